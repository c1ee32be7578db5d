"""Exports of a compensator for a controller: one C99 file, or a table of corrections.

The geometry of the C file is exact. What effects add is taken apart: an effect whose formula needs nothing but the
joint, the direction of approach, the temperature and the time stands in the file as it was derived; the others (loads,
growth of links) become *columns*, a polynomial over the workspace for every product of channels that they depend on, to
first order in each. A table holds such columns at its nodes. Either file states the error that it leaves against the
exact machine, over the workspace and over the channels as they were recorded.
"""

from __future__ import annotations

import importlib.resources
import itertools
import json
import math
import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from importlib.resources.abc import Traversable
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.errors import InputError, NoSolutionError, UsageError
from deltacal_gen.files.recording import write_files
from deltacal_gen.files.robot import read_text
from deltacal_gen.identification.accuracy import turned, workspace_of
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import COORDINATES, POSE, SOLVED, UNREACHABLE, Array, Machine
from deltacal_gen.machine.rotation import to_vector
from deltacal_gen.physics.physics import Body, Channels, Term, term_of
from deltacal_gen.physics.states import CHANNELS, STATES, State, named
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.result import Result
from deltacal_gen.units import DEG, file_unit, to_internal
from deltacal_gen.use.compensation import Compensator, RoundTrip, largest, workspace_points

LARGEST_TABLE = (
    200_000  # nodes times columns; beyond this the file has tens of megabytes and the C source is the better export
)
TABLE_DECIMALS = 7  # of a correction in deg or mm: at a metre, 2e-6 mm
DEGREE = 6  # of the polynomials over the workspace: 84 coefficients
TURNS = 12  # of the fixed point in C: an effect of the joint angle that steepens by a tenth is then known to 1e-12
_SOURCE = {"exact": "inverse.c", "linear": "linear.c"}
_MARGIN = 1.05  # a stated error over the measured one
_CHUNK = 100_000  # points evaluated at once
_SEED = 20151  # of the channels' random values: the same machine always gets the same statement


# --- what corrections depend on beside the target -------------------------------------------------------------------

Column = tuple[str, ...]  # channels whose product a correction goes with; () is the correction at reference


@dataclass(frozen=True)
class Spans:
    """Between which values the channels lay when the effects were found; only what was recorded is there.

    By the names of columns of corrections, in their units: warming [K over 20 degC], payload [kg], time [h].
    """

    known: Mapping[str, tuple[float, float]] = field(default_factory=dict)

    def items(self) -> dict[str, tuple[float, float]]:
        """Return the channels that varied, by name."""
        return {name: span for name, span in self.known.items() if span[1] > span[0]}

    def in_words(self) -> str:
        """Return the ranges for a header."""
        words = [f"{name} {low:g} to {high:g} {_unit(name)[0]}" for name, (low, high) in self.items().items()]
        return ", ".join(words) or "no channel varied"


def _unit(name: str) -> tuple[str, float]:
    """Return the unit of a channel in corrections, and how many of the state's it is."""
    unit = named(name).tabled
    assert unit is not None  # corrections go with no other channel
    return unit


def _tabled(states: Iterable[State]) -> list[State]:
    """Return the channels by which corrections for states go, one per recorded column."""
    read = [c for s in states if not s.since for c in s.channels]
    every = [c if c.tabled else next((o for o in CHANNELS if o.column == c.column and o.tabled), None) for c in read]
    return list(dict.fromkeys(c for c in every if c is not None))


def spans(result: Result | Diagnosis) -> Spans:
    """Return the spans of the channels that a diagnosis was made with; a result has none."""
    recorded = result.residuals.channels if isinstance(result, Diagnosis) else {}
    read = _tabled(s for kept in result.physics or () for s in term_of(kept).states)
    found: dict[str, tuple[float, float]] = {}
    for s in dict.fromkeys((*_tabled(CHANNELS), *read)):
        values = recorded.get(s.column, np.zeros(0))
        values = values[np.isfinite(values)]
        if len(values):
            scale = _unit(s.name)[1]
            found[s.name] = float(values.min() - s.zero) / scale, float(values.max() - s.zero) / scale
    return Spans(found)


def _columns(compensator: Compensator, terms: Sequence[Term], over: Spans) -> tuple[Column, ...]:
    """Return every product of channels that the terms may go with; a product's parts stand before it."""
    known, limbs = over.items(), compensator.mechanism.limbs
    found: set[Column] = {()}
    for term in terms:
        read = _tabled(term.states)
        reads = [s.name for s in read if s.name in known]
        subsets = [c for n in range(len(reads) + 1) for c in itertools.combinations(reads, n)]
        joints: list[Column] = [()]
        for s in read:
            if s.per == "joint":
                own = (s.joint,) if s.joint else term.limbs or range(1, limbs + 1)
                joints += [(s.column.format(i=i),) for i in own]
        found |= {(*a, *s) for a in joints for s in subsets}
    return tuple(sorted(found, key=lambda c: (len(c), c)))


def _channels(compensator: Compensator, n: int, values: Mapping[str, Array | float]) -> Channels:
    """Return channels of n rows from values by the names of columns; what is not given stays at reference."""
    columns: dict[str, Array | float] = {}
    for s in _tabled((*CHANNELS, *(s for t in compensator.effects for s in t.states))):
        if s.per == "joint":
            names = s.columns(compensator.mechanism.joint_unit, compensator.mechanism.limbs)
            columns |= {name: values.get(name, 0.0) for name in names}
        else:
            columns[s.column] = np.add(np.multiply(values.get(s.name, 0.0), _unit(s.name)[1]), s.zero)
    return compensator.channels(columns, n)[0]


def _after_jumps(compensator: Compensator) -> Compensator:
    """Return the compensator for all that is commanded after the recording: jumps are past."""
    return replace(compensator, terms=tuple(t.afterwards() for t in compensator.terms))


def _factor(column: Column, values: Mapping[str, Array | float]) -> Array | float:
    out: Array | float = 1.0
    for name in column:
        out = out * values[name]
    return out


def _drawn(columns: Sequence[Column], over: Spans, n: int) -> dict[str, Array]:
    """Return random values (n,) of every channel that the columns name, within what was recorded."""
    rng = np.random.default_rng(_SEED)
    known = over.items()
    names = sorted({c for column in columns for c in column})
    return {name: rng.choice([-1.0, 1.0], n) if name not in known else rng.uniform(*known[name], n) for name in names}


def _taken_apart(
    compensator: Compensator, points: Array, columns: Sequence[Column], over: Spans, known: Sequence[Term], base: Array
) -> Array:
    """Return the columns (N, columns, n_q) of what exact joints differ from `base`, after `known` effects on them.

    Each product of channels is switched on by itself, at the end of its span, and what its parts explain taken off.
    Joints as the geometry counts them [rad or mm].
    """
    ends = {name: max(span, key=abs) for name, span in over.items().items()}
    settings = [{name: ends.get(name, 1.0) for name in column} for column in columns]
    found = []
    for values in settings:
        at = _channels(compensator, len(points), values)
        q = compensator.command(points, None, at)[0] * compensator.robot.joint_sign
        found.append(q + _shift(compensator, q, at, known) - base)
    weights = np.array([[_factor(c, v) if set(c) <= v.keys() else 0.0 for c in columns] for v in settings])
    return np.einsum("kl,nlj->nkj", np.linalg.inv(weights), np.stack(found, axis=1))


def _shift(compensator: Compensator, q: Array, at: Channels, known: Sequence[Term]) -> Array:
    """Return by how much effects of the joint alone move it, (N, n_q)."""
    if not known:
        return np.zeros_like(q)
    mechanism, robot = compensator.mechanism, compensator.robot
    body = Body(robot, mechanism, q, np.zeros((len(q), 3)), at)
    names = sorted({s.name for t in known for s in t.states if not s.since})
    state = body.state(names, np.zeros((len(q), POSE)), q, mechanism.rows(robot))  # no load, so no pose
    moved: Array = body.moved(known, state)["joint"]
    return moved


def _stated(measured: float) -> float:
    """Return what is stated for a measured error: a margin above it, rounded up to two digits."""
    if measured == 0.0:
        return 0.0
    digit = 10.0 ** (math.floor(math.log10(measured * _MARGIN)) - 1)
    return float(f"{math.ceil(measured * _MARGIN / digit) * digit:.1e}")


# --- C99 ------------------------------------------------------------------------------------------------------------


def export_c(compensator: Compensator, path: str | Path, over: Spans | None = None) -> RoundTrip:
    """Write the compensator as one self-contained C99 file.

    It defines ``int deltacal_compensate(const double target_mm[3], double joints_deg[3])``, which returns 0 (solved),
    1 (out of reach) or 2 (singular), keeps no state and allocates nothing. The tool point is the robot's. Where the
    machine has effects there is also ``deltacal_command``, which takes temperature, payload, time and directions of
    approach beside the target.

    Parameters
    ----------
    compensator : Compensator
    path : path
        Replaced only when the new file is complete.
    over : Spans, optional
        Ranges of the channels, for a machine with effects.

    Returns
    -------
    RoundTrip
        What the file's header states.

    Raises
    ------
    InputError
        The robot has no workspace, or the file cannot be written.
    """
    if compensator.effects and compensator.mechanism.turning:
        raise UsageError(
            "effects are exported as functions of the position, and this platform turns on command. "
            "Write the joints of your targets: deltacal compensate RESULT TARGETS -o JOINTS."
        )
    rigid = replace(compensator, terms=())
    with using(Backend.NUMPY):  # a file holds the same digits wherever it is written from
        left = rigid.round_trip()
        live = _Live.of(_after_jumps(compensator), over or Spans()) if compensator.effects else None
        write_files({Path(path): c_source(rigid, left, live)})
        return left if live is None else live.left


@dataclass(frozen=True, eq=False)
class _Live:
    """The effects of a C export: polynomials for the columns, and the effects that stand in it as they were derived.

    coefficients (columns, n_q, m) of the monomials `powers` (m, 3) in the position from `centre` in units of `half`.
    """

    compensator: Compensator
    over: Spans
    columns: tuple[Column, ...]
    coefficients: Array
    powers: np.ndarray
    centre: Array
    half: Array
    known: tuple[Term, ...]

    @staticmethod
    def of(compensator: Compensator, over: Spans) -> _Live:
        centre, half = workspace_of(compensator.robot).box
        half = np.where(half > 0, half, 1.0)
        powers = np.array([e for e in itertools.product(range(DEGREE + 1), repeat=3) if sum(e) <= DEGREE])
        known = tuple(t for t in compensator.effects if _c_effect(t).is_file())
        others = [t for t in compensator.effects if not _c_effect(t).is_file()]
        columns = _columns(compensator, others, over)
        points = workspace_points(workspace_of(compensator.robot))[::3]
        rigid = replace(compensator, terms=()).command(points)[0] * compensator.robot.joint_sign
        found = _taken_apart(compensator, points, columns, over, known, rigid)
        solved = np.isfinite(found).all(axis=(1, 2))
        basis = np.prod(((points - centre) / half)[:, None, :] ** powers, axis=2)[solved]
        fitted = np.linalg.lstsq(basis, found[solved].reshape(solved.sum(), -1), rcond=None)[0]
        coefficients = np.moveaxis(fitted.reshape(len(powers), *found.shape[1:]), 0, 2)
        # a column that nothing goes with is rounding
        kept = [k for k, c in enumerate(coefficients) if np.abs(c).max(initial=0.0) > 1e-13]
        return _Live(
            compensator, over, tuple(columns[k] for k in kept), coefficients[kept], powers, centre, half, known
        )

    def command(self, points: Array, values: Mapping[str, Array | float]) -> Array:
        """Return joints (N, n_q) as the controller counts them [rad or mm], as the C file computes them."""
        sign = self.compensator.robot.joint_sign
        theta = replace(self.compensator, terms=()).command(points)[0] * sign
        basis = np.prod(((points - self.centre) / self.half)[:, None, :] ** self.powers, axis=2)
        for column, coefficients in zip(self.columns, self.coefficients, strict=True):
            theta = theta + np.reshape(_factor(column, values), (-1, 1)) * (basis @ coefficients.T)
        at, q = _channels(self.compensator, len(points), values), theta
        for _ in range(TURNS):
            q = theta - _shift(self.compensator, q, at, self.known)
        return q * sign

    @cached_property
    def left(self) -> RoundTrip:
        """What the file leaves at random points of the workspace and random values of the channels."""
        points = workspace_points(workspace_of(self.compensator.robot))
        every = _columns(self.compensator, self.compensator.effects, self.over)
        values = _drawn(every, self.over, len(points))
        at = _channels(self.compensator, len(points), values)
        error = np.linalg.norm(self.compensator.missed(self.command(points, values), points, None, at), axis=1)
        return RoundTrip(largest(error), len(points), int(np.isnan(error).sum()))


def _c_effect(term: Term) -> Traversable:
    """Return the C source of an effect's formula; it exists where a controller knows all that the effect reads."""
    return importlib.resources.files("deltacal_kernels").joinpath("effects", f"{term.effect}.c")


def c_source(compensator: Compensator, left: RoundTrip, live: _Live | None = None) -> str:
    """Return the text of the C99 file that `export_c` writes; `compensator` is that of the geometry alone."""
    mechanism, kernels, robot = compensator.mechanism, compensator._kernels, compensator.robot
    body = importlib.resources.files("deltacal_kernels").joinpath(mechanism.name, _SOURCE[compensator.kind])
    constants = compensator._constants[0]
    if compensator.kind == "exact":
        constants = constants[:, : kernels.COMMAND_CONSTANTS]
    limbs, unit = mechanism.limbs, file_unit(mechanism.joint_unit)
    values = "\n".join(f"    {{ {_wrapped(row)} }}," for row in constants)
    numbers = (
        f"static const double DELTACAL_K[{limbs}][{constants.shape[1]}] = {{\n{values}\n}};\n"
        f"static const double DELTACAL_TOOL[3] = {{ {_c_numbers(robot.tool)} }}; /* mm, reference point in {{O'}} */\n"
        f"static const double DELTACAL_SIGN[{limbs}] = {{ {_c_numbers(robot.joint_sign)} }}; /* of the controller */\n"
    )
    comment = "\n".join(f" * {line}".rstrip() for line in _c_header(compensator, left, unit, live))
    text = f"/*\n{comment}\n */\n{numbers}\n{body.read_text(encoding='utf-8')}"
    return text if live is None else f"{text}\n{_c_command(live, unit)}"


def _c_command(live: _Live, unit: str) -> str:
    """Return the function that adds what the effects ask for to the geometry's command."""
    limbs, n, m = live.compensator.mechanism.limbs, len(live.columns), len(live.powers)
    files = dict.fromkeys(_c_effect(t) for t in live.known)
    sources = [f.read_text(encoding="utf-8") for f in files]
    tables = []
    if n:
        rows = ",\n".join(
            "    {\n" + ",\n".join(f"    {{ {_wrapped(row)} }}" for row in column) + "\n    }"
            for column in live.coefficients
        )
        tables = [
            f"static const unsigned char DELTACAL_POWERS[{m}][3] = {{\n      "
            + ",\n      ".join(
                ", ".join(f"{{ {x}, {y}, {z} }}" for x, y, z in live.powers[j : j + 8]) for j in range(0, m, 8)
            )
            + "\n};",
            "/* rad, per product of channels: polynomials of the position in units of the workspace */".replace(
                "rad", live.compensator.mechanism.joint_unit
            ),
            f"static const double DELTACAL_COLUMNS[{n}][{limbs}][{m}] = {{\n{rows}\n}};",
        ]
    used = (s for t in live.compensator.effects for s in t.states)
    covariates = [c for c in _tabled(used) if c.base not in STATES]
    factors = {s.name: _c_factor(s) for s in _tabled((*CHANNELS, *covariates)) if s.per == "machine"}
    factors |= {
        s.column.format(i=i + 1): s.c99.format(i=i, sign="")
        for s in _tabled(CHANNELS)
        for i in range(limbs if s.per == "joint" else 0)
    }
    body = [
        "int deltacal_command(const double target_mm[3], const struct deltacal_channels *at,",
        f"                     double joints_{unit}[{limbs}])",
        "{",
        f"    double theta[{limbs}], q[{limbs}];",
        f"    int i{', j, k' if n else ''}{', turn' if live.known else ''};",
        f"    const int status = deltacal_compensate(target_mm, joints_{unit});",
        *([f"    double u[3][{DEGREE + 1}], by[{n}];"] if n else []),
        "    (void)(at);",
        "    if (status != DELTACAL_SOLVED)",
        "        return status;",
        f"    for (i = 0; i < {limbs}; i++)",
        f"        theta[i] = DELTACAL_SIGN[i] * joints_{unit}[i] / JOINT_PER_UNIT;",
    ]
    if n:
        ends = zip(live.centre.tolist(), live.half.tolist(), strict=True)
        place = [f"(target_mm[{i}] - {c!r}) / {h!r}" for i, (c, h) in enumerate(ends)]
        body += [
            f"    {_c_each('u[{i}][1]', place)}",
            "    for (i = 0; i < 3; i++) {",
            "        u[i][0] = 1.0;",
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
    body += [f"    for (i = 0; i < {limbs}; i++)", "        q[i] = theta[i];"]
    if live.known:
        body += [f"    for (turn = 0; turn < {TURNS}; turn++) {{", f"        double moved[{limbs}] = {{ 0.0 }};"]
        for t in live.known:
            for row, limb in enumerate(t.limbs or range(1, limbs + 1)):
                s = ", ".join(_c_state(s, limb, live.compensator) for s in t.states)
                c, constants = t.values[row if t.limbs else 0], [0.0 if math.isinf(v) else v for v in t.constants]
                body += [
                    "        {",
                    f"            const double s[] = {{ {s} }};",
                    f"            static const double c[] = {{ {_c_numbers(c)} }}, "
                    f"constants[] = {{ {_c_numbers(np.array(constants or [0.0]))} }};",
                    f"            moved[{limb - 1}] += {t.effect}(s, c, constants);",
                    "        }",
                ]
        body += [f"        for (i = 0; i < {limbs}; i++)", "            q[i] = theta[i] - moved[i];", "    }"]
    body += [
        f"    for (i = 0; i < {limbs}; i++)",
        f"        joints_{unit}[i] = DELTACAL_SIGN[i] * q[i] * JOINT_PER_UNIT;",
        "    return DELTACAL_SOLVED;",
        "}",
    ]
    interface = [
        "/* What commands depend on beside the target; approach is +1 or -1 as the controller counts, 0: not known. */",
        "struct deltacal_channels {",
        f"    double {', '.join(dict.fromkeys(c.column for c in CHANNELS if c.c99 and c.per == 'machine'))};",
        *(f"    double {c.column.format(i='')}[{limbs}];" for c in CHANNELS if c.c99 and c.per == "joint"),
        *(f"    double {c.column};" for c in covariates),
        "};",
    ]
    return "\n".join([*interface, "", *sources, *tables, "", *body]) + "\n"


def _c_state(state: State, limb: int, compensator: Compensator) -> str:
    """Return a state as C writes it for a limb (from 1)."""
    i = (state.joint or limb) - 1
    return state.c99.format(i=i, sign=f"DELTACAL_SIGN[{i}] * ", turned=repr(_turned(compensator)))


def _c_factor(channel: State) -> str:
    """Return a channel of the machine as corrections go with it, in C."""
    scale = _unit(channel.name)[1]
    text = channel.c99 if scale == 1.0 else f"{channel.c99} / {scale!r}"
    return f"({text})" if " " in text else text


def _turned(compensator: Compensator) -> float:
    """Return by how much a joint's motor or pulley turns per unit of the joint [rad per rad or mm]."""
    transmission = compensator.robot.transmission
    around = transmission.pulley_circumference if transmission is not None else None
    return 2 * math.pi / around if compensator.mechanism.joint_unit == "mm" and around else 1.0


def _c_each(target: str, values: Sequence[str]) -> str:
    """Return one assignment per value."""
    return "\n    ".join(f"{target.format(i=i)} = {value};" for i, value in enumerate(values))


def _c_header(compensator: Compensator, left: RoundTrip, unit: str, live: _Live | None) -> Iterator[str]:
    robot, mechanism = compensator.robot, compensator.mechanism
    limbs = mechanism.limbs
    what = {
        "exact": "inverse position of the calibrated machine, by Newton's method",
        "linear": "nominal joints and the first-order change that undoes the errors (Bai 2015, eq. 23)",
    }
    yield f"Joint commands for {_plain(robot.name)} ({mechanism.name}), compensated."
    yield ""
    yield f"Kind        {compensator.kind}: {what[compensator.kind]}"
    yield f"Model       {compensator.model}, {sum(1 for v in robot.errors.values() if v)} source errors"
    yield f"Parameters  sha256 {compensator.digest}: the same numbers always give the same file"
    yield f"Error left  {_stated(left.worst_mm):.1e} mm at the worst of {left.points} points of the workspace,"
    yield "            against the model's own forward position (what the model does not know is not in it)"
    if left.missed:
        yield f"WARNING     {left.missed} of these points are out of reach or singular"
    if live is not None:
        yield from _c_effects(live)
    yield ""
    yield f"In          {_stated_in_words(mechanism)}"
    yield f"Out         joints_{unit}: what to command, as the controller counts [{unit}]; not checked for joint limits"
    yield "Returns     0 solved; 1 out of reach; 2 singular; joints are written only for 0"
    yield ""
    yield f"Usage       double joints[{limbs}];"
    home = _as_files(mechanism, turned(robot, workspace_of(robot).home[None]))[0]
    yield f"            const double target[{len(home)}] = {{ {_c_numbers(home)} }};"
    yield "            if (deltacal_compensate(target, joints) == 0) { ... }"
    yield "Build       C99 with the mathematics library. No memory is allocated and no state is kept: safe from any"
    yield "            thread. Not with -ffast-math, which drops the test for targets out of reach."
    checks = turned(robot, np.round(workspace_points(workspace_of(robot))[[-3, -7, -70]], 3))
    joints, status = compensator.command(checks)
    yield ""
    yield "To check after installation:"
    given, unit_in = _as_files(mechanism, checks), "mm, deg" if mechanism.turning else "mm"
    for target, command in zip(given[status == SOLVED], joints[status == SOLVED], strict=True):
        inputs = ", ".join(f"{v:.{9 if mechanism.turning else 3}f}" for v in target)
        outputs = ", ".join(f"{v:.9f}" for v in command / to_internal(mechanism.joint_unit))
        yield f"            ({inputs}) {unit_in} -> ({outputs}) {unit}"


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


def _c_effects(live: _Live) -> Iterator[str]:
    compensator, left = live.compensator, live.left
    yield ""
    yield "deltacal_compensate knows the geometry only; use deltacal_command, which also knows"
    for t in compensator.effects:
        limbs = f" at joint{'s' if len(t.limbs) > 1 else ''} {', '.join(map(str, t.limbs))}" if t.limbs else ""
        how = (
            "closed form"
            if any(t is k for k in live.known)
            else f"polynomials of degree {DEGREE}, first order in each channel"
        )
        yield f"            {t.effect}{limbs}: {how}"
    for t in compensator.instrument:
        yield f"            (not {t.effect}: it belongs to the instrument)"
    yield f"Error left  {_stated(left.worst_mm):.1e} mm at the worst of {left.points} points with these effects,"
    yield "            against the exact machine in equilibrium, over the channels as they were recorded:"
    yield f"            {live.over.in_words()}; beyond them it is extrapolated"
    yield "            A machine at rest, and after every jump that the recording holds."
    if left.missed:
        yield f"WARNING     {left.missed} of these points are out of reach or singular"


def _plain(text: str) -> str:
    """Return `text` without anything that means something in a C comment."""
    return re.sub(r"[^\w .,:;()+-]", "_", text)


def _c_numbers(values: Array) -> str:
    return ", ".join(repr(float(v)) for v in values)


def _wrapped(values: Array, per_line: int = 5) -> str:
    parts = [_c_numbers(values[j : j + per_line]) for j in range(0, len(values), per_line)]
    return ",\n      ".join(parts)


# --- the table ------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class TableCompensator:
    """Corrections of joint commands on a regular grid, interpolated between its nodes (trilinear).

    Parameters
    ----------
    origin, step : (3,) arrays
        First node and spacing along x, y, z [mm].
    corrections : (n_x, n_y, n_z, columns, n_q) array
        To be added to the nominal joints, as the controller counts [rad or mm, per unit of the column's channels]; NaN
        where out of reach.
    worst_mm : float
        Worst position error over the workspace, compensated by this table [mm].
    missed : int
        Checked points of the workspace for which the table has no answer.
    robot, mechanism, kind, digest : str
        Of the `Compensator` it was made from.
    joint_unit : {"rad", "mm"}
    tool : (3,) array
        The reference point in {O'} for which it holds [mm].
    columns : tuple
        Products of channels that the corrections go with: warming [K over 20 degC], payload [kg], time [h],
        approach1 ... [1]; the first is the correction at reference.
    """

    origin: Array
    step: Array
    corrections: Array
    worst_mm: float
    missed: int
    robot: str
    mechanism: str
    kind: str
    digest: str
    joint_unit: str
    tool: Array
    columns: tuple[Column, ...] = ((),)

    @property
    def nodes(self) -> tuple[int, int, int]:
        """Number of nodes along x, y, z."""
        n_x, n_y, n_z = self.corrections.shape[:3]
        return n_x, n_y, n_z

    def correction(
        self, targets: Array, channels: Mapping[str, Array | float] | None = None
    ) -> tuple[Array, np.ndarray]:
        """Return what to add to the nominal joints at targets (N, 3) [mm].

        Parameters
        ----------
        channels : mapping of (N,) arrays or numbers, optional
            By the names of the columns; one that is not given stays at reference.

        Returns
        -------
        correction : (N, n_q) array
            As the controller counts [rad or mm]; NaN beside the grid and where one of the 8 nodes is out of reach.
        status : (N,) int array
            SOLVED, or UNREACHABLE where there is no correction.
        """
        values = {name: 0.0 for column in self.columns for name in column} | dict(channels or {})
        targets = np.asarray(targets, dtype=float)
        if targets.ndim != 2 or targets.shape[1] != 3:
            raise ValueError(f"targets have the shape {targets.shape}, but must have (N, 3).")
        place = (targets - self.origin) / self.step
        last = np.array(self.nodes) - 1
        # a target on the rim may round to beside it
        outside: np.ndarray = np.any(~((place > -1e-9) & (place < last + 1e-9)), axis=1)
        place = np.where(outside[:, None], 0.0, place)
        cell = np.clip(place.astype(np.int64), 0, last - 1)
        part = place - cell
        found = np.zeros((len(targets), *self.corrections.shape[3:]))
        for corner in itertools.product((0, 1), repeat=3):
            weight = np.prod(np.where(corner, part, 1.0 - part), axis=1)
            i, j, k = (cell + corner).T
            found += weight[:, None, None] * self.corrections[i, j, k]
        found[outside] = np.nan
        factors = np.stack([np.broadcast_to(_factor(c, values), len(targets)) for c in self.columns], axis=1)
        total = np.einsum("nk,nkj->nj", factors, found)
        return total, np.where(np.isnan(total).any(axis=1), UNREACHABLE, SOLVED)


def export_table(
    compensator: Compensator,
    path: str | Path,
    over: Spans | None = None,
    *,
    worst_mm: float = 0.01,
    step_mm: float | None = None,
) -> TableCompensator:
    """Write the corrections as a table over the workspace, with its worst error stated in the file.

    Parameters
    ----------
    compensator : Compensator
    path : path
        A CSV file; replaced only when the new one is complete.
    over : Spans, optional
        Ranges of the channels, for a machine with effects.
    worst_mm : float
        The error that the table may leave; the grid is made as fine as this needs.
    step_mm : float, optional
        Largest spacing of the grid; then `worst_mm` is not asked for, only stated.

    Returns
    -------
    TableCompensator
        As `read_table` reads it back.

    Raises
    ------
    InputError
        The robot has no workspace, or the file cannot be written.
    NoSolutionError
        No table of a reasonable size leaves so small an error.

    Notes
    -----
    The error is that of the calibrated machine's exact forward position at nominal joints plus correction, measured at
    the middles of all cells, faces and edges, and at random points. Where corrections curve with the square of the
    distance, trilinear interpolation errs by a sum of one term per axis, each largest half way between nodes: the
    largest norm of such a sum is found at one of these middles.
    """
    if len(compensator.mechanism.axes) < 3:
        raise UsageError(
            f"a table is made for machines that move in space, and {compensator.mechanism.machine} moves in a plane. "
            "Export the C source, or write the joints of your targets: deltacal compensate RESULT TARGETS -o JOINTS."
        )
    over = over or Spans()
    compensator = _after_jumps(compensator)
    compensator.round_trip()  # a workspace out of reach is refused here
    table = _sampled(compensator, over, step_mm) if step_mm is not None else _fine_enough(compensator, over, worst_mm)
    write_files({Path(path): _table_text(table, compensator, over)})
    return table


def _fine_enough(compensator: Compensator, over: Spans, worst_mm: float) -> TableCompensator:
    if not worst_mm > 0.0:
        raise UsageError(f"the worst error asked of a table is {worst_mm:g} mm, but must be above 0.")
    left = compensator.round_trip()
    if left.missed:
        raise NoSolutionError(
            f"{left.missed} of {left.points} checked points of the workspace are out of reach, so no table covers it. "
            "Make [workspace] smaller, or give the step of a table that leaves them blank."
        )
    if _stated(left.worst_mm) >= worst_mm:
        raise NoSolutionError(
            f"the {compensator.kind} compensator itself leaves {_stated(left.worst_mm):g} mm over the workspace, so no "
            f"table of it leaves {worst_mm:g} mm. Use the exact one, or ask for a larger worst error."
        )
    if (floor := _floor(compensator, over)) >= worst_mm:
        raise NoSolutionError(
            f"what the effects ask for is not linear enough in the channels: to first order {floor:g} mm are left, so "
            f"no table leaves {worst_mm:g} mm. Allow a larger worst error, or export the C source."
        )
    step = workspace_of(compensator.robot).box[1].max() / 2
    while True:
        table = _sampled(compensator, over, step, at_most=worst_mm)
        if table.worst_mm <= worst_mm and not table.missed:
            return table
        # the error goes with the square of the step
        step *= 0.5 if table.missed else max(0.3, min(0.95, 0.98 * math.sqrt(worst_mm / table.worst_mm)))


def _floor(compensator: Compensator, over: Spans) -> float:
    """Return what columns leave where they need no interpolation, as it would be stated [mm]."""
    points = workspace_points(workspace_of(compensator.robot))[::7]
    columns = _columns(compensator, compensator.effects, over)
    values = _drawn(columns, over, len(points))
    sign = compensator.robot.joint_sign
    q = compensator.nominal_command(points)[0] * sign
    found = _taken_apart(compensator, points, columns, over, (), q)
    for k, column in enumerate(columns):
        q = q + np.reshape(_factor(column, values), (-1, 1)) * found[:, k]
    at = _channels(compensator, len(points), values)
    return _stated(largest(np.linalg.norm(compensator.missed(q * sign, points, None, at), axis=1)))


def _sampled(compensator: Compensator, over: Spans, step_mm: float, at_most: float | None = None) -> TableCompensator:
    """Return the table whose steps are `step_mm` or a little less."""
    if not step_mm > 0.0:
        raise UsageError(f"the step of a table is {step_mm:g} mm, but must be above 0.")
    space = workspace_of(compensator.robot)
    centre, half = space.box
    origin, extent = centre - half, 2 * half
    cells = np.maximum(np.ceil(extent / step_mm - 1e-9).astype(int), 1)
    columns = _columns(compensator, compensator.effects, over)
    if np.prod(cells + 1.0) * len(columns) > LARGEST_TABLE:
        asked = f"{at_most:g} mm" if at_most is not None else f"a step of {step_mm:g} mm"
        raise NoSolutionError(
            f"a table for {asked} needs more than {LARGEST_TABLE} corrections. "
            "Allow a larger one, or export the C source, which needs no grid."
        )
    step = extent / cells
    axes = [origin[i] + step[i] * np.arange(cells[i] + 1) for i in range(3)]
    nodes = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    unit = to_internal(compensator.mechanism.joint_unit)
    sign = compensator.robot.joint_sign
    nominal = compensator.nominal_command(nodes)[0] * sign
    corrections = _taken_apart(compensator, nodes, columns, over, (), nominal) * sign / unit
    if len(columns) > 1:  # a column that nothing goes with is rounding
        kept = [k for k in range(len(columns)) if k == 0 or np.nanmax(np.abs(corrections[:, k])) > 0.1**TABLE_DECIMALS]
        columns, corrections = tuple(columns[k] for k in kept), corrections[:, kept]
    table = TableCompensator(
        origin=origin,
        step=step,
        corrections=np.round(corrections, TABLE_DECIMALS).reshape(*(cells + 1), len(columns), -1) * unit,
        worst_mm=math.nan,
        missed=0,
        robot=compensator.robot.name,
        mechanism=compensator.mechanism.name,
        kind=compensator.kind,
        digest=compensator.digest,
        joint_unit=compensator.mechanism.joint_unit,
        tool=np.array(compensator.robot.tool, dtype=float),
        columns=columns,
    )
    left = _table_errors(table, compensator, over, space.radius or 0.0)
    return replace(table, worst_mm=_stated(left.worst_mm), missed=left.missed)


def _table_errors(table: TableCompensator, compensator: Compensator, over: Spans, radius: float) -> RoundTrip:
    """Return what a table leaves at the middles of its cells, faces and edges, and at random points.

    The channels take random values within what was recorded.
    """
    middles = [table.origin[i] + 0.5 * table.step[i] * np.arange(2 * n - 1) for i, n in enumerate(table.nodes)]
    used = _used(table, radius)
    lattice = np.stack(np.meshgrid(*middles, indexing="ij"), axis=-1)[used]
    points = np.vstack([workspace_points(workspace_of(compensator.robot)), lattice.reshape(-1, 3)])
    inside = np.hypot(points[:, 0], points[:, 1]) <= radius * (1 + 1e-12)
    worst, missed = 0.0, 0
    for start in range(0, len(points), _CHUNK):
        part = points[start : start + _CHUNK]
        values = _drawn(_columns(compensator, compensator.effects, over), over, len(part))
        joints = compensator.nominal_command(part)[0] + table.correction(part, values)[0]
        at = _channels(compensator, len(part), values)
        error = np.linalg.norm(compensator.missed(joints, part, None, at), axis=1)
        worst = max(worst, largest(error))
        missed += int((np.isnan(error) & inside[start : start + _CHUNK]).sum())
    return RoundTrip(worst, len(points), missed)


def _used(table: TableCompensator, radius: float) -> np.ndarray:
    """Tell which columns of half steps (2 n_x - 1, 2 n_y - 1) belong to cells that the cylinder meets."""
    used = np.zeros((2 * table.nodes[0] - 1, 2 * table.nodes[1] - 1), dtype=bool)
    edges = [table.origin[i] + table.step[i] * np.arange(table.nodes[i]) for i in range(2)]
    # the point of each interval that is nearest to the axis
    near_x, near_y = (np.clip(0.0, e[:-1], e[1:]) for e in edges)
    for i, j in np.argwhere(np.hypot(near_x[:, None], near_y[None, :]) <= radius):
        used[2 * i : 2 * i + 3, 2 * j : 2 * j + 3] = True
    return used


_TABLE_SCHEMA = "deltacal.table/1"


def _table_header(columns: Sequence[Column], joints: int, unit: str) -> list[str]:
    by = ["".join(f"_{name}" for name in ("by", *column)) if column else "" for column in columns]
    return ["x_mm", "y_mm", "z_mm", *(f"dq{i + 1}_{unit}{suffix}" for suffix in by for i in range(joints))]


def _table_text(table: TableCompensator, compensator: Compensator, over: Spans) -> str:
    unit = file_unit(table.joint_unit)
    count = table.corrections.shape[4]
    n_x, n_y, n_z = table.nodes
    prose: tuple[str, ...] = (
        "Corrections of joint commands: command = nominal inverse position of the target + dq,",
        f"dq1..dq{count} in {unit} as the controller counts, by the position x, y, z in mm of the reference point in",
        "the robot frame {O} (origin at the base centre, z up). Regular grid, z running fastest, then y, then x:",
        "row (i * nodes_y + j) * nodes_z + k, counted from 0, belongs to the node origin + (i, j, k) * step.",
        "Interpolation: trilinear between the 8 nodes of the cell. Blank: out of reach; no target may use such a cell.",
        "worst_mm: worst position error left in the cells that the workspace meets, against the model's own exact",
        "forward position, measured half way between all nodes and at random points. What the model does not know is",
        "not in it. missed: checked points of the workspace without an answer.",
    )
    if len(table.columns) > 1:
        prose += (
            "Columns dq1_..._by_CHANNELS are to be multiplied by those channels and added to dq1: payload in kg,",
            "warming = temp_C - 20, time in h of the recording's clock, approach1 = +1 or -1, the direction in which",
            "the joint last moved. Effects: "
            + ", ".join(t.effect for t in compensator.effects)
            + "; after every jump, and",
            f"at rest. Recorded were: {over.in_words()}; worst_mm holds within these.",
        )
    facts: dict[str, Any] = {
        "schema": _TABLE_SCHEMA,
        "worst_mm": table.worst_mm,
        "missed": table.missed,
        "robot": table.robot,
        "mechanism": table.mechanism,
        "model": compensator.model,
        "kind": table.kind,
        "parameters_sha256": table.digest,
        "tool_mm": [float(v) for v in table.tool],
        "origin_mm": [float(v) for v in table.origin],
        "step_mm": [float(v) for v in table.step],
        "nodes": [n_x, n_y, n_z],
    }
    if len(table.columns) > 1:
        facts["columns"] = [list(column) for column in table.columns]
    lines = [f"# {line}" for line in prose]
    lines += [f"#: {key} = {json.dumps(value)}".replace("\x7f", "\\u007f") for key, value in facts.items()]
    lines.append(",".join(_table_header(table.columns, count, unit)))
    values = table.corrections.reshape(-1, count * len(table.columns)) / to_internal(table.joint_unit)
    places = itertools.product(*([f"{v:.6f}" for v in axis] for axis in _axes(table)))
    for place, row in zip(places, values, strict=True):
        cells = ("" if math.isnan(v) else f"{v:.{TABLE_DECIMALS}f}" for v in row)
        lines.append(",".join((*place, *cells)))
    return "\n".join(lines) + "\n"


def _axes(table: TableCompensator) -> list[Array]:
    return [table.origin[i] + table.step[i] * np.arange(n) for i, n in enumerate(table.nodes)]


def read_table(path: str | Path) -> TableCompensator:
    """Read a table that `export_table` wrote.

    Raises
    ------
    InputError
        The file is not such a table, or not all of it; the message names the line.
    """
    path = Path(path)
    lines = read_text(path).split("\n")
    top = next((n for n, line in enumerate(lines) if not line.startswith("#")), len(lines))
    facts = _table_facts(path, lines[:top])
    header = lines[top].split(",") if top < len(lines) else []
    columns = tuple(tuple(column) for column in facts.get("columns", [[]]))
    joints = len(header[3:]) // len(columns)
    fitting = [u for u in ("deg", "mm") if header == _table_header(columns, joints, u) and joints]
    if not fitting:
        raise _damaged(path, top + 1, "the names of the columns, x_mm,y_mm,z_mm,dq1_deg,..., were expected here")
    unit = "rad" if fitting == ["deg"] else "mm"
    shape = tuple(facts["nodes"])
    rows = [line for line in lines[top + 1 :] if line]
    if len(rows) != math.prod(shape):
        raise _damaged(path, len(lines), f"{math.prod(shape)} rows were expected, but there are {len(rows)}")
    values = np.empty((len(rows), len(header)))
    for n, row in enumerate(rows):
        try:
            values[n] = [float(cell) if cell else math.nan for cell in row.split(",")]
        except ValueError:
            raise _damaged(path, top + 2 + n, f"{len(header)} numbers were expected") from None
    table = TableCompensator(
        origin=np.array(facts["origin_mm"], dtype=float),
        step=np.array(facts["step_mm"], dtype=float),
        corrections=values[:, 3:].reshape(*shape, len(columns), joints) * to_internal(unit),
        worst_mm=float(facts["worst_mm"]),
        missed=int(facts["missed"]),
        robot=facts["robot"],
        mechanism=facts["mechanism"],
        kind=facts["kind"],
        digest=facts["parameters_sha256"],
        joint_unit=unit,
        tool=np.array(facts["tool_mm"], dtype=float),
        columns=columns,
    )
    nodes = np.stack(np.meshgrid(*_axes(table), indexing="ij"), axis=-1).reshape(-1, 3)
    if len(strays := np.flatnonzero(~(np.abs(values[:, :3] - nodes) < 1e-5).all(axis=1))):
        raise _damaged(path, top + 2 + int(strays[0]), "x, y, z are not the node that the header's grid has here")
    return table


def _table_facts(path: Path, lines: list[str]) -> dict[str, Any]:
    """Return what the header of a table states, checked for what `read_table` needs."""
    try:
        facts = tomllib.loads("\n".join(line.removeprefix("#:") if line.startswith("#:") else "" for line in lines))
    except tomllib.TOMLDecodeError as error:
        raise _damaged(path, None, f"the header cannot be read: {error}") from None
    if facts.get("schema") != _TABLE_SCHEMA:
        raise _damaged(path, 1, f"a header with schema = {_TABLE_SCHEMA} was expected")
    numbers = {"worst_mm": 1, "missed": 1, "tool_mm": 3, "origin_mm": 3, "step_mm": 3, "nodes": 3}
    for key, count in numbers.items():
        found = facts.get(key)
        values = found if count > 1 else [found]
        if not (isinstance(values, list) and len(values) == count and all(type(v) in (int, float) for v in values)):
            raise _damaged(path, None, f"{key} in the header is {found!r}; {count} number{'s'[: count > 1]} expected")
    if not (min(facts["nodes"]) >= 2 and all(isinstance(n, int) for n in facts["nodes"]) and min(facts["step_mm"]) > 0):
        raise _damaged(path, None, "the grid in the header needs 2 or more nodes and a positive step along each axis")
    for key in ("robot", "mechanism", "kind", "parameters_sha256"):
        if not isinstance(facts.get(key), str):
            raise _damaged(path, None, f"{key} in the header is missing")
    return facts


def _damaged(path: Path, line: int | None, problem: str) -> InputError:
    return InputError(f"{problem}.", "Export the table again.", file=path, line=line)
