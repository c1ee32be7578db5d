"""How surely a fit knows a machine, the errors that its model leaves out included: what bands are made of.

A smaller model fits what it has to readings of a machine that has more. The errors that it leaves out move the readings
at new poses, and they have bent the parameters that were fitted: both are linear in them, so that one covariance of all
source errors, effects and instrument's unknowns holds both. How large they are the residuals tell: their size in
ordinary errors and the noise are what explains best what the fit leaves (restricted maximum likelihood, Patterson and
Thompson 1971, Biometrika 58, 545-554); where the readings tell nothing they are ordinary.
"""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.system import system
from deltacal_gen.identification.noise import Noise, freedom, lack_of_fit
from deltacal_gen.inference.likelihood import MixedModel
from deltacal_gen.inference.projection import basis, project_out
from deltacal_gen.inference.sizes import fit_sizes
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.factors import packed, unpacked
from deltacal_gen.results.parts import Source, Uncertainty
from deltacal_gen.units import file_unit

ORDINARY_SPREAD = np.log(3.0)  # of the size of left-out errors about the ordinary one, before the readings
SIZES = (0.03, 30.0)  # of left-out errors, between which the likeliest is sought
NOISES = (1e-6, 2.0)  # parts of the fit's own variance, likewise of the noise
FEWEST = 3.0  # degrees of freedom on which a figure may rest


class _Left(NamedTuple):
    """Source errors that a model leaves out: names, units, ordinary sizes, and their whitened columns (scalars, q)."""

    names: tuple[str, ...]
    units: tuple[str, ...]
    ordinary: Array
    columns: Array


def uncertainty_of(final: Fit, known: Noise, heldout: float | None = None) -> Uncertainty:
    """Return how surely a fit knows machine and instrument, and what it leaves beyond noise.

    `heldout` is the RMS [mm] of readings held out where functions bend to those that were not: beyond noise is what
    these leave.
    """
    problem = final.problem
    left = _left_out(final)
    sigma = final.sigma if heldout is None else final.sigma * (heldout / final.rms())
    beyond = heldout is not None or lack_of_fit(final, problem.recording)
    excess = max(sigma[0] ** 2 / _per_reading(final, known) ** 2 - 1, 0.0) if beyond else 0.0
    size: dict[str, float] | None = None
    C = final.covariance
    if left.names:
        C, size = _widened(final, left, known)
        excess = 0.0
    scatter = sigma * np.sqrt(excess / (1 + excess))
    return Uncertainty(
        parameters=(*problem.names, *left.names),
        coefficients=sum(t.n_coefficients for t in problem.terms),
        factor=packed(C),
        degrees=max(freedom(final), FEWEST),
        scatter=scatter,
        left_out=size,
        text=_text(left, size, excess),
    )


def factor(known: Uncertainty) -> Array:
    """Return L (n, n) of the covariance L L' of parameters, coefficients and instrument's unknowns."""
    return unpacked(known.factor)


def _per_reading(final: Fit, known: Noise) -> float:
    """Return the known noise of a reading as the fit counts it [mm]: a distance made of positions has that of two."""
    return known.sigma * (np.sqrt(2.0) if final.problem.readings.made else 1.0)


def _text(left: _Left, size: dict[str, float] | None, excess: float) -> str:
    held = "Bands hold the uncertainty of parameters and instrument"
    if size is not None:
        within = {unit: "without a unit" if unit == "1" else f"in {unit}" for unit in size}
        sizes = " and ".join(f"{value:.2g} times ordinary ones {within[unit]}" for unit, value in size.items())
        held += f", and {len(left.names)} source errors that the model leaves out, {sizes}"
    elif excess > 0:
        held += ", and what no effect explains, as if it were another at each pose"
    return held + "; not the noise of a reading."


def _left_out(final: Fit) -> _Left:
    """Return the source errors of the mechanism's full model that the fit's model leaves out."""
    problem = final.problem
    mechanism, own = problem.mechanism, set(problem.names)
    full = mechanism.model(mechanism.full_model)
    names = tuple(n for n in full if n not in own) if own <= set(full) else ()
    typical = mechanism.typical[[mechanism.index[n] for n in names]]
    units = tuple(file_unit(mechanism.parameters[mechanism.index[n]].unit) for n in names)
    sizes = np.array([problem.robot.tolerance.get(n, s) for n, s in zip(names, typical, strict=True)])
    if not names:
        return _Left((), (), sizes, np.zeros((0, 0)))
    n, q = len(problem.names), len(names)
    scale = np.concatenate([problem.scale[:n], sizes, problem.scale[n:]])
    wide = dataclasses.replace(problem, names=(*problem.names, *names), scale=scale)
    state = wide.linearise(final.errors, final.instrument, final.machine)
    A = system(state, final.sigma, final.weights, final.repeats, scale).A_p
    return _Left(names, units, sizes, A[:, n : n + q])


def _widened(final: Fit, left: _Left, known: Noise) -> tuple[Array, dict[str, float]]:
    """Return the covariance of [names, left out, coefficients, instrument], and how large what is left out is, by unit.

    With readings b = A p + B u + M m + noise, u unit vectors of ordinary errors, an estimate p* = p + R (b - A p) that
    knows nothing of u is off by R B u; the instrument's unknowns follow.
    """
    problem, solution = final.problem, final.solution
    state = problem.linearise(final.errors, final.instrument, final.machine)
    linear = system(state, final.sigma, final.weights, final.repeats, problem.scale)
    A_p, A_m, b = linear.A_p, linear.A_m, linear.b
    Q = basis(A_m)
    V, s, f = solution.V, solution.singular_values, solution.factors
    with np.errstate(divide="ignore", invalid="ignore"):
        back = (V * np.where(f > 0, f / s**2, 0.0)) @ V.T
    moved = back @ (project_out(A_p, Q).T @ project_out(left.columns, Q))
    follow = -np.linalg.lstsq(A_m, A_p, rcond=None)[0] if A_m.shape[1] else np.zeros((0, A_p.shape[1]))
    direct = np.linalg.lstsq(A_m, left.columns, rcond=None)[0] if A_m.shape[1] else np.zeros((0, len(left.names)))
    by_left = np.vstack([moved * problem.scale[:, None], direct + follow @ moved])

    fixed = (_per_reading(final, known) / final.sigma[0]) ** 2 if known.source is not Source.RESIDUAL else None
    size, part = _sizes(A_p, A_m, b, left, final.departure if solution.posterior else None, fixed)

    n, n_c, q = len(problem.names), len(problem.scale), len(left.names)
    prior = np.zeros_like(final.covariance)
    if solution.posterior:
        own = (V * (1 - f) ** 2) @ V.T + np.eye(n_c) - V @ V.T
        both = np.vstack([np.diag(problem.scale), follow])
        prior = both @ own @ both.T
    moved_by, own_by = by_left * size, np.diag(-left.ordinary * size)
    noise = part * (final.covariance - prior) + prior + moved_by @ moved_by.T
    whole = np.block([[noise, moved_by @ own_by], [own_by @ moved_by.T, own_by @ own_by]])
    order = [*range(n), *range(len(noise), len(noise) + q), *range(n, len(noise))]
    return whole[np.ix_(order, order)], dict(zip(left.units, size.tolist(), strict=True))


def _sizes(
    A_p: Array, A_m: Array, b: Array, left: _Left, departure: Array | None, fixed: float | None
) -> tuple[Array, float]:
    """Return the size (q,) of left-out errors, in ordinary ones, and the part of the fit's variance that is noise.

    Lengths have one size, angles another. `departure` (n,) of the parameters from where priors of unit variance draw
    them; None where none do. `fixed` is that part where the noise is known.
    """
    A, r, B = np.hstack([A_p, A_m]), b, left.columns
    if departure is not None:
        A = np.vstack([A, np.eye(len(departure), A.shape[1])])
        r, B = np.concatenate([b, -departure]), np.vstack([B, np.zeros((len(departure), B.shape[1]))])
    units = list(dict.fromkeys(left.units))
    owner = np.array([units.index(unit) for unit in left.units])
    found = fit_sizes(
        MixedModel.of(B, r, basis(A)),
        owner,
        (SIZES[0] ** 2, SIZES[1] ** 2),
        noise=NOISES if fixed is None else fixed,
        spread=float(ORDINARY_SPREAD),
    )
    return np.sqrt(found.variances[owner]), found.noise
