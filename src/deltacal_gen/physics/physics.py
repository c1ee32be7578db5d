"""Physics beyond geometry: effects on a machine, as exact deformation and as columns for a fit.

An effect's own formulas are generated from ``derive/effects``; here its state is put together (joints, channels of the
recording, loads from virtual work at the deformed pose) and its targets are led through the machine's derivatives by
the chain rule. A machine with compliant parts is solved to its static equilibrium: loads at the pose, deformation by
the loads, pose again, until nothing moves.
"""

from __future__ import annotations

import dataclasses
import importlib
import itertools
from collections.abc import Container, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from types import ModuleType
from typing import NamedTuple

import deltacal_kernels.effects
import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.instrument.readings import Readings
from deltacal_gen.machine.registry import SOLVED, STATUS, UNBALANCED, Array, Machine, Sensitivity
from deltacal_gen.machine.rotation import cayley_matrix
from deltacal_gen.machine.values import TEMPERATURE, Recording, Robot
from deltacal_gen.physics import states
from deltacal_gen.physics.memory import Along, along
from deltacal_gen.physics.states import CHANNELS, State
from deltacal_gen.results.parts import TermState
from deltacal_gen.units import joint_factors, of_joints, of_sliding

EQUILIBRIUM_STEPS = 25
EQUILIBRIUM_DONE = 1e-9  # mm and rad: change of the pose that the next step would bring
EQUILIBRIUM_LEFT = 1e-6  # mm and rad: change of the pose by the last step, above which there is no equilibrium
STEP_S = 1e-3  # of the second difference that gives the accelerations of the weights
AXES = ("x", "y", "z")
Point = tuple[float, float, float]


def effect_names() -> tuple[str, ...]:
    """Return the names of all registered effects."""
    return tuple(deltacal_kernels.effects.EFFECTS)


@cache
def load_effect(name: str) -> ModuleType:
    """Return the generated module of an effect: its tables, `value` and `jacobian`."""
    return importlib.import_module(f"deltacal_kernels.effects.{name}")


@dataclass(frozen=True)
class Term:
    """An effect with its coefficients on a machine.

    Attributes
    ----------
    effect : str
    limbs : tuple of int
        Limbs (from 1) that have it; empty for an effect of the whole machine.
    constants : tuple of float
        Found by search: the order of a harmonic, the time of a jump.
    values : (limbs, tools or 1, n_c) array
        Coefficients [mm, rad, N, s, K].
    tools : tuple of (x, y, z)
        Tool points [mm] that have it, of an effect that displaces measured points.
    """

    effect: str
    limbs: tuple[int, ...]
    values: Array
    constants: tuple[float, ...] = ()
    tools: tuple[Point, ...] = ()

    @property
    def kernels(self) -> ModuleType:
        """The effect's generated module."""
        return load_effect(self.effect)

    @property
    def states(self) -> tuple[State, ...]:
        """What the effect reads, in the order of its kernels' input."""
        return states.read_by(self.kernels)

    @property
    def n_coefficients(self) -> int:
        """Number of coefficients, all limbs together."""
        return int(self.values.size)

    def with_values(self, flat: Array) -> Term:
        """Return the term with other coefficients (n_coefficients,)."""
        return dataclasses.replace(self, values=np.asarray(flat, dtype=float).reshape(self.values.shape))

    def constant(self, name: str) -> float:
        """Return a constant by name."""
        return self.constants[[key for key, *_ in self.kernels.CONSTANTS].index(name)]

    def afterwards(self) -> Term:
        """Return the effect as it acts after the recording in which it was found: a jump is past."""
        past, names = self.kernels.AFTERWARDS, [key for key, *_ in self.kernels.CONSTANTS]
        constants = tuple(past.get(key, value) for key, value in zip(names, self.constants, strict=True))
        return dataclasses.replace(self, constants=constants)


def blank(
    effect: str, limbs: Sequence[int], constants: Sequence[float] = (), tools: Sequence[Sequence[float]] = ()
) -> Term:
    """Return a term with all coefficients zero."""
    kernels = load_effect(effect)
    own = tuple(limbs) if kernels.PER_LIMB else ()
    points = tuple((float(x), float(y), float(z)) for x, y, z in tools) if displaces_points(kernels) else ()
    values = np.zeros((max(len(own), len(points), 1), len(kernels.COEFFICIENTS)))
    return Term(effect, own, values, tuple(constants), points)


def remembers(kernels: ModuleType) -> bool:
    """Tell whether an effect has memories along a run."""
    return hasattr(kernels, "MEMORY")


def displaces_points(kernels: ModuleType) -> bool:
    """Tell whether an effect acts tool point by tool point."""
    return "points" in kernels.SEARCHED


@dataclass(frozen=True, eq=False)
class Channels:
    """What a recording says beside joints and readings, row by row.

    Attributes
    ----------
    values : mapping of (N, n_q) or (N,) arrays
        By the names of states, joints as the geometry counts them [rad/s, rad/s^2, 1, degC, K, kg, s]; covariates by
        their columns, as recorded. What the recording does not say is not there.
    order : (N,) array
        The place of each row where there is no time.
    run : (N,) array of int, optional
        Which rows are one uninterrupted movement: the column ``run``, or a set-up; None: all.
    """

    values: Mapping[str, Array]
    order: Array
    run: np.ndarray | None = None

    def get(self, name: str) -> Array | None:
        """Return a channel, None where the recording says nothing of it; one that is optional is then nowhere."""
        found = self.values.get(name)
        if found is None and states.named(name).optional:
            return np.zeros(len(self.order))
        return found

    @property
    def payload(self) -> Array:
        """The payload of each row (N,) [kg]."""
        found = self.get("payload")
        assert found is not None  # it is optional
        return found

    @property
    def clock(self) -> Array:
        """The time of each row (N,) [s]; its place where there is no time."""
        time = self.get("time")
        return self.order if time is None else time

    def subset(self, rows: np.ndarray) -> Channels:
        """Return the channels at these rows."""
        run = None if self.run is None else self.run[rows]
        return Channels({name: v[rows] for name, v in self.values.items()}, self.order[rows], run)

    def with_values(self, **values: Array) -> Channels:
        """Return the channels with others, or other ones."""
        return dataclasses.replace(self, values={**self.values, **values})

    @staticmethod
    def of(recording: Recording, robot: Robot) -> Channels:
        """Read the channels of a recording; joint channels are turned as the geometry counts."""
        found = Channels.from_columns(recording.channels, recording.joints.shape, robot, recording.joint_unit)
        label = found.values.get("run", np.zeros(len(recording.joints)))
        _, run = np.unique(np.column_stack([recording.setup, label]), axis=0, return_inverse=True)
        return dataclasses.replace(found, run=run)

    @staticmethod
    def from_columns(
        columns: Mapping[str, Array], shape: tuple[int, ...], robot: Robot, joint_unit: str = "rad"
    ) -> Channels:
        """Read channels from columns (N,) as files name them; `shape` is (N, n_q)."""
        rows, n = shape
        own = {"temp_C": _temperature(columns)}
        values, known = {}, set()
        for s in CHANNELS:
            names = s.columns(joint_unit, n)
            known |= set(names)
            found = [own.get(name, columns.get(name)) for name in names]
            given = [f - s.zero for f in found if f is not None]
            if len(given) < len(names):
                continue
            values[s.name] = given[0]
            if s.per == "joint":
                factors = joint_factors(joint_unit, n) if "{unit}" in s.column else [1.0] * n
                each = zip(factors, robot.joint_sign, given, strict=True)
                values[s.name] = np.column_stack([c * sign * f for c, sign, f in each])
        values |= {name: column for name, column in columns.items() if name not in known}
        return Channels(values, np.arange(rows, dtype=float))


def _temperature(columns: Mapping[str, Array]) -> Array | None:
    """Return the machine's temperature [degC]: `temp_C` or, where parts have thermometers instead, their mean."""
    parts = [v for name, v in sorted(columns.items()) if TEMPERATURE.fullmatch(name)]
    return columns.get("temp_C", np.mean(parts, axis=0) if parts else None)


def complete_channels(
    columns: Mapping[str, Array], shape: tuple[int, int], robot: Robot, joint_unit: str, terms: Sequence[Term]
) -> tuple[Channels, list[str]]:
    """Return channels that lack nothing but perhaps the time, and in words what was assumed for which effects.

    Parameters
    ----------
    columns : mapping of (N,) arrays
        By the names of a recording's channels, in their units; nan where not given.
    shape : (N, n_q)

    Raises
    ------
    InputError
        Some rows have a time and some have none.
    """
    n, limbs = shape
    have = Channels.from_columns(columns, shape, robot, joint_unit)
    values, said = dict(have.values), []
    assuming = [s for s in states.STATES.values() if s.assumed]
    for (column, assumed), found in itertools.groupby(assuming, key=lambda s: (s.column, s.assumed)):
        own = tuple(found)
        read = next(c for c in CHANNELS if c.column == column)
        given = have.values.get(read.name, np.full((n, limbs) if read.per == "joint" else n, np.nan))
        blank = np.isnan(given).reshape(n, -1).any(axis=1)
        for s in own:
            if read.whole and blank.all():
                values.pop(s.name, None)
            elif not s.since:
                values[s.name] = np.nan_to_num(values.get(s.name, np.full(given.shape, np.nan)), nan=s.default - s.zero)
        users = [t.effect for t in terms if {s.base for s in own} & {c.base for s in t.states for c in s.channels}]
        if not users or not blank.any():
            continue
        names = read.columns(joint_unit, limbs)
        name = f"{names[0]} ... {names[-1]}" if len(names) > 1 else names[0]
        where = "not given" if blank.all() else f"blank in {blank.sum()} of {n} rows"
        said.append(f"{name} {where}: {assumed} ({', '.join(users)})")
        if read.whole and not blank.all():
            raise InputError(
                "some rows have a time and some have none.",
                "Fill in all cells, or leave the column out.",
                column=column,
            )
    return Channels(values, have.order, have.run), said


class Deformed(NamedTuple):
    """A machine moved by effects: what the kernels read.

    Attributes
    ----------
    x, q, tool, rows : (N, 12), (N, n_q), (N, 3), (1 or N, limbs, n_p) arrays
    restless : (N,) array of int, optional
        At rows without static equilibrium the joint, from 1, that is thrown back and forth; 0 elsewhere.
    """

    x: Array
    q: Array
    tool: Array
    rows: Array
    restless: np.ndarray | None = None


class Body:
    """A robot at the rows of a recording, with what an effect may read of it.

    Parameters
    ----------
    robot, mechanism : Robot, Machine
    q : (N, n_q) array
        Reported joints as the geometry counts them.
    tool : (N, 3) array
    channels : Channels
    """

    def __init__(self, robot: Robot, mechanism: Machine, q: Array, tool: Array, channels: Channels) -> None:
        self.robot, self.mechanism, self.q, self.tool, self.channels = robot, mechanism, q, tool, channels
        self.roles, self._moves = mechanism.roles(robot), mechanism.moves(robot)
        masses = robot.masses.model_dump() if robot.masses is not None else {}
        self.gravity = np.asarray(masses.pop("gravity", (0.0, 0.0, -9.81)), dtype=float)
        self._held: tuple[tuple[int, ...], tuple[Term, ...], dict[str, Array]] | None = None
        self.inertia = masses.pop("proximal_inertia", None)
        self.masses: dict[str, float] = {k: v for k, v in masses.items() if v is not None}

    def missing(self, effect: str) -> str | None:
        """Return what an effect needs that is not there, in words; None where nothing is."""
        if why := self.foreign(effect):
            return why
        read = states.read_by(load_effect(effect))
        if without := [s.requires for s in read if s.requires and not self._able(s)]:
            return without[0]
        channels = [c for s in read if not s.since for c in s.channels]
        channels += [states.named("time")] if remembers(load_effect(effect)) else []
        for channel in dict.fromkeys(channels):
            names = channel.columns(self.mechanism.joint_unit, self.q.shape[1])
            words = f"column{'s' if len(names) > 1 else ''} {', '.join(names)}"
            value = self._channel(channel)
            if value is None:
                return f"the {words}"
            if np.isnan(value).any():
                return f"every cell of the {words} (some are blank)"
        return None

    def _able(self, state: State) -> bool:
        """Tell whether the robot file says what a state requires."""
        return self.robot.masses is not None if state.kind == "load" else self._turn() is not None

    def _channel(self, state: State) -> Array | None:
        """Return a channel: of a joint (N, n_q), of another limb's joint or of the machine (N,)."""
        value = self.channels.get(state.base)
        return value[:, state.joint - 1] if value is not None and state.joint else value

    def foreign(self, effect: str) -> str | None:
        """Return the part that an effect moves or reads and this mechanism does not have; None where it has all."""
        parts = lacking(effect, self.mechanism, self._moves, self.roles)
        return f"a machine that has a part {parts[0]}; {self.mechanism.name} has none" if parts else None

    # ----------------------------------------------------------------------------------------------------- the state

    def state(self, names: Sequence[str], x: Array, q: Array, rows: Array) -> dict[str, Array]:
        """Return what effects read of the machine, by name, at a solved pose.

        Parameters
        ----------
        names : sequence of str
            Not those of a reading.
        x, q, rows : (N, 12), (N, n_q), (1 or N, limbs, n_p) arrays
            Pose, joints as the geometry sees them, and parameters; read by states that follow the pose only.

        Returns
        -------
        dict of (N, limbs) or (N,) arrays
            Of each limb's own, or of the machine and of another limb's joint.
        """
        found: dict[str, Array | None] = {}
        wanted = tuple(map(states.named, names))
        own = {s.base for s in wanted}
        for s in wanted:
            if s.kind == "channel":
                found[s.base] = self.channels.get(s.base)
            elif s.kind == "geometry" and s.base in self.roles:
                found[s.base] = np.broadcast_to(self.roles[s.base], self.q.shape)
        if "q" in own:
            found["q"] = self.q
        if "turn" in own:
            found["turn"] = self._turn()
        if "theta" in own:
            offsets = self._moves["offset"].items()
            found["theta"] = q + sum(much * rows[:, :, self.mechanism.column(name)] for name, much in offsets)
        if loads := {s.base for s in wanted if s.kind == "load"}:
            found |= self._loads(loads, x, q, rows)
        if any(s.kind == "place" for s in wanted):
            found |= dict(zip(AXES, x[:, :3].T, strict=True)) | {"radius": np.hypot(x[:, 0], x[:, 1])}
        return {s.name: v[:, s.joint - 1] if s.joint else v for s in wanted if (v := found.get(s.base)) is not None}

    def _loads(self, wanted: set[str], x: Array, q: Array, rows: Array) -> dict[str, Array]:
        """Return what the weights exert at a pose, by the names of states, `wanted` among them."""
        payload = self.channels.payload
        out: dict[str, Array] = {}
        if wanted - {"payload_torque", "inertia_torque"}:
            total = self.mechanism.loads(x, q, self.tool, rows, self.masses, self.gravity, payload)
            out |= {"torque": total.torque, "moment_x": total.moment[:, 0], "moment_y": total.moment[:, 1]}
            # a closure may stand for both rods
            out |= {"tension_1": total.tension[:, :, 0], "tension_2": total.tension[:, :, -1]}
            names_d = self.mechanism.deflections
            out |= {f"pull_{a}": total.pull[:, :, names_d.index(f"tip_{a}")] for a in "vw" if f"tip_{a}" in names_d}
        if "payload_torque" in wanted:
            out["payload_torque"] = self.mechanism.loads(x, q, self.tool, rows, {}, self.gravity, payload).torque
        acceleration = self.channels.get("qdd")
        if "inertia_torque" in wanted and acceleration is not None:
            out["inertia_torque"] = self._inertia(x, q, rows, acceleration)
        return out

    def _turn(self) -> Array | None:
        """Return the turn of each joint (N, n_q) [rad]; of a sliding one, that of the pulley which drives its belt.

        None where all joints slide and nothing says how far a pulley takes them; among turning ones such a joint has no
        turn, 0.
        """
        have, slides = self.robot.transmission, np.array([u == "mm" for u in self.mechanism.joint_units])
        around = have.pulley_circumference if have is not None else None
        if slides.all() and around is None:
            return None
        return np.where(slides, self.q * (0.0 if around is None else 2 * np.pi / around), self.q)

    def _inertia(self, x: Array, q: Array, rows: Array, acceleration: Array) -> Array:
        """Return the torque (N, n_q) of all masses times minus their acceleration [N mm].

        Accelerations are second differences of the exact positions along the motion; the arm's inertia about its own
        centre of mass turns with the joint.
        """
        speed = self.channels.get("qd")
        speed = np.zeros_like(q) if speed is None else speed
        at = []
        for t in (-STEP_S, 0.0, STEP_S):
            moved = q + speed * t + acceleration * t**2 / 2
            pose, _ = self.mechanism.forward(moved, self.tool, rows, near=x)
            at.append(self.mechanism.weights_at(pose, moved, self.tool, rows, self.masses))
        fields = -(at[0] - 2 * at[1] + at[2]) / STEP_S**2 / 1000.0  # mm/s^2 -> m/s^2
        loads = self.mechanism.loads(x, q, self.tool, rows, self.masses, fields, self.channels.payload)
        own = self.mechanism.limb_inertia(self.robot, self.masses) if self.inertia is None else self.inertia
        return loads.torque - own * acceleration / 1000.0  # kg mm^2/s^2 = 1e-3 N mm

    # ------------------------------------------------------------------------------------------------ deformation

    def _inputs(self, term: Term, state: Mapping[str, Array]) -> Array:
        """Return the term's state as the kernels read it, (N * limbs, n_s), or (N, n_s) for targets of the machine.

        Memories come last.
        """
        read = self._read(term, state)
        return np.hstack([read, self._remembered(term, read).value]) if remembers(term.kernels) else read

    def _remembered(self, term: Term, read: Array) -> Along:
        """Return the memories of a term at the rows of its state; NaN where they do not settle."""
        N, c = len(self.q), self._coefficients(term)
        time, run = self.channels.get("time"), self.channels.run
        assert time is not None  # see `missing`
        limbs = len(read) // N
        own = [i - 1 for i in term.limbs] or list(range(limbs))  # others have no coefficients
        given = np.broadcast_to(c, (len(read), c.shape[1])).reshape(N, limbs, -1)
        run = np.zeros(N, dtype=np.int64) if run is None else run
        found = along(term.kernels, read.reshape(N, limbs, -1)[:, own], given[:, own], term.constants, time, run)

        def of_all(values: Array) -> Array:
            every = np.zeros((N, limbs, *values.shape[2:]), dtype=values.dtype)
            every[:, own] = values
            return every.reshape(len(read), *values.shape[2:])

        value = np.where(found.settled[:, :, None], found.value, np.nan)
        return Along(*map(of_all, (value, found.by_coefficients, found.bound, found.settled)))

    def _derivatives(self, term: Term, read: Array, coefficients: Array) -> Array:
        """Return the derivatives of what a term moves by its coefficients, (M, n_t, n_c), through memories too."""
        kernels = term.kernels
        if not remembers(kernels):
            return np.asarray(kernels.jacobian(read, coefficients, term.constants))
        found = self._remembered(term, read)
        s = np.hstack([read, found.value])
        by_memory = kernels.by_memory(s, coefficients, term.constants)
        return np.asarray(kernels.jacobian(s, coefficients, term.constants) + by_memory @ found.by_coefficients)

    def _read(self, term: Term, state: Mapping[str, Array]) -> Array:
        """Return the states that a term reads, memories not among them."""
        by_limb = _by_limb(term)
        N, limbs = self.q.shape
        columns = []
        for s in term.states:
            value = self._since(term, s) if s.since else state[s.name]
            if by_limb and value.ndim == 1:
                value = np.repeat(value[:, None], limbs, axis=1)
            if not by_limb and value.ndim == 2:  # a length of all limbs
                value = value.mean(axis=1)
            columns.append(value.ravel() if by_limb else value)
        size = N * limbs if by_limb else N
        return np.column_stack(columns) if columns else np.zeros((size, 0))

    def _since(self, term: Term, state: State) -> Array:
        """Return which rows (N,) come after a moment, 1 or 0."""
        return (self.channels.clock >= term.constant(state.since)).astype(float)

    def _coefficients(self, term: Term) -> Array:
        """Return the coefficients as the kernels read them: (N * limbs, n_c), zero where a limb has none."""
        N, limbs = self.q.shape
        if term.tools:
            return sum(self.uses(t)[:, None] * v for t, v in zip(term.tools, term.values, strict=True))
        if not _by_limb(term):
            return term.values
        c = np.zeros((limbs, term.values.shape[1]))
        if term.limbs:
            c[[i - 1 for i in term.limbs]] = term.values
        else:
            c[:] = term.values
        return np.tile(c, (N, 1))

    def moved(self, terms: Sequence[Term], state: Mapping[str, Array]) -> dict[str, Array]:
        """Return the displacement of every target: (N, limbs) of a limb, (N,) of the machine."""
        N, limbs = self.q.shape
        out: dict[str, Array] = {}
        for term in terms:
            kernels = term.kernels
            values = kernels.value(self._inputs(term, state), self._coefficients(term), term.constants)
            for j, target in enumerate(kernels.TARGETS):
                value = values[:, j].reshape(N, limbs) if _by_limb(term) else values[:, j]
                out[target] = out[target] + value if target in out else value
        return out

    def uses(self, tool: Sequence[float]) -> np.ndarray:
        """Return which rows (N,) measure a tool point."""
        mask: np.ndarray = np.linalg.norm(self.tool - np.asarray(tool), axis=1) < 1e-6
        return mask

    def solve(
        self, errors: Array, terms: Sequence[Term], near: Array | None = None, held: tuple[Term, ...] = ()
    ) -> tuple[Deformed, np.ndarray]:
        """Return the machine in static equilibrium with all effects on it, and the status (N,) of each row.

        Parameters
        ----------
        errors : (n_p,) array
            Source errors [mm, rad].
        near : (N, 12) array, optional
            Where to start.
        held : tuple of Term
            Effects beside `terms` that do not change from call to call.
        """
        mechanism = self.mechanism
        plain = mechanism.rows(self.robot, errors)
        terms, held = (tuple(t for t in some if t.kernels.ACTS_ON != "reading") for some in (terms, held))
        # joints as reported and channels do not change with the pose
        terms, held = (*terms, *(t for t in held if _follows(t))), tuple(t for t in held if not _follows(t))
        key = tuple(map(id, held))
        if self._held is None or self._held[0] != key:
            self._held = key, held, self._steady(held, plain)
        unchanged = _together(self._held[2], self._steady([t for t in terms if not _follows(t)], plain))
        varying = [t for t in terms if _follows(t)]
        names = _read_by(varying)
        if not (terms or held) or near is None:
            x, status = mechanism.forward(self.q, self.tool, plain, near)
            if not (terms or held):
                return Deformed(x, self.q, self.tool, plain), status
            ok = status == SOLVED
        else:
            x, ok = near, np.isfinite(near).all(axis=1)
        q, rows, tool, before = self.q, plain, self.tool, 0.0
        shift: dict[str, Array] = {}
        restless = None
        for _ in range(EQUILIBRIUM_STEPS):
            safe = np.where(ok[:, None], x, 0.0)
            earlier, shift = shift, _together(unchanged, self.moved(varying, self.state(names, safe, q, rows)))
            q = self.q + shift.get("joint", 0.0)
            rows = self._rows(errors, shift)
            tool = self.tool + np.column_stack([np.broadcast_to(shift.get(f"tool.{a}", 0.0), len(x)) for a in AXES])
            last = x
            x, status = mechanism.forward(q, tool, rows, near=safe)
            ok = status == SOLVED
            step = float(np.max(np.abs((x - last)[ok]), initial=0.0))
            # what follows the pose changes by a small part of what it moves: steps shrink by a steady factor
            if not varying or step * (min(step / before, 1.0) if before else 1.0) < EQUILIBRIUM_DONE:
                break
            before = step
        else:
            left = ok & (np.abs(x - last).max(axis=1) > EQUILIBRIUM_LEFT)
            restless = np.where(left, _restless(earlier, shift, len(x)), 0)
            x, status = np.where(left[:, None], np.nan, x), np.where(left, UNBALANCED, status)
        turn = np.column_stack([np.broadcast_to(shift.get(f"turn.{a}", 0.0), len(x)) for a in AXES])
        if turn.any():
            x = x.copy()
            x[:, :3] += np.cross(turn, x[:, :3])
            x[:, 3:] = (cayley_matrix(turn) @ x[:, 3:].reshape(-1, 3, 3)).reshape(-1, 9)
        return Deformed(x, q, tool, rows, restless), status

    def _steady(self, terms: Sequence[Term], rows: Array) -> dict[str, Array]:
        """Return the displacement of every target by effects of the reported joints and of channels alone."""
        if not terms:
            return {}
        return self.moved(terms, self.state(_read_by(terms), np.zeros((len(self.q), 12)), self.q, rows))

    def _rows(self, errors: Array, shift: Mapping[str, Array]) -> Array:
        parts = {t[5:]: v for t, v in shift.items() if t.startswith("limb.")}
        base = self.mechanism.rows(self.robot, errors)
        if not parts:
            return base
        rows = np.repeat(base, len(self.q), axis=0)
        for part, value in parts.items():
            for name, much in self._moves[part].items():
                rows[:, :, self.mechanism.column(name)] += much * value
        return rows

    # ---------------------------------------------------------------------------------------------------- columns

    def columns(self, terms: Sequence[Term], body: Deformed, sensitivity: Sensitivity, chosen: np.ndarray) -> Array:
        """Return derivatives of the platform coordinates by all coefficients, (N, n_x, n_c), at fixed loads.

        Parameters
        ----------
        sensitivity : Sensitivity
            Of the rows `chosen`; other rows are zero.
        """
        (N, limbs), n_x = self.q.shape, self.mechanism.n_x
        out, start = np.zeros((N, n_x, sum(t.n_coefficients for t in terms))), 0
        if not terms:
            return out
        state = self.state(_read_by(terms), np.nan_to_num(body.x), body.q, body.rows)
        for _, group in itertools.groupby(terms, key=lambda t: (t.effect, t.limbs)):
            forms = list(group)
            kernels, count = forms[0].kernels, sum(t.n_coefficients for t in forms)
            part = out[:, :, start : start + count]
            start += count
            if not _by_limb(forms[0]):
                part[:] = np.concatenate([self._machine_columns(t, state, body, n_x, chosen) for t in forms], axis=2)
                continue
            same = None if any(s.since for s in forms[0].states) else self._read(forms[0], state)
            D = np.array(
                [
                    self._derivatives(
                        t,
                        self._read(t, state) if same is None else same,
                        self._coefficients(t) if t.values.any() else t.values[:1],
                    )
                    for t in forms
                ]
            )
            D = D.reshape(len(forms), N, limbs, len(kernels.TARGETS), -1)[:, chosen]
            moved = np.zeros((len(chosen), n_x, len(forms), limbs, D.shape[-1]))
            for j, target in enumerate(kernels.TARGETS):
                S = sensitivity.joints if target == "joint" else self._along(sensitivity, target[5:])
                moved += S[:, :, None, :, None] * np.moveaxis(D[:, :, :, j], 0, 1)[:, None]
            own = [i - 1 for i in forms[0].limbs]
            part[chosen] = (moved[:, :, :, own] if own else moved.sum(axis=3)).reshape(len(chosen), n_x, -1)
        return out

    def _along(self, sensitivity: Sensitivity, part: str) -> Array:
        """Return the derivatives of the pose by what an effect moves in a limb, (n, n_x, limbs)."""
        every = np.concatenate([sensitivity.own, sensitivity.common, sensitivity.deflections], axis=3)
        first = len(self.mechanism.geometry)
        out = np.zeros(every.shape[:3])
        for name, much in self._moves[part].items():
            out += much * every[..., self.mechanism.column(name) - first]
        return out

    def _machine_columns(
        self, term: Term, state: Mapping[str, Array], body: Deformed, n_x: int, chosen: np.ndarray
    ) -> Array:
        kernels = term.kernels
        out = np.zeros((len(self.q), n_x, term.n_coefficients))
        if kernels.ACTS_ON == "reading":
            return out
        D = self._derivatives(term, self._read(term, state), self._coefficients(term))
        for j, target in enumerate(kernels.TARGETS):
            axis = AXES.index(target[-1])
            unit = np.eye(3)[axis]
            if target.startswith("turn."):
                step = np.hstack([np.cross(unit, body.x[:, :3]), np.tile(unit, (len(out), 1))])
            else:
                step = np.zeros((len(out), n_x))
                step[:, :3] = np.nan_to_num(body.x[:, 3:]).reshape(-1, 3, 3)[:, :, axis]
            moved = step[:, :, None] * D[:, None, j, :]
            if term.tools:
                moved = np.concatenate([np.where(self.uses(t)[:, None, None], moved, 0.0) for t in term.tools], axis=2)
            out += moved
        keep = np.zeros(len(out), dtype=bool)
        keep[chosen] = True
        out[~keep] = 0.0
        return out

    def check(self, machine: Deformed, status: np.ndarray, used: np.ndarray, recording: Recording) -> None:
        """Raise an InputError that names the first row of `used` without a pose."""
        bad = used[status[used] != SOLVED]
        if len(bad):
            joint = 0 if machine.restless is None else int(machine.restless[bad[0]])
            raise InputError(
                f"at these joints the machine is {STATUS[int(status[bad[0]])]}"
                + (f", joint {joint} first" if joint else "")
                + (f" (and at {len(bad) - 1} more rows)." if len(bad) > 1 else "."),
                "Make the effect's jump smaller, or a slope of it."
                if joint
                else "Check the joint columns, their signs and units, and the robot's lengths.",
                file=recording.path,
                line=int(recording.line[bad[0]]),
            )


def lacking(effect: str, mechanism: Machine, moves: Container[str], roles: Container[str]) -> list[str]:
    """Return what an effect moves or reads of a machine and a mechanism does not have.

    Parameters
    ----------
    moves, roles : container of str
        Parts and lengths by which effects find their place in the mechanism.
    """
    kernels = load_effect(effect)
    read = states.read_by(kernels)
    parts = [t[5:] for t in kernels.TARGETS if t.startswith("limb.") and t[5:] not in moves]
    parts += sorted(s.name for s in read if s.kind == "geometry" and s.name not in roles)
    if any(s.base == "theta" for s in read) and "offset" not in moves:
        parts.append("angle of a joint")
    if any(s.kind == "load" for s in read) and not mechanism.weighs:
        parts.append("weights")
    if "height" in kernels.TARGETS and "z" not in mechanism.axes:
        parts.append("heights")
    parts += [f"joint {s.joint}" for s in read if s.joint > mechanism.limbs]
    return parts


def _by_limb(term: Term) -> bool:
    """Tell whether an effect moves limbs, whose own states it then reads."""
    return bool(term.kernels.ACTS_ON == "limb")


def _follows(term: Term) -> bool:
    """Tell whether an effect reads what changes with the pose."""
    return any(s.follows for s in term.states)


def _restless(earlier: Mapping[str, Array], shift: Mapping[str, Array], rows: int) -> np.ndarray:
    """Return the joint (N,), from 1, of which two steps move something differently by most; 0 where none does."""
    changes = [np.abs(v - earlier[target]) for target, v in shift.items() if v.ndim == 2 and target in earlier]
    parts = [change / most for change in changes if (most := change.max(initial=0.0)) > 0.0]
    return 1 + np.sum(parts, axis=0).argmax(axis=1) if parts else np.zeros(rows, dtype=np.int64)


def _together(a: Mapping[str, Array], b: Mapping[str, Array]) -> dict[str, Array]:
    """Return the sum of displacements, target by target."""
    out = dict(a)
    for target, value in b.items():
        out[target] = out[target] + value if target in out else value
    return out


def of_reading(terms: Sequence[Term]) -> tuple[Term, ...]:
    """Return the effects that act on the reading itself."""
    return tuple(t for t in terms if t.kernels.ACTS_ON == "reading")


def of_the_instrument(effect: str) -> bool:
    """Tell whether what an effect moves is only read, or where: no command undoes it."""
    return load_effect(effect).ACTS_ON in ("point", "reading")


def _read_by(terms: Sequence[Term]) -> list[str]:
    """Return what effects read of the machine at each pose, by name."""
    return sorted({s.name for t in terms for s in t.states if s.kind != "reading" and not s.since})


def reading_shift(terms: Sequence[Term], body: Body, found: Readings, values: Array, x: Array) -> tuple[Array, Array]:
    """Return what effects on the reading add to predicted readings (R, k), and the derivatives (R, k, n_c).

    Parameters
    ----------
    found : Readings
        Which rows of the recording, and what of them.
    values : (R, k) array
        Readings as predicted without these effects.
    x : (N, 12) array
        Poses of the machine.
    """
    R, k = values.shape
    added, parts = np.zeros((R, k)), []
    columns, rows = found.kind.targets, found.rows[:, 0]
    for term in terms:
        kernels = term.kernels
        own = np.zeros((R, k, term.n_coefficients))
        on = [(j, columns[t]) for j, t in enumerate(kernels.TARGETS) if t in columns]
        if on and kernels.ACTS_ON == "reading":
            # a column that this kind of reading does not have is read by no target that acts here
            state = dict.fromkeys(("y_x", "y_y", "y_z", "y_length"), np.zeros(R))
            state |= {f"y_{t.rpartition('.')[2]}": values[:, c] for t, c in columns.items()}
            machine = body.state(_read_by([term]), x, body.q, np.zeros((0, 0, 0)))  # no parameter is read
            state |= {name: (v if v.ndim == 1 else v.mean(axis=1))[rows] for name, v in machine.items()}
            state |= {s.name: body._since(term, s)[rows] for s in term.states if s.since}
            if set(kernels.STATE) <= state.keys():
                s = np.column_stack([state[n] for n in kernels.STATE]) if kernels.STATE else np.zeros((R, 0))
                value, D = (
                    kernels.value(s, term.values, term.constants),
                    kernels.jacobian(s, term.values, term.constants),
                )
                for j, column in on:
                    added[:, column] += value[:, j]
                    own[:, column] += D[:, j]
        parts.append(own)
    return added, np.concatenate(parts, axis=2) if parts else np.zeros((R, k, 0))


def coefficients(effect: str, joint_unit: str) -> tuple[tuple[str, str, float], ...]:
    """Return name, unit in files and factor to the unit inside of an effect's coefficients.

    Those of a joint depend on whether it turns or slides (`joint_unit` rad or mm).
    """
    kernels = load_effect(effect)
    return tuple(
        (name, *(of_sliding(unit) if joint_unit == "mm" and name in kernels.OF_JOINT else (unit, factor)))
        for name, unit, factor, _ in kernels.COEFFICIENTS
    )


def row_coefficients(term: Term, joint_unit: str) -> list[tuple[tuple[str, str, float], ...]]:
    """Return `coefficients` for each row of a term's values: a limb's, where its joint says in what they count."""
    units = of_joints(joint_unit, max(term.limbs, default=1))
    return [
        coefficients(term.effect, units[term.limbs[r] - 1] if term.limbs else units[0]) for r in range(len(term.values))
    ]


def row_factors(term: Term, joint_unit: str) -> Array:
    """Return the factors (rows, n_c) from files' units to those inside of a term's values."""
    return np.array([[factor for _, _, factor in row] for row in row_coefficients(term, joint_unit)])


def kept_term(term: Term) -> TermState:
    """Return what an answer keeps of a term, in its own units inside."""
    return TermState(
        effect=term.effect, limbs=term.limbs, constants=term.constants, values=term.values, tools=term.tools
    )


def term_of(kept: TermState) -> Term:
    """Return the term that an answer kept."""
    return Term(kept.effect, kept.limbs, kept.values, kept.constants, kept.tools)
