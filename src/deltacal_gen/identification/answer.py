"""The answer of an identification as users read it: RESULT.json, in the units of files."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import BROAD
from deltacal_gen.estimation.residuals import lengths
from deltacal_gen.files.robot import kept_robot
from deltacal_gen.identification import identifiability
from deltacal_gen.identification.accuracy import distance_error, largest, volumetric_error
from deltacal_gen.identification.checks import doubted
from deltacal_gen.identification.drawing import doubts, in_file
from deltacal_gen.identification.noise import Noise, coordinate_sigma, freedom
from deltacal_gen.identification.outliers import gross_lines
from deltacal_gen.identification.prior import share_of_data
from deltacal_gen.identification.unknowns import Unknowns
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Robot
from deltacal_gen.physics.terms import kept_term
from deltacal_gen.results import result
from deltacal_gen.results.parts import Continued, Missing, Uncertainty
from deltacal_gen.units import DEG, file_unit, to_internal


@dataclass(frozen=True)
class Identification:
    """What a recording says of a robot.

    Attributes
    ----------
    model : str
    fit : Fit
        Of all readings.
    rough : Fit
        Of the encoder offsets alone.
    before_rms : float
        RMS of the residuals of the robot file's machine, the instrument and what the file does not say fitted [mm].
    heldout_rms : float
        RMS of readings in folds that took no part in the fit [mm].
    seen : Seen
        What the readings pin down.
    remedies : tuple of result.Remedy
        Extra measurements and how many of the free directions each pins.
    noise : Noise
        Of the readings, and where it is known from.
    robot : Robot
        The calibrated machine.
    in_file : (n_p,) array
        Source errors of the robot file, from which those found count.
    not_held : tuple of Missing
        Effects that belong to the session they were found in, and what this one lacks for them.
    continued : Continued or None
        What the readings told further of periodic errors that were held.
    map : result.UncertaintyMap or None
        Over the workspace, where the robot has one.
    uncertainty : Uncertainty
        Of parameters and instrument, errors that the model leaves out included.
    """

    model: str
    fit: Fit
    rough: Fit
    before_rms: float
    heldout_rms: float
    seen: identifiability.Seen
    remedies: tuple[result.Remedy, ...]
    noise: Noise
    robot: Robot
    in_file: Array
    not_held: tuple[Missing, ...]
    continued: Continued | None
    map: result.UncertaintyMap | None
    uncertainty: Uncertainty

    def answer(self) -> result.Result:
        """Return the same as users read it: RESULT.json."""
        final, problem, observed = self.fit, self.fit.problem, self.seen.observability
        sigma, residual_sigma = self.noise.sigma, coordinate_sigma(final)
        readings, recording = problem.readings, problem.recording
        unit, unknowns = final.instrument.unit(recording.columns), Unknowns(final)
        return result.Result(
            model=self.model,
            parameters=(*_parameters(self), *unknowns.parameters),
            rank=observed.rank,
            rank_tolerance=identifiability.RANK_TOLERANCE,
            singular_values=observed.singular_values,
            condition=observed.condition if np.isfinite(observed.condition) else None,
            scaling="columns in ordinary errors, rows in mm, unknown frame projected out, at the robot file's machine",
            unidentifiable=(*unknowns.combinations, *_open(self)),
            base=_base(self),
            next_measurements=(*unknowns.remedies, *self.remedies),
            regularisation=_regularisation(final),
            readings=result.Read(
                kind=problem.readings.kind.name,
                scalars=problem.readings.n_scalars,
                poses=len(np.unique(recording.pose)),
            ),
            before_rms_mm=self.before_rms,
            degrees_of_freedom=freedom(final),
            train_rms_mm=final.rms(),
            heldout_rms_mm=self.heldout_rms if np.isfinite(self.heldout_rms) else None,
            sigma_mm=self.noise.told,
            sigma_source=self.noise.source,
            residual_sigma_mm=residual_sigma,
            chi2_per_dof=(residual_sigma / sigma) ** 2 if sigma > 0 else None,
            gross_errors=gross_lines(final),
            stages=(_stage("rough", self.rough), _stage("fine", final)),
            accuracy=_accuracy(self),
            base_frame=_base_frames(final),
            contacts=final.instrument.kind.points(final.instrument, recording),
            workspace=self.map,
            iterations=len(final.history),
            physics=tuple(map(kept_term, problem.held)),
            physics_not_held=self.not_held,
            continued=self.continued,
            begun_s=problem.body.channels.begun,
            residuals=result.FitResiduals(
                line=readings.line,
                position_mm=final.machine.x[readings.rows[:, 0], :3],
                residual_mm=lengths(final.residual, readings.kind),
            ),
            instrument=final.instrument.kept(recording.setup_names, recording.measurement.zero, recording.columns),
            robot=kept_robot(self.robot),
            uncertainty=self.uncertainty,
            unit=unit and unit[0],
            unit_mm=unit and unit[1],
            doubts=(*final.unsettled, *doubts(final), *doubted(problem, final)) or None,
            motion=recording.motion,
        )


# -------------------------------------------------------------------------------------------------- RESULT.json


def _std(final: Fit) -> Array:
    """Return the standard deviations [mm, rad] of the free parameters, then of the instrument's unknowns."""
    std: Array = np.sqrt(np.maximum(np.diag(final.covariance), 0.0))
    return std


def _parameters(found: Identification) -> Iterator[result.Parameter]:
    """Yield all source errors of the mechanism, actual minus robot file; one that is not pinned has no deviation."""
    parameters, statuses = found.fit.problem.mechanism.parameters, _statuses(found)
    std = dict(zip(statuses, _std(found.fit), strict=False))
    for p, value in zip(parameters, found.fit.errors - found.in_file, strict=True):
        status = statuses.get(p.name, result.Status.FIXED)
        unknown = status in (result.Status.FIXED, result.Status.NOT_PINNED)
        yield result.Parameter(
            name=p.name,
            value=float(value) / to_internal(p.unit),
            std=None if unknown else float(std[p.name]) / to_internal(p.unit),
            unit=file_unit(p.unit),
            status=status,
            meaning=p.meaning,
        )


def _statuses(found: Identification) -> dict[str, result.Status]:
    """Return what is known of each free parameter."""
    final, out = found.fit, {}
    ruled_out = {name for c in (*found.seen.unseen, *found.seen.weak) for name in c.terms}
    by_prior, by_data = final.solution.posterior, share_of_data(final)
    for name, share in zip(final.problem.names, by_data, strict=True):
        known = share > identifiability.RESOLVED if by_prior else name not in ruled_out
        given = by_prior and name in final.problem.robot.tolerance
        out[name] = result.Status.IDENTIFIED if known else result.Status.BY_PRIOR if given else result.Status.NOT_PINNED
    return out


def _base(found: Identification) -> tuple[result.BaseParameter, ...]:
    """Return the base parameters with values and standard deviations, where single parameters have none."""
    problem, n = found.fit.problem, len(found.fit.problem.names)
    values = (found.fit.errors - problem.reference)[problem.columns[:n]]
    units = {p.name: p.unit for p in problem.mechanism.parameters}
    entries = []
    for name, terms in found.seen.base.items():
        share, unit = np.array([terms.get(other, 0.0) for other in problem.names]), to_internal(units[name])
        std = float(np.sqrt(max(share @ found.fit.covariance[:n, :n] @ share, 0.0)))
        entries.append(
            result.BaseParameter(
                name=name,
                combination=identifiability.sum_of(terms, units),
                value=float(share @ values) / unit,
                std=std / unit,
                unit=file_unit(units[name]),
            )
        )
    return tuple(entries)


def _open(found: Identification) -> Iterator[result.OpenCombination]:
    """Yield the combinations of parameters that readings do not determine, in the units of files."""
    units = {p.name: to_internal(p.unit) for p in found.fit.problem.mechanism.parameters}
    degrees: tuple[Literal["not at all", "less than noise"], ...] = ("not at all", "less than noise")
    for degree, several in zip(degrees, (found.seen.unseen, found.seen.weak), strict=True):
        for c in several:
            yield result.OpenCombination(seen=degree, text=c.text, terms={n: v / units[n] for n, v in c.terms.items()})


def _regularisation(final: Fit) -> result.Regularisation:
    if not final.solution.posterior:
        return result.Regularisation(rule=final.solution.rule)
    names = final.problem.names
    given = sum(name in final.problem.robot.tolerance for name in names)
    return result.Regularisation(
        rule=f"priors: {given} from [tolerance], {len(names) - given} broad ({BROAD:g} ordinary errors)",
        determined=final.solution.degrees,
    )


def _stage(name: Literal["rough", "fine"], at: Fit) -> result.Stage:
    return result.Stage(stage=name, parameters=len(at.problem.names), iterations=len(at.history), train_rms_mm=at.rms())


def _accuracy(found: Identification) -> result.Accuracy | None:
    """Return the paper's two error measures of the measured positions, before and after; home is the most central."""
    problem, final, readings = found.fit.problem, found.fit, found.fit.problem.readings
    if not readings.kind.positions or np.isnan(readings.values).all(axis=0).any():
        return None
    chosen = np.setdiff1d(np.arange(len(readings)), final.gross)
    chosen = chosen[readings.setup[chosen] == readings.setup[chosen[0]]]
    measured, rows = np.nan_to_num(readings.values[chosen]), readings.rows[chosen, 0]
    home = int(np.argmin(np.linalg.norm(measured - np.median(measured, axis=0), axis=1)))

    def at(errors: Array) -> result.Largest:
        wanted = problem.poses(errors)[rows, :3]
        return result.Largest(
            distance_mm=largest(distance_error(measured, wanted, home)),
            volumetric_mm=largest(volumetric_error(measured, wanted, home)),
        )

    return result.Accuracy(
        home_line=int(readings.line[chosen[home]]),
        note="largest errors relative to home; the distance error is the same in every frame, the volumetric error "
        "is taken after the rotation that fits the two sets best",
        before=at(in_file(final)),
        rough=at(found.rough.errors) if len(found.rough.problem.names) < len(problem.names) else None,
        after=at(final.errors),
    )


def _base_frames(final: Fit) -> tuple[result.BaseFrame, ...]:
    """Return where {O} stands in the instrument's frame, set-up by set-up, with standard deviations."""
    instrument, n = final.instrument, len(final.problem.names)
    frames = instrument.frames()
    if not {3, 4} <= {*instrument.free} or not frames:
        return ()
    std = np.zeros((len(instrument.state), 9))  # zero: not estimated, because no reading depends on it
    std[:, list(instrument.free)] = _std(final)[n:].reshape(len(std), -1)
    return tuple(
        result.BaseFrame(
            setup=final.problem.recording.setup_names[s],
            rotation_deg=tuple((turn / DEG).tolist()),
            rotation_std_deg=tuple((std[s, :3] / DEG).tolist()),
            origin_mm=tuple(origin.tolist()),
            origin_std_mm=tuple(std[s, 3:6].tolist()),
        )
        for s, (turn, origin) in enumerate(frames)
    )
