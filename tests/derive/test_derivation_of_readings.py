"""Reports of kinds of measurement: no gap from the platform to the reading, and derivatives that are checked."""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy as sp

from deltacal_gen.instrument.kinds import kind_of
from derive import registry
from derive.review import account, checks, reports
from derive.review.subjects import seen_by, subject
from derive.review.written import OPAQUE, Entries
from tests.support.expressions import numbers, value


@pytest.mark.parametrize("name", registry.measurement_names())
def test_readings_are_shown_as_they_are_lowered(name: str) -> None:
    spec, lowered = registry.measurement(name, OPAQUE), registry.measurement(name)
    reader, triples = account.reader_of(spec), []
    if len(spec.reading) == 3:
        triples.append((sp.Matrix(spec.reading), sp.Matrix(lowered.reading)))
    triples += zip(map(sp.Matrix, spec.rotation), map(sp.Matrix, lowered.rotation), strict=True)
    for written, exact in triples:
        shown = reader.read(written)
        scalars = written.cols == 1 and not {"x_mm", "y_mm", "z_mm"} <= {*spec.columns}  # three, of no point
        assert scalars or not isinstance(shown, Entries), "no vector or matrix was recognised"
        at = numbers(exact.free_symbols)
        for e, own in zip(shown.explicit(), exact, strict=True):
            assert value(e, at) == pytest.approx(value(own, at), abs=1e-12)


def test_a_report_of_readings_shows_the_instrument_and_checks_its_derivatives() -> None:
    written = {}
    for one, template, found in reports.made([subject("board_image"), subject("encoder")], lambda text: None):
        for ending in ("html", "md"):
            written |= reports.files(Path(f"{one.name}.{ending}"), template, found)
    for name in ("board_image", "encoder"):
        html, md = (written[Path(f"{name}.{ending}")] for ending in ("html", "md"))
        spec, told = registry.measurement(name), account.measurement(name)
        for formula in (*told["steps"], *told["readings"]):
            assert formula.mathml in html
            assert formula.latex in md
        for quantity in (*spec.given, *spec.unknown):
            assert quantity.meaning.partition(", entry")[0] in md
        for quantity in spec.unknown:
            assert f"<code>{quantity.name}</code>" in html
            assert f"`{quantity.name}`" in md
        for column in (*spec.columns, *(q.name for q in spec.known)):
            assert f"`{column}`" in md
    assert "by the unknowns the order is 2.0" in written[Path("board_image.md")]
    assert Path("board_image-orders.svg") in written
    assert Path("encoder-orders.svg") not in written  # of rounding no picture is made


@pytest.mark.parametrize("name", registry.measurement_names())
def test_readings_lead_to_the_platform_and_the_instrument_without_a_gap(name: str) -> None:
    """Every symbol of a formula is the platform's, the instrument's, a recording's or another formula's, and shown."""
    spec, told = registry.measurement(name), account.measurement(name)
    known = {s for p in spec.platforms for s in (*p.coordinates, *p.turn)}
    known |= {q.symbol for q in (*spec.given, *spec.unknown, *spec.known)}
    for symbol, made in spec.steps:
        assert made.free_symbols <= known, symbol
        known.add(symbol)
    assert {s for e in spec.reading for s in e.free_symbols} <= known
    assert sum(3 if f.latex.startswith("\\mathbf") else 1 for f in told["steps"]) == len(spec.steps)
    assert not any("cay\\_" in f.latex for f in told["steps"]), "a rotation is shown entry by entry"


@pytest.mark.parametrize("name", registry.measurement_names())
def test_derivatives_of_readings_converge(name: str) -> None:
    kind = kind_of(name)
    for order in checks.orders_of_readings(seen_by(kind), kind):
        assert order.order > 1.94 or order.gaps.max() < 1e-9, order.by  # what is odd about zero leaves third order
