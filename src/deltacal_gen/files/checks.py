"""Values of a recording that cannot be: of another unit, impossible, of another pose, or not from the home."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator

import numpy as np

from deltacal_gen.errors import BadValue, ContradictingRows, ImplausibleReadings, WrongUnit
from deltacal_gen.files.robot import robot_size
from deltacal_gen.files.rows import Rows
from deltacal_gen.instrument.kinds import PAIRS, kind_of
from deltacal_gen.machine.values import Recording, Robot
from deltacal_gen.states import RECORDED
from deltacal_gen.units import DEG, joint_names, of_joints, to_file

_SAME_JOINT = 1e-6 * DEG  # rad, and mm: joints that differ by more are not the same pose
_LEAST_SPREAD = 0.01  # of readings, in machine sizes per rad of joint motion (1 rad at most)
_MOST_SPREAD = 20.0  # in machine sizes
_MOST_MOTION = 5.0  # in machine sizes per rad of joint motion
_MOST_PAYLOAD = 20.0  # in moving masses of the machine: parallel robots carry a few of them
_HOME = 0.1  # of the spread of positions: further from zero the first row is not at the home
_TURN, _MOST_TURN = 360.0, 720.0  # deg: of limbs, and of arms, whose wrists turn 400 and more; beyond are motor angles
_RADIANS = 1.6  # a column of degrees that stays within this may be in radians


def check_units(recording: Recording, robot: Robot) -> None:
    """Compare joints and readings with the size of the machine.

    Raises
    ------
    InputError
        Joints look like radians or motor angles, or positions or distances like metres or micrometres.
    """
    q = recording.joints
    turning = np.array([unit == "rad" for unit in of_joints(recording.joint_unit, q.shape[1])])
    most = np.full(len(turning), (_MOST_TURN if robot.links else _TURN) * DEG)
    if robot.joint_limits is not None:
        most = np.maximum(most, np.nan_to_num(np.abs(robot.joint_limits).max(axis=1)))
    if (far := np.argwhere(turning & (np.abs(q) > most))).size:
        row, joint = far[0]
        raise ImplausibleReadings(
            f"the joint reads {q[row, joint] / DEG:.6g} deg, more than joints of this machine turn either way.",
            "Give angles of the joint, after the gear, in degrees; or limits_deg of one that turns so far.",
            file=recording.path,
            line=int(recording.line[row]),
            column=f"q{joint + 1}_deg",
        )
    # an axis is as long as it slides
    size = robot_size(robot) + float(np.ptp(q[:, ~turning], axis=0).max(initial=0.0)) * bool(robot.links)
    if size == 0:
        raise BadValue(
            "the machine has no size: the lengths of all its links are 0, and no joint slides in this recording.",
            "Give a and d of its [[joint]] tables, in mm.",
            file=robot.source,
        )
    small_angles = turning.any() and (np.abs(q[:, turning]) <= _RADIANS * DEG).all()
    for column, spread, turn in _spreads(recording, q / np.where(turning, 1.0, size)):
        what = f"the readings spread over {spread:.4g} mm"
        if small_angles and spread > size * max(_MOST_MOTION * turn, _LEAST_SPREAD):
            raise WrongUnit(
                f"{what}, yet no joint reads more than {_RADIANS} deg: the joints look like radians.",
                "Convert them to degrees.",
                file=recording.path,
                column=f"q{int(np.argmax(turning)) + 1}_deg",
            )
        if spread > _MOST_SPREAD * size or spread < _LEAST_SPREAD * size * min(turn, 1.0):
            unit, factor = ("micrometres", "Divide by") if spread > size else ("metres", "Multiply by")
            raise WrongUnit(
                f"{what} on a machine of {size:.4g} mm: they look like {unit}.",
                f"{factor} 1000, or correct the robot file.",
                file=recording.path,
                column=column,
            )


def _spreads(recording: Recording, joints: np.ndarray) -> Iterator[tuple[str, float, float]]:
    """Column, spread of its readings [mm] and largest motion of a joint (N, n_q) between them."""
    kind, pairs = kind_of(recording.kind), kind_of(PAIRS)
    yield from kind.spreads(recording, joints)
    if recording.pairs is not None and not kind.pairs:
        yield from pairs.spreads(recording, joints)


def impossible(name: str, values: np.ndarray, heaviest: float = np.inf) -> tuple[np.ndarray, str]:
    """Which values (N,) of a channel cannot be, and what was expected in words; `heaviest` is the largest payload."""
    channel = next((s for s in RECORDED if s.holds(name)), None)
    if channel is None:
        return np.zeros(len(values), dtype=bool), ""
    low, high = channel.ends
    wrong = (values < low) | (values > high)
    if channel.levels:
        wrong = np.isfinite(values) & ~np.isin(values, (0.0, *channel.levels))  # 0: not known which
    if channel.weighs and not wrong.any():
        return values > heaviest, f"at most {heaviest:.3g} kg were expected on arms and a platform like these"
    return wrong, channel.expected


def set_aside(recording: Recording, robot: Robot) -> Recording:
    """Return the recording without the channels that hold values which cannot be; `doubts` says why."""
    masses = robot.masses
    heaviest = np.inf
    if masses is not None:
        limbs = recording.joints.shape[1]
        moving = masses.platform + limbs * (masses.proximal + 2 * masses.distal_rod)
        heaviest = _MOST_PAYLOAD * moving if moving else np.inf
    doubts = {}
    for name, values in recording.channels.items():
        wrong, expected = impossible(name, values, heaviest)
        if wrong.any():
            row = int(np.argmax(wrong))
            doubts[name] = f"line {recording.line[row]} holds {values[row]:.6g}: {expected}"
    kept = {name: values for name, values in recording.channels.items() if name not in doubts}
    return dataclasses.replace(recording, channels=kept, doubts=doubts)


def check_repeats(recording: Recording, rows: Rows) -> None:
    """Rows of one pose have the same joints; which point of the machine was measured there may differ."""
    stands = recording.joints if recording.targets is None else recording.targets
    poses = recording.pose.tolist()
    first = {label: row for row, label in reversed([*enumerate(poses)])}
    moved = np.abs(stands - stands[[first[label] for label in poses]]).max(axis=1)
    rows.refuse(
        moved > _SAME_JOINT,
        lambda k: f"pose '{poses[k]}' has other joints than in line {rows.line[first[poses[k]]]}.",
        "Give every pose a label of its own; only repeats, and points measured at one pose, share one.",
        column="pose",
        family=ContradictingRows,
    )


def check_home(recording: Recording) -> None:
    """Increments count from the first row, which stands at the home."""
    unit, home = recording.joint_unit, recording.joints[0]
    each = zip(joint_names(unit, len(home)), of_joints(unit, len(home)), home, strict=True)
    off = {name: to_file(value, u) for name, u, value in each if abs(value) > _SAME_JOINT}
    what, axes = "joints", kind_of(recording.kind).zero_at_home(recording)
    if not off and axes is not None:
        spread = float(np.ptp(axes[np.isfinite(axes).all(axis=1)], axis=0).max(initial=0.0))
        first = zip(recording.columns, axes[0].tolist(), strict=False)
        off, what = {name: value for name, value in first if abs(value) > _HOME * spread}, "readings"
    if off:
        column = max(off, key=lambda name: abs(off[name]))
        raise ImplausibleReadings(
            f'zero = "incremental": {what} count from the home, yet the first row reads {off[column]:.6g} '
            f"{column.rpartition('_')[2]}.",
            'Put the home, with joints 0, into the first row, or say zero = "absolute" in the sidecar.',
            file=recording.path,
            line=int(recording.line[0]),
            column=column,
        )
