"""A second encoder on the joints: no drawing needed, zeros found, play and eccentricity seen, whole runs held out."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from deltacal_gen.app.cli.terminal import Terminal
from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import read_robot, robot_from_dict, robot_to_toml
from deltacal_gen.files.writing import write_recording
from deltacal_gen.identification.folds import folds
from deltacal_gen.identification.identification import identify
from deltacal_gen.instrument.kinds import readings
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.values import Measurement, Recording, Robot, poses_of
from deltacal_gen.physics.motion import approach, motion_of
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, blank
from deltacal_gen.results.document import decimals
from deltacal_gen.units import DEG
from deltacal_gen.use import prediction, validation
from deltacal_gen.use.comparison import compare
from derive.review import checks
from derive.review.subjects import example
from tests.benchmarks.truth import BEHIND, behind
from tests.support.commands import Run
from tests.support.second_encoder import DELTA, EACH, NOISE, RUNS, UNDRAWN, motion, read

EXAMPLES = Path(__file__).parents[2] / "src/deltacal_gen/examples"


@pytest.fixture(scope="module")
def robot() -> Robot:
    return robot_from_dict(UNDRAWN)


def play(width: float) -> Term:
    """Return backlash of joint 2 [deg]."""
    term = blank("backlash", (2,))
    return term.with_values(np.array([width * DEG]))


def test_zeros_are_found_without_a_drawing(robot: Robot) -> None:
    made = read(robot)
    result = identify(robot, made).answer()
    assert result.model == "delta/0"
    zeros = {p.name: p for p in result.parameters if p.name.startswith("enc_zero")}
    assert list(zeros) == ["enc_zero_1", "enc_zero_2", "enc_zero_3"]
    # the encoder counts as the controller does, its zero as the geometry: enc = sign (theta + zero)
    truth = (robot.joint_sign * (made.measured - made.joints)).mean(axis=0) / DEG
    for p, zero in zip(zeros.values(), truth, strict=True):
        assert (p.status, p.unit) == ("identified", "deg")
        assert p.std is not None
        assert p.value == pytest.approx(zero, abs=4 * p.std)
    assert result["train_rms_deg"] == pytest.approx(NOISE, rel=0.1)
    assert result["sigma_deg"] == pytest.approx(NOISE)
    assert result["train_rms_mm"] == pytest.approx(result["train_rms_deg"] * 100 * DEG)


def test_play_is_named_from_the_way_the_joints_came(robot: Robot) -> None:
    found = diagnose(robot, read(robot, (play(0.3),))).answer()
    assert found.verdict == "missing_physics"
    (effect,) = found.effects
    assert (effect.name, effect.limbs) == ("backlash", (2,))
    (width,) = effect.parameters
    assert width.std is not None
    assert width.value == pytest.approx(0.3, abs=4 * width.std)
    assert found["final"]["heldout_rms_deg"] == pytest.approx(NOISE, rel=0.1)
    assert found["parameters"][1]["name"] == "enc_zero_2"
    fresh = dataclasses.replace(read(robot, (play(0.3),), seed=2), measured=np.full((RUNS * EACH, 3), np.nan))
    told = prediction.predict(found, fresh).measured - read(robot, (play(0.3),)).measured
    assert np.sqrt(np.mean(told**2)) == pytest.approx(NOISE * DEG, rel=0.15)


def test_nothing_is_named_where_nothing_is_missing(robot: Robot) -> None:
    found = diagnose(robot, read(robot))
    assert found.verdict == "adequate"
    assert "robot file has it" not in found.answer().summary  # of a machine that has nothing to correct


def test_the_screen_has_the_unit_of_the_readings(
    robot: Robot, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    found = identify(robot, read(robot)).answer()
    Terminal().show(found)
    assert "robot file has it" not in capsys.readouterr().out  # as above
    assert found.heldout_rms_mm is not None
    Terminal().show(found.replace(rank=1, degrees_of_freedom=1.0, before_rms_mm=found.heldout_rms_mm / 2))
    shown = " ".join(capsys.readouterr().out.split())
    half = found.heldout_rms_mm / 2 / (100 * DEG)
    assert f"leaves no more, {decimals(half)} deg, than" in shown
    assert f"leaves a residual of {found['train_rms_deg']:.3g} deg" in shown


def test_whole_runs_are_held_out(robot: Robot) -> None:
    made = read(robot)
    for train, test in folds(readings(made), made):
        rows = readings(made).rows[:, 0]
        run = made.channels["run"][rows]
        assert not set(run[train]) & set(run[test])


def test_joints_without_an_encoder_have_no_column(robot: Robot, tmp_path: Path) -> None:
    write_recording(read(robot), tmp_path / "whole.csv")
    header, *rows = (tmp_path / "whole.csv").read_text().splitlines()
    keep = [k for k, name in enumerate(header.split(",")) if name != "enc3_deg"]
    text = "\n".join(",".join(line.split(",")[k] for k in keep) for line in (header, *rows))
    (tmp_path / "part.csv").write_text(text + "\n")
    made = read_recording(tmp_path / "part.csv", DELTA)
    assert made.kind == "encoder"
    assert np.isnan(made.measured[:, 2]).all()
    result = identify(robot, made).answer()
    assert result.readings.scalars == 2 * RUNS * EACH
    assert validation.validate(result, made)["rms_deg"] == pytest.approx(NOISE, rel=0.1)


def test_what_sees_the_platform_needs_the_drawing(robot: Robot) -> None:
    made = dataclasses.replace(
        motion(robot), kind="position", measurement=Measurement(), columns=("x_mm", "y_mm", "z_mm")
    )
    made = dataclasses.replace(made, measured=np.random.default_rng(1).standard_normal(made.joints.shape))
    with pytest.raises(InputError, match=r"no table \[geometry\], which readings of the kind 'position' need"):
        identify(robot, made)


def test_a_model_of_the_geometry_is_refused(robot: Robot) -> None:
    with pytest.raises(UsageError, match="see no source error of delta/42"):
        identify(robot, read(robot), "delta/42")


def test_a_robot_without_a_drawing_survives_its_file(robot: Robot, tmp_path: Path) -> None:
    assert not robot.drawn
    (tmp_path / "robot.toml").write_text(robot_to_toml(robot))
    assert "geometry" not in (tmp_path / "robot.toml").read_text()
    assert not read_robot(tmp_path / "robot.toml").drawn


def test_the_way_a_joint_came_turns_with_it_and_not_with_its_flutter() -> None:
    q = np.array([0.0, 0.0, 1.0, 2.0, 1.999, 2.0, 3.0, 2.5, 2.501, 1.0])
    assert approach(q, 0.01).tolist() == [0, 0, 1, 1, 1, 1, 1, -1, -1, -1]


def test_a_run_that_begins_where_the_last_one_ended_came_as_that_did(robot: Robot) -> None:
    made = motion(robot)
    joints, run = made.joints.copy(), made.channels["run"]
    joints[run == 1, 0] = joints[run == 0, 0][-1]  # joint 1 waits throughout the second run
    way = motion_of(dataclasses.replace(made, joints=joints))["approach1"]
    (came,) = np.unique(way[run == 1])
    assert came == way[run == 0][-1] != 0
    assert way[run == 0][0] == 0  # nobody knows


def test_samples_of_runs_are_of_one_pose_while_the_joints_stand(robot: Robot) -> None:
    made = motion(robot)
    joints = np.repeat([[0.1], [0.2], [0.1]], (3, 1, 2), axis=0) * np.ones(3)
    part = dataclasses.replace(made.subset(np.arange(6)), joints=joints)
    assert poses_of(part).tolist() == [0, 0, 0, 1, 2, 2]
    apart = dataclasses.replace(part, channels={"run": np.array([0.0, 0, 1, 1, 1, 1])})
    assert poses_of(apart).tolist() == [0, 0, 1, 2, 3, 3]
    at_rest = dataclasses.replace(part, channels={})
    assert poses_of(at_rest).tolist() == [0, 0, 0, 1, 0, 0]


def test_a_clock_that_begins_anew_with_a_run_tells_nothing_of_time(robot: Robot) -> None:
    made = read(robot, (play(0.3),))
    untested = {m.name: m.missing for m in diagnose(robot, made).answer().not_tested}
    assert untested["zero_drift"] == untested["warm_up"] == untested["zero_jump"]
    assert "begins anew with a run" in untested["zero_drift"]
    time, run = made.channels["time_s"], made.channels["run"]
    through = dataclasses.replace(made, channels=made.channels | {"time_s": time + 100 * run})
    assert "zero_drift" not in {m.name for m in diagnose(robot, through).answer().not_tested}


def test_speeds_are_made_without_delay_run_by_run(robot: Robot) -> None:
    made = motion(robot)
    columns = motion_of(made)
    time, run = made.channels["time_s"], made.channels["run"]

    def slope(values: Array) -> Array:
        return np.concatenate([np.gradient(values[run == r], time[run == r]) for r in range(RUNS)])

    speed = slope(made.joints[:, 0] / DEG)  # central differences of 50 ms, too small by a six-hundredth at 2 rad/s
    inside = np.concatenate([np.arange(EACH)[5:-5] + EACH * r for r in range(RUNS)])
    assert columns["qd1_deg_s"][inside] == pytest.approx(speed[inside], rel=0.01, abs=0.3)
    assert columns["qdd1_deg_s2"][inside] == pytest.approx(slope(speed)[inside], rel=0.02, abs=3.0)
    still = dataclasses.replace(made, channels=made.channels | {"time_s": np.zeros_like(time)})
    assert motion_of(still) == {}
    told = dataclasses.replace(made, channels=made.channels | {"approach1": np.ones(len(time))})
    assert "approach1" not in motion_of(told)


def swift(robot: Robot) -> Recording:
    """Return joints that go to places and stay there, at 60 deg/s for half a second, sampled at 10 Hz."""
    made, rng = motion(robot), np.random.default_rng(5)
    time = np.tile(0.1 * np.arange(EACH), RUNS)
    places = rng.uniform(-1.0, 1.0, (RUNS, 4, 3)).cumsum(axis=1) * 30.0
    moves = np.arange(1, 5)
    at = [np.interp(0.1 * np.arange(EACH), np.sort(np.r_[moves, moves + 0.5]), v) for run in places for v in _ends(run)]
    joints = np.reshape(at, (RUNS, 3, EACH)).swapaxes(1, 2).reshape(-1, 3) * DEG
    return dataclasses.replace(made, joints=joints, channels=made.channels | {"time_s": time})


def _ends(places: Array) -> list[Array]:
    """Return each joint's places (4, 3) at beginning and end of its moves, from 0."""
    return [np.repeat(np.r_[0.0, joint], 2)[1:-1] for joint in places.T]


def test_moves_of_few_samples_keep_their_speed(robot: Robot) -> None:
    """Splines would cut them, and a joint at rest would have a speed: a delay then passes for play."""
    made = swift(robot)
    speed = motion_of(made)["qd1_deg_s"]
    still = np.abs(np.diff(made.joints[:, 0])) < 1e-12
    assert np.abs(speed[1:-1][still[1:] & still[:-1]]).max() < 1e-9
    late = blank("latency", ())
    rng = np.random.default_rng(6)
    terms = (late.with_values(np.array([0.01])),)
    found = diagnose(robot, simulate(robot, made, noise_mm=100 * NOISE * DEG, rng=rng, terms=terms)).answer()
    assert [e.name for e in found.effects] == ["latency"]
    assert found.final.heldout_rms_mm == pytest.approx(100 * NOISE * DEG, rel=0.1)


def test_the_commands_speak_degrees(run: Run, robot: Robot, tmp_path: Path) -> None:
    (tmp_path / "robot.toml").write_text(robot_to_toml(robot))
    write_recording(read(robot), tmp_path / "recording.csv")
    files = tmp_path / "robot.toml", tmp_path / "recording.csv"
    code, out, _ = run("identify", *files, "-o", tmp_path / "result.json")
    assert code == 0
    assert "enc_zero_2" in out
    code, out, _ = run("validate", tmp_path / "result.json", files[1], "--json")
    assert json.loads(out)["unit"] == "deg"


def test_two_sessions_of_joints_without_a_drawing_are_compared(tmp_path: Path) -> None:
    robot = robot_from_dict(UNDRAWN)
    results = []
    for seed in (1, 2):
        blank = motion(robot, seed)
        made = simulate(robot, blank, {}, noise_mm=NOISE, rng=np.random.default_rng(seed))
        results.append(identify(robot, made).answer())
    assert compare(*results).summary
    assert compare(results[0], results[0]).changed == ()


@pytest.mark.parametrize("ask", [identify, diagnose])
def test_readings_that_are_of_other_rows_are_refused(ask: Any) -> None:
    robot, rng = robot_from_dict(UNDRAWN), np.random.default_rng(2)
    made = simulate(robot, motion(robot), {}, noise_mm=NOISE, rng=rng)
    still = made.subset(np.arange(0, made.n_rows, 6))
    still.channels.clear()
    shuffled = dataclasses.replace(still, measured=still.measured[rng.permutation(still.n_rows)])
    with pytest.raises(InputError, match="of the joints' way off"):
        ask(robot, shuffled)


def test_joints_read_at_one_pose_are_no_repeats() -> None:
    """A gear that is off by 0.4 % at every joint is no noise, though all three are read at each pose."""
    robot, rng = robot_from_dict(UNDRAWN), np.random.default_rng(2)
    still = simulate(robot, motion(robot), {}, noise=NOISE, rng=rng).subset(np.arange(0, RUNS * EACH, 6))
    still.channels.clear()
    found = diagnose(robot, dataclasses.replace(still, measured=still.measured * 1.004)).answer()
    assert found.noise.source == "declared"
    assert [(e.name, e.limbs) for e in found.effects] == [("joint_scale", (1, 2, 3))]


def test_joints_are_planned_from_both_sides(run: Run, tmp_path: Path) -> None:
    """Of a drawn machine within its workspace, of one without a drawing within its limits."""
    file, plan = tmp_path / "robot.toml", tmp_path / "plan.csv"
    limited = dict(UNDRAWN) | {"joints": {"limits_deg": [[-20, 60]] * 3}}
    for text in ((EXAMPLES / "delta/robot.toml").read_text(), robot_to_toml(robot_from_dict(limited))):
        file.write_text(text)
        code, said, why = run("plan", file, "--kind", "encoder", "-o", plan, "--positions", 24)
        assert code == 0, why
        assert "48 rows" in said
        rows = np.genfromtxt(plan, delimiter=",", names=True)
        q = np.column_stack([rows[f"q{i}_deg"] for i in (1, 2, 3)])
        sides = np.column_stack([rows[f"approach{i}"] for i in (1, 2, 3)])
        assert (q[::2] == q[1::2]).all()
        assert (sides[::2] == -sides[1::2]).all()
        assert np.abs(np.corrcoef(sides[::2].T) - np.eye(3)).max() < 0.5  # no joint passes for another
        assert np.ptp(q, axis=0).min() > 50
        assert run("simulate", file, plan, "-o", tmp_path / "read.csv", "--noise", 0.02)[0] == 0
        read = np.genfromtxt(tmp_path / "read.csv", delimiter=",", names=True)
        assert np.std(np.diff(read["enc2_deg"] - q[:, 1])) == pytest.approx(0.02 * np.sqrt(2), rel=0.4)
    file.write_text(robot_to_toml(robot_from_dict(UNDRAWN)))
    assert "how far the joints go" in run("plan", file, "--kind", "encoder")[2]
    assert "cycles are of one axis" in run("plan", file, "--kind", "encoder", "--cycles", 3)[2]


def stepped(seed: int) -> tuple[Recording, Array]:
    """Return runs of a pick and place at 10 Hz, which waits at home before and after, and its speeds [deg/s]."""
    rng, time, home, joints = np.random.default_rng(seed), 0.1 * np.arange(110), np.full(3, -15.0), list[Array]()
    for _ in range(8):
        at, places = [0.0, 3.0], [home, home]
        while at[-1] < 7.5:
            place, speed = rng.uniform(-30.0, 65.0, 3), rng.uniform(45.0, 85.0)
            at.append(at[-1] + max(float(np.abs(place - places[-1]).max()) / speed, 0.1))
            places.append(place)
        at, places = [*at, at[-1] + 1.0, 20.0], [*places, home, home]
        joints.append(np.column_stack([np.interp(time, at, own) for own in np.transpose(places)]))
    made, rows = motion(robot_from_dict(UNDRAWN)).subset(np.arange(8 * len(time)) % 10), 8 * len(time)
    made = dataclasses.replace(
        made,
        measurement=Measurement(kind="encoder"),
        joints=np.round(np.vstack(joints) / 0.1125) * 0.1125 * DEG,
        pose=np.arange(rows).astype(str),
        line=np.arange(rows) + 2,
        channels={"time_s": np.tile(time, 8), "run": np.repeat(np.arange(8.0), len(time))},
    )
    speeds = motion_of(made)
    return made, np.column_stack([speeds[f"qd{i}_deg_s"] for i in (1, 2, 3)])


@pytest.mark.thorough
@pytest.mark.parametrize("seed", [0, 3, 4])
def test_what_drags_while_it_moves_hides_no_delay_and_is_no_play(robot: Robot, seed: int) -> None:
    """Arms that lag by what hardly grows with their speed and come back where they stop: no effect is that.

    Of the rows at home those that only pass it were repeats of the waits there: play was named for it, or nothing.
    """
    made, speed = stepped(seed)
    late = blank("latency", ()).with_values(np.array([0.006]))
    turns = blank("transmission_eccentricity", (1, 2), (1.0,)).with_values(np.array([3.0, -1.5, -3.0, 0.5]) * DEG)
    rng = np.random.default_rng(seed + 100)
    read_ = simulate(robot, made, noise_mm=100 * NOISE * DEG, rng=rng, terms=(late, turns)).measured
    uneven = np.repeat(rng.uniform(0.7, 1.3, (8, 3)), len(speed) // 8, axis=0)
    dragged = read_ - 0.35 * DEG * np.tanh(speed / 8) * np.array([1.0, 0.8, 0.6]) * uneven
    count = 360 / 4096 * DEG
    found = diagnose(robot, dataclasses.replace(made, measured=np.round(dragged / count) * count)).answer()
    effects = {e.name: e for e in found.effects}
    assert effects.keys() == {"latency", "transmission_eccentricity"}
    assert effects["latency"].parameters[0].value == pytest.approx(0.006, rel=0.1)


@pytest.mark.parametrize(("name", "zeros"), [("delta", 3), ("complete_delta", 3), ("diamond", 2)])
def test_the_scale_of_truth_ranks_encoders(name: str, zeros: int) -> None:
    """Of a joint whose encoder's zero is known its own is seen, also where two errors together are it; else nothing."""
    machine = example(name)
    assert machine is not None
    mechanism = mechanism_of(machine)
    names, at = mechanism.models[mechanism.full_model], checks.trials(machine)
    seen = {unknown: behind(machine, at, names, words) for words, unknown in BEHIND.items()}
    assert seen == {True: 0, False: zeros}
