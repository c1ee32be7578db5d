"""Lookup tables of corrected commands: written, read back, and how far they miss."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import ConfigDict, Field
from scipy.interpolate import RegularGridInterpolator
from scipy.ndimage import binary_dilation

from deltacal_gen.errors import ExportNotPossible, FileFormat, InputError, NotForThisMachine, ValueOutOfRange
from deltacal_gen.files.toml import Number, Positive, Table, TomlFile, Vector, read_text
from deltacal_gen.files.writing import write_files
from deltacal_gen.identification.accuracy import workspace_of
from deltacal_gen.machine.registry import SOLVED, UNREACHABLE, Array
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.result import Result
from deltacal_gen.units import file_unit, to_internal
from deltacal_gen.use.compensation import Compensator, CompensatorKind, RoundTrip, largest, workspace_points
from deltacal_gen.use.exporters import Exporter
from deltacal_gen.use.layout import laid_out
from deltacal_gen.use.spans import (
    LEFT_OUT,
    Column,
    Spans,
    after_jumps,
    columns_of,
    drawn,
    factor,
    missed,
    spans,
    stated,
    taken_apart,
)

LARGEST_TABLE = 200_000  # nodes times columns: beyond, the file has tens of megabytes and C is the better export
TABLE_DECIMALS = 7  # of a correction in deg or mm: at a metre, 2e-6 mm
ON_THE_RIM = 1e-9  # of a step: a target on the rim may round to beyond it
_CHUNK = 100_000  # points evaluated at once
_SCHEMA = "deltacal.table/1"


class _Header(Table):
    """The lines ``#:`` of a table."""

    model_config = ConfigDict(populate_by_name=True)

    form: Literal["deltacal.table/1"] = Field(alias="schema")
    worst_mm: Number
    missed: int
    robot: str
    mechanism: str
    model: str
    kind: CompensatorKind
    digest: str = Field(alias="parameters_sha256")
    tool: Vector = Field(alias="tool_mm")
    origin: Vector = Field(alias="origin_mm")
    step: Annotated[tuple[Positive, ...], Field(alias="step_mm", min_length=3, max_length=3)]
    nodes: Annotated[tuple[Annotated[int, Field(ge=2)], ...], Field(min_length=3, max_length=3)]
    columns: tuple[Column, ...] = ((),)


@dataclass(frozen=True, eq=False)
class TableCompensator:
    """Corrections of joint commands on a regular grid, interpolated between its nodes (trilinear).

    Parameters
    ----------
    origin, step : (3,) arrays
        First node and spacing along x, y, z [mm].
    corrections : (n_x, n_y, n_z, columns, n_q) array
        To be added to the nominal joints, as the controller counts [rad or mm, per unit of the column's channels]; NaN
        where out of reach.
    worst_mm : float
        Worst position error over the workspace, compensated by this table [mm].
    missed : int
        Checked points of the workspace for which the table has no answer.
    robot, mechanism, model, kind, digest : str
        Of the `Compensator` it was made from.
    joint_unit : {"rad", "mm"}
    tool : (3,) array
        The reference point in {O'} for which it holds [mm].
    columns : tuple
        Products of channels that the corrections go with: warming [K over 20 degC], payload [kg], time [h],
        approach1 ... [1]; the first is the correction at reference.
    """

    origin: Array
    step: Array
    corrections: Array
    worst_mm: float
    missed: int
    robot: str
    mechanism: str
    model: str
    kind: CompensatorKind
    digest: str
    joint_unit: str
    tool: Array
    columns: tuple[Column, ...] = ((),)

    @property
    def nodes(self) -> tuple[int, ...]:
        """Number of nodes along x, y, z."""
        return self.corrections.shape[:3]

    @property
    def axes(self) -> list[Array]:
        """Where the nodes lie along x, y, z [mm]."""
        return [first + step * np.arange(n) for first, step, n in zip(self.origin, self.step, self.nodes, strict=True)]

    def correction(
        self, targets: Array, channels: Mapping[str, Array | float] | None = None
    ) -> tuple[Array, np.ndarray]:
        """Return what to add to the nominal joints at targets (N, 3) [mm].

        Parameters
        ----------
        channels : mapping of (N,) arrays or numbers, optional
            By the names of the columns; one that is not given stays at reference.

        Returns
        -------
        correction : (N, n_q) array
            As the controller counts [rad or mm]; NaN beside the grid and where one of the 8 nodes is out of reach.
        status : (N,) int array
            SOLVED, or UNREACHABLE where there is no correction.
        """
        values = {name: 0.0 for column in self.columns for name in column} | dict(channels or {})
        targets = np.asarray(targets, dtype=float)
        if targets.ndim != 2 or targets.shape[1] != 3:
            raise ValueError(f"targets have the shape {targets.shape}, but must have (N, 3).")
        ends = self.origin, self.origin + self.step * (np.array(self.nodes) - 1)
        within = np.clip(targets, *ends)
        on_the_rim = np.abs(targets - within) < ON_THE_RIM * self.step
        grid = RegularGridInterpolator(self.axes, self.corrections, bounds_error=False, fill_value=np.nan)
        found = grid(np.where(on_the_rim, within, targets))
        factors = np.stack([np.broadcast_to(factor(c, values), len(targets)) for c in self.columns], axis=1)
        total = np.einsum("nk,nkj->nj", factors, found)
        return total, np.where(np.isnan(total).any(axis=1), UNREACHABLE, SOLVED)


def export_table(
    compensator: Compensator,
    path: str | Path,
    over: Spans | None = None,
    *,
    worst_mm: float = 0.01,
    step_mm: float | None = None,
) -> TableCompensator:
    """Write the corrections as a table over the workspace, with its worst error stated in the file.

    Parameters
    ----------
    compensator : Compensator
    path : path
        A CSV file; replaced only when the new one is complete.
    over : Spans, optional
        Ranges of the channels, for a machine with effects.
    worst_mm : float
        The error that the table may leave; the grid is made as fine as this needs.
    step_mm : float, optional
        Largest spacing of the grid; then `worst_mm` is not asked for, only stated.

    Returns
    -------
    TableCompensator
        As `read_table` reads it back.

    Raises
    ------
    UsageError
        The machine moves in a plane, or an effect remembers.
    InputError
        The robot has no workspace, or the file cannot be written.
    NoSolutionError
        No table of a reasonable size leaves so small an error.

    Notes
    -----
    The error is that of the calibrated machine's exact forward position at nominal joints plus correction, measured at
    the middles of all cells, faces and edges, and at random points. Where corrections curve with the square of the
    distance, trilinear interpolation errs by a sum of one term per axis, each largest half way between nodes: the
    largest norm of such a sum is found at one of these middles.
    """
    if len(compensator.mechanism.axes) < 3:
        raise NotForThisMachine(
            f"a table is made for machines that move in space, and {compensator.mechanism.machine} moves in a plane. "
            "Export the C source, or write the joints of your targets: deltacal compensate RESULT TARGETS -o JOINTS."
        )
    compensator.needs_no_past("table")
    compensator.needs_loops("export 'table'")
    over = over or Spans()
    compensator = after_jumps(compensator)
    compensator.round_trip()  # a workspace out of reach is refused here
    table = _sampled(compensator, over, step_mm) if step_mm is not None else _fine_enough(compensator, over, worst_mm)
    write_files({Path(path): _table_text(table, compensator, over)})
    return table


class CorrectionTable(Exporter):
    """The corrections of joint commands as a table."""

    def at_rest(self, known: Result | Diagnosis, path: Path, *, kind: str, worst_mm: float) -> None:
        """Write the table with the effects, over the channels as they were recorded."""
        export_table(Compensator(known, kind), path, spans(known), worst_mm=worst_mm)


EXPORTER = CorrectionTable()


def _fine_enough(compensator: Compensator, over: Spans, worst_mm: float) -> TableCompensator:
    if not worst_mm > 0.0:
        raise ValueOutOfRange(f"the worst error asked of a table is {worst_mm:g} mm, but must be above 0.")
    left = compensator.round_trip()
    if left.missed:
        raise ExportNotPossible(
            f"{left.missed} of {left.points} checked points of the workspace are out of reach, so no table covers it. "
            "Make [workspace] smaller, or give the step of a table that leaves them blank."
        )
    if stated(left.worst_mm) >= worst_mm:
        raise ExportNotPossible(
            f"the {compensator.kind} compensator itself leaves {stated(left.worst_mm):g} mm over the workspace, so no "
            f"table of it leaves {worst_mm:g} mm. Use the exact one, or ask for a larger worst error."
        )
    if (floor := _floor(compensator, over)) >= worst_mm:
        raise ExportNotPossible(
            f"what the effects ask for is not linear enough in the channels: to first order {floor:g} mm are left, so "
            f"no table leaves {worst_mm:g} mm. Allow a larger worst error, or export the C source."
        )
    step = workspace_of(compensator.robot).box[1].max() / 2
    while True:
        table = _sampled(compensator, over, step, at_most=worst_mm)
        if table.worst_mm <= worst_mm and not table.missed:
            return table
        # the error goes with the square of the step
        step *= 0.5 if table.missed else max(0.3, min(0.95, 0.98 * math.sqrt(worst_mm / table.worst_mm)))


def _floor(compensator: Compensator, over: Spans) -> float:
    """Return what columns leave where they need no interpolation, as it would be stated [mm]."""
    points = workspace_points(workspace_of(compensator.robot))[::7]
    columns = columns_of(compensator, compensator.effects, over)
    values = drawn(compensator, over, len(points))
    sign = compensator.robot.joint_sign
    q = compensator.nominal_command(points)[0] * sign
    found = taken_apart(compensator, points, columns, over, (), q)
    for k, column in enumerate(columns):
        q = q + np.reshape(factor(column, values), (-1, 1)) * found[:, k]
    return stated(largest(missed(compensator, q * sign, points, values)))


def _sampled(compensator: Compensator, over: Spans, step_mm: float, at_most: float | None = None) -> TableCompensator:
    """Return the table whose steps are `step_mm` or a little less."""
    if not step_mm > 0.0:
        raise ValueOutOfRange(f"the step of a table is {step_mm:g} mm, but must be above 0.")
    space = workspace_of(compensator.robot)
    centre, half = space.box
    origin, extent = centre - half, 2 * half
    cells = np.maximum(np.ceil(extent / step_mm - 1e-9).astype(int), 1)
    columns = columns_of(compensator, compensator.effects, over)
    if np.prod(cells + 1.0) * len(columns) > LARGEST_TABLE:
        asked = f"{at_most:g} mm" if at_most is not None else f"a step of {step_mm:g} mm"
        raise ExportNotPossible(
            f"a table for {asked} needs more than {LARGEST_TABLE} corrections. "
            "Allow a larger one, or export the C source, which needs no grid."
        )
    step = extent / cells
    nodes = _lattice([origin[i] + step[i] * np.arange(cells[i] + 1) for i in range(3)])
    unit = to_internal(compensator.mechanism.joint_unit)
    sign = compensator.robot.joint_sign
    nominal = compensator.nominal_command(nodes)[0] * sign
    corrections = taken_apart(compensator, nodes, columns, over, (), nominal) * sign / unit
    if len(columns) > 1:  # a column that nothing goes with is rounding
        kept = [k for k in range(len(columns)) if k == 0 or np.nanmax(np.abs(corrections[:, k])) > 0.1**TABLE_DECIMALS]
        columns, corrections = tuple(columns[k] for k in kept), corrections[:, kept]
    table = TableCompensator(
        origin=origin,
        step=step,
        corrections=np.round(corrections, TABLE_DECIMALS).reshape(*(cells + 1), len(columns), -1) * unit,
        worst_mm=math.nan,
        missed=0,
        robot=compensator.robot.name,
        mechanism=compensator.mechanism.name,
        model=compensator.model,
        kind=compensator.kind,
        digest=compensator.digest,
        joint_unit=compensator.mechanism.joint_unit,
        tool=np.array(compensator.robot.tool, dtype=float),
        columns=columns,
    )
    left = _table_errors(table, compensator, over, space.radius or 0.0)
    return replace(table, worst_mm=stated(left.worst_mm), missed=left.missed)


def _table_errors(table: TableCompensator, compensator: Compensator, over: Spans, radius: float) -> RoundTrip:
    """Return what a table leaves at the middles of its cells, faces and edges, and at random points.

    The channels take random values within what was recorded.
    """
    middles = [table.origin[i] + 0.5 * table.step[i] * np.arange(2 * n - 1) for i, n in enumerate(table.nodes)]
    points = np.vstack([workspace_points(workspace_of(compensator.robot)), _lattice(middles, _used(table, radius))])
    inside = np.hypot(points[:, 0], points[:, 1]) <= radius * (1 + 1e-12)
    errors = np.empty(len(points))
    for start in range(0, len(points), _CHUNK):
        part = points[start : start + _CHUNK]
        values = drawn(compensator, over, len(part))
        joints = compensator.nominal_command(part)[0] + table.correction(part, values)[0]
        errors[start : start + _CHUNK] = missed(compensator, joints, part, values)
    return RoundTrip(largest(errors), len(points), int((np.isnan(errors) & inside).sum()))


def _lattice(axes: Sequence[Array], some: np.ndarray | slice = slice(None)) -> Array:
    """Return the points (N, 3) of a grid, z running fastest; of `some` lines along z."""
    return np.asarray(np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1)[some].reshape(-1, 3))


def _used(table: TableCompensator, radius: float) -> np.ndarray:
    """Tell which columns of half steps (2 n_x - 1, 2 n_y - 1) belong to cells that the cylinder meets."""
    # the point of each interval that is nearest to the axis
    near_x, near_y = (np.clip(0.0, nodes[:-1], nodes[1:]) for nodes in table.axes[:2])
    used = np.zeros((2 * table.nodes[0] - 1, 2 * table.nodes[1] - 1), dtype=bool)
    used[1::2, 1::2] = np.hypot(near_x[:, None], near_y) <= radius
    return np.asarray(binary_dilation(used, np.ones((3, 3))))


def _table_header(columns: Sequence[Column], joints: int, unit: str) -> list[str]:
    by = ["".join(f"_{name}" for name in ("by", *column)) if column else "" for column in columns]
    return ["x_mm", "y_mm", "z_mm", *(f"dq{i + 1}_{unit}{suffix}" for suffix in by for i in range(joints))]


def _table_text(table: TableCompensator, compensator: Compensator, over: Spans) -> str:
    unit = file_unit(table.joint_unit)
    count = table.corrections.shape[4]
    named = (name for name in _Header.model_fields if name not in ("form", "columns"))
    own = {name: np.array(getattr(table, name)).tolist() for name in named}
    header = _Header.model_validate(own | {"form": _SCHEMA, "columns": table.columns})
    facts = header.model_dump(mode="json", by_alias=True, exclude_defaults=True)
    ranges = over.in_channels(compensator.begun)
    content = {"compensator": compensator, "joints": count, "unit": unit, "ranges": ranges, "left_out": LEFT_OUT}
    lines = laid_out("table.csv", facts=facts, **content).splitlines()
    lines.append(",".join(_table_header(table.columns, count, unit)))
    values = table.corrections.reshape(-1, count * len(table.columns)) / to_internal(table.joint_unit)
    places = itertools.product(*([f"{v:.6f}" for v in axis] for axis in table.axes))
    for place, row in zip(places, values, strict=True):
        cells = ("" if math.isnan(v) else f"{v:.{TABLE_DECIMALS}f}" for v in row)
        lines.append(",".join((*place, *cells)))
    return "\n".join(lines) + "\n"


def read_table(path: str | Path) -> TableCompensator:
    """Read a table that `export_table` wrote.

    Raises
    ------
    InputError
        The file is not such a table, or not all of it; the message names the line.
    """
    path = Path(path)
    lines = read_text(path).split("\n")
    top = next((n for n, line in enumerate(lines) if not line.startswith("#")), len(lines))
    text = "\n".join(line[2:] if line.startswith("#:") else "" for line in lines[:top])
    if f'"{_SCHEMA}"' not in text:
        raise _damaged(path, 1, f"a header with schema = {_SCHEMA} was expected")
    facts = TomlFile.parse(path, text).check(_Header)
    header = lines[top].split(",") if top < len(lines) else []
    joints = len(header[3:]) // len(facts.columns)
    fitting = [u for u in ("rad", "mm") if header == _table_header(facts.columns, joints, file_unit(u)) and joints]
    if not fitting:
        raise _damaged(path, top + 1, "the names of the columns, x_mm,y_mm,z_mm,dq1_deg,..., were expected here")
    rows = [line for line in lines[top + 1 :] if line]
    if len(rows) != math.prod(facts.nodes):
        raise _damaged(path, len(lines), f"{math.prod(facts.nodes)} rows were expected, but there are {len(rows)}")
    values = np.empty((len(rows), len(header)))
    for n, row in enumerate(rows):
        try:
            values[n] = [float(cell) if cell else math.nan for cell in row.split(",")]
        except ValueError:
            raise _damaged(path, top + 2 + n, f"{len(header)} numbers were expected") from None
    corrections = values[:, 3:].reshape(*facts.nodes, len(facts.columns), joints) * to_internal(fitting[0])
    own: dict[str, Any] = {name: value for name, value in facts if name not in ("form", "nodes")}
    own |= {name: np.array(own[name]) for name in ("origin", "step", "tool")}
    table = TableCompensator(corrections=corrections, joint_unit=fitting[0], **own)
    if len(strays := np.flatnonzero(~(np.abs(values[:, :3] - _lattice(table.axes)) < 1e-5).all(axis=1))):
        raise _damaged(path, top + 2 + int(strays[0]), "x, y, z are not the node that the header's grid has here")
    return table


def _damaged(path: Path, line: int | None, problem: str) -> InputError:
    return FileFormat(f"{problem}.", "Export the table again.", file=path, line=line)
