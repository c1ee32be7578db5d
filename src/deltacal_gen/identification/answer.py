"""The answer of an identification as users read it: RESULT.json, in the units of files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import BROAD
from deltacal_gen.estimation.residuals import lengths
from deltacal_gen.files.robot import kept_robot
from deltacal_gen.identification import identifiability
from deltacal_gen.identification.accuracy import distance_error, largest, volumetric_error
from deltacal_gen.identification.checks import doubted, gross_lines
from deltacal_gen.identification.drawing import doubts, in_file
from deltacal_gen.identification.identifiability import Combination
from deltacal_gen.identification.noise import Noise, coordinate_sigma, freedom
from deltacal_gen.identification.prior import share_of_data
from deltacal_gen.identification.unknowns import unknowns_of
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.values import Robot
from deltacal_gen.physics.terms import kept_term
from deltacal_gen.results.parts import Continued, Missing, Uncertainty
from deltacal_gen.results.result import (
    Accuracy,
    BaseFrame,
    BaseParameter,
    FitResiduals,
    Largest,
    OpenCombination,
    Parameter,
    Read,
    Regularisation,
    Remedy,
    Result,
    Stage,
    Status,
    UncertaintyMap,
)
from deltacal_gen.units import DEG, file_unit, to_internal

RESOLVED = 0.5  # of a parameter's variance that comes from directions the data know better than the prior


@dataclass(frozen=True)
class Identification:
    """What a recording says of a robot.

    Attributes
    ----------
    model : str
    fit : Fit
        Of all readings.
    rough : Fit or None
        Of the encoder offsets alone.
    before_rms : float
        RMS of the residuals of the robot file's machine, the instrument and what the file does not say fitted [mm].
    heldout_rms : float
        RMS of readings in folds that took no part in the fit [mm].
    observability : Observability
        Of the identification matrix at the robot file's machine, columns in ordinary errors.
    unseen, weak : list of Combination
        What no reading sees, and what the readings see less well than a broad prior.
    base : list of BaseParameter
        What the readings determine, parameter by parameter with those that act through it.
    remedies : tuple of Remedy
        Extra measurements and how many of the free directions each pins.
    noise : Noise
        Of the readings, and where it is known from.
    prior_given : tuple of bool
        Of each parameter: whether the robot file's ``[tolerance]`` names it.
    robot : Robot
        The calibrated machine.
    in_file : (n_p,) array
        Source errors of the robot file, from which those found count.
    not_held : tuple of Missing
        Effects that belong to the session they were found in, and what this one lacks for them.
    continued : Continued or None
        What the readings told further of periodic errors that were held.
    map : UncertaintyMap or None
        Over the workspace, where the robot has one.
    uncertainty : Uncertainty
        Of parameters and instrument, errors that the model leaves out included.
    """

    model: str
    fit: Fit
    rough: Fit | None
    before_rms: float
    heldout_rms: float
    observability: identifiability.Observability
    unseen: list[Combination]
    weak: list[Combination]
    base: list[identifiability.BaseParameter]
    remedies: tuple[Remedy, ...]
    noise: Noise
    prior_given: tuple[bool, ...]
    robot: Robot
    in_file: Array
    not_held: tuple[Missing, ...]
    continued: Continued | None
    map: UncertaintyMap | None
    uncertainty: Uncertainty

    def answer(self) -> Result:
        """Return the same as users read it: RESULT.json."""
        return result_of(self)


# -------------------------------------------------------------------------------------------------- RESULT.json


def parameter_table(
    mechanism: Machine, change: Array, status: Mapping[str, Status], deviation: Array
) -> tuple[Parameter, ...]:
    """Return the parameters of a result: all source errors of a mechanism, in the units of files.

    Parameters
    ----------
    change : (n_p,) array
        Actual minus robot file [mm, rad].
    status : mapping
        Of the parameters that were free, by their names.
    deviation : (n,) array
        Their standard deviations [mm, rad], in the order of `status`; one that is not pinned has none.
    """
    std = {name: float(d) for (name, s), d in zip(status.items(), deviation, strict=True) if s is not Status.NOT_PINNED}
    return tuple(
        Parameter(
            name=p.name,
            value=float(value) / to_internal(p.unit),
            std=std[p.name] / to_internal(p.unit) if p.name in std else None,
            unit=file_unit(p.unit),
            status=status.get(p.name, Status.FIXED),
            meaning=p.meaning,
        )
        for p, value in zip(mechanism.parameters, change, strict=True)
    )


def _residuals(final: Fit) -> FitResiduals:
    readings = final.problem.readings
    return FitResiduals(
        line=readings.line,
        position_mm=final.machine.x[readings.rows[:, 0], :3],
        residual_mm=lengths(final.residual, readings.kind),
    )


def result_of(found: Identification) -> Result:
    """Return what was identified as RESULT.json says it."""
    final, problem = found.fit, found.fit.problem
    mechanism, n = problem.mechanism, len(problem.names)
    deviation = np.sqrt(np.maximum(np.diag(final.covariance)[:n], 0.0))
    sigma, recording = found.noise.sigma, problem.recording
    residual_sigma = coordinate_sigma(final)
    unit, unknowns = final.instrument.unit(recording.columns), unknowns_of(final)
    return Result(
        model=found.model,
        parameters=(
            *parameter_table(mechanism, final.errors - found.in_file, _statuses(found), deviation),
            *unknowns.parameters,
        ),
        rank=found.observability.rank,
        rank_tolerance=identifiability.RANK_TOLERANCE,
        singular_values=found.observability.singular_values,
        condition=found.observability.condition if np.isfinite(found.observability.condition) else None,
        scaling="columns in ordinary errors, rows in mm, unknown frame projected out, at the robot file's machine",
        unidentifiable=(
            *unknowns.combinations,
            *open_combinations(found.unseen, mechanism, "not at all"),
            *open_combinations(found.weak, mechanism, "less than noise"),
        ),
        base=_base(found),
        next_measurements=(*unknowns.remedies, *found.remedies),
        regularisation=_regularisation(found),
        readings=Read(
            kind=problem.readings.kind.name, scalars=problem.readings.n_scalars, poses=len(np.unique(recording.pose))
        ),
        before_rms_mm=found.before_rms,
        degrees_of_freedom=freedom(final),
        train_rms_mm=final.rms(),
        heldout_rms_mm=found.heldout_rms if np.isfinite(found.heldout_rms) else None,
        sigma_mm=found.noise.told,
        sigma_source=found.noise.source,
        residual_sigma_mm=residual_sigma,
        chi2_per_dof=(residual_sigma / sigma) ** 2 if sigma > 0 else None,
        gross_errors=gross_lines(final),
        stages=_stages(found),
        accuracy=_accuracy(found),
        base_frame=_base_frames(found),
        contacts=final.instrument.kind.points(final.instrument, recording),
        workspace=found.map,
        iterations=len(final.history),
        physics=tuple(map(kept_term, problem.held)),
        physics_not_held=found.not_held,
        continued=found.continued,
        begun_s=problem.body.channels.begun,
        residuals=_residuals(final),
        instrument=final.instrument.kept(recording.setup_names, recording.measurement.zero, recording.columns),
        robot=kept_robot(found.robot),
        uncertainty=found.uncertainty,
        unit=unit and unit[0],
        unit_mm=unit and unit[1],
        doubts=(*doubts(final), *doubted(problem, final)) or None,
        motion=recording.motion,
    )


def _statuses(found: Identification) -> dict[str, Status]:
    """Return what is known of each parameter."""
    final, out = found.fit, {}
    ruled_out = {name for c in (*found.unseen, *found.weak) for name in c.terms}
    by_prior, by_data = final.solution.posterior, share_of_data(final)
    for j, name in enumerate(final.problem.names):
        known = by_data[j] > RESOLVED if by_prior else name not in ruled_out
        given = by_prior and found.prior_given[j]
        out[name] = Status.IDENTIFIED if known else Status.BY_PRIOR if given else Status.NOT_PINNED
    return out


def _base(found: Identification) -> tuple[BaseParameter, ...]:
    """Return the base parameters with values and standard deviations, where single parameters have none."""
    problem, n = found.fit.problem, len(found.fit.problem.names)
    values = (found.fit.errors - problem.reference)[problem.columns[:n]]
    entries = []
    for b in found.base:
        unit = problem.mechanism.parameters[problem.mechanism.index[b.name]].unit
        share = np.array([b.terms.get(name, 0.0) for name in problem.names])
        std = float(np.sqrt(max(share @ found.fit.covariance[:n, :n] @ share, 0.0)))
        entries.append(
            BaseParameter(
                name=b.name,
                combination=b.text,
                value=float(share @ values) / to_internal(unit),
                std=std / to_internal(unit),
                unit=file_unit(unit),
            )
        )
    return tuple(entries)


def open_combinations(
    several: Sequence[Combination], mechanism: Machine, seen: Literal["not at all", "less than noise"]
) -> tuple[OpenCombination, ...]:
    """Return combinations of parameters that readings do not determine, in the units of files."""
    units = {p.name: to_internal(p.unit) for p in mechanism.parameters}
    return tuple(
        OpenCombination(seen=seen, text=c.text, terms={n: v / units[n] for n, v in c.terms.items()}) for c in several
    )


def _regularisation(found: Identification) -> Regularisation:
    if not found.fit.solution.posterior:
        return Regularisation(rule=found.fit.solution.rule)
    given = sum(found.prior_given)
    return Regularisation(
        rule=f"priors: {given} from [tolerance], {len(found.prior_given) - given} broad ({BROAD:g} ordinary errors)",
        determined=found.fit.solution.degrees,
    )


def _stages(found: Identification) -> tuple[Stage, ...]:
    stages: tuple[tuple[Literal["rough", "fine"], Fit | None], ...] = (("rough", found.rough), ("fine", found.fit))
    return tuple(
        Stage(stage=name, parameters=len(f.problem.names), iterations=len(f.history), train_rms_mm=f.rms())
        for name, f in stages
        if f is not None
    )


def _accuracy(found: Identification) -> Accuracy | None:
    """Return the paper's two error measures of the measured positions, before and after; home is the most central."""
    problem, final = found.fit.problem, found.fit
    if not problem.readings.kind.positions or np.isnan(problem.readings.values).all(axis=0).any():
        return None
    chosen = np.setdiff1d(np.arange(len(problem.readings)), final.gross)
    chosen = chosen[problem.readings.setup[chosen] == problem.readings.setup[chosen[0]]]
    measured, rows = np.nan_to_num(problem.readings.values[chosen]), problem.readings.rows[chosen, 0]
    home = int(np.argmin(np.linalg.norm(measured - np.median(measured, axis=0), axis=1)))

    def at(errors: Array) -> Largest:
        wanted = problem.poses(errors)[rows, :3]
        return Largest(
            distance_mm=largest(distance_error(measured, wanted, home)),
            volumetric_mm=largest(volumetric_error(measured, wanted, home)),
        )

    return Accuracy(
        home_line=int(problem.readings.line[chosen[home]]),
        note="largest errors relative to home; the distance error is the same in every frame, the volumetric error "
        "is taken after the rotation that fits the two sets best",
        before=at(in_file(final)),
        rough=at(found.rough.errors) if found.rough and len(found.rough.problem.names) < len(problem.names) else None,
        after=at(final.errors),
    )


def _base_frames(found: Identification) -> tuple[BaseFrame, ...]:
    """Return where {O} stands in the instrument's frame, set-up by set-up, with standard deviations."""
    instrument, n = found.fit.instrument, len(found.fit.problem.names)
    frames = instrument.frames()
    if not {3, 4} <= {*instrument.free} or not frames:
        return ()
    std = np.zeros((len(instrument.state), 9))  # zero: not estimated, because no reading depends on it
    std[:, list(instrument.free)] = np.sqrt(np.maximum(np.diag(found.fit.covariance)[n:], 0.0)).reshape(len(std), -1)
    return tuple(
        BaseFrame(
            setup=found.fit.problem.recording.setup_names[s],
            rotation_deg=tuple((turn / DEG).tolist()),
            rotation_std_deg=tuple((std[s, :3] / DEG).tolist()),
            origin_mm=tuple(origin.tolist()),
            origin_std_mm=tuple(std[s, 3:6].tolist()),
        )
        for s, (turn, origin) in enumerate(frames)
    )
