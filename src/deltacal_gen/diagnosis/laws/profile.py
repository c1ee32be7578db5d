"""Constants within a law (thresholds, scales, orders, time constants) where they explain most beside all else.

Coefficients follow from the constants at once (variable projection; Golub and Pereyra 2003, Inverse Problems 19,
R1-R26), so that Gauss and Newton step along the constants alone. Where a law jumps it has no derivative: there each
constant is sought by itself.
"""

from __future__ import annotations

import dataclasses

import numpy as np

from deltacal_gen.diagnosis.laws.ground import Ground, Place, Tried
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.grammar import Form

SUDDEN = ("Heaviside(", "Mod(")  # functions that jump where a constant says so
STEPS = 60  # of the search along each constant
SHARP = 0.15  # of a constant, in logarithms, or of the width of its state: its first step
ROUNDS, HARDER = 20, 5  # of Gauss and Newton; and attempts of each, damped ten times more
ASIDE = 1e-4  # of a constant's size, by which its derivative is taken
FARTHEST = 0.5  # of the same: how far a step goes
ENOUGH = 0.02  # of chi2: what a last step gains
LEAST = 1e-9  # damping: constants that do the same have no step of their own without any
UNSEEN = 1e-20  # of the largest diagonal: less is rounding of a constant that moves nothing


def refine(ground: Ground, place: Place, tried: Tried) -> Tried:
    """Return a form with its constants where it explains most, from where they are."""
    form = tried.form
    if not form.constants:
        return tried
    if any(name in f for f in form.functions for name in SUDDEN):
        return _along_each(ground, place, tried)
    at, best, damping = np.array(form.constants), tried.gain, 1e-3
    size = np.array([_size(ground, form, k) for k in range(len(at))])
    signed = np.array([_place(form, k) or _weight(form, k) for k in range(len(at))])
    for _ in range(ROUNDS):
        G, b = _linear(ground, place, form.with_constants(at), tried.limbs, size)
        for _ in range(HARDER):
            step = damped(G, b, damping)[-len(at) :]
            trial = at + size * np.clip(step, -FARTHEST, FARTHEST)
            trial = np.where(signed | (trial * at > 0), trial, at)
            found = ground.gain(place, form.with_constants(trial), tried.limbs)
            damping = max(damping * (0.2 if found > best else 10.0), LEAST)
            if found > best:
                break
        gained, best, at = (found - best, found, trial) if found > best else (0.0, best, at)
        if gained < ENOUGH:
            break
    return dataclasses.replace(tried, form=form.with_constants(at), gain=best)


def damped(G: Array, b: Array, damping: float) -> Array:
    """Return the step of Levenberg and Marquardt for normal equations; 0 along what moves nothing."""
    own = np.diag(G)
    size = np.where(own > UNSEEN * own.max(initial=0.0), np.sqrt(np.maximum(own, 0.0)), np.inf)
    step: Array = np.linalg.solve(G / np.outer(size, size) + damping * np.eye(len(G)), b / size) / size
    return step


def _linear(ground: Ground, place: Place, form: Form, limbs: tuple[int, ...], size: Array) -> tuple[Array, Array]:
    """Return normal equations of coefficients and constants, these in their sizes, at a form's best coefficients."""
    own = [i - 1 for i in limbs] or [0]
    C = ground.columns(place, ground.values(form))[:, :, own]
    functions = C.shape[1]
    C = C.reshape(len(C), -1)
    G, b, long = (v[0] for v in ground.normal(C[:, None]))
    by = np.linalg.pinv(G, rcond=1e-10, hermitian=True) @ b / np.where(long > 0, long, 1.0)
    moved = ground.by_constants(place, form, limbs, by.reshape(functions, -1).T, ASIDE * size) * size
    X = np.hstack([C, moved])
    G, b, long = (v[0] for v in ground.normal(X[:, None]))
    left = b - G[:, : len(by)] @ (by * long[: len(by)])
    return G * np.outer(long, long), left * long


def _along_each(ground: Ground, place: Place, tried: Tried) -> Tried:
    """Return what `refine` does, each constant sought in turn with a step of its own."""
    form, best = tried.form, tried.gain
    at = np.array(form.constants)
    step = np.array([SHARP * _size(ground, form, k) for k in range(len(at))])
    for _ in range(STEPS):
        moved = False
        for k in range(len(at)):
            for sign in (1.0, -1.0):
                trial = at.copy()
                trial[k] += sign * step[k]
                if trial[k] * at[k] <= 0 and not (_place(form, k) or _weight(form, k)):
                    continue  # a scale, a period or a time has a sign
                found = ground.gain(place, form.with_constants(trial), tried.limbs)
                if found > best + 1e-3:
                    best, at, moved = found, trial, True
                    step[k] *= 1.5
                    break
            else:
                step[k] *= 0.5
        if not moved and (step < 1e-3 * np.maximum(np.abs(at), 1e-12)).all():
            break
    return dataclasses.replace(tried, form=form.with_constants(at), gain=best)


def _place(form: Form, k: int) -> bool:
    """Tell whether a constant is a place on the axis of its state, and no size."""
    return any(f"- {{{k}}}" in f for f in form.functions)


def _weight(form: Form, k: int) -> bool:
    """Tell whether a constant weighs a part of a sum."""
    return any(f"+ {{{k}}}" in f and f"+ {{{k}}}**" not in f for f in form.functions)


def _size(ground: Ground, form: Form, k: int) -> float:
    """Return what a constant is compared with: itself, or the width of its state."""
    if _place(form, k):
        return float(np.ptp(ground.states[form.states[-1] if len(form.states) == 1 else _owner(form, k)]))
    return max(abs(form.constants[k]), 1e-12)


def _owner(form: Form, k: int) -> str:
    """Return the state whose function holds a constant: the last one before it in the text."""
    text = next(f for f in form.functions if f"{{{k}}}" in f)
    before = text[: text.index(f"{{{k}}}")]
    return max(form.states, key=before.rfind)
