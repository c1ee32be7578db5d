"""Formulas as DIAGNOSIS.json holds them: expressions, numbers with units, where they were found, and their curve."""

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


def told(laws: Sequence[Lawful], final: Fit) -> tuple[Law, ...]:
    """Return formulas as answers hold them, the best one with the numbers of the final fit.

    A formula that nobody has registered is a rival only if it was confirmed on held-out data.
    """
    confirmed = [law for law in laws if law.proof.holds]
    alike = tuple(law.text for law in confirmed[1:])
    return tuple(_law(law, law.fit if k else final, () if k else alike) for k, law in enumerate(confirmed))


def _law(law: Lawful, at: Fit, alike: tuple[str, ...]) -> Law:
    terms = terms_of(at)
    every = [i for i, t in enumerate(terms) if is_law(t.effect)]
    own, rest = list(zip(every, law.unsure, strict=False)), every[len(law.law) :]
    limits: dict[str, tuple[float, float]] = {}
    for i, _ in own:
        module = load_law(terms[i].effect)
        for state, (low, high) in zip(module.STATE, module.ends(terms[i].constants).tolist(), strict=True):
            least, most = limits.get(state, (low, high))
            limits[state] = min(least, low), max(most, high)
    curves = [(n, _curve(at, i, rest, unsure)) for n, (i, unsure) in enumerate(own)]
    drawn = tuple(curve.replace(term=n) for n, curve in curves if curve is not None)
    return Law(
        terms=tuple(_term(at, i, unsure) for i, unsure in own),
        states=tuple(limits),
        range=limits,
        heldout_rms_mm=law.proof.rms,
        share_of_excess=float(np.clip(law.proof.share, 0.0, 1.0)),
        gain=law.gain,
        charge=law.charge,
        alike=alike,
        borne_out=law.proof.holds,
        curve=next((c for c in drawn if c.term == 0), None),
        curves=drawn,
        forms_tried=law.count or None,
        runners_up=tuple(
            RunnerUp(target=t.target, limbs=t.limbs, expression=t.form.text, gain=t.gain, charge=t.price)
            for t in law.runners_up
        ),
        remainder_rms_mm=_moved(at, [terms[i] for i in rest]) if rest else None,
    )


def _moved(at: Fit, terms: Sequence[Term]) -> float:
    """Return by how much some terms move the readings, RMS [mm]."""
    columns = at.problem.term_columns(terms, at.errors, at.instrument, at.machine)
    moved = columns @ np.concatenate([t.values.ravel() for t in terms])
    return rms(lengths(np.where(np.isfinite(at.residual), moved, np.nan), at.problem.readings.kind))


def _term(at: Fit, i: int, unsure: Unsure) -> LawTerm:
    """Return a term of a fit with its coefficients, joint by joint, and the constants within, in their order."""
    term, own = terms_of(at)[i], at.problem.coefficients(i)
    law = load_law(term.effect)
    std = np.sqrt(np.maximum(np.diag(at.covariance)[own], 0.0) + unsure.added).reshape(term.values.shape)
    units = [law.units(_joint_unit(at, limb)) for limb in term.limbs or (0,)]
    numbers = [
        (name, term.limbs[r] if term.limbs else None, value, std[r, k], units[r][name])
        for r, row in enumerate(term.values)
        for k, (name, value) in enumerate(zip(law.formula.linear, row, strict=True))
    ]
    numbers += [
        (name, None, term.constants[law.inner.index(name)], unsure.std[k], units[0][name])
        for k, name in enumerate(_in_order(law))
    ]
    return LawTerm(
        target=law.target,
        limbs=term.limbs,
        expression=law.formula.text,
        coefficients=tuple(
            LawCoefficient(name=name, limb=limb, value=float(value), std=float(s), unit=written(of))
            for name, limb, value, s, of in numbers
        ),
    )


def _in_order(law: LawModule) -> list[str]:
    """Return the names of the constants within a formula as a form counts them."""
    return sorted(law.inner, key=lambda name: int(name[1:]))


def _joint_unit(at: Fit, limb: int) -> str:
    """Return the unit of a joint, from 1; of the first one where the machine has the formula."""
    return of_joints(at.problem.recording.joint_unit, max(limb, 1))[max(limb, 1) - 1]


def _curve(at: Fit, i: int, rest: Sequence[int], unsure: Unsure) -> LawCurve | None:
    """Return a term along its first state, other states at their median, and what every reading says of it.

    With what its form leaves, terms `rest` of the fit that sit where it does.
    """
    term, ground = terms_of(at)[i], Ground(at)
    law = load_law(term.effect)
    if law.lags or any(s not in ground.states for s in law.STATE):
        return None
    drawn = _Drawn.of(at, [i, *(k for k in rest if _beside(terms_of(at)[k], term))], unsure)
    place, limb = ground.place(law.TARGETS[0]), min(term.limbs, default=0)
    column = place.columns[:, :, max(limb, 1) - 1 if term.limbs else 0]
    read = {s: ground.states[s] for s in law.STATE}
    seen = {s: v if v.ndim == 1 else v[:, max(limb, 1) - 1] for s, v in read.items()}
    residual = np.nan_to_num(at.residual[:, : column.shape[1]])
    size = (column**2).sum(axis=1)
    moved = (column * residual).sum(axis=1) / np.where(size > 0, size, np.inf)
    first, *others = law.STATE
    middle = {s: float(np.median(seen[s])) for s in others}

    def along(values: Array) -> dict[str, Array]:
        return {first: values} | {s: np.full(len(values), v) for s, v in middle.items()}

    low, high = law.ends(term.constants)[0]
    grid, level = along(np.linspace(low, high, POINTS)), along(seen[first])
    # with several states a reading is shown as it would be at the medians of the others
    now, shown = drawn.value(seen), drawn.value(level)
    ratio = np.divide(shown, now, out=np.ones_like(now), where=np.abs(now) > 1e-3 * np.abs(now).max())
    return LawCurve(
        state=first,
        unit=written(unit(inside(named(first), _joint_unit(at, limb)))),
        target_unit=law.unit_moved(_joint_unit(at, limb)),
        at=grid[first],
        value=drawn.value(grid),
        std=drawn.std(grid, level),
        seen=seen[first],
        partial=shown + ratio * moved,
    )


def _beside(rest: Term, term: Term) -> bool:
    """Tell whether what is left of a formula's form is left of this term's."""
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
        """Return the standard uncertainty (N,) of `value` by those of the coefficients and of the constants within.

        Coefficients go with the constants, as `Unsure.by` says: with a scale that is larger, a slope is less. Where
        the mean over the readings, at states `seen`, is less known than the curve varies, geometry takes over what is
        unknown of it, and it is that of the curve about its mean.
        """
        by, mean = self._derivatives(states), self._derivatives(seen).mean(axis=0)
        unknown = block_diag(self.covariance, self.unsure.covariance)
        if mean @ unknown @ mean > np.ptp(self.value(states)) ** 2:
            by = by - mean
        return np.sqrt(np.maximum(np.einsum("nc,cd,nd->n", by, unknown, by), 0.0))

    def _derivatives(self, states: Mapping[str, Array]) -> Array:
        """Return the derivatives (N, n_c + n) of `value` by the coefficients and the constants, with which these go."""
        each = list(self._each(states))
        by = [m.jacobian(s, t.values[:1], t.constants)[:, 0] for t, m, s in each]
        term, law, s = each[0]
        for name, moved in zip(_in_order(law), self.unsure.by[:, : term.values.shape[1]], strict=True):
            k = law.inner.index(name)
            step = STEP * max(abs(float(term.constants[k])), 1e-12)
            above, below = (
                law.value(
                    s,
                    term.values[:1] + h * moved,
                    [*term.constants[:k], float(term.constants[k]) + h, *term.constants[k + 1 :]],
                )
                for h in (step, -step)
            )
            by.append((above - below) / (2 * step))
        return np.hstack(by)

    def _each(self, states: Mapping[str, Array]) -> Iterator[tuple[Term, LawModule, Array]]:
        for term in self.terms:
            law = load_law(term.effect)
            yield term, law, np.column_stack([states[s] for s in law.STATE])
