"""Files that commands wrote, read back: the one door by which an answer comes in from outside."""

from __future__ import annotations

import importlib
import json
import re
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any, Final, TypeVar, cast

from pydantic import ValidationError

from deltacal_gen.errors import FileFormat, FileNotReadable, InputError, OtherVersion
from deltacal_gen.results.base import Answer, Value, key_of, plain

if TYPE_CHECKING:
    from pydantic_core import ErrorDetails

    from deltacal_gen.results.diagnosis import Diagnosis
    from deltacal_gen.results.motion import MotionDiagnosis, MotionResult
    from deltacal_gen.results.result import Result

ANSWERS = {  # what `schema` says, and the type of it: module and class
    "deltacal.batch/1": ("batch", "Batch"),
    "deltacal.certificate/1": ("certificate", "Certificate"),
    "deltacal.comparison/1": ("comparison", "Comparison"),
    "deltacal.cycles/1": ("plan", "CyclePlan"),
    "deltacal.demo/2": ("demo", "Demo"),
    "deltacal.diagnosis/1": ("diagnosis", "Diagnosis"),
    "deltacal.error/1": ("written", "Failure"),
    "deltacal.next/1": ("written", "Experiment"),
    "deltacal.plan/1": ("plan", "Plan"),
    "deltacal.receipt/1": ("written", "Receipt"),
    "deltacal.result/1": ("result", "Result"),
    "deltacal.study/1": ("study", "Study"),
    "deltacal.validation/1": ("validation", "Validation"),
}
IN_MOTION = {  # the same of recordings in motion
    "deltacal.diagnosis/1": ("motion", "MotionDiagnosis"),
    "deltacal.plan/1": ("plan", "MotionPlan"),
    "deltacal.result/1": ("motion", "MotionResult"),
    "deltacal.validation/1": ("motion", "MotionValidation"),
}
TORQUE: Final = "torque"  # what drives give
KINDS_IN_MOTION = (TORQUE,)
Part = TypeVar("Part", bound=Value)
Given = str | Path | Mapping[str, Any]  # an answer: its file, its JSON, or itself
FITTED = ("deltacal.result/1", "deltacal.diagnosis/1")
COMMANDS = {  # that write the files which other commands read
    "deltacal.result/1": "identify",
    "deltacal.diagnosis/1": "diagnose",
}
BECAME = {"deltacal.motion": "deltacal.result", "deltacal.motion-diagnosis": "deltacal.diagnosis"}  # as once called
MOST_SHOWN = 60  # letters of a value that cannot be used


def type_of(schema: str, *, in_motion: bool = False) -> type[Answer]:
    """Return the type of the answers with a `schema`."""
    module, name = (IN_MOTION if in_motion else ANSWERS)[schema]
    found: type[Answer] = getattr(importlib.import_module(f"deltacal_gen.results.{module}"), name)
    return found


def types_of(schema: str) -> tuple[type[Answer], ...]:
    """Return all types of answers with a `schema`: of machines at rest, then in motion."""
    return (type_of(schema), *([type_of(schema, in_motion=True)] if schema in IN_MOTION else []))


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
    return cast("Result | Diagnosis | MotionResult | MotionDiagnosis", read_answer(source, FITTED))


def read_diagnosis(source: Given) -> Diagnosis | MotionDiagnosis:
    """Return what `diagnose` found; see `read_result`."""
    return cast("Diagnosis | MotionDiagnosis", read_answer(source, ("deltacal.diagnosis/1",)))


def read_answer(source: Given, schemas: tuple[str, ...] = (*ANSWERS,), kind: str = "") -> Answer:
    """Return the answer that a file or a mapping holds, if it is one of some schemas; see `read_result`.

    Parameters
    ----------
    schemas : tuple of str
        What `schema` may say.
    kind : str
        How to call them in a message; default by the commands that write them.
    """
    writers = " or ".join(COMMANDS[s] for s in schemas if s in COMMANDS)
    kind = kind or (f"result of {writers}" if writers and set(schemas) <= COMMANDS.keys() else "answer of deltacal")
    if isinstance(source, Answer):
        if source.to_dict()["schema"] not in schemas:
            raise _Refused(kind, "", writers, None).error()
        return source
    file = None if isinstance(source, Mapping) else Path(source)
    text = json.dumps(plain(source)) if file is None else _text(file)
    refused = _Refused(kind, text, writers, file)
    try:
        data = json.loads(text)
    except json.JSONDecodeError as error:
        raise FileFormat(f"this is not JSON: {error.msg}.", refused.remedy, file=file, line=error.lineno) from None
    except RecursionError:
        raise FileFormat("its lists are nested too deeply.", refused.remedy, file=file) from None
    schema = data.get("schema") if isinstance(data, dict) else None
    if schema not in schemas:
        raise refused.error(schema, schemas)
    moves = schema in IN_MOTION and data.get("kind") in KINDS_IN_MOTION
    try:
        return type_of(str(schema), in_motion=moves).model_validate_json(text, strict=True)
    except ValidationError as error:
        raise refused.flaw(error.errors(include_url=False)[0]) from None


def _text(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8-sig")
    except FileNotFoundError:
        raise FileNotReadable("there is no such file.", "Check the path.", file=file) from None
    except UnicodeDecodeError:
        raise FileFormat("this is not text.", "Save it as UTF-8.", file=file) from None
    except OSError as error:
        raise FileNotReadable(f"cannot be read: {error.strerror}.", "Look at the file.", file=file) from None


class _Refused:
    """How a file is refused: where it is wrong, in words, and what to do."""

    def __init__(self, kind: str, text: str, writers: str, file: Path | None) -> None:
        self.kind, self.text, self.file = kind, text, file
        self.remedy = f"Give the file that {writers} wrote." if writers else "Give a file that deltacal wrote."

    def error(self, schema: object = None, known: tuple[str, ...] = ()) -> InputError:
        """Return the error of a file that says to be something else."""
        said = str(schema).partition("/")[0]
        family = BECAME.get(said, said)
        mine = next((s for s in known if s.partition("/")[0] == family), None)
        if mine is None:
            return FileFormat(f"this is no {self.kind}.", self.remedy, file=self.file)
        again = f"Run {COMMANDS[mine]} again" if mine in COMMANDS else "Make it again"
        return OtherVersion(
            f"it was written by another version: its schema is {schema}, and this version reads {mine}.",
            f"{again} with this version, or use the version that wrote it.",
            file=self.file,
        )

    def flaw(self, found: ErrorDetails) -> InputError:
        """Return the error of a file that is damaged."""
        steps = [s for s in found["loc"] if not isinstance(s, str) or s == key_of(s)]
        path = "".join(f"[{s}]" if isinstance(s, int) else f".{s}" for s in steps).removeprefix(".")
        if found["type"] == "missing":
            words = f"'{path}' is missing."
        else:
            value = json.dumps(found["input"], default=str)
            shown = value if len(value) <= MOST_SHOWN else value[: MOST_SHOWN - 3] + "..."
            words = f"'{path}' is {shown}: {found['msg'][:1].lower()}{found['msg'][1:]}."
        return FileFormat(f"this is no {self.kind}: {words}", self.remedy, file=self.file, line=self._line(steps))

    def _line(self, steps: list[Any]) -> int | None:
        """Return the line of a key of the file as it is written: a line to each."""
        at = re.search(rf"^ {re.escape(json.dumps(steps[0]))}:", self.text, re.MULTILINE) if steps else None
        return None if at is None else self.text.count("\n", 0, at.start()) + 1
