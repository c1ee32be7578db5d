"""Tables 2 and 5 and figure 8 of Bai 2015 on a simulated prototype: ``python -m tests.benchmarks.bai2015 [PICTURE]``.

The machine has the errors of Table 4 and the encoder offsets of section 5.1; the tracker has 0.005 mm of noise. Rough
calibration uses home and five poses of the middle layer; fine calibration home and n poses on the top and bottom
layers: n = 7 and one reference point for model 18, n = 9 and two points for model 32; all from distances of all pairs.
"""

from __future__ import annotations

import dataclasses
import sys
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table

from deltacal_gen.app.demonstration import example
from deltacal_gen.estimation.estimation import fit, pose_problem
from deltacal_gen.estimation.solvers import LeastSquares
from deltacal_gen.files.recording import Measurement, Recording
from deltacal_gen.files.robot import Robot, read_robot
from deltacal_gen.identification.accuracy import (
    check_poses,
    circle,
    distance_error,
    largest,
    volumetric_error,
    workspace_of,
)
from deltacal_gen.machine.registry import Array, load_mechanism
from deltacal_gen.physics.simulation import read_truth, simulate
from deltacal_gen.use.compensation import Compensator

SIGMA = 0.005  # mm, per coordinate; each pose is read three times and averaged
DELTA = load_mechanism("delta")


def measured(
    robot: Robot, truth: dict[str, float], targets: Array, tools: Array, rng: np.random.Generator
) -> Recording:
    """Return what the tracker reads of every target with every reference point."""
    at, tool = np.tile(targets, (len(tools), 1)), np.repeat(tools, len(targets), axis=0)
    n = len(at)
    joints, _, _ = DELTA.inverse(at, robot.tool, DELTA.rows(robot))
    poses = Recording(
        path=Path("bai2015.csv"),
        kind="position",
        measurement=Measurement(frame="unknown"),
        joint_unit="rad",
        joints=joints,
        columns=("x_mm", "y_mm", "z_mm"),
        measured=np.full((n, 3), np.nan),
        pose=np.arange(n).astype(str),
        line=np.arange(n) + 2,
        channels={},
        setup=np.zeros(n, dtype=int),
        setup_names=("1",),
        tool=tool,
    )
    return simulate(robot, poses, truth, noise_mm=SIGMA / np.sqrt(3), rng=rng)


def identified(robot: Robot, recording: Recording, model: str) -> Robot:
    """Return the robot with a model's parameters identified from the distances of all pairs."""
    problem = pose_problem(robot, recording, DELTA.model(model), as_distance=True)
    errors = fit(problem, LeastSquares(), weigh_repeats=False, robust=False).errors
    return dataclasses.replace(robot, errors=dict(zip(DELTA.index, errors.tolist(), strict=True)))


def errors_of(command: Robot, kind: str, truth: dict[str, float], targets: Array) -> tuple[Array, Array]:
    """Return distance and volumetric error relative to the first target; the frame is the robot's own, known here."""
    true = dataclasses.replace(command, errors=truth)
    joints = Compensator(command, kind).joints(targets)
    reached = DELTA.forward(joints, command.tool, DELTA.rows(true))[0][:, :3]
    return distance_error(reached, targets), volumetric_error(reached, targets, turn=np.eye(3))


def main() -> None:
    """Simulate, identify, print the tables, draw the figure."""
    screen, rng = Console(), np.random.default_rng(2015)
    nominal = read_robot(example() / "robot.toml")
    truth = read_truth(example() / "truth.toml", nominal).errors
    space = workspace_of(nominal)
    home, points = check_poses(space)[:1], np.array([[0.0, 0.0, 0.0], [0.0, 0.0, -100.0]])
    middle = np.vstack([home, circle(space, 0.5, 1.0, 5)])

    def rings(n: int) -> Array:
        return np.vstack([home, circle(space, 0.0, 1.0, n), circle(space, 1.0, 1.0, n)])

    rough = identified(nominal, measured(nominal, truth, middle, points[:1], rng), "3")
    offsets = np.degrees([rough.errors[f"theta_{i}"] for i in (1, 2, 3)])
    fine = {
        "18": identified(rough, measured(nominal, truth, rings(7), points[:1], rng), "18"),
        "32": identified(rough, measured(nominal, truth, rings(9), points, rng), "32"),
    }

    table = Table("", *(f"P{k}" for k in range(1, 6)), title="Table 2: errors relative to P0, mm")
    for name, machine in (("before", nominal), ("after", rough)):
        rho, v = errors_of(machine, "exact", truth, middle)
        table.add_row(f"{name}, distance", *(f"{e:.3f}" for e in rho[1:]))
        table.add_row(f"{name}, volumetric", *(f"{e:.3f}" for e in v[1:]))
    screen.print(f"encoder offsets found: {', '.join(f'{v:.3f}' for v in offsets)} deg")
    screen.print(table)

    check = check_poses(space)
    table = Table("machine commanded by", "compensator", "distance", "volumetric", title="Table 5: largest errors, mm")
    cases = [("A nominal", nominal, "exact"), ("B encoder offsets", rough, "exact")]
    cases += [(f"C{m} model {m}", fine[m], kind) for m in ("18", "32") for kind in ("linear", "exact")]
    for name, machine, kind in cases:
        rho, v = errors_of(machine, kind, truth, check)
        table.add_row(name, kind, f"{largest(rho):.3f}", f"{largest(v):.3f}")
    screen.print(table)
    if len(sys.argv) > 1:
        _figure(Path(sys.argv[1]), rough, fine, truth, np.vstack([home, circle(space, 0.5, 1.0, 72)]))


def _figure(path: Path, rough: Robot, fine: dict[str, Robot], truth: dict[str, float], targets: Array) -> None:
    """Draw figure 8: errors on the rim of the middle layer against the swing angle."""
    from deltacal_gen.pages import figures

    with figures.mpl.rc_context(figures.STYLE):
        picture, axes = figures.plt.subplots(1, 2, figsize=(10, 3.6), constrained_layout=True)
        machines = (("before fine calibration", rough, "exact"), ("model 18", fine["18"], "linear"))
        for name, machine, kind in (*machines, ("model 32", fine["32"], "linear")):
            found = errors_of(machine, kind, truth, targets)
            for a, errors in zip(axes, found, strict=True):
                a.plot(np.arange(0, 360, 5), errors[1:], label=name)
        for a, what in zip(axes, ("distance", "volumetric"), strict=True):
            a.set(xlabel="swing angle, deg", ylabel=f"{what} error, mm")
        axes[0].legend(frameon=False)
        figures.save(picture, path)


if __name__ == "__main__":
    main()
