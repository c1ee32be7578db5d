"""The joint lies on either side of its play: ``theta = q - approach width / 2``."""

from derive.effects import DEG, joint_coefficient, state
from derive.language.effects import Effect, Reference

(approach,) = state("approach")
width = joint_coefficient("width", "", "the full gap", (0.0, 5.0))
EFFECT = Effect(
    name="backlash",
    title="play, flips with the direction of approach",
    advice="Look for play in the gearbox and its couplings, and take it out. Until then command by the direction "
    "of approach, or always arrive from the same side.",
    source="derive/effects/backlash.py",
    per_limb=True,
    coefficients=(width,),
    targets={"joint": -approach * width.symbol / 2},
    tests=(Reference({"approach": -1.0}, {"width": 0.04}, {"joint": 0.02 * DEG}),),
)
