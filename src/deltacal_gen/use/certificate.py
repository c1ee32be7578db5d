"""What is certified of a calibrated machine: errors before and after, and an uncertainty budget.

The measurand is the difference between a reading and what the calibrated machine is predicted to read there: of it the
validation gives one value for each reading, and the Guide to the expression of uncertainty in measurement (GUM, JCGM
100:2008) says how surely. Its parts are independent; a line of the budget is the root mean square of one over all
readings of the validation.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal, NamedTuple

import numpy as np

from deltacal_gen.estimation.residuals import lengths, rms
from deltacal_gen.instrument.kind import Readings
from deltacal_gen.instrument.kinds import readings
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.factors import HELD, quantile
from deltacal_gen.results.certificate import Budget, Condition, Contribution, Errors
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.parts import MachineState, Source
from deltacal_gen.results.result import Result, Status
from deltacal_gen.results.validation import Validation
from deltacal_gen.states import RECORDED
from deltacal_gen.use import bands
from deltacal_gen.use.prediction import Place, calibrated_robot, predict, residual
from deltacal_gen.use.validation import error_sizes, has_place, validate


class Checked(NamedTuple):
    """A calibration held against readings that it has not seen."""

    validation: Validation
    before: Errors
    after: Errors
    budget: Budget


def check(result: Result | Diagnosis, recording: Recording) -> Checked:
    """Return the errors of a machine before and after its calibration, with the uncertainty budget.

    Raises
    ------
    InputError
        The result keeps no uncertainty, or the readings leave open where the instrument stands.
    """
    bands.known_of(result)
    validation = validate(result, recording)
    found = readings(recording)
    placed = frozenset(p.setup for p in validation.placed or ())
    place = Place(recording, found, placed) if placed else None
    r = residual(result, recording, found, place)
    drawn = _as_drawn(result)
    anew = Place(recording, found, frozenset(recording.setup_names)) if has_place(drawn, recording, found) else None
    return Checked(
        validation,
        _errors("as drawn", found, residual(drawn, recording, found, anew)),
        _errors("calibrated", found, r).replace(rms_mm=validation.rms_mm, worst_mm=validation.worst_mm),
        _budget(
            result,
            recording,
            found,
            np.delete(r, found.kind.turned, axis=1),
            place,
            sum(p.unknowns for p in validation.placed or ()),
        ),
    )


def conditions(recording: Recording) -> tuple[Condition, ...]:
    """Return between which values the channels stood that say how it was measured."""
    ranges = ((s, recording.channels.get(s.column)) for s in RECORDED if s.per == "machine")
    return tuple(
        Condition(name=s.called, low=float(np.nanmin(v)), high=float(np.nanmax(v)), unit=s.unit)
        for s, v in ranges
        if v is not None and np.isfinite(v).any()
    )


def model_of(result: Result | Diagnosis) -> str:
    """Return the model that was fitted."""
    return result.baseline.model if isinstance(result, Diagnosis) else result.model


def _as_drawn(result: Result | Diagnosis) -> MachineState:
    """Return the machine as its robot file has it; of a diagnosis, which does not keep that, without any errors."""
    errors: dict[str, float] = {}
    if isinstance(result, Result):
        index = mechanism_of(calibrated_robot(result)).index
        moved = {p.name: p.value for p in result.parameters if p.status is not Status.FIXED and p.name in index}
        errors = {name: value - moved.get(name, 0.0) for name, value in (result.robot.errors or {}).items()}
    return MachineState(robot=result.robot.replace(errors=errors), physics=(), instrument=result.instrument)


def _errors(of: Literal["as drawn", "calibrated"], found: Readings, r: Array) -> Errors:
    size = error_sizes(r, found.kind)
    return Errors(of=of, rms_mm=_rms(lengths(r, found.kind)), mean_mm=float(size.mean()), worst_mm=float(size.max()))


def _rms(values: Array) -> float:
    return float(np.nan_to_num(rms(values)))


class _Line(NamedTuple):
    """A line of a budget as it is made: standard uncertainties (R, k) [mm], in each reading."""

    source: str
    evaluation: Literal["A", "B"]
    degrees: float | None
    values: Array


def _lines(
    result: Result | Diagnosis, recording: Recording, found: Readings, place: Place | None, unknowns: int
) -> Iterator[_Line]:
    known = bands.known_of(result)
    source = result.noise.source if isinstance(result, Diagnosis) else result.sigma_source
    apart = bands.parts(result, recording, predict(result, recording, place), model_of(result), place)
    shape = apart.identified.shape
    told = {
        Source.REPEATS: "from repeated poses",
        Source.DECLARED: "as the recording declares it",
        Source.RESIDUAL: "from what the fit leaves",
    }[source]
    declared = source is Source.DECLARED
    evaluation: Literal["A", "B"] = "B" if declared else "A"
    degrees = None if declared else known.degrees
    yield _Line(f"a reading of the instrument, {told}", evaluation, degrees, np.full(shape, result.sigma_mm))
    yield _Line("machine and instrument, as identified", "A", known.degrees, apart.identified)
    if place is not None:
        degrees = float(np.isfinite(found.values).sum()) - unknowns
        yield _Line("where these readings place the instrument", "A", max(degrees, 1.0), apart.placing)
    if apart.left_out.any():
        yield _Line("errors of the machine that the model leaves out", "A", known.degrees, apart.left_out)
    if apart.beyond.any():
        yield _Line("what nothing explains, as held-out readings show it", "A", known.degrees, apart.beyond)


def _budget(
    result: Result | Diagnosis, recording: Recording, found: Readings, r: Array, place: Place | None, unknowns: int
) -> Budget:
    read = np.isfinite(r)
    made = _lines(result, recording, found, place, unknowns)
    lines = [line._replace(values=np.where(read, line.values, np.nan)) for line in made]
    sizes = [_rms(line.values) for line in lines]
    variance = float(np.sum(np.square(sizes)))
    slack = sum(u**4 / line.degrees for u, line in zip(sizes, lines, strict=True) if line.degrees is not None)
    degrees = variance**2 / slack if slack > 0 else None
    factor = quantile(np.inf if degrees is None else degrees)
    each = factor * np.sqrt(sum(line.values**2 for line in lines))
    return Budget(
        measurand="a coordinate that is read, less that of the calibrated machine at the joints commanded"
        if found.kind.positions
        else "a reading, less what the calibrated machine is predicted to read",
        contributions=tuple(
            Contribution(
                source=source, evaluation=how, degrees=own, sigma_mm=u, share=u**2 / variance if variance else 0.0
            )
            for (source, how, own, _), u in zip(lines, sizes, strict=True)
        ),
        sigma_mm=float(np.sqrt(variance)),
        degrees=degrees,
        factor=factor,
        expanded_mm=factor * float(np.sqrt(variance)),
        probability=HELD,
        machine_mm=factor * float(np.sqrt(max(variance - sizes[0] ** 2, 0.0))),
        within=float(np.mean(np.abs(r[read]) <= each[read])),
    )
