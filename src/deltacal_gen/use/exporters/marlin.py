"""Marlin's M665 and M666, to be sent to the printer."""

from __future__ import annotations

from collections.abc import Mapping

from deltacal_gen.machine.values import Robot
from deltacal_gen.use.firmware import Firmware, by_axis, firmware_values, turned_towers


class Marlin(Firmware):
    """M665 and M666: carriages go down from their switches by the trims, which therefore are none above 0."""

    def lines(self, robot: Robot, scales: Mapping[str, float]) -> list[str]:
        """Return the mean arm with what each differs by, and the height of the lowest endstop."""
        radius, arm, angle, endstop = firmware_values(robot)
        home, rod = float(endstop.min()), float(arm.mean())
        return [
            f"M665 L{rod:.4f} R{radius:.4f} H{home:.4f} {turned_towers(angle)} {by_axis('ABC', arm - rod)}",
            f"M666 {by_axis('XYZ', home - endstop)}",
            "M500",
        ]


EXPORTER = Marlin()
