"""What 30 % more or less of a constant does: ``python -m tests.benchmarks.thirty FOLDER [FOLDER ...]``.

A folder holds ``robot.toml`` and ``recording.csv``. Each is diagnosed as it is, and once with every constant that
steers what is called noise, found, proven or corrected, times 0.7 and times 1.3; a number of things by one at least. A
line is printed for each that changes the verdict or what is named, or moves the RMS of held-out readings by more than
2 %. Diagnoses are done as `sitting` says.
"""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from importlib import import_module
from inspect import getsource
from pathlib import Path
from typing import Any

import numpy as np

import deltacal_gen as dc
from deltacal_gen.errors import DeltacalError
from deltacal_gen.machine.registry import mechanism_of
from tests.benchmarks.sitting import Entry, add_options, sit

STEERING = {
    "estimation.residuals": ("HUBER", "MOST_GROSS", "MOST_APART", "APART", "FEWEST_APART", "GROSS"),
    "estimation.turns": ("TURNED",),
    "estimation.directions": ("CHANCE", "FEWEST"),
    "estimation.series": ("LONGEST", "OWN_PRICE", "TWICE", "STILL"),
    "estimation.saddles": ("SEEN", "ASIDE", "LINEAR", "LOOKS", "FORESEEN", "SURE"),
    "estimation.system": ("STRONG",),
    "estimation.fit": ("CONVERGED", "ESTIMATED_AT", "OPPOSITE"),
    "inference.least_squares": ("SHRINK", "GOOD", "FLAT", "LONGEST", "KEPT", "STALL", "SLOW"),
    "physics.following": ("STEP",),
    "identification.mistakes": ("NEARER", "EXPLAINED", "AS_NEAR"),
    "identification.outliers": ("MOST_TRIED",),
    "identification.noise": ("PROVEN", "MISTAKEN", "LEAST_EXCESS"),
    "identification.repeats": ("ENOUGH", "MOST_TAKEN", "FEW_LEVELS", "ALIKE"),
    "identification.rounding": ("TOLD", "FEWEST"),
    "identification.together": ("PROVEN", "PRICE", "MANY"),
    "identification.drawing": ("ANOTHER", "PROMISED", "WIDER", "ABOVE_NOISE", "ABOVE_SIZE"),
    "identification.folds": ("FOLDS",),
    "identification.functions": ("PROVEN", "SAME_NOISE"),
    "diagnosis.conclusion": ("SHORT",),
    "diagnosis.diagnosis": ("MACHINED", "MOST_POSES"),
    "diagnosis.evidence": ("FAR", "SHORT", "MOST_WRONG"),
    "diagnosis.findings": ("AMBIGUOUS",),
    "diagnosis.refits": ("ROOM", "COMPARED"),
    "diagnosis.strategy": ("ALIKE", "HARDLY_ALIKE", "BORNE_OUT", "TURNS", "SETTLED", "REVISIONS"),
    "diagnosis.selection": ("MOST_EFFECTS", "MOST_WAVES", "MOST_REFITTED", "PROPOSED", "RIVALS", "NEAR", "EXCHANGED"),
    "identification.sandwich": ("MEMORIES", "SHARES", "ORDINARY", "MODES"),
    "diagnosis.charges": ("CHANCE", "MARGIN", "AS_GOOD", "BENT"),
    "diagnosis.harmonics": ("FEW", "LONGEST", "SEEN_TWICE"),
    "diagnosis.chance": ("MOST_LEVERAGE", "LEAST_REST", "PROVEN"),
    "diagnosis.search": ("REFINED", "NEAR_BEST", "ASIDE"),
    "diagnosis.library": ("MIXED", "NEIGHBOURS", "SIZES", "SIZE_STEP"),
    "diagnosis.structure": ("FEWEST_NEIGHBOURS", "FUNCTIONS", "LEVELS", "CENTRES", "RADII"),
    "diagnosis.spectrum": ("MARGIN", "STANDS_OUT", "LEAST_TURN", "IDLE"),
    "diagnosis.wandering": ("MODES",),
    "diagnosis.scattering": ("ROUNDED", "SIZES"),
    "diagnosis.unnamed": ("SMALLEST",),
    "diagnosis.correction": ("LENGTHS", "KNOTS", "CANDIDATES"),
    "diagnosis.laws.screen": ("PART", "LOOKED_AT", "KINDS", "REFINED", "NEAR"),
    "diagnosis.laws.shape": ("MOST", "CLOSER", "LITTLE"),
    "diagnosis.laws.search": ("MOST_TERMS", "AT_FIRST", "TRIED", "LOOKS"),
    "diagnosis.laws.proof": ("SHARE", "TRIMMED", "BLOCK", "PART", "LAST", "SLOW", "SUPPORTED"),
    "diagnosis.laws.remainder": ("COUNTS", "PRICE"),
    "diagnosis.laws.laws": ("RIVALS", "DOUBTED"),
}
FACTORS = (0.7, 1.3)
ALIKE = 0.02  # of the held-out RMS
Job = tuple[str, str, str, float]  # folder, module, constant, factor; without a constant as it is


def scaled(value: Any, factor: float) -> Any:
    """Return a constant times a factor; whole numbers stay whole, and become others."""
    if isinstance(value, tuple):
        return tuple(scaled(v, factor) for v in value)
    if isinstance(value, int):
        new = round(factor * value)
        return max(new if new != value else value + (1 if factor > 1 else -1), 1)
    return factor * np.asarray(value) if isinstance(value, np.ndarray) else factor * value


def holders(module: str, name: str) -> list[Any]:
    """Return the modules that know a constant: its own, and those that import it."""
    own = import_module(f"deltacal_gen.{module}")
    value = getattr(own, name)
    others = [
        m for key, m in sys.modules.items() if key.startswith("deltacal_gen.") and getattr(m, name, None) is value
    ]
    assigns = re.compile(rf"^[A-Z_, ]*\b{name}\b[A-Z_, ]*(:[^=]+)?=", re.MULTILINE)  # small numbers are one object
    return [own, *(m for m in others if m is not own and not assigns.search(getsource(m)))]


@contextmanager
def changed(module: str, name: str, factor: float) -> Iterator[None]:
    """Multiply a constant, wherever it was imported to."""
    own = holders(module, name)
    value = getattr(own[0], name)
    try:
        for holder in own:
            setattr(holder, name, scaled(value, factor))
        yield
    finally:
        for holder in own:
            setattr(holder, name, value)


def said(folder: Path) -> Entry:
    """Return verdict, what is named with its limbs, and the RMS of held-out readings."""
    robot = dc.read_robot(folder / "robot.toml")
    found = dc.diagnose(robot, dc.read_recording(folder / "recording.csv", mechanism_of(robot)))
    named = [[e.name, list(e.limbs)] for e in found.effects] + [[law.text, []] for law in found.laws]
    held_out = found.final.heldout_rms_mm if found.correction is None else found.correction.heldout_rms_mm.after
    return {"verdict": found.verdict.value, "named": named, "held out": held_out or 0.0}


def examine(job: Job) -> Entry:
    """Return what is said with a constant changed."""
    folder, module, name, factor = job
    try:
        if not name:
            return said(Path(folder))
        with changed(module, name, factor):
            return said(Path(folder))
    except DeltacalError as error:
        return {"error": str(error)}


def jobs(folder: str, only: str = "") -> list[Job]:
    """Return a diagnosis as it is, and one for each change; `only` of constants that hold one of some words."""
    every = [(module, name) for module, names in STEERING.items() for name in names]
    wanted = [(m, n) for m, n in every if any(words in f"{m}.{n}" for words in only.split(","))]
    return [(folder, "", "", 1.0), *((folder, m, n, factor) for m, n in wanted for factor in FACTORS)]


def told(done: dict[Job, Entry]) -> Iterable[str]:
    """Return what changes."""
    count, base = 0, next((entry for job, entry in done.items() if not job[2]), None)
    if base is None or "error" in base:
        return
    for (_, module, name, factor), now in done.items():
        count += bool(name)
        moved = "error" in now or any(now[key] != base[key] for key in ("verdict", "named"))
        if moved or abs(now["held out"] - base["held out"]) > ALIKE * base["held out"]:
            yield f"  {module}.{name} times {factor}: {now}"
    yield f"  {count} changes of a constant looked at"


def main(arguments: list[str] | None = None) -> int:
    """Print what changes."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.thirty", description=__doc__.split("\n")[0])
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--only", default="", help="constants whose names hold one of these words, parted by commas")
    add_options(parser)
    given = parser.parse_args(arguments)
    found = sit(examine, [job for folder in given.folders for job in jobs(str(folder), given.only)], given)
    for folder in map(str, given.folders):
        own = {job: entry for job, entry in found.done.items() if job[0] == folder}
        print(f"{Path(folder).name}: {own.get((folder, '', '', 1.0))}")
        print(*told(own), sep="\n", flush=True)
    return found.code


if __name__ == "__main__":
    sys.exit(main())
