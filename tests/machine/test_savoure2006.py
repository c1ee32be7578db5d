"""Savoure 2006: the complete Delta and the planar parallelogram, against machines written by hand."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.errors import UsageError
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import Robot, for_model, for_names, read_robot, robot_from_dict, robot_to_dict
from deltacal_gen.identification.identifiability import observability, unseen
from deltacal_gen.identification.identification import identify
from deltacal_gen.machine.registry import SOLVED, UNREACHABLE, Machine, load_mechanism
from deltacal_gen.machine.values import Masses, Recording
from deltacal_gen.physics.simulation import read_truth, simulate, truth_names
from deltacal_gen.use.compensation import Compensator
from derive.review.reproduction.savoure import remaining
from tests.claims.independent_savoure import (
    CHECK,
    CONFIGURATIONS,
    ERRORS,
    NAMES,
    NOMINAL,
    PLANAR,
    SCALE,
    SIGMA,
    Delta,
    planar_closed_form,
    planar_pose,
    study,
    turned,
)
from tests.support.every_effect import ON_MACHINES, channels, machine_with, sized
from tests.support.prototype import PROTOTYPE, wanted

LENGTHS = (0.0, 100.0, 200.0)
IRREGULAR = np.array([0.02, 1.0, -1.0, 30.0, -2.0, 0.0, -40.0, 1.0, -2.0])


# ------------------------------------------------------------------------------------------------ planar parallelogram


@pytest.fixture(scope="module")
def planar() -> Machine:
    return load_mechanism("planar_parallelogram")


def parallelogram(h: float = 100.0) -> Robot:
    robot = read_robot(example("planar_parallelogram") / "robot.toml")
    return dataclasses.replace(robot, geometry=robot.geometry | {"h": np.array([h])})


def pose_of(x: np.ndarray) -> np.ndarray:
    """Return x, y and the angle about z of poses (N, 12)."""
    return np.column_stack([x[:, :2], np.arctan2(x[:, 6], x[:, 3])])


@pytest.mark.parametrize("backend", ["vectorised", "compiled"])
@pytest.mark.parametrize("h", LENGTHS)
@pytest.mark.parametrize("errors", [0 * ERRORS, ERRORS, IRREGULAR], ids=["nominal", "Table 2", "irregular"])
def test_the_forward_position_is_closed(backend: str, h: float, errors: np.ndarray) -> None:
    """The kernel's seed is the closed form: Newton's first step already finds nothing to do."""
    mechanism, robot = load_mechanism("planar_parallelogram"), parallelogram(h)
    rows, q = mechanism.rows(robot, errors), CONFIGURATIONS[:, None]
    k, tool = mechanism.vectorised.constants(rows), np.zeros((len(q), 3))
    if backend == "vectorised":
        seed = mechanism.vectorised._position(np.zeros((3, len(q))), q.T, tool.T, k.T)[:, 0].T
    else:
        seed, status = np.zeros((len(q), 3)), np.empty(len(q), dtype=np.int64)
        mechanism.compiled.simplified_forward(q, tool, k, seed, status)
        assert (status == SOLVED).all()
    expected = np.array([planar_pose(angle, NOMINAL + errors, h) for angle in CONFIGURATIONS])
    assert np.allclose(seed[:, :2], expected[:, :2], atol=1e-9)
    assert np.allclose(2 * np.arctan(seed[:, 2] / 2), expected[:, 2], atol=1e-12)
    x, status = mechanism.forward(q, np.zeros(3), rows)
    assert (status == SOLVED).all()
    assert np.allclose(pose_of(x), expected, atol=1e-9)


def test_forward_and_inverse_undo_each_other(planar: Machine) -> None:
    for tool in (np.zeros(3), np.array([20.0, -35.0, 0.0])):
        rows = planar.rows(parallelogram(), IRREGULAR)
        x, _ = planar.forward(CONFIGURATIONS[:, None], tool, rows)
        q, again, status = planar.inverse(x[:, :3], tool, rows)
        assert (status == SOLVED).all()
        assert np.abs(q[:, 0] - CONFIGURATIONS).max() < 1e-10
        assert np.abs(again - x).max() < 1e-8


def test_both_backends_agree_where_arrays_are_used_again(planar: Machine) -> None:
    """Derivatives that are identically zero must be zero in the compiled kernels too, pose after pose."""
    rows, q, tool = planar.rows(parallelogram(), IRREGULAR), CONFIGURATIONS[:, None], np.zeros((19, 3))
    k = planar.vectorised.constants(rows)
    both = []
    for kernels in (planar.vectorised, planar.compiled):
        x, status = np.empty((19, 3)), np.empty(19, dtype=np.int64)
        kernels.forward(q, tool, k, x, status, False)
        F, J_x, J_q, J_p = np.zeros((19, 3)), np.zeros((19, 3, 3)), np.zeros((19, 3)), np.zeros((19, 3, 9))
        kernels.jacobians(x, q, tool, k, F, J_x, J_q, J_p)
        joints, pose = np.empty((19, 1)), np.empty((19, 3))
        kernels.inverse(np.ascontiguousarray(x[:, :1]), tool, k, pose, joints, status)
        both.append((x, F, J_x, J_q, J_p, joints, pose))
    for a, b in zip(*both, strict=True):
        assert np.abs(a - b).max() < 1e-9


def test_what_cannot_be_assembled_is_unreachable(planar: Machine) -> None:
    rows, q = planar.rows(parallelogram(), 10 * ERRORS), CONFIGURATIONS[:, None]
    x, status = planar.forward(q, np.zeros(3), rows)
    assert status[0] == UNREACHABLE
    assert np.isnan(x[0]).all()
    assert (status[1:] == SOLVED).all()
    _, _, status = planar.inverse(np.array([[2000.0, 0.0, 0.0]]), np.zeros(3), rows)
    assert status[0] == UNREACHABLE


def test_velocity_is_eqs_53_and_54(planar: Machine) -> None:
    rows, e = planar.rows(parallelogram(200.0), ERRORS), 1e-5
    x, _ = planar.forward(CONFIGURATIONS[:, None], np.zeros(3), rows)
    J = planar.sensitivity(x, CONFIGURATIONS[:, None], np.zeros(3), rows).joints[:, 0, 0]
    target = np.zeros((19, 3))
    shifted = []
    for side in (1, -1):
        target[:, 0] = x[:, 0] + side * e
        shifted.append(planar.inverse(target, np.zeros(3), rows)[0][:, 0])
    J_inverse = (shifted[0] - shifted[1]) / (2 * e)
    assert np.allclose(J * J_inverse, 1.0, rtol=1e-6)


def readings(h: float, seed: int | None) -> tuple[Robot, Recording]:
    """Return the machine and the 19 readings of position and orientation, with Table 2's errors."""
    robot = parallelogram(h)
    source = example("planar_parallelogram")
    poses = read_recording(source / "poses.csv", load_mechanism(robot.mechanism), need_measured=False)
    truth = read_truth(source / "truth.toml", robot).errors
    noise = (0.0, 0.0) if seed is None else (SIGMA[0], SIGMA[2])
    rng = np.random.default_rng(seed)
    return robot, simulate(robot, poses, truth, noise_mm=noise[0], noise_rad=noise[1], rng=rng)


@pytest.mark.parametrize("h", LENGTHS)
def test_the_exact_method_leaves_noise(h: float) -> None:
    """Identified with tolerances as priors, compensated exactly: less over all angles than the noise of one reading."""
    robot, recording = readings(h, seed=int(h))
    found = identify(robot, recording)
    assert found.model == "planar_parallelogram/9"
    x = NOMINAL[7] * np.sin(CHECK)
    joints = Compensator(found.robot, "exact").joints(np.column_stack([x, 0 * x, 0 * x]))
    reached = planar_closed_form(joints[:, 0], NOMINAL + ERRORS, h)
    assert np.sqrt(np.mean((reached[:, 0] - x) ** 2)) < SIGMA[0]


@pytest.mark.parametrize("h", LENGTHS)
def test_the_study_is_the_one_by_hand(h: float) -> None:
    """Errors without calibration, after the classical and after the improved one, at all 91 angles, without noise."""
    here, by_hand = remaining(h, None), study(h, None)
    for way in ("none", "classical", "improved"):
        assert np.abs(here[way] - getattr(by_hand, way)).max() < 1e-6
    assert np.abs(here["exact"]).max() < 1e-3


def test_noise_free_readings_give_the_machine_back() -> None:
    """Three of the nine act alone to second order only: what is recovered is the machine, not each error."""
    robot, recording = readings(100.0, None)
    robot = dataclasses.replace(robot, tolerance={})
    found = identify(robot, recording, solver="least-squares")
    k = NOMINAL + np.array([found.robot.errors[name] for name in PLANAR])
    assert np.abs(planar_closed_form(CHECK, k, 100.0) - planar_closed_form(CHECK, NOMINAL + ERRORS, 100.0)).max() < 1e-5


def test_six_base_parameters_in_words() -> None:
    robot, recording = readings(100.0, 1)
    found = identify(robot, recording).answer()
    assert found["rank"] == 6
    told = {frozenset(c["terms"]) for c in found["unidentifiable"] if c["seen"] == "not at all"}
    assert told == {frozenset(pair) for pair in (("a1x", "b1x"), ("a2x", "b2x"), ("a2y", "b2y"))}
    by_pair = {frozenset(b["combination"].replace(" -", "").split()): b for b in found["base"]}
    assert set(by_pair) == told | {frozenset([name]) for name in ("q0", "l1", "l2")}
    for pair, b in by_pair.items():  # eqs. (70)-(72), up to which of the two is kept
        truth = sum((1 if n == b["name"] else -1) * ERRORS[PLANAR.index(n)] for n in pair)
        scale = 180 / np.pi if b["unit"] == "deg" else 1.0
        assert abs(b["value"] - truth * scale) < 5 * b["std"] + 0.05 * abs(truth * scale) + 0.01


def test_the_simplified_model_is_eq_38() -> None:
    robot = for_model(dataclasses.replace(parallelogram(0.0), tolerance={}), "2")
    simplified = load_mechanism(robot.mechanism)
    assert simplified.name == "simplified_parallelogram"
    rows, q = simplified.rows(robot), CONFIGURATIONS[:, None]
    x, _ = simplified.forward(q, np.zeros(3), rows)
    S = simplified.sensitivity(x, q, np.zeros(3), rows)
    assert np.allclose(x[:, 0], 950 * np.sin(CONFIGURATIONS))
    assert np.allclose(S.parameters[:, 0], np.column_stack([950 * np.cos(CONFIGURATIONS), np.sin(CONFIGURATIONS)]))
    assert np.allclose(S.joints[:, 0, 0], 950 * np.cos(CONFIGURATIONS))  # eq. (36)
    again, _, status = simplified.inverse(x[:, :3], np.zeros(3), rows)
    assert (status == SOLVED).all()
    assert np.allclose(again, q)


def test_a_model_of_another_description_calibrates_a_complete_robot() -> None:
    robot, recording = readings(100.0, 1)
    found = identify(robot, recording, "2")
    assert found.model == "planar_parallelogram/2"
    tables = robot_to_dict(found.robot)
    assert tables["robot"]["mechanism"] == "simplified_parallelogram"
    assert robot_from_dict(tables).errors == pytest.approx(found.robot.errors)
    assert found.heldout_rms > 100 * SIGMA[0]  # it does not explain the platform's turn, and says so


# -------------------------------------------------------------------------------------------------- the complete Delta

LIMB = {1: 3, 2: 1, 3: 2}  # the paper's actuators at 60, 180, 300 deg turn the arms at 150, 270, 30 deg
HAND = Delta(tool=(30.0, 20.0, -100.0))
TO_FILE = [1, 2, 0]  # joints
PAPER_TO_FILE = [f"{n.rsplit('_', 1)[0]}_{LIMB[int(n.rsplit('_', 1)[1][0])]}{n.rsplit('_', 1)[1][1:]}" for n in NAMES]


@pytest.fixture(scope="module")
def complete() -> Machine:
    return load_mechanism("complete_delta")


@pytest.fixture(scope="module")
def delta51() -> Robot:
    return for_model(robot_from_dict(PROTOTYPE), "delta/51")


def test_the_complete_delta_is_the_machine_by_hand(complete: Machine, delta51: Robot) -> None:
    """Finite errors of all 51 kinds, a millimetre each: joints and platform agree to rounding."""
    errors = np.random.default_rng(0).standard_normal(51) * SCALE
    x, tool = HAND.positions(4), np.array(HAND.tool)
    rows = complete.rows(delta51, complete.vector(dict(zip(PAPER_TO_FILE, errors, strict=True))))
    q, pose, status = complete.inverse(x, tool, rows)
    assert (status == SOLVED).all()
    for n in range(len(x)):
        expected = HAND.inverse(x[n], errors)
        assert np.allclose(q[n], expected[TO_FILE], atol=1e-12)
        R = turned(HAND.forward(expected, errors, np.concatenate([x[n], np.zeros(3)]))[3:])
        assert np.allclose(pose[n, 3:].reshape(3, 3), R, atol=1e-12)
    again, status = complete.forward(q, tool, rows)
    assert (status == SOLVED).all()
    assert np.abs(again - pose).max() < 1e-9


def test_its_sensitivity_is_eq_22(complete: Machine, delta51: Robot) -> None:
    x, tool = HAND.positions(4, seed=1), np.array(HAND.tool)
    rows = complete.rows(delta51)
    q, pose, _ = complete.inverse(x, tool, rows)
    S = complete.sensitivity(pose, q, tool, rows).parameters[:, :, [complete.index[n] for n in PAPER_TO_FILE]]
    expected = np.array([HAND.sensitivity(p, HAND.inverse(p)) for p in x])
    assert np.abs((S - expected) * SCALE).max() < 1e-9


def poses_at(n: int, kind: str = "pose", seed: int = 0) -> Recording:
    return wanted(HAND.positions(n, seed), kind, frame="robot", tool=np.array(HAND.tool))


def columns(delta51: Robot, part: slice, n: int = 40) -> tuple[np.ndarray, tuple[str, ...], np.ndarray]:
    """Return S_G of eq. (24) in ordinary errors, only some of the six components of each pose, names and errors."""
    complete = load_mechanism(delta51.mechanism)
    tool, rows = np.array(HAND.tool), complete.rows(delta51)
    q, x, _ = complete.inverse(HAND.positions(n), tool, rows)
    S = complete.sensitivity(x, q, tool, rows).parameters * complete.typical
    return S[:, part].reshape(-1, 51), complete.model("51"), complete.typical


@pytest.mark.parametrize(
    ("part", "expected"),
    [(slice(0, 6), 42), (slice(0, 3), 38), (slice(3, 6), 18)],
    ids=["full pose", "position", "orientation"],
)
def test_identifiable_errors_and_null_directions(delta51: Robot, part: slice, expected: int) -> None:
    """Ranks, and that the null directions in words span those derived by hand in closed form."""
    H, names, typical = columns(delta51, part)
    assert observability(H, 40).rank == expected
    told = unseen(H / typical, names, ["mm"] * 48 + ["rad"] * 3, typical)
    assert len(told) == 51 - expected
    by_hand = list(HAND.unseen_by_pose().values())
    if part == slice(0, 3):
        by_hand += HAND.unseen_by_position().values()
    if part == slice(3, 6):
        by_hand += HAND.unseen_by_orientation().values()
    span = np.array([[c.terms.get(n, 0.0) for n in PAPER_TO_FILE] for c in told]) / SCALE
    directions = np.array(by_hand) / SCALE
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    assert len(directions) == len(told)
    rest = directions - directions @ np.linalg.pinv(span) @ span
    assert np.abs(rest).max() < 1e-5


def test_base_parameters_come_back_within_their_deviations(delta51: Robot) -> None:
    """39 combinations in words; each is as far from the truth as its standard deviation says.

    An instrument's target is mounted at an unknown constant rotation: three fewer than with the rotation known.
    """
    rng = np.random.default_rng(7)
    complete = load_mechanism(delta51.mechanism)
    truth = dict(zip(complete.index, rng.standard_normal(51) * complete.typical, strict=True))
    recording = simulate(delta51, poses_at(30, seed=2), truth, noise_mm=0.005, noise_rad=2e-5, rng=rng)
    found = identify(robot_from_dict(PROTOTYPE), recording, "delta/51")
    told = found.answer()
    assert told["rank"] == 39 == len(told["base"]) == len(found.seen.base)
    assert len([c for c in told["unidentifiable"] if c["seen"] == "not at all"]) == 12
    off = []
    for terms, entry in zip(found.seen.base.values(), told["base"], strict=True):
        unit = 180 / np.pi if entry["unit"] == "deg" else 1.0
        actual = sum(factor * truth[n] for n, factor in terms.items()) * unit
        off.append((entry["value"] - actual) / entry["std"])
    assert np.abs(off).max() < 4.5
    assert 0.6 < np.sqrt(np.mean(np.square(off))) < 1.5


def test_approximated_and_exact_inverse_position(complete: Machine, delta51: Robot) -> None:
    """Eqs. (29)-(33) leave an error of second order; the exact inverse leaves none."""
    targets = HAND.positions(5, seed=3)
    errors = np.random.default_rng(8).standard_normal(51) * complete.typical
    left = []
    for t in (1.0, 0.5):
        truth = dict(zip(complete.index, t * errors, strict=True))
        robot = dataclasses.replace(delta51, errors=truth, tool=np.array(HAND.tool))
        rows = complete.rows(robot)
        reached = {
            kind: complete.forward(Compensator(robot, kind).joints(targets), robot.tool, rows)[0][:, :3]
            for kind in ("linear", "exact")
        }
        assert np.abs(reached["exact"] - targets).max() < 1e-8
        left.append(np.linalg.norm(reached["linear"] - targets, axis=1).max())
    assert left[0] / left[1] == pytest.approx(4, rel=0.25)
    q = Compensator(robot, "linear").joints(targets)
    by_hand = np.array([HAND.inverse(x) for x in targets])
    for n, x in enumerate(targets):  # eqs. (29)-(33) by hand
        scaled = np.array([truth[name] for name in PAPER_TO_FILE])
        q_hand = by_hand[n] - HAND.joint_matrix(x, by_hand[n]) @ (HAND.sensitivity(x, by_hand[n]) @ scaled)[:3]
        assert np.allclose(q[n], q_hand[TO_FILE], atol=1e-9)


def test_errors_of_one_kind_name_the_description(tmp_path: Path) -> None:
    robot = robot_from_dict(PROTOTYPE)
    assert for_names(robot, ["bx_11", "betaz_3"]).mechanism == "complete_delta"
    assert for_names(robot, ["theta_1", "dl_2"]).mechanism == "delta"
    assert robot_from_dict(PROTOTYPE | {"errors": {"ax_21": 0.5}}).mechanism == "complete_delta"
    truth = tmp_path / "truth.toml"
    truth.write_text("[parameters]\nl_11 = 0.5\n")
    assert truth_names(truth) == ("l_11",)
    with pytest.raises(UsageError, match=r"complete_delta has no theta_1"):
        for_model(dataclasses.replace(robot, errors={"theta_1": 0.1}), "51")


@pytest.mark.parametrize("name", [n for n in ON_MACHINES if machine_with(n).mechanism == "delta"])
def test_effects_move_both_descriptions_alike(robot: Robot, name: str) -> None:
    """At nominal geometry the Delta of 42 errors and that of 51 are one machine, whatever its physics."""
    masses = Masses(proximal=1.2, proximal_com=0.4, distal_rod=0.15, platform=0.8)
    bai = Compensator(dataclasses.replace(robot, masses=masses), terms=(sized(name),))
    savoure = Compensator(for_model(bai.robot, "delta/51"), terms=(sized(name),))
    q = np.random.default_rng(1).uniform(-0.6, 0.3, (12, 3))
    tool = np.array([30.0, -20.0, -80.0])
    at, _ = bai.channels(channels(robot, 12), 12)
    (one, _), (other, _), (rigid, _) = (
        bai.reached(q, tool, at),
        savoure.reached(q, tool, at),
        Compensator(robot).reached(q, tool),
    )
    moved = np.abs(one - rigid).max()
    assert moved > 0.05
    assert np.abs(one - other).max() < 2e-3 * moved  # the second order of parts that turn


def test_a_base_and_rods_that_grow_move_the_parallelogram_as_longer_ones_do(tmp_path: Path) -> None:
    robot = read_robot(example("planar_parallelogram") / "robot.toml")
    poses = tmp_path / "poses.csv"
    poses.write_text("q1_deg,temp_C\n" + "".join(f"{q},45\n" for q in range(-40, 41, 10)))
    poses.with_suffix(".toml").write_text('[measurement]\nkind = "position"\nframe = "robot"\n')
    growth = {"proximal": 12e-6, "distal": 20e-6, "base": 8e-6}
    lines = "\n".join(f"expansion_{part} = {much}" for part, much in growth.items())
    (tmp_path / "warm.toml").write_text(f'[[effects]]\nname = "thermal_growth"\n{lines}\n')
    (tmp_path / "cold.toml").write_text("[parameters]\n")
    longer = {"l1": 950 * 25 * growth["proximal"], "l2": 950 * 25 * growth["distal"]}
    longer |= dict.fromkeys(("a1x", "a2x"), 125 * 25 * growth["base"])
    warm, cold, still = (
        dc.simulate(robot, poses, truth=truth).measured
        for truth in (tmp_path / "warm.toml", longer, tmp_path / "cold.toml")
    )
    assert np.abs(warm - cold).max() < 1e-9
    assert np.abs(warm - still).max() > 0.2
