"""Dry friction that builds up over a way (Dahl): the part ``stiffness travel`` of it has ``z`` for ``sign(qd)``.

``dz/dt = qd / travel (1 - z sign(qd))``; the joint's dry friction is ``coulomb``, of which all builds up where
``travel = coulomb / stiffness``.
"""

import sympy as sp

from derive.effects import DEG, constant, state, torque_coefficient
from derive.language.effects import Effect, Reference, Travels
from derive.language.memory import Memory

(qd,) = state("qd")
stiffness = torque_coefficient("stiffness", "/deg", "of what gives before the joint slides", (0.0, 1e6))
travel = constant("travel", "deg", DEG, "way over which friction builds up", of_joint=True)
z = sp.Symbol("z", real=True)
EFFECT = Effect(
    name="presliding_friction",
    title="dry friction that builds up over a way",
    advice="The joint gives before it slides: after each reversal friction comes late. Let the feed-forward follow the "
    "way since the reversal, and approach from one side where the last of it counts.",
    source="derive/effects/presliding_friction.py",
    per_limb=True,
    coefficients=(stiffness,),
    searched=(Travels(travel),),
    memory=(
        Memory(z, "part of the friction that has built up", qd / travel.symbol * (1 - z * sp.sign(qd)), sp.Integer(0)),
    ),
    targets={"torque": stiffness.symbol * travel.symbol * (z - sp.sign(qd))},
    tests=(
        Reference({"qd": 2.0, "z": -0.5}, {"stiffness": 10.0}, {"torque": -3000.0}, {"travel": 0.2}),
        Reference({"qd": -2.0, "z": -1.0}, {"stiffness": 10.0}, {"torque": 0.0}, {"travel": 0.2}),
    ),
)
