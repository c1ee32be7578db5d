"""Rows of a plan: joints in the digits and units of files, and a recording in which nothing has been read yet."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.units import file_unit, to_file, to_internal

READABLE = {"mm": 3, "rad": 4}  # digits of targets and joints that are written, in the units of files


def readable(values: Array, units: Sequence[str]) -> Array:
    """Return columns (N, k) [`units`] as a person types them: to 1 um, 0.0001 deg."""
    columns = zip(values.T, units, strict=True)
    return np.column_stack([np.round(v / to_internal(u), READABLE[u]) * to_internal(u) for v, u in columns])


def joints_in_files(robot: Robot, joints: Array) -> list[dict[str, Any]]:
    """Return joints (N, n_q) row by row as answers have them, under the key of their unit."""
    units = mechanism_of(robot).joint_units
    key = f"joints_{file_unit(units[0])}" if len(set(units)) == 1 else "joints"
    return [{key: tuple(map(to_file, row, units))} for row in joints.tolist()]


def blank_recording(
    robot: Robot,
    kind: str,
    joints: Array,
    columns: Sequence[str],
    measurement: Measurement,
    path: str | Path,
    **further: Any,
) -> Recording:
    """Return joints (N, n_q), as the controller counts, as a recording in which nothing has been read yet.

    Parameters
    ----------
    columns : sequence of str
        To be measured.
    further
        Of `Recording`: channels, reference points, targets.
    """
    count = len(joints)
    return Recording(
        path=Path(path),
        kind=kind,
        measurement=measurement,
        joint_unit=mechanism_of(robot).joint_unit,
        joints=joints,
        columns=tuple(columns),
        measured=np.full((count, len(columns)), np.nan),
        pose=np.arange(1, count + 1).astype(str),
        line=np.arange(2, count + 2),
        setup=np.zeros(count, dtype=int),
        setup_names=("1",),
        **{"channels": {}, **further},
    )
