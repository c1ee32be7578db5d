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

PAYLOAD = sp.Symbol("payload", real=True)


def _fields(weights: tuple[Weight, ...]) -> list[sp.Matrix]:
    """Return the acceleration field that acts on each weight: gravity, or minus its own acceleration."""
    return [sp.Matrix(sp.symbols(f"f{j}x f{j}y f{j}z", real=True)) for j in range(len(weights))]


def loads(mechanism: LimbMechanism) -> dict[str, Kernel]:
    """Lower one limb's and the platform's weights to kernels, by name.

    `limb`: generalised loads on the joint, on the platform's coordinates, moment about {O}. `platform`: the same
    without a joint. `limb_points`, `platform_points`: where the weights are.
    """
    platform = [quantity.symbol for quantity in mechanism.platform]
    joint = mechanism.joint.symbol
    inputs = {s: f"x[{j}]" for j, s in enumerate(platform)}
    inputs |= {s.symbol: f"tool[{j}]" for j, s in enumerate(mechanism.tool)}
    inputs |= {joint: "q", PAYLOAD: "payload"}
    inputs |= {s.symbol: f"masses[{j}]" for j, s in enumerate(mechanism.masses)}
    inputs |= {s.symbol: f"p[{j}]" for j, s in enumerate(mechanism.limb_parameters)}
    kernels = {}
    for name, weights, by in (
        ("limb", mechanism.limb_weights, [joint, *platform]),
        ("platform", mechanism.platform_weights, platform),
    ):
        graph = Graph(mechanism.steps)
        fields = _fields(weights)
        own = {s: f"fields[{3 * j + c}]" for j, field in enumerate(fields) for c, s in enumerate(field)}
        lowering = Lowering(graph, {}, inputs | own)
        pairs = list(zip(weights, fields, strict=True))
        work = sum((w.mass * field.dot(w.point) for w, field in pairs), sp.Integer(0))
        moment = sum((w.mass * w.point.cross(field) for w, field in pairs), sp.zeros(3, 1))
        kernels[name] = lowering.kernel(
            name,
            f"generalised loads of the weights of one {name} and their moment",
            [*graph.derivatives(work, by), *moment],
        )
        kernels[f"{name}_points"] = lowering.kernel(
            f"{name}_points",
            f"where the weights of one {name} are",
            [component for w in weights for component in w.point],
        )
    return kernels
