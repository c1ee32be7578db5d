"""A machine as a line drawing: points, lines and paths in space, seen at an angle, as SVG in the page's colours."""

from __future__ import annotations

import copy
import hashlib
import html
import itertools
import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from deltacal_gen.machine.registry import Array

WIDTH, HEIGHT, MARGIN = 640.0, 520.0, 58.0
SMALL = 90.0  # a platform that is seen smaller than this is enlarged, in a square of so much
INSET = 200.0
TITLE = "The machine at its nominal pose, drawn from its closure equations"
AZIMUTH, ELEVATION = math.radians(-62.0), math.radians(18.0)
_COLOURS = {"base": "var(--muted)", "link": "var(--ink)", "platform": "var(--before)", "rod": "var(--after)"}
_WIDTHS = {"base": 1.2, "link": 3.4, "platform": 2.2, "rod": 1.8}
_SMALL = str.maketrans("0123456789", "₀₁₂₃₄₅₆₇₈₉")
_GREEK = {"phi": "φ", "alpha": "α", "beta": "β", "theta": "θ"}


def machine(found: Mapping[str, Any], axes: Sequence[str]) -> str:
    """Return the drawing of a machine of limbs, of what `derive.review.drawing` found.

    One limb is labelled, with the names of its equations. A platform that is small beside its machine stands enlarged
    at the side.

    Parameters
    ----------
    axes : sequence of str
        Along which the platform moves: without z the machine is seen from the front.
    """
    points, lines = found["points"], found["lines"]
    every = [p["at"] for p in points] + [e for line in lines for e in (line["from"], line["to"])]
    every += [e for path in found["paths"] for e in path["points"]]
    every += [(0.0, 0.0, 0.0), found["P"]]
    view = _View(np.array(every, dtype=float), flat="z" not in axes)
    body = [found["P"], *(p["at"] for p in points if p["on"] == "platform")]
    body += [e for line in lines if line["kind"] == "platform" for e in (line["from"], line["to"])]
    seen = np.array([view(e) for e in body])
    size = float(np.ptp(seen, axis=0).max())
    parts = _solid(found, view)
    labels = _Labels([view(p["at"]) for p in points], _ends(found, view))
    front = _front(points, view)
    if not 0 < size < SMALL:
        return _svg([*parts, *_names(found, view, labels, front, ("base", "link", "rod", "platform"))], TITLE)
    middle = (seen.min(axis=0) + seen.max(axis=0)) / 2
    corner = labels.emptiest(INSET)
    close = view.enlarged((corner[0] + INSET / 2, corner[1] + INSET / 2), middle, 0.68 * INSET / size)
    labels.take((*corner, INSET, INSET))
    inside = _Labels([close(e) for e in body], _ends(found, close))
    inside.keep((corner[0] + 8, corner[1] + 26, corner[0] + INSET - 8, corner[1] + INSET - 8))
    box = f'x="{corner[0]:.1f}" y="{corner[1]:.1f}" width="{INSET:.0f}" height="{INSET:.0f}" rx="4"'
    drawn = "".join(_solid(found, close))
    clip = f"c{hashlib.sha256(drawn.encode()).hexdigest()[:10]}"  # a page may hold several drawings
    parts += _names(found, view, labels, front, ("base", "link", "rod"))
    parts += [
        f'<circle cx="{middle[0]:.1f}" cy="{middle[1]:.1f}" r="{0.75 * size:.1f}" stroke="var(--muted)"/>',
        f'<clipPath id="{clip}"><rect {box}/></clipPath><rect {box} fill="var(--card)" stroke="var(--muted)"/>',
        f'<g clip-path="url(#{clip})">{drawn}{"".join(_names(found, close, inside, front, ("platform",)))}</g>',
        f'<text x="{corner[0] + 9:.1f}" y="{corner[1] + 19:.1f}" font-size="13" fill="var(--muted)" '
        f'stroke="var(--card)" stroke-width="4" paint-order="stroke">platform × {close.scale / view.scale:.0f}</text>',
    ]
    return _svg(parts, TITLE)


def _ends(found: Mapping[str, Any], view: _View) -> list[Sequence[tuple[float, float]]]:
    """Return what labels keep off: the lines, and the axes of {O} and P."""
    lines = [(view(e["from"]), view(e["to"])) for e in found["lines"]]
    return [*lines, *(ends for at in ((0.0, 0.0, 0.0), found["P"]) for ends, _ in _axes(view, at))]


def _solid(found: Mapping[str, Any], view: _View) -> list[str]:
    """Return what is drawn of a machine, without its names."""
    points, lines = found["points"], found["lines"]
    parts = [_polygon(points, view, on) for on in ("base", "platform")]
    parts += [_path(p["points"], view) for p in found["paths"]]
    order = {"base": 0, "rod": 1, "platform": 2, "link": 3}
    for line in sorted(lines, key=lambda e: order[e["kind"]]):
        dash = ' stroke-dasharray="5 4"' if line["kind"] == "base" else ""
        parts.append(_stroke(view(line["from"]), view(line["to"]), _COLOURS[line["kind"]], _WIDTHS[line["kind"]], dash))
    parts += _frame(view, (0.0, 0.0, 0.0)) + _frame(view, found["P"])
    for p in points:
        x, y = view(p["at"])
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.4" fill="var(--card)" stroke="var(--ink)"/>')
    return parts


def _names(found: Mapping[str, Any], view: _View, labels: _Labels, front: int, kinds: Sequence[str]) -> list[str]:
    """Return the names of the frames, points, dimensions and joints of some kinds of parts."""
    parts = []
    if "base" in kinds:
        parts.append(labels.put(view((0.0, 0.0, 0.0)), "{O}", "var(--ink)", bold=True))
    if "platform" in kinds:
        parts.append(labels.put(view(found["P"]), "P", "var(--ink)", bold=True))
    for p in (p for p in found["points"] if p["limb"] == front and p["on"] in kinds):
        parts.append(labels.put(view(p["at"]), _name(p["name"]), "var(--ink)", bold=True))
    said: set[tuple[str, str]] = set()
    for line in sorted(found["lines"], key=lambda e: e["limb"] != front):
        key = (line["label"], line["kind"])
        if line["label"] and line["kind"] in kinds and key not in said:
            said.add(key)
            (x, y), (u, v) = view(line["from"]), view(line["to"])
            parts.append(labels.put(((x + u) / 2, (y + v) / 2), _name(line["label"]), _COLOURS[line["kind"]]))
    if "link" in kinds and (own := [p["points"] for p in found["paths"] if p["limb"] == front]):
        parts.append(labels.put(view(own[0][-2]), found.get("joint", "q"), "var(--muted)"))
    return parts


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
    seen = [view(p) for p in every]
    for n, (a, b) in enumerate(itertools.pairwise(seen)):
        kind = "platform" if n == len(every) - 2 else "link"
        parts.append(_stroke(a, b, _COLOURS[kind], _WIDTHS[kind]))
    for p, R in zip(origins, rotations, strict=True):
        parts += _frame(view, tuple(p), R)
    axes = [ends for p, R in zip(origins, rotations, strict=True) for ends, _ in _axes(view, tuple(p), R)]
    labels = _Labels(seen, [*itertools.pairwise(seen), *axes])
    alike: dict[tuple[int, int], list[int]] = {}
    for n, (x, y) in enumerate(seen[:-1]):
        alike.setdefault((round(x / 4), round(y / 4)), []).append(n)
    for numbers in alike.values():  # frames that lie on one another share a label
        parts.append(labels.put(seen[numbers[0]], ", ".join(f"{{{n}}}" for n in numbers), "var(--ink)", bold=True))
    parts.append(labels.put(seen[-1], "P", "var(--ink)", bold=True))
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
        self._at = (WIDTH / 2, HEIGHT / 2)

    def __call__(self, point: Sequence[float] | Array) -> tuple[float, float]:
        x, y = (self._matrix @ np.asarray(point, dtype=float) - self._middle) * self.scale
        return self._at[0] + float(x), self._at[1] - float(y)

    def enlarged(self, at: tuple[float, float], middle: Array, times: float) -> _View:
        """Return the same view with what is seen at `middle` moved to another place and so many times as large."""
        other = copy.copy(self)
        shift = np.array([middle[0] - self._at[0], self._at[1] - middle[1]]) / self.scale
        other.scale, other._middle, other._at = self.scale * times, self._middle + shift, at
        return other


class _Labels:
    """Puts labels beside points, where there is neither a line nor another label.

    Parameters
    ----------
    points : sequence of (x, y)
        That are drawn.
    lines : sequence of pairs of points
        That are drawn.
    """

    def __init__(self, points: Sequence[tuple[float, float]], lines: Sequence[Sequence[tuple[float, float]]]) -> None:
        along = np.linspace(0.0, 1.0, 40)[:, None]
        drawn = [np.array(points, dtype=float).reshape(-1, 2)]
        drawn += [np.array(a) * (1 - along) + np.array(b) * along for a, b in lines]
        self._drawn = np.vstack(drawn)
        self._boxes: list[tuple[float, float, float, float]] = []  # x, y, width, height
        self._within = (6.0, 6.0, WIDTH - 6.0, HEIGHT - 6.0)

    def keep(self, within: tuple[float, float, float, float]) -> None:
        """Put labels into a part of the picture only: left, top, right, bottom."""
        self._within = within

    def take(self, box: tuple[float, float, float, float]) -> None:
        """Keep labels away from a box: x, y, width, height."""
        self._boxes.append(box)

    def emptiest(self, size: float) -> tuple[float, float]:
        """Return the upper left corner of a square at the picture's rim with least in it, and furthest from it."""
        places = [(x, y) for x in (8.0, WIDTH - size - 8) for y in (8.0, (HEIGHT - size) / 2, HEIGHT - size - 8)]
        return max(places, key=lambda p: (-self._hits((*p, size, size), 10.0), self._off((*p, size, size))))

    def _hits(self, box: tuple[float, float, float, float], margin: float) -> int:
        return int((self._distances(box) < margin).sum())

    def _off(self, box: tuple[float, float, float, float]) -> float:
        return float(self._distances(box).min())

    def _distances(self, box: tuple[float, float, float, float]) -> Array:
        """Return how far what is drawn is from a box."""
        x, y, width, height = box
        outside = np.maximum(np.abs(self._drawn - [x + width / 2, y + height / 2]) - [width / 2, height / 2], 0.0)
        return np.asarray(np.linalg.norm(outside, axis=1))

    def _cost(self, box: tuple[float, float, float, float], way: float) -> float:
        left, top, right, bottom = self._within
        x, y, width, height = box
        out = max(left - x, top - y, x + width - right, y + height - bottom, 0.0)
        over = sum(
            max(0.0, min(x + width, u + w) - max(x, u)) * max(0.0, min(y + height, v + h) - max(y, v))
            for u, v, w, h in self._boxes
        )
        return 50.0 * out + 2.0 * over + 6.0 * self._hits(box, 3.0) + way

    def put(self, at: tuple[float, float], text: str, colour: str, *, bold: bool = False) -> str:
        """Return a label beside a point."""
        width, height = 8.4 * len(text) + 2, 15.0
        best, cost = (at[0], at[1], width, height), math.inf
        for far in (9.0, 14.0, 20.0, 28.0):
            for angle in np.linspace(0, 2 * math.pi, 25)[:-1]:
                c, s = math.cos(angle), math.sin(angle)
                x, y = at[0] + (far + width / 2) * c, at[1] + (far + height / 2) * s
                box = (x - width / 2, y - height / 2, width, height)
                if (new := self._cost(box, far)) < cost:
                    best, cost = box, new
        self._boxes.append(best)
        weight = ' font-weight="700"' if bold else ' font-style="italic"'
        return (
            f'<text x="{best[0] + width / 2:.1f}" y="{best[1] + height / 2 + 5:.1f}" text-anchor="middle" '
            f'font-size="15" fill="{colour}" stroke="var(--paper)" stroke-width="4" paint-order="stroke"{weight}>'
            f"{html.escape(text)}</text>"
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


def _stroke(a: tuple[float, float], b: tuple[float, float], colour: str, width: float, more: str = "") -> str:
    d = f"M{a[0]:.1f} {a[1]:.1f}L{b[0]:.1f} {b[1]:.1f}"
    return f'<path d="{d}" stroke="{colour}" stroke-width="{width}"{more}/>'


def _axes(
    view: _View, at: Sequence[float], R: Array | None = None
) -> list[tuple[tuple[tuple[float, float], tuple[float, float]], int]]:
    """Return the axes of a frame that are not seen end on, each as long as its direction shows, and which they are."""
    length = (26.0 if R is not None else 44.0) / view.scale
    a, axes = view(at), np.eye(3) if R is None else R
    ends = [(view(np.asarray(at) + length * axes[:, n]), n) for n in range(3)]
    return [((a, b), n) for b, n in ends if math.dist(a, b) >= 4]


def _frame(view: _View, at: Sequence[float], R: Array | None = None) -> list[str]:
    """Return a frame; the axes of {O} and P, which need no rotation, with their letters."""
    parts = []
    for (a, b), n in _axes(view, at, R):
        colour = ("var(--bad)", "var(--good)", "var(--after)")[n]
        parts.append(_stroke(a, b, colour, 1.6))
        if R is None:
            x, y = a[0] + 1.22 * (b[0] - a[0]), a[1] + 1.22 * (b[1] - a[1])
            letter = f'<text x="{x:.1f}" y="{y + 4:.1f}" font-size="12" text-anchor="middle" fill="{colour}">'
            parts.append(f"{letter}{'xyz'[n]}</text>")
    return parts
