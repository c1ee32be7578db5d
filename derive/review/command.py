"""``python -m derive review TASK``: what reviewers ask for, from a checkout.

Tasks are ``derivation`` (reports of what is derived), ``trial`` (a first look at a machine that was just derived),
``claims`` (the ledger of the papers' claims) and ``reproduce`` (the tables of a paper). The answer is JSON on standard
output; of an error it is its code and what it was made of, and the exit code is that of its class. Progress goes to
standard error.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.writing import write_files
from derive.review import rendering


def _tell(what: str) -> None:
    print(what, file=sys.stderr, flush=True)


def write_report(name: str, output: Path) -> list[str]:
    """Write the report of a model, mechanism (its largest model), effect or measurement as a page, or as Markdown."""
    from derive.review import reports
    from derive.review.subjects import subject

    ((_, template, found),) = reports.made([subject(name)], _tell)
    files = reports.files(output, template, found)
    write_files(files)
    return list(map(str, files))


def write_all_reports(folder: Path) -> list[str]:
    """Write all reports as pages into a folder, and an index, which is the first file returned."""
    from derive.review import reports
    from derive.review.subjects import subjects

    folder.mkdir(parents=True, exist_ok=True)
    written, done = [folder / "index.html"], []
    for one, template, found in reports.made(subjects(), _tell):
        files = reports.files(folder / f"{one.stem}.html", template, found)
        write_files(files)
        written += files
        done.append((one, found))
    page = rendering.page("contents", title="Derivations", **reports.index(done, ".html"))
    write_files({written[0]: page})
    return list(map(str, written))


def try_out(file: Path, output: Path) -> str:
    """Return how the machine of a robot file does, and draw it: ``.svg``, or named after the mechanism in a folder."""
    from deltacal_gen.files.robot import read_robot
    from derive.review.trial import drawn, told, trial

    robot = read_robot(file)
    picture = output / f"{robot.mechanism}.svg" if output.is_dir() else output
    text = told(robot, trial(robot))
    write_files({picture: drawn(robot)})
    return f"{text}drawing in {picture}"


def list_claims(paper: str | None, status: str | None, search: str | None, output: Path | None) -> list[dict[str, Any]]:
    """Return the claims of one paper or all, of one status or all, with some words; as a page in `output`, too."""
    from derive.review import ledger

    papers = [ledger.load_paper(name) for name in (ledger.paper_names() if paper is None else (paper,))]
    found = ledger.select(papers, status, (search or "").split())
    ended = ledger.decided()
    titles = {p.claims[0].paper: p.title for p in papers}
    if output is not None:
        write_files({output: ledger.page(titles, found)})
    return [{**c.model_dump(), "title": titles[c.paper], **ledger.in_short(ended.get(c.test))} for c in found]


def reproduce(paper: str, folder: Path) -> dict[str, list[str]]:
    """Write the page of a paper's tables and figures; return its file, and the numbers of what was remade."""
    from derive.review import reproduction

    parts = reproduction.remade(paper, _tell)
    folder.mkdir(parents=True, exist_ok=True)
    page = folder / f"{paper}.html"
    write_files({page: reproduction.page(paper, parts)})
    return {"files": [str(page)], "remade": list(dict.fromkeys(part.of for part in parts))}


def _parse(arguments: Sequence[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m derive review", description="Answer for reviewers, as JSON.")
    tasks = parser.add_subparsers(dest="task", required=True)
    of_reports = tasks.add_parser("derivation", help="write reports of what is derived")
    of_reports.add_argument("name", nargs="?", help="a model (delta/42), mechanism, effect, measurement; default: all")
    of_reports.add_argument("-o", "--output", type=Path, required=True, help="FILE.html or FILE.md; of all a folder")
    of_trial = tasks.add_parser("trial", help="look at a machine whose kernels were just derived")
    of_trial.add_argument("robot", metavar="ROBOT.toml", type=Path)
    of_trial.add_argument("-o", "--output", type=Path, required=True, help="FILE.svg or a folder")
    of_claims = tasks.add_parser("claims", help="list what the papers claim, and what became of it")
    for option in ("--paper", "--status", "--search"):
        of_claims.add_argument(option)
    of_claims.add_argument("-o", "--output", type=Path, help="FILE.html")
    of_tables = tasks.add_parser("reproduce", help="make the tables and figures of a paper again")
    of_tables.add_argument("paper")
    of_tables.add_argument("-o", "--output", type=Path, required=True, help="a folder")
    return parser.parse_args(arguments)


def answer(arguments: Sequence[str]) -> Any:
    """Return the answer to a command line, as it is written in JSON."""
    given = _parse(arguments)
    match given.task:
        case "derivation":
            return write_all_reports(given.output) if given.name is None else write_report(given.name, given.output)
        case "trial":
            return try_out(given.robot, given.output)
        case "claims":
            return list_claims(given.paper, given.status, given.search, given.output)
        case _:
            return reproduce(given.paper, given.output)


def main(arguments: Sequence[str]) -> int:
    """Run the command; return its exit code."""
    try:
        print(json.dumps(answer(arguments)))
    except InputError as error:
        where = {"file": None if error.file is None else str(error.file), "line": error.line, "column": error.column}
        print(json.dumps({"code": error.code, "words": [error.problem, error.remedy], "where": where}))
        return error.exit_code
    except UsageError as error:
        print(json.dumps({"code": error.code, "words": [str(error)], "where": {}}))
        return error.exit_code
    return 0
