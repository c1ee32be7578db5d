"""Kinematics and error model of Mei et al. 2018, sections 2 and 3, decided."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp

from tests.claims import independent_mei as mei
from tests.claims.simulated_mei import SIX, condition

# ---------------------------------------------------------------------------------------------- section 2: kinematics


def limb() -> dict[str, sp.Symbol]:
    return {name: sp.Symbol(name, real=True) for name in ("x", "y", "ex", "ey", "L", "l", "theta")}


def closure(s: dict[str, sp.Symbol]) -> sp.Expr:
    """|r - e - L u|^2 - l^2."""
    elbow = sp.Matrix([s["ex"] + s["L"] * sp.cos(s["theta"]), s["ey"] + s["L"] * sp.sin(s["theta"])])
    arm = sp.Matrix([s["x"], s["y"]]) - elbow
    return sp.expand(arm.dot(arm) - s["l"] ** 2)


def test_closure_of_both_limbs() -> None:
    """Eqs. (1), (2) and (4): the chain closes with unit vectors, at nominal and at erroneous geometry."""
    for robot in (mei.NOMINAL, mei.group(1)):
        theta = mei.inverse(SIX, robot)
        assert np.allclose(mei.forward(theta, robot), SIX, atol=1e-9)
        u, w = mei.links(SIX, robot)
        assert np.allclose(np.linalg.norm(w, axis=-1), 1, atol=1e-12)
        length, radius = mei.L + robot.proximal, mei.DISTAL + robot.distal
        chain = mei.centres(robot) + length[:, None] * u + radius[:, None] * w
        assert np.allclose(chain, SIX[:, None, :], atol=1e-9)


def test_eq_3() -> None:
    """Half-angle formula: the printed root and denominator are wrong, and so is one sign for both limbs."""
    C, D, E, t = sp.symbols("C D E t", real=True)
    s = limb()
    reach = {
        C: -2 * s["L"] * (s["y"] - s["ey"]),
        D: -2 * s["L"] * (s["x"] - s["ex"]),
        E: (s["x"] - s["ex"]) ** 2 + (s["y"] - s["ey"]) ** 2 + s["L"] ** 2 - s["l"] ** 2,
    }
    form = (D * sp.cos(s["theta"]) + C * sp.sin(s["theta"]) + E).subs(reach)
    assert sp.simplify(form - closure(s)) == 0
    quadratic = sp.expand(D * (1 - t**2) + 2 * C * t + E * (1 + t**2))  # times (1 + t^2)
    for sign in (1, -1):
        right = (-C + sign * sp.sqrt(C**2 + D**2 - E**2)) / (E - D)
        assert sp.simplify(quadratic.subs(t, right)) == 0
        for root in (C**2 - D**2 + E**2, C**2 + D**2 - E**2):
            for denominator in (D - E, E - D):
                wrong = (-C + sign * sp.sqrt(root)) / denominator
                if (root, denominator) != (C**2 + D**2 - E**2, E - D):
                    assert sp.simplify(quadratic.subs(t, wrong)) != 0

    def angle(p: mei.Array, i: int, sign: float) -> float:
        ex = (mei.EX, -mei.EX)[i]
        c, d = -2 * mei.L * p[1], -2 * mei.L * (p[0] - ex)
        e = (p[0] - ex) ** 2 + p[1] ** 2 + mei.L**2 - mei.DISTAL**2
        return float(np.mod(2 * np.arctan((-c + sign * np.sqrt(c**2 + d**2 - e**2)) / (e - d)), 2 * np.pi))

    p = np.array([100.0, -700.0])
    right_limb, left_limb = np.mod(mei.inverse(p), 2 * np.pi)
    assert angle(p, 0, 1) == pytest.approx(right_limb)
    assert angle(p, 1, -1) == pytest.approx(left_limb)
    assert abs(angle(p, 0, -1) - right_limb) > 1
    assert abs(angle(p, 1, 1) - left_limb) > 1


def elbows() -> tuple[sp.Matrix, sp.Matrix, sp.Symbol, sp.Symbol]:
    b1, b2 = (sp.Matrix(sp.symbols(f"b{i}x b{i}y", real=True)) for i in (1, 2))
    return b1, b2, *sp.symbols("l1 l2", positive=True)


def test_eq_5() -> None:
    s = limb()
    b = sp.Matrix([s["ex"] + s["L"] * sp.cos(s["theta"]), s["ey"] + s["L"] * sp.sin(s["theta"])])
    r = sp.Matrix([s["x"], s["y"]])
    assert sp.simplify(r.dot(r) - 2 * b.dot(r) + b.dot(b) - s["l"] ** 2 - closure(s)) == 0


def eliminated() -> dict[str, sp.Expr]:
    """The printed coefficients of eqs. (6) and (7), and what eq. (5) becomes with x of eq. (6), limb 1."""
    b1, b2, l1, l2 = elbows()
    y = sp.Symbol("y", real=True)
    F, M = 2 * (b2 - b1)[0], 2 * (b2 - b1)[1]
    S = b1.dot(b1) - b2.dot(b2) - (l1**2 - l2**2)
    x = -(M * y + S) / F
    left = [x**2 + y**2 - 2 * (b[0] * x + b[1] * y) + b.dot(b) - length**2 for b, length in ((b1, l1), (b2, l2))]
    N = 1 + M**2 / F**2
    Q = [2 * M * S / F**2 + 2 * (b[0] * M / F - b[1]) for b in (b1, b2)]
    R = [S**2 / F**2 + 2 * S / F * b[0] + b.dot(b) - n**2 for b, n in ((b1, l1), (b2, l2))]
    return {"y": y, "left": left, "N": N, "Q": Q, "R": R}


def test_which_norm_gives_the_inverse_solution() -> None:
    """The norm of both sides of (1) as it stands keeps phi_i; that of l_i w_i = r - e_i - L_i u_i has lost it."""
    s, angle = limb(), sp.Symbol("varphi", real=True)
    elbow = sp.Matrix([s["ex"] + s["L"] * sp.cos(s["theta"]), s["ey"] + s["L"] * sp.sin(s["theta"])])
    distal = s["l"] * sp.Matrix([sp.cos(angle), sp.sin(angle)])
    assert sp.simplify((elbow + distal).dot(elbow + distal).diff(angle)) != 0
    assert sp.simplify(distal.dot(distal) - s["l"] ** 2) == 0  # what is left is the closure, and eq. (3) solves that


def test_eq_6() -> None:
    b1, b2, l1, l2 = elbows()
    x, y = sp.symbols("x y", real=True)
    circle = [x**2 + y**2 - 2 * (b[0] * x + b[1] * y) + b.dot(b) - n**2 for b, n in ((b1, l1), (b2, l2))]
    F, M = 2 * (b2 - b1)[0], 2 * (b2 - b1)[1]
    S = b1.dot(b1) - b2.dot(b2) - (l1**2 - l2**2)
    assert sp.expand(circle[0] - circle[1] - (F * x + M * y + S)) == 0


def test_eq_7() -> None:
    """The linear term lacks its y in print; with it, both limbs give the same quadratic."""
    e = eliminated()
    for i in range(2):
        right = e["N"] * e["y"] ** 2 + e["Q"][i] * e["y"] + e["R"][i]
        printed = e["N"] * e["y"] ** 2 + e["Q"][i] + e["R"][i]
        assert sp.simplify(e["left"][i] - right) == 0
        assert sp.simplify(e["left"][i] - printed) != 0
    assert sp.simplify(e["Q"][0] - e["Q"][1]) == 0
    assert sp.simplify(e["R"][0] - e["R"][1]) == 0


def test_eq_8() -> None:
    """Of the two roots of (7) the lower one is the assembly that hangs below the base."""
    theta = mei.inverse(SIX)
    elbow = mei.centres(mei.NOMINAL) + mei.L * np.stack([np.cos(theta), np.sin(theta)], -1)
    b1, b2 = elbow[:, 0], elbow[:, 1]
    F, M = 2 * (b2 - b1).T
    S = np.sum(b1**2, -1) - np.sum(b2**2, -1)
    N, Q = 1 + (M / F) ** 2, 2 * M * S / F**2 + 2 * (b1[:, 0] * M / F - b1[:, 1])
    R = (S / F) ** 2 + 2 * S / F * b1[:, 0] + np.sum(b1**2, -1) - mei.DISTAL**2
    y = (-Q - np.sqrt(Q**2 - 4 * N * R)) / (2 * N)
    assert np.allclose(np.column_stack([-(M * y + S) / F, y]), SIX, atol=1e-9)


# ------------------------------------------------------------------------------------------- section 3: error modelling


def test_error_model() -> None:
    """Eqs. (9) to (11): the differential of the closure, divided by 2 l, is eq. (11) term by term."""
    s = limb()
    d = {name: sp.Symbol(f"d{name}", real=True) for name in s}
    u = sp.Matrix([sp.cos(s["theta"]), sp.sin(s["theta"])])
    l_w = sp.Matrix([s["x"] - s["ex"], s["y"] - s["ey"]]) - s["L"] * u  # l w
    turned = sp.Matrix([[0, -1], [1, 0]]) * u
    assert sp.simplify(turned - u.diff(s["theta"])) == sp.zeros(2, 1)  # eq. (10)
    differential = sum(closure(s).diff(s[name]) * d[name] for name in s)
    dr, de = sp.Matrix([d["x"], d["y"]]), sp.Matrix([d["ex"], d["ey"]])
    eq_11 = l_w.dot(dr) - l_w.dot(de) - d["L"] * l_w.dot(u) - s["L"] * l_w.dot(turned) * d["theta"] - s["l"] * d["l"]
    assert sp.simplify(differential - 2 * eq_11) == 0


def test_dot_product_with_w() -> None:
    """Eq. (11) is eq. (9) times w, not times dw as the text says: dw kills the term in dl and leaves l |dw|^2."""
    phi, dphi, dl, l = sp.symbols("phi dphi dl l", real=True)
    w = sp.Matrix([sp.cos(phi), sp.sin(phi)])
    dw = w.diff(phi) * dphi
    end = dl * w + l * dw  # the terms of eq. (9) in the distal link
    assert sp.simplify(w.dot(end) - dl) == 0  # eq. (11)
    assert sp.simplify(dw.dot(end) - l * dphi**2) == 0


def numerical_transfer(p: mei.Array) -> mei.Array:
    """d(position)/d(source errors), 10 columns in the order and units of eq. (12), by central differences."""
    theta, h = mei.inverse(p), 1e-4
    columns = []
    for i in range(2):
        for name, axis in (("zero", None), ("base", 0), ("base", 1), ("proximal", None), ("distal", None)):
            ends = []
            for sign in (1, -1):
                error = np.zeros((2, 2) if name == "base" else 2)
                error[(i, axis) if name == "base" else i] = sign * h / (mei.L if name == "zero" else 1)
                ends.append(mei.forward(theta, mei.Robot(**{name: error})))
            columns.append((ends[0] - ends[1]) / (2 * h))
    return np.stack(columns, -1)


def test_error_transfer_matrices() -> None:
    """Eqs. (12) and (13) against differences of the exact forward solution."""
    exact = numerical_transfer(SIX)
    assert np.allclose(mei.transfer(SIX, complete=True), exact, atol=1e-6)
    assert np.allclose(mei.transfer(SIX), exact[..., [0, 5]], atol=1e-6)


def test_fig_5() -> None:
    """Per degree against per mm the zero offset weighs most; per mm at the arm's end (L dtheta) it does not."""
    per_mm = np.linalg.norm(mei.transfer(mei.forward(mei.HOME), complete=True), axis=0)
    assert np.allclose(per_mm[:5], per_mm[5:])  # the symmetry that the text uses
    assert np.allclose(per_mm[:5], [0.907, 0.599, 0.907, 0.599, 1.087], atol=5e-4)
    assert per_mm[0] * np.radians(mei.L) == pytest.approx(5.934, abs=1e-3)  # mm per degree
    assert per_mm[4] > per_mm[0]
    assert per_mm[2] == pytest.approx(per_mm[0])


def test_table_1() -> None:
    """Only c and d pointing down give 475.34; up, as printed in the frame of eq. (8), gives 111.49."""
    assert condition(mei.identification_matrix(SIX)) == pytest.approx(475.34, abs=5e-3)
    up = np.array([0.0, 2 * mei.MECHANISM[1]])  # f = r - c - d with c, d = (0, 79), (0, 51)
    assert condition(mei.identification_matrix(SIX, shift=up)) == pytest.approx(111.49, abs=5e-3)
    home = mei.forward(mei.HOME)
    assert -mei.TOP - mei.HEIGHT < home[1] < -mei.TOP
    assert home[1] == pytest.approx(-688.186, abs=1e-3)
