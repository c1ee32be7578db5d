"""The way back into a printer: the lines of its firmware that describe the calibrated machine, as far as they can.

Firmware knows radius, arms, tower angles and endstops. Where the readings have been fitted by just these, that fit is
written. Of a machine that has more, the lines are those with the least error over the bed, which is what the first
layer asks for, and over the printed volume; where nothing but heights was read, over the bed alone: they do not say
where across it the nozzle is. What is in the file now stands beside; lines that are worse are refused.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares

from deltacal_gen.errors import NoImprovement, NotForThisMachine
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.files.printers import ANGLES, DECIMALS
from deltacal_gen.files.robot import Robot, robot_of
from deltacal_gen.files.writing import write_files
from deltacal_gen.machine.registry import SOLVED, Array, Machine, load_mechanism, mechanism_of
from deltacal_gen.machine.rotation import about_z
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.result import Result
from deltacal_gen.results.written import FirmwareLeft, FirmwareLines, FirmwareValue
from deltacal_gen.units import DEG, file_unit, to_internal
from deltacal_gen.use.exporters import Exporter

PRINTER = "linear_delta"
MODEL = f"{PRINTER}/9"  # what Klipper, RepRapFirmware and Marlin describe
FROM_HEIGHTS = f"{PRINTER}/6"  # what they fit to heights alone
PRINTED = 0.6  # of the radius: the printed volume's, where the robot file gives no workspace
NEGLIGIBLE = 1e-9  # of a parameter, internal units
WORSE = 1e-6  # mm: lines that leave so much more on the bed than those in the file now are worse
LAYERS = (0.0, 0.2, 0.4)  # of the endstop's height; the first is the bed
RINGS = (1 / 3, 2 / 3, 1.0)  # of the printed radius
BED_MM = 0.02  # what a probe knows of the bed, and a first layer bears
VOLUME_MM = 1.0  # what distances and a probe leave open of where the nozzle is
HEIGHTS = "height"  # kind of readings that say nothing of where across the bed the nozzle is


def knows(problem: Problem) -> bool:
    """Tell whether firmware has a model of what readings say: a printer's, which a second encoder says nothing of."""
    return problem.mechanism.name == PRINTER and not problem.readings.kind.sees_joints


def exceeded_by(model: str) -> bool:
    """Tell whether a printer's model has more than firmware fits to heights; for less there may be too few heights."""
    models = load_mechanism(PRINTER).models
    return len(models[model]) > len(models[FROM_HEIGHTS])


class Firmware(Exporter):
    """A printer's firmware, whose own numbers describe a linear delta.

    Attributes
    ----------
    mark : str
        Begins a comment.
    belts : bool
        Whether the length of a belt's turn is one of its numbers.
    notes : tuple of str
        What stands above all lines.
    """

    mark = ";"
    belts = False
    notes: tuple[str, ...] = ()

    def lines(self, robot: Robot, scales: Mapping[str, float]) -> list[str]:
        """Return the lines of a robot that it can describe, and of the scales of its belts."""
        raise NotImplementedError

    def at_rest(self, known: Result | Diagnosis, path: Path, *, kind: str, worst_mm: float) -> FirmwareLines:
        """Write the lines; see `lines_of`."""
        found = self.lines_of(known)
        write_files({path: found.text})
        return found

    def lines_of(self, known: Result | Diagnosis) -> FirmwareLines:
        """Return the lines for an answer: those that the firmware's own fit to its readings gives, where there is one.

        Raises
        ------
        UsageError
            Another mechanism.
        NoSolutionError
            They predict readings that took no part in the fit worse than the lines in the file now fit all, or leave
            more on the bed.
        """
        beside = None
        if isinstance(known, Result):
            beside = known.firmware
            fit = known if known.model in (MODEL, FROM_HEIGHTS) else beside
            heldout = None if fit is None else fit.heldout_rms_mm
            if heldout is not None and heldout > known.before_rms_mm:
                raise NoImprovement(
                    f"the held-out error of new lines is {heldout:.4f} mm, the error of those in the file now "
                    f"{known.before_rms_mm:.4f} mm: your current values are already as good. Keep them, or probe a "
                    "mesh."
                )
        return self.describe(
            robot_of(known.robot),
            [term.effect for term in known.physics or ()],
            None if beside is None else beside.errors,
            heights_alone=known.instrument.kind == HEIGHTS,
        )

    def describe(
        self,
        robot: Robot,
        physics: Sequence[str] = (),
        fitted: Mapping[str, float] | None = None,
        *,
        heights_alone: bool = False,
    ) -> FirmwareLines:
        """Return the lines for a calibrated machine.

        Parameters
        ----------
        robot : Robot
            Linear delta, with its errors; its geometry is what is in the firmware's file now.
        physics : sequence of str
            Effects that were diagnosed on it, which no line can carry.
        fitted : mapping, optional
            Source errors in the units of files, where the firmware's own parameters have been fitted to the readings.
        heights_alone : bool
            Whether nothing but heights was read.
        """
        if robot.mechanism != PRINTER:
            raise NotForThisMachine(f"lines of {self.name} describe a {PRINTER}, not a {robot.mechanism}.")
        mechanism = mechanism_of(robot)
        belts = self.belts and robot.transmission is not None and not heights_alone
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
            raise NoImprovement(
                f"lines of {self.name} for this machine would leave {after.bed_rms_mm:.4f} mm rms on the bed, those in "
                f"the file now {before.bed_rms_mm:.4f} mm: what is wrong with it is not in the firmware's model. Keep "
                "the lines that are there, and compensate the bed by a mesh."
            )
        missing = [] if by_readings else _not_carried(bed.carried, mechanism, own)
        lines = FirmwareLines(
            kind=self.name,
            text="",
            by_readings=by_readings,
            heights_alone=heights_alone,
            before=before,
            after=after,
            values=_changes(nominal, written),
            not_carried=(*missing, *(f"the effect {name}" for name in physics)),
        )
        head = (f"{self.mark} {words}" for words in (*self.notes, *_head(robot.name, lines)))
        return lines.replace(text="\n".join([*head, *self.lines(written, bed.scales)]) + "\n")


def _head(name: str, lines: FirmwareLines) -> list[str]:
    """Return what stands above the lines: what they leave, what they change, and what they cannot carry."""
    after, was = lines.after, lines.before.bed_rms_mm
    over = f"rms {after.rms_mm:.4f}, worst {after.worst_mm:.4f} mm"
    return [
        "meshes of the bed that were probed before do not hold with these lines: clear them, and probe again",
        f"{name}: error over the printed volume with these lines: "
        + ("unknown from heights alone" if lines.heights_alone else over),
        f"error on the bed: rms {after.bed_rms_mm:.4f} mm, with the lines before {was:.4f} mm",
        *(f"{v.name}: {v.before:.4f} -> {v.after:.4f} {v.unit}" for v in lines.values),
        *["not carried by them:"] * bool(lines.not_carried),
        *(f"  {note}" for note in lines.not_carried),
    ]


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
        found: dict[str, float] = {}
        for name, part in (("bed", off[self.on_bed, 2:]), ("lateral", off[:, :2]), ("", off)):
            size, stem = np.linalg.norm(part, axis=1), f"{name}_" if name else ""
            found |= {f"{stem}rms_mm": float(np.sqrt(np.mean(size**2))), f"{stem}worst_mm": float(size.max())}
        return FirmwareLeft(**{key: round(value, DECIMALS) for key, value in found.items()})  # as lines can hold it

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

        return described(least_squares(missed, np.zeros(len(names)), jac="3-point", xtol=1e-14).x)


def _not_carried(carried: Robot, mechanism: Machine, own: set[str]) -> list[str]:
    """Return in words which errors the machine has that are none of the firmware's parameters."""
    notes = []
    for p in mechanism.parameters:
        value = carried.errors.get(p.name, 0.0)
        if p.name not in own and abs(value) > NEGLIGIBLE:
            unit = "" if p.unit == "1" else f" {file_unit(p.unit)}"
            notes.append(f"{p.name} = {value / to_internal(p.unit):+.4f}{unit} ({p.meaning})")
    return notes


def firmware_values(robot: Robot) -> tuple[float, Array, Array, Array]:
    """Return radius, arms, angles [deg] and endstops, errors included."""
    e, g = robot.errors, robot.geometry
    arm, angle, endstop = (
        g[key] + np.array([e.get(f"{error}_{i}", 0.0) for i in (1, 2, 3)])
        for key, error in (("arm_length", "arm"), ("tower_angle", "angle"), ("endstop", "endstop"))
    )
    return float(g["radius"][0] + e.get("radius", 0.0)), arm, angle / DEG, endstop


def _changes(before: Robot, after: Robot) -> tuple[FirmwareValue, ...]:
    """Return each of the firmware's numbers as it is and as it is to be."""
    names = [
        ("radius", "mm"),
        *((f"{n} of {i}", u) for n, u in (("arm", "mm"), ("angle", "deg"), ("endstop", "mm")) for i in "abc"),
    ]
    old, new = (np.hstack(firmware_values(robot)).tolist() for robot in (before, after))
    return tuple(
        FirmwareValue(name=name, before=was, after=becomes, unit=unit)
        for (name, unit), was, becomes in zip(names, old, new, strict=True)
    )


def by_axis(axes: str, values: Array) -> str:
    """Return a letter with a number for each tower: ``X0.1000 Y0.0000 Z-0.2000``."""
    return " ".join(f"{axis}{value:.4f}" for axis, value in zip(axes, values.tolist(), strict=True))


def turned_towers(angle: Array) -> str:
    """Return by how much towers stand off their usual angles [deg]."""
    return by_axis("XYZ", angle - ANGLES)
