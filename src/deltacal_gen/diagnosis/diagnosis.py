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
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.correction import Correction, correct
from deltacal_gen.diagnosis.discrimination import Question, more_poses, next_measurements
from deltacal_gen.diagnosis.search import Found, Search, charge, library
from deltacal_gen.diagnosis.spectrum import Spectrum, periodic, wave
from deltacal_gen.diagnosis.structure import Region, Structure, smooth_columns, structures
from deltacal_gen.errors import InputError, NoSolutionError
from deltacal_gen.estimation.estimation import (
    SPARE_READINGS,
    Fit,
    Problem,
    fit,
    held_out,
    held_out_errors,
    lengths,
    pose_problem,
    rms,
)
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.files.recording import Recording, check_units, set_aside
from deltacal_gen.files.robot import Robot, kept_robot
from deltacal_gen.identification import identification
from deltacal_gen.identification.identification import Noise, folds, noise
from deltacal_gen.instrument.instrument import Instrument
from deltacal_gen.machine.backend import by_recording
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.physics.physics import Body, Term, blank, effect_names, kept_term, load_effect, row_coefficients
from deltacal_gen.physics.states import read_by
from deltacal_gen.results.diagnosis import (
    Baseline,
    BeforeAfter,
    Channel,
    Diagnosis,
    Effect,
    EffectParameter,
    Final,
    Location,
    NextMeasurement,
    NoiseLevel,
    RegionOf,
    Rejected,
    Residuals,
    Seen,
    SeenJoint,
    SmoothCorrection,
    Verdict,
)
from deltacal_gen.results.parts import InstrumentState, MachineState, Missing
from deltacal_gen.units import DEG, joint_factors, joint_names

MARGIN = 10.0  # of chi2, beyond all charges: what an effect must earn to be named, and what is left to be unexplained
# of chi2: two explanations whose expected difference is below 10 are not told apart; the difference found spreads by
# twice its root, and two such deviations are allowed
AMBIGUOUS = 10.0 + 4 * 10.0**0.5
MOST_EFFECTS = 3
MOST_POSES = 700  # that the search looks at, drawn at random: they show what is there; the fit uses all
SEED = 2013
REVISIONS = 4
MUCH_WORSE = 1.02  # times the noise: another form that fits so much worse in the exact machine is not taken
MACHINED = 5.0  # standard deviation of a source error, in ordinary ones: geometry may not strain to imitate physics
SHORT = 2.0  # times the noise: a held-out error beyond it says that the geometry itself is hardly known
ROOM = 10.0  # mm: root mean square that an effect's coefficient may well move the readings, a prior that never pulls
BORNE_OUT = 2.0  # standard deviations by which held-out readings must speak for what is named
Progress = Callable[[str], None]


@dataclass(frozen=True)
class Diagnosed:
    """What was found, with the fits that it rests on; `answer` gives the same as users read it."""

    verdict: Verdict
    model: str
    baseline: Fit
    final: Fit
    effects: tuple[Named, ...]
    heldout: tuple[float, float]
    noise: Noise
    location: Location
    rejected: tuple[Rejected, ...]
    not_tested: tuple[Missing, ...]
    next_measurements: tuple[NextMeasurement, ...]
    robot: Robot
    correction: Correction | None = None
    spectrum: Spectrum | None = None
    lean: bool = False

    @property
    def short(self) -> bool:
        """Whether there are too few readings to tell a lesser effect from geometry."""
        return self.verdict is Verdict.ADEQUATE and not self.heldout[0] <= SHORT * self.noise.sigma

    def answer(self) -> Diagnosis:
        """Return the same as users read it: DIAGNOSIS.json."""
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
    mechanism = mechanism_of(robot)
    lean = model is None and _lean(robot, recording)
    model = lean or model or mechanism.full_model
    names = mechanism.model(model)
    problem = pose_problem(robot, recording, names)
    scale = np.array([robot.tolerance.get(n, MACHINED * s) for n, s in zip(names, problem.scale, strict=True)])
    problem = dataclasses.replace(problem, scale=scale)
    identification.distinct(problem, recording)
    if not lean:
        identification.enough(mechanism, problem, recording)
        identification.enough_poses(problem, model)
    progress("geometry")
    some, kind = _drawn(problem), problem.readings.kind
    rough = identification.rough(some, must_converge=False)
    identification.plausible(rough)
    identification.check_rows(rough, recording)
    # what is left out may look like gross errors where it is strongest: none is dropped before it is known
    first = fit(some, Prior(), errors=rough.errors, instrument=rough.instrument, drop_gross=False, must_converge=False)
    terms, not_tested = library(some) if not lean else ([], _untested(problem))
    parts = folds(some.readings, some.recording)
    search, considered = _chosen(some, first, terms, progress)
    progress("held-out error")
    without, tested = held_out_errors(first, Prior(), parts), search
    predicted = _held_out(some, search, parts) if search.effects else without
    if search.effects and not _borne_out(without / first.sigma, predicted / first.sigma):
        search = Search(first, terms)
    progress("what is left")
    search, left = _without_gross(some, search)

    def short_of_noise() -> bool:
        return identification.lack_of_fit(search.fit, some.recording) or any(s.earned > MARGIN for s in left)

    unexplained = not lean and short_of_noise()
    spectrum = None
    if unexplained:
        progress("periodic errors of many orders")
        spectrum = _spectrum(some, search, parts)
    if spectrum is not None:
        some = dataclasses.replace(some, held=spectrum.terms)
        others = [t for t in _terms(search.fit) if t.effect != wave()]
        beside = _refitted(some, search.fit, others)
        if beside is not None:
            search, considered = _chosen(some, beside, [t for t in terms if t.effect != wave()], progress)
            search, left = _without_gross(some, search)
            unexplained = short_of_noise()
    if left[0].earned > MARGIN and search.effects:
        proven = _proven(some, search, smooth_columns(search.fit, left[0].channel))
        if proven is not search:
            search, left = proven, structures(proven.fit)
            unexplained = not lean and short_of_noise()
    # what comes near its price without earning it is no finding, but worth a measurement
    doubtful = [f.term for f in search.ranked()[:1] if 0 < f.score < MARGIN]
    before = after = rms(lengths(without, kind))
    if search.effects and spectrum is None:
        after = rms(lengths(predicted if search is tested else _held_out(some, search, parts), kind))
    progress(f"fit of all {len(problem.readings)} readings")
    baseline, current, spectrum = _of_all(problem, first, search.fit, spectrum)
    heldout = (before, after if spectrum is None else spectrum.heldout[1])
    named_any = current.problem.terms or current.problem.held
    verdict = Verdict.UNEXPLAINED if unexplained else Verdict.MISSING_PHYSICS if named_any else Verdict.ADEQUATE
    known = noise(current, recording)
    named = _named(search, current, heldout, known.sigma, spectrum)
    location = _location(search.fit, left, named, spectrum, explained=not unexplained)
    progress("what to measure next")
    questions = [
        *(Question(n.term, n.rivals, n.unrecorded) for n in named),
        *(Question(search.estimated(t), proven=False) for t in doubtful),
    ]
    fitted = current.errors[: len(mechanism.parameters)]
    calibrated = dataclasses.replace(
        robot, errors={p.name: float(v) for p, v in zip(mechanism.parameters, fitted, strict=True)}
    )
    return Diagnosed(
        verdict=verdict,
        model=model,
        baseline=baseline,
        final=current,
        effects=named,
        heldout=heldout,
        noise=known,
        location=location,
        rejected=_rejected(considered, named, spectrum),
        not_tested=not_tested,
        next_measurements=next_measurements(search.fit, questions, location if unexplained else None),
        robot=calibrated,
        correction=correct(search.fit, left, parts) if unexplained else None,
        spectrum=spectrum,
        lean=bool(lean),
    )


def _lean(robot: Robot, recording: Recording) -> str | None:
    """Return the model of a printer's own session, whose few heights carry firmware's parameters and nothing else.

    None where the readings carry the full geometry, beside which effects can be told.
    """
    mechanism = mechanism_of(robot)
    problem = pose_problem(robot, recording, ())
    full = len(mechanism.model(mechanism.full_model)) + SPARE_READINGS
    if not problem.readings.kind.probed or problem.readings.n_scalars >= full:
        return None
    return identification.chosen_model(mechanism, problem, recording, None)


def _untested(problem: Problem) -> tuple[Missing, ...]:
    full = len(problem.mechanism.model(problem.mechanism.full_model)) + SPARE_READINGS
    why = (
        f"at least {full} readings, of which there are {problem.readings.n_scalars}: fewer cannot tell it from geometry"
    )
    return tuple(Missing(name=name, missing=why) for name in effect_names())


def _drawn(problem: Problem) -> Problem:
    """Return the problem with some of its poses where they are many, all readings of a pose or none."""
    found, body = problem.readings, problem.body
    groups = np.unique(found.group)
    if len(groups) <= MOST_POSES:
        return problem
    drawn = np.random.default_rng(SEED).choice(groups, MOST_POSES, replace=False)
    part = found.subset(np.flatnonzero(np.isin(found.group, drawn)))
    rows = np.unique(part.rows)
    _, group = np.unique(part.group, return_inverse=True)
    return dataclasses.replace(
        problem,
        recording=problem.recording.subset(rows),
        readings=dataclasses.replace(part, rows=np.searchsorted(rows, part.rows), group=group),
        body=Body(body.robot, body.mechanism, body.q[rows], body.tool[rows], body.channels.subset(rows)),
    )


def _of_all(problem: Problem, first: Fit, found: Fit, spectrum: Spectrum | None) -> tuple[Fit, Fit, Spectrum | None]:
    """Return the fit of the geometry to all readings, the fit with what was found, and the spectrum as all have it."""
    if first.problem.body is problem.body and spectrum is None:
        return first, found, None
    geometry = dataclasses.replace(problem, held=())
    baseline = first if first.problem.body is problem.body else _refitted(geometry, first, [])
    terms = _terms(found)
    final = _refitted(dataclasses.replace(problem, held=spectrum.terms if spectrum else ()), found, terms)
    if spectrum is not None and final is not None:
        spectrum = periodic(final, folds(problem.readings, problem.recording), spectrum) or spectrum
        final = _refitted(dataclasses.replace(problem, held=spectrum.terms), final, terms, drop_gross=True)
    if baseline is None or final is None:
        raise NoSolutionError("the fit of all readings did not converge, though that of a part did.")
    return baseline, final, spectrum


def _spectrum(problem: Problem, search: Search, parts: Sequence[tuple[np.ndarray, np.ndarray]]) -> Spectrum | None:
    """Return periodic errors of many orders where they predict readings better than the few that were found."""
    terms = _terms(search.fit)
    beside = _refitted(problem, search.fit, [t for t in terms if t.effect != wave()])
    found = None if beside is None else periodic(beside, parts)
    if found is None or found.heldout[1] >= held_out(search.fit, Prior(), parts):
        return None
    return found


# -------------------------------------------------------------------------------------------------- what is named


def _chosen(problem: Problem, baseline: Fit, terms: Sequence[Term], progress: Progress) -> tuple[Search, list[Found]]:
    """Return the fit with every effect that earns its price, and the best form of each effect at the first look.

    Forwards: the effect that earns most is fitted jointly with all before. After each, every effect is looked at again
    with the others beside it: another form, another effect or none may now be better.
    """
    search = Search(baseline, terms)
    considered: list[Found] = []
    while len(search.effects) < MOST_EFFECTS:
        named = search.effects
        progress(f"search {len(named) + 1}: {len(terms)} forms of {len({t.effect for t in terms})} effects")
        ranked = search.ranked()
        considered = considered or ranked
        if not ranked or ranked[0].score < MARGIN:
            break
        better = _refitted(problem, search.fit, [*_terms(search.fit), ranked[0].term])
        if better is None or better.sigma[0] > search.fit.sigma[0] * MUCH_WORSE:
            break  # it did not converge
        search = _revised(problem, Search(better, terms))
        if search.effects == named:
            break  # it did not hold
    return search, considered


def _without_gross(problem: Problem, search: Search) -> tuple[Search, list[Structure]]:
    """Return the search without gross errors, and what it leaves.

    They are dropped only where nothing is left with them: readings that lie off together, in a region or for a time,
    are no gross errors but what the model does not know. For that, none counts more than an ordinary reading that is
    just off: the squares of Huber's weights bound what each adds to a gain.
    """
    left = structures(dataclasses.replace(search.fit, weights=search.fit.weights**2))
    if left[0].earned > MARGIN or not len(search.fit.gross):
        return search, left
    final = _refitted(problem, search.fit, _terms(search.fit), drop_gross=True)
    if final is None:
        return search, left
    search = _proven(problem, Search(final, search.terms))
    return search, structures(search.fit)


def _terms(at: Fit) -> list[Term]:
    return list(at.problem.split(at.errors)[1])


def _refitted(problem: Problem, at: Fit, terms: Sequence[Term], drop_gross: bool = False) -> Fit | None:
    """Return the joint fit of geometry, instrument and effects, starting from a fit; None where there is none.

    What is left out may look like gross errors where it is strongest: none is dropped before all is known.
    """
    n_p = len(problem.mechanism.parameters)
    errors, joint = at.errors[:n_p], problem
    if terms:
        same = at.problem.body is problem.body
        machine = at.problem.solve(at.errors) if same else problem.solve(errors)
        columns = problem.term_columns(terms, at.errors, at.instrument, machine)
        flat = np.where(np.isfinite(columns), columns, 0.0).reshape(-1, columns.shape[2])
        scale = ROOM * np.sqrt(len(flat)) / np.maximum(np.linalg.norm(flat, axis=0), 1e-300)
        joint = problem.with_terms(terms, scale)
        errors = np.concatenate([errors, *(t.values.ravel() for t in terms)])
    try:
        return fit(joint, Prior(), errors=errors, instrument=at.instrument, drop_gross=drop_gross, must_converge=False)
    except (NoSolutionError, InputError):
        return None


def _revised(problem: Problem, search: Search) -> Search:
    """Look at each effect again with the others held beside it, until none has a better form."""
    for _ in range(REVISIONS):
        count = len(search.effects)
        tried = (_better(problem, search.fit, i, search.freed(i).ranked()[0]) for i in range(count))
        better = next((found for found in tried if found is not None), None)
        if better is None:
            break
        search = Search(better, search.terms)
    return search


def _better(problem: Problem, current: Fit, i: int, best: Found) -> Fit | None:
    """Return a fit in which what is best, or nothing, stands for an effect; None where it is best as it is."""
    chosen = _terms(current)
    others = chosen[:i] + chosen[i + 1 :]
    if best.score < MARGIN:
        return _refitted(problem, current, others)
    if _form(best.term) == _form(chosen[i]):
        return None
    other = _refitted(problem, current, [*others, best.term])
    return other if other is not None and other.sigma[0] <= current.sigma[0] * MUCH_WORSE else None


def _proven(problem: Problem, search: Search, rest: Array | None = None) -> Search:
    """Drop the effects that do not earn their price, or do not beside the rest, columns that explain them as well.

    What no effect explains is easily imitated in part by some that vary with the same channel.
    """
    drop_gross = not search.fit.weights.all()
    while search.effects:
        terms = _terms(search.fit)
        scores = []
        for i, term in enumerate(terms):
            beside = search.freed(i) if rest is None else search.freed(i).joined(rest)
            forms = sum(t.effect == term.effect for t in search.terms)
            scores.append(beside.gain(beside.where(term)) - charge(term, forms))
        worst = int(np.argmin(scores))
        if scores[worst] > MARGIN:
            break
        kept = _refitted(problem, search.fit, terms[:worst] + terms[worst + 1 :], drop_gross=drop_gross)
        if kept is None:
            break
        search = Search(kept, search.terms)
    return search


def _borne_out(before: Array, after: Array) -> bool:
    """Tell whether readings held out lie nearer to their prediction after than before, (R, k) in standard deviations.

    Each counts by the part of its square that goes or comes, which no gross error outweighs.
    """
    a, b = np.nansum(before**2, axis=1), np.nansum(after**2, axis=1)
    seen = np.isfinite(before).any(axis=1) & np.isfinite(after).any(axis=1) & (a + b > 0)
    gone = (a[seen] - b[seen]) / (a[seen] + b[seen])
    if len(gone) < 2:
        return False
    return bool(gone.mean() > BORNE_OUT * gone.std(ddof=1) / np.sqrt(len(gone)))


def _held_out(problem: Problem, search: Search, parts: Sequence[tuple[np.ndarray, np.ndarray]]) -> Array:
    """Return the errors (R, k) [mm, rad] of readings that took part neither in a fit nor in the choice of its effects.

    Each part of the readings is predicted from the others, which choose their own effects: by the same charges, in the
    machine made linear at the final fit.
    """
    final = {_form(t): t for t in _terms(search.fit)}
    out = np.full(search.fit.residual.shape, np.nan)
    for train, test in parts:
        part = search.freed(*range(len(final))).within(train)
        chosen: list[Term] = []
        while len(chosen) < MOST_EFFECTS and (best := part.ranked()[0]).score > MARGIN:
            chosen.append(best.term)
            part = part.added(best.term)
        same = {_form(t) for t in chosen} == final.keys()
        terms = [final.get(_form(t), t) for t in chosen]
        fitted = search.fit if same else _refitted(problem, search.fit, terms)
        if fitted is not None:
            out[test] = held_out_errors(fitted, Prior(), [(train, test)])[test]
    return out


def _form(term: Term) -> tuple[object, ...]:
    return term.effect, term.limbs, term.constants, term.tools


def _location(
    at: Fit, left: Sequence[Structure], named: Sequence[Named], spectrum: Spectrum | None, explained: bool
) -> Location:
    """Return channels by their share of the misfit, the limbs, the region where it is local, and all in words.

    Where effects explain the misfit they say what it depends on; elsewhere the strongest structures do.
    """
    channels: dict[str, tuple[float, float]] = {}
    limbs: list[int] = []
    region: Region | None = None
    unit, joints = at.problem.recording.joint_unit, at.problem.mechanism.limbs
    names = joint_names(unit, joints)
    if explained:
        periodic_at = spectrum.gains if spectrum is not None else {}
        limbs = sorted({i for n in named for i in n.term.limbs} | set(periodic_at))
        for i, gain in periodic_at.items():
            share = gain / (sum(periodic_at.values()) + sum(n.gain for n in named))
            channels[names[i - 1]] = (share, float(np.exp(-min(gain, 1400.0) / 2)))
        for n in named:
            for state in n.term.states:
                for name in state.shown_in(unit, joints, n.term.limbs or range(1, joints + 1)):
                    share = max(n.share, channels.get(name, (0.0, 1.0))[0])
                    channels[name] = (share, float(np.exp(-min(n.gain, 1400.0) / 2)))
    else:
        total = float(np.nansum((at.residual / at.sigma) ** 2))
        earning = [s for s in left if s.earned > 0]
        for s in earning:
            channels[s.channel] = (min(s.earned / total, 1.0), float(np.exp(-min(s.earned, 1400.0) / 2)))
        if earning:
            limbs, region = list(earning[0].limbs), earning[0].region
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
    return Location(
        channels=tuple(Channel(name=name, p_value=p, share=share) for name, (share, p) in ordered),
        limbs=tuple(limbs),
        region=None if region is None else RegionOf(centre_mm=tuple(region[0]), radius_mm=region[1]),
        text=text,
    )


# ------------------------------------------------------------------------------------------------ what was found


def _named(
    search: Search, final: Fit, heldout: tuple[float, float], sigma: float, spectrum: Spectrum | None
) -> tuple[Named, ...]:
    """Return the effects of the final fit with their uncertainty, their gain beside all others, and their rivals.

    `heldout` is the error without and with them on readings that no fit has seen, `sigma` the noise in it [mm].
    """
    out: list[Named] = []
    for i, term in enumerate(_terms(final)):
        freed = search.freed(i)
        variance = np.diag(final.covariance)[final.problem.coefficients(i)]
        gain = freed.gain(freed.where(term))
        price = charge(term, sum(t.effect == term.effect for t in search.terms))
        others = [f for f in freed.ranked() if f.term.effect != term.effect]
        rivals = tuple(f.term for f in others if f.score > gain - price - AMBIGUOUS)
        std = np.sqrt(np.maximum(variance, 0.0))
        out.append(Named(term, std, gain, 1.0, rivals, _unrecorded(freed, gain - price)))
    # of the held-out variance above noise, each in proportion to what is lost without it
    before, after = heldout
    removed = float(np.clip((before**2 - after**2) / max(before**2 - sigma**2, 1e-300), 0.0, 1.0))
    total = sum(n.gain for n in out) + (sum(spectrum.gains.values()) if spectrum else 0.0)
    return tuple(dataclasses.replace(n, share=removed * n.gain / total) for n in out)


def _unrecorded(freed: Search, score: float) -> tuple[str, ...]:
    """Return effects of a temperature that was not recorded, or did not vary, that explain as much all the same."""
    body = freed.fit.problem.body
    warming = body.channels.get("warming")
    rows = np.unique(freed.fit.problem.readings.rows)
    if warming is not None and (not np.isfinite(warming[rows]).all() or np.ptp(warming[rows]) > 0):
        return ()
    warm = np.ones(len(body.q)) if warming is None else warming
    channels = body.channels.with_values(warming=warm, temperature=warm + 20.0)
    assumed = Body(body.robot, body.mechanism, body.q, body.tool, channels)
    limbs = tuple(range(1, body.mechanism.limbs + 1))
    terms = [
        blank(name, limbs)
        for name in effect_names()
        if any(s.column == "temp_C" for s in read_by(load_effect(name))) and assumed.missing(name) is None
    ]
    found = freed.of(assumed, terms).ranked()
    return tuple(f.term.effect for f in found if f.score > score - AMBIGUOUS)


def _rejected(considered: Sequence[Found], named: Sequence[Named], spectrum: Spectrum | None) -> tuple[Rejected, ...]:
    chosen = {n.term.effect for n in named} | ({wave()} if spectrum is not None else set())
    alike = {name: n.term.effect for n in named for name in n.alike}
    return tuple(
        Rejected(
            name=f.term.effect,
            gain_chi2=f.gain,
            why=f"not told from {alike[f.term.effect]} by these poses"
            if f.term.effect in alike
            else "earns less than the charge for its coefficients and for the search"
            if f.score < MARGIN
            else "explains less of the same misfit than what was named"
            if chosen
            else "explains part of the misfit, but does not hold",
        )
        for f in sorted(considered, key=lambda f: -f.gain)
        if f.term.effect not in chosen
    )


def _result(found: Diagnosed) -> Diagnosis:
    baseline, final, sigma = found.baseline, found.final, found.noise.sigma
    before, after = (heldout if np.isfinite(heldout) else None for heldout in found.heldout)
    of_baseline, of_final = ((float(at.sigma[0]) / sigma) ** 2 for at in (baseline, final))
    return Diagnosis(
        verdict=found.verdict,
        summary=_summary(found),
        noise=NoiseLevel(sigma_mm=sigma, source=found.noise.source),
        baseline=Baseline(
            model=found.model, train_rms_mm=baseline.rms(), heldout_rms_mm=before, chi2_per_dof=of_baseline
        ),
        location=found.location,
        effects=(
            *([_periodic(found, found.spectrum)] if found.spectrum is not None else []),
            *(_effect(n, final.problem.recording.joint_unit) for n in found.effects),
        ),
        final=Final(train_rms_mm=final.rms(), heldout_rms_mm=after, chi2_per_dof=of_final),
        rejected=found.rejected,
        not_tested=found.not_tested,
        next_measurements=(
            *found.next_measurements,
            *([more_poses(found.final.problem)] if found.short else []),
        ),
        gross_errors=tuple(int(final.problem.readings.line[j]) for j in final.gross),
        correction=_correction(found),
        residuals=_residuals(found),
        sigma_mm=sigma,
        physics=tuple(map(kept_term, final.problem.acting(final.errors))),
        seen=None if found.spectrum is None else _seen(found.spectrum),
        clock="row" if final.problem.body.channels.get("time") is None else "time_s",
        instrument=_instrument(found, final.instrument),
        robot=kept_robot(found.robot),
    )


def _instrument(found: Diagnosed, known: Instrument) -> InstrumentState:
    recording = found.final.problem.recording
    return known.kept(recording.setup_names, recording.measurement.zero)


def _correction(found: Diagnosed) -> SmoothCorrection | None:
    """Return the smooth correction: what it depends on, what it gains on held-out poses, and all that it needs.

    `machine` holds geometry, effects and instrument as they are beside it.
    """
    if found.correction is None:
        return None
    made, before, after = found.correction, *found.correction.heldout
    names = [p.name for p in found.final.problem.mechanism.parameters]
    robot = dataclasses.replace(found.robot, errors=dict(zip(names, made.errors.tolist(), strict=True)))
    excess = max(before**2 - found.noise.sigma**2, 1e-300)
    return SmoothCorrection(
        depends_on=(made.smooth.variable,),
        limbs=made.smooth.limbs,
        rms_mm=made.size,
        heldout_rms_mm=BeforeAfter(before=before, after=after),
        share_of_excess=float(np.clip((before**2 - after**2) / excess, 0.0, 1.0)),
        smooth=made.smooth.kept(),
        machine=MachineState(
            robot=kept_robot(robot),
            physics=tuple(map(kept_term, made.terms)),
            instrument=_instrument(found, made.instrument),
        ),
    )


def _residuals(found: Diagnosed) -> Residuals:
    """Return what every reading is off, before and after, where it was read and what the channels said there."""
    problem = found.final.problem
    rows = problem.readings.rows[:, 0]
    machine = problem.solve(found.final.errors)
    channels = {
        name: values[rows] for name, values in problem.recording.channels.items() if not name.startswith("true_")
    }
    unit, q = problem.recording.joint_unit, problem.body.q[rows]
    channels |= zip(joint_names(unit, q.shape[1]), (q / joint_factors(unit, q.shape[1])).T, strict=True)
    return Residuals(
        line=problem.readings.line,
        position_mm=machine.x[rows, :3],
        before_mm=np.nan_to_num(found.baseline.residual[:, :3]),
        after_mm=np.nan_to_num(found.final.residual[:, :3]),
        channels=channels,
    )


def _effect(found: Named, joint_unit: str) -> Effect:
    term, kernels = found.term, found.term.kernels
    parameters: list[EffectParameter] = []
    std = found.std.reshape(term.values.shape)
    for r, (row, units) in enumerate(zip(term.values, row_coefficients(term, joint_unit), strict=True)):
        for c, (name, unit, factor) in enumerate(units):
            parameters.append(
                EffectParameter(
                    name=name,
                    limb=term.limbs[r] if term.limbs else None,
                    value=float(row[c] / factor),
                    std=float(std[r, c] / factor),
                    unit=unit,
                    tool_mm=term.tools[r] if term.tools else None,
                )
            )
    for value, (name, unit, factor, _) in zip(term.constants, kernels.CONSTANTS, strict=True):
        parameters.append(EffectParameter(name=name, limb=None, value=value / factor, std=None, unit=unit))
    return Effect(
        name=term.effect,
        title=kernels.TITLE,
        limbs=term.limbs,
        parameters=tuple(parameters),
        p_value=float(np.exp(-min(found.gain, 1400.0) / 2)),
        gain_chi2=found.gain,
        share_of_excess=found.share,
        indistinguishable_from=found.alike,
    )


def _periodic(found: Diagnosed, spectrum: Spectrum) -> Effect:
    """Return the entry of periodic errors of many orders: what they come to, joint by joint."""
    kernels, gain = load_effect(wave()), sum(spectrum.gains.values())
    before, after = found.heldout
    removed = (before**2 - after**2) / max(before**2 - found.noise.sigma**2, 1e-300)
    joints = (
        EffectParameter(name="rms", limb=j, value=v / DEG, std=spectrum.std[j] / DEG, unit="deg")
        for j, v in spectrum.rms.items()
    )
    return Effect(
        name=wave(),
        title=kernels.TITLE,
        limbs=spectrum.limbs,
        parameters=(*joints, EffectParameter(name="corner", limb=None, value=spectrum.corner, std=None, unit="1")),
        orders=(1, len(spectrum.terms)),
        p_value=float(np.exp(-min(gain, 1400.0) / 2)),
        gain_chi2=gain,
        gain_by_limb={str(j): g for j, g in spectrum.gains.items()},
        share_of_excess=float(np.clip(removed, 0.0, 1.0)) * gain / (gain + sum(n.gain for n in found.effects)),
        indistinguishable_from=(),
    )


def _seen(spectrum: Spectrum) -> Seen:
    """Return between which angles of the turn each joint was read, and how near to them its error is still known."""
    return Seen(
        within_deg=180.0 / spectrum.corner,
        joints=tuple(SeenJoint(limb=j, angles_deg=tuple(spans)) for j, spans in spectrum.seen.items()),
    )


def _summary(found: Diagnosed) -> str:
    before, after = found.heldout
    if found.lean:
        scalars, count = found.final.problem.readings.n_scalars, len(found.final.problem.names)
        return (
            f"No physics can be named: {scalars} readings carry the {count} parameters of {found.model} and leave "
            f"{scalars - count} to judge by; whatever is missing, the parameters take over. The fit leaves "
            f"{found.final.rms():.4f} mm. Probe a mesh over the whole bed, and measure distances on a printed object."
        )
    if found.short:
        held_out = f"{before:.4f} mm" if np.isfinite(before) else "too little to say"
        return (
            f"Nothing can be shown to be missing, but these poses are too few for {len(found.baseline.problem.names)} "
            f"parameters: on held-out readings the geometry leaves {held_out}, where the noise is "
            f"{found.noise.sigma:.4f} mm. Measure more poses."
        )
    if found.verdict is Verdict.ADEQUATE:
        return (
            f"Nothing is missing: what the calibrated geometry leaves, {before:.4f} mm on held-out readings, is noise. "
            "Use the calibrated machine."
        )
    parts = []
    if found.spectrum is not None:
        joints = ", ".join(map(str, found.spectrum.limbs))
        parts.append(f"{load_effect(wave()).TITLE} of many orders ({wave()}) at joints {joints}")
    for n in found.effects:
        limbs = (
            f" at limb{'s' if len(n.term.limbs) > 1 else ''} {', '.join(map(str, n.term.limbs))}"
            if n.term.limbs
            else ""
        )
        parts.append(f"{n.term.kernels.TITLE} ({n.term.effect}){limbs}")
    if found.verdict is Verdict.MISSING_PHYSICS:
        open_questions = [f"{n.term.effect} from {' or '.join(n.alike)}" for n in found.effects if n.alike]
        doubt = f" These poses cannot tell {'; '.join(open_questions)}." if open_questions else ""
        return (
            f"Geometry alone leaves {before:.4f} mm on held-out readings. What is missing: {'; '.join(parts)}. "
            f"With it {after:.4f} mm are left, which is noise.{doubt}"
        )
    named = f" Proven beside it: {'; '.join(parts)}." if parts else ""
    left = rms(lengths(found.final.residual, found.final.problem.readings.kind))
    return (
        f"A mismatch of {left:.4f} mm is left that no registered effect explains: "
        f"{found.location.text}.{named} {_corrected(found.correction)}"
    )


def _corrected(made: Correction | None) -> str:
    if made is None:
        return "No smooth correction holds on held-out readings."
    before, after = made.heldout
    on = "position" if made.smooth.variable == "position" else f"the channel {made.smooth.variable}"
    return (
        f"A smooth correction by {on}, without physics, lowers the error of held-out readings from {before:.4f} to "
        f"{after:.4f} mm; predictions use it where {made.smooth.variable} is as in this recording."
    )
