"""What is derived and registered: models, effects, kernels, and the reports and claims for reviewers."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from deltacal_gen.app import checkout
from deltacal_gen.app.commands.common import Progress, Source, check_folder, check_output, silent
from deltacal_gen.errors import OptionNotApplicable, UnknownName

if TYPE_CHECKING:
    from deltacal_gen.results.registered import Claims, Effects, Mechanisms
    from deltacal_gen.results.written import Receipt


def models(name: str | None = None) -> Mechanisms:
    """List the mechanisms, their models and their parameters.

    Parameters
    ----------
    name : str, optional
        Mechanism or model, for example delta or delta/18: its parameters with units and meanings; default all.

    Raises
    ------
    UsageError
        There is none of this name.

    Examples
    --------
    deltacal models delta
    """
    from deltacal_gen.machine.registry import load_mechanism, mechanism_names
    from deltacal_gen.results.registered import Dimension, MechanismEntry, Mechanisms, SourceError
    from deltacal_gen.units import file_unit, to_internal

    wanted = mechanism_names() if name is None else _named(name.partition("/")[0], mechanism_names(), "mechanism")
    return Mechanisms(
        MechanismEntry(
            mechanism=m.name,
            of=m.machine,
            title=m.title,
            reference=m.reference,
            models={name: tuple(names) for name, names in m.models.items()},
            parameters=tuple(
                SourceError(
                    name=p.name, unit=file_unit(p.unit), meaning=p.meaning, typical=p.typical / to_internal(p.unit)
                )
                for p in m.parameters
            ),
            geometry=tuple(
                Dimension(
                    key=g.key, table=g.table, unit=file_unit(g.unit), meaning=g.meaning, required=g.default is None
                )
                for g in m.geometry
            ),
        )
        for m in map(load_mechanism, wanted)
    )


def effects(name: str | None = None) -> Effects:
    """List the physical effects that diagnose knows, with their parameters and units.

    Parameters
    ----------
    name : str, optional
        Effect, for example backlash: meaning of its parameters, what it depends on and what it moves; default all.

    Raises
    ------
    UsageError
        There is none of this name.

    Examples
    --------
    deltacal effects backlash
    """
    from deltacal_gen.physics.terms import drive_effect_names, effect_names, load_effect
    from deltacal_gen.results.registered import EffectEntry, Effects, EffectUnknown

    known = (*effect_names(), *drive_effect_names())
    wanted = known if name is None else _named(name, known, "effect")
    return Effects(
        EffectEntry(
            effect=name,
            title=found.TITLE,
            per_limb=found.PER_LIMB,
            parameters=tuple(
                EffectUnknown(name=n, unit=unit, meaning=meaning, searched=searched)
                for rows, searched in ((found.COEFFICIENTS, False), (found.CONSTANTS, True))
                for n, unit, _, meaning in rows
            ),
            reads=tuple(found.STATE),
            moves=tuple(found.TARGETS),
        )
        for name, found in ((name, load_effect(name)) for name in wanted)
    )


def _named(name: str, known: Sequence[str], what: str) -> tuple[str]:
    """Return the name alone; raises UsageError where it is not known."""
    if name not in known:
        raise UnknownName(f"there is no {what} '{name}'; known: {', '.join(known)}.")
    return (name,)


def claims(
    *, paper: str | None = None, status: str | None = None, search: str | None = None, output: Source | None = None
) -> Claims:
    """List the claims of the papers with their status, the evidence and the deciding test (source checkout only).

    Parameters
    ----------
    paper : str, optional
        Only this paper: bai, mei, savoure or traslosheros.
    status : str, optional
        Only this status, for example contradicted.
    search : str, optional
        Only claims with words that begin with each of these.
    output : path, optional
        Page with a search field (.html).

    Raises
    ------
    UsageError
        There is no such paper or status; or this is no source checkout.

    Examples
    --------
    deltacal claims --paper bai --status contradicted
    """
    from deltacal_gen.results.registered import ClaimEntry, Claims

    check_output(output, ending=(".html",))
    options = {"--paper": paper, "--status": status, "--search": search, "--output": output and Path(output).absolute()}
    given = [f"{option}={value}" for option, value in options.items() if value is not None]
    return Claims(ClaimEntry(**claim) for claim in checkout.run_review("claims", *given))


def reproduce(paper: str, *, output: Source, progress: Progress = silent) -> Receipt:
    """Reproduce the tables and figures of a paper beside the printed ones (source checkout only).

    Parameters
    ----------
    paper : str
        bai, mei, savoure or traslosheros.
    output : path
        Folder for PAPER.html; created if missing.
    progress : callable
        Called with what is being done.

    Raises
    ------
    UsageError
        There is no such paper; or this is no source checkout.
    InputError
        The output is a file.

    Examples
    --------
    deltacal reproduce bai -o reproduced
    """
    from deltacal_gen.results.written import Receipt

    folder = Path(output)
    check_folder(folder)
    done = checkout.run_review("reproduce", paper, "-o", folder.absolute(), progress=progress)
    files = tuple(str(folder / Path(file).name) for file in done["files"])
    remade = tuple(done["remade"])
    summary = f"{len(remade)} tables and figures remade; open {files[0]}"
    return Receipt(command="reproduce", summary=summary, files=files, figures={"remade": remade})


def derivation(model: str | None = None, *, all_: bool = False, output: Source, progress: Progress = silent) -> Receipt:
    """Write the report for reviewers: every equation with its source and its checks (source checkout only).

    Parameters
    ----------
    model : str, optional
        Model (delta/42), mechanism (its largest model), effect (backlash), kind of measurement (distance), or the word
        method.
    all_ : bool
        All models, effects and kinds of measurement, with an index; then -o is a folder.
    output : path
        FILE.html, or FILE.md with its pictures beside it.
    progress : callable
        Called with what is being done.

    Raises
    ------
    UsageError
        No such model; or this is no source checkout, or SymPy is not installed.

    Examples
    --------
    deltacal derivation delta/42 -o delta.html
    """
    from deltacal_gen.results.written import Receipt

    if (model is None) != all_:
        raise OptionNotApplicable("give a model, a mechanism, an effect or a measurement, or else --all.")
    target = Path(output)
    if model is not None:
        check_output(output, ending=(".html", ".md"))
    else:
        check_folder(target)
    chosen = () if model is None else (model,)
    task = ("derivation", *chosen, "-o", target.absolute())
    written = checkout.run_review(*task, deriving=True, progress=progress)
    files = tuple(str((target if all_ else target.parent) / Path(file).name) for file in written)
    summary = f"{len(files)} file{'s' if len(files) > 1 else ''}; open {files[0]}"
    return Receipt(command="derivation", summary=summary, files=files)


def kernels(
    names: Sequence[str] = (),
    *,
    check: bool = False,
    warm: bool = False,
    try_: Source | None = None,
    output: Source | None = None,
    progress: Progress = silent,
) -> Receipt:
    """Derive the models and generate the kernel package (source checkout only), or compile it ahead of time.

    Parameters
    ----------
    names : sequence of str
        Mechanisms, effects or kinds of measurement to derive; default all.
    check : bool
        Write nothing; exit with 1 if the committed kernels differ.
    warm : bool
        Derive nothing; compile all kernels now, so that later commands start faster.
    try_ : path, optional
        Robot file (TOML) of a newly derived machine to try: 100 poses forward and inverse, what each kind of
        measurement can identify, and a drawing from its equations.
    output : path, optional
        Drawing of --try (.svg); default MECHANISM.svg.
    progress : callable
        Called with what is being done.

    Raises
    ------
    InputError
        The robot file cannot be used.
    UsageError
        This is no source checkout, or SymPy is not installed.

    Examples
    --------
    deltacal kernels delta --check
    """
    from deltacal_gen.results.written import Receipt

    if warm:
        seconds = _compiled(progress)
        each = "\n".join(f"{spent:7.2f} s  {name}" for name, spent in seconds.items())
        return Receipt(command="kernels", summary=each, figures={f"{name}_s": spent for name, spent in seconds.items()})
    done = checkout.run_derivation(*names, *(["--check"] if check else []))
    return Receipt(command="kernels", summary=trial(try_, output) if done and try_ is not None else "", done=done)


def trial(robot: Source, output: Source | None = None) -> str:
    """Return in words how a machine does whose kernels were just derived, and draw it from its own equations."""
    check_output(output, robot, ending=(".svg",))
    task = ("trial", Path(robot).absolute(), "-o", Path(output or "").absolute())
    answer: str = checkout.run_review(*task, deriving=True)
    return answer.replace(f"{Path().absolute()}{os.sep}", "")


def _compiled(progress: Progress) -> dict[str, float]:
    """Compile modules to byte code, and the kernels of all mechanisms, ahead; return the seconds of each."""
    import compileall
    import time
    from importlib.util import find_spec

    from deltacal_gen.machine.backend import compile_row_functions
    from deltacal_gen.machine.registry import load_mechanism, mechanism_names

    spent: dict[str, float] = {}
    for package in ("deltacal_gen", "deltacal_kernels"):
        progress(package)
        start, found = time.perf_counter(), find_spec(package)
        if found is not None and found.origin is not None:
            compileall.compile_dir(Path(found.origin).parent, quiet=2)  # a folder that cannot be written stays as it is
        spent[package] = time.perf_counter() - start
    for kernels in (*(load_mechanism(name).compile() for name in mechanism_names()), compile_row_functions()):
        for kernel, seconds in kernels:
            progress(kernel)
            spent[kernel] = seconds
    return spent
