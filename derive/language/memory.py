"""States with a memory along a run: ``dz/dt = rate(z, states)``, z given at the run's first row.

`Lag` writes the common case into a formula: a state that follows another one with a time constant.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import ClassVar

import sympy as sp


@dataclass(frozen=True)
class Memory:
    """A state that follows from what happened before.

    Parameters
    ----------
    symbol : sympy.Symbol
        As it stands in the targets.
    meaning : str
        One line.
    rate : sympy.Expr
        dz/dt, by itself, states, coefficients and constants.
    start : sympy.Expr
        z at the first row of a run, by states and constants.
    """

    symbol: sp.Symbol
    meaning: str
    rate: sp.Expr
    start: sp.Expr

    def __post_init__(self) -> None:
        if not self.meaning:
            raise ValueError(f"the memory {self.symbol} has no meaning; add one line.")

    @property
    def name(self) -> str:
        """Name by which the kernels know it."""
        return str(self.symbol)


class Lag(sp.Function):
    """``Lag(state, tau)``: z with ``dz/dt = (state - z) / tau``, which is the state at the first row of a run."""

    nargs: ClassVar[int] = 2
    is_real = True


def with_lags(
    targets: Mapping[str, sp.Expr], memory: Iterable[Memory]
) -> tuple[dict[str, sp.Expr], tuple[Memory, ...]]:
    """Return targets without `Lag`, and all memories, those that stand for it among them."""
    found = sorted(set().union(*(e.atoms(Lag) for e in targets.values())), key=sp.default_sort_key)
    own = {lag: sp.Symbol(f"lag_{n}", real=True) for n, lag in enumerate(found, 1)}
    memories = [
        Memory(z, f"{lag.args[0]}, lagging by {lag.args[1]}", (lag.args[0] - z) / lag.args[1], lag.args[0])
        for lag, z in own.items()
    ]
    return {target: e.xreplace(own) for target, e in targets.items()}, (*memory, *memories)
