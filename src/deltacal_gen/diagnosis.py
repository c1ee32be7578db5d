"""Diagnosis: is there a mismatch, where, what physics was left out, and does it hold on poses that no fit has seen.

The full identifiable geometry and the instrument's unknowns are fitted first and stay in every comparison: what
geometry can explain is geometry. Every registered effect is then a candidate. Its columns, with geometry and instrument
projected out, say how much of the misfit it could explain that nothing else does; the gain in chi2 is charged for its
coefficients and for the search (limbs, orders, times). What is chosen is refitted exactly, jointly with everything, and
the search goes on from there until nothing earns its price; then it goes backwards.

Two errors are worse than silence: naming physics that is not there, and forcing a name on what no effect explains.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from deltacal_gen import identification
from deltacal_gen.discrimination import Question, next_measurements
from deltacal_gen.errors import InputError, NoSolutionError
from deltacal_gen.estimation import Fit, Problem, fit, held_out, pose_problem, rms
from deltacal_gen.identification import Noise, folds, noise
from deltacal_gen.mechanism import Array, load_mechanism
from deltacal_gen.physics import Body, Term, blank, effect_names, load_effect, term_to_dict
from deltacal_gen.recording import Recording, check_units
from deltacal_gen.robot import Robot, robot_to_dict
from deltacal_gen.solvers import Prior

SCHEMA = "deltacal.diagnosis/1"
MARGIN = 10.0  # of chi2, beyond all charges: what an effect must earn to be named
AMBIGUOUS = 10.0  # of chi2: two explanations closer than this are not told apart
MOST_EFFECTS = 3
MACHINED = 5.0  # standard deviation of a source error, in ordinary ones: geometry may not strain to imitate physics
ORDERS = 100  # integer orders of a periodic error that are searched
ROOM = 10.0  # mm: root mean square that an effect's coefficient may well move the readings, a prior that never pulls
FUNCTIONS = 6  # of a channel, that a physics-free rival may combine
STRUCTURE = 25.0  # of chi2, beyond its charge: structure that is left in what should be noise
Progress = Callable[[str], None]


@dataclass(frozen=True)
class Candidate:
    """An effect with its searched constants, on all limbs, and where its columns stand."""

    term: Term
    start: int

    @property
    def name(self) -> str:
        return self.term.effect

    def columns(self, limbs: Sequence[int]) -> list[int]:
        """Return the columns of a subset of limbs (from 1); all of them for an effect of the whole machine."""
        n_c = self.term.values.shape[1]
        if not self.term.limbs:
            return list(range(self.start, self.start + n_c))
        return [self.start + self.term.limbs.index(i) * n_c + j for i in limbs for j in range(n_c)]

    def subsets(self) -> list[tuple[int, ...]]:
        """Return the sets of limbs that are considered."""
        limbs = self.term.limbs
        if not limbs:
            return [()]
        return [s for n in range(1, len(limbs) + 1) for s in itertools.combinations(limbs, n)]


@dataclass(frozen=True)
class Found:
    """A candidate's best form: its gain in chi2 and what is left of it after all charges."""

    candidate: Candidate
    limbs: tuple[int, ...]
    gain: float
    score: float

    @property
    def term(self) -> Term:
        """The term that it would add to the machine."""
        t = self.candidate.term
        return blank(t.effect, self.limbs, t.constants, t.tool)


class Search:
    """The linear problem at a fit: residual and candidates' columns with everything already fitted projected out."""

    def __init__(self, at: Fit, terms: Sequence[Term]) -> None:
        self.at, problem = at, at.problem
        machine = problem.solve(at.errors)
        state = problem.linearise(at.errors, at.instrument, machine)
        read = np.isfinite(state.residual)
        # the residual carries the influence of a reading, its columns none of it: a gross error can earn but little
        w = np.sqrt(1 + at.repeats.ratio) / np.broadcast_to(at.sigma, state.residual.shape)
        candidates, start = [], 0
        for term in terms:
            candidates.append(Candidate(term, start))
            start += term.n_coefficients
        self.candidates = candidates
        raw = problem.term_columns(terms, at.instrument, machine)

        def rows(values: Array) -> Array:
            scaled = np.where(read[..., None], values * w[..., None], 0.0)
            return at.repeats.whiten(scaled)[read]

        base = rows(np.concatenate([state.J_p * problem.scale, state.J_m], axis=2))
        r = rows((state.residual * at.weights[:, None])[..., None])[:, 0]
        n = len(problem.scale)
        # the prior's rows: geometry moves as far as drawings leave it open, not to the ends of a flat direction
        prior = np.concatenate([np.eye(n), np.zeros((n, base.shape[1] - n))], axis=1)
        Q_all = np.linalg.qr(np.vstack([base, prior]))[0]
        Q = Q_all[: len(r)]
        columns = rows(raw)
        self.size = np.linalg.norm(columns, axis=0)
        columns = columns / np.maximum(self.size, 1e-300)
        # what the base cannot follow: with the prior's rows the projection is (I - Q Q^T) on the readings' part
        self.rest = 1.0 - np.einsum("ij,ij->j", Q.T @ columns, Q.T @ columns)
        self.gram = columns.T @ columns - (Q.T @ columns).T @ (Q.T @ columns)
        departure = (at.errors[problem.columns] - problem.reference[problem.columns]) / problem.scale
        pulled = np.concatenate([r, -departure])
        left = pulled - Q_all @ (Q_all.T @ pulled)
        self.reach = columns.T @ left[: len(r)]
        self.readings = len(r)

    def gain(self, columns: Sequence[int]) -> float:
        """Return by how much columns, fitted together with all that is fitted already, lower chi2."""
        seen = [j for j in columns if self.rest[j] > 1e-6]
        if not seen:
            return 0.0
        G, b = self.gram[np.ix_(seen, seen)], self.reach[seen]
        values, vectors = np.linalg.eigh(G)
        keep = values > 1e-8 * values[-1]
        along = vectors[:, keep].T @ b
        return float(np.sum(along**2 / values[keep]))

    def fitted(self, found: Found) -> Term:
        """Return what was found with the coefficients that explain most."""
        columns = found.candidate.columns(found.limbs)
        values = np.linalg.pinv(self.gram[np.ix_(columns, columns)], rcond=1e-8, hermitian=True) @ self.reach[columns]
        return found.term.with_values(values / self.size[columns])

    def best(self, name: str, sets: dict[str, int]) -> Found | None:
        """Return an effect's best form over its constants and limbs, charged for both."""
        best: Found | None = None
        for candidate in self.candidates:
            if candidate.name != name:
                continue
            for limbs in candidate.subsets():
                columns = candidate.columns(limbs)
                gain = self.gain(columns)
                # BIC for the coefficients; twice the logarithm of how many forms were looked at, for the search
                charge = len(columns) * np.log(self.readings) + 2 * np.log(sets[name])
                if best is None or gain - charge > best.score:
                    best = Found(candidate, limbs, gain, gain - charge)
        return best


@dataclass(frozen=True)
class Diagnosis:
    """What was found; `to_dict` gives the contract's DIAGNOSIS.json."""

    verdict: str
    baseline: Fit
    final: Fit
    effects: tuple[Named, ...]
    heldout: tuple[float, float]
    noise: Noise
    location: dict[str, Any]
    rejected: list[dict[str, Any]]
    not_tested: list[dict[str, str]]
    next_measurements: list[dict[str, Any]]
    robot: Robot

    def to_dict(self) -> dict[str, Any]:
        """Return the contract's DIAGNOSIS.json."""
        return _result(self)


@dataclass(frozen=True)
class Named:
    """An effect that was found, with the gain in chi2 that it brings beside all others.

    `rivals` explain the same misfit as well; `unrecorded` name effects that could, through a channel that was not
    recorded or did not vary.
    """

    term: Term
    std: Array
    gain: float
    share: float
    rivals: tuple[Term, ...]
    unrecorded: tuple[str, ...]

    @property
    def alike(self) -> tuple[str, ...]:
        """Names of the effects that the readings cannot tell from it."""
        return (*(t.effect for t in self.rivals), *self.unrecorded)


def diagnose(robot: Robot, recording: Recording, *, progress: Progress = lambda text: None) -> Diagnosis:
    """Find where model and recording differ, and which physics was left out.

    Parameters
    ----------
    progress : callable
        Told in words what is being done.

    Raises
    ------
    InputError
        The recording cannot be used at all: too few readings, joints at which the machine cannot stand.
    """
    check_units(recording, robot)
    mechanism = load_mechanism(robot.mechanism)
    names = mechanism.model(mechanism.full_model)
    problem = pose_problem(robot, recording, names)
    scale = np.array([robot.tolerance.get(n, MACHINED * s) for n, s in zip(names, problem.scale, strict=True)])
    problem = dataclasses.replace(problem, scale=scale)
    identification.enough(mechanism, problem, recording)
    identification.distinct(problem, recording)
    progress("geometry")
    rough = identification.rough(problem, mechanism, robust=True)
    identification.plausible(rough, mechanism)
    identification.check_rows(rough, recording)
    # what is left out may look like gross errors where it is strongest: none is dropped before it is known
    baseline = fit(
        problem, Prior(), errors=rough.errors, instrument=rough.instrument, drop_gross=False, must_converge=False
    )
    terms, not_tested = library(problem)
    sets = _sets(terms)
    current: Fit = baseline
    chosen: list[Term] = []
    considered: dict[str, Found] = {}
    questions: list[Question] = []
    for n in range(MOST_EFFECTS):
        progress(f"search {n + 1}: {len(terms)} forms of {len(sets)} effects")
        search = Search(current, [t for t in terms if t.effect not in {c.effect for c in chosen}])
        ranked = sorted((f for name in sets if (f := search.best(name, sets)) is not None), key=lambda f: -f.score)
        if n == 0:
            considered = {f.candidate.name: f for f in ranked}
        if not ranked or ranked[0].score < MARGIN:
            if ranked and ranked[0].score > 0:
                questions = [Question(search.fitted(ranked[0]), proven=False)]
            break
        better = _with_terms(problem, current, [*chosen, ranked[0].term])
        if better is None:
            break
        current, chosen = better, list(better.problem.split(better.errors)[1])
        current, chosen = _revised(problem, current, terms, sets, progress)
    if not chosen:
        n_p = len(mechanism.parameters)
        current = fit(
            problem, Prior(), errors=baseline.errors[:n_p], instrument=baseline.instrument, must_converge=False
        )
    progress("held-out error")
    parts = folds(problem.readings, recording)
    before = held_out(baseline, Prior(), parts)
    heldout = (before, held_out(current, Prior(), parts) if chosen else before)
    structures = _structures(current)
    left = _left(current, recording, structures)
    verdict = "unexplained" if left else "missing_physics" if chosen else "adequate"
    progress("uncertainty and rivals")
    named = tuple(_named(problem, baseline, current, i, terms, sets) for i in range(len(chosen)))
    location = _location(current, structures, named, explained=not left)
    progress("what to measure next")
    questions = [*(Question(n.term, n.rivals, n.unrecorded) for n in named), *questions]
    fitted = current.errors[: len(mechanism.parameters)]
    calibrated = dataclasses.replace(
        robot, errors={p.name: float(v) for p, v in zip(mechanism.parameters, fitted, strict=True)}
    )
    return Diagnosis(
        verdict=verdict,
        baseline=baseline,
        final=current,
        effects=named,
        heldout=heldout,
        noise=noise(current, recording),
        location=location,
        rejected=_rejected(considered, named),
        not_tested=not_tested,
        next_measurements=next_measurements(current, questions, location if left else None),
        robot=calibrated,
    )


# ------------------------------------------------------------------------------------------------------- candidates


def library(problem: Problem) -> tuple[list[Term], list[dict[str, str]]]:
    """Return every form of every effect that the recording can carry, and those it cannot with what is missing."""
    limbs = tuple(range(1, problem.mechanism.limbs + 1))
    terms: list[Term] = []
    missing: list[dict[str, str]] = []
    for name in effect_names():
        if why := problem.body.missing(name):
            missing.append({"name": name, "missing": why})
            continue
        if why := _constant(problem, name):
            missing.append({"name": name, "missing": why})
            continue
        terms += [blank(name, limbs, c, tool) for c, tool in _forms(problem, name)]
    return terms, missing


def _constant(problem: Problem, name: str) -> str | None:
    """Return why an effect could not show on these rows: its channel does not vary, or its columns do not exist."""
    kernels, have, kind = load_effect(name), problem.body.channels, problem.readings.kind
    rows = np.unique(problem.readings.rows)
    for state, channel, words in (
        ("approach", have.approach, "both directions of approach"),
        ("speed", have.speed, "motion in the columns qd"),
        ("acceleration", have.acceleration, "motion in the columns qdd"),
        ("inertia_torque", have.acceleration, "motion in the columns qdd"),
        ("warming", have.warming, "temperatures that differ"),
        ("time", have.time, "times that differ"),
    ):
        if state in kernels.STATE and channel is not None and np.ptp(channel[rows], axis=0).max() == 0:
            return words
    if "payload_torque" in kernels.STATE and np.ptp(have.payload[rows]) == 0:
        return "payloads that differ in the column payload_kg"
    reads = [t for t in kernels.TARGETS if t == "length" or t.startswith("reading.")]
    if reads and not any((t == "length") == (kind in ("distance", "gauge")) for t in reads):
        return f"readings of another kind than {kind}"
    if any(t.startswith("tool.") for t in kernels.TARGETS) and len(_tools(problem)) < 2:
        return "readings of a second point of the platform"
    return None


def _tools(problem: Problem) -> list[tuple[float, ...]]:
    used = np.unique(problem.readings.rows)
    return [tuple(t) for t in np.unique(np.round(problem.body.tool[used], 9), axis=0).tolist()]


def _forms(problem: Problem, name: str) -> list[tuple[tuple[float, ...], tuple[float, ...] | None]]:
    """Return the constants (and tool point) of every form of an effect that is searched."""
    if name == "transmission_eccentricity":
        orders = {float(k) for k in range(1, ORDERS + 1)}
        ratio = problem.robot.transmission.gear_ratio if problem.robot.transmission else None
        if ratio:
            orders |= {ratio * k for k in range(1, 6)}
        return [((k,), None) for k in sorted(orders)]
    if name == "zero_jump":
        used = np.unique(problem.readings.rows)
        clock = problem.body.channels.order if problem.body.channels.time is None else problem.body.channels.time
        times = np.unique(clock[used])
        edge = max(3, len(times) // 40)  # a jump needs rows on both sides
        return [((float(t),), None) for t in times[edge : len(times) - edge]]
    if name == "instrument_offset":
        return [((), t) for t in _tools(problem)[1:]]
    return [((), None)]


def _sets(terms: Sequence[Term]) -> dict[str, int]:
    """Return how many forms (constants times limbs) of each effect are looked at."""
    count: dict[str, int] = {}
    for t in terms:
        count[t.effect] = count.get(t.effect, 0) + max(2 ** len(t.limbs) - 1, 1)
    return count


# -------------------------------------------------------------------------------------------------------- fitting


def _with_terms(problem: Problem, at: Fit, terms: Sequence[Term]) -> Fit | None:
    """Return the joint fit of geometry, instrument and effects from a fit without the last of them."""
    raw = problem.term_columns(terms, at.instrument, at.problem.solve(at.errors))
    flat = np.where(np.isfinite(raw), raw, 0.0).reshape(-1, raw.shape[2])
    scale = ROOM * np.sqrt(len(flat)) / np.maximum(np.linalg.norm(flat, axis=0), 1e-300)
    joint = problem.with_terms(terms, scale)
    n_p = len(problem.mechanism.parameters)
    values = np.concatenate([t.values.ravel() for t in terms]) if terms else np.zeros(0)
    try:
        return fit(
            joint,
            Prior(),
            errors=np.concatenate([at.errors[:n_p], values]),
            instrument=at.instrument,
            must_converge=False,
        )
    except (NoSolutionError, InputError):
        return None


def _revised(
    problem: Problem, current: Fit, terms: Sequence[Term], sets: dict[str, int], progress: Progress
) -> tuple[Fit, list[Term]]:
    """Look at each effect again with the others held beside it: another form or another effect may now be better."""
    for _ in range(3):
        chosen = list(current.problem.split(current.errors)[1])
        changed = False
        for i, term in enumerate(chosen):
            others = [t for j, t in enumerate(chosen) if j != i]
            without = _with_terms(problem, current, others) if others else _baseline_again(problem, current)
            if without is None:
                continue
            search = Search(dataclasses.replace(without, sigma=current.sigma, weights=current.weights), terms)
            ranked = [f for name in sets if (f := search.best(name, sets)) is not None]
            best = max(ranked, key=lambda f: f.score)
            if best.score < MARGIN:
                current, changed = without, True
                break
            same = best.candidate.name == term.effect and best.limbs == term.limbs
            if same and best.candidate.term.constants == term.constants:
                continue
            better = _with_terms(problem, without, [*others, best.term])
            if better is not None and _objective(better) < _objective(current) + 1e-6:
                current, changed = better, True
                break
        if not changed:
            break
    return current, list(current.problem.split(current.errors)[1])


def _objective(found: Fit) -> float:
    """Return a figure by which fits of different effects compare: readings times the log of variance, and charges."""
    scalars = int(np.isfinite(found.residual).sum())
    n_c = sum(t.n_coefficients for t in found.problem.split(found.errors)[1])
    return scalars * 2 * float(np.log(found.sigma[0])) + n_c * float(np.log(scalars))


def _baseline_again(problem: Problem, current: Fit) -> Fit:
    n_p = len(problem.mechanism.parameters)
    return fit(problem, Prior(), errors=current.errors[:n_p], instrument=current.instrument, must_converge=False)


# ------------------------------------------------------------------------------------------------- what is left


def _left(current: Fit, recording: Recording, structures: Sequence[Structure]) -> bool:
    """Tell whether what is left is more than noise: against a noise known beforehand, and by the structure in it."""
    return identification.lack_of_fit(current, recording) or any(f.earned > STRUCTURE for f in structures)


def _structures(at: Fit) -> list[Structure]:
    """Return what smooth, physics-free terms along each channel explain of what a fit leaves, the strongest first.

    The rival that knows no physics: any dependence on a channel that shows in the joints or in the reading.
    """
    smooth = _Smooth(at)
    found = [smooth.along(name, functions, places) for name, (functions, places) in _bases(at.problem).items()]
    return sorted(found, key=lambda f: -f.earned)


@dataclass(frozen=True)
class Structure:
    """Dependence on a channel: gain in chi2, the charge for the functions used, and where it sits if it is local."""

    channel: str
    gain: float
    charge: float
    used: tuple[int, ...]
    region: tuple[tuple[float, float, float], float] | None

    @property
    def earned(self) -> float:
        """Gain beyond the charge."""
        return self.gain - self.charge


class _Smooth:
    """Displacements of each joint and of the reading, modulated by functions of the rows, beside all that is fitted."""

    def __init__(self, at: Fit) -> None:
        problem = at.problem
        self._at, self._problem = at, problem
        machine = problem.solve(at.errors)
        used = np.unique(problem.readings.rows)
        rows = machine.rows if len(machine.rows) == 1 else machine.rows[used]
        S = problem.mechanism.sensitivity(machine.x[used], machine.q[used], machine.tool[used], rows)
        self._dx = np.zeros((len(machine.x), problem.mechanism.n_x, problem.mechanism.limbs + 3))
        self._dx[used, :, : problem.mechanism.limbs] = S.joints
        self._dx[used, :3, problem.mechanism.limbs :] = np.eye(3)
        self._machine = machine
        state = problem.linearise(at.errors, at.instrument, machine)
        self._read = np.isfinite(state.residual)
        self._w = np.sqrt(1 + at.repeats.ratio) / np.broadcast_to(at.sigma, state.residual.shape)
        base = self._rows(np.concatenate([state.J_p * problem.scale, state.J_m], axis=2))
        r = self._rows((state.residual * at.weights[:, None])[..., None])[:, 0]
        n = len(problem.scale)
        prior = np.concatenate([np.eye(n), np.zeros((n, base.shape[1] - n))], axis=1)
        self._Q = np.linalg.qr(np.vstack([base, prior]))[0][: len(r)]
        self._r = r - self._Q @ (self._Q.T @ r)
        self.readings = len(r)

    def _rows(self, values: Array) -> Array:
        scaled = np.where(self._read[..., None], values * self._w[..., None], 0.0)
        return self._at.repeats.whiten(scaled)[self._read]

    def _columns(self, functions: Array, directions: Sequence[int]) -> Array:
        """Return projected unit columns (rows, functions, directions)."""
        dx = self._dx[:, :, None, list(directions)] * functions[:, None, :, None]
        J, _ = self._at.instrument.linearise(self._problem.readings, self._machine.x, dx.reshape(*dx.shape[:2], -1))
        A = self._rows(J)
        A = A / np.maximum(np.linalg.norm(A, axis=0), 1e-300)
        A = A - self._Q @ (self._Q.T @ A)
        return A.reshape(len(A), functions.shape[1], len(directions))

    def along(
        self, channel: str, functions: Array, places: Sequence[tuple[tuple[float, float, float], float] | None]
    ) -> Structure:
        """Return what the best few functions of a channel explain, each charged for its columns and its choice."""
        directions = range(self._dx.shape[2])
        A = self._columns(functions, directions)
        r, gain, charge = self._r.copy(), 0.0, 0.0
        chosen: list[int] = []
        price = A.shape[2] * float(np.log(self.readings)) + 2 * float(np.log(max(A.shape[1], 2)))
        taken = np.zeros((len(r), 0))
        for _ in range(min(FUNCTIONS, A.shape[1])):
            gains = np.array([_explained(A[:, k], r) for k in range(A.shape[1])])
            k = int(np.argmax(gains))
            if gains[k] < price:
                break
            taken = np.hstack([taken, A[:, k]])
            Q = np.linalg.qr(taken)[0]
            left = self._r - Q @ (Q.T @ self._r)
            gain, charge, r = float(self._r @ self._r - left @ left), charge + price, left
            A = A - np.einsum("ij,jkl->ikl", Q, np.einsum("ij,ikl->jkl", Q, A))
            chosen.append(k)
        region = places[chosen[0]] if chosen else None
        return Structure(channel, gain, charge, tuple(chosen), region)

    def limbs(self, functions: Array) -> list[int]:
        """Return the limbs whose joints carry a dependence on functions (N, m) of a channel; none where readings do."""
        every = range(1, self._problem.mechanism.limbs + 1)
        A = self._columns(functions, [i - 1 for i in every])
        best: list[int] = []
        best_score = 0.0
        for n in every:
            for subset in itertools.combinations(every, n):
                columns = A[:, :, [i - 1 for i in subset]].reshape(len(A), -1)
                score = _explained(columns, self._r) - columns.shape[1] * float(np.log(self.readings))
                if score > best_score:
                    best, best_score = list(subset), score
        seen = self._columns(functions, range(len(every), len(every) + 3)).reshape(len(A), -1)
        as_reading = _explained(seen, self._r) - seen.shape[1] * float(np.log(self.readings))
        return best if best_score > as_reading else []


def _explained(A: Array, r: Array) -> float:
    """Return the part of |r|^2 that the columns of A explain."""
    U, s, _ = np.linalg.svd(A, full_matrices=False)
    keep = s > 1e-3
    return float(np.sum((U[:, keep].T @ r) ** 2))


_Places = list[tuple[tuple[float, float, float], float] | None]


def _bases(problem: Problem) -> dict[str, tuple[Array, _Places]]:
    """Return functions (N, m) of every channel, joint and of the position; of local ones, where they sit."""
    recording, body = problem.recording, problem.body
    rows = np.unique(problem.readings.rows)
    out: dict[str, tuple[Array, _Places]] = {}
    joint = "deg" if recording.joint_unit == "rad" else "mm"
    named = {f"q{i + 1}_{joint}": q for i, q in enumerate(body.q.T)}
    for name, values in {**recording.channels, **named}.items():
        if name.startswith("true_") or not np.isfinite(values[rows]).any():
            continue
        v = np.nan_to_num(values, nan=float(np.nanmedian(values[rows])))
        if np.ptp(v[rows]) > 0:
            functions = _functions(v, rows)
            out[name] = functions, [None] * functions.shape[1]
    x, _ = body.mechanism.forward(body.q, body.tool, body.mechanism.rows(problem.robot))
    x = np.nan_to_num(x[:, :3])
    span = float(np.linalg.norm(np.ptp(x[rows], axis=0))) / 2
    centres = [rows[0]]
    while len(centres) < min(24, len(rows)):  # the farthest point of what is measured, again and again
        gap = np.min([np.linalg.norm(x[rows] - x[c], axis=1) for c in centres], axis=0)
        centres.append(rows[int(np.argmax(gap))])
    radii = [part * span for part in (0.15, 0.25, 0.4)]
    bumps = [np.exp(-0.5 * (np.linalg.norm(x - x[c], axis=1) / radius) ** 2) for c in centres for radius in radii]
    places: _Places = [((float(x[c, 0]), float(x[c, 1]), float(x[c, 2])), r) for c in centres for r in radii]
    out["position"] = np.column_stack(bumps), places
    return out


def _functions(v: Array, rows: np.ndarray) -> Array:
    """Return functions (N, m) of a channel: its levels where it has few values, powers and waves where it has many."""
    levels = np.unique(v[rows])
    if len(levels) <= 4:
        return np.column_stack([(v == level).astype(float) for level in levels[1:]])
    t = (v - v[rows].min()) / np.ptp(v[rows])
    s = 2 * t - 1
    most = int(np.clip(len(levels) // 4, 2, 40))
    waves = [f(2 * np.pi * k * t) for k in range(1, most + 1) for f in (np.cos, np.sin)]
    return np.column_stack([s, s**2 - 1 / 3, s**3 - 0.6 * s, *waves])


_CHANNELS = {  # of the recording, for what effects read
    "approach": "approach{}",
    "speed": "qd{}_deg_s",
    "acceleration": "qdd{}_deg_s2",
    "inertia_torque": "qdd{}_deg_s2",
    "warming": "temp_C",
    "time": "time_s",
    "after": "time_s",
    "payload_torque": "payload_kg",
    "torque": "q{}_deg",
    "pull_v": "q{}_deg",
    "tension_1": "q{}_deg",
    "moment_x": "position",
    "q": "q{}_deg",
    "theta": "q{}_deg",
}


def _location(at: Fit, structures: Sequence[Structure], named: Sequence[Named], explained: bool) -> dict[str, Any]:
    """Return channels by their share of the misfit, the limbs, the region where it is local, and all in words.

    Where effects explain the misfit they say what it depends on; elsewhere the strongest structures do.
    """
    channels: dict[str, tuple[float, float]] = {}
    limbs: list[int] = sorted({i for n in named for i in n.term.limbs}) if explained else []
    region: tuple[tuple[float, float, float], float] | None = None
    if explained:
        for n in named:
            for state in n.term.kernels.STATE:
                pattern = _CHANNELS.get(state)
                for i in n.term.limbs or (1, 2, 3):
                    if pattern is not None:
                        name = pattern.format(i)
                        share = max(n.share, channels.get(name, (0.0, 1.0))[0])
                        channels[name] = (share, float(np.exp(-min(n.gain, 1400.0) / 2)))
    else:
        total = float(np.nansum((at.residual / at.sigma) ** 2))
        for f in structures:
            if f.earned > 0:
                channels[f.channel] = (min(f.earned / total, 1.0), float(np.exp(-min(f.earned, 1400.0) / 2)))
        strongest = next((f for f in structures if f.earned > 0), None)
        if strongest is not None:
            functions, _ = _bases(at.problem)[strongest.channel]
            limbs = _Smooth(at).limbs(functions[:, list(strongest.used)])
            if strongest.region is not None:
                region, limbs = strongest.region, []
    ordered = sorted(channels.items(), key=lambda kv: -kv[1][0])
    first = ordered[0][0] if ordered else None
    if first is None:
        text = "what is left depends on nothing that was recorded"
    elif region is not None:
        x, y, z = region[0]
        text = f"the misfit sits in a region of the workspace around ({x:.0f}, {y:.0f}, {z:.0f}) mm"
    else:
        text = f"the misfit depends on {first}"
    if limbs:
        text += f", at limb{'s' if len(limbs) > 1 else ''} {', '.join(map(str, limbs))}"
    return {
        "channels": [{"name": name, "p_value": p, "share": share} for name, (share, p) in ordered],
        "limbs": limbs,
        "region": None if region is None else {"centre_mm": list(region[0]), "radius_mm": region[1]},
        "text": text,
    }


# ------------------------------------------------------------------------------------------------ what was found


def _named(problem: Problem, baseline: Fit, current: Fit, i: int, terms: Sequence[Term], sets: dict[str, int]) -> Named:
    chosen = list(current.problem.split(current.errors)[1])
    term = chosen[i]
    n = len(problem.names)
    before = sum(t.n_coefficients for t in chosen[:i])
    own = slice(n + before, n + before + term.n_coefficients)
    C = current.covariance[own, own]
    std = np.sqrt(np.maximum(np.diag(C), 0.0))
    value = term.values.ravel()
    gain = float(value @ np.linalg.pinv(C) @ value)
    others = [t for j, t in enumerate(chosen) if j != i]
    without = _with_terms(problem, current, others) if others else baseline
    rivals: list[Term] = []
    unrecorded: list[str] = []
    share = 1.0
    if without is not None:
        search = Search(dataclasses.replace(without, sigma=current.sigma, weights=current.weights), terms)
        mine = search.best(term.effect, sets)
        if mine is not None:
            for name in sets:
                rival = search.best(name, sets)
                if name == term.effect or rival is None or name in {t.effect for t in others}:
                    continue
                if mine.gain - rival.gain < AMBIGUOUS and rival.score > mine.score - 1.5 * AMBIGUOUS:
                    rivals.append(rival.term)
            unrecorded = _unrecorded(search.at, mine.gain)
        excess = float(baseline.sigma[0] ** 2 - current.sigma[0] ** 2)
        share = float((without.sigma[0] ** 2 - current.sigma[0] ** 2) / excess) if excess > 0 else 0.0
    return Named(term, std, gain, min(max(share, 0.0), 1.0), tuple(rivals), tuple(unrecorded))


def _unrecorded(at: Fit, gain: float) -> list[str]:
    """Return effects of a temperature that was not recorded, or did not vary, that explain as much all the same."""
    body = at.problem.body
    warming = body.channels.warming
    rows = np.unique(at.problem.readings.rows)
    if warming is not None and (not np.isfinite(warming[rows]).all() or np.ptp(warming[rows]) > 0):
        return []
    warm = np.ones(len(body.q)) if warming is None else warming
    assumed = Body(body.robot, body.mechanism, body.q, body.tool, dataclasses.replace(body.channels, warming=warm))
    limbs = tuple(range(1, body.mechanism.limbs + 1))
    terms = [
        blank(name, limbs)
        for name in effect_names()
        if "warming" in load_effect(name).STATE and assumed.missing(name) is None
    ]
    search = Search(dataclasses.replace(at, problem=dataclasses.replace(at.problem, body=assumed)), terms)
    found = [search.best(t.effect, _sets(terms)) for t in terms]
    return [f.candidate.name for f in found if f is not None and gain - f.gain < AMBIGUOUS]


def _rejected(considered: dict[str, Found], named: Sequence[Named]) -> list[dict[str, Any]]:
    chosen = {n.term.effect for n in named}
    return [
        {
            "name": name,
            "gain_chi2": f.gain,
            "why": "earns less than the charge for its coefficients and for the search"
            if f.score < MARGIN
            else "explains less of the same misfit than what was named"
            if chosen
            else "explains part of the misfit, but does not hold",
        }
        for name, f in sorted(considered.items(), key=lambda kv: -kv[1].gain)
        if name not in chosen
    ]


def _result(found: Diagnosis) -> dict[str, Any]:
    baseline, final = found.baseline, found.final
    sigma, source = found.noise.sigma, found.noise.source

    def summary(at: Fit, heldout: float) -> dict[str, Any]:
        return {
            "train_rms_mm": at.rms(),
            "heldout_rms_mm": heldout if np.isfinite(heldout) else None,
            "chi2_per_dof": (float(at.sigma[0]) / sigma) ** 2,
        }

    return {
        "schema": SCHEMA,
        "verdict": found.verdict,
        "summary": _summary(found),
        "noise": {"sigma_mm": sigma, "source": source},
        "baseline": {"model": found.baseline.problem.mechanism.full_model} | summary(baseline, found.heldout[0]),
        "location": found.location,
        "effects": [_effect(n) for n in found.effects],
        "final": summary(final, found.heldout[1]),
        "rejected": found.rejected,
        "not_tested": found.not_tested,
        "next_measurements": found.next_measurements,
        "gross_errors": [int(final.problem.readings.line[j]) for j in final.gross],
        "residuals": _residuals(found),
        "sigma_mm": sigma,
        "physics": [term_to_dict(n.term) for n in found.effects],
        "clock": "row" if final.problem.body.channels.time is None else "time_s",
        "instrument": final.instrument.to_dict()
        | {"setups": list(final.problem.recording.setup_names), "zero": final.problem.recording.measurement.zero},
        "robot": robot_to_dict(found.robot),
    }


def _residuals(found: Diagnosis) -> dict[str, Any]:
    """Return what every reading is off, before and after, where it was read and what the channels said there."""
    problem = found.final.problem
    rows = problem.readings.rows[:, 0]
    machine = problem.solve(found.final.errors)
    channels = {
        name: [None if np.isnan(v) else float(v) for v in values[rows]]
        for name, values in problem.recording.channels.items()
        if not name.startswith("true_")
    }
    degrees = problem.recording.joint_unit == "rad"
    for i, q in enumerate(problem.body.q.T):
        channels[f"q{i + 1}_{'deg' if degrees else 'mm'}"] = (np.degrees(q) if degrees else q)[rows].tolist()
    return {
        "line": problem.readings.line.tolist(),
        "position_mm": machine.x[rows, :3].tolist(),
        "before_mm": np.nan_to_num(found.baseline.residual[:, :3]).tolist(),
        "after_mm": np.nan_to_num(found.final.residual[:, :3]).tolist(),
        "channels": channels,
    }


def _effect(found: Named) -> dict[str, Any]:
    term, kernels = found.term, found.term.kernels
    parameters: list[dict[str, Any]] = []
    std = found.std.reshape(term.values.shape)
    for r, row in enumerate(term.values):
        limb = term.limbs[r] if term.limbs else None
        for c, (name, unit, factor, _) in enumerate(kernels.COEFFICIENTS):
            parameters.append(
                {"name": name, "limb": limb, "value": row[c] / factor, "std": std[r, c] / factor, "unit": unit}
            )
    for value, (name, unit, factor, _) in zip(term.constants, kernels.CONSTANTS, strict=True):
        parameters.append({"name": name, "limb": None, "value": value / factor, "std": None, "unit": unit})
    return {
        "name": term.effect,
        "title": kernels.TITLE,
        "limbs": list(term.limbs),
        "parameters": parameters,
        "p_value": float(np.exp(-min(found.gain, 1400.0) / 2)),
        "gain_chi2": found.gain,
        "share_of_excess": found.share,
        "indistinguishable_from": list(found.alike),
    }


def _summary(found: Diagnosis) -> str:
    before, after = found.heldout
    if found.verdict == "adequate":
        return (
            f"Nothing is missing: what the calibrated geometry leaves, {before:.4f} mm on held-out readings, is noise. "
            "Use the calibrated machine."
        )
    parts = []
    for n in found.effects:
        limbs = (
            f" at limb{'s' if len(n.term.limbs) > 1 else ''} {', '.join(map(str, n.term.limbs))}"
            if n.term.limbs
            else ""
        )
        parts.append(f"{n.term.kernels.TITLE} ({n.term.effect}){limbs}")
    if found.verdict == "missing_physics":
        return (
            f"Geometry alone leaves {before:.4f} mm on held-out readings. What is missing: {'; '.join(parts)}. "
            f"With it {after:.4f} mm are left, which is noise."
        )
    named = f" Proven beside it: {'; '.join(parts)}." if parts else ""
    return (
        f"A mismatch of {rms(found.final.residual):.4f} mm is left that no registered effect explains: "
        f"{found.location['text']}.{named}"
    )
