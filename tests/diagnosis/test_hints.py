"""What earned its price, or nearly, and is not named is told; held-out readings decide with errors that are stated."""

from __future__ import annotations

import dataclasses
import html

import numpy as np
import pytest
from scipy.signal import lfilter

from deltacal_gen.app.cli.terminal import Terminal
from deltacal_gen.diagnosis import hints, selection, strategy
from deltacal_gen.diagnosis.answer import Diagnosed
from deltacal_gen.diagnosis.charges import MARGIN
from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.diagnosis.evidence import MOST_WRONG, Evidence, evidence
from deltacal_gen.diagnosis.hints import hinted
from deltacal_gen.diagnosis.library import library
from deltacal_gen.diagnosis.search import Search
from deltacal_gen.diagnosis.words import no_poses
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.pages import report
from deltacal_gen.physics.terms import blank
from deltacal_gen.results.diagnosis import Diagnosis, Hint, Verdict
from tests.support.left_out import channels, effect, machine, record

pytestmark = pytest.mark.usefixtures("compiled")

WEAK = 2  # seed of a recording on which play stays short of proof


@pytest.fixture(scope="module")
def weak() -> Diagnosed:
    """Play too small to be proven by these poses."""
    robot = machine()
    return diagnose(
        robot, record(robot, effect("backlash", (2,), 0.0013), n=100, of=channels(100, "approach"), seed=WEAK)
    )


def test_what_comes_near_its_price_is_a_hint_with_poses_that_would_decide(weak: Diagnosed) -> None:
    found = weak.answer()
    assert found.effects == ()
    [hint, *_] = found.hints
    assert "backlash" in (hint.name, *hint.indistinguishable_from)
    assert hint.limbs == (2,)
    assert hint.p_value < 0.05
    [entry] = [n for n in found.next_measurements if n.separates == (hint.name,)]
    assert entry.why == f"settles whether there is {hint.name}"
    assert entry.poses
    assert found.rejected


@pytest.mark.walk
def test_what_is_held_out_and_predicted_worse_is_no_name(monkeypatch: pytest.MonkeyPatch) -> None:
    robot, n, rng = machine(), 60, np.random.default_rng(4)
    made = record(robot, effect("backlash", (2,), 0.02), n=n, of=channels(n, "approach"))
    noise = lfilter([1.0], [1.0, -0.9], 0.02 * rng.standard_normal((n, 3)), axis=0)
    problem = pose_problem(
        robot,
        dataclasses.replace(made, measured=made.measured + noise),
        mechanism_of(robot).model("42"),
    )
    first = fit(problem, Prior(), drop_gross=False, must_converge=False)

    def searched() -> strategy.Outcome:
        return strategy.searched(problem, first, library(problem)[0], False, lambda text: None)

    def names(found: strategy.Outcome) -> list[str]:
        return [t.effect for t in strategy.terms_of(found.search.fit)]

    found = searched()
    assert "backlash" in names(found)
    monkeypatch.setattr(strategy, "held_out_by", _millimetres_off)
    assert names(searched()) == []


def _millimetres_off(problem: Problem, search: Search, parts: object) -> Array:
    return np.where(np.isfinite(search.fit.residual), 1.0, np.nan)


def test_noise_gives_no_hint_and_no_name() -> None:
    robot = machine()
    found = diagnose(robot, record(robot, of=channels(60, "approach"))).answer()
    assert (found.hints, found.effects) == ((), ())
    assert "Suspected" not in found.summary


@pytest.mark.parametrize("size", [9.0, 16.0, 25.0])
def test_both_errors_are_as_often_as_stated(size: float) -> None:
    rng, n, shift = np.random.default_rng(3), 4000, np.sqrt(size)
    ratios = {there: 2 * shift * (there * shift + rng.standard_normal(n)) - size for there in (0, 1)}  # on one reading
    stated = Evidence(1.0, size, size).wrong
    tolerance = 3 * np.sqrt(stated / n) + 1e-3
    assert np.mean(ratios[0] > 0) == pytest.approx(stated, abs=tolerance)
    assert np.mean(ratios[1] <= 0) == pytest.approx(stated, abs=tolerance)
    assert Evidence(1.0, size, size).speaks == (stated <= MOST_WRONG)
    assert not Evidence(-1.0, size, size).speaks
    assert [Evidence(k * 2 * np.sqrt(size), size, size).denies for k in (-1.1, -0.9, 1.0)] == [True, False, False]
    short = [Evidence(size - k * 2 * np.sqrt(size), size, size).falls_short for k in (3.1, 2.9)]
    assert short == [True, size < 16]  # where the effects are small: farther off by what the ratio scatters
    large = 100 * size  # sizes that differ from part to part are told where there are many readings, and no reason
    assert [Evidence(part * large, large, large).falls_short for part in (0.4, 0.6)] == [True, False]


def test_a_gross_error_says_no_more_than_huber_lets_it(weak: Diagnosed) -> None:
    at = weak.baseline
    before = np.zeros_like(at.residual)
    after = before.copy()
    before[0, 0], before[1, 0] = 1000 * at.sigma[0], np.nan
    assert 0 < evidence(at, before, after).ratio < 6000 < evidence(at, before, after).size
    assert evidence(at, after, before).ratio < 0


def test_a_form_whose_size_lies_between_those_that_compete_is_estimated_and_joined(weak: Diagnosed) -> None:
    robot = machine()
    made = record(robot, of=channels(60, "time"))
    first = diagnose(robot, made).baseline
    one = first.problem.body.blank("warm_up", (1, 2, 3), ("time_s", 600.0))
    search = Search(first, [one])
    between = blank("warm_up", one.limbs, ("time_s", 733.0), one.tools, one.lacks)
    assert search.where(between) == []
    assert np.abs(search.estimated(between).values).max() > 0
    left, with_it = (s.beside.residual for s in (search, search.added(between)))
    assert with_it @ with_it < left @ left - 0.1


def test_several_hints_each_earn_their_price_beside_those_before() -> None:
    robot = machine()
    two = (effect("backlash", (2,), 0.02), effect("joint_scale", (1,), 0.0004))
    found = diagnose(robot, record(robot, of=channels(60, "approach")))
    terms = [found.baseline.problem.body.blank(t.effect, (1, 2, 3)) for t in two]
    made = diagnose(robot, record(robot, *two, of=channels(60, "approach")))
    hints = hinted(Search(made.baseline, terms), 0.0)
    assert hints
    assert all(h.found.score > MARGIN for h in hints[1:])
    assert len({h.term.effect for h in hints}) == len(hints)


def test_a_search_that_ends_at_its_limit_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    for room in (selection, hints):
        monkeypatch.setattr(room, "MOST_EFFECTS", 1)
    robot = machine()
    two = (effect("backlash", (2,), 0.02), effect("distal_compliance", (1,), 0.02))
    found = diagnose(robot, record(robot, *two, of=channels(60, "approach"))).answer()
    assert len(found.effects) == 1
    assert any("the search ends at 1 effects: there is more" in hint.why for hint in found.hints)


def test_all_that_earned_their_full_price_are_hints() -> None:
    robot, of = machine(), channels(100, "approach", "temp", "payload")
    several = (
        effect("backlash", (2,), 0.02),
        effect("joint_scale", (1,), 0.002),
        effect("thermal_zero", (3,), 0.01),
        effect("distal_compliance", (1,), 0.02),
        effect("transmission_eccentricity", (2,), 0.01, 0.01, constants=(9.0,)),
    )
    made = record(robot, *several, n=100, of=of)
    problem = pose_problem(robot, made, mechanism_of(robot).model("42"))
    first = fit(problem, Prior(), drop_gross=False, must_converge=False)
    terms = [problem.body.blank(t.effect, (1, 2, 3), t.constants) for t in several]
    found = hinted(Search(first, terms), 0.0)
    assert {h.term.effect for h in found} == {t.effect for t in several}


def _earning(weak: Diagnosed, verdict: Verdict) -> Diagnosis:
    hints = [
        Hint(name=n, limbs=(2,), gain_chi2=40.0, p_value=1e-6, indistinguishable_from=(), why="", earned=e)
        for n, e in (("backlash", True), ("zero_drift", False), ("joint_scale", True))
    ]
    return dataclasses.replace(weak, verdict=verdict, hints=tuple(hints)).answer()


@pytest.mark.parametrize("verdict", ["missing_physics", "unexplained"])
def test_what_earned_its_price_is_in_the_summary_whatever_the_verdict(weak: Diagnosed, verdict: str) -> None:
    text = _earning(weak, Verdict(verdict)).summary
    assert "Suspected, not confirmed: backlash at limb 2 (p = 1e-06); joint_scale at limb 2 (p = 1e-06)" in text
    assert "zero_drift" not in text


def test_brackets_of_a_robot_file_s_tables_are_printed(weak: Diagnosed, capsys: pytest.CaptureFixture[str]) -> None:
    """They were read as markup: `limits_deg or limits_mm under  in the robot file`."""
    none = tuple(n.replace(poses=(), text=no_poses(False, 10.0, [], False)) for n in weak.next_measurements)
    told = dataclasses.replace(weak, next_measurements=none).answer()
    Terminal().show(told)
    assert "under [joints] in the robot file" in " ".join(capsys.readouterr().out.split())


def test_hints_stand_on_the_page_with_what_decides(weak: Diagnosed) -> None:
    found = weak.answer()
    page = report.diagnosis(found)
    hint = found.hints[0]
    [entry] = [n for n in found.next_measurements if n.separates == (hint.name,)]
    part = page[page.index("<h2>Suspected, not confirmed") :]
    for said in (f"{hint.name} at limb 2", f"{hint.gain_chi2:.0f}", report.power(hint.p_value), hint.why):
        assert said in part
    assert f"The {len(entry.poses)} poses below: {entry.expected_chi2:.0f} of chi² are expected" in part
    assert html.escape(found.summary, quote=False) in page
    assert "no model error found" in page
    assert found.summary.startswith("No model error proven: ")
    answer = dataclasses.replace(weak, hints=()).answer()
    without = report.diagnosis(answer)
    assert "Suspected, not confirmed" not in without
    assert html.escape(answer.summary, quote=False) in without
    assert answer.summary.startswith("No model error found: ")
