"""A compensator as one C99 file, with the effects that were found.

The geometry of the C file is exact. What effects add is taken apart: an effect whose formula needs nothing but the
joint, the direction of approach, the temperature and the time stands in the file as it was derived; the others (loads,
growth of links) become *columns*, a polynomial over the workspace for every product of channels that they depend on, to
first order in each. The file states the error that it leaves against the exact machine, over the workspace and over
the channels as they were recorded.
"""

from __future__ import annotations

import importlib.resources
import itertools
import math
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from importlib.resources.abc import Traversable

import numpy as np

from deltacal_gen.identification.accuracy import turned, workspace_of
from deltacal_gen.machine.places import at
from deltacal_gen.machine.registry import COORDINATES, SOLVED, Array, Machine, mechanism_of
from deltacal_gen.machine.rotation import to_vector
from deltacal_gen.machine.values import Robot
from deltacal_gen.physics.terms import Term
from deltacal_gen.states import CHANNELS, STATES, State
from deltacal_gen.units import DEG, file_unit, to_internal
from deltacal_gen.use.compensation import Compensator, CompensatorKind, RoundTrip, largest, workspace_points
from deltacal_gen.use.spans import (
    LEFT_OUT,
    Column,
    Spans,
    channels_of,
    columns_of,
    drawn,
    factor,
    missed,
    shift,
    stated,
    tabled,
    taken_apart,
    tidy,
    unit_of,
)

FARTHEST = 1.1  # of the workspace's half size: where the polynomials end, and stay what they are there
DEGREE = 6  # of the polynomials over the workspace: 84 coefficients
TURNS = 12  # of the fixed point in C: an effect of the joint angle that steepens by a tenth is then known to 1e-12
NOT_A_NUMBER = 3  # a status, after those of the geometry
BUILD = """#include <float.h>
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || defined(_M_FP_FAST)
#error "built with -ffast-math, which drops the tests for what is out of reach and for what is no number"
#endif
#if DBL_DIG < 15
#error "double has fewer than 64 bits here: nothing would converge, or nothing be as exact as stated"
#endif
"""
_SOURCE = {CompensatorKind.EXACT: "inverse.c", CompensatorKind.LINEAR: "linear.c"}


@dataclass(frozen=True, eq=False)
class LiveEffects:
    """The effects of a C export: polynomials for the columns, and the effects that stand in it as they were derived.

    coefficients (columns, n_q, m) of the monomials `powers` (m, 3) in the `_places` of positions.
    """

    compensator: Compensator
    over: Spans
    columns: tuple[Column, ...]
    coefficients: Array
    powers: np.ndarray
    known: tuple[Term, ...]

    @staticmethod
    def of(compensator: Compensator, over: Spans) -> LiveEffects:
        """Return the effects of a compensator, fitted over the workspace and over spans of the channels."""
        powers = np.array([e for e in itertools.product(range(DEGREE + 1), repeat=3) if sum(e) <= DEGREE])
        known = tuple(t for t in compensator.effects if effect_source(t).is_file())
        others = [t for t in compensator.effects if not effect_source(t).is_file()]
        columns = columns_of(compensator, others, over)
        points = turned(compensator.robot, workspace_points(workspace_of(compensator.robot)))[::3]
        rigid = replace(compensator, terms=()).command(points)[0] * compensator.robot.joint_sign
        found = taken_apart(compensator, points, columns, over, known, rigid)
        solved = np.isfinite(found).all(axis=(1, 2))
        basis = np.prod(_places(compensator, points)[:, None, :] ** powers, axis=2)[solved]
        fitted = np.linalg.lstsq(basis, found[solved].reshape(solved.sum(), -1), rcond=None)[0]
        coefficients = np.moveaxis(fitted.reshape(len(powers), *found.shape[1:]), 0, 2)
        # a column that nothing goes with is rounding
        kept = [k for k, c in enumerate(coefficients) if np.abs(c).max(initial=0.0) > 1e-13]
        return LiveEffects(compensator, over, tuple(columns[k] for k in kept), coefficients[kept], powers, known)

    def command(self, points: Array, values: Mapping[str, Array | float]) -> Array:
        """Return joints (N, n_q) as the controller counts them [rad or mm], as the C file computes them."""
        sign = self.compensator.robot.joint_sign
        theta = replace(self.compensator, terms=()).command(points)[0] * sign
        basis = np.prod(_places(self.compensator, points)[:, None, :] ** self.powers, axis=2)
        for column, coefficients in zip(self.columns, self.coefficients, strict=True):
            theta = theta + np.reshape(factor(column, values), (-1, 1)) * (basis @ coefficients.T)
        at, q = channels_of(self.compensator, len(points), values), theta
        for _ in range(TURNS):
            q = theta - shift(self.compensator, q, at, self.known)
        return q * sign

    @cached_property
    def usual(self) -> tuple[dict[str, float], list[str]]:
        """Channels within what was recorded, to check by: by the names of columns, and as C writes the struct."""
        values: dict[str, float] = {}
        fields: list[str] = []
        for s in _fields(self.compensator):
            if s.per == "joint":
                names = s.columns(self.compensator.mechanism.joint_unit, self.compensator.mechanism.limbs)
                values |= dict.fromkeys(names, 1.0)
                fields.append(f".{_field(s)} = {{ {', '.join('1.0' for _ in names)} }}")
            else:
                scale, since = unit_of(s.name)[1], s.zero + (self.compensator.begun if s.passes else 0.0)
                most = self.over.items().get(s.name, (0.0, 0.0))[1]
                field = tidy(most * scale + since)
                values[s.name] = (field - since) / scale
                fields.append(f".{_field(s)} = {field!r}")
        return values, fields

    @cached_property
    def left(self) -> RoundTrip:
        """What the file leaves at random points of the workspace and random values of the channels."""
        points = turned(self.compensator.robot, workspace_points(workspace_of(self.compensator.robot)))
        values = drawn(self.compensator, self.over, len(points))
        error = missed(self.compensator, self.command(points, values), points, values)
        return RoundTrip(largest(error), len(points), int(np.isnan(error).sum()))


def _box(compensator: Compensator) -> tuple[Array, Array]:
    """Return the centre of the workspace and its half size, 1 mm where it has none, (3,) each."""
    centre, half = workspace_of(compensator.robot).box
    return centre, np.where(half > 0, half, 1.0)


def _places(compensator: Compensator, points: Array) -> Array:
    """Return where positions lie in the workspace, (N, 3) from -1 to 1; far beside it, what is nearest.

    A tenth beyond where it was fitted a polynomial errs by a few times what it leaves; farther on it grows without end.
    """
    centre, half = _box(compensator)
    place = (points[:, :3] - centre) / half
    if workspace_of(compensator.robot).radius is not None:
        place[:, :2] /= np.maximum(np.hypot(place[:, 0], place[:, 1]) / FARTHEST, 1.0)[:, None]
    return np.clip(place, -FARTHEST, FARTHEST)


def effect_source(term: Term) -> Traversable:
    """Return the C source of an effect's formula; it exists where a controller knows all that the effect reads."""
    return importlib.resources.files("deltacal_kernels").joinpath("effects", f"{term.effect}.c")


def c_source(compensator: Compensator, left: RoundTrip, live: LiveEffects | None = None) -> str:
    """Return the text of the C99 file that `export_c` writes; `compensator` is that of the geometry alone."""
    mechanism, kernels, robot = compensator.mechanism, compensator._kernels, compensator.robot
    body = importlib.resources.files("deltacal_kernels").joinpath(mechanism.name, _SOURCE[compensator.kind])
    constants = compensator._constants[0]
    if compensator.kind is CompensatorKind.EXACT:
        constants = constants[:, : kernels.COMMAND_CONSTANTS]
    limbs, unit = mechanism.limbs, file_unit(mechanism.joint_unit)
    values = "\n".join(f"    {{ {wrapped(row)} }}," for row in constants)
    numbers = (
        f"static const double DELTACAL_K[{limbs}][{constants.shape[1]}] = {{\n{values}\n}};\n"
        f"static const double DELTACAL_TOOL[3] = {{ {c_numbers(robot.tool)} }}; /* mm, reference point in {{O'}} */\n"
        f"static const double DELTACAL_SIGN[{limbs}] = {{ {c_numbers(robot.joint_sign)} }}; /* of the controller */\n"
    )
    comment = "\n".join(f" * {line}".rstrip() for line in _c_header(compensator, left, unit, live))
    text = f"/*\n{comment}\n */\n{BUILD}\n{numbers}\n{body.read_text(encoding='utf-8')}"
    return text if live is None else f"{text}\n{_c_command(live, unit)}"


def _c_command(live: LiveEffects, unit: str) -> str:
    """Return the function that adds what the effects ask for to the geometry's command."""
    mechanism, n = live.compensator.mechanism, len(live.columns)
    limbs, target = mechanism.limbs, f"target[{len(mechanism.asks)}]" if mechanism.turning else "target_mm[3]"
    files = dict.fromkeys(effect_source(t) for t in live.known)
    sources = [f.read_text(encoding="utf-8") for f in files]
    read = _fields(live.compensator)
    factors = {s.name: _c_factor(s, live.compensator) for s in read if s.per == "machine"}
    factors |= {
        s.column.format(i=i + 1): s.c99.format(i=i, sign="")
        for s in read
        for i in range(limbs if s.per == "joint" else 0)
    }
    body = [
        f"int deltacal_command(const double {target}, const struct deltacal_channels *at,",
        f"                     double joints_{unit}[{limbs}])",
        "{",
        f"    double theta[{limbs}], q[{limbs}];",
        f"    int i{', j, k' if n else ''}{', turn' if live.known else ''};",
        f"    const int status = deltacal_compensate({target.partition('[')[0]}, theta);",
        *([f"    double u[3][{DEGREE + 1}], by[{n}];"] if n else []),
        "    (void)(at);",
        "    if (status != DELTACAL_SOLVED)",
        "        return status;",
        f"    for (i = 0; i < {limbs}; i++)",
        "        theta[i] = DELTACAL_SIGN[i] * theta[i] / JOINT_PER_UNIT;",
    ]
    body += _c_smooth(live, factors) if n else []
    body += [f"    for (i = 0; i < {limbs}; i++)", "        q[i] = theta[i];"]
    body += _c_known(live) if live.known else []
    body += [
        f"    for (i = 0; i < {limbs}; i++)",
        "        if (!isfinite(q[i]))",
        "            return DELTACAL_NOT_A_NUMBER;",
        f"    for (i = 0; i < {limbs}; i++)",
        f"        joints_{unit}[i] = DELTACAL_SIGN[i] * q[i] * JOINT_PER_UNIT;",
        "    return DELTACAL_SOLVED;",
        "}",
    ]
    begun = f", and effects count it from {live.compensator.begun!r} on" if live.compensator.begun else ""
    interface = [
        f"#define DELTACAL_NOT_A_NUMBER {NOT_A_NUMBER}",
        "/*",
        " * What commands depend on beside the target. payload_kg is held at the reference point, time_s is read off",
        f" * the recording's clock{begun}. approach is the way",
        " * that a joint last moved, +1 or -1 as the controller counts; 0: not known, the middle of the play.",
        " */",
        "struct deltacal_channels {",
        *(f"    double {_field(s)}{f'[{limbs}]' if s.per == 'joint' else ''};" for s in read),
        "};",
    ]
    return "\n".join([*interface, "", *sources, *(_c_tables(live) if n else []), "", *body]) + "\n"


def _c_tables(live: LiveEffects) -> list[str]:
    """Return the polynomials by which the command changes with products of channels, as tables."""
    mechanism, n, m = live.compensator.mechanism, len(live.columns), len(live.powers)
    powers = ",\n      ".join(
        ", ".join(f"{{ {x}, {y}, {z} }}" for x, y, z in live.powers[j : j + 8]) for j in range(0, m, 8)
    )
    by_joint = (",\n".join(f"    {{ {wrapped(row)} }}" for row in column) for column in live.coefficients)
    rows = ",\n".join(f"    {{\n{text}\n    }}" for text in by_joint)
    unit = mechanism.joint_unit
    return [
        f"static const unsigned char DELTACAL_POWERS[{m}][3] = {{\n      {powers}\n}};",
        f"/* {unit}, per product of channels: polynomials of the position in units of the workspace */",
        f"static const double DELTACAL_COLUMNS[{n}][{mechanism.limbs}][{m}] = {{\n{rows}\n}};",
    ]


def _c_smooth(live: LiveEffects, factors: Mapping[str, str]) -> list[str]:
    """Return the lines that add the polynomials to the joints; `factors` are channels as C writes them."""
    limbs, n, m = live.compensator.mechanism.limbs, len(live.columns), len(live.powers)
    ends = zip(*(values.tolist() for values in _box(live.compensator)), strict=True)
    place = [f"(target_mm[{i}] - {c!r}) / {h!r}" for i, (c, h) in enumerate(ends)]
    rim = [
        f"    u[0][0] = fmax(sqrt(u[0][1] * u[0][1] + u[1][1] * u[1][1]) / {FARTHEST}, 1.0);",
        "    u[0][1] /= u[0][0];",
        "    u[1][1] /= u[0][0];",
    ]
    return [
        f"    {_c_each('u[{i}][1]', place)}",
        *(rim if workspace_of(live.compensator.robot).radius is not None else []),
        "    for (i = 0; i < 3; i++) {",
        "        u[i][0] = 1.0;",
        f"        u[i][1] = fmin(fmax(u[i][1], -{FARTHEST}), {FARTHEST}); /* of the workspace's half size */",
        f"        for (k = 2; k <= {DEGREE}; k++)",
        "            u[i][k] = u[i][k - 1] * u[i][1];",
        "    }",
        f"    {_c_each('by[{i}]', [' * '.join(factors[c] for c in column) or '1.0' for column in live.columns])}",
        f"    for (j = 0; j < {m}; j++) {{",
        "        const unsigned char *e = DELTACAL_POWERS[j];",
        "        const double part = u[0][e[0]] * u[1][e[1]] * u[2][e[2]];",
        f"        for (k = 0; k < {n}; k++)",
        f"            for (i = 0; i < {limbs}; i++)",
        "                theta[i] += by[k] * DELTACAL_COLUMNS[k][i][j] * part;",
        "    }",
    ]


def _c_known(live: LiveEffects) -> list[str]:
    """Return the lines that take off what effects move the joints by, which may depend on the joints."""
    limbs = live.compensator.mechanism.limbs
    lines = [f"    for (turn = 0; turn < {TURNS}; turn++) {{", f"        double moved[{limbs}] = {{ 0.0 }};"]
    for t in live.known:
        for row, limb in enumerate(t.limbs or range(1, limbs + 1)):
            s = ", ".join(_c_state(s, limb, live.compensator) for s in t.states)
            c = t.values[row if t.limbs else 0]
            constants = [v if isinstance(v, float) and math.isfinite(v) else 0.0 for v in t.constants]
            lines += [
                "        {",
                f"            const double s[] = {{ {s} }};",
                f"            static const double c[] = {{ {c_numbers(c)} }}, "
                f"constants[] = {{ {c_numbers(np.array(constants or [0.0]))} }};",
                f"            moved[{limb - 1}] += {t.effect}(s, c, constants);",
                "        }",
            ]
    return [*lines, f"        for (i = 0; i < {limbs}; i++)", "            q[i] = theta[i] - moved[i];", "    }"]


def _c_state(state: State, limb: int, compensator: Compensator) -> str:
    """Return a state as C writes it for a limb (from 1)."""
    i = (state.joint or limb) - 1
    text = _since(state, compensator)
    return text.format(i=i, sign=f"DELTACAL_SIGN[{i}] * ", turned=repr(_turned(compensator)))


def _fields(compensator: Compensator) -> list[State]:
    """Return the channels that a controller tells, in the order of their struct: covariates behind the usual ones."""
    read = tabled(s for t in compensator.effects for s in t.states)
    usual = sorted(tabled(CHANNELS), key=lambda s: s.per == "joint")
    return [*usual, *(s for s in read if s.base not in STATES)]


def _field(state: State) -> str:
    """Return what a channel is called in C: a column of the user's own may be called ``switch`` or ``p [bar]``."""
    if state.base in STATES:
        return state.column.format(i="")
    if re.fullmatch(r"[a-z]\w*_\w+", state.column, re.ASCII):  # no keyword and no macro is written so
        return state.column
    return "recorded_" + re.sub(r"\W", "_", state.column, flags=re.ASCII)


def _since(state: State, compensator: Compensator) -> str:
    """Return a state in C, the time as effects count it."""
    if state.base not in STATES:
        return f"at->{_field(state)}"
    return f"({state.c99} - {compensator.begun!r})" if state.passes and compensator.begun else state.c99


def _c_factor(channel: State, compensator: Compensator) -> str:
    """Return a channel of the machine as corrections go with it, in C."""
    scale, text = unit_of(channel.name)[1], _since(channel, compensator)
    text = text if scale == 1.0 else f"{text} / {scale!r}"
    return f"({text})" if " " in text else text


def _turned(compensator: Compensator) -> float:
    """Return by how much a joint's motor or pulley turns per unit of the joint [rad per rad or mm]."""
    transmission = compensator.robot.transmission
    around = transmission.pulley_circumference if transmission is not None else None
    return 2 * math.pi / around if compensator.mechanism.joint_unit == "mm" and around else 1.0


def _c_each(target: str, values: Sequence[str]) -> str:
    """Return one assignment per value."""
    return "\n    ".join(f"{target.format(i=i)} = {value};" for i, value in enumerate(values))


def _c_header(compensator: Compensator, left: RoundTrip, unit: str, live: LiveEffects | None) -> Iterator[str]:
    robot, mechanism = compensator.robot, compensator.mechanism
    limbs = mechanism.limbs
    what = {
        CompensatorKind.EXACT: "inverse position of the calibrated machine, by Newton's method",
        CompensatorKind.LINEAR: "nominal joints and the first-order change that undoes the errors (Bai 2015, eq. 23)",
    }
    yield f"Joint commands for {plain(robot.name)} ({mechanism.name}), compensated."
    yield ""
    yield f"Kind        {compensator.kind}: {what[compensator.kind]}"
    yield f"Model       {compensator.model}, {sum(1 for v in robot.errors.values() if v)} source errors"
    yield f"Parameters  sha256 {compensator.digest}: the same numbers always give the same file"
    yield f"Error left  {stated(left.worst_mm):.1e} mm at the worst of {left.points} points of the workspace,"
    yield "            against the model's own forward position (what the model does not know is not in it):"
    yield f"            {_workspace_in_words(robot)}"
    if left.missed:
        yield f"WARNING     {left.missed} of these points are out of reach or singular"
    if compensator.corrected:
        yield f"WARNING     {LEFT_OUT}: commands for targets in a file have it."
    if live is not None:
        yield from _c_effects(live)
    yield ""
    yield f"In          {_stated_in_words(mechanism)}"
    yield f"Out         joints_{unit}: what to command, as the controller counts [{unit}]; not checked for joint limits"
    channel = "" if live is None else f"; {NOT_A_NUMBER} a channel is no finite number"
    yield f"Returns     0 solved; 1 out of reach; 2 singular{channel}; joints are written only for 0"
    yield ""
    yield f"Usage       double joints[{limbs}];"
    home = _as_files(mechanism, turned(robot, workspace_of(robot).home[None]))[0]
    yield f"            const double target[{len(home)}] = {{ {c_numbers(home)} }};"
    if live is None:
        yield "            if (deltacal_compensate(target, joints) == 0) { ... }"
    else:
        yield "            const struct deltacal_channels at = {"
        yield from (f"                {field}," for field in live.usual[1])
        yield "            };"
        yield "            if (deltacal_command(target, &at, joints) == 0) { ... }"
    yield "Build       C99 with the mathematics library, double of 64 bits. No memory is allocated, no state is kept:"
    yield "            safe from any thread. Not with -ffast-math, which drops the test for targets out of reach."
    yield '            Declare it elsewhere as it is declared here, in C++ as extern "C". Two machines in one program:'
    yield "            build each with names of its own, -Ddeltacal_compensate=left_compensate and so on."
    yield from _c_checks(compensator, unit, live)


def _c_checks(compensator: Compensator, unit: str, live: LiveEffects | None) -> Iterator[str]:
    """Yield targets with their joints."""
    robot, mechanism = compensator.robot, compensator.mechanism
    checks = turned(robot, np.round(workspace_points(workspace_of(robot))[[-3, -7, -70]], 3))
    joints, status = compensator.command(checks)
    given, unit_in = _as_files(mechanism, checks), "mm, deg" if mechanism.turning else "mm"
    by = [("", joints)]
    if live is not None:
        by = [
            (" of deltacal_compensate", joints),
            (" of deltacal_command, at as above", live.command(checks, live.usual[0])),
        ]
    for function, found in by:
        yield ""
        yield f"To check after installation{function}:"
        for target, command in zip(given[status == SOLVED], found[status == SOLVED], strict=True):
            inputs = ", ".join(f"{v:.3f}" for v in target)
            outputs = ", ".join(f"{v:.9f}" for v in command / to_internal(mechanism.joint_unit))
            yield f"            ({inputs}) {unit_in} -> ({outputs}) {unit}"


def _workspace_in_words(robot: Robot) -> str:
    """Say where the workspace is."""
    space, axes = workspace_of(robot), mechanism_of(robot).axes
    centre, half = space.box
    ends = [
        f"{axis} from {c - h:g} to {c + h:g}" for axis, c, h in zip("xyz", centre, half, strict=True) if axis in axes
    ]
    if space.radius is not None:
        ends = [f"within {space.radius:g} mm of the z axis", *ends[2:]]
    turned = f", turned by up to {space.turn:g} deg" if space.turn else ""
    return f"{', '.join(ends)} mm in {{O}}{turned}"


def _stated_in_words(mechanism: Machine) -> str:
    """Say what a target is."""
    shifts = [name[1] for name in mechanism.asks if name[0] == "p"]
    of = f"{', '.join(shifts)} of the " if len(shifts) < 3 else ""
    place = f"{of}reference point P in the robot frame {{O}}"
    if mechanism.turning:
        turns = ", ".join(f"r{name[1]}" for name in mechanism.asks if name[0] == "c")
        return f"target: {place} [mm], {turns} of its rotation vector [deg]"
    unread = [axis for axis in "xyz" if axis not in shifts]
    rest = f"; {' and '.join(unread)} {'are' if len(unread) > 1 else 'is'} not read" if unread else ""
    return f"target_mm: {place}{rest} [mm]"


def _as_files(mechanism: Machine, targets: Array) -> Array:
    """Return targets as the C function takes them: positions (N, 3) [mm], or what a command states [mm, deg]."""
    if not mechanism.turning:
        return targets
    whole = np.hstack([targets[:, :3], to_vector(targets[:, 3:].reshape(-1, 3, 3)) / DEG])
    return whole[:, [COORDINATES.index(name) for name in mechanism.asks]]


def _c_effects(live: LiveEffects) -> Iterator[str]:
    compensator, left = live.compensator, live.left
    yield ""
    yield "deltacal_compensate knows the geometry only; use deltacal_command, which also knows"
    for t in compensator.effects:
        limbs = at(compensator.robot, t.limbs)
        how = (
            "closed form"
            if any(t is k for k in live.known)
            else f"polynomials of degree {DEGREE}, first order in each channel"
        )
        yield f"            {t.effect}{limbs}: {how}"
    for t in compensator.instrument:
        yield f"            (not {t.effect}: it belongs to the instrument)"
    yield f"Error left  {stated(left.worst_mm):.1e} mm at the worst of {left.points} points with these effects,"
    yield "            against the exact machine in equilibrium, over the channels as they were recorded:"
    ends = "; polynomials end where they stand a tenth beyond the workspace" if live.columns else ""
    yield f"            {live.over.in_channels(compensator.begun)};"
    yield f"            beyond them it is extrapolated{ends}"
    yield "            A machine at rest, and after every jump that the recording holds."
    if left.missed:
        yield f"WARNING     {left.missed} of these points are out of reach or singular"


def plain(text: str) -> str:
    """Return `text` without anything that means something in a C comment."""
    return re.sub(r"[^\w .,:;()+-]", "_", text)


def c_numbers(values: Array) -> str:
    """Return numbers as C writes them, to the last digit."""
    return ", ".join(repr(float(v)) for v in values)


def wrapped(values: Array, per_line: int = 5) -> str:
    """Return a row of numbers as C writes them, a few in a line."""
    parts = [c_numbers(values[j : j + per_line]) for j in range(0, len(values), per_line)]
    return ",\n      ".join(parts)
