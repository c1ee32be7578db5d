"""Torques against the kinematics of the same machine: how much more a sample in motion costs than a pose at rest.

    python -m tests.benchmarks.motion [--samples N]

All in one run, one thread, position solved included: inverse dynamics over the exact forward position, the regressor
over the sensitivity; a six-joint arm beside CasADi's C for that very arm, its numbers in the code, and Pinocchio's
calls, where these are installed. Times of a shared machine go up and down together, ratios do not.
"""

from __future__ import annotations

import argparse
import importlib.util
import time
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from deltacal_gen.files.robot import robot_from_dict
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.dynamics import dynamics_of
from deltacal_gen.machine.registry import mechanism_of
from tests.every_effect import ARM
from tests.machines_with_loops import REACH, machine, states

Array = np.ndarray

ROUNDS = 25
MOST_TORQUE, MOST_REGRESSOR = 3.5, 2.5  # of the six-rod Delta


def least(calls: dict[str, Callable[[], object]], samples: int) -> dict[str, float]:
    """Return the least time of each call [ns a sample], one after the other round by round."""
    spent = dict.fromkeys(calls, np.inf)
    for _ in range(ROUNDS):
        for name, call in calls.items():
            start = time.perf_counter()
            call()
            spent[name] = min(spent[name], (time.perf_counter() - start) / samples * 1e9)
    return spent


def ratios(name: str, samples: int) -> tuple[dict[str, float], float, float]:
    """Return the times of a mechanism's calls [ns a sample], and the two ratios."""
    robot = machine(name)
    mechanism, own = mechanism_of(robot), dynamics_of(robot)
    motion, rows, tool = states(robot, samples), mechanism.rows(robot), np.array(robot.tool)
    inertia = own.stated()
    x, _ = mechanism.forward(motion[0], tool, rows)
    width = mechanism.limbs * (len(mechanism.errors) + len(mechanism.common) + len(mechanism.deflections))
    out = np.empty((samples, mechanism.n_x, width)), np.empty((samples, mechanism.n_x, mechanism.limbs))
    spent = least(
        {
            "forward": lambda: mechanism.forward(motion[0], tool, rows),
            "sensitivity": lambda: mechanism.sensitivity(x, motion[0], tool, rows, out=out),
            "torque": lambda: own.torque(motion, inertia),
            "regressor": lambda: own.regressor(motion),
        },
        samples,
    )
    return spent, spent["torque"] / spent["forward"], spent["regressor"] / spent["sensitivity"]


def installed(name: str) -> bool:
    """Tell whether a package is there."""
    return importlib.util.find_spec(name) is not None


def arm(samples: int) -> dict[str, float]:
    """Return the times of the torques of a six-joint arm [ns a sample], by the tool and others that are installed.

    Raises
    ------
    AssertionError
        They do not agree.
    """
    links = [link | {"inertia": [1e4 * link["mass"]] * 3 + [0.0] * 3} for link in ARM]
    robot = robot_from_dict({"robot": {"name": "arm", "mechanism": "serial"}, "joint": links})
    own = dynamics_of(robot)
    inertia, motion = own.stated(), np.random.default_rng(0).standard_normal((3, samples, len(links)))
    calls: dict[str, Callable[[], object]] = {"own": lambda: own.torque(motion, inertia)}
    if installed("casadi"):
        from tests.benchmarks import in_casadi

        calls[in_casadi.NAME] = in_casadi.torque(links, inertia.reshape(-1, 10), own.gravity, motion)
    if installed("pinocchio"):
        calls["Pinocchio"] = in_pinocchio(links, inertia.reshape(-1, 10), own.gravity, motion)
    answers = {name: np.array(call()) for name, call in calls.items()}
    for name, torque in answers.items():
        assert np.abs(torque - answers["own"]).max() < 1e-9 * np.abs(answers["own"]).max(), f"{name} says otherwise"
    return least(calls, samples)


def in_pinocchio(links: Sequence[dict[str, Any]], inertia: Array, gravity: Array, motion: Array) -> Callable[[], Array]:
    """Return what computes the torques (N, n) [N mm] call by call, as its Python interface has it."""
    import pinocchio as pin

    model, after = pin.Model(), pin.SE3.Identity()
    model.gravity.linear = np.array(gravity)
    for i, (link, body) in enumerate(zip(links, inertia, strict=True)):
        joint = model.addJoint(i, pin.JointModelRZ(), after, f"joint {i + 1}")
        tilt = np.radians(link.get("alpha", 0.0))
        step = np.array([link.get("a", 0.0), 0.0, link.get("d", 0.0)]) / 1000
        after = pin.SE3(pin.utils.rotate("x", tilt), step)
        m, h, (xx, yy, zz, xy, xz, yz) = body[0], body[1:4] / 1000, body[4:] / 1e6
        c = h / m
        about = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) - m * (c @ c * np.eye(3) - np.outer(c, c))
        model.appendBodyToJoint(joint, pin.Inertia(m, c, about), after)
    data = model.createData()
    return lambda: 1000 * np.array([pin.rnea(model, data, *state) for state in motion.transpose(1, 0, 2)])


def main(arguments: list[str] | None = None) -> int:
    """Print the table; return 1 where the six-rod Delta or the arm needs more than it may."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.motion", description=__doc__.split("\n")[0])
    parser.add_argument("--samples", type=int, default=4000)
    given = parser.parse_args(arguments)
    over = False
    print(f"{'ns a sample':16s} forward  sensitivity  torque  regressor  torque/forward  regressor/sensitivity")
    for name in REACH:
        with using(Backend.COMPILED):
            spent, torque, regressor = ratios(name, given.samples)
        times = [spent[call] for call in ("forward", "sensitivity", "torque", "regressor")]
        print("{:16s} {:7.0f}  {:11.0f}  {:6.0f}  {:9.0f}  {:14.2f}  {:21.2f}".format(name, *times, torque, regressor))
        over |= name == "delta" and (torque > MOST_TORQUE or regressor > MOST_REGRESSOR)
    with using(Backend.COMPILED):
        spent = arm(given.samples)
    print("arm of six joints, ns a sample: " + ", ".join(f"{name} {value:.0f}" for name, value in spent.items()))
    for name in ("casadi", "pinocchio"):
        if not installed(name):
            print(f"{name} is not installed: not compared (pip install casadi pin)")
    return int(over or spent["own"] > spent.get("CasADi C", np.inf))


if __name__ == "__main__":
    raise SystemExit(main())
