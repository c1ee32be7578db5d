"""Files that commands wrote, read back: the one door by which an answer comes in from outside."""

from __future__ import annotations

import importlib
import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, cast

from pydantic import ValidationError

from deltacal_gen.errors import FileFormat, FileNotReadable, OtherVersion
from deltacal_gen.results.base import Answer, key_of, plain

if TYPE_CHECKING:
    from deltacal_gen.results.diagnosis import Diagnosis
    from deltacal_gen.results.motion import MotionDiagnosis, MotionResult
    from deltacal_gen.results.result import Result

ANSWERS = {  # what `schema` says, and the types of it, by module and class: at rest, in motion
    "deltacal.batch/1": ("batch.Batch",),
    "deltacal.certificate/1": ("certificate.Certificate",),
    "deltacal.comparison/1": ("comparison.Comparison",),
    "deltacal.cycles/1": ("plan.CyclePlan",),
    "deltacal.demo/2": ("demo.Demo",),
    "deltacal.diagnosis/1": ("diagnosis.Diagnosis", "motion.MotionDiagnosis"),
    "deltacal.error/1": ("written.Failure",),
    "deltacal.next/1": ("written.Experiment",),
    "deltacal.plan/1": ("plan.Plan", "plan.MotionPlan"),
    "deltacal.receipt/1": ("written.Receipt",),
    "deltacal.result/1": ("result.Result", "motion.MotionResult"),
    "deltacal.study/1": ("study.Study",),
    "deltacal.validation/1": ("validation.Validation", "motion.MotionValidation"),
}
TORQUE: Final = "torque"  # what drives give
KINDS_IN_MOTION = (TORQUE,)
Given = str | Path | Mapping[str, Any]  # an answer: its file, its JSON, or itself
COMMANDS = {  # that write the files which other commands read
    "deltacal.result/1": "identify",
    "deltacal.diagnosis/1": "diagnose",
}
BECAME = {"deltacal.motion": "deltacal.result", "deltacal.motion-diagnosis": "deltacal.diagnosis"}  # as once called
MOST_SHOWN = 60  # letters of a value that cannot be used


def types_of(schema: str) -> tuple[type[Answer], ...]:
    """Return the types of answers with a `schema`: of machines at rest, then in motion."""
    places = (place.split(".") for place in ANSWERS[schema])
    return tuple(getattr(importlib.import_module(f"{__package__}.{module}"), name) for module, name in places)


def read_result(source: Given) -> Result | Diagnosis | MotionResult | MotionDiagnosis:
    """Return what `identify` or `diagnose` found, from its file, its JSON or as it is.

    Parameters
    ----------
    source : path or mapping
        RESULT.json or DIAGNOSIS.json, or the same as a dictionary or an answer.

    Raises
    ------
    InputError
        It cannot be read, is something else, or is damaged: the message names file, line, key and what was expected.
    """
    return cast("Result | Diagnosis | MotionResult | MotionDiagnosis", read_answer(source, (*COMMANDS,)))


def read_diagnosis(source: Given) -> Diagnosis | MotionDiagnosis:
    """Return what `diagnose` found; see `read_result`."""
    return cast("Diagnosis | MotionDiagnosis", read_answer(source, ("deltacal.diagnosis/1",)))


def read_answer(source: Given, schemas: Sequence[str] = (*ANSWERS,)) -> Answer:
    """Return the answer that a file or a mapping holds, if it is one of some schemas; see `read_result`.

    Parameters
    ----------
    schemas : sequence of str
        What `schema` may say.
    """
    if isinstance(source, Answer) and source.named() in schemas:
        return source
    file = None if isinstance(source, Mapping) else Path(source)
    text = json.dumps(plain(source)) if file is None else _text(file)
    writers = " or ".join(COMMANDS[s] for s in schemas if s in COMMANDS)
    kind = f"result of {writers}" if set(schemas) <= COMMANDS.keys() else "answer of deltacal"
    remedy = f"Give the file that {writers} wrote." if writers else "Give a file that deltacal wrote."
    try:
        data = json.loads(text)
    except json.JSONDecodeError as error:
        raise FileFormat(f"this is not JSON: {error.msg}.", remedy, file=file, line=error.lineno) from None
    except RecursionError:
        raise FileFormat("its lists are nested too deeply.", remedy, file=file) from None
    schema = data.get("schema") if isinstance(data, dict) else None
    if schema not in schemas:
        _check_version(str(schema), schemas, file)
        raise FileFormat(f"this is no {kind}.", remedy, file=file)
    kinds = types_of(str(schema))
    try:
        return kinds[-1 if data.get("kind") in KINDS_IN_MOTION else 0].model_validate_json(text, strict=True)
    except ValidationError as error:
        flaw = error.errors(include_url=False)[0]
        steps = [s for s in flaw["loc"] if not isinstance(s, str) or s == key_of(s)]
        path = "".join(f"[{s}]" if isinstance(s, int) else f".{s}" for s in steps).removeprefix(".")
        value = "missing" if flaw["type"] == "missing" else json.dumps(flaw["input"], default=str)
        shown = value if len(value) <= MOST_SHOWN else value[: MOST_SHOWN - 3] + "..."
        words = f"this is no {kind}: '{path}' is {shown}: {flaw['msg'][:1].lower()}{flaw['msg'][1:]}."
        raise FileFormat(words, remedy, file=file, line=_line(text, steps)) from None


def _text(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8-sig")
    except FileNotFoundError:
        raise FileNotReadable("there is no such file.", "Check the path.", file=file) from None
    except UnicodeDecodeError:
        raise FileFormat("this is not text.", "Save it as UTF-8.", file=file) from None
    except OSError as error:
        raise FileNotReadable(f"cannot be read: {error.strerror}.", "Look at the file.", file=file) from None


def _check_version(schema: str, known: Sequence[str], file: Path | None) -> None:
    """Raise OtherVersion for a file whose schema this version has under another number, or another name."""
    family = schema.partition("/")[0]
    mine = next((s for s in known if s.partition("/")[0] == BECAME.get(family, family)), None)
    if mine is not None:
        again = f"Run {COMMANDS[mine]} again" if mine in COMMANDS else "Make it again"
        raise OtherVersion(
            f"it was written by another version: its schema is {schema}, and this version reads {mine}.",
            f"{again} with this version, or use the version that wrote it.",
            file=file,
        )


def _line(text: str, steps: list[Any]) -> int | None:
    """Return the line of a key of a file as it is written: a line to each."""
    at = re.search(rf"^ {re.escape(json.dumps(steps[0]))}:", text, re.MULTILINE) if steps else None
    return None if at is None else text.count("\n", 0, at.start()) + 1
