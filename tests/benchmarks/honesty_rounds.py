"""What one round of the proposed readings makes of recordings whose misfit several effects explain.

Beside it stands the best design: the fewest readings of the whole workspace that an exchange search finds which knows
the truth, and refits geometry, instrument and each rival. What no number of them tells apart no poses can. Random ones
are counted by the same engine, until they part as much.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from deltacal_gen.diagnosis.answer import Diagnosed
from deltacal_gen.diagnosis.designs import Duel, choose, least_misfit, take
from deltacal_gen.diagnosis.diagnosis import _first, _geometry, diagnose
from deltacal_gen.diagnosis.discrimination import CLEAR, SEED, Pool
from deltacal_gen.diagnosis.refits import refitted
from deltacal_gen.estimation.fit import CONVERGED
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.files.checks import set_aside
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.terms import Term, load_effect
from deltacal_gen.use.experiments import next_rows, open_questions, shared
from tests.benchmarks.honesty_starts import SORTS, Start, start

__all__ = ["SORTS", "round_of"]
MOST = 100  # readings of the best design, beyond which poses do not tell effects apart
DRAWN = 5  # times that random readings are drawn


def round_of(sort: str, k: int) -> dict[str, Any]:
    """Return what a diagnosis of the k-th recording of a sort says, and what it says after one round of proposals.

    `open` says that it was ambiguous, `answered` that poses are proposed for every rival, `resolvable` that the best
    design tells them apart, or the round did. Readings are counted that are proposed against rivals, those for all
    questions, those of the best design, and random ones.
    """
    begun, effect = start(sort, k), SORTS[sort][1]
    first = diagnose(begun.robot, begun.first)
    found = first.answer()
    entries = [e for e in found.next_measurements if e.separates and _rivals(e.separates)]
    out: dict[str, Any] = {
        "open": any(_rivals((e.name, *e.indistinguishable_from)) for e in found.effects),
        "truth in the set": any(effect in (e.name, *e.indistinguishable_from) for e in found.effects),
        "answered": bool(entries) and all(e.poses for e in entries),
    }
    if not out["open"]:
        return out
    rivals = _wrong(first, effect)
    of = best(begun, rivals) if rivals else None
    out |= {"resolvable": of is not None}
    questions = open_questions(found)
    if not questions:
        return out
    rows = next_rows(questions, shared(questions, None))
    extended = begun.extended(rows)
    after = diagnose(begun.robot, extended).answer()
    names = [e.name for e in after.effects]
    alone = names == [effect] and not _rivals((effect, *after.effects[0].indistinguishable_from))
    wrong = bool(names) and not any(effect in (e.name, *e.indistinguishable_from) for e in after.effects)
    asked = [q for q, e in zip(questions, (e for e in found.next_measurements if e.poses), strict=True) if e in entries]
    out |= {"alone after a round": alone, "wrong after a round": wrong, "resolvable": alone or of is not None}
    out |= {"rows": len(shared(asked, None).rows), "rows in all": len(rows)}
    if out["resolvable"]:
        out["alone after a round, of those that can be resolved"] = alone
    if of is not None and asked:
        out |= {"best": of.best, "random": of.random, "chi2": parted(begun, extended, rivals)}
    return out


def _rivals(names: Sequence[str]) -> bool:
    """Tell whether one of several effects is another than the first: what becomes it in a limit none can refute."""
    return any(names[0] != load_effect(name).EXTENDS for name in names[1:])


def _wrong(found: Diagnosed, effect: str) -> list[Term]:
    """Return the forms that a diagnosis could not tell from the truth, or took for it."""
    sets = [(n.term, *n.rivals) for n in found.effects]
    own = next((terms for terms in sets if any(t.effect == effect for t in terms)), ())
    return [t for t in own if t.effect != effect and effect != load_effect(t.effect).EXTENDS]


# ------------------------------------------------------------------------------------------------- who knows the truth


class Designs(NamedTuple):
    """Readings that tell the truth from all rivals: of the best design, and of random ones in the mean."""

    best: int
    random: float


def best(begun: Start, rivals: Sequence[Term]) -> Designs | None:
    """Return how many readings who knows the truth takes to part it from its rivals, and how many random ones do.

    None where no poses part them.
    """
    at = _known(begun, begun.first)
    pool = Pool(at, [begun.term, *rivals], np.random.default_rng(SEED))
    if not len(pool.found.ends):
        return None

    def duels() -> list[Duel]:
        spread = pool._spread(begun.term)
        return [duel for rival in rivals for duel in pool.against(rival, begun.term, spread, [])]

    chosen = choose(duels(), 1, MOST, CLEAR)
    if chosen.gained[chosen.needed - 1] < CLEAR:
        return None
    counts = [_until_clear(duels(), np.random.default_rng([begun.k, n])) for n in range(DRAWN)]
    return Designs(chosen.needed, float(np.mean(counts)))


def _until_clear(duels: Sequence[Duel], rng: np.random.Generator) -> int:
    """Return after how many random readings the truth is parted from all rivals; all of them where it never is."""
    before, count = least_misfit(duels), len(duels[0])
    for n, j in enumerate(rng.permutation(count), start=1):
        take(duels, int(j))
        if least_misfit(duels) >= before + CLEAR:
            return n
    return count


def parted(begun: Start, extended: Recording, rivals: Sequence[Term]) -> float:
    """Return by how much chi2 the truth outdoes its best rival in what was measured, all refitted."""
    true = _known(begun, extended)
    others = [refitted(true.problem.with_names(true.problem.names), true, [rival], tolerance=1e-2) for rival in rivals]
    return min((_chi2(other, true) for other in others if other), default=np.inf) - _chi2(true, true)


def _chi2(at: Fit, unit: Fit) -> float:
    """Return what a fit leaves, in units of the noise of one."""
    return float(np.nansum((at.residual / unit.sigma) ** 2))


def _known(begun: Start, recording: Recording) -> Fit:
    """Return the fit of geometry, instrument and the effect that is there."""
    recording = set_aside(recording, begun.robot)
    problem = _geometry(begun.robot, recording, None)[0]
    first = _first(problem)
    return refitted(problem, first, [begun.term], tolerance=CONVERGED) or first
