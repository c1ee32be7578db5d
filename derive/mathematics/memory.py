"""How a memory goes on from one row of a run to the next, and its derivatives.

Between two rows states go straight. Over an interval of length h ::

    z(h) = z + h phi_1(h J) f(z, s) + h phi_2(h J) (f(z, s') - f(z, s)),    J = df/dz (z, (s + s') / 2)

with the states s at its begin and s' at its end: the exponential Rosenbrock-Euler rule (Hochbruck and Ostermann,
Acta Numerica 2010, section 2.4), the rate's change by the states taken as a difference. It is exact for a rate that is
linear in z and in the states, with a constant factor of z, as that of a lag; else its error is of third order in h.
However stiff the rate, the rule stays where z goes.
"""

from __future__ import annotations

from collections.abc import Sequence

import sympy as sp

from derive.backends.ir import Place
from derive.graph import Graph
from derive.language.memory import Memory
from derive.mathematics.derivative import derivative
from derive.mathematics.functions import Functions, Inputs, entries

TERMS = 18  # of the series of phi: less than 1e-17 is left of them for |x| < 1
INTERVAL = sp.Symbol("h", real=True)


def phi(n: int, x: sp.Expr) -> sp.Expr:
    """Return ``phi_1 = (e^x - 1) / x`` or ``phi_2 = (e^x - 1 - x) / x^2``, a series where both cancel."""
    series: sp.Expr = sp.Integer(0)
    for k in reversed(range(TERMS)):
        series = sp.Rational(1, sp.factorial(k + n)) + x * series
    closed = (sp.exp(x) - sum(x**k / sp.factorial(k) for k in range(n))) / x**n
    return sp.Piecewise((series, sp.Abs(x) < 1), (closed, True))


def memory_functions(memories: Sequence[Memory], states: Sequence[sp.Symbol], inputs: Inputs) -> list[Functions]:
    """Return `start`, z of each memory at a run's first row, and `step`, what becomes of it over an interval.

    `step` gives for each memory z at the interval's end, its derivative by z at the begin, and those by the
    coefficients, which stand in the array c of `inputs`, at fixed z.

    Parameters
    ----------
    states : sequence of sympy.Symbol
        What the rates read, in the order in which they stand in s (at the begin) and ``to`` (at the end).
    inputs : mapping
        Where states, coefficients and constants stand.
    """
    coefficients = [s for s, place in inputs.items() if place.array == "c"]
    later = {s: sp.Symbol(f"{s}_to", real=True) for s in states}
    start = Functions(Graph(), {}, inputs)
    start.add("start", "memories at the first row of a run", [m.start for m in memories])
    places = {**inputs, **entries("to", list(later.values())), **entries("z", [m.symbol for m in memories])}
    steps: list[tuple[sp.Symbol, sp.Expr]] = []
    outputs: list[sp.Expr] = []

    def named(name: str, value: sp.Expr) -> sp.Symbol:
        steps.append((sp.Symbol(name, real=True), value))
        return steps[-1][0]

    for m in memories:
        z, middle = m.symbol, {s: (s + to) / 2 for s, to in later.items()}
        slope = derivative(m.rate, z).xreplace(middle)
        change = m.rate.xreplace(later) - m.rate
        x = named(f"x_{z}", INTERVAL * slope)
        phis = [named(f"phi{n}_{z}", phi(n, x)) for n in (1, 2)]
        slopes = [named(f"dphi{n}_{z}", derivative(phi(n, x), x)) for n in (1, 2)]
        outputs.append(z + INTERVAL * (phis[0] * m.rate + phis[1] * change))
        for by in (z, *coefficients):
            x_by = INTERVAL * derivative(slope, by)
            parts = [
                f * derivative(g, by) + d * x_by * g for f, d, g in zip(phis, slopes, (m.rate, change), strict=True)
            ]
            outputs.append(derivative(z, by) + INTERVAL * sp.Add(*parts))
    step = Functions(Graph(steps), {}, {**places, INTERVAL: Place("h")})
    step.add(
        "step", "memories at the end of an interval, derivatives by those at its begin and by coefficients", outputs
    )
    return [start, step]
