"""``python -m tests.frozen write|compare|commit``: what the program answers, held against what it answered before.

``write FOLDER`` runs every case and keeps whole answers there (one JSON a case); ``compare FOLDER`` runs them again and
names every difference that `intended.toml` does not list; ``commit FOLDER`` puts the essence of kept answers into
`answers.json`, which a test holds: of an older version, or of this one where an answer was meant to change. Whole
answers belong to one processor and one set of versions, so that only their essence is committed. ``--tree`` runs
the program of another checkout.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
import time
import tomllib
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from fnmatch import fnmatch
from pathlib import Path

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # of the processes that are started

from tests.frozen.answers import TOLERANCE, Answers, answered, differences, essence, intended
from tests.frozen.cases import ROOT, Case, cases

HERE = Path(__file__).parent
ANSWERS = HERE / "answers.json"


def main() -> int:
    """Run the command; return 0, or 1 where an answer differs."""
    parser = argparse.ArgumentParser(prog="python -m tests.frozen", description=(__doc__ or "").split("\n")[0])
    parser.add_argument("command", choices=("write", "compare", "commit"))
    parser.add_argument("folder", type=Path, help="where whole answers are kept")
    parser.add_argument("--only", default="*", help="pattern of the cases' names")
    parser.add_argument("--tree", type=Path, default=ROOT, help="checkout whose program is run")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--tolerance", type=float, default=TOLERANCE)
    parser.add_argument("--again", action="store_true", help="write: also what is there already")
    given = parser.parse_args()
    chosen = [case for case in cases() if fnmatch(case.name, given.only)]
    if given.command == "commit":
        commit(given.folder, chosen)
        return 0
    given.folder.mkdir(parents=True, exist_ok=True)
    if given.command == "write" and not given.again:
        chosen = [case for case in chosen if not (given.folder / f"{case.name}.json").exists()]
    bad = 0
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(given.jobs) as pool:

        def run(case: Case) -> tuple[Case, Answers, float]:
            start = time.perf_counter()
            return case, answered(case, Path(scratch) / case.name, given.tree), time.perf_counter() - start

        for done, (case, found, took) in enumerate(pool.map(run, chosen), 1):
            kept = given.folder / f"{case.name}.json"
            said = f"[{done}/{len(chosen)}] {case.name} {took:.1f} s"
            if given.command == "write":
                kept.write_text(json.dumps(found), encoding="utf-8")
                errors = [v for k, v in found.items() if k.startswith("error")]
                print(said, *errors, sep="\n    ", flush=True)
            else:
                lines = unlisted(case.name, json.loads(kept.read_text(encoding="utf-8")), found, given.tolerance)
                bad += bool(lines)
                print(said, *(lines[:20] or ["as before"]), sep="\n    ", flush=True)
    if given.command == "compare":
        print(f"{len(chosen) - bad} of {len(chosen)} cases answer as before")
    return int(bad > 0)


def unlisted(name: str, before: Answers, now: Answers, tolerance: float = TOLERANCE) -> list[str]:
    """Return the differences of a case that are not listed as intended."""
    # a round trip through JSON, so that what was kept and what was found are of the same types
    found = differences(before, json.loads(json.dumps(now)), tolerance)
    return [line for line in found if not intended(line, name, listed())]


def listed() -> list[dict[str, str]]:
    """Return the intended differences: pattern of the case, pattern of the place, reason."""
    entries: list[dict[str, str]] = tomllib.loads((HERE / "intended.toml").read_text(encoding="utf-8")).get(
        "change", []
    )
    if blank := [e for e in entries if not e.get("reason")]:
        raise ValueError(f"intended.toml: {blank[0]} gives no reason.")
    return entries


def commit(folder: Path, chosen: Iterable[Case]) -> None:
    """Put the essence of kept answers of simulated cases, rounded to 12 digits, into `answers.json`; others stay."""
    kept = json.loads(ANSWERS.read_text(encoding="utf-8")) if ANSWERS.exists() else {}
    for case in chosen:
        if not case.name.startswith(("concealed", "real")):
            found = json.loads((folder / f"{case.name}.json").read_text(encoding="utf-8"))
            short = json.dumps(essence(found))
            kept[case.name] = json.loads(short, parse_float=lambda text: float(f"{float(text):.12g}"))
    lines = [f"{json.dumps(name)}: {json.dumps(answer)}" for name, answer in kept.items()]
    ANSWERS.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")
    print(f"{len(kept)} cases in {ANSWERS.name}")


if __name__ == "__main__":
    sys.exit(main())
