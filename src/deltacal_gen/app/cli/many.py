"""Many machines: simulated ones of a study, recorded ones of a batch."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from deltacal_gen.app.cli.common import (
    Decimal,
    Json,
    Model,
    RobotFile,
    counting,
    output_file,
    print_json,
    screen,
    show,
)

Workers = Annotated[int | None, typer.Option("--workers", min=1, help="local processes; default one per core")]
Cluster = Annotated[str | None, typer.Option("--cluster", metavar="ADDRESS", help="Dask scheduler, tcp://HOST:PORT")]


def study(
    robot: RobotFile,
    plan_file: Annotated[Path, typer.Option("--plan", metavar="PLAN", help="poses or targets (CSV), with a sidecar")],
    output: Annotated[Path | None, output_file("STUDY.json")] = None,
    report: Annotated[Path | None, typer.Option("--report", help="page (HTML)", show_default=False)] = None,
    model: Model = None,
    machine: Annotated[str | None, typer.Option("--machine", help="model of what machines are wrong in")] = None,
    trials: Annotated[int, typer.Option("--trials", help="machines to be simulated and calibrated")] = 1000,
    noise: Annotated[
        float | None,
        typer.Option("--noise", help="of a reading, in its unit (mm, px, deg); default the sidecar's"),
    ] = None,
    suspects: Annotated[
        list[Path] | None,
        typer.Option("--suspect", metavar="TRUTH", help="effects that may be there (TOML); repeatable"),
    ] = None,
    diagnoses: Annotated[int, typer.Option("--diagnoses", help="recordings in which each suspicion is concealed")] = 10,
    seed: Annotated[int, typer.Option("--seed")] = 0,
    workers: Workers = None,
    cluster: Cluster = None,
    directory: Annotated[
        Path | None, typer.Option("--run", metavar="DIR", help="keep results there, to resume")
    ] = None,
    decimal: Decimal = None,
    as_json: Json = False,
) -> None:
    """Say what a measuring plan will give, before anyone measures."""
    from deltacal_gen.app import commands

    with counting(as_json) as told:
        found = commands.study(
            robot,
            plan_file,
            output,
            model=model,
            machine=machine,
            trials=trials,
            noise=noise,
            suspects=suspects or (),
            diagnoses=diagnoses,
            seed=seed,
            workers=workers,
            cluster=cluster,
            directory=directory,
            report=report,
            told=told,
        )
    if as_json:
        print_json(found)
        return
    show(found)
    for path in (output, report):
        if path is not None:
            screen.print(f"written to {path}")


def batch(
    folder: Annotated[Path, typer.Argument(metavar="DIR", help="folder with a folder for each machine")],
    directory: Annotated[
        Path, typer.Option("-o", "--output", metavar="RUN", help="run directory; resumed if it is there")
    ],
    action: Annotated[str, typer.Option("--do", help="diagnose, identify or validate")] = "diagnose",
    model: Model = None,
    machine: Annotated[
        str | None, typer.Option("--machine", metavar="REGEX", help="paths with the same match are of one machine")
    ] = None,
    workers: Workers = None,
    cluster: Cluster = None,
    as_json: Json = False,
) -> None:
    """Identify, validate or diagnose many recordings; what is done is not done again."""
    from deltacal_gen.app import commands

    with counting(as_json) as told:
        found = commands.batch(
            folder, directory, action, model=model, machine=machine, workers=workers, cluster=cluster, told=told
        )
    if as_json:
        print_json(found)
        return
    show(found)
    screen.print(f"table.csv and index.html written to {directory}")
