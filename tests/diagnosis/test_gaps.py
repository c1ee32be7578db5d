"""Channels that older rows lack: a thermometer from now on; there an effect moves by as much as nobody knows."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.diagnosis.library import library
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.terms import Term, blank, load_effect, partial
from deltacal_gen.results.diagnosis import Diagnosis
from tests.support.left_out import channels, effect, machine, record

pytestmark = pytest.mark.usefixtures("compiled")

N, FROM = 60, 35  # rows, and from which on the temperature was recorded
ROBOT = machine()
BEFORE = 26.0  # degC: what nobody wrote down
LATER = np.random.default_rng(3).choice([18.0, 24.0, 30.0], N)
TIME = channels(N, "time")
WARM = effect("thermal_zero", (2,), 0.004)  # deg/K


def with_a_thermometer_since(*terms: Term) -> Recording:
    """Return readings of a machine whose temperature is known from a row on."""
    late = np.arange(N) >= FROM
    made = record(ROBOT, *terms, n=N, of=TIME | {"temp_C": np.where(late, LATER, BEFORE)})
    return dataclasses.replace(made, channels=made.channels | {"temp_C": np.where(late, LATER, np.nan)})


@pytest.fixture(scope="module")
def warm() -> Diagnosis:
    return diagnose(ROBOT, with_a_thermometer_since(WARM)).answer()


@pytest.mark.walk
def test_an_effect_of_the_channel_is_found_by_the_rows_that_have_it(warm: Diagnosis) -> None:
    (found,) = warm.effects
    assert (found.name, found.limbs) == ("thermal_zero", (2,))
    (drift,) = found.parameters  # what the other rows have is no number of the effect
    assert drift.std is not None
    assert abs(drift.value - 0.004) < 4 * drift.std < 0.001
    (kept,) = warm.physics or ()
    assert kept.gaps == (0,)
    drifted, before = np.ravel(kept.values)
    assert before == pytest.approx(drifted * (BEFORE - 20.0), rel=0.1)


@pytest.mark.walk
def test_predictions_at_temperatures_that_are_known_know_nothing_of_the_gap(warm: Diagnosis, tmp_path: Path) -> None:
    path = tmp_path / "found.json"
    path.write_text(json.dumps(warm.to_dict()), encoding="utf-8")
    fresh = record(ROBOT, WARM, n=N, seed=5, sigma=0.0, of=TIME | {"temp_C": LATER})
    assert np.sqrt(np.mean((dc.predict(path, fresh).measured - fresh.measured) ** 2)) < 0.01


@pytest.mark.walk
@pytest.mark.parametrize(
    "truth",
    [effect("zero_drift", (2,), 0.05), effect("zero_jump", (2,), 0.03, constants=(float(TIME["time_s"][FROM]),)), None],
    ids=lambda t: t.effect if t else "nothing",
)
def test_what_has_nothing_to_do_with_the_channel_is_not_named_after_it(truth: Term | None) -> None:
    found = diagnose(ROBOT, with_a_thermometer_since(*([truth] if truth else []))).answer()
    assert [e.name for e in found.effects] == ([truth.effect] if truth else [])
    assert not any("thermal" in name for e in found.effects for name in e.indistinguishable_from)


@pytest.mark.walk
def test_older_rows_without_a_payload_had_none_but_cells_here_and_there_were_lost() -> None:
    soft = effect("joint_compliance", (1, 2, 3), 0.011)
    loads = np.where(np.arange(N) < FROM, 0.0, 1.0 + np.arange(N) % 2)
    made = record(ROBOT, soft, n=N, of={"payload_kg": loads})
    found = diagnose(ROBOT, lost(made, np.arange(N) < FROM)).answer()
    assert "joint_compliance" in [e.name for e in found.effects]
    assert "blank" not in {m.name: m.missing for m in found.not_tested}.get("joint_compliance", "")
    # what is not in the library of a recording is named by no diagnosis, which would look for a law in its place
    sought, not_tested = library(pose_problem(ROBOT, lost(made, np.arange(N) % 3 == 0), ()))
    assert "joint_compliance" not in [t.effect for t in sought]
    assert "blank" in {m.name: m.missing for m in not_tested}["joint_compliance"]


def lost(made: Recording, where: np.ndarray) -> Recording:
    """Return readings whose payload nobody wrote down in some rows (N,)."""
    return dataclasses.replace(made, channels={"payload_kg": np.where(where, np.nan, made.channels["payload_kg"])})


def test_kernels_count_in_rows_with_a_gap_by_their_session() -> None:
    plain, found = load_effect("thermal_zero"), partial("thermal_zero", (), (3, 7))
    s = np.array([[4.0, 3.0], [np.nan, 3.0], [np.nan, 7.0]])  # the state, and the session
    c = np.array([[0.5, -2.0, 9.0]])
    assert found.value(s, c)[:, 0] == pytest.approx([2.0, -2.0, 9.0])
    assert found.jacobian(s, c)[:, 0] == pytest.approx(np.diag([4.0, 1.0, 1.0]))
    assert len(found.COEFFICIENTS) == len(found.BELIEVABLE) == 3 * len(plain.COEFFICIENTS)
    term = blank("thermal_zero", (1, 2), gaps=(3, 7)).with_values(np.arange(6.0))
    assert (term.plain.values.tolist(), term.plain.gaps) == ([[0.0], [3.0]], ())
