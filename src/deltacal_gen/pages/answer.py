"""The page of an answer, whatever it is the answer of."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from deltacal_gen.pages import motion, report, studies, validation
from deltacal_gen.results.base import Answer
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.motion import MotionDiagnosis, MotionResult
from deltacal_gen.results.result import Result
from deltacal_gen.results.study import Study
from deltacal_gen.results.validation import Validation

_PAGES: Mapping[type[Answer], Callable[[Any], str]] = {
    Result: report.calibration,
    Diagnosis: report.diagnosis,
    MotionResult: motion.motion,
    MotionDiagnosis: motion.motion,
    Study: studies.page,
    Validation: validation.page,
}


def page_of(found: Answer) -> str:
    """Return the page of an answer of a sort that has one."""
    return _PAGES[type(found)](found)
