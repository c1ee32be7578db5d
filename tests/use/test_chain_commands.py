"""Open chains are compensated and planned for: led to poses, measured at joints."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError, NoSolutionError, UsageError
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.accuracy import joint_spread
from deltacal_gen.identification.identifiability import identification_matrix, observability
from deltacal_gen.machine.registry import SOLVED, UNREACHABLE, mechanism_of
from deltacal_gen.machine.rotation import to_vector
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import blank
from deltacal_gen.planning import optimal, planning
from deltacal_gen.units import DEG
from deltacal_gen.use.compensation import Compensator
from tests.support.open_chains import ARM, by_hand, robot
from tests.support.planned import log_determinant
from tests.support.prototype import calibrated

LIMITS = {"limits_deg": [[-170, 170], [-30, 60], [50, 130], [-180, 180], [30, 150], [-180, 180]]}


def flawed(size: float = 1.0, **tables: object) -> Robot:
    """The arm with ordinary errors."""
    r = robot(joints=LIMITS, **tables)
    rng, m = np.random.default_rng(4), mechanism_of(r)
    for p in m.parameters:
        r.errors[p.name] = float(size * p.typical * rng.standard_normal())
    return r


def stands(count: int, seed: int = 1) -> np.ndarray:
    rng, (low, high) = np.random.default_rng(seed), DEG * np.array(LIMITS["limits_deg"]).T
    return low + (high - low) * rng.uniform(0.1, 0.9, (count, 6))


def test_commands_bring_the_flawed_arm_to_where_the_drawn_one_stands() -> None:
    r, drawn = flawed(), robot()
    for size in (1.0, 0.5):
        r = flawed(size)
        compensator, q = Compensator(r), stands(40)
        wanted = Compensator(drawn).pose(q)[0]
        joints, status = compensator.command(wanted, near=q)
        assert (status == SOLVED).all()
        for n in range(5):
            assert by_hand(r, joints[n], r.errors) == pytest.approx(wanted[n], abs=1e-8)
        assert np.abs(compensator.missed(joints, wanted)).max() < 1e-8
    assert 0.1 * DEG < np.abs(joints - q).max() < 20 * DEG


def test_what_first_order_leaves_is_of_second_order() -> None:
    q, left = stands(30), []
    for size in (0.2, 0.1):
        linear = Compensator(flawed(size), "linear")
        wanted = Compensator(robot()).pose(q)[0]
        left.append(np.median(np.abs(linear.missed(linear.command(wanted, near=q)[0], wanted)).max(axis=1)))
    assert left[0] / left[1] == pytest.approx(4.0, rel=0.2)


def test_an_arm_that_gives_way_is_led_where_it_is_wanted() -> None:
    gear = blank("joint_compliance", (2, 3))
    r, q = flawed(), stands(20)
    compensator = Compensator(r, terms=[gear.with_values(np.array([2e-8, 3e-8]))])
    at, _ = compensator.channels({"payload_kg": np.full(20, 4.0)}, 20)
    wanted = Compensator(robot()).pose(q)[0]
    joints = compensator.joints(wanted, None, at, q)
    assert np.abs(compensator.missed(joints, wanted, None, at)).max() < 1e-7
    assert np.abs(compensator.missed(Compensator(r).command(wanted, near=q)[0], wanted, None, at)[:, :3]).max() > 0.01


def test_poses_without_joints_choose_how_the_arm_stands_and_go_on_so(tmp_path: Path) -> None:
    r, q = flawed(), np.full(6, 0.6) + np.linspace(0, 0.3, 12)[:, None] * [1, -1, 1, 1, 1, 1] + [0, 0, 0.8, 0, 0.5, 0]
    wanted = Compensator(robot()).pose(q)[0]
    numbers = np.hstack([wanted[:, :3], to_vector(wanted[:, 3:].reshape(-1, 3, 3)) / DEG])
    joints = dc.compensate(calibrated(r), numbers)
    assert np.abs(Compensator(r).missed(joints * DEG, wanted)).max() < 1e-8
    assert np.abs(np.diff(joints, axis=0)).max() < 10  # no jump from one way of standing to another
    assert ((joints > np.array(LIMITS["limits_deg"])[:, 0]) & (joints < np.array(LIMITS["limits_deg"])[:, 1])).all()
    file = tmp_path / "targets.csv"
    np.savetxt(file, numbers, delimiter=",", comments="", header="x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg")
    assert dc.compensate(calibrated(r), file) == pytest.approx(joints, abs=1e-9)
    drawn = read_recording(file, mechanism_of(r), need_measured=False, allow_targets=True)
    reached = simulate(robot(joints=LIMITS), drawn, {})
    assert reached.measured[:, :3] == pytest.approx(numbers[:, :3], abs=1e-8)
    np.savetxt(file, numbers[:, :3], delimiter=",", comments="", header="x_mm,y_mm,z_mm")
    with pytest.raises(InputError, match="how an open chain shall stand"):
        dc.compensate(calibrated(r), file)


def test_a_program_in_joints_is_corrected_as_it_stands(tmp_path: Path) -> None:
    r, q, file = flawed(), stands(15), tmp_path / "program.csv"
    signed = robot(joints={"sign": [1, -1, 1, 1, -1, 1]})
    names = ",".join(f"q{i}_deg" for i in range(1, 7))
    np.savetxt(file, q / DEG, delimiter=",", comments="", header=names)
    joints = dc.compensate(calibrated(r), file, output=tmp_path / "joints.csv")
    assert np.abs(Compensator(r).missed(joints * DEG, Compensator(robot()).pose(q)[0])).max() < 1e-8
    written = np.loadtxt(tmp_path / "joints.csv", delimiter=",", skiprows=1)
    assert written[:, 1:] == pytest.approx(joints)
    counted = Compensator(signed).joints(Compensator(signed).pose(q * signed.joint_sign)[0], near=q * signed.joint_sign)
    assert counted == pytest.approx(q * signed.joint_sign, abs=1e-9)


def test_a_tool_that_nobody_wrote_down_is_no_error_of_the_machine(tmp_path: Path) -> None:
    """It is found; neither what calibration gains nor the commands of a program count where it sits."""
    untold = dataclasses.replace(robot(joints=LIMITS), tool=np.zeros(3))
    small = {name: 0.2 * value for name, value in flawed().errors.items()}
    truth = dataclasses.replace(untold, errors=small | {"tx": 10.0, "ty": -5.0, "tz": 160.0})
    q, file = stands(60), tmp_path / "poses.csv"
    names = ",".join(f"q{i}_deg" for i in range(1, 7))
    np.savetxt(file, q / DEG, delimiter=",", comments="", header=names)
    read = simulate(
        truth,
        read_recording(file, mechanism_of(untold), need_measured=False),
        noise_mm=0.01,
        rng=np.random.default_rng(1),
    )
    found = dc.identify(untold, read, output=tmp_path / "result.json")
    assert 0.1 < found["before_rms_mm"] < 2.0
    assert found["accuracy"]["before"]["distance_mm"] < 10.0
    joints = dc.compensate(found, file)
    assert 0 < np.abs(joints - q / DEG).max() < 3.0


def test_near_its_singularity_the_wrist_stays_and_what_it_leaves_is_told(tmp_path: Path) -> None:
    r, told = flawed(), []
    q = stands(3)
    q[:, 4] = 0.0
    wanted = Compensator(robot()).pose(q)[0]
    joints, _ = Compensator(r).command(wanted, near=q)
    missed = Compensator(r).missed(joints, wanted)
    assert np.abs(missed[:, :3]).max() < 1e-8
    assert 1e-5 < np.abs(missed[:, 3:]).max() < 1 * DEG
    assert np.abs(joints - q).max() < 20 * DEG
    free = calibrated(dataclasses.replace(r, joint_limits=None))
    file = tmp_path / "program.csv"
    np.savetxt(file, q / DEG, delimiter=",", comments="", header=",".join(f"q{i}_deg" for i in range(1, 7)))
    dc.compensate(free, file, tell=told.append)
    assert [words for words in told if "near singular" in words]


def test_an_arm_in_the_plane_commands_the_plane() -> None:
    links = [{"kind": "revolute", "a": a} for a in (300.0, 250.0, 80.0)]
    r = robot(links)
    r.errors.update({"a_1": 0.4, "alpha_1": 0.1 * DEG, "theta_2": 0.2 * DEG, "d_3": 0.3, "beta_2": 0.05 * DEG})
    q = np.random.default_rng(2).uniform(0.3, 1.5, (10, 3))
    wanted = Compensator(robot(links)).pose(q)[0]
    joints, status = Compensator(r).command(wanted, near=q)
    missed = Compensator(r).missed(joints, wanted)
    assert (status == SOLVED).all()
    assert np.abs(missed[:, :2]).max() < 1e-8
    assert np.abs(missed[:, 2]).max() > 0.1
    assert np.abs(joints - q).max() < 2 * DEG


def test_what_cannot_be_reached_is_named() -> None:
    r, q = flawed(), stands(2)
    wanted = Compensator(robot()).pose(q)[0]
    wanted[1, :3] *= 3
    assert Compensator(r).command(wanted, near=q)[1].tolist() == [SOLVED, UNREACHABLE]
    with pytest.raises(NoSolutionError, match="target 2"):
        Compensator(r).joints(wanted, near=q)
    near_limit = stands(1)
    near_limit[:, 0] = 170 * DEG - 1e-6
    r.errors["theta_1"] = -0.5 * DEG
    with pytest.raises(NoSolutionError, match="joint 1 would go to"):
        Compensator(r).joints(Compensator(robot()).pose(near_limit)[0], near=near_limit)
    with pytest.raises(UsageError, match="how it stands is part of every command"):
        Compensator(r).servo()


@pytest.mark.parametrize("kind", ["position", "pose", "distance"])
def test_a_plan_has_the_rank_and_the_matrix_of_its_recording(kind: str, tmp_path: Path) -> None:
    r = robot(joints=LIMITS)
    found = planning.plan_poses(r, "dh", kind=kind, n_max=14, sigma_mm=0.01)
    assert found.steps[0].rank == len(found.names) == 21  # 4 by joint and 6, less the frame; of a pose the body too
    low, high = np.array(LIMITS["limits_deg"]).T * DEG
    assert ((found.poses.joints >= low) & (found.poses.joints <= high)).all()
    assert len(np.unique(found.poses.joints, axis=0)) == len(found.poses)
    assert found.prediction is not None
    planning.write_targets(found, tmp_path / "poses.csv")
    read = read_recording(tmp_path / "poses.csv", mechanism_of(r), need_measured=False, allow_targets=True)
    problem = pose_problem(r, simulate(r, read), found.names, as_distance=kind == "distance")
    if kind != "pose":  # whose turns count in rad there
        H = identification_matrix(problem, "typical").H
        step = next(step for step in found.steps if step.poses == len(found.poses))
        assert observability(H, step.poses).condition == pytest.approx(step.condition, rel=1e-6)


def test_d_optimal_joints_beat_those_drawn() -> None:
    r = robot(joints=LIMITS)
    best = optimal.plan_optimal_poses(r, "dh", 12, kind="pose")
    drawn = joint_spread(r, 12)
    assert best.steps[0].condition < 50
    assert log_determinant(best, best.poses.joints) > log_determinant(best, drawn) + 5
    with pytest.raises(UsageError, match="plan at least"):
        optimal.plan_optimal_poses(r, "dh", 3)


def test_a_parallel_robot_is_planned_for_poses_too(robot: Robot) -> None:
    found = planning.plan_poses(robot, "36", kind="pose", n_max=6)
    assert found.tools.shape == (1, 3)
    assert found.steps[-1].rank == len(found.names)
    assert len(found.names) >= len(planning.plan_poses(robot, "36", kind="position", tools=1, n_max=6).names)


def test_sliding_joints_need_limits_to_be_planned() -> None:
    with pytest.raises(InputError, match="sliding joints"):
        planning.plan_poses(robot([ARM[0] | {"kind": "prismatic"}] * 3), "dh")
