"""The search for what was left out: forwards by what earns most, backwards by what does not hold, noise as a rival."""

from __future__ import annotations

import dataclasses
import itertools
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.diagnosis.charges import AS_GOOD, MARGIN, carriers_of, several
from deltacal_gen.diagnosis.evidence import evidence
from deltacal_gen.diagnosis.refits import COMPARED, form, kind, place, refitted, std_of, terms_of
from deltacal_gen.diagnosis.scattering import scattering
from deltacal_gen.diagnosis.search import Found, Search
from deltacal_gen.diagnosis.spectrum import Spectrum, periodic
from deltacal_gen.diagnosis.structure import Structure, alike, smooth_columns, structures
from deltacal_gen.estimation.fit import held_out, held_out_errors
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.identification.folds import folds
from deltacal_gen.identification.noise import lack_of_fit, merely_more
from deltacal_gen.identification.orders import wave
from deltacal_gen.identification.together import PRICE, deviance_of, together
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.terms import (
    Term,
    beyond,
    load_effect,
    on_limbs,
    without_rows,
)
from deltacal_gen.states import read_by

MOST_EFFECTS = 8  # that are searched: more were never told apart
MOST_WAVES = 3  # single orders among them: what shows at more is one error of many orders
REVISIONS = 4
FEW = 3  # effects, of which two may have been taken for two others: more of them follow what nothing explains
RIVALS = 4  # effects of which each may be the first of two in the place of two others
NEAR = 20.0  # of chi2: two that explain so much less in the linear machine may explain more in the exact one
GIVEN_UP = 2  # times, after which an effect is taken up no more
TURNS, SETTLED = 4, 0.5  # in which orders and what is beside them settle; standard deviations that are as good as none
MUCH_WORSE = 1.02  # times the noise: another form that fits so much worse in the exact machine is not taken
HARDLY_ALIKE = 2.5  # likewise, from which it may be none
SOLVED_TO = 1e-8  # mm, rad: what is left of readings without noise is how far poses are solved, and no physics
ALIKE = 4.0  # standard deviations by which what is left must correlate between neighbouring poses to be no noise
BORNE_OUT = 2.0  # standard deviations by which held-out readings must speak for what is named
Progress = Callable[[str], None]


@dataclass(frozen=True)
class Outcome:
    """What a search has found: the fit with all effects that hold, what it leaves, and what it was judged by.

    Attributes
    ----------
    first : Fit
        Of geometry and instrument alone.
    left : list of Structure
        What is left, the strongest first.
    parts : list of (train, test)
        Masks of readings, held out in turn.
    without, predicted : (R, k) array
        Errors of held-out readings [mm, rad] by geometry alone, and with what `tested` had found.
    wandering : tuple of int
        Joints, from 1, and 0 for the instrument, that go as chance has it where effects of time were found at first.
    """

    problem: Problem
    first: Fit
    search: Search
    considered: list[Found]
    left: list[Structure]
    spectrum: Spectrum | None
    unexplained: bool
    parts: list[tuple[np.ndarray, np.ndarray]]
    tested: Fit
    without: Array
    predicted: Array
    wandering: tuple[int, ...] = ()


def searched(some: Problem, first: Fit, terms: Sequence[Term], lean: bool, progress: Progress) -> Outcome:
    """Search for what was left out, beside a fit of geometry and instrument."""
    parts = folds(some.readings, some.recording, rows=first.repeats.rows)
    search, considered = _chosen(some, Search(first, terms), progress)
    if (fewer := _with_fewer_waves(some, search)) is not search:
        search = _chosen(some, fewer, progress)[0]
    if 1 < len(search.grouped(terms_of(search.fit))) <= FEW and _unexplained(search, structures(search.fit), lean):
        exchanged = _exchanged(some, search)
        search = search if exchanged is search else _chosen(some, exchanged, progress)[0]
    progress("held-out error")
    without, tested = held_out_errors(first, Prior(), parts), search.fit
    predicted = held_out_by(some, search, parts) if search.effects else without
    if search.effects and not _speak_for(search, first, without, predicted, parts):
        search = Search(first, terms)
    progress("what is left")
    search, left = _without_gross(some, search)

    spectrum = None
    if unexplained := _unexplained(search, left, lean):
        progress("periodic errors of many orders")
        spectrum = _spectrum(some, search, parts)
    if spectrum is not None:
        some, search, spectrum, considered = _beside_orders(some, search, spectrum, parts, progress)
        search, left = _without_gross(some, search)
        unexplained = _unexplained(search, left, lean)
    rest = smooth_columns(search.fit, left[0].channel) if left[0].earned > MARGIN else None
    if search.effects and (rest is not None or scattering(search.fit)):
        proven = _proven(some, search, rest)
        if proven is not search:
            search, left = proven, structures(proven.fit)
            unexplained = _unexplained(search, left, lean)
    return Outcome(some, first, search, considered, left, spectrum, unexplained, parts, tested, without, predicted)


def _speak_for(
    search: Search, first: Fit, without: Array, predicted: Array, parts: Sequence[tuple[np.ndarray, np.ndarray]]
) -> bool:
    """Tell whether held-out readings bear out what was found, and are not farther off where others choose for them.

    Effects that other readings would not have chosen, or in sizes that spoil the prediction, hold for their own alone.
    """
    found = evidence(first, without, held_out_errors(search.fit, Prior(), parts))
    return found.speaks and not evidence(first, without, predicted).falls_short


def _unexplained(search: Search, left: Sequence[Structure], lean: bool) -> bool:
    """Tell whether more is left than noise: by its size, along a channel, a place, a joint, or alike in neighbours."""
    if lean:
        return False
    at, recording = search.fit, search.fit.problem.recording
    if float(np.nanmax(np.abs(at.residual))) < SOLVED_TO:
        return False
    if any(s.earned > MARGIN for s in left) or alike(at)[1] > ALIKE or scattering(at):
        return True
    return lack_of_fit(at, recording) and not (merely_more(at, recording) and _structureless(search, left))


def _structureless(search: Search, left: Sequence[Structure]) -> bool:
    """Tell whether nothing that was recorded, no neighbour and no effect explains more of what is left than chance.

    Then a declared noise that is less than it is wrong: no physics is left to be sought.
    """
    calm = alike(search.fit)[1] < HARDLY_ALIKE and all(s.earned <= 0 for s in left)
    return calm and all(f.score <= 0 for f in search.ranked())


def beside_noise(found: Outcome, lean: bool) -> Outcome:
    """Return what of the effects found holds beside noise that hangs together as what they leave does.

    Noise that wanders leaves readings anywhere, and what they then leave wanders farther: it is less likely, and stops.
    In such noise effects may grow without end against one another: with them others are predicted worse than without.
    """
    at = found.search.fit
    if (calm := together(at)) is None:
        return found
    kept = refitted(found.problem, dataclasses.replace(at, repeats=calm), terms_of(at))
    if kept is None or (not at.repeats.plain and deviance_of(kept) > deviance_of(at)):
        return found
    if at.problem.readings.rows.shape[1] > 1:  # points that distances share are held out together
        parts = folds(at.problem.readings, at.problem.recording, rows=calm.rows)
        found = dataclasses.replace(found, parts=parts, without=held_out_errors(found.first, Prior(), parts))
    search = _proven(found.problem, Search(kept, found.search.terms))
    predicted = held_out_by(found.problem, search, found.parts) if search.effects else found.without
    if search.effects and evidence(found.first, found.without, predicted).denies:
        search = Search(found.first, found.search.terms)
    left = structures(search.fit)
    unexplained = _unexplained(search, left, lean)
    return dataclasses.replace(
        found, search=search, left=left, unexplained=unexplained, tested=search.fit, predicted=predicted
    )


def deviance(found: Outcome) -> float:
    """Return twice the negative logarithm of the likelihood of what was found, with its price; see `deviance_of`.

    An instrument that wanders moves readings as effects without limbs do: those pay as much more as such noise does.
    """
    terms = terms_of(found.search.fit)
    price = sum(found.search.price(*(terms[i] for i in own)) + MARGIN for own in found.search.grouped(terms))
    price += PRICE * any(not t.limbs for t in terms)
    of_spectrum = 0.0 if found.spectrum is None else 2 * len(found.spectrum.limbs) * found.spectrum.corner + MARGIN
    return deviance_of(found.search.fit) + price + of_spectrum


def _spectrum(problem: Problem, search: Search, parts: Sequence[tuple[np.ndarray, np.ndarray]]) -> Spectrum | None:
    """Return periodic errors of many orders where they predict readings better than the few that were found."""
    beside = refitted(problem, search.fit, _beside_waves(search))
    found = None if beside is None else periodic(beside, parts)
    if found is None or found.heldout[1] >= held_out(search.fit, Prior(), parts):
        return None
    return found


def _beside_orders(
    some: Problem,
    search: Search,
    spectrum: Spectrum,
    parts: Sequence[tuple[np.ndarray, np.ndarray]],
    progress: Progress,
) -> tuple[Problem, Search, Spectrum, list[Found]]:
    """Search beside many orders, and estimate these beside what is found, in turn, until both stay."""
    terms = [t for t in search.terms if t.effect != wave()]
    considered: list[Found] = []
    at, effects = search.fit, _beside_waves(search)
    for _ in range(REVISIONS):
        beside = refitted(spectrum.held_in(some), at, effects)
        if beside is None:
            break
        beside, spectrum = settled(some, beside, spectrum, parts)
        some = spectrum.held_in(some)
        before = {form(t) for t in terms_of(beside)}
        search, ranked = _chosen(some, _revised(some, Search(beside, terms)), progress)
        considered = considered or ranked
        at, effects = search.fit, terms_of(search.fit)
        if {form(t) for t in effects} == before:
            break
    return some, search, spectrum, considered


def settled(
    problem: Problem,
    at: Fit,
    spectrum: Spectrum,
    parts: Sequence[tuple[np.ndarray, np.ndarray]],
) -> tuple[Fit, Spectrum]:
    """Return a fit and the orders that are held in it, each as it is beside the other.

    Orders and all that is fitted beside them are estimated jointly in the machine made linear; that is repeated in the
    exact one until nothing moves by much of what it is uncertain by.
    """
    for _ in range(TURNS):
        again = periodic(at, parts, spectrum)
        if again is None:
            break
        new = refitted(again.held_in(problem), at, terms_of(at))
        if new is None:
            break
        own = at.problem.columns
        std = np.sqrt(np.maximum(np.diag(again.covariance)[: len(own)], 1e-300))
        moved = float(np.abs((new.errors[own] - at.errors[own]) / std).max())
        at, spectrum = new, again
        if moved < SETTLED:
            break
    return at, spectrum


def _beside_waves(search: Search) -> list[Term]:
    """Return the effects found that are no waves, simple ones for those that extend them.

    Whether the flexible ones are needed is seen in what many orders leave.
    """
    found = [t for t in terms_of(search.fit) if t.effect != wave()]
    blanks = {t.effect: t for t in search.terms if all(t.effect != other.effect for other in found)}
    simple = (blanks.get(t.kernels.EXTENDS) for t in found)
    return [t if s is None else on_limbs(s, t.limbs) for t, s in zip(found, simple, strict=True)]


def _chosen(problem: Problem, search: Search, progress: Progress) -> tuple[Search, list[Found]]:
    """Return the fit with every effect that earns its price, and the best form of each effect at the first look.

    Forwards: the effect that earns most is fitted jointly with all before. After each, every effect is looked at again
    with the others beside it: another form, another effect or none may now be better. What was given up `GIVEN_UP`
    times is left: what stands for it and it itself would take turns.
    """
    terms, considered = search.terms, list[Found]()
    seen: set[frozenset[tuple[object, ...]]] = set()
    given_up = Counter[tuple[object, ...]]()
    while (
        len(search.grouped(there := terms_of(search.fit))) < MOST_EFFECTS
        and (here := frozenset(map(place, there))) not in seen
    ):
        seen.add(here)  # what is given up for something else may earn its price beside that, and so on, for ever
        named = search.effects
        progress(f"search {len(named) + 1}: {len(terms)} forms of {len({t.effect for t in terms})} effects")
        ranked = [f for f in search.ranked() if given_up[kind(f.term)] < GIVEN_UP]
        considered = considered or ranked
        if not ranked or ranked[0].score < MARGIN or _crowded(search, ranked[0]):
            break
        better = refitted(problem, search.fit, [*there, *_first(ranked).terms])
        if better is None or better.sigma[0] > search.fit.sigma[0] * MUCH_WORSE:
            break  # it did not converge
        search = _revised(problem, Search(better, terms))
        given_up.update({*map(kind, terms_of(better))} - {*map(kind, terms_of(search.fit))})
        if search.effects == named:
            break  # it did not hold
    return _stiffest(problem, search), considered


def _exchanged(problem: Problem, search: Search) -> Search:
    """Return the search with two others in place of two effects, where these explain more together.

    Of two events either may look like the other's kind while the other is not there: what was taken first for what it
    is not holds the second to the same mistake, and neither is the worse by itself.
    """
    terms, at = terms_of(search.fit), search.fit
    for pair_of in itertools.combinations(search.grouped(terms), 2):
        places = list(itertools.chain(*pair_of))
        own, rest = [[terms[k] for k in one] for one in pair_of], [t for k, t in enumerate(terms) if k not in places]
        freed = search.freed(*places)
        tried = [pair for found in freed.ranked()[:RIVALS] if (pair := _paired(freed, found)) is not None]
        others = [p for p in tried if {*map(place, itertools.chain(*p))} != {*map(place, itertools.chain(*own))}]
        pair = max(others, key=lambda p: _worth(freed, p), default=None)
        if pair is None or _worth(freed, pair) < _worth(freed, own) - NEAR:
            continue
        other = refitted(problem, at, [*rest, *itertools.chain(*pair)])
        if other is None:
            continue
        more = 2 * problem.readings.n_scalars * float(np.log(at.sigma[0] / other.sigma[0]))
        if more - sum(search.price(*one) for one in pair) + sum(search.price(*one) for one in own) > MARGIN:
            return _revised(problem, Search(other, search.terms))
    return search


def _with_fewer_waves(problem: Problem, search: Search) -> Search:
    """Return the search with one wave of a period, and what earns most beside it, where they stand for all its waves.

    So many waves imitate others that are not found yet, and leave them nothing to earn afterwards.
    """
    terms, at = terms_of(search.fit), search.fit
    for places in search.grouped(terms):
        own, rest = [terms[k] for k in places], [t for k, t in enumerate(terms) if k not in places]
        if len(own) == 1:
            continue
        freed = search.freed(*places)
        best = max(own, key=lambda t: freed.gain(freed.where(t)))
        pair: list[Sequence[Term]] = [[best], freed.added(best).ranked()[0].terms]
        if _worth(freed, pair) <= _worth(freed, [own]) + MARGIN:
            continue
        if (other := refitted(problem, at, [*rest, *itertools.chain(*pair)])) is not None:
            return _revised(problem, Search(other, search.terms))
    return search


def _paired(freed: Search, found: Found) -> list[Sequence[Term]] | None:
    """Return an effect and the one that explains most beside it, the first in the form that is best beside that."""
    second = freed.added(*found.terms).ranked()[0].terms
    first = freed.added(*second).best(found.term.effect)
    return None if first.score < MARGIN else [first.terms, second]


def _worth(search: Search, several: Sequence[Sequence[Term]]) -> float:
    """Return what findings earn together beyond their prices, in the linear machine."""
    return search.gain(search.columns_of(*itertools.chain(*several))) - sum(search.price(*own) for own in several)


def _first(ranked: Sequence[Found]) -> Found:
    """Return what is fitted next: what earns most, but load before angle, and simple before flexible.

    What a load does is a function of the joints too, and waves of six joints imitate it where poses are few. Beside it
    they show what they explain themselves, and it is dropped again where they explain it all.
    """
    best, earning = ranked[0], [f for f in ranked if f.score > MARGIN]
    if best.term.effect == wave():
        best = next((f for f in earning if _loaded(f.term)), best)
    return next((f for f in earning if f.term.effect == best.term.kernels.EXTENDS), best)


def _crowded(search: Search, best: Found) -> bool:
    """Tell whether one more order earns most where there are many already.

    A machine that errs at so many orders imitates whatever else varies with its joints: before anything else is looked
    at, all orders are fitted together.
    """
    waves = search.grouped([t for t in terms_of(search.fit) if t.effect == wave()])
    return best.term.effect == wave() and len(waves) >= MOST_WAVES


def _loaded(term: Term) -> bool:
    return any(state.kind == "load" for state in read_by(load_effect(term.effect)))


def _without_gross(problem: Problem, search: Search) -> tuple[Search, list[Structure]]:
    """Return the search without gross errors, and what it leaves.

    They are dropped only where nothing is left with them: readings that lie off together, in a region or for a time,
    are no gross errors but what the model does not know. For that, none counts more than an ordinary reading that is
    just off: the squares of Huber's weights bound what each adds to a gain.
    """
    left = structures(dataclasses.replace(search.fit, weights=search.fit.weights**2))
    if left[0].earned > MARGIN or not len(search.fit.gross):
        return search, left
    final = refitted(problem, search.fit, terms_of(search.fit), drop_gross=True)
    if final is None:
        return search, left
    search = _proven(problem, Search(final, search.terms))
    return search, structures(search.fit)


def _revised(problem: Problem, search: Search) -> Search:
    """Look at each effect again with the others held beside it, until none has a better form."""
    for _ in range(REVISIONS):
        tried = (_better(problem, search, own) for own in search.grouped(terms_of(search.fit)))
        better = next((found for found in tried if found is not None), None)
        if better is None:
            break
        search = Search(better, search.terms)
    return search


def _better(problem: Problem, search: Search, places: Sequence[int]) -> Fit | None:
    """Return a fit in which what is best, or nothing, stands for a finding; None where it is best as it is.

    What earns more than a finding, but leaves it its price, does not stand for it: it comes beside it.
    """
    current, freed = search.fit, search.freed(*places)
    chosen, best = terms_of(current), freed.ranked()[0]
    own, others = [chosen[i] for i in places], [t for i, t in enumerate(chosen) if i not in places]
    kept = [_possible(t, std_of(current, i), problem) for i, t in zip(places, own, strict=True)]
    if any(less is not t for less, t in zip(kept, own, strict=True)):
        return refitted(problem, current, [*others, *filter(None, kept)])
    if best.score < MARGIN:
        return refitted(problem, current, others)
    first, *harmonics = own
    if first.effect != wave() and _crowded(search, best):
        return None
    if first.kernels.EXTENDS and (simple := _simpler(problem, search, places[0])) is not None:
        return simple
    if not harmonics and (wider := _wider(problem, search, places[0])) is not None:
        return wider
    if (fewer := _fewer(problem, search, places[0])) is not None:
        return fewer
    if {*map(form, best.terms)} == {*map(form, own)}:
        return None
    if best.term.effect != first.effect:
        beside = freed.added(*best.terms)
        if beside.gain(beside.columns_of(*own)) - search.price(*own) > MARGIN:
            return None
    other = refitted(problem, current, [*others, *best.terms])
    if other is None or other.sigma[0] > current.sigma[0] * MUCH_WORSE:
        return None
    further = best.term.effect == first.effect and set(carriers_of(best.term)) > set(carriers_of(first))
    if further and first.kernels.EXTENDS:  # the linear machine leaves much of a large delay: others make up for it
        more = 2 * problem.readings.n_scalars * float(np.log(current.sigma[0] / other.sigma[0]))
        return other if more > search.price(*best.terms) - search.price(*own) else None
    flexible = first.effect == best.term.kernels.EXTENDS or _richer(best.term, first)
    return None if flexible and not _refused(current, other) else other


def _possible(own: Term, std: Array, problem: Problem) -> Term | None:
    """Return an effect on the limbs where its size can be, None where it can on none; itself where it can on all."""
    cannot = beyond(own, std, problem.recording.joint_unit)
    return without_rows(own, [c.row for c in cannot]) if cannot else own


def _stiffest(problem: Problem, search: Search) -> Search:
    """Return the search with effects at the limbs that give least, of those that nothing tells apart beside all others.

    Not before: what is not found yet may tell them apart.
    """
    for i in range(len(terms_of(search.fit))):
        terms = terms_of(search.fit)
        if (other := search.freed(i).stiffer(terms[i])) is None:
            continue
        tried = refitted(problem, search.fit, [*terms[:i], other, *terms[i + 1 :]])
        if tried is None:
            continue
        worse = 2 * problem.readings.n_scalars * float(np.log(tried.sigma[0] / search.fit.sigma[0]))
        if worse < AS_GOOD:
            search = Search(tried, search.terms)
    return search


def _simpler(problem: Problem, search: Search, i: int) -> Fit | None:
    """Return a fit with the simpler effect that one extends in its place; None where readings refuse that."""
    current = search.fit
    terms = terms_of(current)
    name = terms[i].kernels.EXTENDS
    others = terms[:i] + terms[i + 1 :]
    if any(t.effect == name for t in others) or all(t.effect != name for t in search.terms):
        return None
    found = search.freed(i).best(name)
    if found.score < MARGIN:
        return None
    simple = refitted(problem, current, [*others, found.term])
    return None if simple is None or _refused(simple, current) else simple


def _richer(one: Term, other: Term) -> bool:
    """Tell whether both are what a load does to limbs, and one does more at each: it imitates the other."""
    both = (one, other)
    return one.values.shape[1] > other.values.shape[1] and all(t.limbs and _loaded(t) for t in both)


def _fewer(problem: Problem, search: Search, i: int) -> Fit | None:
    """Return a fit in which poorer effects of the load, with fewer coefficients, explain as much as one; None else.

    An axis that tilts turns what it bears about its neighbours' axes too: at several joints it imitates their springs.
    """
    at, freed = search.fit, search.freed(i)
    own, rest = terms_of(at)[i], [t for k, t in enumerate(terms_of(at)) if k != i]
    poorer = dict.fromkeys(t.effect for t in search.terms if _richer(own, t)).keys() - {t.effect for t in rest}
    found = [f for name in sorted(poorer) if (f := freed.best(name)).score > MARGIN]
    both = ((f, freed.added(*f.terms).ranked()[0]) for f in found)
    pairs = [[f.terms for f in pair if f.score > MARGIN] for pair in both]
    fewer = [p for p in pairs if sum(t.values.size for t in itertools.chain(*p)) < own.values.size]
    pair = max(fewer, key=lambda p: _worth(freed, p), default=None)
    other = None if pair is None else refitted(problem, at, [*rest, *itertools.chain(*pair)])
    if other is None or 2 * problem.readings.n_scalars * float(np.log(other.sigma[0] / at.sigma[0])) > AS_GOOD:
        return None
    return other


def _wider(problem: Problem, search: Search, i: int) -> Fit | None:
    """Return a fit in which another effect that is there already, on more limbs, stands for an effect.

    What twists the elbow of an arm twists its shoulder too: that needs a kind of physics less, and is left only for
    what earns more than one more name costs.
    """
    terms, alone = terms_of(search.fit), search.freed(i)
    own = terms[i]
    earned = alone.gain(alone.where(own)) - search.price(own)
    for j, other in enumerate(terms):
        if j == i or several(other.effect) or not carriers_of(other):
            continue
        every = alone.where(next(t for t in search.terms if t.effect == other.effect))
        if alone.gain(every) < earned - MARGIN:
            continue
        freed = search.freed(i, j)
        found = freed.best(other.effect)
        if not set(carriers_of(found.term)) > set(carriers_of(other)):
            continue
        both = freed.gain([*freed.where(own), *freed.where(other)]) - search.price(own) - search.price(other)
        if both - found.score < MARGIN:
            rest = [t for k, t in enumerate(terms) if k not in (i, j)]
            return refitted(problem, search.fit, [*rest, found.term])
    return None


def _refused(simple: Fit, flexible: Fit) -> bool:
    """Tell whether held-out readings refuse a simple model: the flexible one predicts them better, beyond doubt."""
    parts = folds(simple.problem.readings, simple.problem.recording, rows=simple.repeats.rows)
    before, after = (held_out_errors(at, Prior(), parts) / simple.sigma for at in (simple, flexible))
    return borne_out(before, after)


def _proven(problem: Problem, search: Search, rest: Array | None = None) -> Search:
    """Drop the effects that do not earn their price, or do not beside the rest, columns that explain them as well.

    What no effect explains is easily imitated in part by some that vary with the same channel, or move the same joint.
    """
    drop_gross = not search.fit.weights.all()
    while search.effects:
        terms, scatter = terms_of(search.fit), scattering(search.fit)
        each, scores = search.grouped(terms), []
        for places in each:
            own = [terms[i] for i in places]
            beside = search.freed(*places) if rest is None else search.freed(*places).joined(rest)
            noisy = scatter.variance if scatter and own[0].limbs == (scatter.joint,) else 1.0
            scores.append(beside.gain(beside.columns_of(*own)) / noisy - search.price(*own))
        worst = int(np.argmin(scores))
        if scores[worst] > MARGIN:
            break
        others = [t for i, t in enumerate(terms) if i not in each[worst]]
        kept = refitted(problem, search.fit, others, drop_gross=drop_gross)
        if kept is None:
            break
        search = Search(kept, search.terms)
    return search


def borne_out(before: Array, after: Array) -> bool:
    """Tell whether readings held out lie nearer to their prediction after than before, (R, k) in standard deviations.

    Each counts by the part of its square that goes or comes, which no gross error outweighs.
    """
    a, b = np.nansum(before**2, axis=1), np.nansum(after**2, axis=1)
    seen = np.isfinite(before).any(axis=1) & np.isfinite(after).any(axis=1) & (a + b > 0)
    gone = (a[seen] - b[seen]) / (a[seen] + b[seen])
    if len(gone) < 2:
        return False
    return bool(gone.mean() > BORNE_OUT * gone.std(ddof=1) / np.sqrt(len(gone)))


def held_out_by(problem: Problem, search: Search, parts: Sequence[tuple[np.ndarray, np.ndarray]]) -> Array:
    """Return the errors (R, k) [mm, rad] of readings that took part neither in a fit nor in the choice of its effects.

    Each part of the readings is predicted from the others, which choose their own effects: by the same charges, in the
    machine made linear at the final fit.
    """
    final = {form(t): t for t in terms_of(search.fit)}
    out = np.full(search.fit.residual.shape, np.nan)
    for train, test in parts:
        part = search.freed(*range(len(final))).within(train)
        chosen: list[Term] = []
        while len(part.grouped(chosen)) < MOST_EFFECTS and (best := part.ranked()[0]).score > MARGIN:
            chosen += best.terms
            part = part.added(*best.terms)
        same = {form(t) for t in chosen} == final.keys()
        terms = [final.get(form(t), t) for t in chosen]
        fitted = search.fit if same else refitted(problem, search.fit, terms, tolerance=COMPARED, known=terms)
        if fitted is not None:
            out[test] = held_out_errors(fitted, Prior(), [(train, test)])[test]
    return out
