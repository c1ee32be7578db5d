"""Geometry that the model in use leaves out: the towers of a linear delta lean about their feet."""

from derive.effects import DEG, coefficient
from derive.language.effects import Effect, Reference

radial = coefficient("radial", "deg", DEG, "lean outwards", (-5.0, 5.0))
tangential = coefficient("tangential", "deg", DEG, "lean counter-clockwise", (-5.0, 5.0))
EFFECT = Effect(
    name="tower_lean",
    title="the towers lean",
    source="derive/effects/tower_lean.py",
    advice="Geometry, not physics: set the towers upright with a square, or identify with linear_delta/21.",
    per_limb=True,
    coefficients=(radial, tangential),
    targets={"limb.lean_radial": radial.symbol, "limb.lean_tangential": tangential.symbol},
    tests=(
        Reference(
            {}, {"radial": 0.1, "tangential": -0.2}, {"limb.lean_radial": 0.1 * DEG, "limb.lean_tangential": -0.2 * DEG}
        ),
    ),
)
