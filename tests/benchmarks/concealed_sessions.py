"""What is recorded for a concealed case: a machine, an instrument, the channels of a shop, and the poses.

Public: `Session`, which draws them and makes readings.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.files.robot import Robot
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Camera, Measurement, Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term
from deltacal_gen.units import DEG, file_unit, to_internal
from tests.benchmarks import concealed_machines as machines

Array = np.ndarray
NEEDS = {  # channels of a recording, by what an effect reads
    "approach": "approach",
    "qd": "motion",
    "qdd": "motion",
    "inertia_torque": "motion",
    "warming": "temp",
    "time": "time",
    "payload_torque": "payload",
}
SHARES = {  # of the recordings that have a channel or a trait
    "time": 0.75,
    "temp": 0.6,
    "payload": 0.5,
    "approach": 0.6,
    "motion": 0.25,
    "humidity": 0.15,
    "room": 0.1,
    "pause": 0.15,
    "steady": 0.15,
    "round": 0.15,
    "setups": 0.1,
}
INSTRUMENT_ONLY = {"instrument_drift"}  # not seen in lengths
FEWER, IMAGES = 6, 30  # times fewer poses than of other kinds: each image shows some dozen points; at least so many
LENS = Camera(fx_px=1500.0, fy_px=1490.0, cx_px=645.0, cy_px=505.0)
OF_POSITIONS = {"position", "pose"}


@dataclass(frozen=True)
class Session:
    """A machine with its errors, what measures it how well, and its poses: those of the recording and fresh ones."""

    robot: Robot
    errors: dict[str, float]
    sigma: float
    turn: float
    measurement: Measurement
    base: Any  # where the base point of a gauge really is
    tools: Array
    poses: Recording
    fresh: Recording
    frame: int  # seed of the instrument's frame
    traits: tuple[str, ...]

    @classmethod
    def draw(cls, kind: str, names: tuple[str, ...], must: set[str], rng: np.random.Generator, machine: str) -> Session:
        """Draw one; `must` are channels that it has to have."""
        name, only = machines.parted(machine)
        robot = machines.draw(name, rng)
        errors, mechanism = machines.ordinary_errors(robot, rng), mechanism_of(robot)
        sigma, turn = round(float(rng.uniform(0.005, 0.02)), 4), round(float(rng.uniform(0.002, 0.01)), 4) * DEG
        have = {channel for channel, share in SHARES.items() if rng.random() < share}
        have |= must
        have |= must
        measurement, base = _measurement(kind, names, machines.kinds(mechanism), rng)
        if only:
            measurement, base = Measurement(kind=only, camera=LENS if only == "board_image" else None), None
            turn = sigma / kind_of(only).scale
        of = str(measurement.kind)
        have -= set() if of in OF_POSITIONS else {"setups"}
        several = ("instrument_offset" in names or rng.random() < 0.3) and not only
        size = robot.geometry.get("platform_radius", (50.0,))[0]
        tools = np.round(rng.uniform(-1, 1, (int(rng.integers(2, 5)) if several else 1, 3)) * [size, size, 30], 3)
        tools[:, [axis not in mechanism.axes for axis in "xyz"]] = 0.0
        n = int(np.exp(rng.uniform(np.log(180 if of == "gauge" else 60), np.log(400))))
        n = max(n // FEWER, IMAGES) if of == "board_image" else n
        start = float(rng.uniform(0, 60))
        repeats = int(rng.choice([1, 1, 1, 2, 3])) if n > 120 and of != "board_image" else 1
        poses = _poses(robot, measurement, n, repeats, tools, have, rng, start)
        after, count = 40.0 * n + 3600 * ("pause" in have), 100 // FEWER if of == "board_image" else 100
        fresh = _poses(robot, measurement, count, 1, tools, have, rng, after)
        frame = int(rng.integers(2**32))
        traits = (*sorted(have), of, f"n={n}", f"repeats={repeats}", f"tools={len(tools)}")
        traits = (*traits, *(["incremental"] if measurement.zero == "incremental" else []), measurement.frame)
        return cls(robot, errors, sigma, turn, measurement, base, tools, poses, fresh, frame, traits)

    def positions(self, at: Recording) -> Array:
        """Return where the machine with its errors stands, (N, 3) [mm]."""
        columns = tuple(f"{axis}_mm" for axis in mechanism_of(self.robot).axes)
        known = Measurement(kind="position", frame="robot")
        in_robot = dataclasses.replace(at, kind="position", measurement=known, columns=columns)
        x = np.zeros((at.n_rows, 3))
        x[:, : len(columns)] = simulate(self.robot, in_robot, self.errors).measured
        return x

    def read(
        self,
        at: Recording,
        terms: Sequence[Term] = (),
        moved: tuple[Array, Array] | None = None,
        by: Callable[..., Recording] = simulate,
    ) -> Recording:
        """Return readings without noise, with effects, or with joints and positions `moved` by what is not one."""
        if kind_of(at.kind).aims:
            return self._of_board(at, terms, moved, by)
        joints = at.joints if moved is None else at.joints + moved[0]
        mounted = at.measurement
        if self.base is not None:
            mounted = dataclasses.replace(mounted, base_point_mm=self.base)
        real = dataclasses.replace(at, joints=joints, measurement=mounted)
        done = by(self.robot, real, self.errors, terms=terms, rng=np.random.default_rng(self.frame))
        measured = done.measured
        if moved is not None and at.kind in OF_POSITIONS:
            k = moved[1].shape[1]
            measured = np.hstack([measured[:, :k] + moved[1], measured[:, k:]])
        return dataclasses.replace(
            done, joints=at.joints, channels=at.channels, measurement=at.measurement, measured=measured
        )

    def _of_board(
        self, at: Recording, terms: Sequence[Term], moved: tuple[Array, Array] | None, by: Callable[..., Recording]
    ) -> Recording:
        """Return readings of a board that lies where all poses have it, those of the recording and the fresh ones."""
        both = _joined(self.poses, self.fresh)
        own = np.arange(self.poses.n_rows) if at is self.poses else self.poses.n_rows + np.arange(self.fresh.n_rows)
        joints = both.joints.copy()
        joints[own] += 0.0 if moved is None else moved[0]
        real = dataclasses.replace(both, joints=joints)
        done = by(self.robot, real, self.errors, terms=terms, rng=np.random.default_rng(self.frame))
        return dataclasses.replace(done.subset(own), joints=at.joints, channels=at.channels, pose=at.pose, line=at.line)


def _joined(first: Recording, second: Recording) -> Recording:
    """Return a recording with the rows of another behind its own, poses told apart."""
    rows = {name: np.concatenate([getattr(first, name), getattr(second, name)]) for name in ("joints", "line", "setup")}
    pose = np.concatenate([first.pose, np.char.add("fresh ", second.pose)])
    channels = {name: np.concatenate([values, second.channels[name]]) for name, values in first.channels.items()}
    blank = np.zeros((len(pose), first.measured.shape[1]))
    return dataclasses.replace(first, **rows, pose=pose, channels=channels, measured=blank)


def _channels(n: int, have: set[str], robot: Robot, rng: np.random.Generator, start: float) -> dict[str, Array]:
    """Return channels as a shop records them, of a session that starts `start` seconds after the instrument's."""
    out: dict[str, Array] = {}
    joints = range(1, mechanism_of(robot).limbs + 1)
    t = start + np.cumsum(rng.uniform(15, 40, n))
    if "pause" in have:  # lunch
        t += 3600.0 * (np.arange(n) > n * rng.uniform(0.3, 0.7))
    if "time" in have:
        out["time_s"] = np.round(t, 0 if "round" in have else 2)
    if "cycling" in have:
        out["temp_C"] = np.round(24 + 3 * np.sign(np.sin(2 * np.pi * t / rng.uniform(1200, 2000))) + 0.2 * t / 3600, 1)
    elif "temp" in have:
        much = 0.15 if "steady" in have else 1.0
        warm = rng.uniform(2, 8) * (1 - np.exp(-t / rng.uniform(1000, 6000)))
        wave = rng.uniform(0, 2) * np.sin(2 * np.pi * t / rng.uniform(1500, 5000) + rng.uniform(0, 6))
        warmth = 20 + rng.uniform(-1, 2) + much * (warm + wave + 0.1 * rng.standard_normal(n))
        out["temp_C"] = np.round(warmth, 1 if much == 1.0 else 2)
    if "room" in have:
        out["temp_room_C"] = np.round(21 + 1.5 * np.sin(2 * np.pi * t / rng.uniform(4000, 9000)), 1)
    if "cycle" in have:  # loaded and unloaded step by step
        steps = np.array([0.0, 1.0, 2.0, 3.0, 2.0, 1.0])
        out["payload_kg"] = steps[(np.arange(n) // 5) % 6]
    elif "payload" in have:
        chosen = rng.choice([0.0, 1.0, 2.0, 3.0, 5.0], int(rng.integers(2, 4)), replace=False)
        out["payload_kg"] = rng.choice(chosen, n)
    if "approach" in have:
        forward = rng.choice([0.5, 0.5, 0.2, 0.85])
        out |= {f"approach{i}": np.where(rng.random(n) < forward, 1.0, -1.0) for i in joints}
    if "motion" in have:
        unit = file_unit(mechanism_of(robot).joint_unit)
        out |= {f"qd{i}_{unit}_s": np.round(60 * rng.standard_normal(n), 2) for i in joints}
        out |= {f"qdd{i}_{unit}_s2": np.round(800 * rng.standard_normal(n), 1) for i in joints}
    if "humidity" in have:
        out["humidity_pct"] = np.round(45 + 8 * np.sin(2 * np.pi * t / 3700 + rng.uniform(0, 6)) + rng.normal(0, 3, n))
    return out


def _poses(
    robot: Robot,
    measurement: Measurement,
    n: int,
    repeats: int,
    tools: Array,
    have: set[str],
    rng: np.random.Generator,
    start: float,
) -> Recording:
    """Return a recording without readings: `n` rows, every pose `repeats` times."""
    kind = str(measurement.kind)
    single = -(-n // repeats)
    tool = tools[rng.integers(len(tools), size=single)]
    mechanism, reads = mechanism_of(robot), kind_of(kind)
    theta = machines.joints_of_poses(robot, single, tool, rng, flat=reads.aims == "touch")
    which = np.tile(np.arange(single), repeats)[:n]
    if rng.random() < 0.6:
        which = rng.permutation(which)
    pairs = None
    if kind == "distance":
        k = int(rng.uniform(2.0, 3.5) * n)
        drawn = rng.integers(n, size=(4 * k, 2))
        pairs = np.unique(np.sort(drawn[which[drawn[:, 0]] != which[drawn[:, 1]]], axis=1), axis=0)
        pairs = rng.permutation(pairs)[:k]
    at = tuple(f"{axis}_mm" for axis in mechanism.axes)
    turned = (*at, *(f"r{axis}_deg" for axis in mechanism.turns))
    columns = {"distance": (), "gauge": ("gauge_mm",), "position": at, "pose": turned}
    unit = to_internal(mechanism.joint_unit)
    setups = 2 if "setups" in have else 1
    made = Recording(
        path=Path("recording.csv"),
        kind=kind,
        measurement=measurement,
        joint_unit=mechanism.joint_unit,
        joints=np.round(theta[which] / unit, 2 if "round" in have else 6) * unit,
        columns=columns[kind] if kind in columns else reads.columns(mechanism),
        measured=np.zeros((n, 0)),
        pose=np.array([str(i) for i in range(n)] if kind == "distance" else [str(i + 1) for i in which]),
        line=np.arange(n) + 2,
        channels=_channels(n, have, robot, rng, start),
        setup=(np.arange(n) * setups) // n,
        setup_names=tuple(str(i + 1) for i in range(setups)),
        tool=tool[which] if len(tools) > 1 else None,
        pairs=pairs,
        pair_measured=None if pairs is None else np.zeros(len(pairs)),
        pair_line=None if pairs is None else np.arange(len(pairs)) + 2,
    )
    if not reads.aims:
        return made
    x = mechanism.forward(made.joints, robot.tool, mechanism.rows(robot))[0]
    return reads.laid_out(made, x, mechanism)


def _measurement(
    kind: str, names: Sequence[str], share: Mapping[str, float], rng: np.random.Generator
) -> tuple[Measurement, Any]:
    """Return the sidecar, and where the base point of a gauge really is; `share` is how often a kind is drawn."""
    of = str(rng.choice(list(share), p=list(share.values())))
    if kind == "outside" or INSTRUMENT_ONLY & set(names):
        seen = [of for of in share if of in OF_POSITIONS]
        of = str(rng.choice(seen, p=[0.85, 0.15] if len(seen) == 2 else [1.0]))
    frame = "robot" if of in OF_POSITIONS and rng.random() < 0.1 else "unknown"
    if of != "gauge":
        return Measurement(kind=of, frame=frame), None
    nominal = np.round(rng.uniform([-300, -300, -100], [300, 300, 100]), 0)
    zero = str(rng.choice(["absolute", "incremental"]))
    base = tuple(float(v) for v in nominal + 0.2 * rng.standard_normal(3))
    return Measurement(kind=of, zero=zero, base_point_mm=tuple(map(float, nominal))), base
