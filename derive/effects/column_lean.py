"""A lifting column bends: its slope at the top is the compliance times the moment there times its height.

A uniform beam under a moment at its top: slope ``compliance moment height``, and the top moves as if the column turned
by it half way up, ``compliance moment height^2 / 2``. The height is the way of the joint that lifts, from its foot.
"""

from derive.effects import DEG, coefficient, state
from derive.language.effects import Effect, Reference

q, foot, slides, moment_x, moment_y, side_x, side_y = state("q foot slides on_tilt_x on_tilt_y on_side_x on_side_y")
compliance = coefficient(
    "compliance", "deg/(Nm mm)", DEG / 1000, "slope of the column's top per moment there and height", (0.0, 1e-3)
)
height = slides * q + foot
slope_x = compliance.symbol * height * (moment_x + height * side_y)  # the moment at the foot less that of the force
slope_y = compliance.symbol * height * (moment_y - height * side_x)
EFFECT = Effect(
    name="column_lean",
    title="column leans the more, the higher it is",
    advice="Check the column's guides and its foot. The lean repeats with load and height, so that commands by the "
    "payload undo it.",
    source="derive/effects/column_lean.py",
    per_limb=True,
    coefficients=(compliance,),
    targets={
        "limb.tilt_x": slope_x,
        "limb.tilt_y": slope_y,
        "limb.side_x": -slope_y * height / 2,
        "limb.side_y": slope_x * height / 2,
    },
    tests=(
        Reference(
            {
                "q": 300.0 / DEG,
                "foot": 200.0,
                "slides": 1.0,
                "on_tilt_x": 40000.0,
                "on_tilt_y": -9000.0,
                "on_side_x": 10.0,
                "on_side_y": -20.0,
            },
            {"compliance": 1e-6},
            {
                "limb.tilt_x": 0.015 * DEG,
                "limb.tilt_y": -0.007 * DEG,
                "limb.side_x": 1.75 * DEG,
                "limb.side_y": 3.75 * DEG,
            },
        ),
    ),
)
