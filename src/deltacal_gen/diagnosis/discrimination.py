"""What to measure next, where a recording leaves a question open.

Two explanations of one misfit are told apart by readings that the wrong one cannot follow, whatever limbs it is then
given and however geometry and instrument are fitted again; `designs` chooses them among all that may be taken.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from deltacal_gen.diagnosis import words
from deltacal_gen.diagnosis.candidates import (
    candidates,
    columns_read,
    first_label,
    in_time,
    levels_of,
    row_of,
    within_limits,
)
from deltacal_gen.diagnosis.designs import Duel, Question, choose
from deltacal_gen.diagnosis.library import sizes
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.law import PREFIX, Law, is_law
from deltacal_gen.physics.terms import Term, blank
from deltacal_gen.results.diagnosis import Location, NextMeasurement, Row
from deltacal_gen.states import CHANNELS, TEMPERATURE, TIME, of_column

# of chi2: a difference D between two explanations scatters by 2 sqrt(D); at 58 it stays above the 22.6 below which a
# diagnosis calls them indistinguishable (`findings.AMBIGUOUS`) in 99 of 100 recordings
CLEAR = 58.0
LEAST = 10.0  # of chi2: poses that promise less are not worth a trip to the machine
FEWEST_POSES, MOST_POSES = 3, 16  # no single reading decides: it may be an outlier
MOST_ALONE = 48  # poses that prove an effect that stayed short of proof on many: each adds little
FURTHER = 8  # poses that are chosen beyond, for those who can measure more
SEED = 1975
REPEATED = 3  # poses that are repeated at each level of a channel
STEP = 1e-3  # of a constant, by which its derivative is taken


# ------------------------------------------------------------------------------------------------- two explanations


class Proposal(NamedTuple):
    """Readings that answer a question, the most telling ones first; `further` is for those who can measure more.

    `gained` is the difference in chi2 that the first n of both are expected to make.
    """

    rows: list[Row]
    further: list[Row]
    gained: tuple[float, ...]


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
        forms = {_key(t): t for family in self._family.values() for t in family}
        self._wide = {key: _on_all(t, at.problem) for key, t in forms.items()}
        bends = {key: list(_bends(t)) for key, t in forms.items()}
        if len(self.found.ends):
            every, bent = list(self._wide.values()), [pair for pairs in bends.values() for pair in pairs]
            self._old, self._new = (_columns(at, problem, every, bent) for problem in (at.problem, self.found.problem))
        count = itertools.count()
        self._place = {key: list(itertools.islice(count, t.n_coefficients)) for key, t in self._wide.items()}
        self._bent = {key: list(itertools.islice(count, len(pairs))) for key, pairs in bends.items()}

    def separating(self, truth: Term, rival: Term | None, beside: Sequence[Term]) -> Proposal:
        """Return the readings that tell an effect from a rival, or from there being nothing.

        Parameters
        ----------
        truth : Term
            With its coefficients.
        rival : Term, optional
            Its coefficients are not read: it is as large as it must be to look like the truth so far. One of a channel
            that was not recorded has no size yet, and is only asked to follow the truth.
        beside : sequence of Term
            Other effects that are on the machine whichever holds.
        """
        if not len(self.found.ends):
            return Proposal([], [], ())
        duels = self.against(rival, truth, self._spread(truth), beside)
        if rival is not None and not rival.gaps:
            first = self._old[0].shape[-1]
            alike = duels[0].coefficients[first : first + len(self._place[_key(rival)])]
            duels += self.against(truth, rival, alike, beside)
        design = choose(duels, FEWEST_POSES, MOST_ALONE if rival is None else MOST_POSES, CLEAR, FURTHER)
        rows = self.found.to_rows(design.order)
        return Proposal(rows[: design.needed], rows[design.needed :], design.gained)

    def against(self, wrong: Term | None, truth: Term, coefficients: Array, beside: Sequence[Term]) -> list[Duel]:
        """Return what fails where an effect, with coefficients on all limbs, is the truth: a wrong one, or nothing.

        A size within the wrong one is fitted again, too: each that the readings so far leave is one to fail. The first
        has its own.
        """
        if wrong is None:
            return [self._duel(truth, coefficients, None, beside)]
        first, *others = (self._duel(truth, coefficients, t, beside) for t in self._family[_key(wrong)])
        least = min(d.misfit for d in (first, *others))
        return [first, *(d for d in others if d.misfit < least + CLEAR)]

    def _resized(self, term: Term) -> list[Term]:
        """Return an effect with each size that a fit to all readings, taken or to be taken, may give it."""
        if is_law(term.effect) or not (sized := next(iter(term.kernels.SIZED), None)):
            return []
        at = [name for name, *_ in term.kernels.CONSTANTS].index(sized)
        problems = [self.at.problem, *([self.found.problem] if len(self.found.ends) else [])]
        every = {size for problem in problems for size in sizes(problem, term.kernels, term.constants[:at])}
        return [_with_constant(term, at, size) for size in sorted(every - {term.constants[at]})]

    def _spread(self, term: Term) -> Array:
        """Return an effect's coefficients on all limbs, zero where it is not."""
        wide = self._wide[_key(term)]
        values = np.zeros_like(wide.values)
        values[[wide.limbs.index(i) for i in term.limbs] if term.limbs else slice(None)] = term.values
        return values.ravel()

    def _duel(self, truth: Term, coefficients: Array, wrong: Term | None, beside: Sequence[Term]) -> Duel:
        """Return what fails where an effect holds: a wrong one, fitted with all others and with the geometry."""
        own = [] if wrong is None else [*self._place[_key(wrong)], *self._bent[_key(wrong)]]
        own += [j for t in beside for j in self._place[_key(t)]]
        (X, d), (more, shift) = (
            (np.concatenate([base, rest[..., own]], axis=-1), rest[..., self._place[_key(truth)]] @ coefficients)
            for base, rest in (self._old, self._new)
        )
        prior = np.zeros(X.shape[-1])
        prior[: len(self.at.problem.names)] = 1.0
        return Duel(X.reshape(-1, X.shape[-1]), d.ravel(), prior, more, shift)


def _key(term: Term) -> tuple[object, ...]:
    return term.effect, term.constants, term.tools, term.lacks, term.gaps


def _on_all(term: Term, problem: Problem) -> Term:
    """Return an effect, blank, on all limbs: a fit to more readings may put it on others."""
    limbs = range(1, problem.mechanism.limbs + 1)
    return blank(term.effect, tuple(limbs), term.constants, term.tools, term.lacks, term.gaps)


def _with_constant(term: Term, at: int, value: float) -> Term:
    return dataclasses.replace(term, constants=(*term.constants[:at], value, *term.constants[at + 1 :]))


def _bends(term: Term) -> Iterator[tuple[Term, Term]]:
    """Yield a formula with each constant within moved to both sides, by one unit together; none of an effect."""
    if isinstance(term.kernels, Law):
        for k in range(len(term.kernels.inner)):
            value = float(term.constants[k])
            step = STEP * max(abs(value), 1e-12)
            above, below = (
                dataclasses.replace(_with_constant(term, k, value + h), values=term.values / (2 * h))
                for h in (step, -step)
            )
            yield above, below


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


def next_measurements(
    at: Fit, questions: Sequence[Question], unexplained: Location | None
) -> tuple[NextMeasurement, ...]:
    """Return what to measure next: readings as rows of a recording where poses help, in words what else would.

    Rivals of what was named come first, then what is suspected, a formula of that last.

    Parameters
    ----------
    at : Fit
        Of the geometry with all effects that were named.
    questions : sequence of Question
    unexplained : Location, optional
        Where a misfit sits that no effect explains.
    """
    rng, out = np.random.default_rng(SEED), list[NextMeasurement]()
    if any(q.unrecorded for q in questions):
        at = _with_thermometer(at)
    warm = {name: _thermal(name, at.problem) for q in questions for name in q.unrecorded}
    terms = [t for q in questions for t in (q.truth, *q.rivals)] + list(warm.values())
    pool = Pool(at, terms, rng) if questions else None
    for q in sorted(questions, key=lambda q: (not q.proven, is_law(q.truth.effect))):
        assert pool is not None
        beside = [other.truth for other in questions if other.proven and other is not q]
        for rival in ((None,) if not q.proven else ()) + q.rivals:
            out.append(_entry(pool.separating(q.truth, rival, beside), q.truth, rival, at.problem))
        for name in q.unrecorded:
            found = _entry(pool.separating(q.truth, warm[name], beside), q.truth, warm[name], at.problem)
            out.append(_recording_warmth(found, at.problem))
    return tuple(out) if unexplained is None else (*out, _exploring(at, unexplained, rng))


def more_poses(problem: Problem) -> NextMeasurement:
    """Return the advice to measure as many poses again as there are: what a recording that is too short needs."""
    count = len(np.unique(problem.readings.group))
    return _advice(*words.more_poses(count))


def _advice(why: str, text: str, poses: Sequence[Row] = ()) -> NextMeasurement:
    return NextMeasurement(why=why, text=text, poses=tuple(poses), expected_chi2=None)


def _entry(found: Proposal, truth: Term, rival: Term | None, problem: Problem) -> NextMeasurement:
    terms = [truth, *([rival] if rival else [])]
    names = tuple(t.effect.removeprefix(PREFIX) for t in terms)
    read, expected = columns_read(problem, terms), found.gained[len(found.rows) - 1] if found.rows else 0.0
    if promising := expected >= LEAST:
        text = words.measure(len(found.rows), [name for name in read if name in found.rows[0]])
    else:
        missing = [name for name in read if name not in problem.recording.channels]
        text = words.no_poses(
            within_limits(problem), LEAST, missing, any(t.kernels.ACTS_ON == "reading" for t in terms)
        )
    return NextMeasurement(
        why=words.purpose(*names),
        text=text,
        poses=tuple(in_time(found.rows, problem.recording)) if promising else (),
        expected_chi2=max(0.0, expected),  # rounding may leave less
        separates=names,
        chi2_by_pose=found.gained if promising else None,
        further=tuple(found.further) if promising else None,
    )


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


def _recording_warmth(found: NextMeasurement, problem: Problem) -> NextMeasurement:
    """Return what tells an effect from one of the temperature, which was not recorded or did not vary.

    Where no poses promise enough by themselves, some are repeated warm and cold.
    """
    warmth = of_column(TEMPERATURE)
    text = words.record_warmth(TEMPERATURE, warmth.step, *(found.separates or ()))
    if found.poses:
        return found.replace(text=text)
    ends = problem.robot.limits.get(TEMPERATURE, (warmth.default, warmth.default + warmth.step))
    return found.replace(text=text, poses=_at_levels(problem, TEMPERATURE, ends, 2 * REPEATED), expected_chi2=None)


def _exploring(at: Fit, location: Location, rng: np.random.Generator) -> NextMeasurement:
    """Return readings that show more of a misfit that nothing explains: where it sits, along what it depends on."""
    problem, recording = at.problem, at.problem.recording
    if recording.joints.shape[1] == 1 and np.isfinite(problem.readings.values).any(axis=0).sum() == 1:
        return _advice(*words.AXIS_OR_INSTRUMENT)
    channel = location.channels[0].name if location.channels else ""
    poses: Sequence[Row] = ()
    if location.region is None and channel in recording.channels:
        poses = _at_levels(problem, channel, levels_of(problem, channel, curved=True), REPEATED)
    elif channel:
        found = candidates(at, (), rng)
        if location.region is not None:
            gap = np.linalg.norm(found.position - np.asarray(location.region.centre_mm), axis=1)
            chosen = np.argsort(gap)[:MOST_POSES].tolist()
        else:
            along = found.problem.recording.joints[found.ends[:, 0], int(channel[1 : channel.index("_")]) - 1]
            levels = np.linspace(along.min(initial=0.0), along.max(initial=0.0), MOST_POSES)
            chosen = list(dict.fromkeys(int(np.argmin(np.abs(along - v))) for v in levels)) if len(along) else []
        rows = found.to_rows(chosen)
        poses = in_time([{k: v for k, v in row.items() if k != TIME} for row in rows], recording)  # one after the other
    text = words.explore(problem.robot, channel if poses else "", location, channel in recording.channels)
    return _advice(words.EXPLORES, text, poses)


def _at_levels(problem: Problem, channel: str, levels: Sequence[float] | Array | None, count: int) -> tuple[Row, ...]:
    """Return so many poses whose joints lie far apart, all of them at each level of a channel."""
    recording, used = problem.recording, np.unique(problem.readings.rows)
    far = [int(used[0])]
    while len(far) < min(count, len(used)):
        gap = np.min([np.linalg.norm(recording.joints[used] - recording.joints[k], axis=1) for k in far], axis=0)
        far.append(int(used[int(np.argmax(gap))]))
    first = first_label(recording)
    rows = [
        row_of(recording, [k], first + n) | {channel: float(level)}
        for level in (() if levels is None else levels)
        for n, k in enumerate(far)
    ]
    return tuple(in_time(rows, recording))
