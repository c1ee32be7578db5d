"""Points of a printed board that the tip touched: where they stand on the print, at an unknown pose of the board."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from deltacal_gen.instrument.facts import Look
from deltacal_gen.instrument.kind import Frame, Instrument, Kind, Readings
from deltacal_gen.instrument.kinds.position import Position
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.rotation import from_vector
from deltacal_gen.machine.values import Measurement, Recording, Robot

FLAT = 1e-2  # of its width, by which points that a machine touches are off the plane of a print
UPRIGHT = 0.9  # of a unit vector: a print whose normal is nearer to x than that has another first axis
SCALE = 6  # place of the print's scale among the unknowns


@dataclass(frozen=True)
class TouchedBoard(Position):
    """Positions in the frame of a print, whose points are as far off its plane as the recording says: not at all."""

    whereabouts: ClassVar[str] = "where the board lies"
    aliases: ClassVar[tuple[str, ...]] = ("touched board",)
    under: ClassVar[str] = "position"
    aims: ClassVar[str] = "touch"
    filled: ClassVar[Mapping[str, float]] = {"board_z_mm": 0.0}
    reported: ClassVar[Mapping[str, int]] = {"board_scale": 12}
    confounds: ClassVar[Mapping[str, tuple[str, str]]] = {
        "board_scale": (
            "the machine's own scale",
            "measure one length of the print, or of the machine, with callipers: to {accuracy:.2g} % of itself, as far "
            "as possible across. Say the print's in the columns of the board, the machine's in [tolerance]",
        )
    }

    def columns(self, mechanism: Machine) -> tuple[str, ...]:
        """Return the coordinates on the print and off it."""
        return Kind.columns(self, mechanism)

    def readings(self, recording: Recording, pose: np.ndarray) -> Readings:
        """Return the points that were touched."""
        return Kind.readings(self, recording, pose)

    def with_values(self, recording: Recording, found: Readings, values: Array, rotations: Array | None) -> Recording:
        """Return the recording with all three coordinates."""
        return Kind.with_values(self, recording, found, values, rotations)

    def as_distances(self, found: Readings, recording: Recording) -> Readings:
        """Return the points themselves: their distances are those of the print, not of the machine."""
        return found

    def zero_at_home(self, recording: Recording) -> Array | None:
        """Return None: a print has its own origin."""
        return None

    def wanted(self, said: Measurement) -> tuple[int, ...]:
        """Return what is unknown: where the board is, unless it is said to be the robot's frame, and its scale."""
        place = () if said.frame == "robot" else tuple(range(SCALE))
        return (*place, *((SCALE,) if said.board_scale == "unknown" else ()))

    def start(self, found: Readings, recording: Recording, robot: Robot, x: Array) -> Instrument:
        """Return the board aligned with the points of the machine, as large as it says."""
        frames = self._aligned(found, recording, robot, x)
        state = np.hstack([frames, np.zeros((len(frames), 1))])
        return Instrument(self, state, self.wanted(recording.measurement))

    def drawn(
        self, recording: Recording, robot: Robot, x: Array, frame: Frame | None, rng: np.random.Generator | None
    ) -> Instrument:
        """Return a board in the robot's frame, or drawn at random; printed off by some where its scale is unknown.

        Of poses in one plane it lies there.
        """
        state = np.hstack([np.eye(3).ravel(), np.zeros(4)])[None]
        state = np.tile(state, (int(recording.setup.max(initial=0)) + 1, 1))
        if recording.measurement.frame != "robot" and rng is not None:
            off = self.typical[:SCALE] * rng.standard_normal((len(state), SCALE))
            state[:, :9], state[:, 9:12] = from_vector(off[:, :3]).reshape(-1, 9), off[:, 3:]
            if (lies := _plane(x[:, :3])) is not None:
                state[:, :9], state[:, 9:12] = lies[0].ravel(), lies[1]
        if recording.measurement.board_scale == "unknown" and rng is not None:
            state[:, 12] = self.typical[SCALE] * rng.standard_normal(len(state))
        return Instrument(self, state, ())

    def own(self, found: Readings, recording: Recording, robot: Robot, poses: Callable[[], Array]) -> Instrument | None:
        """Return None, unless everything is known of the board."""
        known = not self.wanted(recording.measurement)
        return self.start(found, recording, robot, poses()) if known else None

    def like(self, instrument: Instrument, recording: Recording) -> Instrument | None:
        """Return an instrument that reads points of a board."""
        return Kind.like(self, instrument, recording)

    def of_points(self, instrument: Instrument) -> Instrument | None:
        """Return the instrument: it reads nothing else."""
        return instrument

    @property
    def planned(self) -> str:
        """Points of a board."""
        return "points of a flat printed board, which the tip touches; where it lies is unknown and projected out"

    def laid_out(self, recording: Recording, x: Array, mechanism: Machine) -> Recording:
        """Return the rows with the points of the print that the tip touches, from its corner [mm]."""
        lies = _plane(x[:, :3])
        if lies is None:
            return recording
        at = x[:, :3] @ lies[0].T + lies[1]
        return dataclasses.replace(recording, measured=np.column_stack([at[:, :2].round(1) + 0.0, np.zeros(len(at))]))

    def looks(self, mechanism: Machine, points: int, stands: int) -> tuple[Look, ...]:
        """Return points of a board of known and of unknown scale, of a machine that moves in space."""
        if "z" not in mechanism.axes:
            return ()
        return (Look("points of a board in an unknown place", 1, "unknown frame, one point"),)

    def imagined(self, x: Array, sets: int, mechanism: Machine, said: Measurement) -> tuple[Readings, Instrument]:
        """Return readings of a board in the frame {O}."""
        state = np.hstack([np.eye(3).ravel(), np.zeros(4)])[None]
        found = self.taken(np.arange(len(x))[:, None])
        return found, Instrument(self, state, self.wanted(said))


def _plane(P: Array) -> tuple[Array, Array] | None:
    """Return turn (3, 3) and shift (3,) into the frame of a print in which points (N, 3) lie, from its corner.

    None where they lie in no plane.
    """
    middle = P.mean(axis=0)
    _, size, axes = np.linalg.svd(P - middle, full_matrices=False)
    if len(P) < 3 or size[2] > FLAT * size[1]:
        return None
    up = axes[2] * (np.sign(axes[2][np.argmax(np.abs(axes[2]))]))
    along = np.eye(3)[np.argmin(np.abs(up))]
    if abs(up[0]) < UPRIGHT:
        along = np.eye(3)[0]
    first = along - (along @ up) * up
    turn = np.array([first, np.cross(up, first), up * np.linalg.norm(first)]) / np.linalg.norm(first)
    at = P @ turn.T
    return turn, -np.array([*at[:, :2].min(axis=0), at[:, 2].mean()])


KIND = TouchedBoard("touched_board")
