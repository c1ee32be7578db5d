"""``python -m derive review``: write reports of what is derived, or look at a machine that was just derived.

Standard output is the answer, the files one a line, or why there are none: of an unusable input that is JSON, what an
`InputError` holds. What is being done goes to standard error. The exit code is that of the error's class.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path

from deltacal_gen.errors import DeltacalError, InputError
from deltacal_gen.files.robot import read_robot
from deltacal_gen.files.writing import write_files
from deltacal_gen.pages import report
from derive.review import reports
from derive.review.subjects import subject, subjects
from derive.review.trial import drawn, told, trial


def _tell(what: str) -> None:
    print(what, file=sys.stderr, flush=True)


def write(name: str, output: Path) -> list[Path]:
    """Write the report of a model, mechanism (its largest model), effect or measurement as a page, or as Markdown."""
    ((_, template, found),) = reports.made([subject(name)], _tell)
    files = reports.files(output, template, found)
    write_files(files)
    return list(files)


def write_all(folder: Path) -> list[Path]:
    """Write all reports as pages into a folder, and an index, which is the first file returned."""
    folder.mkdir(parents=True, exist_ok=True)
    written, done = [folder / "index.html"], []
    for one, template, found in reports.made(subjects(), _tell):
        files = reports.files(folder / f"{one.stem}.html", template, found)
        write_files(files)
        written += files
        done.append((one, found))
    page = report.page_of("contents", reports.PAGES, title="Derivations", **reports.index(done, ".html"))
    write_files({written[0]: page})
    return written


def try_out(file: Path, output: Path) -> str:
    """Return how the machine of a robot file does, and draw it: ``.svg``, or named after the mechanism in a folder."""
    robot = read_robot(file)
    picture = output / f"{robot.mechanism}.svg" if output.is_dir() else output
    text = told(robot, trial(robot))
    write_files({picture: drawn(robot)})
    return f"{text}drawing in {picture}"


def main(arguments: Sequence[str]) -> int:
    """Run the command; return its exit code."""
    parser = argparse.ArgumentParser(prog="python -m derive review", description="Write reports for reviewers.")
    parser.add_argument("name", nargs="?", help="a model (delta/42), mechanism, effect or measurement; without it all")
    parser.add_argument("--try", dest="tried", metavar="ROBOT.toml", type=Path, help="no report: look at this machine")
    parser.add_argument("-o", "--output", type=Path, required=True, help="FILE.html or FILE.md; of all a folder")
    asked = parser.parse_args(arguments)
    try:
        if asked.tried is not None:
            print(try_out(asked.tried, asked.output))
            return 0
        written = write_all(asked.output) if asked.name is None else write(asked.name, asked.output)
    except InputError as error:
        said = {"problem": error.problem, "remedy": error.remedy, "line": error.line, "column": error.column}
        print(json.dumps({**said, "file": None if error.file is None else str(error.file)}))
        return error.exit_code
    except DeltacalError as error:
        print(error)
        return error.exit_code
    print(*written, sep="\n")
    return 0
