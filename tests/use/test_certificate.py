"""Certificates: errors before and after, an uncertainty budget that holds, a page and a DCC that say the same."""

from __future__ import annotations

import json
import shutil
import xml.etree.ElementTree as ET
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.errors import InputError
from deltacal_gen.files.recording import read_recording
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.pages.certificate import certificate as page_of
from deltacal_gen.pages.dcc import dcc
from deltacal_gen.physics.factors import quantile
from deltacal_gen.use import bands
from deltacal_gen.use.prediction import predict
from tests.support.commands import Run
from tests.support.dcc_structure import DCC, SI, flaws
from tests.support.html import assert_self_contained, words

DELTA = example()
ROBOT = DELTA / "robot.toml"
ABOUT = """
[laboratory]
name = "Service & Sons <Ltd>"
city = "Aachen"
country = "DE"
[machine]
serial = "D-42"
[calibration]
number = "2026-17"
begin = 2026-01-16
end = 2026-01-17
place = "customer"
"""


@pytest.fixture(scope="module")
def result() -> dc.Result:
    return dc.identify(ROBOT, DELTA / "recording.csv", model="delta/24")


@pytest.fixture(scope="module")
def other(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return readings of another day, of which half the poses were read twice."""
    folder = tmp_path_factory.mktemp("other")
    rng = np.random.default_rng(3)
    rows = [(f"p{k}", *(rng.uniform(-300, 300, 2)), rng.uniform(-950, -750), 20 + k / 10) for k in range(40)]
    lines = [",".join(map(str, row)) for row in rows + rows[:20]]
    (folder / "poses.csv").write_text("pose,x_mm,y_mm,z_mm,temp_C\n" + "\n".join(lines) + "\n")
    (folder / "poses.toml").write_text(
        '[measurement]\nkind = "position"\nframe = "unknown"\ninstrument = "tracker 7"\n'
    )
    truth = DELTA / "truth.toml"
    dc.simulate(ROBOT, folder / "poses.csv", output=folder / "other.csv", truth=truth, noise=0.005, seed=5)
    return folder / "other.csv"


@pytest.fixture(scope="module")
def found(result: dc.Result, other: Path) -> dc.Certificate:
    (other.parent / "about.toml").write_text(ABOUT)
    return dc.certificate(result, other, about=other.parent / "about.toml")


def test_before_is_what_a_best_fitting_frame_leaves_of_the_drawing(found: dc.Certificate, other: Path) -> None:
    robot = dc.read_robot(ROBOT)
    given = read_recording(other, mechanism_of(robot))
    drawn = dc.Compensator(robot).pose(given.joints)[0][:, :3]
    a, b = drawn - drawn.mean(axis=0), given.measured - given.measured.mean(axis=0)
    U, _, Vt = np.linalg.svd(a.T @ b)
    turn = U @ np.diag([1, 1, np.sign(np.linalg.det(U @ Vt))]) @ Vt
    left = np.linalg.norm(b - a @ turn, axis=1)
    assert found.before.rms_mm == pytest.approx(np.sqrt(np.mean(left**2) / 3), rel=1e-6)
    assert found.before.mean_mm == pytest.approx(left.mean(), rel=1e-6)
    assert found.before.worst_mm == pytest.approx(left.max(), rel=1e-6)


def test_after_is_what_validate_says(found: dc.Certificate, result: dc.Result, other: Path) -> None:
    said = dc.validate(result, other)
    assert (found.after.rms_mm, found.after.worst_mm) == (said.rms_mm, said.worst_mm)
    assert (found.iso9283, found.placed) == (said.iso9283, said.placed)
    assert found.readings == 60


def test_the_parts_of_the_budget_make_up_the_bands(result: dc.Result, other: Path) -> None:
    robot = dc.read_robot(ROBOT)
    recording = read_recording(other, mechanism_of(robot))
    recording = recording.subset(slice(0, 5))
    known = result.replace(instrument=result.instrument.replace(setups=recording.setup_names))
    done = predict(known, recording)
    parts = bands.parts(known, recording, done, "delta/24")
    ends = bands.predicted_bands(known, recording, done)
    half = (ends["x_hi_mm"] - ends["x_lo_mm"]) / 2 / quantile(bands.known_of(known).degrees)
    assert np.sqrt(sum(part**2 for part in parts))[:, 0] == pytest.approx(half)
    assert (parts.left_out > 0).all()
    assert (parts.left_out > 3 * parts.identified).all()  # a model of 24 leaves out what turns the platform


def test_the_budget_adds_up_and_holds(found: dc.Certificate) -> None:
    budget = found.budget
    assert budget.sigma_mm**2 == pytest.approx(sum(c.sigma_mm**2 for c in budget.contributions))
    assert sum(c.share for c in budget.contributions) == pytest.approx(1)
    assert budget.expanded_mm == pytest.approx(budget.factor * budget.sigma_mm)
    assert budget.machine_mm**2 == pytest.approx(budget.expanded_mm**2 - (budget.factor * 0.005) ** 2)
    assert [c.evaluation for c in budget.contributions] == ["B", "A", "A", "A"]
    assert 0.9 <= budget.within <= 1.0  # of 180 scalars 95 % are meant to
    assert budget.factor == pytest.approx(1.96, abs=0.01)


def test_a_model_that_is_all_there_leaves_nothing_out(other: Path) -> None:
    full = dc.certificate(dc.identify(ROBOT, DELTA / "recording.csv", model="delta/42"), other)
    assert not any("leaves out" in c.source for c in full.budget.contributions)
    assert full.identifier.startswith("deltacal-")
    assert full.performed is None


def test_page_and_digital_certificate_say_what_the_answer_says(found: dc.Certificate) -> None:
    page, xml = page_of(found), dcc(found)
    assert_self_contained(page)
    for said in ("2026-17", "D-42", "tracker 7", "2026-01-16 to 2026-01-17", "temperature 20 to 23.9 degC", "AP, mean"):
        assert said in words(page)
    assert "Service &amp; Sons &lt;Ltd&gt;" in page
    assert flaws(xml) == []
    tree = ET.fromstring(xml)
    values = [float(e.text or "") for e in tree.iterfind(f".//{SI}real/{SI}value")]
    assert found.before.rms_mm in values
    assert found.after.rms_mm in values
    assert float(tree.findtext(f".//{SI}valueExpandedMU") or "") == found.budget.expanded_mm
    hashes = " ".join(e.text or "" for e in tree.iterfind(f".//{DCC}declaration/{DCC}content"))
    for file in (*found.made.inputs, *(found.fitted.inputs if found.fitted else ())):
        assert file.sha256 in hashes
        assert file.sha256 in page


def test_a_digital_certificate_stands_whatever_a_machine_is_called(found: dc.Certificate) -> None:
    for name in ("\x00\x07", " ", "<&>'\"", "Ünïcode 機械"):
        assert flaws(dcc(found.replace(machine=name, instrument=name, serial=name, conditions=()))) == []


@pytest.mark.parametrize(
    "damage",
    [
        ("<dcc:uniqueIdentifier>2026-17</dcc:uniqueIdentifier>", ""),
        ("<dcc:countryCodeISO3166_1>DE", "<dcc:countryCodeISO3166_1>Germany"),
        (r"\milli\metre", "mm"),
        ('schemaVersion="3.3.0"', 'schemaVersion="2.4.0"'),
        ("coverageFactor", "coveragefactor"),
    ],
)
def test_the_check_of_structure_sees_what_is_against_the_schema(found: dc.Certificate, damage: tuple[str, str]) -> None:
    assert flaws(dcc(found).replace(*damage)) != []


def test_readings_of_another_kind_are_certified_in_their_own_unit(tmp_path: Path) -> None:
    (tmp_path / "robot.toml").write_text('[robot]\nname = "arms"\nmechanism = "delta"\n')
    rows = [f"{k},{k * 7 % 60},{k * 11 % 50},{k * 13 % 40}" for k in range(40)]
    (tmp_path / "poses.csv").write_text("\n".join(["pose,q1_deg,q2_deg,q3_deg", *rows]) + "\n")
    (tmp_path / "poses.toml").write_text('[measurement]\nkind = "encoder"\nsigma_deg = 0.01\n')
    robot, readings = dc.read_robot(tmp_path / "robot.toml"), tmp_path / "readings.csv"
    dc.simulate(robot, tmp_path / "poses.csv", output=readings, noise=0.01, seed=1)
    given = read_recording(readings, mechanism_of(robot))
    found = dc.certificate(dc.identify(robot, given.subset(slice(20))), given.subset(slice(20, 40)))
    assert (found.unit, found.kind) == ("deg", "encoder")
    assert found.unit_mm is not None
    assert found["after"]["rms_deg"] == pytest.approx(0.01, rel=0.2)
    assert f"calibrated by {found['after']['rms_deg']:.4f} deg" in page_of(found)
    assert flaws(dcc(found)) == []


def test_one_coordinate_is_certified_as_one(tmp_path: Path) -> None:
    axis = '[robot]\nname = "axis"\nmechanism = "serial"\n[[joint]]\nkind = "prismatic"\n'
    (tmp_path / "robot.toml").write_text(axis + "".join(f"{key} = 0.0\n" for key in ("a", "alpha", "d", "theta")))
    stops = [*range(0, 501, 25), *range(500, -1, -25)]
    for day in (1, 2):
        rng = np.random.default_rng(day)
        rows = [f"{c},{q},{q + 3 + 0.001 * rng.standard_normal():.6f}" for c in range(3) for q in stops]
        (tmp_path / f"{day}.csv").write_text("\n".join(["cycle,q1_mm,x_mm", *rows]) + "\n")
        (tmp_path / f"{day}.toml").write_text('[measurement]\nkind = "position"\nsigma_mm = 0.001\n')
    found = dc.certificate(dc.identify(tmp_path / "robot.toml", tmp_path / "1.csv"), tmp_path / "2.csv")
    assert found.iso230 is not None
    assert found.after.rms_mm == pytest.approx(0.001, rel=0.2)
    assert found.budget.within == pytest.approx(0.95, abs=0.04)
    assert "ISO 230-2, 19 positions" in page_of(found)


def test_the_command_writes_both_files(run: Run, result: dc.Result, other: Path, tmp_path: Path) -> None:
    (tmp_path / "result.json").write_text(result.to_json())
    code, out, _ = run("certificate", tmp_path / "result.json", other, "-o", tmp_path / "c.html")
    assert code == 0
    assert "machine and instrument, as identified" in out
    assert (tmp_path / "c.html").read_text().startswith("<!doctype html>")
    assert flaws((tmp_path / "c.xml").read_text()) == []
    code, out, _ = run("certificate", tmp_path / "result.json", other, "-o", tmp_path / "c.html", "--json")
    assert json.loads(out)["schema"] == "deltacal.certificate/1"


@pytest.mark.parametrize(
    ("about", "message"),
    [
        ('[laboratory]\nnam = "x"\n', r"about.toml.*2.*'nam' in \[laboratory\] is not known. Did you mean 'name'"),
        ('[laboratory]\ncountry = "Germany"\n', "line 2|:2"),
        ("[calibration]\nbegin = 2026-02-02\nend = 2026-02-01\n", "ends before it begins"),
    ],
)
def test_what_cannot_be_said_of_a_certificate_is_refused(
    result: dc.Result, other: Path, tmp_path: Path, about: str, message: str
) -> None:
    (tmp_path / "about.toml").write_text(about)
    with pytest.raises(InputError, match=message):
        dc.certificate(result, other, about=tmp_path / "about.toml")


def test_readings_of_the_fit_are_no_check_of_it(result: dc.Result, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="made of these readings"):
        dc.certificate(result, DELTA / "recording.csv", output=tmp_path / "c.html")
    assert not [*tmp_path.iterdir()]


@pytest.mark.parametrize("name", ["own.txt", "own.CSV", "own.tsv"])
def test_readings_of_the_fit_are_told_by_any_ending(tmp_path: Path, name: str) -> None:
    shutil.copyfile(DELTA / "recording.csv", tmp_path / name)
    shutil.copyfile(DELTA / "recording.toml", tmp_path / "own.toml")
    fitted = dc.identify(ROBOT, tmp_path / name, model="18")
    with pytest.raises(InputError, match="made of these readings"):
        dc.certificate(fitted, tmp_path / name, output=tmp_path / "c.html")


def test_a_result_without_uncertainty_is_refused(other: Path) -> None:
    older = dc.identify(ROBOT, DELTA / "recording.csv", model="18").replace(uncertainty=None)
    with pytest.raises(InputError, match="says nothing of its uncertainty"):
        dc.certificate(older, other)
