"""What there is to derive: one file per mechanism, effect and kind of measurement; its presence registers it.

A mechanism's file defines ``mechanism(v)``, a measurement's ``measurement(v)``, an effect's ``EFFECT``; `v` holds the
rotations in which it is written down.
"""

from __future__ import annotations

import importlib
import pkgutil
from collections.abc import Iterator
from functools import cache
from types import ModuleType

import derive.effects
import derive.measurements
import derive.mechanisms
from derive.language.effects import Effect
from derive.spec import ChainMechanism, LimbMechanism, Measurement
from derive.vectors import EXACT, Algebra


def _names(package: ModuleType) -> list[str]:
    return sorted(module.name for module in pkgutil.iter_modules(package.__path__))


def file_of(spec: LimbMechanism | ChainMechanism | Measurement | Effect) -> ModuleType:
    """Return the module in which a description is written down."""
    return importlib.import_module(spec.source.removesuffix(".py").replace("/", "."))


@cache
def mechanism(name: str, v: Algebra = EXACT) -> LimbMechanism | ChainMechanism:
    """Return a registered mechanism, its rotations written in an algebra; always the same object."""
    found: LimbMechanism | ChainMechanism = importlib.import_module(f"derive.mechanisms.{name}").mechanism(v)
    return found


@cache
def measurement(name: str, v: Algebra = EXACT) -> Measurement:
    """Return a registered kind of measurement, its rotations written in an algebra; always the same object."""
    found: Measurement = importlib.import_module(f"derive.measurements.{name}").measurement(v)
    return found


@cache
def effect(name: str) -> Effect:
    """Return a registered effect."""
    found: Effect = importlib.import_module(f"derive.effects.{name}").EFFECT
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
