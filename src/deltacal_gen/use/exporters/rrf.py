"""RepRapFirmware's M665 and M666, for config.g."""

from __future__ import annotations

from collections.abc import Mapping

from deltacal_gen.machine.values import Robot
from deltacal_gen.use.firmware import Firmware, by_axis, firmware_values, turned_towers


class RepRap(Firmware):
    """M665 and M666, trims about their mean."""

    def lines(self, robot: Robot, scales: Mapping[str, float]) -> list[str]:
        """Return arms one by one, and the height of the mean endstop."""
        radius, arm, angle, endstop = firmware_values(robot)
        home = float(endstop.mean())
        rods = ":".join(f"{a:.4f}" for a in arm)
        return [
            f"M665 R{radius:.4f} L{rods} H{home:.4f} {turned_towers(angle)}",
            f"M666 {by_axis('XYZ', endstop - home)}",
        ]


EXPORTER = RepRap()
