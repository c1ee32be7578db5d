"""Torques against the kinematics of the same machine: how much more a sample in motion costs than a pose at rest.

    python -m tests.benchmarks.motion [--samples N] [--rows N]

All in one run, one thread, position solved included: inverse dynamics over the exact forward position, the regressor
over the sensitivity; a six-joint arm beside CasADi's C for that very arm, its numbers in the code, and Pinocchio's
calls, where these are installed. Times of a shared machine go up and down together, ratios do not.

At last that arm, with friction in every joint, is recorded at 500 Hz and diagnosed by the command, in a process of its
own: seconds of CPU, and the largest resident memory (``--rows 0`` leaves it out).
"""

from __future__ import annotations

import argparse
import importlib.util
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np

import deltacal_gen as dc
from deltacal_gen.files.robot import robot_from_dict, robot_to_toml
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.dynamics import dynamics_of
from deltacal_gen.machine.registry import mechanism_of
from tests.support.every_effect import ARM
from tests.support.machines_with_loops import NAMES, machine, states

Array = np.ndarray

ROUNDS = 25
MOST_TORQUE, MOST_REGRESSOR = 3.5, 2.5  # of the six-rod Delta
RATE, ROWS_A_RUN = 500.0, 10_000  # of the recording that is diagnosed: samples per second, and of a run
MOST_SECONDS, MOST_MIB = 30.0, 1024.0  # of CPU, and of memory: diagnosing six joints, 60 000 samples
WAVES = 2 * np.pi * np.array([0.1, 0.23, 0.41, 0.6])  # rad/s, of every joint
TRUTH = """
[[effects]]
name = "coulomb_friction"
limbs = [1, 2, 3, 4, 5, 6]
coulomb = 4.0

[[effects]]
name = "viscous_friction"
limbs = [1, 2, 3, 4, 5, 6]
viscous = 0.1

[[effects]]
name = "stribeck_friction"
limbs = [2]
stribeck = 3.0
velocity = 6.0

[[effects]]
name = "load_friction"
limbs = [3]
load = 0.08

[[effects]]
name = "torque_ripple"
limbs = [4]
order = 20.0
cos = 0.5
sin = 0.3
"""


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


def bodied() -> Any:
    """Return a six-joint arm whose file states all bodies."""
    links = [link | {"inertia": [1e4 * link["mass"]] * 3 + [0.0] * 3} for link in ARM]
    return robot_from_dict({"robot": {"name": "arm", "mechanism": "serial"}, "joint": links})


def diagnosing(rows: int) -> tuple[float, float]:
    """Return seconds of CPU and largest resident memory [MiB] of diagnosing the arm's recording of so many samples.

    Its bodies are all to be found, as of a machine of which nobody knows them.
    """
    rng, robot = np.random.default_rng(0), bodied()
    lines = ["run,time_s," + ",".join(f"q{j}_deg" for j in range(1, len(ARM) + 1))]
    for first in range(0, rows, ROWS_A_RUN):
        t = np.arange(min(ROWS_A_RUN, rows - first)) / RATE
        sizes = rng.uniform(0.2, 0.5, (len(WAVES), len(ARM))) / (1 + WAVES[:, None])
        phases = rng.uniform(0, 6, (len(WAVES), len(ARM)))
        q = np.degrees(np.einsum("wj,nwj->nj", sizes, np.sin(t[:, None, None] * WAVES[:, None] + phases)))
        q += 0.001 * rng.standard_normal(q.shape)
        run = first // ROWS_A_RUN + 1
        lines += [f"{run},{when:.6f}," + ",".join(f"{v:.6f}" for v in row) for when, row in zip(t, q, strict=True)]
    with tempfile.TemporaryDirectory(prefix="deltacal-motion-") as place:
        folder = Path(place)
        (folder / "moved.csv").write_text("\n".join(lines) + "\n")
        (folder / "moved.toml").write_text('[measurement]\nkind = "torque"\n')
        (folder / "truth.toml").write_text(TRUTH)
        dc.simulate(
            robot, folder / "moved.csv", output=folder / "recording.csv", truth=folder / "truth.toml", noise=0.1
        )
        bare = [{k: v for k, v in link.items() if k not in ("mass", "com", "inertia")} for link in ARM]
        open_ = robot_from_dict({"robot": {"name": "arm", "mechanism": "serial"}, "joint": bare})
        (folder / "robot.toml").write_text(robot_to_toml(open_))
        process = subprocess.Popen(
            [sys.executable, "-m", "deltacal_gen.app.cli", "diagnose", "robot.toml", "recording.csv", "-o", "d.json"],
            cwd=folder,
            stdout=subprocess.DEVNULL,
        )
        _, status, used = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)  # it has ended, which Popen did not see
    if status:
        raise SystemExit("the diagnosis failed")
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


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
    own = dynamics_of(bodied())
    inertia, motion = own.stated(), np.random.default_rng(0).standard_normal((3, samples, len(ARM)))
    calls: dict[str, Callable[[], object]] = {"own": lambda: own.torque(motion, inertia)}
    if installed("casadi"):
        from tests.benchmarks import in_casadi

        calls[in_casadi.NAME] = in_casadi.torque(ARM, inertia.reshape(-1, 10), own.gravity, motion)
    if installed("pinocchio"):
        calls["Pinocchio"] = in_pinocchio(ARM, inertia.reshape(-1, 10), own.gravity, motion)
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
    """Print the table; return 1 where the six-rod Delta, the arm or its diagnosis needs more than it may."""
    parser = argparse.ArgumentParser(prog="python -m tests.benchmarks.motion", description=__doc__.split("\n")[0])
    parser.add_argument("--samples", type=int, default=4000)
    parser.add_argument("--rows", type=int, default=60_000, help="of the recording that is diagnosed; 0 leaves it out")
    given = parser.parse_args(arguments)
    over = False
    print(f"{'ns a sample':16s} forward  sensitivity  torque  regressor  torque/forward  regressor/sensitivity")
    for name in NAMES:
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
    over |= spent["own"] > spent.get("CasADi C", np.inf)
    if given.rows:
        seconds, memory = diagnosing(given.rows)
        print(f"diagnosing six joints, {given.rows} samples: {seconds:.1f} s of CPU, {memory:.0f} MiB")
        over |= seconds > MOST_SECONDS or memory > MOST_MIB
    return int(over)


if __name__ == "__main__":
    raise SystemExit(main())
