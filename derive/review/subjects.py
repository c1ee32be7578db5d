"""What a report may be on: models of mechanisms, and effects; and the machine that shows each in numbers."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from functools import cache
from importlib import resources
from pathlib import Path

from deltacal_gen.errors import UsageError
from deltacal_gen.files.robot import Robot, for_model, read_robot, robot_from_dict
from deltacal_gen.machine.registry import load_mechanism, mechanism_names, mechanism_of
from deltacal_gen.physics.parts import lacking
from deltacal_gen.physics.terms import effect_names
from derive import registry
from derive.spec import LimbMechanism


@dataclass(frozen=True)
class Subject:
    """What a report is on: a model of a mechanism, an effect, or the method.

    Attributes
    ----------
    name : str
        ``delta/42`` or ``backlash``.
    mechanism : str
        Registered name; empty for an effect.
    """

    name: str
    mechanism: str

    @property
    def stem(self) -> str:
        """Name of its file."""
        return self.name.replace("/", "-") if self.mechanism or self.name == "method" else f"effect-{self.name}"


METHOD = Subject("method", "")  # what every recording goes through: solvers, weights, the charge of a search


def subjects() -> list[Subject]:
    """Return all models of all mechanisms, all effects, and the method."""
    models = [Subject(model, name) for name in mechanism_names() for model in _models(name)]
    return [*models, *(Subject(name, "") for name in effect_names()), METHOD]


def subject(name: str) -> Subject:
    """Return what `name` means: a model, a mechanism (then its largest model) or an effect.

    Raises
    ------
    UsageError
        There is no such thing.
    """
    every = subjects()
    named = [s for s in every if s.name == name] or [s for s in every if s.mechanism == name]
    if not named:
        known = ", ".join(s.name for s in every)
        raise UsageError(f"there is no model, mechanism or effect '{name}'; known: {known}.")
    return named[0]


@cache
def _models(mechanism: str) -> tuple[str, ...]:
    """Return the models of a mechanism; those of a chain are its robot file's."""
    robot = example(mechanism)
    return tuple(mechanism_of(robot).models if robot is not None else load_mechanism(mechanism).models)


@cache
def example(mechanism: str) -> Robot | None:
    """Return a machine as a mechanism describes it: an example's, else that of the mechanism's `drawing`, or None."""
    kernels = importlib.import_module(f"deltacal_kernels.{mechanism}.parameters")
    machine = getattr(kernels, "MACHINE", mechanism)
    folder = Path(str(resources.files("deltacal_gen") / "examples"))
    for file in sorted(folder.glob("*/robot.toml"), key=lambda f: (f.parent.name != machine, f.parent.name)):
        robot = read_robot(file)
        if robot.mechanism == mechanism:
            return robot
        if robot.mechanism == machine:
            return for_model(robot, next(iter(load_mechanism(mechanism).models)))
    spec = registry.mechanism(machine)
    if not isinstance(spec, LimbMechanism) or not spec.drawing:
        return None
    robot = robot_from_dict({"robot": {"name": machine, "mechanism": machine}, **spec.drawing})
    return robot if machine == mechanism else for_model(robot, next(iter(load_mechanism(mechanism).models)))


def applies(effect: str, mechanism: str) -> list[str]:
    """Return what a mechanism lacks that an effect needs; nothing where it applies."""
    robot = example(mechanism)
    of = load_mechanism(mechanism) if robot is None else mechanism_of(robot)
    return lacking(effect, of, {} if robot is None else of.moves(robot), {} if robot is None else of.roles(robot))


def title_of(mechanism: str) -> str:
    """Return the title of a mechanism as its committed kernels say it."""
    title: str = importlib.import_module(f"deltacal_kernels.{mechanism}.parameters").TITLE
    return title
