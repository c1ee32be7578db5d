"""What a ladder leaves: whether it depends on anything that was recorded, joint by joint."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from scipy.stats import chi2

from deltacal_gen.motion.fit import Fit
from deltacal_gen.motion.ladder import PER_COEFFICIENT
from deltacal_gen.motion.library import LOAD, hats
from deltacal_gen.motion.regression import EXACT, FOLDS, GAP, STRETCH
from deltacal_gen.physics.terms import remembers
from deltacal_gen.states import named

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

WAVES = 8  # hats across the range of a channel
STAGES = 4  # hats across a session, in what goes with speed as well
SHOWS = 0.03  # of the held-out rms: what a smooth function of a channel must take away
SMOOTH = 3.0  # times the part of the rest that changes from sample to sample: what is larger is no noise
APART = 0.01  # s: nearer to each other samples hang together by how the drive is controlled and read
TOO_LITTLE = "that took no part: it moved too little, or too much alike, to tell"
ABOVE = 1.15  # times a noise that is declared, or of single samples: more is no noise


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
    shown : bool
        Whether its movement would have shown what it has: otherwise a longer one may leave nothing.
    """

    joint: int
    channel: str
    share: float
    text: str
    shown: bool = True


class Seen(NamedTuple):
    """What a rest may depend on: a state or another number, whether differently in both directions, and in words."""

    of: str
    either_way: bool
    words: str


def _seen(name: str) -> Seen:
    return Seen(name, False, named(name).its)


def _seen_either_way(name: str) -> Seen:
    return Seen(name, True, f"{named(name).its}, differently in both directions")


SEEN: Mapping[str, Seen] = {  # as answers call it
    "speed": _seen("qd"),
    "angle": _seen("q"),
    "load": _seen("torque"),
    "acceleration": _seen("qdd"),
    "time": _seen("time"),
    "direction": _seen_either_way("q"),
    "friction": _seen_either_way("torque"),
    "reversal": Seen("reversal", True, "how far it has moved since it last turned back"),
    "temperature": _seen("temperature")._replace(either_way=True),
}
RUN = "run"  # no state: of the run itself
HISTORY = Seen("history", True, "the ways it came, over several reversals")


def channels(fit: Fit) -> dict[str, Array]:
    """Return smooth functions (M, k) of what the rest of a joint may depend on."""
    states, one = fit.joint.states, np.ones(len(fit.left))
    way = np.sign(states["qd"])
    every = states | {LOAD: fit.load, "reversal": _since_reversal(fit)}
    found = {n: (every[s.of], way if s.either_way else one) for n, s in SEEN.items() if s.of in every}
    smooth = {n: hats(values, WAVES) * by[:, None] for n, (values, by) in found.items() if np.ptp(values) > 0}
    smooth["speed"] = np.column_stack([smooth["speed"], way])  # what depends on the speed may jump where it turns
    # what changes as the session goes on, friction that runs in, goes with the speed and its sign as well
    session = hats(fit.joint.rows.astype(float), STAGES)
    by_time = [states["qd"] / max(float(np.std(states["qd"])), 1e-300), way]
    along = smooth.get("time", np.empty((len(one), 0)))
    smooth["time"] = np.hstack([along, *(session * by[:, None] for by in by_time)])
    history = _history(fit)
    return smooth | ({HISTORY.of: history} if history.size else {})


def _history(fit: Fit) -> Array:
    """Return what builds up over ways of many sizes (M, k): together any hysteresis that does not depend on time."""
    joint = fit.joint
    remember = [rung for rung in joint.candidates if remembers(rung.kernels)]
    states = joint.states | {LOAD: fit.load}
    return np.hstack([np.empty((len(fit.left), 0)), *(joint.of_rung(rung, states) for rung in remember)])


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


def share_left(fit: Fit) -> float:
    """Return which part of what the drive gave (rms) is left on held-out samples: above 1 nothing predicts better."""
    return _held_out(fit) / max(fit.joint.given, 1e-300)


def _apart(fit: Fit) -> int:
    """Return how many samples lie between two that are `APART` from each other; one of a slower recording."""
    return max(1, round(APART / fit.joint.step))


def _rough(fit: Fit) -> float:
    """Return the noise of single samples, by how much the rest of ones that are `APART` differs."""
    rows, pieces, apart = fit.joint.rows, fit.joint.piece[fit.joint.rows], _apart(fit)
    other = np.minimum(np.searchsorted(rows, rows + apart), len(rows) - 1)
    beside = (rows[other] - rows == apart) & (pieces[other] == pieces)
    steps = (fit.left[other] - fit.left)[beside]
    return float(np.sqrt(np.mean(steps**2) / 2)) if len(steps) else float("inf")


def dependences(fit: Fit) -> list[Dependence]:
    """Return the channels that the rest of a joint depends on, beyond chance, by what they take away.

    All that the fit has is fitted anew beside them: bodies and friction take of anything what looks like theirs, and
    what is left alone no longer looks like what it was.
    """
    joint, smooth = fit.joint, channels(fit)
    own = joint.columns(fit.rungs, fit.load)
    bench = joint.bench(np.hstack([own, *smooth.values()]))
    folds, every = bench.folds, range(own.shape[1])
    samples = float(sum(bench.n[list(folds)]))
    before, left = bench.held_out(every, folds), bench.train(every, folds)
    found, first = [], own.shape[1]
    for name, X in smooth.items():
        beside, first = [*every, *range(first, first + X.shape[1])], first + X.shape[1]
        share = 1.0 - float(np.sqrt(bench.held_out(beside, folds) / before))
        if share <= 0:
            continue
        after = bench.fit(beside, range(len(bench.n))) / bench.scale[beside]
        count = samples / joint.correlated(joint.y - np.hstack([own, X]) @ after)
        gain = count * float(np.log(left / max(bench.train(beside, folds), 1e-300)))
        if gain > PER_COEFFICIENT * X.shape[1]:
            found.append(Dependence(name, share, gain, X.shape[1]))
    return sorted(found, key=lambda d: -d.share)


def by_run(fit: Fit) -> Dependence | None:
    """Return what an offset and a part of the load that each run has of its own take away; None where it is nothing.

    Held out are whole seconds of every run: what a run has of its own no other run tells.
    """
    joint, rows = fit.joint, fit.joint.rows
    own, run = joint.columns(fit.rungs, fit.load), joint.series.run[rows]
    each = (run[:, None] == np.unique(run)).astype(float)
    if each.shape[1] < 2:
        return None
    beside = np.hstack([own, each, each * fit.load[:, None]])
    seconds = (joint.series.time[rows] // STRETCH).astype(int) % FOLDS
    bench = joint.bench(beside, seconds)
    first, every, folds = range(own.shape[1]), range(beside.shape[1]), bench.folds
    if len(folds) < FOLDS:
        return None
    share = 1.0 - float(np.sqrt(bench.held_out(every, folds) / bench.held_out(first, folds)))
    left = joint.y - beside @ (bench.fit(every, folds) / bench.scale)
    count = len(rows) / joint.correlated(left)
    gain = count * float(np.log(bench.train(first, folds) / max(bench.train(every, folds), 1e-300)))
    width = len(every) - len(first)
    return Dependence(RUN, share, gain, width) if share > SHOWS and gain > PER_COEFFICIENT * width else None


def rest(fit: Fit, sigma: float | None) -> Rest | None:
    """Return what the rest of a joint depends on; None where nothing shows.

    `sigma` is the noise where it is declared, with what the joints' own adds, in units inside.
    """
    number, share_of_all = fit.joint.number, share_left(fit)
    if share_of_all < EXACT:
        return None
    short = _too_little(fit)
    if share_of_all <= 1.0 and (known := dependences(fit)) and (share := known[0].share) > SHOWS:
        name = known[0].channel
        on = SEEN.get(name, HISTORY).words
        text = f"what is left of joint {number} depends on {on}: {100 * share:.0f} % of its rms"
        return Rest(number, name, share, text)
    if (why := short or _no_noise(fit, sigma)) is None:
        return None
    if (found := by_run(fit)) is None:
        return Rest(number, "", 0.0, why, shown=short is None)
    text = (
        f"what is left of joint {number} differs from run to run: {100 * found.share:.0f} % of its rms is an offset, or"
    )
    return Rest(number, RUN, found.share, f"{text} a part of the load, of each run's own")


def _too_little(fit: Fit) -> str | None:
    """Return by what a joint shows that it moved too little for what is found of it; None where it does not."""
    rough, found = max(_rough(fit), 1e-300), f"what is found of joint {fit.joint.number}"
    if (over := share_left(fit)) > 1.0:
        return f"{found} is off by {over:.3g} times what its drive gives on samples {TOO_LITTLE}"
    if (over := _held_out(fit) / rough) > SMOOTH and float(np.sqrt(np.mean(fit.left**2))) <= SMOOTH * rough:
        return f"{found} meets what it was fitted to, and is off by {over:.3g} times the noise on samples {TOO_LITTLE}"
    return None


def _no_noise(fit: Fit, sigma: float | None) -> str | None:
    """Return by what the rest of a joint, which depends on nothing recorded, is no noise; None where it may be."""
    if (over := _held_out(fit) / max(_rough(fit), 1e-300)) > SMOOTH:
        text = f"what is left of joint {fit.joint.number} on held-out samples is {over:.3g} times what differs within"
        return f"{text} {1000 * _apart(fit) * fit.joint.step:.3g} ms: no noise, and of nothing recorded"
    if over > ABOVE and (lasts := fit.together * fit.joint.step) > GAP:
        text = f"what is left of joint {fit.joint.number} hangs together over {lasts:.2g} s, longer than noise does"
        return f"{text}, and depends on nothing recorded"
    if sigma is not None and (over := fit.sigma / sigma) > ABOVE:
        return f"what is left of joint {fit.joint.number} is {over:.3g} times the noise and depends on nothing recorded"
    return None
