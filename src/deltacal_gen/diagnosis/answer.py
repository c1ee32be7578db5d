"""DIAGNOSIS.json of what was found, and the same in words."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from deltacal_gen.diagnosis.candidates import within_limits
from deltacal_gen.diagnosis.chance import Chance
from deltacal_gen.diagnosis.charges import several
from deltacal_gen.diagnosis.correction import POSITION, Correction
from deltacal_gen.diagnosis.discrimination import more_poses
from deltacal_gen.diagnosis.findings import Named
from deltacal_gen.diagnosis.harmonics import order_of, unrepeated
from deltacal_gen.diagnosis.laws.laws import Lawful
from deltacal_gen.diagnosis.laws.told import told
from deltacal_gen.diagnosis.partial import with_partial_residuals
from deltacal_gen.diagnosis.search import SCATTERED
from deltacal_gen.diagnosis.spectrum import Spectrum, Standing
from deltacal_gen.diagnosis.words import effects_in_words
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.estimation.series import Series
from deltacal_gen.files.robot import kept_robot
from deltacal_gen.identification.checks import gross_lines
from deltacal_gen.identification.drawing import filed_rms
from deltacal_gen.identification.knowledge import uncertainty_of
from deltacal_gen.identification.noise import Noise, coordinate_sigma, noise_model
from deltacal_gen.identification.orders import wave
from deltacal_gen.identification.unknowns import unknowns_of
from deltacal_gen.instrument.kind import Instrument
from deltacal_gen.machine.places import at, place_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.physics.law import PREFIX
from deltacal_gen.physics.terms import (
    LOGGED,
    constants_of,
    kept_term,
    load_effect,
    row_coefficients,
    scaled,
)
from deltacal_gen.results.diagnosis import (
    Baseline,
    BeforeAfter,
    Diagnosis,
    Effect,
    EffectParameter,
    Final,
    Hint,
    JointFunction,
    Location,
    NextMeasurement,
    NoiseLevel,
    Rejected,
    Residuals,
    Searched,
    Seen,
    SeenJoint,
    SmoothCorrection,
    StandingOrder,
    Verdict,
)
from deltacal_gen.results.document import decimals, rounded
from deltacal_gen.results.parts import InstrumentState, MachineState, Missing, Source, needless
from deltacal_gen.units import DEG, joint_factors, joint_names

SHORT = 2.0  # times the noise: a held-out error beyond it says that the geometry itself is hardly known
MOST_TOLD = 3  # that the summary tells: hints; joints, and waves of each, of a smooth correction; orders of a joint
MOST_ODDS = 100.0  # that are told as a number
WORTH_SAYING = 0.02  # p-value of a hint that the summary tells
ROUNDING = 1e-9  # of a standard deviation: less, of what no reading sees, is none


@dataclass(frozen=True)
class Diagnosed:
    """What was found, with the fits that it rests on; `answer` gives the same as users read it."""

    verdict: Verdict
    model: str
    baseline: Fit
    final: Fit
    effects: tuple[Named, ...]
    heldout: tuple[float, float]
    noise: Noise
    location: Location
    rejected: tuple[Rejected, ...]
    hints: tuple[Hint, ...]
    not_tested: tuple[Missing, ...]
    next_measurements: tuple[NextMeasurement, ...]
    robot: Robot
    chance: Chance
    correction: Correction | None = None
    spectrum: Spectrum | None = None
    lean: bool = False
    laws: tuple[Lawful, ...] = ()
    turned: str = ""
    doubts: tuple[str, ...] = ()
    redrawn: bool = False  # `robot` is drawn as the readings want it, not as its file does

    @property
    def short(self) -> bool:
        """Whether there are too few readings to tell a lesser effect from geometry.

        What a fit leaves of the readings that it saw, such as noise that repeats within a few rows do not show, is no
        want of readings.
        """
        return self.verdict is Verdict.ADEQUATE and not self.heldout[0] <= SHORT * self._left

    @property
    def unsure(self) -> bool:
        """Whether what was found predicts held-out readings far worse than those that it was fitted to."""
        return self.heldout[1] > SHORT * self._left

    @property
    def _left(self) -> float:
        """The noise of a coordinate [mm], known or as the fit leaves it."""
        return max(self.noise.sigma, coordinate_sigma(self.final))

    def answer(self) -> Diagnosis:
        """Return the same as users read it: DIAGNOSIS.json."""
        return result_of(self)


def result_of(found: Diagnosed) -> Diagnosis:
    """Return what was found as the answer of the command: figures in mm, curves and wording among them."""
    return with_partial_residuals(_without_partial_residuals(found))


def _without_partial_residuals(found: Diagnosed) -> Diagnosis:
    final, sigma = found.final, found.noise.sigma
    before, after = (heldout if np.isfinite(heldout) else None for heldout in found.heldout)
    of_final = (coordinate_sigma(final) / sigma) ** 2
    unit, unknowns = final.instrument.unit(final.problem.recording.columns), unknowns_of(final)
    clock: Literal["time_s", "row"] = "row" if final.problem.body.channels.get("time") is None else "time_s"
    return Diagnosis(
        verdict=found.verdict,
        summary=" ".join(filter(None, (_summary(found), found.noise.contradiction, *_doubts(found)))),
        noise=NoiseLevel(sigma_mm=found.noise.told, source=found.noise.source, model=noise_model(final, found.noise)),
        baseline=_baseline(found, before),
        location=found.location,
        effects=(
            *([_periodic(found, found.spectrum)] if found.spectrum is not None else []),
            *(_effect(n, final.problem, found.chance, clock) for n in found.effects),
        ),
        search=Searched(best=found.chance.best, p_value=found.chance.p_value),
        final=Final(train_rms_mm=final.rms(), heldout_rms_mm=after, chi2_per_dof=of_final),
        rejected=found.rejected,
        hints=found.hints,
        not_tested=found.not_tested,
        next_measurements=(
            *unknowns.next_measurements,
            *found.next_measurements,
            *([more_poses(found.final.problem)] if found.short else []),
        ),
        gross_errors=gross_lines(final),
        correction=_correction(found),
        residuals=_residuals(found),
        sigma_mm=found.noise.told,
        physics=tuple(map(kept_term, final.problem.acting(final.errors))),
        seen=None if found.spectrum is None else _seen(found.spectrum),
        clock=clock,
        begun_s=final.problem.body.channels.begun,
        poses=_numbers(found) if clock == "row" else None,
        instrument=_instrument(found, final.instrument),
        robot=kept_robot(found.robot),
        uncertainty=uncertainty_of(final, found.noise),
        unit=unit and unit[0],
        unit_mm=unit and unit[1],
        parameters=unknowns.parameters or None,
        turned=found.turned or None,
        motion=final.problem.recording.motion,
        laws=told(found.laws, final),
    )


def _baseline(found: Diagnosed, heldout: float | None) -> Baseline:
    return Baseline(
        model=found.model,
        parameters=len(found.final.problem.mechanism.model(found.model)),
        train_rms_mm=found.baseline.rms(),
        heldout_rms_mm=heldout,
        chi2_per_dof=(coordinate_sigma(found.baseline) / found.noise.sigma) ** 2,
    )


def _numbers(found: Diagnosed) -> tuple[int, ...] | None:
    """Return the numbers of the poses, by which events are placed in other rows of the series; None for no event."""
    final, numbers = found.final, found.final.problem.recording.numbers
    happens = any(t.happens for t in final.problem.acting(final.errors))
    return tuple(numbers.tolist()) if happens and numbers is not None else None


def _doubts(found: Diagnosed) -> list[str]:
    return [f"But {doubt}" for doubt in found.doubts]


def _instrument(found: Diagnosed, known: Instrument) -> InstrumentState:
    recording = found.final.problem.recording
    return known.kept(recording.setup_names, recording.measurement.zero, recording.columns)


def _correction(found: Diagnosed) -> SmoothCorrection | None:
    """Return the smooth correction: what it depends on, what it gains on held-out poses, and all that it needs.

    `machine` holds geometry, effects and instrument as they are beside it.
    """
    if found.correction is None:
        return None
    made, before, after = found.correction, *found.correction.heldout
    names = [p.name for p in found.final.problem.mechanism.parameters]
    robot = dataclasses.replace(found.robot, errors=dict(zip(names, made.errors.tolist(), strict=True)))
    excess = max(before**2 - found.noise.sigma**2, 1e-300)
    return SmoothCorrection(
        depends_on=tuple(smooth.variable for smooth in made.moving),
        limbs=tuple(i for smooth in made.moving for i in smooth.limbs),
        rms_mm=made.size,
        heldout_rms_mm=BeforeAfter(before=before, after=after),
        share_of_excess=float(np.clip((before**2 - after**2) / excess, 0.0, 1.0)),
        functions=_functions(found.final.problem, made),
        smooth=tuple(smooth.kept() for smooth in made.smooth),
        machine=MachineState(
            robot=kept_robot(robot),
            physics=tuple(map(kept_term, made.terms)),
            instrument=_instrument(found, made.instrument),
        ),
    )


def _residuals(found: Diagnosed) -> Residuals:
    """Return what every reading is off, before and after, where it was read and what the channels said there."""
    problem = found.final.problem
    rows = problem.readings.rows[:, 0]
    machine = found.final.machine
    channels = {name: values[rows] for name, values in problem.recording.told.items()}
    unit, q = problem.recording.joint_unit, problem.body.q[rows]
    channels |= zip(joint_names(unit, q.shape[1]), (q / joint_factors(unit, q.shape[1])).T, strict=True)
    return Residuals(
        line=problem.readings.line,
        position_mm=machine.x[rows, :3],
        before_mm=np.nan_to_num(found.baseline.residual[:, :3]),
        after_mm=np.nan_to_num(found.final.residual[:, :3]),
        channels=channels,
    )


def _effect(found: Named, problem: Problem, chance: Chance, clock: str) -> Effect:
    term, kernels, joint_unit = found.term.plain, found.term.kernels, problem.recording.joint_unit
    read = unrepeated(problem, term) if several(term.effect) and found.fundamental is None else {}
    parameters: list[EffectParameter] = []
    std = found.std.reshape(found.term.values.shape)[:, : found.term.own]
    for r, (row, units) in enumerate(zip(term.values, row_coefficients(term, joint_unit), strict=True)):
        for c, (name, unit, factor) in enumerate(units):
            parameters.append(
                EffectParameter(
                    name=name,
                    limb=term.limbs[r] if term.limbs else None,
                    value=float(row[c] / factor) if abs(row[c]) > ROUNDING * std[r, c] else 0.0,
                    std=float(std[r, c] / factor),
                    unit=unit,
                    tool_mm=term.tools[r] if term.tools else None,
                )
            )
    channel = kernels.SEARCHED.get("clocks", "")
    counts = str(term.constant(channel)) if channel else LOGGED
    for value, (name, unit, factor) in zip(term.constants, constants_of(term, joint_unit), strict=True):
        if value == LOGGED:
            continue  # a time constant in s says so
        unit = counts if counts != LOGGED and name in kernels.SIZED else unit
        unit = "row" if clock == "row" and name == kernels.SEARCHED.get("moments") else unit
        searched = name in kernels.SIZED or name in map(kernels.SEARCHED.get, SCATTERED)
        std_of = found.of_constant / factor if found.of_constant is not None and searched else None
        parameters.append(EffectParameter(name=name, limb=None, value=scaled(value, 1 / factor), std=std_of, unit=unit))
    return Effect(
        name=term.effect,
        title=kernels.TITLE,
        limbs=term.limbs,
        parameters=tuple(parameters),
        p_value=chance.of(found.score),
        gain_chi2=found.gain,
        share_of_excess=found.share,
        harmonic_of=None if found.fundamental is None else order_of(found.fundamental),
        indistinguishable_from=found.alike,
        instead_of_limb={str(limb): others for limb, others in found.elsewhere.items()} or None,
        read_deg={str(limb): (low / DEG, high / DEG) for limb, (low, high) in read.items()} or None,
    )


def _periodic(found: Diagnosed, spectrum: Spectrum) -> Effect:
    """Return the entry of periodic errors of many orders: what they come to, joint by joint."""
    kernels, gain = load_effect(wave()), sum(spectrum.gains.values())
    before, after = found.heldout
    removed = (before**2 - after**2) / max(before**2 - found.noise.sigma**2, 1e-300)
    joints = (
        EffectParameter(name="rms", limb=j, value=v / DEG, std=spectrum.std[j] / DEG, unit="deg")
        for j, v in spectrum.rms.items()
    )
    return Effect(
        name=wave(),
        title=kernels.TITLE,
        limbs=spectrum.limbs,
        parameters=(*joints, EffectParameter(name="corner", limb=None, value=spectrum.corner, std=None, unit="1")),
        orders=(1, len(spectrum.terms)),
        standing_out=tuple(
            StandingOrder(limb=j, order=s.order, amplitude_deg=s.amplitude / DEG, std_deg=s.std / DEG)
            for j, each in spectrum.standing.items()
            for s in each
        ),
        p_value=found.chance.of(gain - 2.0 * spectrum.corner * len(spectrum.limbs)),
        gain_chi2=gain,
        gain_by_limb={str(j): g for j, g in spectrum.gains.items()},
        share_of_excess=float(np.clip(removed, 0.0, 1.0)) * gain / (gain + sum(n.gain for n in found.effects)),
        indistinguishable_from=(),
    )


def _seen(spectrum: Spectrum) -> Seen:
    """Return between which angles of the turn each joint was read, and how near to them its error is still known."""
    return Seen(
        within_deg=180.0 / spectrum.corner,
        joints=tuple(SeenJoint(limb=j, angles_deg=tuple(spans)) for j, spans in spectrum.seen.items()),
    )


def _summary(found: Diagnosed) -> str:
    before, _ = found.heldout
    if found.lean:
        scalars, count = found.final.problem.readings.n_scalars, len(found.final.problem.names)
        return (
            f"No physics can be named: {scalars} readings carry the {count} parameters of {found.model} and leave "
            f"{scalars - count} to judge by; whatever is missing, the parameters take over. The fit leaves "
            f"{decimals(found.final.rms())} mm. Probe a mesh over the whole bed, and measure distances on a printed "
            "object."
        )
    if found.short:
        held_out = f"{decimals(before)} mm" if np.isfinite(before) else "too little to say"
        return (
            f"Nothing can be shown to be missing, but these poses are too few for {len(found.baseline.problem.names)} "
            f"parameters: on held-out readings the geometry leaves {held_out}, where the noise is "
            f"{decimals(found.noise.sigma)} mm. Measure more poses."
        )
    if found.verdict is Verdict.ADEQUATE:
        nothing = "Nothing" if _lasting(found) is None else "Nothing that was recorded"
        surely = "is proven to be missing" if _hinted(found) else "is missing"
        return (
            f"{nothing} {surely}: what the calibrated geometry leaves, {decimals(before)} mm on held-out readings, "
            f"{_as_noise(found)}. {_use_of(found)}{_hinted(found)}"
        )
    turned = f"It may be {found.turned}: compare the signs of that column first. " if found.turned else ""
    parts = []
    if found.spectrum is not None:
        where = at(found.robot, found.spectrum.limbs)
        parts.append(f"{load_effect(wave()).TITLE} of many orders ({wave()}){where}{_standing_out(found)}")
    parts += effects_in_words(found.effects, found.robot, found.final.problem) + _lawful(found)
    if found.verdict is Verdict.MISSING_PHYSICS:
        return (
            f"{turned}Geometry alone leaves {decimals(before)} mm on held-out readings. What is missing: "
            f"{'; '.join(parts)}. {_left_by(found)}{_alike(found.effects)}{_elsewhere(found)}{_hinted(found)}"
        )
    named = f" Proven beside it: {'; '.join(parts)}.{_elsewhere(found)}" if parts else ""
    mismatch = "As recorded, a mismatch" if turned else "A mismatch"
    return (
        f"{turned}{mismatch} of {decimals(found.final.rms())} mm is left that no registered effect explains: "
        f"{found.location.text}.{named}{_hinted(found)}{_unsought(found)} {_corrected(found)}"
    )


def _left_by(found: Diagnosed) -> str:
    """Return what is left with all that was found, and whether that is noise on held-out readings, too."""
    after = found.heldout[1]
    if not found.unsure:
        return f"With it {decimals(after)} mm are left: that {_as_noise(found)}."
    return (
        f"With it {decimals(found.final.rms())} mm are left of the readings that it was fitted to: that "
        f"{_as_noise(found)}. Of held-out readings {decimals(after)} mm are left: it is there, but more poses would "
        "tell it better."
    )


def _unsought(found: Diagnosed) -> str:
    """Return why no law was looked for where none is told; "" where one was."""
    if found.final.problem.readings.rows.shape[1] > 1:
        return " No law was looked for: of a distance between two poses either end may have moved; measure positions."
    if found.spectrum is not None:
        return " No law was looked for: an error of so many orders imitates any function of the pose."
    return ""


def _standing_out(found: Diagnosed) -> str:
    """Return which orders of each joint's periodic error stand out, with amplitudes and their deviations [deg]."""
    each = {} if found.spectrum is None else found.spectrum.standing
    told = [
        f"{place_of(found.robot, [j])} {', '.join(f'{s.order} ({_amplitude(s)})' for s in some[:MOST_TOLD])}"
        for j, some in each.items()
        if some
    ]
    return f", clearest at orders: {'; '.join(told)}" if told else ", at no order clearly"


def _amplitude(standing: Standing) -> str:
    return f"{' +- '.join(rounded(standing.amplitude / DEG, standing.std / DEG))} deg"


def _alike(effects: Sequence[Named]) -> str:
    """Return what these poses cannot tell apart, how little speaks for what is named, and what decides.

    What the sign of a column would decide is told before.
    """
    others = [(n, [name for name in n.alike if name not in n.turned]) for n in effects if n.fundamental is None]
    told = [
        f"{n.term.effect} from {' or '.join(alike)}" + (f" (odds {_odds(n.lead)} to 1 for it)" if n.rivals else "")
        for n, alike in others
        if alike
    ]
    return f" These poses cannot tell {'; '.join(told)}: what to measure next decides." if told else ""


def _elsewhere(found: Diagnosed) -> str:
    """Return at which limbs effects may be instead, as far as these poses go, and what would tell."""
    told = [
        f"{n.term.effect}{at(found.robot, [limb])} from one{at(found.robot, others)}"
        for n in found.effects
        for limb, others in n.elsewhere.items()
    ]
    return f" These poses do not tell {'; '.join(told)}: poses in which other joints turn, too, would." if told else ""


def _odds(lead: float) -> str:
    """Return the ratio of likelihoods, the charge for the search in them, that a lead of chi2 stands for."""
    odds = float(np.exp(lead / 2))
    return f"{odds:.2g}" if odds < MOST_ODDS else f"more than {MOST_ODDS:.0f}"


def _lawful(found: Diagnosed) -> list[str]:
    """Return the law that is borne out, in words."""
    if not found.laws:
        return []
    terms = []
    for t in found.laws[0].terms:
        terms.append(t.effect.removeprefix(PREFIX).replace(" = ", " moves by ") + at(found.robot, t.limbs))
    rivals = len(found.laws) - 1
    doubt = f" ({rivals} other law{'s' if rivals > 1 else ''} that these poses cannot tell from it)" if rivals else ""
    return [f"a law that nobody has registered: {' and '.join(terms)}{doubt}"]


def _hinted(found: Diagnosed) -> str:
    """Return what may be there all the same, as far as it earned its price.

    Where nothing else is missing the first is told though it did not quite, if chance hardly does as much.
    """
    calm = found.verdict is Verdict.ADEQUATE
    shown = [h for n, h in enumerate(found.hints) if h.earned or (calm and n == 0 and h.p_value <= WORTH_SAYING)]
    if not shown:
        return ""
    told = "; ".join(f"{h.name}{at(found.robot, h.limbs)} ({_doubtful(h)})" for h in shown[:MOST_TOLD])
    more = f" and {len(shown) - MOST_TOLD} more" if len(shown) > MOST_TOLD else ""
    several = len(shown) > 1
    why = f"earned {'their' if several else 'its'} price but {'are' if several else 'is'} not proven"
    why = why if all(h.earned for h in shown) else "is not proven"
    names = {h.name for h in shown}
    asked = [n for n in found.next_measurements if n.separates and n.separates[0] in names]
    decides = ": what to measure next would decide it"
    if asked and all(n.expected_chi2 is not None and not n.poses for n in asked):  # none promise enough
        which = "of this machine" if within_limits(found.final.problem) else "within what the joints have moved"
        decides = f", and poses {which} would not decide it"
    return f" There may {'' if calm else 'also '}be {told}{more}, which {why}{decides}."


def _doubtful(hint: Hint) -> str:
    """Return what else a hint may be, and how likely chance alone does as much."""
    others = f"or {' or '.join(hint.indistinguishable_from)}, " if hint.indistinguishable_from else ""
    return f"{others}p = {hint.p_value:.1g}"


def _as_noise(found: Diagnosed) -> str:
    """Return what entitles to take what is left for noise, or that nothing does."""
    if (lasting := _lasting(found)) is not None:
        timed = found.final.problem.recording.time_s is not None
        return (
            f"hangs together over {lasting.rows:.0f} of {lasting.rows_of_a_set_up:.0f} rows: no noise of readings, but "
            "something that moved on while they were taken (the instrument's stand, the base, the zero of a joint), "
            "and nothing that was recorded tells of it. Read one pose first, now and then, and last"
            f"{'' if timed else ', and write time_s'}"
        )
    together = noise_model(found.final, found.noise)
    hangs = "" if together.rho == 0 else f" that hangs together over {together.rows:.0f} rows"
    hangs += f" ({found.noise.rounded})" if found.noise.rounded else ""
    if found.noise.refuted is not None and found.noise.source is Source.RESIDUAL:
        return f"looks like noise{hangs}: no channel and no place carries more of it"
    if found.noise.source is Source.RESIDUAL:
        return (
            f"looks like noise{hangs}: no channel and no place carries more of it, but neither repeats nor a declared "
            "sigma_mm say how large noise is here"
        )
    return f"is noise{hangs}"


def _lasting(found: Diagnosed) -> Series | None:
    """Return how what is left hangs together where that lasts as long as the recording; None of noise of its own.

    An instrument whose noise is declared may wander within that.
    """
    series = found.final.repeats.series
    declared = found.noise.source is Source.DECLARED
    return series if isinstance(series, Series) and series.lasts and not declared else None


def _functions(problem: Problem, made: Correction) -> tuple[JointFunction, ...]:
    """Return what a correction says of each joint that goes with its own angle or travel, the strongest first."""
    mechanism = problem.mechanism
    names = joint_names(problem.recording.joint_unit, mechanism.limbs)
    out = []
    for smooth, moved in zip(made.moving, made.each, strict=True):
        if smooth.variable not in names or smooth.limbs != (names.index(smooth.variable) + 1,):
            continue
        limb, turns = smooth.limbs[0], mechanism.joint_units[smooth.limbs[0] - 1] == "rad"
        size, waves = smooth.waves()
        out.append(
            JointFunction(
                limb=limb,
                rms_mm=moved,
                joint_rms_deg=size / DEG if turns else None,
                joint_rms_mm=None if turns else size,
                orders=tuple(360.0 / v for v in waves) if turns else None,
                waves_mm=None if turns else waves,
            )
        )
    return tuple(sorted(out, key=lambda f: -f.rms_mm))


def _corrected(found: Diagnosed) -> str:
    made = found.correction
    if made is None:
        return "No smooth correction holds on held-out readings."
    before, after = made.heldout
    names = [smooth.variable for smooth in made.moving]
    on = POSITION if names == [POSITION] else f"the channel {names[0]}"
    where, most = f"{names[0]} is", ""
    if len(names) > 1:
        on, where = "functions that each joint has of its own angle or travel", "joints and position are"
        own = "; ".join(_waves(found.robot, f) for f in _functions(found.final.problem, made)[:MOST_TOLD])
        most = f" Most of it: {own}. No period is claimed over the range that was seen."
        if found.final.repeats.rows > 1:
            most += " Rows that follow one another are alike: only the same poses on another day tell joints from time."
    aside = ", gross errors left out," if len(found.final.gross) else ""
    judged = "readings held out row by row" if made.row_by_row else "held-out readings"  # or with their neighbours
    return (
        f"A smooth correction by {on}, without physics, lowers the error of {judged}{aside} from "
        f"{decimals(before)} to {decimals(after)} mm; predictions use it where {where} as in this recording.{most}"
    )


def _use_of(found: Diagnosed) -> str:
    """Return what to do with a machine to which nothing is missing."""
    asked = found.final.problem.names and not found.redrawn
    vain = needless(filed_rms(found.final), found.heldout[0]) if asked else ""
    return vain or "Use the calibrated machine."


def _waves(robot: Robot, own: JointFunction) -> str:
    if own.orders is not None:
        few = ", ".join(f"{order:.0f}" for order in own.orders[:MOST_TOLD])
        return f"{place_of(robot, [own.limb])} {own.joint_rms_deg:.4f} deg at about {few} waves a turn"
    few = ", ".join(f"{wave:.1f}" for wave in (own.waves_mm or ())[:MOST_TOLD])
    return f"{place_of(robot, [own.limb])} {own.joint_rms_mm:.4f} mm in waves of about {few} mm"
