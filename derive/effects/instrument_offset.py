"""A measured point of the platform is not where the sidecar says: one offset in {O'} per distinct tool point."""

from derive.effects import coefficient
from derive.language.effects import Effect, Points, Reference

x, y, z = (coefficient(f"offset_{a}", "mm", 1.0, f"offset along {a} of {{O'}}", (-50.0, 50.0)) for a in "xyz")
EFFECT = Effect(
    name="instrument_offset",
    title="a measured point is not where it is said to be",
    advice="The machine is not at fault. Measure again where this reflector or probe sits on the platform, and "
    "correct tool_x_mm ... in the recording.",
    source="derive/effects/instrument_offset.py",
    per_limb=False,
    coefficients=(x, y, z),
    targets={f"tool.{a}": o.symbol for a, o in zip("xyz", (x, y, z), strict=True)},
    searched=(Points(),),
    tests=(
        Reference(
            {}, {"offset_x": 0.1, "offset_y": -0.2, "offset_z": 0.3}, {"tool.x": 0.1, "tool.y": -0.2, "tool.z": 0.3}
        ),
    ),
)
