"""The selection of effects: moves that the linear machine proposes and one objective accepts."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from deltacal_gen.diagnosis import selection
from deltacal_gen.diagnosis.library import library
from deltacal_gen.diagnosis.refits import refitted, terms_of
from deltacal_gen.diagnosis.search import Search
from deltacal_gen.diagnosis.selection import Hypothesis, Selection, select
from deltacal_gen.estimation.fit import fit, rough
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import with_prior
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Recording, Robot
from deltacal_gen.physics import terms as of
from deltacal_gen.physics.terms import Term
from tests.support.concealed import Case
from tests.support.concealed import record as concealed
from tests.support.every_effect import ARM, chain
from tests.support.left_out import SIGMA, channels, effect, machine, record

SPRINGS = ("joint_compliance", "saturating_compliance")  # the simple one, and what becomes of it
WAVE = "transmission_eccentricity"
N = 120
EARLY, LATE = 40, 80  # rows after which something happens


def of_geometry(robot: Robot, made: Recording, model: str | None = None) -> Fit:
    """Return the fit of geometry alone."""
    mechanism = mechanism_of(robot)
    problem = pose_problem(robot, made, mechanism.model(model or mechanism.full_model))
    problem = with_prior(problem, robot)[0]
    start = rough(problem, must_converge=False)
    return fit(problem, Prior(), errors=start.errors, instrument=start.instrument, must_converge=False)


def selected(first: Fit, start: Sequence[Term], among: Sequence[Term] | None = None) -> Selection:
    """Return what is selected from a start with some effects."""
    begun = refitted(first.problem, first, start) if start else first
    assert begun is not None
    terms = library(first.problem)[0] if among is None else among
    found = select(first.problem, Search(begun, terms), lambda text: None)
    assert_consistent(found, first.problem)
    return found


def assert_consistent(found: Selection, problem: Problem) -> None:
    """The trace can be replayed: what was selected costs least by the one objective, which every hypothesis has."""
    costs = [selection._weighed(problem, found.search, h.white, terms_of(h.white)).cost for h in found.hypotheses]
    # a size between those that are searched is one form more to choose among
    assert costs == pytest.approx([h.cost for h in found.hypotheses], abs=0.5)
    assert costs == sorted(costs)
    assert found.search.fit is found.hypotheses[0].fit


def named(found: Selection) -> list[tuple[str, tuple[int, ...]]]:
    """Return effects and limbs of what was selected."""
    return sorted((t.effect, t.limbs) for t in terms_of(found.search.fit))


def on_all(name: str, robot: Robot) -> Term:
    """Return an effect on all limbs, blank."""
    return of.blank(name, tuple(range(1, mechanism_of(robot).limbs + 1)))


def test_two_events_each_taken_for_the_other_are_exchanged() -> None:
    robot = machine()
    time = channels(N, "time")["time_s"]
    early, late = (float(time[k]) for k in (EARLY, LATE))
    slip = effect("tool_slip", (), 0.1, -0.1, 0.2, constants=(late,))
    jump = effect("zero_jump", (3,), 0.03, constants=(early,))
    first = of_geometry(robot, record(robot, slip, jump, n=N, of=channels(N, "time")), "42")
    swapped = [
        effect("tool_slip", (), 0.1, -0.1, 0.2, constants=(early,)),
        effect("zero_jump", (1, 2, 3), 0.03, constants=(late,)),
    ]
    found = selected(first, swapped)
    # where a platform does not turn a slip of the tool is one of the instrument
    alike = {"instrument_slip": "tool_slip"}
    assert {(alike.get(t.effect, t.effect), t.limbs, t.constants) for t in terms_of(found.search.fit)} == {
        ("tool_slip", (), (late,)),
        ("zero_jump", (3,), (early,)),
    }
    assert found.search.fit.sigma[0] < 1.1 * SIGMA
    assert named(selected(first, terms_of(found.search.fit))) == named(found)  # the right two stay


def test_waves_of_a_period_give_way_to_the_one_of_them_that_is_there_and_another() -> None:
    """Taken for a shape before order 11 was known, they imitate it in part, and would leave it nothing to earn."""
    robot = machine()
    there = [effect(WAVE, (2,), 0.01, 0.0, constants=(24.0,)), effect(WAVE, (2,), 0.0, 0.006, constants=(11.0,))]
    first = of_geometry(robot, record(robot, *there, n=N), "42")
    terms = [t for t in library(first.problem)[0] if t.effect == WAVE]
    taken = [effect(WAVE, (2,), 0.0, 0.0, constants=(k,)) for k in (8.0, 16.0, 24.0)]
    assert sorted(t.constants[0] for t in terms_of(selected(first, taken, terms).search.fit)) == [11.0, 24.0]


@pytest.mark.parametrize("hardens", [True, False])
def test_a_hardening_spring_is_named_where_a_simple_one_costs_more(hardens: bool) -> None:
    arm = chain(ARM)
    simple = Case("arm", "joint_compliance", (2,), {"compliance": 0.002})
    hard = Case("arm", "saturating_compliance", (2,), {"compliance": 0.002}, {"limit": 60.0})
    true = (hard if hardens else simple).term(arm)
    first = of_geometry(arm, concealed(arm, true))
    other = of.blank(SPRINGS[0], (2,)) if hardens else of.blank(SPRINGS[1], (2,), hard.term(arm).constants)
    every = [on_all(SPRINGS[0], arm), *(t for t in library(first.problem)[0] if t.effect == SPRINGS[1])]
    assert named(selected(first, [other], every)) == [(true.effect, (2,))]


@pytest.mark.parametrize(("limbs", "wider"), [((2, 3), True), ((3,), False)])
def test_a_spring_that_is_there_already_stands_for_another_kind_of_spring(limbs: tuple[int, ...], wider: bool) -> None:
    """What twists the elbow of an arm twists its shoulder, too: that needs a kind of physics less."""
    arm = chain(ARM)
    springs = Case("arm", "joint_compliance", limbs, {"compliance": 0.002}).term(arm)
    base = Case("arm", "base_compliance", (), {"compliance_x": 0.002, "compliance_y": 0.002}).term(arm)
    first = of_geometry(arm, concealed(arm, springs, beside=() if wider else (base,)))
    start = [of.blank("base_compliance", ()), of.blank("joint_compliance", (3,))]
    found = selected(first, start, [of.blank("base_compliance", ()), on_all("joint_compliance", arm)])
    assert named(found) == [*([] if wider else [("base_compliance", ())]), ("joint_compliance", limbs)]


@pytest.mark.parametrize("soft", [True, False])
def test_axes_that_tilt_leave_their_place_to_fewer_springs_that_explain_as_much(soft: bool) -> None:
    """An axis tilts about its neighbours' axes, too: at several joints it imitates what these give."""
    arm = chain(ARM)
    given = {"compliance": 0.004} if soft else {"compliance_x": 0.004, "compliance_y": 0.005}
    true = [("joint_compliance", (2, 3)), ("link_torsion", (3,))] if soft else [("joint_tilt_compliance", (2, 4))]
    terms = [Case("arm", name, limbs, given).term(arm) for name, limbs in true]
    first = of_geometry(arm, concealed(arm, terms[0], beside=tuple(terms[1:])))
    every = [on_all(name, arm) for name in ("joint_tilt_compliance", "joint_compliance", "link_torsion")]
    tilts = of.blank("joint_tilt_compliance", (2, 4, 5) if soft else (2, 4))
    assert named(selected(first, [tilts], every)) == true


def test_a_load_is_found_though_a_wave_explains_more_at_first() -> None:
    """What a load does is a function of the joints, too, which waves imitate where poses are few."""
    robot = machine()
    first = of_geometry(robot, record(robot, effect("joint_compliance", (2,), 4e-3), n=60, of=channels(60, "payload")))
    start = [effect(WAVE, (2,), 0.01, 0.0, constants=(1.0,))]
    assert named(selected(first, start)) == [("joint_compliance", (2,))]


def test_moves_are_few_and_a_search_ends_at_its_limit(monkeypatch: pytest.MonkeyPatch) -> None:
    robot, tried = machine(), list[int]()
    weighed = selection._weighed

    def counted(*args: Any) -> Hypothesis:
        tried.append(1)
        return weighed(*args)

    monkeypatch.setattr(selection, "_weighed", counted)
    two = (effect("backlash", (2,), 0.02), effect("joint_scale", (1,), 0.002))
    first = of_geometry(robot, record(robot, *two, n=100, of=channels(100, "approach")))
    assert named(selected(first, [])) == [("backlash", (2,)), ("joint_scale", (1,))]
    assert len(tried) <= 20
    monkeypatch.setattr(selection, "MOST_EFFECTS", 1)
    assert len(named(selected(first, []))) == 1


def test_noise_that_hangs_together_costs_less_than_what_goes_with_time() -> None:
    robot, rng = machine(), np.random.default_rng(4)
    made = record(robot, n=N, of=channels(N, "time"))
    noise = np.zeros((N, 3))
    for k in range(1, N):
        noise[k] = 0.8 * noise[k - 1] + 0.03 * rng.standard_normal(3)
    first = of_geometry(robot, type(made)(**(vars(made) | {"measured": made.measured + noise})))
    found = selected(first, [])
    assert named(found) == []
    assert found.search.fit.repeats.series is not None
