"""A chain whose joints and links give way: the same chain, with tables between its own whose errors are deflections.

A table of Denavit and Hartenberg without dimensions turns and shifts by its errors. Before a joint's motion one stands
so that ``side_x, side_y`` shift the joint's axis and ``tilt_x, tilt_y`` turn it, along and about x and y of the frame
in which the joint moves. Where a link begins one stands so that ``bend_v, bend_w`` shift all that it carries across the
link's line, and ``twist`` turns it about that line; w is the joint's axis as far as that lies across, v completes.

The line of a link leads from its joint's point to that of the next table that moves, or to the origin of the last
frame, over the fixed tables between; of a joint that slides it begins on the slide. What weights do along a deflection
follows by virtual work, as along any error.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from deltacal_gen.machine.rotation import Array, aim
from deltacal_gen.machine.values import Link

DEFLECTIONS = ("side_x", "side_y", "tilt_x", "tilt_y", "bend_v", "bend_w", "twist")
NO_LINE = 1e-6  # mm: a link that is shorter has no line across which it could bend
A, ALPHA, D, THETA, DA, DALPHA, DD, DTHETA, DBETA = range(9)  # columns of a table's row of parameters
TABLE = 9
QUARTER = np.pi / 2


@dataclass
class _Laid:
    """Tables as they are laid down, and where each number of the chain's own rows goes."""

    links: list[Link] = field(default_factory=list)
    copies: list[tuple[int, int, int, int]] = field(default_factory=list)  # own table, column; table here, column
    fixed: list[tuple[int, int, float]] = field(default_factory=list)  # table here, column, number
    lines: list[tuple[int, int]] = field(default_factory=list)  # of each joint: tables that turn to its line, and back

    def add(self, convention: str, of: int = -1, columns: Sequence[int] = (), kind: str = "fixed") -> int:
        """Lay a table down that takes some columns of one of the chain's own; return its number."""
        self.links.append(Link(kind, convention, 0.0, 0.0, (0.0, 0.0, 0.0)))
        at = len(self.links) - 1
        self.copies += [(of, c, at, c) for c in columns]
        return at


class Flexible:
    """Where the tables of a chain stand among those that it gives way by.

    Parameters
    ----------
    links : tuple of Link
        Of the chain.
    moving : sequence of int
        Which of them its joints move.
    joints : sequence of int
        Which of these joints give way, from 0.

    Attributes
    ----------
    links : tuple of Link
        Of the chain that gives way.
    errors, deflections : array of int
        Table and error there of each of the chain's own errors (links, 5, 2), and of the deflections of each joint that
        gives way (joints, 7, 2).
    begun : (joints, links, 4) array of bool
        Which dimensions of its own tables lead along the line of each joint's link.
    bears, ends : (links,) arrays of int
        Which table bears the weight of each of the chain's own, before the place where its link bends; and which one
        has its frame.
    """

    def __init__(self, links: tuple[Link, ...], moving: Sequence[int], joints: Sequence[int]) -> None:
        self._own, self._moving, self._joints = links, list(moving), list(joints)
        giving = [self._moving[j] for j in joints]
        laid = _Laid()
        numbers: dict[int, int] = {}
        bears: list[int] = []
        ends: list[int] = []
        deflections = []
        for k, link in enumerate(links):
            if k not in giving:
                numbers[k + 1] = laid.add(link.convention, k, range(TABLE), link.kind) + 1
                bears.append(bears[-1] if link.kind == "fixed" and bears else numbers[k + 1] - 1)
                ends.append(numbers[k + 1] - 1)
                continue
            joint, places = self._joint(laid, k)
            numbers[k + 1] = joint + 1
            bears.append(joint)
            ends.append(len(laid.links) - 1)
            deflections.append(places)
        self._laid = laid
        self._copied = np.array(laid.copies).T
        self.bears, self.ends = np.array(bears), np.array(ends)
        self.deflections = np.array(deflections, dtype=int).reshape(-1, len(DEFLECTIONS), 2)
        couplings = {numbers[k + 1] - 1: link.coupling for k, link in enumerate(links) if link.coupling}
        self.links = tuple(
            link._replace(coupling=tuple((numbers[n], much) for n, much in couplings.get(t, ())))
            for t, link in enumerate(laid.links)
        )
        to = {(k, c): (t, other) for k, c, t, other in laid.copies}
        self.begun = self._begun()
        self.errors = np.array([[to[k, c] for c in range(DA, TABLE)] for k in range(len(links))]) - [0, DA]

    def _joint(self, laid: _Laid, k: int) -> tuple[int, list[tuple[int, int]]]:
        """Lay down a joint and its link; return the joint's table and where its deflections stand."""
        link = self._own[k]
        modified, slides = link.convention == "modified", link.kind == "prismatic"
        before, along = (A, ALPHA, DA, DALPHA, DBETA), (D, DD)
        if modified:
            laid.add("modified", k, before)
        to, back = laid.add("standard"), laid.add("standard")
        laid.fixed += [(to, ALPHA, -QUARTER), (back, ALPHA, QUARTER)]
        joint = laid.add("standard", k, (THETA, DTHETA, *(along if slides else ())), link.kind)
        line = laid.add("standard"), laid.add("standard"), laid.add("standard")
        laid.lines.append((line[0], line[2]))
        laid.add("standard", k, (*(() if slides else along), *(() if modified else before)))
        side, bend = back, line[1]
        of = {"side_x": (side, DA), "side_y": (side, DD), "tilt_x": (side, DALPHA), "tilt_y": (side, DTHETA)}
        of |= {"bend_w": (bend, DA), "bend_v": (bend, DD), "twist": (bend, DBETA)}
        return joint, [(of[name][0], of[name][1] - DA) for name in DEFLECTIONS]

    def _begun(self) -> np.ndarray:
        """Return which dimensions (joints, links, 4) lead from where a joint has turned or slid along its link's line.

        Of a joint's own table what its motion does not come after, all of the fixed ones behind it, and of the next one
        that moves what comes before its motion.
        """
        kept = np.zeros((len(self._moving), len(self._own), THETA + 1), dtype=bool)
        for j, k in enumerate(self._moving):
            own = self._own[k]
            kept[j, k, D] = own.kind == "revolute"
            kept[j, k, [A, ALPHA]] = own.convention == "standard"
            for n in range(k + 1, len(self._own)):
                moves = self._own[n].kind != "fixed"
                kept[j, n] = not moves
                kept[j, n, [A, ALPHA]] |= self._own[n].convention == "modified"
                if moves:
                    break
        return kept

    def rows(self, rows: Array, lines: Array) -> Array:
        """Return the rows of parameters of the chain that gives way, (M, tables, 12).

        Those of its own (M, links, n) hold geometry, errors, those of the tool and deflections, in this order; `lines`
        (joints, 3) are those of the joints' links, in the frames in which the joints have turned or slid [mm].
        """
        own = rows[:, :, : -len(DEFLECTIONS)]
        plain = self._plain(own[:1] if (own == own[:1]).all() else own, lines)
        out = np.repeat(plain, len(rows) // len(plain), axis=0)
        tables, errors = np.moveaxis(self.deflections, -1, 0)
        out[:, tables, DA + errors] += rows[:, [self._moving[j] for j in self._joints], -len(DEFLECTIONS) :]
        return out

    def _plain(self, rows: Array, lines: Array) -> Array:
        """Return what `rows` does, without any deflection; those of its own (M, links, n) hold none."""
        common = rows[:, :, TABLE:]
        out = np.zeros((len(rows), len(self.links), TABLE + common.shape[2]))
        own, columns, tables, others = self._copied
        n, width = rows.shape[2], out.shape[2]
        taken = np.take(rows.reshape(len(rows), -1), own * n + columns, axis=1)
        out.reshape(len(rows), -1)[:, tables * width + others] = taken
        for t, c, number in self._laid.fixed:
            out[:, t, c] = number
        lines = lines[self._joints]
        # y along the line and x to w, where w is z as far as that lies across, else x
        length = np.linalg.norm(lines, axis=1, keepdims=True)
        for (first, last), (about_z, about_x), (x, y, z), far in zip(
            self._laid.lines, aim(lines), lines, length, strict=True
        ):
            if far > NO_LINE:
                if x * x + y * y < (NO_LINE * far) ** 2:
                    about_z = np.copysign(QUARTER, z)
                out[:, first, [THETA, ALPHA, DBETA]] = about_z, about_x, -QUARTER
                out[:, last, [THETA, ALPHA, DBETA]] = about_x, -about_z, QUARTER
        out[:, :, TABLE:] = common[:, :1]
        return out
