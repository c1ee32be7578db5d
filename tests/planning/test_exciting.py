"""Exciting trajectories: within limits, from rest to rest, and better told than movements at random."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.errors import NoSolutionError, UsageError
from deltacal_gen.files.robot import robot_to_toml
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Robot, Workspace
from deltacal_gen.planning.exciting import Excitation, Series, plan_trajectories
from deltacal_gen.units import DEG
from tests.support.every_effect import ARM, chain, machines

SPEED, ACCELERATION = (80.0, 70.0, 60.0), (300.0, 250.0, 200.0)  # deg/s, deg/s^2


def limited(robot: Robot) -> Robot:
    """Return a Delta with limits of its own for every joint."""
    limits = {f"qd{i}_deg_s": (-v, v) for i, v in enumerate(SPEED, start=1)}
    limits |= {f"qdd{i}_deg_s2": (-v, v) for i, v in enumerate(ACCELERATION, start=1)}
    ends = np.array([[-45.0, 30.0], [-30.0, 45.0], [-35.0, 25.0]]) * DEG
    return dataclasses.replace(robot, limits=limits, joint_limits=ends)


@pytest.fixture(scope="module")
def planned() -> tuple[Robot, Any, tuple[Series, ...]]:
    robot = limited(machines()[0])
    return robot, *plan_trajectories(robot, runs=2, period=8.0)


@pytest.mark.walk
def test_no_limit_is_passed_between_samples_either(planned: tuple[Robot, Any, tuple[Series, ...]]) -> None:
    robot, _, series = planned
    for s in series:
        _within(robot, s, np.array(SPEED) * DEG, np.array(ACCELERATION) * DEG)


@pytest.mark.parametrize(("period", "harmonics"), [(1.0, 5), (3.0, 11), (10.0, 5)])
def test_nor_is_it_by_any_series_that_is_drawn(period: float, harmonics: int) -> None:
    """Many waves in a short period are few samples of each."""
    robot = limited(machines()[0])
    search = Excitation(robot, period, harmonics, 5)
    for _ in range(8):
        _within(robot, search.changed(search.drawn(), 0.5), search.speed, search.acceleration)


def _within(robot: Robot, series: Series, speed: np.ndarray, acceleration: np.ndarray) -> None:
    """Hold a series against all limits, at several times the samples by which it was judged."""
    assert robot.joint_limits is not None
    assert robot.workspace is not None
    q, qd, qdd = series.states(np.linspace(0, series.period, 2003))
    low, high = robot.joint_limits.T
    rounding = 1e-12
    assert (q >= low - rounding).all()
    assert (q <= high + rounding).all()
    assert (np.abs(qd) <= speed + rounding).all()
    assert (np.abs(qdd) <= acceleration + rounding).all()
    machine = mechanism_of(robot)
    x = machine.positions(robot.joint_sign * q, robot.tool, machine.rows(robot))
    assert robot.workspace.holds(x).all()


@pytest.mark.walk
def test_it_is_as_large_as_some_limit_lets_it_be(planned: tuple[Robot, Any, tuple[Series, ...]]) -> None:
    robot, _, series = planned
    assert robot.joint_limits is not None
    for s in series:
        q, qd, qdd = s.states(np.linspace(0, 8, 801))
        used = np.concatenate(
            [np.abs(qd).max(axis=0) / np.array(SPEED), np.abs(qdd).max(axis=0) / np.array(ACCELERATION)]
        )
        ends = np.min([robot.joint_limits[:, 1] - q.max(axis=0), q.min(axis=0) - robot.joint_limits[:, 0]])
        assert used.max() / DEG > 0.98 or ends < 0.5 * DEG or not _holds_more(robot, s)


def _holds_more(robot: Robot, series: Series) -> bool:
    """Tell whether the workspace would hold a movement that is a twentieth larger."""
    machine = mechanism_of(robot)
    q = series.times(1.05).states(np.linspace(0, 8, 801))[0]
    assert robot.workspace is not None
    return bool(robot.workspace.holds(machine.positions(robot.joint_sign * q, robot.tool, machine.rows(robot))).all())


@pytest.mark.walk
def test_it_goes_from_rest_to_rest_and_its_derivatives_are_its_own(
    planned: tuple[Robot, Any, tuple[Series, ...]],
) -> None:
    _, _, series = planned
    for s in series:
        ends, h = s.states(np.array([0.0, 8.0])), 1e-5
        assert ends[1:] == pytest.approx(np.zeros((2, 2, 3)), abs=1e-12)
        assert ends[0, 0] == pytest.approx(ends[0, 1], abs=1e-12)
        t = np.linspace(0.1, 7.9, 50)
        before, at, after = (s.states(t + d) for d in (-h, 0, h))
        assert (after[:2] - before[:2]) / (2 * h) == pytest.approx(at[1:], abs=1e-7)


@pytest.mark.walk
def test_it_tells_more_than_movements_at_random(planned: tuple[Robot, Any, tuple[Series, ...]]) -> None:
    """Than every one of forty that are as large as limits let them be, in both figures."""
    robot, answer, series = planned
    search = Excitation(robot, 8.0, 5, 77)

    def told(movement: Series) -> tuple[float, float]:
        W = search.columns(movement)
        return search.judge(W.T @ W)

    others = np.array([told(search.drawn()) for _ in range(40)])
    condition, determinant = told(series[0])
    assert condition < np.median(others[:, 0]) / 1.5
    assert determinant > others[:, 1].max()
    assert answer.readings == (600, 1200)


def test_a_chain_without_limits_is_planned_and_what_is_assumed_is_said() -> None:
    answer, (series,) = plan_trajectories(chain(ARM), runs=1, harmonics=3)
    assert len(answer.notes) == 3
    assert answer.condition[0] is not None
    assert np.abs(series.states(np.linspace(0, 10, 1001))[1]).max() <= 60.5 * DEG


def test_a_workspace_that_holds_nothing_is_said() -> None:
    robot = dataclasses.replace(machines()[0], workspace=Workspace(top=3000.0, radius=10.0, height=10.0))
    with pytest.raises(NoSolutionError, match="does not reach the middle of its workspace"):
        plan_trajectories(robot)


def test_too_few_harmonics_are_refused() -> None:
    with pytest.raises(UsageError, match="two harmonics"):
        plan_trajectories(machines()[0], harmonics=1)


def test_the_command_writes_what_simulate_takes(tmp_path: Path, run: Callable[..., Any]) -> None:
    robot, out = tmp_path / "robot.toml", tmp_path / "plan.csv"
    robot.write_text(robot_to_toml(limited(machines()[0])))
    small = ("--runs", 1, "--period", 4, "--harmonics", 3, "--rate", 50)
    code, shown, _ = run("plan", robot, "--kind", "torque", *small, "-o", out, "--picture", tmp_path / "plan.svg")
    assert code == 0
    assert "1 runs of 4 s" in " ".join(shown.split()) or "condition number" in shown
    assert (tmp_path / "plan.svg").read_text().count("<path") > 20
    done: Any = dc.simulate(robot, out)
    assert done.n_rows == 201
    assert np.isfinite(done.readings).all()
    table = np.genfromtxt(out, delimiter=",", names=True)
    assert done.joints[:, 1] == pytest.approx(table["q2_deg"] * DEG, abs=1e-12)
    assert run("plan", robot)[0] == 2


def test_an_arm_begins_where_its_workspace_is() -> None:
    """The middle of its joints' limits lies outside."""
    arm = dc.read_robot(example("serial") / "robot.toml")
    assert arm.joint_limits is not None
    assert arm.workspace is not None
    machine = mechanism_of(arm)

    def places(q: np.ndarray) -> np.ndarray:
        return machine.positions(arm.joint_sign * q, arm.tool, machine.rows(arm))

    assert not arm.workspace.holds(places(arm.joint_limits.mean(axis=1)[None])).any()
    _, series = plan_trajectories(arm, runs=1, period=8.0)
    q = series[0].states(np.linspace(0, 8, 401))[0]
    low, high = arm.joint_limits.T
    assert (q >= low - 1e-9).all()
    assert (q <= high + 1e-9).all()
    assert arm.workspace.holds(places(q)).all()
