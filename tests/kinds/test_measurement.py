"""Readings and instruments: formulas by hand, derivatives by complex or finite steps, frames, pairs."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from deltacal_gen.errors import InputError
from deltacal_gen.files.robot import Robot
from deltacal_gen.instrument.kind import Instrument, Readings
from deltacal_gen.instrument.kinds import kind_of, readings
from deltacal_gen.machine.registry import Machine
from deltacal_gen.machine.rotation import align, cayley_matrix, from_vector, mean, to_vector
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.simulation import simulate
from tests.support.prototype import plausible, scattered, wanted

TURN, ORIGIN = np.array([0.4, -0.3, 2.1]), np.array([900.0, -500.0, 1200.0])
BODY = np.array([0.2, 0.5, -0.1])


@pytest.fixture(scope="module")
def x() -> np.ndarray:
    """Platforms anywhere, turned by anything up to half a turn (N, 12)."""
    rng = np.random.default_rng(2)
    turned = from_vector(np.pi * rng.uniform(-0.57, 0.57, (12, 3))).reshape(-1, 9)
    return np.hstack([300 * rng.standard_normal((12, 3)) - [0, 0, 850], turned])


def taken(kind: str, n: int = 12) -> Readings:
    rows = np.column_stack([np.arange(n), (np.arange(n) + 5) % n]) if kind == "distance" else np.arange(n)[:, None]
    size = 3 if kind in ("position", "pose") else 1
    zeros = np.zeros(n, dtype=int)
    setup = np.arange(n) % 2 if kind in ("position", "pose") else zeros
    rotations = np.tile(np.eye(3), (n, 1, 1)) if kind == "pose" else None
    return Readings(kind_of(kind), rows, np.zeros((n, size)), rotations, setup, np.arange(n), np.arange(n))


def instrument(kind: str) -> Instrument:
    """Return an instrument in general position, with two set-ups where frames are unknown."""
    if kind == "distance":
        return Instrument(kind_of(kind), np.zeros((1, 0)), ())
    if kind == "gauge":
        return Instrument(kind_of(kind), np.array([[300.0, -100.0, 40.0, 7.0]]), (0, 1, 2, 3))
    frames = [np.concatenate([from_vector(s * TURN).ravel(), s * ORIGIN]) for s in (1.0, -0.5)]
    if kind == "position":
        return Instrument(kind_of(kind), np.array(frames), tuple(range(6)))
    bodies = [from_vector(s * BODY).ravel() for s in (1.0, 2.0)]
    return Instrument(kind_of(kind), np.hstack([np.array(frames), np.array(bodies)]), tuple(range(9)))


def test_a_position_is_turned_and_shifted_into_the_instrument_s_frame(x: np.ndarray) -> None:
    values, rotations = instrument("position").predict(taken("position"), x)
    turn = Rotation.from_rotvec(TURN)
    assert values[::2] == pytest.approx(turn.apply(x[::2, :3]) + ORIGIN, abs=1e-10)
    half = Rotation.from_rotvec(-0.5 * TURN)
    assert values[1::2] == pytest.approx(half.apply(x[1::2, :3]) - 0.5 * ORIGIN, abs=1e-10)
    assert rotations is None


def test_a_pose_is_that_of_a_body_fixed_to_the_platform(x: np.ndarray) -> None:
    values, rotations = instrument("pose").predict(taken("pose"), x)
    platform = Rotation.from_matrix(x[::2, 3:].reshape(-1, 3, 3))
    expected = Rotation.from_rotvec(TURN) * platform * Rotation.from_rotvec(BODY)
    assert rotations[::2] == pytest.approx(expected.as_matrix(), abs=1e-13)
    assert values == pytest.approx(instrument("position").predict(taken("position"), x)[0], abs=1e-10)


def test_a_distance_is_between_the_points_of_its_two_rows(x: np.ndarray) -> None:
    values, _ = instrument("distance").predict(taken("distance"), x)
    assert values[:, 0] == pytest.approx(np.linalg.norm(np.roll(x[:, :3], -5, axis=0) - x[:, :3], axis=1), rel=1e-14)


def test_a_gauge_measures_from_its_base_point_and_its_zero(x: np.ndarray) -> None:
    values, _ = instrument("gauge").predict(taken("gauge"), x)
    assert values[:, 0] == pytest.approx(np.linalg.norm(x[:, :3] - [300.0, -100.0, 40.0], axis=1) + 7.0, rel=1e-14)


def test_the_unknowns_have_names_and_units() -> None:
    assert instrument("gauge").unknown == (("mx", "mm"), ("my", "mm"), ("mz", "mm"), ("dzero", "mm"))
    assert [n for n, _ in instrument("position").unknown][:7] == [
        "wx_1",
        "wy_1",
        "wz_1",
        "tx_1",
        "ty_1",
        "tz_1",
        "wx_2",
    ]
    assert instrument("distance").unknown == ()


def test_residuals_are_measured_minus_predicted(x: np.ndarray) -> None:
    at = instrument("pose")
    values, rotations = at.predict(taken("pose"), x)
    small = 1e-3 * np.random.default_rng(1).standard_normal((12, 3))
    measured = dataclasses.replace(
        taken("pose"), values=values + np.array([1.0, 2.0, 3.0]), rotations=from_vector(small) @ rotations
    )
    r = at.residual(measured, x)
    assert r[:, :3] == pytest.approx(np.tile([1.0, 2.0, 3.0], (12, 1)), abs=1e-9)
    assert r[:, 3:] == pytest.approx(small, abs=1e-13)


def test_a_reading_of_one_setup_tells_nothing_of_another(x: np.ndarray) -> None:
    _, J_m = instrument("position").linearise(taken("position"), x, np.zeros((12, 6, 0)))
    assert (J_m[::2, :, 6:] == 0).all()
    assert (J_m[1::2, :, :6] == 0).all()


# -------------------------------------------------------------------------------------------------- the first alignment


def recorded(robot: Robot, kind: str, errors: dict[str, float], **more: object) -> Recording:
    given = wanted(scattered(robot, 12, 6), kind, **more)
    return simulate(robot, given, errors, frame=(TURN, ORIGIN))


def true_poses(robot: Robot, mechanism: Machine, recording: Recording, errors: dict[str, float]) -> np.ndarray:
    rows = mechanism.rows(robot, mechanism.vector(errors))
    tool = np.zeros(3) if recording.tool is None else recording.tool
    return mechanism.forward(recording.joints, tool, rows)[0]


@pytest.mark.parametrize("kind", ["position", "pose"])
def test_an_unknown_frame_is_aligned_exactly_when_the_machine_is_known(
    robot: Robot, mechanism: Machine, kind: str
) -> None:
    errors = plausible(mechanism, 4)
    recording = recorded(robot, kind, errors)
    found, poses = readings(recording), true_poses(robot, mechanism, recording, errors)
    at = found.kind.start(found, recording, robot, poses)
    assert np.abs(at.residual(found, poses)).max() < 1e-9
    ((turn, origin),) = at.frames()
    assert turn == pytest.approx(TURN, abs=1e-12)
    assert origin == pytest.approx(ORIGIN, abs=1e-9)


def test_the_robot_s_own_frame_leaves_nothing_to_find(robot: Robot, mechanism: Machine) -> None:
    recording = simulate(robot, wanted(scattered(robot, 5, 6), frame="robot"))
    found, poses = readings(recording), true_poses(robot, mechanism, recording, {})
    at = found.kind.start(found, recording, robot, poses)
    assert at.n_unknown == 0
    assert np.abs(at.residual(found, poses)).max() < 1e-9


def test_an_incremental_gauge_has_an_unknown_zero(robot: Robot, mechanism: Machine) -> None:
    point = (420.0, -150.0, 40.0)
    for zero, unknowns in (("absolute", 3), ("incremental", 4)):
        recording = recorded(robot, "gauge", {}, base_point_mm=point, zero=zero)
        assert (recording.measured[0, 0] == 0) == (zero == "incremental")
        poses = true_poses(robot, mechanism, recording, {})
        at = readings(recording).kind.start(readings(recording), recording, robot, poses)
        assert at.n_unknown == unknowns
        assert np.abs(at.residual(readings(recording), poses)).max() < 1e-9


def test_a_gauge_that_was_moved_has_a_zero_of_its_own(robot: Robot, mechanism: Machine) -> None:
    setup = ["a"] * 6 + ["b"] * 6
    recording = recorded(robot, "gauge", {}, base_point_mm=(420.0, -150.0, 40.0), zero="incremental", setup=setup)
    moved = dataclasses.replace(recording, measured=recording.measured + 7.0 * recording.setup[:, None])
    poses = true_poses(robot, mechanism, recording, {})
    at = readings(moved).kind.start(readings(moved), moved, robot, poses)
    assert at.n_unknown == 2 * 4
    assert at.state[1, 3] - at.state[0, 3] == pytest.approx(7.0, abs=1e-9)
    assert np.abs(at.residual(readings(moved), poses)).max() < 1e-9


def test_alignment_recovers_a_rotation_and_never_a_mirror() -> None:
    rng = np.random.default_rng(4)
    a = rng.standard_normal((5, 3))
    turn = from_vector(TURN)
    assert align(a, a @ turn.T) == pytest.approx(turn, abs=1e-13)
    assert np.linalg.det(align(a, a * [1, 1, -1])) == pytest.approx(1.0)
    flat = a * [1, 1, 0]
    assert align(flat, flat @ turn.T) == pytest.approx(turn, abs=1e-13)  # three points in a plane are enough
    assert align(a[:2], a[:2]).tolist() == np.eye(3).tolist()


# ------------------------------------------------------------------------------------------------------- which readings


def test_blank_readings_are_left_out_and_lines_stay_with_theirs(robot: Robot) -> None:
    recording = recorded(robot, "position", {})
    measured = recording.measured.copy()
    measured[3, 1] = np.nan
    found = readings(dataclasses.replace(recording, measured=measured))
    assert len(found) == 11
    assert found.line.tolist() == [2, 3, 4, *range(6, 14)]
    with pytest.raises(InputError, match="every measured cell is blank"):
        readings(dataclasses.replace(recording, measured=np.full((12, 3), np.nan)))


def test_all_pairs_share_tool_point_and_setup_and_join_no_repeats(robot: Robot) -> None:
    tool = np.array([[0.0, 0.0, 0.0]] * 6 + [[50.0, 0.0, 0.0]] * 6)
    setup = ["a", "a", "a", "b", "b", "b"] * 2
    pose = ["1", "1", "2", "3", "4", "5", "6", "7", "8", "9", "10", "11"]
    recording = recorded(robot, "position", {}, tool=tool, setup=setup, pose=pose)
    found = readings(recording, as_distance=True)
    assert found.kind.name == "distance"
    pairs = {tuple(sorted(p)) for p in found.rows.tolist()}
    assert pairs == {(0, 2), (1, 2), (3, 4), (3, 5), (4, 5), (6, 7), (6, 8), (7, 8), (9, 10), (9, 11), (10, 11)}
    group = {tuple(sorted(p)): int(g) for p, g in zip(found.rows.tolist(), found.group, strict=True)}
    assert group[0, 2] == group[1, 2]  # the same two poses: repeats
    assert len(set(group.values())) == len(pairs) - 1
    for (a, b), value in zip(found.rows, found.values[:, 0], strict=True):
        assert value == pytest.approx(np.linalg.norm(recording.measured[a] - recording.measured[b]))


def test_a_rotation_read_now_and_then_counts_where_it_was_read(robot: Robot) -> None:
    recording = recorded(robot, "pose", {})
    measured = recording.measured.copy()
    measured[4:, 3:] = np.nan
    found = readings(dataclasses.replace(recording, measured=measured))
    assert len(found) == 12
    assert found.n_scalars == 12 * 3 + 4 * 3


# ------------------------------------------------------------------------------------------------------------ rotations


@pytest.mark.parametrize("angle", [0.0, 1e-9, 1e-3, 1.0, 3.0, np.pi - 1e-7, np.pi])
def test_rotation_vectors_survive_up_to_half_a_turn(angle: float) -> None:
    v = angle * np.array([0.6, -0.48, 0.64])
    back = to_vector(from_vector(v)[None])[0]
    if angle == np.pi and back @ v < 0:
        back = -back  # both signs are the same half turn
    assert back == pytest.approx(v, abs=2e-8 if angle > 3.1 else 1e-14)


def test_rotations_that_are_none_have_no_vector_and_spoil_no_others() -> None:
    """As of poses that no machine reaches, beside half turns, which are taken by another way."""
    wanted = np.array([[0.1, -0.2, 0.3], [0.0, 0.0, 3.1]])
    found = to_vector(np.concatenate([from_vector(wanted), np.full((1, 3, 3), np.nan)]))
    assert found[:2] == pytest.approx(wanted, abs=1e-12)
    assert np.isnan(found[2]).all()


def test_a_cayley_vector_is_twice_the_tangent_of_half_the_angle() -> None:
    v = np.array([0.2, -0.1, 0.4])
    angle = np.linalg.norm(v)
    c = 2 * np.tan(angle / 2) * v / angle
    assert cayley_matrix(c[None])[0] == pytest.approx(from_vector(v), abs=1e-15)


def test_the_mean_of_rotations_lies_between_them() -> None:
    assert to_vector(mean(from_vector(np.array([[0.0, 0.0, 0.1], [0.0, 0.0, 0.3]])))) == pytest.approx([0, 0, 0.2])
