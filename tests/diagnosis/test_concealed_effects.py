"""Effects concealed in recordings of machines of every sort: each is named, at its limb, in its size."""

from __future__ import annotations

import copy
import json
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.diagnosis import strategy
from deltacal_gen.diagnosis.refits import refitted
from deltacal_gen.diagnosis.search import Found, Search
from deltacal_gen.diagnosis.strategy import _fewer, _first, _refused, _wider
from deltacal_gen.estimation.fit import rough
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.files.robot import Robot, robot_from_dict
from deltacal_gen.identification import carried
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.physics import terms as of
from deltacal_gen.physics.terms import Term
from tests.support.concealed import Case, record
from tests.support.every_effect import ARM, LIFT, PRINTER, chain
from tests.support.left_out import machine, named

pytestmark = pytest.mark.usefixtures("compiled")

SPRINGS = ("joint_compliance", "saturating_compliance")  # the simple one, and what becomes of it
BETWEEN = 40.0  # s: of two readings, at most


def printer() -> Robot:
    return robot_from_dict(copy.deepcopy(PRINTER) | {"masses": {"carriage": 0.3, "distal_rod": 0.05, "platform": 0.4}})


MACHINES = {"delta": machine, "printer": printer, "arm": lambda: chain(ARM), "lift": lambda: chain(LIFT)}


OFFSET = {"offset_x": 0.1, "offset_y": -0.15, "offset_z": 0.2}
CASES = (
    Case("printer", "thermal_growth", (), {"expansion_distal": 2.4e-5, "expansion_base": 1.2e-5}),
    Case("arm", "thermal_growth", (), {"expansion_proximal": 2.4e-5}),
    Case("lift", "thermal_growth", (), {"expansion_proximal": 2.4e-5}),
    Case("delta", "tool_slip", (), OFFSET, {"when": 1800.0}, alike=("instrument_slip",)),
    Case("arm", "tool_slip", (), OFFSET, {"when": 1800.0}),
    Case("delta", "instrument_slip", (), OFFSET, {"when": 1800.0}, alike=("tool_slip",)),
    Case("printer", "instrument_slip", (), OFFSET, {"when": 1800.0}, alike=("tool_slip",)),
    Case("arm", "instrument_slip", (), OFFSET, {"when": 1800.0}),
    Case("delta", "joint_coupling", (3,), {"coupling": 1.5e-3}, {"of": 1}),
    Case("arm", "joint_coupling", (3,), {"coupling": 2e-3}, {"of": 2}),
    Case("lift", "joint_coupling", (2,), {"coupling": 2e-3}, {"of": 1}),  # deg per mm
    Case("delta", "saturating_compliance", (2,), {"compliance": 0.02}, {"limit": 4.0}),
    Case("arm", "saturating_compliance", (2,), {"compliance": 0.002}, {"limit": 60.0}),
    Case("delta", "warm_up", (1,), {"size": 0.06}, {"per": "time_s", "time_constant": 900.0}),
    Case("printer", "warm_up", (3,), {"size": 0.3}, {"per": "time_s", "time_constant": 900.0}),
    Case("lift", "warm_up", (1,), {"size": 0.4}, {"per": "time_s", "time_constant": 900.0}),
    Case("arm", "warm_up", (5,), {"size": 0.2}, {"per": "time_s", "time_constant": 900.0}),
    Case("arm", "link_bending", (2,), {"compliance": 2e-3}),
    Case("arm", "link_torsion", (3,), {"compliance": 5e-3}, alike=("joint_tilt_compliance",)),  # of the next joint
    Case("arm", "joint_tilt_compliance", (4,), {"compliance_x": 4e-3, "compliance_y": 5e-3}),
    Case("lift", "link_bending", (2,), {"compliance": 3e-3}),
    Case("lift", "link_torsion", (3,), {"compliance": 5e-3}, alike=("joint_tilt_compliance",)),
    Case("lift", "joint_tilt_compliance", (2,), {"compliance_x": 2e-3, "compliance_y": 3e-3}),
    Case("lift", "column_lean", (1,), {"compliance": 3e-6}),
    Case("arm", "part_tilt", (1,), {"tilt_x": 0.01, "tilt_y": -0.008}, {"of": "level_mrad"}),
    Case("delta", "part_tilt", (2,), {"tilt_x": 0.03, "tilt_y": -0.02}, {"of": "level_mrad"}),
    Case("printer", "part_tilt", (2,), {"tilt_x": 0.03, "tilt_y": -0.02}, {"of": "level_mrad"}),
)


FIRST = {c.effect: c for c in reversed(CASES)}  # where an effect is looked for first; elsewhere it takes minutes more


@pytest.mark.walk
@pytest.mark.parametrize(
    "case",
    [
        pytest.param(c, marks=() if c is FIRST[c.effect] else pytest.mark.thorough, id=f"{c.effect}-{c.machine}")
        for c in CASES
    ],
)
def test_an_effect_is_named_at_its_limbs_in_its_size(case: Case) -> None:
    robot = MACHINES[case.machine]()
    found = dc.diagnose(robot, record(robot, case.term(robot)))
    assert found["verdict"] == "missing_physics", found["summary"]
    (effect,) = found["effects"]
    if effect["name"] in case.alike:  # likelier by chance
        assert case.effect in effect["indistinguishable_from"]
        return
    assert named(found) == [(case.effect, list(case.limbs))]
    assert set(effect["indistinguishable_from"]) <= set(case.alike)
    for p in effect["parameters"]:
        true = {**case.values, **case.constants}[p["name"]]
        if p["name"] == "when":
            assert abs(p["value"] - true) < BETWEEN
        elif p["std"] is None:
            assert p["value"] == true
        else:
            assert abs(p["value"] - true) < 4 * p["std"], p
            assert p["std"] < 0.5 * abs(true), p


@pytest.mark.parametrize("machine_name", MACHINES)
def test_where_nothing_is_concealed_nothing_is_named(machine_name: str) -> None:
    robot = MACHINES[machine_name]()
    found = dc.diagnose(robot, record(robot, None, seed=2))
    assert (found["verdict"], found["effects"]) == ("adequate", []), found["summary"]


def test_of_two_springs_the_simple_one_is_fitted_first() -> None:
    simple, flexible = (of.blank(name, (1, 2), (50.0,) * k) for k, name in enumerate(SPRINGS))
    earn = (Found(flexible, 500.0, 450.0), Found(simple, 450.0, 420.0))
    assert _first(earn).term is simple
    assert _first((earn[0], Found(simple, 20.0, 5.0))).term is flexible


def test_a_hardening_spring_is_named_where_held_out_readings_refuse_a_simple_one() -> None:
    arm = chain(ARM)
    known = Case("arm", "saturating_compliance", (2,), {"compliance": 0.002}, {"limit": 60.0}).term(arm)
    model = mechanism_of(arm).full_model
    problem = pose_problem(arm, record(arm, known), mechanism_of(arm).model(model))
    first = rough(problem, must_converge=False)
    blanks = (of.blank(SPRINGS[0], (2,)), of.blank(SPRINGS[1], (2,), known.constants))
    simple, flexible = (refitted(problem, first, [b]) for b in blanks)
    assert simple is not None
    assert flexible is not None
    assert _refused(simple, flexible)
    assert not _refused(flexible, simple)
    # joint 1 stands upright: it bears nothing
    nothing = refitted(problem, first, [of.blank("joint_compliance", (1, 2))])
    assert nothing is not None


@pytest.mark.parametrize(("limbs", "wider"), [((2, 3), True), ((3,), False)])
def test_a_spring_that_is_there_already_stands_for_another_kind_of_spring(limbs: tuple[int, ...], wider: bool) -> None:
    arm = chain(ARM)
    springs = Case("arm", "joint_compliance", limbs, {"compliance": 0.002}).term(arm)
    base = Case("arm", "base_compliance", (), {"compliance_x": 0.002, "compliance_y": 0.002}).term(arm)
    m = mechanism_of(arm)
    problem = pose_problem(arm, record(arm, springs, beside=() if wider else (base,)), m.model(m.full_model))
    first = rough(problem, must_converge=False)
    blanks = [of.blank("base_compliance", ()), of.blank("joint_compliance", (3,))]
    current = refitted(problem, first, blanks)
    assert current is not None
    every = [of.blank("base_compliance", ()), of.blank("joint_compliance", tuple(range(1, m.limbs + 1)))]
    found = _wider(problem, Search(current, every), 0)
    assert (found is not None) == wider
    if found is not None:
        assert [(t.effect, t.limbs) for t in found.problem.terms] == [("joint_compliance", (2, 3))]


@pytest.mark.parametrize("soft", [True, False])
def test_axes_that_tilt_leave_their_place_to_fewer_springs_that_explain_as_much(soft: bool) -> None:
    """An axis tilts about its neighbours' axes, too: at several joints it imitates what these give."""
    arm, m = chain(ARM), mechanism_of(chain(ARM))
    given = {"compliance": 0.004} if soft else {"compliance_x": 0.004, "compliance_y": 0.005}
    named = [("joint_compliance", (2, 3)), ("link_torsion", (3,))] if soft else [("joint_tilt_compliance", (2, 4))]
    true = [Case("arm", name, limbs, given).term(arm) for name, limbs in named]
    problem = pose_problem(arm, record(arm, true[0], beside=tuple(true[1:])), m.model(m.full_model))
    tilts = refitted(
        problem, rough(problem, must_converge=False), [of.blank("joint_tilt_compliance", (2, 4, 5) if soft else (2, 4))]
    )
    assert tilts is not None
    every = [
        of.blank(name, tuple(range(1, m.limbs + 1)))
        for name in ("joint_tilt_compliance", "joint_compliance", "link_torsion")
    ]
    found = _fewer(problem, Search(tilts, every), 0)
    assert (found is not None) == soft
    if found is not None:  # what else there is earns its price beside them
        assert [(t.effect, t.limbs) for t in found.problem.terms] == named[:1]


def test_a_search_that_goes_in_circles_ends(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of three effects the third goes for the first, beside which it earns its price again."""
    one, two, three = (of.blank("joint_compliance", (limb,)) for limb in (1, 2, 3))

    def search(*terms: Term) -> Any:
        fit = SimpleNamespace(sigma=np.ones(1), terms=list(terms))
        ranked = [Found(three, 500.0, 450.0)]
        alone = [(i,) for i in range(len(terms))]
        return SimpleNamespace(
            fit=fit, effects=terms, terms=(one, two, three), ranked=lambda: ranked, grouped=lambda terms: alone
        )

    circle = iter([search(two, one), search(one), search(two), search(one), search(two)])
    monkeypatch.setattr(strategy, "terms_of", lambda fit: fit.terms)
    monkeypatch.setattr(strategy, "refitted", lambda problem, at, terms: at)
    monkeypatch.setattr(strategy, "Search", lambda fit, terms: None)
    monkeypatch.setattr(strategy, "_revised", lambda problem, given: next(circle))
    monkeypatch.setattr(strategy, "_stiffest", lambda problem, given: given)
    nothing: Any = None  # the problem, which only what is replaced here asks
    found, _ = strategy._chosen(nothing, search(one), progress=lambda text: None)
    assert found.effects == (one,)
    assert next(circle).effects == (two,)  # it was not asked again


def test_what_was_once_is_long_ago_in_numbers_that_a_file_can_hold() -> None:
    jump = of.blank("instrument_slip", (), (1800.0,)).afterwards()
    assert json.loads(json.dumps(jump.constants, allow_nan=False)) == list(jump.constants)
    arm = chain(ARM)
    problem = pose_problem(arm, record(arm, None), ())
    can, cannot = carried.usable(problem, [jump, of.blank("tool_slip", (), (1800.0,)).afterwards()])
    assert [t.effect for t in can] == ["tool_slip"]
    assert [(m.name, m.missing) for m in cannot] == [("instrument_slip", "that session: it happened once, and is past")]
