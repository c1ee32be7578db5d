"""Height of the reference point above the bed, the plane z = 0 of {O}: no unknown of the instrument.

A bed that is mounted askew is a change of the machine's endstops and frame; one that is not flat is an effect.
"""

from __future__ import annotations

from derive.measurements import platform
from derive.spec import Measurement
from derive.vectors import Algebra

X = platform()


def measurement(v: Algebra) -> Measurement:
    """Return the kind of measurement, its rotations written in an algebra."""
    return Measurement(
        name="height",
        meaning="height of the reference point above the bed [mm]",
        source="derive/measurements/height.py",
        platforms=(X,),
        given=(),
        unknown=(),
        reading=(X.position[2],),
        columns=("height_mm",),
        targets={"height": 0},
    )
