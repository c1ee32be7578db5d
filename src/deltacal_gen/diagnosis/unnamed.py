"""How far effects that nobody named shift those that were: small ones of the same cause, of which nothing was proven.

A standard deviation that knows of nothing but the model that was chosen is too small where a rival was left out for
parsimony alone: the shoulder that twists under a load stands for all that yields to it. What bears a load yields; that
a compliance was not proven says that it is small, not that there is none. Effects of one cause are taken to move the
readings by amounts drawn about zero, all with one size: the likeliest by what is left of the readings (a variance
component; Patterson and Thompson 1971). What they then are expected to be shifts the coefficients of what was named by
what leaving them out does to a fit. Where nothing is left the likeliest size is none, and so is the shift.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from deltacal_gen.diagnosis.charges import carriers_of
from deltacal_gen.diagnosis.refits import form, terms_of
from deltacal_gen.diagnosis.search import Search
from deltacal_gen.inference.likelihood import MixedModel
from deltacal_gen.inference.sizes import fit_sizes
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Term

SMALLEST = 1e-6  # of the size of what was named: less is none


def shifts(search: Search) -> dict[tuple[object, ...], Array]:
    """Return the variances (n_c,) that unnamed effects add to the coefficients of each effect of a fit, by its form."""
    terms, added = terms_of(search.fit), dict[tuple[object, ...], Array]()
    for cause in {_cause(t) for t in terms} - {frozenset()}:
        if columns := _unnamed(search, cause, terms):
            own = {i: t for i, t in enumerate(terms) if _cause(t) == cause}
            most = max(search.beside.moved(search.fit.problem.coefficients(i)) for i in own)
            products = expected_products(*search.normal(columns), search.beside.squares, most)
            for i, term in own.items():
                shift = search.shift_by(i, columns)
                added[form(term)] = np.einsum("ij,jk,ik->i", shift, products, shift)
    return added


def _cause(term: Term) -> frozenset[str]:
    """Return what an effect goes with: the channels that it reads, and whether it is a load; nothing for geometry."""
    return frozenset("load" if s.kind == "load" else s.name for s in term.states if s.kind in ("load", "channel"))


def _unnamed(search: Search, cause: frozenset[str], named: Sequence[Term]) -> list[int]:
    """Return the columns of effects of a cause that are not in a fit.

    What moves the same part of the same limb as a named effect stands instead of it, not beside it: a joint yields in
    one way; so does the simpler effect that a named one extends. Effects of which a constant is searched are not there
    all the time, and shift nothing that is.
    """
    within = {t.kernels.EXTENDS for t in named}
    taken = {(limb, t.kernels.TARGETS) for t in named for limb in carriers_of(t) or (None,)}
    out: list[int] = []
    for term in search.terms:
        if term.kernels.CONSTANTS or term.effect in within or not _cause(term) & cause:
            continue
        start, width = search.where(term)[0], term.values.shape[1]
        for row, limb in enumerate(carriers_of(term) or (None,)):
            if (limb, term.kernels.TARGETS) not in taken:
                out += range(start + row * width, start + (row + 1) * width)
    return out


def expected_products(G: Array, b: Array, squares: float, most: float) -> Array:
    """Return E[c c'] (n, n) of effects of unit columns in unit noise, drawn with the likeliest size, `most` at most."""
    model, within = MixedModel.normal(G, b, squares, len(b)), ((SMALLEST * most) ** 2, most**2)
    one = model.diagonal()
    size = fit_sizes(one, np.zeros(len(one.s), dtype=int), within, noise=1.0).variances[0]
    mean, covariance = model.posterior(np.full(len(b), size), 1.0)
    return covariance + np.outer(mean, mean)
