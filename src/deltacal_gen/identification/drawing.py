"""Whether the robot file draws the machine that was read, or another one."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from deltacal_gen.estimation.fit import fit, held_out
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import unsaid, with_prior
from deltacal_gen.estimation.residuals import lengths, rms
from deltacal_gen.estimation.solvers import LeastSquares, Prior
from deltacal_gen.files.robot import robot_size
from deltacal_gen.identification.folds import folds
from deltacal_gen.identification.mistakes import AS_NEAR, EXPLAINED, NEARER, attempt
from deltacal_gen.identification.noise import coordinate_sigma, noise
from deltacal_gen.machine.registry import Array
from deltacal_gen.results.parts import Source
from deltacal_gen.units import file_unit, to_internal

ANOTHER = 1e-9  # chance that a machine which is as it is known is so far off
FARTHEST = 3  # parameters that are told of it
PROMISED = 0.1  # of the squares that are left: a step on the way to another machine promises more
WIDER = (10.0, 100.0)  # times what drawings leave open: where another machine is looked for
ABOVE_NOISE, ABOVE_SIZE = 10.0, 1e-3  # of the noise, or of the machine where noise is not known: what asks for it


def as_read(at: Fit, *, robust: bool = True) -> Fit | None:
    """Return the fit of a machine far from the robot file that explains ten times as much; None where there is none.

    A rod that is a decimetre longer than drawn is so incredible that a fit whose noise is open believes in noise of
    centimetres instead. Readings whose noise is known, if roughly, or that leave what no stiff machine does, are
    asked whether another machine gives them: the first steps tell, and only what they come near is fitted whole. Like a
    mistake, it has to explain nearly all; and to foretell readings held out, as few readings any machine explains.
    """
    problem, count, kind = at.problem, len(at.problem.names), at.problem.readings.kind
    if kind.sees_joints or not count or coordinate_sigma(at) < _suspicious(at):
        return None
    parts = folds(problem.readings, problem.recording)
    drawn, said = with_prior(problem.with_names(problem.names), problem.robot)
    how: dict[str, Any] = {"robust": robust, "must_converge": False}
    begun = {"instrument": at.instrument, "tolerance": PROMISED * problem.readings.n_scalars, "across": True}
    for wider in WIDER:
        scale = problem.scale.copy()
        scale[:count] = drawn.scale[:count] * np.where(said, 1.0, wider)
        wide = dataclasses.replace(problem, scale=scale)
        other = attempt(fit, wide, Prior(), errors=at.errors, **begun, **how)
        if other and other.rms() < AS_NEAR * EXPLAINED * at.rms():
            other = attempt(fit, wide, Prior(), errors=other.errors, instrument=other.instrument, **how)
        if not other or other.rms() >= EXPLAINED * at.rms():
            continue
        if held_out(other, Prior(), parts) < NEARER * held_out(at, Prior(), parts):
            return other
    return None


def _suspicious(at: Fit) -> float:
    """Return what a fit may leave [mm] of a machine that is as drawn: far more than noise, where that is known.

    Of heights, whose noise is known roughly, the usual one counts: distances stand beside them.
    """
    known, kind = noise(at, at.problem.recording), at.problem.readings.kind
    if known.source is not Source.RESIDUAL:
        return ABOVE_NOISE * known.sigma
    if kind.probed:
        return ABOVE_NOISE * (kind.usual_noises or (kind.usual_noise,))[0]
    return ABOVE_SIZE * robot_size(at.problem.robot)


def in_file(at: Fit) -> Array:
    """Return the source errors of the robot file's machine; of what the file does not say, as a fit has it."""
    errors, mechanism = at.problem.reference.copy(), at.problem.mechanism
    own = [mechanism.index[name] for name in unsaid(at.problem)]
    errors[own] = at.errors[own]
    return errors


def filed_rms(at: Fit) -> float:
    """Return the error of the robot file's machine, the instrument alone fitted [mm]."""
    free = at.problem.with_names(())
    alone = fit(free, LeastSquares(), errors=in_file(at), weigh_repeats=False, must_converge=False)
    return rms(lengths(alone.residual, at.problem.readings.kind))


def doubts(at: Fit) -> tuple[str, ...]:
    """Return why a fitted machine may be another one than the robot file's: it is farther off than drawings leave open.

    What the drawing leaves open is the robot file's tolerance, or ten ordinary errors.
    """
    drawn = with_prior(at.problem.with_names(at.problem.names), at.problem.robot)[0]
    if not strained(as_drawn := dataclasses.replace(at, problem=drawn)):
        return ()
    moved, off = _departure(as_drawn)
    order = np.argsort(-np.abs(off))[:FARTHEST]
    kinds = [drawn.mechanism.parameters[drawn.columns[k]] for k in order]
    told = (
        f"{p.name} by {moved[k] / to_internal(p.unit):+.3g} {file_unit(p.unit)} "
        f"where {drawn.scale[k] / to_internal(p.unit):.2g} is much"
        for p, k in zip(kinds, order, strict=True)
        if 2 * abs(off[k]) > abs(off[order[0]])
    )
    return (
        f"the identified machine differs from the robot file by more than parts are off: {'; '.join(told)}. "
        "Compare the file's dimensions with the machine; where they are rough, say how rough ([tolerance]).",
    )


def strained(at: Fit) -> bool:
    """Tell whether a fitted machine is farther from the robot file than what the fit takes as known makes credible.

    What readings do not determine stays as it was known, so the departure is the least that explains them: of a
    machine that is one of those, the sum of its squares in standard deviations is below chi2 of as many parameters.
    """
    _, off = _departure(at)
    if off @ off <= len(off):
        return False  # as far as is usual: most are, and need no distribution
    from scipy.special import chdtrc  # a fifth of a second, of which an ordinary calibration has no need

    return bool(chdtrc(len(off), float(off @ off)) < ANOTHER)


def _departure(at: Fit) -> tuple[Array, Array]:
    """Return how far parameters are from the robot file [mm, rad], and that in standard deviations beforehand."""
    problem, n = at.problem, len(at.problem.names)
    moved = (at.errors - problem.reference)[problem.columns[:n]]
    return moved, moved / problem.scale[:n]
