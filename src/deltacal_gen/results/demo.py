"""The answer of `demo`."""

from __future__ import annotations

from typing import Literal

from deltacal_gen.results.base import Answer, Value
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.result import Result


class ConcealedParameter(Value):
    """A coefficient as the truth file has it."""

    name: str
    limb: int | None
    value: float
    unit: str


class Concealed(Value):
    """An effect that was concealed in the recording."""

    name: str
    limbs: tuple[int, ...]
    parameters: tuple[ConcealedParameter, ...]


class Check(Value):
    """How far off the true machine stands when a model of it commands it."""

    model: str
    rms_mm: float
    worst_mm: float
    poses: int


class Demo(Answer):
    """The main job end to end."""

    schema: Literal["deltacal.demo/2"] = "deltacal.demo/2"
    result: Result
    diagnosis: Diagnosis
    truth: tuple[Concealed, ...]
    check: tuple[Check, ...]
    files: dict[str, str]
    """By name, where each was written."""
