"""Readings: what was measured, reading by reading, whatever it was measured by."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.machine.rotation import Array
from deltacal_gen.machine.values import Recording, numbered

if TYPE_CHECKING:
    from deltacal_gen.instrument.kind import Kind

ALL = (0, 1, 2, 3, 4, 5)  # coordinates of a body: position, rotation


@dataclass(frozen=True, eq=False)
class Readings:
    """What was measured, reading by reading; a reading belongs to one row of the recording, a distance to two.

    Attributes
    ----------
    kind : Kind
        As the recording says, or what several kinds read together.
    rows : (R, 1) or (R, 2) int array
        Rows of the recording; among readings of several kinds, one of a single row names it twice.
    values : (R, k) array
        Lengths [mm], or as the kind says [rad, px]. NaN along an axis that the machine does not have and, among
        readings of several kinds, in the columns of the others.
    rotations : (R, 3, 3) array or None
        Measured rotations; NaN where only the position was read.
    setup : (R,) int array
        Set-up of the instrument; of contacts, the point that is touched.
    group : (R,) int array
        Readings of one group stay together when readings are held out: repeats of a pose, of a pair of poses.
    line : (R,) int array
        Line in the file.
    made : bool
        Distances made of measured positions, which share their noise.
    known : (R, k) array or None
        What the recording tells of each reading beside what was read: where on a board its point lies [mm].
    components : tuple of int
        Which coordinates of a body (position, rotation) a position or pose holds: in the plane, not all.
    """

    kind: Kind
    rows: np.ndarray
    values: Array
    rotations: Array | None
    setup: np.ndarray
    group: np.ndarray
    line: np.ndarray
    made: bool = False
    known: Array | None = None
    components: tuple[int, ...] = ALL

    def __len__(self) -> int:
        return len(self.values)

    @property
    def n_scalars(self) -> int:
        """Number of independent scalar readings: distances made of positions hold no more than those."""
        if self.made:
            return min(len(self.values), 3 * len(self.used) - 6)
        turns = sum(c >= 3 for c in self.components)
        turned = 0 if self.rotations is None else turns * int(np.isfinite(self.rotations[:, 0, 0]).sum())
        return int(np.isfinite(self.values).sum()) + turned

    @cached_property
    def used(self) -> np.ndarray:
        """Rows of the recording to which readings belong, in their order."""
        return np.flatnonzero(np.bincount(self.rows.ravel()))

    def ends(self, values: Array) -> tuple[Array, ...]:
        """Return what holds at each end of the readings (R, ...) of values (N, ...) of all rows; in order no copy."""
        every = np.arange(len(values))
        return tuple(values if np.array_equal(rows, every) else values[rows] for rows in self.rows.T)

    def subset(self, chosen: np.ndarray) -> Readings:
        """Return the readings of an index or mask."""
        return dataclasses.replace(
            self,
            rows=self.rows[chosen],
            values=self.values[chosen],
            rotations=None if self.rotations is None else self.rotations[chosen],
            setup=self.setup[chosen],
            group=self.group[chosen],
            line=self.line[chosen],
            known=None if self.known is None else self.known[chosen],
        )

    def some(self, recording: Recording) -> Readings:
        """Return the readings; raise an InputError where there are none."""
        if len(self) == 0:
            raise InputError(
                "every measured cell is blank, so there is nothing to fit.",
                "Fill the measured columns, or use predict to compute them.",
                file=recording.path,
            )
        return self


def poses_of(recording: Recording) -> np.ndarray:
    """Return the pose (N,) of each row: label and set-up or, where there are no labels, joints and tool point."""
    _, label = np.unique(recording.pose, return_inverse=True)
    if label.max(initial=-1) + 1 == recording.n_rows and recording.pairs is None:
        tool = np.zeros((recording.n_rows, 3)) if recording.tool is None else np.nan_to_num(recording.tool)
        key = np.round(np.column_stack([recording.joints, tool, recording.setup]), 9)
        return numbered(key)
    return numbered(np.column_stack([label, recording.setup]))
