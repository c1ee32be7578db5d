"""The proof as tables and a page: answers, errors of parameters and predictions; by kind, signal over noise, effect."""

from __future__ import annotations

import html
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from deltacal_gen.pages import report
from deltacal_gen.pages.figures import AFTER, BEFORE, MUTED, STYLE, mpl, sheet
from tests.benchmarks import motion_blind
from tests.support.measured import PACKAGES, write

Entry = Mapping[str, Any]
KINDS = {
    "single": "one effect",
    "pair": "two effects",
    "null": "nothing",
    "outside": "foreign physics",
}
RIGHT = {
    "single": "named, with its limbs",
    "pair": "both named, with their limbs",
    "null": "nothing named",
    "outside": "unexplained, and where",
}
BY = {"own": "deltacal", "exudyn": "Exudyn"}
NOISE = ((0.0, 3.0, "up to 3"), (3.0, 6.0, "3 to 6"), (6.0, np.inf, "above 6"))
HEADS = ("cases", "right", "wrong name", "no name", "parameter error", "within 3 std", "to ideal", "gain")
LEGEND = (
    "Right: exactly the concealed effects with exactly their limbs and orders; where nothing is concealed, nothing "
    "named; of foreign physics, which is not in the vocabulary, unexplained and located. Wrong name: a name, limb or "
    "order that is not the case; where nothing is concealed, a false alarm. No name: an effect that is there was not "
    "named; foreign physics was overlooked or misplaced. Parameter error: median, over the effect's largest true "
    "value. Within 3 std: parameters whose error is below three of their stated standard deviations. To ideal: "
    "prediction error of fresh readings over that of a fit that knows the effects, median. Gain: prediction error of "
    "geometry alone over that of the diagnosis, median."
)
INTRODUCTION = (
    "Machines with errors in all 42 parameters were simulated with physics left out of their model, or with none. "
    "The diagnosis saw the robot file and the recording, nothing else."
)
OTHERS = (
    " Half of the recordings were made by the project's own simulator, half by a multibody engine of others, in "
    "which bodies, joints, springs and weights find their equilibrium without a formula of this project."
)
IN_MOTION = (
    "Torques of a six-joint arm and a six-rod Delta along trajectories, with friction, wrong payloads, ripple, delays "
    "or what is none of them concealed, and diagnosed blind. Right: exactly the concealed effects at exactly their "
    "joints; of foreign physics, unexplained or a law at the right joint. To ideal: held-out error over what a fit "
    "that knows the effects leaves, median."
)
HOW = (
    "An effect is drawn such that geometry alone leaves 1.5 to 10 standard deviations of the noise; a case that "
    "another explanation fits within 40 of chi2 is drawn anew, so that every case has one right answer. Readings are "
    "positions, poses, distances or gauge lengths, some with repeats, outliers, heavy tails, several set-ups, and "
    "channels that have nothing to do with it."
)


def _answer(entry: Entry) -> str:
    """Return how an answer counts: right, wrong (a name too many or in the wrong place) or silent."""
    if entry["right"]:
        return "right"
    if entry["kind"] == "outside":
        return "wrong" if entry.get("verdict") == "missing_physics" else "silent"
    named = [name for name, *_ in entry.get("found", ())]
    exact_but = entry.get("exact") and entry.get("verdict_ok")
    return "wrong" if set(named) - set(entry["names"]) or len(set(named)) < len(named) or exact_but else "silent"


def _numbers(found: Sequence[Entry]) -> list[str]:
    """Return the cells of a row, in the order of `HEADS`."""
    answers = [_answer(f) for f in found]
    relative = [v for f in found for v in f.get("relative", ())]
    z = np.abs([v for f in found for v in f.get("z", ())])
    ideal = [f["to_oracle"] for f in found if f.get("to_oracle") and f["names"]]
    gain = [f["gain"] for f in found if f.get("gain") and f["names"]]
    return [
        str(len(found)),
        str(answers.count("right")),
        str(answers.count("wrong")),
        str(answers.count("silent")) if any(f["names"] for f in found) else "",
        f"{100 * np.median(relative):.1f} %" if relative else "",
        f"{int((z < 3).sum())}/{len(z)}" if len(z) else "",
        f"{np.median(ideal):.2f}" if ideal else "",
        f"{np.median(gain):.1f}" if gain else "",
    ]


def _by_kind(found: Sequence[Entry]) -> Iterator[list[str]]:
    for kind, words in KINDS.items():
        for engine, who in BY.items():
            if part := [f for f in found if f["kind"] == kind and f["engine"] == engine]:
                yield [words, who, *_numbers(part)]


def _by_noise(found: Sequence[Entry]) -> Iterator[list[str]]:
    for low, high, words in NOISE:
        if part := [f for f in found if f["kind"] in ("single", "pair") and low <= f["excess"] < high]:
            yield [words, *_numbers(part)]


def _by_name(found: Sequence[Entry], kind: str) -> Iterator[list[str]]:
    of_kind = [f for f in found if f["kind"] == kind]
    for name in sorted({name for f in of_kind for name in f["names"]}):
        yield [name.replace("_", " "), *_numbers([f for f in of_kind if name in f["names"]])]


def _tables(found: Sequence[Entry]) -> Iterator[tuple[str, bool, Sequence[str], list[list[str]]]]:
    """Yield title, whether it is one for those who want to know more, heads and rows of every table."""
    yield "By what is concealed", False, ("concealed", "simulated by", *HEADS), list(_by_kind(found))
    yield (
        "By signal over noise: what geometry alone leaves, in standard deviations of the noise; one or two effects",
        False,
        ("signal over noise", *HEADS),
        list(_by_noise(found)),
    )
    yield "By effect, concealed alone", True, ("effect", *HEADS), list(_by_name(found, "single"))
    yield (
        "Foreign physics: not in the vocabulary of effects",
        True,
        ("physics", *HEADS),
        list(_by_name(found, "outside")),
    )


def markdown(found: Sequence[Entry], run: Mapping[str, Any]) -> str:
    """Return the tables as Markdown, with what made them."""
    out = [_made(run), ""]
    for title, folded, heads, rows in _tables(found):
        if not rows:
            continue
        used = [j for j in range(len(heads)) if any(row[j] for row in rows)]
        out += [f"<details><summary>{title}</summary>" if folded else f"{title}:", ""]
        out.append("| " + " | ".join(heads[j] for j in used) + " |")
        out.append("| " + " | ".join("---" if heads[j] not in HEADS else "---:" for j in used) + " |")
        out += ["| " + " | ".join(row[j] for j in used) + " |" for row in rows]
        out += ["", "</details>", ""] if folded else [""]
    return "\n".join([*out, LEGEND, ""])


def measured(found: Sequence[Entry], run: Mapping[str, Any]) -> None:
    """Write the tables as the manual shows them."""
    names = ("proof_concealed", "proof_noise", "proof_effects", "proof_foreign")
    packages = [*PACKAGES, *(["exudyn"] if "exudyn" in run["engines"] else [])]
    for name, (_, _, heads, rows) in zip(names, _tables(found), strict=True):
        used = [j for j in range(len(heads)) if any(row[j] for row in rows)]
        cells = [[row[j] for j in used] for row in rows]
        write(name, [heads[j] for j in used], cells, run["command"], packages=packages, note=_counted(run))


def failures(found: Sequence[Entry]) -> Iterator[str]:
    """Yield a line for each case whose answer is not right, or right with a flaw."""
    for f in found:
        if f["wrong"]:
            truth = " + ".join(f["names"]) or "nothing"
            flaw = "" if f["right"] else f"{_answer(f)}: "
            yield f"{f['name']} {f['engine']} {truth}, {f['excess']:.1f} sigma: {flaw}{'; '.join(map(str, f['wrong']))}"


def _made(run: Mapping[str, Any]) -> str:
    engines = ", ".join(BY[e] if v == "deltacal_gen" else str(v) for e, v in run["engines"].items())
    return f"{run['command']}: {_counted(run)}; {engines}."


def _counted(run: Mapping[str, Any]) -> str:
    lost = f", {run['skipped']} more could not be drawn or graded" if run.get("skipped") else ""
    return f"{run['cases']} cases{lost}, seed {run['seed']}"


# ------------------------------------------------------------------------------------------------------------ page

_CSS = """
.verdict { color: var(--muted); font-size: 0.85rem; font-weight: 600; margin: 0; }
.figures { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(24rem, 100%), 1fr)); gap: 0 2rem; }
.answers { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(13rem, 100%), 1fr)); gap: 0.4rem 2rem; }
.answers p { margin: 0.3rem 0; color: var(--muted); } .answers b { display: block; font-size: 1.7rem; color: var(--ink);
  font-weight: 600; font-variant-numeric: tabular-nums; }
th { vertical-align: bottom; } th.n { text-align: right; } td.n { white-space: nowrap; }
ul { padding-left: 1.1rem; } li { margin: 0.25rem 0; }
code { font-size: 0.92em; overflow-wrap: anywhere; }
"""


def page(found: Sequence[Entry], run: Mapping[str, Any], moving: Sequence[dict[str, Any]] = ()) -> str:
    """Return the page: one self-contained HTML file without script, for light and dark screens.

    `moving` are the cases of `tests.benchmarks.motion_blind`, where they were run.
    """
    parts = [
        f"<style>{_CSS}</style>",
        '<p class="verdict">the proof</p>',
        f"<h1>{_text(_headline(found))}</h1>",
        f'<p class="lead">{_text(INTRODUCTION + (OTHERS if len(run["engines"]) > 1 else ""))}</p>',
        f'<div class="answers">{"".join(_answers(found))}</div>',
        '<div class="figures">',
        *_figures(found),
        "</div>",
    ]
    for title, _, heads, rows in _tables(found):
        if rows:
            parts += [f"<h2>{_text(title)}</h2>", _table(heads, rows)]
    parts.append(f'<p class="note">{_text(LEGEND)}</p>')
    if moving:
        parts += ["<h2>In motion</h2>", f'<p class="note">{_text(IN_MOTION)}</p>']
        parts.append(_table(motion_blind.HEADS, motion_blind.told(moving), motion_blind.HEADS[1:]))
    lines = [*failures(found), *_failed_in_motion(moving)]
    parts.append("<h2>What went wrong, case by case</h2>")
    parts.append(f"<ul>{''.join(f'<li>{_text(line)}</li>' for line in lines)}</ul>" if lines else "<p>Nothing.</p>")
    parts += ["<h2>How it was made</h2>", f"<p>{_text(_made(run))} {_text(HOW)}</p>"]
    return report.page_of("parts", title="deltacal: the proof", parts=parts)


def _failed_in_motion(moving: Sequence[dict[str, Any]]) -> Iterator[str]:
    """Yield a line for each case in motion whose answer is not right."""
    for row in moving:
        if not row["right"]:
            truth = " + ".join(f"{name} of joint {joint}" for name, joint, _ in row["true"]) or "nothing"
            said = {"missed": row["missed"], "false": row["false"], "unexplained": row["unexplained"]}
            words = "; ".join(f"{key} {value}" for key, value in said.items() if value)
            yield f"in motion {row['seed']} {row['machine']} ({row['engine']}) {truth}: {words or row['verdict']}"


def _headline(found: Sequence[Entry]) -> str:
    named = [f for f in found if f["kind"] == "single"]
    nothing = [f for f in found if f["kind"] == "null"]
    words = []
    if named:
        words.append(f"{sum(f['right'] for f in named)} of {len(named)} concealed effects named with their limbs")
    if nothing:
        alarms = sum(_answer(f) == "wrong" for f in nothing)
        words.append(f"{alarms or 'no'} false alarm{'s' * (alarms != 1)} on {len(nothing)} recordings without any")
    return "; ".join(words) or f"{len(found)} cases"


def _answers(found: Sequence[Entry]) -> Iterator[str]:
    for kind, words in KINDS.items():
        if part := [f for f in found if f["kind"] == kind]:
            right = sum(f["right"] for f in part)
            yield f"<p><b>{right} of {len(part)}</b>{_text(words)}: {_text(RIGHT[kind])}</p>"


def _figures(found: Sequence[Entry]) -> Iterator[str]:
    effects = [f for f in found if f["kind"] in ("single", "pair")]
    exact = [f for f in effects if f.get("relative")]
    if exact:
        yield _figure(
            _drawn(lambda axes: _errors(axes, exact, [f for f in effects if not f["right"]])),
            "Error of the parameters, largest of each case, against what geometry alone leaves. Crosses on the upper "
            "edge: answers that were not right.",
        )
    if len(z := np.array([v for f in effects for v in f.get("z", ())])) > 4:
        yield _figure(
            _drawn(lambda axes: _honesty(axes, z)),
            "Parameters: value minus truth in units of the stated standard deviation, and what it would be if that "
            "were exact.",
        )
    both = [f for f in effects if f.get("gain") and f.get("to_oracle")]
    if both:
        yield _figure(
            _drawn(lambda axes: _gains(axes, both)),
            "Prediction of 100 fresh readings: how much better than geometry alone the diagnosis is, and how much "
            "better an ideal fit that knows the effects. On the line there is nothing left to gain.",
        )
        yield _figure(
            _drawn(lambda axes: _rates(axes, effects)),
            "Right answers by signal over noise, with their 95 % intervals; one or two effects concealed.",
        )


def _figure(picture: Any, caption: str) -> str:
    return f"<figure>{report.inline(picture)}<figcaption>{_text(caption)}</figcaption></figure>"


def _drawn(draw: Callable[[Any], None]) -> Any:
    with mpl.rc_context(STYLE):
        picture, axes = sheet(1, 1, (4.4, 2.9))
        draw(axes)
    return picture


def _errors(axes: Any, exact: Sequence[Entry], wrong: Sequence[Entry]) -> None:
    for engine, colour in (("own", BEFORE), ("exudyn", AFTER)):
        of = [f for f in exact if f["engine"] == engine and f["right"]]
        if of:
            axes.loglog(
                [f["excess"] for f in of], [max(100 * max(f["relative"]), 1e-3) for f in of], "o", ms=3.5, color=colour
            )
            axes.lines[-1].set_label(BY[engine])
    if wrong:
        place = axes.get_xaxis_transform()
        axes.plot([f["excess"] for f in wrong], [0.97] * len(wrong), "x", ms=5, color=MUTED, transform=place)
    axes.set_xscale("log")
    axes.set_xticks([1.5, 2, 3, 5, 10], ["1.5", "2", "3", "5", "10"])
    axes.minorticks_off()
    axes.yaxis.set_major_formatter(lambda v, _: f"{v:g}")
    axes.set_xlabel("signal over noise")
    axes.set_ylabel("parameter error, %")
    axes.legend(frameon=False, fontsize=8, loc="lower left")


def _honesty(axes: Any, z: np.ndarray) -> None:
    edges = np.linspace(-4.0, 4.0, 25)
    axes.hist(np.clip(z, -3.99, 3.99), edges, color=AFTER, rwidth=0.9)
    t = np.linspace(-4, 4, 200)
    axes.plot(t, len(z) * (edges[1] - edges[0]) * np.exp(-(t**2) / 2) / np.sqrt(2 * np.pi), color=BEFORE, lw=1.2)
    axes.set_xlabel("(value - truth) / standard deviation")
    axes.set_ylabel("parameters")


def _gains(axes: Any, both: Sequence[Entry]) -> None:
    ideal = np.array([f["gain"] * f["to_oracle"] for f in both])
    own = np.array([f["gain"] for f in both])
    for engine, colour in (("own", BEFORE), ("exudyn", AFTER)):
        of = np.array([f["engine"] == engine for f in both])
        if of.any():
            axes.loglog(ideal[of], own[of], "o", ms=3.5, color=colour, label=BY[engine])
    ends = [min(own.min(), ideal.min(), 1.0), max(own.max(), ideal.max())]
    axes.plot(ends, ends, color=MUTED, lw=0.8, zorder=0)
    axes.xaxis.set_major_formatter(lambda v, _: f"{v:g}")
    axes.yaxis.set_major_formatter(lambda v, _: f"{v:g}")
    axes.minorticks_off()
    axes.set_xlabel("gain of the ideal fit")
    axes.set_ylabel("gain of the diagnosis")
    axes.legend(frameon=False, fontsize=8)


def _rates(axes: Any, effects: Sequence[Entry]) -> None:
    from scipy.stats import binomtest

    for i, (low, high, _) in enumerate(NOISE):
        of = [f["right"] for f in effects if low <= f["excess"] < high]
        if of:
            rate, bounds = sum(of) / len(of), binomtest(sum(of), len(of)).proportion_ci()
            axes.plot([i, i], [100 * bounds.low, 100 * bounds.high], color=AFTER, lw=1.5)
            axes.plot(i, 100 * rate, "o", ms=6, color=AFTER)
            axes.text(i + 0.08, 100 * rate, f"{sum(of)}/{len(of)}", va="center", fontsize=8)
    axes.set_xticks(range(len(NOISE)), [words for *_, words in NOISE])
    axes.set_xlim(-0.5, len(NOISE) - 0.4)
    axes.set_ylim(0, 104)
    axes.set_xlabel("signal over noise")
    axes.set_ylabel("right answers, %")


def _table(heads: Sequence[str], rows: Sequence[Sequence[str]], numbers: Sequence[str] = HEADS) -> str:
    used = [j for j in range(len(heads)) if any(row[j] for row in rows)]
    kind = ["n" if heads[j] in numbers else "" for j in range(len(heads))]
    top = "".join(f'<th class="{kind[j]}">{_text(heads[j])}</th>' for j in used)
    body = "".join(
        "<tr>" + "".join(f'<td class="{kind[j]}">{_text(row[j])}</td>' for j in used) + "</tr>" for row in rows
    )
    return f'<div class="wide"><table><tr>{top}</tr>{body}</table></div>'


def _text(value: object) -> str:
    return html.escape(str(value))
