"""What a case answered, and how two answers differ.

Words, names, verdicts, flags and lengths must be equal. A number may differ by `TOLERANCE` of its own scale: of the
standard deviation that stands beside it or, where there is none, of the largest number beside it.
"""

from __future__ import annotations

import csv
import io
import json
import math
import os
import re
import subprocess
import sys
from collections.abc import Iterator, Mapping
from fnmatch import fnmatch
from pathlib import Path
from typing import Any

from tests.frozen.cases import ROOT, Case

TOLERANCE = 1e-9
LIMIT_S = 600
SAVED = (".json", ".csv", ".c")
NUMBER = re.compile(r"[-+]?(?:\d+\.\d*|\.\d+|\d+)(?:[eE][-+]?\d+)?")
# all commands of a case by one process, which imports once: what one did moves no bit of the next one's answer
RUN = """
import contextlib, io, json, sys
from deltacal_gen.app import cli
ended = []
for sys.argv[1:] in json.loads(sys.argv[1]):
    code = 0
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()) as said:
        try:
            cli.main()
        except SystemExit as end:
            code = int(end.code or 0)
    ended.append((code, said.getvalue()))
print(json.dumps(ended))
"""
LEFT = ("heldout_rms_mm", "heldout_rms_by_joint")  # at rest, and in motion
FIGURES = ("model", "rank", "train_rms_mm", "heldout_rms_mm", "sigma_mm", "train_rms_Nm", "heldout_rms_Nm", "sigma_Nm")
Answers = dict[str, Any]


def answered(case: Case, folder: Path, tree: Path = ROOT) -> Answers:
    """Run a case in a new folder with the program of a tree; return the exit codes and every file it wrote, by name."""
    folder.mkdir(parents=True)
    case.write(folder)
    given = {path.name for path in folder.iterdir()}
    environment = {**os.environ, "PYTHONPATH": f"{tree / 'src'}{os.pathsep}{tree / 'generated'}", "COLUMNS": "120"}
    found: Answers = {}
    done = subprocess.run(
        [sys.executable, "-c", RUN, json.dumps(case.commands)],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        timeout=LIMIT_S,
        check=True,
    )
    for number, (command, (code, said)) in enumerate(zip(case.commands, json.loads(done.stdout), strict=True)):
        found[f"exit {number} {command[0]}"] = code
        if code not in (0, 1):
            found[f"error {number} {command[0]}"] = " ".join(said.split())
    for path in sorted(folder.iterdir()):
        if path.suffix in SAVED and path.name not in given:
            found[path.name] = _parsed(path)
    return found


def _parsed(path: Path) -> Any:
    """Return a file as nested lists and mappings of numbers and words."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".json":
        return json.loads(text)
    if path.suffix == ".csv":
        rows = list(csv.reader(io.StringIO(text)))
        return {"columns": rows[0], "rows": [[_cell(c) for c in row] for row in rows[1:]]}
    code = [line for line in text.splitlines() if "sha256" not in line]
    return {"words": NUMBER.sub("#", "\n".join(code)), "numbers": [float(n) for n in NUMBER.findall("\n".join(code))]}


def _cell(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text


def differences(before: Any, now: Any, tolerance: float = TOLERANCE, at: str = "") -> Iterator[str]:
    """Yield where two answers differ, one line each."""
    if isinstance(before, Mapping) and isinstance(now, Mapping):
        for key in [*before, *(k for k in now if k not in before)]:
            where = f"{at}/{key}"
            if key not in now or key not in before:
                yield f"{where}: {'gone' if key in before else 'new'}"
            elif _number(before[key]) and _number(now[key]):
                yield from _apart(before[key], now[key], tolerance, _scale(before, key), where)
            else:
                yield from differences(before[key], now[key], tolerance, where)
    elif isinstance(before, list) and isinstance(now, list):
        if len(before) != len(now):
            yield f"{at}: {len(before)} entries, now {len(now)}"
            return
        size = max((abs(v) for v in before if _number(v)), default=0.0)
        for j, (old, new) in enumerate(zip(before, now, strict=True)):
            if _number(old) and _number(new):
                yield from _apart(old, new, tolerance, size, f"{at}[{j}]")
            else:
                yield from differences(old, new, tolerance, f"{at}[{j}]")
    elif before != now:
        yield f"{at}: {str(before)[:200]!r}, now {str(now)[:200]!r}"


def _number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _scale(beside: Mapping[str, Any], key: str) -> float:
    """Return the scale of a number in a table: its standard deviation or, without one, its own size."""
    sd = beside.get("std") if key == "value" else None
    return float(sd) if _number(sd) and sd else abs(beside[key])


def _apart(old: float, new: float, tolerance: float, scale: float, at: str) -> Iterator[str]:
    if not (old == new or abs(new - old) <= tolerance * scale or (math.isnan(old) and math.isnan(new))):
        yield f"{at}: {old!r}, now {new!r} ({abs(new - old) / scale if scale else math.inf:.1e} of its scale)"


def intended(line: str, case: str, listed: list[dict[str, str]]) -> bool:
    """Tell whether a difference is listed, by case and place, as intended."""
    place = line.partition(": ")[0]
    return any(fnmatch(case, entry["case"]) and fnmatch(place, entry["place"]) for entry in listed)


def essence(found: Answers) -> Answers:
    """Return what of an answer is committed: verdicts, names, limbs, values with their uncertainty, errors, codes."""
    kept: Answers = {k: v for k, v in found.items() if k.startswith(("exit", "error"))}
    if "result.json" in found:
        result = found["result.json"]
        kept["result.json"] = {k: result[k] for k in FIGURES if k in result}
        names = ("name", "value", "std", "unit", "status")
        kept["result.json"]["parameters"] = [{k: p[k] for k in names} for p in result["parameters"]]
    if "diagnosis.json" in found:
        diagnosis = found["diagnosis.json"]
        kept["diagnosis.json"] = {
            "verdict": diagnosis["verdict"],
            "channels": [c["name"] for c in diagnosis["location"]["channels"]],
            "limbs": diagnosis["location"]["limbs"],
            "effects": [
                {k: e[k] for k in ("name", "limbs", "parameters", "indistinguishable_from")}
                for e in diagnosis["effects"]
            ],
            **{key: [diagnosis[k][key] for k in ("baseline", "final")] for key in LEFT if key in diagnosis["final"]},
        }
    for name, content in found.items():
        if name.endswith(".csv") and name != "recording.csv":
            kept[name] = {"columns": content["columns"], "rows": content["rows"][:3]}
        elif name.endswith(".c"):
            kept[name] = {"numbers": content["numbers"][:12]}
    return kept
