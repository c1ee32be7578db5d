"""The wheel as others get it: what it holds, and what a type checker sees of it."""

from __future__ import annotations

import ast
import importlib
import subprocess
import sys
import sysconfig
import venv
import zipfile
from pathlib import Path

import pytest

import deltacal_gen as dc
from deltacal_gen.pages import manual

ROOT = Path(__file__).resolve().parents[2]
USER = """
import numpy as np
import deltacal_gen as dc
import deltacal_kernels

robot = dc.read_robot("robot.toml")
reveal_type(robot)
reveal_type(dc.identify)
reveal_type(dc.Compensator(robot).servo)
reveal_type(deltacal_kernels.MECHANISMS)
dc.identify(3, "recording.csv")

result: dc.Result = dc.identify("robot.toml", "recording.csv", model="delta/32")
held: float | None = result.heldout_rms_mm
texts: list[str] = [c.text for c in result.unidentifiable]
joints = dc.compensate(result, np.zeros((2, 3)))
print(joints.shape, str(result))
verdict: dc.Verdict = dc.diagnose("robot.toml", "recording.csv").verdict
wrong: int = result.model
"""


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    pytest.importorskip("hatchling")
    folder = tmp_path_factory.mktemp("wheel")
    subprocess.run([sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", folder], cwd=ROOT, check=True)
    (built,) = folder.glob("*.whl")
    return built


def test_the_wheel_holds_all_that_is_read_at_run_time(wheel: Path) -> None:
    with zipfile.ZipFile(wheel) as archive:
        held = set(archive.namelist())
    packages = {"deltacal_gen": ROOT / "src", "deltacal_kernels": ROOT / "generated"}
    files = subprocess.run(
        ["git", "ls-files", "src", "generated"], cwd=ROOT, check=True, capture_output=True, text=True
    )
    wanted = {str((ROOT / name).relative_to(packages[Path(name).parts[1]])) for name in files.stdout.split()}
    assert wanted <= held
    assert {f"{name}/py.typed" for name in packages} <= held
    assert {f"deltacal_gen/manual/{p.name}" for p in manual.folder().glob("*.[mp][dy]")} <= held


@pytest.mark.walk
def test_a_type_checker_sees_the_types_of_an_installed_wheel(wheel: Path, tmp_path: Path) -> None:
    pytest.importorskip("mypy")
    place = tmp_path / "installed"
    venv.create(place, with_pip=False)
    (packages,) = place.glob("lib/*/site-packages")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(packages)
    (packages / "others.pth").write_text(sysconfig.get_path("purelib"))  # NumPy and the like, behind the wheel
    (tmp_path / "user.py").write_text(USER)
    command = [sys.executable, "-m", "mypy", "--config-file=", "--strict", f"--python-executable={place}/bin/python"]
    done = subprocess.run([*command, "user.py"], cwd=tmp_path, capture_output=True, text=True)
    said = [line.partition(": ")[2] for line in done.stdout.splitlines()]
    assert said[0] == 'note: Revealed type is "deltacal_gen.machine.values.Robot"', done.stdout + done.stderr
    assert "def (robot: str | pathlib.Path | deltacal_gen.machine.values.Robot" in said[1]
    assert "deltacal_gen.use.compensation.Servo" in said[2]
    assert said[3].startswith('note: Revealed type is "tuple[str, ')
    assert 'incompatible type "int"' in said[4]
    assert "error: Incompatible types in assignment" in said[5]  # and of a script no other line
    assert done.stdout.splitlines()[5].startswith(f"user.py:{len(USER.splitlines())}: ")
    assert "Found 2 errors" in done.stdout.splitlines()[6]
    assert not [line for line in said if "import" in line]


def test_what_a_type_checker_sees_is_what_there_is() -> None:
    tree = ast.parse(Path(dc.__file__).with_suffix(".pyi").read_text(encoding="utf-8"))
    found = [node for node in tree.body if isinstance(node, ast.ImportFrom)]
    seen = {alias.name: node.module for node in found for alias in node.names if alias.asname == alias.name}
    assert sorted(seen) == dc.__all__  # "a as a": a type checker takes nothing else as exported
    for name, module in seen.items():
        assert getattr(dc, name) is getattr(importlib.import_module(f"deltacal_gen.{module}"), name)
