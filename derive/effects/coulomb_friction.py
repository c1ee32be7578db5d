"""Dry friction against the motion, whatever its speed: ``coulomb sign(qd)``."""

import sympy as sp

from derive.effects import state, torque_coefficient
from derive.language.effects import Effect, Reference

(qd,) = state("qd")
coulomb = torque_coefficient("coulomb", "", "dry friction", (0.0, 10000.0))
EFFECT = Effect(
    name="coulomb_friction",
    title="dry friction",
    advice="Every joint has some. More than last time is a seal, a bearing under too much preload, or a brake that "
    "drags; the feed-forward torque takes it along.",
    source="derive/effects/coulomb_friction.py",
    per_limb=True,
    coefficients=(coulomb,),
    targets={"torque": coulomb.symbol * sp.sign(qd)},
    tests=(
        Reference({"qd": 3.0}, {"coulomb": 2.0}, {"torque": 2000.0}),
        Reference({"qd": -0.1}, {"coulomb": 2.0}, {"torque": -2000.0}),
    ),
)
