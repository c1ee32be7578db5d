"""From what is said of machines, effects and instruments to ``generated/``, in four stages.

=========  ==========================================================================================================
collect    the specs: one per file in ``mechanisms/``, ``effects/``, ``measurements/``; a file's presence registers it
derive     a spec becomes functions on graphs of named steps: closures, seeds, derivatives (``mathematics/``)
lower      functions become kernels: loads, assignments, stores, in the order of evaluation (``lower.py``); those of a
           torque get others beside them, of its rates (``tangent.py``)
write      kernels become text: a target prints and lays out lines (``backends/``), a template puts them into a file
=========  ==========================================================================================================

Each stage's output is the next one's input. SymPy's expressions go through to the last, where a target prints them.
Writing and checking compare the same text.
"""

from __future__ import annotations

import difflib
import hashlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import jinja2
import sympy as sp

from derive import registry, servo, statics, tangent
from derive.backends import c99, lanes, numpy, scalar
from derive.backends import servo as commands
from derive.backends.ir import Kernel
from derive.blocks import nominal
from derive.first_order import linear
from derive.language.effects import Effect, Orders
from derive.language.states import COVARIATE, STATES
from derive.language.targets import LAWFUL, TARGETS
from derive.lower import lower
from derive.mathematics.bodies import INERTIA
from derive.mathematics.chains import links
from derive.mathematics.effects import effect
from derive.mathematics.functions import Functions
from derive.mathematics.images import images
from derive.mathematics.kinematics import kinematics, meeting, rotations, stated
from derive.mathematics.loops import loops
from derive.mathematics.measurements import distances, measurement, platform_names, step
from derive.mathematics.motion import motion
from derive.spec import ChainMechanism, LimbMechanism, Measurement

ROOT = Path(__file__).resolve().parent.parent
TEMPLATES = ROOT / "templates"
GENERATED = ROOT / "generated" / "deltacal_kernels"
COMMAND = "deltacal kernels"
SIZES = Path("sizes.csv")
SUPPORT = ROOT / "derive" / "support"  # plain Python, copied as it stands
COMMON = (
    "__init__.py",
    "poses.py",
    "rotations.py",
    "images.py",
    "effects/__init__.py",
    "effects/compiled/__init__.py",
    "effects/states.py",
    "effects/targets.py",
    "measurements/__init__.py",
    "measurements/compiled/__init__.py",
)

Spec = LimbMechanism | ChainMechanism | Effect | Measurement
Kernels = Mapping[str, Kernel]


# ------------------------------------------------------------------------------------------------------------- collect


def collect(names: Sequence[str] = ()) -> list[Spec]:
    """Return the specs of these names; all of them where no name is given.

    Raises
    ------
    ValueError
        Nothing is registered by a name.
    """
    registered: list[tuple[Callable[[str], Spec], list[str]]] = [
        (registry.mechanism, registry.mechanism_names()),
        (registry.measurement, registry.measurement_names()),
        (registry.effect, registry.effect_names()),
    ]
    known = [name for _, own in registered for name in own]
    if unknown := [name for name in names if name not in known]:
        raise ValueError(f"nothing is registered as {', '.join(unknown)}; there are {', '.join(known)}.")
    return [build(name) for build, own in registered for name in own if not names or name in names]


# -------------------------------------------------------------------------------------------------------------- derive


@dataclass(frozen=True)
class Derived:
    """What is derived of a spec.

    Attributes
    ----------
    functions : mapping
        By what they are for.
    layouts : mapping
        What templates are told beside the kernels: where quantities over lanes stand.
    """

    spec: Spec
    functions: Mapping[str, Sequence[Functions]]
    layouts: Mapping[str, Any] = field(default_factory=dict)


def derive_one(spec: Spec) -> Derived:
    """Derive the functions of a spec."""
    if isinstance(spec, Effect):
        return Derived(spec, {"effect": effect(spec)})
    if isinstance(spec, Measurement):
        return Derived(spec, {"measurement": [measurement(spec), step(spec)]})
    if isinstance(spec, ChainMechanism):
        return Derived(spec, {"links": [links(spec)], "motion": [motion(spec)]})
    moving, blocks = kinematics(spec)
    ideal = nominal(spec, blocks)
    exact, first_order = servo.exact(spec), servo.linear(spec)
    bodies = loops(spec, blocks) if spec.limb_inertials else None
    functions = {
        "moving": [moving, *blocks.functions, *meeting(spec)],
        "statics": statics.loads(spec),
        "motion": bodies.functions if bodies else [],
        "exact": exact.functions,
        "linear": first_order.functions,
        "exported": [linear(spec), *([stated(spec)] if spec.turning else [])],
        **({"nominal": [*ideal.functions, distances(spec.commanded)]} if ideal else {}),
    }
    layouts = {"blocks": blocks, "nominal": ideal, "exact": exact, "linear": first_order, "bodies": bodies}
    return Derived(spec, functions, layouts)


# --------------------------------------------------------------------------------------------------------------- lower


@dataclass(frozen=True)
class Lowered:
    """Kernels of a spec: by what they are for, then by name."""

    spec: Spec
    kernels: Mapping[str, Kernels]
    layouts: Mapping[str, Any]


def lower_one(derived: Derived) -> Lowered:
    """Lower the functions of a spec."""
    kernels = {name: _lowered(found) for name, found in derived.functions.items()}
    if isinstance(derived.spec, ChainMechanism):
        kernels["slopes"] = tangent.of_chain(kernels["motion"])
    elif isinstance(derived.spec, LimbMechanism) and derived.spec.limb_inertials:
        blocks = derived.layouts["blocks"]
        kernels["slopes"] = tangent.of_limbs(derived.spec, blocks, kernels["moving"], kernels["motion"])
    return Lowered(derived.spec, kernels, derived.layouts)


def _lowered(functions: Sequence[Functions]) -> dict[str, Kernel]:
    return {name: kernel for group in functions for name, kernel in lower(group).items()}


# --------------------------------------------------------------------------------------------------------------- write


def write_one(lowered: Lowered) -> dict[Path, str]:
    """Return the files of a spec, by their paths below the kernel package."""
    spec, kernels = lowered.spec, lowered.kernels
    if isinstance(spec, Effect):
        return _effect(spec, kernels["effect"])
    if isinstance(spec, Measurement):
        return _measurement(spec, kernels["measurement"])
    folder = Path(spec.name)
    texts = {folder / "__init__.py": f'"""{spec.title}: tables and kernels."""\n'}
    if isinstance(spec, ChainMechanism):
        for name in ("parameters.py", "vectorised.py", "kinematics.py"):
            texts[folder / name] = _file(f"chain/{name}", spec, mechanism=spec, kernels=kernels["links"])
        for name in ("dynamics.py", "dynamics.c"):
            texts[folder / name] = _file(
                f"chain/{name}",
                spec,
                mechanism=spec,
                kernels=kernels["motion"],
                slopes=kernels["slopes"],
                inertia=INERTIA,
            )
        return texts
    moving, layouts = kernels["moving"], lowered.layouts
    command_constants = 1 + max(j for name in ("newton", "joint") for j in moving[name].reads("k") if j is not None)
    contents: dict[str, dict[str, Any]] = {
        "parameters.py": _tables(spec),
        "constants.py": {"kernels": moving, "nominal": kernels.get("nominal")},
        "blocks.py": {},
        "kinematics.py": {"kernels": moving},
        "servo.py": {
            "kernels": {name: kernels[name] for name in ("exact", "linear", "exported")},
            "command_constants": command_constants,
        },
        "vectorised.py": {"kernels": moving},
        "compiled/__init__.py": {},
        "statics.py": {"functions": (statics_rows := _statics(kernels["statics"]))},
        "inverse.c": {"kernels": {**kernels["exported"], **moving}, "constants": command_constants},
        "linear.c": {"kernels": kernels["exported"]},
    }
    if spec.limb_inertials:
        stated = {b.name: b.stated for b in (*spec.limb_inertials, *spec.platform_inertials) if b.stated is not None}
        contents["dynamics.py"] = {
            "kernels": kernels["motion"],
            "slopes": kernels["slopes"],
            "stated": {name: numpy.expression(e) for name, e in stated.items()},
            "reads": set().union(*(e.free_symbols for e in stated.values())),
        }
        contents["dynamics.c"] = {"kernels": moving, "motion": kernels["motion"]}
    if "nominal" in kernels:
        contents["nominal.py"] = {"kernels": kernels["nominal"]}
    for name, context in contents.items():
        texts[folder / name] = _file(f"mechanism/{name}", spec, mechanism=spec, **{**layouts, **context})
    return texts | _rows(folder / "statics.py", spec, f"Generalised loads of `{spec.name}`: {spec.title}", statics_rows)


def _rows(path: Path, spec: Spec, title: str, functions: Sequence[lanes.RowFunction]) -> dict[Path, str]:
    """Return a module of functions over rows for Numba, beside the NumPy module of a path."""
    return {path.parent / "compiled" / path.name: _file("rows.py", spec, title=title, functions=functions)}


def _statics(kernels: Kernels) -> list[lanes.RowFunction]:
    """Return what weights exert, of a limb and of the platform, and where they are."""
    arguments: dict[str, tuple[str, ...]] = {
        "limb": ("x", "q", "tool", "p", "masses", "fields"),
        "limb_points": ("x", "q", "tool", "p", "masses"),
        "platform": ("x", "tool", "masses", "payload", "fields"),
        "platform_points": ("x", "tool", "masses", "payload"),
    }
    return [
        lanes.RowFunction(name, kernels[name], called, (kernels[name].length,), ("masses",))
        for name, called in arguments.items()
    ]


def _measurement(spec: Measurement, kernels: Kernels) -> dict[Path, str]:
    """Return a measurement in NumPy and for Numba."""
    names, path = platform_names(spec), Path("measurements") / f"{spec.name}.py"
    moved = len(spec.platforms[0].displacement)
    rows = kernels["reading"].length + (3 if spec.rotation else 0)
    shapes: dict[str, tuple[int, ...]] = {"reading": (kernels["reading"].length,)}
    if spec.rotation:
        shapes["rotation"] = (3, 3)
    shapes["by_platform"] = (rows, len(names), moved)
    if spec.unknown:
        shapes["by_unknown"] = (rows, len(spec.unknown))
    functions = [lanes.RowFunction(name, kernels[name], (*names, "given"), shape) for name, shape in shapes.items()]
    if spec.unknown:
        functions.append(lanes.RowFunction("stepped", kernels["stepped"], ("given", "step"), (len(spec.given),)))
    context = {"measurement": spec, "kernels": kernels, "arguments": ", ".join(names), "functions": functions}
    title = spec.meaning[0].upper() + spec.meaning[1:]
    return {path: _file("measurement.py", spec, **context), **_rows(path, spec, title, functions)}


def _effect(spec: Effect, kernels: Kernels) -> dict[Path, str]:
    """Return an effect in NumPy, for Numba and, where a controller knows all that it reads, or tells a drive, in C."""
    read = spec.states
    moved, n_c, n_m = len(spec.targets), len(spec.coefficients), len(spec.memory)
    called = ("s", "c", "constants")
    shapes: dict[str, tuple[tuple[str, ...], tuple[int, ...]]] = {
        "value": (called, (moved,)),
        "jacobian": (called, (moved, n_c)),
    }
    if spec.memory:
        shapes["by_memory"] = called, (moved, n_m)
        shapes["start"] = called, (n_m,)
        shapes["step"] = ("z", "s", "to", "h", "c", "constants"), (n_m, 2 + n_c)
    functions = [
        lanes.RowFunction(name, kernels[name], arguments, shape, ("constants",))
        for name, (arguments, shape) in shapes.items()
    ]
    before = all(s.c99 for s in read) and not spec.memory
    in_c = (set(spec.targets) == {"joint"} and before) or spec.acts_on == "drive"
    path, title = Path("effects") / f"{spec.name}.py", spec.title[0].upper() + spec.title[1:]
    context = {"effect": spec, "states": read, "kernels": kernels, "functions": functions}
    texts = {
        path.with_suffix(f".{ending}"): _file(f"effect.{ending}", spec, **context) for ending in ("py", "c")[: 1 + in_c]
    }
    return texts | _rows(path, spec, title, functions)


def _tables(mechanism: LimbMechanism) -> dict[str, Any]:
    """Return the functions of geometry that ``parameters.py.jinja`` writes, as NumPy text, and what each reads."""
    found = {
        "scaling": mechanism.scalings,
        "roles": mechanism.roles,
        "moves": mechanism.moves,
        "limb_inertia": mechanism.limb_inertia,
    }

    def text(value: Any) -> Any:
        if isinstance(value, Mapping):
            return {name: text(part) for name, part in value.items()}
        return numpy.expression(sp.sympify(value))

    def leaves(value: Any) -> list[sp.Expr]:
        if isinstance(value, Mapping):
            return [leaf for part in value.values() for leaf in leaves(part)]
        return [sp.sympify(value)]

    return {
        "tables": text(found),
        "reads": {name: set().union(*(e.free_symbols for e in leaves(value))) for name, value in found.items()},
        "calls_numpy": any(map(numpy.calls_numpy, leaves(found))),
    }


def _common(every: Mapping[str, Sequence[Any]]) -> dict[Path, str]:
    """Return the files that belong to no spec alone; `every` tells of mechanisms and effects."""
    words = {"states": STATES.values(), "covariate": COVARIATE, "targets": TARGETS, "lawful": LAWFUL}
    plain, of_poses = _lowered(rotations()), _lowered(rotations("own", "pose", 3))
    context = {**every, **words, "plain": plain, "kernels": of_poses, "images": _lowered(images())}
    context["command"] = COMMAND
    texts = {Path(name): _environment().get_template(f"{name}.jinja").render(context) for name in COMMON}
    for path in sorted(SUPPORT.glob("[!_]*.py")):
        head = f'# Copied from {path.relative_to(ROOT).as_posix()} by "{COMMAND}". Do not edit.\n\n'
        texts[Path(path.name)] = head + path.read_text(encoding="utf-8")
    return texts


def _file(name: str, spec: Spec, **context: Any) -> str:
    """Return the text of a file of a spec by the template of a name."""
    template = f"{name}.jinja"
    return _environment().get_template(template).render(stamp=_stamp(spec.source, template), **context)


def _environment() -> jinja2.Environment:
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.globals |= {"numpy": numpy, "lanes": lanes, "scalar": scalar, "servo": commands, "c99": c99}
    return environment


def _digest(*paths: Path) -> str:
    return hashlib.sha256(b"".join(path.read_bytes() for path in paths)).hexdigest()[:16]


def _stamp(source: str, template: str) -> dict[str, str]:
    """Return what the header of a generated file says of its origin."""
    return {
        "source": source,
        "template": f"templates/{template}",
        "digest": _digest(ROOT / source, TEMPLATES / template),
        "sympy": sp.__version__,
        "command": COMMAND,
    }


# -------------------------------------------------------------------------------------------------- all four, and files


def render(names: Sequence[str] = ()) -> dict[Path, str]:
    """Return every generated file by its path below the kernel package; of `names` only theirs and the common ones.

    Where names are given, what else is registered counts as it was committed.

    Raises
    ------
    ValueError
        Nothing is registered by a name, or it is the name of a file that is common to all.
    """
    texts: dict[Path, str] = {}
    for spec in collect(names):
        own = write_one(lower_one(derive_one(spec)))
        if taken := sorted(path.as_posix() for path in own if path in texts or path.as_posix() in COMMON):
            raise ValueError(f"{spec.source}: {taken[0]} is written for something else; choose another name.")
        texts |= own
    old = committed() if names else {}
    known = {path.parts for path in (*old, *texts)}
    effects = [e for e in registry.effects() if ("effects", f"{e.name}.py") in known]
    every: dict[str, Sequence[Any]] = {
        "mechanisms": [name for name in registry.mechanism_names() if (name, "parameters.py") in known],
        "effects": [e.name for e in effects if e.acts_on != "drive"],
        "of_drives": [e.name for e in effects if e.acts_on == "drive"],
        "orders": [(e.name, s.constant.name) for e in effects for s in e.searched if isinstance(s, Orders)],
    }
    texts |= _common(every)
    texts[SIZES] = sizes({path: text for path, text in (old | texts).items() if path != SIZES})
    return texts


def sizes(texts: Mapping[Path, str]) -> str:
    """Return the table of how large each file is, so that growth is seen in every change."""
    rows = [f"{path.as_posix()},{text.count(chr(10))},{len(text.encode())}" for path, text in sorted(texts.items())]
    return "\n".join(["file,lines,bytes", *rows]) + "\n"


def committed(names: Sequence[str] = ()) -> dict[Path, str]:
    """Return what stands in ``generated/`` now; of `names` only theirs and the common files."""
    found = (path for path in sorted(GENERATED.rglob("*")) if path.suffix in {".py", ".c", ".csv"})
    paths = [path for path in found if not names or _is_of(path.relative_to(GENERATED), names)]
    return {path.relative_to(GENERATED): path.read_text(encoding="utf-8") for path in paths}


def _is_of(path: Path, names: Sequence[str]) -> bool:
    """Tell whether a file is of one of the names, or of none."""
    common = path.parent == Path() or path.as_posix() in COMMON
    return common or path.parts[0] in names or path.stem in names


def differences(fresh: Mapping[Path, str], old: Mapping[Path, str]) -> list[str]:
    """Return one diff per file that is missing, left over or different; empty when all agree."""
    found = []
    for path in sorted(fresh.keys() | old.keys()):
        if fresh.get(path) != old.get(path):
            lines = difflib.unified_diff(
                old.get(path, "").splitlines(),
                fresh.get(path, "").splitlines(),
                f"committed/{path}",
                f"derived/{path}",
                n=1,
            )
            found.append("\n".join(list(lines)[:40]))
    return found


def write(fresh: Mapping[Path, str], old: Mapping[Path, str]) -> list[Path]:
    """Write what differs from the `old` files, delete what is left over of them; return the paths touched."""
    touched = [path for path in sorted(fresh.keys() | old.keys()) if fresh.get(path) != old.get(path)]
    for path in touched:
        target = GENERATED / path
        if path in fresh:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(fresh[path], encoding="utf-8", newline="\n")
        else:
            target.unlink()
    return touched
