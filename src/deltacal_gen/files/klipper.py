"""A printer.cfg of Klipper: its sections as Klipper reads them, and what is measured in them.

What stands in the file, or in files that it includes, holds; the saved block (``#*#``) where these say nothing. Klipper
comments out what it saves, so that the two differ where the file was edited later.
"""

from __future__ import annotations

import configparser
import glob
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.files.rows import number_of
from deltacal_gen.files.toml import read_text
from deltacal_gen.machine.registry import Array

_OTHERS = {  # machines of Klipper that are near relations, and what could be done with them
    "rotary_delta": ": arms that turn; write a robot file of mechanism 'delta' by hand",
    "winch": ": cables, whose lengths no mechanism here has",
    "deltesian": ": two towers and a sliding bed, which no mechanism here has",
}
TOWERS = ("stepper_a", "stepper_b", "stepper_c")
SAVED = "#*#"  # begins a line of the saved block
HEADER = re.compile(r"#\*# <-+ SAVE_CONFIG -+>")
INCLUDE = re.compile(r"\[include\s+(.+?)\s*\]")
FULL_STEPS = 200.0  # of a motor's turn
ROUNDED = 1e-3  # of the bed's radius: a map's limits are written with a digit or two
LONGEST_NAME = 100  # letters of a mesh's name, which becomes a file's


def _sections(lines: list[str], path: Path) -> dict[str, dict[str, str]]:
    """Return the keys and values of each section; comments end lines, as they do in Klipper."""
    bare = [re.sub(r"\s*[#;].*$", "", line) for line in lines]
    start = next((k for k, line in enumerate(bare) if line.startswith("[")), len(bare))
    parser = configparser.RawConfigParser(strict=False, delimiters=("=", ":"), allow_no_value=True)
    try:
        parser.read_string("\n".join(bare[start:]))
    except configparser.Error as error:
        raise InputError(
            f"this is no configuration of Klipper: {str(error).splitlines()[0]}.", "Correct it.", file=path
        ) from None
    return {
        name.strip(): {key: value for key, value in parser.items(name) if value is not None}
        for name in parser.sections()
    }


@dataclass(frozen=True)
class Height:
    """A height [mm] that was probed or measured, and the stable position there [motor steps]."""

    z: float
    position: tuple[float, ...]


@dataclass(frozen=True)
class Distance:
    """A distance [mm] that was measured on a print, and the stable positions of its ends [motor steps]."""

    length: float
    first: tuple[float, ...]
    second: tuple[float, ...]


class KlipperFile:
    """The sections of a printer.cfg, with what it includes; the saved block holds where these say nothing.

    Attributes
    ----------
    absent : list of str
        Files that are included and are not there: macros and much else, but perhaps also the probe or the motors.
    below : bool
        Whether anything follows the saved block, which Klipper then takes for a comment.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self.absent: list[str] = []
        lines = read_text(path).split("\n")
        saved = [re.sub(r"^#\*# ?", "", line) for line in lines if line.startswith(SAVED)]
        self.sections = _sections(saved, path)
        for name, given in _sections(list(self._body(path.resolve(), ())), path).items():
            self.sections[name] = self.sections.get(name, {}) | given
        header = next((k for k, line in enumerate(lines) if HEADER.match(line)), len(lines))
        self.below = any(line.strip() and not line.startswith(SAVED) for line in lines[header:])
        if "printer" not in self.sections:
            raise InputError("there is no [printer] in the file.", self.whole, file=path)
        if (kinematics := self.sections["printer"].get("kinematics", "delta")) != "delta":
            other = _OTHERS.get(kinematics, "")
            raise InputError(
                f"the file describes no linear delta ([printer] kinematics: {kinematics}{other}).",
                "Give the printer.cfg of a printer whose carriages slide on three towers.",
                file=path,
            )

    def _body(self, path: Path, above: tuple[Path, ...]) -> Iterator[str]:
        """Yield the lines of a file, with those of the files that it includes in their places."""
        for line in read_text(path).split("\n"):
            if (include := INCLUDE.match(line)) is None:
                yield line
                continue
            found = sorted(glob.glob(include[1], root_dir=path.parent))
            if not found and not glob.has_magic(include[1]):
                self.absent.append(include[1])
            for name in found:
                if (inner := (path.parent / name).resolve()) not in (*above, path):
                    yield from self._body(inner, (*above, path))

    def doubts(self) -> tuple[str, ...]:
        """Return warnings about what Klipper does not read, and what was not there to read."""
        warnings = []
        if self.below:
            warnings.append(
                "lines follow the SAVE_CONFIG block: Klipper then takes all of the block for comments, heights and "
                "meshes with it. Move these lines above it.",
            )
        unplaced = not {"x_offset", "y_offset"} & self.sections.get(self.probe, {}).keys()
        if self.absent and unplaced and any(name.startswith("bed_mesh ") for name in self.sections):
            warnings.append(
                f"the file includes {', '.join(self.absent)}, which are not beside it, and does not say how far the "
                "probe stands from the nozzle (x_offset, y_offset): as though it were the nozzle. Put them beside it, "
                "if they do.",
            )
        return tuple(warnings)

    @property
    def whole(self) -> str:
        """What to give where something is missing."""
        beside = f", and beside it what it includes ({', '.join(self.absent)})" if self.absent else ""
        return f"Give the whole printer.cfg{beside}."

    @property
    def probe(self) -> str:
        """Return the section of the probe, which has several names ([probe], [bltouch], [smart_effector], ...)."""
        offsets = {f"{axis}_offset" for axis in "xyz"}
        return next(
            (name for name in ("probe", *self.sections) if offsets & self.sections.get(name, {}).keys()), "probe"
        )

    def optional(self, section: str, key: str) -> float | None:
        """Return a number; None where the file does not say."""
        text = self.sections.get(section, {}).get(key)
        if text is None:
            return None
        value = number_of(text)
        if value is None or not np.isfinite(value):
            raise InputError(f"{key} in [{section}] is '{text}': a number was expected.", "Correct it.", file=self.path)
        return value

    def number(self, section: str, key: str) -> float:
        """Return a number; raise where the file does not say."""
        value = self.optional(section, key)
        if value is None:
            raise InputError(f"{key} in [{section}] is missing.", self.whole, file=self.path)
        return value

    def towers(self, key: str, default: Sequence[float] | None) -> list[float]:
        """Return a value per tower; one that is not given is the default, or that of tower a, as in Klipper."""
        found = [self.optional(tower, key) for tower in TOWERS]
        if default is None:
            first = self.number("stepper_a", key)
            return [first if v is None else v for v in found]
        return [d if v is None else v for v, d in zip(found, default, strict=True)]

    def step(self, tower: str) -> float | None:
        """Return mm of belt per step of a tower's motor; None where the file does not say."""
        if (old := self.optional(tower, "step_distance")) is not None:
            return old
        given = {k: self.optional(tower, k) for k in ("rotation_distance", "microsteps", "full_steps_per_rotation")}
        given = {k: v if v is not None else self.optional("stepper_a", k) for k, v in given.items()}
        belt, micro = given["rotation_distance"], given["microsteps"]
        if belt is None or micro is None:
            return None
        gears = self.sections.get(tower, {}).get("gear_ratio", "")
        driven, driving = np.array(
            [(1.0, 1.0), *re.findall(r"(\d+\.?\d*)\s*:\s*(\d+\.?\d*)", gears)], dtype=float
        ).prod(0)
        full = given["full_steps_per_rotation"]
        if not min(belt, micro, driven, driving, FULL_STEPS if full is None else full) > 0:
            raise InputError(
                f"rotation_distance, microsteps, full_steps_per_rotation or gear_ratio in [{tower}] is 0 or less.",
                "Correct it.",
                file=self.path,
            )
        return float(belt * driving / ((full or FULL_STEPS) * micro * driven))

    def _position(self, key: str) -> tuple[float, ...]:
        text = self.sections["delta_calibrate"].get(key, "")
        found = tuple(v for cell in text.split(",") if (v := number_of(cell)) is not None and np.isfinite(v))
        if len(found) != 3 or text.count(",") != 2:
            raise InputError(
                f"{key} in [delta_calibrate] is '{text}': three positions, separated by commas, were expected.",
                "Run DELTA_CALIBRATE and SAVE_CONFIG again.",
                file=self.path,
            )
        return found

    def _numbered(self, pattern: str) -> list[str]:
        keys = self.sections.get("delta_calibrate", {})
        return sorted((k for k in keys if re.fullmatch(pattern, k)), key=lambda k: int(re.sub(r"\D", "", k)))

    def heights(self) -> list[Height]:
        """Return probed and manual heights."""
        return [
            Height(self.number("delta_calibrate", key), self._position(f"{key}_pos"))
            for pattern in (r"height\d+", r"manual_height\d+")
            for key in self._numbered(pattern)
        ]

    def distances(self) -> list[Distance]:
        """Return the distances that were measured on a print."""
        return [
            Distance(self.number("delta_calibrate", key), self._position(f"{key}_pos1"), self._position(f"{key}_pos2"))
            for key in self._numbered(r"distance\d+")
        ]

    def _mesh(self, section: str) -> Array:
        """Return the heights (rows, columns) of a bed mesh [mm]."""
        lines = self.sections[section]["points"].strip().split("\n")
        cells = [[c.strip() for c in line.split(",") if c.strip()] for line in lines]
        bad = next((c for row in cells for c in row if (v := number_of(c)) is None or not np.isfinite(v)), None)
        if bad is not None:
            problem = f"a point of [{section}] is '{bad}': a number was expected."
        elif len({len(row) for row in cells}) > 1 or not cells[0]:
            problem = f"the rows of points in [{section}] are not equally long."
        else:
            return np.array(cells, dtype=float)
        raise InputError(problem, "Run BED_MESH_CALIBRATE and SAVE_CONFIG again.", file=self.path)

    def meshes(self) -> list[tuple[str, Array, Array]]:
        """Return name, points (n, 2) and heights (n,) of every bed mesh [mm]."""
        out = []
        for section in self.sections:
            if not section.startswith("bed_mesh ") or "points" not in self.sections[section]:
                continue
            z = self._mesh(section)
            low, high = (np.array([self.number(section, f"{m}_{a}") for a in "xy"]) for m in ("min", "max"))
            x, y = (np.linspace(low[k], high[k], count) for k, count in enumerate((z.shape[1], z.shape[0])))
            grid = np.stack(np.meshgrid(x, y), axis=2)
            # the bed is round: cells beyond the circle repeat the last probed one of their row
            inside = np.linalg.norm(grid - (low + high) / 2, axis=2) <= np.min(high - low) / 2 * (1 + ROUNDED)
            name = re.sub(r"\W+", "_", section.split(" ", 1)[1].strip())
            if len(name) > LONGEST_NAME:
                raise InputError(
                    f"the name of the mesh '{name[:20]}...' has {len(name)} letters, and a file is named after it.",
                    f"Give it at most {LONGEST_NAME}.",
                    file=self.path,
                )
            out.append((name, grid[inside], z[inside]))
        return out
