"""Periodic errors that are no sine: a fundamental with its harmonics is one finding, claimed where it repeats."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from deltacal_gen.diagnosis.charges import MARGIN, charge
from deltacal_gen.diagnosis.harmonics import LONGEST, grouped, is_multiple, lowest_repeating, once, series
from deltacal_gen.pages import report, validation
from deltacal_gen.physics.terms import Term
from deltacal_gen.use.prediction import beyond_waves
from deltacal_gen.use.validation import validate
from tests.support.left_out import channels, diagnosis, effect, machine, record

pytestmark = pytest.mark.usefixtures("compiled")

ORDERS = tuple(float(k) for k in range(1, 101))
WAVE = "transmission_eccentricity"


def waves(shape: str, order: int, size: float) -> list[Term]:
    """Return a square wave or a saw tooth of joint 2 [deg] by its first orders."""
    step = 2 if shape == "square" else 1
    sizes = {m: (4 if shape == "square" else 2) / (np.pi * m) for m in range(1, 100 // order + 1, step)}
    return [
        effect(WAVE, (2,), size * a * np.cos(m), size * a * np.sin(m), constants=(float(m * order),))
        for m, a in sizes.items()
    ]


@given(st.floats(1.0, 60.0))
def test_series_are_multiples_of_fundamentals_that_repeat(least: float) -> None:
    known = series(ORDERS, least)
    for places, holds in zip(known.places, known.holds, strict=True):
        orders = [ORDERS[k] for k in places]
        assert orders[0] >= least
        assert 2 <= len(orders) <= LONGEST
        assert all(is_multiple(order, orders[0]) for order in orders)
        assert sorted(places) == list(np.flatnonzero(holds))
    assert len(set(known.places)) == len(known.places)


@given(st.floats(0.1, 6.0))
def test_what_repeats_and_what_does_not_leave_a_gap(travel: float) -> None:
    """An order is seen once where its period is the travel or longer, and to repeat over a period and a quarter."""
    assert once(travel) * travel <= 2 * np.pi * (1 + 1e-12)
    assert lowest_repeating(travel) * travel == pytest.approx(1.25 * 2 * np.pi)


def test_waves_of_one_period_are_one_finding_and_others_are_not() -> None:
    terms = [
        effect(WAVE, (2,), 0.01, 0.0, constants=(24.0,)),
        effect("backlash", (2,), 0.02),
        effect(WAVE, (2,), 0.01, 0.0, constants=(8.0,)),
        effect(WAVE, (1,), 0.01, 0.0, constants=(16.0,)),
        effect(WAVE, (2,), 0.01, 0.0, constants=(9.0,)),
        effect(WAVE, (2,), 0.01, 0.0, constants=(45.0,)),
    ]
    assert grouped(terms, lambda wave: True) == [(1,), (2, 0), (3,), (4,), (5,)]
    assert grouped(terms, lambda wave: False) == [(0,), (1,), (2,), (3,), (4,), (5,)]


def test_harmonics_are_cheaper_together() -> None:
    """Six waves chosen as one form cost less than half of six that are each chosen among a hundred orders."""
    one = effect(WAVE, (2,), 0.0, 0.0, constants=(8.0,))
    forms = len(series(ORDERS, 1.0).places)
    assert charge(one, forms, 6) + MARGIN < 0.5 * 6 * (charge(one, len(ORDERS)) + MARGIN)


@pytest.mark.walk
@pytest.mark.parametrize(("shape", "order"), [("square", 8), ("saw", 9)])
def test_a_shape_that_is_no_sine_is_named_with_what_its_fundamental_carries(shape: str, order: int) -> None:
    robot = machine()
    found = diagnosis(robot, record(robot, *waves(shape, order, 0.01), n=120))
    assert found.verdict == "missing_physics"
    assert not found.laws
    assert {(e.name, e.limbs) for e in found.effects} == {(WAVE, (2,))}
    first, *harmonics = found.effects
    orders = [p.value for e in found.effects for p in e.parameters if p.name == "order"]
    assert orders[0] == order
    assert len(harmonics) >= 3
    assert {e.harmonic_of for e in harmonics} == {float(order)}
    assert first.harmonic_of is None
    assert set(orders) <= {float(t.constants[0]) for t in waves(shape, order, 1.0)}
    assert all(p.std is None for e in harmonics for p in e.parameters if p.name == "order")
    assert found.findings == (first,)
    assert found.harmonics(first) == tuple(harmonics)
    told = f"(transmission_eccentricity) at limb 2, no sine: {order} periods a turn, with harmonics {orders[1]:g}, "
    assert told in found.summary
    page = report.diagnosis(found)
    assert page.count(told) == 1
    assert found.final.heldout_rms_mm is not None
    assert found.final.heldout_rms_mm < 0.016  # of .01 noise; three waves leave .02


@pytest.mark.walk
@pytest.mark.parametrize(("order", "seen"), [(3, False), (24, True)])
def test_a_wave_that_was_not_seen_to_repeat_is_told_as_such(order: int, seen: bool) -> None:
    robot = machine()
    read = record(robot, effect(WAVE, (2,), 0.3, 0.0, constants=(float(order),)), n=120)
    found = diagnosis(robot, read)
    assert [e.name for e in found.effects] == [WAVE]
    assert ("not seen to repeat" in found.summary) is not seen
    # where its joint was never read it is anything: predictions there say so
    assert (found.effects[0].read_deg is None) is seen
    assert beyond_waves(found, read) == ()
    turn = np.radians(15.0) * (np.arange(read.n_rows) == np.argmax(read.joints[:, 1]))
    farther = dataclasses.replace(read, joints=read.joints + turn[:, None] * [0, 1, 0])
    told = beyond_waves(found, farther)
    assert [(t.limb, t.readings) for t in told] == ([] if seen else [(2, 1)])
    checked = validate(found, farther)
    for shown in (" ".join(checked.told), " ".join(validation.page(checked).split())):  # on the screen and the page
        assert ("was not seen to repeat, and is not known there" in shown) is not seen


@pytest.mark.walk
def test_several_waves_are_told_in_one_phrase_by_their_orders() -> None:
    """Each had a phrase of its own, without its order: one joint had `a periodic error` three times over."""
    robot = machine()
    slow, fine = (effect(WAVE, (2,), size, 0.0, constants=(order,)) for size, order in ((0.3, 3.0), (0.03, 24.0)))
    found = diagnosis(robot, record(robot, slow, fine, n=120))
    assert [e.limbs for e in found.effects] == [(2,), (2,)]
    assert found.summary.count("periodic error of the transmission") == 1
    assert "of orders 3 at limb 2, 24 at limb 2, of which 3 was not seen to repeat: any smooth" in found.summary


def test_joints_that_hardly_move_show_no_period() -> None:
    robot = machine()
    joints = np.random.default_rng(2).uniform(-1.5, 1.5, (60, 3))
    found = diagnosis(robot, record(robot, effect("backlash", (2,), 0.03), joints=joints, of=channels(60, "approach")))
    [only] = found.effects
    assert {only.name, *only.indistinguishable_from} >= {"backlash"}
    assert only.limbs == (2,)


def test_one_sine_stays_one_effect() -> None:
    robot = machine()
    found = diagnosis(robot, record(robot, effect(WAVE, (2,), 0.006, 0.004, constants=(8.0,)), n=60))
    assert [(e.name, e.limbs, e.harmonic_of) for e in found.effects] == [(WAVE, (2,), None)]
