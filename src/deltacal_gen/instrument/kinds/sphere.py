"""Images of a ball: its extremes in a camera on the platform; where the ball stands is unknown in any case."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import ClassVar

import numpy as np

from deltacal_gen.errors import MissingChannel
from deltacal_gen.instrument import sphere
from deltacal_gen.instrument.facts import Look
from deltacal_gen.instrument.kind import Frame, Instrument, Kind, Readings
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.rotation import align, from_vector
from deltacal_gen.machine.values import Measurement, Recording, Robot
from deltacal_gen.units import DEG

VISIBLE = 0.9  # part of the half image that a simulated ball stays in
NEEDED = ("fx_px", "fy_px", "cx_px", "cy_px", "k1", "ball_radius_mm")
CAMERA, BALL = (0, 1, 2), (3, 4, 5)  # the unknowns: turns of the camera, shifts of the ball; the distortion is known


@dataclass(frozen=True)
class Sphere(Kind):
    """Extremes of a ball's image. `rotation_deg` of the camera turns the axes of {O'} into its own."""

    whereabouts: ClassVar[str] = "where the camera stands"
    aliases: ClassVar[tuple[str, ...]] = ("sphere image", "sphere_image")

    def check(
        self, said: Measurement, ties: Sequence[tuple[str, str, float]], cells: Mapping[str, Sequence[str]], file: Path
    ) -> None:
        """Raise an InputError where the sidecar does not say what the camera is."""
        camera = said.camera
        if camera is None or not np.isfinite([getattr(camera, key) for key in NEEDED]).all():
            raise MissingChannel(
                "images of a sphere need the camera.",
                "Add [measurement.camera] with fx_px, fy_px, cx_px, cy_px and ball_radius_mm.",
                file=file,
            )

    def start(self, found: Readings, recording: Recording, robot: Robot, x: Array) -> Instrument:
        """Return the camera aligned by the ball's directions, set-up by set-up, and where the ball stands."""
        camera = recording.measurement.camera
        assert camera is not None
        known = recording.measurement.frame == "robot"
        seen = sphere.centres(found.values, camera)
        nominal = from_vector(np.asarray(camera.rotation_deg) * DEG).T
        state = []
        for s in range(int(recording.setup.max()) + 1):
            chosen = found.setup == s
            P, c = x[found.rows[chosen, 0], :3], seen[chosen]
            turn = nominal if known or not chosen.any() else align(P.mean(axis=0) - P, c - c.mean(axis=0))
            ball = (P + c @ turn).mean(axis=0) if chosen.any() else np.zeros(3)
            state.append(sphere.state(camera, turn, ball, sphere.order(found.values)))
        scale = float(np.median(seen[:, 2])) / np.sqrt(camera.fx_px * camera.fy_px)
        return Instrument(self, np.array(state), BALL if known else CAMERA + BALL, scale)

    def drawn(
        self, recording: Recording, robot: Robot, x: Array, frame: Frame | None, rng: np.random.Generator | None
    ) -> Instrument:
        """Return a camera whose ball stands on its axis, as near as all poses still see the whole of it.

        Where the frame is unknown the camera is mounted some degrees off the sidecar's rotation.
        """
        camera = recording.measurement.camera
        assert camera is not None  # the recording was read
        unknown = rng is not None and recording.measurement.frame == "unknown"
        off = self.typical[list(CAMERA)] * rng.standard_normal(3) if rng is not None and unknown else np.zeros(3)
        turn = from_vector(off) @ from_vector(np.asarray(camera.rotation_deg) * DEG).T
        P = x[:, :3] @ turn.T
        away = P - (P.max(axis=0) + P.min(axis=0)) / 2
        slope = VISIBLE * np.array([camera.cx_px / camera.fx_px, camera.cy_px / camera.fy_px])  # centre: about half
        reach = (np.abs(away[:, :2]) + 2 * camera.ball_radius_mm) / slope
        depth = max(float((reach + away[:, 2:]).max()), 4 * camera.ball_radius_mm + float(away[:, 2].max()))
        ball = turn.T @ ((P.max(axis=0) + P.min(axis=0)) / 2 + [0, 0, depth])
        state = np.tile(sphere.state(camera, turn, ball), (int(recording.setup.max()) + 1, 1))
        return Instrument(self, state, (), depth / np.sqrt(camera.fx_px * camera.fy_px))

    def own(self, found: Readings, recording: Recording, robot: Robot, poses: Callable[[], Array]) -> Instrument | None:
        """Return None: where the ball stands only a result knows."""
        return None

    @property
    def planned(self) -> str:
        """Nothing: which poses see the ball is not known beforehand."""
        return ""

    def looks(self, mechanism: Machine, points: int, stands: int) -> tuple[Look, ...]:
        """Return images, of a machine that moves in space; a chain that turns its last frame shows the body too."""
        if "z" not in mechanism.axes:
            return ()
        motions = "unknown frame and body" if mechanism.turning else "unknown frame, one point"
        return (Look("images of a ball, camera and ball unknown", 1, motions),)

    def imagined(self, x: Array, sets: int, mechanism: Machine, said: Measurement) -> tuple[Readings, Instrument]:
        """Return images at the poses that see the ball well.

        The camera looks along z of the platform, and the ball stands where the middle of the poses looks.
        """
        camera = said.camera
        assert camera is not None
        along = x[:, 3:].reshape(-1, 3, 3)[:, :, 2]
        middle = along.mean(axis=0) / np.linalg.norm(along.mean(axis=0))
        far = 2.0 * float(np.ptp(x[:, :3], axis=0).max()) + 20.0 * camera.ball_radius_mm
        ball = x[:, :3].mean(axis=0) + far * middle
        depth = np.einsum("ni,ni->n", along, ball - x[:, :3])
        rows = np.flatnonzero(depth > 0.5 * np.linalg.norm(ball - x[:, :3], axis=1))
        state = sphere.state(camera, np.eye(3), ball)[None]
        return self.taken(rows[:, None]), Instrument(self, state, CAMERA + BALL, far / camera.fx_px)


KIND = Sphere("sphere")
