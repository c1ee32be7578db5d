"""Laws: physics that no one registered, as effects that a formula in text makes without a kernel being built.

A law is called by what it says, ``law limb.rod = c1*tanh(tension_1/c2)``: under that name it is a term like any effect.
It is fitted jointly with the geometry, kept in answers, predicted from and compensated. The constants that multiply its
summands are its coefficients; those within (thresholds, scales, orders, time constants) are constants of the term, and
so are the ends of each state where it was found. Beyond these a law goes on for half of what was seen, and by no more
than it varied there, then it stays: an exponential or a square that fits within explodes outside. A wave goes on, but
one that has not been seen to come again (two periods; one, where it has corners) goes on straight.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache

import numpy as np
from deltacal_kernels.effects.targets import TARGETS

from deltacal_gen import states
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.formula import Unit, formula, unit, written
from deltacal_gen.physics.targets import target_of
from deltacal_gen.states import State

PREFIX = "law "
EVERY = "every "  # before a target of limbs that share one coefficient: ``law every joint = c1*q**2``
ROUNDING = 1e-9  # of the width that was seen: less beyond it is none
SEEN_AT = 1000  # points of the ranges of its states at which is seen by how much a law varies there
STEP = 1e-3  # of the width that was seen: from where to its end a law is straight
BEYOND = 0.5  # of the width that was seen: how far a law goes on beyond it
LEAST, MOST = "least_", "most_"  # of a state, where the law was found
ADVICE = (
    "Nobody has registered this: it was read from the recording. Look for a part that behaves so; until then command "
    "by the states that it names."
)


class Law:
    """A law as a module of an effect: the same tables and functions; see `deltacal_gen.physics.memory` for memories.

    Parameters
    ----------
    name : str
        ``law TARGET = FORMULA``; ``law every TARGET = FORMULA`` where all limbs share its coefficients.

    Raises
    ------
    ValueError
        It is no law: the target, a name or the formula is unknown.
    """

    ADVICE, SEARCHED, SIZED, AFTERWARDS = ADVICE, dict[str, str](), dict[str, str](), dict[str, float]()
    EXTENDS = ""
    WHOLE, PERIODIC, OF_JOINT = True, False, ()

    def __init__(self, name: str) -> None:
        target, equals, text = name.removeprefix(PREFIX).partition(" = ")
        moved, self.target = target.removeprefix(EVERY), target
        unknown = moved not in TARGETS or (moved != target and TARGETS[moved] != "limb")
        if not name.startswith(PREFIX) or not equals or unknown:
            known = ", ".join(TARGETS)
            raise ValueError(f"'{name}' is no law: write '{PREFIX}TARGET = FORMULA', TARGET one of {known}.")
        self.NAME, self.formula = name, formula(text)
        self.TITLE = f"{target} {'is more' if target == 'torque' else 'moves'} by {text}"
        self.ACTS_ON = TARGETS[moved]
        self.PER_LIMB = self.ACTS_ON in ("limb", "drive") and moved == target
        self.TARGETS = (moved,)
        coefficients = self.formula.linear
        own = [n for n in self.formula.names if n not in coefficients and is_constant(n)]
        self.inner: tuple[str, ...] = tuple(own)
        self.STATE = tuple(n for n in self.formula.names if n not in coefficients and n not in own)
        self._check()
        units = self.units("rad")
        self.COEFFICIENTS = tuple((c, written(units[c]), 1.0, "of the law") for c in coefficients)
        self.BELIEVABLE = tuple((-np.inf, np.inf) for _ in coefficients)
        ends = [f"{end}{s}" for s in self.STATE for end in (LEAST, MOST)]
        self.CONSTANTS = (
            *((c, written(units[c]), 1.0, "within the law") for c in own),
            *((end, "", 1.0, "where the law was found") for end in ends),
        )
        self.PARTS = ((coefficients, self.STATE),)
        self.MEMORY = tuple((f"lag_{n}", f"{s}, lagging by {tau}") for n, (s, tau) in enumerate(self.lags, 1))

    def _check(self) -> None:
        if not self.formula.linear or not all(is_constant(c) for c in self.formula.linear):
            raise ValueError(f"'{self.NAME}': every summand begins with a coefficient of its own, c1, c2, ...")
        read = [states.named(s) for s in self.STATE]
        for s in read:
            if s.by or s.kind == "reading":
                raise ValueError(f"'{self.NAME}': no law is made of {s.name}.")
            own = s.per in ("joint", "limb") and not s.joint
            if own and self.ACTS_ON not in ("limb", "drive"):
                raise ValueError(f"'{self.NAME}': every limb has a {s.name} of its own; {s.name}_1 is that of joint 1.")
            if self.ACTS_ON == "reading" and (s.kind == "load" or s.of_geometry):
                raise ValueError(f"'{self.NAME}': a reading does not depend on {s.name} but through the pose.")
        if self.formula.lags and self.ACTS_ON == "reading":
            raise ValueError(f"'{self.NAME}': a reading has no memory.")

    @property
    def lags(self) -> tuple[tuple[str, str], ...]:
        """State and time constant of every Lag."""
        return self.formula.lags

    def units(self, joint_unit: str, read: str = "") -> dict[str, Unit]:
        """Return the unit inside of every constant, where joints are in `joint_unit` (rad or mm).

        `read` is that of the target, and of a torque that is a state, where it is not what these themselves have: a
        torque that is read as a current.
        """
        known = {s: unit(inside(states.named(s), joint_unit, read)) for s in self.STATE}
        return self.formula.units(known, unit(read or self.unit_moved(joint_unit)))

    def unit_moved(self, joint_unit: str) -> str:
        """Return the unit inside of what is moved, where joints are in `joint_unit` (rad or mm)."""
        torque = "N" if joint_unit == "mm" else "N mm"
        of = {"joint": joint_unit, "torque": torque, "turn": "rad"}
        return of.get(target_of(self.TARGETS[0]).sort, "mm")

    def value(self, s: Array, c: Array, constants: Sequence[float | str] = ()) -> Array:
        """Return by how much the target is moved, (M, 1); s are states, then what is lagged."""
        if self._outside(s, constants).any():
            moved: Array = (self.jacobian(s, c, constants)[:, 0] * c).sum(axis=1)[:, None]
            return moved
        known = self._known(s, constants)
        return self._moved(len(s), known | dict(zip(self.formula.linear, c.T, strict=True)))

    def jacobian(self, s: Array, c: Array, constants: Sequence[float | str] = ()) -> Array:
        """Return the derivatives of `value` by the coefficients, (M, 1, n_c)."""
        out = self._functions(len(s), self._known(s, constants))
        if (outside := self._outside(s, constants).any(axis=1)).any():
            own = s[outside].copy()
            near = self._functions(len(own), self._known(np.clip(own, *self._box(own, constants).T), constants))
            varies = self._varies(constants)
            out[outside] = np.clip(self._straight(own, constants), near - varies, near + varies)
        return out[:, None]

    def _straight(self, s: Array, constants: Sequence[float | str], first: int = 0) -> Array:
        """Return what stands beside each coefficient (n, n_c), straight on beyond the ends of what seems to recur.

        States before the `first` are as they are.
        """
        turning = [k for k in range(first, len(self.STATE)) if not self._goes_on(self.STATE[k], constants)]
        if not turning:
            return self._functions(len(s), self._known(s, constants))
        k, (low, high) = turning[0], self.ends(constants)[turning[0]]
        at, step = s.copy(), STEP * (high - low)
        at[:, k] = np.clip(s[:, k], low, high)
        beyond = self.held(s, constants)[:, k] - at[:, k]
        end = self._straight(at, constants, k + 1)
        if not beyond.any():
            return end
        at[:, k] -= np.sign(beyond) * step
        return end + np.abs(beyond / step)[:, None] * (end - self._straight(at, constants, k + 1))

    def _goes_on(self, state: str, constants: Sequence[float | str]) -> bool:
        """Tell whether all waves of a state that it has were seen to recur."""
        k = self.STATE.index(state)
        low, high = self.ends(constants)[k]
        values = dict(zip(self.inner, map(float, constants), strict=False))
        known = values | dict.fromkeys(self.STATE, 0.0)
        return not np.isfinite(high - low) or self.formula.recurs(state, float(low), float(high), known)

    def _recurs(self, constants: Sequence[float | str]) -> list[bool]:
        """Return which states only waves ask for that were seen to recur: wherever they go, nothing new comes."""
        return [s in self.formula.recurring and self._goes_on(s, constants) for s in self.STATE]

    def _functions(self, n: int, known: dict[str, Array | float]) -> Array:
        """Return what stands beside each coefficient, (n, n_c)."""
        names = self.formula.linear
        return np.hstack([self._moved(n, known | {k: float(k == one) for k in names}) for one in names])

    def _varies(self, constants: Sequence[float | str]) -> Array:
        """Return by how much what stands beside each coefficient varies where the law was found, (n_c,)."""
        count = max(int(SEEN_AT ** (1 / len(self.STATE))), 3)
        each = np.meshgrid(*(np.linspace(low, high, count) for low, high in self.ends(constants)))
        at = np.stack([values.ravel() for values in each], axis=1)
        lagged = [self.STATE.index(state) for state, _ in self.lags]
        return np.ptp(self._functions(len(at), self._known(np.hstack([at, at[:, lagged]]), constants)), axis=0)

    def _moved(self, n: int, known: dict[str, Array | float]) -> Array:
        return np.nan_to_num(np.broadcast_to(self.formula(known), n))[:, None]

    def _known(self, s: Array, constants: Sequence[float | str]) -> dict[str, Array | float]:
        """Return states, within their ends, and constants by name; what is lagged by its text."""
        values = dict(zip(self.inner, map(float, constants), strict=False))
        known: dict[str, Array | float] = {**values}
        known |= zip(self.STATE, self.held(s, constants).T, strict=True)
        texts = [f"Lag({state}, {tau})" for state, tau in self.lags]
        return known | dict(zip(texts, s[:, len(self.STATE) :].T, strict=True))

    def held(self, s: Array, constants: Sequence[float | str]) -> Array:
        """Return states (M, n_s) as the law takes them, no farther beyond where it was found than it goes on."""
        low, high = self.ends(constants).T
        beyond = np.where(self._recurs(constants), np.inf, BEYOND * (high - low))
        return np.clip(s[:, : len(self.STATE)], low - beyond, high + beyond)

    def _box(self, s: Array, constants: Sequence[float | str]) -> Array:
        """Return the ends (n_s + m, 2) that count: none of what recurs, those of its state of what is lagged."""
        ends = np.where(np.array(self._recurs(constants))[:, None], [-np.inf, np.inf], self.ends(constants))
        return np.vstack([ends, *(ends[None, self.STATE.index(state)] for state, _ in self.lags)])[: s.shape[1]]

    def _outside(self, s: Array, constants: Sequence[float | str]) -> np.ndarray:
        """Return which states, and what is lagged, (M, n_s + m) lie beyond the ends that count."""
        if not self.STATE:
            return np.zeros(s.shape, dtype=bool)
        low, high = self._box(s, constants).T
        return np.asarray((s < low) | (s > high))

    def beyond(self, s: Array, constants: Sequence[float | str]) -> np.ndarray:
        """Return which states (M, n_s) lie beyond the ends of where the law was found."""
        low, high = self.ends(constants).T
        with np.errstate(invalid="ignore"):  # no ends, no width
            width = np.nan_to_num(ROUNDING * (high - low))
        return np.asarray((s < low - width) | (s > high + width))

    def ends(self, constants: Sequence[float | str]) -> Array:
        """Return between which values (n_s, 2) each state was where the law was found; infinite, where nothing says."""
        given = [float(v) for v in constants[len(self.inner) :]]
        none = [-np.inf, np.inf] * len(self.STATE)
        return np.reshape(given or none, (len(self.STATE), 2))

    def taus(self, constants: Sequence[float | str]) -> Array:
        """Return the time constants [s] of all that is lagged."""
        known = dict(zip(self.inner, map(float, constants), strict=False))
        return np.array([known[tau] if tau in known else float(tau) for _, tau in self.lags])

    def start(self, s: Array, c: Array, constants: Sequence[float | str] = ()) -> Array:
        """Return what is lagged at the first row of a run, (M, m): the state there."""
        own = [self.STATE.index(state) for state, _ in self.lags]
        return self.held(s, constants)[:, own]

    def step(self, z: Array, s: Array, to: Array, h: Array, c: Array, constants: Sequence[float | str] = ()) -> Array:
        """Return what is lagged after an interval in which states go straight, (M, m, 2 + n_c), and its derivatives."""
        begin, end, tau = self.start(s, c, constants), self.start(to, c, constants), self.taus(constants)
        out = np.zeros((len(s), len(self.lags), 2 + len(self.COEFFICIENTS)))
        out[..., 0], out[..., 1] = followed(z, begin, end, h[:, None], tau)
        return out

    def by_memory(self, s: Array, c: Array, constants: Sequence[float | str] = ()) -> Array:
        """Return the derivatives of `value` by what is lagged, (M, 1, m): none of them moves what coefficients do."""
        return np.zeros((len(s), 1, len(self.lags)))


def followed(z: Array, begin: Array, end: Array, h: Array, tau: Array) -> tuple[Array, Array]:
    """Return what follows a state with a time constant after a time h, and its derivative by what it was before.

    The state goes straight from `begin` to `end`: the solution is exact.
    """
    left = np.exp(-h / tau)
    still = np.where(h > 0, -np.expm1(-h / tau) * tau / np.where(h > 0, h, 1.0), 1.0)
    return end + (z - begin) * left - (end - begin) * still, np.broadcast_to(left, z.shape)


def is_constant(name: str) -> bool:
    """Tell whether a name of a formula is a constant: c and a number."""
    return name[:1] == "c" and name[1:].isdecimal()


def inside(state: State, joint_unit: str, read: str = "") -> str:
    """Return the unit inside of a state; of a joint in `joint_unit`. What a covariate counts is its own unit.

    `read` is that of its torque, where this is read as something else.
    """
    if state.unit == "as recorded":
        return state.name
    own = state.unit.replace("deg", joint_unit) if state.unit != "degC" else state.unit
    if state.per != "joint" or "N mm" not in own:
        return own
    return own.replace("N mm", read or ("N" if joint_unit == "mm" else "N mm"))


def is_law(effect: str) -> bool:
    """Tell whether the name of an effect is that of a law."""
    return effect.startswith(PREFIX)


@cache
def load_law(name: str) -> Law:
    """Return a law by its name.

    Raises
    ------
    ValueError
        It is no law.
    """
    return Law(name)
