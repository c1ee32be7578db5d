"""What only a source checkout does: derive kernels, and answer for reviewers, in a process of its own.

Nothing of the runtime imports the derivation; this module is the one place that reaches it.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from deltacal_gen.errors import InputError, NeedsCheckout, NotInstalled, UsageError, families


def find_checkout() -> Path | None:
    """Return the root of the source checkout that this package runs from, or None."""
    root = Path(__file__).resolve().parents[3]
    return root if (root / "derive" / "__main__.py").exists() and (root / "templates").is_dir() else None


def require_checkout(*, deriving: bool) -> Path:
    """Return the root of the checkout.

    Parameters
    ----------
    deriving : bool
        Whether equations are derived, which needs SymPy.

    Raises
    ------
    UsageError
        This is an installed package, or SymPy is not installed.
    """
    root = find_checkout()
    if root is None:
        raise NeedsCheckout("this command needs a source checkout, and this is an installed package.")
    if deriving and not find_spec("sympy"):
        raise NotInstalled("deriving needs SymPy: pip install 'sympy>=1.14,<1.15'.")
    return root


def run_derivation(*arguments: str) -> bool:
    """Run ``python -m derive`` in the terminal that this runs in; return whether it ended well."""
    command = [sys.executable, "-m", "derive", *arguments]
    root = require_checkout(deriving=True)
    return subprocess.run(command, cwd=root, env={**os.environ, "PYTHONHASHSEED": "0"}).returncode == 0


def run_review(*arguments: object, deriving: bool = False, progress: Callable[[str], None] = lambda what: None) -> Any:
    """Return what ``python -m derive review`` answers; raise its errors, which `derive.review.command` describes."""
    root = require_checkout(deriving=deriving)
    command = [sys.executable, "-m", "derive", "review", *map(str, arguments)]
    lines: list[str] = []
    with tempfile.TemporaryFile("w+", encoding="utf-8") as written:  # a pipe would fill while progress is read
        with subprocess.Popen(
            command, cwd=root, stdout=written, stderr=subprocess.PIPE, text=True, encoding="utf-8"
        ) as process:
            for line in process.stderr or ():
                lines.append(line)
                progress(line.rstrip())
        written.seek(0)
        answer = written.read()
    if process.returncode in (UsageError.exit_code, InputError.exit_code):
        told = json.loads(answer)
        raise families()[told["code"]](*told["words"], **told["where"])
    if process.returncode:
        raise RuntimeError("".join(lines) + answer)
    return json.loads(answer)
