"""Laws that no one registered: are they found, in their states and shape, and does what is none stay none.

    python -m tests.benchmarks.laws [--laws N] [--orders N] [--walks N] [--nulls N] [--seed S] [--quick]
                                    [--jobs N] [--kept laws.jsonl] [--minutes M]

Machines and recordings are drawn and simulated exactly. A third of the laws are *foreign*: curves that a generator
draws which shares neither code nor a list of forms with the search. A law is right where its states are exactly those,
and what it does to the readings correlates above 0.98 with what the truth does, geometry taken out of both. Predictions
are of fresh rows, and of rows whose channels reach a quarter farther, against a fit that knows what happened: by what
they leave of readings as the instrument gives them, with its noise, and, which is harder, of what is true without any.
Beside `orders`, laws act on machines whose joints err at many orders besides. Cases are done as `sitting` says. What
is told of time is of CPU: of a diagnosis, and of what the search for laws takes of it.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before NumPy is loaded

import argparse
import dataclasses
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
from rich.console import Console
from rich.table import Table

from deltacal_gen.diagnosis import diagnosis
from deltacal_gen.diagnosis.answer import Diagnosed
from deltacal_gen.diagnosis.beside import Beside
from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.errors import DeltacalError
from deltacal_gen.estimation.fit import fit, rough
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.residuals import rms
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.law import load_law
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.use.prediction import predict
from tests.benchmarks import concealed_machines as machines
from tests.benchmarks.sitting import add_options, sit, wilson

Array = np.ndarray
States = Mapping[str, Array]
Curve = Callable[[Array], Array]
MACHINES = ("delta", "delta", "delta", "linear_delta", "serial")
SIGMA = 0.01  # mm
LEAST, MOST = 2.0, 8.0  # standard deviations of noise that geometry alone leaves
ALIKE = 0.98  # correlation of shapes
FARTHER = 0.25  # of its range, by which a channel goes beyond it
LAWS = ("known", "foreign", "orders")  # kinds of cases in which a law holds
ATTEMPTS = 30  # at a case of a seed
FRESH, BEYOND = 1.2, 1.5  # times the error of one who knows: as near a prediction has to be, in the ranges and beyond
OF_LAWS = ("laws", "with_remainder", "_as_learned")  # what a diagnosis does for laws alone
LONG_S = 30.0  # of CPU: what a search for laws may take beside the diagnosis
ORDERS, LARGE = 24, 3e-4  # of a gear's error: from 1 on, and its size [rad, or 100 mm]


@dataclasses.dataclass(frozen=True)
class Truth:
    """What happens: at a joint [rad or mm], or to an axis of the reading [mm], as a function of states.

    Beside it each joint errs by `orders` (joints, 2, orders) of its angle: cosines and sines.
    """

    kind: str
    states: tuple[str, ...]
    limb: int
    axis: int
    value: Callable[[States], Array]
    orders: Array | None = None

    def beside(self, q: Array) -> Array:
        """Return by how much joints (N, n) [rad or mm] err beside the law."""
        if self.orders is None:
            return np.zeros_like(q)
        turned = q[..., None] * np.arange(1, self.orders.shape[2] + 1)
        return np.asarray((np.cos(turned) * self.orders[:, 0] + np.sin(turned) * self.orders[:, 1]).sum(axis=2))


# ------------------------------------------------------------------------------------------------ machines and channels


def channels(
    n: int, rng: np.random.Generator, joints: int, farther: float = 0.0, late: float = 0.0
) -> dict[str, Array]:
    """Return channels as a shop records them; beyond their ordinary ranges by a part, or at a later time."""
    t = late + np.cumsum(rng.uniform(15, 40, n))
    wide = 1 + 2 * farther
    out = {"time_s": np.round(t, 2), "temp_C": np.round(24 + wide * rng.uniform(-4, 4, n), 2)}
    out["payload_kg"] = np.round(2.0 + wide * rng.uniform(-2, 2, n), 2).clip(0)
    out |= {f"approach{i}": rng.choice([-1.0, 1.0], n) for i in range(1, joints + 1)}
    out["oil_C"] = np.round(45 + wide * 8 * rng.uniform(-1, 1, n), 2)
    out["humidity_pct"] = np.round(50 + wide * rng.uniform(-15, 15, n), 1)
    return out


def commanded(robot: Robot, n: int, rng: np.random.Generator, **how: float) -> Recording:
    """Return a recording without readings."""
    mechanism = mechanism_of(robot)
    joints = machines.joints_of_poses(robot, n, np.zeros(3), rng)
    columns = tuple(f"{axis}_mm" for axis in mechanism.axes)
    return Recording(
        path=Path("recording.csv"),
        kind="position",
        measurement=Measurement(kind="position", frame="unknown"),
        joint_unit=mechanism.joint_unit,
        joints=rng.permutation(joints),
        columns=columns,
        measured=np.full((n, len(columns)), np.nan),
        pose=np.arange(1, n + 1).astype(str),
        line=np.arange(2, n + 2),
        channels=channels(n, rng, mechanism.limbs, **how),
        setup=np.zeros(n, dtype=int),
        setup_names=("",),
    )


def states_of(robot: Robot, at: Recording) -> dict[str, Array]:
    """Return the states that truths read, by the names of laws, (N,) or (N, joints)."""
    mechanism, q = mechanism_of(robot), robot.joint_sign * at.joints
    body = Body(robot, mechanism, q, np.zeros((len(q), 3)), Channels.of(at, robot))
    rows = mechanism.rows(robot)
    x = np.nan_to_num(mechanism.forward(q, body.tool, rows)[0])
    names = ["q", "approach", "warming", "payload", "time", "oil_C", "humidity_pct"]
    names += ["torque"] if robot.masses is not None or (robot.links and mechanism.weighs) else []
    return body.state(names, x, q, rows)


# --------------------------------------------------------------------------------------------------------------- truths

KNOWN: tuple[tuple[str, ...], ...] = (  # formulas of one state, or of two; a and b stand for what is drawn
    ("tanh(a/(0.3*A))", "sign(a)*Max(Abs(a) - 0.4*A, 0)", "Max(a - m, 0)", "exp(-a/(0.3*A))", "Heaviside(a - m)"),
    ("a*b", "a*Max(b - mb, 0)", "tanh(a/(0.4*A))*b", "Abs(a)*b", "a**2*b"),
)


def known(names: Sequence[str], sizes: Sequence[tuple[float, float]], rng: np.random.Generator) -> Callable[..., Array]:
    """Return a formula that the language of laws has, of one state or of two."""
    from deltacal_gen.physics.formula import formula

    text = str(rng.choice(KNOWN[len(names) - 1]))
    own = dict(zip(("A", "B"), (s for s, _ in sizes), strict=False))
    own |= dict(zip(("m", "mb"), (m for _, m in sizes), strict=False))

    def value(*states: Array) -> Array:
        return formula(text)(own | dict(zip(("a", "b"), states, strict=False)))

    return value


def curve(rng: np.random.Generator, size: float, middle: float) -> Curve:
    """Return a curve of a state about its size and middle, of no family that a law has."""
    w, a, k = size * rng.uniform(0.3, 0.8), middle + size * rng.uniform(-0.2, 0.2), rng.uniform(1.2, 2.2)
    knots = np.sort(rng.uniform(-1.2, 1.2, 3))
    slopes = rng.uniform(-1, 1, 4)
    curves: list[Curve] = [
        lambda s: np.arctan((s - a) / w),
        lambda s: np.abs(s / size) ** k * np.sign(s),
        lambda s: np.logaddexp(0.0, (s - a) / (0.4 * w)),
        lambda s: 1 / (1 + ((s - a) / w) ** 2),
        lambda s: np.cosh((s - a) / (1.3 * w)),
        lambda s: np.abs(s) ** k / (np.abs(s) ** k + w**k),
        lambda s: np.cbrt((s - a) / size),
        lambda s: np.arcsin(np.sin(3.0 * np.pi * (s - a) / size * k / 2)),
        lambda s: sum(
            c * np.logaddexp(0.0, 12 * ((s - middle) / size - p)) for c, p in zip(slopes, knots, strict=False)
        ),
        lambda s: np.cos(4 * (s - a) / size) * np.exp(-(s - a) / (2 * size)),
    ]
    return curves[int(rng.integers(len(curves)))]


def foreign(
    names: Sequence[str], sizes: Sequence[tuple[float, float]], rng: np.random.Generator
) -> Callable[..., Array]:
    """Return a curve of a state, or the product of two, that the search has no form of."""
    curves = [curve(rng, *s) for s in sizes]
    if len(names) == 2 and rng.random() < 0.5:
        curves[1] = lambda s: s - sizes[1][1]

    def value(*states: Array) -> Array:
        return np.prod([c(s) for c, s in zip(curves, states, strict=True)], axis=0)

    return value


def draw(kind: str, robot: Robot, seen: States, rng: np.random.Generator) -> Truth:
    """Return a law of a kind (known, foreign), or one of the causes that no channel holds."""
    limbs = mechanism_of(robot).limbs
    limb, axis = int(rng.integers(1, limbs + 1)), int(rng.integers(len(mechanism_of(robot).axes)))
    if kind not in LAWS:
        return Truth(kind, (), limb if rng.random() < 0.5 else 0, axis, _unrecorded(kind, rng))
    at_joint = rng.random() < 0.8
    channel = ["warming", "payload", "oil_C", "humidity_pct", "time"]
    own = [n for n in ("torque", "q", "approach") if n in seen] if at_joint else []
    names = [str(rng.choice([*own, *channel] if own else channel))]
    if rng.random() < 0.6 or names[0] == "approach":
        names.append(str(rng.choice([c for c in channel if c != names[0]])))
    if len(names) == 1 and names[0] == "q":
        other = int(rng.choice([i for i in range(1, limbs + 1) if i != limb]))
        names = [f"q_{other}"]  # of its own angle a joint has the vocabulary

    def of(states: States, name: str) -> Array:
        base, _, number = name.rpartition("_")
        v = states[base] if number.isdecimal() else states[name]
        return v[:, int(number) - 1] if number.isdecimal() else v[:, limb - 1] if v.ndim == 2 else v

    values = [of(seen, n) for n in names]
    sizes = [(float(np.abs(v).max()) if v.min() < 0 else float(np.ptp(v)), float(np.median(v))) for v in values]
    make = foreign if kind == "foreign" else known
    function, orders = make(names, sizes, rng), None
    if kind == "orders":
        large = np.array([LARGE * (100.0 if u == "mm" else 1.0) for u in mechanism_of(robot).joint_units])
        orders = large[:, None, None] * rng.standard_normal((limbs, 2, ORDERS)) / np.sqrt(ORDERS)

    def value(states: States) -> Array:
        return function(*(of(states, n) for n in names))

    # an even function of a direction is none: what truth does not go with, no law need read
    whole = value(seen)
    read = [n for n in names if not np.allclose(value({**seen, **_reversed(seen, n)}), whole)]
    return Truth(kind, tuple(read), limb if at_joint else 0, axis, value, orders)


def _reversed(seen: States, name: str) -> States:
    """Return a state in the reverse order of rows."""
    base, _, number = name.rpartition("_")
    own = base if number.isdecimal() else name
    return {own: seen[own][::-1]}


def _unrecorded(kind: str, rng: np.random.Generator) -> Callable[[States], Array]:
    steps, moments, phase = rng.standard_normal(4000), np.sort(rng.uniform(0, 8000, 4)), rng.uniform(0, 6)
    walk, sizes = np.cumsum(steps), rng.standard_normal(4)

    def value(states: States) -> Array:
        t = states["time"]
        if kind == "walk":
            return np.interp(t, np.arange(4000) * 27.0, walk)
        if kind == "slips":
            return (t[:, None] > moments) @ sizes
        # a covariate that nobody recorded: it wanders about its mean
        slow = np.convolve(steps, np.exp(-np.arange(60) / 15.0))[:4000]
        return np.interp(t, np.arange(4000) * 27.0, slow) + 0.3 * np.sin(t / 700 + phase)

    return value


# ---------------------------------------------------------------------------------------------------------- recordings


@dataclasses.dataclass(frozen=True)
class Case:
    """A recording, what happens in it, and fresh ones without noise: in the ranges, and beyond."""

    robot: Robot
    truth: Truth | None
    recording: Recording
    exact: Recording
    fresh: tuple[Recording, ...]
    errors: dict[str, float]
    much: float
    frame: int


def generate(kind: str, seed: Sequence[int]) -> Case:
    """Return the case of a seed."""
    for attempt in range(ATTEMPTS):
        rng = np.random.default_rng([*seed, attempt])
        try:
            case = _attempt(kind, rng)
        except DeltacalError:
            continue
        if case is not None:
            return case
    raise RuntimeError(f"no case of {kind} in {ATTEMPTS} attempts")


def _attempt(kind: str, rng: np.random.Generator) -> Case | None:
    robot = machines.draw(str(rng.choice(MACHINES)), rng)
    errors, n = machines.ordinary_errors(robot, rng), int(rng.integers(140, 300))
    at = commanded(robot, n, rng)
    late = float(at.channels["time_s"][-1])
    fresh = [commanded(robot, 80, rng), commanded(robot, 80, rng, farther=FARTHER, late=FARTHER * late)]
    fresh[0].channels["time_s"][:] = np.sort(rng.uniform(0, late, 80))
    fresh[1].channels["time_s"][:] = np.sort(rng.uniform(0, (1 + FARTHER) * late, 80))
    frame = int(rng.integers(2**32))
    truth = None if kind == "null" else draw(kind, robot, states_of(robot, at), rng)

    def read(rec: Recording, much: float, truth: Truth | None = truth) -> Recording:
        return _read(robot, rec, errors, truth, much, frame)

    much = 0.0
    if truth is not None:
        if not all(np.isfinite(truth.value(states_of(robot, rec))).all() for rec in (at, *fresh)):
            return None  # no machine stands where a curve has no value
        much, wanted = 1e-4 if truth.limb else 1e-2, float(np.exp(rng.uniform(np.log(LEAST), np.log(MOST))))
        alone = dataclasses.replace(truth, orders=None)
        for _ in range(3):
            left = _left(robot, read(at, much, alone))
            if not left > 1e-6:
                return None
            much *= wanted * SIGMA / left
    exact = read(at, much)
    noise = SIGMA * (rng.standard_normal(exact.measured.shape) if kind != "null" else _noise(rng, exact.measured.shape))
    declared = dataclasses.replace(exact.measurement, sigma_mm=SIGMA if rng.random() < 0.5 else None)
    noisy = dataclasses.replace(exact, measured=exact.measured + noise, measurement=declared)
    return Case(robot, truth, noisy, exact, tuple(read(f, much) for f in fresh), errors, much, frame)


def _noise(rng: np.random.Generator, shape: tuple[int, ...]) -> Array:
    """Return noise of some sort: normal, heavy, or hanging together from row to row."""
    sort = rng.integers(3)
    if sort == 1:
        return np.asarray(rng.standard_t(4, shape) / np.sqrt(2))
    e = rng.standard_normal(shape)
    if sort == 2:
        rho = rng.uniform(0.3, 0.8)
        for k in range(1, len(e)):
            e[k] = rho * e[k - 1] + np.sqrt(1 - rho**2) * e[k]
    return e


def _read(
    robot: Robot, rec: Recording, errors: dict[str, float], truth: Truth | None, much: float, frame: int
) -> Recording:
    """Return what is read without noise: joints stand elsewhere than they report, or the reading is moved."""
    moved, shift = rec.joints, np.zeros(rec.measured.shape)
    if truth is not None:
        moved = rec.joints + truth.beside(rec.joints)
        value = much * truth.value(states_of(robot, rec))
        if truth.limb:
            moved[:, truth.limb - 1] += robot.joint_sign[truth.limb - 1] * value
        else:
            shift[:, truth.axis] = value
    done = simulate(robot, dataclasses.replace(rec, joints=moved), errors, rng=np.random.default_rng(frame))
    kept = {name: v for name, v in rec.channels.items() if not name.startswith("true_")}
    return dataclasses.replace(
        done, joints=rec.joints, channels=kept, measured=done.measured + shift, measurement=rec.measurement
    )


def _left(robot: Robot, exact: Recording) -> float:
    """Return what geometry alone leaves of readings without noise [mm]."""
    at = geometry(robot, exact)
    return rms(at.residual)


def geometry(robot: Robot, rec: Recording, problem: Callable[[Problem], Problem] = lambda p: p) -> Fit:
    """Return the fit of the full geometry."""
    mechanism = mechanism_of(robot)
    whole = problem(pose_problem(robot, rec, mechanism.model(mechanism.full_model)))
    start = rough(whole, must_converge=False)
    return fit(whole, Prior(), errors=start.errors, instrument=start.instrument, drop_gross=False, must_converge=False)


# -------------------------------------------------------------------------------------------------------------- grading


def examine(job: tuple[str, tuple[int, ...]]) -> dict[str, Any]:
    """Return what became of a case."""
    kind, seed = job
    case = generate(kind, seed)
    out: dict[str, Any] = {"kind": kind, "seed": seed, "machine": case.robot.mechanism, "poses": len(case.exact.pose)}
    begin = time.process_time()
    with searching() as spent:
        found = diagnose(case.robot, case.recording)
    out |= {"seconds": time.process_time() - begin, "beside": sum(spent), "verdict": str(found.verdict)}
    out["names"] = [n.term.effect for n in found.effects]
    out["law"] = found.laws[0].text if found.laws else ""
    if case.truth is None or kind not in LAWS:
        return out
    out |= {"states": case.truth.states, "limb": case.truth.limb}
    answer = found.answer()
    off = [predict(answer, f).measured - f.measured for f in case.fresh]
    best = [_by_who_knows(case, f) for f in case.fresh]
    out["ratio"] = [
        float(np.hypot(rms(o), 0.1 * SIGMA) / np.hypot(rms(b), 0.1 * SIGMA)) for o, b in zip(off, best, strict=True)
    ]
    rng = np.random.default_rng([*seed, ATTEMPTS])  # no attempt's own
    noise = [SIGMA * rng.standard_normal(o.shape) for o in off]
    out["of_readings"] = [rms(o - e) / rms(b - e) for o, b, e in zip(off, best, noise, strict=True)]
    out["alike"] = _likeness(case, found)
    told = found.laws[0].terms if found.laws else []  # what is predicted beside it reads other states, too
    own = {_plain(s, case.truth.limb) for t in told for s in load_law(t.effect).STATE}
    out["right"] = own == set(case.truth.states) and out["alike"] > ALIKE
    return out


@contextmanager
def searching() -> Iterator[list[float]]:
    """Yield what a diagnosis spends on laws [s of CPU]: a number for each time that it seeks or refines one."""
    spent: list[float] = []

    def timed(function: Callable[..., Any]) -> Callable[..., Any]:
        def run(*given: Any, **how: Any) -> Any:
            begin = time.process_time()
            try:
                return function(*given, **how)
            finally:
                spent.append(time.process_time() - begin)

        return run

    own = {name: getattr(diagnosis, name) for name in OF_LAWS}
    try:
        for name, function in own.items():
            setattr(diagnosis, name, timed(function))
        yield spent
    finally:
        for name, function in own.items():
            setattr(diagnosis, name, function)


def _plain(state: str, limb: int) -> str:
    """Return the name of a state as truths give it: a joint's own without its number."""
    base, _, number = state.rpartition("_")
    return base if number == str(limb) and base else state


def _by_who_knows(case: Case, fresh: Recording) -> Array:
    """Return by how much a fit is off (N, k) [mm] that knows what happens, but not the geometry."""
    truth = case.truth
    assert truth is not None

    def undone(rec: Recording) -> Recording:
        value = case.much * truth.value(states_of(case.robot, rec))
        joints = rec.joints + truth.beside(rec.joints)
        if not truth.limb:
            shift = np.zeros(rec.measured.shape)
            shift[:, truth.axis] = value
            return dataclasses.replace(rec, joints=joints, measured=rec.measured - shift)
        joints[:, truth.limb - 1] += case.robot.joint_sign[truth.limb - 1] * value
        return dataclasses.replace(rec, joints=joints)

    at = geometry(case.robot, undone(case.recording))
    known = undone(fresh)
    problem = pose_problem(case.robot, known, at.problem.names)
    return -np.asarray(problem.residual(at.errors, at.instrument, problem.poses(at.errors)))


def _likeness(case: Case, found: Diagnosed) -> float:
    """Return the correlation of what the law and the truth do to the readings, geometry taken out of both."""
    if not found.laws:
        return 0.0
    final = found.final
    bare = dataclasses.replace(final.problem, terms=(), held=())
    n = len(final.problem.mechanism.parameters)
    x = bare.poses(final.errors[:n])
    without = bare.residual(final.errors[:n], final.instrument, x)
    by_law = final.problem.residual(final.errors, final.instrument, final.problem.poses(final.errors)) - without
    plain = _read(case.robot, case.exact, case.errors, case.truth, 0.0, case.frame)
    moved = _read(case.robot, case.exact, case.errors, case.truth, case.much, case.frame)
    beside = Beside(geometry(case.robot, case.recording))
    a, b = (
        v - beside.Q @ (beside.Q.T @ v)
        for v in (beside.rows(d[..., None])[:, 0] for d in (-by_law, moved.measured - plain.measured))
    )
    return float(abs(a @ b) / max(np.linalg.norm(a) * np.linalg.norm(b), 1e-300))


def table(entries: Sequence[Mapping[str, Any]]) -> Table:
    """Return what was right, with intervals."""
    out = Table("cases", "what", "share", "95 %")

    def row(kind: str, what: str, hits: Sequence[bool]) -> None:
        low, high = wilson(sum(hits), len(hits))
        out.add_row(kind, what, f"{sum(hits)} of {len(hits)}", f"{low:.2f} to {high:.2f}")

    for kind in LAWS:
        own = [e for e in entries if e["kind"] == kind]
        if own:
            row(kind, "a law is told", [bool(e["law"]) for e in own])
            row(kind, "states and shape right", [e["right"] for e in own])
            row(kind, "shape right", [e["alike"] > ALIKE for e in own])
            for k, (what, most) in enumerate((("fresh", FRESH), ("a quarter beyond", BEYOND))):
                within = f"within {most} of one who knows"
                for name, of in (("of_readings", "readings as an instrument gives them"), ("ratio", "without noise")):
                    row(kind, f"{what}, {of}: {within}", [e[name][k] < most for e in own])
            row(kind, "no name beside a law", [not e["names"] for e in own if e["law"]])
            row(kind, "a wrong name and no law", [bool(e["names"]) and not e["law"] for e in own])
    for kind in ("walk", "covariate", "slips", "null"):
        own = [e for e in entries if e["kind"] == kind]
        if own:
            row(kind, "no law", [not e["law"] for e in own])
    return out


def main(arguments: list[str] | None = None) -> int:
    """Run the cases, print the table and what was not right."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.laws", description=__doc__.split("\n")[0])
    for kind, count in (("laws", 200), ("orders", 0), ("walks", 60), ("nulls", 300)):
        parser.add_argument(f"--{kind}", type=int, default=count, metavar="N", help=f"cases (default {count})")
    parser.add_argument("--seed", type=int, default=21)
    parser.add_argument("--quick", action="store_true", help="a few of each")
    add_options(parser)
    given = parser.parse_args(arguments)
    laws, orders, walks, nulls = (6, 1, 3, 2) if given.quick else (given.laws, given.orders, given.walks, given.nulls)
    jobs = [("foreign" if k % 3 == 2 else "known", (given.seed, 0, k)) for k in range(laws)]
    jobs += [(("walk", "covariate", "slips")[k % 3], (given.seed, 1, k)) for k in range(walks)]
    jobs += [("null", (given.seed, 2, k)) for k in range(nulls)]
    jobs += [("orders", (given.seed, 3, k)) for k in range(orders)]
    found = sit(examine, jobs, given, lambda e: str({k: v for k, v in e.items() if v or k == "alike"}))
    entries = list(found.done.values())
    Console(width=None if sys.stdout.isatty() else 120).print(table(entries))
    print(*times(entries), sep="\n")
    return found.code


def times(entries: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return what a diagnosis takes, and what the search for laws takes beside it."""
    if not entries:
        return []
    whole, beside = (np.array([e[name] for e in entries]) for name in ("seconds", "beside"))
    longest = entries[int(np.argmax(beside))]
    return [
        f"a diagnosis takes {np.median(whole):.1f} s of CPU, {whole.max():.1f} s at most; without the search for laws "
        f"{np.median(whole - beside):.1f} s",
        f"the search for laws takes {np.median(beside):.1f} s, {beside.max():.1f} s at most "
        f"(of {longest['poses']} poses), more than {LONG_S:.0f} s in {int((beside > LONG_S).sum())} of {len(beside)}",
    ]


if __name__ == "__main__":
    sys.exit(main())
