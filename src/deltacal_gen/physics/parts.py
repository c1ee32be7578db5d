"""Which of the parts that an effect moves, and of the lengths and loads that it reads, a mechanism has."""

from __future__ import annotations

from collections.abc import Container

from deltacal_gen import states
from deltacal_gen.machine.registry import Machine
from deltacal_gen.physics.targets import parts_of
from deltacal_gen.physics.terms import Kernels, load_effect


def lacking(effect: str, mechanism: Machine, moves: Container[str], roles: Container[str]) -> list[str]:
    """Return what an effect moves or reads of a machine and a mechanism does not have.

    Parameters
    ----------
    moves, roles : container of str
        Parts and lengths by which effects find their place in the mechanism.
    """
    kernels = load_effect(effect)
    read = states.read_by(kernels)
    without = _without(kernels, mechanism, moves, roles)
    parts = [] if {} in without and not kernels.WHOLE else list({part: None for each in without for part in each})
    if any(s.of_geometry for s in read) and "offset" not in moves:
        parts.append("angle of a joint")
    if any(s.kind == "load" for s in read) and not mechanism.weighs:
        parts.append("weights")
    if "height" in kernels.TARGETS and "z" not in mechanism.axes:
        parts.append("heights")
    parts += [f"joint {s.joint}" for s in read if s.joint > mechanism.limbs]
    return parts


def lacks(effect: str, mechanism: Machine, moves: Container[str], roles: Container[str]) -> tuple[str, ...]:
    """Return the coefficients of an effect that move no part of a mechanism with these parts and lengths.

    After them the targets that are not there of coefficients that move others, too.
    """
    kernels = load_effect(effect)
    without = _without(kernels, mechanism, moves, roles)
    there = {name for each, (names, _) in zip(without, kernels.PARTS, strict=True) if not each for name in names}
    parts = zip(without, kernels.PARTS, kernels.TARGETS, strict=True)
    targets = [target for each, (names, _), target in parts if each and there & set(names)]
    return (*(name for name, *_ in kernels.COEFFICIENTS if name not in there), *targets)


def _without(
    kernels: Kernels, mechanism: Machine, moves: Container[str], roles: Container[str]
) -> list[dict[str, None]]:
    """Return the parts, lengths and loads that each target of an effect needs and that are not there."""
    found = []
    for target, (_, read) in zip(kernels.TARGETS, kernels.PARTS, strict=True):
        missing = [part for part in parts_of((target,)) if part not in moves]
        for s in map(states.named, read):
            unknown = s.kind == "geometry" and s.name not in roles
            if unknown or (s.kind == "load" and mechanism.weighs and not has_load(mechanism, s)):
                missing.append(s.name)
        found.append(dict.fromkeys(missing))
    return found


def has_load(mechanism: Machine, s: states.State) -> bool:
    """Return whether weights exert a load in a mechanism, where they act in it at all."""
    return (not s.along or s.along in mechanism.deflections) and (mechanism.looped or not s.rods)


def along_deflections(mechanism: Machine) -> dict[str, int]:
    """Return the states of what weights exert along deflections of a mechanism, and along which, counted from 0."""
    by = {s.along: s.name for s in states.STATES.values() if s.along}
    return {by[name]: d for d, name in enumerate(mechanism.deflections) if name in by}
