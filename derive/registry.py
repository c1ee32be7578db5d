"""What there is to derive: one file per mechanism, effect and kind of measurement; its presence registers it.

A mechanism's file defines ``mechanism(v)``, a measurement's ``measurement(v)``, an effect's ``EFFECT``; `v` holds the
rotations in which it is written down. Whatever is wrong with a file is told with its name and line: who runs the
build step may have added one of many.
"""

from __future__ import annotations

import importlib
import keyword
import pkgutil
import traceback
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import TypeVar

import derive.effects
import derive.measurements
import derive.mechanisms
from derive.language.effects import Effect
from derive.spec import ChainMechanism, LimbMechanism, Measurement
from derive.vectors import EXACT, Algebra

ROOT = Path(__file__).resolve().parent.parent
Spec = TypeVar("Spec", LimbMechanism | ChainMechanism, Measurement, Effect)


def _names(package: ModuleType) -> list[str]:
    return sorted(module.name for module in pkgutil.iter_modules(package.__path__))


def file_of(spec: LimbMechanism | ChainMechanism | Measurement | Effect) -> ModuleType:
    """Return the module in which a description is written down."""
    return importlib.import_module(spec.source.removesuffix(".py").replace("/", "."))


def _declared(package: ModuleType, name: str, of: Callable[[ModuleType], Spec]) -> Spec:
    """Return what the file `name` of a registry declares.

    Raises
    ------
    ValueError
        The file cannot be read, declares nothing, or something that is named or placed otherwise: its kernels would
        stand where those of another file do.
    """
    own = package.__name__
    try:
        spec = of(importlib.import_module(f"{own}.{name}"))
    except Exception as error:  # whatever a file of somebody else raises, a typing error of Python too
        raise ValueError(_told(own, name, error)) from error
    source = f"{own.replace('.', '/')}/{name}.py"
    if spec.name != name or not name.isidentifier() or keyword.iskeyword(name):
        raise ValueError(f"{source}: it is named '{spec.name}'. Name it as its file: by letters, digits and _.")
    if spec.source != source:
        raise ValueError(f"{source}: write source = \"{source}\"; it says '{spec.source}'.")
    return spec


def _told(package: str, name: str, error: Exception) -> str:
    """Return in one line what went wrong, with the last line of a file of `package` that led there."""
    folder = ROOT / package.replace(".", "/")
    file, line = folder / f"{name}.py", 0
    for frame in traceback.extract_tb(error.__traceback__):
        if Path(frame.filename).parent == folder and frame.lineno:
            file, line = Path(frame.filename), frame.lineno
    said = str(error)
    if isinstance(error, SyntaxError):
        file, line, said = Path(error.filename or file), error.lineno or line, error.msg
    if not isinstance(error, ValueError):  # those are of the language, in whole sentences
        said = f"{type(error).__name__}: {said}"
    place = file.relative_to(ROOT) if file.is_relative_to(ROOT) else file
    return f"{place.as_posix()}, line {line}: {said}" if line else f"{place.as_posix()}: {said}"


@cache
def mechanism(name: str, v: Algebra = EXACT) -> LimbMechanism | ChainMechanism:
    """Return a registered mechanism, its rotations written in an algebra; always the same object."""
    found: LimbMechanism | ChainMechanism = _declared(derive.mechanisms, name, lambda module: module.mechanism(v))
    return found


@cache
def measurement(name: str, v: Algebra = EXACT) -> Measurement:
    """Return a registered kind of measurement, its rotations written in an algebra; always the same object."""
    found: Measurement = _declared(derive.measurements, name, lambda module: module.measurement(v))
    return found


@cache
def effect(name: str) -> Effect:
    """Return a registered effect."""
    found: Effect = _declared(derive.effects, name, lambda module: module.EFFECT)
    return found


def mechanism_names() -> list[str]:
    """Return the name of every registered mechanism; none is built for this."""
    return _names(derive.mechanisms)


def measurement_names() -> list[str]:
    """Return the name of every registered kind of measurement; none is built for this."""
    return _names(derive.measurements)


def effect_names() -> list[str]:
    """Return the name of every registered effect."""
    return _names(derive.effects)


def mechanisms() -> Iterator[LimbMechanism | ChainMechanism]:
    """Yield every registered mechanism, by name."""
    return map(mechanism, mechanism_names())


def measurements() -> Iterator[Measurement]:
    """Yield every registered kind of measurement, by name."""
    return map(measurement, measurement_names())


def effects() -> Iterator[Effect]:
    """Yield every registered effect, by name."""
    return map(effect, effect_names())
