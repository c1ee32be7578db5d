"""One file per effect; a file's presence is its registration (it defines ``EFFECT``).

``derive.language.states`` lists all that an effect may read, per pose and limb, and ``derive.language.targets`` what it
may move; a mechanism says in ``roles`` and ``moves`` which of its own symbols these are. Loads are what the weights
exert by virtual work on the closure: `torque` on the joint, `pull_v` and `pull_w` on the arm's tip along the normals of
the arm, `tension_1` and `tension_2` in the rods, `moment_x` and `moment_y` about {O}.
"""

from __future__ import annotations

import sympy as sp

from derive.language.effects import EffectQuantity
from derive.language.states import DEG, STATES, covariate, state

__all__ = ["DEG", "coefficient", "constant", "covariate", "joint_coefficient", "state", "torque_coefficient"]


def coefficient(name: str, unit: str, factor: float, meaning: str, believable: tuple[float, float]) -> EffectQuantity:
    """Return a coefficient: its unit in files, the factor to mm, rad, N and s, what it is, and its believable range."""
    symbol = sp.Symbol(f"c_{name}" if name in STATES else name, real=True)
    return EffectQuantity(symbol, unit, factor, meaning, believable, label=name)


def constant(name: str, unit: str, factor: float, meaning: str, *, of_joint: bool = False) -> EffectQuantity:
    """Return a constant, which is searched: its unit in files, the factor to mm, rad, N and s, and what it is."""
    return EffectQuantity(sp.Symbol(name, real=True), unit, factor, meaning, of_joint=of_joint)


def joint_coefficient(name: str, per: str, meaning: str, believable: tuple[float, float]) -> EffectQuantity:
    """Return a coefficient that moves a joint `per` Nm, K or h (per nothing: ``""``).

    It is in deg and Nm where the joint turns; where it slides, read mm and N.
    """
    unit, factor = (f"deg/{per}", DEG / 1000 if per == "Nm" else DEG) if per else ("deg", DEG)
    return EffectQuantity(sp.Symbol(name, real=True), unit, factor, meaning, believable, of_joint=True)


def torque_coefficient(name: str, per: str, meaning: str, believable: tuple[float, float]) -> EffectQuantity:
    """Return a coefficient of what a drive gives, in Nm times `per` (nothing, s/deg ...): where it slides N and mm."""
    angles = 2 if "deg^2" in per else per.count("deg")
    unit, factor = f"Nm {per}".strip().replace(" /", "/"), 1000.0 / DEG**angles
    return EffectQuantity(sp.Symbol(name, real=True), unit, factor, meaning, believable, of_joint=True)
