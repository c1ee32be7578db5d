"""The project's machines in the place of the independent ones: does any verdict on a claim change?

The tests of the claims ask twins written from the papers alone. `install` puts the project's own kernels where those
have positions, joints and error transfer; what the paper prints beside them stays. Both must bear out every claim.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from functools import cache
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from deltacal_gen.app.demonstration import example
from deltacal_gen.files.robot import Robot, for_model, read_robot
from deltacal_gen.machine.registry import Machine, load_mechanism
from tests.claims import independent_bai as bai
from tests.claims import independent_mei as mei
from tests.claims import independent_savoure as savoure
from tests.claims import independent_traslosheros as traslosheros

Array = np.ndarray
LIMBS_OF = (1, 2, 0)  # the limbs of Savoure, from 60 deg on, in the order of the robot file, from -90 deg on


@cache
def drawn(mechanism: str) -> tuple[Machine, Robot]:
    """Return a mechanism and the machine of its example, which is the paper's."""
    machine = load_mechanism(mechanism)
    return machine, read_robot(example(machine.machine) / "robot.toml")


def rows_of(machine: Machine, robot: Robot, errors: dict[str, Array], count: int) -> Array:
    """Return what the kernels read of `count` machines, whose errors (count, limbs) are given by their names."""
    rows = np.repeat(np.array(machine.rows(robot)), count, axis=0)
    for name, values in errors.items():
        rows[:, :, machine.column(name)] += values
    return rows


# ------------------------------------------------------------------------------------------------------------------ Mei


def _diamond(robot: Any, lead: tuple[int, ...]) -> Array:
    machine, paper = drawn("diamond")
    errors = {"theta": robot.zero, "L": robot.proximal, "l": robot.distal}
    errors |= {name: robot.base[..., k] for k, name in enumerate(("ex", "ey"))}
    flat = {name: np.broadcast_to(v, (*lead, 2)).reshape(-1, 2) for name, v in errors.items()}
    return rows_of(machine, paper, flat, int(np.prod(lead, dtype=int)))


def _leading(p: Array, robot: Any) -> tuple[int, ...]:
    return np.broadcast_shapes(np.shape(p)[:-1], robot.zero.shape[:-1], robot.base.shape[:-2], robot.distal.shape[:-1])


def mei_forward(theta: Array, robot: Any = mei.NOMINAL) -> Array:
    lead = _leading(theta, robot)
    q = np.broadcast_to(theta, (*lead, 2)).reshape(-1, 2)
    x, _ = drawn("diamond")[0].forward(q, np.zeros((len(q), 3)), _diamond(robot, lead))
    return x[:, :2].reshape(*lead, 2)


def mei_inverse(p: Array, robot: Any = mei.NOMINAL) -> Array:
    lead = _leading(p, robot)
    targets = np.zeros((int(np.prod(lead, dtype=int)), 3))
    targets[:, :2] = np.broadcast_to(p, (*lead, 2)).reshape(-1, 2)
    q, _, _ = drawn("diamond")[0].inverse(targets, np.zeros((len(targets), 3)), _diamond(robot, lead))
    return np.mod(q.reshape(*lead, 2) + np.pi / 2, 2 * np.pi) - np.pi / 2


def mei_transfer(p: Array, complete: bool = False) -> Array:
    machine, paper = drawn("diamond")
    flat, rows = np.reshape(p, (-1, 2)), machine.rows(paper)
    targets, none = np.column_stack([flat, np.zeros(len(flat))]), np.zeros((len(flat), 3))
    q, x, _ = machine.inverse(targets, none, rows)
    scale = machine.scaling("paper", paper, [e.name for e in machine.parameters[:10]])
    S = machine.sensitivity(x, q, none, rows).parameters[:, :2, :10] / scale
    return (S if complete else S[..., [0, 5]]).reshape(*np.shape(p)[:-1], 2, -1)


# ------------------------------------------------------------------------------------------------------------------ Bai


def bai_joints(r: Array) -> Array:
    machine, paper = drawn("delta")
    flat = np.reshape(r, (-1, 3))
    q, _, _ = machine.inverse(flat, np.zeros_like(flat), machine.rows(paper))
    return q.reshape(np.shape(r))


def bai_forward(theta: Array) -> Array:
    machine, paper = drawn("delta")
    flat = np.reshape(theta, (-1, 3))
    return machine.forward(flat, np.zeros_like(flat), machine.rows(paper))[0][:, :3].reshape(np.shape(theta))


def bai_sensitivity(r: Array, point: Array | None = None) -> tuple[Array, Array]:
    machine, paper = drawn("delta")
    flat, rows = np.reshape(r, (-1, 3)), machine.rows(paper)
    tool = np.tile(np.zeros(3) if point is None else point, (len(flat), 1))
    q, x, _ = machine.inverse(flat + tool, tool, rows)
    S = machine.sensitivity(x, q, tool, rows).parameters
    in_mm = machine.scaling("paper", paper, bai.MODEL_42)
    S = S[:, :, [machine.index[name] for name in bai.MODEL_42]] / in_mm
    lead = np.shape(r)[:-1]
    return S[:, :3].reshape(*lead, 3, 42), S[:, 3:, 24:].reshape(*lead, 3, 18)


# -------------------------------------------------------------------------------------------------------------- Savoure


@cache
def _complete() -> tuple[Machine, Robot, tuple[str, ...]]:
    """Return the complete Delta, and the names of its errors in the paper's order."""
    robot = for_model(drawn("delta")[1], "delta/51")
    names = []
    for name in savoure.NAMES:
        stem, _, place = name.partition("_")
        names.append(f"{stem}_{LIMBS_OF.index(int(place[0]) - 1) + 1}{place[1:]}")
    return load_mechanism("complete_delta"), robot, tuple(names)


def _delta51(own: Any, errors: Array | None) -> tuple[Machine, Array, Array]:
    machine, robot, names = _complete()
    lengths = {"base": "base_radius", "platform": "platform_radius", "arm": "proximal_length", "rod": "distal_length"}
    lengths |= {"spacing": "joint_spacing"}
    sizes = {there: np.array([getattr(own, here)]) for here, there in lengths.items()}
    robot = dataclasses.replace(robot, geometry=robot.geometry | sizes)
    given = {} if errors is None else dict(zip(names, errors, strict=True))
    return machine, machine.rows(robot, machine.vector(given)), np.array([own.tool])


def savoure_inverse(own: Any, position: Array, errors: Array | None = None) -> Array:
    machine, rows, tool = _delta51(own, errors)
    q, _, _ = machine.inverse(np.array([position]), tool, rows)
    return q[0][np.argsort(LIMBS_OF)]


def savoure_forward(own: Any, q: Array, errors: Array, near: Array) -> Array:
    machine, rows, tool = _delta51(own, errors)
    x, _ = machine.forward(np.array([q])[:, LIMBS_OF], tool, rows)
    return np.concatenate([x[0, :3], Rotation.from_matrix(x[0, 3:].reshape(3, 3)).as_rotvec()])


def savoure_sensitivity(own: Any, position: Array, q: Array) -> Array:
    machine, rows, tool = _delta51(own, None)
    joints = np.array([q])[:, LIMBS_OF]
    x, _ = machine.forward(joints, tool, rows)
    S = machine.sensitivity(x, joints, tool, rows).parameters[0]
    return S[:, [machine.index[name] for name in _complete()[2]]]


def _parallelogram(k: Array, h: float) -> tuple[Machine, Array]:
    machine, robot = drawn("planar_parallelogram")
    robot = dataclasses.replace(robot, geometry=robot.geometry | {"h": np.array([h])})
    return machine, machine.rows(robot, np.asarray(k) - savoure.NOMINAL)


def planar_closed_form(q: float | Array, k: Array, h: float) -> Array:
    machine, rows = _parallelogram(k, h)
    flat = np.reshape(q, (-1, 1))
    x, _ = machine.forward(flat, np.zeros((len(flat), 3)), rows)
    pose = np.column_stack([x[:, :2], np.arctan2(x[:, 6], x[:, 3])])
    return pose.reshape(*np.shape(q), 3)


def planar_pose(q: float, k: Array, h: float, start: float = 0.0) -> Array:
    return planar_closed_form(q, k, h)


def planar_sensitivity(q: float, h: float, *, printed: bool = False) -> Array:
    if printed:
        return PRINTED["planar_sensitivity"](q, h, printed=True)
    machine, rows = _parallelogram(savoure.NOMINAL, h)
    joints, none = np.array([[q]]), np.zeros((1, 3))
    x, _ = machine.forward(joints, none, rows)
    return machine.sensitivity(x, joints, none, rows).parameters[0][[0, 1, 5]]


PRINTED: dict[str, Callable[..., Array]] = {"planar_sensitivity": savoure.planar_sensitivity}


# --------------------------------------------------------------------------------------------------------- Traslosheros


def _robotennis(own: Any) -> tuple[Machine, Array]:
    machine, robot = drawn("robotennis")
    nominal = traslosheros.NOMINAL
    errors = {name: getattr(own, name) - getattr(nominal, name) for name in ("a", "b", "h", "theta0", "phi", "H")}
    given = {f"{name}_{i + 1}": float(v) for name, values in errors.items() for i, v in enumerate(values)}
    home = dict(zip(("px0", "py0", "pz0"), own.p0 - nominal.p0, strict=True))
    return machine, machine.rows(robot, machine.vector(given | home))


def robotennis_inverse(own: Any, P: Array) -> Array:
    machine, rows = _robotennis(own)
    counted = np.atleast_2d(P) - own.p0 + traslosheros.NOMINAL.p0
    return machine.inverse(counted, np.zeros_like(counted), rows)[0] + own.theta0


def robotennis_forward(own: Any, theta: Array) -> Array:
    machine, rows = _robotennis(own)
    joints = np.atleast_2d(theta) - own.theta0
    return machine.forward(joints, np.zeros_like(joints), rows)[0][:, :3] - traslosheros.NOMINAL.p0 + own.p0


def _derivatives(own: Any, theta: Array, P: Array) -> tuple[Machine, Any]:
    machine, rows = _robotennis(own)
    joints, shift = np.atleast_2d(theta) - own.theta0, np.atleast_2d(P) - own.p0
    x = np.column_stack([shift + traslosheros.NOMINAL.p0, np.tile(np.eye(3).ravel(), (len(shift), 1))])
    return machine, machine.sensitivity(x, joints, np.zeros_like(shift), rows)


def robotennis_jacobian(own: Any, theta: Array, P: Array) -> Array:
    return np.asarray(_derivatives(own, theta, P)[1].joints[:, :3])


def robotennis_observation(own: Any, joints: Array, shift: Array, *, extra: bool = False) -> Array:
    """The closure's derivatives from the position's: ``dGamma/dU = -dGamma/dP dP/dU``."""
    theta, P = own.theta0 + joints, own.p0 + shift
    machine, found = _derivatives(own, theta, P)
    names = [*machine.model("robotennis/15"), *(f"{e}_{i}" for e in ("phi", "H") for i in (1, 2, 3))]
    names = names if extra else names[:15]
    S = found.parameters[:, :3, [machine.index[n] for n in names]]
    J = -2 * np.einsum("nlk,nkp->lnp", traslosheros.rods(own, theta, P), S)
    return np.asarray(J.reshape(3 * len(joints), len(names)))


# ------------------------------------------------------------------------------------------------------------- in place

SWAPS: tuple[tuple[Any, dict[str, Callable[..., Any]]], ...] = (
    (mei, {"forward": mei_forward, "inverse": mei_inverse, "transfer": mei_transfer}),
    (bai, {"joints": bai_joints, "forward": bai_forward, "sensitivity": bai_sensitivity}),
    (savoure.Delta, {"forward": savoure_forward, "inverse": savoure_inverse, "sensitivity": savoure_sensitivity}),
    (
        savoure,
        {
            "planar_pose": planar_pose,
            "planar_closed_form": planar_closed_form,
            "planar_sensitivity": planar_sensitivity,
        },
    ),
    (
        traslosheros,
        {
            "forward": robotennis_forward,
            "inverse": robotennis_inverse,
            "jacobian": robotennis_jacobian,
            "observation": robotennis_observation,
        },
    ),
)


def install() -> None:
    """Put the project's machines in the place of the independent ones, before a test imports these."""
    for where, own in SWAPS:
        for name, function in own.items():
            setattr(where, name, function)
