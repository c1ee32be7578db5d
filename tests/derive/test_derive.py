"""The derivation's own parts: the graph and its derivatives, lowering, printing, what specs refuse, differences."""

from __future__ import annotations

import math
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

sp = pytest.importorskip("sympy", reason="deriving needs the dependency group 'derive'")
pytest.importorskip("jinja2", reason="deriving needs the dependency group 'derive'")

from scipy.linalg import expm  # noqa: E402

from derive import closed_form, compiler, registry, vectors  # noqa: E402
from derive.backends import c99, lanes, numpy, scalar  # noqa: E402
from derive.backends.ir import Kernel, Place  # noqa: E402
from derive.blocks import nominal  # noqa: E402
from derive.graph import Graph, expand_steps, inline  # noqa: E402
from derive.lower import lower  # noqa: E402
from derive.mathematics.functions import Functions, entries  # noqa: E402
from derive.mathematics.kinematics import kinematics  # noqa: E402
from derive.spec import LimbMechanism, Quantity  # noqa: E402

MECHANISM: Any = registry.mechanism("delta")
x, y, a, b = sp.symbols("x y a b", real=True)
AT = {x: 0.7, y: -1.3, a: 2.1, b: 0.4}

# smooth expressions with every construct that a mechanism uses: shared parts, powers, roots, signs, constants
EXPRESSIONS = [
    x,
    -x,
    sp.Integer(3),
    a * x + b,
    (a + b) ** 2 * x * y + (a + b) * x**3,
    sp.sin(a + x) * sp.cos(a + x) - sp.sqrt(1 + x**2 + a**2),
    sp.atan2(x + a, y - b) / (2 + x**2),
    (x - y) * (y - x) + sp.sqrt((x - y) ** 2 + a),
    -(a * b) * sp.cos(a * b) * x,
]


def written_out(graph: Graph, leaf: Any) -> Any:
    return expand_steps(leaf, list(graph.nodes.items()))


# ---------------------------------------------------------------------------------------------------------------- graph


@pytest.mark.parametrize("expr", EXPRESSIONS, ids=str)
@pytest.mark.parametrize("invariant", [(), (a, b)], ids=["all moving", "a and b invariant"])
def test_derivatives_on_the_graph_are_those_of_sympy(expr: Any, invariant: tuple[Any, ...]) -> None:
    graph = Graph(invariant=invariant)
    found = graph.derivatives(expr, [x, y, a, b])
    assert sp.simplify(written_out(graph, graph.add(expr)) - expr) == 0
    for leaf, symbol in zip(found, (x, y, a, b), strict=True):
        got, expected = written_out(graph, leaf), sp.diff(expr, symbol)
        assert float(got.subs(AT)) == pytest.approx(float(expected.subs(AT)), rel=1e-14, abs=1e-15)


def test_derivatives_pass_through_named_steps() -> None:
    r, phi, height = sp.symbols("r phi height", real=True)
    steps = [(r, sp.sqrt(x**2 + y**2)), (phi, sp.atan2(y, x)), (height, a * r + b * phi)]
    graph = Graph(steps, invariant=[a, b])
    found = graph.derivatives(height**2 + r, [x, y, a, b])
    whole = expand_steps(height**2 + r, steps)
    for leaf, symbol in zip(found, (x, y, a, b), strict=True):
        got = float(written_out(graph, leaf).subs(AT))
        assert got == pytest.approx(float(sp.diff(whole, symbol).subs(AT)), rel=1e-13)


def test_equal_subexpressions_share_one_node() -> None:
    graph = Graph()
    first = graph.add(sp.sin(x + y) * x)
    nodes = len(graph.nodes)
    assert graph.add(sp.sin(x + y) * x) == first
    assert graph.add(-sp.sin(x + y) * x) == -first  # and so does the negative
    assert len(graph.nodes) == nodes


def test_what_no_pose_changes_is_grouped_into_one_node() -> None:
    graph = Graph(invariant=[a, b])
    graph.add(a * b * x * y + a + b**2 + x)
    moving = [e for s, e in graph.nodes.items() if not graph.is_invariant(s)]
    for expr in moving:
        fixed = [arg for arg in expr.args if graph.is_invariant(arg) and arg.free_symbols]
        assert len(fixed) <= 1, expr  # one product, one sum, evaluated once per machine
    assert all(not e.has(a, b) or graph.is_invariant(e) for e in moving)


def test_needed_nodes_come_in_order_and_no_others() -> None:
    graph = Graph()
    wanted, other = graph.add(sp.sin(x + 1) + sp.cos(y)), graph.add(sp.exp(x * y))
    found = list(graph.needed([wanted]))
    assert other not in found
    known: set[Any] = {x, y}
    for symbol in found:
        assert graph.nodes[symbol].free_symbols <= known
        known.add(symbol)


def test_inlining_changes_no_value_and_keeps_named_steps() -> None:
    graph = Graph([(sp.Symbol("reach", real=True), sp.sqrt(x**2 + a))])
    leaf = graph.add(sp.sin(sp.Symbol("reach", real=True) + y) * 3)
    nodes, outputs = inline(graph.needed([leaf]), [leaf])
    assert len(nodes) < len(graph.needed([leaf]))
    assert sp.Symbol("reach", real=True) in nodes
    got = expand_steps(outputs[0], list(nodes.items()))
    assert float(got.subs(AT)) == pytest.approx(3 * math.sin(math.sqrt(0.49 + 2.1) - 1.3), rel=1e-14)


# ------------------------------------------------------------------------------------------------ lowering and printing


def run(kernel: Kernel, **arrays: Any) -> list[float]:
    """Execute a kernel's lines as a template would write them."""
    out = [0.0] * kernel.length
    exec("\n".join(scalar.lines(kernel).all), {"math": math, "out": out, **arrays})
    return out


def test_a_toy_of_two_symbols_becomes_ten_lines() -> None:
    functions = Functions(Graph(invariant=[a]), entries("p", [a]), entries("x", [x]))
    functions.add("toy", "a toy", [sp.cos(a) * x, sp.Integer(0), sp.cos(a) ** 2 + x**2])
    functions.constants("constants", "what no pose changes")
    kernels = lower(functions)
    kernel, constants = kernels["toy"], kernels["constants"]
    assert (kernel.name, kernel.meaning, kernel.length) == ("toy", "a toy", 3)
    assert (kernel.loads[0].symbol, kernel.loads[0].place) == (x, Place("x", 0))
    assert kernel.reads("k") == [0, 1]  # cos(a) and its square, once per machine
    assert [store.index for store in kernel.stores] == [0, 2]  # what is identically zero is not stored
    assert constants.length == 2
    k = run(constants, p=[0.3])
    assert sorted(k) == pytest.approx(sorted([math.cos(0.3), math.cos(0.3) ** 2]))
    assert run(kernel, x=[1.7], k=k) == pytest.approx([1.7 * math.cos(0.3), 0.0, math.cos(0.3) ** 2 + 1.7**2])


def test_what_is_asked_for_densely_is_stored_though_it_is_zero_and_what_nobody_reads_never() -> None:
    functions = Functions(Graph(), {}, entries("x", [x]))
    functions.add("dense", "", [sp.Integer(0), None, x], dense=True)
    kernel = lower(functions)["dense"]
    assert [(store.index, store.expr) for store in kernel.stores] == [(0, 0), (2, x)]
    assert kernel.length == 3


def test_a_function_without_a_source_for_a_symbol_is_refused() -> None:
    functions = Functions(Graph(), {}, entries("x", [x]))
    functions.add("toy", "", [x * y])
    with pytest.raises(ValueError, match="kernel toy uses y, for which no source is given"):
        lower(functions)


def test_a_function_cannot_be_derived_twice() -> None:
    functions = Functions(Graph(), {}, entries("x", [x]))
    functions.add("toy", "", [x])
    with pytest.raises(ValueError, match="'toy' is derived twice"):
        functions.add("toy", "", [x])


def test_every_target_lays_the_same_kernel_out_in_its_own_way() -> None:
    cos = sp.Symbol("cos", real=True)
    functions = Functions(Graph(), {}, {x: Place("w", 32, lane=True), **entries("c", [cos])})
    functions.add("f", "", [cos * sp.sin(x), sp.Integer(2)])
    kernel = lower(functions)["f"]
    block = lanes.block(kernel, at=3, size=16, copies=(0, 5), single=(1,))
    assert block.loads == ["cos = c[0]"]  # the same for all lanes
    assert block.assigns == ["x = w[32 + lane]", "s1 = cos*sine(x)"]
    assert block.stores == ["w[48 + lane] = s1", "w[128 + lane] = s1", "w[64 + lane] = 2"]
    assert numpy.over_rows(kernel, ["w"]).loads == ["x = w[32]", "cos = c[:, 0]"]
    assert c99.function(kernel, ["w", "c", "unused"]).all[:2] == ["const double x = w[32];", "const double cos = c[0];"]
    assert "(void)(unused);" in c99.function(kernel, ["w", "c", "unused"]).all


@pytest.mark.parametrize(
    ("expr", "text"),
    [
        (x**2, "(x * x)"),
        (x**3, "(x * x * x)"),
        (1 / x, "(1.0 / x)"),
        (x**-2, "(1.0 / (x * x))"),
        (sp.sqrt(x), "math.sqrt(x)"),
        (x / 2, "0.5*x"),
        (sp.Rational(1, 3) * x, "0.3333333333333333*x"),
        (sp.atan2(y, x), "math.atan2(y, x)"),
    ],
)
def test_python_is_printed_for_numba(expr: Any, text: str) -> None:
    assert scalar.expression(expr) == text


def test_printed_text_has_the_value_of_the_expression() -> None:
    for expr in EXPRESSIONS:
        value = eval(scalar.expression(expr), {"math": math}, {str(s): v for s, v in AT.items()})
        assert value == pytest.approx(float(expr.subs(AT)), rel=1e-15)
    assert c99.PRINTER.expression(x**2 + sp.sqrt(y)) == "(x * x) + sqrt(y)"


# -------------------------------------------------------------------------------------------------------------- vectors


@pytest.mark.parametrize("v", [(0.0, 0.0, 0.0), (1e-9, 0.0, 0.0), (0.1, -0.2, 0.05), (0.4, 0.4, -0.4)])
def test_the_polynomial_of_a_rotation_vector_is_the_exponential(v: tuple[float, float, float]) -> None:
    """Up to 0.7 rad to rounding, as its docstring says; and smooth at zero, where every nominal machine stands."""
    symbols = sp.symbols("u v w", real=True)
    matrix = np.array(sp.lambdify(symbols, vectors.rotation_vector(sp.Matrix(symbols)))(*v), dtype=float)
    K = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    assert matrix == pytest.approx(expm(K), abs=4e-16)


def test_a_cayley_map_is_a_rotation_equal_to_its_vector_at_zero() -> None:
    c = sp.Matrix(sp.symbols("c1:4", real=True))
    R = vectors.cayley(c)
    assert sp.simplify(R * R.T) == sp.eye(3)
    zero = dict.fromkeys(c, 0)
    for i in range(3):
        unit = sp.Matrix([1 if j == i else 0 for j in range(3)])
        assert sp.diff(R, c[i]).subs(zero) == vectors.skew(unit)


# ---------------------------------------------------------------------------------------------------------------- specs


def changed(**fields: Any) -> Any:
    """Return the Delta with fields changed; its constructor checks them."""
    import dataclasses

    return dataclasses.replace(MECHANISM, **fields)


def test_quantities_say_what_they_are() -> None:
    with pytest.raises(ValueError, match="x: unit 'm' is none of"):
        Quantity(x, "m", "a length")
    with pytest.raises(ValueError, match="x has no meaning in its table; add one line"):
        Quantity(x, "mm", "")


def test_every_quantity_of_every_registered_mechanism_has_a_meaning() -> None:
    for mechanism in registry.mechanisms():
        named = mechanism.errors
        if isinstance(mechanism, LimbMechanism):
            named += (
                *mechanism.platform,
                *mechanism.tool,
                *mechanism.common,
                *mechanism.deflections,
                *mechanism.masses,
            )
        assert all(quantity.meaning for quantity in named)
        assert (compiler.ROOT / mechanism.source).is_file()


def test_a_closure_with_an_undeclared_symbol_is_refused_by_name() -> None:
    closure = (MECHANISM.loop_closure[0] + sp.Symbol("stray", real=True), MECHANISM.loop_closure[1])
    with pytest.raises(ValueError, match="delta: the loop closure uses stray, which no table declares"):
        changed(loop_closure=closure)


def test_a_model_with_an_unknown_parameter_is_refused_by_name() -> None:
    with pytest.raises(ValueError, match=r"delta: model delta/1 asks for \['nonsense_1'\]"):
        changed(models={"delta/1": ("nonsense_1",)})


def test_a_name_declared_twice_is_refused() -> None:
    with pytest.raises(ValueError, match="dc"):
        changed(errors=(*MECHANISM.errors, next(e for e in MECHANISM.errors if e.name == "dc")))


# ---------------------------------------------------------------------------------------------------------- the machine


def test_the_models_have_the_sizes_in_their_names() -> None:
    for name, chosen in MECHANISM.models.items():
        assert len(set(chosen)) == len(chosen) == int(name.removeprefix("delta/"))
    removed = set(MECHANISM.models["delta/36"]) - set(MECHANISM.models["delta/32"])
    assert removed == {"alpha03_2", "alpha03_3", "beta03_3", "alpha2_3"}  # Bai, below eq. (19)
    fixed = set(MECHANISM.models["delta/42"]) - set(MECHANISM.models["delta/36"])
    assert fixed == {"ex_1", "ey_2", "ey_3", "ez_1", "ez_2", "ez_3"}  # Bai, eq. (11)


def test_the_simplified_machine_is_a_sphere_about_the_shifted_elbow() -> None:
    """Bai's nominal geometry: the elbow moved in by the platform's radius, the rods' length the radius."""
    b_, a_, L_, l_, q = sp.symbols("b a L l q", real=True)
    centre, constant = closed_form.sphere(MECHANISM)
    zero = {s: 0 for s in (*centre.free_symbols, *constant.free_symbols) if s not in (b_, a_, L_, l_, q)}
    zero[sp.Symbol("phi", real=True)] = sp.Rational(1, 3)
    elbow = b_ - a_ + L_ * sp.cos(q)
    expected = sp.Matrix([elbow * sp.cos(sp.Rational(1, 3)), elbow * sp.sin(sp.Rational(1, 3)), L_ * sp.sin(q)])
    assert (centre.subs(zero) - expected).applyfunc(sp.simplify) == sp.zeros(3, 1)
    assert sp.simplify(constant.subs(zero) - (elbow**2 + (L_ * sp.sin(q)) ** 2 - l_**2) / 2) == 0


@pytest.mark.parametrize("name", ["diamond", "linear_delta"])
def test_what_the_nominal_sensitivity_multiplies_has_been_stored(name: str) -> None:
    """Scratch holds what was left over: a derivative that is zero has to be written there too."""
    (mechanism,) = compiler.collect([name])
    assert isinstance(mechanism, LimbMechanism)
    _, layout = kinematics(mechanism)
    ideal = nominal(mechanism, layout)
    assert ideal is not None
    stored = {layout.limb["rows"] + store.index for store in lower(ideal.functions[0])["nominal"].stores}
    read = {place // layout.lanes % layout.stride for places in ideal.values for place in places}
    assert read <= stored


# ------------------------------------------------------------------------------------------------------ what is emitted


@pytest.fixture
def package(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A copy of the committed kernels that may be written to."""
    copy = tmp_path / "deltacal_kernels"
    shutil.copytree(compiler.GENERATED, copy, ignore=shutil.ignore_patterns("__pycache__"))
    monkeypatch.setattr(compiler, "GENERATED", copy)
    return copy


@pytest.mark.walk
def test_one_name_is_derived_alone_and_leaves_what_is_of_others(package: Path) -> None:
    for path in ("effects/backlash.py", "effects/backlash.c", "measurements/pose.py", "delta/servo.py"):
        (package / path).write_text("x = 1\n")
    (package / "effects/backlash.csv").write_text("left over\n")
    names = ["backlash", "pose"]
    touched = compiler.write(compiler.render(names), compiler.committed(names))
    assert {"effects/backlash.py", "effects/backlash.c", "measurements/pose.py"} < {str(path) for path in touched}
    whole = {
        path: (compiler.ROOT / "generated/deltacal_kernels" / path).read_text()
        for path in touched
        if path.suffix != ".csv"
    }
    assert all((package / path).read_text() == text for path, text in whole.items())
    assert not (package / "effects/backlash.csv").exists()
    assert (package / "delta/servo.py").read_text() == "x = 1\n"  # of another name


def test_what_is_registered_but_not_derived_yet_is_in_no_table(package: Path) -> None:
    (package / "effects/latency.py").unlink()
    shutil.rmtree(package / "diamond")
    texts = compiler.render(["backlash"])
    assert '"latency"' not in texts[Path("effects/__init__.py")]
    assert '"diamond"' not in texts[Path("__init__.py")]
    assert '"latency"' in compiler.render(["latency"])[Path("effects/__init__.py")]


def test_an_unknown_name_is_refused_with_those_there_are() -> None:
    with pytest.raises(
        ValueError, match=r"nothing is registered as nonsense; there are complete_delta, delta, .*backlash"
    ):
        compiler.render(["nonsense"])


def test_differences_name_missing_left_over_and_changed_files() -> None:
    fresh = {Path("new.py"): "a\n", Path("same.py"): "b\n", Path("changed.py"): "c\nd\n"}
    old = {Path("gone.py"): "e\n", Path("same.py"): "b\n", Path("changed.py"): "c\nx\n"}
    found = compiler.differences(fresh, old)
    assert len(found) == 3
    text = "\n".join(found)
    assert "+++ derived/new.py" in text
    assert "--- committed/gone.py" in text
    assert "-x" in text
    assert "+d" in text
    assert compiler.differences(fresh, fresh) == []


@pytest.mark.walk
def test_kernels_do_not_depend_on_how_python_hashes() -> None:
    place = {"PYTHONPATH": os.pathsep.join(sys.path), "PYTHONHASHSEED": "7"}  # the committed ones are of seed 0
    command = [sys.executable, "-m", "derive", "diamond", "--check"]
    done = subprocess.run(command, cwd=compiler.ROOT, env=os.environ | place, capture_output=True, text=True)
    assert "files are what derive/ yields" in done.stdout, done.stderr


@pytest.mark.parametrize(
    ("entry", "zero"),
    [
        (sp.sin(x) ** 2 + sp.cos(x) ** 2 - 1, True),
        ((x + 1) ** 2 - x**2 - 2 * x - 1, True),
        (sp.sin(2 * x) - sp.sin(x), False),
        (1e-7 * x, False),
    ],
)
def test_what_vanishes_is_told_by_algebra_and_what_does_not_by_numbers(entry: Any, zero: bool) -> None:
    assert closed_form.vanishes(sp.Matrix([[0, entry]])) is zero


def test_committed_kernels_name_their_source_and_are_of_this_derivation() -> None:
    """The digests in the headers are of the sources and templates as they stand: a stale kernel is found at once.

    Byte for byte it is `deltacal kernels --check`, which derives everything anew.
    """
    seen = 0
    for path, text in compiler.committed().items():
        header = re.search(r"Generated from (\S+) by .*?Template (\S+); sha256 of both ([0-9a-f]{16})", text, re.DOTALL)
        if header:
            source, template, digest = header.groups()
            assert digest == compiler._digest(compiler.ROOT / source, compiler.ROOT / template), path
            seen += 1
    assert seen >= 8


def test_the_table_of_sizes_is_of_these_files() -> None:
    found = compiler.committed()
    assert found.pop(compiler.SIZES) == compiler.sizes(found)
