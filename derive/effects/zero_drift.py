"""The joint's zero moves with time: ``theta = q + rate t / 3600``."""

from derive.effects import DEG, joint_coefficient, state
from derive.language.effects import Effect, Reference

(time,) = state("time")
rate = joint_coefficient("rate", "h", "drift of the zero per hour", (-10.0, 10.0))
EFFECT = Effect(
    name="zero_drift",
    title="joint zero moves with time",
    advice="Look for a slipping coupling or an encoder that drifts. Home the joint often until it is found: a "
    "drift cannot be foretold.",
    source="derive/effects/zero_drift.py",
    per_limb=True,
    coefficients=(rate,),
    targets={"joint": rate.symbol * time / 3600},
    tests=(Reference({"time": 1800.0}, {"rate": 0.04}, {"joint": 0.02 * DEG}),),
)
