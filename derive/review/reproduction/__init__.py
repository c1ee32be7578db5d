"""The papers' tables and figures remade beside the printed ones, each with what the ledger of claims says of it.

A module per paper, called as its file of the ledger is, gives ``study(tell)``: sheets and pictures, one by one.
"""

from __future__ import annotations

import importlib
import re
from collections.abc import Callable, Sequence
from typing import Any

from deltacal_gen.pages import report
from derive.review import ledger, rendering
from derive.review.reproduction.sheet import Part, Picture, Sheet, Study


def remade(paper: str, tell: Callable[[str], None]) -> list[Part]:
    """Return a paper's tables and figures, remade.

    Raises
    ------
    UsageError
        There is no such paper.
    """
    ledger.load_paper(paper)
    study: Study = importlib.import_module(f"derive.review.reproduction.{paper}").study
    return list(study(tell))


def page(paper: str, parts: Sequence[Part]) -> str:
    """Return the page of a paper: table by table and figure by figure, as they are numbered."""
    found = ledger.load_paper(paper)
    claims = [c for c in found.claims if re.match(r"(Table|Fig\.) ", c.where)]
    numbers = sorted({c.where for c in claims} | {p.of for p in parts}, key=_order)
    sections = [
        {
            "of": number,
            "sheets": [_sheet(p) for p in parts if isinstance(p, Sheet) and p.of == number],
            "pictures": [_picture(p) for p in parts if isinstance(p, Picture) and p.of == number],
            "claims": [c for c in claims if c.where == number],
        }
        for number in numbers
    ]
    counts = [(s, sum(c.status == s for c in claims)) for s in ledger.STATUSES]
    return rendering.page(
        "reproduction", title=f"{paper}: tables and figures", paper=found, counts=counts, sections=sections
    )


def _order(number: str) -> tuple[bool, int]:
    """Tables come before figures, by their numbers."""
    return number.startswith("Fig."), int(number.rsplit(" ", 1)[1])


def _sheet(sheet: Sheet) -> dict[str, Any]:
    of_paper = [c.startswith("paper") for c in sheet.columns]
    return {"title": sheet.title, "columns": sheet.columns, "of_paper": of_paper, "rows": sheet.rows}


def _picture(picture: Picture) -> dict[str, str]:
    return {"title": picture.title, "svg": report.panels(picture.draw, picture.grid, picture.size)}
