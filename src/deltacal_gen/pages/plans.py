"""The picture of measuring plans: condition number against the number of poses."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.pages import figures
from deltacal_gen.pages.figures import plt
from deltacal_gen.planning.matrix import Plan


def figure(plans: Plan | Sequence[Plan], path: str | Path) -> None:
    """Draw condition numbers against n with the chosen n marked, as in Figs 6 and 7 of the paper.

    Parameters
    ----------
    path : path
        The ending says the format: ``.svg``, ``.png``, ``.pdf``.

    Raises
    ------
    UsageError
        No condition number is finite.
    InputError
        The file cannot be written.
    """
    drawn = [p for p in ([plans] if isinstance(plans, Plan) else plans) if math.isfinite(p.steps[-1].condition)]
    if not drawn:
        raise UsageError("there is nothing to draw: no set of poses has the full rank.")
    style: Any = figures.STYLE
    with plt.rc_context(style):
        canvas, axes = plt.subplots(figsize=(6.4, 3.8), layout="constrained")
        for p, colour in zip(drawn, plt.get_cmap("viridis")(np.linspace(0.1, 0.7, len(drawn))), strict=True):
            steps = [step for step in p.steps if math.isfinite(step.condition)]
            n, condition = [step.n for step in steps], [step.condition for step in steps]
            points = f"{len(p.tools)} reference point{'s' if len(p.tools) > 1 else ''}"
            label = f"{p.model}, {points}, {p.scaling} scaling, {p.norm} norm"
            axes.plot(n, condition, "o-", markersize=3, linewidth=1.2, color=colour, label=label)
            for step in (step for step in steps if step.n == p.chosen):
                at = (step.n, step.condition)
                axes.plot(*at, "o", markersize=9, markerfacecolor="none", markeredgecolor=colour)
                axes.annotate(f"n = {step.n}", at, (0, 9), textcoords="offset points", ha="center", color=colour)
        shown = [step.condition for p in drawn for step in p.steps if math.isfinite(step.condition)]
        if max(shown) > 5 * min(shown):
            axes.set_yscale("log")
        axes.locator_params(axis="x", integer=True)
        axes.margins(y=0.2)
        axes.grid(alpha=0.25, linewidth=0.6)
        axes.set_xlabel("poses per layer n [1]")
        axes.set_ylabel("condition number κ [1]")
        canvas.legend(loc="outside upper left", frameon=False)
        try:
            figures.save(canvas, path)
        except (OSError, ValueError) as error:
            raise InputError(f"the figure cannot be written: {error}.", "Check folder and ending.", file=path) from None
        finally:
            plt.close(canvas)
