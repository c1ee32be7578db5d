"""The manual as a site: HTML that opens from disk, one page to each topic, with a search that needs no server."""

from __future__ import annotations

import html
import json
import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

from markdown_it import MarkdownIt
from markdown_it.token import Token

from deltacal_gen.pages import manual, report
from deltacal_gen.pages.manual import CONTENTS, Page, anchor
from deltacal_gen.version import __version__

SHORT = 30  # letters of code that stay in one line


def files(folder: Path) -> dict[Path, str | bytes]:
    """Return the files of the site below `folder`: pages, one stylesheet, one script with the index, pictures."""
    pages = {topic: manual.read(topic) for topic in (CONTENTS, *manual.topics())}
    parts = {part: [pages[topic] for topic in listed] for part, listed in manual.parts().items()}
    made: dict[Path, str | bytes] = {}
    found: list[dict[str, str]] = []
    for page, after in zip(pages.values(), [*list(pages.values())[1:], None], strict=True):
        tokens = _parser().parse(page.text)
        _anchored(tokens)
        for source, name in _led(tokens):
            made[folder / "pictures" / name] = source.read_bytes()
        found += _sections(page, tokens)
        made[folder / f"{page.topic}.html"] = report.page_of(
            "manual",
            title=page.title,
            topic=page.topic,
            body=_parser().renderer.render(tokens, _parser().options, {}),
            parts=parts,
            after=after,
            version=__version__,
        )
    made[folder / "manual.css"] = report.asset("style.css") + report.asset("manual.css")
    made[folder / "search.js"] = f"const SECTIONS = {json.dumps(found)};\n" + report.asset("search.js")
    return made


def _parser() -> MarkdownIt:
    """Return CommonMark with tables, without HTML; what is broad scrolls in a box of its own."""
    parser = MarkdownIt("commonmark", {"html": False}).enable("table")
    parser.add_render_rule("table_open", lambda self, *_: '<div class="wide"><table>\n')
    parser.add_render_rule("table_close", lambda self, *_: "</table></div>\n")
    parser.add_render_rule("fence", _fence)
    parser.add_render_rule("code_inline", _code)
    return parser


def _fence(renderer: Any, tokens: Sequence[Token], at: int, options: Any, env: Any) -> str:
    """Return a block of code; what a command prints is set apart from what is typed."""
    kind = "output" if tokens[at].info.split()[:1] == ["output"] else "typed"
    return f'<pre class="{kind}"><code>{html.escape(tokens[at].content)}</code></pre>\n'


def _code(renderer: Any, tokens: Sequence[Token], at: int, options: Any, env: Any) -> str:
    """Return code within a line, which breaks only where it is long."""
    kind = ' class="unbroken"' if len(tokens[at].content) <= SHORT else ""
    return f"<code{kind}>{html.escape(tokens[at].content)}</code>"


def _anchored(tokens: Sequence[Token]) -> None:
    """Give every heading its anchor, as GitHub does, and numbers of tables their place at the right."""
    for token, inside in zip(tokens, [*tokens[1:], None], strict=True):
        if token.type == "heading_open" and inside is not None:
            token.attrSet("id", anchor(inside.content))
        if token.type in ("th_open", "td_open"):
            right = "right" in str(token.attrs.pop("style", ""))
            token.attrs |= {"class": "n"} if right else {}


def _led(tokens: Sequence[Token]) -> Iterator[tuple[Path, str]]:
    """Lead links to the site's pages and pictures; yield each picture's file with the name that it gets."""
    for token in (child for t in tokens for child in t.children or ()):
        if token.type == "link_open":
            token.attrSet("href", re.sub(r"^([\w-]+)\.(?:md|py)", r"\1.html", str(token.attrGet("href"))))
        elif token.type == "image":
            source = (manual.folder() / str(token.attrGet("src"))).resolve()
            name = f"{source.parent.name}-{source.name}"
            token.attrSet("src", f"pictures/{name}")
            yield source, name


def _sections(page: Page, tokens: Sequence[Token]) -> Iterator[dict[str, str]]:
    """Yield what the search looks through: every heading with its anchor and the text up to the next one."""
    section: dict[str, str] = {}
    for token, before in zip(tokens, [None, *tokens[:-1]], strict=True):
        if before is not None and before.type == "heading_open":
            if section:
                yield section
            section = {"page": page.topic, "title": page.title, "heading": _text(token)}
            section |= {"anchor": str(before.attrGet("id")), "text": ""}
        elif token.type == "inline" or token.type in ("fence", "code_block"):
            section["text"] += f"{_text(token)} "
    yield section


def _text(token: Token) -> str:
    """Return what a reader sees of a block."""
    parts = [child.content or " " * (child.type in ("softbreak", "hardbreak")) for child in token.children or ()]
    return "".join(parts) if token.children else token.content
