"""What effects move, taken apart from its name: ``joint``, ``limb.tip_v``, ``turn.x``, ``tool.z``, ``reading.y``."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

AXES = ("x", "y", "z")


class Target(NamedTuple):
    """What an effect moves.

    Attributes
    ----------
    sort : str
        ``joint``, ``limb``, ``turn`` (of the base), ``tool`` (the measured point), ``reading``, ``torque``, ...
    part : str
        Which part of a limb, as mechanisms call it, or along or about which axis; empty of what is one alone.
    """

    sort: str
    part: str

    @property
    def axis(self) -> int:
        """Along, or about, which axis, from 0."""
        return AXES.index(self.part)


@cache
def target_of(name: str) -> Target:
    """Return the target that kernels call so."""
    sort, _, part = name.partition(".")
    return Target(sort, part)


def parts_of(names: tuple[str, ...]) -> list[str]:
    """Return which parts of a limb are among what an effect moves."""
    return [target.part for target in map(target_of, names) if target.sort == "limb"]
