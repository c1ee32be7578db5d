"""The arm bends: its tip moves by the compliance times the rods' pull normal to the arm, in both directions."""

from derive.effects import coefficient, state
from derive.spec import Effect

pull_v, pull_w = state("pull_v pull_w")
compliance = coefficient("compliance", "mm/N", 1.0, "deflection of the tip per force")
EFFECT = Effect(
    name="proximal_bending",
    title="arm bends under the rods' pull",
    advice="Check the arm and its clamping for cracks and loose screws. The bending repeats with the load, so "
    "that commands by the payload undo it.",
    source="derive/effects/proximal_bending.py",
    per_limb=True,
    coefficients=(compliance,),
    targets={"limb.tip_v": compliance.symbol * pull_v, "limb.tip_w": compliance.symbol * pull_w},
)
