"""An open chain that computes: links of the generated kernels, one behind the other as the robot file lists them.

Beside machines of limbs (`deltacal_gen.machine.limbs`): a limb is a link here, and its joint is the link's. Forward
position is explicit, so there is nothing to solve and no pose is out of reach.
"""

from __future__ import annotations

import importlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from types import ModuleType

import numpy as np

from deltacal_gen.errors import UsageError
from deltacal_gen.machine.machine import (
    COORDINATES,
    POSE,
    SOLVED,
    UNREACHABLE,
    GeometryKey,
    Loads,
    Machine,
    Parameter,
    Reach,
    Sensitivity,
    filled,
    result,
)
from deltacal_gen.machine.rotation import Array
from deltacal_gen.machine.values import Link, Robot

PARALLEL = 1e-6  # rad: axes that are closer to parallel have no common normal to speak of
TOOL = ("tx", "ty", "tz")
RANK = 1e-6  # of the largest: a smaller singular value of the joints' Jacobian is a direction that is not commanded
MOST_LEVER = 50.0  # joints turn at most so many times as far as the last frame: a wrist near its singularity stays
FARTHEST = 0.3  # rad: a step of a joint; a slide's is that much of the chain's reach
NEWTON_STEPS = 40
THERE_TURNED = 1e-6  # rad: of ways to stand, those that miss the rotation by more than the best one are none
THERE_MM, THERE = 1e-9, 1e-11  # a pose is met; joints (rad, and part of the reach) no longer move
STARTS = 16  # joints from which a pose is sought where nothing says how the chain stands


@dataclass(frozen=True)
class _Placed:
    """Links in the base frame: rotation (3, 3, N) and origin (3, N) of each, and rotation of the frame before it.

    Poses stand last, as NumPy runs fastest over them. `local` holds the twists (n_e + 2, 2, 3, N) of each link, its
    origin's shift and its turn, in the frame before.
    """

    q: Array
    rows: Array
    before: list[Array]
    rotation: list[Array]
    origin: list[Array]
    local: list[Array]

    def twists(self, k: int, chosen: slice) -> Array:
        """Return twists (n, 2, 3, N) of link k along the base's axes."""
        return _turned(self.before[k], self.local[k][chosen])


class Chain(Machine):
    """The links of one robot.

    Parameters
    ----------
    tables : module
        Generated tables of a link.
    links : tuple of Link
        As the robot file lists them, from the base.
    """

    sort = "an open chain"
    layers = (1, -1)  # a workspace stands on the base plane
    platform = asks = COORDINATES
    axes = turns = ("x", "y", "z")
    deflections = ()
    many_ways = linked = weighs = True
    looped = written_out = False

    def __init__(self, tables: ModuleType, links: tuple[Link, ...]) -> None:
        self._tables, self.links = tables, links
        self._kernels_of_a_link = importlib.import_module(f"deltacal_kernels.{tables.NAME}.links")
        self.name, self.title, self.reference = tables.NAME, tables.TITLE, tables.REFERENCE
        self.machine = self.name
        self._moving = [k for k, link in enumerate(links) if link.kind in ("revolute", "prismatic")]
        self.limbs = len(self._moving)
        self._last: _Placed | None = None
        units = ["mm" if links[k].kind == "prismatic" else "rad" for k in self._moving]
        self.joint_unit = ",".join(units) if len(set(units)) > 1 else units[0] if units else "rad"
        self.widths = (3, POSE) if self.limbs <= 3 else (POSE,)
        self.geometry = tuple(
            GeometryKey(key, unit, meaning, True, None, "joint", False, None) for key, unit, meaning in tables.GEOMETRY
        )
        self.errors = tuple(name for name, *_ in tables.ERRORS)
        self.common = TOOL
        own = tuple(
            Parameter(f"{name}_{k + 1}", unit, f"joint {k + 1}: {meaning}", k + 1, typical, name)
            for k in range(len(links))
            for name, unit, meaning, typical in tables.ERRORS
        )
        self.parameters = (
            *own,
            *(Parameter(t, "mm", f"tool point, {t[1]} of the last frame", 0, 1.0, t) for t in TOOL),
        )
        free = [p.name for p in own if not p.name.startswith("beta_") or self._parallel(p.limb - 1)]
        self.models = {f"{self.name}/dh": (*free, *TOOL)}

    def compile(self) -> Iterator[tuple[str, float]]:
        """Compile nothing: the kernels of a link are NumPy."""
        return iter(())

    def same_as(self, robot: Robot, key: str) -> tuple[str, ...]:
        """Return the errors, link by link, that a dimension of the links is part of."""
        return tuple(f"{key}_{k + 1}" for k in range(len(self.links)))

    def _parallel(self, k: int) -> bool:
        """Whether link k joins two nominally parallel axes, the second of which moves."""
        after = [j for j in self._moving if j > k]
        return abs(np.sin(self.links[k].alpha)) < PARALLEL and bool(after)

    @property
    def _width(self) -> int:
        return len(self.geometry) + len(self.errors) + len(self.common)

    def scaling(self, convention: str, robot: Robot, names: object) -> Array:
        """Raise UsageError: no paper gives the columns of a chain another scale."""
        raise UsageError(f"{self.name} has no scaling '{convention}'; leave it out.")

    def rows(self, robot: Robot, errors: Array | None = None, deflections: Array | None = None) -> Array:
        """Return the links' rows of parameters, (M, links, n): geometry, source errors, errors of the tool."""
        if deflections is not None:
            raise ValueError("a chain has no deflections of limbs.")
        values = self.every(self.vector(robot.errors) if errors is None else errors)
        n_g, n_e, n = len(self.geometry), len(self.errors), len(self.links)
        out = np.zeros((len(values), n, self._width))
        for j, entry in enumerate(self.geometry):
            out[:, :, j] = robot.geometry[entry.key]
        out[:, :, n_g : n_g + n_e] = values[:, : n * n_e].reshape(-1, n, n_e)
        out[:, :, n_g + n_e :] = values[:, None, n * n_e :]
        return out

    def roles(self, robot: Robot) -> dict[str, Array]:
        """Return no lengths: the parts of a Delta's limb do not exist here."""
        return {}

    def moves(self, robot: Robot) -> dict[str, dict[str, Array]]:
        """Return no parts: effects act on the joints."""
        return {}

    def limb_inertia(self, robot: Robot, masses: Mapping[str, float]) -> Array:
        """Return zero: the file gives masses and their centres only."""
        return np.zeros(())

    # -------------------------------------------------------------------------------------------------- kinematics

    def _variables(self, q: Array) -> Array:
        """Return each link's variable (links, 2, N): its turn and its slide."""
        out = np.zeros((len(self.links), 2, len(q)))
        by_number = {k + 1: q[:, j] for j, k in enumerate(self._moving)}
        for k, link in enumerate(self.links):
            value = by_number.get(k + 1, np.zeros(len(q)))
            if link.kind == "coupled":
                value = np.asarray(sum(much * by_number[number] for number, much in link.coupling))
            out[k, int(link.kind == "prismatic")] = value
        return out

    def _placed(self, q: Array, rows: Array) -> _Placed:
        last = self._last  # forward, derivatives and loads of one state come one after the other
        if last is not None and np.array_equal(last.q, q) and np.array_equal(last.rows, rows):
            return last
        variables, placed = self._variables(q), _Placed(q.copy(), rows.copy(), [], [], [], [])
        R, p = np.broadcast_to(np.eye(3)[:, :, None], (3, 3, len(q))), np.zeros((3, len(q)))
        for k, link in enumerate(self.links):
            turn, shift, local = self._kernels_of_a_link.link(link.convention, variables[k], rows[:, k].T)
            placed.before.append(R)
            p = p + _turned(R, shift)
            R = sum(R[:, j, None] * turn[j] for j in range(3))
            placed.local.append(local)
            placed.rotation.append(R)
            placed.origin.append(p)
        self._last = placed
        return placed

    def frames(self, q: Array, rows: Array) -> tuple[Array, Array]:
        """Return the frames of the base and of every link: origins (N, n + 1, 3) and rotations (N, n + 1, 3, 3)."""
        placed = self._placed(self._poses(q, self.limbs, "joints"), rows)
        origins = np.stack([np.zeros((3, len(q))), *placed.origin])
        rotations = np.stack([np.broadcast_to(np.eye(3)[:, :, None], (3, 3, len(q))), *placed.rotation])
        return np.moveaxis(origins, -1, 0), np.moveaxis(rotations, -1, 0)

    def forward(
        self, q: Array, tool: Array, rows: Array, near: Array | None = None, *, out: Array | None = None
    ) -> tuple[Array, np.ndarray]:
        """Return the pose (N, 12) of the tool point and the last frame; every pose is SOLVED."""
        q, tool = self._poses(q, self.limbs, "joints"), self._tool(tool, len(q))
        if len(rows) not in (1, len(q)):
            rows = np.repeat(rows, len(q) // len(rows), axis=0)
        placed, x = self._placed(q, rows), result(out, (len(q), POSE))
        R = placed.rotation[-1]
        x[:, :3] = (placed.origin[-1] + _turned(R, (tool + rows[:, 0, -3:]).T)).T
        x[:, 3:] = R.reshape(9, -1).T
        return x, np.full(len(q), SOLVED)

    def positions(self, q: Array, tool: Array, rows: Array, *, out: Array | None = None) -> Array:
        """Return the positions (N, 3) of the tool point [mm]."""
        x = result(out, (len(q), 3))
        x[:] = self.forward(q, tool, rows)[0][:, :3]
        return x

    def stated(self, target: Array) -> Array:
        """Return targets as they are: no kernel takes one alone."""
        return target

    def asked(self, motion: Array) -> Array:
        """Return motions as they are: which directions the joints command depends on the pose."""
        return motion

    def inverse(
        self, target: Array, tool: Array, rows: Array, limits: Array | None = None, *, out: Array | None = None
    ) -> tuple[Array, Array, np.ndarray]:
        """Return joints that bring the tool point and the last frame to poses (N, 12), or three joints to positions.

        Of the many ways in which a chain can stand, the first pose takes the one nearest to joints zero, every other
        the one nearest to the pose before it; within the joints' `limits` (n_q, 2) where there is one.

        Raises
        ------
        UsageError
            A position alone, of a chain of more than three joints: it does not say how the chain shall stand.
        """
        target, tool = self.targets(target), self._tool(tool, len(target))
        roots = np.modf(np.outer(np.arange(STARTS), np.sqrt([2, 3, 5, 7, 11, 13, 17, 19, 23, 29][: self.limbs])))[0]
        low, high = (-np.pi, np.pi) if limits is None else np.clip(limits.T / self._sizes(rows), -np.pi, np.pi)
        starts = (low + (high - low) * roots) * self._sizes(rows)
        starts[0] = np.clip(0.0, low, high) * self._sizes(rows)
        every = np.tile(starts, (len(target), 1))
        repeated = np.repeat(target, STARTS, axis=0), np.repeat(tool, STARTS, axis=0)
        q, status = self.follow(repeated[0], every, repeated[1], rows)
        reached, _ = self.forward(np.nan_to_num(q), repeated[1], rows)
        turned = np.abs(self.missed(reached, repeated[0])[:, 3:]).max(axis=1, initial=0.0).reshape(-1, STARTS)
        q, status = q.reshape(len(target), STARTS, -1), status.reshape(len(target), STARTS)
        best_turn = np.where(status == SOLVED, turned, np.inf).min(axis=1, keepdims=True)
        status[turned > best_turn + THERE_TURNED] = UNREACHABLE  # a wrist that got stuck
        turning = np.array([self.links[k].kind == "revolute" for k in self._moving])
        found = result(out, (len(target), self.limbs))
        found[:] = np.nan
        last = starts[0]
        for n, (ways, ok) in enumerate(zip(q, status == SOLVED, strict=True)):
            near = np.where(turning, last + (ways - last + np.pi) % (2 * np.pi) - np.pi, ways)
            if limits is not None:
                for once in (2 * np.pi, -2 * np.pi):
                    inside = turning & (near + once >= limits[:, 0]) & (near + once <= limits[:, 1])
                    near = np.where(inside & ((near < limits[:, 0]) | (near > limits[:, 1])), near + once, near)
            far = np.abs((near - last) / self._sizes(rows)).max(axis=1)
            beyond = 0.0 if limits is None else ((near < limits[:, 0]) | (near > limits[:, 1])).any(axis=1)
            best = int(np.argmin(np.where(ok, far + 100.0 * beyond, np.inf)))
            if ok[best]:
                found[n] = last = near[best]
        solved = np.asarray(np.isfinite(found).all(axis=1))
        x, _ = self.forward(np.nan_to_num(found), tool, rows)
        return found, np.where(solved[:, None], x, np.nan), np.where(solved, SOLVED, UNREACHABLE)

    def follow(
        self,
        target: Array,
        near: Array | None,
        tool: Array,
        rows: Array,
        drawn: Array | None = None,
        reach: Reach | None = None,
        *,
        out: Array | None = None,
    ) -> tuple[Array, np.ndarray]:
        """Return joints (N, n_q) that bring a machine to poses (N, 12) or positions (N, 3), starting from `near`.

        The position comes first; the joints that are left over turn the last frame as far as they can. Where a chain
        commands fewer directions than the target has, the others stay as they come, and near a singularity of the
        wrist the last frame is left as it is rather than turned by joints that move `MOST_LEVER` times as far.

        Parameters
        ----------
        rows, drawn : (1, links, n) arrays
            Of the machine and, where that is another one, of the chain as drawn: what an error alone would let the
            joints move (out of the plane of a planar arm, say) is not commanded.
        reach : callable, optional
            Poses (N, 12) and status (N,) of a machine with effects at joints of some of the targets, given with their
            indices.

        Notes
        -----
        Newton's method with the Jacobian of the machine without effects. Two levels of priority by the projection of
        the second into the null space of the first (Siciliano, Slotine 1991).
        """
        if near is None:
            near, _, _ = self.inverse(target, tool, rows)
        q, status = np.array(near, dtype=float), np.full(len(target), UNREACHABLE)
        sizes, directions = self._sizes(rows), self._directions(rows if drawn is None else drawn)
        open_ = np.arange(len(q))
        for _ in range(NEWTON_STEPS):
            if not len(open_):
                break
            x, reached = self.forward(q[open_], tool[open_], rows)
            slope = self.sensitivity(x, q[open_], tool[open_], rows).joints * sizes
            if reach is not None:
                x, reached = reach(q[open_], open_)
            miss = -self.missed(x, target[open_])
            if directions < 3 and drawn is not None:
                own, _ = self.forward(q[open_], tool[open_], drawn)
                commanded = self.sensitivity(own, q[open_], tool[open_], drawn).joints[:, :3] * sizes
                basis = np.linalg.svd(commanded)[0][:, :, :directions]
                within = basis @ np.swapaxes(basis, 1, 2)
                slope[:, :3], miss[:, :3] = within @ slope[:, :3], np.einsum("nij,nj->ni", within, miss[:, :3])
            step, off, rank = _prioritised(slope, miss, directions)
            ended = (np.abs(off).max(axis=1) < THERE_MM) & (np.abs(step).max(axis=1) < THERE)
            # on the rim of its reach a chain has lost a direction, and what is missing lies along it
            ended &= (rank == directions) | (np.abs(miss[:, :3]).max(axis=1) < THERE_MM)
            wrong = reached != SOLVED
            status[open_[wrong]] = reached[wrong]
            status[open_[ended & ~wrong]] = SOLVED
            going = ~(ended | wrong)
            longest = np.abs(step[going]).max(axis=1, initial=FARTHEST)[:, None]
            open_ = open_[going]
            q[open_] += sizes * step[going] * (FARTHEST / longest)
        return filled(out, np.where((status == SOLVED)[:, None], q, np.nan)), status

    def undo(self, moved: Array, x: Array, q: Array, tool: Array, rows: Array, *, out: Array | None = None) -> Array:
        """Return the change of the joints (N, n_q) that undoes a small displacement `moved` of the pose.

        A shift (N, 3) is undone without turning the last frame, as far as the joints can; see `follow`.
        """
        sizes = self._sizes(rows)
        whole = np.hstack([moved, np.zeros((len(moved), 6 - moved.shape[1]))])
        slope = self.sensitivity(x, q, tool, rows).joints * sizes
        return filled(out, -sizes * _prioritised(slope, whole, self._directions(rows))[0])

    def _sizes(self, rows: Array) -> Array:
        """Return what a step of each joint is compared with, (n_q,): 1 rad, and of a slide the chain's reach [mm]."""
        lengths = [j for j, key in enumerate(self.geometry) if key.unit == "mm"]
        reach = float(np.abs(rows[0][:, lengths]).sum()) or 1000.0
        return np.array([reach if self.links[k].kind == "prismatic" else 1.0 for k in self._moving])

    def _directions(self, rows: Array) -> int:
        """Return in how many directions the joints move the tool point, at joints without any symmetry."""
        q = self._sizes(rows)[None] * np.modf(np.sqrt([2, 3, 5, 7, 11, 13, 17, 19, 23, 29][: self.limbs]))[0]
        tool = np.array([[50.0, 70.0, 110.0]])
        x, _ = self.forward(q, tool, rows)
        slope = self.sensitivity(x, q, tool, rows).joints[0, :3] * self._sizes(rows)
        return int(np.linalg.matrix_rank(slope, RANK * np.abs(slope).max()))

    def jacobians(
        self, x: Array, q: Array, tool: Array, rows: Array, *, out: Sequence[Array] | None = None
    ) -> tuple[Array, Array, Array, Array]:
        """Raise UsageError: a chain's closure is its forward position; see `sensitivity`."""
        raise UsageError("an open chain has no loops to close; its derivatives are those of `sensitivity`.")

    def sensitivity(
        self, x: Array, q: Array, tool: Array, rows: Array, *, out: tuple[Array, Array] | None = None
    ) -> Sensitivity:
        """Return the derivatives of the exact pose at N poses: each twist moves all that comes behind its link.

        `out` holds (6, links, n_e, N) by the links' errors, poses last, and (N, 6, n_q) by the joints.
        """
        x, q = self._poses(x, POSE, "poses"), self._poses(q, self.limbs, "joints")
        placed, n_e, point = self._placed(q, rows), len(self.errors), x[:, :3].T
        own_out, joints_out = (None, None) if out is None else out
        own = result(own_out, (6, len(self.links), n_e, len(q)))
        joints = np.zeros((6, self.limbs, len(q)))
        for k, link in enumerate(self.links):
            twists = placed.twists(k, slice(None))
            turns = twists[:, 1]
            shifts = twists[:, 0] + _cross(turns, point - placed.origin[k])
            own[:3, k], own[3:, k] = (np.swapaxes(moved[:n_e], 0, 1) for moved in (shifts, turns))
            c = n_e + int(link.kind == "prismatic")
            for j, much in self._drives(k):
                joints[:3, j] += much * shifts[c]
                joints[3:, j] += much * turns[c]
        common = np.zeros((6, len(self.links), 3, len(q)))
        common[:3, 0] = placed.rotation[-1]
        none = np.zeros((len(q), 6, self.limbs, 0))
        by_joints = result(joints_out, (len(q), 6, self.limbs))
        by_joints[:] = np.moveaxis(joints, -1, 0)
        return Sensitivity(np.moveaxis(own, -1, 0), np.moveaxis(common, -1, 0), none, by_joints)

    def _drives(self, k: int) -> list[tuple[int, float]]:
        """Return which joints move link k, and by how much each."""
        if k in self._moving:
            return [(self._moving.index(k), 1.0)]
        return [(self._moving.index(number - 1), much) for number, much in self.links[k].coupling]

    # ------------------------------------------------------------------------------------------------------- loads

    def loads(
        self,
        x: Array,
        q: Array,
        tool: Array,
        rows: Array,
        masses: Mapping[str, float],
        fields: Array,
        payload: Array | float = 0.0,
        *,
        out: Sequence[Array] | None = None,
    ) -> Loads:
        """Return what the links' weights and the payload exert on the joints, by virtual work.

        `masses` is read for whether there are any: an empty mapping asks for the payload alone.
        """
        q, point = self._poses(q, self.limbs, "joints"), x[:, :3].T
        placed, n_e = self._placed(q, rows), len(self.errors)
        every = np.asarray(fields, dtype=float).reshape(len(q) if np.ndim(fields) == 3 else 1, -1, 3).transpose(1, 2, 0)
        # of a link and all behind it, the payload last: force, and moment about {O}
        F = np.broadcast_to(np.asarray(payload, dtype=float), len(q)) * every[-1]
        M, torque = _cross(point, F), np.zeros((self.limbs, len(q)))
        for k, link in reversed(list(enumerate(self.links))):
            if masses and link.mass:
                weight = link.mass * every[k if len(every) > 1 else 0]
                F, M = F + weight, M + _cross(self._centre(placed, k), weight)
            driven, c = self._drives(k), n_e + int(link.kind == "prismatic")
            if not driven:
                continue
            shift, turn = placed.twists(k, slice(c, c + 1))[0]
            work = (shift * F).sum(axis=0) + (turn * (M - _cross(placed.origin[k], F))).sum(axis=0)
            for j, much in driven:
                torque[j] += much * work
        none = np.zeros((len(q), self.limbs, 1))
        return Loads.written(out, np.ascontiguousarray(torque.T), none[:, :, :0], none, np.ascontiguousarray(M.T))

    def weights_at(
        self, x: Array, q: Array, tool: Array, rows: Array, masses: Mapping[str, float], *, out: Array | None = None
    ) -> Array:
        """Return where the weights are, (N, links + 1, 3) [mm]: each link's centre of mass, and the payload."""
        placed = self._placed(self._poses(q, self.limbs, "joints"), rows)
        centres = (self._centre(placed, k).T for k in range(len(self.links)))
        return filled(out, np.stack([*centres, x[:, :3]], axis=1))

    def _centre(self, placed: _Placed, k: int) -> Array:
        """Return where link k has its centre of mass, (3, N) [mm]."""
        return placed.origin[k] + _turned(placed.rotation[k], np.array(self.links[k].com)[:, None])


def _prioritised(slope: Array, miss: Array, directions: int) -> tuple[Array, Array, np.ndarray]:
    """Return steps (N, n), what of the missing shift the joints command (N, 3), and in how many directions (N,)."""
    U, s, Vt = np.linalg.svd(slope[:, :3])
    held = (s > RANK * s[:, :1]) & (np.arange(s.shape[1]) < directions)
    k, V = s.shape[1], np.swapaxes(Vt, 1, 2)
    along = np.einsum("nij,ni->nj", U[:, :, :k], miss[:, :3]) * held
    step = np.einsum("nij,nj->ni", V[:, :, :k], along / np.where(held, s, 1.0))
    if miss.shape[1] > 3:
        used = np.concatenate([held, np.zeros((len(s), V.shape[2] - k), dtype=bool)], axis=1)
        left = V * ~used[:, None]
        turned = slope[:, 3:] @ left
        U2, s2, V2 = np.linalg.svd(turned, full_matrices=False)
        held2 = s2 > 1.0 / MOST_LEVER
        rest = miss[:, 3:] - np.einsum("nij,nj->ni", slope[:, 3:], step)
        part = np.einsum("nij,ni->nj", U2, rest) * held2 / np.where(held2, s2, 1.0)
        step = step + np.einsum("nij,nj->ni", left, np.einsum("nji,nj->ni", V2, part))
    off = np.einsum("nij,nj->ni", U[:, :, :k], along)
    return step, off, held.sum(axis=1)


def _turned(rotation: Array, vectors: Array) -> Array:
    """Return vectors (..., 3, N) turned by rotations (3, 3, N)."""
    parts = (rotation[:, j] * vectors[..., j, None, :] for j in range(3))
    out: Array = sum(parts, start=next(parts))
    return out


def _cross(a: Array, b: Array) -> Array:
    """Return the vector products of vectors (..., 3, N) and (3, N) or (3, 1)."""
    out = np.empty(np.broadcast_shapes(a.shape, b.shape))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        out[..., i, :] = a[..., j, :] * b[k] - a[..., k, :] * b[j]
    return out
