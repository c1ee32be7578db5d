"""Savoure, Maurine, Corbel, Krut 2006: every numbered equation and stated figure, decided.

Each test shows what the derivation gives and, where the printed form is wrong, that the printed form fails.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import qr

from tests.claims.independent_savoure import (
    BASE,
    CHECK,
    CONFIGURATIONS,
    DEG,
    ERRORS,
    NAMES,
    NOMINAL,
    PLANAR,
    RODS,
    SCALE,
    SIGMA,
    THETA,
    Delta,
    P,
    Q,
    Study,
    planar_closed_form,
    planar_inverse,
    planar_matrices,
    planar_pose,
    planar_sensitivity,
    rank,
    study,
)

DELTA = Delta(tool=(30.0, 20.0, -100.0))
LENGTHS = (0.0, 100.0, 200.0)


def zero(expr: sp.Expr | sp.Matrix) -> bool:
    """Whether a polynomial in sines and cosines vanishes identically: sin^2 = 1 - cos^2 leaves a normal form."""

    def even(base: sp.Expr, power: sp.Expr) -> sp.Expr:
        if not (isinstance(base, sp.sin) and power.is_Integer and power > 1):
            return base**power
        return (1 - sp.cos(base.args[0]) ** 2) ** (power // 2) * base ** (power % 2)

    return all(sp.expand(sp.expand(sp.expand_trig(e)).replace(sp.Pow, even)) == 0 for e in sp.Matrix([expr]))


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


# -------------------------------------------------------------------------------------- III.A: the planar parallelogram

q, q0, l, h, x = sp.symbols("q q0 l h x", positive=True)
a1x, a2x, b1x, b2x, l1, l2 = sp.symbols("a1x a2x b1x b2x l1 l2", positive=True)
a2y, b2y, alpha, phi = sp.symbols("a2y b2y alpha phi", real=True)
E, E_, F, G, I, gamma_p = sp.symbols("E E_ F G I gamma_p", real=True)
Rp = sp.Matrix([[sp.cos(alpha), -sp.sin(alpha)], [sp.sin(alpha), sp.cos(alpha)]])
A1, A2 = sp.Matrix([-a1x, 0]), sp.Matrix([a2x, a2y])
OB1, OB2, OC = Rp * sp.Matrix([-b1x, 0]), Rp * sp.Matrix([b2x, b2y]), Rp * sp.Matrix([0, -h])
ROD_1 = l1 * sp.Matrix([sp.sin(q + q0), -sp.cos(q + q0)])
ROD_2 = l2 * sp.Matrix([sp.sin(phi), -sp.cos(phi)])
LETTERS = {
    E: (l1 * sp.sin(q + q0) - (a1x + a2x)) / l2,
    E_: (l1 * sp.cos(q + q0) + a2y) / l2,
    F: (b1x + b2x) / l2,
    G: -b2y / l2,
}
PRINTED_G = (h - b2y) / l2
SOME = {q0: 0.02, a1x: 126, a2x: 124, a2y: 30, b1x: 123, b2x: 125, b2y: -40, l1: 951, l2: 948, h: 80}


def numbers(values: dict[sp.Symbol, float]) -> np.ndarray:
    return np.array([float(values[s]) for s in (q0, a1x, a2x, a2y, b1x, b2x, b2y, l1, l2)])


def solved(at: float) -> dict[sp.Symbol, float]:
    """Return the angles of an irregular machine at a joint angle, from Newton's method."""
    k = numbers(SOME)
    turned = planar_pose(at, k, SOME[h])[2]
    values = {**SOME, q: at, alpha: turned}
    rod = (A1 + ROD_1 - OB1 + OB2 - A2).subs(values)
    return {**values, phi: float(sp.atan2(rod[0], -rod[1])), gamma_p: float(np.arctan2(k[6], k[4] + k[5]))}


def test_eq_34_and_35() -> None:
    bar = l * sp.Matrix([sp.sin(q + q0), -sp.cos(q + q0)])
    assert zero(bar[0] - l * sp.sin(q + q0))
    angle = sp.asin(x / l) - q0
    assert zero(bar[0].subs(q, angle) - x)
    for value in (-0.7, 0.3, 0.7):
        assert np.arcsin(np.sin(value + 0.1)) - 0.1 == pytest.approx(value)


def test_eq_36_and_37() -> None:
    forward = sp.diff(l * sp.sin(q + q0), q)
    assert zero(forward - l * sp.cos(q + q0))
    assert zero(forward / (l * sp.cos(q + q0)) - 1)
    inverse = sp.diff(sp.asin(x / l) - q0, x).subs(x, l * sp.sin(q + q0))
    at = {l: 950.0, q: 0.4, q0: 0.1}
    assert float(inverse.subs(at)) == pytest.approx(float((1 / (l * sp.cos(q + q0))).subs(at)))


def test_eq_38() -> None:
    row = sp.Matrix([l * sp.sin(q + q0)]).jacobian([q0, l])
    assert zero(row - sp.Matrix([[l * sp.cos(q + q0), sp.sin(q + q0)]]))


def test_eq_39_and_40() -> None:
    """Nine entries, ten with h; q enters only beside q0, so a derivative by their sum is one by q0."""
    assert len(PLANAR) == 9
    moves = ROD_1.free_symbols - {q}
    assert q0 in moves
    assert zero(ROD_1.diff(q) - ROD_1.diff(q0))
    everything = (A1 + ROD_1 - OB1 + OB2 - A2 + OC).free_symbols - {q, alpha}
    assert everything | {l2} == {q0, a1x, a2x, a2y, b1x, b2x, b2y, l1, l2, h}
    assert len(everything | {l2}) == 10


def test_eq_41() -> None:
    """The position is a function of q and the geometry: q0 alone does not fix it unless q is counted into k_C."""
    k = NOMINAL + ERRORS
    assert planar_pose(0.1, k, 100.0)[0] != pytest.approx(planar_pose(0.2, k, 100.0)[0])
    shifted = k + np.array([0.1, *np.zeros(8)])
    assert planar_pose(0.1, shifted, 100.0)[0] == pytest.approx(planar_pose(0.2, k, 100.0)[0])


def test_eq_42_and_43() -> None:
    """Both ways round the loop lead to C."""
    for at in (-0.5, 0.1, 0.7):
        values = solved(at)
        C = planar_pose(at, numbers(SOME), SOME[h])[:2]
        for way in (A1 + ROD_1 - OB1 + OC, A2 + ROD_2 - OB2 + OC):
            assert np.allclose(np.array(way.subs(values), dtype=float).ravel(), C, atol=1e-6)


def test_eq_44_to_47() -> None:
    """Eq. (42) minus (43) on both axes, with A1B1 = l1 (sin, -cos): the mechanism hangs."""
    difference = (A1 + ROD_1 - OB1 + OC) - (A2 + ROD_2 - OB2 + OC)
    right_44 = (E + F * sp.cos(alpha) + G * sp.sin(alpha)).subs(LETTERS)
    right_45 = (E_ + G * sp.cos(alpha) - F * sp.sin(alpha)).subs(LETTERS)
    assert zero(difference[0] / l2 - (right_44 - sp.sin(phi)))
    assert zero(-difference[1] / l2 - (right_45 - sp.cos(phi)))


def test_rods_hang() -> None:
    """Only A1B1 = l1 (sin, -cos) gives eqs. (45)-(47): the angle is counted from -y_b."""
    standing = sp.diag(1, -1)
    difference = (A1 + standing * ROD_1 - OB1) - (A2 + standing * ROD_2 - OB2)
    right_45 = (E_ + G * sp.cos(alpha) - F * sp.sin(alpha)).subs(LETTERS)
    assert not zero(difference[1] / l2 - (right_45 - sp.cos(phi)))


def test_eq_48() -> None:
    """The tool drops out of the difference of (42) and (43): G = -b2y / l2; with h the closure is missed."""
    difference = ((A1 + ROD_1 - OB1 + OC) - (A2 + ROD_2 - OB2 + OC)).subs(ROD_2[0], 0)
    assert h not in difference.expand().free_symbols
    values = solved(0.3)
    sine = (E + F * sp.cos(alpha) + G * sp.sin(alpha)).subs(LETTERS)
    printed = (E + F * sp.cos(alpha) + PRINTED_G * sp.sin(alpha)).subs(LETTERS)
    assert float(sine.subs(values)) == pytest.approx(float(sp.sin(values[phi])), abs=1e-9)
    assert abs(float(printed.subs(values)) - float(sp.sin(values[phi]))) > 1e-3
    assert zero(LETTERS[F] - (b1x + b2x) / l2)


def test_eq_49() -> None:
    """The cosine law in A2B2B1: interior angle of B2A2 and B2B1; A1B2 is no side, and A2B2 gives the other sign."""
    values = solved(0.3)
    at = {n: np.array(v.subs(values), dtype=float).ravel() for n, v in (("A1", A1), ("A2", A2), ("B1", A1 + ROD_1))}
    at["B2"] = at["B1"] + np.array((OB2 - OB1).subs(values), dtype=float).ravel()

    def side(m: str, n: str) -> np.ndarray:
        return at[n] - at[m]

    def cosine(u: np.ndarray, v: np.ndarray) -> float:
        return float(u @ v / np.linalg.norm(u) / np.linalg.norm(v))

    def law(one: float, other: float, cos: float) -> float:
        return one**2 + other**2 - 2 * one * other * cos

    lengths = {n: float(np.linalg.norm(side(*n))) for n in (("A1", "A2"), ("A1", "B1"), ("A2", "B2"), ("B2", "B1"))}
    left = law(lengths["A1", "A2"], lengths["A1", "B1"], cosine(side("A1", "A2"), side("A1", "B1")))
    two, hand = lengths["A2", "B2"], lengths["B2", "B1"]
    assert left == pytest.approx(law(two, hand, cosine(side("B2", "A2"), side("B2", "B1"))), rel=1e-9)
    for wrong in (side("A1", "B2"), side("A2", "B2")):
        assert abs(left - law(two, hand, cosine(wrong, side("B2", "B1")))) > 1e4


def I_of(G_value: sp.Expr, sign: int, angle: sp.Expr) -> sp.Expr:
    """Eq. (51) with a value of G, the sign of its term and the joint angle it takes."""
    l_b, l_p = sp.sqrt((a1x + a2x) ** 2 + a2y**2), sp.sqrt((b1x + b2x) ** 2 + b2y**2)
    gamma_b, gamma = sp.atan2(a2y, a1x + a2x), sp.atan2(b2y, b1x + b2x)
    first = (l_b**2 - l_p**2 + l1**2 - l2**2 + 2 * l_b * l1 * sp.sin(gamma_b - angle)) / (2 * l_p * l2)
    return first + LETTERS[F] * sp.cos(gamma) + sign * G_value * sp.sin(gamma)


def test_eq_50() -> None:
    """sin phi and cos phi of (44), (45) projected on B1B2: the angle alpha + gamma_p only turns E and E'."""
    psi = alpha + gamma_p
    merged = (E + F * sp.cos(alpha) + G * sp.sin(alpha)) * sp.cos(psi)
    merged -= (E_ + G * sp.cos(alpha) - F * sp.sin(alpha)) * sp.sin(psi)
    left = E_ * sp.sin(psi) - E * sp.cos(psi)
    assert zero(merged + left - (F * sp.cos(gamma_p) - G * sp.sin(gamma_p)))
    for at in (-0.5, 0.3):
        values = solved(at)
        value = left.subs(LETTERS).subs(values)
        assert float(value) == pytest.approx(float(I_of(LETTERS[G], -1, q + q0).subs(values)), abs=1e-9)


def test_eq_51() -> None:
    """The term of G is subtracted, and the angle is q + q0."""
    for at in (-0.5, 0.3):
        values = solved(at)
        left = float((E_ * sp.sin(alpha + gamma_p) - E * sp.cos(alpha + gamma_p)).subs(LETTERS).subs(values))
        assert float(I_of(LETTERS[G], -1, q + q0).subs(values)) == pytest.approx(left, abs=1e-9)
        for value in (LETTERS[G], PRINTED_G):
            for angle in (q, q + q0):
                assert abs(float(I_of(value, +1, angle).subs(values)) - left) > 1e-4
        assert abs(float(I_of(LETTERS[G], -1, q).subs(values)) - left) > 1e-4


def test_gamma_p_is_an_angle_of_the_platform() -> None:
    """B1B2 stands at alpha + gamma_p in the base, so gamma_p is counted from x_p: from x_b it would not be constant."""
    seen = []
    for at in (-0.5, 0.3):
        values = solved(at)
        hand = np.array((OB2 - OB1).subs(values), dtype=float).ravel()
        seen.append(np.arctan2(hand[1], hand[0]))
        assert seen[-1] == pytest.approx(values[alpha] + values[gamma_p], abs=1e-9)
    assert abs(seen[0] - seen[1]) > 1e-3


def test_eq_52() -> None:
    """The parallelogram is the branch (E'I + ED) / (E'D - EI), less gamma_p; the printed form gives another angle."""
    for at in (-0.5, 0.3):
        values = solved(at)
        e, e_ = (float(LETTERS[s].subs(values)) for s in (E, E_))
        i = float(I_of(LETTERS[G], -1, q + q0).subs(values))
        D = np.sqrt(e**2 + e_**2 - i**2)
        correct = np.arctan2(e_ * i + e * D, e_ * D - e * i) - values[gamma_p]
        assert correct == pytest.approx(values[alpha], abs=1e-9)
        gamma_b = float(np.arctan2(SOME[a2y], SOME[a1x] + SOME[a2x]))
        other = np.arctan2(e_ * i - e * D, -e_ * D - e * i)  # the crossed assembly
        printed = np.arctan((e_ * i - e * D) / (e * i + e_ * D))
        for less in (gamma_b, values[gamma_p]):
            for target in (values[alpha], other - values[gamma_p]):
                assert abs((printed - less - target + np.pi / 2) % np.pi - np.pi / 2) > 1e-3
        assert abs(correct + values[gamma_p] - gamma_b - values[alpha]) > 1e-3  # gamma_b in place of gamma_p


def test_eq_52_of_the_nominal_machine() -> None:
    """At Table 2's nominal values alpha must be 0 for every q; the printed form gives -2 arctan(E / E')."""
    for at in (-0.6, 0.4):
        e = (950 * np.sin(at) - 250) / 950
        e_, i = np.cos(at), -e  # I = -sin q + 250 / 950
        D = np.sqrt(e**2 + e_**2 - i**2)
        assert np.arctan2(e_ * i + e * D, e_ * D - e * i) == pytest.approx(0, abs=1e-12)
        printed = np.arctan((e_ * i - e * D) / (e * i + e_ * D))
        assert abs(np.sin(printed + 2 * np.arctan(e / e_))) < 1e-12
        assert abs(printed) > 0.2


def test_closed_form_is_newtons() -> None:
    for tool in LENGTHS:
        for at in CONFIGURATIONS:
            for k in (NOMINAL, NOMINAL + ERRORS, numbers(SOME)):
                assert np.allclose(planar_closed_form(at, k, tool), planar_pose(at, k, tool), atol=1e-9)


def test_eq_53_and_54() -> None:
    k, e = NOMINAL + ERRORS, 1e-5
    for at in (-0.5, 0.4):
        here = planar_closed_form(at, k, 200.0)[0]
        J_m = (planar_inverse(here + e, k, 200.0) - planar_inverse(here - e, k, 200.0)) / (2 * e)
        J = (planar_closed_form(at + e, k, 200.0)[0] - planar_closed_form(at - e, k, 200.0)[0]) / (2 * e)
        assert 1 / J_m == pytest.approx(J, rel=1e-6)


def planar_moves() -> tuple[sp.Matrix, sp.Matrix, list[sp.Symbol]]:
    """Return A1, B1 as functions of every error, and the errors, for a machine that is not nominal."""
    B1 = A1 + ROD_1
    return A1, B1, [q0, a1x, a2x, a2y, b1x, b2x, b2y, l1, l2]


def test_eq_55_and_56() -> None:
    """v1.(dB1 - dA1) = l1 dq0; without dA1, as printed, an error of a1x would turn the rod."""
    here, there, every = planar_moves()
    v1 = sp.Matrix([sp.cos(q + q0), sp.sin(q + q0)])
    for error in every:
        moved = v1.dot(there.diff(error) - here.diff(error))
        assert zero(moved - (l1 if error == q0 else 0)), error
    assert not zero(v1.dot(there.diff(a1x)))  # the printed third line says that this is zero


def test_two_rods_do_not_hold_the_plate() -> None:
    J_X, _ = planar_matrices(0.3, 100.0)
    assert np.linalg.matrix_rank(J_X[:2]) == 2 < 3
    assert np.linalg.matrix_rank(J_X) == 3
    J_X, _ = DELTA.matrices(DELTA.positions(1)[0], DELTA.inverse(DELTA.positions(1)[0]))
    assert np.linalg.matrix_rank(J_X) == 6  # the Delta needs no extra relation


def test_eq_57_and_58() -> None:
    """B_i = C + (B_i in the platform): the turn enters by the planar cross product of B_iC."""
    for point in (sp.Matrix([-b1x, 0]), sp.Matrix([b2x, b2y])):
        from_C = Rp * (point - sp.Matrix([0, -h]))
        BC = -from_C.subs(alpha, 0)
        assert zero(from_C.diff(alpha).subs(alpha, 0) - sp.Matrix([BC[1], -BC[0]]))
    assert not A1.free_symbols & {q, alpha}
    assert not A2.free_symbols & {q, alpha}


def test_eq_59_to_62() -> None:
    k = NOMINAL
    assert k[7] == k[8] == 950.0
    assert (k[1] + k[2], k[3]) == (k[4] + k[5], k[6])  # base and platform alike: a parallelogram
    for at in CONFIGURATIONS:
        pose = planar_pose(at, k, 100.0)
        assert pose[2] == pytest.approx(0, abs=1e-12)
        u = np.array([np.sin(at), -np.cos(at)])
        centre = pose[:2] + np.array([0.0, 100.0])
        assert np.allclose(centre - np.array([k[4] - k[1], 0.0]), 950.0 * u, atol=1e-9)
        assert np.allclose(centre + k[5:7] - k[2:4], 950.0 * u, atol=1e-9)
        v = np.array([-u[1], u[0]])
        assert v @ u == pytest.approx(0)
        assert v @ v == pytest.approx(1)


def exact_slopes(at: float, tool: float, k: np.ndarray = NOMINAL) -> np.ndarray:
    """Return the derivatives of the exact pose by the nine errors, (3, 9)."""
    return np.column_stack(
        [(planar_closed_form(at, k + e, tool) - planar_closed_form(at, k - e, tool)) / 2e-5 for e in np.eye(9) * 1e-5]
    )


def test_eq_64() -> None:
    """J_X of the nominal machine, from the three lines of (56), symbolically."""
    u, v = sp.symbols("u v")
    rows = []
    for point, normal in (((-b1x, 0), (u, v)), ((b2x, 0), (u, v)), ((-b1x, 0), (-v, u))):
        BC = sp.Matrix([0, -h]) - sp.Matrix(point)
        n = sp.Matrix(normal)
        rows.append([*n, n.dot(sp.Matrix([BC[1], -BC[0]]))])
    printed = sp.Matrix([[u, v, -u * h - v * b1x], [u, v, -u * h + v * b2x], [-v, u, v * h - u * b1x]])
    assert zero(sp.Matrix(rows) - printed)


def test_eq_63_and_67() -> None:
    """J_X^-1 J_kC is the exact machine's derivative, for every tool length and configuration."""
    for tool in LENGTHS:
        for at in CONFIGURATIONS[::3]:
            assert np.allclose(planar_sensitivity(at, tool), exact_slopes(at, tool), atol=1e-5)


def test_eq_65() -> None:
    """Third row: +l for q0, and v for a1x, which is missing; printed, two columns of S_C are wrong and only they."""
    wrong = np.abs(planar_sensitivity(0.3, 100.0, printed=True) - exact_slopes(0.3, 100.0)).max(axis=0) > 1e-2
    assert [PLANAR[k] for k in np.flatnonzero(wrong)] == ["q0", "a1x"]
    J_X, J_k = planar_matrices(0.3, 100.0)
    u, v = np.sin(0.3), -np.cos(0.3)
    assert np.allclose(J_k[2], [950, v, 0, 0, -v, 0, 0, 0, 0])
    assert np.allclose(J_X @ exact_slopes(0.3, 100.0), J_k, atol=1e-4)
    assert np.allclose(J_k[0], [0, -u, 0, 0, u, 0, 0, 1, 0])
    # the printed sign contradicts eq. (56) itself, whose third line gives + l1 dq0 on the right
    assert planar_matrices(0.3, 100.0, printed=True)[1][2, 0] == -J_k[2, 0]


def test_eq_68_and_69() -> None:
    J_X, J_k = planar_matrices(0.3, 100.0)
    assert J_X.shape == (3, 3)
    assert J_k.shape == (3, 9) == (3, len(PLANAR))
    assert PLANAR == ("q0", "a1x", "a2x", "a2y", "b1x", "b2x", "b2y", "l1", "l2")


# ------------------------------------------------------------------------------------------------ III.B: the comparison

PLANAR_SCALE = np.array([1 / 950.0, *np.ones(8)])


def stacked(printed: bool = False, tool: float = 100.0) -> np.ndarray:
    return np.concatenate([planar_sensitivity(at, tool, printed=printed) for at in CONFIGURATIONS])


def test_configurations() -> None:
    assert len(CONFIGURATIONS) == 19
    assert len(CHECK) == 91


def test_table_2() -> None:
    """Nine errors of nine parameters; the nominal machine is a parallelogram; only five errors, and q0's, are not 0."""
    assert len(ERRORS) == len(NOMINAL) == 9
    assert NOMINAL[1] + NOMINAL[2] == NOMINAL[4] + NOMINAL[5]
    assert np.count_nonzero(ERRORS) == 6
    for at in CHECK[::15]:
        assert np.isfinite(planar_closed_form(at, NOMINAL + ERRORS, 100.0)).all()  # it can be assembled everywhere


def test_six_of_nine_errors_are_identifiable() -> None:
    for tool in LENGTHS:
        found, gap = rank(stacked(tool=tool), PLANAR_SCALE)
        assert found == 6
        assert gap > 1e6
    assert rank(stacked(printed=True), PLANAR_SCALE)[0] == 7  # eq. (65) as printed contradicts the count


def test_eq_70_to_72() -> None:
    """A null direction for each: the pair moved so that the combination stays, nothing is seen."""
    for base, other, sign in (("a2x", "b2x", 1), ("a2y", "b2y", 1), ("b1x", "a1x", 1)):
        e = np.zeros(9)
        e[PLANAR.index(base)], e[PLANAR.index(other)] = 1.0, float(sign)  # base - other = 0
        assert np.abs(stacked() @ e).max() < 1e-9
        if base == "b1x":
            assert np.abs(stacked(printed=True) @ e).max() > 0.1


def test_base_parameters_hold_to_first_order() -> None:
    """Both of a pair moved alike: nothing at the nominal machine, more than the noise at that of Table 2."""
    found = []
    for pair in (("a2x", "b2x"), ("a2y", "b2y"), ("b1x", "a1x")):
        both = np.isin(PLANAR, pair).astype(float)

        def moved(k: np.ndarray, both: np.ndarray = both) -> np.ndarray:
            change = [planar_pose(q, k + both, 100.0) - planar_pose(q, k, 100.0) for q in CONFIGURATIONS]
            return np.abs(change).max(axis=0)

        assert moved(NOMINAL).max() < 1e-12
        whole, half = moved(NOMINAL + ERRORS), moved(NOMINAL + ERRORS / 2)
        found.append(whole[:2].max())
        assert np.degrees(whole[2]) > 0.008
        assert half[2] / whole[2] == pytest.approx(0.5, abs=0.03)
    assert found == pytest.approx([0.019, 0.020, 0.017], abs=0.0005)


def test_eq_73() -> None:
    columns = [PLANAR.index(name) for name in BASE]
    assert len(columns) == 6
    assert rank(stacked()[:, columns], PLANAR_SCALE[columns])[0] == 6


def test_eq_74() -> None:
    """Two columns, independent over the configurations; the machine has one rod, `l` of eq. (38)."""
    H = np.column_stack([950 * np.cos(CONFIGURATIONS), np.sin(CONFIGURATIONS)])
    assert np.linalg.matrix_rank(H / [950.0, 1.0]) == 2


@cache
def run(tool: float, seed: int | None = 0, noise: float = 1.0, step: float = 5.0) -> Study:
    configurations = np.arange(-45.0, 45.0 + step / 2, step) * DEG
    rng = None if seed is None else np.random.default_rng(seed)
    return study(tool, rng, configurations=configurations, noise=noise)


def worst(values: np.ndarray) -> float:
    return float(np.abs(values).max())


@pytest.mark.parametrize("tool", LENGTHS)
def test_three_curves(tool: float) -> None:
    """The largest error at every tool length: none > classical > 15 times improved."""
    for seed in range(3):
        found = run(tool, seed)
        assert worst(found.none) > 3 * worst(found.classical) > 45 * worst(found.improved)


def test_the_curves_in_numbers() -> None:
    """What the ledger quotes, without noise [mm]."""
    quoted = {0.0: (1.672, 0.239, 0.0063), 100.0: (1.966, 0.632, 0.0084), 200.0: (5.604, 1.543, 0.0820)}
    for tool, values in quoted.items():
        found = run(tool, seed=None)
        measured = (worst(found.none), worst(found.classical), worst(found.improved))
        assert measured == pytest.approx(values, rel=0.01)


def test_the_difference_grows_with_the_tool() -> None:
    gap = [worst(run(tool).classical) - worst(run(tool).improved) for tool in LENGTHS]
    assert gap[0] < gap[1] < gap[2]
    turned = [np.abs(planar_closed_form(CHECK, NOMINAL + ERRORS, tool)[:, 2]).max() for tool in LENGTHS]
    assert turned[0] == pytest.approx(turned[2])  # the platform's turn does not depend on h: its lever does


def test_noise_is_not_what_remains() -> None:
    """Without any noise, or with 19 times the configurations and a tenth of the noise, as much remains."""
    for tool in LENGTHS:
        base, silent, many = run(tool), run(tool, seed=None), run(tool, noise=0.1, step=0.25)
        assert len(np.arange(-45.0, 45.1, 0.25)) == 361
        assert worst(silent.improved) > 0.8 * worst(base.improved)
        assert worst(many.improved) > 0.8 * worst(base.improved)
    # identified biases, not noise: the standard deviation of b1x is some 0.011 mm, its error 0.33 mm at h = 200
    assert abs(run(200.0, seed=None).base[3] - (-1.0)) > 0.3


def test_what_remains_is_of_second_order() -> None:
    """Half the machine's errors leave a quarter: the linearisation is what remains."""
    left = [worst(study(200.0, None, errors=t * ERRORS).improved) for t in (0.5, 0.25)]
    assert left[0] / left[1] == pytest.approx(4, rel=0.15)


def test_the_exact_method_leaves_noise() -> None:
    """Closed form identified and inverted: the largest error is below the noise of one reading."""
    for tool in LENGTHS:
        for seed in range(3):
            assert worst(run(tool, seed).exact) < SIGMA[0]
        assert worst(run(tool, seed=None).exact) < 1e-3


def test_signs_of_eq_65_cancel_in_the_study() -> None:
    """With (65) as printed the same positions come out and delta q0 with the wrong sign: the curves cannot tell."""
    right, printed = (study(100.0, None, printed=p) for p in (False, True))
    assert worst(right.improved) == pytest.approx(worst(printed.improved), rel=1e-6)
    assert printed.base[0] == pytest.approx(-right.base[0], rel=1e-6)


CAPTIONS = {
    2: "Computation scheme of the complete inverse position relationship's approximation",
    3: "Scheme of the simple mechanism",
    6: "TCP positioning before and after classical and improved calibration",
}


@pytest.mark.parametrize(
    ("cited", "meant", "subject"),
    [(6, 3, "mechanism"), (3, 2, "inverse position relationship")],
    ids=["closure relations", "compensation"],
)
def test_cited_figures(cited: int, meant: int, subject: str) -> None:
    assert subject not in CAPTIONS[cited]
    assert subject in CAPTIONS[meant]


def test_table_2_has_errors_on_six_parameters() -> None:
    assert [name for name, value in zip(PLANAR, ERRORS, strict=True) if value == 0] == ["a2x", "b1x", "b2y"]
    base = {"a2x": ERRORS[2] - ERRORS[5], "a2y": ERRORS[3] - ERRORS[6], "b1x": ERRORS[4] - ERRORS[1]}
    assert all(base.values())
