"""The linear delta of printers against a machine written by hand; heights and distances; its own effects."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import root
from scipy.spatial.transform import Rotation

import deltacal_gen as dc
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.files.robot import Robot, robot_from_dict
from deltacal_gen.identification.identification import identify
from deltacal_gen.instrument.kinds import readings
from deltacal_gen.machine.registry import SOLVED, Array
from deltacal_gen.pages import figures
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.reading import reading_shift
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import blank, coefficients, load_effect
from deltacal_gen.units import DEG
from deltacal_gen.use.prediction import predict
from tests.support.commands import Run
from tests.support.printers import LINEAR, PRINTER, grid, plausible, recording
from tests.support.prototype import displacement

pytestmark = pytest.mark.usefixtures("compiled")

Z = np.array([0.0, 0.0, 1.0])


@pytest.fixture(scope="module")
def printer() -> Robot:
    return robot_from_dict(PRINTER)


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(12)


def rod_gaps(robot: Robot, e: dict[str, float], q: Array, at: Array) -> Array:
    """Return how much longer than itself each of the six rods would be at a pose (6,): by hand, SciPy's rotations."""
    g = {name: np.broadcast_to(value, 3) for name, value in robot.geometry.items()}
    out = []
    for i in range(3):
        err = {k: e.get(f"{k}_{i + 1}", 0.0) for k in LINEAR.errors}
        angle = g["tower_angle"][i] + err["angle"]
        u, t = np.array([np.cos(angle), np.sin(angle), 0.0]), np.array([-np.sin(angle), np.cos(angle), 0.0])
        radius = g["radius"][i] + e.get("radius", 0.0) + err["radius"]
        arm = g["arm_length"][i] + err["arm"]
        home = g["endstop"][i] + err["endstop"] + np.sqrt(arm**2 - radius**2)
        axis = Rotation.from_rotvec(err["lean_radial"] * t - err["lean_tangential"] * u).apply(Z)
        foot = (radius + g["effector_radius"][i]) * u
        carriage = foot + axis * (home / axis[2]) - axis * q[i] * (1 + err["scale"])
        turn = Rotation.from_rotvec(at[3:])
        for side in (1, -1):
            half = side * g["rod_spacing"][i] / 2 * t
            ball = at[:3] + turn.apply(g["effector_radius"][i] * u + half - robot.tool)
            out.append(np.linalg.norm(ball - carriage - half) - arm - side * err["dl"] / 2)
    return np.array(out)


# ------------------------------------------------------------------------------------------------------ the machine


def test_the_machine_is_the_one_written_by_hand(printer: Robot, rng: np.random.Generator) -> None:
    robot = dataclasses.replace(printer, tool=np.array([5.0, -3.0, -20.0]))
    errors = plausible(rng)
    rows = LINEAR.rows(robot, LINEAR.vector(errors))
    targets = rng.uniform([-80, -80, 0], [80, 80, 120], (10, 3))
    q, x, status = LINEAR.inverse(targets, robot.tool, rows)
    assert (status == SOLVED).all()
    for joints, pose in zip(q, x, strict=True):
        found = root(lambda at, j=joints: rod_gaps(robot, errors, j, at), np.r_[pose[:3] + 1.0, 0.01, 0.0, -0.01])
        assert found.success
        assert found.x[:3] == pytest.approx(pose[:3], abs=1e-8)
        assert Rotation.from_rotvec(found.x[3:]).as_matrix() == pytest.approx(pose[3:].reshape(3, 3), abs=1e-10)


def test_without_errors_it_is_what_firmware_computes(printer: Robot, rng: np.random.Generator) -> None:
    """Trilateration of the carriages, lower solution (Klipper, klippy/kinematics/delta.py)."""
    q = rng.uniform(200, 330, (20, 3))
    x, status = LINEAR.forward(q, printer.tool, LINEAR.rows(printer))
    g = printer.geometry
    height = g["endstop"] + np.sqrt(g["arm_length"] ** 2 - g["radius"] ** 2) - q
    towers = g["radius"] * np.array([np.cos(g["tower_angle"]), np.sin(g["tower_angle"])])
    for h, pose in zip(height[status == SOLVED], x[status == SOLVED], strict=True):
        assert np.hypot(*(pose[:2, None] - towers)) ** 2 + (pose[2] - h) ** 2 == pytest.approx(g["arm_length"] ** 2)
        assert (pose[2] < h).all()
    assert (status == SOLVED).sum() > 15


def test_carriages_at_their_endstops_put_the_nozzle_at_the_endstop(printer: Robot) -> None:
    even = dataclasses.replace(printer, geometry=printer.geometry | {"endstop": np.full(3, 300.0)})
    x, _ = LINEAR.forward(np.zeros((1, 3)), even.tool, LINEAR.rows(even))
    assert x[0, :3] == pytest.approx([0, 0, 300.0], abs=1e-9)


@pytest.mark.parametrize(("lean", "error"), [("lean_radial", "radius"), ("lean_tangential", "angle")])
def test_towers_lean_outwards_and_counter_clockwise(lean: str, error: str, printer: Robot) -> None:
    """At one height of the carriage, a lean is a larger radius or angle of the tower."""
    q = np.array([[310.0, 280.0, 290.0]])
    small = 1e-4
    g = printer.geometry
    home = g["endstop"][2] + np.sqrt(g["arm_length"][2] ** 2 - g["radius"][0] ** 2)
    way = small * (home - q[0, 2])  # of the carriage
    # a larger radius lowers the endstop too (contract, section 1): not in a lean
    drop = g["radius"][0] / np.sqrt(g["arm_length"][2] ** 2 - g["radius"][0] ** 2)
    same = {"radius_3": way, "endstop_3": drop * way} if error == "radius" else {"angle_3": way / g["radius"][0]}
    plain, leaning, other = (
        LINEAR.forward(q, printer.tool, LINEAR.rows(printer, LINEAR.vector(e)))[0][0, :3]
        for e in ({}, {f"{lean}_3": small}, same)
    )
    assert leaning - plain == pytest.approx(other - plain, abs=0.01 * np.linalg.norm(other - plain))
    assert np.linalg.norm(other - plain) > 0.1 * way


def test_sensitivities_are_the_derivatives_of_the_exact_pose(printer: Robot, rng: np.random.Generator) -> None:
    errors = LINEAR.vector(plausible(rng))
    q, x, _ = LINEAR.inverse(grid(60, 40, 20.0), printer.tool, LINEAR.rows(printer, errors))
    S = LINEAR.sensitivity(x, q, printer.tool, LINEAR.rows(printer, errors)).parameters
    for j, p in enumerate(LINEAR.parameters):
        gaps = []
        for h in (0.1 * p.typical, 0.05 * p.typical):
            step = h * np.eye(len(errors))[j]
            plus, minus = (
                LINEAR.forward(q, printer.tool, LINEAR.rows(printer, errors + s * step), near=x)[0] for s in (1, -1)
            )
            gaps.append(np.abs(displacement(minus, plus) / (2 * h) - S[:, :, j]).max())
        assert gaps[1] < gaps[0] / 3 or gaps[0] < 1e-7 * max(np.abs(S[:, :, j]).max(), 1.0), p.name


def test_both_kernels_agree(printer: Robot, rng: np.random.Generator) -> None:
    errors = LINEAR.vector(plausible(rng))
    constants = LINEAR.vectorised.constants(LINEAR.rows(printer, errors))
    q, out = rng.uniform(230, 300, (8, 3)), []
    for kernels in (LINEAR.compiled, LINEAR.vectorised):
        x, status = np.empty((8, 6)), np.empty(8, dtype=np.int64)
        kernels.forward(q, np.zeros((8, 3)), constants, x, status, False)
        assert (status == SOLVED).all()
        out.append(x)
    assert out[0] == pytest.approx(out[1], abs=1e-9)


def test_effector_joints_and_rod_spacing_cancel_while_rods_are_equal(printer: Robot, rng: np.random.Generator) -> None:
    errors = {n: v for n, v in plausible(rng).items() if not n.startswith("dl")}
    other = dataclasses.replace(
        printer, geometry=printer.geometry | {"effector_radius": np.array([80.0]), "rod_spacing": np.array([20.0])}
    )
    q = rng.uniform(230, 300, (5, 3))
    a, b = (LINEAR.forward(q, r.tool, LINEAR.rows(r, LINEAR.vector(errors)))[0] for r in (printer, other))
    assert a == pytest.approx(b, abs=1e-8)


# ------------------------------------------------------------------------------------------------------ its readings


def test_heights_give_back_what_firmware_fits(printer: Robot, rng: np.random.Generator) -> None:
    truth = plausible(rng, LINEAR.model("linear_delta/6"))
    done = simulate(printer, recording(printer, grid()), truth)
    found = identify(printer, done, "6").answer()
    assert found["train_rms_mm"] < 1e-6
    given = {p["name"]: p["value"] * (DEG if p["unit"] == "deg" else 1.0) for p in found["parameters"]}
    for name, value in truth.items():
        assert given[name] == pytest.approx(value, abs=1e-4), name


def test_seven_heights_carry_six_parameters(printer: Robot, rng: np.random.Generator) -> None:
    """Firmware's own points; the leanest session in use."""
    angles = np.radians([0, 60, 120, 180, 240, 300])
    points = np.vstack([[0, 0, 0], np.column_stack([90 * np.cos(angles), 90 * np.sin(angles), 0 * angles])])
    truth = plausible(rng, LINEAR.model("linear_delta/6"))
    done = simulate(printer, recording(printer, points), truth, noise_mm=0.01, rng=rng)
    found = identify(printer, done).answer()
    assert found["model"] == "linear_delta/6"
    assert found["readings"]["scalars"] == 7
    assert found["train_rms_mm"] < 0.03


def test_a_session_of_seven_heights_names_no_physics_and_says_why(printer: Robot, rng: np.random.Generator) -> None:
    """A bent belt pulley is in the readings all the same; six parameters of seven readings take it over."""
    angles = np.radians([0, 60, 120, 180, 240, 300])
    points = np.vstack([[0, 0, 0], np.column_stack([90 * np.cos(angles), 90 * np.sin(angles), 0 * angles])])
    term = blank("transmission_eccentricity", (2,), (1.0,)).with_values(np.array([0.1, 0.1]))
    done = simulate(printer, recording(printer, points), {}, noise_mm=0.01, rng=rng, terms=[term])
    found = dc.diagnose(printer, done)
    assert (found["verdict"], found["effects"], found["baseline"]["model"]) == ("adequate", [], "linear_delta/6")
    assert "7 readings and 6 parameters of linear_delta/6, 1 degree of freedom" in found["summary"]
    assert all("at least 25 readings" in t["missing"] for t in found["not_tested"])


@pytest.mark.parametrize("radius", [95.0, 180.0])
def test_a_wrong_radius_is_told_by_few_heights(radius: float, printer: Robot, rng: np.random.Generator) -> None:
    """Fewer than two heights to a parameter, which noise of decimetres would otherwise explain."""
    done = simulate(printer, recording(printer, grid(100, 28)), {"endstop_1": 0.4}, noise_mm=0.01, rng=rng)
    assert len(done.joints) < 2 * 21
    wrong = robot_from_dict(PRINTER | {"geometry": PRINTER["geometry"] | {"radius": radius}})
    answer = identify(wrong, done).answer()
    [doubt] = answer.doubts or ()
    assert "radius" in doubt
    assert answer.train_rms_mm < 0.05
    summary = dc.diagnose(wrong, done)["summary"]
    assert "Compare the file's dimensions" in summary
    assert "leaves no more" not in summary


def test_heights_and_distances_count_each_with_its_own_noise(printer: Robot, rng: np.random.Generator) -> None:
    heights = grid(90, 30)
    printed = rng.uniform([-70, -70, 2], [70, 70, 30], (40, 3))
    pairs = len(heights) + np.arange(40).reshape(-1, 2)
    poses = recording(printer, np.vstack([heights, printed]), pairs=pairs)
    truth = plausible(rng, LINEAR.model("linear_delta/9"))
    exact = simulate(printer, poses, truth)
    assert np.isfinite(exact.measured[:, 0]).sum() == len(heights)
    done = dataclasses.replace(
        exact,
        measured=exact.measured + 0.01 * rng.standard_normal(exact.measured.shape),
        pair_measured=exact.pair_measured + 0.1 * rng.standard_normal(20),
    )
    fit = identify(printer, done, "9").fit
    assert fit.problem.readings.kind.name == "height and distance"
    assert fit.sigma == pytest.approx([0.01, 0.1], rel=0.6)
    n = len(fit.problem.names)
    got = np.array([fit.errors[LINEAR.index[name]] for name in fit.problem.names])
    want = np.array([truth[name] for name in fit.problem.names])
    gap = got - want
    assert gap @ np.linalg.solve(fit.covariance[:n, :n], gap) < 40  # chi2 of 9 numbers
    back = predict(identify(printer, done, "9").answer(), done)
    assert np.nanstd(back.measured - exact.measured) < 0.02
    assert np.std(back.pair_measured - exact.pair_measured) < 0.1


def test_a_few_heights_leave_the_size_of_what_is_printed_open(printer: Robot, rng: np.random.Generator) -> None:
    """Klipper's author: other parameters give "a flat bed but absurd settings for any other position"."""
    done = simulate(printer, recording(printer, grid(60, 30)), {}, noise_mm=0.03, rng=rng)
    status = {p["name"]: p["status"] for p in identify(printer, done, "9").answer()["parameters"]}
    assert status["arm_1"] == "not pinned"


# ------------------------------------------------------------------------------------------------------- its effects


@pytest.mark.parametrize("name", ["tower_lean", "effector_tilt", "transmission_eccentricity", "bed_shape"])
def test_columns_are_the_derivative_of_the_exact_machine(name: str, printer: Robot) -> None:
    poses = recording(printer, grid(80, 40, 10.0))
    problem = pose_problem(printer, poses, (), found=readings(simulate(printer, poses)))
    body, every = problem.body, np.arange(poses.n_rows)
    term = blank(name, (1, 3), (2.0,) if name == "transmission_eccentricity" else ())
    errors = LINEAR.vector({})
    machine, _ = body.solve(errors, [term])
    S = LINEAR.sensitivity(machine.x, machine.q, machine.tool, machine.rows)
    shifts = reading_shift([term], body, problem.readings, machine.x[:, 2:3], machine.x)[1]
    columns = body.columns([term], machine, S, every)[:, 2] + shifts[:, 0]

    def height(values: Array) -> Array:
        moved = term.with_values(values)
        x = body.solve(errors, [moved])[0].x
        return (x[:, 2:3] + reading_shift([moved], body, problem.readings, x[:, 2:3], x)[0])[:, 0]

    for j in range(term.n_coefficients):
        step = 1e-4 * np.eye(term.n_coefficients)[j]
        assert (height(step) - height(-step)) / 2e-4 == pytest.approx(columns[:, j], abs=1e-5)
        assert np.abs(columns[:, j]).max() > 1e-3


def test_an_effector_hangs_on_its_rods_and_carriages_bear_what_they_carry(printer: Robot) -> None:
    ideal, tool = dataclasses.replace(printer, errors={}), np.zeros(3)
    q, x, _ = LINEAR.inverse(np.array([[0.0, 0.0, 40.0]]), tool, LINEAR.rows(ideal))
    masses = {"platform": 0.6, "carriage": 0.3}
    loads = LINEAR.loads(x, q, tool, LINEAR.rows(ideal), masses, np.array([0.0, 0.0, -9.81]))
    arm, radius = ideal.geometry["arm_length"], ideal.geometry["radius"]
    upright = np.sqrt(arm**2 - radius**2) / arm
    assert (loads.tension.sum(axis=2) @ upright)[0] == pytest.approx(0.6 * 9.81)
    assert loads.torque.sum() == pytest.approx((0.6 + 3 * 0.3) * 9.81)  # carriages count downwards


def test_joint_effects_read_mm_for_deg_where_joints_slide() -> None:
    assert coefficients(load_effect("backlash"), "rad") == (("width", "deg", DEG),)
    assert coefficients(load_effect("backlash"), "mm") == (("width", "mm", 1.0),)
    assert coefficients(load_effect("joint_compliance"), "mm") == (("compliance", "mm/N", 1.0),)
    assert coefficients(load_effect("tower_lean"), "mm")[0] == ("radial", "deg", DEG)
    assert coefficients(load_effect("joint_scale"), "mm") == (("scale", "1", 1.0),)


def test_a_periodic_error_needs_the_pulley(printer: Robot) -> None:
    bare = dataclasses.replace(printer, transmission=None)
    poses = recording(printer, grid(40, 40))
    body = Body(bare, LINEAR, poses.joints, np.zeros((poses.n_rows, 3)), Channels.of(poses, bare))
    assert "pulley_circumference" in str(body.missing("transmission_eccentricity"))


def test_a_periodic_error_of_a_belt_is_found_with_its_pulley(
    tmp_path: Path, printer: Robot, run: Run, rng: np.random.Generator
) -> None:
    targets = rng.uniform([-90, -90, 0], [90, 90, 100], (220, 3))
    term = blank("transmission_eccentricity", (2,), (1.0,)).with_values(np.array([0.03, 0.04]))
    truth = plausible(rng, LINEAR.model("linear_delta/9"))
    done = simulate(printer, recording(printer, targets, "position"), truth, noise_mm=0.01, rng=rng, terms=[term])
    found = dc.diagnose(printer, done)
    assert found["verdict"] == "missing_physics"
    assert [e["name"] for e in found["effects"]] == ["transmission_eccentricity"]
    effect = found["effects"][0]
    assert effect["limbs"] == [2]
    got = {p["name"]: p for p in effect["parameters"]}
    assert got["order"]["value"] == 1.0
    assert got["cos"]["value"] == pytest.approx(0.03, abs=0.01)
    assert got["cos"]["unit"] == "mm"


def test_a_lag_of_carriages_shows_along_a_column_that_was_recorded(printer: Robot, rng: np.random.Generator) -> None:
    targets = rng.uniform([-90, -90, 0], [90, 90, 100], (80, 3))
    poses = recording(printer, targets, "position")
    motion = {f"qd{i}_mm_s": np.round(60 * rng.standard_normal(80), 2) for i in (1, 2, 3)}
    motion |= {f"qdd{i}_mm_s2": np.round(800 * rng.standard_normal(80), 1) for i in (1, 2, 3)}
    poses = dataclasses.replace(poses, channels=motion)
    lag = blank("latency", ()).with_values(np.array([0.004]))
    done = simulate(printer, poses, noise_mm=0.01, rng=rng, terms=[lag])
    found = dc.diagnose(printer, done)
    assert [e["name"] for e in found["effects"]] == ["latency"]
    assert {c["name"] for c in found["location"]["channels"]} == set(motion)
    assert figures.main_channel(found) == "qd1_mm_s"  # which it is drawn against


def test_models_lists_it(run: Run) -> None:
    _, out, _ = run("models", "--json")
    entry = next(m for m in json.loads(out) if m["mechanism"] == "linear_delta")
    assert {f"linear_delta/{n}" for n in (3, 6, 9, 21)} <= entry["models"].keys()
