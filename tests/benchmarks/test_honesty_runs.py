"""The benchmark of stated figures does what it says, on a job of each sort that costs little."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from deltacal_gen.diagnosis.diagnosis import diagnose
from tests.benchmarks import honesty, sitting
from tests.benchmarks.honesty_chance import first_look
from tests.benchmarks.honesty_likelihood import likeliest, rows_of
from tests.benchmarks.honesty_nulls import ROBOT, SIGMA, SORTS, drawn, null
from tests.benchmarks.honesty_power import FALSE, _needed, preferred
from tests.benchmarks.honesty_rounds import round_of
from tests.benchmarks.honesty_starts import SORTS as SORTS_OF_ROUNDS
from tests.benchmarks.honesty_starts import start

pytestmark = pytest.mark.usefixtures("compiled")


def test_noise_is_of_unit_size_and_of_its_sort() -> None:
    rng = np.random.default_rng(1)
    for sort in ("white", "uniform", "laplace", "skewed", "AR 0.5", "AR 0.9"):
        assert np.std(drawn(sort, (20000, 3), rng)) == pytest.approx(1.0, rel=0.05), sort
    e = drawn("AR 0.9", (20000, 3), rng)
    assert np.mean(e[1:] * e[:-1]) == pytest.approx(0.9, abs=0.05)


def test_every_sort_has_recordings_of_its_own() -> None:
    made = [null(sort, 1) for sort in SORTS]
    assert len({(m.measured.tobytes(), m.measurement.sigma_mm) for m in made}) == len(SORTS)
    counts = np.unique(null("by pose", 1).pose, return_counts=True)[1]
    assert sorted(counts)[1:] == [3] * (len(counts) - 1)


def test_the_ideal_detector_needs_more_for_more_forms_and_for_surety() -> None:
    needed = [_needed(part, forms, 1) for part, forms in ((0.5, 1), (0.5, 1000), (0.95, 1000))]
    assert needed == sorted(needed)
    assert needed[0] == pytest.approx(3.29**2, rel=0.01)  # the bound itself, at which half of a normal lies beyond


def test_what_nothing_tells_from_a_rival_is_named_by_chance() -> None:
    assert preferred(0.0) == preferred(-1.0) == 0.5
    rng = np.random.default_rng(1)  # twice the logarithm of the ratio of likelihoods: mean D, deviation 2 sqrt(D)
    assert preferred(4.0) == pytest.approx(np.mean(4.0 + 4.0 * rng.standard_normal(20000) > 0), abs=0.01)


ONE = dict.fromkeys(honesty.COUNTS, 1)


def test_a_run_that_was_ended_goes_on(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    asked: list[Any] = []

    def examined(job: honesty.Job) -> dict[str, Any]:
        asked.append(job)
        if len(asked) == 5:
            raise KeyboardInterrupt
        return {
            "named": False,
            "told": True,
            "p": 0.5,
            "sigma": 0.01,
            "rows": 1.0,
            "source": "declared",
            "preferred": 0.8,
            "inside": 3,
            "of": 4,
        }

    monkeypatch.setattr(honesty, "examined", examined)
    kept = tmp_path / "kept.txt"
    how = ["--count", "1", "--jobs", "1", "--kept", str(kept)]
    assert honesty.main(how) == sitting.INTERRUPTED
    assert "named" in capsys.readouterr().out  # what is done comes out
    assert len(kept.read_text().splitlines()) == 4
    assert honesty.main(how) == 0
    assert len(asked) == 5 + len(honesty.jobs(ONE)) - 4
    assert len(set(asked)) == len(honesty.jobs(ONE))


def test_the_ideal_detector_is_as_often_wrong_as_the_tool() -> None:
    nulls = {("false", "white", k): {"named": k < 3} for k in range(honesty.ENOUGH - 1)}
    assert honesty.allowed(nulls)[0] == FALSE
    assert "assumed" in honesty.allowed(nulls)[1]
    nulls[("null", "white", 0)] = {"named": False}
    assert honesty.allowed(nulls)[0] == 3 / honesty.ENOUGH
    assert _needed(0.5, 100, 1, 0.01) < _needed(0.5, 100, 1)


def test_the_whole_has_what_was_asked_of_each_sort() -> None:
    whole, quick = ({what: both[k] for what, both in honesty.COUNTS.items()} for k in (0, 1))
    asked = honesty.jobs(whole)
    assert sum(job[:2] == ("null", "walk") for job in asked) == 300
    assert sum(job[0] == "false" for job in asked) == 2000
    assert {job[:2] for job in asked[: len(asked) // 2]} == {job[:2] for job in honesty.jobs(quick)}


@pytest.mark.parametrize("sort", ["white", "AR 0.9", "t3", "laplace", "by pose", "gross"])
def test_who_knows_the_noise_tells_it(sort: str) -> None:
    found = [likeliest(sort, k) for k in range(2)]
    assert np.mean([f.sigma for f in found]) == pytest.approx(SIGMA, rel=0.2)
    true = rows_of(0.9) if sort == "AR 0.9" else 1.0
    assert np.mean([f.rows for f in found]) == pytest.approx(true, rel=0.3)


def test_bands_are_counted_by_what_is_true() -> None:
    found = honesty.examined(("bands", "18", 0))
    assert found["of"] == 3 * honesty.NEW
    assert found["inside"] > 0.8 * found["of"]


@pytest.mark.walk
@pytest.mark.parametrize("noise", ["white", "AR 0.9"])
def test_the_first_look_has_the_p_value_of_the_whole_diagnosis(noise: str) -> None:
    made = null(noise, 1)
    found = diagnose(ROBOT, made).answer()
    assert found.search is not None
    assert first_look(made).p_value == pytest.approx(found.search.p_value, rel=0.2)


def test_no_two_p_values_are_of_the_same_recording() -> None:
    found = [honesty.examined(("chance", f"{noise}/first", k))["p"] for noise in ("white", "tails") for k in (0, 3)]
    assert len(set(found)) == len(found)
    assert all(0 < p <= 1 for p in found)


@pytest.mark.walk
@pytest.mark.parametrize("sort", ["thermal_zero", "a printer's thermal_zero", "an arm's thermal_zero"])
def test_a_round_is_compared_with_the_best_design_and_with_random_poses(sort: str) -> None:
    found = round_of(sort, 1)
    assert found["open"]
    assert found["resolvable"]
    assert 1 <= found["best"] <= found["random"]
    assert found["rows"] <= found["rows in all"]
    shown = honesty.Figures()
    shown.designs("rounds", [found])
    assert shown.shown.row_count == 4


def test_first_sessions_are_of_three_machines_and_as_users_append_them() -> None:
    assert {SORTS_OF_ROUNDS[sort][0] for sort in SORTS_OF_ROUNDS} == {"delta", "linear_delta", "serial"}
    begun = start("a printer's thermal_zero", 0)
    row = {"q1_mm": 301.5, "q2_mm": 300.0, "q3_mm": 299.0, "temp_C": 40.0, "time_s": 9999.0}
    longer = begun.extended([row])
    assert longer.joints[-1].tolist() == [301.5, 300.0, 299.0]
    assert longer.channels["temp_C"][-1] == 40.0
    assert (longer.measured[:-1] == begun.first.measured).all()
