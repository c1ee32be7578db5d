"""The page of a recording in motion: drives over time, the ladder of each joint, the rigid machine behind it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from deltacal_gen.pages import figures, laws, report
from deltacal_gen.pages.figures import AFTER, BEFORE, MUTED
from deltacal_gen.results.diagnosis import Verdict
from deltacal_gen.results.motion import (
    LadderOf,
    MotionDiagnosis,
    MotionResult,
    MotionValidation,
    TorqueEffect,
    Trace,
)
from deltacal_gen.results.parts import Source
from deltacal_gen.results.places import Places

OVER_TIME, AGAINST = (3.9, 1.9), (7.4, 1.9)  # sizes of a picture [inches]
WIDE = 7.4
LAW = (6.4, 3.0)
SHADES = (AFTER, "#5b8fb0", "#8fb3c9", "#c3d6e2")  # of rungs, the one that buys most first
DOT = 3.0


def motion(found: MotionResult | MotionDiagnosis) -> str:
    """Return the page of a RESULT.json or a DIAGNOSIS.json of a recording in motion."""
    machine = found.robot.robot.name
    diagnosed = isinstance(found, MotionDiagnosis)
    each = {} if isinstance(found, MotionResult) else _diagnosed(found)
    blank: dict[str, Any] = {
        "steps": [],
        "law": None,
        "ladder": "",
        "stops": "",
        "parameters": [],
        "rejected": [],
        "not_tested": [],
    }
    own, found_too = any(p.limb is not None for p in found.base), ["with what was found"] * diagnosed
    return report.page_of(
        "motion",
        **(
            blank
            | {
                "badge": Verdict.ADEQUATE.value,
                "verdict": "identified",
                "headline": f"{machine}: {len(found.base)} base parameters",
                "next": [(report.spaced(n.why), n.text) for n in found.next_measurements],
            }
            | each
        ),
        made=found.made,
        title=f"{machine}: {'diagnosis' if diagnosed else 'identification'} in motion",
        machine=machine,
        found=found,
        told=report.told(found),
        heldout_columns=("joint", "rigid machine alone", *found_too, "low-pass filtered", "unit"),
        heldout=_heldout(found),
        time=[_picture(f"joint {t.limb}", partial(over_time, trace=t, bare=not diagnosed)) for t in found.traces],
        against=[{"title": f"joint {t.limb}", "svg": _panels(t, bare=not diagnosed)} for t in found.traces],
        bodies=[(body.name, f"{body.value:.5g}", body.unit) for body in found.consistent or ()],
        base_columns=("parameter", *(("joint",) if own else ()), "made of", "value ± standard uncertainty", "unit"),
        base=[
            (
                p.name,
                *((str(p.limb),) if own else ()),
                p.combination or ("of all runs" if p.run is None else f"of run {p.run}"),
                report.measured(p.value, p.std),
                p.unit,
            )
            for p in found.parameters
        ],
    )


def validation(found: MotionValidation, traces: Sequence[Trace]) -> str:
    """Return the page of a validation in motion."""
    each = zip(
        found.rms_by_joint,
        found.rms_by_joint_filtered,
        found.noise.sigma_by_joint,
        found.unit_by_joint,
        strict=True,
    )
    return report.page_of(
        "validation_in_motion",
        title="Validation in motion",
        found=found,
        told=report.told(found),
        errors=[(str(j), *map(_figure, values), unit) for j, (*values, unit) in enumerate(each, 1)],
        noise="as declared" if found.noise.source == Source.DECLARED else "as the model's own recording left it",
        time=[_picture(f"joint {t.limb}", partial(over_time, trace=t, bare=True)) for t in traces],
        against=[{"title": f"joint {t.limb}", "svg": _panels(t, bare=True)} for t in traces],
        rows=[(str(row.line), str(row.limb), f"{row.error:.4g}", row.unit) for row in found.rows],
        made=found.made,
    )


def _figure(value: float | None) -> str:
    return "-" if value is None else f"{value:.4g}"


def _diagnosed(found: MotionDiagnosis) -> dict[str, Any]:
    """Return what only the page of a diagnosis shows."""
    names = ", ".join(dict.fromkeys([*(e.title for e in found.effects), *map(laws.title, found.laws)]))
    return {
        "badge": "" if found.verdict is Verdict.MISSING_PHYSICS else found.verdict.value,  # friction is no alarm
        "verdict": figures.VERDICTS[found.verdict],
        "headline": f"Beside the rigid machine: {names}" if names else figures.VERDICTS[found.verdict].capitalize(),
        "steps": [(_step(e, found.robot.places), "") for e in found.effects],
        "ladder": _ladder(found.ladder),
        "stops": "; ".join(dict.fromkeys(f"{ladder.stops}" for ladder in found.ladder)).capitalize() + ".",
        "parameters": [
            (
                report.spaced(e.name),
                str(p.limb or p.setup or ("all alike" if p in (e.common or ()) else "")),
                p.name,
                report.measured(p.value, p.std),
                "" if p.unit == "1" else p.unit,
            )
            for e in found.effects
            for p in (*e.parameters, *(e.common or ()))
        ],
        "law": _law(found),
        "rejected": [(report.spaced(r.name), f"{r.gain_chi2:.0f}", r.why) for r in found.rejected],
        "next": [(report.spaced(n.why), n.text) for n in found.next_measurements],
        "not_tested": [(report.spaced(t.name), t.missing) for t in found.not_tested],
    }


def _law(found: MotionDiagnosis) -> dict[str, object] | None:
    """Return the law that was found as a page shows it."""
    if not found.laws:
        return None
    law = found.laws[0]
    each = enumerate(zip(law.heldout_rms_by_joint, law.unit_by_joint, strict=True), 1)
    left = ", ".join(f"{value:.4g} {unit} of joint {j}" for j, (value, unit) in each if value is not None)
    pictures = laws.drawn(law, lambda draw: report.picture(draw, LAW))
    return laws.described(law, (), left, found.robot.places) | {"pictures": pictures}


def _step(effect: TorqueEffect, places: Places) -> str:
    """Return what to do about an effect."""
    where = f", {places.name(effect.limbs, 'joint')}" if effect.limbs else ""
    return f"{effect.title.capitalize()}{where}: {effect.advice or ''}"


def _heldout(found: MotionResult | MotionDiagnosis) -> list[tuple[str, ...]]:
    """Return of every joint the held-out error: of a diagnosis without and with what was found, and filtered."""
    after = found.final
    stages = [after.heldout_rms_by_joint, after.heldout_rms_by_joint_filtered]
    if isinstance(found, MotionDiagnosis):
        stages.insert(0, found.baseline.heldout_rms_by_joint)
    rows = enumerate(zip(*stages, after.unit_by_joint, strict=True), 1)
    return [(str(j), *map(_figure, values), unit) for j, (*values, unit) in rows]


def _picture(title: str, draw: partial[None]) -> dict[str, str]:
    return {"title": title, "svg": report.picture(draw, OVER_TIME)}


def over_time(axes: Axes, trace: Trace, *, bare: bool) -> None:
    """Draw what a drive gave, and what the models say; `bare` where there is one model alone."""
    axes.plot(trace.time, trace.measured, color=MUTED, linewidth=1.6, alpha=0.6)
    if not bare:
        axes.plot(trace.time, trace.before, color=BEFORE, linewidth=0.8)
    axes.plot(trace.time, trace.after, color=AFTER, linewidth=0.9)
    axes.set_xlabel("time, s")
    axes.set_ylabel(_of(trace))
    axes.margins(x=0)


def _panels(trace: Trace, *, bare: bool) -> str:
    return report.panels(partial(against, trace=trace, bare=bare), (1, 3), AGAINST)


def against(axes: np.ndarray, trace: Trace, *, bare: bool) -> None:
    """Draw errors against speed, position and load."""
    unit = "mm" if trace.slides else "deg"
    where = (
        (trace.speed, f"speed, {unit}/s"),
        (trace.position, f"{'position' if trace.slides else 'angle'}, {unit}"),
        (trace.load, "load" if trace.unit == "1" else f"load, {trace.unit}"),
    )
    for axis, (values, words) in zip(np.ravel(axes), where, strict=True):
        if not bare:
            axis.scatter(values, trace.error_before, s=DOT, color=BEFORE, linewidths=0, alpha=0.6)
        axis.scatter(values, trace.error_after, s=DOT, color=AFTER, linewidths=0)
        axis.axhline(0.0, color=MUTED, linewidth=0.6)
        axis.set_xlabel(words)
    np.ravel(axes)[0].set_ylabel("residual" if trace.unit == "1" else f"residual, {trace.unit}")


def _of(trace: Trace) -> str:
    names = {"Nm": "torque, Nm", "N": "force, N", "A": "current, A", "1": "drive"}
    return names[trace.unit]


def _ladder(ladders: Sequence[LadderOf]) -> str:
    """Return the rungs of all joints as bars."""
    rows = [(ladder, rung) for ladder in ladders for rung in ladder.rungs]
    return report.picture(partial(bars, ladders=ladders), (WIDE, 0.6 + 0.22 * len(rows))) if rows else ""


def bars(axes: Axes, ladders: Sequence[LadderOf]) -> None:
    """Draw what every rung of every joint buys."""
    at, labels, ends = [], [], 0.0
    for ladder in ladders:
        for n, rung in enumerate(ladder.rungs):
            axes.barh(ends, 100 * rung.buys, height=0.75, color=SHADES[min(n, len(SHADES) - 1)])
            axes.text(100 * rung.buys + 0.8, ends, f"{100 * rung.buys:.0f}", va="center", fontsize=8, color=MUTED)
            labels.append(f"joint {ladder.limb}   {report.spaced(rung.name)}" if n == 0 else report.spaced(rung.name))
            at.append(ends)
            ends += 1.0
        ends += 0.5
    axes.set_yticks(at, labels)
    axes.invert_yaxis()
    axes.set_xlabel("% of the held-out rms")
