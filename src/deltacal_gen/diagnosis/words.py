"""What a diagnosis says in sentences: its figures are known elsewhere, its words are written here and nowhere else."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.diagnosis.charges import MARGIN
from deltacal_gen.diagnosis.correction import POSITION
from deltacal_gen.diagnosis.strategy import ALIKE
from deltacal_gen.diagnosis.structure import alike, returning
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.series import Series
from deltacal_gen.identification.drawing import filed_rms
from deltacal_gen.identification.noise import alike_at_a_pose, noise_model
from deltacal_gen.machine.places import place_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.results.diagnosis import Diagnosis, Effect, JointFunction, Location, Verdict
from deltacal_gen.results.document import decimals, rounded
from deltacal_gen.results.parts import Source, needless
from deltacal_gen.results.places import Places

if TYPE_CHECKING:
    from deltacal_gen.diagnosis.conclusion import Conclusion, Named
    from deltacal_gen.diagnosis.search import Found
    from deltacal_gen.diagnosis.structure import Region

MOST_SHOWN = 3  # effects that are suspected; joints, and periods of each, of a smooth correction; orders of a joint
MOST_ODDS = 100.0  # that are given as a number
RETURNING = 0.5  # correlation of the visits of a pose from which on most of the residual belongs to the pose
NOTHING = "depends on nothing recorded"
SUSPECTED = 0.02  # p-value of what is worth a word though its gain does not exceed the penalty


def summary(found: Conclusion, answer: Diagnosis) -> str:
    """Return one paragraph that a maintenance engineer can act on."""
    says = {
        Verdict.ADEQUATE: _adequate,
        Verdict.MISSING_PHYSICS: _missing_physics,
        Verdict.UNEXPLAINED: _unexplained,
    }
    sign = f"It may be {found.turned}: compare the signs of that column first." if found.turned else ""
    doubts = [f"But {doubt}" for doubt in (*found.final.unsettled, *found.doubts)]
    parts = (sign, *says[found.verdict](found, answer), found.noise.contradiction, *doubts)
    return " ".join(filter(None, parts))


def _adequate(found: Conclusion, answer: Diagnosis) -> Sequence[str]:
    before, names = found.heldout[0], found.baseline.problem.names
    if found.lean:
        scalars = found.final.problem.readings.n_scalars
        free = scalars - len(names)
        return (
            f"Too few data to name an effect: {scalars} readings and {len(names)} parameters of {found.model}, {free} "
            f"degree{'s' * (free != 1)} of freedom: the parameters absorb any other model error.",
            f"The fit leaves {decimals(found.final.rms())} mm. Probe a mesh over the whole bed, and measure distances "
            "on a printed object.",
        )
    if found.short:
        heldout = f"{decimals(before)} mm" if np.isfinite(before) else "not known"
        return (
            f"No model error can be shown, but these poses are too few for {len(names)} parameters: the held-out error "
            f"of the geometry is {heldout}, the noise {decimals(found.noise.sigma)} mm. Measure more poses.",
        )
    suspected = _suspected(answer)
    asked = found.final.problem.names and not found.redrawn
    vain = needless(filed_rms(found.final), before) if asked else ""
    sure = "proven" if suspected or drifting(found) else "found"
    return (
        f"No model error {sure}: the calibrated geometry leaves {decimals(before)} mm on held-out readings.",
        _residual_is(found),
        vain or "Use the calibrated machine.",
        suspected,
    )


def _missing_physics(found: Conclusion, answer: Diagnosis) -> Sequence[str]:
    before, after = map(decimals, found.heldout)
    named = _named(answer)
    if found.unsure:
        left = (
            f"With it {decimals(found.final.rms())} mm remain of the readings of the fit, {after} mm of held-out "
            "readings: it is there, but more poses would determine it better."
        )
    else:
        left = f"With it {after} mm remain."
    return (
        f"Geometry alone leaves {before} mm on held-out readings.",
        f"Effect{'s' if len(named) > 1 else ''} found: {'; '.join(named)}.",
        left,
        _residual_is(found),
        indistinguishable(found.effects, answer.robot.places),
        _suspected(answer),
    )


def _unexplained(found: Conclusion, answer: Diagnosis) -> Sequence[str]:
    named = _named(answer)
    return (
        f"Residual not explained: {decimals(found.final.rms())} mm remain that no registered effect explains"
        f"{' if the column is right' if found.turned else ''}: {answer.location.text}.",
        f"Proven besides: {'; '.join(named)}." if named else "",
        indistinguishable(found.effects, answer.robot.places),
        _suspected(answer),
        not_searched(found),
        _corrected(found, answer),
    )


# ------------------------------------------------------------------------------------------------ what was found


def _named(answer: Diagnosis) -> list[str]:
    """Return a phrase for each effect, one for all waves of a kind without harmonics, and one for the formula.

    Several waves of a joint that moved less than their period are a smooth function of its angle taken to pieces: one
    by one they look like so many faults.
    """
    places, groups = answer.robot.places, dict[str | int, list[Effect]]()
    for k, effect in enumerate(answer.findings):
        alone = not effect.periods or answer.harmonics(effect)
        groups.setdefault(k if alone else effect.name, []).append(effect)
    return [_phrase(some, answer.harmonics(some[0]), places) for some in groups.values()] + _formula(answer)


def _phrase(some: Sequence[Effect], harmonics: Sequence[Effect], places: Places) -> str:
    """Return an effect, or waves of one kind, and where; of waves also which were not seen to repeat."""
    first = some[0]
    title, where = f"{first.title} ({first.name})", places.at(first.limbs)
    if harmonics:
        orders = ", ".join(f"{order:g}" for order in sorted(e.periods[0] for e in harmonics))
        return f"{title}{where}, no sine: {first.periods[0]:g} periods a turn, with harmonics {orders}"
    if first.standing_out is not None:
        return f"{title} of many orders{where}{_clearest(first, places)}"
    which = "which was"
    unseen = [e for e in some if e.read_deg]
    if len(some) > 1:
        where = f" of orders {', '.join(f'{e.periods[0]:g}{places.at(e.limbs)}' for e in some)}"
        which = f"of which {' and '.join(f'{e.periods[0]:g}' for e in unseen)} {'was' if len(unseen) == 1 else 'were'}"
    if not unseen:
        return f"{title}{where}"
    joints = "that joint" if len({limb for e in unseen for limb in e.limbs}) == 1 else "each of these joints"
    return f"{title}{where}, {which} not seen to repeat: any smooth function of {joints} may be it"


def _clearest(effect: Effect, places: Places) -> str:
    """Return which orders of each joint's periodic error stand out, with amplitudes and standard uncertainties."""
    each: dict[int, list[str]] = {}
    for s in effect.standing_out or ():
        shown = f"{s.order} ({' +- '.join(rounded(s.amplitude_deg, s.std_deg))} deg)"
        each.setdefault(s.limb, []).append(shown)
    joints = [f"{places.name([limb])} {', '.join(some[:MOST_SHOWN])}" for limb, some in each.items()]
    return f", clearest at orders: {'; '.join(joints)}" if joints else ", at no order clearly"


def _formula(answer: Diagnosis) -> list[str]:
    """Return the formula that was confirmed on held-out data."""
    if not answer.laws:
        return []
    places, (best, *rivals) = answer.robot.places, answer.laws
    terms = [f"{t.target} moves by {t.expression}{places.at(t.limbs)}" for t in best.terms]
    doubt = (
        f" ({len(rivals)} other formula{'s' * (len(rivals) > 1)} indistinguishable at these poses)" if rivals else ""
    )
    return [f"a formula beyond the registered effects: {' and '.join(terms)}{doubt}"]


# ------------------------------------------------------------------------------------------- how sure that is


def indistinguishable(effects: Sequence[Named], places: Places) -> str:
    """Return what fits as well as what is named, by how much less, and at which limbs it may be instead; "" for none.

    What the sign of a column would decide is not among it.
    """
    each = []
    for n in effects:
        others = [name for name in n.alike if name not in n.turned]
        if others and n.fundamental is None:
            ratio = f" (likelihood ratio {_ratio(n.lead)})" if n.rivals else ""
            each.append(f"{n.term.effect} from {', '.join(others)}{ratio}")
        each += [f"{n.term.effect}{places.at([limb])} from one{places.at(o)}" for limb, o in n.elsewhere.items()]
    return f"Indistinguishable at these poses: {'; '.join(each)}." if each else ""


def _ratio(lead: float) -> str:
    """Return the ratio of likelihoods, the penalty for the search in them, that a difference in chi2 stands for."""
    ratio = float(np.exp(lead / 2))
    return f"{ratio:.2g}" if ratio < MOST_ODDS else f"above {MOST_ODDS:.0f}"


def _suspected(answer: Diagnosis) -> str:
    """Return what is significant but not confirmed.

    Where nothing is named the first is given though its gain falls short of the penalty, if chance hardly does as much.
    """
    calm = answer.verdict is Verdict.ADEQUATE
    shown = [h for n, h in enumerate(answer.hints) if h.earned or (calm and n == 0 and h.p_value <= SUSPECTED)]
    phrases = [
        f"{h.name}{answer.robot.places.at(h.limbs)} ({''.join(f'or {o}, ' for o in h.indistinguishable_from)}"
        f"p = {h.p_value:.1g})"
        for h in shown[:MOST_SHOWN]
    ]
    more = f" and {len(shown) - MOST_SHOWN} more" if len(shown) > MOST_SHOWN else ""
    return f"Suspected, not confirmed: {'; '.join(phrases)}{more}." if shown else ""


# ------------------------------------------------------------------------------------------------- the residual


def _residual_is(found: Conclusion) -> str:
    """Return why the residual is measurement noise, or that nothing says so."""
    drift = drifting(found)
    if drift is not None:
        timed = found.final.problem.recording.time_s is not None
        return (
            f"The residual is correlated over {drift.rows:.0f} of {drift.rows_of_a_set_up:.0f} readings: no noise of "
            "readings but a slow drift (of the instrument's stand, the base, a joint's zero) that nothing recorded "
            f"explains. Measure one pose first, at intervals and last{'' if timed else ', and record time_s'}."
        )
    serial = noise_model(found.final, found.noise)
    noise = "measurement noise" + (f" correlated over {serial.rows:.0f} readings" if serial.rho else "")
    noise += f" ({found.noise.rounded})" if found.noise.rounded else ""
    if found.noise.source is not Source.RESIDUAL:
        return f"That is {noise}."
    looks = f"That looks like {noise}: no pattern remains in the residual"
    if found.noise.refuted is not None:
        return f"{looks}."
    return (
        f"{looks}. The noise level is unknown (neither repeats nor a declared sigma_mm): model error of this size "
        "cannot be excluded."
    )


def drifting(found: Conclusion) -> Series | None:
    """Return the correlation of the residual where it lasts as long as the recording; None of ordinary noise.

    An instrument whose noise is declared may drift within that.
    """
    series, declared = found.final.repeats.series, found.noise.source is Source.DECLARED
    return series if isinstance(series, Series) and series.lasts and not declared else None


def located(
    at: Fit, channel: str | None, limbs: Sequence[int], region: Region | None, explained: bool, walk: bool
) -> str:
    """Return where a model error sits: the channel it depends on first, limbs, a region, what follows a random walk."""
    if region is not None:
        x, y, z = region[0]
        text = f"the model error sits in a region of the workspace around ({x:.0f}, {y:.0f}, {z:.0f}) mm"
    elif channel is not None:
        text = f"the residual depends on {channel}"
    else:
        text = f"the {'model error' if limbs else 'residual'} {NOTHING}" if explained or walk else _unlocated(at, limbs)
    if limbs:
        text += f", at {place_of(at.problem.body.robot, limbs)}"
    if walk:
        text += ", whose zero" if limbs else ": the instrument, or its stand,"
        text += " follows a random walk, which its past does not predict"
    return text


def _unlocated(at: Fit, limbs: Sequence[int]) -> str:
    """Return how a residual is correlated that depends on no channel."""
    near, proven = alike(at)
    if proven > ALIKE:
        return f"the residual of neighbouring poses is correlated ({near:.2f})"
    again, proven = returning(at)
    if proven > ALIKE and again > RETURNING:
        return (
            f"the residual comes back at each visit of a pose (correlation {again:.2f}), but from one pose to the next "
            "it jumps: poses between them would show how"
        )
    if at.repeats.rows > 1:
        if at.problem.readings.rows.shape[1] > 1:
            return f"the residual is shared by distances with a common point and {NOTHING}"
        return f"the residual is correlated over {at.repeats.rows:.0f} readings and {NOTHING}"
    if limbs:
        return f"the residual {NOTHING}, but moves readings as one joint does"
    alone = not alike_at_a_pose(at, at.problem.recording)
    return f"the residual {NOTHING}" if alone else f"the residual is shared by the readings of a pose, but {NOTHING}"


def why_not(found: Found, as_well: str | None, others: bool) -> str:
    """Return why an effect was not named; `as_well` is a name of which it is indistinguishable."""
    if as_well is not None:
        return f"indistinguishable from {as_well} at these poses"
    if found.score < MARGIN:
        return (
            f"would need {found.doubt.beyond}" if found.doubt else "gain within the penalty for coefficients and search"
        )
    if others:
        return "explains less of the same residual than what was named"
    return "explains part of the residual, but is not confirmed on held-out data"


def not_searched(found: Conclusion) -> str:
    """Return why no formula was searched where none is given; "" where one was."""
    if found.final.problem.readings.rows.shape[1] > 1:
        return "No formula was searched: either end of a distance may have moved; measure positions."
    if found.spectrum is not None:
        return "No formula was searched: an error of so many orders imitates any function of the pose."
    return ""


def _corrected(found: Conclusion, answer: Diagnosis) -> str:
    if found.correction is None or (made := answer.correction) is None:
        return "No smooth correction lowers the held-out error."
    names, places, most = made.depends_on, answer.robot.places, ""
    on = POSITION if names == (POSITION,) else f"the channel {names[0]}"
    where = f"{names[0]} is"
    if len(names) > 1:
        on, where = "functions that each joint has of its own angle or travel", "joints and position are"
        most = f" Most of it: {'; '.join(_periods(f, places) for f in made.functions[:MOST_SHOWN])}."
        most += " No period is claimed over the recorded range."
        if found.final.repeats.rows > 1:
            most += " Successive readings are correlated: only the same poses on another day tell joints from time."
    heldout = made.heldout_rms_mm
    judged = "readings held out row by row" if found.correction.row_by_row else "held-out readings"
    outliers = ", outliers excluded," if answer.gross_errors else ""
    return (
        f"A smooth correction by {on}, without physics, lowers the error of {judged}{outliers} from "
        f"{decimals(heldout.before)} to {decimals(heldout.after)} mm; predictions use it where {where} as in this "
        f"recording.{most}"
    )


def _periods(own: JointFunction, places: Places) -> str:
    name = places.name([own.limb])
    if own.orders is not None:
        few = ", ".join(f"{order:.0f}" for order in own.orders[:MOST_SHOWN])
        return f"{name} {own.joint_rms_deg:.4f} deg at about {few} waves a turn"
    few = ", ".join(f"{wave:.1f}" for wave in (own.waves_mm or ())[:MOST_SHOWN])
    return f"{name} {own.joint_rms_mm:.4f} mm in waves of about {few} mm"


# ------------------------------------------------------------------------------------------ what to measure next


EXPLORES = "shows more of what no effect explains"
AXIS_OR_INSTRUMENT = (
    "separates a profile of the axis from the instrument's own non-linearity",
    "Such readings show both alike. Turn the instrument round, or shift it along the axis, and repeat: what moves with "
    "it is its own, what stays is the axis'.",
)


def more_poses(count: int) -> tuple[str, str]:
    """Return why and what to measure where readings are too few."""
    text = (
        f"Measure at least {count} more readings at other poses, all over the workspace: deltacal plan proposes them."
    )
    return "lets lesser effects show", text


def purpose(name: str, rival: str = "") -> str:
    """Return what a measurement is for."""
    return f"separates {name} from {rival}" if rival else f"settles whether there is {name}"


def measure(count: int, channels: Sequence[str]) -> str:
    """Return how to take proposed poses, at values of channels that are given with them."""
    those, them = ("this pose", "it") if count == 1 else (f"these {count} poses", "them")
    values = f", with {', '.join(channels)} as given" if channels else ""
    return f"Measure {those}{values}, without moving the instrument, and add {them}."


def no_poses(anywhere: bool, least: float, missing: Sequence[str], of_the_instrument: bool) -> str:
    """Return why no poses are proposed, and what would help; `least` is the difference in chi2 that is worth it."""
    text = f"No poses {'of this machine' if anywhere else 'within the recorded joint range'} do: none promise a "
    text += f"difference of {least:g} in chi2."
    if not anywhere:
        text += " State how far each joint may go (limits_deg or limits_mm under [joints] in the robot file), and "
        text += "diagnose again."
    text += f" Record {', '.join(missing)} and vary what is recorded." if missing else ""
    return text + (" Hold the instrument against a length that is known." if of_the_instrument else "")


def record_warmth(column: str, step: float, name: str, rival: str) -> str:
    """Return how to tell an effect from one of a temperature [K] that was not recorded, or did not vary."""
    return (
        f"Record {column}, and repeat the poses when the machine is at least {step:g} K warmer or colder: {rival} "
        f"follows the temperature, {name} does not."
    )


def explore(robot: Robot, channel: str, location: Location, recorded: bool) -> str:
    """Return how to see more of a residual that nothing explains: in its region, along its channel, or anyhow."""
    if not channel:
        joint = place_of(robot, location.limbs, "joint") if len(location.limbs) == 1 else ""
        return (
            f"Repeat a few poses{f', {joint} coming from either side' if joint else ''}, and record what may matter: "
            "time_s, temp_C, payload_kg and the direction in which each joint last moved (approach1 ...)."
        )
    if location.region is not None:
        return "Measure these poses, in the region and around it."
    if recorded:
        return f"Repeat these poses at these values of {channel}: what then changes is not the pose."
    return f"Measure these poses, evenly spread along {channel}."
