"""What a reader sees of a page, and that it stands alone."""

from __future__ import annotations

import re

from deltacal_gen.pages import figures


def words(page: str) -> str:
    """Return what a reader sees of a page."""
    return " ".join(re.sub(r"<style>.*?</style>|<[^>]*>", " ", page, flags=re.S).split())


def assert_self_contained(page: str) -> None:
    assert page.startswith("<!doctype html>")
    assert not re.search(r"<script|<link|<img|@import|\bsrc=|url\((?!#)", page)
    assert not [a for a in re.findall(r'(?:href|xlink:href)="([^"]*)"', page) if not a.startswith("#")]
    for colour in (figures.INK, figures.MUTED, figures.BEFORE, figures.AFTER):  # all of them follow the page's
        assert colour not in page.split("</style>", 1)[1]
    assert "prefers-color-scheme: dark" in page
