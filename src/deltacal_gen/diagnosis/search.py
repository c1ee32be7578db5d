"""The linear competition at a fit: what would each effect explain of the misfit that nothing fitted explains already.

`Beside` takes everything that is fitted (geometry, instrument, effects so far) out of the readings; `Search` puts the
columns of all forms of all effects through the same projection. A form is an effect on some limbs with its searched
constants: the order of a harmonic, the time of a jump, the point of an offset. What the best of many forms explains by
chance grows with their number: the charge is the gain that nothing but noise exceeds with the probability `CHANCE`,
all forms of the effect together (Bonferroni).
"""

from __future__ import annotations

import copy
import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from deltacal_gen.diagnosis.beside import Beside
from deltacal_gen.diagnosis.charges import (
    MARGIN,
    SMALLEST,
    UNSEEN,
    best_part,
    carriers_of,
    charge,
    gains,
    key,
    places,
    several,
    stiffest,
)
from deltacal_gen.diagnosis.harmonics import (
    FEW,
    LONGEST,
    Series,
    grouped,
    is_multiple,
    lowest_repeating,
    once,
    order_of,
    series,
    travelled,
)
from deltacal_gen.diagnosis.library import SIZE_STEP
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import ROUNDING, Problem
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.terms import Beyond, Term, beyond, on_limbs

GOLDEN = 0.5 * (5**0.5 - 1)  # of the golden section by which a size is then sought
REFINEMENTS = 12  # of it: to 0.3 % of the step
REFINED = 0.5  # of chi2: a size that explains less more is as good as the one that is there
NEAR_BEST = 0.95  # of the best score: what earns less is not the best by a size between two steps
ASIDE = 0.1  # by how much of itself a size is moved to see how sharply it is known
SCATTERED = ("moments", "orders")  # constants of which only some values are searched
HARDLY = 1e-6  # of the likelihood: forms below it change no variance


@dataclass(frozen=True)
class Doubt:
    """A size that no machine worth measuring has, of which limb, and the gain of the form that would need it."""

    beyond: Beyond
    limb: int | None
    gain: float


@dataclass(frozen=True)
class Found:
    """An effect's best form: its gain in chi2, and what is left of the gain after its charge.

    `doubt` says what size another form would need that would earn more: one that no machine worth measuring has. Where
    every form would, the score is minus infinity. `harmonics` are found with the term, a periodic error, as one form.
    """

    term: Term
    gain: float
    score: float
    doubt: Doubt | None = None
    harmonics: tuple[Term, ...] = ()

    @property
    def terms(self) -> tuple[Term, ...]:
        """All that is found together."""
        return (self.term, *self.harmonics)


class Search:
    """Gains of all forms of effects at a fit, beside all that is fitted.

    Parameters
    ----------
    at : Fit
    terms : sequence of Term
        Blank, on all limbs and tool points, the forms of one effect in a row.

    Attributes
    ----------
    effects : tuple of (str, tuple of float)
        Effects that are fitted, with their constants: they do not compete. Of a periodic error, other orders do.
    """

    def __init__(self, at: Fit, terms: Sequence[Term]) -> None:
        self.fit = at
        self.effects = tuple(map(key, at.problem.terms))
        self._compete(Beside(at), at.problem, _with_fitted(terms, at.problem))

    def _compete(self, beside: Beside, problem: Problem, terms: Sequence[Term]) -> None:
        self._problem, self._parted = problem, False
        self.terms = tuple(terms)
        self._of_effect: dict[str, list[Term]] = {}
        for term in terms:
            self._of_effect.setdefault(term.effect, []).append(term)
        self._columns = self._whitened(beside, terms)
        size = np.sqrt(np.einsum("ij,ij->j", self._columns, self._columns))
        starts = np.cumsum([0, *(t.n_coefficients for t in terms)])[:-1].tolist()
        self._start = dict(zip(map(key, terms), starts, strict=True))
        lever = problem.borne(terms).astype(float)
        for span in map(self._span, self._of_effect):
            # rounding is no lever: a joint that bears nothing has nothing to twist by
            lever[span] *= size[span] > ROUNDING * size[span].max()
        self._size = np.maximum(size, 1e-300)
        self._columns *= lever / self._size
        self._place(beside)

    def _whitened(self, beside: Beside, terms: Sequence[Term]) -> Array:
        at = beside.fit
        return _beside_gaps(beside, terms, self._problem.term_columns(terms, at.errors, at.instrument, beside.machine))

    def _forms(self, name: str) -> Sequence[Term]:
        return self._of_effect.get(name, ())

    def _span(self, name: str) -> slice:
        """Return the columns of all forms of an effect."""
        forms = self._forms(name)
        first = self._start[key(forms[0])]
        return slice(first, first + forms[0].n_coefficients * len(forms))

    def _place(self, beside: Beside) -> None:
        self._beside = beside
        self._squares: dict[str, Array] = {}
        self._inside = beside.Q.T @ self._columns
        self._reach = beside.residual @ self._columns

    def gram(self, name: str) -> Array:
        """Return the products (M, n, n) of the columns of each of an effect's forms, beside all that is fitted."""
        forms, span = self._forms(name), self._span(name)
        if name not in self._squares:  # they are the same whatever is fitted beside them
            C = np.moveaxis(self._columns[:, span].reshape(self.readings, len(forms), -1), 0, 2)
            self._squares[name] = C @ np.swapaxes(C, 1, 2)
        inside = np.moveaxis(self._inside[:, span].reshape(len(self._inside), len(forms), -1), 0, 2)
        gram: Array = self._squares[name] - inside @ np.swapaxes(inside, 1, 2)
        return gram

    @property
    def readings(self) -> int:
        """Number of scalars."""
        return self._beside.readings

    @property
    def beside(self) -> Beside:
        """What the forms compete beside."""
        return self._beside

    @property
    def columns(self) -> Array:
        """Whitened unit columns (scalars, n) of all forms, in the order of `terms`."""
        return self._columns

    def freed(self, *effects: int) -> Search:
        """Return the search for what could stand for effects of the fit, all others beside it."""
        out, freed = copy.copy(self), self._beside.freed(*effects)
        out.effects = tuple(key for i, key in enumerate(self.effects) if i not in effects)
        if any(t.gaps for t in self.terms):  # what a session without a channel takes depends on what is beside it
            out._compete(freed.beside, self._problem, self.terms)
            return out
        out._beside, out._inside = freed.beside, freed.turn.rest(self._inside)
        out._reach = self._reach + freed.left @ self._inside
        return out

    def within(self, chosen: np.ndarray) -> Search:
        """Return the search on some of the readings (R,) only; repeats of a pose must not be parted."""
        out = copy.copy(self)
        out._parted = True
        out._columns = self._beside.parted(self._columns, chosen)
        out._place(self._beside.within(chosen))
        return out

    def added(self, *terms: Term) -> Search:
        """Return the search beside more forms, fitted in the linear machine."""
        out = self
        for term in terms:
            out = out._added(term)
        return out

    def _added(self, term: Term) -> Search:
        some = self.where(term)
        columns = self._columns[:, some] if some else self._whitened(self._beside, [term])
        out = self.joined(columns / np.maximum(np.linalg.norm(columns, axis=0), 1e-300))
        out.effects = (*self.effects, key(term))
        return out

    def joined(self, columns: Array) -> Search:
        """Return the search beside other whitened columns (scalars, n) that are fitted too."""
        out, known = copy.copy(self), self._beside.Q.shape[1]
        out._beside = self._beside.joined(columns)
        more = out._beside.Q[:, known:]
        out._inside = np.vstack([self._inside, more.T @ self._columns])
        out._reach = out._beside.residual @ self._columns
        return out

    def of(self, body: Body, terms: Sequence[Term]) -> Search:
        """Return the search among other effects, whose channels are those of `body`."""
        out = copy.copy(self)
        out._compete(self._beside, dataclasses.replace(self.fit.problem, body=body), terms)
        return out

    def where(self, term: Term) -> list[int]:
        """Return the columns of a form; none if it does not compete."""
        start = self._start.get(key(term))
        if start is None:
            return []
        return [start + j for j in places(self._forms(term.effect)[0], term)]

    def columns_of(self, *terms: Term) -> list[int]:
        """Return the columns of several forms."""
        return [c for t in terms for c in self.where(t)]

    def grouped(self, terms: Sequence[Term]) -> list[tuple[int, ...]]:
        """Return which terms are one finding; see `harmonics.grouped`."""
        return grouped(terms, self._repeats)

    def price(self, *terms: Term) -> float:
        """Return what a form has to earn, chosen among all forms of its effect; see `charge`.

        Several terms are one form, a periodic error with its harmonics.
        """
        first = terms[0]
        if len(terms) > 1:
            return charge(first, max(len(self._series(first).places), 1), len(terms))
        return charge(first, len(self._of_effect.get(first.effect, ())))

    def priced(self, terms: Sequence[Term]) -> float:
        """Return what effects have to earn together to be named: each finding its price, and the margin beyond it."""
        return sum(self.price(*(terms[i] for i in own)) + MARGIN for own in self.grouped(terms))

    def _series(self, term: Term) -> Series:
        """Return the periodic errors of several waves that the joints can show, by the places of their forms."""
        least = lowest_repeating(min(self._travel[i - 1] for i in term.limbs))
        return series(tuple(order_of(t) for t in self._forms(term.effect)), least)

    def _repeats(self, wave: Term) -> bool:
        """Tell whether all joints of a wave turned far enough to show that it repeats."""
        return order_of(wave) >= lowest_repeating(min(self._travel[i - 1] for i in wave.limbs))

    @cached_property
    def _travel(self) -> Sequence[float]:
        """Return how far each joint turned [rad]."""
        return travelled(self.fit.problem)

    def gain(self, columns: Sequence[int]) -> float:
        """Return by how much columns, fitted together with all that is fitted already, lower chi2."""
        G, b = self.normal(columns)
        return float(gains(G[None], b[None])[0])

    def normal(self, columns: Sequence[int]) -> tuple[Array, Array]:
        """Return the normal equations (n, n) and (n,) of unit columns beside all that is fitted."""
        some = list(columns)
        C, inside = self._columns[:, some], self._inside[:, some]
        return C.T @ C - inside.T @ inside, self._reach[some]

    def elsewhere(self, term: Term) -> dict[int, tuple[int, ...]]:
        """Return the limbs of a form in whose place others explain about as much, and these.

        A size that is searched may be another at another limb.
        """
        forms = [t for t in self._forms(term.effect) if term.kernels.SIZED or key(t) == key(term)]
        if not forms or not term.limbs:
            return {}
        least, out = self.gain(self.where(term)) - MARGIN, {}
        for i in term.limbs:
            others = [j for j in forms[0].limbs if j not in term.limbs]
            rest = [k for k in term.limbs if k != i]
            most = {j: max(self.gain(self.where(on_limbs(t, [j, *rest]))) for t in forms) for j in others}
            if alike := tuple(j for j in others if most[j] > least):
                out[i] = alike
        return out

    def stiffer(self, term: Term) -> Term | None:
        """Return a form on other limbs that explains as much and gives less; None where there is none.

        Of a size that lies between those that were searched none is looked for: it may be another at another limb.
        """
        forms, span = self._forms(term.effect), self._span(term.effect)
        k = next((n for n, t in enumerate(forms) if key(t) == key(term)), None)
        if k is None or not term.limbs:
            return None
        G, b = self.gram(term.effect)[k], self._reach[span].reshape(len(forms), -1)[k]
        size = self._size[span].reshape(len(forms), -1)[k]
        part = stiffest(forms[0], on_limbs(forms[0], term.limbs), G, b, size)
        own = places(forms[0], part)
        if set(part.limbs) == set(term.limbs) or self._beyond(part, G[np.ix_(own, own)], b[own], size[own]):
            return None
        return dataclasses.replace(part, constants=term.constants)

    def shift_by(self, effect: int, columns: Sequence[int]) -> Array:
        """Return by how much unit columns in the readings shift the coefficients of a fitted effect (n_c, n)."""
        own = self.fit.problem.coefficients(effect)
        shift: Array = self._beside.shifts(self._inside[:, list(columns)])[own]
        return self.fit.problem.scale[own][:, None] * shift

    def estimated(self, term: Term) -> Term:
        """Return a form with the coefficients that explain most."""
        some = self.where(term)
        if not some:  # its size lies between those that compete
            return term.with_values(self._explained(term)[1])
        G, b = self.normal(some)
        values = np.linalg.pinv(G, rcond=SMALLEST, hermitian=True) @ b
        return term.with_values(values / self._size[some])

    def best(self, name: str) -> Found:
        """Return an effect's best form over its constants, limbs and tool points, charged for the choice.

        What of it no machine can have is left out, and told: limbs, or the form where it is of the whole machine.
        """
        forms, span = self._forms(name), self._span(name)
        free = [j for j, t in enumerate(forms) if key(t) not in self.effects]
        G = self.gram(name)[free]
        b = self._reach[span].reshape(len(forms), -1)[free]
        size = self._size[span].reshape(len(forms), -1)[free]
        open_forms, doubt = np.arange(len(free)), None
        allowed: list[object] | None = list(carriers_of(forms[0]))
        last = Found(forms[0], 0.0, -np.inf)
        while len(open_forms) and allowed is not None:
            part, k, gain, score = best_part(forms[0], allowed, len(forms), G[open_forms], b[open_forms])
            k = int(open_forms[k])
            form = dataclasses.replace(part, constants=forms[free[k]].constants)
            own = places(forms[0], part)
            cannot = self._beyond(form, G[k][np.ix_(own, own)], b[k, own], size[k, own])
            last = Found(form, gain, score, doubt)
            if not cannot or score < 0:
                return last
            doubt = doubt or Doubt(cannot[0], part.limbs[cannot[0].row] if part.limbs else None, gain)
            if carriers := carriers_of(part):
                out = {carriers[c.row] for c in cannot}
                allowed = [c for c in allowed if c not in out] or None
            else:
                open_forms = open_forms[open_forms != k]
        return dataclasses.replace(last, score=-np.inf, doubt=doubt)

    def _with_harmonics(self, found: Found) -> Found:
        """Return a periodic error with its harmonics, or another one, where these earn more than a wave by itself.

        Waves that are fitted already stay, and others of their period come beside them. Of errors that are worth nearly
        as much as the best the shortest is taken. Where functions of the joint that do not repeat are worth nearly as
        much, no period is claimed.
        """
        every = self._forms(found.term.effect)
        free = np.array([key(t) not in self.effects for t in every])
        G, b = self.gram(found.term.effect), self._reach[self._span(found.term.effect)].reshape(len(every), -1)
        tried: list[_Tried] = []
        for limbs in dict.fromkeys([found.term.limbs, *((i,) for i in every[0].limbs)]):
            wave = on_limbs(every[0], limbs)
            own = places(every[0], wave)
            holds = self._series(wave).holds & free
            if not len(holds):
                continue  # no order repeats on so short a way
            count = holds.sum(axis=1)
            prices = np.array([charge(wave, len(holds), n) for n in range(LONGEST + 1)])[count]
            # waves that share nothing explain no more together than each alone
            most = holds @ gains(G[:, own][:, :, own], b[:, own])
            few = count * wave.n_coefficients <= FEW * self.readings
            columns = np.array([self._start[key(t)] for t in every])[:, None] + own
            for s in np.flatnonzero(few & (most > prices + max(found.score, 0.0) + MARGIN)):
                gain = self.gain(columns[holds[s]].ravel())
                tried.append(_Tried(gain - prices[s], gain, limbs, np.flatnonzero(holds[s])))
        best = max(tried, key=lambda t: t.score, default=None)
        if best is None or best.score < found.score + MARGIN:
            return found
        if best.score < self._once(best.found(every)) + MARGIN:
            return found
        alike = (t for t in tried if t.score > best.score - MARGIN)
        return min(alike, key=lambda t: (len(t.waves) * len(t.limbs), -t.score)).found(every)

    def _once(self, found: Found) -> float:
        """Return the score of functions as fine as a periodic error that do not repeat where the joints were."""
        slowest = once(min(self._travel[i - 1] for i in found.term.limbs))
        top = max(map(order_of, found.terms))
        lattice = [
            t for t in self._forms(found.term.effect) if order_of(t) <= top and is_multiple(order_of(t), slowest)
        ]
        waves = [on_limbs(t, found.term.limbs) for t in lattice if key(t) not in self.effects]
        if not waves:
            return -np.inf
        G, b = self.normal(self.columns_of(*waves))
        # of the first so many all at once: what each column adds to those before it
        added = np.linalg.solve(np.linalg.cholesky(G + SMALLEST * np.eye(len(b))), b) ** 2
        gain = np.cumsum(added)[waves[0].n_coefficients - 1 :: waves[0].n_coefficients]
        forms = len(self._series(found.term).holds)
        return float(max(g - charge(waves[0], forms, n) for n, g in enumerate(gain, start=1)))

    def _beyond(self, form: Term, G: Array, b: Array, size: Array) -> list[Beyond]:
        """Return what of a form's best coefficients cannot be; of one that no reading sees that is never known."""
        inverse = np.linalg.pinv(G, rcond=SMALLEST, hermitian=True)
        std = np.where(np.diag(G) > UNSEEN, np.sqrt(np.maximum(np.diag(inverse), 0.0)) / size, np.inf)
        return beyond(form.with_values(inverse @ b / size), std, self.fit.problem.recording.joint_unit)

    def _refined(self, found: Found) -> Found:
        """Return a form whose constant, a size that was searched in steps, is where it explains most among them.

        Of parts of the readings it stays as it is: a little more than all others explain with it tells nothing.
        """
        at = _sized(found.term)
        if at is None or self._parted:
            return found
        size, like = float(found.term.constants[at]), found.term.constants[:at]
        alike = [float(t.constants[at]) for t in self._forms(found.term.effect) if t.constants[:at] == like]
        low = max(np.log(min(alike) / size), -np.log(SIZE_STEP))
        high = min(np.log(max(alike) / size), np.log(SIZE_STEP))
        inside = [high - GOLDEN * (high - low), low + GOLDEN * (high - low)]
        gain = [self._explained(_resized(found.term, at, u))[0] for u in inside]
        for _ in range(REFINEMENTS):
            worse = int(gain[0] > gain[1])
            low, high = (low, inside[1]) if worse else (inside[0], high)
            new = high - GOLDEN * (high - low) if worse else low + GOLDEN * (high - low)
            inside, kept = [new, inside[0]] if worse else [inside[1], new], gain[0] if worse else gain[1]
            added = self._explained(_resized(found.term, at, new))[0]
            gain = [added, kept] if worse else [kept, added]
        best = int(gain[1] > gain[0])
        more = gain[best] - found.gain
        if more < REFINED:
            return found
        return dataclasses.replace(
            found, term=_resized(found.term, at, inside[best]), gain=gain[best], score=found.score + more
        )

    def _explained(self, term: Term) -> tuple[float, Array]:
        """Return the gain of a form that does not compete, and its coefficients (n_c,)."""
        columns = self._whitened(self._beside, [term])
        size = np.maximum(np.linalg.norm(columns, axis=0), 1e-300)
        C = columns / size
        inside, b = self._beside.Q.T @ C, C.T @ self._beside.residual
        G = C.T @ C - inside.T @ inside
        return float(gains(G[None], b[None])[0]), np.linalg.pinv(G, rcond=SMALLEST, hermitian=True) @ b / size

    def spread(self, term: Term) -> tuple[float | None, Array]:
        """Return how uncertain a searched constant is, and what that adds to the variances of coefficients (n_c,).

        The gain falls by 1 where the size is a standard deviation off, the coefficients with it. None where the
        readings give it no two ends.
        """
        at = _sized(term)
        if at is None:
            return self._scattered(term)
        (less, a), (most, _), (more, b) = (self._explained(_resized(term, at, u)) for u in (-ASIDE, 0.0, ASIDE))
        falls = (2 * most - less - more) / ASIDE**2
        if falls <= 0:
            return None, np.zeros(term.n_coefficients)
        return float(term.constants[at]) * (2 / falls) ** 0.5, ((b - a) / (2 * ASIDE)) ** 2 * 2 / falls

    def _scattered(self, term: Term) -> tuple[float | None, Array]:
        """Return what `spread` does, of a moment or an order: all forms that the readings leave count by likelihood.

        A moment lies anywhere since the form before it.
        """
        kinds = {key: kind for kind, key in term.kernels.SEARCHED.items() if kind in SCATTERED}
        names = [name for name, *_ in term.kernels.CONSTANTS]
        if names not in ([key] for key in kinds):
            return None, np.zeros(term.n_coefficients)
        forms = [dataclasses.replace(term, constants=t.constants) for t in self._forms(term.effect)]
        value = np.array([float(t.constants[0]) for t in forms])
        gain = np.array([self.gain(self.where(t)) for t in forms])
        weight = np.exp((gain - gain.max()) / 2)
        weight /= weight.sum()
        seen = np.flatnonzero(weight > HARDLY)
        sizes = np.array([self.estimated(forms[k]).values.ravel() for k in seen])
        off = (value - float(term.constants[0])) ** 2
        if kinds[names[0]] == "moments":
            off += np.diff(value, prepend=value[0]) ** 2 / 3
        more = weight[seen] @ (sizes - weight[seen] @ sizes) ** 2
        return float(np.sqrt(weight[seen] @ off[seen])) or None, more  # an order that is certain has none

    def ranked(self) -> list[Found]:
        """Return the best form of every effect that is not fitted, the best first."""
        taken = {name for name, _ in self.effects if not several(name)}
        names = dict.fromkeys(t.effect for t in self.terms if t.effect not in taken)
        found = list(map(self.best, names))
        found = [self._with_harmonics(f) if f.term.limbs and several(f.term.effect) else f for f in found]
        near = max(NEAR_BEST * max((f.score for f in found), default=0.0), 0.0)
        return sorted((self._refined(f) if f.score > near else f for f in found), key=lambda f: -f.score)


class _Tried(NamedTuple):
    """A periodic error of several waves: its score, its gain, the limbs, and which of the forms its waves are."""

    score: float
    gain: float
    limbs: tuple[int, ...]
    waves: np.ndarray

    def found(self, every: Sequence[Term]) -> Found:
        """Return it as one form, of all forms that its waves are among."""
        first, *others = (on_limbs(every[k], self.limbs) for k in self.waves)
        return Found(first, float(self.gain), float(self.score), harmonics=tuple(others))


def _beside_gaps(beside: Beside, terms: Sequence[Term], columns: Array) -> Array:
    """Return columns (R, k, n) of effects, whitened; what sessions without their channel take explains nothing."""
    out, start = beside.rows(columns), 0
    for term in terms:
        span = slice(start, start + term.n_coefficients)
        start = span.stop
        if not term.gaps:
            continue
        own = out[:, span]
        unknown = own.reshape(len(out), len(term.values), -1)[:, :, term.own :].reshape(len(out), -1)
        U, size, _ = np.linalg.svd(unknown - beside.Q @ (beside.Q.T @ unknown), full_matrices=False)
        U = U[:, size > UNSEEN**0.5 * np.linalg.norm(unknown, axis=0).max()]
        out[:, span] = own - U @ (U.T @ own)
    return out


def _with_fitted(terms: Sequence[Term], problem: Problem) -> list[Term]:
    """Return the forms that compete, those that are fitted with sizes between the searched ones among them."""
    out, known = list(terms), set(map(key, terms))
    for term in problem.terms:
        if key(term) not in known and (same := [j for j, t in enumerate(out) if t.effect == term.effect]):
            out.insert(same[-1] + 1, dataclasses.replace(out[same[-1]], constants=term.constants))
    return out


def _sized(term: Term) -> int | None:
    """Return which constant of a term is a size between those that are searched; None where none is."""
    names = [name for name, *_ in term.kernels.CONSTANTS]
    return next((names.index(name) for name in term.kernels.SIZED), None)


def _resized(term: Term, at: int, by: float) -> Term:
    """Return a term, blank, with a constant times ``exp(by)``."""
    constants = list(term.constants)
    constants[at] = float(constants[at]) * float(np.exp(by))
    return dataclasses.replace(term, constants=tuple(constants), values=np.zeros_like(term.values))
