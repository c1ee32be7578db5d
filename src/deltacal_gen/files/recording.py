"""Recordings: what the controller reported and what the instrument read, one row per reading.

A recording is a CSV or Parquet file, an optional sidecar ``NAME.toml`` that says what was measured and how, and,
where distances between two rows were measured, ``NAME.distances.csv``. Everything that can be wrong without knowing
the kinematics is caught here, with file, line, column and remedy: a recording that was read can be trusted to be
complete. Joints and measured quantities are converted to mm and rad; the other channels keep the unit in their name.
"""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TypedDict, Unpack

import numpy as np

from deltacal_gen.errors import BadValue, ContradictingRows, InputError, MissingColumn, NoReadings, WrongKind
from deltacal_gen.files.checks import check_home, check_repeats, impossible
from deltacal_gen.files.columns import (
    DRIVE,
    JOINT,
    MEASURED,
    ONE_SETUP,
    RESERVED,
    TOOL,
    distances_path,
    instrument_path,
    is_channel,
)
from deltacal_gen.files.dialect import LOOKED_AT
from deltacal_gen.files.frames import rows_of
from deltacal_gen.files.logged import put_right
from deltacal_gen.files.rows import Rows, number_of, read_csv, read_table
from deltacal_gen.files.sidecar import Sidecar, measurement_of, read_sidecar
from deltacal_gen.instrument import kinds
from deltacal_gen.instrument.kind import Kind
from deltacal_gen.instrument.kinds import PAIRS, POINTS, kind_of
from deltacal_gen.machine.registry import POSE, Machine
from deltacal_gen.machine.rotation import from_turns, from_vector, to_vector, vector_of_quaternion
from deltacal_gen.machine.values import POSITION, ROTATION, Recording
from deltacal_gen.results.parts import InstrumentState
from deltacal_gen.results.reader import TORQUE
from deltacal_gen.states import of_column
from deltacal_gen.units import DEG, joint_factors, joint_names

NO_TURN = 1e-9  # rad: what is left of a turn of zero after somebody's arithmetic
QUATERNION = 0.01  # by which one may be longer or shorter than 1: it was rounded
_QUATERNION = re.compile(r"(?P<of>(?:.*[._ ])?(?:q|quat|quaternion|orientation|rotation|rot))[._ ]?(?P<axis>[xyzw])")
_JOINT_LIKE = re.compile(r"q\d", re.IGNORECASE)  # meant as joints, though perhaps misspelt
_JOINT_OF_END = re.compile(r"q\d+[ab]_(deg|mm|rad)")
_END = re.compile(r"(?P<stem>.+?)_?(?P<end>[ab])(?P<unit>(_[A-Za-z]+\d?)*)")  # q1a_deg, payload_a_kg, approach1b


class Asked(TypedDict, total=False):
    """What a recording is read for; see `read_recording`."""

    need_measured: bool
    allow_targets: bool
    doubtful: bool
    like: InstrumentState | None


def read_recording(path: str | Path, mechanism: Machine, **asked: Unpack[Asked]) -> Recording:
    """Read a recording with its sidecar and its distances file.

    Parameters
    ----------
    path : path
        CSV, Parquet by the ending ``.parquet``, or a workbook by ``.xlsx``.
    mechanism : Machine
        Says how many joints there are and whether they turn or slide.
    need_measured : bool
        Whether a recording without a single reading is an error; it is by default.
    allow_targets : bool
        Whether positions without joints are taken as targets.
    doubtful : bool
        Whether channels are taken that hold values which cannot be, for `set_aside` to judge.
    like : InstrumentState, optional
        The instrument whose readings are requested, where neither sidecar nor columns say another.

    Raises
    ------
    InputError
        The recording cannot be used; the message names file, line, column and remedy.
    """
    path = Path(path)
    return recording_of_rows(read_table(path), read_sidecar(path), mechanism, **asked)


def recording_of(frame: object, mechanism: Machine, **asked: Unpack[Asked]) -> Recording:
    """Return a data frame, or what makes one (``to_dataframe()``, ``to_pandas()``), as a recording.

    Columns are those of a file, in any of its units. What a sidecar would say stands in ``attrs``:
    ``frame.attrs["measurement"] = {"frame": "robot", "sigma_mm": 0.01}``.

    Raises
    ------
    UsageError
        It is no data frame.
    InputError
        As `read_recording`; lines count the rows from 1.
    """
    return recording_of_rows(*rows_of(frame), mechanism, **asked)


def recording_of_rows(
    rows: Rows,
    sidecar: Sidecar,
    mechanism: Machine,
    *,
    need_measured: bool = True,
    allow_targets: bool = False,
    doubtful: bool = False,
    like: InstrumentState | None = None,
) -> Recording:
    """Return a table that has been read as a recording; see `read_recording`."""
    path, measurement = rows.path, measurement_of(sidecar)
    pairs, rows = _pairs_and_rows(path, rows)
    rows, targets = _from_quaternions(rows, measurement.rotation, mechanism.axes), None
    axes = tuple(f"{axis}_mm" for axis in mechanism.axes)
    if allow_targets and not any(map(_JOINT_LIKE.match, rows.columns)) and set(axes) & set(rows.columns):
        targets, rows = targets_of(rows, mechanism, measurement.rotation)
        joints = np.full((len(targets), mechanism.limbs), np.nan)
    else:
        joints = _joints(rows, mechanism)

    asked = None if like is None or pairs is not None else kind_of(like.kind)
    kind = _kind(rows, measurement.kind, mechanism, pairs is not None, need_measured, asked)
    columns = kind.read_in(kind.columns(mechanism), rows.columns)
    if like is not None and like.columns and kind == asked:
        columns = like.columns
    kind.check(measurement, sidecar.contacts.distance_mm, rows.columns, path.with_suffix(".toml"))
    pose = rows.labels("pose") or [str(n + 1) for n in range(len(joints))]
    setup_names, setup = np.unique(rows.labels("setup", blank=False) or ONE_SETUP * len(joints), return_inverse=True)
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
        channels={name: values for name in rows.columns if (values := _channel(rows, name, doubtful)) is not None}
        | {name: rows.numbers(name, blank=False)[:, 0] for name in kind.known},
        setup=setup,
        setup_names=tuple(setup_names.tolist()),
        tool=rows.numbers(*TOOL) if set(TOOL) & set(rows.columns) else None,
        targets=targets,
        contact=np.array(rows.columns["contact"]) if {"contact"} & set(columns) & set(rows.columns) else None,
        contact_distances=sidecar.contacts.distance_mm,
    )
    if pairs is not None:
        recording = _with_pairs(recording, pairs, rows, need_measured and kind.pairs)
    else:
        check_repeats(recording, rows)
    counts_from_home = measurement.zero == "incremental" and any(key.key == "home" for key in mechanism.geometry)
    if need_measured and counts_from_home:
        check_home(recording)
    label = rows.labels("run")
    run = [f"set-up '{setup_names[k]}'" for k in setup] if label is None else [f"run '{own}'" for own in label]
    recording = put_right(_with_vectors(recording), run, read=need_measured)
    if need_measured and not _is_measured(recording):
        raise NoReadings("no row holds a reading.", f"Fill in {', '.join(recording.columns)}.", file=path)
    return recording


def _from_quaternions(rows: Rows, order: str, axes: Sequence[str]) -> Rows:
    """Return rows of positions in space with rotation vectors for the quaternions beside them; others as they are.

    Parameters
    ----------
    rows : Rows
    order : str
        ``rotation`` of the sidecar.
    axes : sequence of str
        Along which the machine moves.

    Raises
    ------
    InputError
        Numbers that are no quaternion; turns in an order, which these are not.
    """
    names = _quaternion_of(rows.columns)
    placed = len(axes) == len(POSITION) and {*POSITION} <= {*rows.columns}
    if names is None or not placed or {*ROTATION} & {*rows.columns}:
        return rows
    if order != "vector":
        raise rows.error(
            f'rotation = "{order}" in the sidecar is an order of turns, but the rotation here is a quaternion.',
            "Leave the key out: a quaternion needs none.",
            column=names[0],
        )
    read = rows.numbers(*names)
    lengths = np.linalg.norm(read, axis=1)
    rows.refuse(
        np.abs(lengths - 1) > QUATERNION,
        lambda k: f"{', '.join(names)} are no rotation: a quaternion has the length 1, this one {lengths[k]:.4g}.",
        "Correct the row, or blank its rotation; where these columns are something else, rename them.",
        column=names[0],
    )
    vectors = (vector_of_quaternion(read) / DEG).T.tolist()
    told = {name: ["" if v != v else repr(v) for v in own] for name, own in zip(ROTATION, vectors, strict=True)}
    return dataclasses.replace(rows, columns=rows.without(names).columns | told)


def _quaternion_of(columns: Iterable[str]) -> tuple[str, ...] | None:
    """Return which columns are x, y, z, w of a quaternion; None where there is none, or more than one."""
    found: dict[str, dict[str, str]] = {}
    for name in columns:
        if (part := _QUATERNION.fullmatch(name.lower())) is not None:
            found.setdefault(part["of"], {})[part["axis"]] = name
    whole = [own for own in found.values() if len(own) == len("xyzw")]
    return tuple(whole[0][axis] for axis in "xyzw") if len(whole) == 1 else None


def _with_vectors(recording: Recording) -> Recording:
    """Return the recording with rotation vectors where its file has turns about x, y, z."""
    order, measurement = recording.measurement.rotation, dataclasses.replace(recording.measurement, rotation="vector")
    if order == "vector" or recording.targets is not None:
        return dataclasses.replace(recording, measurement=measurement)
    at = [recording.columns.index(name) for name in ROTATION if name in recording.columns]
    if len(at) < len(ROTATION):
        raise BadValue(
            f'rotation = "{order}" says in which order the turns rx_deg, ry_deg, rz_deg are made, which are not all '
            "measured here.",
            "Leave the key out, or add the columns.",
            file=Path(recording.path).with_suffix(".toml"),
        )
    measured = recording.measured.copy()
    read = np.isfinite(measured[:, at]).all(axis=1)
    measured[np.ix_(read, at)] = to_vector(from_turns(order, measured[np.ix_(read, at)]))
    return dataclasses.replace(recording, measured=measured, measurement=measurement)


def _pairs_and_rows(path: Path, rows: Rows) -> tuple[Rows | None, Rows]:
    """Return the table of distances, if there is one, and the table of rows.

    A row that holds both joint sets becomes two rows, labelled with a and b behind its pose.
    """
    if not any(_JOINT_OF_END.fullmatch(name) for name in rows.columns):
        distances = distances_path(path)
        return (read_csv(distances) if distances.exists() else None), rows
    ends: dict[str, dict[str, str]] = {}
    for name in rows.columns:
        if end := _END.fullmatch(name):
            ends.setdefault(end["stem"] + end["unit"], {})[end["end"]] = name
    for name, found in ends.items():
        if len(found) == 1 and JOINT.fullmatch(name):
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


def _turns(rows: Rows, mechanism: Machine) -> tuple[str, ...]:
    """Return the columns of a rotation: those about which a platform turns, and others that are there."""
    return tuple(turn for turn in ROTATION if turn[1] in mechanism.turns or turn in rows.columns)


def _angles(rows: Rows, mechanism: Machine, turns: Sequence[str]) -> np.ndarray:
    """Return what the columns of a rotation hold (N, 3) [rad], zero where one is left out.

    Raises
    ------
    InputError
        Cells are missing, or the platform would have to turn about an axis about which it does not.
    """
    angles = np.zeros((len(rows.line), 3))
    angles[:, [ROTATION.index(turn) for turn in turns]] = rows.numbers(*turns, blank=False) * DEG
    for turn in turns:
        if turn[1] not in mechanism.turns:
            tilted = np.abs(angles[:, ROTATION.index(turn)]) > NO_TURN
            problem = f"the platform of '{mechanism.name}' does not turn about {turn[1]}."
            rows.refuse(tilted, problem, "Write 0, or leave the column out.", column=turn)
    return angles


def targets_of(rows: Rows, mechanism: Machine, rotation: str = "vector") -> tuple[np.ndarray, Rows]:
    """Return targets (N, 3), or poses (N, 12) of a machine that turns on command, and the rows without their columns.

    `rotation` says what the angles are; see `machine.values.Measurement`.

    Raises
    ------
    InputError
        Cells are missing, or how the machine shall stand is not said, or it cannot stand so.
    """
    axes, turns = tuple(f"{axis}_mm" for axis in mechanism.axes), _turns(rows, mechanism)
    targets = np.zeros((len(rows.line), 3))
    given = [axis for axis in axes if f"p{axis[0]}" in mechanism.asks or axis in rows.columns]
    targets[:, [POSITION.index(axis) for axis in given]] = rows.numbers(*given, blank=False)
    if POSE in mechanism.widths and set(turns) & set(rows.columns):
        angles = _angles(rows, mechanism, turns)
        turned = from_vector(angles) if rotation == "vector" else from_turns(rotation, angles)
        return np.hstack([targets, turned.reshape(-1, 9)]), rows.without((*axes, *turns))
    if 3 not in mechanism.widths:
        raise rows.error(
            f"a position alone does not say how {mechanism.sort} shall stand.",
            "Add rx_deg, ry_deg, rz_deg (a rotation vector of the last frame in {O}), or give joints instead.",
            column=axes[0],
            family=MissingColumn,
        )
    return targets, rows.without(axes)


def _joints(rows: Rows, mechanism: Machine) -> np.ndarray:
    names = joint_names(mechanism.joint_unit, mechanism.limbs)
    joints = rows.numbers(*names, blank=False) * joint_factors(mechanism.joint_unit, mechanism.limbs)
    for name in rows.columns:
        if JOINT.fullmatch(name) and name not in names:
            raise rows.error(
                f"'{mechanism.name}' has the joints {', '.join(names)} only.",
                "Rename or remove the column, or correct the mechanism in the robot file.",
                column=name,
                family=WrongKind,
            )
    return joints


def _kind(
    rows: Rows, said: str | None, mechanism: Machine, paired: bool, need_measured: bool, asked: Kind | None
) -> Kind:
    """Kind of the recording: what the sidecar says, checked against the columns, or what the columns say.

    Where neither says anything else, it is the one that is asked for.
    """
    columns = {kind: kind.columns(mechanism) for kind in map(kind_of, kinds.names())}
    present = _present(columns, rows.columns)
    stated = None if said is None else kind_of(said)
    stated = next((kind for kind in present if stated is not None and kind.under == stated.name), stated)
    if asked is not None and (stated is None or asked.under == stated.name):
        own = {*columns[asked], *asked.known}
        if not any({*columns[kind]} & {*rows.columns} - own for kind in present):
            return asked
    known = () if stated is None else stated.known
    present = [kind for kind in present if not {*columns[kind]} & {*rows.columns} <= {*known}]
    between = [kind for kind in (stated, *present) if kind is not None and kind.pairs]
    if between and not paired:
        name = distances_path(rows.path).name
        raise rows.error(
            "distances lie between two points, but the rows hold one joint set each.",
            f"Add {name} with the columns pose_a, pose_b, distance_mm, or name the joints q1a_..., q1b_... here.",
            column="distance_mm",
            family=MissingColumn,
        )
    if stated is not None:
        # a kind with more columns than another may be read as that one
        if not stated.pairs and present and not any(set(columns[stated]) <= set(columns[kind]) for kind in present):
            other = present[0]
            raise rows.error(
                f"the sidecar says kind = '{said}', but this column belongs to kind = '{other.name}'.",
                f"Correct the sidecar, or give the columns {', '.join(columns[stated])}.",
                column=next(name for name in columns[other] if name in rows.columns),
                family=WrongKind,
            )
        return stated
    if len(present) > 1:
        raise rows.error(
            f"the columns hold readings of several kinds: {', '.join(kind.name for kind in present)}.",
            f"Say which to use: kind = '...' under [measurement] in {rows.path.with_suffix('.toml').name}.",
            family=WrongKind,
        )
    if not present and need_measured and not paired:
        if (drive := next(filter(DRIVE.fullmatch, rows.columns), None)) is not None:
            raise rows.error(
                "this is what a drive gives, and the sidecar does not say that the recording is in motion.",
                f"Write kind = '{TORQUE}' under [measurement] in {rows.path.with_suffix('.toml').name}.",
                column=drive,
                family=WrongKind,
            )
        raise rows.error(
            "no column holds a measured quantity.",
            f"Add one of: {'; '.join(', '.join(names) for names in columns.values())}.",
            family=MissingColumn,
        )
    return next(iter(present), kind_of(PAIRS if paired else POINTS))


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
    found = [kind for kind in found if not any(kind in within[larger] for larger in found)]
    # what one kind is read of may be what another reads
    return [k for k in found if not any(own[k] & there <= {*other.known} for other in found if other != k)]


def _measured(rows: Rows, kind: Kind, columns: tuple[str, ...], need_measured: bool) -> np.ndarray:
    if not kind.numbers:
        if need_measured and not kind.pairs:
            rows.require(*columns)
        return np.empty((len(rows.line), 0))
    if not need_measured and not set(columns) & set(rows.columns):
        return np.full((len(rows.line), len(columns)), np.nan)
    factors = [DEG if name.endswith("_deg") else 1.0 for name in columns]
    if kind.apart and set(columns) & set(rows.columns):
        return rows.each(*columns) * factors
    for name, value in kind.filled.items():
        rows = rows.filled(name, value, next(n for n in columns if n != name))
    # what is in one unit is read together: a tracker may read a point without its rotation, but not part of a point
    units = [name.rpartition("_")[2] for name in columns]
    parts = [[name for name, u in zip(columns, units, strict=True) if u == unit] for unit in dict.fromkeys(units)]
    return np.hstack([rows.numbers(*names) for names in parts]) * factors


def _is_measured(recording: Recording) -> bool:
    paired = recording.pair_measured is not None and bool(np.isfinite(recording.pair_measured).any())
    touched = recording.contact is not None and bool((recording.contact != "").any())
    # the first column: a rotation without its point, which comes before it, is no reading
    own = recording.measured if kind_of(recording.kind).apart else recording.measured[:, :1]
    return paired or touched or bool(np.isfinite(own).any())


def _channel(rows: Rows, name: str, doubtful: bool) -> np.ndarray | None:
    """(N,) values of a channel or covariate; None for other columns, and for those that hold text only.

    A value that cannot be is an error, unless `doubtful` ones are taken as they are.
    """
    if name in RESERVED or JOINT.fullmatch(name):
        return None
    if name == "run" and any(cell and number_of(cell) is None for cell in rows.columns[name]):
        numbers = {label: k for k, label in enumerate(dict.fromkeys(filter(None, rows.columns[name])), start=1)}
        return np.array([numbers.get(label, np.nan) for label in rows.columns[name]])  # in the order of their names
    if not is_channel(name) and all(number_of(cell) is None for cell in rows.columns[name]):
        return None
    values = rows.numbers(name)[:, 0]
    if of_column(name).levels:
        values[values == 0] = np.nan  # one of its levels, but not known which
    wrong, expected = impossible(name, values)
    remedy = "Correct the cell, or leave it blank if it is not known."
    rows.refuse(
        wrong & (not doubtful), lambda k: f"the cell holds '{rows.columns[name][k]}': {expected}.", remedy, column=name
    )
    return values


def _with_pairs(recording: Recording, pairs: Rows, rows: Rows, need_measured: bool) -> Recording:
    if pairs.path == recording.path:  # both joint sets in one row
        check_repeats(recording, rows)
        indices = np.arange(recording.n_rows).reshape(-1, 2)
    else:
        indices = _named_pairs(recording, pairs, rows)
    if need_measured:
        pairs.require("distance_mm")
    measured = pairs.each("distance_mm")[:, 0]
    pairs.refuse(measured < 0, "a distance cannot be negative.", "Correct the cell.", column="distance_mm")
    stands = recording.joints if recording.targets is None else recording.targets
    at = stands if recording.tool is None else np.hstack([stands, np.nan_to_num(recording.tool)])
    alike = (at[indices[:, 0]] == at[indices[:, 1]]).all(axis=1)
    pairs.refuse(
        np.isfinite(measured) & alike,
        "both ends of the distance have the same joints and measured point: a pose and its own repeat, which tell "
        "nothing of the machine.",
        "Remove the row.",
        family=ContradictingRows,
    )
    return dataclasses.replace(recording, pairs=indices, pair_measured=measured, pair_line=pairs.line)


def _named_pairs(recording: Recording, pairs: Rows, rows: Rows) -> np.ndarray:
    """Return which two rows each distance (K, 2) lies between, by the names of their poses."""
    poses = recording.pose.tolist()
    first = {label: row for row, label in reversed([*enumerate(poses)])}
    rows.refuse(
        np.array([first[label] != row for row, label in enumerate(poses)]),
        lambda k: f"pose '{poses[k]}' stands in line {rows.line[first[poses[k]]]} too, but distances name rows by it.",
        "Give every row a pose of its own.",
        column="pose",
        family=ContradictingRows,
    )
    pairs.require("pose_a", "pose_b")
    a, b = pairs.columns["pose_a"], pairs.columns["pose_b"]
    for name, cells in (("pose_a", a), ("pose_b", b)):
        lost = np.array([label not in first for label in cells])
        problem = f"{Path(recording.path).name} has no pose '{cells[int(np.argmax(lost))]}'."
        pairs.refuse(lost, problem, "Correct the name or remove the row.", column=name)
    pairs.refuse(
        np.array(a) == np.array(b),
        "the pose is paired with itself.",
        "Name two poses.",
        column="pose_b",
        family=ContradictingRows,
    )
    return np.array([[first[label] for label in cells] for cells in (a, b)]).T


def is_recording(path: Path) -> bool:
    """Tell whether a table holds joints, and it or a file that belongs to it a reading; its values are not judged."""

    def filled(table: Path) -> bool:
        return any(
            any(any(begun.columns[name]) for name in begun.columns if name in MEASURED)
            for begun in (read_csv(table, first) for first in (LOOKED_AT, None))
        )

    try:
        joints = any(JOINT.fullmatch(n) or _JOINT_OF_END.fullmatch(n) for n in read_csv(path, LOOKED_AT).columns)
        return joints and any(
            own.exists() and filled(own) for own in (path, distances_path(path), instrument_path(path))
        )
    except InputError:
        return False
