"""What RepRapFirmware keeps of a delta printer, as a robot and a recording: M665, M666 and G31, and its height map."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.files.imported import Imported
from deltacal_gen.files.printers import ANGLES, PULLEY, done, doubt_arms, map_recording, printer_robot
from deltacal_gen.files.toml import read_text
from deltacal_gen.machine.registry import Array

OVERRIDE = "config-override.g"


def import_rrf(config: str | Path, height_map: str | Path, output: str | Path | None = None) -> Imported:
    """Read RepRapFirmware's config.g (M665, M666, G31), with what it has saved, and a height map.

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
    """
    config, height_map = Path(config), Path(height_map)
    said = _gcode(config)
    if "M665" not in said:
        raise InputError(
            "there is no M665, which describes a delta.", "Give the config.g that holds M665 and M666.", file=config
        )
    delta, trims = said["M665"], said.get("M666", {})
    for letter, what in (("R", "delta radius"), ("L", "rod length"), ("H", "homed height")):
        if letter not in delta:
            raise InputError(f"M665 has no {letter} ({what}).", f"Add {letter} to M665.", file=config)
    arms = delta["L"] * 3 if len(delta["L"]) == 1 else delta["L"]
    trim = np.array([trims.get(axis, [0.0])[0] for axis in "XYZ"])
    geometry = {
        "radius": delta["R"][0],
        "arm_length": arms[:3],
        "tower_angle": [a + delta.get(axis, [0.0])[0] for a, axis in zip(ANGLES, "XYZ", strict=True)],
        "endstop": (delta["H"][0] + trim - trim.mean()).tolist(),
    }
    robot = printer_robot(config.stem, geometry, PULLEY, config)
    probe = said.get("G31", {})
    points, z = _height_map(height_map)
    offset = np.array([probe.get(axis, [0.0])[0] for axis in "XY"])
    recording = map_recording(robot, points - offset, z, probe.get("Z", [0.0])[0], height_map)
    warnings = doubt_arms(geometry["arm_length"])
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
    return done(robot, {"recording": recording}, warnings, config, output)


def _number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None


def _gcode(path: Path) -> dict[str, dict[str, list[float]]]:
    """Return the last of each code in a file, with its letters' numbers; ``L`` may hold several, ``a:b:c``.

    M501 runs what M500 has saved, config-override.g, in its place.
    """
    out: dict[str, dict[str, list[float]]] = {}
    for line in read_text(path).split("\n"):
        words = re.sub(r"\(.*?\)", "", line.split(";", 1)[0]).split()
        if not words:
            continue
        if words[0].upper() == "M501" and (saved := path.with_name(OVERRIDE)).is_file() and path.name != OVERRIDE:
            for code, letters in _gcode(saved).items():
                out.setdefault(code, {}).update(letters)
        found: dict[str, list[float]] = {}
        for word in words[1:]:
            if (m := re.fullmatch(r"([A-Za-z])([-+\d.:]+)", word)) is not None:
                try:
                    found[m[1].upper()] = [float(v) for v in m[2].split(":")]
                except ValueError:
                    continue
        out.setdefault(words[0].upper(), {}).update(found)
    return out


def _height_map(path: Path) -> tuple[Array, Array]:
    """Return points (n, 2) and heights (n,) of a map; a bare 0 was not probed [mm]."""
    lines = [line for line in read_text(path).split("\n") if line.strip()]
    if len(lines) < 3 or "height map" not in lines[0]:
        raise InputError("this is no height map of RepRapFirmware.", "Give heightmap.csv.", file=path)
    head = dict(zip((w.strip() for w in lines[1].split(",")), (w.strip() for w in lines[2].split(",")), strict=False))
    try:
        names = ("min0", "spacing0", "min1", "spacing1") if "min0" in head else ("xmin", "xspacing", "ymin", "yspacing")
        x0, dx, y0, dy = (float(head[n]) for n in names)
    except (KeyError, ValueError):
        raise InputError(
            "the second and third line do not say where the map's points lie.",
            "Give the file as it is.",
            file=path,
            line=2,
        ) from None
    points, z = [], []
    for j, line in enumerate(lines[3:]):
        for i, cell in enumerate(line.split(",")):
            text = cell.strip()
            if text in ("", "0"):
                continue
            try:
                z.append(float(text))
            except ValueError:
                raise InputError(
                    f"the cell holds '{text}', a number was expected.", "Correct it.", file=path, line=j + 4
                ) from None
            points.append((x0 + i * dx, y0 + j * dy))
    return np.array(points).reshape(-1, 2), np.array(z)
