"""Positions: coordinates of the measured point in a frame of the instrument, unknown unless it is the robot's."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from deltacal_gen.instrument.facts import Look
from deltacal_gen.instrument.kind import Frame, Instrument, Kind, Readings
from deltacal_gen.instrument.kinds import distance
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.rotation import align, from_vector, to_vector
from deltacal_gen.machine.values import Measurement, Recording, Robot

NEXT = 1e-12  # of a number: as near to it as divisions bear
SEEN = 1e-6  # of the length of a line: points that lie so near it do not show how it turns
IDENTITY = np.concatenate([np.eye(3).ravel(), np.zeros(3)])  # a frame that is {O}


def home_of(recording: Recording, robot: Robot) -> tuple[float, float, float]:
    """Return the home [mm] from which incremental positions count; {O} itself where they are absolute."""
    if recording.measurement.zero != "incremental" or "home" not in robot.geometry:
        return 0.0, 0.0, 0.0
    x, y, z = robot.geometry["home"].tolist()
    return x, y, z


def drawn_frames(recording: Recording, setups: int, rng: np.random.Generator) -> tuple[Array, Array]:
    """Return where instruments of unknown frame stand: rotation vectors (setups, 3) [rad] and origins (setups, 3)."""
    moving = np.array([1.0, 1.0, 1.0] if 2 in recording.components else [0.0, 0.0, 1.0])  # in the plane: about z
    turns, shifts = np.split(KIND.typical, 2)
    return turns * rng.standard_normal((setups, 3)) * moving, shifts * rng.standard_normal((setups, 3))


def seen(components: Sequence[int]) -> tuple[int, ...]:
    """Return the unknowns (turn x y z, shift x y z, turn of the body x y z) that show in coordinates of a body.

    In the plane x y an instrument turns about z and shifts along x and y.
    """
    if 2 in components:
        return tuple(range(9))
    return (2, 3, 4, 8) if 5 in components else (2, 3, 4)


def places(components: Sequence[int]) -> list[int]:
    """Return which coordinates of a point are read, of those of a body."""
    return [c for c in components if c < 3]


def _line(P: Array) -> Array:
    """Return the direction (3,) along which points (N, 3) spread most, as they go on."""
    away = P - P.mean(axis=0)
    line: Array = np.linalg.svd(away, full_matrices=False)[2][0]
    return line * np.sign(line[np.argmax(np.abs(line))])


def read_along(P: Array, y: Array) -> Array:
    """Return the direction (3,) along which points (N, 3) have coordinates (N,) best; both count from their means.

    Least squares on the unit sphere (Gander, Golub, von Matt 1989), along directions that the points show: without its
    length, the line of points on a surface that is read level would lie in that surface.
    """
    from scipy.optimize import brentq

    U, sizes, V = np.linalg.svd(P, full_matrices=False)
    shown = sizes > SEEN * sizes[:1]
    U, sizes, V = U[:, shown], sizes[shown], V[shown]
    if not len(sizes):
        return np.zeros(3)
    wanted = sizes * (U.T @ y)

    def longer(shift: float) -> float:
        return float(np.linalg.norm(wanted / (sizes**2 - shift))) - 1.0

    last = float(sizes[-1] ** 2) * (1.0 - NEXT)
    first = last - float(np.linalg.norm(wanted)) - 1.0
    own = wanted / (sizes**2 - (brentq(longer, first, last) if longer(last) > 0 else last))
    rest = max(1.0 - float(own[:-1] @ own[:-1]), 0.0)  # the direction that shows least takes what no shift gives
    own[-1] = np.copysign(np.sqrt(rest), own[-1])
    line: Array = own @ V
    return line


def frame_of(line: Array, k: int) -> Array:
    """Return a rotation (3, 3) whose axis k lies along a line (3,)."""
    size = np.linalg.norm(line)
    own = line / size if size > 0 else np.eye(3)[k]
    turn: Array = align(np.array([own, own, own]), np.array([np.eye(3)[k]] * 3))
    return turn


@dataclass(frozen=True)
class Position(Kind):
    """Positions of the measured point."""

    positions: ClassVar[bool] = True
    aliases: ClassVar[tuple[str, ...]] = ("one axis",)
    second_point: ClassVar[bool] = True
    more_poses: ClassVar[bool] = True

    def columns(self, mechanism: Machine) -> tuple[str, ...]:
        """Return the coordinates that the machine moves along."""
        return tuple(name for name in self.kernels.COLUMNS if name[0] in mechanism.axes)

    def read_in(self, columns: tuple[str, ...], given: Collection[str]) -> tuple[str, ...]:
        """Return the columns; where one coordinate alone was measured, as a laser does along an axis, that one."""
        there = [name for name in columns if name in given]
        return tuple(there) if len(there) == 1 else columns

    def spreads(self, recording: Recording, joints: Array) -> Iterator[tuple[str, float, float]]:
        """Yield the spread of the points of each set-up: each has a frame of its own.

        One coordinate of a machine that moves in several may stay what it is: a surface is followed.
        """
        points = recording.measured[:, [name.endswith("_mm") for name in recording.columns]]
        if points.shape[1] == 1 and np.count_nonzero(np.ptp(joints, axis=0)) > 1:
            return
        for setup in np.unique(recording.setup):
            rows = (recording.setup == setup) & np.isfinite(points).all(axis=1)
            if rows.any():
                spread = np.linalg.norm(np.ptp(points[rows], axis=0))
                yield recording.columns[0], float(spread), float(np.ptp(joints[rows], axis=0).max())

    def zero_at_home(self, recording: Recording) -> Array | None:
        """Return all positions, where they are the robot's own."""
        return recording.measured if recording.measurement.frame == "robot" else None

    def readings(self, recording: Recording, pose: np.ndarray) -> Readings:
        """Return the positions of the recording; a coordinate that the machine does not have is NaN."""
        components = np.array(recording.components)
        points = np.full((recording.n_rows, 3), np.nan)
        points[:, components[components < 3]] = recording.measured[:, components < 3]
        taken = np.flatnonzero(np.isfinite(points[:, components[components < 3]]).all(axis=1))
        return Readings(
            self,
            taken[:, None],
            points[taken],
            None,
            recording.setup[taken],
            pose[taken],
            recording.line[taken],
            components=recording.components,
        )

    def as_distances(self, found: Readings, recording: Recording) -> Readings:
        """Return the distances between all points of one set-up."""
        return distance.between(found, recording)

    def with_values(self, recording: Recording, found: Readings, values: Array, rotations: Array | None) -> Recording:
        """Return the recording with the coordinates that it has columns for."""
        whole = super().with_values(recording, found, values, rotations)
        return dataclasses.replace(whole, measured=whole.measured[:, list(recording.components)])

    def frames(self, instrument: Instrument) -> list[Frame]:
        """Return the rotation vector and the origin of {O} in the instrument's frame."""
        return [(to_vector(s[:9].reshape(3, 3)), s[9:12]) for s in instrument.state]

    def of_points(self, instrument: Instrument) -> Instrument | None:
        """Return the instrument without what else it reads."""
        return dataclasses.replace(
            instrument,
            kind=KIND,
            state=instrument.state[:, : len(IDENTITY)],
            free=tuple(u for u in instrument.free if u < len(KIND.unknown)),
        )

    def start(self, found: Readings, recording: Recording, robot: Robot, x: Array) -> Instrument:
        """Return the instrument aligned set-up by set-up (Kabsch).

        Positions that count from the robot's home have their origin there.
        """
        if len(places(found.components)) == 1:
            return self._along_a_line(found, recording, x)
        state = self._aligned(found, recording, robot, x)
        home = home_of(recording, robot)
        free = tuple(u for u in self._free(found.components, home) if u < len(self.unknown))
        return Instrument(self, state, () if recording.measurement.frame == "robot" else free, home=home)

    def _along_a_line(self, found: Readings, recording: Recording, x: Array) -> Instrument:
        """Return the instrument that reads one coordinate: along {O}'s own axis, or along a line that fits best.

        Turns of the line are unknown where the points show them: those of a single sliding joint lie on it.
        """
        (k,), setups = places(found.components), int(recording.setup.max()) + 1
        state = np.tile(IDENTITY, (setups, 1))
        if recording.measurement.frame == "robot":
            return Instrument(self, state, ())
        turns = {0, 1, 2} - {k}
        for s in range(setups):
            chosen = np.flatnonzero(found.setup == s)
            if not len(chosen):
                continue
            P, y = x[found.rows[chosen, 0], :3], found.values[chosen, k]
            away = P - P.mean(axis=0)
            turn = frame_of(read_along(away, y - y.mean()), k)
            state[s, :9] = turn.ravel()
            state[s, 9 + k] = y.mean() - turn[k] @ P.mean(axis=0)
            across = away @ turn.T  # turned about one axis the line sweeps along the other
            turns &= {u for u in turns if np.ptp(across[:, 3 - k - u]) > SEEN * np.ptp(across[:, k])}
        return Instrument(self, state, (*sorted(turns), 3 + k))

    @staticmethod
    def _free(components: Sequence[int], home: tuple[float, float, float]) -> tuple[int, ...]:
        return tuple(u for u in seen(components) if not (any(home) and 3 <= u < 6))

    @staticmethod
    def _aligned(found: Readings, recording: Recording, robot: Robot, x: Array) -> Array:
        setups = int(recording.setup.max()) + 1
        home = home_of(recording, robot)
        state = np.tile(IDENTITY, (setups, 1))
        for s in range(setups) if recording.measurement.frame != "robot" else ():
            chosen = found.setup == s
            if not chosen.any():
                continue
            P, y = x[found.rows[chosen, 0], :3], np.nan_to_num(found.values[chosen])
            turn = align(P - P.mean(axis=0), y - y.mean(axis=0))
            state[s, :9] = turn.ravel()
            if not any(home):
                state[s, 9:12] = y.mean(axis=0) - turn @ P.mean(axis=0)
        return state

    def drawn(
        self, recording: Recording, robot: Robot, x: Array, frame: Frame | None, rng: np.random.Generator | None
    ) -> Instrument:
        """Return the instrument in the robot's frame, in the one given, or in one drawn at random.

        What reads one coordinate alone is laid along the line on which the machine moves.
        """
        setups = int(recording.setup.max()) + 1
        turn, origin = np.tile(np.eye(3), (setups, 1, 1)), np.zeros((setups, 3))
        if frame is not None:
            turn[:], origin[:] = from_vector(frame[0]), frame[1]
        elif recording.measurement.frame == "unknown" and rng is not None:
            vectors, origin = drawn_frames(recording, setups, rng)
            turn = from_vector(vectors)
            if len(read := places(recording.components)) == 1:
                turn = np.array([frame_of(_line(x[recording.setup == s, :3]), read[0]) for s in range(setups)])
        home = home_of(recording, robot)
        if any(home):
            origin[:] = 0.0
        return Instrument(self, self._mounted(turn, origin), (), home=home)

    def _mounted(self, turn: Array, origin: Array) -> Array:
        """Return the state at frames: rotations (S, 3, 3) and origins (S, 3)."""
        return np.hstack([turn.reshape(len(turn), 9), origin])

    def own(self, found: Readings, recording: Recording, robot: Robot, poses: Callable[[], Array]) -> Instrument | None:
        """Return the instrument in the robot's frame."""
        if recording.measurement.frame != "robot":
            return None
        state = np.tile(IDENTITY, (int(recording.setup.max()) + 1, 1))
        return Instrument(self, state, (), home=home_of(recording, robot))

    def like(self, instrument: Instrument, recording: Recording) -> Instrument | None:
        """Return an instrument that reads positions, whatever else it reads."""
        return instrument.of_points()

    @property
    def planned(self) -> str:
        """Positions."""
        return "positions in one unknown frame, which is projected out"

    def looks(self, mechanism: Machine, points: int, stands: int) -> tuple[Look, ...]:
        """Return positions in a known frame, and in an unknown one of one and of several points."""
        unknown = "positions in an unknown frame"
        return (
            Look("positions in a known frame", 1, "frame of the robot", frame="robot"),
            Look(unknown, 1, "unknown frame, one point"),
            Look(unknown, points, "unknown frame, several points"),
        )

    def imagined(self, x: Array, sets: int, mechanism: Machine, said: Measurement) -> tuple[Readings, Instrument]:
        """Return readings in the frame {O}, known or not."""
        components = (0, 1, 2, 3, 4, 5) if "z" in mechanism.axes else (0, 1, 5)
        free = tuple(u for u in seen(components) if u < len(self.unknown))
        state = self._mounted(np.eye(3)[None], np.zeros((1, 3)))
        return self.taken(np.arange(len(x))[:, None]), Instrument(self, state, () if said.frame == "robot" else free)


KIND = Position("position")
