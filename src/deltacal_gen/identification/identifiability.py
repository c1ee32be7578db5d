"""What the data pin down: identification matrices, ranks, observability, and the combinations that stay free.

Ranks are decided on columns scaled to ordinary errors (``Machine.typical``) or, where a convention of the papers is
asked for, on its columns; a singular value below `RANK_TOLERANCE` of the largest is zero. Condition numbers depend on
the scaling, so every one is given with its convention.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.errors import UnknownName
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.files.robot import Robot
from deltacal_gen.inference.projection import basis, project_out
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.units import file_unit, to_internal

SHARE = 1e-6  # of the largest share, or of a column: less is rounding
TOLD, MOST_TOLD = 1e-3, 8  # of the largest share: what is told by name, and how many at most
RANK_TOLERANCE = 1e-9
NOT_AT_ALL = "moves no reading at all", "change no reading"  # one parameter, several
WEAKLY = "moves the readings by less than their noise", "change the readings by less than their noise"
RESOLVED = 0.5  # of a variance, a direction's or a parameter's, that readings explain: else the prior knows it better
CONVENTIONS = ("file", "paper", "table", "typical")


@dataclass(frozen=True)
class IdentificationMatrix:
    """The linear problem ``H p = r`` of a recording at the robot file's machine.

    Attributes
    ----------
    H : (rows, n) array
        Readings by parameters, an unknown instrument projected out [mm per unit of the convention].
    r : (rows,) array
        Measured minus nominal, projected likewise [mm].
    moved : (rows, n) array
        Readings by parameters where the instrument stays: what H is before the projection.
    names : tuple of str
    units : tuple of str
        Of the parameters in the convention.
    convention : str
        ``file``: mm and deg; ``paper``: the unknowns of the paper's equations; ``table``: those of its tables;
        ``typical``: in ordinary errors.
    """

    H: Array
    r: Array
    moved: Array
    names: tuple[str, ...]
    units: tuple[str, ...]
    convention: str


@dataclass(frozen=True)
class Observability:
    """Figures of an identification matrix.

    ``indices`` O1 .. O5 as in the literature: geometric mean of the singular values over the square root of the number
    of poses (Borm, Menq 1991), inverse condition number (Driels, Pathre 1990), smallest singular value (Nahvi,
    Hollerbach 1994), noise amplification (Nahvi, Hollerbach 1996), harmonic sum (Sun, Hollerbach 2008).
    """

    rank: int
    columns: int
    condition: float
    singular_values: Array
    indices: dict[str, float]


@dataclass(frozen=True)
class Combination:
    """A combination of parameters along which readings change by nothing, or by less than their noise.

    Attributes
    ----------
    terms : dict
        Parameter to its share [mm, rad], the largest share in ordinary errors being 1.
    shares : str
        The same in words, moved together where they are several.
    effect : str
        What that does.
    """

    terms: dict[str, float]
    shares: str
    effect: str

    @property
    def text(self) -> str:
        """The combination and what it does, in words."""
        return f"{self.shares} {self.effect}"


@dataclass(frozen=True)
class Seen:
    """What readings pin down of a model.

    Attributes
    ----------
    observability : Observability
        Of the identification matrix at the robot file's machine, columns in ordinary errors.
    unseen, weak : list of Combination
        What no reading sees, and what the readings see less well than a broad prior.
    absorbed : int
        How many directions of `unseen` would move readings if the instrument's place were known.
    base : dict
        What the readings determine, parameter by parameter with those that act through it; see `base_parameters`.
    """

    observability: Observability
    unseen: list[Combination]
    weak: list[Combination]
    absorbed: int
    base: dict[str, dict[str, float]]


def seen(final: Fit, own: Problem) -> Seen:
    """Return what the readings of a fit pin down of its parameters; `own` is its problem in ordinary errors."""
    mechanism, matrix, names = own.mechanism, identification_matrix(own, "typical"), own.names
    units, typical = [mechanism.parameters[j].unit for j in own.columns], mechanism.typical[own.columns]
    per_unit = matrix.H / typical
    found = unseen(per_unit, names, units, typical)
    found, absorbed = _beside(found, matrix, typical, own.readings.kind.whereabouts)
    solution = final.solution
    order = np.argsort(solution.singular_values)[len(found) :]
    rows = [solution.V[:, j] for j in order if solution.factors[j] < RESOLVED]
    weak = combinations(np.array(rows), names, units, final.problem.scale, WEAKLY) if rows else []
    observed = observability(matrix.H, len(np.unique(own.readings.group)))
    return Seen(observed, found, weak, absorbed, base_parameters(per_unit, names, typical) if found else {})


def identification_matrix(problem: Problem, convention: str = "file") -> IdentificationMatrix:
    """Return the identification matrix of a problem, at the robot file's geometry.

    Positions and poses in an unknown frame have the frame projected out of H and r, distances need none. The rows of
    an incremental gauge are differences of adjacent readings (Mei 2018, eq. 24). Weights play no part; rotations count
    in rad.

    Raises
    ------
    UsageError
        An unknown convention.
    """
    factors, units = column_convention(problem.robot, problem.names, convention)
    machine = problem.solve(problem.reference)
    instrument = problem.begin(problem.reference, machine)
    state = problem.linearise(problem.reference, instrument, machine)
    read = np.isfinite(state.residual)
    J_p, J_m, r = state.J_p[read], state.J_m[read], state.residual[read]
    if problem.readings.kind.in_differences(problem.recording.measurement):
        J_p, J_m, r = np.diff(J_p, axis=0), np.diff(J_m, axis=0)[:, :-1], np.diff(r)  # the zero falls out
    moved = J_p * factors
    if J_m.shape[1] and len(problem.readings) * state.residual.shape[1] >= instrument.n_unknown:
        Q = basis(J_m)
        J_p, r = project_out(J_p, Q), project_out(r, Q)
    return IdentificationMatrix(J_p * factors, r, moved, problem.names, units, convention)


def column_convention(robot: Robot, names: Sequence[str], convention: str) -> tuple[Array, tuple[str, ...]]:
    """Return the factors (n,) by which columns per mm and rad are multiplied, and the units of the unknowns.

    Raises
    ------
    UsageError
        An unknown convention.
    """
    if convention not in CONVENTIONS:
        raise UnknownName(f"there is no scaling '{convention}'; known: {', '.join(CONVENTIONS)}.")
    mechanism = mechanism_of(robot)
    columns = [mechanism.index[n] for n in names]
    units = [mechanism.parameters[j].unit for j in columns]
    if convention == "file":
        return np.array([to_internal(u) for u in units]), tuple(file_unit(u) for u in units)
    if convention == "typical":
        return mechanism.typical[columns], ("1",) * len(units)
    scale = mechanism.scaling(convention, robot, names)
    # an angle times a length is a length; a length over a length, an angle
    lengths = [s > 1 if u == "rad" else s == 1 for u, s in zip(units, scale, strict=True)]
    return 1 / scale, tuple("mm" if is_length else "rad" for is_length in lengths)


def observability(H: Array, poses: int) -> Observability:
    """Return rank, condition number and observability indices of an identification matrix.

    The condition number is of the largest to the smallest singular value; infinite where the rank is short.
    """
    n, s = H.shape[1], np.asarray(np.linalg.svd(H, compute_uv=False) if H.size else np.zeros(0))
    rank, indices = _rank(s), dict.fromkeys(("O1", "O2", "O3", "O4", "O5"), 0.0)
    if not 0 < n == rank:
        return Observability(rank, n, float("inf"), s, indices)
    least = s[-1]
    figures = (np.exp(np.mean(np.log(s))) / np.sqrt(poses), least / s[0], least, least**2 / s[0], 1 / np.sum(1 / s))
    indices = dict(zip(indices, map(float, figures), strict=True))
    return Observability(rank, n, float(s[0] / least), s, indices)


def _rank(sizes: Array) -> int:
    """Return how many of singular values, or of a pivoted triangle's diagonal, the largest first, are not zero."""
    return int((sizes > RANK_TOLERANCE * sizes.max(initial=0.0)).sum())


def unseen(H: Array, names: Sequence[str], units: Sequence[str], typical: Array) -> list[Combination]:
    """Return a sparse basis of the combinations that H does not see.

    Parameters
    ----------
    H : (rows, n) array
        Per mm and rad.
    names, units : sequences of str
        Internal units.
    typical : (n,) array
        Ordinary errors, by which columns are scaled before the rank is decided.
    """
    scaled = H * typical
    if len(scaled) > scaled.shape[1]:
        scaled = np.asarray(np.linalg.qr(scaled, mode="r"))  # the same rows, seen from the columns
    _, s, Vt = np.linalg.svd(scaled, full_matrices=True)
    return combinations(Vt[_rank(s) :], names, units, typical)


def _beside(
    found: Sequence[Combination], matrix: IdentificationMatrix, per: Array, standing: str
) -> tuple[list[Combination], int]:
    """Return combinations beside what stands open in the instrument, and how many directions of them move readings.

    Those that do are told with `standing`, which takes that up. Columns of the matrix are `per` (n,) [mm, rad].
    """
    if not found:
        return [], 0
    share = np.array([[c.terms.get(name, 0.0) for name in matrix.names] for c in found]) / per
    moved = matrix.moved @ share.T
    least = RANK_TOLERANCE * float(np.linalg.norm(matrix.moved, axis=0).max(initial=0.0))
    effect = f"and {standing} are one number in these readings"
    far = np.linalg.norm(moved, axis=0) > least
    each = [dataclasses.replace(c, effect=effect) if taken else c for c, taken in zip(found, far, strict=True)]
    return each, int((np.linalg.svd(moved, compute_uv=False) > least).sum())


def combinations(
    basis: Array, names: Sequence[str], units: Sequence[str], typical: Array, effects: tuple[str, str] = NOT_AT_ALL
) -> list[Combination]:
    """Return a sparse basis, in words, of the space spanned by the rows of `basis` (k, n), in ordinary errors.

    `effects` says what one parameter, or several together, do to readings.
    """
    unit, found = dict(zip(names, units, strict=True)), []
    for row in _reduced(np.array(basis)):
        share = row / row[np.argmax(np.abs(row))]
        terms = {names[j]: float(share[j] * typical[j]) for j in np.argsort(-np.abs(share)) if abs(share[j]) > SHARE}
        shown = min(int((np.abs(share) > TOLD).sum()), MOST_TOLD)
        found.append(Combination(terms, _words(terms, unit, shown), effects[len(terms) > 1]))
    return found


def _reduced(basis: Array) -> Array:
    """Return the reduced row echelon form with full pivoting: each row has a 1 where all others have 0."""
    rows = basis.copy()
    free = np.ones(rows.shape[1], dtype=bool)
    for k in range(len(rows)):
        i, j = np.unravel_index(int(np.argmax(np.abs(rows[k:]) * free)), rows[k:].shape)
        free[j] = False
        rows[[k, k + int(i)]] = rows[[k + int(i), k]]
        rows[k] /= rows[k, j]
        others = np.arange(len(rows)) != k
        rows[others] -= np.outer(rows[others, j], rows[k])
    rows[np.abs(rows) < 1e-9] = 0.0
    return rows


def _words(terms: dict[str, float], units: dict[str, str], count: int) -> str:
    if len(terms) == 1:
        return next(iter(terms))
    shown = [f"{n} by {v / to_internal(units[n]):+.3g} {file_unit(units[n])}" for n, v in terms.items()][:count]
    if rest := len(terms) - count:
        shown.append(f"{rest} smaller share{'s'[: rest > 1]}")
    return f"{', '.join(shown[:-1])} and {shown[-1]}, moved together,"


def base_parameters(H: Array, names: Sequence[str], typical: Array) -> dict[str, dict[str, float]]:
    """Return the base parameters of H (rows, n), per mm and rad: those that a pivoted QR keeps (Savoure 2006, II.B).

    Each, in the order of `names`, comes with the factors [mm, rad] of those that act through it, 1 for itself: the
    readings determine that sum.
    """
    from scipy import linalg

    _, R, order = linalg.qr(H * typical, mode="economic", pivoting=True)
    rank = _rank(np.abs(np.diag(R)))
    share = linalg.solve_triangular(R[:rank, :rank], R[:rank, rank:])
    factors = np.where(np.abs(share) > SHARE, share * typical[order[:rank], None] / typical[order[rank:]], 0.0)
    through = {
        names[kept]: {names[kept]: 1.0} | {names[j]: float(f) for j, f in zip(order[rank:], own, strict=True) if f}
        for kept, own in zip(order[:rank], factors, strict=True)
    }
    return {name: through[name] for name in names if name in through}


def sum_of(terms: Mapping[str, float], units: Mapping[str, str]) -> str:
    """Return a sum of parameters in words, in units of files; `units` are those inside."""
    out, first = "", next(iter(terms))
    for name, factor in terms.items():
        value = factor * to_internal(units[name]) / to_internal(units[first])
        size = "" if abs(abs(value) - 1) < SHARE else f"{abs(value):.4g} "
        out += name if name == first else f" {'-' if value < 0 else '+'} {size}{name}"
    return out
