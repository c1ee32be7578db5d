"""The rows to measure next: what a diagnosis proposes, shared among its open questions, as many as may be measured."""

from __future__ import annotations

import itertools
import re
from collections.abc import Sequence
from dataclasses import dataclass

from deltacal_gen.diagnosis.candidates import one_by_one
from deltacal_gen.diagnosis.discrimination import CLEAR
from deltacal_gen.results.diagnosis import Diagnosis, NextMeasurement, Row
from deltacal_gen.states import TIME

LATER = 60.0  # s from one reading to the next where the rows do not show it
_NUMBER = re.compile(r"\d+$")
_STANDS = re.compile(r"q\d|tool_")  # columns by which rows are repeats of a pose


@dataclass(frozen=True)
class Open:
    """A question that poses can settle: rows in the order of their worth, and the chi2 that the first n make."""

    why: str
    rows: tuple[Row, ...]
    chi2: tuple[float, ...]

    def after(self, n: int) -> float:
        """Return the difference in chi2 that n rows are expected to make; repeats make as much as their mean."""
        if n <= len(self.chi2):
            return self.chi2[n - 1] if n else 0.0
        return self.chi2[-1] * n / len(self.chi2)


def open_questions(found: Diagnosis) -> list[Open]:
    """Return the questions of a diagnosis that come with poses, in its order."""
    return [_open(entry) for entry in found.next_measurements if entry.poses]


def _open(entry: NextMeasurement) -> Open:
    rows = sorted(entry.poses, key=_number) if entry.chi2_by_pose else list(entry.poses)
    rows += entry.further or ()
    each = CLEAR / len(entry.poses)
    return Open(entry.why, tuple(rows), entry.chi2_by_pose or tuple(each * (n + 1) for n in range(len(rows))))


@dataclass(frozen=True)
class Shared:
    """Rows to measure, and how many of them each question has; a row of two questions counts for both."""

    rows: tuple[Row, ...]
    counts: tuple[int, ...]


def shared(questions: Sequence[Open], budget: int | None) -> Shared:
    """Return the rows of open questions: the next one is for what is least separated.

    Without a budget each question gets as many as `CLEAR` takes. Rows are measured again when no question has another.
    """
    counts = [0] * len(questions)
    rows: list[Row] = []
    known: set[tuple[tuple[str, float | str], ...]] = set()
    while budget is None or len(rows) < budget:
        asking = [k for k, q in enumerate(questions) if budget is not None or q.after(counts[k]) < CLEAR]
        if not asking:
            break
        fresh = [k for k in asking if counts[k] < len(questions[k].rows)]
        k = min(fresh or asking, key=lambda k: questions[k].after(counts[k]))
        row = questions[k].rows[counts[k] % len(questions[k].rows)]
        counts[k] += 1
        if _asks(row) in known and fresh:
            continue  # it is measured for another question already
        known.add(_asks(row))
        rows.append(row)
    return Shared(tuple(rows), tuple(counts))


def next_rows(questions: Sequence[Open], found: Shared) -> list[Row]:
    """Return rows as they are to be measured.

    Poses have labels of their own, repeats that of their pose; times come after the last reading, and grow.
    """
    label = min((_number(row) for q in questions for row in q.rows), default=1)
    labels: dict[tuple[tuple[str, float | str], ...], str] = {}
    rows: list[Row] = []
    for row in found.rows:
        stands = tuple((key, v) for key, v in row.items() if _STANDS.match(key))
        if stands not in labels:
            labels[stands] = f"{_NUMBER.sub('', str(row.get('pose', '')))}{label + len(labels)}"
        rows.append(row | {"pose": labels[stands]})
    return _in_time(rows)


def _asks(row: Row) -> tuple[tuple[str, float | str], ...]:
    """Return what a row asks for, whatever its label and its time."""
    return tuple((key, v) for key, v in row.items() if key not in ("pose", TIME))


def _in_time(rows: list[Row]) -> list[Row]:
    """Return rows in the order of their times, each later than the one before."""
    times = sorted({float(row[TIME]) for row in rows if TIME in row})
    if not times:
        return rows
    gap = min((b - a for a, b in itertools.pairwise(times)), default=LATER)
    return one_by_one([row | {TIME: row.get(TIME, times[-1])} for row in rows], times[0] - gap, gap)


def _number(row: Row) -> int:
    found = _NUMBER.search(str(row.get("pose", "")))
    return int(found.group()) if found else 0


def columns_of(rows: Sequence[Row]) -> dict[str, list[float | str]]:
    """Return rows as columns of a recording, a blank where a row says nothing."""
    names = list(dict.fromkeys(name for row in rows for name in row))
    return {name: [row.get(name, float("nan")) for row in rows] for name in names}
