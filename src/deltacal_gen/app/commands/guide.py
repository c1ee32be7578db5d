"""The demonstration and the manual."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import TYPE_CHECKING

from deltacal_gen.app.commands.common import Progress, Source, make_folder, silent
from deltacal_gen.errors import InputError
from deltacal_gen.files.writing import write_files

if TYPE_CHECKING:
    from deltacal_gen.results.demo import Demo


def demo(output: Source = "demo", progress: Progress = silent) -> Demo:
    """Run the main job on the embedded recording; write its files and a picture below `output`."""
    from deltacal_gen.app import demonstration

    if Path(output).exists() and not Path(output).is_dir():
        raise InputError("this is a file, and the demonstration needs a folder.", "Choose another name.", file=output)
    return demonstration.run(Path(output), progress)


def manual(topic: str | None = None) -> str:
    """Return a page of the manual as Markdown, without a topic its contents.

    Raises
    ------
    UsageError
        There is no such topic; the nearest are named.
    """
    from deltacal_gen.pages import manual as pages

    return pages.read(topic or pages.CONTENTS).text


def manual_site(folder: Source) -> Path:
    """Write the manual as a site that opens from disk and can be searched; return its first page.

    Raises
    ------
    InputError
        The folder cannot be made or written.
    """
    from deltacal_gen.pages import site

    made = site.files(Path(folder))
    for place in {path.parent for path in made}:
        make_folder(place)
    write_files(made)
    return next(iter(made))


def manual_examples(folder: Source) -> list[Path]:
    """Copy the examples on which the manual's commands run into `folder`; return their folders.

    Raises
    ------
    InputError
        The folder cannot be made, or holds one of them already: what was tried there is not overwritten.
    """
    from deltacal_gen.app.demonstration import example

    names = sorted(path.parent.name for path in example("").glob("*/robot.toml"))
    copies = [Path(folder) / name for name in names]
    if there := next((path for path in copies if path.exists()), None):
        raise InputError("this is there already.", "Choose another folder.", file=there)
    make_folder(Path(folder))
    for name, copy in zip(names, copies, strict=True):
        shutil.copytree(example(name), copy, ignore=shutil.ignore_patterns("*.png", "*.svg"))
    return copies
