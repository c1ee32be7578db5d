"""Compensators: the joint commands that bring the machine as it is to where the drawing would have it.

Two kinds. *exact* is the inverse position of the calibrated machine. *linear* is Bai 2015, eqs. (23) and (25): the
nominal joints, and the change that keeps the reference point in place to first order when the errors appear. What it
leaves is of second order in the errors, and encoder offsets leave nothing: it takes them away exactly, and evaluates
the rest at the angles the geometry then sees.

Both run as compiled functions of one pose (`Compensator.servo`), as C99 source (`export_c`) and as a table of
corrections (`export_table`); each export says what error it leaves over the workspace.

References
----------
Bai, Mei, Huang, Chetwynd 2015, Proc. IMechE C 230(3), section 4.
"""

from __future__ import annotations

import hashlib
import importlib.resources
import itertools
import json
import math
import re
import tomllib
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from deltacal_gen.errors import InputError, NoSolutionError, UsageError
from deltacal_gen.mechanism import SOLVED, STATUS, UNREACHABLE, Array, Mechanism, mechanism_of
from deltacal_gen.recording import write_files
from deltacal_gen.robot import Robot, Workspace, read_text
from deltacal_gen.units import file_unit, to_internal

KINDS = ("exact", "linear")
LARGEST_TABLE = 200_000  # nodes; beyond this the file has tens of megabytes and the C source is the better export
TABLE_DECIMALS = 7  # of a correction in deg or mm: at a metre, 2e-6 mm
_SOURCE = {"exact": "inverse.c", "linear": "linear.c"}
_RANDOM_POINTS = 2000
_SEED = 20150  # of the random points: the same machine always gets the same statement
_MARGIN = 1.05  # a stated error over the measured one
_CHUNK = 100_000  # points evaluated at once
_NAMED = 5  # targets a message names before it counts the rest


class RoundTrip(NamedTuple):
    """What commands leave over the workspace: the worst error [mm] at `points` targets, `missed` of them unsolved."""

    worst_mm: float
    points: int
    missed: int


class Servo(NamedTuple):
    """A compensator for a compiled loop; see `Compensator.servo`."""

    command: Callable[..., int]
    constants: Array
    tool: Array
    sign: Array
    work: Array


@dataclass(frozen=True, eq=False)
class Compensator:
    """Corrected joint commands for a calibrated machine.

    Parameters
    ----------
    robot : Robot
        The calibrated machine: the geometry that the controller computes with, and the errors found.
    kind : {"exact", "linear"}
        Inverse position of the calibrated machine, or eq. (23) of Bai 2015; with errors of the position model only
        (its first group), eq. (23) is eq. (25).

    Raises
    ------
    UsageError
        There is no such kind.
    """

    robot: Robot
    kind: str = "exact"

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise UsageError(f"there is no compensator '{self.kind}'; there are {' and '.join(KINDS)}.")

    @cached_property
    def mechanism(self) -> Mechanism:
        """The kernels of the machine."""
        return mechanism_of(self.robot)

    @cached_property
    def nominal(self) -> Robot:
        """The machine that an uncompensated controller believes in."""
        return replace(self.robot, errors={})

    @cached_property
    def model(self) -> str:
        """Smallest model that has all errors of the robot; the mechanism's full one where none has."""
        models, errors = self.mechanism.models, {name for name, value in self.robot.errors.items() if value}
        fitting = [name for name in models if errors <= set(models[name])]
        return min(fitting, key=lambda name: len(models[name]), default=self.mechanism.full_model)

    @cached_property
    def digest(self) -> str:
        """Fingerprint of every number that a command depends on, but the target."""
        numbers = (self._rows, self.robot.tool, self.robot.joint_sign)
        text = self.kind.encode() + b"".join(np.ascontiguousarray(n, dtype="<f8").tobytes() for n in numbers)
        return hashlib.sha256(text).hexdigest()[:16]

    @cached_property
    def _rows(self) -> Array:
        return self.mechanism.rows(self.robot)

    @cached_property
    def _kernels(self) -> Any:
        return self.mechanism.compiled

    @cached_property
    def _constants(self) -> Array:
        kernels = self._kernels
        k: Array = (kernels.constants if self.kind == "exact" else kernels.linear_constants)(self._rows)
        return k

    def servo(self) -> Servo:
        """Return the compensator of one pose, for a loop that Numba compiles.

        Returns
        -------
        Servo
            ``status = command(target, tool, constants, work, q)`` fills `q` (n_q,) for a `target` (3,) [mm] and
            allocates nothing; ``sign * q`` is what the controller counts [rad or mm]. `work` is scratch, one per
            thread.

        Notes
        -----
        With `target` (N, 3) and `q` (N, 3)::

            servo = Compensator(robot).servo()
            command = servo.command

            @njit
            def loop(targets, tool, constants, work, q):
                for n in range(len(targets)):
                    command(targets[n], tool, constants, work, q[n])
        """
        kernels = self._kernels
        function = kernels.exact_command if self.kind == "exact" else kernels.linear_command
        work = np.zeros(kernels.COMMAND_WORK)
        sign = np.array(self.robot.joint_sign, dtype=float)
        return Servo(function, self._constants[0].copy(), np.array(self.robot.tool, dtype=float), sign, work)

    def command(self, targets: Array, tool: Array | None = None) -> tuple[Array, np.ndarray]:
        """Return corrected joint commands.

        Parameters
        ----------
        targets : (N, 3) array
            Where the reference point is wanted, in {O} [mm].
        tool : (3,) or (N, 3) array, optional
            Reference point in {O'} [mm]; default the robot's.

        Returns
        -------
        joints : (N, n_q) array
            As the controller counts them [rad or mm]; NaN where not solved.
        status : (N,) int array
            SOLVED, UNREACHABLE or SINGULAR of `deltacal_gen.mechanism`, explained in its `STATUS`.
        """
        targets, tool = self._targets(targets, tool)
        q, status = np.empty((len(targets), self.mechanism.limbs)), np.empty(len(targets), dtype=np.int64)
        function = self._kernels.exact_commands if self.kind == "exact" else self._kernels.linear_commands
        function(targets, tool, self._constants, q, status)
        return q * self.robot.joint_sign, status

    def joints(self, targets: Array, tool: Array | None = None) -> Array:
        """Return corrected joint commands (N, n_q) [rad or mm], all of them within the joints' limits.

        Raises
        ------
        NoSolutionError
            A target is out of reach, singular, or asks a joint beyond its limits; the message names the first ones.
        """
        targets, tool = self._targets(targets, tool)
        joints, status = self.command(targets, tool)
        beyond = self.beyond_limits(joints)
        if flaws := [self._flaw(n, targets[n], joints[n], status[n], beyond[n]) for n in _failed(status, beyond)]:
            more = f"\n  and {len(flaws) - _NAMED} more" if len(flaws) > _NAMED else ""
            raise NoSolutionError(
                f"{len(flaws)} of {len(targets)} targets have no joint command:\n  "
                + "\n  ".join(flaws[:_NAMED])
                + f"{more}\nMove them into the workspace, or leave them out."
            )
        return joints

    def beyond_limits(self, joints: Array) -> np.ndarray:
        """Tell which commands (N, n_q) lie beyond the robot's joint limits; none where it states no limits."""
        if self.robot.joint_limits is None:
            return np.zeros(np.shape(joints), dtype=bool)
        lower, upper = self.robot.joint_limits.T
        beyond: np.ndarray = (joints < lower) | (joints > upper)
        return beyond

    def nominal_command(self, targets: Array, tool: Array | None = None) -> tuple[Array, np.ndarray]:
        """Return what the uncompensated controller commands, like `command`."""
        targets, tool = self._targets(targets, tool)
        q, _, status = self.mechanism.inverse(targets, tool, self.mechanism.rows(self.nominal))
        return q * self.robot.joint_sign, status

    def reached(self, joints: Array, tool: Array | None = None) -> tuple[Array, np.ndarray]:
        """Return where the calibrated machine really goes, (N, 3) [mm], and the status (N,), at joint commands."""
        q = np.asarray(joints, dtype=float) * self.robot.joint_sign
        x, status = self.mechanism.forward(q, self.robot.tool if tool is None else tool, self._rows)
        return x[:, :3], status

    def leftover(self, targets: Array, tool: Array | None = None) -> Array:
        """Return the position error (N, 3) [mm] that the compensated machine has left; NaN where not solved."""
        targets, tool = self._targets(targets, tool)
        return self.reached(self.command(targets, tool)[0], tool)[0] - targets

    def round_trip(self) -> RoundTrip:
        """Return what the commands leave over the robot's workspace.

        Raises
        ------
        InputError
            The robot file gives no cylindrical workspace.
        NoSolutionError
            The machine reaches no point of it.
        """
        targets = _workspace_points(_workspace(self.robot))
        error = np.linalg.norm(self.leftover(targets), axis=1)
        if np.isnan(error).all():
            raise NoSolutionError(
                "no point of the workspace is within the machine's reach. "
                "Check [workspace] and the lengths in [geometry]; top is counted downwards from the base plane."
            )
        return RoundTrip(_largest(error), len(targets), int(np.isnan(error).sum()))

    def _targets(self, targets: Array, tool: Array | None) -> tuple[Array, Array]:
        targets = np.ascontiguousarray(targets, dtype=float)
        if targets.ndim != 2 or targets.shape[1] != 3:
            raise ValueError(f"targets have the shape {targets.shape}, but must have (N, 3).")
        tool = np.asarray(self.robot.tool if tool is None else tool, dtype=float)
        return targets, np.ascontiguousarray(np.broadcast_to(tool, targets.shape))

    def _flaw(self, n: int, target: Array, joints: Array, status: int, beyond: np.ndarray) -> str:
        where = f"target {n + 1} ({', '.join(f'{v:g}' for v in target)} mm)"
        if status != SOLVED:
            return f"{where}: {STATUS[int(status)]}"
        unit, limits = self.mechanism.joint_unit, self.robot.joint_limits
        assert limits is not None  # or nothing would be beyond them
        i = int(np.flatnonzero(beyond)[0])
        value, lower, upper = (v / to_internal(unit) for v in (joints[i], *limits[i]))
        allowed = f"its limits are {lower:g} to {upper:g} {file_unit(unit)}"
        return f"{where}: joint {i + 1} would go to {value:.4f}, but {allowed}"


def _failed(status: np.ndarray, beyond: np.ndarray) -> list[int]:
    return [int(n) for n in np.flatnonzero((status != SOLVED) | beyond.any(axis=1))]


def _largest(errors: Array) -> float:
    """Return the largest error that is a number; 0 where none is."""
    return float(np.nan_to_num(errors).max(initial=0.0))


def _stated(measured: float) -> float:
    """Return what is stated for a measured error: a margin above it, rounded up to two digits."""
    if measured == 0.0:
        return 0.0
    digit = 10.0 ** (math.floor(math.log10(measured * _MARGIN)) - 1)
    return float(f"{math.ceil(measured * _MARGIN / digit) * digit:.1e}")


def _workspace(robot: Robot) -> tuple[float, float, float]:
    """Return radius, lowest and highest z of the workspace [mm]; raises InputError where the robot has none."""
    space: Workspace | None = robot.workspace
    if space is None or space.radius is None:
        raise InputError(
            "the robot has no [workspace] with top, radius and height, over which the export could state its error.",
            "Add the cylinder in which the machine works.",
            file=robot.source,
        )
    return space.radius, -space.top - space.height, -space.top


def _workspace_points(space: tuple[float, float, float]) -> Array:
    """Return points of a cylinder, (N, 3): random ones, and circles on the rim and half way in three layers."""
    radius, low, high = space
    rng = np.random.default_rng(_SEED)
    r, turn = radius * np.sqrt(rng.random(_RANDOM_POINTS)), 2 * np.pi * rng.random(_RANDOM_POINTS)
    z = low + (high - low) * rng.random(_RANDOM_POINTS)
    circles = list(
        itertools.product((radius, radius / 2), np.radians(np.arange(0, 360, 15)), (low, (low + high) / 2, high))
    )
    axis = [(0.0, 0.0, level) for level in (low, (low + high) / 2, high)]
    r, turn, z = np.vstack([np.column_stack([r, turn, z]), circles, axis]).T
    return np.column_stack([r * np.cos(turn), r * np.sin(turn), z])


# --- C99 ------------------------------------------------------------------------------------------------------------


def export_c(compensator: Compensator, path: str | Path) -> RoundTrip:
    """Write the compensator as one self-contained C99 file.

    It defines ``int deltacal_compensate(const double target_mm[3], double joints_deg[3])``, which returns 0 (solved),
    1 (out of reach) or 2 (singular), keeps no state and allocates nothing. The tool point is the robot's.

    Parameters
    ----------
    compensator : Compensator
    path : path
        Replaced only when the new file is complete.

    Returns
    -------
    RoundTrip
        What the file's header states.

    Raises
    ------
    InputError
        The robot has no workspace, or the file cannot be written.
    """
    left = compensator.round_trip()
    write_files({Path(path): c_source(compensator, left)})
    return left


def c_source(compensator: Compensator, left: RoundTrip) -> str:
    """Return the text of the C99 file that `export_c` writes."""
    mechanism, kernels, robot = compensator.mechanism, compensator._kernels, compensator.robot
    body = importlib.resources.files("deltacal_kernels").joinpath(mechanism.name, _SOURCE[compensator.kind])
    constants = compensator._constants[0]
    if compensator.kind == "exact":
        constants = constants[:, : kernels.COMMAND_CONSTANTS]
    limbs, unit = mechanism.limbs, file_unit(mechanism.joint_unit)
    values = "\n".join(f"    {{ {_wrapped(row)} }}," for row in constants)
    numbers = (
        f"static const double DELTACAL_K[{limbs}][{constants.shape[1]}] = {{\n{values}\n}};\n"
        f"static const double DELTACAL_TOOL[3] = {{ {_c_numbers(robot.tool)} }}; /* mm, reference point in {{O'}} */\n"
        f"static const double DELTACAL_SIGN[{limbs}] = {{ {_c_numbers(robot.joint_sign)} }}; /* of the controller */\n"
    )
    comment = "\n".join(f" * {line}".rstrip() for line in _c_header(compensator, left, unit))
    return f"/*\n{comment}\n */\n{numbers}\n{body.read_text(encoding='utf-8')}"


def _c_header(compensator: Compensator, left: RoundTrip, unit: str) -> Iterator[str]:
    robot, mechanism = compensator.robot, compensator.mechanism
    limbs = mechanism.limbs
    what = {
        "exact": "inverse position of the calibrated machine, by Newton's method",
        "linear": "nominal joints and the first-order change that undoes the errors (Bai 2015, eq. 23)",
    }
    yield f"Joint commands for {_plain(robot.name)} ({mechanism.name}), compensated."
    yield ""
    yield f"Kind        {compensator.kind}: {what[compensator.kind]}"
    yield f"Model       {compensator.model}, {sum(1 for v in robot.errors.values() if v)} source errors"
    yield f"Parameters  sha256 {compensator.digest}: the same numbers always give the same file"
    yield f"Error left  {_stated(left.worst_mm):.1e} mm at the worst of {left.points} points of the workspace,"
    yield "            against the model's own forward position (what the model does not know is not in it)"
    if left.missed:
        yield f"WARNING     {left.missed} of these points are out of reach or singular"
    yield ""
    yield "In          target_mm: reference point P in the robot frame {O}: origin at the base centre, z up [mm]"
    yield f"Out         joints_{unit}: what to command, as the controller counts [{unit}]; not checked for joint limits"
    yield "Returns     0 solved; 1 out of reach; 2 singular; joints are written only for 0"
    yield ""
    yield f"Usage       double joints[{limbs}];"
    yield "            const double target[3] = { 0.0, 0.0, -850.0 };"
    yield "            if (deltacal_compensate(target, joints) == 0) { ... }"
    yield "Build       C99 with the mathematics library. No memory is allocated and no state is kept: safe from any"
    yield "            thread. Not with -ffast-math, which drops the test for targets out of reach."
    checks = np.round(_workspace_points(_workspace(robot))[[-3, -7, -70]], 3)
    joints, status = compensator.command(checks)
    yield ""
    yield "To check after installation:"
    for target, command in zip(checks[status == SOLVED], joints[status == SOLVED], strict=True):
        inputs = ", ".join(f"{v:.3f}" for v in target)
        outputs = ", ".join(f"{v:.9f}" for v in command / to_internal(mechanism.joint_unit))
        yield f"            ({inputs}) mm -> ({outputs}) {unit}"


def _plain(text: str) -> str:
    """Return `text` without anything that means something in a C comment."""
    return re.sub(r"[^\w .,:;()+-]", "_", text)


def _c_numbers(values: Array) -> str:
    return ", ".join(repr(float(v)) for v in values)


def _wrapped(values: Array, per_line: int = 5) -> str:
    parts = [_c_numbers(values[j : j + per_line]) for j in range(0, len(values), per_line)]
    return ",\n      ".join(parts)


# --- the table ------------------------------------------------------------------------------------------------------


@dataclass(frozen=True, eq=False)
class TableCompensator:
    """Corrections of joint commands on a regular grid, interpolated between its nodes (trilinear).

    Parameters
    ----------
    origin, step : (3,) arrays
        First node and spacing along x, y, z [mm].
    corrections : (n_x, n_y, n_z, n_q) array
        To be added to the nominal joints, as the controller counts [rad or mm]; NaN where out of reach.
    worst_mm : float
        Worst position error over the workspace, compensated by this table [mm].
    missed : int
        Checked points of the workspace for which the table has no answer.
    robot, mechanism, kind, digest : str
        Of the `Compensator` it was made from.
    joint_unit : {"rad", "mm"}
    tool : (3,) array
        The reference point in {O'} for which it holds [mm].
    """

    origin: Array
    step: Array
    corrections: Array
    worst_mm: float
    missed: int
    robot: str
    mechanism: str
    kind: str
    digest: str
    joint_unit: str
    tool: Array

    @property
    def nodes(self) -> tuple[int, int, int]:
        """Number of nodes along x, y, z."""
        n_x, n_y, n_z = self.corrections.shape[:3]
        return n_x, n_y, n_z

    def correction(self, targets: Array) -> tuple[Array, np.ndarray]:
        """Return what to add to the nominal joints at targets (N, 3) [mm].

        Returns
        -------
        correction : (N, n_q) array
            As the controller counts [rad or mm]; NaN beside the grid and where one of the 8 nodes is out of reach.
        status : (N,) int array
            SOLVED, or UNREACHABLE where there is no correction.
        """
        targets = np.asarray(targets, dtype=float)
        if targets.ndim != 2 or targets.shape[1] != 3:
            raise ValueError(f"targets have the shape {targets.shape}, but must have (N, 3).")
        place = (targets - self.origin) / self.step
        last = np.array(self.nodes) - 1
        # a target on the rim may round to beside it
        outside: np.ndarray = np.any(~((place > -1e-9) & (place < last + 1e-9)), axis=1)
        place = np.where(outside[:, None], 0.0, place)
        cell = np.clip(place.astype(np.int64), 0, last - 1)
        part = place - cell
        found = np.zeros((len(targets), self.corrections.shape[3]))
        for corner in itertools.product((0, 1), repeat=3):
            weight = np.prod(np.where(corner, part, 1.0 - part), axis=1)
            i, j, k = (cell + corner).T
            found += weight[:, None] * self.corrections[i, j, k]
        found[outside] = np.nan
        return found, np.where(np.isnan(found).any(axis=1), UNREACHABLE, SOLVED)


def export_table(
    compensator: Compensator, path: str | Path, *, worst_mm: float = 0.01, step_mm: float | None = None
) -> TableCompensator:
    """Write the corrections as a table over the workspace, with its worst error stated in the file.

    Parameters
    ----------
    compensator : Compensator
    path : path
        A CSV file; replaced only when the new one is complete.
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
    compensator.round_trip()  # a workspace out of reach is refused here
    table = _sampled(compensator, step_mm) if step_mm is not None else _fine_enough(compensator, worst_mm)
    write_files({Path(path): _table_text(table, compensator)})
    return table


def _fine_enough(compensator: Compensator, worst_mm: float) -> TableCompensator:
    if not worst_mm > 0.0:
        raise UsageError(f"the worst error asked of a table is {worst_mm:g} mm, but must be above 0.")
    left = compensator.round_trip()
    if left.missed:
        raise NoSolutionError(
            f"{left.missed} of {left.points} checked points of the workspace are out of reach, so no table covers it. "
            "Make [workspace] smaller, or give the step of a table that leaves them blank."
        )
    if _stated(left.worst_mm) >= worst_mm:
        raise NoSolutionError(
            f"the {compensator.kind} compensator itself leaves {_stated(left.worst_mm):g} mm over the workspace, so no "
            f"table of it leaves {worst_mm:g} mm. Use the exact one, or ask for a larger worst error."
        )
    radius, low, high = _workspace(compensator.robot)
    step = max(2 * radius, high - low) / 4
    while True:
        table = _sampled(compensator, step, at_most=worst_mm)
        if table.worst_mm <= worst_mm and not table.missed:
            return table
        # the error goes with the square of the step
        step *= 0.5 if table.missed else max(0.3, min(0.95, 0.98 * math.sqrt(worst_mm / table.worst_mm)))


def _sampled(compensator: Compensator, step_mm: float, at_most: float | None = None) -> TableCompensator:
    """Return the table whose steps are `step_mm` or a little less."""
    if not step_mm > 0.0:
        raise UsageError(f"the step of a table is {step_mm:g} mm, but must be above 0.")
    radius, low, high = _workspace(compensator.robot)
    origin, extent = np.array([-radius, -radius, low]), np.array([2 * radius, 2 * radius, high - low])
    cells = np.maximum(np.ceil(extent / step_mm - 1e-9).astype(int), 1)
    if np.prod(cells + 1.0) > LARGEST_TABLE:
        asked = f"{at_most:g} mm" if at_most is not None else f"a step of {step_mm:g} mm"
        raise NoSolutionError(
            f"a table for {asked} needs more than {LARGEST_TABLE} nodes. "
            "Allow a larger one, or export the C source, which needs no grid."
        )
    step = extent / cells
    axes = [origin[i] + step[i] * np.arange(cells[i] + 1) for i in range(3)]
    nodes = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    unit = to_internal(compensator.mechanism.joint_unit)
    corrections = (compensator.command(nodes)[0] - compensator.nominal_command(nodes)[0]) / unit
    table = TableCompensator(
        origin=origin,
        step=step,
        corrections=np.round(corrections, TABLE_DECIMALS).reshape(*(cells + 1), -1) * unit,
        worst_mm=math.nan,
        missed=0,
        robot=compensator.robot.name,
        mechanism=compensator.mechanism.name,
        kind=compensator.kind,
        digest=compensator.digest,
        joint_unit=compensator.mechanism.joint_unit,
        tool=np.array(compensator.robot.tool, dtype=float),
    )
    left = _table_errors(table, compensator, radius)
    return replace(table, worst_mm=_stated(left.worst_mm), missed=left.missed)


def _table_errors(table: TableCompensator, compensator: Compensator, radius: float) -> RoundTrip:
    """Return what a table leaves at the middles of its cells, faces and edges, and at random points."""
    middles = [table.origin[i] + 0.5 * table.step[i] * np.arange(2 * n - 1) for i, n in enumerate(table.nodes)]
    used = _used(table, radius)
    lattice = np.stack(np.meshgrid(*middles, indexing="ij"), axis=-1)[used]
    points = np.vstack([_workspace_points(_workspace(compensator.robot)), lattice.reshape(-1, 3)])
    inside = np.hypot(points[:, 0], points[:, 1]) <= radius * (1 + 1e-12)
    worst, missed = 0.0, 0
    for start in range(0, len(points), _CHUNK):
        part = points[start : start + _CHUNK]
        joints = compensator.nominal_command(part)[0] + table.correction(part)[0]
        error = np.linalg.norm(compensator.reached(joints)[0] - part, axis=1)
        worst = max(worst, _largest(error))
        missed += int((np.isnan(error) & inside[start : start + _CHUNK]).sum())
    return RoundTrip(worst, len(points), missed)


def _used(table: TableCompensator, radius: float) -> np.ndarray:
    """Tell which columns of half steps (2 n_x - 1, 2 n_y - 1) belong to cells that the cylinder meets."""
    used = np.zeros((2 * table.nodes[0] - 1, 2 * table.nodes[1] - 1), dtype=bool)
    edges = [table.origin[i] + table.step[i] * np.arange(table.nodes[i]) for i in range(2)]
    # the point of each interval that is nearest to the axis
    near_x, near_y = (np.clip(0.0, e[:-1], e[1:]) for e in edges)
    for i, j in np.argwhere(np.hypot(near_x[:, None], near_y[None, :]) <= radius):
        used[2 * i : 2 * i + 3, 2 * j : 2 * j + 3] = True
    return used


_TABLE_SCHEMA = "deltacal.table/1"


def _table_text(table: TableCompensator, compensator: Compensator) -> str:
    unit = file_unit(table.joint_unit)
    count = table.corrections.shape[3]
    n_x, n_y, n_z = table.nodes
    prose = (
        "Corrections of joint commands: command = nominal inverse position of the target + dq,",
        f"dq1..dq{count} in {unit} as the controller counts, by the position x, y, z in mm of the reference point in",
        "the robot frame {O} (origin at the base centre, z up). Regular grid, z running fastest, then y, then x:",
        "row (i * nodes_y + j) * nodes_z + k, counted from 0, belongs to the node origin + (i, j, k) * step.",
        "Interpolation: trilinear between the 8 nodes of the cell. Blank: out of reach; no target may use such a cell.",
        "worst_mm: worst position error left in the cells that the workspace meets, against the model's own exact",
        "forward position, measured half way between all nodes and at random points. What the model does not know is",
        "not in it. missed: checked points of the workspace without an answer.",
    )
    facts = {
        "schema": _TABLE_SCHEMA,
        "worst_mm": table.worst_mm,
        "missed": table.missed,
        "robot": table.robot,
        "mechanism": table.mechanism,
        "model": compensator.model,
        "kind": table.kind,
        "parameters_sha256": table.digest,
        "tool_mm": [float(v) for v in table.tool],
        "origin_mm": [float(v) for v in table.origin],
        "step_mm": [float(v) for v in table.step],
        "nodes": [n_x, n_y, n_z],
    }
    lines = [f"# {line}" for line in prose]
    lines += [f"#: {key} = {json.dumps(value)}".replace("\x7f", "\\u007f") for key, value in facts.items()]
    lines.append(",".join(("x_mm", "y_mm", "z_mm", *(f"dq{i + 1}_{unit}" for i in range(count)))))
    values = table.corrections.reshape(-1, count) / to_internal(table.joint_unit)
    places = itertools.product(*([f"{v:.6f}" for v in axis] for axis in _axes(table)))
    for place, row in zip(places, values, strict=True):
        cells = ("" if math.isnan(v) else f"{v:.{TABLE_DECIMALS}f}" for v in row)
        lines.append(",".join((*place, *cells)))
    return "\n".join(lines) + "\n"


def _axes(table: TableCompensator) -> list[Array]:
    return [table.origin[i] + table.step[i] * np.arange(n) for i, n in enumerate(table.nodes)]


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
    facts = _table_facts(path, lines[:top])
    header = lines[top].split(",") if top < len(lines) else []
    units = {name.rpartition("_")[2] for name in header[3:]}
    if header[:3] != ["x_mm", "y_mm", "z_mm"] or len(units) != 1 or not units <= {"deg", "mm"}:
        raise _damaged(path, top + 1, "the names of the columns, x_mm,y_mm,z_mm,dq1_deg,..., were expected here")
    unit = "rad" if units == {"deg"} else "mm"
    shape = tuple(facts["nodes"])
    rows = [line for line in lines[top + 1 :] if line]
    if len(rows) != math.prod(shape):
        raise _damaged(path, len(lines), f"{math.prod(shape)} rows were expected, but there are {len(rows)}")
    values = np.empty((len(rows), len(header)))
    for n, row in enumerate(rows):
        try:
            values[n] = [float(cell) if cell else math.nan for cell in row.split(",")]
        except ValueError:
            raise _damaged(path, top + 2 + n, f"{len(header)} numbers were expected") from None
    table = TableCompensator(
        origin=np.array(facts["origin_mm"], dtype=float),
        step=np.array(facts["step_mm"], dtype=float),
        corrections=values[:, 3:].reshape(*shape, -1) * to_internal(unit),
        worst_mm=float(facts["worst_mm"]),
        missed=int(facts["missed"]),
        robot=facts["robot"],
        mechanism=facts["mechanism"],
        kind=facts["kind"],
        digest=facts["parameters_sha256"],
        joint_unit=unit,
        tool=np.array(facts["tool_mm"], dtype=float),
    )
    nodes = np.stack(np.meshgrid(*_axes(table), indexing="ij"), axis=-1).reshape(-1, 3)
    if len(strays := np.flatnonzero(~(np.abs(values[:, :3] - nodes) < 1e-5).all(axis=1))):
        raise _damaged(path, top + 2 + int(strays[0]), "x, y, z are not the node that the header's grid has here")
    return table


def _table_facts(path: Path, lines: list[str]) -> dict[str, Any]:
    """Return what the header of a table states, checked for what `read_table` needs."""
    try:
        facts = tomllib.loads("\n".join(line.removeprefix("#:") if line.startswith("#:") else "" for line in lines))
    except tomllib.TOMLDecodeError as error:
        raise _damaged(path, None, f"the header cannot be read: {error}") from None
    if facts.get("schema") != _TABLE_SCHEMA:
        raise _damaged(path, 1, f"a header with schema = {_TABLE_SCHEMA} was expected")
    numbers = {"worst_mm": 1, "missed": 1, "tool_mm": 3, "origin_mm": 3, "step_mm": 3, "nodes": 3}
    for key, count in numbers.items():
        found = facts.get(key)
        values = found if count > 1 else [found]
        if not (isinstance(values, list) and len(values) == count and all(type(v) in (int, float) for v in values)):
            raise _damaged(path, None, f"{key} in the header is {found!r}; {count} number{'s'[: count > 1]} expected")
    if not (min(facts["nodes"]) >= 2 and all(isinstance(n, int) for n in facts["nodes"]) and min(facts["step_mm"]) > 0):
        raise _damaged(path, None, "the grid in the header needs 2 or more nodes and a positive step along each axis")
    for key in ("robot", "mechanism", "kind", "parameters_sha256"):
        if not isinstance(facts.get(key), str):
            raise _damaged(path, None, f"{key} in the header is missing")
    return facts


def _damaged(path: Path, line: int | None, problem: str) -> InputError:
    return InputError(f"{problem}.", "Export the table again.", file=path, line=line)
