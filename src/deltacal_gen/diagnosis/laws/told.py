"""Laws as DIAGNOSIS.json holds them: expressions, numbers with units, where they were found, and their curve."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.linalg import block_diag

from deltacal_gen.diagnosis.laws.ground import Ground
from deltacal_gen.diagnosis.refits import terms_of
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.residuals import lengths, rms
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.formula import unit, written
from deltacal_gen.physics.law import Law as LawModule
from deltacal_gen.physics.law import inside, is_law, load_law
from deltacal_gen.physics.terms import Term
from deltacal_gen.results.diagnosis import Law, LawCoefficient, LawCurve, LawTerm, RunnerUp
from deltacal_gen.states import named
from deltacal_gen.units import of_joints

if TYPE_CHECKING:
    from deltacal_gen.diagnosis.laws.laws import Lawful, Unsure

POINTS = 121  # of a curve
STEP = 1e-3  # of a constant, by which its derivative is taken


def told(laws: tuple[Lawful, ...], final: Fit) -> tuple[Law, ...]:
    """Return laws as answers hold them, the best one with the numbers of the final fit."""
    others = tuple(law.text for law in laws[1:])
    return tuple(_law(law, final if k == 0 else law.fit, others if k == 0 else ()) for k, law in enumerate(laws))


def _law(law: Lawful, at: Fit, alike: tuple[str, ...]) -> Law:
    every = terms_of(at)
    every_law = [i for i, t in enumerate(every) if is_law(t.effect)]
    places, rest = every_law[: len(law.law)], every_law[len(law.law) :]
    std = np.sqrt(np.maximum(np.diag(at.covariance), 0.0))
    unit_of_joints = at.problem.recording.joint_unit
    terms: list[LawTerm] = []
    ends: dict[str, tuple[float, float]] = {}
    for i, unsure in zip(places, law.unsure, strict=True):
        term, own = every[i], std[at.problem.coefficients(i)]
        module = load_law(term.effect)
        terms.append(_term(term, module, np.hypot(own, np.sqrt(unsure.added)), unsure.std, unit_of_joints))
        for state, (low, high) in zip(module.STATE, module.ends(term.constants), strict=True):
            before = ends.get(state, (np.inf, -np.inf))
            ends[state] = (min(before[0], float(low)), max(before[1], float(high)))
    curves: list[LawCurve] = []
    for n, (i, unsure) in enumerate(zip(places, law.unsure, strict=True)) if alike or law.proof.holds else ():
        drawn = _curve(at, i, rest, unsure)
        curves += [] if drawn is None else [drawn.replace(term=n)]
    return Law(
        terms=tuple(terms),
        states=tuple(ends),
        range=ends,
        heldout_rms_mm=law.proof.rms,
        share_of_excess=float(np.clip(law.proof.share, 0.0, 1.0)),
        gain=law.gain,
        charge=law.charge,
        alike=alike,
        borne_out=law.proof.holds,
        curve=next((c for c in curves if c.term == 0), None),
        curves=tuple(curves),
        forms_tried=law.count or None,
        runners_up=tuple(
            RunnerUp(target=t.target, limbs=t.limbs, expression=t.form.text, gain=t.gain, charge=t.price)
            for t in law.runners_up
        ),
        remainder_rms_mm=_moved(at, rest) if rest else None,
    )


def _moved(at: Fit, some: Sequence[int]) -> float:
    """Return by how much some terms move the readings, RMS [mm]."""
    terms = [terms_of(at)[i] for i in some]
    columns = at.problem.term_columns(terms, at.errors, at.instrument, at.machine)
    moved = columns @ np.concatenate([t.values.ravel() for t in terms])
    return rms(lengths(np.where(np.isfinite(at.residual), moved, np.nan), at.problem.readings.kind))


def _term(term: Term, law: LawModule, std: Array, of_constants: Array, joint_unit: str) -> LawTerm:
    coefficients = []
    spread = std.reshape(term.values.shape)
    for r, row in enumerate(term.values):
        limb = term.limbs[r] if term.limbs else None
        units = law.units(_joint_unit(joint_unit, limb))
        coefficients += [
            LawCoefficient(name=c, limb=limb, value=float(v), std=float(s), unit=written(units[c]))
            for c, v, s in zip(law.formula.linear, row, spread[r], strict=True)
        ]
    units = law.units(_joint_unit(joint_unit, min(term.limbs, default=None)))
    for k, name in enumerate(_in_order(law)):
        value = float(term.constants[law.inner.index(name)])
        coefficients.append(
            LawCoefficient(name=name, limb=None, value=value, std=float(of_constants[k]), unit=written(units[name]))
        )
    expression = law.formula.text
    return LawTerm(target=law.TARGETS[0], limbs=term.limbs, expression=expression, coefficients=tuple(coefficients))


def _in_order(law: LawModule) -> list[str]:
    """Return the names of the constants within a law as a form counts them."""
    return sorted(law.inner, key=lambda name: int(name[1:]))


def _joint_unit(joint_unit: str, limb: int | None) -> str:
    return of_joints(joint_unit, max(limb or 1, 1))[(limb or 1) - 1]


def _curve(at: Fit, i: int, rest: Sequence[int], unsure: Unsure) -> LawCurve | None:
    """Return a term along its first state, other states at their median, and what every reading says of it.

    With what its form leaves, terms `rest` of the fit that sit where it does.
    """
    term = terms_of(at)[i]
    law = load_law(term.effect)
    ground = Ground(at)
    if law.lags or any(s not in ground.states for s in law.STATE):
        return None
    drawn = _Drawn.of(at, [i, *(k for k in rest if _beside(terms_of(at)[k], term))], unsure)
    place, limb = ground.place(law.TARGETS[0]), (term.limbs or (1,))[0]
    column = place.columns[:, :, limb - 1 if term.limbs else 0]
    seen = {s: _of_limb(ground.states[s], limb) for s in law.STATE}
    now = drawn.value(seen)
    residual = np.where(np.isfinite(at.residual[:, : column.shape[1]]), at.residual[:, : column.shape[1]], 0.0)
    size = (column**2).sum(axis=1)
    moved = (column * residual).sum(axis=1) / np.where(size > 0, size, np.inf)
    low, high = law.ends(term.constants)[0]
    first, *others = law.STATE
    middle = {s: float(np.median(seen[s])) for s in others}
    grid = {first: np.linspace(low, high, POINTS)} | {s: np.full(POINTS, v) for s, v in middle.items()}
    # with several states a reading is shown as it would be at the medians of the others
    level = {first: seen[first]} | {s: np.full(len(now), v) for s, v in middle.items()}
    shown = drawn.value(level)
    ratio = np.divide(shown, now, out=np.ones_like(now), where=np.abs(now) > 1e-3 * np.abs(now).max())
    joint_unit = _joint_unit(at.problem.recording.joint_unit, limb)
    return LawCurve(
        state=first,
        unit=written(unit(inside(named(first), joint_unit))),
        target_unit=law.unit_moved(joint_unit),
        at=grid[first],
        value=drawn.value(grid),
        std=drawn.std(grid, level),
        seen=seen[first],
        partial=shown + ratio * moved,
    )


def _beside(rest: Term, term: Term) -> bool:
    """Tell whether what is left of a law's form is left of this term's."""
    own, whole = load_law(rest.effect), load_law(term.effect)
    return (own.TARGETS, rest.limbs) == (whole.TARGETS, term.limbs) and set(own.STATE) <= set(whole.STATE)


@dataclass(frozen=True)
class _Drawn:
    """Terms at one place as a function of their states, on the first of their limbs; the first has constants."""

    terms: list[Term]
    covariance: Array
    unsure: Unsure

    @staticmethod
    def of(at: Fit, some: Sequence[int], unsure: Unsure) -> _Drawn:
        terms = [terms_of(at)[i] for i in some]
        own = [j for i, t in zip(some, terms, strict=True) for j in at.problem.coefficients(i)[: t.values.shape[1]]]
        return _Drawn(terms, at.covariance[np.ix_(own, own)], unsure)

    def value(self, states: Mapping[str, Array]) -> Array:
        """Return by how much they move their place (N,), states (N,) by name."""
        return np.asarray(sum(m.value(s, t.values[:1], t.constants)[:, 0] for t, m, s in self._each(states)))

    def std(self, states: Mapping[str, Array], seen: Mapping[str, Array]) -> Array:
        """Return the standard deviation (N,) of `value` by those of the coefficients and of the constants within.

        Coefficients go with the constants, as `Unsure.by` says: beside a scale that is larger, a slope is less. Where
        the mean over the readings, at states `seen`, is less known than the curve varies, geometry takes over what is
        unknown of it, and it is that of the curve beside its mean.
        """
        at, there = self._derivatives(states), self._derivatives(seen)
        unknown = block_diag(self.covariance, self.unsure.covariance)
        mean = there.mean(axis=0)
        if mean @ unknown @ mean > np.ptp(self.value(states)) ** 2:
            at = at - mean
        return np.sqrt(np.maximum(np.einsum("nc,cd,nd->n", at, unknown, at), 0.0))

    def _derivatives(self, states: Mapping[str, Array]) -> Array:
        """Return the derivatives (N, n_c + n) of `value` by the coefficients and the constants."""
        by = [m.jacobian(s, t.values[:1], t.constants)[:, 0] for t, m, s in self._each(states)]
        return np.hstack([*by, self._by_constants(states)])

    def _by_constants(self, states: Mapping[str, Array]) -> Array:
        """Return the derivatives (N, n) of `value` by the constants within the first term, its coefficients in step."""
        term, law, s = next(self._each(states))
        out = np.zeros((len(s), len(self.unsure.std)))
        for k, name in enumerate(_in_order(law)):
            at, ends = law.inner.index(name), []
            step = STEP * max(abs(float(term.constants[at])), 1e-12)
            for h in (step, -step):
                constants = [*term.constants[:at], float(term.constants[at]) + h, *term.constants[at + 1 :]]
                values = term.values[:1] + h * self.unsure.by[k, : term.values.shape[1]]
                ends.append(law.value(s, values, constants)[:, 0])
            out[:, k] = (ends[0] - ends[1]) / (2 * step)
        return out

    def _each(self, states: Mapping[str, Array]) -> Iterator[tuple[Term, LawModule, Array]]:
        for term in self.terms:
            law = load_law(term.effect)
            yield term, law, np.column_stack([states[s] for s in law.STATE])


def _of_limb(values: Array, limb: int) -> Array:
    return values[:, limb - 1] if values.ndim == 2 else values
