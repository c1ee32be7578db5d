"""COMPARISON.json of `compare`."""

from __future__ import annotations

from typing import Literal

from deltacal_gen.results.base import Answer, Value


class Change(Value):
    """A parameter in both sessions, as errors relative to the first robot file."""

    name: str
    before: float
    after: float
    change: float
    std: float | None
    """Null where a session says nothing of it."""
    unit: str


class Comparison(Answer):
    """What changed between two sessions of one machine."""

    schema: Literal["deltacal.comparison/1"] = "deltacal.comparison/1"
    summary: str
    limit_std: float
    """Standard deviations beyond which a change is called one."""
    changed: tuple[Change, ...]
    """The clearest first."""
    unchanged: tuple[Change, ...]
    unknown: tuple[Change, ...]
