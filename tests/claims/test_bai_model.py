"""The model of Bai 2015, section 2, decided: equations by SymPy from the loop closure, figures by NumPy."""

from __future__ import annotations

import numpy as np
import pytest

from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import Machine
from tests.claims import independent_bai as bai
from tests.claims.symbolic_bai import (
    R0,
    R1,
    SIGNS,
    L,
    a_i,
    c,
    closure,
    d_arm,
    dalpha0,
    dalpha03,
    dalpha2,
    dbeta0,
    dbeta03,
    dbeta2,
    dc,
    de,
    dl_diff,
    dl_mean,
    dr,
    dtheta,
    eps,
    eps_rod,
    equation_1,
    equation_3,
    equation_4,
    is_zero,
    l,
    lhat,
    p_e,
    p_r,
    phi,
    rows,
    t,
    theta,
    u0,
    u1,
    v0,
    v1,
    w0,
)

sp = pytest.importorskip("sympy", reason="the proofs need the dependency group 'derive'")

# ------------------------------------------------------------------------------------------------ section 2: the model


@pytest.mark.parametrize("j", SIGNS)
def test_eq_1(j: int) -> None:
    assert is_zero(closure(j).subs(t, 0))
    assert is_zero(closure(j).diff(t).subs(t, 0) - (dr - equation_1(j)))


def test_classes_of_the_cited_calibrations() -> None:
    """Section 1 by the numbers it cites: what is distance-based is external, and what is external is not autonomous."""
    external, autonomous = set(range(5, 10)), set(range(10, 14))
    coordinates, distances = {5, 7}, {9, 10}
    assert coordinates <= external
    assert distances - external == distances & autonomous == {10}


def test_eq_2() -> None:
    # the frame as the text builds it: Rot(z, phi) Rot(x, pi/2)
    assert is_zero(sp.rot_ccw_axis3(phi) * sp.rot_ccw_axis1(sp.pi / 2) - R0)
    assert is_zero((R0 * R1)[:, :2] - sp.Matrix.hstack(u1, v1))
    assert is_zero(u0.cross(u1) - sp.sin(theta) * w0)
    assert is_zero(v0.cross(u1) + sp.cos(theta) * w0)
    assert is_zero(w0.cross(u1) - v1)


def test_eq_3() -> None:
    assert is_zero(dr - (equation_1(1) + equation_1(2)) / 2 - equation_3())


def test_eq_4() -> None:
    # the difference of the two closures, divided by c; the printed bar over the rods' turns would make it their mean
    difference = (equation_1(1) - equation_1(2)) / c
    assert is_zero(difference + equation_4())
    mean = equation_4() + l / c * ((eps_rod[1] - eps_rod[2]) - (eps_rod[1] + eps_rod[2]) / 2).cross(lhat)
    assert not is_zero(difference + mean)


def test_eq_5() -> None:
    first = lhat.dot(dr) + a_i.cross(lhat).dot(eps)
    first -= L * dtheta * lhat.dot(v1) + lhat.dot(de) + d_arm * lhat.dot(u1) + dl_mean
    first -= L * (sp.sin(theta) * dalpha0 - sp.cos(theta) * dbeta0) * lhat.dot(w0)
    turns = -dalpha03 * v0 + dbeta03 * u0 - dalpha2 * v1 + dbeta2 * u1
    second = w0.cross(lhat).dot(eps) - (dl_diff / c + dc / c * lhat.dot(w0) + lhat.dot(turns))
    assert is_zero(lhat.dot(equation_3()) - first)
    assert is_zero(lhat.dot(equation_4()) - second)


def test_eq_6() -> None:
    B_r, _ = rows()
    assert is_zero(lhat.dot(equation_3()) - (lhat.dot(dr) + a_i.cross(lhat).dot(eps) - (B_r * p_r)[0]))


def test_eq_7() -> None:
    _, B_e = rows()
    assert is_zero(lhat.dot(equation_4()) - (w0.cross(lhat).dot(eps) - (B_e * p_e)[0]))


def test_eq_8_and_9() -> None:
    n = 3
    A_rr, A_re, A_ee = (sp.MatrixSymbol(name, n, n) for name in ("A_rr", "A_re", "A_ee"))
    x, y = sp.MatrixSymbol("x", n, 1), sp.MatrixSymbol("y", n, 1)  # B_r Delta p_r and B_e Delta p_e
    turn = A_ee.I * y
    shift = A_rr.I * x - A_rr.I * A_re * A_ee.I * y
    assert (A_ee * turn).doit() == y
    assert sp.expand(A_rr * shift + A_re * turn).doit() == x


def test_eqs_8_and_9_against_the_exact_machine(robot: Robot, mechanism: Machine) -> None:
    """Derivatives of the package's exact closure, for a reference point at the centre and off it."""
    columns = [mechanism.index[n] for n in bai.MODEL_42]
    for point in (np.zeros(3), np.array([35.0, -20.0, -60.0])):
        r = bai.scattered(20, np.random.default_rng(3)) + point
        machine = mechanism.rows(robot)
        q, x, _ = mechanism.inverse(r, point, machine)
        S = mechanism.sensitivity(x, q, point, machine).parameters[:, :, columns]
        S = S / mechanism.scaling("paper", robot, bai.MODEL_42)
        C_r, C_e = bai.sensitivity(r - point, point)
        assert S[:, :3] == pytest.approx(C_r, abs=1e-12 * np.abs(C_r).max())
        assert S[:, 3:, 24:] == pytest.approx(C_e, abs=1e-12 * np.abs(C_e).max())
        assert S[:, 3:, :24] == pytest.approx(0.0, abs=1e-12)  # Delta p_r turns nothing


def test_a_i_counts_from_the_reference_point(robot: Robot, mechanism: Machine) -> None:
    """With P below O' the derivatives of the exact machine want a_i less P; with the paper's a_i they are missed."""
    point = np.array([0.0, 0.0, -60.0])
    r = bai.scattered(20, np.random.default_rng(3)) + point
    machine = mechanism.rows(robot)
    q, x, _ = mechanism.inverse(r, point, machine)
    columns = [mechanism.index[n] for n in bai.MODEL_42]
    S = mechanism.sensitivity(x, q, point, machine).parameters[:, :3, columns]
    S = S / mechanism.scaling("paper", robot, bai.MODEL_42)
    size = np.abs(S).max()
    from_the_point, from_the_centre = bai.sensitivity(r - point, point)[0], bai.sensitivity(r - point)[0]
    assert np.abs(S - from_the_point).max() < 1e-12 * size
    assert np.abs(S - from_the_centre).max() > 0.1 * size


def test_where_the_term_of_eq_22_is_added(robot: Robot, mechanism: Machine) -> None:
    """Joints move the point by L A_rr^-1 B_m: the term belongs to (6); on the right of (8) it would be B_m."""
    r = bai.scattered(20, np.random.default_rng(3))
    machine = mechanism.rows(robot)
    q, x, _ = mechanism.inverse(r, np.zeros(3), machine)
    by_joints = mechanism.sensitivity(x, q, np.zeros(3), machine).joints[:, :3]
    A_rr, *_, B_m = bai.matrices(r)
    arm = robot.geometry["proximal_length"][0]
    size = np.abs(by_joints).max()
    assert np.abs(by_joints - arm * np.linalg.solve(A_rr, B_m)).max() < 1e-12 * size
    assert np.abs(by_joints - arm * B_m).max() > 0.5 * size


def test_counts_of_the_models() -> None:
    """Section 2: 18 errors turn the plate and 42 move the point; none of the columns is zero."""
    C_r, C_e = bai.sensitivity(bai.scattered(20, np.random.default_rng(3)))
    assert C_r.shape[2] == 24 + 18
    assert C_e.shape[2] == 18
    assert np.abs(C_r).max(axis=(0, 1)).min() > 0.1
    assert np.abs(C_e).max(axis=(0, 1)).min() > 0.01


def test_the_matrices_are_regular_in_the_workspace() -> None:
    grid = np.vstack([bai.ring(36, d, radius=r) for d in np.linspace(0, 1, 6) for r in np.linspace(0, 500, 9)])
    A_rr, _, A_ee, _, _, B_m = bai.matrices(grid)
    assert np.linalg.svd(A_rr, compute_uv=False)[:, -1].min() > 0.3
    assert np.linalg.svd(A_ee, compute_uv=False)[:, -1].min() > 0.6
    assert np.abs(np.einsum("nii->ni", B_m)).min() > 0.6
    # the claim has a limit outside the workspace: rods parallel to z, elbows at a distance a, make both singular
    upright = np.tile([0.0, 0.0, -1.0], (3, 1))
    assert np.linalg.matrix_rank(np.cross(bai.W0, upright)) == 2


def test_eq_10() -> None:
    """The plate stays parallel exactly where the six errors of each limb vanish: the functions are independent."""
    r = bai.scattered(40, np.random.default_rng(3))
    B_e = bai.matrices(r)[4]
    for limb in range(3):
        assert bai.rank(B_e[:, limb, 6 * limb : 6 * limb + 6]) == 6
    assert bai.sensitivity(r)[0][:, :, :24] == pytest.approx(np.linalg.solve(bai.matrices(r)[0], bai.matrices(r)[3]))
    assert len(bai.MODEL_24) == 24
