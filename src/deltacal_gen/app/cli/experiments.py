"""Before anyone measures: poses are chosen, recordings simulated."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, cast

import typer
from rich.table import Table

from deltacal_gen.app.cli.common import (
    Decimal,
    Json,
    RobotFile,
    escaped,
    number,
    output_file,
    print_json,
    screen,
)

MOST_NOTES = 4  # on the screen
if TYPE_CHECKING:
    from deltacal_gen.machine.values import Recording
    from deltacal_gen.results.motion import MotionPlan
    from deltacal_gen.results.plan import CyclePlan, Plan
    from deltacal_gen.results.written import Runs


Measured = Annotated[
    str | None,
    typer.Option(
        help="what is measured: distance, position, pose, gauge, encoder, torque, 'board image' or 'touched board'",
        show_default=False,
    ),
]
Singular = Annotated[
    tuple[float, float] | None,
    typer.Option(
        metavar="FROM TO",
        help="poses so far from the nearest singularity, mm, instead of rings: 50 100",
        show_default=False,
    ),
]
Picture = Annotated[
    Path | None, typer.Option(help="condition number against n, or the trajectory, .svg or .png", show_default=False)
]
Scaling = Annotated[
    str | None, typer.Option(help="columns: paper, table, file or typical; default the paper's", show_default=False)
]


SidecarFile = Annotated[
    Path | None,
    typer.Option(help="what the readings' sidecar will say: kind, place and lens of a camera", show_default=False),
]
Positions = Annotated[
    int | None, typer.Option(help="one axis, or kind encoder: reached from both sides", show_default=False)
]
Cycles = Annotated[int | None, typer.Option(help="one axis: forth and back; default 5", show_default=False)]
Layers = Annotated[
    str | None, typer.Option(help="of the rings: top,middle,bottom; default as the paper", show_default=False)
]


PlannedModel = Annotated[
    str | None,
    typer.Option("--model", help="e.g. delta/18; not needed for kinds torque and encoder", show_default=False),
]
GaugeFile = Annotated[
    Path | None, typer.Option(help="a sidecar that says where a gauge's ends are mounted", show_default=False)
]
Points = Annotated[
    int | None, typer.Option(help="reference points on the platform, 1 to 3; default as the model needs")
]
Threshold = Annotated[float, typer.Option(help="relative change of the condition number that the rule tolerates")]
Optimal = Annotated[int | None, typer.Option(help="so many D-optimal poses instead of rings", show_default=False)]


def plan(
    robot: RobotFile,
    model: PlannedModel = None,
    kind: Measured = None,
    gauge: GaugeFile = None,
    sidecar: SidecarFile = None,
    points: Points = None,
    start_angle: Annotated[float, typer.Option(help="of the first pose of a ring, deg")] = 0.0,
    layers: Layers = None,
    scaling: Scaling = None,
    norm: Annotated[str, typer.Option(help="of the condition number: spectral or frobenius")] = "spectral",
    threshold: Threshold = 0.01,
    sigma: Annotated[float | None, typer.Option(help="noise, mm: predict what the poses will give")] = None,
    optimal: Optimal = None,
    singular: Singular = None,
    positions: Positions = None,
    cycles: Cycles = None,
    runs: Annotated[int, typer.Option(help="kind torque: movements, each a run")] = 3,
    period: Annotated[float, typer.Option(help="kind torque: of each movement, s")] = 10.0,
    harmonics: Annotated[int, typer.Option(help="kind torque: of its Fourier series")] = 5,
    rate: Annotated[float, typer.Option(help="kind torque: samples per second, Hz")] = 100.0,
    output: Annotated[Path | None, output_file("targets, or the trajectory, as a CSV for simulate")] = None,
    picture: Picture = None,
    as_json: Json = False,
) -> None:
    """Choose measuring poses: condition number and observability against n, or a D-optimal set."""
    from deltacal_gen.app import commands
    from deltacal_gen.instrument.kinds import MOUNTED
    from deltacal_gen.motion.kinds import plans_motion
    from deltacal_gen.units import DEG

    if plans_motion(kind, model):
        series: dict[str, Any] = {"runs": runs, "period": period, "harmonics": harmonics, "rate": rate}
        moving = commands.plan(
            robot,
            model,
            output,
            optimal=optimal,
            picture=picture,
            gauge=gauge,
            sidecar=sidecar,
            kind=kind,
            **series,
        )
        _show_trajectory(cast("MotionPlan", moving), output, as_json)
        return
    kind = kind or (None if gauge is None else MOUNTED)
    options: dict[str, Any] = {"kind": kind, "tools": points, "scaling": scaling, "norm": norm, "sigma_mm": sigma}
    options |= {"singular": singular} if singular is not None else {}
    if optimal is None:
        options |= {"start_angle": start_angle * DEG, "threshold": threshold}
        options |= {"layers": layers.split(",")} if layers else {}
        options |= {"gauge": gauge} if gauge else {}
    options |= {"positions": positions, "cycles": cycles, "sidecar": sidecar}
    found = cast("Plan", commands.plan(robot, model, output, optimal=optimal, picture=picture, **options))
    if as_json:
        print_json(found)
        return
    what = _show_plan(found)
    if output is not None:
        screen.print(f"{len(found.poses)} {what} written to {output}")


def _show_trajectory(found: MotionPlan, output: Path | None, as_json: bool) -> None:
    """Print what exciting trajectories tell."""
    if as_json:
        print_json(found)
        return
    screen.print(escaped(found.headline))
    table = Table("runs", "readings", "condition", "O1", "O3")
    for n, readings, condition, o1, o3 in zip(
        found.n, found.readings, found.condition, found.O1, found.O3, strict=True
    ):
        table.add_row(str(n), str(readings), number(condition), number(o1), number(o3))
    screen.print(table)
    for note in found.notes:
        screen.print(f"  {escaped(note)}")
    if output is not None:
        screen.print(f"{len(found.n)} runs written to {output}")


def _show_plan(found: Plan | CyclePlan) -> str:
    """Print a plan; return what its file holds."""
    from deltacal_gen.results.plan import CyclePlan

    if isinstance(found, CyclePlan):
        screen.print(found.headline)
        return "rows"
    screen.print(found.conventions)
    if found.n:
        table = Table("n", "poses", "rank", "condition", "change", "O1", "O3")
        for j, n in enumerate(found.n):
            mark = " <-" if n == found.chosen else ""
            change = found.change[j]
            table.add_row(
                f"{n}{mark}",
                str(found.pose_count[j]),
                str(found.rank[j]),
                number(found.condition[j]),
                "-" if change is None else f"{100 * change:.2f} %",
                number(found.O1[j]),
                number(found.O3[j]),
            )
        screen.print(table)
    notes = found.notes or ()
    for note in notes[:MOST_NOTES]:
        screen.print(f"  {note}")
    if len(notes) > MOST_NOTES:
        screen.print(f"  and {len(notes) - MOST_NOTES} more poses likewise")
    screen.print(f"chosen: {found.chosen}, {len(found.poses)} poses")
    return "targets"


def simulate(
    robot: RobotFile,
    poses: Annotated[
        Path, typer.Argument(metavar="POSES", help="joints, or targets x_mm, y_mm, z_mm (CSV)", show_default=False)
    ],
    output: Annotated[Path, typer.Option("-o", "--output", help="the recording to write")],
    truth: Annotated[Path | None, typer.Option(help="TRUTH.toml: the true errors", show_default=False)] = None,
    noise: Annotated[
        float, typer.Option(help="standard deviation of a reading, in its unit (mm, px, deg; Nm, N, A)")
    ] = 0.0,
    seed: Annotated[int, typer.Option(help="of noise and unknown frame")] = 0,
    decimal: Decimal = None,
    as_json: Json = False,
) -> None:
    """Simulate a recording exactly."""
    from deltacal_gen.app import commands
    from deltacal_gen.results.written import Simulated

    done = commands.simulate(robot, poses, output, truth=truth, noise=noise, seed=seed)
    rows = done.n_rows if done.pairs is None else len(done.pairs)
    if as_json:
        print_json(Simulated(recording=str(output), readings=rows, kind=done.kind))
    else:
        screen.print(f"{rows} readings of the kind {done.kind} written to {output}")
        if (noisy := _noise_told(done, noise)) is not None:
            screen.print(noisy)


def _noise_told(done: Recording, noise: float) -> str | None:
    """Say in which unit noise was taken, where that is not mm alone."""
    from deltacal_gen.instrument.kinds import kind_of
    from deltacal_gen.results.reader import KINDS_IN_MOTION

    if not noise or done.kind in KINDS_IN_MOTION:
        return None
    kind, turns = kind_of(done.kind), done.measurement.sigma_deg
    if kind.rotations:
        return f"noise: {noise:g} mm of positions, {turns:.3g} deg of rotations"
    unit = kind.unit_in(done.columns)
    return None if unit == "mm" else f"noise: {noise:g} {unit} of each reading"


def next_(
    diagnosis: Annotated[
        Path, typer.Argument(metavar="DIAGNOSIS", help="DIAGNOSIS.json of diagnose", show_default=False)
    ],
    output: Annotated[Path, output_file("POSES.csv: rows to measure; in motion a trajectory of runs to record")],
    budget: Annotated[
        int | None, typer.Option(help="how many rows; default as many as the open questions take", show_default=False)
    ] = None,
    as_json: Json = False,
) -> None:
    """Write the rows to measure next, which settle what a diagnosis leaves open."""
    from deltacal_gen.app import commands

    found = commands.next_poses(diagnosis, output, budget=budget)
    if as_json:
        print_json(found)
    else:
        for asked in found.questions:
            screen.print(f"{asked.rows} rows: {asked.why} (expected difference in chi2: {asked.expected_chi2:.0f})")
        for words in found.advice:
            screen.print(f"  {escaped(words)}")
        if found.motion is not None:
            _show_runs(found.motion, output)
        elif found.poses:
            screen.print(f"{len(found.poses)} rows written to {output}: measure them, append them, diagnose again")
        else:
            screen.print("nothing is open that poses could settle; no file was written")
    if not found.poses and found.motion is None:
        raise typer.Exit(1)


def _show_runs(found: Runs, output: Path | None) -> None:
    """Print which runs of a machine in motion are to be recorded."""
    for n, (name, period) in enumerate(zip(found.runs, found.period_s, strict=True)):
        carried = "" if found.payload_kg is None else f", with {found.payload_kg[n]:g} kg"
        screen.print(f"  {name}: {period:g} s{carried}")
    for note in found.notes:
        screen.print(f"  {escaped(note)}")
    screen.print(
        f"{len(found.runs)} runs written to {output}: let the machine follow them, record what its drives give, append "
        "it, diagnose again"
    )
    screen.print(f"other lengths or rates: {escaped(found.command)}")
