"""A payload that is not what was written: its mass and centre, found by all drives together.

Where the robot file states all bodies, what they leave may be the payload's: one mass and one centre for each `setup`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.inference.projection import basis, project_out

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array
    from deltacal_gen.motion.fit import Fit
    from deltacal_gen.motion.rigid import Rigid
    from deltacal_gen.motion.trajectories import Trajectories

PAYLOAD = "payload_error"  # as the vocabulary calls it
ADVICE = "Weigh what the machine carries and say so (payload_kg), or enter it at the controller with its centre."
NAMES = (("mass", "kg"), ("com_x", "mm"), ("com_y", "mm"), ("com_z", "mm"))
ROUNDS = 12
FIRST = 0.1  # kg: where the search begins
SETTLED = 1e-6  # of a deviation: the last step
LIGHTEST, FARTHEST = -1e-3, 1000.0  # kg of a payload, mm of its centre from the tool point
UNSEEN = 1e-9  # of the largest: what a number may tell at least


@dataclass(frozen=True, eq=False)
class PayloadError:
    """What a payload has beside what is written.

    Attributes
    ----------
    setups : tuple of str
    values, std : (S, 4) arrays
        Mass [kg], centre from the tool point along the last link's axes [mm]; std nan where no torque tells.
    gain : float
        Of chi2, samples that hang together counted as one.
    """

    setups: tuple[str, ...]
    values: Array
    std: Array
    gain: float = 0.0


def torque_of(rigid: Rigid, states: Array, given: Trajectories, setups: Sequence[str], values: Array) -> Array:
    """Return what a payload asks of the joints (N, n_q) beyond what is written, by `values` (S, 4) of each set-up.

    A set-up that is not among `setups` has what is written.
    """
    out = np.zeros(given.joints.shape)
    for name, (mass, *centre) in zip(setups, values, strict=True):
        own = np.flatnonzero(given.setup_is(name))
        if len(own):
            written, at = given.payload[own, None], np.asarray(centre)
            there = rigid.of_payload(states[:, own], at) * (written + mass)
            out[own] = there - rigid.of_payload(states[:, own]) * written
    return out


def payload_error(rigid: Rigid, states: Array, given: Trajectories, fits: Sequence[Fit]) -> PayloadError | None:
    """Return the payload by which all drives together leave least, beside each joint's own rungs (Gauss-Newton).

    A set-up of which it would be no payload, less than nothing or out of all reach, carries what is written: one that
    carries nothing has no centre. None where no other is left.

    Parameters
    ----------
    states : (3, N, n_q) array
        Of the joints; zero where they are not known.
    """
    setups = given.setup_names
    while setups:
        found = _of_setups(rigid, states, given, fits, setups)
        if isinstance(found, PayloadError):
            return found
        setups = found
    return None


def _of_setups(
    rigid: Rigid, states: Array, given: Trajectories, fits: Sequence[Fit], setups: tuple[str, ...]
) -> PayloadError | tuple[str, ...]:
    """Return the payload of some set-ups, or those of them that could carry what this comes to."""
    values = np.zeros((len(setups), 4))
    values[:, 0] = FIRST  # a mass must be there for its centre to be told
    std = np.full_like(values, np.nan)
    for _ in range(ROUNDS):
        now = torque_of(rigid, states, given, setups, values)
        columns = _by_values(rigid, states, given, setups, values, now)
        step, std = _step(fits, now, columns, values.shape)
        values = values + step
        could = tuple(s for s, row in zip(setups, values, strict=True) if _could_be(given, s, row))
        if len(could) < len(setups):
            return could
        if (np.abs(step) <= SETTLED * np.nan_to_num(std, nan=np.inf)).all():
            break
    now = torque_of(rigid, states, given, setups, values)
    gain = sum(len(f.left) / f.together * np.log(_left(f, None) / _left(f, now)) for f in fits)
    return PayloadError(setups, values, std, float(gain))


def _could_be(given: Trajectories, setup: str, row: Array) -> bool:
    """Tell whether a machine could carry such a payload, mass and centre (4,), in a set-up."""
    mass = float(given.payload[given.setup_is(setup)].max(initial=0.0)) + row[0]
    return mass > LIGHTEST and bool((np.abs(row[1:]) < FARTHEST).all())


def _by_values(
    rigid: Rigid, states: Array, given: Trajectories, setups: Sequence[str], values: Array, now: Array
) -> Array:
    """Return the derivatives (N, n_q, 4 S) of the joints' torques by mass and centre of each set-up's payload."""
    found = []
    for k in np.ndindex(values.shape):
        moved = values.copy()
        moved[k] += 1e-3
        found.append((torque_of(rigid, states, given, setups, moved) - now) / 1e-3)
    return np.stack(found, axis=2)


def _step(fits: Sequence[Fit], now: Array, columns: Array, shape: tuple[int, ...]) -> tuple[Array, Array]:
    """Return what the numbers move by, and their standard deviations; nothing where no torque tells."""
    G, g = np.zeros((columns.shape[2],) * 2), np.zeros(columns.shape[2])
    for fit in fits:
        joint, j = fit.joint, fit.joint.number - 1
        own = _columns(fit)
        P, left = columns[joint.rows, j], joint.y - now[joint.rows, j]
        Q = basis(own)
        P, left = project_out(P, Q), project_out(left, Q)
        weight = 1.0 / (np.mean(left**2) * fit.together)
        G += weight * P.T @ P
        g += weight * P.T @ left
    size = np.sqrt(np.diag(G))
    seen = size > UNSEEN * size.max(initial=0.0)
    step, std = np.zeros(len(g)), np.full(len(g), np.nan)
    if seen.any():
        scaled = G[np.ix_(seen, seen)] / np.outer(size[seen], size[seen])
        inverse = np.linalg.pinv(scaled, rcond=UNSEEN, hermitian=True)
        step[seen] = inverse @ (g[seen] / size[seen]) / size[seen]
        std[seen] = np.sqrt(np.diag(inverse)) / size[seen]
    return step.reshape(shape), std.reshape(shape)


def _columns(fit: Fit) -> Array:
    return fit.joint.columns(fit.rungs, fit.load)


def _left(fit: Fit, torque: Array | None) -> float:
    """Return the sum of squares of a joint, its rungs fitted, without or with a payload's torque (N, n_q)."""
    own, y = _columns(fit), fit.joint.y
    if torque is not None:
        y = y - torque[fit.joint.rows, fit.joint.number - 1]
    return float(np.sum((y - own @ np.linalg.lstsq(own, y, rcond=None)[0]) ** 2))
