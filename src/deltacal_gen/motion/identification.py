"""The rigid machine by its drives: base parameters with their uncertainty, and bodies that could be built."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.optimize import nnls

from deltacal_gen.errors import UnknownModel
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion.fit import Fit, fitted
from deltacal_gen.motion.joint import USUAL
from deltacal_gen.motion.ladder import BUYS
from deltacal_gen.motion.library import Rung
from deltacal_gen.motion.mistakes import check, sizes_alone, too_heavy
from deltacal_gen.motion.regression import BELIEVED
from deltacal_gen.motion.rigid import Rigid
from deltacal_gen.motion.session import Session, still_to_move
from deltacal_gen.motion.traces import traces
from deltacal_gen.motion.trajectories import Trajectories
from deltacal_gen.results.diagnosis import NextMeasurement
from deltacal_gen.results.motion import Consistent, InertialParameter, MotionResult
from deltacal_gen.results.result import Read, Regularisation, Status

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

RIGID = "rigid"  # name of the model, behind that of the mechanism
RANK = 1.0  # singular value of what readings tell as much of as is known without them
SURE = 3.0  # standard deviations from zero of a parameter that is told as identified
NEXT_TO_NOTHING = 0.8  # of the readings' rms: so much is left where bodies are fitted to readings of other rows
TAKEN_UP = 1.0  # standard deviation of a parameter: what friction must change of one, to be told


def identify(robot: Robot, given: Trajectories, model: str | None = None) -> MotionResult:
    """Identify the rigid machine, without friction.

    Raises
    ------
    UsageError
        Another model is asked for.
    InputError
        No joint moves for long enough; columns of drives are exchanged, or count in another unit than they say.
    """
    name = rigid_model(robot, model)
    session = Session.of(robot, given)
    check(session)
    fits = [fitted(joint, []) for joint in session.moving]
    final, noise = session.left(fits, name), session.noise(fits)
    bodies = bodies_told(session.rigid, fits)
    return MotionResult(
        **session.answered(fits),
        **bodies,
        model=name,
        traces=traces(session, fits, fits),
        next_measurements=(*still_to_move(session, fits), *still_to_show(bodies)),
        regularisation=Regularisation(rule="base parameters are shrunk by what predicts held-out samples best"),
        readings=Read(kind=given.kind, scalars=sum(len(fit.left) for fit in fits), poses=given.n_rows),
        noise=noise,
        final=final,
        train_rms=final.train_rms,
        heldout_rms=final.heldout_rms,
        sigma=noise.sigma,
        sigma_source=noise.source,
        chi2_per_dof=final.chi2_per_dof,
        friction=_of_friction(session, fits),
        doubts=(*_doubts(fits), *too_heavy(session, fits), *sizes_alone(fits)) or None,
    )


def rigid_model(robot: Robot, model: str | None) -> str:
    """Return the name of the one model in motion; raises a UsageError where another one is asked for."""
    name = f"{robot.mechanism}/{RIGID}"
    if model not in (None, RIGID, name):
        raise UnknownModel(f"in motion there is the model {name} only, not '{model}'.")
    return name


def bodies_told(rigid: Rigid, fits: Sequence[Fit]) -> dict[str, Any]:
    """Return the fields of an answer that say what is known of bodies, beside what effects the fits have."""
    torques, parameters = reads_torques(fits), base_parameters(rigid, fits)
    each = [_singular(rigid, fits)] if torques else [_singular_of(fit) for fit in fits]
    known = [len(values) > 0 and values[-1] > RANK for values in each]
    bodies, off = _consistent(rigid, fits) if torques else (None, None)
    return {
        "parameters": tuple(parameters),
        "rank": int(sum(np.count_nonzero(values > RANK) for values in each)),
        "rank_tolerance": RANK,
        "singular_values": np.concatenate(each),
        "condition": max(float(values[0] / values[-1]) for values in each) if all(known) else None,
        "scaling": f"over what is known beforehand: {BELIEVED:g} times what a joint gave is the most that a parameter "
        "asks of it where all joints move as the quickest did",
        "unidentifiable": tuple(rigid.unseen(rigid.common)),
        "consistent": bodies,
        "consistent_off": off,
    }


def still_to_show(bodies: Mapping[str, Any]) -> tuple[NextMeasurement, ...]:
    """Return how to move so that a recording tells all base parameters; nothing where it does."""
    rank, count = bodies["rank"], len(bodies["parameters"])
    if rank == count:
        return ()
    text = "Move all joints at once, each over its range and at several speeds; plan gives such a movement."
    why = f"the movement tells {rank} of {count} base parameters"
    return (NextMeasurement(why=why, text=text, poses=(), expected_chi2=None, run=("q", "qd", "qdd")),)


def _of_friction(session: Session, fits: Sequence[Fit]) -> str | None:
    """Return in words what usual friction would change of a rigid machine's parameters; None where there is none."""
    beside = [fitted(fit.joint, [Rung(name) for name in USUAL]) for fit in fits]
    rubbed = [
        str(fit.joint.number)
        for fit, other in zip(fits, beside, strict=True)
        if np.nanmean(other.held_out**2) < (1.0 - BUYS) ** 2 * np.nanmean(fit.held_out**2)
    ]
    if not rubbed:
        return None
    each = zip(base_parameters(session.rigid, fits), base_parameters(session.rigid, beside), strict=True)
    moved = [(abs(a.value - b.value) / a.std, a, b) for a, b in each if a.std]
    told = f"friction (joint {', '.join(rubbed)}) is no part of the rigid machine"
    off, own, other = max(moved, key=lambda pair: pair[0], default=(0.0, None, None))
    if own is None or other is None or off < TAKEN_UP:
        return told
    of = "" if own.limb is None else f" of joint {own.limb}"
    return (
        f"{told}, whose parameters take some of it up: beside dry and viscous friction and an offset {own.name}{of} is "
        f"{other.value:.4g} instead of {own.value:.4g} {own.unit}, {off:.1f} of its standard deviations away; diagnose "
        "gives all of them beside what it finds"
    )


def _doubts(fits: Sequence[Fit]) -> Iterator[str]:
    """Yield the joints whose drives gave something else than what the rigid machine asks for."""
    if turned := [str(fit.joint.number) for fit in fits if fit.joint.sense < 0]:
        yield (
            f"friction would drive joint{'s' * (len(turned) > 1)} {', '.join(turned)}: the reading is counted against "
            "the angle; turn the sign of its column"
        )
    little = [
        str(fit.joint.number)
        for fit in fits
        if np.sqrt(np.mean(fit.left**2)) > NEXT_TO_NOTHING * np.sqrt(np.mean(fit.joint.y**2))
    ]
    if little:
        yield (
            f"the rigid machine explains next to nothing of what joint{'s' * (len(little) > 1)} {', '.join(little)} "
            "gave: friction may be all there is (diagnose), or the readings are of other rows or another machine"
        )


def reads_torques(fits: Sequence[Fit]) -> bool:
    """Tell whether what drives give is known as a torque or a force."""
    return all(fit.joint.readout.forces for fit in fits)


def base_parameters(rigid: Rigid, fits: Sequence[Fit]) -> list[InertialParameter]:
    """Return the base parameters, beside what effects the fits have: of all joints, or of each where units are open."""
    return _common(rigid, fits) if reads_torques(fits) else _by_joint(rigid, fits)


def _singular(rigid: Rigid, fits: Sequence[Fit]) -> Array:
    """Return the singular values of the common base parameters' columns, over what is known beforehand."""
    G, _, known = _normal(rigid, fits)
    scale = np.sqrt(known)
    return np.asarray(np.sqrt(np.maximum(np.linalg.eigvalsh(G / np.outer(scale, scale))[::-1], 0.0)))


def _singular_of(fit: Fit) -> Array:
    """Return the singular values of one joint's columns, over what is known beforehand."""
    X = fit.beside_effects(fit.joint.X)
    return np.asarray(np.linalg.svd(X / (fit.joint.usual * np.sqrt(fit.prior * len(X))), compute_uv=False))


def _normal(rigid: Rigid, fits: Sequence[Fit]) -> tuple[Array, Array, Array]:
    """Return normal equations (r, r), (r,) of the common base parameters by all joints, each by its own noise.

    With them comes what is known beforehand (r,), which their diagonal does not hold.
    """
    size = rigid.common.rank
    G, g, known = np.zeros((size, size)), np.zeros(size), np.zeros(size)
    for fit in fits:
        own = rigid.own[fit.joint.number - 1]
        weight = 1.0 / (fit.sigma**2 * fit.together)
        X = fit.joint.X @ own.made_up[:, rigid.common.chosen]
        y = fit.left + fit.load - fit.joint.carried  # what effects gave is not the rigid machine's
        X = fit.beside_effects(X)
        G += weight * X.T @ X
        g += weight * X.T @ y
        usual = fit.joint.usual**2 @ own.made_up[:, rigid.common.chosen] ** 2
        known += weight * len(X) * fit.prior * usual
    return G, g, np.maximum(known, 1e-300)


def _common(rigid: Rigid, fits: Sequence[Fit]) -> list[InertialParameter]:
    """Return the base parameters by the torques of all joints together."""
    G, g, known = _normal(rigid, fits)
    g = g - G @ rigid.stated_base(rigid.common)
    scale = np.sqrt(known + np.diag(G))
    inverse = np.linalg.inv((G + np.diag(known)) / np.outer(scale, scale))
    value, std = inverse @ (g / scale) / scale, np.sqrt(np.maximum(np.diag(inverse), 0.0)) / scale
    units = [rigid.dynamics.units[k] for k in rigid.common.chosen]
    return [
        _parameter(name, text, v, s, unit, None)
        for (name, text), v, s, unit in zip(rigid.words(rigid.common), value, std, units, strict=True)
    ]


def _by_joint(rigid: Rigid, fits: Sequence[Fit]) -> list[InertialParameter]:
    """Return the base parameters that each joint's reading knows, per unknown torque of that reading."""
    found = []
    for fit in fits:
        base = rigid.own[fit.joint.number - 1]
        per = "A/Nm" if fit.joint.unit == "A" else "1/Nm"
        for (name, text), k, v, s in zip(
            rigid.words(base), base.chosen, fit.coefficients[: base.rank], fit.std[: base.rank], strict=True
        ):
            unit = f"{rigid.dynamics.units[k]} {per}"
            found.append(_parameter(name, text, 1000.0 * v, 1000.0 * s, unit, fit.joint.number))
    return found


def _parameter(name: str, text: str, value: float, std: float, unit: str, limb: int | None) -> InertialParameter:
    known = abs(value) > SURE * std and std > 0
    return InertialParameter(
        name=name,
        combination=text,
        value=float(value),
        std=float(std),
        unit=unit,
        limb=limb,
        status=Status.IDENTIFIED if known else Status.NOT_PINNED,
    )


def _consistent(rigid: Rigid, fits: Sequence[Fit]) -> tuple[tuple[Consistent, ...], float]:
    """Return inertial parameters of bodies that could be built, as near to the base parameters as the noise asks.

    Masses on a lattice, by least squares that keeps them positive (Lawson, Hanson 1974). With them comes by how much
    their base parameters are off: rms, in standard deviations.
    """
    G, g, known = _normal(rigid, fits)
    scale = np.sqrt(known)
    values, vectors = np.linalg.eigh(G / np.outer(scale, scale))
    kept = values > RANK**2
    half = np.sqrt(values[kept])[:, None] * (vectors[:, kept].T * scale)
    wanted = (vectors[:, kept].T @ (g / scale)) / np.sqrt(values[kept])
    simplest = rigid.dynamics.buildable()
    A = half @ rigid.common.made_up @ simplest.T
    size = np.linalg.norm(A, axis=0)
    size[size == 0] = 1.0
    masses, off = nnls(A / size, wanted, maxiter=20 * A.shape[1])
    found = (masses / size) @ simplest
    told = tuple(
        Consistent(name=name, value=float(v), unit=unit)
        for name, v, unit in zip(rigid.names, found, rigid.dynamics.units, strict=True)
    )
    return told, float(off / np.sqrt(max(len(wanted), 1)))
