"""What commands say of the files that they wrote, with ``--json``."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from pydantic import Field

from deltacal_gen.results.base import Answer, BlankRows, Value
from deltacal_gen.results.document import Document, Table, Text, decimals


class FirmwareLeft(Value):
    """What lines of a firmware leave of a calibrated machine."""

    bed_rms_mm: float
    """Of heights over the bed."""
    bed_worst_mm: float
    lateral_rms_mm: float
    """Across, over the printed volume."""
    lateral_worst_mm: float
    rms_mm: float
    """Of positions over the printed volume."""
    worst_mm: float


class FirmwareValue(Value):
    """A number of a firmware's lines, as it is and as it is to be."""

    name: str
    before: float
    after: float
    unit: str


class FirmwareLines(Value):
    """The lines of a printer's firmware that describe a calibrated machine."""

    kind: str
    text: str
    by_readings: bool
    """Whether they are a fit of the firmware's own parameters to the readings."""
    heights_alone: bool
    """Whether nothing but heights was read: then errors across the bed and above it are not known."""
    before: FirmwareLeft
    after: FirmwareLeft
    values: tuple[FirmwareValue, ...]
    not_carried: tuple[str, ...]

    def document(self) -> Iterator[Text | Table]:
        """Yield the firmware's numbers as they are and as they are to be, and the errors with either."""
        rows = [(v.name, f"{v.before:.4f}", f"{v.after:.4f}", v.unit) for v in self.values]
        shown = [("error on the bed", "bed"), ("lateral error", "lateral")]
        for name, key in shown[: 1 if self.heights_alone else 2]:
            for figure in ("rms", "worst"):
                now, new = (decimals(getattr(left, f"{key}_{figure}_mm")) for left in (self.before, self.after))
                rows.append((f"{name}, {figure}", now, new, "mm"))
        yield Table((self.kind, "in the file now", "new", "unit"), rows)
        least = "least over the bed" if self.heights_alone else "least over bed and volume"
        how = "a fit of the firmware's own numbers to the readings" if self.by_readings else least
        where = "the printed bed" if self.heights_alone else "the printed volume"
        yield Text(f"errors are those of the calibrated machine over {where}; the lines are {how}")
        if self.heights_alone:
            yield Text(
                "heights alone do not determine how far prints are off across the bed: identify says what to measure"
            )
        if self.not_carried:
            names = ", ".join(note.partition(" = ")[0] for note in self.not_carried)
            yield Text(f"not carried by the lines, with their sizes in the file: {names}")


class Receipt(Answer):
    """What a command wrote or did, where that is no answer itself: its files, and what stands in them."""

    schema_: Literal["deltacal.receipt/1"] = "deltacal.receipt/1"
    command: str
    summary: str
    """In a line."""
    done: bool = True
    """False where a check failed, for which the exit code is 1."""
    files: tuple[str, ...] = ()
    figures: dict[str, int | float | str | tuple[str, ...] | None] = Field(default_factory=dict)
    """What stands in them, by names that end in their unit; without one it is a count, a part of a whole or a word."""
    columns: tuple[str, ...] | None = None
    rows: BlankRows | None = None
    """Commands: joint by joint in deg or mm, or by `columns`; null of a joint that the model does not know."""
    firmware: FirmwareLines | None = None
    text: str | None = None
    """A page, in Markdown."""
    notes: tuple[str, ...] = ()
    """What was assumed, and what is to be known before the files are used."""

    @property
    def headline(self) -> str:
        """What was written."""
        return self.summary

    def document(self) -> Document:
        """Yield what was written, the commands where no file holds them, and what is to be known of it."""
        if self.firmware is not None:
            yield from self.firmware.document()
        elif self.rows is not None and not self.files:
            yield from (Text("  ".join(f"{v:12.6f}" for v in row)) for row in self.rows)
        elif self.summary:
            yield Text(self.summary)
        yield from (Text(words, level=1) for words in self.notes)


class Failure(Answer):
    """Why a command ended with an error, as `--json` prints it."""

    schema_: Literal["deltacal.error/1"] = "deltacal.error/1"
    code: str
    """The family of the error: what `deltacal explain` takes."""
    error: str
    """What is wrong, where, and what to do."""
    exit_code: int
    file: str | None
    line: int | None
    column: str | None


class Asked(Value):
    """An open question, how many rows it got, and the difference in chi2 that they are expected to make."""

    why: str
    rows: int
    expected_chi2: float


class Runs(Value):
    """Movements to be recorded next, of a machine in motion."""

    why: tuple[str, ...]
    """The questions that they are for."""
    runs: tuple[str, ...]
    """As the file calls them."""
    period_s: tuple[float, ...]
    payload_kg: tuple[float, ...] | None = None
    """Of each run, where [limits] of the robot file says what may be carried."""
    rate_Hz: float
    condition: float | None
    """Of what they tell, as of `plan`; null where it is infinite."""
    notes: tuple[str, ...]
    """Limits that were assumed."""
    command: str
    """What plans movements of other lengths or rates."""

    def document(self, file: str | None) -> Iterator[Text]:
        """Yield which runs are to be recorded."""
        for n, (name, period) in enumerate(zip(self.runs, self.period_s, strict=True)):
            carried = "" if self.payload_kg is None else f", with {self.payload_kg[n]:g} kg"
            yield Text(f"{name}: {period:g} s{carried}", level=1)
        yield from (Text(note, level=1) for note in self.notes)
        yield Text(
            f"{len(self.runs)} runs written to {file}: let the machine follow them, record what its drives give, "
            "append it, diagnose again"
        )
        yield Text(f"other lengths or rates: {self.command}")


class Experiment(Answer):
    """Rows of `next`; of a machine in motion its runs, whose rows are in the file alone."""

    schema_: Literal["deltacal.next/1"] = "deltacal.next/1"
    file: str | None
    """Null where none was written."""
    poses: tuple[dict[str, float | str], ...]
    questions: tuple[Asked, ...]
    advice: tuple[str, ...]
    """What no poses settle, in words."""
    motion: Runs | None = None

    def document(self) -> Document:
        """Yield the open questions, what no poses settle, and what to do with the file."""
        for asked in self.questions:
            yield Text(f"{asked.rows} rows: {asked.why} (expected difference in chi2: {asked.expected_chi2:.0f})")
        yield from (Text(words, level=1) for words in self.advice)
        if self.motion is not None:
            yield from self.motion.document(self.file)
        elif self.poses:
            yield Text(f"{len(self.poses)} rows written to {self.file}: measure them, append them, diagnose again")
        else:
            yield Text("nothing is open that poses could settle; no file was written")
