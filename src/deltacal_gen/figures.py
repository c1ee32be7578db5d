"""Pictures of a calibration: quiet, with units, readable on their own.

Matplotlib is imported here and only when a picture is asked for; no window is ever opened.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import matplotlib as mpl

mpl.use("Agg")

import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

INK, MUTED, BEFORE, AFTER = "#1c2733", "#6b7885", "#c8553d", "#2a6f97"
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


def save(figure: Figure, path: str | Path) -> None:
    """Write a figure, the same bytes for the same content."""
    path = Path(path)
    metadata = {"Date": None} if path.suffix == ".svg" else {"Software": None}
    figure.savefig(path, dpi=150, metadata=metadata if path.suffix in (".svg", ".png") else None)
    plt.close(figure)


def calibration(result: Mapping[str, Any], path: str | Path, check: Sequence[Mapping[str, Any]] = ()) -> None:
    """Draw a RESULT.json: errors by stage, parameters with their deviation, the tool's uncertainty over the workspace.

    Parameters
    ----------
    check : sequence of mappings, optional
        Machines with their errors (N,) [mm] on poses that no fit has seen: ``machine, errors_mm``.
    """
    with mpl.rc_context(STYLE):
        figure, axes = plt.subplots(2, 2, figsize=(10, 7.2), constrained_layout=True)
        _stages(axes[0, 0], result)
        if check:
            _check(axes[0, 1], check)
        else:
            _readings(axes[0, 1], result)
        _parameters(axes[1, 0], result)
        _workspace(axes[1, 1], result)
        name = result["robot"]["robot"]["name"]
        held = result["heldout_rms_mm"]
        figure.suptitle(
            f"{name}, {result['model']}: {result['before_rms_mm']:.3f} mm before, "
            + (f"{held:.4f} mm on held-out readings" if held is not None else f"{result['train_rms_mm']:.4f} mm after"),
            x=0.01,
            ha="left",
            fontsize=12,
        )
        save(figure, path)


def _stages(axes: Axes, result: Mapping[str, Any]) -> None:
    bars = [("robot file", result["before_rms_mm"], BEFORE)]
    for stage in result["stages"]:
        name = "encoder offsets" if stage["stage"] == "rough" else result["model"]
        bars.append((name, stage["train_rms_mm"], AFTER))
    if result["heldout_rms_mm"] is not None:
        bars.append(("held out", result["heldout_rms_mm"], AFTER))
    names, values, colours = zip(*bars, strict=True)
    axes.barh(names, values, color=colours, height=0.6)
    axes.invert_yaxis()
    axes.set_xscale("log")
    axes.set_xlim(min(*values, result["sigma_mm"]) / 2, max(values) * 4)
    for i, value in enumerate(values):
        axes.text(value * 1.08, i, f"{value:.4g}", va="center")
    axes.axvline(result["sigma_mm"], color=MUTED, lw=1, ls="--")
    axes.text(result["sigma_mm"], -0.62, f"noise ({result['sigma_source']})", color=MUTED, ha="center", fontsize=8)
    axes.set_xlabel("rms of the readings, mm")
    axes.set_title("What each stage leaves", pad=16)


def _check(axes: Axes, check: Sequence[Mapping[str, Any]]) -> None:
    colours = [BEFORE, "#e9a25b", AFTER]
    for row, colour in zip(check, colours, strict=False):
        axes.plot(np.maximum(row["errors_mm"], 1e-4), ".", ms=4, color=colour, label=row["machine"])
    axes.set_yscale("log")
    axes.set_xlabel("check pose, top to bottom layer")
    axes.set_ylabel("position error, mm")
    axes.set_title("Error at poses that no fit has seen")
    axes.legend(frameon=False, loc="upper center", bbox_to_anchor=(0.5, -0.18), ncols=3)


def _readings(axes: Axes, result: Mapping[str, Any]) -> None:
    s = np.array(result["singular_values"])
    axes.semilogy(np.arange(1, len(s) + 1), np.maximum(s / s[0], 1e-17), ".", color=AFTER)
    axes.axhline(result["rank_tolerance"], color=MUTED, lw=1, ls="--")
    axes.text(1, result["rank_tolerance"] * 1.6, "rank tolerance", color=MUTED, fontsize=8)
    axes.set_xlabel("direction")
    axes.set_ylabel("singular value, relative")
    axes.set_title(f"The readings see {result['rank']} of {len(s)} directions")


def _parameters(axes: Axes, result: Mapping[str, Any]) -> None:
    shown = [p for p in result["parameters"] if p["status"] in ("identified", "pinned by prior") and p["std"]]
    shown = sorted(shown, key=lambda p: -abs(p["value"]) / p["std"])[:14]
    title = "Parameters found, with 2 standard deviations"
    if not shown:
        axes.text(
            0.5, 0.5, "no single parameter is identified,\nonly combinations", ha="center", va="center", color=MUTED
        )
        axes.set_axis_off()
        axes.set_title(title)
        return
    for i, p in enumerate(shown):
        colour = AFTER if p["unit"] == "mm" else "#5a8f69"
        axes.errorbar(p["value"], i, xerr=2 * p["std"], fmt="o", ms=4, color=colour, capsize=2, lw=1)
    axes.set_yticks(range(len(shown)), [f"{p['name']} [{p['unit']}]" for p in shown])
    axes.invert_yaxis()
    axes.axvline(0, color=MUTED, lw=0.8)
    axes.set_xlabel("actual minus robot file")
    axes.set_title(title)


def _workspace(axes: Axes, result: Mapping[str, Any]) -> None:
    found = result["workspace"]
    if not found:
        axes.text(0.5, 0.5, "the robot file has no workspace", ha="center", va="center", color=MUTED)
        axes.set_axis_off()
        return
    points = np.array([p["target_mm"] for p in found["points"]])
    size = np.linalg.norm([p["std_mm"] for p in found["points"]], axis=1)
    layers = np.unique(points[:, 2])
    span = 2.4 * np.abs(points[:, 0]).max() + 1e-9
    for k, z in enumerate(layers[::-1]):
        chosen = points[:, 2] == z
        dots = axes.scatter(
            points[chosen, 0] + k * span,
            points[chosen, 1],
            c=size[chosen],
            s=26,
            cmap="viridis",
            vmin=0,
            vmax=size.max(),
        )
        axes.text(k * span, points[:, 1].max() * 1.25, f"z = {z:.0f} mm", ha="center", fontsize=8, color=MUTED)
    axes.set_aspect("equal")
    axes.set_xticks([])
    axes.set_yticks([])
    axes.spines[:].set_visible(False)
    axes.figure.colorbar(
        dots, ax=axes, orientation="horizontal", shrink=0.7, label="standard deviation of the position, mm"
    )
    axes.set_title("How well the tool position is known, layer by layer", pad=22)
