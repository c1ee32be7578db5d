"""Static loads by virtual work on the loop closure.

A weight `m` at point `r(x, q)` does the virtual work ``m g . dr``. With the generalised loads ``W_q = sum m g . dr/dq``
and ``W_x = sum m g . dr/dx`` and the closure's Jacobians, equilibrium of the platform gives the multipliers of the
rods, ``J_x^T mu = -W_x``, and the joints must hold ``torque = W_q + J_q^T mu``: what the loads exert on each joint,
positive along its positive direction.
"""

from __future__ import annotations

import sympy as sp

from derive.backends.ir import Place
from derive.graph import Graph
from derive.mathematics.functions import Functions, entries
from derive.spec import LimbMechanism, Weight

PAYLOAD = sp.Symbol("payload", real=True)


def _fields(weights: tuple[Weight, ...]) -> list[sp.Matrix]:
    """Return the acceleration field that acts on each weight: gravity, or minus its own acceleration."""
    return [sp.Matrix(sp.symbols(f"f{j}x f{j}y f{j}z", real=True)) for j in range(len(weights))]


def loads(mechanism: LimbMechanism) -> list[Functions]:
    """Return what the weights of one limb, and of the platform, exert.

    `limb`: generalised loads on the joint, on the platform's coordinates, moment about {O}. `platform`: the same
    without a joint. `limb_points`, `platform_points`: where the weights are.
    """
    platform = [quantity.symbol for quantity in mechanism.platform]
    joint = mechanism.joint.symbol
    inputs = entries("x", platform) | entries("tool", [s.symbol for s in mechanism.tool])
    inputs |= {joint: Place("q"), PAYLOAD: Place("payload")}
    inputs |= entries("masses", [s.symbol for s in mechanism.masses])
    inputs |= entries("p", [s.symbol for s in mechanism.limb_parameters])
    found = []
    for name, weights, by in (
        ("limb", mechanism.limb_weights, [joint, *platform]),
        ("platform", mechanism.platform_weights, platform),
    ):
        graph = Graph(mechanism.steps)
        fields = _fields(weights)
        own = entries("fields", [s for field in fields for s in field])
        functions = Functions(graph, {}, inputs | own)
        pairs = list(zip(weights, fields, strict=True))
        work = sum((w.mass * field.dot(w.point) for w, field in pairs), sp.Integer(0))
        moment = sum((w.mass * w.point.cross(field) for w, field in pairs), sp.zeros(3, 1))
        functions.add(
            name,
            f"generalised loads of the weights of one {name} and their moment",
            [*graph.derivatives(work, by), *moment],
        )
        functions.add(
            f"{name}_points",
            f"where the weights of one {name} are",
            [component for w in weights for component in w.point],
        )
        found.append(functions)
    return found
