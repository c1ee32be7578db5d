"""What a model of a machine in motion predicts for other samples, and how far off it is there."""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from deltacal_gen.files.robot import robot_of
from deltacal_gen.motion.bands import half_width, known_of, unshown, unsure
from deltacal_gen.motion.derivatives import motion
from deltacal_gen.motion.joint import earlier
from deltacal_gen.motion.library import LOAD, Rung, of_joint
from deltacal_gen.motion.payload import torque_of
from deltacal_gen.motion.rigid import Rigid
from deltacal_gen.motion.trajectories import Readout, Trajectories
from deltacal_gen.physics.law import Law
from deltacal_gen.physics.splines import Samples, smooth
from deltacal_gen.results.motion import (
    JointModel,
    MotionDiagnosis,
    MotionModel,
    MotionResult,
    MotionValidation,
    Worst,
)

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

WORST = 20  # readings that are listed


def predicted(known: MotionModel, given: Trajectories, *, bands: bool = False) -> Trajectories:
    """Return a recording with the readings that a model predicts; blank at rest, where friction is not known.

    Measured cells are not read. A joint that did not move in the recording of the model has no prediction. With
    `bands` half the width of each reading's band of 95 % stands beside it; see `motion.bands`.

    Raises
    ------
    InputError
        Bands are asked of a result that says nothing of its uncertainty.
    """
    robot = robot_of(known.robot)
    rigid, found = Rigid(robot), motion(given, known.motion.cutoff_Hz)
    states = np.nan_to_num(found.states)
    models = {model.joint: model for model in known.joints}
    chosen = [models[j + 1].columns if j + 1 in models else () for j in range(given.joints.shape[1])]
    columns = rigid.columns(states, [np.array(some, dtype=int) for some in chosen])
    payload = known_beforehand(known, rigid, states, given)
    units = tuple(column.rpartition("_")[2] if "_" in column else "1" for column in known.columns)
    done = dataclasses.replace(given, columns=known.columns, units=units)
    out, outside = np.full(given.joints.shape, np.nan), np.zeros(given.n_rows, dtype=bool)
    beyond = np.zeros(given.joints.shape, dtype=bool)
    loads = out.copy()
    half = np.full(given.joints.shape, np.nan) if bands else None
    for j, model in models.items():
        late = functools.partial(earlier, delay=model.delay or 0.0, time=given.time, piece=given.piece)
        read = {name: late(values) for name, values in of_joint(given, states, j - 1).items()}
        own = late(columns[j - 1]), late(payload[:, j - 1]), done.readouts[j - 1]
        past = remembered(model, read, given)
        value = given_by_drive(model, read, past, *own)
        moving = np.abs(late(found.states[1, :, j - 1])) > model.at_rest_below
        out[:, j - 1] = np.where(moving, value / done.readouts[j - 1].inside, np.nan)
        read = read | {LOAD: load_of(model, *own)}
        loads[:, j - 1] = np.where(moving, read[LOAD] / done.readouts[j - 1].inside, np.nan)
        outside |= moving & beyond_laws(model, read)
        if model.uncertainty is None and half is None:
            continue  # of a result of an earlier version
        by = own[0] if model.payload is None else np.column_stack(own[:2])
        sure, variance = known_of(model), unsure(model, read, past, by, given)
        beyond[:, j - 1] = moving & ~found.loose & unshown(sure, variance)
        if half is not None:
            half[:, j - 1] = half_width(sure, variance) / done.readouts[j - 1].inside
    return dataclasses.replace(done, readings=out, outside=outside, unshown=beyond, load=loads, half=half)


def beyond_laws(model: JointModel, states: dict[str, Array]) -> np.ndarray:
    """Return which samples (N,) lie outside of where a law of a joint was found, by states (N,) of the joint."""
    out = np.zeros(len(states["q"]), dtype=bool)
    for term in model.terms:
        law = Rung(term.effect, term.constants).kernels
        if isinstance(law, Law) and law.STATE:
            out |= law.beyond(np.stack([states[name] for name in law.STATE], axis=1), term.constants).any(axis=1)
    return out


def known_beforehand(known: MotionModel, rigid: Rigid, states: Array, given: Trajectories) -> Array:
    """Return what is known of what the joints must give (N, n_q): payload, and bodies as the robot file states them."""
    payload = rigid.of_payload(states) * given.payload[:, None]
    if known.known is None:
        return payload
    setups = [each.setup for each in known.known.payloads]
    values = np.array([[each.mass, *each.centre] for each in known.known.payloads]).reshape(-1, 4)
    stated = rigid.torque(states, np.array(known.known.inertial))
    return payload + stated + torque_of(rigid, states, given, setups, values)


def remembered(model: JointModel, read: dict[str, Array], given: Trajectories) -> list[dict[str, Array]]:
    """Return what each effect of a joint remembers at all samples, by name (N,); `read` is what effects read."""
    return [Rung(term.effect, term.constants).remembered(read, given.time, given.piece) for term in model.terms]


def load_of(model: JointModel, columns: Array, known: Array, readout: Readout) -> Array:
    """Return what the rigid machine asks of a joint (N,), in units inside; see `given_by_drive`."""
    load = columns @ np.array(model.coefficients)
    if readout.forces:
        return np.asarray(load + known)
    return np.asarray(load if model.payload is None else load + model.payload * known)


def given_by_drive(
    model: JointModel,
    read: dict[str, Array],
    past: Sequence[dict[str, Array]],
    columns: Array,
    known: Array,
    readout: Readout,
) -> Array:
    """Return what a joint's drive gives (N,), in units inside.

    Parameters
    ----------
    read : dict
        What effects read, see `of_joint`.
    past : sequence of dict
        What they remember; see `remembered`.
    columns : (N, r) array
        What the inertial parameters of the model ask of the joint.
    known : (N,) array
        What is known of what it must give; see `known_beforehand`.
    """
    load = load_of(model, columns, known, readout)
    read, total = read | {LOAD: load}, load
    for term, own in zip(model.terms, past, strict=True):
        total = total + Rung(term.effect, term.constants).columns(read | own) @ np.array(term.values)
    return np.asarray(total)


def validated(known: MotionResult | MotionDiagnosis, given: Trajectories) -> MotionValidation:
    """Return how far off a model is on samples that it has not seen."""
    done = predicted(known, given)
    left = given.readings - done.readings
    rms = tuple(_rms(left[:, j]) for j in range(left.shape[1]))
    units = set(done.units)
    together: dict[str, Any] = {f"rms_{done.units[0]}": _rms(left)} if len(units) == 1 else {}
    noise = known.noise
    sigma = np.array([s or np.nan for s in noise.sigma_by_joint])
    count = int(np.isfinite(left / sigma).sum())
    worst = np.argsort(-np.nan_to_num(np.abs(left / sigma)), axis=None)[: min(WORST, count)]
    rows = [
        Worst(line=int(given.line[n]), limb=j + 1, error=float(left[n, j]), unit=done.units[j])
        for n, j in zip(*map(np.ndarray.tolist, np.unravel_index(worst, left.shape)), strict=True)
    ]
    return MotionValidation(
        kind=known.kind,
        readings=int(np.isfinite(left).sum()),
        **together,
        rms_by_joint=rms,
        rms_by_joint_filtered=tuple(
            _rms(_filtered(left[:, j], given, known.motion.cutoff_Hz)) for j in range(len(rms))
        ),
        unit_by_joint=done.units,
        noise=noise,
        chi2_per_dof=float(np.nansum((left / sigma) ** 2)) / count if count else None,
        degrees_of_freedom=count,
        rows=tuple(rows),
        at_rest=int((np.isfinite(given.readings) & ~np.isfinite(done.readings)).sum()),
        repairs=given.repairs,
        outside_law=int(done.outside.sum()) if known.has_law else None,
        unshown_by_joint=tuple(int(n) for n in (done.unshown & np.isfinite(left)).sum(axis=0)),
    )


def _filtered(left: Array, given: Trajectories, cutoff: float | None) -> Array:
    there = np.isfinite(left)
    if cutoff is None or not there.any():
        return left
    changes = np.diff(given.piece, prepend=0) + np.abs(np.diff(there.astype(int), prepend=0)) != 0
    return np.asarray(
        smooth(Samples(left[there, None], given.time[there], np.cumsum(changes)[there]), 0.5 / cutoff, 0)[0, :, 0]
    )


def _rms(values: Array) -> float | None:
    known = values[np.isfinite(values)]
    return float(np.sqrt(np.mean(known**2))) if len(known) else None
