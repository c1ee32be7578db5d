"""Elementary functions of the compiled kernels: as accurate as they say, to the ends of their ranges."""

from __future__ import annotations

import numpy as np
import pytest
from deltacal_kernels import elementary
from numba import njit

ULP = np.finfo(float).eps


def over(function: object, *arguments: np.ndarray) -> np.ndarray:
    """Return a compiled function of one or two arguments at all of their values."""

    @njit
    def of_one(rows: np.ndarray) -> np.ndarray:
        out = np.empty(len(rows))
        for n in range(len(rows)):
            out[n] = function(rows[n, 0])  # type: ignore[operator]
        return out

    @njit
    def of_two(rows: np.ndarray) -> np.ndarray:
        out = np.empty(len(rows))
        for n in range(len(rows)):
            out[n] = function(rows[n, 0], rows[n, 1])  # type: ignore[operator]
        return out

    found: np.ndarray = (of_one if len(arguments) == 1 else of_two)(np.column_stack(arguments))
    return found


@pytest.mark.parametrize("reach", [3.2, 100.0, 1e5])
@pytest.mark.parametrize(("name", "exact"), [("sine", np.sin), ("cosine", np.cos)])
def test_sine_and_cosine(name: str, exact: np.ufunc, reach: float) -> None:
    x = np.concatenate([np.linspace(-reach, reach, 20_001), np.arange(-8, 9) * np.pi / 4])
    error = np.abs(over(getattr(elementary, name), x) - exact(x))
    assert (error <= np.maximum(2 * ULP * np.abs(exact(x)), 1e-15)).all()


def test_arctangent_in_all_directions_and_sizes() -> None:
    rng = np.random.default_rng(1)
    y, x = rng.standard_normal((2, 20_000)) * 10 ** rng.uniform(-9, 9, (2, 20_000))
    ends = np.array([[0.0, 1.0], [0.0, -1.0], [1.0, 0.0], [-1.0, 0.0], [1.0, 1.0], [-1.0, 1.0], [0.0, 0.0]]).T
    y, x = np.concatenate([y, ends[0]]), np.concatenate([x, ends[1]])
    exact = np.arctan2(y, x)
    assert (np.abs(over(elementary.arctangent, y, x) - exact) <= 2 * ULP * np.abs(exact)).all()


def test_arcsine_and_tangent() -> None:
    x = np.linspace(-1, 1, 4001)
    assert np.abs(over(elementary.arcsine, x) - np.arcsin(x)).max() <= 1e-15
    t = np.tan(1.5 * x)
    assert (np.abs(over(elementary.tangent, 1.5 * x) - t) <= 1e-14 * np.maximum(np.abs(t), 1e-2)).all()


def test_what_is_no_number_goes_through() -> None:
    nan = np.array([np.nan])
    assert np.isnan(over(elementary.sine, nan)).all()
    assert np.isnan(over(elementary.arctangent, nan, np.ones(1))).all()
    assert np.isnan(over(elementary.arcsine, np.array([1.1]))).all()
