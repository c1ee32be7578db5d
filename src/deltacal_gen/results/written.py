"""What commands say of the files that they wrote, with ``--json``."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from deltacal_gen.results.base import Answer, Rows, Value
from deltacal_gen.results.document import Document, Table, Text, decimals, number


class Simulated(Answer):
    """A recording of `simulate`."""

    schema_: Literal["deltacal.simulation/1"] = "deltacal.simulation/1"
    recording: str
    readings: int
    kind: str | None = None
    noise: str | None = None
    """In words, where it is not that of lengths alone."""

    def document(self) -> Document:
        """Yield how many readings there are, and their noise."""
        yield Text(f"{self.readings} readings of the kind {self.kind}")
        if self.noise is not None:
            yield Text(self.noise)


class Matrix(Answer):
    """An identification matrix of `matrix`."""

    schema_: Literal["deltacal.matrix/1"] = "deltacal.matrix/1"
    file: str
    rows: int
    columns: int
    rank: int
    condition: float | None
    """Null where the rank is not full."""
    scaling: str
    combinations: tuple[str, ...] | None = None
    """In motion: the combinations of inertial parameters that the samples know."""
    unidentifiable: tuple[str, ...] | None = None
    """In motion: what they do not know, in words."""

    def document(self) -> Document:
        """Yield its size and rank, and in motion what the samples determine."""
        yield Text(
            f"H {self.rows} x {self.columns}, rank {self.rank}, condition {number(self.condition)} "
            f"(scaling {self.scaling})"
        )
        for name in ("combinations", "unidentifiable"):
            if (words := getattr(self, name)) is not None:
                yield Text(f"{name}: {'; '.join(words)}", level=1)


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


class Joints(Answer):
    """Commands of `compensate`, in deg or mm."""

    schema_: Literal["deltacal.joints/1"] = "deltacal.joints/1"
    kind: str
    export: str | None
    joints: Rows
    assumed: tuple[str, ...]
    """What was assumed where a channel was not given."""
    firmware: FirmwareLines | None = None
    file: str | None = None

    def document(self) -> Document:
        """Yield what was exported, or the commands where no file holds them, and what was assumed."""
        if self.firmware is not None:
            yield from self.firmware.document()
        elif self.export is not None:
            yield Text(f"{self.kind} compensator; its error is stated in the file")
        elif self.file is not None:
            yield Text(f"{len(self.joints)} commands")
        else:
            yield from (Text("  ".join(f"{v:12.6f}" for v in row)) for row in self.joints)
        yield from (Text(words, level=1) for words in self.assumed)


class FedForward(Answer):
    """Commands of `compensate --trajectory`, sample by sample."""

    schema_: Literal["deltacal.feedforward/1"] = "deltacal.feedforward/1"
    columns: tuple[str, ...]
    """Of the file that is written."""
    joints: Rows
    torques: Rows
    """In `units`; null of a joint that the model does not know."""
    units: tuple[str, ...]
    told: tuple[str, ...]
    """What was assumed, and what is beyond limits."""
    file: str | None = None

    def document(self) -> Document:
        """Yield the commands where no file holds them, what was assumed and what is beyond limits."""
        if self.file is not None:
            yield Text(f"{len(self.torques)} samples with joints and torques")
        else:
            yield from (
                Text("  ".join(f"{v:12.6f}" for v in (*q, *torque)))
                for q, torque in zip(self.joints, self.torques, strict=True)
            )
        yield from (Text(words, level=1) for words in self.told)


class Predicted(Answer):
    """Readings of `predict`."""

    schema_: Literal["deltacal.prediction/1"] = "deltacal.prediction/1"
    file: str
    kind: str | None = None
    readings: int
    told: tuple[str, ...]

    def document(self) -> Document:
        """Yield how many readings are predicted, and what is to be known of them."""
        yield Text(f"{self.readings} readings of the kind {self.kind} predicted")
        yield from map(Text, self.told)


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


class Imported(Answer):
    """What `import` made."""

    schema_: Literal["deltacal.import/1"] = "deltacal.import/1"
    folder: str
    robot: str | None
    recordings: tuple[str, ...]
    warnings: tuple[str, ...]

    def document(self) -> Document:
        """Yield what was written, and what to know before using it."""
        yield Text(", ".join([*([self.robot] if self.robot else []), *self.recordings]))
        yield from (Text(words, "warning: ") for words in self.warnings)


class Derivation(Answer):
    """Pages of `derivation`."""

    schema_: Literal["deltacal.derivation/1"] = "deltacal.derivation/1"
    files: tuple[str, ...]

    def document(self) -> Document:
        """Yield which file to open."""
        yield Text(f"{len(self.files)} file{'s' if len(self.files) > 1 else ''}; open {self.files[0]}")


class Reproduction(Answer):
    """Pages of `reproduce`."""

    schema_: Literal["deltacal.reproduction/1"] = "deltacal.reproduction/1"
    files: tuple[str, ...]
    remade: tuple[str, ...]
    """Tables and figures, by their numbers in the paper."""

    def document(self) -> Document:
        """Yield which file to open."""
        yield Text(f"{len(self.remade)} tables and figures remade; open {self.files[0]}")


class Kernels(Answer):
    """What `kernels` did."""

    schema_: Literal["deltacal.kernels/1"] = "deltacal.kernels/1"
    done: bool
    """Whether the derivation went well, and under --check gave the committed kernels."""
    seconds: dict[str, float] | None = None
    """Of what was compiled ahead."""
    trial: str | None = None
    """How a machine of the derived kernels does, in words."""

    def document(self) -> Document:
        """Yield the time of each kernel, or what the trial says."""
        yield from (Text(f"{seconds:7.2f} s  {name}") for name, seconds in (self.seconds or {}).items())
        if self.trial is not None:
            yield Text(self.trial)


class Manual(Answer):
    """A page of `manual`, or the examples that it copied."""

    schema_: Literal["deltacal.manual/1"] = "deltacal.manual/1"
    topic: str
    text: str | None
    """Markdown; null where examples were copied and no topic was given."""
    files: tuple[str, ...]
