"""Lists of points, as trackers and their software write them, beside a table of joints: to a recording.

A list holds group, point, X, Y, Z, line by line; whatever stands between the columns, with or without a header, with
decimal points or commas. A group is a set-up of the instrument where there is more than one; a point that comes again
in its group is a repeat. The joints of each point come from a second table, by the point's name.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.files.imported import Imported, write_import
from deltacal_gen.files.lists import (
    GROUP,
    LENGTHS,
    POINT,
    TextTable,
    is_numeric,
    joints_of,
    plain_name,
    read_text_table,
    required_column,
)
from deltacal_gen.files.robot import read_robot
from deltacal_gen.files.rows import number_of
from deltacal_gen.instrument.kinds import POINTS
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Measurement, Recording

ROTATIONS = ("rx", "ry", "rz")
FEW = 3  # names that a message lists


def _rows_of_points(table: TextTable, q: Array, where: int, group: int | None) -> dict[tuple[str, str], int]:
    """Return the row of each point by its group and name; raise an InputError where one has two places."""
    keys: dict[tuple[str, str], int] = {}
    for j, row in enumerate(table.cells):
        key = (row[group] if group is not None else "", row[where])
        if key in keys and not np.array_equal(q[keys[key]], q[j]):
            raise InputError(
                f"the point '{row[where]}' comes twice, with different joints.",
                "Give every point a name of its own, or add a column 'group'.",
                file=table.path,
                line=table.lines[j],
            )
        keys.setdefault(key, j)
    return keys


def import_points(
    points: str | Path, joints: str | Path, robot: str | Path | None = None, output: str | Path | None = None
) -> Imported:
    """Return a recording of positions from a tracker's list of points and a table of joints.

    Parameters
    ----------
    points : path
        Group, point, X, Y, Z in this order, or in any with a header; mm unless the header says m, cm or in.
    joints : path
        A header with the point's name, `q1_deg ...` (`_rad`, `_mm`; `J1`, `A1`, `joint 1 [deg]` are understood too), a
        group where names repeat among groups, and any channel.
    robot : path, optional
        Robot file; it is written beside the recording, and the number of joints is checked.
    output : path, optional
        Folder for recording.csv, and robot.toml.

    Raises
    ------
    InputError
        A cell that is no number, an angle without a unit, no point that both files name.
    """
    measured, table = _points(Path(points)), read_text_table(Path(joints))
    where, names = required_column(table, POINT, "the point's name"), measured[1]
    group = table.column(GROUP)
    q, unit, used = joints_of(table)
    machine = None if robot is None else read_robot(robot)
    if machine is not None and len(machine.joint_sign) not in (1, q.shape[1]):
        raise InputError(
            f"the table has {q.shape[1]} joints, the robot {len(machine.joint_sign)}.",
            "Give the joints of the robot file, in its order.",
            file=table.path,
        )
    keys = _rows_of_points(table, q, where, group)
    groups = measured[0]
    rows = [keys.get((g if group is not None else "", p)) for g, p in zip(groups, names, strict=True)]
    taken = [i for i, j in enumerate(rows) if j is not None]
    if not taken:
        raise InputError(
            f"no point of the list ({', '.join(names[:FEW])}) is in the table of joints "
            f"({', '.join(row[where] for row in table.cells[:FEW])}).",
            "Name the points alike in both files.",
            file=table.path,
        )
    of_row = np.array([j for j in rows if j is not None])
    setups = list(dict.fromkeys(groups[i] for i in taken))
    recording = Recording(
        path=Path(points),
        kind=POINTS,
        measurement=Measurement(kind=POINTS, frame="unknown"),
        joint_unit=unit,
        joints=q[of_row],
        columns=("x_mm", "y_mm", "z_mm"),
        measured=measured[2][taken],
        pose=np.array([names[i] for i in taken]),
        line=np.array([measured[3][i] for i in taken]),
        channels={
            table.header[c].strip(): table.numbers(c)[of_row]
            for c in range(len(table.header))
            if c not in (where, group, *used) and is_numeric(table, c)
        },
        setup=np.array([setups.index(groups[i]) for i in taken]),
        setup_names=tuple(setups),
    )
    warnings = []
    if lost := [names[i] for i, j in enumerate(rows) if j is None]:
        warnings.append(f"{len(lost)} points have no joints ({', '.join(lost[:FEW])}{' ...' * (len(lost) > FEW)})")
    seen = set(of_row.tolist())
    if idle := [row[where] for j, row in enumerate(table.cells) if j not in seen]:
        warnings.append(f"{len(idle)} joints have no point ({', '.join(idle[:FEW])}{' ...' * (len(idle) > FEW)})")
    header = read_text_table(Path(points)).header
    if turns := [head.strip() for head in header if plain_name(head)[0] in ROTATIONS]:
        warnings.append(
            f"{', '.join(turns)} are not read: a list is of positions. Rotations stand in a recording of kind pose, as "
            "rx_deg, ry_deg, rz_deg; its sidecar says what their angles are"
        )
    return write_import(Imported(machine, {"recording": recording}, tuple(warnings)), output)


def _points(path: Path) -> tuple[list[str], list[str], Array, list[int]]:
    """Return groups, names, positions (N, 3) [mm] and lines of a list of points."""
    table = read_text_table(path)
    if table.header:
        where, group = required_column(table, POINT, "the point's name"), table.column(GROUP)
        axes = [required_column(table, (a,), a.upper()) for a in "xyz"]
        units = [plain_name(table.header[a])[1] or table.unit or "mm" for a in axes]
    else:
        width = min(len(row) for row in table.cells)
        if width < 4:
            raise InputError(
                f"a line has {width} cells, where group, point, X, Y, Z were expected.",
                "Export the points with their group and name, in this order.",
                file=path,
                line=next(n for n, row in zip(table.lines, table.cells, strict=True) if len(row) == width),
            )
        first = next(c for c in range(width) if all(number_of(row[c]) is not None for row in table.cells) or c == 2)
        first = max(first, 1)
        where, group, axes, units = (
            first - 1,
            first - 2 if first > 1 else None,
            [first, first + 1, first + 2],
            [table.unit or "mm"],
        )
    bad = next((u for u in units if u not in LENGTHS), None)
    if bad is not None:
        raise InputError(f"'{bad}' is no unit of length.", f"Known: {', '.join(LENGTHS)}.", file=path)
    scale = [LENGTHS[u] for u in units]
    xyz = np.column_stack([table.numbers(c) for c in axes]) * scale
    groups = [row[group] if group is not None else "points" for row in table.cells]
    return groups, [row[where] for row in table.cells], xyz, table.lines
