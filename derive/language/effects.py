"""What an effect *is*: physics that a rigid nominal machine leaves out, with what is fitted, searched and remembered.

Nothing here computes; the constructors only refuse what cannot be meant.
"""

from __future__ import annotations

import keyword
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import sympy as sp

from derive.language import vocabulary
from derive.language.memory import Memory, with_lags
from derive.language.states import STATES, TAKEN, State, read_by
from derive.language.targets import acts_on

LONG_AGO = -1e12  # s, or rows: before any recording, and a number that a file can hold
OF_LIMBS = ("limb", "drive")  # what every limb has of its own
OF_TRUTHS = ("name", "limb", "limbs", "tool", "tools")  # keys of an effect's table in a truth that are no parameters
HELD = 1e-9  # part of a displacement by which one that was computed by hand may differ: it is written in decimals


@dataclass(frozen=True)
class EffectQuantity:
    """A coefficient or constant of an effect; `factor` leads from the files' unit to mm, rad, N, s and K.

    A quantity `of_joint` is in deg and Nm where the joint turns; where it slides, in mm and N. `believable` is the
    range [unit] that a machine worth measuring can have: of one sign where physics knows one only. `label` is the
    public name where a state has the symbol's.
    """

    symbol: sp.Symbol
    unit: str
    factor: float
    meaning: str
    believable: tuple[float, float] = (-math.inf, math.inf)
    of_joint: bool = False
    label: str = ""

    @property
    def name(self) -> str:
        """Public name: in tables, reports and results."""
        return self.label or str(self.symbol)


@dataclass(frozen=True)
class Orders:
    """The constant is the number of periods per turn: integers and multiples of the gear ratio.

    A machine may have the effect at several orders at once.
    """

    constant: EffectQuantity
    afterwards: float | None = None
    kind = "orders"


@dataclass(frozen=True)
class Moments:
    """The constant is a moment of the recording, which is past `afterwards`: when others are read, or commanded."""

    constant: EffectQuantity
    afterwards: float | None = LONG_AGO
    kind = "moments"


@dataclass(frozen=True)
class Points:
    """Which of the measured points of the platform have the effect, each with coefficients of its own."""

    constant: None = None
    afterwards: None = None
    kind = "points"


@dataclass(frozen=True)
class Joints:
    """The constant is the number of a joint, from 1: that of the state `q_other`."""

    constant: EffectQuantity
    afterwards = None
    kind = "joints"


@dataclass(frozen=True)
class Columns:
    """The constant is the name of a recorded column that is no other state: that of the state `recorded`."""

    constant: EffectQuantity
    afterwards = None
    kind = "columns"


@dataclass(frozen=True)
class Clocks:
    """The constant is the name of the column that counts on, `time_s` or what stands for it: of the state `passed`."""

    constant: EffectQuantity
    afterwards = None
    kind = "clocks"


@dataclass(frozen=True)
class Sizes:
    """The constant is a size of a state, `of`: it is sought from small to large ones of that, and between them."""

    constant: EffectQuantity
    of: str
    afterwards = None
    kind = "sizes"


@dataclass(frozen=True)
class Travels:
    """The constant is a way of the joint: sought from what it passes between two rows to a part of all it passes."""

    constant: EffectQuantity
    afterwards = None
    kind = "travels"


Searched = Orders | Moments | Points | Joints | Columns | Clocks | Sizes | Travels
IN_POSES: tuple[type[Searched], ...] = (Orders, Moments, Joints, Columns, Clocks, Sizes)  # constants, in readings
IN_MOTION: tuple[type[Searched], ...] = (Orders, Sizes, Travels)  # constants of drives, in torques along a motion
SEARCHED = {"drive": IN_MOTION, "point": (*IN_POSES, Points)}  # by what is moved; in all else `IN_POSES`


@dataclass(frozen=True)
class Reference:
    """A displacement that was computed by hand, against which the derived functions are held.

    Parameters
    ----------
    state, coefficients, constants : mapping
        By name, in the units of the tables; memories among the states, as the formulas have them.
    moved : mapping
        By target, in mm or rad; a torque in N mm.
    """

    state: Mapping[str, float]
    coefficients: Mapping[str, float]
    moved: Mapping[str, float]
    constants: Mapping[str, float | str] = field(default_factory=dict)


@dataclass(frozen=True)
class Effect:
    """Physics that a rigid nominal machine leaves out, as a deformation of what a machine already has.

    An effect knows no mechanism: it reads *states* (``derive.language.states``: joints, channels, loads from virtual
    work) and moves *targets* (``derive.language.targets``); the chain rule ties both to a machine's derivatives.

    Parameters
    ----------
    name, title : str
        Name in files, and what it is in plain words.
    advice : str
        What someone who maintains the machine does about it.
    per_limb : bool
        Whether every limb has its own coefficients.
    coefficients : tuple of EffectQuantity
        What is fitted; all zero means that nothing is left out.
    targets : mapping
        What is moved, each to its expression [mm or rad; of a torque N mm or N].
    tests : tuple of Reference
        Displacements computed by hand.
    searched : tuple of Searched
        What is searched, not fitted; at most one of each, of drives at most one at all.
    whole : bool
        Whether it is one only where a machine has all that it moves. Else it is what the parts that are there make of
        it, with the coefficients that stand in them.
    memory : tuple of Memory
        States that follow from what happened before. A `Lag` in the targets becomes one.
    extends : Effect, optional
        What it becomes where the size that is searched grows without bound, or where all limbs are alike: that is named
        unless readings refuse it.

    Raises
    ------
    ValueError
        A formula holds what some target could not write (``derive.language.vocabulary``), reads what is no state, or
        does not vanish with the coefficients; that of a drive is not linear in them; something is missing, said twice,
        or searched where nothing searches it.
    """

    name: str
    title: str
    source: str
    advice: str
    per_limb: bool
    coefficients: tuple[EffectQuantity, ...]
    targets: Mapping[str, sp.Expr]
    tests: tuple[Reference, ...]
    searched: tuple[Searched, ...] = ()
    memory: tuple[Memory, ...] = ()
    whole: bool = False
    extends: Effect | None = None

    def __post_init__(self) -> None:
        targets, memory = with_lags(self.targets, self.memory)
        object.__setattr__(self, "targets", targets)
        object.__setattr__(self, "memory", memory)
        try:
            self._check()
        except ValueError as error:
            raise ValueError(f"effect {self.name}: {error}") from None

    @property
    def constants(self) -> tuple[EffectQuantity, ...]:
        """Numbers that are searched: the order of a harmonic, the time of a jump."""
        return tuple(s.constant for s in self.searched if s.constant is not None)

    @property
    def afterwards(self) -> dict[str, float]:
        """What constants are after the recording they were found in, where that is known."""
        return {s.constant.name: s.afterwards for s in self.searched if s.constant and s.afterwards is not None}

    @property
    def sized(self) -> dict[str, str]:
        """Of what state a constant that is searched by size is one."""
        return {s.constant.name: s.of for s in self.searched if isinstance(s, Sizes)}

    @property
    def acts_on(self) -> str:
        """What is moved: ``limb, drive, base, point`` or ``reading``."""
        return acts_on(self.targets)

    @property
    def states(self) -> list[State]:
        """What is read, in the order of the derived functions' input."""
        own = [q.symbol for q in (*self.coefficients, *self.constants)] + [m.symbol for m in self.memory]
        return read_by([*self.targets.values(), *(e for m in self.memory for e in (m.rate, m.start))], own)

    @property
    def parts(self) -> list[tuple[tuple[str, ...], tuple[str, ...]]]:
        """What stands in each target: names of coefficients, and of states."""
        own = [(c.name, c.symbol) for c in self.coefficients]
        read = [(s.name, s.symbol) for s in self.states]
        found = [e.free_symbols for e in self.targets.values()]
        return [(tuple(n for n, s in own if s in e), tuple(n for n, s in read if s in e)) for e in found]

    @property
    def periodic(self) -> bool:
        """Whether it is a wave of the joint's turn, cosine and sine: all orders together are any periodic function."""
        orders = [s.constant.symbol for s in self.searched if isinstance(s, Orders)]
        if len(orders) != 1 or len(self.coefficients) != 2:
            return False
        angle, (cos, sin) = orders[0] * STATES["turn"].symbol, (c.symbol for c in self.coefficients)
        return dict(self.targets) == {"joint": cos * sp.cos(angle) + sin * sp.sin(angle)}

    def _check_memory(self) -> None:
        """Refuse rates and starts that cannot be meant."""
        own, varied = {m.symbol for m in self.memory}, {c.symbol for c in self.coefficients}
        if self.memory and self.acts_on == "reading":
            raise ValueError("a reading has no memory: readings are no rows of a run. Let it act on the machine.")
        for m in self.memory:
            vocabulary.check(f"memory {m.name}", m.rate)
            vocabulary.check(f"start of {m.name}", m.start)
            if m.rate.free_symbols & own - {m.symbol}:
                raise ValueError(f"the rate of {m.name} reads another memory.")
            if m.start.free_symbols & (own | varied):
                raise ValueError(f"{m.name} starts from states and constants only.")
            if m.rate.subs(dict.fromkeys(varied, 0)).has(sp.zoo, sp.nan):
                raise ValueError(
                    f"the rate of {m.name} has no value where all coefficients are zero: a fit begins there. Search "
                    "what it is divided by, as a constant."
                )

    def _check(self) -> None:
        """Refuse what cannot be meant."""
        if not self.advice.endswith("."):
            raise ValueError(
                "say in `advice`, in whole sentences, what someone who maintains the machine does about it."
            )
        for target, e in self.targets.items():
            vocabulary.check(target, e)
        self._check_memory()
        self._check_words()
        states, named = self.states, [q.symbol for q in (*self.coefficients, *self.constants)]
        if twice := {str(s) for s in named if named.count(s) > 1}:
            raise ValueError(f"{', '.join(sorted(twice))} is declared twice.")
        for target, e in self.targets.items():
            if e.subs({c.symbol: 0 for c in self.coefficients}) != 0:
                raise ValueError(f"{target} does not vanish where all coefficients are zero.")
        for c in self.coefficients:
            low, high = c.believable
            if not low <= 0.0 <= high or low == high or math.isinf(high - low):
                raise ValueError(f"the believable range of {c.name} is {c.believable}; it holds 0 and has two ends.")
        if wrong := [of for of in self.sized.values() if of not in (s.name for s in self.states)]:
            raise ValueError(f"a constant is searched as a size of {wrong[0]}, which is not read.")
        self._check_searched()
        self._check_used(states)
        if self.per_limb and self.acts_on not in OF_LIMBS:
            raise ValueError(f"it acts on the {self.acts_on}, of which there is one: no limb has its own coefficients.")
        self._check_extended()
        for s in states:
            self._check_state(s)
        self._check_tests([*(s.name for s in states), *(m.name for m in self.memory)])
        for test in self.tests:
            self._check_held(test, states)

    def _check_words(self) -> None:
        """Refuse names that files and generated functions cannot hold, and what is not said in words."""
        if not self.title:
            raise ValueError("say in `title`, in plain words, what it is.")
        for q in (*self.coefficients, *self.constants):
            if not q.meaning:
                raise ValueError(f"{q.name} has no meaning; add one line.")
            for name in (q.name, str(q.symbol)):
                if not name.isidentifier() or keyword.iskeyword(name) or TAKEN.fullmatch(name) or name in OF_TRUTHS:
                    raise ValueError(f"a parameter cannot be called '{name}': choose another word of letters and _.")

    def _check_used(self, states: Sequence[State]) -> None:
        """Refuse a parameter of which nothing depends: no reading would tell its size."""
        formulas = (*self.targets.values(), *(e for m in self.memory for e in (m.rate, m.start)))
        used, deciding = set().union(*(e.free_symbols for e in formulas)), {s.by for s in states}
        every = (*self.coefficients, *self.constants)
        if idle := [q.name for q in every if q.symbol not in used and q.name not in deciding]:
            raise ValueError(f"{', '.join(idle)} stands in no formula: no reading would tell its size.")

    def _check_searched(self) -> None:
        """Refuse what nothing searches or fits; a regression on the torque takes one constant, and is linear."""
        known = SEARCHED.get(self.acts_on, IN_POSES)
        for s in self.searched:
            if not isinstance(s, known):
                names = ", ".join(way.__name__ for way in known)
                raise ValueError(f"what acts on the {self.acts_on} is not searched by {type(s).__name__}; by {names}.")
        if len({s.kind for s in self.searched}) < len(self.searched):
            raise ValueError("it is searched twice in the same way.")
        if self.acts_on != "drive":
            return
        if len(self.searched) > 1:
            raise ValueError("an effect of a drive has one constant that is searched; hold the other in the formula.")
        varied = {c.symbol for c in self.coefficients}
        slopes = [e.diff(c) for e in self.targets.values() for c in varied]
        if any(e.free_symbols & varied for e in (*slopes, *(m.rate for m in self.memory))):
            raise ValueError("an effect of a drive is linear in its coefficients; search the others as constants.")

    def _check_extended(self) -> None:
        """Refuse to extend what the effect does not become."""
        if self.extends is None:
            return
        sizes = {s.constant.symbol for s in self.searched if isinstance(s, Sizes)}
        becomes = bool(sizes) or (self.per_limb and not self.extends.per_limb)
        without = {size: sp.Dummy(positive=True) for size in sizes}
        for target in self.targets.keys() | self.extends.targets.keys():
            e = self.targets.get(target, sp.Integer(0)).subs(without)
            for size in without.values():
                e = sp.limit(e, size, sp.oo)
            if not becomes or sp.simplify(e - self.extends.targets.get(target, 0)) != 0:
                where = "its size is large" if sizes or not becomes else "all limbs are alike"
                raise ValueError(f"it does not become {self.extends.name} where {where}: {target} is {e}.")

    def _check_state(self, s: State) -> None:
        if s.kind == "reading" and self.acts_on != "reading":
            raise ValueError(f"{s.name} is what the instrument reads: the machine does not depend on it.")
        own = s.per in ("joint", "limb") and s.kind != "geometry" and s.name in STATES
        if own and self.acts_on not in OF_LIMBS:
            hint = f": {s.name}_1 is that of joint 1" if s.per == "joint" else ""
            raise ValueError(f"every limb has a {s.name} of its own, and it acts on the {self.acts_on}{hint}.")
        if self.acts_on == "reading" and (s.kind == "load" or s.name.startswith("theta")):
            raise ValueError(f"a reading does not depend on {s.name} but through the pose: move the machine by it.")
        if s.by and s.by not in [c.name for c in self.constants]:
            raise ValueError(f"{s.name} is decided by a constant '{s.by}'; search it.")

    def _check_tests(self, states: Sequence[str]) -> None:
        if not self.tests:
            raise ValueError("add a displacement that you computed by hand to `tests`.")
        for test in self.tests:
            for what, given, wanted in (
                ("states", test.state, states),
                ("coefficients", test.coefficients, [c.name for c in self.coefficients]),
                ("constants", test.constants, [c.name for c in self.constants]),
                ("targets", test.moved, list(self.targets)),
            ):
                if set(given) != set(wanted):
                    raise ValueError(f"a test gives the {what} {sorted(given)}, and it has {sorted(wanted)}.")
            for c in self.coefficients:
                low, high = c.believable
                if not low <= test.coefficients[c.name] <= high:
                    raise ValueError(f"a test has {c.name} = {test.coefficients[c.name]}, beyond what is believable.")

    def _check_held(self, test: Reference, states: Sequence[State]) -> None:
        """Refuse a displacement that is not what the formula gives: a factor, a sign or a unit is wrong in either."""
        known: dict[sp.Symbol, float] = {s.symbol: test.state[s.name] * s.factor for s in states}
        known |= {m.symbol: test.state[m.name] for m in self.memory}
        known |= {c.symbol: test.coefficients[c.name] * c.factor for c in self.coefficients}
        given = {c: test.constants[c.name] for c in self.constants}
        known |= {c.symbol: v * c.factor for c, v in given.items() if not isinstance(v, str)}
        for target, e in self.targets.items():
            value, wanted = sp.N(e.subs(known)), test.moved[target]
            found = float(value) if value.is_finite else math.nan
            if not math.isclose(found, wanted, rel_tol=HELD, abs_tol=HELD * HELD):
                unit = "N mm or N" if target == "torque" else "mm or rad"
                raise ValueError(
                    f"a test says that {target} moves by {wanted:.9g}, and the formula gives {found:.9g} [{unit}]: "
                    "look at the formula's sign, at the factors of the coefficients and at units."
                )
