"""An effect is one file: those that the manual prints, put into a copy of the sources, are derived, tested and used."""

from __future__ import annotations

import json
import re
import shutil
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from conftest import scattered, wanted

from deltacal_gen.files.robot import robot_to_toml
from deltacal_gen.files.writing import write_recording
from deltacal_gen.pages import manual
from tests.copies import ROOT, called, commanded, copied
from tests.left_out import channels, machine

SHARED = ("test_states", "test_physics", "test_compensation_effects")  # tests over all effects
LIMB = 2


@dataclass(frozen=True)
class Added:
    """An effect's file, and the truth in which it is concealed, in the units of files; `columns` it depends on."""

    text: str
    truth: dict[str, float]
    columns: tuple[str, ...]


def in_manual(name: str) -> str:
    """Return the file of an effect that the manual prints."""
    page = (manual.folder() / "add-effect.md").read_text(encoding="utf-8")
    blocks = re.findall(r"```python.*?\n(.*?)```", page, re.S)
    (text,) = (block for block in blocks if f'name="{name}"' in block)
    return str(text)


ADDED = {
    "warm_compliance": Added(in_manual("warm_compliance"), {"softening": 0.002}, ("temp", "payload")),
    "preload": Added(in_manual("preload"), {"compliance": 0.02}, ("payload",)),
}


@pytest.fixture(scope="module", params=["warm_compliance", pytest.param("preload", marks=pytest.mark.thorough)])
def added(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> tuple[str, Path]:
    """Return the name of an effect, and a copy of the sources to which its file was added."""
    name, folder = str(request.param), tmp_path_factory.mktemp("sources")
    copied(folder, "derive", "templates", "generated", "tests", without=("benchmarks", "proof", "claims", "frozen"))
    shutil.copy(ROOT / "pyproject.toml", folder)
    (folder / "derive" / "effects" / f"{name}.py").write_text(ADDED[name].text, encoding="utf-8")
    python(folder, "-m", "derive", name)
    return name, folder


def paths(folder: Path) -> list[Path]:
    return [folder, folder / "generated", ROOT / "src"]


def python(folder: Path, *arguments: object) -> str:
    return called(folder, *arguments, paths=paths(folder))


def deltacal(folder: Path, *lines: tuple[object, ...]) -> list[str]:
    return commanded(folder, *lines, paths=paths(folder))


def written(path: Path, columns: dict[str, np.ndarray]) -> None:
    """Write columns as a CSV."""
    values = np.column_stack(list(columns.values()))
    np.savetxt(path, values, fmt="%.12g", delimiter=",", header=",".join(columns), comments="")


def test_every_shared_test_takes_it(added: tuple[str, Path]) -> None:
    name, folder = added
    said = python(folder, "-m", "pytest", "-q", "-n0", "-k", name, *(f"tests/{test}.py" for test in SHARED))
    assert int(re.search(r"(\d+) passed", said)[1]) >= 5  # type: ignore[index]


def test_it_is_listed_simulated_diagnosed_and_compensated(added: tuple[str, Path]) -> None:
    name, folder = added
    case, robot = ADDED[name], machine()
    (folder / "robot.toml").write_text(robot_to_toml(robot), encoding="utf-8")
    values = "\n".join(f"{key} = {value}" for key, value in case.truth.items())
    (folder / "truth.toml").write_text(f'[[effects]]\nname = "{name}"\nlimb = {LIMB}\n{values}\n', encoding="utf-8")
    poses = wanted(scattered(robot, 80, 1), frame="robot", channels=channels(80, *case.columns))
    write_recording(poses, folder / "poses.csv")
    noise = ("--noise", 0.005, "--seed", 1)
    said = deltacal(
        folder,
        ("effects", "--json"),
        ("simulate", "robot.toml", "poses.csv", "-o", "read.csv", "--truth", "truth.toml", *noise),
        ("diagnose", "robot.toml", "read.csv", "-o", "found.json", "--report", "found.html"),
    )
    assert name in {e["effect"] for e in json.loads(said[0])}
    found = json.loads((folder / "found.json").read_text(encoding="utf-8"))
    assert [(e["name"], e["limbs"]) for e in found["effects"]] == [(name, [LIMB])]
    for p in found["effects"][0]["parameters"]:
        assert abs(p["value"] - case.truth[p["name"]]) < 5 * p["std"]
    assert found["location"]["channels"]
    assert "nothing that was recorded" not in found["location"]["text"]

    targets = scattered(robot, 20, 3)
    now = {k: v for k, v in channels(20, *case.columns, seed=9).items() if not k.startswith("time")}
    written(folder / "targets.csv", dict(zip(("x_mm", "y_mm", "z_mm"), targets.T, strict=True)) | now)
    deltacal(
        folder,
        ("compensate", "found.json", "targets.csv", "-o", "joints.csv"),
        ("compensate", "found.json", "--export", "c", "-o", "command.c"),
    )
    # the true machine, sent there, stands where it was wanted
    joints = np.genfromtxt(folder / "joints.csv", delimiter=",", names=True)
    written(folder / "sent.csv", {q: joints[q] for q in ("q1_deg", "q2_deg", "q3_deg")} | now)
    (folder / "sent.toml").write_text('[measurement]\nkind = "position"\nframe = "robot"\n', encoding="utf-8")
    deltacal(folder, ("simulate", "robot.toml", "sent.csv", "-o", "stood.csv", "--truth", "truth.toml"))
    stood = np.genfromtxt(folder / "stood.csv", delimiter=",", names=True)
    error = np.column_stack([stood[f"{a}_mm"] for a in "xyz"]) - targets
    assert np.sqrt(np.mean(np.sum(error**2, axis=1))) < 0.01
    assert f"{name} at joint {LIMB}" in (folder / "command.c").read_text(encoding="utf-8")
