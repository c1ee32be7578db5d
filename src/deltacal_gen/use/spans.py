"""Over which channels, and which values of them, corrected commands are exported."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from deltacal_gen.machine.registry import POSE, Array
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.terms import Term, term_of
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.result import Result
from deltacal_gen.states import CHANNELS, State, named
from deltacal_gen.use.compensation import Compensator

_MARGIN = 1.05  # a stated error over the measured one
_SEED = 20151  # of the channels' random values: the same machine always gets the same statement
LEFT_OUT = "The smooth correction of the answer is not in this file"
Column = tuple[str, ...]  # channels whose product a correction goes with; () is the correction at reference


@dataclass(frozen=True)
class Spans:
    """Between which values the channels lay when the effects were found; only what was recorded is there.

    By the names of columns of corrections, in their units: warming [K over 20 degC], payload [kg], time [h]
    from when effects count it.
    """

    known: Mapping[str, tuple[float, float]] = field(default_factory=dict)

    def items(self) -> dict[str, tuple[float, float]]:
        """Return the channels that varied, by name."""
        return {name: span for name, span in self.known.items() if span[1] > span[0]}

    def in_channels(self, begun: float) -> str:
        """Return the ranges as a recording has them, which began at some time [s]: ``temp_C 18 to 25``."""
        words = []
        for name, span in self.items().items():
            channel = named(name)
            scale, since = scale_of(channel, begun)
            low, high = (f"{tidy(v * scale + since):.15g}" for v in span)
            words.append(f"{channel.column} {low} to {high}")
        return ", ".join(words) or "no channel varied"


def tidy(value: float) -> float:
    """Return a value of a channel as one would write it: a clock in ms, what is small in four digits."""
    return round(value, 3) if abs(value) >= 1 else float(f"{value:.4g}")


def scale_of(channel: State, begun: float) -> tuple[float, float]:
    """Return how many of a channel's own units its unit in corrections is, and from where these count it."""
    assert channel.tabled is not None  # corrections go with no other channel
    return channel.tabled[1], channel.zero + (begun if channel.passes else 0.0)


def tabled(states: Iterable[State]) -> list[State]:
    """Return the channels by which corrections for states go, one per recorded column."""
    read = [c for s in states if not s.by for c in s.channels]
    every = [c if c.tabled else next((o for o in CHANNELS if o.column == c.column and o.tabled), None) for c in read]
    return list(dict.fromkeys(c for c in every if c is not None))


def spans(result: Result | Diagnosis) -> Spans:
    """Return the spans of the channels that a diagnosis was made with; a result has none."""
    recorded = result.residuals.channels if isinstance(result, Diagnosis) else {}
    read = tabled(s for kept in result.physics or () for s in term_of(kept).states)
    found: dict[str, tuple[float, float]] = {}
    for s in dict.fromkeys((*tabled(CHANNELS), *read)):
        values = recorded.get(s.column, np.zeros(0))
        values = values[np.isfinite(values)]
        if len(values):
            scale, since = scale_of(s, result.begun_s)
            found[s.name] = float(values.min() - since) / scale, float(values.max() - since) / scale
    return Spans(found)


def columns_of(compensator: Compensator, terms: Sequence[Term], over: Spans) -> tuple[Column, ...]:
    """Return every product of channels that the terms may go with; a product's parts stand before it."""
    known, limbs = over.items(), compensator.mechanism.limbs
    found: set[Column] = {()}
    for term in terms:
        read = tabled(term.states)
        reads = [s.name for s in read if s.name in known]
        subsets = [c for n in range(len(reads) + 1) for c in itertools.combinations(reads, n)]
        joints: list[Column] = [()]
        for s in read:
            if s.per == "joint":
                own = (s.joint,) if s.joint else term.limbs or range(1, limbs + 1)
                joints += [(s.column.format(i=i),) for i in own]
        found |= {(*a, *s) for a in joints for s in subsets}
    return tuple(sorted(found, key=lambda c: (len(c), c)))


def channels_of(compensator: Compensator, n: int, values: Mapping[str, Array | float]) -> Channels:
    """Return channels of n rows from values by the names of columns; what is not given stays at reference."""
    columns: dict[str, Array | float] = {}
    for s in tabled((*CHANNELS, *(s for t in compensator.effects for s in t.states))):
        if s.per == "joint":
            names = s.columns(compensator.mechanism.joint_unit, compensator.mechanism.limbs)
            columns |= {name: values.get(name, 0.0) for name in names}
        else:
            scale, since = scale_of(s, compensator.begun)
            columns[s.column] = np.add(np.multiply(values.get(s.name, 0.0), scale), since)
    return compensator.channels(columns, n)[0]


def after_jumps(compensator: Compensator) -> Compensator:
    """Return the compensator for all that is commanded after the recording: jumps are past."""
    return replace(compensator, terms=tuple(t.afterwards() for t in compensator.terms))


def factor(column: Column, values: Mapping[str, Array | float]) -> Array | float:
    """Return the product of the channels of a column, (N,) or a number; 1 for the correction at reference."""
    out: Array | float = 1.0
    for name in column:
        out = out * values[name]
    return out


def drawn(compensator: Compensator, over: Spans, n: int) -> dict[str, Array]:
    """Return random values (n,) of every channel that the effects may go with, within what was recorded."""
    rng = np.random.default_rng(_SEED)
    known = over.items()
    names = sorted({c for column in columns_of(compensator, compensator.effects, over) for c in column})
    return {name: rng.choice([-1.0, 1.0], n) if name not in known else rng.uniform(*known[name], n) for name in names}


def missed(compensator: Compensator, joints: Array, points: Array, values: Mapping[str, Array | float]) -> Array:
    """Return how far commands (N, n_q) lead off points (N, 3) at values of the channels, (N,) [mm]."""
    at = channels_of(compensator, len(points), values)
    return np.asarray(np.linalg.norm(compensator.missed(joints, points, None, at), axis=1))


def taken_apart(
    compensator: Compensator, points: Array, columns: Sequence[Column], over: Spans, known: Sequence[Term], base: Array
) -> Array:
    """Return the columns (N, columns, n_q) of what exact joints differ from `base`, after `known` effects on them.

    Each product of channels is switched on by itself, at the end of its span, and what its parts explain taken off.
    Joints as the geometry counts them [rad or mm].
    """
    ends = {name: max(span, key=abs) for name, span in over.items().items()}
    settings = [{name: ends.get(name, 1.0) for name in column} for column in columns]
    found = []
    for values in settings:
        at = channels_of(compensator, len(points), values)
        q = compensator.command(points, None, at)[0] * compensator.robot.joint_sign
        found.append(q + shift(compensator, q, at, known) - base)
    weights = np.array([[factor(c, v) if set(c) <= v.keys() else 0.0 for c in columns] for v in settings])
    return np.einsum("kl,nlj->nkj", np.linalg.inv(weights), np.stack(found, axis=1))


def shift(compensator: Compensator, q: Array, at: Channels, known: Sequence[Term]) -> Array:
    """Return by how much effects of the joint alone move it, (N, n_q)."""
    if not known:
        return np.zeros_like(q)
    mechanism, robot = compensator.mechanism, compensator.robot
    body = Body(robot, mechanism, q, np.zeros((len(q), 3)), at)
    names = sorted({s.name for t in known for s in t.states if not s.by})
    state = body.state(names, np.zeros((len(q), POSE)), q, mechanism.rows(robot))  # no load, so no pose
    return np.asarray(body.moved(known, state)["joint"])


def stated(measured: float) -> float:
    """Return what is stated for a measured error: a margin above it, rounded up to two digits."""
    if measured == 0.0:
        return 0.0
    digit = 10.0 ** (math.floor(math.log10(measured * _MARGIN)) - 1)
    return float(f"{math.ceil(measured * _MARGIN / digit) * digit:.1e}")
