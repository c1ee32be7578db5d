"""Distance between the reference points of two poses: no frame, no unknown of the instrument (Bai 2015, eq. 12)."""

from __future__ import annotations

import sympy as sp

from derive.measurements import platform
from derive.spec import Measurement
from derive.vectors import vector

A, B = platform("_a"), platform("_b")
between = vector(*B[:3]) - vector(*A[:3])

MEASUREMENT = Measurement(
    name="distance",
    meaning="distance between the reference points of two poses [mm]",
    source="derive/measurements/distance.py",
    platforms=(A, B),
    given=(),
    unknown=(),
    reading=(sp.sqrt(between.dot(between)),),
)
