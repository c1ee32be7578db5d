"""What motion capture writes, beside a table of joints: C3D (by ezc3d, extra ``c3d``), Motive's and Nexus' CSV.

A marker gives positions, a rigid body of Motive poses. The table of joints has a column ``time_s``; its clock is that
of the capture, or differs from it by an offset that is given.
"""

from __future__ import annotations

import csv
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from deltacal_gen.errors import FileFormat, FileNotReadable, ImportUnclear, NotInstalled, listed, naming
from deltacal_gen.files.dialect import length_mm, text_of
from deltacal_gen.files.imported import Imported, robot_with, write_import
from deltacal_gen.files.lists import joints_in_time
from deltacal_gen.files.rows import Rows, number_of
from deltacal_gen.files.samples import Samples, imported, join
from deltacal_gen.machine.rotation import vector_of_quaternion

Captured = Mapping[str, Samples]  # by the name of a marker or a body
FEW = 8  # names that a message lists


def import_c3d(
    path: str | Path,
    joints: str | Path,
    robot: str | Path | None = None,
    output: str | Path | None = None,
    *,
    readings: str | None = None,
    moving: bool = False,
    offset_s: float = 0.0,
) -> Imported:
    """Import motion capture (``.c3d``, or CSV of Motive or Nexus) and a table of joints.

    Parameters
    ----------
    path : path
        The capture.
    joints : path
        Table with the columns ``time_s`` and ``q1_deg ...``, as `import_points` reads them.
    robot : path, optional
        Robot file, by which the joints are counted.
    output : path, optional
        Folder for recording.csv, and robot.toml.
    readings : str, optional
        Name of the marker or rigid body; needed where several were captured.
    moving : bool
        One row for every frame, also where the joints stand still.
    offset_s : float
        Offset added to the time of the capture [s].

    Raises
    ------
    InputError
        A file cannot be read, or the marker is missing.
    UsageError
        ezc3d is not installed.

    Examples
    --------
    deltacal import c3d session.c3d joints.csv robot.toml -o session
    """
    path = Path(path)
    with naming(path):
        captured = _c3d(path) if path.suffix.lower() == ".c3d" else _table(path)
        name = _chosen(captured, readings)
    time, q, units = joints_in_time(Path(joints))
    seen = replace(captured[name], time=captured[name].time + offset_s)
    joined = join(Samples(str(joints), time, q), seen, moving=moving, path=path)
    machine, own = robot_with(robot, q.shape[1], Path(joints))
    return write_import(imported(joined, own or units, machine, path, (f"readings of {name}",)), output)


def _chosen(captured: Captured, asked: str | None) -> str:
    names = [n for n, samples in captured.items() if np.isfinite(samples.values).any()]
    known = listed(names, FEW) or "none"
    if asked is not None and asked not in names:
        raise ImportUnclear(f"'{asked}' was not captured.", f"There are {known}.")
    if asked is None and len(names) != 1:
        found = f"{len(names)} markers were captured" if names else "no marker was captured"
        raise ImportUnclear(f"{found}.", f"Name one, --readings NAME; there are {known}.")
    return asked or names[0]


def _c3d(path: Path) -> Captured:
    try:
        import ezc3d
    except ImportError:
        raise NotInstalled("C3D needs ezc3d. Install it: pip install 'deltacal_gen[c3d]'.") from None
    if not path.is_file():
        raise FileNotReadable("there is no such file.", "Check the path.")
    try:
        found = ezc3d.c3d(str(path))
        told, points = found["parameters"]["POINT"], found["data"]["points"]
        labels, rate = [str(own) for own in told["LABELS"]["value"]], float(told["RATE"]["value"][0])
        unit = (told["UNITS"]["value"] or ["mm"])[0].strip()
    except Exception as error:  # of a library that lets through whatever is wrong inside a file
        raise FileFormat(f"this is no C3D file: {error}.", "Export it again.") from None
    first = int(found["header"]["points"]["first_frame"])
    time = (first + np.arange(points.shape[2])) / _positive(rate)
    scale = length_mm(unit)
    return {label: Samples(label, time, points[:3, k].T * scale) for k, label in enumerate(labels[: points.shape[1]])}


def _table(path: Path) -> Captured:
    rows = list(csv.reader(text_of(path).split("\n")))
    if rows and rows[0] and rows[0][0].strip() == "Trajectories":
        return _nexus(path, rows)
    head = next((k for k, row in enumerate(rows) if row and row[0].strip() == "Frame"), None)
    if head is None:
        raise FileFormat(
            "this is neither C3D nor a table of Motive or Nexus.",
            "Export the capture as C3D; from Motive as CSV with its header, from Nexus as ASCII with trajectories.",
        )
    return _motive(path, rows, head)


def _motive(path: Path, rows: Sequence[Sequence[str]], head: int) -> Captured:
    """Return what Motive's CSV holds: a header of pairs, then rows Type, Name, ID, what is measured, axes."""
    meta = dict(zip(rows[0][::2], rows[0][1::2], strict=False))
    scale = length_mm(meta.get("Length Units", "Meters").strip())
    above = {row[1].strip(): row for row in rows[:head] if len(row) > 1 and row[1].strip() in ("Type", "Name")}
    if "Name" not in above:
        raise FileFormat("the row with names is missing.", "Export with Motive's header.", line=head + 1)
    kinds = above.get("Type", [""] * len(above["Name"]))
    parts = list(zip(above["Name"], rows[head - 1], rows[head], kinds, strict=False))
    table = _below(path, rows, head + 1, ["frame", "time", *(_part(*own[:3]) for own in parts[2:])])
    time = table.numbers("time")[:, 0]
    quaternions = meta.get("Rotation Type", "Quaternion").strip() == "Quaternion"
    out = {}
    for name in dict.fromkeys(name.strip() for name, *_, kind in parts[2:] if kind.strip() != "Rigid Body Marker"):
        place, turn = [_part(name, "Position", a) for a in "XYZ"], [_part(name, "Rotation", a) for a in "XYZW"]
        if {*place} <= {*table.columns}:
            body = table.numbers(*place) * scale
            if quaternions and {*turn} <= {*table.columns}:
                body = np.hstack([body, vector_of_quaternion(table.numbers(*turn))])
            out[name] = Samples(name, time, body)
    return out


def _part(name: str, measured: str, axis: str) -> str:
    return f"{name.strip()} {measured.strip()} {axis.strip()}"


def _nexus(path: Path, rows: Sequence[Sequence[str]]) -> Captured:
    """Return what Nexus' ASCII holds under "Trajectories": the rate, names, axes, units, and a row to each frame."""
    if len(rows) < 6:
        raise FileFormat("the table ends in its header.", "Export the trajectories again.", line=len(rows))
    rate = number_of(rows[1][0].strip()) if rows[1] else None
    table = _below(path, rows, 5, [f"column {k + 1}" for k in range(len(rows[3]))])
    time = table.numbers("column 1")[:, 0] / _positive(rate or 0.0)
    out = {}
    for k, name in enumerate(map(str.strip, rows[2])):
        if name and k + 3 <= len(rows[3]):
            scale = length_mm(rows[4][k].strip() if k < len(rows[4]) else "mm")
            out[name] = Samples(name, time, table.numbers(*(f"column {n}" for n in range(k + 1, k + 4))) * scale)
    return out


def _below(path: Path, rows: Sequence[Sequence[str]], start: int, names: Sequence[str]) -> Rows:
    """Return what stands below a header, up to the first empty row."""
    end = next((k for k in range(start, len(rows)) if not any(cell.strip() for cell in rows[k])), len(rows))
    if end <= start:
        raise FileFormat("there are no frames below the header.", "Export the capture again.")
    filled = [[*map(str.strip, row), *[""] * (len(names) - len(row))] for row in rows[start:end]]
    columns = {name: [row[k] for row in filled] for k, name in enumerate(names)}
    return Rows(path, columns, np.arange(start, end) + 1, start)


def _positive(rate: float) -> float:
    if not rate > 0:
        raise ImportUnclear("the rate of the frames is missing.", "Export the capture again.")
    return rate
