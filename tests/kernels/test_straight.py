"""Kernels that go straight from their text to LLVM: the same numbers as plain Python, and no other statements."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest
from deltacal_kernels.elementary import arctangent, sine
from deltacal_kernels.straight import straight
from numba import njit
from numba.core.errors import UnsupportedError

FLOOR = 0.25


def _every_statement(x, order, out, n):
    """Use each kind of statement and expression once."""
    first, left = x[0], 0
    for lane in range(n):
        a, b = x[lane], x[min(lane + 1, n - 1)]
        c = -a / 3 + 2 * b if (a < b) & (b != FLOOR) else abs(a - b) * math.pi
        out[lane] = c + sine(a) * math.sqrt(c * c) - max(arctangent(a, b), FLOOR)
        out[n + lane] += 1.0 if a >= first else -math.inf
        order[n - 1 - lane] = 2 * lane - 5
        left += 1 if c > 0.0 else 0
    for pair in range(0, n - 1, 2):
        out[2 * n] += x[pair + 1] - x[pair]
    return left


def _branches(x, n):
    if n > 1:
        x[0] = 1.0


def _carries(x, n):
    total = 0.0
    for lane in range(n):
        total = total + x[lane]
    x[0] = total


def _returns_within(x, n):
    for _ in range(n):
        return 1
    return 0


def _raises_to_a_power(x, n):
    x[0] = x[n] ** 4


compiled = straight(_every_statement)
refused = {
    "if n > 1": straight(_branches),
    "total = total": straight(_carries),
    "return 1": straight(_returns_within),
    "x[n] ** 4": straight(_raises_to_a_power),
}


@njit
def call(x, order, out, n):
    return compiled(x, order, out, n)


def test_a_kernel_is_what_python_makes_of_its_text() -> None:
    x = np.random.default_rng(3).normal(size=13)
    results = []
    for function in (_every_statement, call):
        order, out = np.full(13, -1), np.zeros(27)
        results.append((function(x, order, out, 13), order, out))
    (left, order, out), (other_left, other_order, other_out) = results
    assert left == other_left
    np.testing.assert_array_equal(order, other_order)
    np.testing.assert_allclose(other_out, out, rtol=1e-14, atol=1e-14)
    assert np.isneginf(out).any()


@pytest.mark.parametrize("what", refused)
def test_what_a_kernel_cannot_hold_is_told_with_its_line(what: str) -> None:
    kernel = refused[what]

    @njit
    def calling(x, n):
        kernel(x, n)

    told = rf"test_straight.py, line \d+: .* cannot hold '{re.escape(what)}"
    with pytest.raises(UnsupportedError, match=told):
        calling(np.zeros(3), 2)
