"""Random problems of all machines that a fit must arrive at, each made of a seed and a number.

Short and wide ranges, few and many poses, small and large errors, frames known and unknown, points near a line, soft
arms, starts that are far off. Half are of geometry; the others of geometry beside physics that another session found,
of geometry with effects, of joints that touch fixed points, and beside a smooth correction. Distributions were written
down before the first run and are not narrowed.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from pathlib import Path

import numpy as np

from deltacal_gen.diagnosis.correction import Smooth, displaced
from deltacal_gen.diagnosis.library import library
from deltacal_gen.diagnosis.refits import refitted, terms_of
from deltacal_gen.errors import DeltacalError
from deltacal_gen.estimation.fit import CONVERGED, fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import BROAD
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.files.robot import Robot, read_robot, robot_from_dict
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import SOLVED, Array, mechanism_of
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, largest, on_limbs
from deltacal_gen.planning.targets import grid
from deltacal_gen.units import DEG, joint_names

EXAMPLES = Path(__file__).resolve().parents[2] / "src" / "deltacal_gen" / "examples"
MACHINES = ("delta", "linear_delta", "diamond", "planar_parallelogram")
SORTS = {"geometry": 0.5, "physics": 0.15, "effects": 0.15, "contact": 0.1, "correction": 0.1}
KINDS = {"position": 0.6, "pose": 0.15, "distance": 0.15, "height": 0.1}
RANGES = (5.0, 15.0, 40.0, 120.0)  # deg: how far joints of a chain move
SIGMAS = (0.002, 0.02, 0.2)  # mm; rotations and joints: of an arm of 500 mm
SIZES = (0.3, 1.0, 3.0, 10.0)  # of the errors, in ordinary ones
STARTS = (0.0, 0.0, 1.0, 3.0, 10.0)  # ordinary errors by which a start is off the robot file
EFFECTS = 2  # at most, beside geometry
SHARE = 0.3  # of an effect's largest believable size, or of that which moves readings by ROOM
ROOM = 1.0  # mm
TRIES = 200  # of a machine that may not be able to stand at its poses
SOCKETS, TOUCHES = 4, 12
KNOTS = 8
WAVE = 1e-3  # rad, mm / 100: what a smooth correction moves a joint by
Fitted = Callable[[], Fit]


def drawn(seed: int, number: int) -> tuple[str, Fitted]:
    """Return a random problem: a word on what it is, and what fits it."""
    rng = np.random.default_rng([seed, number])
    sort = str(rng.choice(list(SORTS), p=list(SORTS.values())))
    for _ in range(TRIES):
        try:
            word, fitted = MAKERS[sort](rng)
        except DeltacalError:
            continue  # a machine that cannot stand at such poses is no problem of a fit
        return f"{sort}: {word}", fitted
    raise AssertionError(f"no machine of {TRIES} stands at its poses")


def chain(rng: np.random.Generator, fewest: int = 3) -> Robot:
    """Return an arm of 3 to 8 joints, its links drawn at random [mm, deg]."""
    joints = []
    for _ in range(int(rng.integers(fewest, 9))):
        joints.append(
            {
                "kind": "revolute" if rng.random() < 0.9 else "prismatic",
                "convention": "standard" if rng.random() < 0.7 else "modified",
                "a": float(np.round(rng.choice([0.0, 1.0]) * rng.uniform(-600, 600), 1)),
                "alpha": float(rng.choice([-90.0, 0.0, 90.0])),
                "d": float(np.round(rng.choice([0.0, 1.0]) * rng.uniform(-500, 500), 1)),
                "theta": float(rng.choice([-90.0, 0.0, 90.0, 180.0])),
                "mass": float(np.round(rng.uniform(0.5, 12.0), 1)),
                "com": np.round(rng.uniform(-150, 150, 3), 1).tolist(),
            }
        )
    tool = np.round(rng.uniform(-120, 120, 3), 1).tolist()
    return robot_from_dict(
        {"robot": {"name": "drawn", "mechanism": "serial"}, "joint": joints, "geometry": {"tool": tool}}
    )


def machine(rng: np.random.Generator) -> Robot:
    """Return a machine: three in five are arms."""
    if rng.random() < 0.6:
        return chain(rng)
    return read_robot(EXAMPLES / str(rng.choice(MACHINES)) / "robot.toml")


def poses(robot: Robot, rng: np.random.Generator, n: int) -> Array:
    """Return joints (n, n_q) of a machine as the controller counts [rad, mm]."""
    mechanism = mechanism_of(robot)
    turning = np.array([unit == "rad" for unit in mechanism.joint_units])
    if mechanism.name == "serial":
        middle = np.where(turning, rng.uniform(-90, 90, len(turning)) * DEG, rng.uniform(-200, 200, len(turning)))
        wide = rng.choice(RANGES) / 2
        half = np.where(turning, wide * DEG, 5 * wide)
        q = middle + half * rng.uniform(-1, 1, (n, len(turning)))
        return near_a_line(robot, q, rng) if rng.random() < 0.2 else q
    assert robot.workspace is not None  # the examples have one
    places = grid(robot.workspace, layers=4, radii=3)
    ends, part = rng.choice(len(places), (2, n)), rng.random((n, 1))
    points = part * places[ends[0]] + (1 - part) * places[ends[1]]
    q, _, status = mechanism.inverse(points, robot.tool, mechanism.rows(robot))
    return robot.joint_sign * q[status == SOLVED]


def near_a_line(robot: Robot, q: Array, rng: np.random.Generator) -> Array:
    """Return joints that bring the tool nearer to a line, as trajectories do."""
    mechanism, rows = mechanism_of(robot), mechanism_of(robot).rows(robot)
    tool = np.broadcast_to(robot.tool, (len(q), 3))
    along = rng.standard_normal(3)
    along /= np.linalg.norm(along)
    for _ in range(20):
        x, _ = mechanism.forward(q, tool, rows)
        off = x[:, :3] - x[:, :3].mean(axis=0)
        off -= np.outer(off @ along, along)
        J = mechanism.sensitivity(x, q, tool, rows).joints[:, :3]
        step = np.linalg.pinv(J, rcond=1e-2) @ off[:, :, None]
        q = q - np.clip(0.5 * step[:, :, 0], -0.1, 0.1)
    return q


def made(robot: Robot, q: Array, rng: np.random.Generator, kind: str, frame: str) -> Recording:
    """Return an empty recording of joints (n, n_q), with temperatures, payloads and times as a session has them."""
    mechanism, n = mechanism_of(robot), len(q)
    columns = () if kind == "contact" else kind_of(kind).columns(mechanism)
    return Recording(
        path=Path("drawn"),
        kind=kind,
        measurement=Measurement(kind=kind, frame=frame),
        joint_unit=mechanism.joint_unit,
        joints=q,
        columns=columns,
        measured=np.full((n, len(columns)), np.nan),
        pose=np.arange(1, n + 1).astype(str),
        line=np.arange(2, n + 2),
        channels={
            "temp_C": rng.uniform(18.0, 35.0, n),
            "payload_kg": rng.choice([0.0, 1.0, 3.0], n),
            "time_s": np.cumsum(rng.uniform(2.0, 20.0, n)),
        },
        setup=np.zeros(n, dtype=int),
        setup_names=("",),
    )


def count(rng: np.random.Generator, parameters: int) -> int:
    """Return how many poses: fewer than determine the machine, just enough, or many."""
    return int(np.ceil(parameters * rng.choice([0.7, 1.5, 4.0]))) + 4


def ordinary(robot: Robot, rng: np.random.Generator, size: float) -> Array:
    """Return source errors (n_p,) of a size in ordinary ones."""
    typical = mechanism_of(robot).typical
    found: Array = size * typical * rng.standard_normal(len(typical))
    return found


def measured(
    rng: np.random.Generator, robot: Robot, kind: str = "position", terms: Callable[[Problem], list[Term]] | None = None
) -> tuple[str, Problem, list[Term]]:
    """Return a problem of a machine with errors, and with the effects that `terms` draws for it."""
    mechanism = mechanism_of(robot)
    names = mechanism.model(mechanism.full_model)
    frame = str(rng.choice(["robot", "unknown"])) if kind in ("position", "pose") else "robot"
    size, sigma = float(rng.choice(SIZES)), float(rng.choice(SIGMAS))
    q = poses(robot, rng, count(rng, len(names)))
    plain = made(robot, q, rng, "position" if kind == "distance" else kind, frame)
    own = [] if terms is None else terms(pose_problem(robot, simulate(robot, plain), names))
    errors = dict(zip((p.name for p in mechanism.parameters), ordinary(robot, rng, size), strict=True))
    found = simulate(robot, plain, errors, noise_mm=sigma, noise_rad=sigma / 500, rng=rng, terms=own)
    if mechanism.name == "serial" and kind == "position" and rng.random() < 0.3:  # it hangs, by what its reach is
        sag = rng.uniform(0, 0.01) * np.linalg.norm(found.measured[:, :2], axis=1)
        low = found.measured - np.outer(sag, np.eye(found.measured.shape[1])[-1])
        found = dataclasses.replace(found, measured=low)
    problem = pose_problem(robot, found, names, as_distance=kind == "distance")
    word = f"{mechanism.name}, {len(q)} poses, {kind}, frame {frame}, errors {size:g} ordinary, sigma {sigma:g}"
    return word, dataclasses.replace(problem, scale=BROAD * problem.scale), own


def start(problem: Problem, rng: np.random.Generator) -> Array:
    """Return where a fit begins: at the robot file, or off it."""
    errors = problem.reference.copy()
    own = problem.columns[: len(problem.names)]
    errors[own] += ordinary(problem.robot, rng, float(rng.choice(STARTS)))[own]
    return errors


def of_geometry(rng: np.random.Generator) -> tuple[str, Fitted]:
    robot, kind = machine(rng), str(rng.choice(list(KINDS), p=list(KINDS.values())))
    word, problem, _ = measured(rng, robot, "position" if kind == "height" and robot.links else kind)
    errors = start(problem, rng)
    problem.begin(errors)  # a machine that cannot stand there is no start
    return word, lambda: fit(problem, Prior(), errors=errors, robust=False, weigh_repeats=False)


def effects_for(rng: np.random.Generator) -> Callable[[Problem], list[Term]]:
    """Return what draws effects that a recording can carry, each on some of the limbs, of a size that shows."""

    def terms(problem: Problem) -> list[Term]:
        every, found = library(problem)[0], []
        names = sorted({t.effect for t in every})
        for name in rng.choice(names, int(rng.integers(1, EFFECTS + 1)), replace=False):
            forms = [t for t in every if t.effect == name]
            term = forms[int(rng.integers(len(forms)))]
            if term.limbs:
                term = on_limbs(term, rng.choice(term.limbs, int(rng.integers(1, len(term.limbs) + 1)), replace=False))
            machine = problem.solve(problem.reference)
            columns = problem.term_columns([term], problem.reference, problem.begin(problem.reference), machine)
            reach = np.nanmax(np.abs(columns), axis=(0, 1)).reshape(term.values.shape)
            most = SHARE * np.minimum(largest(term, problem.recording.joint_unit), ROOM / np.maximum(reach, 1e-9))
            found.append(term.with_values(np.where(reach > 0, most * rng.uniform(-1, 1, most.shape), 0.0)))
        return found

    return terms


def of_physics(rng: np.random.Generator) -> tuple[str, Fitted]:
    """Geometry beside physics that is carried, right or wrong by as much as it is large."""
    word, problem, terms = measured(rng, machine(rng), terms=effects_for(rng))
    held = tuple(t.with_values(t.values * (1 + rng.choice([0.0, 0.3, 1.0]) * rng.standard_normal())) for t in terms)
    problem, errors = dataclasses.replace(problem, held=held), start(problem, rng)
    problem.begin(errors)
    words = " and ".join(t.effect for t in held)
    return f"{word}, {words}", lambda: fit(problem, Prior(), errors=errors, robust=False, weigh_repeats=False)


def of_effects(rng: np.random.Generator) -> tuple[str, Fitted]:
    """Geometry and effects together, as a diagnosis searches and then tells them: they begin at nothing."""
    word, problem, terms = measured(rng, machine(rng), terms=effects_for(rng))
    first = fit(problem, Prior(), robust=False, weigh_repeats=False, must_converge=False)

    def fitted() -> Fit:
        found = refitted(problem, first, [t.with_values(np.zeros_like(t.values)) for t in terms])
        assert found is not None
        told = refitted(problem, found, terms_of(found), tolerance=CONVERGED)
        assert told is not None
        return told

    return f"{word}, {' and '.join(t.effect for t in terms)}", fitted


def of_contact(rng: np.random.Generator) -> tuple[str, Fitted]:
    """Joints at which an arm touches fixed points from many sides, two distances between them known."""
    robot = chain(rng, fewest=5)
    mechanism = mechanism_of(robot)
    names = mechanism.model(mechanism.full_model)
    size, sigma = float(rng.choice(SIZES)), float(rng.choice(SIGMAS))
    true = mechanism.rows(robot, ordinary(robot, rng, size))
    turning = np.array([unit == "rad" for unit in mechanism.joint_units])
    wide = np.where(turning, 1.0, 150.0)
    home = wide * rng.uniform(-1, 1, len(turning))
    at, q, which = [], [], []
    for k in range(SOCKETS):
        tool = np.tile(robot.tool, (3 * TOUCHES, 1))
        at.append(mechanism.forward((home + wide * rng.uniform(-0.5, 0.5, len(wide)))[None], tool[:1], true)[0][0, :3])
        free = home + wide * rng.uniform(-1, 1, (len(tool), len(wide)))
        for _ in range(40):  # Newton's method, all draws at once; those that do not get there are left out
            x, _ = mechanism.forward(free, tool, true)
            slope = mechanism.sensitivity(x, free, tool, true).joints[:, :3] * wide
            step = (np.linalg.pinv(slope, rcond=1e-3) @ (at[k] - x[:, :3])[:, :, None])[:, :, 0]
            free = free + wide * np.clip(step, -0.3, 0.3)
        there = free[np.abs(step).max(axis=1) < 1e-9][:TOUCHES]
        q.append(there + sigma / 500 * wide * rng.standard_normal(there.shape))
        which += [f"s{k}"] * len(there)
    joints = np.vstack(q)
    ties = tuple((f"s{k}", f"s{k + 1}", float(np.linalg.norm(at[k] - at[k + 1]))) for k in (0, 2))
    found = made(robot, joints, rng, "contact", "robot")
    found = dataclasses.replace(found, contact=np.array(which), contact_distances=ties)
    problem = pose_problem(robot, found, names)
    problem = dataclasses.replace(problem, scale=BROAD * problem.scale)
    errors = start(problem, rng)
    word = f"serial, {len(joints)} touches, errors {size:g} ordinary, sigma {sigma:g}"
    return word, lambda: fit(problem, Prior(), errors=errors, robust=False, weigh_repeats=False)


def of_correction(rng: np.random.Generator) -> tuple[str, Fitted]:
    """Geometry beside a smooth displacement of a joint that was found, from where geometry alone has it."""
    word, problem, _ = measured(rng, machine(rng))
    first = fit(problem, Prior(), robust=False, weigh_repeats=False, must_converge=False)
    mechanism = problem.mechanism
    limb = int(rng.integers(1, mechanism.limbs + 1))
    values = problem.body.q[:, limb - 1]
    unit = DEG if mechanism.joint_units[limb - 1] == "rad" else 1.0
    knots = np.linspace(values.min(), values.max(), KNOTS)[:, None] / unit
    wide = float(np.ptp(knots))
    size = WAVE if unit == DEG else 100 * WAVE
    name = joint_names(problem.recording.joint_unit, mechanism.limbs)[limb - 1]
    c, length = size * rng.standard_normal((KNOTS, 1)), 0.2 * wide
    smooth = Smooth(variable=name, limbs=(limb,), knots=knots, length=length, reach=length, coefficients=c)
    moved = displaced(first, [smooth], problem)
    return f"{word}, a correction of joint {limb}", lambda: fit(
        moved, Prior(), errors=first.errors, instrument=first.instrument, robust=False, weigh_repeats=False
    )


MAKERS = {
    "geometry": of_geometry,
    "physics": of_physics,
    "effects": of_effects,
    "contact": of_contact,
    "correction": of_correction,
}
