"""Kernels by `straight` against the same text by Numba's own njit, function by function, bit for bit up to rounding.

Run as a program, ``python -m tests.kernels.test_plain_jit NAME FILE.npz``, it writes what the kernels of a machine
compute.
"""

from __future__ import annotations

import csv
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from deltacal_gen.app.demonstration import example
from deltacal_gen.files.robot import read_robot
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.limbs import Limbs
from deltacal_gen.machine.registry import load_mechanism, mechanism_names, mechanism_of
from tests.support.drawn import example_of

ROOT = Path(__file__).resolve().parents[2]
QUICK = "simplified_parallelogram"  # the smallest machine: the others take a minute each
POSES = 11  # no multiple of the lanes that are written at once


@using(Backend.COMPILED)
def of_chain() -> dict[str, Any]:
    """Return what the kernels of a chain compute, at the joints of the example with errors."""
    robot = read_robot(example("serial/robot.toml"))
    m, rng = mechanism_of(robot), np.random.default_rng(3)
    rows = m.rows(robot, rng.standard_normal((POSES, len(m.parameters))) * m.typical)
    q, tool = rng.uniform(-1, 1, (POSES, m.limbs)), rng.standard_normal((POSES, 3))
    x, _ = m.forward(q, tool, rows)
    S, given = m.sensitivity(x, q, tool, rows), ({"proximal": 0.0}, np.array([0.0, 0.0, -9.81]), 1.5)
    loads = m.loads(x, q, tool, rows, *given)
    found = {"x": x, "S": S.parameters, "V": S.joints, "torque": loads.torque, "moment": loads.moment}
    return found | {"weights": m.weights_at(x, q, tool, rows, {}), "pulls": m.pulls(x, q, tool, rows, *given)}


def computed(name: str) -> dict[str, Any]:
    """Return what the kernels of a machine with errors compute at some of its example's poses."""
    mechanism = load_mechanism(name)
    if not isinstance(mechanism, Limbs):
        return of_chain()
    robot = read_robot(example_of(name) / "robot.toml")
    rng, sizes = np.random.default_rng(3), [p.typical for p in mechanism.parameters]
    rows = mechanism.rows(robot, rng.standard_normal(len(sizes)) * sizes)
    kernels, servo, tool = mechanism.compiled, mechanism.servo, rng.standard_normal((1, 3))
    limbs, n_x, k = mechanism.limbs, len(mechanism.platform), kernels.constants(rows)
    with (example_of(name) / "poses.csv").open() as file:
        poses = list(csv.DictReader(file))
    by_joints = "q1_deg" in poses[0]
    names = [f"q{i + 1}_deg" for i in range(limbs)] if by_joints else [f"{a}_mm" for a in mechanism.axes[:limbs]]
    every = np.array(sorted({tuple(float(row[name]) for name in names) for row in poses}))
    target = every[:: max(1, len(every) // POSES)][:POSES].copy()
    n = len(target)
    x, q, status = np.empty((n, n_x)), np.empty((n, limbs)), np.empty(n, dtype=np.int64)
    if by_joints:
        kernels.forward(np.deg2rad(target), tool, k, x, status, False)
        target = x[:, :limbs].copy()
    kernels.inverse(target, tool, k, x, q, status)
    found: dict[str, Any] = {"k": k, "x": x.copy(), "q": q.copy(), "inverse": status.copy()}
    kernels.forward(q, tool, k, x, status, False)
    found |= {"x again": x.copy(), "forward": status.copy()}
    width = rows.shape[2] - len(mechanism.geometry)
    found["S"], found["V"] = np.empty((n, n_x, limbs * width)), np.empty((n, n_x, limbs))
    kernels.sensitivity(x, q, tool, k, found["S"], found["V"], status)
    if hasattr(kernels, "simplified_forward"):  # not where a command turns the platform
        found["simple"] = np.empty((n, kernels.SIMPLIFIED))
        kernels.simplified_forward(q, tool, k, found["simple"], status)
    if hasattr(kernels, "nominal_sensitivity"):
        n_e, positions = len(mechanism.errors) + len(mechanism.common), n_x - len(mechanism.turns)
        nominal = kernels.nominal_constants(rows)
        found["N"] = np.empty((n, positions, limbs * n_e))
        kernels.nominal_sensitivity(target, q, tool, nominal, found["N"])
        columns = np.arange(limbs * n_e)
        found["H"] = np.empty((n * (n - 1) // 2, len(columns)))
        kernels.distance_rows(target, q, tool, nominal, columns, found["H"])
    sign = np.ones(limbs)
    exact, linear = servo.exact_state(rows[0], tool[0], sign), servo.linear_state(rows[0], tool[0], sign)
    found["exact"] = np.array([servo.exact_command(*at, exact) for at in target])
    found["linear"] = np.array([servo.linear_command(*at, linear) for at in target])
    return found


@pytest.mark.walk
@pytest.mark.parametrize(
    "name",
    [pytest.param(name, marks=() if name == QUICK else pytest.mark.thorough) for name in mechanism_names()],
)
def test_kernels_are_the_same_by_numba_alone(name: str, tmp_path: Path) -> None:
    results = []
    for plain in ("", "1"):
        out = tmp_path / f"{name}{plain}.npz"
        environment = {**os.environ, "DELTACAL_PLAIN_JIT": plain}
        if plain:  # beside the kernels it would take the place of the code that all others use
            environment["NUMBA_CACHE_DIR"] = str(tmp_path / "cache")
            environment["NUMBA_OPT"] = "0"  # what Numba means is compared; how LLVM makes it quick takes a third more
        command = [sys.executable, "-m", "tests.kernels.test_plain_jit", name, str(out)]
        subprocess.run(command, cwd=ROOT, env=environment, check=True)
        with np.load(out) as file:
            results.append(dict(file))
    own, numba = results
    assert sorted(own) == sorted(numba)
    assert "inverse" not in own or (own["inverse"] == 0).all()
    assert own["compiled by"] == "straight"
    assert numba["compiled by"] == "numba"
    for what in set(own) - {"compiled by"}:
        size = np.abs(np.nan_to_num(own[what])).max(initial=1.0)
        np.testing.assert_allclose(numba[what], own[what], rtol=1e-11, atol=1e-12 * size, err_msg=what)


if __name__ == "__main__":
    from deltacal_kernels.straight import PLAIN

    np.savez(sys.argv[2], **computed(sys.argv[1]), **{"compiled by": np.array("numba" if PLAIN else "straight")})
