"""Whether measured rotations are this machine's, and how the axes stand that they are about."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.rotation import align, from_vector, to_vector
from deltacal_gen.units import DEG

POSES_LOOKED_AT = 60  # poses on which mistakes are tried
FAR_TURNED = 2 * DEG  # rms of rotations beside a fit: no instrument reads so badly
TURNED = 0.3  # of what they are off: what another meaning of their angles may leave that explains them


class Turns(NamedTuple):
    """Rotations from pose to pose of one set-up beside others: both by one angle, wherever and however each is mounted.

    Attributes
    ----------
    off : float
        Median distance of their rotation vectors [rad].
    frame : (3, 3) array
        The rotation that takes the axes of the first to those of the others.
    left : float
        What of `off` it leaves.
    """

    off: float
    frame: Array
    left: float


def turned(at: Fit) -> tuple[str, ...]:
    """Return that measured rotations are not the machine's, where a fit leaves so much of them: they told nothing."""
    found = at.problem.readings
    left = at.residual[:, 3:] if found.rotations is not None else np.empty(0)
    left = left[np.isfinite(left)]
    off = float(np.sqrt(np.mean(left**2))) if len(left) else 0.0
    if off < FAR_TURNED:
        return ()
    said = f"the measured rotations are {off / DEG:.2g} deg off this machine, "
    turns = None
    if found.rotations is not None and {3, 4, 5} <= {*found.components}:
        gap = from_vector(np.nan_to_num(at.residual[:, 3:]))
        turns = compared(np.swapaxes(gap, 1, 2) @ found.rotations, found.rotations, found.setup)
    if turns is not None and turns.left < TURNED * turns.off:
        frame = to_vector(turns.frame[None])[0]
        angle = float(np.linalg.norm(frame))
        axis = ", ".join(f"{v:.2f}" for v in np.round(frame / angle, 2) + 0.0)
        return (
            f"{said}though from pose to pose they turn as it does: their axes are those of the positions turned by "
            f"{angle / DEG:.3g} deg about ({axis}). They told next to nothing. Give positions and rotations in one "
            "frame.",
        )
    return (
        f"{said}which explains its positions: they told next to nothing. rx_deg, ry_deg, rz_deg are a rotation vector "
        "of the platform about the instrument's axes; what else they may be, the sidecar says (rotation under "
        "[measurement]).",
    )


def compared(made: Array, told: Array, setup: np.ndarray) -> Turns | None:
    """Return how rotations (R, 3, 3) turn from pose to pose beside others, by set-up (R,); None of too few poses.

    A pose that was read wrongly, and turns near half a revolution, which may be of the other sense, are beyond the
    median.
    """
    read = np.isfinite(told).all(axis=(1, 2)) & np.isfinite(made).all(axis=(1, 2))
    looked_at = [np.flatnonzero(read & (setup == s))[:POSES_LOOKED_AT] for s in np.unique(setup)]
    a, b = np.hstack([own[np.array(np.triu_indices(len(own), 1))] for own in looked_at])
    if len(a) < 3:
        return None
    by_machine, by_reading = (to_vector(R[a] @ np.swapaxes(R[b], 1, 2)) for R in (made, told))

    def left(frame: Array) -> Array:
        return np.linalg.norm(by_reading - by_machine @ frame.T, axis=1)

    every = left(align(by_machine, by_reading))
    near = every <= np.median(every)
    frame = align(by_machine[near], by_reading[near])
    return Turns(float(np.median(left(np.eye(3)))), frame, float(np.median(left(frame))))
