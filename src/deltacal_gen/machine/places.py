"""Where something sits, in the words of those who stand before the machine: limbs of a Delta, joints of an arm.

And how the table of an arm's links may be read otherwise by those who wrote it.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.machine.chain import HAYATI
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.results.places import MOVING, Places

if TYPE_CHECKING:
    from deltacal_gen.machine.values import Link, Robot

LEAST_TWIST = 0.1  # rad: axes that are nearly parallel are so whichever way their twist counts
LENGTHS = ((10.0, "cm"), (1000.0, "metres"))  # and how many mm are one of them


def places_of(robot: Robot) -> Places:
    """Return what the limbs of a machine are called, and which they are."""
    return Places.of([link.kind for link in robot.links], robot.name, mechanism_of(robot).part)


def read_together(robot: Robot) -> list[tuple[int, int]]:
    """Return joints, from 0, with which a controller may count the next one together, and their tables, from 1.

    Their axes are parallel, as those of shoulder and elbow, whose angle is one to the horizontal where a rod holds it.
    """
    mechanism, found = mechanism_of(robot), []
    tables = [k for k, link in enumerate(robot.links) if link.kind in MOVING]
    free = mechanism.model(mechanism.full_model)
    parallel = {p.limb for p in mechanism.parameters if p.error == HAYATI and p.name in free}
    for i, (first, second) in enumerate(itertools.pairwise(tables)):
        between = first if robot.links[second].convention == "standard" else second
        if second == first + 1 and between + 1 in parallel:
            found.append((i, first + 1))
    return found


def misread(robot: Robot) -> Iterator[tuple[str, Robot]]:
    """Yield other meanings that a table of links may have, in words, each with the robot as it then is."""
    links, geometry = robot.links, robot.geometry

    def with_links(links: tuple[Link, ...], **changed: Array) -> Robot:
        return dataclasses.replace(robot, links=links, geometry={**geometry, **changed})

    if len({link.convention for link in links}) == 1:
        (other,) = {"standard", "modified"} - {links[0].convention}
        words = f'the table of the links is of the other convention (convention = "{other}" in every [[joint]])'
        yield words, with_links(tuple(link._replace(convention=other) for link in links))
    for k, link in enumerate(links):
        this = np.arange(len(links)) == k
        if abs(link.alpha - np.pi * round(link.alpha / np.pi)) > LEAST_TWIST:
            twisted = (*links[:k], link._replace(alpha=-link.alpha), *links[k + 1 :])
            turned = np.where(this, -geometry["alpha"], geometry["alpha"])
            yield f"alpha of [[joint]] {k + 1} counts the other way", with_links(twisted, alpha=turned)
        for key, (factor, unit) in itertools.product(("a", "d"), LENGTHS):
            if geometry[key][k]:
                longer = np.where(this, factor, 1.0) * geometry[key]
                yield f"{key} of [[joint]] {k + 1} is in {unit}", with_links(links, **{key: longer})


def place_of(robot: Robot, limbs: Sequence[int], part: str | None = None) -> str:
    """Return where something sits; see `results.places`."""
    return places_of(robot).name(limbs, part)


def at(robot: Robot, limbs: Sequence[int], part: str | None = None) -> str:
    """Return the same behind what sits there, as ` at limb 2`; "" of the whole machine."""
    return places_of(robot).at(limbs, part)
