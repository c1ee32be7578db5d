"""Where recordings come from, beside an instrument's own files: firmware, trackers."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from deltacal_gen.app.cli.common import Decimal, Json, aside, escaped, print_json, screen

Sources = Annotated[
    list[Path],
    typer.Argument(
        metavar="FILE...",
        help="printer.cfg; config.g and heightmap.csv; a log of Marlin; points, joints, ROBOT.toml; a bag, "
        "ROBOT.toml; a capture, joints, ROBOT.toml; a URDF",
    ),
]


OPTIONS = {"mapping": "--map", "offset_s": "--offset"}  # of importers, where they are not called as their parameters


def import_(
    kind: Annotated[str, typer.Argument(metavar="KIND", help="klipper, rrf, marlin, points, bag, c3d or urdf")],
    files: Sources,
    output: Annotated[Path, typer.Option("-o", "--output", help="folder for robot.toml and recordings")],
    joints: Annotated[str | None, typer.Option("--joints", help="of a bag: the topic of the joints")] = None,
    readings: Annotated[
        str | None, typer.Option("--readings", help="of a bag: the topic; of a capture: the marker or body")
    ] = None,
    mapping: Annotated[
        Path | None, typer.Option("--map", metavar="MAP.toml", help="of a bag: which parts of which messages")
    ] = None,
    moving: Annotated[bool, typer.Option("--moving", help="a row for every reading, not for every standstill")] = False,
    offset: Annotated[float, typer.Option("--offset", help="what is added to the readings' clock, s")] = 0.0,
    base: Annotated[str | None, typer.Option("--base", metavar="LINK", help="of a URDF: where {O} is")] = None,
    tip: Annotated[str | None, typer.Option("--tip", metavar="LINK", help="of a URDF: where the arm ends")] = None,
    decimal: Decimal = None,
    as_json: Json = False,
) -> None:
    """Make recordings, and a robot file, from what firmware, a tracker's software, ROS or motion capture keeps.

    A URDF gives a robot file alone.
    """
    from deltacal_gen.files.importers import importer
    from deltacal_gen.results.written import Imported

    how = importer(kind)
    if not how.needed <= len(files) <= len(how.files):
        counts = " or ".join(str(n) for n in range(how.needed, len(how.files) + 1))
        raise typer.BadParameter(
            f"{kind} takes {counts} file{'s' if len(how.files) > 1 else ''}: {', '.join(how.files)}. It does this: "
            f"{how.summary}",
            param_hint="FILE",
        )
    given = {"joints": joints, "readings": readings, "mapping": mapping, "moving": moving, "offset_s": offset}
    options = {name: value for name, value in (given | {"base": base, "tip": tip}).items() if value}
    for name in options:
        if name not in how.options:
            hint = OPTIONS.get(name, f"--{name}")
            raise typer.BadParameter(f"it means nothing for {kind}; leave it out", param_hint=hint)
    found = how.read(*files, output=output, **options)
    names = [f"{name}.csv" for name in found.recordings]
    if as_json:
        print_json(
            Imported(
                folder=str(output),
                robot="robot.toml" if found.robot is not None else None,
                recordings=tuple(names),
                warnings=tuple(found.warnings),
            )
        )
        return
    for warning in found.warnings:
        aside.print(escaped(f"warning: {warning}"))
    written = [*(["robot.toml"] if found.robot is not None else []), *names]
    screen.print(f"{', '.join(written)} written to {output}")
