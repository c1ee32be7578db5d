"""What a search has found, effect by effect: size, gain, rivals; what was rejected, and where the misfit sits."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import numpy as np

from deltacal_gen.diagnosis.chance import Chance
from deltacal_gen.diagnosis.charges import AS_GOOD, MARGIN
from deltacal_gen.diagnosis.conclusion import Named
from deltacal_gen.diagnosis.library import unseen
from deltacal_gen.diagnosis.refits import form, terms_of
from deltacal_gen.diagnosis.scattering import scattering
from deltacal_gen.diagnosis.search import Doubt, Found, Search
from deltacal_gen.diagnosis.spectrum import Spectrum
from deltacal_gen.diagnosis.strategy import ALIKE
from deltacal_gen.diagnosis.structure import Region, Structure, alike
from deltacal_gen.diagnosis.unnamed import shifts
from deltacal_gen.diagnosis.words import located, why_not
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.identification.orders import wave
from deltacal_gen.machine.places import place_of
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Robot
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.law import is_law
from deltacal_gen.physics.terms import (
    TURNED,
    Term,
    effect_names,
    largest,
    load_effect,
)
from deltacal_gen.results.diagnosis import (
    Channel,
    Location,
    RegionOf,
    Rejected,
)
from deltacal_gen.states import TEMPERATURE, named, read_by
from deltacal_gen.units import joint_names

# of chi2: two explanations whose expected difference is below 10 are not told apart; the difference found spreads by
# twice its root, and two such deviations are allowed
AMBIGUOUS = 10.0 + 4 * 10.0**0.5
WARMED_WITHIN = (0.5, 0.2)  # of a session: times in which a machine that warms up comes near its end
WARMED = 20.0  # K: by which a machine whose temperature nobody recorded may well differ from its drawing


def location_of(
    at: Fit,
    left: Sequence[Structure],
    named: Sequence[Named],
    spectrum: Spectrum | None,
    chance: Chance,
    explained: bool,
    wandering: tuple[int, ...] = (),
) -> Location:
    """Return channels by their share of the misfit, the limbs, the region where it is local, and all in words.

    Where effects explain the misfit they say what it depends on; elsewhere the strongest structures do, and joints, or
    the instrument (0), that are `wandering`.
    """
    region: Region | None = None
    if explained:
        channels = _shown_by(at, named, spectrum, chance)
        limbs = sorted({i for n in named for i in n.term.limbs} | {*(spectrum.limbs if spectrum else ())})
    else:
        shows = wandering or any(s.earned > MARGIN for s in left) or alike(at)[1] > ALIKE
        scatter = None if shows else scattering(at)
        earning = [s for s in left if s.earned > 0] if scatter is None else []
        total = float(np.nansum((np.delete(at.residual, at.gross, axis=0) / at.sigma) ** 2))
        channels = {s.channel: (min(s.earned / total, 1.0), float(np.exp(-s.earned / 2))) for s in earning}
        limbs = list(earning[0].limbs) if earning else [] if scatter is None else [scatter.joint]
        region = earning[0].region if earning else None
        if wandering:
            limbs, region = [joint for joint in wandering if joint], None
    ordered = sorted(channels.items(), key=lambda kv: -kv[1][0])
    first = ordered[0][0] if ordered else None
    return Location(
        channels=tuple(Channel(name=name, p_value=p, share=share) for name, (share, p) in ordered),
        limbs=tuple(limbs),
        region=None if region is None else RegionOf(centre_mm=tuple(region[0]), radius_mm=region[1]),
        text=located(at, first, limbs, region, explained, bool(wandering)),
    )


def _shown_by(
    at: Fit, named: Sequence[Named], spectrum: Spectrum | None, chance: Chance
) -> dict[str, tuple[float, float]]:
    """Return the channels in which what was found shows, each with its share and its p-value."""
    unit, joints = at.problem.recording.joint_unit, at.problem.mechanism.limbs
    channels: dict[str, tuple[float, float]] = {}
    if spectrum is not None:
        whole = sum(spectrum.gains.values()) + sum(n.gain for n in named)
        for i, gain in spectrum.gains.items():
            channels[joint_names(unit, joints)[i - 1]] = gain / whole, chance.of(gain - 2.0 * spectrum.corner)
    for n in named:
        for state in n.term.states:
            for name in state.shown_in(unit, joints, n.term.limbs or range(1, joints + 1)):
                channels[name] = max(n.share, channels.get(name, (0.0, 1.0))[0]), chance.of(n.score)
    return channels


def named_of(
    search: Search, final: Fit, heldout: tuple[float, float], sigma: float, spectrum: Spectrum | None
) -> tuple[Named, ...]:
    """Return the effects of the final fit with their uncertainty, their gain beside all others, and their rivals.

    `heldout` is the error without and with them on readings that no fit has seen, `sigma` the noise in it [mm].
    """
    out: list[Named] = []
    unnamed = shifts(search)
    terms = terms_of(final)
    for places in search.grouped(terms):
        own = [terms[i] for i in places]
        if is_law(own[0].effect):
            continue  # told by itself
        freed = search.freed(*places)
        score = freed.gain(freed.columns_of(*own)) - search.price(*own)
        rivals = [f for f in freed.ranked() if not _is_as_well(f.term, own[0]) and f.score > score - AMBIGUOUS]
        unrecorded = _unrecorded(freed, own[0], score)
        lead = min((score - f.score for f in rivals), default=np.inf)
        others = tuple(f.term for f in rivals)
        for i, term in zip(places, own, strict=True):
            alone, of = search.freed(i), None if i == places[0] else own[0]
            of_constant, more = alone.spread(term) if of is None else (None, 0.0)  # a harmonic's order is its own
            variance = np.diag(final.covariance)[final.problem.coefficients(i)]
            std = np.sqrt(np.maximum(variance, 0.0) + more + unnamed.get(form(term), 0.0))
            # of what bears nothing as drawn is known what is believed of any machine
            borne, most = search.fit.problem.borne([term]), largest(term, final.problem.recording.joint_unit)
            std = np.where(borne, std, most.ravel())
            gain = alone.gain(alone.where(term))
            at_others = alone.elsewhere(term) if of is None else {}
            out.append(Named(term, std, gain, 1.0, others, unrecorded, score, of_constant, lead, of, at_others))
    # each in proportion to what is lost without it
    total = sum(n.gain for n in out) + (sum(spectrum.gains.values()) if spectrum else 0.0)
    share = share_removed(heldout, sigma) / max(total, 1e-300)
    return tuple(dataclasses.replace(n, share=share * n.gain) for n in out)


def share_removed(heldout: tuple[float, float], sigma: float) -> float:
    """Return which part of the held-out variance above noise something removes; errors [mm] without and with it."""
    before, after = heldout
    return float(np.clip((before**2 - after**2) / max(before**2 - sigma**2, 1e-300), 0.0, 1.0))


def _is_as_well(rival: Term, own: Term) -> bool:
    """Tell whether a rival is the effect itself, or is it wherever limbs are alike: that tells of nothing else."""
    return rival.effect == own.effect or (own.effect == rival.kernels.EXTENDS and not rival.kernels.SEARCHED)


def _unrecorded(freed: Search, term: Term, score: float) -> tuple[str, ...]:
    """Return effects of a temperature that was not recorded, or did not vary, that explain as much all the same.

    Beside an effect that goes with time, a temperature that nobody recorded may have gone with it: steadily, or ever
    less as a hall or a machine warms up.
    """
    body = freed.fit.problem.body
    warming = body.channels.get("warming")
    rows = np.unique(freed.fit.problem.readings.rows)
    if warming is not None and (not np.isfinite(warming[rows]).all() or np.ptp(warming[rows]) > 0):
        return ()
    courses = [np.full(len(body.q), WARMED) if warming is None else warming]
    time = body.channels.get("time")
    if warming is None and time is not None and any(s.passes for s in term.states):
        courses += _warmings(time)
    limbs, names = tuple(range(1, body.mechanism.limbs + 1)), dict[str, None]()
    for warm in courses:
        channels = body.channels.with_values(warming=warm, temperature=warm + named("warming").zero)
        assumed = Body(body.robot, body.mechanism, body.q, body.tool, channels)
        terms = [
            assumed.blank(name, limbs)
            for name in effect_names()
            if any(s.column == TEMPERATURE for s in read_by(load_effect(name)))
            and assumed.missing(name) is None
            and not unseen(freed.fit.problem, name)
        ]
        found = freed.of(assumed, terms).ranked()
        names |= {f.term.effect: None for f in found if f.score > score - AMBIGUOUS}
    return tuple(names)


def _warmings(time: Array) -> list[Array]:
    """Return courses (N,) [K] that the temperature may have taken in a session: steadily, or ever less."""
    since = (time - np.nanmin(time)) / max(float(np.ptp(time[np.isfinite(time)])), 1e-12)
    return [WARMED * since, *(WARMED * -np.expm1(-since / within) for within in WARMED_WITHIN)]


def turned_by(considered: Sequence[Found]) -> tuple[str, Doubt] | None:
    """Return the effect that would explain as much as any if approach counted the other way; None if none.

    Readings of which the column has the wrong sign look like play of less than nothing.
    """
    most = max((f.gain for f in considered), default=0.0)
    sizes = [(f.term.effect, f.doubt) for f in considered if f.doubt and f.doubt.beyond.turned]
    found = max(sizes, key=lambda s: s[1].gain, default=None)
    return None if found is None or found[1].gain < max(most - AS_GOOD, MARGIN) else found


def beside_turned(named: Sequence[Named], considered: Sequence[Found]) -> tuple[Named, ...]:
    """Return names with the effect of `turned_by`, where they explain as much: a jump as a joint turned back."""
    found = turned_by(considered)
    if found is None:
        return tuple(named)
    as_much = {f.term.effect for f in considered if abs(f.gain - found[1].gain) < AS_GOOD}
    return tuple(dataclasses.replace(n, turned=(found[0],)) if n.term.effect in as_much else n for n in named)


def turned_of(robot: Robot, considered: Sequence[Found]) -> str:
    """Return the same in words, with its size; "" where there is none."""
    if (found := turned_by(considered)) is None:
        return ""
    name, doubt = found
    where = f" at {place_of(robot, [doubt.limb])}" if doubt.limb else ""
    return f"{name}{where} with a {doubt.beyond.name} of {-doubt.beyond.value:.3g} {doubt.beyond.unit}, if {TURNED}"


def only_turned(considered: Sequence[Found], law: Sequence[Term]) -> bool:
    """Tell whether a law reads no more than the effect of `turned_by`: it is what the wrong sign does."""
    if not law or (found := turned_by(considered)) is None:
        return False
    read = {s.base for s in read_by(load_effect(found[0]))}
    return all({s.base for s in t.states} <= read for t in law)


def rejected_of(considered: Sequence[Found], named: Sequence[Named], spectrum: Spectrum | None) -> tuple[Rejected, ...]:
    """Return the effects that were considered and not named, what explains most first, each with why not."""
    chosen = {n.term.effect for n in named} | ({wave()} if spectrum is not None else set())
    alike = {name: n.term.effect for n in named for name in n.alike}
    return tuple(
        Rejected(name=f.term.effect, gain_chi2=f.gain, why=why_not(f, alike.get(f.term.effect), bool(chosen)))
        for f in sorted(considered, key=lambda f: -f.gain)
        if f.term.effect not in chosen
    )
