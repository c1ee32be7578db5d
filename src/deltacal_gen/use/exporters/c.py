"""A compensator, or a machine in motion, as one self-contained C99 file."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from deltacal_gen.errors import NotForThisMachine
from deltacal_gen.files.writing import write_files
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.motion import MotionModel
from deltacal_gen.results.result import Result
from deltacal_gen.use.command_source import LiveEffects, command_source, effect_source
from deltacal_gen.use.compensation import Compensator, RoundTrip
from deltacal_gen.use.exporters import Exporter
from deltacal_gen.use.servo_source import servo_source
from deltacal_gen.use.spans import Spans, after_jumps, spans


class C99(Exporter):
    """One C99 file."""

    def at_rest(self, known: Result | Diagnosis, path: Path, *, kind: str, worst_mm: float) -> None:
        """Write the compensator with the effects, over the channels as they were recorded."""
        export_c(Compensator(known, kind), path, spans(known))

    def in_motion(self, known: MotionModel, path: Path) -> None:
        """Write joints and torques by position, velocity and acceleration; see the head of the file."""
        write_files({path: servo_source(known)})


EXPORTER = C99()


def export_c(compensator: Compensator, path: str | Path, over: Spans | None = None) -> RoundTrip:
    """Write the compensator as one self-contained C99 file.

    It defines ``int deltacal_compensate(const double target_mm[3], double joints_deg[3])``, which returns 0 (solved),
    1 (out of reach) or 2 (singular), keeps no state and allocates nothing. The tool point is the robot's. Where the
    machine has effects there is also ``deltacal_command``, which takes temperature, payload, time and directions of
    approach beside the target, and returns 3 where one that an effect reads is no finite number.

    Parameters
    ----------
    compensator : Compensator
    path : path
        Replaced only when the new file is complete.
    over : Spans, optional
        Ranges of the channels, for a machine with effects.

    Returns
    -------
    RoundTrip
        What the file's header states.

    Raises
    ------
    UsageError
        An effect remembers, or acts along a position at which the platform also turns on command.
    InputError
        The robot has no workspace, or the file cannot be written.
    """
    compensator.needs_no_past("C")
    compensator.needs_loops("export 'c'")
    placed = [t.effect for t in compensator.effects if not effect_source(t).is_file()]
    if placed and compensator.mechanism.turning:
        raise NotForThisMachine(
            f"{', '.join(dict.fromkeys(placed))}: exported as a function of the position alone, and this platform "
            "turns on command. Write the joints of your targets: deltacal compensate RESULT TARGETS -o JOINTS."
        )
    rigid = replace(compensator, terms=())
    with using(Backend.NUMPY):  # a file holds the same digits wherever it is written from
        left = rigid.round_trip()
        live = LiveEffects.of(after_jumps(compensator), over or Spans()) if compensator.effects else None
        write_files({Path(path): command_source(rigid, left, live)})
        return left if live is None else live.left
