"""The joint's zero jumps once: ``theta = q + size`` from the jump on."""

from derive.effects import coefficient, joint_coefficient, state
from derive.spec import Effect

(after,) = state("after")
size = joint_coefficient("size", "", "size of the jump")
when = coefficient("when", "s", 1.0, "time of the jump; the row, where there is no time")
EFFECT = Effect(
    name="zero_jump",
    title="joint zero jumps once",
    advice="Look for a coupling that slipped or a collision at that time, tighten it, and home the joint. What "
    "was taught before is off by the jump.",
    source="derive/effects/zero_jump.py",
    per_limb=True,
    coefficients=(size,),
    constants=(when,),
    targets={"joint": size.symbol * after},
)
