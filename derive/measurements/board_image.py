"""Points of a flat printed board in a camera on the platform, or of a board on the platform in a camera beside it.

A point ``m = (1 + scale) (x, y, 0)`` of the print lies at ``e = B m + g`` in the frame of the part that the board is
fixed to, and the camera sees it at ``n = C X + h``, `X` the same point as the camera's part counts it: on the platform
``r = R^T (e - P)``, beside the machine ``q = P + R e``; `ride` tells which. The image of `n` follows the pinhole camera
with the five coefficients of Brown's lens (Brown 1966; order and signs as in OpenCV: k1 k2 p1 p2 k3).
"""

from __future__ import annotations

import sympy as sp

from derive.measurements import platform, rotation_state
from derive.spec import Measurement, Quantity
from derive.vectors import Algebra, vector

X = platform()
C, C_STATE = rotation_state("C", "rotation to the camera's frame")
B, B_STATE = rotation_state("B", "rotation from the board's frame")
w, u, h, dh, g, dg = (
    vector(*sp.symbols(" ".join(f"{name}{axis}" for axis in "xyz"), real=True))
    for name in ("w", "u", "h", "dh", "g", "dg")
)
ride, x, y, scale, dscale = sp.symbols("ride x y scale dscale", real=True)
LENS = ("fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3")
lens, dlens = (sp.symbols(" ".join(d + name for name in LENS), real=True) for d in ("", "d"))
MEANINGS = (
    *("focal length along u [px]", "focal length along v [px]"),
    *("principal point, u [px]", "principal point, v [px]"),
    *("radial distortion, square", "radial distortion, fourth power"),
    *("decentring of the lens along v", "decentring of the lens along u"),
    "radial distortion, sixth power",
)
TYPICAL = (50.0, 50.0, 30.0, 30.0, 0.1, 0.1, 0.003, 0.003, 0.1)
m, e, r, q, n = (vector(*sp.symbols(" ".join(f"{name}_{axis}" for axis in "xyz"), real=True)) for name in "merqn")
a, b, square, radial, across, down = sp.symbols("a b square radial across down", real=True)


def measurement(v: Algebra) -> Measurement:
    """Return the kind of measurement, its rotations written in an algebra."""
    turned = v.cayley(X.turn) * X.rotation
    fx, fy, cx, cy, k1, k2, p1, p2, k3 = (known + more for known, more in zip(lens, dlens, strict=True))
    return Measurement(
        name="board_image",
        meaning="image of a point of a printed board [px]",
        source="derive/measurements/board_image.py",
        platforms=(X,),
        given=(
            *C_STATE,
            *(Quantity(s, "mm", "origin of the camera's part in the camera's frame") for s in h),
            *B_STATE,
            *(Quantity(s, "mm", "origin of the print in the frame of its part") for s in g),
            Quantity(scale, "1", "by how much the print is larger than it says"),
            *(Quantity(s, "1", m) for s, m in zip(lens, MEANINGS, strict=True)),
            Quantity(ride, "1", "1 where the camera rides on the platform, 0 where the board does"),
        ),
        unknown=(
            *(Quantity(s, "rad", "turn of the camera about its own axes", typical=0.3) for s in w),
            *(Quantity(s, "mm", "shift of the camera along its own axes", typical=100.0) for s in dh),
            *(Quantity(s, "rad", "turn of the board about the axes of its part", typical=0.3) for s in u),
            *(Quantity(s, "mm", "shift of the board along the axes of its part", typical=100.0) for s in dg),
            Quantity(dscale, "1", "by how much the print is larger than it says", typical=0.002, label="board_scale"),
            *(
                Quantity(s, "1", m, typical=size, label=name + ("_px" if size >= 1 else ""))
                for s, m, size, name in zip(dlens, MEANINGS, TYPICAL, LENS, strict=True)
            ),
        ),
        reading=(cx + fx * across, cy + fy * down),
        steps=(
            *zip(m, (1 + scale + dscale) * vector(x, y, 0), strict=True),
            *zip(e, v.cayley(u) * B * m + g + dg, strict=True),  # in the frame of the part that carries the board
            *zip(r, turned.T * (e - X.position), strict=True),
            *zip(q, X.position + turned * e, strict=True),
            *zip(n, v.cayley(w) * C * (ride * r + (1 - ride) * q) + h + dh, strict=True),
            (a, n[0] / n[2]),
            (b, n[1] / n[2]),
            (square, a**2 + b**2),
            (radial, 1 + k1 * square + k2 * square**2 + k3 * square**3),
            (across, a * radial + 2 * p1 * a * b + p2 * (square + 2 * a**2)),
            (down, b * radial + p1 * (square + 2 * b**2) + 2 * p2 * a * b),
        ),
        after=(
            *(v.cayley(w) * C),
            *(h + dh),
            *(v.cayley(u) * B),
            *(g + dg),
            scale + dscale,
            *(known + more for known, more in zip(lens, dlens, strict=True)),
            ride,
        ),
        columns=("u_px", "v_px"),
        known=(
            Quantity(x, "mm", "point of the print, x", label="board_x_mm"),
            Quantity(y, "mm", "point of the print, y", label="board_y_mm"),
        ),
    )
