"""Many machines: simulated ones of a study, recorded ones of a batch."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.table import Column, Table

from deltacal_gen.app.cli.common import (
    Decimal,
    Json,
    Model,
    RobotFile,
    counting,
    escaped,
    number,
    output_file,
    print_json,
    screen,
)

if TYPE_CHECKING:
    from deltacal_gen.results.motion import MotionStudy
    from deltacal_gen.results.study import Study

MOST_LINES = 60  # of a table on the screen
Workers = Annotated[int | None, typer.Option("--workers", min=1, help="local processes; default one per core")]
Cluster = Annotated[str | None, typer.Option("--cluster", metavar="ADDRESS", help="Dask scheduler, tcp://HOST:PORT")]


def study(
    robot: RobotFile,
    plan_file: Annotated[
        Path, typer.Option("--plan", metavar="PLAN", help="poses, targets or a trajectory (CSV), with a sidecar")
    ],
    output: Annotated[Path | None, output_file("STUDY.json")] = None,
    report: Annotated[Path | None, typer.Option("--report", help="page (HTML)", show_default=False)] = None,
    model: Model = None,
    machine: Annotated[str | None, typer.Option("--machine", help="model of what machines are wrong in")] = None,
    trials: Annotated[int, typer.Option("--trials", help="machines to be simulated and calibrated")] = 1000,
    noise: Annotated[
        float | None,
        typer.Option("--noise", help="of a reading, in its unit (mm, px, deg; Nm, N, A); default the sidecar's"),
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
    """Say what a measuring plan, or a trajectory, will give, before anyone measures."""
    from deltacal_gen.app import commands
    from deltacal_gen.results.study import Study

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
    (_show_study if isinstance(found, Study) else _show_drives)(found)
    for path in (output, report):
        if path is not None:
            screen.print(f"written to {path}")


def _show_study(found: Study) -> None:
    """Print what a plan will give: errors, parameters, what diagnoses would say, what to add."""
    position, advice = found.position, found.advice
    if position is None or advice is None:
        screen.print(f"{found.model}: these readings see no source error; noise {found.noise_told}")
        _show_suspects(found)
        return
    table = Table("position over the workspace, mm", "rms", "95 % of machines", "largest, 95 %", "predicted rms")
    for p, words in ((position.before, "as built"), (position.after, f"calibrated, {found.model}")):
        expected = f"{p.predicted_rms_mm:.4f}" if p.predicted_rms_mm is not None else ""
        table.add_row(words, f"{p.rms_mm:.4f}", f"{p.p95_mm:.4f}", f"{p.worst_p95_mm:.4f}", expected)
    screen.print(table)
    table = Table("parameter", "drawn", "std", "predicted", "unit")
    for q in found.parameters:
        table.add_row(q.name, *(number(v, 3) for v in (q.drawn_std, q.std, q.predicted_std)), q.unit)
    screen.print(table)
    _show_suspects(found)
    if found.unit is not None or found.turn_sigma_deg is not None:
        screen.print(f"Each coordinate is read with a noise of {found.noise_told}.")
    screen.print(f"Twice the measuring takes {advice.doubling:.0%} off the error.")
    for g in advice.add:
        screen.print(f"{g.add}: {g.gain:.0%} off")
    if found.lost:
        screen.print(f"{found.lost} machines could not be simulated or calibrated, and are not counted")


def _show_drives(found: MotionStudy) -> None:
    """Print what a trajectory will tell of drives."""
    table = Table("torque on other movements", "as drawn", "identified", "95 % of machines", "predicted", "unit")
    for t in found.torque:
        figures = (t.before_rms, t.after_rms, t.p95, t.predicted_rms)
        table.add_row(f"joint {t.limb}", *("" if v is None else number(v, 3) for v in figures), t.unit)
    screen.print(table)
    table = Table("base parameter", "drawn", "std", "predicted", "stated", "unit")
    for p in found.parameters:
        spreads = (p.drawn_std, p.std, p.predicted_std, p.stated_std)
        table.add_row(p.name, *("not told" if v is None else number(v, 3) for v in spreads), p.unit)
    screen.print(table)
    _show_suspects(found)
    for more in found.add:
        errors = ", ".join("-" if v is None else number(v, 3) for v in more.rms_by_joint)
        screen.print(f"{more.add}: {errors}")
    for note in found.notes:
        screen.print(f"  {escaped(note)}")


def _show_suspects(found: Study | MotionStudy) -> None:
    """Print how often what was concealed was named."""
    from deltacal_gen.files.robot import robot_of
    from deltacal_gen.machine.places import at
    from deltacal_gen.results.motion import MotionStudy

    robot, part = robot_of(found.robot), "joint" if isinstance(found, MotionStudy) else None
    for s in found.suspects:
        words = " and ".join(f"{e.name}{escaped(at(robot, e.limbs, part))}" for e in s.effects) or "nothing"
        low, high = s.interval
        screen.print(
            f"{words} concealed: said so in {s.named_right} of {s.recordings} recordings "
            f"(95 %: {low:.0%} to {high:.0%})"
        )
        for why in s.failed:
            screen.print(f"  not simulated: {escaped(why)}")
    for c in found.channels_wanted:
        screen.print(f"{c.name} cannot be found without {escaped(c.missing)}")


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
    from deltacal_gen.results.batch import ASIDE, alike, in_table, worst

    with counting(as_json) as told:
        found = commands.batch(
            folder, directory, action, model=model, machine=machine, workers=workers, cluster=cluster, told=told
        )
    if as_json:
        print_json(found)
        return
    rows, done = found.rows, [r for r in found.rows if r.error is None]
    columns = [c for c in dict.fromkeys(k for r in rows for k, _ in r.written()) if c not in ASIDE]
    table = Table(*[Column(c.replace("_", " "), overflow="fold") for c in columns])
    for r in worst(rows, MOST_LINES):
        cells = [getattr(r, c, None) for c in columns]
        table.add_row(*[number(c) if isinstance(c, float) else escaped(str(in_table(c))) for c in cells])
    screen.print(table)
    if len(rows) > MOST_LINES:
        screen.print(f"These are the {MOST_LINES} with the largest errors.")
    for change in found.changed[:MOST_LINES]:
        screen.print(f"[bold]{escaped(change.to)}[/bold] after {escaped(change.from_)}: {escaped(change.text)}")
    if len(found.changed) > MOST_LINES:
        screen.print(f"{len(found.changed) - MOST_LINES} more comparisons are in {directory / 'index.html'}")
    for names, why in alike([(r.recording, r.error) for r in rows if r.error is not None])[:MOST_LINES]:
        screen.print(f"failed: {escaped(names)}: {escaped(why)}")
    for names, what in alike([(r.recording, r.warnings) for r in rows if r.warnings])[:MOST_LINES]:
        screen.print(f"warning: {escaped(names)}: {escaped(what)}")
    if found.passed_over:
        rest = f" and {len(found.passed_over) - 3} more" if len(found.passed_over) > 3 else ""
        screen.print(f"passed over: {escaped(', '.join(found.passed_over[:3]))}{rest}: no recordings")
    screen.print(f"{len(done)} of {len(rows)} recordings done; table.csv and index.html in {directory}")
