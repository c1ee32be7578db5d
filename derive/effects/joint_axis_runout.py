"""The joint's centre orbits with the joint angle: it moves ``cos cos(theta) + sin sin(theta)`` along the limb."""

import sympy as sp

from derive.effects import coefficient, state
from derive.spec import Effect

(theta,) = state("theta")
cos = coefficient("cos", "mm", 1.0, "amplitude of the cosine")
sin = coefficient("sin", "mm", 1.0, "amplitude of the sine")
out = cos.symbol * sp.cos(theta) + sin.symbol * sp.sin(theta)
EFFECT = Effect(
    name="joint_axis_runout",
    title="the joint's centre orbits with its angle",
    advice="Check the bearings of the joint axis. The error repeats exactly, so that the corrected commands undo it.",
    source="derive/effects/joint_axis_runout.py",
    per_limb=True,
    coefficients=(cos, sin),
    targets={"limb.outwards": out},
)
