"""What printers' firmware keeps, as a robot and recordings: Klipper's printer.cfg, and what all firmwares share.

Formats only, written from their documentation: Klipper's saved block (``[delta_calibrate]``: heights and distances in
stable positions, motor steps since the endstop, which hold whatever the parameters are) and bed meshes. A mesh holds
heights, not joints: the carriages are computed back with the geometry that stands beside it, so it is worth as much as
that geometry was in force. `rrf` and `marlin` read the other firmwares.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.files.klipper import FULL_STEPS, TOWERS, Distance, Height, KlipperFile
from deltacal_gen.files.robot import Robot, robot_from_dict, robot_to_toml
from deltacal_gen.files.writing import write_files, write_recording
from deltacal_gen.machine.registry import SOLVED, Array, load_mechanism
from deltacal_gen.machine.values import Measurement, Recording

ANGLES = (210.0, 330.0, 90.0)  # of the towers, where the file does not say [deg]
PITCH = 2.0  # mm of belt per tooth
USUAL_TEETH = range(15, 30)  # of a pulley; twice as many are half the microsteps
PULLEY = 40.0  # mm of belt per motor turn: 20 teeth of 2 mm, the usual one, where RepRapFirmware does not say
ABSURD = 0.05  # of a distance: no geometry of the printer's parts is so far off
DOUBTFUL = 1.0  # mm: a printed distance so far off the printer's own geometry is looked at again
WRONG_STEP = 5.0  # mm: no bed is so far off by what a calibration corrects
EDITED = 1.0  # mm: heights that all are so far off alike were probed with other endstops
FELT = 0.02  # mm: a first layer shows a nozzle that is so much too low
CLEARLY = 2.0  # by which the step that fits must fit better than the next, and what is alike stand above what is not
DECIMALS = 6  # of mm and deg that are kept: a nanometre, a ten-thousandth of a motor's step
SPREAD = 0.02  # by which the arms of one printer may differ


@dataclass(frozen=True)
class Imported:
    """A robot where it is known, its recordings by name, and what a user should know before using them."""

    robot: Robot | None
    recordings: dict[str, Recording]
    warnings: tuple[str, ...] = field(default=())


def import_klipper(path: str | Path, output: str | Path | None = None) -> Imported:
    """Read a Klipper printer.cfg with its saved block.

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
    file = KlipperFile(path)
    geometry: dict[str, Any] = {
        "radius": file.number("printer", "delta_radius"),
        "arm_length": file.towers("arm_length", None),
        "tower_angle": file.towers("angle", ANGLES),
        "endstop": file.towers("position_endstop", None),
    }
    belt = file.optional("stepper_a", "rotation_distance")
    robot = printer_robot(path.stem, geometry, belt, path)
    warnings = (*file.doubts(), *doubt_arms(geometry["arm_length"]))
    recordings: dict[str, Recording] = {}
    heights, distances = file.heights(), file.distances()
    if heights or distances:
        given = [file.step(tower) for tower in TOWERS]
        step = np.array([v for v in given if v is not None])
        if len(step) < len(given):
            usual, belt, said = _usual_step(robot, heights, path)
            step, warnings = np.full(3, usual), (*warnings, said)
            robot = printer_robot(path.stem, geometry, belt, path)
        else:
            _check_step(robot, heights, step, path)
        recordings["recording"] = _session(path, heights, distances, step)
        warnings += _check_heights(robot, recordings["recording"]) + _check_distances(robot, recordings["recording"])
    for name, points, z in file.meshes():
        offset = np.array([file.optional(file.probe, f"{axis}_offset") or 0.0 for axis in "xy"])
        trigger = file.optional(file.probe, "z_offset") or 0.0
        recordings[f"mesh_{name}"] = map_recording(robot, points - offset, z, trigger, path)
    return done(robot, recordings, warnings, path, output)


# ------------------------------------------------------------------------------------------------------ the results


def printer_robot(name: str, geometry: Mapping[str, Any], belt: float | None, path: Path) -> Robot:
    """Return a linear delta of this geometry [mm, deg], `belt` in mm per motor turn; raise where there can be none."""
    read = {key: np.round(value, DECIMALS).tolist() for key, value in geometry.items()}
    tables: dict[str, Any] = {"robot": {"name": name, "mechanism": "linear_delta"}, "geometry": read}
    if belt is not None:
        tables["transmission"] = {"pulley_circumference": belt}
    try:
        return robot_from_dict(tables)
    except InputError as error:
        raise InputError(error.problem, error.remedy, file=path) from None


def _recording(path: Path, q: Array, height: Array, instrument: str, **pairs: Any) -> Recording:
    n = len(q)
    return Recording(
        path=path,
        kind="height",
        measurement=Measurement(kind="height", frame="robot", instrument=instrument),
        joint_unit="mm",
        joints=np.round(q, DECIMALS),
        columns=("height_mm",),
        measured=np.round(np.asarray(height, dtype=float), DECIMALS)[:, None],
        pose=np.arange(1, n + 1).astype(str),
        line=np.arange(2, n + 2),
        channels={},
        setup=np.zeros(n, dtype=int),
        setup_names=("1",),
        **pairs,
    )


def _session(path: Path, heights: list[Height], distances: list[Distance], step: Array) -> Recording:
    positions = [h.position for h in heights] + [p for d in distances for p in (d.first, d.second)]
    measured = np.concatenate([[h.z for h in heights], np.full(2 * len(distances), np.nan)])
    pairs: dict[str, Any] = {}
    if distances:
        pairs = {
            "pairs": len(heights) + np.arange(2 * len(distances)).reshape(-1, 2),
            "pair_measured": np.array([d.length for d in distances]),
            "pair_line": np.arange(2, len(distances) + 2),
        }
    instrument = "bed probe (heights); caliper on a printed object (distances)" if distances else "bed probe"
    return _recording(path, np.array(positions) * step, measured, instrument, **pairs)


def _usual_step(robot: Robot, heights: list[Height], path: Path) -> tuple[float, float, str]:
    """Return the step [mm] of a usual pulley that puts the probed points at their heights, its turn [mm], and a word.

    Steps of different pulleys lie 3 % and more apart, which bends the bed by millimetres: one fits, or none.

    Raises
    ------
    InputError
        There are no heights to tell by, or no usual step or more than one fits.
    """
    remedy = "Give the whole printer.cfg, with rotation_distance and microsteps (or step_distance)."
    problem = "the positions are in motor steps, but [stepper_a] does not say how long a step is"
    if not heights:
        raise InputError(f"{problem}, and there are no heights to tell by.", remedy, file=path)
    fitting = _usual_steps(robot, heights)
    if not fitting or fitting[0][0] > EDITED:
        raise InputError(f"{problem}, and that of no usual pulley fits.", remedy, file=path)
    if len(fitting) > 1 and fitting[1][0] < CLEARLY * fitting[0][0]:
        raise InputError(f"{problem}, and those of two usual pulleys fit.", remedy, file=path)
    _, step, belt = fitting[0]
    return (
        step,
        belt,
        f"the file does not say how long a motor step is; {step:g} mm puts the probed points at their heights, as of a "
        f"pulley of {belt:g} mm a turn, which is taken. Correct pulley_circumference in robot.toml if it is another.",
    )


def _usual_steps(robot: Robot, heights: list[Height]) -> list[tuple[float, float, float]]:
    """Return how bent the bed comes out with the step of each usual pulley, the step and its turn [mm], best first."""
    return sorted(
        (left, step, PITCH * teeth)
        for teeth, doubled in itertools.product(USUAL_TEETH, range(-1, 9))
        if np.isfinite(left := _bent(robot, heights, step := PITCH * teeth / (FULL_STEPS * 2.0**doubled)))
    )


def _bent(robot: Robot, heights: list[Height], step: float | Array) -> float:
    """Return by how much the heights of probed points differ from one another with steps of a length [mm].

    By their shape alone: endstops are edited after the probing. Infinite where the machine cannot stand so.
    """
    off = _heights_off(robot, heights, step)
    return np.inf if off is None else float(np.ptp(off))


def _heights_off(robot: Robot, heights: list[Height], step: float | Array) -> Array | None:
    """Return by how much probed points lie off their heights (n,) [mm]; None where the machine cannot stand so."""
    mechanism = load_mechanism(robot.mechanism)
    positions, z = np.array([h.position for h in heights]), np.array([h.z for h in heights])
    x, status = mechanism.forward(positions * step, robot.tool, mechanism.rows(robot))
    return x[:, 2] - z if (status == SOLVED).all() else None


def _check_step(robot: Robot, heights: list[Height], step: Array, path: Path) -> None:
    """Raise an InputError where steps put the bed bent and far off, and those of one usual pulley do not.

    A printer that was never calibrated has a bed that is bent with the right steps, too, but in its place.
    """
    if not heights or (bent := _bent(robot, heights, step)) <= EDITED or _placed(robot, heights, step):
        return
    try:
        usual, belt, _ = _usual_step(robot, heights, path)
    except InputError:
        most = min(bent / CLEARLY, WRONG_STEP)
        better = [own for own in _usual_steps(robot, heights) if own[0] < most and _placed(robot, heights, own[1])]
        if len(better) != 1:
            return
        [(_, usual, belt)] = better
    raise InputError(
        f"with steps of {step[0]:g} mm the bed comes out bent and far off, and all distances are off by one factor of "
        f"{usual / step[0]:.3g}; steps of {usual:g} mm, of a pulley of {belt:g} mm a turn, fit.",
        "Correct rotation_distance or microsteps.",
        file=path,
    )


def _placed(robot: Robot, heights: list[Height], step: float | Array) -> bool:
    """Tell whether steps put the bed where a calibration may have to correct it."""
    off = _heights_off(robot, heights, step)
    return off is not None and abs(float(np.median(off))) <= WRONG_STEP


def map_recording(robot: Robot, nozzle: Array, z: Array, trigger: float, path: Path) -> Recording:
    """Return the recording of a map: the carriages stood where the geometry puts them for the probed height."""
    mechanism = load_mechanism(robot.mechanism)
    targets = np.column_stack([nozzle, z + trigger])
    q, _, status = mechanism.inverse(targets, robot.tool, mechanism.rows(robot))
    if (status != SOLVED).any():
        x, y = nozzle[np.argmax(status != SOLVED)]
        raise InputError(
            f"the printer cannot stand at x = {x:.1f}, y = {y:.1f} mm of the map with the geometry beside it.",
            "Give the geometry that was in force when the map was probed; check arm length and radius.",
            file=path,
        )
    return _recording(path, q, np.full(len(q), trigger), "bed probe, a mesh over the bed")


def done(
    robot: Robot,
    recordings: dict[str, Recording],
    warnings: tuple[str, ...],
    path: Path,
    output: str | Path | None,
) -> Imported:
    """Return what was imported, written into a folder where there is one; raise where nothing was measured."""
    if not recordings:
        raise InputError(
            "there are neither heights, distances nor a bed mesh in the file.",
            "Run DELTA_CALIBRATE or BED_MESH_CALIBRATE and SAVE_CONFIG, and give the file again.",
            file=path,
        )
    return write_import(Imported(robot, recordings, warnings), output)


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


# ----------------------------------------------------------------------------------------------- mistakes users make


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


def _check_heights(robot: Robot, recording: Recording) -> tuple[str, ...]:
    """Return warnings about heights that cannot be of this geometry; raise where a probed point is out of reach."""
    rows = np.flatnonzero(np.isfinite(recording.measured[:, 0]))
    if not len(rows):
        return ()
    mechanism = load_mechanism(robot.mechanism)
    x, status = mechanism.forward(recording.joints[rows], robot.tool, mechanism.rows(robot))
    if (status != SOLVED).any():
        k = int(np.argmax(status != SOLVED))
        raise InputError(
            f"at height{k}_pos the carriages stand where the rods do not reach.",
            "Check rotation_distance, microsteps and arm_length: one of them does not belong to these positions.",
            file=recording.path,
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
    a, b = recording.pairs.T
    known = np.linalg.norm(x[b, :3] - x[a, :3], axis=1)
    off = recording.pair_measured - known
    same = _repeated(recording)
    warnings: list[str] = []
    if len(same):
        i, j = same[0]
        raise InputError(
            f"distance{i} and distance{j} lie between the same two points: one line was entered twice, and another is "
            "missing.",
            "Enter the distances again, each in its own place.",
            file=recording.path,
        )
    usual = float(np.median(off))
    for k in np.flatnonzero(np.isfinite(off)):
        if abs(off[k] - usual) > ABSURD * known[k]:
            swapped = next(
                (
                    int(m)
                    for m in range(len(off))
                    if m != k
                    and abs(recording.pair_measured[m] - known[k] - usual) < DOUBTFUL
                    and abs(recording.pair_measured[k] - known[m] - usual) < DOUBTFUL
                ),
                None,
            )
            cause = f" It agrees with distance{swapped}: the two are exchanged." if swapped is not None else ""
            raise InputError(
                f"distance{k} is {recording.pair_measured[k]:.2f} mm, but the printer moved {known[k]:.2f} mm between "
                f"its two points: no geometry allows that.{cause}",
                "Measure it again with the callipers in mm; check that the pillar widths were entered too.",
                file=recording.path,
            )
        if abs(off[k] - usual) > DOUBTFUL:
            warnings.append(
                f"distance{k} is {off[k] - usual:+.2f} mm off what the others say of this printer: measure it again."
            )
    return tuple(warnings)


def _repeated(recording: Recording) -> list[tuple[int, int]]:
    assert recording.pairs is not None
    ends = [frozenset(map(tuple, recording.joints[pair].round(6).tolist())) for pair in recording.pairs]
    return [(i, j) for j in range(len(ends)) for i in range(j) if ends[i] == ends[j]]
