"""Where recordings come from, beside an instrument's own files: firmware, trackers."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Annotated, Any

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


FILES = {
    "klipper": "printer.cfg",
    "rrf": "config.g and heightmap.csv",
    "marlin": "what M503 and G33 or G29 printed",
    "points": "the instrument's points and a table of joints; a robot.toml, if there is one",
    "bag": "the bag; a robot.toml, if there is one",
    "c3d": "the capture and a table of joints in time; a robot.toml, if there is one",
    "urdf": "the URDF of an arm",
}


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
    from deltacal_gen.app import commands
    from deltacal_gen.results.written import Imported

    in_time = {"readings": readings, "moving": moving, "offset_s": offset}
    importers: dict[str, tuple[Callable[..., Any], tuple[int, ...], dict[str, Any]]] = {
        "klipper": (commands.import_klipper, (1,), {}),
        "rrf": (commands.import_rrf, (2,), {}),
        "marlin": (commands.import_marlin, (1,), {}),
        "points": (commands.import_points, (2, 3), {}),
        "bag": (commands.import_bag, (1, 2), {"joints": joints, "mapping": mapping, **in_time}),
        "c3d": (commands.import_c3d, (2, 3), in_time),
        "urdf": (commands.import_urdf, (1,), {"base": base, "tip": tip}),
    }
    if kind not in importers:
        raise typer.BadParameter(f"there is no import '{kind}'; known: {', '.join(importers)}", param_hint="KIND")
    read, counts, options = importers[kind]
    if len(files) not in counts:
        raise typer.BadParameter(
            f"{kind} takes {' or '.join(map(str, counts))} file{'s' if counts[-1] > 1 else ''}: {FILES[kind]}",
            param_hint="FILE",
        )
    given = {"--joints": joints, "--map": mapping, "--readings": readings, "--moving": moving, "--offset": offset}
    keys = ("joints", "mapping", "readings", "moving", "offset_s", "base", "tip")
    for (name, value), key in zip((given | {"--base": base, "--tip": tip}).items(), keys, strict=True):
        if value and key not in options:
            raise typer.BadParameter(f"it means nothing for {kind}; leave it out", param_hint=name)
    found = read(*files, output=output, **options)
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
