"""Studies of a trajectory: what Monte Carlo finds is what the linear problem predicts and identifications state."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.app import commands
from deltacal_gen.app.demonstration import example
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.robot import read_robot, robot_to_toml
from deltacal_gen.results.reader import read_answer
from deltacal_gen.results.trajectories import MotionStudy

MACHINES = 200
FRICTION = """
[[effects]]
name = "coulomb_friction"
limb = 1
coulomb = 0.5

[[effects]]
name = "viscous_friction"
limbs = [2, 3]
viscous = 0.02
"""


@pytest.fixture(scope="module")
def planned(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Write an exciting trajectory of the example delta; return its path."""
    file = tmp_path_factory.mktemp("planned") / "trajectory.csv"
    commands.plan(example() / "robot.toml", None, file, kind="torque", runs=3, period=6.0)
    return file


@pytest.fixture(scope="module")
def found(planned: Path) -> Any:
    return commands.study(example() / "robot.toml", planned, noise=0.05, trials=MACHINES, workers=1)


def test_scatter_is_what_the_linear_problem_predicts_and_identifications_state(found: Any) -> None:
    """Friction that is found beside the bodies takes its part of what is known of them: `stated` holds with it."""
    scatter = 1 / np.sqrt(2 * MACHINES)
    for key in ("predicted_std", "stated_std"):
        ratio = np.array([p["std"] / p[key] for p in found["parameters"]])
        assert np.abs(ratio - 1).max() < 4 * scatter, key
        assert np.sqrt(np.mean(ratio**2)) == pytest.approx(1.0, abs=0.05), key
    for torque in found["torque"]:
        assert torque["after_rms"] == pytest.approx(torque["predicted_rms"], rel=0.08)
        assert torque["after_rms"] < 0.05 * torque["before_rms"]


def test_what_is_added_leaves_what_is_said(found: Any, planned: Path, tmp_path: Path) -> None:
    """The same trajectory once more, written as further runs."""
    lines = planned.read_text().splitlines()
    more = [f"{int(line.partition(',')[0]) + 3},{line.partition(',')[2]}" for line in lines[1:]]
    twice = tmp_path / "twice.csv"
    twice.write_text("\n".join([*lines, *more]) + "\n")
    twice.with_suffix(".toml").write_text(planned.with_suffix(".toml").read_text())
    (said,) = [a for a in found["add"] if a["add"].startswith("the same")]
    again = commands.study(example() / "robot.toml", twice, noise=0.05, trials=1, workers=1)
    left = [t["predicted_rms"] for t in again["torque"]]
    assert left == pytest.approx(said["rms_by_joint"], rel=1e-6)


def test_workers_change_nothing_and_the_answer_is_read_back(found: Any, planned: Path, tmp_path: Path) -> None:
    both = commands.study(
        example() / "robot.toml", planned, tmp_path / "s.json", noise=0.05, trials=MACHINES, workers=2
    )
    assert both.to_json() == found.to_json()
    assert isinstance(read_answer(tmp_path / "s.json"), MotionStudy)


def test_suspects_are_concealed_and_diagnosed(planned: Path, tmp_path: Path) -> None:
    (tmp_path / "friction.toml").write_text(FRICTION)
    (tmp_path / "warm.toml").write_text('[[effects]]\nname = "warm_friction"\nlimb = 2\nwarm = 0.001\n')
    suspects = (tmp_path / "friction.toml", tmp_path / "warm.toml")
    page = tmp_path / "page.html"
    answer: Any = commands.study(
        example() / "robot.toml", planned, noise=0.05, trials=2, suspects=suspects, diagnoses=1, workers=1, report=page
    )
    nothing, friction, warm = answer["suspects"]
    assert nothing["named_right"] == 1
    assert friction["named_right"] == 1
    assert [(e["name"], e["limbs"]) for e in friction["effects"]] == [
        ("coulomb_friction", [1]),
        ("viscous_friction", [2, 3]),
    ]
    assert warm["recordings"] == 0
    assert [c["name"] for c in answer["channels_wanted"]] == ["warm_friction"]
    assert "temp_C" in page.read_text()


def test_what_a_trajectory_hardly_tells_is_said_so(planned: Path, tmp_path: Path) -> None:
    """Where joints only creep, bodies are seen by their weight alone, and masses and inertias stand for one another."""
    lines = planned.read_text().splitlines()
    slow, page = tmp_path / "slow.csv", tmp_path / "page.html"
    rows = [line.split(",")[:5] for line in lines]
    slow.write_text(
        "\n".join(",".join([r[0], repr(20 * float(r[1])), *r[2:]]) if n else ",".join(r) for n, r in enumerate(rows))
    )
    slow.with_suffix(".toml").write_text('[measurement]\nkind = "torque"\nsigma_Nm = 0.05\n')
    answer: Any = commands.study(example() / "robot.toml", slow, trials=30, workers=1, report=page)
    assert all(p["std"] > 10 * p["drawn_std"] for p in answer["parameters"])
    assert all(p["stated_std"] > 10 * p["drawn_std"] for p in answer["parameters"])
    assert "it tells less than the robot file says already" in page.read_text()


def test_what_cannot_be_studied_is_refused(planned: Path, tmp_path: Path) -> None:
    robot = read_robot(example() / "robot.toml")
    with pytest.raises(InputError, match="how well drives are read"):
        commands.study(robot, planned)
    with pytest.raises(UsageError, match="'model' means nothing"):
        commands.study(robot, planned, noise=0.05, model="delta/18")
    amperes = tmp_path / "amperes.csv"
    lines = planned.read_text().splitlines()
    head = f"{lines[0]},current1_A,current2_A,current3_A"
    amperes.write_text("\n".join([head, *(f"{line},0,0,0" for line in lines[1:])]) + "\n")
    amperes.with_suffix(".toml").write_text(planned.with_suffix(".toml").read_text())
    with pytest.raises(InputError, match="per ampere"):
        commands.study(robot, amperes, noise=0.05, trials=1)
    bare = tmp_path / "robot.toml"
    bare.write_text(robot_to_toml(dataclasses.replace(robot, masses=None)))
    with pytest.raises(dc.InputError):
        commands.study(bare, planned, noise=0.05, trials=1)
