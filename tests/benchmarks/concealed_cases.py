"""Concealed cases: machines with physics left out of their model, drawn from seeds and simulated exactly.

Machines, recordings and what is left out are drawn at random; compliant parts are simulated in static equilibrium. An
amplitude is such that geometry alone leaves 1.5 to 10 standard deviations of noise; a case that another explanation
fits within `MARGIN` of chi2, limb by limb, is drawn anew, so that every case has one right answer.

Public: `plan` (what to draw, reproducibly), `generate` (one case of a seed), `Case`, `Judge`, `ORDINARY`, `OUTSIDE`.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

from deltacal_gen.diagnosis.library import library
from deltacal_gen.diagnosis.search import Search
from deltacal_gen.errors import DeltacalError
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.residuals import Repeats, rms
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.prior import BROAD
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import load_mechanism, mechanism_of
from deltacal_gen.machine.rotation import from_vector, to_vector
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, blank, coefficients, load_effect
from deltacal_gen.units import DEG, file_unit, to_internal
from tests.benchmarks import concealed_machines as machines

Array = np.ndarray
MARGIN = 40.0  # of chi2 without noise: what the truth must be ahead of every other explanation
REST = 0.5  # of chi2 per reading: what the vocabulary must leave of physics that is not in it
LARGEST = 1.0  # mm: root mean square by which an effect moves the readings
LEAST, MOST = 1.5, 10.0  # standard deviations of noise that geometry alone leaves
ATTEMPTS = 40
MECHANISM = load_mechanism("delta")
NEEDS = {  # channels of a recording, by what an effect reads
    "approach": "approach",
    "qd": "motion",
    "qdd": "motion",
    "inertia_torque": "motion",
    "warming": "temp",
    "time": "time",
    "payload_torque": "payload",
}
OUTSIDE = {  # channel that tells best (the first) or also tells, and what the channels must hold
    "square_wave": (("time_s",), {"time"}),
    "local_bump": (("position",), set()),
    "covariate": (("humidity_pct",), {"humidity"}),
    "payload_hysteresis": (("payload_kg", "time_s"), {"time", "cycle"}),
    "cross_joint": (("q1_deg", "q2_deg", "q3_deg", "position"), set()),
    "thermal_lag": (("time_s", "temp_C"), {"time", "cycling"}),
    "random_walk": (("time_s",), {"time"}),
}
ORDINARY = {"null": 40, "single": 3 * len(machines.shown("delta")), "pair": 20, "outside": 2 * len(OUTSIDE)}
INSTRUMENT_ONLY = {"instrument_drift"}  # not seen in lengths
OF_POSITIONS = {"position", "pose"}


@dataclass(frozen=True)
class Case:
    """A recording, what is concealed in it, the same without noise, and 100 fresh readings without noise."""

    kind: str
    names: tuple[str, ...]
    robot: Robot
    recording: Recording
    exact: Recording
    fresh: Recording
    errors: dict[str, float]
    terms: tuple[Term, ...]
    sigma: float
    turn_sigma: float
    excess: float
    channels: tuple[str, ...] = ()
    limbs: tuple[int, ...] = ()
    traits: tuple[str, ...] = ()


def plan(
    counts: Mapping[str, int], seed: int, only: Sequence[str] = (), machine: str = "delta"
) -> list[tuple[str, tuple[str, ...], tuple[int, ...], str]]:
    """Return what is to be drawn, shuffled: (kind, names, seed, machine) of each case, the arguments of `generate`.

    Parameters
    ----------
    counts : mapping
        How many cases of each kind (null, single, pair, outside).
    only : sequence of str
        Names of effects to which singles and pairs are restricted; default all.
    machine : str
        One of `concealed_machines.MACHINES`.
    """
    out = []
    for kind, count in counts.items():
        number = list(ORDINARY).index(kind)
        rng = np.random.default_rng([seed, number])
        pool = list(OUTSIDE) if kind == "outside" else [n for n in machines.shown(machine) if not only or n in only]
        for i in range(count):
            names: tuple[str, ...] = () if kind == "null" else (pool[i % len(pool)],)
            if kind == "pair":
                names = tuple(str(n) for n in rng.choice(pool, 2, replace=False))
            out.append((kind, names, (seed, number, i), machine))
    return [out[i] for i in np.random.default_rng(seed).permutation(len(out))]


@using(Backend.COMPILED)
def generate(
    kind: str,
    names: Sequence[str],
    seed: Sequence[int],
    machine: str = "delta",
    by: Callable[..., Recording] = simulate,
) -> Case:
    """Return the case of a seed: `names` are effects, or one of `OUTSIDE`, or empty.

    `by` makes the readings, with the signature of `simulate`; amplitudes and clarity are judged on the project's own.
    """
    for attempt in range(ATTEMPTS):
        try:
            case = _attempt(kind, tuple(names), np.random.default_rng([*seed, attempt]), machine, by)
        except DeltacalError:
            continue  # a pose out of reach
        if case is not None:
            return case
    raise RuntimeError(f"no clear case of {kind} {' + '.join(names)} in {ATTEMPTS} attempts")


# ----------------------------------------------------------------------------------------------- machine and recording


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
    theta, mechanism = machines.joints_of_poses(robot, single, tool, rng), mechanism_of(robot)
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
    return Recording(
        path=Path("recording.csv"),
        kind=kind,
        measurement=measurement,
        joint_unit=mechanism.joint_unit,
        joints=np.round(theta[which] / unit, 2 if "round" in have else 6) * unit,
        columns=columns[kind],
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


# ------------------------------------------------------------------------------------------------- what is concealed


def _term(name: str, poses: Recording, robot: Robot, tools: Array, rng: np.random.Generator) -> Term:
    """Return an effect with coefficients of about the right proportions."""
    mechanism = mechanism_of(robot)
    most = mechanism.limbs
    some = min(int(rng.choice([1, 2, 3], p=[0.45, 0.2, 0.35])), most)
    limbs = tuple(sorted(int(i) for i in rng.choice(range(1, most + 1), some, replace=False)))
    constants: tuple[float, ...] = ()
    if name == "transmission_eccentricity":
        ratio = robot.transmission.gear_ratio if robot.transmission else None
        orders = [int(rng.integers(1, 13)), int(rng.integers(1, 101)), ratio or 1, 2 * (ratio or 1)]
        constants = (float(rng.choice(orders)),)
    if name == "zero_jump":
        clock = poses.channels.get("time_s", np.arange(poses.n_rows, dtype=float))
        constants = (float(np.sort(clock)[int(rng.uniform(0.15, 0.85) * len(clock))]),)
    moved = rng.permutation(tools)[: int(rng.integers(1, max(len(tools), 2)))]
    term = blank(name, limbs, constants, moved)
    sizes = {"expansion_proximal": 20e-6, "expansion_distal": 10e-6, "expansion_base": 15e-6}
    known = coefficients(load_effect(name), mechanism.joint_unit)
    values = np.array([sizes.get(c, 1e-3 * f) for c, _, f in known]) * np.ones_like(term.values)
    values *= rng.uniform(0.5, 1.5, values.shape)
    if name not in {"thermal_growth", "latency", "backlash"} and not any("compl" in c[0] for c in known):
        values *= rng.choice([-1.0, 1.0], values.shape)
    return dataclasses.replace(term, values=values)


def _parts(term: Term) -> list[Term]:
    """Return an effect on each set of its limbs, or of its tool points; an offset of all of these is another frame."""
    limbs = [s for n in range(1, len(term.limbs) + 1) for s in itertools.combinations(term.limbs, n)] or [()]
    tools = [s for n in range(1, len(term.tools)) for s in itertools.combinations(term.tools, n)] or [()]
    return [blank(term.effect, ls, term.constants, ts, term.lacks) for ls in limbs for ts in tools]


def readings(recording: Recording) -> Array:
    """Return what was measured (R, k)."""
    return recording.measured if recording.pair_measured is None else recording.pair_measured[:, None]


@dataclass
class Foreign:
    """Physics outside the vocabulary, unit amplitude: an error of a joint [rad] or of the reading [mm]."""

    name: str
    limb: int
    draw: tuple[float, ...]
    walk: Array
    direction: Array
    centre: Array
    axes: tuple[str, ...]

    def shift(self, rec: Recording, x: Array, first: Recording) -> tuple[Array, Array]:
        """Return the errors of joints (N, 3) and of readings (N, 3) at positions x in {O}."""
        c, n = rec.channels, rec.n_rows
        joint, reading = np.zeros(rec.joints.shape), np.zeros((n, 3))
        t = c.get("time_s", np.arange(n))
        i = self.limb - 1
        if self.name == "square_wave":
            span = np.ptp(first.channels["time_s"])
            joint[:, i] = np.sign(np.sin(2 * np.pi * t / span * (2 + 3 * self.draw[0])))
        elif self.name == "local_bump":
            reach = np.ptp(x, axis=0).max() * (0.1 + 0.08 * self.draw[0])
            bump = np.exp(-(((x - self.centre) / reach) ** 2).sum(axis=1) / 2)
            reading = 100 * bump[:, None] * self.direction
        elif self.name == "covariate":
            joint[:, i] = (c["humidity_pct"] - 45) / 10
        elif self.name == "payload_hysteresis":
            p = c["payload_kg"]
            last = np.concatenate([[1.0], np.sign(np.diff(p))])
            for k in range(1, n):
                last[k] = last[k] or last[k - 1]
            joint[:, i] = np.where(last < 0, 1.0, 0.0) * p * (p.max() - p) / 2
        elif self.name == "cross_joint":
            other = rec.joints[:, (i + 1 + (self.draw[0] > 0.5)) % rec.joints.shape[1]]
            joint[:, i] = np.cos((3 + 4 * self.draw[1]) * other + 6 * self.draw[2])
        elif self.name == "thermal_lag":
            lag, tau = np.empty(n), 900 + 600 * self.draw[0]
            lag[0] = c["temp_C"][0]
            for k in range(1, n):
                lag[k] = c["temp_C"][k] + (lag[k - 1] - c["temp_C"][k]) * np.exp(-(t[k] - t[k - 1]) / tau)
            joint[:, i] = (lag - 24) / 3
        elif self.name == "random_walk":
            at = np.minimum(np.searchsorted(first.channels["time_s"], t), len(self.walk) - 1)
            reading = 100 * self.walk[at] / np.sqrt(len(self.walk))
        return 1e-3 * to_internal(rec.joint_unit) * joint, 1e-3 * reading[:, : len(self.axes)]

    @classmethod
    def draw_one(cls, name: str, x: Array, robot: Robot, rng: np.random.Generator) -> Foreign:
        """Return one at random."""
        mechanism, direction = mechanism_of(robot), rng.standard_normal(3)
        return cls(
            name,
            int(rng.integers(1, mechanism.limbs + 1)),
            tuple(rng.random(3)),
            np.cumsum(rng.standard_normal((len(x), 3)), axis=0),
            direction / np.linalg.norm(direction),
            x[int(rng.integers(len(x)))],
            mechanism.axes,
        )


class Judge:
    """The linear problem without noise: what of a displacement geometry leaves, and what else would explain it.

    `exact` is the recording of a machine with `errors` and nothing left out, without noise.
    """

    def __init__(self, robot: Robot, exact: Recording, errors: Mapping[str, float], sigma: float, turn: float) -> None:
        self.robot, mechanism = robot, mechanism_of(robot)
        self.names = tuple(p.name for p in mechanism.parameters)
        self.errors = mechanism.vector(errors)
        self.problem = self._of(exact)
        self.instrument = self.problem.begin(self.errors)
        self.machine = self.problem.solve(self.errors)
        state = self.problem.linearise(self.errors, self.instrument, self.machine)
        self.sigma = np.array([sigma] * 3 + [turn] * 3)[: state.residual.shape[1]]
        n, A = len(self.names), np.concatenate([state.J_p * self.problem.scale, state.J_m], axis=2)
        A = (A / self.sigma[:, None]).reshape(-1, A.shape[2])
        self.scalars = readings(exact).size
        prior = np.concatenate([np.eye(n), np.zeros((n, A.shape[1] - n))], axis=1)
        self.Q = np.linalg.qr(np.vstack([A, prior]))[0][: len(A)]

    def _of(self, recording: Recording) -> Problem:
        problem = pose_problem(self.robot, recording, self.names)
        return dataclasses.replace(problem, scale=BROAD * problem.scale)

    def departure(self, recording: Recording) -> Array:
        """Return what another recording of the same poses reads beyond this machine (R, k) [mm, rad]."""
        off = self._of(recording).residual(self.errors, self.instrument, self.machine.x)
        return np.nan_to_num(off)  # a planar machine reads not all coordinates

    def misfit(self, recording: Recording) -> float:
        """Return chi2 that geometry and instrument leave of a recording of the same poses."""
        r = (self.departure(recording) / self.sigma).ravel()
        return float(np.sum((r - self.Q @ (self.Q.T @ r)) ** 2))

    def search(self, exact: Recording) -> Search:
        """Return the search for effects on readings without noise."""
        problem = self._of(exact)
        found = SimpleNamespace(
            problem=problem,
            errors=self.errors,
            machine=problem.solve(self.errors),
            instrument=self.instrument,
            weights=np.ones(len(problem.readings)),
            sigma=self.sigma,
            repeats=Repeats(problem.readings.group),
        )
        return Search(found, library(problem)[0])  # type: ignore[arg-type]

    def loss(self, exact: Recording, terms: Sequence[Term], index: int, rival: str) -> float:
        """Return what chi2 loses, without noise, where a rival stands for one of the true effects."""
        search = self.search(exact)
        best = search.gain([j for t in terms for j in search.where(t)])
        others = [j for k, t in enumerate(terms) if k != index for j in search.where(t)]
        gains = [search.gain([*others, *search.where(c)]) for c in search.terms if c.effect == rival]
        return best - max(gains, default=0.0)

    def clear(self, exact: Recording, terms: Sequence[Term]) -> bool:
        """Tell whether nothing but the true effects comes near the truth."""
        search = self.search(exact)
        own = [search.where(t) for t in terms]
        if not all(own):
            return False
        best = search.gain([j for columns in own for j in columns])
        for i, term in enumerate(terms):
            other = [j for k, columns in enumerate(own) if k != i for j in columns]
            if search.gain(other) > best - 2 * MARGIN:
                return False
            others = [t for k, t in enumerate(terms) if k != i]
            limbs = range(1, mechanism_of(self.robot).limbs + 1)
            wider = [j for t in others for j in search.where(blank(t.effect, limbs, t.constants, t.tools))]
            if search.gain(wider) > best - MARGIN:
                return False  # another effect, at more limbs, could stand for it
            for c in search.terms:
                same = c.effect == term.effect
                if any(c.effect == t.effect for t in terms if t is not term) or (same and c.tools):
                    continue
                near = c.effect == "zero_jump" == term.effect  # a neighbouring time is no other explanation
                if search.gain([*other, *search.where(c)]) < best - MARGIN:
                    continue
                for part in _parts(c):
                    right = same and set(part.limbs) >= set(term.limbs)
                    if right and (near or c.constants == term.constants):
                        continue
                    if search.gain([*other, *search.where(part)]) > best - MARGIN:
                        return False
        return True

    def foreign(self, exact: Recording) -> bool:
        """Tell whether three effects of the vocabulary leave enough of physics that is not in it."""
        search = self.search(exact)
        left, chosen, names = self.misfit(exact), [], set()
        for _ in range(3):
            others = [c for c in search.terms if c.effect not in names]
            gain, _, best = max((search.gain([*chosen, *search.where(c)]), i, c) for i, c in enumerate(others))
            chosen, names = [*chosen, *search.where(best)], {*names, best.effect}
        return left - gain > REST * search.readings


def _attempt(
    kind: str, names: tuple[str, ...], rng: np.random.Generator, machine: str, by: Callable[..., Recording]
) -> Case | None:
    robot = machines.draw(machine, rng)
    errors, mechanism = machines.ordinary_errors(robot, rng), mechanism_of(robot)
    sigma, turn = round(float(rng.uniform(0.005, 0.02)), 4), round(float(rng.uniform(0.002, 0.01)), 4) * DEG
    have = {c for c, p in (("time", 0.75), ("temp", 0.6), ("payload", 0.5), ("approach", 0.6)) if rng.random() < p}
    have |= {c for c, p in (("motion", 0.25), ("humidity", 0.15), ("room", 0.1)) if rng.random() < p}
    have |= {c for c, p in (("pause", 0.15), ("steady", 0.15), ("round", 0.15), ("setups", 0.1)) if rng.random() < p}
    if kind == "outside":
        have |= OUTSIDE[names[0]][1]
    else:
        have |= {NEEDS[s] for name in names for s in load_effect(name).STATE if s in NEEDS}
    measurement, base = _measurement(kind, names, machines.kinds(mechanism), rng)
    of = str(measurement.kind)
    have -= set() if of in OF_POSITIONS else {"setups"}
    several = "instrument_offset" in names or rng.random() < 0.3
    size = robot.geometry.get("platform_radius", (50.0,))[0]
    tools = np.round(rng.uniform(-1, 1, (int(rng.integers(2, 5)) if several else 1, 3)) * [size, size, 30], 3)
    tools[:, [axis not in mechanism.axes for axis in "xyz"]] = 0.0
    n = int(np.exp(rng.uniform(np.log(180 if of == "gauge" else 60), np.log(400))))
    start = float(rng.uniform(0, 60))
    repeats = int(rng.choice([1, 1, 1, 2, 3])) if n > 120 else 1
    poses = _poses(robot, measurement, n, repeats, tools, have, rng, start)
    fresh = _poses(robot, measurement, 100, 1, tools, have, rng, 40.0 * n + 3600 * ("pause" in have))
    frame = int(rng.integers(2**32))

    def read(
        at: Recording,
        terms: Sequence[Term] = (),
        foreign: Foreign | None = None,
        much: float = 0.0,
        by: Callable[..., Recording] = simulate,
    ) -> Recording:
        joint, shift = np.zeros(at.joints.shape), np.zeros((at.n_rows, len(mechanism.axes)))
        if foreign is not None:
            known = Measurement(kind="position", frame="robot")
            columns = tuple(f"{axis}_mm" for axis in mechanism.axes)
            in_robot = dataclasses.replace(at, kind="position", measurement=known, columns=columns)
            x = np.zeros((at.n_rows, 3))
            x[:, : len(columns)] = simulate(robot, in_robot, errors).measured
            joint, shift = foreign.shift(at, x, poses)
        mounted = at.measurement if base is None else dataclasses.replace(at.measurement, base_point_mm=base)
        moved = dataclasses.replace(at, joints=at.joints + much * joint, measurement=mounted)
        done = by(robot, moved, errors, terms=terms, rng=np.random.default_rng(frame))
        measured = done.measured
        if foreign is not None and at.kind in OF_POSITIONS:
            k = shift.shape[1]
            measured = np.hstack([measured[:, :k] + much * shift, measured[:, k:]])
        return dataclasses.replace(
            done, joints=at.joints, channels=at.channels, measurement=at.measurement, measured=measured
        )

    plain = read(poses)
    judge = Judge(robot, plain, errors, sigma, turn)
    terms: list[Term] = []
    make: Callable[..., Recording] = read
    if kind == "outside":
        x = judge.machine.x[:, :3]
        foreign, much, wanted = Foreign.draw_one(names[0], x, robot, rng), 1.0, float(rng.uniform(2, MOST))
        for _ in range(2):
            much *= wanted * np.sqrt(judge.scalars / judge.misfit(read(poses, (), foreign, much)))
        make = lambda at, by=simulate: read(at, (), foreign, much, by)  # noqa: E731
    elif names:
        for name in names:
            term = _term(name, poses, robot, tools, rng)
            wanted = float(np.exp(rng.uniform(np.log(LEAST), np.log(MOST))))
            for _ in range(3):
                left = judge.misfit(read(poses, [term]))
                if left <= 1e-12:
                    return None
                term = term.with_values(term.values.ravel() * wanted * np.sqrt(judge.scalars / left))
            terms.append(term)
        if any(rms(judge.departure(read(poses, [t]))) > LARGEST for t in terms if t.effect not in INSTRUMENT_ONLY):
            return None  # an effect that hardly shows, blown up
        late = [dataclasses.replace(t, constants=(-1.0,)) if _unplaced(t, poses) else t for t in terms]
        make = lambda at, by=simulate: read(at, late if at is fresh else terms, by=by)  # noqa: E731
    exact = make(poses)
    excess = float(np.sqrt(judge.misfit(exact) / judge.scalars))
    if kind == "outside" and not judge.foreign(exact):
        return None
    if terms and not (0.95 * LEAST < excess < 1.1 * MOST and judge.clear(exact, terms)):
        return None
    if by is not simulate:
        exact = make(poses, by=by)
    noisy, traits = _noisy(exact, sigma, turn, rng)
    traits = (*traits, *sorted(have), of, f"n={n}", f"repeats={repeats}", f"tools={len(tools)}")
    traits = (*traits, *(["incremental"] if measurement.zero == "incremental" else []), measurement.frame)
    channels, limbs = OUTSIDE[names[0]][0] if kind == "outside" else (), ()
    if kind == "outside" and names[0] not in ("local_bump", "random_walk"):
        limbs = (foreign.limb,)
    return Case(
        kind,
        names,
        robot,
        noisy,
        exact,
        make(fresh, by=by),
        errors,
        tuple(terms),
        sigma,
        turn,
        excess,
        channels,
        limbs,
        traits,
    )


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


def _unplaced(term: Term, poses: Recording) -> bool:
    return term.effect == "zero_jump" and "time_s" not in poses.channels


def _noisy(exact: Recording, sigma: float, turn: float, rng: np.random.Generator) -> tuple[Recording, tuple[str, ...]]:
    values = readings(exact)
    noise, traits = rng.standard_normal(values.shape), []
    if rng.random() < 0.15:
        noise = rng.standard_t(4, values.shape) / np.sqrt(2)
        traits.append("heavy")
    if rng.random() < 0.25:
        bad = rng.choice(len(values), max(int(rng.uniform(0.01, 0.04) * len(values)), 1), replace=False)
        noise[bad] += rng.choice([-1, 1], (len(bad), values.shape[1])) * rng.uniform(10, 60, (len(bad), 1))
        traits.append("outliers")
    sigmas = [sigma if column.endswith("_mm") else turn for column in exact.columns] or [sigma]
    noisy = values + np.asarray(sigmas) * noise
    if exact.kind == "pose" and len(sigmas) == 6:
        turned = from_vector(turn * noise[:, 3:]) @ from_vector(values[:, 3:])
        noisy = np.hstack([noisy[:, :3], to_vector(turned)])
    if exact.measurement.zero == "incremental":
        noisy = noisy - noisy[0]
    measurement = exact.measurement
    if rng.random() < 0.5:
        measurement = dataclasses.replace(measurement, sigma_mm=sigma)
        traits.append("declared")
    if exact.pair_measured is not None:
        return dataclasses.replace(exact, pair_measured=noisy[:, 0], measurement=measurement), tuple(traits)
    return dataclasses.replace(exact, measured=noisy, measurement=measurement), tuple(traits)
