"""The kinds of measurement: registered by presence, of a generated module or of a file here that defines ``KIND``."""

from __future__ import annotations

import functools
import importlib
import importlib.util
import pkgutil
from typing import TYPE_CHECKING

import deltacal_kernels.measurements
import numpy as np

from deltacal_gen.errors import BadValue
from deltacal_gen.instrument.kind import Instrument, Kind, Readings
from deltacal_gen.instrument.several import Several
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.values import Recording, Robot, poses_of

if TYPE_CHECKING:
    from deltacal_gen.results.parts import InstrumentState

POINTS = "position"  # where points are: what rows hold where nothing says what they do
PAIRS = "distance"  # what lies between two rows: what pairs hold, and all of positions whose frame does not matter
MOUNTED = "gauge"  # what is read by an instrument that a machine may carry
AND = " and "  # between the names of kinds that are read together


@functools.cache
def names() -> tuple[str, ...]:
    """Return the names of all kinds of measurement."""
    derived, own = (
        {module.name for module in pkgutil.iter_modules(path) if not module.ispkg}
        for path in (deltacal_kernels.measurements.__path__, __path__)
    )
    return tuple(sorted(derived | own))


@functools.cache
def kind_of(name: str) -> Kind:
    """Return the kind of measurement of a name, or what several kinds read together: ``height and distance``.

    Raises
    ------
    InputError
        There is no such kind.
    """
    if AND in name:
        return Several(name, tuple(kind_of(part) for part in name.split(AND)))
    if name not in names():
        raise BadValue(f"there is no kind of measurement '{name}'.", f"Known: {', '.join(names())}.")
    if importlib.util.find_spec(f"{__name__}.{name}") is None:
        return Kind(name)
    kind: Kind = importlib.import_module(f"{__name__}.{name}").KIND
    return kind


def together(*kinds: Kind) -> Kind:
    """Return what several kinds read together."""
    return kind_of(AND.join(kind.name for kind in kinds))


def usual(mechanism: Machine) -> str:
    """Return what is planned for where nobody says what will be measured: distances show no turn on command."""
    return POINTS if mechanism.turning else PAIRS


def mounts() -> frozenset[str]:
    """Return the source errors by which some machine carries a measuring mechanism of some kind."""
    return frozenset(name for kind in names() for name in kind_of(kind).mount)


def instrument_of(kept: InstrumentState) -> Instrument:
    """Return the instrument that an answer kept."""
    return Instrument(kind_of(kept.kind), kept.state, kept.free, kept.scale, kept.home, kept.ties)


def readings(recording: Recording, *, as_distance: bool = False) -> Readings:
    """Return the readings of a recording; blank ones are left out.

    Parameters
    ----------
    as_distance : bool
        Turn positions into the distances of all pairs that share tool point and set-up (Bai 2015, section 3.1).

    Raises
    ------
    InputError
        The recording holds no reading of a kind that can be used here.
    """
    kind = kind_of(recording.kind)
    if not kind.distances_beside and recording.pairs is not None and len(recording.pairs):
        kind = kind_of(PAIRS)
    found = kind.readings(recording, poses_of(recording)).some(recording)
    return found.kind.as_distances(found, recording).some(recording) if as_distance else found


def measured_points(robot: Robot, recording: Recording) -> Array:
    """Return the measured point (N, 3) of the platform in each row: its own, or what the sidecar or the robot says."""
    point = None if recording.tool is not None else kind_of(recording.kind).measured_point(recording.measurement)
    tool = np.broadcast_to(robot.tool if point is None else np.asarray(point, dtype=float), (recording.n_rows, 3))
    if recording.tool is not None:
        tool = np.where(np.isfinite(recording.tool), recording.tool, tool)
    return np.array(tool)
