"""Bags of ROS and files of MCAP: joints and what an instrument said, to a recording.

Joints come as JointState; readings as PointStamped, PoseStamped or TransformStamped, in metres as ROS has them. Any
other message by a mapping (TOML): which topic, which parts of its messages, in which unit. Bags and
single files of MCAP are read by rosbags (extra ``bags``).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import AfterValidator, Field

from deltacal_gen.errors import DeltacalError, FileNotReadable, ImportUnclear, NotInstalled, listed, naming
from deltacal_gen.files.imported import Imported, robot_with, write_import
from deltacal_gen.files.samples import Samples, imported, join
from deltacal_gen.files.toml import Table, TomlFile
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.rotation import vector_of_quaternion
from deltacal_gen.units import DEG

M = 1000.0  # mm
JOINTS = "JointState"
READINGS = ("PointStamped", "PoseStamped", "TransformStamped")
FEW = 6  # names that a message lists
_STEP = re.compile(r"([A-Za-z_]\w*)((?:\[\d+\])*)")

Path_ = Annotated[str, Field(pattern=r"^[A-Za-z_]\w*(\[\d+\])*(\.[A-Za-z_]\w*(\[\d+\])*)*$")]


def _is_body(fields: tuple[str, ...]) -> tuple[str, ...]:
    if len(fields) not in (0, 3, 6):
        raise ValueError("three or six parts were expected")
    return fields


class JointMap(Table):
    """[joints] of a mapping: names, of a JointState, in the robot's order; or parts of another message."""

    topic: str | None = None
    names: tuple[str, ...] = ()
    fields: tuple[Path_, ...] = ()
    unit: Literal["rad", "deg", "m", "mm"] = "rad"


class ReadingMap(Table):
    """[readings] of a mapping: parts of a message that are x, y, z, and a rotation vector where six are given."""

    topic: str | None = None
    fields: Annotated[tuple[Path_, ...], AfterValidator(_is_body)] = ()
    unit: Literal["m", "mm"] = "m"
    angles: Literal["rad", "deg"] = "rad"


class BagMap(Table):
    """The file of ``--mapping``."""

    joints: JointMap = JointMap()
    readings: ReadingMap = ReadingMap()


def import_bag(
    path: str | Path,
    robot: str | Path | None = None,
    output: str | Path | None = None,
    *,
    joints: str | None = None,
    readings: str | None = None,
    mapping: str | Path | None = None,
    moving: bool = False,
    offset_s: float = 0.0,
) -> Imported:
    """Import a bag: a folder of ROS 2, a ``.bag`` of ROS 1, or a file of MCAP.

    Parameters
    ----------
    path : path
        The bag.
    robot : path, optional
        Robot file: how many joints there are, and which of them slide.
    output : path, optional
        Folder for recording.csv, and robot.toml.
    joints : str, optional
        Topic of the joints; needed where several topics hold JointState.
    readings : str, optional
        Topic of the readings; needed where several topics hold points or poses.
    mapping : path, optional
        TOML with ``[joints]`` (topic, names or fields, unit) and ``[readings]`` (topic, fields, unit, angles).
    moving : bool
        One row for every reading, also where the joints stand still.
    offset_s : float
        Offset added to the time stamps of the readings [s].

    Raises
    ------
    InputError
        The bag cannot be read, or a topic is missing.
    UsageError
        The libraries are not installed.

    Examples
    --------
    deltacal import bag session.mcap robot.toml -o session
    """
    path = Path(path)
    said = BagMap() if mapping is None else TomlFile.read(mapping).check(BagMap)
    names = list(said.joints.names)
    with naming(path), _opened(path) as bag:
        kinds = {c.topic: c.msgtype.rpartition("/")[2] for c in bag.connections}
        of_joints = _chosen(kinds, joints or said.joints.topic, (JOINTS,), "joints", said.joints)
        of_readings = _chosen(kinds, readings or said.readings.topic, READINGS, "readings", said.readings)
        q, told = _logged(bag, of_joints, _fields(said.joints.fields) or _by_name(names))
        y, more = _logged(bag, of_readings, _fields(said.readings.fields) or _body)
    machine, units = robot_with(robot, q.values.shape[1], path)
    if machine is None:
        units = ("rad" if said.joints.unit in ("rad", "deg") else "mm",) * q.values.shape[1]
        told.append(f"without a robot file the joints are taken to be in {units[0]}")
    if names:
        told.insert(0, f"joints 1 to {len(names)} are {', '.join(names)}")
    told = [f"joints from {of_joints}, readings from {of_readings}", *told, *more]
    q = replace(q, values=q.values * _joint_scales(said.joints.unit, units))
    body = y.values * _body_scales(said.readings)[: y.values.shape[1]] if said.readings.fields else y.values
    joined = join(q, Samples(y.name, y.time + offset_s, body), moving=moving, path=path)
    return write_import(imported(joined, units, machine, path, tuple(told)), output)


def _logged(bag: Any, topic: str, take: Callable[[Any], list[float]]) -> tuple[Samples, list[str]]:
    """Return what `take` finds in the messages of a topic, and what a user should know of their stamps."""
    times, values, told = list[float](), list[list[float]](), list[str]()
    for connection, received, raw in bag.messages(connections=[c for c in bag.connections if c.topic == topic]):
        message = bag.deserialize(raw, connection.msgtype)
        try:
            values.append(take(message))
        except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
            raise ImportUnclear(
                f"a message of {topic} is not as the mapping says: {error}.",
                "Say in the file of --mapping which parts of the message are meant: fields = [...].",
            ) from None
        if (stamp := _stamp(message)) is None:
            told = [f"{topic}: messages without a stamp have the time at which they were logged"]
        times.append(received * 1e-9 if stamp is None else stamp)
    if len({len(own) for own in values}) != 1:
        found = "holds messages of different lengths" if values else "is empty"
        raise ImportUnclear(f"{topic} {found}.", "Look at the bag: ros2 bag info.")
    return Samples(topic, np.array(times), np.array(values)), told


def _chosen(
    topics: Mapping[str, str], asked: str | None, kinds: Sequence[str], what: str, said: JointMap | ReadingMap
) -> str:
    """Return the topic that is requested, or the only one of some kinds."""
    fitting = [t for t, kind in topics.items() if kind in kinds]
    if asked is None and len(fitting) == 1:
        return fitting[0]
    if asked is None:
        found = f"several topics could be the {what}" if fitting else f"no topic holds {' or '.join(kinds)}"
        raise ImportUnclear(f"{found}.", f"Name one, --{what} TOPIC; there are {_listed(topics)}.")
    if asked not in topics:
        raise ImportUnclear(f"there is no topic {asked}.", f"There are {_listed(topics)}.")
    if not said.fields and asked not in fitting:
        raise ImportUnclear(
            f"{asked} holds {topics[asked]}, not {' or '.join(kinds)}.",
            f"Say in the file of --mapping which parts of it are meant: [{what}] fields = [...].",
        )
    return asked


def _listed(topics: Mapping[str, str]) -> str:
    return listed([f"{topic} ({kind})" for topic, kind in sorted(topics.items())], FEW) or "none"


# ------------------------------------------------------------------------------------------------------ of a message


def _stamp(message: Any) -> float | None:
    """Return the stamp of a message [s]; None where it has none, or one that nobody has set."""
    stamp = getattr(getattr(message, "header", None), "stamp", None)
    if stamp is None:
        return None
    nanoseconds = getattr(stamp, "nanosec", getattr(stamp, "nsec", 0))
    return float(stamp.sec + 1e-9 * nanoseconds) or None


def _by_name(names: list[str]) -> Callable[[Any], list[float]]:
    """Return what takes the joints of a JointState by their names, whose order may change between messages."""

    def take(message: Any) -> list[float]:
        if not names:
            names.extend(message.name)
        at = {name: k for k, name in enumerate(message.name)}
        return [float(message.position[at[name]]) for name in names]

    return take


def _fields(paths: Sequence[str]) -> Callable[[Any], list[float]] | None:
    """Return what takes parts of a message: ``pose.position.x``, ``data[2]``; None where none are named."""
    return (lambda message: [float(_part(message, path)) for path in paths]) if paths else None


def _part(message: Any, path: str) -> Any:
    for name, indices in _STEP.findall(path):
        message = getattr(message, name)
        for index in re.findall(r"\d+", indices):
            message = message[int(index)]
    return message


def _body(message: Any) -> list[float]:
    """Return x, y, z [mm] of a stamped message, and the rotation vector [rad] of a pose or a transform."""
    if hasattr(message, "point"):
        return [M * getattr(message.point, axis) for axis in "xyz"]
    if hasattr(message, "pose"):
        place, turn = message.pose.position, message.pose.orientation
    else:
        place, turn = message.transform.translation, message.transform.rotation
    xyz = [M * getattr(place, axis) for axis in "xyz"]
    return [*xyz, *vector_of_quaternion(np.array([[getattr(turn, axis) for axis in "xyzw"]]))[0]]


# ------------------------------------------------------------------------------------------------------------- units


def _joint_scales(unit: str, inside: Sequence[str]) -> Array:
    """Return by what recorded joints are multiplied: ROS counts those that turn in rad, those that slide in m."""
    turned, slid = DEG if unit == "deg" else 1.0, 1.0 if unit == "mm" else M
    return np.array([turned if u == "rad" else slid for u in inside])


def _body_scales(said: ReadingMap) -> Array:
    """Return by what x, y, z and a rotation vector are multiplied that a mapping names."""
    return np.repeat([M if said.unit == "m" else 1.0, DEG if said.angles == "deg" else 1.0], 3)


# ------------------------------------------------------------------------------------------------------------ formats


@contextmanager
def _opened(path: Path) -> Iterator[Any]:
    """Yield a reader of a bag of either ROS, or of a file of MCAP; raises InputError, UsageError."""
    if not path.exists():
        raise FileNotReadable("there is no such file or folder.", "Check the path.")
    try:
        from rosbags.highlevel import AnyReader
        from rosbags.typesys import Stores, get_typestore
    except ImportError:
        raise NotInstalled("bags need rosbags. Install it: pip install 'deltacal_gen[bags]'.") from None
    try:
        with AnyReader([path], default_typestore=get_typestore(Stores.LATEST)) as reader:
            yield reader
    except DeltacalError:
        raise
    except Exception as error:  # of a library that lets through whatever is wrong inside a bag
        raise FileNotReadable(
            f"the bag cannot be read: {type(error).__name__}: {error}.".replace("..", "."),
            "Give the folder of a ROS 2 bag (with metadata.yaml), a .bag of ROS 1, or a file .mcap.",
        ) from None
