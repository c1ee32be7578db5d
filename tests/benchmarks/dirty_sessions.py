"""Sessions as people take them: what `concealed_cases` draws, recorded without the order of a laboratory.

Errors are ordinary everywhere and large at one part; an arm's tool is not where the robot file has it. Poses lie on a
path, and are driven and read in the order of time; the first one is visited again now and then, with the label of its
pose or without. Joints are rounded to encoder counts, payloads change in blocks, the thermometer lags, the instrument
may be moved once. Its noise grows with the range and is larger across the line of sight than along it; a part of it is
correlated in time; it warms up by less than its noise; a few readings are outliers.

Public: `DirtyShop`.
"""

from __future__ import annotations

import dataclasses

import numpy as np

from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.rotation import from_vector, to_vector
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.units import DEG
from tests.benchmarks import concealed_machines as machines
from tests.benchmarks.concealed_cases import Shop
from tests.benchmarks.concealed_sessions import SHARES, Array, Session, _channels

ORDERLY = {"motion", "room", "pause", "steady", "round", "approach"}  # of `SHARES`: drawn here in another way, or not
POSES = 60, 200  # rows of a session
FRESH = 100
LARGE = 4.0, 12.0  # one part's error, in typical ones
TOOL_OFF_MM = 40.0
RETURNS = 8, 20  # rows between visits of the first pose
COLOURED = 0.4  # at most so much of the noise's variance is correlated in time
MEMORY_ROWS = 1.0, 5.0  # its e-folding time
WARM_UP = 0.3, 0.7  # standard deviations of noise
WARM_UP_S = 600.0, 3000.0
ACROSS = 1.0, 2.5  # times the noise along the line of sight
RANGE = 1.2, 4.0  # of the instrument, in sizes of the measured volume
OUTLIERS = 0.03  # at most, of the rows
OUTLIER_SIZE = 8.0, 60.0  # standard deviations
COUNT = 0.3, 1.2  # an encoder count moves the platform by so many standard deviations of noise
LAG_S = 200.0, 700.0  # of the thermometer


class DirtyShop(Shop):
    """Draws sessions as people take them, and records them with what their instruments do."""

    def session(
        self, kind: str, names: tuple[str, ...], must: set[str], rng: np.random.Generator, machine: str
    ) -> Session:
        """Return a session of positions, or of poses; `must` are channels that it has to have."""
        robot = machines.draw(machine, rng)
        errors = large_errors(robot, rng)
        have = {"time", *must, *(c for c, share in SHARES.items() if c not in ORDERLY and rng.random() < share)}
        if rng.random() < 0.5:
            have.add("approach")
        of = str(rng.choice(["position", "pose"], p=[0.85, 0.15]))
        of = of if of in machines.kinds(mechanism_of(robot)) else "position"
        sigma, turn = round(float(rng.uniform(0.01, 0.05)), 4), round(float(rng.uniform(0.002, 0.01)), 4) * DEG
        count = int(np.exp(rng.uniform(*np.log(POSES))))
        start = float(rng.uniform(0, 60))
        tools = np.zeros((1, 3))
        if "instrument_offset" in names:
            size = robot.geometry.get("platform_radius", (50.0,))[0]
            tools = np.round(rng.uniform(-1, 1, (3, 3)) * [size, size, 30], 3)
            tools[:, [axis not in mechanism_of(robot).axes for axis in "xyz"]] = 0.0
        made = [
            path_of_poses(robot, of, n, tools, have, rng, begin)
            for n, begin in ((count, start), (FRESH, start + 40.0 * count))
        ]
        traits = (*sorted(have), of, f"n={count}")
        measurement = made[0].measurement
        return Session(
            robot, errors, sigma, turn, measurement, None, tools, *made, frame=int(rng.integers(2**32)), traits=traits
        )

    def record(
        self, exact: Recording, session: Session, rng: np.random.Generator, scale: float
    ) -> tuple[Recording, tuple[str, ...]]:
        """Return what the shop's instrument, encoders and thermometer make of readings without noise."""
        traits = []
        k = len(mechanism_of(session.robot).axes)
        values = exact.measured.copy()
        values[:, :k] += instrument_noise(values[:, :k], exact.channels["time_s"], exact.setup, session.sigma, rng)
        if values.shape[1] > k:
            turned = session.turn * rng.standard_normal((len(values), values.shape[1] - k))
            if turned.shape[1] == 3:
                values[:, k:] = to_vector(from_vector(turned) @ from_vector(values[:, k:]))
            else:
                values[:, k:] += turned
        channels = dict(exact.channels)
        if "temp_C" in channels:
            channels["temp_C"] = lagged(channels["temp_C"], channels["time_s"], rng.uniform(*LAG_S)).round(1)
        pose = exact.pose
        if rng.random() < 0.5:
            pose = np.array([str(row + 1) for row in range(len(pose))])
            traits.append("unlabelled")
        said = exact.measurement
        if rng.random() < 0.5:
            said = dataclasses.replace(said, sigma_mm=session.sigma)
            traits.append("declared")
        joints = rounded_to_counts(exact.joints, values[:, :k], session.sigma, rng)
        done = dataclasses.replace(
            exact, joints=joints, channels=channels, pose=pose, measured=values, measurement=said
        )
        return done, tuple(traits)


def large_errors(robot: Robot, rng: np.random.Generator) -> dict[str, float]:
    """Return ordinary errors of the parts, one of them large, and of an arm the tool elsewhere [mm, rad]."""
    errors, mechanism = machines.ordinary_errors(robot, rng), mechanism_of(robot)
    known = set(mechanism.models[mechanism.full_model])
    parts = [p for p in mechanism.parameters if p.name in known and p.name not in ("tx", "ty", "tz")]
    part = parts[int(rng.integers(len(parts)))]
    errors[part.name] = float(machines.SMALL * part.typical * rng.uniform(*LARGE) * rng.choice([-1, 1]))
    if robot.links:
        errors |= {name: float(TOOL_OFF_MM * rng.standard_normal()) for name in ("tx", "ty", "tz") if name in known}
    return errors


def path_of_poses(
    robot: Robot, kind: str, n: int, tools: Array, have: set[str], rng: np.random.Generator, start: float
) -> Recording:
    """Return a recording without readings, its poses driven one after another along a path."""
    mechanism = mechanism_of(robot)
    every = int(rng.integers(*RETURNS)) if rng.random() < 0.6 else n
    away = np.arange(n) % every > 0
    tool = tools[rng.integers(len(tools), size=n)]
    theta = machines.joints_of_poses(robot, int(away.sum()) + 1, tool[: int(away.sum()) + 1], rng)
    order = nearest_first(theta)
    which = np.where(away, np.cumsum(away), 0)
    joints, tool = theta[order][which], tool[: len(theta)][order][which]
    channels = _channels(n, have, robot, rng, start)
    if "payload_kg" in channels and "cycle" not in have:
        levels = rng.choice([0.0, 1.0, 2.0, 3.0, 5.0], int(rng.integers(2, 4)), replace=False)
        channels["payload_kg"] = levels[np.arange(n) * len(levels) // n]
    for i in range(mechanism.limbs):
        if f"approach{i + 1}" in channels:
            channels[f"approach{i + 1}"] = side_of_approach(joints[:, i])
    axes = tuple(f"{axis}_mm" for axis in mechanism.axes)
    setups = 2 if "setups" in have else 1
    return Recording(
        path="recording.csv",
        kind=kind,
        measurement=Measurement(kind=kind, frame="unknown"),
        joint_unit=mechanism.joint_unit,
        joints=joints,
        columns=axes if kind == "position" else (*axes, *(f"r{axis}_deg" for axis in mechanism.turns)),
        measured=np.zeros((n, 0)),
        pose=np.array([str(i + 1) for i in which]),
        line=np.arange(n) + 2,
        channels=channels,
        setup=(np.arange(n) * setups) // n,
        setup_names=tuple(str(i + 1) for i in range(setups)),
        tool=tool if len(tools) > 1 else None,
    )


def nearest_first(theta: Array) -> Array:
    """Return an order in which each row is followed by the nearest of those that are left."""
    left, order = set(range(1, len(theta))), [0]
    while left:
        rest = np.array(sorted(left))
        order.append(int(rest[np.argmin(((theta[rest] - theta[order[-1]]) ** 2).sum(axis=1))]))
        left.remove(order[-1])
    return np.array(order)


def side_of_approach(joint: Array) -> Array:
    """Return from which side a joint came to each row, +1 or -1: where it did not move as it came before."""
    side = np.sign(np.diff(joint, prepend=joint[0] - 1.0))
    for k in np.flatnonzero(side == 0):
        side[k] = side[k - 1]
    return side


def lagged(values: Array, time: Array, constant: float) -> Array:
    """Return what a sensor of the first order reads of a quantity over time [s]."""
    out = values.astype(float)
    for k in range(1, len(out)):
        out[k] = values[k] + (out[k - 1] - values[k]) * np.exp(-(time[k] - time[k - 1]) / constant)
    return out


def instrument_noise(x: Array, time: Array, setup: Array, sigma: float, rng: np.random.Generator) -> Array:
    """Return noise (N, k) of readings x [mm], rms `sigma` but for outliers: by range and direction, with memory."""
    n, k = x.shape
    size = float(np.linalg.norm(np.ptp(x, axis=0))) or 1.0
    noise = np.zeros((n, k))
    for s in np.unique(setup):
        at = setup == s
        direction = rng.standard_normal(k)
        station = x[at].mean(axis=0) + size * rng.uniform(*RANGE) * direction / np.linalg.norm(direction)
        sight = x[at] - station
        distance = np.linalg.norm(sight, axis=1)
        ray = sight / distance[:, None]
        share = rng.uniform(0, COLOURED)
        white = rng.standard_normal((at.sum(), k))
        drawn = np.sqrt(1 - share) * white + np.sqrt(share) * coloured(at.sum(), k, rng.uniform(*MEMORY_ROWS), rng)
        along = (drawn * ray).sum(axis=1)[:, None] * ray
        across = (drawn - along) * rng.uniform(*ACROSS) * (distance / distance.mean())[:, None]
        noise[at] = along + across
        noise[at] *= sigma / np.sqrt((noise[at] ** 2).mean())
        warm = rng.standard_normal(k)
        decay = np.exp(-(time[at] - time[at][0]) / rng.uniform(*WARM_UP_S))
        noise[at] += sigma * rng.uniform(*WARM_UP) * decay[:, None] * warm / np.linalg.norm(warm) * np.sqrt(k)
    bad = rng.choice(n, int(rng.uniform(0, OUTLIERS) * n), replace=False)
    noise[bad] += sigma * rng.choice([-1, 1], (len(bad), k)) * rng.uniform(*OUTLIER_SIZE, (len(bad), 1))
    return noise


def coloured(n: int, k: int, memory: float, rng: np.random.Generator) -> Array:
    """Return noise (n, k) of variance 1 that is correlated over `memory` rows (e-folding)."""
    out = rng.standard_normal((n, k))
    rho = np.exp(-1.0 / memory)
    for row in range(1, n):
        out[row] = rho * out[row - 1] + np.sqrt(1 - rho**2) * out[row]
    return out


def rounded_to_counts(joints: Array, x: Array, sigma: float, rng: np.random.Generator) -> Array:
    """Return joints in whole encoder counts, one of which moves the platform by about the noise."""
    travel = np.ptp(joints, axis=0)
    count = rng.uniform(*COUNT) * sigma * travel / (float(np.linalg.norm(np.ptp(x, axis=0))) or 1.0)
    return np.where(count > 0, np.round(joints / np.where(count > 0, count, 1.0)) * count, joints)
