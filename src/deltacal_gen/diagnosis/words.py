"""What was named, in words of a summary: one phrase for each effect, and one for all waves of a kind."""

from __future__ import annotations

from collections.abc import Sequence

from deltacal_gen.diagnosis.charges import several
from deltacal_gen.diagnosis.findings import Named
from deltacal_gen.diagnosis.harmonics import order_of, unrepeated
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.machine.places import at
from deltacal_gen.machine.values import Robot


def effects_in_words(effects: Sequence[Named], robot: Robot, problem: Problem) -> list[str]:
    """Return the effects that are named, waves of one kind together but for those that have harmonics.

    Several waves of a joint that turned less than their period are a smooth function of its angle taken to pieces: told
    one by one they look like so many faults, each of a size that nobody could build.
    """
    told: dict[str | int, list[Named]] = {}  # in the order of what is named
    for k, n in enumerate(effects):
        if n.fundamental is None:
            a_wave = several(n.term.effect) and not _harmonics(n, effects)
            told.setdefault(n.term.effect if a_wave else k, []).append(n)
    return [
        _waves(some, robot, problem)
        if isinstance(key, str)
        else f"{_title(some[0])}{at(robot, some[0].term.limbs)}{_no_sine(some[0], effects)}"
        for key, some in told.items()
    ]


def _title(one: Named) -> str:
    return f"{one.term.kernels.TITLE} ({one.term.effect})"


def _harmonics(fundamental: Named, effects: Sequence[Named]) -> list[float]:
    return sorted(order_of(n.term) for n in effects if n.fundamental is fundamental.term)


def _no_sine(fundamental: Named, effects: Sequence[Named]) -> str:
    """Return that an effect is no sine, and which harmonics it has; "" of others."""
    orders = ", ".join(f"{order:g}" for order in _harmonics(fundamental, effects))
    return f", no sine: {order_of(fundamental.term):g} periods a turn, with harmonics {orders}" if orders else ""


def _waves(some: Sequence[Named], robot: Robot, problem: Problem) -> str:
    """Return waves of one kind, and which of them were not seen to repeat."""
    unseen = [n for n in some if unrepeated(problem, n.term)]
    joints = sorted({limb for n in unseen for limb in n.term.limbs})
    of = "that joint" if len(joints) == 1 else "each of these joints"
    if len(some) == 1:
        repeats = f", which was not seen to repeat: any smooth function of {of} may be it" if unseen else ""
        return f"{_title(some[0])}{at(robot, some[0].term.limbs)}{repeats}"
    orders = [f"{order_of(n.term):g}{at(robot, n.term.limbs)}" for n in some]
    which = " and ".join(f"{order_of(n.term):g}" for n in unseen)
    were = "was" if len(unseen) == 1 else "were"
    rest = f", of which {which} {were} not seen to repeat: any smooth function of {of} may be it" if unseen else ""
    return f"{_title(some[0])} of orders {', '.join(orders)}{rest}"
