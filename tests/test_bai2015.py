"""Bai, Mei, Huang, Chetwynd 2015: its matrices, its parameters in Tables 3 and 4, its procedure and its ranks."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
import pytest
from conftest import rings, scattered, wanted
from scipy.linalg import block_diag

from deltacal_gen.accuracy import check_poses, circle, distance_error, largest, volumetric_error
from deltacal_gen.estimation import pose_problem
from deltacal_gen.identifiability import identification_matrix, observability, unseen
from deltacal_gen.identification import identify
from deltacal_gen.mechanism import SOLVED, Mechanism
from deltacal_gen.recording import Recording
from deltacal_gen.robot import Robot
from deltacal_gen.simulation import simulate
from deltacal_gen.units import DEG

L, c = 375.0, 100.0
OFFSETS = {"theta_1": 0.911 * DEG, "theta_2": 1.098 * DEG, "theta_3": 1.441 * DEG}  # section 5.1

# [mm], with the columns' names here and what the table multiplies them by
TABLE_3 = {
    ("ey", 1.0): (0.114, None, None),
    ("ex", 1.0): (None, -0.201, 0.146),
    ("theta", L): (0.965, -0.034, -0.578),
    ("L", 1.0): (0.112, 0.101, 0.098),
    ("alpha0", L): (-0.841, -0.546, 0.759),
    ("beta0", L): (0.421, -0.764, 0.432),
    ("l", 1.0): (0.107, 0.157, 0.302),
}
TABLE_4 = {
    ("ey", 1.0): (0.160, None, None),
    ("ex", 1.0): (None, -0.187, 0.174),
    ("theta", L): (1.107, -0.112, -0.941),
    ("L", 1.0): (0.919, 0.110, 0.122),
    ("alpha0", L): (-0.707, -0.901, 0.872),
    ("beta0", L): (0.636, -0.524, 0.497),
    ("l", 1.0): (0.114, 0.125, 0.193),
    ("dl", 1.0): (0.048, 0.052, 0.039),
    ("dc", 1.0): (-0.021, 0.014, -0.009),
    ("alpha03", c): (-0.175, None, None),
    ("beta03", c): (0.267, -0.242, None),
    ("alpha2", c): (0.057, -0.017, None),
    ("beta2", c): (-0.032, -0.047, 0.061),
}
REFERENCE_POINTS = np.array([[0.0, 0.0, -60.0], [80.0, 30.0, -60.0]])  # two sockets on the plate, as in Fig. 5


def errors_of(table: dict[tuple[str, float], tuple[float | None, ...]]) -> dict[str, float]:
    """Return a table's errors in mm and rad, the encoder offsets of the rough stage added."""
    errors = {
        f"{name}_{limb}": value / divisor
        for (name, divisor), row in table.items()
        for limb, value in enumerate(row, start=1)
        if value is not None
    }
    for name, offset in OFFSETS.items():
        errors[name] += offset
    return errors


TRUTH = {"18": errors_of(TABLE_3), "32": errors_of(TABLE_4)}
RING = {"18": 7, "32": 9}  # section 5.2: n of the measuring poses


def measuring(robot: Robot, model: str, noise: float = 0.0, seed: int = 0) -> Recording:
    """Return the paper's measurement: home and n poses on either ring, with two reference points for model 32."""
    points = REFERENCE_POINTS[: 1 if model == "18" else 2]
    poses = rings(robot, RING[model])
    given = wanted(np.tile(poses, (len(points), 1)), tool=np.repeat(points, len(poses), axis=0))
    return simulate(robot, given, TRUTH[model], noise_mm=noise, rng=np.random.default_rng(seed))


def positions_at(
    robot: Robot, mechanism: Mechanism, errors: dict[str, float], q: np.ndarray, tool: np.ndarray
) -> np.ndarray:
    x, status = mechanism.forward(q, tool, mechanism.rows(robot, mechanism.vector(errors)))
    assert (status == SOLVED).all()
    return x[:, :3]


def compare(
    robot: Robot, mechanism: Mechanism, model: str, found: dict[str, float]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return distance errors, volumetric errors and plain errors at the 96 check poses, commanded by the found machine.

    Plain: after the rigid motion that fits best, since distances know no frame.
    """
    assert robot.workspace is not None
    targets, tool = check_poses(robot.workspace), REFERENCE_POINTS[0]
    q, _, status = mechanism.inverse(targets, tool, mechanism.rows(robot, mechanism.vector(found)))
    assert (status == SOLVED).all()
    attained = positions_at(robot, mechanism, TRUTH[model], q, tool)
    return distance_error(attained, targets), volumetric_error(attained, targets), attained - targets


# ----------------------------------------------------------------------------------------- the matrices of eqs. (5)-(9)


def paper_matrices(q: np.ndarray, r: np.ndarray, tool: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return C_r (3, 42) and C_e (3, 18) of eqs. (8) and (9) at a nominal pose, from the paper's text alone.

    Columns as in the paper: the 24 of Delta p_r (L theta, e_x, e_y, e_z, L_i, L alpha0, L beta0, l), limb by limb, then
    the 18 of Delta p_e (dl/c, dc/c, alpha03, beta03, alpha2, beta2).
    """
    a_radius, b_radius = 51.0, 200.0
    A_rr, A_re, A_ee, B_r, B_e = [], [], [], [], []
    for i, theta in enumerate(q):
        phi = -np.pi / 2 + 2 * np.pi * i / 3
        # R_0i = Rot(z, phi) Rot(x_0i, pi/2) = [u0 v0 w0]
        Rz = np.array([[np.cos(phi), -np.sin(phi), 0], [np.sin(phi), np.cos(phi), 0], [0, 0, 1]])
        u0, v0, w0 = (Rz @ np.array([[1.0, 0, 0], [0, 0, -1.0], [0, 1.0, 0]])).T
        u1, v1 = np.cos(theta) * u0 + np.sin(theta) * v0, -np.sin(theta) * u0 + np.cos(theta) * v0
        a_i = a_radius * u0 - tool  # from the reference point, whose error Delta r is
        l_hat = r + a_i - b_radius * u0 - L * u1
        l_hat = l_hat / np.linalg.norm(l_hat)
        A_rr.append(l_hat)
        A_re.append(np.cross(a_i, l_hat))
        A_ee.append(np.cross(w0, l_hat))
        lw = l_hat @ w0
        B_r.append(np.array([[l_hat @ v1, *l_hat, l_hat @ u1, lw * np.sin(theta), -lw * np.cos(theta), 1.0]]))
        B_e.append(np.array([[1.0, lw, -l_hat @ v0, l_hat @ u0, -l_hat @ v1, l_hat @ u1]]))
    C_e = np.linalg.solve(np.array(A_ee), block_diag(*B_e))
    C_rr = np.linalg.solve(np.array(A_rr), block_diag(*B_r))
    C_re = -np.linalg.solve(np.array(A_rr), np.array(A_re) @ C_e)
    return np.hstack([C_rr, C_re]), C_e


@pytest.mark.parametrize("tool", [(0.0, 0.0, 0.0), (35.0, -20.0, -60.0)], ids=["at the centre", "off the centre"])
def test_the_sensitivity_at_the_nominal_machine_is_the_paper_s(
    robot: Robot, mechanism: Mechanism, tool: tuple[float, float, float]
) -> None:
    position = [f"{e}_{i}" for i in (1, 2, 3) for e in ("theta", "ex", "ey", "ez", "L", "alpha0", "beta0", "l")]
    orientation = [f"{e}_{i}" for i in (1, 2, 3) for e in ("dl", "dc", "alpha03", "beta03", "alpha2", "beta2")]
    names = position + orientation
    columns = [mechanism.index[n] for n in names]
    rows = mechanism.rows(robot)
    q, x, status = mechanism.inverse(scattered(robot, 20, 3), np.array(tool), rows)
    assert (status == SOLVED).all()
    S = mechanism.sensitivity(x, q, np.array(tool), rows).parameters[:, :, columns] / mechanism.scaling(
        "paper", robot, names
    )
    for n in range(len(q)):
        C_r, C_e = paper_matrices(q[n], x[n, :3], np.array(tool))
        assert S[n, :3] == pytest.approx(C_r, abs=1e-12 * np.abs(C_r).max())
        assert S[n, 3:, 24:] == pytest.approx(C_e, abs=1e-12 * np.abs(C_e).max())
        assert S[n, 3:, :24] == pytest.approx(0.0, abs=1e-12)  # eq. (7): Delta p_r turns nothing


def test_the_units_of_the_paper_s_columns_are_said(robot: Robot) -> None:
    recording = simulate(robot, wanted(rings(robot, 7), frame="robot"))
    problem = pose_problem(robot, recording, ("theta_1", "alpha0_2", "ex_3", "dl_1", "dc_2", "alpha03_1", "beta2_3"))
    assert identification_matrix(problem, "paper").units == ("mm", "mm", "mm", "rad", "rad", "rad", "rad")
    assert identification_matrix(problem, "table").units == ("mm",) * 7
    assert identification_matrix(problem, "file").units == ("deg", "deg", "mm", "mm", "mm", "deg", "deg")


def test_scalings_are_the_same_matrix_in_other_units(robot: Robot) -> None:
    recording = simulate(robot, wanted(rings(robot, 7), frame="robot"))
    problem = pose_problem(robot, recording, ("theta_1", "l_2", "dl_1", "beta2_3"))
    in_files, paper, table = (identification_matrix(problem, how).H for how in ("file", "paper", "table"))
    assert paper * [L * DEG, 1.0, 1 / c, DEG] == pytest.approx(in_files, abs=1e-12)
    assert table * [L * DEG, 1.0, 1.0, c * DEG] == pytest.approx(in_files, abs=1e-12)


# ---------------------------------------------------------------------------------------------------------------- ranks

RANKS = {"42": 32, "36": 32, "32": 32, "24": 18, "18": 18, "3": 3}  # section 3.2


@pytest.mark.parametrize("points", [1, 2, 3])
@pytest.mark.parametrize(("model", "rank"), RANKS.items())
def test_ranks_are_those_of_the_paper(robot: Robot, mechanism: Mechanism, model: str, rank: int, points: int) -> None:
    tools = np.array([[0.0, 0.0, -60.0], [80.0, 0.0, -60.0], [0.0, 80.0, -60.0]])[:points]
    poses = np.vstack([rings(robot, 6), scattered(robot, 8, 3)])
    given = wanted(np.tile(poses, (points, 1)), frame="robot", tool=np.repeat(tools, len(poses), axis=0))
    problem = pose_problem(robot, simulate(robot, given), mechanism.model(model), as_distance=True)
    figures = observability(identification_matrix(problem, "typical").H, len(poses))
    assert figures.rank == rank
    s = figures.singular_values
    # no judgement call: the last direction seen stands 1e6 above rounding
    assert s[rank - 1] > 1e-5 * s[0]
    assert np.all(s[rank:] < 1e-12 * s[0])


def test_what_distances_do_not_see_moves_them_to_second_order_only(robot: Robot, mechanism: Mechanism) -> None:
    """The exact machine is moved along each of the ten combinations of model 42."""
    tools = np.array([[0.0, 0.0, -60.0], [80.0, 0.0, -60.0], [0.0, 80.0, -60.0]])
    poses = np.vstack([rings(robot, 6), scattered(robot, 8, 3)])
    tool = np.repeat(tools, len(poses), axis=0)
    recording = simulate(robot, wanted(np.tile(poses, (3, 1)), frame="robot", tool=tool))
    names = mechanism.model("42")
    problem = pose_problem(robot, recording, names, as_distance=True)
    H = identification_matrix(problem, "typical").H / mechanism.typical
    found = unseen(H, names, [p.unit for p in mechanism.parameters], mechanism.typical)
    assert len(found) == 10

    def distances(errors: dict[str, float]) -> np.ndarray:
        P = positions_at(robot, mechanism, errors, recording.joints, tool)
        return np.linalg.norm(P[problem.readings.rows[:, 1]] - P[problem.readings.rows[:, 0]], axis=1)

    nominal = distances({})
    for combination in found:
        assert combination.text.endswith("change no reading")
        change = [
            np.abs(distances({n: k * v for n, v in combination.terms.items()}) - nominal).max() for k in (4.0, 2.0)
        ]
        moved = np.abs(
            positions_at(robot, mechanism, {n: 4 * v for n, v in combination.terms.items()}, recording.joints, tool)
            - positions_at(robot, mechanism, {}, recording.joints, tool)
        ).max()
        assert moved > 0.1  # mm: the machine does move
        # rigid shifts change nothing at all (rounding of 1000 mm); the others as the square of the step
        assert change[0] < 1e-10 or np.log2(change[0] / change[1]) > 1.9
        assert change[0] < 0.05 * moved


# ------------------------------------------------------------------------------------ Tables 3 and 4, and the procedure


@pytest.mark.parametrize("model", ["18", "32"])
@pytest.mark.parametrize("as_distance", [True, False], ids=["from distances", "from positions"])
def test_the_table_s_machine_is_recovered_without_noise(
    robot: Robot, mechanism: Mechanism, model: str, as_distance: bool
) -> None:
    found = identify(robot, measuring(robot, model), model, as_distance=as_distance, solver="least-squares")
    distance, volumetric, plain = compare(robot, mechanism, model, found.robot.errors)
    assert largest(distance) < 1e-6
    assert largest(volumetric) < 1e-6
    assert np.abs(plain).max() < 1e-6  # eq. (11) fixes the frame, so nothing is left to align
    for name, value in TRUTH[model].items():
        scale = mechanism.typical[mechanism.index[name]]
        assert found.robot.errors[name] == pytest.approx(value, abs=1e-5 * scale), name


def linear_route(robot: Robot, mechanism: Mechanism, model: str, recording: Recording) -> dict[str, float]:
    """Return the machine of section 4.2: offsets by eqs. (17) and (26), iterated; then eq. (17) or (20), once."""
    errors: dict[str, float] = {}
    offsets = mechanism.model("3")
    for _ in range(10):
        at = dataclasses.replace(robot, errors=dict(errors))
        found = identification_matrix(pose_problem(at, recording, offsets, as_distance=True), "paper")
        step = np.linalg.lstsq(found.H, found.r, rcond=None)[0] / L
        errors = {n: errors.get(n, 0.0) + float(s) for n, s in zip(offsets, step, strict=True)}
        if np.abs(step).max() < 1e-6 * DEG:
            break
    else:
        pytest.fail("the rough stage did not converge")
    names = mechanism.model(model)
    at = dataclasses.replace(robot, errors=dict(errors))
    found = identification_matrix(pose_problem(at, recording, names, as_distance=True), "paper")
    step = np.linalg.lstsq(found.H, found.r, rcond=None)[0] / mechanism.scaling("paper", robot, names)
    for n, s in zip(names, step, strict=True):
        errors[n] = errors.get(n, 0.0) + float(s)
    return errors


@pytest.mark.parametrize("model", ["18", "32"])
def test_one_linear_step_after_the_offsets_is_enough(robot: Robot, mechanism: Mechanism, model: str) -> None:
    """Section 5.2: "we only need to run the calibration procedure once"."""
    errors = linear_route(robot, mechanism, model, measuring(robot, model))
    distance, volumetric, _ = compare(robot, mechanism, model, errors)
    assert largest(distance) < 0.02
    assert largest(volumetric) < 0.02


def test_the_offsets_come_out_of_five_poses_on_the_middle_layer(robot: Robot, mechanism: Mechanism) -> None:
    """Section 5.1 on a machine whose only errors are the offsets: 15 distances, exact."""
    assert robot.workspace is not None
    poses = np.vstack([check_poses(robot.workspace)[:1], circle(robot.workspace, 0.5, 1.0, 5)])
    recording = simulate(robot, wanted(poses), OFFSETS)
    found = identify(robot, recording, "3", as_distance=True)
    assert len(found.fit.problem.readings) == 15
    for name, offset in OFFSETS.items():
        assert found.robot.errors[name] == pytest.approx(offset, abs=1e-9)


@pytest.fixture(scope="module")
def noisy(robot: Robot, mechanism: Mechanism) -> dict[str, dict[str, Any]]:
    """Largest errors at the 96 check poses as in Table 5, over ten sessions with the tracker's noise of 0.005 mm."""
    out: dict[str, dict[str, Any]] = {}
    for model in ("18", "32"):
        stages: dict[str, list[tuple[float, float]]] = {"A": [], "B": [], "C": []}
        for seed in range(10):
            found = identify(robot, measuring(robot, model, 0.005, seed), model, as_distance=True)
            assert found.rough is not None
            rough = {p.name: float(v) for p, v in zip(mechanism.parameters, found.rough.errors, strict=True) if v}
            for stage, errors in (("A", {}), ("B", rough), ("C", found.robot.errors)):
                distance, volumetric, _ = compare(robot, mechanism, model, errors)
                stages[stage].append((largest(distance), largest(volumetric)))
        out[model] = {stage: np.array(v) for stage, v in stages.items()}
    return out


@pytest.mark.parametrize("model", ["18", "32"])
def test_table_5_has_its_shape(noisy: dict[str, dict[str, Any]], model: str) -> None:
    """A before, B after the offsets, C calibrated: each stage several times better, C at the level of the tracker."""
    A, B, C = (noisy[model][stage] for stage in "ABC")
    assert np.all(A > 2.0)  # mm, as the paper's 5.704 and 6.361
    assert np.all(B < A / 3)
    # calibrated by a tracker of 0.005 mm: the largest of 96 poses stays within a few hundredths, far below the paper's
    # 0.167 and 0.386 mm, which hold what the model leaves out
    assert C.mean() < 0.05
    assert np.all(C < B / 3)
