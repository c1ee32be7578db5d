"""Where and how to measure: poses, joints reached from either side, trajectories."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal

from deltacal_gen.app.commands.common import PICTURES, Source, as_robot, check_output
from deltacal_gen.errors import OptionNotApplicable, UnknownModel

if TYPE_CHECKING:
    from deltacal_gen.app.commands.common import AnyRobot
    from deltacal_gen.machine.values import Robot
    from deltacal_gen.results.plan import CyclePlan, MotionPlan, Plan


def plan(
    robot: AnyRobot,
    *,
    model: str | int | None = None,
    kind: str | None = None,
    optimal: int | None = None,
    points: int | None = None,
    singular: tuple[float, float] | None = None,
    layers: str | None = None,
    start_angle_deg: float | None = None,
    threshold: float | None = None,
    n_max: int | None = None,
    noise: float | None = None,
    gauge: Source | None = None,
    sidecar: Source | None = None,
    scaling: str | None = None,
    norm: Literal["spectral", "frobenius"] = "spectral",
    output: Source | None = None,
    picture: Source | None = None,
) -> Plan:
    """Choose measuring poses: how many by condition number and observability, or a D-optimal set.

    For a machine of one axis, and for kind encoder, it chooses joint positions that are reached from both sides; for
    kind torque it plans exciting trajectories.

    Parameters
    ----------
    robot : path, Robot or RobotTables
        Robot file (TOML).
    model : str or int, optional
        Model whose parameters the poses must identify: delta/18 or 18. Needed, unless the mechanism has one model
        only, or the kind is torque or encoder.
    kind : str, optional
        What is measured: distance, position, pose, gauge, encoder, torque, 'board image' or 'touched board'; default
        distance, of an open chain position.
    optimal : int, optional
        Number of D-optimal poses, chosen in place of rings of poses.
    points : int, optional
        Number of reference points (reflectors) on the platform, 1 to 3; default as many as the model needs.
    singular : (float, float), optional
        Smallest and largest distance of the poses from the nearest singularity [mm], in place of rings.
    layers : str, optional
        Heights of the rings in the workspace, as top,middle,bottom; default those of the paper.
    start_angle_deg : float, optional
        Angle about z of the first pose of each ring [deg]; default 0.
    threshold : float, optional
        Relative change of the condition number below which no more poses are added; default 0.01.
    n_max : int, optional
        Largest number of poses for each ring; default 30.
    noise : float, optional
        Measurement noise (1 sigma) [mm], to predict the uncertainty of the parameters.
    gauge : path, optional
        Sidecar (TOML) with base_point_mm and platform_point_mm, where the ends of the gauge are mounted.
    sidecar : path, optional
        Sidecar (TOML) that the readings will have: their kind; of a camera, its place and lens.
    scaling : {"paper", "table", "file", "typical"}, optional
        Units of the matrix's columns: paper (those of its equations), table (of its tables), file (mm, deg) or typical
        (typical errors); default paper.
    norm : {"spectral", "frobenius"}
        Norm by which the condition number is taken.
    output : path, optional
        TARGETS.csv: the poses, as simulate and the controller take them.
    picture : path, optional
        Condition number against the number of poses, .svg, .png or .pdf.

    Raises
    ------
    UsageError
        An unknown model or kind; options that exclude each other.

    Examples
    --------
    deltacal plan robot.toml --model delta/32 --points 2 -o targets.csv
    """
    from deltacal_gen.files.sidecar import read_measurement
    from deltacal_gen.instrument.kinds import MOUNTED
    from deltacal_gen.planning import matrix, planning
    from deltacal_gen.planning.optimal import plan_optimal_poses
    from deltacal_gen.units import DEG

    check_output(output, robot)
    check_output(picture, robot, output, ending=PICTURES)
    if (function := planner(robot, kind, model, sidecar)) != plan.__name__:
        raise OptionNotApplicable(f"these are no poses: {function} plans what is measured here.")
    machine, name = _with_model(as_robot(robot), model)
    said = None if sidecar is None else read_measurement(sidecar)
    said = said if gauge is None else matrix.read_mount(gauge)
    kind = kind or (MOUNTED if gauge else said.kind if said else None)
    how: dict[str, Any] = {"kind": kind, "tools": points, "singular": singular, "said": said}
    how |= {"scaling": scaling, "norm": norm, "sigma_mm": noise}
    options: dict[str, Any] = {
        "layers": layers and layers.split(","),
        "start_angle": None if start_angle_deg is None else start_angle_deg * DEG,
        "threshold": threshold,
        "n_max": n_max,
    }
    rings = {name: value for name, value in options.items() if value is not None}
    if optimal is None:
        found = planning.plan_poses(machine, name, **how, **rings)
    elif gauge is not None:
        raise OptionNotApplicable("D-optimal sets are chosen for positions and distances, not for a gauge.")
    elif rings:
        raise OptionNotApplicable(f"{', '.join(rings)}: of rings, and means nothing for a D-optimal set; leave it out.")
    else:
        found = plan_optimal_poses(machine, name, optimal, **how)
    if output is not None:
        planning.write_targets(found, output)
    answer = found.answer()
    if picture is not None:
        from deltacal_gen.pages import plans

        plans.write([answer], picture)
    return answer


def _with_model(robot: Robot, model: str | int | None) -> tuple[Robot, str]:
    """Return the robot as a model describes it, and the name of the model; the only one where none is given."""
    from deltacal_gen.files.robot import for_model
    from deltacal_gen.machine.registry import mechanism_of

    first, *others = mechanism_of(robot).models
    if model is None and others:
        names = ", ".join((first, *others))
        raise UnknownModel(f"give the model whose parameters the poses shall determine: --model {names}.")
    name = first if model is None else str(model)
    return for_model(robot, name), name


def plan_cycles(
    robot: AnyRobot,
    *,
    kind: str | None = None,
    positions: int | None = None,
    cycles: int | None = None,
    sidecar: Source | None = None,
    output: Source | None = None,
) -> CyclePlan:
    """Choose joints that are reached from either side: of one axis in cycles, or of several over their ranges.

    Parameters
    ----------
    robot : path, Robot or RobotTables
        Robot file (TOML).
    kind : str, optional
        What is measured: encoder, or position for a machine of one axis.
    positions : int, optional
        One axis or kind encoder: number of positions that are reached from both sides.
    cycles : int, optional
        One axis: number of runs to and fro over all positions; default 5.
    sidecar : path, optional
        Sidecar (TOML) that the readings will have: their kind.
    output : path, optional
        ROWS.csv: the joint positions, as simulate and the controller take them.

    Raises
    ------
    InputError
        The robot file does not say how far the joints go.
    UsageError
        Fewer than two positions or cycles; cycles of several joints.

    Examples
    --------
    deltacal plan axis.toml --cycles 5 -o rows.csv
    """
    from deltacal_gen.instrument.kinds import POINTS
    from deltacal_gen.planning import both_sides

    check_output(output, robot)
    machine = as_robot(robot)
    name = _reached_from_both_sides(machine, _kind_of(kind, sidecar)) or POINTS
    found = both_sides.plan_both_sides(machine, name, positions, cycles)
    if output is not None:
        both_sides.write_rows(found, output)
    return found.answer()


def plan_trajectory(
    robot: AnyRobot,
    *,
    runs: int = 3,
    period_s: float = 10.0,
    harmonics: int = 5,
    rate_Hz: float = 100.0,
    output: Source | None = None,
    picture: Source | None = None,
) -> MotionPlan:
    """Plan exciting trajectories, whose torques determine the bodies and drives of a robot.

    Parameters
    ----------
    robot : path, Robot or RobotTables
        Robot file (TOML).
    runs : int
        Kind torque: number of trajectories, each a run.
    period_s : float
        Kind torque: period of each trajectory [s].
    harmonics : int
        Kind torque: number of harmonics of the Fourier series.
    rate_Hz : float
        Kind torque: samples per second [Hz].
    output : path, optional
        TRAJECTORY.csv with its sidecar, for simulate and for the controller.
    picture : path, optional
        The course of the trajectories and their limits, .svg, .png or .pdf.

    Raises
    ------
    UsageError
        A number out of range.
    NoSolutionError
        No trajectory stays in the workspace.

    Examples
    --------
    deltacal plan robot.toml --kind torque -o trajectory.csv
    """
    from deltacal_gen.planning import exciting

    check_output(output, robot)
    check_output(picture, robot, output, ending=PICTURES)
    machine = as_robot(robot)
    found, series = exciting.plan_trajectories(machine, runs=runs, period=period_s, harmonics=harmonics, rate=rate_Hz)
    if output is not None:
        exciting.write_trajectory(machine, series, found.rate_Hz, output)
    if picture is not None:
        from deltacal_gen.pages import plans

        plans.trajectory(machine, found, exciting.columns_of(machine, series, found.rate_Hz), picture)
    return found


def planner(robot: AnyRobot, kind: str | None, model: str | int | None, sidecar: Source | None) -> str:
    """Return the function that plans what is measured: poses, joints from either side, or trajectories."""
    from deltacal_gen.motion.kinds import plans_motion

    kind = _kind_of(kind, sidecar)
    if plans_motion(kind, None if model is None else str(model)):
        return plan_trajectory.__name__
    return plan.__name__ if _reached_from_both_sides(as_robot(robot), kind) is None else plan_cycles.__name__


def _kind_of(kind: str | None, sidecar: Source | None) -> str | None:
    """Return the kind of what is measured, as it was given or as the sidecar says it."""
    from deltacal_gen.files.sidecar import read_measurement

    return kind or (None if sidecar is None else read_measurement(sidecar).kind)


def _reached_from_both_sides(robot: Robot, kind: str | None) -> str | None:
    """Return the kind of readings for which joints are reached from either side; None of any other."""
    from deltacal_gen.instrument import kinds
    from deltacal_gen.machine.registry import mechanism_of

    name = next((n for n in kinds.names() if kind in (n, *kinds.kind_of(n).aliases)), kind)
    if name in kinds.names() and kinds.kind_of(name).sees_joints:
        return name
    machine = mechanism_of(robot)
    one_axis = machine.limbs == 1 and machine.many_ways  # a chain of one joint
    return kinds.POINTS if one_axis and name in (None, kinds.POINTS) else None
