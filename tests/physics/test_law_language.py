"""Laws in text: what they say, in which units, and that as terms they are fitted, kept and predicted from exactly."""

from __future__ import annotations

import dataclasses
import os
import re
import subprocess
import sys

import numpy as np
import pytest
import sympy as sp

from deltacal_gen.diagnosis.refits import refitted
from deltacal_gen.estimation.fit import fit, rough
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.physics.formula import FUNCTIONS, Formula, unit, written
from deltacal_gen.physics.law import load_law
from deltacal_gen.physics.terms import Term, kept_term, term_of
from derive.language import vocabulary
from tests.support.laws import law
from tests.support.left_out import channels, machine, record

PATHS = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}


@pytest.mark.parametrize(
    ("text", "units"),
    [
        ("joint = c1*torque*warming", {"c1": "rad/(N mm K)"}),
        ("limb.rod = c1*tanh(tension_1/c2)", {"c1": "mm", "c2": "N"}),
        ("joint = c1*cos(c3*q) + c2*sin(c3*q)", {"c1": "rad", "c2": "rad", "c3": "1"}),
        ("joint = c1*sin(c2*time)", {"c1": "rad", "c2": "rad/s"}),
        ("joint = c1*Lag(torque, c2)*approach", {"c1": "rad/(N mm)", "c2": "s"}),
        ("tool.z = c1*Max(oil_C - c2, 0)*exp(-time/c3)", {"c1": "mm/oil_C", "c2": "oil_C", "c3": "s"}),
        ("joint = c1*Piecewise((torque, torque > c2), (c2, True))", {"c1": "rad/(N mm)", "c2": "N mm"}),
        ("limb.arm = c1*sqrt(Abs(torque))", {"c1": "mm^0.5/N^0.5"}),
    ],
)
def test_units_are_checked_and_those_of_constants_follow(text: str, units: dict[str, str]) -> None:
    found = load_law(f"law {text}")
    assert {name: written(u) for name, u in found.units("rad").items()} == units
    assert unit(written(found.units("rad")["c1"])) == found.units("rad")["c1"]


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("joint = c1*tanh(torque)", "units do not agree in 'tanh"),
        ("joint = c1*(q + torque)", "units do not agree in 'q + torque'"),
        ("joint = torque*c1", "begins with a coefficient"),
        ("joint = c1*q**c2", "an exponent is a number"),
        ("joint = c1*__import__('os')", "no function '__import__'"),
        ("joint = c1*q.real", "'Attribute' is not of the language"),
        ("elbow = c1*q", "is no law"),
        ("limb.elbow = c1*q", "is no law"),
        ("joint.x = c1*q", "is no law"),
        ("tool.x = c1*torque", "torque_1 is that of joint 1"),
        ("reading.x = c1*torque_1", "but through the pose"),
        ("joint = c1*Lag(q*2, c2)", "by its name"),
    ],
)
def test_what_is_no_law_is_refused_by_name(text: str, said: str) -> None:
    with pytest.raises(ValueError, match=re.escape(said)):
        load_law(f"law {text}")


def test_every_function_is_what_sympy_means_by_it() -> None:
    rng = np.random.default_rng(1)
    a, b = rng.uniform(-0.9, 0.9, (2, 20))
    for name, (_, count) in FUNCTIONS.items():
        text = f"c1*{name}(a)" if count == 1 else f"c1*{name}(a, b)"
        mine = Formula(text)({"c1": 2.0, "a": a, "b": b})
        for k in range(len(a)):
            exact = sp.sympify(text).subs({"c1": 2.0, "a": a[k], "b": b[k]})
            if exact.is_real:
                assert mine[k] == pytest.approx(float(exact), abs=1e-12)
    text = "Piecewise((a, a > b), (2*b - 1, True))**2"
    both = sp.lambdify(("a", "b"), sp.sympify(text))(a, b)
    np.testing.assert_allclose(Formula(text)({"a": a, "b": b}), both)


def test_the_runtime_reads_laws_without_sympy() -> None:
    code = "import sys, deltacal_gen.physics.law as l; l.load_law('law joint = c1*q'); print('sympy' in sys.modules)"
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, env=PATHS).stdout
    assert said.strip() == "False"


@pytest.mark.parametrize(
    "truth",
    [
        law("joint = c1*torque*warming", 6e-9),
        law("limb.rod = c1*tanh(tension_1/c2)", 0.2, 8.0),
        law("joint = c1*Lag(warming, c2)", 4e-4, 400.0),
        law("tool.z = c1*Abs(x)**(1/2)", 0.02),
        law("reading.y = c1*exp(-time/c2)", 0.3, 500.0),
    ],
    ids=lambda t: t.effect,
)
def test_a_law_is_fitted_jointly_with_everything_and_found_again(truth: Term) -> None:
    robot = machine()
    recording = record(robot, truth, of=channels(60, "temp", "time", "payload"), sigma=0.002)
    problem = pose_problem(robot, recording, mechanism_of(robot).model("delta/42"))
    start = rough(problem)
    first = fit(problem, Prior(), errors=start.errors, instrument=start.instrument, drop_gross=False)
    found = refitted(problem, first, [dataclasses.replace(truth, values=np.zeros_like(truth.values))])
    assert found is not None
    assert first.sigma[0] > 1.5 * found.sigma[0]
    (term,) = found.problem.split(found.errors)[1]
    std = np.sqrt(found.covariance[found.problem.coefficients(0)[0], found.problem.coefficients(0)[0]])
    assert abs(term.values[0, 0] - truth.values[0, 0]) < 4 * std + 0.01 * abs(truth.values[0, 0])
    # what answers keep is the law
    again = term_of(kept_term(term))
    assert again.effect == truth.effect


def test_a_law_that_is_none_is_told() -> None:
    with pytest.raises(ValueError, match="units do not agree"):
        load_law("law joint = c1*tanh(torque)")


def test_limbs_may_share_the_coefficients_of_a_law() -> None:
    own, shared = load_law("law joint = c1*q"), load_law("law every joint = c1*q")
    assert (own.PER_LIMB, shared.PER_LIMB) == (True, False)
    assert (shared.ACTS_ON, shared.TARGETS, shared.STATE) == (own.ACTS_ON, own.TARGETS, own.STATE)
    with pytest.raises(ValueError, match="is no law"):
        load_law("law every tool.z = c1*time")


def test_beyond_what_was_seen_a_law_goes_on_for_half_of_it_and_stays() -> None:
    found = load_law("law joint = c1*torque")
    s = np.array([[-1000.0], [0.0], [10.0], [14.0], [16.0], [1000.0]])
    moved = found.value(s, np.ones((1, 1)), (0.0, 10.0))[:, 0]
    np.testing.assert_allclose(moved, [-5.0, 0.0, 10.0, 14.0, 15.0, 15.0])


def test_beyond_what_was_seen_a_law_changes_by_no_more_than_within() -> None:
    """What fits within explodes outside: an exponential over five scales would be a dozen times as large there."""
    found = load_law("law joint = c1*exp(torque/c2)")
    s = np.array([[0.0], [10.0], [10.5], [15.0], [-5.0]])
    moved = found.value(s, np.full((1, 1), -2.0), (2.0, 0.0, 10.0))[:, 0]
    most = np.exp(5.0)
    np.testing.assert_allclose(moved, -2 * np.array([1.0, most, np.exp(5.25), most + (most - 1.0), np.exp(-2.5)]))
    np.testing.assert_allclose(found.jacobian(s, np.ones((1, 1)), (2.0, 0.0, 10.0))[:, 0, 0], moved / -2)


def test_beyond_what_was_seen_a_wave_goes_on_and_what_it_is_weighed_by_stays() -> None:
    found = load_law("law joint = c1*torque*Heaviside(Mod(time - c2, c3) - c3/2)")
    s = np.array([[10.0, 6.0], [10.0, 1006.0], [1000.0, 1006.0], [1000.0, 1001.0]])  # torque, then time
    moved = found.value(s, np.ones((1, 1)), (0.0, 10.0, 0.0, 10.0, 0.0, 20.0))[:, 0]
    np.testing.assert_allclose(moved, [10.0, 10.0, 15.0, 0.0])


@pytest.mark.parametrize(("width", "recurs"), [(3.0, False), (12.0, False), (13.0, True)])
def test_a_wave_of_which_not_two_periods_were_seen_goes_on_straight(width: float, recurs: bool) -> None:
    found = load_law("law joint = c1*time*sin(q)")
    s = np.array([[width + 0.4, 1.0], [-0.3, 1.0], [width + 0.4, 2.5]])  # q, then time, which is seen from 0 to 2
    own = s[:, [["q", "time"].index(name) for name in found.STATE]]
    ends = {"q": (0.0, width), "time": (0.0, 2.0)}
    moved = found.value(own, np.ones((1, 1)), [e for name in found.STATE for e in ends[name]])[:, 0]
    at_end = np.sin(width + 0.4) if recurs else np.sin(width) + 0.4 * np.cos(width)
    at_zero = np.sin(-0.3) if recurs else -0.3
    np.testing.assert_allclose(moved, [at_end, at_zero, 2.5 * at_end], rtol=0.01)


def test_a_wave_with_corners_goes_on_once_a_period_was_seen() -> None:
    found = load_law("law joint = c1*Abs(Mod(time, c2) - c2/2)")
    s, size = np.array([[11.0], [9.0]]), np.ones((1, 1))
    np.testing.assert_allclose(found.value(s, size, (8.0, 0.0, 8.5))[:, 0], [1.0, 3.0])  # comes again after 8 s
    np.testing.assert_allclose(found.value(s, size, (8.0, 0.0, 7.0))[:, 0], [6.5, 5.0], rtol=1e-6)


def test_what_lags_follows_exactly_and_begins_anew_in_every_run() -> None:
    found = load_law("law joint = c1*Lag(torque, c2)")
    h, tau = np.array([3.0]), 7.0
    z, begin, end = np.array([[2.0]]), np.array([[1.0]]), np.array([[4.0]])
    after = found.step(z, begin, end, h, np.ones((1, 1)), (tau,))[0, 0]  # type: ignore[attr-defined]
    t = sp.symbols("t")
    y = sp.Function("y")
    exact = sp.dsolve(y(t).diff(t) - (1 + t - y(t)) / 7, ics={y(0): 2}).rhs.subs(t, 3)
    assert after[0] == pytest.approx(float(exact), abs=1e-12)
    assert after[1] == pytest.approx(np.exp(-3 / 7))


def test_a_wave_beside_what_lags_goes_on_straight() -> None:
    """States, and after them what is lagged, beyond the ends of two states."""
    found = load_law("law joint = c1*Lag(torque, c2)*sin(q/c3)")
    constants = (300.0, 2.0, -10.0, 10.0, -1.0, 1.0)  # torque from -10 to 10, q from -1 to 1: no whole period
    s = np.column_stack([np.linspace(-12.0, 12.0, 14), np.full(14, 1.2), np.linspace(-3.0, 3.0, 14)])
    straight = s[:, 2] * (np.sin(0.5) + 0.2 * np.cos(0.5) / 2)
    np.testing.assert_allclose(found.value(s, np.ones((14, 1)), constants)[:, 0], straight, rtol=2e-3)
    assert found.jacobian(s, np.ones((14, 1)), constants).shape == (14, 1, 1)


def test_formulas_and_effects_are_made_of_the_same_functions() -> None:
    assert {*FUNCTIONS, "Piecewise"} == {"sqrt", *(f.__name__ for f in vocabulary.FUNCTIONS)}
