"""Pages to read: one self-contained HTML file, no script, no network, for light and dark screens and for print.

Layout and colours are in ``pages/``: one stylesheet and one base for all pages. Pictures are Matplotlib's, with its
colours replaced by the stylesheet's.
"""

from __future__ import annotations

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
from deltacal_gen.results.base import Answer, shown_in
from deltacal_gen.results.batch import Batch, alike, in_table, worst
from deltacal_gen.results.diagnosis import (
    Diagnosis,
    Effect,
    EffectParameter,
    NextMeasurement,
    Verdict,
)
from deltacal_gen.results.document import Text, decimals, rounded
from deltacal_gen.results.motion import MotionDiagnosis
from deltacal_gen.results.places import Places
from deltacal_gen.results.result import Result, Status

COLOURS = {INK: "var(--ink)", MUTED: "var(--muted)", BEFORE: "var(--before)", AFTER: "var(--after)"}
MOST_DRAWN = 60  # recordings of a batch, each with its line; of more, their distribution
FAILED = {"verdict": "failed"}  # in the columns of a recording that could not be done
MOST_ROWS = 500  # of a table on a page: 10^5 would be 20 MB, which no browser likes
_NUMBERS = re.compile(r"[-+\d.,eE±·∞()% ⁻⁰¹²³⁴⁵⁶⁷⁸⁹]*")


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
    return page_of(
        "diagnosis",
        made=found.made,
        title=f"{machine}: diagnosis",
        machine=machine,
        found=found,
        verdict=figures.VERDICTS[found.verdict],
        headline=_headline(found),
        told=told(found),
        steps=_steps(found),
        improvement={"title": "", "svg": picture(partial(figures.bars, found=found), (4.4, 1.6))},
        noise=f"{decimals(found.noise.sigma_mm / shown_in(found)[1])} {shown_in(found)[0]} ({found.noise.source})",
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
        notes=[_note(e) for e in found.findings],
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
        readings=len(found.residuals.line),
        geometry=found.baseline.parameters,
    )


def batch(found: Batch, links: Mapping[str, str] | None = None) -> str:
    """Return the page over many recordings; of very many, over their distribution and the worst.

    `links` says where the pages of single recordings are.
    """
    rows, failed = found.rows, [r for r in found.rows if r.error is not None]
    columns = found.columns
    drawn = [r for r in rows if r.in_mm]  # all in one unit
    errors = ""
    if len(drawn) > MOST_DRAWN:
        errors = picture(partial(figures.fleet_distribution, rows=drawn), (7.4, 3.2))
    elif drawn:
        errors = picture(partial(figures.fleet, rows=drawn), (7.4, 0.8 + 0.16 * len(drawn)))
    changed = [(c.machine, f"{c.to} after {c.from_}: {c.text}") for c in found.changed]
    shown = worst(rows, MOST_ROWS)
    return page_of(
        "batch",
        title=f"{len(rows)} recordings",
        found=found,
        headline=f"{len(rows) - len(failed)} of {len(rows)} recordings done",
        picture=errors,
        verdicts=figures.VERDICTS,
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
    panels = [(figures.stages, (4.6, 2.6)), (figures.readings, (4.6, 2.6)), (figures.parameters, (4.6, 3.9))]
    if found.workspace:
        panels.append((figures.workspace, (4.6, 3.2)))
    return page_of(
        "calibration",
        made=found.made,
        title=f"{machine}: calibration",
        found=found,
        headline=f"{machine}: {before:.3f} {unit} before, {decimals(after)} {unit} after",
        told=told(found),
        steps=_uses(found),
        pictures=[{"title": "", "svg": picture(partial(draw, result=found), size)} for draw, size in panels],
        left=[{"title": "", "svg": picture(draw, size)} for draw, size in _left_panels(left_of(found))],
        parameters=_parameter_rows(found, pinned=True),
        unpinned=_parameter_rows(found, pinned=False),
        unseen=[(c.meaning or "", c.text) for c in found.unidentifiable],
    )


def _uses(found: Result) -> list[tuple[str, str]]:
    """Return what to do with a calibrated machine, and what to measure besides."""
    more = [part.words for part in found.document() if isinstance(part, Text) and part.words.startswith("+ ")]
    if found.robot.places.part == "tower":
        words = "New lines for the firmware (klipper, rrf or marlin):"
        use = (words, "deltacal compensate RESULT.json --export klipper -o lines.cfg")
    else:
        use = ("Corrected commands:", "deltacal compensate RESULT.json targets.csv -o joints.csv")
    return [
        ("Check it on readings of another day:", "deltacal validate RESULT.json other_day.csv"),
        ("Find what the residuals hold beside noise:", "deltacal diagnose ROBOT.toml RECORDING.csv -o diagnosis.json"),
        use,
        *((f"{sentence(words.removeprefix('+ '))}.", "") for words in more[:1]),
    ]


def _left_panels(left: Left | None) -> Sequence[tuple[Callable[[Any], None], tuple[float, float]]]:
    if left is None:
        return []
    drawn = [(partial(in_order, left=left), (4.6, 2.6)), (partial(spread, left=left), (4.6, 2.6))]
    return drawn + [(partial(places_of_readings, left=left, view=view), (4.6, 3.4)) for view in left.views]


def told(found: Answer) -> list[Text]:
    """Return the sentences of an answer, as a terminal shows them; what stands in lists below them has its tables."""
    words = [part for part in found.document() if isinstance(part, Text) and not part.level]
    if isinstance(found, Diagnosis | MotionDiagnosis):
        return [Text(found.summary), *words[1:]]  # the verdict is the page's badge
    return sorted((part for part in words if not part.words.endswith(":")), key=lambda part: not part.lead)


def power(value: float) -> str:
    """Return a number as a reader writes a small one: 3.1·10⁻⁵; 0 for zero."""
    if value == 0 or not math.isfinite(value):
        return f"{value:g}"
    exponent = math.floor(math.log10(abs(value)))
    if -2 <= exponent < 4:
        return f"{value:.2g}"
    return f"{value / 10.0**exponent:.1f}·10{str(exponent).translate(RAISED)}"


def asset(name: str) -> str:
    """Return the stylesheet of the pages, or a part of them."""
    text: str = (_pages() / name).read_text(encoding="utf-8")
    return text


def page_of(template: str, **content: Any) -> str:
    """Return a page by the name of its template."""
    page = _environment().get_template(f"{template}.html.jinja")
    return page.render(style=asset("style.css"), numeric=_numeric, sentence=sentence, **content)


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
    """Return text that begins with a capital, if it begins with a word."""
    return text[:1].upper() + text[1:] if text.partition(" ")[0].isalpha() else text


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


def _law(found: Diagnosis) -> dict[str, object] | None:
    """Return the law that was found as a page shows it."""
    if not found.laws:
        return None
    best, *others = found.laws
    pictures = laws.drawn(best, lambda draw: picture(draw, (6.4, 3.0)))
    left = f"{decimals(best.heldout_rms_mm)} mm"
    return laws.described(best, tuple(others), left, found.robot.places, best.remainder_rms_mm) | {"pictures": pictures}


def _note(effect: Effect) -> str:
    """Return what an effect is, how far it moves the readings, and what else it may be."""
    moves = f"; moves the readings by up to {effect.moves_mm:.2f} mm" if effect.moves_mm else ""
    others = ", ".join(map(spaced, effect.indistinguishable_from))
    alike = f" At these poses it is indistinguishable from {others}." if others else ""
    return f"{sentence(spaced(effect.name))}: {effect.title}{moves}.{alike}"


def _steps(found: Diagnosis) -> list[tuple[str, str]]:
    """Return what to do now, with the command where there is one."""
    steps = []
    if found.turned:
        steps.append((f"Compare the signs of the approach columns: it may be {found.turned}.", ""))
    for effect in found.findings:
        steps.append((f"{sentence(figures.named(effect, found.robot.places))}: {effect.advice or ''}", ""))
    if found.laws:
        again = "deltacal diagnose ROBOT.toml RECORDING.csv --write-effect NAME.py"
        steps.append((f"{laws.ADVICE} To have it under a name from now on, write it as an effect file:", again))
    if found.verdict is Verdict.UNEXPLAINED:
        steps.append(("Do not extrapolate: corrected commands hold only where there are readings (maps below).", ""))
    steps += [(f"{question.text} This {question.why}.", "") for question in found.next_measurements[:2]]
    if found.robot.joint is None:  # an open chain is not commanded by the position alone
        steps.append(("Corrected joint commands:", "deltacal compensate DIAGNOSIS.json targets.csv -o joints.csv"))
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


# ------------------------------------------------------------------------------------------------------- pictures


def _pair(
    draw: Callable[..., None], before: str | None, after: str, size: tuple[float, float], calm: bool
) -> list[dict[str, str]]:
    """Return the panels of both states with their titles, or of the one there is: calm where nothing is amiss."""
    states = [(False, before), (True, after)] if before is not None else [(calm, after)]
    return [{"title": str(title), "svg": picture(partial(draw, after=state), size)} for state, title in states]


def picture(draw: Callable[[Any], None], size: tuple[float, float]) -> str:
    """Return a picture of one panel, which `draw` makes, as SVG that takes its colours and its type from the page."""
    return panels(draw, (1, 1), size)


def panels(draw: Callable[[Any], None], grid: tuple[int, int], size: tuple[float, float]) -> str:
    """Return a picture of several panels (rows, columns), whose axes `draw` gets as an array; of one, its axes."""
    with mpl.rc_context({**STYLE, "font.size": 9.5, "axes.labelsize": 9.5}):
        picture, axes = figures.sheet(*grid, size)
        draw(axes)
        return inline(picture)


def inline(picture: Any) -> str:
    """Return a Matplotlib figure as SVG whose colours and type follow the page's."""
    stream = io.StringIO()
    picture.savefig(
        stream, format="svg", transparent=True, metadata=dict.fromkeys(("Date", "Creator", "Format", "Type"))
    )
    svg = stream.getvalue()
    svg = svg[svg.index("<svg") :]
    for colour, variable in COLOURS.items():
        svg = svg.replace(colour, variable)
    return svg.replace("'DejaVu Sans'", "inherit")
