"""What a second encoder on the joints of a Delta reads, of which no drawing is known."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from deltacal_gen.machine.registry import load_mechanism
from deltacal_gen.machine.values import Measurement, Recording, Robot
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term
from deltacal_gen.units import DEG

UNDRAWN = {"robot": {"name": "arms alone", "mechanism": "delta"}, "joints": {"sign": [-1, -1, -1]}}
DELTA = load_mechanism("delta")
RUNS, EACH, NOISE = 6, 60, 0.02  # rows of a run; deg


def motion(robot: Robot, seed: int = 1) -> Recording:
    """Return runs of joints that swing to and fro, not in step, without readings."""
    rng, rows = np.random.default_rng(seed), RUNS * EACH
    time = np.tile(0.05 * np.arange(EACH), RUNS)
    run = np.repeat(np.arange(RUNS), EACH)
    rate, phase = rng.uniform(1.0, 3.0, (RUNS, 3)), rng.uniform(0, 6, (RUNS, 3))
    joints = (20.0 + 35.0 * np.sin(rate[run] * time[:, None] + phase[run])) * DEG
    return Recording(
        path=Path("recording.csv"),
        kind="encoder",
        measurement=Measurement(kind="encoder", sigma_deg=NOISE),
        joint_unit="rad",
        joints=joints,
        columns=("enc1_deg", "enc2_deg", "enc3_deg"),
        measured=np.full((rows, 3), np.nan),
        pose=np.arange(rows).astype(str),
        line=np.arange(rows) + 2,
        channels={"time_s": time, "run": run.astype(float)},
        setup=np.zeros(rows, dtype=int),
        setup_names=("1",),
    )


def read(robot: Robot, terms: tuple[Term, ...] = (), seed: int = 2) -> Recording:
    """Return what encoders read in a motion; noise is given at the platform, 100 mm to the radian."""
    rng = np.random.default_rng(seed)
    return simulate(robot, motion(robot), noise_mm=100 * NOISE * DEG, rng=rng, terms=terms)
