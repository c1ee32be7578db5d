"""What must not move a diagnosis: circumstances of the recording, and channels that cause nothing."""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.values import Recording
from tests.support.left_out import POSES, SIGMA, channels, diagnosis, effect, machine, named, record

pytestmark = pytest.mark.usefixtures("compiled")

Make = Callable[..., Recording]
BACKLASH = effect("backlash", (2,), 0.02)
TOOLS = np.array([[0.0, 0.0, 0.0], [40.0, 0.0, -30.0], [-20.0, 35.0, 0.0]])


@pytest.fixture(scope="module")
def robot() -> Robot:
    return machine()


def plain(robot: Robot, *terms: Any, n: int = POSES, **how: Any) -> Recording:
    return record(robot, *terms, n=n, of=channels(n, "approach"), **how)


def crowded(robot: Robot, *terms: Any) -> Recording:
    """Every channel a shop may record, none of them a cause but the approach."""
    return record(robot, *terms, of=channels(POSES, "approach", "temp", "time", "payload", "motion", "humidity_pct"))


def still(robot: Robot, *terms: Any) -> Recording:
    """Channels that hardly vary."""
    rng = np.random.default_rng(8)
    calm = {
        "temp_C": np.round(21.0 + 0.05 * rng.standard_normal(POSES), 1),
        "payload_kg": np.where(np.arange(POSES) < 2, 0.1, 0.0),
        "time_s": 1e6 + np.arange(POSES) * 0.5,
    }
    return record(robot, *terms, of=channels(POSES, "approach") | calm)


def round_values(robot: Robot, *terms: Any) -> Recording:
    """Joints of whole degrees, readings to a hundredth of a millimetre: as written down by hand."""
    joints = np.round(np.degrees(plain(robot).joints))
    made = plain(robot, *terms, joints=joints)
    return dataclasses.replace(made, measured=np.round(made.measured, 2))


def short(robot: Robot, *terms: Any) -> Recording:
    return plain(robot, *terms, n=35)


def long(robot: Robot, *terms: Any) -> Recording:
    return plain(robot, *terms, n=240)


def several_points(robot: Robot, *terms: Any) -> Recording:
    return plain(robot, *terms, tool=TOOLS[np.arange(POSES) % 3])


def no_sidecar(robot: Robot, *terms: Any) -> Recording:
    return plain(robot, *terms, declared=False)


def repeats(robot: Robot, *terms: Any) -> Recording:
    """Every pose twice, from other directions, without a word on the noise."""
    once = plain(robot).joints
    twice = np.degrees(np.repeat(once[: POSES // 2], 2, axis=0))
    return plain(robot, *terms, joints=twice, pose=[str(k // 2) for k in range(POSES)], declared=False)


def two_setups(robot: Robot, *terms: Any) -> Recording:
    return plain(robot, *terms, setup=["a"] * (POSES // 2) + ["b"] * (POSES // 2))


CIRCUMSTANCES = (crowded, still, round_values, short, long, several_points, no_sidecar, repeats, two_setups)


@pytest.mark.parametrize("made", CIRCUMSTANCES, ids=lambda f: f.__name__)
def test_circumstances_name_nothing(robot: Robot, made: Make) -> None:
    found = diagnosis(robot, made(robot))
    assert found["verdict"] == "adequate", found["summary"]
    assert found["effects"] == []


@pytest.mark.walk
@pytest.mark.parametrize("made", CIRCUMSTANCES, ids=lambda f: f.__name__)
def test_circumstances_hide_nothing(robot: Robot, made: Make) -> None:
    found = diagnosis(robot, made(robot, BACKLASH))
    assert named(found) == [("backlash", [2])]
    assert found["verdict"] == "missing_physics", found["summary"]
    [width] = found["effects"][0]["parameters"]
    assert abs(width["value"] - 0.02) < 4 * width["std"]


def thrice(robot: Robot, *terms: Any, **how: Any) -> Recording:
    """Every pose three times in a row, beside a thermometer that never stands still."""
    once = np.degrees(plain(robot).joints[:45])
    of = channels(3 * len(once), "temp", "time")
    pose = [str(k // 3) for k in range(3 * len(once))]
    return record(robot, *terms, n=3 * len(once), of=of, joints=np.repeat(once, 3, axis=0), pose=pose, **how)


def test_a_declared_noise_that_repeats_contradict_is_told(robot: Robot) -> None:
    made = thrice(robot, sigma=2 * SIGMA)
    measurement = dataclasses.replace(made.measurement, sigma_mm=SIGMA)
    found = diagnosis(robot, dataclasses.replace(made, measurement=measurement))
    assert (found["verdict"], found["noise"]["source"]) == ("adequate", "repeats"), found["summary"]
    times = re.search(r"declared sigma_mm of 0\.01 is (\d\.\d) times too small", found["summary"])
    assert times is not None, found["summary"]
    assert 1.7 < float(times[1]) < 2.3


@pytest.mark.walk
def test_what_repeats_do_not_show_is_no_noise(robot: Robot) -> None:
    """An error of each pose of its own, beyond what repeats of it differ by."""
    made = thrice(robot, declared=False)
    own = np.random.default_rng(3).standard_normal((len(made.measured) // 3, 3)).repeat(3, axis=0)
    found = diagnosis(robot, dataclasses.replace(made, measured=made.measured + 2.5 * SIGMA * own))
    assert found["noise"]["source"] == "repeats"
    assert (found["verdict"], found["effects"]) == ("unexplained", [])


# ------------------------------------------------------------------------------------------- negative controls


@pytest.mark.parametrize("seed", [1, pytest.param(2, marks=pytest.mark.thorough)])
def test_a_shuffled_cause_is_not_named(robot: Robot, seed: int) -> None:
    made = plain(robot, BACKLASH)
    mixed = {**made.channels, "approach2": np.random.default_rng(seed).permutation(made.channels["approach2"])}
    found = diagnosis(robot, dataclasses.replace(made, channels=mixed))
    assert found["effects"] == []
    assert found["verdict"] == "unexplained"  # twelve times the declared noise is left, and nothing shows why


@pytest.mark.parametrize("seed", [3, 4, 5])
def test_noise_with_heavy_tails_is_noise(robot: Robot, seed: int) -> None:
    made = plain(robot, sigma=0.0, seed=seed, declared=False)
    tails = SIGMA * np.random.default_rng(seed).standard_t(3, made.measured.shape)
    found = diagnosis(robot, dataclasses.replace(made, measured=made.measured + tails))
    assert found["verdict"] == "adequate", found["summary"]


@pytest.mark.parametrize("terms", [(), (BACKLASH,)], ids=["nothing", "backlash"])
def test_gross_errors_are_listed_by_line_and_change_nothing(robot: Robot, terms: tuple[Any, ...]) -> None:
    made = plain(robot, *terms, n=90)
    wild = [7, 30, 61]
    measured = made.measured.copy()
    measured[wild] += [[2.0, 0.0, -1.0], [0.0, -0.7, 0.0], [15.0, 4.0, 0.0]]
    found = diagnosis(robot, dataclasses.replace(made, measured=measured))
    assert found["gross_errors"] == made.line[wild].tolist()
    assert named(found) == ([("backlash", [2])] if terms else [])
    assert found["verdict"] == ("missing_physics" if terms else "adequate")


@pytest.mark.parametrize("terms", [(), (effect("backlash", (1, 2, 3), 0.02),)], ids=["nothing", "backlash"])
def test_few_poses(robot: Robot, terms: tuple[Any, ...]) -> None:
    found = diagnosis(robot, plain(robot, *terms, n=24))  # 72 readings, 48 unknowns of geometry and frame
    assert [e["name"] for e in found["effects"]] == [t.effect for t in terms]
    assert found["verdict"] == ("missing_physics" if terms else "adequate")


@pytest.mark.parametrize("seed", [6, 7])
def test_noise_that_grows_with_distance_is_noise(robot: Robot, seed: int) -> None:
    made = plain(robot, sigma=0.0, seed=seed, declared=False, n=90)
    rim = np.linalg.norm(made.measured - made.measured.mean(axis=0), axis=1, keepdims=True)
    noise = SIGMA * (0.5 + 2 * rim / rim.max()) * np.random.default_rng(seed).standard_normal(made.measured.shape)
    found = diagnosis(robot, dataclasses.replace(made, measured=made.measured + noise))
    assert found["effects"] == []
    assert found["verdict"] == "adequate", found["summary"]


def test_a_channel_that_only_copies_the_pose_is_not_a_cause(robot: Robot) -> None:
    """A temperature that rises along the path of the poses explains what geometry errors look like, and no more."""
    made = plain(robot)
    along = made.joints[:, 0] - made.joints[:, 0].min()
    found = diagnosis(robot, dataclasses.replace(made, channels={"temp_C": 20 + 8 * along}))
    assert found["verdict"] == "adequate", found["summary"]
