"""Papers' tables remade: the pages hold every table of the ledger, and figures are those of other computations."""

from __future__ import annotations

import json
import re
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError, UsageError
from derive.review import ledger, reproduction
from derive.review.reproduction import bai, mei, savoure
from derive.review.reproduction.sheet import Picture, Sheet
from derive.review.sources import EXAMPLES
from tests.claims import independent_bai, independent_mei, independent_traslosheros
from tests.support import remade

NUMBER = re.compile(r"-?\d+(?:\.\d+)?")


@pytest.fixture(scope="module")
def recorded() -> dict[str, remade.Tables]:
    return json.loads(remade.FILE.read_text(encoding="utf-8"))


@pytest.mark.parametrize("paper", ledger.paper_names())
def test_tables_are_as_recorded(paper: str, recorded: dict[str, remade.Tables]) -> None:
    """Word by word, and figures to one in the last digit that is shown."""
    found, wanted = remade.tables(paper), recorded[paper]
    assert found.keys() == wanted.keys(), "run python -m tests.support.remade"
    for of in found:
        for row, known in zip(found[of], wanted[of], strict=True):
            assert NUMBER.sub("#", row) == NUMBER.sub("#", known), of
            for value, before in zip(NUMBER.findall(row), NUMBER.findall(known), strict=True):
                last = 10.0 ** -len(before.partition(".")[2])
                assert float(value) == pytest.approx(float(before), abs=1.01 * last), (of, row)


def test_table_1_of_traslosheros_shows_what_is_printed_beside_what_is_simulated(
    recorded: dict[str, remade.Tables],
) -> None:
    """The printed home is not where the printed lengths and angles put it, which the simulated machine has."""
    heads, *rows = (row.split(" | ") for row in next(iter(recorded["traslosheros"].values())))
    of = {name: [float(row[heads.index(name)]) for row in rows] for name in ("paper: calibrated", "simulated")}
    nominal, calibrated = independent_traslosheros.NOMINAL, independent_traslosheros.CALIBRATED
    for name, machine in (
        ("paper: calibrated", calibrated),
        ("simulated", independent_traslosheros.closed(calibrated)),
    ):
        errors = machine.vector() - nominal.vector()
        errors[[3, 7, 11]] = np.rad2deg(errors[[3, 7, 11]])
        assert of[name] == pytest.approx(errors, abs=6e-4)
    assert of["paper: calibrated"][-3:] == [5.31, 0.31, -6.26]


@pytest.mark.walk
def test_bai_is_remade_on_one_page_twice_alike(tmp_path: Path) -> None:
    """Every table and figure of the ledger has its section with its verdicts; the same call gives the same bytes."""
    answer = dc.reproduce("bai", output=tmp_path)
    html = Path(answer.files[0]).read_text()
    done = answer.figures["remade"]
    assert isinstance(done, tuple)
    assert set(done) >= {f"Table {k}" for k in range(1, 6)} | {"Fig. 6", "Fig. 7", "Fig. 8"}
    for claim in ledger.load_paper("bai").claims:
        if re.match(r"(Table|Fig\\.) ", claim.where):
            assert f'<h2 id="{claim.where.replace(" ", "-")}">' in html
            assert claim.test.split("::")[1].replace("_", "_<wbr>") in html or claim.test.split("::")[1] in html
    dc.reproduce("bai", output=tmp_path / "again")
    assert (tmp_path / "again" / "bai.html").read_bytes() == (tmp_path / "bai.html").read_bytes()


def test_what_is_printed_stands_beside() -> None:
    """The paper's figures in the sheets are those that the independent tests typed from the text."""
    sheets = {p.of: p for p in bai.study(remade.quiet) if isinstance(p, Sheet)}
    typed = independent_bai.entries(independent_bai.TABLE_4)
    for row in sheets["Table 4"].rows:
        for i, cell in zip((1, 2, 3), row[4:], strict=True):
            assert cell == "" or float(cell) == pytest.approx(typed[f"{row[0]}_{i}"], abs=5e-4)
    # model 32 finds the machine that was simulated with Table 4, the direction of dL_1 included
    lengths = next(row for row in sheets["Table 4"].rows if row[0] == "L")
    assert [float(v) for v in lengths[1:4]] == pytest.approx([0.919, 0.110, 0.122], abs=0.01)


def test_the_condition_number_of_bai_is_the_independent_one() -> None:
    made = bai.Calibrated.simulated(np.random.default_rng(1))
    ours = bai.condition(made, bai.FINE[0], 7)[0]
    H = independent_bai.H(independent_bai.fine_poses(7, bai.START), independent_bai.MODEL_18)
    assert ours == pytest.approx(np.linalg.cond(H), rel=1e-6)


def test_mei_before_calibration_is_the_independent_one() -> None:
    """Few seeds suffice: what is compared needs none."""
    bench = mei.Bench.of_example()
    truth = mei.read_truth(EXAMPLES / "diamond" / "truth.toml", bench.robot).errors
    groups = mei.Groups(bench, truth, 2)
    for row in groups.before().rows:
        number = int(row[0])
        assert float(row[1]) == pytest.approx(
            float(independent_mei.home_error(independent_mei.group(number))), abs=1e-4
        )
        assert float(row[3]) == independent_mei.BEFORE[number - 1]
    done = groups.after()
    assert [row[1] for row in done.rows[:2]] == ["stated", "scale only"]
    assert len(done.rows) == 12


def test_savoure_has_a_curve_for_each_tool() -> None:
    parts = list(savoure.study(remade.quiet))
    assert [p.of for p in parts if isinstance(p, Picture)] == ["Fig. 5", "Fig. 6", "Fig. 7"]
    rows = next(p for p in parts if p.of == "Fig. 5" and isinstance(p, Sheet)).rows
    exact = [float(row[-1]) for row in rows if row[1] == "without noise"]
    assert max(exact) < 1e-4  # identified and inverted exactly, nothing is left


@pytest.mark.thorough
@pytest.mark.parametrize("paper", ["mei", "traslosheros"])
def test_long_pages_are_remade(paper: str, tmp_path: Path) -> None:
    answer = dc.reproduce(paper, output=tmp_path)
    done = answer.figures["remade"]
    assert isinstance(done, tuple)
    assert len(done) >= 6
    assert Path(answer.files[0]).read_text().count("<figure>") >= 3


def test_what_cannot_be_is_refused(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="no paper 'plato'"):
        dc.reproduce("plato", output=tmp_path)
    (tmp_path / "file").write_text("")
    with pytest.raises(InputError, match="a folder is needed"):
        dc.reproduce("bai", output=tmp_path / "file")
    with pytest.raises(ValueError, match="2 cells for 1 columns"):
        Sheet("Table 1", "", ("one",)).add(1, 2)


def test_tables_come_before_figures() -> None:
    page = reproduction.page("savoure", [])
    found = re.findall(r'<h2 id="([^"]+)"', page)
    assert found == ["Table-1", "Table-2", "Fig.-5", "Fig.-6", "Fig.-7"]
