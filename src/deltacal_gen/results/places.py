"""Where something sits, in the words of those who stand before the machine: limbs of a Delta, joints of an arm."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import NamedTuple

MOVING = ("revolute", "prismatic")  # links that count as joints; what is fixed or coupled has no number of its own
PARTS = ("tower", "leg")  # what a limb is called, where dimensions in its robot file are: `tower_angle`, `leg_length`
NAMELESS = ("robot", "axis")  # names of machines that say no more than that it is one


def part_named(keys: Iterable[str]) -> str:
    """Return what a limb is called whose dimensions are known by some keys."""
    names = tuple(keys)
    return next((part for part in PARTS if any(key.startswith(f"{part}_") for key in names)), "limb")


class Places(NamedTuple):
    """What the limbs of a machine are called, and which they are."""

    part: str
    """What one is called: `limb`, `tower`, `leg` or `joint`."""
    tables: tuple[int, ...] = ()
    """Of an open chain: the number of each joint's table in the file, from 1."""
    axis: str = ""
    """Its name, if it is a chain of one joint alone."""

    @classmethod
    def of(cls, kinds: Sequence[str], name: str, part: str) -> Places:
        """Return the places of a chain whose links are of some kinds, or of a machine without links."""
        tables = tuple(k for k, kind in enumerate(kinds, start=1) if kind in MOVING)
        alone = "" if name in NAMELESS else f" '{name}'"
        return cls(part, tables, f"the axis{alone}" if len(tables) == 1 else "")

    def number(self, limb: int) -> str:
        """Return which limb one is, as `2`; where a chain's file counts other links, too, with its table there."""
        other = self.tables[limb - 1] if self.tables else limb
        return str(limb) if other == limb else f"{limb} ([[joint]] {other})"

    def name(self, limbs: Sequence[int], part: str | None = None) -> str:
        """Return where something sits, as `limb 2`, `towers 1 and 3`; "" of the whole machine.

        A chain of one joint is an axis, which has a name: there is no other to be counted. `part` is what one is called
        where that is not the machine's own word: drives are of joints.
        """
        if not limbs:
            return ""
        if self.axis:
            return self.axis
        *others, last = map(self.number, limbs)
        several = f"{', '.join(others)} and {last}" if others else last
        return f"{part or self.part}{'s' if others else ''} {several}"

    def at(self, limbs: Sequence[int], part: str | None = None) -> str:
        """Return the same behind what sits there, as ` at limb 2`; "" of the whole machine."""
        return f" at {self.name(limbs, part)}" if limbs else ""
