"""What 30 % more or less of a constant does: ``python -m tests.benchmarks.thirty FOLDER [FOLDER ...]``.

A folder holds ``robot.toml`` and ``recording.csv``. Each is diagnosed as it is, and once with every constant that
steers what is called noise, found, proven or corrected, times 0.7 and times 1.3. A line is printed for each that
changes the verdict or what is named, or moves the RMS of held-out readings by more than 2 %.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib import import_module
from pathlib import Path

import deltacal_gen as dc
from deltacal_gen.errors import DeltacalError
from deltacal_gen.machine.registry import mechanism_of

STEERING = {
    "estimation.residuals": ("HUBER", "MOST_GROSS", "GROSS"),
    "estimation.turns": ("TURNED",),
    "identification.noise": ("PROVEN", "MISTAKEN", "LEAST_EXCESS"),
    "identification.together": ("PROVEN", "PRICE"),
    "diagnosis.diagnosis": ("MACHINED",),
    "diagnosis.refits": ("ROOM",),
    "diagnosis.strategy": ("MARGIN", "ALIKE", "HARDLY_ALIKE", "BORNE_OUT", "MUCH_WORSE", "SETTLED"),
    "diagnosis.charges": ("CHANCE",),
    "diagnosis.search": ("REFINED",),
    "diagnosis.library": ("MIXED", "SIZE_STEP"),
    "diagnosis.spectrum": ("MARGIN", "PROVEN", "LEAST_TURN", "IDLE", "SAME_NOISE"),
    "diagnosis.correction": ("PROVEN", "LENGTHS", "SIZES"),
}
FACTORS = (0.7, 1.3)
ALIKE = 0.02  # of the held-out RMS
Said = tuple[str, tuple[tuple[str, tuple[int, ...]], ...], float]


@contextmanager
def changed(module: str, name: str, factor: float) -> Iterator[None]:
    """Multiply a constant, wherever it was imported to."""
    value = getattr(import_module(f"deltacal_gen.{module}"), name)
    holders = [m for m in list(sys.modules.values()) if getattr(m, name, None) is value]
    new = tuple(factor * v for v in value) if isinstance(value, tuple) else factor * value
    try:
        for holder in holders:
            setattr(holder, name, new)
        yield
    finally:
        for holder in holders:
            setattr(holder, name, value)


def said(folder: Path) -> Said:
    """Return verdict, what is named with its limbs, and the RMS of held-out readings."""
    robot = dc.read_robot(folder / "robot.toml")
    found = dc.diagnose(robot, dc.read_recording(folder / "recording.csv", mechanism_of(robot)))
    named = tuple((e.name, tuple(e.limbs)) for e in found.effects)
    held_out = found.final.heldout_rms_mm if found.correction is None else found.correction.heldout_rms_mm.after
    return found.verdict.value, named, held_out or 0.0


def main() -> None:
    """Print what changes."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.thirty", description=__doc__.split("\n")[0])
    parser.add_argument("folders", nargs="+", type=Path)
    for folder in parser.parse_args().folders:
        base = said(folder)
        print(f"{folder.name}: {base}", flush=True)
        count = 0
        for module, names in STEERING.items():
            for name in names:
                for factor in FACTORS:
                    with changed(module, name, factor):
                        try:
                            now = said(folder)
                        except DeltacalError as error:
                            print(f"  {module}.{name} times {factor}: {error}", flush=True)
                            continue
                    count += 1
                    if now[:2] != base[:2] or abs(now[2] - base[2]) > ALIKE * base[2]:
                        print(f"  {module}.{name} times {factor}: {now}", flush=True)
        print(f"  {count} changes of a constant looked at", flush=True)


if __name__ == "__main__":
    main()
