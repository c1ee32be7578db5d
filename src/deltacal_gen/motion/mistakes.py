"""Mistakes of a recording in motion that its own samples show: columns exchanged, another unit, a sign that is lost."""

from __future__ import annotations

import dataclasses
import itertools
import math
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np
from scipy.optimize import linear_sum_assignment

from deltacal_gen.errors import MisreadReadings
from deltacal_gen.files.robot import robot_size
from deltacal_gen.machine.registry import Array
from deltacal_gen.motion.fit import Fit, fitted
from deltacal_gen.motion.joint import FEW, USUAL, Joint
from deltacal_gen.motion.library import Rung
from deltacal_gen.motion.regression import Bench
from deltacal_gen.motion.session import Session
from deltacal_gen.units import DEG, of_joints

LOOKED_AT = 2000  # samples of two joints on which mistakes are tried
NEARER = 0.5  # of what is left held out: what an exchange must leave of every reading that it moves, at most
STEEL = 7.85e-6  # kg/mm^3, of a cube half as wide as the machine is long
NO_FARTHER = 1.1  # times what is left: what another unit of joints may leave of any drive
SMALL = 7.0  # deg or mm, of all joints: as radians a turn, as metres the largest machines
SI = {"rad": (DEG, 1 / DEG, "radians"), "mm": (1.0, 1000.0, "metres")}  # by joint unit: one in files, how many in SI
REMEDY = {"radians": "those in radians by 57.29578 for _deg", "metres": "those in metres by 1000 for _mm"}
DOWN = 0.02  # of a reading's rms: so near to zero it comes
BOTH_WAYS = 0.1  # of the samples in motion, at least, in either direction
PREFIXES = {1e3: "m", 1e-3: "k", 1e6: "u"}  # of a unit in which readings are so many times as large
ROUGH = 3.0  # times that a body may be heavier or lighter than its file says, and its drive still be the one
KNOWN = 10.0  # standard deviations that a factor must have
EXPLAINED = 0.1  # of what common bodies leave above noise: what a factor may leave that explains it
SINGULAR = 1e-13  # of the largest: a smaller eigenvalue is none, of columns one of which may count a million times
ABOVE = 2.0  # of the noise: less is left by bodies that all drives agree on


def check(session: Session) -> None:
    """Raise an InputError where columns of drives are exchanged, or count in another unit than they say.

    Effects found in such a recording, and bodies, would be none of the machine's.
    """
    for text, remedy in itertools.chain(_of_joints(session), _exchanged(session), _other_units(session)):
        raise MisreadReadings(text, remedy, file=session.given.path)


def too_heavy(session: Session, fits: Sequence[Fit]) -> Iterator[str]:
    """Yield which drives would carry more than steel of the machine's size weighs: their unit may be another one."""
    size, g = robot_size(session.robot), float(np.linalg.norm(session.rigid.dynamics.gravity))
    for fit in fits if size > 0 and g > 0 else ():
        column, unit = session.given.columns[fit.joint.number - 1], fit.joint.unit
        per_kg = (g + _shaken(session, fit.joint, size)) * (size if unit == "Nm" else 1.0)
        carried = float(np.median(np.abs(fit.load) / per_kg))  # kg, at the farthest
        if unit in ("Nm", "N") and carried > STEEL * (size / 2) ** 3:
            yield (
                f"joint {fit.joint.number} would carry {carried:.3g} kg at the end of its links, more than steel of "
                f"such a size weighs: {column} may be in m{unit}"
            )


def _shaken(session: Session, joint: Joint, size: float) -> Array:
    """Return the acceleration (M,) [m/s^2], at most, against which a joint moves what is `size` [mm] away from it.

    What its own speed does points to its axis, and is no torque about it.
    """
    _, speeds, accelerations = np.abs(np.nan_to_num(session.motion.states[:, joint.rows]))
    turns = np.array(of_joints(session.given.joint_unit, speeds.shape[1])) == "rad"
    own = joint.number - 1
    pulls = speeds[:, turns].sum(axis=1) ** 2 - (speeds[:, own] ** 2 if turns[own] else 0.0)
    mm = size * (accelerations[:, turns].sum(axis=1) + pulls) + accelerations[:, ~turns].sum(axis=1)
    return np.asarray(mm / 1000)


def sizes_alone(fits: Sequence[Fit]) -> Iterator[str]:
    """Yield which drives come down to zero and never read below it, though their joints move both ways."""
    numbers = []
    for fit in fits:
        y, ahead = fit.joint.series.y[fit.joint.rows], float(np.mean(fit.joint.states["qd"] > 0))
        if 0 <= y.min() < DOWN * np.sqrt(np.mean(y**2)) and BOTH_WAYS < ahead < 1.0 - BOTH_WAYS:
            numbers.append(str(fit.joint.number))
    if numbers:
        yield (
            f"readings of joint {', '.join(numbers)} come down to zero and are never below, though it moves both ways: "
            "their size may have been recorded without their sign"
        )


def _of_joints(session: Session) -> Iterator[tuple[str, str]]:
    """Yield whether joints count in radians or metres: numbers so small, and drives that larger ones foretell."""
    given = session.given
    factors, names = np.ones(len(session.joints)), list[str]()
    for unit, (inside, factor, said) in SI.items():
        own = [k for k, of in enumerate(of_joints(given.joint_unit, len(factors))) if of == unit]
        if own and float(np.max(np.abs(given.joints[:, own]))) < SMALL * inside:
            factors[own] = factor
            names.append(said)
    if not names:
        return
    larger = Session.of(
        session.robot,
        dataclasses.replace(given, joints=given.joints * factors, recorded=given.recorded * factors, moved=None),
    )
    now, then = (
        {joint.number: _left_of_usual(joint) for joint in each.joints if joint.moves and not joint.silent}
        for each in (session, larger)
    )
    ratios = [then[k] / now[k] for k in now if k in then and now[k] > 0]
    if ratios and min(ratios) < NEARER and max(ratios) < NO_FARTHER:
        yield (
            f"joints count in {' and '.join(names)}, by what drives give: so read they foretell samples that took no "
            f"part up to {1 / min(ratios):.3g} times as well, and none worse.",
            f"Multiply the columns: {', '.join(REMEDY[name] for name in names)}.",
        )


def _left_of_usual(joint: Joint) -> float:
    """Return what is left of a joint's held-out samples by the rigid machine and usual friction, rms."""
    X = joint.columns([Rung(name) for name in USUAL], joint.carried)
    bench = joint.bench(X)
    return math.sqrt(bench.held_out(range(X.shape[1]), bench.folds)) if len(bench.folds) > 1 else math.inf


def _exchanged(session: Session) -> Iterator[tuple[str, str]]:
    """Yield which readings follow the movement of one another's joints, and what to do."""
    joints, given = session.moving, session.given
    columns = [joint.columns([Rung(name) for name in USUAL], joint.carried) for joint in joints]
    own, other = np.ones((len(joints), len(joints))), np.full((len(joints), len(joints)), np.inf)
    for n, k in itertools.permutations(range(len(joints)), 2):
        both = _where_both_move(joints[n], joints[k])
        if both is not None and joints[n].readout == joints[k].readout:
            y = given.readings[both, joints[n].number - 1] * joints[n].readout.inside
            own[n, k], other[n, k] = (_held_out(joints[m], columns[m], both, y) for m in (n, k))
    cost = np.log(np.clip(other / own, 1e-300, 1e300))
    np.fill_diagonal(cost, 0.0)
    _, of = linear_sum_assignment(cost)
    for cycle in _cycles(of):
        if not all(other[n, of[n]] < NEARER * own[n, of[n]] for n in cycle):
            continue
        names = {n: given.columns[joints[n].number - 1] for n in cycle}
        unit, inside = joints[cycle[0]].unit, joints[cycle[0]].readout.inside
        each = [
            f"{other[n, of[n]] / inside:.3g} instead of {own[n, of[n]] / inside:.3g} {unit} of {names[n]}"
            for n in cycle
        ]
        yield (
            f"the readings of joints {' and '.join(str(joints[n].number) for n in sorted(cycle))} are exchanged: each "
            f"follows the movement of another joint, which leaves {' and '.join(each)} of samples that took no part.",
            f"Rename columns in its first line: {', '.join(f'{names[n]} is {names[int(of[n])]}' for n in cycle)}.",
        )


def _where_both_move(one: Joint, other: Joint) -> np.ndarray | None:
    """Return some of the samples (K,) at which two joints move; None where there are too few."""
    both = np.intersect1d(one.rows, other.rows)
    return both[:: max(1, len(both) // LOOKED_AT)] if len(both) > FEW else None


def _held_out(joint: Joint, X: Array, rows: np.ndarray, y: Array) -> float:
    """Return what is left of readings (K,) at some of a joint's samples by its own movement, rms of held-out ones."""
    at = np.searchsorted(joint.rows, rows)
    bench = Bench.of(X[at], y - joint.carried[at], joint.fold[at], joint.usual)
    return math.sqrt(bench.held_out(range(X.shape[1]), bench.folds)) if len(bench.folds) > 1 else math.inf


def _cycles(of: np.ndarray) -> list[list[int]]:
    """Return the members of each cycle of a permutation, of those that move something."""
    found, seen = [], set[int]()
    for n in range(len(of)):
        cycle = []
        while n not in seen:
            seen.add(n)
            cycle.append(n)
            n = int(of[n])
        if len(cycle) > 1:
            found.append(cycle)
    return found


def _other_units(session: Session) -> Iterator[tuple[str, str]]:
    """Yield which readings count in another unit than they say, and what to do."""
    than, factors = "what the bodies in the robot file ask for", _by_stated(session)
    if not factors:
        than, factors = "what bodies ask for of which the other drives tell", _by_others(session)
    for factor in dict.fromkeys(factors.values()):
        numbers = [number for number, own in factors.items() if own == factor]
        names = ", ".join(session.given.columns[number - 1] for number in numbers)
        unit, one = session.given.units[numbers[0] - 1], len(numbers) == 1
        by = f"Divide the column{'s' * (not one)} by {factor:g}" if factor > 1 else f"Multiply by {1 / factor:g}"
        yield (
            f"{names} read{'s' * one} {factor:g} times {than}: as {PREFIXES[factor]}{unit} would.",
            f"{by}, or correct the robot file (masses in kg, lengths in mm).",
        )


def _by_stated(session: Session) -> dict[int, float]:
    """Return by drive how many times its readings are what bodies ask for that the robot file states, all of them."""
    known, factors = session.stated(), dict[int, float]()
    for joint in [] if known is None else known.moving:
        if joint.X.shape[1]:  # what is not stated may do anything
            continue
        y = joint.y + joint.carried
        whole = dataclasses.replace(joint, X=joint.carried[:, None], y=y, carried=np.zeros(len(y)))
        fit = fitted(whole, [Rung(name) for name in USUAL])
        times = fit.coefficients[0]
        near = [f for f in PREFIXES if 1 / ROUGH < times / f < ROUGH]
        if near and times > KNOWN * fit.std[0]:
            factors[joint.number] = near[0]
    return factors


def _by_others(session: Session) -> dict[int, float]:
    """Return the drive whose readings are so many times what bodies ask for of which the others tell."""
    joints = session.moving
    if len(joints) < 2 or not all(joint.readout.forces for joint in joints):
        return {}
    each = [_asked(session, fitted(joint, [Rung(name) for name in USUAL])) for joint in joints]
    free = sum(part.own for part in each)
    plain = _left(each, np.ones(len(each))) - free
    tried = [(factor, n) for factor in PREFIXES for n in range(len(each))]
    left = [_left(each, np.where(np.arange(len(each)) == n, factor, 1.0)) - free for factor, n in tried]
    factor, n = tried[int(np.argmin(left))]
    return {joints[n].number: factor} if plain > ABOVE * free and min(left) < EXPLAINED * plain else {}


class _Asked(NamedTuple):
    """Normal equations of common base parameters by one drive beside usual friction, and what a fit of its own leaves.

    All by the noise of that fit, samples that hang together counted as one.
    """

    G: Array
    g: Array
    yy: float
    own: float


def _asked(session: Session, fit: Fit) -> _Asked:
    own, chosen = session.rigid.own[fit.joint.number - 1], session.rigid.common.chosen
    X = fit.beside_effects(fit.joint.X @ own.made_up[:, chosen])
    y = fit.beside_effects((fit.left + fit.load - fit.joint.carried)[:, None])[:, 0]
    weight = 1.0 / (fit.sigma**2 * fit.together)
    return _Asked(weight * X.T @ X, weight * X.T @ y, weight * float(y @ y), weight * float(fit.left @ fit.left))


def _left(each: Sequence[_Asked], factors: Array) -> float:
    """Return chi2 of base parameters common to all drives, whose readings count so many times too much."""
    G = sum(f**2 * part.G for f, part in zip(factors, each, strict=True))
    g = sum(f * part.g for f, part in zip(factors, each, strict=True))
    size = np.sqrt(np.maximum(np.diag(G), 1e-300))
    told = (g / size) @ np.linalg.pinv(G / np.outer(size, size), rcond=SINGULAR, hermitian=True) @ (g / size)
    return float(sum(part.yy for part in each) - told)
