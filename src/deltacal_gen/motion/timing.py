"""Two clocks set against each other by what drives give: offset and rate, found together with bodies and friction.

What a drive gives is linear in base parameters and friction, which are projected out joint by joint; what the rest
changes by when joints come a little later tells the clocks. A joint whose own readings come late beside those of the
others takes no part: its delay is told as `latency`.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.machine.values import Robot
from deltacal_gen.motion import alignment
from deltacal_gen.motion.alignment import GRID, Alignment, Bar, Made
from deltacal_gen.motion.clocks import Clock, DriveClocks
from deltacal_gen.motion.derivatives import motion
from deltacal_gen.motion.joint import USUAL, Joint, Series
from deltacal_gen.motion.ladder import BUYS
from deltacal_gen.motion.library import Rung
from deltacal_gen.motion.rigid import Rigid
from deltacal_gen.motion.session import series
from deltacal_gen.results.motion import MotionModel

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

Progress = Callable[[str], None]
BAR = Bar(follows=0.5, as_good=1.3, exact=1e-4)  # friction at a reversal is not known: so much is nothing
FINER = 10  # functions between offsets that are looked at: straight between these
RANK = 1e-9  # of the largest singular value: a smaller one is none


@dataclass(frozen=True)
class Beside:
    """What a joint's drive has beside the rigid machine: rungs, and by how much its readings come late [s]."""

    rungs: tuple[Rung, ...] = tuple(Rung(name) for name in USUAL)
    delay: float = 0.0


def beside_of(found: MotionModel) -> dict[int, Beside]:
    """Return what an answer knows of each joint's drive, by its number."""
    return {
        model.joint: Beside(tuple(Rung(t.effect, t.constants) for t in model.terms), model.delay or 0.0)
        for model in found.joints
    }


def aligned(
    robot: Robot,
    given: DriveClocks,
    beside: Mapping[int, Beside] | None = None,
    *,
    start: Clock | None = None,
    progress: Progress = lambda text: None,
) -> Alignment:
    """Set the clocks of a recording against each other.

    Parameters
    ----------
    beside : mapping, optional
        What is known of joints, by their number; usual friction by default.
    start : Clock, optional
        Where they stand about; looked for by default.

    Raises
    ------
    InputError
        The clocks cannot be set by these readings; the message says why.
    """
    progress("where the clocks stand")
    rigid, known = Rigid(robot), dict(beside or {})
    clock = start
    if clock is None:
        clock = alignment.first(given, lambda runs: _made(rigid, given, runs), BAR)
    out = set[int]()

    def step(at: Clock) -> tuple[Array, Array]:
        return _step(robot, rigid, given, at, known, out)[:2]

    while True:
        found = alignment.settled(given, clock, step, beside="bodies or friction")
        *_, apart = _step(robot, rigid, given, found.clock, known, out)
        if len(apart) < 2 or max(own.buys for own in apart.values()) < BUYS:
            return found
        middle = float(np.median([own.shift for own in apart.values()]))
        out.add(max(apart, key=lambda j: abs(apart[j].shift - middle)))
        clock = found.clock


@dataclass(frozen=True)
class _Own:
    """By how much a joint alone would shift the clocks [s], and what part of its rms that would take away."""

    shift: float
    buys: float


def _step(
    robot: Robot, rigid: Rigid, given: DriveClocks, clock: Clock, beside: Mapping[int, Beside], out: set[int]
) -> tuple[Array, Array, dict[int, _Own]]:
    """Return what all unknowns together move the clocks by, their standard deviations, and what each joint would.

    Joints `out` take no part.
    """
    count = 1 if given.shared else len(clock.offsets)
    size = count + given.rated
    G, g, apart = np.zeros((size, size)), np.zeros(size), dict[int, _Own]()
    step = given.readings.step
    sides = [Clock(clock.offsets + by, clock.rate) for by in (0.0, step, -step)]
    at = [series(robot, then, motion(then), rigid) for then in map(given.at, sides)]
    for here, after, before in zip(*at, strict=True):
        joint = here.at(beside.get(here.number, Beside()).delay)
        if here.number in out or not joint.moves or joint.silent:
            continue
        rungs = beside.get(here.number, Beside()).rungs
        left, by_time, fitted = _projected(joint, (after, before), rungs, step)
        run, time = here.run[joint.rows], here.time[joint.rows]
        runs = np.ones((len(run), 1)) if given.shared else run[:, None] == np.arange(count)
        columns = by_time[:, None] * runs
        if given.rated:
            columns = np.column_stack([columns, by_time * time])
        columns = columns - fitted @ (fitted.T @ columns)
        together = joint.correlated(left)
        variance = float(left @ left) / max(len(left) / together - fitted.shape[1] - size, 1.0)
        G += columns.T @ columns / variance
        g += columns.T @ left / variance
        later = columns[:, :count].sum(axis=1)
        shift = float(later @ left) / max(float(later @ later), 1e-300)
        taken = shift * float(later @ left) / max(float(left @ left), 1e-300)
        apart[here.number] = _Own(shift, 1.0 - float(np.sqrt(1.0 - min(taken, 1.0))))
    scale = np.sqrt(np.diag(G))
    seen = scale > 0
    unit = np.where(seen, scale, 1.0)
    inverse = np.linalg.pinv(G / np.outer(unit, unit), rcond=1e-12, hermitian=True)
    std = np.where(seen, np.sqrt(np.maximum(np.diag(inverse), 0.0)) / unit, np.inf)
    return inverse @ (g / unit) / unit, std, apart


def _projected(
    joint: Joint, sides: tuple[Series, Series], rungs: Sequence[Rung], step: float
) -> tuple[Array, Array, Array]:
    """Return what a fit of bodies and rungs leaves (M,), and the derivative (M,) of that fit by the joints' time.

    The third, (M, r), is orthonormal: all that bodies and rungs could give.
    """
    load = joint.load_by(None)
    X = joint.columns(rungs, load)
    size = np.linalg.norm(X, axis=0)
    X = X[:, size > 0] / size[size > 0]
    U, s, Vt = np.linalg.svd(X, full_matrices=False)
    kept = s > RANK * s[0]
    U = U[:, kept]
    found = np.zeros(len(size))
    found[size > 0] = (Vt[kept].T @ ((U.T @ joint.y) / s[kept])) / size[size > 0]
    each = [_asked(side.at(joint.delay), joint, rungs, found) for side in sides]
    by_time = np.nan_to_num((each[0] - each[1]) / (2 * step))
    return joint.y - U @ (U.T @ joint.y), by_time, U


def _asked(other: Joint, joint: Joint, rungs: Sequence[Rung], found: Array) -> Array:
    """Return what a joint's drive would give (M,) at its samples, its joints at other times; nan of those at rest."""
    whole = np.full(len(joint.used), np.nan)
    whole[other.rows] = other.columns(rungs, other.load_by(None)) @ found + other.carried
    return whole[joint.rows]


def _made(rigid: Rigid, given: DriveClocks, runs: Sequence[int]) -> list[Made]:
    """Return the readings of each joint, and what bodies and usual friction are made of in some runs."""
    tables: list[list[tuple[int, Array, Array]]] = [[] for _ in range(given.joints.joints.shape[1])]
    for run, movement in given.movements:
        if run not in runs:
            continue
        times = np.arange(movement.start, movement.end, GRID / FINER)
        states = np.stack([movement(times, order) for order in range(3)])
        for j, X in enumerate(rigid.columns(states)):
            speed = states[1, :, j]
            tables[j].append((run, times, np.column_stack([np.ones(len(times)), np.sign(speed), speed, X])))
    out = []
    for j, own in enumerate(tables):
        readings = given.readings.readings[:, [j]]
        if not own or not np.nanstd(readings) > 0:  # nothing was read, or always the same
            continue
        size = np.sqrt(sum(np.sum(c**2, axis=0) for *_, c in own))
        used = size > 0
        scaled = [(r, t, c[:, used] / size[used]) for r, t, c in own]
        out.append(Made(readings, scaled))
    return out
