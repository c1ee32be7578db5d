"""COMPARISON.json of `compare`."""

from __future__ import annotations

from typing import Literal

from deltacal_gen.results.base import Answer, Value
from deltacal_gen.results.document import Document, Table, Text, number, some
from deltacal_gen.results.parts import Made

MOST_NAMES = 8  # of parameters in a line


class Change(Value):
    """A parameter in both sessions, as errors relative to the first robot file."""

    name: str
    before: float
    after: float
    change: float
    std: float | None
    """Null where a session says nothing of it."""
    unit: str


class Moved(Value):
    """How far the machine moved between two sessions at the same joints, over its workspace.

    No instrument knows where {O} lies: the best alignment of the two as a whole is taken out.
    """

    rms_mm: float
    worst_mm: float
    worst_at_mm: tuple[float, ...]
    """Where, in {O}."""
    poses: int


class Comparison(Answer):
    """What changed between two sessions of one machine."""

    schema_: Literal["deltacal.comparison/1"] = "deltacal.comparison/1"
    summary: str
    moved: Moved | None
    """Null of a machine whose file says no workspace."""
    limit_std: float
    """Standard deviations beyond which a change is called one."""
    changed: tuple[Change, ...]
    """The clearest first."""
    unchanged: tuple[Change, ...]
    unknown: tuple[Change, ...]
    """Parameters of which a session says nothing one by one."""
    combinations_changed: tuple[Change, ...] | None = None
    """Combinations of parameters that both sessions determine; absent where they determine other ones."""
    combinations_unchanged: tuple[Change, ...] | None = None
    made: Made | None = None

    @property
    def headline(self) -> str:
        """The summary."""
        return self.summary

    def document(self) -> Document:
        """Yield what changed, and the names of what did not."""
        combined = self.combinations_changed is not None
        unchanged = (self.combinations_unchanged or ()) if combined else self.unchanged
        yield Text(self.summary)
        if rows := [(e.name, *map(number, (e.before, e.after, e.change, e.std)), e.unit) for e in self.table()]:
            yield Table(("changed", "before", "after", "change", "std", "unit"), rows)
        for words, names in (
            ("unchanged", [e.name for e in unchanged if " " not in e.name]),
            ("not known one by one", [e.name for e in self.unknown]),
        ):
            if names:
                yield Text(f"{words}: {some(names, MOST_NAMES)}")

    def table(self) -> tuple[Change, ...]:
        """Return what changed."""
        return self.changed if self.combinations_changed is None else self.combinations_changed
