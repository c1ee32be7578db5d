"""The wheel in the hands of somebody who has nothing else: no checkout, no SymPy, an environment of its own."""

from __future__ import annotations

import os
import subprocess
import sys
import venv
from pathlib import Path

import pytest

pytestmark = [pytest.mark.walk, pytest.mark.timeout(900)]  # a package index may be slow

ROOT = Path(__file__).resolve().parents[2]
SETTINGS = ("PYTHON", "NUMBA_", "DELTACAL_", "VIRTUAL_ENV")  # of the shell of these tests


def _called(*command: object, where: Path) -> subprocess.CompletedProcess[str]:
    """Run a command in a shell that knows nothing of this checkout."""
    env = {name: value for name, value in os.environ.items() if not name.startswith(SETTINGS)}
    return subprocess.run([*map(str, command)], cwd=where, env=env, capture_output=True, text=True, check=False)


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of programs of an environment into which the wheel was installed, with what it asks for."""
    pytest.importorskip("hatchling")
    folder = tmp_path_factory.mktemp("fresh")
    build = [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", folder]
    subprocess.run(build, cwd=ROOT, check=True, capture_output=True)
    (wheel,) = folder.glob("*.whl")
    venv.create(folder / "venv", with_pip=True)
    programs = folder / "venv" / ("Scripts" if os.name == "nt" else "bin")
    pip = [programs / "python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    if _called(*pip, "--dry-run", "--no-deps", "--retries", "0", "rich", where=folder).returncode:
        pytest.skip("no package index can be reached")
    done = _called(*pip, wheel, where=folder)
    assert done.returncode == 0, done.stderr
    return programs


def test_the_demonstration_runs_from_a_wheel_alone(installed: Path, tmp_path: Path) -> None:
    absent = "import importlib.util as u; print(*(n for n in ('sympy', 'derive', 'tests', 'pytest') if u.find_spec(n)))"
    assert _called(installed / "python", "-c", absent, where=tmp_path).stdout.strip() == ""
    done = _called(installed / "deltacal", "demo", where=tmp_path)
    assert done.returncode == 0, done.stderr
    assert (tmp_path / "demo" / "diagnosis.html").stat().st_size > 10_000
    where = "import deltacal_gen, deltacal_kernels; print(deltacal_gen.__file__, deltacal_kernels.__file__)"
    files = _called(installed / "python", "-c", where, where=tmp_path).stdout.split()
    assert len(files) == 2
    assert all(Path(file).is_relative_to(installed.parent) for file in files)
