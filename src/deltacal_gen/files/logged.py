"""What loggers make of samples: stamps and rows that come once more, rows of zeros, counts that lost their sign."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np

from deltacal_gen.errors import InputError, TimeOrder
from deltacal_gen.files.rows import Rows
from deltacal_gen.instrument.sampled import at_rate, runs_of, several_at_once
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording
from deltacal_gen.states import TIME

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


def increasing(
    path: Path | str, line: np.ndarray, time: Array, run: np.ndarray, names: Sequence[str]
) -> tuple[np.ndarray, list[str]]:
    """Tell which rows (N,) repeat the time of the one before in their run, and what is said of them.

    Parameters
    ----------
    run : (N,) array of int
        Index into `names`.

    Raises
    ------
    InputError
        Time goes backwards within a run.
    """

    def error(row: int, problem: str, remedy: str) -> InputError:
        return TimeOrder(problem, remedy, file=path, line=int(line[row]), column=TIME)

    again = np.zeros(len(time), dtype=bool)
    for code, name in enumerate(names):
        own = np.flatnonzero(run == code)
        steps = np.diff(time[own])
        if (steps < 0).any():
            k = int(np.argmax(steps < 0))
            raise error(
                own[k + 1],
                f"time goes backwards within {name}: {time[own[k]]:g} s, then {time[own[k + 1]]:g} s.",
                "Sort the rows, or give each uninterrupted movement a label of its own in the column 'run'.",
            )
        if len(steps) > 1 and not steps.any():
            remedy = "Give the time of each sample, or leave the column out."
            raise error(own[0], f"time stands still within {name}.", remedy)
        again[own[1:][steps == 0]] = True
    told = [f"{path}:{n}: the time of the row before once more; the row is left out" for n in line[again]]
    return again, told


def put_right(recording: Recording, run: Sequence[str], *, read: bool) -> Recording:
    """Return samples in motion without those that say once more what the one before says; `repairs` tells of them.

    Joints that stand are read several times, too: what a log holds more than once has joints and readings alike.

    Parameters
    ----------
    run : sequence of str
        What each row's run is called.
    read : bool
        Whether readings are taken from it; else every row is to be answered, and stays.

    Raises
    ------
    InputError
        Time goes backwards within a run.
    """
    if not at_rate(recording):
        return recording
    time, runs = recording.time_s, runs_of(recording)
    assert time is not None
    code = np.empty(recording.n_rows, dtype=int)
    for k, own in enumerate(runs):
        code[own] = k
    names = [run[own[0]] for own in runs]
    again, said = increasing(recording.path, recording.line, time, code, names)
    if several_at_once(recording) or not read:
        return recording
    recording, code = recording.subset(~again), code[~again]
    order = np.argsort(code, kind="stable")
    joints, readings = recording.joints[order], recording.measured[order]
    words = "joints and readings are what they were", "joints and instrument are", "the instrument is"
    held, silent, told = _held(
        recording.path, recording.line[order], code[order], np.hstack([joints, readings]), readings, words
    )
    measured = recording.measured.copy()
    measured[order[silent]] = np.nan
    kept = np.ones(recording.n_rows, dtype=bool)
    kept[order[held]] = False
    recording = dataclasses.replace(recording, measured=measured, repairs=(*said, *told))
    return recording.subset(kept)


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
    words = "joints stand where they stood", "joints are", "drives are"
    again, silent, told = _held(rows.path, rows.line[kept], piece[kept], joints[kept], readings[kept], words)
    readings[np.flatnonzero(kept)[silent]] = np.nan
    kept[np.flatnonzero(kept)[again]] = False
    return kept, said + told


def _held(
    path: Path | str, line: np.ndarray, piece: np.ndarray, stands: Array, readings: Array, words: tuple[str, str, str]
) -> tuple[np.ndarray, np.ndarray, list[str]]:
    """Tell which rows (N,) only hold what the one before them says, which further readings (N, k), and what is said.

    `stands` (N, n) is what a row says of where the machine is; `words` say what then stays, and what is read.
    """
    stay, of_rows, of_readings = words
    again, told = _once_more(stands, piece), list[str]()
    if again.any():
        told.append(
            f"{path}:{line[again][0]}: {stay} a row before, here and on {again.sum() - 1} rows more, though they move: "
            f"the log is written more often than {of_rows} read; these rows are left out"
        )
    silent = np.zeros(len(again), dtype=bool)
    silent[~again] = _once_more(readings[~again], piece[~again])
    if silent.any():
        told.append(
            f"{path}:{line[silent][0]}: all readings are what they were a row before, here and on {silent.sum() - 1} "
            f"rows more: the log is written more often than {of_readings} read; these readings are left out"
        )
    return again, silent, told


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
