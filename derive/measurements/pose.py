"""Position and rotation in the instrument's frame; the measured body is turned from {O'} by a constant unknown D.

``y = cay(w) F P + f + t`` and ``Y = cay(w) F R cay(d) D``.
"""

from __future__ import annotations

import sympy as sp

from derive.measurements import platform, position, rotation_state
from derive.spec import Measurement, Quantity
from derive.vectors import cayley, vector

X = platform()
D, D_STATE = rotation_state("D", "rotation from the measured body to {O'}")
d = vector(*sp.symbols("dx dy dz", real=True))

MEASUREMENT = Measurement(
    name="pose",
    meaning="position [mm] and rotation [rad] of a body on the platform in the instrument's frame",
    source="derive/measurements/pose.py",
    platforms=(X,),
    given=(*position.MEASUREMENT.given, *D_STATE),
    unknown=(
        *position.MEASUREMENT.unknown,
        *(Quantity(s, "rad", "turn of the measured body about the axes of {O'}") for s in d),
    ),
    reading=position.MEASUREMENT.reading,
    rotation=(cayley(position.w), position.F, cayley(X.turn), X.rotation, cayley(d), D),
    after=(*position.MEASUREMENT.after, *(cayley(d) * D)),
    columns=(*position.MEASUREMENT.columns, "rx_deg", "ry_deg", "rz_deg"),
    targets=position.MEASUREMENT.targets,
)
