"""The registry of importers: functions and the command are made of what lies in its folder."""

from __future__ import annotations

import pytest

import deltacal_gen as dc
from deltacal_gen.errors import UsageError
from deltacal_gen.files import importers


def test_every_importer_is_a_function_of_the_package() -> None:
    exported = {name.removeprefix(importers.PREFIX) for name in dc.__all__ if name.startswith(importers.PREFIX)}
    assert exported == {*importers.names()}
    for kind in importers.names():
        assert importers.importer(kind).read is getattr(dc, importers.PREFIX + kind)


@pytest.mark.parametrize(
    ("kind", "files", "needed", "options"),
    [
        ("klipper", ("path",), 1, ()),
        ("rrf", ("config", "height_map"), 2, ()),
        ("points", ("points", "joints", "robot"), 2, ()),
        ("bag", ("path", "robot"), 1, ("joints", "readings", "mapping", "moving", "offset_s")),
        ("urdf", ("path",), 1, ("base", "tip")),
    ],
)
def test_files_and_options_are_those_of_its_signature(
    kind: str, files: tuple[str, ...], needed: int, options: tuple[str, ...]
) -> None:
    found = importers.importer(kind)
    assert (found.files, found.needed, found.options) == (files, needed, options)
    assert found.summary.endswith(".")


def test_a_kind_that_is_not_there_is_refused() -> None:
    with pytest.raises(UsageError, match=r"there is no import 'excel'; known: bag, c3d, klipper"):
        importers.importer("excel")
