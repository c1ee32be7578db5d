"""Whether a fit stands on a saddle: where what is left bends the objective down in directions that readings do not see.

A step takes the machine for linear. Where the readings do not see a parameter at all to first order (a twist that
tilts a rod either way, a vertical axis whose compliance no weight loads) nothing pulls, and the fit ends there, though
the objective falls to both sides. How it bends is seen in its gradient a little beside the fit. What the linear machine
says of that is known without it: where there is little else nothing more is asked; elsewhere few directions hold the
rest, whose lowest curvature is sought (Lanczos 1950), and the direction that bends down most under both.

A drawing may be such a place: of a drawn machine that is like its mirror image, errors and their opposites explain
distances about as well, and a fit that left it to one side sees nothing of the other.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.estimation.fitted import SEEN, Fit
from deltacal_gen.estimation.problem import State
from deltacal_gen.estimation.system import System, system

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array

ASIDE = 0.02  # standard deviations beforehand: how far beside a fit its gradient is taken
LINEAR = 0.02  # of a gradient's change: where less of it is not the linear machine's, nothing is asked further
LOOKS = 8  # directions that are looked at, at most
SETTLED = 0.1  # in units of the prior's own: how surely the lowest curvature is known where no more are
DOWN = -0.05  # in units of the prior's own: a curvature that is below it leads away
GOLDEN = (5**0.5 - 1) / 2  # parts of one that its multiples leave are spread evenly
BEGUN = 0.5  # standard deviations beforehand: where steps begin
FORESEEN = 1 / 3  # of the way from the drawing to a fit: of which less is not the linear machine's, it saw the place
SURE = 10.0  # of chi2: a place that is so far from the one foreseen is another


def away(found: Fit) -> list[State]:
    """Return states on both sides of a fit from which steps lead away from it; none where it is no saddle."""
    at, n = found.solution, len(found.problem.scale)
    strong = at.V[:, at.factors > SEEN]
    unseen = np.linalg.qr(strong, mode="complete")[0][:, strong.shape[1] :]
    v = unseen.T @ (np.mod(GOLDEN * np.arange(1.0, 1.0 + n), 1.0) - 0.5)  # some of every direction
    if np.linalg.norm(v) < ASIDE:
        return []
    try:
        beside = _Beside(found)
        down = _most_down(beside, unseen, v / np.linalg.norm(v))
        return [] if down is None else [beside.state(side * BEGUN * down) for side in (1.0, -1.0)]
    except InputError:
        return []  # no machine stands there


def unforeseen(found: Fit) -> bool:
    """Tell whether a fit ended elsewhere than the machine made linear at the drawing would have it.

    By more than a part of the way, and than the fit is uncertain by: the objective bends between, and may have another
    low place on the other side.
    """
    problem, at = found.problem, found.problem.reference
    if not found.solution.posterior:
        return False
    try:
        machine = problem.solve(at)
        A, b = _rows(found, State(at, problem.begin(at, machine), machine)).machine
    except InputError:
        return False  # no machine stands there
    n, solution = A.shape[1], found.solution
    # by rows, not by their squares: readings without noise leave these nothing of the prior
    foreseen = np.linalg.lstsq(np.vstack([A, np.eye(n)]), np.append(b, np.zeros(n)), rcond=None)[0]
    off = found.departure - foreseen
    if np.linalg.norm(off) < FORESEEN * np.linalg.norm(found.departure):
        return False
    seen = solution.singular_values * (solution.V.T @ off)
    return bool(seen @ seen + off @ off > SURE)


def _most_down(beside: _Beside, unseen: Array, v: Array) -> Array | None:
    """Return the direction (n,) of unit length that bends down most; None where none does.

    Parameters
    ----------
    unseen : (n, m) array
        Orthonormal: all that readings do not see.
    v : (m,) array
        Where the search begins.
    """
    seen = beside.A @ unseen
    linear = seen.T @ seen + np.eye(len(v))
    basis: list[Array] = [v]
    bent: list[Array] = []  # beyond what the linear machine does
    for k in range(LOOKS):
        h = unseen.T @ (beside.gradient(ASIDE * (unseen @ basis[k])) - beside.here) / ASIDE
        expected = linear @ basis[k]
        bent.append(h - expected)
        if k == 0 and np.linalg.norm(bent[0]) < LINEAR * np.linalg.norm(expected):
            return None
        Q = np.array(basis).T
        H = Q.T @ np.array(bent).T
        H = (H + H.T) / 2
        _, vectors = np.linalg.eigh(H)
        rest = bent[k] - Q @ (Q.T @ bent[k])
        size = np.linalg.norm(rest)
        if size < LINEAR or (k > 0 and size * abs(vectors[-1, 0]) < SETTLED):
            break
        basis.append(rest / size)
    values, vectors = np.linalg.eigh(linear + Q @ H @ Q.T)
    return None if values[0] > DOWN else np.asarray(unseen @ vectors[:, 0])


class _Beside:
    """A fit, and how its objective goes beside it: in scaled parameters, the instrument following."""

    def __init__(self, found: Fit) -> None:
        self._fit = found
        self._system = _rows(found, State(found.errors, found.instrument, found.machine))
        self.A, b = self._system.machine
        self.here: Array = found.departure - self.A.T @ b

    def state(self, aside: Array) -> State:
        """Return where parameters are off by `aside` (n,)."""
        found = self._fit
        errors = found.errors.copy()
        errors[found.problem.columns] += aside * found.problem.scale
        instrument = found.instrument.stepped(self._system.following(aside))
        return State(errors, instrument, found.problem.solve(errors, near=found.machine))

    def gradient(self, aside: Array) -> Array:
        """Return half the gradient (n,) there."""
        A, b = _rows(self._fit, self.state(aside)).machine
        return np.asarray(self._fit.departure + aside - A.T @ b)


def _rows(found: Fit, at: State) -> System:
    """Return the rows of the machine made linear, of a soft one as its loads follow, weighed as in the fit."""
    problem = found.problem
    linear = problem.linearise(at.errors, at.instrument, at.machine)
    if problem.gives_way:
        linear = linear._replace(J_p=linear.J_p + problem.followed(*at))
    return system(linear, found.sigma, found.weights, found.repeats, problem.scale)
