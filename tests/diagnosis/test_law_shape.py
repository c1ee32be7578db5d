"""The shape of a law: the curves that it earns, and none that it does not."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

from deltacal_gen.app.demonstration import example
from deltacal_gen.diagnosis.laws.ground import Ground, Tried
from deltacal_gen.diagnosis.laws.profile import LEAST, damped, refine
from deltacal_gen.diagnosis.laws.remainder import with_remainder
from deltacal_gen.diagnosis.laws.screen import price, ranked
from deltacal_gen.diagnosis.laws.search import placed
from deltacal_gen.diagnosis.laws.shape import shaped
from deltacal_gen.diagnosis.refits import refitted
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.residuals import rms
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import read_robot
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.physics import grammar
from deltacal_gen.physics.terms import Term
from tests.support.laws import LIMB, law
from tests.support.left_out import DELTA, SIGMA, channels, machine, record

pytestmark = pytest.mark.usefixtures("compiled")

N = 90
ROBOT = machine()
OF = {
    "payload_kg": np.random.default_rng(3).uniform(0.0, 3.0, N).round(2),
    "oil_C": np.random.default_rng(4).uniform(40.0, 50.0, N).round(1),
}


def straight(*truth: Term) -> tuple[Ground, Tried]:
    """Return what geometry alone leaves of a machine with a law, and a straight line of the payload."""
    at = fit(pose_problem(ROBOT, record(ROBOT, *truth, n=N, of=OF), DELTA.model(DELTA.full_model)), Prior())
    tried = Tried("joint", grammar.single("payload", grammar.Atom("payload")), (LIMB,), 0.0, 0.0)
    quiet = dataclasses.replace(
        at, sigma=np.full(3, SIGMA), weights=np.ones(N)
    )  # as what is left once the law is known
    return Ground(at).sharper(quiet), dataclasses.replace(tried, price=price(tried, 1))


def test_a_straight_line_stays_one() -> None:
    ground, tried = straight(law("joint = c1*payload", 5e-4))
    assert shaped(ground, tried).form.functions == tried.form.functions


def test_a_bend_is_found_where_it_is() -> None:
    ground, tried = straight(law("joint = c1*payload", 3e-4), law("joint = c1*Max(payload - c2, 0)", 9e-4, 1.3))
    found = shaped(ground, tried)
    assert found.form.states == ("payload",)
    assert any(abs(k - 1.3) < 0.05 for k in found.form.constants)
    ground.term(found.target, found.form, found.limbs)  # its text is a law


def test_both_curves_of_a_product_are_found() -> None:
    ground, tried = straight(law("joint = c1*tanh(payload/c2)*exp(oil_C/c3)", 5e-7, 0.8, 7.0))
    product = grammar.product(("payload", grammar.Atom("payload")), ("oil_C", grammar.Atom("oil_C")))
    found = shaped(ground, dataclasses.replace(tried, form=product))
    saturating, growing = grammar.Atom("tanh(payload/{0})", (0.8,)), grammar.Atom("exp(oil_C/{0})", (7.0,))
    truth = ground.gain(ground.place("joint"), grammar.product(("payload", saturating), ("oil_C", growing)), (LIMB,))
    assert ground.gain(ground.place("joint"), product, (LIMB,)) < 0.97 * truth
    assert found.gain > truth - 12.0  # two parts of a form: less than that is not told


def test_what_readings_cannot_tell_apart_is_told_as_the_simplest() -> None:
    ground, tried = straight(law("joint = c1*payload", 4e-5), law("joint = c1*Max(payload - c2, 0)", 1.2e-4, 1.3))
    found = shaped(ground, tried)
    assert found.form.text == "c1*payload**2"  # a bend explains as much, and has a constant more


def test_a_sum_of_functions_is_written_and_read_again() -> None:
    curve = grammar.Curve("payload", (grammar.Atom("tanh(payload/{0})", (2.0,)), grammar.Atom("1")), (0.5,))
    assert curve.text == "(tanh(payload/{0}) + {1})"
    assert curve.constants == (2.0, 0.5)
    assert curve.with_constants((3.0, 0.7)) == grammar.Curve(
        "payload", (grammar.Atom("tanh(payload/{0})", (3.0,)), grammar.Atom("1")), (0.7,)
    )


def test_constants_are_where_the_gain_is_largest() -> None:
    ground, tried = straight(law("joint = c1*tanh(payload/c2)", 2e-3, 0.8))
    form = grammar.single("payload", grammar.Atom("tanh(payload/{0})", (2.5,), 3))
    place = ground.place("joint")
    found = refine(ground, place, dataclasses.replace(tried, form=form, gain=ground.gain(place, form, tried.limbs)))
    gains = [ground.gain(place, form.with_constants((c,)), tried.limbs) for c in np.linspace(0.4, 1.6, 121)]
    assert found.gain > max(gains) - 0.02


def test_a_state_that_modulates_a_law_is_found() -> None:
    ground, tried = straight(law("joint = c1*payload", 5e-4), law("joint = c1*payload*(oil_C - c2)", 1e-4, 45.0))
    found = shaped(ground, tried)
    assert set(found.form.states) == {"payload", "oil_C"}
    ground.term(found.target, found.form, found.limbs)  # its text is a law


def test_a_curve_of_a_state_that_nearly_goes_with_the_right_one_is_told_of_that() -> None:
    """What the arm is pulled by explains most of a function of the torque, and more with every part."""
    ground, tried = straight(law("joint = c1*tanh((torque - c2)/c3)", 1e-3, -5000.0, 2500.0))
    pull = grammar.Atom("tanh((pull_v - {0})/{1})", (-8.0, 6.0), 5)
    wrong = shaped(ground, dataclasses.replace(tried, form=grammar.single("pull_v", pull)))
    right = shaped(ground, dataclasses.replace(tried, form=grammar.single("torque", grammar.Atom("torque"))))
    assert right.form.states == ("torque",)
    assert right.score > wrong.score + 10.0


def test_what_all_limbs_do_alike_has_one_coefficient() -> None:
    """As spools that thicken: with coefficients of their own three limbs would pay for three."""
    ends = (-2.0, 2.0, 0.0, 3.0)
    ground, _ = straight(Term("law every joint = c1*q**2*payload", (), np.array([[2e-4]]), ends))
    best = next(t for t in ranked(ground) if t.target == "joint")  # of which an arm's other end says nearly the same
    assert (best.limbs, set(best.form.states)) == ((), {"q", "payload"})
    assert ground.term(best.target, best.form, best.limbs).effect.startswith("law every joint = c1*")


def test_products_count_from_within_the_range_of_a_state() -> None:
    far, near = np.linspace(40.0, 50.0, 30), np.linspace(-5.0, 5.0, 30)
    assert [a.text for a in grammar.linear("oil_C", far)] == ["oil_C", "(oil_C - {0})", "Abs(oil_C - {0})"]
    assert [a.text for a in grammar.linear("q", near)] == ["q", "Abs(q)"]
    assert grammar.linear("oil_C", far)[1].constants == (45.0,)


@pytest.mark.parametrize("count", [2, 12])
def test_a_form_may_have_many_constants(count: int) -> None:
    factors = tuple((f"Max(payload - {{{k}}}, 0)",) for k in range(count))
    form = grammar.Form(factors, tuple(np.linspace(0.1, 2.0, count)), ("payload",), 3)
    ground, _ = straight(law("joint = c1*payload", 5e-4))
    values = ground.values(form)
    assert values.shape == (N, 1, count)
    last = form.constants[-1]
    assert values[:, 0, -1] == pytest.approx(np.maximum(OF["payload_kg"] - last, 0.0))


@pytest.mark.parametrize(("true", "seen"), [("joint", "limb.rod"), ("limb.rod", "joint")])
def test_a_law_acts_where_its_form_explains_most(true: str, seen: str) -> None:
    size = 0.002 if true == "joint" else 0.2
    ground, tried = straight(law(f"{true} = c1*payload*(oil_C - c2)", size, 45.0))
    form = grammar.product(("payload", grammar.Atom("payload")), ("oil_C", grammar.Atom("(oil_C - {0})", (45.0,), 2)))
    there = placed(ground, dataclasses.replace(tried, target=seen, form=form))
    assert (there.target, there.limbs) == (true, (LIMB,))
    assert placed(ground, there) is there


def _fitted(form: str, *truth: Term, constants: tuple[float, ...] = ()) -> tuple[Fit, Tried]:
    """Return the fit with a law of one form beside geometry, and the law."""
    ground, tried = straight(*truth)
    atom = grammar.Atom(form, constants)
    tried = dataclasses.replace(tried, form=grammar.single("payload", atom))
    at = refitted(ground.problem, ground.fit, [ground.term("joint", tried.form, (LIMB,))])
    assert at is not None
    return at, tried


def _error(at: Fit, *truth: Term, of: dict[str, np.ndarray] | None = None) -> float:
    """Return the error [mm] of a fit in readings that it has not seen, exact ones, at some values of channels."""
    fresh = record(ROBOT, *truth, n=N, seed=9, sigma=0.0, of={k: v[::-1] for k, v in OF.items()} | (of or {}))
    count = sum(t.n_coefficients for t in at.problem.terms)
    problem = pose_problem(ROBOT, fresh, at.problem.names).with_terms(at.problem.terms, np.ones(count))
    return rms(problem.residual(at.errors, at.instrument, problem.poses(at.errors)))


def test_what_a_form_leaves_of_its_state_is_predicted() -> None:
    truth = law("joint = c1*payload", 3e-4), law("joint = c1*Max(payload - c2, 0)", 2e-4, 1.3)
    at, tried = _fitted("payload", *truth)
    whole = with_remainder(at, [tried])
    *_, told, rest = whole.problem.split(whole.errors)[1]
    assert told.effect == "law joint = c1*payload"
    assert rest.limbs == (LIMB,)
    assert "sqrt((payload - " in rest.effect  # bends, as the truth is one: of higher evidence than bumps
    assert _error(whole, *truth) < 0.5 * _error(at, *truth)


def test_a_form_that_leaves_nothing_has_no_remainder() -> None:
    at, tried = _fitted("payload", law("joint = c1*payload", 3e-4))
    assert with_remainder(at, [tried]) is at


def test_of_a_product_each_curve_may_leave_something() -> None:
    truth = law("joint = c1*payload*exp(oil_C/c2)", 2e-6, 9.0)
    ground, tried = straight(truth)
    product = grammar.product(("payload", grammar.Atom("payload")), ("oil_C", grammar.Atom("oil_C")))
    tried = dataclasses.replace(tried, form=product)
    at = refitted(ground.problem, ground.fit, [ground.term("joint", product, (LIMB,))])
    assert at is not None
    whole = with_remainder(at, [tried])
    assert any("(oil_C - " in t.effect and "payload" in t.effect for t in whole.problem.terms)
    assert _error(whole, truth) < 0.7 * _error(at, truth)


def test_what_another_state_changes_of_a_law_is_predicted_though_too_little_to_be_told() -> None:
    """The oil's part lies about its mean: alone and times the payload it is large, and takes itself away."""
    truth = law("joint = c1*payload", 3e-4), law("joint = c1*(oil_C - c2)*(payload - c3)", 9e-6, 45.0, 1.5)
    at, tried = _fitted("payload", *truth)
    whole = with_remainder(at, [tried])
    assert any("oil_C" in t.effect and "(payload - " in t.effect for t in whole.problem.terms)
    assert _error(whole, *truth) < 0.75 * _error(at, *truth)


def test_beyond_the_readings_a_bend_goes_on_straight() -> None:
    """A law has a sharp corner where nature's is round: a straight line beside it begins and ends elsewhere."""
    truth = law("joint = c1*sqrt((payload - c2)**2 + c3**2)", 3e-4, 1.6, 0.7)
    at, tried = _fitted("Max(payload - {0}, 0)", truth, constants=(1.6,))
    whole = with_remainder(at, [tried])
    assert any("sqrt((payload" in t.effect for t in whole.problem.terms)
    payload = {"payload_kg": np.linspace(3.0, 3.6, N)}
    assert _error(whole, truth, of=payload) < 0.5 * _error(at, truth, of=payload)


@pytest.mark.parametrize("tau", [1e-9, 0.0, -1e-9, -3.0, -1e-300])
def test_a_state_that_lags_by_no_time_or_less_is_itself(tau: float) -> None:
    """A size that is sought may step across zero, beyond which what lags would grow without bounds."""
    recording = record(ROBOT, n=60, of=channels(60, "temp", "time"))
    at = fit(pose_problem(ROBOT, recording, DELTA.model("delta/18")), Prior(), must_converge=False)
    ground = Ground(at)
    found = ground.lagged("warming", tau)
    assert np.isfinite(found).all()
    assert found.ravel() == pytest.approx(ground.states["warming"].ravel(), abs=1e-9)


@pytest.mark.parametrize("size", [1e-12, 1.0, 1e12])
def test_constants_that_do_the_same_or_nothing_have_a_step(size: float) -> None:
    """However little it is damped, and in whatever units they are: two take half of it each, one that is nowhere 0."""
    a = np.array([1.0, 2.0, -1.0])
    A = size * np.column_stack([a, a, np.zeros(3)])
    step = damped(A.T @ A, A.T @ a, LEAST)
    assert step == pytest.approx([0.5 / size, 0.5 / size, 0.0], rel=1e-6)


@pytest.mark.parametrize(("kind", "read"), [("height", False), ("position", True)])
def test_a_law_of_where_a_surface_is_touched_reads_no_height(tmp_path: Path, kind: str, read: bool) -> None:
    """All touches read the same: to move the machine by the height that it believes in undoes any misfit at all."""
    robot = read_robot(example("linear_delta") / "robot.toml")
    printer, rng = mechanism_of(robot), np.random.default_rng(5)
    bed = np.column_stack([rng.uniform(-60, 60, (40, 2)), np.zeros(40)])
    q = printer.inverse(bed, robot.tool, printer.rows(robot))[0] + 0.5 * rng.standard_normal((40, 3))
    cells = np.hstack([q / robot.joint_sign, bed[:, 2:] if kind == "height" else bed])
    names = ["height_mm"] if kind == "height" else ["x_mm", "y_mm", "z_mm"]
    file = tmp_path / "recording.csv"
    header = ",".join(["q1_mm", "q2_mm", "q3_mm", *names])
    np.savetxt(file, cells, delimiter=",", header=header, comments="")
    (tmp_path / "recording.toml").write_text(f'[measurement]\nkind = "{kind}"\n')
    problem = pose_problem(robot, read_recording(file, printer), ("endstop_1", "endstop_2", "endstop_3"))
    states = Ground(fit(problem, Prior(), must_converge=False)).states
    assert ("z" in states) is read
    assert {"x", "y"} <= set(states)


def test_a_law_found_elsewhere_is_read_where_its_state_and_place_are_others(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a part of the readings a state may be a straight line of another, and a target may move them as another."""
    two = OF["payload_kg"]
    recording = record(ROBOT, n=N, of={"payload_kg": two, "oil_C": 40.0 + 3.0 * two})
    ground = Ground(fit(pose_problem(ROBOT, recording, DELTA.model("delta/18")), Prior(), must_converge=False))
    assert "payload" in ground.states
    assert "oil_C" not in ground.states
    form = grammar.single("oil_C", grammar.Atom("oil_C"))
    assert ground.values(form).ravel() == pytest.approx(40.0 + 3.0 * two[ground.rows])
    joint, others = ground.place("joint"), [p for p in ground.places if p.target != "joint"]
    monkeypatch.setattr(Ground, "places", others)
    assert np.array_equal(ground.place("joint").columns, joint.columns)
