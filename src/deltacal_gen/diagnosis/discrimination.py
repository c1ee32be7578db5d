"""What to measure next, where a recording leaves a question open.

Two explanations of one misfit are told apart by readings that the wrong one cannot follow. If one of them holds, a fit
of the other beside geometry and instrument leaves a misfit; poses and values of the channels are chosen one by one so
that this misfit, expected in chi2, grows most. That is T-optimality (Atkinson and Fedorov 1975, Biometrika 62, 57-70)
at the fit of the diagnosis, with the one of the two as the truth that is the harder to prove.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.estimation.fit import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import SOLVED, Array
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.states import columns
from deltacal_gen.physics.terms import Term
from deltacal_gen.results.diagnosis import Location, NextMeasurement, Row
from deltacal_gen.units import joint_factors, joint_names, of_joints, to_file

# Of chi2. A difference D between two explanations scatters by 2 sqrt(D): at 40 it stays above 10, below which a
# diagnosis tells nothing apart, in 99 of 100 recordings.
CLEAR = 40.0
LEAST = 10.0  # of chi2: poses that promise less are not worth a trip to the machine
FEWEST_POSES, MOST_POSES = 3, 16  # no single reading decides: it may be a gross error
CANDIDATES = 1500  # joints and channels drawn at random, from which the poses are chosen
WIDER = 0.1  # of the range of joints that was recorded: how far beyond it poses may go where nothing says more
WARMER = 10.0  # K
LONGER = 1.0  # times the session: when the last of the proposed readings may be taken
SEED = 1975
LEVELS, REPEATED = 5, 3  # of a channel, and poses that are repeated at each
WEAK = 1e-9  # of a column's information: holds what no reading sees, without pulling on what they do see
DECIMALS = 4  # of deg and mm: as precise as controllers take commands
COMMANDED = ("approach", "payload", "qd")  # channels that whoever measures sets; the others come as they come


def columns_read(problem: Problem, terms: Sequence[Term]) -> list[str]:
    """Return the columns of a recording that effects read, beside the joints."""
    read = (s for term in terms for s in term.states)
    return columns(read, problem.recording.joint_unit, problem.mechanism.limbs)


# ------------------------------------------------------------------------------------------------------ candidates


@dataclass(frozen=True)
class Candidates:
    """Readings that could be taken: a problem whose rows are poses with values of the channels.

    Attributes
    ----------
    problem : Problem
    ends : (C, 1) or (C, 2) int array
        Rows of each reading.
    position : (C, 3) array
        Where the measured point is, at its first end [mm].
    told : tuple of str
        Columns that a proposal states, beside the joints.
    """

    problem: Problem
    ends: np.ndarray
    position: Array
    told: tuple[str, ...]

    def to_rows(self, chosen: Sequence[int]) -> list[Row]:
        """Return readings as rows of a recording; a distance holds the joints of both its ends."""
        recording = self.problem.recording
        if "time_s" in self.told:
            chosen = sorted(chosen, key=lambda j: float(recording.channels["time_s"][self.ends[j, 0]]))
        rows = []
        for n, j in enumerate(chosen):
            row: Row = {"pose": f"next{n + 1}"}
            ends = self.ends[j].tolist()
            for end, k in zip(("a", "b") if len(ends) == 2 else ("",), ends, strict=True):
                row |= _joints(recording, k, end)
            if len(recording.setup_names) > 1:
                row["setup"] = recording.setup_names[recording.setup[ends[0]]]
            if recording.tool is not None:
                row |= {f"tool_{a}_mm": float(v) for a, v in zip("xyz", recording.tool[ends[0]], strict=True)}
            values = {name: float(recording.channels[name][ends[0]]) for name in self.told}
            row |= {name: value for name, value in values.items() if np.isfinite(value)}
            rows.append(row)
        return rows


def _joints(recording: Recording, row: int, end: str = "") -> dict[str, float]:
    """Return the joints of a row by their columns, of one end of a distance; shortened."""
    q, unit = recording.joints[row], recording.joint_unit
    names = joint_names(unit, len(q), f"q{{i}}{end}_{{unit}}")
    return {
        name: round(to_file(float(v), u), DECIMALS)
        for name, v, u in zip(names, q, of_joints(unit, len(q)), strict=True)
    }


def candidates(at: Fit, terms: Sequence[Term], rng: np.random.Generator) -> Candidates:
    """Return readings that could be taken next: joints within their limits, positions where the machine works.

    Channels that `terms` read take the ends of what was recorded, or of what may well be set; the commanded ones among
    the others are as in some row of the recording.
    """
    problem = at.problem
    recording, robot = problem.recording, problem.robot
    like = rng.integers(recording.n_rows, size=CANDIDATES)
    two = problem.readings.rows.shape[1] == 2
    if two:
        like[1::2] = like[::2]  # channels and measured point hold for both ends
    lower, upper = _joint_range(problem)
    unit = np.array(joint_factors(recording.joint_unit, len(lower)))
    joints = lower + rng.random((CANDIDATES, len(lower))) * (upper - lower)
    joints = np.round(joints / unit, DECIMALS) * unit
    channels = {name: values[like].copy() for name, values in recording.channels.items()}
    needed = columns_read(problem, terms)
    for name in needed:
        levels = _levels(problem, name)
        if levels is not None:
            drawn = rng.choice(levels, CANDIDATES)
            if two:
                drawn[1::2] = drawn[::2]
            channels[name] = drawn
    told = [n for n in channels if n in needed or n.startswith(COMMANDED)]
    rows = dataclasses.replace(
        recording,
        joints=joints,
        measured=np.zeros((CANDIDATES, 0)),
        pose=np.arange(CANDIDATES).astype(str),
        line=np.arange(CANDIDATES) + 2,
        channels=channels,
        setup=np.full(CANDIDATES, recording.setup[-1]),
        tool=None if recording.tool is None else problem.body.tool[like],
        pairs=np.arange(CANDIDATES).reshape(-1, 2) if two else None,
    )
    body = Body(
        robot,
        problem.mechanism,
        robot.joint_sign * joints,
        problem.body.tool[like],
        dataclasses.replace(Channels.of(rows, robot), order=np.full(CANDIDATES, float(recording.n_rows))),
    )
    whole = dataclasses.replace(problem, recording=rows, body=body, readings=kind_of(rows.kind).unread(rows))
    machine, status = body.solve(whole.split(at.errors)[0], whole.acting(at.errors))
    fit_for_use = (status == SOLVED) & _inside(problem, machine.x)
    if whole.readings.kind.sees_joints:
        fit_for_use[:] = True  # joints are within their limits, wherever that leads
    able = np.flatnonzero(fit_for_use[whole.readings.rows].all(axis=1))
    whole = whole.subset(able)
    ends = whole.readings.rows
    return Candidates(whole, ends, machine.x[ends[:, 0], :3], tuple(told))


def _joint_range(problem: Problem) -> tuple[Array, Array]:
    """Return the lowest and highest joints that may be commanded, as the controller counts."""
    if problem.robot.joint_limits is not None:
        lower, upper = problem.robot.joint_limits.T
        return lower, upper
    joints = problem.recording.joints[np.unique(problem.readings.rows)]
    spare = WIDER * np.ptp(joints, axis=0)
    return joints.min(axis=0) - spare, joints.max(axis=0) + spare


def _inside(problem: Problem, x: Array) -> np.ndarray:
    """Tell which poses (N, 12) lie where the machine works: in its workspace, or among what was measured."""
    space = problem.robot.workspace
    position = np.nan_to_num(x[:, :3], nan=np.inf)
    if space is not None:
        inside: np.ndarray = space.holds(position)
        return inside
    seen = problem.poses(problem.reference)[np.unique(problem.readings.rows), :3]
    between: np.ndarray = ((position >= seen.min(axis=0)) & (position <= seen.max(axis=0))).all(axis=1)
    return between


def _levels(problem: Problem, name: str) -> Array | None:
    """Return the values of a channel that are proposed, None where whoever measures cannot choose them."""
    recording = problem.recording
    used = np.unique(problem.readings.rows)
    values = recording.channels.get(name)
    seen = np.zeros(0) if values is None else np.unique(values[used][np.isfinite(values[used])])
    if name == "payload_kg":
        if len(seen) > 1:
            return seen if len(seen) <= 4 else seen[[0, -1]]
        masses = problem.robot.masses
        held = float(seen[0]) if len(seen) else 0.0
        return None if masses is None or not masses.platform else np.array([held, held + masses.platform])
    if not len(seen):
        return None
    if name.startswith("approach"):
        return np.array([-1.0, 1.0])
    if name == "time_s":
        gap, span = float(np.median(np.diff(seen))) if len(seen) > 1 else 60.0, float(np.ptp(seen))
        return np.round(seen[-1] + np.array([gap, gap + LONGER * span]), 1)
    if name == "temp_C" and np.ptp(seen) == 0:
        return seen[0] + np.array([0.0, WARMER])
    return np.array([seen[0], 0.0, seen[-1]]) if name.startswith("qd") else seen[[0, -1]]


# ------------------------------------------------------------------------------------------------- two explanations


class Refutation:
    """What a wrong model leaves of a displacement, and by how much further readings would raise it.

    Parameters
    ----------
    X : (M, p) array
        Columns of the wrong model, in units of the noise.
    d : (M,) array
        What the true one displaces, in units of the noise.
    prior : (p,) array
        Information on each parameter that comes from elsewhere.
    """

    def __init__(self, X: Array, d: Array, prior: Array) -> None:
        self._size = np.maximum(np.linalg.norm(X, axis=0), 1e-300)
        Z = X / self._size
        self._inverse = np.linalg.inv(Z.T @ Z + np.diag(prior / self._size**2 + WEAK))
        self._moment, self._whole = Z.T @ d, float(d @ d)

    @property
    def coefficients(self) -> Array:
        """Return the wrong model's best fit (p,) to the displacement."""
        fitted: Array = self._inverse @ self._moment / self._size
        return fitted

    @property
    def misfit(self) -> float:
        """Return the chi2 that the wrong model leaves."""
        return self._whole - float(self._moment @ self._inverse @ self._moment)

    def gains(self, X: Array, d: Array) -> Array:
        """Return by how much each of C readings, columns (C, k, p) and displacements (C, k), would raise the misfit."""
        Z = X / self._size
        unforeseen = d - Z @ (self._inverse @ self._moment)
        scatter = np.eye(Z.shape[1]) + Z @ self._inverse @ np.swapaxes(Z, 1, 2)
        gains: Array = np.einsum("ck,ck->c", unforeseen, np.linalg.solve(scatter, unforeseen[..., None])[..., 0])
        return gains

    def take(self, X: Array, d: Array) -> None:
        """Add one reading (k, p), (k,)."""
        Z = X / self._size
        ZP = Z @ self._inverse
        self._inverse = self._inverse - ZP.T @ np.linalg.solve(np.eye(len(Z)) + ZP @ Z.T, ZP)
        self._moment, self._whole = self._moment + Z.T @ d, self._whole + float(d @ d)


@dataclass(frozen=True)
class Proposal:
    """Readings that answer a question, and the difference in chi2 that they are expected to make."""

    rows: list[Row]
    expected: float


def separating(at: Fit, truth: Term, rival: Term | None, beside: Sequence[Term], rng: np.random.Generator) -> Proposal:
    """Return the readings that tell an effect from a rival, or from there being nothing.

    Parameters
    ----------
    at : Fit
        Of the geometry, with or without effects.
    truth : Term
        With its coefficients.
    rival : Term, optional
        Its coefficients are not read: it is as large as it must be to look like the truth so far.
    beside : sequence of Term
        Other effects that are on the machine whichever holds.
    """
    asked = [truth] if rival is None else [truth, rival]
    found = candidates(at, [*beside, *asked], rng)
    if not len(found.ends):
        return Proposal([], 0.0)
    base, rest = _columns(at, at.problem, [*beside, *asked])
    base_new, rest_new = _columns(at, found.problem, [*beside, *asked])
    ends = np.cumsum([t.n_coefficients for t in beside], dtype=int)[-1:].sum()
    n = truth.n_coefficients
    mine, theirs = slice(ends, ends + n), slice(ends + n, None)

    def duel(true: slice, coefficients: Array, wrong: slice) -> tuple[Refutation, Array, Array]:
        old, new = (
            np.concatenate([b, r[..., :ends], r[..., wrong]], axis=-1) for b, r in ((base, rest), (base_new, rest_new))
        )
        prior = np.zeros(old.shape[-1])
        prior[: len(at.problem.names)] = 1.0
        flat = old.reshape(-1, old.shape[-1])
        return (
            Refutation(flat, (rest[..., true] @ coefficients).ravel(), prior),
            new,
            rest_new[..., true] @ coefficients,
        )

    duels = [duel(mine, truth.values.ravel(), theirs)]
    if rival is not None:
        duels.append(duel(theirs, duels[0][0].coefficients[-rival.n_coefficients :], mine))
    chosen: list[int] = []
    before = min(d.misfit for d, *_ in duels)
    while len(chosen) < min(MOST_POSES, len(base_new)) and (
        len(chosen) < FEWEST_POSES or min(d.misfit for d, *_ in duels) < before + CLEAR
    ):
        after = np.min([d.misfit + d.gains(X, shift) for d, X, shift in duels], axis=0)
        after[chosen] = -np.inf
        best = int(np.argmax(after))
        chosen.append(best)
        for d, X, shift in duels:
            d.take(X[best], shift[best])
    return Proposal(found.to_rows(chosen), min(d.misfit for d, *_ in duels) - before)


def _columns(at: Fit, problem: Problem, terms: Sequence[Term]) -> tuple[Array, Array]:
    """Return what geometry and instrument, and what effects do to readings, (R, k, n) each, in units of the noise.

    Readings that were taken share what their repeats share, and weigh as in the fit.
    """
    machine = problem.solve(at.errors)
    taken = problem is at.problem
    if not taken:
        mounted = at.instrument.mounted(problem.mechanism, at.errors)
        values, rotations = mounted.predict(problem.readings, problem.seen(machine))
        problem = dataclasses.replace(
            problem, readings=dataclasses.replace(problem.readings, values=values, rotations=rotations)
        )
    state = problem.linearise(at.errors, at.instrument, machine)
    n = len(problem.names)
    base = np.concatenate([state.J_p[:, :, :n] * problem.scale[:n], state.J_m], axis=2)
    effects = problem.term_columns(terms, at.errors, at.instrument, machine)
    both = np.concatenate([base, effects], axis=2) / at.sigma[:, None]
    if taken:
        both *= (np.sqrt(at.weights)[:, None] * np.sqrt(1 + at.repeats.ratio))[..., None]
        both = at.repeats.whiten(np.where(np.isfinite(state.residual)[..., None], both, 0.0))
    return both[..., : base.shape[2]], both[..., base.shape[2] :]


# -------------------------------------------------------------------------------------------------------- proposals


@dataclass(frozen=True)
class Question:
    """What a diagnosis leaves open.

    Attributes
    ----------
    truth : Term
        An effect with its coefficients.
    rivals : tuple of Term
        Those that the readings cannot tell from it; their coefficients are not read.
    unrecorded : tuple of str
        Effects that could do the same through a channel that was not recorded or did not vary.
    proven : bool
        Whether the readings bear `truth` out against there being nothing.
    """

    truth: Term
    rivals: tuple[Term, ...] = ()
    unrecorded: tuple[str, ...] = ()
    proven: bool = True


def next_measurements(
    at: Fit, questions: Sequence[Question], unexplained: Location | None
) -> tuple[NextMeasurement, ...]:
    """Return what to measure next: readings as rows of a recording where poses help, in words what else would.

    Parameters
    ----------
    at : Fit
        Of the geometry with all effects that were named.
    questions : sequence of Question
    unexplained : Location, optional
        Where a misfit sits that no effect explains.
    """
    rng = np.random.default_rng(SEED)
    named = [q.truth for q in questions if q.proven]
    out = []
    for q in questions:
        beside = [t for t in named if t is not q.truth]
        if not q.proven:
            found = separating(at, q.truth, None, beside, rng)
            out.append(_entry(f"settles whether there is {q.truth.effect}", found, q.truth, None, at.problem))
        for rival in q.rivals:
            found = separating(at, q.truth, rival, beside, rng)
            why = f"separates {q.truth.effect} from {rival.effect}"
            out.append(_entry(why, found, q.truth, rival, at.problem))
        for name in q.unrecorded:
            out.append(_other_channel(q.truth.effect, name))
    if unexplained is not None:
        out.append(_exploring(at, unexplained, rng))
    return tuple(out)


def more_poses(problem: Problem) -> NextMeasurement:
    """Return the advice to measure as many poses again as there are: what a recording that is too short needs."""
    count = len(np.unique(problem.readings.group))
    text = (
        f"Measure at least {count} more readings at other poses, all over the workspace: deltacal plan proposes them."
    )
    return _advice("lets lesser effects show", text)


def _advice(why: str, text: str, poses: Sequence[Row] = (), expected: float | None = None) -> NextMeasurement:
    return NextMeasurement(why=why, text=text, poses=tuple(poses), expected_chi2=expected)


def _entry(why: str, found: Proposal, truth: Term, rival: Term | None, problem: Problem) -> NextMeasurement:
    if found.expected >= LEAST and found.rows:
        values = [n for n in columns_read(problem, [t for t in (truth, rival) if t]) if n in found.rows[0]]
        with_values = f", with {', '.join(values)} as given" if values else ""
        text = f"Measure these {len(found.rows)} poses{with_values}, without moving the instrument, and add them."
        return _advice(why, text, found.rows, found.expected)
    missing = [
        n for n in columns_read(problem, [t for t in (truth, rival) if t]) if n not in problem.recording.channels
    ]
    text = "No poses of this machine do."
    if missing:
        text += f" Record {', '.join(missing)} and vary what is recorded."
    if any(_reads_only(t) for t in (truth, rival) if t):
        text += " Hold the instrument against a length that is known."
    return _advice(why, text, expected=found.expected)


def _reads_only(term: Term) -> bool:
    return all(t == "length" or t.startswith("reading.") for t in term.kernels.TARGETS)


def _other_channel(named: str, unrecorded: str) -> NextMeasurement:
    return _advice(
        f"separates {named} from {unrecorded}",
        f"Record temp_C, and repeat the poses when the machine is at least {WARMER:g} K warmer or colder: "
        f"{unrecorded} follows the temperature, {named} does not.",
    )


def _exploring(at: Fit, location: Location, rng: np.random.Generator) -> NextMeasurement:
    """Return readings that show more of a misfit that nothing explains: where it sits, along what it depends on."""
    recording = at.problem.recording
    channel = location.channels[0].name if location.channels else None
    why = "shows more of what no effect explains"
    if channel is None:
        text = (
            "Repeat a few poses, and record what may matter: time_s, temp_C, payload_kg and the direction in which "
            "each joint last moved (approach1 ...)."
        )
        return _advice(why, text)
    region = location.region
    if region is None and channel in recording.channels:
        text = f"Repeat these poses at these values of {channel}: what then changes is not the pose."
        return _advice(why, text, _repeated(at.problem, channel))
    found = candidates(at, (), rng)
    if region is not None:
        gap = np.linalg.norm(found.position - np.asarray(region.centre_mm), axis=1)
        chosen, text = np.argsort(gap)[:MOST_POSES].tolist(), "Measure these poses, in the region and around it."
    else:
        along = found.problem.recording.joints[found.ends[:, 0], _joint_of(channel)]
        levels = np.linspace(along.min(initial=0.0), along.max(initial=0.0), MOST_POSES)
        chosen = list(dict.fromkeys(int(np.argmin(np.abs(along - v))) for v in levels)) if len(along) else []
        text = f"Measure these poses, evenly spread along {channel}."
    return _advice(why, text, found.to_rows(chosen))


def _joint_of(column: str) -> int:
    return int(column[1 : column.index("_")]) - 1


def _repeated(problem: Problem, channel: str) -> list[Row]:
    """Return poses far apart, each at values of a channel from one end of what was recorded to the other."""
    recording = problem.recording
    used = np.unique(problem.readings.rows)
    values = recording.channels[channel][used]
    values = np.unique(values[np.isfinite(values)])
    levels = values if len(values) <= LEVELS else np.linspace(values[0], values[-1], LEVELS).round(DECIMALS)
    if channel == "time_s":  # what is measured next comes later
        levels = (levels - levels[0] + values[-1] + np.median(np.diff(values))).round(1)
    far = [used[0]]
    while len(far) < REPEATED:
        gap = np.min([np.linalg.norm(recording.joints[used] - recording.joints[k], axis=1) for k in far], axis=0)
        far.append(used[int(np.argmax(gap))])
    return [
        {"pose": f"next{n + 1}"} | _joints(recording, k) | {channel: float(level)}
        for level in levels
        for n, k in enumerate(far)
    ]
