"""Position and rotation in the instrument's frame; the measured body is turned from {O'} by a constant unknown D.

``y = cay(w) F P + f + t`` and ``Y = cay(w) F R cay(d) D``.
"""

from __future__ import annotations

import sympy as sp

from derive.measurements import platform, position, rotation_state
from derive.spec import Measurement, Quantity
from derive.vectors import Algebra, vector

X = platform()
D, D_STATE = rotation_state("D", "rotation from the measured body to {O'}")
d = vector(*sp.symbols("dx dy dz", real=True))


def measurement(v: Algebra) -> Measurement:
    """Return the kind of measurement, its rotations written in an algebra."""
    point = position.measurement(v)
    return Measurement(
        name="pose",
        meaning="position [mm] and rotation [rad] of a body on the platform in the instrument's frame",
        source="derive/measurements/pose.py",
        platforms=(X,),
        given=(*point.given, *D_STATE),
        unknown=(
            *point.unknown,
            *(Quantity(s, "rad", "turn of the measured body about the axes of {O'}") for s in d),
        ),
        reading=point.reading,
        rotation=(v.cayley(position.w), position.F, v.cayley(X.turn), X.rotation, v.cayley(d), D),
        after=(*point.after, *(v.cayley(d) * D)),
        columns=(*point.columns, "rx_deg", "ry_deg", "rz_deg"),
        targets=point.targets,
    )
