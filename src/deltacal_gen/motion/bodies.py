"""Which bodies a machine in motion has: as its robot file states them, with another payload, or found anew.

What is stated holds as long as bodies that are free would not predict held-out samples better; where they would, or
the machine was set up in several ways, a payload that is not what was written is tried first.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from deltacal_gen.motion.common import asked_in_common
from deltacal_gen.motion.fit import Fit, climbed, fitted
from deltacal_gen.motion.joint import USUAL
from deltacal_gen.motion.ladder import BUYS
from deltacal_gen.motion.lag import with_lag
from deltacal_gen.motion.library import Rung
from deltacal_gen.motion.payload import PayloadError
from deltacal_gen.motion.regression import EXACT
from deltacal_gen.motion.session import Session

Progress = Callable[[str], None]
AGAIN = 2  # rounds in which the payload is fitted beside the rungs that were found beside it


@dataclass(frozen=True, eq=False)
class Found:
    """The ladders of all joints that move.

    Attributes
    ----------
    session : Session
        With what is known of the machine's bodies.
    fits : list of Fit
    free : list of Fit
        The same rungs beside bodies that are all unknown.
    payload : PayloadError, optional
    bought : tuple of float
        Part of the held-out rms that the payload takes away, joint by joint.
    """

    session: Session
    fits: list[Fit]
    free: list[Fit]
    payload: PayloadError | None = None
    bought: tuple[float, ...] = ()


def searched(session: Session, progress: Progress) -> Found:
    """Return the ladders of a recording whose bodies are all unknown, or known as far as the robot file is right."""
    known = session.stated()
    if known is None:
        fits = _climbed(session, progress)
        return Found(session, fits, fits)
    fits = _climbed(known, progress)
    free = beside(session, fits)
    holds, found = _as_good(fits, free), None
    if not holds or len(session.given.setup_names) > 1:  # no bodies are right for several payloads, free ones neither
        usual = [fitted(joint, [Rung(name) for name in USUAL]) for joint in known.moving]
        found = _carrying(session, known, known.payload_by(usual), progress)
    if found is None and holds:
        return Found(known, fits, free)
    if found is None:
        fits = _climbed(session, progress)
        return Found(session, fits, fits)
    return found


def _carrying(session: Session, known: Session, payload: PayloadError | None, progress: Progress) -> Found | None:
    """Return the ladders of a machine with another payload; None where that is not what its bodies lack."""
    for _ in range(AGAIN):
        carrying = None if payload is None else session.stated(payload)
        if payload is None or carrying is None:
            return None
        fits = _climbed(carrying, progress)
        without = beside(known, fits)
        used, payload = payload, known.payload_by(without)
    free = beside(session, fits)
    if payload is None or carrying is None or not _as_good(fits, free):
        return None
    bought = tuple(1.0 - _rms(after) / _rms(before) for after, before in zip(_again(fits), without, strict=True))
    if max(bought) < BUYS:
        return None
    return Found(carrying, fits, free, replace(used, std=payload.std, gain=payload.gain), bought)


def _climbed(session: Session, progress: Progress) -> list[Fit]:
    found = []
    for joint in session.moving:
        progress(f"joint {joint.number}")
        found.append(with_lag(climbed(joint)))
    return asked_in_common(found, session.rigid.dynamics.joint_units)


def beside(session: Session, fits: Sequence[Fit]) -> list[Fit]:
    """Return the fits of the same rungs beside the bodies of another session."""
    joints = {joint.number: joint for joint in session.joints}
    return [fitted(joints[fit.joint.number].series.at(fit.joint.delay), fit.rungs) for fit in fits]


def _again(fits: Sequence[Fit]) -> list[Fit]:
    """Return the fits as `fitted` holds out: the same choice of rungs in every fold."""
    return [fitted(fit.joint, fit.rungs) for fit in fits]


def _as_good(fits: Sequence[Fit], free: Sequence[Fit]) -> bool:
    """Tell whether free bodies would buy less than a rung has to, of every joint."""
    pairs = zip(_again(fits), free, strict=True)
    return all(_rms(other) > (1.0 - BUYS) * _rms(own) for own, other in pairs)


def _rms(fit: Fit) -> float:
    return max(float(np.sqrt(np.nanmean(fit.held_out**2))), EXACT * fit.joint.given)
