"""Nuisance columns are taken out, combinations of others once."""

from __future__ import annotations

import numpy as np
import pytest

from deltacal_gen.inference.projection import basis, project_out


def test_what_is_left_is_that_of_least_squares() -> None:
    rng = np.random.default_rng(1)
    unit, y = rng.standard_normal((30, 4)), rng.standard_normal((30, 2))
    X = unit * [1e-6, 1.0, 1e3, 1e9]
    Q = basis(X)
    assert pytest.approx(np.eye(4), abs=1e-12) == Q.T @ Q
    assert project_out(y, Q) == pytest.approx(y - unit @ np.linalg.lstsq(unit, y)[0], abs=1e-12)
    assert project_out(X, Q) / np.linalg.norm(X, axis=0) == pytest.approx(np.zeros((30, 4)), abs=1e-12)


@pytest.mark.parametrize("rows", [3, 30])
def test_rank_is_that_of_the_columns(rows: int) -> None:
    rng = np.random.default_rng(2)
    X = rng.standard_normal((rows, 2)) @ rng.standard_normal((2, 5))
    X[:, 3] = 0.0
    assert basis(X).shape == (rows, 2)
    assert project_out(X, basis(X)) == pytest.approx(np.zeros_like(X), abs=1e-12)
    assert basis(np.zeros((rows, 3))).shape == (rows, 0)
    assert basis(np.zeros((rows, 0))).shape == (rows, 0)
