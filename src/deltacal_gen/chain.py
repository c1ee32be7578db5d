"""An open chain that computes: links of the generated kernels, one behind the other as the robot file lists them.

The same interface as a machine of limbs (`deltacal_gen.mechanism.Mechanism`); a limb is a link here, and its joint is
the link's. Forward position is explicit, so there is nothing to solve and no pose is out of reach.
"""

from __future__ import annotations

import importlib
from collections.abc import Mapping
from dataclasses import dataclass
from types import ModuleType

import numpy as np

from deltacal_gen.errors import UsageError
from deltacal_gen.inputs import Link, Robot
from deltacal_gen.mechanism import POSE, SOLVED, GeometryKey, Loads, Mechanism, Parameter, Sensitivity
from deltacal_gen.rotation import Array

PARALLEL = 1e-6  # rad: axes that are closer to parallel have no common normal to speak of
TOOL = ("tx", "ty", "tz")


@dataclass(frozen=True)
class _Placed:
    """Links in the base frame: rotation (N, 3, 3) and origin (N, 3) of each, and of the frame before it.

    `local` holds the twists (N, 6, n_e + 2) of each link in the frame before it.
    """

    q: Array
    rows: Array
    before: list[Array]
    rotation: list[Array]
    origin: list[Array]
    local: list[Array]

    def twists(self, k: int, columns: slice | list[int]) -> Array:
        """Return twists (N, 6, columns) of link k along the base's axes."""
        rows = np.swapaxes(self.local[k], 1, 2)[:, columns]  # as they lie in memory
        turned = rows.reshape(len(rows), -1, 3) @ np.swapaxes(self.before[k], 1, 2)
        return np.swapaxes(turned.reshape(rows.shape), 1, 2)


class Chain(Mechanism):
    """The links of one robot.

    Parameters
    ----------
    tables : module
        Generated tables of a link.
    links : tuple of Link
        As the robot file lists them, from the base.
    """

    links: tuple[Link, ...]

    def __init__(self, tables: ModuleType, links: tuple[Link, ...]) -> None:
        self._tables, self.links = tables, links
        self._kernels_of_a_link = importlib.import_module(f"deltacal_kernels.{tables.NAME}.links")
        self.name, self.title, self.reference = tables.NAME, tables.TITLE, tables.REFERENCE
        self.machine = self.name
        self._moving = [k for k, link in enumerate(links) if link.kind in ("revolute", "prismatic")]
        self.limbs = len(self._moving)
        self._last: _Placed | None = None
        kinds = {links[k].kind for k in self._moving}
        if len(kinds) > 1:
            raise UsageError("a chain of revolute and prismatic joints together is not supported yet.")
        self.joint_unit = "mm" if kinds == {"prismatic"} else "rad"
        self.platform = ("px", "py", "pz", "cx", "cy", "cz")
        self.layers = (1, -1)  # a workspace stands on the base plane
        self.axes = self.turns = ("x", "y", "z")
        self.geometry = tuple(
            GeometryKey(key, unit, meaning, True, None, "joint", False, None) for key, unit, meaning in tables.GEOMETRY
        )
        self.errors = tuple(name for name, *_ in tables.ERRORS)
        self.common = TOOL
        self.deflections = ()
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
        values = np.atleast_2d(self.vector(robot.errors) if errors is None else np.asarray(errors, dtype=float))
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
        """Return each link's variable (N, links, 2): its turn and its slide."""
        out = np.zeros((len(q), len(self.links), 2))
        by_number = {k + 1: q[:, j] for j, k in enumerate(self._moving)}
        for k, link in enumerate(self.links):
            value = by_number.get(k + 1, np.zeros(len(q)))
            if link.kind == "coupled":
                value = np.asarray(sum(much * by_number[number] for number, much in link.coupling))
            out[:, k, int(link.kind == "prismatic")] = value
        return out

    def _placed(self, q: Array, rows: Array) -> _Placed:
        last = self._last  # forward, derivatives and loads of one state come one after the other
        if last is not None and np.array_equal(last.q, q) and np.array_equal(last.rows, rows):
            return last
        variables, placed = self._variables(q), _Placed(q.copy(), rows.copy(), [], [], [], [])
        R, p = np.broadcast_to(np.eye(3), (len(q), 3, 3)), np.zeros((len(q), 3))
        for k, link in enumerate(self.links):
            turn, shift, local = self._kernels_of_a_link.link(link.convention, variables[:, k], rows[:, k])
            placed.before.append(R)
            R, p = R @ turn, p + np.einsum("nij,nj->ni", R, shift)
            placed.local.append(local)
            placed.rotation.append(R)
            placed.origin.append(p)
        self._last = placed
        return placed

    def frames(self, q: Array, rows: Array) -> tuple[Array, Array]:
        """Return the frames of the base and of every link: origins (N, n + 1, 3) and rotations (N, n + 1, 3, 3)."""
        placed = self._placed(self._poses(q, self.limbs, "joints"), rows)
        origins = np.stack([np.zeros((len(q), 3)), *placed.origin], axis=1)
        rotations = np.stack([np.broadcast_to(np.eye(3), (len(q), 3, 3)), *placed.rotation], axis=1)
        return origins, rotations

    def forward(self, q: Array, tool: Array, rows: Array, near: Array | None = None) -> tuple[Array, np.ndarray]:
        """Return the pose (N, 12) of the tool point and the last frame; every pose is SOLVED."""
        q, tool = self._poses(q, self.limbs, "joints"), self._tool(tool, len(q))
        if len(rows) not in (1, len(q)):
            rows = np.repeat(rows, len(q) // len(rows), axis=0)
        placed = self._placed(q, rows)
        R, p = placed.rotation[-1], placed.origin[-1]
        point = p + np.einsum("nij,nj->ni", R, tool + rows[:, 0, -3:])
        return np.hstack([point, R.reshape(-1, 9)]), np.full(len(q), SOLVED)

    def positions(self, q: Array, tool: Array, rows: Array) -> Array:
        """Return the positions (N, 3) of the tool point [mm]."""
        return self.forward(q, tool, rows)[0][:, :3]

    def inverse(self, target: Array, tool: Array, rows: Array) -> tuple[Array, Array, np.ndarray]:
        """Raise UsageError: a position alone does not say how a chain shall stand."""
        raise UsageError(
            "a position alone does not say how an open chain shall stand. Give joints: a recording instead of targets."
        )

    def jacobians(self, x: Array, q: Array, tool: Array, rows: Array) -> tuple[Array, Array, Array, Array]:
        """Raise UsageError: a chain's closure is its forward position; see `sensitivity`."""
        raise UsageError("an open chain has no loops to close; its derivatives are those of `sensitivity`.")

    def sensitivity(self, x: Array, q: Array, tool: Array, rows: Array) -> Sensitivity:
        """Return the derivatives of the exact pose at N poses: each twist moves all that comes behind its link."""
        x, q = self._poses(x, POSE, "poses"), self._poses(q, self.limbs, "joints")
        placed, n_e = self._placed(q, rows), len(self.errors)
        own = np.zeros((len(q), 6, len(self.links), n_e))
        joints = np.zeros((len(q), 6, self.limbs))
        for k, link in enumerate(self.links):
            moved = _at(placed.twists(k, slice(None)), placed.origin[k], x[:, :3])
            own[:, :, k] = moved[:, :, :n_e]
            for j, much in self._drives(k):
                joints[:, :, j] += much * moved[:, :, n_e + int(link.kind == "prismatic")]
        common = np.zeros((len(q), 6, len(self.links), 3))
        common[:, :3, 0] = placed.rotation[-1]
        return Sensitivity(own, common, np.zeros((len(q), 6, self.limbs, 0)), joints)

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
    ) -> Loads:
        """Return what the links' weights and the payload exert on the joints, by virtual work.

        `masses` is read for whether there are any: an empty mapping asks for the payload alone.
        """
        q = self._poses(q, self.limbs, "joints")
        placed, carried = self._placed(q, rows), np.broadcast_to(np.asarray(payload, dtype=float), len(q))
        points = self.weights_at(x, q, tool, rows, masses)
        every = np.broadcast_to(np.asarray(fields, dtype=float), points.shape)
        weighs = np.array([link.mass if masses else 0.0 for link in self.links])
        force = every * np.column_stack([*(np.full(len(q), m) for m in weighs), carried])[:, :, None]
        moment = np.cross(points, force)
        # of a link and all behind it, the payload last: force, and moment about {O}
        behind = [np.cumsum(v[:, ::-1], axis=1)[:, ::-1] for v in (force, moment)]
        torque, n_e = np.zeros((len(q), self.limbs)), len(self.errors)
        for k, link in enumerate(self.links):
            driven = self._drives(k)
            if not driven:
                continue
            F, M = (v[:, k] for v in behind)
            twist = placed.twists(k, [n_e + int(link.kind == "prismatic")])[:, :, 0]
            work = (twist[:, :3] * F + twist[:, 3:] * (M - np.cross(placed.origin[k], F))).sum(axis=1)
            for j, much in driven:
                torque[:, j] += much * work
        none = np.zeros((len(q), self.limbs, 1))
        return Loads(torque, none[:, :, :0], none, moment.sum(axis=1))

    def weights_at(self, x: Array, q: Array, tool: Array, rows: Array, masses: Mapping[str, float]) -> Array:
        """Return where the weights are, (N, links + 1, 3) [mm]: each link's centre of mass, and the payload."""
        placed = self._placed(self._poses(q, self.limbs, "joints"), rows)
        at = [p + R @ np.array(link.com) for p, R, link in zip(placed.origin, placed.rotation, self.links, strict=True)]
        return np.stack([*at, x[:, :3]], axis=1)


def _at(twists: Array, origin: Array, point: Array) -> Array:
    """Return twists (N, 6, n) given at `origin` as they move another `point` of the same body (N, 3)."""
    out = twists.copy()
    arm = (point - origin)[:, :, None]
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        out[:, i] += twists[:, 3 + j] * arm[:, k] - twists[:, 3 + k] * arm[:, j]
    return out
