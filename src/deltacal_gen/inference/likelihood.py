"""The likelihood of a linear mixed model, of the singular values of its effects.

::

    y = X a + Z c + e,    a flat,    c ~ N(0, D), D diagonal,    e ~ N(0, noise I)

The likelihood is that of contrasts which are free of a (restricted likelihood; Patterson and Thompson 1971, Biometrika
58, 545-554): P projects X out. With PZ = U S V', w = U'y, A = I + R Z'PZ R and R = (D / noise)^(1/2) they have ::

    -2 log p = n log(2 pi noise) + log det A + (y'Py - w'S V'R A^-1 R V S w) / noise,    n = rows - rank X

so that the rows' covariance is never formed. What is left is summed of squares, for a difference would be rounding
where effects explain nearly all. Rows come whitened, up to the noise's size.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass

import numpy as np

from deltacal_gen.inference.projection import Array, project_out

EXACT = 1e-12  # of a sum of squares: what rounding leaves of it where all is explained
TINY = 1e-300  # of squares: rows without any error


@dataclass(frozen=True, eq=False)
class MixedModel:
    """Rows of random effects, everything else that is estimated projected out.

    Attributes
    ----------
    s : (m,) array
        Singular values of the effects' columns.
    V : (n, m) array
        Right singular vectors; ones (m,) where the effects are these directions themselves.
    w : (m,) array
        Rows along left singular vectors.
    rest : float
        What of y'Py no effect can explain.
    contrasts : int or float
        Rows less the rank of what was projected out.
    """

    s: Array
    V: Array
    w: Array
    rest: float
    contrasts: float

    @staticmethod
    def of(Z: Array, y: Array, Q: Array) -> MixedModel:
        """Return the model of whitened rows y, of effects' columns Z, beside a basis Q of what else is estimated."""
        R, n = np.asarray(np.linalg.qr(project_out(np.column_stack([Z, y]), Q), mode="r")), Z.shape[1]
        U, s, Vt = np.linalg.svd(R[:n, :n], full_matrices=False)
        return MixedModel(s, Vt.T, U.T @ R[:n, n], float((R[n:, n] ** 2).sum()), len(y) - Q.shape[1])

    @staticmethod
    def normal(G: Array, b: Array, squares: float, contrasts: float) -> MixedModel:
        """Return the model of normal equations Z'PZ and Z'Py, and of y'Py."""
        values, V = np.linalg.eigh(G)
        seen = values > EXACT * values.max(initial=0.0)
        s, V = np.sqrt(values[seen]), V[:, seen]
        w = V.T @ b / s
        return MixedModel(s, V, w, max(squares - float(w @ w), EXACT * squares), contrasts)

    def diagonal(self) -> MixedModel:
        """Return the model of combinations of effects that are orthogonal in the rows: of one variance for all."""
        return dataclasses.replace(self, V=np.ones(len(self.s)))

    def deviance(self, variances: Array, noise: float | None = None) -> float:
        """Return -2 log p of the contrasts, but for n log(2 pi).

        Parameters
        ----------
        variances : (n,) array
            Of the effects, D. Where no noise is given they are ratios to it, and it is the likeliest: the constant
            n (1 - log n) is then left out as well.
        noise : float, optional
            Variance of whitened rows.
        """
        n, (left, _, _, L) = self.contrasts, self._solved(variances, noise or 1.0)
        size = n * np.log(left) if noise is None else n * np.log(noise) + left / noise
        return float(size + 2 * np.log(L if L.ndim == 1 else np.diag(L)).sum())

    def slopes(self, variances: Array, noise: float | None = None) -> tuple[Array, float]:
        """Return the derivatives of the deviance by the logarithms of the variances (n,), and of the noise."""
        left, _, mean, L = self._solved(variances, noise or 1.0)
        by, there = np.zeros(len(variances)), np.flatnonzero(variances)
        own = 1 / L**2 if L.ndim == 1 else (_of_triangle(L, np.eye(len(L))) ** 2).sum(axis=0)
        # 1 - E[c^2] / variance: by how much the posterior is narrower, or farther off, than the prior
        by[there] = 1 - own - mean**2 / (noise or left / self.contrasts)
        return by, 0.0 if noise is None else float(self.contrasts - left / noise - by.sum())

    def noise(self, variances: Array) -> float:
        """Return the likeliest noise, for variances that are ratios to it."""
        return self._solved(variances, 1.0)[0] / self.contrasts

    def evidence(self, variances: Array, noise: float) -> float:
        """Return log p of the contrasts."""
        return -0.5 * (self.contrasts * np.log(2 * np.pi) + self.deviance(variances, noise))

    def posterior(self, variances: Array, noise: float) -> tuple[Array, Array]:
        """Return mean (n,) and covariance (n, n) of the effects, given their variances and the noise."""
        _, r, mean, L = self._solved(variances, noise)
        there, out, half = np.flatnonzero(variances), np.zeros(len(variances)), np.zeros((len(r), len(variances)))
        out[there] = r * mean
        half[:, there] = np.diag(r / L) if L.ndim == 1 else _of_triangle(L, np.diag(r))
        return out, noise * (half.T @ half)

    def _solved(self, variances: Array, noise: float) -> tuple[float, Array, Array, Array]:
        """Return what effects leave of the squares; of those with a variance r, A^-1 R W'w and L of A = L L'.

        L is its diagonal (n,) where the model is diagonal.
        """
        there = np.flatnonzero(variances)
        r = np.sqrt(variances[there] / noise)
        if self.V.ndim == 1:
            s = self.s[there]
            L = np.sqrt(1 + (r * s) ** 2)
            mean, moved = r * s * self.w[there] / L**2, np.zeros(len(self.w))
            moved[there] = s * r * mean
        else:
            W: Array = self.s[:, None] * self.V[there].T * r
            # the factor of I + W'W, which rounding makes indefinite where rows have next to no noise
            upper = np.linalg.qr(np.vstack([np.eye(len(r)), W]), mode="r")
            L = (upper * np.sign(np.diag(upper))[:, None]).T
            mean = _of_triangle(L, _of_triangle(L, W.T @ self.w), transposed=True)
            moved = W @ mean
        left = self.rest + float(((self.w - moved) ** 2).sum() + mean @ mean)
        return max(left, TINY), r, mean, L


def unit_variance(columns: Array) -> float:
    """Return the factor by which columns (rows, n) of effects bring a row the variance 1 in the mean."""
    return 1.0 / max(float(np.sqrt((columns**2).sum() / len(columns))), 1e-150)


def _of_triangle(L: Array, values: Array, transposed: bool = False) -> Array:
    """Return L^-1, or L^-T, times values, of a lower triangle."""
    from scipy.linalg import solve_triangular

    return np.asarray(solve_triangular(L, values, trans=int(transposed), lower=True, check_finite=False))
