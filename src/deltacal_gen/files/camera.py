"""A ball and a board in images: the ball's centre, the camera's parameters, the camera's rotation in the hand.

OpenCV finds things (``pip install deltacal_gen[camera]``); what they measure is fitted here. The ball's image is not
reduced to edge points or to an ellipse: the grey values of its rim are fitted by the exact outline of a sphere, blurred
by the optics and averaged over each pixel, so that neither the ellipse's centre nor its shape nor the rim's bend needs
a correction. Pixel coordinates have their origin at the centre of the first pixel.
"""

from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

import numpy as np
from deltacal_kernels import images

from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.columns import Columns
from deltacal_gen.files.sidecar import CameraTable, said_of
from deltacal_gen.files.toml import Table, TomlFile, toml_text
from deltacal_gen.files.writing import csv_text, write_files
from deltacal_gen.instrument import sphere
from deltacal_gen.machine.rotation import align, from_vector
from deltacal_gen.machine.values import Camera

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

SMALLEST = 5.0  # px: a ball of a smaller radius has too short a rim
PROVEN = 6.0  # standard deviations of a pixel's noise by which a ball must stand out
ALIKE = 0.2  # of the largest thing's area: a second one of that size is no speck
ROUND = 0.15  # by which a ball's area may differ from that of an ellipse in its box
RIM = 6.0  # px on either side of the outline that are fitted, beyond three times the blur
UNBENT = 30  # steps in which a direction of sight is found
PIXEL = 1 / 12  # px^2: variance of a pixel's own square
FEWEST_BOARDS = 3


def opencv() -> ModuleType:
    """Return OpenCV; raise a UsageError where it is not installed."""
    try:
        import cv2
    except ImportError:
        raise UsageError("images need OpenCV. Install it: pip install 'deltacal_gen[camera]'.") from None
    return cv2


def read_image(path: str | Path) -> Array:
    """Return the grey values (rows, columns) of an image file.

    Raises
    ------
    InputError
        The file is missing or no image.
    """
    cv2 = opencv()
    found = cv2.imread(str(path), cv2.IMREAD_GRAYSCALE | cv2.IMREAD_ANYDEPTH) if Path(path).exists() else None
    if found is None:
        raise InputError("there is no image that can be read.", "Give a PNG, TIFF, BMP or JPEG file.", file=path)
    grey: Array = found.astype(float)
    return grey


@dataclass(frozen=True)
class Ball:
    """A ball in an image.

    Attributes
    ----------
    centre : (3,) array
        In the camera's frame [mm].
    extremes : (4,) array
        u1, u2, v1, v2 of its image [px], the larger ones first.
    blur : float
        Standard deviation of the optics' blur [px].
    noise : float
        Standard deviation of the grey values from the fit.
    covariance : (3, 3) array
        Of the centre, from that noise [mm^2].
    """

    centre: Array
    extremes: Array
    blur: float
    noise: float
    covariance: Array


def find_ball(image: Array, camera: Camera, file: str | Path | None = None) -> Ball:
    """Return the ball that an image (rows, columns) of grey values shows, brighter or darker than what is behind it.

    Raises
    ------
    InputError
        No ball, more than one, or one that the image's border cuts; a rim too short to measure.

    References
    ----------
    Traslosheros 2013, sections 5.2 and 5.3, of which this is the exact form.
    """
    left, top, width, height, brighter = _box(image, file)
    rough = np.array([left + width - 0.5, left - 0.5, top + height - 0.5, top - 0.5])
    centre = sphere.centres(rough, camera)[0]
    if min(width, height) < 2 * SMALLEST:
        raise InputError(
            f"the ball's image is {width} x {height} px, too small to measure.",
            "Bring the camera nearer, or use a longer focal length.",
            file=file,
        )
    for _ in range(2):  # the rim to be fitted follows the outline that the first fit has found
        rim = _Rim(image, camera, centre)
        found = rim.fit(centre, brighter)
        centre = found.centre
    return found


def _box(image: Array, file: str | Path | None) -> tuple[int, int, int, int, bool]:
    """Return the box (left, top, width, height) of the only ball in an image, and whether the ball is the brighter."""
    cv2 = opencv()
    span = float(image.max() - image.min())
    nothing = InputError(
        "no ball can be seen.",
        "Take the image with the whole ball in view, before an even background of another brightness.",
        file=file,
    )
    if span <= 0:
        raise nothing
    smooth = cv2.GaussianBlur(np.round((image - image.min()) * (255 / span)).astype(np.uint8), (5, 5), 1.0)
    level, _ = cv2.threshold(smooth, 0, 255, cv2.THRESH_BINARY + cv2.THRESH_OTSU)
    edge = np.concatenate([smooth[0], smooth[-1], smooth[:, 0], smooth[:, -1]])
    brighter = bool(np.median(edge) <= level)
    mask = ((smooth > level) == brighter).astype(np.uint8)
    _, _, stats, _ = cv2.connectedComponentsWithStats(mask, connectivity=4)
    things = stats[1:][stats[1:, cv2.CC_STAT_AREA] > SMALLEST**2]
    inside = mask.astype(bool)
    if not len(things) or inside.all():
        raise nothing
    step = image[:, 1:] - image[:, :-1]
    noise = 1.4826 * float(np.median(np.abs(step))) / np.sqrt(2)
    if abs(float(np.median(image[inside]) - np.median(image[~inside]))) < PROVEN * max(noise, span / 1000):
        raise nothing
    things = things[np.argsort(-things[:, cv2.CC_STAT_AREA])]
    things = things[things[:, cv2.CC_STAT_AREA] > ALIKE * things[0, cv2.CC_STAT_AREA]]
    left, top, width, height, area = (int(v) for v in things[0])
    rows, columns = image.shape
    for x, y, w, h, _ in things:
        if x <= 1 or y <= 1 or x + w >= columns - 1 or y + h >= rows - 1:
            raise InputError(
                "the ball is cut by the border of the image.",
                "Move the hand so that the whole ball is in view.",
                file=file,
            )
    if len(things) > 1:
        raise InputError(
            f"{len(things)} things in the image could be the ball.",
            "Leave only one ball in view, before an even background.",
            file=file,
        )
    if abs(area / (np.pi / 4 * width * height) - 1) > ROUND:
        raise InputError(
            "what stands out in the image is not round, so it is no ball.",
            "Keep other things and shadows out of view.",
            file=file,
        )
    return left, top, width, height, brighter


class _Rim:
    """The pixels near a ball's outline, and the grey values that a ball gives them."""

    def __init__(self, image: Array, camera: Camera, centre: Array) -> None:
        u1, u2, v1, v2 = sphere.extremes(centre, camera)[0]
        margin = RIM + 2
        rows, columns = image.shape
        u = np.arange(max(int(u2 - margin), 0), min(int(u1 + margin) + 2, columns))
        v = np.arange(max(int(v2 - margin), 0), min(int(v1 + margin) + 2, rows))
        uu, vv = np.meshgrid(u, v)
        self._camera = camera
        self._sight, self._by_pixel = _sights(np.array([uu, vv]), camera)
        gap, *inward = self._gap(centre, self._sight, self._by_pixel)
        bend = -(np.gradient(inward[0], axis=1) + np.gradient(inward[1], axis=0))  # of the outline [1/px]
        near = np.abs(gap) < RIM
        self._sight, self._by_pixel, self._bend = self._sight[:, near], self._by_pixel[:, near], bend[near]
        self._inside = gap[near] > 0
        self._grey = image[v[0] : v[-1] + 1, u[0] : u[-1] + 1][near]

    def _gap(self, centre: Array, sight: Array, by_pixel: Array) -> Array:
        """Return how far pixels lie inside the outline [px], and the direction there that leads inward: (3, ...)."""
        with np.errstate(divide="ignore", invalid="ignore"):  # straight at the centre no direction leads inward
            found: Array = images.outline(sight, by_pixel, centre, self._camera.ball_radius_mm)
        return found

    def fit(self, centre: Array, brighter: bool) -> Ball:
        """Return the ball whose blurred outline fits the grey values best."""
        from scipy.optimize import least_squares
        from scipy.special import ndtr

        inner, outer = np.median(self._grey[self._inside]), np.median(self._grey[~self._inside])
        contrast = float(abs(inner - outer))

        def residual(p: Array) -> Array:
            gap, *_ = self._gap(p[:3], self._sight, self._by_pixel)
            variance = p[5] ** 2 + PIXEL
            # where the outline bends, blur draws the middle of the edge inward by half its variance times the bend
            part = ndtr((gap - self._bend * variance / 2) / np.sqrt(variance))
            result: Array = (p[3] + (p[4] - p[3]) * part - self._grey) / contrast
            return result

        start = np.array([*centre, outer, inner, 0.7])
        scale = np.array([*np.full(3, 1e-3 * np.linalg.norm(centre)), contrast, contrast, 1.0])
        found = least_squares(residual, start, x_scale=scale, method="lm", xtol=1e-9, ftol=1e-9)
        noise = np.sqrt(2 * found.cost / max(len(found.fun) - len(start), 1))
        covariance = noise**2 * np.linalg.inv(found.jac.T @ found.jac)[:3, :3]
        return Ball(
            centre=found.x[:3],
            extremes=sphere.extremes(found.x[:3], self._camera)[0],
            blur=float(abs(found.x[5])),
            noise=float(noise * contrast),
            covariance=covariance,
        )


def _sights(pixel: Array, camera: Camera) -> tuple[Array, Array]:
    """Return directions of sight (2, ...) through pixels (2, ...), and their derivatives (4, ...) by u and v."""
    sight, lens = np.zeros(pixel.shape), sphere.lens(camera)
    for _ in range(UNBENT):
        sight = images.direction(pixel, sight, lens)
    by_sight = images.by_sight(sight, lens).reshape(2, 2, *pixel.shape[1:])
    by_pixel = np.linalg.inv(np.moveaxis(by_sight, (0, 1), (-2, -1)))
    return sight, np.moveaxis(by_pixel, (-2, -1), (0, 1)).reshape(4, *pixel.shape[1:])


@dataclass(frozen=True)
class Calibration:
    """A camera calibrated from images of a board.

    Attributes
    ----------
    camera : Camera
    rms_px : float
        What is left between the corners seen and predicted.
    turns, origins : (N, 3, 3), (N, 3) arrays
        Board in the camera's frame, image by image: rotation, and position of its first corner [mm].
    """

    camera: Camera
    rms_px: float
    turns: Array
    origins: Array


def calibrate(
    images: Sequence[Array],
    corners: tuple[int, int],
    square_mm: float,
    ball_radius_mm: float,
    files: Sequence[str | Path] | None = None,
) -> Calibration:
    """Calibrate a camera from images of a chessboard (Zhang 2000): focal lengths, principal point, radial distortion.

    Parameters
    ----------
    corners : (int, int)
        Inner corners along a row and along a column of the board.
    square_mm : float
        Side of a square.
    ball_radius_mm : float
        Kept with the camera: the ball that it will look at.
    files : sequence of paths, optional
        Names of the images, for messages.

    Raises
    ------
    InputError
        Fewer than three images, an image without the whole board, or images of different sizes.
    """
    cv2 = opencv()
    names: Sequence[Any] = [None] * len(images) if files is None else files
    if len(images) < FEWEST_BOARDS:
        raise InputError(
            f"{len(images)} images of the board are too few to calibrate a camera.",
            f"Give at least {FEWEST_BOARDS}, better 15, with the board tilted in different directions.",
        )
    seen = []
    for image, name in zip(images, names, strict=True):
        if image.shape != images[0].shape:
            raise InputError("the image has another size than the first one.", "Use one camera.", file=name)
        grey = np.round(255 * (image - image.min()) / max(float(np.ptp(image)), 1.0)).astype(np.uint8)
        there, found = cv2.findChessboardCorners(grey, corners)
        if not there:
            raise InputError(
                f"no board with {corners[0]} x {corners[1]} inner corners can be seen.",
                "Take the image with the whole board in view, or correct the number of corners.",
                file=name,
            )
        found = np.reshape(found, (-1, 1, 2))  # OpenCV 5 has dropped the middle axis
        spacing = float(np.linalg.norm(np.diff(found[: corners[0], 0], axis=0), axis=1).min())
        half = max(int(spacing / 3), 3)
        ending = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_COUNT, 100, 1e-4)
        seen.append(cv2.cornerSubPix(grey, found, (half, half), (-1, -1), ending))
    board = np.zeros((corners[0] * corners[1], 3), dtype=np.float32)
    board[:, :2] = square_mm * np.mgrid[: corners[0], : corners[1]].T.reshape(-1, 2)
    rows, columns = images[0].shape
    flags = cv2.CALIB_FIX_K2 | cv2.CALIB_FIX_K3 | cv2.CALIB_ZERO_TANGENT_DIST
    rms, K, distortion, turns, origins = cv2.calibrateCamera(
        [board] * len(seen), seen, (columns, rows), None, None, flags=flags
    )
    camera = Camera(
        fx_px=float(K[0, 0]),
        fy_px=float(K[1, 1]),
        cx_px=float(K[0, 2]),
        cy_px=float(K[1, 2]),
        k1=float(np.ravel(distortion)[0]),
        ball_radius_mm=ball_radius_mm,
    )
    return Calibration(camera, float(rms), from_vector(np.reshape(turns, (-1, 3))), np.reshape(origins, (-1, 3)))


def hand_eye(positions: Array, seen: Array) -> tuple[Array, float]:
    """Return the camera's rotation in the hand (3, 3), its axes as columns, and the RMS left [mm].

    A fixed point seen from a hand that only translates moves in the camera's frame as the hand does, with the sign
    turned. Where the camera sits in the hand does not matter.

    Parameters
    ----------
    positions : (N, 3) array
        Of the hand in {O} [mm], three at least, not on a line.
    seen : (N, 3) array
        The fixed point in the camera's frame: a ball's centre, a board's first corner [mm].
    """
    moved, back = positions - positions.mean(axis=0), seen.mean(axis=0) - seen
    if len(positions) < 3 or np.linalg.matrix_rank(moved, 1e-3 * float(np.abs(moved).max())) < 2:
        raise InputError(
            "the hand's positions lie on a line or are fewer than three: they leave the camera's rotation open.",
            "Move the hand in at least two directions.",
        )
    turn = align(back, moved)
    return turn, float(np.sqrt(np.mean((moved - back @ turn.T) ** 2)))


# --- files ----------------------------------------------------------------------------------------------------------


class _Measurement(Table):
    kind: str = "sphere"
    camera: CameraTable


class _CameraFile(Table):
    measurement: _Measurement


def read_camera(path: str | Path) -> Camera:
    """Return the camera of a TOML file with a table ``[measurement.camera]``: what `camera_text` gives."""
    return TomlFile.read(path).check(_CameraFile).measurement.camera.value()


def camera_text(camera: Camera) -> str:
    """Return a camera as the text of a recording's sidecar."""
    return toml_text({"measurement": {"kind": "sphere"}, "measurement.camera": said_of(camera)})


def record(table: str | Path, camera: Camera, output: str | Path) -> list[Ball]:
    """Measure the ball in every image that a table names, and write the recording with its sidecar.

    Parameters
    ----------
    table : path
        CSV with the joints and any channels, and a column ``image``: files named from the table's folder.
    output : path
        Recording of the kind sphere image: the table with u1_px, u2_px, v1_px, v2_px for ``image``.

    Raises
    ------
    InputError
        A file that cannot be read, or an image without exactly one whole ball; nothing is written then.
    """
    table = Path(table)
    try:
        with table.open(newline="", encoding="utf-8-sig") as stream:
            rows = list(csv.DictReader(stream))
    except OSError as error:
        raise InputError(f"the table cannot be read: {error.strerror}.", "Check its name.", file=table) from None
    if not rows or "image" not in rows[0]:
        raise InputError("the table has no column 'image'.", "Name each row's image there.", file=table, line=1)
    balls = []
    for n, row in enumerate(rows):
        if not row["image"]:
            raise InputError("the cell is blank.", "Name the image.", file=table, line=n + 2, column="image")
        path = table.parent / row["image"]
        balls.append(find_ball(read_image(path), camera, path))
    columns: Columns = {name: [row[name] for row in rows] for name in rows[0] if name and name != "image"}
    for name, values in zip(("u1_px", "u2_px", "v1_px", "v2_px"), np.array([b.extremes for b in balls]).T, strict=True):
        columns[name] = values
    output = Path(output)
    write_files({output.with_suffix(".toml"): camera_text(camera), output: csv_text(columns)})
    return balls
