"""What a calibrated machine is good for: commands, predictions, a check, a comparison of two sessions."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.table import Table

from deltacal_gen.app.cli.common import (
    Decimal,
    Json,
    RecordingFile,
    ResultFile,
    escaped,
    number,
    output_file,
    print_json,
    screen,
    show_any,
)
from deltacal_gen.errors import UsageError
from deltacal_gen.results.base import shown_in
from deltacal_gen.results.shown import decimals

MOST_NAMES = 8  # of parameters in a line on the screen
if TYPE_CHECKING:
    from deltacal_gen.results.validation import Validation
    from deltacal_gen.results.written import FirmwareLines


Trajectory = Annotated[
    bool, typer.Option("--trajectory", help="TARGETS are samples in time: joints and torques, of a result in motion")
]


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
    output: Annotated[Path | None, output_file("JOINTS.csv, or the export")] = None,
    kind: Annotated[str, typer.Option(help="exact or linear")] = "exact",
    export: Annotated[
        str | None,
        typer.Option(help="c or table: the compensator; klipper, rrf, marlin: a printer's lines", show_default=False),
    ] = None,
    worst: Annotated[float, typer.Option(help="what a table may leave, mm")] = 0.01,
    bands: Annotated[
        bool, typer.Option("--bands", help="beside each command where the machine will stand, with 95 % probability")
    ] = False,
    trajectory: Trajectory = False,
    decimal: Decimal = None,
    as_json: Json = False,
) -> None:
    """Correct joint commands, or export the compensator; of a diagnosis with its effects, channel by channel."""
    if trajectory:
        if targets is None or bands or export is not None:
            raise UsageError("--trajectory needs the file of samples, and neither --bands nor --export.")
        _feed_forward(result, targets, output, as_json)
        return
    from deltacal_gen.app import commands
    from deltacal_gen.results.written import Joints
    from deltacal_gen.use.firmware import KINDS

    assumed: list[str] = []
    if export in KINDS and output is not None:
        import numpy as np

        lines = commands.firmware_lines(result, export, output, tell=assumed.append)
        if as_json:
            print_json(
                Joints(kind=kind, export=export, joints=np.zeros((0, 3)), assumed=tuple(assumed), firmware=lines)
            )
        else:
            _show_lines(lines, output, assumed)
        return
    joints = commands.compensate(
        result, targets, output, kind=kind, export=export, worst_mm=worst, bands=bands, tell=assumed.append
    )
    if as_json:
        print_json(Joints(kind=kind, export=export, joints=joints, assumed=tuple(assumed)))
        return
    if export is not None:
        screen.print(f"{kind} compensator written to {output}; what it leaves is stated in the file")
    elif output is not None:
        screen.print(f"{len(joints)} commands written to {output}")
    else:
        for row in joints:
            screen.print("  ".join(f"{v:12.6f}" for v in row))
    for words in assumed:
        screen.print(f"  {escaped(words)}")


def _feed_forward(result: Path, trajectory: Path, output: Path | None, as_json: bool) -> None:
    """Command a trajectory, and print or write it."""
    from deltacal_gen.app import commands
    from deltacal_gen.results.written import FedForward

    told: list[str] = []
    done = commands.feed_forward(result, trajectory, output, tell=told.append)
    if as_json:
        found = done.columns_of_file()
        joints, torques = done.joints_in_files, done.torque
        print_json(FedForward(columns=tuple(found), joints=joints, torques=torques, units=done.units, told=tuple(told)))
        return
    if output is None:
        for time, q, tau in zip(done.given.time, done.joints_in_files, done.torque, strict=True):
            screen.print("  ".join(f"{v:12.6f}" for v in (time, *q, *tau)))
    else:
        screen.print(f"{len(done.torque)} samples with joints and torques written to {output}")
    for words in told:
        screen.print(f"  {escaped(words)}")


def _show_lines(lines: FirmwareLines, output: Path, told: list[str]) -> None:
    """Print a firmware's numbers as they are and as they are to be, and what either leave."""
    table = Table(lines.kind, "in the file now", "new", "unit")
    for v in lines.values:
        table.add_row(v.name, f"{v.before:.4f}", f"{v.after:.4f}", v.unit)
    table.add_section()
    shown = [("error on the bed", "bed"), ("lateral error", "lateral")]
    for name, key in shown[: 1 if lines.heights_alone else 2]:
        for figure in ("rms", "worst"):
            now, new = (getattr(left, f"{key}_{figure}_mm") for left in (lines.before, lines.after))
            table.add_row(f"{name}, {figure}", decimals(now), decimals(new), "mm")
    screen.print(table)
    least = "least over the bed" if lines.heights_alone else "least over bed and volume"
    how = "a fit of the firmware's own numbers to the readings" if lines.by_readings else least
    where = "the printed bed" if lines.heights_alone else "the printed volume"
    screen.print(f"errors are those of the calibrated machine over {where}; the lines are {how}")
    if lines.heights_alone:
        screen.print("heights alone do not say how far prints are off across the bed: identify says what to measure")
    if lines.not_carried:
        names = ", ".join(note.partition(" = ")[0] for note in lines.not_carried)
        screen.print(f"not carried by the lines, with their sizes in the file: {escaped(names)}")
    for words in told:
        screen.print(f"  {escaped(words)}")
    screen.print(f"{lines.kind} lines written to {output}")


def predict(
    result: ResultFile,
    recording: RecordingFile,
    output: Annotated[Path, output_file("PREDICTED.csv")],
    place: Annotated[
        Path | None,
        typer.Option(metavar="OTHER", help="readings of the same set-up at other poses (CSV)", show_default=False),
    ] = None,
    bands: Annotated[
        bool, typer.Option("--bands", help="beside each value between which ends it lies with 95 % probability")
    ] = False,
    decimal: Decimal = None,
    as_json: Json = False,
) -> None:
    """Predict the readings of other joints, in the instrument's frame."""
    from deltacal_gen.app import commands
    from deltacal_gen.machine.values import Recording
    from deltacal_gen.results.written import Predicted
    from deltacal_gen.use.prediction import CORRECTED

    told: list[str] = []
    done = commands.predict(result, recording, output, place=place, bands=bands, tell=told.append)
    if not isinstance(done, Recording):
        said = f"samples predicted in {output}; at rest, where friction is not known, they are blank"
        if as_json:
            kind = done.said.measurement.kind
            print_json(Predicted(file=str(output), kind=kind, readings=done.n_rows, told=tuple(told)))
        else:
            screen.print(f"{done.n_rows} {said}")
            for words in told:
                screen.print(escaped(words))
        return
    rows = done.n_rows if done.pairs is None else len(done.pairs)
    if as_json:
        print_json(Predicted(file=str(output), kind=done.kind, readings=rows, told=tuple(told)))
    else:
        screen.print(f"{rows} readings of the kind {done.kind} predicted in {output}")
        for words in told:
            screen.print(escaped(words))
        share = done.channels.get(CORRECTED)
        if share is not None and (share < 1).any():
            screen.print(
                f"{(share < 1).sum()} of {len(share)} rows lie outside what was measured for the smooth correction; it "
                f"fades there and at {(share == 0).sum()} of them nothing is corrected (column {CORRECTED})"
            )


def validate(
    result: ResultFile,
    recording: RecordingFile,
    report: Annotated[Path | None, typer.Option(help="a page to read, .html", show_default=False)] = None,
    decimal: Decimal = None,
    as_json: Json = False,
) -> None:
    """Hold a calibrated model against readings that it has not seen."""
    from deltacal_gen.app import commands

    found = commands.validate(result, recording, report)
    if as_json:
        print_json(found)
        return
    show_any(found, _show_validation)


def _show_validation(found: Validation) -> None:
    """Print the error against the noise, and what is said of it."""
    for words in (found.headline, *found.told):
        screen.print(escaped(words))
    if (iso := found.iso9283) is not None:
        screen.print(
            f"ISO 9283, {iso.poses} poses: accuracy AP {decimals(iso.AP_mean_mm)} mm (largest "
            f"{decimals(iso.AP_max_mm)}), repeatability RP {decimals(iso.RP_mean_mm)} mm "
            f"(largest {decimals(iso.RP_max_mm)})"
        )
    if (axis := found.iso230) is not None:
        screen.print(
            f"ISO 230-2, {axis.poses} positions from both sides, mm: accuracy A {decimals(axis.A_mm)}, "
            f"systematic E {decimals(axis.E_mm)}, repeatability R {decimals(axis.R_mm)}, reversal B "
            f"{decimals(axis.B_mm)}, mean M {decimals(axis.M_mm)}"
        )


def certificate(
    result: ResultFile,
    recording: Annotated[
        Path, typer.Argument(metavar="VALIDATION", help="readings that the fit has not seen (CSV)", show_default=False)
    ],
    output: Annotated[Path, output_file("CERTIFICATE.html; beside it CERTIFICATE.xml, the digital one")],
    about: Annotated[
        Path | None,
        typer.Option(metavar="ABOUT.toml", help="laboratory, customer, serial number, dates", show_default=False),
    ] = None,
    decimal: Decimal = None,
    as_json: Json = False,
) -> None:
    """Certify a calibrated machine: errors before and after, uncertainty budget, ISO 9283, hashes; A4 and DCC."""
    from deltacal_gen.app import commands

    found = commands.certificate(result, recording, output, about=about)
    if as_json:
        print_json(found)
        return
    unit, length = shown_in(found)
    table = Table("contribution", "type", unit, "share")
    for c in found.budget.contributions:
        table.add_row(c.source, c.evaluation, decimals(c.sigma_mm / length), f"{c.share:.1%}")
    screen.print(escaped(found.headline))
    screen.print(table)
    screen.print(f"{found.budget.within:.0%} of what was read lies within U")
    screen.print(f"{output} and {output.with_suffix('.xml').name} written")


def compare(
    before: Annotated[Path, typer.Argument(metavar="RESULT_A", help="RESULT.json of the earlier session")],
    after: Annotated[Path, typer.Argument(metavar="RESULT_B", help="RESULT.json of the later session")],
    output: Annotated[Path | None, output_file("COMPARISON.json")] = None,
    as_json: Json = False,
) -> None:
    """Say what changed between two sessions of one machine, by parameter, and what did not."""
    from deltacal_gen.app import commands

    found = commands.compare(before, after, output)
    if as_json:
        print_json(found)
        return
    screen.print(escaped(found.summary))
    changed, unchanged = found.changed, found.unchanged
    if found.combinations_changed is not None:
        changed, unchanged = found.combinations_changed, found.combinations_unchanged or ()
    table = Table("changed", "before", "after", "change", "std", "unit")
    for e in changed:
        table.add_row(e.name, *map(number, (e.before, e.after, e.change, e.std)), e.unit)
    if changed:
        screen.print(table)
    for words, names in (
        ("unchanged", [e.name for e in unchanged if " " not in e.name]),
        ("not known one by one", [e.name for e in found.unknown]),
    ):
        if names:
            rest = f" and {len(names) - MOST_NAMES} more" if len(names) > MOST_NAMES else ""
            screen.print(f"{words}: {', '.join(names[:MOST_NAMES])}{rest}", style="dim")
