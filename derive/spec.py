"""What a machine and an instrument *are*, in symbols: the frozen descriptions that every other stage reads.

Nothing here computes; the constructors only refuse what cannot be meant (an undeclared symbol, a name twice,
a quantity without a meaning).
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import sympy as sp

from derive.graph import Steps, expand_steps

UNITS = ("mm", "rad", "1")
COLUMN_UNITS = ("_mm", "_deg", "_px", "_{unit}")  # of readings
COORDINATES = ("px", "py", "pz", "cx", "cy", "cz")  # of a body in space: position, Cayley vector of its rotation


@dataclass(frozen=True)
class Quantity:
    """A symbol with what a reader needs to use it.

    Parameters
    ----------
    symbol : sympy.Symbol
        As it stands in the equations.
    unit : {"mm", "rad", "1"}
        Internal unit.
    meaning : str
        One line.
    typical : float, optional
        Size of an ordinary manufacturing or assembly error, in `unit`. It scales columns, so that a rank or a
        condition number compares like with like; it never enters an equation.
    label : str, optional
        Public name where the symbol's is taken (the error `L` of the length `L`). In the name of a limb's error ``{i}``
        stands for the limb, which otherwise follows the name: ``bx_{i}1`` is ``bx_21`` of limb 2.
    """

    symbol: sp.Symbol
    unit: str
    meaning: str
    typical: float = 1.0
    label: str = ""

    def __post_init__(self) -> None:
        if self.unit not in UNITS:
            raise ValueError(f"{self.symbol}: unit '{self.unit}' is none of {UNITS}.")
        if not self.meaning:
            raise ValueError(f"{self.symbol} has no meaning in its table; add one line.")

    @property
    def name(self) -> str:
        """Public name, ``{i}`` in it standing for the limb."""
        return self.label or str(self.symbol)

    def name_of(self, limb: int) -> str:
        """Return the name of a limb's own one, counted from 1."""
        return self.name.replace("{i}", str(limb)) if "{i}" in self.name else f"{self.name}_{limb}"


@dataclass(frozen=True)
class GeometryKey:
    """A nominal dimension: the robot file's key and the symbol that a limb sees.

    Parameters
    ----------
    key : str
        As the robot file names it.
    quantity : Quantity
    table : str
        Table of the robot file.
    per_limb : bool
        Whether every limb has its own value (one number in the file stands for all).
    default : tuple of float, optional
        Internal unit, one value per limb: makes the key optional.
    positive : bool
        Whether it is a length, which cannot be zero or negative; a coordinate can.
    entry : int, optional
        Which entry of a vector in the robot file (``home = [x, y, z]``) it is.
    """

    key: str
    quantity: Quantity
    table: str = "geometry"
    per_limb: bool = False
    default: tuple[float, ...] | None = None
    positive: bool = True
    entry: int | None = None


@dataclass(frozen=True)
class Weight:
    """A mass and the point where it acts; `mass` is one of the mechanism's mass symbols."""

    mass: sp.Expr
    point: sp.Matrix


OWN = sp.Symbol("own", real=True)  # a limb's own inertia about its centre of mass [kg mm^2]
SHARE = sp.Symbol("share", real=True)  # of a rod's mass that moves like either of its ends; the rest like its middle


@dataclass(frozen=True)
class Inertial:
    """An inertial parameter of a body, as points with masses that do the same where the parameter is 1.

    Parameters
    ----------
    name : str
        As results call it; of a limb ``name_i``.
    unit : str
    meaning : str
    points : tuple of (mass, point)
        Masses are constants or expressions in the geometry; they may be negative, as of a first moment.
    stated : sympy.Expr, optional
        What the robot file says of it, in terms of the masses, of the geometry and of `OWN`; None of a payload.
    """

    name: str
    unit: str
    meaning: str
    points: tuple[tuple[sp.Expr, sp.Matrix], ...]
    stated: sp.Expr | None = None


@dataclass(frozen=True, eq=False)
class LimbMechanism:
    """A platform carried by equal limbs with one joint each, written once for limb i.

    The closure of limb i reads ``loop_closure(x, q_i, tool, p_i) = 0``: `x` the platform, `q_i` the limb's joint, `p_i`
    the limb's own row of parameters: nominal geometry, source errors, deflections. Everything else follows by
    differentiation.

    Parameters
    ----------
    platform : tuple of Quantity
        What the closures solve for, as many as there are closures. Named after the six coordinates of a body in
        space, ``px py pz`` (position of the reference point) and ``cx cy cz`` (Cayley vector of its rotation); those
        that the machine cannot move are left out and are zero. The first ones, as many as there are joints, are what
        a command asks for.
    tool : tuple of Quantity
        Reference point in {O'}, ``tx ty tz``.
    joint : Quantity
    geometry : tuple of GeometryKey
    errors : tuple of Quantity
        Source errors of one limb, actual minus nominal; in the model of all parameters, ``name_i``.
    common : tuple of Quantity
        Source errors that all limbs share; in the model of all parameters, ``name``.
    deflections : tuple of Quantity
        Displacements that vanish on a rigid machine: where physics that the geometry leaves out may act.
    steps : sequence of (symbol, expression)
        Named intermediate quantities, each in terms of earlier ones: the derivation as a human writes it down.
    loop_closure : tuple of sympy.Expr
        One equation per rod, in mm^2 or mm, in terms of the steps.
    small : tuple of sympy.Symbol
        Errors set to zero for the closed-form seeds of Newton's method; the seeds keep the others.
    limb_weights, platform_weights : tuple of Weight
    limb_inertials, platform_inertials : tuple of Inertial
        What there is to know of the bodies in motion; none where the dynamics are not derived.
    masses : tuple of Quantity
        Mass symbols (kg) and dimensionless positions of centres of mass.
    elbow, assembly : {+1, -1}
        Which of the two closed-form inverse (forward) solutions is the machine's; `elbow` may be an expression of the
        limb's geometry, where the limbs differ.
    seeds : mapping, optional
        Platform coordinates in terms of the joint and its limb's parameters, and the joint in terms of the commanded
        ones: closed-form positions of the simplified machine of one limb, which is no sphere (circle) about its joint.
    home : mapping, optional
        Platform coordinates in terms of geometry and tool, zero where left out: where Newton's method begins a forward
        position that has no closed form, as that of every machine whose platform turns on command.
    roles : mapping
        Lengths that effects read (``derive.language.states``: L, l, b) in terms of the geometry.
    moves : mapping
        What effects move in a limb (``derive.language.targets.PARTS``), each as a sum of this machine's errors and
        deflections: {part: {name: how much of it}}. An effect applies to a machine that has all parts it moves.
    rods : tuple of str
        The errors that lengthen a limb's rods: their conjugate loads are the tensions.
    layers : (int, int)
        Where the layers of the workspace lie along z (y of a planar machine): the first at ``layers[0] * top``, the
        others from there towards ``layers[1]``. (-1, -1): below the base; (1, -1): above a bed, counted downwards.
    rods_per_closure : int
        How many equal rods share the pull of one closure, where a parallelogram is written as a single rod.
    limb_inertia : sympy.Expr
        A limb's own inertia that turns with the joint, about its centre of mass [kg mm^2].
    models : mapping
        Name of each model to the names of its parameters; the first stands for the whole machine.
    scalings : mapping
        Convention to {error name: factor}, by which a column of that error is *divided*; expressions in the geometry.
    of : str
        Name of the mechanism whose robot files this is another description of: the same geometry, other source errors.
        Its models are named after that mechanism.
    drawing : mapping
        Tables of a robot file [mm, deg] of an ordinary machine, with its workspace: what shared tests and reports look
        at where none of the package's examples is of this mechanism.
    """

    name: str
    title: str
    reference: str
    source: str
    limbs: int
    platform: tuple[Quantity, ...]
    tool: tuple[Quantity, ...]
    joint: Quantity
    geometry: tuple[GeometryKey, ...]
    errors: tuple[Quantity, ...]
    deflections: tuple[Quantity, ...]
    steps: Steps
    loop_closure: tuple[sp.Expr, ...]
    small: tuple[sp.Symbol, ...]
    masses: tuple[Quantity, ...]
    limb_weights: tuple[Weight, ...]
    platform_weights: tuple[Weight, ...]
    elbow: sp.Expr | int
    assembly: int
    models: Mapping[str, tuple[str, ...]]
    common: tuple[Quantity, ...] = ()
    seeds: Mapping[sp.Symbol, sp.Expr] | None = None
    home: Mapping[sp.Symbol, sp.Expr] | None = None
    limb_inertials: tuple[Inertial, ...] = ()
    platform_inertials: tuple[Inertial, ...] = ()
    roles: Mapping[str, sp.Expr] = field(default_factory=dict)
    moves: Mapping[str, Mapping[str, sp.Expr]] = field(default_factory=dict)
    rods: tuple[str, ...] = ()
    layers: tuple[int, int] = (-1, -1)
    rods_per_closure: int = 1
    limb_inertia: sp.Expr = field(default_factory=lambda: sp.Integer(0))
    scalings: Mapping[str, Mapping[str, sp.Expr]] = field(default_factory=dict)
    of: str = ""
    drawing: Mapping[str, Mapping[str, object]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        if stray := [q.name for q in self.platform if q.name not in COORDINATES]:
            raise ValueError(f"{self.name}: {stray} are no coordinates of a body; they are named {COORDINATES}.")
        closures = self.limbs * len(self.loop_closure)
        if len(self.platform) != closures:
            raise ValueError(f"{self.name}: {closures} closures cannot hold {len(self.platform)} coordinates.")
        if self.seeds is not None and (self.limbs > 1 or self.home is not None):
            raise ValueError(f"{self.name}: seeds are closed-form positions of one limb; give home for several.")
        turning = [q.name for q in self.platform[: self.commanded] if q.name[0] == "c"]
        if turning and self.home is None:
            raise ValueError(
                f"{self.name}: a command turns the platform ({', '.join(turning)}), so that its forward position has "
                "no closed form. Say where it is at home: home = {coordinate: expression}."
            )
        if turning and self.commanded < len(self.platform):
            raise ValueError(f"{self.name}: a command that turns the platform asks for all of its coordinates.")
        declared = [q.symbol for q in (*self.platform, *self.tool, self.joint, *self.limb_parameters)]
        names = [str(s) for s in declared]
        for name in names:
            if names.count(name) > 1:
                raise ValueError(f"{self.name}: the symbol '{name}' is declared twice.")
        for equation in self.loop_closure:
            unknown = sorted(str(s) for s in expand_steps(equation, self.steps).free_symbols - set(declared))
            if unknown:
                raise ValueError(
                    f"{self.name}: the loop closure uses {', '.join(unknown)}, which no table declares. "
                    "Add it with a unit and a meaning."
                )
        known = set(self.parameter_names)
        for model, chosen in self.models.items():
            if missing := [n for n in chosen if n not in known]:
                raise ValueError(f"{self.name}: model {model} asks for {missing}, which are no parameters.")

    @property
    def limb_parameters(self) -> tuple[Quantity, ...]:
        """One limb's row of parameters: geometry, errors, common errors, deflections, in this order."""
        return (*(g.quantity for g in self.geometry), *self.varied)

    @property
    def varied(self) -> tuple[Quantity, ...]:
        """What a limb's closure is differentiated by: its errors, the common ones, deflections."""
        return (*self.errors, *self.common, *self.deflections)

    @property
    def commanded(self) -> int:
        """How many platform coordinates a command asks for, the first ones: as many as there are joints."""
        return self.limbs

    @property
    def turning(self) -> bool:
        """Whether a command says how the platform is turned."""
        return any(q.name[0] == "c" for q in self.platform[: self.commanded])

    @property
    def parameter_names(self) -> tuple[str, ...]:
        """The model of all source errors: limb by limb, then the common ones."""
        own = (e.name_of(i) for i in range(1, self.limbs + 1) for e in self.errors)
        return (*own, *(e.name for e in self.common))


@dataclass(frozen=True)
class Screw:
    """A turn about an axis of the present frame and a shift along it, either of which may be zero."""

    axis: str
    turn: sp.Expr
    shift: sp.Expr


@dataclass(frozen=True, eq=False)
class ChainMechanism:
    """An open chain, written once for a link; the runtime composes links as the robot file lists them.

    Parameters
    ----------
    joint : tuple of Quantity
        Variable of a turning and of a sliding joint; a link reads one of them, the other is zero.
    geometry : tuple of GeometryKey
        Nominal dimensions of a link.
    errors : tuple of Quantity
        Source errors of a link, actual minus nominal; in the model of all parameters, ``name_i``.
    tool : tuple of Quantity
        Reference point in the last frame, ``tx ty tz``.
    common : tuple of Quantity
        Source errors of the tool, one along each of its coordinates.
    transforms : mapping
        Convention to the screws, in terms of the steps, that lead from the frame before the link to its own.
    steps : sequence of (symbol, expression)
        What nominal dimension, error and joint add up to.
    """

    name: str
    title: str
    reference: str
    source: str
    joint: tuple[Quantity, Quantity]
    geometry: tuple[GeometryKey, ...]
    errors: tuple[Quantity, ...]
    tool: tuple[Quantity, ...]
    common: tuple[Quantity, ...]
    transforms: Mapping[str, tuple[Screw, ...]]
    steps: Steps

    @property
    def link_parameters(self) -> tuple[Quantity, ...]:
        """A link's row of parameters: geometry, source errors, then those of the tool, the same in every row."""
        return (*(g.quantity for g in self.geometry), *self.errors, *self.common)


@dataclass(frozen=True)
class Platform:
    """What a measurement sees of a machine: a body in space.

    Parameters
    ----------
    position : sympy.Matrix
        Reference point in {O}, (3, 1).
    rotation : sympy.Matrix
        From the platform's frame to {O}, (3, 3).
    turn : sympy.Matrix
        A small rotation vector about the axes of {O}, (3, 1), by which derivatives are taken: the body's rotation is
        ``cayley(turn) * rotation`` at ``turn = 0``.
    """

    position: sp.Matrix
    rotation: sp.Matrix
    turn: sp.Matrix

    @property
    def coordinates(self) -> tuple[sp.Symbol, ...]:
        """The twelve numbers of a pose, as they stand in a row of x: position, rotation row by row."""
        return (*self.position, *self.rotation)

    @property
    def displacement(self) -> tuple[sp.Symbol, ...]:
        """The six directions of a derivative: shift of the reference point, turn about the axes of {O}."""
        return (*self.position, *self.turn)

    @property
    def shown(self) -> str:
        """What stands in a row of x, in words."""
        return "poses x (N, 12), position and rotation matrix"


@dataclass(frozen=True)
class Joint:
    """What a measurement sees of a machine that looks at one of its joints: how far the joint has moved.

    Parameters
    ----------
    moved : sympy.Symbol
        As the geometry sees it.
    """

    moved: sp.Symbol

    @property
    def coordinates(self) -> tuple[sp.Symbol, ...]:
        """The only number in a row of x."""
        return (self.moved,)

    @property
    def displacement(self) -> tuple[sp.Symbol, ...]:
        """The direction of a derivative."""
        return (self.moved,)

    @property
    def turn(self) -> tuple[sp.Symbol, ...]:
        """No body that turns is looked at."""
        return ()

    @property
    def shown(self) -> str:
        """What stands in a row of x, in words."""
        return "joints x (N, 1)"


@dataclass(frozen=True)
class Measurement:
    """What an instrument reports of the platform, and what of the instrument itself is unknown.

    Parameters
    ----------
    platforms : tuple of Platform or Joint
        What one reading depends on: one platform, or two for a distance between poses; or one joint.
    given : tuple of Quantity
        The present state of the instrument, in terms of which its unknowns are increments.
    unknown : tuple of Quantity
        The instrument's own parameters: increments of its state, evaluated at zero. Their `typical` size is by how much
        an ordinary instrument is mounted off, where a simulation draws one.
    reading : tuple of sympy.Expr
        The predicted reading.
    rotation : tuple of sympy.Matrix
        A measured rotation as a product of rotations (3, 3). Its derivatives are the spins ``axial(dR R^T)``: three
        more rows of the Jacobians.
    steps : sequence of (symbol, expression)
        Named quantities between the platform and the reading, none in terms of another.
    after : sequence of sympy.Expr
        The instrument's state after a step of its unknowns, in the order of `given`: with it and no step the reading is
        the same as before it with the step.
    columns : tuple of str
        Of recordings, one per row of the reading, rotations behind values; the ending says the unit: ``_mm``, ``_deg``
        or ``_px``. Of a joint ``{i}`` stands for its number and ``{unit}`` for its unit.
    known : tuple of Quantity
        What a recording tells of each reading beside what the instrument read: where on a board the point lies. The
        label is the column.
    targets : mapping
        What effects on the reading move, as they call it, and which value that is: ``{"length": 0}``.
    start : sequence of float
        The state from which the instrument's readings find it, where no file in ``instrument/kinds`` knows better.
    scale : float
        What one unit of a value (rad or px) is at the platform [mm], where no such file knows better; lengths count as
        they are.
    """

    name: str
    meaning: str
    source: str
    platforms: tuple[Platform | Joint, ...]
    given: tuple[Quantity, ...]
    unknown: tuple[Quantity, ...]
    reading: tuple[sp.Expr, ...]
    rotation: tuple[sp.Matrix, ...] = ()
    steps: Steps = ()
    after: tuple[sp.Expr, ...] = field(default=(), kw_only=True)
    columns: tuple[str, ...] = field(kw_only=True)
    known: tuple[Quantity, ...] = field(default=(), kw_only=True)
    targets: Mapping[str, int] = field(default_factory=dict, kw_only=True)
    start: tuple[float, ...] = field(default=(), kw_only=True)
    scale: float = field(default=1.0, kw_only=True)

    def __post_init__(self) -> None:
        rows = len(self.reading) + 3 * bool(self.rotation)
        if len(self.columns) != rows:
            raise ValueError(f"{self.name}: {len(self.columns)} columns for the {rows} rows of a reading.")
        for column in self.columns:
            if not column.endswith(COLUMN_UNITS):
                raise ValueError(f"{self.name}: the column '{column}' ends in none of {', '.join(COLUMN_UNITS)}.")
        declared = [str(q.symbol) for q in (*self.given, *self.unknown, *self.known)]
        if twice := [name for name in declared if declared.count(name) > 1]:
            raise ValueError(f"{self.name}: the symbol '{twice[0]}' is declared twice.")
        if self.unknown and len(self.after) != len(self.given):
            raise ValueError(f"{self.name}: `after` gives {len(self.after)} of {len(self.given)} entries of the state.")
        if self.start and len(self.start) != len(self.given):
            raise ValueError(f"{self.name}: `start` gives {len(self.start)} of {len(self.given)} entries of the state.")
        if beyond := [target for target, row in self.targets.items() if not 0 <= row < len(self.reading)]:
            raise ValueError(f"{self.name}: the target '{beyond[0]}' is no value of the reading.")
