"""The answer of `demo`."""

from __future__ import annotations

from typing import Literal

from deltacal_gen.results.base import Answer, Value
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.document import Document, Table, Text, number
from deltacal_gen.results.parts import EffectName
from deltacal_gen.results.result import Result


class ConcealedParameter(Value):
    """A coefficient as the truth file has it."""

    name: str
    limb: int | None
    value: float
    unit: str


class Concealed(EffectName):
    """An effect that was concealed in the recording."""

    parameters: tuple[ConcealedParameter, ...]


class Check(Value):
    """How far off the true machine stands when a model of it commands it."""

    model: str
    rms_mm: float
    worst_mm: float
    poses: int


class Demo(Answer):
    """The main job end to end."""

    schema_: Literal["deltacal.demo/2"] = "deltacal.demo/2"
    result: Result
    diagnosis: Diagnosis
    truth: tuple[Concealed, ...]
    check: tuple[Check, ...]
    files: dict[str, str]
    """By name, where each was written."""

    def document(self) -> Document:
        """Yield each step of the job, and where its files are."""
        result, places = self.result, self.diagnosis.robot.places
        yield Text(
            f", {result.model}: {result.readings.scalars} scalar readings, held-out error "
            f"{number(result.heldout_rms_mm)} mm; the measurement noise is {result.sigma_mm:.4f} mm (1 sigma).",
            "1. Geometry alone",
        )
        yield Text(f": {self.diagnosis.headline}", "2. Diagnosis")
        yield from list(self.diagnosis.document())[1:]
        told = "; ".join(
            f"{t.name}{places.at([p.limb] if p.limb else ())}, {p.name} {p.value:g} {p.unit}"
            for t in self.truth
            for p in t.parameters
        )
        yield Text(f", read only now: {told}.", "3. The truth")
        yield Text("The true machine, commanded by each model of it, with payloads and in directions drawn at random:")
        rows = [(row.model, f"{row.rms_mm:.4f}", f"{row.worst_mm:.4f}") for row in self.check]
        yield Table(("commanded by", f"rms of {self.check[0].poses} poses, mm", "largest, mm"), rows)
        files = self.files
        yield Text(f"Open {files['diagnosis.html']} (picture: {files['diagnosis.svg']}).")
        yield Text(f"Commands for the controller are in {files['command.c']}; for targets of your own:")
        yield Text(f"deltacal compensate {files['diagnosis.json']} TARGETS.csv -o JOINTS.csv", level=1)
