"""What no effect explains: corrected as far as held-out poses bear it out, and only where there were readings."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.diagnosis.correction import Smooth, borne_out_beside, holding
from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.diagnosis.laws.laws import Sought
from deltacal_gen.diagnosis.structure import Structure, structures
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.prior import with_prior
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.files.robot import Robot, robot_from_dict
from deltacal_gen.identification.accuracy import volumetric_error
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.units import DEG
from deltacal_gen.use.known import known_result
from deltacal_gen.use.prediction import CORRECTED
from tests.support.left_out import DELTA, FRAME, SIGMA, channels, diagnosis, machine, record
from tests.support.printers import PRINTER, grid, recording
from tests.support.prototype import plausible

pytestmark = pytest.mark.usefixtures("compiled")

POSES = 140
LIMB = 1  # the second


def swollen(robot: Robot, seed: int, sigma: float = SIGMA) -> Recording:
    """Return readings of a machine whose second joint errs with the humidity, not in proportion to it."""
    of = channels(POSES, "humidity", "temp", "time", seed=seed)
    plain = record(robot, n=POSES, seed=seed, sigma=0.0, of=of, declared=False)
    joints = plain.joints.copy()
    joints[:, LIMB] += 0.01 * DEG * np.sin((of["humidity"] - 45) / 6)
    read = simulate(robot, dataclasses.replace(plain, joints=joints), plausible(DELTA, 11, size=0.3), frame=FRAME)
    noise = sigma * np.random.default_rng(seed).standard_normal((POSES, 3))
    return dataclasses.replace(plain, measured=read.measured + noise)


def dented(robot: Robot, seed: int, sigma: float = SIGMA) -> Recording:
    """Return readings moved by up to 0.3 mm around a place of the workspace."""
    plain = record(robot, n=POSES, seed=seed, sigma=sigma, declared=False)
    x = simulate(robot, dataclasses.replace(plain, channels={}), frame=(np.zeros(3), np.zeros(3))).measured
    bump = np.exp(-0.5 * np.sum(((x - [250.0, 100.0, -850.0]) / 90.0) ** 2, axis=1))
    return dataclasses.replace(plain, measured=plain.measured + 0.3 * bump[:, None] * [0.6, -0.6, 0.5])


@pytest.fixture(scope="module")
def robot() -> Robot:
    return machine()


@pytest.fixture
def no_laws(monkeypatch: pytest.MonkeyPatch) -> None:
    """None is sought, which would explain a misfit before any correction does."""
    monkeypatch.setattr("deltacal_gen.diagnosis.diagnosis.laws", lambda found, progress, doubted=False: Sought())


@pytest.fixture(scope="module")
def humid(robot: Robot) -> dict[str, Any]:
    """A diagnosis that has found no law, which would explain a wave of the humidity before any correction does."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("deltacal_gen.diagnosis.diagnosis.laws", lambda found, progress: Sought())
        found: dict[str, Any] = json.loads(diagnosis(robot, swollen(robot, 1)).to_json())
    return found


def error(found: dict[str, Any], fresh: Recording) -> float:
    return float(np.sqrt(np.mean((dc.predict(found, fresh).measured - fresh.measured) ** 2)))


def without(found: dict[str, Any]) -> dict[str, Any]:
    return found | {"correction": None}


@pytest.mark.walk
def test_a_dependence_on_a_channel_is_corrected_at_its_joint(robot: Robot, humid: dict[str, Any]) -> None:
    assert humid["verdict"] == "unexplained"
    made = humid["correction"]
    assert made["depends_on"] == ["humidity"]
    assert made["limbs"] == [LIMB + 1]
    assert made["heldout_rms_mm"]["before"] > 3 * SIGMA
    assert made["heldout_rms_mm"]["after"] < 1.2 * SIGMA
    assert made["share_of_excess"] > 0.9
    assert "by the channel humidity" in humid["summary"]
    fresh = swollen(robot, 9, sigma=0.0)
    assert error(humid, fresh) < 0.2 * error(without(humid), fresh)


@pytest.mark.walk
def test_a_local_misfit_is_corrected_where_it_sits(robot: Robot) -> None:
    found = diagnosis(robot, dented(robot, 1))
    assert found["verdict"] == "unexplained"
    assert found["correction"]["depends_on"] == ["position"]
    assert found["correction"]["limbs"] == []
    assert "lowers the error of held-out readings" in found["summary"]
    fresh = dented(robot, 9, sigma=0.0)
    assert error(found, fresh) < 0.65 * error(without(found), fresh)


def test_a_correction_holds_where_the_machine_of_a_prediction_puts_its_readings(robot: Robot) -> None:
    """What an unknown frame leaves open of where {O} stands one fit has otherwise than the next."""
    problem = pose_problem(robot, dented(robot, 1), DELTA.models["delta/42"])
    at = fit(with_prior(problem, robot)[0], Prior())
    made = borne_out_beside(at, structures(at))
    assert made is not None
    higher = at.errors + [100.0 * (p.error == "ez") for p in DELTA.parameters]  # the base as a whole
    whole = dataclasses.replace(at, errors=higher, machine=at.problem.solve(higher))
    found, body = made.of_all(whole), problem.body
    assert found is not None
    assert [smooth.variable for smooth in found.smooth] == ["position"]
    assert holding(found.smooth, problem.recording, body.q, whole.machine.x) == pytest.approx(1.0, abs=1e-6)


@pytest.mark.walk
def test_beyond_what_was_measured_nothing_is_corrected(robot: Robot, humid: dict[str, Any]) -> None:
    fresh = swollen(robot, 9, sigma=0.0)
    seen = np.array(humid["correction"]["smooth"][0]["knots"])
    for value in (seen.max() + 100.0, seen.min() - 100.0, np.nan):
        dry = dataclasses.replace(fresh, channels=fresh.channels | {"humidity": np.full(POSES, value)})
        plain = dc.predict(without(humid), dry)
        done = dc.predict(humid, dry)
        assert (done.channels[CORRECTED] == 0).all()
        assert done.measured == pytest.approx(plain.measured, abs=1e-9)
        assert CORRECTED not in plain.channels
    lost = dataclasses.replace(fresh, channels={k: v for k, v in fresh.channels.items() if k != "humidity"})
    assert (dc.predict(humid, lost).channels[CORRECTED] == 0).all()
    inside = dc.predict(humid, swollen(robot, 1)).channels[CORRECTED]
    assert inside == pytest.approx(1.0, abs=1e-12)


@pytest.mark.walk
def test_a_validation_uses_the_correction_too(robot: Robot, humid: dict[str, Any]) -> None:
    fresh = swollen(robot, 9, sigma=0.0)
    assert dc.validate(humid, fresh)["rms_mm"] == pytest.approx(error(humid, fresh), rel=1e-9)


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_noise_is_not_corrected(robot: Robot, seed: int) -> None:
    """Also where it is made to try: of all that is held out, none is predicted better."""
    recording = record(robot, n=POSES, seed=seed, of=channels(POSES, "humidity", "temp"))
    found = diagnose(robot, recording)
    assert found.verdict == "adequate"
    assert found.answer()["correction"] is None
    tried = [Structure(name, 1.0, 0.0, limbs) for name, limbs in (("humidity", (2,)), ("position", ()), ("temp_C", ()))]
    assert borne_out_beside(found.final, tried) is None


def test_a_function_fades_over_its_length() -> None:
    knots, ones = np.array([[20.0], [21.0], [22.0]]), np.ones((3, 1))
    made = Smooth(variable="temp_C", limbs=(1,), knots=knots, length=2.0, reach=0.5, coefficients=ones)
    share = made.share(np.array([[20.0], [21.3], [22.5], [24.5], [40.0], [np.nan]]))
    assert share == pytest.approx([1.0, 1.0, 1.0, np.exp(-0.5), 0.0, 0.0], abs=1e-7)
    assert made.displacement(np.array([[21.0], [np.nan]])) == pytest.approx(np.array([[1 + 2 * np.exp(-1 / 8)], [0.0]]))
    again = Smooth(**json.loads(json.dumps(made.to_dict())))
    assert again.displacement(made.knots) == pytest.approx(made.displacement(made.knots), abs=0)


@pytest.mark.walk
def test_commands_undo_the_correction_too(robot: Robot, humid: dict[str, Any]) -> None:
    """On the true machine: the joint that swells is commanded less."""
    rng = np.random.default_rng(31)
    targets = np.column_stack([rng.uniform(-250, 250, (20, 2)), rng.uniform(-930, -780, 20)])
    humidity = rng.uniform(*np.quantile(humid["correction"]["smooth"][0]["knots"], [0.2, 0.8]), 20)
    said: list[str] = []
    off = []
    for known in (humid, without(humid)):
        joints = dc.compensate(known, targets, channels={"humidity": humidity}, tell=said.append) * DEG
        joints[:, LIMB] += 0.01 * DEG * np.sin((humidity - 45) / 6)
        x, _ = DELTA.forward(joints, robot.tool, DELTA.rows(robot, DELTA.vector(plausible(DELTA, 11, size=0.3))))
        off.append(float(np.sqrt(np.mean(volumetric_error(x[:, :3], targets) ** 2))))  # {O} is known but for a motion
    assert off[0] < 0.3 * off[1]
    assert not any("smooth correction" in words for words in said)
    dc.compensate(humid, targets[:2], channels={"humidity": np.array([1e4, 1e4])}, tell=said.append)
    assert "2 of 2 targets lie outside" in said[-1]


@pytest.mark.walk
@pytest.mark.parametrize("export", ["c", "table"])
def test_an_export_says_what_it_leaves_out(humid: dict[str, Any], tmp_path: Path, export: str) -> None:
    for known, said in ((humid, True), (without(humid), False)):
        dc.export_compensator(known, output=tmp_path / "file", export=export)
        heads = [(tmp_path / "file").read_text(encoding="utf-8")[:4000]]
        compensator = dc.Compensator(known_result(known))
        if export == "c":
            dc.export_c(compensator, tmp_path / "other")
        else:
            dc.export_table(compensator, tmp_path / "other")
        heads.append((tmp_path / "other").read_text(encoding="utf-8")[:4000])
        assert [("The smooth correction of the answer is not in this file" in head) for head in heads] == [said] * 2


def probed(printer: Robot, targets: Array, sigma: float = 0.0) -> Recording:
    """Return probed heights of a bed with a dent of 0.25 mm."""
    read = simulate(printer, recording(printer, targets), {"endstop_1": 0.2, "radius_2": -0.3, "arm_3": 0.15})
    dent = 0.25 * np.exp(-0.5 * np.sum(((targets[:, :2] - [35.0, 20.0]) / 22.0) ** 2, axis=1))
    noise = sigma * np.random.default_rng(1).standard_normal(read.measured.shape)
    return dataclasses.replace(read, measured=read.measured + dent[:, None] + noise)


@pytest.mark.walk
@pytest.mark.usefixtures("no_laws")
def test_heights_are_predicted_as_the_page_says() -> None:
    """On the readings themselves and between them; ten times off, once."""
    printer = robot_from_dict(PRINTER)
    read, between = probed(printer, grid(step=10.0), 0.005), probed(printer, grid(radius=95.0, step=9.3))
    found: dict[str, Any] = json.loads(diagnose(printer, read).answer().to_json())
    told = found["correction"]["heldout_rms_mm"]
    assert "of readings held out row by row" in found["summary"]  # the table's are held out with their neighbours
    assert told["before"] > 0.02
    assert told["after"] < 0.008
    assert error(found, read) < 1.1 * told["after"]
    assert error(found, between) < 1.1 * told["after"]
