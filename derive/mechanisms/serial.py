r"""An open chain of links by Denavit and Hartenberg: its closure is its last frame minus the measured one.

One link is derived, the runtime puts links one behind the other; no kernel belongs to one robot. With the joint's
variable in `turn` (a revolute joint) or `slide` (a prismatic one), a link leads from frame i - 1 to frame i::

    standard   Rz(about_z) Tz(along_z) Tx(along_x) Rx(about_x) Ry(about_y)
    modified   Rx(about_x) Ry(about_y) Tx(along_x) Rz(about_z) Tz(along_z)

    about_z = theta + turn    along_z = d + slide    along_x = a    about_x = alpha    about_y = beta

each of the five with its own error.
`beta` is zero by definition. As an error it turns neighbouring axes that are nominally parallel out of their common
plane, which alpha, a, theta and d cannot do without jumps (Hayati 1983).
"""

from __future__ import annotations

import sympy as sp

from derive.spec import ChainMechanism, GeometryKey, Quantity, Screw
from derive.vectors import Algebra

DEG = float(sp.pi) / 180

turn, slide, a, alpha, d, theta = sp.symbols("turn slide a alpha d theta", real=True)
about_z, along_z, along_x, about_x, about_y = sp.symbols("about_z along_z along_x about_x about_y", real=True)
da, dalpha, dd, dtheta, dbeta = sp.symbols("da dalpha dd dtheta dbeta", real=True)
tx, ty, tz, dtx, dty, dtz = sp.symbols("tx ty tz dtx dty dtz", real=True)

screw_z, screw_x, tilt = Screw("z", about_z, along_z), Screw("x", about_x, along_x), Screw("y", about_y, sp.Integer(0))

MACHINE = ChainMechanism(
    name="serial",
    title="Open chain of revolute and prismatic joints",
    reference="Denavit, Hartenberg 1955, J. Appl. Mech. 22; Craig 1986; Hayati 1983, IEEE CDC 22",
    source="derive/mechanisms/serial.py",
    joint=(
        Quantity(turn, "rad", "variable of a revolute joint"),
        Quantity(slide, "mm", "variable of a prismatic joint"),
    ),
    geometry=(
        GeometryKey("a", Quantity(a, "mm", "a: length of the link"), table="joint", per_limb=True, positive=False),
        GeometryKey("alpha", Quantity(alpha, "rad", "alpha: twist"), table="joint", per_limb=True),
        GeometryKey("d", Quantity(d, "mm", "d: offset along the axis"), table="joint", per_limb=True, positive=False),
        GeometryKey("theta", Quantity(theta, "rad", "theta: added to the reading"), table="joint", per_limb=True),
    ),
    errors=(
        Quantity(da, "mm", "length of the link", typical=0.3, label="a"),
        Quantity(dalpha, "rad", "twist", typical=0.1 * DEG, label="alpha"),
        Quantity(dd, "mm", "offset along the axis", typical=0.3, label="d"),
        Quantity(dtheta, "rad", "zero of the joint", typical=0.1 * DEG, label="theta"),
        Quantity(dbeta, "rad", "turn about y between parallel axes", typical=0.1 * DEG, label="beta"),
    ),
    tool=tuple(
        Quantity(t, "mm", f"tool point, {a} of the last frame") for t, a in zip((tx, ty, tz), "xyz", strict=True)
    ),
    common=tuple(
        Quantity(e, "mm", f"tool point, {str(e)[2]} of the last frame", label=str(e)[1:]) for e in (dtx, dty, dtz)
    ),
    transforms={
        "standard": (screw_z, screw_x, tilt),
        "modified": (Screw("x", about_x, sp.Integer(0)), tilt, Screw("x", sp.Integer(0), along_x), screw_z),
    },
    steps=(
        (about_z, theta + dtheta + turn),
        (along_z, d + dd + slide),
        (along_x, a + da),
        (about_x, alpha + dalpha),
        (about_y, dbeta),
    ),
)


def mechanism(v: Algebra) -> ChainMechanism:
    """Return the chain: its screws turn about axes of frames, so that no rotation is written out in it."""
    return MACHINE
