"""The likelihood of a linear mixed model, against densities of rows whose covariance is written out."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import approx_fprime
from scipy.stats import multivariate_normal

from deltacal_gen.inference.likelihood import MixedModel
from deltacal_gen.inference.projection import basis

ROWS, FIXED, EFFECTS = 40, 5, 12


@pytest.fixture(params=range(3))
def drawn(request: pytest.FixtureRequest) -> tuple[np.ndarray, ...]:
    """Return fixed columns, effects' columns, their variances and rows."""
    rng = np.random.default_rng(request.param)
    X, Z = rng.standard_normal((ROWS, FIXED)), rng.standard_normal((ROWS, EFFECTS))
    variances = rng.uniform(0.1, 3.0, EFFECTS) * (np.arange(EFFECTS) % 4 > 0)  # some are not there
    y = X @ rng.standard_normal(FIXED) + Z @ (np.sqrt(variances) * rng.standard_normal(EFFECTS))
    return X, Z, variances, y + 0.7 * rng.standard_normal(ROWS)


def contrasts(X: np.ndarray) -> np.ndarray:
    """Return an orthonormal basis of what is orthogonal to columns."""
    return np.linalg.qr(X, mode="complete")[0][:, X.shape[1] :]


def test_evidence_is_the_density_of_the_contrasts(drawn: tuple[np.ndarray, ...]) -> None:
    X, Z, variances, y = drawn
    model, K = MixedModel.of(Z, y, basis(X)), contrasts(X)
    V = K.T @ (0.5 * np.eye(ROWS) + (Z * variances) @ Z.T) @ K
    assert model.contrasts == ROWS - FIXED
    assert model.evidence(variances, 0.5) == pytest.approx(multivariate_normal.logpdf(K.T @ y, cov=V), rel=1e-12)


def test_profiled_noise_is_the_likeliest(drawn: tuple[np.ndarray, ...]) -> None:
    X, Z, ratios, y = drawn
    model, n = MixedModel.of(Z, y, basis(X)), ROWS - FIXED
    noise = model.noise(ratios)
    at = [model.deviance(ratios * s, s) for s in (0.99 * noise, noise, 1.01 * noise)]
    assert at[1] < min(at[0], at[2])
    assert model.deviance(ratios) + n * (1 - np.log(n)) == pytest.approx(at[1], rel=1e-12)


def test_a_diagonal_model_is_the_dense_one(drawn: tuple[np.ndarray, ...]) -> None:
    X, Z, _, y = drawn
    dense = MixedModel.of(Z, y, basis(X))
    turned = dense.diagonal()
    for noise in (None, 0.6):
        alike = np.full(EFFECTS, 0.8)
        assert turned.deviance(alike, noise) == pytest.approx(dense.deviance(alike, noise), rel=1e-12)
        own, of_noise = turned.slopes(alike, noise)
        each, also = dense.slopes(alike, noise)
        assert own.sum() == pytest.approx(each.sum(), rel=1e-10)
        assert of_noise == pytest.approx(also, rel=1e-10)


def test_normal_equations_say_what_rows_do(drawn: tuple[np.ndarray, ...]) -> None:
    X, Z, variances, y = drawn
    K = contrasts(X)
    Z, y = K.T @ np.column_stack([Z, Z[:, 0]]), K.T @ y  # one effect is another one
    every = np.append(variances, 0.3)
    model = MixedModel.normal(Z.T @ Z, Z.T @ y, float(y @ y), len(y))
    assert len(model.s) == EFFECTS
    assert model.evidence(every, 0.5) == pytest.approx(
        multivariate_normal.logpdf(y, cov=0.5 * np.eye(len(y)) + (Z * every) @ Z.T), rel=1e-10
    )


def test_what_is_left_is_no_difference_of_large_squares() -> None:
    """Effects that explain all but the noise of rows a hundred million times larger."""
    rng = np.random.default_rng(9)
    Z, e = rng.standard_normal((60, 5)), rng.standard_normal(60)
    large = 1e8 * Z @ np.ones(5)
    known = MixedModel.of(Z, e, np.zeros((60, 0)))
    assert MixedModel.of(Z, large + e, np.zeros((60, 0))).noise(np.full(5, 1e40)) == pytest.approx(
        known.noise(np.full(5, 1e40)), rel=1e-6
    )


@pytest.mark.parametrize("noise", [None, 0.6])
@pytest.mark.parametrize("diagonal", [False, True])
def test_slopes_are_those_of_the_deviance(drawn: tuple[np.ndarray, ...], noise: float | None, diagonal: bool) -> None:
    X, Z, variances, y = drawn
    model = MixedModel.of(Z, y, basis(X))
    model = model.diagonal() if diagonal else model
    there = np.flatnonzero(variances)

    def deviance(log: np.ndarray) -> float:
        each = np.zeros(EFFECTS)
        each[there] = np.exp(log[:-1])
        return model.deviance(each, None if noise is None else float(np.exp(log[-1])))

    at = np.append(np.log(variances[there]), np.log(noise or 1.0))
    by, of_noise = model.slopes(variances, noise)
    assert np.append(by[there], of_noise) == pytest.approx(approx_fprime(at, deviance, 1e-7), abs=1e-4)
    assert not by[variances == 0].any()


def test_posterior_is_that_of_the_joint_distribution(drawn: tuple[np.ndarray, ...]) -> None:
    """Henderson's (1950) mixed model equations, the fixed effects among the unknowns."""
    X, Z, variances, y = drawn
    there = np.flatnonzero(variances)
    W, noise = np.column_stack([X, Z[:, there]]), 0.5
    precision = W.T @ W / noise + np.diag(np.append(np.zeros(FIXED), 1 / variances[there]))
    C = np.linalg.inv(precision)
    mean, covariance = MixedModel.of(Z, y, basis(X)).posterior(variances, noise)
    assert mean[there] == pytest.approx((C @ W.T @ y / noise)[FIXED:], rel=1e-9)
    assert covariance[np.ix_(there, there)] == pytest.approx(C[FIXED:, FIXED:], rel=1e-9)
    assert not mean[variances == 0].any()
    assert not covariance[variances == 0].any()


def test_what_effects_explain_wholly_leaves_what_rounding_does() -> None:
    model = MixedModel.of(np.eye(6), np.arange(6.0), np.zeros((6, 0)))
    assert np.isfinite(model.deviance(np.full(6, 1e30)))
    assert np.isfinite(MixedModel.normal(np.eye(6), np.arange(6.0), 55.0, 6).deviance(np.full(6, 1e30)))
    assert np.isfinite(MixedModel.of(np.eye(6), np.zeros(6), np.zeros((6, 0))).deviance(np.ones(6)))
