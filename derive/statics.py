"""Static loads by virtual work on the loop closure.

A weight `m` at point `r(x, q)` does the virtual work ``m g . dr``. With the generalised loads ``W_q = sum m g . dr/dq``
and ``W_x = sum m g . dr/dx`` and the closure's Jacobians, equilibrium of the platform gives the multipliers of the
rods, ``J_x^T mu = -W_x``, and the joints must hold ``torque = W_q + J_q^T mu``: what the loads exert on each joint,
positive along its positive direction.
"""

from __future__ import annotations

import sympy as sp

from derive.graph import Graph
from derive.lower import Kernel, Lowering
from derive.spec import LimbMechanism, Weight

GRAVITY = sp.Matrix(sp.symbols("gx gy gz", real=True))
PAYLOAD = sp.Symbol("payload", real=True)


def _work(weights: tuple[Weight, ...]) -> sp.Expr:
    return sum((w.mass * GRAVITY.dot(w.point) for w in weights), sp.Integer(0))


def loads(mechanism: LimbMechanism) -> dict[str, Kernel]:
    """Lower the generalised loads of one limb's and of the platform's weights to kernels, by name."""
    platform = [quantity.symbol for quantity in mechanism.platform]
    joint = mechanism.joint.symbol
    inputs = {s: f"x[{j}]" for j, s in enumerate(platform)}
    inputs |= {s.symbol: f"tool[{j}]" for j, s in enumerate(mechanism.tool)}
    inputs |= {joint: "q", PAYLOAD: "payload"}
    inputs |= {s: f"gravity[{j}]" for j, s in enumerate(GRAVITY)}
    inputs |= {s.symbol: f"masses[{j}]" for j, s in enumerate(mechanism.masses)}
    inputs |= {s.symbol: f"p[{j}]" for j, s in enumerate(mechanism.limb_parameters)}
    graph = Graph(mechanism.steps)
    lowering = Lowering(graph, {}, inputs)
    limb = graph.derivatives(_work(mechanism.limb_weights), [joint, *platform])
    body = graph.derivatives(_work(mechanism.platform_weights), platform)
    return {
        "limb": lowering.kernel(
            "limb",
            "generalised loads of one limb's weights: on its joint, on the platform",
            limb,
        ),
        "platform": lowering.kernel(
            "platform",
            "generalised loads of the platform's weight and of the payload",
            body,
        ),
    }
