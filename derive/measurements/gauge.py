"""Length between a point fixed to the base and the reference point: linear scale, ball bar, draw wire.

``y = |P - g - m| + zero``: the mounted base point `g` is off by `m`, and a gauge that counts from its first reading
has an unknown zero.
"""

from __future__ import annotations

import sympy as sp

from derive.measurements import platform
from derive.spec import Measurement, Quantity
from derive.vectors import Algebra, vector

X = platform()
g = vector(*sp.symbols("gx gy gz", real=True))
m = vector(*sp.symbols("mx my mz", real=True))
zero, dzero = sp.symbols("zero dzero", real=True)
length = X.position - g - m


def measurement(v: Algebra) -> Measurement:
    """Return the kind of measurement, its rotations written in an algebra."""
    return Measurement(
        name="gauge",
        meaning="length from a point of the base to the reference point [mm]",
        source="derive/measurements/gauge.py",
        platforms=(X,),
        given=(
            *(Quantity(s, "mm", "base point of the gauge in {O}") for s in g),
            Quantity(zero, "mm", "zero of the gauge"),
        ),
        unknown=(
            *(Quantity(s, "mm", "error of the base point in {O}") for s in m),
            Quantity(dzero, "mm", "error of the gauge's zero"),
        ),
        reading=(sp.sqrt(length.dot(length)) + zero + dzero,),
        after=(*(g + m), zero + dzero),
        columns=("gauge_mm",),
        targets={"length": 0},
    )
