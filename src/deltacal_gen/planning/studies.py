"""What a measuring plan will give, before anyone measures: Monte Carlo over machines, noise and suspected effects.

A machine of a study has source errors drawn from the robot file's tolerances (an ordinary manufacturing error where
it names none). It is simulated exactly, calibrated by Gauss-Newton whose Jacobian is that of the nominal machine,
factored once for all, and judged over the workspace after the best alignment of the map as a whole: what stays when a
workpiece has been located. Beside the simulated scatter stands what the covariance predicts for the linear problem.
Suspected effects are concealed in recordings of such machines, which the diagnosis then sees as any other recording.
Of readings of joints, which see no source error, nothing but these can be asked.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from threadpoolctl import threadpool_limits

from deltacal_gen.errors import NoConvergence, TooFewReadings
from deltacal_gen.execution import Outcome, Task, Told, content_key, run
from deltacal_gen.files.robot import kept_robot
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.planning.advice import advice, channels_wanted, told_of
from deltacal_gen.planning.machines import Machines, Study, concealed, machines, rms_of
from deltacal_gen.results import study as results
from deltacal_gen.results.base import Json
from deltacal_gen.results.parts import EffectName
from deltacal_gen.results.study import Advice, Histogram, Position, Spread, StudyParameter, Suspect
from deltacal_gen.units import DEG, file_unit, to_internal

_met: dict[str, Study] = {}


def once(study: Study, mark: str) -> Study:
    """Return the study of a fingerprint as this process first met it: what its tasks share is worked out once."""
    if mark not in _met:
        _met.clear()
        _met[mark] = study
    return _met[mark]


def work(study: Study, mark: str, what: str, *numbers: int) -> Json:
    """Do a task of the study of a fingerprint; runs on a worker."""
    own = once(study, mark)
    with threadpool_limits(1, "blas"):  # sums must not depend on the cores of a worker
        return (machines if what == "machines" else concealed)(own, *numbers).to_dict()


def _asked(study: Study, mark: str, job: tuple[Any, ...]) -> tuple[Any, ...]:
    """Return what a worker is handed, which works out the rest itself."""
    return dataclasses.replace(study), mark, *job


def tasks(study: Study, mark: str, trials: int, diagnoses: int) -> list[Task]:
    """Return the tasks of the study of a fingerprint: machines, then each suspicion, nothing concealed first.

    Random numbers belong to the chunk's index or the suspect's trial, not to the worker.
    """
    jobs: list[tuple[Any, ...]] = []
    for index in range(math.ceil(trials / study.chunk)):
        jobs.append(("machines", index, min(study.chunk, trials - index * study.chunk)))
    for suspect in range(-1, len(study.suspects)):
        jobs += [("concealed", suspect, trial) for trial in range(diagnoses)] if len(study.suspects) else []
    return [Task(content_key(mark, job), f"{job[0]} {job[1] + 1}", partial(_asked, study, mark, job)) for job in jobs]


def conduct(
    study: Study,
    trials: int = 1000,
    diagnoses: int = 10,
    *,
    model: str,
    workers: int | None = None,
    cluster: str | None = None,
    directory: str | Path | None = None,
    told: Told = lambda done, total, label: None,
) -> results.Study:
    """Conduct a study; see `execution.run` for workers, cluster and directory.

    Parameters
    ----------
    model : str
        What the study's parameters are called together: ``delta/18``.

    Raises
    ------
    InputError
        The plan carries fewer readings than the calibration has unknowns, or cannot be reached; no scheduler answers.
    NoSolutionError
        A chunk of machines failed.
    """
    with using(Backend.COMPILED):
        joints = study.sees_joints
        unknowns = study.instrument.n_unknown if joints else study.linear.J.shape[1]
        scalars = study.problem.readings.n_scalars
        if scalars < unknowns:
            raise TooFewReadings(
                f"the plan has {scalars} scalar readings for {unknowns} unknowns.",
                "Add poses, or free fewer parameters with --model.",
                file=study.poses.path,
            )
        trials, mark = 0 if joints else trials, study.fingerprint()
        study = once(study, mark)
        todo = tasks(study, mark, trials, diagnoses)
        outcomes = run(work, todo, workers=workers, cluster=cluster, directory=directory, told=told)
        done = [next(outcomes)]
        more = None if joints else advice(study)  # while the workers are at work
        done += outcomes
        chunks = math.ceil(trials / study.chunk)
        names = [tuple(EffectName(name=t.effect, limbs=t.limbs) for t in terms) for terms in study.suspects]
        suspects = told_of(names, done[chunks:], diagnoses)
        return _summed(study, model, [Machines(**_result(o)) for o in done[:chunks]], suspects, more)


def _result(outcome: Outcome) -> Json:
    """Return what became of a chunk of machines."""
    if outcome.result is None:
        raise NoConvergence(f"{outcome.label}: {outcome.error}")
    return outcome.result


def _summed(
    study: Study, model: str, chunks: Sequence[Machines], suspects: tuple[Suspect, ...], more: Advice | None
) -> results.Study:
    problem, count = study.problem, sum(c.count for c in chunks)
    kind = problem.readings.kind
    unit = study.instrument.unit(problem.recording.columns)
    found = results.Study(
        model=model,
        robot=kept_robot(study.robot),
        kind=kind.name,
        readings=problem.readings.n_scalars,
        poses=len(set(problem.recording.pose.tolist())),
        sigma_mm=study.sigma,
        turn_sigma_deg=study.turn_sigma / DEG if kind.rotations else None,
        unit=unit and unit[0],
        unit_mm=unit and unit[1],
        machines=count,
        lost=sum(c.lost for c in chunks),
        seed=study.seed,
        parameters=(),
        position=None,
        suspects=suspects,
        channels_wanted=channels_wanted(study),
        advice=more,
    )
    return found if study.sees_joints else _with_machines(study, found, chunks)


def _with_machines(study: Study, found: results.Study, chunks: Sequence[Machines]) -> results.Study:
    """Return an answer with what became of machines that were calibrated."""
    problem, linear, count = study.problem, study.linear, found.machines
    mechanism, n = problem.mechanism, len(study.names)
    if count == 0:
        raise NoConvergence("no machine of the study could be simulated and calibrated: its errors are too large.")
    mean = np.sum([c.sum for c in chunks], axis=0) / count
    scatter = np.sqrt(np.sum([c.squares for c in chunks], axis=0) / count)
    moments = linear.of_estimate(study.spread, problem.columns)
    stated = np.sqrt(np.diag(linear.covariance)[:n])
    predicted = np.sqrt(np.diag(moments)[problem.columns])
    parameters = []
    for k, name in enumerate(study.names):
        p = mechanism.parameters[mechanism.index[name]]
        factor = to_internal(p.unit)
        parameters.append(
            StudyParameter(
                name=name,
                unit=file_unit(p.unit),
                drawn_std=float(study.spread[mechanism.index[name]] / factor),
                std=float(scatter[k] / factor),
                bias=float(mean[k] / factor),
                predicted_std=float(predicted[k] / factor),
                stated_std=float(stated[k] / factor),
            )
        )
    return found.replace(
        parameters=tuple(parameters),
        position=Position(
            aligned=not study.known_frame,
            points=len(study.check[0]),
            before=_spread([c.before for c in chunks]),
            after=_spread([c.after for c in chunks]).replace(predicted_rms_mm=rms_of(study, linear)),
        ),
    )


def _spread(parts: Sequence[Sequence[Sequence[float]]]) -> Spread:
    """Return root mean square over all machines, and quantiles of the machines' own figures [mm]."""
    rms, worst = np.array([f for part in parts for f in part]).T
    edges = np.geomspace(max(float(rms.min()), 1e-12), max(float(rms.max()), 2e-12), 31)
    return Spread(
        rms_mm=float(np.sqrt(np.mean(rms**2))),
        median_mm=float(np.median(rms)),
        p95_mm=float(np.quantile(rms, 0.95)),
        worst_median_mm=float(np.median(worst)),
        worst_p95_mm=float(np.quantile(worst, 0.95)),
        histogram=Histogram(edges_mm=edges, count=np.histogram(rms, edges)[0]),
    )
