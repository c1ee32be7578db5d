"""A joint moves with another one: ``theta = q + coupling q_of``."""

from derive.effects import DEG, coefficient, constant, state
from derive.language.effects import Effect, Joints, Reference

(other,) = state("q_other")
coupling = coefficient("coupling", "1", 1.0, "way of the joint per way of the other, in their units", (-0.2, 0.2))
of = constant("of", "1", 1.0, "number of the other joint")
EFFECT = Effect(
    name="joint_coupling",
    title="the joint moves with another one",
    advice="Check the coupling of the two joints in the controller (a wrist's gears, a parallelogram's rod, a belt "
    "that runs past an axis), and correct its ratio there.",
    source="derive/effects/joint_coupling.py",
    per_limb=True,
    coefficients=(coupling,),
    searched=(Joints(of),),
    targets={"joint": coupling.symbol * other},
    tests=(Reference({"q_other": 40.0}, {"coupling": -0.002}, {"joint": -0.08 * DEG}, {"of": 2.0}),),
)
