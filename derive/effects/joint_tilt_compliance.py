"""A joint's axis tilts under the moment across it, about x and y of the frame in which the joint moves."""

from derive.effects import DEG, coefficient, state
from derive.language.effects import Effect, Reference

moment_x, moment_y = state("on_tilt_x on_tilt_y")
x, y = (
    coefficient(f"compliance_{a}", "deg/Nm", DEG / 1000, f"tilt about {a} per moment about {a}", (0.0, 1.0))
    for a in "xy"
)
EFFECT = Effect(
    name="joint_tilt_compliance",
    title="joint's axis tilts under the moment across it",
    advice="Check the bearing of the joint for wear and its screws. The tilt repeats with the load, so that commands "
    "by the payload undo it.",
    source="derive/effects/joint_tilt_compliance.py",
    per_limb=True,
    coefficients=(x, y),
    targets={"limb.tilt_x": x.symbol * moment_x, "limb.tilt_y": y.symbol * moment_y},
    tests=(
        Reference(
            {"on_tilt_x": 8000.0, "on_tilt_y": -3000.0},
            {"compliance_x": 0.002, "compliance_y": 0.001},
            {"limb.tilt_x": 0.016 * DEG, "limb.tilt_y": -0.003 * DEG},
        ),
    ),
)
