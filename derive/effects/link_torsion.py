"""A link twists about its line, by the compliance times the moment about it of all that the link carries."""

from derive.effects import DEG, coefficient, state
from derive.language.effects import Effect, Reference

(moment,) = state("on_twist")
compliance = coefficient("compliance", "deg/Nm", DEG / 1000, "twist of a link per moment about its line", (0.0, 1.0))
EFFECT = Effect(
    name="link_torsion",
    title="link twists about its line under what it carries",
    advice="Check the link and its flanges for cracks and loose screws. The twist repeats with the load, so that "
    "commands by the payload undo it.",
    source="derive/effects/link_torsion.py",
    per_limb=True,
    coefficients=(compliance,),
    targets={"limb.twist": compliance.symbol * moment},
    tests=(Reference({"on_twist": 5000.0}, {"compliance": 0.004}, {"limb.twist": 0.02 * DEG}),),
)
