"""Bands: between which values a prediction, or the place that a command leads to, lies with 95 % probability.

What a fit knows of parameters, effects and instrument is one covariance (`identification.knowledge`), the source errors
that the model leaves out in it; a prediction is linear in all of them as far as they are open. What is left unexplained
comes on top, as large as held-out readings had it. The noise of a reading is not in a band: it is about what is true.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from deltacal_gen.errors import OtherVersion
from deltacal_gen.estimation.problem import Linearised, Problem
from deltacal_gen.identification.knowledge import factor
from deltacal_gen.instrument.kind import Instrument, Readings
from deltacal_gen.instrument.kinds import instrument_of, kind_of
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.rotation import from_vector, to_vector
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.factors import quantile
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.parts import Uncertainty
from deltacal_gen.results.result import Result
from deltacal_gen.units import to_file
from deltacal_gen.use.prediction import (
    CORRECTED,
    Place,
    calibrated_robot,
    commanded,
    known_effects,
    prediction_problem,
)

ASIDE = 1e-6  # rad: by which a rotation is turned to see how its vector changes


class _At(NamedTuple):
    """A problem whose open parameters are free, its instrument, poses (N, 12), and derivatives of its readings.

    `known` is how many of the instrument's set-ups the result knows; the others were placed.
    """

    problem: Problem
    instrument: Instrument
    x: Array
    state: Linearised
    known: int


def known_of(result: Result | Diagnosis) -> Uncertainty:
    """Return the uncertainty that a result keeps.

    Raises
    ------
    InputError
        It keeps none.
    """
    if result.uncertainty is None:
        raise OtherVersion(
            "the result says nothing of its uncertainty: it was made by an earlier version.",
            "Run identify or diagnose again.",
        )
    return result.uncertainty


def band_columns(recording: Recording) -> tuple[str, ...]:
    """Return the columns of a recording's kind that are predicted, in its file of distances where it has one."""
    return ("distance_mm",) if recording.pairs is not None else recording.columns


def named(column: str) -> tuple[str, str]:
    """Return the names of the two ends of a column's band: ``x_lo_mm, x_hi_mm``."""
    stem, _, unit = column.rpartition("_")
    return f"{stem}_lo_{unit}", f"{stem}_hi_{unit}"


def predicted_bands(
    result: Result | Diagnosis, recording: Recording, done: Recording, place: Place | None = None
) -> dict[str, Array]:
    """Return the ends of the bands of what was predicted for a recording, by their columns, in the units of files.

    Parameters
    ----------
    recording : Recording
        Whose readings are predicted.
    done : Recording
        The same with what `prediction.predict` says.
    place : Place, optional
        By which it was predicted.
    """
    known, at = known_of(result), _linear(result, recording, place)
    found = at.problem.readings
    J_p, J_m = _in_columns(at)
    if recording.measurement.zero == "incremental" and not found.kind.positions:
        J_p, J_m = J_p - J_p[:1], J_m - J_m[:1]  # what all readings share falls out of what counts from the first
    spread = _moved(result, known, at, J_p, J_m, place).spread
    beyond = _beyond(result, known, done, found)
    width = spread.shape[1]
    scale = 1.0 / at.instrument.at_platform[:width]
    variance = spread**2 + (np.resize(known.scatter, width) * scale) ** 2 + (beyond[:, None] * scale) ** 2
    half = quantile(known.degrees) * np.sqrt(variance)
    values, turns = half[:, : found.kind.width], half[:, found.kind.width :]
    held = found.kind.with_values(recording, found, values, from_vector(turns) if turns.shape[1] else None)
    if recording.pairs is not None:
        assert done.pair_measured is not None
        assert held.pair_measured is not None
        centres, halves = done.pair_measured[:, None], held.pair_measured[:, None]
    else:
        centres, halves = done.measured, held.measured
    return _ends(band_columns(recording), centres, halves)


def commanded_bands(
    result: Result | Diagnosis,
    joints: Array,
    reached: Array,
    tool: Array | None,
    channels: Channels,
    share: Array | None = None,
) -> dict[str, Array]:
    """Return the ends of the bands in which the machine will stand at commands, by their columns [mm].

    Parameters
    ----------
    joints : (N, n_q) array
        As the controller counts [rad or mm].
    reached : (N, 3) array
        Where the calibrated machine stands at them, in {O} [mm].
    channels : Channels
        Of each command, as the compensator completes them.
    share : (N,) array, optional
        Which part of a smooth correction they undo.

    Notes
    -----
    Of readings in an unknown frame {O} is known as the instrument sees it: the band is of where the instrument will
    read the point, along the axes of {O}.
    """
    known = known_of(result)
    frame = "unknown" if kind_of(result.instrument.kind).positions else "robot"
    commands = commanded(result, joints, tool, {}, frame)
    if channels.get("time") is None:
        channels = channels.with_values(time=np.zeros(len(joints)))
    at = _linear(result, commands, channels=channels)
    J_p, J_m = _in_columns(at)
    turn = at.instrument.state[0, :9].reshape(3, 3) if at.instrument.kind.positions else np.eye(3)
    J_p, J_m = turn.T @ J_p[:, :3], turn.T @ J_m[:, :3]
    done = dataclasses.replace(commands, channels={} if share is None else {CORRECTED: share})
    beyond = _beyond(result, known, done, at.problem.readings)
    scatter = known.scatter[:1] if frame == "unknown" else np.zeros(1)
    spread = _moved(result, known, at, J_p, J_m, None).spread
    half = quantile(known.degrees) * np.sqrt(spread**2 + scatter**2 + beyond[:, None] ** 2)
    axes = mechanism_of(calibrated_robot(result)).axes
    read = ["xyz".index(axis) for axis in axes]
    return _ends([f"{axis}_mm" for axis in axes], reached[:, read], half[:, read])


def _ends(columns: Sequence[str], centres: Array, halves: Array) -> dict[str, Array]:
    """Return the two ends of the bands of columns (N, k), in the units of files."""
    found: dict[str, Array] = {}
    for column, low, high in zip(columns, (centres - halves).T, (centres + halves).T, strict=True):
        unit = "rad" if column.endswith("_deg") else "mm"
        ends = (np.array([to_file(v, unit) for v in end.tolist()]) for end in (low, high))
        found |= zip(named(column), ends, strict=True)
    return found


class Parts(NamedTuple):
    """Standard deviations (R, k) [mm] of predicted readings, by what they come from; the parts are independent.

    `identified`: machine and instrument, as far as the readings of the fit tell them. `left_out`: source errors that
    the model leaves out, and what they have bent of the others. `placing`: set-ups placed by other readings. `beyond`:
    what no effect explains.
    """

    identified: Array
    left_out: Array
    placing: Array
    beyond: Array


def parts(
    result: Result | Diagnosis, recording: Recording, done: Recording, model: str, place: Place | None = None
) -> Parts:
    """Return of what the uncertainty of predicted readings is made; `model` is the one that was fitted.

    What is left out is independent of the noise of the fit, so that its part of the covariance C is
    C[:, u] C[u, u]^-1 C[u, :]: in the rows of its factor L the projection onto those of u.
    """
    known, at = known_of(result), _linear(result, recording, place)
    moved = _moved(result, known, at, *_in_columns(at), place)
    width = at.problem.readings.kind.width
    fitted = {*mechanism_of(calibrated_robot(result)).model(model)}
    own = factor(known)[[i for i, name in enumerate(known.parameters) if name not in fitted]]
    onto = np.linalg.pinv(own) @ own if len(own) else np.zeros((moved.by.shape[2],) * 2)
    by = moved.by[:, :width]
    beyond = _beyond(result, known, done, at.problem.readings)
    return Parts(
        np.linalg.norm(by - by @ onto, axis=2),
        np.linalg.norm(by @ onto, axis=2),
        np.sqrt(moved.placing[:, :width]),
        np.sqrt(np.resize(known.scatter, width) ** 2 + beyond[:, None] ** 2) / at.instrument.at_platform[:width],
    )


def _linear(
    result: Result | Diagnosis,
    recording: Recording,
    place: Place | None = None,
    found: Readings | None = None,
    channels: Channels | None = None,
) -> _At:
    """Return derivatives of readings by all that a result leaves open; `channels` stand for those of the recording.

    They are of all readings that the recording may hold, where none are given.
    """
    known = known_of(result)
    plain = result if channels is None else result.replace(physics=())
    problem, instrument = prediction_problem(plain, recording, found, place)
    if channels is not None:
        body = problem.body
        body = Body(problem.robot, problem.mechanism, body.q, body.tool, channels)
        problem = dataclasses.replace(problem, held=tuple(known_effects(result)), body=body)
    ends = np.cumsum([0, *(term.n_coefficients for term in problem.held)]).tolist()
    terms = problem.held[: ends.index(known.coefficients)]
    mechanism = problem.mechanism
    named = dataclasses.replace(problem.with_names(known.parameters), held=problem.held[len(terms) :])
    free = named.with_terms(terms, np.ones(known.coefficients))
    parameters = np.concatenate([problem.reference[: len(mechanism.parameters)], *(t.values.ravel() for t in terms)])
    machine = free.solve(parameters)
    like = kind_of(recording.kind).like(instrument_of(result.instrument), recording)
    knows = 0 if like is None else len(like.state)
    return _At(free, instrument, free.seen(machine), free.linearise(parameters, instrument, machine), knows)


def _in_columns(at: _At) -> tuple[Array, Array]:
    """Return derivatives (R, k, n) of readings in their own units; of rotations, of their vectors in the file."""
    J_p, J_m = at.state.J_p.copy(), at.state.J_m.copy()
    kind, width = at.problem.readings.kind, at.problem.readings.kind.width
    for J in (J_p, J_m):
        J[:, :width] /= at.instrument.at_platform[:width, None]
    if kind.rotations:
        _, rotations = at.instrument.mounted(at.problem.mechanism, at.problem.reference).predict(
            at.problem.readings, at.x
        )
        assert rotations is not None
        own = to_vector(rotations)
        turned = [to_vector(from_vector(ASIDE * np.tile(e, (len(own), 1))) @ rotations) for e in np.eye(3)]
        D = np.stack([(t - own) / ASIDE for t in turned], axis=2)
        for J in (J_p, J_m):
            J[:, width:] = D @ J[:, width:]
    return J_p, J_m


class _Moved(NamedTuple):
    """How what is open moves readings.

    By independent standard normal numbers (R, k, n), and the variance (R, k) that the placing of a set-up adds by its
    own noise.
    """

    by: Array
    placing: Array

    @property
    def spread(self) -> Array:
        """Standard deviation (R, k)."""
        return np.sqrt((self.by**2).sum(axis=2) + self.placing)


def _moved(
    result: Result | Diagnosis, known: Uncertainty, at: _At, J_p: Array, J_m: Array, place: Place | None
) -> _Moved:
    """Return how readings are moved by what is open of parameters and instrument."""
    L, n = factor(known), len(known.parameters) + known.coefficients
    kept, instrument = result.instrument, at.instrument
    out = J_p @ L[:n]
    extra = np.zeros(out.shape[:2])
    if not instrument.free:
        return _Moved(out, extra)
    if instrument.ties:
        return _Moved(out + J_m @ L[n:], extra)
    by_setup = J_m.reshape(*J_m.shape[:2], len(instrument.state), len(instrument.free))
    whole = [kept.free.index(u) if u in kept.free else -1 for u in instrument.free]
    for s in range(len(instrument.state)):
        if s < at.known:
            rows = [n + s * len(kept.free) + j for j in whole if j >= 0]
            out += by_setup[:, :, s, [i for i, j in enumerate(whole) if j >= 0]] @ L[rows]
        elif place is not None:
            follow, own = _placed(result, place, s, len(instrument.free))
            out += by_setup[:, :, s] @ follow @ L[:n]
            extra += np.einsum("rki,ij,rkj->rk", by_setup[:, :, s], own, by_setup[:, :, s])
    return _Moved(out, extra)


def _placed(result: Result | Diagnosis, place: Place, setup: int, count: int) -> tuple[Array, Array]:
    """Return how a placed set-up follows what is open of the machine, and the covariance that it has itself."""
    at = _linear(result, place.recording, place, place.readings)
    mine = at.problem.readings.setup == setup
    read = np.isfinite(at.state.residual[mine])
    first = setup * count
    A_m = at.state.J_m[mine][read][:, first : first + count]
    A_p, r = at.state.J_p[mine][read], at.state.residual[mine][read]
    follow = -np.linalg.lstsq(A_m, A_p, rcond=None)[0]
    variance = float(r @ r) / max(len(r) - count, 1)
    return follow, variance * np.linalg.pinv(A_m.T @ A_m)


def _beyond(result: Result | Diagnosis, known: Uncertainty, done: Recording, found: Readings) -> Array:
    """Return by how much (R,) [mm] readings depart where a smooth correction stands in for what no effect explains."""
    correction, share = result.correction, done.channels.get(CORRECTED)
    if correction is None or share is None:
        return np.zeros(len(found))
    before, after = (
        max(v**2 - result.sigma_mm**2 - known.scatter[0] ** 2, 0.0)
        for v in (correction.heldout_rms_mm.before, correction.heldout_rms_mm.after)
    )
    each = share[found.rows].min(axis=1)
    return np.sqrt(each * after + (1 - each) * before)
