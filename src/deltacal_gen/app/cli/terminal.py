"""What a person sees of a command: its answer, what it does meanwhile, and why it did not."""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

from rich.console import Console
from rich.markup import escape

from deltacal_gen.errors import DeltacalError


class Terminal:
    """The two streams of a command.

    Parameters
    ----------
    as_json : bool
        Standard output holds the JSON of the answer, or of the error, and nothing else.
    quiet, verbose : bool
        Nothing but errors is shown; what is being done is shown line by line.
    aside : bool
        Standard output holds a file: words go to standard error.
    """

    def __init__(
        self, *, as_json: bool = False, quiet: bool = False, verbose: bool = False, aside: bool = False
    ) -> None:
        self.as_json, self.quiet, self.verbose = as_json, quiet, verbose
        self._words = Console(stderr=aside, highlight=False, quiet=quiet or as_json)
        self._aside = Console(stderr=True, highlight=False)

    def say(self, words: str) -> None:
        """Print words for a person."""
        self._words.print(words, markup=False, soft_wrap=True)  # a path stays whole

    def warn(self, words: str, what: str) -> None:
        """Print words that do not belong to the answer, after what they are."""
        self._aside.print(f"[bold red]{escape(what)}:[/bold red] {escape(words)}", soft_wrap=True)

    def fail(self, error: DeltacalError) -> int:
        """Print an error, with the code of its family; return the exit code."""
        if self.as_json:
            from deltacal_gen.results.written import Failure

            where = {name: getattr(error, name, None) for name in ("file", "line", "column")}
            where["file"] = where["file"] and str(where["file"])
            told = {"code": error.code, "error": str(error), "exit_code": error.exit_code}
            self._write(Failure.model_validate(told | where).to_dict())
        self.warn(str(error), f"error[{error.code}]")
        return error.exit_code

    def show(self, answer: Any) -> None:
        """Print an answer, or several, as it was asked for."""
        from deltacal_gen.results.base import plain

        if self.as_json:
            self._write(plain(answer))
        elif (text := getattr(answer, "text", None)) is not None:
            self._page(text)
        elif not self.quiet:
            self._document(answer)

    def _write(self, found: Any) -> None:
        sys.stdout.write(json.dumps(found, indent=1, allow_nan=False) + "\n")

    def _page(self, text: str) -> None:
        """Print Markdown: laid out on a terminal, elsewhere as it is."""
        if not self._words.is_terminal:
            sys.stdout.write(text)
            return
        from rich.markdown import Markdown

        from deltacal_gen.pages.manual import for_terminal

        self._words.print(Markdown(for_terminal(text), code_theme="ansi_dark"))  # on the terminal's own ground

    def _document(self, answer: Any) -> None:
        from rich.table import Table
        from rich.text import Text

        from deltacal_gen.results import document

        for part in answer.document():
            if isinstance(part, document.Text):
                self._words.print(Text("  " * part.level).append(part.lead, "bold").append(part.words))
                continue
            table = Table(title=part.title or None, title_justify="left", show_header=any(part.head))
            for head, numeric in zip(part.head, part.numeric or [False] * len(part.head), strict=True):
                table.add_column(head, justify="right" if numeric else "left", overflow="fold")
            for row in part.rows:
                table.add_row(*map(Text, row))
            self._words.print(table)

    @contextmanager
    def stages(self) -> Iterator[Callable[[str], None]]:
        """Show what is being done while it lasts; an empty text leaves the terminal to others."""
        if self.verbose:
            start = time.monotonic()
            yield lambda words: self._aside.print(f"{time.monotonic() - start:7.1f} s  {words}", markup=False)
        elif self.as_json or self.quiet or not self._aside.is_terminal:
            yield lambda words: None
        else:
            with self._aside.status("") as status:

                def show(words: str) -> None:
                    status.update(words)
                    (status.start if words else status.stop)()

                yield show

    @contextmanager
    def tasks(self) -> Iterator[Callable[[int, int, str], None]]:
        """Show how many tasks are done, and the time left."""
        from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

        columns = (BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(), TextColumn("{task.description}"))
        hidden = self.as_json or self.quiet or not self._aside.is_terminal
        with Progress(*columns, console=self._aside, disable=hidden, transient=True) as progress:
            bar = progress.add_task("", total=None)
            try:
                yield lambda done, total, label: progress.update(bar, completed=done, total=total, description=label)
            except KeyboardInterrupt:
                self.warn("what a run directory holds is kept, and the same command goes on from there", "stopped")
                raise
