"""What was diagnosed in one session, held in another: only what its own readings bear out there.

An effect is carried with the coefficients that it was found with. Whether the machine still does that, the readings of
the other session say: those that no fit has seen must lie nearer to their prediction with it than without.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np

from deltacal_gen.errors import InputError, NoSolutionError
from deltacal_gen.estimation.fit import fit, held_out_errors
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import lengths
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.identification.folds import folds
from deltacal_gen.machine.places import at
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Robot
from deltacal_gen.physics.terms import Term, load_effect, of_reading, without_rows
from deltacal_gen.results.parts import Missing
from deltacal_gen.states import TIME

POSES, SEED = 400, 2021  # on which is judged what holds, drawn at random where there are more
TOLERANCE = 0.1  # of chi2: what a last step of a fit may still gain that judges

Part = tuple[str, int | None]  # an effect, and of a periodic one the joint: its orders stand and fall together


def usable(problem: Problem, held: Sequence[Term]) -> tuple[tuple[Term, ...], tuple[Missing, ...]]:
    """Return the effects that a recording can hold, and those of another session that it cannot, with what is missing.

    What the instrument did, or what went with the time of a session, is not the machine's.

    Raises
    ------
    InputError
        An effect of the machine needs a channel that is not there.
    """
    can, cannot = [], []
    for term in held:
        why = problem.body.missing(term.effect)
        if of_reading([term]) and term.kernels.AFTERWARDS and not term.happens:
            cannot.append(Missing(name=term.effect, missing="that session: it happened once, and is past"))
        elif why is None:
            can.append(term)
        elif of_reading([term]) or any(s.column == TIME for s in term.states):
            cannot.append(Missing(name=term.effect, missing=why))
        else:
            raise InputError(f"the effect '{term.effect}' needs {why}.", "Add it.", file=problem.recording.path)
    return tuple(can), tuple(cannot)


def borne_out(problem: Problem, first: Fit) -> tuple[tuple[Term, ...], tuple[Missing, ...]]:
    """Return the held effects of a problem that its own readings bear out, and those that they do not.

    Backwards: whatever the held-out readings are nearer to their prediction without is dropped, the worst first; all of
    it, where geometry alone predicts them best.

    Parameters
    ----------
    first : Fit
        A fit of the same machine from which others start.
    """
    some = problem.some(POSES, np.random.default_rng(SEED))
    parts = folds(some.readings, some.recording)

    def judged(held: tuple[Term, ...]) -> Array:
        """Return the squares (R,) of held-out errors [mm2]; inf where there is no fit."""
        try:
            found = fit(
                dataclasses.replace(some, held=held),
                Prior(),
                errors=first.errors,
                drop_gross=False,
                must_converge=False,
                tolerance=TOLERANCE,
            )
        except (InputError, NoSolutionError):
            return np.full(len(some.readings), np.inf)
        errors = lengths(held_out_errors(found, Prior(), parts), some.readings.kind)
        return np.nansum(errors**2, axis=1)

    held, dropped = tuple(problem.held), []
    now = judged(held)
    while held:
        others = [(part, judged(_without(held, part))) for part in _parts(held)]
        part, best = min(others, key=lambda found: _typical(found[1]))
        if _typical(best) >= _typical(now):
            break
        dropped.append(_told(problem.robot, part, now, best))
        held, now = _without(held, part), best
    if held and _typical(alone := judged(())) <= _typical(now):
        dropped += [_told(problem.robot, part, now, alone) for part in _parts(held)]
        held = ()
    return held, tuple(dropped)


def _typical(squares: Array) -> float:
    """Return the mean of squares that no gross error outweighs."""
    bound = 9 * float(np.median(squares)) + 1e-300
    return float(np.mean(np.minimum(squares, bound)))


def _parts(held: Sequence[Term]) -> list[Part]:
    """Return what may be dropped for itself: an effect; of periodic ones, all orders of a joint."""
    found: dict[Part, None] = {}
    for term in held:
        for limb in term.limbs if load_effect(term.effect).PERIODIC else (None,):
            found[term.effect, limb] = None
    return list(found)


def _without(held: Sequence[Term], part: Part) -> tuple[Term, ...]:
    name, limb = part
    out = []
    for term in held:
        if term.effect != name:
            out.append(term)
        elif limb is not None:
            less = without_rows(term, [i for i, own in enumerate(term.limbs) if own == limb])
            out += [] if less is None else [less]
    return tuple(out)


def _told(robot: Robot, part: Part, with_it: Array, without: Array) -> Missing:
    name, limb = part
    where = "" if limb is None else at(robot, [limb])
    before, after = (float(np.sqrt(_typical(squares) / 3)) for squares in (with_it, without))
    return Missing(
        name=name,
        missing=f"readings that bear it out here{where}: held-out ones lie {before:.3g} mm off with it, {after:.3g} mm "
        "without",
    )
