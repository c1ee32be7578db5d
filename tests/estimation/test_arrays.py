"""Arrays in, parameters out: the fit of ``identify`` by a path that imports NumPy alone."""

from __future__ import annotations

import dataclasses
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen
from deltacal_gen import PoseSet, estimate, nominal
from deltacal_gen.app.demonstration import example
from deltacal_gen.errors import InputError, NoSolutionError, UsageError
from deltacal_gen.estimation.arrays import recorded
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import Robot, read_robot
from deltacal_gen.identification.identification import identify
from deltacal_gen.machine.registry import load_mechanism, mechanism_names, mechanism_of
from deltacal_gen.use.compensation import Compensator
from tests.support.drawn import example_of
from tests.support.prototype import PROTOTYPE, plausible, rings

MASSES = {"proximal": 1.2, "proximal_com": 0.4, "distal_rod": 0.15, "platform": 0.8}
SIGMA = 0.005  # mm
SPREAD = np.linspace(0.0, 0.3, 57).reshape(19, 3)  # joints [rad]
BESIDE = np.array([60.0, -20.0, -40.0])  # a second reference point [mm]
FIRST_RESULT = """
import sys
before = set(sys.modules)
import json
import numpy as np
from deltacal_gen import PoseSet, estimate, nominal
data = np.load(sys.argv[1])
found = estimate(nominal("delta", json.loads(sys.argv[2])), "32", data["joints"], data["measured"], tool=data["tool"],
                 as_distance=True)
slow = sorted({"numpy.ma", "deltacal_kernels.cache"} & sys.modules.keys())
packages = {name.partition(".")[0] for name in sys.modules.keys() - before}
packages = sorted(packages - sys.stdlib_module_names)
print(json.dumps({"packages": packages, "slow": slow, "parameters": found.parameters}))
"""


@pytest.fixture(scope="module")
def measured(robot: Robot) -> dict[str, np.ndarray]:
    """Two points of the platform read at 19 poses of a machine with errors."""
    mechanism, rng = load_mechanism("delta"), np.random.default_rng(7)
    joints, _, _ = mechanism.inverse(rings(robot, 9), np.zeros(3), mechanism.rows(robot))
    errors = mechanism.vector(plausible(mechanism, 5, mechanism.model("32")))
    joints, tool = np.tile(joints, (2, 1)), np.repeat([np.zeros(3), BESIDE], len(joints), axis=0)
    x, _ = mechanism.forward(joints, tool, mechanism.rows(robot, errors))
    return {"joints": joints, "tool": tool, "measured": x[:, :3] + SIGMA * rng.standard_normal((len(x), 3))}


def test_a_mechanism_is_one_object_however_it_is_asked_for() -> None:
    robot = nominal("delta", PROTOTYPE["geometry"])
    assert load_mechanism("delta") is load_mechanism("delta", ()) is mechanism_of(robot)


def test_a_first_result_needs_numpy_and_the_kernels_alone(measured: dict[str, np.ndarray], tmp_path: Path) -> None:
    np.savez(tmp_path / "data.npz", **measured)
    arguments = [str(tmp_path / "data.npz"), json.dumps(PROTOTYPE["geometry"])]
    done = subprocess.run([sys.executable, "-c", FIRST_RESULT, *arguments], capture_output=True, text=True, check=True)
    found = json.loads(done.stdout)
    assert found["packages"] == ["deltacal_gen", "deltacal_kernels", "lazy_loader", "numpy"]
    assert not found["slow"]  # a fifth of what an identification takes
    here = estimate(
        nominal("delta", PROTOTYPE["geometry"]),
        "32",
        measured["joints"],
        measured["measured"],
        tool=measured["tool"],
        as_distance=True,
    )
    assert list(found["parameters"]) == list(here.parameters)
    deviation = np.sqrt(np.diag(here.covariance))
    gap = np.subtract(list(found["parameters"].values()), list(here.parameters.values()))
    assert (np.abs(gap) < 1e-3 * deviation).all()


@pytest.mark.parametrize("as_distance", [False, True])
def test_the_parameters_are_those_of_identify(robot: Robot, measured: dict[str, np.ndarray], as_distance: bool) -> None:
    given = dict(measured)
    joints, values = given.pop("joints"), given.pop("measured")
    plain = nominal("delta", PROTOTYPE["geometry"])
    ours = estimate(plain, "delta/18", joints, values, as_distance=as_distance, **given)
    thorough = identify(
        robot, recorded(robot, joints, values, **given), "18", as_distance=as_distance, solver="least-squares"
    )
    deviation = np.sqrt(np.diag(ours.covariance)[:18])
    gap = (ours.errors - thorough.fit.errors)[ours.problem.columns]
    assert list(ours.parameters) == list(load_mechanism("delta").model("18"))
    assert (np.abs(gap) < 1e-3 * deviation).all()


@pytest.mark.parametrize("name", [n for n in mechanism_names() if not load_mechanism(n).linked])  # those need a file
def test_every_mechanism_finds_a_machine_that_reads_alike(name: str, tmp_path: Path) -> None:
    """Positions of the example's poses, without noise, on a machine with errors of the model."""
    drawn = dataclasses.replace(read_robot(example_of(name) / "robot.toml"), mechanism=name, errors={}, tolerance={})
    mechanism, rng = load_mechanism(name), np.random.default_rng(3)
    model = mechanism.full_model
    poses = read_recording(example_of(name) / "poses.csv", mechanism, need_measured=False, allow_targets=True)
    joints = poses.joints
    if poses.targets is not None:
        joints, _, _ = mechanism.inverse(poses.targets, np.zeros(3), mechanism.rows(drawn))
    joints = np.unique(joints, axis=0)
    free = np.isin([p.name for p in mechanism.parameters], mechanism.model(model))
    errors = np.where(free, 0.3 * mechanism.typical * rng.standard_normal(len(free)), 0.0)
    x, _ = mechanism.forward(joints, np.zeros(3), mechanism.rows(drawn, errors))
    geometry = {k.key: drawn.geometry[k.key] * (180 / np.pi if k.unit == "rad" else 1) for k in mechanism.geometry}
    positions = x[:, ["xyz".index(axis) for axis in mechanism.axes]]
    plain = nominal(name, geometry)
    found = estimate(plain, model, joints, positions, frame="robot", robust=False)
    assert np.abs(found.residual[np.isfinite(found.residual)]).max() < 1e-5
    pairs = np.column_stack([np.arange(len(x)), np.roll(np.arange(len(x)), 1)])
    lengths = np.linalg.norm(x[pairs[:, 1], :3] - x[pairs[:, 0], :3], axis=1)
    found = estimate(plain, model, joints, lengths, pairs=pairs, robust=False)
    assert np.abs(found.residual).max() < 1e-5


@pytest.mark.parametrize("name", mechanism_names())
def test_results_are_written_where_the_caller_wants_them(name: str) -> None:
    """Every function of many poses, of every mechanism: `out` is what it returns, and holds what it returns else."""
    robot = dataclasses.replace(read_robot(example_of(name) / "robot.toml"), mechanism=name, tolerance={})
    mechanism = mechanism_of(robot)
    poses = read_recording(example_of(name) / "poses.csv", mechanism, need_measured=False, allow_targets=True)
    tool, rows = np.zeros(3), mechanism.rows(robot)
    q = mechanism.inverse(poses.targets, tool, rows)[0] if poses.targets is not None else poses.joints
    q = np.ascontiguousarray(q[:5])
    x, _ = mechanism.forward(q, tool, rows)
    S = mechanism.sensitivity(x, q, tool, rows)
    target = x if mechanism.turning else x[:, :3]
    at, moved, down = (x, q, tool, rows), np.full((len(q), 3), 0.01), np.array([0.0, 0.0, -9.81])
    calls = [
        lambda out: mechanism.undo(moved, *at, out=out),
        lambda out: mechanism.torques(*at, MASSES, down, 2.0, out=out),
        lambda out: mechanism.weights_at(*at, MASSES, out=out),
        lambda out: mechanism.forward(q, tool, rows, out=out)[0],
        lambda out: mechanism.positions(q, tool, rows, out=out),
        lambda out: mechanism.inverse(target, tool, rows, out=out)[0],
        lambda out: PoseSet(robot, q).positions(np.zeros((2, len(mechanism.parameters))), out=out),
        lambda out: PoseSet(robot, q).commands(np.zeros((2, len(mechanism.parameters))), out=out),
        lambda out: Compensator(robot).command(target, out=out)[0],
    ]
    for call in calls:
        alone = call(None)
        out = np.full(alone.shape, 7.0)
        returned = call(out)
        assert returned is out or np.shares_memory(returned, out)
        assert np.allclose(out, alone, rtol=1e-9, atol=1e-9, equal_nan=True)
        with pytest.raises(ValueError, match="out is an array"):
            call(np.empty((1, 1)))
    several = [lambda out: mechanism.loads(*at, MASSES, down, 2.0, out=out)]
    several += [lambda out: mechanism.jacobians(*at, out=out)] if mechanism.looped else []
    for call in several:
        alone = call(None)
        out = [np.full(one.shape, 7.0) for one in alone]
        assert all(given is filled for given, filled in zip(out, call(out), strict=True))
        assert all(np.allclose(a, b, rtol=1e-9, atol=1e-9) for a, b in zip(out, alone, strict=True))
        with pytest.raises(ValueError, match="out is an array"):
            call([np.empty((1, 1))] * len(out))
    shapes = S.own.base.shape, S.joints.shape
    out = np.full(shapes[0], 7.0), np.full(shapes[1], 7.0)
    again = mechanism.sensitivity(x, q, tool, rows, out=out)
    assert again.own.base is out[0]
    assert again.joints is out[1]
    assert np.allclose(again.parameters, S.parameters, rtol=1e-9, atol=1e-9, equal_nan=True)


@pytest.mark.parametrize(
    ("changed", "says"),
    [
        ({"joints": np.zeros((19, 2))}, r"joints have the shape \(19, 2\); \(N, 3\)"),
        ({"measured": np.zeros((18, 3))}, r"measured has the shape \(18, 3\); \(19, 3\)"),
        ({"measured": np.zeros(2), "pairs": [[0, 1], [2, 19]]}, "whole numbers below 19"),
        ({"tool": np.zeros((3, 3))}, r"tool has the shape \(3, 3\)"),
        ({"model": "17"}, "delta has no model '17'"),
        (
            {"measured": np.ones(2), "pairs": [[0, 1], [3, 3]], "joints": SPREAD},
            r"pairs\[1\] = \[3, 3\] .* two different poses",
        ),
        ({"measured": np.ones(1), "pairs": [[0, 1]]}, "two different poses"),  # all joints are alike
        ({"measured": [-1.0], "pairs": [[0, 1]], "joints": SPREAD}, "cannot be negative"),
        ({"frame": "nonsense"}, "no frame 'nonsense'; known: unknown, robot"),
        ({"sigma": -1.0}, "sigma = -1.0: a standard deviation above 0 mm"),
        ({"sigma": float("nan")}, "sigma = nan"),
    ],
)
def test_what_does_not_go_together_is_said(changed: dict[str, object], says: str) -> None:
    given: dict[str, object] = {"model": "18", "joints": np.zeros((19, 3)), "measured": np.ones((19, 3))} | changed
    with pytest.raises(UsageError, match=says):
        estimate(nominal("delta", PROTOTYPE["geometry"]), **given)


def test_dimensions_are_named() -> None:
    geometry = dict(PROTOTYPE["geometry"])
    with pytest.raises(UsageError, match="no dimension 'arm'"):
        nominal("delta", geometry | {"arm": 1.0})
    with pytest.raises(UsageError, match="one finite number or 3 of them"):
        nominal("delta", geometry | {"limb_angle_deg": [0.0, 120.0]})
    del geometry["distal_length"]
    with pytest.raises(UsageError, match=r"'distal_length' of delta is missing: .* \[mm\]"):
        nominal("delta", geometry)
    with pytest.raises(UsageError, match="made of links"):
        nominal("serial", {})


@pytest.mark.parametrize("n", [0, 19])
@pytest.mark.parametrize("as_distance", [False, True])
def test_no_reading_is_nothing_to_fit(n: int, as_distance: bool) -> None:
    plain = nominal("delta", PROTOTYPE["geometry"])
    with pytest.raises(InputError, match="nothing to fit"):
        estimate(plain, "18", SPREAD[:n], np.full((n, 3), np.nan), as_distance=as_distance)


def test_names_of_the_package_are_found() -> None:
    assert {"estimate", "nominal"} <= set(deltacal_gen.__all__)
    assert deltacal_gen.Robot is Robot


@pytest.fixture(scope="module")
def poses(robot: Robot, measured: dict[str, np.ndarray]) -> PoseSet:
    return PoseSet(robot, measured["joints"], tool=measured["tool"])


def small(n: int, size: float = 0.01) -> np.ndarray:
    """Source errors (n, 42) of machines, a fraction of ordinary ones."""
    typical = load_mechanism("delta").typical
    return size * typical * np.random.default_rng(11).standard_normal((n, len(typical)))


def test_many_machines_stand_where_each_of_them_stands(poses: PoseSet) -> None:
    errors, mechanism = small(3, 1.0), load_mechanism("delta")
    joints = poses.joints + 0.001 * np.arange(3)[:, None, None]
    for given, all_at_once in ((None, poses.positions(errors)), (joints, poses.positions(errors, joints))):
        for t, p in enumerate(errors):
            q = poses.joints if given is None else given[t]
            x, _ = mechanism.forward(q, poses.tool, mechanism.rows(poses.robot, p))
            np.testing.assert_allclose(all_at_once[t], x[:, :3], rtol=0, atol=1e-9)


@pytest.mark.parametrize("kind", ["distances of positions", "distances", "positions"])
def test_small_errors_are_found_in_one_step(poses: PoseSet, kind: str) -> None:
    """What is left of errors a hundred times smaller than ordinary ones is of second order."""
    mechanism = load_mechanism("delta")
    pairs = np.column_stack(np.triu_indices(19, 1))
    linear = {
        "distances of positions": lambda: poses.linear("32", as_distance=True),
        "distances": lambda: poses.linear("18", pairs=pairs),
        "positions": lambda: poses.linear("36", frame="robot"),
    }[kind]()
    free = np.isin([p.name for p in mechanism.parameters], linear.names)
    errors = np.where(free, small(200), 0.0)
    positions = poses.positions(errors)
    gap = positions[:, pairs[:, 1]] - positions[:, pairs[:, 0]]
    found = linear.estimate(np.linalg.norm(gap, axis=2) if kind == "distances" else positions)
    whole = np.full(errors.shape, 7.0)
    assert linear.whole(found, out=whole) is whole
    assert not whole[:, ~free].any()
    left = (whole - errors)[:, free]
    assert np.sqrt((left**2).mean()) < 0.2 * np.sqrt((errors[:, free] ** 2).mean())
    seen = (poses.positions(whole) - positions).std(axis=1)
    assert np.median(seen) < 1e-3 * np.median((positions - poses.positions(0 * errors[0])).std(axis=1))


def test_the_factor_that_is_kept_is_that_of_the_least_squares(poses: PoseSet) -> None:
    linear = poses.linear("32", as_distance=True)
    rng = np.random.default_rng(2)
    measured = poses.positions(np.zeros(42)) + SIGMA * rng.standard_normal((150, 38, 3))
    found = linear.estimate(measured)
    nominal_lengths = linear._lengths(poses.positions(np.zeros(42)))[:, 0]
    for t in (0, 149):
        rest = linear._lengths(measured[t : t + 1])[:, 0] - nominal_lengths
        wanted = np.linalg.lstsq(linear.matrix, rest, rcond=None)[0]
        np.testing.assert_allclose(found[t], wanted, rtol=1e-6, atol=1e-9 * np.abs(wanted).max())


def test_commands_are_those_of_the_linear_compensator(robot: Robot, poses: PoseSet) -> None:
    targets = rings(robot, 9)
    q, _, _ = load_mechanism("delta").inverse(targets, np.zeros(3), load_mechanism("delta").rows(robot))
    errors, check = small(2, 1.0), PoseSet(robot, q)
    names = [p.name for p in load_mechanism("delta").parameters]
    for p, joints in zip(errors, check.commands(errors), strict=True):
        machine = dataclasses.replace(robot, errors=dict(zip(names, p.tolist(), strict=True)))
        wanted, _ = Compensator(machine, "linear").command(targets)
        np.testing.assert_allclose(joints, wanted, rtol=0, atol=1e-10)


def test_pose_sets_say_what_they_cannot(robot: Robot, poses: PoseSet) -> None:
    with pytest.raises(UsageError, match="unknown frame are not linear"):
        poses.linear("18")
    with pytest.raises(UsageError, match=r"shape \(3,\)"):
        PoseSet(robot, np.zeros(3))
    short = nominal("delta", PROTOTYPE["geometry"] | {"distal_length": 300.0})
    with pytest.raises(NoSolutionError, match="row 1 the machine is out of reach"):
        PoseSet(short, [[-1.2, -1.2, -1.2], [0.0, 0.0, 0.0]])


@pytest.mark.parametrize("name", ["delta", "serial"])
def test_errors_and_readings_that_are_too_many_or_few_are_refused(name: str) -> None:
    robot = dataclasses.replace(read_robot(example(f"{name}/robot.toml")), errors={})
    mechanism = mechanism_of(robot)
    n = len(mechanism.parameters)
    poses = PoseSet(robot, np.random.default_rng(3).uniform(0.1, 0.3, (9, mechanism.limbs)))
    for wrong in (n - 1, n + 1, 1):
        for function in (poses.positions, poses.commands, lambda p: mechanism.rows(robot, p)):
            with pytest.raises(UsageError, match=rf"errors have the shape \(4, {wrong}\); \({n},\) or \(M, {n}\)"):
                function(np.zeros((4, wrong)))
    lengths, positions = (
        poses.linear(mechanism.full_model, **how) for how in ({"as_distance": True}, {"frame": "robot"})
    )
    with pytest.raises(UsageError, match=r"shape \(4, 8, 3\); positions \(T, 9, axes\) of each machine"):
        lengths.estimate(np.zeros((4, 8, 3)))
    with pytest.raises(UsageError, match=r"shape \(4, 8, 3\); 27 numbers of each machine"):
        positions.estimate(np.zeros((4, 8, 3)))
