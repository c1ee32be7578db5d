"""Compensators: exact to rounding, linear to second order and equal to the paper's, exports as good as they state."""

from __future__ import annotations

import copy
import ctypes
import gc
import inspect
import math
import pickle
import re
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numba import njit

from deltacal_gen.app.demonstration import example
from deltacal_gen.errors import InputError, NoSolutionError, UsageError
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import Robot, read_robot
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import SINGULAR, SOLVED, UNREACHABLE, load_mechanism
from deltacal_gen.machine.values import Workspace
from deltacal_gen.physics.terms import Term
from deltacal_gen.use.compensation import Compensator, CompensatorKind
from deltacal_gen.use.exporters.c import export_c
from deltacal_gen.use.exporters.table import TableCompensator, export_table, read_table

DEG = math.pi / 180
SCALE = Term("joint_scale", (1, 2, 3), np.full((3, 1), 1e-3))
DELTA = load_mechanism("delta")
TEXT = """
[robot]
name = "prototype"
mechanism = "delta"
[geometry]
base_radius = 200.0
platform_radius = 51.0
proximal_length = 375.0
distal_length = 950.0
joint_spacing = 100.0
[workspace]
top = 728.0
radius = 500.0
height = 250.0
"""


@pytest.fixture(scope="module")
def prototype(tmp_path_factory: pytest.TempPathFactory) -> Robot:
    path = tmp_path_factory.mktemp("robot") / "prototype.toml"
    path.write_text(TEXT, encoding="utf-8")
    return read_robot(path)


def drawn(seed: int, scale: float = 1.0) -> dict[str, float]:
    """Errors of a machine, a degree of encoder offset and tenths of millimetres and degrees."""
    rng = np.random.default_rng(seed)
    return {p.name: scale * p.typical * rng.normal() for p in DELTA.parameters}


def targets(count: int, seed: int = 0, radius: float = 500.0) -> np.ndarray:
    rng = np.random.default_rng(seed)
    r, turn = radius * np.sqrt(rng.random(count)), 2 * np.pi * rng.random(count)
    return np.column_stack([r * np.cos(turn), r * np.sin(turn), -728.0 - 250.0 * rng.random(count)])


# --- exact ----------------------------------------------------------------------------------------------------------


def test_the_exact_command_leaves_nothing_over_the_workspace(prototype: Robot) -> None:
    large = {"theta": 5 * DEG, "alpha0": 1 * DEG, "beta0": 1 * DEG, "alpha03": 1 * DEG, "beta2": 1 * DEG}
    rng = np.random.default_rng(1)
    errors = {p.name: large.get(p.error, 3.0 if p.unit == "mm" else DEG) * rng.uniform(-1, 1) for p in DELTA.parameters}
    robot = replace(prototype, errors=errors, tool=np.array([30.0, -20.0, -80.0]))
    left = Compensator(robot).round_trip()
    assert left.points > 2000
    assert left.missed == 0
    assert left.worst_mm < 1e-9


@settings(max_examples=60, derandomize=True, deadline=None)
@given(
    scale=st.floats(0, 4),
    seed=st.integers(0, 10_000),
    r=st.floats(0, 500),
    turn=st.floats(0, 2 * math.pi),
    z=st.floats(-978, -728),
)
def test_round_trip(prototype: Robot, scale: float, seed: int, r: float, turn: float, z: float) -> None:
    compensator = Compensator(replace(prototype, errors=drawn(seed, scale)))
    target = np.array([[r * math.cos(turn), r * math.sin(turn), z]])
    joints, status = compensator.command(target)
    assert status[0] == SOLVED
    assert np.abs(compensator.reached(joints)[0] - target).max() < 1e-9


def test_exact_agrees_with_the_inverse_position(prototype: Robot) -> None:
    robot = replace(prototype, errors=drawn(2), tool=np.array([0.0, 0.0, -50.0]))
    q, _, _ = DELTA.inverse(targets(200), robot.tool, DELTA.rows(robot))
    assert np.abs(Compensator(robot).command(targets(200))[0] - q).max() < 1e-13


@pytest.mark.parametrize("kind", CompensatorKind)
def test_without_errors_the_command_is_the_nominal_one(prototype: Robot, kind: str) -> None:
    compensator = Compensator(prototype, kind)
    assert np.abs(compensator.command(targets(100))[0] - compensator.nominal_command(targets(100))[0]).max() < 1e-13


# --- linear ---------------------------------------------------------------------------------------------------------


def test_the_linear_command_leaves_an_error_of_second_order(prototype: Robot) -> None:
    left = []
    for halving in range(5):
        robot = replace(prototype, errors=drawn(4, 4.0 * 0.5**halving))
        left.append(np.linalg.norm(Compensator(robot, "linear").leftover(targets(200)), axis=1).max())
    order = np.log2(np.divide(left[:-1], left[1:]))
    assert order.min() > 1.9
    assert order[-1] == pytest.approx(2.0, abs=0.05)


def test_the_linear_command_undoes_encoder_offsets_exactly(prototype: Robot) -> None:
    offsets = {"theta_1": 3 * DEG, "theta_2": -5 * DEG, "theta_3": 2 * DEG}
    assert np.abs(Compensator(replace(prototype, errors=offsets), "linear").leftover(targets(200))).max() < 1e-9
    # and beside other errors they change nothing of what is left
    others = {n: v for n, v in drawn(5).items() if not n.startswith("theta")}
    alone = Compensator(replace(prototype, errors=others), "linear").leftover(targets(200))
    beside = Compensator(replace(prototype, errors=others | offsets), "linear").leftover(targets(200))
    assert np.abs(alone).max() > 1e-4
    assert np.abs(beside - alone).max() < 1e-9


def papers_change(robot: Robot, target: np.ndarray, theta: np.ndarray, position_only: bool) -> np.ndarray:
    """Change of the joints [rad] by Bai's eq. (23) or (25), from the matrices printed below eq. (7) and eq. (22)."""
    b, a, L, l, c = (
        float(robot.geometry[key][0])
        for key in ("base_radius", "platform_radius", "proximal_length", "distal_length", "joint_spacing")
    )
    A_rr, A_re, A_ee = np.zeros((3, 3)), np.zeros((3, 3)), np.zeros((3, 3))
    B_r, B_e, B_m = np.zeros((3, 24)), np.zeros((3, 18)), np.zeros((3, 3))
    p_r, p_e = np.zeros(24), np.zeros(18)
    for i, phi in enumerate(np.radians([-90.0, 30.0, 150.0])):
        u0, v0, w0 = (
            np.array([np.cos(phi), np.sin(phi), 0]),
            np.array([0, 0, 1.0]),
            np.array([np.sin(phi), -np.cos(phi), 0]),
        )
        u1 = np.cos(theta[i]) * u0 + np.sin(theta[i]) * v0
        v1 = -np.sin(theta[i]) * u0 + np.cos(theta[i]) * v0
        a_i = a * u0 - robot.tool
        lhat = (target + a_i - b * u0 - L * u1) / l
        assert np.linalg.norm(lhat) == pytest.approx(1.0, abs=1e-12)
        A_rr[i], A_re[i], A_ee[i] = lhat, np.cross(a_i, lhat), np.cross(w0, lhat)
        B_m[i, i] = lhat @ v1
        along = lhat @ w0
        B_r[i, 8 * i : 8 * i + 8] = [
            lhat @ v1,
            *lhat,
            lhat @ u1,
            along * np.sin(theta[i]),
            -along * np.cos(theta[i]),
            1,
        ]
        B_e[i, 6 * i : 6 * i + 6] = [1, along, -lhat @ v0, lhat @ u0, -lhat @ v1, lhat @ u1]
        e = {name.rsplit("_", 1)[0]: value for name, value in robot.errors.items() if name.endswith(f"_{i + 1}")}
        p_r[8 * i : 8 * i + 8] = [
            L * e["theta"],
            e["ex"],
            e["ey"],
            e["ez"],
            e["L"],
            L * e["alpha0"],
            L * e["beta0"],
            e["l"],
        ]
        if not position_only:
            p_e[6 * i : 6 * i + 6] = [e["dl"] / c, e["dc"] / c, e["alpha03"], e["beta03"], e["alpha2"], e["beta2"]]
    moved = B_r @ p_r if position_only else B_r @ p_r - A_re @ np.linalg.solve(A_ee, B_e @ p_e)
    return -np.linalg.solve(B_m, moved) / L


@pytest.mark.parametrize("tool", [(0.0, 0.0, 0.0), (25.0, -40.0, -60.0)])
@pytest.mark.parametrize("position_only", [False, True], ids=["eq. (23)", "eq. (25)"])
def test_the_linear_command_is_the_papers(prototype: Robot, position_only: bool, tool: tuple[float, ...]) -> None:
    group = DELTA.models["delta/24"] if position_only else DELTA.models["delta/42"]
    robot = replace(prototype, errors={n: v for n, v in drawn(6).items() if n in group}, tool=np.array(tool))
    compensator = Compensator(robot, "linear")
    points = targets(50, seed=6)
    commanded, nominal = compensator.command(points)[0], compensator.nominal_command(points)[0]
    printed = [papers_change(robot, *pair, position_only) for pair in zip(points, nominal, strict=True)]
    assert np.abs(commanded - nominal - printed).max() < 1e-12


def test_the_linear_command_follows_from_the_closures_jacobians(prototype: Robot) -> None:
    robot = replace(prototype, errors=drawn(7), tool=np.array([5.0, 6.0, -70.0]))
    compensator = Compensator(robot, "linear")
    points = targets(20, seed=7)
    nominal, _ = compensator.nominal_command(points)
    x = np.hstack([points, np.tile(np.eye(3).ravel(), (20, 1))])
    _, J_x, J_q, J_p = DELTA.jacobians(x, nominal, robot.tool, DELTA.rows(compensator.nominal))
    dp = np.hstack([DELTA.vector(robot.errors).reshape(3, -1), np.zeros((3, len(DELTA.deflections)))])
    blocks = np.zeros((20, 6, 3))
    blocks[:, range(6), np.repeat(range(3), 2)] = J_q
    moved = np.einsum("nfv,fv->nf", J_p, np.repeat(dp, 2, axis=0))
    change = np.linalg.solve(np.concatenate([blocks, J_x[:, :, 3:]], axis=2), -moved[..., None])[:, :3, 0]
    assert np.abs(compensator.command(points)[0] - nominal - change).max() < 1e-12


# --- what both share ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("kind", CompensatorKind)
def test_the_servo_function_runs_in_a_compiled_loop(prototype: Robot, kind: str) -> None:
    signed = replace(prototype, errors=drawn(8), joint_sign=np.array([1.0, -1.0, -1.0]))
    compensator = Compensator(signed, kind)
    command, state = compensator.servo()

    @njit
    def loop(points: Any, state: Any, q: Any) -> None:
        for n in range(len(points)):
            q[n, 0], q[n, 1], q[n, 2] = command(points[n, 0], points[n, 1], points[n, 2], state)

    points = targets(50)
    q = np.empty((50, 3))
    loop(points, state, q)
    assert np.abs(q - compensator.command(points)[0]).max() < 1e-13
    alone = [command(*point, state) for point in points.tolist()]
    assert np.abs(alone - compensator.command(points)[0]).max() < 1e-13
    assert np.isnan(command(0.0, 0.0, -2000.0, state)).all()


def test_the_linear_change_is_what_the_linear_command_adds(prototype: Robot) -> None:
    """For a controller that has nominal joints already."""
    signed = replace(prototype, errors=drawn(8), joint_sign=np.array([1.0, -1.0, -1.0]))
    compensator, points = Compensator(signed, "linear"), targets(20)
    nominal = Compensator(replace(signed, errors={}), "linear").command(points)[0]
    change, state = servo = compensator.servo(change=True)
    direct = servo.direct()
    for point, q, expected in zip(points, nominal, compensator.command(points)[0], strict=True):
        assert change(*point, *q, state) == pytest.approx(expected - q, abs=1e-14)
        assert direct(*point, *q) == change(*point, *q, state)
    with pytest.raises(UsageError, match="the exact compensator has no change to nominal joints"):
        Compensator(signed).servo(change=True)


@pytest.mark.walk
@pytest.mark.parametrize("name", ["delta", "planar_parallelogram", "linear_delta"])
@pytest.mark.parametrize("kind", CompensatorKind)
def test_direct_commands_are_bound_to_their_machine(name: str, kind: str) -> None:
    """Built-in functions of numbers, each of its own state; anything else is a TypeError."""
    robot = replace(read_robot(example(f"{name}/robot.toml")), errors={})
    mechanism = load_mechanism(name)
    moved = replace(robot, errors={mechanism.parameters[0].name: 5 * mechanism.parameters[0].typical})
    servos = [Compensator(r, kind).servo() for r in (robot, moved)]
    commands = [servo.direct() for servo in servos]
    given = read_recording(example(f"{name}/poses.csv"), mechanism, need_measured=False, allow_targets=True)
    if given.targets is not None:
        point = given.targets[0]
    else:
        point = mechanism.forward(given.joints[:1], np.zeros(3), mechanism.rows(robot))[0][0, :3]
    numbers = point[: len(mechanism.stated(np.zeros((1, 3)))[0])].tolist()
    gc.collect()
    nominal, other = (command(*numbers) for command in commands)
    assert nominal != other
    for servo, found in zip(servos, (nominal, other), strict=True):
        assert np.isfinite(found).all()
        assert servo.command(*numbers, servo.state) == found
    command = commands[0]
    assert command.__self__[1:] == commands[1].__self__[1:]  # code, which LLVM never gives back, is made once
    assert command(*map(np.float64, numbers)) == nominal
    ones = [-1] * len(numbers)  # what Python's own functions return besides an error
    np.testing.assert_array_equal(command(*ones), servos[0].command(*map(float, ones), servos[0].state))
    with pytest.raises(TypeError, match=f"{len(numbers)} numbers are needed: px"):
        command(*numbers, 1.0)
    with pytest.raises(TypeError, match="must be real number, not str"):
        command(*numbers[:-1], "1")
    with pytest.raises(TypeError, match="no keyword arguments"):
        command(*numbers, px=1.0)
    assert str(inspect.signature(command)).startswith("(px")
    assert (command.__doc__ or "").startswith("Return the joints")
    assert "state" not in (command.__doc__ or "")


@pytest.mark.parametrize("kind", CompensatorKind)
def test_compensators_and_servos_go_to_other_processes(prototype: Robot, kind: str) -> None:
    compensator, point = Compensator(replace(prototype, errors=drawn(9)), kind), targets(1)
    expected = compensator.command(point)[0][0]  # it has computed, and keeps what it computed with
    servo = compensator.servo()
    given = (compensator, servo)
    for one, its in (pickle.loads(pickle.dumps(given)), copy.deepcopy(given)):
        assert one.mechanism is load_mechanism("delta")
        np.testing.assert_array_equal(one.command(point)[0][0], expected)
        joints = servo.command(*point[0], servo.state)
        assert one.servo().direct()(*point[0]) == its.direct()(*point[0]) == joints


@pytest.mark.parametrize("compensator", [("exact", ()), ("linear", ()), ("exact", (SCALE,))])
def test_commands_may_be_written_in_place_of_their_targets(
    prototype: Robot, compensator: tuple[str, tuple[Term, ...]]
) -> None:
    kind, terms = compensator
    command, points = Compensator(replace(prototype, errors=drawn(9)), kind, terms).command, targets(8, seed=4)
    points[3] = [3000.0, 0.0, -800.0]
    expected, unsolved = command(points)
    found, status = command(points, out=points)
    assert found is points
    np.testing.assert_array_equal(found, expected)
    np.testing.assert_array_equal(status, unsolved)


@pytest.mark.parametrize("kind", CompensatorKind)
def test_commands_are_counted_as_the_controller_counts(prototype: Robot, kind: str) -> None:
    robot = replace(prototype, errors=drawn(9))
    flipped = replace(robot, joint_sign=np.array([-1.0, 1.0, -1.0]))
    plain, signed = (Compensator(r, kind) for r in (robot, flipped))
    assert np.array_equal(signed.command(targets(30))[0], plain.command(targets(30))[0] * [-1.0, 1.0, -1.0])
    assert np.array_equal(signed.leftover(targets(30)), plain.leftover(targets(30)))


def test_targets_out_of_reach_are_named_by_row(prototype: Robot) -> None:
    compensator = Compensator(replace(prototype, errors=drawn(10)))
    points = np.vstack([targets(3), [[900.0, 0.0, -978.0]], targets(2), [[0.0, 0.0, float("nan")]]])
    joints, status = compensator.command(points)
    assert list(status) == [0, 0, 0, UNREACHABLE, 0, 0, UNREACHABLE]
    assert np.isnan(joints[[3, 6]]).all()
    with pytest.raises(
        NoSolutionError, match=r"(?s)2 of 7 targets.*target 4 \(900, 0, -978 mm\): out of reach.*target 7"
    ):
        compensator.joints(points)
    assert np.array_equal(compensator.joints(targets(3)), joints[:3])
    with pytest.raises(NoSolutionError, match="and 2 more"):
        compensator.joints(np.full((7, 3), 5000.0))


def test_commands_beyond_the_joint_limits_are_named(prototype: Robot) -> None:
    limits = np.array([[-60.0, 95.0], [-60.0, 20.0], [-60.0, 95.0]]) * DEG
    compensator = Compensator(replace(prototype, errors=drawn(10), joint_limits=limits))
    up = np.array([[0.0, 0.0, -900.0], [0.0, 0.0, -650.0]])
    with pytest.raises(
        NoSolutionError, match=r"1 of 2 .*\n.*target 2 .*joint 2 would go to 2\d\.\d+, .* -60 to 20 deg"
    ):
        compensator.joints(up)


def test_an_arm_in_line_with_its_rods_is_singular(prototype: Robot) -> None:
    reach = float(prototype.geometry["proximal_length"][0] + prototype.geometry["distal_length"][0])
    # straight out and down along limb 1, to within rounding of the full reach
    offset = float(prototype.geometry["base_radius"][0] - prototype.geometry["platform_radius"][0])
    direction = np.array([0.0, -math.cos(0.9), -math.sin(0.9)])
    target = np.array([[0.0, -offset, 0.0]]) + (reach - 1e-12) * direction
    for kind in CompensatorKind:
        joints, status = Compensator(prototype, kind).command(target)
        assert status[0] in (SINGULAR, UNREACHABLE)
        assert np.isnan(joints).all()


def test_refusals(prototype: Robot) -> None:
    with pytest.raises(UsageError, match="exact and linear"):
        Compensator(prototype, "quadratic")
    with pytest.raises(ValueError, match=r"\(N, 3\)"):
        Compensator(prototype).command(np.zeros(3))
    with pytest.raises(InputError, match="workspace"):
        Compensator(replace(prototype, workspace=None)).round_trip()


def test_the_smallest_model_is_named(prototype: Robot) -> None:
    assert Compensator(replace(prototype, errors={"theta_2": 0.1})).model == "delta/3"
    assert Compensator(replace(prototype, errors={"theta_2": 0.1, "L_1": 0.1})).model == "delta/18"
    assert Compensator(replace(prototype, errors=drawn(1))).model == "delta/42"


# --- C99 ------------------------------------------------------------------------------------------------------------

COMPILER = shutil.which("gcc") or shutil.which("cc") or shutil.which("clang")
FLAGS = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O2")


def compiled(source: Path) -> Any:
    if COMPILER is None:
        pytest.skip("no C compiler on this machine")
    library = source.with_suffix(".so")
    subprocess.run([COMPILER, *FLAGS, "-shared", "-fPIC", "-o", str(library), str(source), "-lm"], check=True)
    return ctypes.CDLL(str(library)).deltacal_compensate


@pytest.mark.parametrize("kind", CompensatorKind)
def test_the_exported_c_agrees(prototype: Robot, kind: str, tmp_path: Path) -> None:
    robot = replace(
        prototype,
        name="cell 4 */ int x; /* \\",
        errors=drawn(11),
        tool=np.array([10.0, 0.0, -45.0]),
        joint_sign=np.array([1.0, -1.0, 1.0]),
    )
    compensator = Compensator(robot, kind)
    left = export_c(compensator, tmp_path / "compensate.c")
    text = (tmp_path / "compensate.c").read_text(encoding="utf-8")
    stated = float(re.search(r"Error left  (\S+) mm", text)[1])  # type: ignore[index]
    assert left.worst_mm <= stated <= 1.3 * left.worst_mm
    assert np.linalg.norm(compensator.leftover(targets(500, seed=12)), axis=1).max() <= max(stated, 1e-9)
    assert compensator.digest in text

    function = compiled(tmp_path / "compensate.c")
    joints, _ = compensator.command(targets(300))
    found = np.zeros((300, 3))
    for target, out in zip(targets(300), found, strict=True):
        place, answer = (ctypes.c_double * 3)(*target), (ctypes.c_double * 3)()
        assert function(place, answer) == SOLVED
        out[:] = answer
    assert np.abs(found - joints / DEG).max() < 1e-9
    untouched = (ctypes.c_double * 3)(7.0, 7.0, 7.0)
    assert function((ctypes.c_double * 3)(0.0, 0.0, -2000.0), untouched) == UNREACHABLE
    assert function((ctypes.c_double * 3)(0.0, math.nan, -800.0), untouched) == UNREACHABLE
    assert list(untouched) == [7.0, 7.0, 7.0]
    # the points that the header gives for a check after installation
    checks = re.findall(r"\((\S+), (\S+), (\S+)\) mm -> \((\S+), (\S+), (\S+)\) deg", text)
    assert len(checks) == 3
    for row in np.array(checks, dtype=float):
        answer = (ctypes.c_double * 3)()
        assert function((ctypes.c_double * 3)(*row[:3]), answer) == SOLVED
        assert np.abs(np.array(answer) - row[3:]).max() < 1e-8


def test_the_same_numbers_give_the_same_file(prototype: Robot, tmp_path: Path) -> None:
    robot = replace(prototype, errors=drawn(13))
    for name, kernels in (("a.c", Backend.NUMPY), ("b.c", Backend.COMPILED)):
        with using(kernels):
            export_c(Compensator(robot), tmp_path / name)
    assert (tmp_path / "a.c").read_bytes() == (tmp_path / "b.c").read_bytes()
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.c", "b.c"]
    nudged = replace(robot, errors=robot.errors | {"L_1": robot.errors["L_1"] + 1e-9})
    assert Compensator(nudged).digest != Compensator(robot).digest != Compensator(robot, "linear").digest


# --- table ----------------------------------------------------------------------------------------------------------


def table_errors(table: TableCompensator, compensator: Compensator, points: np.ndarray) -> np.ndarray:
    correction, status = table.correction(points)
    assert (status == SOLVED).all()
    joints = compensator.nominal_command(points)[0] + correction
    return np.linalg.norm(compensator.reached(joints)[0] - points, axis=1)


@pytest.mark.parametrize(("kind", "worst"), [("exact", 0.05), ("exact", 0.01), ("linear", 0.05)])
def test_a_table_leaves_no_more_than_it_states(prototype: Robot, kind: str, worst: float, tmp_path: Path) -> None:
    robot = replace(
        prototype, errors=drawn(14), tool=np.array([0.0, 20.0, -50.0]), joint_sign=np.array([1.0, -1.0, 1.0])
    )
    compensator = Compensator(robot, kind)
    written = export_table(compensator, tmp_path / "table.csv", worst_mm=worst)
    table = read_table(tmp_path / "table.csv")
    assert table.worst_mm <= worst
    assert table.missed == 0
    error = table_errors(table, compensator, targets(5000, seed=15))
    assert 0.2 * table.worst_mm < error.max() <= table.worst_mm
    # the file says what was computed
    assert np.array_equal(table.corrections, written.corrections)
    for name in ("origin", "step", "tool"):
        assert np.array_equal(getattr(table, name), getattr(written, name))
    for name in ("nodes", "worst_mm", "robot", "mechanism", "kind", "digest", "joint_unit"):
        assert getattr(table, name) == getattr(written, name)
    assert f"worst_mm = {table.worst_mm}" in (tmp_path / "table.csv").read_text(encoding="utf-8")


def test_a_table_of_a_given_step(prototype: Robot, tmp_path: Path) -> None:
    compensator = Compensator(replace(prototype, errors=drawn(14)))
    coarse = export_table(compensator, tmp_path / "coarse.csv", step_mm=100.0)
    fine = export_table(compensator, tmp_path / "fine.csv", step_mm=50.0)
    assert coarse.nodes == (11, 11, 4)
    assert fine.nodes == (21, 21, 6)
    assert (fine.step <= 50.0).all()
    assert coarse.worst_mm / fine.worst_mm > 3.0  # second order in the step
    nodes = fine.origin + fine.step * np.array([[10, 10, 2], [3, 12, 5], [20, 10, 0]])
    assert table_errors(fine, compensator, nodes).max() < 1e-5
    assert fine.correction(np.array([[501.0, 0.0, -800.0], [0.0, np.nan, -800.0]]))[1].tolist() == [UNREACHABLE] * 2


def test_nodes_out_of_reach_are_blank(prototype: Robot, tmp_path: Path) -> None:
    wide = replace(prototype, errors=drawn(16), workspace=Workspace(top=728.0, radius=570.0, height=250.0))
    compensator = Compensator(wide)
    export_table(compensator, tmp_path / "wide.csv", step_mm=60.0)
    table = read_table(tmp_path / "wide.csv")
    assert np.isnan(table.corrections).any()
    corner = table.origin[None, :] + 1.0
    assert table.correction(corner)[1][0] == UNREACHABLE
    assert table.missed == 0
    assert table_errors(table, compensator, targets(2000, radius=570.0)).max() <= table.worst_mm


def test_tables_that_cannot_be(prototype: Robot, tmp_path: Path) -> None:
    robot = replace(prototype, errors=drawn(14))
    beyond = Compensator(replace(robot, workspace=Workspace(top=728.0, radius=900.0, height=250.0)))
    path = tmp_path / "table.csv"
    with pytest.raises(NoSolutionError, match="itself leaves"):
        export_table(Compensator(robot, "linear"), path, worst_mm=1e-5)
    with pytest.raises(NoSolutionError, match="more than 200000 corrections"):
        export_table(Compensator(robot), path, worst_mm=1e-5)
    with pytest.raises(NoSolutionError, match="workspace are out of reach"):
        export_table(beyond, path)
    nowhere = Compensator(replace(robot, workspace=Workspace(top=1728.0, radius=500.0, height=250.0)))
    with pytest.raises(NoSolutionError, match="no point of the workspace"):
        export_table(nowhere, path, step_mm=250.0)
    with pytest.raises(NoSolutionError, match="no point of the workspace"):
        export_c(nowhere, path)
    for wrong in ({"worst_mm": 0.0}, {"step_mm": -1.0}):
        with pytest.raises(UsageError, match="above 0"):
            export_table(Compensator(robot), path, **wrong)
    with pytest.raises(InputError, match="cannot be written"):
        export_table(Compensator(robot), tmp_path / "nowhere" / "table.csv", step_mm=250.0)
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("deltacal.table/1", "deltacal.table/9", "line 1.*schema"),
        ("nodes = [5, 5, 2]", "nodes = [5, 5]", "'nodes' is"),
        ("nodes = [5, 5, 2]", "nodes = [5, 5, 3]", "75 rows were expected, but there are 50"),
        ("step_mm = [250.0", "step_mm = [25.0", "line 32.*not the node"),
        ("robot = ", "robbot = ", "'robbot' is not known. Did you mean 'robot'"),
        ("dq1_deg", "dq1_rad", "line 21.*names of the columns"),
        ("\n-500.000000,-500.000000,-728.000000,", "\n-500.000000,-500.000000,-728.000000,x", "line 23.*6 numbers"),
    ],
)
def test_a_damaged_table_is_refused(prototype: Robot, tmp_path: Path, old: str, new: str, message: str) -> None:
    path = tmp_path / "table.csv"
    export_table(Compensator(replace(prototype, errors=drawn(14))), path, step_mm=250.0)
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new, 1), encoding="utf-8")
    with pytest.raises(InputError, match=message):
        read_table(path)
