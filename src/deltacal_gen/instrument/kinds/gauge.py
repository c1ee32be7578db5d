"""Lengths from a point of the base to one of the platform, by a gauge that may be part of the machine."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import numpy as np

from deltacal_gen.errors import MissingChannel
from deltacal_gen.instrument.facts import Look
from deltacal_gen.instrument.kind import Frame, Instrument, Kind, Readings
from deltacal_gen.machine.registry import Array, Machine, mechanism_of
from deltacal_gen.machine.values import Measurement, Recording, Robot

ZERO = 3  # place of the zero in the state, and among the unknowns


@dataclass(frozen=True)
class Gauge(Kind):
    """Lengths by a linear scale, a ball bar or a draw wire."""

    whereabouts: ClassVar[str] = "where the gauge is mounted"
    second_point: ClassVar[bool] = True
    more_poses: ClassVar[bool] = True
    position_beside: ClassVar[bool] = True
    mount: ClassVar[tuple[str, ...]] = ("mx", "my", "mz")

    def check(
        self, said: Measurement, ties: Sequence[tuple[str, str, float]], cells: Mapping[str, Sequence[str]], file: Path
    ) -> None:
        """Raise an InputError where the sidecar does not say where the gauge is fixed."""
        if said.base_point_mm is None:
            raise MissingChannel(
                "a gauge needs the point of the base that it is fixed to.",
                "Add base_point_mm = [x, y, z] to [measurement].",
                file=file,
            )

    def spreads(self, recording: Recording, joints: Array) -> Iterator[tuple[str, float, float]]:
        """Yield the longest length; nothing of one that counts from the first: a ball bar's hardly moves."""
        rows = np.isfinite(recording.measured[:, 0])
        if rows.any() and recording.measurement.zero != "incremental":
            longest = float(np.abs(recording.measured[rows, 0]).max())
            yield recording.columns[0], longest, float(np.ptp(joints[rows], axis=0).max())

    def with_values(self, recording: Recording, found: Readings, values: Array, rotations: Array | None) -> Recording:
        """Return the recording with these lengths; incremental ones count from the first row."""
        first = values[0] if recording.measurement.zero == "incremental" else 0.0
        return super().with_values(recording, found, values - first, rotations)

    def standing(self, recording: Recording) -> Instrument:
        """Return the gauge where the sidecar says that it is fixed."""
        base = recording.measurement.base_point_mm or (0.0, 0.0, 0.0)
        setups = int(recording.setup.max(initial=0)) + 1
        return Instrument(self, np.tile([*base, 0.0], (setups, 1)), ())

    def start(self, found: Readings, recording: Recording, robot: Robot, x: Array) -> Instrument:
        """Return the gauge where the sidecar says; an incremental one with the zero that fits the readings."""
        mechanism, standing = mechanism_of(robot), self.standing(recording)
        own = self.carried(mechanism)
        free = tuple(u for u in range(ZERO) if u not in own and "xyz"[u] in mechanism.axes)
        if recording.measurement.zero != "incremental":
            return dataclasses.replace(standing, free=free)
        instrument = dataclasses.replace(standing, free=(*free, ZERO))
        r, state = instrument.residual(found, x), instrument.state.copy()
        for s in np.unique(found.setup):
            state[s, ZERO] = np.median(r[found.setup == s])
        return dataclasses.replace(instrument, state=state)

    def drawn(
        self, recording: Recording, robot: Robot, x: Array, frame: Frame | None, rng: np.random.Generator | None
    ) -> Instrument:
        """Return the gauge where the sidecar says that it is fixed."""
        return self.standing(recording)

    def own(self, found: Readings, recording: Recording, robot: Robot, poses: Callable[[], Array]) -> Instrument | None:
        """Return None: a result knows better than the sidecar where the gauge is fixed."""
        return None

    def like(self, instrument: Instrument, recording: Recording) -> Instrument | None:
        """Return a result's gauge; beside readings of other kinds, one that is fixed where the sidecar says."""
        if instrument.kind == self:
            return instrument
        said = recording.measurement.base_point_mm
        return None if said is None else Instrument(self, np.array([[*said, 0.0]]), ())

    def measured_point(self, said: Measurement) -> tuple[float, ...] | None:
        """Return the point of the platform that the gauge is fixed to."""
        return said.platform_point_mm

    def in_differences(self, said: Measurement) -> bool:
        """Tell whether the gauge is incremental (Mei 2018, eq. 24)."""
        return said.zero == "incremental"

    @property
    def planned(self) -> str:
        """Lengths."""
        return "lengths from a point of the base to one of the platform, differences of adjacent poses"

    def looks(self, mechanism: Machine, points: int, stands: int) -> tuple[Look, ...]:
        """Return lengths of one point; of a machine whose errors hold the mount's, with no other unknown mount, too."""
        unknown = Look("gauge between base and platform", 1, "unknown frame, one point")
        if not self.carried(mechanism):
            return (unknown,)
        return Look("gauge of which the machine knows the mount, its zero unknown", 1, frame="robot"), unknown

    def imagined(self, x: Array, sets: int, mechanism: Machine, said: Measurement) -> tuple[Readings, Instrument]:
        """Return lengths from the base point that is said, which is off along the machine's axes unless it is known."""
        base = np.array([[*(said.base_point_mm or (0.0, 0.0, 0.0)), 0.0]])
        free = tuple(u for u in range(ZERO) if "xyz"[u] in mechanism.axes)
        # readings that count from the first have no zero to be found, and leave the mount to be
        known = said.frame == "robot" and said.zero != "incremental"
        return self.taken(np.arange(len(x))[:, None]), Instrument(self, base, (ZERO,) if known else free)


KIND = Gauge("gauge")
