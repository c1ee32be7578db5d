"""A spring that hardens: ``theta = q + compliance limit tanh(torque / limit)``.

Soft as `compliance` says while the torque is small against `limit`; beyond it the joint hardly gives way further.
"""

import sympy as sp

from derive.effects import DEG, constant, joint_coefficient, state
from derive.effects.joint_compliance import EFFECT as SPRING
from derive.language.effects import Effect, Reference, Sizes

(torque,) = state("torque")
compliance = joint_coefficient("compliance", "Nm", "twist per torque while that is small", (0.0, 1.0))
limit = constant("limit", "Nm", 1000.0, "torque about which the spring hardens", of_joint=True)
EFFECT = Effect(
    name="saturating_compliance",
    title="joint gives way under the load, less and less",
    advice="Look for play under preload, a soft coupling with a stop, or a flexspline that hardens. The deflection "
    "repeats with the load, so that commands by the payload undo it.",
    source="derive/effects/saturating_compliance.py",
    per_limb=True,
    coefficients=(compliance,),
    searched=(Sizes(limit, "torque"),),
    extends=SPRING,
    targets={"joint": compliance.symbol * limit.symbol * sp.tanh(torque / limit.symbol)},
    tests=(
        Reference({"torque": 1e6}, {"compliance": 0.01}, {"joint": 0.05 * DEG}, {"limit": 5.0}),
        Reference({"torque": -1.0}, {"compliance": 0.01}, {"joint": -1e-5 * DEG}, {"limit": 1000.0}),
    ),
)
