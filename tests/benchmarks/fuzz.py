"""Damaged inputs for every command: ``python -m tests.benchmarks.fuzz [--runs N] [--seed S] [--only COMMAND]``.

Every run takes a command with good inputs, damages one of its files, and holds what comes back against the contract:
an exit code of the contract, no traceback, no fault of ours, no hang, and nothing left behind by a run that failed. A
run is a process of its own, forked from one that has loaded everything. What was found once stands in `FOUND`.
"""

from __future__ import annotations

import argparse
import importlib
import json
import os
import pkgutil
import random
import re
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import deltacal_gen
from deltacal_gen.app import cli, commands
from deltacal_gen.app.demonstration import example

CODES = (0, 1, 2, 3, 4)  # of the contract; 130 is the keyboard's
HANG_S = 60
NUMBERS = ("nan", "inf", "-1", "0", "1e400", "1e300", "-0.0", "", "x", "1,5", "1_000", "٣", "0x10", "9" * 400, "true")
JSONS = (None, True, -1, 0, 1e300, "", "x", [], {}, [[]], [None], [1, "a"], "9" * 400)
MACHINES = ("delta", "diamond", "planar_parallelogram", "linear_delta", "serial")


@dataclass(frozen=True)
class Job:
    """A command with good inputs: arguments, in which ``{name}`` is a file of the folder, and the files damaged."""

    arguments: tuple[str, ...]
    damaged: tuple[str, ...]

    @property
    def name(self) -> str:
        """The command."""
        return self.arguments[0]


@dataclass(frozen=True)
class Outcome:
    """What a run came to."""

    code: int
    seconds: float
    said: str
    left: tuple[str, ...]

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


# --------------------------------------------------------------------------------------------------------- good inputs


def shelf(folder: Path) -> None:
    """Fill a folder with a good input of each sort for each machine."""
    for machine in MACHINES:
        source = example().parent / machine
        for name in ("robot.toml", "poses.csv", "poses.toml", "truth.toml", "printer.cfg"):
            if (source / name).exists():
                (folder / f"{machine}.{name}").write_bytes((source / name).read_bytes())
        robot, recording = folder / f"{machine}.robot.toml", folder / f"{machine}.recording.csv"
        commands.simulate(robot, folder / f"{machine}.poses.csv", recording, noise=0.02, seed=3)
        commands.identify(robot, recording, output=folder / f"{machine}.result.json")
    for name in ("robot.toml", "recording.csv", "recording.toml"):
        (folder / f"gearbox.{name}").write_bytes((example().parent / "gearbox" / name).read_bytes())
    commands.diagnose(
        folder / "gearbox.robot.toml", folder / "gearbox.recording.csv", folder / "gearbox.diagnosis.json"
    )
    (folder / "targets.csv").write_text("x_mm,y_mm,z_mm,payload_kg,temp_C,approach1\n0,0,-853,1,21,1\n99,0,-900,,,-1\n")
    (folder / "config.g").write_text(
        "; delta\nM665 R160 L345:345:345 H380 X0.1 Y0 Z0\nM666 X0.1 Y-0.1 Z0\nG31 Z0.5 X0 Y0\n"
    )
    (folder / "marlin.txt").write_text(
        "M665 L345 R160 H380 X0.1 Y0 Z0\nM666 X-0.1 Y-0.2 Z0\nM851 Z-0.5\nBed X: 0 Y: 0 Z: 0.1\nBed X: 9 Y: 9 Z: 0.2\n"
    )
    (folder / "heightmap.csv").write_text(
        "RepRapFirmware height map file v2 generated\n"
        "xmin,xmax,ymin,ymax,radius,xspacing,yspacing,xnum,ynum\n-80,80,-80,80,90,80,80,3,3\n"
        "0,0.1,0\n0.12,-0.01,0.05\n0,0.02,0\n"
    )
    rows = (folder / "delta.recording.csv").read_text().splitlines()
    head = rows[0].split(",")
    joints, xyz = (
        [head.index(n) for n in names] for names in (("q1_deg", "q2_deg", "q3_deg"), ("x_mm", "y_mm", "z_mm"))
    )
    cells = [row.split(",") for row in rows[1:]]
    (folder / "joints.csv").write_text(
        "point,J1 [deg],J2 [deg],J3 [deg]\n"
        + "".join(f"p{k},{','.join(c[j] for j in joints)}\n" for k, c in enumerate(cells))
    )
    (folder / "points.txt").write_text("".join(f"A;p{k};{';'.join(c[j] for j in xyz)}\n" for k, c in enumerate(cells)))


def jobs() -> Iterator[Job]:
    """Yield every command with good inputs."""
    for machine in MACHINES:
        robot, recording, poses, truth, result = (
            f"{machine}.{name}" for name in ("robot.toml", "recording.csv", "poses.csv", "truth.toml", "result.json")
        )
        beside = f"{machine}.recording.toml"
        read = (robot, recording, beside)
        yield Job(("identify", f"{{{robot}}}", f"{{{recording}}}", "-o", "{out.json}", "--report", "{out.html}"), read)
        yield Job(("validate", f"{{{result}}}", f"{{{recording}}}"), (result, recording, beside))
        yield Job(("predict", f"{{{result}}}", f"{{{recording}}}", "-o", "{out.csv}"), (result, recording, beside))
        yield Job(
            ("simulate", f"{{{robot}}}", f"{{{poses}}}", "--truth", f"{{{truth}}}", "-o", "{out.csv}"),
            (robot, poses, truth, truth, f"{machine}.poses.toml"),
        )
        yield Job(("compare", f"{{{result}}}", f"{{{result}}}", "-o", "{out.json}"), (result,))
        yield Job(("compensate", f"{{{result}}}", "{targets.csv}", "-o", "{out.csv}"), (result, "targets.csv"))
        yield Job(("compensate", f"{{{result}}}", "--export", "c", "-o", "{out.c}"), (result,))
    yield Job(
        ("diagnose", "{gearbox.robot.toml}", "{gearbox.recording.csv}", "-o", "{out.json}", "--report", "{out.html}"),
        ("gearbox.robot.toml", "gearbox.recording.csv", "gearbox.recording.toml"),
    )
    diagnosis = "gearbox.diagnosis.json"
    for arguments in (
        ("predict", "{gearbox.diagnosis.json}", "{gearbox.recording.csv}", "-o", "{out.csv}"),
        ("compensate", "{gearbox.diagnosis.json}", "{targets.csv}", "-o", "{out.csv}"),
        ("identify", "{gearbox.robot.toml}", "{gearbox.recording.csv}", "--physics", "{gearbox.diagnosis.json}"),
    ):
        yield Job(arguments, (diagnosis, diagnosis, "gearbox.recording.csv", "targets.csv"))
    printer, robot = "linear_delta.result.json", "{delta.robot.toml}"
    for kind in ("klipper", "rrf", "marlin"):
        yield Job(("compensate", f"{{{printer}}}", "--export", kind, "-o", "{out.txt}"), (printer,))
    yield Job(
        ("matrix", robot, "{delta.recording.csv}", "--model", "18", "-o", "{out.npz}"),
        ("delta.robot.toml", "delta.recording.csv"),
    )
    yield Job(("plan", robot, "--model", "18", "-o", "{out.csv}"), ("delta.robot.toml",))
    yield Job(("import", "klipper", "{linear_delta.printer.cfg}", "-o", "{out}"), ("linear_delta.printer.cfg",))
    yield Job(("import", "rrf", "{config.g}", "{heightmap.csv}", "-o", "{out}"), ("config.g", "heightmap.csv"))
    yield Job(("import", "marlin", "{marlin.txt}", "-o", "{out}"), ("marlin.txt",))
    yield Job(("import", "points", "{points.txt}", "{joints.csv}", robot, "-o", "{out}"), ("points.txt", "joints.csv"))


# -------------------------------------------------------------------------------------------------------------- damage


def damaged(content: bytes, name: str, dice: random.Random) -> bytes:
    """Return the content of a file with one to three damages."""
    for _ in range(dice.choice((1, 1, 1, 2, 3))):
        ways: Sequence[Callable[[bytes, random.Random], bytes]] = (
            *_TEXT,
            *(_JSON * 3 if name.endswith(".json") else _CELLS),
        )
        content = dice.choice(ways)(content, dice)
    return content


def _lines(change: Callable[[list[bytes], random.Random], None]) -> Callable[[bytes, random.Random], bytes]:
    def damage(content: bytes, dice: random.Random) -> bytes:
        lines = content.split(b"\n")
        change(lines, dice)
        return b"\n".join(lines)

    return damage


def _swap(lines: list[bytes], dice: random.Random) -> None:
    i, j = dice.randrange(len(lines)), dice.randrange(len(lines))
    lines[i], lines[j] = lines[j], lines[i]


def _number(content: bytes, dice: random.Random) -> bytes:
    """Put something else in the place of a number."""
    found = list(re.finditer(rb"-?\d+(\.\d+)?(e-?\d+)?", content))
    if not found:
        return content
    at = dice.choice(found)
    return content[: at.start()] + dice.choice(NUMBERS).encode() + content[at.end() :]


def _word(content: bytes, dice: random.Random) -> bytes:
    """Misspell a word, or leave it out."""
    found = list(re.finditer(rb"[A-Za-z_][\w.]*", content))
    if not found:
        return content
    at = dice.choice(found)
    word = at[0].decode()
    other = dice.choice(
        ("", word[::-1], word + "_", word.upper(), word * 40, dice.choice(found)[0].decode(), "[" + word, '"')
    )
    return content[: at.start()] + other.encode() + content[at.end() :]


def _byte(content: bytes, dice: random.Random) -> bytes:
    at = dice.randrange(len(content) + 1)
    return content[:at] + bytes([dice.randrange(256)]) + content[at + 1 :]


def _column(content: bytes, dice: random.Random) -> bytes:
    """Leave out a column of a table."""
    rows = [line.split(b",") for line in content.split(b"\n")]
    at = dice.randrange(max(len(rows[0]), 1))
    return b"\n".join(b",".join(c for k, c in enumerate(row) if k != at) for row in rows)


_TEXT: tuple[Callable[[bytes, random.Random], bytes], ...] = (
    lambda c, d: b"",
    lambda c, d: c[: d.randrange(len(c) + 1)],
    lambda c, d: b"\xef\xbb\xbf" + c,
    lambda c, d: c.decode(errors="replace").encode("utf-16"),
    lambda c, d: c.replace(b"\n", b"\r\n"),
    lambda c, d: c.replace(b"\n", b"\r"),
    lambda c, d: c.replace(b".", b","),
    lambda c, d: c.replace(b",", b";"),
    lambda c, d: c + b"\0" * 9,
    lambda c, d: b"\x89PNG\r\n" + bytes(d.randrange(256) for _ in range(200)),
    lambda c, d: c.replace(b'"', b"'"),
    _byte,
    _byte,
    _lines(lambda lines, d: lines.__delitem__(d.randrange(len(lines)))),
    _lines(lambda lines, d: lines.insert(d.randrange(len(lines)), d.choice(lines))),
    _lines(_swap),
)
_CELLS: tuple[Callable[[bytes, random.Random], bytes], ...] = (_number, _number, _number, _word, _word, _word, _column)


def _places(data: object, at: tuple[object, ...] = ()) -> Iterator[tuple[object, ...]]:
    inside = data.items() if isinstance(data, dict) else enumerate(data) if isinstance(data, list) else ()
    for key, value in inside:
        yield (*at, key)
        yield from _places(value, (*at, key))


def _json(content: bytes, dice: random.Random) -> bytes:
    """Put something else in the place of a value of JSON, or leave it out."""
    try:
        data = json.loads(content)
    except (ValueError, RecursionError):
        return content
    shallow = [p for p in _places(data) if len(p) <= dice.choice((1, 2, 3, 9))]
    if not shallow:
        return content
    *path, last = dice.choice(shallow)
    inside = data
    for key in path:
        inside = inside[key]
    way = dice.randrange(4)
    if way == 0:
        del inside[last]
    elif way == 1 and isinstance(inside[last], list) and inside[last]:
        inside[last] = inside[last][:-1]
    elif way == 2 and isinstance(inside[last], (int, float)):
        inside[last] = dice.choice((-1, 0, 1e300, -inside[last], inside[last] * 1e6, int(inside[last])))
    else:
        inside[last] = dice.choice(JSONS)
    return json.dumps(data, indent=1).encode()


def _nested(content: bytes, dice: random.Random) -> bytes:
    deep = 10 ** dice.randrange(2, 6)
    return content.replace(b":", b": " + b"[" * deep, 1)


_JSON: tuple[Callable[[bytes, random.Random], bytes], ...] = (*(_json,) * 12, _nested, _number)

Damage = Callable[[bytes], bytes]


def _keys(content: bytes, change: Callable[[dict[str, Any]], object]) -> bytes:
    """Return JSON of which some keys were changed."""
    data = json.loads(content)
    change(data)
    return json.dumps(data).encode()


FOUND: dict[str, tuple[str, str, Damage]] = {  # command, file, and what was done to it: each was a traceback once
    "a list nested without end": ("validate", "delta.result.json", lambda c: b'{"a": ' + b"[" * 100_000),
    "a mirrored frame": (
        "predict",
        "planar_parallelogram.result.json",
        lambda c: _keys(c, lambda d: d["instrument"]["state"][0].__setitem__(1, 1e300)),
    ),
    "a parameter too few": ("compare", "delta.result.json", lambda c: _keys(c, lambda d: d["parameters"].pop())),
    "no instrument": ("predict", "delta.result.json", lambda c: _keys(c, lambda d: d.pop("instrument"))),
    "an effect without a name": (
        "predict",
        "gearbox.diagnosis.json",
        lambda c: _keys(c, lambda d: d["physics"][0].pop("effect")),
    ),
    "an error that is a text": ("simulate", "delta.truth.toml", lambda c: b'[parameters]\ntheta_1 = "x"\n'),
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


# ---------------------------------------------------------------------------------------------------------------- runs


def run(job: Job, folder: Path) -> Outcome:
    """Run a job in a process of its own, in a folder with its inputs."""
    before = {p.name for p in folder.iterdir()}
    said = folder.parent / f"{folder.name}.said"
    arguments = [re.sub(r"\{(.*)\}", lambda m: str(folder / m[1]), a) for a in job.arguments]
    start = time.monotonic()
    child = os.fork()
    if not child:
        _child(arguments, said)
    status = _waited(child, start)
    left = tuple(sorted(p.name for p in folder.iterdir() if p.name not in before))
    code = os.waitstatus_to_exitcode(status)
    return Outcome(code, time.monotonic() - start, said.read_text(errors="replace"), left)


def _child(arguments: list[str], said: Path) -> None:
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


def _waited(child: int, start: float) -> int:
    while True:
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            return status
        if time.monotonic() - start > HANG_S + 1:
            os.kill(child, signal.SIGKILL)
            return os.waitpid(child, 0)[1]
        time.sleep(0.002)


def again(name: str, good: Path) -> Outcome:
    """Run what was found once."""
    command, file, damage = FOUND[name]
    job = next(j for j in jobs() if j.name == command and file in j.damaged)
    return attempt(job, file, damage((good / file).read_bytes()), good)


def attempt(job: Job, name: str, content: bytes, good: Path) -> Outcome:
    """Run a job whose file `name` has another content; the other files are good."""
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary) / "run"
        folder.mkdir()
        for path in good.iterdir():
            (folder / path.name).hardlink_to(path)
        (folder / name).unlink(missing_ok=True)
        (folder / name).write_bytes(content)
        return run(job, folder)


def _load() -> None:
    """Load every module of the package, so that runs, which are forked, load none."""
    for module in pkgutil.walk_packages(deltacal_gen.__path__, "deltacal_gen."):
        if not module.name.endswith("__main__"):
            importlib.import_module(module.name)


def main(arguments: Sequence[str] | None = None) -> int:
    """Run; return 0 where every run kept the contract."""
    _load()
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=5000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--only", help="a command")
    parser.add_argument("--keep", type=Path, help="folder for the damaged files of runs against the contract")
    asked = parser.parse_args(arguments)
    codes: Counter[tuple[str, int]] = Counter()
    flaws: Counter[str] = Counter()
    with tempfile.TemporaryDirectory() as temporary:
        good = Path(temporary)
        shelf(good)
        for name in FOUND:
            if (outcome := again(name, good)).flaw:
                flaws[f"{outcome.flaw}: {name}"] += 1
                print(f"{name}: {outcome.flaw}\n{outcome.said[-600:]}", flush=True)
        chosen = [job for job in jobs() if asked.only in (None, job.name)]
        for k in range(asked.runs):
            dice = random.Random(f"{asked.seed}/{k}")
            job = chosen[k % len(chosen)]
            name = dice.choice(job.damaged)
            path = good / name
            content = damaged(path.read_bytes() if path.exists() else b"", name, dice)
            outcome = attempt(job, name, content, good)
            codes[job.name, outcome.code] += 1
            if outcome.flaw:
                last = outcome.said.strip().splitlines()[-1:] or [""]
                where = re.findall(r"\(deltacal_\S+", last[0])
                key = f"{outcome.flaw}: {job.name} {name}: {where[-1] if where else last[0][-200:]}"
                if not flaws[key] and asked.keep:
                    asked.keep.mkdir(exist_ok=True)
                    (asked.keep / f"{asked.seed}.{k}.{name}").write_bytes(content)
                    (asked.keep / f"{asked.seed}.{k}.said").write_text(" ".join(job.arguments) + "\n" + outcome.said)
                flaws[key] += 1
                print(f"run {k}: {key}", flush=True)
    for command in sorted({c for c, _ in codes}):
        print(command, {code: n for (c, code), n in sorted(codes.items()) if c == command})
    print(f"{sum(codes.values())} runs, {sum(flaws.values())} against the contract, of {len(flaws)} sorts")
    return 1 if flaws else 0


if __name__ == "__main__":
    sys.exit(main())
