"""Feed-forward on a controller: one C99 file of a machine in motion, as it was identified.

Position, velocity and acceleration of the reference point go in, joints and torques come out. The geometry is that of
`deltacal_gen.use.exporters.c`, the machine in motion is what ``derive/mathematics/loops.py`` derives, put into C as it
stands; friction near rest is ramped as in `deltacal_gen.motion.feedforward`.
"""

from __future__ import annotations

import importlib.resources
from collections.abc import Iterator, Sequence

import numpy as np

from deltacal_gen.errors import UsageError
from deltacal_gen.files.robot import robot_of, robot_size
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.dynamics import Dynamics, dynamics_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.feedforward import readouts_of_model
from deltacal_gen.motion.limits import limits_of
from deltacal_gen.physics.law import is_law
from deltacal_gen.physics.terms import load_effect
from deltacal_gen.results.motion import JointModel, MotionModel, TorqueTerm
from deltacal_gen.states import SPEEDS, read_by
from deltacal_gen.units import file_unit, joint_factors, joint_names
from deltacal_gen.use.command_source import BUILD, c_numbers, c_source, plain, wrapped
from deltacal_gen.use.compensation import Compensator

NO_LIMIT = 1e300  # of a torque, of a joint
POSED = 6  # joints of a chain that stands in any pose
FASTEST = 10.0  # times the speed that is assumed where the robot file says none: beyond it a set point has jumped
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
 * The past    of friction that builds up over a way is followed from set point to set point, period_s apart.
 * Effort      of a target at most POSE_STEPS (40) steps of Newton's method, from held->joints on: set these before the
 *             first one, it says how the chain stands. No other loop depends on the input. No memory is allocated, and
 *             nothing is kept between calls but what is in held.
 * Usage       struct deltacal_motion held = {{ .period_s = 0.001 }};   (between two set points)
 *             status = deltacal_feedforward_joints(&held, q, qd, qdd, 0.0, 20.0);
 *             held.begun = 0 makes the next set point the first one, wherever it is: after a stop, say.
 * Build       C99 with the mathematics library, double of 64 bits; not with -ffast-math, which drops the tests of what
 *             is no number. Declare it elsewhere as it is declared here, in C++ as extern "C".
 */
{build}#include <math.h>

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
    int begun;{past}
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
 * In          {target}, {velocity}, {acceleration}: {axes} in {{O}};
 *             payload_kg at the reference point; temp_C
 * Out         held->joints_{unit} and held->torque [{read}], positive along positive joints of the controller
 * Returns     0 solved; 1 out of reach; 2 singular;
{words}
 *             after 1 to 4 held keeps joints and torques of the last set point that was solved.
 * Near rest   inside DELTACAL_REST (rad/s, mm/s) what depends on a joint's speed goes straight from side to side.
 * The past    of friction that builds up over a way is followed from set point to set point, period_s apart.
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
    int begun;{past}
}};

int deltacal_feedforward(struct deltacal_motion *held, const double {target}[{asked}],
                         const double {velocity}[{asked}], const double {acceleration}[{asked}],
                         double payload_kg, double temp_C);
"""


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
        raise UsageError(f"joint {', '.join(still)} did not move in the recording: its torque is not known.")
    joints = [models[i + 1] for i in range(own.joints)]
    if known.known is not None and any(each.mass for each in known.known.payloads):
        raise UsageError(
            "payload_error belongs to a set-up, which a controller does not know: correct payload_kg in the recording, "
            "and diagnose again."
        )
    body = importlib.resources.files("deltacal_kernels").joinpath(robot.mechanism, "dynamics.c")
    past = _past(joints)
    head = _limbs if mechanism_of(robot).written_out else _chain
    parts = [
        *head(known, robot, own, past),
        "\n".join(_tables(known, robot, own, joints)),
        *_effects(joints),
        "\n".join(_remembering(joints, past)),
        "\n".join(_drive(joints)),
        body.read_text(encoding="utf-8"),
    ]
    return "\n".join(parts)


def _limbs(known: MotionModel, robot: Robot, own: Dynamics, past: int) -> tuple[str, ...]:
    """Return geometry, interface and numbers of a machine with limbs."""
    with using(Backend.NUMPY):  # a file holds the same digits wherever it is written from
        geometry = Compensator(robot)
        text = c_source(geometry, geometry.round_trip())
    numbers = [line for name in ("MOTION_K", "BODY_K") for line in _table(name, own.numbers[name])]
    numbers += [_line("SHARES", own.numbers["SHARES"], "of a rod's mass at either end")]
    return text, _interface(known, robot, past), "\n".join(numbers)


def _chain(known: MotionModel, robot: Robot, own: Dynamics, past: int) -> tuple[str, ...]:
    """Return interface and numbers of an open chain."""
    machine = mechanism_of(robot)
    told = own.numbers
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
        build=BUILD,
        links=len(told["CONVENTION"]),
        drives=len(told["DRIVE"]),
        limbs=machine.limbs,
        past=_held(past),
    )
    numbers = [
        f"static const int DELTACAL_CONVENTION[] = {{ {', '.join(map(str, told['CONVENTION']))} }};",
        "static const int DELTACAL_DRIVE[][3] = { /* link, whether it slides, joint */",
        *(f"    {{ {', '.join(map(str, row))} }}," for row in told["DRIVE"].tolist()),
        "};",
        *_table("LINK_K", told["LINK_K"]),
    ]
    of_pose = (
        ("REACH", np.array([reach]), "mm"),
        ("TOOL", robot.tool, "mm, in the last frame"),
        ("REACHES", np.where(np.array(machine.joint_units) == "mm", reach, 1.0), "what counts as much of a joint"),
    )
    for name, values, words in (
        *(of_pose if machine.limbs == POSED else ()),
        ("MUCH", told["MUCH"], "of a joint in its link"),
        ("SIGN", robot.joint_sign, "of the controller"),
        ("FACTOR", factors, "rad, mm per unit of a joint"),
        ("JOINT_LOW", ends[:, 0], "[joints] of the robot file"),
        ("JOINT_HIGH", ends[:, 1], "the same"),
    ):
        numbers.append(_line(name, values, words))
    return head, "\n".join(numbers)


def _interface(known: MotionModel, robot: Robot, past: int) -> str:
    """Return what a controller sees: codes, what is held between calls, the function."""
    machine = mechanism_of(robot)
    axes = ", ".join(machine.axes)
    target, velocity, acceleration = "target_mm", "velocity_mm_s", "acceleration_mm_s2"
    if machine.turning:
        target, velocity, acceleration = "target", "velocity", "acceleration"
        turns = ", ".join(f"r{name[1]}" for name in machine.asks if name[0] == "c")
        axes = f"{axes} [mm, mm/s, mm/s^2] and {turns} [deg, deg/s, deg/s^2]: rotation vector, turns about the axes"
    return INTERFACE.format(
        target=target,
        velocity=velocity,
        acceleration=acceleration,
        past=_held(past),
        unit=file_unit(machine.joint_unit),
        limbs=machine.limbs,
        asked=len(machine.asks),
        axes=axes,
        read=", ".join(readouts_of_model(known)[0]),
        words=WORDS,
        codes=DEFINES,
    )


def _held(past: int) -> str:
    """Return the line of what effects remember, where some do."""
    return f"\n    double past[{past}]; /* what friction remembers, and the states that it read last */" if past else ""


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
    speeds = joint_names(machine.joint_unit, n, SPEEDS)
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
        if is_law(name):
            raise UsageError(
                f"C is made of derived effects, and '{name}' is a law. Write it down (deltacal diagnose "
                "--write-effect), derive it (deltacal kernels), and diagnose again."
            )
        if lacking := [s.name for s in read_by(load_effect(name)) if s.joint or not s.c99_drive]:
            raise UsageError(
                f"{name} depends on '{lacking[0]}', which a controller does not have: it cannot be exported."
            )
    return [folder.joinpath(f"{name}.c").read_text(encoding="utf-8") for name in names]


def _past(joints: Sequence[JointModel]) -> int:
    """Return how many numbers are kept of the past: what effects remember, and the states that they read last."""
    return sum(_kept(term) for model in joints for term in model.terms)


def _kept(term: TorqueTerm) -> int:
    kernels = load_effect(term.effect)
    memories = len(getattr(kernels, "MEMORY", ()))
    return memories and memories + len(kernels.STATE)


def _by_joint(joints: Sequence[JointModel]) -> Iterator[tuple[int, list[tuple[TorqueTerm, int]]]]:
    """Yield each joint (from 0) that has terms, and these with where their past stands."""
    at = 0
    for model in joints:
        placed = []
        for term in model.terms:
            placed.append((term, at))
            at += _kept(term)
        if placed:
            yield model.joint - 1, placed


DRIVE = "int joint, double q, double qd, double qdd, double load, double temp_C"
UNREAD = "    (void)joint, (void)q, (void)qd, (void)qdd, (void)load, (void)temp_C;"


def _remembering(joints: Sequence[JointModel], past: int) -> Iterator[str]:
    """Yield the functions by which effects follow their past from one set point to the next."""
    yield f"#define DELTACAL_PAST {past}"
    yield "/* What was remembered at the last set point that was solved. */"
    yield "static void recall(const struct deltacal_motion *held, double *past)"
    yield from _copied("past[i] = held->past[i];", past)
    yield "/* Remember what a set point that was solved leaves. */"
    yield "static void keep(struct deltacal_motion *held, const double *past)"
    yield from _copied("held->past[i] = past[i];", past)
    yield "/* Follow the past of a joint's effects to this set point, h seconds after the last (0: it is the first). */"
    yield f"static void remember(double *past, double h, {DRIVE})"
    yield "{"
    yield f"    (void)past, (void)h;\n{UNREAD}"
    for joint, placed in _by_joint(joints):
        remembering = [(term, at) for term, at in placed if _kept(term)]
        if not remembering:
            continue
        yield f"    if (joint == {joint}) {{"
        for term, at in remembering:
            states = load_effect(term.effect).STATE
            before = at + _kept(term) - len(states)
            yield from _numbers(term, at)
            yield "            if (h > 0.0)"
            yield f"                {term.effect}_step(past + {at}, past + {before}, s, h, c, constants);"
            yield "            else"
            yield f"                {term.effect}_start(past + {at}, s, c, constants);"
            yield from (f"            past[{before + n}] = s[{n}];" for n in range(len(states)))
            yield "        }"
        yield "    }"
    yield "}"
    yield ""


def _copied(line: str, past: int) -> Iterator[str]:
    yield "{"
    if past:
        yield f"    int i;\n    for (i = 0; i < DELTACAL_PAST; i++)\n        {line}"
    else:
        yield "    (void)held, (void)past;"
    yield "}"
    yield ""


def _drive(joints: Sequence[JointModel]) -> Iterator[str]:
    """Yield the functions of what a drive has beside the rigid machine."""
    yield "/* What a drive gives beside its load, in units inside. */"
    yield f"static double beside(const double *past, {DRIVE})"
    yield "{"
    yield "    double total = 0.0;"
    yield f"    (void)past;\n{UNREAD}"
    for joint, placed in _by_joint(joints):
        yield f"    if (joint == {joint}) {{"
        for term, at in placed:
            yield from _numbers(term, at)
            yield f"            total += {term.effect}(s, c, constants);"
            yield "        }"
        yield "    }"
    yield "    return total;"
    yield "}"
    yield ""
    yield "/* What a drive gives, friction ramped near rest; past is followed up to this set point. */"
    yield f"static double deltacal_drive(double *past, double h, {DRIVE})"
    yield "{"
    yield "    const double edge = DELTACAL_REST[joint];"
    yield "    load += DELTACAL_ROTOR[joint] * qdd;"
    yield "    remember(past, h, joint, q, qd, qdd, load, temp_C);"
    yield "    if (!(fabs(qd) < edge))"
    yield "        return load + beside(past, joint, q, qd, qdd, load, temp_C);"
    yield "    return load + (0.5 - 0.5 * qd / edge) * beside(past, joint, q, -edge, qdd, load, temp_C)"
    yield "           + (0.5 + 0.5 * qd / edge) * beside(past, joint, q, edge, qdd, load, temp_C);"
    yield "}"
    yield ""


def _numbers(term: TorqueTerm, at: int) -> Iterator[str]:
    """Yield the begin of a block with an effect's states, coefficients and constants; its past stands from `at` on."""
    kernels = load_effect(term.effect)
    memories = len(getattr(kernels, "MEMORY", ()))
    states = [*(s.c99_drive for s in read_by(kernels)), *(f"past[{at + n}]" for n in range(memories))]
    yield "        {"
    yield f"            const double s[] = {{ {', '.join(states) or '0.0'} }};"
    yield f"            static const double c[] = {{ {c_numbers(np.array(term.values))} }};"
    yield f"            static const double constants[] = {{ {c_numbers(np.array(term.constants or (0.0,)))} }};"
