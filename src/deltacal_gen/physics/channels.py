"""Channels: what a recording says beside joints and readings, row by row, as effects read it."""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from deltacal_gen import states
from deltacal_gen.errors import TimeOrder
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.values import Recording, Robot, numbered
from deltacal_gen.physics.terms import Term
from deltacal_gen.states import CHANNELS, RECORDED, State
from deltacal_gen.units import joint_factors


@dataclass(frozen=True, eq=False)
class Channels:
    """What a recording says beside joints and readings, row by row.

    Attributes
    ----------
    values : mapping of (N, n_q) or (N,) arrays
        By the names of states, joints as the geometry counts them [rad/s, rad/s^2, 1, degC, K, kg, s]; covariates by
        their columns, as recorded. What the recording does not say is not there.
    order : (N,) array
        The place of each row where there is no time.
    run : (N,) array of int, optional
        Which rows are one uninterrupted movement: the column ``run``, or a set-up; None: all.
    begun : float
        From when effects count the time [s]; see `Recording.origin`.
    """

    values: Mapping[str, Array]
    order: Array
    run: np.ndarray | None = None
    begun: float = 0.0

    def get(self, name: str) -> Array | None:
        """Return a channel, None where the recording says nothing of it; one that is optional is then nowhere."""
        found = self.values.get(name)
        if found is None and states.named(name).optional:
            return np.zeros(len(self.order))
        return found

    def passed(self, state: State) -> Array | None:
        """Return a channel as effects read it: the time since the recording began, all others as they are."""
        found = self.get(state.base)
        return found - self.begun if state.passes and found is not None and self.begun else found

    @property
    def payload(self) -> Array:
        """The payload of each row (N,) [kg], none where none is written."""
        found = self.get("payload")
        assert found is not None  # it is optional
        return np.nan_to_num(found)

    @property
    def clock(self) -> Array:
        """The time of each row (N,) [s]; its place where there is no time."""
        time = self.get("time")
        return self.order if time is None else time

    def subset(self, rows: np.ndarray) -> Channels:
        """Return the channels at these rows."""
        run = None if self.run is None else self.run[rows]
        return Channels({name: v[rows] for name, v in self.values.items()}, self.order[rows], run, self.begun)

    def with_values(self, **values: Array) -> Channels:
        """Return the channels with others, or other ones."""
        return dataclasses.replace(self, values={**self.values, **values})

    @staticmethod
    def of(recording: Recording, robot: Robot) -> Channels:
        """Read the channels of a recording; joint channels are turned as the geometry counts."""
        found = Channels.from_columns(recording.channels, recording.joints.shape, robot, recording.joint_unit)
        label = found.values.get("run", np.zeros(len(recording.joints)))
        run = numbered(np.column_stack([recording.setup, label]))
        return dataclasses.replace(found, run=run, begun=recording.origin)

    @staticmethod
    def from_columns(
        columns: Mapping[str, Array], shape: tuple[int, ...], robot: Robot, joint_unit: str = "rad"
    ) -> Channels:
        """Read channels from columns (N,) as files name them; `shape` is (N, n_q)."""
        rows, n = shape
        own = {s.column: _of_parts(s, columns) for s in RECORDED if s.parts}
        values, known = {}, set()
        for s in CHANNELS:
            names = s.columns(joint_unit, n)
            known |= set(names)
            found = [own.get(name, columns.get(name)) for name in names]
            given = [f - s.zero for f in found if f is not None]
            if len(given) < len(names):
                continue
            values[s.name] = given[0]
            if s.per == "joint":
                factors = joint_factors(joint_unit, n) if "{unit}" in s.column else [1.0] * n
                each = zip(factors, robot.joint_sign, given, strict=True)
                values[s.name] = np.column_stack([c * sign * f for c, sign, f in each])
        values |= {name: column for name, column in columns.items() if name not in known}
        return Channels(values, np.arange(rows, dtype=float))


def _filled(columns: Mapping[str, Array], shape: tuple[int, int], joint_unit: str) -> dict[str, Array]:
    """Return columns, those of joints complete where some are given: blank, the others."""
    n, limbs = shape
    out = dict(columns)
    for read in (c for c in CHANNELS if c.per == "joint"):
        names = read.columns(joint_unit, limbs)
        if any(name in columns for name in names):
            out |= {name: np.full(n, np.nan) for name in names if name not in columns}
    return out


def _of_parts(s: State, columns: Mapping[str, Array]) -> Array | None:
    """Return a channel of the machine: its column; where parts have columns instead, as thermometers, their mean."""
    parts = [v for name, v in sorted(columns.items()) if s.part(name)]
    return columns.get(s.column, np.mean(parts, axis=0) if parts else None)


def complete_channels(
    columns: Mapping[str, Array], shape: tuple[int, int], robot: Robot, joint_unit: str, terms: Sequence[Term]
) -> tuple[Channels, list[str]]:
    """Return channels that lack nothing but perhaps the time, and in words what was assumed for which effects.

    Parameters
    ----------
    columns : mapping of (N,) arrays
        By the names of a recording's channels, in their units; nan where not given.
    shape : (N, n_q)

    Raises
    ------
    InputError
        Some rows have a time and some have none.
    """
    n, limbs = shape
    have = Channels.from_columns(_filled(columns, shape, joint_unit), shape, robot, joint_unit)
    values, said = dict(have.values), []
    assuming = [s for s in states.STATES.values() if s.assumed]
    for (column, assumed), found in itertools.groupby(assuming, key=lambda s: (s.column, s.assumed)):
        own = tuple(found)
        read = next(c for c in CHANNELS if c.column == column)
        given = have.values.get(read.name, np.full((n, limbs) if read.per == "joint" else n, np.nan))
        cells = np.isnan(given).reshape(n, -1)
        users = [t for t in terms if {s.base for s in own} & {c.base for s in t.states for c in s.channels}]
        if read.per == "joint" and all(t.limbs for t in users):  # of joints whose direction nothing asks for
            cells = cells[:, sorted({i - 1 for t in users for i in t.limbs})]
        blank = cells.any(axis=1)
        for s in own:
            if read.whole and blank.all():
                values.pop(s.name, None)
            elif not s.by:
                values[s.name] = np.nan_to_num(values.get(s.name, np.full(given.shape, np.nan)), nan=s.default - s.zero)
        if not users or not blank.any():
            continue
        names = read.columns(joint_unit, limbs)
        name = f"{names[0]} ... {names[-1]}" if len(names) > 1 else names[0]
        where = "not given" if blank.all() else f"blank in {blank.sum()} of {n} rows"
        said.append(f"{name} {where}: {assumed} ({', '.join(t.effect for t in users)})")
        if read.whole and not blank.all():
            raise TimeOrder(
                "some rows have a time and some have none.",
                "Fill in all cells, or leave the column out.",
                column=column,
            )
    run = numbered(columns["run"][:, None]) if "run" in columns else None
    return Channels(values, have.order, run), said
