"""The position belongs to the joints `delay` seconds earlier: ``q - delay speed + delay^2 / 2 acceleration``."""

from derive.effects import coefficient, state
from derive.spec import Effect

speed, acceleration = state("speed acceleration")
delay = coefficient("delay", "s", 1.0, "time by which the position lags")
EFFECT = Effect(
    name="latency",
    title="the position lags the joints",
    advice="Joints and positions are not of the same instant. Synchronise the instrument's trigger with the "
    "controller, or measure at rest.",
    source="derive/effects/latency.py",
    per_limb=False,
    coefficients=(delay,),
    targets={"joint": -delay.symbol * speed + delay.symbol**2 / 2 * acceleration},
)
