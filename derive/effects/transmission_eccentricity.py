"""Periodic error of the joint, `order` periods per turn: ``theta = q + cos cos(k q) + sin sin(k q)``.

Where the joint slides, the turn is that of the pulley that drives its belt.
"""

import sympy as sp

from derive.effects import DEG, constant, joint_coefficient, state
from derive.language.effects import Effect, Orders, Reference

(turn,) = state("turn")
cos = joint_coefficient("cos", "", "amplitude of the cosine", (-5.0, 5.0))
sin = joint_coefficient("sin", "", "amplitude of the sine", (-5.0, 5.0))
order = constant("order", "1", 1.0, "periods per turn of the joint")
EFFECT = Effect(
    name="transmission_eccentricity",
    title="periodic error of the transmission",
    advice="Check the gear or encoder disc that turns so often for eccentricity. The error repeats exactly, so "
    "that the corrected commands undo it.",
    source="derive/effects/transmission_eccentricity.py",
    per_limb=True,
    coefficients=(cos, sin),
    searched=(Orders(order),),
    targets={"joint": cos.symbol * sp.cos(order.symbol * turn) + sin.symbol * sp.sin(order.symbol * turn)},
    tests=(
        Reference({"turn": 4.5}, {"cos": 0.5, "sin": 0.02}, {"joint": 0.02 * DEG}, {"order": 20.0}),
        Reference({"turn": 15.0}, {"cos": 0.03, "sin": 0.0}, {"joint": 0.015 * DEG}, {"order": 4.0}),
    ),
)
