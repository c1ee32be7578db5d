"""An open chain that computes: what the generated kernels read of the links, as the robot file lists them.

Beside machines of limbs (`deltacal_gen.machine.limbs`): a limb is a link here, and its joint is the link's. Forward
position is explicit, so there is nothing to solve and no pose is out of reach.
"""

from __future__ import annotations

import importlib
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cached_property, partial
from types import ModuleType
from typing import Any

import numpy as np

from deltacal_gen.errors import NotForThisMachine, OptionNotApplicable
from deltacal_gen.machine.answers import Reach, Sensitivity, Weights, filled, result
from deltacal_gen.machine.flexible import DEFLECTIONS, NO_LINE, Flexible
from deltacal_gen.machine.machine import COORDINATES, POSE, SOLVED, UNREACHABLE, GeometryKey, Machine, Parameter
from deltacal_gen.machine.rotation import Array
from deltacal_gen.machine.values import Link, Robot

HAYATI = "beta"  # the error that turns an axis parallel to the one before out of their plane
PARALLEL = 1e-6  # rad: axes that are closer to parallel have no common normal to speak of
RANK = 1e-6  # of the largest: a smaller singular value of the joints' Jacobian is a direction that is not commanded
MOST_LEVER = 50.0  # joints turn at most so many times as far as the last frame: a wrist near its singularity stays
FARTHEST = 0.3  # rad: a step of a joint; a slide's is that much of the chain's reach
NEWTON_STEPS = 40
THERE_TURNED = 1e-6  # rad: of ways to stand, those that miss the rotation by more than the best one are none
THERE_MM, THERE = 1e-9, 1e-11  # a pose is met; joints (rad, and part of the reach) no longer move
STARTS = 16  # joints from which a pose is sought where nothing says how the chain stands


class Chain(Machine):
    """The links of one robot.

    Parameters
    ----------
    tables : module
        Generated tables of a link.
    links : tuple of Link
        As the robot file lists them, from the base.
    """

    sort, part = "an open chain", "joint"
    layers = (1, -1)  # a workspace stands on the base plane
    platform = asks = COORDINATES
    axes = turns = ("x", "y", "z")
    deflections = DEFLECTIONS
    many_ways = linked = weighs = True
    looped = written_out = False
    weighed_by = (
        "masses: mass and com of the [[joint]] tables in the robot file; where none is known, an empty table [masses] "
        "there and payload_kg in the recording, for what the payload does"
    )

    def __init__(self, tables: ModuleType, links: tuple[Link, ...]) -> None:
        self._tables, self.links = tables, links
        self.name, self.title, self.reference = tables.NAME, tables.TITLE, tables.REFERENCE
        self.machine = self.name
        self._moving = [k for k, link in enumerate(links) if link.kind in ("revolute", "prismatic")]
        self.limbs = len(self._moving)
        self.shape = self._described()
        self._laid: dict[tuple[int, ...], tuple[Flexible, Chain]] = {}
        self._bent: tuple[Array, dict[tuple[int, ...], Array]] = np.empty(0), {}  # rows, and those of chains that bend
        self._made: tuple[Array, ModuleType, Array] | None = None  # rows, kernels and what no joint changes
        self._drawn: tuple[Array, Array] | None = None  # dimensions as drawn, and the links' lines that they make
        units = ["mm" if links[k].kind == "prismatic" else "rad" for k in self._moving]
        self.joint_unit = ",".join(units) if len(set(units)) > 1 else units[0] if units else "rad"
        self.widths = (3, POSE) if self.limbs <= 3 else (POSE,)
        self.geometry = tuple(
            GeometryKey(key, unit, meaning, True, None, "joint", False, None) for key, unit, meaning in tables.GEOMETRY
        )
        self.errors = tuple(name for name, *_ in tables.ERRORS)
        self.common = tuple(name for name, *_ in tables.COMMON)
        own = tuple(
            Parameter(f"{name}_{k + 1}", unit, f"joint {k + 1}: {meaning}", k + 1, typical, name)
            for k in range(len(links))
            for name, unit, meaning, typical in tables.ERRORS
        )
        shared = (Parameter(name, unit, meaning, 0, typical, name) for name, unit, meaning, typical in tables.COMMON)
        self.parameters = (*own, *shared)
        free = [p.name for p in own if p.error != HAYATI or self._parallel(p.limb - 1)]
        self.models = {f"{self.name}/dh": (*free, *self.common)}

    def _described(self) -> tuple[np.ndarray, np.ndarray, Array]:
        """Return what tells this chain from others as the kernels read it; see ``kinematics.py`` of the kernels."""
        conventions = [self._tables.CONVENTIONS.index(link.convention) for link in self.links]
        drives, much = [], []
        for k, link in enumerate(self.links):
            own = [(k + 1, 1.0)] if k in self._moving else link.coupling
            drives += [(k, int(link.kind == "prismatic"), self._moving.index(number - 1)) for number, _ in own]
            much += [by for _, by in own]
        integers = np.array(conventions, dtype=np.int64), np.array(drives, dtype=np.int64).reshape(-1, 3)
        return *integers, np.array(much, dtype=float)

    def compile(self) -> Iterator[tuple[str, float]]:
        """Compile all kernels, or load them from Numba's cache; yield each one's name and how long it took [s].

        They are the same for all chains.
        """
        shape = np.zeros(1, dtype=np.int64), np.zeros((1, 3), dtype=np.int64), np.ones(1)
        rows, n_e, n_p = np.ones((1, 1, self.width)), len(self.errors), len(self.errors) + len(self.common)
        k, q, x, points = self.vectorised.constants(rows), np.ones((1, 1)), np.ones((1, POSE)), np.ones((1, 3, 1))
        S, V, along = np.empty((1, self.n_x, n_p)), np.empty((1, self.n_x, 1)), np.empty((1, 1, n_e))
        given: dict[str, tuple[Any, ...]] = {
            "constants": (rows,),
            "forward": (q, np.ones((1, 3)), k, *shape, x),
            "sensitivity": (x, q, k, *shape, S, V),
            "centres": (q, k, *shape, points),
            "loads": (q, k, *shape, points, points, shape[0], q, along, np.empty((1, 3))),
        }
        dynamics = importlib.import_module("deltacal_kernels.serial.dynamics")
        motion, weight, k = np.ones((3, 1, 1)), np.ones(3), dynamics.constants(rows)
        given["torque"] = motion, np.ones((1, len(dynamics.INERTIA))), weight, k, *shape, np.empty((1, 1))
        given["regressor"] = motion, weight, k, *shape, np.empty((1, 1, len(dynamics.INERTIA)))
        given["constants_by"] = rows, rows
        given["torque_by"] = (*given["torque"][:4], k, *shape, np.empty((1, 1, 1)))
        for name, arguments in given.items():
            start = time.perf_counter()
            getattr(self.compiled if hasattr(self.compiled, name) else dynamics, name)(*arguments)
            yield f"{self.name}.{name}", time.perf_counter() - start

    def same_as(self, robot: Robot, key: str) -> tuple[str, ...]:
        """Return the errors, link by link, that a dimension of the links is part of."""
        return tuple(f"{key}_{k + 1}" for k in range(len(self.links)))

    def _parallel(self, k: int) -> bool:
        """Whether link k joins two nominally parallel axes, the second of which moves."""
        after = [j for j in self._moving if j > k]
        return abs(np.sin(self.links[k].alpha)) < PARALLEL and bool(after)

    @property
    def width(self) -> int:
        """How many numbers of a link's row the kernels read: geometry, errors, those of the tool."""
        return len(self.geometry) + len(self.errors) + len(self.common)

    def _flexible(self, joints: tuple[int, ...]) -> tuple[Flexible, Chain]:
        """Return where this chain's tables stand among those that joints (from 0) give way by, and the chain of all."""
        if joints not in self._laid:
            laid = Flexible(self.links, self._moving, joints)
            self._laid[joints] = laid, Chain(self._tables, laid.links)
        return self._laid[joints]

    def _lines(self, rows: Array) -> Array:
        """Return the line of each joint's link (joints, 3), in the frame in which its joint has turned or slid [mm]."""
        drawn = rows[0, :, : len(self.geometry)]
        if self._drawn is None or not np.array_equal(self._drawn[0], drawn):
            begun = self._flexible(())[0].begun
            tables = np.zeros((self.limbs, len(self.links), self.width))
            tables[:, :, : begun.shape[2]] = np.where(begun, drawn, 0.0)
            self._drawn = drawn.copy(), self.frames(np.zeros((self.limbs, self.limbs)), tables)[0][:, -1]
        return self._drawn[1]

    def _bending(self, rows: Array, joints: tuple[int, ...]) -> Array:
        """Return the rows of parameters of the chain whose joints (from 0) give way.

        A pose, its derivatives and its loads are asked for at the same rows: the latest ones are kept.
        """
        kept = self._bent
        if not np.array_equal(kept[0], rows):
            kept = self._bent = rows.copy(), {}
        found = kept[1].get(joints)
        if found is None:
            found = self._flexible(joints)[0].rows(rows, self._lines(rows))
            found.flags.writeable = False
            kept[1][joints] = found
        return found

    def _giving_way(self, rows: Array, besides: Iterable[int] = ()) -> tuple[int, ...]:
        """Return which joints (from 0) have deflections in their rows of parameters, and some besides."""
        bent = rows[:, self._moving, self.width :].any(axis=(0, 2))
        return tuple(sorted({*np.flatnonzero(bent).tolist(), *besides}))

    def scaling(self, convention: str, robot: Robot, names: object) -> Array:
        """Raise UsageError: no paper gives the columns of a chain another scale."""
        raise OptionNotApplicable(f"{self.name} has no scaling '{convention}'; leave it out.")

    def rows(self, robot: Robot, errors: Array | None = None, deflections: Array | None = None) -> Array:
        """Return the links' rows of parameters, (M, links, n): geometry, errors, those of the tool, deflections."""
        values = self.every(self.vector(robot.errors) if errors is None else errors)
        n_g, n_e, n = len(self.geometry), len(self.errors), len(self.links)
        every = values if deflections is None else np.repeat(values, len(deflections) // len(values), axis=0)
        out = np.zeros((len(every), n, self.width + len(self.deflections)))
        for j, entry in enumerate(self.geometry):
            out[:, :, j] = robot.geometry[entry.key]
        out[:, :, n_g : n_g + n_e] = every[:, : n * n_e].reshape(-1, n, n_e)
        out[:, :, n_g + n_e : self.width] = every[:, None, n * n_e :]
        if deflections is not None:
            out[:, self._moving, self.width :] = deflections
        return out

    def roles(self, robot: Robot) -> dict[str, Array]:
        """Return the length of each joint's link, its own table's and all fixed ones' behind it; where slides begin."""
        found = {"L": self._length(robot) @ self._carried}
        slides = np.array([self.links[k].kind == "prismatic" for k in self._moving])
        if slides.any():
            found |= {"slides": slides.astype(float), "foot": np.where(slides, robot.geometry["d"][self._moving], 0.0)}
        return found

    def moves(self, robot: Robot) -> dict[str, dict[str, Array]]:
        """Return what effects move: ``arm``, tables of a joint's link along their own lines; zeros; what gives way."""
        length = self._length(robot)
        line = length @ self._carried
        share = self._carried * (length[:, None] / np.where(line > 0, line, 1.0))
        along = {key: robot.geometry[key] / np.where(length > 0, length, 1.0) for key in ("a", "d")}
        own = np.zeros((len(self.links), self.limbs))
        own[self._moving, np.arange(self.limbs)] = 1.0
        lines = self._lines(self.rows(robot))
        bends = own * (np.linalg.norm(lines, axis=1) > NO_LINE)
        give_way = {name: own if name.startswith(("side", "tilt")) else bends for name in self.deflections}
        slides = np.array([self.links[k].kind == "prismatic" for k in self._moving], dtype=float)
        found = {"arm": {key: direction[:, None] * share for key, direction in along.items()}}
        found["offset"] = {"theta": own * (1 - slides), "d": own * slides}
        return found | {name: {name: much} for name, much in give_way.items()}

    def _length(self, robot: Robot) -> Array:
        """Return how far each table leads (links,) [mm]."""
        return np.hypot(robot.geometry["a"], robot.geometry["d"])

    @cached_property
    def _carried(self) -> Array:
        """Which tables make up the link of each joint, (links, joints): 1 of its own and of fixed ones behind it."""
        out, joint = np.zeros((len(self.links), self.limbs)), -1
        for k, link in enumerate(self.links):
            joint = self._moving.index(k) if k in self._moving else joint if link.kind == "fixed" else -1
            if joint >= 0:
                out[k, joint] = 1.0
        return out

    def limb_inertia(self, robot: Robot, masses: Mapping[str, float]) -> Array:
        """Return zero: the file gives masses and their centres only."""
        return np.zeros(())

    # -------------------------------------------------------------------------------------------------- kinematics

    def _constants(self, kernels: ModuleType, rows: Array, poses: int) -> Array:
        """Return what no joint changes: compiled kernels share machines out, plain ones read one a pose."""
        self._alike(poses, rows=rows)
        made = self._made
        if made is None or made[0] is not rows or made[1] is not kernels:
            made = rows, kernels, kernels.constants(rows[:, :, : self.width])
            if not rows.flags.writeable:  # nobody changes them: see `_bending`
                self._made = made
        k = made[2]
        alone = kernels is self.vectorised and len(k) not in (1, poses)
        return np.repeat(k, poses // len(k), axis=0) if alone else k

    def frames(self, q: Array, rows: Array) -> tuple[Array, Array]:
        """Return the frames of the base and of every link: origins (N, n + 1, 3) and rotations (N, n + 1, 3, 3)."""
        q = self._poses(q, self.limbs, "joints")
        found = self.vectorised.frames(q, self._constants(self.vectorised, rows, len(q)), *self.shape)
        by_pose = np.moveaxis(found, -1, 0)
        return by_pose[..., :3], by_pose[..., 3:].reshape(*by_pose.shape[:2], 3, 3)

    def forward(
        self, q: Array, tool: Array, rows: Array, near: Array | None = None, *, out: Array | None = None
    ) -> tuple[Array, np.ndarray]:
        """Return the pose (N, 12) of the tool point and the last frame; every pose is SOLVED."""
        q, kernels = self._poses(q, self.limbs, "joints"), self._kernels(len(q))
        if joints := self._giving_way(rows):
            return self._flexible(joints)[1].forward(q, tool, self._bending(rows, joints), out=out)
        x, k = result(out, (len(q), POSE)), self._constants(kernels, rows, len(q))
        kernels.forward(q, self._tools(tool, len(q)), k, *self.shape, x)
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
        together: bool = False,
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
        together : bool
            Whether none is done before all are: see `Machine.follow`.

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
        if together:  # nothing waits for what no joints reach
            q, status = self.follow(target, near, tool, rows, drawn)
            open_ = np.flatnonzero(status == SOLVED)
        for _ in range(NEWTON_STEPS):
            if not len(open_):
                break
            x, reached = self.forward(q[open_], tool[open_], rows)
            slope = self.sensitivity(x, q[open_], tool[open_], rows).joints * sizes
            if reach is not None:
                moved, reached = reach(q[open_], open_)
                x = moved.x
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
            status[open_] = np.where(wrong, reached, np.where(ended, SOLVED, UNREACHABLE))
            going = ~(ended | wrong)
            going = ~wrong if together and going.any() else going
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
        raise NotForThisMachine("an open chain has no loops to close; its derivatives are those of `sensitivity`.")

    def sensitivity(
        self, x: Array, q: Array, tool: Array, rows: Array, *, out: tuple[Array, Array] | None = None
    ) -> Sensitivity:
        """Return the derivatives of the exact pose at N poses.

        `out` holds (N, 6, n_p) by the source errors, and (N, 6, n_q) by the joints.
        """
        x, q = self._poses(x, POSE, "poses"), self._poses(q, self.limbs, "joints")
        self._alike(len(x), joints=q)
        kernels, (S_out, V_out) = self._kernels(len(q)), (None, None) if out is None else out
        if joints := self._giving_way(rows):
            return self._of_flexible(joints, x, q, tool, rows, S_out, V_out)
        S, V = result(S_out, (len(x), self.n_x, len(self.parameters))), result(V_out, (len(x), self.n_x, self.limbs))
        kernels.sensitivity(x, q, self._constants(kernels, rows, len(q)), *self.shape, S, V)
        own = S[:, :, : -len(self.common)].reshape(len(x), self.n_x, len(self.links), len(self.errors))
        return Sensitivity(own, own[..., :0], partial(self._by_deflections, x, q, tool, rows), V, S)

    def _by_deflections(self, x: Array, q: Array, tool: Array, rows: Array, limbs: Sequence[int]) -> Array:
        """Return the derivatives by the deflections of some joints, from 1, (N, 6, links, n_d); of the others zero."""
        joints = self._giving_way(rows, [i - 1 for i in limbs] or range(self.limbs))
        laid, chain = self._flexible(joints)
        tables, errors = np.moveaxis(laid.deflections, -1, 0)
        out = np.zeros((len(x), self.n_x, len(self.links), len(self.deflections)))
        out[:, :, [self._moving[j] for j in joints]] = chain.sensitivity(x, q, tool, self._bending(rows, joints)).own[
            :, :, tables, errors
        ]
        return out

    def _of_flexible(
        self,
        joints: tuple[int, ...],
        x: Array,
        q: Array,
        tool: Array,
        rows: Array,
        S_out: Array | None,
        V_out: Array | None,
    ) -> Sensitivity:
        """Return the derivatives of the exact pose of a chain some of whose joints give way."""
        laid, chain = self._flexible(joints)
        found = chain.sensitivity(x, q, tool, self._bending(rows, joints))
        S, V = result(S_out, (len(x), self.n_x, len(self.parameters))), filled(V_out, found.joints)
        tables, errors = np.moveaxis(laid.errors, -1, 0)
        n = tables.size
        S[:, :, :n] = found.own[:, :, tables, errors].reshape(len(x), self.n_x, n)
        S[:, :, n:] = found.parameters[:, :, -len(self.common) :]
        own = S[:, :, :n].reshape(len(x), self.n_x, *tables.shape)
        return Sensitivity(own, own[..., :0], partial(self._by_deflections, x, q, tool, rows), V, S)

    # ------------------------------------------------------------------------------------------------------- loads

    def _loads(self, x: Array, q: Array, tool: Array, rows: Array, given: Weights) -> tuple[Array, ...]:
        """Return what the links' weights and the payload exert on the joints, by virtual work.

        `masses` is read for whether there are any: an empty mapping asks for the payload alone. What a link weighs
        itself pulls others along their deflections, not its own.
        """
        masses, fields, payload, limbs = given
        every = np.asarray(fields, dtype=float).reshape(len(q) if np.ndim(fields) == 3 else 1, -1, 3).transpose(1, 2, 0)
        points = np.concatenate([self._centres(q, rows), x[:, :3].T[None]])
        laid, chain, bears = None, self, np.arange(len(self.links))
        if joints := self._giving_way(rows, [i - 1 for i in limbs]):
            laid, chain = self._flexible(joints)
            rows, bears = self._bending(rows, joints), laid.bears
        weights = [link.mass if masses else 0.0 for link in self.links]
        forces = np.zeros((len(self.links) + 1, 3, len(q)))
        forces[:-1] = np.array(weights)[:, None, None] * every[: len(self.links)]
        forces[-1] = payload * every[-1]
        torque, moment = np.empty(q.shape), np.empty((len(q), 3))
        along = np.empty((len(q), len(chain.links), len(self.errors)))
        kernels = self._kernels(len(q))
        k, at = chain._constants(kernels, rows, len(q)), np.append(bears, len(chain.links))
        kernels.loads(q, k, *chain.shape, points, forces, at, torque, along, moment)
        pull = np.zeros((len(q), self.limbs, len(self.deflections)))
        if laid is not None:
            tables, errors = np.moveaxis(laid.deflections, -1, 0)
            pull[:, list(joints)] = along[:, tables, errors]
        return torque, pull, np.zeros((len(q), self.limbs, 1)), moment

    def weights_at(
        self, x: Array, q: Array, tool: Array, rows: Array, masses: Mapping[str, float], *, out: Array | None = None
    ) -> Array:
        """Return where the weights are, (N, links + 1, 3) [mm]: each link's centre of mass, and the payload."""
        q = self._poses(q, self.limbs, "joints")
        centres = self._centres(q, rows)
        return filled(out, np.concatenate([np.moveaxis(centres, -1, 0), x[:, None, :3]], axis=1))

    def _centres(self, q: Array, rows: Array) -> Array:
        """Return where the links have their centres of mass, (links, 3, N) [mm]."""
        chain, own, tables = self, np.zeros((len(self.links), 3)), np.arange(len(self.links))
        if joints := self._giving_way(rows):
            laid, chain = self._flexible(joints)
            rows, tables = self._bending(rows, joints), laid.ends
            own = np.zeros((len(chain.links), 3))
        own[tables] = [link.com for link in self.links]
        kernels = self._kernels(len(q))
        k = chain._constants(kernels, rows, len(q))
        found: Array = kernels.centres(q, k, *chain.shape, own[:, :, None])
        return found[tables]


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
