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
from types import SimpleNamespace

import numpy as np

from deltacal_gen.diagnosis.library import library
from deltacal_gen.diagnosis.search import Search
from deltacal_gen.errors import DeltacalError
from deltacal_gen.estimation.prior import BROAD
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.residuals import Repeats, rms
from deltacal_gen.files.robot import Robot
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import load_mechanism, mechanism_of
from deltacal_gen.machine.rotation import from_vector, to_vector
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.parts import lacks
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, beyond, blank, coefficients, load_effect
from deltacal_gen.units import DEG, to_internal
from tests.benchmarks import concealed_machines as machines
from tests.benchmarks.concealed_sessions import INSTRUMENT_ONLY, NEEDS, Session

Array = np.ndarray
MARGIN = 40.0  # of chi2 without noise: what the truth must be ahead of every other explanation
REST = 0.5  # of chi2 per reading: what the vocabulary must leave of physics that is not in it
LARGEST = 1.0  # mm: root mean square by which an effect moves the readings
LEAST, MOST = 1.5, 10.0  # standard deviations of noise that geometry alone leaves
ATTEMPTS = 40
MECHANISM = load_mechanism("delta")
OUTSIDE = {  # channel that tells best (the first) or also tells, and what the channels must hold
    "square_wave": (("time_s",), {"time"}),
    "local_bump": (("position",), set()),
    "covariate": (("humidity_pct",), {"humidity"}),
    "payload_hysteresis": (("payload_kg", "time_s"), {"time", "cycle"}),
    "cross_joint": (("q1_deg", "q2_deg", "q3_deg", "position"), set()),
    "thermal_lag": (("time_s", "temp_C"), {"time", "cycling"}),
    "random_walk": (("time_s",), {"time"}),
}
SCALED = {"encoder": "sigma_deg", "board_image": "sigma_px"}  # kinds that read no lengths, and how their noise is said
ON_READING = {"local_bump", "random_walk"}  # of positions
ORDINARY = {"null": 40, "single": 3 * len(machines.shown("delta")), "pair": 20, "outside": 2 * len(OUTSIDE)}


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
        One of `concealed_machines.MACHINES`, with a blank and one of `INSTRUMENTS` behind it where one kind measures.
    """
    out = []
    for kind, count in counts.items():
        number = list(ORDINARY).index(kind)
        rng = np.random.default_rng([seed, number])
        pool = foreign(machine) if kind == "outside" else [n for n in machines.shown(machine) if not only or n in only]
        for i in range(count):
            names: tuple[str, ...] = () if kind == "null" else (pool[i % len(pool)],)
            if kind == "pair":
                names = tuple(str(n) for n in rng.choice(pool, 2, replace=False))
            out.append((kind, names, (seed, number, i), machine))
    return [out[i] for i in np.random.default_rng(seed).permutation(len(out))]


def foreign(machine: str) -> list[str]:
    """Return what is outside the vocabulary: where no positions are read, what moves joints."""
    _, kind = machines.parted(machine)
    return [name for name in OUTSIDE if not kind or name not in ON_READING]


@using(Backend.COMPILED)
def generate(
    kind: str,
    names: Sequence[str],
    seed: Sequence[int],
    machine: str = "delta",
    by: Callable[..., Recording] = simulate,
    shop: Shop | None = None,
) -> Case:
    """Return the case of a seed: `names` are effects, or one of `OUTSIDE`, or empty.

    `by` makes the readings, with the signature of `simulate`; amplitudes and clarity are judged on the project's own.
    `shop` draws sessions and records them, by default as an orderly laboratory does.
    """
    shop = shop or Shop()
    for attempt in range(ATTEMPTS):
        try:
            case = _attempt(kind, tuple(names), np.random.default_rng([*seed, attempt]), machine, by, shop)
        except DeltacalError:
            continue  # a pose out of reach
        if case is not None:
            return case
    raise RuntimeError(f"no clear case of {kind} {' + '.join(names)} in {ATTEMPTS} attempts")


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
    if _placed(name):
        clock = poses.channels.get("time_s", np.arange(poses.n_rows, dtype=float))
        constants = (float(np.sort(clock)[int(rng.uniform(0.15, 0.85) * len(clock))]),)
    moved = rng.permutation(tools)[: int(rng.integers(1, max(len(tools), 2)))]
    term = blank(name, limbs, constants, moved, lacks(name, mechanism, mechanism.moves(robot), mechanism.roles(robot)))
    sizes = {"expansion_proximal": 20e-6, "expansion_distal": 10e-6, "expansion_base": 15e-6}
    known = coefficients(term.kernels, mechanism.joint_unit)
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


def source_errors(robot: Robot, recording: Recording) -> tuple[str, ...]:
    """Return the parameters of a machine that readings may know: encoders know none."""
    return () if kind_of(recording.kind).sees_joints else tuple(p.name for p in mechanism_of(robot).parameters)


class Judge:
    """The linear problem without noise: what of a displacement geometry leaves, and what else would explain it.

    `exact` is the recording of a machine with `errors` and nothing left out, without noise.
    """

    def __init__(self, robot: Robot, exact: Recording, errors: Mapping[str, float], sigma: float, turn: float) -> None:
        self.robot, mechanism = robot, mechanism_of(robot)
        self.names = source_errors(robot, exact)
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
        off = self._of(recording).residual(self.errors, self.instrument, self.problem.seen(self.machine))
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
            departure=(self.errors - problem.reference)[problem.columns] / problem.scale,
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

    def excess(self, exact: Recording) -> float:
        """Return how many standard deviations of noise geometry alone leaves."""
        return float(np.sqrt(self.misfit(exact) / self.scalars))

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
                near = _placed(c.effect) and same  # a neighbouring time is no other explanation
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


@dataclass(frozen=True)
class Concealed:
    """What a case holds back: its readings without noise, how others are made, and what a diagnosis is to say of it."""

    exact: Recording
    make: Callable[..., Recording]
    terms: tuple[Term, ...] = ()
    channels: tuple[str, ...] = ()
    limbs: tuple[int, ...] = ()


class Shop:
    """How sessions are taken: what is drawn, and what a recording makes of readings without noise."""

    def session(
        self, kind: str, names: tuple[str, ...], must: set[str], rng: np.random.Generator, machine: str
    ) -> Session:
        """Return a session; `must` are channels that it has to have."""
        return Session.draw(kind, names, must, rng, machine)

    def record(
        self, exact: Recording, session: Session, rng: np.random.Generator, scale: float
    ) -> tuple[Recording, tuple[str, ...]]:
        """Return noisy readings and their traits; `scale` is what a unit of them is [mm], where it is no length."""
        return _noisy(exact, session.sigma, session.turn, rng, scale)


def _attempt(
    kind: str, names: tuple[str, ...], rng: np.random.Generator, machine: str, by: Callable[..., Recording], shop: Shop
) -> Case | None:
    """Return a case; None where what was drawn is not clear."""
    if kind == "outside":
        must = OUTSIDE[names[0]][1]
    else:
        must = {NEEDS[s] for name in names for s in load_effect(name).STATE if s in NEEDS}
    session = shop.session(kind, names, must, rng, machine)
    robot, poses = session.robot, session.poses
    judge = Judge(robot, session.read(poses), session.errors, session.sigma, session.turn)
    held = (_foreign if kind == "outside" else _effects)(names, session, judge, rng)
    if held is None:
        return None
    exact = held.exact if by is simulate else held.make(poses, by=by)
    noisy, traits = shop.record(exact, session, rng, judge.instrument.scale)
    return Case(
        kind,
        names,
        robot,
        noisy,
        exact,
        held.make(session.fresh, by=by),
        session.errors,
        held.terms,
        session.sigma,
        session.turn,
        judge.excess(held.exact),
        held.channels,
        held.limbs,
        (*traits, *session.traits),
    )


def _foreign(names: tuple[str, ...], session: Session, judge: Judge, rng: np.random.Generator) -> Concealed | None:
    """Conceal physics that is not in the vocabulary; None where the vocabulary could pass for it."""
    foreign = Foreign.draw_one(names[0], judge.machine.x[:, :3], session.robot, rng)
    much, wanted = 1.0, float(rng.uniform(2, MOST))

    def make(at: Recording, by: Callable[..., Recording] = simulate) -> Recording:
        joint, shift = foreign.shift(at, session.positions(at), session.poses)
        return session.read(at, moved=(much * joint, much * shift), by=by)

    for _ in range(2):
        much *= wanted * np.sqrt(judge.scalars / judge.misfit(make(session.poses)))
    exact = make(session.poses)
    if not judge.foreign(exact):
        return None
    limbs = () if names[0] in ("local_bump", "random_walk") else (foreign.limb,)
    return Concealed(exact, make, channels=OUTSIDE[names[0]][0], limbs=limbs)


def _effects(names: tuple[str, ...], session: Session, judge: Judge, rng: np.random.Generator) -> Concealed | None:
    """Conceal effects, or none; None where one hardly shows, or another could stand for it."""
    poses = session.poses
    drawn = [_sized(_term(name, poses, session.robot, session.tools, rng), session, judge, rng) for name in names]
    terms = tuple(term for term in drawn if term is not None)
    if len(terms) < len(names):
        return None
    unit = mechanism_of(session.robot).joint_unit
    if any(beyond(t, np.zeros_like(t.values), unit) for t in terms):
        return None  # as no machine is
    shown = [t for t in terms if t.effect not in INSTRUMENT_ONLY]
    if any(rms(judge.departure(session.read(poses, [t]))) > LARGEST for t in shown):
        return None  # an effect that hardly shows, blown up
    late = [dataclasses.replace(t, constants=(-1.0,)) if _unplaced(t, poses) else t for t in terms]

    def make(at: Recording, by: Callable[..., Recording] = simulate) -> Recording:
        return session.read(at, late if at is session.fresh else terms, by=by)

    exact = make(poses)
    if terms and not (0.95 * LEAST < judge.excess(exact) < 1.1 * MOST and judge.clear(exact, terms)):
        return None
    return Concealed(exact, make, terms)


def _sized(term: Term, session: Session, judge: Judge, rng: np.random.Generator) -> Term | None:
    """Return an effect as large as it is to be; None where readings do not show it."""
    wanted = float(np.exp(rng.uniform(np.log(LEAST), np.log(MOST))))
    for _ in range(3):
        left = judge.misfit(session.read(session.poses, [term]))
        if left <= 1e-12:
            return None
        term = term.with_values(term.values.ravel() * wanted * np.sqrt(judge.scalars / left))
    return term


def _placed(name: str) -> bool:
    """Tell whether an effect begins at a moment."""
    return "moments" in load_effect(name).SEARCHED


def _unplaced(term: Term, poses: Recording) -> bool:
    return _placed(term.effect) and "time_s" not in poses.channels


def _noisy(
    exact: Recording, sigma: float, turn: float, rng: np.random.Generator, scale: float = 1.0
) -> tuple[Recording, tuple[str, ...]]:
    """Return noisy readings and their traits; `scale` is what a unit of the reading is [mm], where it is no length."""
    values = readings(exact)
    noise, traits = rng.standard_normal(values.shape), []
    if rng.random() < 0.15:
        noise = rng.standard_t(4, values.shape) / np.sqrt(2)
        traits.append("heavy")
    if rng.random() < 0.25:
        bad = rng.choice(len(values), max(int(rng.uniform(0.01, 0.04) * len(values)), 1), replace=False)
        noise[bad] += rng.choice([-1, 1], (len(bad), values.shape[1])) * rng.uniform(10, 60, (len(bad), 1))
        traits.append("outliers")
    own = sigma / scale if exact.kind in SCALED else turn
    sigmas = [sigma if column.endswith("_mm") else own for column in exact.columns] or [sigma]
    noisy = values + np.asarray(sigmas) * noise
    if exact.kind == "pose" and len(sigmas) == 6:
        turned = from_vector(turn * noise[:, 3:]) @ from_vector(values[:, 3:])
        noisy = np.hstack([noisy[:, :3], to_vector(turned)])
    if exact.measurement.zero == "incremental":
        noisy = noisy - noisy[0]
    measurement = exact.measurement
    if rng.random() < 0.5:
        said = own / DEG if exact.kind == "encoder" else own if exact.kind in SCALED else sigma
        measurement = dataclasses.replace(measurement, **{SCALED.get(exact.kind, "sigma_mm"): said})
        traits.append("declared")
    if exact.pair_measured is not None:
        return dataclasses.replace(exact, pair_measured=noisy[:, 0], measurement=measurement), tuple(traits)
    return dataclasses.replace(exact, measured=noisy, measurement=measurement), tuple(traits)
