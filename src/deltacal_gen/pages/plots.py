"""What `plot()` of an answer draws: a picture for each sort that has one."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from deltacal_gen.errors import NothingToShow
from deltacal_gen.pages import figures, plans, validation
from deltacal_gen.pages.figures import AFTER, MUTED, STYLE, Sheet, mpl
from deltacal_gen.results.base import Answer
from deltacal_gen.results.batch import Batch
from deltacal_gen.results.comparison import Change, Comparison
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.plan import Plan
from deltacal_gen.results.result import Result
from deltacal_gen.results.study import Study
from deltacal_gen.results.validation import Validation

LONG = 28  # letters of a combination of parameters, of which a picture shows the first alone


def plot(found: Answer) -> Sheet:
    """Return the picture of an answer.

    Raises
    ------
    UsageError
        Answers of this sort have none, or this one has nothing to draw.
    """
    drawer = next((draw for of, draw in _DRAWERS.items() if isinstance(found, of)), None)
    if drawer is None:
        known = ", ".join(of.__name__ for of in _DRAWERS)
        raise NothingToShow(f"there is no picture of a {type(found).__name__}; there is one of {known}.")
    with mpl.rc_context(STYLE):
        figure: Sheet = drawer(found)
    return figure


def _validation(found: Validation) -> Sheet:
    """Draw the worst readings, beside the rms of all and the noise; of an axis its deviations from either side."""
    if found.iso230 is not None and found.iso230.places:
        figure, axes = figures.sheet(1, 1, validation.SIZE)
        validation.axis(axes, found.iso230)
        figure.suptitle(found.headline, x=0.01, ha="left")
        return figure
    figure, axes = figures.sheet(1, 1, (6.4, 1.2 + 0.25 * len(found.rows)))
    axes.barh([f"line {row.line}" for row in found.rows], [row.error_mm for row in found.rows], color=AFTER)
    axes.invert_yaxis()
    for value, name in ((found.rms_mm, "rms of all"), (found.sigma_mm, "noise")):
        axes.axvline(value, color=figures.INK, lw=1, ls="--" if name == "noise" else "-", label=name)
    axes.legend(frameon=False)
    axes.set_xlabel("error of the worst readings, mm")
    figure.suptitle(found.headline, x=0.01, ha="left")
    return figure


def _comparison(found: Comparison) -> Sheet:
    """Draw changes by their standard deviations, those that are called changes first."""
    combined = found.combinations_changed is not None
    changed = found.combinations_changed if combined else found.changed
    same = found.combinations_unchanged if combined else found.unchanged
    told: list[tuple[Change, float]] = [(c, c.change / c.std) for c in (*(changed or ()), *(same or ())) if c.std]
    if not told:
        raise NothingToShow("there is nothing to draw: no parameter is known to both sessions.")
    figure, axes = figures.sheet(1, 1, (7.4, 0.9 + 0.2 * len(told)))
    sizes = np.array([size for _, size in told])
    colours = [figures.BEFORE if abs(size) > found.limit_std else AFTER for size in sizes]
    axes.barh(range(len(told)), sizes, color=colours)
    axes.set_yticks(range(len(told)), [_short(c.name) for c, _ in told])
    axes.invert_yaxis()
    for end in (-found.limit_std, found.limit_std):
        axes.axvline(end, color=MUTED, lw=1, ls="--")
    axes.set_xlabel("change over its standard uncertainty; changed: beyond the dashed lines")
    return figure


def _short(name: str) -> str:
    """Return a long combination of parameters by its first, and how many more there are."""
    first, *others = re.split(r" [+-] ", name)
    return name if len(name) < LONG else f"{first} with {len(others)} others"


def _study(found: Study) -> Sheet:
    if found.position is None or found.advice is None:
        from deltacal_gen.pages import studies

        tried = studies.tried(found)
        figure, axes = figures.sheet(1, 1, (7.4, 0.9 + 0.3 * len(tried)))
        figures.chances(axes, tried)
        return figure
    figure, (spread, more) = figures.sheet(1, 2, (10, 3.5))
    figures.before_and_after(spread, found.position)
    figures.enough(more, found.advice)
    return figure


def _batch(found: Batch) -> Sheet:
    done = [row for row in found.rows if row.in_mm]
    if not done:
        raise NothingToShow("there is nothing to draw: no recording at rest was done.")
    figure, axes = figures.sheet(1, 1, (7.4, 0.8 + 0.16 * len(done)))
    figures.fleet(axes, done)
    return figure


_DRAWERS: Mapping[type[Answer], Callable[[Any], Sheet]] = {
    Result: figures.calibration,
    Diagnosis: figures.diagnosis,
    Plan: lambda found: plans.conditions([found]),
    Validation: _validation,
    Comparison: _comparison,
    Study: _study,
    Batch: _batch,
}
