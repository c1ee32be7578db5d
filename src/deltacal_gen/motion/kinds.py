"""Kinds of recordings in motion, by name: what commands ask for, instead of comparing names."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.files.robot import robot_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion import trajectories
from deltacal_gen.motion.trajectories import Sidecar, Trajectories
from deltacal_gen.results.base import Answer
from deltacal_gen.results.motion import MotionDiagnosis, MotionModel, MotionResult, MotionValidation
from deltacal_gen.results.reader import Given, read_answer
from deltacal_gen.units import joint_factors, joint_names

SCHEMAS = ("deltacal.motion/1", "deltacal.motion-diagnosis/1")


class Torque:
    """What drives give: torques, forces, currents.

    Parameters
    ----------
    path : Path
        The recording.
    sidecar : Sidecar
    """

    def __init__(self, path: Path, sidecar: Sidecar) -> None:
        self._path, self._sidecar = path, sidecar

    def read(self, robot: Robot, *, need_measured: bool = True) -> Trajectories:
        """Return the recording; raises InputError."""
        return trajectories.read(self._path, mechanism_of(robot), self._sidecar, need_measured=need_measured)

    def identify(self, robot: Robot, model: str | None) -> MotionResult:
        """Identify the rigid machine."""
        from deltacal_gen.motion.identification import identify

        return identify(robot, self.read(robot), model)

    def diagnose(self, robot: Robot, progress: Callable[[str], None]) -> MotionDiagnosis:
        """Find what each drive has beside the rigid machine."""
        from deltacal_gen.motion.diagnosis import diagnose

        return diagnose(robot, self.read(robot), progress)

    def simulate(self, robot: Robot, truth: str | Path | None, noise: float, seed: int) -> Trajectories:
        """Return the recording with what the drives of the robot file's bodies, and of a truth, give."""
        from deltacal_gen.motion.simulation import simulated

        given = self.read(robot, need_measured=False)
        return simulated(robot, given, truth, noise, np.random.default_rng(seed))

    def predict(self, known: MotionModel) -> Trajectories:
        """Return the recording with the readings that a model predicts."""
        from deltacal_gen.motion.prediction import predicted

        return predicted(known, self.read(robot_of(known.robot), need_measured=False))

    def validate(self, known: MotionModel) -> MotionValidation:
        """Return how far off a model is on the recording."""
        from deltacal_gen.motion.prediction import validated

        return validated(known, self.read(robot_of(known.robot)))


KINDS: Mapping[str, type[Torque]] = {"torque": Torque}


def in_motion(recording: object) -> Torque | None:
    """Return a recording as one in motion; None where its sidecar does not say so."""
    if not isinstance(recording, str | Path):
        return None
    path = Path(recording)
    sidecar = trajectories.read_sidecar(path)
    return None if sidecar is None else KINDS[sidecar.measurement.kind](path, sidecar)


def known_motion(result: Given) -> MotionModel | None:
    """Return a result of a recording in motion, from its file, its JSON or as it is; None where it is another."""
    if isinstance(result, MotionModel):
        return result
    if isinstance(result, Answer):
        return None
    schema = result.get("schema") if isinstance(result, Mapping) else _schema_of(Path(str(result)))
    if schema not in SCHEMAS:
        return None
    found = read_answer(result, SCHEMAS)
    assert isinstance(found, MotionModel)
    return found


def _schema_of(path: Path) -> str | None:
    """Return what a file says to be; None where it cannot be read, which its reader then says."""
    import json

    try:
        data: Any = json.loads(path.read_text(encoding="utf-8-sig"))
    except (OSError, ValueError, RecursionError):
        return None
    return data.get("schema") if isinstance(data, dict) else None


def columns_of(done: Trajectories) -> dict[str, Any]:
    """Return a recording in motion as columns of a file."""
    limbs = done.joints.shape[1]
    factors = joint_factors(done.joint_unit, limbs)
    joints = zip(joint_names(done.joint_unit, limbs), (done.joints / factors).T, strict=True)
    runs = {} if done.run_names == ("1",) else {"run": [done.run_names[code] for code in done.run]}
    readings = dict(zip(done.columns, done.readings.T, strict=True))
    return {**runs, "time_s": done.time, **dict(joints), **done.channels, **readings}
