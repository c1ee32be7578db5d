"""The joint twists under the payload's torque only: ``theta = q + compliance torque_of_the_payload``."""

from derive.effects import DEG, joint_coefficient, state
from derive.language.effects import Effect, Reference

(torque,) = state("payload_torque")
compliance = joint_coefficient("compliance", "Nm", "twist per torque of the payload", (0.0, 1.0))
EFFECT = Effect(
    name="payload_deflection",
    title="joint twists under the payload",
    advice="Check the gearbox and its fixing for softness. The deflection repeats with the payload, so that "
    "commands by it undo it.",
    source="derive/effects/payload_deflection.py",
    per_limb=True,
    coefficients=(compliance,),
    targets={"joint": compliance.symbol * torque},
    tests=(Reference({"payload_torque": -1500.0}, {"compliance": 0.02}, {"joint": -0.03 * DEG}),),
)
