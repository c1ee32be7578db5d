"""Commands of one pose: the limbs of a machine side by side, where a batch has its poses.

A servo loop asks for one command at a time. What is the same for every limb runs in one loop over the limbs, which the
compiler turns into SIMD code as it does with the poses of a batch; what couples them is solved in closed form. All of
it lies in one flat array ``w`` at offsets known when the kernels are written: target, what the machine is, scratch.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import sympy as sp

from derive.backends.ir import Kernel, Place
from derive.blocks import FAR, equations, felt, held, motion, of_rows, rotation_steps
from derive.closed_form import inverse_joint, start_of_inverse
from derive.first_order import first_order, to_all_errors, vanishing
from derive.graph import Graph, collected
from derive.mathematics.functions import Functions, entries
from derive.spec import LimbMechanism

UNIT = 4  # places: every group of quantities begins at a multiple


@dataclass(frozen=True)
class Servo:
    """Functions of one kind of command, and where their quantities stand in ``w``.

    Attributes
    ----------
    functions : tuple of Functions
        `joint`: the joint at the target; `angle`: cosine and sine of a given joint; `rows`: a limb's
        equations; these run for every lane. `solution` of all limbs; `move` of the platform, where its place is solved
        for; `constants`, whose number is known when they are lowered.
    at : mapping
        First place of ``x`` (platform, the target first), ``R``, ``tool``, ``sign`` and ``change`` (of joints, then of
        the platform, then how far the equations are from dependent), which stand one after the other; of ``q``,
        ``angle``, ``rows`` and ``k``, each of which takes a place for every lane.
    lanes : int
        Places that a quantity of every limb takes: their number, or the next power of two.
    felt : int
        Place in ``rows`` of how far a limb's equation is from not feeling its joint; -1 where nothing says so.
    checked : bool
        Whether the last of ``change`` says how far the equations of all limbs are from dependent.
    """

    functions: tuple[Functions, ...]
    at: Mapping[str, int]
    lanes: int
    felt: int
    checked: bool

    def size(self, constants: int) -> int:
        """Return the length of ``w``, which ends with so many constants of a limb."""
        return self.at["k"] + _whole(constants * self.lanes)

    def reads_angle(self, kernel: Kernel) -> bool:
        """Tell whether a kernel reads cosine or sine of the joint."""
        places = range(self.at["angle"], self.at["angle"] + 2 * self.lanes, self.lanes)
        return any(load.place.lane and load.place.index in places for load in kernel.loads)


def _whole(count: int) -> int:
    return -(-count // UNIT) * UNIT


class _Layout:
    """Groups of places in ``w``."""

    def __init__(self, lanes: int) -> None:
        self.lanes, self.size = lanes, 0
        self.at: dict[str, int] = {}

    def take(self, name: str, count: int) -> None:
        self.at[name], self.size = self.size, self.size + _whole(count)

    def single(self, name: str, symbols: Sequence[sp.Symbol]) -> dict[sp.Symbol, Place]:
        return entries("w", symbols, self.at[name])

    def each(self, name: str, symbols: Sequence[sp.Symbol]) -> dict[sp.Symbol, Place]:
        return {s: Place("w", self.at[name] + j * self.lanes, lane=True) for j, s in enumerate(symbols)}


def _layout(mechanism: LimbMechanism, width: int) -> _Layout:
    limbs, n_x = mechanism.limbs, len(mechanism.platform)
    layout = _Layout(1 << (limbs - 1).bit_length())
    for name, count in {"x": n_x, "R": 9, "tool": 3, "sign": limbs, "change": n_x + 1}.items():
        layout.take(name, count)
    for name, count in {"q": 1 + n_x - limbs, "angle": 2, "rows": width}.items():
        layout.take(name, count * layout.lanes)
    return layout


def _solution(
    mechanism: LimbMechanism, layout: _Layout, rows: Sequence[Sequence[sp.Expr]], *, whole: bool
) -> Functions:
    """Return the solution of all limbs' equations for joints and, where `whole`, the rest of the platform.

    `rows` are a limb's equations: the value, its derivatives by the platform's coordinates that no command asks for and
    by the joint; what is zero in it is zero for every limb.
    """
    limbs, rods, n_c = mechanism.limbs, len(rows), mechanism.commanded
    f, n_x, width = limbs * rods, len(mechanism.platform), len(rows[0])
    F, J, J_q = sp.zeros(f, 1), sp.zeros(f, n_x), sp.zeros(f, 1)
    read: dict[sp.Symbol, Place] = {}
    for i in range(limbs):
        for j, row in enumerate(rows):
            names = sp.symbols([f"F{i}{j}", *(f"J{i}{j}_{c}" for c in range(n_c, n_x)), f"Q{i}{j}"], real=True)
            read |= {s: Place("w", layout.at["rows"] + (j * width + c) * layout.lanes + i) for c, s in enumerate(names)}
            value, *rest, joint = (s if e != 0 else sp.Integer(0) for s, e in zip(names, row, strict=True))
            at = j * limbs + i if rods == 2 else rods * i + j
            F[at], J_q[at] = value, joint
            for c, e in zip(range(n_c, n_x), rest, strict=True):
                J[at, c] = e
    steps, found = held(F, J, J_q, limbs, n_c, rods == 2)
    outputs = [found[j] if whole or j < limbs or j == n_x else None for j in range(len(found))]
    solution = Functions(Graph(steps), {}, read)
    solution.add("solution", f"changes that undo the closures while the target is kept{FAR}", outputs, dense=True)
    return solution


def linear(mechanism: LimbMechanism) -> Servo:
    """Return the linear compensator: the nominal joint, and the change that keeps the target to first order.

    Where the nominal joint is ``atan2(Y, X)`` its cosine and sine follow without it.
    """
    n_c, joint = mechanism.commanded, mechanism.joint.symbol
    platform = [quantity.symbol for quantity in mechanism.platform]
    errors = [quantity.symbol for quantity in mechanism.varied]
    steps, closures = to_all_errors(mechanism)
    shifted, shifts = first_order(mechanism, {str(s): {s: sp.Integer(1)} for s in platform[:n_c]})
    steps = [*steps, *(step for step in shifted if step not in steps)]
    closures = [rates | shift for rates, shift in zip(closures, shifts, strict=True)]
    by = {name: of_rows([rate[name] for rate in closures], steps) for name in closures[0]}
    free = [str(s) for s in (*platform[n_c:], joint)]
    if len(closures) == 2:  # what the difference of parallel rods does not feel
        by |= {name: [vanishing(e, steps) for e in by[name]] for name in free}
    rows = [[by["errors"][j], *(by[name][j] for name in free)] for j in range(len(closures))]
    layout = _layout(mechanism, len(rows) * len(rows[0]) + 1)

    angle = sp.symbols("cos_q sin_q", real=True)
    turned = dict(zip((sp.cos(joint), sp.sin(joint)), angle, strict=True))
    at_target = inverse_joint(mechanism).xreplace(dict.fromkeys(errors, sp.Integer(0)))
    outputs = [at_target]
    if isinstance(at_target, sp.atan2):
        y, x = at_target.args
        between = (layout.at["angle"] - layout.at["q"]) // layout.lanes - 1
        outputs += [None] * between + [x / sp.sqrt(x**2 + y**2), y / sp.sqrt(x**2 + y**2)]
    inputs = layout.single("x", platform[:n_c]) | layout.single("tool", [s.symbol for s in mechanism.tool])
    inputs |= layout.each("q", [joint]) | layout.each("angle", angle)
    parameters = entries("p", [quantity.symbol for quantity in mechanism.limb_parameters])
    steps = collected([(s, e.xreplace(turned)) for s, e in steps], parameters)
    functions = Functions(Graph(steps, invariant=parameters), parameters, inputs)
    feeling = [felt(rows[0][-1], sp.Matrix([by[str(s)][0] for s in platform[:n_c]]))] if len(rows) <= 2 else []
    functions.add("joint", "joint of the nominal limb at the target, its cosine and sine", outputs)
    functions.add("angle", "cosine and sine of the joint", [sp.cos(joint), sp.sin(joint)])
    functions.add(
        "rows",
        "equations of a nominal limb: change by all errors, derivatives by rotation and joint",
        [*(e.xreplace(turned) for row in rows for e in row), *feeling],
    )
    functions.constants("constants", "what no target changes")
    return _servo(functions, _solution(mechanism, layout, rows, whole=False), [], layout, mechanism, feeling)


def exact(mechanism: LimbMechanism) -> Servo:
    """Return Newton's method for joints and the platform's rotation at a target."""
    n_c, joint = mechanism.commanded, mechanism.joint.symbol
    platform = [quantity.symbol for quantity in mechanism.platform]
    full = equations(mechanism)
    rows = [[row[0], *row[1 + n_c :]] for row in full]
    layout = _layout(mechanism, len(rows) * len(rows[0]) + 1)
    inputs = layout.single("x", platform) | layout.single("R", list(rotation_steps(mechanism)))
    inputs |= layout.single("tool", [s.symbol for s in mechanism.tool]) | layout.each("q", [joint])
    parameters = entries("p", [quantity.symbol for quantity in mechanism.limb_parameters])
    functions = Functions(Graph(mechanism.steps, invariant=parameters), parameters, inputs)
    feeling = [felt(full[0][-1], sp.Matrix(full[0][1 : 1 + n_c]))] if len(rows) <= 2 else []
    functions.add(
        "joint",
        "joint of the simplified limb at the target, then the platform's coordinates that follow from it",
        start_of_inverse(mechanism),
    )
    functions.add(
        "rows",
        "equations of a limb, their derivatives by turns of the platform and by the joint",
        [*(e for row in rows for e in row), *feeling],
    )
    functions.constants("constants", "what no target changes")
    y = sp.symbols([f"y{j}" for j in range(len(platform))], real=True)
    step = {s: sp.Integer(0) for s in y[:n_c]}
    read = layout.single("x", platform)
    read |= entries("w", y[n_c:], layout.at["change"] + mechanism.limbs)
    steps, outputs = motion(mechanism, [step.get(s, s) for s in y])
    move = Functions(Graph(steps), {}, read)
    move.add("move", "the platform after a step, and its rotation matrix", outputs, dense=True)
    return _servo(functions, _solution(mechanism, layout, rows, whole=True), [move], layout, mechanism, feeling)


def _servo(
    functions: Functions,
    solution: Functions,
    further: Sequence[Functions],
    layout: _Layout,
    mechanism: LimbMechanism,
    feeling: Sequence[sp.Expr],
) -> Servo:
    layout.take("k", 0)
    checked = solution["solution"].length > len(mechanism.platform)
    felt = functions["rows"].length - 1 if feeling else -1
    return Servo((functions, solution, *further), layout.at, layout.lanes, felt, checked)
