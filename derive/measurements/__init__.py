"""One file per kind of measurement; a file's presence is its registration (it defines ``MEASUREMENT``)."""

from __future__ import annotations

import sympy as sp

from derive.spec import Quantity


def platform(suffix: str = "") -> tuple[sp.Symbol, ...]:
    """Return the symbols of a platform that moves in space: reference point and Cayley vector of its rotation."""
    return sp.symbols(" ".join(f"{s}{suffix}" for s in ("px", "py", "pz", "cx", "cy", "cz")), real=True)


def rotation_state(name: str, meaning: str) -> tuple[sp.Matrix, tuple[Quantity, ...]]:
    """Return a known rotation matrix and its nine entries as quantities."""
    entries = sp.Matrix(3, 3, lambda r, c: sp.Symbol(f"{name}{r + 1}{c + 1}", real=True))
    return entries, tuple(Quantity(s, "1", f"{meaning}, entry {str(s)[-2:]}") for s in entries)
