"""What a calibrated machine is good for: commands, predictions, a check, a comparison of two sessions."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from deltacal_gen.app.cli.common import (
    Decimal,
    Json,
    RecordingFile,
    ResultFile,
    escaped,
    output_file,
    print_json,
    screen,
    show,
)
from deltacal_gen.errors import UsageError
from deltacal_gen.use import exporters

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
        typer.Option(
            help=f"for a controller, in place of commands: {', '.join(exporters.names())}", show_default=False
        ),
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
    if export is not None:
        _export(result, export, output, kind, worst, as_json)
        return
    from deltacal_gen.app import commands
    from deltacal_gen.results.written import Joints

    assumed: list[str] = []
    joints = commands.compensate(result, targets, output, kind=kind, bands=bands, tell=assumed.append)
    found = Joints(kind=kind, export=None, joints=joints, assumed=tuple(assumed))
    if as_json:
        print_json(found)
        return
    if output is not None:
        screen.print(f"{len(joints)} commands written to {output}")
    else:
        for row in joints:
            screen.print("  ".join(f"{v:12.6f}" for v in row))
    show(found)


def _export(result: Path, export: str, output: Path | None, kind: str, worst: float, as_json: bool) -> None:
    """Export the compensator, and print what is said of it."""
    import numpy as np

    from deltacal_gen.app import commands
    from deltacal_gen.results.written import Joints

    told: list[str] = []
    lines = commands.export_compensator(result, export, output, kind=kind, worst_mm=worst, tell=told.append)
    found = Joints(kind=kind, export=export, joints=np.zeros((0, 3)), assumed=tuple(told), firmware=lines)
    if as_json:
        print_json(found)
        return
    show(found)
    screen.print(f"export {export} written to {output}; the errors that it leaves are stated in the file")


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
    show(found)


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
    show(found)
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
    show(found)
