"""Time stamps that count from long before a recording, as clocks of computers do, change nothing but their count."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.values import Recording
from deltacal_gen.use.compensation import Compensator
from deltacal_gen.use.prediction import predict
from deltacal_gen.use.spans import spans
from tests.support.left_out import channels, effect, machine, record

BEFORE = 1.7e9  # s: from 1970 on


@pytest.fixture(scope="module")
def robot() -> Robot:
    return machine()


@pytest.fixture(scope="module")
def drifting(robot: Robot) -> Recording:
    """Return an hour's readings in which two joints drift by 0.01 deg/h."""
    return record(robot, effect("zero_drift", (1, 2), 0.01), n=80, of=channels(80, "time", "temp"))


def stamped(recording: Recording, before: float = BEFORE) -> Recording:
    time = recording.channels["time_s"] + before
    return dataclasses.replace(recording, channels=recording.channels | {"time_s": time})


@pytest.mark.walk
def test_a_drift_is_found_and_predicted_all_the_same(robot: Robot, drifting: Recording) -> None:
    plain, late = (diagnose(robot, r).answer() for r in (drifting, stamped(drifting)))
    assert [e.name for e in plain.effects] == ["zero_drift"]
    assert [(e.name, e.limbs) for e in late.effects] == [(e.name, e.limbs) for e in plain.effects]
    rates = [[p.value for e in found.effects for p in e.parameters] for found in (plain, late)]
    assert rates[1] == pytest.approx(rates[0], rel=1e-3)
    assert (plain.begun_s, late.begun_s) == (0.0, BEFORE + drifting.channels["time_s"].min())
    after = dataclasses.replace(drifting, channels={k: v + 1800.0 for k, v in drifting.channels.items()})
    assert predict(late, stamped(after)).measured == pytest.approx(predict(plain, after).measured, abs=1e-3)
    over = [spans(found).known["time"] for found in (plain, late)]  # what exports are made over [h]
    assert over[1] == pytest.approx(np.subtract(over[0], over[0][0]), abs=1e-9)
    assert f"time_s {late.begun_s:.15g} to" in spans(late).in_channels(late.begun_s)
    x, hour = np.array([[50.0, 20.0, -900.0]]), 3600.0 + drifting.channels["time_s"].min()
    plainly, stampedly = Compensator(plain), Compensator(late)
    at = plainly.channels({"time_s": hour}, 1)[0], stampedly.channels({"time_s": BEFORE + hour}, 1)[0]
    commands = plainly.command(x, channels=at[0])[0], stampedly.command(x, channels=at[1])[0]
    assert commands[1] == pytest.approx(commands[0], abs=1e-6)
    begin = plainly.command(x, channels=plainly.channels({"time_s": hour - 3600.0}, 1)[0])[0]
    assert np.abs(begin - commands[0]).max() > 1e-4  # a drift of 1.7e-4 rad
    assert stampedly.command(x)[0] == pytest.approx(begin, abs=1e-6)  # without a time, at the start


def test_stamps_of_a_recording_of_its_own_stay_as_they_are(drifting: Recording) -> None:
    length = float(np.ptp(drifting.channels["time_s"]))
    assert drifting.origin == 0.0
    assert stamped(drifting, 9.0 * length).origin == 0.0
    assert stamped(drifting, 11.0 * length).origin == pytest.approx(11.0 * length + drifting.channels["time_s"].min())
    assert dataclasses.replace(stamped(drifting), begun=5.0).origin == 5.0
    assert dataclasses.replace(drifting, channels={}).origin == 0.0
