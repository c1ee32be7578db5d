"""Answers in the hands of a programmer: what types promise holds, pictures show themselves, robots go in a circle."""

from __future__ import annotations

import subprocess
import sys

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.pages.figures import Sheet
from deltacal_gen.results.base import Answer
from deltacal_gen.results.written import Receipt
from tests.support import typed

DELTA = example("delta")


@pytest.fixture(scope="module")
def result() -> dc.Result:
    return dc.identify(DELTA / "robot.toml", DELTA / "recording.csv", model="delta/18")


def test_the_script_that_mypy_reads_runs() -> None:
    assert typed.main().moved is not None


def test_each_sort_of_answer_draws_itself(result: dc.Result) -> None:
    answers: list[Answer] = [
        result,
        dc.validate(result, DELTA / "recording.csv"),
        dc.plan(DELTA / "robot.toml", model="delta/3"),
        dc.compare(result, result),
        dc.study(DELTA / "robot.toml", plan=DELTA / "poses.csv", model="delta/3", trials=8, workers=1, noise=0.01),
    ]
    for answer in answers:
        sheet = dc.plot(answer)
        assert isinstance(sheet, Sheet)
        assert "</svg>" in sheet._repr_svg_(), answer
    with pytest.raises(dc.UsageError, match="no picture of a Receipt"):
        dc.plot(Receipt(command="simulate", summary="1 reading"))


def test_a_picture_leaves_the_backend_of_a_program_alone() -> None:
    script = (
        "import sys, deltacal_gen as dc\n"
        f"folder = {str(DELTA)!r}\n"
        "dc.plot(dc.plan(folder + '/robot.toml', model='delta/3'))\n"
        "assert 'matplotlib.pyplot' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", script], check=True)


def test_a_solver_is_given_as_an_object(result: dc.Result) -> None:
    by_name = dc.identify(DELTA / "robot.toml", DELTA / "recording.csv", model="delta/18", method="tsvd", truncation=10)
    given = dc.identify(DELTA / "robot.toml", DELTA / "recording.csv", model="delta/18", method=dc.TSVD(10, 0.005))
    assert given.replace(made=None) == by_name.replace(made=None)
    assert given.train_rms_mm > result.train_rms_mm


def test_the_robot_of_a_result_is_a_robot(result: dc.Result) -> None:
    again = dc.identify(result.robot, DELTA / "recording.csv", model="delta/18")
    assert again.before_rms_mm == pytest.approx(result.train_rms_mm, rel=0.05)
    assert repr(dc.read_robot(DELTA / "robot.toml")) == "<Robot 'prototype': delta>"


def test_recordings_and_compensators_are_short_in_a_session_and_frames_where_wanted(result: dc.Result) -> None:
    done = dc.predict(result, DELTA / "recording.csv")
    assert repr(done) == f"<Recording: {done.n_rows} readings of the kind position, recording.csv>"
    assert list(dc.to_dataframe(done))[:3] == ["pose", "q1_deg", "q2_deg"]
    assert repr(dc.Compensator(result)) == "<Compensator of 'prototype', exact: geometry>"


def test_an_array_is_no_recording() -> None:
    with pytest.raises(dc.UsageError, match="a ndarray is no recording"):
        dc.identify(DELTA / "robot.toml", np.zeros((4, 6)))  # type: ignore[arg-type]
