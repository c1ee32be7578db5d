"""The machine of Bai 2015, its poses and what an instrument reads on it: shared by all tests."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.files.robot import Robot, kept_robot
from deltacal_gen.identification.accuracy import check_poses, circle
from deltacal_gen.instrument.kind import Instrument
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import Machine
from deltacal_gen.machine.rotation import cayley_vector, from_vector, to_vector
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.results.parts import Source
from deltacal_gen.results.result import Read, Regularisation, Result
from deltacal_gen.units import to_internal

PROTOTYPE = {  # Bai 2015, Table 1; masses of an ordinary machine of this size
    "robot": {"name": "prototype", "mechanism": "delta"},
    "geometry": {
        "base_radius": 200.0,
        "platform_radius": 51.0,
        "proximal_length": 375.0,
        "distal_length": 950.0,
        "joint_spacing": 100.0,
    },
    "workspace": {"top": 728.0, "radius": 500.0, "height": 250.0},
    "masses": {"proximal": 1.2, "proximal_com": 0.4, "distal_rod": 0.15, "platform": 0.8},
}

COLUMNS = {
    "position": ("x_mm", "y_mm", "z_mm"),
    "pose": ("x_mm", "y_mm", "z_mm", "rx_deg", "ry_deg", "rz_deg"),
    "distance": ("distance_mm",),
    "gauge": ("gauge_mm",),
}
ORDINARY = {"theta": 0.3, "mm": 0.1, "rad": 0.03}  # [deg, mm, deg] standard deviations of a plausible machine's errors


def plausible(mechanism: Machine, seed: int, names: Sequence[str] | None = None, size: float = 1.0) -> dict[str, float]:
    """Return source errors of a plausible machine [mm, rad]."""
    rng = np.random.default_rng(seed)
    errors = {}
    for p in mechanism.parameters:
        sd = ORDINARY["theta"] if p.error == "theta" else ORDINARY[p.unit]
        value = float(size * sd * to_internal(p.unit) * rng.standard_normal())
        if names is None or p.name in names:
            errors[p.name] = value
    return errors


def rings(robot: Robot, n: int) -> np.ndarray:
    """Return home and n poses on the rim of the top and of the bottom layer: Bai's measuring poses (2 n + 1, 3)."""
    assert robot.workspace is not None
    top, bottom = (circle(robot.workspace, depth, 1.0, n) for depth in (0.0, 1.0))
    return np.vstack([check_poses(robot.workspace)[:1], top, bottom])


def scattered(robot: Robot, n: int, seed: int) -> np.ndarray:
    """Return n points anywhere in the workspace (n, 3)."""
    rng = np.random.default_rng(seed)
    space = robot.workspace
    assert space is not None
    assert space.radius is not None
    angle, radius = 2 * np.pi * rng.random(n), space.radius * np.sqrt(rng.random(n))
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), -space.top - space.height * rng.random(n)])


def wanted(
    targets: np.ndarray,
    kind: str = "position",
    *,
    frame: str = "unknown",
    tool: np.ndarray | None = None,
    setup: Sequence[str] | None = None,
    pose: Sequence[str] | None = None,
    pairs: np.ndarray | None = None,
    channels: Mapping[str, np.ndarray] | None = None,
    **measurement: Any,
) -> Recording:
    """Return a recording without readings at targets (n, 3) in {O}: what `simulate` fills in. Line 1 is the header."""
    n = len(targets)
    names, index = np.unique(list(setup or ["1"] * n), return_inverse=True)
    return Recording(
        path=Path("recording.csv"),
        kind=kind,
        measurement=Measurement(kind=kind, frame=frame, **measurement),
        joint_unit="rad",
        joints=np.full((n, 3), np.nan),
        columns=COLUMNS[kind],
        measured=np.zeros((n, 0)),
        pose=np.array(list(pose or [str(j + 1) for j in range(n)])),
        line=np.arange(n) + 2,
        channels=dict(channels or {}),
        setup=np.ravel(index),
        setup_names=tuple(names.tolist()),
        tool=None if tool is None else np.broadcast_to(tool, (n, 3)).copy(),
        targets=targets,
        pairs=pairs,
        pair_line=None if pairs is None else np.arange(len(pairs)) + 2,
    )


def displaced(x: np.ndarray, by: np.ndarray) -> np.ndarray:
    """Return poses (N, 12) shifted and turned in {O} by (N, 6) or (6,) [mm, rad]."""
    by = np.tile(by, (len(x), 1)) if np.ndim(by) == 1 else by
    turned = from_vector(by[:, 3:]) @ x[:, 3:].reshape(-1, 3, 3)
    return np.hstack([x[:, :3] + by[:, :3], turned.reshape(-1, 9)])


def displacement(x: np.ndarray, moved: np.ndarray) -> np.ndarray:
    """Return the shift and the turn in {O} (N, 6) that lead from poses to poses (N, 12)."""
    turn = moved[:, 3:].reshape(-1, 3, 3) @ np.swapaxes(x[:, 3:].reshape(-1, 3, 3), 1, 2)
    return np.hstack([moved[:, :3] - x[:, :3], to_vector(turn)])


def solved_for(x: np.ndarray) -> np.ndarray:
    """Return the coordinates (N, 6) that a machine in space is solved for: position and Cayley vector."""
    return np.hstack([x[:, :3], cayley_vector(x[:, 3:].reshape(-1, 3, 3))])


def calibrated(robot: Robot) -> Result:
    """Return a result that says nothing but what the machine is."""
    return Result(
        model=robot.mechanism,
        parameters=(),
        rank=0,
        rank_tolerance=0.0,
        singular_values=np.zeros(0),
        condition=None,
        scaling="",
        unidentifiable=(),
        next_measurements=(),
        regularisation=Regularisation(rule=""),
        readings=Read(kind="position", scalars=0, poses=0),
        before_rms_mm=0.0,
        train_rms_mm=0.0,
        heldout_rms_mm=None,
        sigma_mm=0.0,
        sigma_source=Source.DECLARED,
        chi2_per_dof=None,
        gross_errors=None,
        accuracy=None,
        workspace=None,
        instrument=Instrument(kind_of("position"), np.zeros((0, 12)), ()).kept((), "absolute"),
        robot=kept_robot(robot),
    )
