"""What a calibration is given: a robot and a recording, as values in internal units (mm, rad, kg).

How files say it, and what can be wrong with them, is the matter of ``robot`` and ``recording``. Importing this module
costs NumPy alone, so that arrays are identified as soon as a process has started.
"""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from deltacal_gen.results import shown
from deltacal_gen.units import DEG

if TYPE_CHECKING:
    import pandas as pd

    from deltacal_gen.files.robot import Masses, Transmission, Workspace
    from deltacal_gen.files.sidecar import Camera

POSITION = ("x_mm", "y_mm", "z_mm")
ROTATION = ("rx_deg", "ry_deg", "rz_deg")
TEMPERATURE = re.compile(r"temp_(\w+_)?C")


class Link(NamedTuple):
    """What a link of an open chain is, beside its dimensions.

    Parameters
    ----------
    kind : {"revolute", "prismatic", "fixed", "coupled"}
    convention : {"standard", "modified"}
        Of Denavit and Hartenberg.
    alpha : float
        Nominal twist [rad]: whether its axes are parallel.
    mass : float
        [kg]
    com : tuple of float
        Centre of mass in the link's frame [mm].
    coupling : tuple of (int, float)
        Of a coupled joint: numbers of the joints, from 1, and how much of each.
    inertia : tuple of float, optional
        Tensor about the centre of mass along the link frame's axes, xx, yy, zz, xy, xz, yz [kg mm^2].
    rotor_inertia : float, optional
        Of the drive, at the joint [kg mm^2; kg of one that slides].
    """

    kind: str
    convention: str
    alpha: float
    mass: float
    com: tuple[float, ...]
    coupling: tuple[tuple[int, float], ...] = ()
    inertia: tuple[float, ...] | None = None
    rotor_inertia: float | None = None


@dataclass(frozen=True, eq=False)
class Robot:
    """A machine as its drawings describe it, in internal units (mm, rad, kg).

    Parameters
    ----------
    name, mechanism : str
        The machine's own name, and the name of the mechanism it is an instance of.
    geometry : dict of (limbs,) or (n,) arrays
        Values by their key in the file; one per limb where the mechanism says so, else length 1 [mm or rad]. NaN where
        the file has no table [geometry]; see `drawn`.
    tool : (3,) array
        Reference point P in {O'} [mm].
    errors, tolerance : dict of float
        Actual minus nominal values of parameters, and their standard deviations [mm, rad or 1].
    workspace, masses, transmission : optional
        None where the file does not say.
    joint_sign : (limbs,) array
        -1 where the controller counts against the mechanism's positive direction.
    joint_limits : (limbs, 2) array, optional
        Lower and upper limit of each joint as the controller counts [rad or mm].
    source : Path, optional
        The file it was read from.
    links : tuple of Link
        Of an open chain, from the base; empty for other mechanisms.
    limits : dict of (float, float)
        Between what a channel can be set for an experiment, by its column in recordings, in its unit.
    """

    name: str
    mechanism: str
    geometry: dict[str, np.ndarray]
    tool: np.ndarray
    errors: dict[str, float]
    tolerance: dict[str, float]
    workspace: Workspace | None
    masses: Masses | None
    transmission: Transmission | None
    joint_sign: np.ndarray
    joint_limits: np.ndarray | None
    source: Path | None = None
    links: tuple[Link, ...] = ()
    limits: dict[str, tuple[float, float]] = field(default_factory=dict)

    def __repr__(self) -> str:
        return f"<Robot '{self.name}': {self.mechanism}>"

    @property
    def drawn(self) -> bool:
        """Whether the file says how the machine is built; readings of joints need not know."""
        return all(np.isfinite(values).all() for values in self.geometry.values())

    @property
    def geometric_limits(self) -> np.ndarray | None:
        """Limits of the joints (limbs, 2) as the geometry counts them, or None."""
        if self.joint_limits is None:
            return None
        return np.sort(self.joint_limits * self.joint_sign[:, None], axis=1)


@dataclass(frozen=True)
class Measurement:
    """What is known of a measurement beside its readings, in the units of the names; None where it is not said.

    `sigma_*` are standard deviations per coordinate. The points of a gauge are `base_point_mm`, in {O} as nominally
    mounted, and `platform_point_mm`, in {O'}. `board_scale` says whether a printed board is as large as it says,
    "known", or larger or smaller by a part that is "unknown". With ``zero = "incremental"`` readings count from the
    first row. `clock` says that the instrument has one of its own and what of it is alike in all runs,
    `clock_offset_s` where it stands in runs of which no result knows it.
    """

    kind: str | None = None
    frame: str = "unknown"
    sigma_mm: float | None = None
    sigma_deg: float | None = None
    sigma_px: float | None = None
    instrument: str | None = None
    operator: str | None = None
    zero: str = "absolute"
    base_point_mm: tuple[float, ...] | None = None
    platform_point_mm: tuple[float, ...] | None = None
    camera: Camera | None = None
    board_scale: str = "known"
    clock: str | None = None
    clock_offset_s: float | None = None

    def with_noise(self, unit: str, sigma: float) -> Measurement:
        """Return the same with a standard deviation in a unit: mm, deg or px."""
        said: dict[str, Any] = {f"sigma_{unit}": sigma}
        return dataclasses.replace(self, **said)

    @property
    def sigma_rad(self) -> float | None:
        """Standard deviation of measured angles [rad]."""
        return None if self.sigma_deg is None else self.sigma_deg * DEG


@dataclass(frozen=True, eq=False)
class Recording:
    """Readings of one machine, row by row.

    Parameters
    ----------
    path : Path or str
        The file; where there is none, what messages say for it.
    kind : str
        position, pose, distance, gauge, contact, height or sphere.
    measurement : Measurement
    joint_unit : str
        ``"rad"`` or ``"mm"``; of a chain with both, one by one: ``"rad,rad,mm"``.
    joints : (N, n_q) array
        Joints as the controller reports them [joint_unit]; nan where the file gives `targets` instead.
    columns : tuple of str
        Names of the measured columns in the file; their order is that of `measured`.
    measured : (N, n_y) array
        Readings [mm, rad or px], nan where not measured; n_y = 0 for the kinds distance and contact.
    pose : (N,) array of str
        Label of the pose; rows that share it are repeats.
    line : (N,) array of int
        Line in the file (row, counted from 1, of a Parquet file).
    channels : dict of (N,) arrays
        Every other numeric column, by its name and in its unit there; nan where not measured. Columns of other
        kinds of measurement are not among them.
    setup, setup_names : (N,) array of int, tuple of str
        Index into the names of the instrument's set-ups.
    tool : (N, 3) array, optional
        Measured point in {O'} [mm]; nan where the robot's own tool point holds.
    targets : (N, 3) array, optional
        Wanted positions in {O} [mm], of a file without joints; zero along an axis that the machine does not have. Of an
        open chain poses (N, 12) where the file gives rotations.
    contact : (N,) array of str, optional
        Which fixed point was touched; "" for none.
    contact_distances : tuple of (str, str, float)
        Known distances between fixed points [mm].
    pairs, pair_measured, pair_line : (K, 2), (K,), (K,) arrays, optional
        Rows between whose points a distance was measured, the distance [mm], its line in the file.
    doubts : dict of str
        Channels that were set aside, and why.
    """

    path: Path | str
    kind: str
    measurement: Measurement
    joint_unit: str
    joints: np.ndarray
    columns: tuple[str, ...]
    measured: np.ndarray
    pose: np.ndarray
    line: np.ndarray
    channels: dict[str, np.ndarray]
    setup: np.ndarray
    setup_names: tuple[str, ...]
    tool: np.ndarray | None = None
    targets: np.ndarray | None = None
    contact: np.ndarray | None = None
    contact_distances: tuple[tuple[str, str, float], ...] = ()
    pairs: np.ndarray | None = None
    pair_measured: np.ndarray | None = None
    pair_line: np.ndarray | None = None
    doubts: dict[str, str] = dataclasses.field(default_factory=dict)

    def __repr__(self) -> str:
        readings = self.n_rows if self.pairs is None else len(self.pairs)
        what = "targets" if self.targets is not None else f"readings of the kind {self.kind}"
        return f"<Recording: {readings} {what}, {Path(self.path).name}>"

    def to_dataframe(self) -> pd.DataFrame:
        """Return what its file would hold, as a data frame; of distances those alone. Needs pandas."""
        return shown.recorded(self)

    @property
    def n_rows(self) -> int:
        """Number of rows, N."""
        return len(self.joints)

    @property
    def components(self) -> tuple[int, ...]:
        """Which of a body's six coordinates (x y z, rotation about x y z) the columns of a position or pose hold."""
        return tuple((*POSITION, *ROTATION).index(name) for name in self.columns if name in POSITION + ROTATION)

    @property
    def time_s(self) -> np.ndarray | None:
        """(N,) time [s], or None."""
        return self.channels.get("time_s")

    @property
    def payload_kg(self) -> np.ndarray | None:
        """(N,) payload [kg], or None."""
        return self.channels.get("payload_kg")

    def subset(self, rows: np.ndarray | Sequence[int] | slice) -> Recording:
        """The recording with these rows only (indices, mask or slice); pairs keep both their rows or go."""
        rows = np.arange(self.n_rows)[rows]
        per_row = ("joints", "measured", "pose", "line", "setup", "tool", "targets", "contact")
        picked: dict[str, Any] = {name: None if (a := getattr(self, name)) is None else a[rows] for name in per_row}
        channels = {name: values[rows] for name, values in self.channels.items()}
        part = dataclasses.replace(self, channels=channels, **picked)
        if self.pairs is None:
            return part
        position = np.full(self.n_rows, -1)
        position[rows] = np.arange(len(rows))
        pairs = position[self.pairs]
        return dataclasses.replace(part, pairs=pairs).subset_pairs((pairs >= 0).all(axis=1))

    def subset_pairs(self, pair_rows: np.ndarray | Sequence[int] | slice) -> Recording:
        """The recording with these distances only (indices, mask or slice), all rows kept."""
        if self.pairs is None or self.pair_measured is None or self.pair_line is None:
            raise ValueError("this recording holds no distances between rows")
        k = np.arange(len(self.pairs))[pair_rows]
        return dataclasses.replace(
            self, pairs=self.pairs[k], pair_measured=self.pair_measured[k], pair_line=self.pair_line[k]
        )
