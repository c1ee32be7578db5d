"""From kernels to text: the one path that both writes and checks ``generated/``.

`render` is a pure function, specs and templates in, ``{path: text}`` out; writing and checking compare the same text.
"""

from __future__ import annotations

import difflib
import hashlib
import importlib
import pkgutil
from collections.abc import Iterator, Mapping
from pathlib import Path
from types import ModuleType
from typing import Any

import jinja2
import sympy as sp

import derive.effects
import derive.measurements
import derive.mechanisms
from derive import closed_form, servo, statics, vectors
from derive.blocks import Blocks, blocks, nominal, turn_by_change
from derive.first_order import linear
from derive.graph import Graph
from derive.lower import Kernel, Lowering, Text
from derive.printer import c99, python
from derive.spec import ChainMechanism, Effect, EffectQuantity, LimbMechanism, Measurement

ROOT = Path(__file__).resolve().parent.parent
TEMPLATES = ROOT / "templates"
GENERATED = ROOT / "generated" / "deltacal_kernels"
COMMAND = "deltacal kernels"
SIZES = Path("sizes.csv")
KNOWN_BEFORE = {"q", "turn", "approach", "warming", "time", "after"}  # what a controller knows before it moves


def effects() -> Iterator[Effect]:
    """Yield every registered effect: one per file in ``derive/effects``."""
    return _registered(derive.effects, "EFFECT")


def effect(spec: Effect, text: Text = python) -> tuple[list[EffectQuantity], dict[str, Kernel]]:
    """Return the state that an effect reads, and its deformation and derivatives as kernels.

    In Python they read many rows at once, in C one.

    Raises
    ------
    ValueError
        A target does not vanish with the coefficients, or reads what is no state.
    """
    read = set().union(*(e.free_symbols for e in spec.targets.values()))
    states = [s for s in derive.effects.STATE if s.symbol in read]
    for target, e in spec.targets.items():
        if e.subs({c.symbol: 0 for c in spec.coefficients}) != 0:
            raise ValueError(f"effect {spec.name}: {target} does not vanish where all coefficients are zero.")
    rows = ":, " if text is python else ""
    # a coefficient may be called cos, which in C would hide the function
    own = {c.symbol: c.symbol if text is python else sp.Symbol(f"c_{c.name}", real=True) for c in spec.coefficients}
    inputs = {s.symbol: f"s[{rows}{j}]" for j, s in enumerate(states)}
    inputs |= {own[c.symbol]: f"c[{rows}{j}]" for j, c in enumerate(spec.coefficients)}
    inputs |= {c.symbol: f"constants[{j}]" for j, c in enumerate(spec.constants)}
    lowering = Lowering(Graph(), {}, inputs, text=text)
    values = [e.xreplace(own) for e in spec.targets.values()]
    return states, {
        "value": lowering.kernel("value", "value", values),
        "jacobian": lowering.kernel(
            "jacobian", "jacobian", [sp.diff(e, own[c.symbol]) for e in values for c in spec.coefficients]
        ),
    }


def _registered(package: ModuleType, name: str) -> Iterator[Any]:
    for module in sorted(pkgutil.iter_modules(package.__path__), key=lambda m: m.name):
        yield getattr(importlib.import_module(f"{package.__name__}.{module.name}"), name)


def mechanisms() -> Iterator[LimbMechanism | ChainMechanism]:
    """Yield every registered mechanism: one per file in ``derive/mechanisms``."""
    return _registered(derive.mechanisms, "MECHANISM")


def links(mechanism: ChainMechanism) -> dict[str, Kernel]:
    """Lower a link of each convention: its rotation (9) and shift (3), then how errors and joint move it.

    Each derivative is a shift of the link's origin and a turn, ``axial(dR R^T)``, both in the frame before the link:
    the twist that the chain behind the link takes part in.
    """
    variables = [quantity.symbol for quantity in mechanism.joint]
    varied = [quantity.symbol for quantity in mechanism.errors] + variables
    inputs = {s: f"x[{j}]" for j, s in enumerate(variables)}
    inputs |= {q.quantity.symbol: f"p[{j}]" for j, q in enumerate(mechanism.geometry)}
    inputs |= {q.symbol: f"p[{len(mechanism.geometry) + j}]" for j, q in enumerate(mechanism.errors)}
    found = {}
    for convention, screws in mechanism.transforms.items():
        rotation, shift, by_step = vectors.follow(screws)
        twists: list[sp.Expr] = []
        for s in varied:
            parts = [sp.diff(added, s) * by_step[step] for step, added in mechanism.steps]
            twists += list(sum(parts, sp.zeros(6, 1)))
        found[convention] = Lowering(Graph(mechanism.steps), {}, inputs).kernel(
            convention,
            f"a link, {convention} convention: rotation, shift; shift and turn by each error, by turn and slide",
            [*rotation, *shift, *twists],
        )
    return found


def measurements() -> Iterator[Measurement]:
    """Yield every registered kind of measurement: one per file in ``derive/measurements``."""
    return _registered(derive.measurements, "MEASUREMENT")


def kinematics(mechanism: LimbMechanism, text: Text = python) -> tuple[dict[str, Kernel], Blocks | None]:
    """Lower a mechanism to the kernels that ``kinematics.py.jinja`` calls, by name.

    Keys: `newton` (closure, its Jacobians by platform and joint), `parameters` (its Jacobian by errors and
    deflections), `sphere` (or `position`) and `joint` (the seeds), `constants`. What a command needs comes first, so
    that it reads the first columns of the constants only.
    """
    platform = [quantity.symbol for quantity in mechanism.platform]
    joint = mechanism.joint.symbol
    varied = [quantity.symbol for quantity in mechanism.varied]
    inputs = {s: f"x[{j}]" for j, s in enumerate(platform)}
    inputs |= {s.symbol: f"tool[{j}]" for j, s in enumerate(mechanism.tool)}
    inputs |= {joint: "q"}
    parameters = {s.symbol: f"p[{j}]" for j, s in enumerate(mechanism.limb_parameters)}
    graph = Graph(mechanism.steps, invariant=parameters)
    lowering = Lowering(graph, parameters, inputs, text=text)
    newton: list[sp.Expr] = []
    errors: list[sp.Expr] = []
    for closure in mechanism.loop_closure:
        by = graph.derivatives(closure, [*platform, joint, *varied])
        newton += [closure, *by[: len(platform) + 1]]
        errors += by[len(platform) + 1 :]
    kernels = [
        lowering.kernel(
            "newton", "per rod of one limb: closure, its derivatives by the platform, by the joint", newton, dense=True
        ),
        lowering.kernel(
            "joint",
            "joint of the simplified limb at a given position, then the platform's coordinates that follow from it",
            closed_form.start_of_inverse(mechanism),
            dense=True,
        ),
        lowering.kernel(
            "parameters", "per rod of one limb: derivatives of the closure by errors, by deflections", errors
        ),
        _seed(mechanism, lowering),
    ]
    if turns := turn_by_change(mechanism):
        kernels.append(lowering.kernel("spin", "turn about the axes of {O} by the Cayley vector", turns, dense=True))
    batch = blocks(mechanism, *_seeds(mechanism), lowering, graph) if text is python else None
    kernels.append(lowering.constants("constants", "what no pose changes"))
    return {kernel.name: kernel for kernel in kernels}, batch


def _seed(mechanism: LimbMechanism, lowering: Lowering) -> Kernel:
    """Lower what the forward position starts from: each limb as a sphere, or the closed form that the spec gives."""
    return lowering.kernel("position" if mechanism.seeds is not None else "sphere", *_seeds(mechanism), dense=True)


def _seeds(mechanism: LimbMechanism) -> tuple[str, list[sp.Expr]]:
    """Return what the forward position starts from, its meaning and expressions."""
    if mechanism.seeds is not None:
        position = [mechanism.seeds.get(quantity.symbol, sp.Integer(0)) for quantity in mechanism.platform]
        return "platform of the simplified machine at a given joint", position
    centre, constant = closed_form.sphere(mechanism)
    return "the simplified limb as a sphere |P|^2 - 2 c.P + d = 0: c, d", [*centre, 2 * constant]


def rotations() -> dict[str, Kernel]:
    """Lower a platform's rotation matrix by its Cayley vector, and the vector by the matrix, for ``poses.py``."""
    c = sp.Matrix(sp.symbols("cx cy cz", real=True))
    R = sp.Matrix(3, 3, lambda i, j: sp.Symbol(f"R_{i}{j}", real=True))
    by_vector = Lowering(Graph(), {}, {s: f"own[{3 + j}]" for j, s in enumerate(c)})
    by_matrix = Lowering(Graph(), {}, {s: f"pose[{3 + j}]" for j, s in enumerate(R)})
    kernels = (
        by_vector.kernel("matrix", "rotation matrix by the Cayley vector", list(vectors.cayley(c))),
        by_matrix.kernel("vector", "Cayley vector by the rotation matrix", list(vectors.cayley_vector(R))),
    )
    return {kernel.name: kernel for kernel in kernels}


def measurement(spec: Measurement) -> dict[str, Kernel]:
    """Lower a measurement to its reading and derivatives, evaluated where the instrument's increments are zero."""
    inputs = {
        s: f"{name}[:, {j}]"
        for name, platform in zip(_platform_names(spec), spec.platforms, strict=True)
        for j, s in enumerate(platform.coordinates)
    }
    inputs |= {quantity.symbol: f"given[:, {j}]" for j, quantity in enumerate(spec.given)}
    turns = [s for platform in spec.platforms for s in platform.turn]
    zero = dict.fromkeys((*(quantity.symbol for quantity in spec.unknown), *turns), 0)
    moved = [s for platform in spec.platforms for s in platform.displacement]
    unknown = [quantity.symbol for quantity in spec.unknown]

    def spin(symbol: sp.Symbol) -> sp.Matrix:
        """Return axial(dR R^T) of a product of rotations: the factor's own, turned by the factors before it."""
        before = sp.eye(3)
        for factor in spec.rotation:
            if factor.has(symbol):
                others = {s: 0 for s in zero if s != symbol}
                turning = (sp.diff(factor.subs(others), symbol) * factor.subs(others).T).subs(zero).applyfunc(sp.cancel)
                return before * sp.Matrix([turning[2, 1], turning[0, 2], turning[1, 0]])
            before = before * factor.subs(zero)
        return sp.zeros(3, 1)

    graph = Graph(spec.steps)

    def jacobian(by: list[sp.Symbol]) -> list[sp.Expr]:
        rows = [graph.derivatives(e, by) for e in spec.reading]
        if spec.rotation:
            spins = [spin(s) for s in by]
            rows += [[column[k] for column in spins] for k in range(3)]
        return [e for row in rows for e in row]

    outputs = {"reading": list(spec.reading), "by_platform": jacobian(moved), "by_unknown": jacobian(unknown)}
    if spec.rotation:
        outputs["rotation"] = list(sp.prod([sp.eye(3), *spec.rotation]))
    lowered = {name: [graph.add(e) for e in exprs] for name, exprs in outputs.items()}
    graph, values = graph.at(zero)
    lowering = Lowering(graph, {}, inputs)
    return {name: lowering.kernel(name, name, [e.xreplace(values) for e in leaves]) for name, leaves in lowered.items()}


def _platform_names(spec: Measurement) -> tuple[str, ...]:
    return ("x",) if len(spec.platforms) == 1 else ("x_a", "x_b")


def _columns(*kernels: Kernel) -> int:
    """Return how many of the first columns of the constants the kernels read."""
    return max(int(load[2:-1]) for kernel in kernels for _, load in kernel.loads if load.startswith("k[")) + 1


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
        return python(sp.sympify(value)).replace("math.", "np.")

    def symbols(value: Any) -> set[sp.Symbol]:
        if isinstance(value, Mapping):
            return set().union(*map(symbols, value.values()))
        return set(sp.sympify(value).free_symbols)

    return {"tables": text(found), "reads": {name: symbols(value) for name, value in found.items()}}


def _environment() -> jinja2.Environment:
    return jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )


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


def render() -> dict[Path, str]:
    """Derive and render every generated file; the keys are paths below the kernel package."""
    environment = _environment()
    found = list(mechanisms())
    texts = {
        Path(name): environment.get_template(f"{name}.jinja").render(
            mechanisms=found, kernels=rotations(), command=COMMAND
        )
        for name in ("__init__.py", "compiled.py", "direct.py", "elementary.py", "poses.py", "straight.py")
    }
    for mechanism in found:
        folder = Path(mechanism.name)
        texts[folder / "__init__.py"] = f'"""{mechanism.title}: tables and kernels."""\n'
        if isinstance(mechanism, ChainMechanism):
            files = {f"chain/{name}.py.jinja": f"{name}.py" for name in ("parameters", "links")}
            for template, name in files.items():
                texts[folder / name] = environment.get_template(template).render(
                    mechanism=mechanism, kernels=links(mechanism), stamp=_stamp(mechanism.source, template)
                )
            continue
        loads = statics.loads(mechanism)
        moving, batch = kinematics(mechanism)
        command_constants = _columns(moving["newton"], moving["joint"])
        ideal = nominal(mechanism, batch) if batch else None
        contents: dict[str, dict[str, Any]] = {
            "parameters.py": {},
            "constants.py": {"kernels": moving, "nominal": ideal},
            "blocks.py": {"blocks": batch},
            "kinematics.py": {"kernels": moving, "blocks": batch, "nominal": ideal},
            **({"nominal.py": {"blocks": batch, "nominal": ideal}} if ideal else {}),
            "servo.py": {
                "exact": servo.exact(mechanism),
                "linear": servo.linear(mechanism),
                "exported": linear(mechanism),
                "command_constants": command_constants,
            },
            "vectorised.py": {"kernels": moving},
            "statics.py": {"kernels": loads},
            "inverse.c": {"kernels": kinematics(mechanism, text=c99)[0], "constants": command_constants},
            "linear.c": {"kernels": linear(mechanism, text=c99)},
        }
        for name, context in contents.items():
            template = f"mechanism/{name}.jinja"
            texts[folder / name] = environment.get_template(template).render(
                mechanism=mechanism,
                stamp=_stamp(mechanism.source, template),
                **_tables(mechanism),
                **context,
            )
    texts[Path("measurements/__init__.py")] = '"""What instruments report: readings and their derivatives."""\n'
    for spec in measurements():
        template = "measurement.py.jinja"
        texts[Path("measurements") / f"{spec.name}.py"] = environment.get_template(template).render(
            measurement=spec,
            kernels=measurement(spec),
            arguments=", ".join(_platform_names(spec)),
            stamp=_stamp(spec.source, template),
        )
    found_effects = list(effects())
    texts[Path("effects/__init__.py")] = environment.get_template("effects.py.jinja").render(
        effects=found_effects, command=COMMAND
    )
    for physics in found_effects:
        for ending, text in (("py", python), ("c", c99)):
            states, lowered = effect(physics, text)
            if ending == "c" and not (set(physics.targets) == {"joint"} and {s.name for s in states} <= KNOWN_BEFORE):
                continue
            template = f"effect.{ending}.jinja"
            texts[Path("effects") / f"{physics.name}.{ending}"] = environment.get_template(template).render(
                effect=physics, states=states, kernels=lowered, stamp=_stamp(physics.source, template)
            )
    texts[SIZES] = sizes(texts)
    return texts


def sizes(texts: Mapping[Path, str]) -> str:
    """Return the table of how large each file is, so that growth is seen in every change."""
    rows = [f"{path.as_posix()},{text.count(chr(10))},{len(text.encode())}" for path, text in sorted(texts.items())]
    return "\n".join(["file,lines,bytes", *rows]) + "\n"


def committed() -> dict[Path, str]:
    """Return what stands in ``generated/`` now."""
    found = (path for path in sorted(GENERATED.rglob("*")) if path.suffix in {".py", ".c", ".csv"})
    return {path.relative_to(GENERATED): path.read_text(encoding="utf-8") for path in found}


def differences(fresh: dict[Path, str], old: dict[Path, str]) -> list[str]:
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


def write(fresh: dict[Path, str]) -> list[Path]:
    """Write what differs, delete what is left over; return the paths touched."""
    old = committed()
    touched = [path for path in sorted(fresh.keys() | old.keys()) if fresh.get(path) != old.get(path)]
    for path in touched:
        target = GENERATED / path
        if path in fresh:
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(fresh[path], encoding="utf-8", newline="\n")
        else:
            target.unlink()
    return touched
