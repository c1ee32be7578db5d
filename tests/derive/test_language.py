"""The language of effects: every target computes what SymPy means, derivatives too, and anything else is refused."""

from __future__ import annotations

import contextlib
import ctypes
import importlib.util
import math
import shutil
import subprocess
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, Phase, given, settings
from hypothesis import strategies as st

sp = pytest.importorskip("sympy", reason="deriving needs the dependency group 'derive'")
pytest.importorskip("jinja2", reason="deriving needs the dependency group 'derive'")

from mpmath import mp, mpf, mpmathify  # noqa: E402

from derive.backends import c99, lanes, numpy, scalar  # noqa: E402
from derive.backends.ir import Kernel, Place  # noqa: E402
from derive.graph import Graph  # noqa: E402
from derive.language.vocabulary import FUNCTIONS, check  # noqa: E402
from derive.lower import lower  # noqa: E402
from derive.mathematics.derivative import derivative  # noqa: E402
from derive.mathematics.functions import Functions  # noqa: E402

SYMBOLS = x, y, z = sp.symbols("x y z", real=True)
DIGITS = 40
NEAR = mpf("1e-12")  # of a kink: where the value changes by more than SMOOTH times this, it is not compared
SMOOTH = 1e4
LARGE = 1e6  # no value beyond is compared


def leaves() -> st.SearchStrategy[Any]:
    numbers = st.sampled_from([1, -2, sp.Rational(1, 3), sp.Rational(-7, 5), sp.pi, sp.Float(0.37)])
    return st.one_of(st.sampled_from(SYMBOLS), st.sampled_from(SYMBOLS), numbers.map(sp.sympify))


def grown(inner: st.SearchStrategy[Any]) -> st.SearchStrategy[Any]:
    """Return expressions of one function or operation more."""
    comparison = st.builds(lambda order, a, b: order(a, b), st.sampled_from([sp.Lt, sp.Le, sp.Gt, sp.Ge]), inner, inner)
    condition = st.one_of(
        comparison, st.builds(sp.And, comparison, comparison), st.builds(sp.Or, comparison, comparison)
    )
    single = [sp.Abs, sp.sign, sp.sin, sp.cos, sp.tanh, sp.floor, sp.Heaviside]
    return st.one_of(
        st.builds(sp.Add, inner, inner),
        st.builds(sp.Mul, inner, inner),
        st.builds(lambda a, b: a / (1 + b**2), inner, inner),
        st.builds(lambda a, n: a**n, inner, st.sampled_from([2, 3, 5])),
        st.builds(lambda a, n: sp.Abs(a) ** n, inner, st.sampled_from([sp.Rational(1, 2), sp.Rational(3, 2), 0.7])),
        st.builds(lambda f, a: f(a), st.sampled_from(single), inner),
        st.builds(lambda a: sp.exp(-(a**2)), inner),
        st.builds(lambda a: sp.log(1 + sp.Abs(a)), inner),
        st.builds(lambda a: sp.asin(sp.tanh(a) / 2), inner),
        st.builds(sp.Max, inner, inner),
        st.builds(sp.Min, inner, inner, inner),
        st.builds(sp.Mod, inner, st.sampled_from([sp.Integer(2), sp.Rational(3, 4), sp.pi])),
        st.builds(lambda a, c, b: sp.Piecewise((a, c), (b, True)), inner, condition, inner),
    )


def real(e: Any) -> bool:
    """Tell whether an expression depends on anything, and SymPy does not take it for a complex one: Abs(asin(x))**2."""
    return e.is_real is not False and bool(e.free_symbols) and not e.has(sp.re, sp.im)


expressions = st.recursive(leaves(), grown, max_leaves=6).filter(real)


def lowered(outputs: list[Any], lanes_of: int | None = None) -> Kernel:
    """Return one kernel of all outputs; its inputs stand in s, or in lane arrays of w."""
    places = {
        s: Place("s", j) if lanes_of is None else Place("w", j * lanes_of, lane=True) for j, s in enumerate(SYMBOLS)
    }
    functions = Functions(Graph(), {}, places)
    functions.add("f", "a test", outputs, dense=True)
    return lower(functions)["f"]


def by_numpy(outputs: list[Any], points: np.ndarray) -> np.ndarray:
    kernel = lowered(outputs)
    names = {"np": np, "s": points, "out": np.empty((len(points), len(outputs)))}
    with np.errstate(all="ignore"):
        exec("\n".join(numpy.over_rows(kernel).all), names)
    return np.asarray(names["out"])


def by_single_numbers(outputs: list[Any], points: np.ndarray) -> np.ndarray:
    """Run the text of single numbers by Python; where it raises, as at the root of a negative number, is NaN."""
    found = np.full((len(points), len(outputs)), np.nan)
    for j, output in enumerate(outputs):
        code = compile("\n".join(scalar.lines(lowered([output])).all), "single", "exec")
        for s, out in zip(points.tolist(), found, strict=True):
            with contextlib.suppress(ValueError, ZeroDivisionError, OverflowError, TypeError):
                exec(code, {"math": math, "s": s, "out": out[j : j + 1]})
    return found


def by_lanes(outputs: list[Any], points: np.ndarray, folder: Path) -> np.ndarray:
    """Compile a kernel over lanes by what stands in the package of kernels."""
    n = len(points)
    lines = lanes.block(lowered(outputs, n), at=len(SYMBOLS), size=n)
    body = "\n        ".join([*lines.assigns, *lines.stores])
    used = ", ".join(["larger", "smaller", *lanes.PRINTER.functions.values()])
    text = (
        "import math\nimport numpy as np\nfrom numba import njit\n"
        f"from deltacal_kernels.elementary import {used}\nfrom deltacal_kernels.straight import straight\n"
        f"@straight\ndef kernel(w, n):\n    for lane in range(n):\n        {body}\n"
        "@njit\ndef run(w, n):\n    kernel(w, n)\n"
    )
    path = folder / f"lanes_{abs(hash(text))}.py"
    path.write_text(text)
    spec = importlib.util.spec_from_file_location(path.stem, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    w = np.concatenate([points.T.ravel(), np.full(n * len(outputs), np.nan)])
    module.run(w, n)
    return w[points.size :].reshape(len(outputs), n).T


def by_c(outputs: list[Any], points: np.ndarray, folder: Path) -> np.ndarray:
    lines = "\n".join(c99.function(lowered(outputs), ["s"]).all)
    source = folder / "kernel.c"
    source.write_text(f"#include <math.h>\nvoid f(const double *s, double *out)\n{{\n{lines}\n}}\n")
    library = folder / f"kernel_{len(list(folder.iterdir()))}.so"
    flags = [
        "-std=c99",
        "-Wall",
        "-Wextra",
        "-Werror",
        "-Wno-unused-variable",
        "-O1",
        "-shared",
        "-fPIC",
        "-ffp-contract=off",
    ]
    subprocess.run(["gcc", *flags, "-D_XOPEN_SOURCE=600", str(source), "-o", str(library), "-lm"], check=True)
    f = ctypes.CDLL(str(library)).f
    found = np.full((len(points), len(outputs)), np.nan)
    pointer = ctypes.POINTER(ctypes.c_double)
    for s, out in zip(np.ascontiguousarray(points), found, strict=True):
        f(s.ctypes.data_as(pointer), out.ctypes.data_as(pointer))
    return found


def exact(expr: Any, points: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return value and gradient (N, 3) by many digits, and (N,) where the expression is smooth and of ordinary size."""
    of = sp.lambdify(SYMBOLS, expr, "mpmath")
    values, slopes, good = np.zeros(len(points)), np.zeros((len(points), 3)), np.zeros(len(points), dtype=bool)
    with mp.workdps(DIGITS):
        for n, point in enumerate(points.tolist()):
            at = [mpmathify(v) for v in point]
            try:
                middle = mpmathify(of(*at))
                sides = []
                for j in range(len(SYMBOLS)):
                    shifted = [[v + sign * NEAR * (k == j) for k, v in enumerate(at)] for sign in (1, -1)]
                    sides.append([mpmathify(of(*s)) for s in shifted])
            except (ZeroDivisionError, ValueError, TypeError):  # an infinite slope, a complex number
                continue
            every = [middle, *(v for pair in sides for v in pair)]
            if any(mp.im(v) != 0 or abs(v) > LARGE for v in every):
                continue
            steps = [(abs(up - middle), abs(middle - down)) for up, down in sides]
            gradient = [(up - down) / (2 * NEAR) for up, down in sides]
            bent = any(abs(a - b) > NEAR * mpf("1e-6") * (1 + a / NEAR) for a, b in steps)
            if bent or any(abs(slope) > SMOOTH for slope in gradient):
                continue
            values[n], slopes[n], good[n] = float(middle), [float(v) for v in gradient], True
    return values, slopes, good


@pytest.mark.walk
@pytest.mark.skipif(shutil.which("gcc") is None, reason="C is compiled by gcc, which is not installed")
@settings(
    max_examples=6,
    derandomize=True,
    deadline=None,
    suppress_health_check=list(HealthCheck),
    phases=[Phase.explicit, Phase.reuse, Phase.generate],  # to shrink twelve expressions would compile for minutes
)
@given(st.lists(expressions, min_size=12, max_size=12), st.integers(0, 2**32 - 1))
def test_every_target_computes_what_sympy_means(drawn: list[Any], seed: int) -> None:
    for e in drawn:
        check("drawn", e)
    points = np.random.default_rng(seed).uniform(-2.5, 2.5, (16, 3))
    outputs = [part for e in drawn for part in (e, *(derivative(e, s) for s in SYMBOLS))]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        found = {
            "NumPy": by_numpy(outputs, points),
            "single": by_single_numbers(outputs, points),
            "lanes": by_lanes(outputs, points, folder),
            "C": by_c(outputs, points, folder),
        }
    compared = 0
    for j, e in enumerate(drawn):
        value, slope, good = exact(e, points)
        compared += int(good.sum())
        for target, results in found.items():
            got = results[good, 4 * j : 4 * j + 4]
            sizes = 1 + np.abs(value[good]) + np.abs(slope[good]).sum(axis=1)
            assert np.abs(got[:, 0] - value[good]).max(initial=0.0) <= 1e-12 * sizes.max(initial=1.0), (target, e)
            assert (np.abs(got[:, 1:] - slope[good]) <= 1e-9 * sizes[:, None] ** 2).all(), (target, e)
    assert compared > 0


ONE_OF_EACH = {
    sp.Abs: sp.Abs(x - y),
    sp.sign: z * sp.sign(x - y),
    sp.exp: sp.exp(-((x - y) ** 2)),
    sp.log: sp.log(2 + x * y),
    sp.sin: sp.sin(3 * x),
    sp.cos: sp.cos(x - y),
    sp.asin: sp.asin(x / 3),
    sp.tanh: sp.tanh(5 * x * y),
    sp.Max: sp.Max(x - 1, y, 0),
    sp.Min: sp.Min(x, z) * y,
    sp.Heaviside: z * sp.Heaviside(x - y),
    sp.Piecewise: sp.Piecewise((x, (x > 1) & (y < 1)), (x**2, sp.Or(x < -1, sp.And(sp.Eq(y, 0), z < 5))), (1, True)),
    sp.Mod: sp.Mod(x, sp.Rational(3, 4)) + sp.Mod(y, 1 + z**2),
    sp.floor: z * sp.floor(3 * x),
}
AT_KINKS = np.array([[0.0, 0.0, 1.0], [1.0, 1.0, -2.0], [-1.0, 0.0, 0.5], [1.5, 1.5, 0.0], [2.0, 1.0, 1.0]])


def test_every_function_of_the_language_is_among_them() -> None:
    assert set(ONE_OF_EACH) == set(FUNCTIONS)
    assert all(e.has(f) for f, e in ONE_OF_EACH.items())


@pytest.mark.skipif(shutil.which("gcc") is None, reason="C is compiled by gcc, which is not installed")
def test_values_at_kinks_and_jumps_are_those_of_sympy_in_every_target(tmp_path: Path) -> None:
    outputs = list(ONE_OF_EACH.values())
    expected = [
        [float(e.xreplace(dict(zip(SYMBOLS, map(sp.Rational, p), strict=True)))) for e in outputs] for p in AT_KINKS
    ]
    for found in (
        by_numpy(outputs, AT_KINKS),
        by_single_numbers(outputs, AT_KINKS),
        by_lanes(outputs, AT_KINKS, tmp_path),
        by_c(outputs, AT_KINKS, tmp_path),
    ):
        np.testing.assert_allclose(found, expected, rtol=1e-15, atol=1e-15)


@pytest.mark.parametrize("jump", [sp.sign(x), sp.floor(x), sp.Heaviside(x), sp.sign(sp.floor(3 * x) + y)])
def test_the_derivative_of_a_jump_is_zero(jump: Any) -> None:
    assert derivative(jump, x) == 0
    assert derivative(y * jump, y) == jump


@pytest.mark.parametrize(
    ("kink", "sides"),
    [
        (sp.Abs(x), (-1, 1)),
        (sp.Max(x, 0), (0, 1)),
        (sp.Min(x, -x), (1, -1)),
        (sp.Piecewise((x**2, x < 0), (3 * x, True)), (0, 3)),
        (sp.sqrt(x**2) * sp.cos(x), (-1, 1)),
    ],
)
def test_the_derivative_at_a_kink_is_that_of_one_side(kink: Any, sides: tuple[int, int]) -> None:
    slope = derivative(kink, x)
    assert slope.subs(x, 0) in sides
    assert not slope.has(sp.DiracDelta, sp.Derivative, sp.Subs)
    for side, at in zip(sides, (sp.Rational(-1, 10**9), sp.Rational(1, 10**9)), strict=True):
        assert float(slope.subs(x, at)) == pytest.approx(side, abs=1e-8)


def test_a_comparison_of_a_choice_is_one_of_comparisons() -> None:
    """SymPy makes ``ITE(y >= 1, True, x <= z)`` of it."""
    e = sp.Max(sp.Piecewise((z, y >= 1), (x, True)), z)
    slope = derivative(e, x)
    check("drawn", slope)
    assert slope.has(sp.ITE)
    points = np.array([[1.0, 2.0, 3.0], [5.0, 0.0, 3.0], [1.0, 0.0, 3.0]])
    np.testing.assert_array_equal(by_numpy([e, slope], points), [[3.0, 0.0], [5.0, 1.0], [3.0, 0.0]])


def test_what_is_not_chosen_does_not_spoil_a_derivative() -> None:
    """The root of a negative number is in the branch that is not taken."""
    e = sp.Piecewise((sp.sqrt(x), x > 0), (y, True))
    found = by_numpy([e, derivative(e, x), derivative(e, y)], np.array([[-1.0, 3.0, 0.0], [4.0, 3.0, 0.0]]))
    np.testing.assert_array_equal(found, [[3.0, 0.0, 1.0], [2.0, 0.25, 0.0]])


@pytest.mark.parametrize(
    ("expr", "named"),
    [
        (sp.tan(x), "tan"),
        (sp.Function("wear")(x) + 1, "wear"),
        (x**y, "a power with the exponent y"),
        (sp.Piecewise((x, x > 1)), "a Piecewise without a last case"),
        (sp.I * x, "I"),
        (x + sp.oo * y, "oo"),
        (sp.Symbol("t") * x, "the symbol t, which is not declared real"),
        (sp.Integral(sp.sin(x) / x, x), "Integral"),
        (sp.DiracDelta(x), "DiracDelta"),
    ],
)
def test_anything_else_is_refused_by_name(expr: Any, named: str) -> None:
    with pytest.raises(ValueError, match=f"drawn: .*{named}.* cannot be written in every target.*sqrt, Abs, sign"):
        check("drawn", expr)
