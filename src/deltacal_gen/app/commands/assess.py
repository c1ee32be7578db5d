"""Whether a calibrated machine is right: a check on other readings, a certificate, two sessions compared."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, cast

from deltacal_gen.app.commands.common import Source, as_recording, check_output, deliver, made, moving_like
from deltacal_gen.errors import ReadingsAlreadySeen, WrongFile

if TYPE_CHECKING:
    from deltacal_gen.app.commands.common import AnyRecording
    from deltacal_gen.results.certificate import Certificate
    from deltacal_gen.results.comparison import Comparison
    from deltacal_gen.results.motion import MotionDiagnosis, MotionResult, MotionValidation
    from deltacal_gen.results.parts import Made
    from deltacal_gen.results.reader import Given
    from deltacal_gen.results.result import Result
    from deltacal_gen.results.validation import Validation

NO_READINGS = (".toml", ".json")  # what files end with that a fit reads beside tables: robots, sidecars, answers
NUMBER = 16  # letters of a hash that stand for the number of a certificate where none is given


def validate(result: Given, recording: AnyRecording, *, report: Source | None = None) -> Validation:
    """Check a calibrated model on readings that took no part in the fit: errors against noise, ISO 9283, ISO 230-2.

    Parameters
    ----------
    result : path or Result or Diagnosis
        RESULT.json of identify, or DIAGNOSIS.json of diagnose.
    recording : path, data frame or Recording
        Joints and readings (CSV). An instrument set-up that the result does not know is located by these readings.
    report : path, optional
        Report (.html).

    Returns
    -------
    Validation
        Of a recording in motion a `results.motion.MotionValidation`.

    Raises
    ------
    InputError
        A file, or data frame, that cannot be used, or whose readings are of another kind than those of the result.

    Examples
    --------
    deltacal validate result.json other.csv
    """
    from deltacal_gen.app.commands.clocks import as_known
    from deltacal_gen.results.motion import MotionModel
    from deltacal_gen.use import validation
    from deltacal_gen.use.known import known_model
    from deltacal_gen.use.prediction import calibrated_robot

    check_output(report, result, recording, ending=(".html",))
    known = known_model(result)
    if isinstance(known, MotionModel):
        return cast("Validation", _validated_in_motion(known, recording, report, made(result, recording)))
    robot = calibrated_robot(known)
    given = as_known(known, recording, robot)
    own = made(result, recording, measured=given)
    seen = True if _seen(own, known.made) else None
    found = validation.validate(known, given).replace(made=own, seen=seen)
    return deliver(found, None, report)


def _validated_in_motion(
    known: MotionResult | MotionDiagnosis, recording: AnyRecording, report: Source | None, made_by: Made
) -> MotionValidation:
    """Return how far off a model is on a recording in motion, and write its page where one is asked for."""
    from deltacal_gen.files.writing import write_files

    moving = moving_like(recording)
    found = moving.validate(known).replace(made=made_by, seen=True if _seen(made_by, known.made) else None)
    if report is not None:
        from deltacal_gen.pages import motion as page

        write_files({Path(report): page.validation(found, moving.drawn(known))})
    return found


def certificate(
    result: Given, validation: AnyRecording, *, about: Source | None = None, output: Source | None = None
) -> Certificate:
    """Write a calibration certificate: errors before and after, uncertainty budget (GUM), ISO 9283, file hashes.

    Parameters
    ----------
    result : path or Result or Diagnosis
        RESULT.json of identify, or DIAGNOSIS.json of diagnose.
    validation : path, data frame or Recording
        Readings that took no part in the fit (CSV).
    about : path, optional
        ABOUT.toml with the details of the certificate: [laboratory] and [customer] (name, street, city, country),
        [machine] (manufacturer, serial), [calibration] (number, person, begin, end, place).
    output : path, optional
        CERTIFICATE.html (A4); the digital calibration certificate (DCC) is written beside it as CERTIFICATE.xml.

    Raises
    ------
    InputError
        The fit was made of these readings, the result keeps no uncertainty, or is one in motion.

    Examples
    --------
    deltacal certificate result.json validation.csv --about about.toml -o certificate.html
    """
    from deltacal_gen.files.about import About, read_about
    from deltacal_gen.files.writing import write_files
    from deltacal_gen.results.certificate import Certificate, Party
    from deltacal_gen.use import certificate as certified
    from deltacal_gen.use.known import known_result
    from deltacal_gen.use.prediction import calibrated_robot

    page = None if output is None else Path(output)
    check_output(page, result, validation, about, ending=(".html",))
    check_output(page and page.with_suffix(".xml"), result, validation, about)
    known = known_result(result)
    robot = calibrated_robot(known)
    given = as_recording(validation, robot)
    said = About() if about is None else read_about(str(about))
    own = made(result, validation, about, measured=given)
    if isinstance(validation, str | Path) and (name := _seen(own, known.made)) is not None:
        raise ReadingsAlreadySeen(
            f"the calibration was made of these readings ('{name}'), so that they are no check of it.",
            "Give readings that took no part in it.",
            file=validation,
        )
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


def _seen(own: Made, fitted: Made | None) -> str | None:
    """Return the name of a file of readings that a fit was made of; None where it saw none of them."""
    hashes = {file.sha256 for file in fitted.inputs if not file.name.lower().endswith(NO_READINGS)} if fitted else ()
    return next((file.name for file in own.inputs if file.sha256 in hashes), None)


def _number(hashes: list[str]) -> str:
    """Return a number that the files alone decide."""
    return f"deltacal-{hashlib.sha256(' '.join(hashes).encode()).hexdigest()[:NUMBER]}"


def compare(before: Given, after: Given, *, output: Source | None = None) -> Comparison:
    """Compare two calibrations of one machine: which parameters changed, with uncertainty, and which did not.

    Parameters
    ----------
    before : path or Result
        RESULT.json of the earlier session.
    after : path or Result
        RESULT.json of the later session.
    output : path, optional
        COMPARISON.json, the result.

    Raises
    ------
    InputError
        No results of identify, or of different machines.

    Examples
    --------
    deltacal compare march.json june.json
    """
    from deltacal_gen.results.motion import MotionModel
    from deltacal_gen.use import comparison
    from deltacal_gen.use.known import known_model

    check_output(output, before, after)
    first, second = known_model(before), known_model(after)
    if isinstance(first, MotionModel) and isinstance(second, MotionModel):
        found = comparison.compare_in_motion(first, second)
    else:
        found = comparison.compare(_calibration(before), _calibration(after))
    return deliver(found.replace(made=made(before, after)), output)


def _calibration(given: Given) -> Result:
    """Return a result of `identify`; a diagnosis has no parameters to compare."""
    from deltacal_gen.results.result import Result
    from deltacal_gen.use.known import known_result

    found = known_result(given)
    if not isinstance(found, Result):
        raise WrongFile(
            "this is no result of identify.",
            "Give two files that identify wrote; of a diagnosed session: identify --physics DIAGNOSIS.json.",
            file=None if isinstance(given, Mapping) else given,
        )
    return found
