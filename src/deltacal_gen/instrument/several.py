"""Readings of several kinds in one recording, each kind in columns of its own: heights and printed distances."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.instrument.kind import Instrument, Kind, Readings
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.values import Measurement, Recording


@dataclass(frozen=True)
class Several(Kind):
    """Kinds that are read together: lengths, by instruments of which nothing is unknown.

    Each kind has noise of its own.
    """

    kinds: tuple[Kind, ...]

    def __post_init__(self) -> None:
        for kind in self.kinds:
            if kind.unknown or kind.rotations or kind.unit != "mm":
                raise ValueError(f"readings of the kind {kind.name} cannot stand beside others: it has unknowns.")

    @property
    def meaning(self) -> str:
        """What is read, in words."""
        return "; ".join(kind.meaning for kind in self.kinds)

    @property
    def sees_joints(self) -> bool:
        """No: lengths are read."""
        return False

    @property
    def known(self) -> tuple[str, ...]:
        """Nothing beside what was read."""
        return ()

    @property
    def unknowns(self) -> tuple[tuple[str, str, float, str], ...]:
        """Nothing."""
        return ()

    @property
    def state_size(self) -> int:
        """None: nothing is unknown."""
        return 0

    @property
    def unit(self) -> str:
        """Unit of the values in files."""
        return self.kinds[0].unit

    @property
    def scale(self) -> float:
        """What one unit of a value is at the platform [mm]."""
        return self.kinds[0].scale

    def at_platform(self, scale: float) -> Array:
        """Return ones: lengths are read."""
        return np.ones(self.width)

    @property
    def turned(self) -> tuple[int, ...]:
        """None: no rotations are read."""
        return ()

    @property
    def touched(self) -> tuple[str, ...]:  # type: ignore[override]  # of one kind it is the class's
        """Coordinates in which any of the kinds touches a surface."""
        return tuple(dict.fromkeys(name for kind in self.kinds for name in kind.touched))

    @property
    def probed(self) -> bool:  # type: ignore[override]  # of one kind it is the class's
        """Whether some of the readings are a firmware's."""
        return any(kind.probed for kind in self.kinds)

    @property
    def distances_beside(self) -> bool:  # type: ignore[override]  # as above
        """Whether some of the readings leave open what distances would tell."""
        return any(kind.distances_beside for kind in self.kinds)

    @property
    def width(self) -> int:
        """Number of columns of all kinds."""
        return sum(kind.width for kind in self.kinds)

    @property
    def scalars(self) -> int:
        """Number of independent scalars of a reading, which is of one kind."""
        return min(kind.scalars for kind in self.kinds)

    @property
    def targets(self) -> Mapping[str, int]:
        """Columns by what effects on the readings move."""
        return {target: c + first for first, kind in self._columns() for target, c in kind.targets.items()}

    @property
    def usual_noises(self) -> tuple[float, ...]:
        """Usual noise of each kind [mm]."""
        return tuple(kind.usual_noise for kind in self.kinds)

    @property
    def noises(self) -> int:
        """Number of noises that readings have: one of each kind."""
        return len(self.kinds)

    def noise_groups(self, columns: int) -> np.ndarray:
        """Return which kind each column belongs to."""
        return np.repeat(np.arange(len(self.kinds)), [kind.width for kind in self.kinds])

    def _columns(self) -> Iterator[tuple[int, Kind]]:
        """Yield the first column of each kind."""
        first = np.cumsum([0, *(kind.width for kind in self.kinds)])
        yield from zip(first.tolist(), self.kinds, strict=False)

    def joined(self, pose: np.ndarray, parts: Sequence[Readings]) -> Readings:
        """Return readings of the kinds, in their order, as one; `pose` (N,) says which rows are repeats."""
        two = any(part.rows.shape[1] == 2 for part in parts)
        rows = np.concatenate([part.rows[:, [0, -1]] if two else part.rows for part in parts])
        values = np.full((len(rows), self.width), np.nan)
        done = 0
        for (first, kind), part in zip(self._columns(), parts, strict=True):
            values[done : done + len(part), first : first + kind.width] = part.values
            done += len(part)
        _, group = np.unique(np.sort(pose[rows], axis=1), axis=0, return_inverse=True)
        line = np.concatenate([part.line for part in parts])
        return Readings(self, rows, values, None, np.zeros(len(rows), dtype=int), np.ravel(group), line)

    def parts(self, found: Readings) -> Iterator[tuple[slice, np.ndarray, Instrument, Readings]]:
        """Yield the readings of each kind: their columns, places, an instrument for them alone, and themselves."""
        for first, kind in self._columns():
            columns = slice(first, first + kind.width)
            at = np.flatnonzero(np.isfinite(found.values[:, columns]).any(axis=1))
            part = found.subset(at)
            rows = part.rows if kind.pairs else part.rows[:, :1]
            alone = dataclasses.replace(part, kind=kind, rows=rows, values=part.values[:, columns])
            yield columns, at, kind.first(), alone

    def predict(self, instrument: Instrument, found: Readings, x: Array) -> tuple[Array, Array | None]:
        """Return predicted values, each kind in its columns."""
        values = np.full((len(found), self.width), np.nan)
        for columns, at, own, part in self.parts(found):
            values[at, columns] = own.predict(part, x)[0]
        return values, None

    def by_platform(self, instrument: Instrument, found: Readings, x: Array, dx: Array) -> Array:
        """Return the derivatives, each kind in its columns; none of the others'."""
        J = np.zeros((len(found), self.width, dx.shape[2]))
        for columns, at, own, part in self.parts(found):
            J[at, columns] = own.linearise(part, x, dx)[0]
        return J

    def imagined(self, x: Array, sets: int, mechanism: Machine, said: Measurement) -> tuple[Readings, Instrument]:
        """Return the readings of all kinds at poses."""
        parts = [kind.imagined(x, sets, mechanism, said)[0] for kind in self.kinds]
        return self.joined(np.arange(len(x)), parts), self.first()

    def with_values(self, recording: Recording, found: Readings, values: Array, rotations: Array | None) -> Recording:
        """Return the recording with the readings of all kinds."""
        for columns, at, _, part in self.parts(found):
            recording = part.kind.with_values(recording, part, values[at, columns], None)
        return recording
