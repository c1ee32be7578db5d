"""What an effect may read: every state, with all that the program knows of it, in one table.

A *state* is a number that the machine or its recording has at a pose: a joint, a channel, a load, a length of the
drawing, where the measured point is, what the instrument reads. Nothing else in the program says what a state is: the
table is emitted as ``deltacal_kernels/effects/states.py`` and read there by everything that asks for a column, a unit,
an assumption, what can be, what can be set, a word for it, or how a controller writes it.

An effect of a limb reads the states of its own limb. Another joint's carries its number (``torque_2``), and any column
of a recording that has no name here is a *covariate*, read by the name of its column.
"""

from __future__ import annotations

import difflib
import keyword
import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields, replace
from typing import Any

import sympy as sp

DEG = math.pi / 180
PER = ("joint", "limb", "machine", "reading")
KINDS = ("joint", "channel", "load", "geometry", "place", "reading", "chosen")
OTHER = re.compile(r"(\w+)_([1-9]\d*)")  # another joint's state
TAKEN = re.compile(r"s\d*|c|constants|out|np|math")  # names that generated functions have for their own


@dataclass(frozen=True)
class State:
    """A state, as a row of the table.

    Parameters
    ----------
    symbol : sympy.Symbol
        As it stands in the equations of effects; its name is the state's.
    unit : str
        In files; of a joint that slides read mm for deg.
    factor : float
        From the unit in files to the one inside (mm, rad, N, s, K); of a joint that slides 1.
    meaning : str
        One line.
    per : {"joint", "limb", "machine", "reading"}
        What has one. Only a joint's can be read by another limb.
    kind : {"joint", "channel", "load", "geometry", "place", "reading", "chosen"}
        Where it comes from: the joints themselves, a recorded column, virtual work at the pose, the drawing, the pose,
        the reading before effects act on it, or the state that a constant of the effect chooses. Loads and what is of
        the pose change with the deformation.
    column : str
        Recorded column that it is read from, per joint with ``{i}`` for its number and ``{unit}`` for deg or mm.
    parts : str
        Columns whose mean the column is, where a recording has these instead, with ``{part}`` for the name of a part.
    zero : float
        What the column holds where the state is zero.
    default : float
        What the column is taken to hold where a command does not give it, and `assumed` says so in words. A state
        without such words must be given.
    optional : bool
        Whether a recording without the column holds none of it.
    whole : bool
        Whether the column is given in every row or in none.
    made_of : tuple of str
        Channels that it is computed from.
    shown : str
        Where a misfit by it shows: a column, a joint's among them, or ``position``.
    differing : str
        What a recording must hold for it to show: the column that shows it must vary.
    by : str
        The constant of the effect that decides it: the moment with which the column is compared, the number of the
        joint, the name of the column.
    requires : str
        What the robot file must hold for it.
    c99 : str
        How C writes it for the joint ``{i}``, counted from 0, where a controller knows it before the machine moves;
        ``{sign}`` turns what the controller counts into what the geometry does, ``{turned}`` a joint into its pulley.
    c99_drive : str
        How C writes it for a drive, whose function has the motion of its own joint.
    tabled : (str, float), optional
        Exported corrections may go with it: the unit there, and how many of `unit` it is.
    called : str
        What it is called beside its unit, where answers and pages show its column, with ``{i}`` for the joint's number.
    its : str
        What it is called after "depends on", where a joint of a machine in motion is spoken of.
    levels : tuple of float
        All that the column can hold, where that is a few values.
    possible : (float or None, float or None), optional
        Between which values the column must lie.
    expected : str
        What is said of a value that cannot be.
    weighs : bool
        Whether it is a mass that the machine carries, of which it can carry so much.
    commanded : bool
        Whether whoever measures sets it; other channels come as they come.
    passes : bool
        Whether it goes on by itself and never comes again: what is measured next has more of it.
    rests : bool
        Whether a machine at rest has none of it.
    step : float
        By how much the column may well be made to differ, where it does not.
    law : int
        When laws of readings look at it, the first at 1; 0: never.
    others : bool
        Whether these look at those of other joints too.
    drive_law : int
        When laws of what drives give look at it, the first at 1; 0: never.
    varied : str
        What must be varied in motion for effects on drives that read it to be told apart.
    needed : str
        What a motion must hold for effects on drives that read it to be looked at.
    along : str
        Of a load: the deflection along which weights exert it; without one every machine that weighs has it.
    rods : bool
        Whether limbs that close loops alone have it.
    """

    symbol: sp.Symbol
    unit: str
    factor: float
    meaning: str
    per: str
    kind: str
    column: str = ""
    parts: str = ""
    zero: float = 0.0
    default: float = 0.0
    assumed: str = ""
    optional: bool = False
    whole: bool = False
    made_of: tuple[str, ...] = ()
    shown: str = ""
    differing: str = ""
    by: str = ""
    requires: str = ""
    c99: str = ""
    c99_drive: str = ""
    tabled: tuple[str, float] | None = None
    called: str = ""
    its: str = ""
    levels: tuple[float, ...] = ()
    possible: tuple[float | None, float | None] | None = None
    expected: str = ""
    weighs: bool = False
    commanded: bool = False
    passes: bool = False
    rests: bool = False
    step: float = 0.0
    law: int = 0
    others: bool = False
    drive_law: int = 0
    varied: str = ""
    needed: str = ""
    along: str = ""
    rods: bool = False

    def __post_init__(self) -> None:
        if self.per not in PER or self.kind not in KINDS:
            raise ValueError(f"state {self.symbol}: {self.per}, {self.kind} are none of {PER}, {KINDS}.")
        if not self.meaning:
            raise ValueError(f"state {self.symbol} has no meaning; add one line.")
        if self.kind == "channel" and not self.column:
            raise ValueError(f"state {self.symbol} is a channel and names no column.")

    @property
    def name(self) -> str:
        """Name by which kernels and reports know it."""
        return str(self.symbol)

    @property
    def row(self) -> dict[str, Any]:
        """What there is to say of it, as plain data."""
        every = {f.name: getattr(self, f.name) for f in fields(self) if f.name != "symbol"}
        return {name: value for name, value in every.items() if value or name == "factor"}


class Covariate(sp.Symbol):
    """A recorded column that is no state, in an equation."""


JOINT, SPEED, ACCELERATION = "q{i}_{unit}", "qd{i}_{unit}_s", "qdd{i}_{unit}_s2"
POSITION = "position"  # where a misfit shows that no column does, but the place in the workspace
AT_REST = "a machine at rest is assumed"
ROOM = 20.0  # degC: what is taken where nobody recorded a temperature, and where a machine is not warmer
_ANGLES = "angles, over the whole range"
_TEMPERATURE: dict[str, Any] = {
    "parts": "temp_{part}_C",
    "default": ROOM,
    "assumed": f"{ROOM:g} degC is assumed",
    "differing": "temperatures that differ",
    "possible": (-100.0, 300.0),
    "expected": "-100 to 300 degC were expected",
    "step": 10.0,
}


def _joint(name: str, unit: str, meaning: str, **known: Any) -> State:
    return State(sp.Symbol(name, real=True), unit, DEG, meaning, "joint", **{"kind": "joint", "shown": JOINT} | known)


def _channel(name: str, unit: str, meaning: str, column: str, **known: Any) -> State:
    per = "joint" if "{i}" in column else "machine"
    factor = DEG if "{unit}" in column else 1.0
    return State(sp.Symbol(name, real=True), unit, factor, meaning, per, "channel", column, **{"shown": column} | known)


def _load(name: str, unit: str, meaning: str, shown: str, per: str = "joint", **known: Any) -> State:
    own = {"made_of": ("payload",), "requires": "[masses] in the robot file"} | known
    return State(sp.Symbol(name, real=True), unit, 1.0, meaning, per, "load", shown=shown, **own)


def _length(name: str, meaning: str, per: str, kind: str, shown: str = "", **known: Any) -> State:
    return State(sp.Symbol(name, real=True), "mm", 1.0, meaning, per, kind, shown=shown, **known)


_ROWS = (
    _joint(
        "q",
        "deg",
        "joint as the controller reports it",
        column=JOINT,
        c99="q[{i}]",
        c99_drive="q",
        called="joint {i}",
        its="its position",
        law=1,
        others=True,
        drive_law=1,
        varied=_ANGLES,
    ),
    _joint("theta", "deg", "joint as the geometry sees it", kind="place"),
    _joint(
        "turn",
        "deg",
        "turn of the joint; of its pulley, where it slides",
        requires="pulley_circumference in [transmission]",
        c99="q[{i}] * {turned}",
        c99_drive="q",
        varied=_ANGLES,
        needed="joints that pass two periods",
    ),
    _channel(
        "qd",
        "deg/s",
        "joint velocity",
        SPEED,
        assumed=AT_REST,
        differing="motion in the columns qd",
        c99_drive="qd",
        called="speed of joint {i}",
        its="its speed",
        commanded=True,
        rests=True,
        law=4,
        others=True,
        drive_law=2,
        varied="speeds, from creeping to the fastest",
    ),
    _channel(
        "qdd",
        "deg/s^2",
        "joint acceleration",
        ACCELERATION,
        assumed=AT_REST,
        differing="motion in the columns qdd",
        c99_drive="qdd",
        called="acceleration of joint {i}",
        its="its acceleration",
        commanded=True,
        rests=True,
        law=5,
        drive_law=3,
        varied="accelerations",
    ),
    _channel(
        "approach",
        "1",
        "direction in which the joint last moved, +1 or -1",
        "approach{i}",
        assumed="the middle of the play is assumed, half of it is left either way",
        differing="both directions of approach",
        c99="{sign}at->approach[{i}]",
        tabled=("", 1.0),
        called="direction in which joint {i} last moved",
        levels=(-1.0, 1.0),
        expected="1 or -1 was expected",
        commanded=True,
        law=3,
        others=True,
    ),
    _joint("q_other", "deg", "another joint as the controller reports it, that of the number", kind="chosen", by="of"),
    State(
        sp.Symbol("recorded", real=True),
        "as recorded",
        1.0,
        "a recorded column that is no other state, that of the name",
        "machine",
        "chosen",
        by="of",
    ),
    State(
        sp.Symbol("passed", real=True),
        "s",
        1.0,
        "time, or where none was logged a recorded column that counts on, that of the name",
        "machine",
        "chosen",
        by="per",
    ),
    _channel(
        "temperature",
        "degC",
        "temperature",
        "temp_C",
        **_TEMPERATURE,
        c99="at->temp_C",
        c99_drive="temp_C",
        called="temperature",
        its="the temperature",
        drive_law=5,
    ),
    _channel(
        "warming",
        "K",
        f"temperature less {ROOM:g} degC",
        "temp_C",
        **_TEMPERATURE,
        zero=ROOM,
        c99=f"at->temp_C - {ROOM}",
        c99_drive=f"temp_C - {ROOM}",
        tabled=(f"K over {ROOM:g} degC", 1.0),
        law=10,
        varied="temperatures",
        needed="temperatures that differ in a column temp_C",
    ),
    _channel(
        "payload",
        "kg",
        "mass at the measured point",
        "payload_kg",
        optional=True,
        assumed="no payload is assumed",
        differing="payloads that differ in the column payload_kg",
        c99="at->payload_kg",
        tabled=("kg", 1.0),
        called="payload",
        possible=(0.0, None),
        expected="a mass cannot be negative",
        weighs=True,
        commanded=True,
        law=11,
    ),
    _channel(
        "time",
        "s",
        "time",
        "time_s",
        whole=True,
        assumed="the start of the recording is assumed, before any drift",
        differing="times that differ",
        c99="at->time_s",
        tabled=("h", 3600.0),
        called="time",
        its="the time",
        passes=True,
        law=12,
    ),
    _channel(
        "after",
        "1",
        "1 from a moment on, 0 before; the moment is a row, where there is no time",
        "time_s",
        whole=True,
        by="when",
        assumed="a time after the jump is assumed",
        c99="1.0",
    ),
    _load(
        "torque",
        "N mm",
        "static torque of all weights on the joint",
        JOINT,
        c99_drive="load",
        its="the torque that the rigid machine asks of it",
        law=2,
        others=True,
        drive_law=4,
        varied="loads, with and without a payload",
    ),
    _load("payload_torque", "N mm", "static torque of the payload on the joint", "payload_kg"),
    _load(
        "inertia_torque",
        "N mm",
        "torque of the masses times minus their acceleration",
        ACCELERATION,
        made_of=("qdd", "payload"),
    ),
    _load(
        "pull_v",
        "N",
        "rods' pull on the arm's tip, normal to the arm in its plane",
        JOINT,
        "limb",
        along="tip_v",
        law=8,
    ),
    _load("pull_w", "N", "rods' pull on the arm's tip, along the joint's axis", JOINT, "limb", along="tip_w", law=9),
    _load("tension_1", "N", "tension of rod 1", JOINT, "limb", rods=True, law=6),
    _load("tension_2", "N", "tension of rod 2", JOINT, "limb", rods=True, law=7),
    *(
        _load(
            f"on_{part}",
            unit,
            f"what weights exert along {part}, by virtual work: {words}",
            JOINT,
            "limb",
            along=part,
        )
        for part, unit, words in (
            ("side_x", "N", "force across the joint's axis, along x of the frame it turns in"),
            ("side_y", "N", "force across the joint's axis, along y of that frame"),
            ("tilt_x", "N mm", "moment across the joint's axis, about x of that frame"),
            ("tilt_y", "N mm", "moment across the joint's axis, about y of that frame"),
            ("bend_v", "N", "force at a link's end across its line and its joint's axis"),
            ("bend_w", "N", "force at a link's end across its line, along the joint's axis as far as that lies across"),
            ("twist", "N mm", "moment at a link's end about its line"),
        )
    ),
    _load("moment_x", "N mm", "moment of all moving weight about {O}, x", POSITION, "machine"),
    _load("moment_y", "N mm", "moment of all moving weight about {O}, y", POSITION, "machine"),
    _length("L", "length of the arm", "limb", "geometry"),
    _length("l", "length of the rods", "limb", "geometry"),
    _length("b", "radius of the base", "limb", "geometry"),
    _length("foot", "where the way of a joint that slides begins on its axis; 0 of one that turns", "limb", "geometry"),
    State(
        sp.Symbol("slides", real=True), "1", 1.0, "1 of a joint that slides, 0 of one that turns", "limb", "geometry"
    ),
    _length("x", "measured point, x in {O}", "machine", "place", POSITION, law=13),
    _length("y", "measured point, y in {O}", "machine", "place", POSITION, law=14),
    _length("z", "measured point, z in {O}", "machine", "place", POSITION, law=15),
    _length("radius", "measured point, its distance from the z axis of {O}", "machine", "place", POSITION, law=16),
    _length("y_x", "reading along the instrument's x", "reading", "reading"),
    _length("y_y", "reading along the instrument's y", "reading", "reading"),
    _length("y_z", "reading along the instrument's z", "reading", "reading"),
    _length("y_length", "reading of a length", "reading", "reading"),
)
STATES: Mapping[str, State] = {row.name: row for row in _ROWS}
COVARIATE = _channel(
    "covariate",
    "as recorded",
    "as the column {column} holds it",
    "{column}",
    differing="values that differ in the column {column}",
    c99="at->{column}",
    tabled=("as recorded", 1.0),
)


def state(names: str) -> tuple[sp.Symbol, ...]:
    """Return symbols of states by name, ``"torque warming torque_2"``.

    Raises
    ------
    ValueError
        There is no such state.
    """
    return tuple(named(name).symbol for name in names.split())


def covariate(column: str) -> sp.Symbol:
    """Return the symbol of a recorded column that is no state.

    Raises
    ------
    ValueError
        The column has a state, or a name that no equation can hold.
    """
    if own := [s.name for s in STATES.values() if column == s.column]:
        raise ValueError(f"the column {column} is the state {own[0]}: write state('{own[0]}').")
    if _known(column) is not None:
        raise ValueError(f"{column} is the name of a state: write state('{column}').")
    if not column.isidentifier() or keyword.iskeyword(column) or TAKEN.fullmatch(column):
        raise ValueError(f"a column '{column}' cannot stand in an equation: rename it to letters, digits and _.")
    return Covariate(column, real=True)


def named(name: str) -> State:
    """Return the row of a state by name; another joint's is that joint's own one.

    Raises
    ------
    ValueError
        There is no such state.
    """
    found = _known(name)
    if found is None:
        near = difflib.get_close_matches(name, STATES, 1)
        hint = f" Did you mean {near[0]}?" if near else f" There are {', '.join(STATES)}."
        raise ValueError(f"there is no state '{name}'.{hint} A recorded column is read by covariate('{name}').")
    return found


def _known(name: str) -> State | None:
    if name in STATES:
        return STATES[name]
    other = OTHER.fullmatch(name)
    own = STATES.get(other[1]) if other else None
    if other is None or own is None or own.per != "joint":
        return None
    return replace(own, symbol=sp.Symbol(name, real=True), meaning=f"of joint {other[2]}: {own.meaning}")


def read_by(expressions: Iterable[sp.Expr], besides: Iterable[sp.Symbol]) -> list[State]:
    """Return the states that expressions read, in the order of the table, covariates last.

    Raises
    ------
    ValueError
        A symbol is neither a state nor one of those `besides`.
    """
    symbols = set().union(*(e.free_symbols for e in expressions)) - set(besides)
    own = [s for s in symbols if not isinstance(s, Covariate)]
    order = {name: n for n, name in enumerate(STATES)}

    def place(name: str) -> tuple[int, int]:
        base, _, number = name.rpartition("_")
        return (order[name], 0) if name in order else (order[base], int(number))

    rows = [named(str(s)) for s in own]
    rows.sort(key=lambda row: place(row.name))
    return rows + [_recorded(s) for s in sorted(symbols - set(own), key=str)]


def _recorded(symbol: sp.Symbol) -> State:
    own: dict[str, Any] = {
        f: v.replace("{column}", str(symbol)) for f, v in COVARIATE.row.items() if isinstance(v, str)
    }
    return replace(COVARIATE, symbol=symbol, **own)
