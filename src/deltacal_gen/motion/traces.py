"""Some samples of each joint, to be drawn: what was read, and what a model says, before and after, or unseen."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.motion.derivatives import motion
from deltacal_gen.motion.fit import Fit
from deltacal_gen.motion.prediction import predicted
from deltacal_gen.motion.trajectories import Trajectories
from deltacal_gen.results.motion import MotionModel, Trace
from deltacal_gen.units import joint_factors, of_joints

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array
    from deltacal_gen.motion.session import Session

DRAWN = 600  # samples in a row that are drawn over time
SPREAD = 250  # samples over the whole recording, drawn against what they may depend on


def traces(session: Session, plain: Sequence[Fit], found: Sequence[Fit]) -> tuple[Trace, ...]:
    """Return what is drawn of each joint that moves; `plain` is the rigid machine alone."""
    factors = joint_factors(session.given.joint_unit, len(session.joints))
    return tuple(
        _of_joint(session, before, after, factors[after.joint.number - 1])
        for before, after in zip(plain, found, strict=True)
    )


def _of_joint(session: Session, before: Fit, after: Fit, factor: float) -> Trace:
    joint, unit = after.joint, after.joint.readout.inside
    measured = session.given.readings[:, joint.number - 1]
    errors = [_everywhere(fit, len(measured)) / unit for fit in (before, after)]
    window = _window(joint.rows, joint.piece)
    some = _spread(joint.rows)
    load = np.full(len(measured), np.nan)
    load[joint.rows] = after.load / unit
    states = joint.series.states
    return Trace(
        limb=joint.number,
        unit=joint.unit,
        slides=session.rigid.dynamics.joint_units[joint.number - 1] == "mm",
        time=session.given.time[window],
        measured=measured[window],
        before=(measured - errors[0])[window],
        after=(measured - errors[1])[window],
        speed=states["qd"][some] / factor,
        position=states["q"][some] / factor,
        load=load[some],
        error_before=errors[0][some],
        error_after=errors[1][some],
    )


def unseen(known: MotionModel, given: Trajectories) -> tuple[Trace, ...]:
    """Return what is drawn of each joint of which a model predicts samples that it has not seen: before is after."""
    done, states = predicted(known, given), motion(given, known.motion.cutoff_Hz).states
    assert done.load is not None
    factors = joint_factors(given.joint_unit, given.joints.shape[1])
    left, found = given.readings - done.readings, []
    for j, rows in enumerate(np.flatnonzero(there) for there in np.isfinite(left).T):
        if not len(rows):
            continue
        window = _window(rows, given.piece)
        some = _spread(rows)
        model = done.readings[window, j]
        found.append(
            Trace(
                limb=j + 1,
                unit=done.units[j],
                slides=of_joints(given.joint_unit, given.joints.shape[1])[j] == "mm",
                time=given.time[window],
                measured=given.readings[window, j],
                before=model,
                after=model,
                speed=states[1, some, j] / factors[j],
                position=states[0, some, j] / factors[j],
                load=done.load[some, j],
                error_before=left[some, j],
                error_after=left[some, j],
            )
        )
    return tuple(found)


def _spread(rows: np.ndarray) -> np.ndarray:
    """Return some of the samples, over the whole recording."""
    return rows[np.unique(np.linspace(0, len(rows) - 1, SPREAD).astype(int))]


def _everywhere(fit: Fit, count: int) -> Array:
    """Return the residuals of a fit at all samples (N,); nan where there is none."""
    out = np.full(count, np.nan)
    out[fit.joint.rows] = fit.left
    return out


def _window(rows: np.ndarray, piece: np.ndarray) -> np.ndarray:
    """Return samples in a row, from the middle of the movement that holds most of those in motion."""
    most = int(np.argmax(np.bincount(piece[rows])))
    own = np.flatnonzero(piece == most)
    first = max(0, (len(own) - DRAWN) // 2)
    return own[first : first + DRAWN]
