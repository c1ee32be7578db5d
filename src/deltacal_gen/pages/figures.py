"""Pictures of calibrations and diagnoses: quiet, with units, readable on their own.

Matplotlib is imported here and only when a picture is asked for; no window is ever opened, and pyplot, which a
notebook or a program may use in its own way, is not touched.
"""

from __future__ import annotations

import io
import math
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.ticker import PercentFormatter

from deltacal_gen.files.writing import staging
from deltacal_gen.results.base import shown_in
from deltacal_gen.results.batch import Row
from deltacal_gen.results.diagnosis import Baseline, Diagnosis, Effect, Final, Hint, PartialResiduals, Verdict
from deltacal_gen.results.parts import EffectName
from deltacal_gen.results.places import Places
from deltacal_gen.results.result import Result, Status
from deltacal_gen.results.study import Advice, Position, Study, Suspect
from deltacal_gen.states import of_column

VERDICTS = {
    Verdict.ADEQUATE: "no model error found",
    Verdict.MISSING_PHYSICS: "effect found",
    Verdict.UNEXPLAINED: "residual not explained",
}
MOST_LAYERS = 12  # of a workspace, drawn side by side
INK, MUTED, BEFORE, AFTER = "#1c2733", "#6b7885", "#c8553d", "#2a6f97"
RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")
STYLE: dict[Any, Any] = {
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "axes.edgecolor": MUTED,
    "axes.labelcolor": INK,
    "axes.titlesize": 10,
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "xtick.color": MUTED,
    "ytick.color": MUTED,
    "text.color": INK,
    "svg.hashsalt": "deltacal",
    "svg.fonttype": "none",
}


def decades(axis: Axis) -> None:
    """Label a logarithmic axis in plain type: its powers of ten, or twice and five times them where those are few."""
    low, high = sorted(axis.get_view_interval())
    exponents = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    inside = [e for e in exponents if low <= 10.0**e <= high]
    ticks = [(1, e) for e in inside[:: 1 + len(inside) // 7]]
    if len(ticks) < 3:
        ticks = [(m, e) for e in exponents for m in (1, 2, 5) if low <= m * 10.0**e <= high]
    axis.set_ticks([m * 10.0**e for m, e in ticks], [decade(m, e) for m, e in ticks], minor=False)
    axis.set_ticks([], minor=True)


def decade(mantissa: int, exponent: int) -> str:
    """Return a digit times a power of ten as a reader writes it: 200, 0.005, 2·10⁻⁵."""
    if -3 <= exponent < 4:
        return f"{mantissa * 10.0**exponent:g}"
    return ("" if mantissa == 1 else f"{mantissa}·") + f"10{str(exponent).translate(RAISED)}"


class Sheet(Figure):
    """A figure that a notebook shows of itself."""

    def _repr_svg_(self) -> str:
        stream = io.StringIO()
        self.savefig(stream, format="svg")
        return stream.getvalue()


def sheet(rows: int, columns: int, size: tuple[float, float], **how: Any) -> tuple[Sheet, Any]:
    """Return a figure of a size [inch] with its axes; an array of them where there are several."""
    figure = Sheet(figsize=size, layout="constrained")
    return figure, figure.subplots(rows, columns, **how)


def save(figure: Figure, path: str | Path) -> None:
    """Write a figure, the same bytes for the same content."""
    path = Path(path)
    metadata = {"Date": None} if path.suffix == ".svg" else {"Software": None}
    ending = path.suffix
    with staging([path]) as parts:
        figure.savefig(
            parts[path], dpi=150, format=ending[1:], metadata=metadata if ending in (".svg", ".png") else None
        )


def write(found: Result | Diagnosis, path: str | Path) -> None:
    """Write the picture of a result or a diagnosis."""
    with mpl.rc_context(STYLE):
        save(calibration(found) if isinstance(found, Result) else diagnosis(found), path)


def calibration(result: Result) -> Sheet:
    """Draw a result: errors by stage, parameters with their deviation, the tool's uncertainty over the workspace."""
    with mpl.rc_context(STYLE):
        figure, axes = sheet(2, 2, (10, 7.2))
        stages(axes[0, 0], result)
        readings(axes[0, 1], result)
        parameters(axes[1, 0], result)
        workspace(axes[1, 1], result)
        name = result.robot.robot.name
        held, (unit, size) = result.heldout_rms_mm, shown_in(result)
        left, of = (result.train_rms_mm, "after") if held is None else (held, "on held-out readings")
        figure.suptitle(
            f"{name}, {result.model}: {result.before_rms_mm / size:.3f} {unit} before, {left / size:.4f} {unit} {of}",
            x=0.01,
            ha="left",
            fontsize=12,
        )
    return figure


def stages(axes: Axes, result: Result) -> None:
    """Draw the rms of the readings stage by stage, against the noise."""
    bars = [("robot file", result.before_rms_mm, BEFORE)]
    for stage in result.stages or ():
        name = "encoder offsets" if stage.stage == "rough" else result.model
        bars.append((name, stage.train_rms_mm, AFTER))
    if result.heldout_rms_mm is not None:
        bars.append(("held out", result.heldout_rms_mm, AFTER))
    unit, size = shown_in(result)
    bars, sigma = [(name, mm / size, colour) for name, mm, colour in bars], result.sigma_mm / size
    names, values, colours = zip(*bars, strict=True)
    axes.barh(names, values, color=colours, height=0.6)
    axes.invert_yaxis()
    axes.set_xscale("log")
    axes.set_xlim(min(*values, sigma) / 2, max(values) * 4)
    decades(axes.xaxis)
    for i, value in enumerate(values):
        axes.text(max(value, sigma) * 1.08, i, f"{value:.4g}", va="center")  # beside the line of the noise
    axes.axvline(sigma, color=MUTED, lw=1, ls="--")
    axes.text(sigma, -0.62, f"noise ({result.sigma_source})", color=MUTED, ha="center", fontsize=8)
    axes.set_xlabel(f"rms of the readings, {unit}")
    axes.set_title("Residual, stage by stage", pad=16)


def _nothing(axes: Axes, title: str, words: str) -> None:
    """Say in words why there is no picture."""
    axes.text(0.5, 0.5, words, ha="center", va="center", color=MUTED)
    axes.set_axis_off()
    axes.set_title(title)


def readings(axes: Axes, result: Result) -> None:
    """Draw the singular values of the identification matrix, and where they stop counting."""
    s = result.singular_values
    if not len(s):
        _nothing(axes, "Directions", "no source error is identifiable: joints are read, not the platform")
        return
    axes.semilogy(np.arange(1, len(s) + 1), np.maximum(s / s[0], 1e-17), ".", color=AFTER)
    axes.axhline(result.rank_tolerance, color=MUTED, lw=1, ls="--")
    decades(axes.yaxis)
    axes.text(1, result.rank_tolerance * 1.6, "rank tolerance", color=MUTED, fontsize=8)
    axes.set_xlabel("direction")
    axes.set_ylabel("singular value, relative")
    axes.set_title(f"{result.rank} of {len(s)} directions are identifiable")


def parameters(axes: Axes, result: Result) -> None:
    """Draw the clearest parameters with two standard deviations."""
    known = (Status.IDENTIFIED, Status.BY_PRIOR)
    told = [(p, p.std) for p in result.parameters if p.status in known and p.std]
    shown = sorted(told, key=lambda both: -abs(both[0].value) / both[1])[:14]
    title = "Parameters, with 2 standard uncertainties"
    if not shown:
        _nothing(axes, title, "no single parameter is identified,\nonly combinations")
        return
    for i, (p, std) in enumerate(shown):
        colour = AFTER if p.unit == "mm" else "#5a8f69"
        axes.errorbar(p.value, i, xerr=2 * std, fmt="o", ms=4, color=colour, capsize=2, lw=1)
    axes.set_yticks(range(len(shown)), [f"{p.name} [{p.unit}]" for p, _ in shown])
    axes.invert_yaxis()
    axes.axvline(0, color=MUTED, lw=0.8)
    axes.set_xlabel("actual minus robot file")
    axes.set_title(title)


def workspace(axes: Axes, result: Result) -> None:
    """Draw the standard deviation of the tool position over the workspace."""
    found = result.workspace
    if not found:
        _nothing(axes, "", "the robot file has no workspace")
        return
    points = np.array([p.target_mm for p in found.points])
    size = np.linalg.norm([p.std_mm for p in found.points], axis=1)
    layers = np.unique(points[:, 2])
    scattered = len(layers) > MOST_LAYERS  # an open chain's positions: seen from above
    where = "from above" if scattered else "layer by layer" if len(layers) > 1 else None  # a plane has no layers
    if scattered:
        layers = layers[:1]
    span = 2.4 * np.abs(points[:, 0]).max() + 1e-9
    for k, z in enumerate(layers[::-1]):
        chosen = (points[:, 2] == z) | scattered
        dots = axes.scatter(
            points[chosen, 0] + k * span,
            points[chosen, 1],
            c=size[chosen],
            s=26,
            cmap="viridis",
            vmin=0,
            vmax=size.max(),
        )
        if len(layers) > 1:
            axes.text(k * span, points[:, 1].max() * 1.25, f"z = {z:.0f} mm", ha="center", fontsize=8, color=MUTED)
    if not np.ptp(points[:, 1]):  # one joint works along a line, which has no height of its own
        axes.set_ylim(points[0, 1] - span / 40, points[0, 1] + span / 40)
    axes.set_aspect("equal")
    axes.set_xticks([])
    axes.set_yticks([])
    axes.spines[:].set_visible(False)
    axes.figure.colorbar(
        dots, ax=axes, orientation="horizontal", shrink=0.7, label="standard uncertainty of the position, mm"
    )
    axes.set_title("Uncertainty of the tool position" + (f", {where}" if where else ""), pad=22)


# ------------------------------------------------------------------------------------------------------- diagnosis

JOINT_UNITS = {"deg": "deg", "mm": "mm", "deg_s": "deg/s", "mm_s": "mm/s", "deg_s2": "deg/s²", "mm_s2": "mm/s²"}
PURE = "1"  # the unit of a number without one
_RANDOM = 0  # seed of the jitter that lets equal values of a channel be seen side by side


def channel_label(name: str) -> str:
    """Return a channel as a reader knows it, with its unit."""
    state = of_column(name)
    found = state.pattern.fullmatch(name)
    if not state.called or found is None:
        return name
    number, unit = (*found.groups(), "", "")[:2]
    unit = JOINT_UNITS.get(unit, unit) or state.unit.replace("degC", "°C")
    return state.called.format(i=number) + (f", {unit}" if unit != PURE else "")


def main_channel(found: Diagnosis) -> str | None:
    """Return the recorded channel that matters most, or None."""
    known = found.residuals.channels if found.residuals.partial is not None else ()
    return next((c.name for c in found.location.channels if c.name in known), None)


def before_title(found: Diagnosis, channel: str | None) -> str:
    """Return what stands over the picture of what was before: against a channel, or over the workspace."""
    partial = found.residuals.partial
    return "geometry alone" if channel is None or partial is None else partial.title


def against(axes: Axes, found: Diagnosis, channel: str, *, after: bool) -> None:
    """Draw what is left against a channel, on the scale of what geometry alone leaves."""
    partial = found.residuals.partial
    assert partial is not None  # `against` is asked of answers that have it
    values = found.residuals.channels[channel]
    levels = np.unique(values[np.isfinite(values)])
    few = len(levels) <= 5
    jitter = np.random.default_rng(_RANDOM).uniform(-0.09, 0.09, len(values)) * (
        np.diff(levels).min() if len(levels) > 1 else 1
    )
    axes.axhline(0, color=MUTED, lw=0.8)
    y = partial.after if after else partial.before
    axes.plot(values + (jitter if few else 0.0), y, "o", ms=3.2, mew=0, alpha=0.75, color=AFTER if after else BEFORE)
    _limits(axes, partial)
    axes.set_xlabel(channel_label(channel))
    axes.set_ylabel(f"{partial.of}, {partial.unit}")
    if few:
        ways = of_column(channel).levels
        words = {way: f"{way:+.0f}, {'increasing' if way > 0 else 'decreasing'}" for way in ways}
        axes.set_xticks(levels, [words.get(float(v), f"{v:g}") for v in levels])


def _limits(axes: Axes, partial: PartialResiduals) -> None:
    """Set the scale so that nearly all of both states fits; gross errors do not stretch it."""
    size = np.abs(np.concatenate([partial.before, partial.after]))
    top = 1.25 * float(np.nanpercentile(size, 98)) or 1.0
    axes.set_ylim(-top, top)


def bubbles(axes: Axes, found: Diagnosis, *, after: bool) -> None:
    """Draw how much is left where, seen from above: the size of a disc is the size of the residual."""
    at = found.residuals.position_mm
    unit, size = shown_in(found)
    sizes = [np.linalg.norm(r, axis=1) / size for r in (found.residuals.before_mm, found.residuals.after_mm)]
    top = float(np.nanpercentile(sizes[0], 98)) or 1.0
    shown = np.minimum(sizes[after], 1.3 * top)
    colour = AFTER if after else BEFORE
    axes.scatter(at[:, 0], at[:, 1], s=130 * shown / top, color=colour, alpha=0.55, linewidths=0)
    axes.set_aspect("equal")
    axes.margins(0.12)
    axes.set_xlabel("x, mm")
    axes.set_ylabel("y, mm")
    key = float(f"{top:.1g}")
    axes.scatter([], [], s=130 * key / top, color=colour, alpha=0.55, linewidths=0, label=f"{key:g} {unit}")
    axes.legend(frameon=False, loc="lower right", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.1, handletextpad=0.2)


def bars(axes: Axes, found: Diagnosis) -> None:
    """Draw the error on held-out readings before and after, against the noise."""
    first = AFTER if found.verdict is Verdict.ADEQUATE else BEFORE
    rows: list[tuple[str, Baseline | Final, str]] = [("geometry alone", found.baseline, first)]
    if found.effects or found.laws:
        rows.append(("with what was found", found.final, AFTER))
    unit, size = shown_in(found)
    values = [(r.train_rms_mm if r.heldout_rms_mm is None else r.heldout_rms_mm) / size for _, r, _ in rows]
    sigma = found.noise.sigma_mm / size
    axes.barh([r[0] for r in rows], values, color=[r[2] for r in rows], height=0.55)
    axes.invert_yaxis()
    axes.set_xlim(0, 1.25 * max(*values, sigma))
    for i, value in enumerate(values):
        right = max(value, sigma)  # clear of the line
        axes.annotate(f"{value:.4f}", (right, i), (5, 0), textcoords="offset points", va="center")
    axes.axvline(sigma, color=INK, lw=1, ls="--")
    axes.set_ylim(len(rows) - 0.45, -0.8)
    noise = (sigma, -0.5)
    axes.annotate("noise", noise, (5, 0), textcoords="offset points", va="center", color=MUTED)
    axes.set_xlabel(f"rms on held-out readings, {unit}")
    axes.tick_params(axis="y", length=0)


def diagnosis(found: Diagnosis) -> Sheet:
    """Draw a DIAGNOSIS.json on one sheet: before and after, against the channel that matters and over the workspace."""
    channel = main_channel(found)
    with mpl.rc_context(STYLE):
        figure, axes = sheet(1, 3, (11, 3.5), width_ratios=(1, 1, 1.05))
        if channel is None:
            bubbles(axes[0], found, after=False)
            bubbles(axes[1], found, after=True)
        else:
            against(axes[0], found, channel, after=False)
            against(axes[1], found, channel, after=True)
            axes[1].set_ylabel("")
        axes[0].set_title(before_title(found, channel))
        axes[1].set_title("with what was found")
        bars(axes[2], found)
        names = [*("an unregistered formula" for _ in found.laws[:1])]
        names += [named(e, found.robot.places) for e in found.findings]
        title = "; ".join(names) if found.verdict is Verdict.MISSING_PHYSICS else VERDICTS[found.verdict]
        figure.suptitle(f"{found.robot.robot.name}: {title}", x=0.01, ha="left", fontsize=12)
    return figure


def named(effect: Effect | EffectName | Hint, places: Places, part: str | None = None) -> str:
    """Return an effect and where it sits."""
    return f"{effect.name.replace('_', ' ')}{places.at(effect.limbs, part)}"


# ------------------------------------------------------------------------------------------------- studies and fleets


def before_and_after(axes: Axes, found: Position) -> None:
    """Draw how the position error of a study's machines is spread, as built and calibrated."""
    states = ((found.before, "as built", BEFORE), (found.after, "calibrated", AFTER))
    for k, (spread, words, colour) in enumerate(states):
        count, middle = spread.histogram.count, spread.median_mm
        axes.stairs(count / max(count.max(), 1), spread.histogram.edges_mm, fill=True, color=colour, alpha=0.8)
        text = f"{words}: {middle:.3g} mm"
        axes.annotate(
            text, (middle, 1.0), (0, 5), textcoords="offset points", ha=("right", "left")[k == 0], color=colour
        )
    axes.set_xscale("log")
    decades(axes.xaxis)
    axes.set_ylim(0, 1.25)
    axes.set_yticks([])
    axes.spines["left"].set_visible(False)
    axes.set_xlabel("position error of a machine over the workspace (rms; the median is written), mm")


def enough(axes: Axes, found: Advice) -> None:
    """Draw the position error against how much is measured."""
    times = [e.times for e in found.enough]
    rms = [e.rms_mm for e in found.enough]
    axes.plot(times, rms, "o-", color=AFTER, ms=4)
    axes.plot([1.0], [rms[times.index(1.0)]], "o", color=AFTER, ms=9)
    axes.annotate("this plan", (1.0, rms[times.index(1.0)]), (8, 6), textcoords="offset points", color=INK)
    axes.set_xscale("log", base=2)
    axes.set_xticks(times, [f"{t:g}" for t in times])
    axes.set_ylim(0, 1.15 * max(rms) or 1.0)
    axes.set_xlabel("times the plan's readings")
    axes.set_ylabel("position error, mm")


def scatter(axes: Axes, found: Study) -> None:
    """Draw what a study leaves unknown of each parameter, as part of what was drawn."""
    told = [p for p in found.parameters if p.drawn_std > 0]
    part = [p.std / p.drawn_std for p in told]
    expected = [p.predicted_std / p.drawn_std for p in told]
    axes.bar(range(len(told)), part, color=AFTER, width=0.7, label="simulated")
    axes.plot(range(len(told)), expected, "_", color=INK, ms=8, mew=1.5, label="predicted")
    axes.axhline(1.0, color=MUTED, lw=1, ls="--")
    axes.set_xticks(range(len(told)), [p.name for p in told], rotation=90, fontsize=8)
    axes.set_ylabel("std after / drawn with")
    axes.legend(frameon=False, fontsize=8)


def fleet(axes: Axes, rows: Sequence[Row]) -> None:
    """Draw the errors of many recordings before and after, one line each."""
    for k, row in enumerate(rows):
        if row.before_mm and row.after_mm:
            axes.plot([row.before_mm, row.after_mm], [k, k], color=MUTED, lw=0.8)
            axes.plot([row.before_mm], [k], "o", color=BEFORE, ms=3.5)
        if row.after_mm:
            axes.plot([row.after_mm], [k], "o", color=AFTER, ms=3.5)
    axes.set_xscale("log")
    decades(axes.xaxis)
    axes.set_ylim(len(rows) - 0.5, -0.5)
    axes.set_yticks(range(len(rows)), [r.recording.removesuffix("/recording.csv") for r in rows], fontsize=7)
    axes.tick_params(axis="y", length=0)
    axes.set_xlabel("error before (red) and after (blue), mm")


def fleet_distribution(axes: Axes, rows: Sequence[Row]) -> None:
    """Draw which share of many recordings has an error below a given one, before and after."""
    before, after = [r.before_mm for r in rows], [r.after_mm for r in rows]
    for values, color, words in ((before, BEFORE, "before"), (after, AFTER, "after")):
        errors = np.sort([v for v in values if v])
        if len(errors):
            axes.step(errors, np.arange(1, len(errors) + 1) / len(errors), color=color, where="post", label=words)
    axes.set_xscale("log")
    decades(axes.xaxis)
    axes.set_ylim(0, 1)
    axes.yaxis.set_major_formatter(PercentFormatter(1.0, decimals=0))
    axes.set_xlabel("error, mm")
    axes.set_ylabel("recordings below it")
    axes.legend(frameon=False, loc="upper left")


def chances(axes: Axes, suspects: Sequence[tuple[str, Suspect]]) -> None:
    """Draw how often each suspicion was named right, with the 95 % interval of the chance."""
    for k, (_, s) in enumerate(suspects):
        axes.plot(s.interval, [k, k], color=MUTED, lw=1.5)
        if s.chance is not None:
            axes.plot([s.chance], [k], "o", color=AFTER, ms=5)
    axes.set_xlim(-0.02, 1.02)
    axes.set_ylim(len(suspects) - 0.5, -0.5)
    axes.set_yticks(range(len(suspects)), [name for name, _ in suspects])
    axes.tick_params(axis="y", length=0)
    axes.xaxis.set_major_formatter(PercentFormatter(1.0, decimals=0))
    axes.set_xlabel("said so; the line holds the chance with 95 %")
