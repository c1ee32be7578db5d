"""Friction by the square of the speed: ``quadratic qd |qd|``."""

import sympy as sp

from derive.effects import state, torque_coefficient
from derive.language.effects import Effect, Reference

(qd,) = state("qd")
quadratic = torque_coefficient("quadratic", "s^2/deg^2", "friction per square of the speed", (-10.0, 10.0))
EFFECT = Effect(
    name="quadratic_friction",
    title="friction by the square of the speed",
    advice="Churned oil or air gives more of it than in proportion, grease that thins less (a negative one). Take it "
    "along in the feed-forward torque.",
    source="derive/effects/quadratic_friction.py",
    per_limb=True,
    coefficients=(quadratic,),
    targets={"torque": quadratic.symbol * qd * sp.Abs(qd)},
    tests=(Reference({"qd": -30.0}, {"quadratic": 0.001}, {"torque": -900.0}),),
)
