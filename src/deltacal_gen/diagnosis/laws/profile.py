"""Constants within a law (thresholds, scales, orders, time constants) where they explain most beside all else.

Coefficients follow from the constants at once (variable projection; Golub and Pereyra 2003, Inverse Problems 19,
R1-R26), so that Gauss and Newton step along the constants alone. Where a law jumps it has no derivative: there a
simplex (Nelder and Mead 1965) steps.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable

import numpy as np

from deltacal_gen.diagnosis.laws.ground import Ground, Place, Tried, on
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.grammar import Form

SUDDEN = ("Heaviside(", "Mod(")  # functions that jump where a constant says so
STEPS = 60  # of the simplex, for each constant
SHARP = 0.04  # of a constant, in logarithms, or of the width of its state: the simplex at first
ROUNDS, HARDER = 20, 5  # of Gauss and Newton; and attempts of each, damped ten times more
ASIDE = 1e-4  # of a constant's size, by which its derivative is taken
FARTHEST = 0.5  # of the same: how far a step goes
ENOUGH = 0.02  # of chi2: what a last step gains
LEAST = 1e-9  # damping: constants that do the same have no step of their own without any
UNSEEN = 1e-20  # of the largest diagonal: less is rounding of a constant that moves nothing


def refine(ground: Ground, place: Place, tried: Tried) -> Tried:
    """Return a form with its constants where it explains most, from where they are."""
    form, limbs = tried.form, tried.limbs
    if not form.constants:
        return tried
    width = np.array([_width(ground, form, k) for k in range(len(form.constants))])

    def moved(at: Array, step: Array) -> Form:
        """Return the form with a step from some constants: of sizes, which keep their sign, in logarithms."""
        return form.with_constants(np.where(width > 0, at + width * step, at * np.exp(step)))

    at, best = np.array(form.constants), tried.gain
    if any(name in f for f in form.functions for name in SUDDEN):
        step = _by_simplex(lambda step: ground.gain(place, moved(at, step), limbs), len(at))
        other = dataclasses.replace(tried, form=moved(at, step), gain=ground.gain(place, moved(at, step), limbs))
        return max(tried, other, key=lambda t: t.gain)
    damping = 1e-3
    for _ in range(ROUNDS):
        G, b = _linear(ground, place, form.with_constants(at), limbs, np.where(width > 0, width, at))
        for _ in range(HARDER):
            trial = moved(at, np.clip(damped(G, b, damping)[-len(at) :], -FARTHEST, FARTHEST))
            found = ground.gain(place, trial, limbs)
            damping = max(damping * (0.2 if found > best else 10.0), LEAST)
            if found > best:
                break
        if found < best + ENOUGH:
            break
        best, at = found, np.array(trial.constants)
    return dataclasses.replace(tried, form=form.with_constants(at), gain=best)


def _by_simplex(explained: Callable[[Array], float], n: int) -> Array:
    """Return the step of n constants with which most is explained."""
    from scipy.optimize import minimize

    simplex = np.vstack([np.zeros(n), SHARP * np.eye(n)])
    how = {"initial_simplex": simplex, "maxfev": STEPS * n, "xatol": 1e-3, "fatol": 1e-3}
    found: Array = minimize(lambda step: -explained(step), simplex[0], method="Nelder-Mead", options=how).x
    return found


def damped(G: Array, b: Array, damping: float) -> Array:
    """Return the step of Levenberg and Marquardt for normal equations; 0 along what moves nothing."""
    own = np.diag(G)
    size = np.where(own > UNSEEN * own.max(initial=0.0), np.sqrt(np.maximum(own, 0.0)), np.inf)
    step: Array = np.linalg.solve(G / np.outer(size, size) + damping * np.eye(len(G)), b / size) / size
    return step


def _linear(ground: Ground, place: Place, form: Form, limbs: tuple[int, ...], size: Array) -> tuple[Array, Array]:
    """Return normal equations of coefficients and constants, these in their sizes, at a form's best coefficients."""
    C = on(ground.columns(place, ground.values(form)), limbs)
    functions = C.shape[1]
    C = C.reshape(len(C), -1)
    G, b, long = (v[0] for v in ground.normal(C[:, None]))
    by = np.linalg.pinv(G, rcond=1e-10, hermitian=True) @ b / np.where(long > 0, long, 1.0)
    moved = ground.by_constants(place, form, limbs, by.reshape(functions, -1).T, ASIDE * size) * size
    X = np.hstack([C, moved])
    G, b, long = (v[0] for v in ground.normal(X[:, None]))
    left = b - G[:, : len(by)] @ (by * long[: len(by)])
    return G * np.outer(long, long), left * long


def _width(ground: Ground, form: Form, k: int) -> float:
    """Return by what a constant is counted that may have either sign: the width of its state, or its own size.

    Of a size (a scale, a period, a time), which has one sign, 0.
    """
    text = next(f for f in form.functions if f"{{{k}}}" in f)
    if f"- {{{k}}}" in text and f"- {{{k}}}/" not in text:  # a place on the axis of the state that stands before it
        state = max(form.states, key=text[: text.index(f"{{{k}}}")].rfind)
        return float(np.ptp(ground.states[state]))
    weighs = f"+ {{{k}}}" in text and f"+ {{{k}}}**" not in text
    return max(abs(form.constants[k]), 1e-12) if weighs else 0.0
