"""Periodic error of the joint angle, `order` periods per turn: ``theta = q + cos cos(k q) + sin sin(k q)``."""

import sympy as sp

from derive.effects import DEG, coefficient, state
from derive.spec import Effect

(q,) = state("q")
cos = coefficient("cos", "deg", DEG, "amplitude of the cosine")
sin = coefficient("sin", "deg", DEG, "amplitude of the sine")
order = coefficient("order", "1", 1.0, "periods per turn of the joint")
EFFECT = Effect(
    name="transmission_eccentricity",
    title="periodic error of the transmission",
    advice="Check the gear or encoder disc that turns so often for eccentricity. The error repeats exactly, so "
    "that the corrected commands undo it.",
    source="derive/effects/transmission_eccentricity.py",
    per_limb=True,
    coefficients=(cos, sin),
    constants=(order,),
    targets={"joint": cos.symbol * sp.cos(order.symbol * q) + sin.symbol * sp.sin(order.symbol * q)},
)
