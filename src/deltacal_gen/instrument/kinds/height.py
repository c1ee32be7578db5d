"""Heights of the nozzle above a flat bed, as printers probe them; distances on a printed object may stand beside."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from deltacal_gen.instrument.facts import Look
from deltacal_gen.instrument.kind import Kind, Readings
from deltacal_gen.instrument.kinds import together
from deltacal_gen.instrument.kinds.distance import KIND as DISTANCE
from deltacal_gen.instrument.several import Several
from deltacal_gen.machine.registry import Machine
from deltacal_gen.machine.values import Recording, poses_of


@dataclass(frozen=True)
class Height(Kind):
    """Heights above the bed."""

    touched: ClassVar[tuple[str, ...]] = ("z",)
    probed: ClassVar[bool] = True
    usual_noise: ClassVar[float] = 0.02  # a bed probe's
    distances_beside: ClassVar[bool] = True

    def readings(self, recording: Recording, pose: np.ndarray) -> Readings:
        """Return the heights and, where distances were measured too, both."""
        heights = Kind.readings(self, recording, pose)
        if recording.pairs is None:
            return heights
        return self._both().joined(pose, (heights, DISTANCE.readings(recording, pose)))

    def unread(self, recording: Recording) -> Readings:
        """Return a height for every row that no pair names or that holds one, and a distance for every pair."""
        if recording.pairs is None:
            return Kind.unread(self, recording)
        own = np.isfinite(recording.measured[:, 0])
        own[np.setdiff1d(np.arange(recording.n_rows), recording.pairs)] = True
        heights = Kind.unread(self, recording).subset(own)
        return self._both().joined(poses_of(recording), (heights, DISTANCE.unread(recording)))

    @staticmethod
    def _both() -> Several:
        both = together(KIND, DISTANCE)
        assert isinstance(both, Several)
        return both

    @property
    def planned(self) -> str:
        """Nothing: a printer probes where its firmware wants."""
        return ""

    def looks(self, mechanism: Machine, points: int, stands: int) -> tuple[Look, ...]:
        """Return heights, of a machine that moves up and down."""
        return (Look("heights over a flat bed", 1, "flat bed"),) if "z" in mechanism.axes else ()


KIND = Height("height")
