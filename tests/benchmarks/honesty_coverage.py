"""Do 95 % intervals hold: of source errors, of effects' coefficients, of the map over the workspace."""

from __future__ import annotations

import dataclasses

import numpy as np

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.identification.identification import identify
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term
from deltacal_gen.results.result import Result
from deltacal_gen.units import to_file
from deltacal_gen.use.prediction import predict
from tests.benchmarks.honesty_nulls import ROBOT
from tests.support.every_effect import sized
from tests.support.left_out import DELTA, FRAME, channels, record
from tests.support.prototype import plausible, wanted

POSES, WIDE = 60, 1.96  # standard deviations of a 95 % interval
MUCH = 0.2  # mm: up to which an effect moves what is read, so that it is named
LIMB = (2,)
EFFECTS = (
    *("backlash", "joint_compliance", "payload_deflection", "inertial_deflection", "friction_windup"),
    *("thermal_zero", "zero_drift", "zero_jump", "transmission_eccentricity", "distal_compliance"),
)
SORTS = ("geometry", "map/42", "map/18", "map/3", *(f"effect/{name}" for name in EFFECTS))


def covered(sort: str, k: int) -> tuple[int, int]:
    """Return how many of the intervals of the k-th recording of a sort hold what is true, and how many there are."""
    what, _, of = sort.partition("/")
    if what == "effect":
        return _effect(of, k)
    errors = plausible(DELTA, 1000 + k)
    result = identify(ROBOT, record(ROBOT, n=POSES, seed=k, errors=errors), of or "42").answer()
    return _map(result, errors) if what == "map" else _geometry(result, errors)


def _geometry(result: Result, errors: dict[str, float]) -> tuple[int, int]:
    known = [p for p in result.parameters if p.std and p.name in errors]
    true = {p.name: to_file(errors[p.name], p.unit) for p in DELTA.parameters}
    inside = [abs(p.value - true[p.name]) < WIDE * float(p.std or 0) for p in known]
    return sum(inside), len(inside)


def _map(result: Result, errors: dict[str, float]) -> tuple[int, int]:
    assert result.workspace is not None
    points = np.array([p.target_mm for p in result.workspace.points])
    std = np.array([p.std_mm for p in result.workspace.points])
    true: Recording = simulate(ROBOT, wanted(points), errors, frame=FRAME)  # at the drawing's commands
    error = predict(result, dataclasses.replace(true, channels={})).measured - true.measured
    inside = np.abs(error) < WIDE * std
    return int(inside.sum()), inside.size


def _effect(name: str, k: int) -> tuple[int, int]:
    of = channels(POSES, "approach", "temp", "time", "payload", "motion", seed=k)
    term = _true(name, of, k)
    made = record(ROBOT, term, n=POSES, seed=k, of=of, errors=plausible(DELTA, 1000 + k, size=0.3), declared=k % 2 > 0)
    found = [e for e in diagnose(ROBOT, made).answer().effects if e.name == name and e.limbs == LIMB]
    coefficients = zip(term.kernels.COEFFICIENTS, term.values.ravel().tolist(), strict=True)
    true = {key: value / factor for (key, _, factor, _), value in coefficients}
    told = [p for e in found for p in e.parameters if p.name in true and p.std]
    inside = [abs(float(p.value) - true[p.name]) < WIDE * float(p.std or 0) for p in told]
    return sum(inside), len(inside)


def _true(name: str, of: dict[str, np.ndarray], k: int) -> Term:
    term = sized(name, LIMB, MUCH)
    if "moments" in term.kernels.SEARCHED:
        when = float(of["time_s"][20 + k % 20]) - 1.0
        return dataclasses.replace(term, constants=(when,))
    return dataclasses.replace(term, constants=(2 + k % 19,)) if "orders" in term.kernels.SEARCHED else term
