"""The gear ratio or the encoder's scale is off: ``theta = q + scale q``."""

from derive.effects import coefficient, state
from derive.spec import Effect

(q,) = state("q")
scale = coefficient("scale", "1", 1.0, "error of the scale")
EFFECT = Effect(
    name="joint_scale",
    title="gear ratio or encoder scale is off",
    advice="Check the gear ratio and the encoder's counts per turn in the controller, and correct them there.",
    source="derive/effects/joint_scale.py",
    per_limb=True,
    coefficients=(scale,),
    targets={"joint": scale.symbol * q},
)
