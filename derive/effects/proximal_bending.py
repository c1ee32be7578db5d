"""The arm bends: its tip moves by the compliance times the rods' pull normal to the arm, in both directions."""

from derive.effects import coefficient, state
from derive.language.effects import Effect, Reference

pull_v, pull_w = state("pull_v pull_w")
compliance = coefficient("compliance", "mm/N", 1.0, "deflection of the tip per force", (0.0, 1.0))
EFFECT = Effect(
    name="proximal_bending",
    title="arm bends under the rods' pull",
    advice="Check the arm and its clamping for cracks and loose screws. The bending repeats with the load, so "
    "that commands by the payload undo it.",
    source="derive/effects/proximal_bending.py",
    per_limb=True,
    coefficients=(compliance,),
    targets={"limb.tip_v": compliance.symbol * pull_v, "limb.tip_w": compliance.symbol * pull_w},
    tests=(
        Reference({"pull_v": -20.0, "pull_w": 5.0}, {"compliance": 0.01}, {"limb.tip_v": -0.2, "limb.tip_w": 0.05}),
    ),
)
