# Copied from derive/support/cache.py by "deltacal kernels". Do not edit.

"""Compiled kernels on disk: one file for each function and signature, named by all that its code depends on.

Numba's own cache asks when a module was changed, and knows neither the options of a function nor the functions of
other modules that were compiled into it. Here the folder is named by a hash of the kernels' text and the file by
signature, options, processor and versions: what is found is what would be compiled, wherever the package was copied.
Files appear whole or not at all, and two processes that compile at once write the same ones.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import pickle
import shutil
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

PACKAGE = Path(__file__).parent
BROKEN = (OSError, EOFError, pickle.UnpicklingError, AttributeError, ImportError, ValueError, TypeError)


@cache
def folder(kernels: Path) -> Path:
    """Return where compiled code of the kernels in a folder (a path) is kept, whether it exists or not.

    In their ``__pycache__``; in the user's cache folder where that cannot be written; below NUMBA_CACHE_DIR where that
    is set.
    """
    digest = hashlib.sha256(os.environ.get("DELTACAL_PLAIN_JIT", "").encode())  # see `straight`
    for text in (*sorted(PACKAGE.glob("*.py")), *sorted(kernels.glob("*.py"))):
        digest.update(text.name.encode() + text.read_bytes())
    name = f"{kernels.name}-{digest.hexdigest()[:16]}"
    if chosen := os.environ.get("NUMBA_CACHE_DIR"):
        return Path(chosen) / PACKAGE.name / name
    inside = kernels / "__pycache__"
    with contextlib.suppress(OSError):
        inside.mkdir(exist_ok=True)
    if inside.is_dir() and os.access(inside, os.W_OK):
        return inside / name
    return _of_user() / PACKAGE.name / name


def _of_user() -> Path:
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA", Path.home() / "AppData/Local"))
    if sys.platform == "darwin":
        return Path.home() / "Library/Caches"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")


def found(kernels: Path, function: str) -> bool:
    """Tell whether compiled code of a function, as ``kinematics._forward``, is kept; Numba is not loaded for this."""
    return any(folder(kernels).glob(f"{function}-*.nbc"))


def kernel(**options: Any) -> Callable[[Callable[..., Any]], Any]:
    """Return a decorator that compiles a function, as ``numba.njit(**options)``, and keeps its code."""
    from numba import njit

    def decorate(function: Callable[..., Any]) -> Any:
        compiled = njit(no_cfunc_wrapper=True, **options)(function)  # nobody calls them from C
        compiled._cache = _kept()(function, options)
        return compiled

    return decorate


@cache
def _kept() -> Any:
    """Return the class of caches; it builds on Numba, which only those import who compile."""
    import llvmlite
    import numba
    from numba.core import caching

    versions = (numba.__version__, llvmlite.__version__, np.__version__, sys.implementation.cache_tag)

    class Kept(caching.NullCache):
        """Code of one function: `load_overload` and `save_overload` are what Numba's dispatcher calls."""

        def __init__(self, function: Callable[..., Any], options: dict[str, Any]) -> None:
            source = Path(function.__code__.co_filename)
            self._folder = folder(source.parent)
            self._name = f"{source.stem}.{function.__qualname__}"
            self._options = sorted((name, str(sorted(v) if isinstance(v, set) else v)) for name, v in options.items())
            self._reduced = caching.CompileResultCacheImpl.reduce
            self._rebuilt = caching.CompileResultCacheImpl.rebuild

        @property
        def cache_path(self) -> str:
            return str(self._folder)

        def _path(self, signature: Any, target: Any) -> Path:
            on = (str(signature), target.magic_tuple(), self._options, versions)
            return self._folder / f"{self._name}-{hashlib.sha256(repr(on).encode()).hexdigest()[:16]}.nbc"

        def load_overload(self, signature: Any, target_context: Any) -> Any:
            target_context.refresh()
            try:
                data = self._path(signature, target_context.codegen()).read_bytes()
                return self._rebuilt(self, target_context, pickle.loads(data))
            except BROKEN:  # not there, or no longer readable: it is compiled anew
                return None

        def save_overload(self, signature: Any, result: Any) -> None:
            if result.library.has_dynamic_globals:
                return
            path = self._path(signature, result.codegen)
            part = path.with_name(f"{path.name}.{os.getpid()}.part")
            with contextlib.suppress(OSError):  # a full disk costs time, no result
                if not self._folder.exists():
                    self._begin()
                part.write_bytes(caching.dumps(self._reduced(self, result)))
                os.replace(part, path)

        def _begin(self) -> None:
            """Make the folder; beside the kernels, remove what other texts of theirs had left."""
            self._folder.mkdir(parents=True, exist_ok=True)
            if self._folder.parent.name == "__pycache__":
                for old in self._folder.parent.iterdir():
                    if old.is_dir() and old != self._folder:
                        shutil.rmtree(old, ignore_errors=True)

    return Kept
