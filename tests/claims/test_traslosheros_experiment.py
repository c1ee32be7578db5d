"""Static and tracking tests of Traslosheros et al. 2013, section 6 and appendix, each claim decided."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp

from deltacal_gen.use import iso9283
from tests.claims import independent_traslosheros as own
from tests.claims.calibrated_traslosheros import NOISE, POINTS, TRUE
from tests.claims.independent_traslosheros import NOMINAL

# ----------------------------------------------------------------------------------------- section 6.1: static tests


def standardised(n: int, trials: int, seed: int) -> np.ndarray:
    """Normal samples (trials, n, 3) with mean 0 and standard deviation 1 each."""
    x = np.random.default_rng(seed).normal(size=(trials, n, 3))
    x -= x.mean(axis=1, keepdims=True)
    return x / x.std(axis=1, ddof=1, keepdims=True)


def repeatabilities(x: np.ndarray) -> np.ndarray:
    gap = np.linalg.norm(x, axis=2)
    return gap.mean(axis=1) + 3 * gap.std(axis=1, ddof=1)


TABLE_2 = np.array([[0.014, 0.059], [0.038, 0.163], [0.092, 0.497]])
TABLE_3 = np.array([[0.0025, 0.0096], [0.0049, 0.0150], [0.0212, 0.0846]])


def test_table_2_and_3_ranges_fit_their_deviations() -> None:
    for n, table in ((50, TABLE_2), (25, TABLE_3)):
        x = standardised(n, 4000, n)
        low, high = np.percentile(np.ptp(x, axis=1), [0.1, 99.9])
        ratio = table[:, 1] / table[:, 0]
        assert ((ratio > low) & (ratio < high)).all()


def test_table_3_mean_of_500_is_better() -> None:
    gain = TABLE_2[:, 0] / TABLE_3[:, 0]
    assert gain == pytest.approx([5.6, 7.8, 4.3], abs=0.06)
    assert (gain > 4).all()
    assert (gain < np.sqrt(500) / 2).all()  # far from the 22.4 of independent images


def test_depth_is_worse_than_the_image_plane() -> None:
    f, z, diameter = sp.symbols("f Z D", positive=True)
    seen = sp.symbols("d", positive=True)
    depth = sp.diff(f * diameter / seen, seen).subs(seen, f * diameter / z)
    assert sp.simplify(depth + z**2 / (f * diameter)) == 0
    assert (200**2 / 40) / 200 == 5  # times worse than across, per pixel, at 200 mm with the circle of 40 mm
    for table in (TABLE_2, TABLE_3):
        assert table[2, 0] > 2 * table[:2, 0].max()


def test_whose_method_calibrates_a_camera() -> None:
    """Titles of the two references, one letter apart: of a camera's calibration speaks the other one."""
    titles = {
        32: "Hand-eye calibration and positioning for a robot drilling system",
        33: "A flexible new technique for camera calibration",
    }
    assert ["camera calibration" in titles[n] for n in (32, 33)] == [False, True]


def test_resolution_of_the_camera() -> None:
    f_px = 200 / 0.4
    assert f_px == 500
    assert f_px * 40 / 200 == pytest.approx(100)  # px across the circle


def test_repeatability_of_the_measurement() -> None:
    RP = repeatabilities(standardised(25, 20_000, 3) * TABLE_3[:, 0])
    assert np.median(RP) == pytest.approx(0.0534, abs=0.0005)
    assert (RP >= 0.0635).mean() < 1e-3
    bound = np.sqrt(np.sum(TABLE_3[:, 0] ** 2) * (24 / 25 + 9))  # of l + 3 S for any sample with these deviations
    assert 0.0635 < bound < 0.0692
    assert abs(3 * TABLE_3[2, 0] - 0.0635) < 3 * 0.00005  # within the rounding of 0.0212: three deviations of Z_c


def test_table_4() -> None:
    x = standardised(25, 8000, 4)
    for ranges, printed in (((0.032, 0.025, 0.114), 0.07041), ((0.039, 0.034, 0.121), 0.07512)):
        RP = repeatabilities(x / np.ptp(x, axis=1, keepdims=True) * ranges)
        low, high = np.percentile(RP, [2.5, 97.5])
        assert low < printed < high
        assert printed < 0.1


def test_repeatabilities_are_coherent() -> None:
    assert np.hypot(0.02, 0.0635) == pytest.approx(0.0666, abs=1e-4)
    assert all(0.0635 < RP < 0.02 + 0.0635 for RP in (0.07041, 0.07512))


def test_cycles_of_the_standard() -> None:
    assert iso9283.CYCLES == 30  # ISO 9283:1998, pose accuracy and repeatability, and distance accuracy
    assert iso9283.CYCLES != 25


def test_encoder_resolution() -> None:
    """0.02 mm is 0.002 degrees at the joint; the paper gives neither counts nor gear ratio."""
    J = own.jacobian(NOMINAL, own.inverse(NOMINAL, POINTS), POINTS)
    worst = np.linalg.norm(J, ord=2, axis=(1, 2)).max()
    assert 0.001 < np.rad2deg(0.02 / worst) < 0.003


def test_static_test_volume() -> None:
    grid = np.arange(5) * 100.0
    assert len(grid) ** 2 == 25
    assert grid[-1] == 400
    assert (5 - 1) * 100 == 400


def plate_distances(motor: bool = True) -> np.ndarray:
    """Errors (..., 2) of the distances between neighbouring circles when nominal parameters read the true joints."""
    step = np.arange(-200, 201, 100.0)
    grid = np.stack(np.meshgrid(step, step, step + 850, indexing="ij"), axis=-1)
    joints = own.inverse(TRUE, grid.reshape(-1, 3))
    read = own.forward(NOMINAL, joints - TRUE.theta0 if motor else joints).reshape(grid.shape)
    return np.concatenate([np.abs(np.linalg.norm(np.diff(read, axis=k), axis=-1) - 100).ravel() for k in (1, 2)])


def test_figures_9_and_10() -> None:
    error = plate_distances()
    assert len(error) == 200
    assert error.mean() == pytest.approx(0.90, abs=0.01)  # nominal; Table 1's calibrated set as the truth
    assert plate_distances(motor=False).mean() < 0.1  # were the angle offsets known
    assert error.mean() >= 1.468 - 0.583  # the difference of the two means does fit Table 1


def test_border_of_the_working_area() -> None:
    step = np.arange(-200, 201, 100.0)
    grid = np.stack(np.meshgrid(step, step, step + 850, indexing="ij"), axis=-1)
    read = own.forward(NOMINAL, own.inverse(TRUE, grid.reshape(-1, 3)) - TRUE.theta0).reshape(grid.shape)
    e = np.abs(np.linalg.norm(np.diff(read, axis=1), axis=-1) - 100)  # (5, 4, 5)
    assert e[:, [0, -1]].mean() < 1.1 * e[:, 1:-1].mean()  # Table 1 alone gives no growth towards the border


def test_reduction_of_the_distance_error() -> None:
    nominal, calibrated = 1.468, 0.583
    assert 100 * (nominal - calibrated) / nominal == pytest.approx(60.3, abs=0.05)
    assert 100 * calibrated / nominal == pytest.approx(39.7, abs=0.05)  # "almost 40 %" is what is left


# ---------------------------------------------------------------------------------------- section 6.2: tracking tests


def tracking(
    sign: float, M: np.ndarray, *, v: float = 0.0, K: float = 16.8, T: float = 8.34e-3, n: int = 400
) -> np.ndarray:
    """Error norm (n,) of a robot that follows a ball; e = actual minus desired position of the ball from the robot."""
    ball, robot, desired = np.array([0.0, 0.0, 600.0]), np.array([20.0, -10.0, 5.0]), np.array([0.0, 0.0, 600.0])
    speed, out = np.array([v, 0.0, 0.0]), []
    for _ in range(n):
        e = ball - robot - desired
        out.append(np.linalg.norm(e))
        robot = robot + T * (M @ (sign * K * e + speed))
        ball = ball + T * speed
    return np.array(out)


def test_eq_23() -> None:
    t, K, v = sp.symbols("t K_p v_p", positive=True)
    e = sp.Function("e")(t)  # actual minus desired position of the object, relative to the robot
    as_printed = sp.dsolve(sp.Eq(e.diff(t), v - (-K * e + v)), e).rhs  # the object moves by v_p, the robot by u_r
    assert sp.limit(as_printed.subs({K: 1, sp.Symbol("C1"): 1}), t, sp.oo) == sp.oo
    assert tracking(-1, np.eye(3))[50] > 100 * tracking(-1, np.eye(3))[0]  # e = object minus robot, as the text has it
    assert tracking(+1, np.eye(3))[-1] < 1e-9  # the same law for e = desired minus actual


def test_eq_24() -> None:
    P = POINTS[:20]
    angles = own.inverse(TRUE, P)
    J = own.jacobian(TRUE, angles, P)
    for k in range(3):
        step = np.zeros(3)
        step[k] = 1e-5
        slope_k = (own.forward(TRUE, angles + step) - own.forward(TRUE, angles - step)) / 2e-5
        assert J[:, :, k] == pytest.approx(slope_k, rel=1e-5, abs=1e-3)
    assert np.isfinite(np.linalg.inv(J)).all()


def jacobians(P: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """J_RC and J_RN at the same positions."""
    return (
        own.jacobian(TRUE, own.inverse(TRUE, P), P),
        own.jacobian(NOMINAL, own.inverse(NOMINAL, P), P),
    )


def test_eq_25_and_26() -> None:
    P = POINTS[:20]
    C, N = jacobians(P)
    wanted = np.array([300.0, -200.0, 100.0])
    rate = np.linalg.solve(N, np.broadcast_to(wanted[:, None], (20, 3, 1)))[..., 0]  # (25)
    moved = (own.forward(TRUE, own.inverse(TRUE, P) + 1e-6 * rate) - P) / 1e-6  # what the true robot does
    assert moved == pytest.approx(C @ np.linalg.inv(N) @ wanted, rel=1e-4, abs=1e-2)


def test_eq_27() -> None:
    C, N, v = sp.MatrixSymbol("C", 3, 3), sp.MatrixSymbol("N", 3, 3), sp.MatrixSymbol("v", 3, 1)
    left = C * N.I * v - C * C.I * v  # u_rN - u_rC by (26) with J_R = J_RC
    right = C * (N.I - C.I) * v
    assert sp.simplify(sp.expand(left - right)) == sp.ZeroMatrix(3, 1)
    assert sp.simplify(sp.expand(left + right)) != sp.ZeroMatrix(3, 1)


def test_eq_28() -> None:
    C, N = sp.MatrixSymbol("C", 3, 3), sp.MatrixSymbol("N", 3, 3)
    assert sp.simplify(sp.expand(C * (N.I - C.I)) - (C * N.I - sp.Identity(3))) == sp.ZeroMatrix(3, 3)
    P = POINTS[:20]
    c, n = jacobians(P)
    assert c @ (np.linalg.inv(n) - np.linalg.inv(c)) == pytest.approx(c @ np.linalg.inv(n) - np.eye(3), abs=1e-9)


def test_singular_value_is_the_bound() -> None:
    C, N = jacobians(POINTS[:50])
    D = C @ np.linalg.inv(N) - np.eye(3)
    bound = np.linalg.norm(D, ord=2, axis=(1, 2))
    v = np.random.default_rng(5).normal(size=(50, 200, 3))
    gain = np.linalg.norm(v @ np.swapaxes(D, 1, 2), axis=2) / np.linalg.norm(v, axis=2)
    assert (gain <= bound[:, None] * (1 + 1e-12)).all()
    assert (gain.max(axis=1) > 0.9 * bound).all()


def largest(bottom: float, at: str) -> float:
    return float(own.velocity_error(TRUE, NOMINAL, own.cylinder(300, bottom, bottom + 400), at=at).max())


def test_figure_12() -> None:
    """0.015 needs a height of the cylinder and a rule where the nominal Jacobian is taken; the paper gives neither."""
    assert largest(760, "joints") == pytest.approx(0.0150, abs=1e-4)
    assert largest(570, "position") == pytest.approx(0.0151, abs=1e-4)
    assert largest(650, "position") < 0.007
    assert largest(600, "joints") > 0.023


def test_figure_12_asymmetry() -> None:
    ring = np.array([[250 * np.cos(t), 250 * np.sin(t), 800.0] for t in np.deg2rad([10, 130, 250])])
    skew = own.velocity_error(TRUE, NOMINAL, ring, at="position")
    assert np.ptp(skew) > 0.05 * skew.mean()
    m = TRUE
    even = own.closed(replace(m, **{k: np.full(3, getattr(m, k).mean()) for k in ("a", "b", "h", "theta0")}))
    assert np.ptp(own.velocity_error(even, NOMINAL, ring, at="position")) < 1e-9
    assert np.isfinite(own.inverse(TRUE, own.cylinder(300, 600, 1000))).all()


def test_figures_of_the_bound() -> None:
    v = 16.8 * 30 + 1500
    assert v == 2004
    assert v == pytest.approx(2000, rel=0.005)
    assert 0.015 * 2000 == 30
    assert 30 / 2000 == 0.015


TABLE_5 = np.array(
    [[500, 4.54, 4.47], [750, 7.42, 7.32], [1000, 12.76, 12.61], [1250, 20.14, 19.84], [1500, 30.47, 30.14]]
)


def test_largest_tracking_error() -> None:
    assert TABLE_5[-1, 1:].min() > 30  # the mean at 1500 mm/s exceeds the "maximum" of 30 mm


def test_table_5() -> None:
    gain = 100 * (TABLE_5[:, 1] - TABLE_5[:, 2]) / TABLE_5[:, 1]
    assert gain == pytest.approx([1.54, 1.35, 1.18, 1.49, 1.08], abs=0.005)
    assert (gain > 1.5).sum() == 1
    assert gain.mean() == pytest.approx(1.33, abs=0.005)
    assert (gain > 0).all()
    assert gain.max() < 60  # smaller than the gain of section 6.1.2
    assert (np.diff(TABLE_5[:, 1:], axis=0) > 0).all()


def test_a_ball_at_rest() -> None:
    C, N = jacobians(POINTS[:1])
    M = (C @ np.linalg.inv(N))[0]
    rough, exact = tracking(1, M), tracking(1, np.eye(3))
    assert rough[-1] < 1e-9
    assert exact[-1] < 1e-9
    assert np.abs(rough - exact).max() > 1e-3  # the way there differs


def test_gain_is_stable() -> None:
    assert 0 < 16.8 * 8.34e-3 < 2  # sampled loop: e <- (1 - K T) e


def test_speed_fits_the_workspace() -> None:
    way = 6**2 / (2 * 58)
    assert way == pytest.approx(0.31, abs=0.005)  # m to reach or lose 6 m/s


# -------------------------------------------------------------------------------------------------------- the appendix


def test_appendix_repeatability() -> None:
    x = np.random.default_rng(6).normal(size=(25, 3)) * NOISE
    assert own.repeatability(x) == pytest.approx(iso9283.pose(x, np.zeros(3)).repeatability, rel=1e-12)
    assert own.repeatability(x + 100) == pytest.approx(own.repeatability(x), rel=1e-9)
    assert own.repeatability(3 * x) == pytest.approx(3 * own.repeatability(x), rel=1e-9)


def test_appendix_distance_accuracy() -> None:
    """The bars take the sign, which ISO 9283 keeps: too short and too long are the same then."""
    origin, along = np.zeros((2, 3)), np.array([[1.0, 0, 0]])
    long = iso9283.distance(origin, np.array([[100.2], [100.4]]) * along, 100)
    short = iso9283.distance(origin, np.array([[99.8], [99.6]]) * along, 100)
    assert long.accuracy == pytest.approx(0.3)
    assert long.accuracy == pytest.approx(-short.accuracy)
    assert long.repeatability == pytest.approx(3 * np.sqrt(0.02))


def test_scatter_of_x_and_y() -> None:
    one, mean = 0.038 / 0.014, 0.0049 / 0.0025
    assert one == pytest.approx(2.71, abs=0.01)
    assert mean == pytest.approx(1.96, abs=0.01)
