"""Pages: self-contained, escaped, and they say what a diagnosis says, whatever its verdict and kind of readings."""

from __future__ import annotations

import copy
import dataclasses
import json
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import read_robot
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.pages import figures, report
from deltacal_gen.pages.left import Left
from deltacal_gen.physics.terms import effect_names, load_effect
from deltacal_gen.results.diagnosis import Diagnosis, Location, Verdict
from deltacal_gen.results.reader import read_result
from tests.support.html import assert_self_contained, words
from tests.support.left_out import machine, record

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.fixture(scope="module")
def diagnosed() -> dict[str, Any]:
    folder = example("gearbox")
    found = dc.diagnose(folder / "robot.toml", folder / "recording.csv")
    done: dict[str, Any] = json.loads(found.to_json())
    return done


@pytest.fixture
def found(diagnosed: dict[str, Any]) -> dict[str, Any]:
    return copy.deepcopy(diagnosed)


def without_effects(verdict: str) -> Diagnosis:
    folder = example("gearbox")
    robot = read_robot(folder / "robot.toml")
    found = diagnose(robot, read_recording(folder / "recording.csv", mechanism_of(robot)))
    nothing = Location(channels=(), limbs=(), region=None, text="the residual depends on nothing")
    return dataclasses.replace(found, effects=(), location=nothing, verdict=Verdict(verdict)).answer()


@pytest.mark.walk
def test_the_page_says_what_was_found_and_what_to_do(found: dict[str, Any]) -> None:
    page = report.diagnosis(read_result(found))
    assert_self_contained(page)
    text = words(page)
    (p,) = found["effects"][0]["parameters"]
    assert "Backlash at limb 2" in text
    assert load_effect("backlash").ADVICE in text
    assert text.count(report.measured(p["value"], p["std"])) == 1
    assert found["summary"] in text
    assert f"{found['baseline']['heldout_rms_mm']:.4f}" in text
    for rival in found["rejected"]:
        assert rival["name"].replace("_", " ") in text
    for other in found["not_tested"]:
        assert other["name"].replace("_", " ") in text
    assert page.count("<svg") == 5  # the bars, the channel and the map, before and after


@pytest.mark.walk
def test_what_the_effect_does_is_shown_on_the_joint_that_has_it(found: dict[str, Any]) -> None:
    picked = read_result(found).residuals.partial  # type: ignore[union-attr]
    assert picked is not None
    assert (picked.of, picked.unit, picked.title) == ("error of joint 2", "deg", "without backlash")
    approach = np.array(found["residuals"]["channels"]["approach2"])
    half = found["effects"][0]["parameters"][0]["value"] / 2
    assert picked.before[approach > 0].mean() == pytest.approx(-half, abs=0.001)
    assert picked.before[approach < 0].mean() == pytest.approx(half, abs=0.001)
    assert np.abs(picked.after).max() < 0.4 * half


@pytest.mark.walk
@pytest.mark.parametrize("verdict", ["adequate", "unexplained"])
def test_a_page_without_effects(verdict: str) -> None:
    page = report.diagnosis(without_effects(verdict))
    assert_self_contained(page)
    assert "What was found" not in words(page)
    assert page.count("<svg") == 2


@pytest.mark.walk
def test_what_to_measure_next_is_a_table_to_type_in(found: dict[str, Any]) -> None:
    poses = [{"pose": "next1", "q1_deg": 1.25, "payload_kg": 3.0}, {"pose": "next2", "q1_deg": -7.5, "payload_kg": 0.0}]
    found["next_measurements"] = [
        {"why": "separates A from B", "text": "Measure these.", "poses": poses, "expected_chi2": 81.4}
    ]
    text = words(report.diagnosis(read_result(found)))
    assert "Separates A from B. Measure these. Expected difference in chi²: 81." in text
    assert "pose q1_deg payload_kg next1 1.25 3.0 next2 -7.5 0.0" in text


@pytest.mark.walk
def test_what_is_written_in_files_is_not_code(found: dict[str, Any]) -> None:
    found["robot"]["robot"]["name"] = "<script>cell</script> & co"
    found["gross_errors"] = [7, 9]
    page = report.diagnosis(read_result(found))
    assert_self_contained(page)
    assert "&lt;script&gt;cell" in page
    assert "Outliers in lines 7, 9." in words(page)


@pytest.mark.walk
def test_readings_of_one_number_have_no_map() -> None:
    robot = machine()
    found = diagnose(robot, record(robot, kind="distance")).answer()
    assert "over the workspace" not in words(report.diagnosis(found))
    assert found.residuals.partial is not None
    assert (found.residuals.partial.of, found.residuals.partial.unit) == ("residual", "mm")


def test_a_page_of_an_older_answer_has_no_partial_residuals(found: dict[str, Any]) -> None:
    del found["residuals"]["partial"]
    page = report.diagnosis(read_result(found))
    assert_self_contained(page)
    assert page.count("<svg") == 3


@pytest.mark.parametrize(
    ("value", "std", "shown"),
    [
        (0.0501545, 0.000361, "0.05015 ± 0.00036"),
        (-12.3456, 1.7, "-12.3 ± 1.7"),
        (12345.6, 170.0, "12346 ± 170"),
        (1.17e-5, 2.3e-7, "(1.170 ± 0.023)·10⁻⁵"),
        (3.0, None, "3"),
    ],
)
def test_values_carry_two_digits_of_their_deviation(value: float, std: float | None, shown: str) -> None:
    assert report.measured(value, std) == shown


def test_every_effect_comes_with_advice() -> None:
    for name in effect_names():
        assert load_effect(name).ADVICE.endswith("."), name


def test_channels_have_names_for_readers() -> None:
    assert figures.channel_label("approach2") == "direction in which joint 2 last moved"
    assert figures.channel_label("qd3_deg_s") == "speed of joint 3, deg/s"
    assert figures.channel_label("q1_mm") == "joint 1, mm"
    assert figures.channel_label("temp_C") == "temperature, °C"
    assert figures.channel_label("humidity") == "humidity"


@pytest.mark.walk
def test_one_sheet_as_a_file(found: dict[str, Any], tmp_path: Any) -> None:
    for name, data in {"a.svg": found, "b.svg": found, "c.svg": without_effects("adequate")}.items():
        figures.write(read_result(data), tmp_path / name)
    assert (tmp_path / "a.svg").read_bytes() == (tmp_path / "b.svg").read_bytes()
    assert "cell 7: no model error found" in (tmp_path / "c.svg").read_text()


def test_the_page_of_a_calibration_shows_what_is_left_where_its_fit_is_known(tmp_path: Any) -> None:
    folder, page = example(), tmp_path / "page.html"
    found = dc.identify(folder / "robot.toml", folder / "recording.csv", model="32", report=page)
    said = page.read_text()
    for title in (
        "In the order of the recording",
        "Distribution of the residuals",
        "Where it was measured, from the side",
    ):
        assert title in said
    assert "Residuals of the readings" not in report.calibration(found.replace(residuals=None))
    assert "Corrected commands" in said


def test_what_is_far_off_does_not_stretch_the_scale() -> None:
    errors = np.full((100, 3), 0.01)
    errors[7] = 5.0
    left = Left(errors, np.arange(2, 102), np.zeros((100, 3)), (9,), 0.01, "mm")
    assert left.size[7] > 8 > 0.05 > left.top > left.size[0]
    assert left.views == ()  # one place


def test_a_printer_is_told_how_its_lines_are_written() -> None:
    folder = example("linear_delta")
    printer = dc.import_klipper(folder / "printer.cfg")
    found = dc.identify(printer.robot, printer.recordings["mesh_default"])
    said = words(report.calibration(found))
    assert "--export klipper" in said
    assert "targets.csv" not in said
    assert "with a bed as flat" in said
    assert "would make" not in said
