"""What is registered: mechanisms, effects, claims. Each command answers a list of these."""

from __future__ import annotations

from typing import Literal, get_args

from deltacal_gen.results.base import Answer, Value

Status = Literal["proved", "verified", "loose", "contradicted", "convention-dependent", "not reproducible", "undecided"]
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
