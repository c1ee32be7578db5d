"""A kind of measurement is one file: those that the manual prints, put into a copy of the sources, are used as any."""

from __future__ import annotations

import dataclasses
import json
import os
import re
import shutil
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import pytest
from conftest import PROTOTYPE, scattered, wanted

from deltacal_gen.files.robot import robot_from_dict, robot_to_toml
from deltacal_gen.files.writing import write_recording

ROOT = Path(__file__).parents[1]
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
    for part in ("derive", "templates", "generated", "tests"):
        ignored = shutil.ignore_patterns("__pycache__", "benchmarks", "proof", "claims", "frozen")
        shutil.copytree(ROOT / part, folder / part, ignore=ignored)
    shutil.copytree(ROOT / "src", folder / "src", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "pyproject.toml", folder)
    (folder / "derive" / "measurements" / f"{name}.py").write_text(ADDED[name].text, encoding="utf-8")
    called(folder, "-m", "derive", name)
    return name, folder


def called(folder: Path, *arguments: object) -> str:
    """Run Python on the copy; return what it printed."""
    paths = [folder, folder / "generated", folder / "src"]
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(map(str, paths))}
    command = [sys.executable, *map(str, arguments)]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def deltacal(folder: Path, *arguments: object) -> str:
    return called(folder, "-c", "from deltacal_gen.app.cli import main; main()", *arguments)


def test_every_shared_test_takes_it(added: tuple[str, Path]) -> None:
    name, folder = added
    said = called(folder, "-m", "pytest", "-q", "-n0", "-k", name, "tests/test_kinds.py")
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
    deltacal(folder, "simulate", "robot.toml", "poses.csv", "-o", "read.csv", "--truth", "truth.toml", *noise)
    header, *rows = (folder / "read.csv").read_text(encoding="utf-8").splitlines()
    assert set(case.columns) <= set(header.split(","))
    for part, kept in (("seen", rows[:FITTED]), ("new", rows[FITTED:])):
        (folder / f"{part}.csv").write_text("\n".join([header, *kept]) + "\n", encoding="utf-8")
        shutil.copy(folder / "read.toml", folder / f"{part}.toml")

    deltacal(folder, "identify", "robot.toml", "seen.csv", "-o", "result.json", "--report", "result.html")
    result = json.loads((folder / "result.json").read_text(encoding="utf-8"))
    assert result["readings"]["kind"] == result["instrument"]["kind"] == name
    assert result["readings"]["scalars"] == FITTED * len(case.columns)
    found = json.loads(deltacal(folder, "validate", "result.json", "new.csv", "--json"))
    assert found["rms_mm"] < 2 * NOISE

    deltacal(folder, "diagnose", "robot.toml", "seen.csv", "-o", "diagnosis.json")
    assert json.loads((folder / "diagnosis.json").read_text(encoding="utf-8"))["effects"] == []
    blank = [",".join("" if c in case.columns else v for c, v in pairs(header, row)) for row in rows[FITTED:]]
    (folder / "blank.csv").write_text("\n".join([header, *blank]) + "\n", encoding="utf-8")
    shutil.copy(folder / "read.toml", folder / "blank.toml")
    deltacal(folder, "predict", "diagnosis.json", "blank.csv", "-o", "told.csv")
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
