"""What a calibrated machine is used for: commands for it, files for its controller, predictions."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

from deltacal_gen.app.commands.common import (
    Progress,
    Source,
    as_recording,
    check_output,
    moving_like,
    refuse_in_motion,
    silent,
)
from deltacal_gen.errors import OptionMissing, OptionNotApplicable

if TYPE_CHECKING:
    from deltacal_gen.app.commands.common import AnyRecording
    from deltacal_gen.machine.registry import Array
    from deltacal_gen.machine.values import Recording
    from deltacal_gen.motion.feedforward import FeedForward
    from deltacal_gen.motion.trajectories import Trajectories
    from deltacal_gen.results.motion import MotionModel
    from deltacal_gen.results.reader import Given
    from deltacal_gen.results.written import FirmwareLines


def compensate(
    result: Given,
    targets: AnyRecording | Array,
    *,
    method: Literal["exact", "linear"] = "exact",
    channels: Mapping[str, Array | float] | None = None,
    bands: bool = False,
    output: Source | None = None,
    tell: Progress = silent,
) -> Array:
    """Compute corrected joint commands for targets, or export the compensator for a controller.

    Parameters
    ----------
    result : path or Result or Diagnosis
        RESULT.json of identify, or DIAGNOSIS.json of diagnose, whose effects are then compensated too.
    targets : path, data frame or (N, 3) array
        Targets x_mm, y_mm, z_mm in {O}, with tool points and the channels that effects depend on (CSV). For an open
        chain also rx_deg, ry_deg, rz_deg, or the joints of a program, whose nominal poses are then reached. From
        Python also an array (N, 3), for a chain (N, 6).
    method : {"exact", "linear"}
        Solve the inverse kinematics of the calibrated machine, or correct the nominal one to first order.
    channels : mapping of (N,) arrays or numbers, optional
        For an array of targets, the channels that effects depend on, by their column names: temp_C, payload_kg, time_s,
        approach1 ...
    bands : bool
        Also write the 95 % coverage interval of the position that each command reaches: x_lo_mm, x_hi_mm ... in {O}.
    output : path, optional
        JOINTS.csv: the commands [deg or mm]; with --export the exported file.
    tell : callable
        Called with what is assumed where a channel is not given.

    Raises
    ------
    UsageError
        An array of targets that are no finite numbers, or of another shape; a channel that nothing could be.
    InputError
        A file, or a data frame, that cannot be read as targets.
    NoSolutionError
        Targets out of reach.

    Examples
    --------
    deltacal compensate diagnosis.json targets.csv -o joints.csv
    """
    import numpy as np

    from deltacal_gen.files.frames import is_frame
    from deltacal_gen.files.writing import csv_text, write_files
    from deltacal_gen.machine.values import Recording
    from deltacal_gen.use import commanded, compensation
    from deltacal_gen.use.known import known_result

    check_output(output, result, targets)
    known = known_result(result)
    compensator = compensation.Compensator(known, method)
    given: Any = targets
    if isinstance(targets, str | Path | Recording) or is_frame(targets):
        recording = as_recording(given, compensator.robot, need_measured=False, allow_targets=True)
        wanted = commanded.Wanted.of_file(recording, compensator, channels or {}, tell)
    else:
        wanted = commanded.Wanted.of_array(given, compensator, channels or {})
    if not len(wanted.positions):
        return np.zeros((0, compensator.mechanism.limbs))
    commanded.check_channels(channels or {}, compensator, known, len(wanted.positions))
    found = commanded.commanded(known, compensator, wanted, tell)
    if bands and output is None:
        raise OptionMissing("bands stand beside the commands in a file: give -o JOINTS.csv.")
    if output is not None:
        table = found.table()
        if bands:
            columns, words = found.bands()
            table |= columns
            tell(words)
        write_files({Path(output): csv_text(table)})
    return found.in_files


def export_compensator(
    result: Given,
    *,
    export: str,
    output: Source,
    method: Literal["exact", "linear"] = "exact",
    tolerance_mm: float = 0.01,
    tell: Progress = silent,
) -> FirmwareLines | None:
    """Write a calibrated machine for its controller; return the lines of a printer's firmware.

    Parameters
    ----------
    result : path or Result or Diagnosis
        RESULT.json of identify, or DIAGNOSIS.json of diagnose.
    export : str
        Export instead of commanding targets: c (C99 source) or table (corrections on a grid); klipper, rrf or marlin
        (configuration lines of printer firmware).
    output : path
        File of the export.
    method : {"exact", "linear"}
        Solve the inverse kinematics of the calibrated machine, or correct the nominal one to first order.
    tolerance_mm : float
        Export table: largest error of interpolation [mm].
    tell : callable
        Called with what the export does not hold.

    Raises
    ------
    UsageError
        There is no such export, or none for this machine.

    Examples
    --------
    deltacal compensate result.json --export klipper -o printer.cfg
    """
    from deltacal_gen.results.motion import MotionModel
    from deltacal_gen.use import exporters
    from deltacal_gen.use.known import known_model

    check_output(output, result)
    known, exporter = known_model(result), exporters.exporter_of(export)
    if isinstance(known, MotionModel):
        exporter.in_motion(known, Path(output))
        return None
    lines = exporter.at_rest(known, Path(output), kind=method, worst_mm=tolerance_mm)
    if known.correction is not None:
        tell("the smooth correction is not part of an export; compensate targets instead")
    return lines


def feed_forward(
    result: Given, targets: Source, *, output: Source | None = None, tell: Progress = silent
) -> FeedForward:
    """Command a trajectory: joints, their derivatives, and the torques of the drives.

    Parameters
    ----------
    result : path or MotionResult or MotionDiagnosis
        RESULT.json or DIAGNOSIS.json of a recording in motion: with the friction that was found.
    targets : path
        Samples in time (CSV): time_s and joints, or x_mm, y_mm, z_mm in {O}, with rx_deg, ry_deg, rz_deg where these
        are commanded too; run and payload_kg where they vary.
    output : path, optional
        COMMANDS.csv: joints, velocities, accelerations, torques in the unit of the result's readings.
    tell : callable
        Called with which rows are left out, where velocities are not those of the joints, where friction is ramped and
        where limits are passed.

    Raises
    ------
    UsageError
        The result is of a machine at rest.

    Examples
    --------
    deltacal compensate diagnosis.json trajectory.csv --trajectory -o commands.csv
    """
    import numpy as np

    from deltacal_gen.files.writing import csv_text, write_files
    from deltacal_gen.results.motion import MotionModel
    from deltacal_gen.use import trajectory as along
    from deltacal_gen.use.known import known_model

    check_output(output, result, targets)
    known = known_model(result)
    if not isinstance(known, MotionModel):
        raise OptionNotApplicable("torques along a trajectory need a result of a recording in motion (kind torque).")
    found = along.feed_forward(known, targets)
    for words in filter(None, (*found.given.repairs, along.blanks(found), along.bent(found))):
        tell(words)
    if slow := [f"joint {j + 1}: {count}" for j, count in enumerate(found.ramped.tolist()) if count]:
        tell(f"samples near rest, at which friction is ramped: {', '.join(slow)}")
    if still := [str(j + 1) for j in range(found.torque.shape[1]) if np.isnan(found.torque[:, j]).all()]:
        tell(f"joint {', '.join(still)} did not move in the recording: its torque is not known and left blank")
    for name, count in found.beyond.items():
        tell(f"{count} of {len(found.torque)} samples lie beyond [limits] {name}")
    if output is not None:
        write_files({Path(output): csv_text(found.columns_of_file())})
    return found


def predict(
    result: Given,
    recording: AnyRecording,
    *,
    place: AnyRecording | None = None,
    bands: bool = False,
    output: Source | None = None,
    tell: Progress = silent,
) -> Recording:
    """Predict the readings at other joint positions, in the instrument's frame.

    Parameters
    ----------
    result : path or Result or Diagnosis
        RESULT.json of identify, or DIAGNOSIS.json of diagnose.
    recording : path, data frame or Recording
        Joints and the channels that effects depend on (CSV); measured columns are ignored.
    place : path, data frame or Recording, optional
        Readings of the same instrument set-ups at other poses (CSV), to locate the instrument again.
    bands : bool
        Also write the 95 % interval of each value: x_lo_mm, x_hi_mm ...; it includes measurement noise only in motion.
    output : path, optional
        PREDICTED.csv: the recording with predicted readings.
    tell : callable
        Called with which joints stand at angles that the diagnosis never saw.

    Returns
    -------
    Recording
        Of a result in motion a `motion.trajectories.Trajectories`, with half the width of its intervals in `half`;
        these hold readings, noise included.

    Raises
    ------
    InputError
        A file, or data frame, that cannot be used; a set-up that the result does not know, without `place`.

    Examples
    --------
    deltacal predict diagnosis.json poses.csv -o predicted.csv
    """
    from deltacal_gen.app.commands.clocks import as_known, clocks_of, instrument_columns
    from deltacal_gen.diagnosis import spectrum
    from deltacal_gen.files.writing import csv_text, file_columns, write_files
    from deltacal_gen.instrument.kinds import kind_of
    from deltacal_gen.physics.ranges import in_words
    from deltacal_gen.results.motion import MotionModel
    from deltacal_gen.use import prediction
    from deltacal_gen.use.known import known_model

    check_output(output, result, recording, place)
    known = known_model(result)
    if isinstance(known, MotionModel):
        refuse_in_motion(place=place)
        return cast("Recording", _predicted_in_motion(known, recording, bands, output, tell))
    robot = prediction.calibrated_robot(known)
    timed = clocks_of(recording, robot, need_measured=False)
    given = as_known(known, recording, robot, need_measured=False)
    placed = None if place is None else prediction.place_of(as_recording(place, robot), given)
    for joint in spectrum.never_seen(known.seen, robot.joint_sign * given.joints):
        tell(joint.words)
    for joint in prediction.beyond_waves(known, given):
        tell(joint.beyond_words)
    done = prediction.predict(known, given, placed)
    if kind_of(given.kind).in_differences(given.measurement):
        tell('Values are changes from the first row, as the sidecar says (zero = "incremental").')
    beyond = in_words(prediction.beyond_laws(known, given), "rows")
    for words in filter(None, (prediction.told_of_events(known, given), beyond)):
        tell(words)
    ends: dict[str, Array] = {}
    if bands:
        from deltacal_gen.use.bands import known_of, predicted_bands

        ends = predicted_bands(known, given, done, placed)
        tell(known_of(known).text)
    if output is not None:
        columns, pairs = file_columns(done)
        if timed is not None:
            columns = instrument_columns(timed, done, joints=True)
        write_files({Path(output): csv_text((pairs or columns) | ends)})
    return done if done.pairs is not None else dataclasses.replace(done, channels=done.channels | ends)


def _predicted_in_motion(
    known: MotionModel, recording: AnyRecording, bands: bool, output: Source | None, tell: Progress
) -> Trajectories:
    """Return the readings of drives, written where that is wanted."""
    from deltacal_gen.files.writing import csv_text, write_files
    from deltacal_gen.motion.kinds import columns_of
    from deltacal_gen.physics.ranges import in_words
    from deltacal_gen.results.motion import not_shown, put_right

    found = moving_like(recording).predict(known, bands=bands)
    beyond = in_words(found.outside, "samples"), not_shown(found.unshown.sum(axis=0).tolist())
    for words in filter(None, (*put_right(found.repairs), *beyond)):
        tell(words)
    if output is not None:
        write_files({Path(output): csv_text(columns_of(found))})
    return found
