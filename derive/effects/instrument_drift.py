"""The reading moves along the instrument's axes: ``y = y + rate t / 3600``."""

from derive.effects import coefficient, state
from derive.language.effects import Effect, Reference

(time,) = state("time")
x, y, z = (coefficient(f"rate_{a}", "mm/h", 1.0, f"drift along the instrument's {a}", (-10.0, 10.0)) for a in "xyz")
EFFECT = Effect(
    name="instrument_drift",
    title="the instrument drifts",
    advice="The machine is not at fault. Let the instrument warm up, fix its stand, and measure a fixed point "
    "again and again.",
    source="derive/effects/instrument_drift.py",
    per_limb=False,
    coefficients=(x, y, z),
    targets={f"reading.{a}": r.symbol * time / 3600 for a, r in zip("xyz", (x, y, z), strict=True)},
    tests=(
        Reference(
            {"time": 1800.0},
            {"rate_x": 0.02, "rate_y": -0.04, "rate_z": 0.1},
            {"reading.x": 0.01, "reading.y": -0.02, "reading.z": 0.05},
        ),
    ),
)
