"""A kind of measurement is one file: those that the manual prints, put into a copy of the sources, are used as any."""

from __future__ import annotations

import dataclasses
import json
import shutil
from dataclasses import dataclass

import numpy as np
import pytest

from deltacal_gen.files.robot import robot_from_dict, robot_to_toml
from deltacal_gen.files.writing import write_recording
from tests.support.copies import Checkout, printed, untried
from tests.support.prototype import PROTOTYPE, scattered, wanted

pytestmark = pytest.mark.walk  # each derives what was added, and runs tests and commands on a copy

POSES, FITTED, NOISE, OPTIMAL = 130, 100, 0.005, 30
WITH_TRUTH = ("--truth", "truth.toml", "--noise", NOISE)
MODEL = ("--model", "24")
FEW = ("--trials", 10, "--noise", NOISE, "--workers", 1)
LINES: list[tuple[object, ...]] = [
    ("identify", "robot.toml", "seen.csv", "-o", "result.json", "--report", "result.html"),
    ("validate", "result.json", "new.csv", "--json"),
    ("diagnose", "robot.toml", "seen.csv", "-o", "diagnosis.json"),
    ("predict", "diagnosis.json", "blank.csv", "-o", "told.csv"),
    ("certificate", "result.json", "new.csv", "-o", "certificate.html"),
    ("compare", "result.json", "result.json"),
    ("next", "diagnosis.json", "-o", "next.csv"),
    ("matrix", "robot.toml", "seen.csv", *MODEL, "-o", "H.npz"),
    ("compensate", "diagnosis.json", "--export", "c", "-o", "command.c"),
]
MANY = {"batch"}  # command of the test that takes longer
OF_OTHERS = {"effects", "models"}  # those that list or show what no kind changes


def planned(name: str) -> list[tuple[object, ...]]:
    """Return lines that choose poses for a kind, simulate there, say what they will give, and show its equations."""
    return [
        ("plan", "robot.toml", *MODEL, "--kind", name, "-o", "rings.csv"),
        ("plan", "robot.toml", *MODEL, "--kind", name, "--optimal", OPTIMAL, "-o", "chosen.csv"),
        ("simulate", "robot.toml", "chosen.csv", "-o", "taken.csv", *WITH_TRUTH),
        ("study", "robot.toml", "--plan", "chosen.csv", *MODEL, *FEW, "-o", "study.json"),
        ("derivation", name, "-o", "page.md"),
    ]


@dataclass(frozen=True)
class Added:
    """The columns of a kind, and the smallest difference that its noise makes in them."""

    columns: tuple[str, ...]
    least: float


ADDED = {
    "probe": Added(("probe_mm",), NOISE),
    "level": Added(("lean_x_deg", "lean_y_deg"), NOISE / 100.0 * 57.3),
    "tracker": Added(("range_mm", "azimuth_deg", "elevation_deg"), NOISE),
}


@pytest.fixture(
    scope="module", params=["probe", *(pytest.param(n, marks=pytest.mark.thorough) for n in ("level", "tracker"))]
)
def added(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Checkout:
    """A copy of the sources to which the kinds' files were added, and readings of one that a simulation gives."""
    name, robot = str(request.param), robot_from_dict(PROTOTYPE)
    texts = {each: printed("add-measurement", each) for each in (name, *(ADDED.keys() - {name}))}
    made = Checkout.with_files(tmp_path_factory.mktemp("sources"), "measurements", texts)
    folder, case = made.folder, ADDED[name]
    (folder / "robot.toml").write_text(robot_to_toml(robot), encoding="utf-8")
    (folder / "truth.toml").write_text("[parameters]\ntheta_1 = 0.3\ntheta_2 = -0.2\ntheta_3 = 0.1\n", encoding="utf-8")
    write_recording(wanted(scattered(robot, POSES, 1), sigma_mm=NOISE), folder / "poses.csv")
    text = (folder / "poses.toml").read_text(encoding="utf-8")
    (folder / "poses.toml").write_text(text.replace('"position"', f'"{name}"'), encoding="utf-8")
    made.deltacal(("simulate", "robot.toml", "poses.csv", "-o", "read.csv", *WITH_TRUTH, "--seed", 1))
    header, *rows = (folder / "read.csv").read_text(encoding="utf-8").splitlines()
    blank = [",".join("" if c in case.columns else v for c, v in pairs(header, row)) for row in rows[FITTED:]]
    for part, kept in (("seen", rows[:FITTED]), ("new", rows[FITTED:]), ("blank", blank)):
        (folder / f"{part}.csv").write_text("\n".join([header, *kept]) + "\n", encoding="utf-8")
        shutil.copy(folder / "read.toml", folder / f"{part}.toml")
    return made


def pairs(header: str, row: str) -> list[tuple[str, str]]:
    """Return the cells of a row by their columns."""
    return list(zip(header.split(","), row.split(","), strict=True))


def test_every_shared_test_takes_it(added: Checkout) -> None:
    passed = added.passed()
    for name in ADDED:
        files = [test.partition("::")[0] for test in passed if name in test.partition("[")[2]]
        assert files.count("tests/kinds/test_kinds.py") >= 6
        assert "tests/derive/test_derivation.py" in files


@pytest.mark.thorough
def test_what_runs_over_all_kinds_takes_it(added: Checkout) -> None:
    assert "tests/derive/test_derivation.py::test_a_report_is_complete" in added.all_passed()


def test_every_command_takes_it(added: Checkout) -> None:
    name, folder = added.name, added.folder
    case, lines = ADDED[name], [*planned(name), *LINES]
    assert untried(*lines) == MANY | OF_OTHERS
    said = dict(zip((line[0] for line in lines), added.deltacal(*lines), strict=True))
    assert {*case.columns} <= {*(folder / "taken.csv").read_text(encoding="utf-8").splitlines()[0].split(",")}
    assert json.loads((folder / "study.json").read_text(encoding="utf-8"))["kind"] == name
    page = (folder / "page.md").read_text(encoding="utf-8")
    assert all(f"`{column}`" in page for column in case.columns)
    assert "the order is " in page
    result = json.loads((folder / "result.json").read_text(encoding="utf-8"))
    assert result["readings"]["kind"] == result["instrument"]["kind"] == name
    assert result["readings"]["scalars"] == FITTED * len(case.columns)
    with np.load(folder / "H.npz") as file:
        assert file["H"].shape[0] == FITTED * len(case.columns)
    assert json.loads(said["validate"])["rms_mm"] < 2 * NOISE
    assert json.loads((folder / "diagnosis.json").read_text(encoding="utf-8"))["effects"] == []
    read, told = ((folder / file).read_text(encoding="utf-8").splitlines() for file in ("new.csv", "told.csv"))
    for row, answer in zip(read[1:], told[1:], strict=True):
        was, now = dict(pairs(read[0], row)), dict(pairs(told[0], answer))
        for column in case.columns:
            assert abs(float(was[column]) - float(now[column])) < 5 * case.least


@pytest.mark.thorough
def test_many_recordings_of_it_are_taken(added: Checkout) -> None:
    cell = added.folder / "hall" / "machine"
    cell.mkdir(parents=True)
    for file in ("robot.toml", "seen.csv", "seen.toml"):
        shutil.copy(added.folder / file, cell)
    added.deltacal(("batch", "hall", "-o", "run", "--do", "identify", "--workers", 1))


def test_what_cannot_be_meant_is_refused() -> None:
    from derive import registry

    position = registry.measurement("position")

    with pytest.raises(ValueError, match="2 columns for the 3 rows"):
        dataclasses.replace(position, columns=("x_mm", "y_mm"))
    with pytest.raises(ValueError, match="ends in none of _mm, _deg, _px"):
        dataclasses.replace(position, columns=("x_mm", "y_mm", "z_inch"))
    with pytest.raises(ValueError, match="`after` gives 3 of 12"):
        dataclasses.replace(position, after=position.after[:3])
    with pytest.raises(ValueError, match="is no value of the reading"):
        dataclasses.replace(position, targets={"reading.w": 3})
