"""Feed-forward of open chains on a controller: the exported C file, compiled, against the command."""

from __future__ import annotations

import ctypes
import re
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import deltacal_gen as dc
from deltacal_gen.files.robot import kept_robot, robot_from_dict
from deltacal_gen.machine.dynamics import dynamics_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.results.motion import JointModel, TorqueTerm
from tests.support.compiled_c import COMPILER, JUMPED, LIMITED, NOT_A_NUMBER, STRICT, needs_compiler
from tests.support.every_effect import ARM, LIFT
from tests.support.motion_recordings import PLANNED, usual, written
from tests.support.moving_chains import bodies

DEG = np.pi / 180
REST = 2.0 * DEG  # rad/s
SIGNS = np.array([1.0, -1.0, 1.0, 1.0, -1.0, 1.0])
UNREACHABLE, SINGULAR = 1, 2
TERMS = (
    TorqueTerm(effect="coulomb_friction", constants=(), values=(4000.0,)),
    TorqueTerm(effect="viscous_friction", constants=(), values=(3000.0,)),
    TorqueTerm(effect="stribeck_friction", constants=(0.1,), values=(1500.0,)),
    TorqueTerm(effect="load_friction", constants=(), values=(0.05,)),
    TorqueTerm(effect="torque_ripple", constants=(7.0,), values=(300.0, -200.0)),
)
DRIVEN = (1, 3)  # joints, from 0, whose drive's inertia is stated
SIX = ctypes.c_double * 6


class Held(ctypes.Structure):
    """What is kept between calls, as the head of the file has it."""

    _fields_ = (("joints", SIX), ("torque", SIX), ("period_s", ctypes.c_double), ("begun", ctypes.c_int))


def arm(**changes: Any) -> Any:
    """Return an arm of six joints with source errors and a tool, some of whose joints count backwards."""
    tables = {
        "robot": {"name": "arm", "mechanism": "serial"},
        "geometry": {"tool": [40.0, -15.0, 90.0]},
        "joints": {"sign": SIGNS.tolist(), "limits_deg": [[-170.0, 170.0]] * 6},
        "joint": [dict(link) | ({"rotor_inertia": 3e5} if k in DRIVEN else {}) for k, link in enumerate(ARM)],
        "errors": {"a_2": 0.8, "alpha_3": 0.1, "theta_4": -0.2, "d_5": 0.4},
    }
    return robot_from_dict(tables | changes)


def answered(folder: Path, robot: Any) -> Any:
    """Return what a diagnosis would say of a machine with known bodies and friction on every joint."""
    own = dynamics_of(robot)
    inertia = np.append(bodies(robot.links).ravel(), [3e5 + 1e4 * n for n in range(len(own.rotors))])
    joints = tuple(
        JointModel(
            joint=j + 1,
            columns=tuple(range(len(inertia))),
            coefficients=tuple(inertia.tolist()),
            terms=TERMS,
            at_rest_below=REST,
        )
        for j in range(own.joints)
    )
    recording = written(folder, usual, runs=3, seconds=4.0)
    dc.diagnose(recording.with_name("robot.toml"), recording, output=folder / "diagnosis.json")
    units = ["N" if unit == "mm" else "Nm" for unit in own.joint_units]
    columns = tuple(f"tau{j + 1}_{unit}" for j, unit in enumerate(units))
    answer: Any = dc.read_answer(folder / "diagnosis.json")
    return answer.replace(robot=kept_robot(robot), joints=joints, columns=columns, inertial=own.names, known=None)


def compiled(folder: Path, answer: Any, name: str) -> Any:
    """Return the exported file as a library."""
    source, library = folder / f"{name}.c", folder / f"{name}.so"
    dc.export_compensator(answer.to_dict(), output=source, export="c")
    text = source.read_text()
    assert "malloc" not in text
    assert "while (" not in text
    assert not re.search(r"^static (?!const|int|double|void)", text, re.M)  # nothing is kept between calls
    assert COMPILER is not None
    subprocess.run([COMPILER, *STRICT, str(source), "-o", str(library), "-lm"], check=True)
    return ctypes.CDLL(str(library))


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("chain")


@pytest.fixture(scope="module")
def answer(folder: Path) -> Any:
    return answered(folder, arm())


@pytest.fixture(scope="module")
def controller(folder: Path, answer: Any) -> Any:
    return compiled(folder, answer, "arm")


def told(function: Any, held: Any, *given: Any, payload: float = 0.0) -> tuple[int, np.ndarray, np.ndarray]:
    own = type(held.joints)
    code = function(
        ctypes.byref(held), *(own(*part) for part in given), ctypes.c_double(payload), ctypes.c_double(20.0)
    )
    return code, np.array(held.joints), np.array(held.torque)


def states(n: int, joints: int = 6, seed: int = 0) -> np.ndarray:
    """Return joints, speeds, accelerations (3, n, joints) [deg, s] along a movement that turns back."""
    rng, t = np.random.default_rng(seed), np.linspace(0.0, 2.0, n)[:, None]
    home = np.array([10.0, -60.0, 80.0, -30.0, 50.0, 20.0])[:joints]
    a, w, p = rng.uniform(5, 15, joints), rng.uniform(2, 5, joints), rng.uniform(0, 6, joints)
    return np.array([home + a * np.sin(w * t + p), a * w * np.cos(w * t + p), -a * w**2 * np.sin(w * t + p)])


def by_command(folder: Path, answer: Any, given: np.ndarray, payload: float, units: tuple[str, ...] = ()) -> np.ndarray:
    """Return the torques (n, joints) that the command gives at states."""
    units = units or ("deg",) * given.shape[2]
    names = [f"{w}{j + 1}_{u}{e}" for w, e in (("q", ""), ("qd", "_s"), ("qdd", "_s2")) for j, u in enumerate(units)]
    time = 0.01 * np.arange(given.shape[1])
    table = np.column_stack([time, *given, np.full(len(time), payload)])
    text = [",".join(["time_s", *names, "payload_kg"]), *(",".join(map(repr, row)) for row in table.tolist())]
    (folder / "states.csv").write_text("\n".join(text))
    (folder / "states.toml").write_text(PLANNED)
    return dc.feed_forward(answer.to_dict(), folder / "states.csv").torque


@needs_compiler
@pytest.mark.parametrize("payload", [0.0, 1.5])
def test_joints_ask_for_the_torques_of_the_command(folder: Path, answer: Any, controller: Any, payload: float) -> None:
    given = states(60)
    assert (np.abs(given[1]) * DEG < REST).any()
    wanted, held = by_command(folder, answer, given, payload), Held(period_s=1.0)
    for n in range(given.shape[1]):
        code, joints, torque = told(controller.deltacal_feedforward_joints, held, *given[:, n], payload=payload)
        assert code == 0
        assert joints == pytest.approx(given[0, n], abs=1e-12)
        assert torque == pytest.approx(wanted[n], abs=1e-9 * np.abs(wanted).max())


def pose_of(robot: Any, q: np.ndarray) -> np.ndarray:
    """Return tool point [mm] and rotation of the last frame, (n, 12), at joints (n, 6) [deg] of the controller."""
    mechanism = mechanism_of(robot)
    return np.asarray(mechanism.forward(q * SIGNS * DEG, robot.tool, mechanism.rows(robot))[0])


def along(robot: Any, given: np.ndarray, h: float = 1e-3) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return poses (n, 6) [mm, deg], their velocity and acceleration, by central differences of eighth order."""
    first, second = (4 / 5, -1 / 5, 4 / 105, -1 / 280), (8 / 5, -1 / 5, 8 / 315, -1 / 560)
    at = {k: pose_of(robot, given[0] + k * h * given[1] + (k * h) ** 2 / 2 * given[2]) for k in range(-4, 5)}
    d1 = sum(c * (at[k] - at[-k]) for k, c in enumerate(first, start=1)) / h
    d2 = (sum(c * (at[k] + at[-k]) for k, c in enumerate(second, start=1)) - 205 / 72 * at[0]) / h**2
    R, R1, R2 = (x[:, 3:].reshape(-1, 3, 3) for x in (at[0], d1, d2))

    def vector(S: np.ndarray) -> np.ndarray:
        return np.column_stack([S[:, 2, 1] - S[:, 1, 2], S[:, 0, 2] - S[:, 2, 0], S[:, 1, 0] - S[:, 0, 1]]) / 2 / DEG

    turn = Rotation.from_matrix(R).as_rotvec() / DEG
    spin, spun = (vector(np.einsum("nij,nkj->nik", X, R)) for X in (R1, R2))
    return np.hstack([at[0][:, :3], turn]), np.hstack([d1[:, :3], spin]), np.hstack([d2[:, :3], spun])


@needs_compiler
def test_poses_ask_for_the_joints_and_torques_that_stand_there(folder: Path, answer: Any, controller: Any) -> None:
    given = states(40, seed=1)
    wanted, held = by_command(folder, answer, given, 0.0), Held(period_s=1.0)
    held.joints = SIX(*(given[0, 0] + 3.0))
    for n, motion in enumerate(zip(*along(arm(), given), strict=True)):
        code, joints, torque = told(controller.deltacal_feedforward, held, *motion)
        assert code == 0
        assert joints == pytest.approx(given[0, n], abs=1e-8)
        assert torque == pytest.approx(wanted[n], abs=1e-6 * np.abs(wanted).max())


@needs_compiler
@pytest.mark.parametrize(
    ("change", "expected"),
    [
        ({0: 5000.0}, UNREACHABLE),
        ({1: float("nan")}, NOT_A_NUMBER),
        ({3: float("inf")}, NOT_A_NUMBER),
        ({0: 30.0}, JUMPED),
    ],
)
def test_what_cannot_be_is_answered_and_the_last_output_held(
    controller: Any, change: dict[int, float], expected: int
) -> None:
    given = states(1)[:, :1]
    pose, zero, held = along(arm(), given)[0][0], np.zeros(6), Held(period_s=0.001)
    held.joints = SIX(*given[0, 0])
    assert told(controller.deltacal_feedforward, held, pose, zero, zero)[0] == 0
    before, moved = bytes(held), pose.copy()
    for axis, by in change.items():
        moved[axis] += by
    assert told(controller.deltacal_feedforward, held, moved, zero, zero)[0] == expected
    assert bytes(held) == before
    assert told(controller.deltacal_feedforward, held, pose, zero, zero)[0] == 0
    held.begun = 0
    if expected == JUMPED:
        assert told(controller.deltacal_feedforward, held, moved, zero, zero)[0] == 0


@pytest.mark.walk
@needs_compiler
def test_a_stretched_wrist_is_singular_and_a_joint_beyond_its_limits_out_of_reach(
    folder: Path, controller: Any
) -> None:
    straight = np.array([10.0, -60.0, 80.0, -30.0, 0.0, 20.0])
    errorless = arm(errors={})
    own = compiled(folder, answered(folder, errorless), "errorless")
    pose = along(errorless, np.array([[straight], [0 * straight], [0 * straight]]))[0][0]
    held = Held(period_s=1.0, joints=SIX(*straight))
    before = bytes(held)
    assert told(own.deltacal_feedforward, held, pose, np.ones(6), np.zeros(6))[0] == SINGULAR
    assert bytes(held) == before
    beyond = [175.0, *straight[1:]]
    assert told(controller.deltacal_feedforward_joints, held, beyond, 0 * straight, 0 * straight)[0] == UNREACHABLE
    assert bytes(held) == before


@pytest.mark.walk
@needs_compiler
def test_a_torque_is_held_at_its_limit_and_friction_does_not_chatter(folder: Path) -> None:
    robot = arm(limits={"tau2_Nm": [-5.0, 5.0]})
    own, given = compiled(folder, answered(folder, robot), "limited"), states(1)[:, 0]
    held = Held(period_s=1.0)
    code, _, torque = told(own.deltacal_feedforward_joints, held, given[0], given[1], given[2])
    assert code == LIMITED
    assert abs(torque[1]) == 5.0
    near = [told(own.deltacal_feedforward_joints, held, given[0], [s] * 6, [0] * 6)[2] for s in (1e-3, -1e-3)]
    assert np.abs(near[0] - near[1])[[0, 2, 3, 4, 5]].max() < 2e-3 * 2 * 5.5 / (REST / DEG)


@pytest.mark.walk
@needs_compiler
def test_a_lift_has_no_pose_and_forces_on_its_column(folder: Path) -> None:
    """Four joints, one of which slides: joints in, no pose."""
    robot = robot_from_dict({"robot": {"name": "lift", "mechanism": "serial"}, "joint": [dict(link) for link in LIFT]})
    made = answered(folder, robot)
    library, given = compiled(folder, made, "lift"), states(20, 4)
    assert not hasattr(library, "deltacal_feedforward")
    wanted = by_command(folder, made, given, 0.7, ("mm", "deg", "deg", "deg"))
    four = ctypes.c_double * 4

    class State(ctypes.Structure):
        _fields_ = (("joints", four), ("torque", four), ("period_s", ctypes.c_double), ("begun", ctypes.c_int))

    held = State(period_s=1.0)
    for n in range(given.shape[1]):
        code, _, torque = told(library.deltacal_feedforward_joints, held, *given[:, n], payload=0.7)
        assert code == 0
        assert torque == pytest.approx(wanted[n], abs=1e-9 * np.abs(wanted).max())


def test_an_arm_is_commanded_along_poses(folder: Path, answer: Any) -> None:
    """Tool points with rotation vectors, one movement that turns back: joints that stand there, row after row."""
    given = states(40, seed=1)
    poses = along(arm(), given)[0]
    head = "time_s,x_mm,y_mm,z_mm,rx_deg,ry_deg,rz_deg"
    rows = np.column_stack([np.linspace(0.0, 2.0, 40), poses]).tolist()
    (folder / "poses.csv").write_text("\n".join([head, *(",".join(map(repr, row)) for row in rows)]))
    (folder / "poses.toml").write_text('[measurement]\nkind = "torque"\n')
    q = np.degrees(dc.feed_forward(answer.to_dict(), folder / "poses.csv").given.joints)
    assert along(arm(), np.array([q, 0 * q, 0 * q]))[0] == pytest.approx(poses, abs=1e-6)
    assert np.abs(np.diff(q, axis=0)).max() == pytest.approx(np.abs(np.diff(given[0], axis=0)).max(), rel=0.1)
