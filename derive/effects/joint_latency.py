"""One joint's readings are `delay` seconds later than the others': ``theta = q - delay qd + delay^2 / 2 qdd``."""

from derive.effects import DEG, state
from derive.effects.latency import EFFECT as ALL
from derive.effects.latency import delay
from derive.language.effects import Effect, Reference

qd, qdd = state("qd qdd")
EFFECT = Effect(
    name="joint_latency",
    title="a joint lags the others",
    advice="One drive follows its command later than the others, or its encoder is read at another instant. Look at "
    "the gains and filters of its controller, and at the order in which joints are read.",
    source="derive/effects/joint_latency.py",
    per_limb=True,
    coefficients=(delay,),
    targets=ALL.targets,
    extends=ALL,
    tests=(Reference({"qd": 100.0, "qdd": 1000.0}, {"delay": 0.01}, {"joint": (-1.0 + 0.05) * DEG}),),
)
