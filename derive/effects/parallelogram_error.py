"""Geometry that the model in use leaves out: rods, spacings or axes of a limb's parallelogram differ.

The platform then rotates (Bai 2015, section 2). A baseline that fits these errors as geometry leaves nothing to it.
"""

from derive.effects import DEG, coefficient
from derive.spec import Effect

parts = {
    "rod_difference": coefficient("dl", "mm", 1.0, "length of rod 1 minus rod 2"),
    "spacing_difference": coefficient("dc", "mm", 1.0, "spacing at the elbow minus spacing at the platform"),
    "hand_axis_u": coefficient("alpha03", "deg", DEG, "alpha0 minus the same error at the platform"),
    "hand_axis_v": coefficient("beta03", "deg", DEG, "beta0 minus the same error at the platform"),
    "elbow_axis_u": coefficient("alpha2", "deg", DEG, "elbow axis turned about the arm"),
    "elbow_axis_v": coefficient("beta2", "deg", DEG, "elbow axis turned about the normal of the arm"),
}
EFFECT = Effect(
    name="parallelogram_error",
    title="rods, spacings or axes of a parallelogram differ",
    advice="Geometry, not physics: identify with the full model, which takes these errors into the commands.",
    source="derive/effects/parallelogram_error.py",
    per_limb=True,
    coefficients=tuple(parts.values()),
    targets={f"limb.{part}": error.symbol for part, error in parts.items()},
)
