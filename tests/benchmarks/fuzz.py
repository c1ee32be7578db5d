"""Damaged inputs for every command: ``python -m tests.benchmarks.fuzz [--runs N] [--seed S] [--only COMMAND]``.

Every run takes a command with good inputs (`fuzz_inputs`), damages one of its files (`fuzz_damage`), and holds what
comes back against the contract: an exit code of the contract, no traceback, no fault of ours, no hang, and nothing left
behind by a run that failed. A run is a process of its own, forked from one that has loaded everything, and its damage
depends on the seed and its number alone. With ``--log FILE`` runs that the file has are not run again, so that many
short sittings make a long one; ``--minutes M`` ends a sitting. What was found once stands in `FOUND`.
"""

from __future__ import annotations

import argparse
import csv
import importlib
import json
import os
import pkgutil
import random
import re
import shutil
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NoReturn

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import deltacal_gen
from deltacal_gen.app import cli
from tests.benchmarks.fuzz_damage import damaged
from tests.benchmarks.fuzz_inputs import Job, jobs, shelf

CODES = (0, 1, 2, 3, 4)  # of the contract; 130 is the keyboard's
HANG_S = 60
IDLE = 5  # times as long by the clock: then it waits for what never comes


@dataclass(frozen=True)
class Outcome:
    """What a run came to."""

    code: int
    seconds: float
    said: str
    left: tuple[str, ...]
    warned: bool = False

    @property
    def flaw(self) -> str:
        """What is against the contract; "" where nothing is."""
        if self.seconds > HANG_S:
            return "hangs"
        if "Traceback" in self.said or self.code == cli.FAULT:
            return "fault"
        if self.code not in CODES:
            return f"exit code {self.code}"
        if self.code not in (0, 1) and self.left:
            return f"leaves {', '.join(self.left)}"
        return ""


Damage = Callable[[bytes], bytes]


def _keys(content: bytes, change: Callable[[dict[str, Any]], object]) -> bytes:
    """Return JSON of which some keys were changed."""
    data = json.loads(content)
    change(data)
    return json.dumps(data).encode()


FOUND: dict[str, tuple[str, str, Damage]] = {  # command, file, and what was done to it: each was a traceback once
    "a list nested without end": ("validate", "delta.result.json", lambda c: b'{"a": ' + b"[" * 100_000),
    "a parameter too few": ("compare", "delta.result.json", lambda c: _keys(c, lambda d: d["parameters"].pop())),
    "no instrument": ("predict", "delta.result.json", lambda c: _keys(c, lambda d: d.pop("instrument"))),
    "an effect without a name": (
        "predict",
        "gearbox.diagnosis.json",
        lambda c: _keys(c, lambda d: d["physics"][0].pop("effect")),
    ),
    "an error that is a text": ("simulate", "delta.truth.toml", lambda c: b'[parameters]\ntheta_1 = "x"\n'),
    "noise whose square is no number": (
        "diagnose",
        "gearbox.recording.toml",
        lambda c: c.replace(b"0.01", b"1e300"),
    ),
    "an integer that no float holds": (
        "simulate",
        "torque.truth.toml",
        lambda c: c.replace(b"coulomb = 2.0", b"coulomb = " + b"9" * 400),
    ),
    "a reading whose square is no number": (
        "identify",
        "encoder.recording.csv",
        lambda c: re.sub(rb"(?m)^(18(?:,[^,\n]+){3}),[^,]+", rb"\1,1e300", c),
    ),
    "poses without labels": (
        "next",
        "open.diagnosis.json",
        lambda c: c.replace(b'"pose"', b'"prose"'),
    ),
    "a ragged mesh": (
        "import",
        "linear_delta.printer.cfg",
        lambda c: c + b"#*# [bed_mesh b]\n#*# points =\n#*#   0, 1\n#*#   2\n#*# min_x = 0\n#*# max_x = 1\n",
    ),
    "a mesh with a name too long": (
        "import",
        "linear_delta.printer.cfg",
        lambda c: c.replace(b"bed_mesh default", b"bed_mesh " + b"a" * 300),
    ),
}


def run(job: Job, folder: Path, seen: Callable[[str, Path], bool] | None = None) -> Outcome:
    """Run a job in a process of its own, in a folder with its inputs; `seen` tells whether its answer warns."""
    before = {*folder.rglob("*")}
    said = folder.parent / f"{folder.name}.said"
    arguments = [re.sub(r"\{(.*)\}", lambda m: str(folder / m[1]), a) for a in job.arguments]
    start = time.monotonic()
    process = os.fork()
    if not process:
        child(arguments, said)
    status, seconds = _waited(process, start)
    left = tuple(sorted(str(p.relative_to(folder)) for p in folder.rglob("*") if p not in before))
    code = os.waitstatus_to_exitcode(status)
    words = said.read_text(errors="replace")
    warned = seen is not None and code in (0, 1) and seen(words, folder)
    return Outcome(code, seconds, words, left, warned)


def child(arguments: list[str], said: Path) -> NoReturn:
    """Run the command line in a forked process, what it says in a file, and end."""
    stream = os.open(said, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    os.dup2(stream, 1)
    os.dup2(stream, 2)
    os.environ[cli.TRACEBACK] = "1"
    sys.argv = ["deltacal", *arguments]
    code = 0
    try:
        cli.main()
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else 0
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)


def _waited(child: int, start: float) -> tuple[int, float]:
    """Return how a process ended and how long it was at it [s]: of the processor, or waiting far longer than that."""
    while True:
        done, status, used = os.wait4(child, os.WNOHANG)
        if done:
            return status, used.ru_utime + used.ru_stime
        waited = time.monotonic() - start
        if waited > HANG_S and max(_busy(child), waited / IDLE) > HANG_S:
            os.kill(child, signal.SIGKILL)
            return os.waitpid(child, 0)[1], HANG_S + 1.0
        time.sleep(0.002)


def _busy(process: int) -> float:
    """Return the processor's time that a process has had [s]; on a busy machine that is not the clock's."""
    fields = Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def again(name: str, good: Path) -> Outcome:
    """Run what was found once."""
    command, file, damage = FOUND[name]
    job = next(j for j in jobs() if j.name == command and file in j.damaged)
    return attempt(job, file, damage((good / file).read_bytes()), good)


def attempt(
    job: Job, name: str, content: bytes, good: Path, seen: Callable[[str, Path], bool] | None = None
) -> Outcome:
    """Run a job whose file `name` has another content; the other files are good."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "run"
        shutil.copytree(good, folder, copy_function=os.link)
        (folder / name).unlink(missing_ok=True)
        (folder / name).write_bytes(content)
        return run(job, folder, seen)


def load() -> None:
    """Load every module of the package, so that runs, which are forked, load none."""
    for module in pkgutil.walk_packages(deltacal_gen.__path__, "deltacal_gen."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)


Run = tuple[int, str, int, str]  # number, command, exit code, what is against the contract


def one(k: int, seed: int, chosen: Sequence[Job], good: Path, keep: Path | None) -> Run:
    """Run number `k`; what is against the contract is kept in a folder, with what the run said."""
    dice = random.Random(f"{seed}/{k}")
    job = chosen[k % len(chosen)]
    name = dice.choice(job.damaged)
    path = good / name
    content = damaged(path.read_bytes() if path.exists() else b"", name, dice)
    outcome = attempt(job, name, content, good)
    if not outcome.flaw:
        return k, job.name, outcome.code, ""
    last = outcome.said.strip().splitlines()[-1:] or [""]
    where = re.findall(r"\(deltacal_\S+", last[0])
    key = f"{outcome.flaw}: {job.name} {name}: {where[-1] if where else last[0][-200:]}"
    if keep is not None:
        keep.mkdir(exist_ok=True)
        (keep / f"{seed}.{k}.{path.name}").write_bytes(content)
        (keep / f"{seed}.{k}.said").write_text(" ".join(job.arguments) + "\n" + outcome.said)
    print(f"run {k}: {key}", flush=True)
    return k, job.name, outcome.code, key


def logged(path: Path | None) -> list[Run]:
    """Return the runs that a log has."""
    if path is None or not path.exists():
        return []
    with path.open(newline="", encoding="utf-8") as file:
        return [(int(k), command, int(code), flaw) for k, command, code, flaw in csv.reader(file)]


def log(path: Path | None, done: Run) -> None:
    """Add a run to a log."""
    if path is not None:
        with path.open("a", newline="", encoding="utf-8") as file:
            csv.writer(file).writerow(done)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; return 0 where every run kept the contract."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", help="a command")
    parser.add_argument("--keep", type=Path, help="folder for the damaged files of runs against the contract")
    parser.add_argument("--log", type=Path, help="a line to each run (CSV); those that it has are not run again")
    parser.add_argument("--minutes", type=float, default=float("inf"), help="after which no further run begins")
    asked = parser.parse_args(arguments)
    load()
    done, end = logged(asked.log), time.monotonic() + 60 * asked.minutes
    had = {k for k, *_ in done}
    with tempfile.TemporaryDirectory() as temporary:
        good = Path(temporary) / "good"
        good.mkdir()
        shelf(good)
        for name in FOUND if not had else ():
            if (outcome := again(name, good)).flaw:
                done.append((-1, FOUND[name][0], outcome.code, f"{outcome.flaw}: {name}"))
                print(f"{name}: {outcome.flaw}\n{outcome.said[-600:]}", flush=True)
        chosen = [job for job in jobs() if asked.only in (None, job.name)]
        for k in (k for k in range(asked.runs) if k not in had):
            if time.monotonic() > end:
                break
            done.append(one(k, asked.seed, chosen, good, asked.keep))
            log(asked.log, done[-1])
    return _told(done)


def _told(done: Sequence[Run]) -> int:
    """Print how runs ended, command by command; return 1 where one was against the contract."""
    codes = Counter((command, code) for _, command, code, _ in done)
    for command in sorted({c for c, _ in codes}):
        print(command, {code: n for (c, code), n in sorted(codes.items()) if c == command})
    flaws = Counter(flaw for *_, flaw in done if flaw)
    for flaw, times in flaws.most_common():
        print(f"{times} x {flaw}")
    print(f"{len(done)} runs, {sum(flaws.values())} against the contract, of {len(flaws)} sorts")
    return 1 if flaws else 0


if __name__ == "__main__":
    sys.exit(main())
