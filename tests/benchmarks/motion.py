"""Torques against the kinematics of the same machine: how much more a sample in motion costs than a pose at rest.

    python -m tests.benchmarks.motion [--samples N]

All in one run, one thread, position solved included: inverse dynamics over the exact forward position, the regressor
over the sensitivity. Times of a shared machine go up and down together, ratios do not.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable

import numpy as np

from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.dynamics import dynamics_of
from deltacal_gen.machine.registry import mechanism_of
from tests.machines_with_loops import REACH, machine, states

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


def main(arguments: list[str] | None = None) -> int:
    """Print the table; return 1 where the six-rod Delta needs more than it may."""
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
    return int(over)


if __name__ == "__main__":
    raise SystemExit(main())
