"""What is derived and registered: kernels, models, effects, the reports and claims that stand behind them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer
from rich.table import Table

from deltacal_gen.app.cli.common import Json, escaped, print_json, progress, screen
from deltacal_gen.results.registered import STATUSES, ClaimEntry


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


def derivation(
    output: Annotated[Path, typer.Option("-o", "--output", help="FILE.html or FILE.md; a folder with --all")],
    model: Annotated[
        str | None, typer.Argument(metavar="MODEL", help="e.g. delta/42, backlash or distance", show_default=False)
    ] = None,
    every: Annotated[bool, typer.Option("--all", help="all models, effects and measurements, with an index")] = False,
    as_json: Json = False,
) -> None:
    """Write the report for reviewers: every equation, its source, its checks (from a source checkout)."""
    from deltacal_gen.app import commands

    with progress(as_json) as tell:
        found = commands.derivation(model, output, every=every, progress=tell)
    if as_json:
        print_json(found)
    else:
        screen.print(f"{len(found.files)} file{'s' if len(found.files) > 1 else ''}; open {found.files[0]}")


def reproduce(
    paper: Annotated[str, typer.Argument(metavar="PAPER", help="bai, mei, savoure or traslosheros")],
    output: Annotated[Path, typer.Option("-o", "--output", metavar="DIR", help="folder for PAPER.html")],
    as_json: Json = False,
) -> None:
    """Remake a paper's tables and figures beside the printed ones, with the verdicts (from a source checkout)."""
    from deltacal_gen.app import commands

    with progress(as_json) as tell:
        found = commands.reproduce(paper, output, progress=tell)
    if as_json:
        print_json(found)
    else:
        screen.print(f"{len(found.remade)} tables and figures remade; open {found.files[0]}")


def models(as_json: Json = False) -> None:
    """List the mechanisms, their models and their parameters."""
    from deltacal_gen.app import commands

    found = commands.models()
    if as_json:
        print_json(found)
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


def effects(as_json: Json = False) -> None:
    """List the effects that a diagnosis knows, with their parameters."""
    from deltacal_gen.app import commands

    found = commands.effects()
    if as_json:
        print_json(found)
        return
    table = Table("effect", "what it is", "parameters")
    for e in found:
        parameters = ", ".join(f"{p.name} [{p.unit}]" for p in e.parameters)
        table.add_row(e.effect, e.title, escaped(parameters))
    screen.print(table)


def claims(
    paper: Annotated[str | None, typer.Option(help="one paper only, e.g. bai", show_default=False)] = None,
    status: Annotated[str | None, typer.Option(help="one status only, e.g. contradicted", show_default=False)] = None,
    search: Annotated[str | None, typer.Option(help="only those with these words", show_default=False)] = None,
    output: Annotated[
        Path | None, typer.Option("-o", "--output", metavar="FILE.html", help="a page that can be searched")
    ] = None,
    as_json: Json = False,
) -> None:
    """Show what the papers claim, what the derivation gives, the test that decides (from a source checkout)."""
    from deltacal_gen.app import commands

    found = commands.claims(paper=paper, status=status, search=search, output=output)
    if as_json:
        print_json(found)
        return
    papers = {name: [c for c in found if c.paper == name] for name in dict.fromkeys(c.paper for c in found)}
    for entries in papers.values() if output is None else ():
        screen.print(f"[bold]{escaped(entries[0].title)}[/bold]\n")
        for c in entries:
            screen.print(_claim(c))
    if output is not None:
        screen.print(f"{len(found)} claims in {output}")
    counts = Table("status", *papers, box=None, padding=(0, 2))
    for s in STATUSES:
        counts.add_row(s, *(str(sum(c.status == s for c in entries)) for entries in papers.values()))
    counts.add_row("all", *(str(len(entries)) for entries in papers.values()))
    screen.print(counts)


def _claim(c: ClaimEntry) -> Table:
    """Return a claim as a block: where it stands and what became of it, then line by line what is said of it."""
    block = Table.grid(padding=(0, 1))
    block.add_column(no_wrap=True, style="dim")
    block.add_column(overflow="fold")
    block.title, block.title_justify = f"[bold]{c.where}[/bold]  [reverse] {c.status} [/reverse]", "left"
    same = c.printed == c.correct
    lines = {
        "": c.statement,
        "printed": c.printed,
        "correct": "the same" if same else c.correct,
        "evidence": c.evidence,
        "derived": c.decided or "no: typed, and decided by its test",
        "test": c.test,
        "ended": c.ended,
        "measured": "\n".join(c.measured),
    }
    for head, line in lines.items():
        if line:
            block.add_row(head, escaped(line))
    block.add_row("", "")
    return block
