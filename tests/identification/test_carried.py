"""What one session found, carried to another: what its readings bear out stays, the rest is dropped with a sentence."""

from __future__ import annotations

import numpy as np

from deltacal_gen.identification.identification import identify
from tests.support.left_out import SIGMA, channels, effect, machine, record

ROBOT = machine()
PLAY = effect("backlash", (2,), 0.02)
WARM = effect("thermal_zero", (1,), 3e-3)
POSES = 80


def _session(*terms, seed):
    of = channels(POSES, "approach", "temp", seed=seed)
    return record(ROBOT, *terms, n=POSES, seed=seed, of=of)


def test_an_effect_that_was_mended_since_is_dropped_with_a_sentence_and_the_other_stays() -> None:
    since = _session(WARM, seed=21)
    alone, carried = identify(ROBOT, since), identify(ROBOT, since, held=(PLAY, WARM))
    assert [t.effect for t in carried.fit.problem.held] == ["thermal_zero"]
    (told,) = carried.answer().physics_not_held
    assert told.name == "backlash"
    before, after = (float(word) for word in told.missing.split() if word[0].isdigit())
    assert before > 2 * after
    assert "readings that bear it out here" in told.missing
    assert carried.heldout_rms < 0.9 * alone.heldout_rms


def test_where_nothing_holds_any_more_the_answer_is_that_of_geometry_alone() -> None:
    since = _session(seed=22)
    alone, carried = identify(ROBOT, since), identify(ROBOT, since, held=(PLAY, WARM))
    assert not carried.fit.problem.held
    assert {told.name for told in carried.answer().physics_not_held} == {"backlash", "thermal_zero"}
    assert np.allclose(carried.fit.errors, alone.fit.errors, atol=1e-6)


def test_what_still_holds_stays_with_the_size_that_it_was_found_with() -> None:
    carried = identify(ROBOT, _session(PLAY, WARM, seed=23), held=(PLAY, WARM))
    assert [(t.effect, t.values.tolist()) for t in carried.fit.problem.held] == [
        (t.effect, t.values.tolist()) for t in (PLAY, WARM)
    ]
    assert not carried.answer().physics_not_held
    assert carried.heldout_rms < 2 * SIGMA
