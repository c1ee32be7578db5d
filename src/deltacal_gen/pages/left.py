"""What a calibration leaves of every reading: in the order of the recording, how it spreads, and where."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes

from deltacal_gen.pages.figures import AFTER, BEFORE, MUTED
from deltacal_gen.results.base import shown_in
from deltacal_gen.results.result import Result

ORDINARY = 98  # per cent of the readings that set a scale: those that are far off do not stretch it
BINS = 30
VIEWS = (("from above", 0, 1), ("from the side", 0, 2))
FLAT = 1e-6  # mm: poses that differ by less along an axis lie in a plane


@dataclass(frozen=True)
class Left:
    """What a fit leaves, in the unit that people read it in.

    Attributes
    ----------
    errors : (R, k) array
        Measured minus calibrated; nan where nothing was read.
    line : (R,) array
        Of the recording.
    place : (R, 3) array
        Where the calibrated machine's tool was, in {O} [mm].
    gross : tuple of int
        Lines of gross errors.
    sigma : float
        Noise of a component.
    unit : str
    """

    errors: np.ndarray
    line: np.ndarray
    place: np.ndarray
    gross: tuple[int, ...]
    sigma: float
    unit: str

    @property
    def size(self) -> np.ndarray:
        """Length (R,) of each error."""
        size: np.ndarray = np.sqrt(np.nansum(self.errors**2, axis=1))
        return size

    @property
    def top(self) -> float:
        """Where a scale of lengths ends."""
        return 1.2 * float(max(np.percentile(self.size, ORDINARY), self.sigma))

    @property
    def views(self) -> tuple[tuple[str, int, int], ...]:
        """From where poses are looked at: no side of a plane."""
        wide = np.ptp(self.place, axis=0) > FLAT
        return tuple((words, a, b) for words, a, b in VIEWS if wide[a] and wide[b] and np.isfinite(self.place).all())


def left_of(found: Result) -> Left | None:
    """Return what a fit leaves, as its answer's figures are shown; None in answers that do not hold it."""
    if found.residuals is None:
        return None
    unit, size = shown_in(found)
    return Left(
        errors=found.residuals.residual_mm / size,
        line=found.residuals.line,
        place=found.residuals.position_mm,
        gross=found.gross_errors or (),
        sigma=found.sigma_mm / size,
        unit=unit,
    )


def in_order(axes: Axes, left: Left) -> None:
    """Draw the error of each reading, in the order of the recording; what is beyond the scale, or gross, at its end."""
    size, top = left.size, left.top
    far = (size > top) | np.isin(left.line, left.gross)
    axes.plot(left.line[~far], size[~far], ".", color=AFTER, ms=4)
    axes.plot(left.line[far], np.minimum(size[far], top), "^", color=BEFORE, ms=5)
    expected = left.sigma * np.sqrt(left.errors.shape[1])
    axes.axhline(expected, color=MUTED, lw=1, ls="--")
    axes.text(1.0, expected, " noise", transform=axes.get_yaxis_transform(), color=MUTED, fontsize=8, va="center")
    axes.set_ylim(0, 1.06 * top)
    axes.set_xlabel("line of the recording")
    axes.set_ylabel(f"residual, {left.unit}")
    axes.set_title(f"In the order of the recording{f' ({far.sum()} beyond the scale)' if far.any() else ''}")


def spread(axes: Axes, left: Left) -> None:
    """Draw how often errors are how large, beside noise of the size that is taken as known."""
    errors = left.errors[np.isfinite(left.errors)]
    end = max(4 * left.sigma, float(np.percentile(np.abs(errors), ORDINARY)))
    edges = np.linspace(-end, end, BINS + 1)
    axes.hist(np.clip(errors, -end, end), bins=edges.tolist(), color=AFTER, alpha=0.75)
    if left.sigma > 0:
        x = np.linspace(-end, end, 200)
        curve = np.exp(-0.5 * (x / left.sigma) ** 2) / (left.sigma * np.sqrt(2 * np.pi))
        axes.plot(x, curve * len(errors) * (edges[1] - edges[0]), color=MUTED, lw=1, ls="--", label="noise")
        axes.legend(frameon=False, loc="upper right")
    axes.set_xlabel(f"residual of a component, {left.unit}")
    axes.set_ylabel("count")
    axes.set_title("Distribution of the residuals")


def places(axes: Axes, left: Left, view: tuple[str, int, int]) -> None:
    """Draw where the tool was measured, and what is left there."""
    words, a, b = view
    order = np.argsort(left.size)  # the largest on top
    dots = axes.scatter(
        left.place[order, a],
        left.place[order, b],
        c=left.size[order],
        s=20,
        cmap="viridis",
        vmin=0,
        vmax=left.top,
        linewidths=0,
    )
    axes.set_aspect("equal")
    axes.margins(0.08)
    axes.set_xlabel(f"{'xyz'[a]}, mm")
    axes.set_ylabel(f"{'xyz'[b]}, mm")
    axes.figure.colorbar(dots, ax=axes, orientation="horizontal", shrink=0.7, label=f"residual, {left.unit}")
    axes.set_title(f"Where it was measured{f', {words}' if len(left.views) > 1 else ''}")
