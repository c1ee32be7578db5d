"""Two clocks in kind torque: what drives give on one, their joints on another."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.robot import robot_to_toml
from deltacal_gen.machine.dynamics import dynamics_of
from tests.support.commands import Run
from tests.support.motion_recordings import BODIED, DEG, LINKS, NOISE, STEP, named, robot, usual, waves
from tests.support.moving_chains import bodies

OFFSET, RATE = {"a": 0.7342, "b": -0.2215}, 2e-4
Q, TAU = [f"q{i}_deg" for i in (1, 2, 3)], [f"tau{i}_Nm" for i in (1, 2, 3)]
Course = Callable[[np.ndarray, int], np.ndarray]  # joints with their derivatives (3, N, 3) by times and the run


def even(t: np.ndarray, run: int) -> np.ndarray:
    """Return joints that go up and down, all with one speed each: friction and weight do what a clock does."""
    rate = np.array([0.2, -0.1, 0.15])
    return np.stack([0.4 + rate * t[:, None], rate + 0 * t[:, None], 0 * rate * t[:, None]])


def circling(t: np.ndarray, run: int) -> np.ndarray:
    """Return joints that come back after each two seconds."""
    out = np.zeros((3, len(t), 3))
    for n, size in ((1, 0.3), (2, 0.15), (3, 0.08)):
        w, phase = n * np.pi, n * np.array([0.3, 1.0, 2.0])
        angle = w * t[:, None] + phase
        out += size * np.stack([np.sin(angle), w * np.cos(angle), -(w**2) * np.sin(angle)])
    return out


def table(path: Path, names: list[str], runs: dict[str, np.ndarray]) -> None:
    rows = [",".join([run, *(f"{v:.6f}" for v in row)]) for run, some in runs.items() for row in some]
    path.write_text("\n".join([",".join(["run", *names]), *rows]) + "\n")


def written(folder: Path, course: Course = waves, clock: str = "own", **kept: Any) -> Path:
    """Write joints and what drives give in some runs, each on its clock; return the path of the joints."""
    machine, rng = robot(), np.random.default_rng(3)
    own, inertia = dynamics_of(machine), bodies(LINKS).ravel()
    rate, late = kept.get("rate", RATE), kept.get("late", (0.0, 0.0, 0.0))
    joints, readings = {}, {}
    for k, (run, offset) in enumerate(kept.get("offsets", OFFSET).items()):
        t = np.arange(0, kept.get("seconds", 8.0), STEP)
        q = course(t, k)[0] / DEG + 0.001 * rng.standard_normal((len(t), 3))
        joints[run] = np.column_stack([t, q])
        when = np.arange(0.3, t[-1] - 0.4, 0.007)  # on the joints' clock
        tau = NOISE * rng.standard_normal((len(when), 3))
        for j, delay in enumerate(late):
            states = course(when - delay, k + kept.get("other", 0))
            load = own.torque(states, inertia) / 1000
            tau[:, j] += (load + usual(states, load))[:, j]
        readings[run] = np.column_stack([(when - offset) / (1 + rate), tau])
    path = folder / "recording.csv"
    table(path, ["time_s", *Q], joints)
    table(folder / "recording.instrument.csv", ["time_s", *TAU], readings)
    path.with_suffix(".toml").write_text(f'[measurement]\nkind = "torque"\nclock = "{clock}"\n')
    (folder / "robot.toml").write_text(robot_to_toml(machine))
    return path


def clocks(found: Any) -> dict[tuple[str, str | None], Any]:
    return {(p["name"], p.get("run")): p for p in found["parameters"] if p["name"].startswith("clock")}


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(tmp_path_factory.mktemp("clocks"))


@pytest.fixture(scope="module")
def diagnosed(recorded: Path) -> Any:
    return dc.diagnose(recorded.with_name("robot.toml"), recorded)


@pytest.mark.walk
def test_offsets_and_rate_are_found_with_the_friction(diagnosed: Any) -> None:
    found = clocks(diagnosed)
    truth = {("clock_offset", run): value for run, value in OFFSET.items()} | {("clock_rate", None): RATE}
    assert found.keys() == truth.keys()
    for key, p in found.items():
        assert abs(p["value"] - truth[key]) < 4 * p["std"], (key, p)
        assert p["std"] < (0.1e-3 if p["unit"] == "s" else 2e-5)
    assert named(diagnosed) == {"coulomb_friction": [1, 2], "viscous_friction": [1, 3]}
    assert diagnosed["final"]["heldout_rms_by_joint"] == pytest.approx([NOISE] * 3, rel=0.1)
    assert len(diagnosed["parameters"]) == diagnosed["rank"] + 3


@pytest.mark.walk
def test_the_rigid_machine_is_identified_beside_its_clocks(recorded: Path, tmp_path: Path) -> None:
    found = dc.identify(recorded.with_name("robot.toml"), recorded, report=tmp_path / "page.html")
    assert clocks(found)["clock_offset", "b"]["value"] == pytest.approx(OFFSET["b"], abs=0.5e-3)
    assert "clock_rate" in (tmp_path / "page.html").read_text()


@pytest.mark.walk
def test_a_result_knows_the_clocks_of_its_runs(recorded: Path, diagnosed: Any, run: Run, tmp_path: Path) -> None:
    assert dc.validate(diagnosed.to_dict(), recorded)["rms_by_joint"] == pytest.approx([NOISE] * 3, rel=0.1)
    (tmp_path / "result.json").write_text(diagnosed.to_json())
    code, *_ = run("predict", tmp_path / "result.json", recorded, "-o", tmp_path / "predicted.csv")
    assert code == 0
    lines = (tmp_path / "predicted.csv").read_text().splitlines()
    given = recorded.with_name("recording.instrument.csv").read_text().splitlines()
    assert lines[0] == ",".join(["run", "time_s", *Q, *TAU])
    assert [line.split(",")[:1] for line in lines] == [line.split(",")[:1] for line in given]


@pytest.mark.walk
def test_another_run_needs_its_offset(recorded: Path, diagnosed: Any, tmp_path: Path) -> None:
    for end in (".csv", ".instrument.csv"):
        text = recorded.with_name(f"recording{end}").read_text()
        (tmp_path / f"new{end}").write_text(text.replace("\na,", "\nc,"))
    said = recorded.with_suffix(".toml").read_text()
    (tmp_path / "new.toml").write_text(said)
    with pytest.raises(InputError, match="in run 'c' is not known"):
        dc.predict(diagnosed, tmp_path / "new.csv")
    (tmp_path / "new.toml").write_text(f"{said}clock_offset_s = {OFFSET['a']}\n")
    assert dc.validate(diagnosed, tmp_path / "new.csv")["rms_by_joint"] == pytest.approx([NOISE] * 3, rel=0.1)


@pytest.mark.walk
def test_a_joint_that_comes_late_beside_the_others_moves_no_clock(tmp_path: Path) -> None:
    """That of the second joint, whose readings tell the time most sharply."""
    path = written(tmp_path, late=(0.0, 0.012, 0.0))
    found = dc.diagnose(tmp_path / "robot.toml", path)
    assert clocks(found)["clock_offset", "a"]["value"] == pytest.approx(OFFSET["a"], abs=0.5e-3)
    (late,) = (e for e in found["effects"] if e["name"] == "latency")
    assert late["limbs"] == [2]
    assert late["parameters"][0]["value"] == pytest.approx(0.012, abs=0.2e-3)


@pytest.mark.parametrize(
    ("clock", "offsets", "rate"),
    [("own, same for all runs", {"a": 0.5, "b": 0.5}, 1e-4), ("own, same rate", {"a": -3.2, "b": 1.1}, 0.0)],
)
def test_what_clocks_have_in_common_is_one_number(
    tmp_path: Path, clock: str, offsets: dict[str, float], rate: float
) -> None:
    found = clocks(dc.identify(tmp_path / "robot.toml", written(tmp_path, clock=clock, offsets=offsets, rate=rate)))
    if clock == "own, same rate":
        assert {run: p["value"] for (_, run), p in found.items()} == pytest.approx(offsets, abs=0.5e-3)
    else:
        assert set(found) == {("clock_offset", None), ("clock_rate", None)}
        assert found["clock_offset", None]["value"] == pytest.approx(0.5, abs=0.5e-3)
        assert found["clock_rate", None]["value"] == pytest.approx(rate, abs=4 * found["clock_rate", None]["std"])


@pytest.mark.parametrize(
    ("course", "other", "words"),
    [
        (even, 0, "does not tell its clock|follow the joints|do as well|does not settle"),
        (circling, 0, "since the movement repeats itself"),
        (waves, 7, "follow the joints at no offset|do as well|does not settle"),
    ],
)
def test_a_movement_that_tells_no_clock_is_refused(tmp_path: Path, course: Course, other: int, words: str) -> None:
    path = written(tmp_path, course, offsets={"a": 0.3}, rate=0.0, other=other)
    with pytest.raises(InputError, match=f"cannot be aligned in time: .*({words})"):
        dc.diagnose(tmp_path / "robot.toml", path)


def test_which_of_the_repetitions_it_is_can_be_said(tmp_path: Path) -> None:
    path = written(tmp_path, circling, offsets={"a": 0.3}, rate=0.0)
    with path.with_suffix(".toml").open("a") as sidecar:
        sidecar.write("clock_offset_s = 0.31\n")
    found = clocks(dc.identify(tmp_path / "robot.toml", path))
    assert found["clock_offset", "a"]["value"] == pytest.approx(0.3, abs=0.5e-3)


def test_a_simulation_has_the_clock_of_its_truth(tmp_path: Path) -> None:
    path = written(tmp_path, offsets={"a": 0.0}, rate=0.0)
    (tmp_path / "robot.toml").write_text(robot_to_toml(robot(BODIED)))
    (tmp_path / "truth.toml").write_text("[parameters]\nclock_offset = 0.037\nclock_rate = 2e-4\n")
    made = tmp_path / "made.csv"
    dc.simulate(tmp_path / "robot.toml", path, output=made, truth=tmp_path / "truth.toml", noise=NOISE)
    assert made.read_text() == path.read_text()
    found = clocks(dc.identify(tmp_path / "robot.toml", made))
    for (name, _), truth in zip(found, (0.037, 2e-4), strict=True):
        (p,) = (p for key, p in found.items() if key[0] == name)
        assert abs(p["value"] - truth) < 4 * p["std"], (name, p)
    path.with_suffix(".toml").write_text('[measurement]\nkind = "torque"\nclock = "own, same rate"\n')
    with pytest.raises(UsageError, match="the truth has a clock_rate"):
        dc.simulate(tmp_path / "robot.toml", path, truth=tmp_path / "truth.toml")


def test_recorded_derivatives_are_read_on_the_clock_of_the_joints(tmp_path: Path) -> None:
    path = written(tmp_path, offsets={"a": 0.3}, rate=0.0)
    t = np.arange(0, 8.0, STEP)
    q, qd, qdd = waves(t, 0) / DEG
    words = ("q{}_deg", "qd{}_deg_s", "qdd{}_deg_s2")
    names = [word.format(i) for word in words for i in (1, 2, 3)]
    table(path, ["time_s", *names], {"a": np.column_stack([t, q, qd, qdd])})
    with path.with_suffix(".toml").open("a") as sidecar:
        sidecar.write('[motion]\nderivatives = "recorded"\n')
    found = dc.identify(tmp_path / "robot.toml", path)
    assert found["motion"]["text"] == "velocities and accelerations as recorded"
    assert clocks(found)["clock_offset", "a"]["value"] == pytest.approx(0.3, abs=0.5e-3)
