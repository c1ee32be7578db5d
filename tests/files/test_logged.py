"""What loggers make of samples is put right and told: rows of zeros, rows written twice, counts without a sign."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.motion import kinds
from tests.support.motion_recordings import NOISE, STEP, named, robot, usual, written

Q, TAU = slice(2, 5), slice(5, 8)
USUAL = {"coulomb_friction": [1, 2], "viscous_friction": [1, 3]}
Change = Callable[[list[list[str]]], list[list[str]]]


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(tmp_path_factory.mktemp("logged"), usual, runs=3, seconds=8.0)


def logged(recorded: Path, folder: Path, change: Change, word: str = "tau{}_Nm") -> Path:
    """Write what a logger makes of a recording, beside its robot file."""
    head, *rows = [line.split(",") for line in recorded.read_text().splitlines()]
    head[TAU] = [word.format(i) for i in (1, 2, 3)]
    path = folder / "recording.csv"
    path.write_text("\n".join(",".join(row) for row in (head, *change(rows))) + "\n")
    for name in ("recording.toml", "robot.toml"):
        (folder / name).write_text(recorded.with_name(name).read_text())
    return path


def read(path: Path) -> Any:
    moving = kinds.in_motion(path)
    assert moving is not None
    return moving.read(robot())


def emptied(rows: list[list[str]]) -> list[list[str]]:
    """A buffer that is longer than the movement: zeros after the last run."""
    run, last = rows[-1][0], float(rows[-1][1])
    return rows + [[run, f"{last + STEP * (n + 1):.6f}", *["0.0"] * 6] for n in range(300)]


def thrice(rows: list[list[str]]) -> list[list[str]]:
    """A log that is written three times as often as anything is read."""
    return [[row[0], f"{float(row[1]) + n * STEP / 3:.6f}", *row[2:]] for row in rows for n in range(3)]


def held(rows: list[list[str]]) -> list[list[str]]:
    """Drives that are read every fourth time."""
    return [[*row[:5], *rows[n - n % 4][TAU]] for n, row in enumerate(rows)]


ODDITIES = [(emptied, "all zero"), (thrice, "joints are read"), (held, "drives are read")]


@pytest.mark.walk
@pytest.mark.parametrize(("change", "words"), ODDITIES)
def test_rows_that_say_nothing_new_are_left_out(recorded: Path, tmp_path: Path, change: Change, words: str) -> None:
    path = logged(recorded, tmp_path, change)
    found = dc.diagnose(tmp_path / "robot.toml", path)
    assert named(found) == USUAL
    assert max(found["final"]["heldout_rms_by_joint"]) < 1.1 * NOISE
    (said,) = found["motion"]["repairs"]
    assert words in said


def counts(code: Callable[[int], int]) -> Change:
    def change(rows: list[list[str]]) -> list[list[str]]:
        return [[*row[:5], *(str(code(round(5 * float(v)))) for v in row[TAU])] for row in rows]

    return change


CODES = [
    (lambda n: n % 2**16, "two's complement of 16 bits"),
    (lambda n: n % 2**32, "two's complement of 32 bits"),
    (lambda n: n if n >= 0 else 2**15 - n, "bit 15"),
    (lambda n: n if n >= 0 else 2**10 - n, "bit 10"),
]


@pytest.mark.parametrize(("code", "words"), CODES)
def test_counts_that_lost_their_sign_get_it_back(
    recorded: Path, tmp_path: Path, code: Callable[[int], int], words: str
) -> None:
    plain = read(logged(recorded, tmp_path, counts(lambda n: n), "drive{}"))
    assert not plain.repairs
    found = read(logged(recorded, tmp_path, counts(code), "drive{}"))
    assert found.readings == pytest.approx(plain.readings)
    assert len(found.repairs) == (plain.readings < 0).any(axis=0).sum()
    assert all(words in said for said in found.repairs)


def coarse(rows: list[list[str]]) -> list[list[str]]:
    """Encoders and drives whose counts stay for several samples, and change by one."""
    return [
        [*row[:2], *(f"{round(float(v) / 2) * 2}" for v in row[Q]), *(f"{round(float(v) / 20) * 20}" for v in row[TAU])]
        for row in rows
    ]


def above(rows: list[list[str]]) -> list[list[str]]:
    """Counts that are positive, and large."""
    return [[*row[:5], *(str(round(float(v)) + 33000) for v in row[TAU])] for row in rows]


@pytest.mark.parametrize("change", [coarse, above])
def test_coarse_and_large_counts_stay_as_they_are(recorded: Path, tmp_path: Path, change: Change) -> None:
    found = read(logged(recorded, tmp_path, change))
    assert not found.repairs
    assert np.isfinite(found.readings).all()
    assert len(found.time) == len(read(recorded).time)


def test_overflow_is_left_out_however_often(recorded: Path, tmp_path: Path) -> None:
    spoilt = set(np.random.default_rng(0).choice(2400, 48, replace=False).tolist())

    def change(rows: list[list[str]]) -> list[list[str]]:
        return [[*row[:6], "32767", *row[7:]] if n in spoilt else row for n, row in enumerate(rows)]

    found = read(logged(recorded, tmp_path, change))
    assert set(np.flatnonzero(np.isnan(found.readings[:, 1]))) == spoilt
    assert all("out of all proportion" in said for said in found.repairs)


def test_rows_to_be_predicted_all_stay(recorded: Path, tmp_path: Path) -> None:
    result = dc.identify(recorded.with_name("robot.toml"), recorded)
    path = logged(recorded, tmp_path, thrice)
    assert len(dc.predict(result, path).time) == len(path.read_text().splitlines()) - 1
