"""Friction winds the joint up against its motion: ``theta = q - approach compliance abs(torque)``."""

import sympy as sp

from derive.effects import joint_coefficient, state
from derive.spec import Effect

approach, torque = state("approach torque")
compliance = joint_coefficient("compliance", "Nm", "windup per torque")
EFFECT = Effect(
    name="friction_windup",
    title="friction winds the joint up, by direction and load",
    advice="Look for friction in the joint and for a soft transmission behind it. Until then command by "
    "direction of approach and payload.",
    source="derive/effects/friction_windup.py",
    per_limb=True,
    coefficients=(compliance,),
    targets={"joint": -approach * compliance.symbol * sp.Abs(torque)},
)
