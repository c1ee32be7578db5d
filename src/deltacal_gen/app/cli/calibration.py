"""What a recording tells of a machine: its errors, the physics that was left out, the matrix itself."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from deltacal_gen.app.cli.common import (
    Decimal,
    Json,
    Model,
    RecordingFile,
    RobotFile,
    escaped,
    number,
    output_file,
    print_json,
    progress,
    screen,
    show,
)

As = Annotated[str | None, typer.Option("--as", help="'distance': use the distances of all pairs of positions")]


def _as_distance(value: str | None) -> bool:
    if value is None:
        return False
    from deltacal_gen.instrument.kinds import PAIRS

    if value != PAIRS:
        raise typer.BadParameter(f"only '{PAIRS}' is known", param_hint="--as")
    return True


def identify(
    robot: RobotFile,
    recording: RecordingFile,
    output: Annotated[Path | None, output_file("RESULT.json")] = None,
    model: Model = None,
    as_kind: As = None,
    solver: Annotated[str, typer.Option(help="prior, least-squares, tsvd or ridge")] = "prior",
    truncation: Annotated[str, typer.Option(help="for tsvd: a number, gcv or discrepancy")] = "gcv",
    robust: Annotated[bool, typer.Option(help="let gross errors not move the result")] = True,
    physics: Annotated[
        Path | None, typer.Option(help="DIAGNOSIS.json: its effects are held", show_default=False)
    ] = None,
    picture: Annotated[Path | None, typer.Option(help="what it found, .svg or .png", show_default=False)] = None,
    report: Annotated[Path | None, typer.Option(help="a page to read, .html", show_default=False)] = None,
    decimal: Decimal = None,
    as_json: Json = False,
) -> None:
    """Identify the machine's errors from a recording."""
    from deltacal_gen.app import commands

    commands.check_output(picture, robot, recording, output, report, ending=commands.PICTURES)
    with progress(as_json) as tell:
        found = commands.identify(
            robot,
            recording,
            model,
            output,
            as_distance=_as_distance(as_kind),
            solver=solver,
            truncation=int(truncation) if truncation.isdecimal() else truncation,
            robust=robust,
            physics=physics,
            report=report,
            progress=tell,
        )
    if picture is not None:
        from deltacal_gen.pages import figures

        figures.write(found, picture)
    if as_json:
        print_json(found)
        return
    show(found)
    if output is not None:
        screen.print(f"written to {output}")


def diagnose(
    robot: RobotFile,
    recording: RecordingFile,
    output: Annotated[Path | None, output_file("DIAGNOSIS.json")] = None,
    model: Annotated[str | None, typer.Option("--model", help="default: the largest", show_default=False)] = None,
    report: Annotated[Path | None, typer.Option(help="a page to read, FILE.html", show_default=False)] = None,
    write_effect: Annotated[
        Path | None, typer.Option(help="the law that was found as a file of an effect, NAME.py", show_default=False)
    ] = None,
    strict: Annotated[bool, typer.Option("--strict", help="exit with 1 unless the verdict is adequate")] = False,
    decimal: Decimal = None,
    as_json: Json = False,
) -> None:
    """Find where model and recording differ, and which physics was left out."""
    from deltacal_gen.app import commands
    from deltacal_gen.results.diagnosis import Verdict

    with progress(as_json) as tell:
        found = commands.diagnose(
            robot, recording, output, model=model, report=report, write_effect=write_effect, progress=tell
        )
    if as_json:
        print_json(found)
    else:
        show(found)
        for path in (output, report, write_effect if found.laws else None):
            if path is not None:
                screen.print(f"written to {path}")
    if write_effect is not None and not found.laws:
        if not as_json:
            screen.print(f"no law was found: {write_effect} is not written")
        raise typer.Exit(1)
    if strict and found.verdict is not Verdict.ADEQUATE:
        raise typer.Exit(1)


def matrix(
    robot: RobotFile,
    recording: RecordingFile,
    model: Annotated[str, typer.Option("--model", help="e.g. delta/32")],
    output: Annotated[Path, output_file("FILE.npz: H, r, names, units")],
    as_kind: As = None,
    scaling: Annotated[str, typer.Option(help="columns: file (mm, deg), paper, table or typical")] = "file",
    decimal: Decimal = None,
    as_json: Json = False,
) -> None:
    """Write the identification matrix itself."""
    from deltacal_gen.app import commands
    from deltacal_gen.identification.identifiability import observability
    from deltacal_gen.results.written import Matrix

    found = commands.matrix(robot, recording, model, output, as_distance=_as_distance(as_kind), scaling=scaling)
    rows, columns = found["H"].shape
    told = {key: tuple(map(str, found[key])) for key in ("combinations", "unidentifiable") if key in found}
    seen = None if told else observability(found["H"], rows)
    summary = Matrix(
        file=str(output),
        rows=rows,
        columns=columns,
        rank=len(told["combinations"]) if seen is None else seen.rank,
        condition=seen.condition if seen is not None and seen.rank == columns else None,
        scaling=scaling,
        combinations=told.get("combinations"),
        unidentifiable=told.get("unidentifiable"),
    )
    if as_json:
        print_json(summary)
    else:
        screen.print(
            f"H {summary.rows} x {summary.columns}, rank {summary.rank}, condition {number(summary.condition)} "
            f"(scaling {scaling}) written to {summary.file}"
        )
        for key, texts in told.items():
            screen.print(f"  {key}: {escaped('; '.join(texts))}")
