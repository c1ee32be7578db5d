"""Friction that grows with the speed, as of oil: ``viscous qd``."""

from derive.effects import state, torque_coefficient
from derive.language.effects import Effect, Reference

(qd,) = state("qd")
viscous = torque_coefficient("viscous", "s/deg", "friction per speed", (0.0, 1000.0))
EFFECT = Effect(
    name="viscous_friction",
    title="friction that grows with the speed",
    advice="Every gear has some; cold or wrong grease has more. Warm the machine up, or take it along in the "
    "feed-forward torque.",
    source="derive/effects/viscous_friction.py",
    per_limb=True,
    coefficients=(viscous,),
    targets={"torque": viscous.symbol * qd},
    tests=(Reference({"qd": -30.0}, {"viscous": 0.01}, {"torque": -300.0}),),
)
