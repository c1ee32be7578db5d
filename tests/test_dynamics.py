"""The derived dynamics: against Newton and Euler, and Lagrange, by hand; their linearity; the energy they keep."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pytest

from deltacal_gen.errors import UsageError
from deltacal_gen.machine.dynamics import Dynamics, dynamics_of
from deltacal_gen.machine.registry import mechanism_of
from tests import independent_delta, independent_dynamics
from tests.every_effect import ARM, LIFT, PRINTER, chain, machines, robot_from_dict, targets

COUPLED: list[dict[str, Any]] = [
    *ARM[:3],
    {"kind": "coupled", "a": 100.0, "alpha": 30.0, "coupling": {"2": -1.0, "3": 0.5}},
    *ARM[3:],
]
CHAINS = {
    "arm": ARM,
    "lift": LIFT,
    "modified": [link | {"convention": "modified"} for link in ARM],
    "coupled": COUPLED,
    "fixed": [*LIFT[:2], {"kind": "fixed", "a": 70.0, "alpha": 20.0}, *LIFT[2:]],
}
GRAVITY = (1.0, -2.0, -9.0)


def dynamics(links: Sequence[Mapping[str, Any]], gravity: Sequence[float] = GRAVITY) -> Dynamics:
    head = {"robot": {"name": "arm", "mechanism": "serial"}, "geometry": {"tool": [40.0, -15.0, 90.0]}}
    tables = head | {"joint": [dict(link) for link in links], "masses": {"gravity": list(gravity)}}
    return dynamics_of(robot_from_dict(tables))


def states(links: Sequence[Mapping[str, Any]], n: int, seed: int = 0) -> np.ndarray:
    """Return joints, velocities and accelerations (3, n, n_q) in general position."""
    moving = [link["kind"] == "prismatic" for link in links if link["kind"] in ("revolute", "prismatic")]
    sizes = np.where(moving, 150.0, 1.5)
    return np.random.default_rng(seed).standard_normal((3, n, len(sizes))) * sizes


def bodies(links: Sequence[Mapping[str, Any]], seed: int = 1) -> np.ndarray:
    """Return inertial parameters (links, 10) of points of mass: what could be built."""
    rng = np.random.default_rng(seed)
    found = np.zeros((len(links), 10))
    for k in range(len(links)):
        for mass, (x, y, z) in zip(rng.uniform(0.2, 3.0, 6), 120 * rng.standard_normal((6, 3)), strict=True):
            tensor = [y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z]
            found[k] += mass * np.array([1.0, x, y, z, *tensor])
    return found


@pytest.mark.parametrize("name", CHAINS)
def test_torques_are_those_of_newton_and_euler(name: str) -> None:
    links = CHAINS[name]
    motion, inertia = states(links, 40), bodies(links)
    found = dynamics(links).torque(motion, inertia)
    wanted = [independent_dynamics.torque(links, *motion[:, n], inertia, np.array(GRAVITY)) for n in range(40)]
    assert found == pytest.approx(np.array(wanted), abs=1e-12 * np.abs(wanted).max())


@pytest.mark.parametrize("name", CHAINS)
def test_the_regressor_times_the_parameters_is_the_torque(name: str) -> None:
    links = CHAINS[name]
    motion, inertia, own = states(links, 70), bodies(links), dynamics(links)
    found, Y = own.torque(motion, inertia), own.regressor(motion)
    assert Y.shape == (70, motion.shape[2], 10 * len(links)) == (*found.shape, len(own.names))
    assert Y @ inertia.ravel() == pytest.approx(found, abs=1e-12 * np.abs(found).max())


def energy(links: Sequence[Mapping[str, Any]], motion: np.ndarray, inertia: np.ndarray) -> np.ndarray:
    """Return kinetic and potential energy (N,) [N mm] of a chain, from the inertia that its joints feel at rest."""
    own, still = dynamics(links, (0.0, 0.0, 0.0)), np.zeros_like(motion)
    still[0], still[2] = motion[0], motion[1]  # without weight and at rest, torques are M(q) qdd: here M(q) qd
    kinetic = 0.5 * (own.torque(still, inertia) * motion[1]).sum(axis=1)
    robot = chain(links)
    machine = mechanism_of(robot)
    origins, rotations = machine.frames(motion[0], machine.rows(robot))
    held = inertia[:, 0, None] * origins[:, 1:] + np.einsum("nkij,kj->nki", rotations[:, 1:], inertia[:, 1:4])
    return kinetic - held.sum(axis=1) @ GRAVITY


@pytest.mark.parametrize("name", CHAINS)
def test_what_the_joints_give_is_what_the_bodies_gain(name: str) -> None:
    """Power is the rate of the energy along a trajectory, by central differences of eighth order."""
    links, inertia, h = CHAINS[name], bodies(CHAINS[name]), 2e-3
    rng = np.random.default_rng(4)
    sizes, phase = np.abs(states(links, 30, 5)[0]).mean(axis=0), rng.uniform(0, 6, states(links, 1).shape[2])
    speed = rng.uniform(1, 3, len(sizes))

    def along(t: np.ndarray) -> np.ndarray:
        angle = speed * t[:, None] + phase
        return np.array([sizes * np.sin(angle), sizes * speed * np.cos(angle), -sizes * speed**2 * np.sin(angle)])

    t = np.linspace(0, 3, 50)
    motion = along(t)
    power = (dynamics(links).torque(motion, inertia) * motion[1]).sum(axis=1)
    by = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}
    gain = sum(
        c * (energy(links, along(t + n * h), inertia) - energy(links, along(t - n * h), inertia)) for n, c in by.items()
    )
    assert gain / h == pytest.approx(power, abs=1e-8 * np.abs(power).max())


def test_a_payload_is_a_mass_at_the_tool_point() -> None:
    """What 1 kg in the last frame asks for, at rest: its static torque, by the kernel of loads."""
    links = [{key: v for key, v in link.items() if key not in ("mass", "com")} for link in ARM]
    robot = chain(links)
    machine, motion = mechanism_of(robot), states(links, 20)
    motion[1:] = 0.0
    own = dynamics(links, (0.0, 0.0, -9.81))
    q, tool, rows = motion[0], np.tile(robot.tool, (20, 1)), machine.rows(robot)
    x, _ = machine.forward(q, tool, rows)
    fields = np.tile([0.0, 0.0, -9.81], (len(links) + 1, 1))
    static = machine.loads(x, q, tool, rows, {}, fields, 1.0).torque
    assert own.payload(motion) == pytest.approx(-static, abs=1e-9)


def test_what_a_file_states_of_a_link() -> None:
    """A mass away from the frame's origin: its tensor there is the one about its centre and Steiner's."""
    link = ARM[1] | {"mass": 2.0, "com": [0.0, 10.0, 0.0], "inertia": [1.0, 2.0, 3.0, 0.1, 0.2, 0.3]}
    own = dynamics([ARM[0] | {"mass": 0.0}, link])
    first, second = own.stated().reshape(2, 10)
    assert np.isnan(first).all()
    assert second == pytest.approx([2.0, 0.0, 20.0, 0.0, 201.0, 2.0, 203.0, 0.1, 0.2, 0.3])


def test_machines_without_dynamics_are_refused() -> None:
    with pytest.raises(UsageError, match="dynamics of linear_delta are not derived; those of delta, serial are"):
        dynamics_of(robot_from_dict(PRINTER))


def test_a_motion_of_another_shape_is_refused() -> None:
    with pytest.raises(UsageError, match=r"\(3, N, 6\) was expected"):
        dynamics(ARM).regressor(np.zeros((2, 5, 6)))


# ------------------------------------------------------------------------------------------------- machines with loops

DELTA = machines()[0]  # with source errors, and a joint that counts backwards


def delta_states(n: int, seed: int = 0) -> np.ndarray:
    """Return joints, velocities and accelerations (3, n, 3) of a Delta in its workspace."""
    machine, rng = mechanism_of(DELTA), np.random.default_rng(seed)
    q, _, status = machine.inverse(targets(DELTA, n, seed), np.tile(DELTA.tool, (n, 1)), machine.rows(DELTA))
    assert not status.any()
    return np.stack([q, 3.0 * rng.standard_normal(q.shape), 40.0 * rng.standard_normal(q.shape)])


def weightless() -> Dynamics:
    assert DELTA.masses is not None
    masses = DELTA.masses.model_copy(update={"gravity": (0.0, 0.0, 0.0)})
    return dynamics_of(dataclasses.replace(DELTA, masses=masses))


def inertia_of_joints(q: np.ndarray, inertia: np.ndarray) -> np.ndarray:
    """Return the matrix of inertia (N, 3, 3) that the joints feel, column by column."""
    own, columns = weightless(), []
    for j in range(3):
        motion = np.zeros((3, *q.shape))
        motion[0], motion[2, :, j] = q, 1.0
        columns.append(own.torque(motion, inertia))
    return np.stack(columns, axis=2)


def test_at_rest_the_loops_give_what_weights_exert() -> None:
    machine, masses = mechanism_of(DELTA), DELTA.masses
    assert masses is not None
    motion, own = delta_states(50), dynamics_of(DELTA)
    motion[1:] = 0.0
    rows, tool = machine.rows(DELTA), np.tile(DELTA.tool, (50, 1))
    x, _ = machine.forward(motion[0], tool, rows)
    fields = np.tile([0.0, 0.0, -9.81], (11, 1))
    static = machine.loads(x, motion[0], tool, rows, masses.model_dump(), fields, 0.7).torque
    lengths = np.array([DELTA.errors[f"L_{i}"] for i in (1, 2, 3)])  # the centre is a part of the arm as it is
    inertia = own.stated()
    inertia[[1, 5, 9]] += masses.proximal * masses.proximal_com * lengths
    found = own.torque(motion, inertia) + 0.7 * own.payload(motion)
    assert found == pytest.approx(-static, abs=1e-10 * np.abs(static).max())


def test_the_inertia_of_loops_is_that_of_their_kinetic_energy() -> None:
    """By hand: velocities of the rods' ends by complex steps along the motion, rods uniform."""
    machine, own = mechanism_of(DELTA), dynamics_of(DELTA)
    motion, inertia, h = delta_states(12), np.abs(np.random.default_rng(2).standard_normal(13)), 1e-4
    inertia *= [1.0, 1e2, 1e4, 1.0] * 3 + [1.0]
    tool, rows = np.tile(DELTA.tool, (12, 1)), machine.rows(DELTA)

    def platform(q: np.ndarray) -> np.ndarray:
        return machine.coordinates(machine.forward(q, tool, rows)[0])

    steps = {1: 8, -1: -8, 2: -1, -2: 1}
    x_t = sum(c * platform(motion[0] + n * h * motion[1]) for n, c in steps.items()) / (12 * h)
    x, geometry = platform(motion[0]), {key: float(v[0]) for key, v in DELTA.geometry.items()}
    geometry["c"] = geometry["joint_spacing"]
    kinetic = np.zeros(12)
    for n in range(12):
        at, along = x[n] + 1e-20j * x_t[n], motion[0, n] + 1e-20j * motion[1, n]
        elbow, hand, _ = independent_delta.rod_ends(geometry, DELTA.errors, at, along, DELTA.tool)
        v, w = elbow.imag * 1e20, hand.imag * 1e20
        R, R_t = independent_delta.cayley(at[3:]).real, independent_delta.cayley(at[3:]).imag * 1e20
        centre = x_t[n, :3] - R_t @ DELTA.tool
        assert pytest.approx(np.eye(3)) == R @ R.T
        rods = ((v**2 + v * w + w**2).sum(axis=2) / 6).sum(axis=1) @ inertia[[3, 7, 11]]
        kinetic[n] = rods + 0.5 * inertia[[2, 6, 10]] @ motion[1, n] ** 2 + 0.5 * inertia[12] * centre @ centre
    M = inertia_of_joints(motion[0], inertia)
    found = 0.5 * np.einsum("ni,nij,nj->n", motion[1], M, motion[1])
    assert found == pytest.approx(kinetic / 1000, rel=1e-8)
    assert pytest.approx(np.swapaxes(M, 1, 2), abs=1e-12 * np.abs(M).max()) == M
    assert own.names[:4] == ("m_arm_1", "mx_arm_1", "i_arm_1", "m_rod_1")


def test_the_torque_of_loops_is_lagrange_s() -> None:
    """``M qdd + (dM/dt) qd - 1/2 d(qd M qd)/dq`` without weight; differences of the matrix of inertia."""
    motion, inertia, h = delta_states(10), weightless().stated(), 1e-3
    q, qd, qdd = motion
    wanted = np.einsum("nij,nj->ni", inertia_of_joints(q, inertia), qdd)
    steps = {1: 8, -1: -8, 2: -1, -2: 1}
    for k in range(3):
        e = np.eye(3)[k]
        slope = sum(c * inertia_of_joints(q + n * h * e, inertia) for n, c in steps.items()) / (12 * h)
        wanted += np.einsum("nij,nj->ni", slope, qd) * qd[:, k, None]
        wanted[:, k] -= 0.5 * np.einsum("ni,nij,nj->n", qd, slope, qd)
    assert weightless().torque(motion, inertia) == pytest.approx(wanted, abs=1e-7 * np.abs(wanted).max())
