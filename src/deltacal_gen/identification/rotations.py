"""Whether measured rotations are this machine's, and how the axes stand that they are about."""

from __future__ import annotations

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.rotation import align, from_vector, to_vector
from deltacal_gen.units import DEG

POSES_LOOKED_AT = 60  # poses on which mistakes are tried
FAR_TURNED = 2 * DEG  # rms of rotations beside a fit: no instrument reads so badly
TURNED = 0.3  # of what they are off: what another meaning of their angles may leave that explains them


def turned(at: Fit) -> tuple[str, ...]:
    """Return that measured rotations are not the machine's, where a fit leaves so much of them: they told nothing."""
    left = at.residual[:, 3:] if at.problem.readings.rotations is not None else np.empty(0)
    left = left[np.isfinite(left)]
    off = float(np.sqrt(np.mean(left**2))) if len(left) else 0.0
    if off < FAR_TURNED:
        return ()
    if (frame := _frame(at)) is not None:
        angle = float(np.linalg.norm(frame))
        axis = ", ".join(f"{v:.2f}" for v in np.round(frame / angle, 2) + 0.0)
        return (
            f"the measured rotations are {off / DEG:.2g} deg off this machine, though from pose to pose they turn as "
            f"it does: their axes are those of the positions turned by {angle / DEG:.3g} deg about ({axis}). They told "
            "next to nothing. Give positions and rotations in one frame.",
        )
    return (
        f"the measured rotations are {off / DEG:.2g} deg off this machine, which explains its positions: they told "
        "next to nothing. rx_deg, ry_deg, rz_deg are a rotation vector of the platform about the instrument's axes; "
        "what else they may be, the sidecar says (rotation under [measurement]).",
    )


def _frame(at: Fit) -> Array | None:
    """Return by what rotation vector (3,) the frame of rotations stands off that of positions; None where by none.

    A turn from pose to pose has one axis in each frame, and one angle, however the body is mounted.
    """
    found = at.problem.readings
    if found.rotations is None or at.residual.shape[1] < 6:
        return None
    read = np.flatnonzero(np.isfinite(at.residual[:, 3:]).all(axis=1))[:POSES_LOOKED_AT]
    a, b = (read[k] for k in np.triu_indices(len(read), 1))
    near = found.setup[a] == found.setup[b]
    measured = found.rotations
    predicted = np.full(measured.shape, np.nan)
    predicted[read] = np.swapaxes(from_vector(at.residual[read, 3:]), 1, 2) @ measured[read]
    made, told = (to_vector(R[a[near]] @ np.swapaxes(R[b[near]], 1, 2)) for R in (predicted, measured))
    if len(told) < 3:
        return None
    off, (turn, left) = float(np.median(np.linalg.norm(told - made, axis=1))), _aligned(made, told)
    vector: Array = to_vector(turn[None])[0]
    return vector if left < TURNED * off else None


def _aligned(made: Array, told: Array) -> tuple[Array, float]:
    """Return the rotation (3, 3) that takes vectors (P, 3) to others, and the median length of what it leaves.

    A pose that was read wrongly, and vectors near half a turn, which may be of the other sense, are beyond the median.
    """
    turn = align(made, told)
    left = np.linalg.norm(told - made @ turn.T, axis=1)
    near = left <= np.median(left)
    turn = align(made[near], told[near])
    return turn, float(np.median(np.linalg.norm(told - made @ turn.T, axis=1)))


def apart(rotations: Array, drawn: Array, problem: Problem) -> float:
    """Return by how much rotations (R, 3, 3) differ from others [rad], the median over pairs of poses of a set-up.

    From pose to pose both turn by one angle about one axis of the body, wherever the instrument stands; and the axes
    of all pairs are those of the other body turned by one rotation, that of its mount.
    """
    setup, turns = problem.readings.setup, []
    for s in np.unique(setup):
        own = np.flatnonzero((setup == s) & np.isfinite(rotations[:, 0, 0]))[:POSES_LOOKED_AT]
        a, b = np.triu_indices(len(own), 1)
        turns.append([to_vector(np.swapaxes(R[own[a]], 1, 2) @ R[own[b]]) for R in (drawn, rotations)])
    made, told = (np.concatenate(each) for each in zip(*turns, strict=True))
    return _aligned(made, told)[1] if len(told) else 0.0
