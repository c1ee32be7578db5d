"""The joint's zero creeps to where it stays: ``theta = q + size (1 - exp(-t / time_constant))``.

Where no time was logged, t is what a recorded column counts: cycles, rows in their order.
"""

import sympy as sp

from derive.effects import DEG, constant, joint_coefficient, state
from derive.language.effects import Clocks, Effect, Reference, Sizes

(passed,) = state("passed")
size = joint_coefficient("size", "", "shift of the zero when all is warm", (-5.0, 5.0))
per = constant("per", "1", 1.0, "name of the column in which the time constant counts")
tau = constant("time_constant", "s", 1.0, "time in which all but 1/e of it has come")
EFFECT = Effect(
    name="warm_up",
    title="the joint's zero creeps while the machine warms up",
    advice="Let the machine warm up for some time constants before it is measured or works, and home it then.",
    source="derive/effects/warm_up.py",
    per_limb=True,
    coefficients=(size,),
    searched=(Clocks(per), Sizes(tau, "passed")),
    targets={"joint": size.symbol * (1 - sp.exp(-passed / tau.symbol))},
    tests=(
        Reference(
            {"passed": 600.0},
            {"size": 0.1},
            {"joint": 0.1 * (1 - 0.1353352832366127) * DEG},
            {"time_constant": 300.0, "per": "cycle"},
        ),
        Reference({"passed": 0.0}, {"size": 0.1}, {"joint": 0.0}, {"time_constant": 300.0, "per": "cycle"}),
    ),
)
