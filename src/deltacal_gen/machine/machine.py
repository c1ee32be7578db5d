"""What a machine is to everyone who computes with one: its tables, and what can be asked of it.

Machines of limbs that close loops (`limbs`) and open chains (`chain`) answer alike; what only some can do is asked of
an attribute, never of the class. Inside: mm, rad, kg, s, N.
"""

from __future__ import annotations

import importlib
from abc import ABC, abstractmethod
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from types import ModuleType
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from deltacal_gen.errors import NotForThisMachine, UnknownModel, UsageError, WrongArray
from deltacal_gen.machine import backend
from deltacal_gen.machine.answers import Loads, Reach, Sensitivity, Weights, filled
from deltacal_gen.machine.backend import Backend
from deltacal_gen.machine.rotation import Array, to_vector
from deltacal_gen.units import of_joints

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from deltacal_gen.machine.values import Robot

COORDINATES = ("px", "py", "pz", "cx", "cy", "cz")  # of a body in space, as the kernels solve for them
POSE = 12  # numbers of a pose: position of the reference point, rotation matrix row by row
SOLVED, UNREACHABLE, SINGULAR, UNBALANCED, UNDEFINED = 0, 1, 2, 3, 4
STATUS = {
    SOLVED: "solved",
    UNREACHABLE: "out of reach: no pose of the platform closes all loops",
    SINGULAR: "singular: the platform is not held in every direction",
    UNBALANCED: "without static equilibrium: an effect that jumps throws the machine back and forth",
    UNDEFINED: "moved by no number: an effect's formula divides by zero there, or what it remembers cannot be followed "
    "between rows so far apart in time",
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


class Machine(ABC):
    """Tables and kernels of one machine; the robot's numbers come in by every call.

    What is computed at many poses takes `out=`, an array of the result's shape that is filled and returned, or a tuple
    of them where there are several results: memory that is fresh costs more than what is computed into it.

    Attributes
    ----------
    name, machine : str
        Of the mechanism, and of the machine whose robot files it reads: one may be described by several.
    sort : str
        In words, for messages: ``an open chain``.
    title, reference : str
        What it is, and who described it.
    limbs : int
        Joints that are commanded, n_q.
    part : str
        What one of its limbs is called: ``limb``, ``tower``, ``leg``, ``joint``.
    joint_unit : str
        ``rad`` or ``mm``; of joints of both kinds one each, with commas.
    layers : (int, int)
        On which side of the base a workspace begins, and which way it goes on.
    platform : tuple of str
        The coordinates of a body in space, of `COORDINATES`, that the platform moves along.
    asks : tuple of str
        Those that a command asks for.
    widths : tuple of int
        Columns that targets may have: 3, positions; `POSE`, poses.
    many_ways : bool
        Whether joints do not follow from where the platform is: a command then starts from joints, how the drawing
        would stand, and poses are chosen among joints.
    looped : bool
        Whether limbs close loops, so that positions of the platform may be singular.
    linked : bool
        Whether its robot files list its links one by one.
    weighed_by : str
        What a robot file must hold for weights to load it, in words; "" where that is its table [masses].
    written_out : bool
        Whether the command of one pose exists as compiled code and as C.
    axes, turns : tuple of str
        Along and about which axes of {O} the platform moves.
    geometry, parameters : tuple of GeometryKey, of Parameter
        Nominal dimensions, and source errors in the order of every vector of them.
    errors, common, deflections : tuple of str
        Source errors of a limb, those that all limbs share, displacements of a limb that vanish on a rigid machine.
    models : dict
        Names of parameters by the name of the model.
    """

    name: str
    machine: str
    sort: str
    title: str
    reference: str
    limbs: int
    part: str
    joint_unit: str
    layers: tuple[int, int]
    platform: tuple[str, ...]
    asks: tuple[str, ...]
    widths: tuple[int, ...]
    many_ways: bool
    looped: bool
    linked: bool
    weighed_by: str = ""
    written_out: bool
    axes: tuple[str, ...]
    turns: tuple[str, ...]
    geometry: tuple[GeometryKey, ...]
    parameters: tuple[Parameter, ...]
    errors: tuple[str, ...]
    common: tuple[str, ...]
    deflections: tuple[str, ...]
    models: dict[str, tuple[str, ...]]

    def __repr__(self) -> str:
        return f"<Machine {self.name}: {len(self.parameters)} source errors>"

    @property
    def joint_units(self) -> tuple[str, ...]:
        """Unit of each joint, rad or mm."""
        return tuple(of_joints(self.joint_unit, self.limbs))

    @property
    def n_x(self) -> int:
        """Directions in which a body in space can move: three shifts, three turns."""
        return len(COORDINATES)

    @property
    def turning(self) -> bool:
        """Whether a command may say how the platform is turned."""
        return any(name[0] == "c" for name in self.asks)

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
        if full == self.rigid_model:
            return ()
        if full not in self.models:
            import difflib  # for the message alone

            near = difflib.get_close_matches(full, self.models, n=1)
            hint = f" Did you mean {near[0]}?" if near else ""
            raise UnknownModel(f"{self.name} has no model '{name}'; it has {', '.join(self.models)}.{hint}")
        return self.models[full]

    @property
    def rigid_model(self) -> str:
        """The model in which no source error is free, for readings that see none."""
        return self.full_name("0")

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
            raise WrongArray(f"errors have the shape {np.shape(errors)}; ({n},) or (M, {n}) was expected.")
        return values

    # ------------------------------------------------------------------------------------ what a robot file says of it

    @abstractmethod
    def scaling(self, convention: str, robot: Robot, names: Sequence[str]) -> Array:
        """Return the factors (n,) by which columns are divided in a convention of the paper, angles in rad.

        Raises
        ------
        UsageError
            There is no such convention for this machine.
        """

    def has_scaling(self, convention: str, robot: Robot) -> bool:
        """Tell whether a paper gives the columns of this machine another scale."""
        try:
            self.scaling(convention, robot, ())
        except UsageError:
            return False
        return True

    @abstractmethod
    def rows(self, robot: Robot, errors: Array | None = None, deflections: Array | None = None) -> Array:
        """Return the rows of parameters that the kernels read, (M, limbs or links, n), of M machines.

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

    def column(self, name: str) -> int:
        """Return where an error or a deflection stands in a limb's row of parameters."""
        return len(self.geometry) + (*self.errors, *self.common, *self.deflections).index(name)

    @abstractmethod
    def same_as(self, robot: Robot, key: str) -> tuple[str, ...]:
        """Return the errors, one a limb or link or the one of all, that a dimension of the robot file is part of."""

    @abstractmethod
    def roles(self, robot: Robot) -> dict[str, Array]:
        """Return the lengths that effects read, one value per limb or one for all [mm]."""

    @abstractmethod
    def moves(self, robot: Robot) -> dict[str, dict[str, Array]]:
        """Return what effects move in a limb: {part: {error or deflection: how much of it}}.

        How much is a matrix (rows of parameters, limbs): of the error in each row by the part in each limb.
        """

    @abstractmethod
    def limb_inertia(self, robot: Robot, masses: Mapping[str, float]) -> Array:
        """Return a limb's own inertia about its centre of mass, which turns with the joint [kg mm^2]."""

    @property
    @abstractmethod
    def weighs(self) -> bool:
        """Whether the mechanism says where weights act; without them nothing loads it, not even a payload."""

    # --------------------------------------------------------------------------------------------------- kernels

    @cached_property
    def compiled(self) -> ModuleType:
        """The Numba kernels; the first use loads Numba and, once per mechanism, compiles."""
        return importlib.import_module(f"deltacal_kernels.{self.name}.kinematics")

    @cached_property
    def vectorised(self) -> ModuleType:
        """The same kernels in plain NumPy."""
        return importlib.import_module(f"deltacal_kernels.{self.name}.vectorised")

    def _kernels(self, poses: int) -> ModuleType:
        """Return the kernels for a call over so many poses."""
        return self.compiled if backend.chosen(poses) is Backend.COMPILED else self.vectorised

    # -------------------------------------------------------------------------------------------------- kinematics

    @property
    def servo(self) -> ModuleType:
        """Commands of one pose, for loops that Numba compiles.

        Raises
        ------
        UsageError
            The machine is not `written_out`.
        """
        raise NotForThisMachine(f"the commands of {self.sort} are not written out.")

    def constants(self, rows: Array) -> Array:
        """Return what no joint and no target changes, as the C source reads it; raises as `servo`."""
        raise NotForThisMachine(f"the commands of {self.sort} are not written out.")

    @abstractmethod
    def compile(self) -> Iterator[tuple[str, float]]:
        """Compile all kernels, or load them from Numba's cache; yield each one's name and how long it took [s]."""

    @abstractmethod
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

    @abstractmethod
    def positions(self, q: Array, tool: Array, rows: Array, *, out: Array | None = None) -> Array:
        """Return the exact positions (N, 3) of the reference point [mm], NaN where not solved; see `forward`."""

    @abstractmethod
    def frames(self, q: Array, rows: Array) -> tuple[Array, Array]:
        """Return the frames from the base to the platform: origins (N, n, 3) [mm] and rotations (N, n, 3, 3)."""

    @abstractmethod
    def inverse(
        self, target: Array, tool: Array, rows: Array, limits: Array | None = None, *, out: Array | None = None
    ) -> tuple[Array, Array, np.ndarray]:
        """Return the joints that bring the reference point exactly to targets.

        Parameters
        ----------
        target : (N, 3) or (N, 12) array
            Positions [mm] or poses, as `widths` allows; what the machine is not `asked` is not looked at. A position
            asks a platform that turns on command to stay level, as the axes of {O}.
        limits : (n_q, 2) array, optional
            Of the joints, where a machine can stand in many ways.
        out : (N, n_q) array, optional
            Where the joints are written.

        Returns
        -------
        q : (N, n_q) array
        x : (N, 12) array
            The pose the platform then has.
        status : (N,) int array

        Raises
        ------
        UsageError
            A position alone does not say how the machine shall stand.
        """

    @abstractmethod
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

        Parameters
        ----------
        target : (N, 3) or (N, 12) array
            See `inverse`.
        near : (N, n_q) array, optional
            Joints to start from, where the machine has `many_ways`.
        rows, drawn : (1, limbs, n) arrays
            Of the machine and, where that is another one, of the machine as drawn.
        reach : callable, optional
            A machine with effects as it stands, and its status (N,), at joints of some targets, given by their index.
        together : bool
            Whether none is done before all are: an effect remembers how the machine came where it is.
        """

    @abstractmethod
    def stated(self, target: Array) -> Array:
        """Return the coordinates that a command states of targets, as the kernels of one command take them."""

    @abstractmethod
    def asked(self, motion: Array) -> Array:
        """Return what a command asks for of motions: shifts (N, 3, ...), or shifts and turns (N, 6, ...).

        A shift alone is one without a turn. As many rows as there are joints, or all where a machine has `many_ways`.
        """

    @abstractmethod
    def undo(self, moved: Array, x: Array, q: Array, tool: Array, rows: Array, *, out: Array | None = None) -> Array:
        """Return the change of the joints (N, n_q) that undoes a small displacement (N, 3) or (N, 6) of poses."""

    def missed(self, x: Array, target: Array) -> Array:
        """Return how far poses (N, 12) lie off targets (N, 3) or (N, 12), along what a command asks for [mm, rad]."""
        shift = x[:, :3] - target[:, :3]
        if target.shape[1] == 3:
            return self.asked(shift)
        turn = x[:, 3:].reshape(-1, 3, 3) @ np.swapaxes(target[:, 3:].reshape(-1, 3, 3), 1, 2)
        return self.asked(np.hstack([shift, to_vector(turn)]))

    @abstractmethod
    def jacobians(
        self, x: Array, q: Array, tool: Array, rows: Array, *, out: Sequence[Array] | None = None
    ) -> tuple[Array, Array, Array, Array]:
        """Return closure and Jacobians F (N, f), J_x (N, f, f), J_q (N, f), J_p (N, f, n_e + n_s + n_d).

        J_x holds the coordinates in `platform`. A row depends on the joint, errors and deflections of its own limb
        only, and on the common errors; J_q and J_p hold those columns.

        Raises
        ------
        UsageError
            The machine is not `looped`.
        """

    @abstractmethod
    def sensitivity(
        self, x: Array, q: Array, tool: Array, rows: Array, *, out: tuple[Array, Array] | None = None
    ) -> Sensitivity:
        """Return the derivatives of the exact pose at N solved poses; NaN where a pose is singular."""

    def joint_sensitivity(self, poses: int) -> Sensitivity:
        """Return what stands for `sensitivity` where joints are looked at: each moves itself alone."""
        n = self.limbs
        own, common, bent = (np.zeros((poses, n, n, len(e))) for e in (self.errors, (), self.deflections))
        whole = np.zeros((poses, n, len(self.parameters)))
        return Sensitivity(own, common, bent, np.tile(np.eye(n), (poses, 1, 1)), whole)

    # ------------------------------------------------------------------------------------------------------- loads

    def loads(
        self,
        x: Array,
        q: Array,
        tool: Array,
        rows: Array,
        masses: Mapping[str, float],
        fields: Array,
        payload: Array | float = 0.0,
        limbs: Sequence[int] = (),
        *,
        out: Sequence[Array] | None = None,
    ) -> Loads:
        """Return what weights exert in the machine, by virtual work.

        Parameters
        ----------
        masses : mapping
            The mechanism's masses [kg] and positions of centres of mass; those not given are 0.
        fields : (3,) or (N, weights, 3) array
            Acceleration that acts on the weights [m/s^2]: gravity in {O}, or minus their own (see `weights_at`).
        payload : float or (N,) array
            At the reference point [kg].
        limbs : sequence of int
            Whose pulls are wanted, from 1: where they take more than the torques, those of others are zero.
        out : sequence of arrays, optional
            Where they are written, as `Loads` has them.
        """
        q, payload = self._poses(q, self.limbs, "joints"), np.broadcast_to(np.asarray(payload, dtype=float), len(q))
        return Loads.written(out, *self._loads(x, q, tool, rows, Weights(masses, fields, payload, limbs)))

    @abstractmethod
    def _loads(self, x: Array, q: Array, tool: Array, rows: Array, given: Weights) -> tuple[Array, ...]:
        """Return the arrays of `Loads`."""

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

    @abstractmethod
    def weights_at(
        self, x: Array, q: Array, tool: Array, rows: Array, masses: Mapping[str, float], *, out: Array | None = None
    ) -> Array:
        """Return where the weights are, (N, weights, 3) [mm], in the order of the fields of `loads`."""

    # --------------------------------------------------------------------------------------------- shapes of arrays

    def targets(self, values: Array) -> Array:
        """Return targets of a width that the machine takes.

        Raises
        ------
        UsageError
            Positions, which do not say how the machine shall stand.
        ValueError
            No machine takes targets of this shape.
        """
        out = np.ascontiguousarray(values, dtype=float)
        if out.ndim != 2 or out.shape[1] not in {3, *self.widths}:
            wanted = " or ".join(f"(N, {n})" for n in self.widths)
            raise ValueError(f"targets have the shape {out.shape}, but must have {wanted}.")
        if out.shape[1] not in self.widths:
            raise NotForThisMachine(
                f"a position alone does not say how {self.sort} shall stand. "
                "Give joints, or the rotation too: rx_deg, ry_deg, rz_deg."
            )
        return out

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
