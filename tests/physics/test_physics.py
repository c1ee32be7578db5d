"""Effects: loads by virtual work, static equilibrium, and columns that are its derivative."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from deltacal_gen.app.demonstration import example
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import Robot, read_robot
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import Array, Machine, load_mechanism
from deltacal_gen.machine.values import Masses
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.reading import reading_shift
from deltacal_gen.physics.terms import Term, blank, displaces_points, effect_names, load_effect, of_reading
from tests.support.every_effect import body_of, constants, limbs_with, machine_with

DELTA = load_mechanism("delta")
READ = {  # coordinates of the pose that a kind of reading shows, by what an effect on it moves
    "position": {"reading.x": 0, "reading.y": 1, "reading.z": 2},
    "height": {"height": 2},
}
N = 12


@pytest.fixture(scope="module")
def robot() -> Robot:
    robot = read_robot(example() / "robot.toml")
    rng = np.random.default_rng(3)
    return dataclasses.replace(
        robot, errors={p.name: float(p.typical * rng.standard_normal()) for p in DELTA.parameters}
    )


@pytest.fixture(scope="module")
def body(robot: Robot) -> Body:
    rng = np.random.default_rng(4)
    targets = np.column_stack([rng.uniform(-300, 300, (N, 2)), rng.uniform(-950, -750, N)])
    tool = np.where(np.arange(N)[:, None] % 2, [[60.0, 10.0, -30.0]], [[0.0, 0.0, 0.0]])
    q, _, status = DELTA.inverse(targets, tool, DELTA.rows(robot))
    assert (status == 0).all()
    values = {
        "approach": rng.choice([-1.0, 1.0], (N, 3)),
        "qd": rng.uniform(-0.5, 0.5, (N, 3)),
        "qdd": rng.uniform(-20, 20, (N, 3)),
        "warming": rng.uniform(0, 12, N),
        "time": np.linspace(0, 5000, N),
        "payload": rng.choice([0.0, 2.0, 5.0], N),
    }
    channels = Channels(values, np.arange(N, dtype=float))
    return Body(robot, DELTA, q, tool, channels)


def work(body: Body, rows: Array, q: Array) -> Array:
    """Return the work function sum(m g.r) of all weights (N,) at the exact pose [N mm]."""
    x, status = DELTA.forward(q, body.tool, rows)
    assert (status == 0).all()
    points = DELTA.weights_at(x, q, body.tool, rows, body.masses)
    limb = [body.masses["proximal"], body.masses["distal_rod"], body.masses["distal_rod"]]
    masses = np.tile(np.array([*limb * 3, body.masses["platform"], 0.0]), (N, 1))
    masses[:, -1] = body.channels.payload
    return (masses * (points @ body.gravity)).sum(axis=1)


def derivative(f: object, h: float) -> Array:
    """Return the central derivative at 0 of a function of one number, to fourth order."""
    assert callable(f)
    return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h)


def test_loads_are_the_derivatives_of_the_work_of_gravity(body: Body, robot: Robot) -> None:
    rows = DELTA.rows(robot)
    x, _ = DELTA.forward(body.q, body.tool, rows)
    loads = DELTA.loads(x, body.q, body.tool, rows, body.masses, body.gravity, body.channels.payload)
    for i in range(3):
        by_joint = derivative(lambda h, i=i: work(body, rows, body.q + h * np.eye(3)[i]), 1e-3)
        assert loads.torque[:, i] == pytest.approx(by_joint, rel=1e-8, abs=1e-6)

    def longer(h: float, limb: int, error: str) -> Array:
        errors = DELTA.vector(robot.errors)
        errors[DELTA.index[f"{error}_{limb}"]] += h
        return work(body, DELTA.rows(robot, errors), body.q)

    for limb in (1, 2, 3):
        mean = derivative(lambda h, limb=limb: longer(h, limb, "l"), 1e-2)
        difference = derivative(lambda h, limb=limb: longer(h, limb, "dl"), 1e-2)
        tension = loads.tension[:, limb - 1]
        assert tension.sum(axis=1) == pytest.approx(mean, rel=1e-7, abs=1e-7)
        assert (tension[:, 0] - tension[:, 1]) / 2 == pytest.approx(difference, rel=1e-7, abs=1e-7)


def test_rods_of_a_hanging_platform_are_in_tension_and_level_arms_are_pulled_down(robot: Robot) -> None:
    level, tool, ideal = np.zeros((1, 3)), np.zeros(3), DELTA.rows(dataclasses.replace(robot, errors={}))
    x, _ = DELTA.forward(level, tool, ideal)
    loads = DELTA.loads(x, level, tool, ideal, {"platform": 2.0}, np.array([0, 0, -9.81]))
    assert (loads.tension > 0).all()
    assert (loads.torque < 0).all()
    assert loads.pull[0, :, 0] == pytest.approx([-2.0 * 9.81 / 3] * 3)  # a third of the weight at each arm's tip
    assert loads.moment[0] == pytest.approx([0, 0, 0], abs=1e-9)


@pytest.mark.parametrize("name", effect_names())
def test_columns_are_the_derivative_of_the_exact_equilibrium(name: str) -> None:
    robot = machine_with(name)
    body = body_of(robot, N)
    mechanism, errors, every = body.mechanism, body.mechanism.vector(robot.errors), np.arange(N)
    tools = [(0.0, 0.0, 0.0)] if displaces_points(load_effect(name)) else []
    term = blank(name, limbs_with(name), constants(name), tools)
    kind = next(k for k, t in READ.items() if not of_reading([term]) or set(t) & set(term.kernels.TARGETS))
    machine, status = body.solve(errors, [term])
    assert (status == 0).all()
    S = mechanism.sensitivity(machine.x, machine.q, machine.tool, machine.rows)
    columns = body.columns([term], machine, S, every)
    readings = machine.x[:, list(READ[kind].values())] + 1000.0
    found = kind_of(kind).taken(every[:, None], values=readings)
    shifts = reading_shift([term], body, found, readings, machine.x)[1]

    def seen(coefficient: int, h: float) -> Array:
        values = np.zeros(term.n_coefficients)
        values[coefficient] = h
        moved = term.with_values(values)
        x = body.solve(errors, [moved])[0].x
        read = x[:, list(READ[kind].values())]
        return read + reading_shift([moved], body, found, read + 1000.0, x)[0]

    for j in range(term.n_coefficients):
        total = columns[:, list(READ[kind].values()), j] + shifts[:, :, j]
        assert np.abs(total).max() > 0, "the effect moves nothing"
        h = 0.05 / np.abs(total).max()  # moves the reading by 0.05 mm
        numeric = derivative(lambda h, j=j: seen(j, h), h)
        assert numeric == pytest.approx(total, rel=1e-3, abs=1e-4 * np.abs(total).max())


def test_a_compliant_machine_is_in_equilibrium_with_its_own_loads(body: Body, robot: Robot) -> None:
    compliance = 2e-8  # rad per N mm: about 1 deg at these torques, far more than any real joint
    term = Term("joint_compliance", (1, 2, 3), np.full((3, 1), compliance))
    machine, _ = body.solve(DELTA.vector(robot.errors), [term])
    loads = DELTA.loads(
        machine.x, machine.q, machine.tool, machine.rows, body.masses, body.gravity, body.channels.payload
    )
    assert machine.q == pytest.approx(body.q + compliance * loads.torque, abs=1e-12)


def test_an_effect_of_the_angle_reads_the_one_that_the_geometry_sees(body: Body, robot: Robot) -> None:
    scale = Term("joint_scale", (1, 2, 3), np.full((3, 1), 0.01))
    runout = Term("joint_axis_runout", (1, 2, 3), np.tile([0.3, 0.2], (3, 1)))
    machine, _ = body.solve(DELTA.vector(robot.errors), [scale, runout])
    theta = body.state(["theta"], machine.x, machine.q, machine.rows)["theta"]
    for name, much in DELTA.moves(robot)["outwards"].items():
        moved = (machine.rows - DELTA.rows(robot))[:, :, DELTA.column(name)]
        assert moved == pytest.approx((0.3 * np.cos(theta) + 0.2 * np.sin(theta)) @ much.T, abs=1e-12)


def test_an_effect_without_its_channel_says_what_is_missing(body: Body, robot: Robot) -> None:
    bare = Channels({}, np.arange(N, dtype=float))
    assert "approach1" in str(Body(robot, DELTA, body.q, body.tool, bare).missing("backlash"))
    assert "temp_C" in str(Body(robot, DELTA, body.q, body.tool, bare).missing("thermal_zero"))
    massless = Body(dataclasses.replace(robot, masses=None), DELTA, body.q, body.tool, body.channels)
    assert "[masses]" in str(massless.missing("joint_compliance"))
    assert massless.missing("joint_scale") is None


ARMED = ("complete_delta", "delta", "diamond", "robotennis")  # whose joints turn an arm
ARM = Masses(proximal=1.2, proximal_com=0.4)


def posed(name: str) -> tuple[Machine, Robot, Array, Array]:
    """Return a mechanism, its example without errors or any mass but its arms', and joints and tool at its poses."""
    machine = load_mechanism(name)
    drawn = read_robot(example(machine.machine) / "robot.toml")
    robot = dataclasses.replace(drawn, mechanism=name, errors={}, masses=ARM)
    poses = read_recording(example(machine.machine) / "poses.csv", machine, need_measured=False, allow_targets=True)
    n = len(poses.joints if poses.targets is None else poses.targets)
    tool = np.zeros((n, 3)) if poses.tool is None else poses.tool
    if poses.targets is None:
        return machine, robot, poses.joints, tool
    q, _, status = machine.inverse(poses.targets, tool, machine.rows(robot))
    assert (status == 0).all()
    return machine, robot, q, tool


@pytest.mark.parametrize("name", ARMED)
def test_inertia_of_a_lone_arm_is_its_moment_of_inertia_times_acceleration(name: str) -> None:
    machine, robot, q, tool = posed(name)
    rng = np.random.default_rng(4)
    speeds = {"qd": np.zeros(q.shape), "qdd": rng.uniform(-20, 20, q.shape), "payload": np.zeros(len(q))}
    alone = Body(robot, machine, q, tool, Channels(speeds, np.arange(len(q), dtype=float)))
    longer, rows = 5.0, np.array(machine.rows(robot))
    for part, much in machine.moves(robot)["arm"].items():
        rows[:, :, machine.column(part)] += longer * np.diag(much)
    x, _ = machine.forward(q, tool, rows)
    torque = alone.state(["inertia_torque"], x, q, rows)["inertia_torque"]
    m, L = ARM.proximal, machine.roles(robot)["L"]
    centre = ARM.proximal_com * (L + longer * (name != "complete_delta"))  # whose errors are those of the rods' ends
    inertia = m * L**2 / 12 + m * centre**2  # kg mm^2, about the joint
    assert torque == pytest.approx(-inertia * speeds["qdd"] / 1000.0, rel=1e-5, abs=1e-3)


@pytest.mark.parametrize("name", ARMED)
def test_a_tip_that_gives_way_across_its_arm_moves_what_the_joint_would(name: str) -> None:
    machine, robot, q, tool = posed(name)
    rows, much = machine.rows(robot), 1e-3
    x, _ = machine.forward(q, tool, rows)
    turns = much / np.broadcast_to(machine.roles(robot)["L"], machine.limbs)
    for limb in range(machine.limbs):
        bent, turned = np.array(rows), np.array(q)
        bent[:, limb, machine.column("tip_v")] += much
        turned[:, limb] += turns[limb]
        moved = machine.forward(q, tool, bent)[0] - x
        assert np.abs(moved).max() > 0.1 * much
        assert moved == pytest.approx(machine.forward(turned, tool, rows)[0] - x, abs=1e-3 * much)


def test_thermometers_of_parts_stand_for_the_machine(robot: Robot) -> None:
    parts = {"temp_base_C": np.array([20.0, 22.0]), "temp_arms_C": np.array([22.0, 26.0])}
    of_parts = Channels.from_columns(parts, (2, 3), robot)
    assert of_parts.values["warming"] == pytest.approx([1.0, 4.0])
    of_machine = Channels.from_columns(parts | {"temp_C": np.array([25.0, 25.0])}, (2, 3), robot)
    assert of_machine.values["warming"] == pytest.approx([5.0, 5.0])
