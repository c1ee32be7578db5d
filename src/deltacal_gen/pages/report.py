"""Pages to read: one self-contained HTML file, no script, no network, for light and dark screens and for print.

Layout and colours are in ``pages/``: one stylesheet and one base for all pages. Pictures are Matplotlib's, with its
colours replaced by the stylesheet's.
"""

from __future__ import annotations

import html
import io
import math
import re
from collections.abc import Callable, Mapping, Sequence
from functools import cache, partial
from importlib import resources
from typing import Any

import jinja2

from deltacal_gen.pages import figures, laws
from deltacal_gen.pages.figures import AFTER, BEFORE, INK, MUTED, RAISED, STYLE, mpl
from deltacal_gen.pages.left import Left, in_order, left_of, spread
from deltacal_gen.pages.left import places as places_of_readings
from deltacal_gen.results.base import shown_in
from deltacal_gen.results.batch import Batch, alike, in_table, worst
from deltacal_gen.results.diagnosis import (
    Baseline,
    Diagnosis,
    Effect,
    EffectParameter,
    Final,
    NextMeasurement,
    Verdict,
)
from deltacal_gen.results.document import decimals, rounded
from deltacal_gen.results.parts import Source
from deltacal_gen.results.places import Places
from deltacal_gen.results.result import Result, Status

COLOURS = {INK: "var(--ink)", MUTED: "var(--muted)", BEFORE: "var(--before)", AFTER: "var(--after)"}
MOST_DRAWN = 60  # recordings of a batch, each with its line; of more, their distribution
FAILED = {"verdict": "failed"}  # in the columns of a recording that could not be done
MOST_ROWS = 500  # of a table on a page: 10^5 would be 20 MB, which no browser likes
_NUMBERS = re.compile(r"[-+\d.,eE±·∞()% ⁻⁰¹²³⁴⁵⁶⁷⁸⁹]*")
DOUBTED = "nothing is proven to be missing"  # where there are hints
VERDICTS = {
    Verdict.ADEQUATE: "nothing is missing",
    Verdict.MISSING_PHYSICS: "missing physics found",
    Verdict.UNEXPLAINED: "unexplained mismatch",
}
_NOISE = {
    Source.REPEATS: "from repeated poses",
    Source.DECLARED: "as the recording declares it",
    Source.RESIDUAL: "from what the fit leaves",
}


def diagnosis(found: Diagnosis) -> str:
    """Return the page of a DIAGNOSIS.json."""
    machine, places = found.robot.robot.name, found.robot.places
    channel = figures.main_channel(found)
    left = "with what was found" if found.effects or found.laws else "what geometry leaves"
    before = {}
    if found.effects or found.laws:
        before = {"map": "geometry alone", "channel": figures.before_title(found, channel)}
    calm = found.verdict is Verdict.ADEQUATE
    positions = found.residuals.before_mm.shape[1] == 3
    return _rendered(
        "diagnosis",
        made=found.made,
        title=f"{machine}: diagnosis",
        machine=machine,
        found=found,
        verdict=DOUBTED if found.verdict is Verdict.ADEQUATE and found.hints else VERDICTS[found.verdict],
        headline=_headline(found),
        lead=_lead(found),
        steps=_steps(found),
        improvement={"title": "", "svg": _svg(partial(figures.bars, found=found), (4.4, 1.6))},
        noise=f"{decimals(found.noise.sigma_mm / shown_in(found)[1])} {shown_in(found)[0]}",
        noise_of=_NOISE[found.noise.source],
        location=sentence(found.location.text),
        channel=_pair(
            partial(figures.against, found=found, channel=channel), before.get("channel"), left, (3.9, 2.7), calm
        )
        if channel is not None
        else [],
        map=_pair(partial(figures.bubbles, found=found), before.get("map"), left, (3.9, 3.8), calm)
        if positions
        else [],
        law=_law(found),
        part=places.part,
        effects=_effects(found),
        parameters=[_parameter(e, p, places) for e in found.effects for p in e.parameters],
        orders=[
            (places.number(s.limb), str(s.order), measured(s.amplitude_deg, s.std_deg), "deg")
            for e in found.effects
            for s in e.standing_out or ()
        ],
        hints=_hints(found, places),
        rejected=[(spaced(r.name), f"{r.gain_chi2:.0f}", r.why) for r in found.rejected],
        next=[_question(n) for n in found.next_measurements],
        not_tested=[(spaced(t.name), t.missing) for t in found.not_tested],
        gross=", ".join(map(str, found.gross_errors)),
        readings=len(found.residuals.line),
        geometry=found.baseline.parameters,
    )


def batch(found: Batch, links: Mapping[str, str] | None = None) -> str:
    """Return the page over many recordings; of very many, over their distribution and the worst.

    `links` says where the pages of single recordings are.
    """
    rows, failed = found.rows, [r for r in found.rows if r.error is not None]
    columns = found.columns
    done = [r for r in rows if r.error is None]
    drawn = [r for r in done if r.in_mm]  # all in one unit
    picture = ""
    if len(drawn) > MOST_DRAWN:
        picture = _svg(partial(figures.fleet_distribution, rows=drawn), (7.4, 3.2))
    elif drawn:
        picture = _svg(partial(figures.fleet, rows=drawn), (7.4, 0.8 + 0.16 * len(drawn)))
    changed = [(c.machine, f"{c.to} after {c.from_}: {c.text}") for c in found.changed]
    shown = worst(rows, MOST_ROWS)
    return _rendered(
        "batch",
        title=f"{len(rows)} recordings",
        found=found,
        headline=f"{len(done)} of {len(rows)} recordings done",
        picture=picture,
        distribution=len(drawn) > MOST_DRAWN,
        failed=[both[::-1] for both in alike([(r.recording, r.error or "") for r in failed])[:MOST_ROWS]],
        warnings=[both[::-1] for both in alike([(r.recording, r.warnings) for r in rows if r.warnings])[:MOST_ROWS]],
        changed=changed[:MOST_ROWS],
        heads=[spaced(c).removesuffix(" mm") + (", mm" if c.endswith("_mm") else "") for c in columns],
        rows=[[(c, _cell((FAILED if r.error else {}).get(c, getattr(r, c)))) for c in columns] for r in shown],
        links=links or {},
        passed_over=found.passed_over or (),
        left_out=len(rows) - len(shown),
        unchanged=len(changed) - MOST_ROWS,
    )


def _cell(value: Any) -> str:
    return f"{value:.4f}" if isinstance(value, float) else str(in_table(value))


def _parameter_rows(found: Result, *, pinned: bool) -> list[tuple[str, str, str, str, str]]:
    """Return name, meaning, value, unit and status of the free parameters that something pins, or of the others."""
    return [
        (p.name, p.meaning or "of the instrument", measured(p.value, p.std), "" if p.unit == "1" else p.unit, p.status)
        for p in found.parameters
        if p.status is not Status.FIXED and (p.status is not Status.NOT_PINNED) == pinned
    ]


def calibration(found: Result) -> str:
    """Return the page of a RESULT.json."""
    machine, held, (unit, size) = found.robot.robot.name, found.heldout_rms_mm, shown_in(found)
    before, after = found.before_rms_mm / size, (found.train_rms_mm if held is None else held) / size
    seen = "on readings that took no part in the fit" if held is not None else "on the readings of the fit"
    panels = [(figures.stages, (4.6, 2.6)), (figures.readings, (4.6, 2.6)), (figures.parameters, (4.6, 3.9))]
    if found.workspace:
        panels.append((figures.workspace, (4.6, 3.2)))
    return _rendered(
        "calibration",
        made=found.made,
        title=f"{machine}: calibration",
        machine=machine,
        found=found,
        prints=found.robot.places.part == "tower",
        headline=f"{machine}: {before:.3f} {unit} before, {decimals(after)} {unit} after",
        lead=f"As the robot file has it, the machine is off by {before:.3f} {unit} rms; calibrated as "
        f"{found.model}, by {decimals(after)} {unit} {seen}. The noise is {decimals(found.sigma_mm / size)} {unit}, "
        f"{_NOISE[found.sigma_source]}.",
        pictures=[{"title": "", "svg": _svg(partial(draw, result=found), size)} for draw, size in panels],
        left=[{"title": "", "svg": _svg(draw, size)} for draw, size in _left_panels(left_of(found))],
        parameters=_parameter_rows(found, pinned=True),
        unpinned=_parameter_rows(found, pinned=False),
        unseen=[(c.meaning or "", c.text) for c in found.unidentifiable],
        errors=[*found.errors_told, *found.carried_told],
        gross=", ".join(map(str, found.gross_errors or ())),
    )


def _left_panels(left: Left | None) -> Sequence[tuple[Callable[[Any], None], tuple[float, float]]]:
    if left is None:
        return []
    drawn = [(partial(in_order, left=left), (4.6, 2.6)), (partial(spread, left=left), (4.6, 2.6))]
    return drawn + [(partial(places_of_readings, left=left, view=view), (4.6, 3.4)) for view in left.views]


def page(title: str, parts: Sequence[str]) -> str:
    """Return a page of parts that are HTML already."""
    return _rendered("parts", title=title, parts=parts)


def figure(picture: Any, caption: str) -> str:
    """Return a Matplotlib figure as SVG whose colours and type follow the page's, with its caption."""
    return f"<figure>{_inline(picture)}<figcaption>{html.escape(caption)}</figcaption></figure>"


def picture(draw: Callable[[Any], None], size: tuple[float, float]) -> str:
    """Return a picture of one panel, which `draw` makes, as SVG that takes its colours and its type from the page."""
    return _svg(draw, size)


def power(value: float) -> str:
    """Return a number as a reader writes a small one: 3.1·10⁻⁵; 0 for zero."""
    if value == 0 or not math.isfinite(value):
        return f"{value:g}"
    exponent = math.floor(math.log10(abs(value)))
    if -2 <= exponent < 4:
        return f"{value:.2g}"
    return f"{value / 10.0**exponent:.1f}·10{str(exponent).translate(RAISED)}"


def page_of(template: str, **content: Any) -> str:
    """Return a page by the name of its template."""
    return _rendered(template, **content)


def asset(name: str) -> str:
    """Return the stylesheet of the pages, or a part of them."""
    text: str = (_pages() / name).read_text(encoding="utf-8")
    return text


def _rendered(template: str, **content: Any) -> str:
    page = _environment().get_template(f"{template}.html.jinja")
    return page.render(style=asset("style.css"), numeric=_numeric, **content)


def _numeric(rows: Sequence[Sequence[object]]) -> list[bool]:
    """Return whether each column of a table holds numbers alone."""
    return [all(_NUMBERS.fullmatch(str(cell)) for cell in column) for column in zip(*rows, strict=True)]


def _pages() -> Any:
    return resources.files("deltacal_gen") / "pages"


@cache
def _environment() -> jinja2.Environment:
    files = {f.name: f.read_text(encoding="utf-8") for f in _pages().iterdir() if f.name.endswith(".html.jinja")}
    return jinja2.Environment(
        loader=jinja2.DictLoader(files),
        undefined=jinja2.StrictUndefined,
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
    )


# ------------------------------------------------------------------------------------------------------- in words


def measured(value: float | str, std: float | None) -> str:
    """Return a value with its standard deviation, to two digits of that; a name as it is."""
    if isinstance(value, str):
        return value
    if std is None or not std > 0:
        return f"{value:.4g}"
    power = math.floor(math.log10(max(abs(value), std)))
    if power < -3:
        shown = measured(value / 10.0**power, std / 10.0**power)
        return f"({shown})·10{str(power).translate(RAISED)}"
    return " ± ".join(rounded(value, std))


def spaced(name: str) -> str:
    """Return a name of the vocabulary as words."""
    return name.replace("_", " ")


def sentence(text: str) -> str:
    """Return text that begins with a capital."""
    return text[:1].upper() + text[1:]


def _headline(found: Diagnosis) -> str:
    effects, places = found.findings, found.robot.places
    if found.verdict is Verdict.ADEQUATE:
        return "The calibrated geometry explains these readings"
    if found.verdict is Verdict.UNEXPLAINED:
        if found.turned:
            return "The direction of approach may count the other way"
        beside = f" beside {' and '.join(figures.named(e, places) for e in effects)}" if effects else ""
        return f"Something{beside} that no known effect explains"
    told = [laws.headline(law, places) for law in found.laws[:1]]
    return sentence(" and ".join([*told, *(figures.named(e, places) for e in effects)]))


def _lead(found: Diagnosis) -> str:
    """Return what was found in two sentences."""
    unit, size = shown_in(found)
    figures_mm = (_heldout(found.baseline), _heldout(found.final), found.noise.sigma_mm)
    before, after, sigma = (f"{decimals(mm / size)} {unit}" for mm in figures_mm)
    if found.verdict is Verdict.ADEQUATE:
        more = "Nothing else is proven" if found.hints else "Nothing else was found"
        return f"What the geometry leaves on held-out readings, {before}, is noise. {more}."
    if found.verdict is Verdict.UNEXPLAINED:
        return (
            f"Geometry alone leaves {before} on held-out readings, {after} are left in the end, and the "
            f"noise is {sigma}. {sentence(found.location.text)}."
        )
    places = found.robot.places
    told = [f"{t.target} moves by {t.expression}{laws.where(t, places)}" for law in found.laws[:1] for t in law.terms]
    parts = "; ".join([*told, *(_in_numbers(e) + _beside(found.harmonics(e)) for e in found.findings)])
    return (
        f"{sentence(parts)}. With it the error on held-out readings falls from {before} to {after}; "
        f"the noise is {sigma}."
    )


def _law(found: Diagnosis) -> dict[str, object] | None:
    """Return the law that was found as a page shows it."""
    if not found.laws:
        return None
    best, *others = found.laws
    pictures = laws.drawn(best, lambda draw: _svg(draw, (6.4, 3.0)))
    left = f"{decimals(best.heldout_rms_mm)} mm"
    return laws.described(best, tuple(others), left, found.robot.places, best.remainder_rms_mm) | {"pictures": pictures}


def _heldout(fit: Baseline | Final) -> float:
    value = fit.heldout_rms_mm
    return float(fit.train_rms_mm if value is None else value)


def _in_numbers(effect: Effect) -> str:
    """Return an effect in plain words with its values; their range where there are many."""
    by_name: dict[str, list[EffectParameter]] = {}
    for p in effect.parameters:
        by_name.setdefault(p.name, []).append(p)
    words = []
    for name, of in by_name.items():
        unit = "" if of[0].unit == "1" else f" {of[0].unit}"
        values = [float(p.value) for p in of] if len(of) > 1 else []
        value = f"{min(values):.3g} to {max(values):.3g}" if values else measured(of[0].value, of[0].std)
        words.append(f"{spaced(name)} {value}{unit}")
    return f"{effect.title}, {', '.join(words)}"


def _beside(harmonics: Sequence[Effect]) -> str:
    """Return what harmonics make of a periodic error, in words; "" where there are none."""
    if not harmonics:
        return ""
    orders = sorted(order for e in harmonics for order in e.periods)
    return f", no sine: with harmonics {', '.join(f'{order:g}' for order in orders)}"


def _steps(found: Diagnosis) -> list[dict[str, str]]:
    """Return what to do now, with the command where there is one."""
    steps: list[dict[str, str]] = []
    if found.turned:
        steps.append({"text": f"Compare the signs of the approach columns: it may be {found.turned}.", "command": ""})
    for effect in found.findings:
        text = f"{sentence(figures.named(effect, found.robot.places))}: {effect.advice or ''}"
        steps.append({"text": text, "command": ""})
    if found.laws:
        text = f"{laws.ADVICE} To know it by a name from now on, write it as an effect and fill in what it is:"
        again = "deltacal diagnose ROBOT.toml RECORDING.csv --write-effect NAME.py"
        steps.append({"text": text, "command": again})
    if found.verdict is Verdict.UNEXPLAINED:
        steps.append(
            {"text": "Do not extrapolate: the corrected commands hold only as far as the maps below.", "command": ""}
        )
    for question in found.next_measurements[:2]:
        steps.append({"text": f"{question.text} This {question.why}.", "command": ""})
    if found.robot.joint is None:  # an open chain is not commanded by the position alone
        steps.append(
            {
                "text": "Corrected joint commands:",
                "command": "deltacal compensate DIAGNOSIS.json targets.csv -o joints.csv",
            }
        )
    return steps


def _parameter(effect: Effect, p: EffectParameter, places: Places) -> tuple[str, ...]:
    joint = "" if p.limb is None else places.number(p.limb)
    return (
        spaced(effect.name),
        joint,
        spaced(p.label),
        measured(p.value, p.std),
        "" if p.unit == "1" else p.unit,
    )


def _hints(found: Diagnosis, places: Places) -> list[tuple[str, ...]]:
    """Return what may be there: what speaks for it, what is alike, what is wanting, and what decides."""
    rows: list[tuple[str, ...]] = []
    for k, hint in enumerate(found.hints):
        before = sum(other.name == hint.name for other in found.hints[:k])
        settles = [n for n in found.next_measurements if n.separates == (hint.name,)][before : before + 1]
        text = "".join(n.text for n in settles) or "Other poses, and channels that were not recorded."
        for n in settles:
            if n.poses:
                text = f"The {len(n.poses)} poses below"
                text += f": {n.expected_chi2:.0f} of chi² are expected" if n.expected_chi2 else ""
        rows.append(
            (
                figures.named(hint, places),
                f"{hint.gain_chi2:.0f}",
                power(hint.p_value),
                ", ".join(map(spaced, hint.indistinguishable_from)),
                hint.why,
                text,
            )
        )
    return rows


def _question(n: NextMeasurement) -> dict[str, object]:
    columns = tuple(dict.fromkeys(key for pose in n.poses for key in pose))
    return {
        "why": sentence(n.why),
        "text": n.text,
        "expected": f"{n.expected_chi2:.0f}" if n.expected_chi2 else "",
        "columns": columns,
        "rows": [tuple(pose.get(c, "") for c in columns) for pose in n.poses],
    }


def _effects(found: Diagnosis) -> list[dict[str, str]]:
    return [
        {
            "name": spaced(e.name),
            "title": e.title,
            "moves": f"{e.moves_mm:.2f}" if e.moves_mm else "",
            "alike": ", ".join(map(spaced, e.indistinguishable_from)),
        }
        for e in found.effects
    ]


# ------------------------------------------------------------------------------------------------------- pictures


def _pair(
    draw: Callable[..., None], before: str | None, after: str, size: tuple[float, float], calm: bool
) -> list[dict[str, str]]:
    """Return the panels of both states with their titles, or of the one there is: calm where nothing is amiss."""
    states = [(False, before), (True, after)] if before is not None else [(calm, after)]
    return [{"title": str(title), "svg": _svg(partial(draw, after=state), size)} for state, title in states]


def _svg(draw: Callable[[Any], None], size: tuple[float, float]) -> str:
    """Return a picture of one panel as SVG that takes its colours and its type from the page."""
    return panels(draw, (1, 1), size)


def panels(draw: Callable[[Any], None], grid: tuple[int, int], size: tuple[float, float]) -> str:
    """Return a picture of several panels (rows, columns), whose axes `draw` gets as an array; of one, its axes."""
    with mpl.rc_context({**STYLE, "font.size": 9.5, "axes.labelsize": 9.5}):
        picture, axes = figures.sheet(*grid, size)
        draw(axes)
        return _inline(picture)


def _inline(picture: Any) -> str:
    stream = io.StringIO()
    picture.savefig(
        stream, format="svg", transparent=True, metadata=dict.fromkeys(("Date", "Creator", "Format", "Type"))
    )
    svg = stream.getvalue()
    svg = svg[svg.index("<svg") :]
    for colour, variable in COLOURS.items():
        svg = svg.replace(colour, variable)
    return svg.replace("'DejaVu Sans'", "inherit")
