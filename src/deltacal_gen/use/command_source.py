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
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from importlib.resources.abc import Traversable
from typing import Any

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
from deltacal_gen.use.layout import laid_out, plain
from deltacal_gen.use.spans import (
    LEFT_OUT,
    Column,
    Spans,
    channels_of,
    columns_of,
    drawn,
    factor,
    missed,
    scale_of,
    shift,
    tabled,
    taken_apart,
    tidy,
)

FARTHEST = 1.1  # of the workspace's half size: where the polynomials end, and stay what they are there
DEGREE = 6  # of the polynomials over the workspace: 84 coefficients
TURNS = 12  # of the fixed point in C: an effect of the joint angle that steepens by a tenth is then known to 1e-12
NOT_A_NUMBER = 3  # a status, after those of the geometry
_SOURCE = {  # of the kernels, and what it is
    CompensatorKind.EXACT: ("inverse.c", "inverse position of the calibrated machine, by Newton's method"),
    CompensatorKind.LINEAR: (
        "linear.c",
        "nominal joints and the first-order change that undoes the errors (Bai 2015, eq. 23)",
    ),
}


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
                scale, since = scale_of(s, self.compensator.begun)
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


def command_source(compensator: Compensator, left: RoundTrip, live: LiveEffects | None = None) -> str:
    """Return the text of the C99 file of a compensator of geometry alone, and of the effects that `live` adds to it."""
    mechanism, robot = compensator.mechanism, compensator.robot
    kernels = importlib.resources.files("deltacal_kernels").joinpath(mechanism.name)
    constants = compensator._constants[0]
    if compensator.kind is CompensatorKind.EXACT:
        constants = constants[:, : compensator._kernels.COMMAND_CONSTANTS]
    source, method = _SOURCE[compensator.kind]
    return laid_out(
        "command.c",
        name=plain(robot.name),
        mechanism=mechanism.name,
        kind=compensator.kind,
        method=method,
        model=compensator.model,
        errors=sum(1 for v in robot.errors.values() if v),
        digest=compensator.digest,
        left=left,
        workspace=_workspace_in_words(robot),
        corrected=LEFT_OUT if compensator.corrected else "",
        target_words=_target_in_words(mechanism),
        unit=file_unit(mechanism.joint_unit),
        not_a_number=NOT_A_NUMBER,
        limbs=mechanism.limbs,
        home=_as_files(mechanism, turned(robot, workspace_of(robot).home[None]))[0],
        checks=list(_checks(compensator, live)),
        turning=mechanism.turning,
        constants=constants,
        tool=robot.tool,
        sign=robot.joint_sign,
        geometry=kernels.joinpath(source).read_text(encoding="utf-8"),
        live=live,
        **({} if live is None else _of_effects(live)),
    )


def _of_effects(live: LiveEffects) -> dict[str, Any]:
    """Return what the template says of effects."""
    compensator, mechanism = live.compensator, live.compensator.mechanism
    limbs, read = mechanism.limbs, _fields(compensator)
    factors = {s.name: _factor(s, compensator) for s in read if s.per == "machine"}
    factors |= {
        s.column.format(i=i + 1): s.c99.format(i=i, sign="")
        for s in read
        for i in range(limbs if s.per == "joint" else 0)
    }
    smooth = f"polynomials of degree {DEGREE}, first order in each channel"
    return {
        "effects": [
            *(
                f"{t.effect}{at(compensator.robot, t.limbs)}: {'closed form' if t in live.known else smooth}"
                for t in compensator.effects
            ),
            *(f"(not {t.effect}: it belongs to the instrument)" for t in compensator.instrument),
        ],
        "ranges": live.over.in_channels(compensator.begun),
        "begun": compensator.begun,
        "fields": [f"{_field(s)}[{limbs}]" if s.per == "joint" else _field(s) for s in read],
        "sources": [f.read_text(encoding="utf-8") for f in dict.fromkeys(effect_source(t) for t in live.known)],
        "joint_unit": mechanism.joint_unit,
        "target": f"target[{len(mechanism.asks)}]" if mechanism.turning else "target_mm[3]",
        "degree": DEGREE,
        "turns": TURNS,
        "farthest": FARTHEST,
        "box": list(zip(*(ends.tolist() for ends in _box(compensator)), strict=True)),
        "round": workspace_of(compensator.robot).radius is not None,
        "factors": [" * ".join(factors[c] for c in column) or "1.0" for column in live.columns],
        "terms": list(_terms(live)),
    }


def _terms(live: LiveEffects) -> Iterator[tuple[str, int, list[str], Array, list[float]]]:
    """Yield effects limb by limb (from 0), with their states as C writes them, coefficients and constants."""
    for t in live.known:
        constants = [v if isinstance(v, float) and math.isfinite(v) else 0.0 for v in t.constants] or [0.0]
        for row, limb in enumerate(t.limbs or range(1, live.compensator.mechanism.limbs + 1)):
            states = [_state(s, (s.joint or limb) - 1, live.compensator) for s in t.states]
            yield t.effect, limb - 1, states, t.values[row if t.limbs else 0], constants


def _state(state: State, i: int, compensator: Compensator) -> str:
    """Return a state as C writes it for a joint (from 0)."""
    return _since(state, compensator).format(i=i, sign=f"DELTACAL_SIGN[{i}] * ", turned=repr(_turned(compensator)))


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


def _factor(channel: State, compensator: Compensator) -> str:
    """Return a channel of the machine as corrections go with it, in C."""
    scale, text = scale_of(channel, compensator.begun)[0], _since(channel, compensator)
    text = text if scale == 1.0 else f"{text} / {scale!r}"
    return f"({text})" if " " in text else text


def _turned(compensator: Compensator) -> float:
    """Return by how much a joint's motor or pulley turns per unit of the joint [rad per rad or mm]."""
    transmission = compensator.robot.transmission
    around = transmission.pulley_circumference if transmission is not None else None
    return 2 * math.pi / around if compensator.mechanism.joint_unit == "mm" and around else 1.0


def _checks(compensator: Compensator, live: LiveEffects | None) -> Iterator[tuple[str, list[tuple[str, str]]]]:
    """Yield, function by function, targets with their joints as a controller would print them."""
    robot, mechanism = compensator.robot, compensator.mechanism
    checks = turned(robot, np.round(workspace_points(workspace_of(robot))[[-3, -7, -70]], 3))
    joints, status = compensator.command(checks)
    by = [("" if live is None else " of deltacal_compensate", joints)]
    if live is not None:
        by.append((" of deltacal_command, at as above", live.command(checks, live.usual[0])))
    given = _as_files(mechanism, checks)[status == SOLVED]
    for function, found in by:
        told = found[status == SOLVED] / to_internal(mechanism.joint_unit)
        yield function, [(_decimals(x, 3), _decimals(q, 9)) for x, q in zip(given, told, strict=True)]


def _decimals(values: Array, places: int) -> str:
    return ", ".join(f"{v:.{places}f}" for v in values)


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


def _target_in_words(mechanism: Machine) -> str:
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
