"""What an import gives: a robot where it is known, its recordings by name, and how they are written into a folder."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.errors import OtherMachine
from deltacal_gen.files.columns import ONE_SETUP
from deltacal_gen.files.robot import Robot, read_robot, robot_to_toml
from deltacal_gen.files.writing import make_folder, write_files, write_recording
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.values import Measurement, Recording

LOOKED_AT = 1_000_000  # bytes of a file, to tell what it is


@dataclass(frozen=True)
class Imported:
    """A robot where it is known, its recordings by name, and what a user should know before using them."""

    robot: Robot | None
    recordings: dict[str, Recording]
    warnings: tuple[str, ...] = field(default=())


def write_import(found: Imported, output: str | Path | None, robot: str | None = None) -> Imported:
    """Write robot.toml and the recordings into a folder, where there is one; return what was imported.

    `robot` is the text of robot.toml, where it says more than the robot does.
    """
    if output is not None:
        folder = Path(output)
        make_folder(folder)
        if found.robot is not None:
            write_files({folder / "robot.toml": robot or robot_to_toml(found.robot)})
        for name, recording in found.recordings.items():
            write_recording(recording, folder / f"{name}.csv")
    return found


def recorded(
    path: Path, kind: str, units: Sequence[str], joints: Array, columns: Sequence[str], measured: Array, **more: Any
) -> Recording:
    """Return rows of joints (N, n) and readings (N, k) as a recording of one set-up, with whatever fields beside.

    `units` are those of the joints, rad or mm.
    """
    rows = len(joints)
    own: dict[str, Any] = {
        "measurement": Measurement(kind=kind, frame="unknown"),
        "pose": np.arange(1, rows + 1).astype(str),
        "line": np.arange(rows) + 2,
        "channels": {},
        "setup": np.zeros(rows, dtype=int),
        "setup_names": ONE_SETUP,
    }
    return Recording(
        path=path,
        kind=kind,
        joint_unit=units[0] if len(set(units)) == 1 else ",".join(units),
        joints=joints,
        columns=tuple(columns),
        measured=measured,
        **own | more,
    )


def robot_with(robot: str | Path | None, count: int, file: Path) -> tuple[Robot | None, tuple[str, ...]]:
    """Return a robot, if one is given, and the units of its joints, rad or mm; raise where not `count` joints are."""
    if robot is None:
        return None, ()
    machine = read_robot(robot)
    mechanism = mechanism_of(machine)
    if mechanism.limbs != count:
        raise OtherMachine(
            f"the file has {count} joints, the robot {mechanism.limbs}.",
            "Give the joints of the robot file, in its order; of a bag, [joints] names in the file of --mapping.",
            file=file,
        )
    return machine, mechanism.joint_units


def beginning(path: Path) -> str:
    """Return the beginning of a file as text, by which it is recognised; "" where it cannot be read."""
    try:
        with path.open("rb") as file:
            return file.read(LOOKED_AT).decode("utf-8", errors="replace")
    except OSError:
        return ""
