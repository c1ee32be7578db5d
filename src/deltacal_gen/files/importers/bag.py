"""Bags of ROS and files of MCAP: joints and what an instrument said, to a recording.

Joints come as JointState; readings as PointStamped, PoseStamped or TransformStamped, in metres as ROS has them. Any
other message by a mapping (TOML): which topic, which parts of its messages, in which unit. Bags are read by rosbags,
single files of MCAP by mcap (extra ``bags``).
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field

from deltacal_gen.errors import DeltacalError, InputError, UsageError
from deltacal_gen.files.imported import Imported, robot_with, write_import
from deltacal_gen.files.quaternions import rotation_vector
from deltacal_gen.files.samples import Samples, imported, join
from deltacal_gen.files.toml import Table, TomlFile
from deltacal_gen.machine.registry import Array

SCALES = {"rad": 1.0, "deg": np.pi / 180, "mm": 1.0, "m": 1000.0}  # to rad and mm
JOINTS = "JointState"
READINGS = ("PointStamped", "PoseStamped", "TransformStamped")
FEW = 6  # names that a message lists
_STEP = re.compile(r"([A-Za-z_]\w*)((?:\[\d+\])*)")

Path_ = Annotated[str, Field(pattern=r"^[A-Za-z_]\w*(\[\d+\])*(\.[A-Za-z_]\w*(\[\d+\])*)*$")]


class JointMap(Table):
    """[joints] of a mapping: names, of a JointState, in the robot's order; or parts of another message."""

    topic: str | None = None
    names: tuple[str, ...] = ()
    fields: tuple[Path_, ...] = ()
    unit: Literal["rad", "deg", "m", "mm"] = "rad"


class ReadingMap(Table):
    """[readings] of a mapping: parts of a message that are x, y, z, and a rotation vector where six are given."""

    topic: str | None = None
    fields: tuple[Path_, ...] = ()
    unit: Literal["m", "mm"] = "m"
    angles: Literal["rad", "deg"] = "rad"


class BagMap(Table):
    """The file of ``--map``."""

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
    """Return a recording of a bag: a folder of ROS 2, a ``.bag`` of ROS 1, or a file of MCAP.

    Parameters
    ----------
    robot : path, optional
        Robot file: how many joints there are, and which of them slide.
    joints, readings : str, optional
        Topics; asked for where several could be meant.
    mapping : path, optional
        TOML with ``[joints]`` (topic, names or fields, unit) and ``[readings]`` (topic, fields, unit, angles).
    moving : bool
        Every reading is a row, also where the joints stand still.
    offset_s : float
        What is to be added to the stamps of the readings [s].

    Raises
    ------
    InputError
        The bag cannot be read, or does not hold what is asked for.
    UsageError
        The libraries are not installed.
    """
    path = Path(path)
    said = BagMap() if mapping is None else TomlFile.read(mapping).check(BagMap)
    with_kinds = dict(_topics(path))
    of_joints = _chosen(path, with_kinds, joints or said.joints.topic, (JOINTS,), "joints", bool(said.joints.fields))
    of_readings = _chosen(
        path, with_kinds, readings or said.readings.topic, READINGS, "readings", bool(said.readings.fields)
    )
    logged: dict[str, list[tuple[float, bool, list[float]]]] = {of_joints: [], of_readings: []}
    names = list(said.joints.names)
    take: dict[str, Callable[[Any], list[float]]] = {
        of_joints: _fields(said.joints.fields) if said.joints.fields else _by_name(names),
        of_readings: _fields(said.readings.fields) if said.readings.fields else _body,
    }
    for topic, received, message in _messages(path, {of_joints, of_readings}):
        stamp = _stamp(message)
        try:
            values = take[topic](message)
        except (AttributeError, IndexError, KeyError, TypeError, ValueError) as error:
            raise InputError(
                f"a message of {topic} is not as the mapping says: {error}.",
                "Say in the file of --map which parts of the message are meant: fields = [...].",
                file=path,
            ) from None
        logged[topic].append((received if stamp is None else stamp, stamp is None, values))
    count = len(logged[of_joints][0][2]) if logged[of_joints] else 0
    units = robot_with(robot, count, path)[1] or _usual(said.joints.unit, count)
    q, y = (_samples(name, rows, path) for name, rows in logged.items())
    scaled = Samples(q.name, q.time, q.values * _joint_scales(said.joints.unit, units))
    body = _scaled(y.values, said.readings) if said.readings.fields else y.values
    joined = join(scaled, Samples(y.name, y.time + offset_s, body), moving=moving, path=path)
    told = _told(of_joints, of_readings, names, logged, units if robot is None else ())
    return write_import(imported(joined, units, robot, path, told), output)


def _told(
    of_joints: str, of_readings: str, names: Sequence[str], logged: dict[str, Any], assumed: Sequence[str]
) -> tuple[str, ...]:
    out = [f"joints from {of_joints}, readings from {of_readings}"]
    if names:
        out.append(f"joints 1 to {len(names)} are {', '.join(names)}")
    if assumed:
        out.append(f"without a robot file the joints are taken to be in {assumed[0]}")
    for topic, rows in logged.items():
        if any(received for _, received, _ in rows):
            out.append(f"{topic}: messages without a stamp have the time at which they were logged")
    return tuple(out)


def _chosen(
    path: Path, topics: dict[str, str], asked: str | None, kinds: Sequence[str], what: str, mapped: bool
) -> str:
    """Return the topic that is asked for, or the only one of some kinds."""
    fitting = [t for t, kind in topics.items() if kind in kinds]
    if asked is not None:
        if asked not in topics:
            raise InputError(f"there is no topic {asked}.", f"There are {_listed(topics)}.", file=path)
        if not mapped and asked not in fitting:
            raise InputError(
                f"{asked} holds {topics[asked]}, not {' or '.join(kinds)}.",
                f"Say in the file of --map which parts of it are meant: [{what}] fields = [...].",
                file=path,
            )
        return asked
    if len(fitting) != 1:
        found = f"several topics could be the {what}" if fitting else f"no topic holds {' or '.join(kinds)}"
        raise InputError(f"{found}.", f"Name one, --{what} TOPIC; there are {_listed(topics)}.", file=path)
    return fitting[0]


def _listed(topics: dict[str, str]) -> str:
    each = [f"{topic} ({kind})" for topic, kind in sorted(topics.items())]
    return (", ".join(each[:FEW]) + (" ..." if len(each) > FEW else "")) or "none"


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


def _fields(paths: Sequence[str]) -> Callable[[Any], list[float]]:
    """Return what takes parts of a message: ``pose.position.x``, ``data[2]``."""

    def take(message: Any) -> list[float]:
        return [float(_part(message, path)) for path in paths]

    return take


def _part(message: Any, path: str) -> Any:
    for name, indices in _STEP.findall(path):
        message = getattr(message, name)
        for index in re.findall(r"\d+", indices):
            message = message[int(index)]
    return message


def _body(message: Any) -> list[float]:
    """Return x, y, z [mm] of a stamped message, and the rotation vector [rad] of a pose or a transform."""
    if hasattr(message, "point"):
        return [1000.0 * getattr(message.point, axis) for axis in "xyz"]
    held = getattr(message, "pose", None)
    place, turn = (held.position, held.orientation) if held is not None else (None, None)
    if held is None:
        place, turn = message.transform.translation, message.transform.rotation
    xyz = [1000.0 * getattr(place, axis) for axis in "xyz"]
    return [*xyz, *rotation_vector(np.array([[getattr(turn, axis) for axis in "xyzw"]]))[0]]


# ------------------------------------------------------------------------------------------------------------- units


def _usual(unit: str, count: int) -> tuple[str, ...]:
    return ("rad" if unit in ("rad", "deg") else "mm",) * count


def _joint_scales(unit: str, inside: Sequence[str]) -> Array:
    """Return by what recorded joints are multiplied: ROS counts those that turn in rad, those that slide in m."""
    turned = SCALES[unit] if unit in ("rad", "deg") else 1.0
    slid = SCALES[unit] if unit in ("m", "mm") else SCALES["m"]
    return np.array([turned if u == "rad" else slid for u in inside])


def _scaled(values: Array, said: ReadingMap) -> Array:
    if values.shape[1] not in (3, 6):
        raise UsageError(f"[readings] fields of the mapping names {values.shape[1]} parts; three or six were expected.")
    out = values * SCALES[said.unit]
    out[:, 3:] = values[:, 3:] * SCALES[said.angles]
    return out


def _samples(name: str, rows: Sequence[tuple[float, bool, list[float]]], path: Path) -> Samples:
    widths = {len(values) for *_, values in rows}
    if len(widths) != 1:
        found = "is empty" if not rows else "holds messages of different lengths"
        raise InputError(f"{name} {found}.", "Look at the bag: ros2 bag info.", file=path)
    return Samples(name, np.array([t for t, *_ in rows]), np.array([values for *_, values in rows]))


# ------------------------------------------------------------------------------------------------------------ formats


def _missing(library: str) -> UsageError:
    return UsageError(f"bags need {library}. Install it: pip install 'deltacal_gen[bags]'.")


def _damaged(path: Path, error: Exception) -> InputError:
    return InputError(
        f"the bag cannot be read: {type(error).__name__}: {error}.".replace("..", "."),
        "Give the folder of a ROS 2 bag (with metadata.yaml), a .bag of ROS 1, or a file .mcap.",
        file=path,
    )


def _topics(path: Path) -> Iterator[tuple[str, str]]:
    """Yield topics and the last part of what they hold."""
    if not path.exists():
        raise InputError("there is no such file or folder.", "Check the path.", file=path)
    if path.suffix == ".mcap" and path.is_file():
        with _opened_mcap(path) as reader:
            summary = reader.get_summary()
            if summary is None:
                raise InputError("the file has no summary.", "Repair it: mcap recover.", file=path)
            for channel in summary.channels.values():
                schema = summary.schemas.get(channel.schema_id)
                yield channel.topic, "" if schema is None else schema.name.rpartition("/")[2]
    else:
        with _opened_bag(path) as reader:
            for connection in reader.connections:
                yield connection.topic, connection.msgtype.rpartition("/")[2]


def _messages(path: Path, topics: set[str]) -> Iterator[tuple[str, float, Any]]:
    """Yield topic, time of receipt [s] and message, in the order of receipt."""
    if path.suffix == ".mcap" and path.is_file():
        with _opened_mcap(path) as reader:
            for _, channel, raw, message in reader.iter_decoded_messages(topics=sorted(topics)):
                yield channel.topic, raw.log_time * 1e-9, message
    else:
        with _opened_bag(path) as reader:
            wanted = [c for c in reader.connections if c.topic in topics]
            for connection, received, raw in reader.messages(connections=wanted):
                yield connection.topic, received * 1e-9, reader.deserialize(raw, connection.msgtype)


@contextmanager
def _opened_bag(path: Path) -> Iterator[Any]:
    try:
        from rosbags.highlevel import AnyReader
        from rosbags.typesys import Stores, get_typestore
    except ImportError:
        raise _missing("rosbags") from None
    try:
        with AnyReader([path], default_typestore=get_typestore(Stores.LATEST)) as reader:
            yield reader
    except DeltacalError:
        raise
    except Exception as error:  # of a library that lets through whatever is wrong inside a bag
        raise _damaged(path, error) from None


@contextmanager
def _opened_mcap(path: Path) -> Iterator[Any]:
    try:
        from mcap.reader import make_reader
        from mcap_ros2.decoder import DecoderFactory
    except ImportError:
        raise _missing("mcap and mcap-ros2-support") from None
    try:
        with path.open("rb") as file:
            yield make_reader(file, decoder_factories=[DecoderFactory()])
    except DeltacalError:
        raise
    except Exception as error:  # as above
        raise _damaged(path, error) from None
