"""Machines in motion that have what nobody says: rigid torques of another engine, friction by formulas of its own.

The rigid machine is MuJoCo's (`tests.support.mujoco_trees`) where the extra `proof` is installed, of the Delta one in
five; else Newton's and Euler's equations of the tests for the arm and the derived torques for the Delta, which agree
with MuJoCo's to 1e-8 (`tests/kernels/test_dynamics_of_others.py`). `Case.engine` says which. What drives have
beside is written here once more, from the contract's definitions, and uses nothing of the effects' kernels. How large
an effect is drawn is settled by an ideal fit: without it, so fitted, the rest would be larger by `SHOWS`.
"""

from __future__ import annotations

import csv
import importlib.util
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.files.robot import robot_from_dict, robot_to_toml
from deltacal_gen.machine.dynamics import dynamics_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.rigid import Rigid
from tests.support.every_effect import ARM
from tests.support.machines_with_loops import machine
from tests.support.mujoco_trees import torque_of_chain, torque_of_linkage

Array = np.ndarray
DEG = np.pi / 180
RUNS, SECONDS = 5, 6.0
COUNTS = 2**19  # of an encoder, per turn
NOISE = 0.02  # of a joint's rms torque
SHOWS = 1.06  # what is left without an effect over what is left with it, at least
HARMONICS = 5
PASSED = 2.2  # periods of a ripple, at least: of fewer it is any smooth function of the position
GROWS = 1.4  # an effect that does not show, again and again
ALONE = ("coulomb_friction", "viscous_friction", "quadratic_friction", "stribeck_friction", "load_friction")
NAMES = (*ALONE, "presliding_friction", "warm_friction", "torque_offset", "torque_ripple", "latency")
BODIES = ("rotor_inertia", "payload_error")  # where the robot file states all bodies
BY_ENGINE = 5
FOREIGN = ("bouc_wen", "counterweight", "run_in", "cable")
UNITS = {"coulomb": 1e3, "stribeck": 1e3, "offset": 1e3, "cos": 1e3, "sin": 1e3, "viscous": 1e3 / DEG, "load": 1.0}
UNITS |= {"quadratic": 1e3 / DEG**2, "warm": 1e3 / DEG, "stiffness": 1e3 / DEG, "inertia": 1.0}


@dataclass(frozen=True)
class Concealed:
    """An effect on a joint (from 1; 0: the payload's, of all), with its parameters in the units of files."""

    name: str
    joint: int
    values: dict[str, float] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Movement:
    """Joints (3, N, n) with derivatives [rad, s], time [s] and run (N,), temperature (N,), rigid torque (N, n)."""

    states: Array
    time: Array
    run: np.ndarray
    warm: Array
    load: Array


@dataclass(frozen=True, eq=False)
class Case:
    """A recording, and what it conceals; `file` is the robot as its file has it, with its bodies or without."""

    seed: int
    machine: str
    engine: str
    stated: bool
    kind: str
    robot: Robot
    file: Robot
    concealed: tuple[Concealed, ...]
    movement: Movement
    tau: Array


def available() -> bool:
    """Tell whether MuJoCo is installed."""
    return importlib.util.find_spec("mujoco") is not None


def series(rng: np.random.Generator, time: Array, home: Array, reach: Array) -> Array:
    """Return joints, velocities, accelerations (3, N, n) of a finite Fourier series around some place."""
    out = np.zeros((3, len(time), len(home)))
    for j in range(len(home)):
        w = 2 * np.pi / SECONDS * np.arange(1, HARMONICS + 1)
        a = rng.standard_normal(HARMONICS) / np.arange(1, HARMONICS + 1) ** 0.7
        phase, angle = rng.uniform(0, 2 * np.pi, HARMONICS), np.outer(time, w)
        size = reach[j] / np.abs(np.sin(angle + phase) @ a).max()
        out[:, :, j] = size * np.array(
            [np.sin(angle + phase) @ a, np.cos(angle + phase) @ (a * w), -np.sin(angle + phase) @ (a * w**2)]
        )
        out[0, :, j] += home[j]
    return out


Made = tuple[Robot, Robot, Callable[[Array], Array], str]  # stated, without bodies, rigid torque, who computes that


def arm(rng: np.random.Generator) -> Made:
    """Return an arm of six joints."""
    links, head = [], {"robot": {"name": "arm", "mechanism": "serial"}}
    for link in ARM:
        m, size = link["mass"] * rng.uniform(0.7, 1.4), 60.0 + 0.2 * abs(link.get("a", 0.0) + link.get("d", 0.0))
        com = [c + 15.0 * rng.standard_normal() for c in link["com"]]
        xx, yy, zz = m * size**2 * rng.uniform(0.5, 1.0, 3)
        links.append(link | {"mass": m, "com": com, "inertia": [xx, yy, zz, 0.0, 0.0, 0.0]})
    robot = robot_from_dict(head | {"joint": [dict(link) for link in links]})
    bodies = {"mass", "com", "inertia"}
    bare = robot_from_dict(head | {"joint": [{k: v for k, v in link.items() if k not in bodies} for link in links]})
    inertia = np.asarray(dynamics_of(robot).stated()).reshape(len(links), 10)
    if available():
        return robot, bare, lambda s: torque_of_chain(links, inertia, s, (0.0, 0.0, -9.81)), "mujoco"
    from tests.support import independent_dynamics

    def newton(s: Array) -> Array:
        g = np.array([0.0, 0.0, -9.81])
        return np.array([independent_dynamics.torque(links, *s[:, n], inertia, g) for n in range(s.shape[1])])

    return robot, bare, newton, "Newton and Euler"


def delta(rng: np.random.Generator) -> Made:
    """Return a six-rod Delta, each the same machine; one in `BY_ENGINE` by MuJoCo, whose loops take it long."""
    robot = replace(machine("delta"), joint_sign=np.ones(3))
    bare = replace(robot, masses=None)
    if available() and rng.integers(BY_ENGINE) == 0:
        from tests.support.linkages import delta as linkage

        at = np.array([0.0, 0.0, -850.0, 0.0, 0.0, 0.0])
        return robot, bare, lambda s: torque_of_linkage(linkage(robot), s, at), "mujoco"
    own = dynamics_of(robot)
    return robot, bare, lambda s: np.asarray(own.torque(s, own.stated())), "deltacal"


def _movement(rng: np.random.Generator, robot: Robot, rate: float, rigid: Callable[[Array], Array]) -> Movement:
    time, n = np.arange(0.0, SECONDS, 1.0 / rate), mechanism_of(robot).limbs
    if robot.mechanism == "serial":
        home, reach = rng.uniform(-0.5, 0.5, n), rng.uniform(0.6, 1.0, n)
    else:
        q, _, _ = mechanism_of(robot).inverse(
            np.array([[0.0, 0.0, -850.0]]), robot.tool, mechanism_of(robot).rows(robot)
        )
        home, reach = q[0], np.full(n, 0.28)
    states = np.concatenate([series(rng, time, home, reach) for _ in range(RUNS)], axis=1)
    run = np.repeat(np.arange(RUNS), len(time))
    warm = 22.0 + 3.0 * run + 2.0 * rng.uniform(0, 1, RUNS)[run]
    return Movement(states, np.tile(time, RUNS), run, warm, rigid(states))


def _state_along(rate: Callable[[float, float], float], way: Array, first: np.ndarray) -> Array:
    """Return a state (N,) that changes along a way (N,) per sample, by exponentials from sample to sample."""
    out = np.zeros(len(way))
    for n in range(1, len(way)):
        out[n] = 0.0 if first[n] else rate(out[n - 1], way[n])
    return out


def torque(concealed: Concealed, at: Movement) -> Array:
    """Return what an effect adds to the torque of its joint (N,) [N mm]; of latency and payload see `beside`."""
    j, v = concealed.joint - 1, concealed.values
    (q, qd, qdd), load = at.states[:, :, j], at.load[:, j]
    way, first = np.gradient(q), np.diff(at.run, prepend=-1) != 0
    way = np.where(first, 0.0, np.diff(q, prepend=q[0]))
    by_name: dict[str, Callable[[], Array]] = {
        "coulomb_friction": lambda: 1e3 * v["coulomb"] * np.sign(qd),
        "viscous_friction": lambda: 1e3 * v["viscous"] * qd / DEG,
        "quadratic_friction": lambda: 1e3 * v["quadratic"] * qd * np.abs(qd) / DEG**2,
        "stribeck_friction": lambda: 1e3 * v["stribeck"] * np.sign(qd) * np.exp(-((qd / DEG / v["velocity"]) ** 2)),
        "load_friction": lambda: v["load"] * np.abs(load) * np.sign(qd),
        "presliding_friction": lambda: (
            1e3 * v["force"] * (_dahl(way, first, v["force"] / v["stiffness"]) - np.sign(qd))
        ),
        "warm_friction": lambda: 1e3 * v["warm"] * (at.warm - 20.0) * qd / DEG,
        "torque_offset": lambda: np.full(len(q), 1e3 * v["offset"]),
        "torque_ripple": lambda: 1e3 * (v["cos"] * np.cos(v["order"] * q) + v["sin"] * np.sin(v["order"] * q)),
        "rotor_inertia": lambda: v["inertia"] * qdd / 1000.0,
        "bouc_wen": lambda: 1e3 * v["size"] * _bouc_wen(way, first, v["way"]),
        "counterweight": lambda: -1e3 * v["size"] * _spring(q - np.median(q)),
        "run_in": lambda: 1e3 * v["size"] * qd / np.std(qd) * np.exp(-(at.run * SECONDS + at.time) / v["time"]),
        "cable": lambda: 1e3 * v["size"] * np.maximum(0.0, (q - np.median(q)) / np.std(q)) ** 2,
    }
    return by_name[concealed.name]()


def _dahl(way: Array, first: np.ndarray, travel: float) -> Array:
    def rate(z: float, s: float) -> float:
        side = float(np.sign(s))
        return side + (z - side) * float(np.exp(-abs(s) / DEG / travel))

    return _state_along(rate, way, first)


def _bouc_wen(way: Array, first: np.ndarray, size: float) -> Array:
    """Hysteresis of a spring that yields gradually, and keeps some of its stiffness (Wen 1976; n = 1)."""
    z = _state_along(lambda z, s: z + (s - 0.7 * abs(s) * z - 0.3 * s * abs(z)) / (size * DEG), way, first)
    q = np.cumsum(way)
    return 0.7 * z + 0.3 * (q - q.mean()) / max(float(np.std(q)), 1e-9)


def _spring(q: Array) -> Array:
    """Torque of a spring from a point of the frame to one of the link: no wave of the joint's turn."""
    a, b = 1.0, 0.6
    long = np.sqrt(a * a + b * b + 2 * a * b * np.cos(q + 0.8))
    return np.asarray(-(long - 0.7) * a * b * np.sin(q + 0.8) / long * 4.0)


def drawn(name: str, joint: int, at: Movement, rng: np.random.Generator, grow: float) -> Concealed:
    """Return an effect of a believable size on a joint, or of the payload."""
    j = max(joint - 1, 0)
    T, V = np.sqrt(np.mean(at.load[:, j] ** 2)) / 1e3, np.sqrt(np.mean(at.states[1, :, j] ** 2)) / DEG
    A, size = np.sqrt(np.mean(at.states[2, :, j] ** 2)), float(rng.uniform(0.05, 0.2)) * grow * T
    phase = rng.uniform(0, 2 * np.pi)
    first = max(5, int(np.ceil(PASSED * 2 * np.pi / np.ptp(at.states[0, :, j]))))
    values: dict[str, dict[str, float]] = {
        "coulomb_friction": {"coulomb": size},
        "viscous_friction": {"viscous": size / V},
        "quadratic_friction": {"quadratic": size / V**2},
        "stribeck_friction": {"stribeck": size, "velocity": float(rng.uniform(0.05, 0.3)) * V},
        "load_friction": {"load": float(rng.uniform(0.05, 0.15)) * grow},
        "presliding_friction": {"force": size, "stiffness": size / float(rng.uniform(0.3, 3.0))},
        "warm_friction": {"warm": size / V / 10.0},
        "torque_offset": {"offset": size},
        "torque_ripple": {
            "order": float(first + rng.integers(25)),
            "cos": size * float(np.cos(phase)),
            "sin": size * float(np.sin(phase)),
        },
        "rotor_inertia": {"inertia": 1e6 * size / A},
        "latency": {"delay": float(rng.uniform(0.002, 0.008)) * grow},
        "payload_error": {
            "mass": float(rng.uniform(0.3, 1.0)) * grow,
            **{f"com_{c}": 40.0 * float(rng.standard_normal()) for c in "xyz"},
        },
        "bouc_wen": {"size": 1.5 * size, "way": float(rng.uniform(2.0, 6.0))},
        "counterweight": {"size": 2 * size},
        "run_in": {"size": 2 * size, "time": float(rng.uniform(4.0, 10.0))},
        "cable": {"size": size},
    }
    return Concealed(name, joint, values[name])


def beside(concealed: Sequence[Concealed], at: Movement, robot: Robot) -> Array:
    """Return what all effects add to the rigid torque (N, n) [N mm]."""
    out = np.zeros_like(at.load)
    for each in concealed:
        if each.name == "payload_error":
            off = np.array([each.values[f"com_{c}"] for c in "xyz"])
            out += each.values["mass"] * np.asarray(dynamics_of(robot).payload(at.states, off))
        elif each.name != "latency":
            out[:, each.joint - 1] += torque(each, at)
    for each in concealed:
        if each.name == "latency":
            whole, j = at.load[:, each.joint - 1] + out[:, each.joint - 1], each.joint - 1
            late = np.concatenate(
                [
                    np.interp(at.time[at.run == r] - each.values["delay"], at.time[at.run == r], whole[at.run == r])
                    for r in range(RUNS)
                ]
            )
            out[:, j] += late - whole
    return out


def shows(some: Sequence[Concealed], k: int, at: Movement, robot: Robot, columns: list[Array], noise: Array) -> bool:
    """Tell whether an ideal fit would miss one of some effects, on a joint it is on."""
    own = [n for n, each in enumerate(some) if each.joint in (some[k].joint, 0) or some[k].joint == 0]
    rest = [some[n] for n in own if n != k]
    change = beside([some[n] for n in own], at, robot) - beside(rest, at, robot)
    for j in [some[k].joint - 1] if some[k].joint else range(at.load.shape[1]):
        others = [beside([r], at, robot)[:, j] for r in rest if r.name != "latency"]
        X = np.column_stack([columns[j], *others]) if others or columns[j].size else np.zeros((len(change), 1))
        usual = np.column_stack([np.sign(at.states[1, :, j]), at.states[1, :, j]])
        X = np.hstack([X, usual]) if some[k].name not in ("coulomb_friction", "viscous_friction") else X
        scale = np.sqrt(np.mean(X**2, axis=0)) + 1e-300
        left = change[:, j] - X @ (np.linalg.lstsq(X / scale, change[:, j], rcond=1e-9)[0] / scale)
        if 1.0 + np.mean(left**2) / noise[j] ** 2 > SHOWS**2:
            return True
    return False


def generate(seed: int, kind: str, rate: float = 500.0) -> Case:
    """Return a case: `kind` is how many effects it conceals, or one of `FOREIGN`."""
    rng = np.random.default_rng([seed, 20])
    which = ("arm", "delta")[seed % 2]
    robot, bare, rigid, engine = {"arm": arm, "delta": delta}[which](rng)
    stated = bool(rng.integers(2))
    at = _movement(rng, robot, rate, rigid)
    n = at.load.shape[1]
    noise = NOISE * np.sqrt(np.mean(at.load**2, axis=0))
    known = stated and kind not in FOREIGN  # what other bodies would do as well is nothing foreign
    columns = [np.zeros((len(at.time), 0))] * n if known else Rigid(robot).columns(at.states)
    names = (*NAMES, *(BODIES if stated else ()))
    count = int(kind) if kind.isdigit() else 1
    chosen = list(rng.choice(names, count, replace=False)) if kind.isdigit() else [kind]
    if "presliding_friction" in chosen and "coulomb_friction" not in chosen:
        chosen = ["coulomb_friction", *[c for c in chosen if c != "coulomb_friction"]][: max(count, 2)]
        chosen = [*dict.fromkeys([*chosen, "presliding_friction"])]
    joint, some = int(rng.integers(1, n + 1)), []
    for name in chosen:
        here = 0 if name == "payload_error" else joint
        some.append(drawn(str(name), here, at, rng, 1.0))
    some = _tied(some)
    for _ in range(12):
        hidden = [k for k in range(len(some)) if not shows(some, k, at, robot, columns, noise)]
        if not hidden:
            break
        some = _tied([grown(each) if k in hidden else each for k, each in enumerate(some)])
    tau = at.load + beside(some, at, robot) + noise * rng.standard_normal(at.load.shape)
    return Case(seed, which, engine, stated, kind, robot, robot if stated else bare, tuple(some), at, tau)


def _tied(some: Sequence[Concealed]) -> list[Concealed]:
    """Return effects of which what builds up over a way is the joint's dry friction."""
    dry = [each.values["coulomb"] for each in some if each.name == "coulomb_friction"]
    found = []
    for each in some:
        if each.name == "presliding_friction" and dry:
            way = each.values["force"] / each.values["stiffness"]
            each = replace(each, values={"force": dry[0], "stiffness": dry[0] / way})
        found.append(each)
    return found


def grown(one: Concealed) -> Concealed:
    """Return an effect that is larger."""
    fixed = {"velocity", "order", "time", "way", "com_x", "com_y", "com_z"}
    return replace(one, values={key: v if key in fixed else GROWS * v for key, v in one.values.items()})


def write(case: Case, folder: Path) -> tuple[Path, Path]:
    """Write robot file and recording; return their paths."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "robot.toml").write_text(robot_to_toml(case.file))
    n, at = case.tau.shape[1], case.movement
    counts = 2 * np.pi / COUNTS
    q = np.round(at.states[0] / counts) * counts / DEG
    names = ["run", "time_s", *(f"q{i + 1}_deg" for i in range(n)), "temp_C", *(f"tau{i + 1}_Nm" for i in range(n))]
    with (folder / "recording.csv").open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(names)
        for k in range(len(q)):
            cells: list[Any] = [f"{v:.7g}" for v in (*q[k], at.warm[k], *(case.tau[k] / 1e3))]
            writer.writerow([int(at.run[k]) + 1, f"{at.time[k]:.4f}", *cells])
    (folder / "recording.toml").write_text('[measurement]\nkind = "torque"\n')
    return folder / "robot.toml", folder / "recording.csv"
