"""A delta printer, points of its bed and readings to come there, and what its firmware keeps."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import SOLVED, Array, load_mechanism
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.units import DEG

PRINTER = {
    "robot": {"name": "printer", "mechanism": "linear_delta"},
    "geometry": {
        "radius": 130.0,
        "arm_length": [270.0, 270.5, 269.5],
        "tower_angle": [210.0, 330.5, 90.0],
        "endstop": [300.0, 301.0, 299.0],
    },
    "transmission": {"pulley_circumference": 32.0},
}
LINEAR = load_mechanism("linear_delta")


def grid(radius: float = 100.0, step: float = 20.0, z: float = 0.0) -> Array:
    axis = np.arange(-radius, radius + 1e-6, step)
    x, y = (a.ravel() for a in np.meshgrid(axis, axis))
    inside = np.hypot(x, y) <= radius + 1e-6
    return np.column_stack([x[inside], y[inside], np.full(inside.sum(), z)])


def recording(robot: Robot, targets: Array, kind: str = "height", pairs: Array | None = None) -> Recording:
    q, _, status = LINEAR.inverse(targets, robot.tool, LINEAR.rows(robot, np.zeros(len(LINEAR.parameters))))
    assert (status == SOLVED).all()
    n, columns = len(q), {"height": ("height_mm",), "position": ("x_mm", "y_mm", "z_mm")}[kind]
    return Recording(
        path=Path("made.csv"),
        kind=kind,
        measurement=Measurement(kind=kind, frame="robot"),
        joint_unit="mm",
        joints=q,
        columns=columns,
        measured=np.full((n, len(columns)), np.nan),
        pose=np.arange(1, n + 1).astype(str),
        line=np.arange(2, n + 2),
        channels={},
        setup=np.zeros(n, dtype=int),
        setup_names=("1",),
        pairs=pairs,
        pair_measured=None if pairs is None else np.full(len(pairs), np.nan),
        pair_line=None if pairs is None else np.arange(2, len(pairs) + 2),
    )


def plausible(rng: np.random.Generator, names: tuple[str, ...] | None = None) -> dict[str, float]:
    return {
        p.name: float(2 * p.typical * rng.standard_normal())
        for p in LINEAR.parameters
        if names is None or p.name in names
    }


STEP = 40.0 / (200 * 16)
Z_OFFSET = 1.5


def joints(robot: Robot, targets: Array, errors: dict[str, float] | None = None) -> Array:
    return LINEAR.inverse(targets, robot.tool, LINEAR.rows(robot, LINEAR.vector(errors or {})))[0]


def printer_cfg(robot: Robot, heights: Array, distances: list[tuple[float, Array, Array]], mesh: str = "") -> str:
    """Return a configuration as Klipper saves it; positions in motor steps."""
    g = robot.geometry
    lines = ["[mcu]", "serial: /dev/tty", "", "[printer]", "kinematics: delta  # of course", "max_velocity: 300", ""]
    for tower in "abc":
        lines += [f"[stepper_{tower}]", "rotation_distance: 40", "microsteps: 16", ""]
    lines += ["[probe]", "x_offset: 2.0", "", "#*# <---------------------- SAVE_CONFIG ---------------------->"]
    saved = ["[printer]", f"delta_radius = {g['radius'][0]:.6f}", ""]
    for i, tower in enumerate("abc"):
        saved += [
            f"[stepper_{tower}]",
            f"angle = {g['tower_angle'][i] / DEG:.6f}",
            f"arm_length = {g['arm_length'][i]:.6f}",
            f"position_endstop = {g['endstop'][i]:.6f}",
            "",
        ]
    saved += ["[probe]", f"z_offset = {Z_OFFSET:.3f}", "", "[delta_calibrate]"]

    def steps(q: Array) -> str:
        return ",".join(f"{v:.3f}" for v in q / STEP)

    for k, q in enumerate(heights):
        saved += [f"height{k} = {Z_OFFSET}", f"height{k}_pos = {steps(q)}"]
    for k, (length, a, b) in enumerate(distances):
        saved += [f"distance{k} = {length}", f"distance{k}_pos1 = {steps(a)}", f"distance{k}_pos2 = {steps(b)}"]
    return "\n".join([*lines, *(f"#*# {line}" for line in [*saved, "", mesh] for line in line.split("\n"))]) + "\n"


def object_points() -> list[tuple[Array, Array]]:
    around = np.radians(np.arange(0, 360, 60))
    out = 65.0 * np.column_stack([np.cos(around), np.sin(around), 0 * around]) + [0, 0, 1.0]
    return [(np.array([0, 0, 1.0]), p) for p in out] + [(out[k], out[k - 1]) for k in range(6)]


def session(robot: Robot) -> tuple[Array, list[tuple[float, Array, Array]]]:
    heights = joints(robot, grid(80, 40, Z_OFFSET))
    distances = [(round(float(np.linalg.norm(b - a)), 4), *joints(robot, np.array([a, b]))) for a, b in object_points()]
    return heights, distances
