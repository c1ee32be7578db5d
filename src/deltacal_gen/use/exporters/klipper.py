"""Klipper's ``[printer]`` and ``[stepper_*]`` sections, to be put into printer.cfg."""

from __future__ import annotations

from collections.abc import Mapping

from deltacal_gen.files.printers import TOWERS
from deltacal_gen.machine.values import Robot
from deltacal_gen.use.firmware import Firmware, firmware_values


class Klipper(Firmware):
    """Sections of printer.cfg; the length of a belt's turn is one of their numbers."""

    mark = "#"
    belts = True
    notes = (
        "put these above the SAVE_CONFIG block: there they hold before what it saved; below it Klipper drops the block",
    )

    def lines(self, robot: Robot, scales: Mapping[str, float]) -> list[str]:
        """Return radius, and angle, arm and endstop of each tower."""
        radius, arm, angle, endstop = firmware_values(robot)
        lines = ["[printer]", f"delta_radius: {radius:.6f}"]
        belt = None if robot.transmission is None else robot.transmission.pulley_circumference
        for i, (tower, a, phi, home) in enumerate(zip(TOWERS, arm, angle, endstop, strict=True), start=1):
            lines += ["", f"[{tower}]", f"angle: {phi:.6f}", f"arm_length: {a:.6f}", f"position_endstop: {home:.6f}"]
            if belt is not None and f"scale_{i}" in scales:
                lines.append(f"rotation_distance: {belt * (1 + scales[f'scale_{i}']):.6f}")
        return lines


EXPORTER = Klipper()
