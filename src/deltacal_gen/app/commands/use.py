"""What a calibrated machine is good for: commands, predictions, a check, a comparison of two sessions."""

from __future__ import annotations

import dataclasses
import hashlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal, cast

import numpy as np

from deltacal_gen.app.commands.clocks import as_known, clocks_of, instrument_columns
from deltacal_gen.app.commands.common import (
    AnyRecording,
    Progress,
    Source,
    as_recording,
    check_output,
    in_motion,
    made,
    refuse_in_motion,
    silent,
    write_json,
)
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.about import About, read_about
from deltacal_gen.files.frames import is_frame
from deltacal_gen.files.writing import csv_text, file_columns, write_files
from deltacal_gen.machine.values import Recording
from deltacal_gen.motion.kinds import columns_of
from deltacal_gen.physics.ranges import in_words
from deltacal_gen.results.certificate import Certificate, Party
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.motion import (
    MotionDiagnosis,
    MotionModel,
    MotionResult,
    MotionValidation,
    not_shown,
    put_right,
)
from deltacal_gen.results.parts import InputFile, Made
from deltacal_gen.results.reader import Given
from deltacal_gen.results.result import Result
from deltacal_gen.use.known import known_model, known_result

NO_READINGS = (".toml", ".json")  # what files end with that a fit reads beside tables: robots, sidecars, answers
NUMBER = 16  # letters of a hash that stand for the number of a certificate where none is given

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array
    from deltacal_gen.motion.feedforward import FeedForward
    from deltacal_gen.motion.kinds import Torque
    from deltacal_gen.results.comparison import Comparison
    from deltacal_gen.results.validation import Validation
    from deltacal_gen.results.written import FirmwareLines


def compensate(
    result: Given,
    targets: AnyRecording | Array | None = None,
    output: Source | None = None,
    *,
    kind: str = "exact",
    export: str | None = None,
    worst_mm: float = 0.01,
    channels: Mapping[str, Array | float] | None = None,
    bands: bool = False,
    tell: Progress = silent,
) -> Array:
    """Return corrected joint commands (N, n_q) [deg or mm] for targets (N, 3) [mm], or export the compensator.

    Parameters
    ----------
    result : path or mapping
        RESULT.json, or DIAGNOSIS.json: then the commands include the effects that were found.
    targets : path, data frame or (N, 3) array
        A CSV with ``x_mm, y_mm, z_mm`` in {O} (tool columns and channels too), or positions. Not needed with `export`.
        Of a data frame the names of columns count, not their order.
        Of an open chain ``rx_deg, ry_deg, rz_deg`` beside, or an array (N, 6); or a CSV with joints instead, the
        program as it is: wanted is where the chain as drawn stands at them, and it goes on standing so.
    output : path
        JOINTS.csv; with `export` the compensator's own file.
    kind : {"exact", "linear"}
    export : str, optional
        What to write in place of commands, see `export_compensator`.
    worst_mm : float
        Of a table: what it may leave.
    channels : mapping of (N,) arrays or numbers, optional
        Beside an array of targets, what the effects depend on, by the names of a recording's columns:
        ``temp_C, payload_kg, time_s, approach1`` ...
    bands : bool
        Write beside each command between which coordinates the machine will stand with 95 % probability, in {O} as the
        instrument sees it: ``x_lo_mm, x_hi_mm`` ...
    tell : callable
        Told in words what was assumed where a channel is not given.

    Raises
    ------
    UsageError
        An array of targets that are no finite numbers, or of another shape; a channel that nothing could be.
    InputError
        A file, or a data frame, that cannot be read as targets.
    NoSolutionError
        Targets out of reach.
    """
    from deltacal_gen.use import commanded, compensation

    if export is not None:
        export_compensator(result, export, output, kind=kind, worst_mm=worst_mm, tell=tell)
        return np.zeros((0, 3))
    check_output(output, result, targets)
    known = known_result(result)
    compensator = compensation.Compensator(known, kind)
    if targets is None:
        raise UsageError("give the targets: a CSV with x_mm, y_mm, z_mm.")
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
        raise UsageError("bands stand beside the commands in a file: give -o JOINTS.csv.")
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
    export: str,
    output: Source | None,
    *,
    kind: str = "exact",
    worst_mm: float = 0.01,
    tell: Progress = silent,
) -> FirmwareLines | None:
    """Write what was found of a machine for its controller; return the lines of a printer's firmware.

    Parameters
    ----------
    export : str
        One of `deltacal_gen.use.exporters.names`.
    output : path
        The export's own file.
    kind, worst_mm, tell
        As of `compensate`.

    Raises
    ------
    UsageError
        There is no such export, or none for this machine.
    """
    from deltacal_gen.use import exporters

    check_output(output, result)
    known, exporter = known_model(result), exporters.exporter_of(export)
    if output is None:
        raise UsageError("an export needs the file to write: give -o FILE.")
    if isinstance(known, MotionModel):
        exporter.in_motion(known, Path(output))
        return None
    lines = exporter.at_rest(known, Path(output), kind=kind, worst_mm=worst_mm)
    _tell_of_correction(known, tell)
    return lines


def _tell_of_correction(known: Result | Diagnosis, tell: Progress) -> None:
    if known.correction is not None:
        tell("the smooth correction is not part of an export; compensate targets instead")


def feed_forward(
    result: Given, trajectory: Source, output: Source | None = None, *, tell: Progress = silent
) -> FeedForward:
    """Return what drives must be told along a trajectory: commanded joints, their derivatives, and torques.

    Parameters
    ----------
    result : path or mapping
        RESULT.json or DIAGNOSIS.json of a recording in motion: with the friction that was found.
    trajectory : path
        A CSV with ``time_s`` and joints, or ``x_mm, y_mm, z_mm`` in {O}, with ``rx_deg, ry_deg, rz_deg`` where these
        are commanded too; ``run`` and ``payload_kg`` where they vary.
    output : path
        COMMANDS.csv: joints, velocities, accelerations, torques in the unit of the result's readings.
    tell : callable
        Told in words which rows are left out, where velocities are not those of the joints, where friction is ramped
        and where limits are passed.

    Raises
    ------
    UsageError
        The result is of a machine at rest.
    """
    from deltacal_gen.use import trajectory as along

    check_output(output, result, trajectory)
    known = known_model(result)
    if not isinstance(known, MotionModel):
        raise UsageError("torques along a trajectory need a result of a recording in motion (kind torque).")
    found = along.feed_forward(known, trajectory)
    for words in (*found.given.repairs, along.blanks(found), along.bent(found)):
        if words is not None:
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


def firmware_lines(result: Given, kind: str, output: Source | None = None, *, tell: Progress = silent) -> FirmwareLines:
    """Return the lines of a printer's firmware for a calibrated machine, beside those in its file now.

    Parameters
    ----------
    kind : str
        The firmware, as `compensate` exports for it: klipper, ...
    output : path
        The lines.

    Raises
    ------
    UsageError
        Another mechanism than a linear delta.
    NoSolutionError
        The lines would be worse than those in the file now; nothing is written.
    """
    from deltacal_gen.use import exporters, firmware

    check_output(output, result)
    known, exporter = known_result(result), exporters.exporter_of(kind)
    if not isinstance(exporter, firmware.Firmware):
        raise UsageError(f"an export '{kind}' has no lines of a printer's firmware.")
    found = exporter.lines_of(known)
    _tell_of_correction(known, tell)
    if output is not None:
        write_files({Path(output): found.text})
    return found


def predict(
    result: Given,
    recording: AnyRecording,
    output: Source | None = None,
    *,
    place: AnyRecording | None = None,
    bands: bool = False,
    tell: Progress = silent,
) -> Recording:
    """Return a recording's readings as an identified or diagnosed model predicts them.

    Parameters
    ----------
    result : path, mapping, Result or Diagnosis
        RESULT.json or DIAGNOSIS.json, or what it was read from.
    recording : path, data frame or Recording
        Joints, and the channels that effects depend on; its measured cells are never read.
    output : path, optional
        PREDICTED.csv.
    place : path, data frame or Recording, optional
        Other poses from the same set-ups of the instrument: those that it holds are placed by its readings, whether
        the result knows a set-up of that name or not.
    bands : bool
        Put beside each value the ends between which it lies with 95 % probability, ``x_lo_mm, x_hi_mm`` ...: channels
        of the recording that is returned or, of distances, columns of the file alone. The noise of a reading is not in
        them.
    tell : callable
        Told in words which joints stand at angles that the diagnosis never saw.

    Returns
    -------
    Recording
        Of a result in motion a `motion.trajectories.Trajectories`, with half the width of its bands in `half`. They
        hold readings, noise included: sample by sample nobody tells that from what the model leaves out.

    Raises
    ------
    InputError
        A file, or data frame, that cannot be used; a set-up that the result does not know, without `place`.
    """
    from deltacal_gen.diagnosis import spectrum
    from deltacal_gen.instrument.kinds import kind_of
    from deltacal_gen.use import prediction

    check_output(output, result, recording, place)
    known = known_model(result)
    if isinstance(known, MotionModel):
        refuse_in_motion(place=place)
        found = _moving(recording).predict(known, bands=bands)
        beyond = in_words(found.outside, "samples"), not_shown(found.unshown.sum(axis=0).tolist())
        for words in (*put_right(found.repairs), *beyond):
            if words is not None:
                tell(words)
        if output is not None:
            write_files({Path(output): csv_text(columns_of(found))})
        return cast("Recording", found)
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
    for words in (prediction.told_of_events(known, given), in_words(prediction.beyond_laws(known, given), "rows")):
        if words is not None:
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


def _moving(recording: object) -> Torque:
    """Return a recording in motion, which a result of one asks for; raises InputError where it is none."""
    found = in_motion(recording)
    if found is None:
        raise InputError(
            "the result is of a recording in motion, and this is none.",
            'Give one whose sidecar says kind = "torque" under [measurement].',
            file=recording if isinstance(recording, str | Path) else None,
        )
    return found


def validate(result: Given, recording: AnyRecording, report: Source | None = None) -> Validation:
    """Return the error of a calibrated model on readings it has not seen, against the noise.

    Parameters
    ----------
    result : path, mapping, Result or Diagnosis
        RESULT.json or DIAGNOSIS.json, or what it was read from.
    recording : path, data frame or Recording
        Joints and readings. A set-up of the instrument that the result does not know is placed by them.
    report : path, optional
        One self-contained HTML page of the same; its name ends with ``.html``.

    Returns
    -------
    Validation
        Of a recording in motion a `results.motion.MotionValidation`.

    Raises
    ------
    InputError
        A file, or data frame, that cannot be used, or whose readings are of another kind than those of the result.
    """
    from deltacal_gen.use import validation

    check_output(report, result, recording, ending=(".html",))
    known = known_model(result)
    if isinstance(known, MotionModel):
        return cast("Validation", _validated_in_motion(known, recording, report, made(result, recording)))
    robot = validation.calibrated_robot(known)
    given = as_known(known, recording, robot)
    own = made(result, recording, measured=given)
    found = validation.validate(known, given).replace(made=own, seen=_seen_before(own, known.made))
    if report is not None:
        from deltacal_gen.pages import validation as page

        write_files({Path(report): page.page(found)})
    return found


def _validated_in_motion(
    known: MotionResult | MotionDiagnosis, recording: AnyRecording, report: Source | None, made_by: Made
) -> MotionValidation:
    """Return how far off a model is on a recording in motion, and write its page where one is asked for."""
    moving = _moving(recording)
    found = moving.validate(known).replace(made=made_by, seen=_seen_before(made_by, known.made))
    if report is not None:
        from deltacal_gen.pages import motion as page

        write_files({Path(report): page.validation(found, moving.drawn(known))})
    return found


def certificate(
    result: Given, validation: AnyRecording, output: Source | None = None, *, about: Source | None = None
) -> Certificate:
    """Return what is certified of a calibrated machine; `output` is the page, and beside it the XML is written.

    Parameters
    ----------
    result : path or mapping
        RESULT.json or DIAGNOSIS.json.
    validation : path or recording
        Readings that took no part in the fit.
    output : path, optional
        CERTIFICATE.html: one page for A4; CERTIFICATE.xml beside it is the digital calibration certificate.
    about : path, optional
        TOML with what no recording knows: ``[laboratory]`` and ``[customer]`` (name, street, city, country),
        ``[machine]`` (manufacturer, serial), ``[calibration]`` (number, person, begin, end, place).

    Raises
    ------
    InputError
        The validation is a file that the fit was made of, the result keeps no uncertainty, or is one in motion.
    """
    from deltacal_gen.use import certificate as certified
    from deltacal_gen.use.prediction import calibrated_robot

    page = None if output is None else Path(output)
    check_output(page, result, validation, about, ending=(".html",))
    check_output(page and page.with_suffix(".xml"), result, validation, about)
    known = known_result(result)
    robot = calibrated_robot(known)
    given = as_recording(validation, robot)
    said = About() if about is None else read_about(str(about))
    own = made(result, validation, about, measured=given)
    _check_unseen(own.inputs, known.made.inputs if known.made else (), validation)
    checked = certified.check(known, given)
    days = [str(d) for d in (said.calibration.begin, said.calibration.end) if d is not None]
    found = Certificate(
        identifier=said.calibration.number or _number([file.sha256 for file in own.inputs]),
        machine=known.robot.robot.name,
        mechanism=known.robot.robot.mechanism,
        model=certified.model_of(known),
        manufacturer=said.machine.manufacturer,
        serial=said.machine.serial,
        instrument=own.instrument,
        kind=given.kind,
        readings=checked.validation.readings,
        performed=(days[0], days[-1]) if days else None,
        place=said.calibration.place,
        person=said.calibration.person or own.operator,
        laboratory=Party(**dict(said.laboratory)),
        customer=Party(**dict(said.customer)),
        conditions=certified.conditions(given),
        before=checked.before,
        after=checked.after,
        budget=checked.budget,
        placed=checked.validation.placed or (),
        iso9283=checked.validation.iso9283,
        iso230=checked.validation.iso230,
        unit=checked.validation.unit,
        unit_mm=checked.validation.unit_mm,
        fitted=known.made,
        made=own,
    )
    if page is not None:
        from deltacal_gen.pages.certificate import certificate as page_of
        from deltacal_gen.pages.dcc import dcc

        write_files({page: page_of(found), page.with_suffix(".xml"): dcc(found)})
    return found


def _check_unseen(own: tuple[InputFile, ...], fitted: tuple[InputFile, ...], validation: AnyRecording) -> None:
    """Raise an InputError where the readings are those of the fit."""
    if isinstance(validation, str | Path) and (name := _seen(own, fitted)) is not None:
        raise InputError(
            f"the calibration was made of these readings ('{name}'), so that they are no check of it.",
            "Give readings that took no part in it.",
            file=validation,
        )


def _seen_before(own: Made, fitted: Made | None) -> Literal[True] | None:
    """Tell whether a fit was made of a file that is asked to check it."""
    return True if fitted is not None and _seen(own.inputs, fitted.inputs) is not None else None


def _seen(own: Sequence[InputFile], fitted: Sequence[InputFile]) -> str | None:
    """Return the name of a file of readings that a fit was made of; None where it saw none of them."""
    hashes = {file.sha256 for file in fitted if not file.name.lower().endswith(NO_READINGS)}
    return next((file.name for file in own if file.sha256 in hashes), None)


def _number(hashes: list[str]) -> str:
    """Return a number that the files alone decide."""
    return f"deltacal-{hashlib.sha256(' '.join(hashes).encode()).hexdigest()[:NUMBER]}"


def compare(before: Given, after: Given, output: Source | None = None) -> Comparison:
    """Return what changed between two sessions of one machine, by parameter with its uncertainty; see `comparison`."""
    from deltacal_gen.use import comparison

    check_output(output, before, after)
    first, second = known_model(before), known_model(after)
    if isinstance(first, MotionModel) and isinstance(second, MotionModel):
        found = comparison.compare_in_motion(first, second)
    else:
        found = comparison.compare(_calibration(before), _calibration(after))
    found = found.replace(made=made(before, after))
    if output is not None:
        write_json(found, output)
    return found


def _calibration(given: Given) -> Result:
    """Return a result of `identify`; a diagnosis has no parameters to compare."""
    found = known_result(given)
    if not isinstance(found, Result):
        raise InputError(
            "this is no result of identify.",
            "Give two files that identify wrote; of a diagnosed session: identify --physics DIAGNOSIS.json.",
            file=None if isinstance(given, Mapping) else given,
        )
    return found
