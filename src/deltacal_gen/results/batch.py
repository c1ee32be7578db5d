"""batch.json of `batch`."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, ClassVar, Literal

from deltacal_gen.results.base import Answer, Value
from deltacal_gen.results.diagnosis import LawCoefficient, LawTerm

Action = Literal["diagnose", "identify", "validate"]
ASIDE = ("machine", "error", "warnings")  # of a row, told apart from the table
ByJoint = tuple[float | None, ...]
FEW = 3  # recordings that are named where many have the same to say
THRICE = 3  # recordings in which a law is physics, and no chance of a session


class FailedRow(Value):
    """A recording that could not be done, and why."""

    recording: str
    machine: str
    error: str

    warnings: ClassVar[None] = None


class DiagnosedRow(Value):
    """A recording's line of the table."""

    recording: str
    machine: str
    verdict: str
    effects: str
    model: str
    before_mm: float | None
    after_mm: float | None
    noise_mm: float
    error: None
    warnings: str | None = None
    law: str | None = None


class IdentifiedRow(Value):
    """A recording's line of the table."""

    recording: str
    machine: str
    model: str
    before_mm: float
    after_mm: float | None
    fitted_mm: float
    noise_mm: float
    error: None
    warnings: str | None = None


class ValidatedRow(Value):
    """A recording's line of the table."""

    recording: str
    machine: str
    after_mm: float
    worst_mm: float
    chi2_per_dof: float | None
    error: None
    warnings: str | None = None

    before_mm: ClassVar[None] = None


class DrivesRow(Value):
    """A line of a recording in motion (kind torque): figures joint by joint, null of one that did not move."""

    recording: str
    machine: str
    unit_by_joint: tuple[str, ...]
    error: None
    warnings: str | None = None

    before_mm: ClassVar[None] = None
    after_mm: ClassVar[None] = None


class DiagnosedDrivesRow(DrivesRow):
    """A recording's line of the table."""

    verdict: str
    effects: str
    model: str
    before_by_joint: ByJoint
    after_by_joint: ByJoint
    noise_by_joint: ByJoint
    law: str | None = None


class IdentifiedDrivesRow(DrivesRow):
    """A recording's line of the table."""

    model: str
    after_by_joint: ByJoint
    fitted_by_joint: ByJoint
    noise_by_joint: ByJoint


class ValidatedDrivesRow(DrivesRow):
    """A recording's line of the table."""

    after_by_joint: ByJoint
    readings: int
    chi2_per_dof: float | None


Done = DiagnosedRow | IdentifiedRow | ValidatedRow | DiagnosedDrivesRow | IdentifiedDrivesRow | ValidatedDrivesRow
Row = Done | FailedRow


class Moved(Value):
    """What moved in a machine from one recording to another."""

    machine: str
    from_: str
    to: str
    text: str


class AskedOf(Value):
    """What a recording says of a law that another one told: its form known, its coefficients fitted anew."""

    holds: bool | None = None
    """Whether it earns its charge and held-out readings lie nearer with it; null where it could not be asked."""
    why: str | None = None
    """Why it could not be asked, in words."""
    limbs: tuple[int, ...] = ()
    coefficients: tuple[LawCoefficient, ...] = ()
    gain: float | None = None
    """In chi2, beside what the recording's own diagnosis names."""
    charge: float | None = None
    """What an effect of known form has to earn: nothing was searched but, on another machine, the limbs."""
    heldout_rms_mm: float | None = None
    """Of readings that took no part in the fit of its coefficients."""
    without_rms_mm: float | None = None
    """Of the same without the law."""


class AskedLaw(AskedOf):
    """A law that was asked of a recording, or told of it."""

    recording: str
    machine: str


class LawSize(Value):
    """A coefficient of a law over the recordings in which it holds."""

    name: str
    limb: int | None
    """Null where each recording has one such coefficient, at whatever limb."""
    unit: str
    recordings: int
    low: float
    high: float
    mean: float
    between: float
    """Standard deviation between recordings, beyond what each leaves open (DerSimonian and Laird 1986)."""

    def __str__(self) -> str:
        where = self.name if self.limb is None else f"{self.name} of limb {self.limb}"
        unit = "" if self.unit == "1" else f" {self.unit}"
        if self.recordings == 1:
            return f"{where} is {self.mean:.3g}{unit}"
        apart = f"they differ by {self.between:.2g}" if self.between else "they differ by no more"
        return f"{where} from {self.low:.3g} to {self.high:.3g}{unit} ({apart} beyond what each leaves open)"


class CommonLaw(Value):
    """A law that recordings told, by what it moves and what it reads, as ``joint(payload, oil_C)``; and the others."""

    law: str
    recordings: tuple[str, ...]
    """In which it was found, each without the others."""
    terms: tuple[LawTerm, ...] = ()
    """The law that was asked: that of the recording in which it earns most."""
    asked: tuple[AskedLaw, ...] = ()
    """What each recording says of it; empty where it was asked of none."""
    sizes: tuple[LawSize, ...] = ()

    @property
    def holds_in(self) -> list[str]:
        """The recordings in which it holds."""
        return [a.recording for a in self.asked if a.holds]

    def told(self) -> list[str]:
        """Return in words where it was found, where it holds, how large it is, and where it could not be asked."""
        n = len(self.recordings)
        found = f"the law {self.law} was found in {n} recording{'s' if n > 1 else ''}: {_listed(self.recordings)}"
        if not self.asked:
            return [found]
        could = [a for a in self.asked if a.holds is not None]
        holds, refused = self.holds_in, [a.recording for a in could if not a.holds]
        physics = "; what is found thrice is physics" if len(holds) >= THRICE else ""
        out = [
            f"{found}; asked as {self._written()}",
            f"it holds in {len(holds)} of {len(could)} recordings that could be asked: {_listed(holds)}{physics}",
            *map(str, self.sizes),
        ]
        out += [f"it does not hold in {_listed(refused)}"] if refused else []
        cannot = [(a.recording, a.why) for a in self.asked if a.why is not None]
        return [*out, *(f"it could not be asked of {names}: {why}" for names, why in alike(cannot))]

    def _written(self) -> str:
        """Return the law with the constants within it, which multiply no summand."""
        terms, fitted = [], {c.name for a in self.asked for c in a.coefficients}
        for k, t in enumerate(self.terms):
            inner = (c for c in t.coefficients if of_term(c.name, k) not in fitted)
            known = [f"{c.name} = {c.value:.4g}{'' if c.unit == '1' else f' {c.unit}'}" for c in inner]
            terms.append(f"{t.target} = {t.expression}" + (f" with {', '.join(known)}" if known else ""))
        return "; ".join(terms)


class Batch(Answer):
    """Many recordings: one row each, in the order of their paths, and what moved."""

    schema: Literal["deltacal.batch/1"] = "deltacal.batch/1"
    action: Action
    rows: tuple[Row, ...]
    changed: tuple[Moved, ...]
    laws: tuple[CommonLaw, ...] = ()
    passed_over: tuple[str, ...] | None = None
    """Tables in the folder that are no recordings, and nothing that is imported; left out where there are none."""

    @property
    def headline(self) -> str:
        """How many recordings, and how many failed."""
        failed = sum(row.error is not None for row in self.rows)
        return f"{self.action}: {len(self.rows)} recordings, {failed} failed, {len(self.changed)} changes"

    def table(self) -> tuple[Row, ...]:
        """Return a row for each recording."""
        return self.rows

    def summary(self) -> str:
        """Return the answer as text, as `print` shows it."""
        return str(self)


def common(rows: Sequence[Row], asked: Mapping[str, CommonLaw] | None = None) -> tuple[CommonLaw, ...]:
    """Return laws that several recordings told or were asked, those of most recordings first.

    `asked` are what recordings say of each, by its name.
    """
    where: dict[str, list[str]] = {}
    for row in rows:
        if isinstance(row, DiagnosedRow | DiagnosedDrivesRow) and row.law is not None:
            where.setdefault(row.law, []).append(row.recording)
    every = [(asked or {}).get(law, CommonLaw(law=law, recordings=tuple(names))) for law, names in where.items()]
    several = [c for c in every if len(c.recordings) > 1 or len(c.asked) > 1]
    return tuple(sorted(several, key=lambda c: (-len(c.holds_in), -len(c.recordings))))


def of_term(name: str, k: int) -> str:
    """Return what a coefficient of a law's term is called among those of all its terms, from 0."""
    return name if k == 0 else f"{name} of term {k + 1}"


def sizes(asked: Sequence[AskedLaw]) -> tuple[LawSize, ...]:
    """Return each coefficient of a law over the recordings in which it holds."""
    held = [a for a in asked if a.holds]
    single = all(len({c.limb for c in a.coefficients}) == 1 for a in held)
    found: dict[tuple[str, int | None, str], list[tuple[float, float]]] = {}
    for c in (c for a in held for c in a.coefficients):
        key = c.name, None if single else c.limb, c.unit
        found.setdefault(key, []).append((c.value, c.std or 0.0))
    return tuple(_size(*key, *zip(*pairs, strict=True)) for key, pairs in found.items())


def _size(name: str, limb: int | None, unit: str, values: Sequence[float], std: Sequence[float]) -> LawSize:
    """Return a coefficient over several recordings, weighed as what each leaves open and their spread have it."""
    by, between = [1.0 / max(s, 1e-300) ** 2 for s in std], 0.0
    for k in range(2):
        mean = sum(w * v for w, v in zip(by, values, strict=True)) / sum(by)
        if k == 0 and len(values) > 1:
            apart = sum(w * (v - mean) ** 2 for w, v in zip(by, values, strict=True)) - (len(values) - 1)
            between = max(0.0, apart / (sum(by) - sum(w * w for w in by) / sum(by))) ** 0.5
        by = [1.0 / max(s * s + between**2, 1e-300) for s in std]
    return LawSize(
        name=name,
        limb=limb,
        unit=unit,
        recordings=len(values),
        low=min(values),
        high=max(values),
        mean=mean,
        between=between,
    )


def _listed(names: Sequence[str]) -> str:
    """Return names, of many the first ones and how many more."""
    return (", ".join(names[:FEW]) + (f" and {len(names) - FEW} more" if len(names) > FEW else "")) or "none"


def worst(rows: Sequence[Row], most: int) -> list[Row]:
    """Return the rows of a batch, in their order; of too many, those with the largest errors first."""
    if len(rows) <= most:
        return list(rows)
    done = [r for r in rows if not isinstance(r, FailedRow)]
    return [*sorted(done, key=lambda r: -(r.after_mm or 0.0))[:most]]


def in_table(value: Any) -> Any:
    """Return a value as it stands in a table: joints side by side, blank where there is none."""
    if isinstance(value, tuple):
        return " ".join("-" if v is None else f"{v:.4g}" if isinstance(v, float) else str(v) for v in value)
    return "" if value is None else value


def alike(said: Sequence[tuple[str, str]]) -> list[tuple[str, str]]:
    """Return recordings of which the same is said, together: (the first of them and how many more, what is said)."""
    by_text: dict[str, list[str]] = {}
    for name, text in said:
        by_text.setdefault(text, []).append(name)
    return [(_listed(names), text) for text, names in by_text.items()]
