"""Answers and inputs as people meet them in a Python session or a notebook."""

from __future__ import annotations

import numpy as np
import pandas as pd
import pytest
import xarray as xr

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example

DELTA = example().parent / "delta"


@pytest.fixture(scope="module")
def result() -> dc.Result:
    return dc.identify(DELTA / "robot.toml", DELTA / "recording.csv", model="18")


@pytest.fixture(scope="module")
def diagnosis() -> dc.Diagnosis:
    return dc.diagnose(DELTA / "robot.toml", DELTA / "recording.csv", model="18")


def test_an_answer_shows_itself_in_a_line_and_in_a_table(result: dc.Result, diagnosis: dc.Diagnosis) -> None:
    validation = dc.validate(result, DELTA / "recording.csv")
    plan = dc.plan(DELTA / "robot.toml", "18", n_max=4)
    comparison = dc.compare(result, result)
    for answer in (result, diagnosis, validation, plan, comparison):
        assert repr(answer).startswith(f"<{type(answer).__name__}: ")
        assert "\n" not in repr(answer)
        assert len(repr(answer)) < 1000
        assert str(answer).startswith(answer.headline)
        assert answer._repr_html_().count("<tr>") == (1 + len(answer.table()) if answer.table() else 0)
    assert result.summary().count("\n") == 1 + len(result.table())
    assert "of 18 parameters identified" in repr(result)


def test_a_table_is_a_data_frame(result: dc.Result) -> None:
    frame = result.to_dataframe()
    assert isinstance(frame, pd.DataFrame)
    assert list(frame.columns) == ["name", "value", "std", "unit", "status"]
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
