"""What noise alone would let the best of all forms of all effects earn: the p-value of a search, and of what it found.

The forms that compete are thousands, and alike; no count of them says how large the largest gain is by chance. It is
therefore drawn: the residuals of the fit, freed of their leverage, change places and signs (of readings that stand
apart the signs alone), are put through the same projection as the readings, and the search looks at each draw as it
looked at them (Freedman and Lane 1983, J. Bus. Econ. Stat. 1, 292-298). Gains count in units of each draw's own noise,
so that an effect in the residuals takes nothing off itself. Where joints were rounded, so are those of the draws.
Beyond the draws the largest gain falls off as a sum of squares does, exponentially.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence

import numpy as np

from deltacal_gen.diagnosis.charges import charge, directions, places
from deltacal_gen.diagnosis.search import Search
from deltacal_gen.identification.rounding import TOLD, moved_by_steps
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Term, blank

DRAWS = 500
TAIL = 20  # draws beyond which the tail stands in for them
MOST_LEVERAGE = 0.95  # of a reading, whose residual would tell nothing of its noise
LEAST_P = 1e-300
LEAST_REST = 0.05  # of the variance that is left: what is no rounding, at least
PROVEN = 10.0  # of twice the logarithm of the likelihood, by which rounding has to be the better noise


class Chance:
    """The score of the best form by chance: its gain in chi2 less its charge.

    Parameters
    ----------
    search : Search
        Beside geometry and instrument alone.

    Attributes
    ----------
    best : str or None
        The effect that scores best; None where none competes.
    score : float
        Its score.
    """

    def __init__(self, search: Search, rng: np.random.Generator) -> None:
        scores = dict(_scores(search, _drawn(search, rng)))
        self.best: str | None = None
        self.score, self._drawn = -np.inf, np.zeros(0)
        if scores:
            self.best = max(scores, key=lambda name: float(scores[name][0]))
            every = np.max(list(scores.values()), axis=0)
            self.score, self._drawn = float(every[0]), np.sort(every[1:])

    @property
    def p_value(self) -> float:
        """Probability that noise alone lets the best form score as much."""
        return self.of(self.score)

    def of(self, score: float) -> float:
        """Return the probability that noise alone lets the best of all forms score so much."""
        count = len(self._drawn)
        if not count:
            return 1.0
        beyond = int((self._drawn >= score).sum())
        if beyond >= TAIL:
            return (1 + beyond) / (1 + count)
        last = self._drawn[-TAIL:]
        scale = max(float(np.mean(last - last[0])) * TAIL / (TAIL - 1), 2.0)
        return max((1 + TAIL) / (1 + count) * float(np.exp(-max(score - last[0], 0.0) / scale)), LEAST_P)


def _drawn(search: Search, rng: np.random.Generator) -> Array:
    """Return what is left of the readings, then of each draw (scalars, 1 + draws), in units of its own noise."""
    Q, r = search.beside.Q, search.beside.residual
    leverage = np.minimum((Q**2).sum(axis=1), MOST_LEVERAGE)
    own = r / np.sqrt(1 - leverage)
    signs = rng.choice([-1.0, 1.0], (len(r), DRAWS))
    noise, whole = np.tile(own[:, None], DRAWS), search.beside.fit.weights[search.beside.owner] >= 1
    noise[whole] = rng.permuted(noise[whole], axis=0)  # what counts for less bends the search where it stands
    noise *= signs
    if (steps := _steps(search, own)) is not None:
        rest = max(1 - float((steps**2).sum()) / 12 / float(own @ own), 0.0)
        within = rng.uniform(-0.5, 0.5, (search.beside.owner[-1] + 1, steps.shape[1], DRAWS))
        noise = rest**0.5 * noise + np.einsum("sj,sjd->sd", steps, within[search.beside.owner])
    every = np.column_stack([r, noise - Q @ (Q.T @ noise)])
    free = max(len(r) - float((Q**2).sum()), 1.0)
    scaled: Array = every / np.sqrt(np.maximum((every**2).sum(axis=0) / free, LEAST_P))
    return scaled


def _steps(search: Search, own: Array) -> Array | None:
    """Return the steps (scalars, n_q) of rounded joints, whitened; None where what is left does not show them.

    Rounding moves a reading along its joints, as effects do: noise that is alike in all directions scores less. Joints
    that were commanded in such steps leave nothing: the likelihood of what is left decides.
    """
    beside = search.beside
    readings, repeats = beside.fit.problem.readings, beside.fit.repeats
    each_read = readings.kind.positions and len(own) == 3 * len(readings)
    if not each_read or readings.kind.sees_joints or repeats.series is not None or np.any(repeats.ratio):
        return None
    steps = beside.rows(moved_by_steps(beside.fit))
    share = float((steps**2).sum()) / 12 / float(own @ own)
    if not TOLD**2 < share < 1 / TOLD**2:
        return None
    M, each, variance = steps.reshape(-1, 3, steps.shape[1]), own.reshape(-1, 3), float(np.mean(own**2))
    C = M @ np.swapaxes(M, 1, 2) / 12 + max(1 - share, LEAST_REST) * variance * np.eye(3)
    rounded = np.einsum("ri,rij,rj->", each, np.linalg.inv(C), each) + np.linalg.slogdet(C)[1].sum()
    return steps if rounded + PROVEN < len(own) * (1 + np.log(variance)) else None


def _scores(search: Search, drawn: Array) -> Iterator[tuple[str, Array]]:
    """Yield of each effect the best score (1 + draws,) over its forms, on one limb or point, or on all."""
    reach = search.columns.T @ drawn
    for name, forms in itertools.groupby(search.terms, key=lambda t: t.effect):
        own = list(forms)
        first, count = search.where(own[0])[0], own[0].n_coefficients
        span = slice(first, first + count * len(own))
        G = search.gram(name)
        b = reach[span].reshape(len(own), count, -1)
        each = [
            _most(G[:, at][:, :, at], b[:, at]) - charge(part, len(own))
            for part in _parts(own[0])
            for at in [places(own[0], part)]
        ]
        yield name, np.max(each, axis=0)


def _parts(term: Term) -> Sequence[Term]:
    """Return an effect on each limb, or tool point, alone, and on all limbs."""
    if term.limbs:
        sets = [(i,) for i in term.limbs] + ([term.limbs] if len(term.limbs) > 1 else [])
        return [blank(term.effect, s, term.constants, term.tools, term.lacks, term.gaps) for s in sets]
    if len(term.tools) > 1:
        return [blank(term.effect, (), term.constants, (t,), term.lacks, term.gaps) for t in term.tools]
    return [term]


def _most(G: Array, b: Array) -> Array:
    """Return the largest gain (draws,) of forms with normal equations G (M, n, n) and b (M, n, draws)."""
    seen, vectors, sizes = directions(G)
    along = np.swapaxes(vectors, 1, 2) @ np.where(seen[..., None], b, 0.0)
    most: Array = np.einsum("mid,mi->md", along**2, 1.0 / sizes).max(axis=0)
    return most
