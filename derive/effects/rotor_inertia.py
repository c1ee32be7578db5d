"""The drive's own inertia, at the joint: ``inertia qdd``."""

from derive.effects import coefficient, state
from derive.language.effects import Effect, Reference

(qdd,) = state("qdd")
inertia = coefficient("inertia", "kg mm^2", 0.001, "of rotor and gear, counted at the joint", (0.0, 1e9))
EFFECT = Effect(
    name="rotor_inertia",
    title="inertia of the drive",
    advice="Write it into the robot file (rotor_inertia): the square of the gear ratio makes a small rotor heavy.",
    source="derive/effects/rotor_inertia.py",
    per_limb=True,
    coefficients=(inertia,),
    targets={"torque": inertia.symbol * qdd},
    tests=(Reference({"qdd": 180.0}, {"inertia": 1000.0}, {"torque": 3.141592653589793}),),
)
