"""Identification and measured positions of Mei et al. 2018, sections 4 and 5, decided."""

from __future__ import annotations

from itertools import permutations

import numpy as np
import pytest
import sympy as sp

from tests.claims import independent_mei as mei
from tests.claims.simulated_mei import GROUPS, SIX, STOP, condition, noise_free

# ------------------------------------------------------------------------------------------- section 4: identification


def test_mechanism_vectors() -> None:
    """Eqs. (14) to (19): the actual vector is lambda + dr - dr_M exactly; its length changes along the unit vector."""
    r, dr, c, dc, d, dd = (sp.Matrix(sp.symbols(f"{n}x {n}y", real=True)) for n in ("r", "dr", "c", "dc", "d", "dd"))
    nominal, actual = r - c - d, (r + dr) - (c + dc) - (d + dd)
    assert sp.expand(actual - (nominal + dr - (dc + dd))) == sp.zeros(2, 1)
    step = sp.Symbol("step", positive=True)
    along = (nominal + step * (dr - dc - dd)).norm()
    unit = nominal / nominal.norm()
    assert sp.simplify(along.diff(step).subs(step, 0) - unit.dot(dr - dc - dd)) == 0  # eq. (19)


def lengths(p: mei.Array, robot: mei.Robot, mounted: mei.Array) -> mei.Array:
    return np.asarray(np.linalg.norm(mei.forward(mei.inverse(p), robot) - mei.MECHANISM - mounted, axis=-1))


def test_identification_matrices() -> None:
    """Eqs. (20) to (24) and (28): rows against differences of exact lengths, all 12 columns and the 4."""
    h = 1e-4
    columns = []
    for i in range(2):
        for name, axis in (("zero", None), ("base", 0), ("base", 1), ("proximal", None), ("distal", None)):
            error = np.zeros((2, 2) if name == "base" else 2)
            error[(i, axis) if name == "base" else i] = h / (mei.L if name == "zero" else 1)
            ends = [lengths(SIX, mei.Robot(**{name: s * error}), np.zeros(2)) for s in (1, -1)]
            columns.append((ends[0] - ends[1]) / (2 * h))
    for axis in np.eye(2):
        columns.append((lengths(SIX, mei.NOMINAL, h * axis) - lengths(SIX, mei.NOMINAL, -h * axis)) / (2 * h))
    exact = np.diff(np.stack(columns, -1), axis=0)
    assert np.allclose(mei.identification_matrix(SIX, complete=True), exact, atol=1e-6)
    assert np.allclose(mei.identification_matrix(SIX), exact[:, [0, 5, 10, 11]], atol=1e-6)


def scattered(count: int) -> mei.Array:
    rng = np.random.default_rng(count)
    low, high = (-mei.WIDTH / 2, -mei.TOP - mei.HEIGHT), (mei.WIDTH / 2, -mei.TOP)
    return rng.uniform(low, high, (count, 2))


def test_rank_of_twelve_columns() -> None:
    """The rank is 9 at most: moving robot and mechanism together does not show, nor does turning them."""
    p = scattered(40)
    shift, turn = np.array([3.0, -2.0]), 0.01
    before = lengths(p, mei.NOMINAL, np.zeros(2))
    assert np.allclose(lengths(p, mei.Robot(base=np.tile(shift, (2, 1))), shift), before, atol=1e-9)
    c, d = np.array([0.0, -79.0]), np.array([0.0, -51.0])
    about = np.array([[np.cos(turn), -np.sin(turn)], [np.sin(turn), np.cos(turn)]])
    centres = mei.centres(mei.NOMINAL)
    turned = mei.Robot(zero=np.full(2, turn), base=(centres - c) @ about.T + c - centres)
    assert np.allclose(lengths(p, turned, about @ d - d), before, atol=1e-9)
    for count in (13, 40, 200):
        s = np.linalg.svd(mei.identification_matrix(scattered(count), complete=True), compute_uv=False)
        assert s[8] / s[0] > 1e-6
        assert s[9] / s[0] < 1e-12


def test_least_squares_of_twelve_columns() -> None:
    """Eqs. (25) and (27): the normal matrix is singular, sigma_10 to sigma_12 are zero."""
    G = mei.identification_matrix(scattered(40), complete=True)
    scaled = G / np.linalg.norm(G, axis=0)
    values = np.linalg.eigvalsh(scaled.T @ scaled)
    assert np.all(np.abs(values[:3]) < 1e-12 * values[-1])
    assert np.linalg.matrix_rank(G) == 9


def test_svd_of_twelve_columns() -> None:
    """Eq. (26): dimensions and product."""
    G = mei.identification_matrix(scattered(40), complete=True)
    U, s, Vt = np.linalg.svd(G)
    assert U.shape == (39, 39)
    assert Vt.shape == (12, 12)
    assert np.allclose(U[:, :12] * s @ Vt, G)


def test_rank_of_four_columns() -> None:
    """Five positions in general are enough for rank 4, and four never are (four positions, three differences)."""
    assert np.linalg.matrix_rank(mei.identification_matrix(SIX)) == 4
    for count in (5, 6, 12):
        assert np.linalg.matrix_rank(mei.identification_matrix(scattered(count))) == 4
    assert np.linalg.matrix_rank(mei.identification_matrix(mei.positions(2))) == 3


def test_rank_needs_more_than_directions_that_differ() -> None:
    """One pair left and right of the axis and any number on the axis: directions differ, the rank is 3."""
    axis = np.column_stack([np.zeros(9), np.linspace(-640, -780, 9)])
    p = np.vstack([axis, [(-200.0, -700.0), (200.0, -700.0)]])
    assert np.ptp(np.arctan2(*(p - mei.MECHANISM).T)) > 0.1  # not collinear
    s = np.linalg.svd(mei.identification_matrix(p), compute_uv=False)
    assert s[3] < 1e-12 * s[0] < s[2]


def test_eq_29() -> None:
    """Four terms of four: least squares, no truncation; and not what truncating the 12 columns at four terms gives."""
    rng = np.random.default_rng(0)
    G, gap = mei.identification_matrix(SIX), rng.standard_normal(5)
    U, s, Vt = np.linalg.svd(G, full_matrices=False)
    sum_of_terms = sum((U[:, i] @ gap) / s[i] * Vt[i] for i in range(4))
    assert np.allclose(sum_of_terms, np.linalg.lstsq(G, gap, rcond=None)[0], rtol=1e-9)
    p = scattered(40)
    gap = np.diff(lengths(p, mei.group(1), mei.MOUNTED) - lengths(p, mei.NOMINAL, np.zeros(2)))
    U, s, Vt = np.linalg.svd(mei.identification_matrix(p, complete=True), full_matrices=False)
    truncated = Vt[:4].T @ (U.T[:4] @ gap / s[:4])
    reduced = np.linalg.lstsq(mei.identification_matrix(p), gap, rcond=None)[0]
    assert np.degrees(abs(truncated[0] - reduced[0]) / mei.L) > 0.1


def test_unknowns_of_eq_28_are_one_column() -> None:
    """(dq dr_M)^T as printed is two by two; G has four columns, and takes the two stacked, as in (21)."""
    offsets, mounting, G = mei.L * np.radians([2.0, -1.0]), mei.MOUNTED, mei.identification_matrix(SIX)
    assert np.column_stack([offsets, mounting]).T.shape == (2, 2)
    assert G.shape[1] == len(np.concatenate([offsets, mounting])) == 4
    seen = np.diff(
        lengths(SIX, mei.Robot(zero=np.radians([2e-4, -1e-4])), 1e-4 * mounting)
        - lengths(SIX, mei.NOMINAL, 0 * mounting)
    )
    assert np.allclose(G @ np.concatenate([1e-4 * offsets, 1e-4 * mounting]), seen, atol=1e-7)


def test_order_of_the_differences() -> None:
    """Differences k less k + 1 with the matrix of (23), k + 1 less k, give the offsets with the other sign."""
    gap = np.diff(lengths(SIX, mei.group(4), mei.MOUNTED) - lengths(SIX, mei.NOMINAL, np.zeros(2)))
    G = mei.identification_matrix(SIX)
    right, turned = (np.degrees(np.linalg.lstsq(G, s * gap, rcond=None)[0][:2] / mei.L) for s in (1, -1))
    assert right == pytest.approx([2.0, -1.0], abs=0.2)  # one step of the iteration
    assert turned == pytest.approx([-2.0, 1.0], abs=0.2)


def test_neglected_geometry_costs_little() -> None:
    """Neglecting 0.03 mm of geometry leaves 0.007 deg, 0.09 mm at home; a tenth of it leaves a tenth."""
    for number, angle, home in ((1, 0.00696, 0.0912), (4, 0.000697, 0.00912)):
        error = noise_free(number).compensated[0, -1] - mei.group(number).zero
        assert np.degrees(np.abs(error).max()) == pytest.approx(angle, rel=5e-3)
        assert mei.home_error(mei.group(number), noise_free(number).compensated[0, -1]) == pytest.approx(home, rel=5e-3)


def test_smaller_mechanism_error_is_not_better() -> None:
    """The condition number falls with +dr_My and rises with -dr_My: what counts is the sign, not the size."""
    found = [condition(mei.identification_matrix(SIX, shift=-k * mei.MOUNTED)) for k in (-2, -1, 0, 1, 2)]
    assert np.allclose(found, [481.46, 478.38, 475.34, 472.35, 469.40], atol=0.01)


def test_eq_30() -> None:
    """f must lose the identified dr_M: with the printed plus the mechanism's error doubles every round."""
    nominal = SIX - mei.MECHANISM
    read = lengths(SIX, mei.NOMINAL, mei.MOUNTED)  # a perfect robot, read by the mechanism as mounted
    assert np.allclose(np.linalg.norm(nominal - mei.MOUNTED, axis=-1), read, atol=1e-9)
    assert np.abs(np.linalg.norm(nominal + mei.MOUNTED, axis=-1) - read).max() > 1.5
    robot = mei.group(4)
    right = mei.procedure(robot, mei.MOUNTED, 6, None)
    printed = mei.procedure(robot, mei.MOUNTED, 6, None, sign=1.0)
    assert np.allclose(right.mechanism[0, -1], mei.MOUNTED, atol=1e-3)
    steps = np.linalg.norm(np.diff(printed.mechanism[0], axis=0), axis=-1)
    assert np.all(steps[1:] > 1.8 * steps[:-1])
    assert np.degrees(np.abs(printed.compensated[0, -1] - robot.zero).max()) > 1


# -------------------------------------------------------------------------- section 5 and figures 7 and 8: positions


def test_boundary_positions_inform_most() -> None:
    centre = SIX.mean(axis=0)
    found = [condition(mei.identification_matrix(centre + k * (SIX - centre))) for k in (1.0, 0.75, 0.5, 0.25)]
    assert np.allclose(found, [475.34, 932.26, 2201.7, 6946.6], rtol=1e-4)


def test_order_of_the_six_positions() -> None:
    """The condition number of differences depends on the order: 144.65 to 975.93; only one order gives 475.34."""
    rows = mei.gauge_rows(SIX, SIX - mei.MECHANISM)
    found = {order: condition(np.diff(rows[list(order)], axis=0)) for order in permutations(range(6))}
    assert min(found.values()) == pytest.approx(144.65, abs=0.01)
    assert max(found.values()) == pytest.approx(975.93, abs=0.01)
    alike = {(0, 1, 2, 3, 4, 5), (2, 1, 0, 5, 4, 3), (3, 4, 5, 0, 1, 2), (5, 4, 3, 2, 1, 0)}
    assert {order for order, value in found.items() if abs(value - 475.34) < 5e-3} == alike


def test_condition_numbers_of_fig_8() -> None:
    """kappa_1 as printed; kappa_m with dr_M = (1, 0.5) taken off is 472.35 (printed 472.54), put on 478.38."""
    assert condition(mei.identification_matrix(SIX)) == pytest.approx(475.34, abs=5e-3)
    assert condition(mei.identification_matrix(SIX, shift=-mei.MOUNTED)) == pytest.approx(472.35, abs=5e-3)
    assert condition(mei.identification_matrix(SIX, shift=mei.MOUNTED)) == pytest.approx(478.38, abs=5e-3)
    second = [noise_free(number).condition[0, 1] for number in GROUPS]
    assert np.allclose(second, [472.53, 472.34, 472.35, 472.54, 472.36, 472.37], atol=0.01)


def test_the_same_mechanism_error_in_every_round() -> None:
    """By (30), with its sign set right, f moves in every round by what the last one found, and the first counts."""
    found = [condition(mei.identification_matrix(SIX, shift=-rounds * mei.MOUNTED)) for rounds in range(5)]
    assert np.allclose(found, [475.34, 472.35, 469.39, 466.48, 463.60], atol=0.01)
    done = noise_free(4)
    change = np.diff(done.mechanism[0], axis=0)
    assert np.linalg.norm(done.mechanism[0, 0] - mei.MOUNTED) < 0.4  # the first round finds most of it
    assert np.linalg.norm(change[2:], axis=1).max() < 1e-3  # and the later ones what it missed
    assert condition(mei.identification_matrix(SIX, shift=-done.mechanism[0, -1])) == pytest.approx(found[1], abs=0.01)


def test_condition_number_over_n() -> None:
    """It falls from n = 3 to 4 and rises only from there; kappa_m < kappa_1 with the right sign, > with the printed."""
    n = range(3, 12)
    first, right, printed = (
        np.array([condition(mei.identification_matrix(mei.positions(k), shift=s)) for k in n])
        for s in (None, -mei.MOUNTED, mei.MOUNTED)
    )
    assert first[1] == pytest.approx(457.81, abs=0.01)
    assert first[1] < first[0]
    assert right[1] == pytest.approx(456.64, abs=0.01)
    assert right[1] < right[0]
    assert np.all(np.diff(first[1:]) > 0)
    assert np.all(right < first)
    assert np.all(printed > first)


def test_eq_31() -> None:
    """n = 3 is the least n with rank 4, and the threshold holds with the paper's figures and with ours."""
    assert abs(475.34 - 472.54) / 475.34 < 0.01
    assert abs(475.34 - 472.35) / 475.34 < 0.01
    assert np.linalg.matrix_rank(mei.identification_matrix(mei.positions(2))) < 4


def test_compensation_rule() -> None:
    """Eqs. (32) and (33): without noise mu goes to zero and the sum of the steps is the set offset, less the bias."""
    for number in GROUPS:
        done = noise_free(number)
        steps = np.diff(done.compensated[0], axis=0)
        mu = np.sqrt(np.mean(np.diff(steps, axis=0) ** 2, axis=-1))
        assert mu[-1] < 1e-6 < STOP < mu[0]
        assert np.degrees(np.abs(steps.sum(axis=0) - mei.group(number).zero).max()) < 0.0071
        assert done.stopped(STOP)[0] in (3, 4)
