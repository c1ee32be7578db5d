"""Recordings of which joints and readings have clocks of their own, as commands take and write them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from deltacal_gen.app.commands.common import Progress, Source, as_recording
from deltacal_gen.files.columns import Columns, instrument_path, sidecar_path
from deltacal_gen.files.writing import csv_text, file_columns, sidecar_text, write_files
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Recording, Robot
from deltacal_gen.motion.clocks import TwoClocks, two_clocks
from deltacal_gen.results.parts import SeriesMade
from deltacal_gen.states import TIME

if TYPE_CHECKING:
    from deltacal_gen.motion.alignment import Alignment
    from deltacal_gen.physics.terms import Term
    from deltacal_gen.results.diagnosis import Diagnosis
    from deltacal_gen.results.result import Parameter, Result

Answered = TypeVar("Answered", "Result", "Diagnosis")


def clocks_of(recording: object, robot: Robot, **how: bool) -> TwoClocks | None:
    """Return a recording with two clocks; None of any other."""
    if not isinstance(recording, str | Path) or not sidecar_path(Path(recording)).exists():
        return None
    return two_clocks(Path(recording), mechanism_of(robot), **how)


def set_in_time(
    robot: Robot,
    recording: Any,
    model: str | None,
    *,
    held: Sequence[Term] = (),
    start: Alignment | None = None,
    progress: Progress,
    **how: bool,
) -> tuple[Recording, Alignment | None]:
    """Return a recording; one with two clocks as these stand by its own readings, and how they stand.

    `held` are effects that act on the machine, `start` says where the clocks stand about.
    """
    given = clocks_of(recording, robot, **how)
    if given is None:
        return as_recording(recording, robot, **how), None
    from deltacal_gen.identification.clocks import aligned

    at = None if start is None else start.clock
    found = aligned(robot, given, model, held=held, start=at, progress=progress)
    return given.at(found.clock), found


def with_clock(found: Answered, clock: Alignment | None) -> Answered:
    """Return an answer that tells how the clocks stand, where there are two."""
    if clock is None:
        return found
    own: tuple[Parameter, ...] = clock.parameters
    told: tuple[Parameter, ...] = found.parameters or ()
    assert isinstance(clock.clocks, TwoClocks)
    return found.replace(parameters=(*told, *own), motion=series_made(clock.clocks))


def as_known(known: Result | Diagnosis, recording: Any, robot: Robot, *, need_measured: bool = True) -> Recording:
    """Return a recording that a result is used on, its clocks as the result knows them."""
    given = clocks_of(recording, robot, need_measured=need_measured)
    if given is None:
        like = None if need_measured else known.instrument
        return as_recording(recording, robot, need_measured=need_measured, like=like)
    return given.at(given.known_clock(known.parameters or ()), need_joints=not need_measured)


def series_made(given: TwoClocks) -> SeriesMade:
    """Return how joints were made to be known at any time."""
    return SeriesMade(
        cutoff_Hz=0.5 / given.spacing, removed=given.removed, text=given.text, repairs=given.joints.repairs
    )


def instrument_columns(given: TwoClocks, done: Recording, *, joints: bool) -> Columns:
    """Return readings as a file holds them: with their run and time, and beside the joints as they were then."""
    columns, _ = file_columns(done)
    runs = {} if given.run_names == ("1",) else {"run": [given.run_names[code] for code in given.run]}
    own = [*done.columns, *given.recording.channels, "setup", "contact"]
    there = [n for n in columns if n.startswith("q") and n not in done.channels] if joints else []
    return {**runs, TIME: given.time, **{name: columns[name] for name in (*there, *own) if name in columns}}


def write_two_clocks(given: TwoClocks, done: Recording, output: Source) -> None:
    """Write a simulated recording with two clocks: joints as they were given, readings, and the sidecar."""
    path = Path(output)
    write_files(
        {
            path.with_suffix(".toml"): sidecar_text(done),
            path: Path(given.joints.path).read_bytes(),
            instrument_path(path): csv_text(instrument_columns(given, done, joints=False)),
        }
    )
