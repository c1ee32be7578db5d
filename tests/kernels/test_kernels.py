"""The generated kernels against a machine written by hand, and one backend against the other.

The hand-written machine stands in `independent_delta`; from the package it takes nothing but the numbers of the robot.
"""

from __future__ import annotations

import dataclasses
import platform
from concurrent.futures import ThreadPoolExecutor
from types import ModuleType

import numpy as np
import pytest
from deltacal_kernels import rotations
from hypothesis import given, settings
from hypothesis import strategies as st
from numba.core.errors import TypingError
from scipy.spatial.transform import Rotation

from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import SINGULAR, SOLVED, UNREACHABLE, Machine, load_mechanism
from deltacal_gen.units import DEG
from tests.support.independent_delta import closure, nominal_frame, numbers, rod_ends
from tests.support.prototype import displaced, displacement, plausible, rings, scattered, solved_for
from tests.support.solved_delta import TOOL, Solved, solved

COMPLEX_STEP = 1e-30  # the imaginary part is the derivative to the last digit, whatever the step


@pytest.fixture(scope="module")
def machine(robot: Robot, mechanism: Machine) -> Solved:
    return solved(robot, mechanism, seed=1)


# --------------------------------------------------------------------------------------------- geometry and conventions


def test_the_rods_of_the_solved_machine_have_their_lengths(robot: Robot, mechanism: Machine) -> None:
    """Contract, section 6, by SciPy's rotations alone, at finite errors of all 42 kinds."""
    at = solved(robot, mechanism, seed=2, poses=8)
    g = numbers(robot.geometry)
    x, status = mechanism.forward(at.q, at.tool, at.rows)
    assert (status == SOLVED).all()
    for n in range(len(x)):
        R = x[n, 3:].reshape(3, 3)
        assert np.abs(R @ R.T - np.eye(3)).max() < 1e-14  # a rotation to begin with
        for i in range(3):
            e = {name[:-2]: value for name, value in at.errors.items() if name.endswith(f"_{i + 1}")}
            frame = Rotation.from_matrix(nominal_frame(i))
            joint = frame * Rotation.from_rotvec([e["alpha0"], e["beta0"], 0])
            arm = joint * Rotation.from_rotvec([0, 0, at.q[n, i] + e["theta"]])
            alpha3, beta3 = e["alpha0"] - e["alpha03"], e["beta0"] - e["beta03"]  # alpha03 = alpha0 - alpha3
            elbow_axis = arm * Rotation.from_rotvec([e["alpha2"], e["beta2"], 0])
            hand_axis = frame * Rotation.from_rotvec([alpha3, beta3, 0])
            B = g["base_radius"] * frame.apply([1, 0, 0]) + [e["ex"], e["ey"], e["ez"]]
            for side, length in (
                (+1, g["distal_length"] + e["l"] + e["dl"] / 2),
                (-1, g["distal_length"] + e["l"] - e["dl"] / 2),
            ):
                C = B + arm.apply([g["proximal_length"] + e["L"], 0, 0])
                C = C + elbow_axis.apply([0, 0, side * (g["c"] + e["dc"]) / 2])
                A = g["platform_radius"] * frame.apply([1, 0, 0]) + hand_axis.apply([0, 0, side * g["c"] / 2])
                A = x[n, :3] + R @ (A - at.tool[n])
                # rounding of coordinates of 1000 mm is 1e-13; what a Newton step below 1e-9 mm leaves is its square
                assert np.linalg.norm(A - C) == pytest.approx(length, abs=1e-9)


@pytest.mark.parametrize(
    ("error", "side", "expected"),
    [("dl", 0, +0.5), ("dl", 1, -0.5), ("l", 0, 1.0), ("l", 1, 1.0)],
)
def test_rod_one_lies_on_the_positive_side_of_the_joint_axis(
    robot: Robot, mechanism: Machine, error: str, side: int, expected: float
) -> None:
    """A rod of limb 2 that is longer is that of +w = (sin phi, -cos phi, 0): seen by distances, not by closures."""
    rows = mechanism.rows(robot, mechanism.vector({f"{error}_2": 1.0}))
    x, _ = mechanism.forward(np.zeros((1, 3)), np.zeros(3), rows)
    elbow, hand, _ = rod_ends(numbers(robot.geometry), {}, solved_for(x)[0], np.zeros(3), np.zeros(3))
    w = np.array([np.sin(30 * DEG), -np.cos(30 * DEG), 0.0])
    assert (elbow[1, 0] - elbow[1, 1]) @ w == pytest.approx(100.0)
    assert np.linalg.norm(hand[1, side] - elbow[1, side]) - 950.0 == pytest.approx(expected, abs=1e-9)


def test_a_positive_joint_angle_lifts_the_arm_and_the_platform_hangs_below(robot: Robot, mechanism: Machine) -> None:
    rows = mechanism.rows(robot)
    x, _ = mechanism.forward(np.deg2rad([[0.0, 0.0, 0.0], [10.0, 10.0, 10.0]]), np.zeros(3), rows)
    # arms flat: sqrt(950^2 - (200 + 375 - 51)^2) below the base
    assert x[0] == pytest.approx([0, 0, -np.sqrt(950.0**2 - 524.0**2), *np.eye(3).ravel()], abs=1e-9)
    assert x[1, 2] > x[0, 2] + 50


def test_the_closure_kernel_is_the_closure_written_by_hand(machine: Solved, robot: Robot, mechanism: Machine) -> None:
    """Off the solution too, where nothing is zero."""
    x = displaced(machine.x, np.array([1.0, -2.0, 3.0, 0.01, -0.02, 0.03]))
    F, *_ = mechanism.jacobians(x, machine.q, machine.tool, machine.rows)
    for n in range(len(x)):
        by_hand = closure(numbers(robot.geometry), machine.errors, solved_for(x)[n], machine.q[n], machine.tool[n])
        # squares of 1e6 mm^2 are rounded at 1e-10; a sum of a dozen of them at 1e-9
        assert F[n] == pytest.approx(by_hand, rel=1e-11, abs=2e-9)


# ---------------------------------------------------------------------------------------------------------- derivatives


def by_complex_step(robot: Robot, mechanism: Machine, at: Solved, n: int) -> tuple[np.ndarray, ...]:
    """Return F_x (6, 6), F_q (6, 3), F_p (6, 42) of the hand-written closure."""
    g, h = numbers(robot.geometry), COMPLEX_STEP
    x, q, tool = solved_for(at.x)[n], at.q[n], at.tool[n]

    def column(by: str, j: int) -> np.ndarray:
        xc, qc, errors = x.astype(complex), q.astype(complex), dict(at.errors)
        if by == "x":
            xc[j] += 1j * h
        elif by == "q":
            qc[j] += 1j * h
        else:
            name = mechanism.parameters[j].name
            errors[name] = errors[name] + 1j * h
        return np.imag(closure(g, errors, xc, qc, tool)) / h

    F_x, F_q, F_p = (np.column_stack([column(by, j) for j in range(m)]) for by, m in (("x", 6), ("q", 3), ("p", 42)))
    return F_x, F_q, F_p


def test_every_column_of_the_sensitivity_agrees_with_the_complex_step(
    machine: Solved, robot: Robot, mechanism: Machine
) -> None:
    S = mechanism.sensitivity(machine.x, machine.q, machine.tool, machine.rows)
    for n in range(4):
        F_x, F_q, F_p = by_complex_step(robot, mechanism, machine, n)
        expected = -np.linalg.solve(F_x, np.hstack([F_p, F_q]))
        expected[3:] = rotations.spin(solved_for(machine.x)[n : n + 1, 3:])[0] @ expected[3:]
        got = np.hstack([S.parameters[n], S.joints[n]])
        # column by column, relative to the column; rounding times the condition of F_x (1e4) stays below 1e-11
        for part in (slice(0, 3), slice(3, 6)):
            scale = np.linalg.norm(expected[part], axis=0)
            rotated = scale > 1e-12 * scale.max()
            gap = np.linalg.norm(got[part] - expected[part], axis=0)
            assert (gap[rotated] / scale[rotated]).max() < 1e-8
            assert gap[~rotated].max(initial=0.0) < 1e-8 * scale.max()


@pytest.mark.parametrize("column", range(42))
def test_the_remainder_of_every_column_is_of_second_order(
    machine: Solved, robot: Robot, mechanism: Machine, column: int
) -> None:
    """Taylor test on the exact machine: halve the step, quarter the gap."""
    S = mechanism.sensitivity(machine.x, machine.q, machine.tool, machine.rows).parameters[:, :, column]
    p = mechanism.vector(machine.errors)
    whole = 5.0 if mechanism.parameters[column].unit == "mm" else 0.05  # large: rounding is far below the remainder
    steps = whole * 0.5 ** np.arange(4)
    gaps = []
    for h in steps:
        moved = p.copy()
        moved[column] += h
        x, status = mechanism.forward(machine.q, machine.tool, mechanism.rows(robot, moved))
        assert (status == SOLVED).all()
        remainder = displacement(machine.x, x) - h * S
        gaps.append(np.linalg.norm(remainder * [1, 1, 1, 100, 100, 100]))  # rotations at 100 mm
    order = np.log2(np.divide(gaps[:-1], gaps[1:]))
    assert order.min() > 1.9
    assert order[-1] == pytest.approx(2.0, abs=0.06)  # the third order is still there at finite steps, halved each time


def test_deflections_are_derivatives_too(machine: Solved, robot: Robot, mechanism: Machine) -> None:
    """No error of the model moves an arm's tip sideways: central differences of the exact machine, extrapolated."""
    S = mechanism.sensitivity(machine.x, machine.q, machine.tool, machine.rows).deflections
    p = mechanism.vector(machine.errors)

    def central(limb: int, which: int, h: float) -> np.ndarray:
        tip = np.zeros((1, 3, 2))
        tip[0, limb, which] = h
        plus, minus = (
            mechanism.forward(machine.q, machine.tool, mechanism.rows(robot, p, s * tip))[0] for s in (1, -1)
        )
        return (displacement(machine.x, plus) - displacement(machine.x, minus)) / (2 * h)

    for limb in range(3):
        for which in range(2):
            extrapolated = (4 * central(limb, which, 0.5) - central(limb, which, 1.0)) / 3
            assert S[:, :, limb, which] == pytest.approx(extrapolated, abs=1e-8)  # mm per mm, rad per mm


def test_a_tip_along_the_arm_normal_is_a_joint_angle_times_the_arm(
    machine: Solved, robot: Robot, mechanism: Machine
) -> None:
    """At nominal geometry, tip_v moves the whole elbow as L dtheta does."""
    rows = mechanism.rows(robot, np.zeros(42))
    q, x, _ = mechanism.inverse(scattered(robot, 6, 5), np.zeros(3), rows)
    S = mechanism.sensitivity(x, q, np.zeros(3), rows)
    for limb in range(3):
        theta = S.parameters[:, :, mechanism.index[f"theta_{limb + 1}"]]
        assert S.deflections[:, :, limb, 0] == pytest.approx(theta / 375.0, abs=1e-13)
        assert S.joints[:, :, limb] == pytest.approx(theta, abs=1e-10)


# ----------------------------------------------------------------------------------------------------- the two backends


def run(kernels: ModuleType, mechanism: Machine, q: np.ndarray, target: np.ndarray, tool: np.ndarray, rows: np.ndarray):
    """Return every output of every kernel of a backend, by name."""
    n = len(q)
    tool = np.ascontiguousarray(np.broadcast_to(tool, (n, 3)))
    k = kernels.constants(rows)
    x, status = np.empty((n, 6)), np.empty(n, dtype=np.int64)
    kernels.forward(q, tool, k, x, status, False)
    q_back, x_back, status_back = np.empty((n, 3)), np.empty((n, 6)), np.empty(n, dtype=np.int64)
    kernels.inverse(np.ascontiguousarray(target), tool, k, x_back, q_back, status_back)
    F, J_x, J_q, J_p = np.zeros((n, 6)), np.zeros((n, 6, 6)), np.zeros((n, 6)), np.zeros((n, 6, 16))
    at = x + np.array([10.0, -20.0, 30.0, 0.01, -0.02, 0.01])  # off the solution, where no closure is zero
    kernels.jacobians(at, q, tool, k, F, J_x, J_q, J_p)
    S, V, status_S = np.empty((n, 6, 48)), np.empty((n, 6, 3)), np.empty(n, dtype=np.int64)
    kernels.sensitivity(at, q, tool, k, S, V, status_S)
    return {
        "x": x,
        "status": status,
        "q_back": q_back,
        "x_back": x_back,
        "status_back": status_back,
        "F": F,
        "J_x": J_x,
        "J_q": J_q,
        "J_p": J_p,
        "S": S,
        "V": V,
        "status_S": status_S,
    }


@pytest.mark.parametrize("many", [False, True], ids=["one machine", "a machine per pose"])
def test_compiled_and_plain_kernels_agree(robot: Robot, mechanism: Machine, many: bool) -> None:
    n = 40
    rng = np.random.default_rng(7)
    errors = np.array([mechanism.vector(plausible(mechanism, s)) for s in range(n if many else 1)])
    rows = mechanism.rows(robot, errors)
    target = scattered(robot, n, 7)
    q, _, _ = mechanism.inverse(target, TOOL, rows)
    q = q + 1e-3 * rng.standard_normal(q.shape)
    compiled, plain = (run(k, mechanism, q, target, TOOL, rows) for k in (mechanism.compiled, mechanism.vectorised))
    for name, value in compiled.items():
        size = np.abs(value).max()
        assert plain[name] == pytest.approx(value, rel=0, abs=1e-12 * max(size, 1.0)), name


@pytest.mark.parametrize("backend", ["compiled", "vectorised"])
def test_poses_that_cannot_be_are_named_and_become_nan(robot: Robot, mechanism: Machine, backend: str) -> None:
    """Rods of 500 mm do not meet while the arms lie flat: the platform's joints are 524 mm from the elbows."""
    kernels = getattr(mechanism, backend)
    short = dataclasses.replace(robot, geometry=robot.geometry | {"distal_length": np.array([500.0])})
    q = np.deg2rad([[60.0, 60.0, 60.0], [0.0, 0.0, 0.0], [10.0, -5.0, 0.0], [50.0, 60.0, 55.0]])
    tool, x, status = np.zeros((4, 3)), np.empty((4, 6)), np.empty(4, dtype=np.int64)
    kernels.forward(q, tool, kernels.constants(mechanism.rows(short)), x, status, False)
    assert (status == SOLVED).tolist() == [True, False, False, True]
    assert np.isnan(x[1:3]).all()
    assert np.isfinite(x[[0, 3]]).all()
    k = kernels.constants(mechanism.rows(robot))
    target = np.array([[0.0, 0.0, -800.0], [0.0, 0.0, -2000.0], [3000.0, 0.0, -800.0], [100.0, 50.0, -900.0]])
    q_back, x_back = np.empty((4, 3)), np.empty((4, 6))
    kernels.inverse(target, tool, k, x_back, q_back, status)
    assert status.tolist() == [SOLVED, UNREACHABLE, UNREACHABLE, SOLVED]
    assert np.isnan(q_back[1:3]).all()
    assert np.isnan(x_back[1:3]).all()


@pytest.mark.parametrize("backend", ["compiled", "vectorised"])
def test_a_pose_with_all_elbows_on_one_line_is_singular(robot: Robot, mechanism: Machine, backend: str) -> None:
    """With b = a and the arms upright the six rods hang parallel from three points: nothing holds the height."""
    kernels = getattr(mechanism, backend)
    flat = dataclasses.replace(robot, geometry=robot.geometry | {"platform_radius": np.array([200.0])})
    rows = mechanism.rows(flat, np.zeros(42))
    q = np.full((1, 3), np.pi / 2)
    x, status = np.empty((1, 6)), np.empty(1, dtype=np.int64)
    kernels.forward(q, np.zeros((1, 3)), kernels.constants(rows), x, status, False)
    assert status[0] == SINGULAR
    S, V = np.empty((1, 6, 48)), np.empty((1, 6, 3))
    below = np.array([[0.0, 0.0, 375.0 - 950.0, 0.0, 0.0, 0.0]])
    kernels.sensitivity(below, q, np.zeros((1, 3)), kernels.constants(rows), S, V, status)
    assert status[0] == SINGULAR
    assert np.isnan(S).all()


def test_a_warm_start_leads_to_the_same_pose(machine: Solved, mechanism: Machine) -> None:
    for kernels in (mechanism.compiled, mechanism.vectorised):
        k = kernels.constants(machine.rows)
        x = solved_for(machine.x) + np.array([2.0, -1.0, 3.0, 0.01, 0.01, -0.01])
        status = np.empty(len(x), dtype=np.int64)
        kernels.forward(machine.q, machine.tool, k, x, status, True)
        assert (status == SOLVED).all()
        assert x == pytest.approx(solved_for(machine.x), abs=1e-9)


# ------------------------------------------------------------------------------------------------- batches of machines


@pytest.mark.parametrize("at", [[0, 1, 2, 3, 4, 5], [0, 1, 2], [0, 2, 4]])
def test_coordinates_and_poses_are_one_another(mechanism: Machine, at: list[int]) -> None:
    """By the rotations of SciPy: a Cayley vector is 2 tan(t/2) n, a rotation vector t n."""
    rng, n = np.random.default_rng(9), 30
    x, pose, again = rng.standard_normal((n, len(at))), np.empty((n, 12)), np.empty((n, len(at)))
    x[4, 1], x[5, 0] = np.nan, np.inf
    mechanism.compiled.as_poses(x, np.array(at), pose)
    full = np.zeros((n, 6))
    full[:, at] = x
    good = np.isfinite(x).all(axis=1)
    half = np.linalg.norm(full[good, 3:], axis=1) / 2
    stretch = np.divide(np.arctan(half), half, out=np.ones_like(half), where=half > 0)
    expected = Rotation.from_rotvec(full[good, 3:] * stretch[:, None]).as_matrix()
    assert np.isnan(pose[~good]).all()
    assert pose[good, :3] == pytest.approx(full[good, :3], abs=0)
    assert pose[good, 3:] == pytest.approx(expected.reshape(-1, 9), abs=4e-16)
    mechanism.compiled.as_coordinates(pose, np.array(at), again)
    assert again[good] == pytest.approx(x[good], abs=1e-13)


@pytest.mark.parametrize("name", ["delta", "complete_delta"])
def test_sensitivity_of_the_nominal_machine(robot: Robot, name: str) -> None:
    """Derived to first order, it is the exact one where all errors are zero."""
    mechanism = load_mechanism(name)
    n, rows = 70, mechanism.rows(robot, np.zeros(len(mechanism.parameters)))
    q, x, _ = mechanism.inverse(scattered(robot, n, 3), TOOL, rows)
    exact = mechanism.sensitivity(x, q, TOOL, rows).parameters[:, :3]
    S = np.empty((n, 3, len(mechanism.parameters)))
    k, at = mechanism.compiled.nominal_constants(rows), np.ascontiguousarray(x[:, :3])
    assert mechanism.compiled.nominal_sensitivity(at, q, TOOL[None], k, S)
    assert pytest.approx(exact, abs=1e-12 * np.abs(exact).max()) == S


@pytest.mark.parametrize("n", [1, 2, 9, 40])  # one pose has no pairs; 40 are more than a block
def test_rows_of_distances_contract_the_sensitivity(robot: Robot, mechanism: Machine, n: int) -> None:
    rows, columns = mechanism.rows(robot, np.zeros(42)), np.arange(3, 40, 2)
    q, x, _ = mechanism.inverse(scattered(robot, n, 3), TOOL, rows)
    at = np.ascontiguousarray(x[:, :3])
    H = np.empty((n * (n - 1) // 2, len(columns)))
    k = mechanism.compiled.nominal_constants(rows)
    assert mechanism.compiled.distance_rows(at, q, TOOL[None], k, columns, H)
    S = mechanism.sensitivity(x, q, TOOL, rows).parameters[:, :3][:, :, columns]
    a, b = np.triu_indices(n, 1)
    along = (at[b] - at[a]) / np.linalg.norm(at[b] - at[a], axis=1)[:, None]
    expected = np.einsum("nc,ncj->nj", along, S[b] - S[a])
    assert pytest.approx(expected, abs=1e-11 * np.abs(expected).max(initial=1.0)) == H


@pytest.mark.parametrize("each", [1, 7, 40])
def test_machines_that_share_a_call_do_not_see_one_another(robot: Robot, mechanism: Machine, each: int) -> None:
    """Blocks of unequal fill, poses out of reach among them: to the last bit what each pose alone would give."""
    kernels, machines = mechanism.compiled, 3
    errors = np.array([mechanism.vector(plausible(mechanism, s)) for s in range(machines)])
    k = kernels.constants(mechanism.rows(robot, errors))
    target = scattered(robot, machines * each, 5)
    target[0] = [3000.0, 0.0, -800.0]
    n = len(target)
    q, x, status = np.empty((n, 3)), np.empty((n, 6)), np.empty(n, dtype=np.int64)
    kernels.inverse(target, TOOL[None], k, x, q, status)
    assert status[0] == UNREACHABLE
    assert (status[1:] == SOLVED).all()
    q[0] = 0.1
    kernels.forward(q, TOOL[None], k, x, status, False)
    for m in range(0, n, max(n // 5, 1)):
        alone, of = np.empty((1, 6)), np.empty(1, dtype=np.int64)
        kernels.forward(q[m : m + 1], TOOL[None], k[m // each : m // each + 1], alone, of, False)
        assert (alone == x[m]).all()


@pytest.mark.parametrize("kernels", Backend)
def test_machines_share_out_poses_in_every_function(robot: Robot, mechanism: Machine, kernels: Backend) -> None:
    """To the last bit what each would give for its own poses."""
    machines, each = 3, 4
    errors = np.array([mechanism.vector(plausible(mechanism, s)) for s in range(machines)])
    rows, target = mechanism.rows(robot, errors), scattered(robot, machines * each, 5)

    def found(rows: np.ndarray, target: np.ndarray) -> list[np.ndarray]:
        q, x, _ = mechanism.inverse(target, TOOL, rows)
        again, _ = mechanism.forward(q, TOOL, rows)
        S = mechanism.sensitivity(x, q, TOOL, rows)
        return [q, x, again, S.own, S.joints, *mechanism.jacobians(x, q, TOOL, rows)]

    with using(kernels):
        together = found(rows, target)
        for m in range(machines):
            of = slice(m * each, (m + 1) * each)
            for some, alone in zip(together, found(rows[m : m + 1], target[of]), strict=True):
                np.testing.assert_array_equal(some[of], alone)


@pytest.mark.parametrize("kernels", Backend)
@pytest.mark.parametrize("size", [0.0, 1.0])
def test_joints_may_be_written_in_place_of_their_targets(
    robot: Robot, mechanism: Machine, kernels: Backend, size: float
) -> None:
    rows, target = mechanism.rows(robot, size * mechanism.vector(plausible(mechanism, 3))), scattered(robot, 9, 3)
    target[4] = [3000.0, 0.0, -800.0]
    with using(kernels):
        expected = mechanism.inverse(target, TOOL, rows)
        found = mechanism.inverse(target, TOOL, rows, out=target)
    assert found[0] is target
    for one, other in zip(found, expected, strict=True):
        np.testing.assert_array_equal(one, other)


def test_the_simplified_machine_is_closed_form(robot: Robot, mechanism: Machine) -> None:
    """Errors that leave the platform parallel: Newton finds nothing to add."""
    errors = {n: v for n, v in plausible(mechanism, 4).items() if n.split("_")[0] in ("theta", "ex", "ez", "L", "l")}
    rows, n = mechanism.rows(robot, mechanism.vector(errors)), 40
    k, target = mechanism.compiled.constants(rows), scattered(robot, n, 6)
    target[3] = [0.0, 0.0, -2000.0]
    q, x, status, again, of = np.empty((n, 3)), np.empty((n, 3)), np.empty(n, int), np.empty((n, 6)), np.empty(n, int)
    for tool in (TOOL[None], np.tile(TOOL, (n, 1))):
        mechanism.compiled.simplified_inverse(target, tool, k, q, status)
        assert status[3] == UNREACHABLE
        mechanism.compiled.simplified_forward(np.nan_to_num(q, nan=0.3), tool, k, x, of)
        plain, pose, alike = np.empty((n, 3)), np.empty((n, 6)), np.empty(n, int)
        mechanism.vectorised.inverse(target, np.tile(TOOL, (n, 1)), k, pose, plain, alike)
        np.testing.assert_allclose(q, plain, rtol=0, atol=1e-14)
        assert (status == alike).all()
        mechanism.vectorised.forward(np.nan_to_num(q, nan=0.3), np.tile(TOOL, (n, 1)), k, again, alike, False)
        np.testing.assert_allclose(np.hstack([x, 0 * x]), again, rtol=0, atol=1e-11)
        assert (of == alike).all()


def test_the_simplified_machine_stands_alone_as_in_company(robot: Robot, mechanism: Machine) -> None:
    """To the last bit: what a pose gives does not depend on how many there are.

    Elsewhere than on x86 a product and a sum may be one operation in a loop over poses, and two behind it.
    """
    far = 0.0 if platform.machine() in ("x86_64", "AMD64") else 4 * float(np.finfo(float).eps)
    n, k = 21, mechanism.compiled.constants(mechanism.rows(robot, np.zeros(42)))
    target = scattered(robot, n, 6)
    q, x, status = np.empty((n, 3)), np.empty((n, 3)), np.empty(n, int)
    mechanism.compiled.simplified_inverse(target, TOOL[None], k, q, status)
    mechanism.compiled.simplified_forward(q, TOOL[None], k, x, status)
    for m in range(n):
        alone, at, of = np.empty((1, 3)), np.empty((1, 3)), np.empty(1, int)
        mechanism.compiled.simplified_inverse(target[m : m + 1], TOOL[None], k, alone, of)
        np.testing.assert_allclose(alone[0], q[m], rtol=far, atol=0)
        mechanism.compiled.simplified_forward(alone, TOOL[None], k, at, of)
        np.testing.assert_allclose(at[0], x[m], rtol=far, atol=0)


def test_two_threads_may_use_the_same_kernels(robot: Robot, mechanism: Machine) -> None:
    rows, n = mechanism.rows(robot, mechanism.vector(plausible(mechanism, 5))), 2000
    k, q = mechanism.compiled.constants(rows), np.random.default_rng(5).uniform(-0.4, 0.2, (n, 3))

    def poses(part: slice) -> np.ndarray:
        x, status = np.empty((len(q[part]), 6)), np.empty(len(q[part]), int)
        mechanism.compiled.forward(q[part], TOOL[None], k, x, status, False)
        return x

    parts = [slice(start, start + 100) for start in range(0, n, 100)]
    with ThreadPoolExecutor(2) as pool:
        found = np.vstack(list(pool.map(poses, parts)))
    assert np.array_equal(found, poses(slice(0, n)), equal_nan=True)


def test_arrays_that_do_not_fit_are_refused(robot: Robot, mechanism: Machine) -> None:
    """By the kernels that are called as they are, and by the mechanism's functions before they call kernels."""
    kernels, rows, r = mechanism.compiled, mechanism.rows(robot), scattered(robot, 5, 7)
    q, k, columns = mechanism.inverse(r, TOOL, rows)[0], kernels.nominal_constants(rows), np.arange(12)
    H = np.empty((10, 12))
    kernels.distance_rows(r, q, TOOL[None], k, columns, H)
    turned, strewn = np.asfortranarray(r), np.asfortranarray(H)
    for x, some, out in ((turned, columns, H), (r, columns[::-1], H), (r, columns, strewn)):
        with pytest.raises(TypingError, match=r"is not C-contiguous; np\.ascontiguousarray"):
            kernels.distance_rows(x, q, TOOL[None], k, some, out)
    with pytest.raises(ValueError, match="a row for every pair"):
        kernels.distance_rows(r, q, TOOL[None], k, columns, np.empty((9, 12)))
    for wrong in (-1, 42):
        with pytest.raises(IndexError, match="no such column"):
            kernels.distance_rows(r, q, TOOL[None], k, np.where(columns == 3, wrong, columns), H)
    with pytest.raises(ValueError, match=r"\(1, 6, 22\); \(M, 3, 22\) was expected"):
        kernels.constants(np.repeat(rows, 2, axis=1))
    x, _ = mechanism.forward(q, TOOL, rows)
    for kernels in Backend:
        with using(kernels):
            for tool in (np.tile(TOOL, (2, 1)), TOOL[:2]):
                with pytest.raises(ValueError, match=r"tool has the shape \(2.*\(3,\) or \(5, 3\)"):
                    mechanism.forward(q, tool, rows)
            for many in (0, 3):
                with pytest.raises(ValueError, match=r"rows have the shape .* 5 poses"):
                    mechanism.forward(q, TOOL, np.tile(rows, (many, 1, 1)))
            with pytest.raises(ValueError, match=r"near have the shape .* 5 poses"):
                mechanism.forward(q, TOOL, rows, x[:3])
            with pytest.raises(ValueError, match=r"poses to start from have the shape \(5, 3\)"):
                mechanism.forward(q, TOOL, rows, x[:, :3])
            for derivatives in (mechanism.sensitivity, mechanism.jacobians):
                with pytest.raises(ValueError, match=r"joints have the shape .* 5 poses"):
                    derivatives(x, q[:3], TOOL, rows)


# ---------------------------------------------------------------------------------------------- properties, any machine

MACHINES = st.integers(min_value=0, max_value=2**31)


@settings(max_examples=30, deadline=None, derandomize=True)
@given(seed=MACHINES, size=st.floats(min_value=0.0, max_value=10.0))
def test_forward_undoes_inverse(seed: int, size: float) -> None:
    """Errors up to ten times ordinary ones; offsets of 10 degrees and lengths of 3 mm among them."""
    from deltacal_gen.files.robot import robot_from_dict
    from tests.support.prototype import PROTOTYPE

    mechanism, robot = load_mechanism("delta"), robot_from_dict(PROTOTYPE)
    rows = mechanism.rows(robot, mechanism.vector(plausible(mechanism, seed, size=size)))
    target = scattered(robot, 10, seed) * [0.8, 0.8, 1.0]
    q, x_held, status = mechanism.inverse(target, TOOL, rows)
    assert (status == SOLVED).all()
    x, status = mechanism.forward(q, TOOL, rows)
    assert (status == SOLVED).all()
    assert x[:, :3] == pytest.approx(target, abs=1e-9)
    assert x == pytest.approx(x_held, abs=1e-9)
    F, *_ = mechanism.jacobians(x, q, TOOL, rows)
    assert np.abs(F).max() < 1e-8  # mm^2: lengths of 1000 mm to 1e-11 mm


def test_shapes_are_checked_by_name(robot: Robot, mechanism: Machine) -> None:
    with pytest.raises(ValueError, match=r"joints have the shape \(2, 4\), but must have \(N, 3\)"):
        mechanism.forward(np.zeros((2, 4)), np.zeros(3), mechanism.rows(robot))
    with pytest.raises(ValueError, match=r"targets have the shape \(3,\)"):
        mechanism.inverse(np.zeros(3), np.zeros(3), mechanism.rows(robot))


def test_measuring_poses_of_the_paper_can_be_reached(robot: Robot, mechanism: Machine) -> None:
    _, _, status = mechanism.inverse(rings(robot, 16), np.zeros(3), mechanism.rows(robot))
    assert (status == SOLVED).all()
