"""Files that somebody adds to a registry: what is wrong with one is told in a line, with its name and place."""

from __future__ import annotations

import importlib
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

pytest.importorskip("sympy", reason="deriving needs the dependency group 'derive'")
pytest.importorskip("jinja2", reason="deriving needs the dependency group 'derive'")

import derive.effects
from derive import compiler, registry
from tests.support.copies import printed

Said = Callable[[str], str]


@pytest.fixture
def said(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Said]:
    """Return what is said of an effect's text in a file ``preload.py`` beside the registered ones."""
    folder = tmp_path / "derive" / "effects"
    folder.mkdir(parents=True)
    monkeypatch.setattr(derive.effects, "__path__", [*derive.effects.__path__, str(folder)])
    monkeypatch.setattr(registry, "ROOT", tmp_path)

    def answer(text: str) -> str:
        (folder / "preload.py").write_text(text, encoding="utf-8")
        importlib.invalidate_caches()
        with pytest.raises(ValueError, match=r".") as error:
            registry.effect.__wrapped__("preload")
        return str(error.value)

    yield answer
    sys.modules.pop("derive.effects.preload", None)


TEXT = printed("add-effect", "preload")
WRONG = {
    'name="preload"': ('name="backlash"', "derive/effects/preload.py: it is named 'backlash'. Name it as its file"),
    '"derive/effects/preload.py"': ('"preload.py"', 'preload.py: write source = "derive/effects/preload.py"; it says'),
    'state("torque")': ('state("torqe")', "derive/effects/preload.py, line 10: there is no state 'torqe'. Did you"),
    "EFFECT =": ("EFFEKT =", "derive/effects/preload.py: AttributeError: module 'derive.effects.preload' has no"),
    "    per_limb=True,\n": ("", "derive/effects/preload.py, line 12: TypeError: "),
    "compliance.symbol *": ("compliance *", "derive/effects/preload.py, line 19: TypeError: unsupported operand"),
    "EFFECT = Effect(": ("EFFECT = Effect((", "derive/effects/preload.py, line 12: SyntaxError: '(' was never"),
    "-0.01 * DEG": ("-0.01", "line 12: effect preload: a test says that joint moves by -0.01, and the formula gives"),
}


@pytest.mark.parametrize("there", WRONG)
def test_what_is_wrong_with_a_file_is_told_with_its_place(said: Said, there: str) -> None:
    instead, words = WRONG[there]
    assert there in TEXT
    assert words in said(TEXT.replace(there, instead, 1))


def test_no_file_is_written_over_what_is_common(monkeypatch: pytest.MonkeyPatch) -> None:
    one = {Path("effects/states.py"): ""}
    monkeypatch.setattr(compiler, "write_one", lambda lowered: one)
    with pytest.raises(
        ValueError, match=r"derive/effects/backlash.py: effects/states.py is written for something else"
    ):
        compiler.render(["backlash"])
