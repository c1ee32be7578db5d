"""Boards in rendered images: their points, in the print's own coordinates, however the board is turned."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.boards import Board
from deltacal_gen.machine.registry import Array
from tests.support.commands import Run

cv2 = pytest.importorskip("cv2")
WARP = np.array([[0.9, 0.08, 60.0], [-0.06, 0.85, 70.0], [1e-5, -2e-5, 1.0]])
SIDE = 40  # px of a square


def chessboard(columns: int, rows: int) -> Array:
    cells = np.add.outer(np.arange(rows + 1), np.arange(columns + 1)) % 2
    plain = np.kron(255 * (1 - cells), np.ones((SIDE, SIDE))).astype(np.uint8)
    return np.pad(plain, SIDE, constant_values=255)


def circles(places: Array) -> Array:
    plain = np.full((420, 520), 255, dtype=np.uint8)
    for u, v in places:
        cv2.circle(plain, (round(u), round(v)), 9, 0, -1, cv2.LINE_AA)
    return plain


def warped(plain: Array, turn: Array = WARP) -> Array:
    return np.asarray(cv2.warpPerspective(plain, turn, (640, 560), borderValue=255)).astype(float)


def mapped(points: Array, turn: Array = WARP) -> Array:
    out = np.hstack([points, np.ones((len(points), 1))]) @ turn.T
    return out[:, :2] / out[:, 2:]


def test_a_chessboard_s_points_keep_their_names_when_it_is_turned_round() -> None:
    plain = chessboard(6, 5)
    half = np.array([[-1.0, 0, plain.shape[1] - 1], [0, -1, plain.shape[0] - 1], [0, 0, 1]])
    kept = []
    for turn in (WARP, WARP @ half):
        image, printed = Board("chessboard", 6, 5, 25.0).find(warped(plain, turn))
        drawn = printed / 25.0 * SIDE + 2 * SIDE - 0.5
        off = [float(np.abs(image - mapped(points, turn)).max()) for points in (drawn, drawn[::-1])]
        assert min(off) < 0.3
        kept.append(off[0] < off[1])
    assert kept[0] == kept[1]


@pytest.mark.parametrize("pattern", ["circles", "acircles"])
def test_circles_are_found(pattern: str) -> None:
    board = Board(pattern, 4, 7, 20.0)
    drawn = board.points / 20.0 * SIDE + 80
    image, printed = board.find(warped(circles(drawn)))
    assert image.shape == printed.shape == (28, 2)
    gaps = np.linalg.norm(image[:, None] - mapped(drawn)[None], axis=2)
    assert gaps.min(axis=1).max() < 0.5


def test_charuco_corners_are_found_though_some_are_hidden() -> None:
    board = Board("charuco", 6, 5, 30.0)
    words = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_5X5_100)
    plain = cv2.aruco.CharucoBoard((6, 5), 30.0, 21.0, words).generateImage((480, 400), marginSize=0)
    seen = warped(plain)
    seen[:, :150] = 255
    image, printed = board.find(seen)
    assert 4 <= len(image) < 20
    assert image == pytest.approx(mapped(printed / 30.0 * 80 - 0.5), abs=1.0)


def test_what_cannot_be_told_is_refused() -> None:
    with pytest.raises(UsageError, match="looks the same turned round"):
        Board("chessboard", 7, 5, 25.0)
    with pytest.raises(UsageError, match="no pattern 'stars'"):
        Board("stars", 7, 5, 25.0)
    with pytest.raises(InputError, match="no chessboard of 6 x 5 can be seen"):
        Board("chessboard", 6, 5, 25.0).find(np.full((100, 100), 9.0))


def test_a_table_becomes_a_recording(run: Run, tmp_path: Path) -> None:
    cv2.imwrite(str(tmp_path / "a.png"), warped(chessboard(6, 5)))
    cv2.imwrite(str(tmp_path / "b.png"), np.full((200, 200), 255, dtype=np.uint8))
    (tmp_path / "joints.csv").write_text("q1_deg,q2_deg,q3_deg,image\n1,2,3,a.png\n4,5,6,b.png\n")
    options = ("--corners", "6x5", "--square", 25, "-o", tmp_path / "recording.csv")
    code, out, said = run("camera", "board", "--table", tmp_path / "joints.csv", *options)
    assert code == 0, said
    assert "30 points written" in out
    assert "b.png" in said.replace("\n", "")
    header, first, *_ = (tmp_path / "recording.csv").read_text().splitlines()
    assert header == "pose,q1_deg,q2_deg,q3_deg,u_px,v_px,board_x_mm,board_y_mm"
    assert first.startswith("1,1,2,3,")
    assert 'kind = "board_image"' in (tmp_path / "recording.toml").read_text()
