"""A robot file of a URDF: the chain between two of its links as Denavit-Hartenberg rows, with what it weighs.

Everything that is written is read back and compared with the file's own frames, at joints all over their turns.
"""

from __future__ import annotations

import itertools
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.errors import UnknownName, UnusableURDF, naming
from deltacal_gen.files.imported import Imported, write_import
from deltacal_gen.files.robot import limits_key, robot_from_dict
from deltacal_gen.files.toml import toml_text
from deltacal_gen.files.urdf_tree import MM, SLIDING, TURNING, Body, Joint, Tree
from deltacal_gen.machine.denavit import Row, Rows, rows_of
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.units import file_unit, to_file

ENDLESS = 2 * np.pi  # rad to either side: limits that are written for a joint that has none
MANY_TURNS = 10 * ENDLESS  # rad: limits farther off may be degrees
FARTHEST = 100.0 * MM  # a chain that is longer was written in millimetres
TRIED, SLID = 64, 500.0  # joints at which the robot file is compared with the URDF; mm to either side
SAME_MM, SAME_TURN = 1e-12, 1e-12  # of the chain's length, at least a metre; of a rotation matrix' entries


def import_urdf(
    path: str | Path, output: str | Path | None = None, *, base: str | None = None, tip: str | None = None
) -> Imported:
    """Import the chain between two links of a URDF as a robot file.

    Parameters
    ----------
    path : path
        The URDF [m, rad, kg].
    output : path, optional
        Folder for robot.toml.
    base : str, optional
        The link whose frame becomes {O}; default the root. It stands still: joints above it are passed upwards.
    tip : str, optional
        The link whose frame becomes that of the last link; default the one with most joints before it.

    Raises
    ------
    InputError
        The file cannot be used, or several chains are as long; with its line and what to do.
    UsageError
        A link that there is not, or that the base does not carry.

    Examples
    --------
    deltacal import urdf arm.urdf --tip tool0 -o arm
    """
    with naming(Path(path)):
        tree = Tree(Path(path))
        chain = _chain(tree, base, tip)
        _check(chain)
        rows = rows_of(*chain.lines, chain.frames[-1])
        tables, warnings = _tables(chain, rows)
        if upwards := ", ".join(joint.name for joint in chain.moving if joint.child not in tree.bodies):
            told = (
                f"'{chain.base}' is taken to stand still: the chain first goes up through what carries it, {upwards}."
            )
            warnings = (told, *warnings)
        text = _commented(toml_text(tables), chain, rows)
        robot = robot_from_dict(tomllib.loads(text))
        _verify(robot, chain, rows)
    return write_import(Imported(robot, {}, warnings), output, text)


@dataclass(frozen=True)
class _Chain:
    """What leads from a base to a tip.

    Attributes
    ----------
    tree : Tree
    base, tip : str
    start : (4, 4) array
        Frame of the link where the ways up from the base and down to the tip meet, in the base's.
    joints : tuple of Joint
        From there down, fixed ones among them.
    """

    tree: Tree
    base: str
    tip: str
    start: Array
    joints: tuple[Joint, ...]

    @cached_property
    def moving(self) -> tuple[Joint, ...]:
        return tuple(joint for joint in self.joints if joint.moves)

    @cached_property
    def read(self) -> tuple[Joint, ...]:
        """The joints that a controller reads: those that follow no other."""
        return tuple(joint for joint in self.moving if joint.mimics is None)

    @cached_property
    def frames(self) -> Array:
        """Frames of the joints and of the tip, (joints + 1, 4, 4), in the base's at joints zero [mm]."""
        return np.array(list(itertools.accumulate((j.origin for j in self.joints), np.matmul, initial=self.start)))

    @property
    def lines(self) -> tuple[Array, Array]:
        """A point of each moving joint's line [mm] and its direction, (n, 3) each, at joints zero."""
        at = [(f, j.axis) for f, j in zip(self.frames[1:], self.joints, strict=True) if j.moves]
        return np.array([f[:3, 3] for f, _ in at]), np.array([f[:3, :3] @ axis for f, axis in at])

    def moved(self, q: Array) -> Iterator[tuple[Joint, Array]]:
        """Yield the joints with the frames (N, 4, 4) of their child links, in the base's [mm].

        Those that are read stand at values (N, n) [rad or mm].
        """
        frame, values = np.tile(self.start, (len(q), 1, 1)), {j.name: q[:, k] for k, j in enumerate(self.read)}
        for joint in self.joints:
            if joint.mimics is not None:
                other, much, offset = joint.mimics
                values[joint.name] = much * values[other] + offset
            frame = frame @ joint.moved(values.get(joint.name, np.zeros(len(q))))
            yield joint, frame

    def carried(self, joint: Joint) -> Iterator[tuple[str, Array]]:
        """Yield the links that stand still beside a joint's child, and where, in that child's frame."""
        links = [(joint.child, np.eye(4))]
        for link, frame in links:
            yield link, frame
            links += [(j.child, frame @ j.origin) for j in self.tree.below[link] if not j.moves]

    def body(self, joint: Joint) -> Body | None:
        """Return what a joint's child weighs with all that is fixed to it, in the child's frame."""
        found = [b.seen(frame) for link, frame in self.carried(joint) if (b := self.tree.bodies[link]) is not None]
        mass = sum(b.mass for b in found)
        if not mass:
            return None
        centre = sum((b.mass * b.centre for b in found), start=np.zeros(3)) / mass
        inertia = np.zeros((3, 3))
        for b in found:
            r = b.centre - centre
            inertia += b.inertia + b.mass * (r @ r * np.eye(3) - np.outer(r, r))
        return Body(mass, centre, inertia)

    def beside(self) -> list[Joint]:
        """Return the joints that move what hangs on the chain."""
        known = {joint.name for joint in self.moving}
        links = (link for joint in self.moving for link, _ in self.carried(joint))
        return [j for link in links for j in self.tree.below[link] if j.moves and j.name not in known]


# ----------------------------------------------------------------------------------------------------- which chain


def _chain(tree: Tree, base: str | None, tip: str | None) -> _Chain:
    """Return the chain between two links, either of which may be left open."""
    if base is not None:
        tree.check_link(base, "--base")
    if tip is None:
        return _longest(tree, base)
    tree.check_link(tip, "--tip")
    start = tree.root_of(tip) if base is None else base
    found = _between(tree, start, tip)
    up = {joint.name for joint in tree.climb(start)}
    aside = any(joint.moves and joint.name not in up for joint in tree.climb(tip))
    if found is None and aside and tree.root_of(start) == tree.root_of(tip):
        found = _between(tree.hung(start), start, tip)
    if found is not None:
        return found
    raise UnknownName(
        f"{tree.path}: link '{start}' does not carry '{tip}': --base names the link that stands still, --tip one "
        "behind the last joint."
    )


def _between(tree: Tree, base: str, tip: str) -> _Chain | None:
    """Return the chain between two links; None where it would go up through a joint that moves, or there is none."""
    down = list(tree.climb(tip))[::-1]
    on_way = {tip, *(joint.parent for joint in down)}
    start, at = np.eye(4), base
    while at not in on_way:
        if at not in tree.above or tree.above[at].moves:
            return None
        start = start @ np.linalg.inv(tree.above[at].origin)
        at = tree.above[at].parent
    first = next((k for k, joint in enumerate(down) if joint.parent == at), len(down))
    return _Chain(tree, base, tip, start, tuple(down[first:]))


def _longest(tree: Tree, base: str | None) -> _Chain:
    """Return the only chain of most joints; raise InputError where there are several, or none."""
    ends = [link for link in tree.bodies if not tree.below[link]]
    ways = [_between(tree, tree.root_of(end) if base is None else base, end) for end in ends]
    found = [way for way in ways if way is not None]
    most = max((len(way.moving) for way in found), default=0)
    if not most:
        behind = "" if base is None else f" behind '{base}'"
        raise UnusableURDF(f"no joint{behind} moves.", "Give the URDF of an arm, and its base.")
    longest = [way for way in found if len(way.moving) == most]
    if len(longest) == 1:
        return longest[0]
    names = ", ".join(way.tip for way in longest)
    if roots := [*dict.fromkeys(way.base for way in longest)][1:]:
        raise UnusableURDF(
            f"{len(longest)} links have {most} joint{'s' * (most > 1)} before them, and none has more: {names}. They "
            f"hang on links that no joint connects: {', '.join((longest[0].base, *roots))}.",
            "Say which arm is meant: --base LINK, one of these.",
        )
    shared = [j[0] for j in zip(*(way.joints for way in longest), strict=False) if len({k.name for k in j}) == 1]
    last = shared[-1].child if shared else longest[0].base
    joints = [f"{n} joint{'' if n == 1 else 's'}" for n in (most, sum(j.moves for j in shared))]
    raise UnusableURDF(
        f"{len(longest)} links have {joints[0]} before them, and none has more: {names}. The ways to them part at "
        f"'{last}', behind {joints[1]}.",
        "Say where the arm ends: --tip LINK, one of these or one before.",
    )


def _check(chain: _Chain) -> None:
    """Raise InputError where a joint of the chain can be none of a robot file, or lengths cannot be metres."""
    read = {joint.name: joint for joint in chain.read}
    for joint in chain.moving:
        if joint.kind not in (*TURNING, *SLIDING):
            raise joint.error(
                f"joint '{joint.name}' is {joint.kind}, which no joint of an arm is.",
                f"Begin behind it: --base {joint.child}.",
            )
        if joint.mimics is None:
            continue
        other = read.get(joint.mimics[0])
        if other is None or {joint.kind, other.kind} & set(SLIDING):
            raise joint.error(
                f"joint '{joint.name}' mimics '{joint.mimics[0]}': only a turning joint can, and only a turning one "
                "of the same chain that mimics none.",
                "End before it (--tip), or take out <mimic> where the controller reads it.",
            )
    if not chain.read:
        raise UnknownName(f"{chain.tree.path}: no joint moves between '{chain.base}' and '{chain.tip}'.")
    if (far := _length(chain)) > FARTHEST:
        raise chain.joints[0].error(
            f"from '{chain.base}' to '{chain.tip}' it is {far / MM:.4g} m: millimetres, where URDF has metres.",
            "Divide the lengths by 1000.",
        )
    for joint in chain.moving:
        body = chain.body(joint)
        if body is not None and (away := float(np.linalg.norm(body.centre))) > FARTHEST:
            raise joint.error(
                f"what joint '{joint.name}' carries has its centre of mass {away / MM:.4g} m away.",
                "Correct the <inertial> of its links; lengths are metres.",
            )


def _length(chain: _Chain) -> float:
    return float(sum(np.linalg.norm(joint.origin[:3, 3]) for joint in chain.joints))


# --------------------------------------------------------------------------------------------------- the robot file


def _tables(chain: _Chain, rows: Rows) -> tuple[dict[str, Any], tuple[str, ...]]:
    """Return the tables of the robot file, and what a user should know."""
    warnings, joints = list[str](), list[dict[str, Any]]()
    before = int(rows.base != Row())
    number = {joint.name: k for k, joint in enumerate(chain.moving)}
    behind = [frame for joint, frame in zip(chain.joints, chain.frames[1:], strict=True) if joint.moves]
    for k, (joint, row) in enumerate(zip(chain.moving, rows.joints, strict=True)):
        table: dict[str, Any] = {"kind": "prismatic" if joint.kind in SLIDING else "revolute"}
        offset = 0.0
        if joint.mimics is not None:
            other, much, offset = joint.mimics
            much *= float(rows.sign[k] * rows.sign[number[other]])
            table = {"kind": "coupled", "coupling": {str(number[other] + 1 + before): much}}
        table |= _drawn(row, float(rows.sign[k]) * offset)
        if (body := chain.body(joint)) is not None:
            seen = body.seen(np.linalg.inv(rows.frames[k]) @ behind[k])
            table |= _weighs(seen)
            if "inertia" not in table and seen.inertia.any():
                warnings.append(
                    f"the inertia behind joint '{joint.name}' is none that a body can have; it is left out."
                )
        joints.append(table)
    if before:
        joints.insert(0, {"kind": "fixed"} | _drawn(rows.base))
    if rows.end != Row():
        joints.append({"kind": "fixed"} | _drawn(rows.end))
    errors = {
        f"{key}_{k}": to_file(value, "rad")
        for k, row in enumerate((rows.base, *rows.joints), start=before)
        for key, value in (("alpha", row.tilt), ("beta", row.beta))
        if value
    }
    tables: dict[str, Any] = {
        "robot": {"name": chain.tree.name, "mechanism": "serial"},
        "joints": {"sign": [int(s) for s, joint in zip(rows.sign, chain.moving, strict=True) if joint in chain.read]},
    }
    warnings += _limits(chain, tables)
    if beside := chain.beside():
        names = ", ".join(joint.name for joint in beside)
        warnings.append(f"what moves beside the chain is left out, with what it weighs: joints {names}.")
    return tables | {"joint": joints} | ({"errors": errors} if errors else {}), tuple(warnings)


def _drawn(row: Row, offset: float = 0.0) -> dict[str, Any]:
    """Return a row as keys of a table [[joint]] [mm, deg]; `offset` [rad] is added to theta."""
    return {
        "convention": "standard",
        "a": row.a,
        "alpha": to_file(row.alpha, "rad"),
        "d": row.d,
        "theta": to_file(row.theta + offset, "rad"),
    }


def _weighs(body: Body) -> dict[str, Any]:
    """Return a body as keys of a table [[joint]]; without its inertia where no body has such a one."""
    keys: dict[str, Any] = {"mass": body.mass, "com": [round(float(v), 9) + 0.0 for v in body.centre]}
    own = np.linalg.eigvalsh(body.inertia)
    if own[0] <= 0 or own[2] > (1 + 1e-6) * (own[0] + own[1]):
        return keys
    entries = [body.inertia[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
    return keys | {"inertia": [round(float(v), 9) + 0.0 for v in entries]}


def _limits(chain: _Chain, tables: dict[str, Any]) -> list[str]:
    """Add limits and speeds of the joints to the tables; return what a user should know."""
    read = [(joint, "mm" if joint.kind in SLIDING else "rad") for joint in chain.read]
    speeds = {
        f"qd{k}_{file_unit(unit)}_s": [-speed, speed]
        for k, (joint, unit) in enumerate(read, start=1)
        if (speed := round(to_file(joint.speed or 0.0, unit), 9)) > 0
    }
    if speeds:
        tables["limits"] = speeds
    without = [joint for joint in chain.read if joint.limits is None]
    listed = ", ".join(joint.name for joint in without)
    if any(joint.kind in SLIDING for joint in without):
        return [f"joints without limits: {listed}. As one slides, robot.toml has none at all; add limits to [joints]."]
    tables["joints"][limits_key(unit for _, unit in read)] = [
        [round(to_file(v, unit), 9) for v in joint.limits or (-ENDLESS, ENDLESS)] for joint, unit in read
    ]
    found = [f"joints without limits: {listed}. A turn to either side is written; say what holds."] if without else []
    turning = [joint for joint in chain.read if joint.limits is not None and joint.kind in TURNING]
    if many := [joint.name for joint in turning if np.abs(joint.limits or 0.0).max() > MANY_TURNS]:
        found.append(
            f"limits of more than {MANY_TURNS / ENDLESS:.0f} turns to a side: {', '.join(many)}. URDF has radians; "
            "where these are degrees, divide them by 57.3 in robot.toml."
        )
    return found


def _commented(text: str, chain: _Chain, rows: Rows) -> str:
    """Return the text of a robot file with the names that the URDF has for its parts."""
    number = {joint.name: k for k, joint in enumerate(chain.read, start=1)}
    whats = [
        f"follows {joint.mimics[0]}: {joint.name}" if joint.mimics else f"q{number[joint.name]}: {joint.name}"
        for joint in chain.moving
    ]
    if rows.base != Row():
        whats.insert(0, f"from {chain.base} to the line of {chain.moving[0].name}")
    if rows.end != Row():
        whats.append(f"to {chain.tip}")
    parts = text.split("[[joint]]\n")
    tables = (f"[[joint]]  # {_plain(what)}\n{part}" for what, part in zip(whats, parts[1:], strict=True))
    head = (
        f"{chain.tree.path.name}, from {chain.base} to {chain.tip}.",
        f"{{O}} is the frame of {chain.base}, the last frame that of {chain.tip}.",
        "[geometry] tool = [x, y, z] says where in the last frame the measured point is, in mm.",
    )
    return "".join(f"# {_plain(line)}\n" for line in head) + parts[0] + "".join(tables)


def _plain(text: str) -> str:
    """Return a text as a comment can hold it: in one line, without signs that no file of TOML may have."""
    return "".join(c if c.isprintable() else "?" for c in text)


# --------------------------------------------------------------------------------------------------------- the proof


def _verify(robot: Robot, chain: _Chain, rows: Rows) -> None:
    """Raise InputError where the robot file puts the tip or a weight elsewhere than the URDF does."""
    slides = np.array([joint.kind in SLIDING for joint in chain.read])
    q = np.random.default_rng(0).uniform(-1.0, 1.0, (TRIED, len(slides))) * np.where(slides, SLID, np.pi)
    mechanism = mechanism_of(robot)
    table = mechanism.rows(robot)
    x, _ = mechanism.forward(q * robot.joint_sign, robot.tool, table)
    centres = mechanism.weights_at(x, q * robot.joint_sign, robot.tool, table, {})
    frame, off, k = np.eye(4), list[Array](), int(rows.base != Row())
    for joint, frame in chain.moved(q):
        if joint.moves:
            if (body := chain.body(joint)) is not None:
                off.append(centres[:, k] - (frame[:, :3, :3] @ body.centre + frame[:, :3, 3]))
            k += 1
    off.append(x[:, :3] - frame[:, :3, 3])
    mm = max(float(np.abs(d).max()) for d in off)
    turn = float(np.abs(x[:, 3:].reshape(-1, 3, 3) - frame[:, :3, :3]).max())
    if not (mm <= SAME_MM * max(_length(chain), MM) and turn <= SAME_TURN):
        raise UnusableURDF(
            f"the table of the chain misses the file's own frames by {mm:.2g} mm and {turn:.2g} rad.",
            "That must not be; nothing is written. Please report it with the file.",
        )
