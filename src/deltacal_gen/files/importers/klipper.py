"""What Klipper keeps of a delta printer, as a robot and recordings: printer.cfg with its saved block and bed meshes.

A format only, written from its documentation. What stands in the file, or in files that it includes, holds; the saved
block (``#*#``) where these say nothing. Klipper comments out what it saves, so that the two differ where the file was
edited later. ``[delta_calibrate]`` holds heights and distances in stable positions, motor steps since the endstop,
which hold whatever the parameters are.
"""

from __future__ import annotations

import configparser
import glob
import itertools
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.errors import PrinterFile, naming
from deltacal_gen.files import printers
from deltacal_gen.files.imported import Imported, beginning, write_import
from deltacal_gen.files.robot import Robot
from deltacal_gen.files.toml import read_text
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording

PITCH = 2.0  # mm of belt per tooth
USUAL_TEETH = range(15, 30)  # of a pulley; twice as many are half the microsteps
ABSURD = 0.05  # of a distance: no geometry of the printer's parts is so far off
DOUBTFUL = 1.0  # mm: a printed distance so far off the printer's own geometry is looked at again
WRONG_STEP = 5.0  # mm: no bed is so far off by what a calibration corrects
EDITED = 1.0  # mm: heights that all are so far off alike were probed with other endstops
FELT = 0.02  # mm: a first layer shows a nozzle that is so much too low
CLEARLY = 2.0  # by which the step that fits must fit better than the next, and what is alike stand above what is not
_OTHERS = {  # machines of Klipper that are near relations, and what could be done with them
    "rotary_delta": ": arms that turn; write a robot file of mechanism 'delta' by hand",
    "winch": ": cables, whose lengths no mechanism here has",
    "deltesian": ": two towers and a sliding bed, which no mechanism here has",
}
SAVED = "#*#"  # begins a line of the saved block
HEADER = re.compile(r"#\*# <-+ SAVE_CONFIG -+>")
INCLUDE = re.compile(r"\[include\s+(.+?)\s*\]")
FIRST = printers.TOWERS[0]  # whose numbers hold for the other towers, too
FULL_STEPS = 200.0  # of a motor's turn
ROUNDED = 1e-3  # of the bed's radius: a map's limits are written with a digit or two
LONGEST_NAME = 100  # letters of a mesh's name, which becomes a file's


def recognise(folder: Path) -> Iterator[tuple[Path, tuple[Path, ...]]]:
    """Yield what Klipper keeps of delta printers in a folder."""
    for path in sorted(p for p in folder.iterdir() if p.suffix in (".cfg", ".txt")):
        text = beginning(path)
        if SAVED in text and "delta_radius" in text:
            yield path, (path,)


def import_klipper(path: str | Path, output: str | Path | None = None) -> Imported:
    """Import Klipper's printer.cfg with its saved block and bed meshes.

    Parameters
    ----------
    path : path
        The configuration; its own values, and those of files that it includes beside it, hold before those of the saved
        block (``#*#``), as in Klipper.
    output : path, optional
        Folder for robot.toml, recording.csv (heights and distances) and one mesh_NAME.csv per bed mesh.

    Raises
    ------
    InputError
        No delta, or a value that is missing or cannot be; the message names the section and what to do.

    Examples
    --------
    deltacal import klipper printer.cfg -o printer
    """
    path = Path(path)
    with naming(path):
        file = KlipperFile(path)
        geometry: dict[str, Any] = {
            "radius": file.number("printer", "delta_radius"),
            "arm_length": file.towers("arm_length"),
            "tower_angle": file.towers("angle", printers.ANGLES),
            "endstop": file.towers("position_endstop"),
        }
        belt = file.optional(FIRST, "rotation_distance")
        robot = printers.printer_robot(path.stem, geometry, belt)
        warnings = (*file.doubts(), *printers.doubt_arms(geometry["arm_length"]))
        recordings: dict[str, Recording] = {}
        probed, ends, lengths = Probed(robot, *file.heights()), *file.distances()
        if len(probed.z) or len(lengths):
            step = np.array([file.step(tower) for tower in printers.TOWERS], dtype=float)
            if np.isfinite(step).all():
                probed.check_step(step)
            else:
                step[:], belt = probed.usual_step()
                robot = printers.printer_robot(path.stem, geometry, belt)
                warnings += (
                    f"the file does not say how long a motor step is; {step[0]:g} mm puts the probed points at their "
                    f"heights, as of a pulley of {belt:g} mm a turn, which is taken. Correct pulley_circumference in "
                    "robot.toml if it is another.",
                )
            warnings += probed.doubts(step) + _doubts_of_distances(robot, ends * step, lengths)
            recordings["recording"] = _session(path, probed, ends, lengths, step)
        for name, points, z in file.meshes():
            offset = np.array([file.number(file.probe, f"{axis}_offset", 0.0) for axis in "xy"])
            trigger = file.number(file.probe, "z_offset", 0.0)
            recordings[f"mesh_{name}"] = printers.map_recording(robot, points - offset, z, trigger, path)
        if not recordings:
            raise PrinterFile(
                "there are neither heights, distances nor a bed mesh in the file.",
                "Run DELTA_CALIBRATE or BED_MESH_CALIBRATE and SAVE_CONFIG, and give the file again.",
            )
    return write_import(Imported(robot, recordings, warnings), output)


def _session(path: Path, probed: Probed, ends: Array, lengths: Array, step: Array) -> Recording:
    """Return heights, and distances between pairs of rows below them."""
    measured = np.concatenate([probed.z, np.full(2 * len(lengths), np.nan)])
    pairs: dict[str, Any] = {}
    if len(lengths):
        pairs = {
            "pairs": len(probed.z) + np.arange(2 * len(lengths)).reshape(-1, 2),
            "pair_measured": lengths,
            "pair_line": np.arange(2, len(lengths) + 2),
        }
    instrument = f"bed probe{' (heights); caliper on a printed object (distances)' if pairs else ''}"
    return printers.height_recording(path, np.vstack([probed.positions, ends]) * step, measured, instrument, **pairs)


@dataclass(frozen=True)
class Probed:
    """Points that were probed, or measured by hand.

    Attributes
    ----------
    robot : Robot
    positions : (n, 3) array
        Stable positions of the carriages [motor steps].
    z : (n,) array
        Heights [mm].
    """

    robot: Robot
    positions: Array
    z: Array

    def off(self, step: float | Array) -> Array:
        """Return by how much points lie off their heights (n,) [mm]; nan where the machine cannot stand so."""
        x, solved = printers.nozzle_at(self.robot, self.positions * step)
        return np.where(solved.all(), x[:, 2] - self.z, np.nan)

    def bent(self, step: float | Array) -> float:
        """Return by how much the heights of points differ from one another with steps of a length [mm].

        By their shape alone: endstops are edited after the probing. Infinite where the machine cannot stand so.
        """
        return float(np.nan_to_num(np.ptp(self.off(step)), nan=np.inf))

    def placed(self, step: float | Array) -> bool:
        """Tell whether steps put the bed where a calibration may have to correct it."""
        return abs(float(np.median(self.off(step)))) <= WRONG_STEP

    def usual_steps(self) -> list[tuple[float, float, float]]:
        """Return how bent the bed comes out with a usual pulley, its step and its turn [mm], best first."""
        return sorted(
            (left, step, PITCH * teeth)
            for teeth, doubled in itertools.product(USUAL_TEETH, range(-1, 9))
            if np.isfinite(left := self.bent(step := PITCH * teeth / (FULL_STEPS * 2.0**doubled)))
        )

    def usual_step(self) -> tuple[float, float]:
        """Return the step [mm] of a usual pulley that puts the points at their heights, and its turn [mm].

        Steps of different pulleys lie 3 % and more apart, which bends the bed by millimetres: one fits, or none.

        Raises
        ------
        InputError
            There are no heights to tell by, or no usual step or more than one fits.
        """
        fitting = self.usual_steps() if len(self.z) else []
        if not len(self.z):
            why = "there are no heights to tell by"
        elif not fitting or fitting[0][0] > EDITED:
            why = "that of no usual pulley fits"
        elif len(fitting) > 1 and fitting[1][0] < CLEARLY * fitting[0][0]:
            why = "those of two usual pulleys fit"
        else:
            return fitting[0][1:]
        raise PrinterFile(
            f"the positions are in motor steps, but [stepper_a] does not say how long a step is, and {why}.",
            "Give the whole printer.cfg, with rotation_distance and microsteps (or step_distance).",
        )

    def check_step(self, step: Array) -> None:
        """Raise an InputError where steps put the bed bent and far off, and those of one usual pulley do not.

        A printer that was never calibrated has a bed that is bent with the right steps, too, but in its place.
        """
        if not len(self.z) or (bent := self.bent(step)) <= EDITED or self.placed(step):
            return
        most = min(bent / CLEARLY, WRONG_STEP)
        better = [own[1:] for own in self.usual_steps() if own[0] < most and self.placed(own[1])]
        if len(better) == 1:
            [(usual, belt)] = better
            raise PrinterFile(
                f"with steps of {step[0]:g} mm the bed comes out bent and far off, and all distances are off by one "
                f"factor of {usual / step[0]:.3g}; steps of {usual:g} mm, of a pulley of {belt:g} mm a turn, fit.",
                "Correct rotation_distance or microsteps.",
            )

    def doubts(self, step: Array) -> tuple[str, ...]:
        """Return warnings about heights that cannot be of this geometry; raise where a point is out of reach."""
        if not len(self.z):
            return ()
        _, solved = printers.nozzle_at(self.robot, self.positions * step)
        if not solved.all():
            raise PrinterFile(
                f"at height{int(np.argmin(solved))}_pos the carriages stand where the rods do not reach.",
                "Check rotation_distance, microsteps and arm_length: one of them does not belong to these positions.",
            )
        off = self.off(step)
        if np.ptp(off) >= EDITED or abs(np.median(off)) <= max(FELT, min(EDITED, CLEARLY * np.ptp(off))):
            return ()
        return (
            f"all heights are off by {np.median(off):.3f} mm alike: the saved endstops were changed after the probing. "
            "The shape is not wrong by it. A calibration by these heights undoes that change: where it was made for "
            "the first layer, probe again before.",
        )


def _doubts_of_distances(robot: Robot, ends: Array, measured: Array) -> tuple[str, ...]:
    """Return warnings about printed distances (m,) that do not fit; raise where no printer could have them.

    Parameters
    ----------
    ends : (2 m, 3) array
        Joints at the one and at the other end of each [mm].
    """
    if not len(measured):
        return ()
    x, _ = printers.nozzle_at(robot, ends)
    known = np.linalg.norm(x[1::2] - x[::2], axis=1)
    between = [frozenset(map(tuple, pair)) for pair in ends.round(6).reshape(-1, 2, 3).tolist()]
    for j, own in enumerate(between):
        if (i := between.index(own)) < j:
            raise PrinterFile(
                f"distance{i} and distance{j} lie between the same two points: one line was entered twice, and "
                "another is missing.",
                "Enter the distances again, each in its own place.",
            )
    usual = float(np.median(measured - known))
    off = measured - known - usual
    crossed = np.abs(measured[:, None] - known - usual) < DOUBTFUL
    exchanged = crossed & crossed.T & ~np.eye(len(known), dtype=bool)
    for k in np.flatnonzero(np.abs(off) > ABSURD * known):
        cause = f" It agrees with distance{exchanged[k].argmax()}: the two are exchanged." if exchanged[k].any() else ""
        raise PrinterFile(
            f"distance{k} is {measured[k]:.2f} mm, but the printer moved {known[k]:.2f} mm between its two points: no "
            f"geometry allows that.{cause}",
            "Measure it again with the callipers in mm; check that the pillar widths were entered too.",
        )
    return tuple(
        f"distance{k} is {off[k]:+.2f} mm off what the others say of this printer: measure it again."
        for k in np.flatnonzero(np.abs(off) > DOUBTFUL)
    )


def _sections(lines: list[str]) -> dict[str, dict[str, str]]:
    """Return the keys and values of each section; comments end lines, as they do in Klipper."""
    bare = [re.sub(r"\s*[#;].*$", "", line) for line in lines]
    start = next((k for k, line in enumerate(bare) if line.startswith("[")), len(bare))
    parser = configparser.RawConfigParser(strict=False, delimiters=("=", ":"), allow_no_value=True)
    try:
        parser.read_string("\n".join(bare[start:]))
    except configparser.Error as error:
        raise PrinterFile(
            f"this is no configuration of Klipper: {str(error).splitlines()[0]}.", "Correct it."
        ) from None
    return {
        name.strip(): {key: value for key, value in parser.items(name) if value is not None}
        for name in parser.sections()
    }


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
        self.absent: list[str] = []
        lines = read_text(path).split("\n")
        saved = [re.sub(r"^#\*# ?", "", line) for line in lines if line.startswith(SAVED)]
        self.sections = _sections(saved)
        for name, given in _sections(list(self._body(path.resolve(), ()))).items():
            self.sections[name] = self.sections.get(name, {}) | given
        header = next((k for k, line in enumerate(lines) if HEADER.match(line)), len(lines))
        self.below = any(line.strip() and not line.startswith(SAVED) for line in lines[header:])
        if "printer" not in self.sections:
            raise PrinterFile("there is no [printer] in the file.", self.whole)
        if (kinematics := self.sections["printer"].get("kinematics", "delta")) != "delta":
            other = _OTHERS.get(kinematics, "")
            raise PrinterFile(
                f"the file describes no linear delta ([printer] kinematics: {kinematics}{other}).",
                "Give the printer.cfg of a printer whose carriages slide on three towers.",
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
        return None if text is None else printers.number(text, f"{key} in [{section}]")

    def number(self, section: str, key: str, default: float | None = None) -> float:
        """Return a number, the default where the file does not say it; raise where there is none."""
        found = self.optional(section, key)
        value = default if found is None else found
        if value is None:
            raise PrinterFile(f"{key} in [{section}] is missing.", self.whole)
        return value

    def towers(self, key: str, default: Sequence[float] = ()) -> list[float]:
        """Return a value per tower; one that is not given is the default, or that of tower a, as in Klipper."""
        instead = default or (self.number(FIRST, key),) * len(printers.TOWERS)
        return [self.number(tower, key, other) for tower, other in zip(printers.TOWERS, instead, strict=True)]

    def step(self, tower: str) -> float:
        """Return mm of belt per step of a tower's motor; nan where the file does not say."""
        if (old := self.optional(tower, "step_distance")) is not None:
            return old
        usual = {"rotation_distance": np.nan, "microsteps": np.nan, "full_steps_per_rotation": FULL_STEPS}
        belt, micro, full = (self.number(tower, key, self.number(FIRST, key, u)) for key, u in usual.items())
        gears = re.findall(r"(\d+\.?\d*)\s*:\s*(\d+\.?\d*)", self.sections.get(tower, {}).get("gear_ratio", ""))
        driven, driving = np.array([(1.0, 1.0), *gears], dtype=float).prod(axis=0)
        if any(value <= 0 for value in (belt, micro, full, driven, driving)):
            raise PrinterFile(
                f"rotation_distance, microsteps, full_steps_per_rotation or gear_ratio in [{tower}] is 0 or less.",
                "Correct it.",
            )
        return float(belt * driving / (full * micro * driven))

    def _measured(self, pattern: str, *ends: str) -> tuple[Array, Array]:
        """Return stable positions (n, 3) [motor steps], those of all ends, and what was measured (k,) [mm]."""
        keys = [key for key in self.sections.get("delta_calibrate", {}) if re.fullmatch(pattern, key)]
        keys.sort(key=lambda k: int(re.sub(r"\D", "", k)))
        positions = [self._position(f"{key}_{end}") for key in keys for end in ends]
        measured = [self.number("delta_calibrate", key) for key in keys]
        return np.array(positions).reshape(-1, 3), np.array(measured)

    def _position(self, key: str) -> list[float]:
        cells = self.sections["delta_calibrate"].get(key, "").split(",")
        remedy = "Run DELTA_CALIBRATE and SAVE_CONFIG again."
        if len(cells) != 3:
            problem = f"{key} in [delta_calibrate] is '{','.join(cells)}': three positions were expected."
            raise PrinterFile(problem, remedy)
        return [printers.number(cell, f"a position of {key} in [delta_calibrate]", remedy) for cell in cells]

    def heights(self) -> tuple[Array, Array]:
        """Return where the carriages stood (n, 3) [motor steps] at probed and at manual heights, and these (n,)."""
        both = [self._measured(pattern, "pos") for pattern in (r"height\d+", r"manual_height\d+")]
        return np.vstack([q for q, _ in both]), np.concatenate([z for _, z in both])

    def distances(self) -> tuple[Array, Array]:
        """Return the ends (2 m, 3) [motor steps] of the distances (m,) that were measured on a print, and these."""
        return self._measured(r"distance\d+", "pos1", "pos2")

    def _mesh(self, section: str) -> Array:
        """Return the heights (rows, columns) of a bed mesh [mm]."""
        lines = self.sections[section]["points"].strip().split("\n")
        remedy = "Run BED_MESH_CALIBRATE and SAVE_CONFIG again."
        cells = [
            [printers.number(c, f"a point of [{section}]", remedy) for c in line.split(",") if c.strip()]
            for line in lines
        ]
        if len({len(row) for row in cells}) > 1 or not cells[0]:
            raise PrinterFile(f"the rows of points in [{section}] are not equally long.", remedy)
        return np.array(cells)

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
                raise PrinterFile(
                    f"the name of the mesh '{name[:20]}...' has {len(name)} letters, and a file is named after it.",
                    f"Give it at most {LONGEST_NAME}.",
                )
            out.append((name, grid[inside], z[inside]))
        return out
