"""Recordings in motion: how they are read, put right and refused, and the derivatives of what they hold."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError
from deltacal_gen.motion import derivatives, kinds, trajectories
from deltacal_gen.motion.lost import limits
from deltacal_gen.physics import splines
from tests.support.commands import Run
from tests.support.motion_recordings import NOISE, STEP, named, robot, trajectory, usual, written


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(tmp_path_factory.mktemp("usual"), usual)


def test_derivatives_have_no_delay_and_tell_their_cut_off(recorded: Path) -> None:
    moving = kinds.in_motion(recorded)
    assert moving is not None
    given = moving.read(robot())
    found = derivatives.motion(given)
    wanted = np.concatenate([trajectory(12.0, run) for run in range(4)], axis=1)
    inside = np.concatenate([(np.arange(0, 12.0, STEP) > 0.3) & (np.arange(0, 12.0, STEP) < 11.7)] * 4)
    for order, allowed in ((1, 0.01), (2, 0.03)):
        off = (found.states[order] - wanted[order])[inside]
        assert np.std(off, axis=0) == pytest.approx(0, abs=allowed * np.std(wanted[order]))
        late = np.polyfit(np.gradient(wanted[order][:, 0], STEP)[inside], off[:, 0], 1)[0]
        assert abs(late) < 2e-4  # s
    assert found.cutoff is not None
    assert 1.0 < found.cutoff < 13.0
    assert 0 < found.removed < 1e-3


@pytest.mark.parametrize("seed", [1, 4])
def test_of_short_movements_at_one_speed_enough_is_left(seed: int) -> None:
    """They have no acceleration: knots a second apart were best for that, and all of two seconds were loose ends."""
    t, rng = np.arange(0, 2.2, STEP), np.random.default_rng(seed)
    joints = np.concatenate([speed * t for speed in (1.5, -1.5, 1.0, -1.0)])[:, None] * np.ones(3)
    joints = joints + 3e-5 * rng.standard_normal(joints.shape)
    given = splines.Samples(joints, np.tile(t, 4), np.repeat(np.arange(4), len(t)))
    spacing = splines.chosen_spacing(given, 2, ["rad"] * 3)
    assert 0.1 < spacing < 0.26
    assert np.mean(splines.inside(given, splines.LOOSE * spacing)) > 0.49


def test_a_stop_between_two_samples_takes_no_part(recorded: Path) -> None:
    """What is made of it is a stop over two knots, before and behind; waves are cut nowhere."""
    t, rng = np.arange(0, 6.0, STEP), np.random.default_rng(5)
    way = 1.5 * np.minimum(t, 3.0) + 0.2 * np.sin(5 * t)
    noisy = way[:, None] + 3e-5 * rng.standard_normal((len(t), 1))
    given = splines.Samples(noisy, t, np.zeros(len(t), dtype=int))
    cut = splines.cut(given, splines.smooth(given, 0.08, 1), 0.08, ["rad"])
    assert cut[np.abs(t - 3.0) < 0.15].all()
    assert not cut[np.abs(t - 3.0) > 0.25].any()
    speed = 1.5 * (t < 3.0) + np.cos(5 * t)
    off = splines.smooth(given, 0.08, 1)[1, :, 0] - speed
    there = splines.inside(given, 0.16)
    assert np.abs(off[there & ~cut]).max() < 0.05 < 0.5 < np.abs(off[cut]).max()
    moving = kinds.in_motion(recorded)
    assert moving is not None
    assert "cuts" not in derivatives.motion(moving.read(robot())).text


@pytest.mark.parametrize("share", [0.01, 0.1])
def test_samples_that_were_read_late_are_no_turns(share: float) -> None:
    """A log that asks more often than a drive answers says some angles late: next to each, all was taken for a stop."""
    t, rng = np.arange(0, 6.0, STEP), np.random.default_rng(5)
    when = t - 0.6 * STEP * (rng.random(len(t)) < share)
    late = (np.sin(2 * when) + 0.5 * np.sin(5 * when))[:, None] + 3e-5 * rng.standard_normal((len(t), 1))
    given = splines.Samples(late, t, np.zeros(len(t), dtype=int))
    assert not splines.cut(given, splines.smooth(given, 0.08, 1), 0.08, ["rad"]).any()


def changed(recorded: Path, folder: Path, change: Callable[[list[str]], list[str]], sidecar: str = "") -> Path:
    path = folder / "recording.csv"
    path.write_text("\n".join(change(recorded.read_text().splitlines())) + "\n")
    path.with_suffix(".toml").write_text(recorded.with_suffix(".toml").read_text() + sidecar)
    return path


def with_cell(line: int, column: int, text: str) -> Callable[[list[str]], list[str]]:
    def change(lines: list[str]) -> list[str]:
        cells = lines[line - 1].split(",")
        cells[column] = text
        return [*lines[: line - 1], ",".join(cells), *lines[line:]]

    return change


def read(path: Path) -> Any:
    moving = kinds.in_motion(path)
    assert moving is not None
    return moving.read(robot())


def test_what_is_put_right_is_said(recorded: Path, tmp_path: Path) -> None:
    overflow = read(changed(recorded, tmp_path, with_cell(50, 6, "3276.7")))
    assert overflow.repairs == (
        f"{tmp_path / 'recording.csv'}:50: tau2_Nm reads 3276.7, out of all proportion; it is left out",
    )
    assert np.isnan(overflow.readings[48, 1])
    jump = read(changed(recorded, tmp_path, with_cell(80, 2, "720.0")))
    assert "q1_deg" in jump.repairs[0]
    assert np.ptp(jump.joints[70:90, 0]) < 0.2
    twice = read(changed(recorded, tmp_path, with_cell(100, 1, "0.970000")))
    assert twice.repairs[0].endswith("100: the time of the row before once more; the row is left out")
    assert twice.n_rows == overflow.n_rows - 1


def test_of_speeds_alone_it_is_said_how_angles_are_made(recorded: Path, tmp_path: Path) -> None:
    path = changed(recorded, tmp_path, lambda lines: [lines[0].replace(",q2_deg", ",qd2_deg_s"), *lines[1:]])
    with pytest.raises(InputError) as refused:
        read(path)
    assert refused.value.column == "q2_deg"
    assert "qd2_deg_s times the interval" in refused.value.remedy


def of_three_runs(*rows: int) -> Callable[[list[str]], list[str]]:
    def change(lines: list[str]) -> list[str]:
        each = [[line for line in lines if line.startswith(f"{run},")] for run in (1, 2, 3)]
        return [lines[0], *(line for own, count in zip(each, rows, strict=True) for line in own[:count])]

    return change


def test_a_run_of_which_hardly_anything_is_left_is_not_counted(recorded: Path, tmp_path: Path) -> None:
    """Three were there, three were asked for: of the shortest, all but some samples lie too near its ends."""
    with pytest.raises(InputError) as refused:
        dc.diagnose(robot(), changed(recorded, tmp_path, of_three_runs(70, 70, 20)))
    assert "in 2 runs long enough to count" in refused.value.problem
    assert re.search(r"beside the first and last 0\.\d+ s of each", refused.value.remedy)


@pytest.mark.parametrize("rows", [75, 85])
def test_a_delay_that_leaves_no_samples_enough_is_none(recorded: Path, tmp_path: Path, rows: int) -> None:
    """Each movement loses some at its beginning: of these, what was left made no folds, and was divided by."""
    found = dc.diagnose(robot(), changed(recorded, tmp_path, of_three_runs(rows, rows, 24)))
    assert found.verdict != "adequate"
    assert all(effect.name != "latency" for effect in found.effects)


def of_column(column: int, value: Callable[[float], float]) -> Callable[[list[str]], list[str]]:
    def change(lines: list[str]) -> list[str]:
        rows = [line.split(",") for line in lines[1:]]
        cells = [[*row[:column], f"{value(float(row[column])):.6f}", *row[column + 1 :]] for row in rows]
        return [lines[0], *(",".join(row) for row in cells)]

    return change


def test_angles_that_begin_anew_after_a_turn_are_counted_on(recorded: Path, tmp_path: Path) -> None:
    plain = read(recorded)
    middle = float(np.degrees(np.median(plain.joints[:, 0])))
    given = read(changed(recorded, tmp_path, of_column(2, lambda q: (q - middle) % 360 + middle)))
    off = (given.joints - plain.joints) / (2 * np.pi)
    assert np.abs(off - np.round(off[0])).max() < 1e-8
    assert len(given.repairs) == 1
    assert "q1_deg jumps by a whole turn, here and" in given.repairs[0]
    assert given.repaired == ()


@pytest.mark.parametrize("begins_anew", [False, True])
def test_of_a_joint_that_spins_no_turn_is_taken_away(begins_anew: bool) -> None:
    """Up to 250 deg from sample to sample, of which none was a turn; and at up to 170 each that begins anew is one."""
    time = np.arange(0.0, 4.0, 0.01)
    way = (170 if begins_anew else 250) * np.pi / 180 / 0.01 * (1 - np.cos(2 * np.pi * time / 2)) / 2
    angles = np.cumsum(way * np.sign(np.sin(2 * np.pi * time / 4))) * 0.01
    read_so = (angles + np.pi) % (2 * np.pi) - np.pi if begins_anew else angles.copy()
    jumps = trajectories._counted_on(read_so, np.zeros(len(time), dtype=int))
    assert np.abs(read_so - angles - (read_so - angles)[0]).max() < 1e-9
    assert (len(jumps) > 50) == begins_anew


def test_a_turn_that_was_lost_is_found_wherever_the_joint_may_turn() -> None:
    time = np.arange(0.0, 4.0, 0.01)
    angles = 4.0 * np.sin(2 * time)
    read_so = angles + 2 * np.pi * (time > 2.0)
    assert len(trajectories._counted_on(read_so, np.zeros(len(time), dtype=int))) == 1
    assert np.abs(read_so - angles).max() < 1e-9


@pytest.mark.walk
def test_of_a_drive_whose_reading_never_changes_nothing_is_said(recorded: Path, tmp_path: Path) -> None:
    (tmp_path / "robot.toml").write_text((recorded.parent / "robot.toml").read_text())
    path = changed(recorded, tmp_path, of_column(6, lambda _: 0.0))
    found = dc.diagnose(tmp_path / "robot.toml", path)
    assert found["verdict"] == "missing_physics"
    assert {joint["joint"] for joint in found["joints"]} == {1, 3}
    assert "The reading of joint 2 never changes" in found["summary"]
    assert "it moves, and its reading never changes" in found["next_measurements"][0]["text"]
    known = {p["name"]: p for p in dc.identify(tmp_path / "robot.toml", path)["parameters"]}
    assert all(np.isfinite(p["std"]) for p in known.values())


@pytest.mark.walk
def test_of_a_drive_that_was_not_read_nothing_is_said(recorded: Path, tmp_path: Path) -> None:
    """It moves for all that."""

    def without_second(line: str) -> str:
        cells = line.split(",")
        return ",".join([*cells[:6], "", *cells[7:]])

    (tmp_path / "robot.toml").write_text((recorded.parent / "robot.toml").read_text())
    found = dc.diagnose(
        tmp_path / "robot.toml", changed(recorded, tmp_path, lambda lines: [lines[0], *map(without_second, lines[1:])])
    )
    assert {joint["joint"] for joint in found["joints"]} == {1, 3}
    assert "What the drive of joint 2 gives was not recorded" in found["summary"]
    assert "moves too little" not in found["summary"]
    assert found["next_measurements"][0]["text"] == "Record what the drive of joint 2 gives: its cells are blank."


@pytest.mark.walk
def test_readings_at_a_limit_are_left_out(recorded: Path, tmp_path: Path) -> None:
    """Those of drives that come near their largest seldom, of coarse counts, or of a switch are at none."""
    (tmp_path / "robot.toml").write_text((recorded.parent / "robot.toml").read_text())
    cut = changed(recorded, tmp_path, of_column(5, lambda torque: min(torque, 25.0)))
    found = dc.diagnose(tmp_path / "robot.toml", cut)
    assert [r.partition("csv:")[2].partition(": ")[2][:20] for r in found["motion"]["repairs"]] == [
        "tau1_Nm is at a limi"
    ]
    assert named(found) == {"coulomb_friction": [1, 2], "viscous_friction": [1, 3]}
    assert found["final"]["heldout_rms_by_joint"][0] < 1.15 * NOISE
    y = np.random.default_rng(2).normal(size=4000)
    assert limits(np.clip(y, -1.5, 2.0)) == pytest.approx([-1.5, 2.0])
    levels = np.repeat([2.0, 1.0, -1.0, -2.0, *np.linspace(-0.9, 0.9, 30)], [400, 900, 900, 400, *[5] * 30])
    for free in (y, np.round(y, 1), np.round(np.sign(y) + 0.05 * y, 2), np.sign(y), np.clip(y, -0.2, 0.2), levels):
        assert not len(limits(free))


def test_what_is_put_right_is_told_by_every_command(run: Run, recorded: Path, tmp_path: Path) -> None:
    """Every fifth row twice: those that predict answers are fewer than those it was asked for."""
    robot_file = tmp_path / "robot.toml"
    robot_file.write_text((recorded.parent / "robot.toml").read_text())
    path = changed(recorded, tmp_path, lambda lines: [x for n, x in enumerate(lines) for _ in range(1 + (n % 5 == 4))])
    result, said = tmp_path / "result.json", f"{path}:6: the time of the row before once more; the row is left out"
    asked = {
        "identify": (robot_file, path, "-o", result),
        "validate": (result, path),
        "predict": (result, path, "-o", tmp_path / "predicted.csv"),
    }
    for command, words in asked.items():
        code, out, _ = run(command, *words)
        assert code == 0
        assert "".join(said.split()) in "".join(out.split()), command  # long paths are broken anywhere
        assert "and 957 more that were put right or left out" in " ".join(out.split())


@pytest.mark.walk
def test_a_reading_that_is_counted_against_its_angle_is_told(recorded: Path, tmp_path: Path) -> None:
    """Motors are mounted either way: of currents that is one more unknown, and nothing is predicted worse."""
    (tmp_path / "robot.toml").write_text((recorded.parent / "robot.toml").read_text())
    turn = of_column(5, lambda torque: -torque)
    path = changed(recorded, tmp_path, lambda lines: [lines[0].replace("tau", "drive").replace("_Nm", ""), *lines[1:]])
    plain = dc.diagnose(tmp_path / "robot.toml", path)
    found = dc.diagnose(tmp_path / "robot.toml", changed(path, tmp_path, turn))
    assert "Friction would drive joint 1: its reading is counted against its angle." in found["summary"]
    assert "would drive" not in plain["summary"]
    assert (found["verdict"], named(found)) == (plain["verdict"], named(plain))
    held = found["final"]["heldout_rms_by_joint"]
    assert held == pytest.approx(plain["final"]["heldout_rms_by_joint"], rel=1e-3)
    doubts = dc.identify(tmp_path / "robot.toml", path)["doubts"]
    assert any("friction would drive joint 1: the reading is counted against the angle" in doubt for doubt in doubts)


def test_readings_that_all_never_change_are_refused(recorded: Path, tmp_path: Path) -> None:
    constant = of_column(5, lambda _: 1.0), of_column(6, lambda _: 0.0), of_column(7, lambda _: 0.0)
    (tmp_path / "robot.toml").write_text((recorded.parent / "robot.toml").read_text())
    path = changed(recorded, tmp_path, lambda lines: constant[2](constant[1](constant[0](lines))))
    with pytest.raises(InputError, match="readings never change: tau1_Nm, tau2_Nm, tau3_Nm"):
        dc.identify(tmp_path / "robot.toml", path)


def test_where_a_run_begins_is_no_spike(tmp_path: Path) -> None:
    """Joints stand elsewhere when the next run begins, many times what they move from sample to sample."""
    given = read(written(tmp_path, usual, runs=3, seed=105))
    assert given.repairs == ()
    assert np.abs(np.diff(given.joints, axis=0))[np.diff(given.run) > 0].max() > 0.5


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (with_cell(100, 1, "0.5"), "line 100, column 'time_s': time goes backwards within run '1'"),
        (with_cell(100, 0, "2"), "line 101, column 'run': run '1' goes on here"),
        (lambda lines: [line.rpartition(",")[0] for line in lines], "column 'tau3_Nm': the column is missing"),
        (lambda lines: [*lines[:-1], "4,11.99,1.0"], "the row has 3 cells, the header 8"),
        (lambda lines: [lines[0].replace("tau1_Nm", "tau1_lbft"), *lines[1:]], "'tau1_lbft' is no reading of a drive"),
        (lambda lines: [lines[0].replace("time_s", "t"), *lines[1:]], "column 'time_s': the column is missing"),
    ],
)
def test_what_cannot_be_used_is_refused_with_its_place(recorded: Path, tmp_path: Path, change: Any, words: str) -> None:
    with pytest.raises(InputError) as error:
        read(changed(recorded, tmp_path, change))
    assert words in str(error.value)


@pytest.mark.walk
def test_noise_that_is_much_is_said(tmp_path: Path) -> None:
    """Little that is left, or much: either is adequate where it depends on nothing."""
    rng = np.random.default_rng(7)
    for noise, said in ((0.0, False), (40.0, True)):
        path = written(tmp_path, lambda s, load, noise=noise: noise * rng.standard_normal(load.shape))
        found = dc.diagnose(tmp_path / "robot.toml", path)
        assert found["verdict"] == "adequate"
        assert ("What is left looks like noise, and is much:" in found["summary"]) == said


def test_a_time_in_milliseconds_is_refused(recorded: Path, tmp_path: Path) -> None:
    given = read(changed(recorded, tmp_path, of_column(1, lambda t: 1000 * t)))
    with pytest.raises(InputError, match=r"samples lie 10 s apart.*Give time_s in seconds"):
        derivatives.motion(given)


def test_a_run_of_a_few_samples_each_is_refused(recorded: Path, tmp_path: Path) -> None:
    """A counter in the column `run`, for one; the screen showed warnings of means of nothing."""

    def counted(lines: list[str]) -> list[str]:
        return [lines[0], *(f"{n // 8},{line.partition(',')[2]}" for n, line in enumerate(lines[1:1200]))]

    with pytest.raises(InputError, match="no movement has more than 8 samples without a gap"):
        derivatives.motion(read(changed(recorded, tmp_path, counted)))


@pytest.mark.parametrize("said", [None, "", "[measurement]\nsigma_mm = 0.1\n"])
def test_a_recording_of_drives_whose_sidecar_does_not_say_so_is_told_what_to_write(
    said: str | None, recorded: Path, tmp_path: Path
) -> None:
    path = changed(recorded, tmp_path, list)
    path.with_suffix(".toml").unlink()
    if said is not None:
        path.with_suffix(".toml").write_text(said)
    with pytest.raises(InputError) as error:
        dc.diagnose(recorded.parent / "robot.toml", path)
    assert "column 'tau1_Nm': this is what a drive gives" in str(error.value)
    assert "Write kind = 'torque' under [measurement] in recording.toml." in str(error.value)


def test_derivatives_said_to_be_recorded_must_be_there(recorded: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="'qd1_deg_s': the sidecar says derivatives = \"recorded\""):
        read(changed(recorded, tmp_path, list, '[motion]\nderivatives = "recorded"\n'))


@pytest.mark.parametrize("sigma", ["1e300", "1e-300", "0.0"])
def test_noise_whose_square_is_no_number_is_refused(recorded: Path, tmp_path: Path, sigma: str) -> None:
    path = changed(recorded, tmp_path, lambda lines: lines)
    path.with_suffix(".toml").write_text(f'[measurement]\nkind = "torque"\nsigma_Nm = {sigma}\n')
    with pytest.raises(InputError, match="sigma_Nm"):
        read(path)
