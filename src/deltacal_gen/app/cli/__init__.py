"""The ``deltacal`` command: arguments in, tables and exit codes out; no computation lives here.

Exit codes: 0 done; 1 done, and the answer is no; 2 usage; 3 bad input; 4 no convergence or no solution; 70 a fault of
ours; 130 stopped from the keyboard.

A module holds the commands that a reader looks for together; the function behind each is in the module of the same
name in `commands`. `common` is what they share.
"""

from __future__ import annotations

import io
import os
import sys
import traceback
from collections.abc import Callable
from functools import cache, wraps
from pathlib import Path
from typing import Annotated, Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the matrices are small: threads only wait for one another

import typer

from deltacal_gen.app.cli import calibration, common, experiments, guide, many, model_side, sources, use
from deltacal_gen.errors import DeltacalError, UsageError
from deltacal_gen.version import __version__

FAULT = 70  # EX_SOFTWARE of sysexits.h
STOPPED = 130  # by SIGINT, as shells say it
TRACEBACK = "DELTACAL_TRACEBACK"  # environment variable: faults are shown in full

app = typer.Typer(
    name="deltacal",
    help="Calibrate parallel robots with models that are derived, not typed.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    context_settings={"help_option_names": ["-h", "--help"]},
)
_COMMANDS: dict[str, Callable[..., None]] = {  # in the order of the help
    "demo": guide.demo,
    "kernels": model_side.kernels,
    "derivation": model_side.derivation,
    "models": model_side.models,
    "claims": model_side.claims,
    "reproduce": model_side.reproduce,
    "plan": experiments.plan,
    "simulate": experiments.simulate,
    "identify": calibration.identify,
    "diagnose": calibration.diagnose,
    "next": experiments.next_,
    "effects": model_side.effects,
    "matrix": calibration.matrix,
    "compensate": use.compensate,
    "predict": use.predict,
    "validate": use.validate,
    "certificate": use.certificate,
    "compare": use.compare,
    "import": sources.import_,
    "study": many.study,
    "batch": many.batch,
    "manual": guide.manual,
}


def _one_output(command: Callable[..., None]) -> Callable[..., None]:
    """Return a command that refuses to print its JSON and a file to one standard output, which no script could part."""

    @wraps(command)
    def run(**given: Any) -> None:
        if given.get("as_json"):
            from deltacal_gen.files.writing import is_standard_output

            if any(isinstance(value, Path) and is_standard_output(value) for value in given.values()):
                raise UsageError("--json and a file would both go to the standard output; leave one of them out.")
        command(**given)

    return run


for _name, _command in _COMMANDS.items():
    app.command(_name)(_one_output(_command))


def _version(asked: bool) -> None:
    if asked:
        common.screen.print(f"deltacal {__version__}")
        raise typer.Exit


@app.callback()
def _options(
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="Say which version this is and exit.")
    ] = False,
) -> None:
    """Calibrate parallel robots with models that are derived, not typed."""


def main() -> None:
    """Run the command line; an explained error ends with its own exit code and no traceback."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # a letter that the screen's code page has not is no fault
    try:
        _tree()()
    except DeltacalError as error:
        common.aside.print(f"[bold red]error:[/bold red] {common.escaped(str(error))}", soft_wrap=True)
        sys.exit(error.exit_code)
    except KeyboardInterrupt:
        sys.exit(STOPPED)
    except Exception as error:
        if os.environ.get(TRACEBACK):
            traceback.print_exception(error)
        common.aside.print(f"[bold red]fault:[/bold red] {common.escaped(_fault(error))}", soft_wrap=True)
        sys.exit(FAULT)


@cache
def _tree() -> Any:
    """Return all commands with their options, made once for a program that runs several."""
    return typer.main.get_command(app)


def _fault(error: Exception) -> str:
    """Return the line by which a fault of ours is reported: what happened, and where in this package."""
    frames = traceback.extract_tb(error.__traceback__)
    ours = [f for f in frames if "deltacal_" in f.filename] or frames
    package, _, place = ours[-1].filename.replace(os.sep, "/").rpartition("deltacal_")
    said = " ".join(traceback.format_exception_only(error)[-1].split())
    return (
        f"this is a mistake of deltacal, not of yours; nothing half was written. Please report this line, and the "
        f"command with its files if you may: {said} ({'deltacal_' if package else ''}{place}:{ours[-1].lineno}, "
        f"deltacal {__version__}, Python {sys.version.partition(' ')[0]}; {TRACEBACK}=1 shows all)."
    )
