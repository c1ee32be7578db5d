"""Machines of a study drawn chunk by chunk, and suspicions concealed in some, on any number of workers."""

from __future__ import annotations

import math
from collections.abc import Callable, Sized
from functools import partial
from pathlib import Path
from typing import Any, Protocol, TypeVar

from threadpoolctl import threadpool_limits

from deltacal_gen.errors import NoSolutionError
from deltacal_gen.execution import Outcome, Task, Told, content_key, run
from deltacal_gen.results.base import Json, Value

T = TypeVar("T")


class Drawing(Protocol):
    """What draws machines; random numbers belong to the chunk's index or the suspect's trial, not to the worker."""

    @property
    def suspects(self) -> Sized:
        """What may be concealed in a machine, one at a time; empty where geometry alone is studied."""

    @property
    def chunk(self) -> int:
        """Machines of a task, whatever the number of workers."""

    def fingerprint(self) -> str:
        """Return a hash of all that the results depend on."""

    def prepare(self) -> None:
        """Work out what all tasks share: processes that are forked afterwards have it."""

    def machines(self, index: int, count: int) -> Value:
        """Draw, measure and calibrate machines."""

    def concealed(self, suspect: int, trial: int) -> Value:
        """Conceal a suspect in a recording and diagnose it; suspect -1 conceals nothing."""


_met: dict[str, Drawing] = {}


def once(study: Drawing, mark: str) -> Drawing:
    """Return the study of a fingerprint as this process first met it: what its tasks share is worked out once."""
    if mark not in _met:
        _met.clear()
        _met[mark] = study
    return _met[mark]


def work(study: Drawing, mark: str, what: str, *numbers: int) -> Json:
    """Do a task of the study of a fingerprint; runs on a worker."""
    own = once(study, mark)
    with threadpool_limits(1, "blas"):  # sums must not depend on the cores of a worker
        return (own.machines if what == "machines" else own.concealed)(*numbers).to_dict()


def _asked(study: Drawing, mark: str, job: tuple[Any, ...]) -> tuple[Any, ...]:
    """Return what a worker is handed."""
    return study, mark, *job


def tasks(study: Drawing, mark: str, trials: int, diagnoses: int) -> list[Task]:
    """Return the tasks of the study of a fingerprint: machines, then each suspicion, nothing concealed first."""
    jobs: list[tuple[Any, ...]] = []
    for index in range(math.ceil(trials / study.chunk)):
        jobs.append(("machines", index, min(study.chunk, trials - index * study.chunk)))
    for suspect in range(-1, len(study.suspects)):
        jobs += [("concealed", suspect, trial) for trial in range(diagnoses)] if len(study.suspects) else []
    return [Task(content_key(mark, job), f"{job[0]} {job[1] + 1}", partial(_asked, study, mark, job)) for job in jobs]


def drawn(
    study: Drawing,
    trials: int,
    diagnoses: int,
    meanwhile: Callable[[], T],
    *,
    workers: int | None,
    cluster: str | None,
    directory: str | Path | None,
    told: Told,
) -> tuple[list[Json], list[Outcome], T]:
    """Return what became of all chunks of machines and of all concealed suspects, and what was done meanwhile.

    Raises
    ------
    NoSolutionError
        A chunk of machines failed.
    """
    mark = study.fingerprint()
    study = once(study, mark)
    study.prepare()
    todo = tasks(study, mark, trials, diagnoses)
    outcomes = run(work, todo, total=len(todo), workers=workers, cluster=cluster, directory=directory, told=told)
    done = [next(outcomes)]
    beside = meanwhile()  # while the workers are at work
    done += outcomes
    chunks = done[: math.ceil(trials / study.chunk)]
    for outcome in chunks:
        if outcome.result is None:
            raise NoSolutionError(f"{outcome.label}: {outcome.error}")
    return [o.result for o in chunks if o.result is not None], done[len(chunks) :], beside
