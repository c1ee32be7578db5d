"""What the command line takes for a command, read off the functions that do it.

Positional parameters of a function are arguments, keyword-only ones are options, and its docstring (numpydoc) is the
help of each. A unit at the end of a name is left to the help (``tolerance_mm`` is ``--tolerance``), a flag
``as_distance`` is spelled ``--as distance``, and what only a program can hand over, an array or a callable, is no
option.
"""

from __future__ import annotations

import builtins
import inspect
import re
from collections.abc import Callable, Sequence
from pathlib import Path
from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from cyclopts import Parameter
from docstring_parser.numpydoc import parse

Function = Callable[..., Any]
GIVEN = (inspect.Parameter.POSITIONAL_OR_KEYWORD, inspect.Parameter.KEYWORD_ONLY)  # kinds of parameters
UNIT = re.compile(r"_(mm|deg|s|Hz)$")
OUTPUT = "output"
WAY = "as_"  # a flag "as_X" of a function is the option "--as X"
FILES = ("Path", "Source", "AnyRobot", "AnyRecording", "Given")  # types of which the command line takes a path


class Unsaid:
    """A type of which no value can be written on a command line."""

    def __class_getitem__(cls, of: object) -> type[Unsaid]:
        return cls


class _Types(dict[str, Any]):
    """Types by the names that annotations give them."""

    def __missing__(self, name: str) -> Any:
        return getattr(builtins, name, Unsaid)


_TYPES = _Types({"Literal": Literal, "Sequence": list} | dict.fromkeys(FILES, Path))


def option_of(name: str) -> str:
    """Return how the command line spells an option of a function."""
    plain = WAY if name.startswith(WAY) else UNIT.sub("", name)
    return f"--{plain.strip('_').replace('_', '-')}"


def type_of(parameter: inspect.Parameter) -> Any:
    """Return the type that the command line reads for a parameter; None where it can give none."""
    if parameter.name.startswith(WAY):
        return Literal[parameter.name.removeprefix(WAY)]
    found = eval(parameter.annotation, {}, _TYPES)
    parts = get_args(found) if get_origin(found) in (Union, UnionType) else (found,)
    said = tuple(part for part in parts if part not in (Unsaid, NoneType))
    if Path in said:
        return Path
    return Union[said] if said else None  # noqa: UP007  # of parts that are known when this runs


class Signature:
    """What a command takes, of one function or of several of which each call takes one.

    Attributes
    ----------
    help, examples : str
        What it does, and how it is called, from the docstring of the first.
    parameters : tuple of inspect.Parameter
        Its arguments and options, with types and help as cyclopts reads them.
    reads_tables : bool
        Whether one of these is a table of readings.
    """

    def __init__(self, functions: Sequence[Function], *, needed: Sequence[str] = ()) -> None:
        documents = [parse(inspect.getdoc(function) or "") for function in functions]
        first, self.needed = documents[0], needed
        self.help = _plain("\n\n".join(filter(None, (first.short_description, first.long_description))))
        examples = [e.description or e.snippet or "" for document in documents for e in document.examples]
        self.examples = "\n".join(f"Example: {line}" for line in examples)
        self._help = {
            name: _plain(p.description or "")
            for document in reversed(documents)
            for p in document.params
            for name in p.arg_name.split(", ")
        }
        given = [inspect.signature(function).parameters for function in functions]
        known = {name: p for parameters in reversed(given) for name, p in parameters.items()}
        always = {name for name in known if all(name in ps and ps[name].default is ps[name].empty for ps in given)}
        ordered = dict.fromkeys(name for parameters in given for name in parameters)
        taken = (self._taken(known[name], name in always) for name in ordered)
        self.parameters = tuple(sorted((p for p in taken if p is not None), key=lambda p: p.kind))
        self.reads_tables = any("AnyRecording" in str(p.annotation) for p in known.values())

    def _taken(self, parameter: inspect.Parameter, always: bool) -> inspect.Parameter | None:
        """Return a parameter as cyclopts reads it; None where the command line has none for it."""
        annotation, name, default = type_of(parameter), parameter.name, parameter.default
        if annotation is None or parameter.kind not in GIVEN:
            return None
        if name in self.needed:
            default = parameter.empty
        elif name.startswith(WAY) or (default is parameter.empty and not always):
            default = None
        how: dict[str, Any] = {"help": self._help.get(name, ""), "show_default": default not in (None, False, ())}
        kind: Any = parameter.POSITIONAL_ONLY
        if parameter.kind is parameter.KEYWORD_ONLY or name == OUTPUT:
            kind = parameter.KEYWORD_ONLY
            how["name"] = [option_of(name), *(["-o"] if name == OUTPUT else [])]
            how["negative"] = None if annotation is bool and default else ()
            how["allow_leading_hyphen"] = annotation is Path  # "-" is the standard output
        if default is None:
            annotation = annotation | None
        return inspect.Parameter(name, kind, default=default, annotation=Annotated[annotation, Parameter(**how)])


def _plain(text: str) -> str:
    """Return text of a docstring as a terminal shows it, a line for each paragraph."""
    return "\n\n".join(" ".join(paragraph.split()) for paragraph in text.replace("`", "").split("\n\n"))
