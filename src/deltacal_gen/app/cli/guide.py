"""The demonstration and the manual."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer
from rich.table import Table

from deltacal_gen.app.cli.calibration import show_diagnosis
from deltacal_gen.app.cli.common import Json, number, print_json, progress, screen


def demo(
    output: Annotated[Path, typer.Option("-o", "--output", help="folder for the files it makes")] = Path("demo"),
    as_json: Json = False,
) -> None:
    """Run the main job end to end on an embedded recording with a concealed effect."""
    from deltacal_gen.app import commands
    from deltacal_gen.files.robot import robot_of
    from deltacal_gen.machine.places import at

    with progress(as_json) as tell:
        found = commands.demo(output, tell)
    if as_json:
        print_json(found)
        return
    result, diagnosis = found.result, found.diagnosis
    screen.print(
        f"[bold]1. Geometry alone[/bold], {result.model}: {result.readings.scalars} scalar readings, "
        f"held-out error {number(result.heldout_rms_mm)} mm; the instrument's noise is {result.sigma_mm:.4f} mm."
    )
    screen.print("[bold]2. Diagnosis[/bold]:", end=" ")
    show_diagnosis(diagnosis)
    robot = robot_of(diagnosis.robot)
    told = "; ".join(
        f"{t.name}{at(robot, [p.limb] if p.limb else ())}, {p.name} {p.value:g} {p.unit}"
        for t in found.truth
        for p in t.parameters
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
        print_json(Manual(topic=topic or CONTENTS, text=text, files=files))
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
