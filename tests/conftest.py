"""What all tests share: a shell that nobody set up, the command line, the machine of Bai 2015."""

from __future__ import annotations

import gc
import os
import sys
from collections.abc import Iterator

os.environ.pop("DELTACAL_TRACEBACK", None)  # no test depends on how its shell was set up
os.environ.pop("DELTACAL_PLAIN_JIT", None)
os.environ.pop("SOURCE_DATE_EPOCH", None)
os.environ.pop("FORCE_COLOR", None)
os.environ.pop("NO_COLOR", None)
os.environ.pop("PY_COLORS", None)
os.environ.pop("COLUMNS", None)
os.environ.pop("TERMINAL_WIDTH", None)
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # small matrices: threads only slow them down

import numpy as np
import pytest

from deltacal_gen.app import cli
from deltacal_gen.files.robot import Robot, robot_from_dict
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import Machine, load_mechanism
from tests.support.commands import Run
from tests.support.prototype import PROTOTYPE

THOROUGH_S = 1800  # before a test that takes minutes is stopped


def pytest_configure() -> None:
    """Look for garbage seldom: it is little beside what imports and syntax trees hold."""
    gc.set_threshold(100_000, 20, 20)


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Begin with the tests of the whole, which take longest: behind the others one core would wait for them."""
    items.sort(key=lambda item: item.path.parent.name != "whole")
    for item in items:
        if item.get_closest_marker("thorough") and not item.get_closest_marker("timeout"):
            item.add_marker(pytest.mark.timeout(THOROUGH_S))


def pytest_collection_finish() -> None:
    """Leave what imports made out of every later collection of garbage: it stays to the end."""
    gc.collect()
    gc.freeze()


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Run:
    """Call ``deltacal`` in this process; return exit code, standard output and standard error."""

    def call(*arguments: object) -> tuple[int, str, str]:
        monkeypatch.setattr(sys, "argv", ["deltacal", *map(str, arguments)])
        code = 0
        try:
            cli.main()
        except SystemExit as end:
            code = int(end.code or 0)
        out = capsys.readouterr()
        return code, out.out, " ".join(out.err.split())

    return call


@pytest.fixture(scope="module")
def compiled() -> Iterator[None]:
    """Compute with compiled kernels: no single small recording pays for loading them, a module of many does.

    What NumPy's give is the same to rounding, which the tests of kernels, of back ends and of frozen answers hold.
    """
    with using(Backend.COMPILED):
        yield


@pytest.fixture(scope="session")
def robot() -> Robot:
    return robot_from_dict(PROTOTYPE)


@pytest.fixture(scope="session")
def mechanism() -> Machine:
    return load_mechanism("delta")


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(20150415)
