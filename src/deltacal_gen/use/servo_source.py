"""Feed-forward on a controller: one C99 file of a machine in motion, as it was identified.

Position, velocity and acceleration of the reference point go in, joints and torques come out. The geometry is that of
`deltacal_gen.use.exports`, the machine in motion is what ``derive/mathematics/loops.py`` derives, put into C as it
stands; friction near rest is ramped as in `deltacal_gen.motion.feedforward`.
"""

from __future__ import annotations

import importlib.resources
from collections.abc import Iterator, Sequence
from pathlib import Path

import numpy as np

from deltacal_gen.errors import UsageError
from deltacal_gen.files.robot import robot_of, robot_size
from deltacal_gen.files.writing import write_files
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.chain import Chain
from deltacal_gen.machine.dynamics import ChainDynamics, Dynamics, LimbDynamics, dynamics_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.feedforward import readouts_of_model
from deltacal_gen.motion.limits import limits_of
from deltacal_gen.physics.terms import load_effect
from deltacal_gen.results.motion import JointModel, MotionModel, TorqueTerm
from deltacal_gen.units import file_unit, joint_factors, joint_names
from deltacal_gen.use.compensation import Compensator
from deltacal_gen.use.exports import c_numbers, c_source, plain, wrapped

NO_LIMIT = 1e300  # of a torque, of a joint
POSED = 6  # joints of a chain that stands in any pose
FASTEST = 10.0  # times the speed that is assumed where the robot file says none: beyond it a set point has jumped
STATES = {  # what effects read, in the words of the file
    "q": "q",
    "turn": "q",
    "qd": "qd",
    "qdd": "qdd",
    "torque": "load",
    "temperature": "temp_C",
    "warming": "temp_C - 20.0",
}
CODES = (
    ("DELTACAL_NOT_A_NUMBER", 3, "an input is not a finite number"),
    ("DELTACAL_JUMP", 4, "since the last set point a joint would have moved faster than DELTACAL_MOST_SPEED"),
    ("DELTACAL_LIMITED", 5, "joints are as asked for; a torque is held at its limit"),
)
WORDS = "\n".join(f" *             {code} {words};" for _, code, words in CODES)
DEFINES = "\n".join(f"#define {name} {code}" for name, code, _ in CODES)

CHAIN = """/*
 * What the drives of {name}, an open chain, must give in motion, as identified.
 *
 * In          joints, speeds, accelerations as the controller counts them [{units}]; payload_kg at the tool point;
 *             temp_C. Or, of six joints, target: the tool point in {{O}} [mm] and the last frame's rotation vector
 *             [deg]; its velocity [mm/s, deg/s] and acceleration [mm/s^2, deg/s^2], turns about the axes of {{O}}
 * Out         held->joints [{units}] and held->torque [{read}], positive along positive joints of the controller
 * Returns     0 solved; 1 out of reach, or beyond the limits of [joints]; 2 singular;
{words}
 *             after 1 to 4 held keeps joints and torques of the last set point that was solved.
 * Near rest   inside DELTACAL_REST (rad/s, mm/s) what depends on a joint's speed goes straight from side to side.
 * Effort      of a target at most POSE_STEPS (40) steps of Newton's method, from held->joints on: set these before the
 *             first one, it says how the chain stands. No other loop depends on the input. No memory is allocated, and
 *             nothing is kept between calls but what is in held.
 * Usage       struct deltacal_motion held = {{ .period_s = 0.001 }};   (between two set points)
 *             status = deltacal_feedforward_joints(&held, q, qd, qdd, 0.0, 20.0);
 *             held.begun = 0 makes the next set point the first one, wherever it is: after a stop, say.
 * Build       C99 with the mathematics library; not with -ffast-math, which drops the tests of what is no number.
 */
#include <math.h>

#define DELTACAL_SOLVED 0
#define DELTACAL_UNREACHABLE 1
#define DELTACAL_SINGULAR 2
{codes}
#define DELTACAL_JOINTS {limbs}
#define DELTACAL_LINKS {links}
#define DELTACAL_DRIVES {drives}
#define DEGREE 0.017453292519943295

struct deltacal_motion {{
    double joints[DELTACAL_JOINTS], torque[DELTACAL_JOINTS];
    double period_s;
    int begun;
}};

int deltacal_feedforward_joints(struct deltacal_motion *held, const double joints[DELTACAL_JOINTS],
                                const double speeds[DELTACAL_JOINTS], const double accelerations[DELTACAL_JOINTS],
                                double payload_kg, double temp_C);
#if DELTACAL_JOINTS == 6
int deltacal_feedforward(struct deltacal_motion *held, const double target[6], const double velocity[6],
                         const double acceleration[6], double payload_kg, double temp_C);
#endif
"""

INTERFACE = """/*
 * In motion: joints and what the drives must give, by position, velocity and acceleration of the reference point.
 *
 * In          target_mm, velocity_mm_s, acceleration_mm_s2: {axes} in {{O}}; payload_kg at the reference point; temp_C
 * Out         held->joints_{unit} and held->torque [{read}], positive along positive joints of the controller
 * Returns     0 solved; 1 out of reach; 2 singular;
{words}
 *             after 1 to 4 held keeps joints and torques of the last set point that was solved.
 * Near rest   inside DELTACAL_REST (rad/s, mm/s) what depends on a joint's speed goes straight from side to side.
 * Effort      at most MAX_STEPS (30) + PLATFORM_STEPS (8) steps of Newton's method; no other loop depends on the input.
 *             No memory is allocated, and nothing is kept between calls but what is in held.
 * Usage       struct deltacal_motion held = {{ .period_s = 0.001 }};   (between two set points)
 *             status = deltacal_feedforward(&held, p, v, a, 0.0, 20.0);
 *             held.begun = 0 makes the next set point the first one, wherever it is: after a stop, say.
 */
{codes}

struct deltacal_motion {{
    double joints_{unit}[{limbs}], torque[{limbs}];
    double period_s;
    int begun;
}};

int deltacal_feedforward(struct deltacal_motion *held, const double target_mm[{asked}],
                         const double velocity_mm_s[{asked}], const double acceleration_mm_s2[{asked}],
                         double payload_kg, double temp_C);
"""


def export_feedforward(known: MotionModel, path: str | Path) -> None:
    """Write a model of a machine in motion as one C99 file; see the file's head.

    Raises
    ------
    UsageError
        A joint's torque is not known, or an effect needs what a controller does not have.
    """
    robot = robot_of(known.robot)
    own = dynamics_of(robot)
    models = {model.joint: model for model in known.joints}
    if still := [str(i + 1) for i in range(own.joints) if i + 1 not in models]:
        raise UsageError(f"joint {', '.join(still)} did not move in the recording: its torque is not known.")
    joints = [models[i + 1] for i in range(own.joints)]
    if known.known is not None and any(each.mass for each in known.known.payloads):
        raise UsageError(
            "payload_error belongs to a set-up, which a controller does not know: correct payload_kg in the recording, "
            "and diagnose again."
        )
    body = importlib.resources.files("deltacal_kernels").joinpath(robot.mechanism, "dynamics.c")
    machine = _limbs(known, robot, own) if isinstance(own, LimbDynamics) else _chain(known, robot, own)
    parts = [
        *machine,
        "\n".join(_tables(known, robot, own, joints)),
        *_effects(joints),
        "\n".join(_drive(joints)),
        body.read_text(encoding="utf-8"),
    ]
    write_files({Path(path): "\n".join(parts)})


def _limbs(known: MotionModel, robot: Robot, own: LimbDynamics) -> tuple[str, str, str]:
    """Return geometry, interface and numbers of a machine with limbs."""
    with using(Backend.NUMPY):  # a file holds the same digits wherever it is written from
        geometry = Compensator(robot)
        text = c_source(geometry, geometry.round_trip())
    numbers = [*_table("MOTION_K", own.constants[0][0]), *_table("BODY_K", own.constants[1][0])]
    numbers += [_line("SHARES", own.shares, "of a rod's mass at either end")]
    return text, _interface(known, robot), "\n".join(numbers)


def _chain(known: MotionModel, robot: Robot, own: Dynamics) -> tuple[str, str]:
    """Return interface and numbers of an open chain."""
    machine = mechanism_of(robot)
    assert isinstance(own, ChainDynamics)
    assert isinstance(machine, Chain)
    conventions, drives, much = machine.shape
    factors = np.array(joint_factors(machine.joint_unit, machine.limbs))
    ends = np.full((machine.limbs, 2), [-NO_LIMIT, NO_LIMIT])
    if robot.joint_limits is not None:
        ends = robot.joint_limits / factors[:, None]
    reach = robot_size(robot)
    head = CHAIN.format(
        name=plain(robot.name),
        units=", ".join(dict.fromkeys(file_unit(u) for u in machine.joint_units)),
        read=", ".join(readouts_of_model(known)[0]),
        words=WORDS,
        codes=DEFINES,
        links=len(conventions),
        drives=len(drives),
        limbs=machine.limbs,
    )
    numbers = [
        f"static const int DELTACAL_CONVENTION[] = {{ {', '.join(map(str, conventions))} }};",
        "static const int DELTACAL_DRIVE[][3] = { /* link, whether it slides, joint */",
        *(f"    {{ {', '.join(map(str, row))} }}," for row in drives.tolist()),
        "};",
        *_table("LINK_K", own.links),
    ]
    of_pose = (
        ("REACH", np.array([reach]), "mm"),
        ("TOOL", robot.tool, "mm, in the last frame"),
        ("REACHES", np.where(np.array(machine.joint_units) == "mm", reach, 1.0), "what counts as much of a joint"),
    )
    for name, values, words in (
        *(of_pose if machine.limbs == POSED else ()),
        ("MUCH", much, "of a joint in its link"),
        ("SIGN", robot.joint_sign, "of the controller"),
        ("FACTOR", factors, "rad, mm per unit of a joint"),
        ("JOINT_LOW", ends[:, 0], "[joints] of the robot file"),
        ("JOINT_HIGH", ends[:, 1], "the same"),
    ):
        numbers.append(_line(name, values, words))
    return head, "\n".join(numbers)


def _interface(known: MotionModel, robot: Robot) -> str:
    """Return what a controller sees: codes, what is held between calls, the function."""
    machine = mechanism_of(robot)
    return INTERFACE.format(
        unit=file_unit(machine.joint_unit),
        limbs=machine.limbs,
        asked=len(machine.asks),
        axes=", ".join(machine.axes),
        read=", ".join(readouts_of_model(known)[0]),
        words=WORDS,
        codes=DEFINES,
    )


def _tables(known: MotionModel, robot: Robot, own: Dynamics, joints: Sequence[JointModel]) -> Iterator[str]:
    """Yield the numbers that every machine in motion has."""
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
    speeds = joint_names(machine.joint_unit, n, "qd{i}_{unit}_s")
    said = np.array([name in robot.limits for name in speeds])
    most = limits_of(robot)[0][2] / factors * np.where(said, 1.0, FASTEST)
    ends = np.array([robot.limits.get(column, (-NO_LIMIT, NO_LIMIT)) for column in known.columns])
    rotors = np.zeros(n)
    for k, j in enumerate(own.rotors):  # of another joint's drive no torque depends
        rotors[j] = inertia[j, len(own.names) - len(own.rotors) + k] / 1000.0
    yield from _table("INERTIA", inertia[:, : inertia.shape[1] - len(own.rotors)])
    for name, values, words in (
        ("ROTOR", rotors, "of the drives: N mm per rad/s^2, N per mm/s^2"),
        ("PAYLOAD", payload[: len(payload) - len(own.rotors)], "1 kg at the reference point"),
        ("GRAVITY", own.gravity, "m/s^2, in {O}"),
        ("PAYLOAD_LOADS", np.array(of_known), "reading inside per torque of the payload"),
        ("READ", np.array([read.inside for read in readouts]), "units inside per unit of a reading"),
        ("REST", np.array([model.at_rest_below for model in joints]), "rad/s or mm/s"),
        ("MOST_SPEED", most, "joints per second: faster, a set point has jumped"),
        ("TORQUE_LOW", ends[:, 0], ", ".join(units)),
        ("TORQUE_HIGH", ends[:, 1], ", ".join(units)),
    ):
        yield _line(name, values, words)
    yield ""


def _line(name: str, values: np.ndarray, words: str) -> str:
    return f"static const double DELTACAL_{name}[{len(values)}] = {{ {c_numbers(values)} }}; /* {words} */"


def _table(name: str, values: np.ndarray) -> Iterator[str]:
    yield f"static const double DELTACAL_{name}[{values.shape[0]}][{values.shape[1]}] = {{"
    for row in values:
        yield f"    {{ {wrapped(row)} }},"
    yield "};"


def _effects(joints: Sequence[JointModel]) -> list[str]:
    """Return the C sources of the effects, each once."""
    names = dict.fromkeys(term.effect for model in joints for term in model.terms)
    folder = importlib.resources.files("deltacal_kernels").joinpath("effects")
    for name in names:
        lacking = [s for s in load_effect(name).STATE if s not in STATES]
        if lacking or not folder.joinpath(f"{name}.c").is_file():
            what = f"'{lacking[0]}'" if lacking else "its past"
            raise UsageError(f"{name} depends on {what}, which a controller does not have: it cannot be exported.")
    return [folder.joinpath(f"{name}.c").read_text(encoding="utf-8") for name in names]


def _drive(joints: Sequence[JointModel]) -> Iterator[str]:
    """Yield the functions of what a drive has beside the rigid machine."""
    yield "/* What a drive gives beside its load, in units inside. */"
    yield "static double beside(int joint, double q, double qd, double qdd, double load, double temp_C)"
    yield "{"
    yield "    double total = 0.0;"
    yield "    (void)joint, (void)q, (void)qd, (void)qdd, (void)load, (void)temp_C;"
    for model in joints:
        if model.terms:
            yield f"    if (joint == {model.joint - 1}) {{"
            for term in model.terms:
                yield from _term(term)
            yield "    }"
    yield "    return total;"
    yield "}"
    yield ""
    yield "/* What a drive gives, friction ramped near rest. */"
    yield "static double deltacal_drive(int joint, double q, double qd, double qdd, double load, double temp_C)"
    yield "{"
    yield "    const double edge = DELTACAL_REST[joint];"
    yield "    load += DELTACAL_ROTOR[joint] * qdd;"
    yield "    if (!(fabs(qd) < edge))"
    yield "        return load + beside(joint, q, qd, qdd, load, temp_C);"
    yield "    return load + (0.5 - 0.5 * qd / edge) * beside(joint, q, -edge, qdd, load, temp_C)"
    yield "           + (0.5 + 0.5 * qd / edge) * beside(joint, q, edge, qdd, load, temp_C);"
    yield "}"
    yield ""


def _term(term: TorqueTerm) -> Iterator[str]:
    states = ", ".join(STATES[name] for name in load_effect(term.effect).STATE) or "0.0"
    yield "        {"
    yield f"            const double s[] = {{ {states} }};"
    yield f"            static const double c[] = {{ {c_numbers(np.array(term.values))} }};"
    yield f"            static const double constants[] = {{ {c_numbers(np.array(term.constants or (0.0,)))} }};"
    yield f"            total += {term.effect}(s, c, constants);"
    yield "        }"
