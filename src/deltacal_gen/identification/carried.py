"""What was diagnosed in one session, held in another: only what its own readings bear out there.

An effect is carried with the coefficients that it was found with. Whether the machine still does that, the readings of
the other session say: those that no fit has seen must lie nearer to their prediction with it than without.

The periodic errors of joints are functions of which a session tells as much as it moved the joints. Another one stands
at other angles. What the diagnosis knew of them is then the prior of what these readings tell: near certain where it
read, and as open as before any readings where it did not (Bayes; `identification.orders`).
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from deltacal_gen.errors import InputError, MissingChannel, NoSolutionError
from deltacal_gen.estimation.fit import fit, held_out_errors
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.residuals import lengths, rms
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.identification.folds import folds
from deltacal_gen.identification.functions import Linear, confirmed
from deltacal_gen.identification.orders import ORDERS, all_orders, as_terms, solved, wave
from deltacal_gen.inference.functions import spectrum, waves
from deltacal_gen.machine.places import at
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Robot
from deltacal_gen.physics.terms import Term, load_effect, of_reading, term_of, without_rows
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.parts import Continued, Missing
from deltacal_gen.states import TIME
from deltacal_gen.units import DEG

POSES, SEED = 400, 2021  # on which is judged what holds, drawn at random where there are more
TOLERANCE = 0.1  # of chi2: what a last step of a fit may still gain that judges

EXACT = 1e-6  # of a function's size: surer it is not known, of readings without noise either

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
            raise MissingChannel(f"the effect '{term.effect}' needs {why}.", "Add it.", file=problem.recording.path)
    return tuple(can), tuple(cannot)


def borne_out(
    problem: Problem, first: Fit, *, spared: str | None = None
) -> tuple[tuple[Term, ...], tuple[Missing, ...]]:
    """Return the held effects of a problem that its own readings bear out, and those that they do not.

    Backwards: whatever the held-out readings are nearer to their prediction without is dropped, the worst first; all of
    it, where geometry alone predicts them best.

    Parameters
    ----------
    first : Fit
        A fit of the same machine from which others start.
    spared : str, optional
        An effect that is not dropped: it is judged otherwise.
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
        others = [(part, judged(_without(held, part))) for part in _parts(held) if part[0] != spared]
        if not others:
            break
        part, best = min(others, key=lambda found: _typical(found[1]))
        if _typical(best) >= _typical(now):
            break
        dropped.append(_told(problem.robot, part, now, best))
        held, now = _without(held, part), best
    if held and spared is None and _typical(alone := judged(())) <= _typical(now):
        dropped += [_told(problem.robot, part, now, alone) for part in _parts(held)]
        held = ()
    return held, tuple(dropped)


@dataclass(frozen=True)
class Periodic:
    """What a diagnosis knew of the periodic errors of joints.

    Attributes
    ----------
    errors : dict
        Of each joint (from 1): cosine and sine of each order (2 orders,) [rad].
    rms, std : dict
        Of each joint, over its readings: of the error, and of its standard deviation [rad].
    seen : dict
        Of each joint: between which angles of the turn [rad] it was read.
    corner : float
        Order beyond which coefficients become small.
    """

    errors: dict[int, Array]
    rms: dict[int, float]
    std: dict[int, float]
    seen: dict[int, tuple[tuple[float, float], ...]]
    corner: float

    @classmethod
    def of(cls, found: Diagnosis) -> Periodic | None:
        """Return what a diagnosis knew; None where it has no periodic errors of many orders."""
        effect = next((e for e in found.effects if e.name == wave() and e.orders == (1, ORDERS)), None)
        if effect is None or found.seen is None:
            return None
        told = {(p.name, p.limb): p for p in effect.parameters}
        terms = [term_of(t) for t in found.physics if t.effect == wave()]
        errors = {j: np.zeros((ORDERS, 2)) for j in effect.limbs}
        for term in terms:
            for j, values in zip(term.limbs, term.values, strict=True):
                errors[j][int(term.constants[0]) - 1] = values
        return cls(
            {j: values.ravel() for j, values in errors.items()},
            {j: float(told["rms", j].value) * DEG for j in errors},
            {j: (told["rms", j].std or 0.0) * DEG for j in errors},
            {s.limb: tuple((a * DEG, b * DEG) for a, b in s.angles_deg) for s in found.seen.joints},
            float(told["corner", None].value),
        )

    def roots(self, limbs: Sequence[int]) -> list[Array]:
        """Return of each joint L of the covariance L L' [rad2] of what its coefficients may be beside those found.

        Where it was read they are known as if by readings of the function itself, so many and so sure that what is
        within half a period of the corner has the standard deviation that the diagnosis tells.
        """
        variance = float(np.mean([self.rms[j] ** 2 for j in self.errors]) / spectrum(ORDERS, self.corner).sum())
        step, out = np.pi / ORDERS, []
        for j in limbs:
            angles = np.concatenate([np.arange(a, b + step / 2, step) for a, b in self.seen[j]])
            number = np.pi / self.corner / step
            F = waves(angles, ORDERS) / (max(self.std[j], EXACT * self.rms[j]) * number**0.5)
            precision = F.T @ F + np.diag(1 / np.repeat(variance * spectrum(ORDERS, self.corner), 2))
            out.append(np.linalg.inv(np.linalg.cholesky(precision)).T)
        return out


class Further(NamedTuple):
    """A fit beside periodic errors that its readings told more of, and what that is worth."""

    fit: Fit
    told: Continued


def further(at: Fit, known: Periodic, again: Callable[[tuple[Term, ...]], Fit]) -> Further | None:
    """Return a fit beside periodic errors that its readings tell more of; None where held-out readings do not prove it.

    Parameters
    ----------
    at : Fit
        Beside the errors as the diagnosis has them, or some of them.
    known : Periodic
    again : callable
        Returns the fit beside other effects that are held.
    """
    problem, rows = at.problem, at.problem.readings.rows
    limbs = [j for j in known.errors if any(t.effect == wave() and j in t.limbs for t in problem.held)]
    if not limbs or rows.shape[1] != 1:
        return None
    parts, roots, q = folds(problem.readings, problem.recording), known.roots(limbs), problem.body.q
    linear = Linear(at, parts)
    functions = linear.functions([all_orders(q, j, L) for j, L in zip(limbs, roots, strict=True)])
    found = linear.sized(functions, np.ones(2 * ORDERS * len(limbs)))
    mended = Linear(at, parts, put_back=[(all_orders(q, j), known.errors[j]) for j in limbs])
    errors = linear.held_out(linear.alone), linear.held_out(found), mended.held_out(mended.alone)
    before, after, without = (rms(lengths(e, problem.readings.kind)) for e in errors)
    if not confirmed(problem, *errors[:2]) or after >= without:
        return None
    each, covariance = solved(linear, found, rows[:, 0])
    changes = [L @ own.values for L, own in zip(roots, each, strict=True)]
    held = [t for t in problem.held if t.effect != wave()]
    held += as_terms({j: known.errors[j] + more for j, more in zip(limbs, changes, strict=True)})
    # what is found beside them is as unknown as the orders leave it, their own degrees of freedom counted
    again_at = dataclasses.replace(
        again(tuple(held)),
        covariance=covariance,
        sigma=at.sigma * found.noise**0.5,
    )
    told = Continued(
        limbs=tuple(limbs),
        change_rms_deg={str(j): own.rms / DEG for j, own in zip(limbs, each, strict=True)},
        held_rms_mm=before,
        heldout_rms_mm=after,
    )
    return Further(again_at, told)


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
