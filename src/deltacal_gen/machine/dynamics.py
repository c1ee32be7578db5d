"""What a machine in motion asks of its joints: derived kernels, linear in the inertial parameters of its bodies."""

from __future__ import annotations

import importlib
import importlib.util
from collections.abc import Sequence
from types import ModuleType

import numpy as np

from deltacal_gen.errors import UsageError
from deltacal_gen.machine.chain import Chain
from deltacal_gen.machine.machine import Machine
from deltacal_gen.machine.registry import mechanism_names, mechanism_of
from deltacal_gen.machine.rotation import Array
from deltacal_gen.machine.values import Link, Robot

NAMES = {  # as results call the parameters of a body, and their units
    "m": ("m", "kg"),
    "m_x": ("mx", "kg mm"),
    "m_y": ("my", "kg mm"),
    "m_z": ("mz", "kg mm"),
}
TENSOR_UNIT = "kg mm^2"


class Dynamics:
    """The bodies of one robot in motion: torques by joints, velocities and accelerations, as the geometry counts them.

    Parameters
    ----------
    robot : Robot
        An open chain; its source errors are part of the kinematics.

    Attributes
    ----------
    names, units : tuple of str
        Of the inertial parameters, body by body.
    joints, joint_units : int, tuple of str
        How many joints there are, and rad or mm of each.

    Raises
    ------
    UsageError
        The dynamics of the mechanism are not derived.
    """

    def __init__(self, robot: Robot) -> None:
        machine = mechanism_of(robot)
        if not derived(machine):
            raise UsageError(f"the dynamics of {machine.name} are not derived; those of {', '.join(known())} are.")
        assert isinstance(machine, Chain)
        self._machine, self._kernels = machine, _kernels(machine.name)
        self._own = self._kernels.constants(machine.rows(robot)[:, :, : machine.width])
        self._gravity = np.array((0.0, 0.0, -9.81) if robot.masses is None else robot.masses.gravity, dtype=float)
        bodies = range(1, len(machine.links) + 1)
        own = [NAMES.get(s, (s, TENSOR_UNIT)) for s in self._kernels.INERTIA]
        self.names = tuple(f"{name}_{body}" for body in bodies for name, _ in own)
        self.units = tuple(unit for _ in bodies for _, unit in own)
        self.joints = machine.limbs
        self.joint_units = machine.joint_units

    def regressor(self, motion: Array) -> Array:
        """Return Y (N, n_q, n): the torque [N mm, N] of each joint for each inertial parameter, which is 1.

        Parameters
        ----------
        motion : (3, N, n_q) array
            Joints, velocities, accelerations [rad, mm, s].
        """
        motion = self._checked(motion)
        Y = np.empty((*motion.shape[1:], len(self.names)))
        self._kernels.regressor(motion, self._gravity, self._own, *self._machine.shape, Y)
        return Y

    def torque(self, motion: Array, inertia: Array) -> Array:
        """Return the torques (N, n_q) [N mm, N] that the joints must give, for inertial parameters (n,)."""
        motion, tau = self._checked(motion), np.empty(np.shape(motion)[1:])
        masses = np.ascontiguousarray(inertia, dtype=float).reshape(len(self._machine.links), -1)
        self._kernels.torque(motion, masses, self._gravity, self._own, *self._machine.shape, tau)
        return tau

    def of_payload(self, place: Sequence[float] | Array) -> Array:
        """Return the inertial parameters (n,) that 1 kg at a place (3,) [mm] in the last frame adds."""
        own = self._kernels.of_point(np.asarray(place, dtype=float))
        return np.concatenate([np.zeros(len(self.names) - len(own)), own])

    def of_points(self, places: Array) -> Array:
        """Return the inertial parameters (M, 10) of 1 kg at each of some places (M, 3) [mm] in a link's frame."""
        return np.array([self._kernels.of_point(place) for place in places])

    def stated(self, *, points: bool = False) -> Array:
        """Return the inertial parameters (n,) that the robot file states; NaN where it says nothing of a body.

        A fixed table without a mass has no body. With `points` a body of which no inertia is said is a point.
        """
        return np.concatenate([self._of_link(link, points) for link in self._machine.links])

    def _of_link(self, link: Link, points: bool) -> Array:
        if not link.mass:
            return np.full(len(self._kernels.INERTIA), 0.0 if link.kind == "fixed" else np.nan)
        found = link.mass * self._kernels.of_point(np.array(link.com))
        tensor = slice(len(NAMES), None)
        if link.inertia is not None:
            found[tensor] += link.inertia
        elif not points:
            found[tensor] = np.nan
        return np.asarray(found)

    def _checked(self, motion: Array) -> Array:
        motion = np.ascontiguousarray(motion, dtype=float)
        if motion.ndim != 3 or motion.shape[0] != 3 or motion.shape[2] != self.joints:
            raise UsageError(f"the motion has the shape {motion.shape}; (3, N, {self.joints}) was expected.")
        return motion


def derived(machine: Machine) -> bool:
    """Tell whether the dynamics of a machine are derived."""
    return _found(machine.name)


def known() -> tuple[str, ...]:
    """Return the mechanisms whose dynamics are derived."""
    return tuple(name for name in mechanism_names() if _found(name))


def _found(name: str) -> bool:
    return importlib.util.find_spec(f"deltacal_kernels.{name}.dynamics") is not None


def _kernels(name: str) -> ModuleType:
    return importlib.import_module(f"deltacal_kernels.{name}.dynamics")
