"""Solvers against SciPy and closed forms, on matrices of every kind of rank."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.linalg import lstsq

from deltacal_gen.errors import UsageError
from deltacal_gen.estimation.solvers import TSVD, LeastSquares, Prior, Ridge, Solver, jitter

M, N = 30, 8


def matrix(kind: str) -> np.ndarray:
    rng = np.random.default_rng(4)
    full = rng.standard_normal((M, N)) * np.logspace(0, -2, N)
    if kind == "full rank":
        return full
    if kind == "wide":
        return full.T
    if kind == "deficient":
        return full[:, :5] @ rng.standard_normal((5, N))
    if kind == "deficient and wide":
        return (full[:, :5] @ rng.standard_normal((5, N))).T
    assert kind == "zero"
    return np.zeros((M, N))


KINDS = ["full rank", "wide", "deficient", "deficient and wide", "zero"]
RANK = {"full rank": 8, "wide": 8, "deficient": 5, "deficient and wide": 5, "zero": 0}
SOLVERS: list[Solver] = [LeastSquares(), TSVD(4), TSVD("discrepancy", 1.0), TSVD("gcv"), Prior()]


@pytest.fixture(params=KINDS)
def problem(request: pytest.FixtureRequest) -> tuple[str, np.ndarray, np.ndarray]:
    A = matrix(request.param)
    b = np.random.default_rng(9).standard_normal(A.shape[0])
    return request.param, A, b


def test_least_squares_is_scipy_s(problem: tuple[str, np.ndarray, np.ndarray]) -> None:
    kind, A, b = problem
    got = LeastSquares().solve(A, b)
    expected, _, rank, s = lstsq(A, b, cond=1e-10)
    assert got.u == pytest.approx(expected, abs=1e-10)  # the weakest direction amplifies rounding by 1e3
    assert got.degrees == rank == RANK[kind]
    assert got.singular_values == pytest.approx(s, abs=1e-12)
    assert got.covariance == pytest.approx(np.linalg.pinv(A.T @ A, rcond=1e-14, hermitian=True), abs=1e-6)


@pytest.mark.parametrize("keep", [0, 1, 4, 99])
def test_a_truncated_svd_is_least_squares_on_the_strong_directions(
    problem: tuple[str, np.ndarray, np.ndarray], keep: int
) -> None:
    kind, A, b = problem
    U, s, Vt = np.linalg.svd(A, full_matrices=False)
    k = min(keep, RANK[kind])
    expected = Vt[:k].T @ ((U[:, :k].T @ b) / s[:k])
    got = TSVD(keep).solve(A, b)
    assert got.u == pytest.approx(expected, abs=1e-10)
    assert got.degrees == k
    assert got.rule == f"truncated SVD, {k} of {len(s)} directions kept (given)"


def test_discrepancy_keeps_the_fewest_directions_that_leave_the_noise() -> None:
    A = matrix("full rank")
    rng = np.random.default_rng(1)
    U, s, Vt = np.linalg.svd(A, full_matrices=False)
    u = Vt[:3].T @ (40.0 / s[:3])  # three directions far above the noise, nothing in the others
    b = A @ u + rng.standard_normal(M)
    got = TSVD("discrepancy", 1.0).solve(A, b)
    left = [np.sum((b - U[:, :k] @ (U[:, :k].T @ b)) ** 2) for k in range(N + 1)]
    assert got.degrees == next(k for k in range(N + 1) if left[k] <= M)
    assert got.degrees <= 3


def test_discrepancy_keeps_everything_where_nothing_leaves_the_noise() -> None:
    A = matrix("full rank")
    assert TSVD("discrepancy", 1.0).solve(A, 1e3 * np.random.default_rng(2).standard_normal(M)).degrees == N


def test_cross_validation_of_a_truncation_is_its_formula(problem: tuple[str, np.ndarray, np.ndarray]) -> None:
    kind, A, b = problem
    if A.shape[0] <= A.shape[1]:
        pytest.skip("as many directions as readings leave no residual to validate on")
    U, _, _ = np.linalg.svd(A, full_matrices=False)
    score = [np.sum((b - U[:, :k] @ (U[:, :k].T @ b)) ** 2) / (M - k) ** 2 for k in range(RANK[kind] + 1)]
    assert TSVD("gcv").solve(A, b).degrees == np.argmin(score)


@pytest.mark.parametrize("strength", [1e-3, 0.3, 20.0])
def test_ridge_solves_the_augmented_system(problem: tuple[str, np.ndarray, np.ndarray], strength: float) -> None:
    kind, A, b = problem
    if kind == "zero":
        pytest.skip("no direction is kept")
    n = A.shape[1]
    expected = lstsq(np.vstack([A, strength * np.eye(n)]), np.concatenate([b, np.zeros(n)]))[0]
    got = Ridge(strength).solve(A, b)
    assert got.u == pytest.approx(expected, abs=1e-11 / strength)
    inverse = np.linalg.inv(A.T @ A + strength**2 * np.eye(n))
    assert got.covariance == pytest.approx(inverse @ A.T @ A @ inverse, rel=1e-6, abs=1e-9 / strength**2)


def test_ridge_chooses_its_strength_by_cross_validation() -> None:
    A = matrix("full rank")
    b = A @ np.ones(N) + 0.1 * np.random.default_rng(3).standard_normal(M)

    def score(strength: float) -> float:
        hat = A @ np.linalg.solve(A.T @ A + strength**2 * np.eye(N), A.T)
        return float(np.sum((b - hat @ b) ** 2) / (M - np.trace(hat)) ** 2)

    got = Ridge().solve(A, b)
    chosen = float(got.rule.removeprefix("ridge, strength "))
    grid = got.singular_values[0] * np.logspace(-10, 0, 201)
    assert score(chosen) <= min(map(score, grid)) * 1.01
    assert got.u == pytest.approx(np.linalg.solve(A.T @ A + chosen**2 * np.eye(N), A.T @ b), rel=0.02, abs=0.02)


def test_a_prior_gives_the_posterior(problem: tuple[str, np.ndarray, np.ndarray]) -> None:
    """Mean and covariance of a unit normal prior and unit noise; where data say nothing the prior's own is left."""
    _, A, b = problem
    C = np.linalg.inv(A.T @ A + np.eye(A.shape[1]))
    got = Prior().solve(A, b)
    assert got.posterior
    assert not LeastSquares().solve(A, b).posterior  # what is left at nominal there counts as known
    assert got.u == pytest.approx(C @ A.T @ b, abs=1e-12)
    assert got.covariance == pytest.approx(C, abs=1e-12)
    assert np.all(np.diag(got.covariance) <= 1 + 1e-12)


@pytest.mark.parametrize("solver", SOLVERS, ids=lambda s: type(s).__name__)
def test_no_reading_moves_nothing(solver: Solver) -> None:
    A = matrix("zero")
    got = solver.solve(A, np.ones(M))
    assert (got.u == 0).all()
    assert got.degrees == 0
    assert np.isfinite(got.covariance).all()


def test_an_unknown_truncation_is_refused() -> None:
    with pytest.raises(UsageError, match="truncation 'l-curve' is not known; give a number, 'discrepancy' or 'gcv'"):
        TSVD("l-curve")


def test_a_column_of_zeros_has_the_solution_zero() -> None:
    A = np.random.default_rng(3).standard_normal((9, 3)) * [1.0, 0.0, 1e6]
    G, g = A.T @ A, A.T @ (A @ [2.0, 5.0, -1e-6])
    G[np.diag_indices(3)] += jitter(np.diag(G))
    np.testing.assert_allclose(np.linalg.solve(G, g), [2.0, 0.0, -1e-6], rtol=1e-9, atol=1e-12)


def test_what_no_reading_sees_stays_where_it_is() -> None:
    """Columns that are but rounding, as of the joints of a delta whose lean is read: noise would move them at will."""
    rng = np.random.default_rng(6)
    A, b = 1e-12 * rng.standard_normal((30, 3)), rng.standard_normal(30)
    assert (LeastSquares().solve(A, b).u == 0).all()


def test_a_number_of_directions_may_be_one_of_numpy() -> None:
    assert TSVD(np.int64(3)) == TSVD(3)
    for wrong in (-1, 2.5, "3"):
        with pytest.raises(UsageError, match=f"truncation '{wrong}' is not known"):
            TSVD(wrong)  # type: ignore[arg-type]
