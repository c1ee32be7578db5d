"""What a machine in motion asks of its joints: derived kernels, linear in the inertial parameters of its bodies."""

from __future__ import annotations

import importlib
import importlib.util
from abc import ABC, abstractmethod
from collections.abc import Sequence
from functools import cached_property
from types import ModuleType

import numpy as np

from deltacal_gen.errors import NotForThisMachine, WrongArray
from deltacal_gen.machine.chain import Chain
from deltacal_gen.machine.limbs import Limbs
from deltacal_gen.machine.machine import COORDINATES
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
ROTOR_UNIT = {"rad": TENSOR_UNIT, "mm": "kg"}
PAYLOAD = "payload"  # of a platform: what is no body of the machine
GRAVITY = (0.0, 0.0, -9.81)
UNIFORM = 1.0 / 6.0  # of a uniform rod's mass, by Simpson's rule: at either end
LATTICE = (-300.0, -100.0, -30.0, 0.0, 30.0, 100.0, 300.0)  # mm, along each axis: masses of a body that could be built
ALONG = np.geomspace(3.0, 3000.0, 60)  # mm, either way along a body that turns about one axis: its masses
OF_LINE = {"m": 0, "mx": 1, "i": 2}  # parameters of such a body, by the moment of its masses along it


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
    rotors : tuple of int
        Joints, from 0, whose drive's inertia is a parameter of its own; these come after those of the bodies.
    gravity : (3,) array
        In {O} [m/s^2].
    """

    names: tuple[str, ...]
    units: tuple[str, ...]
    bodies: int = 0
    rotors: tuple[int, ...] = ()

    def __init__(self, robot: Robot, machine: Chain | Limbs) -> None:
        self._kernels, self._tool, self._robot = _kernels(machine.name), robot.tool, robot
        self.gravity = np.array(GRAVITY if robot.masses is None else robot.masses.gravity, dtype=float)
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
    def payload(self, motion: Array, off: Array | None = None) -> Array:
        """Return the torques (N, n_q) that 1 kg asks for at the tool point, or `off` (3,) it [mm] in the last frame."""

    @abstractmethod
    def of_payload(self, off: Array | None = None) -> Array:
        """Return the inertial parameters, as the kernels of `torque` read them, of 1 kg where `payload` has it."""

    @abstractmethod
    def stated(self, *, points: bool = False) -> Array:
        """Return the inertial parameters (n,) that the robot file states; NaN where it says nothing of a body.

        With `points` a body of which no inertia is said is a point.
        """

    @property
    @abstractmethod
    def numbers(self) -> dict[str, Array]:
        """What no motion changes, as the C source of a machine in motion reads it, by the names that this has."""

    @abstractmethod
    def buildable(self) -> Array:
        """Return the inertial parameters (K, n) of machines with one small mass each, at many places.

        Every sum of these with weights from 0 on could be built: masses are positive, inertias positive definite. What
        could be built is such a sum, as closely as the places are.
        """

    @abstractmethod
    def torque_by_errors(self, motion: Array, inertia: Array, names: Sequence[str]) -> Array:
        """Return the derivatives (N, n_q, n) of the torques by source errors, joints held [N mm, N per mm or rad].

        Forwards along the steps of the torque itself. With one parameter 1 and the others 0 they are those of its
        column of the regressor.

        Parameters
        ----------
        motion, inertia
            See `torque`.
        names : sequence of str
            Of source errors, of the mechanism's parameters.
        """

    def _rows_by(self, names: Sequence[str]) -> Array:
        """Return how rows of parameters (n, limbs or links, n_k) change with source errors: they are linear in them."""
        machine = mechanism_of(self._robot)
        along = np.eye(len(machine.parameters))[[machine.index[name] for name in names]]
        return machine.rows(self._robot, along) - machine.rows(self._robot, 0.0 * along)

    def of_points(self, places: Array) -> Array:
        """Return the inertial parameters (M, 10) of 1 kg at each of some places (M, 3) [mm] in a body's frame."""
        return np.array([self._kernels.of_point(place) for place in places])

    def _checked(self, motion: Array) -> Array:
        motion = np.ascontiguousarray(motion, dtype=float)
        if motion.ndim != 3 or motion.shape[0] != 3 or motion.shape[2] != self.joints:
            raise WrongArray(f"the motion has the shape {motion.shape}; (3, N, {self.joints}) was expected.")
        return motion


class ChainDynamics(Dynamics):
    """An open chain: ten parameters a link, and the inertia of the drives of which its tables state one."""

    def __init__(self, robot: Robot, machine: Chain) -> None:
        super().__init__(robot, machine)
        self._machine = machine
        self._own = self._kernels.constants(machine.rows(robot)[:, :, : machine.width])
        self.bodies = len(machine.links)
        own = [NAMES.get(s, (s, TENSOR_UNIT)) for s in self._kernels.INERTIA]
        driven = [k for k, link in enumerate(machine.links) if link.kind in ("revolute", "prismatic")]
        said = {j: machine.links[k].rotor_inertia for j, k in enumerate(driven)}
        self._rotors = {j: inertia for j, inertia in said.items() if inertia is not None}
        self.rotors = tuple(self._rotors)
        of_bodies = [(f"{name}_{body + 1}", unit) for body in range(self.bodies) for name, unit in own]
        of_rotors = [(f"rotor_{driven[j] + 1}", ROTOR_UNIT[self.joint_units[j]]) for j in self.rotors]
        self.names, self.units = zip(*of_bodies, *of_rotors, strict=True)
        self._of_bodies = len(of_bodies)

    def regressor(self, motion: Array) -> Array:
        """Return Y (N, n_q, n)."""
        motion = self._checked(motion)
        Y = np.empty((*motion.shape[1:], self._of_bodies))
        self._kernels.regressor(motion, self.gravity, self._own, *self._machine.shape, Y)
        return np.concatenate([Y, self._of_rotors(motion)], axis=2) if self.rotors else Y

    def torque(self, motion: Array, inertia: Array) -> Array:
        """Return the torques (N, n_q), by the recursion over links."""
        motion, tau = self._checked(motion), np.empty(np.shape(motion)[1:])
        inertia = np.asarray(inertia, dtype=float)
        masses = np.ascontiguousarray(inertia[: self._of_bodies]).reshape(self.bodies, -1)
        self._kernels.torque(motion, masses, self.gravity, self._own, *self._machine.shape, tau)
        return tau + self._of_rotors(motion) @ inertia[self._of_bodies :] if self.rotors else tau

    def _of_rotors(self, motion: Array) -> Array:
        """Return the torque (N, n_q, rotors) of each joint for each drive's inertia, which is 1."""
        out = np.zeros((*motion.shape[1:], len(self.rotors)))
        for n, j in enumerate(self.rotors):
            out[:, j, n] = motion[2, :, j] / 1000.0
        return out

    def torque_by_errors(self, motion: Array, inertia: Array, names: Sequence[str]) -> Array:
        """Return the derivatives (N, n_q, n) of the torques by source errors; those of the tool move no body."""
        motion, by = self._checked(motion), self._rows_by(names)[:, :, : self._machine.width]
        rows = self._machine.rows(self._robot)[:, :, : self._machine.width]
        tau = np.empty((len(names), *motion.shape[1:]))
        masses = np.ascontiguousarray(inertia[: self._of_bodies], dtype=float).reshape(self.bodies, -1)
        given = motion, masses, self.gravity, self._own, self._kernels.constants_by(rows, by)
        self._kernels.torque_by(*given, *self._machine.shape, tau)
        return np.moveaxis(tau, 0, 2)

    def payload(self, motion: Array, off: Array | None = None) -> Array:
        """Return the torques (N, n_q) that 1 kg asks for at the tool point, or off it, in the last frame."""
        return self.torque(motion, self.of_payload(off))

    def of_payload(self, off: Array | None = None) -> Array:
        """Return the parameters of 1 kg in the last frame."""
        own = self.of_points((self._tool if off is None else self._tool + off)[None])[0]
        return np.concatenate([np.zeros(self._of_bodies - len(own)), own, np.zeros(len(self.rotors))])

    @property
    def numbers(self) -> dict[str, Array]:
        """What tells the chain from others, and what no pose changes of each link (links, n_k)."""
        conventions, drives, much = self._machine.shape
        return {"CONVENTION": conventions, "DRIVE": drives, "MUCH": much, "LINK_K": np.asarray(self._own[0])}

    def stated(self, *, points: bool = False) -> Array:
        """Return what the tables of links state; a fixed one without a mass has no body."""
        links = [self._of_link(link, points) for link in self._machine.links]
        return np.concatenate([*links, list(self._rotors.values())])

    def buildable(self) -> Array:
        """Return a kilogram at each place of a lattice in each link's frame, and a drive at each joint."""
        points = self.of_points(np.array(np.meshgrid(*[LATTICE] * 3)).reshape(3, -1).T)
        made = np.zeros((self.bodies * len(points) + len(self.rotors), len(self.names)))
        made[: -len(self.rotors) or None, : self._of_bodies] = np.kron(np.eye(self.bodies), points)
        made[len(made) - len(self.rotors) :, self._of_bodies :] = np.eye(len(self.rotors))
        return made

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
    """A platform on limbs: velocities and accelerations follow from the closures, torques from virtual work."""

    def __init__(self, robot: Robot, machine: Limbs) -> None:
        super().__init__(robot, machine)
        self._robot, self._machine = robot, machine
        self._rows = machine.rows(robot)
        self.constants = machine.compiled.constants(self._rows), self._kernels.constants(self._rows)
        own = [(f"{name}_{i}", unit) for i in range(1, machine.limbs + 1) for name, unit, _ in self._kernels.LIMB]
        self.names, self.units = zip(*own, *((name, unit) for name, unit, _ in self._platform), strict=True)

    @property
    def _platform(self) -> tuple[tuple[str, str, str], ...]:
        """The platform's parameters but the payload, which is no part of the machine and comes last."""
        *own, (name, *_) = self._kernels.PLATFORM
        assert name == PAYLOAD
        return tuple(own)

    def regressor(self, motion: Array) -> Array:
        """Return Y (N, n_q, n); NaN where the machine cannot stand."""
        motion = self._checked(motion)
        Y = np.empty((*motion.shape[1:], len(self.names)))
        self._kernels.regressor(*self._given(motion), Y)
        return Y

    def torque(self, motion: Array, inertia: Array) -> Array:
        """Return the torques (N, n_q); NaN where the machine cannot stand."""
        return self._asked(motion, np.append(inertia, 0.0))

    def torque_by_errors(self, motion: Array, inertia: Array, names: Sequence[str]) -> Array:
        """Return the derivatives (N, n_q, n) of the torques by source errors; NaN where the machine cannot stand."""
        motion = self._checked(motion)
        x, _, tool, k, c, gravity, shares = self._given(motion)
        k_by, c_by = self._kernels.constants_by(self._rows, self._rows_by(names))
        tau = np.empty((len(names), *motion.shape[1:]))
        x_by, masses = self._moved_by(motion[0], names), np.append(inertia, 0.0)
        self._kernels.torque_by(x, x_by, motion, tool, k, k_by, c, c_by, gravity, shares, masses, tau)
        return np.moveaxis(tau, 0, 2)

    def _moved_by(self, q: Array, names: Sequence[str]) -> Array:
        """Return the twists of the platform (n, N, n_x) along source errors, joints held."""
        machine = self._machine
        at = [COORDINATES.index(name) for name in machine.platform]
        x, _ = machine.forward(q, self._tool, self._rows)
        found = machine.sensitivity(x, q, self._tool, self._rows).parameters
        return np.ascontiguousarray(np.moveaxis(found[:, at][:, :, [machine.index[name] for name in names]], 2, 0))

    def payload(self, motion: Array, off: Array | None = None) -> Array:
        """Return the torques (N, n_q) that 1 kg at the reference point asks for.

        A platform that only translates asks the same wherever on it that is.
        """
        return self._asked(motion, self.of_payload())

    def of_payload(self, off: Array | None = None) -> Array:
        """Return the parameters of 1 kg, which comes after those of the machine."""
        return np.append(np.zeros(len(self.names)), 1.0)

    def stated(self, *, points: bool = False) -> Array:
        """Return what [masses] states; a mass that is not given is none."""
        if (own := self._robot.masses) is None:
            return np.full(len(self.names), np.nan)
        masses = dict.fromkeys(("carriage", "distal_inertia", "rotor_inertia"), 0.0) | own.numbers
        arm = self._machine.limb_inertia(self._robot, masses) if own.proximal_inertia is None else own.proximal_inertia
        found = self._kernels.stated(self._robot.geometry, masses, arm + masses["rotor_inertia"])
        limbs = [found[name] * np.ones(self.joints) for name, *_ in self._kernels.LIMB]
        return np.append(np.array(limbs).T.ravel(), [found[name] for name, *_ in self._platform])

    def buildable(self) -> Array:
        """Return a kilogram at each place along each body that turns, what lies across it, and each other mass."""
        x, at = np.concatenate([-ALONG[::-1], [0.0], ALONG]), {name: n for n, name in enumerate(self.names)}
        bodies: dict[str, dict[int, int]] = {}
        for name in self.names:
            moment, _, of = name.partition("_")
            bodies.setdefault(of, {})[OF_LINE[moment]] = at[name]
        rows = []
        for moments in bodies.values():
            turns = max(moments) > 0
            made = np.zeros((len(x) + 1 if turns else 1, len(self.names)))
            for power, n in moments.items():
                made[: len(x), n] = x**power if turns else 1.0
            if turns:
                made[-1, moments[max(moments)]] = 1.0
            rows.append(made)
        return np.concatenate(rows)

    @cached_property
    def shares(self) -> Array:
        """How much of a rod's mass moves like either of its ends (limbs,); the rest moves like its middle."""
        own = self._robot.masses
        if own is None or not own.distal_rod or own.distal_inertia is None:
            return np.full(self.joints, UNIFORM)
        return (
            2
            * own.distal_inertia
            / (own.distal_rod * self._machine.roles(self._robot)["l"] ** 2)
            * np.ones(self.joints)
        )

    @property
    def numbers(self) -> dict[str, Array]:
        """What no pose changes in the closures and in the bodies, and how the rods' masses move."""
        return {"MOTION_K": self.constants[0][0], "BODY_K": self.constants[1][0], "SHARES": self.shares}

    def _given(self, motion: Array) -> tuple[Array, ...]:
        """Return what the kernels read."""
        tool = np.ascontiguousarray(self._tool[None], dtype=float)
        x = self._machine.closed(motion[0], tool, self._rows)
        return x, motion, tool, *self.constants, self.gravity, self.shares

    def _asked(self, motion: Array, inertia: Array) -> Array:
        motion = self._checked(motion)
        tau = np.empty(motion.shape[1:])
        self._kernels.torque(*self._given(motion), np.ascontiguousarray(inertia, dtype=float), tau)
        return tau


def dynamics_of(robot: Robot) -> Dynamics:
    """Return the dynamics of a robot; its source errors are part of the kinematics.

    Raises
    ------
    UsageError
        The dynamics of the mechanism are not derived.
    """
    machine = mechanism_of(robot)
    if not _found(machine.name):
        raise NotForThisMachine(f"the dynamics of {machine.name} are not derived; those of {', '.join(known())} are.")
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
