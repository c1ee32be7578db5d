"""What RepRapFirmware keeps of a delta printer, as a robot and a recording: M665, M666 and G31, and its height map."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from deltacal_gen.errors import PrinterFile, naming
from deltacal_gen.files.imported import Imported, beginning, write_import
from deltacal_gen.files.printers import check_delta, doubt_arms, from_codes, letters_of, number
from deltacal_gen.files.toml import read_text
from deltacal_gen.machine.registry import Array

CONFIG, OVERRIDE = "config.g", "config-override.g"
MAP = "RepRapFirmware height map"  # begins the file of one


def recognise(folder: Path) -> Iterator[tuple[Path, tuple[Path, ...]]]:
    """Yield the height maps in a folder, each with the configuration beside it; M500 writes the one that then holds."""
    config = next((folder / c for c in (OVERRIDE, CONFIG) if "M665" in beginning(folder / c)), folder / CONFIG)
    yield from ((path, (config, path)) for path in sorted(folder.glob("*.csv")) if beginning(path).startswith(MAP))


def import_rrf(config: str | Path, height_map: str | Path, output: str | Path | None = None) -> Imported:
    """Import RepRapFirmware's config.g (M665, M666, G31) and height map.

    Parameters
    ----------
    config : path
        config.g; where it says M501, config-override.g beside it holds, as M500 has written it.
    height_map : path
        heightmap.csv.
    output : path, optional
        Folder for robot.toml and recording.csv.

    Raises
    ------
    InputError
        No M665, or a map that cannot be read; the message names the line.

    Examples
    --------
    deltacal import rrf config.g heightmap.csv -o printer
    """
    config, height_map = Path(config), Path(height_map)
    codes = _gcode(config)
    said = {code: {letter: numbers[0] for letter, numbers in letters.items()} for code, letters in codes.items()}
    with naming(config):
        if "M665" not in said:
            raise PrinterFile(
                "there is no M665, which describes a delta.", "Give the config.g that holds M665 and M666."
            )
        delta, trims, probe = said["M665"], said.get("M666", {}), said.get("G31", {})
        check_delta(delta, "Add {letter} to M665.")
    rods = codes["M665"]["L"]
    arms = rods * 3 if len(rods) == 1 else rods[:3]
    trim = np.array([trims.get(axis, 0.0) for axis in "XYZ"])
    endstops = delta["H"] + trim - trim.mean()
    bed = _height_map(height_map)
    robot, recording = from_codes(config, delta, arms, endstops, bed, probe, probe.get("Z", 0.0), height_map)
    warnings = doubt_arms(arms)
    if "M501" in said and not config.with_name(OVERRIDE).is_file():
        warnings += (
            f"{config.name} loads what M500 has saved (M501), and {OVERRIDE} is not beside it: what it says itself is "
            "taken. Put it there, if there is one.",
        )
    if "G31" not in said:
        warnings += (
            f"{config.name} says nothing of the probe (G31): its trigger height is taken as 0, which is right for a "
            "nozzle that touches the bed.",
        )
    return write_import(Imported(robot, {"recording": recording}, warnings), output)


def _gcode(path: Path) -> dict[str, dict[str, list[float]]]:
    """Return the last of each code in a file, with its letters' numbers; ``L`` may hold several, ``a:b:c``.

    M501 runs what M500 has saved, config-override.g, in its place.
    """
    out: dict[str, dict[str, list[float]]] = {}
    for line in read_text(path).split("\n"):
        if (found := re.match(r"\s*([A-Z]\d+)(.*)", line.upper())) is None:
            continue
        if found[1] == "M501" and (saved := path.with_name(OVERRIDE)).is_file() and path.name != OVERRIDE:
            for code, letters in _gcode(saved).items():
                out.setdefault(code, {}).update(letters)
        out.setdefault(found[1], {}).update(letters_of(found[2]))
    return out


def _height_map(path: Path) -> tuple[Array, Array]:
    """Return points (n, 2) and heights (n,) of a map; a bare 0 was not probed [mm]."""
    lines = [line for line in read_text(path).split("\n") if line.strip()]
    with naming(path):
        if len(lines) < 3 or "height map" not in lines[0]:
            raise PrinterFile("this is no height map of RepRapFirmware.", "Give heightmap.csv.")
        said = dict(zip(*([word.strip() for word in line.split(",")] for line in lines[1:3]), strict=False))
        keys = ("min0", "spacing0", "min1", "spacing1") if "min0" in said else ("xmin", "xspacing", "ymin", "yspacing")
        x, dx, y, dy = (
            number(said.get(key, ""), f"{key} of the map", "Give the file as it is.", line=3) for key in keys
        )
        points, z = list[tuple[float, float]](), list[float]()
        for j, line in enumerate(lines[3:]):
            for i, cell in enumerate(map(str.strip, line.split(","))):
                if cell not in ("", "0"):
                    points.append((x + i * dx, y + j * dy))
                    z.append(number(cell, "the cell", line=j + 4))
    return np.array(points).reshape(-1, 2), np.array(z)
