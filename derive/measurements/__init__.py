"""One file per kind of measurement; its presence is its registration (it defines ``measurement(v)``).

`v` holds the rotations in which it is written, see `derive.registry`.
"""

from __future__ import annotations

import sympy as sp

from derive.spec import Platform, Quantity
from derive.vectors import vector


def platform(suffix: str = "") -> Platform:
    """Return a platform that moves in space: its reference point, its rotation matrix, a small further turn."""
    position = sp.symbols(" ".join(f"p{axis}{suffix}" for axis in "xyz"), real=True)
    rotation = sp.Matrix(3, 3, lambda r, c: sp.Symbol(f"R{r + 1}{c + 1}{suffix}", real=True))
    return Platform(vector(*position), rotation, vector(*sp.symbols(f"sx{suffix} sy{suffix} sz{suffix}", real=True)))


def rotation_state(name: str, meaning: str) -> tuple[sp.Matrix, tuple[Quantity, ...]]:
    """Return a known rotation matrix and its nine entries as quantities."""
    entries = sp.Matrix(3, 3, lambda r, c: sp.Symbol(f"{name}{r + 1}{c + 1}", real=True))
    return entries, tuple(Quantity(s, "1", f"{meaning}, entry {str(s)[-2:]}") for s in entries)
