"""One file per effect; a file's presence is its registration (it defines ``EFFECT``).

`STATE` is all that an effect may read, per pose and limb, and `PARTS` what of a limb it may move; a mechanism says in
``roles`` and ``moves`` which of its own symbols these are. Loads are what the weights exert by virtual work on the
closure: `torque` on the joint, `pull_v` and `pull_w` on the arm's tip along the normals of the arm, `tension_1` and
`tension_2` in the rods, `moment_x` and `moment_y` about {O}.
"""

from __future__ import annotations

import math

import sympy as sp

from derive.spec import EffectQuantity

DEG = math.pi / 180

STATE = (
    EffectQuantity(sp.Symbol("q", real=True), "deg", DEG, "joint as the controller reports it"),
    EffectQuantity(sp.Symbol("theta", real=True), "deg", DEG, "joint as the geometry sees it"),
    EffectQuantity(sp.Symbol("turn", real=True), "deg", DEG, "turn of the joint; of its pulley, where it slides"),
    EffectQuantity(sp.Symbol("speed", real=True), "deg/s", DEG, "joint speed"),
    EffectQuantity(sp.Symbol("acceleration", real=True), "deg/s^2", DEG, "joint acceleration"),
    EffectQuantity(sp.Symbol("approach", real=True), "1", 1.0, "direction in which the joint last moved, +1 or -1"),
    EffectQuantity(sp.Symbol("warming", real=True), "K", 1.0, "temperature less 20 degC"),
    EffectQuantity(sp.Symbol("time", real=True), "s", 1.0, "time"),
    EffectQuantity(sp.Symbol("after", real=True), "1", 1.0, "1 from the jump on, 0 before"),
    EffectQuantity(sp.Symbol("torque", real=True), "N mm", 1.0, "static torque of all weights on the joint"),
    EffectQuantity(sp.Symbol("payload_torque", real=True), "N mm", 1.0, "static torque of the payload on the joint"),
    EffectQuantity(
        sp.Symbol("inertia_torque", real=True), "N mm", 1.0, "torque of the masses times minus their acceleration"
    ),
    EffectQuantity(
        sp.Symbol("pull_v", real=True), "N", 1.0, "rods' pull on the arm's tip, normal to the arm in its plane"
    ),
    EffectQuantity(sp.Symbol("pull_w", real=True), "N", 1.0, "rods' pull on the arm's tip, along the joint's axis"),
    EffectQuantity(sp.Symbol("tension_1", real=True), "N", 1.0, "tension of rod 1"),
    EffectQuantity(sp.Symbol("tension_2", real=True), "N", 1.0, "tension of rod 2"),
    EffectQuantity(sp.Symbol("moment_x", real=True), "N mm", 1.0, "moment of all moving weight about {O}, x"),
    EffectQuantity(sp.Symbol("moment_y", real=True), "N mm", 1.0, "moment of all moving weight about {O}, y"),
    EffectQuantity(sp.Symbol("L", real=True), "mm", 1.0, "length of the arm"),
    EffectQuantity(sp.Symbol("l", real=True), "mm", 1.0, "length of the rods"),
    EffectQuantity(sp.Symbol("b", real=True), "mm", 1.0, "radius of the base"),
    EffectQuantity(sp.Symbol("y_x", real=True), "mm", 1.0, "reading along the instrument's x"),
    EffectQuantity(sp.Symbol("y_y", real=True), "mm", 1.0, "reading along the instrument's y"),
    EffectQuantity(sp.Symbol("y_z", real=True), "mm", 1.0, "reading along the instrument's z"),
    EffectQuantity(sp.Symbol("y_length", real=True), "mm", 1.0, "reading of a length"),
    EffectQuantity(sp.Symbol("p_x", real=True), "mm", 1.0, "reference point, x in {O}"),
    EffectQuantity(sp.Symbol("p_y", real=True), "mm", 1.0, "reference point, y in {O}"),
)
PARTS = {
    "offset": "zero of the joint",
    "arm": "length of the arm",
    "rod": "length of the rods, mean of the pair",
    "rod_difference": "length of the rods, rod 1 minus rod 2",
    "outwards": "joint centre along the limb's direction, away from the base's centre",
    "tip_v": "arm's tip normal to the arm, in its plane",
    "tip_w": "arm's tip normal to the arm, along the joint's axis",
    "spacing_difference": "spacing of the rods, at the elbow minus at the platform",
    "hand_axis_u": "axis of the platform's joints about the limb's direction, the elbow's less the platform's",
    "hand_axis_v": "the same about the normal of the base",
    "elbow_axis_u": "axis of the elbow's joints about the arm",
    "elbow_axis_v": "axis of the elbow's joints about the normal of the arm",
    "pair_difference": "rod 1 minus rod 2, where the platform tilts by it",
    "lean_radial": "axis of a sliding joint, outwards",
    "lean_tangential": "axis of a sliding joint, counter-clockwise",
}
_BY_NAME = {s.name: s.symbol for s in STATE}


def state(names: str) -> tuple[sp.Symbol, ...]:
    """Return symbols of the state by name."""
    return tuple(_BY_NAME[name] for name in names.split())


def coefficient(name: str, unit: str, factor: float, meaning: str) -> EffectQuantity:
    """Return a coefficient: its unit in files, the factor to mm, rad, N and s, and what it is."""
    return EffectQuantity(sp.Symbol(name, real=True), unit, factor, meaning)


def joint_coefficient(name: str, per: str, meaning: str) -> EffectQuantity:
    """Return a coefficient that moves a joint `per` Nm, K or h (per nothing: ``""``).

    It is in deg and Nm where the joint turns; where it slides, read mm and N.
    """
    unit, factor = (f"deg/{per}", DEG / 1000 if per == "Nm" else DEG) if per else ("deg", DEG)
    return EffectQuantity(sp.Symbol(name, real=True), unit, factor, meaning, of_joint=True)
