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


def test_exponential_to_the_ends_of_the_numbers() -> None:
    x = np.concatenate([np.linspace(-40, 40, 20_001), np.linspace(-745, 709.7, 5001), [0.0, 1e-300, -1e-17]])
    exact = np.exp(x)
    error = np.abs(over(elementary.exponential, x) - exact)
    assert (error <= np.maximum(2 * ULP * exact, 5e-324)).all()
    ends = over(elementary.exponential, np.array([710.0, np.inf, -760.0, -np.inf]))
    assert ends.tolist() == [np.inf, np.inf, 0.0, 0.0]


def test_logarithm_of_all_sizes() -> None:
    rng = np.random.default_rng(2)
    x = np.concatenate(
        [10 ** rng.uniform(-320, 308, 20_000), 1 + rng.uniform(-0.5, 1, 20_000), 2.0 ** np.arange(-1074, 1024)]
    )
    exact = np.log(x)
    assert (np.abs(over(elementary.logarithm, x) - exact) <= 2 * ULP * np.abs(exact)).all()
    ends = over(elementary.logarithm, np.array([0.0, 1.0, np.inf, -1.0, -np.inf]))
    np.testing.assert_array_equal(ends, [-np.inf, 0.0, np.inf, np.nan, np.nan])


def test_hyperbolic_tangent() -> None:
    x = np.concatenate([np.linspace(-25, 25, 20_001), np.linspace(-0.7, 0.7, 20_001), [1e-300, 800.0, -np.inf]])
    exact = np.tanh(x)
    assert (np.abs(over(elementary.hyperbolic_tangent, x) - exact) <= 2 * ULP * np.abs(exact)).all()


def test_the_larger_and_the_smaller() -> None:
    a, b = np.array([1.0, 3.0, 2.0, np.nan, 1.0, -np.inf]), np.array([2.0, 1.0, 2.0, 1.0, np.nan, 4.0])
    np.testing.assert_array_equal(over(elementary.larger, a, b), np.maximum(a, b))
    np.testing.assert_array_equal(over(elementary.smaller, a, b), np.minimum(a, b))


def test_what_is_no_number_goes_through() -> None:
    nan = np.array([np.nan])
    assert np.isnan(over(elementary.exponential, nan)).all()
    assert np.isnan(over(elementary.logarithm, nan)).all()
    assert np.isnan(over(elementary.hyperbolic_tangent, nan)).all()
    assert np.isnan(over(elementary.sine, nan)).all()
    assert np.isnan(over(elementary.arctangent, nan, np.ones(1))).all()
    assert np.isnan(over(elementary.arcsine, np.array([1.1]))).all()
