"""A machine that computes: the one place that imports the generated kernels.

Shapes and units are checked here; the kernels below neither check nor raise. Inside: mm, rad, kg, s, N.
"""

from __future__ import annotations

import dataclasses
import importlib
import time
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from types import ModuleType
from typing import TYPE_CHECKING, Any, NamedTuple

import deltacal_kernels
import numpy as np

from deltacal_gen.errors import UsageError
from deltacal_gen.machine import backend
from deltacal_gen.machine.backend import Backend
from deltacal_gen.rotation import Array, cayley_matrix, cayley_vector
from deltacal_gen.units import of_joints

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from deltacal_gen.inputs import Link, Robot

COORDINATES = ("px", "py", "pz", "cx", "cy", "cz")  # of a body in space, as the kernels solve for them
POSE = 12  # numbers of a pose: position of the reference point, rotation matrix row by row
SOLVED, UNREACHABLE, SINGULAR = 0, 1, 2
KNOWN, KNOWN_BYTES = 16, 20_000_000  # sets of constants that are kept, and how large all of them may become
STATUS = {
    SOLVED: "solved",
    UNREACHABLE: "out of reach: no pose of the platform closes all loops",
    SINGULAR: "singular: the platform is not held in every direction",
}


class GeometryKey(NamedTuple):
    """A nominal dimension as the robot file names it."""

    key: str
    unit: str
    meaning: str
    per_limb: bool
    default: tuple[float, ...] | None
    table: str
    positive: bool
    entry: int | None


class Parameter(NamedTuple):
    """A source error of the whole machine, actual minus nominal; `typical` is the size of an ordinary one.

    `limb` counts from 1; 0 for an error that all limbs share. `error` is the name without the limb.
    """

    name: str
    unit: str
    meaning: str
    limb: int
    typical: float
    error: str


@dataclass(frozen=True, eq=False)
class Sensitivity:
    """Derivatives of the exact platform pose at N poses: shift of the reference point, turn about the axes of {O}.

    Attributes
    ----------
    own : (N, n_x, limbs, n_e) array
        By each limb's source errors [unit of x / mm or rad].
    common : (N, n_x, limbs, n_s) array
        By the errors that all limbs share, limb by limb: what each limb's share of them does.
    deflections : (N, n_x, limbs, n_d) array
        By the displacements that vanish on a rigid machine.
    joints : (N, n_x, n_q) array
        The velocity Jacobian.
    """

    own: Array
    common: Array
    deflections: Array
    joints: Array

    @cached_property
    def parameters(self) -> Array:
        """By the source errors, (N, n_x, n_p), in the order of ``Mechanism.parameters``."""
        flat = self.own.reshape(*self.own.shape[:2], -1)
        return np.concatenate([flat, self.common.sum(axis=2)], axis=2) if self.common.shape[3] else flat


class Loads(NamedTuple):
    """What weights exert in a machine at N poses; each is conjugate to a displacement, positive along it.

    Attributes
    ----------
    torque : (N, n_q) array
        On the joints [N mm]; gravity on a horizontal arm is negative.
    pull : (N, limbs, n_d) array
        Of the rods on the limb's deflections [N].
    tension : (N, limbs, rods) array
        In the rods [N].
    moment : (N, 3) array
        Of all weights about {O} [N mm].
    """

    torque: Array
    pull: Array
    tension: Array
    moment: Array

    @classmethod
    def written(cls, out: Sequence[Array] | None, *values: Array) -> Loads:
        """Return loads in the caller's arrays, where there are any; see `result`."""
        return cls(*values if out is None else map(filled, out, values))


def mechanism_names() -> tuple[str, ...]:
    """Return the names of all registered mechanisms."""
    return tuple(deltacal_kernels.MECHANISMS)


def load_mechanism(name: str, links: tuple[Link, ...] = ()) -> Mechanism:
    """Return a registered mechanism, always the same object; an open chain is one of its `links`.

    Raises
    ------
    UsageError
        No mechanism has this name; the message lists those that exist.
    """
    if name not in mechanism_names():
        raise UsageError(f"there is no mechanism '{name}'. Registered: {', '.join(mechanism_names())}.")
    return _loaded(name, links)


@cache
def _loaded(name: str, links: tuple[Link, ...]) -> Mechanism:
    tables = importlib.import_module(f"deltacal_kernels.{name}.parameters")
    if getattr(tables, "CHAIN", False):
        from deltacal_gen.chain import Chain  # which builds on this module

        return Chain(tables, links)
    return Mechanism(tables)


def mechanism_of(robot: Robot) -> Mechanism:
    """Return the mechanism of a robot."""
    return load_mechanism(robot.mechanism, robot.links)


def nominal_joints(robot: Robot, targets: Array, tool: Array) -> tuple[Array, np.ndarray]:
    """Return the joints (N, n_q) that a controller commands which believes the drawing, as the geometry counts them.

    Parameters
    ----------
    targets : (N, 3) array, or (N, 12) of an open chain
        See `Mechanism.inverse`.

    Returns
    -------
    q : (N, n_q) array
    status : (N,) int array
    """
    mechanism = mechanism_of(robot)
    rows = mechanism.rows(dataclasses.replace(robot, errors={}))
    limits = {} if mechanism.links is None else {"limits": robot.geometric_limits}  # a chain can stand in many ways
    q, _, status = mechanism.inverse(targets, tool, rows, **limits)
    return q, status


def described(mechanism: Mechanism) -> tuple[Mechanism, ...]:
    """Return the mechanisms that share a mechanism's robot files: one geometry, different source errors."""
    tables = {name: importlib.import_module(f"deltacal_kernels.{name}.parameters") for name in mechanism_names()}
    alike = [name for name, table in tables.items() if getattr(table, "MACHINE", name) == mechanism.machine]
    return tuple(map(load_mechanism, alike)) if mechanism.links is None else (mechanism,)


def result(out: Array | None, shape: tuple[int, ...]) -> Array:
    """Return the array that a batch function writes its result into: the caller's `out`, or a new one.

    Raises
    ------
    ValueError
        `out` has another shape or type, is not contiguous, or cannot be written.
    """
    if out is None:
        return np.empty(shape)
    if out.shape != shape or out.dtype != float or not (out.flags.c_contiguous and out.flags.writeable):
        raise ValueError(
            f"out is an array {out.shape} of {out.dtype}; it must be a contiguous array {shape} of float64 to write to."
        )
    return out


def filled(out: Array | None, values: Array) -> Array:
    """Return values in the caller's `out`, or as they are where there is none; see `result`."""
    if out is None:
        return values
    result(out, values.shape)[:] = values
    return out


class Mechanism:
    """Tables and kernels of one machine; the robot's numbers come in by every call.

    What is computed at many poses takes `out=`, an array of the result's shape that is filled and returned, or a tuple
    of them where there are several results: memory that is fresh costs more than what is computed into it.
    """

    links: tuple[Link, ...] | None = None  # of an open chain

    def __init__(self, tables: ModuleType) -> None:
        self._tables = tables
        self._known: dict[bytes, Array] = {}  # constants of machines seen lately: they cost as much as a hundred poses
        self.name: str = tables.NAME
        self.machine: str = tables.MACHINE
        self.title: str = tables.TITLE
        self.reference: str = tables.REFERENCE
        self.limbs: int = tables.LIMBS
        self.joint_unit: str = tables.JOINT_UNIT
        self.layers: tuple[int, int] = tables.LAYERS
        self.platform: tuple[str, ...] = tuple(name for name, _, _ in tables.PLATFORM)
        self._at = np.array([COORDINATES.index(name) for name in self.platform])
        self.axes: tuple[str, ...] = tuple(name[1] for name in self.platform if name[0] == "p")
        self.turns: tuple[str, ...] = tuple(name[1] for name in self.platform if name[0] == "c")
        self.geometry = tuple(GeometryKey(*row) for row in tables.GEOMETRY)
        self.deflections: tuple[str, ...] = tuple(name for name, _, _ in tables.DEFLECTIONS)
        self.errors: tuple[str, ...] = tuple(name for name, *_ in tables.ERRORS)
        self.common: tuple[str, ...] = tuple(name for name, *_ in tables.COMMON)
        own = (
            Parameter(names[limb - 1], unit, f"limb {limb}: {meaning}", limb, typical, name)
            for limb in range(1, self.limbs + 1)
            for name, unit, meaning, typical, names in tables.ERRORS
        )
        shared = (Parameter(name, unit, meaning, 0, typical, name) for name, unit, meaning, typical in tables.COMMON)
        self.parameters = (*own, *shared)
        self.models: dict[str, tuple[str, ...]] = dict(tables.MODELS)

    def __repr__(self) -> str:
        return f"<Mechanism {self.name}: {len(self.parameters)} source errors>"

    def __reduce__(self) -> tuple[Callable[..., Mechanism], tuple[str, tuple[Link, ...]]]:
        """Another process, and a copy, take the mechanism that is loaded there."""
        return load_mechanism, (self.name, self.links or ())

    @property
    def joint_units(self) -> tuple[str, ...]:
        """Unit of each joint, rad or mm."""
        return tuple(of_joints(self.joint_unit, self.limbs))

    @property
    def n_x(self) -> int:
        """Directions in which a body in space can move: three shifts, three turns."""
        return len(COORDINATES)

    @property
    def reading_columns(self) -> tuple[bool, ...]:
        """Which of a body's six coordinates this machine moves: what there is to measure."""
        return tuple(name in self.platform for name in COORDINATES)

    @property
    def full_model(self) -> str:
        """Name of the model that stands for the whole machine unless another is asked for: the first of the table."""
        return next(iter(self.models))

    @cached_property
    def index(self) -> dict[str, int]:
        """Column of each parameter in the order of `parameters`."""
        return {p.name: j for j, p in enumerate(self.parameters)}

    @cached_property
    def typical(self) -> Array:
        """Size of an ordinary error, (n_p,) [mm, rad]: the scale in which unlike columns are compared."""
        return np.array([p.typical for p in self.parameters])

    def model(self, name: str) -> tuple[str, ...]:
        """Return the parameter names of a model, given as ``delta/18`` or ``18``.

        Raises
        ------
        UsageError
            The mechanism has no such model; the message lists those it has.
        """
        full = self.full_name(name)
        if full not in self.models:
            import difflib  # for the message alone

            near = difflib.get_close_matches(full, self.models, n=1)
            hint = f" Did you mean {near[0]}?" if near else ""
            raise UsageError(f"{self.name} has no model '{name}'; it has {', '.join(self.models)}.{hint}")
        return self.models[full]

    def full_name(self, model: str) -> str:
        """Return ``delta/18`` for ``18``."""
        return model if "/" in model else f"{self.machine}/{model}"

    def vector(self, errors: Mapping[str, float]) -> Array:
        """Return source errors as a vector (n_p,) in the order of `parameters`; those not given are 0."""
        out = np.zeros(len(self.parameters))
        for name, value in errors.items():
            out[self.index[name]] = value
        return out

    def every(self, errors: ArrayLike) -> Array:
        """Return source errors of one machine or of many as (M, n_p).

        Raises
        ------
        UsageError
            They are not as many as the mechanism has.
        """
        values, n = np.atleast_2d(np.asarray(errors, dtype=float)), len(self.parameters)
        if values.ndim != 2 or values.shape[1] != n:
            raise UsageError(f"errors have the shape {np.shape(errors)}; ({n},) or (M, {n}) was expected.")
        return values

    def scaling(self, convention: str, robot: Robot, names: Sequence[str]) -> Array:
        """Return the factors (n,) by which columns are divided in a convention of the paper, angles in rad."""
        try:
            factors = self._tables.scaling(convention, {key: float(v[0]) for key, v in robot.geometry.items()})
        except KeyError:
            raise UsageError(f"{self.name} has no scaling '{convention}'; leave it out.") from None
        return np.array([factors.get(self.parameters[self.index[n]].error, 1.0) for n in names])

    def has_scaling(self, convention: str, robot: Robot) -> bool:
        """Tell whether a paper gives the columns of this machine another scale."""
        try:
            self.scaling(convention, robot, ())
        except UsageError:
            return False
        return True

    # ------------------------------------------------------------------ from robots to the rows the kernels read

    def rows(self, robot: Robot, errors: Array | None = None, deflections: Array | None = None) -> Array:
        """Return the limbs' rows of parameters, (M, limbs, n): geometry, source errors, deflections.

        Parameters
        ----------
        robot : Robot
        errors : (n_p,) or (M, n_p) array, optional
            Source errors [mm, rad]; default the robot's own.
        deflections : (M, limbs, n_d) array, optional

        Raises
        ------
        UsageError
            As `every`.
        """
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

    def column(self, name: str) -> int:
        """Return where an error or a deflection stands in a limb's row of parameters."""
        return len(self.geometry) + (*self.errors, *self.common, *self.deflections).index(name)

    def roles(self, robot: Robot) -> dict[str, Array]:
        """Return the lengths that effects read, one value per limb or one for all [mm]."""
        found: dict[str, Array] = self._tables.roles(robot.geometry)
        return found

    def moves(self, robot: Robot) -> dict[str, dict[str, Array]]:
        """Return what effects move in a limb: {part: {error or deflection: how much of it}}."""
        found: dict[str, dict[str, Array]] = self._tables.moves(robot.geometry)
        return found

    def limb_inertia(self, robot: Robot, masses: Mapping[str, float]) -> Array:
        """Return a limb's own inertia about its centre of mass, which turns with the joint [kg mm^2]."""
        return np.asarray(self._tables.limb_inertia(robot.geometry, masses), dtype=float)

    # --------------------------------------------------------------------------------------------------- kernels

    @cached_property
    def compiled(self) -> ModuleType:
        """The Numba kernels; the first use loads Numba and, once per machine, compiles."""
        return importlib.import_module(f"deltacal_kernels.{self.name}.kinematics")

    @cached_property
    def servo(self) -> ModuleType:
        """Commands of one pose, for loops that Numba compiles."""
        return importlib.import_module(f"deltacal_kernels.{self.name}.servo")

    @cached_property
    def vectorised(self) -> ModuleType:
        """The same kernels in plain NumPy."""
        return importlib.import_module(f"deltacal_kernels.{self.name}.vectorised")

    def compile(self) -> Iterator[tuple[str, float]]:
        """Compile all kernels, or load them from Numba's cache; yield each one's name and how long it took [s].

        Compiled code is kept on disk as ``deltacal_kernels.compiled`` says, and found by any process as long as the
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
        yield from done(batch, "simplified_forward", q, tool, k, x[:, : batch.SIMPLIFIED].copy(), status)
        if hasattr(batch, "simplified_inverse"):
            yield from done(batch, "simplified_inverse", one, tool, k, q, status)
        yield from done(batch, "sensitivity", x, q, tool, k, S, V, status)
        if hasattr(batch, "nominal_sensitivity"):
            nominal, n_e = (yield from done(batch, "nominal_constants", rows)), len(self.errors) + len(self.common)
            columns, rest = np.arange(self.limbs * n_e), (one, q, tool, nominal)
            yield from done(batch, "nominal_sensitivity", *rest, np.empty((1, positions, len(columns))))
            yield from done(batch, "distance_rows", *rest, columns, np.empty((0, len(columns))))
        exact, linear = servo.exact_state(rows[0], tool[0], sign), servo.linear_state(rows[0], tool[0], sign)
        yield from done(servo, "exact_command", *command, exact)
        yield from done(servo, "linear_command", *command, linear)
        yield from done(servo, "linear_change", *command, *command, linear)
        yield from done(servo, "linear_commands", one, tool, linear, q, status)

    def _kernels(self, poses: int) -> ModuleType:
        """Return the kernels for a call over so many poses."""
        return self.compiled if backend.chosen(poses) is Backend.COMPILED else self.vectorised

    @cached_property
    def weighs(self) -> bool:
        """Whether the mechanism says where weights act; without them nothing loads it, not even a payload."""
        return bool(self._statics.LIMB_WEIGHTS + self._statics.PLATFORM_WEIGHTS)

    @cached_property
    def _statics(self) -> ModuleType:
        return importlib.import_module(f"deltacal_kernels.{self.name}.statics")

    def _constants(self, kernels: ModuleType, rows: Array) -> Array:
        if kernels is not self.vectorised:  # compiled, they take microseconds
            return np.asarray(kernels.constants(rows))
        key = rows.tobytes()
        if (found := self._known.get(key)) is None:
            kept = list(self._known.values())
            if len(kept) > KNOWN or sum(k.nbytes for k in kept) > KNOWN_BYTES:
                self._known.clear()
            found = self._known[key] = self.vectorised.constants(rows)
        return found

    def forward(
        self, q: Array, tool: Array, rows: Array, near: Array | None = None, *, out: Array | None = None
    ) -> tuple[Array, np.ndarray]:
        """Return the exact platform pose at given joints.

        Parameters
        ----------
        q : (N, n_q) array
            Joints [rad or mm].
        tool : (3,) or (N, 3) array
            Reference point in {O'} [mm].
        rows : (M, limbs, n) array
            See `rows`; each of M machines stands at N / M joints one after another.
        near : (N, 12) array, optional
            Poses of a machine that differs little: where to start from.
        out : (N, 12) array, optional
            Where x is written.

        Returns
        -------
        x : (N, 12) array
            Position of the reference point [mm] and rotation matrix of the platform, row by row; NaN where not solved.
        status : (N,) int array
            SOLVED, UNREACHABLE or SINGULAR, explained in `STATUS`.
        """
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
        if kernels is not self.vectorised and self._simplified(rows):
            x = np.empty((len(q), kernels.SIMPLIFIED))
            kernels.simplified_forward(q, tool, constants, x, status)
        else:
            x = np.empty((len(q), len(self._at))) if near is None else self._own(near, kernels)
            kernels.forward(q, tool, constants, x, status, near is not None)
        return x, status, kernels

    def inverse(
        self, target: Array, tool: Array, rows: Array, *, out: Array | None = None
    ) -> tuple[Array, Array, np.ndarray]:
        """Return the joints that bring the reference point exactly to `target` (N, 3) [mm].

        A machine of fewer joints takes of the target the coordinates that it commands, the first of `platform`. The
        joints are written into `out` (N, n_q) where it is given.

        Returns
        -------
        q : (N, n_q) array
        x : (N, 12) array
            The pose the platform then has; a machine of three joints cannot choose its rotation.
        status : (N,) int array
        """
        target = self._poses(target, 3, "target")
        self._alike(len(target), rows=rows)
        q, status = result(out, (len(target), self.limbs)), np.empty(len(target), dtype=np.int64)
        x = self.commanded(target)
        if np.may_share_memory(x, q):  # joints in place of their targets, which are still read
            x = x.copy()
        kernels = self._kernels(len(target))
        tool, constants = self._machines(kernels, tool, rows, len(target))
        if hasattr(kernels, "simplified_inverse") and self._simplified(rows):
            kernels.simplified_inverse(x, tool, constants, q, status)
            if not (solved := status == SOLVED).all():
                x = np.where(solved[:, None], x, np.nan)
        else:
            x, asked = np.empty((len(target), len(self._at))), x
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

    def undo(self, moved: Array, x: Array, q: Array, tool: Array, rows: Array, *, out: Array | None = None) -> Array:
        """Return the change of the joints (N, n_q) that undoes a shift `moved` (N, 3) of the reference point."""
        speed = self.commanded(self.sensitivity(x, q, tool, rows).joints)
        return filled(out, np.asarray(np.linalg.solve(speed, -self.commanded(moved)[..., None])[..., 0]))

    def commanded(self, target: Array) -> Array:
        """Return what a command asks for of targets (N, 3): as many coordinates as there are joints."""
        asked = self._at[: self.limbs]
        if np.array_equal(asked, np.arange(target.shape[1])):
            return np.ascontiguousarray(target)
        return np.ascontiguousarray(target[:, asked])

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
        """Return closure and Jacobians F (N, f), J_x (N, f, f), J_q (N, f), J_p (N, f, n_e + n_s + n_d).

        J_x holds the coordinates in `platform`. A row depends on the joint, errors and deflections of its own limb
        only, and on the common errors; J_q and J_p hold those columns.
        """
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

    def loads(
        self,
        x: Array,
        q: Array,
        tool: Array,
        rows: Array,
        masses: Mapping[str, float],
        fields: Array,
        payload: Array | float = 0.0,
        *,
        out: Sequence[Array] | None = None,
    ) -> Loads:
        """Return what weights exert in the machine, by virtual work on the closure.

        Parameters
        ----------
        masses : mapping
            The mechanism's masses [kg] and positions of centres of mass; those not given are 0.
        fields : (3,) or (N, weights, 3) array
            Acceleration that acts on the weights [m/s^2]: gravity in {O}, or minus their own (see `weights_at`).
        payload : float or (N,) array
            At the reference point [kg].
        out : sequence of arrays, optional
            Where they are written, as `Loads` has them.
        """
        q, tool = self._poses(q, self.limbs, "joints"), self._tool(tool, len(x))
        _, J_x, J_q, J_p = self.jacobians(x, q, tool, rows)
        weights, payload = self._masses(masses), np.broadcast_to(np.asarray(payload, dtype=float), len(x))
        count = self.limbs * self._statics.LIMB_WEIGHTS + self._statics.PLATFORM_WEIGHTS
        every = np.broadcast_to(np.asarray(fields, dtype=float), (len(x), count, 3))
        W_q, W_x, moment = self._statics.loads(self._own(x), q, tool, rows, weights, payload, every)
        multipliers = -np.linalg.solve(np.swapaxes(J_x, 1, 2), W_x[..., None])[..., 0]
        per_limb = multipliers.reshape(len(x), self.limbs, -1)
        J_limb = J_p.reshape(*per_limb.shape, -1)
        exerted = (J_q.reshape(per_limb.shape) * per_limb).sum(axis=2)
        first = J_limb.shape[3] - len(self.deflections)
        rods = [self.column(rod) - len(self.geometry) for rod in self._tables.RODS]
        along = J_limb[..., rods].sum(axis=3)  # a closure knows its own rod only
        return Loads.written(
            out,
            W_q + exerted,
            (J_limb[..., first:] * per_limb[..., None]).sum(axis=2),
            along * per_limb / self._tables.RODS_PER_CLOSURE,
            moment,
        )

    def torques(
        self,
        x: Array,
        q: Array,
        tool: Array,
        rows: Array,
        masses: Mapping[str, float],
        gravity: Array,
        payload: Array | float = 0.0,
        *,
        out: Array | None = None,
    ) -> Array:
        """Return the static joint torques (N, n_q) [N mm] under gravity [m/s^2] and payload [kg]; see `loads`.

        Positive along the positive joint: gravity on a horizontal arm is negative.
        """
        return filled(out, self.loads(x, q, tool, rows, masses, gravity, payload).torque)

    def weights_at(
        self, x: Array, q: Array, tool: Array, rows: Array, masses: Mapping[str, float], *, out: Array | None = None
    ) -> Array:
        """Return where the weights are, (N, weights, 3) [mm], in the order of the fields of `loads`."""
        tool, none = self._tool(tool, len(x)), np.zeros(len(x))
        return filled(out, self._statics.points(self._own(x), q, tool, rows, self._masses(masses), none))

    def _masses(self, masses: Mapping[str, float]) -> Array:
        return np.array([masses.get(name, 0.0) for name, _ in self._tables.MASSES])

    @staticmethod
    def _poses(values: Array, columns: int, what: str) -> Array:
        out = np.ascontiguousarray(values, dtype=float)
        if out.ndim != 2 or out.shape[1] != columns:
            raise ValueError(f"{what} have the shape {out.shape}, but must have (N, {columns}).")
        return out

    @staticmethod
    def _tools(tool: Array, n: int) -> Array:
        """Return tools (n or 1, 3) as the compiled kernels read them."""
        out = np.ascontiguousarray(np.atleast_2d(tool), dtype=float)
        if out.shape not in ((1, 3), (n, 3)):
            raise ValueError(f"tool has the shape {np.shape(tool)}, but must have (3,) or ({n}, 3), one a pose.")
        return out

    @staticmethod
    def _alike(n: int, **others: Array) -> None:
        """Raise ValueError where other arrays do not go with n poses: rows of machines share them out evenly."""
        for what, values in others.items():
            shared = what == "rows" and len(values) > 0
            if n % len(values) if shared else len(values) != n:
                raise ValueError(f"{what} have the shape {values.shape}, which does not go with {n} poses.")

    @classmethod
    def _tool(cls, tool: Array, n: int) -> Array:
        """Return tools (n, 3)."""
        return np.ascontiguousarray(np.broadcast_to(cls._tools(tool, n), (n, 3)))
