"""Laws of a drive: what a joint's torque has that no registered effect is, written down in the states of that joint.

Sought where the ladder of a joint leaves what depends on something that was recorded. The grammar is that of laws of
machines at rest (`deltacal_gen.physics.grammar`): functions of one state of the joint, and friction, with the
speed or its sign, that another state changes. A law is a rung like any other: `JointModel` holds it, and what predicts
or commands takes it from there.

Some folds take no part in the search. What is told must take most of that away there which a smooth function of
anything recorded takes away.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from scipy.optimize import minimize

from deltacal_gen.inference.projection import basis, project_out
from deltacal_gen.motion.fit import Fit, fitted
from deltacal_gen.motion.joint import OFFSET
from deltacal_gen.motion.ladder import ALIKE, BEGUN_WITH, BUYS, PER_COEFFICIENT
from deltacal_gen.motion.library import LOAD, Rung
from deltacal_gen.motion.regression import BETWEEN
from deltacal_gen.motion.unexplained import RUN, SHOWS, Rest, channels, rest
from deltacal_gen.physics.grammar import THRESHOLDS, Atom, Form, full, product, single, switch
from deltacal_gen.physics.law import PREFIX, Law, load_law
from deltacal_gen.states import STATES

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

# states that a law is made of; of the time none is: what wanders is met by any function of it
OF = [s.name for s in sorted(STATES.values(), key=lambda s: s.drive_law) if s.drive_law]
TERMS = 4  # of a law
SWEEPS = 3  # of refining terms beside one another
SETTLES = 4  # fits in which a load and a law of it settle
SCREENED = 6000  # samples at which every form is looked at
REFINED = 8  # forms whose constants are sought between the steps of their grid
HELD_BACK = 3  # one fold of so many takes no part in the search
MOST_OF = 0.8  # of what a smooth function takes away of squares that took no part: what a law must
TRIED = 150  # evaluations in which constants are refined
STEP = 0.02  # of a state's range, either way: for a derivative by a constant


@dataclass(frozen=True, eq=False)
class Lawful:
    """A law of one joint.

    Attributes
    ----------
    fit : Fit
        Of the joint, the law's terms the last of its rungs.
    forms : tuple of Form
        Its terms.
    limits : dict
        Between which values each state was, in units inside.
    gain, charge : float
        Of chi2, on the folds of the search.
    heldout : float
        Rms on folds that took no part, in units inside.
    share : float
        Part of the excess over noise there that it takes away, in squares.
    alike : tuple of str
        Expressions that the readings do not tell from its first term.
    std : tuple of float
        Standard deviations of its coefficients and constants, term by term, coefficients first.
    """

    fit: Fit
    forms: tuple[Form, ...]
    limits: dict[str, tuple[float, float]]
    gain: float
    charge: float
    heldout: float
    share: float
    alike: tuple[str, ...]
    std: tuple[tuple[float, ...], ...]

    @property
    def rungs(self) -> tuple[Rung, ...]:
        """Its terms."""
        return self.fit.rungs[len(self.fit.rungs) - len(self.forms) :]


def lawful(fit: Fit, left: Rest | None, sigma: float | None) -> Lawful | None:
    """Return the law that explains what is left of a joint; None where nothing is, or no law holds.

    What the ladder took may only have stood for the law: beside what drives usually have alone, one as simple is told
    without it, unless it still pays beside that. `sigma` is the noise where it is declared; see `rest`.
    """
    if left is None or left.channel in ("", RUN):
        return None
    found, usual = _law(fit, sigma), [k for k, rung in enumerate(fit.rungs) if rung.effect in BEGUN_WITH]
    if len(usual) == len(fit.rungs) or (found is not None and _kept(found) <= len(usual)):
        return found
    lean = _law(_refitted(fit, usual), sigma)
    if lean is None or (found is not None and len(lean.forms) > len(found.forms)):
        return found
    return lean if set(_needed(fit, lean.rungs)) <= set(usual) else found


def registered(law: Lawful, sigma: float | None) -> Fit | None:
    """Return the fit of a law's joint with a registered effect in its place, where one does as much; else None.

    The ladder takes samples that hang together before an effect is taken for one, and may pass over what the search for
    a law finds. What has a name is no law for that: where all movements go one way, ``sign(q)`` is dry friction.
    """
    fit, kept = law.fit, [*range(_kept(law))]
    constant = [] if OFFSET in (fit.rungs[k].effect for k in kept) else [Rung(OFFSET)]  # a law may have one of its own
    ladder = fit.ladder([*constant, *fit.joint.candidates])
    every, first = range(len(fit.rungs)), len(fit.rungs) + len(constant)
    beside = [*kept, *range(len(fit.rungs), first)]
    taken = {ladder.rungs[k].effect for k in beside}
    rivals = [k for k in range(first, len(ladder.rungs)) if ladder.rungs[k].effect not in taken]
    worse = len(fit.left) / fit.together * ladder.worse_by(beside, rivals, every)
    for n in np.argsort(worse):
        if worse[n] >= ALIKE:
            break
        own = [*kept, rivals[n]]
        if constant and ladder.buys([*own, len(fit.rungs)], len(fit.rungs), ladder.bench.folds) >= BUYS:
            own = [*beside, rivals[n]]
        after = _refitted(fit, kept, [ladder.rungs[k] for k in own[len(kept) :]])
        if not ladder.impossible(own, ladder.bench.folds) and rest(after, sigma) is None:
            after, rungs = after.with_worth(), range(len(after.rungs))
            others = after.ladder(after.joint.candidates)
            return replace(after, alike=tuple(others.alike(rungs, k) for k in rungs))
    return None


def _kept(law: Lawful) -> int:
    """Return how many rungs the ladder has beside a law."""
    return len(law.fit.rungs) - len(law.forms)


def _refitted(fit: Fit, kept: Sequence[int], more: Sequence[Rung] = ()) -> Fit:
    """Return a fit with some of its rungs alone, and further ones."""
    after = fitted(fit.joint, [*(fit.rungs[k] for k in kept), *more])
    alike = (*(fit.alike[k] for k in kept), *[()] * len(more))
    return replace(after, alike=alike, lag=fit.lag, passed_over=fit.passed_over, first=fit.first)


def _law(fit: Fit, sigma: float | None) -> Lawful | None:
    """Return the law that explains what a fit leaves of its joint, beside its rungs; None where none holds."""
    if all(rung.effect != OFFSET for rung in fit.rungs):  # whatever begins somewhere has a constant elsewhere
        fit = _refitted(fit, range(len(fit.rungs)), [Rung(OFFSET)])
    folds = sorted({int(f) for f in np.unique(fit.joint.fold)} - {BETWEEN})
    if len(folds) < 2:
        return None
    apart = folds[:: min(HELD_BACK, len(folds))][: max(len(folds) // HELD_BACK, 1)]
    inside = [f for f in folds if f not in apart]
    search = _Search(fit, inside)
    forms, gain, charge, alike = search.found()
    if not forms or (proof := _proof(fit, [_rung(f, search.limits) for f in forms], inside, apart)) is None:
        return None
    for _ in range(SETTLES if any(LOAD in form.states for form in forms) else 1):
        every = _Search(fit, folds)
        forms, limits = _alive(fit, every.settled(forms), every.limits), every.limits
        if not forms:
            return None
        terms = [_rung(form, limits) for form in forms]
        kept = _needed(fit, terms)
        after = _refitted(fit, kept, terms)
        fit = replace(fit, load=after.load)  # without the law, the machine was asked for a part of what that gives
    if any(fit.rungs[k].effect == OFFSET for k in kept):  # nobody can tell a law's own constant from it
        kept = [k for k in kept if fit.rungs[k].effect != OFFSET]
        forms = (*forms[:-1], replace(forms[-1], factors=(*forms[-1].factors, ("1",))))
        terms = [_rung(form, limits) for form in forms]
        after = _refitted(fit, kept, terms)
    if rest(after, sigma) is not None:
        return None
    read = {state: limits[state] for form in forms for state in load_law(_name(form)).STATE}
    return Lawful(after.with_worth(), forms, read, gain, charge, *proof, alike, _std(after, forms, limits))


def _alive(fit: Fit, forms: tuple[Form, ...], limits: dict[str, tuple[float, float]]) -> tuple[Form, ...]:
    """Return the forms that are not nothing throughout: by another load on the joint, one may begin beyond it."""
    states = fit.joint.states | {LOAD: fit.load}
    return tuple(form for form in forms if fit.joint.of_rung(_rung(form, limits), states).any())


def _needed(fit: Fit, terms: Sequence[Rung]) -> list[int]:
    """Return which rungs of a fit still pay beside a law: what stood for it before is no effect of its own."""
    ladder = fit.ladder(terms)
    return [k for k in ladder.needed([*range(len(ladder.rungs))], ladder.bench.folds) if k < len(fit.rungs)]


def _name(form: Form) -> str:
    return f"{PREFIX}torque = {form.text}"


def _rung(form: Form, limits: dict[str, tuple[float, float]]) -> Rung:
    """Return a form as a rung: its constants as its module reads them, then where each state was."""
    law = load_law(_name(form))
    assert isinstance(law, Law)
    first = len(form.functions) + 1
    inner = {f"c{first + k}": v for k, v in enumerate(form.constants)}
    return Rung(law.NAME, (*(inner[name] for name in law.inner), *itertools.chain(*(limits[s] for s in law.STATE))))


def _forms(states: dict[str, Array]) -> Iterator[Form]:
    """Yield what the torque of a joint may have besides: see the module."""
    own = {name: states[name] for name in OF if name in states and np.ptp(states[name]) > 0}
    for name, values in own.items():
        yield from (single(name, atom) for atom in (*full(name, values), *_stops(name, values)))
    for friction in (Atom("sign(qd)"), Atom("qd")):
        for name, values in own.items():
            if STATES[name].rests or switch(values):
                continue
            yield from (product(("qd", friction), (name, atom)) for atom in full(name, values))


def _stops(state: str, values: Array) -> Iterator[Atom]:
    """Yield what begins at a value and goes on to one side: springs and stops, straight or ever harder."""
    for k in np.quantile(values, THRESHOLDS):
        yield Atom(f"Max({{0}} - {state}, 0)", (float(k),), 3)
        yield Atom(f"Max({state} - {{0}}, 0)**2", (float(k),), 4)
        yield Atom(f"Max({{0}} - {state}, 0)**2", (float(k),), 4)


class _Priced(NamedTuple):
    """A form with what it earns and is charged in chi2, and what it takes of the held-out rms."""

    form: Form
    gain: float
    charge: float
    buys: float


class _Search:
    """Forms beside all that a fit of a joint has, on some folds: screened at some samples, refined, and held out."""

    def __init__(self, fit: Fit, folds: Sequence[int]) -> None:
        self.fit, self.folds = fit, folds
        self.states = states = fit.joint.states | {LOAD: fit.load}
        self.limits = {name: (float(values.min()), float(values.max())) for name, values in states.items()}
        rows = np.flatnonzero(np.isin(fit.joint.fold, folds))
        self.rows = rows[:: -(-len(rows) // SCREENED)]
        self.some = {name: values[self.rows] for name, values in states.items()}
        self.own = fit.joint.columns(fit.rungs, fit.load)
        self._begin([])

    def _begin(self, terms: Sequence[Form]) -> None:
        """Take terms of the law as known beside what the fit has."""
        self.terms = [_rung(form, self.limits) for form in terms]
        beside = np.hstack([self.own[self.rows], *(rung.columns(self.some) for rung in self.terms)])
        self.Q = basis(beside, 1e-8)
        self.left = project_out(self.fit.joint.y[self.rows], self.Q)

    def explained(self, form: Form) -> float:
        """Return which part of the squares that are left a form takes away, at the samples of the screen."""
        with np.errstate(all="ignore"):
            Z = _rung(form, self.limits).columns(self.some)
            size = np.sqrt((Z**2).sum(axis=0))
        if not np.isfinite(size).all():
            return 0.0
        Z = project_out(Z, self.Q)
        free = np.sqrt((Z**2).sum(axis=0))
        if (free <= 1e-6 * size).any():
            return 0.0
        found = np.linalg.lstsq(Z / free, self.left, rcond=1e-9)[0]
        return float(1.0 - np.sum((self.left - Z / free @ found) ** 2) / np.sum(self.left**2))

    def refined(self, form: Form, beside: Sequence[Form]) -> Form:
        """Return a form with the constants that explain most beside other terms."""
        if not form.constants:
            return form
        self._begin(beside)
        start, span = np.array(form.constants), np.array([self._span(form, k) for k in range(len(form.constants))])
        positive = start > 0
        simplex = np.vstack([np.zeros(len(start)), 0.1 * np.eye(len(start))])

        def unexplained(moved: Array) -> float:
            constants = start + moved * span
            if (positive & (constants <= 0)).any():
                return 0.0
            return -self.explained(form.with_constants(constants))

        best = minimize(
            unexplained,
            np.zeros(len(start)),
            method="Nelder-Mead",
            options={"initial_simplex": simplex, "maxfev": TRIED, "xatol": 1e-4, "fatol": 1e-9},
        )
        return form.with_constants(start + best.x * span)

    def settled(self, forms: Sequence[Form]) -> tuple[Form, ...]:
        """Return terms of a law with the constants that explain most together: each beside the others, in turn."""
        out = list(forms)
        for _ in range(SWEEPS if len(out) > 1 else 1):
            for k in range(len(out)):
                out[k] = self.refined(out[k], [*out[:k], *out[k + 1 :]])
        return tuple(out)

    def _span(self, form: Form, k: int) -> float:
        """Return by how much a constant may well differ: its own size, or the range of the state that it counts in."""
        low, high = self.limits[form.states[-1]]
        return max(0.5 * abs(form.constants[k]), 0.05 * (high - low))

    def found(self) -> tuple[tuple[Form, ...], float, float, tuple[str, ...]]:
        """Return the terms that earn their charge, their gain and charge in chi2, and what is like the first."""
        forms = list(_forms(self.states))
        chosen: list[Form] = []
        gain = charge = 0.0
        alike: tuple[str, ...] = ()
        while len(chosen) < TERMS:
            self._begin(chosen)
            shares = np.array([self.explained(form) for form in forms])
            first = [self.refined(forms[k], chosen) for k in np.argsort(-shares)[:REFINED]]
            self._begin(chosen)
            priced = sorted((self._priced(form, len(forms)) for form in first), key=lambda p: p.charge - p.gain)
            best, lead = priced[0].form, priced[0].gain - priced[0].charge
            if lead <= 0 or priced[0].buys < BUYS:
                break
            if not chosen:
                near = [p.form for p in priced[1:] if lead - (p.gain - p.charge) < ALIKE]
                alike = tuple(f"torque = {f.text}" for f in near if f.text != best.text)
            chosen, gain, charge = [*self.settled([*chosen, best])], gain + priced[0].gain, charge + priced[0].charge
        return tuple(chosen), gain, charge, alike

    def _priced(self, form: Form, tried: int) -> _Priced:
        """Return a form with what it earns, costs and buys beside the terms taken, on the folds of the search."""
        joint = self.fit.joint
        before = np.hstack([self.own, *(rung.columns(self.states) for rung in self.terms)])
        X = np.hstack([before, _rung(form, self.limits).columns(self.states)])
        bench = joint.bench(X)
        own, every = range(before.shape[1]), range(X.shape[1])
        after = bench.fit(every, self.folds)
        count = float(bench.n[list(self.folds)].sum()) / joint.correlated(joint.y - X @ (after / bench.scale))
        gain = count * float(np.log(bench.train(own, self.folds) / max(bench.train(every, self.folds), 1e-300)))
        charge = PER_COEFFICIENT * (form.length + len(form.constants)) + 2 * float(np.log(tried))
        folds = self.folds if len(self.folds) > 1 else bench.folds
        buys = 1.0 - float(np.sqrt(bench.held_out(every, folds) / bench.held_out(own, folds)))
        return _Priced(form, gain, charge, buys)


def _proof(fit: Fit, terms: Sequence[Rung], inside: Sequence[int], apart: Sequence[int]) -> tuple[float, float] | None:
    """Return the rms on folds that took no part, and the share of the excess taken away; None where it does not hold.

    Coefficients are of the folds of the search.
    """
    joint, states = fit.joint, fit.joint.states | {LOAD: fit.load}
    own = joint.columns(fit.rungs, fit.load)
    law = np.hstack([rung.columns(states) for rung in terms])
    smooth = list(channels(fit).values())
    bench = joint.bench(np.hstack([own, law, *smooth]))

    def left(more: Sequence[int]) -> float:
        columns = [*range(own.shape[1]), *more]
        by = bench.with_ridge(columns, inside) if len(inside) > 1 else bench
        return by.error(columns, by.fit(columns, inside), apart)

    at = own.shape[1]
    before, after = left([]), left(range(at, at := at + law.shape[1]))
    others = []
    for each in smooth:
        others.append(left(range(at, at + each.shape[1])))
        at += each.shape[1]
    count = float(bench.n[list(apart)].sum())
    if 1.0 - np.sqrt(after / before) < SHOWS or before - after < MOST_OF * (before - min(others)):
        return None
    noise = min(after, *others)
    share = (before - after) / max(before - noise, 1e-300)
    return float(np.sqrt(after / count)), float(np.clip(share, 0.0, 1.0))


def _std(fit: Fit, forms: Sequence[Form], limits: dict[str, tuple[float, float]]) -> tuple[tuple[float, ...], ...]:
    """Return standard deviations of coefficients and constants of a law, all fitted with everything else."""
    joint, states = fit.joint, fit.joint.states | {LOAD: fit.load}
    X = joint.columns(fit.rungs, fit.load)
    at = X.shape[1] - sum(len(form.functions) for form in forms)
    columns, places = [X], []
    end = X.shape[1]
    for form in forms:
        own = fit.coefficients[at : at + len(form.functions)]
        by = []
        for k, value in enumerate(form.constants):
            step = STEP * max(abs(value), 1e-3 * float(np.ptp(limits[form.states[-1]])))
            sides = []
            for side in (step, -step):
                moved = [*form.constants[:k], value + side, *form.constants[k + 1 :]]
                sides.append(_rung(form.with_constants(moved), limits).columns(states) @ own)
            by.append((sides[0] - sides[1]) / (2 * step))
        columns += [np.column_stack(by)] if by else []
        places.append([*range(at, at + len(own)), *range(end, end + len(by))])
        at, end = at + len(own), end + len(by)
    whole = np.hstack(columns)
    bench = joint.bench(whole)
    bench = bench.with_ridge(range(X.shape[1]))
    variance = fit.sigma**2 * fit.together
    std = np.sqrt(np.maximum(np.diag(bench.covariance(range(whole.shape[1]))), 0.0) * variance) / bench.scale
    return tuple(tuple(float(std[i]) for i in own) for own in places)
