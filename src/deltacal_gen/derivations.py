"""Reports of a derivation, for reviewers: from the closure equations to the committed kernels, and what checks them.

The mathematics comes from ``derive.account``, which runs in a process of its own: nothing here knows SymPy. Beside it
stand the claims of the papers, ranks and numerical checks that are computed when the report is made, and the sources
themselves, so that every equation leads to its line without a network. A report says nothing of when or where it was
made: the same sources and versions give the same bytes.
"""

from __future__ import annotations

import ast
import hashlib
import importlib.metadata
import json
import os
import platform
import re
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache, partial
from importlib import resources
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from deltacal_gen import checks, sketch
from deltacal_gen.errors import UsageError
from deltacal_gen.files.robot import Robot, for_model, read_robot
from deltacal_gen.identification.identifiability import RANK_TOLERANCE
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import (
    COORDINATES,
    Machine,
    load_mechanism,
    mechanism_names,
    mechanism_of,
)
from deltacal_gen.machine.rotation import cayley_vector
from deltacal_gen.pages import ledger, report
from deltacal_gen.pages.figures import AFTER, BEFORE, MUTED, decades
from deltacal_gen.physics.physics import effect_names, lacking, load_effect
from deltacal_gen.units import file_unit, to_internal

KERNELS = "generated/deltacal_kernels"
RUNTIME = tuple(f"src/deltacal_gen/{name}.py" for name in ("machine/limbs", "physics", "measurement", "chain"))
VERSIONS = ("numpy", "scipy", "matplotlib")


# ------------------------------------------------------------------------------------------------------ what there is


@dataclass(frozen=True)
class Common:
    """What `derive.account` says of all that reports of machines have in common.

    `chain`: how an effect reaches a reading; `formulas`: the words and formulas, in turn, of a text of the ledger.
    """

    measurements: Sequence[Mapping[str, Any]]
    effects: Sequence[Mapping[str, Any]]
    chain: Sequence[Mapping[str, Any]]
    formulas: Mapping[str, Sequence[Any]]


@dataclass(frozen=True)
class Subject:
    """What a report is on: a model of a mechanism, or an effect.

    Attributes
    ----------
    name : str
        ``delta/42`` or ``backlash``.
    mechanism : str
        Registered name; empty for an effect.
    """

    name: str
    mechanism: str

    @property
    def stem(self) -> str:
        """Name of its file."""
        return self.name.replace("/", "-") if self.mechanism else f"effect-{self.name}"


def subjects() -> list[Subject]:
    """Return all models of all mechanisms, and all effects."""
    models = [Subject(model, name) for name in mechanism_names() for model in _models(name)]
    return [*models, *(Subject(name, "") for name in effect_names())]


def subject(name: str) -> Subject:
    """Return what `name` means: a model, a mechanism (then its largest model) or an effect.

    Raises
    ------
    UsageError
        There is no such thing.
    """
    every = subjects()
    named = [s for s in every if s.name == name] or [s for s in every if s.mechanism == name]
    if not named:
        known = ", ".join(s.name for s in every)
        raise UsageError(f"there is no model, mechanism or effect '{name}'; known: {known}.")
    return named[0]


@cache
def _models(mechanism: str) -> tuple[str, ...]:
    """Return the models of a mechanism; those of a chain are its robot file's."""
    robot = example(mechanism)
    return tuple(mechanism_of(robot).models if robot is not None else load_mechanism(mechanism).models)


@cache
def example(mechanism: str) -> Robot | None:
    """Return the machine of an example's robot file as a mechanism describes it, or None where there is no example."""
    tables = importlib.import_module(f"deltacal_kernels.{mechanism}.parameters")
    machine = getattr(tables, "MACHINE", mechanism)
    folder = Path(str(resources.files("deltacal_gen") / "examples"))
    for file in sorted(folder.glob("*/robot.toml"), key=lambda f: (f.parent.name != machine, f.parent.name)):
        robot = read_robot(file)
        if robot.mechanism == mechanism:
            return robot
        if robot.mechanism == machine:
            return for_model(robot, next(iter(load_mechanism(mechanism).models)))
    return None


# ------------------------------------------------------------------------------------------------------- the accounts


def accounts(requests: Sequence[Mapping[str, Any]], root: Path) -> Iterator[dict[str, Any]]:
    """Yield what `derive.account` answers, request by request; it works while the caller does."""
    command = [sys.executable, "-m", "derive.account"]
    environment = {**os.environ, "PYTHONHASHSEED": "0"}
    with subprocess.Popen(
        command, cwd=root, env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, encoding="utf-8"
    ) as process:
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.write(json.dumps(list(requests)))
        process.stdin.close()
        for line in process.stdout:
            yield json.loads(line)
    if process.returncode:
        raise RuntimeError("the derivation's account ended early; its message is above.")


def request(one: Subject) -> dict[str, Any]:
    """Return what to ask for: the machine's numbers at one pose, so that it can be drawn."""
    if not one.mechanism:
        return {"effect": one.name}
    robot = example(one.mechanism)
    return {"mechanism": one.mechanism} if robot is None else asked(robot)


def asked(robot: Robot) -> dict[str, Any]:
    """Return what to ask of a machine: the account of its mechanism, with its numbers at one pose."""
    asked: dict[str, Any] = {"mechanism": robot.mechanism}
    mechanism, pose = mechanism_of(robot), checks.middle(robot)
    if robot.links:
        lengths = {key: np.asarray(values).tolist() for key, values in robot.geometry.items()}
        asked["links"] = [
            {"kind": link.kind, "convention": link.convention, **{key: values[k] for key, values in lengths.items()}}
            for k, link in enumerate(robot.links)
        ]
        asked["common"] = [
            {"name": p.name, "unit": p.unit, "meaning": p.meaning, "typical": p.typical}
            for p in mechanism.parameters
            if not p.limb
        ]
        return asked | {"tool": np.asarray(robot.tool).tolist(), "models": mechanism.models}
    body = np.concatenate([pose.x[0, :3], cayley_vector(pose.x[:, 3:].reshape(-1, 3, 3))[0]])
    asked["at"] = {
        "x": [float(body[COORDINATES.index(name)]) for name in mechanism.platform],
        "q": pose.q[0].tolist(),
        "tool": np.asarray(robot.tool).tolist(),
        "rows": mechanism.rows(robot)[0].tolist(),
    }
    asked["numbers"] = {key: np.asarray(values).tolist() for key, values in robot.geometry.items()}
    return asked


# -------------------------------------------------------------------------------------------------------- the sources


class Sources:
    """The files of the checkout that a report leads to, and the lines it leads to in them.

    Parameters
    ----------
    root : path
        Of the checkout.
    """

    def __init__(self, root: Path) -> None:
        self.root = root
        self._texts: dict[str, str] = {}
        self._wanted: dict[str, set[int]] = {}

    def text(self, file: str) -> str:
        """Return a file's text."""
        if file not in self._texts:
            self._texts[file] = (self.root / file).read_text(encoding="utf-8")
        return self._texts[file]

    def at(self, file: str, line: int) -> dict[str, Any]:
        """Return a place to lead to: its text, and the name of its anchor."""
        self._wanted.setdefault(file, set()).add(line)
        return {"file": file, "line": line, "text": f"{file}:{line}", "anchor": _anchor(file, line)}

    def functions(self, file: str) -> dict[str, ast.FunctionDef]:
        """Return the functions of a file, those of a class by ``Class.name``."""
        return _functions(self.text(file))

    def listings(self) -> list[dict[str, Any]]:
        """Return what the report embeds: a mechanism or an effect whole, of other files the functions in question."""
        found = []
        for file in sorted(self._wanted):
            lines, wanted = self.text(file).splitlines(), sorted(self._wanted[file])
            spans = [(1, len(lines))]
            if file.endswith(".jinja"):
                spans = [(n, _paragraphs(lines, n)) for n in wanted]
            elif not file.startswith(("derive/mechanisms", "derive/effects", "derive/measurements")):
                nodes = self.functions(file).values()
                first = [min([node.lineno, *(d.lineno for d in node.decorator_list)]) for node in nodes]
                every = [(a, node.end_lineno or a) for a, node in zip(first, nodes, strict=True)]
                spans = [(a, b) for a, b in every if any(a <= line <= b for line in wanted)]
            found.append(
                {
                    "file": file,
                    "parts": [
                        [
                            {"number": n, "text": lines[n - 1], "anchor": _anchor(file, n) if n in wanted else ""}
                            for n in range(a, b + 1)
                        ]
                        for a, b in spans
                    ],
                }
            )
        return found

    def digest(self, file: str) -> str:
        """Return the SHA-256 of a file's bytes."""
        return hashlib.sha256(self.text(file).encode()).hexdigest()


@cache
def _functions(text: str) -> dict[str, ast.FunctionDef]:
    found = {}
    for node in ast.parse(text).body:
        if isinstance(node, ast.FunctionDef):
            found[node.name] = node
        elif isinstance(node, ast.ClassDef):
            found |= {f"{node.name}.{f.name}": f for f in node.body if isinstance(f, ast.FunctionDef)}
    return found


def _paragraphs(lines: Sequence[str], first: int) -> int:
    """Return the last line of a function in a template: two empty lines follow it."""
    return next(
        (n for n in range(first, len(lines) - 1) if not lines[n].strip() and not lines[n + 1].strip()), len(lines)
    )


def _anchor(file: str, line: int) -> str:
    return f"{re.sub(r'[^a-z0-9]+', '-', file.lower())}-{line}"


@dataclass(frozen=True)
class Assigned:
    """A named value in a kernel: its line, its operations as they stand and written out."""

    line: int
    operations: int
    written_out: int


@dataclass(frozen=True)
class Kernel:
    """A straight-line function of the generated package, counted in its committed text.

    `operations`: of its statements, common subexpressions once; `written_out`: of its outputs with every name replaced
    by what it stands for, down to the inputs.
    """

    name: str
    file: str
    line: int
    meaning: str
    outputs: int
    operations: int
    written_out: int
    assigned: Mapping[str, Assigned]


def kernels(sources: Sources, file: str) -> list[Kernel]:
    """Return the straight-line functions of a generated file, of one limb too; constants count in what reads them."""
    shared: dict[str, int] = {}
    constants: dict[tuple[str, str], int] = {}  # of commands of one pose, by kind and name: they lie in w with all else
    found = []
    for name, node in sources.functions(file).items():
        kind = name.lstrip("_").split("_")[0]
        inside = [a.arg for a in node.args.args][:1] == ["w"]
        out = "k" if name.endswith("constants") else "w" if inside else "out"
        body = [s for part in node.body for s in (part.body if inside and isinstance(part, ast.For) else [part])]
        if any(isinstance(s, ast.For | ast.While | ast.If) for s in body):
            continue
        sizes: dict[str, int] = {}
        assigned: dict[str, Assigned] = {}
        operations = outputs = written_out = 0
        for statement in body:
            if not isinstance(statement, ast.Assign):
                continue
            target = statement.targets[0]
            if inside and isinstance(target, ast.Name) and isinstance(statement.value, ast.Subscript):
                sizes[target.id] = constants.get((kind, target.id), 0)
                continue  # reads a place of w
            if isinstance(target, ast.Name) and target.id == out:
                continue  # makes the array
            own, whole = _size(statement.value, sizes, shared if out == "out" else {})
            operations += own
            if isinstance(target, ast.Name):
                sizes[target.id] = whole
                assigned[target.id] = Assigned(statement.lineno, own, whole)
            elif isinstance(target, ast.Subscript) and isinstance(target.value, ast.Name) and target.value.id == out:
                outputs += 1
                written_out += whole
                if out == "k":
                    shared[_index(target)] = whole
                    if name.startswith("_") and isinstance(statement.value, ast.Name):
                        constants[kind, statement.value.id] = whole
        if outputs and operations:
            doc = (ast.get_docstring(node) or "").split("\n")[0]
            doc = re.sub(r"^Return k \(.*?\), (.*), from p \(.*", lambda m: m[1][0].upper() + m[1][1:], doc)
            doc = doc.split(" (")[0].rstrip(".:")
            found.append(Kernel(name, file, node.lineno, doc, outputs, operations, written_out, assigned))
    return found


def _table_of(used: Sequence[Kernel], sources: Sources) -> list[dict[str, Any]]:
    return [
        {
            "name": k.name,
            "meaning": k.meaning,
            "outputs": k.outputs,
            "operations": k.operations,
            "written_out": k.written_out,
            "at": sources.at(k.file, k.line),
        }
        for k in used
    ]


def _index(node: ast.Subscript) -> str:
    return ast.unparse(node.slice).split(", ")[-1].rstrip(")")


def _size(node: ast.expr, sizes: Mapping[str, int], shared: Mapping[str, int]) -> tuple[int, int]:
    """Return the operations of an expression as it stands, and with its names written out."""
    own = whole = 0
    for part in ast.walk(node):
        if isinstance(part, ast.BinOp | ast.Call) or (isinstance(part, ast.UnaryOp) and isinstance(part.op, ast.USub)):
            own += 1
        elif isinstance(part, ast.Name):
            whole += sizes.get(part.id, 0)
        elif isinstance(part, ast.Subscript) and isinstance(part.value, ast.Name) and part.value.id == "k":
            whole += shared.get(_index(part), 0)
    return own, own + whole


# --------------------------------------------------------------------------------------------------------- the report


def content(one: Subject, account: Mapping[str, Any], root: Path, common: Common) -> dict:
    """Return all that a report of a model shows, for either format.

    Parameters
    ----------
    account : mapping
        What `derive.account` says of the mechanism.
    common : Common
        What it says of measurements, effects and the papers.
    """
    sources, robot, account = Sources(root), example(one.mechanism), dict(account)
    found: dict[str, Any] = {
        "subject": one.name,
        "mechanism": one.mechanism,
        "what": account["title"],
        "reference": account["reference"],
        "conventions": account["docstring"],
        "robot": robot.name if robot is not None else None,
        "account": account,
        "rank_tolerance": RANK_TOLERANCE,
    }
    for part in (
        *account["steps"],
        *account.get("where", ()),
        *account.get("rotations", ()),
    ):
        part["at"] = sources.at(**part["place"])
    for part in (*account.get("closures", ()), *account.get("weights", ()), *account.get("seeds", ())):
        part["at"] = sources.at(**part["place"]) if part["place"] else None
    files = [f"{KERNELS}/{one.mechanism}/{name}.py" for name in ("vectorised", "servo", "statics", "links")]
    every = [k for file in files if (root / file).exists() for k in kernels(sources, file)]
    used = list({k.name: k for k in reversed(every)}.values())[::-1]  # what stands in two files, from the first
    for step in account["steps"]:
        step["ends"] = _ends(step, used, sources)
    folder = f"{KERNELS}/{one.mechanism}"
    for key in ("implicit", "statics", "links"):
        account[key] = [_led(part, used, sources, folder) for part in account.get(key, ())]
    account["gradient"] = _led(account["gradient"], used, sources, folder)
    found["kernels"] = _table_of(used, sources)
    found["measurements"] = [{**m, "at": sources.at(**m["place"])} for m in common.measurements]
    found["claims"] = _claims(account["reference"], common.formulas)
    found["effects"] = [_effect_on(e, one.mechanism, sources) for e in common.effects]
    found["effect_chain"] = [_led(part, used, sources, folder) for part in common.chain]
    if robot is not None:
        found |= _in_numbers(one, robot, account)
    else:
        found |= {"machine": None, "tables": _tables(account, None, (), None), "checks": None, "ranks": []}
    found["dimensions"] = _dimensions(account)
    found["short"] = _short(found, used)
    found["listings_"] = sources.listings()
    stages = [f"derive/{name}.py" for name in ("vectors", "graph", "lower", "compiler")]
    written = [account["source"], *stages, *(f for f in files if (root / f).exists())]
    found["provenance"] = _provenance(one, sources, written, account)
    return found


def _short(found: Mapping[str, Any], used: Sequence[Kernel]) -> list[dict[str, str]]:
    """Return the report in a few sentences, each with the section that bears it out."""
    account, claims, ranks, checked = found["account"], found["claims"], found["ranks"], found["checks"]
    lines: list[tuple[str, str, str]] = []
    if account["kind"] == "limbs":
        limbs, closures, x = account["limbs"], len(account["closures"]), len(account["tables"]["platform"])
        many = f"{limbs} limbs of {closures}" if limbs > 1 else f"{closures}"
        what = f"{many} closure equation{'s' if closures > 1 else ''} for {x} coordinates of the platform"
    else:
        what = "one link, derived once in either convention, and composed as the robot file says"
    steps = f"; {len(account['steps'])} named steps lead to them" if account["steps"] else ""
    parameters = f"; {ranks[0]['columns']} source errors in {found['subject']}" if ranks else ""
    lines.append(("Model", "equations", f"{what}{steps}{parameters}."))
    if claims:
        equations, wrong = claims["equations"], [c for c in claims["equations"] if c["status"] == "contradicted"]
        as_printed = sum(c["status"] in ("proved", "verified") for c in equations)
        says = f"{as_printed} of {len(equations)} entries on numbered equations hold as printed"
        says += f"; corrected: {', '.join(c['where'] for c in wrong)}" if wrong else ""
        others = len(equations) - as_printed - len(wrong)
        says += f"; left to a convention or undecided: {others}" if others else ""
        rest = claims["others"]
        no = sum(c["status"] == "contradicted" for c in rest)
        lines.append(("Paper", "paper", f"{says}; contradicted of {len(rest)} other statements: {no}."))
    if ranks:
        seen = next((r for r in ranks if r["motions"] == "unknown frame, one point"), ranks[0])
        says = f"positions of one point in an unknown frame see {seen['rank']} of {seen['columns']} parameters"
        if seen["free"]:
            says += "; the others are named, in closed form" if seen["closed"] else "; the others are named"
        lines.append(("Identifiability", "identifiability", f"{says}."))
    if checked:
        by = ", ".join(f"{o['order']} by {o['by']}" for o in checked["orders"])
        says = f"what first order leaves shrinks with the step to the power {by} (2 is right)"
        lines.append(
            ("Derivatives", "checks", f"{says}; of ordinary errors in all parameters it leaves {checked['share']} %.")
        )
    if used:
        most = max(used, key=lambda k: k.written_out)
        says = (
            f"{len(used)} straight-line kernels; the longest, {most.name.lstrip('_')}, has {_count(most.written_out)}"
        )
        says += f" operations written out and {_count(most.operations)} as it stands"
        lines.append(("Kernels", "kernels", f"{says}."))
    return [{"what": what, "at": at, "says": says[0].upper() + says[1:]} for what, at, says in lines]


def _count(n: int) -> str:
    return f"{n:,}".replace(",", " ")


def _dimensions(account: Mapping[str, Any]) -> str:
    if account["kind"] != "limbs":
        return ""
    limbs, tables = account["limbs"], account["tables"]
    f, x = limbs * len(account["closures"]), len(tables["platform"])
    own, common = len(tables["errors"]), len(tables["common"])
    p = limbs * own + common
    per_limb = own + common + len(tables["deflections"])
    return (
        f"F has {f} entries, x {x}, q {limbs} and p {p}; J_x is {f} by {x}, J_q {f} by {limbs}, J_p {f} by {p}. A row "
        f"of them holds what its own limb moves: {x} + 1 + {per_limb} derivatives"
    )


def _ends(step: Mapping[str, Any], used: Sequence[Kernel], sources: Sources) -> dict[str, Any] | None:
    """Return where the generated code evaluates a step, or None where it is an input under another name."""
    for kernel in used:
        found = [kernel.assigned[name] for name in step["entries"] if name in kernel.assigned]
        if found:
            return {
                "kernel": kernel.name.lstrip("_"),
                "operations": sum(a.operations for a in found),
                "written_out": sum(a.written_out for a in found),
                **sources.at(kernel.file, min(a.line for a in found)),
            }
    return None


def _led(part: Mapping[str, Any], used: Sequence[Kernel], sources: Sources, folder: str) -> dict[str, Any]:
    """Return where a formula is made, and the functions in which it ends: kernels with their operations."""
    ends: list[dict[str, Any]] = []
    for name in part["ends"]:
        kernel = next((k for k in used if k.name.lstrip("_") == name), None)
        if kernel is not None:
            counts = {"operations": kernel.operations, "written_out": kernel.written_out}
            ends.append({"kernel": name, **counts, **sources.at(kernel.file, kernel.line)})
            continue
        for file in (f"{folder}/vectorised.py", f"{folder}/links.py", *RUNTIME):
            functions = sources.functions(file) if (sources.root / file).exists() else {}
            if name in functions:
                ends.append({"kernel": name, "operations": None, **sources.at(file, functions[name].lineno)})
                break
    return {**part, "at": sources.at(**part["place"]) if part.get("place") else None, "led": ends}


def _in_numbers(one: Subject, robot: Robot, account: Mapping[str, Any]) -> dict[str, Any]:
    """Return what one machine shows: its drawing, nominal values, ranks and checks."""
    mechanism = mechanism_of(robot)
    names = mechanism.models[one.name]
    with using(Backend.NUMPY):
        return {
            "machine": drawn(robot, account),
            "tables": _tables(account, robot, names, mechanism),
            "ranks": _ranks(one, robot, names, account),
            "checks": _checked(one, robot, names),
        }


@cache
def _trials(mechanism: str) -> checks.Trials:
    robot = example(mechanism)
    assert robot is not None
    return checks.trials(robot)


@cache
def _converging(mechanism: str) -> dict[str, Any]:
    """Return the orders of convergence of a mechanism's derivatives, which all its models share, and their picture."""
    robot = example(mechanism)
    assert robot is not None
    orders = checks.orders(robot, _trials(mechanism).poses)
    return {
        "orders": [{"by": o.by, "order": f"{o.order:.3f}", "gap": f"{o.gaps[-1] * 1000:.2g}"} for o in orders],
        "orders_picture": report.picture(partial(_orders, found=orders), (4.4, 3.0)),
    }


def drawn(robot: Robot, account: Mapping[str, Any]) -> str:
    """Return the drawing of a machine in the middle of its workspace."""
    mechanism = mechanism_of(robot)
    if account.get("drawing"):
        return sketch.machine(account["drawing"], mechanism.axes)
    pose = checks.middle(robot)
    origins, rotations = mechanism.frames(pose.q, mechanism.rows(robot))
    return sketch.chain(origins[0], rotations[0], pose.x[0, :3])


def _tables(
    account: Mapping[str, Any], robot: Robot | None, names: Sequence[str], mechanism: Machine | None
) -> list[dict[str, Any]]:
    """Return the tables of parameters: symbol, name, unit, nominal value or ordinary error, meaning."""
    words = {
        "platform": "Platform: what the closures are solved for",
        "joint": "Joint",
        "tool": "Reference point",
        "geometry": "Nominal geometry",
        "errors": "Source errors of a limb" if account["kind"] == "limbs" else "Source errors of a link",
        "common": "Source errors that all limbs share" if account["kind"] == "limbs" else "Source errors of the tool",
        "deflections": "Deflections: zero on a rigid machine, moved by effects",
        "masses": "Masses",
    }
    found = []
    for key, title in words.items():
        rows = account["tables"].get(key)
        if not rows:
            continue
        value = {"geometry": "nominal", "errors": "ordinary error", "common": "ordinary error"}.get(key)
        shown = []
        for row in rows:
            unit = "" if row["unit"] == "1" else file_unit(row["unit"])
            cell = ""
            if key == "geometry" and robot is not None:
                values = [f"{v / to_internal(row['unit']):.6g}" for v in robot.geometry[row["key"]]]
                cell = values[0] if len(set(values)) == 1 else ", ".join(values)
            elif value:
                cell = f"{row['typical'] / to_internal(row['unit']):.3g}"
            name = row.get("key", row["name"])
            in_model = ""
            if key in ("errors", "common") and mechanism is not None:
                own = [p.name for p in mechanism.parameters if p.error == row["name"]]
                count = sum(n in names for n in own)
                in_model = "all" if count == len(own) else f"{count} of {len(own)}" if count else "no"
            shown.append({**row, "unit": unit, "value": cell, "name": name, "in_model": in_model})
        found.append({"title": title, "value": value, "rows": shown, "model": key in ("errors", "common")})
    return found


def _ranks(one: Subject, robot: Robot, names: Sequence[str], account: Mapping[str, Any]) -> list[dict[str, Any]]:
    """Return ranks with what is unseen: in closed form where that is all of it, else in words."""
    closed = (account.get("unseen") or {}).get(one.name, {})
    found: list[dict[str, Any]] = []
    for rank in checks.ranks(robot, _trials(one.mechanism), names):
        free = rank.columns - rank.rank
        basis = closed.get(rank.motions)
        same = [r for r in found if r["motions"] == rank.motions and r["closed"] and r["free"] == free]
        found.append(
            {
                "kind": rank.kind,
                "points": rank.points,
                "rank": rank.rank,
                "columns": rank.columns,
                "free": free,
                "smallest": report.power(rank.smallest),
                "noise": report.below(rank.noise),
                "motions": rank.motions,
                "closed": basis if basis is not None and len(basis) == free and free else None,
                "closed_rank": None if basis is None else rank.columns - len(basis),
                "words": [c.text for c in rank.unseen],
                "same_as": same[0]["kind"] if same else None,
            }
        )
    return found


def _checked(one: Subject, robot: Robot, names: Sequence[str]) -> dict[str, Any]:
    mechanism, at = mechanism_of(robot), _trials(one.mechanism)
    poses = at.poses
    exact, left = checks.linear_against_exact(robot, poses, names)
    sizes = [np.linalg.norm(v, axis=1) for v in (exact, left)]
    counts, conditions, rank = checks.condition_by_count(robot, at, names)
    shown = (0, 1) if "y" in mechanism.axes else (0, 2)
    return {
        "poses": len(poses.x),
        **_converging(one.mechanism),
        "moved": f"{np.sqrt(np.mean(sizes[0] ** 2)):.3f}",
        "left": f"{np.sqrt(np.mean(sizes[1] ** 2)) * 1000:.2g}",
        "largest": f"{sizes[1].max() * 1000:.2g}",
        "share": f"{100 * np.sqrt(np.mean(sizes[1] ** 2) / np.mean(sizes[0] ** 2)):.2g}",
        "map_picture": report.picture(partial(_map, x=poses.x, left=sizes[1], plane=shown), (4.4, 3.9)),
        "condition_rank": rank,
        "condition_columns": len(names),
        "condition_first": next((n for n, c in zip(counts, conditions, strict=True) if np.isfinite(c)), None),
        "condition_last": f"{conditions[-1]:.3g}",
        "condition_count": counts[-1],
        "condition_picture": report.picture(partial(_conditions, counts=counts, values=conditions), (4.4, 3.0)),
    }


def _orders(axes: Axes, found: Sequence[checks.Order]) -> None:
    for order, colour in zip(found, (AFTER, BEFORE, MUTED), strict=False):
        axes.loglog(order.steps, np.maximum(order.gaps, 1e-13), "o-", ms=3.5, lw=1.2, color=colour, label=order.by)
    steps = found[0].steps
    axes.loglog(steps, found[0].gaps[0] * 2.5 * (steps / steps[0]) ** 2, "--", lw=0.9, color=MUTED, label="slope 2")
    decades(axes.xaxis)
    decades(axes.yaxis)
    axes.set_xlabel("step, in ordinary errors")
    axes.set_ylabel("left by first order, mm")
    axes.legend(frameon=False)


def _map(axes: Axes, x: np.ndarray, left: np.ndarray, plane: tuple[int, int]) -> None:
    i, j = plane
    top = float(left.max()) or 1.0
    axes.scatter(x[:, i], x[:, j], s=150 * left / top, color=AFTER, alpha=0.55, linewidths=0)
    axes.set_aspect("equal", adjustable="datalim")
    axes.margins(0.12)
    axes.set_xlabel(f"{'xyz'[i]}, mm")
    axes.set_ylabel(f"{'xyz'[j]}, mm")
    axes.scatter([], [], s=150, color=AFTER, alpha=0.55, linewidths=0, label=f"{top * 1000:.2g} µm")
    axes.legend(frameon=False, loc="lower right", bbox_to_anchor=(1.0, 1.0), borderaxespad=0.1, handletextpad=0.2)


def _conditions(axes: Axes, counts: Sequence[int], values: np.ndarray) -> None:
    axes.loglog(counts, values, "o-", ms=3.5, lw=1.2, color=AFTER)
    axes.set_xticks([3, 5, 10, 20, 40, 80], ["3", "5", "10", "20", "40", "80"])
    axes.minorticks_off()
    decades(axes.yaxis)
    axes.set_xlabel("poses n, each with three reference points")
    axes.set_ylabel("condition number")


def _claims(reference: str, formulas: Mapping[str, Sequence[Any]]) -> dict[str, Any] | None:
    """Return the ledger's entries on the paper that a mechanism is of: its file is named by the first author."""
    author = reference.split(",")[0].split(" ")[0].lower()
    if author not in ledger.paper_names():
        return None
    paper = ledger.load_paper(author)
    claims = [
        {**c.model_dump(), "sides": {key: _said(formulas[getattr(c, key)]) for key in ("printed", "correct")}}
        for c in paper.claims
    ]
    return {
        "title": paper.title,
        "counts": [(s, sum(c["status"] == s for c in claims)) for s in ledger.STATUSES],
        "equations": [c for c in claims if c["where"].startswith("eq.")],
        "others": [c for c in claims if not c["where"].startswith("eq.")],
        "corrected": [c for c in claims if c["status"] == "contradicted"],
        "conventions": [c for c in claims if c["status"] == "convention-dependent"],
    }


def _said(parts: Sequence[Any]) -> dict[str, Any]:
    """Return a text of the ledger, and whether it is formulas alone, which are set larger than in a sentence."""
    return {"parts": parts, "alone": all(not isinstance(p, str) or not re.search(r"[A-Za-z]", p) for p in parts)}


def applies(effect: str, mechanism: str) -> list[str]:
    """Return what a mechanism lacks that an effect needs; nothing where it applies."""
    robot = example(mechanism)
    of = load_mechanism(mechanism) if robot is None else mechanism_of(robot)
    return lacking(effect, of, {} if robot is None else of.moves(robot), {} if robot is None else of.roles(robot))


def _effect_on(account: Mapping[str, Any], mechanism: str, sources: Sources) -> dict[str, Any]:
    """Return an effect on a machine: its deformation, what it reads, the kernels it ends in, or what is lacking."""
    name = account["name"]
    effect, lacks = load_effect(name), applies(name, mechanism)
    file = f"{KERNELS}/effects/{name}.py"
    return {
        "name": name,
        "title": effect.TITLE,
        "formulas": [] if lacks else [t["formula"] for t in account["targets"]],
        "reads": ", ".join(effect.STATE) or "nothing",
        "lacks": ", ".join(lacks),
        "at": None if lacks else sources.at(**account["targets"][0]["place"]),
        "led": []
        if lacks
        else [
            {"kernel": k.name, "operations": k.operations, "written_out": k.written_out, **sources.at(k.file, k.line)}
            for k in kernels(sources, file)
        ],
    }


def _provenance(one: Subject, sources: Sources, files: Sequence[str], account: Mapping[str, Any]) -> dict[str, Any]:
    versions = [("Python", platform.python_version()), ("SymPy", account["sympy"])]
    versions += [(name, importlib.metadata.version(name)) for name in VERSIONS]
    return {
        "command": f"deltacal derivation {one.name} -o",
        "versions": versions,
        "files": [{"file": file, "sha256": sources.digest(file)} for file in files],
        "seed": checks.SEED,
    }


def effect_content(one: Subject, account: Mapping[str, Any], root: Path) -> dict[str, Any]:
    """Return all that a report of an effect shows."""
    sources = Sources(root)
    file = f"{KERNELS}/effects/{one.name}.py"
    for target in account["targets"]:
        target["at"] = sources.at(**target["place"])
    used = kernels(sources, file)
    account = {**account, "chain": [_led(part, used, sources, KERNELS) for part in account["chain"]]}
    return {
        "subject": one.name,
        "what": account["title"],
        "account": account,
        "conventions": account["docstring"],
        "kernels": _table_of(used, sources),
        "machines": [
            {"name": name, "title": _title(name), "lacks": ", ".join(applies(one.name, name))}
            for name in mechanism_names()
        ],
        "listings_": sources.listings(),
        "provenance": _provenance(one, sources, [account["source"], "derive/effects/__init__.py", file], account),
    }


def _title(mechanism: str) -> str:
    title: str = importlib.import_module(f"deltacal_kernels.{mechanism}.parameters").TITLE
    return title


# ---------------------------------------------------------------------------------------------------------- the files

FORMATS = (".html", ".md")
PICTURES = {"machine": "machine", "orders": "orders_picture", "map": "map_picture", "condition": "condition_picture"}


def files(path: Path, template: str, found: Mapping[str, Any]) -> dict[Path, str]:
    """Return a report as files: one page of HTML, or Markdown with its pictures beside it."""
    if path.suffix == ".html":
        return {path: report.page_of(template, title=f"{found['subject']}: derivation", **found)}
    named = {key: path.with_name(f"{path.stem}-{key}.svg") for key in PICTURES}
    svg = {**(found.get("checks") or {}), "machine": found.get("machine")}
    drawn = {named[key]: report.standalone(svg[of]) for key, of in PICTURES.items() if svg.get(of)}
    pictures = {key: file.name for key, file in named.items()}
    return {path: report.markdown(template, pictures=pictures, **found), **drawn}


def derivations(
    chosen: Sequence[Subject], root: Path, progress: Callable[[str], None]
) -> Iterator[tuple[Subject, str, dict[str, Any]]]:
    """Yield each subject's template and content; SymPy works on the next one meanwhile."""
    kinds = sorted(p.stem for p in (root / "derive" / "measurements").glob("[a-z]*.py"))
    wanted: dict[str, dict[str, Any]] = {}
    for one in chosen:
        wanted.setdefault(one.mechanism or one.name, request(one))
    common = Common((), (), (), {})
    asked: list[dict[str, Any]] = []
    texts = sorted(
        {t for p in ledger.paper_names() for c in ledger.load_paper(p).claims for t in (c.printed, c.correct)}
    )
    if any(one.mechanism for one in chosen):
        asked += [{"measurement": kind} for kind in kinds]
        asked += [{"effect": name} for name in effect_names()]
        asked += [{"texts": texts}, {"reaches": ["joint", "limb.part", "turn.axis", "tool.axis", "reading.axis"]}]
    answers = accounts([*asked, *wanted.values()], root)
    if asked:
        progress("measurements, effects, papers")
        first = [next(answers) for _ in asked]
        formulas = dict(zip(texts, first[-2]["texts"], strict=True))
        common = Common(first[: len(kinds)], first[len(kinds) : -2], first[-1]["chain"], formulas)
    done = 0
    for key in wanted:
        progress(f"{key}: equations")
        account = next(answers)
        for one in (one for one in chosen if (one.mechanism or one.name) == key):
            done += 1
            progress(f"{one.name} ({done} of {len(chosen)}): ranks and checks")
            if one.mechanism:
                yield one, "derivation", content(one, account, root, common)
            else:
                yield one, "effect", effect_content(one, account, root)
    for _ in answers:  # the process ends
        raise AssertionError("more answers than requests")


def index(found: Sequence[tuple[Subject, dict[str, Any]]], ending: str) -> dict[str, Any]:
    """Return what the page that leads to all reports shows."""
    machines: dict[str, dict[str, Any]] = {}
    effects = []
    for one, data in found:
        file = f"{one.stem}{ending}"
        if not one.mechanism:
            effects.append({"name": one.name, "file": file, "title": data["what"]})
            continue
        machine = machines.setdefault(
            one.mechanism,
            {"title": data["what"], "reference": data["reference"], "drawing": data["machine"], "models": []},
        )
        seen = next((r["rank"] for r in data["ranks"] if r["motions"] == "unknown frame, one point"), None)
        columns = data["ranks"][0]["columns"] if data["ranks"] else 0
        machine["models"].append({"name": one.name, "file": file, "parameters": columns, "rank": seen})
    return {"machines": list(machines.values()), "effects": effects}
