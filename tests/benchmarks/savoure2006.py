"""The study of Savoure 2006, section III.B: ``python -m tests.benchmarks.savoure2006 [PICTURE]``.

A planar parallelogram with the errors of Table 2 is read at 19 joint angles (position 0.003 mm, orientation 0.003 deg
of noise) and calibrated in four ways; what is shown is the error of the tool point along x over -45 to 45 deg.

1. none;
2. classical: the simplified model of eq. (38) by least squares of x, the simplified inverse position (35);
3. improved: the complete model to first order, its six base parameters, compensation by eqs. (29)-(33);
4. exact: ``identify`` and the exact compensator.
"""

from __future__ import annotations

import dataclasses
import sys
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table

from deltacal_gen.app.demonstration import example
from deltacal_gen.files.recording import Recording, read_recording
from deltacal_gen.files.robot import Robot, for_model, read_robot
from deltacal_gen.identification.identifiability import base_parameters
from deltacal_gen.identification.identification import identify
from deltacal_gen.machine.registry import Array, load_mechanism
from deltacal_gen.physics.simulation import read_truth, simulate
from deltacal_gen.units import DEG
from deltacal_gen.use.compensation import Compensator

TOOLS = (0.0, 100.0, 200.0)  # h [mm]
SIGMA_MM, SIGMA_RAD = 0.003, 0.003 * DEG
CHECK = np.arange(-45.0, 46.0) * DEG
WAYS = ("none", "classical", "improved", "exact")
SOURCE = example("planar_parallelogram")


def machine(h: float) -> tuple[Robot, dict[str, float]]:
    """Return the nominal machine with a tool of length h, and the errors of Table 2."""
    robot = read_robot(SOURCE / "robot.toml")
    robot = dataclasses.replace(robot, geometry=robot.geometry | {"h": np.array([h])})
    return robot, read_truth(SOURCE / "truth.toml", robot).errors


def measured(robot: Robot, truth: dict[str, float], rng: np.random.Generator | None) -> Recording:
    """Return the 19 readings, without noise where no generator is given."""
    poses = read_recording(SOURCE / "poses.csv", load_mechanism(robot.mechanism), need_measured=False)
    noise = (0.0, 0.0) if rng is None else (SIGMA_MM, SIGMA_RAD)
    return simulate(robot, poses, truth, noise_mm=noise[0], noise_rad=noise[1], rng=rng)


def first_order(robot: Robot, recording: Recording, *, components: tuple[int, ...]) -> dict[str, float]:
    """Return the base parameters of the robot's mechanism by one linear least squares at nominal geometry, eq. (26).

    `components` are those of the pose's error that count: x, y, and the turn about z.
    """
    mechanism = load_mechanism(robot.mechanism)
    rows, q = mechanism.rows(robot), recording.joints
    x, _ = mechanism.forward(q, robot.tool, rows)
    S = mechanism.sensitivity(x, q, robot.tool, rows).parameters[:, [0, 1, 5]]
    turned = recording.measured[:, 2] - np.arctan2(x[:, 6], x[:, 3])
    dX = np.column_stack([recording.measured[:, :2] - x[:, :2], turned])
    S_G, dX_G = S[:, components].reshape(-1, S.shape[2]), dX[:, components].ravel()
    kept, _ = base_parameters(S_G, [p.name for p in mechanism.parameters], mechanism.typical)
    columns = [mechanism.index[name] for name in kept]
    found = np.linalg.lstsq(S_G[:, columns], dX_G, rcond=None)[0]
    return dict(zip(kept, found.tolist(), strict=True))


def remaining(h: float, rng: np.random.Generator | None) -> dict[str, Array]:
    """Return the error along x at the check angles (91,) [mm], by way of calibration."""
    robot, truth = machine(h)
    recording = measured(robot, truth, rng)
    simplified = for_model(robot, "2")
    commanding = {
        "none": (simplified, "exact"),
        "classical": (
            dataclasses.replace(simplified, errors=first_order(simplified, recording, components=(0,))),
            "exact",
        ),
        "improved": (dataclasses.replace(robot, errors=first_order(robot, recording, components=(0, 1, 2))), "linear"),
        "exact": (identify(robot, recording).robot, "exact"),
    }
    mechanism, nominal = load_mechanism(robot.mechanism), load_mechanism(simplified.mechanism)
    targets, _ = nominal.forward(CHECK[:, None], robot.tool, nominal.rows(simplified))
    true = mechanism.rows(robot, mechanism.vector(truth))
    errors = {}
    for way, (known, kind) in commanding.items():
        joints = Compensator(known, kind).joints(targets[:, :3])
        errors[way] = mechanism.forward(joints, robot.tool, true)[0][:, 0] - targets[:, 0]
    return errors


def main() -> None:
    """Simulate, print the table, draw the figure."""
    screen, rng = Console(), np.random.default_rng(2006)
    table = Table("tool, mm", "readings", *WAYS, title="Largest error along x over -45 to 45 deg, mm")
    curves = {}
    for h in TOOLS:
        curves[h] = remaining(h, rng)
        for name, errors in (("0.003 mm, 0.003 deg", curves[h]), ("without noise", remaining(h, None))):
            table.add_row(f"{h:.0f}", name, *(f"{np.abs(errors[way]).max():.4f}" for way in WAYS))
    screen.print(table)
    if len(sys.argv) > 1:
        _figure(Path(sys.argv[1]), curves)


def _figure(path: Path, curves: dict[float, dict[str, Array]]) -> None:
    """Draw figures 5 to 7: error against joint angle, the calibrated ones again on a scale of their own."""
    from deltacal_gen.pages import figures

    with figures.mpl.rc_context(figures.STYLE):
        picture, axes = figures.plt.subplots(2, 3, figsize=(11, 5.6), sharex=True, constrained_layout=True)
        for column, (h, errors) in enumerate(curves.items()):
            for row, ways in enumerate((WAYS[:3], WAYS[2:])):
                a = axes[row, column]
                for way in ways:
                    a.plot(np.degrees(CHECK), errors[way], color=f"C{WAYS.index(way)}", label=way)
                a.axhline(0.0, color="0.8", linewidth=0.8, zorder=0)
            axes[0, column].set_title(f"tool h = {h:.0f} mm")
            axes[1, column].set_xlabel("q, deg")
        for a in axes[:, 0]:
            a.set_ylabel("error along x, mm")
            a.legend()
        picture.savefig(path, dpi=150)


if __name__ == "__main__":
    main()
