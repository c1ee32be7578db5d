"""The way back into a printer: the lines of its firmware that describe the calibrated machine, as far as they can.

Firmware knows radius, arms, tower angles and endstops. What a machine has beside them is approximated: the lines are
those whose positions come closest over the printable volume, and the file says what they leave.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np

from deltacal_gen.errors import UsageError
from deltacal_gen.estimation.estimation import fit, pose_problem
from deltacal_gen.estimation.solvers import LeastSquares
from deltacal_gen.files.imports import ANGLES, TOWERS
from deltacal_gen.files.recording import Measurement, Recording, write_files
from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import SOLVED, Array, Machine, mechanism_of
from deltacal_gen.units import DEG, file_unit, to_internal

MODEL = "linear_delta/9"  # what Klipper and RepRapFirmware describe
FROM_HEIGHTS = "linear_delta/6"  # what they fit to heights alone
PRINTED = 0.6  # of the radius: the printed volume's, where the robot file gives no workspace
NEGLIGIBLE = 1e-9  # of a parameter, internal units
LAYERS = (0.0, 0.2, 0.4)  # of the endstop's height


@dataclasses.dataclass(frozen=True)
class Lines:
    """What firmware is told, what that leaves over the printed volume [mm], and what it cannot be told."""

    text: str
    left_rms_mm: float
    left_worst_mm: float
    not_carried: tuple[str, ...]


def firmware_lines(robot: Robot, kind: str, physics: Sequence[str] = ()) -> Lines:
    """Return the lines of a printer's firmware for a calibrated machine.

    Parameters
    ----------
    robot : Robot
        Linear delta, with its errors.
    kind : {"klipper", "rrf"}
    physics : sequence of str
        Effects that were diagnosed on it, which no line can carry.

    Raises
    ------
    UsageError
        Another mechanism, or another firmware.
    """
    writers: dict[str, Callable[[Robot], str]] = {"klipper": _klipper, "rrf": _rrf}
    if robot.mechanism != "linear_delta" or kind not in writers:
        raise UsageError(f"{' and '.join(writers)} lines describe a linear_delta, not '{kind}' of a {robot.mechanism}.")
    mechanism = mechanism_of(robot)
    scales = {n: v for n, v in robot.errors.items() if n.startswith("scale_") and abs(v) > NEGLIGIBLE}
    carried = dataclasses.replace(robot, errors={n: v for n, v in robot.errors.items() if n not in scales})
    closest, left = _closest(carried, mechanism)
    notes = [
        f"{n} = {v:+.6f}: multiply {_belt(kind, int(n[-1]))} by {1 + v if kind == 'klipper' else 1 / (1 + v):.6f}"
        for n, v in scales.items()
    ]
    own = set(mechanism.model(MODEL))
    for p in mechanism.parameters:
        value = carried.errors.get(p.name, 0.0)
        if p.name not in own and abs(value) > NEGLIGIBLE:
            notes.append(f"{p.name} = {value / to_internal(p.unit):+.4f} {file_unit(p.unit)} ({p.meaning})")
    notes += [f"the effect {name}" for name in physics]
    rms, worst = float(np.sqrt(np.mean(left**2))), float(left.max())
    mark = "#" if kind == "klipper" else ";"
    head = [f"{mark} {robot.name}: what these lines leave over the printed volume: rms {rms:.4f}, worst {worst:.4f} mm"]
    if notes:
        head.append(f"{mark} not carried by them:")
        head += [f"{mark}   {note}" for note in notes]
    return Lines("\n".join([*head, writers[kind](closest)]) + "\n", rms, worst, tuple(notes))


def export_firmware(robot: Robot, kind: str, path: str | Path, physics: Sequence[str] = ()) -> Lines:
    """Write the lines of a printer's firmware; see `firmware_lines`."""
    found = firmware_lines(robot, kind, physics)
    write_files({Path(path): found.text})
    return found


def _belt(kind: str, tower: int) -> str:
    if kind == "klipper":
        return f"rotation_distance of {TOWERS[tower - 1]}"
    return f"the steps per mm of {'XYZ'[tower - 1]} (M92)"


def _closest(robot: Robot, mechanism: Machine) -> tuple[Robot, Array]:
    """Return the machine that firmware can describe with the least position error, and that error (N,) [mm]."""
    space = robot.workspace
    wide = space.radius if space is not None and space.radius is not None else PRINTED * robot.geometry["radius"][0]
    around = np.linspace(0, 2 * np.pi, 12, endpoint=False)
    disc = np.vstack([[0.0, 0.0], *(r * wide * np.column_stack([np.cos(around), np.sin(around)]) for r in (0.5, 1.0))])
    high = float(np.min(robot.geometry["endstop"]))
    targets = np.vstack([np.column_stack([disc, np.full(len(disc), part * high)]) for part in LAYERS])
    q, _, status = mechanism.inverse(targets, robot.tool, mechanism.rows(robot))
    q, targets = q[status == SOLVED], targets[status == SOLVED]
    n = len(q)
    positions = Recording(
        path=Path("firmware"),
        kind="position",
        measurement=Measurement(kind="position", frame="robot"),
        joint_unit="mm",
        joints=q * robot.joint_sign,
        columns=("x_mm", "y_mm", "z_mm"),
        measured=targets,
        pose=np.arange(n).astype(str),
        line=np.arange(n),
        channels={},
        setup=np.zeros(n, dtype=int),
        setup_names=("1",),
    )
    nominal = dataclasses.replace(robot, errors={})
    found = fit(
        pose_problem(nominal, positions, mechanism.model(MODEL)),
        LeastSquares(),
        robust=False,
        weigh_repeats=False,
        drop_gross=False,
        must_converge=False,
    )
    given = dict(zip((p.name for p in mechanism.parameters), found.errors.tolist(), strict=True))
    return dataclasses.replace(nominal, errors=given), np.linalg.norm(found.residual, axis=1)


def _values(robot: Robot) -> tuple[float, Array, Array, Array]:
    """Return radius, arms, angles [deg] and endstops, errors included."""
    e, g = robot.errors, robot.geometry
    arm, angle, endstop = (
        g[key] + np.array([e.get(f"{error}_{i}", 0.0) for i in (1, 2, 3)])
        for key, error in (("arm_length", "arm"), ("tower_angle", "angle"), ("endstop", "endstop"))
    )
    return float(g["radius"][0] + e.get("radius", 0.0)), arm, angle / DEG, endstop


def _klipper(robot: Robot) -> str:
    radius, arm, angle, endstop = _values(robot)
    lines = ["[printer]", f"delta_radius: {radius:.6f}"]
    for tower, a, phi, home in zip(TOWERS, arm, angle, endstop, strict=True):
        lines += ["", f"[{tower}]", f"angle: {phi:.6f}", f"arm_length: {a:.6f}", f"position_endstop: {home:.6f}"]
    return "\n".join(lines)


def _rrf(robot: Robot) -> str:
    radius, arm, angle, endstop = _values(robot)
    home = float(endstop.mean())
    turned = " ".join(f"{axis}{phi - nominal:.4f}" for axis, phi, nominal in zip("XYZ", angle, ANGLES, strict=True))
    rods = ":".join(f"{a:.4f}" for a in arm)
    trims = " ".join(f"{axis}{h - home:.4f}" for axis, h in zip("XYZ", endstop, strict=True))
    return f"M665 R{radius:.4f} L{rods} H{home:.4f} {turned}\nM666 {trims}"
