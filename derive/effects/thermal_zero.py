"""The joint's zero moves with temperature: ``theta = q + drift (T - 20)``."""

from derive.effects import DEG, coefficient, state
from derive.spec import Effect

(warming,) = state("warming")
drift = coefficient("drift", "deg/K", DEG, "drift of the zero")
EFFECT = Effect(
    name="thermal_zero",
    title="joint zero moves with temperature",
    source="derive/effects/thermal_zero.py",
    per_limb=True,
    coefficients=(drift,),
    targets={"joint": drift.symbol * warming},
)
