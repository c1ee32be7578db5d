"""Concealed recordings: what the diagnosis names on machines of which it knows nothing, against what is the case.

``python -m tests.benchmarks.concealed [--cases N] [--kinds null,single,pair,outside] [--jobs 2] [--seed S]``

Machines, recordings and what is left out are drawn from fixed seeds and simulated exactly, compliant parts in static
equilibrium. An amplitude is such that geometry alone leaves 1.5 to 10 standard deviations of noise; a case that another
explanation fits within `MARGIN` of chi2 is drawn anew, so that every case has one right answer.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy is loaded

import argparse
import collections
import dataclasses
import json
import multiprocessing
import sys
import time
import traceback
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
from rich.console import Console
from rich.progress import Progress
from rich.table import Table

from deltacal_gen.diagnosis import Candidate, Search, diagnose, library
from deltacal_gen.errors import DeltacalError, NoSolutionError
from deltacal_gen.estimation import Fit, Problem, Repeats, fit, pose_problem, rms
from deltacal_gen.identification import BROAD, rough
from deltacal_gen.mechanism import load_mechanism
from deltacal_gen.physics import Term, blank, effect_names, load_effect, term_to_dict
from deltacal_gen.prediction import predict
from deltacal_gen.recording import Measurement, Recording
from deltacal_gen.robot import Robot, robot_from_dict, robot_to_dict
from deltacal_gen.simulation import simulate
from deltacal_gen.solvers import Prior
from deltacal_gen.units import DEG

Array = np.ndarray
MARGIN = 40.0  # of chi2 without noise: what the truth must be ahead of every other explanation
REST = 0.5  # of chi2 per reading: what the vocabulary must leave of physics that is not in it
LARGEST = 1.0  # mm: root mean square by which an effect moves the readings
ATTEMPTS = 120
MECHANISM = load_mechanism("delta")
PARAMETERS = tuple(p.name for p in MECHANISM.parameters)
TYPICAL = {"theta": 0.05 * DEG, "length": 0.1, "angle": 0.03 * DEG}  # of machined parts
NEEDS = {  # channels of a recording, by what an effect reads
    "approach": "approach",
    "speed": "motion",
    "acceleration": "motion",
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
ORDINARY = {"null": 40, "single": 3 * len(effect_names()), "pair": 20, "outside": 2 * len(OUTSIDE)}
CONVENTION = {"joint_axis_runout", "instrument_offset"}  # parameters that are equal up to the geometry


@dataclass(frozen=True)
class Case:
    """A recording, what is concealed in it, and 100 fresh readings without noise (`fresh`, measured)."""

    kind: str
    names: tuple[str, ...]
    robot: Robot
    recording: Recording
    fresh: Recording
    terms: tuple[Term, ...]
    sigma: float
    excess: float
    channels: tuple[str, ...] = ()
    limbs: tuple[int, ...] = ()
    traits: tuple[str, ...] = ()


def generate(kind: str, names: Sequence[str], seed: Sequence[int]) -> Case:
    """Return the case of a seed: `names` are effects, or one of `OUTSIDE`, or empty."""
    for attempt in range(ATTEMPTS):
        try:
            case = _attempt(kind, tuple(names), np.random.default_rng([*seed, attempt]))
        except DeltacalError:
            continue  # a pose out of reach
        if case is not None:
            return case
    raise RuntimeError(f"no clear case of {kind} {' + '.join(names)} in {ATTEMPTS} attempts")


# ----------------------------------------------------------------------------------------------- machine and recording


def _machine(rng: np.random.Generator) -> Robot:
    s = rng.choice([0.55, 0.8, 1.0, 1.2])
    sizes = {"base_radius": 200, "platform_radius": 51, "proximal_length": 375, "distal_length": 950}
    tables: dict[str, Any] = {
        "robot": {"name": "delta", "mechanism": "delta"},
        "geometry": {k: round(float(v * s * rng.uniform(0.97, 1.03)), 1) for k, v in sizes.items()}
        | {"joint_spacing": round(float(100 * s), 1), "tool": [0.0, 0.0, 0.0]},
        "workspace": {"top": 728.0 * s, "radius": 480.0 * s, "height": 250.0 * s},
        "masses": {
            "proximal": round(float(1.2 * s * rng.uniform(0.7, 1.4)), 3),
            "proximal_com": round(float(rng.uniform(0.35, 0.5)), 3),
            "distal_rod": round(float(0.15 * s * rng.uniform(0.7, 1.4)), 3),
            "platform": round(float(0.8 * s * rng.uniform(0.7, 1.4)), 3),
        },
    }
    if rng.random() < 0.4:
        tables["transmission"] = {"gear_ratio": float(rng.choice([16.0, 20.0, 21.0, 33.0, 50.5]))}
    return robot_from_dict(tables)


def _errors(rng: np.random.Generator) -> dict[str, float]:
    def size(name: str, unit: str) -> float:
        return TYPICAL["theta" if name.startswith("theta") else "length" if unit == "mm" else "angle"]

    return {p.name: float(size(p.name, p.unit) * rng.standard_normal()) for p in MECHANISM.parameters}


def _targets(robot: Robot, n: int, rings: bool, rng: np.random.Generator) -> Array:
    space = robot.workspace
    assert space is not None
    assert space.radius is not None
    if rings:
        per = int(rng.choice([8, 12, 18]))
        k = np.arange(n)
        layers = int(rng.integers(3, 6))
        count = max(int(np.ceil(n / per / layers)), 1)
        radius = space.radius * (1 + (k // per) % count) / count
        angle = 2 * np.pi * (k % per) / per + rng.uniform(0, 1)
        height = np.minimum((k // (per * count)) / max(layers - 1, 1), 1.0)
    else:
        radius, angle = space.radius * np.sqrt(rng.random(n)), 2 * np.pi * rng.random(n)
        height = rng.random(n)
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), -space.top - space.height * height])


def _channels(n: int, have: set[str], rng: np.random.Generator, start: float) -> dict[str, Array]:
    """Return channels as a shop records them, of a session that starts `start` seconds after the instrument's."""
    out: dict[str, Array] = {}
    t = start + np.cumsum(rng.uniform(15, 40, n))
    if "time" in have:
        out["time_s"] = np.round(t, 2)
    if "cycling" in have:
        out["temp_C"] = np.round(24 + 3 * np.sign(np.sin(2 * np.pi * t / rng.uniform(1200, 2000))) + 0.2 * t / 3600, 1)
    elif "temp" in have:
        warm = rng.uniform(2, 8) * (1 - np.exp(-t / rng.uniform(1000, 6000)))
        wave = rng.uniform(0, 2) * np.sin(2 * np.pi * t / rng.uniform(1500, 5000) + rng.uniform(0, 6))
        out["temp_C"] = np.round(20 + rng.uniform(-1, 2) + warm + wave + 0.1 * rng.standard_normal(n), 1)
    if "cycle" in have:  # loaded and unloaded step by step
        steps = np.array([0.0, 1.0, 2.0, 3.0, 2.0, 1.0])
        out["payload_kg"] = steps[(np.arange(n) // 5) % 6]
    elif "payload" in have:
        chosen = rng.choice([0.0, 1.0, 2.0, 3.0, 5.0], int(rng.integers(2, 4)), replace=False)
        out["payload_kg"] = rng.choice(chosen, n)
    if "approach" in have:
        out |= {f"approach{i}": rng.choice([-1.0, 1.0], n) for i in (1, 2, 3)}
    if "motion" in have:
        out |= {f"qd{i}_deg_s": np.round(60 * rng.standard_normal(n), 2) for i in (1, 2, 3)}
        out |= {f"qdd{i}_deg_s2": np.round(800 * rng.standard_normal(n), 1) for i in (1, 2, 3)}
    if "humidity" in have:
        out["humidity_pct"] = np.round(45 + 8 * np.sin(2 * np.pi * t / 3700 + rng.uniform(0, 6)) + rng.normal(0, 3, n))
    return out


def _poses(
    robot: Robot, kind: str, n: int, repeats: int, tools: Array, have: set[str], rng: np.random.Generator, start: float
) -> Recording:
    """Return a recording without readings: `n` rows, every pose `repeats` times."""
    single = -(-n // repeats)
    tool = tools[rng.integers(len(tools), size=single)]
    theta, _, status = MECHANISM.inverse(
        _targets(robot, single, rng.random() < 0.5, rng), tool, MECHANISM.rows(robot, np.zeros(len(PARAMETERS)))
    )
    if (status != 0).any():
        raise RuntimeError("the workspace is larger than the machine's reach")
    which = np.tile(np.arange(single), repeats)[:n]
    if rng.random() < 0.6:
        which = rng.permutation(which)
    pairs = None
    if kind == "distance":
        k = int(rng.uniform(2.0, 3.5) * n)
        drawn = rng.integers(n, size=(4 * k, 2))
        pairs = np.unique(np.sort(drawn[which[drawn[:, 0]] != which[drawn[:, 1]]], axis=1), axis=0)
        pairs = rng.permutation(pairs)[:k]
    return Recording(
        path=Path("recording.csv"),
        kind=kind,
        measurement=Measurement(kind=kind, frame="unknown"),
        joint_unit="rad",
        joints=np.round(theta[which] / DEG, 6) * DEG,
        columns=() if kind == "distance" else ("x_mm", "y_mm", "z_mm"),
        measured=np.zeros((n, 0)),
        pose=np.array([str(i) for i in range(n)] if kind == "distance" else [str(i + 1) for i in which]),
        line=np.arange(n) + 2,
        channels=_channels(n, have, rng, start),
        setup=np.zeros(n, dtype=int),
        setup_names=("1",),
        tool=tool[which] if len(tools) > 1 else None,
        pairs=pairs,
        pair_measured=None if pairs is None else np.zeros(len(pairs)),
        pair_line=None if pairs is None else np.arange(len(pairs)) + 2,
    )


# ------------------------------------------------------------------------------------------------- what is concealed


def _term(name: str, poses: Recording, robot: Robot, tools: Array, rng: np.random.Generator) -> Term:
    """Return an effect with coefficients of about the right proportions."""
    kernels = load_effect(name)
    limbs = (1, 2, 3) if rng.random() < 0.4 else (int(rng.integers(1, 4)),)
    constants: tuple[float, ...] = ()
    tool = None
    if name == "transmission_eccentricity":
        ratio = robot.transmission.gear_ratio if robot.transmission else None
        orders = [int(rng.integers(1, 13)), int(rng.integers(1, 101)), ratio or 1, 2 * (ratio or 1)]
        constants = (float(rng.choice(orders)),)
    if name == "zero_jump":
        clock = poses.channels.get("time_s", np.arange(poses.n_rows, dtype=float))
        constants = (float(np.sort(clock)[int(rng.uniform(0.15, 0.85) * len(clock))]),)
    if name == "instrument_offset":
        tool = tools[int(rng.integers(len(tools)))]
    term = blank(name, limbs, constants, tool)
    sizes = {"expansion_proximal": 20e-6, "expansion_distal": 10e-6, "expansion_base": 15e-6}
    values = np.array([sizes.get(c, 1e-3 * f) for c, _, f, _ in kernels.COEFFICIENTS]) * np.ones_like(term.values)
    values *= rng.uniform(0.5, 1.5, values.shape)
    if name not in {"thermal_growth", "latency", "backlash"} and not any("compl" in c[0] for c in kernels.COEFFICIENTS):
        values *= rng.choice([-1.0, 1.0], values.shape)
    return dataclasses.replace(term, values=values)


@dataclass
class Foreign:
    """Physics outside the vocabulary, unit amplitude: an error of a joint [rad] or of the reading [mm]."""

    name: str
    limb: int
    draw: tuple[float, ...]
    walk: Array
    direction: Array
    centre: Array

    def shift(self, rec: Recording, x: Array, first: Recording) -> tuple[Array, Array]:
        """Return the errors of joints (N, 3) and of readings (N, 3) at positions x in {O}."""
        c, n = rec.channels, rec.n_rows
        joint, reading = np.zeros((n, 3)), np.zeros((n, 3))
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
            other = rec.joints[:, (i + 1 + (self.draw[0] > 0.5)) % 3]
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
        return 1e-3 * DEG * joint, 1e-3 * reading

    @classmethod
    def draw_one(cls, name: str, x: Array, rng: np.random.Generator) -> Foreign:
        """Return one at random."""
        direction = rng.standard_normal(3)
        return cls(
            name,
            int(rng.integers(1, 4)),
            tuple(rng.random(3)),
            np.cumsum(rng.standard_normal((len(x), 3)), axis=0),
            direction / np.linalg.norm(direction),
            x[int(rng.integers(len(x)))],
        )


class Judge:
    """The linear problem without noise: what of a displacement geometry leaves, and what else would explain it."""

    def __init__(self, robot: Robot, exact: Recording, errors: dict[str, float], sigma: float) -> None:
        self.robot, self.errors, self.sigma = robot, MECHANISM.vector(errors), sigma
        self.problem = self._of(exact)
        self.plain = self.problem.readings.values
        self.instrument = self.problem.begin(self.errors)
        state = self.problem.linearise(self.errors, self.instrument)
        n, A = len(PARAMETERS), np.concatenate([state.J_p * self.problem.scale, state.J_m], axis=2) / sigma
        A = A.reshape(-1, A.shape[2])
        prior = np.concatenate([np.eye(n), np.zeros((n, A.shape[1] - n))], axis=1)
        self.Q = np.linalg.qr(np.vstack([A, prior]))[0][: len(A)]

    def _of(self, recording: Recording) -> Problem:
        problem = pose_problem(self.robot, recording, PARAMETERS)
        return dataclasses.replace(problem, scale=BROAD * problem.scale)

    def misfit(self, values: Array) -> float:
        """Return chi2 that geometry and instrument leave of readings."""
        r = (values - self.plain).ravel() / self.sigma
        return float(np.sum((r - self.Q @ (self.Q.T @ r)) ** 2))

    def search(self, exact: Recording) -> Search:
        """Return the search for effects on readings without noise."""
        problem = self._of(exact)
        R = len(problem.readings)
        found = SimpleNamespace(
            problem=problem,
            errors=self.errors,
            instrument=self.instrument,
            weights=np.ones(R),
            sigma=np.full(problem.readings.values.shape[1], self.sigma),
            repeats=Repeats(problem.readings.group),
        )
        return Search(found, library(problem)[0])  # type: ignore[arg-type]

    def clear(self, exact: Recording, terms: Sequence[Term]) -> bool:
        """Tell whether nothing but the true effects comes near the truth."""
        search = self.search(exact)
        own = []
        for t in terms:
            same = [c for c in search.candidates if c.name == t.effect and c.term.constants == t.constants]
            if t.tool is None and not same:
                return False
            own.append(same[0] if t.tool is None else next((c for c in same if c.term.tool == t.tool), same[-1]))
        best = search.gain([j for c, t in zip(own, terms, strict=True) for j in c.columns(t.limbs)])
        for i, (mine, term) in enumerate(zip(own, terms, strict=True)):
            other = [j for k, (c, t) in enumerate(zip(own, terms, strict=True)) if k != i for j in c.columns(t.limbs)]
            if search.gain(other) > best - 2 * MARGIN:
                return False
            for c in search.candidates:
                if any(c.name == t.effect for t in terms if t is not term) or (c.name == term.effect and c.term.tool):
                    continue
                near = c.name == "zero_jump" == mine.name  # a neighbouring time is no other explanation
                if search.gain([*other, *c.columns(c.term.limbs)]) < best - MARGIN:
                    continue
                for limbs in c.subsets():
                    right = c.name == term.effect and set(limbs) >= set(term.limbs)
                    if right and (near or c.term.constants == term.constants):
                        continue
                    if search.gain([*other, *c.columns(limbs)]) > best - MARGIN:
                        return False
        return True

    def foreign(self, exact: Recording) -> bool:
        """Tell whether three effects of the vocabulary leave enough of physics that is not in it."""
        search = self.search(exact)
        left, chosen, names = self.misfit(self._of(exact).readings.values), [], set()
        for _ in range(3):
            others = [c for c in search.candidates if c.name not in names]
            gain, _, best = max((search.gain([*chosen, *_all(c)]), i, c) for i, c in enumerate(others))
            chosen, names = [*chosen, *_all(best)], {*names, best.name}
        return left - gain > REST * search.readings


def _all(c: Candidate) -> list[int]:
    return c.columns(c.term.limbs)


def _attempt(kind: str, names: tuple[str, ...], rng: np.random.Generator) -> Case | None:
    robot, errors = _machine(rng), _errors(rng)
    sigma = round(float(rng.uniform(0.005, 0.02)), 4)
    have = {c for c, p in (("time", 0.75), ("temp", 0.6), ("payload", 0.5), ("approach", 0.6)) if rng.random() < p}
    have |= {c for c, p in (("motion", 0.25), ("humidity", 0.15)) if rng.random() < p}
    of = "distance" if kind != "outside" and rng.random() < 0.2 and "instrument_drift" not in names else "position"
    if kind == "outside":
        have |= OUTSIDE[names[0]][1]
    else:
        have |= {NEEDS[s] for name in names for s in load_effect(name).STATE if s in NEEDS}
    several = "instrument_offset" in names or rng.random() < 0.25
    size = robot.geometry["platform_radius"][0]
    tools = np.round(rng.uniform(-1, 1, (int(rng.integers(2, 4)) if several else 1, 3)) * [size, size, 30], 3)
    n = int(rng.integers(80, 261))
    start = float(rng.uniform(0, 60))
    repeats = int(rng.choice([1, 1, 1, 2, 3])) if n > 120 else 1
    poses = _poses(robot, of, n, repeats, tools, have, rng, start)
    fresh = _poses(robot, of, 100, 1, tools, have, rng, 40.0 * n)
    frame = (0.3 * rng.standard_normal(3), 1000 * rng.standard_normal(3))

    def read(at: Recording, terms: Sequence[Term] = (), foreign: Foreign | None = None, much: float = 0.0) -> Recording:
        if foreign is None:
            done = simulate(robot, at, errors, terms=terms, frame=frame)
            return dataclasses.replace(done, channels=at.channels)
        x = simulate(robot, at, errors, frame=(np.zeros(3), np.zeros(3))).measured
        joint, shift = foreign.shift(at, x, poses)
        done = simulate(robot, dataclasses.replace(at, joints=at.joints + much * joint), errors, frame=frame)
        return dataclasses.replace(done, joints=at.joints, channels=at.channels, measured=done.measured + much * shift)

    exact = read(poses)
    judge = Judge(robot, exact, errors, sigma)
    scalars = judge.plain.size
    terms: list[Term] = []
    make: Callable[[Recording], Recording] = read
    if kind == "outside":
        x = simulate(robot, poses, errors, frame=(np.zeros(3), np.zeros(3))).measured
        foreign, much, wanted = Foreign.draw_one(names[0], x, rng), 1.0, float(rng.uniform(2, 10))
        for _ in range(2):
            much *= wanted * np.sqrt(scalars / judge.misfit(read(poses, (), foreign, much).measured))
        make = lambda at: read(at, (), foreign, much)  # noqa: E731
    elif names:
        for name in names:
            term = _term(name, poses, robot, tools, rng)
            wanted = float(np.exp(rng.uniform(np.log(1.5), np.log(10.0))))
            for _ in range(3):
                left = judge.misfit(_values(read(poses, [term])))
                if left <= 1e-12:
                    return None
                term = term.with_values(term.values.ravel() * wanted * np.sqrt(scalars / left))
            terms.append(term)
        if any(rms(_values(read(poses, [t])) - judge.plain) > LARGEST for t in terms if t.effect != "instrument_drift"):
            return None  # an effect that hardly shows, blown up
        late = [dataclasses.replace(t, constants=(-1.0,)) if _unplaced(t, poses) else t for t in terms]
        make = lambda at: read(at, late if at is fresh else terms)  # noqa: E731
    exact = make(poses)
    excess = float(np.sqrt(judge.misfit(_values(exact)) / scalars))
    if names and not (judge.foreign(exact) if kind == "outside" else 1.4 < excess < 15 and judge.clear(exact, terms)):
        return None
    noisy, traits = _noisy(exact, sigma, rng)
    traits = (*traits, *sorted(have), of, f"n={n}", f"repeats={repeats}", f"tools={len(tools)}")
    channels, limbs = OUTSIDE[names[0]][0] if kind == "outside" else (), ()
    if kind == "outside" and names[0] not in ("local_bump", "random_walk"):
        limbs = (foreign.limb,)
    return Case(kind, names, robot, noisy, make(fresh), tuple(terms), sigma, excess, channels, limbs, traits)


def _unplaced(term: Term, poses: Recording) -> bool:
    return term.effect == "zero_jump" and "time_s" not in poses.channels


def _values(recording: Recording) -> Array:
    values = recording.measured if recording.pair_measured is None else recording.pair_measured[:, None]
    assert values is not None
    return values


def _noisy(exact: Recording, sigma: float, rng: np.random.Generator) -> tuple[Recording, tuple[str, ...]]:
    values = _values(exact)
    noise, traits = rng.standard_normal(values.shape), []
    if rng.random() < 0.15:
        noise = rng.standard_t(4, values.shape) / np.sqrt(2)
        traits.append("heavy")
    if rng.random() < 0.25:
        bad = rng.choice(len(values), max(int(rng.uniform(0.01, 0.03) * len(values)), 1), replace=False)
        noise[bad] += rng.choice([-1, 1], (len(bad), values.shape[1])) * rng.uniform(10, 60, (len(bad), 1))
        traits.append("outliers")
    noisy = values + sigma * noise
    measurement = exact.measurement
    if rng.random() < 0.5:
        measurement = measurement.model_copy(update={"sigma_mm": sigma})
        traits.append("declared")
    if exact.pair_measured is not None:
        return dataclasses.replace(exact, pair_measured=noisy[:, 0], measurement=measurement), tuple(traits)
    return dataclasses.replace(exact, measured=noisy, measurement=measurement), tuple(traits)


# -------------------------------------------------------------------------------------------------------- judgement


def _prediction_error(case: Case, result: dict[str, Any]) -> float:
    return rms(_values(predict(result, case.fresh)) - _values(case.fresh))


def oracle(case: Case) -> dict[str, float]:
    """Return prediction errors of geometry alone and of the true effects, both fitted to the noisy recording."""
    problem = pose_problem(case.robot, case.recording, PARAMETERS)
    problem = dataclasses.replace(problem, scale=BROAD * problem.scale)
    first = rough(problem, MECHANISM, robust=True)
    found = {"geometry": fit(problem, Prior(), errors=first.errors, instrument=first.instrument)}
    if case.terms:
        values = np.concatenate([t.values.ravel() for t in case.terms])
        joint = problem.with_terms(case.terms, 10 * np.abs(values))
        at = np.concatenate([found["geometry"].errors, values])
        found["truth"] = fit(joint, Prior(), errors=at, instrument=found["geometry"].instrument)
    out = {name: _prediction_error(case, _as_result(case, f)) for name, f in found.items()}
    return out if case.kind == "outside" else {"truth": out["geometry"]} | out


def _as_result(case: Case, found: Fit) -> dict[str, Any]:
    errors, terms = found.problem.split(found.errors)
    robot = dataclasses.replace(case.robot, errors=dict(zip(PARAMETERS, map(float, errors), strict=True)))
    terms = [dataclasses.replace(t, constants=(-1.0,)) if _unplaced(t, case.recording) else t for t in terms]
    instrument = found.instrument.to_dict() | {"setups": ["1"], "zero": "absolute"}
    return {"robot": robot_to_dict(robot), "physics": [term_to_dict(t) for t in terms], "instrument": instrument}


def _short(term: Term) -> list[Any]:
    return [term.effect, list(term.limbs), list(term.constants)]


def examine(job: tuple[str, tuple[str, ...], tuple[int, ...]]) -> dict[str, Any]:
    """Return how the diagnosis does on the case of a job."""
    kind, names, seed = job
    out: dict[str, Any] = {"kind": kind, "names": names, "seed": seed, "wrong": []}
    try:
        case = generate(*job)
    except RuntimeError as e:
        return out | {"skipped": str(e)}
    out |= {"truth": [_short(t) for t in case.terms], "excess": case.excess, "traits": case.traits}
    begin = time.perf_counter()
    try:
        found = diagnose(case.robot, case.recording)
        out["seconds"] = time.perf_counter() - begin
        out |= _compared(case, found)
        error = _prediction_error(case, found.to_dict())
        best = oracle(case)
        out |= {
            "to_oracle": error / best["truth"] if "truth" in best else None,
            "to_geometry": error / best["geometry"],
        }
    except NoSolutionError as e:
        out.setdefault("wrong" if "seconds" not in out else "no_oracle", []).append(f"exception: {e}")
        out.setdefault("seconds", time.perf_counter() - begin)
    except Exception:
        out["wrong"].append(f"exception: {' '.join(traceback.format_exc().splitlines()[-3:])}")
        out.setdefault("seconds", time.perf_counter() - begin)
    return out


def _compared(case: Case, found: Any) -> dict[str, Any]:
    result = found.to_dict()
    true, named = {t.effect: t for t in case.terms}, {n.term.effect: n for n in found.effects}
    right = {"null": "adequate", "outside": "unexplained"}.get(case.kind, "missing_physics")
    first = next(iter(result["location"]["channels"]), {}).get("name")
    out: dict[str, Any] = {
        "verdict": found.verdict,
        "verdict_ok": found.verdict == right,
        "found": [[*_short(n.term), round(n.gain, 1), list(n.alike)] for n in found.effects],
        "chi2": result["final"]["chi2_per_dof"],
        "noise": [found.noise.sigma / case.sigma, found.noise.source],
        "location": [first, result["location"]["limbs"]],
        "rejected": [[r["name"], round(r["gain_chi2"], 1)] for r in result["rejected"][:3]],
        "wrong": [],
        "z": [],
    }
    if not out["verdict_ok"]:
        out["wrong"].append(f"verdict {found.verdict}, chi2 {out['chi2']:.2f} ({found.noise.source})")
    if case.kind == "outside":
        out["channel_ok"] = first in case.channels
        out["limbs_ok"] = not case.limbs or set(result["location"]["limbs"]) == set(case.limbs)
        if not out["channel_ok"]:
            out["wrong"].append(f"placed at {first}, not {case.channels[0]}")
        return out
    out["exact"] = set(true) == set(named)
    if not out["exact"]:
        out["wrong"].append(f"named {' + '.join(map(str, out['found'])) or 'nothing'}")
    elif case.terms:
        out["limbs_ok"] = all(named[e].term.limbs == t.limbs for e, t in true.items())
        if not out["limbs_ok"]:
            out["wrong"].append(f"limbs {[list(n.term.limbs) for n in found.effects]}")
        for e, t in true.items():
            if e == "transmission_eccentricity" and named[e].term.constants != t.constants:
                out["wrong"].append(f"order {named[e].term.constants}")
            elif e not in CONVENTION:
                out["z"] += _departures(t, named[e].term, named[e].std)
    return out


def _departures(true: Term, found: Term, std: Array) -> list[float]:
    values, spread = found.values, np.asarray(std).reshape(found.values.shape)
    rows = [(i, true.limbs.index(limb), r) for r, limb in enumerate(found.limbs) for i in [limb] if limb in true.limbs]
    pairs = [(a, b) for _, a, b in rows] if true.limbs else [(0, 0)]
    return [float(z) for a, b in pairs for z in (values[b] - true.values[a]) / np.maximum(spread[b], 1e-300)]


# ------------------------------------------------------------------------------------------------------------ report


def jobs(kinds: Sequence[str], cases: int | None, seed: int) -> list[tuple[str, tuple[str, ...], tuple[int, ...]]]:
    """Return what is to be examined: `cases` in all, in the ordinary proportions."""
    share = (cases or sum(ORDINARY[k] for k in kinds)) / sum(ORDINARY[k] for k in kinds)
    out = []
    for kind in kinds:
        rng = np.random.default_rng([seed, list(ORDINARY).index(kind)])
        pool = list(OUTSIDE) if kind == "outside" else list(effect_names())
        for i in range(max(round(ORDINARY[kind] * share), 1)):
            names: tuple[str, ...] = () if kind == "null" else (pool[i % len(pool)],)
            if kind == "pair":
                names = tuple(str(n) for n in rng.choice(pool, 2, replace=False))
            out.append((kind, names, (seed, list(ORDINARY).index(kind), i)))
    return [out[i] for i in np.random.default_rng(seed).permutation(len(out))]


def _part(found: Sequence[dict[str, Any]], key: str) -> str:
    values = [f[key] for f in found if f.get(key) is not None]
    return f"{sum(map(bool, values))}/{len(values)}" if values else ""


def _line(label: str, found: Sequence[dict[str, Any]]) -> list[str]:
    z = np.array([v for f in found for v in f.get("z", ())])
    ratio = [f["to_oracle"] for f in found if f.get("to_oracle")]
    alarms = sum(bool(f.get("found")) or f.get("verdict") != "adequate" for f in found if f["kind"] == "null")
    spread = np.diff(np.quantile(z, [0.16, 0.84]))[0] / 2 if len(z) > 4 else None
    return [
        label,
        str(len(found)),
        _part(found, "exact"),
        _part(found, "limbs_ok"),
        str(alarms) if found[0]["kind"] == "null" else "",
        _part(found, "verdict_ok"),
        f"{int((np.abs(z) < 3).sum())}/{len(z)}" if len(z) else "",
        "" if spread is None else f"{spread:.2f}",
        f"{np.median(ratio):.2f}" if ratio else "",
        _part(found, "channel_ok"),
        f"{np.median([f['seconds'] for f in found]):.1f}",
    ]


def table(found: Sequence[dict[str, Any]]) -> Table:
    """Return the table by kind and by effect."""
    out = Table("", title="what was concealed, and what was found")
    for head in ("n", "exact", "limbs", "alarms", "verdict", "< 3 std", "spread", "/oracle", "channel", "s"):
        out.add_column(head, justify="right")
    for kind in ORDINARY:
        if of_kind := [f for f in found if f["kind"] == kind]:
            out.add_row(*_line(kind, of_kind), style="bold")
            by_name: dict[str, list[dict[str, Any]]] = collections.defaultdict(list)
            for f in of_kind:
                for name in f["names"]:
                    by_name[name].append(f)
            if kind != "pair":
                for name in sorted(by_name):
                    out.add_row(*_line(f"  {name}", by_name[name]))
    return out


def failures(found: Sequence[dict[str, Any]]) -> Iterator[str]:
    """Yield a line for each case that went wrong: what was true, what was found, and by what gains."""
    for f in sorted(found, key=lambda f: (f["kind"], f["names"])):
        if f["wrong"]:
            yield (
                f"{f['kind']} {f['seed']} true {f.get('truth') or f['names']} excess {f.get('excess', 0):.1f} "
                f"{' '.join(f.get('traits', ()))}: {'; '.join(f['wrong'])}; found {f.get('found')} chi2 "
                f"{f.get('chi2', 0):.2f} noise {f.get('noise')} at {f.get('location')}; next {f.get('rejected')}"
            )


def main(arguments: list[str] | None = None) -> int:
    """Run the cases, print the table and the failures."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.concealed", description=__doc__.split("\n")[0])
    parser.add_argument("--cases", type=int, help=f"in all (default {sum(ORDINARY.values())} of all kinds)")
    parser.add_argument("--kinds", default=",".join(ORDINARY), help="of " + ", ".join(ORDINARY))
    parser.add_argument("--jobs", type=int, default=2, help="processes")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", type=Path, metavar="FILE", help="write what was found in each case")
    given = parser.parse_args(arguments)
    kinds = given.kinds.split(",")
    if unknown := set(kinds) - set(ORDINARY):
        parser.error(f"no such kind: {', '.join(unknown)}")
    work = jobs(kinds, given.cases, given.seed)
    found: list[dict[str, Any]] = []
    errors = Console(stderr=True)
    with Progress(console=errors) as progress, multiprocessing.Pool(given.jobs) as pool:
        task = progress.add_task("cases", total=len(work))
        for f in pool.imap_unordered(examine, work):
            progress.advance(task)
            if "skipped" in f:
                progress.console.print(f["skipped"], markup=False, highlight=False)
                continue
            found.append(f)
            if given.json is not None:
                given.json.write_text(json.dumps(found, indent=1) + "\n")
    Console(width=None if sys.stdout.isatty() else 150).print(table(found))
    for line in failures(found):
        print(line)
    return 0


if __name__ == "__main__":
    sys.exit(main())
