"""The derived dynamics of machines with loops: against Lagrange, energies and weights; their linearity and rank."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from deltacal_gen.machine.dynamics import Dynamics, dynamics_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.rigid import Rigid
from tests.support import independent_delta
from tests.support.machines_with_loops import NAMES, machine, states
from tests.support.moving_chains import by_differences

QUICK = ("delta", "planar_parallelogram")  # the others' kernels of rates compile for three seconds each
STENCIL = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}  # central differences of eighth order, odd


def weightless(robot: Robot) -> Dynamics:
    assert robot.masses is not None
    masses = dataclasses.replace(robot.masses, gravity=(0.0, 0.0, 0.0))
    return dynamics_of(dataclasses.replace(robot, masses=masses))


def inertia_of_joints(robot: Robot, q: np.ndarray, inertia: np.ndarray) -> np.ndarray:
    """Return the matrix of inertia (N, n_q, n_q) that the joints feel, column by column."""
    own, columns = weightless(robot), []
    for j in range(q.shape[1]):
        motion = np.zeros((3, *q.shape))
        motion[0], motion[2, :, j] = q, 1.0
        columns.append(own.torque(motion, inertia))
    return np.stack(columns, axis=2)


@pytest.mark.walk
@pytest.mark.parametrize("name", NAMES)
def test_the_regressor_times_the_parameters_is_the_torque(name: str) -> None:
    robot = machine(name)
    own, motion = dynamics_of(robot), states(robot, 70)
    inertia = np.random.default_rng(1).uniform(0.5, 1.5, len(own.names)) * own.stated()
    found, Y = own.torque(motion, inertia), own.regressor(motion)
    assert Y.shape == (*found.shape, len(own.names))
    assert Y @ inertia == pytest.approx(found, abs=1e-12 * np.abs(found).max())


@pytest.mark.parametrize("name", NAMES)
def test_at_rest_the_loops_give_what_weights_exert(name: str) -> None:
    """By the kernels of statics, which put half of a rod at either end: at rest that is the same."""
    robot = dataclasses.replace(machine(name), errors={})  # there a centre of mass is a part of the arm as it is
    mechanism, own, motion = mechanism_of(robot), dynamics_of(robot), states(robot, 50)
    motion[1:] = 0.0
    rows, tool = mechanism.rows(robot), np.tile(robot.tool, (50, 1))
    x, _ = mechanism.forward(motion[0], tool, rows)
    assert robot.masses is not None
    weights = mechanism.weights_at(x, motion[0], tool, rows, dataclasses.asdict(robot.masses))
    fields = np.tile(robot.masses.gravity, (weights.shape[1], 1))
    masses = {key: value for key, value in dataclasses.asdict(robot.masses).items() if value is not None}
    static = mechanism.loads(x, motion[0], tool, rows, masses, fields, 0.7).torque
    found = own.torque(motion, own.stated()) + 0.7 * own.payload(motion)
    assert found == pytest.approx(-static, abs=1e-10 * np.abs(static).max())


def test_the_inertia_of_a_delta_is_that_of_its_kinetic_energy() -> None:
    """By hand: velocities of the rods' ends by complex steps along the motion, rods uniform."""
    DELTA = machine("delta")
    mechanism, own = mechanism_of(DELTA), dynamics_of(DELTA)
    motion, inertia, h = states(DELTA, 12), np.abs(np.random.default_rng(2).standard_normal(13)), 1e-4
    inertia *= [1.0, 1e2, 1e4, 1.0] * 3 + [1.0]
    tool, rows = np.tile(DELTA.tool, (12, 1)), mechanism.rows(DELTA)

    def platform(q: np.ndarray) -> np.ndarray:
        return mechanism.coordinates(mechanism.forward(q, tool, rows)[0])

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
    M = inertia_of_joints(DELTA, motion[0], inertia)
    found = 0.5 * np.einsum("ni,nij,nj->n", motion[1], M, motion[1])
    assert found == pytest.approx(kinetic / 1000, rel=1e-8)
    assert pytest.approx(np.swapaxes(M, 1, 2), abs=1e-12 * np.abs(M).max()) == M
    assert own.names[:4] == ("m_arm_1", "mx_arm_1", "i_arm_1", "m_rod_1")


@pytest.mark.parametrize("name", NAMES)
def test_the_torque_of_loops_is_lagrange_s(name: str) -> None:
    """``M qdd + (dM/dt) qd - 1/2 d(qd M qd)/dq`` without weight; differences of the matrix of inertia."""
    robot = machine(name)
    motion, inertia = states(robot, 10), weightless(robot).stated()
    h = 1e-3 if mechanism_of(robot).joint_unit == "rad" else 0.1
    q, qd, qdd = motion
    M = inertia_of_joints(robot, q, inertia)
    assert np.swapaxes(M, 1, 2) == pytest.approx(M, abs=1e-12 * np.abs(M).max())
    wanted = np.einsum("nij,nj->ni", M, qdd)
    for k in range(q.shape[1]):
        e = np.eye(q.shape[1])[k]
        slope = sum(
            c * (inertia_of_joints(robot, q + n * h * e, inertia) - inertia_of_joints(robot, q - n * h * e, inertia))
            for n, c in STENCIL.items()
        )
        slope = slope / h
        wanted += np.einsum("nij,nj->ni", slope, qd) * qd[:, k, None]
        wanted[:, k] -= 0.5 * np.einsum("ni,nij,nj->n", qd, slope, qd)
    assert weightless(robot).torque(motion, inertia) == pytest.approx(wanted, abs=1e-9 * np.abs(wanted).max())


@pytest.mark.parametrize("name", NAMES)
def test_what_the_joints_give_is_what_the_bodies_gain(name: str) -> None:
    """Along a trajectory power is the rate of kinetic energy, and of the work against gravity at no speed."""
    robot = machine(name)
    own, (q, *_) = dynamics_of(robot), states(robot, 2, 3)
    inertia, h, speed = own.stated(), 1e-3, 2.0

    def along(t: np.ndarray) -> np.ndarray:
        """Move to and fro between two poses."""
        way, middle = (q[1] - q[0]) / 2, (q[0] + q[1]) / 2
        s = speed * np.array([np.arange(len(way)) + 1.0]) / len(way) * t[:, None]
        rate = speed * (np.arange(len(way)) + 1.0) / len(way)
        return np.array([middle + way * np.sin(s), way * rate * np.cos(s), -way * rate**2 * np.sin(s)])

    def kinetic(t: np.ndarray) -> np.ndarray:
        at = along(t)
        return 0.5 * np.einsum("ni,nij,nj->n", at[1], inertia_of_joints(robot, at[0], inertia), at[1])

    t = np.linspace(0, 3, 40)
    motion = along(t)
    still = motion.copy()
    still[1:] = 0.0
    power = ((own.torque(motion, inertia) - own.torque(still, inertia)) * motion[1]).sum(axis=1)
    gain = sum(c * (kinetic(t + n * h) - kinetic(t - n * h)) for n, c in STENCIL.items()) / h
    assert gain == pytest.approx(power, abs=1e-8 * np.abs(power).max())


@pytest.mark.parametrize("name", NAMES)
def test_as_many_base_parameters_as_the_columns_have_directions(name: str) -> None:
    robot = machine(name)
    Y = dynamics_of(robot).regressor(states(robot, 300, 8)).reshape(-1, len(dynamics_of(robot).names))
    R = np.abs(np.diag(np.linalg.qr(Y / np.maximum(np.linalg.norm(Y, axis=0), 1e-300), mode="r")))
    singular = np.linalg.svd(Y / np.maximum(np.linalg.norm(Y, axis=0), 1e-300), compute_uv=False)
    assert Rigid(robot).common.rank == (singular > 1e-9 * singular[0]).sum() == (R > 1e-9).sum()


def test_a_rod_with_an_inertia_of_its_own_is_two_ends_and_a_middle() -> None:
    """A rod with the inertia of a uniform one is that; one of two end masses m/2 is what statics has."""
    robot = machine("delta")
    assert robot.masses is not None
    motion, length = states(robot, 20), float(robot.geometry["distal_length"][0])

    def torque(inertia: float | None) -> np.ndarray:
        masses = dataclasses.replace(robot.masses, distal_inertia=inertia)
        own = dynamics_of(dataclasses.replace(robot, masses=masses))
        return own.torque(motion, own.stated())

    uniform, heavy = torque(0.15 * length**2 / 12), torque(0.15 * length**2 / 4)
    assert uniform == pytest.approx(torque(None), rel=1e-12)
    assert heavy - uniform == pytest.approx(2 * (uniform - torque(0.0)), abs=1e-9 * np.abs(uniform).max())


@pytest.mark.walk
def test_a_pose_out_of_reach_has_no_torque() -> None:
    robot = machine("linear_delta")
    motion, own = states(robot, 5), dynamics_of(robot)
    motion[0, 2] += [0.0, 900.0, 0.0]  # no rods of 270 mm span it
    found = own.torque(motion, own.stated())
    assert np.isnan(found[2]).all()
    assert np.isfinite(np.delete(found, 2, axis=0)).all()
    slopes = own.torque_by_errors(motion, own.stated(), ["dl_1"])
    assert np.isnan(slopes[2]).all()
    assert np.isfinite(np.delete(slopes, 2, axis=0)).all()


@pytest.mark.walk
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=() if name in QUICK else pytest.mark.thorough) for name in NAMES]
)
def test_torques_change_with_the_errors_of_the_calibrated_machine_as_derived(name: str) -> None:
    """Against differences of fourth order, error by error."""
    robot = machine(name)
    motion, inertia = states(robot, 20), dynamics_of(robot).stated()
    parameters = mechanism_of(robot).parameters
    found = dynamics_of(robot).torque_by_errors(motion, inertia, [p.name for p in parameters])
    wanted = by_differences(robot, motion, inertia)
    size = np.abs(wanted).max()
    assert np.abs(found * [p.typical for p in parameters] - wanted).max() < 1e-8 * size
    assert size > 1e-4 * np.abs(dynamics_of(robot).torque(motion, inertia)).max()
