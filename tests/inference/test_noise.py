"""Noise as a sum of pieces, against covariances that are written out."""

from __future__ import annotations

import numpy as np
import pytest

from deltacal_gen.inference.noise import NoiseModel

R = 30


def covariance(noise: NoiseModel) -> np.ndarray:
    """Return diag(own) + fading S + B B'."""
    S, every = np.eye(R), np.empty((R, R))
    for i in range(R):
        for j in range(i + 1, R):
            S[i, j] = S[j, i] = S[i, j - 1] * noise.told[j]
    every[np.ix_(noise.order, noise.order)] = np.diag(noise.own) + noise.fading * S + noise.shared @ noise.shared.T
    return every


@pytest.fixture(
    params=[
        (1.0, 0.0, 0),  # white
        (0.3, 0.7, 0),  # serial, with a part of each row's own
        (0.0, 1.0, 0),  # serial alone
        (0.5, 0.0, 4),  # shared
        (0.2, 0.6, 4),  # all of them
        (0.2, 0.6, 40),  # more is shared than there are rows
    ]
)
def noise(request: pytest.FixtureRequest) -> NoiseModel:
    own, fading, m = request.param
    rng = np.random.default_rng(1)
    gap = rng.exponential(5.0, R)  # s, between rows
    gap[[0, 11]] = np.inf  # two runs
    order = rng.permutation(R) if fading else np.arange(R)
    return NoiseModel(order, own * rng.uniform(0.5, 2.0, R), np.exp(-gap / 8.0), fading, rng.standard_normal((R, m)))


def test_whitened_rows_have_the_covariance_one(noise: NoiseModel) -> None:
    W = noise.whiten(np.eye(R))
    assert W @ covariance(noise) @ W.T == pytest.approx(np.eye(R), abs=1e-9)
    assert noise.log_det == pytest.approx(np.linalg.slogdet(covariance(noise))[1], abs=1e-9)


def test_parts_of_other_sizes_need_no_new_decomposition(noise: NoiseModel) -> None:
    own, shared = 0.3, 1.7
    sized, B = noise.sized(own, shared), noise.shared
    every = np.ix_(noise.order, noise.order)
    expected = own * covariance(noise)
    expected[every] += (shared - own) * B @ B.T
    assert covariance(sized) == pytest.approx(expected, abs=1e-12)
    W = sized.whiten(np.eye(R))
    assert W @ expected @ W.T == pytest.approx(np.eye(R), abs=1e-9)
    assert sized.log_det == pytest.approx(np.linalg.slogdet(expected)[1], abs=1e-9)


def test_components_are_whitened_alike(noise: NoiseModel) -> None:
    values = np.random.default_rng(2).standard_normal((R, 3, 2))
    assert noise.whiten(values)[:, 1, 0] == pytest.approx(noise.whiten(values[:, 1, 0]))


def test_products_are_those_of_the_covariance(noise: NoiseModel) -> None:
    values = np.random.default_rng(5).standard_normal((R, 2, 3))
    assert noise.times(values) == pytest.approx(np.einsum("ij,jab->iab", covariance(noise), values), abs=1e-12)


def test_likelihood_is_that_of_the_dense_covariance(noise: NoiseModel) -> None:
    z = np.random.default_rng(3).standard_normal(R)
    e = noise.whiten(z)
    assert e @ e == pytest.approx(z @ np.linalg.solve(covariance(noise), z), rel=1e-9)


def test_what_others_do_not_tell_is_that_of_the_inverse(noise: NoiseModel) -> None:
    if noise.fading:
        return
    z, inverse = np.random.default_rng(4).standard_normal((R, 1)), np.linalg.inv(covariance(noise))
    assert noise.alone(z)[:, 0] == pytest.approx((inverse @ z)[:, 0] / np.sqrt(np.diag(inverse)), rel=1e-9)
    assert noise.restore(noise.whiten(z)) == pytest.approx(z, rel=1e-9)
