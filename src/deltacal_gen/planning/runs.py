"""The runs to record next: where a diagnosis in motion says that another one would tell, movements that do."""

from __future__ import annotations

import shlex
from dataclasses import dataclass
from pathlib import Path

from deltacal_gen.files.robot import robot_of
from deltacal_gen.planning import exciting
from deltacal_gen.results.diagnosis import NextMeasurement
from deltacal_gen.results.motion import MotionDiagnosis
from deltacal_gen.results.written import Runs

PLANNED, PERIOD, RATE = 3, 10.0, 100.0  # runs, of so many seconds, at so many samples per second
SLOWER = (3.0, 9.0)  # times: the first run once more, where speeds tell
NAME = "next{}"  # of a run: none of the recording, to which it is appended


@dataclass(frozen=True, eq=False)
class Asked:
    """Runs to record, and what they are for."""

    answer: Runs
    series: tuple[exciting.Series, ...]


def open_runs(found: MotionDiagnosis) -> list[NextMeasurement]:
    """Return what a diagnosis leaves open that another run would tell."""
    return [entry for entry in found.next_measurements if entry.run is not None]


def asked(found: MotionDiagnosis, output: Path | None) -> Asked | None:
    """Return the runs that tell what a diagnosis leaves open; None where no run would.

    Exciting trajectories. Where speeds are to be told apart the first one is repeated more slowly, and where loads are
    runs carry the least and the most that [limits] allows, in turn.

    Raises
    ------
    NoSolutionError
        No trajectory stays in the workspace.
    """
    entries = open_runs(found)
    if not entries:
        return None
    robot = robot_of(found.robot)
    plan, planned = exciting.plan_trajectories(robot, runs=PLANNED, period=PERIOD, rate=RATE)
    varied = {state for entry in entries for state in entry.run or ()}
    series = (*planned, *(planned[0].slower(factor) for factor in SLOWER if "qd" in varied))
    payload = None
    if "torque" in varied and "payload_kg" in robot.limits:
        least, most = sorted(robot.limits["payload_kg"])
        payload = tuple(most if k % 2 else least for k in range(len(series)))
    answer = Runs(
        why=tuple(entry.why for entry in entries),
        runs=tuple(NAME.format(k + 1) for k in range(len(series))),
        period_s=tuple(s.period for s in series),
        payload_kg=payload,
        rate_Hz=RATE,
        condition=plan.condition[-1],
        notes=plan.notes,
        command=command(found, output),
    )
    return Asked(answer, series)


def write(found: MotionDiagnosis, runs: Asked, output: str | Path) -> None:
    """Write runs as a trajectory that a controller follows and `simulate` takes, with its sidecar."""
    loads = runs.answer.payload_kg
    channels = {} if loads is None else {"payload_kg": loads}
    exciting.write_trajectory(
        robot_of(found.robot), runs.series, runs.answer.rate_Hz, output, names=runs.answer.runs, channels=channels
    )


def command(found: MotionDiagnosis, output: Path | None) -> str:
    """Return the command that plans movements like these, to be changed."""
    inputs = found.made.inputs if found.made else ()
    robot = inputs[0].name if inputs else "robot.toml"
    file = "trajectory.csv" if output is None else str(output)
    numbers = f"--runs {PLANNED} --period {PERIOD:g} --rate {RATE:g}"
    return f"deltacal plan {shlex.quote(robot)} --kind torque {numbers} -o {shlex.quote(file)}"
