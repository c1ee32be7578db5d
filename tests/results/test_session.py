"""Answers and inputs as people meet them in a Python session or a notebook."""

from __future__ import annotations

from typing import Any

import numpy as np
import pandas as pd
import pyarrow as pa
import pytest
import xarray as xr

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.files.recording import recording_of
from deltacal_gen.results.document import Table, Text

DELTA = example().parent / "delta"
GEARBOX = example().parent / "gearbox" / "recording.csv"


@pytest.fixture(scope="module")
def result() -> dc.Result:
    return dc.identify(DELTA / "robot.toml", DELTA / "recording.csv", model="18")


@pytest.fixture(scope="module")
def diagnosis() -> dc.Diagnosis:
    return dc.diagnose(DELTA / "robot.toml", DELTA / "recording.csv", model="18")


def test_an_answer_shows_itself_in_a_line_and_in_a_table(result: dc.Result, diagnosis: dc.Diagnosis) -> None:
    validation = dc.validate(result, DELTA / "recording.csv")
    plan = dc.plan(DELTA / "robot.toml", model="18", n_max=4)
    comparison = dc.compare(result, result)
    for answer in (result, diagnosis, validation, plan, comparison):
        assert repr(answer).startswith(f"<{type(answer).__name__}: ")
        assert "\n" not in repr(answer)
        assert len(repr(answer)) < 1000
        told = list(answer.document())
        tables = [part for part in told if isinstance(part, Table)]
        assert answer._repr_html_().count("<tr>") == sum(1 + len(table.rows) for table in tables)
        assert answer._repr_html_().count("<p>") == len(told) - len(tables)
        assert all(part.words in str(answer) for part in told if isinstance(part, Text))
    assert [row[0] for row in next(p for p in result.document() if isinstance(p, Table)).rows] == [
        p.name for p in result.table()
    ]
    assert "of 18 parameters identified" in repr(result)


def test_a_table_is_a_data_frame(result: dc.Result) -> None:
    frame = result.to_dataframe()
    assert isinstance(frame, pd.DataFrame)
    assert list(frame.columns) == ["name", "value", "std", "unit", "status", "meaning"]
    assert frame.set_index("name")["value"]["L_1"] == next(p.value for p in result.parameters if p.name == "L_1")


def test_html_is_escaped(result: dc.Result) -> None:
    assert "<script>" not in result.replace(model="<script>")._repr_html_()


def test_data_frames_and_xarray_are_recordings(result: dc.Result) -> None:
    frame = pd.read_csv(DELTA / "recording.csv", comment="#")
    frame.attrs["measurement"] = {"sigma_mm": 0.005}
    dataset = xr.Dataset.from_dataframe(frame).assign_attrs(measurement={"sigma_mm": 0.005})
    for given in (frame, dataset):
        again = dc.identify(DELTA / "robot.toml", given, model="18")
        assert again.train_rms_mm == result.train_rms_mm
        assert again.sigma_mm == result.sigma_mm
    frame.attrs["measurement"] = {"sigma": 0.005}
    with pytest.raises(dc.InputError, match="Did you mean 'sigma_"):
        dc.identify(DELTA / "robot.toml", frame, model="18")
    frame.attrs.clear()
    with pytest.raises(dc.InputError, match=r"data frame, line 3, column 'q2_deg'"):
        dc.identify(DELTA / "robot.toml", frame.assign(q2_deg=frame["q2_deg"].where(frame.index != 2)), model="18")


def test_a_compensator_of_a_result_is_that_of_its_machine(result: dc.Result) -> None:
    targets = np.array([[0.0, 0.0, -853.0], [300.0, -200.0, -900.0]])
    assert np.degrees(dc.Compensator(result).joints(targets)) == pytest.approx(dc.compensate(result, targets))
    assert dc.compensate(result, np.zeros((0, 3))).shape == (0, 3)


def test_a_misspelt_channel_is_an_error(result: dc.Result) -> None:
    with pytest.raises(dc.UsageError, match=r"no channel 'payload'\. Did you mean 'payload_kg'"):
        dc.compensate(result, np.array([[0.0, 0.0, -853.0]]), channels={"payload": 2.0})


@pytest.mark.parametrize(
    ("channels", "message"),
    [
        ({"payload_kg": -3.0}, "'payload_kg' holds -3: a mass cannot be negative"),
        ({"approach2": [1.0, 5.0]}, "'approach2' holds 5: 1 or -1 was expected"),
        ({"temp_C": np.inf}, "'temp_C': a finite number was expected"),
        ({"temp_C": [20.0, 21.0, 22.0]}, "'temp_C': a number, or 2 of them, one for each target, were expected"),
        ({"temp_C": "warm"}, "'temp_C': a number, or 2 of them"),
    ],
)
def test_a_channel_that_cannot_be_is_an_error(result: dc.Result, channels: dict[str, Any], message: str) -> None:
    targets = np.array([[0.0, 0.0, -853.0], [300.0, -200.0, -900.0]])
    with pytest.raises(dc.UsageError, match=message):
        dc.compensate(result, targets, channels=channels)
    blank = dc.compensate(result, targets, channels={"approach2": [0.0, np.nan], "payload_kg": 2.0})
    assert np.array_equal(blank, dc.compensate(result, targets))


def test_a_data_frame_is_read_as_its_file_is() -> None:
    delta, frame = dc.load_mechanism("delta"), pd.read_csv(GEARBOX)
    want = dc.read_recording(GEARBOX, delta)
    same: list[Any] = [
        frame.set_index("pose"),
        frame.rename(columns={"x_mm": "X [mm]", "q1_deg": " Q1 (deg) "}),
        frame.drop(columns="temp_C").assign(temp_K=frame["temp_C"] + 273.15),
        frame.drop(columns="payload_kg").assign(payload_g=1000 * frame["payload_kg"]),
        frame.drop(columns="time_s").assign(timestamp=pd.to_datetime(frame["time_s"], unit="s")),
        pa.Table.from_pandas(frame),
    ]
    for given in same:
        found = recording_of(given, delta)
        assert found.pose.tolist() == want.pose.tolist()
        assert found.measured == pytest.approx(want.measured)
        assert set(found.channels) == set(want.channels)
        for name, values in want.channels.items():
            assert found.channels[name] == pytest.approx(values), name


def test_mistakes_of_a_data_frame_are_told() -> None:
    delta, frame = dc.load_mechanism("delta"), pd.read_csv(GEARBOX)
    with pytest.raises(dc.InputError, match=r"column 'x_mm': the name stands over columns 5 and 14"):
        recording_of(pd.concat([frame, frame[["x_mm"]]], axis=1), delta)
    with pytest.raises(dc.InputError, match=r"data frame: there is no row"):
        recording_of(frame.iloc[:0], delta)
    attrs: list[tuple[dict[str, Any], str]] = [
        ({"measurment": {"sigma_mm": 0.01}}, "Did you mean 'measurement'"),
        ({"sigma_mm": 0.01}, r"It belongs to \[measurement\]"),
        ({"contacts": {"distance": []}}, r"'distance' in \[contacts\]"),
    ]
    for said, told in attrs:
        frame.attrs = said
        with pytest.raises(dc.InputError, match=told):
            recording_of(frame, delta)
    frame.attrs = {"title": "of another program", "instrument": 7, "camera": "in the hall"}
    assert recording_of(frame, delta).n_rows == len(frame)


def test_targets_of_a_data_frame_count_by_name(result: dc.Result) -> None:
    targets = np.array([[0.0, 0.0, -853.0], [30.0, -20.0, -900.0]])
    want = dc.compensate(result, targets)
    frame = pd.DataFrame(targets, columns=["x_mm", "y_mm", "z_mm"])
    metres = (frame / 1000).rename(columns=lambda name: name.replace("mm", "m"))
    for given in (frame, frame[["z_mm", "x_mm", "y_mm"]], frame.assign(pose=["a", "b"]), metres, pd.DataFrame(targets)):
        assert dc.compensate(result, given) == pytest.approx(want)
    with pytest.raises(dc.InputError, match="'z_mm': the column is missing"):
        dc.compensate(result, frame[["x_mm", "y_mm"]])


def test_an_array_that_holds_no_targets_is_told(result: dc.Result) -> None:
    targets = np.array([[0.0, 0.0, -853.0], [30.0, -20.0, -900.0]])
    wrong: list[tuple[Any, str]] = [
        (targets[0], r"the shape \(3,\); \(N, 3\) mm is expected"),
        (targets.T, r"the shape \(3, 2\)"),
        (np.ma.masked_greater(targets, 20.0), "target 2 is not a finite number"),
        (np.where(targets > 20.0, np.nan, targets), "target 2 is not a finite number"),
        (targets * 1j, "of no real numbers"),
        ([[1, 2, 3], [1, 2]], "a list of no real numbers"),
    ]
    for given, told in wrong:
        with pytest.raises(dc.UsageError, match=told):
            dc.compensate(result, given)
