"""Partial residuals: one number per reading, where the cause shows best, and what each effect moves.

Geometry that is fitted without an effect follows part of it. What the effect does shows undistorted as a partial
residual: the residual of the whole fit plus what the effect adds there (Larsen and McCleary 1972).
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np

from deltacal_gen.diagnosis.refits import form
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import Term
from deltacal_gen.results.diagnosis import PartialResiduals
from deltacal_gen.units import file_unit, to_internal


def added_by(final: Fit, terms: Sequence[Term]) -> Array | None:
    """Return what some of the acting effects add to measured positions (R, 3) [mm].

    None where readings are no positions in one frame. 0 where a coordinate was not read.
    """
    if not _in_one_frame(final):
        return None
    problem, removed = final.problem, {form(t) for t in terms}
    kept = tuple(t for t in problem.acting(final.errors) if form(t) not in removed)
    without, errors = dataclasses.replace(problem, terms=(), held=kept), problem.split(final.errors)[0]
    residuals = (
        p.residual(parameters, final.instrument, p.seen(machine))[:, :3]
        for p, parameters, machine in (
            (without, errors, without.solve(errors)),
            (problem, final.errors, final.machine),
        )
    )
    return np.nan_to_num(next(residuals) - next(residuals))


def most_moved(final: Fit, terms: Sequence[Term]) -> float | None:
    """Return by how much effects move a reading at most [mm]; None where `added_by` is."""
    added = added_by(final, terms)
    return None if added is None else float(np.linalg.norm(added, axis=1).max())


def partial_residuals(
    final: Fit, before: Array, after: Array, strongest: tuple[str, Sequence[Term]] | None, limbs: Sequence[int]
) -> PartialResiduals:
    """Return residuals as the error of the joint at fault, else along the direction of the largest residuals.

    Parameters
    ----------
    before, after : (R, k) array
        Residuals of the geometry and of the final fit, 0 where nothing was read [mm].
    strongest : (str, sequence of Term), optional
        The effect that explains most, and all terms of it.
    limbs : sequence of int
        Where the residual shows.
    """
    (unit, size), without = final.instrument.unit(final.problem.recording.columns) or ("mm", 1.0), None
    if strongest is not None and (added := added_by(final, strongest[1])) is not None:
        before, without = after + added, strongest[0]
    if before.shape[1] == 1:
        along, of = np.ones(1) / size, "residual"
    elif len(limbs) == 1 and _in_one_frame(final):
        along, unit = _at_joint(final, limbs[0])
        of = f"error of joint {limbs[0]}"
    else:
        centred = before - np.median(before, axis=0)
        along, of = np.linalg.svd(centred, full_matrices=False)[2][0] / size, "largest principal component of residual"
    return PartialResiduals(
        of=of, unit=unit, without=without, before=(along * before).sum(axis=1), after=(along * after).sum(axis=1)
    )


def _in_one_frame(final: Fit) -> bool:
    return final.problem.readings.kind.positions and len(final.problem.recording.setup_names) == 1


def _at_joint(final: Fit, limb: int) -> tuple[Array, str]:
    """Return what makes of a position's residual the error of a joint (R, 3), and its unit in files."""
    problem, mechanism = final.problem, final.problem.mechanism
    dx = problem.displacements(final.machine)[:, :, : mechanism.limbs]
    by_joints, _ = final.instrument.linearise(problem.readings, problem.seen(final.machine), dx)
    unit = mechanism.joint_units[limb - 1]
    along = np.linalg.pinv(by_joints[:, :3])[:, limb - 1].astype(np.float64)
    return along / to_internal(unit), file_unit(unit)
