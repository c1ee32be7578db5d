"""What the drive reads too much, whatever the machine does: ``offset``."""

from derive.effects import torque_coefficient
from derive.language.effects import Effect, Reference

offset = torque_coefficient("offset", "", "constant reading", (-10000.0, 10000.0))
EFFECT = Effect(
    name="torque_offset",
    title="constant torque",
    advice="A current sensor's zero, a hanging cable or a spring. Zero the sensor with the drive off.",
    source="derive/effects/torque_offset.py",
    per_limb=True,
    coefficients=(offset,),
    targets={"torque": offset.symbol},
    tests=(Reference({}, {"offset": -0.2}, {"torque": -200.0}),),
)
