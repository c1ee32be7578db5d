"""The back end depends on the work alone: not on the clock, on the cache of compiled code, or on what ran before."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from threadpoolctl import threadpool_info, threadpool_limits

import deltacal_gen as dc
from deltacal_gen.files.robot import Robot, robot_to_toml
from deltacal_gen.machine import backend
from deltacal_gen.machine.backend import PAYS_FROM, Backend, by_recording, using, working
from deltacal_gen.machine.registry import Machine
from tests.support.prototype import scattered

ERRORS = {"L_1": 0.3, "theta_2": 0.002, "ex_3": -0.2}
PROGRAM = """
import sys
from pathlib import Path
import numpy as np
import deltacal_gen as dc
folder, history = Path(sys.argv[1]), sys.argv[2:]
robot = dc.read_robot(folder / "robot.toml")
mechanism = dc.load_mechanism("delta")
if "compiled" in history:
    mechanism.forward(np.full((25_000, 3), -0.1), np.zeros(3), mechanism.rows(robot))
if "small" in history:
    for angle in np.linspace(-0.3, 0.1, 50):
        mechanism.forward(np.full((7, 3), angle), np.zeros(3), mechanism.rows(robot))
for size in ("small", "large"):
    result = folder / f"{size}.json"
    dc.identify(robot, folder / f"{size}.csv", model="18", output=result)
    dc.export_compensator(result, output=folder / f"{size}.c", export="c")
dc.diagnose(robot, folder / "small.csv", output=folder / "diagnosis.json")
dc.export_compensator(folder / "diagnosis.json", output=folder / "diagnosis.c", export="c")
print("deltacal_kernels.cache" in sys.modules)
"""


@pytest.fixture(scope="module")
def given(robot: Robot, mechanism: Machine, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A robot file and two recordings of a machine with errors: of few poses, and of more than pay for compiling."""
    folder = tmp_path_factory.mktemp("given")
    (folder / "robot.toml").write_text(robot_to_toml(robot))
    for name, n in (("small", 60), ("large", PAYS_FROM["identify"])):
        targets = folder / f"{name}_targets.csv"
        np.savetxt(targets, scattered(robot, n, 5), "%.9g", ",", header="x_mm,y_mm,z_mm", comments="")
        dc.simulate(robot, targets, output=folder / f"{name}.csv", truth=ERRORS, noise=0.01, seed=3)
    return folder


def written(given: Path, place: Path, *history: str, cache: Path) -> dict[str, bytes]:
    """Run the program in a process of its own; return the files that it wrote."""
    place.mkdir()
    for name in ("robot.toml", "small.csv", "small.toml", "large.csv", "large.toml"):
        (place / name).write_bytes((given / name).read_bytes())
    before = {path.name for path in place.iterdir()}
    done = subprocess.run(
        [sys.executable, "-c", PROGRAM, ".", *history],
        cwd=place,
        env=os.environ | {"NUMBA_CACHE_DIR": str(cache), "OPENBLAS_NUM_THREADS": "1", "SOURCE_DATE_EPOCH": "0"},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.split() == ["True"]  # the large recording was worth compiling
    return {path.name: path.read_bytes() for path in place.iterdir() if path.name not in before}


@pytest.mark.walk
def test_neither_the_cache_nor_what_ran_before_moves_a_bit(given: Path, tmp_path: Path) -> None:
    cache = tmp_path / "cache"
    no_folder = tmp_path / "file"
    no_folder.write_text("")  # no folder can be made below a file, by nobody
    empty = written(given, tmp_path / "empty", cache=cache)
    assert sorted(empty) == ["diagnosis.c", "diagnosis.json", "large.c", "large.json", "small.c", "small.json"]
    assert list(cache.rglob("*.nbc"))
    assert written(given, tmp_path / "full", "small", "compiled", "small", cache=cache) == empty
    assert written(given, tmp_path / "unwritable", "compiled", cache=no_folder / "cache") == empty


def kernels_used(mechanism: Machine, robot: Robot, poses: int, monkeypatch: pytest.MonkeyPatch) -> set[ModuleType]:
    """Return the kernels that a call over so many poses runs."""
    used = set()
    for kernels in (mechanism.compiled, mechanism.vectorised):

        def forward(*args: object, of: ModuleType = kernels, **kwargs: object) -> None:
            used.add(of)

        for name in {"forward", "simplified_forward"} & vars(kernels).keys():
            monkeypatch.setattr(kernels, name, forward)
    mechanism.positions(np.full((poses, 3), -0.1), np.zeros(3), mechanism.rows(robot))
    return used


def test_a_call_is_compiled_where_its_poses_pay_for_it(
    robot: Robot, mechanism: Machine, monkeypatch: pytest.MonkeyPatch
) -> None:
    enough = PAYS_FROM["call"]
    assert kernels_used(mechanism, robot, enough, monkeypatch) == {mechanism.compiled}
    assert kernels_used(mechanism, robot, enough - 1, monkeypatch) == {mechanism.vectorised}  # also afterwards
    with using(Backend.COMPILED):
        assert kernels_used(mechanism, robot, 1, monkeypatch) == {mechanism.compiled}
    with using(Backend.NUMPY):
        assert kernels_used(mechanism, robot, enough, monkeypatch) == {mechanism.vectorised}


def test_a_part_is_done_by_the_back_end_of_the_whole() -> None:
    """A diagnosis identifies, and thousands of identifications in a study are one work."""
    many, few = PAYS_FROM["diagnose"], PAYS_FROM["diagnose"] - 1
    with working("diagnose", many), working("identify", 1):
        assert backend.chosen(1) is Backend.COMPILED
    with working("diagnose", few), working("identify", PAYS_FROM["identify"]):
        assert backend.chosen(1_000_000) is Backend.NUMPY
    with working("diagnose", many), using(Backend.NUMPY):  # what is asked for by name stands above all works
        assert backend.chosen(1) is Backend.NUMPY
    assert backend.chosen(1) is Backend.NUMPY


def test_a_function_of_a_recording_is_a_work_over_its_poses(robot: Robot) -> None:
    class Recorded:
        def __init__(self, poses: int) -> None:
            self.joints = np.zeros((poses, 3))

    @by_recording("identify")
    def work(robot: Robot, recording: Recorded, poses: int = 1) -> Backend:
        """Say which."""
        return backend.chosen(poses)

    assert work(robot, Recorded(PAYS_FROM["identify"])) is Backend.COMPILED
    assert work(robot, Recorded(PAYS_FROM["identify"] - 1), poses=1_000_000) is Backend.NUMPY
    assert work.__doc__ == "Say which."
    with using(Backend.COMPILED):
        assert work(robot, Recorded(1)) is Backend.COMPILED


def test_a_work_takes_one_thread_of_linear_algebra(robot: Robot, tmp_path: Path) -> None:
    """Threads of small matrices wait for one another, at twice the cost, and add in the order of their number."""

    def threads() -> set[int]:
        return {pool["num_threads"] for pool in threadpool_info() if pool["user_api"] == "blas"}

    @by_recording("identify")
    def worked(robot: Robot, recording: dc.Recording) -> set[int]:
        return threads()

    np.savetxt(tmp_path / "targets.csv", scattered(robot, 5, 5), "%.9g", ",", header="x_mm,y_mm,z_mm", comments="")
    dc.simulate(robot, tmp_path / "targets.csv", output=tmp_path / "recording.csv", seed=3)
    with threadpool_limits(2, "blas"):
        assert worked(robot, dc.read_recording(tmp_path / "recording.csv", dc.load_mechanism("delta"))) == {1}
        assert threads() == {2}
