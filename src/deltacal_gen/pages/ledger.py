"""The ledger of claims: what the papers say, what the derivation gives, and the test that decides.

One file per paper, ``claims/PAPER.toml``: its ``title``, then a ``[[claim]]`` for every numbered equation, every table,
every figure with numbers and every number stated in the text. The file's presence is its registration.
"""

from __future__ import annotations

from collections.abc import Mapping
from importlib import resources
from pathlib import Path
from typing import Annotated, Any, Literal, get_args

from pydantic import Field, ValidationError

from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.robot import Table, TomlFile

Status = Literal["proved", "verified", "contradicted", "convention-dependent", "not reproducible", "undecided"]
STATUSES: tuple[str, ...] = get_args(Status)

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
        *proved* symbolically, *verified* numerically, *contradicted*, *convention-dependent* (true only under a
        convention that the paper leaves open), *not reproducible* or *undecided*.
    printed, correct : str
        The formula or figure as printed, and as it is.
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
    evidence: _Line
    test: _Test


class Paper(Table):
    """A paper with its claims, in the order of its file."""

    title: str
    claims: tuple[Claim, ...]


def folder() -> Path:
    """Return the folder of the papers' files."""
    return Path(str(resources.files("deltacal_gen") / "claims"))


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
        raise UsageError(f"there is no paper '{name}'; known: {', '.join(paper_names())}.")
    return read_paper(folder() / f"{name}.toml")


def read_paper(path: str | Path) -> Paper:
    """Read a paper's file.

    Raises
    ------
    InputError
        An entry has an unknown or missing key, a status or place that is none; file, line and entry are named.
    """
    file = TomlFile.read(path)
    name, entries, title = Path(path).stem, file.data.get("claim"), file.data.get("title")
    if not isinstance(title, str) or not isinstance(entries, list) or file.data.keys() != {"title", "claim"}:
        raise file.error("a title and a list of [[claim]], and nothing else, were expected.", "Add or remove keys.")
    headers = [number for number, line in enumerate(file.text.splitlines(), start=1) if line.strip() == "[[claim]]"]
    claims = []
    for n, entry in enumerate(entries):
        try:
            if "paper" in entry:
                raise InputError("'paper' is the file's name.", "Remove it.", file=path, line=headers[n])
            claims.append(Claim.model_validate({"paper": name, **entry}))
        except ValidationError as error:
            raise _explained(error.errors()[0], entry, n, Path(path), headers[n]) from None
    return Paper(title=title, claims=tuple(claims))


def _explained(flaw: Mapping[str, Any], entry: Mapping[str, Any], n: int, path: Path, line: int) -> InputError:
    key = flaw["loc"][0]
    what = f"claim {n + 1} ({entry.get('where', 'no place')}), key '{key}'"
    match flaw["type"]:
        case "extra_forbidden" | "missing":
            known = ", ".join(name for name in Claim.model_fields if name != "paper")
            problem = "is missing" if flaw["type"] == "missing" else "is not known"
            return InputError(f"{what} {problem}.", f"A claim has {known}.", file=path, line=line)
        case "literal_error":
            wanted = f"one of {', '.join(STATUSES)}"
        case "string_pattern_mismatch":
            wanted = {
                "where": "'eq. (N)', 'Table N', 'Fig. N' or 'section N'",
                "test": "'tests/FILE.py::test_NAME'",
            }.get(key, "one line of text")
        case _:
            wanted = "one line of text"
    return InputError(
        f"{what} is {flaw['input']!r}: {wanted} was expected.", "Correct the value.", file=path, line=line
    )
