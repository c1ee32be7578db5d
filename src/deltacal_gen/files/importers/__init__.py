"""What other programs keep, made a robot and recordings: each importer is one file here, registered by its presence.

The file ``KIND.py`` defines ``import_KIND``. Its parameters before `output` are the files that it takes, in their
order, and its keyword-only ones are its options: the command ``deltacal import KIND`` and the function
``deltacal_gen.import_KIND`` are both made of that signature. ``recognise(folder)``, in files that have it, yields what
of a folder can be imported: the path by which it is called, and the files in the order of the arguments.
"""

from __future__ import annotations

import functools
import importlib
import pkgutil
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from deltacal_gen.errors import UnknownName

if TYPE_CHECKING:
    from deltacal_gen.files.imported import Imported

PREFIX = "import_"


@functools.cache
def names() -> tuple[str, ...]:
    """Return the kinds that can be imported."""
    return tuple(sorted(module.name for module in pkgutil.iter_modules(__path__)))


def importer(kind: str) -> Callable[..., Imported]:
    """Return the function that imports a kind; raises UsageError where there is none."""
    if kind not in names():
        raise UnknownName(f"there is no import '{kind}'; known: {', '.join(names())}.")
    read: Callable[..., Imported] = getattr(importlib.import_module(f"{__name__}.{kind}"), PREFIX + kind)
    return read


def recognised(folder: Path) -> Iterator[tuple[str, Path, Sequence[Path]]]:
    """Yield what can be imported of a folder: its kind, what it is called, and its files as the importer takes them."""
    for kind in names():
        module = importlib.import_module(f"{__name__}.{kind}")
        yield from ((kind, *found) for found in (module.recognise(folder) if hasattr(module, "recognise") else ()))
