"""Savoure et al. 2006 on the Delta, sections I, II.B and II.C: every numbered equation and stated figure, decided.

Each test shows what the derivation gives and, where the printed form is wrong, that the printed form fails.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import qr

from tests.claims.identities import zero
from tests.claims.independent_savoure import (
    BASE,
    CONFIGURATIONS,
    DELTA,
    LENGTHS,
    NAMES,
    PLANAR,
    RODS,
    SCALE,
    SIGMA,
    THETA,
    Delta,
    P,
    Q,
    planar_sensitivity,
    rank,
)

# ------------------------------------------------------------------------------------ II.B: one rod of the Delta, exact


def hat(v: sp.Matrix) -> sp.Matrix:
    return sp.Matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def small_turn(v: sp.Matrix) -> sp.Matrix:
    """A rotation, exact about each axis in turn; the order does not matter to first order."""
    out = sp.eye(3)
    for k in range(3):
        c, s = sp.cos(v[k]), sp.sin(v[k])
        R = sp.eye(3)
        a, b = (k + 1) % 3, (k + 2) % 3
        R[a, a], R[a, b], R[b, a], R[b, b] = c, -s, s, c
        out = out * R
    return out


class Rod:
    """Eq. (2) of one rod with every error in it, and its differential at zero error."""

    x, dx = sp.Matrix(sp.symbols("x:3")), sp.Matrix(sp.symbols("dx:3"))
    b, db = sp.Matrix(sp.symbols("b:3")), sp.Matrix(sp.symbols("db:3"))
    a, da = sp.Matrix(sp.symbols("a:3")), sp.Matrix(sp.symbols("da:3"))
    p, dp = sp.Matrix(sp.symbols("p:3")), sp.Matrix(sp.symbols("dp:3"))
    alpha, beta = sp.Matrix(sp.symbols("alpha:3")), sp.Matrix(sp.symbols("beta:3"))
    l, dl, q, theta = sp.symbols("l dl q theta")

    P = sp.Matrix([[sp.cos(theta), -sp.sin(theta), 0], [sp.sin(theta), sp.cos(theta), 0], [0, 0, 1]])
    Q = sp.Matrix([[1, 0, 0], [0, sp.cos(q), -sp.sin(q)], [0, sp.sin(q), sp.cos(q)]])
    R = P * Q
    end_a = p + dp + small_turn(beta) * R * (a + da)
    end_b = x + dx + small_turn(alpha) * (b + db)
    closure = ((end_b - end_a).dot(end_b - end_a) - (l + dl) ** 2) / 2

    AB = x + b - p - R * a
    AP, BC = -R * a, -b

    @classmethod
    def at_zero(cls, expr: sp.Expr | sp.Matrix) -> sp.Expr | sp.Matrix:
        errors = (*cls.dx, *cls.db, *cls.da, *cls.dp, *cls.alpha, *cls.beta, cls.dl)
        return expr.subs(dict.fromkeys(errors, 0))

    @classmethod
    @cache
    def slope(cls, name: str) -> sp.Matrix:
        """Derivatives of the closure by one vector of errors, at zero error, as a row."""
        by = {"x": cls.dx, "b": cls.db, "a": cls.da, "p": cls.dp, "alpha": cls.alpha, "beta": cls.beta}[name]
        rod = cls.end_b - cls.end_a
        return sp.Matrix([[cls.at_zero(rod).dot(cls.at_zero(rod.diff(s))) for s in by]])


def test_eq_1() -> None:
    pose = DELTA.forward(DELTA.inverse(DELTA.positions(1)[0]), 0.1 * SCALE, np.r_[DELTA.positions(1)[0], np.zeros(3)])
    assert pose.shape == (6,)
    assert np.linalg.norm(pose[3:]) > 1e-6  # the platform does turn: a position alone would not describe it


def test_eq_2() -> None:
    """A and B of the nominal machine are a rod's length apart wherever the inverse position brings it."""
    for x in DELTA.positions(10):
        q = DELTA.inverse(x)
        for i, j in RODS:
            p, a, b = DELTA.nominal(i, j)
            assert np.linalg.norm(x + b - p - P(i) @ Q(q[i]) @ a) == pytest.approx(DELTA.rod, abs=1e-9)


def test_eq_3() -> None:
    """Errors taken for differentials: what is neglected is of second order."""
    x = DELTA.positions(1, seed=2)[0]
    q, start = DELTA.inverse(x), np.concatenate([x, np.zeros(3)])
    e = np.random.default_rng(0).standard_normal(51) * SCALE
    neglected = [DELTA.forward(q, t * e, start) - start - t * DELTA.sensitivity(x, q) @ e for t in (0.4, 0.2, 0.1)]
    size = [np.linalg.norm(n[:3]) for n in neglected]
    assert size[0] / size[1] == pytest.approx(4, rel=0.1)
    assert size[1] / size[2] == pytest.approx(4, rel=0.05)


def test_eq_4_and_5() -> None:
    AB, dAB = sp.Matrix(sp.symbols("u:3")), sp.Matrix(sp.symbols("du:3"))
    l, dl, t = sp.symbols("l dl t")
    line = ((AB + t * dAB).dot(AB + t * dAB) - (l + t * dl) ** 2) / 2  # half of eq. (2) along a small displacement
    assert zero(sp.diff(line, t).subs(t, 0) - (AB.dot(dAB) - l * dl))


def test_eq_6_and_7() -> None:
    r = Rod
    for k in range(3):
        assert zero(r.at_zero(r.end_b.diff(r.dx[k])) - sp.eye(3)[:, k])
        assert zero(r.at_zero(r.end_b.diff(r.alpha[k])) - hat(r.BC)[:, k])
        assert zero(r.at_zero(r.end_b.diff(r.db[k])) - sp.eye(3)[:, k])
    v, w = sp.Matrix(sp.symbols("v:3")), sp.Matrix(sp.symbols("w:3"))
    assert zero(hat(v) * w - v.cross(w))


def test_eq_8() -> None:
    r = Rod
    for k in range(3):
        assert zero(r.at_zero(r.end_a.diff(r.dp[k])) - sp.eye(3)[:, k])
        assert zero(r.at_zero(r.end_a.diff(r.da[k])) - r.R[:, k])
        assert zero(r.at_zero(r.end_a.diff(r.beta[k])) - hat(r.AP)[:, k])


def test_eq_9() -> None:
    """P Q carries the arm's coordinates to the base; the turn by q about u itself is P Q P^T."""
    r, u = Rod, Rod.P[:, 0]
    about_u = sp.eye(3) * sp.cos(r.q) + hat(u) * sp.sin(r.q) + u * u.T * (1 - sp.cos(r.q))
    assert zero(r.P * r.Q * r.P.T - about_u)
    assert not zero(r.R - about_u)
    assert zero(r.R.diff(r.q) * r.R.T - hat(u))  # either way it turns about u


def test_eq_10() -> None:
    r = Rod
    assert zero(r.P.T * r.P - sp.eye(3))
    assert zero(r.P[:, 0].cross(r.P[:, 1]) - r.P[:, 2])
    assert zero(r.P[:, 2] - sp.Matrix([0, 0, 1]))


def test_angles_of_the_actuators() -> None:
    """60, 180 and 300 degrees: a third of a turn apart, so that a turn of the machine by it permutes the limbs."""
    third = P(1) @ P(0).T
    assert np.allclose(np.trace(third), 1 + 2 * np.cos(2 * np.pi / 3))
    for i in range(3):
        assert np.allclose(third @ P(i), P((i + 1) % 3))
    assert np.allclose(np.rad2deg(THETA), (60, 180, 300))


def test_eq_11() -> None:
    r = Rod
    e = sp.Matrix([1, 0, 0])
    assert zero(r.Q * e - e)
    assert zero(r.Q.diff(r.q) * r.Q.T - hat(e))


def test_eq_12_and_14() -> None:
    """From eq. (5) the block of b' = b - p stands on the right with a minus; printed with a plus, twice."""
    r = Rod
    assert zero(r.slope("x") - r.AB.T)
    assert zero(r.slope("alpha") - r.AB.T * hat(r.BC))
    right = {"b": -r.AB.T, "a": r.AB.T * r.R, "beta": r.AB.T * hat(r.AP)}  # closure: left - right = 0
    for name, block in right.items():
        assert zero(r.slope(name) + block), name
    assert zero(r.at_zero(sp.diff(r.closure, r.dl)) + r.l)
    assert not zero(r.slope("b") + r.AB.T)  # the printed sign of the first block
    assert r.AB.T.shape[1] + r.R.shape[1] + 1 + 3 == 10


def test_printed_sign_of_eq_14_moves_the_tcp_the_wrong_way() -> None:
    x = DELTA.positions(1)[0]
    q, start = DELTA.inverse(x), np.concatenate([x, np.zeros(3)])
    J_X, J_kC = DELTA.matrices(x, q)
    for n in range(6):
        for k in range(7 * n, 7 * n + 3):
            e = np.zeros(51)
            e[k] = 1e-3
            moved = (DELTA.forward(q, e, start) - DELTA.forward(q, -e, start)) / 2e-3
            assert np.allclose(moved, np.linalg.solve(J_X, J_kC[:, k]), atol=1e-6)
            assert not np.allclose(moved, np.linalg.solve(J_X, -J_kC[:, k]), atol=1e-2)


def test_eq_13() -> None:
    """Only the difference b - p is seen of the two vectors."""
    assert zero(Rod.slope("b") + Rod.slope("p"))


def test_eq_15() -> None:
    r = Rod
    assert zero(r.slope("beta") + r.AB.T * hat(r.AP))


def test_dimensions() -> None:
    """Sizes of eqs. (16)-(20), (24): 6 rods of 7 errors and 3 joints of 3 make 51."""
    J_X, J_kC = DELTA.matrices(DELTA.positions(1)[0], DELTA.inverse(DELTA.positions(1)[0]))
    assert J_X.shape == (6, 6)
    assert J_kC.shape == (6, 51) == (6, len(NAMES))
    assert len(NAMES) == 6 * 7 + 3 * 3
    assert DELTA.global_sensitivity(9).reshape(-1, 51).shape == (54, 51)


def test_eq_17_to_22() -> None:
    """J_X^-1 J_kC against the exact machine, error by error."""
    for x in DELTA.positions(2, seed=4):
        q, start = DELTA.inverse(x), np.concatenate([x, np.zeros(3)])
        S = DELTA.sensitivity(x, q)
        for k, size in enumerate(SCALE):
            e = np.zeros(51)
            e[k] = 1e-3 * size
            moved = (DELTA.forward(q, e, start) - DELTA.forward(q, -e, start)) / 2e-3
            assert np.allclose(moved, S[:, k] * size, atol=1e-6), NAMES[k]


def test_eq_19_rows() -> None:
    """A rod's row holds its own seven columns and those of its joint; the last a-block ends at column 42."""
    _, J_kC = DELTA.matrices(DELTA.positions(1)[0], DELTA.inverse(DELTA.positions(1)[0]))
    for n, (i, _) in enumerate(RODS):
        own = {*range(7 * n, 7 * n + 7), *range(42 + 3 * i, 45 + 3 * i)}
        assert {int(k) for k in np.flatnonzero(J_kC[n])} <= own
        assert np.abs(J_kC[n, 7 * n : 7 * n + 7]).min() > 0


def test_eq_23_and_24() -> None:
    e = np.random.default_rng(1).standard_normal(51) * SCALE * 1e-3
    S_G, moved = [], []
    for x in DELTA.positions(9, seed=5):
        q, start = DELTA.inverse(x), np.concatenate([x, np.zeros(3)])
        S_G.append(DELTA.sensitivity(x, q))
        moved.append(DELTA.forward(q, e, start) - start)
    assert np.allclose(np.concatenate(S_G) @ e, np.concatenate(moved), atol=1e-7)


def test_relations_of_nine_poses() -> None:
    assert 8 * 6 < 51 <= 9 * 6


@pytest.mark.parametrize("machine", [Delta(), DELTA, Delta(platform=150.0, spacing=60.0, tool=(0, 0, 40))])
def test_the_complete_delta_has_42_identifiable_errors(machine: Delta) -> None:
    """Of 51: nine directions are unseen by full poses, however many; eight poses see all the others."""
    many = machine.global_sensitivity(60).reshape(-1, 51)
    unseen = np.array(list(machine.unseen_by_pose().values()))
    assert np.abs(many @ unseen.T).max() < 1e-9
    assert np.linalg.matrix_rank(unseen) == 9
    found, gap = rank(many, SCALE)
    assert found == 42
    assert gap > 1e6
    assert [rank(machine.global_sensitivity(m, seed=3).reshape(-1, 51), SCALE)[0] for m in (7, 8, 9)] == [39, 42, 42]


@pytest.mark.parametrize("machine", [Delta(), DELTA, Delta(platform=150.0, spacing=60.0, tool=(0, 0, 40))])
def test_position_or_orientation_alone(machine: Delta) -> None:
    """38 errors by position, 18 by orientation; every null direction in closed form."""
    S_G = machine.global_sensitivity(60)
    for rows, more, expected in (
        (slice(0, 3), machine.unseen_by_position(), 38),
        (slice(3, 6), machine.unseen_by_orientation(), 18),
    ):
        unseen = np.array([*machine.unseen_by_pose().values(), *more.values()])
        part = S_G[:, rows].reshape(-1, 51)
        assert np.abs(part @ unseen.T).max() < 1e-8
        assert np.linalg.matrix_rank(unseen / SCALE) == len(unseen) == 51 - expected
        found, gap = rank(part, SCALE)
        assert found == expected
        assert gap > 1e6


def base_of(matrix: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return kept columns, dropped columns and the combinations: dropped column = kept columns @ combination."""
    _, R, order = qr(matrix, mode="economic", pivoting=True)
    size = np.abs(np.diag(R))
    b = int((size > 1e-9 * size[0]).sum())
    return order[:b], order[b:], np.linalg.solve(R[:b, :b], R[:b, b:])


def test_eq_25() -> None:
    """Pivoted QR picks 42 columns that carry every prediction of the 51."""
    S_G = DELTA.global_sensitivity(40).reshape(-1, 51) * SCALE
    kept, dropped, combination = base_of(S_G)
    assert len(kept) == 42
    assert np.allclose(S_G[:, kept] @ combination, S_G[:, dropped], atol=1e-9)
    e = np.random.default_rng(3).standard_normal(51)
    assert np.allclose(S_G[:, kept] @ (e[kept] + combination @ e[dropped]), S_G @ e, atol=1e-8)


def test_eq_26() -> None:
    S_G = DELTA.global_sensitivity(40).reshape(-1, 51) * SCALE
    S_b = S_G[:, base_of(S_G)[0]]
    assert np.linalg.matrix_rank(S_b) == 42
    X = S_G @ np.random.default_rng(4).standard_normal(51) * 1e-2
    normal = np.linalg.solve(S_b.T @ S_b, S_b.T)
    assert np.allclose(normal, np.linalg.pinv(S_b), atol=1e-8)
    assert np.allclose(normal @ X, np.linalg.lstsq(S_b, X, rcond=None)[0], atol=1e-8)


def test_standard_deviations_follow_from_the_reduced_matrix() -> None:
    columns = [PLANAR.index(n) for n in BASE]
    S = np.array([planar_sensitivity(q, 100.0)[:, columns] / SIGMA[:, None] for q in CONFIGURATIONS]).reshape(-1, 6)
    predicted = np.sqrt(np.diag(np.linalg.inv(S.T @ S)))
    noise = np.random.default_rng(5).standard_normal((4000, len(S)))
    spread = (np.linalg.pinv(S) @ noise.T).std(axis=1)
    assert np.allclose(spread, predicted, rtol=0.05)


# -------------------------------------------------------------------------------------- II.C: compensation of the Delta


def compensated(errors: np.ndarray, known: np.ndarray, x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return joints by eqs. (29)-(33), the predicted error (6,) and the TCP's error after it (3,)."""
    q = DELTA.inverse(x)
    predicted = DELTA.sensitivity(x, q) @ known
    corrected = q - DELTA.joint_matrix(x, q) @ predicted[:3]
    reached = DELTA.forward(corrected, errors, np.concatenate([x, np.zeros(3)]))
    return corrected, predicted, reached[:3] - x


@pytest.fixture(scope="module")
def errors() -> np.ndarray:
    return np.random.default_rng(6).standard_normal(51) * SCALE


@pytest.mark.parametrize("base_only", [False, True], ids=["all errors", "base parameters"])
def test_eq_27_and_28(errors: np.ndarray, base_only: bool) -> None:
    """The exact inverse of the updated machine reaches the target; with base parameters, to second order."""
    x = DELTA.positions(1, seed=8)[0]
    remaining = []
    for t in (1.0, 0.5):
        known = t * errors
        if base_only:
            kept, dropped, combination = base_of(DELTA.global_sensitivity(40).reshape(-1, 51) * SCALE)
            scaled = known / SCALE
            known = np.zeros(51)
            known[kept] = (scaled[kept] + combination @ scaled[dropped]) * SCALE[kept]
        q = DELTA.inverse(x, known)
        remaining.append(np.linalg.norm(DELTA.forward(q, t * errors, np.concatenate([x, np.zeros(3)]))[:3] - x))
    if base_only:
        assert remaining[0] / remaining[1] == pytest.approx(4, rel=0.3)
    else:
        assert max(remaining) < 1e-6
    unmended = DELTA.forward(DELTA.inverse(x), errors, np.concatenate([x, np.zeros(3)]))[:3] - x
    assert np.linalg.norm(unmended) > 10 * remaining[0]  # k_C^b without a hat, the nominal values of (28)


def test_eq_29() -> None:
    for x in DELTA.positions(5, seed=9):
        pose = DELTA.forward(DELTA.inverse(x), np.zeros(51), np.concatenate([x + 3.0, np.full(3, 0.01)]))
        assert np.allclose(pose, np.concatenate([x, np.zeros(3)]), atol=1e-7)


def test_eq_30_and_31(errors: np.ndarray) -> None:
    """The identification model predicts what the TCP's three coordinates miss by, to second order."""
    x = DELTA.positions(1, seed=10)[0]
    start = np.concatenate([x, np.zeros(3)])
    missed = []
    for t in (0.2, 0.1):
        predicted = compensated(t * errors, t * errors, x)[1]
        missed.append(np.linalg.norm((DELTA.forward(DELTA.inverse(x), t * errors, start) - start - predicted)[:3]))
    assert missed[0] / missed[1] == pytest.approx(4, rel=0.1)


def test_eq_32() -> None:
    x = DELTA.positions(1, seed=11)[0]
    numeric = np.column_stack([(DELTA.inverse(x + d) - DELTA.inverse(x - d)) / 2e-3 for d in np.eye(3) * 1e-3])
    assert np.allclose(DELTA.joint_matrix(x, DELTA.inverse(x)), numeric, atol=1e-9)


def test_eq_33(errors: np.ndarray) -> None:
    """What the approximated inverse leaves is of second order; with a plus for the minus it would double the error."""
    x = DELTA.positions(1, seed=12)[0]
    start = np.concatenate([x, np.zeros(3)])
    left, before = [], []
    for t in (0.2, 0.1):
        left.append(np.linalg.norm(compensated(t * errors, t * errors, x)[2]))
        before.append(np.linalg.norm(DELTA.forward(DELTA.inverse(x), t * errors, start)[:3] - x))
    assert left[0] / left[1] == pytest.approx(4, rel=0.15)
    assert left[1] < 0.02 * before[1]
    wrong = np.linalg.norm(compensated(t * errors, -t * errors, x)[2])
    assert wrong == pytest.approx(2 * before[1], rel=0.05)


def test_table_1(errors: np.ndarray) -> None:
    """Forward and inverse relations undo each other; S_C has six rows, the simplified relations three."""
    x = DELTA.positions(1, seed=13)[0]
    q = DELTA.inverse(x)
    assert np.allclose(DELTA.forward(q, np.zeros(51), np.concatenate([x + 1, np.zeros(3)]))[:3], x, atol=1e-7)
    assert np.allclose(DELTA.forward(DELTA.inverse(x, errors), errors, np.r_[x, 0, 0, 0])[:3], x, atol=1e-6)
    numeric = np.column_stack(
        [(DELTA.forward(q + d, np.zeros(51), np.r_[x, 0, 0, 0]) - np.r_[x, 0, 0, 0])[:3] for d in np.eye(3) * 1e-6]
    )
    assert np.allclose(DELTA.joint_matrix(x, q) @ numeric / 1e-6, np.eye(3), atol=1e-4)
    assert DELTA.sensitivity(x, q).shape == (6, 51)


# ---------------------------------------------------------------------------------------- section I: what turns a plate


def test_equal_rods_do_not_keep_the_plate_parallel() -> None:
    """Rods of a pair of one length keep the plate parallel only if the joints are equally spaced at both ends."""
    x = DELTA.positions(1, seed=14)[0]
    q, start = DELTA.inverse(x), np.concatenate([x, np.zeros(3)])
    equal = np.zeros(51)
    for limb, size in enumerate((1.0, -2.0, 0.5)):
        equal[[NAMES.index(f"l_{limb + 1}1"), NAMES.index(f"l_{limb + 1}2")]] = size
    assert np.abs(DELTA.forward(q, equal, start)[3:]).max() < 1e-12
    equal[NAMES.index("ax_11")] = 1.0  # one elbow joint 1 mm further out along the axis, every rod of a pair alike
    assert np.abs(DELTA.forward(q, equal, start)[3:]).max() > 1e-3


def test_errors_of_rods_grow_with_the_tool() -> None:
    """What the plate's turn adds at the tool is in proportion to the tool; beside it stands a shift that is not."""
    e = np.zeros(51)
    e[NAMES.index("l_11")], e[NAMES.index("l_12")] = 0.1, -0.1
    poses = []
    for h in LENGTHS:
        machine = Delta(tool=(0.0, 0.0, -h))
        x = np.array([100.0, -50.0, -900.0 - h])
        poses.append(machine.forward(machine.inverse(x), e, np.r_[x, 0, 0, 0]) - np.r_[x, 0, 0, 0])
    added = [pose[:3] - poses[0][:3] for pose in poses]
    assert np.linalg.norm(added[1]) > 0.1
    assert np.allclose(added[2], 2 * added[1], rtol=1e-6)
    assert np.allclose(added[1], np.cross(poses[0][3:], [0.0, 0.0, -100.0]), atol=1e-3)
    assert np.linalg.norm(poses[1][:3]) < np.linalg.norm(poses[0][:3])  # here the whole error is least near h = 100
