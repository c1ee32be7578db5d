"""The ledger of claims: what the papers say, what the derivation gives, and the test that decides.

One file per paper, ``claims/PAPER.toml`` beside this module: its ``title``, then a ``[[claim]]`` for every numbered
equation, every table, every figure with numbers and every number stated in the text. The file's presence is its
registration.

What the derivation decides is not typed there: such a claim names its verdicts (``derived``), and its printed and
correct form and its status are those of ``claims/derived.json``, which ``python -m derive verdicts`` writes.
"""

from __future__ import annotations

import ast
import hashlib
import json
import re
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any

from pydantic import Field, ValidationError
from pydantic_core import ErrorDetails

from deltacal_gen.errors import BadValue, InputError, UnknownName
from deltacal_gen.files.toml import Table, TomlFile
from deltacal_gen.results.registered import STATUSES, Status
from derive.review import rendering
from derive.review.sources import PAGES

SHOWN = 3  # figures of a deciding test where there is little room; the page has all

_Line = Annotated[str, Field(pattern=r"^\S(.*\S)?$")]  # one line of text, not empty
_Place = Annotated[str, Field(pattern=r"^(eq\. \(\d+\)|Table \d+|Fig\. \d+|section (\d+(\.\d+)*|[IVX]+(\.[A-Z])?))$")]
_Test = Annotated[str, Field(pattern=r"^tests/[\w/]+\.py::test_\w+$")]


class Claim(Table):
    """One claim of a paper, decided.

    Parameters
    ----------
    paper : str
        Name of the paper's file.
    where : str
        ``eq. (N)``, ``Table N``, ``Fig. N`` or ``section N``, numbered as in the paper.
    statement : str
        What the paper claims.
    status : str
        *proved* symbolically, *verified* numerically, *imprecise* (true as it is meant, not as it is worded),
        *contradicted*, *convention-dependent* (true only under a convention that the paper leaves open), *not
        reproducible* or *undecided*.
    printed, correct : str
        The formula or figure as printed, and as it is.
    decided : str
        How the derivation decides it; empty where its test does, and printed and correct form are typed.
    evidence : str
        What decides it, with the figure measured.
    test : str
        ``FILE::FUNCTION`` of the test that decides it.
    """

    paper: str
    where: _Place
    statement: _Line
    status: Status
    printed: _Line
    correct: _Line
    decided: str = ""
    evidence: _Line
    test: _Test


class Paper(Table):
    """A paper with its claims, in the order of its file."""

    title: str
    claims: tuple[Claim, ...]


def folder() -> Path:
    """Return the folder of the papers' files."""
    return Path(__file__).parent / "claims"


def paper_names() -> tuple[str, ...]:
    """Return the names of the papers that have a file."""
    return tuple(sorted(path.stem for path in folder().glob("*.toml")))


def load_paper(name: str) -> Paper:
    """Return the claims of a registered paper.

    Raises
    ------
    UsageError
        There is no such paper.
    """
    if name not in paper_names():
        raise UnknownName(f"there is no paper '{name}'; known: {', '.join(paper_names())}.")
    return read_paper(folder() / f"{name}.toml")


def read_paper(path: str | Path) -> Paper:
    """Read a paper's file.

    Raises
    ------
    InputError
        An entry has an unknown or missing key, a status or place that is none; file, line and entry are named.
    """
    file = TomlFile.read(path)
    verdicts = derived(Path(path).parent).get(Path(path).stem, {})
    name, entries, title = Path(path).stem, file.data.get("claim"), file.data.get("title")
    if not isinstance(title, str) or not isinstance(entries, list) or file.data.keys() != {"title", "claim"}:
        raise file.error("a title and a list of [[claim]], and nothing else, were expected.", "Add or remove keys.")
    headers = [number for number, line in enumerate(file.text.splitlines(), start=1) if line.strip() == "[[claim]]"]
    claims = []
    for n, entry in enumerate(entries):
        try:
            if "paper" in entry:
                raise BadValue("'paper' is the file's name.", "Remove it.", file=path, line=headers[n])
            given = _with_verdicts(entry, verdicts, Path(path), headers[n]) if "derived" in entry else entry
            claims.append(Claim.model_validate({"paper": name, **given}))
        except ValidationError as error:
            raise _explained(error.errors()[0], entry, n, Path(path), headers[n]) from None
    return Paper(title=title, claims=tuple(claims))


def select(papers: Iterable[Paper], status: str | None, words: Sequence[str]) -> list[Claim]:
    """Return the claims of papers that have a status, where one is given, and in which each word begins a word.

    Raises
    ------
    UsageError
        There is no such status.
    """
    if status not in (None, *STATUSES):
        raise UnknownName(f"there is no status '{status}'; known: {', '.join(STATUSES)}.")
    return [c for p in papers for c in p.claims if status in (None, c.status) and _has(c, words)]


def _has(claim: Claim, words: Sequence[str]) -> bool:
    text = " ".join((claim.where, claim.status, claim.statement, claim.printed, claim.correct, claim.evidence))
    return all(re.search(rf"(?<!\w){re.escape(word)}", text, re.IGNORECASE) for word in words)


def page(titles: Mapping[str, str], claims: Sequence[Claim]) -> str:
    """Return claims as a page that can be searched, by paper and with their counts.

    Parameters
    ----------
    titles : mapping
        Name of each paper to its title.
    claims : sequence of Claim
        To be shown, in their order.
    """
    by_paper = {n: [c for c in claims if c.paper == n] for n in titles}
    papers = [{"name": n, "title": titles[n], "count": len(own), "claims": own} for n, own in by_paper.items()]
    counts = [(s, sum(c.status == s for c in claims)) for s in STATUSES]
    script = (PAGES / "claims.js").read_text(encoding="utf-8")
    return rendering.page(
        "claims", title="Claims of the papers", papers=papers, counts=counts, script=script, ended=decided()
    )


def derived(of: Path | None = None) -> dict[str, dict[str, dict[str, str]]]:
    """Return the verdicts of the derivation in a folder, by default the registered ones: paper, name, what it holds."""
    return _stored("derived.json", of)


class Figure(Table):
    """An assertion of a deciding test, and what stood on its two sides; empty where it is but true, as of symbols."""

    asserted: str
    found: str


class Ended(Table):
    """How a deciding test ended when it last ran.

    Parameters
    ----------
    outcome, by_project, date : str
        As pytest calls it, with machines written from the papers alone and with the project's in their place; the day.
    sources : str
        Hash of what it was decided with, `sources`.
    figures : tuple of Figure
        What it measured.
    """

    outcome: str
    by_project: str
    date: str
    sources: str
    figures: tuple[Figure, ...]

    @property
    def both(self) -> str:
        """How it ended, in words."""
        return self.outcome if self.outcome == self.by_project else f"{self.outcome}, by the project {self.by_project}"

    @property
    def measured(self) -> list[str]:
        """The first figures as lines of text."""
        return [f"{f.asserted}: {f.found}" for f in self.figures if f.found][:SHOWN]


def in_short(end: Ended | None) -> dict[str, Any]:
    """Return how a test ended, and its first figures, as lines of text; empty ones where it never ran."""
    if end is None:
        return {"ended": "", "measured": []}
    return {"ended": f"{end.both} {end.date}, sources {end.sources[:12]}", "measured": end.measured}


def decided(of: Path | None = None) -> dict[str, Ended]:
    """Return how the deciding tests ended when they last ran, by their names."""
    return {test: Ended.model_validate(end) for test, end in _stored("decided.json", of).items()}


def _stored(name: str, of: Path | None) -> dict[str, Any]:
    """Return what a file of a folder holds, by default of the ledger's; nothing where there is none."""
    file = (of or folder()) / name
    found: dict[str, Any] = json.loads(file.read_text("utf-8")) if file.exists() else {}
    return found


def sources(root: Path, test: str) -> str:
    """Return the hash of what a test decides with: the descriptions that are derived, the kernels, its own modules."""
    patterns = ("derive/mechanisms/*.py", "derive/measurements/*.py", "derive/effects/*.py", "derive/statics.py")
    files = [p for pattern in (*patterns, "generated/deltacal_kernels/**/*.py") for p in root.glob(pattern)]
    whole = hashlib.sha256()
    for path in (*sorted(files), *_modules(root, root / test.partition("::")[0])):
        whole.update(path.relative_to(root).as_posix().encode() + b"\0" + path.read_bytes())
    return whole.hexdigest()


def _modules(root: Path, test: Path) -> list[Path]:
    """Return a test's file and the modules of the tests that it imports, and these in turn."""
    found, left = {test}, [test]
    while left:
        imports = (n for n in ast.walk(ast.parse(left.pop().read_text("utf-8"))) if isinstance(n, ast.ImportFrom))
        names = {name for n in imports for name in (f"{n.module}", *(f"{n.module}.{a.name}" for a in n.names))}
        of_tests = (root / f"{name.replace('.', '/')}.py" for name in names if name.startswith("tests."))
        found |= (new := {*filter(Path.exists, of_tests)} - found)
        left += new
    return sorted(found)


def _with_verdicts(
    entry: Mapping[str, Any], verdicts: Mapping[str, Mapping[str, str]], path: Path, line: int
) -> dict[str, Any]:
    """Return an entry with the printed and correct form and the status of the verdicts that it names."""
    names = [entry["derived"]] if isinstance(entry["derived"], str) else list(entry["derived"])
    typed = sorted({"printed", "correct", "status", "decided"} & entry.keys())
    if typed:
        raise BadValue(
            f"'{typed[0]}' is typed beside 'derived', which decides it.", "Remove one.", file=path, line=line
        )
    unknown = [n for n in names if n not in verdicts]
    if unknown or not names:
        known = ", ".join(verdicts) or "none"
        raise BadValue(
            f"there is no verdict {unknown or names!r} of the derivation; known: {known}.",
            'Correct it, or run "python -m derive verdicts".',
            file=path,
            line=line,
        )
    chosen = [verdicts[n] for n in names]
    ways = {v["status"] for v in chosen}
    joined = {key: "; ".join(dict.fromkeys(v[key] for v in chosen)) for key in ("printed", "correct", "decided")}
    kept = {key: value for key, value in entry.items() if key != "derived"}
    return {**kept, **joined, "status": next(s for s in ("contradicted", "verified", "proved") if s in ways)}


def _explained(flaw: ErrorDetails, entry: Mapping[str, Any], n: int, path: Path, line: int) -> InputError:
    key = flaw["loc"][0]
    what = f"claim {n + 1} ({entry.get('where', 'no place')}), key '{key}'"
    match flaw["type"]:
        case "extra_forbidden" | "missing":
            known = ", ".join(name for name in Claim.model_fields if name != "paper")
            problem = "is missing" if flaw["type"] == "missing" else "is not known"
            return BadValue(f"{what} {problem}.", f"A claim has {known}.", file=path, line=line)
        case "literal_error":
            wanted = f"one of {', '.join(STATUSES)}"
        case "string_pattern_mismatch":
            wanted = {
                "where": "'eq. (N)', 'Table N', 'Fig. N' or 'section N'",
                "test": "'tests/FILE.py::test_NAME'",
            }.get(str(key), "one line of text")
        case _:
            wanted = "one line of text"
    return BadValue(f"{what} is {flaw['input']!r}: {wanted} was expected.", "Correct the value.", file=path, line=line)
