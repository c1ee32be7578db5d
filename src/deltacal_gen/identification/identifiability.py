"""What the data pin down: identification matrices, ranks, observability, and the combinations that stay free.

Ranks are decided on columns scaled to ordinary errors (``Machine.typical``) or, where a convention of the papers is
asked for, on its columns; a singular value below `RANK_TOLERANCE` of the largest is zero. Condition numbers depend on
the scaling, so every one is given with its convention.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen.errors import UnknownName
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.files.robot import Robot
from deltacal_gen.inference.projection import basis, project_out
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.units import file_unit, to_internal

TOLD, MOST_TOLD = 1e-3, 8  # of the largest share: what is told by name, and how many at most
RANK_TOLERANCE = 1e-9
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
    """A combination of parameters that no reading sees: moving along it changes nothing that was measured.

    Attributes
    ----------
    terms : dict
        Parameter to its share [mm, rad], the largest share in ordinary errors being 1.
    text : str
    """

    terms: dict[str, float]
    text: str


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
    s = np.asarray(np.linalg.svd(H, compute_uv=False) if H.size else np.zeros(0))
    n = H.shape[1]
    if not n:
        return Observability(0, 0, float("inf"), s, dict.fromkeys(("O1", "O2", "O3", "O4", "O5"), 0.0))
    rank = int((s > RANK_TOLERANCE * s[0]).sum()) if len(s) and s[0] > 0 else 0
    full = rank == n
    kept = s[:rank]
    indices = {
        "O1": float(np.exp(np.mean(np.log(s[:n]))) / np.sqrt(poses)) if full else 0.0,
        "O2": float(s[n - 1] / s[0]) if full else 0.0,
        "O3": float(s[n - 1]) if full else 0.0,
        "O4": float(s[n - 1] ** 2 / s[0]) if full else 0.0,
        "O5": float(1 / np.sum(1 / s[:n])) if full else 0.0,
    }
    return Observability(rank, n, float(kept[0] / kept[-1]) if full else float("inf"), s, indices)


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
    rank = int((s > RANK_TOLERANCE * s[0]).sum()) if len(s) and s[0] > 0 else 0
    return combinations(Vt[rank:], names, units, typical)


def beside(
    found: Sequence[Combination], matrix: IdentificationMatrix, per: Array, standing: str
) -> tuple[list[Combination], int]:
    """Return combinations beside what stands open in the instrument, and how many directions of them move readings.

    Those that do are told with what takes that up.

    Parameters
    ----------
    found : sequence of Combination
        Of the parameters of `matrix`.
    per : (n,) array
        What its columns are per [mm, rad].
    standing : str
        What is unknown of the instrument, in words.
    """
    if not found:
        return [], 0
    share = np.array([[c.terms.get(name, 0.0) for name in matrix.names] for c in found]) / per
    moved = matrix.moved @ share.T
    least = RANK_TOLERANCE * float(np.linalg.norm(matrix.moved, axis=0).max(initial=0.0))
    each = []
    for one, far in zip(found, np.linalg.norm(moved, axis=0), strict=True):
        text = one.text.replace(" moves no reading at all", "").replace(", moved together, change no reading", "")
        together = ", moved together," if len(one.terms) > 1 else ""
        said = f"{text}{together} and {standing} are one number in these readings"
        each.append(Combination(one.terms, said) if far > least else one)
    return each, int((np.linalg.svd(moved, compute_uv=False) > least).sum())


def combinations(basis: Array, names: Sequence[str], units: Sequence[str], typical: Array) -> list[Combination]:
    """Return a sparse basis, in words, of the space spanned by the rows of `basis` (k, n), in ordinary errors."""
    rows = _reduced(np.array(basis))
    found = []
    for row in rows:
        row = row / row[np.argmax(np.abs(row))]
        terms = {names[j]: float(row[j] * typical[j]) for j in np.argsort(-np.abs(row)) if abs(row[j]) > 1e-6}
        shown = min(int((np.abs(row) > TOLD).sum()), MOST_TOLD)
        found.append(Combination(terms, _words(terms, dict(zip(names, units, strict=True)), shown)))
    return found


def _reduced(basis: Array) -> Array:
    """Return the reduced row echelon form with full pivoting: each row has a 1 where all others have 0."""
    rows = basis.copy()
    free = list(range(rows.shape[1]))
    for k in range(len(rows)):
        block = np.abs(rows[k:][:, free])
        i, j = np.unravel_index(int(np.argmax(block)), block.shape)
        column = free.pop(int(j))
        rows[[k, k + int(i)]] = rows[[k + int(i), k]]
        rows[k] /= rows[k, column]
        for other in range(len(rows)):
            if other != k:
                rows[other] -= rows[other, column] * rows[k]
    rows[np.abs(rows) < 1e-9] = 0.0
    return rows


def _words(terms: dict[str, float], units: dict[str, str], count: int) -> str:
    parts = [
        f"{name} by {value / to_internal(units[name]):+.3g} {file_unit(units[name])}" for name, value in terms.items()
    ]
    if len(parts) == 1:
        return f"{next(iter(terms))} moves no reading at all"
    rest = len(parts) - count
    shown = parts[:count] + [f"{rest} smaller share{'s'[: rest > 1]}"] * (rest > 0)
    return f"{', '.join(shown[:-1])} and {shown[-1]}, moved together, change no reading"


def base_parameters(H: Array, names: Sequence[str], typical: Array) -> tuple[list[str], dict[str, dict[str, float]]]:
    """Return the parameters that a pivoted QR keeps, and how each dropped one acts through them (Savoure 2006, II.B).

    Returns
    -------
    kept : list of str
    dropped : dict
        Dropped parameter to {kept parameter: factor}: its column is that combination of kept columns [mm, rad].
    """
    from scipy import linalg

    scaled = H * typical
    _, R, order = linalg.qr(scaled, mode="economic", pivoting=True)
    diagonal = np.abs(np.diag(R))
    rank = int((diagonal > RANK_TOLERANCE * diagonal[0]).sum()) if len(diagonal) else 0
    share = linalg.solve_triangular(R[:rank, :rank], R[:rank, rank:])
    kept = [names[j] for j in order[:rank]]
    dropped = {
        names[order[rank + c]]: {
            names[order[i]]: float(share[i, c] * typical[order[i]] / typical[order[rank + c]])
            for i in range(rank)
            if abs(share[i, c]) > 1e-6
        }
        for c in range(H.shape[1] - rank)
    }
    return kept, dropped


@dataclass(frozen=True)
class BaseParameter:
    """A parameter together with those that act through it: what the readings determine of them.

    Attributes
    ----------
    name : str
        Of the parameter that the pivoted QR keeps.
    terms : dict
        Parameter to its factor in the combination, 1 for `name` itself [mm, rad].
    text : str
        The combination in words, in mm and deg.
    """

    name: str
    terms: dict[str, float]
    text: str


def base(H: Array, names: Sequence[str], units: Sequence[str], typical: Array) -> list[BaseParameter]:
    """Return the base parameters of H (rows, n), per mm and rad, in the order of `names`; see `base_parameters`."""
    kept, dropped = base_parameters(H, names, typical)
    unit = dict(zip(names, units, strict=True))
    found = []
    for name in sorted(kept, key=list(names).index):
        terms = {name: 1.0} | {n: factors[name] for n, factors in dropped.items() if name in factors}
        found.append(BaseParameter(name, terms, _sum(terms, unit)))
    return found


def _sum(terms: dict[str, float], units: dict[str, str]) -> str:
    out, first = "", next(iter(terms))
    for name, factor in terms.items():
        value = factor * to_internal(units[name]) / to_internal(units[first])
        size = "" if abs(abs(value) - 1) < 1e-6 else f"{abs(value):.4g} "
        out += name if name == first else f" {'-' if value < 0 else '+'} {size}{name}"
    return out
