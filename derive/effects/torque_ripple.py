"""Torque that repeats with the turn of the joint: ``cos cos(k q) + sin sin(k q)``.

Where the joint slides, the turn is that of the pulley that drives its belt.
"""

import sympy as sp

from derive.effects import constant, state, torque_coefficient
from derive.language.effects import Effect, Orders, Reference

(turn,) = state("turn")
cos = torque_coefficient("cos", "", "amplitude of the cosine", (-10000.0, 10000.0))
sin = torque_coefficient("sin", "", "amplitude of the sine", (-10000.0, 10000.0))
order = constant("order", "1", 1.0, "periods per turn of the joint")
EFFECT = Effect(
    name="torque_ripple",
    title="torque that repeats with the turn of the joint",
    advice="Cogging of the motor or a tooth of the gear: the order says which part turns so often. It repeats exactly, "
    "so that the feed-forward torque takes it along.",
    source="derive/effects/torque_ripple.py",
    per_limb=True,
    coefficients=(cos, sin),
    searched=(Orders(order),),
    targets={"torque": cos.symbol * sp.cos(order.symbol * turn) + sin.symbol * sp.sin(order.symbol * turn)},
    tests=(
        Reference({"turn": 4.5}, {"cos": 0.5, "sin": 0.02}, {"torque": 20.0}, {"order": 20.0}),
        Reference({"turn": 15.0}, {"cos": 0.03, "sin": 0.0}, {"torque": 15.0}, {"order": 4.0}),
    ),
)
