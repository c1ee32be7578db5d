"""Before anyone measures: poses are chosen, recordings simulated."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from deltacal_gen.app.cli.common import (
    Decimal,
    Json,
    RobotFile,
    output_file,
    print_json,
    screen,
    show,
)

if TYPE_CHECKING:
    from deltacal_gen.machine.values import Recording
    from deltacal_gen.results.base import Answer


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
        _show_plan(moving, output, as_json)
        return
    kind = kind or (None if gauge is None else MOUNTED)
    options: dict[str, Any] = {"kind": kind, "tools": points, "scaling": scaling, "norm": norm, "sigma_mm": sigma}
    options |= {"singular": singular} if singular is not None else {}
    if optimal is None:
        options |= {"start_angle": start_angle * DEG, "threshold": threshold}
        options |= {"layers": layers.split(",")} if layers else {}
        options |= {"gauge": gauge} if gauge else {}
    options |= {"positions": positions, "cycles": cycles, "sidecar": sidecar}
    _show_plan(commands.plan(robot, model, output, optimal=optimal, picture=picture, **options), output, as_json)


def _show_plan(found: Answer, output: Path | None, as_json: bool) -> None:
    """Print a plan, and what its file holds."""
    if as_json:
        print_json(found)
        return
    show(found)
    if output is not None:
        what = "targets" if found["schema"] == "deltacal.plan/1" else "rows"
        written = f"{len(found['n'])} runs" if "series" in found else f"{len(found['poses'])} {what}"
        screen.print(f"{written} written to {output}")


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
        show(found)
    if not found.poses and found.motion is None:
        raise typer.Exit(1)
