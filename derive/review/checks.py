"""What a derivation is checked by, in numbers, on one machine: seeded, so that the same sources give the same figures.

Poses are drawn at random from the robot file's workspace, else from the joints about a pose that the machine can take.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from deltacal_gen.files.robot import Robot, robot_size
from deltacal_gen.identification.accuracy import turned
from deltacal_gen.identification.identifiability import RANK_TOLERANCE, Combination, unseen
from deltacal_gen.instrument.facts import Look
from deltacal_gen.instrument.kind import Kind
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.instrument.kinds import names as kind_names
from deltacal_gen.machine.registry import SOLVED, Array, Machine, mechanism_of
from deltacal_gen.machine.rotation import from_vector, to_vector
from deltacal_gen.machine.values import Camera, Measurement

SEED = 1
POSES = 160
SWING = 0.5  # rad to either side of the middle pose, where there is no workspace
SLIDE = 0.08  # of the machine's size, for sliding joints
HALVINGS = 9  # of the step, for orders of convergence
SOCKETS = 40  # fixed points that are touched
STANDS = 4  # ways in which an open chain touches each of them
TOUCHES = 12  # Newton steps to a fixed point
MOST_READINGS = 2000  # of a kind and a reference point: of more, some are drawn
TOUCHED = 1e-9  # mm off a fixed point
MOUNTED = 0.05  # of how far off an instrument ordinarily stands: about there its derivatives are checked
CAMERA = Camera(fx_px=1500.0, fy_px=1500.0, cx_px=640.0, cy_px=512.0, ball_radius_mm=20.0)
OFFSETS = ((0.0, 0.0, 0.0), (0.0, 0.0, -150.0), (150.0, 0.0, 0.0))  # reference points on the platform [mm]


@dataclass(frozen=True)
class Poses:
    """Joints (N, n_q), solved poses (N, 12), the tool point (3,) that they belong to, and what all errors move there.

    `by_errors` (N, 6, n): shift [mm] and turn [rad] in {O} by each parameter of the mechanism.
    """

    q: Array
    x: Array
    tool: Array
    by_errors: Array

    def first(self, count: int) -> Poses:
        """Return the first so many of them."""
        return Poses(self.q[:count], self.x[:count], self.tool, self.by_errors[:count])


def _poses(robot: Robot, q: Array, x: Array, tool: Array) -> Poses:
    mechanism = mechanism_of(robot)
    return Poses(q, x, tool, mechanism.sensitivity(x, q, tool, mechanism.rows(robot)).parameters)


@dataclass(frozen=True)
class Trials:
    """Poses at which every model of a machine is checked.

    `sets`: the same joints with each of the reference points `OFFSETS`, the first of which is the robot file's;
    `touched`: see `touching`, for machines that can.
    """

    sets: tuple[Poses, ...]
    touched: tuple[Poses, ...]

    @property
    def poses(self) -> Poses:
        """Those of the robot file's reference point."""
        return self.sets[0]


@dataclass(frozen=True)
class Order:
    """How what first order leaves shrinks with the step: 2 where the derivative is right."""

    by: str
    steps: Array
    gaps: Array

    @property
    def order(self) -> float:
        """Median slope between steps, of those that rounding does not spoil; infinite where it spoils all."""
        clear = self.gaps > 1e-9 * max(float(self.gaps[0]), 1e-3)
        slopes = -np.diff(np.log2(np.maximum(self.gaps, 1e-300)))[clear[1:]]
        return float(np.median(slopes)) if len(slopes) else float("inf")


@dataclass(frozen=True)
class Rank:
    """What poses without any symmetry see of a model by one kind of measurement.

    `smallest` and `noise`: the smallest singular value that counts and the largest that does not, by the largest.
    """

    kind: str
    points: int
    rank: int
    columns: int
    smallest: float
    noise: float
    unseen: tuple[Combination, ...]
    motions: str


def middle(robot: Robot) -> Poses:
    """Return the pose in the middle of the workspace, or of the joints."""
    mechanism = mechanism_of(robot)
    rows, tool = mechanism.rows(robot), robot.tool
    if (targets := _targets(robot, np.full((1, 3), 0.5))) is not None:
        q, x, status = mechanism.inverse(targets, tool, rows)
        if status[0] == SOLVED:
            return _poses(robot, q, x, tool)
    q = np.zeros((1, mechanism.limbs))
    if robot.joint_limits is not None:
        q[0] = robot.joint_sign * robot.joint_limits.mean(axis=1)
    elif mechanism.joint_unit == "mm":
        q[:] = 0.2 * robot_size(robot)
    if mechanism.many_ways:
        q[0] = 0.35 * (-1.0) ** np.arange(mechanism.limbs) * _size(robot, 1.0, 0.2 * robot_size(robot))
    x, _ = mechanism.forward(q, tool, rows)
    return _poses(robot, q, x, tool)


def _size(robot: Robot, turn: float, slide: float) -> Array:
    """Return a size for each joint (n_q,), by whether it turns or slides."""
    return np.array([turn if unit == "rad" else slide for unit in mechanism_of(robot).joint_units])


def _targets(robot: Robot, u: Array) -> Array | None:
    """Return points (N, 3) of the workspace, or None; `u` (N, 3) fills the unit cube, 0.5 is the middle."""
    space = robot.workspace
    if space is None or mechanism_of(robot).many_ways:
        return None
    first, last = space.levels
    level = first + (last - first) * u[:, 2]
    if space.radius is None:
        across = (u[:, 0] - 0.5) * (space.width or 0.0)
        return np.column_stack([across, level, np.zeros(len(u))])
    # the middle of the cube is the cylinder's axis
    x, y = 2 * u[:, 0] - 1, 2 * u[:, 1] - 1
    to_disc = np.maximum(np.abs(x), np.abs(y)) / np.maximum(np.hypot(x, y), 1e-12)
    return np.column_stack([space.radius * x * to_disc, space.radius * y * to_disc, level])


def spread(robot: Robot, count: int = POSES) -> Poses:
    """Return poses without any symmetry that the machine can take."""
    mechanism, rng = mechanism_of(robot), np.random.default_rng(SEED)
    rows = mechanism.rows(robot)
    if (targets := _targets(robot, rng.random((count, 3)))) is not None:
        q, x, status = mechanism.inverse(turned(robot, targets), robot.tool, rows)
        good = status == SOLVED
        if good.sum() > count / 2:
            return _poses(robot, q[good], x[good], robot.tool)
    about = middle(robot).q
    size = _size(robot, SWING, SLIDE * robot_size(robot))
    q = about + rng.uniform(-size, size, (count, mechanism.limbs))
    x, status = mechanism.forward(q, robot.tool, rows)
    good = status == SOLVED
    return _poses(robot, q[good], x[good], robot.tool)


def trials(robot: Robot, count: int = POSES) -> Trials:
    """Return `spread` poses with all reference points, and those that touch fixed points."""
    poses = spread(robot, count)
    others = (at_tool(robot, poses, offset) for offset in OFFSETS[1:])
    contacts = any(look.touches for _, look in looks(mechanism_of(robot)))
    return Trials((poses, *others), tuple(touching(robot, poses)) if contacts else ())


def at_tool(robot: Robot, poses: Poses, offset: Sequence[float]) -> Poses:
    """Return the same joints with another reference point on the platform."""
    mechanism, tool = mechanism_of(robot), poses.tool + np.array(offset)
    if "z" not in mechanism.axes:
        tool = poses.tool + np.array([offset[0], offset[2], 0.0])
    x, _ = mechanism.forward(poses.q, tool, mechanism.rows(robot))
    return _poses(robot, poses.q, x, tool)


def touching(robot: Robot, poses: Poses) -> list[Poses]:
    """Return poses that bring several points of the platform, or one in several ways, to the same fixed points.

    A machine whose joints are its platform's freedoms touches a point in one way only: it brings another point there.
    """
    mechanism, rows = mechanism_of(robot), mechanism_of(robot).rows(robot)
    sockets, rng = poses.x[:SOCKETS, :3], np.random.default_rng(SEED + 4)
    several = mechanism.turning  # ways in which one point touches
    sets, reached = [], np.ones(len(sockets), dtype=bool)
    for n in range(STANDS if several else len(OFFSETS)):
        tool = poses.tool if several else at_tool(robot, poses, OFFSETS[n]).tool
        q = poses.q[:SOCKETS] + (rng.uniform(-SWING, SWING, (len(sockets), mechanism.limbs)) if several and n else 0.0)
        for _ in range(TOUCHES):
            x, _ = mechanism.forward(q, tool, rows)
            slope = mechanism.sensitivity(x, q, tool, rows).joints[:, :3]
            q = q + (np.linalg.pinv(np.nan_to_num(slope)) @ (sockets - x[:, :3])[..., None])[..., 0]
        x, status = mechanism.forward(q, tool, rows)
        reached &= (status == SOLVED) & (np.linalg.norm(x[:, :3] - sockets, axis=1) < TOUCHED)
        sets.append((q, x, tool))
    return [_poses(robot, q[reached], x[reached], tool) for q, x, tool in sets]


def moved(x: Array, to: Array) -> Array:
    """Return the shift and the turn in {O} (N, 6) that lead from poses to poses (N, 12)."""
    turn = to[:, 3:].reshape(-1, 3, 3) @ np.swapaxes(x[:, 3:].reshape(-1, 3, 3), 1, 2)
    return np.hstack([to[:, :3] - x[:, :3], to_vector(turn)])


TURNS = ("tilt", "twist", "turn")  # deflections that are angles
LEVER = 100.0  # mm: at which a turn counts as a shift


def orders(robot: Robot, poses: Poses) -> list[Order]:
    """Return the orders of the pose's derivatives by errors, joints and deflections along a random direction."""
    mechanism, rng = mechanism_of(robot), np.random.default_rng(SEED + 1)
    rows = mechanism.rows(robot)
    S = mechanism.sensitivity(poses.x, poses.q, poses.tool, rows)
    size = np.array([1.0, 1.0, 1.0, LEVER, LEVER, LEVER])

    errors = mechanism.typical * rng.standard_normal(len(mechanism.parameters))
    joints = _size(robot, 0.01, 1.0) * rng.standard_normal(mechanism.limbs)
    turned = np.array([name.startswith(TURNS) for name in mechanism.deflections], dtype=bool)
    bent = rng.standard_normal((1, mechanism.limbs, len(turned))) * np.where(turned, 1.0 / LEVER, 1.0)
    base = mechanism.vector(robot.errors)

    def gap(step: float, by: str) -> float:
        if by == "joints":
            x, _ = mechanism.forward(poses.q + step * joints, poses.tool, rows, near=poses.x)
            first = S.joints @ joints
        elif by == "deflections":
            changed = mechanism.rows(robot, base, step * bent)
            x, _ = mechanism.forward(poses.q, poses.tool, changed, near=poses.x)
            first = np.einsum("nxld,ld->nx", S.deflections, bent[0])
        else:
            changed = mechanism.rows(robot, base + step * errors)
            x, _ = mechanism.forward(poses.q, poses.tool, changed, near=poses.x)
            first = S.parameters @ errors
        left = (moved(poses.x, x) - step * first) * size
        return float(np.sqrt(np.nanmean(np.sum(left**2, axis=1))))

    steps: Array = 8.0 * 0.5 ** np.arange(HALVINGS, dtype=float)
    names = ["source errors", "joints", *(["deflections"] if mechanism.deflections else [])]
    return [Order(by, steps, np.array([gap(float(s), by) for s in steps])) for by in names]


def orders_of_readings(robot: Robot, kind: Kind) -> list[Order]:
    """Return the orders of a kind's derivatives by what it looks at, and by its own unknowns, in a random direction.

    An instrument whose unknowns were stepped reads what its derivatives say only if its state after the step is right.
    """
    rng, poses = np.random.default_rng(SEED + 5), spread(robot)
    x = poses.q if kind.sees_joints else poses.x
    found, at = kind.imagined(x, 1, mechanism_of(robot), _usual(robot, poses.x))
    if len(found) > MOST_READINGS:
        found = found.subset(rng.permutation(len(found))[:MOST_READINGS])
    typical = np.tile(kind.typical[list(at.free)], len(at.state))
    at = at.stepped(MOUNTED * typical * rng.uniform(-1.0, 1.0, len(typical)))
    step = rng.standard_normal((len(x), x.shape[1] if kind.sees_joints else 6))
    step[:, 3:] /= LEVER
    own = MOUNTED * typical * rng.standard_normal(len(typical))
    by_place, by_own = at.linearise(found, x, step[:, :, None])
    before, lever = at.predict(found, x), np.ones(by_place.shape[1])
    lever[list(kind.turned)] = LEVER

    def gap(size: float, by: str) -> float:
        if by == "unknowns":
            after, first = at.stepped(size * own).predict(found, x), by_own @ own
        else:
            there = x + size * step if kind.sees_joints else displaced(x, size * step)
            after, first = at.predict(found, there), by_place[:, :, 0]
        left = (_change(before, after, at.at_platform) - size * first) * lever
        return float(np.sqrt(np.nanmean(left**2)))

    steps: Array = 8.0 * 0.5 ** np.arange(HALVINGS, dtype=float)
    names = ["joints" if kind.sees_joints else "platform", *(["unknowns"] if len(own) else [])]
    return [Order(by, steps, np.array([gap(float(s), by) for s in steps])) for by in names]


def displaced(x: Array, by: Array) -> Array:
    """Return poses (N, 12) shifted and turned in {O} by (N, 6) [mm, rad]."""
    turned = from_vector(by[:, 3:]) @ x[:, 3:].reshape(-1, 3, 3)
    return np.hstack([x[:, :3] + by[:, :3], turned.reshape(-1, 9)])


def _change(before: tuple[Array, Array | None], after: tuple[Array, Array | None], scale: Array) -> Array:
    """Return how readings change (R, k): values as residuals count them, and the rotation between rotations."""
    gap = scale[: before[0].shape[1]] * (after[0] - before[0])
    if before[1] is None or after[1] is None:
        return gap
    return np.hstack([gap, to_vector(after[1] @ np.swapaxes(before[1], 1, 2))])


def linear_against_exact(robot: Robot, poses: Poses, names: Sequence[str]) -> tuple[Array, Array]:
    """Return how far ordinary errors of a model move each pose, and what first order leaves of it (N, 3) [mm]."""
    mechanism, rng = mechanism_of(robot), np.random.default_rng(SEED + 2)
    errors = np.zeros(len(mechanism.parameters))
    for name in names:
        j = mechanism.index[name]
        errors[j] = mechanism.typical[j] * rng.standard_normal()
    rows = mechanism.rows(robot, mechanism.vector(robot.errors) + errors)
    x, _ = mechanism.forward(poses.q, poses.tool, rows, near=poses.x)
    exact = x[:, :3] - poses.x[:, :3]
    return exact, exact - poses.by_errors[:, :3] @ errors


# ------------------------------------------------------------------------------------------------------------- ranks


def identification(
    robot: Robot,
    sets: Sequence[Poses],
    names: Sequence[str],
    kind: Kind,
    frame: str = "unknown",
    said: Mapping[str, Any] | None = None,
) -> Array:
    """Return the rows by which a kind of measurement sees parameters at poses, its own unknowns projected out.

    What a sidecar may have `said` else takes the place of a known camera and a print of known
    scale. Angles of a pose count at 100 mm.
    """
    mechanism = mechanism_of(robot)
    x = np.vstack([s.x for s in sets])
    S = np.vstack([s.by_errors for s in sets])[:, :, [mechanism.index[n] for n in names]]
    usual = dataclasses.replace(_usual(robot, x), frame=frame, **(said or {}))
    found, instrument = kind.imagined(x, len(sets), mechanism, usual)
    each = len(found) // len(sets)
    if each > MOST_READINGS:
        few = np.random.default_rng(SEED + 3).permutation(each)[:MOST_READINGS]
        found = found.subset(np.concatenate([few + k * each for k in range(len(sets))]))
    J, nuisance = instrument.linearise(found, x, S)
    instrument.add_carried(J, mechanism, names, found, x)
    turned = list(kind.turned)
    J[:, turned], nuisance[:, turned] = LEVER * J[:, turned], LEVER * nuisance[:, turned]
    J, nuisance = J.reshape(-1, J.shape[2]), nuisance.reshape(J.shape[0] * J.shape[1], -1)
    if nuisance.shape[1]:
        U, s, _ = np.linalg.svd(nuisance, full_matrices=False)
        Q = U[:, s > 1e-10 * s[0]]
        J = J - Q @ (Q.T @ J)
    return np.asarray(J)


def _usual(robot: Robot, x: Array) -> Measurement:
    """Return what an ordinary sidecar would say, at poses (N, 12)."""
    return Measurement(frame="unknown", camera=CAMERA, base_point_mm=tuple(_base_point(robot, x).tolist()))


def _base_point(robot: Robot, x: Array) -> Array:
    """Return a point beside the workspace to which a gauge may be fixed [mm]."""
    span = np.ptp(x[:, :3], axis=0)
    point: Array = x[:, :3].mean(axis=0) + np.array([0.9, 0.4, 0.0]) * span.max()
    return point if "z" in mechanism_of(robot).axes else point * [1.0, 1.0, 0.0]


def looks(mechanism: Machine) -> list[tuple[Kind, Look]]:
    """Return the readings that are looked at, kind by kind."""
    every = map(kind_of, kind_names())
    return [(kind, look) for kind in every for look in kind.looks(mechanism, len(OFFSETS), STANDS)]


def ranks(robot: Robot, at: Trials, names: Sequence[str]) -> list[Rank]:
    """Return rank and null space of a model by each kind of measurement."""
    mechanism = mechanism_of(robot)
    typical = mechanism.typical[[mechanism.index[n] for n in names]]
    units = [mechanism.parameters[mechanism.index[n]].unit for n in names]
    out = []
    for kind, look in looks(mechanism):
        sets = at.touched if look.touches else at.sets[: look.points]
        H = identification(robot, sets, list(names), kind, look.frame)
        s = np.linalg.svd(np.linalg.qr(H * typical, mode="r"), compute_uv=False)
        top = s[0] if len(s) and s[0] > 0 else 1.0
        rank = int((s > RANK_TOLERANCE * top).sum())
        out.append(
            Rank(
                look.words,
                look.points,
                rank,
                len(names),
                float(s[rank - 1] / top) if rank else 0.0,
                float(s[rank] / top) if rank < len(s) else 0.0,
                tuple(unseen(H, names, units, typical)),
                look.motions,
            )
        )
    return out


def condition_by_count(robot: Robot, at: Trials, names: Sequence[str]) -> tuple[list[int], Array, int]:
    """Return numbers of poses, the condition number of what can be seen at each, and its rank.

    Positions of three reference points in an unknown frame, nested random sets, columns in ordinary errors; infinite
    while a set sees less than all of it.
    """
    mechanism = mechanism_of(robot)
    typical = mechanism.typical[[mechanism.index[n] for n in names]]

    def values(count: int) -> Array:
        some = [s.first(count) for s in at.sets]
        s = np.linalg.svd(identification(robot, some, list(names), kind_of("position")) * typical, compute_uv=False)
        return np.asarray(s)

    whole = values(len(at.poses.x))
    rank = int((whole > RANK_TOLERANCE * whole[0]).sum())
    counts = [n for n in (3, 4, 5, 6, 7, 8, 10, 12, 15, 20, 25, 30, 40, 60, 80, 120) if n <= len(at.poses.x)]
    conditions = []
    for n in counts:
        s = values(n)
        seen = len(s) >= rank and s[rank - 1] > RANK_TOLERANCE * s[0]
        conditions.append(s[0] / s[rank - 1] if seen else np.inf)
    return counts, np.array(conditions), rank
