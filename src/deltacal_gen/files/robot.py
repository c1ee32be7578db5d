"""The robot file: a TOML table of nominal values, read, checked and written back.

Files speak mm and deg, a `Robot` speaks mm and rad; the conversion happens here and nowhere else. What a robot file
may say depends on its mechanism, so the schema is built from the mechanism's own tables of keys and parameters:
a new mechanism needs no line in this module.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import AfterValidator, BaseModel, BeforeValidator, Field, create_model
from pydantic_core import to_jsonable_python

from deltacal_gen.errors import FileFormat, UnknownModel, UsageError, WrongUnit
from deltacal_gen.files.toml import NonNegative, Number, Positive, Raw, Table, TomlFile, Vector, table_of, toml_text
from deltacal_gen.machine.registry import GeometryKey, Machine, described, load_mechanism, mechanism_of
from deltacal_gen.machine.values import Link, Masses, Robot, Transmission, Workspace
from deltacal_gen.results.parts import RobotTables
from deltacal_gen.units import file_unit, joint_factors, to_file, to_internal

TABLES = (".csv", ".parquet", ".xlsx", ".txt")  # endings of recordings
SHORTEST_MACHINE = 2.0  # mm; a machine whose longest length is below this was written down in metres
ROUNDED = 5e-3  # by which a right angle in radians may be: 1.57
LONGEST_LINK = 20_000.0  # mm; a length above this was written down in micrometres


def _is_interval(pair: tuple[float, ...]) -> tuple[float, ...]:
    if pair[0] >= pair[1]:
        raise ValueError("the lower limit must be below the upper one")
    return pair


def _list(item: Any, count: int) -> Any:
    return Annotated[tuple[item, ...], Field(min_length=count, max_length=count)]


def _per_limb(item: Any, limbs: int) -> Any:
    """Type of one `item` per limb; a single number stands for all limbs."""

    def spread(value: object) -> object:
        return (value,) * limbs if isinstance(value, (int, float)) else value

    return Annotated[_list(item, limbs), BeforeValidator(spread)]


_Tensor: Any = _list(Number, 6)
_Interval: Any = Annotated[_list(Number, 2), AfterValidator(_is_interval)]
_Masses = table_of(Masses, NonNegative, proximal_com=Number, gravity=Vector)
_Transmission = table_of(Transmission, Positive, torque_constant_Nm_A=tuple[Positive, ...])


class _Joint(Table):
    """One link of an open chain, as a table ``[[joint]]`` of the robot file [mm, deg, kg]."""

    kind: Literal["revolute", "prismatic", "fixed", "coupled"]
    convention: Literal["standard", "modified"] = "standard"
    a: Number = 0.0
    alpha: Number = 0.0
    d: Number = 0.0
    theta: Number = 0.0
    mass: NonNegative = 0.0
    com: Vector = (0.0, 0.0, 0.0)
    coupling: dict[str, Number] | None = None
    inertia: _Tensor | None = None
    rotor_inertia: NonNegative | None = None


def read_robot(path: str | Path) -> Robot:
    """Read a robot file.

    Parameters
    ----------
    path : path
        The TOML file [mm, deg].

    Raises
    ------
    InputError
        The file cannot be used; the message names file, line, key and remedy.
    """
    if Path(path).suffix.lower() in TABLES:
        raise FileFormat("this is a table, where a robot file is wanted.", "Give the robot first (TOML).", file=path)
    return _robot(TomlFile.read(path))


def robot_from_dict(tables: Raw) -> Robot:
    """Robot from the tables of a robot file, as `robot_to_dict` gives them [mm, deg]; raises InputError."""
    return _robot(TomlFile(None, "", dict(tables)))


def robot_to_dict(robot: Robot) -> dict[str, Any]:
    """Tables of a complete robot file, ready for JSON or TOML [mm, deg]."""
    mechanism = mechanism_of(robot)
    tables: dict[str, Any] = {"robot": {"name": robot.name, "mechanism": robot.mechanism}}
    if robot.drawn:
        tables["geometry"] = {"tool": [float(value) for value in robot.tool]}
    for name in ("workspace", "masses", "transmission"):
        if (part := getattr(robot, name)) is not None:
            said = to_jsonable_python(part, exclude={"layers"})
            tables[name] = {key: value for key, value in said.items() if value is not None}
    tables["joints"] = {"sign": [int(sign) for sign in robot.joint_sign]}
    if robot.joint_limits is not None:
        joints = zip(robot.joint_limits, mechanism.joint_units, strict=True)
        limits = [[to_file(value, unit) for value in pair] for pair, unit in joints]
        tables["joints"][limits_key(mechanism.joint_units)] = limits
    if robot.links:
        tables["joint"] = [_joint_table(robot, k) for k in range(len(robot.links))]
    for key in () if mechanism.linked else mechanism.geometry:
        if key.table == "geometry" and not robot.drawn:
            continue
        values = [to_file(value, key.unit) for value in robot.geometry[key.key]]
        tables[key.table][key.key] = values if key.per_limb or len(values) > 1 else values[0]
    if robot.limits:
        tables["limits"] = {key: list(pair) for key, pair in robot.limits.items()}
    units = {parameter.name: parameter.unit for parameter in mechanism.parameters}
    for name, numbers in (("errors", robot.errors), ("tolerance", robot.tolerance)):
        if numbers:
            tables[name] = {key: to_file(value, units[key]) for key, value in numbers.items()}
    return tables


def kept_robot(robot: Robot) -> RobotTables:
    """Return what an answer keeps of a robot: a complete robot file [mm, deg]."""
    return RobotTables.model_validate(robot_to_dict(robot))


def robot_of(kept: RobotTables) -> Robot:
    """Return the robot that an answer kept; raises InputError."""
    return robot_from_dict(kept.to_dict())


def robot_to_toml(robot: Robot) -> str:
    """Text of a complete robot file that reads back as the same robot, to the last digit or two."""
    return toml_text(robot_to_dict(robot))


def robot_size(robot: Robot) -> float:
    """Sum of the machine's lengths, the mean over the limbs of each [mm]: a yardstick for plausible readings."""
    if robot.links:  # a chain reaches as far as its links together
        return float(np.abs(robot.geometry["a"]).sum() + np.abs(robot.geometry["d"]).sum())
    lengths = (key.key for key in mechanism_of(robot).geometry if key.unit == "mm")
    return float(sum(np.abs(robot.geometry[key]).mean() for key in lengths))


def for_model(robot: Robot, model: str) -> Robot:
    """Return the robot as the mechanism that has `model`: a machine may be described by other source errors.

    Tolerances of errors that this mechanism does not have are left out.

    Raises
    ------
    UsageError
        The robot's own errors are not among those of the model's mechanism.
    """
    return _described(robot, model, lambda m: m.full_name(model) in m.models)


def for_names(robot: Robot, names: Iterable[str]) -> Robot:
    """Return the robot as the mechanism that has these source errors; as it is where none has. See `for_model`."""
    wanted = set(names)
    return _described(robot, ", ".join(sorted(wanted)), lambda m: wanted <= m.index.keys())


def _described(robot: Robot, what: str, fits: Callable[[Machine], bool]) -> Robot:
    other = _variant(mechanism_of(robot), fits)
    if foreign := sorted(name for name, value in robot.errors.items() if value and name not in other.index):
        raise UnknownModel(
            f"{what}: {other.name} has no {foreign[0]}, which the robot file names; errors of two kinds mix."
        )
    errors, tolerance = (
        {name: value for name, value in table.items() if name in other.index}
        for table in (robot.errors, robot.tolerance)
    )
    return dataclasses.replace(robot, mechanism=other.name, errors=errors, tolerance=tolerance)


def _variant(mechanism: Machine, fits: Callable[[Machine], bool]) -> Machine:
    """Return the first description of a machine, its own before others, that fits; its own where none does."""
    return mechanism if fits(mechanism) else next(filter(fits, described(mechanism)), mechanism)


def _joint_table(robot: Robot, k: int) -> dict[str, Any]:
    drawn = {key: to_file(robot.geometry[key][k], unit) for key, unit in _LINK_UNITS.items()}
    coupling = {str(number): much for number, much in robot.links[k].coupling}
    said: dict[str, Any] = robot.links[k]._asdict() | drawn | {"coupling": coupling or None}
    return _Joint(**said).model_dump(mode="json", exclude_none=True)


_LINK_UNITS = {"a": "mm", "alpha": "rad", "d": "mm", "theta": "rad"}


def _links(file: TomlFile, joints: Sequence[_Joint]) -> tuple[Link, ...]:
    """Return the links of a chain; raise InputError where a coupling leads nowhere."""
    found = []
    for k, joint in enumerate(joints, start=1):
        coupling = []
        for number, much in (joint.coupling or {}).items():
            other = int(number) if number.isdigit() else 0
            if not 1 <= other <= len(joints) or joints[other - 1].kind not in ("revolute", "prismatic"):
                raise file.error(
                    f"joint {k} is coupled to '{number}', which is no revolute or prismatic joint.",
                    "Give numbers of [[joint]] tables in this file, counted from 1.",
                    "joint",
                )
            coupling.append((other, much))
        if (joint.kind == "coupled") != bool(coupling):
            raise file.error(
                f"joint {k} is of the kind '{joint.kind}' and has {'a' if coupling else 'no'} coupling.",
                'A coupling belongs to kind = "coupled", and only to it: coupling = {2 = -1.0}.',
                "joint",
            )
        own = {key: getattr(joint, key) for key in ("kind", "convention", "mass", "com", "inertia")}
        alpha, rotor = joint.alpha * to_internal("rad"), joint.rotor_inertia
        found.append(Link(**own, alpha=alpha, coupling=tuple(coupling), rotor_inertia=rotor))
    if found and not any(link.kind in ("revolute", "prismatic") for link in found):
        raise file.error("the chain has no joint that moves.", "Add a revolute or prismatic one.", "joint")
    return tuple(found)


def _robot(file: TomlFile) -> Robot:
    named = file.check(_Head)
    head, links = named.robot, _links(file, named.joint)
    try:
        mechanism = _of_errors(file, load_mechanism(head.mechanism, links))
    except UsageError as error:
        raise file.error(
            f"mechanism in [robot]: {error}", "Write the name of a known mechanism.", "robot", "mechanism"
        ) from None
    drawn = mechanism.linked or "geometry" in file.data
    said = file.check(_schema(mechanism, drawn))
    tables = {name: dict(getattr(said, name)) for name in ("geometry", "joints", "errors", "tolerance")}
    geometry = {}
    if mechanism.linked:
        if not links:
            raise file.error("the chain has no links.", "Add one table [[joint]] for each, from the base.", "robot")
        _check_chain(file, named.joint)
        for name, kind in _LINK_UNITS.items():
            geometry[name] = np.array([getattr(joint, name) for joint in named.joint]) * to_internal(kind)
    else:
        _check_scale(file, mechanism, tables)
        _check_directions(file, mechanism, tables)
    for key in () if mechanism.linked else mechanism.geometry:
        value = tables[key.table][key.key]
        missing = key.default if key.default is not None else (np.nan,) * (mechanism.limbs if key.per_limb else 1)
        internal = missing if value is None else np.multiply(value, to_internal(key.unit))
        geometry[key.key] = np.atleast_1d(np.asarray(internal, dtype=float))
    limits = tables["joints"][limits_key(mechanism.joint_units)]
    factors = np.array(joint_factors(mechanism.joint_unit, mechanism.limbs))
    units = {parameter.name: parameter.unit for parameter in mechanism.parameters}
    errors, tolerance = (
        {name: value * to_internal(units[name]) for name, value in tables[table].items() if value is not None}
        for table in ("errors", "tolerance")
    )
    return Robot(
        name=head.name,
        mechanism=mechanism.name,
        geometry=geometry,
        tool=np.array(tables["geometry"]["tool"], dtype=float),
        errors=errors,
        tolerance=tolerance,
        workspace=None if said.workspace is None else Workspace(**dict(said.workspace), layers=mechanism.layers),
        masses=Masses(**dict(said.masses or ())) if said.masses or any(link.mass for link in links) else None,
        transmission=None if said.transmission is None else Transmission(**dict(said.transmission)),
        joint_sign=np.array(tables["joints"]["sign"], dtype=float),
        joint_limits=None if limits is None else np.array(limits) * factors[:, None],
        source=file.path,
        links=links,
        limits={key: (float(pair[0]), float(pair[1])) for key, pair in said.limits.items()},
    )


def _of_errors(file: TomlFile, mechanism: Machine) -> Machine:
    """Return which description of the machine has the errors and tolerances that a robot file names."""
    tables = (file.data.get(name, {}) for name in ("errors", "tolerance"))
    names = {name for table in tables if isinstance(table, dict) for name in table}
    return _variant(mechanism, lambda m: names <= m.index.keys())


class _Name(Table):
    name: str = "robot"
    mechanism: str


class _Head(BaseModel):
    """What is needed before the schema is known; all other tables wait."""

    robot: _Name
    joint: tuple[_Joint, ...] = ()


class _RobotFile(Table):
    """What does not depend on the mechanism; `_schema` adds workspace, geometry, joints, errors and tolerance."""

    robot: _Name
    masses: _Masses | None = None  # type: ignore[valid-type]
    transmission: _Transmission | None = None  # type: ignore[valid-type]
    limits: dict[str, _Interval] = Field(default_factory=dict)


@cache
def _schema(mechanism: Machine, drawn: bool = True) -> Any:
    """Return the schema of the robot files of one mechanism; None stands for a key that the file does not give.

    A machine that is not `drawn` has no table [geometry].
    """
    limbs, linked = mechanism.limbs, mechanism.linked
    keys = () if linked else mechanism.geometry
    geometry: dict[str, Any] = {"tool": (Vector, (0.0, 0.0, 0.0))}
    joints: dict[str, Any] = {
        "sign": (_per_limb(Literal[1, -1], limbs), (1,) * limbs),
        limits_key(mechanism.joint_units): (_list(_Interval, limbs), None),
    }
    for key in keys:
        fields = geometry if key.table == "geometry" else joints
        meaning = f"{key.meaning} [{file_unit(key.unit)}]"
        size = sum(other.key == key.key for other in keys)
        kind = _list(Number, size) if key.entry is not None else _value_type(key, limbs)
        needed = key.default is None and (drawn or key.table != "geometry")
        fields[key.key] = (kind, Field(... if needed else None, description=meaning))
    names = [parameter.name for parameter in mechanism.parameters]
    absent: Any = Field({}, validate_default=True)
    chain: Any = {"joint": (tuple[_Joint, ...], ...)} if linked else {}
    return create_model(
        "RobotFile",
        __base__=_RobotFile,
        **chain,
        workspace=(_workspace(mechanism) | None, None),
        geometry=(_table(geometry), absent if linked or not drawn else ...),
        joints=(_table(joints), absent),
        errors=(_table(dict.fromkeys(names, (Number, None))), absent),
        tolerance=(_table(dict.fromkeys(names, (Positive, None))), absent),
    )


def _workspace(mechanism: Machine) -> Any:
    """Return the table of a workspace: a cylinder, in the plane a rectangle, of a single joint a stroke along x."""
    shape, needed = "a stroke", {"width"}  # height and depth follow from the stroke
    if len(mechanism.axes) == 3:
        shape, needed = "a cylinder", {"top", "radius", "height"}
    elif mechanism.limbs > 1:
        shape, needed = "a rectangle", {"top", "width", "height"}
    meaning = f"the workspace of {mechanism.machine} is {shape} [mm]"
    fields: dict[str, Any] = dict.fromkeys(("top", "height"), (Positive, None))
    fields |= dict.fromkeys(sorted(needed), (Positive, Field(description=meaning)))
    return _table(fields | ({"turn": (NonNegative, None)} if mechanism.turning else {}))


def _table(fields: dict[str, Any]) -> Any:
    return create_model("Table", __base__=Table, **fields)


def _value_type(key: GeometryKey, limbs: int) -> Any:
    """Return what a key holds: distances cannot be zero or negative, coordinates (``positive = False``) can."""
    item: Any = Positive if key.unit == "mm" and key.positive else Number
    if key.per_limb:
        return _per_limb(item, limbs)
    return item if key.default is None or len(key.default) == 1 else _list(item, len(key.default))


def limits_key(units: Iterable[str]) -> str:
    """Return ``limits_deg`` or ``limits_mm``; of joints of both kinds ``limits``, each in its own unit."""
    known = {*map(file_unit, units)}
    return f"limits_{known.pop()}" if len(known) == 1 else "limits"


def _check_scale(file: TomlFile, mechanism: Machine, tables: Mapping[str, Mapping[str, Any]]) -> None:
    keys = [key for key in mechanism.geometry if key.unit == "mm" and tables[key.table][key.key] is not None]
    sizes = {key: float(np.abs(tables[key.table][key.key]).max()) for key in keys}
    if sizes:
        key = max(sizes, key=lambda k: sizes[k])
        what = f"lengths in [{key.table}]", f"{key.key} = {sizes[key]:g}"
        _check_length(file, sizes[key], what, SHORTEST_MACHINE, key.table, key.key)


def _check_length(file: TomlFile, largest: float, what: tuple[str, str], shortest: float, *keys: str) -> None:
    """Refuse lengths in metres or micrometres, by the largest one [mm]."""
    if largest < shortest or largest > LONGEST_LINK:
        unit, factor = ("metres", "Multiply by") if largest < shortest else ("micrometres", "Divide by")
        raise file.error(
            f"the {what[0]} look like {unit} (the largest is {what[1]}); the file is in millimetres.",
            f"{factor} 1000.",
            *keys,
            family=WrongUnit,
        )


def _check_directions(file: TomlFile, mechanism: Machine, tables: Mapping[str, Mapping[str, Any]]) -> None:
    """Refuse directions in radians: limbs all round a machine, and none of them beyond a few degrees."""
    for key in mechanism.geometry:
        values = np.array(tables[key.table].get(key.key) if key.unit == "rad" and key.per_limb else 0.0, dtype=float)
        if np.ptp(values) >= math.pi and np.abs(values).max() <= 2 * math.pi:
            raise file.error(
                f"{key.key} = {values.tolist()} looks like radians; the file is in degrees.",
                "Multiply by 180 / pi.",
                key.table,
                key.key,
                family=WrongUnit,
            )


def _check_chain(file: TomlFile, joints: Sequence[_Joint]) -> None:
    """Refuse right angles in radians, and lengths in metres or micrometres."""
    angles = np.abs([(joint.alpha, joint.theta) for joint in joints])
    off = np.abs(angles - math.pi / 2 * np.round(angles / (math.pi / 2)))
    right = (off < ROUNDED) & (angles > 1.0)
    if right.any() and angles.max() <= 2 * math.pi + ROUNDED:
        raise file.error(
            f"the angles in [[joint]] look like radians ({angles[right][0]:g} is among them); the file is in degrees.",
            "Multiply alpha and theta by 180 / pi.",
            "joint",
            family=WrongUnit,
        )
    longest = max(max(abs(joint.a), abs(joint.d)) for joint in joints)
    slides = any(joint.kind == "prismatic" for joint in joints)
    what = "lengths in [[joint]]", f"{longest:g}"
    _check_length(file, longest, what, 0.0 if slides or not longest else SHORTEST_MACHINE, "joint")
