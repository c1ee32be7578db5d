"""The instrument's length scale is wrong: ``y = y (1 + scale)``."""

from derive.effects import coefficient, state
from derive.language.effects import Effect, Reference

x, y, z, length = state("y_x y_y y_z y_length")
scale = coefficient("scale", "ppm", 1e-6, "error of the length scale", (-1e4, 1e4))
EFFECT = Effect(
    name="instrument_scale",
    title="the instrument's length scale is wrong",
    advice="The machine is not at fault, unless it is warmer than its drawing. Hold the instrument against a "
    "length that is known.",
    source="derive/effects/instrument_scale.py",
    per_limb=False,
    coefficients=(scale,),
    targets={
        "reading.x": scale.symbol * x,
        "reading.y": scale.symbol * y,
        "reading.z": scale.symbol * z,
        "length": scale.symbol * length,
    },
    tests=(
        Reference(
            {"y_x": 1000.0, "y_y": -500.0, "y_z": 200.0, "y_length": 1500.0},
            {"scale": 20.0},
            {"reading.x": 0.02, "reading.y": -0.01, "reading.z": 0.004, "length": 0.03},
        ),
    ),
)
