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

from deltacal_gen.errors import FileFormat, InputError, UnknownName, UnusableURDF, listed
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
SPOKEN = {"sdf": "SDF, of Gazebo", "mujoco": "MJCF, of MuJoCo", "html": "a page of the web", "COLLADA": "a mesh"}


@dataclass(frozen=True)
class Placed:
    """What begins in a line of the file."""

    line: int

    def error(self, problem: str, remedy: str) -> InputError:
        """Return an error at its line."""
        return UnusableURDF(problem, remedy, line=self.line)


@dataclass(frozen=True)
class Tag(Placed):
    """An element of XML: its attributes, and what is inside."""

    name: str
    said: dict[str, str]
    inside: list[Tag] = field(default_factory=list)

    def __getitem__(self, name: str) -> Tag:
        """Return the first element of a name in this one; an empty one where there is none."""
        return next((tag for tag in self.inside if tag.name == name), Tag(self.line, name, {}))

    def text(self, key: str) -> str:
        """Return an attribute; raise InputError where it is not there."""
        if text := self.said.get(key, "").strip():
            return text
        raise self.error(f"<{self.name}> has no {key}.", f'Add {key}="...".')

    def numbers(self, key: str, default: str | None, count: int = 1) -> list[float]:
        """Return the numbers of an attribute; raise InputError where they are others than `count` finite ones."""
        text = self.text(key) if default is None else self.said.get(key, default)
        numbers = [number_of(word) for word in text.split()]
        found = [n for n in numbers if n is not None and abs(n) < LARGEST]
        if len(found) == len(numbers) == count:
            return found
        wanted = "a number was" if count == 1 else f"{count} numbers with blanks between them were"
        remedy = "This is xacro: run `xacro x.xacro > x.urdf` and give x.urdf." if "$" in text else "Correct it."
        raise self.error(f'{key}="{text}" in <{self.name}>: {wanted} expected.', remedy)

    def number(self, key: str, default: str | None = None) -> float:
        """Return the number of an attribute."""
        return self.numbers(key, default)[0]

    @property
    def frame(self) -> Array:
        """The frame (4, 4) of an <origin> [mm]."""
        out, angles = np.eye(4), self.numbers("rpy", "0 0 0", 3)
        if max(map(abs, angles)) > ABSURD_TURN:
            problem = f'rpy="{self.said["rpy"]}" is more than a turn: degrees, where URDF has radians.'
            raise self.error(problem, "Multiply by pi / 180.")
        if any(angles):
            out[:3, :3] = from_turns("xyz", np.array([angles]))[0]
        out[:3, 3] = MM * np.array(self.numbers("xyz", "0 0 0", 3))
        return out


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
class Joint(Placed):
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
                name = tag.text("name")
                if name in self.bodies:
                    raise tag.error(f"there are two links '{name}'.", "Give each its own name.")
                self.bodies[name], self.below[name] = _body(tag, name), []
        joints = [_joint(tag) for tag in root.inside if tag.name == "joint"]
        for k, joint in enumerate(joints):
            if joint.name in {other.name for other in joints[:k]}:
                raise joint.error(f"there are two joints '{joint.name}'.", "Give each its own name.")
            self._hang(joint)
        if not joints:
            raise root.error(
                "there is no joint in the file.",
                "Give the whole robot's URDF; what ROS keeps as robot_description is one.",
            )
        reached = [link for link in self.bodies if link not in self.above]
        for link in reached:
            reached += [joint.child for joint in self.below[link]]
        if lost := [joint for joint in joints if joint.child not in set(reached)]:
            names = ", ".join(f"'{joint.name}'" for joint in lost)
            raise lost[0].error(f"joints lead in a circle, from no root: {names}.", "Correct a parent or a child.")

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
        if link not in self.bodies:
            close = nearest(link, self.bodies)
            hint = f"did you mean '{close}'?" if close else f"it has {listed([*self.bodies], LISTED)}."
            raise UnknownName(f"{option}: {self.path} has no link '{link}'; {hint}")

    def _hang(self, joint: Joint) -> None:
        for what, link in (("parent", joint.parent), ("child", joint.child)):
            if link not in self.bodies:
                raise joint.error(
                    f"the {what} of joint '{joint.name}' is '{link}', which is no link of the file.",
                    f'Correct the name, or add <link name="{link}"/>.',
                )
        if (other := self.above.get(joint.child)) is not None:
            raise joint.error(
                f"link '{joint.child}' hangs on two joints, '{other.name}' and '{joint.name}': a loop, which URDF "
                "cannot say.",
                "Leave out the joint that closes the loop.",
            )
        self.above[joint.child] = joint
        self.below[joint.parent].append(joint)


def _body(link: Tag, name: str) -> Body | None:
    """Return what a link weighs; None where it does not say."""
    tag = link["inertial"]
    if not any(inner is tag for inner in link.inside):
        return None
    mass = tag["mass"].number("value")
    if mass < 0:
        raise tag["mass"].error(f"link '{name}' weighs {mass:g} kg.", "Correct its mass.")
    tensor = [[tag["inertia"].number("i" + "".join(sorted(a + b)), "0") for b in "xyz"] for a in "xyz"]
    return Body(mass, np.zeros(3), KG_MM2 * np.array(tensor)).seen(tag["origin"].frame)


def _joint(tag: Tag) -> Joint:
    """Return a joint; raise InputError where it says what cannot be."""
    name, kind, limit, mimic = tag.text("name"), tag.text("type"), tag["limit"], tag["mimic"]
    if kind not in KINDS:
        raise tag.error(f"joint '{name}' is of the type '{kind}'.", f"Types are {', '.join(KINDS)}.")
    axis = np.array(tag["axis"].numbers("xyz", "1 0 0", 3))
    length = float(np.linalg.norm(axis)) if kind != "fixed" else 1.0
    if not 1e-6 < length < 1e6:
        raise tag["axis"].error(f"the axis of joint '{name}' has no direction.", "Correct its xyz.")
    unit = MM if kind in SLIDING else 1.0
    low, high, speed = (unit * limit.number(key, "0") for key in ("lower", "upper", "velocity"))
    limited = kind in ("revolute", "prismatic") and low != high
    if limited and low > high:
        problem = f"the limits of joint '{name}' are {low / unit:g} and {high / unit:g}: lower is above upper."
        raise limit.error(problem, "Exchange them.")
    follows = mimic.said.get("joint")
    return Joint(
        line=tag.line,
        name=name,
        kind=kind,
        parent=tag["parent"].text("link"),
        child=tag["child"].text("link"),
        origin=tag["origin"].frame,
        axis=axis / length,
        limits=(low, high) if limited and max(-low, high) < NONE * unit else None,
        speed=speed if 0 < speed < NONE * unit else None,
        mimics=None
        if follows is None
        else (follows, mimic.number("multiplier", "1"), unit * mimic.number("offset", "0")),
    )


def _parsed(path: Path) -> Tag:
    """Return the element <robot> of a file."""
    parser, top = expat.ParserCreate(), Tag(1, "", {})
    open_ = [top]

    def begin(name: str, said: dict[str, str]) -> None:
        tag = Tag(parser.CurrentLineNumber, name, said)
        if name.startswith("xacro:"):
            remedy = "Run `xacro x.xacro > x.urdf` and give x.urdf."
            raise tag.error(f"<{name}> is xacro, of which URDF is made.", remedy)
        open_[-1].inside.append(tag)
        open_.append(tag)

    def refuse(*_: object) -> None:
        problem = "the file has a document type (<!DOCTYPE ...>), which URDF has not."
        raise UnusableURDF(problem, "Take it out, and entities with it.", line=parser.CurrentLineNumber)

    parser.StartElementHandler, parser.EndElementHandler = begin, lambda _: open_.pop()
    parser.StartDoctypeDeclHandler = refuse
    try:
        parser.Parse(read_bytes(path), True)
    except expat.ExpatError as error:
        problem = f"this is not XML: {expat.ErrorString(error.code)}."
        raise UnusableURDF(problem, "Correct the line.", line=error.lineno) from None
    except (ValueError, LookupError) as error:
        raise FileFormat(f"this is not XML: {error}.", "Save it in UTF-8.") from None
    root = top.inside[0]
    if root.name != "robot":
        what = SPOKEN.get(root.name, f"<{root.name}>")
        raise root.error(f"this is {what}, where URDF begins with <robot>.", "Give the URDF.")
    return root
