"""What other programs keep, made a robot and recordings: each importer is one file here, registered by its presence.

The file ``KIND.py`` defines ``import_KIND``. Its parameters before `output` are the files that it takes, in their
order, and its keyword-only ones are its options: the command ``deltacal import KIND`` and the function
``deltacal_gen.import_KIND`` are both made of that signature.
"""

from __future__ import annotations

import functools
import importlib
import inspect
import pkgutil
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from deltacal_gen.errors import UsageError

if TYPE_CHECKING:
    from deltacal_gen.files.imported import Imported

PREFIX = "import_"
OUTPUT = "output"


@dataclass(frozen=True)
class Importer:
    """A registered importer.

    Attributes
    ----------
    kind : str
    read : callable
        ``import_KIND``.
    files : tuple of str
        The files that it takes, in their order.
    needed : int
        How many of these, the first ones, it cannot do without.
    options : tuple of str
        Its keyword-only parameters.
    """

    kind: str
    read: Callable[..., Imported]
    files: tuple[str, ...]
    needed: int
    options: tuple[str, ...]

    @property
    def summary(self) -> str:
        """What it reads, in a sentence: the first one of its docstring."""
        return (self.read.__doc__ or "").partition("\n")[0]


@functools.cache
def names() -> tuple[str, ...]:
    """Return the kinds that can be imported."""
    return tuple(sorted(module.name for module in pkgutil.iter_modules(__path__)))


@functools.cache
def importer(kind: str) -> Importer:
    """Return the importer of a kind; raises UsageError where there is none."""
    if kind not in names():
        raise UsageError(f"there is no import '{kind}'; known: {', '.join(names())}.")
    read = getattr(importlib.import_module(f"{__name__}.{kind}"), PREFIX + kind)
    parameters = inspect.signature(read).parameters.values()
    files = [p for p in parameters if p.kind is not p.KEYWORD_ONLY and p.name != OUTPUT]
    options = tuple(p.name for p in parameters if p.kind is p.KEYWORD_ONLY)
    return Importer(kind, read, tuple(p.name for p in files), sum(p.default is p.empty for p in files), options)
