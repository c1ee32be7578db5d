"""What a report may be on: models, effects, measurements and the method; and the machine that shows each in numbers."""

from __future__ import annotations

import importlib
from dataclasses import dataclass
from enum import Enum
from functools import cache

from deltacal_gen.errors import UnknownName
from deltacal_gen.files.robot import Robot, for_model, read_robot, robot_from_dict
from deltacal_gen.instrument.kind import Kind
from deltacal_gen.machine.registry import load_mechanism, mechanism_names, mechanism_of
from deltacal_gen.physics.parts import lacking
from deltacal_gen.physics.terms import drive_effect_names, effect_names
from derive import registry
from derive.review.sources import EXAMPLES
from derive.spec import LimbMechanism


class Sort(Enum):
    """What a report is on, each with a page of its own."""

    MODEL = "derivation"
    EFFECT = "effect"
    MEASUREMENT = "measurement"
    METHOD = "method"


@dataclass(frozen=True)
class Subject:
    """What a report is on: a model of a mechanism, an effect, a kind of measurement, or the method.

    Attributes
    ----------
    name : str
        ``delta/42``, ``backlash`` or ``distance``.
    sort : Sort
    mechanism : str
        Registered name; empty where it is of none.
    """

    name: str
    sort: Sort
    mechanism: str = ""

    @property
    def stem(self) -> str:
        """Name of its file."""
        own = self.name.replace("/", "-")
        return own if self.sort in (Sort.MODEL, Sort.METHOD) else f"{self.sort.value}-{own}"


METHOD = Subject("method", Sort.METHOD)  # what every recording goes through: solvers, weights, the charge of a search


def subjects() -> list[Subject]:
    """Return all models of all mechanisms, all effects, all kinds of measurement, and the method."""
    return [
        *(Subject(model, Sort.MODEL, name) for name in mechanism_names() for model in _models(name)),
        *(Subject(name, Sort.EFFECT) for name in (*effect_names(), *drive_effect_names())),
        *(Subject(name, Sort.MEASUREMENT) for name in registry.measurement_names()),
        METHOD,
    ]


def subject(name: str) -> Subject:
    """Return what `name` means: a model, a mechanism (then its largest model), an effect or a kind of measurement.

    Raises
    ------
    UsageError
        There is no such thing.
    """
    every = subjects()
    named = [s for s in every if s.name == name] or [s for s in every if s.mechanism == name]
    if not named:
        known = ", ".join(s.name for s in every)
        raise UnknownName(f"there is no model, mechanism, effect or measurement '{name}'; known: {known}.")
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
    for file in sorted(EXAMPLES.glob("*/robot.toml"), key=lambda f: (f.parent.name != machine, f.parent.name)):
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


def seen_by(kind: Kind) -> Robot:
    """Return a machine on which a kind of measurement is shown: the first whose errors it sees, else the first."""
    every = [robot for name in mechanism_names() if (robot := example(name)) is not None]
    return next((robot for robot in every if kind.looks(mechanism_of(robot), 1, 1)), every[0])


def title_of(mechanism: str) -> str:
    """Return the title of a mechanism as its committed kernels say it."""
    title: str = importlib.import_module(f"deltacal_kernels.{mechanism}.parameters").TITLE
    return title
