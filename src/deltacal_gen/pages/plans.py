"""Pictures of plans: condition number against the number of poses; the course of an exciting trajectory."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.errors import FileNotWritable, NothingToShow
from deltacal_gen.files.columns import Columns
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.limits import PATTERNS, limits_of
from deltacal_gen.pages import figures
from deltacal_gen.pages.figures import mpl
from deltacal_gen.results.plan import MotionPlan, Plan
from deltacal_gen.states import TIME
from deltacal_gen.units import joint_factors, joint_names


def conditions(plans: Sequence[Plan]) -> figures.Sheet:
    """Draw condition numbers against n with the chosen n marked, as in Figs 6 and 7 of the paper.

    Raises
    ------
    UsageError
        No condition number is finite.
    """
    drawn = [p for p in plans if p.condition and p.condition[-1] is not None]
    if not drawn:
        raise NothingToShow("there is nothing to draw: no set of poses has the full rank.")
    canvas, axes = figures.sheet(1, 1, (6.4, 3.8))
    for p, colour in zip(drawn, mpl.colormaps["viridis"](np.linspace(0.1, 0.7, len(drawn))), strict=True):
        found = {n: k for n, k in zip(p.n, p.condition, strict=True) if k is not None}
        points = f"{len(p.tools_mm)} reference point{'s' if len(p.tools_mm) > 1 else ''}"
        label = f"{p.model}, {points}, {p.scaling} scaling, {p.norm} norm"
        axes.plot(*zip(*found.items(), strict=True), "o-", markersize=3, linewidth=1.2, color=colour, label=label)
        if p.chosen in found:
            at = (p.chosen, found[p.chosen])
            axes.plot(*at, "o", markersize=9, markerfacecolor="none", markeredgecolor=colour)
            axes.annotate(f"n = {p.chosen}", at, (0, 9), textcoords="offset points", ha="center", color=colour)
    shown = [k for p in drawn for k in p.condition if k is not None]
    if max(shown) > 5 * min(shown):
        axes.set_yscale("log")
    axes.locator_params(axis="x", integer=True)
    axes.margins(y=0.2)
    axes.grid(alpha=0.25, linewidth=0.6)
    axes.set_xlabel("poses per layer n [1]")
    axes.set_ylabel("condition number κ [1]")
    canvas.legend(loc="outside upper left", frameon=False)
    return canvas


def write(plans: Sequence[Plan], path: str | Path) -> None:
    """Write the picture of plans; the ending says the format: ``.svg``, ``.png``, ``.pdf``."""
    style: Any = figures.STYLE
    with mpl.rc_context(style):
        _saved(conditions(plans), path)


def trajectory(robot: Robot, plan: MotionPlan, columns: Columns, path: str | Path) -> None:
    """Draw joints, speeds and accelerations over time, run after run, with the limits between which they stay."""
    machine = mechanism_of(robot)
    unit, limbs = machine.joint_unit, machine.limbs
    factors = np.array(joint_factors(unit, limbs))
    low, high, speed, acceleration = (values / factors for values in limits_of(robot)[0])
    run, time = np.asarray(columns["run"]), np.asarray(columns[TIME])
    at = time + (run - 1) * plan.period_s
    style: Any = figures.STYLE
    words = ("joint", "speed", "acceleration")
    with mpl.rc_context(style):
        canvas, rows = figures.sheet(3, 1, (7.2, 6.2), sharex=True)
        colours = mpl.colormaps["viridis"](np.linspace(0.05, 0.85, limbs))
        ends = ((low, high), (-speed, speed), (-acceleration, acceleration))
        for axes, pattern, word, limits in zip(rows, PATTERNS, words, ends, strict=True):
            names = joint_names(unit, limbs, pattern)
            for j, (name, colour) in enumerate(zip(names, colours, strict=True)):
                axes.plot(at, columns[name], linewidth=1.1, color=colour, label=f"joint {j + 1}")
                for end in limits:
                    axes.axhline(end[j], linewidth=0.7, linestyle=(0, (4, 3)), color=colour, alpha=0.6)
            for k in range(1, plan.runs):
                axes.axvline(k * plan.period_s, linewidth=0.6, color="0.6")
            units = sorted({figures.JOINT_UNITS[name.partition("_")[2]] for name in names})
            axes.set_ylabel(f"{word}, {' or '.join(units)}")
            axes.grid(alpha=0.25, linewidth=0.6)
        rows[-1].set_xlabel(f"time, s: {plan.runs} run{'s' if plan.runs > 1 else ''} of {plan.period_s:g} s")
        canvas.suptitle(f"{plan.headline}; limits dashed", fontsize="medium")
        handles, labels = rows[0].get_legend_handles_labels()
        canvas.legend(handles, labels, loc="outside lower center", ncols=limbs, frameon=False)
        _saved(canvas, path)


def _saved(canvas: Any, path: str | Path) -> None:
    try:
        figures.save(canvas, path)
    except (OSError, ValueError) as error:
        raise FileNotWritable(
            f"the figure cannot be written: {error}.", "Check folder and ending.", file=path
        ) from None
