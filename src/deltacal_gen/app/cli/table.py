"""Which commands there are, in the order of the help, and what each does beyond calling its function."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from deltacal_gen.app.cli import receipts

Given = Mapping[str, Any]  # what the command line gave, by the names of parameters


@dataclass(frozen=True)
class Command:
    """A command, and the function of the package that does it.

    Attributes
    ----------
    functions : tuple of str
        Functions of the package, none where these are those of commands below it.
    choose : callable, optional
        Names the one of several functions that does what was given.
    choosers : tuple of str
        Options by which it chooses; the function itself need not take these.
    flags : mapping of str to str
        What the command line alone takes, with its help: flags that choose, or that decide the exit code.
    needed : tuple of str
        Options that the command line cannot do without.
    draws : bool
        Whether its answer has a picture.
    receipt : callable, optional
        Makes the answer that is printed of what the function returned, where that is no answer itself.
    negative : callable
        Whether an answer is a no, for which the exit code is 1.
    """

    functions: tuple[str, ...]
    choose: Callable[[Given], str] | None = None
    choosers: Sequence[str] = ()
    flags: Mapping[str, str] = field(default_factory=dict)
    needed: Sequence[str] = ()
    draws: bool = False
    receipt: Callable[[Any, Given, tuple[str, ...]], Any] | None = None
    negative: Callable[[Any, Given], bool] = lambda found, given: False


def _planner(given: Given) -> str:
    from deltacal_gen.app.commands.plans import planner

    return planner(given["robot"], given.get("kind"), given.get("model"), given.get("sidecar"))


def _compensator(given: Given) -> str:
    if "export" in given:
        return "export_compensator"
    return "feed_forward" if given.get("trajectory") else "compensate"


def _no_effect(found: Any, given: Given) -> bool:
    """Tell whether a diagnosis is a no: not adequate under --strict, or without the law that was to be written."""
    return bool((given.get("strict") and found.verdict != "adequate") or ("write_effect" in given and not found.laws))


COMMANDS: dict[str, dict[str, Command]] = {  # by their group in the help
    "Start": {
        "demo": Command(("demo",)),
        "manual": Command(("manual",), receipt=receipts.page),
        "explain": Command(("explain",), receipt=receipts.page),
    },
    "Calibrate": {
        "models": Command(("models",)),
        "plan": Command(("plan", "plan_cycles", "plan_trajectory"), _planner, ("kind", "model", "sidecar")),
        "study": Command(("study",), draws=True),
        "simulate": Command(("simulate",), needed=("output",), receipt=receipts.simulated),
        "identify": Command(("identify",), draws=True),
        "matrix": Command(("matrix",), needed=("output",), receipt=receipts.matrix),
    },
    "Diagnose": {
        "diagnose": Command(
            ("diagnose",),
            flags={"strict": "Exit with 1 unless the verdict is adequate (no model error found)."},
            draws=True,
            negative=_no_effect,
        ),
        "next": Command(
            ("next_poses",), needed=("output",), negative=lambda found, given: not (found.poses or found.motion)
        ),
        "effects": Command(("effects",)),
    },
    "Use": {
        "predict": Command(("predict",), needed=("output",), receipt=receipts.predicted),
        "compensate": Command(
            ("compensate", "export_compensator", "feed_forward"),
            _compensator,
            ("export", "trajectory"),
            flags={"trajectory": "TARGETS are samples in time: writes joints and drive torques (kind torque)."},
            receipt=receipts.commanded,
        ),
        "validate": Command(("validate",), draws=True),
        "certificate": Command(("certificate",), needed=("output",)),
        "compare": Command(("compare",), draws=True),
        "batch": Command(("batch",)),
    },
    "Import": {"import": Command(())},
    "Review": {
        "derivation": Command(("derivation",)),
        "claims": Command(("claims",), receipt=receipts.claims),
        "reproduce": Command(("reproduce",)),
        "kernels": Command(("kernels",), negative=lambda found, given: not found.done),
    },
}
RENAMED = {  # options of before, by the command or for all
    "plan": {"--sigma": "--noise"},
    "study": {"--run": "--resume"},
    "identify": {"--solver": "--method"},
    "compensate": {"--kind": "--method", "--worst": "--tolerance"},
    "batch": {"--machine": "--group-by"},
    "import": {"--map": "--mapping"},
}
