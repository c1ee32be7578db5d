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
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.factors import packed, unpacked
from deltacal_gen.results.parts import Source, Uncertainty
from deltacal_gen.units import file_unit

ORDINARY_SPREAD = np.log(3.0)  # of the size of left-out errors about the ordinary one, before the readings
SIZES = np.geomspace(0.03, 30.0, 40)  # of left-out errors that are tried
NOISES = np.geomspace(1e-6, 2.0, 60)  # parts of the fit's own variance that are tried as noise
ROUNDS = 3  # through sizes and noise
FEWEST = 3.0  # degrees of freedom on which a figure may rest
UNSEEN = 1e-9  # of the largest column: less is none


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
    Q = np.linalg.qr(A_m)[0] if A_m.shape[1] else np.zeros((len(b), 0))
    V, s, f = solution.V, solution.singular_values, solution.factors
    with np.errstate(divide="ignore", invalid="ignore"):
        back = (V * np.where(f > 0, f / s**2, 0.0)) @ V.T
    beside = left.columns - Q @ (Q.T @ left.columns)
    moved = back @ ((A_p - Q @ (Q.T @ A_p)).T @ beside)
    follow = -np.linalg.lstsq(A_m, A_p, rcond=None)[0] if A_m.shape[1] else np.zeros((0, A_p.shape[1]))
    direct = np.linalg.lstsq(A_m, left.columns, rcond=None)[0] if A_m.shape[1] else np.zeros((0, len(left.names)))
    by_left = np.vstack([moved * problem.scale[:, None], direct + follow @ moved])

    departure = (final.errors[problem.columns] - problem.reference[problem.columns]) / problem.scale
    fixed = (_per_reading(final, known) / final.sigma[0]) ** 2 if known.source is not Source.RESIDUAL else None
    size, part = _sizes(A_p, A_m, b, left, departure if solution.posterior else None, fixed)

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
    U, s, _ = np.linalg.svd(A, full_matrices=False)
    U = U[:, s > UNSEEN * s.max(initial=0.0)]
    r, B = r - U @ (U.T @ r), B - U @ (U.T @ B)
    W, d, _ = np.linalg.svd(B, full_matrices=False)
    W = W[:, d > UNSEEN * max(float(d.max(initial=0.0)), 1.0)]
    c, apart = W.T @ r, W.T @ B
    kinds = np.array(left.units)
    shares = {unit: apart[:, kinds == unit] @ apart[:, kinds == unit].T for unit in dict.fromkeys(left.units)}
    rest, free = max(float(r @ r - c @ c), 0.0), max(len(b) - A_m.shape[1] - W.shape[1], 0)

    def misfit(part: float, sizes: dict[str, float]) -> float:
        """Return twice the negative logarithm of the restricted likelihood, and of what is likely before readings."""
        C = part * np.eye(len(c)) + sum(size**2 * shares[unit] for unit, size in sizes.items())
        before = sum((np.log(size) / ORDINARY_SPREAD) ** 2 for size in sizes.values())
        within = float(np.linalg.slogdet(C)[1] + c @ np.linalg.solve(C, c)) if len(c) else 0.0
        return within + free * float(np.log(part)) + rest / part + before

    part, sizes = fixed or 1.0, dict.fromkeys(shares, 1.0)
    for _ in range(ROUNDS):
        if fixed is None:
            part = min(NOISES.tolist(), key=lambda k: misfit(k, sizes))
        for unit in sizes:
            sizes[unit] = min(SIZES.tolist(), key=lambda size: misfit(part, sizes | {unit: size}))
    return np.array([sizes[unit] for unit in left.units]), part
