"""Reports as pages and as Markdown, by the templates in ``pages/``; layout and colours are those of all pages."""

from __future__ import annotations

import html
import math
import re
from functools import cache
from pathlib import Path
from typing import Any

import jinja2
from markupsafe import Markup

from deltacal_gen.pages import report
from deltacal_gen.pages.figures import decade
from derive.review.sources import PAGES

PAPER = {"var(--card)": "#ffffff", "var(--paper)": "#ffffff", "var(--good)": "#2c7a4b", "var(--bad)": "#b8472f"}


def page(template: str, **content: Any) -> str:
    """Return a page by the name of its template."""
    style = report.asset("style.css") + (PAGES / "style.css").read_text(encoding="utf-8")
    return _environment(autoescape=True).get_template(f"{template}.html.jinja").render(style=style, **content)


def markdown(template: str, **content: Any) -> str:
    """Return a text by the name of its Markdown template."""
    text = _environment(autoescape=False).get_template(f"{template}.md.jinja").render(**content)
    return re.sub(r"\n{3,}", "\n\n", text).strip() + "\n"


def standalone(svg: str) -> str:
    """Return a picture of a page as a file of its own: the page's colours on paper."""
    colours = {variable: colour for colour, variable in report.COLOURS.items()} | PAPER
    for variable, colour in colours.items():
        svg = svg.replace(variable, colour)
    return svg + "\n"


def below(value: float) -> str:
    """Return a bound for what is only rounding: the next power of ten above it, which no other processor changes."""
    return "0" if value == 0 else f"< {decade(1, math.ceil(math.log10(value)))}"


@cache
def _environment(*, autoescape: bool) -> jinja2.Environment:
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader([PAGES, Path(report.__file__).parent]),
        undefined=jinja2.StrictUndefined,
        autoescape=autoescape,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["breakable"] = _breakable
    return environment


def _breakable(text: str) -> Markup:
    """Return a path or a dotted name that may break behind its separators, so that no column is as wide as it."""
    return Markup(re.sub(r"(::|[/_])", r"\1<wbr>", html.escape(text)))
