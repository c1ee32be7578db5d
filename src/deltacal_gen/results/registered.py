"""What is registered: mechanisms, effects, claims. Each command answers a list of these."""

from __future__ import annotations

from deltacal_gen.results.base import Answer, Value


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


class ClaimEntry(Answer):
    """A claim of a paper, and what became of it."""

    paper: str
    where: str
    statement: str
    status: str
    printed: str
    correct: str
    decided: str
    """How the derivation decides it; empty where its test does, and printed and correct form are typed."""
    evidence: str
    test: str
