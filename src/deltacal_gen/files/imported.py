"""What an import gives: a robot where it is known, its recordings by name, and how they are written into a folder."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from deltacal_gen.errors import InputError
from deltacal_gen.files.robot import Robot, robot_to_toml
from deltacal_gen.files.writing import write_files, write_recording
from deltacal_gen.machine.values import Recording


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
        try:
            folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise InputError(f"the folder cannot be made: {error.strerror}.", "Choose another.", file=folder) from None
        if found.robot is not None:
            write_files({folder / "robot.toml": robot or robot_to_toml(found.robot)})
        for name, recording in found.recordings.items():
            write_recording(recording, folder / f"{name}.csv")
    return found
