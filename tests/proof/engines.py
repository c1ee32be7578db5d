"""What makes the readings of a case: the project's own simulator, or one in which the physics is not the project's.

`exudyn` takes the machine from `multibody` and the instrument from the few lines below, so that between a truth and its
recording not one formula of `deltacal_gen` stands.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from deltacal_gen.files.robot import Robot, robot_to_dict
from deltacal_gen.machine.registry import load_mechanism
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term
from deltacal_gen.units import to_file
from tests.proof import multibody

Array = np.ndarray
POSITIONS = ("position", "pose")

HAS = {  # effects that an engine's machine has; none: all that there are
    "own": (),
    "exudyn": (
        *("backlash", "base_compliance", "distal_compliance", "friction_windup", "inertial_deflection"),
        *("instrument_drift", "instrument_offset", "instrument_scale", "joint_axis_runout", "joint_compliance"),
        *("joint_scale", "latency", "payload_deflection", "proximal_bending", "thermal_growth", "thermal_zero"),
        *("transmission_eccentricity", "zero_drift", "zero_jump"),
    ),
}


def truth_of(robot: Robot, errors: dict[str, float], terms: Sequence[Term]) -> dict[str, Any]:
    """Return a machine's truth as the tables of a TRUTH.toml: `parameters` and `effects`."""
    units = {p.name: p.unit for p in load_mechanism(robot.mechanism).parameters}
    effects = []
    for term in terms:
        table: dict[str, Any] = {"name": term.effect}
        if term.limbs:
            table["limbs"] = list(term.limbs)
        for c, (name, _, factor, _) in enumerate(term.kernels.COEFFICIENTS):
            values = (term.values[:, c] / factor).tolist()
            table[name] = values if term.limbs or term.tools else values[0]
        for value, (name, _, factor, _) in zip(term.constants, term.kernels.CONSTANTS, strict=True):
            table[name] = value / factor
        if term.tools:
            table["tools"] = [list(t) for t in term.tools]
        effects.append(table)
    return {"parameters": {name: to_file(value, units[name]) for name, value in errors.items()}, "effects": effects}


def by_exudyn(
    robot: Robot,
    poses: Recording,
    errors: dict[str, float],
    *,
    terms: Sequence[Term] = (),
    rng: np.random.Generator,
) -> Recording:
    """Return the recording that an instrument would make of Exudyn's machine, as `simulate` does.

    Parameters
    ----------
    robot : Robot
    poses : Recording
        Joints, channels, tool points; kind and frame of the measurement.
    errors : dict
        Source errors [mm, rad].
    terms : sequence of Term
        Effects on the machine and the instrument.
    rng : numpy.random.Generator
        Draws the instrument's frame, where it is unknown: first the rotations, then the origins of all set-ups.

    Raises
    ------
    multibody.NoEquilibriumError
        A pose cannot be reached.
    """
    truth = truth_of(robot, errors, terms)
    delta = multibody.Delta(robot_to_dict(robot), truth["parameters"], truth["effects"])
    tools = np.broadcast_to(robot.tool, (poses.n_rows, 3))
    if poses.tool is not None:
        tools = np.where(np.isfinite(poses.tool), poses.tool, tools)
    time = poses.channels.get("time_s", np.arange(poses.n_rows, dtype=float))
    points, turns = delta.measured(np.rad2deg(poses.joints), tools, poses.channels, time)

    sight = poses.measurement
    scale = 1 + delta.values("instrument_scale", "scale")[0] * 1e-6
    if poses.pairs is not None:
        a, b = poses.pairs.T
        return dataclasses.replace(poses, pair_measured=scale * np.linalg.norm(points[a] - points[b], axis=1))
    if poses.kind == "gauge":
        length = scale * np.linalg.norm(points - np.array(sight.base_point_mm), axis=1)[:, None]
        return dataclasses.replace(poses, measured=length - (length[0] if sight.zero == "incremental" else 0.0))
    if poses.kind not in POSITIONS:
        raise ValueError(f"readings of the kind {poses.kind} are not made here.")
    if foreign := [t.effect for t in terms if t.effect not in HAS["exudyn"]]:
        raise ValueError(f"this machine has no {', '.join(foreign)}.")
    if sight.frame == "unknown":
        setups = int(poses.setup.max()) + 1
        frames = Rotation.from_rotvec(0.3 * rng.standard_normal((setups, 3))).as_matrix()[poses.setup]
        origins = 1000.0 * rng.standard_normal((setups, 3))[poses.setup]
    else:
        frames, origins = np.tile(np.eye(3), (poses.n_rows, 1, 1)), np.zeros((poses.n_rows, 3))
    read = np.einsum("nij,nj->ni", frames, points) + origins
    drift = [delta.values("instrument_drift", f"rate_{axis}")[0] for axis in "xyz"]
    read = scale * (read + np.outer(time / 3600, drift))
    if poses.kind == "pose":
        seen = Rotation.from_matrix(frames @ turns @ np.swapaxes(frames, 1, 2)).as_rotvec()
        read = np.hstack([read, seen])
    return dataclasses.replace(poses, measured=read)


ENGINES: dict[str, Callable[..., Recording]] = {"own": simulate, "exudyn": by_exudyn}
