"""Joints and readings in files of their own, each on its clock."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.files.robot import robot_from_dict, robot_to_toml
from deltacal_gen.machine.registry import Array, load_mechanism
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.units import DEG
from tests.support.prototype import PROTOTYPE, plausible

NOISE = 0.02  # mm
RATE, OFFSET = 40e-6, {"a": 0.7342, "b": -0.2215}
JOINT_STEP, STEP = 0.008, 0.013  # s
ROBOT = robot_from_dict(PROTOTYPE)
DELTA = load_mechanism("delta")
Motion = Callable[[Array], Array]


def swings(seed: int) -> Motion:
    """Return joints [rad] as functions of time: waves that never come together again."""
    rng = np.random.default_rng(seed)
    size, phase = rng.uniform(2, 8, (4, 3)), rng.uniform(0, 6, (4, 3))
    rate = np.array([0.9, 1.7, 2.9, 4.3])[:, None]
    return lambda t: DEG * (15 + (size * np.sin(rate * t[:, None, None] + phase)).sum(axis=1))


def read_at(joints: Array, errors: dict[str, float], rng: np.random.Generator, frame: str = "unknown") -> Array:
    """Return positions (N, 3) that an instrument reads at joints."""
    n = len(joints)
    rows = Recording(
        path="made",
        kind="position",
        measurement=Measurement(kind="position", frame=frame),
        joint_unit="rad",
        joints=joints,
        columns=("x_mm", "y_mm", "z_mm"),
        measured=np.full((n, 3), np.nan),
        pose=np.arange(n).astype(str),
        line=np.arange(n) + 2,
        channels={},
        setup=np.zeros(n, dtype=int),
        setup_names=("1",),
    )
    place = np.array([0.3, -0.2, 1.1]), np.array([1500.0, -800.0, 400.0])
    return simulate(ROBOT, rows, errors, noise_mm=NOISE, rng=rng, frame=place).measured


def table(path: Path, names: list[str], columns: list[Any]) -> None:
    lines = [",".join(v if isinstance(v, str) else f"{v:.9g}" for v in row) for row in zip(*columns, strict=True)]
    path.write_text("\n".join([",".join(names), *lines]) + "\n")


Q, X = [f"q{i}_deg" for i in (1, 2, 3)], ["x_mm", "y_mm", "z_mm"]


def written(folder: Path, motion: Callable[[int], Motion] = swings, clock: str = "own", **kept: Any) -> Path:
    """Write joints and readings of some runs, each on its clock; return the path of the joints."""
    rng, errors = np.random.default_rng(5), plausible(DELTA, seed=3)
    offsets, rate = kept.get("offsets", OFFSET), kept.get("rate", RATE)
    joints: list[list[Any]] = []
    readings: list[list[Any]] = []
    for k, (run, offset) in enumerate(offsets.items()):
        path = motion(k + kept.get("seed", 0))
        t = np.arange(0, kept.get("seconds", 8.0), JOINT_STEP)
        joints += [[run, at, *q] for at, q in zip(t, np.round(path(t) / DEG, 4), strict=True)]
        when = np.arange(0.4, t[-1] - 0.4, STEP)  # on the joints' clock, of which the other one is shifted
        own = (when - offset) / (1 + rate)
        x = read_at(path(when), errors, rng) if kept.get("columns", X) else np.zeros((len(when), 0))
        readings += [[run, at, *row] for at, row in zip(own, x, strict=True)]
    recording = folder / "recording.csv"
    table(recording, ["run", "time_s", *Q], [list(c) for c in zip(*joints, strict=True)])
    table(
        folder / "recording.instrument.csv",
        ["run", "time_s", *kept.get("columns", X)],
        [list(c) for c in zip(*readings, strict=True)],
    )
    text = f'[measurement]\nkind = "position"\nclock = "{clock}"\nsigma_mm = {NOISE}\n{kept.get("sidecar", "")}'
    recording.with_suffix(".toml").write_text(text)
    (folder / "robot.toml").write_text(robot_to_toml(ROBOT))
    return recording
