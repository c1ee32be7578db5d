"""Reports of a derivation, for reviewers: from the closure equations to the committed kernels, and what checks them.

The mathematics comes from `account`. Beside it stand the claims of the papers, ranks and numerical checks that are
computed when the report is made, and the sources themselves, so that every equation leads to its line without a
network. A report says nothing of when or where it was made: the same sources and versions give the same bytes.
"""

from __future__ import annotations

import importlib.metadata
import platform
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache, partial
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib.axes import Axes

from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.identifiability import RANK_TOLERANCE
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import Machine, mechanism_names, mechanism_of
from deltacal_gen.pages import report
from deltacal_gen.pages.figures import AFTER, BEFORE, MUTED, decades
from deltacal_gen.physics.terms import drive_effect_names, effect_names, load_effect
from deltacal_gen.units import file_unit, to_internal
from derive import registry
from derive.papers import verdicts
from derive.review import account as accounts
from derive.review import checks, geometry, laws, ledger, method, notation, rendering, sketch
from derive.review.sources import ROOT, Kernel, Sources, kernels, of_function, table_of
from derive.review.subjects import Sort, Subject, applies, example, seen_by, title_of

KERNELS = "generated/deltacal_kernels"
PACKAGES = {"sympy": "SymPy", "numpy": "numpy", "scipy": "scipy", "matplotlib": "matplotlib"}  # as they are shown


@cache
def _account(mechanism: str) -> dict[str, Any]:
    return accounts.mechanism(mechanism, example(mechanism))


@cache
def _effects() -> list[dict[str, Any]]:
    return [accounts.effect(name) for name in effect_names()]


@cache
def _measurements() -> list[dict[str, Any]]:
    return [accounts.measurement(spec.name) for spec in registry.measurements()]


def content(one: Subject) -> dict[str, Any]:
    """Return all that a report of a model shows, for either format."""
    sources, robot, account = Sources(), example(one.mechanism), dict(_account(one.mechanism))
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
    for part in (*account["steps"], *account["where"], *account["rotations"]):
        part["at"] = sources.at(*part["place"])
    for part in (*account.get("closures", ()), *account["weights"], *account.get("seeds", ())):
        part["at"] = sources.at(*part["place"]) if part["place"] else None
    files = [f"{KERNELS}/{one.mechanism}/{name}.py" for name in ("vectorised", "servo", "statics")]
    files = [file for file in files if (ROOT / file).exists()]
    every = [k for file in files for k in kernels(sources, file)]
    used = list({k.name: k for k in reversed(every)}.values())[::-1]  # what stands in two files, from the first
    for step in account["steps"]:
        step["ends"] = _ends(step, used, sources)
    folder = f"{KERNELS}/{one.mechanism}"
    for key in ("implicit", "statics", "links"):
        account[key] = [led(part, used, sources, folder) for part in account.get(key, ())]
    account["gradient"] = led(account["gradient"], used, sources, folder)
    found["kernels"] = table_of(used, sources)
    found["measurements"] = [{**m, "at": sources.at(*m["place"])} for m in _measurements()]
    found["claims"] = _claims(account["reference"])
    found["effects"] = [_effect_on(e, one.mechanism, sources) for e in _effects()]
    reached = laws.reaches(accounts.TARGETS, loaded=True)
    found["effect_chain"] = [led(vars(law), used, sources, folder) for law in reached]
    if robot is not None:
        found |= _in_numbers(one, robot, account)
    else:
        found |= {"machine": None, "tables": _tables(account, None, (), None), "checks": None, "ranks": []}
    found["dimensions"] = _dimensions(account)
    found["short"] = _short(found, used)
    found["listings_"] = sources.listings()
    stages = [f"derive/{name}.py" for name in ("vectors", "graph", "lower", "compiler")]
    found["provenance"] = _provenance(one, sources, [account["source"], *stages, *files])
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
        says += f"; worded loosely, left to a convention or undecided: {others}" if others else ""
        rest = claims["others"]
        no = sum(c["status"] == "contradicted" for c in rest)
        lines.append(("Paper", "paper", f"{says}; contradicted of {len(rest)} other statements: {no}."))
    if ranks:
        seen = next((r for r in ranks if r["paper"]), None)
        by = f"{seen['kind']}, the paper's case" if seen else "positions of one point in an unknown frame"
        seen = seen or _of_positions(ranks) or ranks[0]
        says = f"{seen['rank']} of {seen['columns']} parameters are seen by {by}"
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


def _of_positions(ranks: Sequence[Mapping[str, Any]]) -> Mapping[str, Any] | None:
    """Return what positions of one point in an unknown frame see; contacts, of the same motions, may see less."""
    return next((r for r in ranks if r["kind"] == "positions in an unknown frame" and r["points"] == 1), None)


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


def _counted(kernel: Kernel, sources: Sources, name: str) -> dict[str, Any]:
    """Return a kernel in which a formula ends, with its operations."""
    counts = {"operations": kernel.operations, "written_out": kernel.written_out}
    return {"kernel": name, **counts, **sources.at(kernel.file, kernel.line)}


def led(part: Mapping[str, Any], used: Sequence[Kernel], sources: Sources, folder: str) -> dict[str, Any]:
    """Return where a formula is made, and the functions in which it ends: kernels with their operations.

    Raises
    ------
    KeyError
        A generated function by which a formula ends is not there.
    """
    ends: list[dict[str, Any]] = []
    for end in part["ends"]:
        kernel = next((k for k in used if k.name.lstrip("_") == end), None)
        if kernel is not None:
            ends.append(_counted(kernel, sources, end))
        elif isinstance(end, str):
            file = f"{folder}/vectorised.py"
            ends.append({"kernel": end, "operations": None, **sources.at(file, sources.functions(file)[end].lineno)})
        else:
            ends.append({"kernel": end.__qualname__, "operations": None, **sources.at(*of_function(end))})
    return {**part, "at": sources.at(*part["place"]) if part["place"] else None, "led": ends}


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
    case, limbs = verdicts.case_of(one.mechanism), account.get("limbs", 1) > 1
    found: list[dict[str, Any]] = []
    for rank in checks.ranks(robot, _trials(one.mechanism), names):
        free = rank.columns - rank.rank
        basis = closed.get(rank.motions)
        paper = rank.kind == case and not any(r["paper"] for r in found)
        said = [geometry.sentence(one.mechanism, v["names"], limbs) for v in basis or ()]
        same = [r for r in found if r["motions"] == rank.motions and r["closed"] and r["free"] == free]
        found.append(
            {
                "kind": rank.kind,
                "points": rank.points,
                "rank": rank.rank,
                "columns": rank.columns,
                "free": free,
                "smallest": report.power(rank.smallest),
                "noise": rendering.below(rank.noise),
                "motions": rank.motions,
                "paper": paper,
                "geometry": [
                    *dict.fromkeys(filter(None, said)),
                    *([geometry.RIGID.get(one.name)] if paper else []),
                ],
                "divides": sorted({d for v in basis or () for d in v["divides"]}),
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


def _orders(axes: Axes, found: Sequence[checks.Order], steps: str = "step, in ordinary errors") -> None:
    for order, colour in zip(found, (AFTER, BEFORE, MUTED), strict=False):
        axes.loglog(order.steps, np.maximum(order.gaps, 1e-13), "o-", ms=3.5, lw=1.2, color=colour, label=order.by)
    sizes = found[0].steps
    axes.loglog(sizes, found[0].gaps[0] * 2.5 * (sizes / sizes[0]) ** 2, "--", lw=0.9, color=MUTED, label="slope 2")
    decades(axes.xaxis)
    decades(axes.yaxis)
    axes.set_xlabel(steps)
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


def _claims(reference: str) -> dict[str, Any] | None:
    """Return the ledger's entries on the paper that a mechanism is of: its file is named by the first author."""
    author = reference.split(",")[0].split(" ")[0].lower()
    if author not in ledger.paper_names():
        return None
    paper, ended = ledger.load_paper(author), ledger.decided()
    files = {c.test.partition("::")[0] for c in paper.claims}
    now = {file: ledger.sources(ROOT, file) for file in files}
    claims = [
        {
            **c.model_dump(),
            "sides": {key: _said(notation.read(getattr(c, key))) for key in ("printed", "correct")},
            "ended": ended.get(c.test),
            "with_these": c.test in ended and ended[c.test].sources == now[c.test.partition("::")[0]],
        }
        for c in paper.claims
    ]
    return {
        "title": paper.title,
        "counts": [(s, sum(c["status"] == s for c in claims)) for s in ledger.STATUSES],
        "derived": sum(bool(c["decided"]) for c in claims),
        "equations": [c for c in claims if c["where"].startswith("eq.")],
        "others": [c for c in claims if not c["where"].startswith("eq.")],
        "corrected": [c for c in claims if c["status"] == "contradicted"],
        "conventions": [c for c in claims if c["status"] == "convention-dependent"],
    }


def _said(parts: Sequence[Any]) -> dict[str, Any]:
    """Return a text of the ledger, and whether it is formulas alone, which are set larger than in a sentence."""
    return {"parts": parts, "alone": all(not isinstance(p, str) or not re.search(r"[A-Za-z]", p) for p in parts)}


def _effect_on(account: Mapping[str, Any], mechanism: str, sources: Sources) -> dict[str, Any]:
    """Return an effect on a machine: its deformation, what it reads, the kernels it ends in, or what is lacking."""
    name = account["name"]
    effect, lacks = load_effect(name), applies(name, mechanism)
    file = f"{KERNELS}/effects/{name}.py"
    return {
        "name": name,
        "title": effect.TITLE,
        "formulas": []
        if lacks
        else [*(m["rate"] for m in account["memory"]), *(t["formula"] for t in account["targets"])],
        "reads": ", ".join(effect.STATE) or "nothing",
        "lacks": ", ".join(lacks),
        "at": None if lacks else sources.at(*account["targets"][0]["place"]),
        "led": [] if lacks else [_counted(k, sources, k.name) for k in kernels(sources, file)],
    }


def _provenance(one: Subject, sources: Sources, files: Sequence[str]) -> dict[str, Any]:
    versions = [("Python", platform.python_version())]
    versions += [(shown, importlib.metadata.version(name)) for name, shown in PACKAGES.items()]
    return {
        "command": f"deltacal derivation {one.name} -o",
        "versions": versions,
        "files": [{"file": file, "sha256": sources.digest(file)} for file in files],
        "seed": checks.SEED,
    }


def effect_content(one: Subject) -> dict[str, Any]:
    """Return all that a report of an effect shows."""
    sources, account = Sources(), accounts.effect(one.name)
    file = f"{KERNELS}/effects/{one.name}.py"
    for target in account["targets"]:
        target["at"] = sources.at(*target["place"])
    used = kernels(sources, file)
    account = {**account, "chain": [led(part, used, sources, KERNELS) for part in account["chain"]]}
    return {
        "subject": one.name,
        "what": account["title"],
        "account": account,
        "conventions": account["docstring"],
        "kernels": table_of(used, sources),
        "machines": [
            {"name": name, "title": title_of(name), "lacks": ", ".join(applies(one.name, name))}
            for name in (() if one.name in drive_effect_names() else mechanism_names())  # of drives, whatever they move
        ],
        "listings_": sources.listings(),
        "provenance": _provenance(one, sources, [account["source"], "derive/effects/__init__.py", file]),
    }


def measurement_content(one: Subject) -> dict[str, Any]:
    """Return all that a report of a kind of measurement shows."""
    sources, account, kind = Sources(), accounts.measurement(one.name), kind_of(one.name)
    file, robot = f"{KERNELS}/measurements/{one.name}.py", seen_by(kind)
    with using(Backend.NUMPY):
        orders = checks.orders_of_readings(robot, kind)
    bent = [o for o in orders if np.isfinite(o.order)]
    picture = report.picture(partial(_orders, found=bent, steps="step"), (4.4, 3.0)) if bent else None
    return {
        "subject": one.name,
        "what": account["meaning"],
        "account": account,
        "conventions": account["docstring"],
        "at": sources.at(*account["place"]),
        "effects": [
            {"name": name, "title": load_effect(name).TITLE}
            for name in effect_names()
            if set(load_effect(name).TARGETS) & set(kind.targets)
        ],
        "checked": _checked_by(robot.name, kind.scale, orders),
        "checks": {"orders_picture": picture},
        "kernels": table_of(kernels(sources, file), sources),
        "listings_": sources.listings(),
        "provenance": _provenance(one, sources, [account["source"], "derive/mathematics/measurements.py", file]),
    }


def _checked_by(robot: str, scale: float, orders: Sequence[checks.Order]) -> str:
    """Return in words how the derivatives of readings were checked, and what came of it."""
    linear, each = "they are linear, and first order leaves nothing", []
    for o in orders:
        by = "the unknowns" if o.by == "unknowns" else f"the {o.by}"
        each.append(f"by {by} {f'the order is {o.order:.3f}' if np.isfinite(o.order) else linear}")
    at = "" if scale == 1.0 else f", a rad or a pixel counted as {scale:g} mm"
    text = f"Readings at poses of the machine '{robot}', by random steps{at}: "
    text += f"{'; '.join(each)}."
    if any(np.isfinite(o.order) for o in orders):
        text += " 2 or more says that the derivative is right: halve the step, quarter the gap."
    if any(o.by == "unknowns" for o in orders):
        text += " A step of the unknowns is taken by the instrument's state after it, which is checked by that, too."
    return text


def method_content(one: Subject) -> dict[str, Any]:
    """Return all that the report of the method shows."""
    sources = Sources()
    found = [
        {
            "title": step.title,
            "test": step.test,
            "gap": rendering.below(step.gap),
            **led(vars(step.law), (), sources, ""),
        }
        for step in method.steps()
    ]
    files = sorted({place.file for step in method.steps() for _, place in method.ends(step)})
    return {
        "subject": one.name,
        "steps": found,
        "listings_": sources.listings(),
        "provenance": _provenance(one, sources, ["derive/review/method.py", *files]) | {"seed": method.SEED},
    }


CONTENTS: Mapping[Sort, Callable[[Subject], dict[str, Any]]] = {
    Sort.MODEL: content,
    Sort.EFFECT: effect_content,
    Sort.MEASUREMENT: measurement_content,
    Sort.METHOD: method_content,
}

# ---------------------------------------------------------------------------------------------------------- the files

PICTURES = {"machine": "machine", "orders": "orders_picture", "map": "map_picture", "condition": "condition_picture"}


def files(path: Path, template: str, found: Mapping[str, Any]) -> dict[Path, str]:
    """Return a report as files: one page of HTML, or Markdown with its pictures beside it."""
    if path.suffix == ".html":
        return {path: rendering.page(template, title=f"{found['subject']}: derivation", **found)}
    named = {key: path.with_name(f"{path.stem}-{key}.svg") for key in PICTURES}
    svg = {**(found.get("checks") or {}), "machine": found.get("machine")}
    drawn = {named[key]: rendering.standalone(svg[of]) for key, of in PICTURES.items() if svg.get(of)}
    pictures = {key: file.name for key, file in named.items()}
    return {path: rendering.markdown(template, pictures=pictures, **found), **drawn}


def made(chosen: Sequence[Subject], progress: Callable[[str], None]) -> Iterator[tuple[Subject, str, dict[str, Any]]]:
    """Yield each subject with the template, which is called as its sort is, and the content of its report."""
    for done, one in enumerate(chosen, start=1):
        progress(f"{one.name} ({done} of {len(chosen)})")
        yield one, one.sort.value, CONTENTS[one.sort](one)


def index(found: Sequence[tuple[Subject, dict[str, Any]]], ending: str) -> dict[str, Any]:
    """Return what the page that leads to all reports shows."""
    machines: dict[str, dict[str, Any]] = {}
    others: dict[Sort, list[dict[str, Any]]] = {Sort.EFFECT: [], Sort.MEASUREMENT: []}
    for one, data in found:
        file = f"{one.stem}{ending}"
        if one.sort in others:
            others[one.sort].append({"name": one.name, "file": file, "title": data["what"]})
        if one.sort is not Sort.MODEL:
            continue
        machine = machines.setdefault(
            one.mechanism,
            {"title": data["what"], "reference": data["reference"], "drawing": data["machine"], "models": []},
        )
        seen = _of_positions(data["ranks"])
        columns = data["ranks"][0]["columns"] if data["ranks"] else 0
        machine["models"].append({"name": one.name, "file": file, "parameters": columns, "rank": seen and seen["rank"]})
    return {
        "machines": list(machines.values()),
        "lists": [("Effects", others[Sort.EFFECT]), ("Measurements", others[Sort.MEASUREMENT])],
    }
