"""What loggers make of samples: rows of zeros, rows that say the last one once more, counts that lost their sign."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

if TYPE_CHECKING:
    from deltacal_gen.files.rows import Rows
    from deltacal_gen.machine.registry import Array

FINE = 5.0  # counts by which a column changes at least, where it changes: it does not stand still in between
ONE_BY_ONE = 2  # rows that say the same, of half of all: what is written more often than it is read
GOES_ON = 5.0  # times what a reading ordinarily changes by: so much it may where its sign changes
VARIOUS = 3  # values below zero: fewer stand for no reading


class _Code(NamedTuple):
    """How a drive writes what is below zero: from `first` on, to below `end`, as `value` tells."""

    first: int
    end: int
    value: Callable[[Array], Array]
    text: str


CODES = (
    _Code(1 << 15, 1 << 16, lambda v: v - (1 << 16), "two's complement of 16 bits"),
    _Code(1 << 31, 1 << 32, lambda v: v - (1 << 32), "two's complement of 32 bits"),
    _Code(1 << 15, 1 << 16, lambda v: (1 << 15) - v, "bit 15 for the direction"),
    _Code(1 << 10, 1 << 11, lambda v: (1 << 10) - v, "bit 10 for the direction"),  # Dynamixel AX and MX, Feetech
)


def logged(
    rows: Rows, piece: np.ndarray, joints: Array, readings: Array, columns: Sequence[str]
) -> tuple[np.ndarray, list[str]]:
    """Tell which rows (N,) of a log hold samples, and what is said of the others; readings (N, k) are put right.

    Parameters
    ----------
    joints : (N, n_q) array
        As in the file.
    piece : (N,) array of int
        Which rows are one movement without a gap.
    """
    said, where = list[str](), f"{rows.path}:"
    for name, values in zip(columns, readings.T, strict=True):
        if (code := _lost_sign(values, piece)) is not None:
            below = values >= code.first
            first = int(np.argmax(below))
            said.append(
                f"{where}{rows.line[first]}: {name} reads {values[first]:g} for what is below zero ({code.text}), here "
                f"and on {below.sum() - 1} rows more; it is read with its sign"
            )
            values[below] = code.value(values[below])
    nothing = (joints == 0).all(axis=1) & (readings == 0).all(axis=1)
    if nothing.any() and not nothing.all():
        said.append(
            f"{where}{rows.line[nothing][0]}: joints and readings are all zero, here and on {nothing.sum() - 1} rows "
            "more; these rows are left out"
        )
    kept = ~nothing
    again = np.zeros(len(kept), dtype=bool)
    again[kept] = _once_more(joints[kept], piece[kept])
    if again.any():
        said.append(
            f"{where}{rows.line[again][0]}: joints stand where they stood a row before, here and on {again.sum() - 1} "
            "rows more, though they move: the log is written more often than joints are read; these rows are left out"
        )
        kept &= ~again
    again = np.zeros(len(kept), dtype=bool)
    again[kept] = _once_more(readings[kept], piece[kept])
    if again.any():
        said.append(
            f"{where}{rows.line[again][0]}: all drives read what they read a row before, here and on {again.sum() - 1} "
            "rows more: the log is written more often than drives are read; these readings are left out"
        )
        readings[again] = np.nan
    return kept, said


def _once_more(values: Array, piece: np.ndarray) -> np.ndarray:
    """Tell which rows (N,) only say once more what the one before says: of a log that is written too often.

    Where it stands still for longer, every so many rows count. Coarse counts may stay the same for a while, but then
    change by one.
    """
    same = (np.diff(values, axis=0) == 0) | np.isnan(values[1:]) & np.isnan(values[:-1])
    new = np.concatenate([[True], ~(same.all(axis=1) & (np.diff(piece) == 0))])[: len(values)]
    length = np.diff(np.append(np.flatnonzero(new), len(values)))
    often = int(np.median(length)) if len(length) else 0
    each = [step[step > 0] for step in np.abs(np.diff(values, axis=0)).T]
    if often < ONE_BY_ONE or not any(len(own) and np.median(own) >= FINE * own.min() for own in each):
        return np.zeros(len(values), dtype=bool)
    place = np.arange(len(values)) - np.repeat(np.flatnonzero(new), length)
    return np.asarray((place % often != 0) | (place > 0) & (place < 2 * often))


def _lost_sign(values: Array, piece: np.ndarray) -> _Code | None:
    """Return how a reading (N,) writes what is below zero, where it does so by counts above all others."""
    known = np.isfinite(values)
    v = values[known]
    if not len(v) or (v < 0).any() or (v != np.round(v)).any():
        return None
    within = np.diff(piece[known]) == 0
    for code in CODES:
        below = v >= code.first
        if v.max() >= code.end or len(np.unique(v[below])) < VARIOUS:
            continue
        turns = within & (np.diff(below.astype(int)) != 0)
        read, raw = np.abs(np.diff(np.where(below, code.value(v), v))), np.abs(np.diff(v))
        others = read[within & ~turns]
        usual = max(GOES_ON * float(np.quantile(others, 0.99)), 1.0) if len(others) else 0.0
        if turns.any() and np.median(read[turns]) <= usual < np.median(raw[turns]):
            return code
    return None
