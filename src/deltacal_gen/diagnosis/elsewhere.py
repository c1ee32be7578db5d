"""A law that another recording told, asked of this one: does it hold here, and of what size.

Its form is known, and so are the constants within it: nothing is searched but the limbs, where the machine is another
one, and coefficients alone are fitted, beside the geometry and all that this recording's own diagnosis names. What it
then earns is charged as an effect's coefficients are, and readings that took no part in the fit are asked.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence

import numpy as np

from deltacal_gen.diagnosis.beside import Beside
from deltacal_gen.diagnosis.charges import MARGIN, charge, gains
from deltacal_gen.diagnosis.diagnosis import Drawn, drawn_beside
from deltacal_gen.diagnosis.laws.proof import Proof, judged, parts
from deltacal_gen.diagnosis.laws.search import Grown
from deltacal_gen.diagnosis.refits import refitted, std_of, terms_of
from deltacal_gen.diagnosis.wandering import following_walks
from deltacal_gen.errors import InputError
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.together import deviance_of, together
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.formula import written
from deltacal_gen.physics.law import PREFIX, is_law, load_law
from deltacal_gen.physics.law import Law as LawModule
from deltacal_gen.physics.terms import Term, blank, term_of
from deltacal_gen.results.batch import AskedOf, of_term
from deltacal_gen.results.diagnosis import Diagnosis, Law, LawCoefficient, LawTerm
from deltacal_gen.states import columns, named
from deltacal_gen.units import of_joints

FAINT = 1e-6  # of what a place moves the readings by, times its state: less than that is none


def asked(
    robot: Robot, recording: Recording, own: Diagnosis, laws: Sequence[Law], elsewhere: Sequence[bool]
) -> list[AskedOf]:
    """Return what readings say of laws that other recordings told.

    Parameters
    ----------
    own : Diagnosis
        Of this recording: what it names stands beside, but for a law that moves the same and reads the same.
    laws : sequence of Law
    elsewhere : sequence of bool
        Whether each was told of another machine, whose limbs may be others.
    """
    if own.seen is not None:
        why = "its joints err at many orders of their angle, beside which no law is told from them"
        return [AskedOf(why=why) for _ in laws]
    try:
        begun = drawn_beside(robot, recording, own.baseline.model)
    except InputError as error:
        return [AskedOf(why=str(error)) for _ in laws]
    return [_asked(begun, own, law, free) for law, free in zip(laws, elsewhere, strict=True)]


def _asked(begun: Drawn, own: Diagnosis, law: Law, elsewhere: bool) -> AskedOf:
    problem = begun.some
    if why := next((w for t in law.terms if (w := _lacking(problem, t, elsewhere))), None):
        return AskedOf(why=why)
    base = _base(begun, own, law)
    choices = list(_choices(problem, law)) if elsewhere else [[_term(problem, t, t.limbs) for t in law.terms]]
    terms = _best(base, choices)
    found = None if terms is None else refitted(problem, base, [*terms_of(base), *terms])
    said = None if terms is None or found is None else _proof(problem, base, terms)
    if terms is None or found is None or said is None:
        return AskedOf(why="its readings leave the law open beside the geometry, or are too few")
    proof, borne = said
    gain = deviance_of(base) - deviance_of(found)
    price = sum(charge(t, len(choices)) for t in terms) + MARGIN
    return AskedOf(
        holds=gain > price and borne and not _by_walks(found, len(terms), price),
        limbs=tuple(dict.fromkeys(i for t in terms for i in t.limbs)),
        coefficients=tuple(_coefficients(found, len(terms))),
        gain=gain,
        charge=price,
        heldout_rms_mm=proof.rms,
        without_rms_mm=proof.without,
    )


def _lacking(problem: Problem, term: LawTerm, elsewhere: bool) -> str | None:
    """Return why a term of a law cannot be asked of a recording, in words; None where it can."""
    module, kind, limbs = _module(term), problem.readings.kind, problem.mechanism.limbs
    if why := problem.body.foreign(module.NAME):
        return f"the law is of {why}"
    if module.ACTS_ON == "reading" and module.TARGETS[0] not in kind.targets:
        return f"readings of the kind {kind.name} have no {module.TARGETS[0]}"
    if kind.sees_joints and module.TARGETS[0] != "joint":
        return f"readings of the kind {kind.name} see joints alone"
    numbers = [*(() if elsewhere else term.limbs), *(named(s).joint for s in module.STATE)]
    if max(numbers, default=0) > limbs:
        return f"this machine has {limbs} limbs"
    if why := problem.body.missing(module.NAME):
        return f"there is not {why}"
    units = of_joints(problem.recording.joint_unit, limbs)
    if all(_units(module, unit) != _said(term) for unit in set(units)):
        return "its joints slide where those of the law turn, or turn where those slide"
    values, recorded = _states(problem, module), problem.recording.channels
    for name in module.STATE:
        v = values[name]
        if not np.isfinite(v).all():
            return f"{name} is not known at every reading"
        if not np.ptp(v, axis=0).max() > 0:
            absent = [c for c in columns([named(name)], problem.recording.joint_unit, limbs) if c not in recorded]
            return f"{name} is the same at all readings" + (f": there is no column {', '.join(absent)}" * bool(absent))
    return None


def _base(begun: Drawn, own: Diagnosis, law: Law) -> Fit:
    """Return the fit of geometry and of what a recording's own diagnosis names, in the noise that suits it."""
    kept = [term_of(t) for t in own.physics]
    kept = [t for t in kept if not (is_law(t.effect) and _same(t, law))]
    found = refitted(begun.some, begun.first, kept) or begun.first
    calm = together(found)
    if calm is None:
        return found
    return refitted(begun.some, dataclasses.replace(found, repeats=calm), terms_of(found)) or found


def _same(term: Term, law: Law) -> bool:
    """Tell whether a law of its own, or what its form leaves of a state, moves and reads what another law does."""
    module = load_law(term.effect)
    others = map(_module, law.terms)
    return any(module.TARGETS == o.TARGETS and set(module.STATE) <= set(o.STATE) for o in others)


def _module(term: LawTerm) -> LawModule:
    return load_law(f"{PREFIX}{term.target} = {term.expression}")


def _said(term: LawTerm) -> dict[str, str]:
    """Return the units of a law's coefficients and constants, as it was told."""
    return {c.name: c.unit for c in term.coefficients}


def _units(module: LawModule, joint_unit: str) -> dict[str, str]:
    """Return the units of the same on joints in rad or mm."""
    units = module.units(joint_unit)
    return {name: written(units[name]) for name in (*module.formula.linear, *module.inner)}


def _states(problem: Problem, module: LawModule) -> dict[str, Array]:
    """Return what a law reads at the readings, (N, limbs) of each limb's own, (N,) of all else, by name."""
    machine, _ = problem.body.solve(np.zeros(len(problem.mechanism.parameters)), ())
    found = problem.body.state(list(module.STATE), machine.x, machine.q, machine.rows)
    return {name: found[name][problem.readings.used] for name in module.STATE}


def _term(problem: Problem, term: LawTerm, limbs: Sequence[int]) -> Term:
    """Return a term of a law as a fit takes it, its constants as they were told, its ends those of these readings."""
    module = _module(term)
    known = {c.name: c.value for c in term.coefficients}
    values, own, ends = _states(problem, module), [i - 1 for i in limbs], list[float]()
    for name in module.STATE:
        v = values[name]
        v = v[:, own] if v.ndim == 2 and own else v
        ends += [float(np.nanmin(v)), float(np.nanmax(v))]
    return blank(module.NAME, limbs, (*(known[name] for name in module.inner), *ends))


def _choices(problem: Problem, law: Law) -> Iterator[list[Term]]:
    """Yield a law on each limb of another machine, and on all; whole, where it is of no limb."""
    every = tuple(range(1, problem.mechanism.limbs + 1))
    if not any(_module(t).PER_LIMB for t in law.terms):
        every = every[:1]
    for limbs in dict.fromkeys([*((i,) for i in every), every]):
        if not any(named(s).joint in limbs for t in law.terms for s in _module(t).STATE if named(s).joint):
            yield [_term(problem, t, limbs) for t in law.terms]


def _best(base: Fit, choices: Sequence[list[Term]]) -> list[Term] | None:
    """Return the choice of limbs that earns most beyond its charge; None where no reading sees any of them."""
    beside, problem, best, most = Beside(base), base.problem, None, -np.inf
    for terms in choices:
        moved = problem.term_columns(terms, base.errors, base.instrument, beside.machine)
        C = beside.rows(np.where(np.isfinite(moved), moved, 0.0))
        size = np.linalg.norm(C, axis=0)
        C = C / np.where(size > 0, size, 1.0)
        inside = beside.Q.T @ C
        G = C.T @ C - inside.T @ inside
        if not (np.diag(G) > FAINT).any():
            continue
        worth = float(gains(G[None], (C.T @ beside.residual)[None])[0]) - sum(charge(t, 1) for t in terms)
        if worth > most:
            best, most = terms, worth
    return best


def _proof(problem: Problem, base: Fit, terms: Sequence[Term]) -> tuple[Proof, bool] | None:
    """Return what readings that took no part in the fit of a law's coefficients say of it, and whether they bear it.

    Others may leave much that is none of its doing, so that it need not take what it had to take where it was found;
    but for a law of time, for which a walk may speak.
    """
    beside, states = terms_of(base), {s.name for t in terms for s in t.states}
    train, test, walks = parts(problem, states, any(t.kernels.MEMORY for t in terms))
    if train.sum() < 3 or test.sum() < 3:
        return None
    part = problem.subset(np.flatnonzero(train))
    without = refitted(part, base, beside)
    found = None if without is None else refitted(part, without, [*beside, *terms])
    if without is None or found is None:
        return None
    proof = judged(problem, (without, without), Grown(found, (), (), 0.0), train, test)
    return proof, proof.holds if walks else proof.nearer


def _by_walks(at: Fit, count: int, price: float) -> bool:
    """Tell whether joints, or an instrument, that wander explain as much as a law, the last terms of a fit."""
    n = len(terms_of(at))
    return bool(following_walks(at, dict.fromkeys(range(n - count, n), price / count))[0])


def _coefficients(at: Fit, count: int) -> Iterator[LawCoefficient]:
    """Yield the coefficients of the last terms of a fit, a law."""
    terms = terms_of(at)
    for i in range(len(terms) - count, len(terms)):
        term, std = terms[i], std_of(at, i).reshape(terms[i].values.shape)
        module = load_law(term.effect)
        for r, row in enumerate(term.values):
            limb = term.limbs[r] if term.limbs else None
            units = module.units(of_joints(at.problem.recording.joint_unit, limb or 1)[(limb or 1) - 1])
            for name, value, unsure in zip(module.formula.linear, row, std[r], strict=True):
                own = of_term(name, i - len(terms) + count)
                yield LawCoefficient(
                    name=own, limb=limb, value=float(value), std=float(unsure), unit=written(units[name])
                )
