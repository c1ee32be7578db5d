"""Outputs under attack: ``python -m tests.benchmarks.outputs [--kills N] [--seed S]``.

Runs are killed at random moments while an older output stands; two runs write one output at once; the disk is full
(/dev/full), the folder may not be written, the output is a link or a device. Nothing may be lost, half or left behind.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Sequence
from pathlib import Path

from tests.benchmarks import fuzz
from tests.benchmarks.fuzz_inputs import shelf

LONGEST_S = 1.0  # after which a run is killed at the latest: longer than it takes
RUNS: dict[str, tuple[str, ...]] = {  # commands by the ending of what they write
    ".json": ("identify", "{delta.robot.toml}", "{delta.recording.csv}", "--model", "18", "--report", "{beside.html}"),
    ".csv": ("predict", "{delta.result.json}", "{delta.recording.csv}"),
    ".c": ("compensate", "{delta.result.json}", "--export", "c"),
    ".html": ("certificate", "{delta.result.json}", "{other.csv}"),
}


def begun(folder: Path, arguments: Sequence[str], output: Path | str) -> int:
    """Fork a run that writes `output`; return its process."""
    given = [str(folder / a.strip("{}")) if a.startswith("{") else a for a in arguments]
    child = os.fork()
    if not child:
        fuzz.child([*given, "-o", str(output)], folder.parent / f"said.{os.getpid()}")
    return child


def ended(child: int) -> int:
    """Return the exit code of a run."""
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def whole(path: Path) -> bool:
    """Tell whether an output is complete."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".json":
        return bool(json.loads(text)["parameters"])
    return text.rstrip().endswith({".csv": text.rstrip()[-1], ".c": "}", ".html": "</html>"}[path.suffix])


def killed(folder: Path, count: int, dice: random.Random) -> Counter[str]:
    """Kill runs at random moments; return how what stands there afterwards is."""
    found: Counter[str] = Counter()
    for k in range(count):
        ending = [*RUNS][k % len(RUNS)]
        path = folder / f"out{ending}"
        before = path.read_bytes() if path.exists() else None
        child = begun(folder, RUNS[ending], path)
        time.sleep(dice.uniform(0, LONGEST_S))
        os.kill(child, signal.SIGKILL)
        over = ended(child) == 0
        now = path.read_bytes() if path.exists() else None
        if now == before and not over:
            found["killed, the old one stands"] += 1
        else:
            found["done, the new one stands" if now is not None and whole(path) else "HALF"] += 1
    for ending, arguments in RUNS.items():
        ended(begun(folder, arguments, folder / f"out{ending}"))
    left = [p.name for p in folder.iterdir() if p.name.endswith(".part") and ".out." in p.name]
    found["PARTS LEFT"] += len(left)
    return found


def together(folder: Path, rounds: int) -> Counter[str]:
    """Let two runs write one output."""
    found: Counter[str] = Counter()
    for k in range(rounds):
        ending = [*RUNS][k % len(RUNS)]
        path = folder / f"both{ending}"
        codes = [ended(child) for child in [begun(folder, RUNS[ending], path) for _ in range(2)]]
        found["both done, one stands" if codes == [0, 0] and whole(path) else f"LOST {codes}"] += 1
    return found


def elsewhere(folder: Path) -> Counter[str]:
    """Write where nothing can be written, through links, and into devices."""
    found: Counter[str] = Counter()
    shut = folder.parent / "shut"
    shut.mkdir()
    shut.chmod(0o500)
    for ending, arguments in RUNS.items():
        real, link = folder / f"real{ending}", folder / f"link{ending}"
        real.write_text("old")
        link.symlink_to(real)
        cases: dict[str, tuple[Path, int]] = {
            "full disk": (Path("/dev/full"), 3),
            "no such folder": (folder / "none" / f"x{ending}", 3),
            "link": (link, 0),
        }
        if os.getuid():  # root may write everywhere
            cases["read-only folder"] = (shut / f"x{ending}", 3)
        if ending != ".html":  # of a certificate the XML stands beside
            cases["device"] = (Path("/dev/null"), 0)
        for name, (path, wanted) in cases.items():
            code = ended(begun(folder, arguments, path))
            right = code == wanted and not [*shut.iterdir()] and Path("/dev/null").is_char_device()
            right &= name != "link" or (link.is_symlink() and whole(real))
            found[name if right else f"WRONG {name} {ending} {code}"] += 1
    return found


def main(arguments: Sequence[str] | None = None) -> int:
    """Return 0 where nothing was lost, half or left behind."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=200)
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args(arguments)
    fuzz.load()
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "good"
        folder.mkdir()
        shelf(folder)
        found = elsewhere(folder) + together(folder, max(asked.kills // 10, 4))
        found += killed(folder, asked.kills, random.Random(asked.seed))
    print(dict(found))
    return int(any(name[:4].isupper() for name in found))


if __name__ == "__main__":
    sys.exit(main())
