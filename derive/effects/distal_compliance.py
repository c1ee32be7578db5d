"""Each rod is longer by the compliance times its own tension; the pair's mean and difference carry it."""

from derive.effects import coefficient, state
from derive.language.effects import Effect, Reference

one, two = state("tension_1 tension_2")
compliance = coefficient("compliance", "mm/N", 1.0, "lengthening of a rod per tension", (0.0, 1.0))
EFFECT = Effect(
    name="distal_compliance",
    title="rods stretch",
    advice="Check the rods and their ball joints for softness. Until then command by the payload.",
    source="derive/effects/distal_compliance.py",
    per_limb=True,
    coefficients=(compliance,),
    targets={"limb.rod": compliance.symbol * (one + two) / 2, "limb.rod_difference": compliance.symbol * (one - two)},
    tests=(
        Reference(
            {"tension_1": 30.0, "tension_2": 10.0},
            {"compliance": 0.002},
            {"limb.rod": 0.04, "limb.rod_difference": 0.04},
        ),
    ),
)
