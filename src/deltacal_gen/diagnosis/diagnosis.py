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
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from deltacal_gen.diagnosis.answer import Diagnosed
from deltacal_gen.diagnosis.chance import Chance
from deltacal_gen.diagnosis.charges import MARGIN
from deltacal_gen.diagnosis.conclusion import Named
from deltacal_gen.diagnosis.correction import BorneOut, borne_out_beside
from deltacal_gen.diagnosis.designs import Question
from deltacal_gen.diagnosis.discrimination import next_measurements
from deltacal_gen.diagnosis.findings import (
    AMBIGUOUS,
    beside_turned,
    location_of,
    named_of,
    only_turned,
    rejected_of,
    turned_of,
)
from deltacal_gen.diagnosis.hints import Hinted, hinted, told
from deltacal_gen.diagnosis.laws.laws import Lawful, Sought, laws
from deltacal_gen.diagnosis.laws.remainder import with_remainder
from deltacal_gen.diagnosis.library import defined, library
from deltacal_gen.diagnosis.refits import believable, form, refitted, terms_of
from deltacal_gen.diagnosis.search import Search
from deltacal_gen.diagnosis.selection import MOST_WAVES, Progress, crowded
from deltacal_gen.diagnosis.spectrum import LEAST_TURN, Spectrum, periodic
from deltacal_gen.diagnosis.strategy import (
    Outcome,
    borne_out,
    deviance,
    held_out_by,
    in_white_noise,
    searched,
    settled,
)
from deltacal_gen.diagnosis.structure import Structure, structures
from deltacal_gen.diagnosis.wandering import following_walks
from deltacal_gen.errors import NoConvergence
from deltacal_gen.estimation.fit import CONVERGED, fit, held_out_errors
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import with_prior
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.residuals import lengths, rms
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.files.checks import check_units, set_aside
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification import checks
from deltacal_gen.identification.drawing import as_read, doubts, strained
from deltacal_gen.identification.folds import folds
from deltacal_gen.identification.mistakes import EXPLAINED
from deltacal_gen.identification.noise import lack_of_fit, merely_more, stated
from deltacal_gen.identification.orders import wave
from deltacal_gen.identification.outliers import begun, check_rows, without_knocked, without_overflow
from deltacal_gen.identification.prior import learned
from deltacal_gen.identification.together import as_predicts, better_alone, without_following
from deltacal_gen.machine.backend import by_recording
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.terms import Term, effect_names
from deltacal_gen.results.diagnosis import (
    Verdict,
)
from deltacal_gen.results.parts import Missing

MOST_POSES = 700  # that the search looks at, drawn at random: they show what is there; the fit uses all
SEED = 2013
MACHINED = 5.0  # standard deviation of a source error, in ordinary ones: geometry may not strain to imitate physics


@by_recording("diagnose")
def diagnose(
    robot: Robot, recording: Recording, model: str | None = None, *, progress: Progress = lambda text: None
) -> Diagnosed:
    """Find where model and recording differ, and which physics was left out.

    Parameters
    ----------
    model : str, optional
        Geometry that is fitted first and beside everything; default the mechanism's largest.
    progress : callable
        Told in words what is being done.

    Raises
    ------
    InputError
        The recording cannot be used at all: too few readings, joints at which the machine cannot stand.
    """
    check_units(recording, robot)
    recording = set_aside(recording, robot)
    progress("geometry")
    begun, doubt = _begun(robot, recording, model, progress)
    robot, problem, model, lean = begun.robot, begun.problem, begun.model, begun.lean
    terms, not_tested = begun.terms, begun.not_tested
    found, sought = (begun.found, Sought()) if lean else _by_law(_without_walks(begun.found), progress)
    first, sought = found.first, _less_sign(sought, found)
    search, left, unexplained, spectrum = found.search, found.left, found.unexplained, found.spectrum
    if lawful := sought.laws:
        search, left, unexplained = Search(lawful[0].fit, search.terms), structures(lawful[0].fit), False
    smooth = borne_out_beside(search.fit, left) if unexplained else None
    if spectrum is None and not lawful:
        search, left, smooth = _without_orders(found.problem, search, left, smooth)
    unexplained |= smooth is not None
    # what comes near its price, or is not borne out, is no finding, but worth a measurement
    doubtful = [] if lean else hinted(search, AMBIGUOUS)
    heldout = _held_out(found, search, lawful)
    del begun  # columns of all forms, which take more memory than all readings
    progress(f"fit of all {len(problem.readings)} readings")
    baseline, current, spectrum = _of_all(problem, first, search.fit, spectrum)
    search = _without_refuted(found.problem, search, current)
    current = _as_is_known(problem, current, lawful)
    unexplained |= _left_beside(lawful, current)
    heldout = heldout if spectrum is None else (heldout[0], spectrum.heldout[1])
    known = stated(current, recording, explained=not unexplained)
    named = beside_turned(named_of(search, current, heldout, known.sigma, spectrum), found.considered)
    chance = Chance(Search(_beside_noise_of(search.fit, first), terms), np.random.default_rng(SEED))
    # where a law sits is told as it showed, without the law
    of, shows = (found.search.fit, found.left) if lawful else (search.fit, left)
    location = location_of(of, shows, named, spectrum, chance, not (unexplained or lawful), found.wandering)
    progress("what to measure next")
    questions = _questions(named, sought, doubtful)
    return Diagnosed(
        verdict=Verdict.UNEXPLAINED if unexplained else _verdict(current),
        model=model,
        baseline=as_predicts(baseline),
        final=current,
        effects=named,
        heldout=heldout,
        noise=known,
        location=location,
        rejected=rejected_of(found.considered, named, spectrum),
        hints=told(doubtful, search, chance),
        not_tested=not_tested,
        next_measurements=next_measurements(search.fit, questions, location if unexplained else None),
        robot=_calibrated(robot, current),
        chance=chance,
        hypotheses=found.hypotheses,
        correction=None if smooth is None else smooth.of_all(current),
        spectrum=spectrum,
        lean=lean,
        laws=lawful,
        turned=turned_of(robot, found.considered) if lawful or unexplained or any(n.turned for n in named) else "",
        doubts=(*doubt, *checks.doubted(problem, current)),
        redrawn=bool(doubt),
    )


def _questions(named: Sequence[Named], sought: Sought, doubtful: Sequence[Hinted]) -> list[Question]:
    """Return what is open: rivals of findings, laws, and what is a hint."""
    asked = [Question(n.term, n.rivals, n.unrecorded) for n in named if n.fundamental is None]
    return [*asked, *sought.questions, *(Question(h.term, proven=False) for h in doubtful)]


def _geometry(robot: Robot, recording: Recording, model: str | None) -> tuple[Problem, str, bool]:
    """Return the problem of the geometry beside which effects are sought, its model, and whether no more is told.

    Parameters may be as far off as machined parts are: geometry shall not strain to imitate physics.
    """
    mechanism, everything = mechanism_of(robot), pose_problem(robot, recording, ())
    own = _lean(everything) if model is None else None
    if everything.readings.kind.sees_joints:
        model = checks.chosen_model(everything, model)
    model = own or model or mechanism.full_model
    problem, _ = with_prior(everything.with_names(mechanism.model(model)), robot, MACHINED)
    checks.distinct(problem)
    if own is None:
        checks.check_count(problem, model, checks.once(problem))
    return problem, model, own is not None


class Drawn(NamedTuple):
    """A machine as a robot draws it.

    Attributes
    ----------
    problem, some : Problem
        Of all readings, and of those that the search looks at.
    model : str
    lean : bool
        Whether there are too few heights for anything but firmware's parameters.
    first : Fit
        Of geometry and instrument alone, to some.
    """

    robot: Robot
    problem: Problem
    model: str
    lean: bool
    some: Problem
    first: Fit


@dataclass(frozen=True)
class _Begun:
    """What a diagnosis rests on, and what a first search has found beside it; see `Drawn`.

    Attributes
    ----------
    terms : sequence of Term
        All effects that are looked at.
    found : Outcome
        What was found beside it.
    """

    robot: Robot
    problem: Problem
    model: str
    lean: bool
    some: Problem
    first: Fit
    terms: Sequence[Term]
    not_tested: tuple[Missing, ...]
    found: Outcome


def _begun(robot: Robot, recording: Recording, model: str | None, progress: Progress) -> tuple[_Begun, tuple[str, ...]]:
    """Return what is searched beside, what a first search found, and doubts about the drawing.

    Where the drawing is of another machine, it says nothing of this one's parts: they are as the readings want them.
    But physics strains geometry, too, which is as drawn once that is beside it: what another machine does not explain
    is looked for beside the drawing, which stands where less is left.
    """
    drawn = drawn_beside(robot, recording, model)
    wanted = _as_drawn(drawn.some, drawn.first) if strained(drawn.first) else None
    if not drawn.lean:
        wanted = as_read(wanted or drawn.first) or wanted
    if wanted is None or not (doubt := doubts(wanted)):
        return _searched(drawn, progress), ()
    other = _searched(drawn_beside(_calibrated(robot, wanted), recording, model), progress)
    explained = not (other.found.search.effects or other.found.unexplained)
    if explained or other.first.sigma[0] < EXPLAINED * drawn.first.sigma[0]:
        return other, doubt
    begun = _searched(drawn, progress)
    kept, instead = begun.found.search.fit, other.found.search.fit
    return (begun, ()) if kept.sigma[0] < instead.sigma[0] and not strained(kept) else (other, doubt)


def drawn_beside(robot: Robot, recording: Recording, model: str | None) -> Drawn:
    """Return a machine as its robot draws it, with the fit of its geometry beside which effects are sought.

    Raises
    ------
    InputError
        As `diagnose`.
    """
    problem, name, lean = _geometry(robot, recording, model)
    some = problem.some(MOST_POSES, np.random.default_rng(SEED))
    first = _first(some)
    if first.problem is not some:  # which had few poses: all of them
        problem = some = first.problem
    for without in (without_overflow, without_knocked, without_following):
        if (rest := without(problem, first)) is not None:
            problem, some = rest, rest.some(MOST_POSES, np.random.default_rng(SEED))
            first = _first(some)
    return Drawn(robot, problem, name, lean, some, first)


def _searched(of: Drawn, progress: Progress) -> _Begun:
    terms, not_tested = library(of.some) if not of.lean else ([], _untested(of.problem))
    terms, without_value = defined(of.first, terms)
    not_tested += without_value
    return _Begun(*of, terms, not_tested, searched(of.some, of.first, terms, of.lean, progress))


def _first(some: Problem) -> Fit:
    """Return the fit of geometry and instrument, no reading dropped: what is left out may look like gross errors.

    One of few poses that is of none of the others is, with its problem.
    """
    some, start = begun(some)
    checks.plausible(start)
    check_rows(start)
    return fit(some, Prior(), errors=start.errors, instrument=start.instrument, drop_gross=False, must_converge=False)


def _without_walks(found: Outcome) -> Outcome:
    """Return what was found without effects of time that only follow joints which wander: that remains unexplained."""
    terms = terms_of(found.search.fit)
    prices = {i: found.search.price(t) + MARGIN for i, t in enumerate(terms)}
    gone, wandering = following_walks(found.search.fit, prices)
    kept = [t for i, t in enumerate(terms) if i not in gone]
    fit = refitted(found.problem, found.search.fit, kept) if gone else None
    if fit is None:
        return found
    search = Search(fit, found.search.terms)
    return dataclasses.replace(found, search=search, left=structures(fit), unexplained=True, wandering=wandering)


def _by_law(found: Outcome, progress: Progress) -> tuple[Outcome, Sought]:
    """Return what was found, and the law that explains what it leaves.

    Noise that is correlated takes in what a law of time does to rows: a law beside noise of each row's own, which costs
    less, stands in its place. Joints that err at many orders imitate any function of the pose.
    """
    sought = laws(found, progress) if found.spectrum is None else Sought()
    if sought.laws or found.unexplained or found.spectrum is not None or (white := in_white_noise(found)) is None:
        return found, sought
    instead = laws(white, progress) if white.unexplained else Sought()
    return (white, instead) if instead.laws and instead.laws[0].cost < deviance(found) else (found, sought)


def _less_sign(sought: Sought, found: Outcome) -> Sought:
    """Return the law that is borne out, but for one of what the direction of approach does: its sign is asked first."""
    terms = sought.laws[0].terms if sought.laws else [sought.doubtful] if sought.doubtful is not None else []
    return Sought() if only_turned(found.considered, terms) else sought


def _held_out(found: Outcome, search: Search, lawful: Sequence[Lawful]) -> tuple[float, float]:
    """Return the held-out error of geometry alone, and beside what was found [mm]; a spectrum has its own.

    Both are of the same readings: where a law was found, of those that it was asked of. And both are of the machine
    that is given, of which rows are weighed alone where that predicts better.
    """
    kind = found.problem.readings.kind
    if lawful:
        return lawful[0].proof.without, lawful[0].proof.rms
    alone = better_alone(found.first)
    without = found.without if alone is None else held_out_errors(alone, Prior(), found.parts)
    before = rms(lengths(without, kind))
    if not search.effects or found.spectrum is not None:
        return before, before
    alone = better_alone(search.fit)
    tested = search.fit is found.tested and alone is None
    given = search if alone is None else Search(alone, search.terms)
    beside = found.predicted if tested else held_out_by(found.problem, given, found.parts)
    return before, rms(lengths(beside, kind))


def _without_refuted(some: Problem, search: Search, current: Fit) -> Search:
    """Return the search with those effects alone that all readings leave."""
    if [form(t) for t in terms_of(current)] == [form(t) for t in terms_of(search.fit)]:
        return search
    return Search(refitted(some, search.fit, terms_of(current)) or search.fit, search.terms)


def _left_beside(lawful: Sequence[Lawful], current: Fit) -> bool:
    """Tell whether a law leaves far more than the noise is known to be: it may hold, and be half of it."""
    recording = current.problem.recording
    return bool(lawful) and lack_of_fit(current, recording) and not merely_more(current, recording)


def _as_is_known(problem: Problem, current: Fit, lawful: Sequence[Lawful]) -> Fit:
    """Return the fit by what is then known of geometry: the drawing, where no physics is left that it could imitate."""
    if not (current.problem.terms or current.problem.held):
        current = _as_drawn(problem, current)
    if lawful:
        current = with_remainder(_as_learned(problem, current), lawful[0].law)
    return as_predicts(current)


def _verdict(current: Fit) -> Verdict:
    """Return the verdict on a machine that is explained."""
    return Verdict.MISSING_PHYSICS if current.problem.terms or current.problem.held else Verdict.ADEQUATE


def _calibrated(robot: Robot, current: Fit) -> Robot:
    """Return the robot with all source errors of a fit."""
    parameters = current.problem.mechanism.parameters
    named = zip((p.name for p in parameters), current.errors[: len(parameters)].tolist(), strict=True)
    return dataclasses.replace(robot, errors=dict(named))


def _as_learned(problem: Problem, current: Fit) -> Fit:
    """Return the fit beside laws, which leave nothing for geometry to imitate, by what it has learned of its size."""
    as_large = dataclasses.replace(problem, scale=learned(current, problem.robot))
    return refitted(as_large, current, terms_of(current), tolerance=CONVERGED) or current


def _as_drawn(problem: Problem, current: Fit) -> Fit:
    """Return the fit of a geometry beside which there is no physics, by the tolerances of its drawing."""
    alone, _ = with_prior(problem.with_names(problem.names), problem.robot)
    return fit(
        alone,
        Prior(),
        errors=current.errors,
        instrument=current.instrument,
        repeats=None if current.repeats.plain else current.repeats,
        must_converge=False,
    )


def _without_orders(
    problem: Problem, search: Search, left: list[Structure], smooth: BorneOut | None
) -> tuple[Search, list[Structure], BorneOut | None]:
    """Drop single orders that held-out readings do not need beside smooth functions.

    Over less than a turn few waves imitate any function of a joint's angle; an error that repeats predicts better.
    """
    terms, turned = terms_of(search.fit), np.ptp(problem.body.q[np.unique(problem.readings.rows)], axis=0)
    kept = [t for t in terms if t.effect != wave() or any(turned[i - 1] > LEAST_TURN for i in t.limbs)]
    asked = len(kept) < len(terms) and (smooth is not None or crowded(search, terms, MOST_WAVES - 1))
    plain = refitted(problem, search.fit, kept) if asked else None
    other = None if plain is None else borne_out_beside(plain, unexplained := structures(plain))
    if plain is None or other is None:
        return search, left, smooth
    parts = folds(problem.readings, problem.recording)
    by_orders = held_out_errors(search.fit, Prior(), parts) if smooth is None else smooth.corrected
    if borne_out(other.corrected / plain.sigma, by_orders / plain.sigma):
        return search, left, smooth
    return Search(plain, search.terms), unexplained, other


def _beside_noise_of(found: Fit, first: Fit) -> Fit:
    """Return the fit of geometry alone as it counts with the noise that a later one has found: chance is of that."""
    if found.repeats.plain and first.repeats.plain:
        return first
    return refitted(first.problem, dataclasses.replace(first, repeats=found.repeats), []) or first


def _lean(problem: Problem) -> str | None:
    """Return the model of a printer's own session, whose few heights carry firmware's parameters and nothing else.

    None where `identify` would fit the full geometry, too, beside which effects can be told.
    """
    if not problem.readings.kind.probed:
        return None
    chosen = checks.chosen_model(problem, None)
    return None if chosen == problem.mechanism.full_model else chosen


def _untested(problem: Problem) -> tuple[Missing, ...]:
    full = checks.wanted(problem, problem.mechanism.full_model)
    why = f"at least {full} readings, of which there are {checks.once(problem)}: fewer cannot tell it from geometry"
    return tuple(Missing(name=name, missing=why) for name in effect_names())


def _of_all(problem: Problem, first: Fit, found: Fit, spectrum: Spectrum | None) -> tuple[Fit, Fit, Spectrum | None]:
    """Return the fit of the geometry to all readings, the fit with what was found, and the spectrum as all have it."""
    if first.problem.body is problem.body and spectrum is None:
        if found.problem.gives_way:
            found = refitted(problem, found, terms_of(found), not found.weights.all(), tolerance=CONVERGED) or found
        return first, found, None
    geometry = dataclasses.replace(problem, held=())
    baseline = first if first.problem.body is problem.body else refitted(geometry, first, [], tolerance=CONVERGED)
    how: dict[str, Any] = {"drop_gross": spectrum is not None, "tolerance": CONVERGED}
    start, parts = found, folds(problem.readings, problem.recording)
    if spectrum is not None and (near := refitted(spectrum.held_in(problem), found, terms_of(found))) is not None:
        near = believable(spectrum.held_in(problem), near)
        start, spectrum = settled(problem, near, spectrum, parts)
    held = spectrum.held_in(problem) if spectrum else geometry
    final = refitted(held, start, terms_of(start), **how)
    final = final and believable(held, final, **how)
    if baseline is None or final is None:
        raise NoConvergence("the fit of all readings did not converge, though that of a part did.")
    if spectrum is not None:  # orders are as unknown as what is beside them
        same = spectrum if len(spectrum.covariance) == len(final.covariance) else periodic(final, parts, spectrum)
        final = final if same is None else dataclasses.replace(final, covariance=same.covariance)
    return baseline, final, spectrum
