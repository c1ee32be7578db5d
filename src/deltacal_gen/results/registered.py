"""What is registered: mechanisms, effects, claims. Each command answers a list of these."""

from __future__ import annotations

from typing import Literal, get_args

from deltacal_gen.results.base import Answer, Value
from deltacal_gen.results.document import Document, Table, Text

SHOWN = 8  # parameters of a model that stand in a line

Status = Literal[
    "proved", "verified", "imprecise", "contradicted", "convention-dependent", "not reproducible", "undecided"
]
STATUSES: tuple[str, ...] = get_args(Status)  # of claims


class SourceError(Value):
    """A parameter of a mechanism."""

    name: str
    unit: str
    meaning: str
    typical: float
    """An ordinary manufacturing error."""


class Dimension(Value):
    """A key of a robot file."""

    key: str
    table: str
    unit: str
    meaning: str
    required: bool


class MechanismEntry(Answer):
    """A mechanism with its parameters and models."""

    mechanism: str
    of: str
    """The machine that it describes."""
    title: str
    reference: str
    models: dict[str, tuple[str, ...]]
    """Parameters by the name of the model."""
    parameters: tuple[SourceError, ...]
    geometry: tuple[Dimension, ...]

    def document(self) -> Document:
        """Yield its models and its parameters."""
        yield Text(f": {self.title} ({self.reference})", self.mechanism)
        yield Table(("model", "parameters"), [(name, _first_and_last(names)) for name, names in self.models.items()])
        yield Table(("parameter", "unit", "meaning"), [(p.name, p.unit, p.meaning) for p in self.parameters])


class Mechanisms(tuple[MechanismEntry, ...]):
    """What `models` answers."""

    def document(self) -> Document:
        """Yield each in turn."""
        for each in self:
            yield from each.document()


def _first_and_last(names: tuple[str, ...]) -> str:
    return " ".join(names) if len(names) <= SHOWN else f"{' '.join(names[: SHOWN - 2])} ... {names[-1]}"


class EffectUnknown(Value):
    """A coefficient or constant of an effect."""

    name: str
    unit: str
    meaning: str
    searched: bool
    """Whether it is found by search: an order, a time."""


class EffectEntry(Answer):
    """An effect that a diagnosis knows."""

    effect: str
    title: str
    per_limb: bool
    parameters: tuple[EffectUnknown, ...]
    reads: tuple[str, ...]
    moves: tuple[str, ...]

    def document(self) -> Document:
        """Yield what it is, what it depends on, and its parameters."""
        yield Text(f": {self.title}", self.effect)
        yield Text(f"depends on {', '.join(self.reads) or 'nothing that is recorded'}; moves {', '.join(self.moves)}")
        rows = [(p.name, p.unit, p.meaning, "by search" if p.searched else "linear") for p in self.parameters]
        yield Table(("parameter", "unit", "meaning", "estimated"), rows)


class Effects(tuple[EffectEntry, ...]):
    """What `effects` answers."""

    def document(self) -> Document:
        """Yield them in a table, or the one that there is in full."""
        if len(self) == 1:
            yield from self[0].document()
            return
        rows = [(e.effect, e.title, ", ".join(f"{p.name} [{p.unit}]" for p in e.parameters)) for e in self]
        yield Table(("effect", "what it is", "parameters"), rows)


class ClaimEntry(Answer):
    """A claim of a paper, and what became of it."""

    paper: str
    title: str
    """Of the paper."""
    where: str
    statement: str
    status: Status
    printed: str
    correct: str
    decided: str
    """How the derivation decides it; empty where its test does, and printed and correct form are typed."""
    evidence: str
    test: str
    ended: str
    """How the test ended when it last ran, when, and with which sources; empty where it never ran."""
    measured: tuple[str, ...]
    """Its first figures."""

    def document(self) -> Document:
        """Yield where it stands and what became of it, and what decides it."""
        yield Text(f"  {self.status}", self.where)
        yield Text(self.statement)
        lines = {
            "printed": self.printed,
            "correct": "the same" if self.printed == self.correct else self.correct,
            "evidence": self.evidence,
            "derived": self.decided or "no: typed, and decided by its test",
            "test": self.test,
            "ended": self.ended,
            "measured": "; ".join(self.measured),
        }
        yield from (Text(line, f"{head} ") for head, line in lines.items() if line)
        yield Text("")


class Claims(tuple[ClaimEntry, ...]):
    """What `claims` answers."""

    def papers(self) -> dict[str, list[ClaimEntry]]:
        """Return the claims of each paper."""
        return {name: [c for c in self if c.paper == name] for name in dict.fromkeys(c.paper for c in self)}

    def document(self) -> Document:
        """Yield the claims of each paper, and how many have which status."""
        for entries in self.papers().values():
            yield Text("", entries[0].title)
            for claim in entries:
                yield from claim.document()
        yield from self.counts()

    def counts(self) -> Document:
        """Yield how many claims of which paper have which status."""
        papers = self.papers()
        counts = [(s, *(str(sum(c.status == s for c in own)) for own in papers.values())) for s in STATUSES]
        yield Table(("status", *papers), [*counts, ("all", *(str(len(own)) for own in papers.values()))])


class WrittenClaims(Claims):
    """Claims that stand on a page."""

    def document(self) -> Document:
        """Yield how many claims have which status."""
        yield Text(f"{len(self)} claims")
        yield from self.counts()
