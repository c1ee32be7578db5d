"""The joint's centre orbits with the joint angle: it moves ``cos cos(theta) + sin sin(theta)`` along the limb."""

import sympy as sp

from derive.effects import coefficient, state
from derive.language.effects import Effect, Reference

(theta,) = state("theta")
cos = coefficient("cos", "mm", 1.0, "amplitude of the cosine", (-5.0, 5.0))
sin = coefficient("sin", "mm", 1.0, "amplitude of the sine", (-5.0, 5.0))
out = cos.symbol * sp.cos(theta) + sin.symbol * sp.sin(theta)
EFFECT = Effect(
    name="joint_axis_runout",
    title="the joint's centre orbits with its angle",
    advice="Check the bearings of the joint axis. The error repeats exactly, so that the corrected commands undo it.",
    source="derive/effects/joint_axis_runout.py",
    per_limb=True,
    coefficients=(cos, sin),
    targets={"limb.outwards": out},
    tests=(
        Reference({"theta": 60.0}, {"cos": 0.1, "sin": 0.0}, {"limb.outwards": 0.05}),
        Reference({"theta": 30.0}, {"cos": 0.0, "sin": 0.2}, {"limb.outwards": 0.1}),
    ),
)
