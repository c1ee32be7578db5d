"""Geometry that the model in use leaves out: rods of a pair differ, so the effector tilts from place to place."""

from derive.effects import coefficient
from derive.language.effects import Effect, Reference

dl = coefficient("dl", "mm", 1.0, "length of rod 1 minus rod 2", (-5.0, 5.0))
EFFECT = Effect(
    name="effector_tilt",
    title="rods of a pair differ and tilt the effector",
    source="derive/effects/effector_tilt.py",
    advice="Geometry, not physics: make the two rods of each pair equally long, on a jig or by exchanging rods.",
    per_limb=True,
    coefficients=(dl,),
    targets={"limb.pair_difference": dl.symbol},
    tests=(Reference({}, {"dl": 0.3}, {"limb.pair_difference": 0.3}),),
)
