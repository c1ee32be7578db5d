"""How far, how fast and how quickly faster joints may move: what the robot file says, and what is assumed where not."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.errors import NoPlan
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.states import ACCELERATIONS, JOINTS, SPEEDS
from deltacal_gen.units import DEG, joint_factors, joint_names

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

USUAL = {  # where the robot file says nothing: way either side of the middle, speed, acceleration
    "rad": (60 * DEG, 60 * DEG, 240 * DEG),
    "mm": (150.0, 200.0, 1000.0),
}
PATTERNS = (JOINTS, SPEEDS, ACCELERATIONS)


def limits_of(robot: Robot) -> tuple[tuple[Array, Array, Array, Array], list[str]]:
    """Return the ends of the joints, highest speeds and accelerations, (n_q,) each, and in words what was assumed.

    Positions are those of [joints], speeds and accelerations those of [limits] (`qd1_deg_s`, `qdd1_deg_s2` ...).
    """
    machine, notes = mechanism_of(robot), list[str]()
    usual = np.array([USUAL[unit] for unit in machine.joint_units]).T
    factors = np.array(joint_factors(machine.joint_unit, machine.limbs))
    found = []
    for row, pattern in enumerate(PATTERNS[1:], start=1):
        names = joint_names(machine.joint_unit, machine.limbs, pattern)
        said = np.array([min(map(abs, robot.limits[name])) if name in robot.limits else np.nan for name in names])
        found.append(np.where(np.isnan(said), usual[row], said * factors))
        if np.isnan(said).any():
            values = ", ".join(f"{name} {v:g}" for name, v in zip(names, found[-1] / factors, strict=True))
            notes.append(f"[limits] of the robot file does not say all of them; taken are {values}")
    if robot.joint_limits is not None:
        low, high = robot.joint_limits.T
    else:
        middle = home_of(robot)
        low, high = middle - usual[0], middle + usual[0]
        ways = ", ".join(f"{v:g}" for v in usual[0] / factors)
        notes.append(f"[joints] gives no limits; taken are {ways} to either side of home")
    return (low, high, found[0], found[1]), notes


def home_of(robot: Robot) -> Array:
    """Return where the joints stand in the middle of the workspace (n_q,); of a chain, or without one, at zero."""
    machine = mechanism_of(robot)
    if machine.many_ways or robot.workspace is None:
        return np.zeros(machine.limbs)
    q, _, status = machine.inverse(robot.workspace.home[None], robot.tool, machine.rows(robot))
    if status.any():
        raise NoPlan("the machine does not reach the middle of its workspace: no trajectory begins there.")
    return np.asarray(robot.joint_sign * q[0])
