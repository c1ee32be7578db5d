"""Named steps: a derivation as a human writes it down, and where each line of it stands."""

from __future__ import annotations

import inspect
from typing import Any, TypeVar

import sympy as sp

Value = TypeVar("Value", sp.Expr, sp.Matrix)


class Derivation(list[tuple[sp.Symbol, sp.Expr]]):
    """Named scalar definitions in order, as a `Graph` reads them; a vector or matrix is named entry by entry.

    Attributes
    ----------
    written : dict
        Name of each step to what stands for it in later steps: a symbol, or a vector or matrix of symbols.
    lines : dict
        Name of each step to the line of the source file that makes it.
    """

    def __init__(self) -> None:
        super().__init__()
        self.written: dict[str, Any] = {}
        self.lines: dict[str, int] = {}

    def step(self, name: str, value: Value) -> Value:
        """Name a scalar, vector or matrix; the derivation goes on with what is returned.

        Entries are called ``name_x``, ``name_y``, ``name_z`` in a vector, ``name_11`` ... in a matrix. An entry that
        is zero stays zero: a machine in the plane has no third components.
        """
        if name in self.written:
            raise ValueError(f"the step '{name}' is named twice.")
        caller = inspect.currentframe()
        self.lines[name] = caller.f_back.f_lineno if caller is not None and caller.f_back is not None else 0
        if not isinstance(value, sp.MatrixBase):
            self.written[name] = self._entry(name, value)
        else:
            rows, columns = value.shape
            ends = [f"{'xyz'[r]}" if columns == 1 else f"{r + 1}{c + 1}" for r in range(rows) for c in range(columns)]
            entries = [self._entry(f"{name}_{end}", e) for end, e in zip(ends, value, strict=True)]
            self.written[name] = sp.Matrix(rows, columns, entries)
        return self.written[name]

    def _entry(self, name: str, value: sp.Expr) -> sp.Expr:
        value = sp.sympify(value)
        if value == 0:
            return value
        self.append((sp.Symbol(name, real=True), value))
        return self[-1][0]
