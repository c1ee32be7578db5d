"""What a recording tells of a machine: its errors, the physics that was left out, the matrix itself."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.table import Table

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
    show_any,
)
from deltacal_gen.results.base import shown_in

if TYPE_CHECKING:
    from deltacal_gen.results.diagnosis import Diagnosis
    from deltacal_gen.results.result import Result

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
    show_any(found, _show_result)
    if output is not None:
        screen.print(f"written to {output}")


def _show_result(found: Result) -> None:
    """Print a result: errors before and after, parameters, what is not pinned, one line to end with."""
    from deltacal_gen.results.parts import Source
    from deltacal_gen.results.result import Status
    from deltacal_gen.results.shown import decimals, rounded
    from deltacal_gen.use.comparison import said_of_carried, said_of_errors

    for said in said_of_carried(found):
        screen.print(escaped(said))
    counts = {s: sum(p.status is s for p in found.parameters) for s in Status if s is not Status.FIXED}
    table = Table(title=f"{found.model}: parameters, actual minus robot file", title_justify="left")
    for column in ("parameter", "value", "std", "unit", "status"):
        table.add_column(column, justify="right" if column in ("value", "std") else "left")
    for p in found.parameters:
        if p.status is not Status.FIXED:
            value, std = (f"{p.value:.4f}", "-") if p.std is None else rounded(p.value, p.std)
            table.add_row(p.name, value, std, p.unit, p.status)
    screen.print(table)
    _show_not_pinned(found)
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
    if found.uncertainty is not None and found.uncertainty.left_out:
        screen.print(escaped(found.uncertainty.text), style="dim")
    held = found.heldout_rms_mm
    unit, length = shown_in(found)
    beside = "" if held is None else f", [bold]held-out {number(held / length)} {unit}[/bold]"
    screen.print(
        f"[bold]{counts[Status.IDENTIFIED]} of {sum(counts.values())} parameters identified[/bold], "
        f"{found.readings.scalars} scalar readings: rms before {decimals(found.before_rms_mm / length)} -> "
        f"after {decimals(found.train_rms_mm / length)} {unit}{beside} "
        f"(noise {decimals(found.sigma_mm / length)}, {found.sigma_source})"
    )
    for said in said_of_errors(found):
        screen.print(escaped(said))
    if firmware := found.firmware:
        screen.print(
            f"beside it, what firmware fits ({firmware.model}): {decimals(firmware.train_rms_mm)} mm, "
            f"held-out {number(firmware.heldout_rms_mm)} mm"
        )
    chi2 = found.chi2_per_dof
    if chi2 is not None and chi2 > 2 and found.sigma_source is not Source.RESIDUAL:
        screen.print("What is left stands above the noise: this geometry does not explain all of these readings.")
    for doubt in found.doubts or ():
        screen.print(f"warning: {escaped(doubt)}")


def _show_not_pinned(found: Result) -> None:
    """Print which directions the readings leave open, and what would pin them."""
    from deltacal_gen.use.unseen import sentences

    if found.unidentifiable:
        shown = found.unidentifiable[:4]
        screen.print("[bold]Not pinned by these readings[/bold]; the robot file's values hold along them:")
        for c, sentence in zip(shown, sentences(found), strict=False):
            screen.print(f"  - {escaped(sentence or c.text)}")
        if len(found.unidentifiable) > len(shown):
            screen.print(f"  - and {len(found.unidentifiable) - len(shown)} more, in the result file")
    for m in found.next_measurements[:2]:
        pins = "" if m.open_mm is not None else f" would pin {m.pins} of the {m.of} free directions"
        screen.print(f"  + {escaped(m.measurement)}{pins}")


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
        show_any(found, show_diagnosis)
        for path in (output, report, write_effect if found.laws else None):
            if path is not None:
                screen.print(f"written to {path}")
    if write_effect is not None and not found.laws:
        if not as_json:
            screen.print(f"no law was found: {write_effect} is not written")
        raise typer.Exit(1)
    if strict and found.verdict is not Verdict.ADEQUATE:
        raise typer.Exit(1)


def show_diagnosis(found: Diagnosis) -> None:
    """Print a diagnosis: its verdict, the effects with their parameters, and what cannot be told from them."""
    from deltacal_gen.files.robot import robot_of
    from deltacal_gen.machine.places import at, number_of, part_of
    from deltacal_gen.results.shown import decimals, rounded

    robot = robot_of(found.robot)
    screen.print(f"[bold]{found.verdict.replace('_', ' ')}[/bold]: {escaped(found.summary)}")
    if found.effects:
        table = Table("effect", part_of(robot), "parameter", "value", "std", "unit")
        for effect in found.effects:
            for p in effect.parameters:
                limb = "" if p.limb is None else escaped(number_of(robot, p.limb))
                value, std = (p.value, "-") if isinstance(p.value, str) else rounded(p.value, p.std)
                table.add_row(effect.name, limb, p.label, value, std, p.unit)
        screen.print(table)
        for effect in found.findings:
            if effect.indistinguishable_from:
                others = ", ".join(effect.indistinguishable_from)
                screen.print(f"  these poses cannot tell {effect.name} from {others}")
            for limb, instead in (effect.instead_of_limb or {}).items():
                which = f"{effect.name}{at(robot, [int(limb)])} from one{at(robot, instead)}"
                screen.print(f"  these poses cannot tell {escaped(which)}")
    for k, law in enumerate(found.laws):
        for term in law.terms:
            said = escaped(f"{term.expression}{at(robot, term.limbs)}")
            screen.print(f"  {'or' if k else 'law:'} {term.target} moves by {said}")
            if not k:
                for c in term.coefficients:
                    where = "" if c.limb is None else escaped(at(robot, [c.limb]))
                    value, std = rounded(c.value, c.std)
                    screen.print(f"    {c.name} = {value} +- {std} {c.unit}{where}")
    unit, length = shown_in(found)
    table = Table(f"{unit}, rms of the readings", "fitted", "held out", "chi2 per degree of freedom")
    for words, row in (("geometry", found.baseline), ("with what was found", found.final)):
        table.add_row(
            words,
            decimals(row.train_rms_mm / length),
            number(row.heldout_rms_mm and row.heldout_rms_mm / length),
            f"{row.chi2_per_dof:.2f}",
        )
    screen.print(table)
    for hint in found.hints:
        where = escaped(at(robot, hint.limbs))
        screen.print(f"  may be there, p = {hint.p_value:.2g}: {hint.name}{where}; it {escaped(hint.why)}")
    for question in found.next_measurements:
        clear = question.expected_chi2
        promise = "" if clear is None else f" (expected difference in chi2: {clear:.0f})"
        screen.print(f"  next, {escaped(question.why)}: {escaped(question.text)}{promise}")
    for missing in dict.fromkeys(other.missing for other in found.not_tested):
        names = ", ".join(other.name for other in found.not_tested if other.missing == missing)
        screen.print(f"  not tested: {names}, for want of {escaped(missing)}")
    if found.gross_errors:
        screen.print(f"gross errors in lines {', '.join(map(str, found.gross_errors))}")


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
