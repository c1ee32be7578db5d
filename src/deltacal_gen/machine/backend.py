"""Which kernels do a work: NumPy's, which are there at once, or those that Numba compiles.

The two agree to rounding, not to the last bit. So that the same command on the same files gives the same bytes, the
choice is made by the work alone: what it is, and over how many poses. No clock, no cache and nothing that a process did
before has a say in it.
"""

from __future__ import annotations

import importlib
import pkgutil
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from enum import Enum
from functools import cache, cached_property, wraps
from types import ModuleType
from typing import Any, Concatenate, ParamSpec, Protocol, TypeVar, cast

import deltacal_kernels
import numpy as np

# poses from which a work pays for loading Numba and the compiled kernels, half a second or ten where nothing has been
# compiled yet: one call, a fit of all poses some fifty times, the search of a diagnosis (a hundred fits); of a machine
# of three joints, others in proportion
PAYS_FROM = {"call": 20_000, "identify": 1_000, "diagnose": 300}
JOINTS = 3  # of the machine that `PAYS_FROM` is told of


class Backend(Enum):
    """Kernels to compute with."""

    NUMPY = "numpy"
    COMPILED = "compiled"

    @classmethod
    def of(cls, work: str, poses: int) -> Backend:
        """Return the one that pays for a work of `PAYS_FROM` over so many poses."""
        return cls.COMPILED if poses >= PAYS_FROM[work] else cls.NUMPY


_chosen: ContextVar[Backend | None] = ContextVar("backend", default=None)


def chosen(poses: int) -> Backend:
    """Return the back end of a call over so many poses: that of the work it belongs to, else what pays for the call."""
    return _chosen.get() or Backend.of("call", poses)


@contextmanager
def using(backend: Backend) -> Iterator[None]:
    """Compute with one back end, whatever the work; also a decorator.

    For loops of many small calls, of which no single one pays for compiled kernels::

        with deltacal_gen.using(deltacal_gen.Backend.COMPILED):
            ...
    """
    before = _chosen.set(backend)
    try:
        yield
    finally:
        _chosen.reset(before)


@contextmanager
def working(work: str, poses: int) -> Iterator[None]:
    """Compute with the back end that a work of `PAYS_FROM` pays for, unless it is part of a larger one."""
    with using(_chosen.get() or Backend.of(work, poses)):
        yield


class RowFunctions:
    """A generated module, its functions over rows done by NumPy, or by Numba where one call pays for it.

    The work that a call belongs to has no say: there are two hundred such functions, of which a diagnosis would load
    most, and of a thousand rows NumPy makes microseconds. Everything else of the module is as it stands there.

    Parameters
    ----------
    name : str
        Of the module, below ``deltacal_kernels``.
    """

    def __init__(self, name: str) -> None:
        self._where, _, self._stem = f"deltacal_kernels.{name}".rpartition(".")
        self._plain = importlib.import_module(f"{self._where}.{self._stem}")

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):  # what Python asks of a copy before it has any
            raise AttributeError(name)
        found = getattr(self._plain, name)
        if name in self._plain.OVER_ROWS:
            found = self._by_rows(name, found)
        vars(self)[name] = found
        return found

    def _by_rows(self, name: str, plain: Callable[..., np.ndarray]) -> Callable[..., np.ndarray]:
        @wraps(plain)
        def called(first: np.ndarray, *others: Any) -> np.ndarray:
            if Backend.of("call", len(first)) is Backend.NUMPY:
                return plain(first, *others)
            return cast(np.ndarray, getattr(self._compiled, name)(*map(_numbers, (first, *others))))

        return called

    @cached_property
    def _compiled(self) -> ModuleType:
        return importlib.import_module(f"{self._where}.compiled.{self._stem}")


@cache
def row_functions(name: str) -> RowFunctions:
    """Return a generated module of functions over rows, by its name below ``deltacal_kernels``."""
    return RowFunctions(name)


def compile_row_functions() -> Iterator[tuple[str, float]]:
    """Compile all functions over rows ahead, those of no machine too; yield the name of each and its seconds."""
    for module in pkgutil.walk_packages(deltacal_kernels.__path__, "deltacal_kernels."):
        if ".compiled." in module.name:
            found = importlib.import_module(module.name)
            for name, dimensions in found.DIMENSIONS.items():
                start = time.perf_counter()
                getattr(found, name)(*(np.zeros((0,) * d) for d in dimensions))
                yield f"{module.name}.{name}".removeprefix("deltacal_kernels."), time.perf_counter() - start


def _numbers(values: Any) -> np.ndarray:
    """Return numbers as compiled functions read them; a name among an effect's constants is none of them."""
    if isinstance(values, tuple):
        values = [np.nan if isinstance(value, str) else value for value in values]
    return np.ascontiguousarray(values, dtype=float)


class _Joints(Protocol):
    @property
    def shape(self) -> tuple[int, ...]: ...


class _Recording(Protocol):
    @property
    def joints(self) -> _Joints: ...


_A = TypeVar("_A")
_D = TypeVar("_D", bound=_Recording)
_P = ParamSpec("_P")
_R = TypeVar("_R")


def by_recording(work: str) -> Callable[[Callable[Concatenate[_A, _D, _P], _R]], Callable[Concatenate[_A, _D, _P], _R]]:
    """Decorate a function of a robot and a recording: it is a work of `PAYS_FROM` over the poses of the recording.

    Its matrices are small: threads of the linear algebra would only wait for one another, at twice the cost, and add in
    an order that depends on the number of cores.
    """

    def decorated(function: Callable[Concatenate[_A, _D, _P], _R]) -> Callable[Concatenate[_A, _D, _P], _R]:
        @wraps(function)
        def worked(robot: _A, recording: _D, *args: _P.args, **kwargs: _P.kwargs) -> _R:
            from threadpoolctl import threadpool_limits  # a first pose needs NumPy and the kernels alone

            poses, joints = recording.joints.shape
            with working(work, poses * max(joints, JOINTS) // JOINTS), threadpool_limits(1, "blas"):
                return function(robot, recording, *args, **kwargs)

        return worked

    return decorated
