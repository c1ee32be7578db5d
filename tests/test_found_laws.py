"""Physics that no one registered: the law is found, borne out, predicted from; where there is none, none is told."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.results.diagnosis import Diagnosis
from tests.left_out import SIGMA, channels, machine, record
from tests.test_law_language import LIMB, law

N = 90
OF = ("temp", "time", "payload")
ROBOT = machine()
TRUTH = law("limb.rod = c1*tanh(tension_1/c2)", 0.2, 8.0)


@pytest.fixture(scope="module")
def found() -> Diagnosis:
    return dc.diagnose(ROBOT, record(ROBOT, TRUTH, n=N, of=channels(N, *OF)))


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


def test_its_numbers_are_those_of_the_machine_in_their_units(found: Diagnosis) -> None:
    size, scale = found.laws[0].terms[0].coefficients
    assert (size.name, size.limb, size.unit) == ("c1", LIMB, "mm")
    assert (scale.name, scale.limb, scale.unit) == ("c2", None, "N")
    for c, true in ((size, 0.2), (scale, 8.0)):
        assert c.std is not None
        assert abs(c.value - true) < 4 * c.std
        assert c.std < 0.2 * true


def test_predictions_come_from_the_law(found: Diagnosis, tmp_path: Path) -> None:
    path = tmp_path / "found.json"
    path.write_text(json.dumps(found.to_dict()), encoding="utf-8")
    fresh = record(ROBOT, TRUTH, n=40, seed=9, sigma=0.0, of=channels(40, *OF, seed=8))
    error = dc.predict(path, fresh).measured - fresh.measured
    assert np.sqrt(np.mean(error**2)) < 0.6 * SIGMA
    assert found.laws[0].heldout_rms_mm < 1.5 * SIGMA


def test_its_curve_goes_through_what_the_readings_say(found: Diagnosis) -> None:
    curve = found.laws[0].curve
    assert curve is not None
    assert (curve.state, curve.unit, curve.target_unit) == ("tension_1", "N", "mm")
    off = np.asarray(curve.partial) - np.interp(curve.seen, curve.at, curve.value)
    assert abs(np.median(off)) < 0.3 * np.std(curve.value)
    exact = 0.2 * np.tanh(np.asarray(curve.at) / 8.0)
    np.testing.assert_allclose(curve.value, exact, atol=6 * float(np.max(curve.std)) + 0.01)


def test_where_the_vocabulary_explains_the_misfit_no_law_is_looked_for() -> None:
    from tests.left_out import effect

    found = dc.diagnose(ROBOT, record(ROBOT, effect("joint_compliance", (LIMB,), 0.02), of=channels(60, *OF)))
    assert [e.name for e in found.effects] == ["joint_compliance"]
    assert found.laws == ()


def test_a_random_walk_is_no_law_of_time() -> None:
    recording = record(ROBOT, n=N, of=channels(N, *OF))
    walk = np.cumsum(np.random.default_rng(4).standard_normal((N, 3)), axis=0) * SIGMA
    found = dc.diagnose(ROBOT, dataclasses.replace(recording, measured=recording.measured + walk))
    assert found.laws == ()
