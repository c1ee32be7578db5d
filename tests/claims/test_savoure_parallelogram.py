"""Savoure et al. 2006 on the planar parallelogram, section III.A: every numbered equation, decided.

Each test shows what the derivation gives and, where the printed form is wrong, that the printed form fails.
"""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from tests.claims.identities import zero
from tests.claims.independent_savoure import (
    CONFIGURATIONS,
    DELTA,
    ERRORS,
    LENGTHS,
    NOMINAL,
    PLANAR,
    planar_closed_form,
    planar_inverse,
    planar_matrices,
    planar_pose,
    planar_sensitivity,
)

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
    # and k_C cannot hold q: eqs. (27) and (53) find q from x and k_C, another one for every x of the same machine
    for at in (0.1, 0.2):
        assert float(planar_inverse(planar_pose(at, k, 100.0)[0], k, 100.0)) == pytest.approx(at, abs=1e-9)


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


def test_alpha_is_counted_from_the_base() -> None:
    """Eq. (44) wants the angle between x_b and x_p; from x_p itself it would be 0 whatever the platform does."""
    sine = (E + F * sp.cos(alpha) + G * sp.sin(alpha)).subs(LETTERS)
    for at in (-0.5, 0.3):
        values = solved(at)
        assert float(sine.subs(values)) == pytest.approx(float(sp.sin(values[phi])), abs=1e-9)
        assert abs(float(sine.subs({**values, alpha: 0})) - float(sp.sin(values[phi]))) > 5e-4


def test_axes_lie_on_lines_and_point_away() -> None:
    """x_b lies on the line O_bA1 and points from A1 to O_b, x_p from B1 to O_p: a1x and b1x of Table 2 are positive."""
    assert (NOMINAL[1], NOMINAL[4]) == (125.0, 125.0)
    here = planar_pose(0.3, NOMINAL, 0.0)[0]
    for column, moved in ((1, -1.0), (4, 1.0)):  # A1 goes to -x_b and C with it; B1 to -x_p, so C to +x_p
        there = planar_pose(0.3, NOMINAL + np.eye(9)[column], 0.0)[0]
        assert there - here == pytest.approx(moved, abs=0.01)


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
