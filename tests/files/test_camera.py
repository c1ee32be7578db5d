"""The camera on rendered images: balls, boards, and images that show neither."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.ndimage import gaussian_filter
from scipy.spatial.transform import Rotation

from deltacal_gen.app import cli
from deltacal_gen.errors import InputError
from deltacal_gen.files import camera
from deltacal_gen.instrument import sphere
from deltacal_gen.machine.values import Camera

cv2 = pytest.importorskip("cv2")

CAMERA = Camera(fx_px=500, fy_px=510, cx_px=161.3, cy_px=118.1, k1=-0.15, ball_radius_mm=19)
SHAPE = (240, 320)


def rays(u: np.ndarray, v: np.ndarray, of: Camera) -> tuple[np.ndarray, np.ndarray]:
    """Undistorted image coordinates, by fixed-point iteration of the distortion."""
    x, y = (u - of.cx_px) / of.fx_px, (v - of.cy_px) / of.fy_px
    a, b = x, y
    for _ in range(15):
        s = 1 + of.k1 * (a * a + b * b)
        a, b = x / s, y / s
    return a, b


def render(*balls: Any, of: Camera = CAMERA, fine: int = 6, blur: float = 0.8, dark: bool = False) -> np.ndarray:
    """Grey values (240, 320) of balls at centres [mm]: every pixel the mean of fine ones, smoothed by the optics."""
    part = np.zeros(SHAPE)
    for c in np.asarray(balls, dtype=float):
        radius = of.fx_px * of.ball_radius_mm / c[2] + 10
        middle = sphere.extremes(c, of)[0].reshape(2, 2).mean(axis=1)
        lo = np.maximum((middle - radius).astype(int), 0)
        hi = np.minimum((middle + radius).astype(int) + 1, SHAPE[::-1])
        offset = (np.arange(fine) + 0.5) / fine - 0.5
        u, v = np.meshgrid(*((np.arange(i, j)[:, None] + offset).ravel() for i, j in zip(lo, hi, strict=True)))
        x, y = rays(u, v, of)
        touch = np.sqrt(c @ c - of.ball_radius_mm**2)
        gap = (x * c[0] + y * c[1] + c[2]) / np.sqrt(x * x + y * y + 1) - touch
        inside = np.clip(0.5 + gap / np.hypot(np.gradient(gap, axis=0), np.gradient(gap, axis=1)), 0, 1)
        inside = gaussian_filter(inside, blur * fine, mode="nearest", truncate=5) if blur else inside
        coarse = inside.reshape(hi[1] - lo[1], fine, hi[0] - lo[0], fine).mean(axis=(1, 3))
        part[lo[1] : hi[1], lo[0] : hi[0]] += coarse
    return 210 - 170 * part if dark else 40 + 170 * part


def scene(rng: np.random.Generator) -> np.ndarray:
    z = rng.uniform(250, 400)
    return np.array([z * rng.uniform(-0.2, 0.2), z * rng.uniform(-0.13, 0.13), z])


def test_a_balls_centre_has_no_bias() -> None:
    rng = np.random.default_rng(1)
    gaps = []
    for k in range(8):
        centre = scene(rng)
        found = camera.find_ball(render(centre, dark=bool(k % 2)), CAMERA)
        gaps.append(found.centre - centre)
        assert found.blur == pytest.approx(0.8, abs=0.01)
        assert found.extremes == pytest.approx(sphere.extremes(centre, CAMERA)[0], abs=2e-3)
    assert np.abs(np.mean(gaps, axis=0)).max() < 0.003
    assert np.abs(gaps).max() < 0.01


def test_noise_and_eight_bits_leave_what_the_covariance_says() -> None:
    rng = np.random.default_rng(2)
    centre = np.array([40.0, -20.0, 300.0])
    image = render(centre)
    found = [
        camera.find_ball(np.clip(np.round(image + 3 * rng.standard_normal(SHAPE)), 0, 255), CAMERA) for _ in range(24)
    ]
    gaps = np.array([b.centre for b in found]) - centre
    deviation = np.sqrt(np.diag(found[0].covariance))
    assert found[0].noise == pytest.approx(3, rel=0.1)
    assert gaps.std(axis=0) == pytest.approx(deviation, rel=0.5)
    assert (np.abs(gaps.mean(axis=0)) < 4 * deviation / np.sqrt(len(gaps)) + 0.002).all()


def square() -> np.ndarray:
    image = np.full(SHAPE, 40.0)
    image[80:150, 100:190] = 200.0
    return image


@pytest.mark.parametrize(
    ("image", "text"),
    [
        (np.full(SHAPE, 40.0), "no ball can be seen"),
        (40 + 5 * np.random.default_rng(3).standard_normal(SHAPE), "no ball can be seen"),
        (render((-50.0, 0, 300), (50.0, 0, 300)), "2 things in the image could be the ball"),
        (render((-90.0, 0, 300)), "cut by the border"),
        (render((0.0, -70.0, 300)), "cut by the border"),
        (square(), "not round"),
        (render((0.0, 0, 2400.0)), "too small|no ball"),
    ],
    ids=["even", "noise", "two", "cut left", "cut above", "square", "far"],
)
def test_images_without_one_whole_ball_are_refused(image: np.ndarray, text: str) -> None:
    with pytest.raises(InputError, match=text) as caught:
        camera.find_ball(image, CAMERA, "x.png")
    assert caught.value.exit_code == 3
    assert caught.value.remedy


# --------------------------------------------------------------------------------------------------------- the board

CORNERS, SQUARE = (7, 5), 12.0


def board(turn: np.ndarray, origin: np.ndarray, fine: int = 4) -> np.ndarray:
    """Grey values of a chessboard whose first inner corner lies at `origin`."""
    offset = (np.arange(fine) + 0.5) / fine - 0.5
    u, v = np.meshgrid(*((np.arange(n)[:, None] + offset).ravel() for n in SHAPE[::-1]))
    x, y = rays(u, v, CAMERA)
    ray = np.stack([x, y, np.ones_like(x)], axis=-1)
    depth = turn[:, 2] @ origin / (ray @ turn[:, 2])
    on = (ray * depth[..., None] - origin) @ turn[:, :2] / SQUARE
    cell = np.floor(on).astype(int).sum(axis=-1) % 2
    there = ((on > -1) & (on < np.array(CORNERS))).all(axis=-1)
    grey = np.where(there & (cell == 0), 30.0, 220.0)
    grey = gaussian_filter(grey, 0.6 * fine)
    return grey.reshape(SHAPE[0], fine, SHAPE[1], fine).mean(axis=(1, 3))


@pytest.fixture(scope="module")
def boards() -> list[np.ndarray]:
    rng = np.random.default_rng(5)
    out = []
    for tilt in ([0.4, 0, 0], [-0.4, 0.1, 0], [0, 0.4, 0.1], [0.1, -0.4, 0], [0.3, 0.3, 0.2], [-0.3, 0.3, -0.2]):
        turn = Rotation.from_rotvec(tilt).as_matrix()
        middle = np.array([*rng.uniform(-12, 12, 2), rng.uniform(190, 230)])
        out.append(board(turn, middle - turn @ [3 * SQUARE, 2 * SQUARE, 0]))
    return out


def test_the_camera_is_calibrated_from_boards(boards: list[np.ndarray]) -> None:
    found = camera.calibrate(boards, CORNERS, SQUARE, 19.0)
    assert found.rms_px < 0.1
    assert found.camera.fx_px == pytest.approx(CAMERA.fx_px, rel=2e-3)
    assert found.camera.fy_px == pytest.approx(CAMERA.fy_px, rel=2e-3)
    assert found.camera.cx_px == pytest.approx(CAMERA.cx_px, abs=1.0)
    assert found.camera.cy_px == pytest.approx(CAMERA.cy_px, abs=1.0)
    assert found.camera.k1 == pytest.approx(CAMERA.k1, abs=0.02)


def test_images_without_a_board_are_refused(boards: list[np.ndarray]) -> None:
    with pytest.raises(InputError, match="no board with 7 x 5"):
        camera.calibrate([*boards[:3], render((0.0, 0, 300))], CORNERS, SQUARE, 19.0)
    with pytest.raises(InputError, match="too few"):
        camera.calibrate(boards[:2], CORNERS, SQUARE, 19.0)


def test_the_cameras_rotation_in_the_hand_is_found() -> None:
    rng = np.random.default_rng(6)
    turn = Rotation.from_rotvec([0.1, -0.2, 1.3]).as_matrix()
    hand = rng.uniform(-100, 100, (20, 3))
    ball, mount = np.array([30.0, 40.0, 500.0]), np.array([7.0, 8.0, 9.0])
    seen = (ball - hand - mount) @ turn
    found, rms = camera.hand_eye(hand, seen)
    assert found == pytest.approx(turn, abs=1e-12)
    assert rms < 1e-10
    with pytest.raises(InputError, match="lie on a line"):
        camera.hand_eye(np.outer(np.arange(5.0), [1, 2, 3]), np.outer(np.arange(5.0), [1, 2, 3]))


# -------------------------------------------------------------------------------------------------------- the command


def run(monkeypatch: pytest.MonkeyPatch, *arguments: object) -> int:
    monkeypatch.setattr(sys, "argv", ["deltacal", *map(str, arguments)])
    with pytest.raises(SystemExit) as end:
        cli.main()
    return int(end.value.code or 0)


def test_boards_then_balls_to_a_recording(
    boards: list[np.ndarray], tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    files = [tmp_path / f"board{k}.png" for k in range(len(boards))]
    for file, image in zip(files, boards, strict=True):
        cv2.imwrite(str(file), np.round(image).astype(np.uint8))
    given = ["--corners", "7x5", "--square", SQUARE, "--ball", 19]
    assert run(monkeypatch, "camera", "calibrate", *files, *given, "-o", tmp_path / "camera.toml") == 0
    centres = [scene(np.random.default_rng(k)) for k in (7, 8)]
    for k, centre in enumerate(centres):
        cv2.imwrite(str(tmp_path / f"ball{k}.png"), np.round(render(centre)).astype(np.uint8))
    table = tmp_path / "table.csv"
    table.write_text("q1_deg,q2_deg,q3_deg,image\n0,0,0,ball0.png\n1,2,3,ball1.png\n")
    asked = ("camera", "measure", tmp_path / "camera.toml", table, "-o", tmp_path / "recording.csv")
    assert run(monkeypatch, *asked) == 0
    lines = (tmp_path / "recording.csv").read_text().splitlines()
    assert lines[0] == "q1_deg,q2_deg,q3_deg,u1_px,u2_px,v1_px,v2_px"
    assert [float(x) for x in lines[2].split(",")[3:]] == pytest.approx(
        sphere.extremes(centres[1], CAMERA)[0].tolist(), abs=0.02
    )
    assert "sphere" in (tmp_path / "recording.toml").read_text()
    (tmp_path / "recording.csv").unlink()
    cv2.imwrite(str(tmp_path / "ball1.png"), np.full(SHAPE, 40, np.uint8))
    capsys.readouterr()
    assert run(monkeypatch, *asked) == 3
    assert "ball1.png" in capsys.readouterr().err.replace("\n", "")
    assert not (tmp_path / "recording.csv").exists()
