"""Exact simulation, and the truth files it takes."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

from deltacal_gen.errors import InputError, NoSolutionError
from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import Machine
from deltacal_gen.machine.rotation import from_vector, to_vector
from deltacal_gen.physics.simulation import read_truth, simulate
from deltacal_gen.units import DEG
from tests.support.prototype import plausible, scattered, wanted


def test_targets_are_commanded_by_the_nominal_machine_and_reached_by_the_true_one(
    robot: Robot, mechanism: Machine
) -> None:
    targets, errors, tool = scattered(robot, 8, 1), plausible(mechanism, 2), np.array([20.0, 10.0, -40.0])
    recording = simulate(robot, wanted(targets, frame="robot", tool=tool), errors)
    q, _, _ = mechanism.inverse(targets, tool, mechanism.rows(robot, np.zeros(42)))
    x, _ = mechanism.forward(q, tool, mechanism.rows(robot, mechanism.vector(errors)))
    assert recording.joints == pytest.approx(q, abs=1e-12)
    assert recording.measured == pytest.approx(x[:, :3], abs=1e-9)
    assert recording.targets is None
    turned = np.column_stack([recording.channels[f"true_r{a}_deg"] for a in "xyz"]) * DEG
    assert not {f"true_r{a}_deg" for a in "xyz"} & recording.told.keys()
    assert turned == pytest.approx(to_vector(x[:, 3:].reshape(-1, 3, 3)), abs=1e-12)


def test_a_perfect_machine_attains_its_targets(robot: Robot) -> None:
    targets = scattered(robot, 8, 1)
    assert simulate(robot, wanted(targets, frame="robot")).measured == pytest.approx(targets, abs=1e-9)


def test_joints_are_taken_where_they_are_given(robot: Robot) -> None:
    first = simulate(robot, wanted(scattered(robot, 8, 1), frame="robot"), {"L_1": 0.3})
    again = simulate(robot, dataclasses.replace(first, measured=np.zeros((8, 0))), {"L_1": 0.3})
    assert again.joints.tolist() == first.joints.tolist()
    assert again.measured == pytest.approx(first.measured, abs=1e-9)


def test_the_robot_s_own_errors_are_simulated_unless_others_are_given(robot: Robot) -> None:
    off = dataclasses.replace(robot, errors={"L_2": 0.5})
    targets = scattered(robot, 4, 1)
    own, given, none = (simulate(off, wanted(targets, frame="robot"), e).measured for e in (None, {"L_2": 0.5}, {}))
    assert own.tolist() == given.tolist()
    assert none == pytest.approx(targets, abs=1e-9)
    assert np.abs(own - none).max() > 0.1


def test_noise_has_its_size_and_comes_from_the_generator_alone(robot: Robot) -> None:
    poses = wanted(scattered(robot, 400, 1), frame="robot")
    exact = simulate(robot, poses).measured
    first, same, other = (
        simulate(robot, poses, noise_mm=0.01, rng=np.random.default_rng(s)).measured for s in (1, 1, 2)
    )
    assert first.tolist() == same.tolist()
    assert np.std(first - exact) == pytest.approx(0.01, rel=0.06)  # 1200 numbers: 2 %
    assert np.abs(np.corrcoef((first - exact).ravel(), (other - exact).ravel())[0, 1]) < 0.1
    with pytest.raises(ValueError, match="noise needs a random generator"):
        simulate(robot, poses, noise_mm=0.01)


def test_noise_is_declared_in_the_sidecar(robot: Robot) -> None:
    poses = wanted(scattered(robot, 4, 1))
    rng = np.random.default_rng(1)
    assert simulate(robot, poses, noise_mm=0.01, rng=rng).measurement.sigma_mm == 0.01
    assert simulate(robot, poses).measurement.sigma_mm is None
    said = wanted(scattered(robot, 4, 1), sigma_mm=0.02)
    assert simulate(robot, said, noise_mm=0.01, rng=rng).measurement.sigma_mm == 0.02


def test_noise_stands_in_the_unit_of_the_readings(robot: Robot) -> None:
    """Of a second encoder in deg; declared is what the file would call it."""
    poses = dataclasses.replace(wanted(scattered(robot, 400, 1)), kind="encoder", columns=("enc1_deg",))
    rng = np.random.default_rng(1)
    exact = simulate(robot, poses, rng=np.random.default_rng(1)).measured
    made = simulate(robot, poses, noise=0.02, rng=rng)
    assert np.std(made.measured - exact) == pytest.approx(0.02 * DEG, rel=0.06)
    assert (made.measurement.sigma_deg, made.measurement.sigma_mm) == (0.02, None)


def test_rotations_have_a_share_of_the_noise_that_is_declared(robot: Robot) -> None:
    """What 100 mm from the point is as large, where the sidecar says nothing of it."""
    poses = wanted(scattered(robot, 400, 1), "pose")
    exact = simulate(robot, poses, rng=np.random.default_rng(1)).measured
    made = simulate(robot, poses, noise=0.01, rng=np.random.default_rng(1))
    assert np.std(made.measured[:, 3:] - exact[:, 3:]) == pytest.approx(1e-4, rel=0.1)
    assert made.measurement.sigma_deg == pytest.approx(1e-4 / DEG)
    said = dataclasses.replace(poses, measurement=dataclasses.replace(poses.measurement, sigma_deg=0.003))
    less = simulate(robot, said, noise=0.01, rng=np.random.default_rng(1))
    assert np.std(less.measured[:, 3:] - exact[:, 3:]) == pytest.approx(0.003 * DEG, rel=0.1)


def test_an_unknown_frame_moves_readings_rigidly(robot: Robot) -> None:
    targets = scattered(robot, 6, 1)
    turn, origin = np.array([0.4, -0.1, 2.0]), np.array([100.0, 200.0, 300.0])
    inside = simulate(robot, wanted(targets, frame="robot")).measured
    outside = simulate(robot, wanted(targets), frame=(turn, origin)).measured
    assert outside == pytest.approx(inside @ from_vector(turn).T + origin, abs=1e-9)
    drawn = simulate(robot, wanted(targets), rng=np.random.default_rng(1)).measured
    gap = [np.linalg.norm(p[1:] - p[:-1], axis=1) for p in (inside, drawn)]
    assert gap[0] == pytest.approx(gap[1], abs=1e-9)
    assert np.linalg.norm(drawn - inside) > 100


def test_rotations_are_about_the_instrument_s_axes(robot: Robot, mechanism: Machine) -> None:
    """Up to a constant rotation, which is none here: a platform that stands parallel reads zero."""
    targets = scattered(robot, 6, 1)
    turn, origin = np.array([0.4, -0.1, 2.0]), np.zeros(3)
    assert simulate(robot, wanted(targets, "pose"), frame=(turn, origin)).measured[:, 3:] == pytest.approx(0, abs=1e-12)
    errors = plausible(mechanism, 2)
    own = simulate(robot, wanted(targets, "pose", frame="robot"), errors).measured[:, 3:]
    seen = simulate(robot, wanted(targets, "pose"), errors, frame=(turn, origin)).measured[:, 3:]
    assert np.abs(own).max() > 1e-4
    assert seen == pytest.approx(own @ from_vector(turn).T, abs=1e-12)


def test_distances_and_gauge_lengths_are_those_of_the_positions(robot: Robot, mechanism: Machine) -> None:
    targets, errors = scattered(robot, 6, 1), plausible(mechanism, 2)
    P = simulate(robot, wanted(targets, frame="robot"), errors).measured
    pairs = np.array([[0, 3], [5, 1]])
    measured = simulate(robot, wanted(targets, "distance", pairs=pairs), errors).pair_measured
    assert measured == pytest.approx(np.linalg.norm(P[[0, 5]] - P[[3, 1]], axis=1), abs=1e-9)
    base = (300.0, 10.0, -20.0)
    gauge = simulate(robot, wanted(targets, "gauge", base_point_mm=base), errors).measured[:, 0]
    assert gauge == pytest.approx(np.linalg.norm(P - base, axis=1), abs=1e-9)
    counted = simulate(robot, wanted(targets, "gauge", base_point_mm=base, zero="incremental"), errors).measured[:, 0]
    assert counted == pytest.approx(gauge - gauge[0], abs=1e-9)


def test_a_gauge_s_point_on_the_platform_is_used(robot: Robot) -> None:
    targets = scattered(robot, 4, 1)
    base, point = (0.0, 0.0, 0.0), (0.0, 0.0, -50.0)
    gauge = simulate(robot, wanted(targets, "gauge", base_point_mm=base, platform_point_mm=point)).measured[:, 0]
    assert gauge == pytest.approx(np.linalg.norm(targets, axis=1), abs=1e-9)  # the point itself is what is commanded


def test_a_target_out_of_reach_is_named_by_its_line(robot: Robot) -> None:
    targets = scattered(robot, 4, 1)
    targets[2] = [0.0, 0.0, -3000.0]
    with pytest.raises(NoSolutionError, match=r"recording.csv, line 4: the target cannot be commanded: out of reach"):
        simulate(robot, wanted(targets))


# ---------------------------------------------------------------------------------------------------------- truth files


def truth_file(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "truth.toml"
    path.write_text(text)
    return path


def test_a_truth_file_is_read_in_mm_and_deg(tmp_path: Path, robot: Robot) -> None:
    path = truth_file(tmp_path, "[parameters]\ntheta_1 = 0.5\nL_2 = -0.2\nalpha03_3 = 0.1\n")
    assert read_truth(path, robot).errors == pytest.approx({"theta_1": 0.5 * DEG, "L_2": -0.2, "alpha03_3": 0.1 * DEG})


def test_an_unknown_parameter_is_refused_with_its_line_and_a_guess(tmp_path: Path, robot: Robot) -> None:
    with pytest.raises(InputError, match=r"line 3: delta has no parameter 'alpa0_1'. Did you mean 'alpha0_1'\?"):
        read_truth(truth_file(tmp_path, "[parameters]\nL_1 = 0.2\nalpa0_1 = 0.5\n"), robot)
