"""Whether readings that took no part in finding a law speak for it.

A law is found on a part of the readings and asked for the others: whole poses; the last quarter of the session, where
it goes with time or remembers, for any smooth function follows a random walk on readings in between; blocks of rows,
where what it goes with changes slowly from row to row.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.laws.search import SHARE, Grown, explained, grow, quiet
from deltacal_gen.diagnosis.refits import COMPARED, refitted, terms_of
from deltacal_gen.diagnosis.strategy import borne_out
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import lengths, rms
from deltacal_gen.identification.folds import folds
from deltacal_gen.identification.together import deviance_of
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.law import is_law
from deltacal_gen.physics.terms import Term
from deltacal_gen.states import named

MOST_POSES, SEED = 250, 1859  # on which a law is sought, drawn at random where there are more; all are asked at last
PART = 4  # one of so many parts is asked
LAST = 0.75  # of the session: what comes after is asked
BLOCKS, ASKED = 10, (2, 5, 8)  # blocks of rows, in the order of time, and those that are asked
SLOW = 0.7  # correlation of neighbouring rows above which a state stands in blocks


@dataclass(frozen=True)
class Proof:
    """What a law that was found on a part of the readings is worth on the others.

    Attributes
    ----------
    grown : Grown
        As it was found.
    train, test : (R,) arrays of bool
    rms, without : float
        Of the readings that were asked, and of the same by geometry alone [mm].
    share : float
        Of the variance above the noise in them: what the law takes.
    nearer : bool
        Whether they lie nearer to what is predicted with the law.
    """

    grown: Grown
    train: np.ndarray
    test: np.ndarray
    rms: float
    without: float
    share: float
    nearer: bool

    @property
    def holds(self) -> bool:
        """Whether readings that were asked lie nearer with the law, and it takes most of what stands out of them."""
        return self.nearer and self.share > SHARE


@dataclass(frozen=True)
class Instead:
    """Effects that a law may stand for: together they cost less than it, or are no wrong glasses.

    Attributes
    ----------
    terms : sequence of Term
    price : float
        What all of them have to earn.
    """

    terms: Sequence[Term] = ()
    price: float = 0.0

    def cost(self, part: Problem, base: Fit) -> float:
        """Return the deviance of some readings with the effects, and their price; no bound where there are none."""
        at = refitted(part, base, self.terms, tolerance=COMPARED) if self.terms else None
        return np.inf if at is None else deviance_of(at) + self.price


def proven(problem: Problem, base: Fit, instead: Instead, again: bool = True) -> Proof | None:
    """Return the law that a part of the readings has, and what the others say of it; None where no part has one.

    The last quarter is asked first, which serves for all. Where it does not speak for the law it may lie where nothing
    was read before: of a law that is no function of time alone other parts are asked, if they may be asked `again`.
    """
    proof = _asked(problem, base, instead, _last(problem))
    if proof is not None and (proof.holds or pace(problem, proof.grown.states, proof.grown.remembers) == "time"):
        if proof.holds and pace(problem, proof.grown.states, proof.grown.remembers) == "poses" and _repeated(problem):
            return _asked(problem, base, instead, _poses(problem))
        return proof
    if not again:
        return proof
    proof = _asked(problem, base, instead, _poses(problem))
    if proof is None or (how := pace(problem, proof.grown.states, proof.grown.remembers)) == "poses":
        return proof
    return _asked(problem, base, instead, _blocks(problem)) if how == "blocks" else None


def _repeated(problem: Problem) -> bool:
    """Tell whether poses were read more than once: an error of a pose is then read before and in the last quarter."""
    return len(np.unique(problem.readings.group)) < len(problem.readings)


def pace(problem: Problem, states: Collection[str], remembers: bool) -> str:
    """Return which readings are asked for a law of some states: by ``time``, in ``blocks``, or whole ``poses``.

    What is a function of time alone may be no more than a walk, which goes on otherwise. Of one that has to do with
    what changes from row to row, as no walk does, rows between are asked.
    """
    if remembers:
        return "time"
    channels, rows = problem.body.channels.values, _in_order(problem)
    slow = {s: _slow(channels[s][rows]) for s in states if s in channels and channels[s].ndim == 1}
    if any(named(s).passes for s in states) and all(slow.get(s, True) for s in states):
        return "time"
    return "blocks" if any(slow.values()) else "poses"


def held_out(problem: Problem, fitted: Fit, test: np.ndarray) -> Array:
    """Return errors (R, k) of readings that a fit of others predicts, in standard deviations; NaN of those others."""
    whole = problem.with_terms(fitted.problem.terms, fitted.problem.scale[len(problem.names) :])
    r = whole.residual(fitted.errors, fitted.instrument, whole.poses(fitted.errors))
    out = np.full(r.shape, np.nan)
    out[test] = r[test] / fitted.sigma
    return out


def _asked(problem: Problem, base: Fit, instead: Instead, split: tuple[np.ndarray, np.ndarray]) -> Proof | None:
    """Find a law on a part (R,) of the readings and ask the others."""
    train, test = split
    if test.sum() < 3 or train.sum() < 3:
        return None
    part = problem.subset(np.flatnonzero(train)).some(MOST_POSES, np.random.default_rng(SEED))
    known = [t for t in terms_of(base) if not is_law(t.effect)]
    first = refitted(part, base, known)
    grown = None if first is None else grow(part, first, instead.cost(part, first))
    if first is None or grown is None:
        return None
    return judged(problem, (first, first), grown, train, test)


def judged(problem: Problem, first: tuple[Fit, Fit], grown: Grown, train: np.ndarray, test: np.ndarray) -> Proof:
    """Return what readings (R,) that were asked say of a law; `first`: the others' fits without it, and of geometry."""
    before, alone, after = (held_out(problem, at, test) * at.sigma / grown.fit.sigma for at in (*first, grown.fit))
    share, kept = explained(before, after), quiet(before, after)
    error, without = (rms(lengths((e * grown.fit.sigma)[kept], problem.readings.kind)) for e in (after, alone))
    return Proof(grown, train, test, error, without, share, borne_out(before, after))


def parts(problem: Problem, states: Collection[str], remembers: bool) -> tuple[np.ndarray, np.ndarray, bool]:
    """Return the readings (R,) a law is fitted to, those that are asked, and whether a walk may speak for it."""
    split = {"time": _last, "blocks": _blocks, "poses": _poses}[pace(problem, states, remembers)]
    return *split(problem), split is _last


def _poses(problem: Problem) -> tuple[np.ndarray, np.ndarray]:
    return folds(problem.readings, problem.recording, PART)[0]


def _last(problem: Problem) -> tuple[np.ndarray, np.ndarray]:
    clock = problem.body.channels.clock[problem.readings.rows[:, 0]]
    late = clock > np.quantile(clock, LAST)
    return ~late, late


def _blocks(problem: Problem) -> tuple[np.ndarray, np.ndarray]:
    order = np.argsort(np.argsort(problem.body.channels.clock[problem.readings.rows[:, 0]], kind="stable"))
    asked = np.isin(order * BLOCKS // len(order), ASKED)
    return ~asked, asked


def _in_order(problem: Problem) -> np.ndarray:
    """Return the rows that were read, in the order of time."""
    rows = np.unique(problem.readings.rows)
    order: np.ndarray = rows[np.argsort(problem.body.channels.clock[rows], kind="stable")]
    return order


def _slow(values: Array) -> bool:
    v = values - values.mean()
    size = float((v**2).sum())
    return bool(size > 0 and float((v[1:] * v[:-1]).sum()) > SLOW * size)
