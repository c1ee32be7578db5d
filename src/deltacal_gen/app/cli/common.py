"""What commands share: kinds of arguments and options, the screen, what is told while one works."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from rich.console import Console

if TYPE_CHECKING:
    from deltacal_gen.results.base import Answer

screen = Console(highlight=False)
aside = Console(stderr=True, highlight=False)

RobotFile = Annotated[Path, typer.Argument(metavar="ROBOT", help="robot file (TOML)", show_default=False)]
RecordingFile = Annotated[Path, typer.Argument(metavar="RECORDING", help="recording (CSV)", show_default=False)]
ResultFile = Annotated[
    Path,
    typer.Argument(metavar="RESULT", help="of identify, or DIAGNOSIS.json of diagnose", show_default=False),
]
Json = Annotated[bool, typer.Option("--json", help="print the JSON and nothing else")]
Model = Annotated[str | None, typer.Option("--model", help="e.g. delta/32 or 32", show_default=False)]


def _decimal(mark: str | None) -> str | None:
    from deltacal_gen.files.dialect import set_decimal_mark

    set_decimal_mark(mark)
    return mark


Decimal = Annotated[
    str | None,
    typer.Option(
        "--decimal", callback=_decimal, metavar="MARK", help="of tables, . or ,: asked for where it is not certain"
    ),
]


def output_file(help: str) -> Any:
    """Return the option ``-o FILE``; where FILE is the standard output, words for people go to standard error."""
    return typer.Option("-o", "--output", help=help, show_default=False, callback=_words_aside)


def _words_aside(output: Path | None) -> Path | None:
    if output is not None:
        from deltacal_gen.files.writing import is_standard_output

        if is_standard_output(output):
            screen.file = sys.stderr
    return output


@contextmanager
def progress(quiet: bool) -> Iterator[Callable[[str], None]]:
    """Show what is being done on the error stream while it lasts; nothing when the output is JSON or no terminal.

    An empty text leaves the terminal to others.
    """
    if quiet or not aside.is_terminal:
        yield lambda text: None
        return
    with aside.status("") as status:

        def show(text: str) -> None:
            status.update(text)
            (status.start if text else status.stop)()

        yield show


@contextmanager
def counting(quiet: bool) -> Iterator[Callable[[int, int, str], None]]:
    """Show tasks done and the time left on the error stream; nothing when the output is JSON or no terminal."""
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(), TextColumn("{task.description}"))
    hidden = quiet or not aside.is_terminal
    # drawn when a task has ended, not by a thread: a process of one thread can be forked into workers
    with Progress(*columns, console=aside, disable=hidden, transient=True, auto_refresh=False) as progress:
        bar = progress.add_task("", total=None)
        try:
            yield lambda done, total, label: progress.update(
                bar, completed=done, total=total, description=label, refresh=True
            )
        except KeyboardInterrupt:
            aside.print("stopped; what a run directory holds is kept, and the same command goes on from there")
            raise


def print_json(answer: Answer | Sequence[Answer]) -> None:
    """Print an answer, or several, as JSON on standard output, for ``--json``."""
    from deltacal_gen.results.base import plain

    sys.stdout.write(json.dumps(plain(answer), indent=1, allow_nan=False) + "\n")


def show(answer: Answer) -> None:
    """Print an answer as a person reads it."""
    from rich.table import Table
    from rich.text import Text

    from deltacal_gen.results import document

    for part in answer.document():
        if isinstance(part, document.Text):
            words = Text("  " * part.level).append(part.lead, "bold").append(part.words)
            screen.print(words, markup=False)
            continue
        table = Table(title=part.title or None, title_justify="left")
        for head, numeric in zip(part.head, part.numeric or [False] * len(part.head), strict=True):
            table.add_column(head, justify="right" if numeric else "left", overflow="fold")
        for row in part.rows:
            table.add_row(*map(escaped, row))
        screen.print(table)


def number(value: float | None, digits: int = 4) -> str:
    """Return a number as a cell of a table, to so many significant digits; a dash where there is none."""
    return "-" if value is None else f"{value:.{digits}g}"


def escaped(text: str) -> str:
    """Return text in which brackets are printed as they are, not read as rich's markup."""
    return text.replace("[", "\\[")
