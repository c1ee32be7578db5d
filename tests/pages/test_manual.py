"""The manual says what the program does: commands exist, blocks run and print what is shown, links lead somewhere.

A block of a page is tried where its first line says so:

* ``bash run``: lines that begin with ``deltacal`` or ``cd``, run one after the other in a folder of the page's own;
* ``python run``: run there too, with the names of the page's blocks before it;
* ``LANGUAGE file=NAME``: written there under that name;
* ``output``: what the block before printed, or parts of it, with ``...`` for what is left out. Numbers may differ in
  the third digit.

All other blocks are read: commands and options must exist, Python must compile and name what there is.
"""

from __future__ import annotations

import contextlib
import importlib.util
import io
import json
import os
import re
import shlex
import subprocess
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import pytest
from cyclopts import App

import deltacal_gen as dc
from deltacal_gen.app.cli.application import application
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.pages import manual
from deltacal_gen.results.reader import read_answer
from deltacal_gen.results.written import Receipt
from tests.support.commands import Run
from tests.support.measured import write

ROOT = Path(__file__).resolve().parents[2]
README = ROOT / "README.md"
PAGES = (manual.CONTENTS, *manual.topics())
TOOLS = ("pytest", "ruff", "mypy", "mkdocs", "venv", "pip")  # modules of others that pages run
ALIKE = 0.01  # numbers of two machines
_FENCE = re.compile(r"^( *)```(.*)\n((?:.*\n)*?)\1```$", re.MULTILINE)
_SPAN = re.compile(r"`((?:deltacal|make|python -m) [^`]+)`")
_NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
_FRAME = re.compile(r"[\u2500-\u257f]")  # of tables


@dataclass(frozen=True)
class Block:
    """A fenced block: its first line's words, its text, and where it begins."""

    info: tuple[str, ...]
    text: str
    line: int

    @property
    def file(self) -> str | None:
        return next((word.removeprefix("file=") for word in self.info if word.startswith("file=")), None)

    @property
    def runs(self) -> bool:
        return "run" in self.info


@cache
def deltacal() -> App:
    """Return the command line with all its commands and their options."""
    return application(["--install-completion"])


def anchor(heading: str) -> str:
    """Return the anchor of a heading, as GitHub has it: its words in small letters, joined by hyphens."""
    return re.sub(r"[^\w\s-]", "", heading.lower()).strip().replace(" ", "-")


def source(topic: str) -> str:
    return manual.source(topic)


def blocks(text: str) -> Iterator[Block]:
    for found in _FENCE.finditer(text):
        body = "".join(line.removeprefix(found[1]) for line in found[3].splitlines(keepends=True))
        yield Block(tuple(found[2].split()), body, text.count("\n", 0, found.start()) + 1)


def commands(block: Block) -> Iterator[list[str]]:
    """Yield the command lines of a block, without comments; a backslash goes on in the next line."""
    for line in block.text.replace("\\\n", " ").splitlines():
        if words := shlex.split(line, comments=True):
            yield words


# ------------------------------------------------------------------------------------------------- what a page shows


@pytest.mark.walk
@pytest.mark.parametrize("topic", PAGES)
def test_blocks_run_and_print_what_the_page_shows(
    topic: str, run: Run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "120")
    monkeypatch.setattr(os, "cpu_count", lambda: 1)  # workers change no result, but each imports everything first
    names: dict[str, Any] = {"__name__": "page"}
    printed = ""
    for block in blocks(source(topic)):
        where = f"{topic}.md, line {block.line}"
        if block.file is not None:
            Path(block.file).parent.mkdir(parents=True, exist_ok=True)
            Path(block.file).write_text(block.text, encoding="utf-8")
        elif block.info[:1] == ("output",):
            assert missing(block.text, printed) == "", f"{where}: this is printed now:\n{printed}"
        elif block.runs and block.info[0] == "bash":
            printed = ""
            for words in commands(block):
                if words[0] == "cd":
                    monkeypatch.chdir(Path.cwd() / words[1])
                    continue
                assert words[0] == "deltacal", where
                code, out, err = run(*words[1:])
                assert code == 0, f"{where}: {' '.join(words)}\n{err}"
                printed += out
        elif block.runs:
            assert block.info[0] == "python", where
            told = io.StringIO()
            with contextlib.redirect_stdout(told):
                exec(compile(block.text, where, "exec"), names)
            printed = told.getvalue()


def missing(shown: str, printed: str) -> str:
    """Return the first part of `shown`, between its dots, that does not stand in `printed` after those before it."""
    have, at = _FRAME.sub(" ", printed).split(), 0
    for part in re.split(r"^ *\.\.\. *$", _FRAME.sub(" ", shown), flags=re.MULTILINE):
        want = part.split()
        while at + len(want) <= len(have) and not all(map(_same, want, have[at:])):
            at += 1
        if at + len(want) > len(have):
            return part
        at += len(want)
    return ""


def _same(want: str, have: str) -> bool:
    a, b = ([float(n) for n in _NUMBER.findall(word)] for word in (want, have))
    if _NUMBER.sub("0", want) != _NUMBER.sub("0", have) or len(a) != len(b):
        return False
    return all(abs(x - y) <= ALIKE * max(abs(x), abs(y)) for x, y in zip(a, b, strict=True))


def test_what_is_shown_is_compared_in_earnest() -> None:
    printed = "┃ n ┃ rms ┃\n│ 3 │ 0.1234 │\nwritten to a.json\n"
    assert missing("n rms\n3 0.1233\n...\nto a.json", printed) == ""
    assert missing("3 0.13", printed)
    assert missing("3 0.1234\nwritten to b.json", printed)
    assert missing("written\n...\nn rms", printed).split() == ["n", "rms"]


# ------------------------------------------------------------------------------------------------- what a page names


@pytest.mark.parametrize("topic", [*PAGES, "README"])
def test_commands_options_and_names_of_a_page_exist(topic: str) -> None:
    text = README.read_text(encoding="utf-8") if topic == "README" else manual.read(topic).text
    for block in blocks(text):
        where = f"{topic}.md, line {block.line}"
        if block.info[:1] == ("bash",):
            for words in commands(block):
                _known(words, where, whole=True)
        elif block.info[:1] == ("python",):
            compile(block.text, where, "exec")
            assert set(re.findall(r"\bdc\.(\w+)", block.text)) <= set(dir(dc)), where
    for span in _SPAN.findall(_FENCE.sub("", text)):
        _known(shlex.split(span), f"{topic}.md: {span}", whole=False)


def _known(words: list[str], where: str, *, whole: bool) -> None:
    """Assert that a command exists with its options; `whole`: that it could be run as it stands."""
    if words[0] == "make":
        assert f"\n{words[1]}:" in (ROOT / "Makefile").read_text(), where
    elif words[:2] == ["python", "-m"] and words[2] in TOOLS:
        assert importlib.util.find_spec(words[2]) is not None, where
    elif words[0] == "python":
        place = ROOT / words[2].replace(".", "/")
        assert words[1] == "-m", where
        assert place.with_suffix(".py").exists() or (place / "__main__.py").exists(), where
        program = (place / "__main__.py" if place.is_dir() else place.with_suffix(".py")).read_text()
        assert all(f'"{option}"' in program for option in words[3:] if option.startswith("--")), where
    elif words[0] == "deltacal":
        command, rest = deltacal(), words[1:]
        while rest and not rest[0].startswith("-") and rest[0] in command:
            command, rest = command[rest[0]], rest[1:]
        known = command.assemble_argument_collection() if command.default_command else ()
        options = {
            *command.help_flags,
            *command.version_flags,
            *(name for argument in known for name in argument.names),
        }
        given = {word for word in rest if re.fullmatch(r"--?[a-z][\w-]*", word)}
        assert given <= options, f"{where}: {sorted(given - options)}"
        if whole and "..." not in rest:
            deltacal().parse_args(words[1:], exit_on_error=False, print_error=False)
    else:
        assert words[0] in ("cd", "pip", "cc"), where


@pytest.mark.parametrize("topic", PAGES)
def test_links_of_a_page_lead_somewhere(topic: str) -> None:
    text = _FENCE.sub("", manual.read(topic).text)
    for target in re.findall(r"\]\(([^)]+)\)", text):
        name, _, part = target.partition("#")
        assert (manual.folder() / name).resolve().is_file(), target
        if name.endswith((".md", ".py")):
            assert Path(name).stem in PAGES, target
            headings = re.findall(r"^#+ (.*)$", _FENCE.sub("", source(Path(name).stem)), re.MULTILINE)
            assert not part or part in map(anchor, headings), target


def test_links_of_the_readme_lead_somewhere_and_it_is_short() -> None:
    text = README.read_text(encoding="utf-8")
    assert len(text.splitlines()) <= 150
    for target in re.findall(r"\]\(([^)#]+)", _FENCE.sub("", text)):
        assert (ROOT / target).exists(), target
    for picture in re.findall(r"!\[[^\]]*\]\(([^)]+)\)", text):
        assert picture.startswith("src/deltacal_gen/examples/"), picture


def test_every_page_and_every_table_has_its_place() -> None:
    assert sorted(manual.topics()) == sorted({p.stem for p in manual.folder().glob("*.[mp][dy]")} - {manual.CONTENTS})
    used = [name for topic in PAGES for name in re.findall(r"^<!-- measured (\w+) -->$", source(topic), re.MULTILINE)]
    assert sorted(used) == sorted(path.stem for path in (manual.folder() / "measured").glob("*.json"))
    for topic in PAGES:
        page = manual.read(topic)
        assert source(topic).startswith("# "), topic
        assert page.summary, topic
        assert not page.summary.startswith(("#", "`", "|", "-")), topic
        assert max(len(line) for line in source(topic).splitlines() if not line.startswith("|")) <= 120, topic


def test_a_page_shows_its_tables_cell_by_cell() -> None:
    for name in (path.stem for path in (manual.folder() / "measured").glob("*.json")):
        table = manual.measured(name)
        (topic,) = (t for t in PAGES if f"<!-- measured {name} -->\n" in source(t))
        rows = [line.strip("| ").split(" | ") for line in manual.read(topic).text.splitlines() if line.startswith("| ")]
        for row in (table["columns"], *table["rows"]):
            assert [str(cell) for cell in row if cell] in [[c.strip() for c in r if c.strip("| ")] for r in rows], name


def test_what_measures_writes_what_the_manual_reads(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "measured").mkdir()
    (tmp_path / "index.md").write_text("# Contents\n\nAll.\n\n## Part\n\n- [Page](page.md)\n")
    (tmp_path / "page.md").write_text("# Page\n\nA sentence.\n\n<!-- measured few -->\n")
    monkeypatch.setattr(manual, "folder", lambda: tmp_path)
    manual.parts.cache_clear()
    try:
        write("few", ("what", "time"), [("one µ", "1.5 s"), ("two", "12 s")], "make bench", note="a note")
        text = manual.read("page").text
    finally:
        manual.parts.cache_clear()
    assert "| what | time |\n| --- | ---: |\n| one µ | 1.5 s |\n| two | 12 s |\n" in text
    assert "*Measured by `make bench`; Python " in text
    assert text.endswith("; a note.*\n")


# ---------------------------------------------------------------------------------------------- terminal and site


def test_a_topic_is_printed_and_an_unknown_one_is_answered_with_the_nearest(run: Run) -> None:
    code, out, _ = run("manual", "diagnose")
    assert code == 0
    assert out == dc.manual("diagnose") == manual.read("diagnose").text
    assert run("manual")[1] == dc.manual()
    assert all(f"({topic}." in dc.manual() for topic in manual.topics())
    code, out, err = run("manual", "diagnos")
    assert (code, out) == (2, "")
    assert "diagnose" in err
    with pytest.raises(UsageError, match="printer"):
        dc.manual("klipper")
    said = read_answer(json.loads(run("manual", "limits", "--json")[1]))
    assert isinstance(said, Receipt)
    assert (said.figures["topic"], said.text) == ("limits", dc.manual("limits"))


def test_units_in_tables_and_help_are_not_taken_for_markup(run: Run) -> None:
    assert "size [deg]" in run("effects")[1]
    assert "(1 sigma) [mm]" in run("plan", "--help")[1]


def test_a_terminal_is_told_how_to_show_the_page_that_is_linked() -> None:
    assert manual.for_terminal("see [a result](result.md#ranks)") == "see a result (`deltacal manual result`)"
    assert manual.for_terminal("[result](result.md) and ![a picture](x.png)") == "`result` and "


def test_the_site_holds_all_pages_and_a_search_of_their_text(tmp_path: Path) -> None:
    """Strictly: a link or a picture that leads nowhere ends the build."""
    command = ("-m", "mkdocs", "build", "--strict", "--quiet", "--config-file", ROOT / ".github" / "mkdocs.yml")
    subprocess.run([sys.executable, *command, "--site-dir", tmp_path], check=True)
    assert {f"{page}.html" for page in PAGES} <= {path.name for path in tmp_path.glob("*.html")}
    found = json.loads((tmp_path / "search" / "search_index.json").read_text(encoding="utf-8"))["docs"]
    assert {d["location"].partition(".html")[0] for d in found} == set(PAGES)
    (hit,) = (d for d in found if d["location"] == "result.html#status-of-a-parameter")
    assert "not pinned" in hit["text"]


def test_examples_are_copied_once(tmp_path: Path, run: Run) -> None:
    assert run("manual", "--examples", tmp_path)[0] == 0
    copy = tmp_path / "gearbox" / "recording.csv"
    copy.write_text(copy.read_text() + "\n")
    assert run("manual", "--examples", tmp_path)[0] == 3
    code, _, err = run("manual", "--examples", tmp_path / "gearbox" / "recording.csv")
    assert code == 3
    assert "recording.csv" in err


def test_examples_may_be_asked_for_again_but_nothing_that_was_tried_is_lost(tmp_path: Path) -> None:
    assert dc.manual_examples(tmp_path) == dc.manual_examples(tmp_path)
    tried = tmp_path / "delta" / "robot.toml"
    tried.write_text("[robot]\n")
    (tmp_path / "delta" / "mine.csv").write_text("q1_deg\n")
    with pytest.raises(InputError, match="not as it comes"):
        dc.manual_examples(tmp_path)
    assert tried.read_text() == "[robot]\n"


def test_every_job_of_make_has_its_line_without_make() -> None:
    page = (manual.folder() / "build.md").read_text(encoding="utf-8")
    recipes = (ROOT / "Makefile").read_text(encoding="utf-8")
    jobs = re.findall(r"\$\(BIN\)/(?:python (-m (?!pip)[\w.]+)|(lint-imports|ruff|mypy|deltacal \w+))", recipes)
    lines = {module or command for module, command in jobs}
    assert len(lines) > 8
    assert [line for line in sorted(lines) if line.replace("deltacal kernels", "python -m derive") not in page] == []
