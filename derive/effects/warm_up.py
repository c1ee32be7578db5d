"""The joint's zero creeps to where it stays: ``theta = q + size (1 - exp(-t / time_constant))``."""

import sympy as sp

from derive.effects import DEG, constant, joint_coefficient, state
from derive.language.effects import Effect, Reference, Sizes

(time,) = state("time")
size = joint_coefficient("size", "", "shift of the zero when all is warm", (-5.0, 5.0))
tau = constant("time_constant", "s", 1.0, "time in which all but 1/e of it has come")
EFFECT = Effect(
    name="warm_up",
    title="the joint's zero creeps while the machine warms up",
    advice="Let the machine warm up for some time constants before it is measured or works, and home it then.",
    source="derive/effects/warm_up.py",
    per_limb=True,
    coefficients=(size,),
    searched=(Sizes(tau, "time"),),
    targets={"joint": size.symbol * (1 - sp.exp(-time / tau.symbol))},
    tests=(
        Reference(
            {"time": 600.0}, {"size": 0.1}, {"joint": 0.1 * (1 - 0.1353352832366127) * DEG}, {"time_constant": 300.0}
        ),
        Reference({"time": 0.0}, {"size": 0.1}, {"joint": 0.0}, {"time_constant": 300.0}),
    ),
)
