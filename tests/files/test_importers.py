"""The registry of importers: functions and the command are made of what lies in its folder."""

from __future__ import annotations

import inspect

import pytest

import deltacal_gen as dc
from deltacal_gen.errors import UsageError
from deltacal_gen.files import importers


def test_every_importer_is_a_function_of_the_package() -> None:
    exported = {name.removeprefix(importers.PREFIX) for name in dc.__all__ if name.startswith(importers.PREFIX)}
    assert exported == {*importers.names()}
    for kind in importers.names():
        assert importers.importer(kind) is getattr(dc, importers.PREFIX + kind)


@pytest.mark.parametrize("kind", importers.names())
def test_files_stand_before_the_output_and_options_behind_it(kind: str) -> None:
    parameters = [*inspect.signature(importers.importer(kind)).parameters.values()]
    at = [p.name for p in parameters].index("output")
    assert at > 0
    assert all(p.kind is p.KEYWORD_ONLY for p in parameters[at + 1 :])
    assert not any(p.kind is p.KEYWORD_ONLY for p in parameters[: at + 1])
    assert (importers.importer(kind).__doc__ or "").partition("\n")[0].endswith(".")


def test_a_kind_that_is_not_there_is_refused() -> None:
    with pytest.raises(UsageError, match=r"there is no import 'excel'; known: bag, c3d, klipper"):
        importers.importer("excel")
