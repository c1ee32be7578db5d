"""Named steps: a derivation as a human writes it down, and where each line of it stands."""

from __future__ import annotations

import sys
from typing import Any, TypeVar

import sympy as sp

Value = TypeVar("Value", sp.Expr, sp.Matrix)


def _caller() -> int:
    """Return the line of the source file that called the method in which this is called."""
    return sys._getframe(2).f_lineno


class Derivation(list[tuple[sp.Symbol, sp.Expr]]):
    """Named scalar definitions in order, as a `Graph` reads them; a vector or matrix is named entry by entry.

    Attributes
    ----------
    written : dict
        Name of each step to what stands for it in later steps: a symbol, or a vector or matrix of symbols.
    shown : dict
        Name to vector or matrix that is no step, but that a reader knows by this name.
    lines : dict
        Name of each step, and of what is only shown, to the line of the source file that makes it.
    """

    def __init__(self) -> None:
        super().__init__()
        self.written: dict[str, Any] = {}
        self.shown: dict[str, sp.Matrix] = {}
        self.lines: dict[str, int] = {}

    def step(self, name: str, value: Value) -> Value:
        """Name a scalar, vector or matrix; the derivation goes on with what is returned.

        Entries are called ``name_x``, ``name_y``, ``name_z`` in a vector, ``name_11`` ... in a matrix. An entry that
        is zero stays zero: a machine in the plane has no third components.
        """
        if name in self.written:
            raise ValueError(f"the step '{name}' is named twice.")
        self.lines[name] = _caller()
        if not isinstance(value, sp.MatrixBase):
            self.written[name] = self._entry(name, value)
        else:
            rows, columns = value.shape
            ends = [f"{'xyz'[r]}" if columns == 1 else f"{r + 1}{c + 1}" for r in range(rows) for c in range(columns)]
            entries = [self._entry(f"{name}_{end}", e) for end, e in zip(ends, value, strict=True)]
            self.written[name] = sp.Matrix(rows, columns, entries)
        return self.written[name]

    def named(self, name: str, value: sp.Matrix) -> sp.Matrix:
        """Give a vector or matrix a name for readers and return it: kernels see its entries, as if it had none."""
        self.shown[name], self.lines[name] = value, _caller()
        return value

    def _entry(self, name: str, value: sp.Expr) -> sp.Expr:
        value = sp.sympify(value)
        if value == 0:
            return value
        self.append((sp.Symbol(name, real=True), value))
        return self[-1][0]
