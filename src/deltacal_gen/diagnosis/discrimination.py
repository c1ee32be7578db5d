"""What to measure next, where a recording leaves a question open.

Two explanations of one misfit are told apart by readings that the wrong one cannot follow, whatever limbs it is then
given and however geometry and instrument are fitted again; `designs` chooses them among all that may be taken.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.candidates import (
    DECIMALS,
    LABEL,
    LEVELS,
    candidates,
    columns_read,
    first_label,
    gap_of,
    in_time,
    joints_of,
    within_limits,
)
from deltacal_gen.diagnosis.designs import Duel, Refutation, choose
from deltacal_gen.diagnosis.library import sizes
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.machine.places import place_of
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.law import PREFIX, Law, is_law
from deltacal_gen.physics.terms import Term, blank
from deltacal_gen.results.diagnosis import Location, NextMeasurement, Row
from deltacal_gen.states import CHANNELS, TEMPERATURE, TIME, of_column

# of chi2: a difference D between two explanations scatters by 2 sqrt(D); at 58 it stays above the 22.6 below which a
# diagnosis calls them not told apart (`findings.AMBIGUOUS`) in 99 of 100 recordings
CLEAR = 58.0
LEAST = 10.0  # of chi2: poses that promise less are not worth a trip to the machine
NO_POSES = f"No poses of this machine do: none promise a difference of {LEAST:g} in chi2."
NONE_SO_FAR = (
    f"No poses do within what the joints have moved: none promise a difference of {LEAST:g} in chi2. Say how far each "
    "joint may go (limits_deg or limits_mm under [joints] in the robot file), and diagnose again."
)
PROFILE = "separates a profile of the axis from the instrument's own non-linearity"
TURNED_ROUND = (
    "Such readings show both alike. Turn the instrument round, or shift it along the axis, and repeat: what moves with "
    "it is its own, what stays is the axis'."
)
FEWEST_POSES, MOST_POSES = 3, 16  # no single reading decides: it may be a gross error
MOST_ALONE = 48  # poses that prove an effect that stayed short of proof on many: each adds little
FURTHER = 8  # poses that are chosen beyond, for those who can measure more
SEED = 1975
REPEATED = 3  # poses that are repeated at each level of a channel
STEP = 1e-3  # of a constant, by which its derivative is taken


# ------------------------------------------------------------------------------------------------- two explanations


@dataclass(frozen=True)
class Proposal:
    """Readings that answer a question, and the difference in chi2 that they are expected to make.

    Attributes
    ----------
    rows : list of Row
        The most telling ones first.
    gained : tuple of float
        What the first n of them and of `further` are expected to make.
    further : list of Row
        For those who can measure more.
    """

    rows: list[Row]
    gained: tuple[float, ...] = ()
    further: list[Row] = dataclasses.field(default_factory=list)

    @property
    def expected(self) -> float:
        """The difference that the rows make."""
        return self.gained[len(self.rows) - 1] if self.rows else 0.0


class Pool:
    """Readings that could be taken, and what geometry, instrument and effects would do to them and did to those taken.

    Parameters
    ----------
    at : Fit
        Of the geometry, with or without effects.
    terms : sequence of Term
        All that questions are about, or that is on the machine.
    """

    def __init__(self, at: Fit, terms: Sequence[Term], rng: np.random.Generator) -> None:
        self.at, self.found = at, candidates(at, terms, rng)
        self._family = {_key(t): [t, *self._resized(t)] for t in terms}
        unlike = {_key(t): t for family in self._family.values() for t in family}
        self._wide = {key: _on_all(t, at.problem) for key, t in unlike.items()}
        bends = [bent for t in unlike.values() for bent in _bends(t)]
        if len(self.found.ends):
            every = list(self._wide.values())
            self._old, self._new = (_columns(at, problem, every, bends) for problem in (at.problem, self.found.problem))
        ends = np.cumsum([0, *(t.n_coefficients for t in self._wide.values())])
        last = ends[-1] + np.cumsum([0, *(len(_bends(t)) for t in unlike.values())])
        self._place = dict(zip(self._wide, itertools.pairwise(ends.tolist()), strict=True))
        self._bends = dict(zip(self._wide, itertools.pairwise(last.tolist()), strict=True))

    def separating(self, truth: Term, rival: Term | None, beside: Sequence[Term]) -> Proposal:
        """Return the readings that tell an effect from a rival, or from there being nothing.

        Parameters
        ----------
        truth : Term
            With its coefficients.
        rival : Term, optional
            Its coefficients are not read: it is as large as it must be to look like the truth so far.
        beside : sequence of Term
            Other effects that are on the machine whichever holds.
        """
        if not len(self.found.ends):
            return Proposal([])
        duels = self.against(rival, truth, self._spread(truth), beside)
        if rival is not None:
            theirs = self._columns_of(rival)
            first = duels[0].X.shape[-1] - len(theirs) - len(self._bent(rival))
            alike = duels[0].wrong.coefficients[first : first + len(theirs)]
            if rival.gaps:
                alike = self._as_large(truth, rival)
            duels += self.against(truth, rival, alike, beside)
        most = MOST_ALONE if rival is None else MOST_POSES
        chosen = choose(duels, FEWEST_POSES, most, CLEAR, FURTHER)
        rows = self.found.to_rows(chosen.order)
        return Proposal(rows[: chosen.needed], chosen.gained, rows[chosen.needed :])

    def against(self, wrong: Term | None, truth: Term, coefficients: Array, beside: Sequence[Term]) -> list[Duel]:
        """Return what fails where an effect, with coefficients on all limbs, is the truth: a wrong one, or nothing.

        A size within the wrong one is fitted again, too: each that the readings so far leave is one to fail. The first
        has its own.
        """
        if wrong is None:
            return [self._duel(self._columns_of(truth), coefficients, [], beside)]
        mine = self._columns_of(truth)
        duels = [
            self._duel(mine, coefficients, self._columns_of(t), beside, self._bent(t))
            for t in self._family[_key(wrong)]
        ]
        least = min(d.wrong.misfit for d in duels)
        return [duels[0], *(d for d in duels[1:] if d.wrong.misfit < least + CLEAR)]

    def _resized(self, term: Term) -> list[Term]:
        """Return an effect with each size that a fit to all readings, taken or to be taken, may give it."""
        if is_law(term.effect) or not (sized := next(iter(term.kernels.SIZED), None)):
            return []
        at = [name for name, *_ in term.kernels.CONSTANTS].index(sized)
        problems = [self.at.problem, *([self.found.problem] if len(self.found.ends) else [])]
        every = {size for problem in problems for size in sizes(problem, term.kernels, term.constants[:at])}
        return [
            dataclasses.replace(term, constants=(*term.constants[:at], size, *term.constants[at + 1 :]))
            for size in sorted(every - {term.constants[at]})
        ]

    def _columns_of(self, term: Term) -> list[int]:
        return list(range(*self._place[_key(term)]))

    def _bent(self, term: Term) -> list[int]:
        """Return the columns by which a law gives way as its constants are fitted again."""
        return list(range(*self._bends[_key(term)]))

    def _spread(self, term: Term) -> Array:
        """Return an effect's coefficients on all limbs, zero where it is not."""
        wide = self._wide[_key(term)]
        values = np.zeros_like(wide.values)
        rows = [wide.limbs.index(i) for i in term.limbs] if term.limbs else slice(None)
        values[rows] = term.values
        return values.ravel()

    def _as_large(self, truth: Term, rival: Term) -> Array:
        """Return coefficients with which a rival, of a channel that was not recorded, moves as much as the truth did.

        On the same limbs; so far it has no size.
        """
        wide = self._wide[_key(rival)]
        own = np.zeros_like(wide.values)
        rows = [wide.limbs.index(i) for i in truth.limbs] if wide.limbs and truth.limbs else slice(None)
        own[rows, : wide.own] = 1.0
        size, unit = (
            float(np.sqrt(np.mean((columns @ values) ** 2)))
            for columns, values in (
                (self._old[1][..., self._columns_of(truth)], self._spread(truth)),
                (self._new[1][..., self._columns_of(rival)], own.ravel()),
            )
        )
        alike: Array = own.ravel() * size / max(unit, 1e-300)
        return alike

    def _duel(
        self,
        true: Sequence[int],
        coefficients: Array,
        wrong: Sequence[int],
        beside: Sequence[Term],
        bent: Sequence[int] = (),
    ) -> Duel:
        """Return what fails where effects `true` hold: `wrong` ones, fitted with all others and with the geometry."""
        own = [*(j for t in beside for j in self._columns_of(t)), *wrong, *bent]
        old, new = (np.concatenate([base, rest[..., own]], axis=-1) for base, rest in (self._old, self._new))
        shifts = (rest[..., list(true)] @ coefficients for _, rest in (self._old, self._new))
        prior = np.zeros(old.shape[-1])
        prior[: len(self.at.problem.names)] = 1.0
        unseen = np.abs(new).max(axis=(0, 1))
        return Duel(Refutation(old.reshape(-1, old.shape[-1]), next(shifts).ravel(), prior, unseen), new, next(shifts))


def _key(term: Term) -> tuple[object, ...]:
    return term.effect, term.constants, term.tools, term.lacks, term.gaps


def _on_all(term: Term, problem: Problem) -> Term:
    """Return an effect, blank, on all limbs: a fit to more readings may put it on others."""
    limbs = range(1, problem.mechanism.limbs + 1)
    return blank(term.effect, tuple(limbs), term.constants, term.tools, term.lacks, term.gaps)


def _bends(term: Term) -> list[tuple[Term, Term]]:
    """Return a law with each constant of its form moved to both sides, by one unit together; none of an effect."""
    law = term.kernels
    if not isinstance(law, Law):
        return []
    out = []
    for k in range(len(law.inner)):
        step = STEP * max(abs(float(term.constants[k])), 1e-12)
        ends = []
        for sign in (1.0, -1.0):
            constants = list(term.constants)
            constants[k] = float(constants[k]) + sign * step
            ends.append(dataclasses.replace(term, constants=tuple(constants), values=sign * term.values / (2 * step)))
        out.append((ends[0], ends[1]))
    return out


def _columns(
    at: Fit, problem: Problem, terms: Sequence[Term], bends: Sequence[tuple[Term, Term]]
) -> tuple[Array, Array]:
    """Return what geometry and instrument, and what effects do to readings, (R, k, n) each, in units of the noise.

    Readings that were taken share what their repeats share, and weigh as in the fit. What laws do as their constants
    move, `bends`, comes last.
    """
    taken = problem is at.problem
    machine = at.machine if taken else problem.solve(at.errors)
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
    for pair in bends:
        moved = sum(problem.term_columns([t], at.errors, at.instrument, machine) @ t.values.ravel() for t in pair)
        effects = np.concatenate([effects, np.asarray(moved)[..., None]], axis=2)
    both = np.concatenate([base, effects], axis=2) / at.sigma[:, None]
    if taken:
        both *= (np.sqrt(at.weights)[:, None] * np.sqrt(1 + at.repeats.ratio))[..., None]
        both = at.repeats.whiten(np.where(np.isfinite(state.residual)[..., None], both, 0.0), at.weights)
    else:
        both = at.repeats.levelled(both)
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
    if any(q.unrecorded for q in questions):
        at = _with_thermometer(at)
    warm = {name: _thermal(name, at.problem) for q in questions for name in q.unrecorded}
    pool = None
    if questions:
        pool = Pool(at, [t for q in questions for t in (q.truth, *q.rivals)] + list(warm.values()), rng)
    out = []
    for q in questions:
        assert pool is not None
        beside = [t for t in named if t is not q.truth]
        if not q.proven:
            found = pool.separating(q.truth, None, beside)
            out.append(_entry(f"settles whether there is {label(q.truth)}", found, q.truth, None, at.problem))
        for rival in q.rivals:
            found = pool.separating(q.truth, rival, beside)
            why = f"separates {label(q.truth)} from {label(rival)}"
            out.append(_entry(why, found, q.truth, rival, at.problem))
        for name in q.unrecorded:
            out.append(_other_channel(pool, q.truth, name, warm[name], beside))
    if unexplained is not None:
        out.append(_exploring(at, unexplained, rng))
    return tuple(out)


def label(term: Term) -> str:
    """Return what an effect is called; of a law, what it says."""
    return term.effect.removeprefix(PREFIX)


def more_poses(problem: Problem) -> NextMeasurement:
    """Return the advice to measure as many poses again as there are: what a recording that is too short needs."""
    count = len(np.unique(problem.readings.group))
    text = (
        f"Measure at least {count} more readings at other poses, all over the workspace: deltacal plan proposes them."
    )
    return _advice("lets lesser effects show", text)


def _advice(
    why: str,
    text: str,
    poses: Sequence[Row] = (),
    expected: float | None = None,
    separates: Sequence[str] = (),
    found: Proposal | None = None,
) -> NextMeasurement:
    more = found is not None and bool(poses)
    return NextMeasurement(
        why=why,
        text=text,
        poses=tuple(poses),
        expected_chi2=None if expected is None else max(expected, 0.0) + 0.0,  # rounding may leave less
        separates=tuple(separates) or None,
        chi2_by_pose=found.gained if more and found else None,
        further=tuple(found.further) if more and found else None,
    )


def _entry(why: str, found: Proposal, truth: Term, rival: Term | None, problem: Problem) -> NextMeasurement:
    apart = [label(t) for t in (truth, rival) if t]
    if found.expected >= LEAST and found.rows:
        values = [n for n in columns_read(problem, [t for t in (truth, rival) if t]) if n in found.rows[0]]
        with_values = f", with {', '.join(values)} as given" if values else ""
        those, them = ("this pose", "it") if len(found.rows) == 1 else (f"these {len(found.rows)} poses", "them")
        text = f"Measure {those}{with_values}, without moving the instrument, and add {them}."
        return _advice(why, text, in_time(found.rows, problem.recording), found.expected, apart, found)
    missing = [
        n for n in columns_read(problem, [t for t in (truth, rival) if t]) if n not in problem.recording.channels
    ]
    text = NO_POSES if within_limits(problem) else NONE_SO_FAR
    if missing:
        text += f" Record {', '.join(missing)} and vary what is recorded."
    if any(_reads_only(t) for t in (truth, rival) if t):
        text += " Hold the instrument against a length that is known."
    return _advice(why, text, expected=found.expected, separates=apart)


def _reads_only(term: Term) -> bool:
    return bool(term.kernels.ACTS_ON == "reading")


def _with_thermometer(at: Fit) -> Fit:
    """Return a fit whose recording has a column for the temperature, blank where it had none."""
    problem, body = at.problem, at.problem.body
    if body.channels.get("warming") is not None:
        return at
    unknown = np.full(len(body.q), np.nan)
    recording = dataclasses.replace(problem.recording, channels=problem.recording.channels | {TEMPERATURE: unknown})
    channels = body.channels.with_values(**{s.name: unknown for s in CHANNELS if s.column == TEMPERATURE})
    body = Body(body.robot, body.mechanism, body.q, body.tool, channels)
    return dataclasses.replace(at, problem=dataclasses.replace(problem, recording=recording, body=body))


def _thermal(name: str, problem: Problem) -> Term:
    """Return an effect of the temperature, blank; where that was not recorded every session has a gap."""
    body, limbs = problem.body, tuple(range(1, problem.mechanism.limbs + 1))
    warming = body.channels.get("warming")
    assert warming is not None  # see `_with_thermometer`
    gaps = np.unique(body.session[np.isnan(warming)]).tolist()
    return blank(name, limbs, lacks=body.lacks(name), gaps=tuple(gaps))


def _other_channel(pool: Pool, truth: Term, unrecorded: str, rival: Term, beside: Sequence[Term]) -> NextMeasurement:
    """Return what tells an effect from one of the temperature, which was not recorded or did not vary."""
    why, problem, warmth = f"separates {label(truth)} from {unrecorded}", pool.at.problem, of_column(TEMPERATURE)
    apart = (label(truth), unrecorded)
    text = (
        f"Record {TEMPERATURE}, and repeat the poses when the machine is at least {warmth.step:g} K warmer or colder: "
        f"{unrecorded} follows the temperature, {label(truth)} does not."
    )
    found = pool.separating(truth, rival, beside)
    if found.expected >= LEAST:
        return _advice(why, text, in_time(found.rows, problem.recording), found.expected, apart, found)
    low, high = problem.robot.limits.get(TEMPERATURE, (warmth.default, warmth.default + warmth.step))
    first = first_label(problem.recording)
    poses = [
        {"pose": f"{LABEL}{first + n}"} | joints_of(problem.recording, k) | {TEMPERATURE: level}
        for level in (low, high)
        for n, k in enumerate(_far_apart(problem, 2 * REPEATED))
    ]
    return _advice(why, text, poses, separates=apart)


def _exploring(at: Fit, location: Location, rng: np.random.Generator) -> NextMeasurement:
    """Return readings that show more of a misfit that nothing explains: where it sits, along what it depends on."""
    recording = at.problem.recording
    channel = location.channels[0].name if location.channels else None
    why = "shows more of what no effect explains"
    if recording.joints.shape[1] == 1 and np.isfinite(at.problem.readings.values).any(axis=0).sum() == 1:
        return _advice(PROFILE, TURNED_ROUND)
    if channel is None:
        joint = place_of(at.problem.robot, location.limbs, "joint") if len(location.limbs) == 1 else ""
        from_both = f", {joint} coming from either side" if joint else ""
        text = (
            f"Repeat a few poses{from_both}, and record what may matter: time_s, temp_C, payload_kg and the direction "
            "in which each joint last moved (approach1 ...)."
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
    rows = found.to_rows(chosen)
    if TIME in found.told:  # one after the other
        soonest = min(float(row[TIME]) for row in rows)
        rows = [row | {TIME: soonest} for row in rows]
    return _advice(why, text, in_time(rows, recording))


def _joint_of(column: str) -> int:
    return int(column[1 : column.index("_")]) - 1


def _repeated(problem: Problem, channel: str) -> list[Row]:
    """Return poses far apart, each at values of a channel from one end of what was recorded to the other."""
    recording = problem.recording
    used = np.unique(problem.readings.rows)
    values = recording.channels[channel][used]
    values = np.unique(values[np.isfinite(values)])
    levels = values if len(values) <= LEVELS else np.linspace(values[0], values[-1], LEVELS).round(DECIMALS)
    if of_column(channel).passes:  # what is measured next comes later
        levels = (levels - levels[0] + values[-1] + gap_of(values)).round(1)
    first = first_label(recording)
    rows = [
        {"pose": f"{LABEL}{first + n}"} | joints_of(recording, k) | {channel: float(level)}
        for level in levels
        for n, k in enumerate(_far_apart(problem, REPEATED))
    ]
    return in_time(rows, recording)


def _far_apart(problem: Problem, count: int) -> list[int]:
    """Return so many rows of the recording whose joints lie far apart."""
    recording, used = problem.recording, np.unique(problem.readings.rows)
    far = [int(used[0])]
    while len(far) < min(count, len(used)):
        gap = np.min([np.linalg.norm(recording.joints[used] - recording.joints[k], axis=1) for k in far], axis=0)
        far.append(int(used[int(np.argmax(gap))]))
    return far
