"""Physics that no one registered: the law is found, borne out, predicted from; where there is none, none is told."""

from __future__ import annotations

import dataclasses
import html
import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.diagnosis import diagnosis
from deltacal_gen.diagnosis.answer import Diagnosed
from deltacal_gen.diagnosis.laws import search
from deltacal_gen.diagnosis.laws.ground import TARGETS, Ground, Tried
from deltacal_gen.diagnosis.laws.laws import Unsure
from deltacal_gen.diagnosis.laws.told import _Drawn, told
from deltacal_gen.diagnosis.words import not_searched
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.pages import report
from deltacal_gen.pages.laws import mathml
from deltacal_gen.results.diagnosis import Diagnosis
from tests.benchmarks import laws
from tests.support.laws import LIMB, law
from tests.support.left_out import SIGMA, channels, effect, machine, record

pytestmark = pytest.mark.usefixtures("compiled")

N = 90
OF = ("temp", "time", "payload")
ROBOT = machine()
TRUTH = law("limb.rod = c1*tanh(tension_1/c2)", 0.2, 8.0)


@pytest.fixture(scope="module")
def made() -> Diagnosed:
    return diagnosis.diagnose(ROBOT, record(ROBOT, TRUTH, n=N, of=channels(N, *OF)))


@pytest.fixture(scope="module")
def found(made: Diagnosed) -> Diagnosis:
    return made.answer()


@pytest.mark.walk
def test_a_law_is_told_as_one_and_never_by_a_name(found: Diagnosis) -> None:
    assert found.verdict == "missing_physics"
    assert found.effects == ()
    (best, *_) = found.laws
    assert best.borne_out
    assert best.gain > best.charge + 10
    (term,) = best.terms
    assert (term.target, term.limbs, term.expression) == ("limb.rod", (LIMB,), "c1*tanh(tension_1/c2)")
    assert best.states == ("tension_1",)
    assert "limb.rod moves by c1*tanh(tension_1/c2) at limb 2" in found.summary


@pytest.mark.walk
def test_its_numbers_are_those_of_the_machine_in_their_units(found: Diagnosis) -> None:
    size, scale = found.laws[0].terms[0].coefficients
    assert (size.name, size.limb, size.unit) == ("c1", LIMB, "mm")
    assert (scale.name, scale.limb, scale.unit) == ("c2", None, "N")
    for c, true in ((size, 0.2), (scale, 8.0)):
        assert c.std is not None
        assert abs(c.value - true) < 4 * c.std
        assert c.std < 0.2 * true


@pytest.mark.walk
def test_predictions_come_from_the_law(found: Diagnosis, tmp_path: Path) -> None:
    path = tmp_path / "found.json"
    path.write_text(json.dumps(found.to_dict()), encoding="utf-8")
    fresh = record(ROBOT, TRUTH, n=40, seed=9, sigma=0.0, of=channels(40, *OF, seed=8))
    error = dc.predict(path, fresh).measured - fresh.measured
    assert np.sqrt(np.mean(error**2)) < 0.6 * SIGMA
    assert found.laws[0].heldout_rms_mm < 1.5 * SIGMA


@pytest.mark.walk
def test_rows_outside_its_range_are_counted_and_commands_undo_it(found: Diagnosis, tmp_path: Path) -> None:
    said: list[str] = []
    low, high = found.laws[0].range["tension_1"]
    assert low < -5 < 5 < high
    fresh = record(ROBOT, TRUTH, n=40, seed=9, sigma=0.0, of=channels(40, *OF, seed=8))
    dc.predict(found, fresh, tell=said.append)
    heavy = dataclasses.replace(fresh, channels=fresh.channels | {"payload_kg": np.full(40, 9.0)})
    dc.predict(found, heavy, tell=said.append)
    assert len([words for words in said if "outside the range in which the law was found" in words]) >= 1
    assert (dc.validate(found, heavy)["outside_law"] or 0) > 20
    # a machine commanded with the law known stands where the law's own model says it was asked to
    targets = np.array([[0.0, 0.0, -800.0], [150.0, -100.0, -850.0]])
    compensator = dc.Compensator(found)
    at, _ = compensator.channels({"payload_kg": 1.0, "temp_C": 22.0, "time_s": 100.0}, 2)
    joints = compensator.joints(targets, None, at)
    np.testing.assert_allclose(compensator.pose(joints, None, at)[0][:, :3], targets, atol=1e-6)
    text = tmp_path / "command.c"
    dc.export_compensator(found, output=text, export="c")
    assert "limb.rod = c1*tanh(tension_1/c2) at limb 2" in text.read_text(encoding="utf-8")


@pytest.mark.walk
def test_its_curve_goes_through_what_the_readings_say(found: Diagnosis) -> None:
    curve = found.laws[0].curve
    assert curve is not None
    assert (curve.state, curve.unit, curve.target_unit) == ("tension_1", "N", "mm")
    off = np.asarray(curve.partial) - np.interp(curve.seen, curve.at, curve.value)
    assert abs(np.median(off)) < 0.3 * np.std(curve.value)
    exact = 0.2 * np.tanh(np.asarray(curve.at) / 8.0)
    np.testing.assert_allclose(curve.value, exact, atol=6 * float(np.max(curve.std)) + 0.01)


@pytest.mark.walk
def test_the_band_counts_what_is_unknown_of_the_constants(made: Diagnosed, found: Diagnosis) -> None:
    """As the numbers scatter: coefficient and constant drawn together, the coefficient going with the constant."""
    curve, law = found.laws[0].curve, made.laws[0]
    assert curve is not None
    assert found.laws[0].curves == (curve,)
    [unsure] = law.unsure
    size, scale = (c.value for c in found.laws[0].terms[0].coefficients)
    alone = dataclasses.replace(law, unsure=(Unsure(*(np.zeros_like(part) for part in unsure)),))
    [by_coefficients] = told((alone,), made.final)[0].curves
    rng = np.random.default_rng(2)
    constant = float(unsure.std[0]) * rng.standard_normal(4000)
    known = np.sqrt((found.laws[0].terms[0].coefficients[0].std or 0.0) ** 2 - float(unsure.added[0]))
    slope = size + known * rng.standard_normal(4000) + float(unsure.by[0, 0]) * constant
    drawn = slope * np.tanh(np.asarray(curve.at)[:, None] / (scale + constant))
    np.testing.assert_allclose(curve.std, np.std(drawn, axis=1), rtol=0.15, atol=2e-5)
    wider = np.asarray(curve.std) / np.maximum(by_coefficients.std, 1e-9)
    assert np.max(wider[np.abs(curve.at) > 1]) > 1.2


@pytest.mark.parametrize(("level", "told_of_it"), [(0.5, True), (500.0, False)])
def test_a_level_that_geometry_would_take_over_is_left_out_of_the_band(level: float, told_of_it: bool) -> None:
    """A joint's zero stands for it, so that its constant may be anything: the curve beside it is known."""
    term = law("joint = c1*(warming + c2)", 1e-3, 3.0)
    unsure = Unsure(np.array([level]), np.zeros(1), np.array([[level**2]]), np.zeros((1, 1)))
    states = {"warming": np.linspace(0.0, 6.0, 31)}
    std = _Drawn([term], np.array([[1e-10]]), unsure).std(states, states)
    slope = 1e-5 * (states["warming"] + 3.0)
    beside = np.hypot(slope, 1e-3 * level) if told_of_it else 1e-5 * np.abs(states["warming"] - 3.0)
    np.testing.assert_allclose(std, beside, rtol=1e-3, atol=1e-9)


@pytest.mark.walk
def test_the_page_says_what_else_was_tried_and_what_it_earns(found: Diagnosis) -> None:
    law = found.laws[0]
    assert law.forms_tried
    assert law.forms_tried > 1000
    assert law.runners_up
    assert all(r.gain - r.charge < law.gain - law.charge for r in law.runners_up)
    page = report.diagnosis(found)
    part = page[page.index("What else was tried") :]
    assert f"{law.forms_tried} forms" in part
    for r in law.runners_up:
        assert r.expression in html.unescape(part)
        assert f"{r.gain - r.charge:.0f}" in part


@pytest.mark.walk
def test_every_term_of_a_law_has_its_curve(found: Diagnosis) -> None:
    law = found.laws[0]
    (curve,), (term,) = law.curves, law.terms
    other = term.replace(target="joint", expression="c1*temperature")
    two = law.replace(terms=(term, other), curves=(curve, curve.replace(term=1, state="temperature")))
    page = report.diagnosis(found.replace(laws=(two,)))
    assert page.count("<svg") == report.diagnosis(found).count("<svg") + 1
    for t in (term, other):
        assert f"<h3>{t.target}: {t.expression}</h3>" in page


def test_what_geometry_leaves_is_of_the_rows_that_the_law_was_asked_of(made: Diagnosed) -> None:
    proof, problem = made.laws[0].proof, made.baseline.problem
    alone = fit(problem.subset(np.flatnonzero(proof.train)), Prior(), drop_gross=False, must_converge=False)
    off = problem.residual(alone.errors, alone.instrument, problem.poses(alone.errors))[proof.test]
    assert made.heldout == (proof.without, proof.rms)
    assert proof.without == pytest.approx(np.sqrt(np.mean(off**2)), rel=0.15)
    assert proof.rms < 0.6 * proof.without


@pytest.mark.walk
def test_the_page_shows_it_as_mathematics_with_its_curve(found: Diagnosis) -> None:
    page = report.diagnosis(found)
    assert "A formula that nobody has registered" in page
    assert "limb.rod goes with tension_1 at limb 2" in page
    assert mathml("c1*tanh(tension_1/c2)") in page
    assert page.count("<svg") >= 3
    assert "with what was found" in page[: page.index("A formula that nobody has registered</h2>")]  # a bar
    assert "tested on, predicted from the others" in page
    assert "A smooth discrepancy" not in page  # of which the truth is one
    assert "--write-effect" in page


@pytest.mark.parametrize(
    ("expression", "parts"),
    [
        ("c1*tanh(tension_1/c2)", ["<msub><mi>c</mi><mi>1</mi></msub>", "<mi>tanh</mi>", "<mfrac>"]),
        ("c1*(q - c2)**2", ["<mo>(</mo>", "<msup>"]),
        ("c1*sqrt(Abs(x))", ["<msqrt>", "<mo>|</mo>"]),
        ("c1*Piecewise((q, q > c2), (c2, True))", ["<mtable>", "&gt;", "else"]),
        ("c1*exp(-time/c2)", ["<mo>−</mo>"]),
    ],
)
def test_every_construct_of_a_law_has_its_mathematics(expression: str, parts: list[str]) -> None:
    from xml.etree import ElementTree

    from deltacal_gen.pages.laws import mathml

    shown = mathml(expression)
    assert all(part in shown for part in parts)
    ElementTree.fromstring(shown)


@pytest.mark.walk
def test_a_form_under_which_no_machine_comes_to_rest_is_passed_over(
    made: Diagnosed, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As where a joint jumps at a torque and some pose stands on the jump: the next form is fitted."""
    real, asked = search.fitted, list[Tried]()

    def refusing(
        problem: Problem, now: search.FormulaFit, ground: Ground, tried: Tried, *how: Any
    ) -> search.FormulaFit | None:
        asked.append(tried)
        return None if len(asked) == 1 else real(problem, now, ground, tried, *how)

    monkeypatch.setattr(search, "fitted", refusing)
    grown = search.grow(made.baseline.problem, made.baseline)
    assert grown is not None
    assert grown.law[0].form.states == ("tension_1",)


@pytest.mark.walk
def test_where_the_vocabulary_explains_the_misfit_no_law_is_looked_for() -> None:
    found = dc.diagnose(ROBOT, record(ROBOT, effect("joint_compliance", (LIMB,), 0.02), of=channels(60, *OF)))
    assert [e.name for e in found.effects] == ["joint_compliance"]
    assert found.laws == ()


@pytest.mark.walk
def test_a_random_walk_is_no_law_of_time() -> None:
    recording = record(ROBOT, n=N, of=channels(N, *OF))
    walk = np.cumsum(np.random.default_rng(4).standard_normal((N, 3)), axis=0) * SIGMA
    found = dc.diagnose(ROBOT, dataclasses.replace(recording, measured=recording.measured + walk))
    assert found.laws == ()


@pytest.mark.walk
def test_a_law_with_a_form_that_has_its_part_stands_without_a_name() -> None:
    """Of warmth times the square of what a gauge reads: warmth alone, and times what it reads, cost 19 of chi2 more."""
    case = laws.generate("known", (20281126, 0, 31))
    found = dc.diagnose(case.robot, case.recording)
    assert found.effects == ()
    assert [t.expression for law in found.laws[:1] for t in law.terms] == ["c1*warming*oil_C**2"]


@pytest.mark.walk
def test_it_is_written_as_the_file_of_an_effect_that_says_the_same(found: Diagnosis, tmp_path: Path) -> None:
    import sympy as sp

    from deltacal_gen.diagnosis.laws.effect_file import effect_file
    from derive.language.effects import Effect
    from derive.mathematics.effects import effect as derived

    space: dict[str, object] = {}
    exec(effect_file(found.laws[0], Path("rod_yields.py")), space)
    effect = space["EFFECT"]
    assert isinstance(effect, Effect)
    assert (effect.name, effect.per_limb, effect.source) == ("rod_yields", True, "derive/effects/rod_yields.py")
    assert [(c.name, c.unit) for c in effect.coefficients] == [("c1", "mm")]
    tension, size = sp.Symbol("tension_1", real=True), found.laws[0].terms[0].coefficients[0].value
    moved = sp.lambdify(tension, effect.targets["limb.rod"].subs(effect.coefficients[0].symbol, size))
    curve = found.laws[0].curve
    assert curve is not None
    np.testing.assert_allclose(moved(np.asarray(curve.at)), curve.value, rtol=1e-12, atol=1e-15)
    assert derived(effect)  # its functions are there to be emitted


@pytest.mark.parametrize(
    ("target", "expression", "values", "unit"),
    [
        ("joint", "c1*torque*warming", [("c1", 2e-8, "rad/(N mm K)")], "deg/(K Nm)"),
        ("joint", "c1*Lag(torque, c2)*oil_C", [("c1", 1e-9, ""), ("c2", 300.0, "s")], "deg/(oil_C Nm)"),
        ("every joint", "c1*payload", [("c1", 2e-4, "rad/kg")], "deg/kg"),
        ("tool.z", "c1*Piecewise((time, time < c2), (c2, True))", [("c1", 1e-4, "mm/s"), ("c2", 900.0, "s")], "mm/s"),
    ],
)
def test_any_law_can_be_written_as_an_effect(
    target: str, expression: str, values: list[tuple[str, float, str]], unit: str
) -> None:
    from deltacal_gen.diagnosis.laws.effect_file import effect_file
    from deltacal_gen.physics.law import load_law
    from deltacal_gen.results.diagnosis import Law, LawCoefficient, LawTerm
    from derive.language.effects import Effect

    coefficients = tuple(LawCoefficient(name=n, limb=None, value=v, std=None, unit=u) for n, v, u in values)
    term = LawTerm(target=target, limbs=(), expression=expression, coefficients=coefficients)
    states = load_law(f"law {target} = {expression}").STATE
    figures = {"heldout_rms_mm": 0.0, "share_of_excess": 1.0, "gain": 1.0, "charge": 0.0}
    ends = dict.fromkeys(states, (10.0, 800.0))
    told = Law(terms=(term,), states=states, range=ends, alike=(), borne_out=True, **figures)
    space: dict[str, object] = {}
    exec(effect_file(told, Path("a_law.py")), space)
    effect = space["EFFECT"]
    assert isinstance(effect, Effect)
    assert effect.coefficients[0].unit == unit
    assert effect.per_limb is (target == "joint")


@pytest.mark.parametrize("target", TARGETS)
def test_a_law_of_every_target_comes_back_from_its_file(target: str) -> None:
    import sympy as sp

    from deltacal_gen.diagnosis.laws.effect_file import effect_file
    from deltacal_gen.physics.law import load_law
    from deltacal_gen.results.diagnosis import Law, LawCoefficient, LawTerm
    from derive.language.effects import Effect
    from derive.mathematics.effects import effect as derived

    expression = "c1*(tanh(payload/c2) + c3)*Max(oil_C - c4, 0)"
    known = {"c1": 2e-4, "c2": 1.5, "c3": -0.4, "c4": 41.0}
    law = load_law(f"law {target} = {expression}")
    term = LawTerm(
        target=target,
        limbs=(1,) if law.PER_LIMB else (),
        expression=expression,
        coefficients=tuple(LawCoefficient(name=n, limb=None, value=v, std=None, unit="") for n, v in known.items()),
    )
    figures = {"heldout_rms_mm": 0.0, "share_of_excess": 1.0, "gain": 1.0, "charge": 0.0}
    ends = {"payload": (0.0, 4.0), "oil_C": (37.0, 53.0)}
    told = Law(terms=(term,), states=tuple(ends), range=ends, alike=(), borne_out=True, **figures)
    space: dict[str, object] = {}
    exec(effect_file(told, Path("a_law.py")), space)
    effect = space["EFFECT"]
    assert isinstance(effect, Effect)
    assert effect.per_limb == law.PER_LIMB
    moved = effect.targets[target].subs(effect.coefficients[0].symbol, known["c1"])
    states = sorted(moved.free_symbols, key=str)
    assert list(map(str, states)) == ["oil_C", "payload"]
    oil, payload = np.linspace(37.0, 53.0, 9), np.linspace(0.0, 4.0, 9)[::-1]
    own = law.formula(known | {"oil_C": oil, "payload": payload})
    np.testing.assert_allclose(sp.lambdify(states, moved)(oil, payload), own, rtol=1e-12, atol=1e-15)
    assert derived(effect)  # its functions are there to be emitted


@pytest.mark.walk
def test_a_file_that_names_no_effect_is_refused(found: Diagnosis) -> None:
    from deltacal_gen.diagnosis.laws.effect_file import effect_file
    from deltacal_gen.errors import UsageError

    with pytest.raises(UsageError, match=r"like oil_creep\.py"):
        effect_file(found.laws[0], Path("My law.py"))


@pytest.mark.parametrize(
    ("cheaper", "left", "stands"), [(True, True, True), (False, True, False), (True, False, False)]
)
def test_a_law_hidden_by_correlated_noise_stands_where_it_costs_less(
    monkeypatch: pytest.MonkeyPatch, cheaper: int, left: int, stands: bool
) -> None:
    """It is asked for where noise of each row's own would leave something to explain."""

    def outcome(unexplained: bool) -> Any:
        return SimpleNamespace(unexplained=unexplained, spectrum=None)

    law = SimpleNamespace(cost=995.0 if cheaper else 1005.0)
    white, calm = outcome(bool(left)), outcome(False)
    monkeypatch.setattr(diagnosis, "laws", lambda found, _: SimpleNamespace(laws=(law,) if found is white else ()))
    monkeypatch.setattr(diagnosis, "deviance", lambda found: 1000.0)
    monkeypatch.setattr(diagnosis, "in_white_noise", lambda found: white)
    found, sought = diagnosis._by_law(calm, lambda text: None)
    assert found is (white if stands else calm)
    assert bool(sought.laws) is stands


@pytest.mark.walk
def test_a_joint_whose_zero_wanders_is_told_as_that_and_by_no_effect_of_time() -> None:
    """No noise of readings is like it; functions of time that follow pieces of the walk foretell nothing."""
    n, rng = 70, np.random.default_rng([7, 1])
    exact = record(ROBOT, n=n, of=channels(n, "time"), sigma=0.0, seed=0, declared=False)
    joints = exact.joints.copy()
    joints[:, LIMB - 1] -= 6e-5 * np.cumsum(rng.standard_normal(n))
    noisy = exact.measured + SIGMA * rng.standard_normal(exact.measured.shape)
    found = dc.diagnose(ROBOT, dataclasses.replace(exact, joints=joints, measured=noisy))
    assert found.verdict == "unexplained"
    assert found.effects == found.laws == ()
    assert found.location.limbs == (LIMB,)
    assert f"limb {LIMB}, whose zero follows a random walk" in found.location.text


@pytest.mark.walk
def test_readings_without_noise_leave_nothing_but_what_was_concealed() -> None:
    """What poses are not solved to is alike in neighbouring ones, and no physics; walks explain no more of it."""
    hidden = effect("zero_drift", (1, 2), 0.5), effect("thermal_zero", (3,), 0.01)
    found = dc.diagnose(ROBOT, record(ROBOT, *hidden, n=80, of=channels(80, "time", "temp"), sigma=0.0, declared=False))
    assert found.verdict == "missing_physics"
    assert {(e.name, e.limbs) for e in found.effects} == {("zero_drift", (1, 2)), ("thermal_zero", (3,))}


@pytest.mark.walk
def test_what_a_law_leaves_far_above_a_declared_noise_is_no_noise() -> None:
    """The law holds, and something else is there that no function of what was recorded explains."""
    exact = record(ROBOT, law("limb.rod = c1*tanh(tension_1/c2)", 2.0, 8.0), n=N, of=channels(N, "payload"))
    joints = exact.joints + 3e-4 * np.random.default_rng(4).standard_normal(exact.joints.shape)
    moved = record(
        ROBOT,
        law("limb.rod = c1*tanh(tension_1/c2)", 2.0, 8.0),
        n=N,
        of=channels(N, "payload"),
        joints=np.degrees(joints),
    )
    found = dc.diagnose(ROBOT, dataclasses.replace(moved, joints=exact.joints))
    assert found.laws[0].terms[0].target == "limb.rod"
    assert found.final.chi2_per_dof > 10
    assert found.verdict == "unexplained"
    assert "is measurement noise" not in found.summary
    assert "a formula beyond the registered effects" in found.summary


@pytest.mark.parametrize(
    ("ends", "spectrum", "words"),
    [(2, None, "either end of a distance"), (1, "orders", "so many orders"), (1, None, "")],
)
def test_where_no_law_is_looked_for_it_is_said_why(ends: int, spectrum: str | None, words: str) -> None:
    readings = SimpleNamespace(rows=np.zeros((5, ends), dtype=int))
    of: Any = SimpleNamespace(final=SimpleNamespace(problem=SimpleNamespace(readings=readings)), spectrum=spectrum)
    assert words in not_searched(of)
    assert bool(words) == bool(not_searched(of))
