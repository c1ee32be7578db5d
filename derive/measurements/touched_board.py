"""Points of a flat printed board that the tip touches: ``y = (cay(w) F P + f + t) / (1 + scale)``.

The board's frame has x and y along the print and z off it, where all its points have z = 0. What is printed may be
larger than it says by a common scale.
"""

from __future__ import annotations

import sympy as sp

from derive.measurements import platform, position
from derive.spec import Measurement, Quantity
from derive.vectors import Algebra

X = platform()
scale, dscale = sp.symbols("scale dscale", real=True)


def measurement(v: Algebra) -> Measurement:
    """Return the kind of measurement, its rotations written in an algebra."""
    point = position.measurement(v)
    return Measurement(
        name="touched_board",
        meaning="point of a printed board that the reference point touches, in the print's coordinates [mm]",
        source="derive/measurements/touched_board.py",
        platforms=(X,),
        given=(*point.given, Quantity(scale, "1", "by how much the print is larger than it says")),
        unknown=(
            *point.unknown,
            Quantity(dscale, "1", "by how much the print is larger than it says", typical=0.002, label="board_scale"),
        ),
        reading=tuple(e / (1 + scale + dscale) for e in point.reading),
        after=(*point.after, scale + dscale),
        columns=("board_x_mm", "board_y_mm", "board_z_mm"),
        targets={"reading.x": 0, "reading.y": 1, "reading.z": 2},
    )
