"""DIAGNOSIS.json of what was found, and the same in words."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from deltacal_gen.diagnosis import words
from deltacal_gen.diagnosis.chance import Chance
from deltacal_gen.diagnosis.charges import several
from deltacal_gen.diagnosis.conclusion import Conclusion, Named
from deltacal_gen.diagnosis.correction import Correction
from deltacal_gen.diagnosis.discrimination import more_poses
from deltacal_gen.diagnosis.findings import share_removed
from deltacal_gen.diagnosis.harmonics import order_of, unrepeated
from deltacal_gen.diagnosis.laws.told import told
from deltacal_gen.diagnosis.partial import most_moved, partial_residuals
from deltacal_gen.diagnosis.refits import terms_of
from deltacal_gen.diagnosis.search import SCATTERED
from deltacal_gen.diagnosis.selection import Hypothesis
from deltacal_gen.diagnosis.spectrum import Spectrum
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.files.robot import kept_robot
from deltacal_gen.identification.knowledge import uncertainty_of
from deltacal_gen.identification.noise import coordinate_sigma, noise_model
from deltacal_gen.identification.orders import wave
from deltacal_gen.identification.outliers import gross_lines
from deltacal_gen.identification.unknowns import Unknowns
from deltacal_gen.instrument.kind import Instrument
from deltacal_gen.machine.places import at
from deltacal_gen.machine.values import Robot
from deltacal_gen.physics.terms import (
    LOGGED,
    Term,
    constants_of,
    kept_term,
    load_effect,
    row_coefficients,
    scaled,
)
from deltacal_gen.results import diagnosis as results
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.parts import InstrumentState, MachineState
from deltacal_gen.units import DEG, joint_factors, joint_names

SHOWN = 5  # hypotheses
ROUNDING = 1e-9  # of a standard deviation: less, of what no reading sees, is none


@dataclass(frozen=True)
class Diagnosed(Conclusion):
    """What a diagnosis concludes; `answer` gives the same as users read it."""

    def answer(self) -> Diagnosis:
        """Return the same as users read it, DIAGNOSIS.json: figures in mm, curves and wording among them."""
        final, sigma, recording = self.final, self.noise.sigma, self.final.problem.recording
        before, after = (heldout if np.isfinite(heldout) else None for heldout in self.heldout)
        unit, unknowns = final.instrument.unit(recording.columns), Unknowns(final)
        clock: Literal["time_s", "row"] = "row" if final.problem.body.channels.get("time") is None else "time_s"
        effects = [(_effect(n, final, self.chance, clock), _finding(n, self.effects)) for n in self.effects]
        if self.spectrum is not None:
            effects.insert(0, (_periodic(self, self.spectrum), list(self.spectrum.terms)))
        answer = Diagnosis(
            verdict=self.verdict,
            summary="",
            noise=results.NoiseLevel(
                sigma_mm=self.noise.told, source=self.noise.source, model=noise_model(final, self.noise)
            ),
            baseline=results.Baseline(
                model=self.model,
                parameters=len(final.problem.mechanism.model(self.model)),
                train_rms_mm=self.baseline.rms(),
                heldout_rms_mm=before,
                chi2_per_dof=(coordinate_sigma(self.baseline) / sigma) ** 2,
            ),
            location=self.location,
            effects=tuple(effect for effect, _ in effects),
            search=results.Searched(
                best=self.chance.best, p_value=self.chance.p_value, hypotheses=_hypotheses(self.hypotheses, self.robot)
            ),
            final=results.Final(
                train_rms_mm=final.rms(), heldout_rms_mm=after, chi2_per_dof=(coordinate_sigma(final) / sigma) ** 2
            ),
            rejected=self.rejected,
            hints=self.hints,
            not_tested=self.not_tested,
            next_measurements=(
                *self.next_measurements,
                *unknowns.next_measurements,
                *([more_poses(final.problem)] if self.short else []),
            ),
            gross_errors=gross_lines(final),
            correction=None if self.correction is None else _correction(self, self.correction),
            residuals=_residuals(self, effects),
            sigma_mm=self.noise.told,
            physics=tuple(map(kept_term, final.problem.acting(final.errors))),
            seen=None if self.spectrum is None else _seen(self.spectrum),
            clock=clock,
            begun_s=final.problem.body.channels.begun,
            poses=_numbers(final) if clock == "row" else None,
            instrument=_instrument(final, final.instrument),
            robot=kept_robot(self.robot),
            uncertainty=uncertainty_of(final, self.noise),
            unit=unit and unit[0],
            unit_mm=unit and unit[1],
            parameters=unknowns.parameters or None,
            turned=self.turned or None,
            motion=recording.motion,
            laws=told(self.laws, final),
        )
        return answer.replace(summary=words.summary(self, answer))


def _numbers(final: Fit) -> tuple[int, ...] | None:
    """Return the numbers of the poses, by which events are placed in other rows of the series; None for no event."""
    happens, numbers = any(t.happens for t in final.problem.acting(final.errors)), final.problem.recording.numbers
    return tuple(numbers.tolist()) if happens and numbers is not None else None


def _instrument(final: Fit, known: Instrument) -> InstrumentState:
    recording = final.problem.recording
    return known.kept(recording.setup_names, recording.measurement.zero, recording.columns)


def _correction(found: Diagnosed, made: Correction) -> results.SmoothCorrection:
    """Return the smooth correction: what it depends on, what it gains on held-out poses, and all that it needs.

    `machine` holds geometry, effects and instrument as they are beside it.
    """
    at, names = made.fitted, [p.name for p in found.final.problem.mechanism.parameters]
    robot = dataclasses.replace(found.robot, errors=dict(zip(names, at.errors.tolist(), strict=False)))
    return results.SmoothCorrection(
        depends_on=tuple(smooth.variable for smooth in made.moving),
        limbs=tuple(i for smooth in made.moving for i in smooth.limbs),
        rms_mm=made.size,
        heldout_rms_mm=results.BeforeAfter(before=made.heldout[0], after=made.heldout[1]),
        share_of_excess=share_removed(made.heldout, found.noise.sigma),
        functions=_functions(found.final.problem, made),
        smooth=made.smooth,
        machine=MachineState(
            robot=kept_robot(robot),
            physics=tuple(map(kept_term, at.problem.acting(at.errors))),
            instrument=_instrument(found.final, at.instrument),
        ),
    )


def _functions(problem: Problem, made: Correction) -> tuple[results.JointFunction, ...]:
    """Return what a correction says of each joint that goes with its own angle or travel, the strongest first."""
    out, names = [], joint_names(problem.recording.joint_unit, problem.mechanism.limbs)
    for smooth, moved in sorted(zip(made.moving, made.each, strict=True), key=lambda pair: -pair[1]):
        if [names[i - 1] for i in smooth.limbs] == [smooth.variable]:
            (limb,), (size, waves) = smooth.limbs, smooth.waves()
            by_angle = {"joint_rms_deg": size / DEG, "orders": tuple(360.0 / v for v in waves)}
            by_travel = {"joint_rms_mm": size, "waves_mm": waves}
            nothing: dict[str, Any] = dict.fromkeys((*by_angle, *by_travel))
            own = by_angle if problem.mechanism.joint_units[limb - 1] == "rad" else by_travel
            out.append(results.JointFunction(limb=limb, rms_mm=moved, **nothing | own))
    return tuple(out)


def _residuals(found: Diagnosed, effects: Sequence[tuple[results.Effect, Sequence[Term]]]) -> results.Residuals:
    """Return what every reading is off, before and after, where it was read and what the channels said there."""
    final, problem = found.final, found.final.problem
    rows, unit = problem.readings.rows[:, 0], problem.recording.joint_unit
    channels = {name: values[rows] for name, values in problem.recording.told.items()}
    q, n = problem.body.q[rows], problem.mechanism.limbs
    channels |= zip(joint_names(unit, n), (q / joint_factors(unit, n)).T, strict=True)
    before, after = (np.nan_to_num(at.residual[:, :3]) for at in (found.baseline, final))
    strongest = max(effects, key=lambda e: e[0].share_of_excess, default=None)
    limbs = found.location.limbs if strongest is None else strongest[0].limbs
    return results.Residuals(
        line=problem.readings.line,
        position_mm=final.machine.x[rows, :3],
        before_mm=before,
        after_mm=after,
        channels=channels,
        partial=partial_residuals(final, before, after, strongest and (strongest[0].name, strongest[1]), limbs),
    )


def _finding(one: Named, effects: Sequence[Named]) -> list[Term]:
    """Return the terms of the finding that an effect is part of: a periodic error with its harmonics."""
    first = one.fundamental or one.term
    return [n.term for n in effects if first is n.term or first is n.fundamental]


def _effect(found: Named, final: Fit, chance: Chance, clock: str) -> results.Effect:
    term, problem = found.term, final.problem
    read = unrepeated(problem, term) if several(term.effect) and found.fundamental is None else {}
    return results.Effect(
        name=term.effect,
        title=term.kernels.TITLE,
        limbs=term.limbs,
        parameters=(*_coefficients(found, problem), *_constants(found, problem, clock)),
        p_value=chance.of(found.score),
        gain_chi2=found.gain,
        share_of_excess=found.share,
        harmonic_of=None if found.fundamental is None else order_of(found.fundamental),
        indistinguishable_from=found.alike,
        instead_of_limb={str(limb): others for limb, others in found.elsewhere.items()} or None,
        read_deg={str(limb): (low / DEG, high / DEG) for limb, (low, high) in read.items()} or None,
        moves_mm=most_moved(final, [term]),
        advice=term.kernels.ADVICE,
    )


def _coefficients(found: Named, problem: Problem) -> list[results.EffectParameter]:
    term = found.term.plain
    std = found.std.reshape(found.term.values.shape)[:, : found.term.own]
    values = np.where(np.abs(term.values) > ROUNDING * std, term.values, 0.0)
    return [
        results.EffectParameter(
            name=name,
            limb=term.limbs[r] if term.limbs else None,
            value=float(values[r, c] / factor),
            std=float(std[r, c] / factor),
            unit=unit,
            tool_mm=term.tools[r] if term.tools else None,
        )
        for r, row in enumerate(row_coefficients(term, problem.recording.joint_unit))
        for c, (name, unit, factor) in enumerate(row)
    ]


def _constants(found: Named, problem: Problem, clock: str) -> Iterator[results.EffectParameter]:
    term, kernels = found.term.plain, found.term.kernels
    channel = kernels.SEARCHED.get("clocks", "")
    counts = str(term.constant(channel)) if channel else LOGGED
    searched = {*kernels.SIZED, *map(kernels.SEARCHED.get, SCATTERED)}
    for value, (name, unit, factor) in zip(
        term.constants, constants_of(term, problem.recording.joint_unit), strict=True
    ):
        if value == LOGGED:
            continue  # a time constant in s says so
        unit = counts if counts != LOGGED and name in kernels.SIZED else unit
        unit = "row" if clock == "row" and name == kernels.SEARCHED.get("moments") else unit
        std = found.of_constant / factor if found.of_constant is not None and name in searched else None
        yield results.EffectParameter(name=name, limb=None, value=scaled(value, 1 / factor), std=std, unit=unit)


def _periodic(found: Diagnosed, spectrum: Spectrum) -> results.Effect:
    """Return the entry of periodic errors of many orders: what they come to, joint by joint."""
    gain, named = sum(spectrum.gains.values()), sum(n.gain for n in found.effects)
    joints = (
        results.EffectParameter(name="rms", limb=j, value=v / DEG, std=spectrum.std[j] / DEG, unit="deg")
        for j, v in spectrum.rms.items()
    )
    corner = results.EffectParameter(name="corner", limb=None, value=spectrum.corner, std=None, unit="1")
    return results.Effect(
        name=wave(),
        title=load_effect(wave()).TITLE,
        limbs=spectrum.limbs,
        parameters=(*joints, corner),
        orders=(1, len(spectrum.terms)),
        standing_out=tuple(
            results.StandingOrder(limb=j, order=s.order, amplitude_deg=s.amplitude / DEG, std_deg=s.std / DEG)
            for j, each in spectrum.standing.items()
            for s in each
        ),
        p_value=found.chance.of(gain - 2.0 * spectrum.corner * len(spectrum.limbs)),
        gain_chi2=gain,
        gain_by_limb={str(j): g for j, g in spectrum.gains.items()},
        share_of_excess=share_removed(found.heldout, found.noise.sigma) * gain / (gain + named),
        indistinguishable_from=(),
        moves_mm=most_moved(found.final, spectrum.terms),
        advice=load_effect(wave()).ADVICE,
    )


def _seen(spectrum: Spectrum) -> results.Seen:
    """Return between which angles of the turn each joint was read, and how near to them its error is still known."""
    return results.Seen(
        within_deg=180.0 / spectrum.corner,
        joints=tuple(results.SeenJoint(limb=j, angles_deg=tuple(spans)) for j, spans in spectrum.seen.items()),
    )


def _hypotheses(weighed: Sequence[Hypothesis], robot: Robot) -> tuple[results.Hypothesis, ...]:
    """Return the most probable hypotheses of a search, with what each costs above the first."""
    return tuple(
        results.Hypothesis(
            effects=tuple(t.effect + at(robot, t.limbs) for t in terms_of(h.fit)),
            correlated=not h.fit.repeats.plain,
            cost_chi2=h.cost - weighed[0].cost,
            moves=h.moves,
        )
        for h in weighed[:SHOWN]
        if np.isfinite(h.cost)
    )
