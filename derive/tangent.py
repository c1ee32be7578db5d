"""Rates of kernels: how what a kernel gives changes with what it reads, forwards along its own steps.

A pipeline of kernels is differentiated kernel by kernel: each reads, beside what it read, the rates of that, in arrays
of the same layout by other names, and gives the rates of what it gave. What is derived for one machine so gives the
derivatives by its errors, which enter the pipeline as rates of what no motion changes.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

import sympy as sp

from derive.backends.ir import RATES, Kernel, Place
from derive.blocks import Blocks, lane
from derive.graph import Graph
from derive.lower import lower
from derive.mathematics.functions import Functions
from derive.spec import LimbMechanism

HELD = ("joint", "body", "gravity", "shares", "inertia")  # arrays that no error changes


def tangent(kernel: Kernel, held: Collection[Place] = ()) -> Kernel:
    """Return the kernel of the rates of all that a kernel gives.

    The rate of ``array[n]`` is read from ``array_by[n]``.

    Parameters
    ----------
    held : collection of Place
        What does not change, beside the arrays in `HELD`.
    """
    names = [*(load.symbol for load in kernel.loads), *(node.symbol for node in kernel.assigns)]
    own = {s: sp.Symbol(f"{s}_now", real=True) for s in names}  # the graph numbers its own
    places = {own[load.symbol]: load.place for load in kernel.loads}
    moving = {s: at for s, at in places.items() if at not in held and at.array not in HELD}
    rates = {s: sp.Symbol(f"{s}_by", real=True) for s in moving}
    read = {rates[s]: replace(at, array=f"{at.array}{RATES}") for s, at in moving.items()}
    graph = Graph([(own[node.symbol], node.expr.xreplace(own)) for node in kernel.assigns])
    leaves = {store.index: graph.add(store.expr.xreplace(own)) for store in kernel.stores}
    found = graph.rates(rates)
    functions = Functions(graph, {}, places | read)
    outputs = [graph.rate(leaves[n], found) if n in leaves else None for n in range(kernel.length)]
    functions.add(kernel.name, f"rates of {kernel.meaning}", outputs, dense=True)
    return lower(functions)[kernel.name]


def of_chain(motion: Mapping[str, Kernel]) -> dict[str, Kernel]:
    """Return the rates of a chain's kernels in motion, by their names."""
    pipeline = ("move_", "axes_", "ask", "give", "constants")
    return {name: tangent(k) for name, k in motion.items() if name.startswith(pipeline) and "each" not in name}


def of_limbs(
    mechanism: LimbMechanism, layout: Blocks, moving: Mapping[str, Kernel], motion: Mapping[str, Kernel]
) -> dict[str, Kernel]:
    """Return the rates of the kernels by which limbs stand and move, by their names; ``of_machine``: constants."""
    still = {lane(layout.shared["going"]), lane(layout.limb["q"])}
    still |= {lane(layout.limb["tool"] + j) for j in range(len(mechanism.tool))}
    standing = {name: moving[name] for name in ("early", "more", "rows", "joints", "inverse")}
    standing |= {"of_machine": moving["constants"]}
    every = standing | {name: kernel for name, kernel in motion.items() if name != "give_each"}
    found = {name: tangent(kernel, still) for name, kernel in every.items()}
    place = {lane(layout.limb["x"] + j) for j in range(len(mechanism.platform))}
    return found | {"move_platform": tangent(moving["move"], still | place)}  # errors move it by a step
