"""Denavit-Hartenberg rows of a chain that is known by the lines of its joints.

Rows are standard, with Hayati's angle where neighbouring axes are all but parallel: Rz(theta) Tz(d) Tx(a) Rx(alpha)
Ry(beta). The lines are those at joints zero; a row leads along one line and across to the next, whichever way its frame
turns there, so that one row before the first joint and one behind the last put base and end where they are wanted.
Where a row leads, the derived kernels say: what a row misses by its last digits, the next one makes up for.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from deltacal_gen.machine.chain import HAYATI, Chain
from deltacal_gen.machine.registry import Array, load_mechanism
from deltacal_gen.machine.values import Link
from deltacal_gen.units import DEG

NEARLY_PARALLEL = 1.0 * DEG  # no drawing has axes so close to parallel: a calibrated machine has, with normals far off
MEET = 1e-10  # mm: lines that are closer have no direction from one to the other
NOISE = 1e-13  # rad: what rounding leaves of angles that are zero
ONE = Link("revolute", "standard", 0.0, 0.0, (0.0, 0.0, 0.0))
MM_DIGITS, DEG_DIGITS = 11, 12  # that are kept


class Row(NamedTuple):
    """A standard row [mm, rad]: `alpha` is as drawn, `tilt` is added to it, and `beta` turns about y behind it."""

    theta: float = 0.0
    d: float = 0.0
    a: float = 0.0
    alpha: float = 0.0
    tilt: float = 0.0
    beta: float = 0.0

    def neat(self) -> Row:
        """Return the row without the last digits, which rounding makes."""
        lengths = {key: round(float(getattr(self, key)), MM_DIGITS) + 0.0 for key in ("d", "a")}
        angles = {
            k: round(float(getattr(self, k)) / DEG, DEG_DIGITS) * DEG + 0.0 for k in self._fields if k not in lengths
        }
        return Row(**lengths, **angles)

    def matrix(self) -> Array:
        """Return the frame (4, 4) that the row leads to, joint zero."""
        machine, out = load_mechanism("serial", (ONE,)), np.eye(4)
        assert isinstance(machine, Chain)
        table = np.zeros((1, 1, machine.width + len(machine.deflections)))
        for column, entry in enumerate(machine.geometry):
            table[..., column] = getattr(self, entry.key)
        table[..., machine.column("alpha")], table[..., machine.column(HAYATI)] = self.tilt, self.beta
        x, _ = machine.forward(np.zeros((1, 1)), np.zeros(3), table)
        out[:3, 3], out[:3, :3] = x[0, :3], x[0, 3:].reshape(3, 3)
        return out


@dataclass(frozen=True)
class Rows:
    """The rows of a chain with n joints.

    Parameters
    ----------
    base : Row
        From {O} to the line of the first joint; all zero where that is z.
    joints : tuple of Row
        One for each joint.
    end : Row
        Along and about z of the last joint's frame, to the end; all zero where that frame is the end already.
    sign : (n,) array
        -1 where a joint turns or slides against the z of its row.
    frames : (n, 4, 4) array
        Behind each joint's row, in {O} at joints zero [mm].
    """

    base: Row
    joints: tuple[Row, ...]
    end: Row
    sign: Array
    frames: Array


def rows_of(points: Array, directions: Array, end: Array) -> Rows:
    """Return the rows of a chain by the lines of its joints.

    Of two ways across to the next line the one is taken that turns x by less than a quarter of a turn; of two quarters
    the one with a above zero. A joint whose line runs against the line before it counts backwards instead (`sign`).
    Between parallel lines d is zero.

    Parameters
    ----------
    points, directions : (n, 3) arrays
        A point of each joint's line [mm] and a unit vector along it, in {O} at joints zero.
    end : (4, 4) array
        The last frame in {O} at joints zero [mm].
    """
    frame, rows, frames, sign = np.eye(4), list[Row](), list[Array](), list[float]()
    for point, direction in zip(points, directions, strict=True):
        p, z = _seen(frame, point, direction)
        sign.append(-1.0 if z[2] < -math.cos(NEARLY_PARALLEL) else 1.0)
        rows.append(_across(p, sign[-1] * z).neat())
        frame = frame @ rows[-1].matrix()
        frames.append(frame)
    rows.append(_to_end(frame, end).neat())
    frames.append(frame := frame @ rows[-1].matrix())
    left = np.linalg.inv(frame) @ end
    last = Row(theta=math.atan2(left[1, 0], left[0, 0]), d=left[2, 3]).neat()
    if abs(last.theta) < 2 * NOISE + DEG * 10.0**-DEG_DIGITS and abs(last.d) < MEET:
        last = Row()
    return Rows(rows[0], tuple(rows[1:]), last, np.array(sign), np.array(frames[1:]))


def _seen(frame: Array, point: Array, direction: Array) -> Sequence[Array]:
    return frame[:3, :3].T @ (point - frame[:3, 3]), frame[:3, :3].T @ direction


def _across(p: Array, z: Array, level: float = 0.0) -> Row:
    """Return the row from the z axis to the line through p along z; `level` is d where these are parallel."""
    if math.hypot(z[0], z[1]) > math.sin(NEARLY_PARALLEL):
        theta = _least(math.atan2(z[0], -z[1]), p)
        c, s = math.cos(theta), math.sin(theta)
        alpha = math.atan2(z[0] * s - z[1] * c, z[2])
        t = -(c * p[1] - s * p[0]) / (c * z[1] - s * z[0])
        return Row(theta, p[2] + t * z[2], c * p[0] + s * p[1], alpha)
    foot = p + (level - p[2]) / z[2] * z
    theta = _least(math.atan2(foot[1], foot[0]), p) if math.hypot(foot[0], foot[1]) > MEET else 0.0
    c, s = math.cos(theta), math.sin(theta)
    return _tilted(theta, level, c * foot[0] + s * foot[1], np.array([c * z[0] + s * z[1], c * z[1] - s * z[0], z[2]]))


def _to_end(frame: Array, end: Array) -> Row:
    """Return the last joint's row: across to the z of the end, or into the end itself where the lines coincide."""
    p, z = _seen(frame, end[:3, 3], end[:3, 2])
    parallel = math.hypot(z[0], z[1]) <= math.sin(NEARLY_PARALLEL)
    if not parallel or math.hypot(p[0], p[1]) > MEET:
        return _across(p, z, p[2])
    y = frame[:3, :3].T @ end[:3, 1]
    way = math.copysign(1.0, z[2])  # R = Rz(theta) Rx(alpha) Ry(beta), whose y is that of Rz(theta) Rx(alpha)
    theta = math.atan2(-way * y[0], way * y[1])
    c, s = math.cos(theta), math.sin(theta)
    return _tilted(theta, p[2], 0.0, np.array([c * z[0] + s * z[1], c * z[1] - s * z[0], z[2]]))


def _tilted(theta: float, d: float, a: float, z: Array) -> Row:
    """Return the row to an axis `z` that is all but parallel, seen behind the turn by `theta`."""
    drawn = 0.0 if z[2] > 0 else math.pi
    tilt, beta = math.atan2(-z[1], z[2]) - drawn, math.asin(max(-1.0, min(1.0, z[0])))
    tilt = math.remainder(tilt, 2 * math.pi)
    return Row(theta, d, a, drawn, *(v if abs(v) > NOISE else 0.0 for v in (tilt, beta)))


def _least(theta: float, p: Array) -> float:
    """Return the direction or its opposite, whichever is less than 90 deg off x; else that to p, else that of y."""
    c, s = math.cos(theta), math.sin(theta)
    along = c * p[0] + s * p[1]
    side = c if abs(c) > NOISE else along if abs(along) > MEET else s
    opposite = side < 0
    return math.remainder(theta + math.pi, 2 * math.pi) if opposite else theta
