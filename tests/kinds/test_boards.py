"""Printed boards, touched or seen: what is found of machine, camera and print, and what is said to be one of two."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.errors import InputError
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import Robot, robot_from_dict
from deltacal_gen.files.writing import write_recording
from deltacal_gen.identification.identification import identify
from deltacal_gen.instrument import board
from deltacal_gen.instrument.kinds import kind_of, readings
from deltacal_gen.machine.registry import Array, load_mechanism
from deltacal_gen.machine.rotation import from_vector
from deltacal_gen.machine.values import Camera, Measurement, Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.results.result import Parameter, Result
from deltacal_gen.units import DEG
from deltacal_gen.use import prediction
from tests.support.prototype import PROTOTYPE, scattered

MODEL = "delta/18"
TRUTH = {"theta_1": 0.3 * DEG, "theta_2": -0.2 * DEG, "L_1": 0.3, "l_2": 0.2}
LENS = {"fx_px": 1500.0, "fy_px": 1480.0, "cx_px": 640.0, "cy_px": 512.0, "k1": -0.1}
GRID = np.array([[40.0 * i, 40.0 * j] for i in range(4) for j in range(3)])
ARM = {
    "robot": {"name": "arm", "mechanism": "serial"},
    "joint": [
        {"kind": "revolute", "d": 300.0, "a": 20.0, "alpha": -90.0, "theta": 0.0},
        {"kind": "revolute", "d": 0.0, "a": 350.0, "alpha": 0.0, "theta": -90.0},
        {"kind": "revolute", "d": 0.0, "a": 30.0, "alpha": -90.0, "theta": 0.0},
        {"kind": "revolute", "d": 350.0, "a": 0.0, "alpha": 90.0, "theta": 0.0},
        {"kind": "revolute", "d": 0.0, "a": 0.0, "alpha": -90.0, "theta": 0.0},
        {"kind": "revolute", "d": 80.0, "a": 0.0, "alpha": 0.0, "theta": 0.0},
    ],
    "geometry": {"tool": [0.0, 0.0, 0.0]},
}


@pytest.fixture(scope="module")
def robot() -> Robot:
    return robot_from_dict(PROTOTYPE)


def poses(robot: Robot, targets: Array, kind: str, said: Measurement) -> Recording:
    """Return a recording without readings at targets (N, 3), or at joints (N, n_q); images show all of `GRID`."""
    made, mechanism = kind_of(kind), load_mechanism(robot.mechanism, robot.links)
    each = len(GRID) if made.known else 1
    rows = len(targets) * each
    commanded = np.repeat(targets, each, axis=0)
    asks = robot.mechanism == "delta"
    columns = made.columns(mechanism)
    return Recording(
        path=Path("recording.csv"),
        kind=kind,
        measurement=dataclasses.replace(said, kind=kind),
        joint_unit=mechanism.joint_unit,
        joints=np.full((rows, mechanism.limbs), np.nan) if asks else commanded,
        columns=columns,
        measured=np.full((rows, len(columns)), np.nan),
        pose=(np.arange(rows) // each).astype(str),
        line=np.arange(rows) + 2,
        channels=dict(zip(made.known, np.tile(GRID, (len(targets), 1)).T, strict=False)),
        setup=np.zeros(rows, dtype=int),
        setup_names=("1",),
        targets=commanded if asks else None,
    )


def seen(robot: Robot, said: Measurement, *, noise: float = 0.02, wrong: float = 0.0, count: int = 25) -> Recording:
    """Return images of a board by a machine with errors; `wrong` of the points are found elsewhere."""
    exact = dataclasses.replace(said, camera=Camera(**LENS, place=said.camera.place if said.camera else "platform"))
    blank = poses(robot, scattered(robot, count, 5), "board_image", exact)
    rng = np.random.default_rng(3)
    made = simulate(robot, blank, TRUTH, noise_mm=noise, rng=rng)
    values = made.measured.copy()
    off = rng.random(len(values)) < wrong
    values[off] += rng.uniform(-90, 90, (int(off.sum()), 2))
    return dataclasses.replace(made, measured=values, measurement=dataclasses.replace(said, kind="board_image"))


def touched(robot: Robot, said: Measurement) -> Recording:
    blank = poses(robot, scattered(robot, 60, 5), "touched_board", said)
    return simulate(robot, blank, TRUTH, noise_mm=0.02, rng=np.random.default_rng(4))


def named(result: Result, name: str) -> Parameter:
    (found,) = (p for p in result.parameters if p.name == name)
    return found


# ----------------------------------------------------------------------------------------------------------- the lens


def test_the_image_is_opencv_s() -> None:
    cv2 = pytest.importorskip("cv2")
    rng = np.random.default_rng(2)
    turns = from_vector(0.3 * rng.standard_normal((3, 3)))
    platform = np.hstack([[10.0, -20.0, 30.0], turns[0].ravel()])[None]
    lens = np.array([900.0, 950.0, 600.0, 400.0, -0.2, 0.1, 0.002, -0.003, 0.05])
    camera, origin = np.array([5.0, -7.0, 400.0]), np.array([30.0, 10.0, 40.0])
    for rides in (1.0, 0.0):
        state = np.concatenate([turns[1].ravel(), camera, turns[2].ravel(), origin, [0.01], lens, [rides]])
        flat = np.array([[30.0, 40.0], [-20.0, 10.0]])
        given = np.hstack([np.tile(state, (2, 1)), flat])
        read = kind_of("board_image").kernels.reading(np.tile(platform, (2, 1)), given)
        R, P = turns[0], platform[0, :3]
        fixed = (1.01 * np.column_stack([flat, np.zeros(2)])) @ turns[2].T + origin
        own = (fixed - P) @ R if rides else fixed @ R.T + P
        inside = own @ turns[1].T + camera
        K = np.array([[lens[0], 0, lens[2]], [0, lens[1], lens[3]], [0, 0, 1]])
        wanted, _ = cv2.projectPoints(inside, np.zeros(3), np.zeros(3), K, lens[4:])
        assert read == pytest.approx(wanted[:, 0], abs=1e-9)


def test_a_homography_is_found_beside_wrong_points() -> None:
    rng = np.random.default_rng(1)
    H = np.array([[2.0, 0.1, 30.0], [-0.2, 1.8, -20.0], [1e-4, -2e-4, 1.0]])
    image = np.hstack([GRID, np.ones((12, 1))]) @ H.T
    image = image[:, :2] / image[:, 2:]
    image[3] += rng.uniform(20, 40, 2)
    found = board.homography(GRID, image)
    assert found is not None
    assert found / found[2, 2] == pytest.approx(H, abs=1e-6)
    assert board.homography(GRID * [1.0, 0.0], image) is None


# --------------------------------------------------------------------------------------------------------- the machine


@pytest.mark.parametrize("seed", range(4))
def test_camera_and_board_are_found_from_where_images_show_the_board_and_one_shows_it_wrongly(seed: int) -> None:
    """The first estimate, before any fit: to a few times the noise of where boards were seen to stand."""
    rng, n = np.random.default_rng(seed), 9
    S, C, B = (from_vector(rng.uniform(-2, 2, (m, 3))) for m in (n, 1, 1))
    s, g, f = rng.normal(0, 300, (n, 3)), rng.normal(0, 300, 3), rng.normal(0, 50, 3)
    M = C @ S @ B @ from_vector(rng.normal(0, 1e-3, (n, 3)))
    t = (np.einsum("nij,j->ni", S, g) + s) @ C[0].T + f + rng.normal(0, 0.3, (n, 3))
    M[0], t[0] = B[0], t[0] + 200.0
    for found, true, near in zip(board.hand_eye(M, t, S, s), (C[0], f, B[0], g), (5e-3, 2.0, 5e-3, 2.0), strict=True):
        assert found == pytest.approx(true, abs=near)


@pytest.mark.parametrize("place", ["platform", "fixed"])
def test_a_machine_is_found_by_images_with_wrong_points(robot: Robot, place: str) -> None:
    said = Measurement(camera=Camera(**LENS, place=place))
    result = identify(robot, seen(robot, said, wrong=0.04), MODEL).answer()
    for p in result.parameters:
        if p.status == "identified":
            true = TRUTH.get(p.name, 0.0) / (DEG if p.unit == "deg" else 1.0)
            assert p.std is not None
            assert abs(p.value - true) < 4 * p.std, p.name
    assert result.unit == "px"
    assert result["sigma_mm"] == pytest.approx(0.02, rel=0.35)
    assert result["train_rms_px"] == pytest.approx(result["train_rms_mm"] / result["unit_mm"])


@pytest.mark.walk
@pytest.mark.parametrize("work", [identify, diagnose])
def test_images_that_show_nothing_of_the_machine_are_refused(robot: Robot, work: Callable[..., object]) -> None:
    good = seen(robot, Measurement(kind="board image", sigma_px=0.02, camera=Camera(**LENS)), count=12)
    ends = good.measured.min(axis=0), good.measured.max(axis=0)
    noise = dataclasses.replace(good, measured=np.random.default_rng(17).uniform(*ends, good.measured.shape))
    with pytest.raises(InputError, match="of what the images differ by"):
        work(robot, noise)


def test_a_lens_is_found_with_the_machine(robot: Robot) -> None:
    said = Measurement(camera=Camera(k1=math.nan))
    result = identify(robot, seen(robot, said), MODEL).answer()
    for name, true in LENS.items():
        p = named(result, name)
        assert p.status == "identified"
        assert p.std is not None
        assert p.value == pytest.approx(true, abs=4 * p.std)
        assert p.unit == ("px" if name.endswith("px") else "1")


def test_an_image_that_is_wrong_does_not_say_how_long_the_lens_is() -> None:
    """One of five points, of which one was found wrongly, leads to a homography that seems to see much perspective."""
    rng, focal, H = np.random.default_rng(4), 1500.0, []
    for _ in range(9):
        R = from_vector(rng.uniform(-0.4, 0.4, (1, 3)))[0].reshape(3, 3)
        H.append(np.diag([focal, focal, 1.0]) @ np.column_stack([R[:, :2], [20.0, -30.0, 400.0]]))
    assert board.focal_length(np.array(H), 1280.0) == pytest.approx(focal, rel=1e-9)
    H[3] = H[3] @ np.array([[1, 0, 0], [0, 1, 0], [0.01, -0.02, 1]])
    assert board.focal_length(np.array(H), 1280.0) == pytest.approx(focal, rel=1e-9)


def test_focal_length_and_distance_are_one_where_nothing_tilts_or_comes_nearer(robot: Robot) -> None:
    """A camera that looks straight down from one height, through a lens without distortion."""
    plain = {**LENS, "k1": 0.0}
    level = scattered(robot, 25, 5)
    level[:, 2] = level[:, 2].mean()
    made = simulate(robot, poses(robot, level, "board_image", Measurement(camera=Camera(**plain))), {})
    noise = 0.02 * np.random.default_rng(3).standard_normal(made.measured.shape)
    said = Measurement(kind="board_image", camera=Camera(cx_px=640.0, cy_px=512.0))
    made = dataclasses.replace(made, measured=made.measured + noise, measurement=said)
    result = identify(robot, made, "delta/3").answer()
    focal = named(result, "fx_px")
    assert (focal.status, focal.std) == ("not pinned", None)
    assert "the distance of the board" in (focal.indistinguishable_from or ())
    assert any("height of the camera" in m.measurement for m in result.next_measurements)


def test_hand_and_eye_of_an_arm_are_found_with_its_joints() -> None:
    """The camera on the last link, which turns by up to 25 deg: nothing of it is known but the lens."""
    arm = robot_from_dict(ARM)
    rng = np.random.default_rng(7)
    joints = np.array([0.2, 0.1, 0.3, 0.2, 0.9, 0.1]) + rng.uniform(-0.3, 0.3, (25, 6))
    said = Measurement(camera=Camera(**LENS))
    truth = {"theta_2": 0.2 * DEG, "a_2": 0.5, "theta_5": -0.3 * DEG}
    blank = poses(arm, joints, "board_image", said)
    made = simulate(arm, blank, truth, noise_mm=0.05, rng=np.random.default_rng(8))
    result = identify(arm, made).answer()
    for name, true in truth.items():
        p = named(result, name)
        assert p.status == "identified"
        assert p.std is not None
        assert p.value == pytest.approx(true / (DEG if p.unit == "deg" else 1.0), abs=4 * p.std)
    assert result["train_rms_mm"] == pytest.approx(0.05, rel=0.1)


# ---------------------------------------------------------------------------------------------------------- the scale


@pytest.mark.parametrize("kind", ["touched_board", "board_image"])
def test_a_print_s_scale_and_the_machine_s_are_said_to_be_one(robot: Robot, kind: str) -> None:
    said = Measurement(board_scale="unknown", camera=Camera(**LENS))
    made = seen(robot, said) if kind == "board_image" else touched(robot, said)
    result = identify(robot, made, MODEL).answer()
    scale = named(result, "board_scale")
    assert (scale.status, scale.std) == ("not pinned", None)
    assert scale.indistinguishable_from is not None
    assert scale.indistinguishable_from[0] == "the machine's own scale"
    assert {"L_1", "l_1"} <= {*scale.indistinguishable_from}
    assert named(result, "L_1").status == "not pinned"
    (told,) = (c for c in result.unidentifiable if "board_scale" in c.terms)
    assert "board_scale and the machine's own scale are one number" in told.text
    assert told.terms["L_1"] / told.terms["board_scale"] == pytest.approx(375.0, rel=0.02)
    assert "callipers" in result.next_measurements[0].measurement


def test_a_prior_on_the_lengths_settles_it(robot: Robot) -> None:
    lengths = {f"{name}_{i}": 0.01 for name in ("L", "l") for i in (1, 2, 3)}
    known = dataclasses.replace(robot, tolerance=lengths)
    made = touched(robot, Measurement(board_scale="unknown"))
    scale = named(identify(known, made, MODEL).answer(), "board_scale")
    assert scale.status in ("pinned by prior", "identified")
    assert scale.indistinguishable_from is None
    assert scale.std is not None


def test_a_known_scale_leaves_nothing_to_be_said(robot: Robot) -> None:
    result = identify(robot, touched(robot, Measurement()), MODEL).answer()
    assert not any("one number" in c.text for c in result.unidentifiable)
    assert named(result, "L_1").status == "identified"


def test_a_diagnosis_says_it_too(robot: Robot) -> None:
    found = diagnose(robot, touched(robot, Measurement(board_scale="unknown")), MODEL).answer()
    assert found.verdict == "adequate"
    assert found["parameters"][0]["indistinguishable_from"][0] == "the machine's own scale"
    assert found.next_measurements[0].why == "separates board_scale from the machine's own scale"


# --------------------------------------------------------------------------------------------------------------- files


def test_sidecars_call_a_touched_board_a_position(robot: Robot, tmp_path: Path) -> None:
    made = touched(robot, Measurement())
    flat = dataclasses.replace(made, measured=np.column_stack([made.measured[:, :2], np.zeros(len(made.joints))]))
    write_recording(flat, tmp_path / "touched.csv")
    header, *rows = (tmp_path / "touched.csv").read_text().splitlines()
    keep = [k for k, name in enumerate(header.split(",")) if name != "board_z_mm"]
    lines = [",".join(line.split(",")[k] for k in keep) for line in (header, *rows)]
    (tmp_path / "touched.csv").write_text("\n".join(lines) + "\n")
    (tmp_path / "touched.toml").write_text('[measurement]\nkind = "position"\nboard_scale = "unknown"\n')
    again = read_recording(tmp_path / "touched.csv", load_mechanism("delta"))
    assert again.kind == "touched_board"
    assert again.measured == pytest.approx(flat.measured)


def test_images_say_which_points_they_show(robot: Robot, tmp_path: Path) -> None:
    write_recording(seen(robot, Measurement(camera=Camera(**LENS)), count=4), tmp_path / "seen.csv")
    again = read_recording(tmp_path / "seen.csv", load_mechanism("delta"))
    assert again.kind == "board_image"
    assert readings(again).known == pytest.approx(np.tile(GRID, (4, 1)))
    text = (tmp_path / "seen.csv").read_text().replace("board_x_mm", "board_a_mm")
    (tmp_path / "seen.csv").write_text(text)
    with pytest.raises(InputError, match="column 'board_x_mm' is missing"):
        read_recording(tmp_path / "seen.csv", load_mechanism("delta"))


def test_too_few_points_to_begin_are_told(robot: Robot) -> None:
    made = seen(robot, Measurement(camera=Camera(**LENS)), count=12)
    with pytest.raises(InputError, match="0 images show 4 points or more"):
        identify(robot, made.subset(np.arange(0, made.n_rows, 4)), "delta/3")


def test_predictions_are_in_pixels(robot: Robot) -> None:
    made = seen(robot, Measurement(camera=Camera(**LENS)))
    half = made.n_rows // 2 // len(GRID) * len(GRID)
    result = identify(robot, made.subset(slice(0, half)), "delta/3").answer()
    other = made.subset(slice(half, None))
    told = prediction.predict(result, dataclasses.replace(other, measured=np.full((other.n_rows, 2), np.nan)))
    assert told.columns == ("u_px", "v_px")
    assert np.abs(told.measured - other.measured).max() < 1.5


def test_what_of_a_lens_is_told_by_nothing_but_priors_names_its_rival_and_how_well_it_must_be_known() -> None:
    """A camera on a platform that only shifts it: its principal point may be its tilt, for a machine askew."""
    delta = robot_from_dict(PROTOTYPE)
    plain = Measurement(camera=Camera(**{**LENS, "k1": 0.0}))
    made = seen(delta, plain)
    blank = dataclasses.replace(made, measurement=dataclasses.replace(made.measurement, camera=None))
    result = identify(delta, blank, "delta/42").answer()
    centre = named(result, "cx_px")
    assert (centre.status, centre.std) == ("not pinned", None)
    assert centre.indistinguishable_from is not None
    assert centre.indistinguishable_from[0].startswith("where the camera looks")
    (told,) = (m.measurement for m in result.next_measurements if "say cx_px" in m.measurement)
    accuracy = float(told.removesuffix(" px").rpartition(" ")[2])
    # it moves half of what is read; points of one image, which are no repeats of one another, tell the noise
    assert accuracy == pytest.approx(2**0.5 * result["sigma_px"], rel=0.1)
