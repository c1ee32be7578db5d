"""Geometry that the model in use leaves out: rods, spacings or axes of a limb's parallelogram differ.

The platform then rotates (Bai 2015, section 2). A baseline that fits these errors as geometry leaves nothing to it.
"""

from derive.effects import DEG, coefficient
from derive.language.effects import Effect, Reference

parts = {
    "rod_difference": coefficient("dl", "mm", 1.0, "length of rod 1 minus rod 2", (-5.0, 5.0)),
    "spacing_difference": coefficient(
        "dc", "mm", 1.0, "spacing at the elbow minus spacing at the platform", (-5.0, 5.0)
    ),
    "hand_axis_u": coefficient("alpha03", "deg", DEG, "alpha0 minus the same error at the platform", (-5.0, 5.0)),
    "hand_axis_v": coefficient("beta03", "deg", DEG, "beta0 minus the same error at the platform", (-5.0, 5.0)),
    "elbow_axis_u": coefficient("alpha2", "deg", DEG, "elbow axis turned about the arm", (-5.0, 5.0)),
    "elbow_axis_v": coefficient("beta2", "deg", DEG, "elbow axis turned about the normal of the arm", (-5.0, 5.0)),
}
EFFECT = Effect(
    name="parallelogram_error",
    title="rods, spacings or axes of a parallelogram differ",
    advice="Geometry, not physics: identify with the full model, which takes these errors into the commands.",
    source="derive/effects/parallelogram_error.py",
    per_limb=True,
    whole=True,
    coefficients=tuple(parts.values()),
    targets={f"limb.{part}": error.symbol for part, error in parts.items()},
    tests=(
        Reference(
            {},
            {"dl": 0.1, "dc": 0.2, "alpha03": 0.3, "beta03": 0.4, "alpha2": 0.5, "beta2": 0.6},
            {
                "limb.rod_difference": 0.1,
                "limb.spacing_difference": 0.2,
                "limb.hand_axis_u": 0.3 * DEG,
                "limb.hand_axis_v": 0.4 * DEG,
                "limb.elbow_axis_u": 0.5 * DEG,
                "limb.elbow_axis_v": 0.6 * DEG,
            },
        ),
    ),
)
