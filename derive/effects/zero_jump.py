"""The joint's zero jumps once: ``theta = q + size`` from the jump on."""

from derive.effects import DEG, constant, joint_coefficient, state
from derive.language.effects import Effect, Moments, Reference

(after,) = state("after")
size = joint_coefficient("size", "", "size of the jump", (-30.0, 30.0))
when = constant("when", "s", 1.0, "time of the jump; the row, where there is no time")
EFFECT = Effect(
    name="zero_jump",
    title="joint zero jumps once",
    advice="Look for a coupling that slipped or a collision at that time, tighten it, and home the joint. What "
    "was taught before is off by the jump.",
    source="derive/effects/zero_jump.py",
    per_limb=True,
    coefficients=(size,),
    searched=(Moments(when),),
    targets={"joint": size.symbol * after},
    tests=(
        Reference({"after": 1.0}, {"size": 0.05}, {"joint": 0.05 * DEG}, {"when": 3600.0}),
        Reference({"after": 0.0}, {"size": 0.05}, {"joint": 0.0}, {"when": 3600.0}),
    ),
)
