"""Poses: positions, and the rotation of a body that is mounted on the platform, turned by an unknown constant."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from deltacal_gen.instrument.facts import Look
from deltacal_gen.instrument.kind import Instrument, Kind, Readings
from deltacal_gen.instrument.kinds import position
from deltacal_gen.instrument.kinds.position import Position, home_of
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.rotation import from_vector, mean
from deltacal_gen.machine.values import Measurement, Recording, Robot


@dataclass(frozen=True)
class Pose(Position):
    """Positions and rotations."""

    aliases: ClassVar[tuple[str, ...]] = ()
    second_point: ClassVar[bool] = False
    rotation_beside: ClassVar[bool] = False

    def columns(self, mechanism: Machine) -> tuple[str, ...]:
        """Return coordinates and turns: a platform in the plane turns about z only.

        In space a tracked body has a rotation, held or not.
        """
        flat = len(mechanism.axes) < 3
        points = Position.columns(self, mechanism)
        turns = (name for name in self.kernels.COLUMNS if name.endswith("_deg"))
        return points[: len(mechanism.axes)] + tuple(n for n in turns if not flat or n[1] in mechanism.turns)

    def zero_at_home(self, recording: Recording) -> Array | None:
        """Return None: a body on the platform need not be parallel to it at home."""
        return None

    def readings(self, recording: Recording, pose: np.ndarray) -> Readings:
        """Return the poses of the recording; positions where not a single rotation was read."""
        found = Position.readings(self, recording, pose)
        components = np.array(recording.components)
        turns = np.full((recording.n_rows, 3), np.nan)
        turns[:, components[components >= 3] - 3] = recording.measured[:, components >= 3]
        taken = turns[found.rows[:, 0]]
        read = np.isfinite(taken[:, components[components >= 3] - 3]).all(axis=1)
        if not read.any():
            return dataclasses.replace(found, kind=position.KIND)
        rotations = np.full((len(found), 3, 3), np.nan)
        rotations[read] = from_vector(np.nan_to_num(taken[read]))
        return dataclasses.replace(found, rotations=rotations)

    def start(self, found: Readings, recording: Recording, robot: Robot, x: Array) -> Instrument:
        """Return the instrument aligned by positions, the body by the mean of its rotations; see `Position.start`."""
        frames = self._aligned(found, recording, robot, x)
        home = home_of(recording, robot)
        free = self._free(found.components, home)
        known = recording.measurement.frame == "robot"
        body = np.tile(np.eye(3).ravel(), (len(frames), 1))
        instrument = Instrument(
            self, np.hstack([frames, body]), tuple(u for u in free if u >= 6) if known else free, home=home
        )
        assert found.rotations is not None
        for s in range(len(frames)):
            chosen = np.flatnonzero((found.setup == s) & np.isfinite(found.rotations[:, 0, 0]))
            if len(chosen):
                part = found.subset(chosen)
                _, predicted = instrument.predict(part, x)
                assert part.rotations is not None
                assert predicted is not None
                body[s] = mean(np.swapaxes(predicted, 1, 2) @ part.rotations).ravel()
        return dataclasses.replace(instrument, state=np.hstack([frames, body]))

    def _mounted(self, turn: Array, origin: Array) -> Array:
        """Return the state at frames, with a body whose rotations are about the instrument's axes."""
        body = np.swapaxes(turn, 1, 2).reshape(len(turn), 9)
        return np.hstack([Position._mounted(self, turn, origin), body])

    def own(self, found: Readings, recording: Recording, robot: Robot, poses: Callable[[], Array]) -> Instrument | None:
        """Return None: how the body is mounted only a result knows."""
        return None

    def like(self, instrument: Instrument, recording: Recording) -> Instrument | None:
        """Return an instrument that reads poses."""
        return Kind.like(self, instrument, recording)

    @property
    def planned(self) -> str:
        """Poses."""
        return (
            "positions and rotations in one unknown frame and of one unknown body, which are projected out; a turn of "
            "1 rad counts as 100 mm"
        )

    def looks(self, mechanism: Machine, points: int, stands: int) -> tuple[Look, ...]:
        """Return poses with all known and with all unknown, of a machine whose platform turns."""
        if not mechanism.turns:
            return ()
        known = Look("poses in a known frame", 1, "frame and body known", frame="robot")
        return known, Look("poses, frame and body unknown", 1, "unknown frame and body")

    def imagined(self, x: Array, sets: int, mechanism: Machine, said: Measurement) -> tuple[Readings, Instrument]:
        """Return readings in the frame {O} of a body that is parallel to the platform."""
        found, instrument = Position.imagined(self, x, sets, mechanism, said)
        return dataclasses.replace(found, rotations=x[:, 3:].reshape(-1, 3, 3)), instrument


KIND = Pose("pose")
