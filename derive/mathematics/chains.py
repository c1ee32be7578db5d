"""Functions of a link of an open chain."""

from __future__ import annotations

import sympy as sp

from derive import vectors
from derive.graph import Graph
from derive.mathematics.functions import Functions, entries
from derive.spec import ChainMechanism


def links(mechanism: ChainMechanism) -> list[Functions]:
    """Return a link of each convention: its rotation (9) and shift (3), then how errors and joint move it.

    Each derivative is a shift of the link's origin and a turn, ``axial(dR R^T)``, both in the frame before the link:
    the twist that the chain behind the link takes part in.
    """
    variables = [quantity.symbol for quantity in mechanism.joint]
    errors = [quantity.symbol for quantity in mechanism.errors]
    geometry = [key.quantity.symbol for key in mechanism.geometry]
    inputs = entries("x", variables) | entries("p", [*geometry, *errors])
    found = []
    for convention, screws in mechanism.transforms.items():
        rotation, shift, by_step = vectors.follow(screws)
        twists: list[sp.Expr] = []
        for s in (*errors, *variables):
            parts = [sp.diff(added, s) * by_step[step] for step, added in mechanism.steps]
            twists += list(sum(parts, sp.zeros(6, 1)))
        link = Functions(Graph(mechanism.steps), {}, inputs)
        link.add(
            convention,
            f"a link, {convention} convention: rotation, shift; shift and turn by each error, by turn and slide",
            [*rotation, *shift, *twists],
        )
        found.append(link)
    return found
