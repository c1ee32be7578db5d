"""What all works share: contenders, the machine that they compute with, and recordings of it."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from deltacal_gen.files.robot import Robot, robot_from_dict
from deltacal_gen.machine.registry import load_mechanism
from deltacal_gen.machine.values import Measurement, Recording
from tests.benchmarks import by_hand

Array = np.ndarray
OURS, KERNEL, NUMPY, NUMBA = "ours", "kernel", "NumPy", "Numba"  # a user's call, what computes in it, by hand
NEEDED = {"in_casadi": "casadi", "in_jax": "jax"}  # tools that make programs of formulas: the extra "bench"
MISSING = [name for name in NEEDED.values() if find_spec(name) is None]
TOOLS = {
    tool.NAME: tool
    for module, needs in NEEDED.items()
    if needs not in MISSING and (tool := import_module(f".{module}", __package__))
}
MM = 1e-6  # agreement of lengths, and of angles times lengths
POINT = np.array([60.0, -20.0, -40.0])  # a reference point beside the centre of the platform [mm]
SIGMA = 0.005  # mm; a laser tracker
POSES = 19  # of a calibration: home and the paper's rings
DELTA = load_mechanism("delta")
ROBOT = robot_from_dict(
    {
        "robot": {"name": "prototype", "mechanism": "delta"},
        "geometry": {
            "base_radius": by_hand.BASE,
            "platform_radius": by_hand.PLATFORM,
            "proximal_length": by_hand.ARM,
            "distal_length": by_hand.ROD,
            "joint_spacing": by_hand.SPACING,
        },
        "workspace": {"top": by_hand.TOP, "radius": by_hand.RADIUS, "height": by_hand.HEIGHT},
    }
)
# column of each of the mechanism's parameters in the paper's order, and the paper's unknown per mm or rad
PAPER = np.array([[8 * i + k if k < 8 else 16 + 6 * i + k for k in range(14)] for i in range(3)]).ravel()
UNIT = DELTA.scaling("paper", ROBOT, [p.name for p in DELTA.parameters])


@dataclass(frozen=True)
class Contender:
    """One way of doing a work.

    Attributes
    ----------
    run : callable
        What is timed; it returns its result.
    view : callable
        Result to the array that all contenders must agree on; not timed.
    before : callable, optional
        Done before every single run; not timed.
    """

    run: Callable[[], Any]
    view: Callable[[Any], Array] = np.asarray
    before: Callable[[], None] | None = None


@dataclass(frozen=True)
class Work:
    """What is done, how often in one run, and by whom; `tolerance` is that of the agreement."""

    what: str
    unit: str
    count: int
    contenders: dict[str, Contender]
    tolerance: float = MM


def positions(n: int, seed: int = 1) -> Array:
    """Return points anywhere in the workspace (n, 3)."""
    rng = np.random.default_rng(seed)
    radius, turn = by_hand.RADIUS * np.sqrt(rng.random(n)), 2 * np.pi * rng.random(n)
    return np.column_stack(
        [radius * np.cos(turn), radius * np.sin(turn), -by_hand.TOP - by_hand.HEIGHT * rng.random(n)]
    )


def rings(n: int) -> Array:
    """Return home and the paper's poses: rings on the rim of the top and of the bottom layer, n poses in all."""
    turn = 4 * np.pi * np.arange(n - 1) / (n - 1)
    z = np.where(np.arange(n - 1) < (n - 1) // 2, -by_hand.TOP, -by_hand.TOP - by_hand.HEIGHT)
    circle = np.column_stack([by_hand.RADIUS * np.cos(turn), by_hand.RADIUS * np.sin(turn), z])
    return np.vstack([[0.0, 0.0, -by_hand.TOP - by_hand.HEIGHT / 2], circle])


def errors(model: str = "42", seed: int = 2) -> Array:
    """Return ordinary source errors (42,) of a model [mm, rad], in the mechanism's order."""
    chosen = np.isin([p.name for p in DELTA.parameters], DELTA.model(model))
    return np.where(chosen, DELTA.typical * np.random.default_rng(seed).standard_normal(42), 0.0)


def paper(p: Array) -> Array:
    """Return source errors [mm, rad] as the paper's unknowns, in its order."""
    out = np.empty(42)
    out[PAPER] = p * UNIT
    return out


def columns(model: str) -> list[int]:
    """Return the paper's columns of a model, in the mechanism's order."""
    return [int(PAPER[DELTA.index[name]]) for name in DELTA.model(model)]


def by_tools(work: str, *given: Any) -> dict[str, Contender]:
    """Return the tools that do a work, each made ready for what is given."""
    return {name: Contender(getattr(tool, work)(*given)) for name, tool in TOOLS.items() if hasattr(tool, work)}


def calibrated() -> Robot:
    """Return the machine with errors."""
    return dataclasses.replace(
        ROBOT, errors=dict(zip((p.name for p in DELTA.parameters), errors().tolist(), strict=True))
    )


def recorded(theta: Array, points: list[tuple[Array, Array]]) -> Recording:
    """Return the recording of positions (n, 3) read at each reference point, the offset of which is given."""
    n, many = len(theta), len(points)
    return Recording(
        path=Path("recording.csv"),
        kind="position",
        measurement=Measurement(kind="position", sigma_mm=SIGMA),
        joint_unit="rad",
        joints=np.tile(theta, (many, 1)),
        columns=("x_mm", "y_mm", "z_mm"),
        measured=np.vstack([at for _, at in points]),
        pose=np.tile(np.arange(n).astype(str), many),
        line=np.arange(n * many) + 2,
        channels={},
        setup=np.zeros(n * many, dtype=int),
        setup_names=("1",),
        tool=np.repeat([offset for offset, _ in points], n, axis=0),
    )


def measured(model: str, n: int = 19) -> tuple[Array, list[tuple[Array, Array]]]:
    """Return joints of the paper's poses and what a tracker reads on a machine with the errors of a model."""
    theta, p, rng = by_hand.ideal_inverse(rings(n)), paper(errors(model)), np.random.default_rng(3)
    points = [np.zeros(3)] if model == "18" else [np.zeros(3), POINT]
    read = [by_hand.forward(theta, by_hand.machine(p, at), at)[:, :3] for at in points]
    return theta, [(at, r + SIGMA * rng.standard_normal(r.shape)) for at, r in zip(points, read, strict=True)]


def reach(p: Array) -> Array:
    """Return where the machine with errors p (42,) goes over the workspace: what identifications must agree on."""
    return by_hand.forward(by_hand.ideal_inverse(positions(50, seed=4)), by_hand.machine(p))[:, :3]
