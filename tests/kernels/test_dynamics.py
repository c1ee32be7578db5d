"""The derived dynamics: of chains, against Newton and Euler by hand; their linearity; the energy they keep."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
import pytest

from deltacal_gen.app.demonstration import example
from deltacal_gen.errors import UsageError
from deltacal_gen.machine import dynamics as dynamics_module
from deltacal_gen.machine.dynamics import dynamics_of, known
from deltacal_gen.machine.registry import mechanism_names, mechanism_of
from tests.support import independent_dynamics
from tests.support.drawn import example_of
from tests.support.every_effect import ARM, LIFT, chain
from tests.support.moving_chains import GRAVITY, bodies, by_differences, dynamics, robot_of_links, states

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


@pytest.mark.parametrize("name", CHAINS)
def test_torques_are_those_of_newton_and_euler(name: str) -> None:
    links = CHAINS[name]
    motion, inertia = states(links, 40), bodies(links)
    found = dynamics(links).torque(motion, inertia)
    wanted = [independent_dynamics.torque(links, *motion[:, n], inertia, np.array(GRAVITY)) for n in range(40)]
    assert found == pytest.approx(np.array(wanted), abs=1e-12 * np.abs(wanted).max())


@pytest.mark.parametrize("name", CHAINS)
def test_torques_change_with_source_errors_as_derived(name: str) -> None:
    """Against differences; with one parameter 1 they are those of the regressor's column."""
    links, motion, inertia = CHAINS[name], states(CHAINS[name], 20), bodies(CHAINS[name]).ravel()
    robot = robot_of_links(links)
    parameters = mechanism_of(robot).parameters
    robot = dataclasses.replace(robot, errors={p.name: 0.7 * p.typical for p in parameters})
    own, names = dynamics_of(robot), [p.name for p in parameters]
    found, wanted = own.torque_by_errors(motion, inertia, names), by_differences(robot, motion, inertia)
    assert np.abs(found * [p.typical for p in parameters] - wanted).max() < 1e-9 * np.abs(wanted).max()
    columns = [own.torque_by_errors(motion, row, names) for row in np.eye(len(inertia))]
    assert np.tensordot(inertia, columns, 1) == pytest.approx(found, abs=1e-12 * np.abs(found).max())


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


def test_machines_without_dynamics_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    """As those that somebody adds without bodies; of all that the package has they are derived."""
    assert {name for name in mechanism_names() if example_of(name).parent == example().parent} <= set(known())
    monkeypatch.setattr(dynamics_module, "_found", lambda name: name == "delta")
    with pytest.raises(UsageError, match="the dynamics of serial are not derived; those of delta are"):
        dynamics_of(chain(ARM))


def test_a_motion_of_another_shape_is_refused() -> None:
    with pytest.raises(UsageError, match=r"\(3, N, 6\) was expected"):
        dynamics(ARM).regressor(np.zeros((2, 5, 6)))


def test_a_drive_s_inertia_that_a_table_states_is_a_parameter_of_its_own() -> None:
    tables = [dict(link) for link in LIFT]
    plain = dynamics_of(chain(tables))
    tables[0]["rotor_inertia"], tables[2]["rotor_inertia"] = 7.0, 2e5
    own = dynamics_of(chain(tables))
    assert own.names == (*plain.names, "rotor_1", "rotor_3")
    assert own.units[-2:] == ("kg", "kg mm^2")
    assert own.stated()[-2:].tolist() == [7.0, 2e5]
    motion = np.random.default_rng(4).standard_normal((3, 30, 4))
    inertia = np.append(bodies(LIFT).ravel(), [7.0, 2e5])
    beside = np.zeros((30, 4))
    beside[:, [0, 2]] = motion[2][:, [0, 2]] * [7.0 / 1000, 2e5 / 1000]  # N, N mm
    torque = own.torque(motion, inertia)
    np.testing.assert_allclose(torque, plain.torque(motion, inertia[:-2]) + beside, rtol=1e-12)
    np.testing.assert_allclose(own.regressor(motion) @ inertia, torque, rtol=1e-10, atol=1e-9 * np.abs(torque).max())
    np.testing.assert_array_equal(own.payload(motion), plain.payload(motion))
