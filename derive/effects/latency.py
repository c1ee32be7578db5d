"""The position belongs to the joints `delay` seconds earlier: ``q - delay qd + delay^2 / 2 qdd``."""

from derive.effects import DEG, coefficient, state
from derive.language.effects import Effect, Reference

qd, qdd = state("qd qdd")
delay = coefficient("delay", "s", 1.0, "time by which the position lags", (-1.0, 1.0))
EFFECT = Effect(
    name="latency",
    title="the position lags the joints",
    advice="Joints and positions are not of the same instant. Synchronise the instrument's trigger with the "
    "controller, or measure at rest.",
    source="derive/effects/latency.py",
    per_limb=False,
    coefficients=(delay,),
    targets={"joint": -delay.symbol * qd + delay.symbol**2 / 2 * qdd},
    tests=(Reference({"qd": 100.0, "qdd": 1000.0}, {"delay": 0.01}, {"joint": (-1.0 + 0.05) * DEG}),),
)
