"""Periodic errors of many orders: found, sized, carried to other poses; nothing where there is nothing."""

from __future__ import annotations

import dataclasses
import re
import sys
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.app import cli
from deltacal_gen.diagnosis.search import Search
from deltacal_gen.diagnosis.spectrum import MOST_OUT, STANDS_OUT, Spectrum, never_seen, periodic, seen, unseen
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.series import Series
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import kept_robot, robot_to_toml
from deltacal_gen.identification.folds import folds
from deltacal_gen.identification.functions import Linear
from deltacal_gen.identification.identification import identify
from deltacal_gen.identification.orders import all_orders, wave
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.pages import report
from deltacal_gen.physics.terms import Term
from deltacal_gen.results.diagnosis import Diagnosis, Seen, SeenJoint
from deltacal_gen.results.document import rounded
from deltacal_gen.results.parts import NeverSeen
from deltacal_gen.results.result import Result
from deltacal_gen.units import DEG
from deltacal_gen.use.prediction import known_effects
from tests.support.open_chains import robot

pytestmark = pytest.mark.usefixtures("compiled")

ORDERS = (2, 5, 9, 14, 20)
JOINTS = (2, 3)
NOISE = 0.01
PART = 62.0  # deg to either side: little more than a joint must move to be asked


def amplitudes() -> dict[int, np.ndarray]:
    """Return cosine and sine [deg] of each order at each joint: a hundredth of a degree altogether."""
    rng = np.random.default_rng(11)
    return {k: 0.004 * rng.standard_normal((len(JOINTS), 2)) for k in ORDERS}


def taken(
    folder: Path,
    name: str,
    noise: float,
    concealed: bool,
    seed: int,
    span: float = 170.0,
    least: float | None = None,
    errors: dict[int, np.ndarray] | None = None,
) -> Path:
    """Write a recording of 250 poses of the arm of `test_serial` in an unknown frame."""
    (folder / "robot.toml").write_text(robot_to_toml(robot()))
    text = "[parameters]\na_2 = 0.2\ntheta_3 = 0.05\n"
    for k, c in (errors or amplitudes()).items() if concealed else ():
        text += f'[[effects]]\nname = "{wave()}"\nlimbs = {list(JOINTS)}\norder = {k}\n'
        text += f"cos = {c[:, 0].tolist()}\nsin = {c[:, 1].tolist()}\n"
    (folder / "truth.toml").write_text(text)
    q = np.random.default_rng(seed).uniform(-span if least is None else least, span, (250, 6))
    header = ",".join(f"q{i}_deg" for i in range(1, 7))
    np.savetxt(folder / f"{name}.csv", q, delimiter=",", header=header, comments="")
    (folder / f"{name}.toml").write_text('[measurement]\nkind = "pose"\nframe = "unknown"\nsigma_deg = 0.0005\n')
    out = folder / f"{name}_read.csv"
    dc.simulate(
        folder / "robot.toml", folder / f"{name}.csv", output=out, truth=folder / "truth.toml", noise=noise, seed=seed
    )
    return out


def geometry(path: Path) -> Fit:
    mechanism = mechanism_of(r := robot())
    problem = pose_problem(r, read_recording(path, mechanism), mechanism.model("serial/dh"))
    return fit(problem, Prior(), must_converge=False)


def found_in(at: Fit) -> Spectrum | None:
    return periodic(at, folds(at.problem.readings, at.problem.recording))


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return taken(tmp_path_factory.mktemp("arm"), "poses", NOISE, concealed=True, seed=1)


@pytest.fixture(scope="module")
def at(recorded: Path) -> Fit:
    return geometry(recorded)


@pytest.fixture(scope="module")
def found(at: Fit) -> Spectrum:
    found = found_in(at)
    assert found is not None
    return found


@pytest.fixture(scope="module")
def half_seen(tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, Diagnosis]:
    """Diagnose joints that never were at angles below zero."""
    folder = tmp_path_factory.mktemp("carried")
    path = taken(folder, "before", NOISE, concealed=True, seed=1, least=0.0)
    return folder, dc.diagnose(folder / "robot.toml", path, output=folder / "known.json")


@pytest.mark.walk
def test_the_joints_and_the_size_of_their_errors_are_found(found: Spectrum) -> None:
    assert found.limbs == JOINTS
    for j, limb in enumerate(JOINTS):
        true = np.sqrt(sum((c[j] ** 2).sum() / 2 for c in amplitudes().values())) * DEG
        assert found.rms[limb] == pytest.approx(true, rel=0.2)
    assert found.heldout[1] < 0.6 * found.heldout[0]


@pytest.mark.walk
def test_the_error_is_known_to_the_standard_deviation_that_is_stated(found: Spectrum) -> None:
    angle = np.random.default_rng(2).uniform(-170, 170, 300) * DEG

    def error(j: int, of: dict[int, np.ndarray]) -> np.ndarray:
        each = [c[j, 0] * np.cos(k * angle) + c[j, 1] * np.sin(k * angle) for k, c in of.items()]
        return np.sum(each, axis=0)

    for j, limb in enumerate(JOINTS):
        true = error(j, {k: c * DEG for k, c in amplitudes().items()})
        as_found = error(j, {int(t.constants[0]): t.values for t in found.terms})
        off = as_found - true
        off -= off.mean()  # a constant is the joint's zero
        assert 0.5 < np.std(off) / found.std[limb] < 1.6


@pytest.mark.walk
def test_the_orders_that_stand_out_are_those_that_are_there(found: Spectrum) -> None:
    for j, limb in enumerate(JOINTS):
        true = {k: float(np.hypot(*c[j])) * DEG for k, c in amplitudes().items()}
        told = found.standing[limb]
        assert told[0].order in ORDERS
        assert max(true, key=lambda k: true[k]) in {s.order for s in told}
        assert 2 <= len(told) <= MOST_OUT
        assert {s.order for s in told if s.amplitude > 4 * s.std} <= set(ORDERS)
        for s in told:
            assert abs(s.amplitude - true.get(s.order, 0.0)) < 4 * s.std
            assert s.amplitude > STANDS_OUT * s.std
        assert [s.amplitude / s.std for s in told] == sorted((s.amplitude / s.std for s in told), reverse=True)


@pytest.fixture(scope="module")
def of_a_part(tmp_path_factory: pytest.TempPathFactory) -> tuple[dict[int, np.ndarray], Spectrum]:
    """Find the smooth error of joints that move by a third of a turn."""
    rng = np.random.default_rng(5)
    errors = {k: 0.1 * rng.standard_normal((len(JOINTS), 2)) / k for k in (1, 2, 3)}
    folder = tmp_path_factory.mktemp("part")
    found = found_in(geometry(taken(folder, "part", NOISE, concealed=True, seed=1, span=PART, errors=errors)))
    assert found is not None
    return errors, found


def of_joint(j: int, errors: dict[int, np.ndarray], angle: np.ndarray) -> np.ndarray:
    """Return the error of a joint (from 0) at angles [rad], but for its zero, in the unit of its coefficients."""
    each = [c[j, 0] * np.cos(k * angle) + c[j, 1] * np.sin(k * angle) for k, c in errors.items()]
    error = np.sum(each, axis=0)
    return np.asarray(error - error.mean())


@pytest.mark.walk
def test_over_a_part_of_the_turn_no_order_is_told_that_others_cancel(
    of_a_part: tuple[dict[int, np.ndarray], Spectrum],
) -> None:
    _, found = of_a_part
    angle = np.linspace(-PART, PART, 500) * DEG
    for j, limb in enumerate(found.limbs):
        terms = {int(t.constants[0]): t.values for t in found.terms}
        whole = np.std(of_joint(j, terms, angle))
        for s in found.standing[limb]:
            assert np.std(of_joint(j, {k: c for k, c in terms.items() if k != s.order}, angle)) < whole


@pytest.mark.walk
def test_the_zero_of_a_joint_is_no_part_of_what_is_unknown_of_its_error(
    of_a_part: tuple[dict[int, np.ndarray], Spectrum],
) -> None:
    errors, found = of_a_part
    angle = np.random.default_rng(1).uniform(-PART, PART, 300) * DEG
    for j, limb in enumerate(JOINTS):
        true = of_joint(j, errors, angle) * DEG
        as_found = of_joint(found.limbs.index(limb), {int(t.constants[0]): t.values for t in found.terms}, angle)
        assert 0.5 < np.std(as_found - true) / found.std[limb] < 1.6


@pytest.mark.walk
def test_they_are_told_in_the_answer_in_words_and_on_the_page(half_seen: tuple[Path, Diagnosis]) -> None:
    _, answer = half_seen
    [many] = [e for e in answer.effects if e.orders is not None]
    assert many.standing_out
    assert {s.limb for s in many.standing_out} == set(JOINTS)
    first = many.standing_out[0]
    shown = rounded(first.amplitude_deg, first.std_deg)
    assert f"clearest at orders: joint {first.limb} {first.order} ({shown[0]} +- {shown[1]} deg)" in answer.summary
    page = re.sub(r"<[^>]*>\s*", " ", report.diagnosis(answer))
    for s in many.standing_out:
        assert f" {s.limb} {s.order} {report.measured(s.amplitude_deg, s.std_deg)} deg" in re.sub(" +", " ", page)


@pytest.mark.walk
def test_what_is_fitted_beside_is_as_unknown_as_the_orders_leave_it(tmp_path: Path) -> None:
    at = geometry(taken(tmp_path, "poses", NOISE, concealed=True, seed=6))
    found = found_in(at)
    assert found is not None
    held = fit(dataclasses.replace(at.problem, held=found.terms), Prior(), errors=at.errors)
    assert found.covariance.shape == held.covariance.shape
    true = {"a_2": 0.2, "theta_3": 0.05 * DEG}
    off = np.array([value - true.get(name, 0.0) for name, value in held.parameters.items()])
    stated, alone = (np.sqrt(np.diag(C)[: len(off)]) for C in (found.covariance, held.covariance))
    assert np.all(stated > 0.8 * alone)
    assert np.max(stated / alone) > 2.0
    assert np.mean(np.abs(off / stated) < 2) >= 0.85


@pytest.mark.walk
def test_rows_that_hang_together_count_by_their_effective_number(at: Fit, found: Spectrum) -> None:
    series = Series.of(at.problem.readings, at.problem.recording)
    assert series is not None
    walking = dataclasses.replace(
        at, repeats=dataclasses.replace(at.repeats, series=dataclasses.replace(series, rho=0.3))
    )
    less_sure = found_in(walking)
    assert less_sure is not None
    assert less_sure.limbs == found.limbs
    for joint in found.limbs:  # the orders are what they were, and less sure
        assert less_sure.rms[joint] == pytest.approx(found.rms[joint], rel=0.2)
        assert less_sure.std[joint] > 1.05 * found.std[joint]


@pytest.mark.walk
def test_a_search_leaves_unknown_orders_what_they_may_take(at: Fit, found: Spectrum) -> None:
    fifth = at.problem.body.blank(wave(), JOINTS, (5.0,))
    known, unknown = dataclasses.replace(at.problem, held=found.terms), found.held_in(at.problem)
    left = []
    for problem in (known, unknown):
        beside = fit(problem, Prior(), errors=at.errors, instrument=at.instrument, must_converge=False)
        left.append(np.diagonal(Search(beside, [fifth]).gram(wave())[0]))
    assert np.all(left[1] < 0.1 * left[0])


def test_nothing_is_found_where_there_is_nothing(tmp_path: Path) -> None:
    assert found_in(geometry(taken(tmp_path, "poses", NOISE, concealed=False, seed=3))) is None


def test_joints_that_hardly_turn_show_no_period(tmp_path: Path) -> None:
    at = geometry(taken(tmp_path, "poses", NOISE, concealed=True, seed=4, span=50.0))
    assert found_in(at) is None


def test_angles_that_were_never_seen_are_told() -> None:
    turn = np.array([-10.0, -8.0, -6.0, 90.0, 95.0, 370.0]) * DEG
    spans = seen(turn, corner=30.0)
    assert spans == [(10.0, 10.0), (90.0, 95.0), (350.0, 354.0)]
    far = unseen(np.array([352.0, 0.0, 12.0, 92.0, 200.0]) * DEG, spans, within=5.0)
    assert far.tolist() == [False, True, False, False, True]
    known = Seen(within_deg=5.0, joints=(SeenJoint(limb=2, angles_deg=tuple(spans)),))
    told = never_seen(known, np.array([[0.0, 200.0], [0.0, 90.0]]) * DEG)
    assert told == (NeverSeen(limb=2, readings=1, angles_deg=((200.0, 200.0),)),)
    assert never_seen(None, np.zeros((1, 6))) == ()
    assert told[0].words.startswith(f"joint {told[0].limb} stands in {told[0].readings} readings at angles")


@pytest.mark.walk
def test_another_session_tells_further_of_errors_where_the_diagnosis_never_was(
    half_seen: tuple[Path, Diagnosis],
) -> None:
    folder, known = half_seen
    read = read_recording(taken(folder, "since", NOISE, concealed=True, seed=12), mechanism_of(robot()))
    since, far = (read.subset(np.arange(k, read.n_rows, 2)) for k in (0, 1))
    carried = dc.identify(robot(), since, physics=known)
    told = carried.continued
    assert told is not None
    assert told.limbs == JOINTS
    assert told.heldout_rms_mm < 0.7 * told.held_rms_mm
    assert carried.heldout_rms_mm == told.heldout_rms_mm
    assert carried.never_seen is None
    assert "at joints 2 and 3" in told.words(kept_robot(robot()).places)

    def off(result: Result) -> Array:
        return (dc.predict(result, far, bands=True).measured - far.measured)[:, :3]

    held = identify(robot(), since, held=known_effects(known)).answer()
    size = {name: np.sqrt(np.mean(off(each) ** 2)) for name, each in (("further", carried), ("held", held))}
    size["alone"] = np.sqrt(np.mean(off(dc.identify(robot(), since)) ** 2))
    assert size["further"] < 0.6 * min(size["held"], size["alone"])
    bands = dc.predict(carried, far, bands=True).channels
    half = np.column_stack([(bands[f"{axis}_hi_mm"] - bands[f"{axis}_lo_mm"]) / 2 for axis in "xyz"])
    assert 0.9 < np.mean(np.abs(off(carried)) < np.hypot(half, 1.96 * NOISE)) <= 1.0


@pytest.mark.walk
def test_errors_that_are_held_stand_in_the_readings_again(at: Fit, found: Spectrum) -> None:
    problem, parts = at.problem, folds(at.problem.readings, at.problem.recording)
    holding = dataclasses.replace(problem, held=found.terms)
    held = dataclasses.replace(at, problem=holding, machine=holding.solve(at.errors))
    errors = [(all_orders(problem.body.q, j), found.coefficients(j).ravel()) for j in found.limbs]
    plain, taken_off, again = Linear(at, parts), Linear(held, parts), Linear(held, parts, put_back=errors)
    moved = np.sqrt(np.mean((taken_off.residual - plain.residual) ** 2))
    assert again.residual == pytest.approx(plain.residual, rel=0, abs=5e-3 * moved)
    assert again.held_out(again.alone) == pytest.approx(
        plain.held_out(plain.alone), rel=0, abs=5e-3 * moved, nan_ok=True
    )
    anew, once = found_in(at), periodic(held, parts, found)
    assert anew is not None
    assert once is not None
    assert once.rms == pytest.approx(anew.rms, rel=0.02)
    assert once.heldout == pytest.approx(anew.heldout, rel=0.02)


@pytest.mark.walk
def test_errors_that_were_mended_since_are_dropped(half_seen: tuple[Path, Diagnosis]) -> None:
    folder, known = half_seen
    since = read_recording(taken(folder, "mended", NOISE, concealed=False, seed=13), mechanism_of(robot()))
    carried, alone = dc.identify(robot(), since, physics=known), dc.identify(robot(), since)
    assert carried.continued is None
    assert not carried.physics
    assert {told.name for told in carried.physics_not_held or ()} == {wave()}
    assert carried.heldout_rms_mm == pytest.approx(alone.heldout_rms_mm, rel=1e-3)


@pytest.mark.walk
def test_what_another_session_tells_further_is_on_the_screen(
    half_seen: tuple[Path, Diagnosis], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    folder, _ = half_seen
    path = taken(folder, "shown", NOISE, concealed=True, seed=14)
    known, out = folder / "known.json", folder / "result.json"
    said = ["identify", folder / "robot.toml", path, "--physics", known, "-o", out]
    monkeypatch.setattr(sys, "argv", ["deltacal", *map(str, said)])
    with pytest.raises(SystemExit) as ended:
        cli.main()
    assert not ended.value.code
    assert "are updated from those of the diagnosis" in " ".join(capsys.readouterr().out.split())


def test_a_held_effect_moves_the_machine_as_a_free_one_does(tmp_path: Path) -> None:
    at = geometry(taken(tmp_path, "poses", 0.0, concealed=False, seed=5))
    term = Term(wave(), (2,), np.array([[1e-4, -2e-4]]), (7.0,))
    body = at.problem.body
    free, _ = body.solve(at.errors, (term,))
    held, _ = body.solve(at.errors, (), held=(term,))
    assert held.x == pytest.approx(free.x)
    assert held.q[:, 1] != pytest.approx(body.q[:, 1], abs=1e-5)
