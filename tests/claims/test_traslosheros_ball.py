"""The ball in the image of Traslosheros et al. 2013, sections 5.2 and 5.3, each claim decided by a derivation."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from tests.claims import independent_traslosheros as own
from tests.claims.independent_traslosheros import BALL

BALLS = [
    np.array(c) for c in ((100.0, 60.0, 400.0), (-80.0, 30.0, 300.0), (150.0, -120.0, 600.0), (-40.0, -70.0, 250.0))
]


# ----------------------------------------------------------------------------------- sections 5.2 and 5.3: the ball


X, Y, Z, R = sp.symbols("X_B Y_B Z_B R", positive=True)
slope = sp.Symbol("alpha", real=True)


def tangent_points(centre: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Points where the planes x = alpha z of the two extremes touch the sphere."""
    out = []
    for t in own.extremes(centre)[0]:
        normal = np.array([1.0, 0.0, -t]) / np.hypot(1, t)
        out.append(centre - (centre @ normal) * normal)
    return out[0], out[1]


@pytest.mark.parametrize("centre", BALLS)
def test_eq_9_and_13(centre: np.ndarray) -> None:
    alpha, _ = own.extremes(centre)
    for t, P in zip(alpha, tangent_points(centre), strict=True):
        assert P[0] == pytest.approx(t * P[2])
        assert np.linalg.norm(P - centre) == pytest.approx(BALL)
        assert P[1] == pytest.approx(centre[1])  # the tangent points lie in the plane Y = Y_B of figure 5


@pytest.mark.parametrize("centre", BALLS)
def test_eq_10_and_14(centre: np.ndarray) -> None:
    """Images of the tangent points are the extremes of the whole outline, found here point by point."""
    f = 500.0
    outline = f * own.ellipse(centre).points(200_000)
    alpha, beta = own.extremes(centre)
    assert outline.max(axis=0) / f == pytest.approx([alpha[0], beta[0]], abs=1e-9)
    assert outline.min(axis=0) / f == pytest.approx([alpha[1], beta[1]], abs=1e-9)
    assert [P[0] / P[2] for P in tangent_points(centre)] == pytest.approx(list(alpha))


def test_eq_11_and_15() -> None:
    d = sp.Matrix([slope, sp.Symbol("beta", real=True), 1])
    C = sp.Matrix([X, Y, Z])
    cone = (d.dot(C)) ** 2 - (C.dot(C) - R**2) * d.dot(d)  # zero where the line along d touches the sphere
    # The extreme in x is where the cone has a double root in y.
    double = sp.discriminant(cone, d[1])
    printed = (X - slope * Z) ** 2 - R**2 * (1 + slope**2)
    factor = sp.factor(sp.cancel(double / printed))
    assert factor != 0
    assert not factor.has(slope)  # so the double root is where printed (11) holds


@pytest.mark.parametrize("centre", BALLS)
def test_eq_12_and_16(centre: np.ndarray) -> None:
    alpha, beta = own.extremes(centre)
    for t, c in ((alpha, centre[0]), (beta, centre[1])):
        assert -c + t[0] * centre[2] == pytest.approx(BALL * np.hypot(1, t[0]))
        assert c - t[1] * centre[2] == pytest.approx(BALL * np.hypot(1, t[1]))
        assert abs(c / centre[2] - t.mean()) < 0.02 * (t[0] - t[1])  # null near the mean, not at it
    assert own.from_extremes(alpha, beta) == pytest.approx(centre, abs=1e-9)


def test_tangent_points_are_closer_than_a_diameter() -> None:
    for centre in BALLS:
        P1, P2 = tangent_points(centre)
        expected = 2 * BALL * np.sqrt(1 - BALL**2 / (centre[0] ** 2 + centre[2] ** 2))
        assert np.linalg.norm(P1 - P2) == pytest.approx(expected)
        assert expected < 2 * BALL


def test_lines_of_sight_leave_the_plane_of_the_tangent_points() -> None:
    """Y = Y_B does not hold the optical centre; in X_c-Z_c lie the lines' projections, and (11) is of these."""
    for centre in BALLS:
        for P in tangent_points(centre):
            assert P[1] == pytest.approx(centre[1])
            assert abs(P[1] / 2 - centre[1]) > 10  # half way to the camera
            flat, at = P[[0, 2]] / np.hypot(P[0], P[2]), centre[[0, 2]]
            assert abs(flat[0] * at[1] - flat[1] * at[0]) == pytest.approx(BALL)


def test_the_ellipse_is_not_centred_on_the_ball() -> None:
    centre = BALLS[0]
    away = own.ellipse(centre).centre * centre[2] - centre[:2]
    assert np.linalg.norm(away) == pytest.approx(0.264, abs=0.001)  # mm at the ball, outward
    assert away @ centre[:2] > 0


def test_chords_are_not_extremes() -> None:
    centre = BALLS[0]
    alpha, _ = own.extremes(centre)
    x, y = own.chords(own.ellipse(centre))
    assert (x[0] - x[1]) < (alpha[0] - alpha[1])
    assert own.from_extremes(x, y) - centre == pytest.approx([0.065, 0.039, 0.260], abs=0.001)


def test_eq_17() -> None:
    for centre in BALLS:
        assert np.arccos(centre[2] / np.linalg.norm(centre)) == pytest.approx(
            np.arctan2(np.hypot(centre[0], centre[1]), centre[2])
        )
        # Turned about the minor axis by this angle the image plane sees a circle.
        image = own.ellipse(centre)
        across = np.array([-image.direction[1], image.direction[0], 0.0])
        assert across @ centre == pytest.approx(0, abs=1e-9)
        axis = centre / np.linalg.norm(centre)
        frame = np.array([np.cross(across, axis), across, axis])
        turned = own.ellipse(frame @ centre)
        assert turned.major == pytest.approx(turned.minor)
        # The centre of the ellipse itself lies on another ray.
        ray = np.append(image.centre, 1.0)
        assert np.linalg.norm(np.cross(ray / np.linalg.norm(ray), axis)) > 1e-5


def test_eq_18() -> None:
    for centre in BALLS:
        image, rho = own.ellipse(centre), np.linalg.norm(centre)
        cos, sin = centre[2] / rho, BALL / rho
        exact = np.sqrt((cos**2 - sin**2) / (1 - sin**2))
        assert image.minor / image.major == pytest.approx(exact, rel=1e-12)
        assert cos - image.minor / image.major > 3e-5  # printed: cos
        small = own.ellipse(centre, BALL / 100)
        assert small.minor / small.major == pytest.approx(cos, rel=1e-7)  # holds for a vanishing ball


def printed_ellipse(image: own.Ellipse, spin: float, t: np.ndarray) -> np.ndarray:
    """Equation (19) with the angle theta_r as given."""
    p, q = image.minor, image.major
    x = p * np.cos(t) * np.cos(spin) - q * np.sin(t) * np.sin(spin)
    y = p * np.cos(t) * np.sin(spin) + q * np.sin(t) * np.cos(spin)
    return image.centre + np.column_stack([x, y])


def off_cone(points: np.ndarray, centre: np.ndarray) -> float:
    """Largest distance of sight lines from touching the ball [mm]."""
    d = np.column_stack([points, np.ones(len(points))])
    gap = np.linalg.norm(np.cross(d, centre), axis=1) / np.linalg.norm(d, axis=1)
    return float(np.abs(gap - BALL).max())


TURN = np.linspace(0, 2 * np.pi, 100)


def test_eq_19() -> None:
    for centre in BALLS:
        image = own.ellipse(centre)
        spin = np.arctan2(-image.direction[0], image.direction[1])  # major axis at (-sin, cos)
        assert off_cone(printed_ellipse(image, spin, TURN), centre) < 1e-9


def test_eq_19_holds_for_any_angle() -> None:
    """The ellipse of (19) has the same axes however it is turned: which turn is the image's, only (20) says."""
    image = own.ellipse(BALLS[0])
    for spin in (0.0, 0.4, 1.3):
        away = np.linalg.norm(printed_ellipse(image, spin, np.linspace(0, 2 * np.pi, 361)) - image.centre, axis=1)
        assert (away.min(), away.max()) == pytest.approx((image.minor, image.major))


def test_a_e_and_b_e_are_semi_axes() -> None:
    """(19) is as wide as 2 a_e along the major axis, and (21) equates its term to half a chord."""
    for centre in BALLS:
        image = own.ellipse(centre)
        spin = np.arctan2(-image.direction[0], image.direction[1])
        points = printed_ellipse(image, spin, np.linspace(0, 2 * np.pi, 361))
        assert np.ptp(points @ image.direction) / image.major == pytest.approx(2.0)


def test_eq_20() -> None:
    for centre in BALLS:
        image = own.ellipse(centre)
        x, y = image.centre
        printed, other = np.arctan(-y / x), np.arctan(y / x)
        right = np.arctan(-x / y)
        assert off_cone(printed_ellipse(image, right, TURN), centre) < 1e-9
        assert off_cone(printed_ellipse(image, printed, TURN), centre) > 0.2  # mm
        assert off_cone(printed_ellipse(image, other, TURN), centre) > 0.2  # with the image's y axis turned over
    on_the_diagonal = own.ellipse(np.array([100.0, 100.0, 300.0]))
    x, y = on_the_diagonal.centre
    assert off_cone(printed_ellipse(on_the_diagonal, np.arctan(-y / x), TURN), np.array([100.0, 100.0, 300.0])) < 1e-9


def turned_extremes(image: own.Ellipse, turn: float) -> list[np.ndarray]:
    """Return the extremes in x and y of an ellipse with the image's axes, turned as (19) has it."""
    along = np.array([[image.minor * np.cos(turn), image.major * np.sin(turn)]])
    across = np.array([[image.minor * np.sin(turn), image.major * np.cos(turn)]])
    half = np.linalg.norm(np.vstack([along, across]), axis=1)
    return [image.centre[k] + half[k] * np.array([1.0, -1.0]) for k in (0, 1)]


def test_mean_bias_of_eq_20_over_the_field_of_view() -> None:
    """What the printed angle leaves of the ball's place, all else right: towards the camera, in proportion to it."""
    slopes = np.linspace(-0.3, 0.3, 7)
    off, uncorrected = [], []
    for z in (200.0, 300.0, 400.0, 500.0, 600.0):
        for centre in (np.array([x * z, y * z, z]) for x in slopes for y in slopes if (abs(x) + abs(y)) > 1e-9):
            image = own.ellipse(centre)
            x, y = image.centre
            right = own.from_extremes(*turned_extremes(image, np.arctan2(-x, y)))
            assert right == pytest.approx(centre, abs=1e-9)
            off.append(own.from_extremes(*turned_extremes(image, np.arctan2(-y, x))) - centre)
            uncorrected.append(own.from_extremes(*own.chords(image)) - centre)
    assert np.linalg.norm(off, axis=1).mean() == pytest.approx(0.115, abs=0.001)
    assert np.mean(off, axis=0) == pytest.approx([0.0, 0.0, -0.111], abs=0.001)
    assert np.linalg.norm(uncorrected, axis=1).mean() == pytest.approx(0.307, abs=0.001)


def test_eq_21() -> None:
    for centre in BALLS:
        image = own.ellipse(centre)
        spin = np.arctan2(-image.direction[0], image.direction[1])
        (x2, x1), _ = own.chords(image)
        angle = np.arctan2(-image.minor * np.sin(spin), image.major * np.cos(spin))
        if image.minor * np.cos(angle) * np.cos(spin) - image.major * np.sin(angle) * np.sin(spin) < 0:
            angle += np.pi
        end = printed_ellipse(image, spin, np.array([angle]))[0]
        assert end == pytest.approx([x2, image.centre[1]])
        assert end[0] - image.centre[0] == pytest.approx((x2 - x1) / 2)  # the left side of (21)
        # As printed before (21), x_uc = x_ue + (x_u2 - x_u1)/2, the end is the other one and the sign is minus.
        assert end[0] - image.centre[0] != pytest.approx(-(x2 - x1) / 2)


def test_eq_22() -> None:
    tz, tr, te, half, ae = sp.symbols("theta_z theta_r theta_e c a_e", positive=True)
    be = ae * sp.cos(tz)
    angle = sp.atan(-sp.tan(tr) * sp.cos(tz))
    second = be * sp.cos(te) * sp.sin(tr) + ae * sp.sin(te) * sp.cos(tr)
    assert sp.simplify(second.subs(te, angle)) == 0
    first = be * sp.cos(te) * sp.cos(tr) - ae * sp.sin(te) * sp.sin(tr)
    printed = half / (sp.cos(tz) * sp.cos(te) * sp.cos(tr) - sp.sin(te) * sp.sin(tr))
    assert sp.simplify(first.subs(ae, printed) - half) == 0


def corrected(centre: np.ndarray, rounds: int, *, spin: str, ends: str) -> list[np.ndarray]:
    """Section 5.3, round by round, from the chords of the exact image."""
    image = own.ellipse(centre)
    x, y = own.chords(image)
    xc, yc = image.centre
    guess, out = own.from_extremes(x, y), []
    tr = np.arctan(-yc / xc) if spin == "printed" else np.arctan(-xc / yc)
    for _ in range(rounds):
        tz = np.arccos(guess[2] / np.linalg.norm(guess))
        te = np.arctan(-np.tan(tr) * np.cos(tz))
        major = abs((x[0] - x[1]) / 2 / (np.cos(tz) * np.cos(te) * np.cos(tr) - np.sin(te) * np.sin(tr)))
        minor = major * np.cos(tz)
        shape = own.Ellipse(image.centre, major, minor, np.array([-np.sin(tr), np.cos(tr)]))
        if ends == "vertices":
            points = printed_ellipse(shape, tr, np.array([0, np.pi / 2, np.pi, 3 * np.pi / 2]))
            top, low = points.max(axis=0), points.min(axis=0)
        else:
            reach = np.hypot(minor * np.array([np.cos(tr), np.sin(tr)]), major * np.array([np.sin(tr), np.cos(tr)]))
            top, low = image.centre + reach, image.centre - reach
        guess = own.from_extremes(np.array([top[0], low[0]]), np.array([top[1], low[1]]))
        out.append(guess)
    return out


def test_axis_ends_are_not_extremes() -> None:
    """theta_e = 0, pi/2, pi, 3 pi/2 give the ends of the axes; (12) and (16) need the extremes in x and y."""
    centre = BALLS[0]
    uncorrected = np.linalg.norm(own.from_extremes(*own.chords(own.ellipse(centre))) - centre)
    vertices = np.linalg.norm(corrected(centre, 2, spin="right", ends="vertices")[-1] - centre)
    extremes = np.linalg.norm(corrected(centre, 2, spin="right", ends="extremes")[-1] - centre)
    assert uncorrected == pytest.approx(0.271, abs=0.001)
    assert vertices > 60
    assert extremes < 0.01
    assert np.linalg.norm(corrected(centre, 2, spin="printed", ends="extremes")[-1] - centre) > 7
    assert len({0, np.pi / 2, np.pi, 3 * np.pi / 2}) == 4 != len({0, np.pi / 2, np.pi, np.pi / 2})  # as printed


def test_two_rounds_are_enough() -> None:
    for centre in BALLS:
        rounds = corrected(centre, 3, spin="right", ends="extremes")
        assert np.linalg.norm(rounds[2] - rounds[1]) < 1e-6
        assert np.linalg.norm(rounds[1] - rounds[0]) < 1e-3


def test_two_planes_hold_four_equations() -> None:
    centre = BALLS[1]
    alpha, beta = own.extremes(centre)
    A = np.array([[-1, 0, alpha[0]], [1, 0, -alpha[1]], [0, -1, beta[0]], [0, 1, -beta[1]]])
    assert A.shape == (4, 3)
    assert np.linalg.matrix_rank(A) == 3
    assert np.linalg.matrix_rank(A[:2, [0, 2]]) == 2  # X_B and Z_B from (12) alone
