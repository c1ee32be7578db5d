"""Commands run in the process of the tests."""

from __future__ import annotations

from collections.abc import Callable

Run = Callable[..., tuple[int, str, str]]  # exit code, standard output, standard error: the fixture `run`
