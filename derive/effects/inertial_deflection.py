"""The joint twists under the masses times minus their acceleration: ``theta = q + compliance torque``."""

from derive.effects import DEG, joint_coefficient, state
from derive.language.effects import Effect, Reference

(torque,) = state("inertia_torque")
compliance = joint_coefficient("compliance", "Nm", "twist per torque of inertia", (0.0, 1.0))
EFFECT = Effect(
    name="inertial_deflection",
    title="joint twists with acceleration",
    advice="Let the machine settle before it is measured or grips, or accelerate less. The transmission gives "
    "way to inertia.",
    source="derive/effects/inertial_deflection.py",
    per_limb=True,
    coefficients=(compliance,),
    targets={"joint": compliance.symbol * torque},
    tests=(Reference({"inertia_torque": 4000.0}, {"compliance": 0.005}, {"joint": 0.02 * DEG}),),
)
