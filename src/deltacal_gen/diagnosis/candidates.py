"""Readings that could be taken next: poses where the machine works, with values of the channels that may be set."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.identification.accuracy import turned
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import SOLVED, Array
from deltacal_gen.machine.rotation import about_z
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.law import is_law
from deltacal_gen.physics.terms import Term
from deltacal_gen.results.diagnosis import Row
from deltacal_gen.states import TIME, columns, of_column
from deltacal_gen.units import joint_factors, joint_names, of_joints, to_file

CANDIDATES = 1500  # joints and channels drawn at random, from which the poses are chosen
WIDER = 0.1  # of the range of joints that was recorded: how far beyond it poses may go where nothing says more
LEVELS = 5  # of a channel along which a curve is sought
LONGER = 1.0  # times the session: when the last of the proposed readings may be taken
BETWEEN = 60.0  # s from one reading to the next where a recording does not show it
DECIMALS = 4  # of deg and mm: as precise as controllers take commands
LABEL = "next"  # and a number: the label of a proposed pose


def columns_read(problem: Problem, terms: Sequence[Term]) -> list[str]:
    """Return the columns of a recording that effects read, beside the joints."""
    read = (s for term in terms for s in term.states)
    return columns(read, problem.recording.joint_unit, problem.mechanism.limbs)


@dataclass(frozen=True)
class Candidates:
    """Readings that could be taken: a problem whose rows are poses with values of the channels.

    Attributes
    ----------
    problem : Problem
    ends : (C, 1) or (C, 2) int array
        Rows of each reading.
    position : (C, 3) array
        Where the measured point is, at its first end [mm].
    shown : tuple of str
        Columns that a proposal states, beside the joints.
    first : int
        The number of the first proposal: labels of poses that were measured are not used again.
    """

    problem: Problem
    ends: np.ndarray
    position: Array
    shown: tuple[str, ...]
    first: int = 1

    def to_rows(self, chosen: Sequence[int]) -> list[Row]:
        """Return readings as rows of a recording."""
        recording = self.problem.recording
        return [row_of(recording, self.ends[j].tolist(), self.first + n, self.shown) for n, j in enumerate(chosen)]


def row_of(recording: Recording, ends: Sequence[int], number: int, shown: Sequence[str] = ()) -> Row:
    """Return a reading at rows of a recording as a row to measure; a distance holds the joints of both its ends.

    Joints are as precise as controllers take them.
    """
    first, unit = ends[0], recording.joint_unit
    row: Row = {"pose": f"{LABEL}{number}"}
    for end, k in zip(("a", "b") if len(ends) == 2 else ("",), ends, strict=True):
        q = list(map(to_file, recording.joints[k].tolist(), of_joints(unit, recording.joints.shape[1])))
        row |= zip(joint_names(unit, len(q), f"q{{i}}{end}_{{unit}}"), np.round(q, DECIMALS).tolist(), strict=True)
    if len(recording.setup_names) > 1:
        row["setup"] = recording.setup_names[recording.setup[first]]
    if recording.contact is not None:
        row["contact"] = str(recording.contact[first])
    if recording.tool is not None:
        row |= {f"tool_{a}_mm": float(v) for a, v in zip("xyz", recording.tool[first], strict=True)}
    values = {name: float(recording.channels[name][first]) for name in shown}
    return row | {name: value for name, value in values.items() if np.isfinite(value)}


def candidates(at: Fit, terms: Sequence[Term], rng: np.random.Generator) -> Candidates:
    """Return readings that could be taken next: joints within their limits, positions where the machine works.

    Channels that `terms` read take the ends of what was recorded, or of what may well be set, and values between for a
    formula; the commanded ones among the others are as in some row of the recording.
    """
    problem, ends = at.problem, at.problem.readings.rows.shape[1]
    recording, robot = problem.recording, problem.robot

    def drawn(count: int) -> np.ndarray:
        return np.repeat(rng.integers(count, size=CANDIDATES // ends), ends)  # the same for both ends

    like = drawn(recording.n_rows)
    tool = problem.body.tool[like]
    joints = _drawn(at, tool, rng)
    touched = at.instrument.kind.points(at.instrument, recording)
    which = rng.integers(len(touched), size=CANDIDATES) if touched else None
    if which is not None:
        joints, there = _leading_to(at, np.array([p.position_mm for p in touched])[which], tool, joints)
        joints[~(there & _between(joints, *_joint_range(problem)))] = np.nan
    unit = np.array(joint_factors(recording.joint_unit, joints.shape[1]))
    joints = np.round(joints / unit, DECIMALS) * unit
    channels = {name: _given(values)[like] for name, values in recording.channels.items()}
    needed, curved = columns_read(problem, terms), columns_read(problem, [t for t in terms if is_law(t.effect)])
    for name in dict.fromkeys([*needed, *(n for n in robot.limits if n in channels)]):
        if (levels := levels_of(problem, name, name in curved)) is not None:
            channels[name] = levels[drawn(len(levels))]
    shown = [n for n in channels if n in (*needed, *robot.limits) or (s := of_column(n)).passes or s.commanded]
    rows = dataclasses.replace(
        recording,
        joints=joints,
        measured=np.zeros((CANDIDATES, 0)),
        pose=np.arange(CANDIDATES).astype(str),
        line=np.arange(CANDIDATES) + 2,
        channels=channels,
        setup=np.full(CANDIDATES, recording.setup[-1]),
        tool=None if recording.tool is None else tool,
        contact=None if which is None else np.array([p.name for p in touched])[which],
        pairs=np.arange(CANDIDATES).reshape(-1, 2) if ends == 2 else None,
    )
    past = dataclasses.replace(Channels.of(rows, robot), order=np.full(CANDIDATES, float(recording.n_rows)))
    body = Body(robot, problem.mechanism, robot.joint_sign * joints, tool, past)
    kind = kind_of(rows.kind)
    wanted = kind.readings(rows, np.arange(CANDIDATES)) if touched else kind.unread(rows)
    whole = dataclasses.replace(problem, recording=rows, body=body, readings=wanted)
    machine, status = body.solve(whole.split(at.errors)[0], whole.acting(at.errors))
    usable: np.ndarray = (
        np.ones(CANDIDATES, dtype=bool) if robot.joint_limits is None else _between(joints, *robot.joint_limits.T)
    )
    if not whole.readings.kind.sees_joints:  # else joints are within their limits, wherever that leads
        usable &= (status == SOLVED) & _inside(problem, machine.x)
    whole = whole.subset(np.flatnonzero(usable[whole.readings.rows].all(axis=1)))
    rows_of = whole.readings.rows
    return Candidates(whole, rows_of, machine.x[rows_of[:, 0], :3], tuple(shown), first_label(recording))


def _drawn(at: Fit, tool: Array, rng: np.random.Generator) -> Array:
    """Return joints (C, n_q) of poses anywhere in the workspace, as the controller counts.

    Of an open chain, which reaches a place in many ways, and where the robot file gives no workspace, they are drawn
    between their limits.
    """
    problem = at.problem
    robot, space = problem.robot, problem.robot.workspace
    lower, upper = _joint_range(problem)
    anywhere: Array = lower + rng.random((CANDIDATES, len(lower))) * (upper - lower)
    if space is None or problem.mechanism.many_ways:
        return anywhere
    depth, out = rng.random(CANDIDATES), rng.random(CANDIDATES)
    across = (space.width or 0.0) * (out - 0.5)
    if space.radius is not None:
        across = about_z(space.radius * np.sqrt(out), 2 * np.pi * rng.random(CANDIDATES))
    joints, there = _leading_to(at, turned(robot, space.place(across, depth)), tool, anywhere)
    return np.where(there[:, None], joints, anywhere)


def _leading_to(at: Fit, places: Array, tool: Array, near: Array) -> tuple[Array, np.ndarray]:
    """Return joints (C, n_q) at which a machine stands at places, and where there are such.

    A chain turns about a place (C, 3) as its joints stand, given those near; other machines come to it in one way.
    """
    mechanism, sign = at.problem.mechanism, at.problem.robot.joint_sign
    rows = mechanism.rows(at.problem.robot, at.errors[: len(mechanism.parameters)])
    if mechanism.many_ways:
        q, status = mechanism.follow(places, sign * near, tool, rows)
    else:
        q, _, status = mechanism.inverse(places, tool, rows)
    return sign * np.nan_to_num(q), status == SOLVED


def within_limits(problem: Problem) -> bool:
    """Tell whether poses that could be taken are all that the machine can take: else as far as its joints were seen."""
    anywhere = problem.robot.workspace is not None and not problem.mechanism.many_ways
    return anywhere or problem.robot.joint_limits is not None


def _joint_range(problem: Problem) -> tuple[Array, Array]:
    """Return the lowest and highest joints that may be commanded, as the controller counts."""
    if problem.robot.joint_limits is not None:
        lower, upper = problem.robot.joint_limits.T
        return lower, upper
    joints = problem.recording.joints[np.unique(problem.readings.rows)]
    spare = WIDER * np.ptp(joints, axis=0)
    return joints.min(axis=0) - spare, joints.max(axis=0) + spare


def _inside(problem: Problem, x: Array) -> np.ndarray:
    """Tell which poses (N, 12) lie where the machine works: in its workspace, or among what was measured."""
    space, position = problem.robot.workspace, np.nan_to_num(x[:, :3], nan=np.inf)
    if space is not None:
        return space.holds(position)
    seen = problem.poses(problem.reference)[np.unique(problem.readings.rows), :3]
    return _between(position, seen.min(axis=0), seen.max(axis=0))


def _given(values: Array) -> Array:
    """Return a channel (N,) with what was recorded last, or first, where it is blank."""
    known = np.flatnonzero(np.isfinite(values))
    if not 0 < len(known) < len(values):
        return values
    last = np.searchsorted(known, np.arange(len(values)), side="right") - 1
    return values[known[np.maximum(last, 0)]]


def _between(values: Array, low: Array, high: Array) -> np.ndarray:
    """Tell which rows (N,) of values (N, k) lie between two ends (k,)."""
    return np.asarray(((values >= low) & (values <= high)).all(axis=1))


def levels_of(problem: Problem, name: str, curved: bool) -> Array | None:
    """Return the values of a channel that are proposed, None where whoever measures cannot choose them.

    The ends of what can be set; between them, too, along what is `curved`: any where limits are known or time passes,
    else such as were recorded.
    """
    channel, used = of_column(name), np.unique(problem.readings.rows)
    values = problem.recording.channels.get(name)
    seen = np.zeros(0) if values is None else np.unique(values[used][np.isfinite(values[used])])
    ends = _ends(problem, name, seen)
    if ends is None or not curved or channel.levels or len(ends) > LEVELS:
        return ends
    even: Array = np.linspace(ends.min(), ends.max(), LEVELS).round(DECIMALS)
    if name in problem.robot.limits or channel.passes or not len(seen):
        return even
    return np.unique([seen[np.argmin(np.abs(seen - v))] for v in even])


def _ends(problem: Problem, name: str, seen: Array) -> Array | None:
    """Return the ends of what a channel can be set to, given the values seen (n,), sorted."""
    channel, masses = of_column(name), problem.robot.masses
    if name in problem.robot.limits:
        return np.array(problem.robot.limits[name])
    if channel.weighs and len(seen) < 2:  # the platform once more
        held = float(seen[0]) if len(seen) else 0.0
        return None if masses is None or not masses.platform else np.array([held, held + masses.platform])
    if channel.weighs:
        return seen if len(seen) <= 4 else seen[[0, -1]]
    if not len(seen) or (channel.step and not channel.levels and not channel.passes and np.ptp(seen) == 0):
        return (seen[0] if len(seen) else channel.default) + np.array([0.0, channel.step]) if channel.step else None
    if channel.levels:
        return np.array(channel.levels)
    if channel.passes:
        return np.round(seen[-1] + gap_of(seen) + np.array([0.0, LONGER * float(np.ptp(seen))]), 1)
    return np.array([seen[0], 0.0, seen[-1]]) if channel.rests else seen[[0, -1]]


def gap_of(times: Array) -> float:
    """Return the usual time from one reading to the next [s] of sorted times (n,)."""
    return float(np.median(np.diff(times))) if len(times) > 1 else BETWEEN


def in_time(rows: Sequence[Row], recording: Recording) -> list[Row]:
    """Return rows in the order of their times, which come after those of a recording and grow from row to row."""
    if TIME not in recording.channels:
        return list(rows)
    times = recording.channels[TIME]
    seen = np.unique(times[np.isfinite(times)])
    return one_by_one(rows, float(seen[-1]), gap_of(seen))


def one_by_one(rows: Sequence[Row], last: float, gap: float) -> list[Row]:
    """Return rows in the order of their times, each `gap` [s] or more after the one before: after `last` the first."""
    out: list[Row] = []
    for row in sorted(rows, key=lambda row: float(row.get(TIME, last))):
        last = max(float(row.get(TIME, last)), round(last + gap, 1))
        out.append(row | {TIME: last})
    return out


def first_label(recording: Recording) -> int:
    """Return the number of the first proposed pose: that after all which the recording has."""
    numbers = [label.removeprefix(LABEL) for label in map(str, recording.pose) if label.startswith(LABEL)]
    return max((int(n) for n in numbers if n.isdecimal()), default=0) + 1
