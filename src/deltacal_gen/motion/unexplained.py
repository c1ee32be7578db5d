"""What a ladder leaves: whether it depends on anything that was recorded, joint by joint."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy.stats import chi2

from deltacal_gen.motion.joint import Fit
from deltacal_gen.motion.ladder import PER_COEFFICIENT
from deltacal_gen.motion.library import hats
from deltacal_gen.motion.regression import Bench

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

WAVES = 8  # hats across the range of a channel
SHOWS = 0.03  # of the held-out rms: what a smooth function of a channel must take away
SMOOTH = 3.0  # times the part of the rest that changes from sample to sample: what is larger is no noise
ABOVE = 1.15  # times a declared noise: more is no noise


@dataclass(frozen=True)
class Dependence:
    """How the rest of a joint depends on a channel: held-out rms that it takes away, and what it earns in chi2."""

    channel: str
    share: float
    gain: float
    width: int

    @property
    def p_value(self) -> float:
        """Probability that noise alone earns as much."""
        return float(chi2.sf(self.gain, self.width))


@dataclass(frozen=True)
class Rest:
    """What is left of a joint.

    Attributes
    ----------
    channel : str
        What it depends on most; "" where nothing that was recorded tells.
    share : float
        Part of the held-out rms that a smooth function of it takes away.
    text : str
    """

    joint: int
    channel: str
    share: float
    text: str


WORDS = {
    "speed": "its speed",
    "angle": "its position",
    "load": "the torque that the rigid machine asks of it",
    "acceleration": "its acceleration",
    "time": "the time",
    "temperature": "the temperature",
    "direction": "its position, differently in both directions",
    "reversal": "how far it has moved since it last turned back",
}


def channels(fit: Fit) -> dict[str, tuple[Array, Array]]:
    """Return what the rest of a joint may depend on (M,), and by what that is weighted."""
    states, one = fit.joint.states, np.ones(len(fit.left))
    way = np.sign(states["qd"])
    found = {
        "speed": (states["qd"], one),
        "angle": (states["q"], one),
        "load": (fit.load, one),
        "acceleration": (states["qdd"], one),
        "time": (states["time"], one),
        "direction": (states["q"], way),
        "reversal": (_since_reversal(fit), way),
    }
    if "temperature" in states:
        found["temperature"] = (states["temperature"], way)
    return {name: pair for name, pair in found.items() if np.ptp(pair[0]) > 0}


def _since_reversal(fit: Fit) -> Array:
    """Return how far a joint has moved since it last turned back (M,)."""
    q, way, rows = fit.joint.states["q"], np.sign(fit.joint.states["qd"]), fit.joint.rows
    begins = np.flatnonzero((np.diff(way, prepend=0) != 0) | (np.diff(fit.joint.piece[rows], prepend=-1) != 0))
    start = np.repeat(begins, np.diff(np.append(begins, len(q))))
    return np.asarray(np.abs(q - q[start]))


def _held_out(fit: Fit) -> float:
    """Return the rms on samples that took no part, or of the fit where none were held out."""
    known = fit.held_out[np.isfinite(fit.held_out)]
    return float(np.sqrt(np.mean((known if len(known) else fit.left) ** 2)))


def _rough(fit: Fit) -> float:
    """Return the noise of single samples, by how much the rest of neighbouring ones differs."""
    rows, pieces = fit.joint.rows, fit.joint.piece[fit.joint.rows]
    beside = (np.diff(rows) == 1) & (np.diff(pieces) == 0)
    steps = np.diff(fit.left)[beside]
    return float(np.sqrt(np.mean(steps**2) / 2)) if len(steps) else float("inf")


def dependences(fit: Fit) -> list[Dependence]:
    """Return the channels that the rest of a joint depends on, beyond chance, by what they take away."""
    found = []
    before_bench = Bench.of(np.ones((len(fit.left), 1)), fit.left, fit.joint.fold, 0)
    folds = before_bench.folds
    before = before_bench.held_out([0], folds)
    count = float(sum(before_bench.n[list(folds)])) / fit.together
    for name, (values, weight) in channels(fit).items():
        X = hats(values, WAVES) * weight[:, None]
        bench = Bench.of(X, fit.left, fit.joint.fold, X.shape[1])
        every = range(X.shape[1])
        bench = bench.with_ridge(every)
        gain = count * float(np.log(before * sum(bench.n[list(folds)]) / bench.train(every, folds)))
        share = 1.0 - float(np.sqrt(bench.held_out(every, folds) / before))
        if share > 0 and gain > PER_COEFFICIENT * X.shape[1]:
            found.append(Dependence(name, share, gain, X.shape[1]))
    return sorted(found, key=lambda d: -d.share)


def rest(fit: Fit, sigma: float | None) -> Rest | None:
    """Return what the rest of a joint depends on; None where nothing shows.

    `sigma` is the noise where it is declared, in units inside.
    """
    known = dependences(fit)
    if known and (share := known[0].share) > SHOWS:
        name = known[0].channel
        text = f"what is left of joint {fit.joint.number} depends on {WORDS[name]}: {100 * share:.0f} % of its rms"
        return Rest(fit.joint.number, name, share, text)
    if (over := _held_out(fit) / max(_rough(fit), 1e-300)) > SMOOTH:
        text = f"what is left of joint {fit.joint.number} on held-out samples is {over:.3g} times what differs from one"
        return Rest(fit.joint.number, "", 0.0, f"{text} sample to the next: no noise, and of nothing recorded")
    if sigma is not None and (over := fit.sigma / sigma) > ABOVE:
        text = f"what is left of joint {fit.joint.number} is {over:.3g} times the noise and depends on nothing recorded"
        return Rest(fit.joint.number, "", 0.0, text)
    return None
