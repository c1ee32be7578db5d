"""The study of Savoure 2006, section III.B: figures 5 to 7.

A planar parallelogram with the errors of Table 2 is read at 19 joint angles (position 0.003 mm, orientation 0.003 deg
of noise) and calibrated in four ways; what is shown is the error of the tool point along x over -45 to 45 deg.

1. none;
2. classical: the simplified model of eq. (38) by least squares of x, the simplified inverse position (35);
3. improved: the complete model to first order, its six base parameters, compensation by eqs. (29)-(33);
4. exact: ``identify`` and the exact compensator.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator, Mapping
from functools import partial
from typing import Any

import numpy as np

from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import Robot, for_model, read_robot
from deltacal_gen.identification.identifiability import base_parameters
from deltacal_gen.identification.identification import identify
from deltacal_gen.machine.registry import Array, load_mechanism
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.simulation import read_truth, simulate
from deltacal_gen.units import DEG
from deltacal_gen.use.compensation import Compensator
from derive.review.reproduction.sheet import Part, Picture, Sheet
from derive.review.sources import EXAMPLES

TOOLS = (0.0, 100.0, 200.0)  # h [mm]
SIGMA_MM, SIGMA_RAD = 0.003, 0.003 * DEG
CHECK = np.arange(-45.0, 46.0) * DEG
WAYS = ("none", "classical", "improved", "exact")
SOURCE = EXAMPLES / "planar_parallelogram"


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
    kept = base_parameters(S_G, [p.name for p in mechanism.parameters], mechanism.typical)
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


def study(tell: Callable[[str], None]) -> Iterator[Part]:
    """Yield Table 2, the errors that remain, and figures 5 to 7, remade."""
    yield table_2()
    rng = np.random.default_rng(2006)
    heads = ("tool, mm", "readings", *(f"{way}, mm" for way in WAYS))
    sheet = Sheet("Fig. 5", "Largest error along x over -45 to 45 deg; the paper prints curves only", heads)
    curves = {}
    for h in TOOLS:
        tell(f"tool of {h:.0f} mm")
        curves[h] = remaining(h, rng)
        for name, errors in (("0.003 mm, 0.003 deg", curves[h]), ("without noise", remaining(h, None))):
            sheet.add(f"{h:.0f}", name, *(f"{np.abs(errors[way]).max():.4f}" for way in WAYS))
    yield sheet
    for number, (h, errors) in zip((5, 6, 7), curves.items(), strict=True):
        title = (
            f"Error along x against the joint angle, tool h = {h:.0f} mm; on the right those that are calibrated best"
        )
        yield Picture(f"Fig. {number}", title, partial(_curves, errors), (1, 2))


def table_2() -> Sheet:
    """Return the nominal mechanism and the errors that are simulated."""
    robot, truth = machine(TOOLS[1])
    sheet = Sheet("Table 2", "Taken over as printed", ("parameter", "nominal, mm", "error, mm; q0 in deg"))
    for name, error in truth.items():
        value = f"{robot.geometry[name][0]:g}" if name in robot.geometry else ""
        sheet.add(name, value, f"{error / DEG if name == 'q0' else error:g}")
    return sheet


def _curves(errors: Mapping[str, Array], axes: Any) -> None:
    """Draw errors against the joint angle, the calibrated ones again on a scale of their own."""
    for a, ways in zip(axes, (WAYS[:3], WAYS[2:]), strict=True):
        for way in ways:
            a.plot(np.degrees(CHECK), errors[way], color=f"C{WAYS.index(way)}", label=way)
        a.axhline(0.0, color="0.8", linewidth=0.8, zorder=0)
        a.set(xlabel="q, deg", ylabel="error along x, mm")
        a.legend(frameon=False)
