"""What Marlin tells of a delta printer, as a robot and a recording: a log of M503, G33 and G29.

A format only, written from the firmware's documentation. The machine is what M665 and M666, or a report of G33, said
last. Heights are the lines ``Bed X: .. Y: .. Z: ..`` of G29 (verbose), or the topography of the unified bed levelling
with its corners; a bilinear grid alone does not say where its points lie.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from deltacal_gen.errors import PrinterFile, naming
from deltacal_gen.files.imported import Imported, write_import
from deltacal_gen.files.printers import NUMBER, check_delta, doubt_arms, from_codes, letters_of
from deltacal_gen.files.toml import read_text
from deltacal_gen.machine.registry import Array

_BED = re.compile(rf"Bed X:\s*({NUMBER})\s+Y:\s*({NUMBER})\s+Z:\s*({NUMBER})")
_CORNER = re.compile(rf"\(\s*({NUMBER})\s*,\s*({NUMBER})\s*\)")
_G33 = {  # what a report of G33 calls what M665 and M666 set: code and letter
    "Height": ("M665", "H"),
    "Radius": ("M665", "R"),
    **{f"E{axis}": ("M666", axis.upper()) for axis in "xyz"},
    **{f"T{axis}": ("M665", axis.upper()) for axis in "xyz"},
}
_REPORTED = re.compile(rf"\b({'|'.join(_G33)}):\s*({NUMBER})")


def import_marlin(path: str | Path, output: str | Path | None = None) -> Imported:
    """Import a log of Marlin: M503, and G29 with V4 or, of the unified bed levelling, G29 T.

    Parameters
    ----------
    path : path
        Text as a terminal shows it; other lines do not matter.
    output : path, optional
        Folder for robot.toml and recording.csv.

    Raises
    ------
    InputError
        There is no M665, or no heights whose places are known.

    Examples
    --------
    deltacal import marlin terminal.log -o printer
    """
    path = Path(path)
    lines = read_text(path).split("\n")
    said = _settings(lines)
    delta, trims, probe = said["M665"], said["M666"], said["M851"]
    with naming(path):
        check_delta(
            delta,
            "Send M503 and give all that it answers; where it does not say it, add a line, M665 {letter} and the "
            "number that the firmware was built with.",
        )
        trimmed = {"A", "C"} <= delta.keys()  # B alone: a radius to probe
        arms = [delta["L"] + (delta.get(axis, 0.0) if trimmed else 0.0) for axis in "ABC"]
        endstops = [delta["H"] - trims.get(axis, 0.0) for axis in "XYZ"]  # carriages go down from the switch by it
        robot, recording = from_codes(path, delta, arms, endstops, _heights(lines), probe, -probe.get("Z", 0.0), path)
    warnings = doubt_arms(arms)
    if not probe:
        warnings += ("the log says nothing of the probe (M851): its offset is taken as 0.",)
    return write_import(Imported(robot, {"recording": recording}, warnings), output)


def _settings(lines: list[str]) -> dict[str, dict[str, float]]:
    """Return the numbers of M665, M666 and M851 by their letters, as they were said last."""
    said: dict[str, dict[str, float]] = {"M665": {}, "M666": {}, "M851": {}}
    for line in lines:
        if (code := re.search(r"\b(M665|M666|M851)\b(.*)", line)) is not None:
            said[code[1]].update((letter, numbers[0]) for letter, numbers in letters_of(code[2]).items())
        for name, number in _REPORTED.findall(line):
            key, letter = _G33[name]
            said[key][letter] = float(number)
    return said


def _heights(lines: list[str]) -> tuple[Array, Array]:
    """Return probed points (n, 2) and heights (n,) [mm]."""
    found = [tuple(map(float, m.groups())) for line in lines if (m := _BED.search(line)) is not None]
    if not found:
        found = list(_topography(lines))
    if not found:
        grid = any("Bilinear Leveling Grid" in line for line in lines)
        calibrated = any("G33 Auto Calibrate" in line for line in lines)
        raise PrinterFile(
            "the log does not say where the points of the grid lie."
            if grid
            else "the heights of G33 are averages, at a radius that the log does not say."
            if calibrated
            else "there are no probed heights in the log.",
            "Probe with G29 V4 (or G29 T of the unified bed levelling) and give its answer too.",
        )
    table = np.array(found)
    return table[:, :2], table[:, 2]


def _topography(lines: list[str]) -> Iterator[tuple[float, float, float]]:
    """Yield x, y and height of each probed point of a report of the unified bed levelling."""
    start = next((k for k, line in enumerate(lines) if "Bed Topography Report" in line), None)
    if start is None:
        return
    corners = np.array([c for line in lines[start:] for c in _CORNER.findall(line)][:4], dtype=float)
    rows: dict[int, list[str]] = {}
    for line in lines[start + 1 :]:
        bare = re.sub(r"[\[\]|]", " ", _CORNER.sub(" ", line)).split()
        numbers = len(bare) > 2 and bare[0].isdigit() and not all(c.isdigit() for c in bare)
        if numbers:
            rows.setdefault(int(bare[0]), bare[1:])
    widths = {len(cells) for cells in rows.values()}
    if len(corners) < 4 or len(rows) < 2 or len(widths) > 1 or sorted(rows) != list(range(len(rows))):
        raise PrinterFile(
            "the topography is not complete: its corners and rows of equal length were expected.",
            "Give the whole answer of G29 T.",
            line=start + 1,
        )
    (x0, y0), (x1, y1) = corners.min(axis=0), corners.max(axis=0)
    count = widths.pop()
    for j, cells in rows.items():
        for i, cell in enumerate(cells):
            if re.fullmatch(NUMBER, cell):  # a dot was not probed
                yield x0 + i * (x1 - x0) / (count - 1), y0 + j * (y1 - y0) / (len(rows) - 1), float(cell)
