"""Kinds of recordings in motion, by name: what commands ask for, instead of comparing names."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from deltacal_gen.errors import BadValue, InputError
from deltacal_gen.files.columns import DRIVE, JOINT, Columns, instrument_path
from deltacal_gen.files.dialect import LOOKED_AT
from deltacal_gen.files.robot import robot_of
from deltacal_gen.files.rows import read_csv
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.values import Robot
from deltacal_gen.motion import trajectories
from deltacal_gen.motion.trajectories import Sidecar, Trajectories
from deltacal_gen.results.motion import (
    InertialParameter,
    MotionDiagnosis,
    MotionModel,
    MotionResult,
    MotionValidation,
    Trace,
)
from deltacal_gen.results.reader import TORQUE
from deltacal_gen.states import TIME
from deltacal_gen.units import joint_factors, joint_names

if TYPE_CHECKING:
    from deltacal_gen.motion.alignment import Alignment
    from deltacal_gen.motion.clocks import DriveClocks
    from deltacal_gen.motion.matrix import Regressor


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
        """Return the recording, of one clock; raises InputError."""
        found = trajectories.read(self._path, mechanism_of(robot), self._sidecar, need_measured=need_measured)
        return dataclasses.replace(found, constants=_constants(robot))

    def _clocks(self, robot: Robot, *, need_measured: bool = True, cutoff: float | None = None) -> DriveClocks | None:
        """Return the recording if it has two clocks, low-pass of its joints as it is known [Hz]; raises InputError."""
        from deltacal_gen.motion.clocks import drive_clocks

        if self._sidecar.measurement.clock is None:
            return None
        machine, said = mechanism_of(robot), self._sidecar
        found = drive_clocks(self._path, machine, said, need_measured=need_measured, cutoff=cutoff)
        readings = dataclasses.replace(found.readings, constants=_constants(robot))
        return dataclasses.replace(found, readings=readings)

    def _as_known(self, known: MotionModel, *, need_measured: bool) -> Trajectories:
        """Return the recording, two clocks as a result knows them."""
        robot = robot_of(known.robot)
        both = self._clocks(robot, need_measured=need_measured, cutoff=known.motion.cutoff_Hz)
        if both is None:
            return self.read(robot, need_measured=need_measured)
        return both.at(both.known_clock(known.parameters), need_joints=not need_measured)

    def identify(self, robot: Robot, model: str | None) -> MotionResult:
        """Identify the rigid machine."""
        from deltacal_gen.motion.identification import identify
        from deltacal_gen.motion.timing import aligned

        if (both := self._clocks(robot)) is None:
            return identify(robot, self.read(robot), model)
        clock = aligned(robot, both)
        return _with_clock(identify(robot, both.at(clock.clock), model), clock)

    def matrix(self, robot: Robot) -> Regressor:
        """Return the linear problem of the rigid machine itself."""
        from deltacal_gen.motion.matrix import regressor
        from deltacal_gen.motion.timing import aligned

        both = self._clocks(robot)
        return regressor(robot, self.read(robot) if both is None else both.at(aligned(robot, both).clock))

    def diagnose(self, robot: Robot, progress: Callable[[str], None]) -> MotionDiagnosis:
        """Find what each drive has beside the rigid machine.

        Once more where what was found moves two clocks by more than was known of them.
        """
        from deltacal_gen.motion.diagnosis import diagnose
        from deltacal_gen.motion.timing import aligned, beside_of

        if (both := self._clocks(robot)) is None:
            return diagnose(robot, self.read(robot), progress)
        first = aligned(robot, both, progress=progress)
        found = diagnose(robot, both.at(first.clock), progress)
        clock = aligned(robot, both, beside_of(found), start=first.clock, progress=progress)
        if clock.moved_since(first) > 1.0:
            found = diagnose(robot, both.at(clock.clock), progress)
        return _with_clock(found, clock)

    def simulate(self, robot: Robot, truth: str | Path | None, noise: float, seed: int) -> Trajectories:
        """Return the recording with what the drives of the robot file's bodies, and of a truth, give."""
        from deltacal_gen.motion.rigid import Rigid
        from deltacal_gen.motion.simulation import Truth, read_truth, simulated
        from deltacal_gen.physics.simulation import truth_clock

        both = self._clocks(robot, need_measured=False)
        if both is None:
            given = self.read(robot, need_measured=False)
        else:
            given = both.at(both.simulated({} if truth is None else truth_clock(truth)))
        told = Truth() if truth is None else read_truth(truth, Rigid(robot))
        return simulated(robot, given, told, noise, np.random.default_rng(seed))

    def predict(self, known: MotionModel, *, bands: bool = False) -> Trajectories:
        """Return the recording with the readings that a model predicts, and their bands where these are asked for."""
        from deltacal_gen.motion.prediction import predicted

        return predicted(known, self._as_known(known, need_measured=False), bands=bands)

    def validate(self, known: MotionResult | MotionDiagnosis) -> MotionValidation:
        """Return how far off a model is on the recording."""
        from deltacal_gen.motion.prediction import validated

        return validated(known, self._as_known(known, need_measured=True))

    def drawn(self, known: MotionResult | MotionDiagnosis) -> tuple[Trace, ...]:
        """Return what a page of such a validation draws, joint by joint."""
        from deltacal_gen.motion.traces import unseen

        return unseen(known, self._as_known(known, need_measured=True))


InMotion = TypeVar("InMotion", MotionResult, MotionDiagnosis)


def _constants(robot: Robot) -> tuple[float, ...] | None:
    """Return what each joint gets of an ampere, as far as the robot file says it; raises InputError."""
    constants = None if robot.transmission is None else robot.transmission.torque_constant_Nm_A
    limbs = mechanism_of(robot).limbs
    if constants is not None and len(constants) != limbs:
        raise BadValue(
            f"torque_constant_Nm_A has {len(constants)} numbers, and the machine {limbs} joints.",
            "Give one for each joint.",
            file=robot.source,
        )
    return constants


def _with_clock(found: InMotion, clock: Alignment) -> InMotion:
    """Return an answer that tells how two clocks stand."""
    own: tuple[InertialParameter, ...] = tuple(InertialParameter(**vars(p)) for p in clock.parameters)
    return found.replace(parameters=(*found.parameters, *own))


KINDS: Mapping[str, type[Torque]] = {TORQUE: Torque}


def plans_motion(kind: str | None, model: str | None) -> bool:
    """Tell whether what is to be planned is a trajectory: by the kind of its readings, or for the rigid machine."""
    from deltacal_gen.motion.identification import RIGID

    return kind in KINDS or (model is not None and model.endswith(f"/{RIGID}"))


def in_motion(recording: object) -> Torque | None:
    """Return a recording as one in motion; None where its sidecar does not say so."""
    if not isinstance(recording, str | Path):
        return None
    path = Path(recording)
    sidecar = trajectories.read_sidecar(path)
    return None if sidecar is None else KINDS[sidecar.measurement.kind](path, sidecar)


def is_recording(path: Path) -> bool:
    """Tell whether a table is in motion as its sidecar says, and holds joints and what drives give; values unjudged."""
    try:
        if (said := trajectories.read_sidecar(path)) is None:
            return False
        names = read_csv(path, LOOKED_AT).columns
        beside = names if said.measurement.clock is None else read_csv(instrument_path(path), LOOKED_AT).columns
    except InputError:
        return False
    return any(JOINT.fullmatch(n) for n in names) and any(DRIVE.fullmatch(n) for n in beside)


def columns_of(done: Trajectories, *, joints: bool = True) -> Columns:
    """Return a recording in motion as columns of a file, with its joints or, of two clocks, without."""
    from deltacal_gen.motion.bands import ends

    limbs = done.joints.shape[1]
    factors = joint_factors(done.joint_unit, limbs)
    stand = zip(joint_names(done.joint_unit, limbs), (done.joints / factors).T, strict=True) if joints else ()
    runs = {} if done.run_names == ("1",) else {"run": [done.run_names[code] for code in done.run]}
    readings = dict(zip(done.columns, done.readings.T, strict=True))
    setups = {"setup": list(done.setups)} if done.setups else {}
    return {**runs, TIME: done.time, **dict(stand), **done.channels, **setups, **readings, **ends(done)}
