"""Contacts: fixed points that are touched, a ball in a socket, a tip in a cone; no instrument at all.

A touched point has a frame of its own, along the axes of {O}, in which it reads zero: the formulas are a position's.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

import numpy as np

from deltacal_gen.errors import MissingColumn, WrongKind
from deltacal_gen.instrument.facts import Look
from deltacal_gen.instrument.kind import Frame, Instrument, Kind, Readings
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.values import Measurement, Recording, Robot

if TYPE_CHECKING:
    from deltacal_gen.results.result import TouchedPoint

TIE_STEPS = 4  # each squares what a known distance is off
ORIGIN = slice(9, 12)  # of the frames, in their state
SHIFT = (3, 4, 5)  # among the unknowns


def names(recording: Recording) -> list[str]:
    """Return the names of the points that are touched, in the order of the instrument's state."""
    assert recording.contact is not None
    found: list[str] = np.unique(recording.contact[recording.contact != ""]).tolist()
    return found


@dataclass(frozen=True)
class Contact(Kind):
    """Contacts with fixed points."""

    formulas: ClassVar[str] = "position"
    anew: ClassVar[bool] = True
    follows: ClassVar[bool] = True
    touched: ClassVar[tuple[str, ...]] = ("x", "y", "z", "radius")
    whereabouts: ClassVar[str] = "where the touched points lie"
    rotation_beside: ClassVar[bool] = False  # who touches points has no instrument that reads it

    @property
    def meaning(self) -> str:
        """What is read, in words."""
        return "name of the fixed point that is touched"

    @property
    def targets(self) -> Mapping[str, int]:
        """None: what is touched reads nothing."""
        return {}

    @property
    def numbers(self) -> bool:
        """Names, not numbers."""
        return False

    def columns(self, mechanism: Machine) -> tuple[str, ...]:
        """Return the column of names."""
        return self.reserved

    @property
    def reserved(self) -> tuple[str, ...]:
        """The column of names."""
        return ("contact",)

    def check(
        self, said: Measurement, ties: Sequence[tuple[str, str, float]], cells: Mapping[str, Sequence[str]], file: Path
    ) -> None:
        """Raise an InputError where a known distance names a point that no row touches."""
        touched = set(cells.get("contact", ()))
        for a, b, _ in ties if touched else ():
            if unknown := {a, b} - touched:
                raise MissingColumn(
                    f"[contacts] distance_mm names '{min(unknown)}', which no row has in its column 'contact'.",
                    f"Use names of {', '.join(sorted(touched - {''}))}.",
                    file=file,
                )

    def readings(self, recording: Recording, pose: np.ndarray) -> Readings:
        """Return a zero for each row that touches a point; the point is its set-up."""
        assert recording.contact is not None
        taken = np.flatnonzero(recording.contact != "")
        setup = np.searchsorted(names(recording), recording.contact[taken])
        zeros = np.zeros((len(taken), self.width))
        return Readings(self, taken[:, None], zeros, None, setup, pose[taken], recording.line[taken])

    def unread(self, recording: Recording) -> Readings:
        """Raise an InputError: nothing could be read."""
        raise WrongKind(
            "a contact reads nothing that could be simulated or predicted: its joints are the reading.",
            'Ask for the kind position, with frame = "robot" in the sidecar.',
            file=recording.path,
        )

    def start(self, found: Readings, recording: Recording, robot: Robot, x: Array) -> Instrument:
        """Return the points where the machine touches them in the mean, at the distances that are known."""
        own = names(recording)
        at = [x[found.rows[found.setup == s, 0], :3] for s in range(len(own))]
        state = [[*np.eye(3).ravel(), *(-P.mean(axis=0) if len(P) else np.zeros(3))] for P in at]
        known = (tie for tie in recording.contact_distances if {tie[0], tie[1]} <= set(own))  # not all of a part
        ties = tuple((own.index(a), own.index(b), d) for a, b, d in known)
        return self.tied(Instrument(self, np.array(state), SHIFT, ties=ties))

    def drawn(
        self, recording: Recording, robot: Robot, x: Array, frame: Frame | None, rng: np.random.Generator | None
    ) -> Instrument:
        """Raise an InputError: nothing could be read."""
        self.unread(recording)
        raise AssertionError

    def own(self, found: Readings, recording: Recording, robot: Robot, poses: Callable[[], Array]) -> Instrument | None:
        """Return the points where the machine touches them: they are unknown in every session."""
        return self.start(found, recording, robot, poses())

    def points(self, instrument: Instrument, recording: Recording) -> tuple[TouchedPoint, ...]:
        """Return where the points are in {O}."""
        from deltacal_gen.results.result import TouchedPoint

        return tuple(
            TouchedPoint(name=str(n), position_mm=tuple((-t).tolist()))
            for n, t in zip(names(recording), instrument.state[:, ORIGIN], strict=True)
        )

    @staticmethod
    def _ties(instrument: Instrument) -> tuple[Array, Array]:
        """Return the derivatives (ties, 3 rows) of tied distances by the points, and by how much they are off."""
        ties, state = instrument.ties, instrument.state
        slope, off = np.zeros((len(ties), len(state), 3)), np.zeros(len(ties))
        for i, (a, b, distance) in enumerate(ties):
            gap = state[b, ORIGIN] - state[a, ORIGIN]
            length = max(float(np.linalg.norm(gap)), 1e-12)
            slope[i, b], slope[i, a], off[i] = gap / length, -gap / length, length - distance
        return slope.reshape(len(ties), -1), off

    def loose(self, instrument: Instrument) -> Array:
        """Return the directions (3 rows, n_unknown) of the points that keep the distances known between them."""
        directions: Array = np.linalg.svd(self._ties(instrument)[0])[2][len(instrument.ties) :].T
        return directions

    def tied(self, instrument: Instrument) -> Instrument:
        """Return the points moved, as little as need be, to the distances that are known."""
        for _ in range(TIE_STEPS if instrument.ties else 0):
            slope, off = self._ties(instrument)
            state = instrument.state.copy()
            state[:, ORIGIN] -= (np.linalg.pinv(slope) @ off).reshape(-1, 3)
            instrument = dataclasses.replace(instrument, state=state)
        return instrument

    @property
    def planned(self) -> str:
        """Nothing: where the points are is not known beforehand."""
        return ""

    def looks(self, mechanism: Machine, points: int, stands: int) -> tuple[Look, ...]:
        """Return contacts, of a machine that comes to a point in several ways, or with several points."""
        if mechanism.turning:
            words = f"contacts with fixed points, each in {stands} ways"
            return (Look(words, 1, "unknown frame, one point", touches=True),)
        if mechanism.limbs == len(mechanism.axes):
            several = "unknown frame, several points"
            return (Look("contacts with fixed points", points, several, touches=True),)
        return ()

    def imagined(self, x: Array, sets: int, mechanism: Machine, said: Measurement) -> tuple[Readings, Instrument]:
        """Return contacts at poses whose points are the same in every block."""
        each = len(x) // sets
        state = np.column_stack([np.tile(np.eye(3).ravel(), (each, 1)), -x[:each, :3]])
        free = tuple(u for u in SHIFT if "xyz"[u - SHIFT[0]] in mechanism.axes)
        found = self.taken(np.arange(len(x))[:, None], np.tile(np.arange(each), sets))
        return found, Instrument(self, state, free)


KIND = Contact("contact")
