"""The one estimation problem: exact readings of a machine with errors, seen by an instrument with unknowns."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from deltacal_gen.errors import ImpossiblePose, MissingKey
from deltacal_gen.instrument.kind import Instrument, Readings
from deltacal_gen.instrument.kinds import measured_points, readings
from deltacal_gen.machine.answers import Sensitivity
from deltacal_gen.machine.registry import Array, Machine, mechanism_of
from deltacal_gen.machine.values import Recording, Robot
from deltacal_gen.physics.body import Body, follows
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.deformed import Deformed
from deltacal_gen.physics.following import following
from deltacal_gen.physics.motion import with_motion
from deltacal_gen.physics.reading import following_shift, reading_shift, shift_follows
from deltacal_gen.physics.terms import Term, of_reading

ROUNDING = 1e-9  # of the largest column of an effect: less is no effect at all


class Linearised(NamedTuple):
    """Residuals and Jacobians of all readings at one state; rows (R, k), NaN where a component was not read."""

    residual: Array
    J_p: Array
    J_m: Array


class State(NamedTuple):
    """A machine with given parameters and an instrument: where an iteration stands."""

    errors: Array
    instrument: Instrument
    machine: Deformed


@dataclass(frozen=True, eq=False)
class Problem:
    """A robot, its readings, and which parameters are free.

    The vector of parameters holds all source errors of the mechanism, then the coefficients of the effects on it.

    Attributes
    ----------
    names : tuple of str
        Free source errors; the coefficients of `terms` are free too.
    scale : (n,) array
        Ordinary size of each free parameter, or the standard deviation of its prior [mm, rad, N, s, K].
    reference : (n_p,) array
        Source errors of the robot file, from which the free ones depart, then zeros [mm, rad].
    body : Body
        The robot at the rows of the recording.
    terms : tuple of Term
        Effects on the machine whose coefficients are free.
    held : tuple of Term
        Effects on it that stay as they are.
    held_std : tuple of (rows, n_c) array
        Standard deviation about zero of each held coefficient, where they are as unknown as free ones; none where they
        are known.
    """

    robot: Robot
    mechanism: Machine
    recording: Recording
    readings: Readings
    names: tuple[str, ...]
    scale: Array
    reference: Array
    body: Body
    terms: tuple[Term, ...] = ()
    held: tuple[Term, ...] = ()
    held_std: tuple[Array, ...] = ()

    @property
    def columns(self) -> list[int]:
        """Index of each free parameter in the vector of parameters."""
        n_p = len(self.mechanism.parameters)
        return [self.mechanism.index[n] for n in self.names] + list(range(n_p, len(self.reference)))

    def coefficients(self, i: int) -> list[int]:
        """Return the places of an effect's coefficients among the free parameters."""
        start = len(self.names) + sum(t.n_coefficients for t in self.terms[:i])
        return list(range(start, start + self.terms[i].n_coefficients))

    def split(self, parameters: Array) -> tuple[Array, tuple[Term, ...]]:
        """Return source errors (n_p,) and the free effects with their coefficients."""
        n = len(self.mechanism.parameters)
        errors, rest = parameters[:n], parameters[n:]
        if not self.terms:
            return errors, ()
        ends = np.cumsum([t.n_coefficients for t in self.terms])
        parts = np.split(rest, ends[:-1])
        return errors, tuple(t.with_values(v) for t, v in zip(self.terms, parts, strict=True))

    def acting(self, parameters: Array) -> tuple[Term, ...]:
        """Return all effects on the machine with their coefficients, the free ones first."""
        return (*self.split(parameters)[1], *self.held)

    def solve(self, parameters: Array, near: Deformed | None = None) -> Deformed:
        """Return the machine in equilibrium at all rows; `near` is a machine that differs little.

        Raises
        ------
        InputError
            A row that readings refer to has no pose: out of reach or singular.
        """
        machine, status = self.body.solve(*self.split(parameters), near, self.held)
        if not self.readings.kind.sees_joints:
            self.body.check(machine, status, self.readings.used, self.recording)
        return machine._replace(x=np.where(np.isfinite(machine.x), machine.x, 0.0))

    def seen(self, machine: Deformed) -> Array:
        """Return what instruments look at: the platform's poses (N, 12), or how far the joints have moved (N, n_q)."""
        return self.body.theta(machine.q, machine.rows) if self.readings.kind.sees_joints else machine.x

    def poses(self, parameters: Array) -> Array:
        """Return what instruments look at in all rows, exactly: the platform's poses (N, 12), or joints; see `seen`."""
        return self.seen(self.solve(parameters))

    def residual(self, parameters: Array, instrument: Instrument, x: Array) -> Array:
        """Return measured minus predicted (R, k), effects on the reading included [mm, rad]."""
        instrument = instrument.mounted(self.mechanism, parameters)
        r = instrument.residual(self.readings, x)
        if terms := of_reading(self.acting(parameters)):
            values, _ = instrument.predict(self.readings, x)
            r[:, : values.shape[1]] -= reading_shift(terms, self.body, self.readings, values, x)[0]
        return r

    def linearise(self, parameters: Array, instrument: Instrument, machine: Deformed | None = None) -> Linearised:
        """Return residuals and Jacobians at a vector of parameters and an instrument's state."""
        machine = self.solve(parameters) if machine is None else machine
        _, terms = self.split(parameters)
        used, x = self.readings.used, self.seen(machine)
        sensitivity = self.sensitivity(machine, used)
        if not np.isfinite(sensitivity.parameters).all():
            row = int(used[~np.isfinite(sensitivity.parameters).all(axis=(1, 2))][0])
            raise ImpossiblePose(
                "at these joints the machine is singular.",
                "Remove the row.",
                file=self.recording.path,
                line=int(self.recording.line[row]),
            )
        mounted = instrument.mounted(self.mechanism, parameters)
        dx, own = self._moved(terms, machine, used, sensitivity)
        J, J_m = self._read(parameters, mounted, x, dx)
        del sensitivity, dx  # the largest arrays of a fit: the memory serves what comes next
        J_p = J if own is None else np.take(J, own, axis=2)
        mounted.add_carried(J_p, self.mechanism, self.names, self.readings, x)
        if terms:
            values, _ = mounted.predict(self.readings, x)
            shifted = reading_shift(terms, self.body, self.readings, values, x)[1]
            J_p[:, : values.shape[1], len(self.names) :] += shifted
        return Linearised(self.residual(parameters, instrument, x), J_p, J_m)

    @property
    def gives_way(self) -> bool:
        """Whether effects on the machine follow its pose, as what bends under a load does, and readings see it."""
        bend = (t for t in (*self.terms, *self.held) if t.kernels.ACTS_ON != "reading")
        return not self.readings.kind.sees_joints and any(map(follows, bend))

    def followed(self, parameters: Array, instrument: Instrument, machine: Deformed) -> Array:
        """Return by how much the derivatives (R, k, n) of a machine that gives way are others than at fixed loads.

        A soft machine's loads follow it; see `deltacal_gen.physics.following`.
        """
        errors, terms = self.split(parameters)
        instrument = instrument.mounted(self.mechanism, parameters)
        dx = following(self.body, errors, terms, self.held, machine, self.names)
        return self._read(parameters, instrument, self.seen(machine), dx)[0]

    def _read(self, parameters: Array, mounted: Instrument, x: Array, dx: Array) -> tuple[Array, Array]:
        """Return the derivatives (R, k, n) of the readings by what moves machines at x by dx (N, n_x, n).

        Beside them those (R, k, n_m) by the instrument's unknowns. What effects add to readings follows both.
        """
        J, J_m = mounted.linearise(self.readings, x, dx)
        if terms := [t for t in self.acting(parameters) if shift_follows(t)]:
            values, _ = mounted.predict(self.readings, x)
            by_values, by_place = following_shift(terms, self.body, self.readings, values, x)
            k, point = values.shape[1], dx[self.readings.rows[:, 0], :3]
            J[:, :k] += by_values @ J[:, :k] + by_place @ point
            J_m[:, :k] += by_values @ J_m[:, :k]
        return J, J_m

    def sensitivity(self, machine: Deformed, used: np.ndarray) -> Sensitivity:
        """Return the derivatives of what instruments look at, the platform's pose or the joints, in some rows."""
        if self.readings.kind.sees_joints:
            return self.mechanism.joint_sensitivity(len(used))
        return self.body.sensitivity(machine, used)

    def _moved(
        self, terms: Sequence[Term], machine: Deformed, used: np.ndarray, sensitivity: Sensitivity
    ) -> tuple[Array, list[int] | None]:
        """Return derivatives (N, n_x, n) of what instruments look at, in the rows `used`, and which of them are free.

        None stands for all, in their order.
        """
        own, every, dx = [self.mechanism.index[name] for name in self.names], len(machine.q), sensitivity.parameters
        if 2 * len(own) < dx.shape[2]:  # else the rows of the readings, which are fewer, are chosen from
            own, dx = list(range(len(own))), np.take(dx, own, axis=2)
        if len(used) < every:
            dx = _at_rows(dx, used, every)
        n_p = dx.shape[2]
        if terms:
            dx = np.concatenate([dx, self.effect_columns(terms, machine, used, sensitivity)], axis=2)
        own += range(n_p, dx.shape[2])
        return dx, None if own == list(range(dx.shape[2])) else own

    def displacements(self, machine: Deformed) -> Array:
        """Return the derivatives (N, n_x, limbs + 3) of the pose by each joint and by a shift along each axis of {O}.

        Where joints are looked at, nothing else moves: the shifts are zero.
        """
        used, limbs = np.unique(self.readings.rows), self.mechanism.limbs
        S = self.sensitivity(machine, used)
        dx = np.zeros((len(machine.x), S.joints.shape[1], limbs + 3))
        dx[used, :, :limbs] = S.joints
        if not self.readings.kind.sees_joints:
            dx[used, :3, limbs:] = np.eye(3)
        return dx

    def effect_columns(
        self, terms: Sequence[Term], machine: Deformed, used: np.ndarray, sensitivity: Sensitivity
    ) -> Array:
        """Return the derivatives (N, n_x, n_c) of the platform coordinates by the coefficients of effects."""
        return self.body.columns(terms, machine, sensitivity, used)

    def term_columns(
        self, terms: Sequence[Term], parameters: Array, instrument: Instrument, machine: Deformed
    ) -> Array:
        """Return the derivatives (R, k, n_c) of the readings by the coefficients of effects, free or not."""
        instrument = instrument.mounted(self.mechanism, parameters)
        used, x = self.readings.used, self.seen(machine)
        S = self.sensitivity(machine, used)
        J, _ = instrument.linearise(self.readings, x, self.effect_columns(terms, machine, used, S))
        values, _ = instrument.predict(self.readings, x)
        J[:, : values.shape[1]] += reading_shift(terms, self.body, self.readings, values, x)[1]
        return J

    def borne(self, terms: Sequence[Term]) -> np.ndarray:
        """Tell which coefficients (n_c,) of effects move anything on the machine as drawn.

        A load that only errors of geometry bring about is the product of two small things: whatever it moves, a
        compliance that no machine has would have to make of it.
        """
        out, loaded = [np.ones(t.n_coefficients, dtype=bool) for t in terms], dict[str, list[int]]()
        for i, term in enumerate(terms):
            if any(s.kind == "load" for s in term.states):
                loaded.setdefault(term.effect, []).append(i)
        if not loaded:
            return np.concatenate([np.ones(0, dtype=bool), *out])
        machine, _ = self.body.solve(np.zeros(len(self.mechanism.parameters)), ())
        machine, used = machine._replace(x=np.nan_to_num(machine.x)), self.readings.used
        sensitivity = self.sensitivity(machine, used)
        for forms in loaded.values():
            columns = self.effect_columns([terms[i] for i in forms], machine, used, sensitivity)
            size = np.sqrt(np.nansum(columns**2, axis=(0, 1)))
            parts = np.split(size > ROUNDING * size.max(), np.cumsum([terms[i].n_coefficients for i in forms])[:-1])
            for i, own in zip(forms, parts, strict=True):
                out[i] = own
        return np.concatenate(out)

    def begin(self, parameters: Array, machine: Deformed | None = None) -> Instrument:
        """Return the instrument's first state for a machine with `parameters`."""
        x = self.poses(parameters) if machine is None else self.seen(machine)
        return self.readings.kind.start(self.readings, self.recording, self.robot, x)

    def subset(self, chosen: np.ndarray) -> Problem:
        """Return the problem with these readings only."""
        return dataclasses.replace(self, readings=self.readings.subset(chosen))

    def some(self, most: int, rng: np.random.Generator) -> Problem:
        """Return the problem with some of its poses where they are more, in their order: all readings of each."""
        found, body = self.readings, self.body
        groups = np.unique(found.group)
        if len(groups) <= most:
            return self
        drawn = rng.choice(groups, most, replace=False)
        part = found.subset(np.flatnonzero(np.isin(found.group, drawn)))
        rows = part.used
        _, group = np.unique(part.group, return_inverse=True)
        return dataclasses.replace(
            self,
            recording=self.recording.subset(rows),
            readings=dataclasses.replace(part, rows=np.searchsorted(rows, part.rows), group=group),
            body=Body(body.robot, body.mechanism, body.q[rows], body.tool[rows], body.channels.subset(rows)),
        )

    def with_tool(self, tool: Array) -> Problem:
        """Return the problem with other measured points (N, 3) of the platform."""
        b = self.body
        return dataclasses.replace(self, body=Body(b.robot, b.mechanism, b.q, tool, b.channels))

    def with_names(self, names: Sequence[str]) -> Problem:
        """Return the problem with other free source errors, in their ordinary scale, and only the effects held."""
        index = [self.mechanism.index[n] for n in names]
        return dataclasses.replace(
            self,
            names=tuple(names),
            scale=self.mechanism.typical[index],
            reference=self.reference[: len(self.mechanism.parameters)],
            terms=(),
        )

    def with_terms(self, terms: Sequence[Term], scale: Array) -> Problem:
        """Return the problem with free effects; `scale` (n_c,) is the size that their coefficients may well have."""
        n_p, n = len(self.mechanism.parameters), len(self.names)
        return dataclasses.replace(
            self,
            terms=tuple(terms),
            reference=np.concatenate([self.reference[:n_p], np.zeros(len(scale))]),
            scale=np.concatenate([self.scale[:n], scale]),
        )


def _at_rows(values: Array, rows: np.ndarray, every: int) -> Array:
    """Return values (n, ...) as those of some of so many rows, others zero."""
    out = np.zeros((every, *values.shape[1:]))
    out[rows] = values
    return out


def pose_problem(
    robot: Robot,
    recording: Recording,
    names: Sequence[str],
    *,
    as_distance: bool = False,
    found: Readings | None = None,
    held: Sequence[Term] = (),
) -> Problem:
    """Return the estimation problem of a recording for a set of free source errors; `held` effects stay as they are."""
    mechanism = mechanism_of(robot)
    found = readings(recording, as_distance=as_distance) if found is None else found
    if not robot.drawn and not found.kind.sees_joints:
        raise MissingKey(
            f"there is no table [geometry], which readings of the kind '{found.kind.name}' need.",
            "Add the machine's dimensions from its drawing; readings of joints do without.",
            file=robot.source,
        )
    recording = dataclasses.replace(with_motion(recording), begun=recording.origin)  # so of rows that come after it
    tool = measured_points(robot, recording)
    q = robot.joint_sign * recording.joints
    return Problem(
        robot=robot,
        mechanism=mechanism,
        recording=recording,
        readings=found,
        names=tuple(names),
        scale=mechanism.typical[[mechanism.index[n] for n in names]],
        reference=mechanism.vector(robot.errors),
        body=Body(robot, mechanism, q, tool, Channels.of(recording, robot)),
        held=tuple(held),
    )
