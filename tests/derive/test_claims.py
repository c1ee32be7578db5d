"""The ledger of claims: its form, its completeness, the tests it names, the command that prints it."""

from __future__ import annotations

import ast
import json
import re
import subprocess
import sys
from collections import Counter
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from deltacal_gen.app import checkout, cli
from deltacal_gen.errors import InputError, UsageError
from derive.review import command, ledger
from tests.support.ledger import ENTRY, write

ROOT = Path(__file__).resolve().parents[2]

# What each paper numbers: equations, tables, and the figures that show or state numbers.
CONTENTS = {
    "bai": (26, 5, (4, 6, 7, 8)),
    "mei": (35, 9, (5, 7, 8, 9, 11, 12)),
    "savoure": (74, 2, (5, 6, 7)),
    "traslosheros": (28, 5, (9, 10, 12)),
}


@cache
def functions_of(file: Path) -> frozenset[str]:
    """Return the names of a file's test functions, without running it."""
    found = ast.parse(file.read_text()).body
    return frozenset(f.name for f in found if isinstance(f, ast.FunctionDef) and f.name.startswith("test_"))


def test_every_paper_has_its_ledger() -> None:
    assert set(ledger.paper_names()) == set(CONTENTS)


@pytest.mark.parametrize("paper", ledger.paper_names())
def test_every_claim_names_a_test(paper: str) -> None:
    for claim in ledger.load_paper(paper).claims:
        file, name = claim.test.split("::")
        assert (ROOT / file).exists(), claim
        assert name in functions_of(ROOT / file), claim


@pytest.mark.parametrize("paper", ledger.paper_names())
def test_every_number_of_a_paper_has_a_claim(paper: str) -> None:
    equations, tables, figures = CONTENTS[paper]
    wanted = {f"eq. ({n + 1})" for n in range(equations)} | {f"Table {n + 1}" for n in range(tables)}
    wanted |= {f"Fig. {n}" for n in figures}
    found = {claim.where for claim in ledger.load_paper(paper).claims}
    assert wanted <= found
    assert not {w for w in found - wanted if w.startswith(("eq.", "Table"))}  # no number that the paper does not have


@pytest.mark.parametrize("paper", ledger.paper_names())
def test_no_claim_stands_twice(paper: str) -> None:
    seen = Counter((claim.where, claim.statement) for claim in ledger.load_paper(paper).claims)
    assert max(seen.values()) == 1


@pytest.mark.parametrize("paper", ledger.paper_names())
def test_what_is_contradicted_is_corrected(paper: str) -> None:
    for claim in ledger.load_paper(paper).claims:
        if claim.status in ("contradicted", "imprecise"):
            assert claim.printed != claim.correct, claim


# ------------------------------------------------------------------------------------------------- form and the command


@pytest.mark.parametrize(
    ("change", "problem"),
    [
        ({"wher": "eq. (1)"}, r"key 'wher' is not known"),
        ({"paper": "other"}, r"'paper' is the file's name"),
        ({"status": "wrong"}, r"is 'wrong': one of proved, verified, imprecise, contradicted"),
        ({"where": "eq. 3"}, r"is 'eq. 3': 'eq. \(N\)', 'Table N'"),
        ({"where": "section 3.2, end"}, r"'section N' was expected"),
        ({"evidence": ""}, r"key 'evidence' is '': one line"),
        ({"evidence": "one\ntwo"}, r"one line of text was expected"),
        ({"test": "test_x"}, r"'tests/FILE.py::test_NAME' was expected"),
    ],
    ids=lambda value: next(iter(value)) if isinstance(value, dict) else "",
)
def test_a_flawed_entry_is_named_with_file_and_line(tmp_path: Path, change: dict[str, str], problem: str) -> None:
    path = write(tmp_path, ENTRY, ENTRY | {"where": "Table 2"} | change)
    with pytest.raises(InputError, match=problem) as caught:
        ledger.read_paper(path)
    assert (caught.value.file, caught.value.line) == (path, 12)


def test_a_missing_key_is_named(tmp_path: Path) -> None:
    path = write(tmp_path, {key: value for key, value in ENTRY.items() if key != "printed"})
    with pytest.raises(InputError, match=r"claim 1 \(eq. \(3\)\), key 'printed' is missing"):
        ledger.read_paper(path)


@pytest.fixture
def shelf(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with two papers, in place of the package's."""
    write(tmp_path, ENTRY, ENTRY | {"where": "section 2.1", "status": "proved"})
    write(tmp_path, ENTRY | {"status": "verified"}, name="archimedes")
    monkeypatch.setattr(ledger, "folder", lambda: tmp_path)

    def answer(*arguments: object, **_: object) -> Any:
        """Answer as the process of the review does, which knows nothing of this folder."""
        return json.loads(json.dumps(command.answer([*map(str, arguments)])))

    monkeypatch.setattr(checkout, "run_review", answer)
    return tmp_path


def run(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> None:
    monkeypatch.setattr(sys, "argv", ["deltacal", "claims", *arguments])
    with pytest.raises(SystemExit) as end:
        cli.main()
    assert not end.value.code


@pytest.mark.usefixtures("shelf")
def test_json_is_the_list_and_nothing_else(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    run(monkeypatch, "--json")
    found = json.loads(capsys.readouterr().out)
    assert [(c["paper"], c["where"]) for c in found] == [
        ("archimedes", "eq. (3)"),
        ("euclid", "eq. (3)"),
        ("euclid", "section 2.1"),
    ]
    more = {"title": "Euclid, Elements", "decided": "", "ended": "", "measured": []}
    assert found[1] == {"paper": "euclid", **ENTRY, **more}
    run(monkeypatch, "--json", "--paper", "euclid", "--status", "proved")
    assert [c["where"] for c in json.loads(capsys.readouterr().out)] == ["section 2.1"]


@pytest.mark.usefixtures("shelf")
def test_the_answer_ends_with_counts(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    run(monkeypatch)
    cells = [re.findall(r"[\w-]+", line) for line in capsys.readouterr().out.splitlines()]
    lines = [words for words in cells if words]
    assert lines[-9:-4] == [
        ["status", "archimedes", "euclid"],
        ["proved", "0", "1"],
        ["verified", "1", "0"],
        ["imprecise", "0", "0"],
        ["contradicted", "0", "1"],
    ]
    assert lines[-1] == ["all", "1", "2"]


def test_a_claim_is_a_block_that_80_columns_hold(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Every entry of the real ledger: no line is wider, and no word of a statement is torn."""
    monkeypatch.setenv("COLUMNS", "80")
    run(monkeypatch, "--paper", "savoure")
    out = capsys.readouterr().out
    assert max(map(len, out.splitlines())) <= 80
    claims = ledger.load_paper("savoure").claims
    joined = " ".join(out.split())
    for claim in claims:
        assert " ".join(claim.statement.split()) in joined
    assert out.count("\ntest ") == len(claims)


def test_claims_say_how_their_tests_ended() -> None:
    from deltacal_gen import claims

    ended = ledger.decided()
    for entry in claims(paper="mei", status="contradicted"):
        end = ended[entry.test]
        assert entry.ended == f"passed {end.date}, sources {end.sources[:12]}"
        assert all(any(line.startswith(f.asserted) for f in end.figures) for line in entry.measured)


@pytest.mark.parametrize("arguments", [("claims",), ("reproduce", "bai", "-o", "papers"), ("derivation", "--all")])
def test_an_installed_package_says_that_a_checkout_is_needed(
    arguments: tuple[str, ...], monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    monkeypatch.setattr(checkout, "find_checkout", lambda: None)
    monkeypatch.chdir(tmp_path)
    more = ("-o", "reports") if arguments[0] == "derivation" else ()
    monkeypatch.setattr(sys, "argv", ["deltacal", *arguments, *more])
    with pytest.raises(SystemExit) as end:
        cli.main()
    assert end.value.code == 2
    assert "needs a source checkout" in capsys.readouterr().err
    assert not list(tmp_path.iterdir())


def test_words_and_status_choose(monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> None:
    run(monkeypatch, "--paper", "mei", "--status", "contradicted", "--search", "RANK 12", "--json")
    found = json.loads(capsys.readouterr().out)
    assert found[0]["where"] == "section 4"
    assert {c["status"] for c in found} == {"contradicted"}
    run(monkeypatch, "--search", "nowhereword", "--json")
    assert json.loads(capsys.readouterr().out) == []


def test_the_page_of_claims_holds_every_entry(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    run(monkeypatch, "-o", str(tmp_path / "claims.html"))
    out, html = capsys.readouterr().out, (tmp_path / "claims.html").read_text()
    count = sum(len(ledger.load_paper(p).claims) for p in ledger.paper_names())
    assert out.startswith(f"{count} claims\n")
    assert "claims.html" in out
    assert html.count('<article class="claim"') == count
    assert "http" not in html.replace("http://www.w3.org", "")


@pytest.mark.usefixtures("shelf")
def test_what_does_not_exist_is_refused() -> None:
    from deltacal_gen import claims

    with pytest.raises(UsageError, match=r"no paper 'plato'; known: archimedes, euclid"):
        claims(paper="plato")
    with pytest.raises(UsageError, match="no status 'true'; known: proved"):
        claims(status="true")


def test_every_deciding_test_has_an_outcome_a_day_figures_and_the_hash_of_its_sources() -> None:
    tests = {c.test for name in ledger.paper_names() for c in ledger.load_paper(name).claims}
    ended = ledger.decided()
    assert ended.keys() == tests, "run python -m tests.support.decided"
    assert {(end.outcome, end.by_project) for end in ended.values()} == {("passed", "passed")}
    assert all(len(end.sources) == 64 and len(end.date) == 10 and end.figures for end in ended.values())
    claim = next(c for c in ledger.load_paper("mei").claims if c.where == "Table 1")
    end = ended[claim.test]
    page = " ".join(ledger.page({"mei": "Mei"}, [claim]).split())
    assert f'<b class="passed">passed</b> {end.date}, sources <code title="{end.sources}">' in page
    assert f"<b>{end.figures[0].found}</b>" in page
    assert float(end.figures[0].found.split(" == ")[0]) == pytest.approx(475.34, abs=0.005)


@pytest.mark.walk
def test_the_figures_of_a_test_are_what_pytest_compared(tmp_path: Path) -> None:
    """Run apart: pytest within pytest would compile and capture for both."""
    file = tmp_path / "test_some.py"
    file.write_text(
        "import numpy as np, pytest\n"
        "@pytest.mark.parametrize('x', [1.25, 3.0])\n"
        "def test_it(x):\n"
        "    assert np.sqrt(x) < 2  # a comment\n"
        "    assert np.allclose([x, 1.0], [x, 1.0 + 1e-7], atol=1e-6)\n"
        "    assert isinstance(x, float)\n"
        "    assert np.sqrt(2) == pytest.approx(1.41, abs=0.01)\n"
    )
    script = f"from tests.support import decided; f = decided.decide([{str(file)!r}]); print(f.figures(*f.of))"
    done = subprocess.run([sys.executable, "-c", script], cwd=ROOT, capture_output=True, text=True, check=True)
    told = ast.literal_eval(done.stdout.splitlines()[-1])
    assert {figure["asserted"]: figure["found"] for figure in told} == {
        "np.sqrt(x) < 2": "1.11803 to 1.73205 < 2",
        "np.allclose([x, 1.0], [x, 1.0 + 1e-07], atol=1e-06)": "1e-07 <= 1.1e-05",
        "isinstance(x, float)": "",
        "np.sqrt(2) == pytest.approx(1.41, abs=0.01)": "1.41421 == 1.41 ± 0.01",
    }


def test_the_projects_machines_stand_where_the_independent_ones_do(monkeypatch: pytest.MonkeyPatch) -> None:
    from tests.claims import of_the_project as project

    for where, own in project.SWAPS:
        for name in own:
            monkeypatch.setattr(where, name, getattr(where, name))  # put back afterwards
    rng = np.random.default_rng(0)
    delta = project.savoure.Delta(platform=60.0, tool=(30.0, 20.0, -100.0))
    at, errors = delta.positions(1)[0], project.savoure.SCALE * rng.standard_normal(51)

    def told() -> list[np.ndarray]:
        q, p = delta.inverse(at, errors), project.mei.positions(3)
        own = project.traslosheros.closed(project.traslosheros.CALIBRATED)
        joints, shift = project.traslosheros.increments(own, project.traslosheros.workspace_points(4, rng.spawn(1)[0]))
        return [
            q,
            delta.forward(q, errors, np.r_[at, 0, 0, 0]),
            project.mei.forward(project.mei.inverse(p), project.mei.group(1)),
            project.mei.transfer(p, complete=True),
            project.bai.sensitivity(project.bai.ring(5, 0.3), np.array([80.0, 30.0, -60.0]))[0],
            project.traslosheros.observation(own, joints, shift, extra=True),
        ]

    rng = np.random.default_rng(0)
    alone = told()
    project.install()
    rng = np.random.default_rng(0)
    for ours, theirs in zip(told(), alone, strict=True):
        assert ours == pytest.approx(theirs, rel=1e-9, abs=1e-9)
        assert ours is not theirs
    assert delta.forward.__func__ is project.savoure_forward


def test_the_hash_of_sources_is_of_what_is_derived_and_of_the_test(tmp_path: Path) -> None:
    for name in (
        "derive/statics.py",
        "derive/mechanisms/delta.py",
        "generated/deltacal_kernels/delta/a.py",
        "tests/t.py",
    ):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("x = 1\n")
    before = ledger.sources(tmp_path, "tests/t.py::test_x")
    for name in ("derive/mechanisms/delta.py", "generated/deltacal_kernels/delta/a.py", "tests/t.py"):
        (tmp_path / name).write_text("x = 2\n")
        now = ledger.sources(tmp_path, "tests/t.py::test_x")
        assert now != before
        before = now
    (tmp_path / "derive/other.py").write_text("")
    (tmp_path / "tests/alone.py").write_text("")
    assert ledger.sources(tmp_path, "tests/t.py::test_x") == before
    (tmp_path / "tests/deep.py").write_text("x = 1\n")
    (tmp_path / "tests/twin.py").write_text("from tests.deep import x\n")
    (tmp_path / "tests/t.py").write_text("from tests import twin\n")
    before = ledger.sources(tmp_path, "tests/t.py::test_x")
    (tmp_path / "tests/deep.py").write_text("x = 2\n")
    assert ledger.sources(tmp_path, "tests/t.py::test_x") != before  # of what a module beside it reads
