"""Loops over lanes, which a compiler turns into SIMD code: no branches, no calls that it cannot look into."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import ClassVar

import sympy as sp
from sympy.printing.precedence import PRECEDENCE

from derive.backends.ir import RATES, Kernel, Load, Place
from derive.backends.scalar import Python
from derive.backends.text import PRODUCTS, Layout, Lines, Names, arrays, loaded, written


class Lanes(Python):
    """Python of single numbers, elementary functions by those of ``support/elementary.py``."""

    functions: ClassVar = {
        "asin": "arcsine",
        "atan2": "arctangent",
        "cos": "cosine",
        "exp": "exponential",
        "log": "logarithm",
        "sin": "sine",
        "tan": "tangent",
        "tanh": "hyperbolic_tangent",
    }
    floor: ClassVar = "np.floor"
    larger: ClassVar = "larger"
    smaller: ClassVar = "smaller"

    def _print_Pow(self, expr: sp.Pow, rational: bool = False) -> str:
        """Return a power by products and roots; what neither gives goes through the logarithm."""
        twice, base = 2 * expr.exp, self.parenthesize(expr.base, PRECEDENCE["Pow"])
        if abs(expr.exp) in (1, *PRODUCTS, sp.Rational(1, 2)) and expr.exp not in (-3, -4):
            return str(super()._print_Pow(expr, rational))
        if not twice.is_Integer:
            return f"exponential({self._print(expr.exp)} * logarithm({self._print(expr.base)}))"
        whole, half = divmod(abs(int(twice)), 2)
        product = " * ".join([base] * whole + [f"{self.root}({self._print(expr.base)})"] * half)
        return f"({product})" if expr.exp > 0 else f"(1.0 / ({product}))"


PRINTER = Lanes()


def place(at: Place) -> str:
    """Return the text of a place."""
    return f"{at.array}[{at.index} + lane]" if at.lane else arrays()(at)


def block(
    kernel: Kernel,
    at: int,
    size: int,
    copies: Sequence[int] = (0,),
    single: Collection[int] = (),
    regions: Mapping[str, int | Sequence[int]] | None = None,
    into: str = "w",
) -> Lines:
    """Return the lines of a kernel over the lane arrays of one block of poses, its result from lane array `at` on.

    What is the same for all lanes is loaded before the loop: `Lines.loads`, the rest is the body of the loop.

    Parameters
    ----------
    size : int
        Lanes of a lane array.
    copies : sequence of int
        Where the result is written, in lane arrays further on.
    single : collection of int
        Entries of the result that are written at the first of `copies` only.
    regions : mapping, optional
        Arrays whose numbers stand in lane arrays of w: the first one, or that of each number. Their rates stand in the
        same of ``w_by``.
    into : str
        The array of the result.
    """
    regions = regions or {}
    kernel = replace(kernel, loads=tuple(_laid(load, regions, size) for load in kernel.loads))
    outside = [load for load in kernel.loads if not load.place.lane]
    inside = [load for load in kernel.loads if load.place.lane]
    lines = written(kernel, PRINTER, place, str)
    stores = [
        f"{into}[{(copy + at + store.index) * size} + lane] = {PRINTER.expression(store.expr)}"
        for store in kernel.stores
        for copy in (copies[:1] if store.index in single else copies)
    ]
    loads, first = ([line for x in part for line in loaded(x, PRINTER, place)] for part in (outside, inside))
    return Lines(loads, [*first, *lines.assigns], stores)


def _laid(load: Load, regions: Mapping[str, int | Sequence[int]], size: int) -> Load:
    """Return a load from the lane arrays of its array, where that has some."""
    array, index = load.place.array.removesuffix(RATES), load.place.index
    if index is None or array not in regions:
        return load
    slots = regions[array]
    slot = slots + index if isinstance(slots, int) else slots[index]
    into = "w" if array == load.place.array else f"w{RATES}"
    return Load(load.symbol, Place(into, slot * size, lane=True))


def rows(kernel: Kernel, array: str, width: int) -> Lines:
    """Return the body of a loop over the rows of flat arrays, `array` with rows of a width, or rates of it, and k."""
    layout = arrays(**{name: f"{name}[{width} * lane + {{}}]" for name in (array, f"{array}{RATES}")})
    return written(kernel, PRINTER, layout, lambda j: f"k[{kernel.length} * lane + {j}]")


@dataclass(frozen=True)
class RowFunction:
    """A kernel as a function over rows, for text in which it is a loop over them.

    Attributes
    ----------
    name : str
    kernel : Kernel
    arguments : tuple of str
        Names of the arrays.
    shape : tuple of int
        Of what a row results in.
    shared : tuple of str
        Arrays that are the same for all rows; of the others, row `lane` begins at ``ARRAY_every * lane``.
    """

    name: str
    kernel: Kernel
    arguments: tuple[str, ...]
    shape: tuple[int, ...]
    shared: tuple[str, ...] = ()

    @property
    def over(self) -> list[str]:
        """Arrays that have rows."""
        return [name for name in self.arguments if name not in self.shared]

    @property
    def single(self) -> set[str]:
        """Arrays that have one number in a row."""
        return {load.place.array for load in self.kernel.loads if load.place.index is None}

    @property
    def dimensions(self) -> tuple[int, ...]:
        """How many each array has."""
        return tuple(1 if name in self.shared or name in self.single else 2 for name in self.arguments)

    @property
    def lines(self) -> Lines:
        """The body of the loop.

        Raises
        ------
        ValueError
            A number would be called what an array is called.
        """
        forms = {name: f"{name}[{name}_every * lane + {{}}]" for name in self.over}
        layout = arrays(**forms | {name: f"{name}[{name}_every * lane]" for name in self.single})
        taken = {"lane", "many", "out", *self.arguments, *(f"{name}_every" for name in self.over)}
        names = {load.symbol: f"{load.symbol}_here" for load in self.kernel.loads if str(load.symbol) in taken}
        if clash := taken & {str(node.symbol) for node in self.kernel.assigns}:
            raise ValueError(f"{self.kernel.name}: {', '.join(sorted(clash))} is the name of an array here.")
        return written(self.kernel, PRINTER, layout, lambda j: f"out[{self.kernel.length} * lane + {j}]", names)


class Limb:
    """A kernel of one limb, for text in which the limbs of a machine stand side by side.

    What it computes has names of its own, ``NAME_i``; what is loaded from platform and tool is the same for all limbs
    and keeps its name.

    Parameters
    ----------
    kernel : Kernel
    limb : int
        From 0.
    limbs, constants : int
        How many limbs a machine has, and how many constants a limb.
    """

    def __init__(self, kernel: Kernel, limb: int, limbs: int, constants: int) -> None:
        self._kernel, self._limb = kernel, limb
        own = [load.symbol for load in kernel.loads if load.place.array not in ("x", "tool")]
        own += [node.symbol for node in kernel.assigns]
        self._names: Names = {s: f"{s}_{limb}" for s in own}
        self._layout: Layout = arrays(k=f"own[{limb * constants} + {{}}]", q=f"q[{limbs} * n + {limb}]")

    def loads(self, array: str) -> list[str]:
        """Return the lines that load from an array."""
        found = [load for load in self._kernel.loads if load.place.array == array]
        return [line for load in found for line in loaded(load, PRINTER, self._layout, self._names)]

    def results(self, name: str) -> list[str]:
        """Return the lines of a pose; its results are called by a form of ``{limb}`` and ``{index}``."""
        out = partial(name.format, limb=self._limb)
        lines = written(self._kernel, PRINTER, self._layout, lambda j: out(index=j), self._names)
        return [*self.loads("q"), *lines.assigns, *lines.stores]


def side_by_side(kernel: Kernel, limbs: int, constants: int) -> list[Limb]:
    """Return a kernel for each limb of a machine."""
    return [Limb(kernel, i, limbs, constants) for i in range(limbs)]


def of_numbers(kernel: Kernel, **forms: str) -> Lines:
    """Return the lines of a kernel whose numbers stand in arrays by `forms`, and what it stores by ``out``."""
    out = forms.pop("out")
    return written(kernel, PRINTER, arrays(**forms), out.format)


def results(kernel: Kernel) -> list[str]:
    """Return the texts of what a kernel stores, in order."""
    return [PRINTER.expression(store.expr) for store in kernel.stores]


def functions_of(kernels: Sequence[Kernel]) -> list[str]:
    """Return the functions of ``support/elementary.py`` that the kernels call, by name."""
    called: set[str] = set()
    for e in (e for kernel in kernels for e in kernel.expressions):
        called |= {PRINTER.functions[n] for f in e.atoms(sp.Function) if (n := type(f).__name__) in PRINTER.functions}
        called |= {name for kind, name in ((sp.Max, PRINTER.larger), (sp.Min, PRINTER.smaller)) if e.has(kind)}
        if any(not (2 * power.exp).is_Integer for power in e.atoms(sp.Pow)):  # see `Lanes._print_Pow`
            called |= {"exponential", "logarithm"}
    return sorted(called)
