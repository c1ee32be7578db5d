"""Distance between the reference points of two poses: no frame, no unknown of the instrument (Bai 2015, eq. 12)."""

from __future__ import annotations

import sympy as sp

from derive.measurements import platform
from derive.spec import Measurement
from derive.vectors import Algebra

A, B = platform("_a"), platform("_b")
between = B.position - A.position


def measurement(v: Algebra) -> Measurement:
    """Return the kind of measurement, its rotations written in an algebra."""
    return Measurement(
        name="distance",
        meaning="distance between the reference points of two poses [mm]",
        source="derive/measurements/distance.py",
        platforms=(A, B),
        given=(),
        unknown=(),
        reading=(sp.sqrt(between.dot(between)),),
        columns=("distance_mm",),
        targets={"length": 0},
    )
