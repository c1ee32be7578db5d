"""Bands in motion: between which values a reading of a drive lies with 95 % probability.

What a fit knows of bodies and friction is one covariance, samples that hang together counted as one. What readings of
runs that took no part depart by beside it, noise and what the model leaves out, comes on top, as large as makes the
bands hold 95 % of just these readings, whatever their distribution. Bodies that the robot file states, and a payload
that was found beside them, count as known.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.errors import OtherVersion
from deltacal_gen.motion.fit import Fit
from deltacal_gen.motion.joint import earlier
from deltacal_gen.motion.library import Rung
from deltacal_gen.motion.sizes import STEP, by_sizes
from deltacal_gen.physics.factors import HELD, packed, quantile, unpacked
from deltacal_gen.results.motion import JointModel, JointUncertainty

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array
    from deltacal_gen.motion.trajectories import Trajectories

FEWEST = 3.0  # degrees of freedom on which a figure may rest
WIDE = 3.0  # times what one reading scatters: what is less sure than that, nobody has seen
TIES = 1e-6  # of a standard deviation: what sums in another order differ by


def uncertainty_of(fit: Fit) -> JointUncertainty:
    """Return how surely the reading of a joint is known, by what fits to the other folds leave of each."""
    degrees = max(len(fit.left) / fit.together - len(fit.covariance), FEWEST)
    known = np.isfinite(fit.held_out)
    beyond = np.quantile(fit.left**2, HELD)  # of the fit itself: no less is left of others
    if known.any():
        beyond = max(beyond, np.quantile(fit.held_out[known] ** 2 - quantile(degrees) ** 2 * _apart(fit)[known], HELD))
    return JointUncertainty(
        factor=packed(fit.covariance),
        scatter=float(np.sqrt(beyond)) / quantile(degrees),
        shown=float(np.sqrt(((_slopes(fit) @ unpacked(packed(fit.covariance))) ** 2).sum(axis=1).max())),
        degrees=float(degrees),
        delay_std=None if fit.lag is None else fit.lag.std,
    )


def _apart(fit: Fit) -> Array:
    """Return by how much (variance, (M,)) each sample is unknown to fits to the other folds."""
    joint, X = fit.joint, _slopes(fit)
    bench, each = joint.bench(X).with_prior(fit.prior), range(X.shape[1])
    out = np.zeros(len(X))
    for fold in bench.folds:
        own = joint.held == fold
        C = bench.covariance(each, [f for f in bench.folds if f != fold])
        columns = X[own] / bench.scale
        out[own] = ((columns @ C) * columns).sum(axis=1) * fit.sigma**2 * fit.together
    return out


def _slopes(fit: Fit) -> Array:
    """Return the derivatives (M, p) of what a fit says of its samples by all that its covariance is of."""
    joint = fit.joint
    return np.hstack([joint.columns(fit.rungs, fit.load), by_sizes(joint, fit.rungs, fit.coefficients, fit.load)])


def half_width(known: JointUncertainty, variance: Array) -> Array:
    """Return half the width (N,) of the bands of a joint's readings, in units inside; `variance` as of `unsure`."""
    return np.asarray(quantile(known.degrees) * np.sqrt(variance + known.scatter**2))


def unshown(known: JointUncertainty, variance: Array) -> np.ndarray:
    """Return the samples (N,) that ask of a joint what its recording did not show; `variance` as of `unsure`.

    Coefficients leave them far less sure (`WIDE`) than a reading beside the fit was, and less than any sample of that
    recording.
    """
    most = max(WIDE * known.scatter, known.shown or 0.0)
    return np.asarray(variance > (most * (1 + TIES)) ** 2)


def known_of(model: JointModel) -> JointUncertainty:
    """Return how surely a joint is known; raises an InputError where the result says nothing of it."""
    if model.uncertainty is None:
        raise OtherVersion(
            f"the result says nothing of how surely it knows joint {model.joint}: an earlier version made it.",
            "Run identify or diagnose again.",
        )
    return model.uncertainty


def unsure(
    model: JointModel, read: dict[str, Array], past: Sequence[dict[str, Array]], columns: Array, given: Trajectories
) -> Array:
    """Return the variance (N,) of what a joint's coefficients predict, in units inside.

    Parameters
    ----------
    read, past
        What effects read, the load among it, and what each remembers; see `prediction.given_by_drive`.
    columns : (N, r) array
        What each coefficient of the rigid machine, and the payload where it has one, asks of the joint.

    Raises
    ------
    InputError
        The result says nothing of its uncertainty.
    """
    known = known_of(model)
    by_size: list[Array] = []
    parts, total = [columns], columns @ _of_machine(model)
    for term, own in zip(model.terms, past, strict=True):
        rung, values = Rung(term.effect, term.constants), np.array(term.values)
        parts.append(rung.columns(read | own))
        total = total + parts[-1] @ values
        if rung.continuous:
            by_size.append(_by_size(rung, read, values, given))
    J = np.column_stack([*parts, *by_size])
    L = unpacked(known.factor)
    variance = ((J @ L) ** 2).sum(axis=1)
    if known.delay_std is not None:
        variance += (earlier(total, known.delay_std, given.time, given.piece) - total) ** 2
    return np.asarray(variance)


def _of_machine(model: JointModel) -> Array:
    return np.array([*model.coefficients, *([] if model.payload is None else [model.payload])])


def _by_size(rung: Rung, read: dict[str, Array], values: Array, given: Trajectories) -> Array:
    """Return the derivative (N,) of what an effect gives by the logarithm of its size."""
    sides = []
    for way in (STEP, -STEP):
        other = Rung(rung.effect, (rung.constants[0] * float(np.exp(way)),))
        sides.append(other.columns(read | other.remembered(read, given.time, given.piece)))
    return np.asarray((sides[0] - sides[1]) @ values / (2 * STEP))


def named(column: str) -> tuple[str, str]:
    """Return the names of the two ends of a column's band: ``tau1_lo_Nm, tau1_hi_Nm``; ``drive1_lo, drive1_hi``."""
    stem, _, unit = column.partition("_")
    return (f"{stem}_lo_{unit}", f"{stem}_hi_{unit}") if unit else (f"{stem}_lo", f"{stem}_hi")


def ends(done: Trajectories) -> dict[str, Array]:
    """Return the ends of the bands of predicted readings by their columns; none where no bands were asked for."""
    if done.half is None:
        return {}
    out: dict[str, Array] = {}
    for name, centre, half in zip(done.columns, done.readings.T, done.half.T, strict=True):
        out |= zip(named(name), (centre - half, centre + half), strict=True)
    return out
