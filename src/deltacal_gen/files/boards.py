"""Points of a printed board in images, by OpenCV: chessboards, ChArUco boards, grids of circles."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.camera import opencv, read_image
from deltacal_gen.files.writing import csv_text, write_files
from deltacal_gen.machine.registry import Array

PATTERNS = ("chessboard", "charuco", "circles", "acircles")
MARKER = 0.7  # of a square of a ChArUco board, where nothing else is said
FEWEST = 4  # points of a ChArUco board that an image must show


@dataclass(frozen=True)
class Board:
    """A printed pattern.

    Attributes
    ----------
    pattern : {"chessboard", "charuco", "circles", "acircles"}
    columns, rows : int
        Inner corners of a chessboard, squares of a ChArUco board, circles; of asymmetric circles those of a row.
    pitch : float
        Side of a square, or distance of circles along a row (half of it, where rows are set off) [mm].
    dictionary : str
        Of ChArUco markers, as OpenCV calls it.
    """

    pattern: str
    columns: int
    rows: int
    pitch: float
    dictionary: str = "DICT_5X5_100"

    def __post_init__(self) -> None:
        if self.pattern not in PATTERNS:
            raise UsageError(f"there is no pattern '{self.pattern}'; known: {', '.join(PATTERNS)}.")
        if self.pattern == "chessboard" and (self.columns + self.rows) % 2 == 0:
            raise UsageError(
                f"a chessboard of {self.columns} x {self.rows} inner corners looks the same turned round: its points "
                "cannot be told from one another. Use one with an odd and an even number, such as 9x6."
            )

    @property
    def points(self) -> Array:
        """Where the points lie on the print (n, 2) [mm], in OpenCV's order."""
        j, i = np.mgrid[: self.rows, : self.columns]
        across = 2 * i + j % 2 if self.pattern == "acircles" else i
        return self.pitch * np.column_stack([across.ravel(), j.ravel()]).astype(float)

    def find(self, image: Array, name: Path | None = None) -> tuple[Array, Array]:
        """Return the points found in an image (n, 2) [px], and where they lie on the print (n, 2) [mm].

        Raises
        ------
        InputError
            The board cannot be seen.
        """
        cv2 = opencv()
        grey = np.round(255 * (image - image.min()) / max(float(np.ptp(image)), 1.0)).astype(np.uint8)
        found = self._charuco(cv2, grey) if self.pattern == "charuco" else self._grid(cv2, grey)
        if found is None:
            raise InputError(
                f"no {self.pattern} of {self.columns} x {self.rows} can be seen.",
                "Take the image with the board in view, or correct the numbers.",
                file=name,
            )
        return found

    def _grid(self, cv2: Any, grey: np.ndarray) -> tuple[Array, Array] | None:
        size = (self.columns, self.rows)
        if self.pattern != "chessboard":
            flag = cv2.CALIB_CB_ASYMMETRIC_GRID if self.pattern == "acircles" else cv2.CALIB_CB_SYMMETRIC_GRID
            there, circles = cv2.findCirclesGrid(grey, size, flags=flag)
            return (np.reshape(circles, (-1, 2)).astype(float), self.points) if there else None
        there, corners = cv2.findChessboardCorners(grey, size)
        if not there:
            return None
        corners = np.reshape(corners, (-1, 1, 2))
        half = max(int(np.linalg.norm(np.diff(corners[: self.columns, 0], axis=0), axis=1).min() / 3), 3)
        ending = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_COUNT, 100, 1e-4)
        corners = cv2.cornerSubPix(grey, corners, (half, half), (-1, -1), ending)
        image = np.reshape(corners, (-1, 2)).astype(float)
        return (image if self._dark_first(grey, image) else image[::-1]), self.points

    def _dark_first(self, grey: np.ndarray, corners: Array) -> bool:
        """Tell whether the square between the first corners is darker than the next one: turned round it is not."""
        grid = corners.reshape(self.rows, self.columns, 2)
        cells = (grid[:-1, :-1] + grid[1:, 1:] + grid[:-1, 1:] + grid[1:, :-1]) / 4
        u, v = np.clip(np.round(cells).astype(int), 0, np.array(grey.shape[::-1]) - 1).transpose(2, 0, 1)
        odd = np.add.outer(np.arange(self.rows - 1), np.arange(self.columns - 1)) % 2 == 1
        values = grey[v, u].astype(float)
        return bool(values[~odd].mean() < values[odd].mean())

    def _charuco(self, cv2: Any, grey: np.ndarray) -> tuple[Array, Array] | None:
        if not hasattr(cv2.aruco, self.dictionary):
            raise UsageError(f"OpenCV has no dictionary '{self.dictionary}'.")
        words = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, self.dictionary))
        board = cv2.aruco.CharucoBoard((self.columns, self.rows), self.pitch, MARKER * self.pitch, words)
        corners, ids, *_ = cv2.aruco.CharucoDetector(board).detectBoard(grey)
        if ids is None or len(ids) < FEWEST:
            return None
        points = np.asarray(board.getChessboardCorners(), dtype=float)[:, :2]
        return np.reshape(corners, (-1, 2)).astype(float), points[np.ravel(ids)]


def record(images: Sequence[Path], board: Board, output: Path, table: Path | None = None) -> tuple[int, list[Path]]:
    """Write the points of a board in images, one row each; return how many, and the images that do not show it.

    Parameters
    ----------
    table : path, optional
        CSV with the joints and any channels, and a column ``image``: then the file is a recording of the kind board
        image, and images are named by the table.

    Raises
    ------
    InputError
        No image shows the board, or the table names none.
    """
    given: list[dict[str, str]] = [{"image": str(path)} for path in images]
    if table is not None:
        with table.open(newline="", encoding="utf-8-sig") as stream:
            given = [{str(k): v for k, v in row.items()} for row in csv.DictReader(stream)]
        if not given or "image" not in given[0]:
            raise InputError("the table has no column 'image'.", "Name each row's image there.", file=table, line=1)
    columns: dict[str, list[Any]] = {}
    blind: list[Path] = []
    for number, row in enumerate(given, start=1):
        path = Path(row["image"]) if table is None else table.parent / row["image"]
        try:
            seen, printed = board.find(read_image(path), path)
        except InputError:
            if not path.exists():
                raise
            blind.append(path)
            continue
        kept = {"pose": str(number)} | (row if table is None else {k: v for k, v in row.items() if k != "image"})
        for name, value in kept.items():
            columns.setdefault(name, []).extend([value] * len(seen))
        for name, values in zip(("u_px", "v_px", "board_x_mm", "board_y_mm"), [*seen.T, *printed.T], strict=True):
            columns.setdefault(name, []).extend(np.round(values, 5).tolist())
    if not columns:
        raise InputError(f"none of {len(given)} images shows the board.", "Correct pattern and numbers.", file=table)
    texts = {output: csv_text(columns)}
    if table is not None:
        texts = {output.with_suffix(".toml"): '[measurement]\nkind = "board_image"\n', **texts}
    write_files(texts)
    return len(columns["u_px"]), blind
