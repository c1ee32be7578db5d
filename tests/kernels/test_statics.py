"""Static torques and pulls of the generated kernels: minus the slope of a potential energy written by hand."""

from __future__ import annotations

import numpy as np
import pytest

from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import Machine
from tests.support.independent_delta import nominal_frame, numbers, rod_ends
from tests.support.prototype import solved_for
from tests.support.solved_delta import Solved, solved


@pytest.fixture(scope="module")
def machine(robot: Robot, mechanism: Machine) -> Solved:
    return solved(robot, mechanism, seed=1)


MASSES = {"proximal": 1.2, "proximal_com": 0.4, "distal_rod": 0.15, "platform": 0.8}
GRAVITY = np.array([0.4, -0.3, -9.7])  # not upright: every component counts


def potential_energy(robot: Robot, at: Solved, x: np.ndarray, q: np.ndarray, payload: float) -> np.ndarray:
    """Return minus the sum of m g . r (N,) [N mm] of arms, half rods at either end, platform at O' and payload at P."""
    g, energy = numbers(robot.geometry), np.zeros(len(x))
    for n in range(len(x)):
        elbow, hand, _ = rod_ends(g, at.errors, solved_for(x)[n], q[n], at.tool[n])
        work = payload * x[n, :3] + MASSES["platform"] * (x[n, :3] - x[n, 3:].reshape(3, 3) @ at.tool[n])
        for i in range(3):
            e = {name[:-2]: v for name, v in at.errors.items() if name.endswith(f"_{i + 1}")}
            base = g["base_radius"] * nominal_frame(i)[:, 0] + [e["ex"], e["ey"], e["ez"]]
            # the middle of the elbow is the arm's tip; its centre of mass lies on the line from the base point
            tip = elbow[i].mean(axis=0)
            work = work + MASSES["proximal"] * (base + MASSES["proximal_com"] * (tip - base))
            work = work + MASSES["distal_rod"] / 2 * (elbow[i].sum(axis=0) + hand[i].sum(axis=0))
        energy[n] = -GRAVITY @ work
    return energy


def test_static_torque_is_minus_the_slope_of_potential_energy(
    machine: Solved, robot: Robot, mechanism: Machine
) -> None:
    payload = 2.5
    torque = mechanism.torques(machine.x, machine.q, machine.tool, machine.rows, MASSES, GRAVITY, payload)
    for joint in range(3):

        def slope(h: float, joint: int = joint) -> np.ndarray:
            energies = []
            for sign in (1, -1):
                q = machine.q.copy()
                q[:, joint] += sign * h
                x, _ = mechanism.forward(q, machine.tool, machine.rows)
                energies.append(potential_energy(robot, machine, x, q, payload))
            return np.asarray((energies[0] - energies[1]) / (2 * h))

        extrapolated = (4 * slope(1e-3) - slope(2e-3)) / 3
        # 1e5 N mm of energy rounded at 1e-11 over 2e-3 rad: 1e-8; the fourth order of the extrapolation is above it
        assert torque[:, joint] == pytest.approx(-extrapolated, rel=1e-7, abs=1e-5)


def test_gravity_on_a_horizontal_arm_is_negative(robot: Robot, mechanism: Machine) -> None:
    rows, q = mechanism.rows(robot), np.zeros((1, 3))
    x, _ = mechanism.forward(q, np.zeros(3), rows)
    down = np.array([0.0, 0.0, -9.81])
    alone = mechanism.torques(x, q, np.zeros(3), rows, {"proximal": 1.2, "proximal_com": 0.4}, down)
    assert alone == pytest.approx(np.full((1, 3), -1.2 * 9.81 * 0.4 * 375.0), rel=1e-12)  # nothing else has mass
    loaded = mechanism.torques(x, q, np.zeros(3), rows, MASSES, down, payload=1.0)
    assert (loaded < alone).all()


def test_rods_that_carry_a_platform_pull(robot: Robot, mechanism: Machine) -> None:
    """Six equal rods at the centre, arms flat: their pulls' vertical parts are the weight, and the arms feel them."""
    rows, q = mechanism.rows(robot), np.zeros((1, 3))
    x, _ = mechanism.forward(q, np.zeros(3), rows)
    loads = mechanism.loads(x, q, np.zeros(3), rows, {"platform": 2.0}, np.array([0.0, 0.0, -9.81]))
    vertical = -x[0, 2] / 950.0
    assert loads.tension == pytest.approx(np.full((1, 3, 2), 2.0 * 9.81 / 6 / vertical), rel=1e-12)
    each = -2.0 * 9.81 / 3  # on each arm's tip: v points up, and no pull goes sideways
    assert loads.pull == pytest.approx(np.tile([each, 0.0], (1, 3, 1)), abs=1e-9)
    assert loads.torque == pytest.approx(np.full((1, 3), each * 375.0), rel=1e-12)
    assert loads.moment == pytest.approx(np.zeros((1, 3)), abs=1e-9)


def test_a_pull_on_a_tip_is_minus_the_slope_of_energy_along_it(
    machine: Solved, robot: Robot, mechanism: Machine
) -> None:
    """The rods' part: the weights of rods, platform and payload, moved by the tip's displacement at held joints."""
    hanging = {k: v for k, v in MASSES.items() if k != "proximal"} | {"proximal": 0.0, "distal_rod": 0.0}
    loads = mechanism.loads(machine.x, machine.q, machine.tool, machine.rows, hanging, GRAVITY, 2.5)
    p = mechanism.vector(machine.errors)

    def weight_energy(x: np.ndarray) -> np.ndarray:
        origin = x[:, :3] - np.einsum("nij,nj->ni", x[:, 3:].reshape(-1, 3, 3), machine.tool)
        return -(2.5 * x[:, :3] + MASSES["platform"] * origin) @ GRAVITY

    for limb in range(3):
        for which in range(2):

            def slope(h: float, limb: int = limb, which: int = which) -> np.ndarray:
                tip = np.zeros((1, 3, 2))
                tip[0, limb, which] = h
                plus, minus = (
                    mechanism.forward(machine.q, machine.tool, mechanism.rows(robot, p, s * tip))[0] for s in (1, -1)
                )
                return np.asarray((weight_energy(plus) - weight_energy(minus)) / (2 * h))

            extrapolated = (4 * slope(0.5) - slope(1.0)) / 3
            # 3e4 N mm of energy rounded at 1e-11 over 1 mm, below the fourth order of the extrapolation
            assert loads.pull[:, limb, which] == pytest.approx(-extrapolated, abs=1e-7)
