"""Recordings: what the controller reported and what the instrument read, one row per reading.

A recording is a CSV or Parquet file, an optional sidecar ``NAME.toml`` that says what was measured and how, and,
where distances between two rows were measured, ``NAME.distances.csv``. Everything that can be wrong without knowing
the kinematics is caught here, with file, line, column and remedy: a recording that was read can be trusted to be
complete. Joints and measured quantities are converted to mm and rad; the other channels keep the unit in their name.
"""

from __future__ import annotations

import contextlib
import csv
import dataclasses
import io
import itertools
import os
import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from numbers import Integral
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
from pydantic import AfterValidator
from pydantic_core import PydanticCustomError

from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.robot import (
    Number,
    Positive,
    Table,
    TomlFile,
    Vector,
    nearest,
    read_text,
    robot_size,
    to_file,
    toml_text,
)
from deltacal_gen.instrument import kinds
from deltacal_gen.instrument.kind import Kind
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.machine import POSE
from deltacal_gen.machine.rotation import from_vector, to_vector
from deltacal_gen.machine.values import POSITION, ROTATION, TEMPERATURE, Measurement, Recording, Robot
from deltacal_gen.units import DEG, file_unit, joint_factors, joint_names, of_joints

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Machine

_TOOL = ("tool_x_mm", "tool_y_mm", "tool_z_mm")
_MEASURED = {column for name in kinds.names() for column in kind_of(name).reserved}
_RESERVED = {*_MEASURED, *_TOOL, "pose", "setup"}
_ONE_SETUP = ("1",)  # name of the only set-up, where the file names none

_JOINT = re.compile(r"q\d+_(deg|mm)")
_JOINT_LIKE = re.compile(r"q\d", re.IGNORECASE)  # meant as joints, though perhaps misspelt
_JOINT_OF_END = re.compile(r"q\d+[ab]_(deg|mm|rad)")
_END = re.compile(r"(?P<stem>.+?)_?(?P<end>[ab])(?P<unit>(_[A-Za-z]+\d?)*)")  # q1a_deg, payload_a_kg, approach1b
_APPROACH = re.compile(r"approach\d+")
_CHANNEL = re.compile(rf"time_s|payload_kg|{TEMPERATURE.pattern}|{_APPROACH.pattern}|qdd?\d+_\w+")
_DECIMAL_COMMA = re.compile(r"[-+]?\d+,\d+")

_SAME_JOINT = 1e-6 * DEG  # rad, and mm: joints that differ by more are not the same pose
_LEAST_SPREAD = 0.01  # of readings, in machine sizes per rad of joint motion (1 rad at most)
_MOST_SPREAD = 20.0  # in machine sizes
_MOST_MOTION = 5.0  # in machine sizes per rad of joint motion
_MOST_PAYLOAD = 20.0  # in moving masses of the machine: parallel robots carry a few of them
_HOME = 0.1  # of the spread of positions: further from zero the first row is not at the home
_RADIANS = 1.6  # a column of degrees that stays within this may be in radians


class Camera(Table):
    """Pinhole camera of sphere images: focal lengths and principal point [px], radial distortion `k1`,
    rotation vector [deg], radius of the ball [mm]."""

    fx_px: Positive
    fy_px: Positive
    cx_px: Number
    cy_px: Number
    k1: Number = 0.0
    rotation_deg: Vector = (0.0, 0.0, 0.0)
    ball_radius_mm: Positive


def _kind_name(value: str) -> str:
    """Return a kind's name of what a sidecar calls it."""
    for name in kinds.names():
        if value in (name, *kind_of(name).aliases):
            return name
    *most, last = map(repr, kinds.names())
    expected = f"{', '.join(most)} or {last}"
    raise PydanticCustomError("literal_error", "one of {expected} was expected", {"expected": expected})


class _Measurement(Table):
    """The table [measurement] of a sidecar, of which `Measurement` is made."""

    kind: Annotated[str, AfterValidator(_kind_name)] | None = None
    frame: Literal["unknown", "robot"] = "unknown"
    sigma_mm: Positive | None = None
    sigma_deg: Positive | None = None
    sigma_px: Positive | None = None
    instrument: str | None = None
    zero: Literal["absolute", "incremental"] = "absolute"
    base_point_mm: Vector | None = None
    platform_point_mm: Vector | None = None
    camera: Camera | None = None


class _Contacts(Table):
    distance_mm: tuple[tuple[str, str, Positive], ...] = ()


class _Sidecar(Table):
    measurement: _Measurement = _Measurement()
    camera: Camera | None = None
    contacts: _Contacts = _Contacts()


# --- reading --------------------------------------------------------------------------------------------------------


def read_recording(
    path: str | Path,
    mechanism: Machine,
    *,
    need_measured: bool = True,
    allow_targets: bool = False,
    doubtful: bool = False,
) -> Recording:
    """Read a recording with its sidecar and its distances file.

    Parameters
    ----------
    path : path
        CSV, or Parquet by the ending ``.parquet``.
    mechanism : Machine
        Says how many joints there are and whether they turn or slide.
    need_measured : bool
        Whether a recording without a single reading is an error.
    allow_targets : bool
        Whether positions without joints are taken as targets.
    doubtful : bool
        Whether channels are taken that hold values which cannot be, for `set_aside` to judge.

    Raises
    ------
    InputError
        The recording cannot be used; the message names file, line, column and remedy.
    """
    path = Path(path)
    rows = _read_parquet(path) if path.suffix == ".parquet" else _read_csv(path)
    recording = _recording(path, rows, _read_sidecar(path), mechanism, need_measured, allow_targets, doubtful)
    if need_measured and not _is_measured(recording):
        raise _no_reading(recording)
    return recording


def read_blocks(
    path: str | Path,
    mechanism: Machine,
    rows: int,
    *,
    need_measured: bool = True,
    allow_targets: bool = False,
) -> Iterator[Recording]:
    """Read a recording of any length, so many rows at a time; see `read_recording`.

    What concerns rows far apart (repeats, labels that stand twice) is judged within a block only. Where readings are
    needed, a block without any is passed over.

    Raises
    ------
    UsageError
        Blocks of less than one row.
    InputError
        As `read_recording`; and for distances between rows, several set-ups, or positions that count from a first row:
        those need the whole recording.
    """
    if not isinstance(rows, Integral) or rows < 1:
        raise UsageError(f"rows = {rows}: a block needs a whole number of rows, at least 1.")
    path = Path(path)
    sidecar, done, setups, blank = _read_sidecar(path), 0, set[str](), need_measured
    for block in _parquet_blocks(path, rows) if path.suffix == ".parquet" else _csv_blocks(path, rows):
        part = _recording(path, block, sidecar, mechanism, need_measured, allow_targets, doubtful=False)
        setups |= {*part.setup_names}
        several = f"several set-ups ({', '.join(sorted(setups))})"
        for what, found in (
            ("distances between rows", part.pairs is not None),
            (several, len(setups) > 1),
            ("an incremental zero", part.measurement.zero == "incremental"),
        ):
            if found:
                raise InputError(f"{what} cannot be read in blocks.", "Read the recording as a whole.", file=path)
        if "pose" not in block.columns:
            part = dataclasses.replace(part, pose=np.arange(done + 1, done + part.n_rows + 1).astype(str))
        done += part.n_rows
        free = [n for n, cells in block.columns.items() if not (any(cells) or n in _RESERVED or _JOINT.fullmatch(n))]
        blanks = {name: np.full(part.n_rows, np.nan) for name in free}  # another block may hold numbers there
        part = dataclasses.replace(part, channels=blanks | part.channels)
        if not need_measured or _is_measured(part):
            blank = False
            yield part
    if blank:
        raise _no_reading(part)


def _recording(
    path: Path,
    rows: _Rows,
    sidecar: _Sidecar,
    mechanism: Machine,
    need_measured: bool,
    allow_targets: bool,
    doubtful: bool,
) -> Recording:
    """Return the rows of a file as a recording."""
    measurement = _said(sidecar)
    pairs, rows = _pairs_and_rows(path, rows)
    targets = None
    axes = tuple(f"{axis}_mm" for axis in mechanism.axes)
    has_joints = any(_JOINT_LIKE.match(name) for name in rows.columns)
    if allow_targets and not has_joints and set(axes) & set(rows.columns):
        targets, rows = _targets(rows, mechanism)
        joints = np.full((len(targets), mechanism.limbs), np.nan)
    else:
        joints = _joints(rows, mechanism)

    kind = _kind(rows, measurement.kind, mechanism, pairs is not None, need_measured)
    columns = kind.columns(mechanism)
    kind.check(measurement, sidecar.contacts.distance_mm, rows.columns, path.with_suffix(".toml"))
    pose = rows.labels("pose") or [str(n + 1) for n in range(len(joints))]
    setup_names, setup = np.unique(rows.labels("setup", blank=False) or _ONE_SETUP * len(joints), return_inverse=True)
    recording = Recording(
        path=path,
        kind=kind.name,
        measurement=measurement,
        joint_unit=mechanism.joint_unit,
        joints=joints,
        columns=columns,
        measured=_measured(rows, kind, columns, need_measured),
        pose=np.array(pose),
        line=rows.line,
        channels={name: values for name in rows.columns if (values := _channel(rows, name, doubtful)) is not None},
        setup=setup,
        setup_names=tuple(setup_names.tolist()),
        tool=rows.numbers(*_TOOL) if set(_TOOL) & set(rows.columns) else None,
        targets=targets,
        contact=np.array(rows.columns["contact"]) if {"contact"} & set(columns) & set(rows.columns) else None,
        contact_distances=sidecar.contacts.distance_mm,
    )
    if pairs is not None:
        recording = _with_pairs(recording, pairs, rows, need_measured and kind.pairs)
    else:
        _check_repeats(recording, rows)
    if need_measured and recording.measurement.zero == "incremental" and _has_home(mechanism):
        _check_home(recording)
    return recording


def check_units(recording: Recording, robot: Robot, *, load: Callable[[str], Machine] | None = None) -> None:
    """Compare joints and readings with the size of the machine.

    Raises
    ------
    InputError
        Joints look like radians or motor angles, or positions or distances like metres or micrometres.
    """
    q = recording.joints
    turning = np.array([unit == "rad" for unit in of_joints(recording.joint_unit, q.shape[1])])
    if (far := np.argwhere(turning & (np.abs(q) > 360 * DEG))).size:
        row, joint = far[0]
        raise InputError(
            f"the joint reads {q[row, joint] / DEG:.6g} deg, more than a full turn either way.",
            "Give angles of the joint, after the gear, in degrees.",
            file=recording.path,
            line=int(recording.line[row]),
            column=f"q{joint + 1}_deg",
        )
    size = robot_size(robot, load=load)
    small_angles = turning.any() and (np.abs(q[:, turning]) <= _RADIANS * DEG).all()
    for column, spread, turn in _spreads(recording, q / np.where(turning, 1.0, size)):
        what = f"the readings spread over {spread:.4g} mm"
        if small_angles and spread > size * max(_MOST_MOTION * turn, _LEAST_SPREAD):
            raise InputError(
                f"{what}, yet no joint reads more than {_RADIANS} deg: the joints look like radians.",
                "Convert them to degrees.",
                file=recording.path,
                column=f"q{int(np.argmax(turning)) + 1}_deg",
            )
        if spread > _MOST_SPREAD * size or spread < _LEAST_SPREAD * size * min(turn, 1.0):
            unit, factor = ("micrometres", "Divide by") if spread > size else ("metres", "Multiply by")
            raise InputError(
                f"{what} on a machine of {size:.4g} mm: they look like {unit}.",
                f"{factor} 1000, or correct the robot file.",
                file=recording.path,
                column=column,
            )


def _spreads(recording: Recording, joints: np.ndarray) -> Iterator[tuple[str, float, float]]:
    """Column, spread of its readings [mm] and largest motion of a joint (N, n_q) between them."""
    kind, pairs = kind_of(recording.kind), kind_of("distance")
    yield from kind.spreads(recording, joints)
    if recording.pairs is not None and not kind.pairs:
        yield from pairs.spreads(recording, joints)


@dataclass(frozen=True)
class _Rows:
    """Cells of a file, as text, by column."""

    path: Path
    columns: dict[str, list[str]]
    line: np.ndarray  # of each row
    header_line: int | None

    def error(self, problem: str, remedy: str, *, row: int | None = None, column: str | None = None) -> InputError:
        line = self.header_line if row is None else int(self.line[row])
        return InputError(problem, remedy, file=self.path, line=line, column=column)

    def without(self, names: Iterable[str]) -> _Rows:
        dropped = set(names)
        kept = {name: cells for name, cells in self.columns.items() if name not in dropped}
        return dataclasses.replace(self, columns=kept)

    def require(self, *names: str) -> None:
        """Raise for the first column that is not there, naming one that may be meant."""
        for name in names:
            if name in self.columns:
                continue
            others = [n for n in self.columns if n not in _RESERVED.union(names) and not _CHANNEL.fullmatch(n)]
            stem = name.split("_")[0]
            close = next((n for n in others if n.lower().split("_")[0] == stem), None) or nearest(name, others)
            unit = f" in {name.split('_')[-1]}" if "_" in name else ""
            problem = f"the column is missing; '{close}' looks like it." if close else "the column is missing."
            remedy = f"Rename it to '{name}' and give it{unit}." if close else f"Add it{unit}, or correct the header."
            raise self.error(problem, remedy, column=name)

    def labels(self, name: str, *, blank: bool = True) -> list[str] | None:
        """A column of names; a blank one is named after its line, or raises. None where there is no such column."""
        cells = self.columns.get(name)
        if cells is not None and not blank and "" in cells:
            raise self.error("the cell is blank.", "Fill it in.", row=cells.index(""), column=name)
        return cells and [cell or f"line {line}" for cell, line in zip(cells, self.line, strict=True)]

    def numbers(self, *names: str, blank: bool = True) -> np.ndarray:
        """(N, k) numbers of k columns that belong together: a row is complete, or all blank where that is allowed."""
        self.require(*names)
        values = np.column_stack([self._column(name) for name in names])
        gaps = np.isnan(values)
        bad = gaps.any(axis=1) & ~(gaps.all(axis=1) & blank)
        if bad.any():
            row = int(np.argmax(bad))
            name = names[int(np.argmax(gaps[row]))]
            if blank:
                rest = f"the cell is blank, but other cells of {', '.join(names)} are not."
                raise self.error(rest, "Fill it in, or blank them all.", row=row, column=name)
            raise self.error("the cell is blank.", "Fill it in, or remove the row.", row=row, column=name)
        return values

    def _column(self, name: str) -> np.ndarray:
        values = np.full(len(self.line), np.nan)
        cells = self.columns[name]
        with contextlib.suppress(ValueError):  # the usual column at once; others cell by cell, to name the wrong one
            values = np.array([float(cell) if cell else np.nan for cell in cells])
            if np.isfinite(values).sum() == sum(map(bool, cells)) and not any("_" in cell for cell in cells):
                return values
        for row, cell in enumerate(cells):
            if not cell:
                continue
            value = _number(cell)
            if value is None or not np.isfinite(value):
                remedy = "Correct the cell or remove the row."
                if value is not None:
                    remedy = "Leave the cell blank where nothing was measured; joints must be complete."
                elif _DECIMAL_COMMA.fullmatch(cell):
                    remedy = "Write a decimal point."
                shown = cell if len(cell) <= 40 else f"{cell[:36]} ..."
                expected = "a number" if value is None else "a finite number"
                raise self.error(f"the cell holds '{shown}', {expected} was expected.", remedy, row=row, column=name)
            values[row] = value
        return values


def _number(cell: str) -> float | None:
    try:
        return None if "_" in cell else float(cell)  # float() takes 1_000
    except ValueError:
        return None


def _read_csv(path: Path) -> _Rows:
    return _csv_rows(path, list(_lines(read_text(path).split("\n"))))


def _lines(text: Iterable[str]) -> Iterator[tuple[int, str]]:
    """Yield the lines that hold cells, numbered as in the file."""
    return ((n, line) for n, line in enumerate(text, start=1) if line.strip() and not line.startswith("#"))


def _csv_blocks(path: Path, rows: int) -> Iterator[_Rows]:
    try:
        with path.open(encoding="utf-8-sig") as file:
            lines = _lines(line.rstrip("\n") for line in file)
            head = list(itertools.islice(lines, 1))
            block = list(itertools.islice(lines, rows))
            while True:
                while sum(line.count('"') for _, line in block) % 2 and (more := next(lines, None)):
                    block.append(more)  # a cell goes on in the next line
                yield _csv_rows(path, head + block)
                block = list(itertools.islice(lines, rows))
                if not block:
                    return
    except OSError as error:
        raise InputError(f"the file cannot be read: {error.strerror}.", "Check the path.", file=path) from None
    except UnicodeDecodeError:
        raise InputError("the file is not UTF-8 text.", "Save the file as text in UTF-8.", file=path) from None


def _csv_rows(path: Path, kept: list[tuple[int, str]]) -> _Rows:
    """Return lines, the header first, as cells."""
    if not kept:
        raise InputError("the file is empty.", "Give a header and one row per reading.", file=path)
    header_line, first = kept[0]
    for separator, name in ((";", "semicolons"), ("\t", "tabs")):
        if separator in first and "," not in first:
            raise InputError(
                f"the columns are separated by {name}, commas were expected.",
                "Save the file with commas between the columns and points as decimal marks.",
                file=path,
                line=header_line,
            )
    reader = csv.reader((line for _, line in kept), strict=True)
    table: list[list[str]] = []
    numbers: list[int] = []
    try:
        for cells in reader:
            table.append([cell.strip() for cell in cells])
            numbers.append(kept[reader.line_num - 1][0])
    except csv.Error as error:
        line = kept[min(reader.line_num, len(kept)) - 1][0]
        raise InputError(f"this is not CSV: {error}.", "Correct the quotes.", file=path, line=line) from None
    header = table.pop(0)
    _check_header(path, header, header_line)
    for cells, line in zip(table, numbers[1:], strict=True):
        if len(cells) != len(header):
            comma = " Decimals need a point, not a comma." if len(cells) > len(header) else ""
            raise InputError(
                f"the row has {len(cells)} cells, the header {len(header)}.",
                f"Correct the row.{comma}",
                file=path,
                line=line,
            )
    if not table:
        raise InputError("there is a header but no row.", "Add one row per reading.", file=path, line=header_line)
    columns = {name: [cells[k] for cells in table] for k, name in enumerate(header)}
    return _Rows(path, columns, np.array(numbers[1:]), header_line)


def _read_parquet(path: Path) -> _Rows:
    return next(_parquet_blocks(path, None))


def _parquet_blocks(path: Path, rows: int | None) -> Iterator[_Rows]:
    try:
        import pyarrow as pa
        import pyarrow.parquet as pq
    except ImportError:
        raise InputError(
            "reading Parquet needs pyarrow, which is not installed.",
            "Install it (pip install pyarrow), or save the file as CSV.",
            file=path,
        ) from None
    done = 0
    try:
        with pq.ParquetFile(path) as file:
            whole = rows is None or not file.metadata.num_rows
            for batch in [file.read()] if whole else file.iter_batches(rows):
                names, count = batch.schema.names, batch.num_rows
                _check_header(path, names, None)
                if not count:
                    raise InputError("there is no row.", "Add one row per reading.", file=path)
                columns = {
                    name: ["" if cell is None else str(cell).strip() for cell in column.to_pylist()]
                    for name, column in zip(names, batch.columns, strict=True)
                }
                yield _Rows(path, columns, np.arange(done + 1, done + count + 1), None)
                done += count
    except (OSError, ValueError, pa.ArrowException) as error:
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        raise InputError(f"this is not a readable Parquet file: {reason}.", "Save it again.", file=path) from None


def _check_header(path: Path, header: Sequence[str], line: int | None) -> None:
    for k, name in enumerate(header):
        if not name:
            raise InputError(
                f"column {k + 1} has no name.", "Name it, or remove the comma too many.", file=path, line=line
            )
        if name in header[:k]:
            raise InputError(
                f"the name stands over columns {header.index(name) + 1} and {k + 1}.",
                "Rename or remove one of them.",
                file=path,
                line=line,
                column=name,
            )


def _distances_path(path: Path) -> Path:
    return path.with_name(f"{path.stem}.distances.csv")


def read_measurement(sidecar: str | Path) -> Measurement:
    """Return what a sidecar, NAME.toml, says of the measurement.

    Raises
    ------
    InputError
        The file is missing, or a key in it is wrong.
    """
    return _said(TomlFile.read(sidecar).check(_Sidecar))


def _read_sidecar(path: Path) -> _Sidecar:
    path = path.with_suffix(".toml")
    if not path.exists():
        return _Sidecar()
    return TomlFile.read(path).check(_Sidecar)


def _said(sidecar: _Sidecar) -> Measurement:
    said = Measurement(**dict(sidecar.measurement))
    return said if sidecar.camera is None else dataclasses.replace(said, camera=sidecar.camera)


def _pairs_and_rows(path: Path, rows: _Rows) -> tuple[_Rows | None, _Rows]:
    """The table of distances, if there is one, and the table of rows.

    A row that holds both joint sets becomes two rows, labelled with a and b behind its pose.
    """
    if not any(_JOINT_OF_END.fullmatch(name) for name in rows.columns):
        distances = _distances_path(path)
        return (_read_csv(distances) if distances.exists() else None), rows
    ends: dict[str, dict[str, str]] = {}
    for name in rows.columns:
        if end := _END.fullmatch(name):
            ends.setdefault(end["stem"] + end["unit"], {})[end["end"]] = name
    for name, found in ends.items():
        if len(found) == 1 and _JOINT.fullmatch(name):
            rows.require(*(re.sub(r"(\d+)", rf"\1{end}", name) for end in "ab"))
    ends = {name: found for name, found in ends.items() if len(found) == 2}
    gone = {"distance_mm", *(name for found in ends.values() for name in found.values())}
    columns = {name: [cell for cell in cells for _ in "ab"] for name, cells in rows.without(gone).columns.items()}
    if "pose" in columns:
        columns["pose"] = [label + end for label in rows.labels("pose") or () for end in "ab"]
    for name, found in ends.items():
        both = zip(rows.columns[found["a"]], rows.columns[found["b"]], strict=True)
        columns[name] = [cell for pair in both for cell in pair]
    return rows, dataclasses.replace(rows, columns=columns, line=np.repeat(rows.line, 2))


def _turns(mechanism: Machine) -> tuple[str, ...]:
    """Return the columns of a rotation: in space a tracked body has one, held or not; in the plane it is about z."""
    return ROTATION if len(mechanism.axes) == 3 else tuple(f"r{axis}_deg" for axis in mechanism.turns)


def _targets(rows: _Rows, mechanism: Machine) -> tuple[np.ndarray, _Rows]:
    """Return targets (N, 3) or poses (N, 12), and the rows without their columns."""
    axes, turns = tuple(f"{axis}_mm" for axis in mechanism.axes), _turns(mechanism)
    targets = np.zeros((len(rows.line), 3))
    given = [axis for axis in axes if f"p{axis[0]}" in mechanism.asks or axis in rows.columns]
    targets[:, [POSITION.index(axis) for axis in given]] = rows.numbers(*given, blank=False)
    if POSE in mechanism.widths and set(turns) & set(rows.columns):
        vectors = np.zeros((len(targets), 3))
        vectors[:, [ROTATION.index(turn) for turn in turns]] = rows.numbers(*turns, blank=False) * DEG
        return np.hstack([targets, from_vector(vectors).reshape(-1, 9)]), rows.without((*axes, *turns))
    if 3 not in mechanism.widths:
        raise rows.error(
            f"a position alone does not say how {mechanism.sort} shall stand.",
            "Add rx_deg, ry_deg, rz_deg (a rotation vector of the last frame in {O}), or give joints instead.",
            column=axes[0],
        )
    return targets, rows.without(axes)


def _joints(rows: _Rows, mechanism: Machine) -> np.ndarray:
    names = joint_names(mechanism.joint_unit, mechanism.limbs)
    joints = rows.numbers(*names, blank=False) * joint_factors(mechanism.joint_unit, mechanism.limbs)
    for name in rows.columns:
        if _JOINT.fullmatch(name) and name not in names:
            raise rows.error(
                f"'{mechanism.name}' has the joints {', '.join(names)} only.",
                "Rename or remove the column, or correct the mechanism in the robot file.",
                column=name,
            )
    return joints


def _kind(rows: _Rows, said: str | None, mechanism: Machine, paired: bool, need_measured: bool) -> Kind:
    """Kind of the recording: what the sidecar says, checked against the columns, or what the columns say."""
    columns = {kind: kind.columns(mechanism) for kind in map(kind_of, kinds.names())}
    present = _present(columns, rows.columns)
    stated = None if said is None else kind_of(said)
    between = [kind for kind in (stated, *present) if kind is not None and kind.pairs]
    if between and not paired:
        name = _distances_path(rows.path).name
        raise rows.error(
            "distances lie between two points, but the rows hold one joint set each.",
            f"Add {name} with the columns pose_a, pose_b, distance_mm, or name the joints q1a_..., q1b_... here.",
            column="distance_mm",
        )
    if stated is not None:
        # a kind with more columns than another may be read as that one
        if not stated.pairs and present and not any(set(columns[stated]) <= set(columns[kind]) for kind in present):
            other = present[0]
            raise rows.error(
                f"the sidecar says kind = '{said}', but this column belongs to kind = '{other.name}'.",
                f"Correct the sidecar, or give the columns {', '.join(columns[stated])}.",
                column=next(name for name in columns[other] if name in rows.columns),
            )
        return stated
    if len(present) > 1:
        raise rows.error(
            f"the columns hold readings of several kinds: {', '.join(kind.name for kind in present)}.",
            f"Say which to use: kind = '...' under [measurement] in {rows.path.with_suffix('.toml').name}.",
        )
    if not present and need_measured and not paired:
        raise rows.error(
            "no column holds a measured quantity.",
            f"Add one of: {'; '.join(', '.join(names) for names in columns.values())}.",
        )
    return next(iter(present), kind_of("distance" if paired else "position"))


def _present(columns: Mapping[Kind, tuple[str, ...]], given: Iterable[str]) -> list[Kind]:
    """Return the kinds of which some column is given.

    Of two kinds of which one has all columns of the other, the larger is there where one of its own columns is; it then
    stands for both. On a machine that does not turn, poses have no column of their own.
    """
    there = set(given)
    within = {
        kind: [k for k in columns if k != kind and set(columns[k]) <= set(columns[kind]) and k.scalars < kind.scalars]
        for kind in columns
    }
    own = {kind: set(columns[kind]).difference(*(columns[k] for k in within[kind])) for kind in columns}
    found = [kind for kind in columns if own[kind] & there]
    return [kind for kind in found if not any(kind in within[larger] for larger in found)]


def _measured(rows: _Rows, kind: Kind, columns: tuple[str, ...], need_measured: bool) -> np.ndarray:
    if not kind.numbers:
        if need_measured and not kind.pairs:
            rows.require(*columns)
        return np.empty((len(rows.line), 0))
    if not need_measured and not set(columns) & set(rows.columns):
        return np.full((len(rows.line), len(columns)), np.nan)
    # what is in one unit is read together: a tracker may read a point without its rotation, but not part of a point
    units = [name.rpartition("_")[2] for name in columns]
    parts = [[name for name, u in zip(columns, units, strict=True) if u == unit] for unit in dict.fromkeys(units)]
    factors = [DEG if name.endswith("_deg") else 1.0 for name in columns]
    return np.hstack([rows.numbers(*names) for names in parts]) * factors


def _is_measured(recording: Recording) -> bool:
    paired = recording.pair_measured is not None and bool(np.isfinite(recording.pair_measured).any())
    touched = recording.contact is not None and bool((recording.contact != "").any())
    # the first column: a rotation without its point, which comes before it, is no reading
    return paired or touched or bool(np.isfinite(recording.measured[:, :1]).any())


def _no_reading(recording: Recording) -> InputError:
    return InputError("no row holds a reading.", f"Fill in {', '.join(recording.columns)}.", file=recording.path)


def _channel(rows: _Rows, name: str, doubtful: bool) -> np.ndarray | None:
    """(N,) values of a channel or covariate; None for other columns, and for those that hold text only.

    A value that cannot be is an error, unless `doubtful` ones are taken as they are.
    """
    if name in _RESERVED or _JOINT.fullmatch(name):
        return None
    if not _CHANNEL.fullmatch(name) and all(_number(cell) is None for cell in rows.columns[name]):
        return None
    values = rows.numbers(name)[:, 0]
    if _APPROACH.fullmatch(name):
        values[values == 0] = np.nan  # the direction is not known
    wrong, expected = _impossible(name, values)
    if wrong.any() and not doubtful:
        row = int(np.argmax(wrong))
        problem = f"the cell holds '{rows.columns[name][row]}': {expected}."
        raise rows.error(problem, "Correct the cell, or leave it blank if it is not known.", row=row, column=name)
    return values


def _impossible(name: str, values: np.ndarray, heaviest: float = np.inf) -> tuple[np.ndarray, str]:
    """Which values (N,) of a channel cannot be, and what was expected in words; `heaviest` is the largest payload."""
    if _APPROACH.fullmatch(name):
        return np.isfinite(values) & (np.abs(values) != 1), "1 or -1 was expected"
    if TEMPERATURE.fullmatch(name):
        return (values < -100) | (values > 300), "-100 to 300 degC were expected"
    if name == "payload_kg" and (values < 0).any():
        return values < 0, "a mass cannot be negative"
    if name == "payload_kg":
        return values > heaviest, f"at most {heaviest:.3g} kg were expected on arms and a platform like these"
    return np.zeros(len(values), dtype=bool), ""


def set_aside(recording: Recording, robot: Robot) -> Recording:
    """Return the recording without the channels that hold values which cannot be; `doubts` says why."""
    masses = robot.masses
    heaviest = np.inf
    if masses is not None:
        limbs = recording.joints.shape[1]
        moving = masses.platform + limbs * (masses.proximal + 2 * masses.distal_rod)
        heaviest = _MOST_PAYLOAD * moving if moving else np.inf
    doubts = {}
    for name, values in recording.channels.items():
        wrong, expected = _impossible(name, values, heaviest)
        if wrong.any():
            row = int(np.argmax(wrong))
            doubts[name] = f"line {recording.line[row]} holds {values[row]:.6g}: {expected}"
    kept = {name: values for name, values in recording.channels.items() if name not in doubts}
    return dataclasses.replace(recording, channels=kept, doubts=doubts)


def _check_repeats(recording: Recording, rows: _Rows) -> None:
    """Rows of one pose have the same joints and the same tool point."""
    points = recording.joints if recording.targets is None else recording.targets
    if recording.tool is not None:
        points = np.hstack([points, np.nan_to_num(recording.tool)])
    first: dict[str, int] = {}
    for row, label in enumerate(recording.pose.tolist()):
        other = first.setdefault(label, row)
        if other != row and np.abs(points[row] - points[other]).max() > _SAME_JOINT:
            raise rows.error(
                f"pose '{label}' has other joints or another tool point than in line {rows.line[other]}.",
                "Give every pose a label of its own; only repeats share one.",
                row=row,
                column="pose",
            )


def _has_home(mechanism: Machine) -> bool:
    return any(key.key == "home" for key in mechanism.geometry)


def _check_home(recording: Recording) -> None:
    """Increments count from the first row, which stands at the home."""
    found = recording.joints[0]
    if np.abs(found).max() > _SAME_JOINT:
        joint = int(np.argmax(np.abs(found)))
        unit = of_joints(recording.joint_unit, len(found))[joint]
        raise InputError(
            f'zero = "incremental": joints count from the home, yet the first row reads '
            f"{to_file(found[joint], unit):.6g} {file_unit(unit)}.",
            'Put the home, with joints 0, into the first row, or say zero = "absolute" in the sidecar.',
            file=recording.path,
            line=int(recording.line[0]),
            column=f"q{joint + 1}_{file_unit(unit)}",
        )
    if (axes := kind_of(recording.kind).zero_at_home(recording)) is None:
        return
    spread = float(np.ptp(axes[np.isfinite(axes).all(axis=1)], axis=0).max(initial=0.0))
    axis = int(np.argmax(np.abs(np.nan_to_num(axes[0]))))
    if abs(np.nan_to_num(axes[0, axis])) > _HOME * spread:
        raise InputError(
            f'zero = "incremental": readings count from the home, yet the first row, with joints 0, reads '
            f"{axes[0, axis]:.6g} mm.",
            'Put the home into the first row, or say zero = "absolute" in the sidecar.',
            file=recording.path,
            line=int(recording.line[0]),
            column=recording.columns[axis],
        )


def _with_pairs(recording: Recording, pairs: _Rows, rows: _Rows, need_measured: bool) -> Recording:
    if pairs.path == recording.path:  # both joint sets in one row
        _check_repeats(recording, rows)
        indices = np.arange(recording.n_rows).reshape(-1, 2)
    else:
        row_of: dict[str, int] = {}
        for row, label in enumerate(recording.pose.tolist()):
            if row_of.setdefault(label, row) != row:
                raise rows.error(
                    f"pose '{label}' stands in line {rows.line[row_of[label]]} too, but distances name rows by it.",
                    "Give every row a pose of its own.",
                    row=row,
                    column="pose",
                )
        pairs.require("pose_a", "pose_b")
        for name in ("pose_a", "pose_b"):
            for k, label in enumerate(pairs.columns[name]):
                if label not in row_of:
                    problem = f"{Path(recording.path).name} has no pose '{label}'."
                    raise pairs.error(problem, "Correct the name or remove the row.", row=k, column=name)
        indices = np.array([[row_of[label] for label in pairs.columns[name]] for name in ("pose_a", "pose_b")]).T
        if (same := np.flatnonzero(indices[:, 0] == indices[:, 1])).size:
            raise pairs.error("the pose is paired with itself.", "Name two poses.", row=int(same[0]), column="pose_b")
    if need_measured or "distance_mm" in pairs.columns:
        measured = pairs.numbers("distance_mm")[:, 0]
    else:
        measured = np.full(len(indices), np.nan)
    if (negative := np.flatnonzero(measured < 0)).size:
        row = int(negative[0])
        raise pairs.error("a distance cannot be negative.", "Correct the cell.", row=row, column="distance_mm")
    return dataclasses.replace(recording, pairs=indices, pair_measured=measured, pair_line=pairs.line)


# --- writing --------------------------------------------------------------------------------------------------------


def write_recording(recording: Recording, path: str | Path) -> None:
    """Write a recording as CSV with its sidecar and, where there are pairs, its distances file: all or nothing.

    Raises
    ------
    InputError
        A file cannot be written, or the distances file of another recording is in the way.
    """
    path = Path(path)
    if path.suffix == ".parquet":
        raise InputError("recordings are written as CSV.", "Choose a name that ends with .csv.", file=path)
    distances = _distances_path(path)
    columns, pair_columns = file_columns(recording)
    files = {path.with_suffix(".toml"): _sidecar_text(recording)}
    if pair_columns:
        files[distances] = csv_text(pair_columns)
    elif distances.exists():
        raise InputError(
            f"the file is in the way: it would be read as the distances of {path.name}.",
            "Remove it, or choose another name for the recording.",
            file=distances,
        )
    write_files(files | {path: csv_text(columns)})


def write_blocks(parts: Iterable[Recording], path: str | Path) -> int:
    """Write the parts of a recording one after the other, as CSV with its sidecar; return the number of rows.

    The files appear when all is written. The columns are those of the first part.

    Raises
    ------
    InputError
        A file cannot be written; see also `write_recording`.
    """
    path, done, header = Path(path), 0, list[str]()
    if path.suffix != ".csv" or _distances_path(path).exists():
        raise InputError("recordings are written as CSV, and no distances may lie beside it.", "Rename.", file=path)
    staged = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        with staged.open("w", encoding="utf-8", newline="") as file:
            for part in parts:
                columns, blank = file_columns(part)[0], np.full(part.n_rows, np.nan)
                header = header or list(columns)
                text = csv_text({name: columns.get(name, blank) for name in header})
                file.write(text if not done else text.partition("\n")[2])
                done += part.n_rows
                sidecar = _sidecar_text(part)
        write_files({path.with_suffix(".toml"): sidecar})
        os.replace(staged, path)
    except OSError as error:
        raise InputError(
            f"the file cannot be written: {error.strerror}.", "Check the folder and the space on the disk.", file=path
        ) from None
    finally:
        staged.unlink(missing_ok=True)
    return done


def is_recording(path: Path) -> bool:
    """Tell whether a table holds joints and at least one reading; its values are not judged."""

    def filled(table: Path, joints: bool) -> bool:
        with table.open(encoding="utf-8-sig", newline="") as file:
            rows = csv.reader(line for line in file if not line.startswith("#"))
            header = [name.strip() for name in next(rows, [])]
            if joints and not any(_JOINT.fullmatch(name) or _JOINT_OF_END.fullmatch(name) for name in header):
                raise csv.Error("no joints")
            at = [k for k, name in enumerate(header) if name in _MEASURED]
            return any(len(row) > k and row[k].strip() for row in rows for k in at)

    distances = path.with_suffix(".distances.csv")
    try:
        return filled(path, True) or (distances.exists() and filled(distances, False))
    except (OSError, UnicodeDecodeError, csv.Error):
        return False


def file_columns(recording: Recording) -> tuple[dict[str, Any], dict[str, Any]]:
    """Columns of the recording and of its distances, in the units of the files."""
    poses = recording.pose.tolist()
    if recording.pairs is not None and len(set(poses)) < len(poses):
        poses = [str(n + 1) for n in range(len(poses))]  # distances name rows by their pose
    columns: dict[str, Any] = {"pose": poses}
    if recording.targets is not None:
        axes = 3 if "z_mm" in recording.columns or recording.targets[:, 2].any() else 2  # in the plane there is no z
        columns |= zip(POSITION[:axes], recording.targets.T[:axes], strict=True)
        if recording.targets.shape[1] > 3:
            turned = to_vector(recording.targets[:, 3:].reshape(-1, 3, 3)) / DEG
            columns |= list(zip(ROTATION, turned.T, strict=True))[0 if axes == 3 else 2 :]
    else:
        unit, count = recording.joint_unit, recording.joints.shape[1]
        each = zip(joint_names(unit, count), of_joints(unit, count), recording.joints.T, strict=True)
        columns |= {name: [to_file(value, u) for value in q] for name, u, q in each}
        for name, values in zip(recording.columns, recording.measured.T, strict=False):
            columns[name] = [to_file(value, "rad" if name.endswith("_deg") else "mm") for value in values]
    if recording.contact is not None:
        columns["contact"] = recording.contact.tolist()
    if recording.setup_names != _ONE_SETUP:
        columns["setup"] = [recording.setup_names[code] for code in recording.setup]
    if recording.tool is not None:
        columns |= zip(_TOOL, recording.tool.T, strict=True)
    columns |= recording.channels
    if recording.pairs is None or recording.pair_measured is None:
        return columns, {}
    a, b = ([poses[row] for row in rows] for rows in recording.pairs.T)
    return columns, {"pose_a": a, "pose_b": b, "distance_mm": recording.pair_measured}


def _sidecar_text(recording: Recording) -> str:
    fields = dataclasses.fields(Measurement)
    said = {f.name: value for f in fields if (value := getattr(recording.measurement, f.name)) != f.default}
    said.pop("camera", None)
    tables = {"measurement": {"kind": recording.kind, "frame": "unknown"} | said | {"kind": recording.kind}}
    if recording.measurement.camera is not None:
        tables["measurement.camera"] = recording.measurement.camera.model_dump()
    if recording.contact_distances:
        tables["contacts"] = {"distance_mm": recording.contact_distances}
    return toml_text(tables)


def csv_text(columns: Mapping[str, Any]) -> str:
    """CSV text of columns of one length: texts as they are, numbers with all their digits, nan as a blank cell."""
    text = io.StringIO()
    plain, quoted = csv.writer(text, lineterminator="\n"), csv.writer(text, lineterminator="\n", quoting=csv.QUOTE_ALL)
    plain.writerow(columns)
    for row in zip(*columns.values(), strict=True):
        cells = [_cell(value) for value in row]
        # Unquoted, a row that begins with # would read as a comment.
        (quoted if cells[0].startswith("#") else plain).writerow(cells)
    return text.getvalue()


def _cell(value: object) -> str:
    if isinstance(value, str):
        return value
    number = float(value)  # type: ignore[arg-type]
    return "" if np.isnan(number) else repr(number).removesuffix(".0")


def write_files(files: Mapping[Path, str | bytes]) -> None:
    """Write files, texts in UTF-8, replacing old ones only when all are on the disk; raises InputError."""
    staged = {path: path.with_name(f".{path.name}.{os.getpid()}.part") for path in files}
    try:
        for path, content in files.items():
            staged[path].write_bytes(content if isinstance(content, bytes) else content.encode())
        for path, part in staged.items():
            os.replace(part, path)
    except OSError as error:
        raise InputError(
            f"the file cannot be written: {error.strerror}.", "Check the folder and the space on the disk.", file=path
        ) from None
    finally:
        for part in staged.values():
            part.unlink(missing_ok=True)
