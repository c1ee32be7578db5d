"""URDF, the robots' description of ROS, as links and joints: read from files of strangers, with lines for its errors.

What is read is what a calibration needs: links with what they weigh, joints with what they do. Meshes, colours,
transmissions, plugins of simulators and the like are passed over. A document type is refused, as entities come with it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from copy import copy
from dataclasses import dataclass, field, replace
from pathlib import Path
from xml.parsers import expat

import numpy as np

from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.rows import number_of
from deltacal_gen.files.toml import nearest, read_bytes
from deltacal_gen.machine.rotation import Array, from_turns, from_vector

MM, KG_MM2 = 1e3, 1e6  # of a metre, of a kg m^2
TURNING, SLIDING = ("revolute", "continuous"), ("prismatic",)
KINDS = (*TURNING, *SLIDING, "fixed", "planar", "floating")
ABSURD_TURN = 2.001 * math.pi  # rad: a roll, pitch or yaw beyond a turn was written in degrees
LARGEST = 1e60  # no quantity of a robot is larger, and its square is a number, too
NONE = 1e3  # rad, m, and by the second: larger limits stand for none
LISTED = 20  # links, where one is not known
INERTIA = ("ixx", "iyy", "izz", "ixy", "ixz", "iyz")
SPOKEN = {"sdf": "SDF, of Gazebo", "mujoco": "MJCF, of MuJoCo", "html": "a page of the web", "COLLADA": "a mesh"}


@dataclass(frozen=True)
class Tag:
    """An element of XML and the line where it begins."""

    name: str
    said: dict[str, str]
    line: int
    inside: list[Tag] = field(default_factory=list)

    def __getitem__(self, name: str) -> Tag:
        """Return the first element of a name in this one; an empty one where there is none."""
        return next((tag for tag in self.inside if tag.name == name), Tag(name, {}, self.line))


@dataclass(frozen=True)
class Body:
    """What a link weighs, in a frame: mass [kg], its centre (3,) [mm] and the tensor about that (3, 3) [kg mm^2]."""

    mass: float
    centre: Array
    inertia: Array

    def seen(self, frame: Array) -> Body:
        """Return the body in the frame in which `frame` (4, 4) is told."""
        R = frame[:3, :3]
        return Body(self.mass, R @ self.centre + frame[:3, 3], R @ self.inertia @ R.T)


@dataclass(frozen=True)
class Joint:
    """A joint of the file.

    Attributes
    ----------
    name, kind, parent, child : str
    origin : (4, 4) array
        Its frame in that of the parent link, joint zero [mm].
    axis : (3,) array
        A unit vector in its own frame.
    limits : (float, float) or None
        [rad or mm]
    speed : float or None
        The highest [rad/s or mm/s].
    mimics : (str, float, float) or None
        Joint that it follows, how much of that, and from where [rad or mm].
    line : int
    """

    name: str
    kind: str
    parent: str
    child: str
    origin: Array
    axis: Array
    limits: tuple[float, float] | None
    speed: float | None
    mimics: tuple[str, float, float] | None
    line: int

    @property
    def moves(self) -> bool:
        """Whether it is not fixed."""
        return self.kind != "fixed"

    def moved(self, q: Array) -> Array:
        """Return the child link's frames (N, 4, 4) in the parent's at values (N,) of the joint [rad or mm]."""
        motion = np.tile(np.eye(4), (len(q), 1, 1))
        if self.kind in SLIDING:
            motion[:, :3, 3] = q[:, None] * self.axis
        elif self.kind in TURNING:
            motion[:, :3, :3] = from_vector(q[:, None] * self.axis)
        return self.origin @ motion


class Tree:
    """The links and joints of a file.

    Attributes
    ----------
    path : Path
    name : str
        Of the robot.
    bodies : dict of (Body or None)
        What each link weighs, in its own frame; None where the file does not say.
    above : dict of Joint
        Which joint carries a link.
    below : dict of list of Joint
        Which joints a link carries.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        root = _parsed(path)
        self.name = root.said.get("name", "").strip() or path.stem
        self.bodies: dict[str, Body | None] = {}
        self.above: dict[str, Joint] = {}
        self.below: dict[str, list[Joint]] = {}
        for tag in root.inside:
            if tag.name == "link":
                name = self._text(tag, "name")
                if name in self.bodies:
                    raise self.error(f"there are two links '{name}'.", "Give each its own name.", tag.line)
                self.bodies[name], self.below[name] = self._body(tag, name), []
        named = dict[str, Joint]()
        for tag in root.inside:
            if tag.name == "joint":
                joint = self._joint(tag)
                if joint.name in named:
                    raise self.error(f"there are two joints '{joint.name}'.", "Give each its own name.", tag.line)
                named[joint.name] = joint
                self._hang(joint)
        if not named:
            raise self.error(
                "there is no joint in the file.",
                "Give the whole robot's URDF; what ROS keeps as robot_description is one.",
                root.line,
            )
        self._check_cycles(named)

    def error(self, problem: str, remedy: str, line: int) -> InputError:
        """Return an error at a line of the file."""
        return InputError(problem, remedy, file=self.path, line=line)

    def climb(self, link: str) -> Iterator[Joint]:
        """Yield the joints from a link up to the root."""
        while link in self.above:
            yield (joint := self.above[link])
            link = joint.parent

    def root_of(self, link: str) -> str:
        """Return the link from which all joints to this one lead."""
        return [link, *(joint.parent for joint in self.climb(link))][-1]

    def hung(self, base: str) -> Tree:
        """Return the same machine hung on another link: what leads from that up to the root is turned round.

        A joint that is passed upwards turns its parent the other way, about where its child is; what it reads stays.
        """
        out, turned = copy(self), list(self.climb(base))
        passed = {joint.name for joint in turned}
        joints = [joint for joint in self.above.values() if joint.name not in passed]
        out.bodies = dict(self.bodies)
        for joint in turned:
            seat = f"{joint.parent} at {joint.name}"
            out.bodies[seat] = None
            joints.append(replace(joint, parent=joint.child, child=seat, origin=np.eye(4), axis=-joint.axis))
            back = np.linalg.inv(joint.origin).astype(np.float64)
            fixed = replace(joint, name=seat, kind="fixed", parent=seat, child=joint.parent, mimics=None)
            joints.append(replace(fixed, origin=back))
        out.above = {joint.child: joint for joint in joints}
        out.below = {link: [joint for joint in joints if joint.parent == link] for link in out.bodies}
        return out

    def check_link(self, link: str, option: str) -> None:
        """Raise UsageError where there is no link of a name."""
        if link in self.bodies:
            return
        close = nearest(link, self.bodies)
        known = [*self.bodies][:LISTED]
        hint = f"did you mean '{close}'?" if close else f"it has {', '.join(known)}{', ...' * (len(known) == LISTED)}."
        raise UsageError(f"{option}: {self.path} has no link '{link}'; {hint}")

    def _hang(self, joint: Joint) -> None:
        for what, link in (("parent", joint.parent), ("child", joint.child)):
            if link not in self.bodies:
                raise self.error(
                    f"the {what} of joint '{joint.name}' is '{link}', which is no link of the file.",
                    f'Correct the name, or add <link name="{link}"/>.',
                    joint.line,
                )
        if joint.child in self.above:
            raise self.error(
                f"link '{joint.child}' hangs on two joints, '{self.above[joint.child].name}' and '{joint.name}': a "
                "loop, which URDF cannot say.",
                "Leave out the joint that closes the loop.",
                joint.line,
            )
        self.above[joint.child] = joint
        self.below[joint.parent].append(joint)

    def _check_cycles(self, joints: dict[str, Joint]) -> None:
        reached = [link for link in self.bodies if link not in self.above]
        for link in reached:
            reached += [joint.child for joint in self.below[link]]
        lost = [joint for joint in joints.values() if joint.child not in set(reached)]
        if lost:
            names = ", ".join(f"'{joint.name}'" for joint in lost)
            raise self.error(
                f"joints lead in a circle, from no root: {names}.", "Correct a parent or a child.", lost[0].line
            )

    def _text(self, tag: Tag, key: str) -> str:
        if text := tag.said.get(key, "").strip():
            return text
        raise self.error(f"<{tag.name}> has no {key}.", f'Add {key}="...".', tag.line)

    def _numbers(self, tag: Tag, key: str, default: str | None, count: int = 1) -> list[float]:
        """Return the numbers of an attribute; raise InputError where they are others than `count` finite ones."""
        text = tag.said.get(key, default)
        if text is None:
            raise self.error(f"<{tag.name}> has no {key}.", "Add it.", tag.line)
        numbers = [number_of(word) for word in text.split()]
        found = [n for n in numbers if n is not None and abs(n) < LARGEST]
        if len(found) == len(numbers) == count:
            return found
        wanted = "a number was" if count == 1 else f"{count} numbers with blanks between them were"
        remedy = "Correct it."
        if "$" in text:
            remedy = "This is xacro: run `xacro x.xacro > x.urdf` and give x.urdf."
        raise self.error(f'{key}="{text}" in <{tag.name}>: {wanted} expected.', remedy, tag.line)

    def _number(self, tag: Tag, key: str, default: str | None = None) -> float:
        return self._numbers(tag, key, default)[0]

    def _frame(self, tag: Tag) -> Array:
        """Return the frame (4, 4) of an <origin> [mm]."""
        out, angles = np.eye(4), self._numbers(tag, "rpy", "0 0 0", 3)
        if max(map(abs, angles)) > ABSURD_TURN:
            raise self.error(
                f'rpy="{tag.said["rpy"]}" is more than a turn: degrees, where URDF has radians.',
                "Multiply by pi / 180.",
                tag.line,
            )
        if any(angles):
            out[:3, :3] = from_turns("xyz", np.array([angles]))[0]
        out[:3, 3] = MM * np.array(self._numbers(tag, "xyz", "0 0 0", 3))
        return out

    def _body(self, link: Tag, name: str) -> Body | None:
        tag = link["inertial"]
        if not any(inner is tag for inner in link.inside):
            return None
        mass = self._number(tag["mass"], "value")
        if mass < 0:
            raise self.error(f"link '{name}' weighs {mass:g} kg.", "Correct its mass.", tag["mass"].line)
        said = dict(zip(INERTIA, (self._number(tag["inertia"], key, "0") for key in INERTIA), strict=True))
        tensor = np.array([[said["i" + "".join(sorted(a + b))] for b in "xyz"] for a in "xyz"])
        return Body(mass, np.zeros(3), KG_MM2 * tensor).seen(self._frame(tag["origin"]))

    def _joint(self, tag: Tag) -> Joint:
        name, kind = self._text(tag, "name"), self._text(tag, "type")
        if kind not in KINDS:
            raise self.error(f"joint '{name}' is of the type '{kind}'.", f"Types are {', '.join(KINDS)}.", tag.line)
        axis = np.array(self._numbers(tag["axis"], "xyz", "1 0 0", 3))
        if kind != "fixed" and not 1e-6 < (length := float(np.linalg.norm(axis))) < 1e6:
            raise self.error(f"the axis of joint '{name}' has no direction.", "Correct its xyz.", tag["axis"].line)
        unit = MM if kind in SLIDING else 1.0
        limit, limits = tag["limit"], None
        low, high = (unit * self._number(limit, key, "0") for key in ("lower", "upper"))
        if kind in ("revolute", "prismatic") and low != high:
            if low > high:
                raise self.error(
                    f"the limits of joint '{name}' are {low / unit:g} and {high / unit:g}: lower is above upper.",
                    "Exchange them.",
                    limit.line,
                )
            limits = (low, high) if max(-low, high) < NONE * unit else None
        speed = unit * self._number(limit, "velocity", "0")
        mimic = tag["mimic"]
        return Joint(
            name=name,
            kind=kind,
            parent=self._text(tag["parent"], "link"),
            child=self._text(tag["child"], "link"),
            origin=self._frame(tag["origin"]),
            axis=axis / length if kind != "fixed" else axis,
            limits=limits,
            speed=speed if 0 < speed < NONE * unit else None,
            mimics=None
            if "joint" not in mimic.said
            else (
                mimic.said["joint"],
                self._number(mimic, "multiplier", "1"),
                unit * self._number(mimic, "offset", "0"),
            ),
            line=tag.line,
        )


def _parsed(path: Path) -> Tag:
    """Return the element <robot> of a file."""
    data = read_bytes(path)
    parser, top = expat.ParserCreate(), Tag("", {}, 1)
    open_ = [top]

    def begin(name: str, said: dict[str, str]) -> None:
        line = parser.CurrentLineNumber
        if name.startswith("xacro:"):
            remedy = "Run `xacro x.xacro > x.urdf` and give x.urdf."
            raise InputError(f"<{name}> is xacro, of which URDF is made.", remedy, file=path, line=line)
        tag = Tag(name, said, line)
        open_[-1].inside.append(tag)
        open_.append(tag)

    def end(_: str) -> None:
        open_.pop()

    def refuse(*_: object) -> None:
        raise InputError(
            "the file has a document type (<!DOCTYPE ...>), which URDF has not.",
            "Take it out, and entities with it.",
            file=path,
            line=parser.CurrentLineNumber,
        )

    parser.StartElementHandler, parser.EndElementHandler = begin, end
    parser.StartDoctypeDeclHandler = refuse
    try:
        parser.Parse(data, True)
    except expat.ExpatError as error:
        raise InputError(
            f"this is not XML: {expat.ErrorString(error.code)}.", "Correct the line.", file=path, line=error.lineno
        ) from None
    except (ValueError, LookupError) as error:
        raise InputError(f"this is not XML: {error}.", "Save it in UTF-8.", file=path) from None
    root = top.inside[0]
    if root.name != "robot":
        what = SPOKEN.get(root.name, f"<{root.name}>")
        raise InputError(
            f"this is {what}, where URDF begins with <robot>.", "Give the URDF.", file=path, line=root.line
        )
    return root
