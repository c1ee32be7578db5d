"""The way back into a printer: the lines of its firmware that describe the calibrated machine, as far as they can.

Firmware knows radius, arms, tower angles and endstops. Where the readings have been fitted by just these, that fit is
written. Of a machine that has more, the lines are those with the least error over the bed, which is what the first
layer asks for, and over the printed volume; where nothing but heights was read, over the bed alone: they do not say
where across it the nozzle is. What is in the file now stands beside; lines that are worse are refused.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import numpy as np

from deltacal_gen.errors import NoSolutionError, UsageError
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.files.printers import ANGLES, DECIMALS, TOWERS
from deltacal_gen.files.robot import Robot
from deltacal_gen.files.writing import write_files
from deltacal_gen.machine.registry import SOLVED, Array, Machine, load_mechanism, mechanism_of
from deltacal_gen.machine.rotation import about_z
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.result import Result
from deltacal_gen.results.written import FirmwareLeft, FirmwareLines, FirmwareValue
from deltacal_gen.units import DEG, file_unit, to_internal

MODEL = "linear_delta/9"  # what Klipper, RepRapFirmware and Marlin describe
FROM_HEIGHTS = "linear_delta/6"  # what they fit to heights alone
KINDS = ("klipper", "rrf", "marlin")
PRINTED = 0.6  # of the radius: the printed volume's, where the robot file gives no workspace
NEGLIGIBLE = 1e-9  # of a parameter, internal units
WORSE = 1e-6  # mm: lines that leave so much more on the bed than those in the file now are worse
LAYERS = (0.0, 0.2, 0.4)  # of the endstop's height; the first is the bed
RINGS = (1 / 3, 2 / 3, 1.0)  # of the printed radius
BED_MM = 0.02  # what a probe knows of the bed, and a first layer bears
VOLUME_MM = 1.0  # what distances and a probe leave open of where the nozzle is
HEIGHTS = "height"  # kind of readings that say nothing of where across the bed the nozzle is
PLACE = "put these above the SAVE_CONFIG block: there they hold before what it saved; below it Klipper drops the block"
STEP = 0.1  # ordinary sizes: of a finite difference
ROUNDS, SETTLED = 30, 1e-9  # of the fit of the lines; ordinary sizes


def knows(problem: Problem) -> bool:
    """Tell whether firmware has a model of what readings say: a printer's, which a second encoder says nothing of."""
    return problem.mechanism.name == MODEL.partition("/")[0] and not problem.readings.kind.sees_joints


def exceeded_by(model: str) -> bool:
    """Tell whether a printer's model has more than firmware fits to heights; for less there may be too few heights."""
    models = load_mechanism(MODEL.partition("/")[0]).models
    return len(models[model]) > len(models[FROM_HEIGHTS])


def firmware_lines(
    robot: Robot,
    kind: str,
    physics: Sequence[str] = (),
    fitted: Mapping[str, float] | None = None,
    *,
    heights_alone: bool = False,
) -> FirmwareLines:
    """Return the lines of a printer's firmware for a calibrated machine.

    Parameters
    ----------
    robot : Robot
        Linear delta, with its errors; its geometry is what is in the firmware's file now.
    kind : {"klipper", "rrf", "marlin"}
    physics : sequence of str
        Effects that were diagnosed on it, which no line can carry.
    fitted : mapping, optional
        Source errors in the units of files, where the firmware's own parameters have been fitted to the readings.
    heights_alone : bool
        Whether nothing but heights was read.

    Raises
    ------
    UsageError
        Another mechanism, or another firmware.
    NoSolutionError
        No lines leave less on the bed than those in the file now.
    """
    if robot.mechanism != MODEL.partition("/")[0] or kind not in KINDS:
        raise UsageError(
            f"{', '.join(KINDS)} lines describe a {MODEL.partition('/')[0]}, not '{kind}' of a {robot.mechanism}."
        )
    mechanism = mechanism_of(robot)
    belts = kind == "klipper" and robot.transmission is not None and not heights_alone
    bed = Printed(robot, mechanism, belts=belts)
    nominal = dataclasses.replace(robot, errors={})
    own = set(mechanism.model(MODEL))
    by_readings = fitted is not None and set(fitted) <= own
    if by_readings and fitted is not None:
        units = {p.name: p.unit for p in mechanism.parameters}
        written = dataclasses.replace(nominal, errors={n: v * to_internal(units[n]) for n, v in fitted.items()})
    else:
        written = bed.closest(nominal, heights_alone)
    before, after = bed.left(nominal), bed.left(written)
    if not by_readings and after.bed_rms_mm > before.bed_rms_mm + WORSE:
        raise NoSolutionError(
            f"lines of {kind} for this machine would leave {after.bed_rms_mm:.4f} mm rms on the bed, those in the "
            f"file now {before.bed_rms_mm:.4f} mm: what is wrong with it is not in the firmware's model. Keep the "
            "lines that are there, and compensate the bed by a mesh."
        )
    missing = [] if by_readings else _not_carried(bed.carried, mechanism, own)
    missing += [f"the effect {name}" for name in physics]
    values = _changes(nominal, written)
    lines = FirmwareLines(
        kind=kind,
        text=_WRITERS[kind](written, bed.scales),
        by_readings=by_readings,
        heights_alone=heights_alone,
        before=before,
        after=after,
        values=values,
        not_carried=tuple(missing),
    )
    return lines.replace(text="\n".join([*_head(robot.name, lines), lines.text]) + "\n")


def _head(name: str, lines: FirmwareLines) -> list[str]:
    """Return what stands above the lines: what they leave, what they change, and what they cannot carry."""
    mark = "#" if lines.kind == "klipper" else ";"
    over = f"rms {lines.after.rms_mm:.4f}, worst {lines.after.worst_mm:.4f} mm"
    volume = "heights alone do not say" if lines.heights_alone else over
    head = [
        *[PLACE] * (lines.kind == "klipper"),
        "meshes of the bed that were probed before do not hold with these lines: clear them, and probe again",
        f"{name}: what these lines leave over the printed volume: {volume}",
        f"on the bed: rms {lines.after.bed_rms_mm:.4f} mm, by the lines before {lines.before.bed_rms_mm:.4f} mm",
        *(f"{v.name}: {v.before:.4f} -> {v.after:.4f} {v.unit}" for v in lines.values),
        *["not carried by them:"] * bool(lines.not_carried),
        *(f"  {note}" for note in lines.not_carried),
    ]
    return [f"{mark} {line}" for line in head]


def lines_of(known: Result, robot: Robot, kind: str, physics: Sequence[str]) -> FirmwareLines:
    """Return the lines for a result: those that the firmware's own fit to its readings gives, where there is one.

    Raises
    ------
    NoSolutionError
        They predict readings that took no part in the fit worse than the lines in the file now fit all.
    """
    beside = known.firmware
    if known.model == MODEL or known.model == FROM_HEIGHTS:
        heldout = known.heldout_rms_mm
    else:
        heldout = None if beside is None else beside.heldout_rms_mm
    if heldout is not None and heldout > known.before_rms_mm:
        raise NoSolutionError(
            f"readings that took no part in the fit are missed by {heldout:.4f} mm, the lines in the file now miss "
            f"all by {known.before_rms_mm:.4f} mm: new lines would be no better. Keep those that are there, or probe "
            "more points."
        )
    fitted = None if beside is None else beside.errors
    return firmware_lines(robot, kind, physics, fitted, heights_alone=reads_heights_alone(known))


def reads_heights_alone(known: Result | Diagnosis) -> bool:
    """Tell whether an answer's readings are heights above the bed and nothing else."""
    return known.instrument.kind == HEIGHTS


def export_firmware(found: FirmwareLines, path: str | Path) -> None:
    """Write the lines of a printer's firmware; see `firmware_lines`."""
    write_files({Path(path): found.text})


class Printed:
    """The printed volume of a calibrated machine: where it stands when the firmware asks for its points."""

    def __init__(self, robot: Robot, mechanism: Machine, *, belts: bool) -> None:
        self.mechanism = mechanism
        scales = {n: v for n, v in robot.errors.items() if n.startswith("scale_") and abs(v) > NEGLIGIBLE}
        self.scales = scales if belts else {}  # the length of a belt's turn can be written where it is known
        self.carried = dataclasses.replace(
            robot, errors={n: v for n, v in robot.errors.items() if n not in self.scales}
        )
        space = robot.workspace
        wide = space.radius if space is not None and space.radius is not None else PRINTED * robot.geometry["radius"][0]
        around = np.linspace(0, 2 * np.pi, 12, endpoint=False)
        disc = np.vstack([[[0.0, 0.0]], *(about_z(part * wide, around) for part in RINGS)])
        high = float(np.min(robot.geometry["endstop"]))
        targets = np.vstack([np.column_stack([disc, np.full(len(disc), part * high)]) for part in LAYERS])
        q, _, status = mechanism.inverse(targets, robot.tool, mechanism.rows(self.carried))
        reached = status == SOLVED
        self.q, self.targets = q[reached], targets[reached]
        self.on_bed = self.targets[:, 2] == 0.0

    def _off(self, written: Robot) -> Array:
        """Return by how much the machine misses each point (N, 3) [mm] when lines describe it as `written`.

        The carriages stand where the true machine's are; lines that put the nozzle elsewhere are off by as much.
        """
        x, _ = self.mechanism.forward(self.q, written.tool, self.mechanism.rows(written))
        return self.targets - x[:, :3]

    def left(self, written: Robot) -> FirmwareLeft:
        """Return what lines leave."""
        off = self._off(written)
        size, across, height = np.linalg.norm(off, axis=1), np.linalg.norm(off[:, :2], axis=1), off[self.on_bed, 2]

        def written_out(value: float) -> float:
            return round(float(value), DECIMALS)  # what lines with as many decimals can leave

        return FirmwareLeft(
            bed_rms_mm=written_out(np.sqrt(np.mean(height**2))),
            bed_worst_mm=written_out(np.abs(height).max()),
            lateral_rms_mm=written_out(np.sqrt(np.mean(across**2))),
            lateral_worst_mm=written_out(across.max()),
            rms_mm=written_out(np.sqrt(np.mean(size**2))),
            worst_mm=written_out(size.max()),
        )

    def closest(self, nominal: Robot, heights_alone: bool = False) -> Robot:
        """Return the machine that firmware can describe with the least error over bed and volume, or the bed alone."""
        names = self.mechanism.model(FROM_HEIGHTS if heights_alone else MODEL)
        typical = self.mechanism.typical[[self.mechanism.index[n] for n in names]]
        volume = 0.0 if heights_alone else 1 / VOLUME_MM
        weight = np.where(self.on_bed[:, None] & (np.arange(3) == 2), 1 / BED_MM, volume)

        def described(errors: Array) -> Robot:
            return dataclasses.replace(nominal, errors=dict(zip(names, (errors * typical).tolist(), strict=True)))

        def missed(errors: Array) -> Array:
            return (weight * self._off(described(errors))).ravel()

        errors = np.zeros(len(names))
        for _ in range(ROUNDS):  # a smooth problem of a few unknowns near its solution: Gauss-Newton
            steps = STEP * np.eye(len(names))
            J = np.column_stack([(missed(errors + s) - missed(errors - s)) / (2 * STEP) for s in steps])
            change = np.linalg.lstsq(J, -missed(errors), rcond=None)[0]
            errors = errors + change
            if np.abs(change).max() < SETTLED:
                break
        return described(errors)


def _not_carried(carried: Robot, mechanism: Machine, own: set[str]) -> list[str]:
    """Return in words what the machine has beside the firmware's parameters."""
    notes = []
    for p in mechanism.parameters:
        value = carried.errors.get(p.name, 0.0)
        if p.name not in own and abs(value) > NEGLIGIBLE:
            unit = "" if p.unit == "1" else f" {file_unit(p.unit)}"
            notes.append(f"{p.name} = {value / to_internal(p.unit):+.4f}{unit} ({p.meaning})")
    return notes


def _values(robot: Robot) -> tuple[float, Array, Array, Array]:
    """Return radius, arms, angles [deg] and endstops, errors included."""
    e, g = robot.errors, robot.geometry
    arm, angle, endstop = (
        g[key] + np.array([e.get(f"{error}_{i}", 0.0) for i in (1, 2, 3)])
        for key, error in (("arm_length", "arm"), ("tower_angle", "angle"), ("endstop", "endstop"))
    )
    return float(g["radius"][0] + e.get("radius", 0.0)), arm, angle / DEG, endstop


def _changes(before: Robot, after: Robot) -> tuple[FirmwareValue, ...]:
    """Return each of the firmware's numbers as it is and as it is to be."""
    (radius, *old), (new_radius, *new) = _values(before), _values(after)
    rows = [("radius", radius, new_radius, "mm")]
    for name, unit, was, becomes in zip(("arm", "angle", "endstop"), ("mm", "deg", "mm"), old, new, strict=True):
        rows += [
            (f"{name} of {'abc'[i]}", float(w), float(b), unit)
            for i, (w, b) in enumerate(zip(was, becomes, strict=True))
        ]
    return tuple(FirmwareValue(name=n, before=w, after=b, unit=u) for n, w, b, u in rows)


def _klipper(robot: Robot, scales: Mapping[str, float]) -> str:
    radius, arm, angle, endstop = _values(robot)
    lines = ["[printer]", f"delta_radius: {radius:.6f}"]
    belt = None if robot.transmission is None else robot.transmission.pulley_circumference
    for i, (tower, a, phi, home) in enumerate(zip(TOWERS, arm, angle, endstop, strict=True), start=1):
        lines += ["", f"[{tower}]", f"angle: {phi:.6f}", f"arm_length: {a:.6f}", f"position_endstop: {home:.6f}"]
        if belt is not None and f"scale_{i}" in scales:
            lines.append(f"rotation_distance: {belt * (1 + scales[f'scale_{i}']):.6f}")
    return "\n".join(lines)


def _rrf(robot: Robot, scales: Mapping[str, float]) -> str:
    radius, arm, angle, endstop = _values(robot)
    home = float(endstop.mean())
    turned = " ".join(f"{axis}{phi - nominal:.4f}" for axis, phi, nominal in zip("XYZ", angle, ANGLES, strict=True))
    rods = ":".join(f"{a:.4f}" for a in arm)
    trims = " ".join(f"{axis}{h - home:.4f}" for axis, h in zip("XYZ", endstop, strict=True))
    return f"M665 R{radius:.4f} L{rods} H{home:.4f} {turned}\nM666 {trims}"


def _marlin(robot: Robot, scales: Mapping[str, float]) -> str:
    """Return M665 and M666: carriages go down from their switches by the trims, which therefore are none above 0."""
    radius, arm, angle, endstop = _values(robot)
    home, rod = float(endstop.min()), float(arm.mean())
    turned = " ".join(f"{axis}{phi - nominal:.4f}" for axis, phi, nominal in zip("XYZ", angle, ANGLES, strict=True))
    rods = " ".join(f"{axis}{a - rod:.4f}" for axis, a in zip("ABC", arm, strict=True))
    trims = " ".join(f"{axis}{home - h:.4f}" for axis, h in zip("XYZ", endstop, strict=True))
    return f"M665 L{rod:.4f} R{radius:.4f} H{home:.4f} {turned} {rods}\nM666 {trims}\nM500"


_WRITERS: dict[str, Callable[[Robot, Mapping[str, float]], str]] = {"klipper": _klipper, "rrf": _rrf, "marlin": _marlin}
