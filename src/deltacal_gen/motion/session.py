"""A recording in motion, made ready: derivatives, what the rigid machine asks of every joint, samples in motion."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from deltacal_gen.errors import ConstantReadings, UnusableURDF
from deltacal_gen.files.robot import kept_robot
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.bands import uncertainty_of
from deltacal_gen.motion.derivatives import motion
from deltacal_gen.motion.fit import Fit
from deltacal_gen.motion.joint import FEW, Joint, Series, series_of
from deltacal_gen.motion.lost import without_lost
from deltacal_gen.motion.payload import PayloadError, payload_error, torque_of
from deltacal_gen.motion.regression import GAP, LEAST_RUNS, PART, STRETCH
from deltacal_gen.motion.rigid import Rigid
from deltacal_gen.motion.trajectories import Motion, Trajectories
from deltacal_gen.physics.splines import LOOSE
from deltacal_gen.results.diagnosis import NextMeasurement
from deltacal_gen.results.motion import (
    JointModel,
    KnownMachine,
    Left,
    MotionNoise,
    PayloadState,
    TorqueTerm,
)
from deltacal_gen.results.parts import Derivatives, Source
from deltacal_gen.units import DEG

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

HELD_OUT = (
    f"whole runs, of a joint that moves in at least {LEAST_RUNS}; otherwise stretches of at least {STRETCH:g} s, with "
    f"{GAP:g} s on either side that no fit uses"
)
FILTER = "nothing: readings are fitted as recorded; figures through the filter are of readings and model both"
SLOPES = 300  # samples at which slopes are taken


@dataclass(frozen=True, eq=False)
class Session:
    """A recording in motion.

    Attributes
    ----------
    robot : Robot
    given : Trajectories
    motion : Motion
    rigid : Rigid
    joints : list of Joint
    payload : PayloadError, optional
        By which the payload differs from what is written.
    """

    robot: Robot
    given: Trajectories
    motion: Motion
    rigid: Rigid
    joints: list[Joint]
    payload: PayloadError | None = None

    @classmethod
    def of(cls, robot: Robot, given: Trajectories) -> Session:
        """Return a recording made ready, all bodies of the machine unknown; readings that were lost are left out."""
        rigid, found = Rigid(robot), motion(given)
        ready = cls(robot, given, found, rigid, [each.at() for each in series(robot, given, found, rigid)])
        kept = without_lost(given, ready.moving)
        return ready if kept is None else cls.of(robot, kept)

    def stated(self, payload: PayloadError | None = None) -> Session | None:
        """Return the same with what the robot file states of the machine's bodies, and a payload, as known.

        None where the file states nothing, or what is read tells no torque.
        """
        known = np.nan_to_num(self.rigid.dynamics.stated())
        if not known.any() or not all(read.forces for read in self.given.readouts):
            return None
        rigid = Rigid(self.robot, stated=True)
        every = series(self.robot, self.given, self.motion, rigid, payload)
        return dataclasses.replace(self, rigid=rigid, joints=[each.at() for each in every], payload=payload)

    def payload_by(self, fits: Sequence[Fit]) -> PayloadError | None:
        """Return the payload by which all drives together leave least beside each joint's own rungs, if one could."""
        return payload_error(self.rigid, np.nan_to_num(self.motion.states), self.given, fits)

    @property
    def moving(self) -> list[Joint]:
        """The joints of which there are samples enough, with readings that change.

        Raises
        ------
        InputError
            There are none.
        """
        moved = [joint for joint in self.joints if joint.moves]
        found = [joint for joint in moved if not joint.silent]
        if moved and not found:
            columns = ", ".join(self.given.columns[joint.number - 1] for joint in moved)
            raise ConstantReadings(
                f"joints move, and their readings never change: {columns}.",
                "Record there what the drives give.",
                file=self.given.path,
            )
        if not found:
            raise UnusableURDF(
                f"no joint moves for long enough: {self._most()}. Friction at rest is not known, and a part of what "
                "moves must be held out.",
                f"Record {LEAST_RUNS} runs or more, or one of at least ten seconds, in which joints move for {FEW} "
                f"samples at least{self._ends()}.",
                file=self.given.path,
            )
        return found

    def _most(self) -> str:
        """Return how much there is of the joint that moves most, in words."""
        most = max(self.joints, key=lambda joint: len(joint.rows))
        column = self.given.columns[most.number - 1]
        if most.unread:
            return f"{column} holds readings in fewer than {FEW} rows"
        count, each = len(most.rows), np.bincount(self.given.run[most.rows], minlength=1)
        runs = int((each > PART * count / max(int(np.count_nonzero(each)), 1)).sum())
        return (
            f"joint {most.number} does in {count} samples with a reading, {count * most.step:.2g} s in {runs} "
            f"run{'' if runs == 1 else 's'} long enough to count"
        )

    def _ends(self) -> str:
        """Return in words what of each run makes no derivatives."""
        if self.motion.cutoff is None:
            return ""
        return (
            f", beside the first and last {LOOSE / (2 * self.motion.cutoff):.2g} s of each, whose speeds are not known"
        )

    def rms(self, joint: Joint, residual: Array) -> float | None:
        """Return the rms of residuals of a joint, in the unit of its readings; None where there are none."""
        known = residual[np.isfinite(residual)]
        return float(np.sqrt(np.mean(known**2))) / joint.readout.inside if len(known) else None

    def each(self, fits: Sequence[Fit], value: Callable[[Fit], float | None]) -> tuple[float | None, ...]:
        """Return a figure of every joint; None of those without a fit."""
        known = {fit.joint.number: value(fit) for fit in fits}
        return tuple(known.get(joint.number) for joint in self.joints)

    def left(self, fits: Sequence[Fit], model: str | None = None) -> Left:
        """Return what fits leave."""
        train = self.each(fits, lambda f: self.rms(f.joint, f.left))
        held = self.each(fits, lambda f: self.rms(f.joint, f.held_out))
        filtered = self.each(
            fits, lambda f: self.rms(f.joint, f.joint.filtered(f.held_out, self.given.time, self.motion.cutoff))
        )
        declared = [sigma_said(self.given, f.joint.unit) for f in fits]
        chi2 = None
        if all(declared):
            free = sum(len(f.left) - len(f.coefficients) for f in fits)
            noises = [self.declared(f) or 1.0 for f in fits]
            parts = [np.sum((f.left / s) ** 2) for f, s in zip(fits, noises, strict=True)]
            chi2 = float(sum(parts)) / max(free, 1)
        return Left(
            model=model,
            train_rms=self.together(fits, lambda f: f.left),
            heldout_rms=self.together(fits, lambda f: f.held_out),
            train_rms_by_joint=train,
            heldout_rms_by_joint=held,
            heldout_rms_by_joint_filtered=filtered,
            unit_by_joint=self.given.units,
            chi2_per_dof=chi2,
        )

    def together(self, fits: Sequence[Fit], value: Callable[[Fit], Array]) -> float | None:
        """Return the rms over all joints, in their common unit; None where they have none."""
        if len({f.joint.unit for f in fits}) != 1:
            return None
        every = np.concatenate([value(f) / f.joint.readout.inside for f in fits])
        every = every[np.isfinite(every)]
        return float(np.sqrt(np.mean(every**2))) if len(every) else None

    def declared(self, fit: Fit) -> float | None:
        """Return the noise of a joint's readings as declared, with what its joints' own adds, in units inside."""
        said = sigma_said(self.given, fit.joint.unit)
        return None if said is None else float(np.hypot(said * fit.joint.readout.inside, self.of_joints(fit)))

    def of_joints(self, fit: Fit) -> float:
        """Return by how much noise of velocities and accelerations changes what a fit says (rms, in units inside).

        By the slopes of the rigid machine, at any joint, and of the effects at their own.
        """
        j = fit.joint.number - 1
        picked, states, inertia = self._some(fit)
        total = 0.0
        for order, name in ((1, "qd"), (2, "qdd")):
            for k, sigma in enumerate(self.motion.noise[order - 1]):
                sides = []
                for side in (sigma, -sigma):
                    moved = states.copy()
                    moved[order, :, k] += side
                    own = fit.of_effects(picked, {name: moved[order, :, j]}) if k == j else 0.0
                    sides.append(self.rigid.torque(moved, inertia)[:, j] + own)
                total += float(np.mean((sides[0] - sides[1]) ** 2)) / 4
        return float(np.sqrt(total))

    def of_geometry(self, fit: Fit) -> float | None:
        """Return what the robot file's tolerances change of a joint's torque, beside what a fit takes up of it (rms).

        None where there are none, or what is read is no torque.
        """
        known = {name: std for name, std in self.robot.tolerance.items() if std > 0}
        if not known or not fit.joint.readout.forces:
            return None
        j, sign = fit.joint.number - 1, self.robot.joint_sign
        picked, states, inertia = self._some(fit)
        slopes = self.rigid.dynamics.torque_by_errors(sign * states, inertia, list(known))[:, j] * list(known.values())
        columns = fit.joint.columns(fit.rungs, fit.load)[picked]
        columns = columns / np.maximum(np.linalg.norm(columns, axis=0), 1e-300)
        left = slopes - columns @ np.linalg.lstsq(columns, slopes, rcond=1e-9)[0]
        return float(np.sqrt(np.mean(np.sum(left**2, axis=1))))

    def _of_geometry_in_file(self, fit: Fit) -> float | None:
        of_geometry = self.of_geometry(fit)
        return None if of_geometry is None else of_geometry / fit.joint.readout.inside

    def _some(self, fit: Fit) -> tuple[slice, Array, Array]:
        """Return the samples at which slopes are taken, the states (3, m, n_q) there, and the bodies of a fit."""
        picked = slice(None, None, max(1, len(fit.joint.rows) // SLOPES))
        base, inertia = self.rigid.own[fit.joint.number - 1], self.rigid.known.copy()
        inertia[base.chosen] += fit.coefficients[: base.rank]
        return picked, self.motion.states[:, fit.joint.rows[picked]], inertia

    def noise(self, fits: Sequence[Fit]) -> MotionNoise:
        """Return the noise as declared, or what fits leave."""
        said = [sigma_said(self.given, unit) for unit in self.given.units]
        by_joint = self.each(fits, lambda f: said[f.joint.number - 1] or f.sigma / f.joint.readout.inside)
        known = [s for s in by_joint if s is not None]
        one = float(np.sqrt(np.mean(np.square(known)))) if len(set(self.given.units)) == 1 else None
        return MotionNoise(
            sigma=one,
            sigma_by_joint=by_joint,
            unit_by_joint=self.given.units,
            source=Source.DECLARED if any(said) else Source.RESIDUAL,
            of_joints_by_joint=self.each(fits, lambda f: self.of_joints(f) / f.joint.readout.inside),
            of_geometry_by_joint=self.each(fits, self._of_geometry_in_file),
            together_by_joint=self.each(fits, lambda f: f.together),
        )

    def answered(self, fits: Sequence[Fit]) -> dict[str, Any]:
        """Return the fields that all answers in motion have."""
        units = [DEG if unit == "rad" else 1.0 for unit in self.rigid.dynamics.joint_units]
        return {
            "kind": self.given.said.measurement.kind,
            "motion": Derivatives(
                cutoff_Hz=self.motion.cutoff,
                removed=self.motion.removed,
                text=self.motion.text,
                filter=FILTER,
                at_rest=tuple(joint.resting for joint in self.joints),
                at_rest_below=tuple(joint.threshold / by for joint, by in zip(self.joints, units, strict=True)),
                held_out=HELD_OUT,
                repairs=self.given.repairs,
            ),
            "inertial": self.rigid.names,
            "known": self._known(),
            "joints": tuple(self._model(fit) for fit in fits),
            "columns": self.given.columns,
            "robot": kept_robot(self.robot),
            "gross_errors": self.given.repaired,
        }

    def _known(self) -> KnownMachine | None:
        """Return what is taken as known of the machine; None where all of it is found."""
        if not self.rigid.known.any():
            return None
        errors = [] if self.payload is None else zip(self.payload.setups, self.payload.values, strict=True)
        carried = tuple(
            PayloadState(setup=setup, mass=float(mass), centre=tuple(float(c) for c in centre))
            for setup, (mass, *centre) in errors
        )
        return KnownMachine(inertial=tuple(float(v) for v in self.rigid.known), payloads=carried)

    def _model(self, fit: Fit) -> JointModel:
        base = self.rigid.own[fit.joint.number - 1]
        rigid, terms = fit.coefficients[: fit.joint.X.shape[1]], []
        at = len(rigid)
        for rung in fit.rungs:
            values = fit.coefficients[at : at + rung.width]
            terms.append(
                TorqueTerm(
                    effect=rung.effect,
                    constants=tuple(float(c) for c in rung.constants),
                    values=tuple(float(v) for v in values),
                )
            )
            at += rung.width
        return JointModel(
            joint=fit.joint.number,
            columns=tuple(int(k) for k in base.chosen),
            coefficients=tuple(float(v) for v in rigid[: base.rank]),
            payload=float(rigid[base.rank]) if len(rigid) > base.rank else None,
            terms=tuple(terms),
            at_rest_below=fit.joint.threshold,
            delay=None if fit.lag is None else fit.lag.delay,
            uncertainty=uncertainty_of(fit),
        )


def series(
    robot: Robot, given: Trajectories, found: Motion, rigid: Rigid, payload: PayloadError | None = None
) -> list[Series]:
    """Return all samples of each joint of a recording, beside what is known of the machine and its payload."""
    states = np.nan_to_num(found.states)
    known = rigid.torque(states, rigid.known)
    if payload is not None:
        known = known + torque_of(rigid, states, given, payload.setups, payload.values)
    return series_of(robot, given, found, rigid.asked(states), rigid.asked(rigid.as_lively(states)), known)


class Untold(NamedTuple):
    """Joints of which nothing can be said, by why: they move too little, are not read, or read the same throughout."""

    still: list[int]
    unread: list[int]
    silent: list[int]


def untold(session: Session, fits: Sequence[Fit]) -> Untold:
    """Return the joints without a fit."""
    fitted = {fit.joint.number for fit in fits}
    others = [joint for joint in session.joints if joint.number not in fitted]
    unread, read = ([j for j in others if j.unread is so] for so in (True, False))
    still, silent = ([j.number for j in read if j.moves is so] for so in (False, True))
    return Untold(still, [j.number for j in unread], silent)


def to_move(why: str, text: str) -> NextMeasurement:
    """Return that joints should be moved, over their ranges and at several speeds."""
    return NextMeasurement(why=why, text=text, poses=(), expected_chi2=None, run=("q", "qd"))


def still_to_move(session: Session, fits: Sequence[Fit]) -> tuple[NextMeasurement, ...]:
    """Return that joints should be moved which stood still, and read whose readings lack or never change."""
    still, unread, silent = (", ".join(map(str, some)) for some in untold(session, fits))
    found = []
    if still:
        text = f"Move joint {still}, both ways and at several speeds, in runs of ten seconds at least."
        found.append(to_move("joints stood still", text))
    if unread:
        text = f"Record what the drive of joint {unread} gives: its cells are blank."
        found.append(NextMeasurement(why="readings are missing", text=text, poses=(), expected_chi2=None))
    if silent:
        text = f"Record what the drive of joint {silent} gives, if it has one: it moves, and its reading never changes."
        found.append(NextMeasurement(why="readings never change", text=text, poses=(), expected_chi2=None))
    return tuple(found)


def sigma_said(given: Trajectories, unit: str) -> float | None:
    """Return the noise that a sidecar declares for readings in a unit."""
    found: float | None = getattr(given.said.measurement, f"sigma_{unit}")
    return found
