"""The instrument's frame moves once: readings are off by a shift along its axes from a moment on."""

from derive.effects import coefficient, constant, state
from derive.language.effects import Effect, Moments, Reference

(after,) = state("after")
x, y, z = (
    coefficient(f"offset_{a}", "mm", 1.0, f"shift of readings along the instrument's {a}", (-50.0, 50.0)) for a in "xyz"
)
when = constant("when", "s", 1.0, "time of the slip; the row, where there is no time")
EFFECT = Effect(
    name="instrument_slip",
    title="the instrument slips once",
    advice="The machine is not at fault. Fix the instrument's stand, measure fixed points before and after a session, "
    "and give what was read since a set-up of its own.",
    source="derive/effects/instrument_slip.py",
    per_limb=False,
    coefficients=(x, y, z),
    searched=(Moments(when),),
    targets={f"reading.{a}": o.symbol * after for a, o in zip("xyz", (x, y, z), strict=True)},
    tests=(
        Reference(
            {"after": 1.0},
            {"offset_x": 0.1, "offset_y": -0.2, "offset_z": 0.3},
            {"reading.x": 0.1, "reading.y": -0.2, "reading.z": 0.3},
            {"when": 3600.0},
        ),
        Reference(
            {"after": 0.0},
            {"offset_x": 0.1, "offset_y": -0.2, "offset_z": 0.3},
            {"reading.x": 0.0, "reading.y": 0.0, "reading.z": 0.0},
            {"when": 3600.0},
        ),
    ),
)
