"""What a machine in motion asks of its joints: derived kernels, linear in the inertial parameters of its bodies."""

from __future__ import annotations

import importlib
import importlib.util
from abc import ABC, abstractmethod
from functools import cached_property
from types import ModuleType

import numpy as np

from deltacal_gen.errors import UsageError
from deltacal_gen.machine.chain import Chain
from deltacal_gen.machine.limbs import Limbs
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
PAYLOAD = "payload"  # of a platform: what is no body of the machine
GRAVITY = (0.0, 0.0, -9.81)


class Dynamics(ABC):
    """The bodies of one robot in motion: torques by joints, velocities and accelerations, as the geometry counts them.

    Attributes
    ----------
    names, units : tuple of str
        Of the inertial parameters, body by body.
    joints, joint_units : int, tuple of str
        How many joints there are, and rad or mm of each.
    bodies : int
        How many bodies have ten parameters each; 0 where bodies have others.
    """

    names: tuple[str, ...]
    units: tuple[str, ...]
    bodies: int = 0

    def __init__(self, robot: Robot, machine: Chain | Limbs) -> None:
        self._kernels, self._tool = _kernels(machine.name), robot.tool
        self._gravity = np.array(GRAVITY if robot.masses is None else robot.masses.gravity, dtype=float)
        self.joints, self.joint_units = machine.limbs, machine.joint_units

    @abstractmethod
    def regressor(self, motion: Array) -> Array:
        """Return Y (N, n_q, n): the torque [N mm, N] of each joint for each inertial parameter, which is 1.

        Parameters
        ----------
        motion : (3, N, n_q) array
            Joints, velocities, accelerations [rad, mm, s].
        """

    @abstractmethod
    def torque(self, motion: Array, inertia: Array) -> Array:
        """Return the torques (N, n_q) [N mm, N] that the joints must give, for inertial parameters (n,)."""

    @abstractmethod
    def payload(self, motion: Array) -> Array:
        """Return the torques (N, n_q) that 1 kg at the tool point asks for."""

    @abstractmethod
    def stated(self, *, points: bool = False) -> Array:
        """Return the inertial parameters (n,) that the robot file states; NaN where it says nothing of a body.

        With `points` a body of which no inertia is said is a point.
        """

    def of_points(self, places: Array) -> Array:
        """Return the inertial parameters (M, 10) of 1 kg at each of some places (M, 3) [mm] in a body's frame."""
        return np.array([self._kernels.of_point(place) for place in places])

    def _checked(self, motion: Array) -> Array:
        motion = np.ascontiguousarray(motion, dtype=float)
        if motion.ndim != 3 or motion.shape[0] != 3 or motion.shape[2] != self.joints:
            raise UsageError(f"the motion has the shape {motion.shape}; (3, N, {self.joints}) was expected.")
        return motion


class ChainDynamics(Dynamics):
    """An open chain: ten parameters a link."""

    def __init__(self, robot: Robot, machine: Chain) -> None:
        super().__init__(robot, machine)
        self._machine = machine
        self._own = self._kernels.constants(machine.rows(robot)[:, :, : machine.width])
        self.bodies = len(machine.links)
        own = [NAMES.get(s, (s, TENSOR_UNIT)) for s in self._kernels.INERTIA]
        self.names = tuple(f"{name}_{body + 1}" for body in range(self.bodies) for name, _ in own)
        self.units = tuple(unit for _ in range(self.bodies) for _, unit in own)

    def regressor(self, motion: Array) -> Array:
        """Return Y (N, n_q, n)."""
        motion = self._checked(motion)
        Y = np.empty((*motion.shape[1:], len(self.names)))
        self._kernels.regressor(motion, self._gravity, self._own, *self._machine.shape, Y)
        return Y

    def torque(self, motion: Array, inertia: Array) -> Array:
        """Return the torques (N, n_q), by the recursion over links."""
        motion, tau = self._checked(motion), np.empty(np.shape(motion)[1:])
        masses = np.ascontiguousarray(inertia, dtype=float).reshape(self.bodies, -1)
        self._kernels.torque(motion, masses, self._gravity, self._own, *self._machine.shape, tau)
        return tau

    def payload(self, motion: Array) -> Array:
        """Return the torques (N, n_q) that 1 kg at the tool point asks for, in the last frame."""
        own = self.of_points(self._tool[None])[0]
        return self.torque(motion, np.concatenate([np.zeros(len(self.names) - len(own)), own]))

    def stated(self, *, points: bool = False) -> Array:
        """Return what the tables of links state; a fixed one without a mass has no body."""
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


class LimbDynamics(Dynamics):
    """A platform on limbs: velocities and accelerations follow from the closures, torques from their multipliers."""

    def __init__(self, robot: Robot, machine: Limbs) -> None:
        super().__init__(robot, machine)
        self._robot, self._machine, self._rows = robot, machine, machine.rows(robot)
        limbs = range(1, machine.limbs + 1)
        platform = [(name, unit) for name, unit, _ in self._kernels.PLATFORM]
        self._payload = [name for name, _ in platform].index(PAYLOAD)
        platform.pop(self._payload)
        own = [(f"{name}_{i}", unit) for i in limbs for name, unit, _ in self._kernels.LIMB]
        self.names, self.units = zip(*own, *platform, strict=True)

    def regressor(self, motion: Array) -> Array:
        """Return Y (N, n_q, n); NaN where the machine cannot stand."""
        return np.delete(self._asked(motion), self._at_payload, axis=2)

    def torque(self, motion: Array, inertia: Array) -> Array:
        """Return the torques (N, n_q)."""
        return np.asarray((self.regressor(motion) * np.asarray(inertia, dtype=float)).sum(axis=2))

    def payload(self, motion: Array) -> Array:
        """Return the torques (N, n_q) that 1 kg at the reference point asks for."""
        return np.asarray(self._asked(motion)[:, :, self._at_payload])

    def stated(self, *, points: bool = False) -> Array:
        """Return what [masses] states; a mass that is not given is none."""
        if self._robot.masses is None:
            return np.full(len(self.names), np.nan)
        masses = self._robot.masses.model_dump()
        own = masses["proximal_inertia"]
        own = self._machine.limb_inertia(self._robot, masses) if own is None else own
        found = self._kernels.stated(self._robot.geometry, masses, own)
        limbs = [found[name] * np.ones(self.joints) for name, *_ in self._kernels.LIMB]
        return np.append(np.array(limbs).T.ravel(), [found[n] for n, *_ in self._kernels.PLATFORM if n in found])

    @cached_property
    def _at_payload(self) -> int:
        return self.joints * len(self._kernels.LIMB) + self._payload

    def _asked(self, motion: Array) -> Array:
        """Return the regressor (N, n_q, n) with the payload's column among those of the platform."""
        motion = self._checked(motion)
        tool = np.ascontiguousarray(np.broadcast_to(self._tool, (motion.shape[1], 3)))
        pose, _ = self._machine.forward(motion[0], tool, self._rows)
        x, limb = (
            self._machine.coordinates(pose),
            np.repeat(np.arange(self.joints), self._kernels.EQUATIONS // self.joints),
        )
        known = x, motion, tool, self._rows
        _, J_x, J_q = self._kernels.closing(x, np.zeros_like(x), *known[1:])
        x_t = _solved(J_x, -J_q * motion[1][:, limb])
        curved, _, _ = self._kernels.closing(x, x_t, *known[1:])
        x_tt = _solved(J_x, -curved - J_q * motion[2][:, limb])
        limbs, platform = self._kernels.asks(x, x_t, x_tt, *known[1:], self._gravity)
        N, n = len(x), self.joints * limbs.shape[2]
        on_joints = np.zeros((N, self.joints, n + platform.shape[1]))
        for i in range(self.joints):
            on_joints[:, i, i * limbs.shape[2] : (i + 1) * limbs.shape[2]] = limbs[:, i, :, 0]
        on_platform = np.concatenate([limbs[..., 1:].reshape(N, n, -1), platform], axis=1)
        pulls = np.linalg.solve(np.swapaxes(J_x, 1, 2), -np.swapaxes(on_platform, 1, 2))  # multipliers of the closures
        for e, i in enumerate(limb.tolist()):
            on_joints[:, i] += J_q[:, e, None] * pulls[:, e]
        return -on_joints  # joints give what holds against the loads


def _solved(J: Array, wanted: Array) -> Array:
    return np.asarray(np.linalg.solve(J, wanted[..., None])[..., 0])


def dynamics_of(robot: Robot) -> Dynamics:
    """Return the dynamics of a robot; its source errors are part of the kinematics.

    Raises
    ------
    UsageError
        The dynamics of the mechanism are not derived.
    """
    machine = mechanism_of(robot)
    if not _found(machine.name):
        raise UsageError(f"the dynamics of {machine.name} are not derived; those of {', '.join(known())} are.")
    if isinstance(machine, Chain):
        return ChainDynamics(robot, machine)
    assert isinstance(machine, Limbs)
    return LimbDynamics(robot, machine)


def known() -> tuple[str, ...]:
    """Return the mechanisms whose dynamics are derived."""
    return tuple(name for name in mechanism_names() if _found(name))


def _found(name: str) -> bool:
    return importlib.util.find_spec(f"deltacal_kernels.{name}.dynamics") is not None


def _kernels(name: str) -> ModuleType:
    return importlib.import_module(f"deltacal_kernels.{name}.dynamics")
