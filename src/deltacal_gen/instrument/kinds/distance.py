"""Distances between the measured points of two rows: no frame, nothing unknown of the instrument."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from deltacal_gen.errors import NoReadings, TooFewReadings
from deltacal_gen.instrument.facts import Look
from deltacal_gen.instrument.kind import ALL, Instrument, Kind, Readings
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.values import Measurement, Recording

MOST_PAIRS = 200_000  # distances that are made of positions at once


@dataclass(frozen=True)
class Distance(Kind):
    """Distances between the points of two rows."""

    second_point: ClassVar[bool] = True
    position_beside: ClassVar[bool] = True

    def spreads(self, recording: Recording, joints: Array) -> Iterator[tuple[str, float, float]]:
        """Yield the longest distance."""
        if recording.pairs is None or recording.pair_measured is None:
            return
        distance = np.nan_to_num(recording.pair_measured)
        if distance.any():
            a, b = joints[recording.pairs[np.argmax(distance)]]
            yield "distance_mm", float(distance.max()), float(np.abs(a - b).max())

    def readings(self, recording: Recording, pose: np.ndarray) -> Readings:
        """Return the distances of the recording's pairs."""
        if recording.pairs is None or recording.pair_measured is None or recording.pair_line is None:
            raise NoReadings("no distances between poses are given.", "Add NAME.distances.csv.", file=recording.path)
        taken = np.isfinite(recording.pair_measured)
        ends = np.sort(pose[recording.pairs[taken]], axis=1)
        _, group = np.unique(ends, axis=0, return_inverse=True)
        return Readings(
            self,
            recording.pairs[taken],
            recording.pair_measured[taken, None],
            None,
            np.zeros(int(taken.sum()), dtype=int),
            np.ravel(group),
            recording.pair_line[taken],
        )

    def unread(self, recording: Recording) -> Readings:
        """Return a distance for every pair."""
        if recording.pairs is None:
            raise NoReadings("no pairs of poses are given.", "Add NAME.distances.csv.", file=recording.path)
        every = np.arange(len(recording.pairs))
        none = np.zeros(len(every), dtype=int)
        components = recording.components or ALL
        return Readings(
            self, recording.pairs, np.zeros((len(every), 1)), None, none, every, every, components=components
        )

    def with_values(self, recording: Recording, found: Readings, values: Array, rotations: Array | None) -> Recording:
        """Return the recording with these distances."""
        return dataclasses.replace(recording, pair_measured=values[:, 0])

    @property
    def planned(self) -> str:
        """Distances."""
        return "distances between all pairs of positions of one reference point"

    def looks(self, mechanism: Machine, points: int, stands: int) -> tuple[Look, ...]:
        """Return distances of one and of several points."""
        one, several = "unknown frame, one point", "unknown frame, several points"
        turning = mechanism.turning  # a chain turns its last frame at will, so that a turn of it is seen
        words = "distances between poses"
        return Look(words, 1, one), Look(words, points, several if turning else one)

    def imagined(self, x: Array, sets: int, mechanism: Machine, said: Measurement) -> tuple[Readings, Instrument]:
        """Return the distances of all pairs of each reference point."""
        each = len(x) // sets
        pairs = np.column_stack(np.triu_indices(each, 1))
        rows = np.vstack([pairs + k * each for k in range(sets)])
        return self.taken(rows), self.first()


KIND = Distance("distance")


def between(positions: Readings, recording: Recording) -> Readings:
    """Return the distances of all pairs of positions that share tool point and set-up."""
    tool = np.zeros((recording.n_rows, 3)) if recording.tool is None else np.nan_to_num(recording.tool)
    _, point = np.unique(np.column_stack([tool[positions.rows[:, 0]], positions.setup]), axis=0, return_inverse=True)
    point = np.ravel(point)
    if (count := sum(n * (n - 1) // 2 for n in np.bincount(point))) > MOST_PAIRS:
        raise TooFewReadings(
            f"{len(positions)} positions make {count} distances.",
            "Use the positions themselves (they hold the same information), or fewer rows.",
            file=recording.path,
        )
    a, b = np.triu_indices(len(positions), 1)
    same = point[a] == point[b]
    a, b = a[same], b[same]
    gap = np.linalg.norm(np.nan_to_num(positions.values[b] - positions.values[a]), axis=1)
    apart = positions.group[a] != positions.group[b]  # two readings of one pose have no direction between them,
    joints = recording.joints[positions.rows[:, 0]]
    apart &= (joints[a] != joints[b]).any(axis=1)  # whatever the pose is called
    a, b, gap = a[apart], b[apart], gap[apart]
    ends = np.sort(np.column_stack([positions.group[a], positions.group[b]]), axis=1)
    _, group = np.unique(ends[:, 0] * (positions.group.max() + 1) + ends[:, 1], return_inverse=True)
    return Readings(
        KIND,
        np.column_stack([positions.rows[a, 0], positions.rows[b, 0]]),
        gap[:, None],
        None,
        positions.setup[a],
        np.ravel(group),
        positions.line[b],
        made=True,
    )
