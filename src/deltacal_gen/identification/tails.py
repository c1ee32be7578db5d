"""How heavy the tails of noise are, and how large it then is.

Fits count with noise by a robust size, which is the standard deviation of normal noise; of noise with heavy tails it is
less. Where residuals are far likelier in Laplace's distribution or one of Student's than in the normal one, that is
told, and the standard deviation is the mean over all of these, each as likely as it makes the residuals.
"""

from __future__ import annotations

from dataclasses import dataclass
from math import lgamma, log, pi, sqrt
from typing import Literal

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.machine.registry import Array

DEGREES = (3.0, 4.0, 5.0, 6.0, 8.0, 12.0, 20.0)  # of Student's distributions; those below 3 no instrument has
ROUNDS = 40  # of weights: the size of Student's distribution then stays to five digits
PROVEN = 5.0  # of log likelihood, by which tails must be likelier than none to be told


@dataclass(frozen=True)
class Tails:
    """Shape of noise.

    Attributes
    ----------
    spread : float
        Standard deviation, in units of the robust size that a fit counts with; 1 where no tails are told.
    shape : {"Laplace", "Student"} or None
        The likeliest; none unless it is likelier than the normal one by `PROVEN`.
    degrees : float or None
        Of freedom, of Student's distribution.
    """

    spread: float
    shape: Literal["Laplace", "Student"] | None = None
    degrees: float | None = None

    def __str__(self) -> str:
        """Return what there is to say of them; nothing of normal ones."""
        if self.shape is None:
            return ""
        freedom = f" with {self.degrees:g} degrees of freedom" if self.degrees else ""
        return f"large errors are as frequent as in {self.shape}'s distribution{freedom}"


NO_TAILS = Tails(1.0)


def tails_of(final: Fit) -> Tails:
    """Return the tails of what a fit leaves: freed of what rows share, gross errors left out."""
    z = np.delete(final.repeats.freed(final.residual / final.sigma), final.gross, axis=1)
    return tails(z[np.isfinite(z)], len(z))


def tails(z: Array, ways: int = 1) -> Tails:
    """Return the tails of residuals (n,) in units of a robust size, of which each comes in so many ways."""
    n, size = len(z) / ways, np.abs(z)
    mean, square = float(size.mean()), float(np.mean(size**2))
    if not square > 0:
        return NO_TAILS
    shapes = [(-n / 2 * (log(2 * pi * square) + 1), sqrt(square)), (-n * (log(2 * mean) + 1), sqrt(2) * mean)]
    for degrees in DEGREES:
        scale = _scale(size**2, degrees)
        each = np.log1p(size**2 / (degrees * scale)).sum() / ways
        norm = lgamma((degrees + 1) / 2) - lgamma(degrees / 2) - log(pi * degrees * scale) / 2
        likely = n * norm - (degrees + 1) / 2 * each - log(len(DEGREES))
        shapes.append((likely, sqrt(scale * degrees / (degrees - 2))))
    likelihoods, spreads = np.array(shapes).T
    best = int(likelihoods.argmax())
    if likelihoods[best] < likelihoods[0] + PROVEN:
        return NO_TAILS
    spread = float(np.average(spreads, weights=np.exp(likelihoods - likelihoods[best])))
    return Tails(spread, "Laplace") if best == 1 else Tails(spread, "Student", DEGREES[best - 2])


def _scale(squares: Array, degrees: float) -> float:
    """Return the likeliest square of the scale of Student's distribution, for squares (n,) of residuals."""
    scale = float(squares.mean())
    for _ in range(ROUNDS):
        scale = float(np.mean((degrees + 1) / (degrees + squares / scale) * squares))
    return scale
