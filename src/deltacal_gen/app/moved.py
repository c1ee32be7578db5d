"""What moved in a machine from one recording to another: of two answers, in words."""

from __future__ import annotations

import math

from deltacal_gen.results.base import Answer
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.document import rounded
from deltacal_gen.results.motion import (
    MotionDiagnosis,
    MotionModel,
    MotionResult,
    MotionValidation,
    by_joint,
    by_limb,
)
from deltacal_gen.results.result import Result
from deltacal_gen.results.validation import Validation
from deltacal_gen.use.comparison import compare

CLEAR = 3.0  # standard deviations by which an effect has changed


def moved(old: Answer, new: Answer) -> str | None:
    """Return in words what is other than it was; None of answers that have nothing in common, at rest and in motion."""
    if type(old) is not type(new):
        return None
    if isinstance(old, MotionModel | MotionValidation):
        return _moved_drives(old, new)
    if isinstance(old, Result) and isinstance(new, Result):
        return compare(old, new).summary
    if isinstance(old, Diagnosis) and isinstance(new, Diagnosis):
        parts = _named_otherwise(old, new) + [
            f"{name} of {effect} was {rounded(was, std)[0]}, is {' +- '.join(rounded(now, std))} {unit}"
            for effect, name, was, now, std, unit in grown(old, new)
        ]
        said = "; ".join(parts) or f"still {new.verdict}"
        before, after = (f"{v:.4f}" if v is not None else "-" for v in (r.final.heldout_rms_mm for r in (old, new)))
        text = f"{said}; held out {before} -> {after} mm."
        if old.geometry is None or new.geometry is None:
            return text
        return f"{text} {compare(old.geometry, new.geometry).summary}"
    was, now = (r.rms_mm if isinstance(r, Validation) else 0.0 for r in (old, new))
    return f"error {was:.4f} -> {now:.4f} mm."


def _named_otherwise(old: Diagnosis | MotionDiagnosis, new: Diagnosis | MotionDiagnosis) -> list[str]:
    """Return in words how verdict and names differ."""
    names = [sorted(e.name for e in r.effects) for r in (old, new)]
    gone, come = (sorted(set(a) - set(b)) for a, b in (names, names[::-1]))
    parts = [f"{old.verdict} became {new.verdict}"] if old.verdict != new.verdict else []
    return parts + [f"{name} appeared" for name in come] + [f"{name} is gone" for name in gone]


def _moved_drives(old: Answer, new: Answer) -> str:
    """Return in words what is other in motion: names, and what is left joint by joint."""
    said = ""
    if isinstance(old, MotionDiagnosis) and isinstance(new, MotionDiagnosis):
        said = f"{'; '.join(_named_otherwise(old, new)) or f'still {new.verdict}'}; "
    if isinstance(old, MotionValidation) and isinstance(new, MotionValidation):
        left = [by_limb(zip(r.rms_by_joint, r.unit_by_joint, strict=True)) for r in (old, new)]
        return f"error {left[0]} -> {left[1]}."
    finals = [r.final for r in (old, new) if isinstance(r, MotionResult | MotionDiagnosis)]
    return f"{said}held out {by_joint(finals[0])} -> {by_joint(finals[1])}."


def grown(old: Diagnosis, new: Diagnosis) -> list[tuple[str, str, float, float, float, str]]:
    """Return the parameters of effects in both diagnoses that differ by more than noise explains."""
    was = {(e.name, e.limbs, p.label, p.limb): p for e in old.effects for p in e.parameters}
    out = []
    for e in new.effects:
        for p in e.parameters:
            before = was.get((e.name, e.limbs, p.label, p.limb))
            if before is None or before.std is None or p.std is None:  # an order, a time: a constant
                continue
            std = math.hypot(before.std, p.std)
            first, then = float(before.value), float(p.value)
            if abs(then - first) > CLEAR * std:
                out.append((e.name, p.label, first, then, std, p.unit))
    return out
