"""Compensators: the joint commands that bring the machine as it is to where the drawing would have it.

Two kinds. *exact* is the inverse position of the calibrated machine; where a diagnosis found effects on it, of the
machine in static equilibrium with them, at the payload, temperature, time and direction of approach of each command.
*linear* is Bai 2015, eqs. (23) and (25): the nominal joints, and the change that keeps the reference point in place to
first order when the errors appear. What it leaves is of second order in the errors, and encoder offsets leave nothing:
it takes them away exactly, and evaluates the rest at the angles the geometry then sees.

Geometry alone also runs as a compiled function of one pose (`Compensator.servo`); `deltacal_gen.use.exporters`
write C99 and tables for the controller.

References
----------
Bai, Mei, Huang, Chetwynd 2015, Proc. IMechE C 230(3), section 4.
"""

from __future__ import annotations

import dataclasses
import hashlib
import itertools
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np

from deltacal_gen.errors import MissingChannel, NotForThisMachine, OptionNotApplicable, OutOfReach, UnknownName
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.accuracy import turned, workspace_of
from deltacal_gen.machine.answers import result
from deltacal_gen.machine.registry import (
    SOLVED,
    STATUS,
    Array,
    Machine,
    mechanism_of,
    nominal_joints,
)
from deltacal_gen.machine.rotation import about_z
from deltacal_gen.machine.values import Workspace
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.channels import Channels, complete_channels
from deltacal_gen.physics.deformed import Deformed
from deltacal_gen.physics.law import is_law
from deltacal_gen.physics.ranges import outside
from deltacal_gen.physics.terms import Term, kept_term, of_the_instrument, remembers
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.result import Result
from deltacal_gen.units import file_unit, to_internal

TURNED_DEG = 1e-6  # a rotation of an open chain that a command leaves by more than this is told
_RANDOM_POINTS = 2000
_SEED = 20150  # of the random points: the same machine always gets the same statement
_NAMED = 5  # targets a message names before it counts the rest


class CompensatorKind(StrEnum):
    """How a command is found; see above."""

    EXACT = "exact"
    LINEAR = "linear"


class RoundTrip(NamedTuple):
    """What commands leave over the workspace: the worst error [mm] at `points` targets, `missed` of them unsolved."""

    worst_mm: float
    points: int
    missed: int


class Servo(NamedTuple):
    """A compensator of one pose, for a compiled loop or for single calls from Python; see `Compensator.servo`."""

    command: Callable[..., tuple[float, ...]]
    state: Array

    def direct(self) -> Callable[..., tuple[float, ...]]:
        """Return `command` of this state as a built-in function of numbers, for a loop in Python.

        ``q1, q2, q3 = servo.direct()(x, y, z)`` takes half of the time: Numba does not look at the arguments.
        """
        from deltacal_kernels.direct import direct  # which builds on Numba

        command: Callable[..., tuple[float, ...]] = direct(self.command, self.state)
        return command


@dataclass(frozen=True, eq=False, init=False)
class Compensator:
    """Corrected joint commands for a calibrated machine.

    Parameters
    ----------
    robot : Robot, Result or Diagnosis
        The calibrated machine: the geometry that the controller computes with, and the errors found. Of a diagnosis
        its effects are known too.
    kind : {"exact", "linear"}
        Inverse position of the calibrated machine, or eq. (23) of Bai 2015; with errors of the position model only
        (its first group), eq. (23) is eq. (25).
    terms : sequence of Term
        Effects that a diagnosis found. Those of the instrument are no matter of the machine: see `effects`.
    begun : float
        From when these count the time [s]; see `Recording.origin`.
    corrected : bool
        Whether the answer has a smooth correction as well, which is in no command of a compensator alone.

    Raises
    ------
    UsageError
        There is no such kind, or the linear one is asked to know effects.
    """

    robot: Robot
    kind: CompensatorKind = CompensatorKind.EXACT
    terms: Sequence[Term] = ()
    begun: float = 0.0
    corrected: bool = False

    def __init__(
        self,
        robot: Robot | Result | Diagnosis,
        kind: str = "exact",
        terms: Sequence[Term] = (),
        begun: float = 0.0,
        corrected: bool = False,
    ) -> None:
        if not isinstance(robot, Robot):
            from deltacal_gen.use.prediction import calibrated_robot, known_effects  # the fit's own modules: not always

            terms, begun, corrected = terms or known_effects(robot), robot.begun_s, robot.correction is not None
            robot = calibrated_robot(robot)
        if kind not in [*CompensatorKind]:
            raise UnknownName(f"there is no compensator '{kind}'; there are {' and '.join(CompensatorKind)}.")
        own = robot, CompensatorKind(kind), terms, begun, corrected
        for field, value in zip(dataclasses.fields(self), own, strict=True):
            object.__setattr__(self, field.name, value)
        if self.kind is CompensatorKind.LINEAR and self.effects:
            named = ", ".join(t.effect for t in self.effects)
            raise OptionNotApplicable(f"the linear compensator knows geometry only, not {named}. Use the exact one.")

    def __repr__(self) -> str:
        known = ", ".join(["geometry", *(t.effect for t in self.effects)])
        return f"<Compensator of '{self.robot.name}', {self.kind}: {known}>"

    @cached_property
    def effects(self) -> tuple[Term, ...]:
        """The effects that move the machine; one that only changes what is read asks for no other command."""
        return tuple(t for t in self.terms if not of_the_instrument(t.effect))

    @cached_property
    def instrument(self) -> tuple[Term, ...]:
        """The effects that belong to the instrument, which no command undoes."""
        return tuple(t for t in self.terms if of_the_instrument(t.effect))

    @cached_property
    def mechanism(self) -> Machine:
        """The kernels of the machine."""
        return mechanism_of(self.robot)

    @cached_property
    def nominal(self) -> Robot:
        """The machine an uncompensated controller believes in; a tool point that no file says is where it was found."""
        known = {name: self.robot.errors[name] for name in self.robot.unsaid if name in self.robot.errors}
        return replace(self.robot, errors=known)

    @cached_property
    def found_point(self) -> str | None:
        """In words of which point targets are, where readings have found it and no file says it; else None."""
        sits = [self.nominal.errors.get(name, 0.0) for name in self.robot.unsaid]
        if not any(sits):
            return None
        place = f"({', '.join(f'{value:.3g}' for value in sits)}) mm, as tool counts in a robot file"
        return f"targets are of the point that was measured, found at {place}: this one has none"

    @cached_property
    def model(self) -> str:
        """Smallest model that has all errors of the robot; the mechanism's full one where none has."""
        models, errors = self.mechanism.models, {name for name, value in self.robot.errors.items() if value}
        fitting = [name for name in models if errors <= set(models[name])]
        return min(fitting, key=lambda name: len(models[name]), default=self.mechanism.full_model)

    @cached_property
    def digest(self) -> str:
        """Fingerprint of every number that a command depends on, but the target."""
        numbers = (self._rows, self.robot.tool, self.robot.joint_sign)
        text = self.kind.encode() + b"".join(np.ascontiguousarray(n, dtype="<f8").tobytes() for n in numbers)
        if self.effects:
            masses = dataclasses.asdict(self.robot.masses) if self.robot.masses is not None else None
            text += json.dumps([masses, *(kept_term(t).to_dict() for t in self.effects)]).encode()
        return hashlib.sha256(text).hexdigest()[:16]

    @cached_property
    def _rows(self) -> Array:
        return self.mechanism.rows(self.robot)

    @cached_property
    def _drawn(self) -> Array:
        return self.mechanism.rows(self.nominal)

    @property
    def _kernels(self) -> Any:
        return self.mechanism.servo

    @cached_property
    def _constants(self) -> Array:
        """What no target changes, as the C source reads it."""
        if self.kind is CompensatorKind.LINEAR:
            return np.asarray(self._kernels.linear_constants(self._rows))
        return self.mechanism.constants(self._rows)

    @cached_property
    def _state(self) -> Array:
        """The machine as the kernels of one command read it, and room for their scratch: every call takes a copy."""
        state = getattr(self._kernels, f"{self.kind}_state")
        return np.asarray(state(self._rows[0], self.robot.tool, self.robot.joint_sign))

    def servo(self, *, change: bool = False) -> Servo:
        """Return the compensator of one pose, for a loop that Numba compiles and for calls from Python.

        Parameters
        ----------
        change : bool
            For a controller that has the nominal joints of a target already: return what eq. (23) adds to them.

        Returns
        -------
        Servo
            ``q1, q2, q3 = command(x, y, z, state)`` from a target [mm], as the controller counts joints [rad or mm],
            and with `change` ``d1, d2, d3 = command(x, y, z, q1, q2, q3, state)``; NaN where there is no command; of
            one joint a number, and no tuple. What a platform turns on command stands behind the position, as the
            components of its Cayley vector: along the axis, 2 tan(angle / 2) long; `state` comes last.
            Numbers in and out: an array, or a part of one, would cost more than the command. `state` is the machine
            and scratch, for `command` alone: one per thread.

        Notes
        -----
        With `targets` (N, 3) and `q` (N, 3)::

            command, state = Compensator(robot).servo()

            @njit
            def loop(targets, state, q):
                for n in range(len(targets)):
                    q[n, 0], q[n, 1], q[n, 2] = command(targets[n, 0], targets[n, 1], targets[n, 2], state)

        Raises
        ------
        UsageError
            The machine has effects, which this function does not know; or the change is asked of the exact compensator.
        """
        if change and self.kind is not CompensatorKind.LINEAR:
            raise OptionNotApplicable(
                f"the {self.kind} compensator has no change to nominal joints; the linear one has."
            )
        self.needs_loops("compiled function")
        if self.effects:
            raise OptionNotApplicable(
                "the compiled function knows geometry only; export C or a table for a machine with "
                + ", ".join(t.effect for t in self.effects)
                + "."
            )
        command = getattr(self._kernels, "linear_change" if change else f"{self.kind}_command")
        return Servo(command, self._kernels.copied(self._state))

    def channels(self, columns: Mapping[str, Array | float], n: int) -> tuple[Channels, list[str]]:
        """Return what the effects read beside the target, for n commands, and in words what had to be assumed.

        Parameters
        ----------
        columns : mapping of (n,) arrays or numbers
            By the names of a recording's channels, in their units: ``temp_C, payload_kg, time_s, approach1`` ...
        """
        given = {name: np.broadcast_to(np.asarray(v, dtype=float), (n,)) for name, v in columns.items()}
        shape = (n, self.mechanism.limbs)
        at, assumed = complete_channels(given, shape, self.robot, self.mechanism.joint_unit, self.effects)
        if at.get("time") is not None:
            at = replace(at, begun=self.begun)
        said = [f"{t.effect} belongs to the instrument: no command is changed for it" for t in self.instrument]
        return at, said + assumed

    @property
    def remembers(self) -> bool:
        """Whether a command depends on those before it: an effect remembers how the machine came where it is."""
        return any(remembers(term.kernels) for term in self.effects)

    def needs_no_past(self, what: str) -> None:
        """Raise UsageError where an effect remembers: what is exported knows one target at a time."""
        if late := dict.fromkeys(term.effect for term in self.effects if remembers(term.kernels)):
            raise NotForThisMachine(
                f"{', '.join(late)}: there is no {what} of what remembers how the machine came to a target. Write the "
                "joints of your targets, which say time_s: deltacal compensate RESULT TARGETS -o JOINTS."
            )

    def needs_loops(self, what: str) -> None:
        """Raise UsageError for a machine without an inverse in closed form to be written out."""
        if not self.mechanism.written_out:
            raise NotForThisMachine(
                f"there is no {what} for {self.mechanism.sort}: how it stands is part of every command. "
                "Give targets: joints, or x_mm ... rz_deg, and their commands come as a table."
            )

    def command(
        self,
        targets: Array,
        tool: Array | None = None,
        channels: Channels | None = None,
        near: Array | None = None,
        *,
        out: Array | None = None,
    ) -> tuple[Array, np.ndarray]:
        """Return corrected joint commands.

        Parameters
        ----------
        targets : (N, 3) array
            Where the reference point is wanted, in {O} [mm]; of a machine that turns on command poses
            (N, 12) too, rotations row by row.
        tool : (3,) or (N, 3) array, optional
            Reference point in {O'} [mm]; default the robot's.
        channels : Channels, optional
            Payload, temperature and so on of each command; see `channels`, whose assumptions are the default.
        near : (N, n_q) array, optional
            Of an open chain, joints at which it stands nominally, as the controller counts; default those of
            `nominal_command`.
        out : (N, n_q) array, optional
            Where the joints are written.

        Returns
        -------
        joints : (N, n_q) array
            As the controller counts them [rad or mm]; NaN where not solved.
        status : (N,) int array
            SOLVED, UNREACHABLE or SINGULAR of `deltacal_gen.machine.registry`, explained in its `STATUS`.
        """
        targets, tool = self._targets(targets, tool)
        joints = result(out, (len(targets), self.mechanism.limbs))
        if np.may_share_memory(targets, joints):  # joints in place of their targets, which are still read
            targets = targets.copy()
        start, status = self._start(targets, tool, near)
        if self.kind is CompensatorKind.EXACT:

            def reach(q: Array, some: np.ndarray) -> tuple[Deformed, np.ndarray]:
                return self._machine(q, tool[some], None if channels is None else channels.subset(some))[1:]

            with_effects = reach if self.effects else None
            how = self._rows, self._drawn, with_effects
            q, found = self.mechanism.follow(targets, start, tool, *how, together=self.remembers, out=joints)
        elif start is None:
            q, found, state = joints, np.empty(len(targets), dtype=np.int64), self._kernels.copied(self._state)
            self._kernels.linear_commands(self.mechanism.stated(targets), tool, state, q, found)
        else:
            q, found = self._to_first_order(start, tool), np.full(len(targets), SOLVED)
        status = found if status is None else np.where(status == SOLVED, found, status)
        np.multiply(q, self.robot.joint_sign, out=joints)
        joints[status != SOLVED] = np.nan
        return joints, status

    def _start(self, targets: Array, tool: Array, near: Array | None) -> tuple[Array | None, np.ndarray | None]:
        """Return joints (N, n_q) to start from, where the machine stands in many ways, and how they were found."""
        if not self.mechanism.many_ways:
            return None, None
        status = None
        if near is None:
            near, status = self.nominal_command(targets, tool)
        return np.nan_to_num(near) * self.robot.joint_sign, status

    def _to_first_order(self, start: Array, tool: Array) -> Array:
        """Return joints (N, n_q) that undo at `start`, to first order, what the errors move."""
        x, _ = self.mechanism.forward(start, tool, self._drawn)
        by_errors = self.mechanism.sensitivity(x, start, tool, self._drawn).parameters
        moved = by_errors @ self.mechanism.vector(self.robot.errors)
        return start + self.mechanism.undo(moved, x, start, tool, self._drawn)

    def _machine(self, q: Array, tool: Array, channels: Channels | None) -> tuple[Body, Deformed, np.ndarray]:
        """Return the machine in equilibrium with its effects at joints (N, n_q) as the geometry counts them."""
        at = self.channels({}, len(q))[0] if channels is None else channels
        effects = self.effects
        if at.get("time") is None:  # drift is taken from its start, a jump as past, and nothing as remembered
            run = np.arange(len(q)) if self.remembers else at.run
            at = replace(at.with_values(time=np.zeros(len(q))), run=run)
            effects = tuple(t.afterwards() for t in effects)
        body = Body(self.robot, self.mechanism, q, tool, at)
        for term in effects:
            if why := body.missing(term):
                raise MissingChannel(f"the effect '{term.effect}' needs {why}.", "Add it.", file=self.robot.source)
        return body, *body.solve(self.mechanism.vector(self.robot.errors), effects)

    def beyond_laws(self, joints: Array, tool: Array | None = None, channels: Channels | None = None) -> np.ndarray:
        """Return which commands (N,), as `joints` gives them, lie outside the range in which a law was found."""
        if not any(is_law(t.effect) for t in self.effects):
            return np.zeros(len(joints), dtype=bool)
        body, machine, _ = self._machine(joints * self.robot.joint_sign, self._tool(tool, len(joints)), channels)
        return outside(body, machine, self.effects)

    def joints(
        self,
        targets: Array,
        tool: Array | None = None,
        channels: Channels | None = None,
        near: Array | None = None,
    ) -> Array:
        """Return corrected joint commands (N, n_q) [rad or mm], all of them within the joints' limits.

        Raises
        ------
        NoSolutionError
            A target is out of reach, singular, or asks a joint beyond its limits; the message names the first ones.
        """
        targets, tool = self._targets(targets, tool)
        joints, status = self.command(targets, tool, channels, near)
        beyond = self.beyond_limits(joints)
        if failed := np.flatnonzero((status != SOLVED) | beyond.any(axis=1)).tolist():
            named = [self._flaw(n, targets[n], joints[n], status[n], beyond[n]) for n in failed[:_NAMED]]
            more = [f"and {len(failed) - _NAMED} more"] if len(failed) > _NAMED else []
            raise OutOfReach(
                "\n  ".join([f"{len(failed)} of {len(targets)} targets have no joint command:", *named, *more])
                + "\nMove them into the workspace, or leave them out."
            )
        return joints

    def beyond_limits(self, joints: Array) -> np.ndarray:
        """Tell which commands (N, n_q) lie beyond the robot's joint limits; none where it states no limits."""
        if self.robot.joint_limits is None:
            return np.zeros(np.shape(joints), dtype=bool)
        lower, upper = self.robot.joint_limits.T
        return np.asarray((joints < lower) | (joints > upper))

    def nominal_command(self, targets: Array, tool: Array | None = None) -> tuple[Array, np.ndarray]:
        """Return what the uncompensated controller commands, like `command`."""
        targets, tool = self._targets(targets, tool)
        q, status = nominal_joints(self.robot, targets, tool)
        return q * self.robot.joint_sign, status

    def reached(
        self, joints: Array, tool: Array | None = None, channels: Channels | None = None
    ) -> tuple[Array, np.ndarray]:
        """Return where the calibrated machine really goes, (N, 3) [mm], and the status (N,), at joint commands."""
        x, status = self.pose(joints, tool, channels)
        return x[:, :3], status

    def pose(
        self, joints: Array, tool: Array | None = None, channels: Channels | None = None
    ) -> tuple[Array, np.ndarray]:
        """Return the pose (N, 12) that the calibrated machine really has, and the status (N,), at joint commands."""
        q = np.asarray(joints, dtype=float) * self.robot.joint_sign
        tool = self._tool(tool, len(q))
        if self.effects:
            _, machine, status = self._machine(q, tool, channels)
            return machine.x, status
        return self.mechanism.forward(q, tool, self._rows)

    def leftover(self, targets: Array, tool: Array | None = None, channels: Channels | None = None) -> Array:
        """Return the position error (N, n_q) [mm] that the compensated machine has left; NaN where not solved."""
        targets, tool = self._targets(targets, tool)
        return self.missed(self.command(targets, tool, channels)[0], targets, tool, channels)

    def missed(
        self, joints: Array, targets: Array, tool: Array | None = None, channels: Channels | None = None
    ) -> Array:
        """Return how far commands lead off their targets, (N, n_q) [mm]: along the coordinates that are commanded.

        Of an open chain (N, 3), or (N, 6) with the rotation [rad] where the targets are poses.
        """
        x, _ = self.pose(joints, tool, channels)
        return self.mechanism.missed(x, np.asarray(targets, dtype=float))

    def round_trip(self) -> RoundTrip:
        """Return what the commands leave over the robot's workspace.

        Raises
        ------
        InputError
            The robot file gives no workspace.
        NoSolutionError
            The machine reaches no point of it.
        """
        targets = turned(self.robot, workspace_points(workspace_of(self.robot)))
        error = np.linalg.norm(self.leftover(targets), axis=1)
        if np.isnan(error).all():
            raise OutOfReach(
                "no point of the workspace is within the machine's reach. "
                "Check [workspace] and the lengths in [geometry]; top is counted from the base plane."
            )
        return RoundTrip(largest(error), len(targets), int(np.isnan(error).sum()))

    def _targets(self, targets: Array, tool: Array | None) -> tuple[Array, Array]:
        targets = self.mechanism.targets(targets)
        return targets, self._tool(tool, len(targets))

    def _tool(self, tool: Array | None, n: int) -> Array:
        """Return reference points (n, 3) in {O'}, the robot's own by default."""
        given = np.asarray(self.robot.tool if tool is None else tool, dtype=float)
        return np.ascontiguousarray(np.broadcast_to(given, (n, 3)))

    def _flaw(self, n: int, target: Array, joints: Array, status: int, beyond: np.ndarray) -> str:
        where = f"target {n + 1} ({', '.join(f'{v:g}' for v in target[:3])} mm)"
        if status != SOLVED:
            return f"{where}: {STATUS[int(status)]}"
        limits = self.robot.joint_limits
        assert limits is not None  # or nothing would be beyond them
        i = int(np.flatnonzero(beyond)[0])
        unit = self.mechanism.joint_units[i]
        value, lower, upper = (v / to_internal(unit) for v in (joints[i], *limits[i]))
        allowed = f"its limits are {lower:g} to {upper:g} {file_unit(unit)}"
        return f"{where}: joint {i + 1} would go to {value:.4f}, but {allowed}"


def largest(errors: Array) -> float:
    """Return the largest error that is a number; 0 where none is."""
    return float(np.nan_to_num(errors).max(initial=0.0))


def workspace_points(space: Workspace) -> Array:
    """Return points of a workspace, (N, 3) [mm].

    Random ones; then its axis, and circles on the rim and half way, or a row, in three layers.
    """
    rng = np.random.default_rng(_SEED)
    n, layers = _RANDOM_POINTS, (0.0, 0.5, 1.0)
    if space.radius is None:
        x = (space.width or 0.0) * np.concatenate([rng.uniform(-0.5, 0.5, n), np.tile(np.linspace(-0.5, 0.5, 25), 3)])
        return space.place(x, np.concatenate([rng.random(n), np.repeat(layers, 25)]))
    r, turn = space.radius * np.sqrt(rng.random(n)), 2 * np.pi * rng.random(n)
    circles = itertools.product((space.radius, space.radius / 2), np.radians(np.arange(0, 360, 15)), layers)
    axis = [(0.0, 0.0, layer) for layer in layers]
    r, turn, part = np.vstack([np.column_stack([r, turn, rng.random(n)]), list(circles), axis]).T
    return space.place(about_z(r, turn), part)
