"""Identification: a robot and a recording in, a calibrated robot and what the data pin of it out.

Two stages (Bai 2015, section 4.2): the encoder offsets first, iterated, since they are the largest by far; then all
parameters of the model. Both are exact: the stages differ in what is free, not in the machine.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any

from deltacal_gen.errors import OtherMachine, UnknownName
from deltacal_gen.estimation.fit import fit, held_out, rough
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import with_prior
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.solvers import TSVD, LeastSquares, Prior, Ridge, Solver
from deltacal_gen.files.checks import check_units
from deltacal_gen.files.robot import Robot, for_model
from deltacal_gen.identification import carried, drawing, identifiability
from deltacal_gen.identification.answer import Identification
from deltacal_gen.identification.carried import Periodic
from deltacal_gen.identification.checks import chosen_model, distinct, plausible
from deltacal_gen.identification.folds import FOLDS, folds
from deltacal_gen.identification.knowledge import uncertainty_of
from deltacal_gen.identification.noise import noise, with_tails
from deltacal_gen.identification.orders import wave
from deltacal_gen.identification.outliers import begun, check_rows, without_knocked, without_overflow
from deltacal_gen.identification.remedies import remedies
from deltacal_gen.identification.together import together, without_following
from deltacal_gen.identification.uncertainty import uncertainty_map
from deltacal_gen.machine.backend import by_recording
from deltacal_gen.machine.differences import between
from deltacal_gen.machine.registry import Machine, mechanism_of
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.terms import Term
from deltacal_gen.results.parts import Continued, Missing

Progress = Callable[[str], None]


@by_recording("identify")
def identify(
    robot: Robot,
    recording: Recording,
    model: str | None = None,
    *,
    as_distance: bool = False,
    solver: str | Solver = "prior",
    truncation: int | str = "gcv",
    robust: bool = True,
    held: Sequence[Term] = (),
    periodic: Periodic | None = None,
    machine: Robot | None = None,
    progress: Progress = lambda text: None,
) -> Identification:
    """Identify a robot's source errors from a recording.

    Parameters
    ----------
    model : str, optional
        ``delta/32`` or ``32``; default the largest that the number of readings allows.
    as_distance : bool
        Use the distances of all pairs of measured positions instead of the positions.
    solver : {"prior", "least-squares", "tsvd", "ridge"}, or a solver such as ``TSVD(8)``
        Rule for directions that the data hardly see. ``prior`` uses the robot file's ``[tolerance]``, and ten times
        an ordinary manufacturing error for what it does not name.
    truncation : int or {"gcv", "discrepancy"}
        For ``tsvd``.
    robust : bool
        Let a few per cent of gross errors not move the result.
    held : sequence of Term
        Effects that stay as a diagnosis found them, while geometry and frame are refitted.
    periodic : Periodic, optional
        What it knew of the periodic errors of joints among them: the readings tell further of these.
    machine : Robot, optional
        The machine as it was calibrated in another session: source errors that the model leaves out stay as they are
        there.
    progress : callable
        Told in words what is being done.

    Raises
    ------
    InputError
        Too few readings for the model; joints at which the machine cannot stand; units that cannot be.
    NoSolutionError
        No convergence.
    UsageError
        An unknown model or solver.
    """
    if model is not None:
        robot = for_model(robot, model)
    in_file = mechanism_of(robot).vector(robot.errors)
    robot, everything, chosen, not_held = _asked(robot, recording, model, held, machine, as_distance=as_distance)
    names = everything.mechanism.model(chosen)
    own = everything.with_names(names)
    rule = _solver(solver, truncation, recording.measurement.sigma_mm)
    problem = with_prior(own, robot)[0] if isinstance(rule, Prior) else own

    progress("rough stage: encoder offsets")
    distinct(everything)
    first, problem, dropped = _begun(everything, problem, robust, progress, None if periodic is None else wave())
    plausible(first)
    check_rows(first)
    progress(f"fine stage: {len(names)} parameters of {chosen}")
    final, told, lost = _carried(_fine(problem, rule, first, robust), rule, first, periodic, robust)
    problem, not_held = final.problem, not_held + dropped + lost
    before = drawing.filed_rms(final)
    progress(f"held-out error: {FOLDS} folds")
    final, heldout = _held_out(final, rule, robust) if told is None else (final, told.heldout_rms_mm)
    progress("identifiability")
    seen = identifiability.seen(final, dataclasses.replace(own, held=problem.held, readings=problem.readings))
    calibrated = _calibrated(robot, final, names)
    progress("uncertainty over the workspace")
    of_noise = with_tails(noise(final, recording), final)
    sure = uncertainty_of(final, of_noise, None if told is None else heldout)
    return Identification(
        model=chosen,
        fit=final,
        rough=first,
        before_rms=before,
        heldout_rms=heldout,
        seen=seen,
        remedies=remedies(final, seen),
        noise=of_noise,
        robot=calibrated,
        in_file=in_file,
        not_held=not_held,
        continued=told,
        map=None if problem.readings.kind.sees_joints else uncertainty_map(final, calibrated, sure),
        uncertainty=sure,
    )


def _asked(
    robot: Robot,
    recording: Recording,
    model: str | None,
    held: Sequence[Term],
    machine: Robot | None,
    *,
    as_distance: bool,
) -> tuple[Robot, Problem, str, tuple[Missing, ...]]:
    """Return robot, problem of all parameters and model as they are asked for, and which effects cannot be held."""
    check_units(recording, robot)
    mechanism = mechanism_of(robot)
    everything = pose_problem(robot, recording, (), as_distance=as_distance)
    held, not_held = carried.usable(everything, held)
    everything = dataclasses.replace(everything, held=held)
    chosen = chosen_model(everything, model)
    names = mechanism.model(chosen)
    if machine is not None and len(names) < len(mechanism.parameters):
        robot = dataclasses.replace(robot, errors=_left_out(mechanism, robot, machine, names))
        everything = pose_problem(robot, recording, (), as_distance=as_distance, held=held)
    return robot, everything, chosen, not_held


def _begun(
    everything: Problem, problem: Problem, robust: bool, progress: Progress, spared: str | None = None
) -> tuple[Fit, Problem, tuple[Missing, ...]]:
    """Return the rough fit, the problem with the effects that these readings bear out, and those that they do not."""
    everything, first = begun(everything, robust)
    problem = dataclasses.replace(problem, readings=everything.readings)
    if not everything.held or everything.readings.made:
        return first, problem, ()
    progress("what of the diagnosis holds here")
    held, dropped = carried.borne_out(problem, first, spared=spared)
    if not dropped:
        return first, problem, ()
    everything, problem = (dataclasses.replace(p, held=held) for p in (everything, problem))
    return rough(everything, robust), problem, dropped


def _fine(problem: Problem, rule: Solver, first: Fit, robust: bool) -> Fit:
    """Return the fit of a model, of a machine far from the drawn one where that is the one that was read.

    It is one of fewer readings where others are gross errors, too many or too far to be left to their weights.
    """
    at = fit(problem, rule, errors=first.errors, machine=first.machine, instrument=first.instrument, robust=robust)
    at = (drawing.as_read(at, robust=robust) or at) if isinstance(rule, Prior) else at
    without = (without_overflow, without_knocked, without_following) if robust else (without_following,)
    rest = next((some for each in without if (some := each(at.problem, at)) is not None), None)
    return at if rest is None else _fine(rest, rule, first, robust)


def _calibrated(robot: Robot, final: Fit, names: Sequence[str]) -> Robot:
    """Return the robot with the source errors of a fit."""
    found = zip(final.problem.mechanism.index, final.errors.tolist(), strict=True)
    return dataclasses.replace(robot, errors={name: value for name, value in found if value or name in names})


def _carried(
    final: Fit, rule: Solver, first: Fit, periodic: Periodic | None, robust: bool
) -> tuple[Fit, Continued | None, tuple[Missing, ...]]:
    """Return the fit beside periodic errors that are told further, or held as far as these readings bear them out."""
    if periodic is None or final.problem.readings.made or all(t.effect != wave() for t in final.problem.held):
        return final, None, ()

    def beside(held: tuple[Term, ...]) -> Fit:
        """Return the fit beside other effects that are held, from the machine as it stands with these."""
        problem = dataclasses.replace(final.problem, held=held)
        near = dataclasses.replace(final, machine=problem.solve(final.errors, final.machine))
        return _fine(problem, rule, near, robust)

    if (told := carried.further(final, periodic, beside)) is not None:
        return told.fit, told.told, ()
    held, dropped = carried.borne_out(final.problem, first)
    return (beside(held) if dropped else final), None, dropped


def _left_out(mechanism: Machine, robot: Robot, machine: Robot, names: Sequence[str]) -> dict[str, float]:
    """Return a robot's source errors with those that a model leaves out as another session of the machine has them."""
    if machine.mechanism != robot.mechanism:
        raise OtherMachine(
            f"the diagnosis is of another machine: {machine.mechanism}, where the robot file says {robot.mechanism}.",
            "Give the diagnosis of an earlier session of this machine.",
        )
    known, _ = between(mechanism, robot, machine)
    for name, value in machine.errors.items():
        known[name] = known.get(name, 0.0) + value
    return {n: v for n, v in known.items() if n not in names} | {n: v for n, v in robot.errors.items() if n in names}


def _held_out(final: Fit, rule: Solver, robust: bool) -> tuple[Fit, float]:
    """Return the fit that predicts held-out readings better, and its error: with rows weighed alone, or together.

    What a fit leaves hangs together where noise does, but also where physics was left out, which no weights of rows
    make good: readings decide. A smaller model's hangs together where neighbouring rows are neighbouring poses, and
    where distances share a pose. What points share that were measured once weighs them, whatever it predicts.
    """
    problem, recording = final.problem, final.problem.recording
    whole = set(problem.mechanism.model(problem.mechanism.full_model)) <= set(problem.names)
    shares = problem.readings.rows.shape[1] > 1
    proven = problem.readings.following > 0  # whatever the model
    calm = together(final) if proven or (whole and (shares or problem.readings.kind.positions)) else None
    if calm is None:
        return final, held_out(final, rule, folds(problem.readings, recording))
    near: dict[str, Any] = {"errors": final.errors, "machine": final.machine, "instrument": final.instrument}
    weighed = fit(problem, rule, robust=robust, repeats=calm, must_converge=False, **near)
    parts = folds(problem.readings, recording, rows=calm.rows)
    each = [(at, held_out(at, rule, parts)) for at in ((weighed,) if shares else (final, weighed))]
    return min(each, key=lambda found: found[1])


def _solver(name: str | Solver, truncation: int | str, sigma: float | None) -> Solver:
    if not isinstance(name, str):
        return name
    rules: dict[str, Callable[[], Solver]] = {"prior": Prior, "least-squares": LeastSquares}
    rules |= {"tsvd": partial(TSVD, truncation, sigma), "ridge": Ridge}
    if name not in rules:
        raise UnknownName(f"there is no solver '{name}'; known: {', '.join(rules)}.")
    return rules[name]()
