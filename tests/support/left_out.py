"""Small recordings of machines with physics that their geometry leaves out, for the tests of the diagnosis."""

from __future__ import annotations

import copy
import dataclasses
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

import deltacal_gen as dc
from deltacal_gen.files.robot import Robot, robot_from_dict
from deltacal_gen.machine.registry import load_mechanism
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, blank, load_effect
from deltacal_gen.results.diagnosis import Diagnosis
from tests.support.prototype import PROTOTYPE, plausible, scattered, wanted

DELTA = load_mechanism("delta")
SIGMA = 0.01  # mm
POSES = 60
FRAME = np.array([0.3, -0.2, 1.1]), np.array([1500.0, -800.0, 400.0])  # {O} as the instrument sees it: rad, mm


def machine(**tables: Mapping[str, Any] | None) -> Robot:
    """Return the prototype with other tables of its file; None takes one out."""
    data = copy.deepcopy(PROTOTYPE)
    for name, table in tables.items():
        if table is None:
            del data[name]
        else:
            data.setdefault(name, {}).update(table)
    return robot_from_dict(data)


def effect(name: str, limbs: Sequence[int] = (), *values: float, constants: Sequence[float] = ()) -> Term:
    """Return an effect; `values` are its coefficients in the units of the contract, the same for all limbs."""
    term = blank(name, limbs, constants)
    factors = [factor for _, _, factor, _ in load_effect(name).COEFFICIENTS]
    return dataclasses.replace(term, values=np.array(values) * factors * np.ones_like(term.values))


def channels(n: int, *names: str, seed: int = 5) -> dict[str, np.ndarray]:
    """Return channels as a shop records them: approach, temp, time, payload, motion; any other varies smoothly."""
    rng = np.random.default_rng(seed)
    t = np.round(np.cumsum(rng.uniform(15, 40, n)), 2)
    out: dict[str, np.ndarray] = {}
    for name in names:
        if name == "approach":
            out |= {f"approach{i}": rng.choice([-1.0, 1.0], n) for i in (1, 2, 3)}
        elif name == "temp":
            out["temp_C"] = np.round(20 + 6 * (1 - np.exp(-t / t[-1] * 3)) + 0.1 * rng.standard_normal(n), 1)
        elif name == "time":
            out["time_s"] = t
        elif name == "payload":
            out["payload_kg"] = rng.choice([0.0, 1.0, 2.0], n)
        elif name == "motion":
            out |= {f"qd{i}_deg_s": np.round(60 * rng.standard_normal(n), 2) for i in (1, 2, 3)}
            out |= {f"qdd{i}_deg_s2": np.round(800 * rng.standard_normal(n), 1) for i in (1, 2, 3)}
        else:
            out[name] = np.round(45 + 8 * np.sin(t / 600) + rng.normal(0, 3, n))
    return out


def record(
    robot: Robot,
    *terms: Term,
    kind: str = "position",
    n: int = POSES,
    seed: int = 1,
    sigma: float = SIGMA,
    declared: bool = True,
    errors: Mapping[str, float] | None = None,
    of: Mapping[str, np.ndarray] | None = None,
    joints: np.ndarray | None = None,
    **how: Any,
) -> Recording:
    """Return readings of a machine with plausible errors and effects; `of` are its channels.

    The frame of the instrument is unknown, and the same in all recordings. `joints` [deg] take the place of poses
    anywhere in the workspace.
    """
    rng = np.random.default_rng([seed, 7])
    if kind == "distance":
        how["pairs"] = np.sort(np.array([rng.choice(n, 2, replace=False) for _ in range(3 * n)]), axis=1)
    poses = wanted(scattered(robot, n, seed), kind, channels=of, **how)
    if joints is not None:
        poses = dataclasses.replace(poses, joints=np.radians(joints), targets=None)
    done = simulate(
        robot,
        poses,
        dict(plausible(DELTA, 11, size=0.3) if errors is None else errors),
        noise_mm=sigma,
        noise_rad=2e-5 if kind == "pose" else 0.0,
        rng=rng,
        terms=terms,
        frame=FRAME,
    )
    measurement = dataclasses.replace(done.measurement, sigma_mm=sigma if declared else None)
    kept = {name: v for name, v in done.channels.items() if not name.startswith("true_")}
    return dataclasses.replace(done, measurement=measurement, channels=kept)


def named(found: Mapping[str, Any]) -> list[tuple[str, list[int]]]:
    """Return the names and limbs of what a diagnosis found."""
    return [(e["name"], e["limbs"]) for e in found["effects"]]


def diagnosis(robot: Robot, recording: Recording) -> Diagnosis:
    """Return DIAGNOSIS.json of a recording."""
    return dc.diagnose(robot, recording)
