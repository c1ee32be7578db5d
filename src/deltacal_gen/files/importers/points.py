"""Lists of points, as trackers and their software write them, beside a table of joints: to a recording.

A list holds group, point, X, Y, Z, line by line; whatever stands between the columns, with or without a header, with
decimal points or commas. A group is a set-up of the instrument where there is more than one; a point that comes again
in its group is a repeat. The joints of each point come from a second table, by the point's name.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from deltacal_gen.errors import ImportUnclear, listed
from deltacal_gen.files.columns import JOINT
from deltacal_gen.files.imported import Imported, recorded, robot_with, write_import
from deltacal_gen.files.lists import GROUP, POINT, is_table_of_joints, joints_of, points_of, read_list
from deltacal_gen.files.rows import Rows
from deltacal_gen.instrument.kinds import POINTS
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import POSITION

ROTATION = re.compile(r"r[xyz](_deg)?", re.IGNORECASE)
LISTS = (".csv", ".txt", ".tsv", ".asc")  # ends of the names of lists and tables
FEW = 3  # names that a message lists


def recognise(folder: Path) -> Iterator[tuple[Path, tuple[Path, ...]]]:
    """Yield the list of points in a folder that holds one, a table of joints, and a robot file."""
    lists = [path for path in sorted(folder.iterdir()) if path.suffix in LISTS]
    joints = [path for path in lists if is_table_of_joints(path)]
    robot = folder / "robot.toml"
    if robot.exists() and len(lists) == 2 and len(joints) == 1:
        points = next(path for path in lists if path not in joints)
        yield points, (points, *joints, robot)


def import_points(
    points: str | Path, joints: str | Path, robot: str | Path | None = None, output: str | Path | None = None
) -> Imported:
    """Import a tracker's list of points and a table of joints.

    Parameters
    ----------
    points : path
        List of group, point, X, Y, Z, in any order with a header; mm unless the header says m, cm or in.
    joints : path
        Table with the point's name and `q1_deg ...` (`_rad`, `_mm`; also `J1`, `A1`, `joint 1 [deg]`); a group where
        names repeat among groups, and any channel.
    robot : path, optional
        Robot file; it is written beside the recording, and the number of joints is checked.
    output : path, optional
        Folder for recording.csv, and robot.toml.

    Raises
    ------
    InputError
        A cell that is no number, an angle without a unit, no point that both files name.

    Examples
    --------
    deltacal import points points.txt joints.csv robot.toml -o session
    """
    measured, table = read_list(Path(points)), read_list(Path(joints))
    groups, names = points_of(measured)
    table_groups, table_names = points_of(table)
    q, units = joints_of(table)
    machine, _ = robot_with(robot, q.shape[1], table.path)
    row_of = _rows_of_points(table, table_groups, table_names, q)
    rows = [row_of.get((g if any(table_groups) else "", p)) for g, p in zip(groups, names, strict=True)]
    taken = [i for i, j in enumerate(rows) if j is not None]
    if not taken:
        raise ImportUnclear(
            f"no point of the list ({listed(names, FEW)}) is in the table of joints ({listed(table_names, FEW)}).",
            "Name the points alike in both files.",
            file=table.path,
        )
    of_row = np.array([j for j in rows if j is not None])
    setups = list(dict.fromkeys(groups[i] for i in taken))
    recording = recorded(
        measured.path,
        POINTS,
        units,
        q[of_row],
        POSITION,
        measured.numbers(*POSITION)[taken],
        pose=np.array([names[i] for i in taken]),
        line=measured.line[taken],
        channels={
            name: values[of_row] for name, values in table.numeric(POINT, GROUP).items() if not JOINT.fullmatch(name)
        },
        setup=np.array([setups.index(groups[i]) for i in taken]),
        setup_names=tuple(name or "points" for name in setups),
    )
    warnings = []
    if lost := [names[i] for i, j in enumerate(rows) if j is None]:
        warnings.append(f"{len(lost)} points have no joints ({listed(lost, FEW)})")
    if idle := [name for j, name in enumerate(table_names) if j not in set(of_row.tolist())]:
        warnings.append(f"{len(idle)} joints have no point ({listed(idle, FEW)})")
    if turns := [name for name in measured.columns if ROTATION.fullmatch(name)]:
        warnings.append(
            f"{', '.join(turns)} are not read: a list is of positions. Rotations stand in a recording of kind pose, as "
            "rx_deg, ry_deg, rz_deg; its sidecar says what their angles are"
        )
    return write_import(Imported(machine, {"recording": recording}, tuple(warnings)), output)


def _rows_of_points(table: Rows, groups: list[str], names: list[str], q: Array) -> dict[tuple[str, str], int]:
    """Return the row of each point by its group and name; raise an InputError where one has two places."""
    row_of: dict[tuple[str, str], int] = {}
    for j, key in enumerate(zip(groups, names, strict=True)):
        if not np.array_equal(q[row_of.setdefault(key, j)], q[j]):
            raise table.error(
                f"the point '{key[1]}' comes twice, with different joints.",
                "Give every point a name of its own, or add a column 'group'.",
                row=j,
                family=ImportUnclear,
            )
    return row_of
