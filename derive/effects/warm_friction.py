"""Viscous friction that changes with the temperature: ``(T - 20) warm qd``."""

from derive.effects import state, torque_coefficient
from derive.language.effects import Effect, Reference

qd, warming = state("qd warming")
warm = torque_coefficient("warm", "s/(deg K)", "viscous friction per temperature", (-100.0, 100.0))
EFFECT = Effect(
    name="warm_friction",
    title="friction that changes with the temperature",
    advice="Grease thins while the machine warms up. Warm it up before it works, or take the temperature along in the "
    "feed-forward torque.",
    source="derive/effects/warm_friction.py",
    per_limb=True,
    coefficients=(warm,),
    targets={"torque": warming * warm.symbol * qd},
    tests=(Reference({"qd": 30.0, "warming": 10.0}, {"warm": -0.002}, {"torque": -600.0}),),
)
