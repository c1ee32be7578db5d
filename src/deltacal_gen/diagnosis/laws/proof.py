"""Whether readings that took no part in finding a law speak for it.

A law is found on a part of the readings and asked for the others: blocks along the path of whole poses, for neighbours
share what no model has; of one that goes with time or remembers the last quarter of the session, for any smooth
function follows a random walk on readings in between.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.laws.search import FormulaFit
from deltacal_gen.diagnosis.refits import refitted, terms_of
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import lengths, rms
from deltacal_gen.identification.folds import stands
from deltacal_gen.machine.registry import Array
from deltacal_gen.states import named

LAST = 0.75  # of the session: what comes after is asked
BLOCK, PART = 8, 4  # poses that stand together in the order of their first visit; of how many such one is asked
SLOW = 0.7  # correlation of neighbouring rows above which a state changes slowly
SHARE = 0.75  # of what stands above the noise: what a law has to take
TRIMMED = 0.03  # of readings: the largest errors, which may be gross
SUPPORTED = 2.0  # standard errors by which predictions have to be better


@dataclass(frozen=True)
class Proof:
    """What a law that was found on a part of the readings is worth on the others.

    Attributes
    ----------
    train, test : (R,) arrays of bool
    rms, without : float
        Of the readings that were asked, and of the same by geometry alone [mm].
    share : float
        Of the variance above the noise in them: what the law takes.
    nearer : bool
        Whether they lie nearer to what is predicted with the law.
    """

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


def parted(problem: Problem, by_time: bool) -> tuple[np.ndarray, np.ndarray]:
    """Return which readings (R,) a law is found on, and which are asked."""
    clock = problem.body.channels.clock[problem.readings.rows[:, 0]]
    if by_time:
        late = clock > np.quantile(clock, LAST)
        return ~late, late
    pose = np.unique(stands(problem.readings, problem.recording), return_inverse=True)[1]
    first = np.full(pose.max() + 1, np.inf)
    np.minimum.at(first, pose, clock)
    visited = np.argsort(np.argsort(first, kind="stable"))
    asked = visited[pose] // max(min(BLOCK, len(first) // (2 * PART)), 1) % PART == PART // 2
    return ~asked, asked


def goes_with_time(problem: Problem, law: FormulaFit) -> bool:
    """Tell whether a law may be no more than a walk, which goes on otherwise: it remembers, or reads time alone.

    What it has to do with that changes from row to row, as no walk does, speaks for it between any two readings.
    """
    if any(t.kernels.MEMORY for t in law.terms):
        return True
    rows = np.unique(problem.readings.rows)
    rows = rows[np.argsort(problem.body.channels.clock[rows], kind="stable")]
    read, channels = {s for t in law.law for s in t.form.states}, problem.body.channels.values
    fast = any(s in channels and channels[s].ndim == 1 and not _slow(channels[s][rows]) for s in read)
    return any(named(s).passes for s in read) and not fast


def _slow(values: Array) -> bool:
    v = values - values.mean()
    return bool((v[1:] * v[:-1]).sum() > SLOW * max((v**2).sum(), 1e-300))


def judged(problem: Problem, law: FormulaFit, train: np.ndarray, test: np.ndarray) -> Proof | None:
    """Return what readings (R,) that were asked say of a law whose numbers the others gave."""
    part = law.fit.problem.with_terms([], np.zeros(0))
    without = refitted(part, law.fit, law.names)
    alone = refitted(part, law.fit, []) if law.names else without
    if without is None or alone is None:
        return None
    before, bare, after = (_errors(problem, at)[test] / law.fit.sigma for at in (without, alone, law.fit))
    a, b = (np.nansum(e**2, axis=1) for e in (before, after))
    kept = np.argsort(b)[: len(b) - int(TRIMMED * len(b))]
    noise = np.isfinite(after[kept]).sum()
    excess = float(a[kept].sum() - noise)
    share = 1.0 - float(b[kept].sum() - noise) / excess if excess > 0 else 0.0
    error, off = (rms(lengths((e * law.fit.sigma)[kept], problem.readings.kind)) for e in (after, bare))
    return Proof(train, test, error, off, share, _nearer(a, b))


def _errors(problem: Problem, at: Fit) -> Array:
    """Return the errors (R, k) of all readings as a fit of some predicts them."""
    whole = problem.with_terms(terms_of(at), at.problem.scale[len(problem.names) :])
    return whole.residual(at.errors, at.instrument, whole.poses(at.errors))


def _nearer(a: Array, b: Array) -> bool:
    """Tell whether squares of errors (n,), along the path, fall from a to b by more than chance.

    Each reading counts by the part of its square that goes, which no gross error outweighs; neighbours, which hang
    together, are one batch (batch means; Law, Kelton 1991).
    """
    gone = (a - b) / np.maximum(a + b, 1e-300)
    batches = [part.mean() for part in np.array_split(gone, max(int(np.sqrt(len(gone))), 2))]
    return bool(np.mean(batches) > SUPPORTED * np.std(batches, ddof=1) / np.sqrt(len(batches)))
