"""One limb of Bai 2015 in symbols: its closure with all errors, and the paper's equations as printed."""

from __future__ import annotations

import pytest

sp = pytest.importorskip("sympy", reason="the proofs need the dependency group 'derive'")

SIGNS = {1: 1, 2: -1}  # sgn(j)

# the direction phi of its plane, its joint theta, its rods' direction, lengths and errors
t, phi, theta = sp.symbols("t phi theta", real=True)
L, l, c, a, b, e = sp.symbols("L l c a b e", positive=True)


def symbols(name: str, indices: str = "xyz") -> sp.Matrix:
    return sp.Matrix(sp.symbols(" ".join(f"{name}_{k}" for k in indices), real=True))


u0 = sp.Matrix([sp.cos(phi), sp.sin(phi), 0])
v0 = sp.Matrix([0, 0, 1])
w0 = u0.cross(v0)
u1 = sp.cos(theta) * u0 + sp.sin(theta) * v0
v1 = -sp.sin(theta) * u0 + sp.cos(theta) * v0
lhat, dr, eps, de_b, de_a = (symbols(n) for n in ("lhat", "dr", "eps", "db", "da"))
a_i, b_i = symbols("a"), symbols("b")
d_arm, dtheta, dalpha0, dbeta0, dalpha2, dbeta2, dalpha3, dbeta3, dcc, dca = sp.symbols(
    "d_arm dtheta dalpha0 dbeta0 dalpha2 dbeta2 dalpha3 dbeta3 dcc dca", real=True
)
dl = {j: sp.Symbol(f"dl_{j}", real=True) for j in SIGNS}
eps_rod = {j: symbols(f"eps{j}") for j in SIGNS}
R0 = sp.Matrix.hstack(u0, v0, w0)
R1 = sp.rot_ccw_axis3(theta)
z = sp.Matrix([0, 0, 1])

de = de_b - de_a
dc, dl_mean, dl_diff = dcc - dca, (dl[1] + dl[2]) / 2, dl[1] - dl[2]
dalpha03, dbeta03 = dalpha0 - dalpha3, dbeta0 - dbeta3
p_r = sp.Matrix([L * dtheta, *de, d_arm, L * dalpha0, L * dbeta0, dl_mean])
p_e = sp.Matrix([dl_diff / c, dc / c, dalpha03, dbeta03, dalpha2, dbeta2])


def is_zero(expression: sp.Expr | sp.Matrix) -> bool:
    """Tell whether an expression vanishes for unit vectors l_hat."""
    unit = lhat.dot(lhat) - 1
    return all(sp.simplify(sp.reduced(sp.expand(x), [unit], lhat[2])[1]) == 0 for x in sp.Matrix([expression]))


def rotated(v: sp.Matrix) -> sp.Matrix:
    """Return the rotation by t v, exact to first order in t, which is all that is used."""
    return sp.eye(3) + t * v.hat()


def closure(j: int) -> sp.Matrix:
    """Return the closure of rod j, zero on the real machine; t scales all errors. Nothing of eq. (1) enters here."""
    half = sp.Rational(SIGNS[j], 2)
    base = R0 * rotated(sp.Matrix([dalpha0, dbeta0, 0])) * rotated(sp.Matrix([0, 0, dtheta])) * R1
    arm = sp.Matrix([L + t * d_arm, 0, 0]) + rotated(sp.Matrix([dalpha2, dbeta2, 0])) * z * half * (c + t * dcc)
    hand = a_i + t * de_a + R0 * rotated(sp.Matrix([dalpha3, dbeta3, 0])) * z * half * (c + t * dca)
    rod = (l + t * dl[j]) * rotated(eps_rod[j]) * lhat
    nominal = b_i + L * u1 + l * lhat - a_i
    return nominal + t * dr + rotated(eps) * hand - (b_i + t * de_b + base * arm + rod)


def equation_1(j: int) -> sp.Matrix:
    """Return the right side of eq. (1) as printed."""
    half = sp.Rational(SIGNS[j], 2)
    t0, t1, t2, t3 = (
        sp.Matrix(v) for v in ([dalpha0, dbeta0, 0], [0, 0, dtheta], [dalpha2, dbeta2, 0], [dalpha3, dbeta3, 0])
    )
    return (
        de
        + d_arm * u1
        + (R0 * (t0 + t1)).cross(L * u1)
        + half * dcc * w0
        + l * eps_rod[j].cross(lhat)
        + dl[j] * lhat
        + (R0 * (t0 + t1 + R1 * t2)).cross(half * c * w0)
        - half * dca * w0
        - (eps + R0 * t3).cross(half * c * w0)
        - eps.cross(a_i)
    )


def equation_3() -> sp.Matrix:
    """Return left minus right of eq. (3), read with Delta e_i."""
    mean = (eps_rod[1] + eps_rod[2]) / 2
    turn = (dalpha0 * u0 + dbeta0 * v0 + dtheta * w0).cross(u1)
    return dr + eps.cross(a_i) - (de + d_arm * u1 + L * turn + dl_mean * lhat + l * mean.cross(lhat))


def equation_4() -> sp.Matrix:
    """Return left minus right of eq. (4), read with the difference of the rods' turns."""
    turns = -dalpha03 * v0 + dbeta03 * u0 - dalpha2 * v1 + dbeta2 * u1
    right = dc / c * w0 + turns + dl_diff / c * lhat + l / c * (eps_rod[1] - eps_rod[2]).cross(lhat)
    return eps.cross(w0) - right


def rows() -> tuple[sp.Matrix, sp.Matrix]:
    """Return B_r,i (1, 8) and B_e,i (1, 6) as printed below eq. (7)."""
    s, k = sp.sin(theta), sp.cos(theta)
    B_r = [lhat.dot(v1), *lhat, lhat.dot(u1), lhat.dot(w0) * s, -lhat.dot(w0) * k, 1]
    B_e = [1, lhat.dot(w0), -lhat.dot(v0), lhat.dot(u0), -lhat.dot(v1), lhat.dot(u1)]
    return sp.Matrix([B_r]), sp.Matrix([B_e])
