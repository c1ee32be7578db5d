"""The measured point moves once on the platform: by its offset in {O'} from a moment on."""

from derive.effects import coefficient, constant, state
from derive.language.effects import Effect, Moments, Reference

(after,) = state("after")
x, y, z = (coefficient(f"offset_{a}", "mm", 1.0, f"shift along {a} of {{O'}}", (-50.0, 50.0)) for a in "xyz")
when = constant("when", "s", 1.0, "time of the slip; the row, where there is no time")
EFFECT = Effect(
    name="tool_slip",
    title="the measured point slips on the platform once",
    advice="The machine is not at fault. Look at how the probe, reflector or tool is clamped, fasten it, and measure "
    "again what was read since; where it is the tool that slipped, calibrate its point anew.",
    source="derive/effects/tool_slip.py",
    per_limb=False,
    coefficients=(x, y, z),
    searched=(Moments(when),),
    targets={f"tool.{a}": o.symbol * after for a, o in zip("xyz", (x, y, z), strict=True)},
    tests=(
        Reference(
            {"after": 1.0},
            {"offset_x": 0.1, "offset_y": -0.2, "offset_z": 0.3},
            {"tool.x": 0.1, "tool.y": -0.2, "tool.z": 0.3},
            {"when": 3600.0},
        ),
        Reference(
            {"after": 0.0},
            {"offset_x": 0.1, "offset_y": -0.2, "offset_z": 0.3},
            {"tool.x": 0.0, "tool.y": 0.0, "tool.z": 0.0},
            {"when": 3600.0},
        ),
    ),
)
