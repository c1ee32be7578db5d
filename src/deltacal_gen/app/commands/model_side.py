"""What is derived and registered: kernels, models, effects, the reports and claims that stand behind them."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path

from deltacal_gen.app import checkout
from deltacal_gen.app.commands.common import Progress, Source, check_output, silent
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.machine.backend import compile_row_functions
from deltacal_gen.machine.registry import load_mechanism, mechanism_names
from deltacal_gen.results.registered import (
    ClaimEntry,
    Dimension,
    EffectEntry,
    EffectUnknown,
    MechanismEntry,
    SourceError,
)
from deltacal_gen.results.written import Derivation, Reproduction
from deltacal_gen.units import file_unit, to_internal


def models() -> list[MechanismEntry]:
    """Return what is registered: every mechanism with its parameters, units and models."""
    return [
        MechanismEntry(
            mechanism=m.name,
            of=m.machine,
            title=m.title,
            reference=m.reference,
            models={name: tuple(names) for name, names in m.models.items()},
            parameters=tuple(
                SourceError(
                    name=p.name,
                    unit=file_unit(p.unit),
                    meaning=p.meaning,
                    typical=p.typical / to_internal(p.unit),
                )
                for p in m.parameters
            ),
            geometry=tuple(
                Dimension(
                    key=g.key,
                    table=g.table,
                    unit=file_unit(g.unit),
                    meaning=g.meaning,
                    required=g.default is None,
                )
                for g in m.geometry
            ),
        )
        for m in map(load_mechanism, mechanism_names())
    ]


def effects() -> list[EffectEntry]:
    """Return the registered effects: what each is, its parameters with units, what it reads and moves."""
    from deltacal_gen.physics.terms import drive_effect_names, effect_names, load_effect

    return [
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
        for name, found in ((name, load_effect(name)) for name in (*effect_names(), *drive_effect_names()))
    ]


def claims(
    *, paper: str | None = None, status: str | None = None, search: str | None = None, output: Source | None = None
) -> list[ClaimEntry]:
    """Return the ledger of claims, or a part of it: what is printed, what is right, the test.

    Parameters
    ----------
    paper, status : str
        Those of one paper, of one status.
    search : str
        Those in which each of these words begins a word.
    output : path
        Where to write them as a page that can be searched (``.html``), too.

    Raises
    ------
    UsageError
        There is no such paper or status.
    """
    check_output(output, ending=(".html",))
    options = {"--paper": paper, "--status": status, "--search": search, "--output": output and Path(output).absolute()}
    given = [f"{option}={value}" for option, value in options.items() if value is not None]
    return [ClaimEntry(**claim) for claim in checkout.run_review("claims", *given)]


def reproduce(paper: str, output: Source, *, progress: Progress = silent) -> Reproduction:
    """Remake the tables and figures of a paper beside the printed ones, with the verdict on each, on one page.

    Parameters
    ----------
    paper : str
        As the ledger of claims calls it: ``bai``, ``mei``, ``savoure`` or ``traslosheros``.
    output : path
        Folder for ``PAPER.html``; made where there is none.

    Raises
    ------
    UsageError
        There is no such paper.
    InputError
        The output is a file.
    """
    folder = Path(output)
    if folder.exists() and not folder.is_dir():
        raise InputError("this is a file, and the page needs a folder.", "Choose another name.", file=folder)
    done = checkout.run_review("reproduce", paper, "-o", folder.absolute(), progress=progress)
    files = tuple(str(folder / Path(file).name) for file in done["files"])
    return Reproduction(files=files, remade=tuple(done["remade"]))


def derivation(model: str | None, output: Source, *, every: bool = False, progress: Progress = silent) -> Derivation:
    """Write the report of a derivation for reviewers; return what was written.

    Parameters
    ----------
    model : str
        A model (``delta/42``), a mechanism (its largest model), an effect (``backlash``), a kind of measurement
        (``distance``) or ``method``.
    output : path
        ``.html`` or ``.md``, whose pictures are written beside it; with `every` a folder for all reports in HTML and
        an index.
    every : bool
        All models of all mechanisms, all effects and all kinds of measurement.

    Raises
    ------
    UsageError
        No such model; or this is no source checkout, or SymPy is not installed.
    """
    if (model is None) != every:
        raise UsageError("give a model, a mechanism, an effect or a measurement, or else --all.")
    target = Path(output)
    if model is not None:
        check_output(output, ending=(".html", ".md"))
    elif target.exists() and not target.is_dir():
        raise InputError("this is a file, and the reports need a folder.", "Choose another name.", file=target)
    chosen = () if model is None else (model,)
    task = ("derivation", *chosen, "-o", target.absolute())
    files = checkout.run_review(*task, deriving=True, progress=progress)
    folder = target if every else target.parent
    return Derivation(files=tuple(str(folder / Path(file).name) for file in files))


def kernels(names: Sequence[str] = (), *, check: bool = False) -> bool:
    """Derive kernels and write them, or with `check` compare them; return whether it went well.

    Parameters
    ----------
    names : sequence of str
        Of mechanisms, effects or measurements; default all.

    The derivation runs in a process of its own: nothing at run time imports SymPy.

    Raises
    ------
    UsageError
        This is no source checkout, or SymPy is not installed.
    """
    return checkout.run_derivation(*names, *(["--check"] if check else []))


def trial(robot: Source, output: Source | None = None) -> str:
    """Return in words how a machine does whose kernels were just derived, and draw it from its own equations.

    Parameters
    ----------
    output : path
        The drawing (``.svg``); default named after the mechanism.

    Raises
    ------
    InputError
        The robot file cannot be used.
    UsageError
        This is no source checkout, or SymPy is not installed.
    """
    check_output(output, robot, ending=(".svg",))
    task = ("trial", Path(robot).absolute(), "-o", Path(output or "").absolute())
    answer: str = checkout.run_review(*task, deriving=True)
    return answer.replace(f"{Path().absolute()}{os.sep}", "")


def warm(progress: Callable[[str, float], None] = lambda name, seconds: None) -> dict[str, float]:
    """Compile modules to byte code and the kernels of all mechanisms ahead; return and tell the seconds of each."""
    import compileall
    import importlib.util
    import time

    spent: dict[str, float] = {}
    for package in ("deltacal_gen", "deltacal_kernels"):
        start, found = time.perf_counter(), importlib.util.find_spec(package)
        if found is not None and found.origin is not None:
            compileall.compile_dir(Path(found.origin).parent, quiet=2)  # a folder that cannot be written stays as it is
        spent[package] = time.perf_counter() - start
        progress(package, spent[package])
    for name in mechanism_names():
        for kernel, seconds in load_mechanism(name).compile():
            spent[kernel] = seconds
            progress(kernel, seconds)
    for kernel, seconds in compile_row_functions():
        spent[kernel] = seconds
        progress(kernel, seconds)
    return spent
