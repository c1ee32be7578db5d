"""Feed-forward on a controller: one C99 file of a machine in motion, as it was identified.

Position, velocity and acceleration of the reference point go in, joints and torques come out. The geometry is that of
`deltacal_gen.use.exporters.c`, the machine in motion is what ``derive/mathematics/loops.py`` derives, put into C as it
stands; friction near rest is ramped as in `deltacal_gen.motion.feedforward`.
"""

from __future__ import annotations

import importlib.resources
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from deltacal_gen.errors import NotForThisMachine
from deltacal_gen.files.robot import robot_of, robot_size
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.dynamics import Dynamics, dynamics_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.feedforward import readouts_of_model
from deltacal_gen.motion.limits import limits_of
from deltacal_gen.physics.law import is_law
from deltacal_gen.physics.terms import load_effect
from deltacal_gen.results.motion import JointModel, MotionModel
from deltacal_gen.states import SPEEDS, read_by
from deltacal_gen.units import file_unit, joint_factors, joint_names
from deltacal_gen.use.command_source import command_source
from deltacal_gen.use.compensation import Compensator
from deltacal_gen.use.layout import laid_out, plain

NO_LIMIT = 1e300  # of a torque, of a joint
POSED = 6  # joints of a chain that stands in any pose
FASTEST = 10.0  # times the speed that is assumed where the robot file says none: beyond it a set point has jumped
MOTION = ("target", "velocity", "acceleration")
CODES = (
    ("DELTACAL_NOT_A_NUMBER", 3, "an input is not a finite number"),
    ("DELTACAL_JUMP", 4, "since the last set point a joint would have moved faster than DELTACAL_MOST_SPEED"),
    ("DELTACAL_LIMITED", 5, "joints are as asked for; a torque is held at its limit"),
)


def servo_source(known: MotionModel) -> str:
    """Return the text of the C99 file of a machine in motion; see its head.

    Raises
    ------
    UsageError
        A joint's torque is not known, or an effect needs what a controller does not have.
    """
    robot = robot_of(known.robot)
    own = dynamics_of(robot)
    models = {model.joint: model for model in known.joints}
    if still := [str(i + 1) for i in range(own.joints) if i + 1 not in models]:
        raise NotForThisMachine(f"joint {', '.join(still)} did not move in the recording: its torque is not known.")
    joints = [models[i + 1] for i in range(own.joints)]
    if known.known is not None and any(each.mass for each in known.known.payloads):
        raise NotForThisMachine(
            "payload_error belongs to a set-up, which a controller does not know: correct payload_kg in the recording, "
            "and diagnose again."
        )
    kernels, written_out = importlib.resources.files("deltacal_kernels"), mechanism_of(robot).written_out
    terms = _terms(joints)
    return laid_out(
        "feedforward.c",
        kind="limbs" if written_out else "chain",
        codes=CODES,
        read=", ".join(readouts_of_model(known)[0]),
        limbs=mechanism_of(robot).limbs,
        past=sum(t.memories + t.read for _, of_joint in terms for t in of_joint if t.memories),
        own=own.numbers,
        **(_limbs(robot) if written_out else _chain(robot, own)),
        **_tables(known, robot, own, joints),
        sources=[kernels.joinpath("effects", f"{n}.c").read_text(encoding="utf-8") for n in _effects(joints)],
        joints=[(joint, of_joint) for joint, of_joint in terms if of_joint],
        dynamics=kernels.joinpath(robot.mechanism, "dynamics.c").read_text(encoding="utf-8").rstrip("\n"),
    )


def _limbs(robot: Robot) -> dict[str, Any]:
    """Return geometry and interface of a machine with limbs."""
    machine = mechanism_of(robot)
    with using(Backend.NUMPY):  # a file holds the same digits wherever it is written from
        geometry = Compensator(robot)
        command = command_source(geometry, geometry.round_trip())
    units, axes = ("_mm", "_mm_s", "_mm_s2"), ", ".join(machine.axes)
    if machine.turning:
        units, turns = ("", "", ""), ", ".join(f"r{name[1]}" for name in machine.asks if name[0] == "c")
        axes = f"{axes} [mm, mm/s, mm/s^2] and {turns} [deg, deg/s, deg/s^2]: rotation vector, turns about the axes"
    asked = {name: name + unit for name, unit in zip(MOTION, units, strict=True)}
    return asked | {"command": command, "axes": axes, "unit": file_unit(machine.joint_unit), "asked": len(machine.asks)}


def _chain(robot: Robot, own: Dynamics) -> dict[str, Any]:
    """Return interface and numbers of an open chain."""
    machine, reach = mechanism_of(robot), robot_size(robot)
    factors = np.array(joint_factors(machine.joint_unit, machine.limbs))
    ends = np.full((machine.limbs, 2), [-NO_LIMIT, NO_LIMIT])
    if robot.joint_limits is not None:
        ends = robot.joint_limits / factors[:, None]
    of_pose = (
        ("REACH", np.array([reach]), "mm"),
        ("TOOL", robot.tool, "mm, in the last frame"),
        ("REACHES", np.where(np.array(machine.joint_units) == "mm", reach, 1.0), "what counts as much of a joint"),
    )
    return {
        "name": plain(robot.name),
        "unit": ", ".join(dict.fromkeys(file_unit(u) for u in machine.joint_units)),
        "of_chain": (
            *(of_pose if machine.limbs == POSED else ()),
            ("MUCH", own.numbers["MUCH"], "of a joint in its link"),
            ("SIGN", robot.joint_sign, "of the controller"),
            ("FACTOR", factors, "rad, mm per unit of a joint"),
            ("JOINT_LOW", ends[:, 0], "[joints] of the robot file"),
            ("JOINT_HIGH", ends[:, 1], "the same"),
        ),
    }


def _tables(known: MotionModel, robot: Robot, own: Dynamics, joints: Sequence[JointModel]) -> dict[str, Any]:
    """Return the numbers that every machine in motion has."""
    machine = mechanism_of(robot)
    n, payload = own.joints, own.of_payload()
    inertia = np.zeros((n, len(payload)))
    units, readouts = readouts_of_model(known)
    of_known = [1.0 if read.forces else model.payload or 0.0 for model, read in zip(joints, readouts, strict=True)]
    for row, model, much in zip(inertia, joints, of_known, strict=True):
        row[list(model.columns)] = model.coefficients
        if known.known is not None:
            row[: len(own.names)] += much * np.array(known.known.inertial)
    factors = np.array(joint_factors(machine.joint_unit, n))
    speeds = joint_names(machine.joint_unit, n, SPEEDS)
    said = np.array([name in robot.limits for name in speeds])
    most = limits_of(robot)[0][2] / factors * np.where(said, 1.0, FASTEST)
    ends = np.array([robot.limits.get(column, (-NO_LIMIT, NO_LIMIT)) for column in known.columns])
    rotors = np.zeros(n)
    for k, j in enumerate(own.rotors):  # of another joint's drive no torque depends
        rotors[j] = inertia[j, len(own.names) - len(own.rotors) + k] / 1000.0
    tables = (
        ("ROTOR", rotors, "of the drives: N mm per rad/s^2, N per mm/s^2"),
        ("PAYLOAD", payload[: len(payload) - len(own.rotors)], "1 kg at the reference point"),
        ("GRAVITY", own.gravity, "m/s^2, in {O}"),
        ("PAYLOAD_LOADS", np.array(of_known), "reading inside per torque of the payload"),
        ("READ", np.array([read.inside for read in readouts]), "units inside per unit of a reading"),
        ("REST", np.array([model.at_rest_below for model in joints]), "rad/s or mm/s"),
        ("MOST_SPEED", most, "joints per second: faster, a set point has jumped"),
        ("TORQUE_LOW", ends[:, 0], ", ".join(units)),
        ("TORQUE_HIGH", ends[:, 1], ", ".join(units)),
    )
    return {"inertia": inertia[:, : inertia.shape[1] - len(own.rotors)], "tables": tables}


def _effects(joints: Sequence[JointModel]) -> list[str]:
    """Return the names of the effects, each once, that a controller can follow."""
    names = list(dict.fromkeys(term.effect for model in joints for term in model.terms))
    for name in names:
        if is_law(name):
            raise NotForThisMachine(
                f"C is made of derived effects, and '{name}' is a law. Write it down (deltacal diagnose "
                "--write-effect), derive it (deltacal kernels), and diagnose again."
            )
        if lacking := [s.name for s in read_by(load_effect(name)) if s.joint or not s.c99_drive]:
            raise NotForThisMachine(
                f"{name} depends on '{lacking[0]}', which a controller does not have: it cannot be exported."
            )
    return names


class _Term(NamedTuple):
    """An effect of a joint's drive in C.

    Its states as C writes them; its past stands from `begin` on: what it remembers, and the states that it read last.
    """

    effect: str
    states: list[str]
    values: tuple[float, ...]
    constants: tuple[float, ...]
    begin: int
    memories: int
    read: int


def _terms(joints: Sequence[JointModel]) -> list[tuple[int, list[_Term]]]:
    """Return the terms of each joint (from 0)."""
    begin, every = 0, []
    for model in joints:
        own: list[_Term] = []
        for term in model.terms:
            kernels = load_effect(term.effect)
            memories, read = len(getattr(kernels, "MEMORY", ())), len(kernels.STATE)
            past = (f"past[{begin + n}]" for n in range(memories))
            states = [*(s.c99_drive for s in read_by(kernels)), *past]
            own.append(_Term(term.effect, states, term.values, term.constants or (0.0,), begin, memories, read))
            begin += memories and memories + read
        every.append((model.joint - 1, own))
    return every
