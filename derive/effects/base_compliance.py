"""The frame tilts by the compliance times the moment of all moving weight about {O}."""

from derive.effects import DEG, coefficient, state
from derive.spec import Effect

mx, my = state("moment_x moment_y")
cx = coefficient("compliance_x", "deg/Nm", DEG / 1000, "tilt about x per moment about x")
cy = coefficient("compliance_y", "deg/Nm", DEG / 1000, "tilt about y per moment about y")
EFFECT = Effect(
    name="base_compliance",
    title="frame tilts under the moving weight",
    advice="Check the frame's fixing and stiffness. Until then command by the payload, or calibrate with the "
    "payload that is carried.",
    source="derive/effects/base_compliance.py",
    per_limb=False,
    coefficients=(cx, cy),
    targets={"turn.x": cx.symbol * mx, "turn.y": cy.symbol * my},
)
