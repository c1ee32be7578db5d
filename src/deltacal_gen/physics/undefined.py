"""Rows at which an effect has no value: its formula divides by zero there, or what it remembers cannot be followed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.body import Body, follows, states_read
from deltacal_gen.physics.terms import Term, remembers


def undefined(body: Body, term: Term, x: Array, q: Array, rows: Array) -> np.ndarray:
    """Return the rows (N,) at which an effect does not say by how much it moves, though all that it reads is known.

    Parameters
    ----------
    x, q, rows : (N, 12), (N, n_q), (1 or N, limbs, n_p) arrays
        A solved pose, joints as the geometry sees them, and parameters. Rows without a pose are none of these, where
        the effect follows it.
    """
    state = body.state(states_read([term]), x, q, rows, body.pulled([term]))
    read, N = body.read(term, state), len(body.q)
    with np.errstate(all="ignore"):
        moved = body.moved([term], state).values()
        slopes = body.derivatives(term, read, body.coefficients(term) if term.values.any() else term.values[:1])
    found = np.isfinite(slopes).reshape(N, -1).all(axis=1)
    for value in moved:
        found &= np.isfinite(value).reshape(N, -1).all(axis=1)
    known = np.isfinite(read).reshape(N, -1).all(axis=1)
    if follows(term):
        known &= np.isfinite(x).all(axis=1)
    return np.asarray(known & ~found)


def lacking(term: Term, lines: Sequence[int]) -> str:
    """Return what an effect lacks that is undefined at rows of these lines, as a noun."""
    where = f"line {lines[0]}" + (f" and {len(lines) - 1} more" if len(lines) > 1 else "")
    if remembers(term.kernels):
        return f"rows closer in time: what it remembers cannot be followed to {where}"
    return f"a value at {where}: its formula divides by zero there, or grows beyond all bounds"
