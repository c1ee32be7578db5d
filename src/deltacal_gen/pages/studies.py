"""The page of a study: what a plan of poses, or a trajectory, will give."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np

from deltacal_gen.files.robot import robot_of
from deltacal_gen.pages import figures, report
from deltacal_gen.results.base import shown_in
from deltacal_gen.results.motion import by_limb
from deltacal_gen.results.study import Advice, Study, Suspect
from deltacal_gen.results.trajectories import MotionStudy, TorqueAddition


def page(found: Study | MotionStudy) -> str:
    """Return the page of a STUDY.json, of a machine at rest or in motion."""
    return _of_poses(found) if isinstance(found, Study) else _of_drives(found)


def _of_poses(found: Study) -> str:
    """Return the page of a STUDY.json of a machine at rest."""
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
        steps=_steps(found, advice),
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
        steps=_to_find(found),
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


def _of_drives(found: MotionStudy) -> str:
    """Return the page of a STUDY.json of kind torque."""
    open_ = [p.name for p in found.parameters if p.predicted_std is None]
    loose = [p.name for p in found.parameters if p.predicted_std is not None and p.predicted_std > p.drawn_std]
    steps = [f"This trajectory leaves open: {', '.join(open_)}."] if open_ else []
    if loose:
        steps.append(f"Of {', '.join(loose)} it tells less than the robot file says already.")
    best = min(found.add, key=lambda a: _over(found, a), default=None)
    if best is not None:
        steps.append(f"{report.sentence(best.add)} leaves {1 - _over(found, best):.0%} less of the error.")
    for c in found.channels_wanted:
        steps.append(f"To find {report.spaced(c.name)} at all, the trajectory needs {c.missing}.")
    return report.page_of(
        "study_of_drives",
        title=f"{found.robot.robot.name}: study of a trajectory",
        machine=found.robot.robot.name,
        found=found,
        headline=f"Torques predicted to {by_limb(((t.after_rms, t.unit) for t in found.torque), 2)}",
        steps=steps,
        errors=report.picture(partial(figures.torques, found=found), (7.4, 0.9 + 0.42 * len(found.torque))),
        torque=[
            (
                str(t.limb),
                *("-" if v is None else f"{v:.3g}" for v in (t.before_rms, t.after_rms, t.p95, t.predicted_rms)),
                t.unit,
                str(t.readings),
            )
            for t in found.torque
        ],
        gains=[
            (
                report.sentence(a.add),
                by_limb(((v, "") for v in a.rms_by_joint), 3).strip(),
                f"{1 - _over(found, a):.0%}",
            )
            for a in found.add
        ],
        suspects=[_suspect(s, found)[:5] for s in found.suspects],
        chances=_chances(found),
        parameters=report.picture(partial(figures.scatter, found=found), (7.4, 3.0)),
        rows=[
            (
                p.name,
                p.combination,
                *("-" if v is None else f"{v:.3g}" for v in (p.drawn_std, p.std, p.predicted_std, p.stated_std)),
                p.unit,
            )
            for p in found.parameters
        ],
    )


def _over(found: MotionStudy, more: TorqueAddition) -> float:
    """Return what a further movement leaves of the joints' errors, in parts of what there is without, in the mean."""
    pairs = zip(more.rms_by_joint, (t.predicted_rms for t in found.torque), strict=True)
    known = [after / before for after, before in pairs if after is not None and before]
    return float(np.mean(known)) if known else 1.0


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


def _chances(found: Study | MotionStudy) -> str:
    """Return a picture of how often each suspicion was named; nothing where none was concealed."""
    drawn = tried(found)
    size = (7.4, 0.9 + 0.3 * len(drawn))
    return report.picture(partial(figures.chances, suspects=drawn), size) if drawn else ""


def tried(found: Study | MotionStudy) -> list[tuple[str, Suspect]]:
    """Return the suspicions of which there are recordings, each behind its words."""
    return [(_concealed(s, found), s) for s in found.suspects if s.recordings]


def _concealed(suspect: Suspect, found: Study | MotionStudy) -> str:
    robot, part = robot_of(found.robot), "joint" if isinstance(found, MotionStudy) else None
    return " and ".join(figures.named(e, robot, part) for e in suspect.effects) or "nothing"


def _suspect(s: Suspect, found: Study | MotionStudy, length: float = 1.0) -> tuple[str, ...]:
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
