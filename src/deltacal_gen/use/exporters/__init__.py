"""Exports of what was found of a machine, for its controller.

An export is registered by presence: a file of this folder that defines ``EXPORTER`` and is named as ``--export`` calls
it.
"""

from __future__ import annotations

import functools
import importlib
import pkgutil
from pathlib import Path
from typing import TYPE_CHECKING

from deltacal_gen.errors import UnknownName

if TYPE_CHECKING:
    from deltacal_gen.results.diagnosis import Diagnosis
    from deltacal_gen.results.motion import MotionModel
    from deltacal_gen.results.result import Result
    from deltacal_gen.results.written import FirmwareLines


class Exporter:
    """A form in which a compensator, or a machine in motion, is written for a controller."""

    @property
    def name(self) -> str:
        """What ``--export`` calls it: the name of its file."""
        return type(self).__module__.rpartition(".")[2]

    def at_rest(self, known: Result | Diagnosis, path: Path, *, kind: str, worst_mm: float) -> FirmwareLines | None:
        """Write a compensator of a `kind`; a table may leave `worst_mm`. Return the lines of a printer's firmware."""
        raise NotImplementedError

    def in_motion(self, known: MotionModel, path: Path) -> None:
        """Write what the drives of a machine in motion must give."""
        able = [n for n in names() if type(exporter_of(n)).in_motion is not Exporter.in_motion]
        raise UnknownName(f"there is no export '{self.name}' of a machine in motion; known: {', '.join(able)}.")


@functools.cache
def names() -> tuple[str, ...]:
    """Return the names of all exports."""
    return tuple(sorted(module.name for module in pkgutil.iter_modules(__path__)))


@functools.cache
def exporter_of(name: str) -> Exporter:
    """Return the export of a name.

    Raises
    ------
    UsageError
        There is none.
    """
    if name not in names():
        raise UnknownName(f"there is no export '{name}'; known: {', '.join(names())}.")
    exporter: Exporter = importlib.import_module(f"{__name__}.{name}").EXPORTER
    return exporter
