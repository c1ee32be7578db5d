"""Commands of one pose: single numbers in one flat array w, where the limbs are the lanes."""

from __future__ import annotations

from collections.abc import Sequence

from derive.backends import lanes, scalar
from derive.backends.ir import Kernel, Place
from derive.backends.text import Lines, loaded, written


def each(kernel: Kernel, first: int, constants: int, count: int) -> Lines:
    """Return the lines of a kernel that runs for every limb; its result begins at `first`.

    What is the same for all limbs is loaded before the loop: `Lines.loads`, the rest is the body of the loop.

    Parameters
    ----------
    constants : int
        First place of the constants.
    count : int
        Places that a quantity of every limb takes.
    """

    def place(at: Place) -> str:
        if at.array == "k" and at.index is not None:
            return lanes.place(Place("w", constants + count * at.index, lane=True))
        return lanes.place(at)

    loads = {kind: [x for x in kernel.loads if _where(x.place) == kind] for kind in ("single", "constant", "limb")}
    first_lines = {k: [line for x in v for line in loaded(x, lanes.PRINTER, place)] for k, v in loads.items()}
    lines = written(kernel, lanes.PRINTER, place, lambda j: f"w[{first + j * count} + lane]")
    return Lines(first_lines["single"], [*first_lines["constant"], *first_lines["limb"], *lines.assigns], lines.stores)


def _where(place: Place) -> str:
    return "constant" if place.array == "k" else "limb" if place.lane else "single"


def together(kernel: Kernel, places: Sequence[int]) -> Lines:
    """Return the lines of a kernel of all limbs at once, entry j of whose result stands at ``places[j]``."""
    return written(kernel, scalar.PRINTER, lanes.place, lambda j: f"w[{places[j]}]")
