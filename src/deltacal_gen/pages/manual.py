"""The manual: one page in Markdown for each task, ``manual/TOPIC.md``; ``index.md`` is its contents.

A page may be a notebook instead, ``manual/TOPIC.py``: cells after ``# %%``, as editors and jupytext open them.

A page begins with its title and a sentence that says what it is for. A line ``<!-- measured NAME -->`` stands for the
table ``manual/measured/NAME.json``, which the command named in that file has written: figures are never typed.
"""

from __future__ import annotations

import difflib
import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Any

from deltacal_gen.errors import NothingToShow

CONTENTS = "index"
NEAR = 3  # topics that an unknown one is answered with
_LINK = re.compile(r"(?<!!)\[([^\]]+)\]\(([\w-]+)\.(?:md|py)(#[\w-]+)?\)")
_CELL = re.compile(r"^# %%(.*)\n", re.MULTILINE)
_PICTURE = re.compile(r"!\[([^\]]*)\]\([^)]+\)")
_MEASURED = re.compile(r"^<!-- measured (\w+) -->$", re.MULTILINE)
_NUMBER = re.compile(r"^[<>]?[-+\d][\d., ]*( ?(%|ns|us|ms|s|mm|MiB|MB|GB|kB)|/\d+)?$")


@dataclass(frozen=True)
class Page:
    """A page of the manual.

    Attributes
    ----------
    topic : str
        By which it is asked for, and the name of its file.
    title, summary : str
        Its heading, and the first paragraph below it.
    text : str
        All of it, in Markdown, with the measured tables in their places.
    """

    topic: str
    title: str
    summary: str
    text: str


def folder() -> Path:
    """Return the folder of the pages."""
    return Path(str(resources.files("deltacal_gen") / "manual"))


@cache
def parts() -> Mapping[str, tuple[str, ...]]:
    """Return the topics of each part, as the contents list them: a heading, below it a line to each page."""
    found: dict[str, list[str]] = {}
    for line in (folder() / f"{CONTENTS}.md").read_text(encoding="utf-8").splitlines():
        if line.startswith("## "):
            found[line.removeprefix("## ")] = []
        elif found and (link := _LINK.match(line.removeprefix("- "))):
            found[next(reversed(found))].append(link[2])
    return {part: tuple(listed) for part, listed in found.items()}


def topics() -> tuple[str, ...]:
    """Return all topics in the order of the contents, which themselves are none."""
    return tuple(topic for listed in parts().values() for topic in listed)


def read(topic: str = CONTENTS) -> Page:
    """Return a page.

    Raises
    ------
    UsageError
        There is no such topic; the nearest are named.
    """
    if topic not in (CONTENTS, *topics()):
        near = _near(topic)
        meant = f" Near: {', '.join(near)}." if near else ""
        raise NothingToShow(f"the manual has no topic '{topic}'.{meant} All topics: deltacal manual.")
    text = _MEASURED.sub(lambda found: _as_markdown(measured(found[1])), source(topic))
    title, _, rest = text.partition("\n")
    return Page(topic, title.removeprefix("# "), _plain(rest.strip().partition("\n\n")[0]), text)


def source(topic: str) -> str:
    """Return what stands written of a topic, as Markdown; of a notebook code is what runs."""
    page = folder() / f"{topic}.md"
    if page.exists():
        return page.read_text(encoding="utf-8")
    _, *cells = _CELL.split(page.with_suffix(".py").read_text(encoding="utf-8"))
    parts = []
    for kind, cell in zip(cells[::2], cells[1::2], strict=True):
        if "[markdown]" in kind:
            parts.append(re.sub(r"^# ?", "", cell.strip(), flags=re.MULTILINE))
        else:
            parts.append(f"```python run\n{cell.strip()}\n```")
    return "\n\n".join(parts) + "\n"


def measured(name: str) -> Mapping[str, Any]:
    """Return a measured table: its ``columns`` and ``rows``, and of the run ``command, versions, processor, note``."""
    table: Mapping[str, Any] = json.loads((folder() / "measured" / f"{name}.json").read_text(encoding="utf-8"))
    return table


def for_terminal(text: str) -> str:
    """Return a page's text as a terminal can show it: links name the command that shows their page, pictures go."""
    return _PICTURE.sub("", _LINK.sub(_as_command, text))


def _near(topic: str) -> list[str]:
    """Return topics whose name is nearly `topic`, then those that have most to say of that word."""
    alike = difflib.get_close_matches(topic, topics(), n=NEAR)
    said = {t: read(t).text.lower().count(topic.lower()) for t in topics()}
    most = sorted((t for t, count in said.items() if count), key=lambda t: -said[t])
    return list(dict.fromkeys([*alike, *most]))[:NEAR]


def _as_command(link: re.Match[str]) -> str:
    words, topic = link[1], link[2]
    return f"`{topic}`" if words.strip("`") == topic else f"{words} (`deltacal manual {topic}`)"


def _plain(paragraph: str) -> str:
    """Return a paragraph without its marks."""
    return re.sub(r"[`*]", "", _LINK.sub(r"\1", " ".join(paragraph.split())))


def _as_markdown(table: Mapping[str, Any]) -> str:
    """Return a measured table with the sentence that says what made it."""
    rows: Sequence[Sequence[Any]] = [[str(cell) for cell in row] for row in table["rows"]]
    right = [all(not row[j] or _NUMBER.match(row[j]) for row in rows) for j in range(len(table["columns"]))]
    lines = [table["columns"], ["---:" if r else "---" for r in right], *rows]
    versions = ", ".join(f"{name} {version}" for name, version in table["versions"].items())
    made = "; ".join(part for part in (f"`{table['command']}`", versions, table["processor"], table["note"]) if part)
    return "\n".join(f"| {' | '.join(line)} |" for line in lines) + f"\n\n*Measured by {made}.*"
