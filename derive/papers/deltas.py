"""Deltas without rounding: with any limbs of rational numbers, or closed over a prime field."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from typing import Any

import sympy as sp

from derive.mechanisms.delta import L, a, b, c, l, phi, tool
from derive.papers import exact
from derive.papers.exact import Field, Machine, Number, dot, rationals, turned
from derive.papers.letters import vector

theta = sp.Symbol("theta", real=True)  # the joint's angle
lhat = vector("lhat")  # the unit vector along the rods, from the elbow to the platform
ANGLES = tuple(turned(f(s)) for s in (theta, phi) for f in (sp.cos, sp.sin))


def _limb(cos_sin: tuple[Number, Number], direction: tuple[Number, Number], along: Sequence[Number]) -> dict[Any, Any]:
    angles = dict(zip(ANGLES, (*cos_sin, *direction), strict=True))
    return {**angles, **dict(zip(lhat, along, strict=True))}


def rational_machine(seed: int) -> Machine:
    """Return a machine with rational lengths and directions, its limbs in any directions about z."""
    rng = random.Random(seed)
    shared = {s: exact.rational(rng) for s in (L, l, a, b, c, *tool)}
    limbs = (_limb(exact.on_circle(rng), exact.on_circle(rng), exact.on_sphere(rng)) for _ in range(3))
    return rationals(shared | limb for limb in limbs)


def closed_machine(field: Field, lengths: Mapping[sp.Symbol, Number], centre: Sequence[Number]) -> Machine | None:
    """Return the paper's machine with O' at a place, or None where a limb does not reach it."""
    half = field(sp.Rational(1, 2))
    x, y, z = centre
    e = lengths[a] - lengths[b]
    limbs = []
    for C, S in ((field(0), field(-1)), (half * field.root3, half), (-half * field.root3, half)):
        r = (x + e * C, y + e * S, z)
        level = (dot(r, r) + lengths[L] ** 2 - lengths[l] ** 2) / (field(2) * lengths[L])
        found = field.angle(r[0] * C + r[1] * S, z, level)
        if found is None:
            return None
        tip = [lengths[L] * k for k in (found[0] * C, found[0] * S, found[1])]
        along = [(k - t) / lengths[l] for k, t in zip(r, tip, strict=True)]
        limbs.append({**lengths, **_limb(found, (C, S), along)})
    return Machine(tuple(limbs), field.domain, field)


def places(field: Field, rng: random.Random, lengths: Mapping[sp.Symbol, Number], count: int) -> list[list[Number]]:
    """Return places of O' that all three limbs reach."""
    found: list[list[Number]] = []
    while len(found) < count:
        place = [field.any(rng) for _ in range(3)]
        if closed_machine(field, lengths, place) is not None:
            found.append(place)
    return found


def lengths_of(field: Field, rng: random.Random) -> dict[sp.Symbol, Number]:
    """Return lengths drawn at random, the tool point at O'."""
    return {s: field.any(rng) for s in (L, l, a, b, c)} | dict.fromkeys(tool, field(0))
