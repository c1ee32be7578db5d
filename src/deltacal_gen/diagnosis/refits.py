"""Fits of geometry, instrument and chosen effects, each from the one before."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np

from deltacal_gen.diagnosis.charges import several
from deltacal_gen.errors import InputError, NoSolutionError
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import ROUNDING, Problem
from deltacal_gen.estimation.residuals import Repeats
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.identification.together import common
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Term, beyond, largest, without_rows

SEARCHED = 1e-2  # of chi2: what a last step of a fit within the search may still gain
COMPARED = 0.5  # of chi2: the same, of a fit that is compared with others, by a margin of 10
# mm: root mean square that an effect's coefficient may well move the readings, a prior that never pulls; where readings
# hardly see it, that of its believable range does
ROOM = 10.0


def terms_of(at: Fit) -> list[Term]:
    """Return the effects that a fit left free, with the coefficients it found."""
    return list(at.problem.split(at.errors)[1])


def refitted(
    problem: Problem,
    at: Fit,
    terms: Sequence[Term],
    drop_gross: bool = False,
    tolerance: float = SEARCHED,
    known: Sequence[Term] | None = None,
) -> Fit | None:
    """Return the joint fit of geometry, instrument and effects, starting from a fit; None where there is none.

    What is left out may look like gross errors where it is strongest: none is dropped before all is known. Of effects
    that are `known` no saddle is sought; default those of the fit before, which was asked for its own.
    """
    n_p = len(problem.mechanism.parameters)
    errors, joint, same = at.errors[:n_p], problem, at.problem.body is problem.body
    if terms:
        machine = at.machine if same else problem.solve(errors)
        columns = problem.term_columns(terms, at.errors, at.instrument, machine)
        flat = np.where(np.isfinite(columns), columns, 0.0).reshape(-1, columns.shape[2])
        size = np.linalg.norm(flat, axis=0)
        scale = ROOM * np.sqrt(len(flat)) / np.maximum(size, max(ROUNDING * size.max(), 1e-300))
        most = np.concatenate([largest(t, problem.recording.joint_unit).ravel() for t in terms])
        borne = problem.borne(terms)  # what bears nothing stays nothing
        joint = problem.with_terms(terms, np.minimum(scale, most) * np.where(borne, 1.0, ROUNDING))
        errors = np.concatenate([errors, borne * np.concatenate([t.values.ravel() for t in terms])])
    try:
        return fit(
            joint,
            Prior(),
            errors=errors,
            machine=joint.solve(errors, near=at.machine if same else None),
            instrument=at.instrument,
            repeats=_correlated(at, problem),
            drop_gross=drop_gross,
            must_converge=False,
            tolerance=tolerance,
            known=_among(terms, terms_of(at) if known is None else known),
        )
    except (NoSolutionError, InputError):
        return None


def _among(terms: Sequence[Term], others: Sequence[Term]) -> np.ndarray:
    """Return which coefficients (n_c,) of effects are of one of the others."""
    own = {*map(form, others)}
    return np.array([form(t) in own for t in terms for _ in range(t.n_coefficients)], dtype=bool)


def _correlated(at: Fit, problem: Problem) -> Repeats | None:
    """Return how the noise of other readings hangs together, as a fit counts with it; None where it knows nothing."""
    known = at.repeats
    if known.plain or (own := common(problem, at)) is None:
        return None
    series = known.series and own.like(known.series)
    return dataclasses.replace(known, group=problem.readings.group, series=series)


def believable(problem: Problem, at: Fit, **how: Any) -> Fit:
    """Return a fit without the effects, or their limbs, that would need a size that no machine has."""
    kept: list[Term] = []
    for i, term in enumerate(terms := terms_of(at)):
        cannot = beyond(term, std_of(at, i), problem.recording.joint_unit)
        less = without_rows(term, [c.row for c in cannot]) if cannot else term
        kept += [] if less is None else [less]
    if list(map(form, kept)) == list(map(form, terms)):
        return at
    return refitted(problem, at, kept, **how) or at


def std_of(at: Fit, i: int) -> Array:
    """Return the standard deviations (n_c,) of an effect's coefficients."""
    return np.sqrt(np.maximum(np.diag(at.covariance)[at.problem.coefficients(i)], 0.0))


def kind(term: Term) -> tuple[object, ...]:
    """Return an effect, and of one that a machine may have several times, which."""
    return term.effect, term.constants if several(term.effect) else ()


def place(term: Term) -> tuple[object, ...]:
    """Return an effect and where it is, whatever its size; of one that may be there several times, which."""
    return *kind(term), term.limbs, term.tools


def form(term: Term) -> tuple[object, ...]:
    """Return an effect, and where and with which constants it is."""
    return term.effect, term.limbs, term.constants, term.tools
