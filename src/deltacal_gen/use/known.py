"""A result from a file that another installation may have written: what it names is here, or the file is refused."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

import numpy as np

from deltacal_gen.errors import BadValue, InconsistentResult, InputError, WrongFile
from deltacal_gen.files.robot import robot_of
from deltacal_gen.instrument.kinds import instrument_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.physics.factors import unpacked
from deltacal_gen.physics.law import is_law
from deltacal_gen.physics.terms import drive_effect_names, effect_names, load_effect
from deltacal_gen.results.base import Answer
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.motion import MotionDiagnosis, MotionModel, MotionResult
from deltacal_gen.results.reader import Given, read_diagnosis, read_result
from deltacal_gen.results.result import Result

Known = Result | Diagnosis | MotionResult | MotionDiagnosis


def known_result(source: Given) -> Result | Diagnosis:
    """Return what `identify` or `diagnose` found of a machine at rest; see `known_model`."""
    found = known_model(source)
    if isinstance(found, MotionModel):
        raise WrongFile(
            "this is of a recording in motion, kind torque: it tells torques, and no geometry.",
            "predict, validate and compare take it; for this, give what was made of a recording of positions.",
            file=None if isinstance(source, Mapping) else Path(source),
        )
    return found


def known_diagnosis(source: Given) -> Diagnosis:
    """Return what `diagnose` found of a machine at rest; see `known_model`."""
    read_diagnosis(source)
    found = known_result(source)
    assert isinstance(found, Diagnosis)
    return found


def known_model(source: Given) -> Known:
    """Return what `identify` or `diagnose` found, of a mechanism, a kind and effects that there are; see `read_result`.

    Raises
    ------
    InputError
        As `read_result`; or the file names what this installation does not have.
    """
    found = read_result(source)
    if isinstance(source, Answer):
        return found
    try:
        mechanism_of(robot_of(found.robot))
        if isinstance(found, MotionModel):
            effects = [term.effect for joint in found.joints for term in joint.terms]
        else:
            effects = [term.effect for term in found.physics or ()]
            for kept in (found.instrument, *([found.correction.machine.instrument] if found.correction else [])):
                instrument_of(kept).check_state()
            unpacked(found.uncertainty.factor if found.uncertainty else np.zeros(0))
        for name in effects:
            if not is_law(name) and name not in (*effect_names(), *drive_effect_names()):
                raise BadValue(f"there is no effect '{name}'.", "Add its file, and run deltacal kernels.")
            load_effect(name)
    except (InputError, ValueError) as error:  # the second of a formula, a rotation or a triangle that is none
        written = InconsistentResult(f"{error}.", "Give the file as it was written.")
        said = error if isinstance(error, InputError) else written
        file = None if isinstance(source, Mapping) else Path(source)
        raise InconsistentResult(said.problem, said.remedy, file=file, line=said.line, column=said.column) from None
    return found
