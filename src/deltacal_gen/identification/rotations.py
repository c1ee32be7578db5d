"""Whether measured rotations are this machine's: what else their angles, or the axes they are about, may be."""

from __future__ import annotations

import itertools

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.rotation import align, from_turns, from_vector, to_vector
from deltacal_gen.machine.values import ROTATION
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
    off, turn = np.linalg.norm(told - made, axis=1), align(made, told)
    left = np.linalg.norm(told - made @ turn.T, axis=1)
    most = np.median(left)  # a pose that was read wrongly, and near half a turn an axis of the other sense, are beyond
    vector: Array = to_vector(align(made[left <= most], told[left <= most])[None])[0]
    return vector if most < TURNED * np.median(off) else None


def _apart(rotations: Array, drawn: Array, problem: Problem) -> float:
    """Return by how much rotations (R, 3, 3) differ from others [rad], the median over pairs of poses of a set-up.

    From pose to pose both turn by one angle, wherever the instrument stands and however its body is mounted.
    """
    setup, off = problem.readings.setup, []
    for s in np.unique(setup):
        own = np.flatnonzero((setup == s) & np.isfinite(rotations[:, 0, 0]))[:POSES_LOOKED_AT]
        a, b = np.triu_indices(len(own), 1)
        turns = (to_vector(np.swapaxes(R[own[a]], 1, 2) @ R[own[b]]) for R in (rotations, drawn))
        read, made = (np.linalg.norm(turn, axis=1) for turn in turns)
        off.append(np.abs(read - made))
    return float(np.median(np.concatenate(off)))


def turns_alike(first: Fit) -> None:
    """Raise an InputError where measured rotations agree with the machine as turns about axes, not as vectors.

    The machine is the robot file's: one that was fitted to such rotations has bent to them.
    """
    problem, found = first.problem, first.problem.readings
    if not turned(first) or found.rotations is None or not {3, 4, 5} <= {*found.components}:
        return
    drawn = problem.solve(problem.reference).x[found.rows[:, 0], 3:].reshape(-1, 3, 3)
    off, recording, read = _apart(found.rotations, drawn, problem), problem.recording, np.isfinite(found.rotations)
    angles = recording.measured[found.rows[:, 0]][:, [recording.columns.index(name) for name in ROTATION]]
    tried = {order: np.full(found.rotations.shape, np.nan) for order in map("".join, itertools.permutations("xyz"))}
    for order, rotations in tried.items():
        rotations[read[:, 0, 0]] = from_turns(order, angles[read[:, 0, 0]])
    left = {order: _apart(rotations, drawn, problem) for order, rotations in tried.items()}
    best = min(left, key=lambda order: left[order])
    if left[best] < TURNED * off:
        raise InputError(
            f"rx_deg, ry_deg, rz_deg are no rotation vectors: from pose to pose they turn by {off / DEG:.2g} deg more "
            f"or less than the machine. As angles of turns about the instrument's axes, one after the other, it is "
            f"{left[best] / DEG:.2g} deg.",
            f'Say so under [measurement] in the sidecar: rotation = "{best}".',
            file=recording.path,
        )
