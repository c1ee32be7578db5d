"""Commands as cyclopts knows them: what each takes, and how it is run."""

from __future__ import annotations

import inspect
from collections import OrderedDict
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Annotated, Any

from cyclopts import App, Group, Parameter

import deltacal_gen
from deltacal_gen.app.cli import receipts
from deltacal_gen.app.cli.signatures import GIVEN, WAY, Signature, option_of
from deltacal_gen.app.cli.table import COMMANDS, Command
from deltacal_gen.app.cli.terminal import Terminal
from deltacal_gen.errors import OptionMissing, OptionNotApplicable, ValueOutOfRange

FILES = ("output", "report", "picture", "write_effect")  # parameters that name a file to write
OUTPUT = Group("Output", sort_key=100)  # options of every command
SHOWN = {
    "as_json": ("--json", "Print only JSON, of the result or of the error."),
    "quiet": ("--quiet", "Print only errors."),
    "verbose": ("--verbose", "Print each step of the work, and the traceback of an internal error."),
}
IMPORT = "Convert files of printer firmware, trackers, ROS, motion capture or URDF into robot files and recordings."
PICTURE, DRAWN = "picture", "Picture of the result (.svg, .png or .pdf)."
MARK = "Decimal mark of the tables, '.' or ','; default as each table shows it."


def application(words: list[str]) -> App:
    """Return the command line, for these words: what the command that they call takes, and of the others the help."""
    app = _app("deltacal", "Calibrate parallel robots with models that are derived, not typed.")
    app.register_install_completion_command()
    for flag in ("--help", "--version", "--install-completion"):
        app[flag].group = OUTPUT
    first, listed = " ".join(words[:1]), words[:1] in ([], ["--help"], ["-h"])
    for position, (title, commands) in enumerate(COMMANDS.items()):
        group = Group(title, sort_key=position)
        for order, (name, command) in enumerate(commands.items()):
            how: dict[str, Any] = {"group": group, "sort_key": order}
            called = first in (name, "--install-completion")
            functions = [getattr(deltacal_gen, f) for f in command.functions] if called or listed else []
            if not command.functions:
                app.command(_importers(name, called, **how))
            elif called:
                _add(app, name, command, functions, **how)
            else:
                app.command(_app(name, (functions[0].__doc__ or "").partition("\n")[0] if functions else "", **how))
    return app


def _app(name: str, help: str, **how: Any) -> App:
    return App(
        name=name,
        help=help,
        version=f"deltacal {deltacal_gen.__version__}",
        version_flags=("--version", "-V"),
        help_flags=("--help", "-h"),
        help_format="plaintext",
        result_action="return_value",
        **how,
    )


def _importers(name: str, called: bool, **how: Any) -> App:
    """Return the command that imports, with a command for each kind: these are many modules."""
    app = _app(name, IMPORT, **how)
    if called:
        from deltacal_gen.files import importers

        for kind in importers.names():
            command = Command((f"import_{kind}",), needed=("output",), receipt=receipts.imported)
            _add(app, kind, command, [importers.importer(kind)])
    return app


def _add(app: App, name: str, command: Command, functions: list[Callable[..., Any]], **how: Any) -> None:
    """Add a command to the command line."""
    taken = Signature(functions, needed=command.needed)

    def run(*arguments: Any, **options: Any) -> int:
        given = inspect.signature(run).bind(*arguments, **options).arguments
        return _run(command, {key: value for key, value in given.items() if value is not None})

    own = [_option(bool, key, option_of(key), words) for key, words in command.flags.items()]
    every = [_option(bool, key, *words, group=OUTPUT) for key, words in SHOWN.items()]
    mark = [_option(str | None, "decimal", "--decimal", MARK, group=OUTPUT)] if taken.reads_tables else []
    picture = [_option(Path | None, PICTURE, "--picture", DRAWN)] if command.draws else []
    parameters = [*taken.parameters, *own, *picture, *mark, *every]
    run.__signature__ = inspect.Signature(parameters)  # type: ignore[attr-defined]
    run.__annotations__ = {p.name: p.annotation for p in parameters}
    app.command(run, name=name, help=taken.help, help_epilogue=taken.examples, **how)


def _option(kind: Any, key: str, option: str, words: str, **how: Any) -> inspect.Parameter:
    """Return an option that the command line alone has: a flag, or a text."""
    annotation = Annotated[kind, Parameter(name=option, help=words, negative=(), show_default=False, **how)]
    default = False if kind is bool else None
    return inspect.Parameter(key, inspect.Parameter.KEYWORD_ONLY, default=default, annotation=annotation)


def _run(command: Command, given: dict[str, Any]) -> int:
    """Run a command; return its exit code."""
    from deltacal_gen.app.commands.common import PICTURES, check_output
    from deltacal_gen.files.dialect import set_decimal_mark
    from deltacal_gen.files.writing import is_standard_output

    shown = {key: given.pop(key, False) for key in SHOWN}
    aside = any(isinstance(value, Path) and is_standard_output(value) for value in given.values())
    if aside and shown["as_json"]:
        raise ValueOutOfRange("--json and a file would both go to the standard output; leave one of them out.")
    set_decimal_mark(given.pop("decimal", None))
    terminal = Terminal(**shown, aside=aside)
    notes: list[str] = []
    picture = given.pop(PICTURE, None) if command.draws else None
    files = [value for value in given.values() if isinstance(value, Path)]
    check_output(picture, *files, ending=PICTURES)
    function = getattr(deltacal_gen, command.choose(given) if command.choose else command.functions[0])
    call = _call(function, {key: v for key, v in given.items() if key not in command.flags}, command.choosers)
    with ExitStack() as stack:
        for key, watch in {"progress": terminal.stages, "told": terminal.tasks}.items():
            if key in call.signature.parameters:
                call.arguments[key] = stack.enter_context(watch())
        if "tell" in call.signature.parameters:
            call.arguments["tell"] = notes.append
        found = function(*call.args, **call.kwargs)
    if picture is not None:
        from deltacal_gen.pages import figures, plots

        figures.save(plots.plot(found), picture)
    answer = found if command.receipt is None else command.receipt(found, given, tuple(notes))
    terminal.show(answer)
    for path in (*(given.get(name) for name in FILES), picture):
        if path is not None and path.exists() and not aside:
            terminal.say(f"written to {path}")
    return int(command.negative(found, given))


def _call(function: Callable[..., Any], given: Mapping[str, Any], choosers: Sequence[str]) -> inspect.BoundArguments:
    """Return the arguments of a function; raises UsageError where one is given that it does not take, or is missing."""
    signature = inspect.signature(function)
    call = inspect.BoundArguments(signature, OrderedDict())
    for key, value in given.items():
        if key in signature.parameters:
            call.arguments[key] = value if not key.startswith(WAY) else True
        elif key not in choosers:
            what = (function.__doc__ or "").partition("\n")[0].rstrip(".")
            raise OptionNotApplicable(f"{option_of(key)} means nothing here ({what}); leave it out.")
    for key, parameter in signature.parameters.items():
        if parameter.default is parameter.empty and key not in call.arguments and parameter.kind in GIVEN:
            positional = parameter.kind is not parameter.KEYWORD_ONLY
            raise OptionMissing(f"{key.upper() if positional else option_of(key)} is needed here; give it.")
    return call
