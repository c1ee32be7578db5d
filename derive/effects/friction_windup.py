"""Friction winds the joint up against its motion: ``theta = q - approach compliance abs(torque)``."""

import sympy as sp

from derive.effects import DEG, joint_coefficient, state
from derive.language.effects import Effect, Reference

approach, torque = state("approach torque")
compliance = joint_coefficient("compliance", "Nm", "windup per torque", (0.0, 1.0))
EFFECT = Effect(
    name="friction_windup",
    title="friction winds the joint up, by direction and load",
    advice="Look for friction in the joint and for a soft transmission behind it. Until then command by "
    "direction of approach and payload.",
    source="derive/effects/friction_windup.py",
    per_limb=True,
    coefficients=(compliance,),
    targets={"joint": -approach * compliance.symbol * sp.Abs(torque)},
    tests=(Reference({"approach": 1.0, "torque": -3000.0}, {"compliance": 0.01}, {"joint": -0.03 * DEG}),),
)
