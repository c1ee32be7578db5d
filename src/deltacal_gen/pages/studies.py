"""The page of a study: what a plan of poses will give."""

from __future__ import annotations

from functools import partial
from typing import Any

from deltacal_gen.pages import figures, report
from deltacal_gen.results.base import shown_in
from deltacal_gen.results.study import Advice, Study, Suspect


def page(found: Study) -> str:
    """Return the page of a STUDY.json."""
    position, advice = found.position, found.advice
    if position is None or advice is None:
        return _of_joints(found)
    before, after = position.before, position.after
    lead = (
        f"As built, machines of these tolerances are {before.rms_mm:.3f} mm off over the workspace. Calibrated "
        f"by this plan, 95 % of them come within {after.p95_mm:.4f} mm, and their worst point within "
        f"{after.worst_p95_mm:.4f} mm."
    )
    return report.page_of(
        "study",
        title=f"{found.robot.robot.name}: study of a plan",
        machine=found.robot.robot.name,
        found=found,
        headline=f"This plan leaves {after.rms_mm:.4f} mm",
        lead=lead,
        steps=[(words, "") for words in _steps(found, advice)],
        errors=report.picture(partial(figures.before_and_after, found=position), (7.4, 2.6)),
        positions=[
            (words, f"{p.rms_mm:.4f}", f"{p.p95_mm:.4f}", f"{p.worst_p95_mm:.4f}", expected)
            for words, p, expected in (
                ("as built", before, ""),
                ("calibrated", after, f"{after.predicted_rms_mm or 0.0:.4f}"),
            )
        ],
        enough=report.picture(partial(figures.enough, found=advice), (7.4, 2.4)),
        gains=[(report.sentence(g.add), f"{g.rms_mm:.4f}", f"{g.gain:.0%}") for g in advice.add],
        **_suspected(found),
        parameters=report.picture(partial(figures.scatter, found=found), (7.4, 3.0)),
        rows=[
            (p.name, *(f"{v:.3g}" for v in (p.drawn_std, p.std, p.predicted_std, p.bias)), p.unit)
            for p in found.parameters
        ],
    )


def _of_joints(found: Study) -> str:
    """Return the page of a STUDY.json of readings of joints: what a diagnosis would find."""
    tried = [s for s in found.suspects if s.effects]
    right, count = sum(s.named_right for s in tried), sum(s.recordings for s in tried)
    return report.page_of(
        "study",
        title=f"{found.robot.robot.name}: study of a plan",
        machine=found.robot.robot.name,
        found=found,
        headline=f"{right} of {count} recordings say what is concealed in them" if count else "Nothing would be found",
        lead="These readings see what moves joints. They say nothing of lengths: no source error is calibrated.",
        steps=[(words, "") for words in _to_find(found)],
        **_suspected(found),
    )


def _suspected(found: Study) -> dict[str, Any]:
    """Return what a page says of effects that were concealed, figures in the unit of readings."""
    unit, length = shown_in(found)
    return {
        "unit": unit,
        "noise": found.noise_told,
        "suspects": [_suspect(s, found, length) for s in found.suspects],
        "chances": _chances(found),
    }


def _steps(found: Study, advice: Advice) -> list[str]:
    steps = []
    if advice.worth:
        steps.append(f"More measuring pays: twice as many readings take {advice.doubling:.0%} off the error.")
    else:
        steps.append(f"This is enough: twice as many readings would take no more than {advice.doubling:.0%} off.")
    if advice.add:
        best = advice.add[0]
        steps.append(f"What helps most beside that is {best.add}: {best.gain:.0%} off.")
    return steps + _to_find(found)


def _to_find(found: Study) -> list[str]:
    steps = []
    for c in found.channels_wanted:
        steps.append(f"To find {report.spaced(c.name)} at all, the plan needs {c.missing}.")
    for s in found.suspects:
        if s.effects and s.interval[0] < 0.5 and s.next:
            steps.append(f"To be surer of {_concealed(s, found)}: {s.next[0]}")
    return steps


def _chances(found: Study) -> str:
    """Return a picture of how often each suspicion was named; nothing where none was concealed."""
    drawn = tried(found)
    size = (7.4, 0.9 + 0.3 * len(drawn))
    return report.picture(partial(figures.chances, suspects=drawn), size) if drawn else ""


def tried(found: Study) -> list[tuple[str, Suspect]]:
    """Return the suspicions of which there are recordings, each behind its words."""
    return [(_concealed(s, found), s) for s in found.suspects if s.recordings]


def _concealed(suspect: Suspect, found: Study) -> str:
    return " and ".join(figures.named(e, found.robot.places) for e in suspect.effects) or "nothing"


def _suspect(s: Suspect, found: Study, length: float) -> tuple[str, ...]:
    low, high = s.interval
    instead = "; ".join(f"{words} ({count})" for words, count in s.instead.items()) or "-"
    held_out = [f"{v / length:.4f}" if v is not None else "-" for v in (s.before_mm, s.after_mm)]
    return (
        _concealed(s, found),
        str(s.recordings),
        str(s.named_right),
        f"{low:.0%} to {high:.0%}",
        instead,
        *held_out,
    )
