"""What a law may look like: functions of one state, products of two, from simple to complex, each with its price.

A *form* is a target and the functions that its coefficients multiply. Constants within a function (thresholds, scales,
orders, time constants) stand in its text as ``{0}``, ``{1}`` and are numbers of the form: they are tried on a grid and
then sought between its steps.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from deltacal_gen.machine.registry import Array
from deltacal_gen.states import STATES

LEVELS = 2  # distinct values up to which a state is a switch: every function of it is a straight line
THRESHOLDS = (0.15, 0.3, 0.4, 0.5, 0.6, 0.7, 0.85)  # quantiles of a state at which something may begin
SCALES = (0.1, 0.2, 0.4, 0.8, 1.6)  # of the largest value of a state: scales of what saturates or dies away
LAGS = 8  # time constants, from the time between rows to half of the session
PERIODS = 36  # of a state: from its whole width to four rows
PHASES = tuple(np.arange(8) / 8)  # of a period, at which what is no wave may begin
NEAR_ZERO = 0.1  # of a state's width: what begins farther from nought does not pass it
# what comes once: a step in it, or a bump, is an event and no law
ONCE = tuple(s.name for s in STATES.values() if s.passes)
CONSTANT = re.compile(r"\{(\d+)\}")
LAG = "Lag("  # begins what follows a state with a delay


@dataclass(frozen=True)
class Atom:
    """A function of one state: its text, its constants, and how much there is to say of it."""

    text: str
    constants: tuple[float, ...] = ()
    length: int = 1


@dataclass(frozen=True)
class Curve:
    """A function of one state: a sum, all parts but the first with a weight."""

    state: str
    atoms: tuple[Atom, ...]
    weights: tuple[float, ...] = ()

    @property
    def text(self) -> str:
        """The sum, its constants as ``{0}``: those of the first part, then each weight and those of its part."""
        text, count = self.atoms[0].text, len(self.atoms[0].constants)
        for atom in self.atoms[1:]:
            weight, count = f"{{{count}}}", count + 1
            own = renumbered(atom.text, count)
            text += f" + {weight}" if atom.text == "1" else f" + {weight}*{own}"
            count += len(atom.constants)
        return text if len(self.atoms) == 1 else f"({text})"

    @property
    def constants(self) -> tuple[float, ...]:
        """All of them, in the order of the text."""
        out = list(self.atoms[0].constants)
        for weight, atom in zip(self.weights, self.atoms[1:], strict=True):
            out += [weight, *atom.constants]
        return tuple(out)

    @property
    def length(self) -> int:
        """Parts that there are to say of it."""
        return sum(a.length for a in self.atoms) + len(self.weights)

    def with_constants(self, constants: Sequence[float]) -> Curve:
        """Return the curve with other constants."""
        left, weights, atoms = list(constants), list[float](), list[Atom]()
        for k, atom in enumerate(self.atoms):
            if k:
                weights.append(left.pop(0))
            own = tuple(left.pop(0) for _ in atom.constants)
            atoms.append(replace(atom, constants=own))
        return replace(self, atoms=tuple(atoms), weights=tuple(weights))


@dataclass(frozen=True)
class Form:
    """Functions with a coefficient each, of a target.

    Attributes
    ----------
    factors : tuple of tuple of str
        What each function is the product of, as text, constants as ``{0}``.
    constants : tuple of float
    states : tuple of str
    length : int
        Parts that there are to say of it: the price goes with it.
    curves : tuple of Curve
        Those of which it is the product; none of one with several functions.
    """

    factors: tuple[tuple[str, ...], ...]
    constants: tuple[float, ...]
    states: tuple[str, ...]
    length: int
    curves: tuple[Curve, ...] = ()

    @property
    def functions(self) -> tuple[str, ...]:
        """The functions as text."""
        return tuple("*".join(each) for each in self.factors)

    @property
    def text(self) -> str:
        """The formula, its coefficients first: ``c1*tanh(torque/c2)``."""
        n = len(self.functions)
        names = [f"c{n + k + 1}" for k in range(len(self.constants))]
        return " + ".join(f"c{k}" if f == "1" else f"c{k}*{f.format(*names)}" for k, f in enumerate(self.functions, 1))

    @property
    def lags(self) -> bool:
        """Whether a function of it follows a state with a delay, as `lagging` has it."""
        return any(LAG in function for function in self.functions)

    def with_constants(self, constants: Sequence[float] | Array) -> Form:
        """Return the form with other constants."""
        return replace(self, constants=tuple(map(float, constants)))


def single(state: str, atom: Atom) -> Form:
    """Return a form of one state."""
    return Form(((atom.text,),), atom.constants, (state,), atom.length, (Curve(state, (atom,)),))


def wave(state: str, frequency: float) -> Form:
    """Return a wave of a state, cosine and sine."""
    return Form(((f"cos({{0}}*{state})",), (f"sin({{0}}*{state})",)), (frequency,), (state,), 3)


def sines(state: str, frequency: float) -> tuple[Curve, ...]:
    """Return the parts of a wave."""
    return tuple(Curve(state, (Atom(f"{f}({{0}}*{state})", (frequency,), 2),)) for f in ("cos", "sin"))


def product(a: tuple[str, Atom], b: tuple[str, Atom]) -> Form:
    """Return a product of functions of two states."""
    moved = renumbered(b[1].text, len(a[1].constants))
    curves = Curve(a[0], (a[1],)), Curve(b[0], (b[1],))
    length = a[1].length + b[1].length + 1
    return Form(((a[1].text, moved),), a[1].constants + b[1].constants, (a[0], b[0]), length, curves)


def lagging(state: str, tau: float) -> Atom:
    """Return a state that lags by a time constant."""
    return Atom(f"{LAG}{state}, {{0}})", (tau,), 4)


def plain(state: str, values: Array) -> list[Atom]:
    """Return the simplest functions of a state (any shape of values), from which products are made at first."""
    out = [Atom(state)]
    if values.min() < 0 < values.max() and not switch(values):
        out.append(Atom(f"Abs({state})", (), 2))
    return out


def linear(state: str, values: Array) -> list[Atom]:
    """Return the factors of the simplest products: where a state's zero is far off, it counts from within its range.

    Counted from its own zero, a product of it is hardly more than the other factor alone.
    """
    out = plain(state, values)
    middle = float(np.median(values))
    if abs(middle) > values.std() and not switch(values):
        out += [Atom(f"({state} - {{0}})", (middle,), 2), Atom(f"Abs({state} - {{0}})", (middle,), 3)]
    return out


def simple(state: str, values: Array) -> list[Atom]:
    """Return functions that any other one is like, at first sight: a power, a threshold, a bend."""
    out = plain(state, values)
    if switch(values):
        return out
    out += [Atom(f"{state}**2", (), 2), Atom(f"sqrt(Abs({state}))", (), 2)]
    lines = np.quantile(values, (0.25, 0.5, 0.75))
    out += [Atom(f"Max({state} - {{0}}, 0)", (float(k),), 3) for k in lines]
    if state not in ONCE:
        out += [Atom(f"Heaviside({state} - {{0}})", (float(k),), 3) for k in lines]
    most = float(np.abs(values).max())
    if len(out) and values.min() < 0 < values.max():
        out += [Atom(f"tanh({state}/{{0}})", (s * most,), 3) for s in (0.1, 0.4)]
        out += [Atom(f"{state}*Abs({state})", (), 2), Atom(f"sign({state})", (), 2)]
    width = float(np.ptp(values))
    out += [Atom(f"exp({sign}{state}/{{0}})", (s * width,), 3) for sign in ("", "-") for s in (0.1, 0.4)]
    return out


def full(state: str, values: Array, lags: Sequence[float] = ()) -> list[Atom]:
    """Return every function of a state that is tried; `lags` are the time constants with which it may lag."""
    out = plain(state, values)
    late = [lagging(state, tau) for tau in lags]
    if switch(values):
        return out + late
    most, width, signed = float(np.abs(values).max()), float(np.ptp(values)), values.min() < 0 < values.max()
    out += [Atom(f"{state}**2", (), 2), Atom(f"{state}**3", (), 5)]  # few things grow so fast
    out += [Atom(f"sqrt(Abs({state}))", (), 2), *late]
    at = sorted({float(k) for k in np.quantile(values, THRESHOLDS)})
    for k in at:
        out += [Atom(f"Max({state} - {{0}}, 0)", (k,), 3)]
        if state in ONCE:
            continue
        out += [Atom(f"Heaviside({state} - {{0}})", (k,), 4)]  # between any two readings
        out += [Atom(f"tanh(({state} - {{0}})/{{1}})", (k, s * width), 5) for s in (0.05, 0.15)]
        out += [Atom(f"exp(-(({state} - {{0}})/{{1}})**2)", (k, s * width), 6) for s in (0.1, 0.25)]
        root = f"sqrt(({state} - {{0}})**2 + {{1}}**2)"  # a bend that is round
        out += [Atom(f"({sign}({state} - {{0}}) + {root})", (k, 0.15 * width), 5) for sign in ("", "-")]
        out += [Atom(root, (k, 0.15 * width), 5)]
    for s in SCALES:
        out += [Atom(f"exp({sign}{state}/{{0}})", (s * width,), 3) for sign in ("", "-")]
        out += [Atom(f"log(1 + Abs({state})/{{0}})", (s * most,), 4)]
        if values.min() < NEAR_ZERO * width:  # elsewhere it is an exponential that has no end
            out += [
                Atom(f"exp(-Abs({state})/{{0}})", (s * most,), 4),
                Atom(f"exp(-({state}/{{0}})**2)", (s * most,), 4),
            ]
        out += [Atom(f"tanh({state}/{{0}})", (s * most,), 3)]
        out += [Atom(f"{state}/({{0}} + Abs({state}))", (s * most,), 4)]
    if signed:
        out += [Atom(f"{state}*Abs({state})", (), 2), Atom(f"sign({state})", (), 2)]
        out += [Atom(f"sign({state})*sqrt(Abs({state}))", (), 3)]
        for k in np.quantile(np.abs(values), (0.15, 0.3, 0.5, 0.7)):
            out += [Atom(f"Max(Abs({state}) - {{0}}, 0)", (float(k),), 4)]
            out += [Atom(f"sign({state})*Max(Abs({state}) - {{0}}, 0)", (float(k),), 5)]
    return out


def renumbered(text: str, by: int) -> str:
    """Return a text whose constants count from another one on."""
    return CONSTANT.sub(lambda m: f"{{{int(m[1]) + by}}}", text)


def calm(atom: Atom) -> bool:
    """Tell whether a function goes on no faster than a straight line beyond where it was seen."""
    return not re.match(r"exp\(-?\w+/|.*\*\*[23]$|\w+\*Abs", atom.text)


def slow_waves(values: Array) -> list[float]:
    """Return frequencies [1 per unit of a state] of few periods over its width."""
    return [] if switch(values) else [float(2 * np.pi * k / np.ptp(values)) for k in (0.5, 1.0, 1.5, 2.0, 3.0)]


def waves(state: str, values: Array) -> list[Form]:
    """Return waves of a state, from one period over its width to as short ones as its values can show."""
    levels = len(np.unique(values))
    if levels < 8:
        return []
    most = max(levels / 4, 2.0)
    count = int(min(PERIODS, 2 * most))
    base = 2 * np.pi / float(np.ptp(values))
    return [wave(state, float(base * k)) for k in np.linspace(0.75, min(most, 0.5 * count), count)]


def periodic(state: str, frequency: float) -> list[Atom]:
    """Return periodic functions that are no sine, of about a frequency [1 per unit of the state]."""
    period, out = 2 * np.pi / frequency, []
    for p, phase in itertools.product((0.97, 1.0, 1.03), PHASES):
        at = (float(phase * period), p * period)
        rest = f"Mod({state} - {{0}}, {{1}})"
        out += [Atom(rest, at, 6), Atom(f"Abs({rest} - {{1}}/2)", at, 7), Atom(f"Heaviside({rest} - {{1}}/2)", at, 7)]
        out += [Atom(f"Abs(sin(({state} - {{0}})*{{1}}))", (float(phase * period), 0.5 * frequency / p), 6)]
        out += [Atom(f"Abs(sin(({state} - {{0}})*{{1}}))", (float(phase * period), frequency / p), 6)]
    return out


def switch(values: Array) -> bool:
    """Tell whether a state has so few values that every function of it is a straight line."""
    first = values.ravel()
    return len(np.unique(first[:: max(len(first) // 400, 1)])) <= LEVELS
