"""Joints as a second encoder on them counts: what the transmission does to them is seen directly, geometry is not."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from deltacal_gen.instrument.facts import Look
from deltacal_gen.instrument.kind import Frame, Instrument, Kind, Readings
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.values import Measurement, Recording, Robot
from deltacal_gen.units import joint_names, of_joints

MOST_JOINTS = 32  # of a machine whose columns are reserved


@dataclass(frozen=True)
class Encoder(Kind):
    """Second encoders, each with a zero of its own: of a recording's rows, one reading for every joint that has one.

    The set-up of a reading is its joint, counted from 0: the encoders are part of the machine. Where some joints turn
    and others slide, readings of the former count as arcs of `scale` mm: the encoder's sign has that factor.
    """

    stays: ClassVar[bool] = True
    apart: ClassVar[bool] = True
    in_motion: ClassVar[bool] = True
    rotation_beside: ClassVar[bool] = False
    reported: ClassVar[Mapping[str, int]] = {"enc_zero": 1}
    sums: ClassVar[Mapping[str, tuple[str, str]]] = {
        "enc_zero": (
            "the zero of joint {number}",
            "put joint {number} to a mark or stop whose place the drawing gives, to {own:.2g} {unit}, and read both",
        )
    }

    @property
    def unit(self) -> str:
        """Unit of a turning joint."""
        return "deg"

    @property
    def reserved(self) -> tuple[str, ...]:
        """The columns of joints of either sort."""
        return tuple(name for unit in ("rad", "mm") for name in self._names(unit, MOST_JOINTS))

    def columns(self, mechanism: Machine) -> tuple[str, ...]:
        """Return one column for each joint."""
        return self._names(mechanism.joint_unit, mechanism.limbs)

    def _names(self, joint_unit: str, joints: int) -> tuple[str, ...]:
        return tuple(joint_names(joint_unit, joints, self.kernels.COLUMNS[0]))

    def readings(self, recording: Recording, pose: np.ndarray) -> Readings:
        """Return a reading for every cell that is not blank; a pose read again is a repeat for each joint alone."""
        rows, joints = np.nonzero(np.isfinite(recording.measured))
        return Readings(
            self,
            rows[:, None],
            (recording.measured * self._arcs(recording))[rows, joints, None],
            None,
            joints,
            np.unique(pose[rows] * recording.measured.shape[1] + joints, return_inverse=True)[1],
            recording.line[rows],
        )

    def unread(self, recording: Recording) -> Readings:
        """Return a reading for every joint of every row."""
        rows, joints = self._every(*recording.joints.shape)
        return Readings(self, rows[:, None], np.zeros((len(rows), 1)), None, joints, rows, rows)

    @staticmethod
    def _every(rows: int, joints: int) -> tuple[np.ndarray, np.ndarray]:
        return np.repeat(np.arange(rows), joints), np.tile(np.arange(joints), rows)

    def with_values(self, recording: Recording, found: Readings, values: Array, rotations: Array | None) -> Recording:
        """Return the recording with these readings, each in the column of its joint."""
        measured = np.full(recording.joints.shape, np.nan)
        measured[found.rows[:, 0], found.setup] = values[:, 0]
        return dataclasses.replace(recording, measured=measured / self._arcs(recording))

    def _arcs(self, recording: Recording) -> Array:
        """Return how much a unit of each joint (n_q,) counts: alone among joints of its sort, one."""
        turns = self._turns(recording)
        return np.where(turns, self.scale, 1.0) if 0 < turns.sum() < len(turns) else np.ones(len(turns))

    @staticmethod
    def _turns(recording: Recording) -> np.ndarray:
        return np.array([unit == "rad" for unit in of_joints(recording.joint_unit, recording.joints.shape[1])])

    def unit_of(self, unit: str, state: Array) -> str:
        """Return the unit of a zero: of a joint that turns, or slides."""
        return "rad" if state[2] else "mm"

    def spreads(self, recording: Recording, joints: Array) -> Iterator[tuple[str, float, float]]:
        """Yield nothing: the readings' size says nothing of the machine's."""
        return iter(())

    def looked_at(self, found: Readings, ends: tuple[Array, ...]) -> tuple[Array, ...]:
        """Return the joint of each reading."""
        return tuple(np.take_along_axis(end, found.setup[:, None], axis=1) for end in ends)

    def by_platform(self, instrument: Instrument, found: Readings, x: Array, dx: Array) -> Array:
        """Return the derivatives (R, 1, n) where joints move by `dx` (N, n_q, n)."""
        by_joint = instrument.scale * self.kernels.by_platform(*instrument.ends(found, x), instrument.given(found))
        out: Array = by_joint[:, :, 0] * dx[found.rows[:, 0], found.setup][:, None]
        return out

    def _mounted(self, recording: Recording, robot: Robot, zeros: Array) -> Instrument:
        """Return encoders that count as the controller does, each from its zero (n_q,)."""
        turns = self._turns(recording)
        sign = robot.joint_sign * self._arcs(recording)
        free = () if recording.measurement.frame == "robot" else (0,)
        state = np.column_stack([sign, zeros, turns])
        return Instrument(self, state, free, self.scale if turns.all() else 1.0)

    def start(self, found: Readings, recording: Recording, robot: Robot, x: Array) -> Instrument:
        """Return the encoders with the zeros that fit the middle of their readings."""
        at = self._mounted(recording, robot, np.zeros(x.shape[1]))
        if not at.free:
            return at
        r, zeros = at.residual(found, x)[:, 0] / at.scale, np.zeros(x.shape[1])
        for joint in np.unique(found.setup):
            zeros[joint] = np.median(r[found.setup == joint]) / at.state[joint, 0]
        return self._mounted(recording, robot, zeros)

    def drawn(
        self, recording: Recording, robot: Robot, x: Array, frame: Frame | None, rng: np.random.Generator | None
    ) -> Instrument:
        """Return encoders mounted with zeros drawn at random; without them where the frame is the robot's."""
        known = rng is None or recording.measurement.frame == "robot"
        zeros = np.zeros(x.shape[1]) if rng is None or known else self.typical[0] * rng.standard_normal(x.shape[1])
        return dataclasses.replace(self._mounted(recording, robot, zeros), free=())

    @property
    def planned(self) -> str:
        """Nothing: what geometry does is not seen, and the transmission shows wherever joints move both ways."""
        return ""

    def looks(self, mechanism: Machine, points: int, stands: int) -> tuple[Look, ...]:
        """Return nothing: no source error is seen."""
        return ()

    def imagined(self, x: Array, sets: int, mechanism: Machine, said: Measurement) -> tuple[Readings, Instrument]:
        """Return a reading of every joint at joints x (N, n_q)."""
        rows, joints = self._every(*x.shape)
        turns = [unit == "rad" for unit in of_joints(mechanism.joint_unit, x.shape[1])]
        state = np.column_stack([np.ones(x.shape[1]), np.zeros(x.shape[1]), turns])
        return self.taken(rows[:, None], joints), Instrument(self, state, (0,), self.scale)


KIND = Encoder("encoder")
