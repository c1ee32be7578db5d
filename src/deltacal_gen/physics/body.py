"""A machine under effects: its exact deformation, and the effects' columns for a fit.

An effect's own formulas are generated from ``derive/effects``; here its state is put together (joints, channels of the
recording, loads from virtual work at the deformed pose) and its targets are led through the machine's derivatives by
the chain rule. A machine with compliant parts is solved to its static equilibrium: loads at the pose, deformation by
the loads, pose again, until nothing moves.
"""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence

import numpy as np

from deltacal_gen import states
from deltacal_gen.errors import ImpossiblePose
from deltacal_gen.machine.answers import Sensitivity
from deltacal_gen.machine.machine import POSE
from deltacal_gen.machine.registry import SOLVED, STATUS, UNBALANCED, UNDEFINED, Array, Machine
from deltacal_gen.machine.rotation import cayley_matrix
from deltacal_gen.machine.values import Masses, Recording, Robot
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.deformed import Deformed, carried, turned
from deltacal_gen.physics.memory import Along, along
from deltacal_gen.physics.parts import along_deflections, lacking, lacks
from deltacal_gen.physics.targets import AXES, parts_of, target_of
from deltacal_gen.physics.terms import Constant, Term, blank, partial, remembers
from deltacal_gen.states import State
from deltacal_gen.units import joint_factors

EQUILIBRIUM_STEPS = 25
EQUILIBRIUM_DONE = 1e-9  # mm and rad: change of the pose that the next step would bring
EQUILIBRIUM_LEFT = 1e-6  # mm and rad: change of the pose by the last step, above which there is no equilibrium
STEP_S = 1e-3  # of the second difference that gives the accelerations of the weights


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
        self.roles, self.moves = mechanism.roles(robot), mechanism.moves(robot)
        masses = {} if robot.masses is None else robot.masses.numbers
        self.gravity = np.asarray((robot.masses or Masses()).gravity, dtype=float)
        self._held: tuple[tuple[int, ...], tuple[Term, ...], dict[str, Array]] | None = None
        self.inertia = masses.pop("proximal_inertia", None)
        self.masses = masses

    def missing(self, of: str | Term) -> str | None:
        """Return what an effect needs that is not there, in words; None where nothing is.

        Of its name alone what its constants choose is not looked for.
        """
        if why := self.foreign(of if isinstance(of, str) else of.effect):
            return why
        kernels = partial(of, self.lacks(of)) if isinstance(of, str) else of.kernels
        read = states.read_by(kernels) if isinstance(of, str) else of.states
        if without := [s for s in read if s.requires and not self._able(s)]:
            first = without[0]
            return (self.mechanism.weighed_by if first.kind == "load" else "") or first.requires
        if not self.robot.drawn and any(s.kind in ("load", "place", "geometry") for s in read):
            return "the table [geometry] in the robot file"
        channels = [c for s in read if not s.by for c in s.channels]
        channels += [states.named("time")] if remembers(kernels) else []
        for channel in dict.fromkeys(channels):
            names = channel.columns(self.mechanism.joint_unit, self.q.shape[1])
            words = f"column{'s' if len(names) > 1 else ''} {', '.join(names)}"
            value = self._channel(channel)
            if value is None:
                return f"the {words}"
            gaps = self.gaps(of) if isinstance(of, str) else of.gaps
            if np.isnan(value).any() and not (self._begins(channel) and (gaps or channel.optional)):
                return f"every cell of the {words} (some are blank)"
        return None

    def gaps(self, effect: str) -> tuple[int, ...]:
        """Return the sessions whose older rows lack a channel that an effect reads; see `Interrupted`.

        None where the cells of it that are blank are others, or all, or the effect remembers what was there before.
        """
        kernels = partial(effect, self.lacks(effect))
        channels = {c for s in states.read_by(kernels) if not s.by for c in s.needs}
        if remembers(kernels) or not all(map(self._begins, channels)):
            return ()
        blank = np.any([self._blank(c) for c in channels], axis=0) if channels else np.zeros(len(self.q), dtype=bool)
        return tuple(np.unique(self.session[blank]).tolist())

    def _blank(self, channel: State) -> np.ndarray:
        """Return the rows (N,) without a channel."""
        values = self._channel(channel)
        if values is None:
            return np.zeros(len(self.q), dtype=bool)
        return np.asarray(np.isnan(values).reshape(len(self.q), -1).any(axis=1))

    def _begins(self, channel: State) -> bool:
        """Tell whether a channel was recorded from some row of every session on, or in whole sessions alone."""
        blank, run = self._blank(channel), self.session
        again = blank[1:] & ~blank[:-1] & (run[1:] == run[:-1])
        return not (blank.all() or again.any())

    @property
    def session(self) -> np.ndarray:
        """The session (N,) of every row."""
        run = self.channels.run
        return np.zeros(len(self.q), dtype=np.int64) if run is None else run

    def _able(self, state: State) -> bool:
        """Tell whether the robot file says what a state requires."""
        return self.robot.masses is not None if state.kind == "load" else self._turn() is not None

    def _channel(self, state: State) -> Array | None:
        """Return a channel: of a joint (N, n_q), of another limb's joint or of the machine (N,)."""
        value = self.channels.get(state.base)
        return value[:, state.joint - 1] if value is not None and state.joint else value

    def foreign(self, effect: str) -> str | None:
        """Return the part that an effect moves or reads and this mechanism does not have; None where it has all."""
        parts = lacking(effect, self.mechanism, self.moves, self.roles)
        return f"a machine that has a part {parts[0]}; {self.mechanism.name} has none" if parts else None

    def lacks(self, effect: str) -> tuple[str, ...]:
        """Return the coefficients of an effect that move no part of this mechanism."""
        return lacks(effect, self.mechanism, self.moves, self.roles)

    def blank(
        self,
        effect: str,
        limbs: Sequence[int],
        constants: Sequence[Constant] = (),
        tools: Sequence[Sequence[float]] = (),
    ) -> Term:
        """Return an effect as this mechanism has it, all coefficients zero."""
        return blank(effect, limbs, constants, tools, self.lacks(effect), self.gaps(effect))

    # ----------------------------------------------------------------------------------------------------- the state

    def state(
        self, names: Sequence[str], x: Array, q: Array, rows: Array, limbs: Sequence[int] = ()
    ) -> dict[str, Array]:
        """Return what effects read of the machine, by name, at a solved pose.

        Parameters
        ----------
        names : sequence of str
            Not those of a reading.
        x, q, rows : (N, 12), (N, n_q), (1 or N, limbs, n_p) arrays
            Pose, joints as the geometry sees them, and parameters; read by states that follow the pose only.
        limbs : sequence of int
            Whose loads along deflections are wanted, from 1; others may be zero. Of all, where none is named.

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
                found[s.base] = self.channels.passed(s)
            elif s.kind == "geometry" and s.base in self.roles:
                found[s.base] = np.broadcast_to(self.roles[s.base], self.q.shape)
        if "q" in own:
            found["q"] = self.q
        if "turn" in own:
            found["turn"] = self._turn()
        if "theta" in own:
            found["theta"] = self.theta(q, rows)
        if loads := {s.base for s in wanted if s.kind == "load"}:
            found |= self._loads(loads, x, q, rows, limbs)
        if any(s.kind == "place" for s in wanted):
            found |= dict(zip(AXES, x[:, :3].T, strict=True)) | {"radius": np.hypot(x[:, 0], x[:, 1])}
        return {s.name: v[:, s.joint - 1] if s.joint else v for s in wanted if (v := found.get(s.base)) is not None}

    def theta(self, q: Array, rows: Array) -> Array:
        """Return the joints as the geometry sees them (N, n_q): moved by effects, q, and by errors of their zeros."""
        offsets = self.moves.get("offset", {}).items()  # none of carriages: their endstops are of the geometry
        theta: Array = q + sum((rows[:, :, self.mechanism.column(name)] @ much for name, much in offsets), np.zeros(1))
        return theta

    def _loads(self, wanted: set[str], x: Array, q: Array, rows: Array, limbs: Sequence[int]) -> dict[str, Array]:
        """Return what the weights exert at a pose, by the names of states, `wanted` among them."""
        payload = self.channels.payload
        out: dict[str, Array] = {}
        along = {name: d for name, d in along_deflections(self.mechanism).items() if name in wanted}
        if wanted - {"payload_torque", "inertia_torque"}:
            pulled = (limbs or range(1, self.mechanism.limbs + 1)) if along else ()
            total = self.mechanism.loads(x, q, self.tool, rows, self.masses, self.gravity, payload, pulled)
            out |= {name: total.pull[:, :, d] for name, d in along.items()}
            out |= {"torque": total.torque, "moment_x": total.moment[:, 0], "moment_y": total.moment[:, 1]}
            # a closure may stand for both rods
            out |= {"tension_1": total.tension[:, :, 0], "tension_2": total.tension[:, :, -1]}
        if "payload_torque" in wanted:
            out["payload_torque"] = self.mechanism.loads(x, q, self.tool, rows, {}, self.gravity, payload).torque
        acceleration = self.channels.get("qdd")
        if "inertia_torque" in wanted and acceleration is not None:
            out["inertia_torque"] = self._inertia(x, q, rows, acceleration)
        return out

    def pulled(self, terms: Sequence[Term]) -> list[int]:
        """Return the limbs, from 1, along whose deflections effects read loads; none where one reads those of all."""
        along = set(along_deflections(self.mechanism))
        return limbs_of([t for t in terms if along.intersection(s.base for s in t.states)])

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
        read = self.read(term, state)
        return np.hstack([read, self._remembered(term, read).value]) if remembers(term.kernels) else read

    def _remembered(self, term: Term, read: Array) -> Along:
        """Return the memories of a term at the rows of its state; NaN where they do not settle."""
        N, c = len(self.q), self.coefficients(term)
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

    def derivatives(self, term: Term, read: Array, coefficients: Array) -> Array:
        """Return the derivatives of what a term moves by its coefficients, (M, n_t, n_c), through memories too."""
        kernels = term.kernels
        if not remembers(kernels):
            return np.asarray(kernels.jacobian(read, coefficients, term.constants))
        found = self._remembered(term, read)
        s = np.hstack([read, found.value])
        by_memory = kernels.by_memory(s, coefficients, term.constants)
        return np.asarray(kernels.jacobian(s, coefficients, term.constants) + by_memory @ found.by_coefficients)

    def read(self, term: Term, state: Mapping[str, Array]) -> Array:
        """Return the states that a term reads, memories not among them."""
        limbwise = by_limb(term)
        N, limbs = self.q.shape
        columns = []
        for raw, s in zip(states.read_by(term.kernels), term.states, strict=True):
            value = self.since(term, s) if s.by else state[s.name]
            if limbwise and value.ndim == 1:
                value = np.repeat(value[:, None], limbs, axis=1)
            if raw.kind == "chosen" and s.joint:
                value = value * self._of_other(s.joint)
            if not limbwise and value.ndim == 2:  # a length of all limbs
                value = value.mean(axis=1)
            columns.append(value.ravel() if limbwise else value)
        if term.gaps:
            columns.append(np.repeat(self.session, limbs) if limbwise else self.session)
        size = N * limbs if limbwise else N
        return np.column_stack(columns) if columns else np.zeros((size, 0))

    def since(self, term: Term, state: State) -> Array:
        """Return which rows (N,) come after a moment, 1 or 0."""
        return (self.channels.clock >= float(term.constant(state.by))).astype(float)

    def _of_other(self, joint: int) -> Array:
        """Return how much of a joint's reading counts at each (n_q,): deg for deg or mm, and none at its own."""
        factors = np.array(joint_factors(self.mechanism.joint_unit, self.q.shape[1]))
        return np.where(np.arange(len(factors)) == joint - 1, 0.0, factors / factors[joint - 1])

    def coefficients(self, term: Term) -> Array:
        """Return the coefficients as the kernels read them: (N * limbs, n_c), zero where a limb has none."""
        N, limbs = self.q.shape
        if term.tools:
            return sum(self.uses(t)[:, None] * v for t, v in zip(term.tools, term.values, strict=True))
        if not by_limb(term):
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
            with np.errstate(divide="ignore", invalid="ignore"):  # such rows have no pose, which is told
                values = kernels.value(self._inputs(term, state), self.coefficients(term), term.constants)
            for j, target in enumerate(kernels.TARGETS):
                value = values[:, j].reshape(N, limbs) if by_limb(term) else values[:, j]
                out[target] = out[target] + value if target in out else value
        return out

    def uses(self, tool: Sequence[float]) -> np.ndarray:
        """Return which rows (N,) measure a tool point."""
        mask: np.ndarray = np.linalg.norm(self.tool - np.asarray(tool), axis=1) < 1e-6
        return mask

    def solve(
        self, errors: Array, terms: Sequence[Term], near: Deformed | None = None, held: tuple[Term, ...] = ()
    ) -> tuple[Deformed, np.ndarray]:
        """Return the machine in static equilibrium with all effects on it, and the status (N,) of each row.

        Of a machine of which no drawing is known only the joints move.

        Parameters
        ----------
        errors : (n_p,) array
            Source errors [mm, rad].
        near : Deformed, optional
            A machine that differs little: where to start.
        held : tuple of Term
            Effects beside `terms` that do not change from call to call.
        """
        mechanism = self.mechanism
        plain = mechanism.rows(self.robot, errors)
        terms, held = (tuple(t for t in some if t.kernels.ACTS_ON != "reading") for some in (terms, held))
        # joints as reported and channels do not change with the pose
        terms, held = (*terms, *(t for t in held if follows(t))), tuple(t for t in held if not follows(t))
        key = tuple(map(id, held))
        if self._held is None or self._held[0] != key:
            self._held = key, held, self._steady(held, plain)
        unchanged = _together(self._held[2], self._steady([t for t in terms if not follows(t)], plain))
        varying = [t for t in terms if follows(t)]
        names, limbs = states_read(varying), self.pulled(varying)
        if not self.robot.drawn:
            moved = Deformed(np.zeros((len(self.q), POSE)), self.q + unchanged.get("joint", 0.0), self.tool, plain)
            return moved, np.full(len(self.q), SOLVED)
        if not (terms or held) or near is None:
            x, status = mechanism.forward(self.q, self.tool, plain, None if near is None else near.x)
            if not (terms or held):
                return Deformed(x, self.q, self.tool, plain), status
            ok, q, rows = status == SOLVED, self.q, plain
        else:
            x, q, rows, ok = near.upright, near.q, near.rows, np.isfinite(near.x).all(axis=1)
        tool, before = self.tool, 0.0
        shift: dict[str, Array] = {}
        restless = None
        for _ in range(EQUILIBRIUM_STEPS):
            safe = np.where(ok[:, None], x, 0.0)
            asked = _together(unchanged, self.moved(varying, self.state(names, safe, q, rows, limbs)))
            earlier, (shift, lost) = shift, _defined(asked, len(x))
            q = self.q + shift.get("joint", 0.0)
            rows = self._rows(errors, shift)
            tool = self.tool + np.column_stack([np.broadcast_to(shift.get(f"tool.{a}", 0.0), len(x)) for a in AXES])
            last = x
            x, status = mechanism.forward(q, tool, rows, near=safe)
            ok = (status == SOLVED) & ~lost
            step = float(np.max(np.abs((x - last)[ok]), initial=0.0))
            # what follows the pose changes by a small part of what it moves: steps shrink by a steady factor
            if not varying or step * (min(step / before, 1.0) if before else 1.0) < EQUILIBRIUM_DONE:
                break
            before = step
        else:
            left = ok & (np.abs(x - last).max(axis=1) > EQUILIBRIUM_LEFT)
            restless = np.where(left, _restless(earlier, shift, len(x)), 0)
            x, status = np.where(left[:, None], np.nan, x), np.where(left, UNBALANCED, status)
        x, status = np.where(lost[:, None], np.nan, x), np.where(lost, UNDEFINED, status)
        turn = np.column_stack([np.broadcast_to(shift.get(f"turn.{a}", 0.0), len(x)) for a in AXES])
        if not turn.any():
            return Deformed(x, q, tool, rows, restless), status
        return Deformed(turned(x, cayley_matrix(turn)), q, tool, rows, restless, turn), status

    def _steady(self, terms: Sequence[Term], rows: Array) -> dict[str, Array]:
        """Return the displacement of every target by effects of the reported joints and of channels alone."""
        if not terms:
            return {}
        return self.moved(terms, self.state(states_read(terms), np.zeros((len(self.q), 12)), self.q, rows))

    def _rows(self, errors: Array, shift: Mapping[str, Array]) -> Array:
        parts = {target_of(t).part: v for t, v in shift.items() if target_of(t).sort == "limb"}
        base = self.mechanism.rows(self.robot, errors)
        if not parts:
            return base
        rows = np.repeat(base, len(self.q), axis=0)
        for part, value in parts.items():
            for name, much in self.moves[part].items():
                rows[:, :, self.mechanism.column(name)] += value @ much.T
        return rows

    # ---------------------------------------------------------------------------------------------------- columns

    def sensitivity(self, machine: Deformed, used: np.ndarray | slice = slice(None)) -> Sensitivity:
        """Return the derivatives of the pose in some rows, of a base that has turned as it stands then."""
        rows = machine.rows if len(machine.rows) == 1 else machine.rows[used]
        found = self.mechanism.sensitivity(machine.upright[used], machine.q[used], machine.tool[used], rows)
        return found if machine.turn is None else found.turned(cayley_matrix(machine.turn[used]))

    def columns(self, terms: Sequence[Term], body: Deformed, sensitivity: Sensitivity, chosen: np.ndarray) -> Array:
        """Return derivatives of platform coordinates, or joints, by all coefficients, (N, n_x, n_c), at fixed loads.

        Parameters
        ----------
        sensitivity : Sensitivity
            Of the rows `chosen`; other rows are zero.
        """
        (N, limbs), n_x = self.q.shape, sensitivity.joints.shape[1]
        out, start = np.zeros((N, n_x, sum(t.n_coefficients for t in terms))), 0
        if not terms:
            return out
        state = self.state(states_read(terms), body.upright, body.q, body.rows, self.pulled(terms))
        every = limbs_of([t for t in terms if self._deflects(t)])
        for _, group in itertools.groupby(terms, key=lambda t: (t.effect, t.limbs)):
            forms = list(group)
            kernels, count = forms[0].kernels, sum(t.n_coefficients for t in forms)
            part = out[:, :, start : start + count]
            start += count
            if not by_limb(forms[0]):
                part[:] = np.concatenate([self._machine_columns(t, state, body, n_x, chosen) for t in forms], axis=2)
                continue
            same = None if any(s.by for s in states.read_by(forms[0].kernels)) else self.read(forms[0], state)
            D = np.array(
                [
                    self.derivatives(
                        t,
                        self.read(t, state) if same is None else same,
                        self.coefficients(t) if t.values.any() else t.values[:1],
                    )
                    for t in forms
                ]
            )
            own = [i - 1 for i in forms[0].limbs] or list(range(limbs))
            D = D.reshape(len(forms), N, limbs, len(kernels.TARGETS), -1)[:, chosen][:, :, own]
            moved = np.empty((len(chosen), n_x, len(forms), len(own), D.shape[-1]))
            for j, target in enumerate(map(target_of, kernels.TARGETS)):
                S = self.along(sensitivity, target.part, every) if target.part else sensitivity.joints
                S, by = S[:, :, None, own, None], np.moveaxis(D[:, :, :, j], 0, 1)[:, None]
                if j:
                    moved += S * by
                else:
                    np.multiply(S, by, out=moved)
            part[chosen] = (moved if forms[0].limbs else moved.sum(axis=3)).reshape(len(chosen), n_x, -1)
        return out

    def _deflects(self, term: Term) -> bool:
        """Tell whether an effect moves deflections of limbs."""
        parts = parts_of(term.kernels.TARGETS)
        return any(name in self.mechanism.deflections for part in parts for name in self.moves[part])

    def along(self, sensitivity: Sensitivity, part: str, limbs: Sequence[int]) -> Array:
        """Return the derivatives of the pose by what an effect on some limbs moves in a limb, (n, n_x, limbs)."""
        mechanism, out = self.mechanism, np.zeros((*sensitivity.joints.shape[:2], self.mechanism.limbs))
        for name, much in self.moves[part].items():
            if name in mechanism.errors:
                by = sensitivity.own[..., mechanism.errors.index(name)]
            elif name in mechanism.common:
                by = sensitivity.common[..., mechanism.common.index(name)]
            else:
                by = sensitivity.by_deflections(limbs)[..., mechanism.deflections.index(name)]
            out += by @ much
        return out

    def _machine_columns(
        self, term: Term, state: Mapping[str, Array], body: Deformed, n_x: int, chosen: np.ndarray
    ) -> Array:
        out = np.zeros((len(self.q), n_x, term.n_coefficients))
        if term.kernels.ACTS_ON == "reading" or n_x != self.mechanism.n_x:  # what moves the platform moves no joint
            return out
        D = self.by_coefficients(term, state)
        for j, name in enumerate(term.kernels.TARGETS):
            out += carried(target_of(name), body)[:, :, None] * D[:, None, j, :]
        keep = np.zeros(len(out), dtype=bool)
        keep[chosen] = True
        out[~keep] = 0.0
        return out

    def by_coefficients(self, term: Term, state: Mapping[str, Array]) -> Array:
        """Return the derivatives (N, n_t, n_c) of what an effect moves of the base or the point by its coefficients."""
        D = self.derivatives(term, self.read(term, state), self.coefficients(term))
        if not term.tools:
            return D
        return np.concatenate([np.where(self.uses(t)[:, None, None], D, 0.0) for t in term.tools], axis=2)

    def check(self, machine: Deformed, status: np.ndarray, used: np.ndarray, recording: Recording) -> None:
        """Raise an InputError that names the first row of `used` without a pose."""
        bad = used[status[used] != SOLVED]
        if len(bad):
            joint = 0 if machine.restless is None else int(machine.restless[bad[0]])
            raise ImpossiblePose(
                f"at these joints the machine is {STATUS[int(status[bad[0]])]}"
                + (f", joint {joint} first" if joint else "")
                + (f" (and at {len(bad) - 1} more rows)." if len(bad) > 1 else "."),
                "Remove the row, or the effect."
                if status[bad[0]] == UNDEFINED
                else "Make the effect's jump smaller, or a slope of it."
                if joint
                else "Check the joint columns, their signs, zeros and units, and the robot's lengths.",
                file=recording.path,
                line=int(recording.line[bad[0]]),
            )


def by_limb(term: Term) -> bool:
    """Tell whether an effect moves limbs, whose own states it then reads."""
    return bool(term.kernels.ACTS_ON == "limb")


def follows(term: Term) -> bool:
    """Tell whether an effect reads what changes with the pose."""
    return any(s.follows for s in term.states)


def _defined(shift: Mapping[str, Array], rows: int) -> tuple[dict[str, Array], np.ndarray]:
    """Return displacements with 0 for what is no number, and the rows (N,) that have such."""
    lost = np.zeros(rows, dtype=bool)
    for value in shift.values():
        lost |= ~np.isfinite(value).reshape(len(value), -1).all(axis=1)
    return {t: np.where(np.isfinite(v), v, 0.0) for t, v in shift.items()} if lost.any() else dict(shift), lost


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


def states_read(terms: Sequence[Term]) -> list[str]:
    """Return what effects read of the machine at each pose, by name."""
    return sorted({s.name for t in terms for s in t.states if s.kind != "reading" and not s.by})


def limbs_of(terms: Sequence[Term]) -> list[int]:
    """Return the limbs, from 1, that effects sit on; none where one sits on all."""
    every = [t.limbs for t in terms if t.kernels.ACTS_ON == "limb"]
    return sorted({i for limbs in every for i in limbs}) if all(every) else []
