"""The gear ratio or the encoder's scale is off: ``theta = q + scale q``."""

from derive.effects import DEG, coefficient, state
from derive.language.effects import Effect, Reference

(q,) = state("q")
# one tooth of forty: a ratio farther off is another one, a mistake in the controller
scale = coefficient("scale", "1", 1.0, "error of the scale", (-0.025, 0.025))
EFFECT = Effect(
    name="joint_scale",
    title="gear ratio or encoder scale is off",
    advice="Check the gear ratio and the encoder's counts per turn in the controller, and correct them there.",
    source="derive/effects/joint_scale.py",
    per_limb=True,
    coefficients=(scale,),
    targets={"joint": scale.symbol * q},
    tests=(Reference({"q": 50.0}, {"scale": 0.001}, {"joint": 0.05 * DEG}),),
)
