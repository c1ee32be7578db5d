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

from deltacal_gen.errors import InputError, PrinterFile
from deltacal_gen.files.imported import Imported
from deltacal_gen.files.naming import naming
from deltacal_gen.files.printers import ANGLES, TOWERS, done, doubt_arms, height_recording, map_recording, printer_robot
from deltacal_gen.files.robot import Robot
from deltacal_gen.files.rows import number_of
from deltacal_gen.files.toml import read_text
from deltacal_gen.machine.registry import SOLVED, Array, load_mechanism
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
FULL_STEPS = 200.0  # of a motor's turn
ROUNDED = 1e-3  # of the bed's radius: a map's limits are written with a digit or two
LONGEST_NAME = 100  # letters of a mesh's name, which becomes a file's


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
    """
    path = Path(path)
    with naming(path):
        file = KlipperFile(path)
        geometry: dict[str, Any] = {
            "radius": file.number("printer", "delta_radius"),
            "arm_length": file.towers("arm_length"),
            "tower_angle": file.towers("angle", ANGLES),
            "endstop": file.towers("position_endstop"),
        }
        belt = file.optional("stepper_a", "rotation_distance")
        robot = printer_robot(path.stem, geometry, belt)
        warnings = (*file.doubts(), *doubt_arms(geometry["arm_length"]))
        recordings: dict[str, Recording] = {}
        probed, ends, lengths = Probed(robot, *file.heights()), *file.distances()
        if len(probed.z) or len(lengths):
            step = [file.step(tower) for tower in TOWERS]
            if None in step:
                usual, belt = probed.usual_step()
                step = [usual] * len(TOWERS)
                robot = printer_robot(path.stem, geometry, belt)
                warnings += (
                    f"the file does not say how long a motor step is; {usual:g} mm puts the probed points at their "
                    f"heights, as of a pulley of {belt:g} mm a turn, which is taken. Correct pulley_circumference in "
                    "robot.toml if it is another.",
                )
            else:
                probed.check_step(np.array(step, dtype=float))
            recordings["recording"] = recording = _session(path, probed, ends, lengths, np.array(step, dtype=float))
            warnings += _check_heights(robot, recording) + _check_distances(robot, recording)
        for name, points, z in file.meshes():
            offset = np.array([file.optional(file.probe, f"{axis}_offset") or 0.0 for axis in "xy"])
            trigger = file.optional(file.probe, "z_offset") or 0.0
            recordings[f"mesh_{name}"] = map_recording(robot, points - offset, z, trigger, path)
        return done(robot, recordings, warnings, output)


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
    return height_recording(path, np.vstack([probed.positions, ends]) * step, measured, instrument, **pairs)


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

    def off(self, step: float | Array) -> Array | None:
        """Return by how much points lie off their heights (n,) [mm]; None where the machine cannot stand so."""
        mechanism = load_mechanism(self.robot.mechanism)
        x, status = mechanism.forward(self.positions * step, self.robot.tool, mechanism.rows(self.robot))
        return x[:, 2] - self.z if (status == SOLVED).all() else None

    def bent(self, step: float | Array) -> float:
        """Return by how much the heights of points differ from one another with steps of a length [mm].

        By their shape alone: endstops are edited after the probing. Infinite where the machine cannot stand so.
        """
        off = self.off(step)
        return np.inf if off is None else float(np.ptp(off))

    def placed(self, step: float | Array) -> bool:
        """Tell whether steps put the bed where a calibration may have to correct it."""
        off = self.off(step)
        return off is not None and abs(float(np.median(off))) <= WRONG_STEP

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
        try:
            better = [self.usual_step()]
        except InputError:
            most = min(bent / CLEARLY, WRONG_STEP)
            better = [own[1:] for own in self.usual_steps() if own[0] < most and self.placed(own[1])]
        if len(better) == 1:
            [(usual, belt)] = better
            raise PrinterFile(
                f"with steps of {step[0]:g} mm the bed comes out bent and far off, and all distances are off by one "
                f"factor of {usual / step[0]:.3g}; steps of {usual:g} mm, of a pulley of {belt:g} mm a turn, fit.",
                "Correct rotation_distance or microsteps.",
            )


def _check_heights(robot: Robot, recording: Recording) -> tuple[str, ...]:
    """Return warnings about heights that cannot be of this geometry; raise where a probed point is out of reach."""
    rows = np.flatnonzero(np.isfinite(recording.measured[:, 0]))
    if not len(rows):
        return ()
    mechanism = load_mechanism(robot.mechanism)
    x, status = mechanism.forward(recording.joints[rows], robot.tool, mechanism.rows(robot))
    if (status != SOLVED).any():
        raise PrinterFile(
            f"at height{int(np.argmax(status != SOLVED))}_pos the carriages stand where the rods do not reach.",
            "Check rotation_distance, microsteps and arm_length: one of them does not belong to these positions.",
        )
    off = x[:, 2] - recording.measured[rows, 0]
    if np.ptp(off) < EDITED and abs(np.median(off)) > max(FELT, min(EDITED, CLEARLY * np.ptp(off))):
        return (
            f"all heights are off by {np.median(off):.3f} mm alike: the saved endstops were changed after the probing. "
            "The shape is not wrong by it. A calibration by these heights undoes that change: where it was made for "
            "the first layer, probe again before.",
        )
    return ()


def _check_distances(robot: Robot, recording: Recording) -> tuple[str, ...]:
    """Return warnings about printed distances that do not fit the printer; raise where no printer could have them."""
    if recording.pairs is None or recording.pair_measured is None:
        return ()
    mechanism = load_mechanism(robot.mechanism)
    x, _ = mechanism.forward(recording.joints, robot.tool, mechanism.rows(robot))
    first, second = x[recording.pairs.T, :3]
    known, measured = np.linalg.norm(second - first, axis=1), recording.pair_measured
    ends = [frozenset(map(tuple, recording.joints[pair].round(6).tolist())) for pair in recording.pairs]
    for j, own in enumerate(ends):
        if (i := ends.index(own)) < j:
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
        if text is None:
            return None
        value = number_of(text)
        if value is None or not np.isfinite(value):
            raise PrinterFile(f"{key} in [{section}] is '{text}': a number was expected.", "Correct it.")
        return value

    def number(self, section: str, key: str) -> float:
        """Return a number; raise where the file does not say."""
        value = self.optional(section, key)
        if value is None:
            raise PrinterFile(f"{key} in [{section}] is missing.", self.whole)
        return value

    def towers(self, key: str, default: Sequence[float] = ()) -> list[float]:
        """Return a value per tower; one that is not given is the default, or that of tower a, as in Klipper."""
        found = [self.optional(tower, key) for tower in TOWERS]
        instead = default or (self.number("stepper_a", key),) * len(TOWERS)
        return [d if v is None else v for v, d in zip(found, instead, strict=True)]

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
            raise PrinterFile(
                f"rotation_distance, microsteps, full_steps_per_rotation or gear_ratio in [{tower}] is 0 or less.",
                "Correct it.",
            )
        return float(belt * driving / ((full or FULL_STEPS) * micro * driven))

    def _measured(self, pattern: str, *ends: str) -> tuple[Array, Array]:
        """Return stable positions (n, 3) [motor steps], those of all ends, and what was measured (k,) [mm]."""
        keys = [key for key in self.sections.get("delta_calibrate", {}) if re.fullmatch(pattern, key)]
        keys.sort(key=lambda k: int(re.sub(r"\D", "", k)))
        positions = [self._position(f"{key}_{end}") for key in keys for end in ends]
        measured = [self.number("delta_calibrate", key) for key in keys]
        return np.array(positions).reshape(-1, 3), np.array(measured)

    def _position(self, key: str) -> list[float]:
        text = self.sections["delta_calibrate"].get(key, "")
        found = [number_of(cell) for cell in text.split(",")]
        if len(found) != 3 or not np.isfinite(np.array(found, dtype=float)).all():
            raise PrinterFile(
                f"{key} in [delta_calibrate] is '{text}': three positions, separated by commas, were expected.",
                "Run DELTA_CALIBRATE and SAVE_CONFIG again.",
            )
        return [v for v in found if v is not None]

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
        cells = [[c.strip() for c in line.split(",") if c.strip()] for line in lines]
        bad = next((c for row in cells for c in row if (v := number_of(c)) is None or not np.isfinite(v)), None)
        if bad is not None:
            problem = f"a point of [{section}] is '{bad}': a number was expected."
        elif len({len(row) for row in cells}) > 1 or not cells[0]:
            problem = f"the rows of points in [{section}] are not equally long."
        else:
            return np.array(cells, dtype=float)
        raise PrinterFile(problem, "Run BED_MESH_CALIBRATE and SAVE_CONFIG again.")

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
