"""The ``deltacal`` command: functions of the package, with their docstrings as the help.

Exit codes: 0 done; 1 done, and the answer is no; 2 usage; 3 bad input; 4 no convergence or no solution; 70 a fault of
ours; 130 stopped from the keyboard.

`table` says which commands there are, `signatures` what each takes, `application` how it is run and `terminal` what is
seen of it. No computation lives here.
"""

from __future__ import annotations

import io
import os
import sys
import traceback
from typing import NoReturn

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the matrices are small: threads only wait for one another

from cyclopts import CycloptsError

from deltacal_gen.app.cli.application import application
from deltacal_gen.app.cli.table import RENAMED
from deltacal_gen.app.cli.terminal import Terminal
from deltacal_gen.errors import CommandLine, DeltacalError, UsageError
from deltacal_gen.version import __version__

FAULT = 70  # EX_SOFTWARE of sysexits.h
STOPPED = 130  # by SIGINT, as shells say it
TRACEBACK = "DELTACAL_TRACEBACK"  # environment variable: faults are shown in full


def main() -> NoReturn:
    """Run the command line; an explained error ends with its own exit code and no traceback."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # a letter that the screen's code page has not is no fault
    sys.exit(_code(sys.argv[1:]))


def _code(words: list[str]) -> int:
    """Run the words of a command line; return the exit code."""
    if words[:1] == ["help"]:
        words = [*words[1:], "--help"]
    terminal = Terminal(as_json="--json" in words)
    try:
        code = application(words)(words or ["--help"], exit_on_error=False, print_error=False)
        return (code or 0) if words else UsageError.exit_code
    except CycloptsError as error:
        return terminal.fail(CommandLine(_misused(error, words)))
    except DeltacalError as error:
        return terminal.fail(error)
    except KeyboardInterrupt:
        return STOPPED
    except Exception as error:
        if os.environ.get(TRACEBACK) or "--verbose" in words:
            traceback.print_exception(error)
        terminal.warn(_fault(error), "fault")
        return FAULT


def _misused(error: CycloptsError, words: list[str]) -> str:
    """Return in words what is wrong with a command line, and where the help is."""
    command = words[0] if words and not words[0].startswith("-") else ""
    renamed = RENAMED.get(command, {})
    if old := next((word for word in words if word in renamed), None):
        return f"{old} of {command} is now called {renamed[old]}."
    return f"{' '.join(str(error).split())} See: deltacal {command} --help"


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
