"""What all firmwares of delta printers share: the machine that they describe, and the maps of its bed that they keep.

A map holds heights, not joints: the carriages are computed back with the geometry that stands beside it, so it is worth
as much as that geometry was in force.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.errors import PrinterFile, naming
from deltacal_gen.files.imported import recorded
from deltacal_gen.files.robot import Robot, robot_from_dict
from deltacal_gen.files.rows import number_of
from deltacal_gen.machine.registry import SOLVED, Array, load_mechanism
from deltacal_gen.machine.values import Measurement, Recording

ANGLES = (210.0, 330.0, 90.0)  # of the towers, where the file does not say [deg]
TOWERS = ("stepper_a", "stepper_b", "stepper_c")  # sections of a printer.cfg
PULLEY = 40.0  # mm of belt per motor turn: 20 teeth of 2 mm, the usual one, where RepRapFirmware does not say
DECIMALS = 6  # of mm and deg that are kept: a nanometre, a ten-thousandth of a motor's step
NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)"  # in G-code
_LETTER = re.compile(rf"(?<![A-Za-z])([A-Za-z])\s*({NUMBER}(?::{NUMBER})*)(?![\d.])")
SPREAD = 0.02  # by which the arms of one printer may differ


def number(text: str, what: str, remedy: str = "Correct it.", **where: Any) -> float:
    """Return the number that a file gives for what is named; raise where it is none, or not finite."""
    value = number_of(text.strip())
    if value is None or not np.isfinite(value):
        raise PrinterFile(f"{what} is '{text.strip()}': a number was expected.", remedy, **where)
    return value


def letters_of(code: str) -> dict[str, list[float]]:
    """Return the numbers behind each letter of a line of G-code, of which one may have several: ``L a:b:c``."""
    bare = re.sub(r"\(.*?\)", "", code.split(";", 1)[0])
    return {letter.upper(): [float(v) for v in numbers.split(":")] for letter, numbers in _LETTER.findall(bare)}


def check_delta(m665: Mapping[str, Any], remedy: str) -> None:
    """Raise where the letters of an M665 leave a length of the machine open; the remedy names the `{letter}`."""
    for letter, what in (("L", "diagonal rod"), ("R", "delta radius"), ("H", "homed height")):
        if letter not in m665:
            raise PrinterFile(f"M665 {letter} ({what}) is missing.", remedy.format(letter=letter))


def nozzle_at(robot: Robot, q: Array) -> tuple[Array, np.ndarray]:
    """Return where the nozzle is (n, 3) at joints (n, 3) [mm], and where the printer can stand so (n,)."""
    mechanism = load_mechanism(robot.mechanism)
    x, status = mechanism.forward(q, robot.tool, mechanism.rows(robot))
    return x[:, :3], status == SOLVED


def printer_robot(name: str, geometry: Mapping[str, Any], belt: float | None) -> Robot:
    """Return a linear delta of this geometry [mm, deg], `belt` in mm per motor turn; raise where there can be none."""
    read = {key: np.round(value, DECIMALS).tolist() for key, value in geometry.items()}
    tables: dict[str, Any] = {"robot": {"name": name, "mechanism": "linear_delta"}, "geometry": read}
    if belt is not None:
        tables["transmission"] = {"pulley_circumference": belt}
    return robot_from_dict(tables)


def height_recording(path: Path, q: Array, height: Array, instrument: str, **pairs: Any) -> Recording:
    """Return heights (n,) [mm] that were probed at joints (n, 3) [mm]."""
    measured = np.round(np.asarray(height, dtype=float), DECIMALS)[:, None]
    measurement = Measurement(kind="height", frame="robot", instrument=instrument)
    joints = np.round(q, DECIMALS)
    return recorded(path, "height", ("mm",), joints, ("height_mm",), measured, measurement=measurement, **pairs)


def map_recording(robot: Robot, nozzle: Array, z: Array, trigger: float, path: Path) -> Recording:
    """Return the recording of a map: the carriages stood where the geometry puts them for the probed height."""
    mechanism = load_mechanism(robot.mechanism)
    targets = np.column_stack([nozzle, z + trigger])
    q, _, status = mechanism.inverse(targets, robot.tool, mechanism.rows(robot))
    if (status != SOLVED).any():
        x, y = nozzle[np.argmax(status != SOLVED)]
        raise PrinterFile(
            f"the printer cannot stand at x = {x:.1f}, y = {y:.1f} mm of the map with the geometry beside it.",
            "Give the geometry that was in force when the map was probed; check arm length and radius.",
        )
    return height_recording(path, q, np.full(len(q), trigger), "bed probe, a mesh over the bed")


def from_codes(
    config: Path,
    m665: Mapping[str, float],
    arms: Sequence[float],
    endstops: Sequence[float],
    bed: tuple[Array, Array],
    probe: Mapping[str, float],
    trigger: float,
    map_file: Path,
) -> tuple[Robot, Recording]:
    """Return the printer that codes describe, and its bed as it was probed.

    Parameters
    ----------
    m665, probe : mapping
        The numbers of M665 (R, and angles X, Y, Z), and how far the probe is from the nozzle (X, Y), by letters.
    arms, endstops : sequence of float
        [mm]
    bed : (n, 2) array, (n,) array
        Places of the probe and heights [mm].
    trigger : float
        Height of the nozzle where the probe fires [mm].
    """
    angles = [angle + m665.get(axis, 0.0) for angle, axis in zip(ANGLES, "XYZ", strict=True)]
    geometry = {"radius": m665["R"], "arm_length": arms, "tower_angle": angles, "endstop": endstops}
    with naming(config):
        robot = printer_robot(config.stem, geometry, PULLEY)
    points, z = bed
    offset = np.array([probe.get(axis, 0.0) for axis in "XY"])
    with naming(map_file):
        return robot, map_recording(robot, points - offset, z, trigger, map_file)


def doubt_arms(arms: Sequence[float]) -> tuple[str, ...]:
    """Return a warning where the lengths of the arms [mm] differ by more than rods do that are cut to one."""
    spread = float(np.ptp(arms) / np.mean(arms))
    if spread <= SPREAD:
        return ()
    listed = ", ".join(f"{a:.2f}" for a in arms)
    return (
        f"the arms are {listed} mm: rods cut to one length do not differ by {100 * spread:.0f} %. An earlier "
        "calibration went wrong, most often by one distance in the wrong row. Measure the rods with callipers and put "
        "that length into the file.",
    )
