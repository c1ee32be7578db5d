"""Commands along a trajectory: the torque that was identified, ramped where friction is not known."""

from __future__ import annotations

import ctypes
import dataclasses
import subprocess
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import UsageError
from deltacal_gen.files.robot import Robot, kept_robot, robot_to_toml
from deltacal_gen.machine.dynamics import dynamics_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.rotation import to_vector
from deltacal_gen.motion.feedforward import FeedForward
from deltacal_gen.results.motion import JointModel
from deltacal_gen.use.exporters import exporter_of
from tests.support.compiled_c import COMPILER, JUMPED, LIMITED, NOT_A_NUMBER, STRICT, needs_compiler
from tests.support.every_effect import machines
from tests.support.machines_with_loops import machine
from tests.support.machines_with_loops import states as states_of
from tests.support.motion_recordings import MOTION, PLANNED

COULOMB, VISCOUS = 0.4, 0.004  # Nm, Nm s/deg
TRUTH = f"""
[[effects]]
name = "coulomb_friction"
coulomb = {COULOMB}
[[effects]]
name = "viscous_friction"
viscous = {VISCOUS}
"""


@pytest.fixture(scope="module")
def known(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of a Delta with errors, and the diagnosis of its friction."""
    folder = tmp_path_factory.mktemp("feedforward")
    robot = dataclasses.replace(machines()[0], joint_sign=np.array([1.0, -1.0, 1.0]))
    robot = dataclasses.replace(robot, limits={"tau1_Nm": (-1.0, 1.0)})
    (folder / "robot.toml").write_text(robot_to_toml(robot))
    (folder / "truth.toml").write_text(TRUTH)
    t, rng, rows = np.arange(0, 8, 0.01), np.random.default_rng(2), ["run,time_s,q1_deg,q2_deg,q3_deg"]
    for run in (1, 2, 3):
        q = np.zeros((len(t), 3))
        for k in range(1, 6):
            q += rng.uniform(2, 9, 3) / k * np.sin(2 * np.pi * 0.3 * k * t[:, None] + rng.uniform(0, 6, 3))
        q = (q - [8.0, 8.0, 8.0]) * robot.joint_sign
        rows += [f"{run},{time:.2f},{a:.9f},{b:.9f},{c:.9f}" for time, (a, b, c) in zip(t, q, strict=True)]
    (folder / "planned.csv").write_text("\n".join(rows))
    (folder / "planned.toml").write_text(MOTION)
    recording = folder / "recording.csv"
    dc.simulate(
        folder / "robot.toml", folder / "planned.csv", output=recording, truth=folder / "truth.toml", noise=0.01
    )
    dc.diagnose(folder / "robot.toml", recording, output=folder / "diagnosis.json")
    return folder


def along(
    folder: Path, states: np.ndarray, name: str = "states", every: float = 0.01, known: Any = None
) -> FeedForward:
    """Return commands at states (3, N, 3) as they are [deg, s], by the folder's diagnosis or another."""
    head = [f"{q}{i}{unit}" for q, unit in (("q", "_deg"), ("qd", "_deg_s"), ("qdd", "_deg_s2")) for i in (1, 2, 3)]
    table = np.column_stack([every * np.arange(states.shape[1]), *(s for s in states)])
    text = [",".join(["time_s", *head]), *(",".join(f"{v!r}" for v in row) for row in table.tolist())]
    (folder / f"{name}.csv").write_text("\n".join(text))
    (folder / f"{name}.toml").write_text(PLANNED)
    return dc.feed_forward(known or folder / "diagnosis.json", folder / f"{name}.csv")


def at_speeds(speeds: np.ndarray) -> np.ndarray:
    """Return states at one pose and some speeds of joint 1."""
    states = np.zeros((3, len(speeds), 3))
    states[0] = [-8.0, 8.0, -8.0]
    states[1, :, 0] = speeds
    return states


def test_in_motion_it_is_what_is_predicted(known: Path) -> None:
    found = dc.feed_forward(known / "diagnosis.json", known / "planned.csv")
    predicted: Any = dc.predict(known / "diagnosis.json", known / "planned.csv")
    moving = np.isfinite(predicted.readings)
    assert moving.mean() > 0.8
    assert found.torque[moving] == pytest.approx(predicted.readings[moving], abs=1e-9)
    assert np.isfinite(found.torque).all()


def test_near_rest_friction_goes_straight_from_side_to_side(known: Path) -> None:
    edge = float(np.degrees(dc.read_answer(known / "diagnosis.json").joints[0].at_rest_below))
    speeds = np.array([-edge, -edge / 2, 0.0, edge / 2, edge])
    found = along(known, at_speeds(speeds))
    steps = np.diff(found.torque[:, 0])
    assert steps == pytest.approx(np.full(4, steps.mean()), rel=1e-4)  # but what turns pulls outwards
    assert 4 * steps.mean() == pytest.approx(2 * COULOMB + 2 * VISCOUS * edge, rel=0.05)
    assert found.ramped.tolist() == [3, 5, 5]


def test_a_joint_that_turns_back_meets_no_jump(known: Path) -> None:
    """No two speeds a hundredth of the ramp apart ask for torques that differ by more than their part of it."""
    edge = float(np.degrees(dc.read_answer(known / "diagnosis.json").joints[0].at_rest_below))
    torque = along(known, at_speeds(np.linspace(-3 * edge, 3 * edge, 601))).torque[:, 0]
    assert np.abs(np.diff(torque)).max() < 1.1 * (2 * COULOMB + 2 * VISCOUS * edge) / 200


def test_targets_are_brought_to_joints_by_the_geometry_of_the_result(known: Path, tmp_path: Path) -> None:
    t = np.arange(0, 1, 0.01)
    points = np.column_stack([100 * t, -50 * t**2, -880 + 20 * np.sin(t)])
    rows = [",".join(f"{v!r}" for v in (time, *p)) for time, p in zip(t.tolist(), points.tolist(), strict=True)]
    (tmp_path / "line.csv").write_text("\n".join(["time_s,x_mm,y_mm,z_mm", *rows]))
    (tmp_path / "line.toml").write_text(MOTION)
    found = dc.feed_forward(known / "diagnosis.json", tmp_path / "line.csv", output=tmp_path / "commands.csv")
    robot = dc.read_robot(known / "robot.toml")
    mechanism = mechanism_of(robot)
    assert robot.errors
    x = mechanism.positions(found.given.joints * robot.joint_sign, robot.tool, mechanism.rows(robot))
    assert x == pytest.approx(points, abs=1e-6)
    head = (tmp_path / "commands.csv").read_text().partition("\n")[0].split(",")
    assert head == [
        "time_s",
        *(f"q{i}_deg" for i in (1, 2, 3)),
        *(f"qd{i}_deg_s" for i in (1, 2, 3)),
        *(f"qdd{i}_deg_s2" for i in (1, 2, 3)),
        *(f"tau{i}_Nm" for i in (1, 2, 3)),
    ]


def test_joints_are_those_that_were_asked_for(known: Path, tmp_path: Path) -> None:
    """A profile whose acceleration jumps, and a point of its own: a curve that is smooth goes by 0.06 mm and 20 mm."""
    t, ramp = np.arange(0, 0.5, 0.004), 0.08
    way = np.where(t < ramp, 5000 * t**2, 800 * (t - ramp / 2))
    way = np.where(t > 0.25, 200 - 5000 * np.clip(0.33 - t, 0, None) ** 2, way)
    points = np.column_stack([way - 100, 0 * t, 0 * t - 870])
    points[60, 2] += 20
    robot = dc.read_robot(known / "robot.toml")
    asked = np.degrees(dc.Compensator(robot).joints(points))
    told: list[str] = []
    found = targets_along(known, tmp_path, t, points, told)
    assert found.joints_in_files == pytest.approx(asked, abs=1e-9)
    table = np.genfromtxt(tmp_path / "commands.csv", delimiter=",", names=True)
    assert table["q3_deg"] == pytest.approx(asked[:, 2], abs=1e-9)
    assert [words for words in told if "which leaves the joints where they turn sharply" in words]
    told.clear()
    smooth = np.column_stack([60 * np.sin(4 * t), 0 * t, 0 * t - 870])
    targets_along(known, tmp_path, t, smooth, told)
    assert not [words for words in told if "smooth curve" in words]


def test_rows_that_are_left_out_or_assumed_are_told_and_no_mass_is_negative(known: Path, tmp_path: Path) -> None:
    t, told = np.arange(0, 0.5, 0.004), list[str]()
    points = np.column_stack([60 * np.sin(4 * t), 0 * t, 0 * t - 870])
    twice = np.insert(t, 50, t[50])
    found = targets_along(known, tmp_path, twice, np.insert(points, 50, points[50], axis=0), told)
    assert len(found.torque) == len(t)
    assert [
        words
        for words in told
        if words.endswith("line.csv:53: the time of the row before once more; the row is left out")
    ]
    targets_along(known, tmp_path, t, points, told, payload=["0.5", *[""] * (len(t) - 1)])
    assert "payload_kg blank in 124 of 125 rows: no payload is assumed" in told
    with pytest.raises(dc.InputError, match=r"line 3, column 'payload_kg': a mass cannot be negative"):
        targets_along(known, tmp_path, t, points, told, payload=["0.5", *["-1"] * (len(t) - 1)])
    targets_along(known, tmp_path, t, points, told, approach1=["0", "1", *["-1"] * (len(t) - 2)])  # 0: not known which
    with pytest.raises(dc.InputError, match=r"line 2, column 'approach1'"):
        targets_along(known, tmp_path, t, points, told, approach1=["0.5"] * len(t))


def targets_along(
    known: Path,
    folder: Path,
    t: np.ndarray,
    points: np.ndarray,
    told: list[str],
    payload: list[str] | None = None,
    **others: list[str],
) -> FeedForward:
    """Return commands along targets (N, 3) [mm]; `others` are columns by their names."""
    rows = [",".join(f"{v!r}" for v in (time, *p)) for time, p in zip(t.tolist(), points.tolist(), strict=True)]
    rows = ["time_s,x_mm,y_mm,z_mm", *rows]
    for name, cells in (others if payload is None else {"payload_kg": payload, **others}).items():
        rows = [f"{row},{cell}" for row, cell in zip(rows, [name, *cells], strict=True)]
    (folder / "line.csv").write_text("\n".join(rows))
    (folder / "line.toml").write_text(MOTION)
    return dc.feed_forward(
        known / "diagnosis.json", folder / "line.csv", output=folder / "commands.csv", tell=told.append
    )


def test_limits_of_the_robot_file_are_counted(known: Path) -> None:
    told: list[str] = []
    found = dc.feed_forward(known / "diagnosis.json", known / "planned.csv", tell=told.append)
    count = int((np.abs(found.torque[:, 0]) > 1.0).sum())
    assert count > 0
    assert found.beyond == {"tau1_Nm": count}
    assert f"{count} of {len(found.torque)} samples lie beyond [limits] tau1_Nm" in told


def test_the_command_writes_what_the_function_does(known: Path, tmp_path: Path, run: Callable[..., Any]) -> None:
    out = tmp_path / "commands.csv"
    code, shown, _ = run("compensate", known / "diagnosis.json", known / "planned.csv", "--trajectory", "-o", out)
    assert code == 0
    assert "samples with joints and torques" in " ".join(shown.split())
    found = dc.feed_forward(known / "diagnosis.json", known / "planned.csv")
    table = np.genfromtxt(out, delimiter=",", names=True)
    assert table["tau2_Nm"] == pytest.approx(found.torque[:, 1], abs=1e-12)
    assert run("compensate", known / "diagnosis.json", "--trajectory")[0] == 2


def test_a_machine_at_rest_has_no_torques(known: Path) -> None:
    with pytest.raises(UsageError, match="a result of a recording in motion"):
        dc.feed_forward(_result(known), known / "planned.csv")


def _result(folder: Path) -> Path:
    """Return an identified machine at rest."""
    rows = ["x_mm,y_mm,z_mm", *(f"{100 * np.cos(k)},{100 * np.sin(k)},{-800 - 10 * k}" for k in range(12))]
    (folder / "poses.csv").write_text("\n".join(rows))
    dc.simulate(folder / "robot.toml", folder / "poses.csv", output=folder / "rest.csv", noise=0.01)
    dc.identify(folder / "robot.toml", folder / "rest.csv", model="delta/3", output=folder / "rest.json")
    return folder / "rest.json"


# ------------------------------------------------------------------------------------------------ on a controller

THREE = ctypes.c_double * 3


class Held(ctypes.Structure):
    """What is kept between calls, as the head of the file has it."""

    _fields_ = (("joints", THREE), ("torque", THREE), ("period_s", ctypes.c_double), ("begun", ctypes.c_int))


@pytest.fixture(scope="module")
def controller(known: Path) -> Any:
    """Return the exported file as a library, without limits of torque."""
    answer = dc.read_answer(known / "diagnosis.json").to_dict()
    answer["robot"].pop("limits")
    return compiled(known, answer, "command")


def compiled(known: Path, answer: Any, name: str) -> Any:
    source, library = known / f"{name}.c", known / f"{name}.so"
    dc.export_compensator(answer, output=source, export="c")
    text = source.read_text()
    assert "malloc" not in text
    assert "while (" not in text
    assert COMPILER is not None
    subprocess.run([COMPILER, *STRICT, str(source), "-o", str(library), "-lm"], check=True)
    function = ctypes.CDLL(str(library)).deltacal_feedforward
    function.argtypes = [ctypes.POINTER(Held), THREE, THREE, THREE, ctypes.c_double, ctypes.c_double]
    return function


def told(
    controller: Any, held: Held, p: Any, v: Any = (0, 0, 0), a: Any = (0, 0, 0), payload: float = 0.0
) -> tuple[int, np.ndarray, np.ndarray]:
    code = controller(held, THREE(*p), THREE(*v), THREE(*a), payload, 20.0)
    return code, np.array(held.joints), np.array(held.torque)


@needs_compiler
@pytest.mark.parametrize("payload", [0.0, 0.8])
def test_the_controller_says_what_the_command_does(known: Path, controller: Any, payload: float) -> None:
    """Along a line: joints and torques by the C file, and by Python from joints and their central differences."""
    points, states = on_a_line(known, np.linspace(0.0, 1.0, 40))
    wanted = with_payload(known, states, payload)
    held = Held(period_s=1.0)
    for n, (place, speed, force) in enumerate(points):
        code, joints, torque = told(controller, held, place, speed, force, payload)
        assert code == 0
        assert joints == pytest.approx(states[0, n], abs=1e-9)
        assert torque == pytest.approx(wanted[n], abs=1e-6)


def on_a_line(known: Path, t: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return position, velocity and acceleration (N, 3, 3) of a movement, and its joints' by differences (3, N, 3)."""
    line = lambda t: np.column_stack([150 * np.sin(3 * t), 100 * t**2, -870 + 40 * np.cos(5 * t)])  # noqa: E731
    speed = np.column_stack([450 * np.cos(3 * t), 200 * t, -200 * np.sin(5 * t)])
    force = np.column_stack([-1350 * np.sin(3 * t), 200 + 0 * t, -1000 * np.cos(5 * t)])
    compensator, h = dc.Compensator(dc.read_robot(known / "robot.toml")), 1e-3
    at = {k: np.degrees(compensator.joints(line(t + k * h))) for k in range(-4, 5)}
    first, second = (4 / 5, -1 / 5, 4 / 105, -1 / 280), (8 / 5, -1 / 5, 8 / 315, -1 / 560)
    qd = sum(c * (at[k] - at[-k]) for k, c in enumerate(first, start=1)) / h
    qdd = (sum(c * (at[k] + at[-k]) for k, c in enumerate(second, start=1)) - 205 / 72 * at[0]) / h**2
    return np.stack([line(t), speed, force], axis=1), np.array([at[0], qd, qdd])


@needs_compiler
def test_friction_that_builds_up_over_a_way_is_followed(known: Path) -> None:
    """From set point to set point; a set point that is refused leaves the past alone, a new begin forgets it."""
    answer = dc.read_answer(known / "diagnosis.json").to_dict()
    answer["robot"].pop("limits")
    built_up = {"effect": "presliding_friction", "constants": [np.radians(1.5)], "values": [2e4]}  # 524 N mm
    answer["joints"][1]["terms"].append(built_up)
    function, every = compiled(known, answer, "past"), 1e-3
    points, states = on_a_line(known, every * np.arange(1100))
    assert (np.diff(np.sign(states[1, :, 1])) != 0).any()  # joint 2 turns back
    wanted = along(known, states, "past", every, answer).torque
    rigid = along(known, states, "rigid", every).torque
    assert np.abs(wanted - rigid)[:, 1].max() > 0.5

    class Remembering(Held):
        _fields_ = (("past", ctypes.c_double * 2),)

    held = Remembering(period_s=every)
    function.argtypes = [ctypes.POINTER(Remembering), *function.argtypes[1:]]
    for n, (place, speed, force) in enumerate(points):
        assert told(function, held, (np.nan, 0, 0))[0] == NOT_A_NUMBER
        code, _, torque = told(function, held, place, speed, force)
        assert code == 0
        assert torque == pytest.approx(wanted[n], abs=1e-5)
    held.begun = 0
    assert told(function, held, *points[0])[2] == pytest.approx(wanted[0], abs=1e-5)


def with_payload(known: Path, states: np.ndarray, payload: float) -> np.ndarray:
    along(known, states, "line")
    table = (known / "line.csv").read_text().splitlines()
    rows = [f"{table[0]},payload_kg", *(f"{row},{payload}" for row in table[1:])]
    (known / "line.csv").write_text("\n".join(rows))
    return dc.feed_forward(known / "diagnosis.json", known / "line.csv").torque


@needs_compiler
@pytest.mark.parametrize(
    ("p", "v", "expected"),
    [
        ((5000.0, 0.0, -850.0), (0.0, 0.0, 0.0), 1),
        ((float("nan"), 0.0, -850.0), (0.0, 0.0, 0.0), NOT_A_NUMBER),
        ((0.0, 0.0, -850.0), (0.0, float("inf"), 0.0), NOT_A_NUMBER),
        ((250.0, 0.0, -850.0), (0.0, 0.0, 0.0), JUMPED),
    ],
)
def test_what_cannot_be_is_answered_and_the_last_output_held(
    controller: Any, p: tuple[float, ...], v: tuple[float, ...], expected: int
) -> None:
    held = Held(period_s=0.001)
    assert told(controller, held, (0.0, 0.0, -850.0))[0] == 0
    before = bytes(held)
    assert told(controller, held, p, v)[0] == expected
    assert bytes(held) == before
    assert told(controller, held, (0.01, 0.0, -850.0))[0] == 0


@needs_compiler
def test_after_a_stop_the_next_set_point_may_lie_anywhere(controller: Any) -> None:
    held = Held(period_s=0.001)
    assert told(controller, held, (0.0, 0.0, -850.0))[0] == 0
    held.begun = 0
    assert told(controller, held, (250.0, 0.0, -850.0))[0] == 0


@needs_compiler
def test_a_torque_is_held_at_its_limit(known: Path) -> None:
    """The robot file lets drive 1 give 1 Nm."""
    controller = compiled(known, dc.read_answer(known / "diagnosis.json").to_dict(), "limited")
    code, _, torque = told(controller, Held(period_s=1.0), (0.0, 0.0, -850.0), (0, 0, 0), (0, 0, 20000.0))
    assert code == LIMITED
    assert abs(torque[0]) == 1.0
    assert abs(torque[1]) > 1.0


@needs_compiler
def test_a_controller_that_trembles_does_not_chatter(known: Path, controller: Any) -> None:
    """Velocities of either sign, a thousandth of the ramp, change the torque by about that part of the friction."""
    edge = float(np.degrees(dc.read_answer(known / "diagnosis.json").joints[0].at_rest_below))
    torques = [told(controller, Held(period_s=1.0), (0, 0, -850), (0, 0, side * 1e-3 * edge))[2] for side in (1, -1)]
    assert np.abs(torques[0] - torques[1]).max() < 0.01 * COULOMB


def test_a_machine_in_motion_has_no_table(known: Path) -> None:
    with pytest.raises(UsageError, match="no export 'table' of a machine in motion"):
        dc.export_compensator(known / "diagnosis.json", output=known / "x.csv", export="table")


def rigid_model(known: Path, robot: Robot) -> Any:
    """Return a diagnosis of a machine whose bodies are as its file says, without friction."""
    own, mechanism = dynamics_of(robot), mechanism_of(robot)
    joints = tuple(
        JointModel(
            joint=i + 1,
            columns=tuple(range(len(own.names))),
            coefficients=tuple(own.stated().tolist()),
            terms=(),
            at_rest_below=0.0,
        )
        for i in range(mechanism.limbs)
    )
    unit = "N" if mechanism.joint_unit == "mm" else "Nm"
    columns = tuple(f"tau{i + 1}_{unit}" for i in range(mechanism.limbs))
    answer: Any = dc.read_answer(known / "diagnosis.json")
    return answer.replace(robot=kept_robot(robot), joints=joints, columns=columns, inertial=own.names, known=None)


def turning_course(robot: Robot, folder: Path) -> tuple[np.ndarray, Path]:
    """Write a movement of a machine that turns on command as targets; return joints (N, n_q) as counted, the file."""
    mechanism = mechanism_of(robot)
    t, q = np.arange(0, 1, 0.01)[:, None], states_of(robot, 1)[0]
    size = 0.1 if mechanism.joint_unit == "rad" else 5.0
    q = q + size * np.sin(3 * t + np.arange(mechanism.limbs))
    x, _ = mechanism.forward(q, robot.tool, mechanism.rows(robot))
    turns = np.degrees(to_vector(x[:, 3:].reshape(-1, 3, 3)))
    values = {f"{axis}_mm": x[:, "xyz".index(axis)] for axis in mechanism.axes}
    values |= {f"r{axis}_deg": turns[:, "xyz".index(axis)] for axis in mechanism.turns}
    head, rows = ["time_s", *values], np.column_stack([t, *values.values()])
    path = folder / "course.csv"
    path.write_text("\n".join([",".join(head), *(",".join(map(repr, row)) for row in rows.tolist())]))
    path.with_suffix(".toml").write_text(MOTION)
    return q * robot.joint_sign, path


def test_turns_on_command_are_commanded_along_a_trajectory(known: Path, tmp_path: Path) -> None:
    robot = machine("hexapod")
    assert robot.errors
    answer = rigid_model(known, robot).to_dict()
    joints, path = turning_course(robot, tmp_path)
    assert dc.feed_forward(answer, path).given.joints == pytest.approx(joints, abs=1e-6)


def test_a_turn_that_a_machine_does_not_command_is_refused(known: Path, tmp_path: Path) -> None:
    (tmp_path / "turn.csv").write_text("time_s,x_mm,y_mm,z_mm,rz_deg\n0,0,0,-850,1\n0.01,0,0,-850,1\n")
    with pytest.raises(dc.InputError, match=r"rz_deg.*does not turn on command"):
        dc.feed_forward(known / "diagnosis.json", tmp_path / "turn.csv")


@needs_compiler
@pytest.mark.parametrize("name", ["diamond", "hexapod", "linear_delta", "robotennis"])
def test_every_machine_with_limbs_stands_in_c_as_in_python(known: Path, name: str) -> None:
    """Rigid machines with errors: joints' rates by the velocity Jacobian, torques by the compiled kernels."""
    robot = machine(name)
    own, mechanism, answer = dynamics_of(robot), mechanism_of(robot), rigid_model(known, robot)
    n, unit = mechanism.limbs, "N" if mechanism.joint_unit == "mm" else "Nm"
    source, library = known / f"{name}.c", known / f"{name}.so"
    exporter_of("c").in_motion(answer, source)
    assert COMPILER is not None
    subprocess.run([COMPILER, *STRICT, str(source), "-o", str(library), "-lm"], check=True)
    function = ctypes.CDLL(str(library)).deltacal_feedforward
    numbers = ctypes.c_double * n

    class State(ctypes.Structure):
        _fields_ = (("joints", numbers), ("torque", numbers), ("period_s", ctypes.c_double), ("begun", ctypes.c_int))

    motion, rows, h = states_of(robot, 6), mechanism.rows(robot), 1e-4
    x, _ = mechanism.forward(motion[0], robot.tool, rows)

    def speeds(k: int) -> np.ndarray:
        """Shifts and turns (N, n) of the platform [mm/s, deg/s] some steps of time later."""
        q, rates = motion[0] + k * h * motion[1] + (k * h) ** 2 / 2 * motion[2], motion[1] + k * h * motion[2]
        at, _ = mechanism.forward(q, robot.tool, rows, near=x)
        V = mechanism.sensitivity(at, q, np.tile(robot.tool, (6, 1)), rows).joints[:, :n]
        return np.einsum("nij,nj->ni", V, rates) * np.where(np.arange(n) < 3, 1.0, 180 / np.pi)

    speed, target = speeds(0), x[:, :n]
    bent = (8 * (speeds(1) - speeds(-1)) - (speeds(2) - speeds(-2))) / (12 * h)
    if mechanism.turning:
        target = np.hstack([x[:, :3], np.degrees(to_vector(x[:, 3:].reshape(-1, 3, 3)))])
    wanted = own.torque(motion, own.stated()) / (1000.0 if unit == "Nm" else 1.0)
    function.argtypes = [ctypes.POINTER(State), numbers, numbers, numbers, ctypes.c_double, ctypes.c_double]
    for k in range(6):
        held = State(period_s=1.0)
        assert function(held, numbers(*target[k]), numbers(*speed[k]), numbers(*bent[k]), 0.0, 20.0) == 0
        assert np.array(held.torque) == pytest.approx(wanted[k] * robot.joint_sign, abs=1e-7 * np.abs(wanted).max())
