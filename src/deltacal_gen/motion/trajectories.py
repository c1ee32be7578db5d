"""Recordings in motion: samples in time, run by run, of joints and of what their drives gave.

What is wrong in a file is an error with its line and column, or is put right and said so: nothing is passed over.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar, Literal

import numpy as np

from deltacal_gen.errors import MissingColumn, WrongKind
from deltacal_gen.files.columns import DRIVE, sidecar_path
from deltacal_gen.files.logged import increasing, logged
from deltacal_gen.files.rows import Rows, read_table
from deltacal_gen.files.sidecar import Clocks, Noise
from deltacal_gen.files.toml import Number, Table, TomlFile
from deltacal_gen.physics.proportion import LONGEST_SPIKE, out_of_proportion
from deltacal_gen.physics.splines import ordinary_step, pieces_of
from deltacal_gen.results.reader import KINDS_IN_MOTION
from deltacal_gen.states import ACCELERATIONS, PAYLOAD, SPEEDS, STATES, TIME
from deltacal_gen.units import joint_factors, joint_names, of_joints

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array, Machine

TURNS_ON = 5.0  # times what a joint ordinarily moves from sample to sample: so much it may beside a whole turn
MOVES = 1e-2  # rad: what it may at least
WITHIN = 0.01, 0.99  # quantiles between which angles lie: what begins anew after a turn never leaves it, but for spikes
INSIDE = {"Nm": 1000.0, "N": 1.0, "A": 1.0, "1": 1.0}  # of a unit in files: N mm, N, A, 1


class _Measurement(Table):
    kind: str
    sigma_Nm: Noise | None = None
    sigma_N: Noise | None = None
    sigma_A: Noise | None = None
    sigma_1: Noise | None = None
    clock: Clocks | None = None
    clock_offset_s: Number | None = None
    instrument: str | None = None
    operator: str | None = None


class _Motion(Table):
    derivatives: Literal["recorded", "velocity recorded"] | None = None


class Sidecar(Table):
    """The sidecar of a recording in motion."""

    measurement: _Measurement
    motion: _Motion = _Motion()


@dataclass(frozen=True)
class Readout:
    """How what a drive gives is read.

    Attributes
    ----------
    unit : str
        Of the file.
    inside : float
        What one unit is inside: N mm, N, A or 1.
    told : str
        In which unit effects are told: Nm or N where the torque per ampere is known.
    """

    unit: str
    inside: float
    told: str

    @property
    def forces(self) -> bool:
        """Whether it is known as a torque or a force."""
        return self.told in ("Nm", "N")


def readouts_of(joint_unit: str, units: Sequence[str], constants: Sequence[float] | None) -> tuple[Readout, ...]:
    """Return how each joint is read, by the units of files and, of currents, the torque constants that are known."""
    forces = ["N" if u == "mm" else "Nm" for u in of_joints(joint_unit, len(units))]
    known = [None] * len(units) if constants is None else list(constants)
    return tuple(
        Readout(unit, constant * INSIDE[force], force)
        if unit == "A" and constant is not None
        else Readout(unit, INSIDE[unit], unit)
        for unit, force, constant in zip(units, forces, known, strict=True)
    )


@dataclass(frozen=True, eq=False)
class Motion:
    """Joints with their derivatives.

    Attributes
    ----------
    states : (3, N, n_q) array
        Joints, velocities, accelerations [rad or mm, s]; nan in pieces that are too short.
    noise : (2, n_q) array
        Standard deviation of velocities and accelerations, as far as the joints' own noise goes.
    loose : (N,) array of bool
        Samples near the ends of a piece, where derivatives are known worse: no fit uses them.
    cutoff : float or None
        Of the low-pass [Hz]; None where derivatives were recorded.
    removed : float
        Part of the joints' signal (rms, of its own variation) that the low-pass takes away.
    text : str
        What was done.
    """

    states: Array
    noise: Array
    loose: np.ndarray
    cutoff: float | None
    removed: float
    text: str


@dataclass(frozen=True, eq=False)
class Trajectories:
    """Samples in time of one machine.

    Attributes
    ----------
    path : Path or str
    joint_unit : str
        ``"rad"`` or ``"mm"``; of a chain with both, one by one.
    joints : (N, n_q) array
        As the controller reports them [rad or mm].
    time : (N,) array
        From the start of each run [s], increasing within it.
    run : (N,) array of int
        Index into `run_names`.
    piece : (N,) array of int
        Which samples are one movement without a gap, counted over all runs.
    line : (N,) array of int
        In the file.
    readings : (N, n_q) array
        What the drives gave, in `units`; nan where nothing was read.
    columns, units : tuple of str
        Of the readings, joint by joint.
    recorded : (2, N, n_q) array
        Velocities and accelerations [rad or mm, s]; nan where the file has none.
    channels : dict of (N,) arrays
        Every other numeric column, in its unit there.
    said : Sidecar
    repairs : tuple of str
        What was put right, with the line.
    repaired : tuple of int
        The lines, increasing.
    constants : tuple of float, optional
        What each joint gets of an ampere [Nm/A], a sliding one [N/A].
    setups : tuple of str
        Label of each row, of what the machine carries or where it stands; empty where the file has none.
    outside : (N,) array of bool
        Of predicted readings: which lie outside of where a law was found; empty of those that were read.
    unshown : (N, n_q) array of bool
        Of predicted readings: which samples ask of a joint what the recording of the model did not show.
    load : (N, n_q) array, optional
        Of predicted readings: what of it the rigid machine asks of each joint; blank where nothing is predicted.
    half : (N, n_q) array, optional
        Of predicted readings: half the width of their bands, where these were asked for.
    moved : Motion, optional
        Joints and derivatives at the readings, where they were recorded on a clock of their own.
    joints_path : Path or str, optional
        The file of these joints; `path` is that of the readings then.
    """

    path: Path | str
    joint_unit: str
    joints: Array
    time: Array
    run: np.ndarray
    run_names: tuple[str, ...]
    piece: np.ndarray
    line: np.ndarray
    readings: Array
    columns: tuple[str, ...]
    units: tuple[str, ...]
    recorded: Array
    channels: Mapping[str, Array]
    said: Sidecar
    repairs: tuple[str, ...] = ()
    repaired: tuple[int, ...] = ()
    constants: tuple[float, ...] | None = None
    setups: tuple[str, ...] = ()
    outside: np.ndarray = field(default_factory=lambda: np.zeros(0, dtype=bool))
    unshown: np.ndarray = field(default_factory=lambda: np.zeros((0, 0), dtype=bool))
    load: Array | None = None
    half: Array | None = None
    moved: Motion | None = None
    joints_path: Path | str | None = None

    pairs: ClassVar[None] = None  # what only readings between rows have, for those who look at either

    @property
    def kind(self) -> str:
        """What was read."""
        return self.said.measurement.kind

    @property
    def n_rows(self) -> int:
        """Number of samples."""
        return len(self.joints)

    @property
    def setup_names(self) -> tuple[str, ...]:
        """Set-ups of the recording; one without a name where the file has none."""
        return tuple(dict.fromkeys(self.setups)) or ("",)

    def setup_is(self, name: str) -> np.ndarray:
        """Tell which rows (N,) are of a set-up; all, where either has no name."""
        if not self.setups or not name:
            return np.ones(self.n_rows, dtype=bool)
        return np.array([label == name for label in self.setups])

    @property
    def readouts(self) -> tuple[Readout, ...]:
        """How each joint is read."""
        return readouts_of(self.joint_unit, self.units, self.constants)

    @property
    def step(self) -> float:
        """Ordinary interval between two samples [s]."""
        return ordinary_step(self.time, self.piece)

    @property
    def payload(self) -> Array:
        """Mass at the tool point (N,) [kg]; nothing where the file does not say."""
        found = self.channels.get(PAYLOAD)
        return np.zeros(self.n_rows) if found is None else np.nan_to_num(found)


def read_sidecar(path: Path) -> Sidecar | None:
    """Return what the sidecar of a recording says, if that is in motion; None where there is none or it is not."""
    sidecar = sidecar_path(path)
    if not sidecar.exists():
        return None
    file = TomlFile.read(sidecar)
    head = file.data.get("measurement", {})
    return file.check(Sidecar) if isinstance(head, Mapping) and head.get("kind") in KINDS_IN_MOTION else None


def read(path: str | Path, machine: Machine, sidecar: Sidecar, *, need_measured: bool = True) -> Trajectories:
    """Read a recording in motion.

    Raises
    ------
    InputError
        The recording cannot be used; the message names file, line, column and remedy.
    """
    return trajectories(read_table(Path(path)), machine, sidecar, need_measured=need_measured)


def trajectories(
    rows: Rows, machine: Machine, sidecar: Sidecar, *, need_measured: bool = True, asked: bool = False
) -> Trajectories:
    """Return the rows of a table as samples in time; see `read`. Joints that are `asked` for stay as they are."""
    rows.require(TIME)
    time = rows.numbers(TIME, blank=False)[:, 0]
    run_names, run = _runs(rows)
    again, repairs = increasing(rows.path, rows.line, time, run, [f"run '{name}'" for name in run_names])
    kept = ~again
    repaired = set(rows.line[~kept].tolist())
    rows = rows.subset(kept)
    unit, limbs = machine.joint_unit, machine.limbs
    factors, names = np.array(joint_factors(unit, limbs)), joint_names(unit, limbs)
    columns, units = _read_columns(rows, machine, need_measured)
    _not_speeds_alone(rows, names, joint_names(unit, limbs, SPEEDS))
    joints = rows.numbers(*names, blank=False)
    readings = rows.each(*columns)
    time, run = time[kept], run[kept]
    if need_measured:
        kept, said = logged(rows, pieces_of(time, run), joints, readings, columns)
        repairs += said
        repaired |= set(rows.line[~kept].tolist())
        rows = rows.subset(kept)
        time, run, joints, readings = (values[kept] for values in (time, run, joints, readings))
    joints = joints * factors
    piece = pieces_of(time, run)
    by_joint, by_drive = (dict(zip(*pair, strict=True)) for pair in ((names, joints.T), (columns, readings.T)))
    said, lines = _put_right(rows, piece, by_joint, by_drive, factors, unit, spiked=not asked)
    repairs += said
    repaired |= lines
    recorded = np.array(
        [rows.each(*joint_names(unit, limbs, pattern)) * factors for pattern in (SPEEDS, ACCELERATIONS)]
    )
    found = Trajectories(
        path=rows.path,
        joint_unit=unit,
        joints=joints,
        time=time,
        run=run,
        run_names=run_names,
        piece=piece,
        line=rows.line,
        readings=readings,
        columns=columns,
        units=units,
        recorded=recorded,
        channels=rows.numeric(*names, *columns, TIME, "run", "pose", "setup"),
        said=sidecar,
        setups=tuple(rows.labels("setup", blank=False) or ()),
        repairs=tuple(repairs),
        repaired=tuple(sorted(repaired)),
    )
    _check_derivatives(rows, found, machine)
    return found


def _runs(rows: Rows) -> tuple[tuple[str, ...], np.ndarray]:
    """Return the names of the runs, and which one each row belongs to."""
    labels = rows.labels("run", blank=False) or ["1"] * len(rows.line)
    names = tuple(dict.fromkeys(labels))
    run = np.array([names.index(label) for label in labels])
    rows.refuse(
        run < np.maximum.accumulate(run),
        lambda k: f"run '{names[run[k]]}' goes on here, after rows of another one.",
        "Keep each run together.",
        column="run",
    )
    return names, run


def _put_right(
    rows: Rows,
    piece: np.ndarray,
    joints: dict[str, Array],
    readings: dict[str, Array],
    factors: Array,
    unit: str,
    *,
    spiked: bool,
) -> tuple[list[str], set[int]]:
    """Put joints and readings right, columns (N,) by their name; return what is said of it, and the lines.

    Values out of proportion are taken out where joints and readings may be `spiked`.
    """
    repairs, lines = list[str](), set[int]()
    for (name, values), unit_of in zip(joints.items(), of_joints(unit, len(joints)), strict=True):
        if unit_of == "rad" and len(wraps := _counted_on(values, piece)):
            repairs.append(
                f"{rows.path}:{rows.line[wraps[0]]}: {name} jumps by a whole turn, here and {len(wraps) - 1} times "
                "more; angles are counted on"
            )
    by = (*factors, *np.ones(len(readings)))
    for (name, values), unit_in in zip((joints | readings).items() if spiked else (), by, strict=spiked):
        spikes = _spikes_out(values, piece, filled=name in joints)
        lines |= set(rows.line[list(spikes)].tolist())
        repairs += [
            f"{rows.path}:{rows.line[k]}: {name} reads {value / unit_in:g}, out of all proportion; it is left out"
            for k, value in spikes.items()
        ]
    return repairs, lines


def _read_columns(rows: Rows, machine: Machine, needed: bool) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the columns of what drives give, and their units; raises InputError where they cannot be used."""
    limbs, sliding = machine.limbs, [u == "mm" for u in of_joints(machine.joint_unit, machine.limbs)]
    numbers = range(1, limbs + 1)
    forces = [("N" if slides else "Nm") for slides in sliding]
    forms = {
        "tau": ([f"tau{i}_{unit}" for i, unit in zip(numbers, forces, strict=True)], forces),
        "current": ([f"current{i}_A" for i in numbers], ["A"] * limbs),
        "drive": ([f"drive{i}" for i in numbers], ["1"] * limbs),
    }
    there = [name for name in rows.columns if DRIVE.fullmatch(name)]
    for name in there:
        if not any(name in columns for columns, _ in forms.values()):
            known = "; ".join(", ".join(columns) for columns, _ in forms.values())
            raise rows.error(
                f"'{name}' is no reading of a drive of this machine.",
                f"Known: {known}.",
                column=name,
                family=MissingColumn,
            )
    present = [word for word, (columns, _) in forms.items() if set(columns) & set(there)]
    if len(present) > 1:
        raise rows.error(
            "the columns hold readings of several kinds of drives.",
            "Keep one of them.",
            column=there[0],
            family=WrongKind,
        )
    if not present and needed:
        raise rows.error(
            "no column holds what a drive gives.",
            f"Add one of: {'; '.join(', '.join(c) for c, _ in forms.values())}.",
            family=MissingColumn,
        )
    columns, units = forms[present[0] if present else "tau"]
    if present:
        rows.require(*columns)
    return tuple(columns), tuple(units)


def _not_speeds_alone(rows: Rows, joints: Sequence[str], speeds: Sequence[str]) -> None:
    """Raise an InputError for a joint of which only speeds are there: angles can be made of them."""
    for joint, speed in zip(joints, speeds, strict=True):
        if joint not in rows.columns and speed in rows.columns:
            raise rows.error(
                "the column is missing; only speeds of this joint are there.",
                f"Add it, {speed} times the interval summed up from row to row: where that begins matters only where "
                'weight or stops do. derivatives = "velocity recorded" under [motion] then takes the speeds as given.',
                column=joint,
                family=MissingColumn,
            )


def temperature(given: Trajectories) -> Array | None:
    """Return the temperature (N,) [degC] of a recording that has one."""
    warmth = STATES["temperature"]
    return next((values for name, values in given.channels.items() if warmth.holds(name)), None)


def _counted_on(angles: Array, piece: np.ndarray) -> np.ndarray:
    """Count the angles (N,) [rad] of a joint on where they begin anew after a turn; return the rows at which they do.

    From one sample to the next the joint goes on as it does elsewhere, but for whole turns. Movements are put where the
    first of them is. A joint that spins fast moves on by a turn between samples: where angles lie further apart than
    they jump, and the step is one of those that it makes, nothing begins anew.
    """
    step, within, whole = np.diff(angles), np.diff(piece) == 0, 2 * np.pi
    turns = np.where(within, np.round(step / whole), 0.0)
    ordinary = np.abs(step[within & (turns == 0)])
    if not turns.any() or not len(ordinary):
        return np.empty(0, dtype=int)
    goes = TURNS_ON * float(np.quantile(ordinary, 0.99))
    low, high = np.quantile(angles, WITHIN)
    spins = (high - low > whole * np.abs(turns)) & (np.abs(step) <= goes)
    turns[spins | (np.abs(step - whole * turns) > max(goes, MOVES))] = 0.0
    if not turns.any():
        return np.empty(0, dtype=int)
    angles[1:] -= whole * np.cumsum(turns)
    own = np.split(np.arange(len(piece)), np.flatnonzero(np.diff(piece)) + 1)
    first = np.median(angles[own[0]])
    for rows in own:
        angles[rows] -= whole * np.round((np.median(angles[rows]) - first) / whole)
    return np.flatnonzero(turns) + 1


def _spikes_out(values: Array, piece: np.ndarray, *, filled: bool) -> dict[int, float]:
    """Take values out of a column (N,) that no machine gives for a few samples; return these by their row.

    A joint is put where its neighbours lead (`filled`), a reading is blank then.
    """
    known = np.flatnonzero(np.isfinite(values))
    if len(known) < 10 * LONGEST_SPIKE:
        return {}
    off = np.concatenate([_off(values[own]) for own in np.split(known, np.flatnonzero(np.diff(piece[known])) + 1)])
    steps = np.abs(np.diff(values[known]))
    count = float(np.min(steps[steps > 0], initial=np.inf))  # of a coarse reading: one count more is in proportion
    spikes = known[out_of_proportion(off, np.abs(values[known]), count if np.isfinite(count) else 0.0)]
    said = {int(k): float(values[k]) for k in spikes}
    if said:
        values[spikes] = np.nan
        if filled:
            for k in spikes:
                beside = np.flatnonzero(np.isfinite(values) & (piece == piece[k]))
                values[k] = np.interp(k, beside, values[beside])
    return said


def _off(values: Array) -> Array:
    """Return how far the values (M,) of one movement are from the median of their neighbours."""
    padded = np.pad(values, LONGEST_SPIKE, mode="edge")
    windows = np.lib.stride_tricks.sliding_window_view(padded, 2 * LONGEST_SPIKE + 1)
    return np.asarray(np.abs(values - np.median(windows, axis=1)))


def _check_derivatives(rows: Rows, found: Trajectories, machine: Machine) -> None:
    """Raise an InputError where derivatives are said to be recorded and are not."""
    said = found.said.motion.derivatives
    needed = {None: (), "velocity recorded": (0,), "recorded": (0, 1)}[said]
    for order in needed:
        names = joint_names(machine.joint_unit, machine.limbs, (SPEEDS, ACCELERATIONS)[order])
        for name, values in zip(names, found.recorded[order].T, strict=True):
            rows.refuse(
                np.isnan(values),
                f'the sidecar says derivatives = "{said}", and this column has no number here.',
                "Record it, or leave derivatives out under [motion]: they are then made of the joints.",
                column=name,
            )
