"""Position of the reference point in the instrument's own frame: ``y = cay(w) F P + f + t``."""

from __future__ import annotations

import sympy as sp

from derive.measurements import platform, rotation_state
from derive.spec import Measurement, Quantity
from derive.vectors import Algebra, vector

X = platform()
F, F_STATE = rotation_state("F", "rotation from {O} to the instrument's frame")
f = vector(*sp.symbols("fx fy fz", real=True))
w = vector(*sp.symbols("wx wy wz", real=True))
t = vector(*sp.symbols("tx ty tz", real=True))


def measurement(v: Algebra) -> Measurement:
    """Return the kind of measurement, its rotations written in an algebra."""
    return Measurement(
        name="position",
        meaning="position of the reference point in the instrument's frame [mm]",
        source="derive/measurements/position.py",
        platforms=(X,),
        given=(*F_STATE, *(Quantity(s, "mm", "origin {O} in the instrument's frame") for s in f)),
        unknown=(
            *(Quantity(s, "rad", "turn of {O} about the instrument's axes", typical=0.3) for s in w),
            *(Quantity(s, "mm", "shift of {O} along the instrument's axes", typical=1000.0) for s in t),
        ),
        reading=tuple(v.cayley(w) * F * X.position + f + t),
        after=(*(v.cayley(w) * F), *(f + t)),
        columns=("x_mm", "y_mm", "z_mm"),
        targets={"reading.x": 0, "reading.y": 1, "reading.z": 2},
    )
