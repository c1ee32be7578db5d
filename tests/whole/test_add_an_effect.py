"""An effect is one file: those that the manual prints, put into a copy of the sources, are derived, tested and used.

Of machines at rest two, by every command; of a drive one, by those that know the torque.
"""

from __future__ import annotations

import ctypes
import json
import re
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from deltacal_gen.files.robot import robot_to_toml
from deltacal_gen.files.writing import write_recording
from tests.support.compiled_c import At
from tests.support.copies import Checkout, printed, untried
from tests.support.left_out import channels, machine
from tests.support.motion_recordings import NOISE as TORQUE_NOISE
from tests.support.motion_recordings import planned, trajectory
from tests.support.prototype import scattered, wanted

pytestmark = pytest.mark.walk  # each derives what was added, and runs tests and commands on a copy

COMPILER = shutil.which("cc")
LIMB, NOISE = 2, 0.005
WITH_TRUTH = ("--truth", "truth.toml", "--noise", NOISE)
GEOMETRY_ALONE = {"plan", "matrix", "models"}  # commands that no effect changes
SUSPECT = ("--suspect", "truth.toml", "--trials", 10, "--diagnoses", 1, "--workers", 1)
LINES: list[tuple[object, ...]] = [
    ("effects", "--json"),
    ("simulate", "robot.toml", "poses.csv", "-o", "read.csv", *WITH_TRUTH, "--seed", 1),
    ("simulate", "robot.toml", "other.csv", "-o", "unseen.csv", *WITH_TRUTH, "--seed", 2),
    ("diagnose", "robot.toml", "read.csv", "-o", "found.json", "--report", "found.html"),
    ("identify", "robot.toml", "read.csv", "--physics", "found.json", "-o", "held.json"),
    ("identify", "robot.toml", "read.csv", "--model", "18", "-o", "bare.json"),
    ("validate", "found.json", "unseen.csv", "--json"),
    ("validate", "held.json", "unseen.csv", "--json"),
    ("validate", "bare.json", "unseen.csv", "--json"),
    ("predict", "found.json", "unseen.csv", "-o", "told.csv"),
    ("certificate", "found.json", "unseen.csv", "-o", "certificate.html"),
    ("compare", "bare.json", "held.json"),
    ("next", "found.json", "-o", "next.csv"),
    ("study", "robot.toml", "--plan", "other.csv", "--model", "18", "--noise", NOISE, *SUSPECT, "-o", "study.json"),
    ("compensate", "found.json", "--export", "c", "-o", "command.c"),
]
MANY = {"derivation", "batch"}  # those of the tests that take longer


JOINTS = ("q1_deg", "q2_deg", "q3_deg")


@dataclass(frozen=True)
class Added:
    """The truth in which an effect is concealed, in the units of files, and the `columns` it depends on."""

    truth: dict[str, float]
    columns: tuple[str, ...]


ADDED = {
    "warm_compliance": Added({"softening": 0.002}, ("temp", "payload")),
    "preload": Added({"compliance": 0.02}, ("payload",)),
}


@pytest.fixture(scope="module", params=[pytest.param("warm_compliance", marks=pytest.mark.thorough), "preload"])
def added(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Checkout:
    """A copy of the sources to which an effect's file was added, with a machine that has it, and rows to measure."""
    name, case, robot = str(request.param), ADDED[request.param], machine()
    text = printed("add-effect", name)
    made = Checkout.with_files(tmp_path_factory.mktemp("sources"), "effects", {name: text})
    (made.folder / "robot.toml").write_text(robot_to_toml(robot), encoding="utf-8")
    values = "\n".join(f"{key} = {value}" for key, value in case.truth.items())
    truth = f'[[effects]]\nname = "{name}"\nlimb = {LIMB}\n{values}\n'
    (made.folder / "truth.toml").write_text(truth, encoding="utf-8")
    for n, seed, file in ((80, 1, "poses.csv"), (40, 2, "other.csv")):
        rows = wanted(scattered(robot, n, seed), frame="robot", channels=channels(n, *case.columns, seed=4 + seed))
        write_recording(rows, made.folder / file)
    return made


def written(made: Checkout, name: str, columns: dict[str, np.ndarray]) -> None:
    """Write columns as a CSV."""
    values = np.column_stack(list(columns.values()))
    np.savetxt(made.folder / name, values, fmt="%.12g", delimiter=",", header=",".join(columns), comments="")


def test_every_shared_test_takes_it(added: Checkout) -> None:
    passed = {test.partition("[")[0].partition("::")[2] for test in added.passed()}
    assert {
        "test_an_effect_moves_by_what_was_computed_by_hand",
        "test_columns_are_the_derivative_of_the_exact_equilibrium",
        "test_the_command_brings_the_machine_with_the_effect_to_the_target",
    } <= passed


@pytest.mark.thorough
def test_what_runs_over_all_effects_takes_it(added: Checkout) -> None:
    assert "tests/derive/test_states.py::test_references_hold_in_c" in added.all_passed()


@pytest.mark.thorough
def test_its_derivation_is_written(added: Checkout) -> None:
    added.deltacal(("derivation", added.name, "-o", "page.html"))
    assert added.name in (added.folder / "page.html").read_text(encoding="utf-8")


def test_every_command_takes_it(added: Checkout) -> None:
    """From a concealed effect to what is told of readings that nobody has seen."""
    name, folder, case = added.name, added.folder, ADDED[added.name]
    assert untried(*LINES) == MANY | GEOMETRY_ALONE
    said = added.deltacal(*LINES)
    assert name in {e["effect"] for e in json.loads(said[0])}
    found = json.loads((folder / "found.json").read_text(encoding="utf-8"))
    assert [(e["name"], e["limbs"]) for e in found["effects"]] == [(name, [LIMB])]
    for p in found["effects"][0]["parameters"]:
        assert abs(p["value"] - case.truth[p["name"]]) < 5 * p["std"]
    assert found["location"]["channels"]
    assert "nothing recorded" not in found["location"]["text"]
    with_it, held, without = (json.loads(text)["rms_mm"] for text in said[6:9])
    assert max(with_it, held) < 2.5 * NOISE < without / 2
    told, read = (np.genfromtxt(folder / file, delimiter=",", names=True) for file in ("told.csv", "unseen.csv"))
    missed = np.column_stack([told[f"{a}_mm"] - read[f"{a}_mm"] for a in "xyz"])
    assert np.sqrt(np.mean(missed**2)) < 2.5 * NOISE
    studied = json.loads((folder / "study.json").read_text(encoding="utf-8"))["suspects"]
    (tried,) = (s for s in studied if s["effects"])
    assert (tried["effects"], tried["named_right"]) == ([{"name": name, "limbs": [LIMB]}], 1)


def test_the_true_machine_sent_by_it_stands_where_it_was_wanted(added: Checkout) -> None:
    """By the commands of a file of targets, and by those of the exported C, but for what it states."""
    name, folder, case = added.name, added.folder, ADDED[added.name]
    if not (folder / "command.c").exists():
        added.deltacal(*(LINES[k] for k in (1, 3, -1)))
    targets = scattered(machine(), 20, 3)
    now = {k: v for k, v in channels(20, *case.columns, seed=9).items() if not k.startswith("time")}
    written(added, "targets.csv", dict(zip(("x_mm", "y_mm", "z_mm"), targets.T, strict=True)) | now)
    added.deltacal(("compensate", "found.json", "targets.csv", "-o", "joints.csv"))
    joints = np.genfromtxt(folder / "joints.csv", delimiter=",", names=True)
    sent = [np.column_stack([joints[q] for q in JOINTS])]
    text = (folder / "command.c").read_text(encoding="utf-8")
    assert f"{name} at limb {LIMB}" in text
    if COMPILER:
        sent.append(commanded_in_c(added, targets, now))
    every = dict(zip(JOINTS, np.vstack(sent).T, strict=True))
    written(added, "sent.csv", every | {k: np.tile(v, len(sent)) for k, v in now.items()})
    (folder / "sent.toml").write_text('[measurement]\nkind = "position"\nframe = "robot"\n', encoding="utf-8")
    added.deltacal(("simulate", "robot.toml", "sent.csv", "-o", "stood.csv", "--truth", "truth.toml"))
    stood = np.genfromtxt(folder / "stood.csv", delimiter=",", names=True)
    error = np.column_stack([stood[f"{a}_mm"] for a in "xyz"]) - np.tile(targets, (len(sent), 1))
    assert np.sqrt(np.mean(np.sum(error[:20] ** 2, axis=1))) < 0.01
    stated = float(re.findall(r"Error left  (\S+) mm", text)[-1])
    assert np.linalg.norm(error, axis=1).max() < stated + 0.03  # and what the readings leave open


@pytest.mark.thorough
def test_many_recordings_of_it_are_diagnosed(added: Checkout) -> None:
    cell = added.folder / "hall" / "press"
    cell.mkdir(parents=True)
    shutil.copy(added.folder / "robot.toml", cell)
    added.deltacal(
        ("simulate", "robot.toml", "poses.csv", "-o", cell / "read.csv", *WITH_TRUTH, "--seed", 1),
        ("batch", "hall", "-o", "run", "--workers", 1),
    )
    (task,) = (added.folder / "run" / "tasks").rglob("*.json")
    effects = json.loads(task.read_text(encoding="utf-8"))["result"]["effects"]
    assert [(e["name"], e["limbs"]) for e in effects] == [(added.name, [LIMB])]


def compiled(folder: Path) -> ctypes.CDLL:
    """Return what was exported as a library."""
    library = folder / "command.so"
    flags = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O2", "-shared", "-fPIC")
    subprocess.run([str(COMPILER), *flags, "-o", str(library), str(folder / "command.c"), "-lm"], check=True)
    return ctypes.CDLL(str(library))


def commanded_in_c(made: Checkout, targets: np.ndarray, now: dict[str, np.ndarray]) -> np.ndarray:
    """Return the joints (N, 3) [deg] that the exported C commands."""
    function, rows = compiled(made.folder).deltacal_command, []
    none = np.zeros(len(targets))
    for target, warm, payload in zip(targets, now.get("temp_C", none + 20), now.get("payload_kg", none), strict=True):
        out = (ctypes.c_double * 3)()
        at = At(warm, payload, 0.0, (ctypes.c_double * 3)())
        assert function((ctypes.c_double * 3)(*target), ctypes.byref(at), out) == 0
        rows.append(list(out))
    return np.array(rows)


HOSE, PULL = "hose_pull", 0.4  # Nm/deg
OF_DRIVE = f'[[effects]]\nname = "{HOSE}"\nlimb = {LIMB}\nstiffness = {PULL}\n'
THREE = ctypes.c_double * 3


class Held(ctypes.Structure):
    """What is kept between calls, as the head of the file of a chain has it."""

    _fields_ = (("joints", THREE), ("torque", THREE), ("period_s", ctypes.c_double), ("begun", ctypes.c_int))


def test_an_effect_of_a_drive_is_found_and_fed_forward(tmp_path_factory: pytest.TempPathFactory) -> None:
    """Of the true machine's torques without noise the exported C leaves less than the noise it was found in."""
    made = Checkout.with_files(tmp_path_factory.mktemp("sources"), "effects", {HOSE: printed("add-effect", HOSE)})
    folder = made.folder
    planned(folder, OF_DRIVE, runs=3, seconds=6.0)
    given = np.degrees(trajectory(1.0, 7))
    names = [
        f"{word}{i}_{unit}" for word, unit in (("q", "deg"), ("qd", "deg_s"), ("qdd", "deg_s2")) for i in (1, 2, 3)
    ]
    written(
        made, "states.csv", dict(zip(["time_s", *names], [0.01 * np.arange(100), *np.hstack([*given]).T], strict=True))
    )
    (folder / "states.toml").write_text('[measurement]\nkind = "torque"\n[motion]\nderivatives = "recorded"\n')
    truth = ("--truth", "truth.toml")
    made.deltacal(
        ("simulate", "robot.toml", "trajectory.csv", "-o", "read.csv", *truth, "--noise", TORQUE_NOISE, "--seed", 1),
        ("simulate", "robot.toml", "states.csv", "-o", "stood.csv", *truth),
        ("diagnose", "robot.toml", "read.csv", "-o", "found.json"),
        ("compensate", "found.json", "--export", "c", "-o", "command.c"),
    )
    (effect,) = json.loads((folder / "found.json").read_text(encoding="utf-8"))["effects"]
    assert (effect["name"], effect["limbs"]) == (HOSE, [LIMB])
    (p,) = effect["parameters"]
    assert abs(p["value"] - PULL) < 5 * p["std"]
    if COMPILER:
        stood = np.genfromtxt(folder / "stood.csv", delimiter=",", names=True)
        function, held = compiled(folder).deltacal_feedforward_joints, Held(period_s=0.01)
        for row, at in zip(stood, np.swapaxes(given, 0, 1), strict=True):
            none = ctypes.c_double(0.0)
            assert function(ctypes.byref(held), *(THREE(*part) for part in at), none, none) == 0
            assert np.abs(np.array(held.torque) - [row[f"tau{i}_Nm"] for i in (1, 2, 3)]).max() < TORQUE_NOISE
