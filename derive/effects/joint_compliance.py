"""The joint or its gearbox twists under the static torque of all weights: ``theta = q + compliance torque``."""

from derive.effects import DEG, joint_coefficient, state
from derive.language.effects import Effect, Reference

(torque,) = state("torque")
compliance = joint_coefficient("compliance", "Nm", "twist per static torque", (0.0, 1.0))
EFFECT = Effect(
    name="joint_compliance",
    title="joint or gearbox twists under the load",
    advice="Check the gearbox and its fixing for softness. The deflection repeats with the load, so that "
    "commands by the payload undo it.",
    source="derive/effects/joint_compliance.py",
    per_limb=True,
    coefficients=(compliance,),
    targets={"joint": compliance.symbol * torque},
    tests=(Reference({"torque": -2000.0}, {"compliance": 0.01}, {"joint": -0.02 * DEG}),),
)
