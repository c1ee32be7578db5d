"""What loggers make of samples of encoders, or of positions at rate: stamps and rows that come once more are told."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from deltacal_gen.errors import InputError
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import robot_from_dict, robot_to_toml
from deltacal_gen.files.writing import write_recording
from deltacal_gen.identification.identification import identify
from deltacal_gen.machine.values import Recording, Robot
from deltacal_gen.physics.motion import motion_of
from deltacal_gen.use import prediction, validation
from tests.support.commands import Run
from tests.support.second_encoder import DELTA, EACH, RUNS, UNDRAWN, read

Lines = list[list[str]]
STEP = 0.05  # s between the samples of these recordings


@pytest.fixture(scope="module")
def robot() -> Robot:
    return robot_from_dict(UNDRAWN)


def logged(made: Recording, folder: Path, change: Callable[[Lines], Lines]) -> Path:
    """Write what a logger makes of a recording, its columns run, time_s, joints and readings."""
    path = folder / "recording.csv"
    write_recording(made, path)
    head, *rows = [line.split(",") for line in path.read_text().splitlines()]
    order = [head.index(name) for name in ("run", "time_s", *(n for n in head if n not in ("run", "time_s", "pose")))]
    rows = change([[row[k] for k in order] for row in rows])
    path.write_text("\n".join(",".join(row) for row in ([head[k] for k in order], *rows)) + "\n")
    return path


def again(rows: Lines) -> Lines:
    """Some rows twice, with their time."""
    return [row for n, row in enumerate(rows) for _ in range(2 if n % 50 == 23 else 1)]


def late(rows: Lines) -> Lines:
    """Some rows with the time of the row before."""
    return [[row[0], rows[n - 1][1], *row[2:]] if n % 50 == 23 else row for n, row in enumerate(rows)]


def thrice(rows: Lines) -> Lines:
    """A log that is written three times as often as anything is read."""
    return [[row[0], f"{float(row[1]) + n * STEP / 3:.6f}", *row[2:]] for row in rows for n in range(3)]


def held(rows: Lines) -> Lines:
    """Encoders that are read every second time."""
    return [[*row[:5], *rows[n - n % 2][5:]] for n, row in enumerate(rows)]


def back(rows: Lines) -> Lines:
    return [*rows[:10], rows[11], rows[10], *rows[12:]]


def still(rows: Lines) -> Lines:
    return [[row[0], "1.5", *row[2:]] for row in rows]


def test_stamps_that_come_once_more_are_told_and_derivatives_stay(robot: Robot, tmp_path: Path) -> None:
    made = read(robot)
    plain = read_recording(logged(made, tmp_path, list), DELTA)
    assert not plain.repairs
    path = logged(made, tmp_path, again)
    found = read_recording(path, DELTA)
    assert len(found.repairs) == -(-(RUNS * EACH - 23) // 50)
    assert found.repairs[0] == f"{path}:26: the time of the row before once more; the row is left out"
    for one, other in ((found.joints, plain.joints), (found.measured, plain.measured)):
        assert np.array_equal(one, other)
    speeds = motion_of(found), motion_of(plain)
    assert speeds[0].keys() == speeds[1].keys() >= {"qd1_deg_s", "qdd3_deg_s2", "approach2"}
    assert all(np.array_equal(speeds[0][name], speeds[1][name]) for name in speeds[0])
    assert read_recording(logged(made, tmp_path, late), DELTA).n_rows == RUNS * EACH - len(found.repairs)


def test_rows_that_a_log_holds_are_left_out(robot: Robot, tmp_path: Path) -> None:
    made = read(robot)
    plain = read_recording(logged(made, tmp_path, list), DELTA)
    found = read_recording(logged(made, tmp_path, thrice), DELTA)
    assert np.array_equal(found.measured, plain.measured)
    assert found.time_s == pytest.approx(plain.time_s)
    (said,) = found.repairs
    assert f":3: joints and readings are what they were a row before, here and on {2 * RUNS * EACH - 1} rows" in said
    found = read_recording(logged(made, tmp_path, held), DELTA)
    assert np.array_equal(np.isfinite(found.measured[:, 0]), np.arange(RUNS * EACH) % 2 == 0)
    assert np.array_equal(found.joints, plain.joints)
    (said,) = found.repairs
    assert "more often than the instrument is read" in said


def test_repeats_at_rest_stay(robot: Robot, tmp_path: Path) -> None:
    def waits(rows: Lines) -> Lines:
        return [[*row[:2], *rows[n - n % 5][2:5], *row[5:]] for n, row in enumerate(rows)]

    found = read_recording(logged(read(robot), tmp_path, waits), DELTA)
    assert not found.repairs
    assert np.isfinite(found.measured).all()


@pytest.mark.parametrize(("change", "words"), [(back, "time goes backwards within run '0'"), (still, "stands still")])
def test_a_clock_that_runs_back_or_stands_is_an_error(
    robot: Robot, tmp_path: Path, change: Callable[[Lines], Lines], words: str
) -> None:
    with pytest.raises(InputError, match=words):
        read_recording(logged(read(robot), tmp_path, change), DELTA)


def test_what_was_put_right_stands_in_answers(run: Run, robot: Robot, tmp_path: Path) -> None:
    path = logged(read(robot), tmp_path, again)
    found = read_recording(path, DELTA)
    result = identify(robot, found).answer()
    assert result.motion is not None
    assert result.motion.repairs == found.repairs
    assert result.motion.cutoff_Hz is not None
    assert "no delay" in result.motion.text
    assert validation.validate(result, found).repairs == found.repairs
    (tmp_path / "robot.toml").write_text(robot_to_toml(robot))
    _, out, _ = run("identify", tmp_path / "robot.toml", path, "-o", tmp_path / "result.json")
    assert "once more; the row is left out" in " ".join(out.split())
    asked = read_recording(path, DELTA, need_measured=False)
    assert asked.n_rows == RUNS * EACH + len(found.repairs)  # every row is answered
    told = prediction.predict(result, asked).measured
    assert np.isfinite(told).all()


def test_rows_of_one_time_are_of_one_instant(robot: Robot) -> None:
    """Of several points that are read at a time each is a row: they hide no speed."""
    made = read(robot)
    twice = motion_of(made.subset(np.repeat(np.arange(made.n_rows), 2)))
    once = motion_of(made)
    assert all(np.array_equal(twice[name], np.repeat(values, 2)) for name, values in once.items())
    assert once


def test_positions_at_rate_are_put_right_without_runs(robot: Robot, tmp_path: Path) -> None:
    made = read(robot)
    made = dataclasses.replace(made.subset(np.arange(EACH)), kind="position", columns=("x_mm", "y_mm", "z_mm"))
    made = dataclasses.replace(made, measurement=dataclasses.replace(made.measurement, kind="position", sigma_deg=None))
    path = logged(made, tmp_path, again)
    path.write_text("\n".join(line.partition(",")[2] for line in path.read_text().splitlines()) + "\n")
    found = read_recording(path, DELTA)
    assert (found.kind, found.n_rows, len(found.repairs)) == ("position", EACH, 1)
