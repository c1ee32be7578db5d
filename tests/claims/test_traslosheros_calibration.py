"""Constraints and calibration of Traslosheros et al. 2013, sections 3 to 5.1, each claim decided by a derivation."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from tests.claims import independent_traslosheros as own
from tests.claims.calibrated_traslosheros import NOISE, POINTS, RNG_POINTS, TRUE
from tests.claims.independent_traslosheros import CALIBRATED, NOMINAL

a, b, h, H, phi, theta, theta0, turn = sp.symbols("a b h H phi theta theta_0 Theta", real=True)
px, py, pz, qx, qy, qz = sp.symbols("P_x P_y P_z Pi_x Pi_y Pi_z", real=True)


def column_scaled(J: np.ndarray) -> np.ndarray:
    return J / np.linalg.norm(J, axis=0)


def condition(J: np.ndarray) -> float:
    return float(np.linalg.cond(J))


# --------------------------------------------------------------------------------- sections 3 and 4: the constraints


def limb() -> tuple[sp.Matrix, sp.Matrix]:
    """B and C of one limb from rotations and translations only, not from the printed components."""
    spin = sp.rot_axis3(-phi)  # about z by +phi
    shoulder = spin * sp.Matrix([H, 0, 0])
    arm = spin * (sp.rot_axis2(theta) * sp.Matrix([a, 0, 0]))  # rot_axis2(+theta) carries x towards +z
    return shoulder + arm, sp.Matrix([px, py, pz]) + spin * sp.Matrix([h, 0, 0])


def gamma() -> sp.Expr:
    """Printed equation (4)."""
    return (
        (px + h * sp.cos(phi) + qx - (a * sp.cos(theta0 + turn) + H) * sp.cos(phi)) ** 2
        + (py + h * sp.sin(phi) + qy - (a * sp.cos(theta0 + turn) + H) * sp.sin(phi)) ** 2
        + (pz + qz - a * sp.sin(theta0 + turn)) ** 2
        - b**2
    )


def test_eq_1() -> None:
    P = POINTS[:50]
    angles = own.inverse(TRUE, P)  # from the triangle in the limb's plane, without equation (1)
    assert np.allclose(np.linalg.norm(own.rods(TRUE, angles, P), axis=2), TRUE.b, atol=1e-9)
    assert np.abs(own.closure(TRUE, angles, P)).max() < 1e-6
    # The centre of the effector is the intersection of three spheres.
    assert np.abs(own.forward(TRUE, angles) - P).max() < 1e-9


def test_eq_2() -> None:
    B, C = limb()
    printed_B = sp.Matrix(
        [(H + a * sp.cos(theta)) * sp.cos(phi), (H + a * sp.cos(theta)) * sp.sin(phi), a * sp.sin(theta)]
    )
    turned = sp.Matrix([[sp.cos(phi), -sp.sin(phi), 0], [sp.sin(phi), sp.cos(phi), 0], [0, 0, 1]])
    printed_C = sp.Matrix([px, py, pz]) - turned * sp.Matrix([-h, 0, 0])
    assert sp.simplify(B - printed_B) == sp.zeros(3, 1)
    assert sp.simplify(C - printed_C) == sp.zeros(3, 1)


def test_eq_3() -> None:
    joints, shift = own.increments(TRUE, POINTS)
    assert np.abs(own.closure(TRUE, TRUE.theta0 + joints, TRUE.p0 + shift)).max() < 1e-6
    assert np.abs(own.closure(TRUE, TRUE.theta0[None], TRUE.p0[None])).max() < 1e-6  # the home: both increments zero


def test_eq_4() -> None:
    B, C = limb()
    rod = (C - B).subs(theta, theta0 + turn).subs({px: px + qx, py: py + qy, pz: pz + qz}, simultaneous=True)
    assert sp.simplify(rod.dot(rod) - b**2 - gamma()) == 0


def test_eq_5() -> None:
    joints, shift = own.increments(TRUE, POINTS[:7])
    stacked = own.closure(NOMINAL, joints, NOMINAL.p0 + shift).T.ravel()  # limb by limb
    formula = sp.lambdify((a, b, h, H, phi, theta0, px, py, pz, turn, qx, qy, qz), gamma())
    m = NOMINAL
    by_hand = [
        formula(m.a[i], m.b[i], m.h[i], m.H[i], m.phi[i], m.theta0[i], *m.p0, joints[k, i], *shift[k])
        for i in range(3)
        for k in range(7)
    ]
    assert stacked.shape == (21,)
    assert np.allclose(stacked, by_hand, rtol=1e-12)


def test_eq_6() -> None:
    joints, shift = own.increments(TRUE, POINTS[:20])
    direction = (
        np.random.default_rng(1).normal(size=15) * np.tile([1, 1, 1, 1e-2, 1, 1, 1, 1e-2, 1, 1, 1, 1e-2], 2)[:15]
    )
    J = own.observation(NOMINAL, joints, shift)

    def phi_of(U: np.ndarray) -> np.ndarray:
        m = NOMINAL.with_vector(U)
        return own.closure(m, m.theta0 + joints, m.p0 + shift).T.ravel()

    U = NOMINAL.vector()
    gap = [np.linalg.norm(phi_of(U + t * direction) - phi_of(U) - t * J @ direction) for t in (1.0, 0.5, 0.25)]
    assert np.log2(gap[0] / gap[1]) == pytest.approx(2, abs=0.05)
    assert np.log2(gap[1] / gap[2]) == pytest.approx(2, abs=0.05)


def test_eq_7() -> None:
    values = (a, b, h, theta0, px, py, pz)
    derivative = sp.lambdify(
        (a, b, h, H, phi, theta0, px, py, pz, turn, qx, qy, qz), [sp.diff(gamma(), v) for v in values]
    )
    joints, shift = own.increments(TRUE, POINTS[:6])
    m = TRUE
    J = np.zeros((18, 15))
    for i in range(3):
        for k in range(6):
            row = derivative(m.a[i], m.b[i], m.h[i], m.H[i], m.phi[i], m.theta0[i], *m.p0, joints[k, i], *shift[k])
            J[6 * i + k, 4 * i : 4 * i + 4], J[6 * i + k, 12:] = row[:4], row[4:]
    assert np.allclose(J, own.observation(m, joints, shift), rtol=1e-10, atol=1e-8)
    assert own.observation(TRUE, *own.increments(TRUE, POINTS)).shape == (3 * RNG_POINTS, 15)


def test_eq_8() -> None:
    joints, shift = own.increments(TRUE, POINTS[:40])
    F = own.closure(NOMINAL, NOMINAL.theta0 + joints, NOMINAL.p0 + shift).T.ravel()
    U1 = NOMINAL.vector() - np.linalg.pinv(own.observation(NOMINAL, joints, shift), rcond=1e-12) @ F
    assert np.linalg.norm(U1) > 1000  # "= 0" as printed would set every parameter to zero
    found, history = own.gauss_newton(NOMINAL, joints, shift)
    assert np.abs(found.vector() - TRUE.vector()).max() < 1e-9
    assert history[1] < 0.05 * history[0]
    assert np.abs(U1 - TRUE.vector()).max() < 0.1 * np.abs(NOMINAL.vector() - TRUE.vector()).max()


def test_nonlinearity_is_no_reason_for_a_residual() -> None:
    joints, shift = own.increments(TRUE, POINTS)
    _, history = own.gauss_newton(NOMINAL, joints, shift)
    assert history[-1] < 1e-8 < 1 < history[0]  # perfect data: the nonlinear equations hold exactly
    noisy = shift + NOISE * np.random.default_rng(2).normal(size=shift.shape)
    assert own.gauss_newton(NOMINAL, joints, noisy)[1][-1] > 1  # [mm^2]: it is noise that leaves a residual


def test_units_of_the_jacobian() -> None:
    J = own.observation(TRUE, *own.increments(TRUE, POINTS))
    size = np.linalg.norm(J, axis=0) / np.sqrt(RNG_POINTS)
    assert size[3] / size[0] > 500  # by theta0: mm^2 per rad; by a: mm^2 per mm
    assert condition(J) > 100 * condition(column_scaled(J))
    # In metres the printed Jacobian has another condition number, so it is not homogeneous.
    metres = replace(TRUE, a=TRUE.a / 1e3, b=TRUE.b / 1e3, h=TRUE.h / 1e3, p0=TRUE.p0 / 1e3, H=TRUE.H / 1e3)
    joints, shift = own.increments(TRUE, POINTS)
    assert condition(own.observation(metres, joints, shift / 1e3)) < 0.01 * condition(J)


def test_identifiable_parameters() -> None:
    J = own.observation(TRUE, *own.increments(TRUE, POINTS))
    assert J.shape[1] == 3 * 4 + 3 == 15
    assert np.linalg.matrix_rank(column_scaled(J), 1e-10) == 15
    assert condition(column_scaled(J)) == pytest.approx(147, abs=1)


def test_joints_alone_identify_nothing() -> None:
    """Without camera and ball every pose brings three equations and three unknown coordinates: nothing is left."""
    joints, shift = own.increments(TRUE, POINTS[:20])
    J = own.observation(TRUE, joints, shift).reshape(3, 20, 15).transpose(1, 0, 2)
    by_position = J[:, :, 12:]  # of each pose's own Gamma by its own position
    assert all(np.linalg.matrix_rank(rows) == 3 for rows in by_position)
    unknown = np.zeros((20, 3, 20, 3))
    for k in range(20):
        unknown[k, :, k] = by_position[k]
    both = np.hstack([J.reshape(60, 15), unknown.reshape(60, 60)])
    assert np.linalg.matrix_rank(column_scaled(both)) == 60  # of 15 + 60 unknowns: all of it goes into the positions
    assert np.linalg.matrix_rank(column_scaled(J.reshape(60, 15))) == 15  # with the camera


def test_increments_are_not_the_angles() -> None:
    """theta_ik of (3) in the place of Theta_ik counts the home twice: equation (4) misses by far."""
    joints, shift = own.increments(TRUE, POINTS)
    assert np.abs(own.closure(TRUE, TRUE.theta0 + joints, TRUE.p0 + shift)).max() < 1e-6
    angles = TRUE.theta0 + joints
    assert np.abs(own.closure(TRUE, TRUE.theta0 + angles, TRUE.p0 + shift)).mean() > 1000


def test_the_iteration_is_gauss_newtons() -> None:
    """J is square for five poses only; for 300 equation (8) is least squares, whose residual noise keeps from zero."""
    shapes = [own.observation(TRUE, *own.increments(TRUE, POINTS[:n])).shape for n in (5, 300)]
    assert shapes == [(15, 15), (900, 15)]
    joints, shift = own.increments(TRUE, POINTS)
    noisy = shift + NOISE * np.random.default_rng(2).normal(size=shift.shape)
    found, history = own.gauss_newton(NOMINAL, joints, noisy)
    assert history[-1] > 1  # [mm^2]: no root for Newton and Raphson to find
    F = own.closure(found, found.theta0 + joints, found.p0 + noisy).T.ravel()
    J = column_scaled(own.observation(found, joints, noisy))
    assert np.abs(J.T @ F).max() < 1e-6 * np.linalg.norm(F)  # but the least sum of squares


def test_H_is_not_identifiable_beside_h() -> None:
    assert sp.simplify(sp.diff(gamma(), H) + sp.diff(gamma(), h)) == 0
    J = own.observation(TRUE, *own.increments(TRUE, POINTS), extra=True)
    with_H = J[:, [*range(15), 18, 19, 20]]
    assert np.linalg.matrix_rank(column_scaled(with_H), 1e-10) == 15
    assert J.shape[1] == 21
    assert np.linalg.norm(J, axis=0).min() > 1000  # all of them act on the model, H as well: no column is zero


def weighted_deviation(J: np.ndarray) -> np.ndarray:
    """Standard deviations from Table 3's noise of 300 positions; the limbs share it, so rows are whitened by pose."""
    rods = own.rods(TRUE, own.inverse(TRUE, POINTS), POINTS)
    L = 2 * rods * NOISE
    white = np.linalg.inv(np.linalg.cholesky(L @ np.swapaxes(L, 1, 2)))
    rows = white @ J.reshape(3, RNG_POINTS, -1).transpose(1, 0, 2)
    A = rows.reshape(3 * RNG_POINTS, -1)
    scale = np.linalg.norm(A, axis=0)
    return np.sqrt(np.diag(np.linalg.inv((A / scale).T @ (A / scale)))) / scale


def test_phi_is_identifiable() -> None:
    J = own.observation(TRUE, *own.increments(TRUE, POINTS), extra=True)[:, :18]
    assert np.linalg.matrix_rank(column_scaled(J), 1e-10) == 18
    assert condition(column_scaled(J)) < 3 * condition(column_scaled(J[:, :15]))
    assert np.rad2deg(weighted_deviation(J)[15:]).max() < 0.003
    # A common turn of the three limbs shows as well, because the camera's increments have the frame's directions.
    assert np.linalg.norm(J[:, 15:] @ np.ones(3)) > 0.1 * np.linalg.norm(J[:, 15])


def test_translation_of_the_camera_drops_out() -> None:
    R, ball, mount, p, p0 = sp.MatrixSymbol("R", 3, 3), *(sp.MatrixSymbol(s, 3, 1) for s in ("g", "t", "p", "p0"))
    seen, seen0 = R.T * (ball - p - mount), R.T * (ball - p0 - mount)
    assert sp.simplify((seen - seen0).as_explicit() + (R.T * (p - p0)).as_explicit()).expand() == sp.zeros(3, 1)


def test_rotation_of_the_camera_matters() -> None:
    joints, shift = own.increments(TRUE, POINTS)
    w = np.deg2rad(0.1)
    wrong = shift @ np.array([[1, 0, 0], [0, np.cos(w), -np.sin(w)], [0, np.sin(w), np.cos(w)]]).T
    found, history = own.gauss_newton(NOMINAL, joints, wrong)
    assert np.abs(found.vector() - TRUE.vector()).max() > 0.5  # mm, from a tenth of a degree
    assert history[-1] > 10


def test_newton_may_miss() -> None:
    joints, shift = own.increments(TRUE, own.workspace_points(30, np.random.default_rng(0)))
    poor = replace(NOMINAL, theta0=np.full(3, 1.5), p0=np.array([0, 0, 300.0]))
    found, history = own.gauss_newton(poor, joints, shift, 100)
    assert history[-1] == pytest.approx(history[-2], rel=1e-9)  # it has converged
    assert history[-1] > 1e4
    assert found.b.max() < 300  # rods of a quarter of their length
    mirrored, history = own.gauss_newton(replace(NOMINAL, p0=-NOMINAL.p0), joints, shift, 100)
    assert history[-1] < 1e-6
    assert (mirrored.b < 0).all()  # exact, and useless: a test of the residual alone does not do


# ------------------------------------------------------------------------------------------ section 5.1 and Table 1


def test_number_of_poses() -> None:
    for n, rank in ((4, 12), (5, 15), (6, 15)):
        J = own.observation(TRUE, *own.increments(TRUE, POINTS[:n]))
        assert np.linalg.matrix_rank(column_scaled(J), 1e-10) == rank
    recovered = 0
    for seed in range(20):
        five = own.workspace_points(5, np.random.default_rng(seed))
        found, _ = own.gauss_newton(NOMINAL, *own.increments(TRUE, five), 60)
        recovered += np.abs(found.vector() - TRUE.vector()).max() < 1e-3
    assert recovered == 20
    # The home may be one of the five.
    J = own.observation(TRUE, *own.increments(TRUE, np.vstack([TRUE.p0, POINTS[:4]])))
    assert np.linalg.matrix_rank(column_scaled(J), 1e-10) == 15


def test_singular_poses_are_critical() -> None:
    """Position error per error of an arm's length, towards the pose in which the three rods are parallel."""
    parallel = np.arccos(-(NOMINAL.H[0] - NOMINAL.h[0]) / NOMINAL.a[0])
    gain = []
    for short in np.deg2rad([60, 20, 5, 1]):
        m = own.closed(replace(NOMINAL, theta0=np.full(3, parallel - short)))
        J = own.observation(m, np.zeros((1, 3)), np.zeros((1, 3)))
        gain.append(np.linalg.norm(np.linalg.solve(J[:, 12:], J[:, [0, 4, 8]]), ord=2))
    assert (np.diff(gain) > 0).all()
    assert gain[-1] > 10 * gain[0]


def test_times_of_the_measurement() -> None:
    images = 300 * 500 * 8.34e-3 / 60
    assert images == pytest.approx(21, abs=0.5)
    total = images + 300 * 4 / 60
    assert total == pytest.approx(40.9, abs=0.1)  # motions and the 5 s of the optimisation not counted
    assert round(total, -1) == 40


def test_table_1_nominal_home() -> None:
    home = own.forward(NOMINAL, NOMINAL.theta0)[0]
    assert home == pytest.approx([0, 0, np.sqrt(1000**2 - 660**2)], abs=1e-9)
    assert home[2] == pytest.approx(751.27, abs=0.005)
    assert abs(home[2] - NOMINAL.p0[2]) > 1


def test_table_1_calibrated_home() -> None:
    gap = np.linalg.norm(own.rods(CALIBRATED, CALIBRATED.theta0[None], CALIBRATED.p0[None])[0], axis=1) - CALIBRATED.b
    assert gap == pytest.approx([-12.64, -10.91, -10.24], abs=0.01)
    # No sign of the angles or of P_x, P_y brings the three rods to their lengths.
    for s in (1, -1):
        for sx in (1, -1):
            for sy in (1, -1):
                m = replace(CALIBRATED, theta0=s * CALIBRATED.theta0, p0=CALIBRATED.p0 * [sx, sy, 1])
                rods = own.rods(m, m.theta0[None], m.p0[None])[0]
                assert np.abs(np.linalg.norm(rods, axis=1) - m.b).max() > 3
    assert own.forward(CALIBRATED, CALIBRATED.theta0)[0] == pytest.approx([3.31, -0.26, 758.80], abs=0.005)


def test_table_1_is_recovered() -> None:
    # Free of the home: the printed fifteen numbers, with readings that do not hold the home itself.
    for truth in (CALIBRATED, TRUE):
        found, _ = own.gauss_newton(NOMINAL, *own.increments(truth, POINTS))
        assert np.abs(found.vector() - truth.vector()).max() < 1e-9
    noisy = weighted_deviation(own.observation(TRUE, *own.increments(TRUE, POINTS)))
    assert noisy[[0, 1, 2]] == pytest.approx([0.0048, 0.0203, 0.0091], abs=2e-4)
    assert np.rad2deg(noisy[3]) == pytest.approx(0.0010, abs=1e-4)
    # So deviations of Table 1 are far outside the noise of the camera.
    assert (np.abs(TRUE.b - NOMINAL.b) / noisy[[1, 5, 9]]).min() > 50


def test_table_1_keeps_phi_and_H() -> None:
    assert np.array_equal(CALIBRATED.phi, NOMINAL.phi)
    assert np.array_equal(CALIBRATED.H, NOMINAL.H)
    moved = np.abs(CALIBRATED.vector() - NOMINAL.vector())
    assert (moved > 0).all()  # and the fifteen others were all estimated
