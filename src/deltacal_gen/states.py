"""What the states that effects read are: the one reader of the table that ``derive/language/states.py`` declares.

A state by name is a joint's own, another joint's (``torque_2``), or a covariate: a column of a recording that has no
other meaning.
"""

from __future__ import annotations

import dataclasses
import math
import re
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache, cached_property
from typing import Any

from deltacal_kernels.effects.states import COVARIATE
from deltacal_kernels.effects.states import STATES as _ROWS

from deltacal_gen.units import joint_names

_OTHER = re.compile(r"(\w+)_([1-9]\d*)")


@dataclass(frozen=True)
class State:
    """A state as an effect reads it.

    Attributes
    ----------
    name, base : str
        Its name, and that of its row of the table: ``torque`` of ``torque_2``.
    joint : int
        Whose joint's it is, from 1; 0: of the limb that has the effect, or of the machine.

    The others are columns of the table, see ``derive.language.states.State``.
    """

    name: str
    base: str
    unit: str
    factor: float
    meaning: str
    per: str
    kind: str
    joint: int = 0
    column: str = ""
    parts: str = ""
    zero: float = 0.0
    default: float = 0.0
    assumed: str = ""
    optional: bool = False
    whole: bool = False
    made_of: tuple[str, ...] = ()
    shown: str = ""
    differing: str = ""
    by: str = ""
    requires: str = ""
    c99: str = ""
    c99_drive: str = ""
    tabled: tuple[str, float] | None = None
    called: str = ""
    its: str = ""
    levels: tuple[float, ...] = ()
    possible: tuple[float | None, float | None] | None = None
    expected: str = ""
    weighs: bool = False
    commanded: bool = False
    passes: bool = False
    rests: bool = False
    step: float = 0.0
    law: int = 0
    others: bool = False
    drive_law: int = 0
    varied: str = ""
    needed: str = ""
    along: str = ""
    rods: bool = False

    @property
    def follows(self) -> bool:
        """Whether it changes with the pose, and so with what effects move."""
        return self.kind in ("load", "place")

    @property
    def of_geometry(self) -> bool:
        """Whether it is a joint as the geometry sees it, which readings of the joints themselves do not show."""
        return self.kind == "place" and self.per == "joint"

    @property
    def ends(self) -> tuple[float, float]:
        """Between which values its column must lie."""
        low, high = self.possible or (None, None)
        return -math.inf if low is None else low, math.inf if high is None else high

    @cached_property
    def pattern(self) -> re.Pattern[str]:
        """The names of columns that hold it: a joint's with its number and the rest of its unit as groups."""
        own = re.escape(self.column).replace(re.escape("{i}"), r"(\d+)")
        before, of_unit, _ = own.partition(re.escape("{unit}"))
        return re.compile(before + r"(\w+)" if of_unit else own)

    def part(self, column: str) -> bool:
        """Whether a column holds it of a part, where a recording has these instead of its own column."""
        parts = re.escape(self.parts).replace(re.escape("{part}"), r"\w+")
        return bool(parts) and re.fullmatch(parts, column) is not None

    def holds(self, column: str) -> bool:
        """Whether a column holds it, as a whole or of a part."""
        return bool(self.column) and (self.pattern.fullmatch(column) is not None or self.part(column))

    @property
    def channels(self) -> tuple[State, ...]:
        """The recorded channels that it is read from, or computed from."""
        if self.kind == "channel":
            return (self,)
        made_of = map(named, self.made_of)
        return tuple(c.of_joint(self.joint) if self.joint and c.per == "joint" else c for c in made_of)

    @property
    def needs(self) -> tuple[State, ...]:
        """The recorded channels that it cannot be had without: a load has no payload where none is written."""
        return tuple(c for c in self.channels if not c.optional or self.kind == "channel")

    def chosen(self, constant: float | str) -> State:
        """Return the state that a constant decides on: a column, another joint's reading, or itself."""
        if self.kind != "chosen":
            return self
        if not isinstance(constant, str):
            return named(f"q_{int(constant)}")
        return next((s for s in CHANNELS if s.column == constant), named(constant))

    def of_joint(self, joint: int) -> State:
        """Return another joint's."""
        return dataclasses.replace(self, name=f"{self.base}_{joint}", joint=joint)

    def columns(self, joint_unit: str, joints: int) -> list[str]:
        """Return the columns of a recording that it is read from itself, joint by joint."""
        return self._places(self.column, joint_unit, joints, range(1, joints + 1))

    def shown_in(self, joint_unit: str, joints: int, limbs: Iterable[int]) -> list[str]:
        """Return where a misfit by it shows, at these limbs (from 1): columns, or ``position``."""
        return self._places(self.shown, joint_unit, joints, limbs)

    def _places(self, pattern: str, joint_unit: str, joints: int, limbs: Iterable[int]) -> list[str]:
        every = joint_names(joint_unit, joints, pattern) if pattern else []
        own = (self.joint,) if self.joint else limbs
        return list(dict.fromkeys(every[i - 1] for i in own)) if every else []


STATES: dict[str, State] = {name: State(name=name, base=name, **row) for name, row in _ROWS.items()}
CHANNELS = tuple(s for s in STATES.values() if s.kind == "channel" and not s.by)  # what a recording may say
RECORDED = tuple({s.column: s for s in CHANNELS[::-1]}.values())[::-1]  # the same, one for each column
JOINTS, SPEEDS, ACCELERATIONS, APPROACH = (STATES[name].column for name in ("q", "qd", "qdd", "approach"))
CLOCK = {"clock_offset": "s", "clock_rate": "1"}  # what is found of an instrument's own clock, with its unit
TEMPERATURE, PAYLOAD, TIME = (STATES[name].column for name in ("temperature", "payload", "time"))


@cache
def of_column(column: str) -> State:
    """Return the state whose column this is, of whatever joint; a covariate, of any other column."""
    return next((s for s in (STATES["q"], *RECORDED) if s.pattern.fullmatch(column)), None) or _covariate(column)


@cache
def named(name: str) -> State:
    """Return a state by name: of the table, another joint's, or a covariate."""
    if name in STATES:
        return STATES[name]
    other = _OTHER.fullmatch(name)
    if other is not None and other[1] in STATES and STATES[other[1]].per == "joint":
        return STATES[other[1]].of_joint(int(other[2]))
    return _covariate(name)


def _covariate(column: str) -> State:
    own: dict[str, Any] = {
        field: v.replace("{column}", column) if isinstance(v, str) else v for field, v in COVARIATE.items()
    }
    return State(name=column, base=column, **own)


@cache
def _all(names: tuple[str, ...]) -> tuple[State, ...]:
    return tuple(map(named, names))


def read_by(kernels: Any) -> tuple[State, ...]:
    """Return the states that an effect reads, in the order of its kernels' input."""
    return _all(kernels.STATE)


def columns(found: Iterable[State], joint_unit: str, joints: int) -> list[str]:
    """Return the columns of a recording that states are made of, beside the joints."""
    return list(dict.fromkeys(name for s in found for c in s.channels for name in c.columns(joint_unit, joints)))
