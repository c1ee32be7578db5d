"""A link bends across its line: what it carries moves by the compliance times the force at its end, without slope.

The line of a link leads from its joint to the next one; what the link itself weighs is left out.
"""

from derive.effects import coefficient, state
from derive.language.effects import Effect, Reference

v, w = state("on_bend_v on_bend_w")
compliance = coefficient("compliance", "mm/N", 1.0, "deflection of a link's end per force across it", (0.0, 1.0))
EFFECT = Effect(
    name="link_bending",
    title="link bends across its line under what it carries",
    advice="Check the link and its flanges for cracks and loose screws. The bending repeats with the load, so that "
    "commands by the payload undo it.",
    source="derive/effects/link_bending.py",
    per_limb=True,
    coefficients=(compliance,),
    targets={"limb.bend_v": compliance.symbol * v, "limb.bend_w": compliance.symbol * w},
    tests=(
        Reference(
            {"on_bend_v": -60.0, "on_bend_w": 10.0}, {"compliance": 0.002}, {"limb.bend_v": -0.12, "limb.bend_w": 0.02}
        ),
    ),
)
