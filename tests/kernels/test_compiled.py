"""Compiled kernels on disk: found by what they depend on, written whole, wherever they can be."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from importlib.util import cache_from_source
from itertools import islice
from pathlib import Path
from typing import Any

import deltacal_kernels
import numpy as np
import pytest
from deltacal_kernels import cache

from deltacal_gen.machine import backend, registry
from deltacal_gen.machine.backend import compile_row_functions
from tests.support.commands import Run

KERNEL = "simplified_parallelogram"  # the smallest mechanism
PROGRAM = f"""
import json
import numpy as np
from deltacal_kernels.{KERNEL} import kinematics
x, q = np.full((1, {{platform}}), 0.1), np.full((1, {{limbs}}), 0.1)
constants = kinematics.vectorised.constants(np.ones((1, {{limbs}}, {{width}})))
kinematics._forward(q, np.zeros((1, 3)), constants, x, np.zeros(1, dtype=np.int64), True)
of = kinematics._forward.stats
print(json.dumps([x.sum(), sum(of.cache_hits.values()), sum(of.cache_misses.values()), of.cache_path]))
"""


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A copy of the kernels of one mechanism, without compiled code."""
    source, copy = Path(deltacal_kernels.__file__).parent, tmp_path / "deltacal_kernels"
    hidden = shutil.ignore_patterns("__pycache__")
    shutil.copytree(source / KERNEL, copy / KERNEL, ignore=hidden)
    for file in source.glob("*.py"):
        shutil.copy2(file, copy)
    return copy


def begin(package: Path) -> subprocess.Popen[str]:
    tables: dict[str, Any] = {}
    exec((package / KERNEL / "parameters.py").read_text(), tables)
    width = sum(len(tables[name]) for name in ("GEOMETRY", "ERRORS", "COMMON", "DEFLECTIONS"))
    program = PROGRAM.format(limbs=tables["LIMBS"], width=width, platform=len(tables["PLATFORM"]))
    known = {k: v for k, v in os.environ.items() if k != "NUMBA_CACHE_DIR"} | {"PYTHONPATH": str(package.parent)}
    return subprocess.Popen([sys.executable, "-c", program], env=known, stdout=subprocess.PIPE, text=True)


def end(process: subprocess.Popen[str]) -> tuple[float, int, int, Path]:
    out, _ = process.communicate(timeout=120)
    assert process.returncode == 0
    value, hits, misses, path = json.loads(out)
    return value, hits, misses, Path(path)


@pytest.mark.walk
def test_processes_that_compile_at_once_and_kernels_that_change(package: Path) -> None:
    first, second = (end(process) for process in [begin(package), begin(package)])
    assert first[0] == second[0]
    folder = first[3]
    assert folder.parent == package / KERNEL / "__pycache__"
    assert [file.suffix for file in folder.iterdir()] == [".nbc"]  # one file, whole

    again = end(begin(package))
    assert again[:3] == (first[0], 1, 0)

    # another function that is compiled into this one, in another module, of the same age
    elementary = package / "elementary.py"
    times = elementary.stat()
    text = elementary.read_text()
    changed = text.replace("return r + r * z * p", "return r + r * z * p + 1.0")
    assert changed != text
    elementary.write_text(changed)
    os.utime(elementary, ns=(times.st_atime_ns, times.st_mtime_ns))
    other = end(begin(package))
    assert other[1:3] == (0, 1)
    assert other[0] != first[0]
    assert not folder.exists()  # nothing refers to it any more


@pytest.fixture
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    monkeypatch.setenv("NUMBA_CACHE_DIR", str(tmp_path))
    cache.folder.cache_clear()
    yield tmp_path
    cache.folder.cache_clear()


def test_a_package_that_cannot_be_written_is_kept_in_the_cache_of_the_user(
    elsewhere: Path, package: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert cache.folder(package / KERNEL).parent == elsewhere / "deltacal_kernels"
    cache.folder.cache_clear()
    monkeypatch.delenv("NUMBA_CACHE_DIR")
    (package / KERNEL / "__pycache__").write_text("no folder, for root neither")
    monkeypatch.setattr(sys, "platform", "linux")
    monkeypatch.setenv("XDG_CACHE_HOME", str(elsewhere / "home"))
    assert cache.folder(package / KERNEL).parent == elsewhere / "home" / "deltacal_kernels"


def ratio(a: float, b: float) -> float:
    return a / b


def test_options_of_a_function_are_part_of_its_name(elsewhere: Path) -> None:
    """Numba's own cache would give the second one the code of the first."""
    ieee, python = cache.kernel(error_model="numpy"), cache.kernel(error_model="python")
    assert ieee(ratio)(1.0, 0.0) == np.inf
    with pytest.raises(ZeroDivisionError):
        python(ratio)(1.0, 0.0)
    assert len(list(elsewhere.rglob("test_compiled.ratio-*.nbc"))) == 2
    for file in elsewhere.rglob("*.nbc"):
        file.write_bytes(file.read_bytes()[:100])
    assert ieee(ratio)(1.0, 0.0) == np.inf  # compiled anew
    assert cache.found(Path(__file__).parent, "test_compiled.ratio")
    assert not cache.found(Path(__file__).parent, "test_compiled.product")


def test_kernels_are_compiled_ahead(run: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(registry, "mechanism_names", lambda: (KERNEL, "serial"))
    monkeypatch.setattr(backend, "compile_row_functions", lambda: islice(compile_row_functions(), 2))
    code, out, _ = run("kernels", "--warm")
    assert code == 0
    told = [line.split() for line in out.splitlines()]
    assert Path(cache_from_source(str(backend.__file__))).exists()
    assert {f"{KERNEL}.{name}" for name in ("forward", "inverse", "sensitivity")} <= {name for *_, name in told}
    assert sum(".compiled." in name for *_, name in told) == 2
    assert all(unit == "s" and float(seconds) >= 0 for seconds, unit, _ in told)
    assert cache.found(cache.PACKAGE / KERNEL, "kinematics._forward")
    assert cache.found(cache.PACKAGE / KERNEL, "servo.exact_command")
