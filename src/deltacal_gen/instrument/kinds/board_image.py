"""Images of a printed board: points of it in a camera on the platform, or beside the machine with the board on it."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from deltacal_gen.errors import MissingChannel
from deltacal_gen.instrument import board
from deltacal_gen.instrument.facts import Look
from deltacal_gen.instrument.kind import Frame, Instrument, Kind, Readings
from deltacal_gen.machine.registry import Array, Machine, mechanism_of
from deltacal_gen.machine.values import Measurement, Recording, Robot

if TYPE_CHECKING:
    from deltacal_gen.machine.values import Camera

TURN, AT, LAID, ORIGIN = slice(0, 9), slice(9, 12), slice(12, 21), slice(21, 24)  # places in the state
SCALE, LENS, RIDES = 24, slice(25, 34), 34
NAMES = ("fx_px", "fy_px", "cx_px", "cy_px", "k1", "k2", "p1", "p2", "k3")
ASKEW = "where the camera looks, with the lengths that tilt the machine's motions"
BENT = "how the camera is tilted, with the lengths that bend the machine's motions"
OF_SCALE, OF_LENS = 12, 13  # among the unknowns; before them camera and board, six each
PLACE = (3, 4, 5)  # where the camera sits: the first to go where it is not told from where the board lies
KNOWN_BY = 10.0  # ordinary sizes: what the readings know less well stays where it is
NEAR = 500.0  # mm: how far off an imagined board is at least
MOUNTED = 0.1  # of ordinary sizes: by how much a simulated camera is off the one that looks at the board's middle
USUAL = 1000.0  # px: of a focal length that is imagined
FRAMED = 0.35  # of the distance, that half of an imagined image shows

OF_THE_LENS = {  # what may stand for a number of the lens, and what tells it
    name: (
        words,
        f"calibrate the lens by itself, with the board seen from all sides, and say {name} in [measurement.camera]: to "
        "{own:.2g}" + (" px" if name.endswith("_px") else ""),
    )
    for name, words in zip(NAMES[2:], (*[ASKEW] * 2, *[BENT] * 5), strict=True)
}


@dataclass(frozen=True)
class BoardImage(Kind):
    """Points of a board in images. What of the lens the sidecar leaves out is found with where camera and board are."""

    whereabouts: ClassVar[str] = "where camera and board stand"
    aliases: ClassVar[tuple[str, ...]] = ("board image",)
    aims: ClassVar[str] = "look"
    picked: ClassVar[bool] = True
    usual_noise: ClassVar[float] = 0.05
    rotation_beside: ClassVar[bool] = False
    reported: ClassVar[Mapping[str, int]] = {"board_scale": SCALE} | {n: LENS.start + k for k, n in enumerate(NAMES)}
    confounds: ClassVar[Mapping[str, tuple[str, str]]] = (
        {
            "board_scale": (
                "the machine's own scale",
                "measure one length of the print, or of the machine, with callipers: to {accuracy:.2g} % of itself, as "
                "far as possible across. Say the print's in the columns of the board, the machine's in [tolerance]",
            )
        }
        | dict.fromkeys(
            ("fx_px", "fy_px"),
            (
                "the distance of the board",
                "take images with the board tilted by 20 deg or more, or from another distance; or measure the height "
                "of the camera over the board to {percent:.2g} % of itself",
            ),
        )
        | OF_THE_LENS
    )

    @property
    def places(self) -> dict[int, int]:
        """Where in the state unknowns with a name stand: {unknown: place}."""
        return {u: self.reported[name] for u, (name, _) in enumerate(self.unknown) if name in self.reported}

    @property
    def per_pose(self) -> int:
        """A pose, however many points show it."""
        return 6

    def check(
        self, said: Measurement, ties: Sequence[tuple[str, str, float]], cells: Mapping[str, Sequence[str]], file: Path
    ) -> None:
        """Raise an InputError where a recording does not say which points of the board it holds."""
        if missing := [name for name in self.known if name not in cells]:
            raise MissingChannel(
                f"images of a board need the points of the board: the column '{missing[0]}' is missing.",
                "Add board_x_mm and board_y_mm of each point, as printed.",
                file=file.with_suffix(".csv"),
                column=missing[0],
            )

    def wanted(self, said: Measurement) -> tuple[int, ...]:
        """Return where camera and board are, and what of scale and lens is not said."""
        lens = np.flatnonzero(np.isnan(_lens(said.camera))) + OF_LENS
        return (*range(OF_SCALE), *((OF_SCALE,) if said.board_scale == "unknown" else ()), *lens.tolist())

    def start(self, found: Readings, recording: Recording, robot: Robot, x: Array) -> Instrument:
        """Return the camera by its images, set-up by set-up: homographies, then hand and eye, then all together.

        What the readings know less well than ten ordinary sizes of it stays where it is.
        """
        said, setups = recording.measurement, int(recording.setup.max()) + 1
        rides = _rides(said)
        states = np.zeros((setups, self.state_size))
        for s in range(setups):
            chosen = np.flatnonzero(found.setup == s)
            if not len(chosen):
                states[s] = self._imagined_state(np.zeros(3), rides)
                continue
            part, poses = found.subset(chosen), x[found.rows[chosen, 0]]
            states[s] = board.first(part, poses, _lens(said.camera), rides, recording.path)
        instrument = Instrument(self, states, self.wanted(said))
        instrument = dataclasses.replace(instrument, scale=self._scale(instrument, found, x))
        return self._settled(instrument, found, x)

    def _scale(self, instrument: Instrument, found: Readings, x: Array) -> float:
        """Return what a pixel is at the board [mm]."""
        unscaled = dataclasses.replace(instrument, scale=1.0)
        moved = unscaled.by_unknown(found, x, PLACE[:2])  # px by a shift of the camera across
        return 1.0 / float(np.median(np.abs(np.einsum("ikk->ik", moved))))

    def _settled(self, instrument: Instrument, found: Readings, x: Array) -> Instrument:
        """Return the instrument fitted alone, free in what the readings show of it."""
        first, instrument = instrument, board.fitted(instrument, found, x)
        size = np.tile(self.typical[list(instrument.free)], len(instrument.state))
        unseen = board.unseen(instrument, found, x, size, KNOWN_BY, PLACE)
        if not unseen:
            return instrument
        free = tuple(u for u in instrument.free if u not in unseen)
        begun = [place for u, place in self.places.items() if u in unseen]
        state = instrument.state.copy()
        state[:, begun] = first.state[:, begun]  # not where a fit has led that could not know
        if set(PLACE) <= unseen:  # then it sits where the part that carries it has its origin
            state = board.at_origin(dataclasses.replace(instrument, state=state), found, x)
        return board.fitted(dataclasses.replace(instrument, state=state, free=free), found, x)

    def drawn(
        self, recording: Recording, robot: Robot, x: Array, frame: Frame | None, rng: np.random.Generator | None
    ) -> Instrument:
        """Return a camera that looks at the middle of a board, mounted as cameras are, its lens as the sidecar says."""
        said = recording.measurement
        rides = _rides(said)
        known = np.column_stack([recording.channels[name] for name in self.known])
        middle = (known.max(axis=0) + known.min(axis=0)) / 2
        chain = mechanism_of(robot).many_ways
        state = board.mounted(x, middle, float(np.ptp(known, axis=0).max()), _lens(said.camera), rides, chain)
        at = Instrument(self, np.tile(state, (int(recording.setup.max(initial=0)) + 1, 1)), self.wanted(said))
        if rng is not None:
            size = np.tile(self.typical[list(at.free)], len(at.state)) * MOUNTED
            at = at.stepped(size * rng.standard_normal(len(size)))
        return dataclasses.replace(at, free=(), scale=self._scale(at, self.unread(recording), x))

    def own(self, found: Readings, recording: Recording, robot: Robot, poses: Callable[[], Array]) -> Instrument | None:
        """Return None: where camera and board are only a result knows."""
        return None

    @property
    def planned(self) -> str:
        """Images of a board."""
        return "images of a printed board; camera and board, and what of the lens is not known, are projected out"

    def laid_out(self, recording: Recording, x: Array, mechanism: Machine) -> Recording:
        """Return a row for each point of a print that the camera sees, on the platform or beside it."""
        said, chain = recording.measurement, mechanism.many_ways
        printed = board.printed(x, chain, _rides(said))
        state = board.mounted(x, printed.mean(axis=0), float(np.ptp(printed)), _lens(said.camera), _rides(said), chain)
        rows, points = board.shown(state, x, printed)
        channels = {name: values[rows] for name, values in recording.channels.items()}
        channels |= dict(zip(self.known, printed[points].T, strict=True))
        return dataclasses.replace(
            recording,
            joints=recording.joints[rows],
            measured=np.full((len(rows), self.width), np.nan),
            pose=recording.pose[rows],
            line=np.arange(2, len(rows) + 2),
            channels=channels,
            setup=recording.setup[rows],
            tool=None if recording.tool is None else recording.tool[rows],
            targets=None if recording.targets is None else recording.targets[rows],
        )

    def looks(self, mechanism: Machine, points: int, stands: int) -> tuple[Look, ...]:
        """Return images, of a machine that moves in space."""
        if "z" not in mechanism.axes:
            return ()
        motions = "unknown frame and body" if mechanism.turning else "unknown frame, one point"
        return (Look("images of a board, camera and board unknown", 1, motions),)

    def _imagined_state(self, middle: Array, rides: bool) -> Array:
        lens = np.array([USUAL, USUAL, 0, 0, 0, 0, 0, 0, 0])
        return np.concatenate([np.eye(3).ravel(), np.zeros(3), np.eye(3).ravel(), middle, [0.0], lens, [float(rides)]])

    def imagined(self, x: Array, sets: int, mechanism: Machine, said: Measurement) -> tuple[Readings, Instrument]:
        """Return four points of a board at the poses that see it well; the camera looks along z of the platform.

        A fixed one looks at the print that a plan for it has.
        """
        if not _rides(said):
            return self._imagined_fixed(x, mechanism, said)
        along = x[:, 3:].reshape(-1, 3, 3)[:, :, 2]
        middle = along.mean(axis=0) / np.linalg.norm(along.mean(axis=0))
        far = 2.0 * float(np.ptp(x[:, :3], axis=0).max()) + NEAR
        centre = board.looked_at(x[:, :3], along, x[:, :3].mean(axis=0) + far * middle)
        far = float(np.median(np.linalg.norm(centre - x[:, :3], axis=1)))
        depth = np.einsum("ni,ni->n", along, centre - x[:, :3])
        rows = np.flatnonzero(depth > 0.5 * np.linalg.norm(centre - x[:, :3], axis=1))
        half = FRAMED * far / 2
        corners = half * np.array([[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 0.8]])
        state = self._imagined_state(centre, rides=True)
        lens = _lens(said.camera)
        state[LENS] = np.where(np.isnan(lens), state[LENS], lens)
        found = self.taken(np.repeat(rows, len(corners))[:, None])
        found = dataclasses.replace(found, known=np.tile(corners, (len(rows), 1)), group=np.repeat(rows, len(corners)))
        return found, Instrument(self, state[None], self._free(mechanism, said), far / state[LENS][0])

    def _free(self, mechanism: Machine, said: Measurement) -> tuple[int, ...]:
        """Return what is unknown; on a platform that does not turn the camera's place is told by the board's."""
        wanted = self.wanted(said)
        return wanted if mechanism.turning else tuple(u for u in wanted if u not in PLACE)

    def _imagined_fixed(self, x: Array, mechanism: Machine, said: Measurement) -> tuple[Readings, Instrument]:
        """Return the corners of a print on the platform as a camera before it sees them, one of them cut off."""
        chain = mechanism.many_ways
        printed = board.printed(x, chain, rides=False)
        width, height = printed.max(axis=0)
        corners = np.array([[0.0, 0.0], [width, 0.0], [width, height], [0.0, 0.9 * height]])
        state = board.mounted(x, printed.mean(axis=0), float(np.ptp(printed)), _lens(said.camera), False, chain)
        rows, points = board.shown(state, x, corners)
        found = dataclasses.replace(self.taken(rows[:, None]), known=corners[points], group=rows)
        instrument = Instrument(self, state[None], self._free(mechanism, said))
        return found, dataclasses.replace(instrument, scale=self._scale(instrument, found, x))


def _rides(said: Measurement) -> bool:
    """Tell whether the camera sits on the platform."""
    return said.camera is None or said.camera.place == "platform"


def _lens(camera: Camera | None) -> Array:
    """Return focal lengths, principal point and distortion as a sidecar says them; NaN where they are to be found."""
    if camera is None:
        return np.array([np.nan] * 4 + [0.0] * 5)
    return np.array([getattr(camera, name) for name in NAMES], dtype=float)


KIND = BoardImage("board_image")
