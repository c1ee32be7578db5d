"""The demonstration and the manual."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from deltacal_gen.app.cli.common import Json, print_json, progress, screen, show


def demo(
    output: Annotated[Path, typer.Option("-o", "--output", help="folder for the files it makes")] = Path("demo"),
    as_json: Json = False,
) -> None:
    """Run the main job end to end on an embedded recording with a concealed effect."""
    from deltacal_gen.app import commands

    with progress(as_json) as tell:
        found = commands.demo(output, tell)
    if as_json:
        print_json(found)
    else:
        show(found)


def manual(
    topic: Annotated[str | None, typer.Argument(metavar="TOPIC", help="without it: all topics")] = None,
    examples: Annotated[
        Path | None,
        typer.Option("--examples", metavar="FOLDER", help="copy the files that the pages try", show_default=False),
    ] = None,
    as_json: Json = False,
) -> None:
    """Show a page of the manual, or copy the examples that it works on."""
    from deltacal_gen.app import commands
    from deltacal_gen.pages.manual import CONTENTS, for_terminal
    from deltacal_gen.results.written import Manual

    copies = [] if examples is None else commands.manual_examples(examples)
    text = commands.manual(topic) if topic is not None or examples is None else None
    if as_json:
        print_json(Manual(topic=topic or CONTENTS, text=text, files=tuple(map(str, copies))))
        return
    for path in copies:
        screen.print(str(path))
    if text is not None and screen.is_terminal:
        from rich.markdown import Markdown

        screen.print(Markdown(for_terminal(text), code_theme="ansi_dark"))  # on the terminal's own ground
    elif text is not None:
        sys.stdout.write(text)
