"""A kind of measurement is one file: those that the manual prints, put into a copy of the sources, are used as any."""

from __future__ import annotations

import dataclasses
import json
import re
import shutil
from dataclasses import dataclass
from pathlib import Path

import pytest
from conftest import PROTOTYPE, scattered, wanted

from deltacal_gen.files.robot import robot_from_dict, robot_to_toml
from deltacal_gen.files.writing import write_recording
from tests.copies import ROOT, called, commanded, copied

PAGE = ROOT / "src" / "deltacal_gen" / "manual" / "add-measurement.md"
POSES, FITTED, NOISE = 130, 100, 0.005


@dataclass(frozen=True)
class Added:
    """A kind's file, its columns, and the smallest difference that its noise makes in them."""

    text: str
    columns: tuple[str, ...]
    least: float


def in_manual(name: str) -> str:
    """Return the file of a kind that the manual prints."""
    blocks = re.findall(r"```python\n(.*?)```", PAGE.read_text(encoding="utf-8"), re.S)
    (text,) = (block for block in blocks if f'name="{name}"' in block)
    return str(text)


ADDED = {
    "probe": Added(in_manual("probe"), ("probe_mm",), NOISE),
    "level": Added(in_manual("level"), ("lean_x_deg", "lean_y_deg"), NOISE / 100.0 * 57.3),
}


@pytest.fixture(scope="module", params=["probe", pytest.param("level", marks=pytest.mark.thorough)])
def added(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Path]:
    """Return the name of a kind, and a copy of the sources to which its file was added."""
    name, folder = str(request.param), tmp_path_factory.mktemp("sources")
    copied(folder, "derive", "templates", "generated", "src")
    copied(folder, "tests", without=("benchmarks", "proof", "claims", "frozen"))
    shutil.copy(ROOT / "pyproject.toml", folder)
    (folder / "derive" / "measurements" / f"{name}.py").write_text(ADDED[name].text, encoding="utf-8")
    python(folder, "-m", "derive", name)
    return name, folder


def paths(folder: Path) -> list[Path]:
    return [folder, folder / "generated", folder / "src"]


def python(folder: Path, *arguments: object) -> str:
    return called(folder, *arguments, paths=paths(folder))


def deltacal(folder: Path, *lines: tuple[object, ...]) -> list[str]:
    return commanded(folder, *lines, paths=paths(folder))


def test_every_shared_test_takes_it(added: tuple[str, Path]) -> None:
    name, folder = added
    said = python(folder, "-m", "pytest", "-q", "-n0", "-k", name, "tests/test_kinds.py")
    assert int(re.search(r"(\d+) passed", said)[1]) >= 5  # type: ignore[index]


def test_it_is_simulated_identified_diagnosed_predicted_and_validated(added: tuple[str, Path]) -> None:
    name, folder = added
    case, robot = ADDED[name], robot_from_dict(PROTOTYPE)
    (folder / "robot.toml").write_text(robot_to_toml(robot), encoding="utf-8")
    (folder / "truth.toml").write_text("[parameters]\ntheta_1 = 0.3\ntheta_2 = -0.2\ntheta_3 = 0.1\n", encoding="utf-8")
    poses = wanted(scattered(robot, POSES, 1), sigma_mm=NOISE)
    write_recording(poses, folder / "poses.csv")
    text = (folder / "poses.toml").read_text(encoding="utf-8")
    (folder / "poses.toml").write_text(text.replace('"position"', f'"{name}"'), encoding="utf-8")
    noise = ("--noise", NOISE, "--seed", 1)
    deltacal(folder, ("simulate", "robot.toml", "poses.csv", "-o", "read.csv", "--truth", "truth.toml", *noise))
    header, *rows = (folder / "read.csv").read_text(encoding="utf-8").splitlines()
    assert set(case.columns) <= set(header.split(","))
    for part, kept in (("seen", rows[:FITTED]), ("new", rows[FITTED:])):
        (folder / f"{part}.csv").write_text("\n".join([header, *kept]) + "\n", encoding="utf-8")
        shutil.copy(folder / "read.toml", folder / f"{part}.toml")

    blank = [",".join("" if c in case.columns else v for c, v in pairs(header, row)) for row in rows[FITTED:]]
    (folder / "blank.csv").write_text("\n".join([header, *blank]) + "\n", encoding="utf-8")
    shutil.copy(folder / "read.toml", folder / "blank.toml")
    said = deltacal(
        folder,
        ("identify", "robot.toml", "seen.csv", "-o", "result.json", "--report", "result.html"),
        ("validate", "result.json", "new.csv", "--json"),
        ("diagnose", "robot.toml", "seen.csv", "-o", "diagnosis.json"),
        ("predict", "diagnosis.json", "blank.csv", "-o", "told.csv"),
    )
    result = json.loads((folder / "result.json").read_text(encoding="utf-8"))
    assert result["readings"]["kind"] == result["instrument"]["kind"] == name
    assert result["readings"]["scalars"] == FITTED * len(case.columns)
    assert json.loads(said[1])["rms_mm"] < 2 * NOISE
    assert json.loads((folder / "diagnosis.json").read_text(encoding="utf-8"))["effects"] == []
    told_header, *told = (folder / "told.csv").read_text(encoding="utf-8").splitlines()
    for row, answer in zip(rows[FITTED:], told, strict=True):
        was, now = dict(pairs(header, row)), dict(pairs(told_header, answer))
        for column in case.columns:
            assert abs(float(was[column]) - float(now[column])) < 5 * case.least


def pairs(header: str, row: str) -> list[tuple[str, str]]:
    """Return the cells of a row by their columns."""
    return list(zip(header.split(","), row.split(","), strict=True))


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
