"""What every machine answers alike, whether limbs close loops or links make a chain."""

from __future__ import annotations

import copy
import dataclasses
import pickle
from typing import Any

import numpy as np
import pytest

from deltacal_gen.errors import UsageError
from deltacal_gen.files.robot import Robot, read_robot
from deltacal_gen.machine.limbs import _solved
from deltacal_gen.machine.registry import POSE, SOLVED, Machine, mechanism_names, mechanism_of
from derive.review.checks import Poses, spread
from tests.support.drawn import example_of

SMALL = 1e-6  # of a step [mm, rad]: its square is what first order leaves


@pytest.fixture(params=mechanism_names())
def robot(request: Any) -> Robot:
    """The example's machine as each mechanism describes it, with errors of half the ordinary size."""
    drawn = dataclasses.replace(
        read_robot(example_of(request.param) / "robot.toml"), mechanism=request.param, tolerance={}, errors={}
    )
    mechanism, rng = mechanism_of(drawn), np.random.default_rng(8)
    sizes = 0.5 * mechanism.typical * rng.uniform(-1, 1, len(mechanism.typical))
    return dataclasses.replace(drawn, errors={p.name: s for p, s in zip(mechanism.parameters, sizes, strict=True)})


@pytest.fixture
def machine(robot: Robot) -> Machine:
    return mechanism_of(robot)


@pytest.fixture
def poses(robot: Robot) -> Poses:
    return spread(robot, 20)


def test_another_process_takes_the_machine_that_is_loaded_there(machine: Machine) -> None:
    assert pickle.loads(pickle.dumps(machine)) is machine
    assert copy.deepcopy(machine) is machine


def test_its_platform_stands_where_its_last_frame_is(robot: Robot, machine: Machine, poses: Poses) -> None:
    """But for the tool point, and in a chain for its errors."""
    rows = machine.rows(dataclasses.replace(robot, errors={}))
    origins, rotations = machine.frames(poses.q, rows)
    x, status = machine.forward(poses.q, np.zeros(3), rows)
    assert (status == SOLVED).all()
    np.testing.assert_allclose(origins[:, -1], x[:, :3], rtol=0, atol=1e-9)
    np.testing.assert_allclose(rotations[:, -1], x[:, 3:].reshape(-1, 3, 3), rtol=0, atol=1e-12)
    assert (origins[:, 0] == 0).all()
    assert (rotations[:, 0] == np.eye(3)).all()


def test_it_is_led_to_every_target_that_it_takes(robot: Robot, machine: Machine, poses: Poses) -> None:
    rows = machine.rows(robot)
    for width in machine.widths:
        target = poses.x[:, :width].copy()
        if width == 3 and machine.turning and machine.looped:  # positions of a level platform
            continue
        q, x, status = machine.inverse(target, robot.tool, rows, robot.geometric_limits)
        if width < POSE or machine.limbs >= len(machine.platform):
            assert (status == SOLVED).all()
            assert np.abs(machine.missed(x, target)).max() < 1e-7
        again, _ = machine.follow(target, q if machine.many_ways else None, np.tile(robot.tool, (len(q), 1)), rows)
        np.testing.assert_allclose(again, q, rtol=0, atol=1e-9, equal_nan=True)
    for width in {3, POSE} - set(machine.widths):
        with pytest.raises((UsageError, ValueError), match="shape"):
            machine.inverse(poses.x[:, :width], robot.tool, rows) if width == POSE else machine.targets(poses.x[:, :5])


def test_what_moved_is_undone(robot: Robot, machine: Machine, poses: Poses) -> None:
    """A small shift of the reference point, as far as a command asks for it, by a small step of the joints."""
    rows, rng = machine.rows(robot), np.random.default_rng(4)
    moved = machine.sensitivity(poses.x, poses.q, poses.tool, rows).joints @ rng.uniform(-SMALL, SMALL, machine.limbs)
    step = machine.undo(moved, poses.x, poses.q, poses.tool, rows)
    x, _ = machine.forward(poses.q + step, poses.tool, rows, near=poses.x)
    left = machine.missed(x, poses.x if machine.turning else poses.x[:, :3])
    left = left + machine.asked(moved if machine.turning else moved[:, :3])
    assert np.abs(left).max() < 1e-3 * np.abs(moved).max()


def test_what_only_some_can_do_is_refused_by_name(robot: Robot, machine: Machine, poses: Poses) -> None:
    if not machine.looped:
        with pytest.raises(UsageError, match="no loops to close"):
            machine.jacobians(poses.x, poses.q, poses.tool, machine.rows(robot))
    if not machine.written_out:
        for ask in (lambda: machine.servo, lambda: machine.constants(machine.rows(robot))):
            with pytest.raises(UsageError, match=f"commands of {machine.sort} are not written out"):
                ask()
    if 3 not in machine.widths:
        with pytest.raises(UsageError, match=f"a position alone does not say how {machine.sort} shall stand"):
            machine.inverse(poses.x[:, :3], robot.tool, machine.rows(robot))
    with pytest.raises(ValueError, match=r"targets have the shape \(5, 4\)"):
        machine.targets(np.zeros((5, 4)))


def test_systems_that_have_no_solution_spoil_no_others() -> None:
    A = np.array([np.eye(3), np.zeros((3, 3)), np.full((3, 3), np.nan), 2 * np.eye(3)])
    assert np.array_equal(_solved(A, np.ones((4, 3))), np.outer([1.0, np.nan, np.nan, 0.5], np.ones(3)), equal_nan=True)
