"""What a study advises."""

from __future__ import annotations

import dataclasses
import math
from collections import Counter
from collections.abc import Sequence

import numpy as np
from scipy.stats import binomtest

from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.execution import Outcome
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.planning.machines import Linear, Study, Trial, rms_of, rows_of
from deltacal_gen.planning.rows import blank_recording
from deltacal_gen.results.parts import EffectName, Missing
from deltacal_gen.results.study import Addition, Advice, Suspect, Times

NEARBY = 100.0  # mm: the second reference point from the first
TIMES = (0.5, 1.0, 2.0, 4.0, 8.0)  # the plan's readings
WORTH = 0.1  # of the error: what twice the measuring must take away to be worth it
SURE = math.erf(1.96 / math.sqrt(2))  # of an interval: 95 %, the quantile rounded as everybody has it


def advice(study: Study) -> Advice:
    """Return what more of the same, another pose or a second reference point would leave by the linear problem."""
    now = rms_of(study, study.linear)
    enough = tuple(Times(times=t, rms_mm=rms_of(study, study.linear.times(t))) for t in TIMES)
    left = sorted(((words, rms_of(study, more)) for words, more in _ideas(study)), key=lambda idea: idea[1])
    add = tuple(Addition(add=words, rms_mm=rms, gain=_gain(rms, now)) for words, rms in left)
    doubling = _gain(enough[2].rms_mm, now)
    return Advice(rms_mm=now, enough=enough, doubling=doubling, worth=bool(doubling > WORTH), add=add)


def _gain(left: float, now: float) -> float:
    """Return which part of an error is taken off where so much is left; none of no error."""
    return 1 - left / now if now > 0 else 0.0


def _ideas(study: Study) -> list[tuple[str, Linear]]:
    """Return measurements that could be added, each with the linear problem of plan and addition."""
    problem, linear = study.problem, study.linear
    ideas = []
    if problem.readings.kind.second_point and "z" in problem.mechanism.axes:
        moved = problem.with_tool(problem.body.tool + np.array([NEARBY, 0.0, 0.0]))
        words = f"a second reference point {NEARBY:.0f} mm beside the first, at the same poses"
        ideas.append((words, linear.and_more(*rows_of(study, moved))))
    if problem.readings.kind.more_poses and study.robot.workspace is not None:
        q, x = study.check
        plan = problem.recording
        tool = None if plan.tool is None else np.tile(plan.tool[0], (len(q), 1))
        joints = problem.robot.joint_sign * q
        one = blank_recording(problem.robot, plan.kind, joints, plan.columns, plan.measurement, plan.path, tool=tool)
        extra = pose_problem(problem.robot, simulate(problem.robot, one), study.names)
        J, whole = (
            rows.reshape(len(q), -1, rows.shape[1])
            for rows in rows_of(study, dataclasses.replace(extra, scale=problem.scale))
        )
        further = np.zeros((*J.shape[:2], len(linear.prior)))  # read in the first set-up of the instrument
        further[:, :, : J.shape[2]] = J
        better = [linear.and_more(*both) for both in zip(further, whole, strict=True)]
        best = int(np.argmin([rms_of(study, more) for more in better]))
        at = ", ".join(f"{v:.0f}" for v in x[best, :3])
        ideas.append((f"one more pose, at ({at}) mm", better[best]))
    return ideas


def channels_wanted(study: Study) -> tuple[Missing, ...]:
    """Return what the plan does not record and a suspected effect needs."""
    p = study.problem
    body = Body(study.robot, p.mechanism, p.body.q, p.body.tool, Channels.of(study.poses, study.robot))
    lacking = ((term.effect, body.missing(term)) for terms in study.suspects for term in terms)
    return tuple(Missing(name=name, missing=why) for name, why in lacking if why is not None)


def told_of(suspects: Sequence[tuple[EffectName, ...]], outcomes: Sequence[Outcome], each: int) -> tuple[Suspect, ...]:
    """Return suspect by suspect, nothing concealed first, how often it was named."""
    if not outcomes:
        return ()
    told = []
    for k, effects in enumerate([(), *suspects]):
        mine = outcomes[k * each : (k + 1) * each]
        good = [Trial(**o.result) for o in mine if o.result is not None]
        right = sum(r.right for r in good)
        wrong = [r for r in good if not r.right]
        others = Counter(", ".join(f"{n} {limbs}" for n, limbs in r.named) or r.verdict for r in wrong)
        told.append(
            Suspect(
                effects=effects,
                recordings=len(good),
                named_right=right,
                named_among_equals=sum(r.among for r in good),
                chance=right / len(good) if good else None,
                interval=_wilson(right, len(good)),
                instead=dict(others),
                before_mm=_median([r.before_mm for r in good]),
                after_mm=_median([r.after_mm for r in good]),
                next=tuple(sorted({t for r in wrong for t in r.next})[:3]),
                failed=tuple(sorted({o.error for o in mine if o.error is not None})),
            )
        )
    return tuple(told)


def _median(of: Sequence[float | None]) -> float | None:
    """Return the median of what recordings were held out to [mm], None where nothing could be."""
    known = [v for v in of if v is not None]
    return float(np.median(known)) if known else None


def _wilson(right: int, of: int) -> tuple[float, float]:
    """Return the 95 % interval of a chance that came true `right` times of so many."""
    if of == 0:
        return 0.0, 1.0
    found = binomtest(right, of).proportion_ci(SURE, method="wilson")
    return float(found.low), float(found.high)
