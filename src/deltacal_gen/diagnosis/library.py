"""Every form of every effect that a recording can carry, and what it lacks for the others."""

from __future__ import annotations

import itertools
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from deltacal_gen.diagnosis.candidates import columns_read
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.identification.orders import ORDERS
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.targets import parts_of
from deltacal_gen.physics.terms import (
    LOGGED,
    Constant,
    Kernels,
    Point,
    Term,
    displaces_points,
    effect_names,
    load_effect,
)
from deltacal_gen.physics.undefined import lacking, undefined
from deltacal_gen.results.parts import Missing
from deltacal_gen.states import CHANNELS, RECORDED, TIME, State, named, read_by

Form = tuple[Constant, ...]  # the constants before one that is searched

HARMONICS = 5  # multiples of the gear ratio that are searched
MOST_TIMES = 300  # of a jump that are searched
SIZES = (0.15, 3.0)  # of what a state becomes: a size beyond either end is not told from none, or from a straight line
SIZE_STEP = 1.6  # from a size that is searched to the next: half way between two, 99 % of the gain is seen
NEIGHBOURS = 4  # of a pose, among which others are counted
SAME_POSE = 1e-6  # of each joint's travel: poses closer together are one
MIXED = 0.5  # of the neighbours that poses in any order have beyond a moment: fewer, and it is a place as well
NOTHING = {
    "orders": "a joint that turns",
    "moments": "like poses before and after a moment",
    "joints": "a second joint that moves",
    "columns": "a column that has no other meaning, of what a part may tilt with",
    "clocks": "the column time_s, or one that counts on (cycle, order)",
    "sizes": "readings under a load, or at different times",
}


def library(problem: Problem) -> tuple[list[Term], tuple[Missing, ...]]:
    """Return every form of every effect that the recording can carry, and those it cannot with what is missing.

    Effects of parts that the mechanism does not have are neither.
    """
    limbs, tools = tuple(range(1, problem.mechanism.limbs + 1)), _tools(problem)
    terms: list[Term] = []
    missing: list[Missing] = []
    for name in effect_names():
        if problem.body.foreign(name):
            continue
        if why := _spoilt(problem, name) or problem.body.missing(name) or _constant(problem, name):
            missing.append(Missing(name=name, missing=why))
            continue
        forms = _forms(problem, name)
        if not forms:
            missing.append(Missing(name=name, missing=NOTHING[next(iter(load_effect(name).SEARCHED))]))
        terms += [problem.body.blank(name, limbs, constants, tools) for constants in forms]
    return terms, tuple(missing)


def defined(at: Fit, terms: Sequence[Term]) -> tuple[list[Term], tuple[Missing, ...]]:
    """Return the terms that say at every reading by how much they move something, and what the others lack."""
    problem, machine = at.problem, at.machine
    rows, kept = np.unique(problem.readings.rows), []
    missing: list[Missing] = []
    for name, own in itertools.groupby(terms, key=lambda term: term.effect):
        forms = list(own)
        if forms[0].kernels.ACTS_ON != "reading":
            lost = undefined(problem.body, forms[0], machine.upright, machine.q, machine.rows)[rows]
            if lost.any():
                lines = problem.recording.line[rows[lost]].tolist()
                missing.append(Missing(name=name, missing=lacking(forms[0], lines)))
                continue
        kept += forms
    return kept, tuple(missing)


def _spoilt(problem: Problem, name: str) -> str | None:
    """Return what is wrong with a column that an effect reads: values that cannot be, or blank cells."""
    recording = problem.recording
    if any(s.kind == "load" for s in read_by(load_effect(name))) and problem.robot.masses is None:
        return None  # the column would not help
    rows = np.unique(problem.readings.rows)
    for column in columns_read(problem, [problem.body.blank(name, (1,))]):
        if column in recording.doubts:
            return f"values that can be in the column {column} ({recording.doubts[column]})"
        values = recording.channels.get(column)
        if values is not None and len(empty := rows[~np.isfinite(values[rows])]) and problem.body.missing(name):
            where = f"{len(empty)} of {len(rows)} are blank, the first in line {recording.line[empty[0]]}"
            return f"every cell of the column {column} ({where})"
    return None


def _constant(problem: Problem, name: str) -> str | None:
    """Return why an effect could not show: its channel does not vary, its columns do not exist, or it is geometry."""
    kernels = load_effect(name)
    rows = np.unique(problem.readings.rows)
    kind = problem.readings.kind
    for channel in (c for s in read_by(kernels) for c in s.channels if c.column == s.shown):
        if channel.differing and not _differs(problem, channel, rows):
            return channel.differing
    if problem.recording.measurement.clock and not kernels.PER_LIMB and "qd" in kernels.STATE:
        return "one clock: where the instrument has its own, an offset of the clocks does the same"
    if problem.recording.begins_anew and _by_the_clock(kernels):
        return "one clock: the time of this recording begins anew with a run"
    if unseen(problem, name):
        return f"readings of the platform; those of the kind {kind.name} see joints alone"
    if kernels.ACTS_ON == "reading" and not any(t in kind.targets for t in kernels.TARGETS):
        return f"readings of another kind than {kind.name}"
    if displaces_points(kernels) and len(_tools(problem)) < 2:
        return "readings of a second point of the platform, at two poses or more"
    parts = parts_of(kernels.TARGETS)
    if not kernels.STATE and len(parts) == len(kernels.TARGETS):
        moves = problem.mechanism.moves(problem.robot)
        moved = {error for part in parts for error in moves.get(part, {})}
        if {p.name for p in problem.mechanism.parameters if p.error in moved} <= set(problem.names):
            return "a smaller model: this one fits these errors as geometry"
    return None


def _by_the_clock(kernels: Kernels) -> bool:
    """Tell whether an effect asks what time it is, not how long ago something was."""
    return "clocks" in kernels.SEARCHED or any(c.column == TIME for s in read_by(kernels) for c in s.channels)


def unseen(problem: Problem, name: str) -> bool:
    """Tell whether readings look at joints alone, and an effect moves none."""
    return problem.readings.kind.sees_joints and "joint" not in load_effect(name).TARGETS


def _differs(problem: Problem, channel: State, rows: np.ndarray) -> bool:
    """Tell whether a channel, of some joint or of its own, varies among rows; one that is not recorded may."""
    values = problem.body.channels.get(channel.base)
    if values is None:
        return True
    own = values[rows] if not channel.joint else values[rows, channel.joint - 1]
    own = own[np.isfinite(own).reshape(len(own), -1).all(axis=1)]
    return bool(len(own) and np.ptp(own, axis=0).max() > 0)


def _tools(problem: Problem) -> list[Point]:
    """Return the points that are read at more than one pose: where one sits that was read once, is what it reads."""
    used = np.unique(problem.readings.rows)
    points, point = np.unique(np.round(problem.body.tool[used], 9), axis=0, return_inverse=True)
    of_pose = np.unique(np.column_stack([point.ravel(), problem.body.q[used]]), axis=0)[:, 0]
    often = np.bincount(of_pose.astype(int), minlength=len(points)) > 1
    return [(x, y, z) for x, y, z in points[often].tolist()]


def _forms(problem: Problem, name: str) -> list[tuple[Constant, ...]]:
    """Return the constants of every form of an effect that is searched."""
    kernels = load_effect(name)
    how = {constant: kind for kind, constant in kernels.SEARCHED.items()}
    forms: list[tuple[Constant, ...]] = [()]
    for key, *_ in kernels.CONSTANTS:
        forms = [(*form, value) for form in forms for value in SEARCHES[how[key]](problem, kernels, form)]
    return forms


def _orders(problem: Problem, kernels: Kernels, form: Form) -> list[float]:
    """Return the orders of a periodic error."""
    orders = {float(k) for k in range(1, ORDERS + 1)}
    ratio = problem.robot.transmission.gear_ratio if problem.robot.transmission else None
    if ratio:
        orders |= {ratio * k for k in range(1, HARMONICS + 1)}
    return sorted(orders)


def _moments(problem: Problem, kernels: Kernels, form: Form) -> list[float]:
    """Return the moments at which something may happen."""
    rows = np.unique(problem.readings.rows)
    clock = problem.body.channels.clock[rows]
    times = np.unique(clock)
    edge = max(3, len(times) // 40)  # it needs rows on both sides
    inside = times[edge : len(times) - edge]
    if not len(inside):
        return []
    step = -(-len(inside) // MOST_TIMES)
    some = inside[step // 2 :: step]
    return some[_mixed(problem.body.q[rows], clock, some)].tolist()


def _mixed(q: Array, clock: Array, moments: Array) -> np.ndarray:
    """Tell at which moments (M,) the poses before and after are like ones; else what has changed may be the place.

    A bed that is probed line by line stands at a new place after every moment. Poses in any order lie among one
    another: of a pose's neighbours so many are on the other side as there are there.
    """
    apart = np.linalg.norm((q[:, None] - q) / np.maximum(np.ptp(q, axis=0), 1e-12), axis=2)
    apart[apart <= SAME_POSE] = np.inf  # the same pose, at any time, tells nothing of the order of others
    near = np.argsort(apart, axis=1, kind="stable")[:, :NEIGHBOURS]
    after = clock >= moments[:, None]
    crossing = (after[:, near] != after[:, :, None]).mean(axis=2)
    small = after == (after.mean(axis=1) < 0.5)[:, None]
    share = np.where(small, crossing, 0.0).sum(axis=1) / np.maximum(small.sum(axis=1), 1)
    expected = 1 - small.mean(axis=1)
    mixed: np.ndarray = share > MIXED * expected
    return mixed


def _joints(problem: Problem, kernels: Kernels, form: Form) -> list[float]:
    """Return the numbers of the joints that others may move with: those that move at all."""
    moving = np.ptp(problem.body.q[np.unique(problem.readings.rows)], axis=0) > 0
    return [float(i + 1) for i in np.flatnonzero(moving)] if len(moving) > 1 else []


def _recorded(problem: Problem, kernels: Kernels, form: Form) -> list[str]:
    """Return the recorded columns that are no state, are whole and vary."""
    rows = np.unique(problem.readings.rows)
    known = {n for s in CHANNELS for n in s.columns(problem.recording.joint_unit, problem.mechanism.limbs)}
    return [
        name
        for name, values in problem.recording.told.items()
        if not (name in known or name in problem.readings.kind.known or name in problem.recording.doubts)
        and not any(s.part(name) for s in RECORDED)
        and np.isfinite(values[rows]).all()
        and np.ptp(values[rows]) > 0
    ]


def _clocks(problem: Problem, kernels: Kernels, form: Form) -> list[str]:
    """Return the columns that count on: the time where it was logged, else what only rises from row to row."""
    rows, time = np.unique(problem.readings.rows), problem.recording.time_s
    if time is not None:
        return [LOGGED] if np.isfinite(time[rows]).all() and LOGGED not in problem.recording.doubts else []
    columns = ((name, problem.recording.channels[name][rows]) for name in _recorded(problem, kernels, form))
    return [name for name, values in columns if (np.diff(values) >= 0).all()]


def sizes(problem: Problem, kernels: Kernels, form: Form) -> list[float]:
    """Return sizes of a state, from a part of the smallest joint's largest to a multiple of the largest one's."""
    body, rows = problem.body, np.unique(problem.readings.rows)
    (of,) = kernels.SIZED.values()
    known = dict(zip((key for key, *_ in kernels.CONSTANTS), form, strict=False))
    state = named(of)
    name = state.chosen(known[state.by]).name if state.by in known else of
    plain = body.mechanism.rows(problem.robot)
    x = np.nan_to_num(body.mechanism.forward(body.q, body.tool, plain)[0])
    values = np.abs(body.state([name], x, body.q, plain)[name][rows])
    most = values.max(axis=0).ravel()
    most = most[most > 0]
    if not len(most):
        return []
    low, high = SIZES[0] * most.min(), SIZES[1] * most.max()
    return np.geomspace(low, high, 2 + int(np.log(high / low) / np.log(SIZE_STEP))).tolist()


# of constants, by how an effect declares that they are searched; and what there is not, where there is none
SEARCHES: Mapping[str, Callable[[Problem, Kernels, Form], Sequence[Constant]]] = {
    "orders": _orders,
    "moments": _moments,
    "joints": _joints,
    "columns": _recorded,
    "clocks": _clocks,
    "sizes": sizes,
}
