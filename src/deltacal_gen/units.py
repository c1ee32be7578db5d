"""Units: millimetres, radians, kilograms, seconds, newtons and kelvins inside; converted once, at the edge of a file.

The files speak mm, deg, kg, s, N and degC (contract, section 0); torques are Nm at the edge and N mm inside.
"""

from __future__ import annotations

import math

DEG = math.pi / 180.0

_FILE_UNIT = {"rad": "deg", "mm": "mm", "1": "1", "rad/N/mm": "deg/Nm"}
_PER_FILE_UNIT = {"rad": DEG, "mm": 1.0, "1": 1.0, "rad/N/mm": DEG / 1000.0}


def file_unit(unit: str) -> str:
    """Name of the unit that files use where the code uses `unit`."""
    return _FILE_UNIT[unit]


def to_internal(unit: str) -> float:
    """Factor from the file's unit to the internal one, e.g. ``to_internal("rad") == pi / 180``."""
    return _PER_FILE_UNIT[unit]


def to_file(value: float, unit: str) -> float:
    """Value in the unit of the files of an internal one [`unit`]: the shortest decimal that is read as this value.

    30 deg are so, though of pi / 180 thirty times and of pi / 6 the last digits differ.
    """
    factor = to_internal(unit)
    exact = float(value) / factor
    short = round(exact, 12)
    same = short * factor == value or (factor != 1.0 and math.isclose(short, exact, rel_tol=4e-16))
    return short if same else exact


def of_joints(unit: str, joints: int) -> list[str]:
    """Return the unit of each joint: `unit` is that of all of them, or lists them one by one, with commas."""
    each = unit.split(",")
    return each if len(each) > 1 else each * joints


def joint_names(unit: str, joints: int, pattern: str = "q{i}_{unit}") -> list[str]:
    """Return the columns of the joints in files, as ``q1_deg, q2_deg, q3_mm``."""
    return [pattern.format(i=i, unit=file_unit(u)) for i, u in enumerate(of_joints(unit, joints), start=1)]


def joint_factors(unit: str, joints: int) -> list[float]:
    """Return the factor of each joint from the file's unit to the internal one."""
    return [to_internal(u) for u in of_joints(unit, joints)]


def of_sliding(unit: str) -> tuple[str, float]:
    """Return unit in files and factor to the internal one of what moves a sliding joint: mm for deg, N for Nm."""
    return unit.replace("deg", "mm").replace("Nm", "N"), 1.0
