"""Friction that grows with what the joint carries: ``load |torque| sign(qd)``."""

import sympy as sp

from derive.effects import coefficient, state
from derive.language.effects import Effect, Reference

qd, torque = state("qd torque")
load = coefficient("load", "1", 1.0, "friction per torque", (0.0, 1.0))
EFFECT = Effect(
    name="load_friction",
    title="friction that grows with the load",
    advice="Gears lose a part of what they carry. A larger part than last time is wear or want of lubrication.",
    source="derive/effects/load_friction.py",
    per_limb=True,
    coefficients=(load,),
    targets={"torque": load.symbol * sp.Abs(torque) * sp.sign(qd)},
    tests=(Reference({"torque": -5000.0, "qd": -3.0}, {"load": 0.1}, {"torque": -500.0}),),
)
