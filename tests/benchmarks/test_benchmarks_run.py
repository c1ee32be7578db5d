"""Every contender of every benchmark computes the same numbers: no benchmark compares different work."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import numpy as np
import pytest

from deltacal_gen.machine.registry import mechanism_names
from deltacal_gen.pages import manual
from tests.benchmarks import __main__ as every
from tests.benchmarks import (
    compile,
    fuzz,
    instruments,
    motion,
    mutations,
    nonsense,
    outputs,
    scaling,
    thirty,
    truth,
)
from tests.benchmarks.works import WORKS, disagreement, works

QUICK = [name for name in WORKS if not name.endswith("_cold") and "command" not in name]


ALIKE = [name for name in QUICK if re.match("(forward|sensitivity)_(?!diamond|serial)", name)]  # one work, each machine
ALIKE += ["W1exact", "W4linear", "W7_warm", "W7cli_warm"]  # works that others do too, on other readings or started anew


@pytest.mark.walk
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.thorough if name in ALIKE else ()) for name in QUICK]
)
def test_all_contenders_agree(name: str) -> None:
    [(_, work)] = works([name], size=2)
    assert all(much <= 1 for much in disagreement(work).values())


def test_scaling_is_measured(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert scaling.main(["--most", "1000", "-o", str(tmp_path / "scaling.png")]) == 0
    assert (tmp_path / "scaling.png").stat().st_size > 10_000
    said = capsys.readouterr().out
    for words in ("two threads: W5", "linearise 200 poses"):
        assert words in said


@pytest.mark.thorough
def test_the_table_of_motion_is_printed(capsys: pytest.CaptureFixture[str]) -> None:
    motion.main(["--samples", "64", "--rows", "4000"])
    said = capsys.readouterr().out
    assert [line.split()[0] for line in said.splitlines()[1 : 1 + len(motion.REACH)]] == list(motion.REACH)
    assert "arm of six joints, ns a sample: own " in said
    assert "torque/forward" in said
    assert re.search(r"diagnosing six joints, 4000 samples: \d+\.\d s of CPU, \d+ MiB", said)


def test_the_table_of_compile_times_names_modules_that_exist() -> None:
    told = compile.read()
    assert {row["module"] for row in told} == compile.modules(), "run tests.benchmarks.compile --write"
    assert all(float(row["seconds"]) > 0 for row in told)


@pytest.mark.thorough
def test_the_table_of_all_mechanisms_is_written_as_the_manual_shows_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "measured").mkdir()
    monkeypatch.setattr(manual, "folder", lambda: tmp_path)
    names = [name for name in WORKS if name.startswith(("forward_", "sensitivity_"))]
    rows = [every.row(name, work, every.measure(work, 1, 0.0)) for name, work in works(names, size=2)]
    every.measured(rows[:-1], "one is missing", quick=True)
    assert not list((tmp_path / "measured").iterdir())
    every.measured(rows, "python -m tests.benchmarks --measured", quick=True)
    table = manual.measured("machines")
    assert [row[0] for row in table["rows"]] == [f"`{name}`" for name in mechanism_names()]
    assert all(float(cell.replace(" ", "")) > 0 for row in table["rows"] for cell in row[1:] if cell != "-")


forked = pytest.mark.skipif(sys.platform != "linux", reason="runs are forked")


@pytest.mark.walk
@forked
def test_damaged_inputs_end_as_the_contract_says(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    log = tmp_path / "log.csv"
    log.write_text("0,identify,3,\n1,validate,0,\n")  # of another sitting: these are not run again
    assert fuzz.main(["--runs", "20", "--seed", "7", "--log", str(log)]) == 0, capsys.readouterr().out
    assert [int(line.split(",")[0]) for line in log.read_text().split()] == [*range(20)]


@forked
@pytest.mark.thorough
def test_nonsense_is_not_accepted_and_outputs_are_whole(capsys: pytest.CaptureFixture[str]) -> None:
    assert nonsense.main(["--runs", "10", "--seed", "3"]) == 0, capsys.readouterr().out
    assert outputs.main(["--kills", "4"]) == 0, capsys.readouterr().out


def test_the_scale_of_truth_is_that_of_the_ranks() -> None:
    table, found = manual.measured("truth"), truth.machines()
    assert table["columns"][1:] == list(found)
    told = {name: {row[0]: row[k] for row in table["rows"]} for k, name in enumerate(table["columns"][1:], start=1)}
    for name, column in told.items():
        assert {kind: seen for kind, seen in column.items() if seen != "-"} == found[name]
    delta = told["delta/42"]
    assert delta["poses in a known frame"] == "42 of 42"
    assert delta["points of a board in an unknown place, its print's scale unknown"] == "31 of 42"
    assert delta["points of a board in an unknown place"] == "32 of 42"


def test_mistakes_are_drawn_alike_whatever_else_there_is() -> None:
    every = mutations.mistakes()
    order = mutations.drawn(3, every)
    assert order != mutations.drawn(4, every)
    some = [m for m in every if "mechanisms" in m.file]
    assert mutations.drawn(3, some) == [m for m in order if "mechanisms" in m.file]


@pytest.mark.walk
def test_an_exact_camera_is_compared_with_what_knows_more(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "camera.csv"
    assert instruments.main(["camera", "--count", "1", "-o", str(out)]) == 0
    first = out.read_text()
    assert instruments.main(["camera", "--count", "1", "-o", str(out)]) == 0  # nothing is tried again
    assert out.read_text() == first
    said = capsys.readouterr().out
    assert "within three standard deviations: 1" in said
    assert "squared error by the bound's covariance" in said


def test_the_constants_that_are_said_to_decide_are_the_ones_that_are_changed() -> None:
    every = {(module, name) for module, names in thirty.STEERING.items() for name in names}
    for module, name in every:
        own, *others = thirty.holders(module, name)
        before = [getattr(m, name) for m in (own, *others)]
        with thirty.changed(module, name, 1.3):
            assert np.all(np.asarray(getattr(own, name)) > np.asarray(before[0])), name
            assert all(getattr(m, name) is not value for m, value in zip(others, before[1:], strict=True)), name
        assert getattr(own, name) is before[0]
    page = (manual.folder() / "real.md").read_text(encoding="utf-8").partition("## The numbers that decide")[2]
    said = {name for line in page.splitlines() if line.startswith("| ") for name in re.findall(r"`([A-Z_]+)`", line)}
    assert said <= {name for _, name in every}
    assert thirty.scaled(2, 0.7) == 1
    assert thirty.scaled((4, 0.5), 1.3) == (5, 0.65)


def test_a_constant_that_shares_its_name_and_value_with_another_is_changed_alone() -> None:
    holders = {m.__name__ for m in thirty.holders("diagnosis.selection", "RIVALS")}
    assert "deltacal_gen.diagnosis.laws.laws" not in holders
