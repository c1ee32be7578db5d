"""Mistakes of a recording in motion that its own samples show: exchanged columns, another unit; good ones have none."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError
from deltacal_gen.files.robot import read_robot
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.motion import mistakes
from deltacal_gen.motion.fit import fitted
from deltacal_gen.motion.joint import USUAL
from deltacal_gen.motion.library import Rung
from deltacal_gen.motion.session import Session
from deltacal_gen.motion.trajectories import read, read_sidecar
from tests.support.motion_recordings import carried, usual, waves, written

Change = Callable[[dict[str, Any]], Any]


@pytest.fixture(scope="module")
def free(tmp_path_factory: Any) -> Path:
    """Return a recording of an arm whose bodies no file states."""
    return written(tmp_path_factory.mktemp("free"), usual, seed=4)


@pytest.fixture(scope="module")
def stated(tmp_path_factory: Any) -> Path:
    """Return one of an arm whose file states all of them."""
    truth = '[[effects]]\nname = "coulomb_friction"\nlimbs = [1, 2]\ncoulomb = 4.0\n'
    return carried(tmp_path_factory.mktemp("stated"), truth)


def changed(path: Path, folder: Path, change: Change) -> Path:
    """Write a recording with other columns; return its path."""
    head, *lines = path.read_text().splitlines()
    table = dict(zip(head.split(","), np.array([line.split(",") for line in lines], dtype=float).T, strict=True))
    change(table)
    out = folder / "recording.csv"
    np.savetxt(out, np.column_stack(list(table.values())), delimiter=",", header=",".join(table), comments="")
    out.with_suffix(".toml").write_text(path.with_suffix(".toml").read_text())
    (folder / "robot.toml").write_text((path.parent / "robot.toml").read_text())
    return out


def session_of(path: Path) -> Session:
    robot, said = read_robot(path.parent / "robot.toml"), read_sidecar(path)
    assert said is not None
    return Session.of(robot, read(path, mechanism_of(robot), said))


def exchanged(*numbers: int) -> Change:
    """Return what gives each of some drives the readings of the next."""
    names = [f"tau{i}_Nm" for i in numbers]

    def change(table: dict[str, Any]) -> None:
        table |= dict(zip(names, [table[name] for name in (*names[1:], names[0])], strict=True))

    return change


def times(factor: float, *numbers: int) -> Change:
    def change(table: dict[str, Any]) -> None:
        table |= {f"tau{i}_Nm": factor * table[f"tau{i}_Nm"] for i in numbers}

    return change


@pytest.mark.parametrize("pair", [(1, 2), (2, 3), (1, 3)])
def test_two_drives_whose_columns_are_exchanged_are_said(free: Path, tmp_path: Path, pair: tuple[int, int]) -> None:
    path, (a, b) = changed(free, tmp_path, exchanged(*pair)), pair
    with pytest.raises(InputError) as error:
        mistakes.check(session_of(path))
    said = str(error.value)
    assert f"the readings of joints {a} and {b} are exchanged: each follows the movement of another joint" in said
    assert f"Rename columns in its first line: tau{a}_Nm is tau{b}_Nm, tau{b}_Nm is tau{a}_Nm." in said


def test_three_that_went_round_are_said_too(free: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"tau1_Nm is tau2_Nm, tau2_Nm is tau3_Nm, tau3_Nm is tau1_Nm"):
        mistakes.check(session_of(changed(free, tmp_path, exchanged(1, 2, 3))))


@pytest.mark.parametrize(("joint", "factor", "unit"), [(1, 1e3, "mNm"), (2, 1e3, "mNm"), (3, 1e-3, "kNm")])
def test_one_drive_in_another_unit_than_the_others_is_said(
    free: Path, tmp_path: Path, joint: int, factor: float, unit: str
) -> None:
    """By the bodies that the others tell of."""
    path = changed(free, tmp_path, times(factor, joint))
    with pytest.raises(
        InputError, match=f"tau{joint}_Nm reads {factor:g} times what bodies .* as {unit} would"
    ) as error:
        mistakes.check(session_of(path))
    assert ("Divide the column by 1000" if factor > 1 else "Multiply by 1000") in str(error.value)


def test_all_drives_in_another_unit_are_said_where_the_file_states_bodies(stated: Path, tmp_path: Path) -> None:
    path = changed(stated, tmp_path, times(1e3, 1, 2, 3))
    said = "tau1_Nm, tau2_Nm, tau3_Nm read 1000 times what the bodies in the robot file ask for: as mNm would"
    for command in (dc.identify, dc.diagnose):
        with pytest.raises(InputError, match=said):
            command(tmp_path / "robot.toml", path)


@pytest.mark.walk
def test_where_it_states_none_they_would_carry_more_than_steel(free: Path, tmp_path: Path) -> None:
    path = changed(free, tmp_path, times(1e3, 1, 2, 3))
    doubts = dc.identify(tmp_path / "robot.toml", path)["doubts"]
    assert any("more than steel of such a size weighs: tau2_Nm may be in mNm" in doubt for doubt in doubts)
    assert "But joint 2 would carry" in dc.diagnose(tmp_path / "robot.toml", path)["summary"]
    assert dc.identify(free.parent / "robot.toml", free).doubts is None


def test_what_is_quick_is_not_heavy(tmp_path: Path) -> None:
    """A wheel of 70 kg mm^2 that a drive takes to 500 rad/s and back, again and again: of 60 g, not of half a kilo."""
    t, rng = np.arange(0.0, 12.0, 0.002), np.random.default_rng(1)
    q, qdd = -(500 / 8) * np.cos(8 * t), 500 * 8 * np.cos(8 * t)
    tau = 7e-5 * qdd + 0.005 * np.sign(np.sin(8 * t)) + 0.005 * rng.standard_normal(len(t))
    path = tmp_path / "recording.csv"
    np.savetxt(path, np.column_stack([t, np.degrees(q), tau]), "%.6f", ",", header="time_s,q1_deg,tau1_Nm", comments="")
    path.with_suffix(".toml").write_text('[measurement]\nkind = "torque"\n')
    (tmp_path / "robot.toml").write_text(
        '[robot]\nname = "wheel"\nmechanism = "serial"\n\n[[joint]]\nkind = "revolute"\nconvention = "standard"\n'
        "a = 0.0\nalpha = 0.0\nd = 50.0\ntheta = 0.0\n"
    )
    session = session_of(path)
    fits = [fitted(joint, [Rung(name) for name in USUAL]) for joint in session.moving]
    assert list(mistakes.too_heavy(session, fits)) == []


def in_radians(table: dict[str, Any]) -> None:
    table |= {name: np.radians(table[name]) for name in ("q1_deg", "q2_deg", "q3_deg")}


def test_joints_in_radians_are_said(free: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=r"joints count in radians, by what drives give: .*Multiply .* by 57.29578"):
        mistakes.check(session_of(changed(free, tmp_path, in_radians)))


@pytest.mark.parametrize("metres", [True, False])
def test_a_slide_in_metres_is_said_and_one_that_moves_little_is_not(tmp_path: Path, metres: bool) -> None:
    (tmp_path / "robot.toml").write_text(
        '[robot]\nname = "slide"\nmechanism = "serial"\n[[joint]]\nkind = "prismatic"\nconvention = "standard"\n'
        "a = 0.0\nalpha = 0.0\nd = 0.0\ntheta = 0.0\n"
    )
    t = np.arange(0, 20, 0.005)
    q, qd, qdd = 200.0 * waves(t, 0, 1)[:, :, 0]  # mm
    size = 1e-3 if metres else 1.0
    force = 5.0 * (9.81 + qdd / 1000) + 3.0 * np.sign(qd) + 0.1 * np.random.default_rng(0).standard_normal(len(t))
    path = tmp_path / "recording.csv"
    np.savetxt(path, np.column_stack([t, size * q, force]), "%.8f", ",", header="time_s,q1_mm,tau1_N", comments="")
    path.with_suffix(".toml").write_text('[measurement]\nkind = "torque"\n')
    if metres:
        with pytest.raises(InputError, match="joints count in metres"):
            mistakes.check(session_of(path))
    else:
        mistakes.check(session_of(path))


def test_readings_that_lost_their_sign_are_a_doubt(free: Path, tmp_path: Path) -> None:
    path = changed(free, tmp_path, lambda table: table.update(tau1_Nm=np.abs(table["tau1_Nm"])))
    doubts = dc.identify(tmp_path / "robot.toml", path)["doubts"]
    assert any(doubt.startswith("readings of joint 1 come down to zero and are never below") for doubt in doubts)


def still(table: dict[str, Any]) -> None:
    """One joint alone in each run, the others and what holds them at rest."""
    for j in (1, 2, 3):
        others = table["run"] != j
        table[f"q{j}_deg"][others] = table[f"q{j}_deg"][others][0]


@pytest.mark.parametrize("change", [lambda table: None, times(2.0, 2), times(-1.0, 1), still])
def test_what_is_none_of_these_is_not_refused(free: Path, stated: Path, tmp_path: Path, change: Change) -> None:
    """A drive counted against its angle and one of twice the torque are other things; nor do joints move together."""
    for path in (free, stated):
        mistakes.check(session_of(changed(path, tmp_path, change)))
