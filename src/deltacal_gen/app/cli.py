"""The ``deltacal`` command: arguments in, tables and exit codes out; no computation lives here.

Exit codes: 0 done; 1 done, and the answer is no; 2 usage; 3 bad input; 4 no convergence or no solution.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the matrices are small: threads only wait for one another

import typer
from rich.console import Console
from rich.table import Column, Table

from deltacal_gen.errors import DeltacalError, UsageError

if TYPE_CHECKING:
    from deltacal_gen.results.base import Answer
    from deltacal_gen.results.diagnosis import Diagnosis
    from deltacal_gen.results.plan import Plan
    from deltacal_gen.results.result import Result

app = typer.Typer(
    name="deltacal",
    help="Calibrate parallel robots with models that are derived, not typed.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
MOST_LINES = 60  # of a table on the screen
screen = Console(highlight=False)
aside = Console(stderr=True, highlight=False)

RobotFile = Annotated[Path, typer.Argument(metavar="ROBOT", help="robot file (TOML)", show_default=False)]
RecordingFile = Annotated[Path, typer.Argument(metavar="RECORDING", help="recording (CSV)", show_default=False)]
ResultFile = Annotated[
    Path,
    typer.Argument(metavar="RESULT", help="of identify, or DIAGNOSIS.json of diagnose", show_default=False),
]
Json = Annotated[bool, typer.Option("--json", help="print the JSON and nothing else")]
Model = Annotated[str | None, typer.Option("--model", help="e.g. delta/32 or 32", show_default=False)]
Blocks = Annotated[
    bool, typer.Option("--blocks", help="some rows at a time, in a fixed memory: one set-up, positions, no effects")
]
As = Annotated[str | None, typer.Option("--as", help="'distance': use the distances of all pairs of positions")]


@contextmanager
def _progress(quiet: bool) -> Iterator[Callable[[str], None]]:
    """Show what is being done on the error stream while it lasts; nothing when the output is JSON or no terminal."""
    if quiet or not aside.is_terminal:
        yield lambda text: None
        return
    with aside.status("") as status:
        yield lambda text: status.update(text)


@contextmanager
def _counting(quiet: bool) -> Iterator[Callable[[int, int, str], None]]:
    """Show tasks done and the time left on the error stream; nothing when the output is JSON or no terminal."""
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(), TextColumn("{task.description}"))
    hidden = quiet or not aside.is_terminal
    # drawn when a task has ended, not by a thread: a process of one thread can be forked into workers
    with Progress(*columns, console=aside, disable=hidden, transient=True, auto_refresh=False) as progress:
        bar = progress.add_task("", total=None)
        try:
            yield lambda done, total, label: progress.update(
                bar, completed=done, total=total, description=label, refresh=True
            )
        except KeyboardInterrupt:
            aside.print("stopped; what a run directory holds is kept, and the same command goes on from there")
            raise


def _as_distance(value: str | None) -> bool:
    if value not in (None, "distance"):
        raise typer.BadParameter("only 'distance' is known", param_hint="--as")
    return value == "distance"


def _print_json(answer: Answer | Sequence[Answer]) -> None:
    from deltacal_gen.results.base import plain

    sys.stdout.write(json.dumps(plain(answer), indent=1, allow_nan=False) + "\n")


def _number(value: float | None, digits: int = 4) -> str:
    return "-" if value is None else f"{value:.{digits}g}"


@app.command()
def demo(
    output: Annotated[Path, typer.Option("-o", "--output", help="folder for the files it makes")] = Path("demo"),
    as_json: Json = False,
) -> None:
    """Run the main job end to end on an embedded recording with a concealed effect."""
    from deltacal_gen.app import commands

    with _progress(as_json) as tell:
        found = commands.demo(output, tell)
    if as_json:
        _print_json(found)
        return
    result, diagnosis = found.result, found.diagnosis
    screen.print(
        f"[bold]1. Geometry alone[/bold], {result.model}: {result.readings.scalars} scalar readings, "
        f"held-out error {_number(result.heldout_rms_mm)} mm; the instrument's noise is {result.sigma_mm:.4f} mm."
    )
    screen.print("[bold]2. Diagnosis[/bold]:", end=" ")
    _show_diagnosis(diagnosis)
    told = "; ".join(
        f"{t.name} at joint {p.limb}, {p.name} {p.value:g} {p.unit}" for t in found.truth for p in t.parameters
    )
    screen.print(f"[bold]3. The truth[/bold], read only now: {told}.")
    screen.print("The true machine, commanded by each model of it, with payloads and in directions drawn at random:")
    table = Table("commanded by", f"rms of {found.check[0].poses} poses, mm", "largest, mm")
    for row in found.check:
        table.add_row(row.model, f"{row.rms_mm:.4f}", f"{row.worst_mm:.4f}")
    screen.print(table)
    files = found.files
    screen.print(f"Open {files['diagnosis.html']} (picture: {files['diagnosis.svg']}).")
    screen.print(f"Commands for the controller are in {files['command.c']}; for targets of your own:")
    screen.print(f"  deltacal compensate {files['diagnosis.json']} TARGETS.csv -o JOINTS.csv")


@app.command()
def kernels(
    names: Annotated[
        list[str] | None,
        typer.Argument(metavar="[NAME]...", help="mechanisms, effects, measurements; default all", show_default=False),
    ] = None,
    check: Annotated[bool, typer.Option("--check", help="write nothing; fail if the committed kernels differ")] = False,
    warm: Annotated[bool, typer.Option("--warm", help="derive nothing; compile everything ahead")] = False,
    tried: Annotated[
        Path | None,
        typer.Option("--try", metavar="ROBOT.toml", help="then round trips, ranks and a drawing of such a machine"),
    ] = None,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="FILE.svg", help="the drawing; default MECHANISM.svg")
    ] = None,
) -> None:
    """Derive the models and emit the kernel package (from a source checkout), or compile it ahead (anywhere).

    With --try a machine is looked at whose kernels were just derived: 100 poses there and back, what each kind of
    measurement sees of its largest model, and a drawing made of its own equations.
    """
    from deltacal_gen.app import commands

    if warm:
        commands.warm(lambda name, seconds: screen.print(f"{seconds:7.2f} s  {name}"))
        return
    if not commands.kernels(names or (), check=check):
        raise typer.Exit(1)
    if tried is not None:
        screen.print(commands.trial(tried, output), markup=False, highlight=False)


@app.command()
def derivation(
    output: Annotated[Path, typer.Option("-o", "--output", help="FILE.html or FILE.md; a folder with --all")],
    model: Annotated[
        str | None, typer.Argument(metavar="MODEL", help="e.g. delta/42, delta or backlash", show_default=False)
    ] = None,
    every: Annotated[bool, typer.Option("--all", help="all models and effects, with an index")] = False,
    as_json: Json = False,
) -> None:
    """Write the report for reviewers: every equation, its source, its checks (from a source checkout)."""
    from deltacal_gen.app import commands

    with _progress(as_json) as tell:
        found = commands.derivation(model, output, every=every, progress=tell)
    if as_json:
        _print_json(found)
    else:
        screen.print(f"{len(found.files)} file{'s' if len(found.files) > 1 else ''}; open {found.files[0]}")


@app.command()
def models(as_json: Json = False) -> None:
    """List the mechanisms, their models and their parameters."""
    from deltacal_gen.app import commands

    found = commands.models()
    if as_json:
        _print_json(found)
        return
    for m in found:
        screen.print(f"[bold]{m.mechanism}[/bold]: {m.title} ({m.reference})")
        table = Table("model", "parameters", box=None, padding=(0, 2))
        for name, names in m.models.items():
            shown = " ".join(names) if len(names) <= 8 else f"{' '.join(names[:6])} ... {names[-1]}"
            table.add_row(name, shown)
        screen.print(table)
        table = Table("parameter", "unit", "meaning", box=None, padding=(0, 2))
        for p in m.parameters:
            table.add_row(p.name, p.unit, p.meaning)
        screen.print(table)


@app.command()
def claims(
    paper: Annotated[str | None, typer.Option(help="one paper only, e.g. bai", show_default=False)] = None,
    status: Annotated[str | None, typer.Option(help="one status only, e.g. contradicted", show_default=False)] = None,
    as_json: Json = False,
) -> None:
    """Show what the papers claim, what the derivation gives, and the test that decides."""
    from deltacal_gen.app import commands
    from deltacal_gen.pages import ledger

    found = commands.claims(paper=paper, status=status)
    if as_json:
        _print_json(found)
        return
    papers = {name: [c for c in found if c.paper == name] for name in dict.fromkeys(c.paper for c in found)}
    for name, entries in papers.items():
        table = Table(title=ledger.load_paper(name).title, title_justify="left", show_lines=True)
        for column in ("where", "status", "claim", "printed", "correct", "evidence"):
            table.add_column(column, overflow="fold")
        for c in entries:
            cells = (c.where, c.status, c.statement, c.printed, c.correct, c.evidence)
            table.add_row(*map(_escaped, cells), style="bold" if c.status == "contradicted" else None)
        screen.print(table)
    counts = Table("status", *papers, box=None, padding=(0, 2))
    for s in ledger.STATUSES:
        counts.add_row(s, *(str(sum(c.status == s for c in entries)) for entries in papers.values()))
    counts.add_row("all", *(str(len(entries)) for entries in papers.values()))
    screen.print(counts)


@app.command()
def plan(
    robot: RobotFile,
    model: Annotated[str, typer.Option("--model", help="e.g. delta/18")],
    kind: Annotated[
        str | None, typer.Option(help="what will be measured: distance, position, pose or gauge", show_default=False)
    ] = None,
    gauge: Annotated[
        Path | None, typer.Option(help="a sidecar that says where a gauge's ends are mounted", show_default=False)
    ] = None,
    points: Annotated[
        int | None, typer.Option(help="reference points on the platform, 1 to 3; default as the model needs")
    ] = None,
    start_angle: Annotated[float, typer.Option(help="of the first pose of a ring, deg")] = 0.0,
    layers: Annotated[
        str | None, typer.Option(help="of the rings: top,middle,bottom; default as the paper", show_default=False)
    ] = None,
    scaling: Annotated[
        str | None,
        typer.Option(help="columns: paper, table, file or typical; default the paper's", show_default=False),
    ] = None,
    norm: Annotated[str, typer.Option(help="of the condition number: spectral or frobenius")] = "spectral",
    threshold: Annotated[
        float, typer.Option(help="relative change of the condition number that the rule tolerates")
    ] = 0.01,
    sigma: Annotated[float | None, typer.Option(help="noise, mm: predict what the poses will give")] = None,
    optimal: Annotated[
        int | None, typer.Option(help="so many D-optimal poses instead of rings", show_default=False)
    ] = None,
    singular: Annotated[
        tuple[float, float] | None,
        typer.Option(
            metavar="FROM TO",
            help="poses so far from the nearest singularity, mm, instead of rings: 50 100",
            show_default=False,
        ),
    ] = None,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", help="targets as a CSV for simulate", show_default=False)
    ] = None,
    picture: Annotated[
        Path | None, typer.Option(help="condition number against n, .svg or .png", show_default=False)
    ] = None,
    as_json: Json = False,
) -> None:
    """Choose measuring poses: condition number and observability against n, or a D-optimal set."""
    from deltacal_gen.app import commands
    from deltacal_gen.units import DEG

    kind = kind or (None if gauge is None else "gauge")
    options: dict[str, Any] = {"kind": kind, "tools": points, "scaling": scaling, "norm": norm, "sigma_mm": sigma}
    options |= {"singular": singular} if singular is not None else {}
    if optimal is None:
        options |= {"start_angle": start_angle * DEG, "threshold": threshold}
        options |= {"layers": layers.split(",")} if layers else {}
        options |= {"gauge": gauge} if gauge else {}
    found = commands.plan(robot, model, output, optimal=optimal, picture=picture, **options)
    if as_json:
        _print_json(found)
        return
    _show_plan(found)
    if output is not None:
        screen.print(f"{len(found.poses)} targets written to {output}")


def _show_plan(found: Plan) -> None:
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
                _number(found.condition[j]),
                "-" if change is None else f"{100 * change:.2f} %",
                _number(found.O1[j]),
                _number(found.O3[j]),
            )
        screen.print(table)
    screen.print(f"chosen: {found.chosen}, {len(found.poses)} poses")


@app.command()
def simulate(
    robot: RobotFile,
    poses: Annotated[
        Path, typer.Argument(metavar="POSES", help="joints, or targets x_mm, y_mm, z_mm (CSV)", show_default=False)
    ],
    output: Annotated[Path, typer.Option("-o", "--output", help="the recording to write")],
    truth: Annotated[Path | None, typer.Option(help="TRUTH.toml: the true errors", show_default=False)] = None,
    noise: Annotated[float, typer.Option(help="standard deviation per coordinate, mm")] = 0.0,
    seed: Annotated[int, typer.Option(help="of noise and unknown frame")] = 0,
    blocks: Blocks = False,
    as_json: Json = False,
) -> None:
    """Simulate a recording exactly."""
    from deltacal_gen.app import commands
    from deltacal_gen.results.written import Simulated

    if blocks:
        rows = commands.simulate_blocks(robot, poses, output, truth=truth, noise=noise, seed=seed)
        kind, what = None, "readings"
    else:
        done = commands.simulate(robot, poses, output, truth=truth, noise=noise, seed=seed)
        rows = done.n_rows if done.pairs is None else len(done.pairs)
        kind, what = done.kind, f"readings of the kind {done.kind}"
    if as_json:
        _print_json(Simulated(recording=str(output), readings=rows, kind=kind))
    else:
        screen.print(f"{rows} {what} written to {output}")


@app.command()
def identify(
    robot: RobotFile,
    recording: RecordingFile,
    output: Annotated[Path | None, typer.Option("-o", "--output", help="RESULT.json", show_default=False)] = None,
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
    blocks: Blocks = False,
    as_json: Json = False,
) -> None:
    """Identify the machine's errors from a recording."""
    from deltacal_gen.app import commands

    commands.check_output(picture, robot, recording, ending=commands.PICTURES)
    if blocks:
        if as_kind or physics or picture or report or solver != "prior":
            raise UsageError("in blocks positions are fitted by least squares; leave the other options out.")
        found = commands.identify_blocks(robot, recording, model, output)
    else:
        with _progress(as_json) as tell:
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

        figures.calibration(found, picture)
    if as_json:
        _print_json(found)
        return
    _show_result(found)
    if output is not None:
        screen.print(f"written to {output}")


def _show_result(found: Result) -> None:
    """Print a result: errors before and after, parameters, what is not pinned, one line to end with."""
    from deltacal_gen.diagnosis.spectrum import words
    from deltacal_gen.results.parts import Source
    from deltacal_gen.results.result import Status
    from deltacal_gen.use.comparison import flattered

    for joint in found.never_seen or ():
        screen.print(words(joint))
    for effect in found.physics_not_held or ():
        screen.print(f"{effect.name} of the diagnosed session is not held: this one lacks {effect.missing}")
    counts = {s: sum(p.status is s for p in found.parameters) for s in Status if s is not Status.FIXED}
    table = Table(title=f"{found.model}: parameters, actual minus robot file", title_justify="left")
    for column in ("parameter", "value", "std", "unit", "status"):
        table.add_column(column, justify="right" if column in ("value", "std") else "left")
    for p in found.parameters:
        if p.status is not Status.FIXED:
            table.add_row(p.name, f"{p.value:.4f}", _number(p.std, 2), p.unit, p.status)
    screen.print(table)
    if found.unidentifiable:
        shown = found.unidentifiable[:4]
        screen.print("[bold]Not pinned by these readings[/bold]; the robot file's values hold along them:")
        for c in shown:
            screen.print(f"  - {c.text}")
        if len(found.unidentifiable) > len(shown):
            screen.print(f"  - and {len(found.unidentifiable) - len(shown)} more, in the result file")
    for m in found.next_measurements[:2]:
        pins = "" if m.open_mm is not None else f" would pin {m.pins} of the {m.of} free directions"
        screen.print(f"  + {m.measurement}{pins}")
    if found.gross_errors:
        screen.print(f"gross errors in lines {', '.join(map(str, found.gross_errors))}: they took next to no part")
    if found.accuracy:
        a = found.accuracy
        table = Table("largest error relative to home", "distance, mm", "volumetric, mm")
        for stage, name in ((a.before, "robot file"), (a.rough, "encoder offsets"), (a.after, found.model)):
            if stage is not None:
                table.add_row(name, f"{stage.distance_mm:.3f}", f"{stage.volumetric_mm:.3f}")
        screen.print(table)
    if found.workspace:
        w = found.workspace
        screen.print(
            f"tool position known to {w.median_mm:.3f} mm over the workspace, {w.worst_mm:.3f} at worst (1 std)"
        )
    held = found.heldout_rms_mm
    beside = "" if held is None else f", [bold]held-out {_number(held)} mm[/bold]"  # nothing was held out of blocks
    screen.print(
        f"[bold]{counts[Status.IDENTIFIED]} of {sum(counts.values())} parameters identified[/bold], "
        f"{found.readings.scalars} scalar readings: rms before {found.before_rms_mm:.4f} -> "
        f"after {found.train_rms_mm:.4f} mm{beside} "
        f"(noise {found.sigma_mm:.4f}, {found.sigma_source})"
    )
    if words_of_few := flattered(found.degrees_of_freedom, found.readings.scalars, found.train_rms_mm):
        screen.print(words_of_few)
    if firmware := found.firmware:
        screen.print(
            f"beside it, what firmware fits ({firmware.model}): {firmware.train_rms_mm:.4f} mm, "
            f"held-out {_number(firmware.heldout_rms_mm)} mm"
        )
    chi2 = found.chi2_per_dof
    if chi2 is not None and chi2 > 2 and found.sigma_source is not Source.RESIDUAL:
        screen.print("What is left stands above the noise: this geometry does not explain all of these readings.")


@app.command()
def diagnose(
    robot: RobotFile,
    recording: RecordingFile,
    output: Annotated[Path | None, typer.Option("-o", "--output", help="DIAGNOSIS.json", show_default=False)] = None,
    model: Annotated[str | None, typer.Option("--model", help="default: the largest", show_default=False)] = None,
    report: Annotated[Path | None, typer.Option(help="a page to read, FILE.html", show_default=False)] = None,
    strict: Annotated[bool, typer.Option("--strict", help="exit with 1 unless the verdict is adequate")] = False,
    as_json: Json = False,
) -> None:
    """Find where model and recording differ, and which physics was left out."""
    from deltacal_gen.app import commands
    from deltacal_gen.results.diagnosis import Verdict

    with _progress(as_json) as tell:
        found = commands.diagnose(robot, recording, output, model=model, report=report, progress=tell)
    if as_json:
        _print_json(found)
    else:
        _show_diagnosis(found)
        for path in (output, report):
            if path is not None:
                screen.print(f"written to {path}")
    if strict and found.verdict is not Verdict.ADEQUATE:
        raise typer.Exit(1)


def _show_diagnosis(found: Diagnosis) -> None:
    screen.print(f"[bold]{found.verdict.replace('_', ' ')}[/bold]: {found.summary}")
    if found.effects:
        table = Table("effect", "limb", "parameter", "value", "std", "unit")
        for effect in found.effects:
            for p in effect.parameters:
                limb = "" if p.limb is None else str(p.limb)
                table.add_row(effect.name, limb, p.name, f"{p.value:.6g}", _number(p.std, 2), p.unit)
        screen.print(table)
        for effect in found.effects:
            if effect.indistinguishable_from:
                others = ", ".join(effect.indistinguishable_from)
                screen.print(f"  these poses cannot tell {effect.name} from {others}")
    table = Table("mm, rms of the readings", "fitted", "held out", "chi2 per degree of freedom")
    for words, row in (("geometry", found.baseline), ("with what was found", found.final)):
        table.add_row(
            words,
            f"{row.train_rms_mm:.4f}",
            _number(row.heldout_rms_mm),
            f"{row.chi2_per_dof:.2f}",
        )
    screen.print(table)
    for question in found.next_measurements:
        clear = question.expected_chi2
        promise = "" if clear is None else f" (expected difference in chi2: {clear:.0f})"
        screen.print(f"  next, {question.why}: {question.text}{promise}")
    for other in found.not_tested:
        screen.print(f"  not tested: {other.name}, for want of {_escaped(other.missing)}")
    if found.gross_errors:
        screen.print(f"gross errors in lines {', '.join(map(str, found.gross_errors))}")


@app.command()
def effects(as_json: Json = False) -> None:
    """List the effects that a diagnosis knows, with their parameters."""
    from deltacal_gen.app import commands

    found = commands.effects()
    if as_json:
        _print_json(found)
        return
    table = Table("effect", "what it is", "parameters")
    for e in found:
        parameters = ", ".join(f"{p.name} [{p.unit}]" for p in e.parameters)
        table.add_row(e.effect, e.title, _escaped(parameters))
    screen.print(table)


@app.command()
def matrix(
    robot: RobotFile,
    recording: RecordingFile,
    model: Annotated[str, typer.Option("--model", help="e.g. delta/32")],
    output: Annotated[Path, typer.Option("-o", "--output", help="FILE.npz: H, r, names, units")],
    as_kind: As = None,
    scaling: Annotated[str, typer.Option(help="columns: file (mm, deg), paper, table or typical")] = "file",
    as_json: Json = False,
) -> None:
    """Write the identification matrix itself."""
    from deltacal_gen.app import commands
    from deltacal_gen.identification.identifiability import observability
    from deltacal_gen.results.written import Matrix

    found = commands.matrix(robot, recording, model, output, as_distance=_as_distance(as_kind), scaling=scaling)
    seen = observability(found["H"], len(found["H"]))
    summary = Matrix(
        file=str(output),
        rows=found["H"].shape[0],
        columns=found["H"].shape[1],
        rank=seen.rank,
        condition=seen.condition if seen.rank == seen.columns else None,
        scaling=scaling,
    )
    if as_json:
        _print_json(summary)
    else:
        screen.print(
            f"H {summary.rows} x {summary.columns}, rank {seen.rank}, condition {_number(summary.condition)} "
            f"(scaling {scaling}) written to {summary.file}"
        )


@app.command()
def compensate(
    result: ResultFile,
    targets: Annotated[
        Path | None,
        typer.Argument(
            metavar="TARGETS",
            help="x_mm, y_mm, z_mm, channels (CSV); of a chain joints, or rx_deg ... too",
            show_default=False,
        ),
    ] = None,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", help="JOINTS.csv, or the export", show_default=False)
    ] = None,
    kind: Annotated[str, typer.Option(help="exact or linear")] = "exact",
    export: Annotated[
        str | None, typer.Option(help="c, table, klipper or rrf: the compensator itself", show_default=False)
    ] = None,
    worst: Annotated[float, typer.Option(help="what a table may leave, mm")] = 0.01,
    as_json: Json = False,
) -> None:
    """Correct joint commands, or export the compensator; of a diagnosis with its effects, channel by channel."""
    from deltacal_gen.app import commands
    from deltacal_gen.results.written import Joints

    assumed: list[str] = []
    joints = commands.compensate(result, targets, output, kind=kind, export=export, worst_mm=worst, tell=assumed.append)
    if as_json:
        _print_json(Joints(kind=kind, export=export, joints=joints, assumed=tuple(assumed)))
        return
    if export is not None:
        what = f"{export} lines" if export in ("klipper", "rrf") else f"{kind} compensator"
        screen.print(f"{what} written to {output}; what it leaves is stated in the file")
    elif output is not None:
        screen.print(f"{len(joints)} commands written to {output}")
    else:
        for row in joints:
            screen.print("  ".join(f"{v:12.6f}" for v in row))
    for words in assumed:
        screen.print(f"  {_escaped(words)}")


@app.command()
def predict(
    result: ResultFile,
    recording: RecordingFile,
    output: Annotated[Path, typer.Option("-o", "--output", help="PREDICTED.csv")],
    blocks: Blocks = False,
    as_json: Json = False,
) -> None:
    """Predict the readings of other joints, in the instrument's frame."""
    from deltacal_gen.app import commands
    from deltacal_gen.results.written import Predicted
    from deltacal_gen.use.prediction import CORRECTED

    if blocks:
        rows = commands.predict_blocks(result, recording, output)
        if as_json:
            _print_json(Predicted(file=str(output), readings=rows, told=()))
        else:
            screen.print(f"{rows} readings predicted in {output}")
        return
    told: list[str] = []
    done = commands.predict(result, recording, output, tell=told.append)
    rows = done.n_rows if done.pairs is None else len(done.pairs)
    if as_json:
        _print_json(Predicted(file=str(output), kind=done.kind, readings=rows, told=tuple(told)))
    else:
        screen.print(f"{rows} readings of the kind {done.kind} predicted in {output}")
        for words in told:
            screen.print(words)
        share = done.channels.get(CORRECTED)
        if share is not None and (share < 1).any():
            screen.print(
                f"{(share < 1).sum()} of {len(share)} rows lie outside what was measured for the smooth correction; it "
                f"fades there and at {(share == 0).sum()} of them nothing is corrected (column {CORRECTED})"
            )


@app.command()
def validate(result: ResultFile, recording: RecordingFile, blocks: Blocks = False, as_json: Json = False) -> None:
    """Hold a calibrated model against readings that it has not seen."""
    from deltacal_gen.app import commands
    from deltacal_gen.diagnosis.spectrum import words

    found = commands.validate_blocks(result, recording) if blocks else commands.validate(result, recording)
    if as_json:
        _print_json(found)
        return
    screen.print(
        f"{found.readings} readings: rms {found.rms_mm:.4f} mm, largest {found.worst_mm:.4f} mm "
        f"(noise {found.sigma_mm:.4f} mm)"
    )
    for joint in found.never_seen:
        screen.print(words(joint))
    if (iso := found.iso9283) is not None:
        screen.print(
            f"ISO 9283, {iso.poses} poses: accuracy AP {iso.AP_mean_mm:.4f} mm (largest {iso.AP_max_mm:.4f}), "
            f"repeatability RP {iso.RP_mean_mm:.4f} mm (largest {iso.RP_max_mm:.4f})"
        )


camera_app = typer.Typer(help="Measure with a camera in the hand: boards to calibrate it, a ball to look at.")
app.add_typer(camera_app, name="camera")


def _corners(text: str) -> tuple[int, int]:
    numbers = text.lower().split("x")
    if len(numbers) != 2 or not all(n.isdigit() and int(n) > 1 for n in numbers):
        raise typer.BadParameter("two numbers of at least 2 were expected, e.g. 9x6", param_hint="--corners")
    return int(numbers[0]), int(numbers[1])


@camera_app.command("calibrate")
def camera_calibrate(
    images: Annotated[list[Path], typer.Argument(metavar="IMAGE...", help="images of a chessboard")],
    corners: Annotated[str, typer.Option("--corners", help="inner corners of the board, e.g. 9x6")],
    square: Annotated[float, typer.Option("--square", help="side of a square (mm)")],
    ball: Annotated[float, typer.Option("--ball", help="radius of the ball that the camera will look at (mm)")],
    output: Annotated[Path, typer.Option("-o", "--output", help="camera (TOML)")],
) -> None:
    """Calibrate a camera from images of a chessboard."""
    from deltacal_gen.app.commands import check_output
    from deltacal_gen.files import camera
    from deltacal_gen.files.recording import write_files

    check_output(output, *images, ending=(".toml",))
    found = camera.calibrate([camera.read_image(i) for i in images], _corners(corners), square, ball, images)
    write_files({output: camera.camera_text(found.camera)})
    c = found.camera
    screen.print(
        f"{len(images)} images: focal lengths {c.fx_px:.2f}, {c.fy_px:.2f} px, principal point {c.cx_px:.2f}, "
        f"{c.cy_px:.2f} px, k1 {c.k1:.4f}; corners off by {found.rms_px:.3f} px rms\nwritten to {output}"
    )


@camera_app.command("measure")
def camera_measure(
    camera_file: Annotated[Path, typer.Argument(metavar="CAMERA", help="camera (TOML)")],
    table: Annotated[Path, typer.Argument(metavar="TABLE", help="CSV with the joints and a column 'image'")],
    output: Annotated[Path, typer.Option("-o", "--output", help="recording (CSV)")],
) -> None:
    """Measure the ball in the images of a table: a recording of the kind sphere image."""
    from deltacal_gen.app.commands import check_output
    from deltacal_gen.files import camera

    check_output(output, camera_file, table, ending=(".csv",))
    balls = camera.record(table, camera.read_camera(camera_file), output)
    blur = sorted(b.blur for b in balls)[len(balls) // 2]
    screen.print(f"{len(balls)} images measured, blur {blur:.2f} px\nwritten to {output}")


@app.command()
def compare(
    before: Annotated[Path, typer.Argument(metavar="RESULT_A", help="RESULT.json of the earlier session")],
    after: Annotated[Path, typer.Argument(metavar="RESULT_B", help="RESULT.json of the later session")],
    output: Annotated[Path | None, typer.Option("-o", "--output", help="COMPARISON.json", show_default=False)] = None,
    as_json: Json = False,
) -> None:
    """Say what changed between two sessions of one machine, by parameter, and what did not."""
    from deltacal_gen.app import commands

    found = commands.compare(before, after, output)
    if as_json:
        _print_json(found)
        return
    table = Table("parameter", "before", "after", "change", "std", "unit", "")
    for words, entries in (("changed", found.changed), ("unchanged", found.unchanged), ("unknown", found.unknown)):
        for e in entries:
            table.add_row(e.name, *map(_number, (e.before, e.after, e.change, e.std)), e.unit, words)
    screen.print(table)
    screen.print(_escaped(found.summary))


@app.command("import")
def import_(
    kind: Annotated[str, typer.Argument(metavar="KIND", help="klipper, rrf or points")],
    files: Annotated[
        list[Path],
        typer.Argument(
            metavar="FILE...",
            help="printer.cfg; config.g and heightmap.csv; a tracker's list of points, a table of joints, ROBOT.toml",
        ),
    ],
    output: Annotated[Path, typer.Option("-o", "--output", help="folder for robot.toml and recordings")],
    as_json: Json = False,
) -> None:
    """Make recordings, and a robot file, from what a printer's firmware or a tracker's software keeps."""
    from deltacal_gen.app import commands
    from deltacal_gen.results.written import Imported

    importers: dict[str, tuple[Callable[..., Any], tuple[int, ...]]] = {
        "klipper": (commands.import_klipper, (1,)),
        "rrf": (commands.import_rrf, (2,)),
        "points": (commands.import_points, (2, 3)),
    }
    if kind not in importers:
        raise typer.BadParameter(f"there is no import '{kind}'; known: {', '.join(importers)}", param_hint="KIND")
    read, counts = importers[kind]
    if len(files) not in counts:
        raise typer.BadParameter(
            f"{kind} takes {' or '.join(map(str, counts))} file{'s' if counts[-1] > 1 else ''}", param_hint="FILE"
        )
    found = read(*files, output=output)
    names = [f"{name}.csv" for name in found.recordings]
    if as_json:
        _print_json(
            Imported(
                folder=str(output),
                robot="robot.toml" if found.robot is not None else None,
                recordings=tuple(names),
                warnings=tuple(found.warnings),
            )
        )
        return
    for warning in found.warnings:
        aside.print(_escaped(f"warning: {warning}"))
    written = [*(["robot.toml"] if found.robot is not None else []), *names]
    screen.print(f"{', '.join(written)} written to {output}")


Workers = Annotated[int | None, typer.Option("--workers", min=1, help="local processes; default one per core")]
Cluster = Annotated[str | None, typer.Option("--cluster", metavar="ADDRESS", help="Dask scheduler, tcp://HOST:PORT")]


@app.command()
def study(
    robot: RobotFile,
    plan_file: Annotated[Path, typer.Option("--plan", metavar="PLAN", help="poses or targets (CSV), with a sidecar")],
    output: Annotated[Path | None, typer.Option("-o", "--output", help="STUDY.json", show_default=False)] = None,
    report: Annotated[Path | None, typer.Option("--report", help="page (HTML)", show_default=False)] = None,
    model: Model = None,
    machine: Annotated[str | None, typer.Option("--machine", help="model of what machines are wrong in")] = None,
    trials: Annotated[int, typer.Option("--trials", help="machines to be simulated and calibrated")] = 1000,
    noise: Annotated[
        float | None, typer.Option("--noise", help="of the instrument (mm); default the sidecar's")
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
    as_json: Json = False,
) -> None:
    """Say what a measuring plan will give, before anyone measures."""
    from deltacal_gen.app import commands

    with _counting(as_json) as told:
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
        _print_json(found)
        return
    position, advice = found.position, found.advice
    table = Table("position over the workspace, mm", "rms", "95 % of machines", "largest, 95 %", "predicted rms")
    for p, words in ((position.before, "as built"), (position.after, f"calibrated, {found.model}")):
        expected = f"{p.predicted_rms_mm:.4f}" if p.predicted_rms_mm is not None else ""
        table.add_row(words, f"{p.rms_mm:.4f}", f"{p.p95_mm:.4f}", f"{p.worst_p95_mm:.4f}", expected)
    screen.print(table)
    table = Table("parameter", "drawn", "std", "predicted", "unit")
    for q in found.parameters:
        table.add_row(q.name, *(_number(v, 3) for v in (q.drawn_std, q.std, q.predicted_std)), q.unit)
    screen.print(table)
    for s in found.suspects:
        words = " and ".join(f"{e.name} {' '.join(map(str, e.limbs))}".strip() for e in s.effects) or "nothing"
        low, high = s.interval
        screen.print(
            f"{words} concealed: said so in {s.named_right} of {s.recordings} recordings "
            f"(95 %: {low:.0%} to {high:.0%})"
        )
        for why in s.failed:
            screen.print(f"  not simulated: {_escaped(why)}")
    for c in found.channels_wanted:
        screen.print(f"{c.name} cannot be found without {_escaped(c.missing)}")
    screen.print(f"Twice the measuring takes {advice.doubling:.0%} off the error.")
    for g in advice.add:
        screen.print(f"{g.add}: {g.gain:.0%} off")
    if found.lost:
        screen.print(f"{found.lost} machines could not be simulated or calibrated, and are not counted")
    for path in (output, report):
        if path is not None:
            screen.print(f"written to {path}")


@app.command()
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
    from deltacal_gen.results.batch import ASIDE, alike, worst

    with _counting(as_json) as told:
        found = commands.batch(
            folder, directory, action, model=model, machine=machine, workers=workers, cluster=cluster, told=told
        )
    if as_json:
        _print_json(found)
        return
    rows, done = found.rows, [r for r in found.rows if r.error is None]
    columns = [c for c in dict.fromkeys(k for r in rows for k, _ in r.written()) if c not in ASIDE]
    table = Table(*[Column(c.replace("_", " "), overflow="fold") for c in columns])
    for r in worst(rows, MOST_LINES):
        cells = [getattr(r, c, None) for c in columns]
        table.add_row(*[_number(c) if isinstance(c, float) else str(c if c is not None else "") for c in cells])
    screen.print(table)
    if len(rows) > MOST_LINES:
        screen.print(f"These are the {MOST_LINES} with the largest errors.")
    for change in found.changed[:MOST_LINES]:
        screen.print(f"[bold]{_escaped(change.to)}[/bold] after {_escaped(change.from_)}: {_escaped(change.text)}")
    if len(found.changed) > MOST_LINES:
        screen.print(f"{len(found.changed) - MOST_LINES} more comparisons are in {directory / 'index.html'}")
    for names, why in alike([(r.recording, r.error) for r in rows if r.error is not None])[:MOST_LINES]:
        screen.print(f"failed: {_escaped(names)}: {_escaped(why)}")
    for names, what in alike([(r.recording, r.warnings) for r in rows if r.warnings])[:MOST_LINES]:
        screen.print(f"warning: {_escaped(names)}: {_escaped(what)}")
    screen.print(f"{len(done)} of {len(rows)} recordings done; table.csv and index.html in {directory}")


@app.command()
def manual(
    topic: Annotated[str | None, typer.Argument(metavar="TOPIC", help="without it: all topics")] = None,
    site: Annotated[
        Path | None,
        typer.Option("--site", metavar="FOLDER", help="write all pages as searchable HTML", show_default=False),
    ] = None,
    examples: Annotated[
        Path | None,
        typer.Option("--examples", metavar="FOLDER", help="copy the files that the pages try", show_default=False),
    ] = None,
    as_json: Json = False,
) -> None:
    """Show a page of the manual; write it as a site; copy the examples that it works on."""
    from deltacal_gen.app import commands
    from deltacal_gen.pages.manual import CONTENTS, for_terminal
    from deltacal_gen.results.written import Manual

    first = None if site is None else commands.manual_site(site)
    copies = [] if examples is None else commands.manual_examples(examples)
    text = commands.manual(topic) if topic is not None or (site is None and examples is None) else None
    if as_json:
        files = tuple(str(path) for path in (*([] if first is None else [first]), *copies))
        _print_json(Manual(topic=topic or CONTENTS, text=text, files=files))
        return
    if first is not None:
        screen.print(f"open {first}")
    for path in copies:
        screen.print(str(path))
    if text is not None and screen.is_terminal:
        from rich.markdown import Markdown

        screen.print(Markdown(for_terminal(text), code_theme="ansi_dark"))  # on the terminal's own ground
    elif text is not None:
        sys.stdout.write(text)


def main() -> None:
    """Run the command line; an explained error ends with its own exit code and no traceback."""
    try:
        app()
    except DeltacalError as error:
        aside.print(f"[bold red]error:[/bold red] {_escaped(str(error))}", soft_wrap=True)
        sys.exit(error.exit_code)


def _escaped(text: str) -> str:
    return text.replace("[", "\\[")


if __name__ == "__main__":
    main()
