"""What readings of one pose say of noise: their differences, less what channels that differ between them make of these.

Where enough repeats have every channel but time alike, they are taken as they are. Otherwise what varies smoothly with
the channels, by each joint and by the reading, is taken out of the differences: that holds whatever was recorded.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.residuals import Repeats, lengths
from deltacal_gen.inference.projection import project_out
from deltacal_gen.instrument.kind import Readings
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording, numbered
from deltacal_gen.physics.motion import with_motion
from deltacal_gen.states import of_column

ENOUGH = 12  # degrees of freedom, without which repeats say nothing of noise
POWERS = (3, 2, 1)  # of a channel, up to which it is taken out: as many as the repeats carry
MOST_TAKEN = 0.5  # of the degrees of freedom
UNSEEN = 1e-6  # of the largest singular value: less is a combination of other columns
FEW_LEVELS = 8  # values of a channel that is switched: directions, payloads
ALIKE = 0.1  # of a channel's span: values that differ by less are of one level


@dataclass(frozen=True)
class Shown:
    """The spread within poses.

    Attributes
    ----------
    rows : (R, k) array
        Readings whose differences within a group are noise [mm].
    group : (R,) int array
    variance : float
        Of one component [mm^2].
    degrees : int
        On which it rests.
    """

    rows: Array
    group: np.ndarray
    variance: float
    degrees: int

    @classmethod
    def of(cls, final: Fit, group: np.ndarray) -> Shown:
        """Return the spread of what a fit leaves within groups (R,) of its readings, gross errors left out."""
        r, quiet = _quiet(final)
        return cls(r, group[quiet], *Repeats.ratio_of(r, group[quiet])[1:])

    @property
    def closest(self) -> float:
        """The noise that the closest quarter of repeats speaks for, as if noise were normal [mm]."""
        order = np.argsort(self.group, kind="stable")
        together = self.group[order][1:] == self.group[order][:-1]
        gaps = np.abs(np.diff(self.rows[order], axis=0)[together])
        return float(np.quantile(gaps, 0.25) / (0.3186 * np.sqrt(2.0)))


def repeats(final: Fit, recording: Recording) -> Shown:
    """Return what repeats show of the noise, gross errors left out."""
    found = final.problem.readings
    channels, same = _channels(found, recording), of_one_point(found)
    levels = [_levels(v) for n, v in channels.items() if not of_column(n).passes]
    alike = Shown.of(final, numbered(np.column_stack([same, *levels])))
    if alike.degrees >= ENOUGH or not channels or not all(np.isfinite(v).all() for v in channels.values()):
        return alike
    return _smoothed(final, same, channels) or alike


def within_poses(final: Fit) -> Shown:
    """Return the spread within poses whatever the channels were: noise is no more than that."""
    return Shown.of(final, of_one_point(final.problem.readings))


def _quiet(final: Fit) -> tuple[Array, np.ndarray]:
    """Return what a fit leaves (Q, k) [mm], gross errors left out, and of which readings (Q,)."""
    quiet = np.setdiff1d(np.arange(len(final.residual)), final.gross)
    return np.nan_to_num(lengths(final.residual, final.problem.readings.kind))[quiet], quiet


def of_one_point(found: Readings) -> np.ndarray:
    """Return groups (R,) of readings of one pose and of the same point: those of a printed board see others."""
    if found.known is None:
        return found.group
    return numbered(np.column_stack([found.group, found.known]))


def _smoothed(final: Fit, same: np.ndarray, channels: Mapping[str, Array]) -> Shown | None:
    """Return the spread within poses beside what varies smoothly with channels; None where too little is left."""
    r, quiet = _quiet(final)
    group = numbered(same[quiet, None])
    several = (np.bincount(group)[group] > 1).nonzero()[0]
    degrees = (len(several) - len(np.unique(group[several]))) * r.shape[1]
    if degrees < ENOUGH:
        return None
    J = final.by_displacements
    read = ~np.isin(np.arange(J.shape[1]), final.problem.readings.kind.turned) & np.isfinite(final.residual).any(axis=0)
    J, y = np.nan_to_num(J[quiet][:, read]), about_means(r, group)[several].ravel()
    scaled = [np.interp(v[quiet], (v[quiet].min(), v[quiet].max()), (-1.0, 1.0)) for v in channels.values()]
    for most in POWERS:
        F = np.column_stack([v**k for v in scaled for k in range(1, most + 1)])
        moved = (J[..., None] * F[:, None, None]).reshape(len(r), -1)
        U, size, _ = np.linalg.svd(about_means(moved, group)[several].reshape(len(y), -1), full_matrices=False)
        Q = U[:, size > UNSEEN * size.max(initial=0.0)]
        spare = degrees - Q.shape[1]
        if spare >= max(ENOUGH, (1 - MOST_TAKEN) * degrees):
            left = project_out(y, Q)
            rows = left.reshape(len(several), -1) * np.sqrt(degrees / spare)
            return Shown(rows, group[several], float(left @ left) / spare, spare)
    return None


def about_means(values: Array, group: np.ndarray) -> Array:
    """Return values (R, n) less the mean of their group."""
    own = np.unique(group, return_inverse=True)[1]
    sums = np.zeros((int(own.max()) + 1, values.shape[1]))
    np.add.at(sums, own, values)
    apart: Array = values - (sums / np.bincount(own)[:, None])[own]
    return apart


def _channels(found: Readings, recording: Recording) -> dict[str, Array]:
    """Return the channels (R,) of readings of one row each, the way joints came among them; those that vary."""
    if found.rows.shape[1] != 1:
        return {}
    every = {n: v[found.rows[:, 0]] for n, v in sorted(with_motion(recording).told.items())}
    return {n: v for n, v in every.items() if (v != v[0]).any()}


def _levels(values: Array) -> Array:
    """Return what counts as one level (N,) of a channel: each value of a few, else values that hardly differ.

    A thermometer never stands still. What an effect makes of a part of its span is as small a part of that effect.
    """
    finite = values[np.isfinite(values)]
    if len(np.unique(finite)) <= FEW_LEVELS:
        return np.nan_to_num(values, nan=-1e9)
    low, high = np.quantile(finite, [0.05, 0.95])
    levels: Array = np.nan_to_num(np.floor((values - low) / max(ALIKE * (high - low), 1e-300)), nan=-1e9)
    return levels
