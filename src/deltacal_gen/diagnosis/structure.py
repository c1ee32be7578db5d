"""What is left of a fit that is no noise: smooth terms along a channel or over the workspace, which know no physics.

They are the rivals of every effect, and they say where a mismatch sits that no effect explains: along which channel,
at which limbs or in the reading, in which region.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.beside import Beside
from deltacal_gen.diagnosis.charges import MOST_SETS, best_set, gains, quantile
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.system import in_unit_noise
from deltacal_gen.inference.functions import bumps, farthest, waves
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.rotation import swept
from deltacal_gen.states import APPROACH
from deltacal_gen.units import joint_names

FEWEST_NEIGHBOURS = 20  # poses, without which their likeness tells nothing
FUNCTIONS = 6  # of a channel, that one structure may combine
SMOOTH = 15  # functions of a channel that make any smooth dependence on it: three powers, six waves
LEVELS = 4  # distinct values up to which a channel is taken as levels
WAVES = 40  # periods over the span of a channel, at most
CENTRES = 24  # of local functions over the workspace
RADII = (0.15, 0.25, 0.4)  # of local functions, parts of the workspace's half span

Region = tuple[tuple[float, float, float], float]


@dataclass(frozen=True)
class Structure:
    """Dependence on a channel: gain in chi2, the charge for the functions used, and where it sits.

    Attributes
    ----------
    limbs : tuple of int
        Limbs whose joints carry it; empty where the reading does.
    region : ((x, y, z), radius) or None
        [mm], where it is local.
    """

    channel: str
    gain: float
    charge: float
    limbs: tuple[int, ...] = ()
    region: Region | None = None

    @property
    def earned(self) -> float:
        """Gain beyond the charge."""
        return self.gain - self.charge


def structures(at: Fit) -> list[Structure]:
    """Return what smooth terms along each channel explain of what a fit leaves, the strongest first."""
    smooth = Displaced(at, Beside(at))
    found = [smooth.along(name, functions, places) for name, (functions, places) in _bases(at.problem).items()]
    return sorted(found, key=lambda f: -f.earned)


def alike(at: Fit) -> tuple[float, float]:
    """Return how what a fit leaves correlates between neighbouring poses, and in how many standard deviations.

    Noise knows nothing of the joints. What the machine does and the model does not is alike where the joints are.
    """
    found = at.problem.readings
    if found.rows.shape[1] != 1:
        return 0.0, 0.0
    read = np.isfinite(at.residual)
    z = in_unit_noise(at.residual, read, at.sigma, at.weights, at.repeats)[:, read.any(axis=0)]
    first = np.unique(found.group, return_index=True)[1]
    means = np.array([z[found.group == g].mean(axis=0) for g in np.unique(found.group)])
    q = at.problem.body.q[found.rows[first, 0]]
    q = q / np.maximum(np.std(q, axis=0), 1e-12)
    if len(q) < FEWEST_NEIGHBOURS:
        return 0.0, 0.0
    from scipy.spatial import cKDTree

    _, near = cKDTree(q).query(q, k=2)
    pairs = np.unique(np.sort(np.column_stack([np.arange(len(q)), near[:, 1]]), axis=1), axis=0)
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    a, b = means[pairs[:, 0]].ravel(), means[pairs[:, 1]].ravel()
    size = np.sqrt(np.mean(a**2) * np.mean(b**2))
    correlation = float(np.mean(a * b) / max(size, 1e-300))
    return correlation, correlation * np.sqrt(len(a))


def returning(at: Fit) -> tuple[float, float]:
    """Return how what a fit leaves correlates between visits of a pose, and in how many standard deviations.

    Visits as near to one another as noise hangs together tell nothing.
    """
    found = at.problem.readings
    if found.rows.shape[1] != 1:
        return 0.0, 0.0
    visits = [np.flatnonzero(found.group == g) for g in np.unique(found.group)]
    pairs = np.vstack([np.column_stack([v[: len(v) - len(v) // 2], v[len(v) // 2 :]]) for v in visits])
    pairs = pairs[np.diff(found.rows[pairs, 0], axis=1)[:, 0] > at.repeats.rows]
    if len(pairs) < FEWEST_NEIGHBOURS:
        return 0.0, 0.0
    z = np.nan_to_num(at.residual / at.sigma)
    correlation = float(np.sum(z[pairs[:, 0]] * z[pairs[:, 1]]) / max(np.sum(z[pairs] ** 2) / 2, 1e-300))
    return correlation, correlation * np.sqrt(len(pairs))


def smooth_columns(at: Fit, channel: str) -> Array:
    """Return whitened columns (scalars, n) of any smooth dependence on a channel, of the joints and of the reading."""
    smooth, (functions, _) = Displaced(at, beside := Beside(at)), _bases(at.problem)[channel]
    most = max(beside.readings // (4 * smooth.directions), 1)
    return smooth.modulated(functions[:, : min(SMOOTH, most)])


def _turns(x: Array, n_x: int) -> Array:
    """Return the derivatives (N, n_x, 3) of poses (N, 12) by turns of the instrument about what it measures."""
    out = np.zeros((len(x), 6, 3))
    out[:, :3] = swept(x[:, :3] - x[:, :3].mean(axis=0))
    out[:, 3:] = np.eye(3)
    return out[:, :n_x]


def by_instrument(at: Fit, beside: Beside, functions: Array) -> Array:
    """Return whitened columns (scalars, n) of what readings do where the instrument moves by functions (R, m) of them.

    It shifts and, where it reads positions, turns.
    """
    of_rows = np.zeros((len(at.machine.x), functions.shape[1]))
    of_rows[at.problem.readings.rows[:, 0]] = functions
    return Displaced(at, beside).columns(of_rows, at.problem.mechanism.limbs).reshape(beside.readings, -1)


class Displaced:
    """Displacements of each joint and of the reading, modulated by functions of the rows, beside all that is fitted.

    A reading of positions is displaced as the instrument moves, which shifts and turns: on a stand that creeps or was
    knocked, it does both.
    """

    def __init__(self, at: Fit, beside: Beside) -> None:
        problem = at.problem
        self._beside, self._limbs = beside, problem.mechanism.limbs
        self._dx, self._seen = problem.displacements(beside.machine), problem.seen(beside.machine)
        if problem.readings.kind.positions:
            self._dx = np.concatenate([self._dx, _turns(beside.machine.x, self._dx.shape[1])], axis=2)

    @property
    def directions(self) -> int:
        """Number of joints and axes of the reading."""
        return int(self._dx.shape[2])

    def columns(self, functions: Array, first: int = 0) -> Array:
        """Return whitened columns (scalars, m, directions) of functions (N, m) of the rows, from a direction on."""
        at, dx = self._beside.fit, self._dx[:, :, None, first:] * functions[:, None, :, None]
        J, _ = at.instrument.linearise(at.problem.readings, self._seen, dx.reshape(*dx.shape[:2], -1))
        return self._beside.rows(J).reshape(self._beside.readings, functions.shape[1], -1)

    def modulated(self, functions: Array) -> Array:
        """Return whitened unit columns (scalars, m * directions) of functions (N, m) of the rows."""
        A = self.columns(functions).reshape(self._beside.readings, -1)
        unit: Array = A / np.maximum(np.linalg.norm(A, axis=0), 1e-300)
        return unit

    def along(self, channel: str, functions: Array, places: Sequence[Region | None]) -> Structure:
        """Return what the best few functions (N, m) of a channel explain, charged for columns and choice."""
        A, count = self.modulated(functions), functions.shape[1]
        A -= self._beside.Q @ (self._beside.Q.T @ A)
        apart = A.reshape(len(A), count, -1)
        # what only shifts is not charged for turns, but for the choice
        widths = sorted({self._limbs + 3, self.directions})
        chosen, gain, charge = max(
            (self._chosen(apart[:, :, :width], quantile(width, len(widths) * count)) for width in widths),
            key=lambda found: found[1] - found[2],
        )
        limbs = self._sits(np.moveaxis(apart[:, chosen], 1, 0)) if chosen else ()
        region = places[chosen[0]] if chosen else None
        return Structure(channel, gain, charge, () if region is not None else limbs, region)

    def _chosen(self, apart: Array, price: float) -> tuple[list[int], float, float]:
        """Return which functions of columns (scalars, m, directions) pay their price, their gain and charge."""
        r, count = self._beside.residual, apart.shape[1]
        A = apart.reshape(len(apart), -1)
        # products of what is left of the columns when chosen ones are taken out: only they change
        G = np.array([apart[:, k].T @ apart[:, k] for k in range(count)])
        b = (r @ A).reshape(count, -1)
        chosen: list[int] = []
        taken = np.zeros((len(r), 0))
        left, gain = r, 0.0
        for _ in range(min(FUNCTIONS, count)):
            each = gains(G, b)
            k = int(np.argmax(each))
            if each[k] < price:
                break
            chosen.append(k)
            U, s, _ = np.linalg.svd(apart[:, k] - taken @ (taken.T @ apart[:, k]), full_matrices=False)
            U = U[:, s > 1e-3]
            shares, along = (U.T @ A).reshape(U.shape[1], count, -1), U.T @ left
            G -= np.einsum("umi,umj->mij", shares, shares)
            b -= np.einsum("umi,u->mi", shares, along)
            taken, left = np.hstack([taken, U]), left - U @ along
            gain = float(r @ r - left @ left)
        return chosen, gain, price * len(chosen)

    def _sits(self, A: Array) -> tuple[int, ...]:
        """Return the limbs whose joints carry what functions (m, scalars, directions) explain; none: the reading."""
        every, shifts = range(self._limbs), range(self._limbs, self._limbs + 3)
        reading = {tuple(shifts), tuple(range(self._limbs, A.shape[2]))}  # which shifts, or turns as well

        def worth(sets: Sequence[Sequence[int]]) -> list[float]:
            found = []
            for own in sets:
                columns = np.hstack(list(A[:, :, list(own)]))
                gain = gains((columns.T @ columns)[None], (self._beside.residual @ columns)[None])[0]
                found.append(float(gain - columns.shape[1] * np.log(self._beside.readings)))
            return found

        if self._limbs > MOST_SETS:
            sets = [*sorted(reading), best_set(list(every), worth)[0]]
        else:
            sets = [*sorted(reading), *(s for n in range(1, self._limbs + 1) for s in itertools.combinations(every, n))]
        return tuple(i + 1 for i in sets[int(np.argmax(worth(sets)))] if i in every)


def _bases(problem: Problem) -> dict[str, tuple[Array, list[Region | None]]]:
    """Return functions (N, m) of every channel, joint and of the position; of local ones, where they sit."""
    recording, body = problem.recording, problem.body
    rows = np.unique(problem.readings.rows)
    out: dict[str, tuple[Array, list[Region | None]]] = {}
    n_q = body.q.shape[1]
    named = dict(zip(joint_names(recording.joint_unit, n_q), body.q.T, strict=True))
    moving = dict(zip(joint_names(recording.joint_unit, n_q, APPROACH), body.q.T, strict=True))
    for name, values in {**recording.told, **named}.items():
        if not np.isfinite(values[rows]).any():
            continue
        v = np.nan_to_num(values, nan=float(np.nanmedian(values[rows])))
        if np.ptp(v[rows]) > 0:
            functions = _functions(v, rows)
            if name in moving and np.ptp(moving[name][rows]) > 0:  # play is wide where a gear is worn
                functions = np.hstack([functions, v[:, None] * _functions(moving[name], rows)])
            out[name] = functions, [None] * functions.shape[1]
    if problem.readings.kind.sees_joints:
        return out
    x, _ = body.mechanism.forward(body.q, body.tool, body.mechanism.rows(problem.robot))
    x = np.nan_to_num(x[:, :3])
    span = float(np.linalg.norm(np.ptp(x[rows], axis=0))) / 2
    centres = x[rows[farthest(x[rows], CENTRES)]]
    radii = [part * span for part in RADII]
    about = [(float(x), float(y), float(z)) for x, y, z in centres]
    places: list[Region | None] = [(centre, radius) for radius in radii for centre in about]
    out["position"] = np.hstack([bumps(x, centres, radius) for radius in radii]), places
    return out


def _functions(v: Array, rows: np.ndarray) -> Array:
    """Return functions (N, m) of a channel: its levels where it has few values, powers and waves where it has many."""
    levels = np.unique(v[rows])
    if len(levels) <= LEVELS:
        return np.column_stack([(v == level).astype(float) for level in levels[1:]])
    t = (v - v[rows].min()) / np.ptp(v[rows])
    s = 2 * t - 1
    most = int(np.clip(len(levels) // 4, 2, WAVES))
    return np.column_stack([s, s**2 - 1 / 3, s**3 - 0.6 * s, waves(2 * np.pi * t, most)])
