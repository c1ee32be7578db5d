"""The joint's zero moves with temperature: ``theta = q + drift (T - 20)``."""

from derive.effects import DEG, joint_coefficient, state
from derive.language.effects import Effect, Reference

(warming,) = state("warming")
drift = joint_coefficient("drift", "K", "drift of the zero", (-1.0, 1.0))
EFFECT = Effect(
    name="thermal_zero",
    title="joint zero moves with temperature",
    advice="Look for what moves the encoder or its coupling with heat. Until then command by the temperature, or "
    "home again when it has changed.",
    source="derive/effects/thermal_zero.py",
    per_limb=True,
    coefficients=(drift,),
    targets={"joint": drift.symbol * warming},
    tests=(Reference({"warming": 5.0}, {"drift": 0.002}, {"joint": 0.01 * DEG}),),
)
