"""A machine is one file: the 3-RRR that the manual prints, whose platform turns on command, added to a checkout."""

from __future__ import annotations

import csv
import ctypes
import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from deltacal_gen.files.toml import toml_text
from tests.support.copies import Checkout, printed, untried

pytestmark = pytest.mark.walk  # each derives what was added, and runs tests and commands on a copy

COMPILER = shutil.which("cc")
NOISE = 0.003  # mm
TRUTH = """
[parameters]
theta_1 = 0.2
theta_2 = -0.1
ex_1 = 0.1
L_2 = 0.08
l_3 = -0.1
bx_2 = 0.05
"""
WITH_TRUTH = ("--truth", "truth.toml", "--noise", NOISE)
LINES: list[tuple[object, ...]] = [
    ("simulate", "robot.toml", "poses.csv", "-o", "recording.csv", *WITH_TRUTH),
    ("simulate", "robot.toml", "other.csv", "-o", "unseen.csv", *WITH_TRUTH, "--seed", 5),
    ("simulate", "robot.toml", "other.csv", "-o", "hall/stage/unseen.csv", *WITH_TRUTH),
    ("identify", "robot.toml", "recording.csv", "-o", "result.json", "--report", "result.html", "--json"),
    ("matrix", "robot.toml", "recording.csv", "--model", "21", "-o", "H.npz"),
    ("plan", "robot.toml", "--model", "21", "-o", "targets.csv"),
    ("plan", "robot.toml", "--model", "21", "--optimal", 12, "-o", "optimal.csv"),
    ("validate", "result.json", "unseen.csv"),
    ("certificate", "result.json", "unseen.csv", "-o", "certificate.html"),
    ("predict", "result.json", "unseen.csv", "-o", "predicted.csv"),
    ("diagnose", "robot.toml", "recording.csv", "-o", "diagnosis.json", "--report", "diagnosis.html"),
    ("identify", "robot.toml", "recording.csv", "--physics", "diagnosis.json", "-o", "held.json"),
    ("next", "diagnosis.json", "-o", "next.csv"),
    ("study", "robot.toml", "--plan", "poses.csv", "--model", "21", "--trials", 20, "--noise", NOISE),
    ("batch", "hall", "-o", "run", "--do", "identify", "--workers", 1),
    ("compare", "result.json", "held.json"),
    ("compensate", "result.json", "targets.csv", "-o", "joints.csv"),
    ("compensate", "diagnosis.json", "--export", "c", "-o", "diagnosed.c"),
    ("models", "--json"),
    ("effects",),
]
KERNELS = """
import dataclasses
import numpy as np
import deltacal_gen as dc
from deltacal_gen.use.compensation import Compensator
from deltacal_gen.machine.backend import Backend
from deltacal_gen.machine.rotation import from_vector
robot = dc.read_robot("robot.toml")
machine, rng, n = dc.load_mechanism("rrr"), np.random.default_rng(1), 100
assert (machine.asks, machine.widths, machine.turning) == (("px", "py", "cz"), (3, 12), True)
errors = machine.typical * rng.standard_normal(21)
robot = dataclasses.replace(robot, errors={p.name: e for p, e in zip(machine.parameters, errors)})
rows, tool = machine.rows(robot), np.array([10.0, 5.0, 0.0])
vectors = np.zeros((n, 3))
vectors[:, 2] = rng.uniform(-0.3, 0.3, n)
places = np.column_stack([rng.uniform(-50, 50, (n, 2)), np.zeros(n)])
targets = np.hstack([places, from_vector(vectors).reshape(-1, 9)])
for backend in Backend:
    with dc.using(backend):
        q, x, status = machine.inverse(targets, tool, rows)
        assert not status.any() and np.abs(x - targets).max() < 1e-12
        again, status = machine.forward(q, tool, rows)
        assert not status.any() and np.abs(again - targets).max() < 1e-9
        level, there, _ = machine.inverse(places, tool, rows)  # a position alone: level
        assert np.abs(there[:, 3:] - np.eye(3).ravel()).max() < 1e-12
        S, step = machine.sensitivity(x, q, tool, rows), 1e-6 * rng.standard_normal(21)
        moved, _ = machine.forward(q, tool, machine.rows(robot, errors + step), near=x)
        gap = moved[:, :3] - x[:, :3] - (S.parameters @ step)[:, :3]
        assert np.abs(gap).max() < 1e-8
        exact, linear = (Compensator(robot, kind).command(targets)[0] for kind in ("exact", "linear"))
        nominal, _ = Compensator(robot).nominal_command(targets)
        assert np.abs(linear - exact).max() < 0.02 * np.abs(nominal - exact).max()
command, state = Compensator(robot).servo()
assert np.allclose(command(*machine.stated(targets)[0], state), exact[0], rtol=0, atol=1e-12)
"""


@pytest.fixture(scope="module")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Checkout:
    """A checkout with the machine's file and its kernels, and a folder of a machine's files."""
    text = printed("add-mechanism", "rrr")
    names: dict[str, Any] = {}
    exec(text, names)
    robot = {"robot": {"name": "stage", "mechanism": "rrr"}, **names["MACHINE"].keywords["drawing"]}
    made = Checkout.with_files(tmp_path_factory.mktemp("checkout"), "mechanisms", {"rrr": text})
    work = made.folder / "work"
    work.mkdir()
    (work / "robot.toml").write_text(toml_text(robot))
    (work / "truth.toml").write_text(TRUTH)
    rng = np.random.default_rng(2)
    for name in ("poses", "other"):
        rows = np.column_stack([rng.uniform(-40, 40, (60, 2)), rng.uniform(-15, 15, 60)])
        np.savetxt(work / f"{name}.csv", rows, "%.4f", ",", header="x_mm,y_mm,rz_deg", comments="")
        (work / f"{name}.toml").write_text('[measurement]\nkind = "position"\nframe = "unknown"\n')
    return made


def table(path: Path, *columns: str) -> np.ndarray:
    with path.open() as file:
        return np.array([[float(row[c]) for c in columns] for row in csv.DictReader(file)])


def test_every_shared_test_takes_it(checkout: Checkout) -> None:
    files = {test.partition("::")[0] for test in checkout.passed()}
    assert {
        "tests/machine/test_machine.py",
        "tests/whole/test_every_mechanism.py",
        "tests/derive/test_laws.py",
    } <= files
    assert len(files) >= 6


@pytest.mark.thorough
def test_what_runs_over_all_machines_takes_it_and_its_kernels_are_numbas(checkout: Checkout) -> None:
    passed = checkout.all_passed()
    assert "tests/kernels/test_plain_jit.py::test_kernels_are_the_same_by_numba_alone[rrr]" in passed
    assert "tests/benchmarks/test_benchmarks_run.py::test_all_contenders_agree[forward_rrr]" in passed


def test_a_trial_shows_that_it_closes_and_what_is_seen(checkout: Checkout) -> None:
    """`deltacal kernels NAME --try ROBOT.toml` derives one machine and looks at it."""
    command = ("kernels", "rrr", "--try", "robot.toml", "-o", "rrr.svg")
    said = " ".join(checkout.python("-m", "deltacal_gen.app.cli", *command, where="work").split())
    assert "100 of 100 poses there and back" in said
    assert "of rrr/21" in said
    order = float(said.partition("of order ")[2].split()[0])
    assert 1.9 < order < 2.1
    assert "drawing in rrr.svg" in said
    picture = (checkout.folder / "work" / "rrr.svg").read_text()
    assert picture.startswith("<svg")
    for name in ("A", "B", "C", "base", "platform"):
        assert f">{name}</" in picture or f">{name}<" in picture


@pytest.mark.thorough
def test_kernels_are_derived_and_agree(checkout: Checkout) -> None:
    assert "files are what derive/ yields" in checkout.python("-m", "derive", "rrr", "--check")
    checkout.python("-c", KERNELS, where="work")


def test_every_command_takes_it(checkout: Checkout) -> None:
    """From drawing to corrected commands; the true machine then meets positions and rotations."""
    work = checkout.folder / "work"
    cell = work / "hall" / "stage"
    cell.mkdir(parents=True)
    shutil.copy(work / "robot.toml", cell)
    assert untried(*LINES) == {"derivation"}
    said = checkout.deltacal(*LINES, where="work")
    assert "rrr/21" in said[-2]
    found = json.loads(said[3])
    assert found["model"] == "rrr/21"
    assert found["heldout_rms_mm"] < 1.5 * NOISE < found["before_rms_mm"] / 5
    assert np.abs(table(work / "targets.csv", "rz_deg")).max() > 10  # a plan turns the platform, too
    assert np.abs(table(work / "targets.csv", "rz_deg")).max() <= 15
    (work / "joints.toml").write_text('[measurement]\nkind = "pose"\nframe = "robot"\n')
    (work / "targets.toml").write_text('[measurement]\nkind = "pose"\nframe = "robot"\n')
    columns = ("x_mm", "y_mm", "rz_deg")
    wanted, off = table(work / "targets.csv", *columns), {}
    names = ("joints", "targets")
    sent = [("simulate", "robot.toml", f"{n}.csv", "-o", f"{n}_reached.csv", "--truth", "truth.toml") for n in names]
    checkout.deltacal(*sent, where="work")
    for name in names:
        apart = table(work / f"{name}_reached.csv", *columns) - wanted
        off[name] = np.abs(apart - apart.mean(axis=0)).max(axis=0)
    assert (off["joints"] < off["targets"] / 2).all()


@pytest.mark.thorough
def test_its_derivation_is_written(checkout: Checkout) -> None:
    checkout.deltacal(("derivation", "rrr", "-o", "rrr.html"), where="work")
    page = (checkout.folder / "work" / "rrr.html").read_text(encoding="utf-8")
    assert "Planar 3-RRR" in page
    assert "parameters are seen by" in page  # in numbers, of its drawing


C = """
import dataclasses, numpy as np, deltacal_gen as dc
from deltacal_gen.use.compensation import Compensator
robot = dataclasses.replace(dc.read_robot("robot.toml"), errors={"theta_1": 0.003, "L_2": 0.1, "bx_3": 0.2})
poses = dc.read_recording("poses.csv", dc.load_mechanism("rrr"), need_measured=False, allow_targets=True)
for kind in ("exact", "linear"):
    compensator = Compensator(robot, kind)
    dc.export_c(compensator, f"{kind}.c")
    np.save(f"{kind}.npy", np.degrees(compensator.command(poses.targets)[0]))
"""


@pytest.mark.skipif(COMPILER is None, reason="no C compiler")
def test_its_c_takes_position_and_rotation(checkout: Checkout) -> None:
    work = checkout.folder / "work"
    checkout.python("-c", C, where="work")
    for name in ("exact", "linear"):
        library = work / f"{name}.so"
        flags = ["-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O2", "-shared", "-fPIC"]
        subprocess.run([str(COMPILER), *flags, "-o", str(library), str(work / f"{name}.c"), "-lm"], check=True)
        function = ctypes.CDLL(str(library)).deltacal_compensate
        given = ctypes.c_double * 3
        targets, commands = table(work / "poses.csv", "x_mm", "y_mm", "rz_deg"), np.load(work / f"{name}.npy")
        for target, wanted in zip(targets, commands, strict=True):
            found = given()
            assert function(given(*target), found) == 0
            np.testing.assert_allclose(list(found), wanted, rtol=0, atol=1e-9)
