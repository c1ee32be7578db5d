"""The proof: effects are concealed in simulated recordings, and the diagnosis is run blind on the files.

``python -m tests.proof [generate | grade] [--cases N] [--engine own,exudyn] [--seed S] [--tool CMD] [--jobs 2] -o DIR``

Without a step both are done, case by case; DIR then holds the cases, their truth, the answers, ``grades.json``,
``table.md`` and ``proof.html``; of cases in motion that ``tests.benchmarks.motion_blind`` kept in ``motion.jsonl``
there, the page has the table. README.md beside this file says how another tool takes the same test.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy is loaded

import argparse
import json
import multiprocessing
import shutil
import sys
from functools import partial
from pathlib import Path
from typing import Any

from rich.console import Console
from rich.progress import MofNCompleteColumn, Progress, TimeRemainingColumn

from deltacal_gen.errors import NoSolutionError
from deltacal_gen.machine.backend import Backend, using
from tests.benchmarks import motion_blind
from tests.benchmarks.concealed_cases import generate, plan
from tests.benchmarks.concealed_grading import oracle
from tests.proof import files, multibody, report
from tests.proof.engines import ENGINES, HAS
from tests.proof.grading import TOOL, answer, judge

SHARES = {"null": 0.25, "single": 0.45, "pair": 0.15, "outside": 0.15}
DEFAULT_CASES = 100
Job = tuple[str, str, str, tuple[str, ...], tuple[int, ...], str]


def jobs(cases: int, engines: list[str], seed: int) -> list[Job]:
    """Return what is to be drawn, (name, engine, kind, names, seed, machine): as many of each engine."""
    drawn = []
    for engine in engines:
        part = cases // len(engines)
        counts = {kind: round(share * part) for kind, share in SHARES.items()}
        counts["single"] = part - sum(n for kind, n in counts.items() if kind != "single")
        own = seed * len(ENGINES) + list(ENGINES).index(engine)
        drawn += [(engine, *job) for job in plan(counts, own, HAS[engine])]
    order = sorted(range(len(drawn)), key=lambda i: (i % max(len(drawn) // len(engines), 1), i))  # engines in turn
    return [(f"c{n + 1:03d}", *drawn[i]) for n, i in enumerate(order)]


@using(Backend.COMPILED)
def conceal(job: Job, folder: Path) -> None:
    """Draw the case of a job and write its files."""
    name, engine, *of = job
    case = generate(*of, by=ENGINES[engine])
    try:
        ideal = oracle(case)
    except NoSolutionError:
        ideal = None
    files.write(files.Concealed(name, engine, case, ideal), folder)


def examine(name: str, folder: Path, tool: str) -> dict[str, Any]:
    """Run a tool on a case and return its entry of the table."""
    output = folder / "answers" / name
    ran = answer(folder / "cases" / name, output, tool)
    return judge(files.read(folder, name), output, ran)


def _work(job: Job | str, folder: Path, tool: str, steps: str) -> dict[str, Any]:
    name, about = (job, "") if isinstance(job, str) else (job[0], f" ({job[1]}, {job[2]} {' + '.join(job[3])})")
    try:
        if not isinstance(job, str):
            conceal(job, folder)
        return {"name": name} if steps == "generate" else examine(name, folder, tool)
    except Exception as error:  # a long run goes on, and says which cases it has not
        return {"name": name, "skipped": f"{name}{about}: {type(error).__name__}: {error}"}


def main(arguments: list[str] | None = None) -> int:
    """Conceal, diagnose, grade, and write the table and the page."""
    parser = argparse.ArgumentParser(prog="python -m tests.proof", description=__doc__.split("\n")[0])
    parser.add_argument("step", nargs="?", choices=("all", "generate", "grade"), default="all")
    parser.add_argument("-o", "--output", type=Path, default=Path("proof"), metavar="DIR")
    parser.add_argument("--cases", type=int, default=DEFAULT_CASES, help=f"in all (default {DEFAULT_CASES})")
    parser.add_argument("--engine", default=",".join(ENGINES), help="who simulates: own, exudyn, or both")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--tool", default=TOOL, help="command line before 'diagnose' and 'predict' (default deltacal)")
    parser.add_argument("--jobs", type=int, default=2, help="processes")
    parser.add_argument("--measured", action="store_true", help="write the manual's tables too")
    given = parser.parse_args(arguments)
    engines = given.engine.split(",")
    if unknown := set(engines) - set(ENGINES):
        parser.error(f"no such engine: {', '.join(sorted(unknown))}; there are {', '.join(ENGINES)}")
    if "exudyn" in engines and given.step != "grade" and not multibody.available():
        parser.error("Exudyn is not installed: pip install '.[proof]', or give --engine own")
    folder: Path = given.output
    work: list[Any] = files.names(folder) if given.step == "grade" else jobs(given.cases, engines, given.seed)
    if not work:
        parser.error(f"{folder} holds no cases: generate them first")
    for part in ("answers",) if given.step == "grade" else ("cases", "truth", "answers"):
        shutil.rmtree(folder / part, ignore_errors=True)
    run = folder / "run.json"
    if given.step != "grade":
        folder.mkdir(parents=True, exist_ok=True)
        versions = {e: multibody.version() if e == "exudyn" else "deltacal_gen" for e in engines}
        run.write_text(json.dumps({"seed": given.seed, "engines": versions}) + "\n", encoding="utf-8")
    console, found, skipped = Console(stderr=True), [], 0
    columns = (*Progress.get_default_columns()[:2], MofNCompleteColumn(), TimeRemainingColumn())
    with Progress(*columns, console=console) as progress, multiprocessing.Pool(given.jobs) as pool:
        task = progress.add_task(given.step if given.step != "all" else "conceal, diagnose, grade", total=len(work))
        for entry in pool.imap_unordered(partial(_work, folder=folder, tool=given.tool, steps=given.step), work):
            progress.advance(task)
            if "skipped" in entry:
                skipped += 1
                progress.console.print(entry["skipped"], markup=False, highlight=False)
            else:
                found.append(entry)
    if given.step == "generate":
        console.print(f"{len(found)} cases in {folder}", highlight=False)
        return 0
    found.sort(key=lambda entry: entry["name"])
    command = " ".join(["python -m tests.proof", *(sys.argv[1:] if arguments is None else arguments)])
    said = json.loads(run.read_text(encoding="utf-8")) | {"cases": len(found), "skipped": skipped, "command": command}
    (folder / "grades.json").write_text(json.dumps({"run": said, "cases": found}, indent=1) + "\n", encoding="utf-8")
    moving = motion_blind.kept(folder / "motion.jsonl")
    text = report.markdown(found, said)
    (folder / "table.md").write_text(text, encoding="utf-8")
    (folder / "proof.html").write_text(report.page(found, said, moving), encoding="utf-8")
    if given.measured:
        report.measured(found, said)
    print(text)
    for line in report.failures(found):
        print(line)
    console.print(f"written: {folder / 'proof.html'}, table.md, grades.json", highlight=False)
    return 0


if __name__ == "__main__":
    sys.exit(main())
