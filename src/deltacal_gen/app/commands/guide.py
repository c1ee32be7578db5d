"""The demonstration and the manual."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import TYPE_CHECKING

from deltacal_gen.app.commands.common import Progress, Source, check_folder, silent
from deltacal_gen.errors import OutputName, UnknownName

if TYPE_CHECKING:
    from deltacal_gen.results.demo import Demo


def demo(*, output: Source = "demo", progress: Progress = silent) -> Demo:
    """Run the whole job on an example with a concealed effect: identify, diagnose, compensate, compare with the truth.

    Parameters
    ----------
    output : path
        Folder for the results and the page.
    progress : callable
        Called with what is being done.

    Raises
    ------
    InputError
        The output is a file.

    Examples
    --------
    deltacal demo -o demo
    """
    from deltacal_gen.app import demonstration

    check_folder(output)
    return demonstration.run(Path(output), progress)


def manual(topic: str | None = None, *, examples: Source | None = None) -> str:
    """Show a page of the manual, or copy the examples that its commands use.

    Parameters
    ----------
    topic : str, optional
        Page to show; default the list of pages.
    examples : path, optional
        Folder into which the examples are copied.

    Raises
    ------
    UsageError
        There is no such topic; the nearest are named.
    InputError
        The folder holds other files of these names.

    Examples
    --------
    deltacal manual diagnose
    """
    from deltacal_gen.pages import manual as pages

    copied = () if examples is None else manual_examples(examples)
    if copied and topic is None:
        return "".join(f"{folder}\n" for folder in copied)
    return pages.read(topic or pages.CONTENTS).text


def explain(code: str) -> str:
    """Explain the code of an error: what it means and what to do.

    Parameters
    ----------
    code : str
        The code in brackets before the message of an error, for example missing-column.

    Raises
    ------
    UsageError
        There is no such code; all are named.

    Examples
    --------
    deltacal explain missing-column
    """
    from inspect import getdoc

    from deltacal_gen.errors import families

    known = families()
    if code not in known:
        raise UnknownName(f"there is no code '{code}'; known: {', '.join(sorted(known))}.")
    return f"# {code}\n\n{getdoc(known[code])}\n\nThe exit code is {known[code].exit_code}.\n"


def manual_examples(folder: Source) -> list[Path]:
    """Copy the examples on which the manual's commands run into `folder`; return their folders.

    What is there already and as it comes stays, so that a notebook may be run again.

    Raises
    ------
    InputError
        The folder cannot be made, or holds one of the files otherwise: what was tried there is not overwritten.
    """
    from deltacal_gen.app.demonstration import example

    check_folder(folder)
    sources = [p for p in sorted(example("").glob("*/*")) if p.is_file() and p.suffix not in (".png", ".svg")]
    copies = {Path(folder) / p.parent.name / p.name: p for p in sources}
    if changed := next((c for c, p in copies.items() if c.exists() and c.read_bytes() != p.read_bytes()), None):
        raise OutputName("this is there already, and is not as it comes.", "Choose another folder.", file=changed)
    for copy, source in copies.items():
        copy.parent.mkdir(parents=True, exist_ok=True)
        if not copy.exists():
            shutil.copyfile(source, copy)
    return sorted({copy.parent for copy in copies})
