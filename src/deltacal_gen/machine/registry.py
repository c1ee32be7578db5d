"""Machines by name: those of the generated kernels, each loaded once."""

from __future__ import annotations

import copyreg
import dataclasses
import importlib
from collections.abc import Callable
from functools import cache
from typing import TYPE_CHECKING, Any

import deltacal_kernels
import numpy as np

from deltacal_gen.errors import UnknownName
from deltacal_gen.machine.chain import Chain
from deltacal_gen.machine.limbs import Limbs
from deltacal_gen.machine.machine import (
    COORDINATES,
    POSE,
    SINGULAR,
    SOLVED,
    STATUS,
    UNBALANCED,
    UNDEFINED,
    UNREACHABLE,
    GeometryKey,
    Machine,
    Parameter,
)
from deltacal_gen.machine.rotation import Array

if TYPE_CHECKING:
    from deltacal_gen.machine.values import Link, Robot

__all__ = [
    "COORDINATES",
    "POSE",
    "SINGULAR",
    "SOLVED",
    "STATUS",
    "UNBALANCED",
    "UNDEFINED",
    "UNREACHABLE",
    "Array",
    "GeometryKey",
    "Machine",
    "Parameter",
    "described",
    "load_mechanism",
    "mechanism_names",
    "mechanism_of",
    "nominal_joints",
]


def mechanism_names() -> tuple[str, ...]:
    """Return the names of all registered mechanisms."""
    return tuple(deltacal_kernels.MECHANISMS)


def load_mechanism(name: str, links: tuple[Link, ...] = ()) -> Machine:
    """Return a registered mechanism, always the same object; an open chain is one of its `links`.

    Raises
    ------
    UsageError
        No mechanism has this name; the message lists those that exist.
    """
    if name not in mechanism_names():
        raise UnknownName(f"there is no mechanism '{name}'. Registered: {', '.join(mechanism_names())}.")
    return _loaded(name, links)


@cache
def _loaded(name: str, links: tuple[Link, ...]) -> Machine:
    tables = importlib.import_module(f"deltacal_kernels.{name}.parameters")
    return Chain(tables, links) if getattr(tables, "CHAIN", False) else Limbs(tables)


# another process, and a copy, take the machine that is loaded there
_load: Callable[..., Any] = load_mechanism
copyreg.pickle(Limbs, lambda machine: (_load, (machine.name,)))
copyreg.pickle(Chain, lambda machine: (_load, (machine.name, machine.links)))


def mechanism_of(robot: Robot) -> Machine:
    """Return the mechanism of a robot."""
    return load_mechanism(robot.mechanism, robot.links)


def nominal_joints(robot: Robot, targets: Array, tool: Array) -> tuple[Array, np.ndarray]:
    """Return the joints (N, n_q) that a controller commands which believes the drawing, as the geometry counts them.

    Parameters
    ----------
    targets : (N, 3) or (N, 12) array
        See `Machine.inverse`.

    Returns
    -------
    q : (N, n_q) array
    status : (N,) int array
    """
    mechanism = mechanism_of(robot)
    rows = mechanism.rows(dataclasses.replace(robot, errors={}))
    q, _, status = mechanism.inverse(targets, tool, rows, robot.geometric_limits)
    return q, status


def described(mechanism: Machine) -> tuple[Machine, ...]:
    """Return the mechanisms that share a mechanism's robot files: one geometry, different source errors."""
    tables = {name: importlib.import_module(f"deltacal_kernels.{name}.parameters") for name in mechanism_names()}
    alike = [name for name, table in tables.items() if getattr(table, "MACHINE", name) == mechanism.machine]
    return tuple(mechanism if name == mechanism.name else load_mechanism(name) for name in alike)
