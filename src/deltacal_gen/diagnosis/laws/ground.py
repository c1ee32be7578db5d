"""What laws stand on: the places where one may act, the states that it may read, and all that is fitted, projected out.

At a fit the kernels give what a unit of each target does to the readings, once. A law's column is that times a function
of states, row by row, so that thousands are looked at together, beside everything that is fitted.
"""

from __future__ import annotations

import copy
import dataclasses
import functools
import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from deltacal_kernels.effects.targets import LAWFUL as TARGETS

from deltacal_gen.diagnosis.beside import Beside
from deltacal_gen.diagnosis.charges import gains
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.body import AXES
from deltacal_gen.physics.formula import formula
from deltacal_gen.physics.grammar import CONSTANT, LAGS, Form
from deltacal_gen.physics.law import EVERY, PREFIX, followed, load_law
from deltacal_gen.physics.memory import recursion
from deltacal_gen.physics.parts import has_load
from deltacal_gen.physics.terms import Term, blank
from deltacal_gen.states import CHANNELS, STATES, TIME, named

BOUNDLESS = 1e100  # standard deviations: what moves readings by more, an exponential far off, is no law
LAWFUL = sorted((s for s in STATES.values() if s.law), key=lambda s: s.law)  # what laws look at
OWN = [s.name for s in LAWFUL if s.per != "machine"]  # of a limb
OTHERS = [s.name for s in LAWFUL if s.others]  # of another joint
RECORDED = [s.name for s in LAWFUL if s.per == "machine" and s.kind == "channel"]
PLACE = [s.name for s in LAWFUL if s.kind == "place"]
CHUNK = 1200  # columns that are projected together
ALIKE = 0.9999  # correlation of two states that are one for a law


@dataclass(frozen=True, eq=False)
class Place:
    """A target, and what a unit of it at each limb does to the readings, (R, k, limbs or 1)."""

    target: str
    limbs: tuple[int, ...]
    columns: Array

    @property
    def remembers(self) -> bool:
        """Whether what moves may lag; readings are no rows of a run."""
        return load_law(f"{PREFIX}{self.target} = c1").ACTS_ON != "reading"


@dataclass(frozen=True)
class Tried:
    """A form at a place: gain in chi2 on the limbs that carry it, and price of the choice.

    Limbs have coefficients of their own; where none is named, all that there are share one.
    """

    target: str
    form: Form
    limbs: tuple[int, ...]
    gain: float
    price: float

    @property
    def score(self) -> float:
        """Gain beyond the price."""
        return self.gain - self.price


class Ground:
    """A fit, with the places and states of laws.

    Parameters
    ----------
    at : Fit
        Of readings that each belong to one row.
    """

    def __init__(self, at: Fit) -> None:
        self.fit, self.beside = at, Beside(at)
        self.problem, self.rows = at.problem, at.problem.readings.rows[:, 0]
        self._read: dict[str, Array] = {}  # states at the rows of the recording
        self._lagged: dict[tuple[str, float], Array] = {}
        self.coarse: dict[
            tuple[tuple[str, ...], bool], list[Form]
        ] = {}  # forms that were looked at first, by what may be read
        self._factors: dict[tuple[str, tuple[float, ...]], Array] = {}
        self._at_rows: dict[str, tuple[Array, Array, Array]] = {}  # of places, by target

    def freed(self, *effects: int) -> Ground:
        """Return the same with terms of the fit taken out: they stand in the readings, nothing else moves."""
        out = copy.copy(self)
        out.beside, out._at_rows = self.beside.freed(*effects).beside, {}
        return out

    def sharper(self, other: Fit) -> Ground:
        """Return the same with readings weighed by the noise that another fit leaves of them."""
        out = copy.copy(self)
        out.beside = Beside(dataclasses.replace(self.fit, sigma=other.sigma, weights=other.weights))
        out._at_rows = {}
        return out

    @cached_property
    def places(self) -> list[Place]:
        """Every target that this machine and this kind of readings have."""
        out = list[Place]()
        for target in TARGETS:
            own = self._own_place(target)
            if own is not None and own.columns.any() and not any(_moves_alike(own.columns, p.columns) for p in out):
                out.append(own)
        return out

    def _own_place(self, target: str) -> Place | None:
        """Return the place of a target; None where this machine or this kind of readings has none."""
        law = load_law(f"{PREFIX}{target} = c1")
        limbs = tuple(range(1, self.problem.mechanism.limbs + 1)) if law.PER_LIMB else ()
        unknown = law.ACTS_ON == "reading" and target not in self.problem.readings.kind.targets
        unknown |= self.problem.readings.kind.sees_joints and target != "joint"
        if unknown or self.problem.body.foreign(law.NAME):
            return None
        at = self.fit
        columns = self.problem.term_columns([blank(law.NAME, limbs)], at.errors, at.instrument, self.beside.machine)
        return Place(target, limbs, np.where(np.isfinite(columns), columns, 0.0))

    def place(self, target: str) -> Place:
        """Return a place by its target, of a law that was found elsewhere also one that moves readings as another."""
        found = next((p for p in self.places if p.target == target), None) or self._own_place(target)
        assert found is not None
        return found

    @cached_property
    def states(self) -> dict[str, Array]:
        """States at the readings, (R, limbs) of each limb's own, (R,) of all else: those that vary, each once.

        Where the machine touches something it stands where that is: a law of where it believes to be undoes any misfit.
        """
        problem, machine = self.problem, self.beside.machine
        numbers = range(1, problem.mechanism.limbs + 1)
        names = [*OWN, *(f"{s}_{j}" for s in OTHERS for j in numbers), *_channels(problem), *PLACE]
        touched = problem.readings.kind.touched
        names = [n for n in dict.fromkeys(names) if not _missing(problem, n) and n not in touched]
        found = self._read = problem.body.state(names, machine.x, machine.q, machine.rows)
        out: dict[str, Array] = {}
        for name in names:
            if name in found and np.isfinite(v := found[name][self.rows]).all() and np.ptp(v, axis=0).max() > 0:
                own = v.ndim == 2
                if not any(_same(v, o) for n, o in out.items() if (o.ndim == 2) == own and not _numbered(n, name)):
                    out[name] = v
        return out

    def _of(self, name: str) -> Array:
        """Return a state at the readings, also one that is a straight line of another here: laws elsewhere read it."""
        return self.states[name] if name in self.states else self._read[name][self.rows]

    def readable(self, place: Place) -> list[str]:
        """Return the states that a law at a place may read."""
        kind = load_law(f"{PREFIX}{place.target} = c1").ACTS_ON
        out = []
        for name, values in self.states.items():
            s = named(name)
            if values.ndim == 2 and kind != "limb":
                continue
            if kind == "reading" and (s.kind == "load" or s.of_geometry):
                continue
            out.append(name)
        return out

    @cached_property
    def lags(self) -> tuple[float, ...]:
        """Time constants [s] with which a state may lag; none where no time was recorded, or for readings."""
        time = self.problem.body.channels.get("time")
        if time is None or not np.isfinite(time[self.rows]).all():
            return ()
        t = np.unique(time[self.rows])
        if len(t) < 8:
            return ()
        return tuple(np.geomspace(np.median(np.diff(t)), np.ptp(t) / 2, LAGS).tolist())

    def values(self, form: Form) -> Array:
        """Return what a form's functions are at the readings, (R, limbs or 1, functions)."""
        return np.stack(np.broadcast_arrays(*(self._function(f, form.constants) for f in form.factors)), axis=2)

    def _function(self, factors: tuple[str, ...], constants: tuple[float, ...]) -> Array:
        """Return a product at the readings, (R, limbs or 1)."""
        out = self._factor(factors[0], constants)
        with np.errstate(over="ignore"):  # what has no bounds is no law; see `normal`
            for f in factors[1:]:
                out = out * self._factor(f, constants)
        return out

    def _factor(self, text: str, constants: tuple[float, ...]) -> Array:
        """Return what a factor of a function is at the readings, (R, limbs or 1), computed once."""
        own = _constants(text)
        key = text, tuple(constants[k] for k in own)
        if key not in self._factors:
            self._factors[key] = self._computed(text, constants, self.states)
        return self._factors[key]

    def _computed(self, text: str, constants: tuple[float, ...], states: Mapping[str, Array]) -> Array:
        f = formula(text.format(*(f"c{k}" for k in range(len(constants)))))
        names = {f"c{k}": constants[k] for k in _constants(text)}
        known: dict[str, Array | float] = {**names}
        known |= {n: (v := states.get(n, self._of(n))).reshape(len(v), -1) for n in f.names if n not in names}
        known |= {f"Lag({s}, {tau})": self.lagged(s, names[tau]) for s, tau in f.lags}
        out = np.nan_to_num(f(known), posinf=0.0, neginf=0.0)
        return out if out.ndim else np.full((len(self.rows), 1), float(out))

    def lagged(self, state: str, tau: float) -> Array:
        """Return a state as it lags, at the readings (R, limbs or 1); by no time, or less, it does not.

        What lags by less than nothing would grow without bounds.
        """
        key = state, float(tau)
        if key not in self._lagged:
            channels = self.problem.body.channels
            assert self.states
            v = self._read[state].reshape(len(channels.order), -1)
            time = np.asarray(channels.get("time"), dtype=float)
            run = np.zeros(len(v), dtype=np.int64) if channels.run is None else channels.run
            order = np.lexsort((time, run))
            first = np.r_[True, np.diff(run[order]) != 0]
            h, now = np.diff(time[order], prepend=time[order[0]]), v[order]
            h = np.where(first, 0.0, h)[:, None]
            kept, left = now, np.zeros_like(now)
            if tau > 0:
                kept, left = followed(left, np.roll(now, 1, axis=0), now, h, np.asarray(tau))
            first, out = first[:, None], np.empty_like(v)
            out[order] = recursion(np.where(first, 0.0, left), np.where(first, now, kept))
            self._lagged[key] = out[self.rows]
        return self._lagged[key]

    def columns(self, place: Place, values: Array, states: Sequence[Sequence[str]] = ()) -> Array:
        """Return whitened columns (scalars, n, limbs or 1) of n functions (R, limbs or 1, n) at a place.

        Where `states` of each function are given, a limb carries none that reads its own joint as another's.
        """
        (R, k, limbs), n = place.columns.shape, values.shape[2]
        each = np.broadcast_to(np.swapaxes(values, 1, 2), (R, n, limbs))
        if states:
            each = np.where(_others(states, limbs), each, 0.0)
        with np.errstate(over="ignore", invalid="ignore"):  # what has no bounds is no law; see `normal`
            C = place.columns[:, :, None, :] * each[:, None]
            return self.beside.rows(C.reshape(R, k, -1)).reshape(-1, n, limbs)

    def by_constants(self, place: Place, form: Form, limbs: tuple[int, ...], values: Array, steps: Array) -> Array:
        """Return derivatives (scalars, constants) of what a form moves by its constants: differences to both sides.

        `values` are its coefficients (limbs or 1, n), `steps` one for each constant.
        """
        at, out = np.array(form.constants), []
        for step in np.diag(steps):
            forms = (form.with_constants(c) for c in (at + step, at - step))
            ends = [on(self.columns(place, self.values(f)), limbs) for f in forms]
            out.append(np.einsum("snl,ln->s", ends[0] - ends[1], values) / (2 * step.sum()))
        return np.column_stack(out) if out else np.zeros((self.beside.readings, 0))

    def normal(self, columns: Array) -> tuple[Array, Array, Array]:
        """Return normal equations beside all that is fitted, G (n, m, m) and b (n, m), and sizes (n, m).

        `columns` (scalars, n, m) are made of unit length; one that has no bounds is none.
        """
        S, n, m = columns.shape
        flat = columns.reshape(S, -1)
        with np.errstate(over="ignore", invalid="ignore"):
            size = np.sqrt(np.einsum("ij,ij->j", flat, flat))
        if not (bounded := size < BOUNDLESS).all():  # neither is what is not finite
            flat, size = np.where(bounded, flat, 0.0), np.where(bounded, size, 0.0)
        C = flat / np.where(size > 0, size, 1.0)
        inside = self.beside.Q.T @ C
        b = C.T @ self.beside.residual
        C3, I3 = (np.moveaxis(v.reshape(len(v), n, m), 1, 0) for v in (C, inside))
        G = np.swapaxes(C3, 1, 2) @ C3 - np.swapaxes(I3, 1, 2) @ I3
        return G, b.reshape(n, m), size.reshape(n, m)

    def systems(self, place: Place, forms: Sequence[Form]) -> Iterator[tuple[list[int], tuple[Array, Array, Array]]]:
        """Yield which forms have equally many functions, some at a time, with their normal equations on all limbs."""
        for m in sorted({len(f.factors) for f in forms}):
            every = [k for k, f in enumerate(forms) if len(f.factors) == m]
            step = max(CHUNK // (place.columns.shape[2] * m), 1)
            for some in (every[at : at + step] for at in range(0, len(every), step)):
                own = [forms[k] for k in some]
                yield some, self._normal_of(place, own, np.dstack(np.broadcast_arrays(*map(self.values, own))))

    def _normal_of(self, place: Place, forms: Sequence[Form], values: Array) -> tuple[Array, Array, Array]:
        """Return normal equations of forms with m functions each, G (n, limbs * m, limbs * m), b and sizes.

        `values` (R, limbs or 1, n * m) are the forms' functions. Where the noise of each row is its own, what a place
        does to the readings of a row comes down to few numbers, and no column is ever written out.
        """
        n, m, limbs = len(forms), len(forms[0].factors), place.columns.shape[2]
        states = [f.states for f in forms for _ in range(m)]
        if not self.beside.fit.repeats.by_row:
            C = self.columns(place, values, states)
            C = np.swapaxes(C.reshape(len(C), n, m, limbs), 2, 3).reshape(len(C), n, -1)
            return self.normal(C)
        W, Q, r = self._in_rows(place)
        each = np.where(_others(states, limbs).T, values, 0.0)
        with np.errstate(over="ignore", invalid="ignore"):
            size = np.sqrt(np.einsum("rl,rln->ln", np.diagonal(W, axis1=1, axis2=2), each**2))
        if not (bounded := size < BOUNDLESS).all():  # as in `normal`
            each, size = np.where(bounded, each, 0.0), np.where(bounded, size, 0.0)
        each /= np.where(size > 0, size, 1.0)
        b = np.einsum("rl,rln->ln", r, each)
        inside = np.matmul(np.moveaxis(Q, 0, 2), np.moveaxis(each, 1, 0))  # (limbs, n_Q, n * m)
        own = [(limb, j) for limb in range(limbs) for j in range(m)]
        G = np.empty((n, len(own), len(own)))
        for (s, (k, i)), (t, (l, j)) in itertools.combinations_with_replacement(enumerate(own), 2):
            both = np.einsum("rn,rn->n", W[:, k, l, None] * each[:, k, i::m], each[:, l, j::m])
            G[:, s, t] = G[:, t, s] = both - np.einsum("qn,qn->n", inside[k][:, i::m], inside[l][:, j::m])
        by_form = (np.moveaxis(v.reshape(limbs, n, m), 0, 1).reshape(n, -1) for v in (b, size))
        return G, *by_form

    def _in_rows(self, place: Place) -> tuple[Array, Array, Array]:
        """Return what a place does to each row, whitened: times itself, times `Q` and times the residual.

        They are (R, limbs, limbs), (R, limbs, n_Q) and (R, limbs).
        """
        if place.target not in self._at_rows:
            beside, R = self.beside, len(self.rows)
            whole = np.zeros((R, place.columns.shape[1], place.columns.shape[2] + beside.Q.shape[1] + 1))
            whole[beside.read] = np.column_stack([beside.rows(place.columns), beside.Q, beside.residual])
            limbs = place.columns.shape[2]
            found = np.swapaxes(whole[..., :limbs], 1, 2) @ whole
            self._at_rows[place.target] = found[..., :limbs], found[..., limbs:-1], found[..., -1]
        return self._at_rows[place.target]

    def term(self, target: str, form: Form, limbs: tuple[int, ...]) -> Term:
        """Return a form as a term of a fit, its coefficients as they explain most here, and where it was found."""
        every = EVERY if self.place(target).limbs and not limbs else ""
        law = load_law(f"{PREFIX}{every}{target} = {form.text}")
        ends = [float(end(self._seen(s, limbs))) for s in law.STATE for end in (np.min, np.max)]
        inner = {f"c{len(form.functions) + k}": c for k, c in enumerate(form.constants, 1)}
        term = blank(law.NAME, limbs, (*(inner[name] for name in law.inner), *ends))
        G, b, size = (v[0] for v in self.normal(self.of(self.place(target), form, limbs)[:, None]))
        values = np.linalg.pinv(G, rcond=1e-8, hermitian=True) @ b / np.where(size > 0, size, 1.0)
        return term.with_values(values)

    def gain(self, place: Place, form: Form, limbs: tuple[int, ...]) -> float:
        """Return by how much a form on some limbs lowers chi2 beside all that is fitted."""
        return float(gains(*self.normal(self.of(place, form, limbs)[:, None])[:2])[0])

    def of(self, place: Place, form: Form, limbs: tuple[int, ...]) -> Array:
        """Return whitened columns (scalars, n) of a form on some limbs, limb by limb."""
        C = on(self.columns(place, self.values(form)), limbs)
        return np.swapaxes(C, 1, 2).reshape(len(C), -1)

    def _seen(self, state: str, limbs: tuple[int, ...]) -> Array:
        values = self._of(state)
        return values[:, [i - 1 for i in limbs]] if values.ndim == 2 and limbs else values


def on(columns: Array, limbs: tuple[int, ...]) -> Array:
    """Return columns (..., limbs or 1) of limbs that have coefficients of their own; of none, of all at once."""
    return columns[..., [i - 1 for i in limbs]] if limbs else columns.sum(axis=-1, keepdims=True)


def joined(system: tuple[Array, Array, Array], limbs: tuple[int, ...], every: int) -> tuple[Array, Array]:
    """Return normal equations of functions on some of `every` limbs, as `on` does with columns, of those on all."""
    G, b, size = system
    n, m = len(G), G.shape[1] // every
    if limbs:
        at = [(i - 1) * m + j for i in limbs for j in range(m)]
        return G[:, at][:, :, at], b[:, at]
    by = size.reshape(n, every, m)
    by = by / np.maximum(np.sqrt((by**2).sum(axis=1, keepdims=True)), 1e-300)
    G = np.einsum("nki,nkilj,nlj->nij", by, G.reshape(n, every, m, every, m), by)
    return G, (by * b.reshape(n, every, m)).sum(axis=1)


@functools.lru_cache(maxsize=100_000)
def _constants(text: str) -> tuple[int, ...]:
    """Return which constants stand in a factor."""
    return tuple(sorted({int(k) for k in CONSTANT.findall(text)}))


def _channels(problem: Problem) -> list[str]:
    """Return the channels of the machine that were recorded, by the names of states, then covariates by their own."""
    out = [n for n in RECORDED if n in problem.body.channels.values]
    own = {n for s in CHANNELS for n in s.columns(problem.recording.joint_unit, problem.mechanism.limbs)}
    for name in problem.recording.told:
        doubtful = name in problem.recording.doubts or not name.isidentifier()
        if name not in own and not doubtful and name in problem.body.channels.values and named(name).name == name:
            out += [name] if named(name).unit == "as recorded" else []
    return out


def _missing(problem: Problem, name: str) -> bool:
    """Tell whether a state cannot be read here."""
    s, body = named(name), problem.body
    if s.kind == "load":
        if problem.robot.masses is None or not problem.mechanism.weighs:
            return True
        if not has_load(problem.mechanism, s):
            return True
    if s.kind == "place" and name in AXES and name not in problem.mechanism.axes:
        return True
    if problem.recording.begins_anew and any(c.column == TIME for c in s.channels):
        return True
    return any(body.channels.get(c.base) is None for c in s.channels)


def _same(a: Array, b: Array) -> bool:
    """Tell whether two states are one for a law: a straight line of each other, limb by limb."""
    x, y = a - a.mean(axis=0), b - b.mean(axis=0)
    return x.shape == y.shape and _same_direction(x, y)


def _moves_alike(a: Array, b: Array) -> bool:
    """Tell whether two targets move the readings alike, limb by limb: an arm's tip goes as its joint turns."""
    return a.shape == b.shape and _same_direction(a.reshape(-1, a.shape[2]), b.reshape(-1, b.shape[2]))


def _same_direction(x: Array, y: Array) -> bool:
    size = np.sqrt((x**2).sum(axis=0) * (y**2).sum(axis=0))
    return bool(np.all(np.abs((x * y).sum(axis=0)) > ALIKE * np.maximum(size, 1e-300)))


def _numbered(a: str, b: str) -> bool:
    """Tell whether two states are a joint's and another joint's."""
    return bool(named(a).joint) != bool(named(b).joint)


def _others(states: Sequence[Sequence[str]], limbs: int) -> Array:
    """Return which limbs (n, limbs) read no joint of their own as another's."""
    out = np.ones((len(states), limbs))
    if limbs > 1:
        for k, own in enumerate(states):
            for name in own:
                if joint := named(name).joint:
                    out[k, joint - 1] = 0.0
    return out
