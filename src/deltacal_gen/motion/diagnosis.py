"""From what drives gave to the friction behind it: the ladder of every joint, told together."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from scipy.stats import chi2

from deltacal_gen.machine.places import place_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.bodies import Found, beside, searched
from deltacal_gen.motion.common import in_common
from deltacal_gen.motion.fit import Fit, fitted
from deltacal_gen.motion.identification import RIGID, bodies_told, still_to_show
from deltacal_gen.motion.ladder import BUYS, SEVERAL, LookedAt
from deltacal_gen.motion.lag import LATENCY
from deltacal_gen.motion.laws import Lawful, lawful, registered
from deltacal_gen.motion.mistakes import check, sizes_alone, too_heavy
from deltacal_gen.motion.payload import ADVICE, NAMES, PAYLOAD, PayloadError
from deltacal_gen.motion.session import Session, still_to_move, to_move, untold
from deltacal_gen.motion.told import told
from deltacal_gen.motion.traces import traces
from deltacal_gen.motion.trajectories import INSIDE, Trajectories
from deltacal_gen.motion.unexplained import RUN, Rest, dependences, rest, share_left
from deltacal_gen.physics.law import is_law
from deltacal_gen.physics.terms import drive_effect_names, load_effect
from deltacal_gen.results.diagnosis import (
    Channel,
    EffectParameter,
    LawTerm,
    Location,
    NextMeasurement,
    Searched,
    Verdict,
)
from deltacal_gen.results.motion import (
    LadderOf,
    MotionDiagnosis,
    RungOf,
    TorqueEffect,
    TorqueLaw,
    TorqueRejected,
    Unexplained,
)
from deltacal_gen.results.parts import Missing
from deltacal_gen.states import read_by
from deltacal_gen.units import of_sliding

if TYPE_CHECKING:
    from deltacal_gen.physics.terms import Kernels

Progress = Callable[[str], None]
MUCH = 0.1  # of what a drive gives: so much noise is said
LAW = "law"  # in a ladder: what nobody has registered, all terms together


def diagnose(robot: Robot, given: Trajectories, progress: Progress) -> MotionDiagnosis:
    """Find what each drive has beside the rigid machine.

    Raises
    ------
    InputError
        No joint moves for long enough; columns of drives are exchanged, or count in another unit than they say.
    """
    progress("derivatives")
    session = Session.of(robot, given)
    check(session)
    plain = [fitted(joint, []) for joint in session.moving]
    whole = searched(session, progress)
    free, session = session, whole.session
    rests = [rest(fit, session.declared(fit)) for fit in whole.fits]
    laws, found, rests = _lawful(session, whole.fits, rests, progress)
    effects = _effects(session, plain, found)
    if whole.payload is not None:
        effects = (*effects, _payload(whole.payload, whole, plain))
    open_ = [r for r in rests if r is not None]
    verdict = Verdict.UNEXPLAINED if open_ else Verdict.MISSING_PHYSICS if effects or laws else Verdict.ADEQUATE
    final = session.left(found)
    as_found = all(one is other for one, other in zip(found, whole.fits, strict=True))
    bodies = bodies_told(free.rigid, whole.free if as_found else beside(free, found))
    return MotionDiagnosis(
        **session.answered(found),
        **bodies,
        traces=traces(session, plain, found),
        verdict=verdict,
        summary=_summary(effects, laws, open_, session, found),
        noise=session.noise(found),
        baseline=session.left(plain, f"{robot.mechanism}/{RIGID}"),
        location=_location(robot, effects, laws, open_, plain, found),
        effects=effects,
        search=_search(found),
        final=final,
        ladder=tuple(_ladder(fit, r) for fit, r in zip(found, rests, strict=True)),
        unexplained=tuple(Unexplained(limb=r.joint, channel=r.channel, share=r.share, text=r.text) for r in open_),
        rejected=_rejected(session, effects, found),
        not_tested=_not_tested(session, found),
        next_measurements=(*_next(session, effects, open_, found), *still_to_show(bodies)),
        laws=laws,
    )


def _lawful(
    session: Session, fits: Sequence[Fit], rests: Sequence[Rest | None], progress: Progress
) -> tuple[tuple[TorqueLaw, ...], list[Fit], list[Rest | None]]:
    """Return the laws of joints that the ladder leaves open, and the fits and rests of all joints with these.

    A law that a registered effect says as well is that effect.
    """
    laws: dict[int, Lawful] = {}
    after, left_open = list(fits), list(rests)
    for k, (fit, left) in enumerate(zip(fits, rests, strict=True)):
        if left is None:
            continue
        progress(f"a law of joint {fit.joint.number}")
        sigma = session.declared(fit)
        if (found := lawful(fit, left, sigma)) is None:
            continue
        if (named := registered(found, sigma)) is None:
            laws[fit.joint.number] = found
        after[k], left_open[k] = named or found.fit, None
    return told(session, laws), after, left_open


def _effects(session: Session, plain: Sequence[Fit], fits: Sequence[Fit]) -> tuple[TorqueEffect, ...]:
    """Return the effects by name; those of several orders one for each."""
    of_name: dict[tuple[str, tuple[float, ...]], list[tuple[Fit, int]]] = {}
    for fit in fits:
        for n, rung in enumerate(fit.rungs):
            if is_law(rung.effect):
                continue
            key = rung.effect, rung.constants if "orders" in rung.kernels.SEARCHED else ()
            of_name.setdefault(key, []).append((fit, n))
    before = {fit.joint.number: _mean_square(fit) for fit in plain}
    excess = {f.joint.number: max(before[f.joint.number] / max(_mean_square(f), 1e-300) - 1.0, 0.0) for f in fits}
    found = [_effect(session, where, excess) for where in of_name.values()]
    late = [fit for fit in fits if fit.lag is not None]
    return (*found, *([_latency(late, excess)] if late else []))


def _latency(fits: Sequence[Fit], excess: Mapping[int, float]) -> TorqueEffect:
    """Return by how much the readings of some joints come late."""
    lags = [(fit, fit.lag) for fit in fits if fit.lag is not None]
    gain = float(sum(lag.gain for _, lag in lags))
    removed = sum(excess[f.joint.number] * ((1.0 - lag.bought) ** -2 - 1.0) / f.takes_away for f, lag in lags)
    return TorqueEffect(
        name=LATENCY,
        advice=load_effect(LATENCY).ADVICE,
        title=_late_or_early([lag.delay for _, lag in lags]),
        limbs=tuple(fit.joint.number for fit, _ in lags),
        parameters=tuple(
            EffectParameter(name="delay", limb=fit.joint.number, value=lag.delay, std=lag.std, unit="s")
            for fit, lag in lags
        ),
        p_value=float(chi2.sf(gain, len(lags))),
        gain_chi2=gain,
        gain_by_limb={str(fit.joint.number): lag.gain for fit, lag in lags},
        share_of_excess=removed / max(sum(excess.values()), 1e-300),
        indistinguishable_from=(),
        heldout_gain=tuple(lag.bought for _, lag in lags),
    )


def _late_or_early(delays: Sequence[float]) -> str:
    """Return what readings do whose delays [s] are of these signs."""
    if min(delays) > 0:
        return "readings that come late"
    early = "readings that come early, as what the joints did was recorded late"
    return early if max(delays) < 0 else "readings that come late, or early, beside what the joints did"


def _mean_square(fit: Fit) -> float:
    """Return the mean square of a joint's held-out residuals."""
    return float(np.nanmean(fit.held_out**2))


def _effect(session: Session, where: Sequence[tuple[Fit, int]], excess: Mapping[int, float]) -> TorqueEffect:
    """Return an effect on some joints; `excess` is what the rigid machine leaves above noise, in its variances.

    The excess of a joint is shared among its effects by what each takes away beside the others.
    """
    fit, n = where[0]
    kernels = fit.rungs[n].kernels
    gains = [fit.gains[n] for fit, n in where]
    removed = 0.0
    for of, k in where:
        removed += excess[of.joint.number] * ((1.0 - of.bought[k]) ** -2 - 1.0) / of.takes_away
    tried = sum(len(fit.joint.candidates) for fit, _ in where)
    parameters = tuple(p for fit, n in where for p in _parameters(session, fit, n))
    common = in_common(parameters)
    own = sum(gains), fit.rungs[n].width * len(where)
    charged = own if common is None else (own[0] - common.lost, fit.rungs[n].width)
    return TorqueEffect(
        name=fit.rungs[n].effect,
        title=kernels.TITLE,
        advice=kernels.ADVICE,
        limbs=tuple(fit.joint.number for fit, _ in where),
        parameters=parameters,
        common=None if common is None else common.parameters,
        p_value=_of_the_best(*charged, tried),
        gain_chi2=float(sum(gains)),
        gain_by_limb={str(fit.joint.number): float(fit.gains[n]) for fit, n in where},
        share_of_excess=removed / max(sum(excess.values()), 1e-300),
        indistinguishable_from=tuple(sorted({name for fit, n in where for name in fit.alike[n]})),
        heldout_gain=tuple(float(fit.bought[n]) for fit, n in where),
    )


def _payload(payload: PayloadError, whole: Found, plain: Sequence[Fit]) -> TorqueEffect:
    """Return a payload that is not what was written; of what no torque tells the deviation is not known."""
    parameters = [
        EffectParameter(
            name=name,
            limb=None,
            value=float(v),
            std=None if np.isnan(s) else float(s),
            unit=unit,
            setup=setup or None,
        )
        for setup, row, stds in zip(payload.setups, payload.values, payload.std, strict=True)
        for (name, unit), v, s in zip(NAMES, row, stds, strict=True)
    ]
    before = sum(_mean_square(fit) for fit in plain)
    removed = sum(_mean_square(f) * ((1.0 - b) ** -2 - 1.0) for f, b in zip(whole.fits, whole.bought, strict=True))
    return TorqueEffect(
        name=PAYLOAD,
        title="a payload that is not what was written",
        advice=ADVICE,
        limbs=(),
        parameters=tuple(parameters),
        p_value=float(chi2.sf(payload.gain, int(np.isfinite(payload.std).sum()))),
        gain_chi2=payload.gain,
        share_of_excess=float(np.clip(removed / before, 0.0, 1.0)),
        indistinguishable_from=(),
        heldout_gain=whole.bought,
    )


def _of_the_best(gain: float, width: int, tried: int) -> float:
    """Return the probability that noise alone lets the best of some candidates earn so much in chi2."""
    return float(-np.expm1(tried * np.log1p(-min(chi2.sf(gain, width), 1.0 - 1e-16))))


def _search(fits: Sequence[Fit]) -> Searched:
    """Return what the search comes to where nothing is named yet, all joints together."""
    firsts = [fit.first for fit in fits if fit.first is not None]
    if not firsts:
        return Searched(best=None, p_value=1.0)
    tried = sum(len(fit.joint.candidates) for fit in fits)
    best = min(firsts, key=lambda f: chi2.logsf(f.gain, f.width))
    return Searched(best=best.effect, p_value=_of_the_best(best.gain, best.width, tried))


def _rejected(session: Session, effects: Sequence[TorqueEffect], fits: Sequence[Fit]) -> tuple[TorqueRejected, ...]:
    """Return the effects that no joint has, the one that would earn most first."""
    named = {e.name for e in effects}
    left = {fit.joint.number: np.sqrt(_mean_square(fit)) / fit.joint.readout.inside for fit in fits}
    of_name: dict[str, list[tuple[Fit, LookedAt]]] = {}
    for fit in fits:
        for looked in fit.passed_over:
            if looked.effect not in named:
                of_name.setdefault(looked.effect, []).append((fit, looked))
    found = []
    for name, where in of_name.items():
        with_it = left | {fit.joint.number: left[fit.joint.number] * (1.0 - max(k.buys, 0.0)) for fit, k in where}
        counts = {fit.joint.number: np.isfinite(fit.held_out).sum() for fit in fits}
        square = sum(counts[i] * with_it[i] ** 2 for i in with_it) / sum(counts.values())
        fit, most = max(where, key=lambda pair: pair[1].buys)
        one = len({f.joint.unit for f in fits}) == 1
        by_joint = tuple(float(with_it[j.number]) if j.number in with_it else None for j in session.joints)
        found.append(
            TorqueRejected(
                name=name,
                gain_chi2=float(max(k.gain for _, k in where)),
                why=f"it takes {100 * max(most.buys, 0.0):.2g} % of the held-out rms away where it takes most, on "
                f"joint {fit.joint.number}, beside what is named{_for_all_that(most)}",
                heldout_rms=float(np.sqrt(square)) if one else None,
                heldout_rms_by_joint=by_joint,
                unit_by_joint=session.given.units,
            )
        )
    return tuple(sorted(found, key=lambda r: -r.gain_chi2))


def _for_all_that(looked: LookedAt) -> str:
    """Return why an effect that takes enough of the held-out rms away is not named for all that."""
    if looked.buys < BUYS:
        return ""
    if looked.gain <= looked.price:
        return f": it earns {looked.gain:.3g} of chi2, and its search costs {looked.price:.3g}"
    if looked.impossible:
        return ", but by a coefficient of the wrong sign, which no drive has"
    smooth = (
        "a smooth function of the position does as much, or " if SEVERAL in load_effect(looked.effect).SEARCHED else ""
    )
    return f": but {smooth}what some stretches would choose does not foretell the others; a longer recording may tell"


def _parameters(session: Session, fit: Fit, n: int) -> list[EffectParameter]:
    """Return an effect's coefficients and constants on a joint, in the units of files."""
    rung, joint = fit.rungs[n], fit.joint
    at = joint.X.shape[1] + sum(other.width for other in fit.rungs[:n])
    slides = session.rigid.dynamics.joint_units[joint.number - 1] == "mm"
    found = []
    for c, (name, unit, factor, _) in enumerate(rung.kernels.COEFFICIENTS):
        unit, factor = in_files(rung.kernels, name, unit, factor, joint.readout.told, slides)
        value, std = fit.coefficients[at + c] / factor, fit.std[at + c] / factor
        found.append(EffectParameter(name=name, limb=joint.number, value=float(value), std=float(std), unit=unit))
    sized = [k for k, other in enumerate(fit.rungs) if other.continuous]
    part = fit.size_std[sized.index(n)] if n in sized else None
    for (name, unit, factor, _), constant in zip(rung.kernels.CONSTANTS, rung.constants, strict=True):
        if slides and name in rung.kernels.OF_JOINT:
            unit, factor = of_sliding(unit)
        value = float(constant / factor)
        std = None if part is None else float(part * value)
        found.append(EffectParameter(name=name, limb=joint.number, value=value, std=std, unit=unit))
    return found


def in_files(kernels: Kernels, name: str, unit: str, factor: float, read: str, slides: bool) -> tuple[str, float]:
    """Return unit in files and factor to the unit inside of a coefficient, of a joint whose readings are in a unit.

    Where what a drive gives per torque is unknown, its readings' unit stands for Nm.
    """
    if slides and name in kernels.OF_JOINT:
        unit, factor = of_sliding(unit)
    if read in ("Nm", "N"):
        return unit, factor
    if name in kernels.OF_JOINT:
        force = "N" if slides else "Nm"
        return unit.replace(force, read, 1), factor / (1.0 if slides else INSIDE["Nm"])
    return (f"{unit} {read}/Nm", factor / INSIDE["Nm"]) if unit != "1" else (unit, factor)


def _ladder(fit: Fit, left: Rest | None) -> LadderOf:
    rungs = [
        RungOf(limb=fit.joint.number, name=rung.effect, buys=float(b), gain_chi2=float(g))
        for rung, b, g in zip(fit.rungs, fit.bought, fit.gains, strict=True)
        if not is_law(rung.effect)
    ]
    law = [(b, g) for rung, b, g in zip(fit.rungs, fit.bought, fit.gains, strict=True) if is_law(rung.effect)]
    if law:
        buys, gain = (float(sum(each)) for each in zip(*law, strict=True))
        rungs.append(RungOf(limb=fit.joint.number, name=LAW, buys=buys, gain_chi2=gain))
    if fit.lag is not None:
        rungs.append(RungOf(limb=fit.joint.number, name=LATENCY, buys=fit.lag.bought, gain_chi2=fit.lag.gain))
    stops = f"no further effect buys {100 * BUYS:g} % of the held-out rms"
    return LadderOf(
        limb=fit.joint.number,
        unit=fit.joint.unit,
        rungs=tuple(sorted(rungs, key=lambda r: -r.buys)),
        stops=stops if left is None else f"{stops}; {left.text}",
    )


def _location(
    robot: Robot,
    effects: Sequence[TorqueEffect],
    laws: Sequence[TorqueLaw],
    rests: Sequence[Rest],
    plain: Sequence[Fit],
    found: Sequence[Fit],
) -> Location:
    """Return where model and recording differ: what is open, or else what the effects explain."""
    of_laws = {i for law in laws for t in law.terms for i in t.limbs}
    limbs = sorted({r.joint for r in rests} or {i for e in effects for i in e.limbs} | of_laws)
    texts = [r.text for r in rests] or [*(_where(robot, e) for e in effects), *_in_words(robot, laws)]
    where = [fit for fit in (found if rests else plain) if fit.joint.number in limbs]
    known = [(fit.joint.number, d) for fit in where for d in dependences(fit)]
    channels = [
        Channel(name=f"{d.channel}{joint}", p_value=d.p_value, share=d.share)
        for joint, d in sorted(known, key=lambda pair: -pair[1].share)
    ]
    return Location(channels=tuple(channels), limbs=tuple(limbs), region=None, text="; ".join(texts) or "nowhere")


def _where(robot: Robot, effect: TorqueEffect) -> str:
    """Return an effect with its joints, in words."""
    return f"{effect.title} ({place_of(robot, effect.limbs, 'joint')})" if effect.limbs else effect.title


def _in_words(robot: Robot, laws: Sequence[TorqueLaw]) -> list[str]:
    """Return every term of a law, in words."""
    return [f"a torque of {t.expression} ({place_of(robot, t.limbs, 'joint')})" for law in laws for t in law.terms]


def _numbers(term: LawTerm) -> str:
    """Return the numbers of a term of a law, in words."""
    return ", ".join(f"{c.name} = {c.value:.4g}{'' if c.unit == '1' else f' {c.unit}'}" for c in term.coefficients)


def _summary(
    effects: Sequence[TorqueEffect],
    laws: Sequence[TorqueLaw],
    rests: Sequence[Rest],
    session: Session,
    fits: Sequence[Fit],
) -> str:
    still, unread, silent = (", ".join(map(str, some)) for some in untold(session, fits))
    named = [_where(session.robot, e) for e in effects]
    parts = [f"Beside the rigid machine the drives overcome {'; '.join(named)}." if named else ""]
    if laws:
        each = zip(_in_words(session.robot, laws), (_numbers(t) for law in laws for t in law.terms), strict=True)
        parts.append(f"A law that nobody has registered: {'; '.join(' with '.join(pair) for pair in each)}.")
    if rests:
        parts.append(f"Not explained: {'; '.join(r.text for r in rests)}.")
    if not named and not laws and not rests:
        parts.append("The rigid machine explains what the drives give.")
        much = [(fit.joint.number, share) for fit in fits if (share := share_left(fit)) > MUCH]
        if much:
            shares = ", ".join(f"{100 * share:.0f} % of what joint {joint} gives" for joint, share in much)
            parts.append(f"What is left looks like noise, and is much: {shares}.")
    if turned := [str(fit.joint.number) for fit in fits if fit.joint.sense < 0]:
        parts.append(f"Friction would drive joint {', '.join(turned)}: its reading is counted against its angle.")
    if still:
        parts.append(f"Joint {still} moves too little to say anything.")
    if unread:
        parts.append(f"What the drive of joint {unread} gives was not recorded: of it nothing can be said.")
    if silent:
        parts.append(f"The reading of joint {silent} never changes: of what its drive gives nothing can be said.")
    parts += [f"But {doubt}." for doubt in (*too_heavy(session, fits), *sizes_alone(fits))]
    return " ".join(p for p in parts if p)


def _not_tested(session: Session, fits: Sequence[Fit]) -> tuple[Missing, ...]:
    """Return the effects that no joint's samples can tell, and what they would need."""
    tested = {rung.effect for fit in fits for rung in fit.joint.candidates}
    found = []
    for name in drive_effect_names():
        if name not in tested:
            needs = [s.needed for s in read_by(load_effect(name)) if s.needed]
            found.append(Missing(name=name, missing="; ".join(needs) or "longer motion"))
    if session.stated() is None:
        needs = ["mass, com and inertia of every body in the robot file, and readings whose torque is known"]
        found.append(Missing(name=PAYLOAD, missing=needs[0]))
    return tuple(found)


def _next(
    session: Session, effects: Sequence[TorqueEffect], rests: Sequence[Rest], fits: Sequence[Fit]
) -> tuple[NextMeasurement, ...]:
    """Return what to record next: what tells effects apart, what runs have of their own, joints that stood still."""
    found = []
    if own := ", ".join(str(r.joint) for r in rests if r.channel == RUN):
        text = (
            f"Record with each run what differs: what the machine carries (payload_kg, or a setup), its temperature. "
            f"Where a sensor has another zero in each run, zero it before it, or take that of joint {own} off."
        )
        found.append(NextMeasurement(why="runs differ", text=text, poses=(), expected_chi2=None))
    if short := ", ".join(str(r.joint) for r in rests if not r.shown):
        text = f"Record joint {short} for longer, all joints moving at once; plan gives such a movement."
        found.append(to_move("movements were too short", text))
    for effect in effects:
        if effect.indistinguishable_from:
            names = (effect.name, *effect.indistinguishable_from)
            states = tuple(dict.fromkeys(s for name in names for s in read_by(load_effect(name))))
            varied = dict.fromkeys(s.varied or s.name for s in states)
            joints = ", ".join(map(str, effect.limbs))
            found.append(
                NextMeasurement(
                    why=f"separates {' from '.join(names)}",
                    text=f"Record joint {joints} at other {' and '.join(varied)}.",
                    poses=(),
                    expected_chi2=None,
                    separates=names,
                    run=tuple(s.name for s in states),
                )
            )
    return (*found, *still_to_move(session, fits))
