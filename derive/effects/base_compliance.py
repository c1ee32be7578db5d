"""The frame tilts by the compliance times the moment of all moving weight about {O}."""

from derive.effects import DEG, coefficient, state
from derive.language.effects import Effect, Reference

mx, my = state("moment_x moment_y")
cx = coefficient("compliance_x", "deg/Nm", DEG / 1000, "tilt about x per moment about x", (0.0, 1.0))
cy = coefficient("compliance_y", "deg/Nm", DEG / 1000, "tilt about y per moment about y", (0.0, 1.0))
EFFECT = Effect(
    name="base_compliance",
    title="frame tilts under the moving weight",
    advice="Check the frame's fixing and stiffness. Until then command by the payload, or calibrate with the "
    "payload that is carried.",
    source="derive/effects/base_compliance.py",
    per_limb=False,
    coefficients=(cx, cy),
    targets={"turn.x": cx.symbol * mx, "turn.y": cy.symbol * my},
    tests=(
        Reference(
            {"moment_x": 2000.0, "moment_y": -1000.0},
            {"compliance_x": 0.01, "compliance_y": 0.02},
            {"turn.x": 0.02 * DEG, "turn.y": -0.02 * DEG},
        ),
    ),
)
