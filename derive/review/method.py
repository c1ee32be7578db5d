"""The method as a derivation: what is minimised, what SymPy makes of it, the line that computes it, the difference.

Everything after the machine's own equations is one least squares in the directions of a singular value decomposition,
and every rule of it is the minimum of a sum that is written here; SymPy differentiates and solves it. Beside each
stands the function of the runtime that computes it, the figure by which the two differ at seeded numbers, made with the
page, and the test that decides.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import sympy as sp

from deltacal_gen.diagnosis import charges, correction
from deltacal_gen.estimation import fit, residuals, solvers
from deltacal_gen.identification import orders
from deltacal_gen.inference import functions
from deltacal_gen.instrument.kinds import kind_of
from derive.measurements import gauge
from derive.review.laws import Law, law
from derive.review.sources import Place, of_function

SEED = 23
# one direction of the decomposition: its singular value, the readings along it, its amplitude; the noise that is left
s, c, a, strength = sp.symbols("s c a lambda", positive=True)
k, m, i = sp.symbols("k m i", integer=True, positive=True)
rest = sp.Symbol("r_0", positive=True)
z, huber = sp.symbols("z h", positive=True)
gain, forms, chance = sp.symbols("g m_f p", positive=True)


@dataclass(frozen=True)
class Step:
    """A part of the method.

    Attributes
    ----------
    title : str
    law : Law
        What SymPy made, and the function in which it ends.
    gap : float
        Largest difference between the two at seeded numbers.
    test : str
        ``FILE::FUNCTION`` that decides it.
    """

    title: str
    law: Law
    gap: float
    test: str


def least(objective: sp.Expr) -> sp.Expr:
    """Return the amplitude at which an objective is least: its only stationary point, where it is curved upwards."""
    (found,) = sp.solve(sp.diff(objective, a), a)
    if sp.diff(objective, a, 2).is_positive is not True:
        raise ValueError("the objective is not convex.")
    return sp.factor(found)


def _system() -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return seeded A, b, and its decomposition: singular values, b along them, V."""
    rng = np.random.default_rng(SEED)
    A, b = rng.standard_normal((12, 4)) * [1.0, 0.3, 0.05, 0.01], rng.standard_normal(12)
    U, values, Vt = np.linalg.svd(A, full_matrices=False)
    return A, b, values, U.T @ b, Vt.T


def _amplitudes(expr: sp.Expr, **more: float) -> np.ndarray:
    """Return what an amplitude comes to along each direction of `_system`."""
    _, _, values, along, _ = _system()
    known = {strength: more.get("strength", 1.0)}
    return np.array([float(expr.subs(known | {s: v, c: w})) for v, w in zip(values, along, strict=True)])


def _solved(solver: solvers.Solver, expr: sp.Expr, **more: float) -> float:
    A, b, _, _, V = _system()
    return float(np.abs(solver.solve(A, b).u - V @ _amplitudes(expr, **more)).max())


def _solver_steps() -> list[Step]:
    """Return least squares, ridge, priors and the truncation."""
    square = (s * a - c) ** 2
    ridge, prior = square + strength**2 * a**2, square + a**2
    curvature = sp.simplify(2 / sp.diff(prior, a, 2))
    A, b, values, _, V = _system()
    posterior = (V * [float(curvature.subs(s, v)) for v in values]) @ V.T
    spread_off = float(np.abs(solvers.Prior().solve(A, b).covariance - posterior).max())
    name = "tests/estimation/test_solvers.py::"
    amplitude = sp.Symbol("a", positive=True)
    return [
        Step(
            "Least squares",
            law(
                "The amplitude of a direction at which the readings miss least.",
                (amplitude, least(square)),
                place=of_function(solvers._factored),
                ends=[solvers.LeastSquares.solve],
            ),
            _solved(solvers.LeastSquares(), least(square)),
            f"{name}test_least_squares_is_scipy_s",
        ),
        Step(
            "Ridge",
            law(
                "Least where every amplitude costs its square as well: strong directions stay, weak ones shrink.",
                (amplitude, least(ridge)),
                ends=[solvers.Ridge.solve],
            ),
            _solved(solvers.Ridge(0.2), least(ridge), strength=0.2),
            f"{name}test_ridge_solves_the_augmented_system",
        ),
        Step(
            "Priors",
            law(
                "Columns count in standard deviations of what is known beforehand, so the cost has the weight one; the "
                "posterior variance is twice the inverse curvature.",
                (amplitude, least(prior)),
                (sp.Symbol("sigma_a") ** 2, curvature),
                ends=[solvers.Prior.solve],
            ),
            max(_solved(solvers.Prior(), least(prior)), spread_off),
            f"{name}test_a_prior_gives_the_posterior",
        ),
        _truncation(),
    ]


def _truncation() -> Step:
    """Return the score by which a number of directions is chosen."""
    kept = sp.Symbol("k", integer=True)
    c_i = sp.Symbol("c_i", real=True)
    score = (rest + sp.Sum(c_i**2, (i, kept + 1, 4))) / (m - kept) ** 2
    A, b, _, along, _ = _system()
    left = float(b @ b - along @ along)
    scores = [(left + float(np.sum(along[j:] ** 2))) / (len(b) - j) ** 2 for j in range(5)]
    chosen = int(solvers.TSVD("gcv").solve(A, b).factors.sum())
    return Step(
        "Truncated SVD",
        law(
            "Of k directions kept, generalised cross-validation weighs what is left, outside the columns and in "
            "the directions given up, against the readings that are left to tell.",
            (sp.Symbol("G"), score),
            ends=[solvers.TSVD.solve],
        ),
        float(abs(chosen - int(np.argmin(scores)))),
        "tests/estimation/test_solvers.py::test_cross_validation_of_a_truncation_is_its_formula",
    )


def _rough_and_fine() -> Step:
    """Return the step that both fits repeat: normal equations of the misfit to first order."""
    rows, columns = sp.symbols("n_r n_p", integer=True, positive=True)
    J, r, d = (sp.MatrixSymbol(n, *size) for n, size in (("J", (rows, columns)), ("r", (rows, 1)), ("d", (columns, 1))))
    A, b, *_ = _system()
    u = solvers.LeastSquares().solve(A, b).u
    return Step(
        "Rough and fine",
        law(
            "The encoder offsets alone first, which move the platform most, then all parameters from there. Either fit "
            "repeats one step d until it promises nothing: the gradient of the misfit to first order vanishes.",
            (J.T * J * d, J.T * r),
            place=of_function(fit.rough),
            ends=[fit.fit],
        ),
        float(np.abs(A.T @ (A @ u - b)).max()),
        "tests/machine/test_bai2015.py::test_one_linear_step_after_the_offsets_is_enough",
    )


def _weights() -> Step:
    """Return Huber's weight: the slope of his loss over the residual."""
    loss = sp.Piecewise((z**2 / 2, z <= huber), (huber * z - huber**2 / 2, True))
    weight = sp.piecewise_fold(sp.simplify(sp.diff(loss, z) / z))
    sizes = np.array([[0.2], [1.0], [3.0], [40.0]])
    ours = residuals.robust_weights(sizes, np.ones(1))
    gap = max(
        abs(float(weight.subs({z: v, huber: residuals.HUBER})) - w) for v, w in zip(sizes[:, 0], ours, strict=True)
    )
    return Step(
        "Robust weights",
        law(
            "A reading counts by the slope of Huber's loss at its residual z, in standard deviations, over z.",
            (sp.Symbol("w"), weight),
            place=of_function(fit.fit),
            ends=[residuals.robust_weights],
        ),
        gap,
        "tests/diagnosis/test_diagnosis_controls.py::test_noise_with_heavy_tails_is_noise",
    )


def _loop() -> Step:
    """Return the correction of Mei's eq. (30), from the gauge's own length: what its mounting is off is taken away."""
    f = sp.Matrix(sp.symbols("f_x f_y f_z", real=True))
    length = gauge.length.xreplace(dict(zip((*gauge.X.position, *gauge.g), (*f, 0, 0, 0), strict=True)))
    kind, rng = kind_of("gauge"), np.random.default_rng(SEED)
    found = kind.taken(np.zeros((1, 1), dtype=int))
    x, mount = np.zeros((1, 12)), rng.standard_normal(3)
    x[0, :3], x[0, 3:] = 300.0 * rng.standard_normal(3), np.eye(3).ravel()
    standing = kind.first()
    known = {**dict(zip(f, x[0, :3], strict=True)), **dict(zip(gauge.m, mount, strict=True))}
    state = np.array([[*mount, 0.0]])
    read = type(standing)(kind, state, ()).predict(found, x)[0]
    return Step(
        "The loop of eq. (30)",
        law(
            "What the scale spans is f less what its mounting is off, m. A round that finds dr_M of it goes on with "
            "f - dr_M; the print has a plus, with which the loop runs away.",
            (sp.ImmutableMatrix(sp.symbols("rho_x rho_y rho_z", real=True)), sp.ImmutableMatrix(length)),
            ends=[type(standing).predict],
        ),
        float(abs(np.linalg.norm(np.array(length.subs(known), dtype=float)) - float(read.ravel()[0]))),
        "tests/claims/test_mei_identification.py::test_eq_30",
    )


def _search_steps() -> list[Step]:
    """Return the gain of columns, and the charge of a search."""
    G, v = sp.MatrixSymbol("G", k, k), sp.MatrixSymbol("b", k, 1)
    x = sp.Symbol("x", positive=True)
    tail = sp.erfc(sp.sqrt(x / 2))  # of chi2 with one degree of freedom
    rng = np.random.default_rng(SEED)
    root = rng.standard_normal((6, 3))
    root /= np.linalg.norm(root, axis=0)
    left = rng.standard_normal(6)
    taken = float(left @ left - np.sum((left - root @ np.linalg.lstsq(root, left, rcond=None)[0]) ** 2))
    gains = float(charges.gains((root.T @ root)[None], (root.T @ left)[None])[0])
    level = charges.quantile(1, 50)
    return [
        Step(
            "Gain of a candidate",
            law(
                "What columns take from chi2, geometry's and the instrument's share projected out before: G of their "
                "normal equations, b of what is left.",
                (gain, (v.T * G.I * v)),
                ends=[charges.gains],
            ),
            abs(gains - taken),
            "tests/diagnosis/test_discrimination.py::test_expected_gains_are_those_of_fitting_anew",
        ),
        Step(
            "Charge of a search",
            law(
                "The largest of so many forms exceeds x by chance no more often than their number times the tail of "
                "one; the charge is the x at which that is the chance allowed.",
                (chance, forms * tail),
                place=of_function(charges.charge),
                ends=[charges.quantile],
            ),
            abs(float((50 * tail).subs(x, level)) - charges.CHANCE),
            "tests/derive/test_derivation.py::test_the_method_is_what_the_runtime_computes",
        ),
    ]


def _smooth_steps() -> list[Step]:
    """Return the periodic function of a joint and the smooth correction as models: their covariances."""
    order, corner, gap, length = sp.symbols("n n_c d l", positive=True)
    variance = (1 + (order / corner) ** 2) ** -2
    kernel = sp.exp(-((gap / length) ** 2) / 2)
    t, u = sp.symbols("t u", real=True)
    n = np.arange(1, orders.ORDERS + 1)
    shape = functions.spectrum(orders.ORDERS, 7.0)
    values, knots = np.array([[0.3]]), np.array([[1.1]])
    # waves of one order with independent coefficients of one variance: the covariance of two angles
    pair = sp.simplify(sp.cos(order * t) * sp.cos(order * u) + sp.sin(order * t) * sp.sin(order * u))
    return [
        Step(
            "Periodic function of a joint",
            law(
                "Cosine and sine of order n with coefficients of one variance: two angles are alike by the cosine of "
                "their distance; beyond the corner the variance falls with the fourth power of the order.",
                (sp.Symbol("k_n"), variance * pair),
                ends=[functions.spectrum, functions.waves],
            ),
            float(max(abs(float(variance.subs({order: int(j), corner: 7.0})) - shape[j - 1]) for j in n)),
            "tests/diagnosis/test_spectrum.py::test_the_error_is_known_to_the_standard_deviation_that_is_stated",
        ),
        Step(
            "Smooth correction",
            law(
                "A function of one variable of which two values are alike by their distance d over a length l: what it "
                "displaces is this kernel times coefficients of its knots.",
                (sp.Symbol("k"), kernel),
                ends=[correction.Smooth.displacement, functions.bumps],
            ),
            abs(float(kernel.subs({gap: 0.8, length: 0.5})) - float(functions.bumps(values, knots, 0.5)[0, 0])),
            "tests/diagnosis/test_correction.py::test_a_function_fades_over_its_length",
        ),
    ]


def steps() -> Sequence[Step]:
    """Return the method, in the order in which a recording goes through it."""
    return (_rough_and_fine(), *_solver_steps(), _weights(), _loop(), *_search_steps(), *_smooth_steps())


def ends(step: Step) -> list[tuple[Callable[..., Any], Place]]:
    """Return the functions of the runtime in which a step ends, with their lines."""
    return [(f, of_function(f)) for f in step.law.ends if callable(f)]
