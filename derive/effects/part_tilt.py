"""A part tilts as a recorded column says, an accelerometer on it: the joint's axis and all it bears turn with it."""

from derive.effects import DEG, coefficient, constant, state
from derive.language.effects import Columns, Effect, Reference

(recorded,) = state("recorded")
x, y = (coefficient(f"tilt_{a}", "deg", DEG, f"tilt about {a} per unit of the column", (-10.0, 10.0)) for a in "xy")
of = constant("of", "1", 1.0, "name of the column")
EFFECT = Effect(
    name="part_tilt",
    title="the joint's axis tilts as a recorded column says",
    advice="Look for what gives way there: a foot, a floor, a foundation, a clamp. Until it is fixed command by the "
    "column.",
    source="derive/effects/part_tilt.py",
    per_limb=True,
    coefficients=(x, y),
    searched=(Columns(of),),
    targets={"limb.tilt_x": x.symbol * recorded, "limb.tilt_y": y.symbol * recorded},
    tests=(
        Reference(
            {"recorded": 0.5},
            {"tilt_x": 0.1, "tilt_y": -0.2},
            {"limb.tilt_x": 0.05 * DEG, "limb.tilt_y": -0.1 * DEG},
            {"of": "level_mm_m"},
        ),
    ),
)
