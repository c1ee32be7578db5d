"""Pages to read: one self-contained HTML file, no script, no network, for light and dark screens and for print."""

from __future__ import annotations

import html
import io
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from deltacal_gen.figures import AFTER, BEFORE, INK, MUTED, STYLE, mpl, plt

_COLOURS = {INK: "var(--ink)", MUTED: "var(--muted)", BEFORE: "var(--before)", AFTER: "var(--after)"}
_CSS = """
:root { --ink: #1c2733; --muted: #66727e; --paper: #fdfdfb; --line: #d9dee2; --before: #c8553d; --after: #2a6f97; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e6eaee; --muted: #94a1ad; --paper: #14191e; --line: #333d46; --before: #e88a72; --after: #74b4d8; }
}
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 62rem; padding: 2rem 1.2rem 4rem; background: var(--paper); color: var(--ink);
  font: 16px/1.5 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
h1 { font-size: 1.5rem; line-height: 1.25; margin: 0.2rem 0 0.8rem; }
h2 { font-size: 1.05rem; margin: 2.2rem 0 0.5rem; }
.verdict { letter-spacing: 0.06em; text-transform: uppercase; font-size: 0.8rem; color: var(--muted); margin: 0; }
.lead { font-size: 1.1rem; max-width: 46rem; }
figure { margin: 0.8rem 0; } figure svg { width: 100%; height: auto; display: block; }
figcaption, .note { color: var(--muted); font-size: 0.88rem; max-width: 46rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: 0.92rem; } th { color: var(--muted); font-weight: 500; text-align: left; }
th, td { padding: 0.25rem 1.1rem 0.25rem 0; border-bottom: 1px solid var(--line); vertical-align: top; }
td.n { text-align: right; font-variant-numeric: tabular-nums; }
@media print { body { max-width: none; padding: 0; } figure, table { break-inside: avoid; } }
"""


def diagnosis(found: Mapping[str, Any]) -> str:
    """Return the page of a DIAGNOSIS.json."""
    machine = found["robot"]["robot"]["name"]
    headline = {
        "adequate": "Nothing is missing: geometry explains the readings",
        "missing_physics": "Found: " + "; ".join(_where(e) for e in found["effects"]),
        "unexplained": "A mismatch that no known effect explains",
    }[found["verdict"]]
    before, final = found["baseline"], found["final"]
    parts = [
        f'<p class="verdict">{_text(machine)}: {_text(found["verdict"].replace("_", " "))}</p>',
        f"<h1>{_text(headline)}</h1>",
        f'<p class="lead">{_text(found["summary"])}</p>',
        "<h2>Before and after</h2>",
        figure(_bars(before, final, found["noise"]), "Root mean square of the readings, each scalar once. "
                "Held-out readings took part neither in the fit nor, pose by pose, in their repeats."),
    ]  # fmt: skip
    residuals = found["residuals"]
    if residuals["before_mm"] and len(residuals["before_mm"][0]) == 3:
        channel = next((c["name"] for c in found["location"]["channels"] if c["name"] in residuals["channels"]), None)
        if channel is not None:
            parts += [
                f"<h2>Against {_text(channel)}</h2>",
                figure(
                    _against(residuals, channel),
                    f"Residual along the direction in which geometry alone leaves most: {found['location']['text']}.",
                ),
            ]
        parts += [
            "<h2>Over the workspace</h2>",
            figure(_map(residuals), "Size of the residual where it was measured, seen from above; one scale."),
        ]
    if found["effects"]:
        parts += ["<h2>What was found</h2>", _parameters(found["effects"])]
        for e in found["effects"]:
            if e["indistinguishable_from"]:
                others = ", ".join(e["indistinguishable_from"])
                parts.append(f'<p class="note">These poses cannot tell {_text(e["name"])} from {_text(others)}.</p>')
    if found["next_measurements"]:
        parts += ["<h2>What to measure next</h2>", *(_question(m) for m in found["next_measurements"])]
    parts += ["<h2>What was considered and why it lost</h2>", _rivals(found)]
    if found["not_tested"]:
        missing = [(t["name"], t["missing"]) for t in found["not_tested"]]
        parts += ["<h2>Not tested</h2>", table(("effect", "what is missing"), missing)]
    gross = found["gross_errors"]
    words = f"Lines {', '.join(map(str, gross))}: they took next to no part in the fit." if gross else "None."
    parts += ["<h2>Gross errors</h2>", f"<p>{words}</p>"]
    return page(f"{machine}: diagnosis", parts)


def page(title: str, parts: Sequence[str]) -> str:
    """Return a page of parts that are HTML already."""
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{_text(title)}</title><style>{_CSS}</style></head>\n<body>\n" + "\n".join(parts) + "\n</body></html>\n"
    )


def _question(asked: Mapping[str, Any]) -> str:
    """Return a proposed measurement: why, what to do, and its poses as a table."""
    why = asked["why"][0].upper() + asked["why"][1:]
    promise = asked["expected_chi2"]
    if promise is not None and asked["poses"]:
        why += f" (expected difference in chi2: {promise:.0f})"
    text = f"<p><b>{_text(why)}.</b> {_text(asked['text'])}</p>"
    if not asked["poses"]:
        return text
    names = list(dict.fromkeys(name for row in asked["poses"] for name in row))
    rows = [["" if row.get(n) is None else row[n] for n in names] for row in asked["poses"]]
    return text + table(names, rows)


def _where(effect: Mapping[str, Any]) -> str:
    limbs = effect["limbs"]
    return effect["title"] + (f", limb{'s' if len(limbs) > 1 else ''} {', '.join(map(str, limbs))}" if limbs else "")


def _text(value: object) -> str:
    return html.escape(str(value))


def table(head: Sequence[str], rows: Sequence[Sequence[object]]) -> str:
    """Return a table; it scrolls where the window is narrow."""
    top = "".join(f"<th>{_text(h)}</th>" for h in head)
    body = "".join(f"<tr>{''.join(map(_cell, row))}</tr>" for row in rows)
    return f'<div class="wide"><table><tr>{top}</tr>{body}</table></div>'


def _cell(value: object) -> str:
    return f'<td class="n">{value:.5g}</td>' if isinstance(value, float) else f"<td>{_text(value)}</td>"


def _parameters(effects: Sequence[Mapping[str, Any]]) -> str:
    rows = [
        (e["name"], "" if p["limb"] is None else str(p["limb"]), p["name"], float(p["value"]),
         "" if p["std"] is None else f"± {p['std']:.2g}", p["unit"])
        for e in effects
        for p in e["parameters"]
    ]  # fmt: skip
    return table(("effect", "limb", "parameter", "value", "one standard deviation", "unit"), rows)


def _rivals(found: Mapping[str, Any]) -> str:
    rows = [(r["name"], float(r["gain_chi2"]), r["why"]) for r in found["rejected"]]
    return table(("effect", "gain in chi2, alone", "why it is not named"), rows) if rows else "<p>No rival.</p>"


# --------------------------------------------------------------------------------------------------------- pictures


def figure(picture: Any, caption: str) -> str:
    """Return a Matplotlib figure as SVG whose colours follow the page's, light or dark."""
    stream = io.StringIO()
    picture.savefig(stream, format="svg", transparent=True, metadata={"Date": None})
    plt.close(picture)
    svg = stream.getvalue()
    svg = svg[svg.index("<svg") :]
    for colour, variable in _COLOURS.items():
        svg = svg.replace(colour, variable)
    return f"<figure>{svg}<figcaption>{_text(caption)}</figcaption></figure>"


def _bars(before: Mapping[str, Any], final: Mapping[str, Any], noise: Mapping[str, Any]) -> Any:
    rows = [
        ("geometry, fitted", before["train_rms_mm"], BEFORE),
        ("geometry, held out", before["heldout_rms_mm"], BEFORE),
    ]
    rows += [("with what was found, fitted", final["train_rms_mm"], AFTER)]
    rows += [("with what was found, held out", final["heldout_rms_mm"], AFTER)]
    shown = [r for r in rows if r[1] is not None]
    with mpl.rc_context(STYLE):
        picture, axes = plt.subplots(figsize=(8, 1.9), constrained_layout=True)
        axes.barh([r[0] for r in shown], [r[1] for r in shown], color=[r[2] for r in shown], height=0.62)
        axes.invert_yaxis()
        top = max(r[1] for r in shown)
        for i, r in enumerate(shown):
            axes.text(r[1] + 0.01 * top, i, f"{r[1]:.4f}", va="center")
        axes.set_xlim(0, 1.12 * top)
        axes.axvline(noise["sigma_mm"], color=MUTED, lw=1, ls="--")
        axes.set_xlabel(f"mm; dashed: noise {noise['sigma_mm']:.4f} mm ({noise['source']})")
    return picture


def _against(residuals: Mapping[str, Any], channel: str) -> Any:
    before, after = (np.array(residuals[k], dtype=float) for k in ("before_mm", "after_mm"))
    values = np.array([np.nan if v is None else v for v in residuals["channels"][channel]])
    along = np.linalg.svd(np.nan_to_num(before - np.nanmedian(before, axis=0)), full_matrices=False)[2][0]
    levels = np.unique(values[np.isfinite(values)])
    rng = np.random.default_rng(0)
    spread = rng.uniform(-0.08, 0.08, len(values)) * (np.ptp(levels) or 1) if len(levels) <= 5 else 0.0
    with mpl.rc_context(STYLE):
        picture, axes = plt.subplots(1, 2, figsize=(8, 2.9), sharey=True, constrained_layout=True)
        for a, r, colour, name in (
            (axes[0], before, BEFORE, "geometry alone"),
            (axes[1], after, AFTER, "with what was found"),
        ):
            a.plot(values + spread, r @ along, ".", ms=4, color=colour)
            a.axhline(0, color=MUTED, lw=0.8)
            a.set_title(name)
            a.set_xlabel(channel)
        axes[0].set_ylabel("residual, mm")
    return picture


def _map(residuals: Mapping[str, Any]) -> Any:
    at = np.array(residuals["position_mm"])
    before, after = (np.linalg.norm(np.array(residuals[k], dtype=float), axis=1) for k in ("before_mm", "after_mm"))
    top = float(np.nanpercentile(before, 98))
    with mpl.rc_context(STYLE):
        picture, axes = plt.subplots(1, 2, figsize=(8, 3.7), sharey=True, constrained_layout=True)
        for a, size, name in ((axes[0], before, "geometry alone"), (axes[1], after, "with what was found")):
            dots = a.scatter(at[:, 0], at[:, 1], c=size, s=16, cmap="viridis", vmin=0, vmax=top)
            a.set_aspect("equal")
            a.set_title(name)
            a.set_xlabel("x in {O}, mm")
        axes[0].set_ylabel("y in {O}, mm")
        picture.colorbar(dots, ax=axes, label="residual, mm", shrink=0.85)
    return picture
