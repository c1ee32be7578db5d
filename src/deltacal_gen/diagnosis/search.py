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
import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np

from deltacal_gen.diagnosis.discrimination import columns_read
from deltacal_gen.estimation.estimation import Fit, Problem
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.physics import Body, Point, Term, blank, displaces_points, effect_names, load_effect
from deltacal_gen.physics.states import State, read_by
from deltacal_gen.results.parts import Missing

CHANCE = 5e-4  # that noise alone earns a form, or a limb, its charge
ORDERS = 100  # integer orders of a periodic error that are searched
HARMONICS = 5  # multiples of the gear ratio that are searched
ROUNDING = 1e-9  # of the largest column of an effect: less is no effect at all
MOST_TIMES = 300  # of a jump that are searched
UNSEEN = 1e-6  # part of a column's square beside the base: less is a combination of what is fitted
SMALLEST = 1e-8  # of the largest eigenvalue: below it columns are combinations of one another


class Beside:
    """Readings at a fit, whitened, and the projection beside geometry, instrument and effects that are fitted.

    Attributes
    ----------
    Q : (scalars, n) array
        The readings' part of an orthonormal basis of what is fitted; priors make it shorter than unit vectors.
    residual : (scalars,) array
        What is left of the readings by the projection, in standard deviations.
    readings : int
        Number of scalars.
    owner : (scalars,) int array
        The reading that each belongs to.
    """

    def __init__(self, at: Fit) -> None:
        self.fit, problem = at, at.problem
        self.machine = problem.solve(at.errors)
        state = problem.linearise(at.errors, at.instrument, self.machine)
        self._read = np.isfinite(state.residual)
        self.owner = np.nonzero(self._read)[0]
        # the residual carries the influence of a reading, columns none of it: a gross error can earn but little
        self._w = np.sqrt(1 + at.repeats.ratio) / np.broadcast_to(at.sigma, state.residual.shape)
        base = self.rows(np.concatenate([state.J_p * problem.scale, state.J_m], axis=2))
        n = len(problem.scale)
        # the prior's rows: geometry moves as far as drawings leave it open, not to the ends of a flat direction
        departure = (at.errors[problem.columns] - problem.reference[problem.columns]) / problem.scale
        self._departure = np.concatenate([departure, np.zeros(base.shape[1] - n)])
        r = self.rows((state.residual * at.weights[:, None])[..., None])[:, 0]
        self.readings = len(r)
        self._project(np.vstack([base, np.eye(n, base.shape[1])]), np.concatenate([r, -departure]))

    def _project(self, base: Array, pulled: Array) -> None:
        Q = np.linalg.qr(base)[0]
        self._base, self._pulled = base, pulled
        self.Q: Array = Q[: self.readings]
        self.residual: Array = (pulled - Q @ (Q.T @ pulled))[: self.readings]

    def freed(self, *effects: int) -> Beside:
        """Return the same with effects of the fit taken out: they stand in the readings, nothing else moves."""
        own = [j for i in effects for j in self.fit.problem.coefficients(i)]
        out = copy.copy(self)
        out._project(np.delete(self._base, own, axis=1), self._pulled + self._base[:, own] @ self._departure[own])
        return out

    def within(self, chosen: np.ndarray) -> Beside:
        """Return the same with some of the readings (R,) only; repeats of a pose must not be parted."""
        out = copy.copy(self)
        out.owner = self.owner[chosen[self.owner]]
        keep = np.concatenate([chosen[self.owner], np.ones(len(self._base) - self.readings, dtype=bool)])
        out.readings = len(out.owner)
        out._project(self._base[keep], self._pulled[keep])
        return out

    def joined(self, columns: Array) -> Beside:
        """Return the same with other whitened columns (scalars, n) fitted too, free of any prior."""
        out = copy.copy(self)
        free = np.zeros((len(self._base) - len(columns), columns.shape[1]))
        out._project(np.hstack([self._base, np.vstack([columns, free])]), self._pulled)
        return out

    def rows(self, values: Array) -> Array:
        """Return readings (R, k, n) as whitened rows (scalars, n), unread components dropped."""
        scaled = np.where(self._read[..., None], values * self._w[..., None], 0.0)
        return self.fit.repeats.whiten(scaled)[self._read]


@dataclass(frozen=True)
class Found:
    """An effect's best form: its gain in chi2, and what is left of the gain after its charge."""

    term: Term
    gain: float
    score: float


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
        self.effects = tuple(map(_key, at.problem.terms))
        self._compete(Beside(at), at.problem, terms)

    def _compete(self, beside: Beside, problem: Problem, terms: Sequence[Term]) -> None:
        self.terms = tuple(terms)
        columns = beside.rows(problem.term_columns(terms, beside.fit.errors, beside.fit.instrument, beside.machine))
        self._size = np.linalg.norm(columns, axis=0)
        owner = np.concatenate([[t.effect] * t.n_coefficients for t in terms]) if terms else np.zeros(0, dtype=str)
        for name in np.unique(owner):  # rounding is no lever: a joint that bears nothing has nothing to twist by
            own = owner == name
            columns[:, own] *= self._size[own] > ROUNDING * self._size[own].max()
        self._size = np.maximum(self._size, 1e-300)
        self._columns = columns / self._size
        starts = np.cumsum([0, *(t.n_coefficients for t in terms)])[:-1].tolist()
        self._start = dict(zip(map(_key, terms), starts, strict=True))
        self._place(beside)

    def _place(self, beside: Beside) -> None:
        self._beside = beside
        self._inside = beside.Q.T @ self._columns
        self._reach = self._columns.T @ beside.residual

    @property
    def readings(self) -> int:
        """Number of scalars."""
        return self._beside.readings

    def freed(self, *effects: int) -> Search:
        """Return the search for what could stand for effects of the fit, all others beside it."""
        out = copy.copy(self)
        out.effects = tuple(key for i, key in enumerate(self.effects) if i not in effects)
        out._place(self._beside.freed(*effects))
        return out

    def within(self, chosen: np.ndarray) -> Search:
        """Return the search on some of the readings (R,) only; repeats of a pose must not be parted."""
        out = copy.copy(self)
        out._columns = self._columns[chosen[self._beside.owner]]
        out._place(self._beside.within(chosen))
        return out

    def added(self, term: Term) -> Search:
        """Return the search beside one more form, fitted in the linear machine."""
        out = self.joined(self._columns[:, self.where(term)])
        out.effects = (*self.effects, _key(term))
        return out

    def joined(self, columns: Array) -> Search:
        """Return the search beside other whitened columns (scalars, n) that are fitted too."""
        out = copy.copy(self)
        out._place(self._beside.joined(columns))
        return out

    def of(self, body: Body, terms: Sequence[Term]) -> Search:
        """Return the search among other effects, whose channels are those of `body`."""
        out = copy.copy(self)
        out._compete(self._beside, dataclasses.replace(self.fit.problem, body=body), terms)
        return out

    def where(self, term: Term) -> list[int]:
        """Return the columns of a form; none if it does not compete."""
        start = self._start.get(_key(term))
        if start is None:
            return []
        return [start + j for j in _offsets(next(t for t in self.terms if t.effect == term.effect), term)]

    def gain(self, columns: Sequence[int]) -> float:
        """Return by how much columns, fitted together with all that is fitted already, lower chi2."""
        some = list(columns)
        C, inside = self._columns[:, some], self._inside[:, some]
        return float(gains((C.T @ C - inside.T @ inside)[None], self._reach[some][None])[0])

    def estimated(self, term: Term) -> Term:
        """Return a form with the coefficients that explain most."""
        some = self.where(term)
        C, inside = self._columns[:, some], self._inside[:, some]
        values = np.linalg.pinv(C.T @ C - inside.T @ inside, rcond=SMALLEST, hermitian=True) @ self._reach[some]
        return term.with_values(values / self._size[some])

    def best(self, name: str) -> Found:
        """Return an effect's best form over its constants, limbs and tool points, charged for the choice."""
        forms = [t for t in self.terms if t.effect == name]
        free = [j for j, t in enumerate(forms) if _key(t) not in self.effects]
        first, count = self._start[_key(forms[0])], forms[0].n_coefficients
        span = slice(first, first + count * len(forms))
        C = np.moveaxis(self._columns[:, span].reshape(self.readings, len(forms), count)[:, free], 0, 2)
        inside = np.moveaxis(self._inside[:, span].reshape(-1, len(forms), count)[:, free], 0, 2)
        G = C @ np.swapaxes(C, 1, 2) - inside @ np.swapaxes(inside, 1, 2)
        b = self._reach[span].reshape(-1, count)[free]
        most = gains(G, b)  # no part of a form explains more than the whole
        found: list[Found] = []
        for part in reversed(parts(forms[0])):
            price = charge(part, len(forms))
            some = np.flatnonzero(most - price > (found[-1].score if found else -np.inf))
            if not len(some):
                continue
            own = _offsets(forms[0], part)
            each = gains(G[some][:, own][:, :, own], b[some][:, own])
            k = int(np.argmax(each))
            if not found or float(each[k]) - price > found[-1].score:
                form = dataclasses.replace(part, constants=forms[free[some[k]]].constants)
                found.append(Found(form, float(each[k]), float(each[k]) - price))
        return found[-1]

    def ranked(self) -> list[Found]:
        """Return the best form of every effect that is not fitted, the best first."""
        taken = {name for name, _ in self.effects if not several(name)}
        names = dict.fromkeys(t.effect for t in self.terms if t.effect not in taken)
        return sorted(map(self.best, names), key=lambda f: -f.score)


def several(effect: str) -> bool:
    """Tell whether a machine may have an effect more than once: periodic errors of different orders."""
    return "orders" in load_effect(effect).SEARCHED


def charge(term: Term, forms: int) -> float:
    """Return the gain in chi2 that the best of `forms` of an effect exceeds by chance alone.

    Each limb, or tool point, has to earn its own: an effect on two limbs is charged as two.
    """
    rows, n_c = term.values.shape
    return rows * quantile(n_c, 1) + quantile(1, forms) - quantile(1, 1)


@cache
def quantile(degrees: int, forms: int) -> float:
    """Return what the largest of `forms` chi2 of so many degrees exceeds with the probability `CHANCE`, at most."""
    from scipy.special import chdtri  # scipy.stats would take a second to load

    return float(chdtri(degrees, CHANCE / forms))


def parts(term: Term) -> list[Term]:
    """Return an effect on each set of its limbs, or of its tool points; the effect itself if it has neither.

    An offset of all tool points alike is no offset: it is another frame.
    """
    limbs = [s for n in range(1, len(term.limbs) + 1) for s in itertools.combinations(term.limbs, n)] or [()]
    tools = [s for n in range(1, len(term.tools)) for s in itertools.combinations(term.tools, n)] or [()]
    return [blank(term.effect, ls, term.constants, ts) for ls in limbs for ts in tools]


def _key(term: Term) -> tuple[str, tuple[float, ...]]:
    return term.effect, term.constants


def _offsets(every: Term, part: Term) -> list[int]:
    n_c = every.values.shape[1]
    carriers: Sequence[object] = every.limbs or every.tools
    own: Sequence[object] = part.limbs or part.tools
    places = [carriers.index(c) for c in own] if carriers else [0]
    return [p * n_c + j for p in places for j in range(n_c)]


def gains(G: Array, b: Array) -> Array:
    """Return b G^+ b (M,) of M normal equations, (M, k, k) and (M, k); columns that are not seen take no part.

    Columns had unit length before the projection.
    """
    seen = np.diagonal(G, axis1=1, axis2=2) > UNSEEN
    both = seen[:, :, None] & seen[:, None, :]
    values, vectors = np.linalg.eigh(np.where(both, G, 0.0))
    along = np.einsum("mij,mi->mj", vectors, np.where(seen, b, 0.0))
    keep = values > SMALLEST * np.maximum(values[:, -1:], UNSEEN)
    found: Array = np.sum(np.where(keep, along**2 / np.where(keep, values, 1.0), 0.0), axis=1)
    return found


# ------------------------------------------------------------------------------------------------------- candidates


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
        terms += [blank(name, limbs, constants, tools) for constants in _forms(problem, name)]
    return terms, tuple(missing)


def _spoilt(problem: Problem, name: str) -> str | None:
    """Return what is wrong with a column that an effect reads: values that cannot be, or blank cells."""
    recording = problem.recording
    if any(s.kind == "load" for s in read_by(load_effect(name))) and problem.robot.masses is None:
        return None  # the column would not help
    rows = np.unique(problem.readings.rows)
    for column in columns_read(problem, [blank(name, (1,))]):
        if column in recording.doubts:
            return f"values that can be in the column {column} ({recording.doubts[column]})"
        values = recording.channels.get(column)
        if values is not None and len(empty := rows[~np.isfinite(values[rows])]):
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
    if kernels.ACTS_ON == "reading" and not any(t in kind.targets for t in kernels.TARGETS):
        return f"readings of another kind than {kind.name}"
    if displaces_points(kernels) and len(_tools(problem)) < 2:
        return "readings of a second point of the platform"
    if not kernels.STATE and all(t.startswith("limb.") for t in kernels.TARGETS):
        moves = problem.mechanism.moves(problem.robot)
        moved = {error for t in kernels.TARGETS for error in moves[t[5:]]}
        if {p.name for p in problem.mechanism.parameters if p.error in moved} <= set(problem.names):
            return "a smaller model: this one fits these errors as geometry"
    return None


def _differs(problem: Problem, channel: State, rows: np.ndarray) -> bool:
    """Tell whether a channel, of some joint or of its own, varies among rows; one that is not recorded may."""
    values = problem.body.channels.get(channel.base)
    if values is None:
        return True
    own = values[rows] if not channel.joint else values[rows, channel.joint - 1]
    return bool(np.ptp(own, axis=0).max() > 0)


def _tools(problem: Problem) -> list[Point]:
    used = np.unique(problem.readings.rows)
    return [(x, y, z) for x, y, z in np.unique(np.round(problem.body.tool[used], 9), axis=0).tolist()]


def _forms(problem: Problem, name: str) -> list[tuple[float, ...]]:
    """Return the constants of every form of an effect that is searched."""
    kernels = load_effect(name)
    how = {constant: kind for kind, constant in kernels.SEARCHED.items()}
    return list(itertools.product(*(SEARCHES[how[key]](problem) for key, *_ in kernels.CONSTANTS)))


def _orders(problem: Problem) -> list[float]:
    """Return the orders of a periodic error."""
    orders = {float(k) for k in range(1, ORDERS + 1)}
    ratio = problem.robot.transmission.gear_ratio if problem.robot.transmission else None
    if ratio:
        orders |= {ratio * k for k in range(1, HARMONICS + 1)}
    return sorted(orders)


def _moments(problem: Problem) -> list[float]:
    """Return the moments at which something may happen."""
    times = np.unique(problem.body.channels.clock[np.unique(problem.readings.rows)])
    edge = max(3, len(times) // 40)  # it needs rows on both sides
    inside = times[edge : len(times) - edge]
    step = -(-len(inside) // MOST_TIMES)
    return inside[step // 2 :: step].tolist() if len(inside) else []


SEARCHES = {"orders": _orders, "moments": _moments}  # of constants, by how an effect declares that they are searched
