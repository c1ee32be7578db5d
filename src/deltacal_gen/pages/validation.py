"""The page of a validation: the error on readings that no fit has seen, and the figures of the norms."""

from __future__ import annotations

from functools import partial

import numpy as np
from matplotlib.axes import Axes

from deltacal_gen.pages import report
from deltacal_gen.pages.figures import AFTER, BEFORE, INK, MUTED
from deltacal_gen.results.base import shown_in
from deltacal_gen.results.document import decimals
from deltacal_gen.results.validation import Iso230, Iso9283, Validation

WIDTH = 2.0  # standard deviations that a band shows to either side: those of ISO 230-2
SIZE = (7.4, 3.2)  # inches, of the picture of an axis
_ISO9283 = {
    "AP_mean_mm": "accuracy of a pose AP, mean",
    "AP_max_mm": "accuracy of a pose AP, largest",
    "RP_mean_mm": "repeatability of a pose RP, mean",
    "RP_max_mm": "repeatability of a pose RP, largest",
    "AD_mean_mm": "accuracy of a distance AD, mean",
    "AD_max_mm": "accuracy of a distance AD, largest",
    "RD_max_mm": "repeatability of a distance RD, largest",
}
_ISO230 = {
    "A_mm": "accuracy A",
    "E_mm": "systematic deviation E",
    "R_mm": "repeatability R",
    "B_mm": "reversal B",
    "M_mm": "mean deviation M",
}


def page(found: Validation) -> str:
    """Return the page of a validation."""
    unit, length = shown_in(found)
    return report.page_of(
        "validation",
        title="Validation",
        found=found,
        told=report.told(found),
        unit=unit,
        norms=norms(found.iso9283, found.iso230),
        rows=[(str(row.line), f"{row.error_mm / length:.4g}") for row in found.rows],
        made=found.made,
    )


def norms(iso9283: Iso9283 | None, iso230: Iso230 | None) -> list[tuple[str, list[tuple[str, str]], str, str]]:
    """Return of each norm whose figures there are its title, its figures in words, a note, and a picture or ""."""
    picture = report.picture(partial(axis, found=iso230), SIZE) if iso230 and iso230.places else ""
    return [
        *_norm(iso9283, "ISO 9283, {} poses", _ISO9283, ""),
        *_norm(iso230, "ISO 230-2, {} positions", _ISO230, picture),
    ]


def _norm(
    answer: Iso9283 | Iso230 | None, title: str, names: dict[str, str], picture: str
) -> list[tuple[str, list[tuple[str, str]], str, str]]:
    if answer is None:
        return []
    written = answer.to_dict()
    rows = [(words, decimals(written[key])) for key, words in names.items() if key in written]
    return [(title.format(answer.poses), rows, f"{answer.note[:1].upper()}{answer.note[1:]}.", picture)]


def axis(axes: Axes, found: Iso230) -> None:
    """Draw the mean deviations of an axis, position by position, from either side with two standard deviations."""
    at = np.array([p.at for p in found.places])
    sides = (
        ("upwards", "o-", AFTER, [(p.up_mm, p.up_std_mm) for p in found.places]),
        ("downwards", "s--", BEFORE, [(p.down_mm, p.down_std_mm) for p in found.places]),
    )
    for words, line, color, values in sides:
        mean, std = np.array(values).T
        axes.fill_between(at, mean - WIDTH * std, mean + WIDTH * std, color=color, alpha=0.15, lw=0)
        axes.plot(at, mean, line, ms=3.5, lw=1.2, color=color, label=words)
    axes.plot(at, [(p.up_mm + p.down_mm) / 2 for p in found.places], ":", color=INK, lw=1, label="mean of both")
    axes.axhline(0.0, color=MUTED, lw=0.8)
    axes.set_xlabel(f"position of the joint, {found.unit}")
    axes.set_ylabel("attained less wanted, mm")
    axes.legend(frameon=False, fontsize=8, ncols=3)
