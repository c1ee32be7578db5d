"""Geometry that the model in use leaves out: the towers of a linear delta lean about their feet."""

from derive.effects import DEG, coefficient
from derive.spec import Effect

radial = coefficient("radial", "deg", DEG, "lean outwards")
tangential = coefficient("tangential", "deg", DEG, "lean counter-clockwise")
EFFECT = Effect(
    name="tower_lean",
    title="the towers lean",
    source="derive/effects/tower_lean.py",
    advice="Geometry, not physics: set the towers upright with a square, or identify with linear_delta/21.",
    per_limb=True,
    coefficients=(radial, tangential),
    targets={"limb.lean_radial": radial.symbol, "limb.lean_tangential": tangential.symbol},
)
