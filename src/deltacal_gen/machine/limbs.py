"""A machine of limbs that close loops: the generated kernels of its mechanism.

Shapes and units are checked here; the kernels below neither check nor raise.
"""

from __future__ import annotations

import importlib
import importlib.util
import time
from collections.abc import Generator, Iterator, Mapping, Sequence
from functools import cached_property
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np

from deltacal_gen.errors import OptionNotApplicable
from deltacal_gen.machine.answers import Reach, Sensitivity, Weights, filled, result
from deltacal_gen.machine.backend import RowFunctions, row_functions
from deltacal_gen.machine.machine import (
    COORDINATES,
    POSE,
    SINGULAR,
    SOLVED,
    UNREACHABLE,
    GeometryKey,
    Machine,
    Parameter,
)
from deltacal_gen.machine.rotation import Array, cayley_matrix, cayley_vector
from deltacal_gen.results.places import part_named

if TYPE_CHECKING:
    from deltacal_gen.machine.values import Robot

KNOWN, KNOWN_BYTES = 16, 20_000_000  # sets of constants that are kept, and how large all of them may become
NUDGE = 1e-3  # mm and rad: by which a dimension and an error are moved to see whether they are one
SETTLED_MM = 1e-9  # how near to the target a machine with effects is brought
STEPS = 60  # of Newton's method with the rigid machine's Jacobian: what effects add to it slows the last digits only


class Limbs(Machine):
    """A machine of limbs that close loops.

    Parameters
    ----------
    tables : module
        Generated tables of the mechanism.
    """

    many_ways = linked = False
    looped = written_out = True

    def __init__(self, tables: ModuleType) -> None:
        self._tables = tables
        self._known: dict[bytes, Array] = {}  # constants of machines seen lately: they cost as much as a hundred poses
        self.name: str = tables.NAME
        self.machine: str = tables.MACHINE
        self.title: str = tables.TITLE
        self.reference: str = tables.REFERENCE
        self.limbs: int = tables.LIMBS
        self.sort = "a parallel machine" if self.limbs > 1 else "a single joint"
        self.joint_unit: str = tables.JOINT_UNIT
        self.layers: tuple[int, int] = tables.LAYERS
        self.platform: tuple[str, ...] = tuple(name for name, _, _ in tables.PLATFORM)
        self._at = np.array([COORDINATES.index(name) for name in self.platform])
        self.asks = self.platform[: self.limbs]
        self.widths = (3, POSE) if self.turning else (3,)
        self.axes: tuple[str, ...] = tuple(name[1] for name in self.platform if name[0] == "p")
        self.turns: tuple[str, ...] = tuple(name[1] for name in self.platform if name[0] == "c")
        self.geometry = tuple(GeometryKey(*row) for row in tables.GEOMETRY)
        one = part_named(k.key for k in self.geometry)
        self.part = one if self.limbs > 1 else "joint"
        self.deflections: tuple[str, ...] = tuple(name for name, _, _ in tables.DEFLECTIONS)
        self.errors: tuple[str, ...] = tuple(name for name, *_ in tables.ERRORS)
        self.common: tuple[str, ...] = tuple(name for name, *_ in tables.COMMON)
        own = (
            Parameter(names[limb - 1], unit, f"{one} {limb}: {meaning}", limb, typical, name)
            for limb in range(1, self.limbs + 1)
            for name, unit, meaning, typical, names in tables.ERRORS
        )
        shared = (Parameter(name, unit, meaning, 0, typical, name) for name, unit, meaning, typical in tables.COMMON)
        self.parameters = (*own, *shared)
        self.models: dict[str, tuple[str, ...]] = dict(tables.MODELS)

    def scaling(self, convention: str, robot: Robot, names: Sequence[str]) -> Array:
        """Return the factors (n,) by which columns are divided in a convention of the paper, angles in rad."""
        try:
            factors = self._tables.scaling(convention, {key: float(v[0]) for key, v in robot.geometry.items()})
        except KeyError:
            raise OptionNotApplicable(f"{self.name} has no scaling '{convention}'; leave it out.") from None
        return np.array([factors.get(self.parameters[self.index[n]].error, 1.0) for n in names])

    # ------------------------------------------------------------------ from robots to the rows the kernels read

    def rows(self, robot: Robot, errors: Array | None = None, deflections: Array | None = None) -> Array:
        """Return the limbs' rows of parameters, (M, limbs, n): geometry, source errors, deflections."""
        values = self.every(self.vector(robot.errors) if errors is None else errors)
        many = max(len(values), 1 if deflections is None else len(deflections))
        own, n_g = len(self.errors), len(self.geometry)
        out = np.zeros((many, self.limbs, self._width))
        for j, entry in enumerate(self.geometry):
            value = robot.geometry[entry.key]
            out[:, :, j] = value if entry.entry is None else value[entry.entry]
        out[:, :, n_g : n_g + own] = values[:, : self.limbs * own].reshape(len(values), self.limbs, own)
        out[:, :, n_g + own : n_g + own + len(self.common)] = values[:, None, self.limbs * own :]
        if deflections is not None:
            out[:, :, self._width - len(self.deflections) :] = deflections
        return out

    @property
    def _width(self) -> int:
        return len(self.geometry) + len(self.errors) + len(self.common) + len(self.deflections)

    def same_as(self, robot: Robot, key: str) -> tuple[str, ...]:
        """Return the errors, limb by limb or the one of all limbs, that a dimension of the robot file is part of.

        A dimension and an error are one where moving either changes the same constants.
        """
        rows = self.rows(robot)

        def moved(column: int) -> Array:
            other = rows.copy()
            other[:, :, column] += NUDGE
            return self.constants(other)

        at, *more = (j for j, entry in enumerate(self.geometry) if entry.key == key)
        if more:
            return ()
        target = moved(at)
        own = self.geometry[at].per_limb
        for name in (*self.errors, *self.common) if own else (*self.common, *self.errors):
            if np.allclose(moved(self.column(name)), target, rtol=1e-12, atol=1e-9):
                return (name,) if name in self.common else tuple(f"{name}_{i + 1}" for i in range(self.limbs))
        return ()

    def roles(self, robot: Robot) -> dict[str, Array]:
        """Return the lengths that effects read, one value per limb or one for all [mm]."""
        found: dict[str, Array] = self._tables.roles(robot.geometry)
        return found

    def moves(self, robot: Robot) -> dict[str, dict[str, Array]]:
        """Return what effects move in a limb: {part: {error or deflection: how much of it (limbs, limbs)}}."""
        found = self._tables.moves(robot.geometry)
        own = np.ones(self.limbs)
        return {part: {name: np.diag(much * own) for name, much in moved.items()} for part, moved in found.items()}

    def limb_inertia(self, robot: Robot, masses: Mapping[str, float]) -> Array:
        """Return a limb's own inertia about its centre of mass, which turns with the joint [kg mm^2]."""
        return np.asarray(self._tables.limb_inertia(robot.geometry, masses), dtype=float)

    # --------------------------------------------------------------------------------------------------- kernels

    @cached_property
    def servo(self) -> ModuleType:
        """Commands of one pose, for loops that Numba compiles."""
        return importlib.import_module(f"deltacal_kernels.{self.name}.servo")

    def compile(self) -> Iterator[tuple[str, float]]:
        """Compile all kernels, or load them from Numba's cache; yield each one's name and how long it took [s].

        Compiled code is kept on disk as ``deltacal_kernels.cache`` says, and found by any process as long as the
        kernels' text stays the same.
        """
        n_v, n_x = self._width - len(self.geometry), len(self._at)
        rows, one, command = np.ones((1, self.limbs, self._width)), np.ones((1, self.limbs)), np.ones(self.limbs)
        x, status, tool, q = np.ones((1, n_x)), np.empty(1, dtype=np.int64), np.ones((1, 3)), one.copy()
        S, V = np.empty((1, n_x, self.limbs * n_v)), np.empty((1, n_x, self.limbs))
        batch, servo, positions, sign = self.compiled, self.servo, n_x - len(self.turns), np.ones(self.limbs)

        def done(module: ModuleType, name: str, *arguments: Any) -> Generator[tuple[str, float], None, Any]:
            start = time.perf_counter()
            with np.errstate(all="ignore"):
                value = getattr(module, name)(*arguments)
            yield f"{self.name}.{name}", time.perf_counter() - start
            return value

        yield from done(batch, "as_poses", x, self._at, np.empty((1, POSE)))
        yield from done(batch, "as_coordinates", np.ones((1, POSE)), self._at, x)
        k = yield from done(batch, "constants", rows)
        yield from done(batch, "forward", q, tool, k, x, status, False)
        yield from done(batch, "inverse", one, tool, k, x, q, status)
        if hasattr(batch, "simplified_forward"):  # not where a command turns the platform
            yield from done(batch, "simplified_forward", q, tool, k, x[:, : batch.SIMPLIFIED].copy(), status)
        if hasattr(batch, "simplified_inverse"):
            yield from done(batch, "simplified_inverse", one, tool, k, q, status)
        yield from done(batch, "sensitivity", x, q, tool, k, S, V, status)
        if hasattr(batch, "nominal_sensitivity"):
            nominal, n_e = (yield from done(batch, "nominal_constants", rows)), len(self.errors) + len(self.common)
            columns, rest = np.arange(self.limbs * n_e), (one, q, tool, nominal)
            yield from done(batch, "nominal_sensitivity", *rest, np.empty((1, positions, len(columns))))
            yield from done(batch, "distance_rows", *rest, columns, np.empty((0, len(columns))))
        if self.moving is not None:
            c = yield from done(self.moving, "constants", rows)
            inertia = np.ones(self.limbs * len(self.moving.LIMB) + len(self.moving.PLATFORM))
            given = x, np.ones((3, 1, self.limbs)), tool, k, c, np.ones(3), np.ones(self.limbs)
            yield from done(self.moving, "torque", *given, inertia, one)
            yield from done(self.moving, "regressor", *given, np.empty((1, self.limbs, len(inertia) - 1)))
            k_by, c_by = yield from done(self.moving, "constants_by", rows, rows)
            slopes = x, x[None], given[1], tool, k, k_by, c, c_by, *given[5:], inertia, one[None]
            yield from done(self.moving, "torque_by", *slopes)
        exact, linear = servo.exact_state(rows[0], tool[0], sign), servo.linear_state(rows[0], tool[0], sign)
        yield from done(servo, "exact_command", *command, exact)
        yield from done(servo, "linear_command", *command, linear)
        yield from done(servo, "linear_change", *command, *command, linear)
        yield from done(servo, "linear_commands", one, tool, linear, q, status)

    @cached_property
    def moving(self) -> ModuleType | None:
        """The kernels of the machine in motion; none where the mechanism says nothing of its bodies."""
        name = f"deltacal_kernels.{self.name}.dynamics"
        return importlib.import_module(name) if importlib.util.find_spec(name) else None

    @cached_property
    def weighs(self) -> bool:
        """Whether the mechanism says where weights act; without them nothing loads it, not even a payload."""
        return bool(self._statics.LIMB_WEIGHTS + self._statics.PLATFORM_WEIGHTS)

    @cached_property
    def _statics(self) -> RowFunctions:
        return row_functions(f"{self.name}.statics")

    def constants(self, rows: Array) -> Array:
        """Return what no joint and no target changes, as the C source reads it.

        The home of a machine whose lengths do not close is not a number: from there its poses are out of reach.
        """
        with np.errstate(invalid="ignore"):
            return np.asarray(self.vectorised.constants(rows))

    def _constants(self, kernels: ModuleType, rows: Array) -> Array:
        if kernels is not self.vectorised:  # compiled, they take microseconds
            return np.asarray(kernels.constants(rows))
        key = rows.tobytes()
        if (found := self._known.get(key)) is None:
            kept = list(self._known.values())
            if len(kept) > KNOWN or sum(k.nbytes for k in kept) > KNOWN_BYTES:
                self._known.clear()
            found = self._known[key] = self.constants(rows)
        return found

    def forward(
        self, q: Array, tool: Array, rows: Array, near: Array | None = None, *, out: Array | None = None
    ) -> tuple[Array, np.ndarray]:
        """Return the exact platform pose at given joints, and its status."""
        x, status, kernels = self._solved(q, tool, rows, near)
        return self._body(x, kernels, out), status

    def positions(self, q: Array, tool: Array, rows: Array, *, out: Array | None = None) -> Array:
        """Return the exact positions (N, 3) of the reference point [mm], NaN where not solved; see `forward`."""
        x, _, _ = self._solved(q, tool, rows, None)
        if self._at[:3].tolist() == [0, 1, 2]:
            if out is None:
                return x[:, :3]
            result(out, (len(x), 3))[:] = x[:, :3]
            return out
        out, moved = result(out, (len(x), 3)), [a for a in self._at[: x.shape[1]] if a < 3]
        out[:] = 0.0
        out[:, moved] = x[:, : len(moved)]
        out[np.isnan(x[:, 0])] = np.nan
        return out

    def _solved(self, q: Array, tool: Array, rows: Array, near: Array | None) -> tuple[Array, np.ndarray, ModuleType]:
        """Return the coordinates (N, n) that the kernels solve for, their status, and the kernels."""
        q = self._poses(q, self.limbs, "joints")
        near = None if near is None else self._poses(near, POSE, "poses to start from")
        self._alike(len(q), rows=rows, **({} if near is None else {"near": near}))
        status = np.empty(len(q), dtype=np.int64)
        kernels = self._kernels(len(q))
        tool, constants = self._machines(kernels, tool, rows, len(q))
        if hasattr(kernels, "simplified_forward") and self._simplified(rows):
            x = np.empty((len(q), kernels.SIMPLIFIED))
            kernels.simplified_forward(q, tool, constants, x, status)
        else:
            x = np.empty((len(q), len(self._at))) if near is None else self._own(near, kernels)
            kernels.forward(q, tool, constants, x, status, near is not None)
        return x, status, kernels

    def closed(self, q: Array, tool: Array, rows: Array) -> Array:
        """Return the coordinates (N, n) that close the loops at given joints, NaN where none do; see `coordinates`."""
        x, _, _ = self._solved(q, tool, rows, None)
        return x if x.shape[1] == len(self._at) else np.pad(x, ((0, 0), (0, len(self._at) - x.shape[1])))

    def frames(self, q: Array, rows: Array) -> tuple[Array, Array]:
        """Return the frames of base and platform: origins (N, 2, 3) and rotations (N, 2, 3, 3)."""
        x, _ = self.forward(q, np.zeros(3), rows)
        origins, rotations = np.zeros((len(x), 2, 3)), np.tile(np.eye(3), (len(x), 2, 1, 1))
        origins[:, 1], rotations[:, 1] = x[:, :3], x[:, 3:].reshape(-1, 3, 3)
        return origins, rotations

    def inverse(
        self, target: Array, tool: Array, rows: Array, limits: Array | None = None, *, out: Array | None = None
    ) -> tuple[Array, Array, np.ndarray]:
        """Return the joints that bring the reference point exactly to targets; `limits` choose nothing here."""
        x = self.stated(target)
        self._alike(len(x), rows=rows)
        q, status = result(out, (len(x), self.limbs)), np.empty(len(x), dtype=np.int64)
        if np.may_share_memory(x, q):  # joints in place of their targets, which are still read
            x = x.copy()
        kernels = self._kernels(len(x))
        tool, constants = self._machines(kernels, tool, rows, len(x))
        if hasattr(kernels, "simplified_inverse") and self._simplified(rows):
            kernels.simplified_inverse(x, tool, constants, q, status)
            if not (solved := status == SOLVED).all():
                x = np.where(solved[:, None], x, np.nan)
        else:
            x, asked = np.empty((len(x), len(self._at))), x
            kernels.inverse(asked, tool, constants, x, q, status)
        return q, self._body(x, kernels), status

    def _machines(self, kernels: ModuleType, tool: Array, rows: Array, poses: int) -> tuple[Array, Array]:
        """Return tools and constants as kernels read them: compiled ones share them out, plain ones read one a pose."""
        tool, constants = self._tools(tool, poses), self._constants(kernels, rows)
        if kernels is self.vectorised:
            tool = self._tool(tool, poses)
            if len(rows) not in (1, poses):
                constants = np.repeat(constants, poses // len(rows), axis=0)
        return tool, constants

    def _simplified(self, rows: Array) -> bool:
        """Tell whether all positions of the machine are closed form."""
        return not rows[:, :, self._tables.SMALL].any()

    def follow(
        self,
        target: Array,
        near: Array | None,
        tool: Array,
        rows: Array,
        drawn: Array | None = None,
        reach: Reach | None = None,
        *,
        together: bool = False,
        out: Array | None = None,
    ) -> tuple[Array, np.ndarray]:
        """Return joints (N, n_q) that bring a machine to targets, with effects too, and the status (N,).

        Newton's method on the exact machine: where it stands off the target is undone through the rigid machine's
        Jacobian. What an effect adds to that Jacobian is as small as the effect, so each step gains as many digits.
        """
        q, _, status = self.inverse(target, tool, rows, out=out)
        if reach is None:
            return q, status
        open_ = off = np.flatnonzero(status == SOLVED)
        q[:] = np.where(np.isfinite(q), q, 0.0)
        for _ in range(STEPS):
            if not len(open_):
                break
            at, reached = reach(q[open_], open_)
            miss = self.missed(at.x, target[open_])
            speed = self.asked(self.sensitivity(np.nan_to_num(at.x), at.q, at.tool, at.rows).joints)
            step = _solved(speed, miss)
            singular = ~np.isfinite(step).all(axis=1)
            status[open_] = np.where(reached != SOLVED, reached, np.where(singular, SINGULAR, SOLVED))
            solved = status[open_] == SOLVED
            going = solved & (np.abs(np.nan_to_num(miss)).max(axis=1) > SETTLED_MM)
            off = open_[going]
            going = solved if together and len(off) else going
            open_ = open_[going]
            q[open_] -= step[going]
        status[off] = UNREACHABLE
        q[status != SOLVED] = np.nan
        return q, status

    def asked(self, motion: Array) -> Array:
        """Return what a command asks for of motions (N, 3 or 6, ...): as many rows as there are joints."""
        rows = self._at[: self.limbs]
        if motion.shape[1] == 3 and (turns := rows >= 3).any():
            out = np.zeros((len(motion), self.limbs, *motion.shape[2:]))
            out[:, ~turns] = motion[:, rows[~turns]]
            return out
        return np.ascontiguousarray(motion[:, rows])

    def undo(self, moved: Array, x: Array, q: Array, tool: Array, rows: Array, *, out: Array | None = None) -> Array:
        """Return the change of the joints (N, n_q) that undoes a small displacement of poses."""
        speed = self.asked(self.sensitivity(x, q, tool, rows).joints)
        return filled(out, _solved(speed, -self.asked(moved)))

    def stated(self, target: Array) -> Array:
        """Return the coordinates (N, n_q) that a command states of targets (N, 3) or (N, 12)."""
        target = self.targets(target)
        if self.asks == COORDINATES[:3] and target.shape[1] == 3:
            return target
        if target.shape[1] == POSE:
            return self._own(target)[:, : self.limbs].copy()
        asked = self._at[: self.limbs]
        out = np.zeros((len(target), self.limbs))
        shifts = asked < 3
        out[:, shifts] = target[:, asked[shifts]]
        return out

    def _body(self, x: Array, kernels: ModuleType, out: Array | None = None) -> Array:
        """Return the pose (N, 12) of a body in space by the coordinates that kernels solved for, or the first ones."""
        at, out = self._at[: x.shape[1]], result(out, (len(x), POSE))
        if kernels is not self.vectorised:
            kernels.as_poses(x, at, out)
            return out
        full = np.zeros((len(x), self.n_x))
        full[:, at] = x
        out[:, :3], out[:, 3:] = full[:, :3], cayley_matrix(full[:, 3:]).reshape(-1, 9)
        out[~np.isfinite(x @ np.ones(x.shape[1]))] = np.nan
        return out

    def coordinates(self, x: Array) -> Array:
        """Return the coordinates (N, n) that closures are written in, of poses (N, 12)."""
        return self._own(self._poses(x, POSE, "poses"))

    def _own(self, x: Array, kernels: ModuleType | None = None) -> Array:
        """Return the coordinates (N, n) that the kernels solve for."""
        if kernels is not None and kernels is not self.vectorised:
            own = np.empty((len(x), len(self._at)))
            kernels.as_coordinates(x, self._at, own)
            return own
        full = np.hstack([x[:, :3], cayley_vector(x[:, 3:].reshape(-1, 3, 3))])
        return np.ascontiguousarray(full[:, self._at])

    def jacobians(
        self, x: Array, q: Array, tool: Array, rows: Array, *, out: Sequence[Array] | None = None
    ) -> tuple[Array, Array, Array, Array]:
        """Return closure and Jacobians F, J_x, J_q, J_p."""
        x, q = self._own(self._poses(x, POSE, "poses")), self._poses(q, self.limbs, "joints")
        self._alike(len(x), rows=rows, joints=q)
        f, n_v = self._tables.EQUATIONS, self._width - len(self.geometry)
        shapes = (len(x), f), (len(x), f, f), (len(x), f), (len(x), f, n_v)
        F, J_x, J_q, J_p = map(result, [None] * len(shapes) if out is None else out, shapes)
        tool, constants = self._machines(self.vectorised, tool, rows, len(x))
        self.vectorised.jacobians(x, q, tool, constants, F, J_x, J_q, J_p)
        return F, J_x, J_q, J_p

    def sensitivity(
        self, x: Array, q: Array, tool: Array, rows: Array, *, out: tuple[Array, Array] | None = None
    ) -> Sensitivity:
        """Return the derivatives of the exact pose at N solved poses; NaN where a pose is singular.

        The result is views of two arrays, which `out` may give: (N, n_x, limbs (n_e + n_s + n_d)) by each limb's
        errors and deflections, and (N, n_x, n_q) by the joints.
        """
        x, q = self._poses(x, POSE, "poses"), self._poses(q, self.limbs, "joints")
        self._alike(len(x), rows=rows, joints=q)
        n, n_v = len(self._at), self._width - len(self.geometry)
        S_out, V_out = (None, None) if out is None else out
        whole = n == self.n_x
        S = result(S_out if whole else None, (len(x), n, self.limbs * n_v))
        V = result(V_out if whole else None, (len(x), n, self.limbs))
        status = np.empty(len(x), dtype=np.int64)
        kernels = self._kernels(len(q))
        tool, constants = self._machines(kernels, tool, rows, len(q))
        kernels.sensitivity(self._own(x, kernels), q, tool, constants, S, V, status)
        if not whole:
            S, V = self._in_space(S, S_out), self._in_space(V, V_out)
        by_limb = S.reshape(len(x), self.n_x, self.limbs, n_v)
        own, common, deflections = np.split(by_limb, np.cumsum([len(self.errors), len(self.common)]), axis=3)
        return Sensitivity(own, common, deflections, V)

    def _in_space(self, derivatives: Array, out: Array | None) -> Array:
        out = result(out, (len(derivatives), self.n_x, derivatives.shape[2]))
        out[:] = 0.0
        out[:, self._at] = derivatives
        return out

    def _loads(self, x: Array, q: Array, tool: Array, rows: Array, given: Weights) -> tuple[Array, ...]:
        """Return what weights exert in the machine, by virtual work on the closure."""
        tool, weights = self._tool(tool, len(x)), self._masses(given.masses)
        _, J_x, J_q, J_p = self.jacobians(x, q, tool, rows)
        W_q, W_x, moment = self._exerted(self._own(x), q, tool, rows, weights, given.payload, given.fields)
        multipliers = -_solved(np.swapaxes(J_x, 1, 2), W_x)
        per_limb = multipliers.reshape(len(x), self.limbs, -1)
        J_limb = J_p.reshape(*per_limb.shape, -1)
        exerted = (J_q.reshape(per_limb.shape) * per_limb).sum(axis=2)
        first = J_limb.shape[3] - len(self.deflections)
        rods = [self.column(rod) - len(self.geometry) for rod in self._tables.RODS]
        along = J_limb[..., rods].sum(axis=3)  # a closure knows its own rod only
        pull = (J_limb[..., first:] * per_limb[..., None]).sum(axis=2)
        return W_q + exerted, pull, along * per_limb / self._tables.RODS_PER_CLOSURE, moment

    def weights_at(
        self, x: Array, q: Array, tool: Array, rows: Array, masses: Mapping[str, float], *, out: Array | None = None
    ) -> Array:
        """Return where the weights are, (N, weights, 3) [mm], in the order of the fields of `loads`."""
        kernels, own, weights = self._statics, self._own(x), self._masses(masses)
        tool, none = self._tool(tool, len(x)), np.zeros(len(x))
        parts = [kernels.limb_points(own, q[:, i], tool, rows[:, i], weights) for i in range(self.limbs)]
        points = np.hstack([*parts, kernels.platform_points(own, tool, weights, none)])
        return filled(out, points.reshape(len(x), -1, 3))

    def _exerted(
        self, own: Array, q: Array, tool: Array, rows: Array, weights: Array, payload: Array, fields: Array
    ) -> tuple[Array, Array, Array]:
        """Return what weights exert, as if the platform hung on nothing.

        On the joints (N, limbs), on the coordinates of the platform (N, n_x), and the moment about {O} (N, 3).
        """
        kernels, each, n_x = self._statics, 3 * self._statics.LIMB_WEIGHTS, own.shape[1]
        count = self.limbs * each + 3 * kernels.PLATFORM_WEIGHTS
        flat = np.broadcast_to(np.asarray(fields, dtype=float), (len(own), count // 3, 3)).reshape(len(own), count)
        rest = kernels.platform(own, tool, weights, payload, flat[:, self.limbs * each :])
        W_q = np.zeros((len(own), self.limbs))
        for i in range(self.limbs):
            of_limb = kernels.limb(own, q[:, i], tool, rows[:, i], weights, flat[:, each * i : each * (i + 1)])
            W_q[:, i] = of_limb[:, 0]
            rest += of_limb[:, 1:]
        return W_q, rest[:, :n_x], rest[:, n_x:]

    def _masses(self, masses: Mapping[str, float]) -> Array:
        return np.array([masses.get(name, 0.0) for name, _ in self._tables.MASSES])


def _solved(A: Array, b: Array) -> Array:
    """Return the solutions (N, n) of N systems of equations A (N, n, n), b (N, n); NaN where one is singular."""
    regular = np.flatnonzero(np.isfinite(A).all(axis=(1, 2)))
    regular = regular[np.linalg.det(A[regular]) != 0.0]  # of the same pivots as `solve` divides by
    out = np.full(b.shape, np.nan)
    out[regular] = np.linalg.solve(A[regular], b[regular][..., None])[..., 0]
    return out
