"""What a calibration is given: a robot and a recording, as values in internal units (mm, rad, kg).

How files say it, and what can be wrong with them, is the matter of ``robot`` and ``recording``. Importing this module
costs NumPy alone, so that arrays are identified as soon as a process has started.
"""

from __future__ import annotations

import dataclasses
import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, NamedTuple

import numpy as np

from deltacal_gen.states import PAYLOAD, TIME
from deltacal_gen.units import DEG

if TYPE_CHECKING:
    from deltacal_gen.results.parts import SeriesMade

POSITION = ("x_mm", "y_mm", "z_mm")
TOOL_ERRORS = ("tx", "ty", "tz")  # of machines that turn what they carry
ROTATION = ("rx_deg", "ry_deg", "rz_deg")
TRUTH = "true_"  # so begin the columns of what only a simulation knows
UNKNOWN = math.nan  # what is to be found
LONG_BEFORE = 10.0  # times a recording's own length: stamps that begin so late count from another day


def numbered(rows: np.ndarray) -> np.ndarray:
    """Return the number (N,) of each of the different rows (N, k) that a row is, in ascending order; NaN equals none.

    NumPy's ``unique`` of rows has the same numbers as its inverse; it compares rows field by field, which takes long.
    """
    order = np.argsort(rows[:, 0], kind="stable")
    if not (np.diff(rows[order, 0]) > 0).all():  # mostly the first column is enough
        order = np.lexsort(rows.T[::-1])
    placed = rows[order]
    found = np.zeros(len(rows), dtype=int)
    found[order[1:]] = np.cumsum((placed[1:] != placed[:-1]).any(axis=1))
    return found


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


@dataclass(frozen=True)
class Workspace:
    """Where the machine works [mm]: a cylinder about z; for planar machines a rectangle; for a single joint a stroke.

    `top` is the distance from the base plane to the first layer, `radius` (or `width`) and `height` are its size; a
    stroke, along x, has a width only. A platform that turns on command turns by up to `turn` [deg] either way. On which
    side of the base the layers lie, and which way they go on, `layers`, is the mechanism's.
    """

    top: float | None = None
    radius: float | None = None
    width: float | None = None
    height: float | None = None
    turn: float | None = None
    layers: tuple[int, int] = (-1, -1)

    @property
    def levels(self) -> tuple[float, float]:
        """Where the first layer and the last one lie along z, or along y of a rectangle."""
        side, way = self.layers
        first = side * (self.top or 0.0)
        return first, first + way * (self.height or 0.0)

    def place(self, across: Any, part: Any) -> np.ndarray[Any, np.dtype[np.float64]]:
        """Return positions (N, 3) in {O}: `across` (N, 2) of a cylinder, or (N,) along x, at parts of the height."""
        first, last = self.levels
        level = first + np.asarray(part, dtype=float) * (last - first)
        across = np.asarray(across, dtype=float)
        if self.radius is not None:
            return np.column_stack([across, np.broadcast_to(level, len(across))])
        return np.column_stack([across, np.broadcast_to(level, len(across)), np.zeros(len(across))])

    @property
    def home(self) -> np.ndarray[Any, np.dtype[np.float64]]:
        """Its centre, (3,)."""
        centre: np.ndarray[Any, np.dtype[np.float64]] = self.place(np.zeros((1, 2) if self.radius else 1), 0.5)[0]
        return centre

    @property
    def box(self) -> tuple[np.ndarray[Any, np.dtype[np.float64]], np.ndarray[Any, np.dtype[np.float64]]]:
        """Its centre and its half size, (3,) each; no size along axes in which the machine does not move."""
        half = (self.height or 0.0) / 2
        if self.radius is not None:
            return self.home, np.array([self.radius, self.radius, half])
        return self.home, np.array([(self.width or 0.0) / 2, half, 0.0])

    def holds(
        self, positions: np.ndarray[Any, np.dtype[np.float64]], within: float = 0.0
    ) -> np.ndarray[Any, np.dtype[np.bool_]]:
        """Tell which positions (N, 3) lie within, by so much at least [mm]."""
        centre, half = self.box
        across = np.hypot(*positions[:, :2].T) <= self.radius - within if self.radius is not None else True
        inside = np.abs(positions - centre) <= np.where(half > 0, half - within, 0.0)
        if self.top is None:  # of a stroke only x counts
            return np.asarray(inside[:, 0])
        return np.asarray(across & inside.all(axis=1))


@dataclass(frozen=True)
class Masses:
    """Moving masses [kg]; one that is not given counts as zero.

    `proximal` is one arm with its centre of mass at `proximal_com` of its length, `distal_rod` one of the rods,
    `platform` sits at O', `carriage` is that of a sliding joint. `gravity` is (3,) in {O} [m/s^2 = N/kg];
    `proximal_inertia` is an arm's own inertia about its centre of mass [kg mm^2], `distal_inertia` that of a rod,
    across it: None for those of slender rods. `rotor_inertia` turns with the joint [kg mm^2].
    """

    proximal: float = 0.0
    proximal_com: float = 0.5
    distal_rod: float = 0.0
    platform: float = 0.0
    carriage: float | None = None
    gravity: tuple[float, ...] = (0.0, 0.0, -9.81)
    proximal_inertia: float | None = None
    distal_inertia: float | None = None
    rotor_inertia: float | None = None

    @property
    def numbers(self) -> dict[str, float]:
        """Masses and inertias that are given, by name, in the order of the file."""
        each = ((f.name, getattr(self, f.name)) for f in dataclasses.fields(self) if f.name != "gravity")
        return {name: value for name, value in each if value is not None}


@dataclass(frozen=True)
class Transmission:
    """What is between motor and joint.

    `gear_ratio` in motor turns per joint turn, `encoder_counts` per motor turn, `pulley_circumference` in mm of belt
    per motor turn, `torque_constant_Nm_A` what each joint gets of an ampere.
    """

    gear_ratio: float | None = None
    encoder_counts: float | None = None
    pulley_circumference: float | None = None
    torque_constant_Nm_A: tuple[float, ...] | None = None


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
    def unsaid(self) -> tuple[str, ...]:
        """The source errors of which the file leaves open more than parts are off, of machines that have them.

        No reflector sits in the origin of a flange: a tool point of zeros is one that nobody has written down.
        """
        return () if self.tool.any() else TOOL_ERRORS

    @property
    def geometric_limits(self) -> np.ndarray | None:
        """Limits of the joints (limbs, 2) as the geometry counts them, or None."""
        if self.joint_limits is None:
            return None
        return np.sort(self.joint_limits * self.joint_sign[:, None], axis=1)


@dataclass(frozen=True)
class Camera:
    """Pinhole camera: focal lengths and principal point [px], Brown's distortion as in OpenCV, and what it looks at.

    Of a ball the rotation vector from {O'} [deg] and the radius [mm]. Of a board what is left out of the first four, or
    "unknown", is to be found: NaN here. The camera sits on the platform, on the last link of a chain, or is fixed and
    looks at a board there.
    """

    fx_px: float = UNKNOWN
    fy_px: float = UNKNOWN
    cx_px: float = UNKNOWN
    cy_px: float = UNKNOWN
    k1: float = 0.0
    k2: float = 0.0
    p1: float = 0.0
    p2: float = 0.0
    k3: float = 0.0
    rotation_deg: tuple[float, ...] = (0.0, 0.0, 0.0)
    ball_radius_mm: float = UNKNOWN
    place: Literal["platform", "fixed"] = "platform"


@dataclass(frozen=True)
class Measurement:
    """What is known of a measurement beside its readings, in the units of the names; None where it is not said.

    `sigma_*` are standard deviations per coordinate. The points of a gauge are `base_point_mm`, in {O} as nominally
    mounted, and `platform_point_mm`, in {O'}. `board_scale` says whether a printed board is as large as it says,
    "known", or larger or smaller by a part that is "unknown". With ``zero = "incremental"`` readings count from the
    first row. `clock` says that the instrument has one of its own and what of it is alike in all runs,
    `clock_offset_s` where it stands in runs of which no result knows it. `rotation` says what a file's three angles
    of a rotation are: a rotation vector, or turns about x, y, z in an order; a recording that was read has vectors.
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
    rotation: str = "vector"

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
    repairs : tuple of str
        What was put right or left out of samples in motion, with the line.
    motion : SeriesMade, optional
        How channels were made of joints in motion, where they were.
    begun : float, optional
        From when effects count the time [s], of another recording that this one is held against; its own: `origin`.
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
    repairs: tuple[str, ...] = ()
    motion: SeriesMade | None = None
    begun: float | None = None

    def __repr__(self) -> str:
        readings = self.n_rows if self.pairs is None else len(self.pairs)
        what = "targets" if self.targets is not None else f"readings of the kind {self.kind}"
        return f"<Recording: {readings} {what}, {Path(self.path).name}>"

    @property
    def n_rows(self) -> int:
        """Number of rows, N."""
        return len(self.joints)

    @property
    def components(self) -> tuple[int, ...]:
        """Which of a body's six coordinates (x y z, rotation about x y z) the columns of a position or pose hold."""
        return tuple((*POSITION, *ROTATION).index(name) for name in self.columns if name in POSITION + ROTATION)

    @property
    def told(self) -> dict[str, np.ndarray]:
        """The channels, but for those that only a simulation knows: no answer goes by the truth."""
        return {name: values for name, values in self.channels.items() if not name.startswith(TRUTH)}

    @property
    def time_s(self) -> np.ndarray | None:
        """(N,) time [s], or None."""
        return self.channels.get(TIME)

    @property
    def origin(self) -> float:
        """From when effects count the time [s]: 0, or the first reading where stamps count from long before it.

        A drift that had gone on since 1970 would be nothing but where everything stands.
        """
        time = self.time_s
        if self.begun is not None or time is None or not np.isfinite(time).any():
            return self.begun or 0.0
        first, last = float(np.nanmin(time)), float(np.nanmax(time))
        return first if first > LONG_BEFORE * (last - first) else 0.0

    @property
    def numbers(self) -> np.ndarray | None:
        """(N,) numbers of the poses, where they are numbered in the order in which they were measured; else None."""
        if not np.char.isdigit(self.pose).all():
            return None
        found = self.pose.astype(np.int64)
        return found if (np.diff(found) >= 0).all() else None

    @property
    def begins_anew(self) -> bool:
        """Whether time begins anew with some run, so that two runs stand at one time."""
        time, run = self.time_s, self.channels.get("run")
        if time is None or run is None:
            return False
        ends = sorted((float(time[run == k].min()), float(time[run == k].max())) for k in np.unique(run[run == run]))
        return any(begin < end for (_, end), (begin, _) in itertools.pairwise(ends))

    @property
    def payload_kg(self) -> np.ndarray | None:
        """(N,) payload [kg], or None."""
        return self.channels.get(PAYLOAD)

    def subset(self, rows: np.ndarray | Sequence[int] | slice) -> Recording:
        """Return the recording with these rows only (indices, mask or slice); pairs keep both their rows or go."""
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
        """Return the recording with these distances only (indices, mask or slice), all rows kept."""
        if self.pairs is None or self.pair_measured is None or self.pair_line is None:
            raise ValueError("this recording holds no distances between rows")
        k = np.arange(len(self.pairs))[pair_rows]
        return dataclasses.replace(
            self, pairs=self.pairs[k], pair_measured=self.pair_measured[k], pair_line=self.pair_line[k]
        )


def poses_of(recording: Recording) -> np.ndarray:
    """Return the pose (N,) of each row: label or, where there are no labels, joints; with set-up and measured point.

    Samples of runs are of one pose as long as the joints stand: what passes there, or comes back, comes differently.
    """
    _, label = np.unique(recording.pose, return_inverse=True)
    tool = np.zeros((recording.n_rows, 3)) if recording.tool is None else np.nan_to_num(recording.tool)
    if label.max(initial=-1) + 1 == recording.n_rows and recording.pairs is None:
        key = np.round(np.column_stack([recording.joints, tool, recording.setup]), 9)
        if (run := recording.channels.get("run")) is not None:
            went = np.any(np.diff(np.column_stack([key, run]), axis=0, prepend=np.nan) != 0, axis=1)
            key = np.cumsum(went)[:, None]
        return numbered(key)
    return numbered(np.round(np.column_stack([label, recording.setup, tool]), 9))
