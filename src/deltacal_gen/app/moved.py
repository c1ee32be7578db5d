"""What moved in a machine from one recording to another: of two answers, in words."""

from __future__ import annotations

from deltacal_gen.results.base import Answer
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.document import number
from deltacal_gen.results.motion import MotionDiagnosis, MotionResult, MotionValidation, by_joint, by_limb
from deltacal_gen.results.result import Result
from deltacal_gen.results.validation import Validation
from deltacal_gen.use.comparison import compare, compare_numbers, in_words


def moved(old: Answer, new: Answer) -> str | None:
    """Return in words what is other than it was; None of answers that have nothing in common, at rest and in motion."""
    if isinstance(old, Result) and isinstance(new, Result):
        return compare(old, new).summary
    if isinstance(old, Diagnosis) and isinstance(new, Diagnosis):
        left = [number(r.final.heldout_rms_mm) for r in (old, new)]
        text = f"{_found(old, new)}; held out {left[0]} -> {left[1]} mm."
        if old.geometry is None or new.geometry is None:
            return text
        return f"{text} {compare(old.geometry, new.geometry).summary}"
    if isinstance(old, MotionDiagnosis) and isinstance(new, MotionDiagnosis):
        return f"{_found(old, new)}; held out {by_joint(old.final)} -> {by_joint(new.final)}."
    if isinstance(old, MotionResult) and isinstance(new, MotionResult):
        return f"held out {by_joint(old.final)} -> {by_joint(new.final)}."
    if isinstance(old, MotionValidation) and isinstance(new, MotionValidation):
        errors = [by_limb(zip(r.rms_by_joint, r.unit_by_joint, strict=True)) for r in (old, new)]
        return f"error {errors[0]} -> {errors[1]}."
    if isinstance(old, Validation) and isinstance(new, Validation):
        return f"error {old.rms_mm:.4f} -> {new.rms_mm:.4f} mm."
    return None


def _found(old: Diagnosis | MotionDiagnosis, new: Diagnosis | MotionDiagnosis) -> str:
    """Return in words how verdict, names and the parameters of effects differ."""
    names = [sorted(e.name for e in r.effects) for r in (old, new)]
    gone, come = (sorted(set(a) - set(b)) for a, b in (names, names[::-1]))
    parts = [f"{old.verdict} became {new.verdict}"] if old.verdict != new.verdict else []
    parts += [f"{name} appeared" for name in come] + [f"{name} is gone" for name in gone]
    return "; ".join(parts + in_words(compare_numbers(old, new).changed)) or f"still {new.verdict}"
