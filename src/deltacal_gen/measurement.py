"""Readings and the instrument that made them: from platform poses to what was measured.

The formulas are generated from ``derive/measurements``; here they are put together with the rows of a recording. An
`Instrument` is a value: its unknowns are increments of its state, and a step gives a new instrument.
"""

from __future__ import annotations

import dataclasses
import importlib
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from types import ModuleType
from typing import Any

import numpy as np

from deltacal_gen import sphere
from deltacal_gen.errors import InputError
from deltacal_gen.inputs import Recording, Robot
from deltacal_gen.mechanism import Array, Machine, mechanism_of
from deltacal_gen.rotation import cayley_matrix, from_vector, mean, to_vector
from deltacal_gen.units import DEG

MOST_PAIRS = 200_000  # distances that are made of positions at once
TIE_STEPS = 4  # each squares what a known distance is off
MOUNT = ("mx", "my", "mz")  # a gauge's unknowns which, where they are parameters of the machine, a model frees or not
BOTH = "height and distance"  # of a printer: the bed was probed, and a printed object measured
CONTACT = "contact"  # a position in a frame of its own: that of the point that is touched, where it reads zero
FRAMELESS = ("distance", "height", BOTH)  # the instrument itself has nothing unknown
_AXES = {"reading.x": 0, "reading.y": 1, "reading.z": 2}
_TARGETS = {  # what of a reading effects may move, by column
    "position": _AXES,
    "pose": _AXES,
    "distance": {"length": 0},
    "gauge": {"length": 0},
    "sphere": {},
    CONTACT: {},
    "height": {"height": 0},
    BOTH: {"height": 0, "length": 1},
}


@dataclass(frozen=True, eq=False)
class Readings:
    """What was measured, reading by reading; a reading belongs to one row of the recording, a distance to two.

    Attributes
    ----------
    kind : str
        As in a recording, or `BOTH`.
    rows : (R, 1) or (R, 2) int array
        Rows of the recording; of a height among distances, its row twice.
    values : (R, k) array
        Position, distance, length or height [mm]; extremes of an image [px]. NaN along an axis that the machine does
        not have, and in a height's row for the distance (or the other way round), where both were measured.
    rotations : (R, 3, 3) array or None
        Measured rotations; NaN where only the position was read.
    setup : (R,) int array
        Set-up of the instrument; of contacts, the point that is touched.
    group : (R,) int array
        Readings of one group stay together when readings are held out: repeats of a pose, of a pair of poses.
    line : (R,) int array
        Line in the file.
    made : bool
        Distances made of measured positions, which share their noise.
    components : tuple of int
        Which coordinates of a body (position, rotation) a position or pose holds: in the plane, not all.
    """

    kind: str
    rows: np.ndarray
    values: Array
    rotations: Array | None
    setup: np.ndarray
    group: np.ndarray
    line: np.ndarray
    made: bool = False
    components: tuple[int, ...] = (0, 1, 2, 3, 4, 5)

    def __len__(self) -> int:
        return len(self.values)

    @property
    def targets(self) -> dict[str, int]:
        """Columns of `values` by what effects on the reading move."""
        return _TARGETS[self.kind]

    def noise_groups(self, columns: int) -> np.ndarray:
        """Return which noise each column (columns,) of a residual has: lengths and rotations, heights and distances."""
        return np.arange(2) if self.kind == BOTH else (np.arange(columns) >= 3).astype(int)

    @property
    def n_scalars(self) -> int:
        """Number of independent scalar readings: distances made of positions hold no more than those."""
        if self.made:
            return min(len(self.values), 3 * len(self.used) - 6)
        turns = sum(c >= 3 for c in self.components)
        turned = 0 if self.rotations is None else turns * int(np.isfinite(self.rotations[:, 0, 0]).sum())
        return int(np.isfinite(self.values).sum()) + turned

    @cached_property
    def used(self) -> np.ndarray:
        """Rows of the recording to which readings belong, in their order."""
        return np.flatnonzero(np.bincount(self.rows.ravel()))

    def subset(self, chosen: np.ndarray) -> Readings:
        """Return the readings of an index or mask."""
        return dataclasses.replace(
            self,
            rows=self.rows[chosen],
            values=self.values[chosen],
            rotations=None if self.rotations is None else self.rotations[chosen],
            setup=self.setup[chosen],
            group=self.group[chosen],
            line=self.line[chosen],
        )


def readings(recording: Recording, *, as_distance: bool = False) -> Readings:
    """Return the readings of a recording; blank ones are left out.

    Parameters
    ----------
    as_distance : bool
        Turn positions into the distances of all pairs that share tool point and set-up (Bai 2015, section 3.1).

    Raises
    ------
    InputError
        The recording holds no reading of a kind that can be used here.
    """
    kind = recording.kind
    pose = _poses(recording)
    if kind == "height":
        return _some(recording, _heights(recording, pose))
    if kind == "distance" or (recording.pairs is not None and len(recording.pairs)):
        if recording.pairs is None or recording.pair_measured is None or recording.pair_line is None:
            raise InputError("no distances between poses are given.", "Add NAME.distances.csv.", file=recording.path)
        taken = np.isfinite(recording.pair_measured)
        ends = np.sort(pose[recording.pairs[taken]], axis=1)
        _, group = np.unique(ends, axis=0, return_inverse=True)
        return _some(
            recording,
            Readings(
                "distance",
                recording.pairs[taken],
                recording.pair_measured[taken, None],
                None,
                np.zeros(int(taken.sum()), dtype=int),
                np.ravel(group),
                recording.pair_line[taken],
            ),
        )
    if kind == CONTACT:
        assert recording.contact is not None
        taken = np.flatnonzero(recording.contact != "")
        return _some(
            recording,
            Readings(
                kind,
                taken[:, None],
                np.zeros((len(taken), 3)),
                None,
                np.searchsorted(contacts(recording), recording.contact[taken]),
                pose[taken],
                recording.line[taken],
            ),
        )
    if kind in ("gauge", "sphere"):
        taken = np.flatnonzero(np.isfinite(recording.measured).all(axis=1))
        return _some(
            recording,
            Readings(
                kind,
                taken[:, None],
                recording.measured[taken],
                None,
                recording.setup[taken],
                pose[taken],
                recording.line[taken],
            ),
        )
    components = np.array(recording.components)
    body = np.full((recording.n_rows, 6), np.nan)
    body[:, components] = recording.measured
    taken = np.flatnonzero(np.isfinite(body[:, components[components < 3]]).all(axis=1))
    rotations = None
    if kind == "pose":
        read = np.isfinite(body[np.ix_(taken, components[components >= 3])]).all(axis=1)
        rotations = np.full((len(taken), 3, 3), np.nan)
        rotations[read] = from_vector(np.nan_to_num(body[taken, 3:])[read])
        if not read.any():
            kind, rotations = "position", None
    found = Readings(
        kind,
        taken[:, None],
        body[taken, :3],
        rotations,
        recording.setup[taken],
        pose[taken],
        recording.line[taken],
        components=recording.components,
    )
    return _some(recording, distances(found, recording) if as_distance and kind in ("position", "pose") else found)


def contacts(recording: Recording) -> np.ndarray:
    """Return the names of the points that are touched, in the order of an instrument's state."""
    assert recording.contact is not None
    return np.unique(recording.contact[recording.contact != ""])


def _heights(recording: Recording, pose: np.ndarray) -> Readings:
    """Return the heights and, where distances were measured too, both."""
    taken = np.flatnonzero(np.isfinite(recording.measured[:, 0]))
    heights, zeros = recording.measured[taken], np.zeros(len(taken), dtype=int)
    if recording.pairs is None or recording.pair_measured is None or recording.pair_line is None:
        return Readings("height", taken[:, None], heights, None, zeros, pose[taken], recording.line[taken])
    pairs = np.flatnonzero(np.isfinite(recording.pair_measured))
    return both(
        recording,
        taken,
        pairs,
        np.concatenate([heights[:, 0], recording.pair_measured[pairs]]),
        np.concatenate([recording.line[taken], recording.pair_line[pairs]]),
    )


def both(recording: Recording, rows: np.ndarray, pairs: np.ndarray, values: Array, line: np.ndarray) -> Readings:
    """Return readings of height at some rows and of distance between some pairs; `values`, `line` in this order."""
    assert recording.pairs is not None
    ends = np.concatenate([np.column_stack([rows, rows]), recording.pairs[pairs]])
    table = np.full((len(ends), 2), np.nan)
    table[np.arange(len(ends)), (ends[:, 0] != ends[:, 1]).astype(int)] = values
    _, group = np.unique(np.sort(_poses(recording)[ends], axis=1), axis=0, return_inverse=True)
    return Readings(BOTH, ends, table, None, np.zeros(len(ends), dtype=int), np.ravel(group), line)


def _poses(recording: Recording) -> np.ndarray:
    """Return the pose (N,) of each row: label and set-up or, where there are no labels, joints and tool point."""
    _, label = np.unique(recording.pose, return_inverse=True)
    if label.max(initial=-1) + 1 == recording.n_rows and recording.pairs is None:
        tool = np.zeros((recording.n_rows, 3)) if recording.tool is None else np.nan_to_num(recording.tool)
        key = np.round(np.column_stack([recording.joints, tool, recording.setup]), 9)
        return np.ravel(np.unique(key, axis=0, return_inverse=True)[1])
    return np.ravel(np.unique(np.column_stack([label, recording.setup]), axis=0, return_inverse=True)[1])


def distances(positions: Readings, recording: Recording) -> Readings:
    """Return the distances of all pairs of positions that share tool point and set-up."""
    tool = np.zeros((recording.n_rows, 3)) if recording.tool is None else np.nan_to_num(recording.tool)
    _, point = np.unique(np.column_stack([tool[positions.rows[:, 0]], positions.setup]), axis=0, return_inverse=True)
    point = np.ravel(point)
    if (count := sum(n * (n - 1) // 2 for n in np.bincount(point))) > MOST_PAIRS:
        raise InputError(
            f"{len(positions)} positions make {count} distances.",
            "Use the positions themselves (they hold the same information), or fewer rows.",
            file=recording.path,
        )
    a, b = np.triu_indices(len(positions), 1)
    same = point[a] == point[b]
    a, b = a[same], b[same]
    gap = np.linalg.norm(np.nan_to_num(positions.values[b] - positions.values[a]), axis=1)
    apart = positions.group[a] != positions.group[b]  # two readings of one pose have no direction between them
    a, b, gap = a[apart], b[apart], gap[apart]
    ends = np.sort(np.column_stack([positions.group[a], positions.group[b]]), axis=1)
    _, group = np.unique(ends[:, 0] * (positions.group.max() + 1) + ends[:, 1], return_inverse=True)
    return Readings(
        "distance",
        np.column_stack([positions.rows[a, 0], positions.rows[b, 0]]),
        gap[:, None],
        None,
        positions.setup[a],
        np.ravel(group),
        positions.line[b],
        made=True,
    )


def _some(recording: Recording, found: Readings) -> Readings:
    if len(found) == 0:
        raise InputError(
            "every measured cell is blank, so there is nothing to fit.",
            "Fill the measured columns, or use predict to compute them.",
            file=recording.path,
        )
    return found


@dataclass(frozen=True, eq=False)
class Instrument:
    """State of the instrument: one row of `state` per set-up, in the order of the generated `given`.

    Attributes
    ----------
    kind : str
    state : (S, g) array
    free : tuple of int
        Which unknowns of the kind are estimated; none of them in a frame that is known.
    scale : float
        What one unit of the reading is at the platform [mm]: of images, a pixel at the ball's distance. Residuals and
        derivatives come multiplied by it.
    home : tuple of float
        From where positions count [mm], in {O}.
    ties : tuple of (int, int, float)
        Known distances [mm] between the origins of two rows of the state: they leave so many unknowns fewer.
    """

    kind: str
    state: Array
    free: tuple[int, ...]
    scale: float = 1.0
    home: tuple[float, float, float] = (0.0, 0.0, 0.0)
    ties: tuple[tuple[int, int, float], ...] = ()

    @property
    def _kernels(self) -> ModuleType:
        return _kernels(self.kind)

    @property
    def n_unknown(self) -> int:
        """Number of unknowns, all set-ups together."""
        return len(self.free) * len(self.state) - len(self.ties)

    @property
    def unknown(self) -> tuple[tuple[str, str], ...]:
        """Name and unit of each unknown, set-up by set-up."""
        named = [self._kernels.UNKNOWN[j] for j in self.free] if self.free else []
        several = len(self.state) > 1
        return tuple(
            (f"{name}_{s + 1}" if several else name, unit) for s in range(len(self.state)) for name, unit, _ in named
        )

    def _ends(self, found: Readings, x: Array) -> tuple[Array, ...]:
        ends = tuple(x[rows] for rows in found.rows.T)
        if any(self.home):
            for end in ends:
                end[:, :3] -= self.home
        return ends

    @staticmethod
    def _split(found: Readings) -> tuple[tuple[int, np.ndarray, Instrument, Readings], ...]:
        """Return heights and distances apart: column, place of each reading, and an instrument for them alone."""
        height = found.rows[:, 0] == found.rows[:, 1]
        out = []
        for column, kind in enumerate(("height", "distance")):
            at = np.flatnonzero(height == (kind == "height"))
            part = found.subset(at)
            rows = part.rows[:, :1] if kind == "height" else part.rows
            alone = dataclasses.replace(part, kind=kind, rows=rows, values=part.values[:, [column]])
            out.append((column, at, frameless(kind), alone))
        return tuple(out)

    def predict(self, found: Readings, x: Array) -> tuple[Array, Array | None]:
        """Return predicted values (R, k) and, for poses, rotations (R, 3, 3), at platform coordinates x (N, 6)."""
        if self.kind == BOTH:
            apart = np.full((len(found), 2), np.nan)
            for column, at, instrument, part in self._split(found):
                apart[at, column] = instrument.predict(part, x)[0][:, 0]
            return apart, None
        ends, given = self._ends(found, x), self.state[found.setup]
        values: Array = self._kernels.reading(*ends, given)
        return values, self._kernels.rotation(*ends, given) if self.kind == "pose" else None

    def residual(self, found: Readings, x: Array) -> Array:
        """Return measured minus predicted, (R, k): mm, and the rotation vector between the rotations in rad."""
        values, rotations = self.predict(found, x)
        r = self.scale * (found.values - values)
        if rotations is None or found.rotations is None:
            return r
        turned = np.full((len(found), 3), np.nan)
        read = np.isfinite(found.rotations[:, 0, 0])
        gap = found.rotations[read] @ np.swapaxes(rotations[read], 1, 2)
        turned[read] = to_vector(gap)
        turned[:, [c - 3 for c in range(3, 6) if c not in found.components]] = np.nan
        return np.hstack([r, turned])

    def mounted(self, mechanism: Machine, parameters: Array) -> Instrument:
        """Return the instrument where the machine's own parameters (n_p,) put it."""
        own = carried(self.kind, mechanism)
        if not own:
            return self
        state = self.state.copy()
        state[:, list(own)] += parameters[list(own.values())]
        return dataclasses.replace(self, state=state)

    def by_unknown(self, found: Readings, x: Array, chosen: Sequence[int]) -> Array:
        """Return the derivatives (R, k, chosen) of the readings by unknowns of the kind, free or not."""
        derivatives: Array = self.scale * self._kernels.by_unknown(*self._ends(found, x), self.state[found.setup])
        return derivatives[:, :, list(chosen)]

    def linearise(self, found: Readings, x: Array, dx: Array) -> tuple[Array, Array]:
        """Return the derivatives of the readings by parameters and by the instrument's unknowns.

        Parameters
        ----------
        dx : (N, 6, n) array
            Derivatives of the platform coordinates by n parameters.

        Returns
        -------
        J_p : (R, k, n) array
        J_m : (R, k, n_unknown) array
        """
        if self.kind == BOTH:
            J = np.zeros((len(found), 2, dx.shape[2]))
            for column, at, instrument, part in self._split(found):
                J[at, column] = instrument.linearise(part, x, dx)[0][:, 0]
            return J, np.zeros((len(found), 2, 0))
        ends, given = self._ends(found, x), self.state[found.setup]
        by_platform = self._kernels.by_platform(*ends, given)
        J_p = self.scale * sum(by_platform[:, :, e] @ dx[rows] for e, rows in enumerate(found.rows.T))
        J_m = np.zeros((*J_p.shape[:2], len(self.state), len(self.free)))
        if self.free:
            J_m[np.arange(len(found)), :, found.setup] = self.by_unknown(found, x, self.free)
        J_m = J_m.reshape(*J_p.shape[:2], -1)
        return J_p, J_m @ self._loose() if self.ties else J_m

    def _tied(self) -> tuple[Array, Array]:
        """Return the derivatives (ties, 3 rows) of tied distances by the origins, and by how much they are off."""
        slope, off = np.zeros((len(self.ties), len(self.state), 3)), np.zeros(len(self.ties))
        for i, (a, b, distance) in enumerate(self.ties):
            gap = self.state[b, 9:12] - self.state[a, 9:12]
            length = max(float(np.linalg.norm(gap)), 1e-12)
            slope[i, b], slope[i, a], off[i] = gap / length, -gap / length, length - distance
        return slope.reshape(len(self.ties), -1), off

    def _loose(self) -> Array:
        """Return the directions (3 rows, n_unknown) of the origins that keep tied distances."""
        directions: Array = np.linalg.svd(self._tied()[0])[2][len(self.ties) :].T
        return directions

    def tied(self) -> Instrument:
        """Return the instrument with its origins moved, as little as need be, to the known distances."""
        out = self
        for _ in range(TIE_STEPS if self.ties else 0):
            slope, off = out._tied()
            state = out.state.copy()
            state[:, 9:12] -= (np.linalg.pinv(slope) @ off).reshape(-1, 3)
            out = dataclasses.replace(out, state=state)
        return out

    def stepped(self, increment: Array) -> Instrument:
        """Return the instrument after an increment (n_unknown,) of its unknowns."""
        if not self.n_unknown:
            return self
        step = np.zeros((len(self.state), len(self._kernels.UNKNOWN)))
        if self.ties:
            increment = self._loose() @ increment
        step[:, list(self.free)] = np.asarray(increment).reshape(len(self.state), -1)
        state = self.state.copy()
        if self.kind == "gauge":
            state += step
            return dataclasses.replace(self, state=state)
        state[:, :9] = (cayley_matrix(step[:, :3]) @ state[:, :9].reshape(-1, 3, 3)).reshape(-1, 9)
        state[:, 9:12] += step[:, 3:6]
        if self.kind == "sphere":
            state[:, sphere.DISTORTION] += step[:, 6]
        if self.kind == "pose":
            state[:, 12:] = (cayley_matrix(step[:, 6:9]) @ state[:, 12:].reshape(-1, 3, 3)).reshape(-1, 9)
        return dataclasses.replace(self, state=state).tied()

    def frames(self) -> list[tuple[Array, Array]]:
        """Return per set-up the rotation vector [rad] and the origin [mm] of {O} in the instrument's frame."""
        if self.kind not in ("position", "pose"):
            return []
        return [(to_vector(s[:9].reshape(3, 3)), s[9:12]) for s in self.state]

    def to_dict(self) -> dict[str, Any]:
        """Return the state for a result file."""
        return {
            "kind": self.kind,
            "state": self.state.tolist(),
            "free": list(self.free),
            "scale": self.scale,
            "home": list(self.home),
            "ties": [list(tie) for tie in self.ties],
        }

    @staticmethod
    def from_dict(data: dict[str, Any]) -> Instrument:
        """Return the instrument of a result file."""
        return Instrument(
            data["kind"],
            np.asarray(data["state"], dtype=float),
            tuple(data["free"]),
            data.get("scale", 1.0),
            tuple(data.get("home", (0.0, 0.0, 0.0))),
            tuple((int(a), int(b), float(d)) for a, b, d in data.get("ties", ())),
        )


def carried(kind: str, mechanism: Machine) -> dict[int, int]:
    """Return which unknowns of a kind of instrument are parameters of the machine: {unknown: parameter}.

    A measuring mechanism that belongs to a machine has its errors in the machine's table (Mei 2018, eq. 17).
    """
    if kind != "gauge":
        return {}
    return {u: mechanism.index[name] for u, name in enumerate(MOUNT) if name in mechanism.index}


def _kernels(kind: str) -> ModuleType:
    return importlib.import_module(f"deltacal_kernels.measurements.{'position' if kind == CONTACT else kind}")


def frameless(kind: str) -> Instrument:
    """Return the instrument of a kind that has nothing unknown."""
    return Instrument(kind, np.zeros((1, 0)), ())


def start(found: Readings, recording: Recording, robot: Robot, x: Array) -> Instrument:
    """Return the instrument in its first state, from the poses x (N, 6) of the machine as known so far.

    Frames are aligned set-up by set-up (Kabsch); a gauge stands where the sidecar says. Positions that count from the
    robot's home have their origin there.
    """
    known = recording.measurement.frame == "robot"
    setups = int(recording.setup.max()) + 1 if found.kind in ("position", "pose", "sphere") else 1
    if found.kind in FRAMELESS:
        return frameless(found.kind)
    if found.kind == CONTACT:
        return _touched(found, recording, x)
    if found.kind == "gauge":
        base = recording.measurement.base_point_mm or (0.0, 0.0, 0.0)
        incremental = recording.measurement.zero == "incremental"
        state = np.array([[*base, 0.0]])
        mechanism = mechanism_of(robot)
        own = carried("gauge", mechanism)
        free = tuple(u for u in range(3) if u not in own and "xyz"[u] in mechanism.axes)
        instrument = Instrument("gauge", state, (*free, 3) if incremental else free)
        zero = float(np.median(instrument.residual(found, x))) if incremental else 0.0
        return dataclasses.replace(instrument, state=np.array([[*base, zero]]))
    if found.kind == "sphere":
        return _camera(found, recording, x, setups, known)
    home = home_of(recording, robot)
    state = np.tile(np.concatenate([np.eye(3).ravel(), np.zeros(3)]), (setups, 1))
    for s in range(setups) if not known else ():
        chosen = found.setup == s
        if not chosen.any():
            continue
        P, y = x[found.rows[chosen, 0], :3], np.nan_to_num(found.values[chosen])
        turn = align(P - P.mean(axis=0), y - y.mean(axis=0))
        state[s, :9] = turn.ravel()
        if not any(home):
            state[s, 9:12] = y.mean(axis=0) - turn @ P.mean(axis=0)
    free = _unknown(found.components)
    if any(home):
        free = tuple(u for u in free if not 3 <= u < 6)
    if found.kind == "position":
        return Instrument("position", state, () if known else tuple(u for u in free if u < 6), home=home)
    body = np.tile(np.eye(3).ravel(), (setups, 1))
    instrument = Instrument(
        "pose", np.hstack([state, body]), tuple(u for u in free if u >= 6) if known else free, home=home
    )
    assert found.rotations is not None
    for s in range(setups):
        chosen = np.flatnonzero((found.setup == s) & np.isfinite(found.rotations[:, 0, 0]))
        if len(chosen):
            part = found.subset(chosen)
            _, predicted = instrument.predict(part, x)
            assert part.rotations is not None
            assert predicted is not None
            body[s] = mean(np.swapaxes(predicted, 1, 2) @ part.rotations).ravel()
    return dataclasses.replace(instrument, state=np.hstack([state, body]))


def _touched(found: Readings, recording: Recording, x: Array) -> Instrument:
    """Return the points that are touched: a frame each, along the axes of {O}, in which the point reads zero."""
    names = contacts(recording).tolist()
    at = [x[found.rows[found.setup == s, 0], :3] for s in range(len(names))]
    state = [[*np.eye(3).ravel(), *(-P.mean(axis=0) if len(P) else np.zeros(3))] for P in at]
    ties = tuple((names.index(a), names.index(b), d) for a, b, d in recording.contact_distances)
    return Instrument(CONTACT, np.array(state), (3, 4, 5), ties=ties).tied()


def home_of(recording: Recording, robot: Robot) -> tuple[float, float, float]:
    """Return the home [mm] from which incremental positions count; {O} itself where they are absolute."""
    if recording.measurement.zero != "incremental" or "home" not in robot.geometry:
        return 0.0, 0.0, 0.0
    x, y, z = robot.geometry["home"].tolist()
    return x, y, z


def _camera(found: Readings, recording: Recording, x: Array, setups: int, known: bool) -> Instrument:
    """Return a camera that sees a ball; where the ball stands is unknown in any case, the camera's rotation may be.

    `rotation_deg` turns the axes of {O'} into the camera's.
    """
    camera = recording.measurement.camera
    assert camera is not None
    seen = sphere.centres(found.values, camera)
    nominal = from_vector(np.asarray(camera.rotation_deg) * DEG).T
    state = []
    for s in range(setups):
        chosen = found.setup == s
        P, c = x[found.rows[chosen, 0], :3], seen[chosen]
        turn = nominal if known or not chosen.any() else align(P.mean(axis=0) - P, c - c.mean(axis=0))
        ball = (P + c @ turn).mean(axis=0) if chosen.any() else np.zeros(3)
        state.append(sphere.state(camera, turn, ball, sphere.order(found.values)))
    scale = float(np.median(seen[:, 2])) / np.sqrt(camera.fx_px * camera.fy_px)
    return Instrument("sphere", np.array(state), (3, 4, 5) if known else tuple(range(6)), scale)


def _unknown(components: Sequence[int]) -> tuple[int, ...]:
    """Return the unknowns of an instrument (turn x y z, shift x y z, turn of the body x y z) that show in readings.

    In the plane x y an instrument turns about z and shifts along x and y.
    """
    if 2 in components:
        return tuple(range(9))
    return (2, 3, 4, 8) if 5 in components else (2, 3, 4)


def align(a: Array, b: Array) -> Array:
    """Return the rotation R (3, 3) that minimises |b - R a|^2 (Kabsch)."""
    if len(a) < 3:
        return np.eye(3)
    U, _, Vt = np.linalg.svd(b.T @ a)
    turn: Array = U @ np.diag([1.0, 1.0, np.sign(np.linalg.det(U @ Vt))]) @ Vt
    return turn
