"""A result from a file that may have been edited by hand: its parts belong together, or it is refused.

`results.reader` checks the form of a file. What its numbers may be depends on the mechanism, the effects and the kind
of measurement that it names: that is looked at here.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from pathlib import Path

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.files.robot import robot_of
from deltacal_gen.instrument.kinds import instrument_of
from deltacal_gen.machine.registry import Machine, mechanism_of
from deltacal_gen.machine.rotation import from_vector
from deltacal_gen.motion.kinds import flaws as motion_flaws
from deltacal_gen.physics.law import is_law
from deltacal_gen.physics.terms import effect_names, load_effect, partial
from deltacal_gen.results.base import Answer
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.motion import MotionDiagnosis, MotionModel, MotionResult
from deltacal_gen.results.parts import InstrumentState, MachineState, TermState, Uncertainty
from deltacal_gen.results.reader import Given, read_diagnosis, read_result
from deltacal_gen.results.result import Parameter, Result
from deltacal_gen.states import CLOCK
from deltacal_gen.units import file_unit

_REMEDY = "Give the file as it was written; a machine is edited in its robot file."
ORTHONORMAL = 1e-6  # by which the rows of a rotation may fail to be


def known_result(source: Given) -> Result | Diagnosis:
    """Return what `identify` or `diagnose` found of a machine at rest; see `known_model`."""
    return _at_rest(known_model(source), source)


def known_diagnosis(source: Given) -> Diagnosis:
    """Return what `diagnose` found of a machine at rest; see `known_model`."""
    found = read_diagnosis(source)
    if not isinstance(source, Answer):
        _check(found, source)
    still = _at_rest(found, source)
    assert isinstance(still, Diagnosis)
    return still


def known_model(source: Given) -> Result | Diagnosis | MotionResult | MotionDiagnosis:
    """Return what `identify` or `diagnose` found, its parts held against one another; see `read_result`."""
    found = read_result(source)
    if not isinstance(source, Answer):
        _check(found, source)
    return found


def _at_rest(found: Result | Diagnosis | MotionResult | MotionDiagnosis, source: Given) -> Result | Diagnosis:
    if isinstance(found, MotionModel):
        raise InputError(
            "this is of a recording in motion, kind torque: it tells torques, and no geometry.",
            "predict, validate and compare take it; for this, give what was made of a recording of positions.",
            file=None if isinstance(source, Mapping) else Path(source),
        )
    return found


def _check(found: Result | Diagnosis | MotionResult | MotionDiagnosis, source: Given) -> None:
    file = None if isinstance(source, Mapping) else Path(source)
    for key, problem in motion_flaws(found) if isinstance(found, MotionModel) else _flaws(found):
        raise InputError(
            f"{problem}.",
            _REMEDY,
            file=file,
            column=key,
        )


def _flaws(found: Result | Diagnosis) -> Iterator[tuple[str, str]]:
    """Yield key and flaw of all that cannot be."""
    if not found.sigma_mm >= 0:
        yield "sigma_mm", f"the noise is {found.sigma_mm:g} mm, which cannot be negative"
    yield from _machine_flaws(found, "")
    mechanism = mechanism_of(robot_of(found.robot))
    if isinstance(found, Result):
        yield from _parameter_flaws(found.parameters, mechanism, found.instrument)
    if found.uncertainty is not None and not any(True for _ in _instrument_flaws(found.instrument)):
        yield from _uncertainty_flaws(found.uncertainty, found, mechanism)
    if found.correction is not None:
        yield from _machine_flaws(found.correction.machine, "correction.machine.")
        for k, smooth in enumerate(found.correction.smooth):
            if len(smooth.knots) != len(smooth.coefficients) or not smooth.length > 0 or not smooth.reach >= 0:
                flaw = "knots and coefficients are not equally many, or a length is below 0"
                yield f"correction.smooth[{k}]", flaw


def _machine_flaws(state: Result | Diagnosis | MachineState, where: str) -> Iterator[tuple[str, str]]:
    try:
        mechanism = mechanism_of(robot_of(state.robot))
    except InputError as error:
        yield f"{where}robot", str(error).rstrip(".")
        return
    for k, term in enumerate(state.physics or ()):
        for flaw in _term_flaws(term, mechanism):
            yield f"{where}physics[{k}]", flaw
    for flaw in _instrument_flaws(state.instrument):
        yield f"{where}instrument", flaw


def _uncertainty_flaws(known: Uncertainty, state: Result | Diagnosis, mechanism: Machine) -> Iterator[tuple[str, str]]:
    if unknown := [name for name in known.parameters if name not in mechanism.index]:
        yield "uncertainty", f"a {mechanism.name} has no parameter '{unknown[0]}'"
    rows = len(known.parameters) + known.coefficients + instrument_of(state.instrument).n_unknown
    if len(known.factor) != rows * (rows + 1) // 2:
        yield "uncertainty", f"its factor holds {len(known.factor)} numbers, and {rows * (rows + 1) // 2} were expected"
    if not (known.degrees > 0 and len(known.scatter) and (known.scatter >= 0).all()):
        yield "uncertainty", "degrees of freedom must be above 0, and a scatter not below"


def _parameter_flaws(
    parameters: tuple[Parameter, ...], mechanism: Machine, instrument: InstrumentState
) -> Iterator[tuple[str, str]]:
    of_machine = {p.name: file_unit(p.unit) for p in mechanism.parameters}
    units = dict(of_machine)
    if not any(True for _ in _instrument_flaws(instrument)):
        units |= instrument_of(instrument).reported | CLOCK
    for k, p in enumerate(parameters):
        key = f"parameters[{k}]"
        if p.name not in units:
            yield key, f"a {mechanism.name} has no parameter '{p.name}'"
        elif p.unit != units[p.name]:
            yield key, f"{p.name} is in {units[p.name]}, not in '{p.unit}'"
        elif p.std is not None and p.std < 0:
            yield key, f"the standard deviation of {p.name} is negative"
    if parameters and (missing := of_machine.keys() - {p.name for p in parameters}):
        yield "parameters", f"of a {mechanism.name} it does not say {', '.join(sorted(missing)[:3])}"


def _term_flaws(term: TermState, mechanism: Machine) -> Iterator[str]:
    if not is_law(term.effect) and term.effect not in effect_names():
        yield f"there is no effect '{term.effect}'"
        return
    try:
        kernels = load_effect(term.effect)
    except ValueError as error:  # a law that is none
        yield str(error).rstrip(".")
        return
    if any(not 1 <= i <= mechanism.limbs for i in term.limbs) or len(set(term.limbs)) < len(term.limbs):
        yield f"{term.effect}: limbs are counted from 1 to {mechanism.limbs}, each once"
    rows = max(len(term.limbs) if kernels.PER_LIMB else 0, len(term.tools), 1)
    own = partial(term.effect, term.lacks or (), term.gaps or ())
    wanted = (rows, len(own.COEFFICIENTS))
    if np.shape(term.values) != wanted:
        yield f"{term.effect} needs {wanted[0]} rows of {wanted[1]} values"
    if len(term.constants) != len(kernels.CONSTANTS):
        yield f"{term.effect} needs {len(kernels.CONSTANTS)} constants"


def _instrument_flaws(state: InstrumentState) -> Iterator[str]:
    try:
        instrument = instrument_of(state)
    except InputError as error:
        yield str(error).rstrip(".")
        return
    size = instrument.kind.state_size
    if np.shape(state.state)[1:] != (size,):
        yield f"a row of its state holds {size} numbers"
        return
    if not state.scale > 0:
        yield "its scale must be above 0"
    if instrument.kind.positions:
        turns = np.asarray(state.state, dtype=float)[:, :9].reshape(-1, 3, 3)
        bounded = np.clip(np.nan_to_num(turns), -2.0, 2.0)  # so that nothing overflows
        if not np.allclose(bounded @ np.swapaxes(bounded, 1, 2), np.eye(3), atol=ORTHONORMAL):
            yield "its frame is turned by no rotation"
    unknowns, rows = len(instrument.kind.unknown), len(state.state)
    if any(not 0 <= j < unknowns for j in state.free) or any(
        not 0 <= k < rows for a, b, _ in state.ties for k in (a, b)
    ):
        yield "it names unknowns or ties that it does not have"
        return
    try:
        frames = instrument.kind.frames(instrument)
    except ValueError:  # a rotation that mirrors, or is no number
        yield "a rotation of its state is none"
        return
    for (turn, _), row in zip(frames, state.state, strict=True) if frames else ():
        if np.abs(from_vector(turn) - row[:9].reshape(3, 3)).max() > ORTHONORMAL:
            yield "a rotation of its state is none"
    if frames and len(frames) != len(state.setups):
        yield f"it has {len(frames)} frames for {len(state.setups)} set-ups"
