"""Extremes of a ball's image in a camera on the platform (Traslosheros 2013, section 5.2).

The ball's centre in the camera's frame is ``c = cay(w) F r``, where ``r = R^T (g + t - P)``: the camera turns and moves
with the platform, the ball stands at `g` in {O}. A plane ``X = a Z`` through the optical centre touches the ball where
``(c_x - a c_z)^2 = R^2 (1 + a^2)`` (equation (11)); of all rays that touch the ball those in the two planes reach
furthest in x, so the extremes of the image follow without a detour over its ellipse. Each touches at
``y = c_y (1 + a^2) / (c_z + a c_x)``.

Radial distortion moves the image point by the factor ``1 + k1 r^2``. Along the outline, which bends by `x''`, it also
shifts which point is the extreme: there the coordinate is larger by ``-(2 k1 x y)^2 / (2 D)``, where `D` is the second
derivative of the distorted coordinate.
"""

from __future__ import annotations

import sympy as sp

from derive.measurements import platform, rotation_state
from derive.spec import Measurement, Quantity
from derive.vectors import Algebra, vector

X = platform()
F, F_STATE = rotation_state("F", "rotation from {O'} to the camera's frame")
g = vector(*sp.symbols("gx gy gz", real=True))
w = vector(*sp.symbols("wx wy wz", real=True))
t = vector(*sp.symbols("tx ty tz", real=True))
fu, fv, u0, v0, k1, dk1, radius = sp.symbols("fu fv u0 v0 k1 dk1 radius", real=True)
order_u, order_v = sp.symbols("order_u order_v", real=True)

r, c = (vector(*sp.symbols(" ".join(f"{name}_{axis}" for axis in "xyz"), real=True)) for name in "rc")
k = sp.Symbol("k", real=True)


def measurement(v: Algebra) -> Measurement:
    """Return the kind of measurement, its rotations written in an algebra."""
    from_platform = (v.cayley(X.turn) * X.rotation).T * (g + t - X.position)
    steps = [*zip(r, from_platform, strict=True), *zip(c, v.cayley(w) * F * r, strict=True), (k, k1 + dk1)]

    def extreme(name: str, along: sp.Expr, across: sp.Expr, side: sp.Expr) -> sp.Expr:
        """Return an extreme of the distorted image, `along` the axis in question, in units of the focal length."""
        x, y, bend, second = sp.symbols(" ".join(f"{name}_{part}" for part in ("x", "y", "bend", "second")), real=True)
        depth = c[2]
        far = along**2 + depth**2 - radius**2  # square of the tangents' length, seen along `across`
        tangents = far + across**2
        steps.extend(
            (
                (x, (along * depth + side * radius * sp.sqrt(far)) / (depth**2 - radius**2)),
                (y, across * (1 + x**2) / (depth + x * along)),
                (bend, far / ((x * along + y * across + depth) * along - tangents * x)),  # x'' along the outline
                (second, bend * (1 + k * (3 * x**2 + y**2)) + 2 * k * x),
            )
        )
        return x * (1 + k * (x**2 + y**2)) - (2 * k * x * y) ** 2 / (2 * second)

    return Measurement(
        name="sphere",
        meaning="extremes of a ball's image [px]",
        source="derive/measurements/sphere.py",
        platforms=(X,),
        given=(
            *F_STATE,
            *(Quantity(s, "mm", "centre of the ball in {O}") for s in g),
            Quantity(fu, "1", "focal length along u [px]"),
            Quantity(fv, "1", "focal length along v [px]"),
            Quantity(u0, "1", "principal point, u [px]"),
            Quantity(v0, "1", "principal point, v [px]"),
            Quantity(k1, "1", "radial distortion"),
            Quantity(radius, "mm", "radius of the ball"),
            Quantity(order_u, "1", "1 where u1 is the larger extreme, -1 where it is the smaller"),
            Quantity(order_v, "1", "1 where v1 is the larger extreme, -1 where it is the smaller"),
        ),
        unknown=(
            *(Quantity(s, "rad", "turn of the camera about its own axes", typical=0.03) for s in w),
            *(Quantity(s, "mm", "shift of the ball in {O}") for s in t),
            Quantity(dk1, "1", "error of the radial distortion"),
        ),
        reading=(
            u0 + fu * extreme("u1", c[0], c[1], order_u),
            u0 + fu * extreme("u2", c[0], c[1], -order_u),
            v0 + fv * extreme("v1", c[1], c[0], order_v),
            v0 + fv * extreme("v2", c[1], c[0], -order_v),
        ),
        steps=tuple(steps),
        after=(*(v.cayley(w) * F), *(g + t), fu, fv, u0, v0, k1 + dk1, radius, order_u, order_v),
        columns=("u1_px", "u2_px", "v1_px", "v2_px"),
    )
