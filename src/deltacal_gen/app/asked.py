"""Laws of a batch: what the diagnosis of one recording tells is asked of all others, and where it holds is told.

Of laws that move the same and read the same, found in several recordings, the one that earns most is asked.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from deltacal_gen.app.commands.common import as_recording, as_robot
from deltacal_gen.app.tasks import RECORDING, ROBOT, Contents, laid_out
from deltacal_gen.execution import Task, content_key, run
from deltacal_gen.physics.law import PREFIX, load_law
from deltacal_gen.results.base import Json
from deltacal_gen.results.batch import AskedLaw, AskedOf, CommonLaw, DiagnosedRow, of_term, sizes
from deltacal_gen.results.diagnosis import Diagnosis, Law, LawCoefficient, LawTerm
from deltacal_gen.results.reader import read_answer, read_part


@dataclass(frozen=True)
class Done:
    """A recording that was diagnosed.

    Attributes
    ----------
    row : DiagnosedRow
    contents : callable
        Returns its files.
    key : str
        Of its diagnosis.
    answer : callable
        Returns the JSON of its diagnosis; None where that is gone.
    """

    row: DiagnosedRow
    contents: Callable[[], Contents]
    key: str
    answer: Callable[[], Json | None]


@dataclass(frozen=True)
class _Told:
    """A law with the recordings that told one of its place and states, and the one whose it is."""

    of: DiagnosedRow
    law: Law
    recordings: tuple[str, ...]


def place_of(term: LawTerm) -> str:
    """Return what a term of a law moves and what it reads, whatever its shape: ``joint(oil_C, payload)``."""
    states = sorted(load_law(f"{PREFIX}{term.target} = {term.expression}").STATE)
    return f"{term.target}({', '.join(states)})"


def in_all(done: Sequence[Done], where: Mapping[str, Any]) -> dict[str, CommonLaw]:
    """Return what all recordings say of each law that the diagnosis of one tells, by its place and states.

    `where` is what `execution.run` takes.
    """
    told = _told(done)
    if not told or len(done) < 2:
        return {}
    tasks = [_of(d, told) for d in done]
    outcomes = run(ask, (t for t in tasks if t is not None), total=sum(t is not None for t in tasks), **where)
    said: dict[str, list[AskedLaw]] = {name: [] for name in told}
    for d, task in zip(done, tasks, strict=True):
        outcome = next(outcomes) if task is not None else None
        answers = iter([] if outcome is None or outcome.result is None else outcome.result["asked"])
        for name, t in told.items():
            if t.of.recording == d.row.recording:
                found = _own(t.law)
            else:
                why = None if outcome is None else outcome.error
                found = AskedOf(why=why) if why is not None else read_part(AskedOf, next(answers))
            said[name].append(AskedLaw(recording=d.row.recording, machine=d.row.machine, **dict(found.written())))
    return {
        name: CommonLaw(
            law=name, recordings=t.recordings, terms=t.law.terms, asked=tuple(said[name]), sizes=sizes(said[name])
        )
        for name, t in told.items()
    }


def ask(files: Contents, own: Json, laws: Sequence[Json], elsewhere: Sequence[bool]) -> Json:
    """Ask laws of a recording; runs on a worker."""
    from deltacal_gen.diagnosis.elsewhere import asked

    diagnosis = read_answer(own)
    assert isinstance(diagnosis, Diagnosis)
    with laid_out(files) as folder:
        robot = as_robot(folder / ROBOT)
        recording = as_recording(folder / RECORDING, robot)
        found = asked(robot, recording, diagnosis, [read_part(Law, law) for law in laws], elsewhere)
    return {"asked": [a.to_dict() for a in found]}


def _told(done: Sequence[Done]) -> dict[str, _Told]:
    """Return the laws that are asked, by their place and states."""
    out: dict[str, _Told] = {}
    for d in done:
        answer = d.answer() if d.row.law is not None else None
        found = None if answer is None else read_answer(answer)
        if d.row.law is None or not isinstance(found, Diagnosis) or not found.laws:
            continue
        before, law = out.get(d.row.law), found.laws[0].replace(curve=None, curves=(), runners_up=())
        names = (*(() if before is None else before.recordings), d.row.recording)
        best = before if before is not None and before.law.gain >= law.gain else _Told(d.row, law, ())
        out[d.row.law] = _Told(best.of, best.law, names)
    return out


def _of(done: Done, told: Mapping[str, _Told]) -> Task | None:
    """Return the task of asking a recording the laws of others; None where there are none."""
    others = [t for t in told.values() if t.of.recording != done.row.recording]
    if not others:
        return None
    laws, elsewhere = [t.law.to_dict() for t in others], [t.of.machine != done.row.machine for t in others]

    def arguments() -> tuple[Any, ...]:
        return done.contents(), done.answer(), laws, elsewhere

    return Task(content_key("laws", done.key, laws, elsewhere), done.row.recording, arguments)


def _own(law: Law) -> AskedOf:
    """Return what the recording says that told the law."""
    return AskedOf(
        holds=True,
        limbs=tuple(dict.fromkeys(i for t in law.terms for i in t.limbs)),
        coefficients=tuple(c for k, t in enumerate(law.terms) for c in _fitted(t, k)),
        gain=law.gain,
        charge=law.charge,
        heldout_rms_mm=law.heldout_rms_mm,
    )


def _fitted(term: LawTerm, k: int) -> Iterator[LawCoefficient]:
    """Yield the coefficients of a law's term, without the constants within it."""
    linear = load_law(f"{PREFIX}{term.target} = {term.expression}").formula.linear
    yield from (c.replace(name=of_term(c.name, k)) for c in term.coefficients if c.name in linear)
