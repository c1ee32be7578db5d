"""Noise of distances that share the points they lie between: where a point was read wrongly, all of them end wrongly.

A distance between points `a` and `b` has the noise ``u . (e_b - e_a)`` along its direction u, where e are the errors of
points, and a part of its own. Of two that end in one point the noise has half the shared part of the variance times the
cosine between them in common: so what a tracker computes of positions, or a caliper reads of printed marks, is told
from what a ball bar reads anew. The covariance is diagonal but for three directions of every point: its inverse root
costs a decomposition of these.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from deltacal_gen.estimation.correlated import FAINT, Correlated, Taken
from deltacal_gen.inference.noise import FLAT, NoiseModel
from deltacal_gen.inference.sizes import least
from deltacal_gen.instrument.kind import Readings
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording, numbered

LEAST_OWN = 1e-3  # part of the variance that is a reading's own, at least: what is computed of positions is rounded
ODDS = np.linspace(-3.0, float(np.log(1 / LEAST_OWN - 1)), 9)  # log of the shared part over the own, that are tried
PER_POINT = 12  # distances that are looked at for each point: four times as many as tell where it is
SPARE = 3  # distances more than follow, of which noise of their own is told
FOLLOWS = 0.1  # of the noise: the part of its own of a distance that others tell


def points_of(found: Readings, recording: Recording) -> tuple[np.ndarray, int]:
    """Return the points (R, 2) that distances lie between, by number, and how many there are.

    Every row is one. Where each holds an end of one distance alone, those of the same joints and tool are.
    """
    rows = found.used
    own = rows if len(rows) < found.rows.size else numbered(_places(recording))[rows]
    _, number = np.unique(own, return_inverse=True)
    return np.ravel(number)[np.searchsorted(rows, found.rows)], int(number.max(initial=-1)) + 1


def _places(recording: Recording) -> Array:
    tool = np.zeros((recording.n_rows, 3)) if recording.tool is None else np.nan_to_num(recording.tool)
    return np.round(np.column_stack([recording.joints, tool]), 9)


@dataclass(frozen=True, eq=False)
class Ends(Correlated):
    """Distances, the points that they lie between, and how much of their noise these have in common.

    Attributes
    ----------
    moved : (R, 3 points) array
        By how much a distance grows with the coordinates of all points.
    own : float
        Part of the variance that is each distance's own.
    weight : (R,) array, optional
        How much each reading counts, 1 fully; see `Series`.
    rho : float
        None: no distance tells of the next.
    unit : NoiseModel, optional
        Noise of an own part and a shared one, each of the variance 1, of distances that count fully; by default it is
        made of `moved`. What is decomposed of it is so for all sizes of these parts.
    """

    moved: Array
    own: float = 1.0
    weight: Array | None = None
    rho: float = 0.0
    unit: NoiseModel | None = None

    def __post_init__(self) -> None:
        if self.unit is None:
            n = len(self.moved)
            unit = NoiseModel(np.arange(n), np.ones(n), np.zeros(n), 0.0, self.moved / np.sqrt(2))
            object.__setattr__(self, "unit", unit)

    @staticmethod
    def of(found: Readings, recording: Recording, x: Array) -> Ends | None:
        """Return distances between machines that stand at x (N, 12); None of those that share no point, or are made."""
        a, b = found.rows.T if found.rows.shape[1] == 2 else np.zeros((2, 1), dtype=int)
        if found.made or found.values.shape[1] != 1 or (a == b).any():
            return None
        points, count = points_of(found, recording)
        if count == points.size:
            return None
        direction = x[b, :3] - x[a, :3]
        direction /= np.maximum(np.linalg.norm(direction, axis=1), FAINT)[:, None]
        moved, every = np.zeros((len(found), count, 3)), np.arange(len(found))
        moved[every, points[:, 1]] = direction
        moved[every, points[:, 0]] -= direction
        return Ends(moved.reshape(len(found), -1))

    @cached_property
    def rows_of_size(self) -> float:
        """So many tell as much of the size of noise as one whose noise is its own: mean square of correlations."""
        few = self.moved if self.moved.shape[0] <= self.moved.shape[1] else self.moved.T
        square = float(((few @ few.T) ** 2).sum()) / 4 / max(len(self.moved), 1)
        return 1 - (1 - self.own) ** 2 * (1 - square)

    @property
    def text(self) -> str:
        """What distances have in common, in words."""
        return (
            f"{1 - self.own:.0%} of the noise's variance is of the points between which distances lie, and shared by "
            f"all that end there: {self.rows:.1f} of them tell as much as one read anew"
        )

    @cached_property
    def noise(self) -> NoiseModel:
        """Noise of distances."""
        assert self.unit is not None
        noise = self.unit.sized(max(self.own, LEAST_OWN), 1 - self.own)
        more = 1 / self.counts(len(self.moved)) - 1
        return dataclasses.replace(noise, own=noise.own + more) if more.any() else noise

    def alone(self, values: Array) -> Array:
        """Return what all others do not tell of each distance (R, 1); noise of size 1 stays so."""
        return self.noise.alone(values)

    def parted(self, freed: Array, chosen: np.ndarray) -> Array:
        """Return of distances (R, ...) that are freed some, freed of one another alone."""
        raw = self.noise.restore(freed) * np.sqrt(self.counts(len(freed))).reshape(-1, *[1] * (freed.ndim - 1))
        return self.subset(chosen).freed(raw[chosen])

    def freed_among(self, values: Array, known: np.ndarray) -> Array:
        """Return distances (R, ...) freed of those that are known (R,), others zero."""
        out = np.zeros_like(values)
        out[known] = self.subset(known).freed(values[known])
        return out

    def subset(self, chosen: np.ndarray) -> Ends:
        """Return some of the distances."""
        weight = None if self.weight is None else self.weight[chosen]
        return dataclasses.replace(self, moved=self.moved[chosen], weight=weight, unit=None)

    def likeliest(self, z: Array, taken: Taken | None = None) -> tuple[Ends, float]:
        """Return the noise that explains distances (R, 1) best, beside what a fit took of them, and its deviance."""

        def tried(odds: float) -> Ends:
            return dataclasses.replace(self, own=1 / (1 + float(np.exp(odds))))

        (odds,), cost = least(
            lambda x: tried(*x).deviance(z, taken), ODDS[:, None], [ODDS[1] - ODDS[0]], [ODDS[[0, -1]]]
        )
        alone = dataclasses.replace(self, own=1.0)
        return min((tried(odds), cost), (alone, alone.deviance(z, taken)), key=lambda f: f[1])

    def leading(self, left: Array, noise: float) -> np.ndarray | None:
        """Return which distances the others follow from, where these have no noise of their own; None where they have.

        Points that are measured once have fewer coordinates than there are distances between them. What no error of
        points explains of what a fit leaves of them is each one's own noise, whatever machine was fitted.

        Parameters
        ----------
        left : (R,) array
            What a fit leaves [mm].
        noise : float
            Of a distance [mm].
        """
        from scipy.linalg import qr

        some = np.arange(len(self.moved))
        if len(some) > (most := PER_POINT * self.moved.shape[1] // 3):
            some = np.random.default_rng(len(some)).permutation(some)[:most]
        D = self.moved[some]
        R, order = qr(D.T, mode="r", pivoting=True, check_finite=False)
        size = np.abs(np.diagonal(R))
        rank = int((size > np.sqrt(FLAT) * size[0]).sum())
        if len(some) < rank + SPARE:
            return None
        rest = left[some] - D @ np.linalg.lstsq(D, left[some], rcond=np.sqrt(FLAT))[0]
        own = 1.4826 * float(np.median(np.abs(rest))) * np.sqrt(len(some) / (len(some) - rank))
        return None if own > FOLLOWS * noise else np.sort(some[order[:rank]])
