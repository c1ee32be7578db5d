"""A machine as a line drawing: points, lines and paths in space, seen at an angle, as SVG in the page's colours."""

from __future__ import annotations

import html
import itertools
import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from deltacal_gen.mechanism import Array

WIDTH, HEIGHT, MARGIN = 640.0, 520.0, 46.0
AZIMUTH, ELEVATION = math.radians(-62.0), math.radians(18.0)
_COLOURS = {"base": "var(--muted)", "link": "var(--ink)", "platform": "var(--before)", "rod": "var(--after)"}
_WIDTHS = {"base": 1.2, "link": 3.4, "platform": 2.2, "rod": 1.8}
_SMALL = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_GREEK = {"phi": "φ", "alpha": "α", "beta": "β", "theta": "θ"}


def machine(found: Mapping[str, Any], axes: Sequence[str]) -> str:
    """Return the drawing of a machine of limbs, of what `derive.drawing` found.

    Parameters
    ----------
    axes : sequence of str
        Along which the platform moves: without z the machine is seen from the front.
    """
    points, lines, paths = found["points"], found["lines"], found["paths"]
    every = [p["at"] for p in points] + [e for line in lines for e in (line["from"], line["to"])]
    every += [(0.0, 0.0, 0.0), found["P"]]
    view = _View(np.array(every, dtype=float), flat="z" not in axes)
    parts = [_polygon(points, view, on) for on in ("base", "platform")]
    parts += [_path(p["points"], view) for p in paths]
    order = {"base": 0, "rod": 1, "platform": 2, "link": 3}
    for line in sorted(lines, key=lambda e: order[e["kind"]]):
        a, b = view(line["from"]), view(line["to"])
        dash = ' stroke-dasharray="5 4"' if line["kind"] == "base" else ""
        parts.append(
            f'<path d="M{a[0]:.1f} {a[1]:.1f}L{b[0]:.1f} {b[1]:.1f}" stroke="{_COLOURS[line["kind"]]}" '
            f'stroke-width="{_WIDTHS[line["kind"]]}"{dash}/>'
        )
    parts += _frame(view, (0.0, 0.0, 0.0), "O") + _frame(view, found["P"], "P")
    for p in points:
        x, y = view(p["at"])
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.4" fill="var(--card)" stroke="var(--ink)"/>')
    labels = _Labels([view(e) for e in every])
    said: set[tuple[str, str]] = set()
    front = _front(points, view)
    for p in (p for p in points if p["limb"] == front):
        index = str(p["limb"]).translate(_SMALL) if len({q["limb"] for q in points}) > 1 else ""
        parts.append(labels.put(view(p["at"]), _name(p["name"]) + index, "var(--ink)", bold=True))
    for line in sorted(lines, key=lambda e: e["limb"] != front):
        key = (line["label"], line["kind"])
        if line["label"] and key not in said:
            said.add(key)
            (x, y), (u, v) = view(line["from"]), view(line["to"])
            parts.append(labels.put(((x + u) / 2, (y + v) / 2), _name(line["label"]), _COLOURS[line["kind"]]))
    return _svg(parts, "The machine at its nominal pose, drawn from its closure equations")


def chain(origins: Array, rotations: Array, tool: Array) -> str:
    """Return the drawing of an open chain.

    Parameters
    ----------
    origins : (n + 1, 3) array
        The base and the links' frames [mm].
    rotations : (n + 1, 3, 3) array
    tool : (3,) array
    """
    every = np.vstack([origins, tool])
    view = _View(every, flat=False)
    parts = []
    for n, (a, b) in enumerate(itertools.pairwise(every)):
        kind = "platform" if n == len(every) - 2 else "link"
        (x, y), (u, v) = view(a), view(b)
        parts.append(
            f'<path d="M{x:.1f} {y:.1f}L{u:.1f} {v:.1f}" stroke="{_COLOURS[kind]}" stroke-width="{_WIDTHS[kind]}"/>'
        )
    labels = _Labels([view(p) for p in every])
    for n, (p, R) in enumerate(zip(origins, rotations, strict=True)):
        parts += _frame(view, tuple(p), "", R)
        parts.append(labels.put(view(p), f"{{{n}}}", "var(--ink)", bold=True))
    parts.append(labels.put(view(tool), "P", "var(--ink)", bold=True))
    return _svg(parts, "The chain at a pose off its singularities, frame by frame")


def _svg(parts: Sequence[str], title: str) -> str:
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH:.0f} {HEIGHT:.0f}" role="img" fill="none" '
        f'stroke-linecap="round" stroke-linejoin="round"><title>{html.escape(title)}</title>{"".join(parts)}</svg>'
    )


class _View:
    """Parallel projection that fits what is shown into the picture."""

    def __init__(self, points: Array, flat: bool) -> None:
        c, s = math.cos(AZIMUTH), math.sin(AZIMUTH)
        e, f = math.cos(ELEVATION), math.sin(ELEVATION)
        self._matrix = np.array([[-s, c, 0.0], [-c * f, -s * f, e]]) if not flat else np.eye(3)[:2]
        seen = points @ self._matrix.T
        low, high = seen.min(axis=0), seen.max(axis=0)
        span = np.maximum(high - low, 1e-9)
        self.scale = float(min((WIDTH - 2 * MARGIN) / span[0], (HEIGHT - 2 * MARGIN) / span[1]))
        self._middle = (low + high) / 2

    def __call__(self, point: Sequence[float] | Array) -> tuple[float, float]:
        x, y = (self._matrix @ np.asarray(point, dtype=float) - self._middle) * self.scale
        return WIDTH / 2 + float(x), HEIGHT / 2 - float(y)


class _Labels:
    """Puts labels beside points, where none of them is yet."""

    def __init__(self, taken: Sequence[tuple[float, float]]) -> None:
        self._taken = list(taken)

    def put(self, at: tuple[float, float], text: str, colour: str, *, bold: bool = False) -> str:
        ways = [(r * math.cos(a), r * math.sin(a)) for r in (15.0, 24.0) for a in np.linspace(0, 2 * math.pi, 13)[:-1]]
        inside = [
            (at[0] + x, at[1] + y)
            for x, y in ways
            if 12 < at[0] + x < WIDTH - 12 - 7 * len(text) and 14 < at[1] + y < HEIGHT - 8
        ]
        place = max(inside or [at], key=lambda p: min(math.dist(p, t) for t in self._taken if t != at))
        self._taken.append(place)
        weight = ' font-weight="700"' if bold else ' font-style="italic"'
        return (
            f'<text x="{place[0]:.1f}" y="{place[1] + 5:.1f}" text-anchor="middle" font-size="15" fill="{colour}" '
            f'stroke="var(--paper)" stroke-width="4" paint-order="stroke"{weight}>{html.escape(text)}</text>'
        )


def _name(text: str) -> str:
    head, _, half = text.partition("/")
    base = head.rstrip("0123456789")
    shown = _GREEK.get(base, base) + head[len(base) :].translate(_SMALL)
    return f"{shown}/{half}" if half else shown


def _front(points: Sequence[Mapping[str, Any]], view: _View) -> int:
    """Return the limb that is seen best: the one furthest to a side."""
    spread = {p["limb"]: abs(view(p["at"])[0] - WIDTH / 2) for p in points}
    return max(spread, key=lambda limb: spread[limb]) if spread else 1


def _polygon(points: Sequence[Mapping[str, Any]], view: _View, on: str) -> str:
    """Return the outline that points of one name, one in each limb, span."""
    names = [p["name"] for p in points if p["on"] == on]
    out = ""
    for name in dict.fromkeys(names):
        corners = [view(p["at"]) for p in points if p["name"] == name]
        if len(corners) > 2:
            d = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in corners) + "Z"
            out += f'<path d="{d}" fill="{_COLOURS[on]}" fill-opacity="0.13" stroke="{_COLOURS[on]}" stroke-width="1"/>'
    return out


def _path(points: Sequence[Sequence[float]], view: _View) -> str:
    d = "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in map(view, points))
    return f'<path d="{d}" stroke="var(--muted)" stroke-width="1" stroke-dasharray="1.5 4"/>'


def _frame(view: _View, at: Sequence[float], name: str, R: Array | None = None) -> list[str]:
    """Return the axes of a frame, each as long as its direction shows."""
    length = (26.0 if R is not None else 44.0) / view.scale
    a = view(at)
    parts = []
    for n, axis in enumerate("xyz"):
        unit = np.eye(3)[n] if R is None else R[:, n]
        b = view(np.asarray(at) + length * unit)
        if math.dist(a, b) < 4:
            continue
        colour = ("var(--bad)", "var(--good)", "var(--after)")[n]
        parts.append(f'<path d="M{a[0]:.1f} {a[1]:.1f}L{b[0]:.1f} {b[1]:.1f}" stroke="{colour}" stroke-width="1.6"/>')
        if name:
            x, y = a[0] + 1.22 * (b[0] - a[0]), a[1] + 1.22 * (b[1] - a[1])
            parts.append(
                f'<text x="{x:.1f}" y="{y + 4:.1f}" font-size="12" text-anchor="middle" fill="{colour}">{axis}</text>'
            )
    if name:
        parts.append(
            f'<text x="{a[0] - 9:.1f}" y="{a[1] + 15:.1f}" font-size="14" font-weight="700" text-anchor="middle" '
            f'fill="var(--ink)" stroke="var(--paper)" stroke-width="4" paint-order="stroke">{name}</text>'
        )
    return parts
