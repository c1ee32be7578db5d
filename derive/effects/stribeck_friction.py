"""More friction near rest than in motion: ``stribeck sign(qd) exp(-(qd / velocity)^2)``."""

import sympy as sp

from derive.effects import DEG, constant, state, torque_coefficient
from derive.language.effects import Effect, Reference, Sizes

(qd,) = state("qd")
stribeck = torque_coefficient("stribeck", "", "friction that motion takes away", (0.0, 10000.0))
velocity = constant("velocity", "deg/s", DEG, "speed at which most of it is gone", of_joint=True)
EFFECT = Effect(
    name="stribeck_friction",
    title="more friction near rest than in motion",
    advice="A joint that sticks: look at the lubrication, and avoid creeping moves.",
    source="derive/effects/stribeck_friction.py",
    per_limb=True,
    coefficients=(stribeck,),
    searched=(Sizes(velocity, "qd"),),
    targets={"torque": stribeck.symbol * sp.sign(qd) * sp.exp(-((qd / velocity.symbol) ** 2))},
    tests=(
        Reference({"qd": -2.0}, {"stribeck": 1.0}, {"torque": -367.87944117144235}, {"velocity": 2.0}),
        Reference({"qd": 100.0}, {"stribeck": 1.0}, {"torque": 0.0}, {"velocity": 2.0}),
    ),
)
