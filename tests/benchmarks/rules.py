"""What each rule of the diagnosis is worth: ``python -m tests.benchmarks.rules [--seed S] [--quick]``.

A rule is a function that changes the course of a diagnosis in some cases and is idle in all others: a veto that says
no, a search that returns what it was given. Each concealed case is diagnosed once with every rule watched, then once
again for every rule that fired, with that rule switched off. That is exact: a rule that was idle in all its calls has
changed nothing. Compared are the answer (verdict, names, places), whether it is right, and the error of its predictions
on fresh readings. Half of the cases are orderly ones of `concealed_cases`, half are those of `dirty_sessions`.

The table says how often each rule fired, how many answers changed without it, how many of these were right with it and
without it, and the ratio of the prediction errors. ``--kept`` goes on where a run was ended.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy is loaded

import argparse
import importlib
import pkgutil
import sys
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from typing import Any
from unittest import mock

import numpy as np
from rich.console import Console
from rich.table import Table

import deltacal_gen
from tests.benchmarks import concealed_cases, dirty
from tests.benchmarks.concealed_grading import Job, examine
from tests.benchmarks.sitting import add_options, sit

MACHINES = ("delta", "linear_delta", "hexapod", "serial")
COUNTS = {"null": 10, "single": 16, "pair": 8, "outside": 8}  # of orderly and of dirty cases, each
QUICK = 4  # a part of the cases
ALIKE = 0.02  # prediction errors that differ by less are the same


@dataclass(frozen=True)
class Rule:
    """A function, or a property of a class, and what it returns where it is idle.

    Attributes
    ----------
    place : str
        ``module:function`` or ``module:Class.property``, without the package.
    idle : object
        What it returns where it changes nothing.
    given : int, optional
        The place of the argument that it returns where it is idle, instead of `idle`.
    """

    place: str
    idle: Any = None
    given: int | None = None

    @property
    def name(self) -> str:
        """The function's name behind its module's."""
        module, _, name = self.place.partition(":")
        return f"{module.rpartition('.')[2]}.{name.lstrip('_')}"

    def returned(self, arguments: Sequence[Any]) -> Any:
        """Return what the rule answers where it is idle."""
        return self.idle if self.given is None else arguments[self.given]

    def fired(self, answer: Any, arguments: Sequence[Any]) -> bool:
        """Tell whether an answer changes anything."""
        if self.given is not None:
            return answer is not arguments[self.given]
        return answer is not None if self.idle is None else bool(answer) is not self.idle


RULES = (
    *(Rule(f"diagnosis.diagnosis:{name}", given=0) for name in ("_without_walks", "_less_sign")),
    Rule("diagnosis.diagnosis:_without_refuted", given=1),
    Rule("diagnosis.diagnosis:_as_is_known", given=1),
    Rule("diagnosis.diagnosis:_left_beside", False),
    Rule("diagnosis.findings:turned_by"),
    Rule("diagnosis.findings:only_turned", False),
    Rule("diagnosis.strategy:_proven", given=1),
    Rule("diagnosis.strategy:_structureless", False),
    Rule("diagnosis.strategy:_spectrum"),
    Rule("diagnosis.strategy:borne_out", True),
    Rule("diagnosis.evidence:Evidence.speaks", True),
    Rule("diagnosis.evidence:Evidence.denies", False),
    Rule("diagnosis.evidence:Evidence.falls_short", False),
    Rule("diagnosis.correction:borne_out_beside"),
    Rule("identification.functions:confirmed", True),
    Rule("diagnosis.refits:_correlated"),
    Rule("diagnosis.refits:believable", given=1),
    Rule("diagnosis.scattering:scattering"),
    Rule("diagnosis.spectrum:periodic"),
    Rule("diagnosis.library:_spoilt"),
    Rule("diagnosis.library:unseen", False),
    Rule("diagnosis.laws.laws:_by_walks", False),
    Rule("diagnosis.laws.laws:_needed", given=1),
    Rule("diagnosis.laws.remainder:with_remainder", given=0),
    Rule("diagnosis.laws.screen:stands_out", True),
    Rule("diagnosis.laws.search:_longer"),
    *(Rule(f"diagnosis.laws.search:{name}", given=1) for name in ("shaped_all", "polished", "placed")),
    Rule("identification.outliers:_all_but_one"),
    Rule("identification.outliers:without_knocked"),
    Rule("identification.drawing:as_read"),
    Rule("identification.drawing:strained", False),
    Rule("identification.noise:merely_more", False),
    Rule("identification.noise:doubted", given=0),
    Rule("identification.noise:with_tails", given=0),
    Rule("identification.noise:alike_at_a_pose", False),
    Rule("identification.outliers:without_overflow"),
    Rule("identification.together:together"),
    Rule("identification.together:common"),
    Rule("identification.together:without_following"),
    Rule("identification.together:better_alone"),
    Rule("identification.together:as_predicts", given=0),
    Rule("estimation.directions:shape_of"),
    Rule("estimation.saddles:unforeseen", False),
    Rule("estimation.fit:_shared_noise"),
)


def modules() -> list[Any]:
    """Return all modules of the package, loaded."""
    found = pkgutil.walk_packages(deltacal_gen.__path__, "deltacal_gen.")
    names = [m.name for m in found if not m.name.startswith(("deltacal_gen.manual", "deltacal_gen.app.cli.__main__"))]
    return [importlib.import_module(name) for name in names]


def original(rule: Rule) -> Any:
    """Return the function of a rule, or the property; raises AttributeError where there is none by its name."""
    module, _, name = rule.place.partition(":")
    owner: Any = importlib.import_module(f"deltacal_gen.{module}")
    *path, last = name.split(".")
    for part in path:
        owner = getattr(owner, part)
    return vars(owner)[last]


@contextmanager
def replaced(rule: Rule, by: Callable[[Callable[..., Any]], Callable[..., Any]]) -> Iterator[None]:
    """Let a function stand for a rule, wherever the program has imported it."""
    real = original(rule)
    with ExitStack() as stack:
        if isinstance(real, property):
            assert real.fget is not None
            module, _, name = rule.place.partition(":")
            owner = getattr(importlib.import_module(f"deltacal_gen.{module}"), name.split(".")[0])
            stack.enter_context(mock.patch.object(owner, name.split(".")[1], property(by(real.fget))))
        else:
            changed = by(real)
            for module_ in modules():
                for name in [n for n, value in vars(module_).items() if value is real]:
                    stack.enter_context(mock.patch.object(module_, name, changed))
        yield


@contextmanager
def watched(fired: Counter[str]) -> Iterator[None]:
    """Count the calls in which each rule changes something."""

    def counting(rule: Rule) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
        def wrap(real: Callable[..., Any]) -> Callable[..., Any]:
            def run(*arguments: Any, **named: Any) -> Any:
                answer = real(*arguments, **named)
                fired[rule.name] += rule.fired(answer, arguments)
                return answer

            return run

        return wrap

    with ExitStack() as stack:
        for rule in RULES:
            stack.enter_context(replaced(rule, counting(rule)))
        yield


@contextmanager
def switched_off(rule: Rule) -> Iterator[None]:
    """Let a rule be idle."""
    with replaced(rule, lambda real: lambda *arguments, **named: rule.returned(arguments)):
        yield


def essence(entry: dict[str, Any]) -> dict[str, Any]:
    """Return what of a graded answer is compared: what it says, whether that is right, and its prediction's error."""
    said = [
        entry.get("verdict"),
        sorted([name, limbs, constants] for name, limbs, constants, *_ in entry.get("found", [])),
    ]
    return {"said": said, "right": not entry["wrong"], "error": entry.get("to_geometry"), "wrong": entry["wrong"]}


def priced(job: tuple[Any, ...]) -> dict[str, Any]:
    """Return the answer of a case with all rules, and without each of those that fired."""
    sort, *rest = job
    case: Job = (rest[0], tuple(rest[1]), tuple(rest[2]), rest[3])
    draw = dirty.drawn if sort == "dirty" else concealed_cases.generate
    fired: Counter[str] = Counter()
    with watched(fired):
        entry = examine(case, draw)
    if "skipped" in entry:
        return {"skipped": entry["skipped"]}
    out = {"sort": sort, "kind": entry["kind"], "names": entry["names"], "with": essence(entry), "without": {}}
    for rule in (rule for rule in RULES if fired[rule.name]):
        with switched_off(rule):
            out["without"][rule.name] = essence(examine(case, draw))
    return out


def jobs(seed: int, part: int = 1) -> list[tuple[Any, ...]]:
    """Return the cases of a seed, orderly and dirty ones by turns."""
    out: list[tuple[Any, ...]] = []
    for number, machine in enumerate(MACHINES):
        counts = {k: len(range(number, n // part, len(MACHINES))) for k, n in COUNTS.items()}
        only = dirty.usable(machine)
        orderly = [("orderly", *job) for job in concealed_cases.plan(counts, seed + number, only, machine)]
        messy = [("dirty", *job) for job in concealed_cases.plan(counts, 1000 + seed + number, only, machine)]
        out += [job for both in zip(orderly, messy, strict=True) for job in both]
    return [out[i] for i in np.random.default_rng(seed).permutation(len(out))]


def table(found: Sequence[dict[str, Any]]) -> Table:
    """Return what each rule did, those that decide most first."""
    out = Table("rule", title=f"{len(found)} cases: each rule switched off where it fired")
    for head in ("fired in", "answers changed", "right with it", "right without", "predicts better with", "without"):
        out.add_column(head, justify="right")
    rows = []
    for rule in RULES:
        pairs = [(f["with"], f["without"][rule.name]) for f in found if rule.name in f["without"]]
        changed = [(a, b) for a, b in pairs if a["said"] != b["said"]]
        ratios = [b["error"] / a["error"] for a, b in pairs if a["error"] and b["error"]]
        figures = (
            len(pairs),
            len(changed),
            sum(a["right"] and not b["right"] for a, b in pairs),
            sum(b["right"] and not a["right"] for a, b in pairs),
            sum(ratio > 1 + ALIKE for ratio in ratios),
            sum(ratio < 1 - ALIKE for ratio in ratios),
        )
        rows.append((figures, rule.name))
    for figures, name in sorted(rows, key=lambda row: (-row[0][1], -row[0][0], row[1])):
        out.add_row(name, *map(str, figures))
    return out


def main(arguments: list[str] | None = None) -> int:
    """Price the rules and print the table."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.rules", description=__doc__.split("\n")[0])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--quick", action="store_true", help=f"one case of {QUICK}")
    add_options(parser)
    given = parser.parse_args(arguments)
    sitting = sit(priced, jobs(given.seed, QUICK if given.quick else 1), given)
    found = [entry for entry in sitting.done.values() if "skipped" not in entry]
    Console(width=None if sys.stdout.isatty() else 150).print(table(found))
    print(f"{sum(f['with']['right'] for f in found)} of {len(found)} right with all rules")
    return sitting.code


if __name__ == "__main__":
    sys.exit(main())
