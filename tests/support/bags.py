"""A file of MCAP, written by its own library."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

START = 1_700_000_000  # s: a clock as ROS has it
NAMES = ("shoulder", "elbow", "wrist")
JOINT_STATE = """std_msgs/Header header
string[] name
float64[] position
float64[] velocity
float64[] effort
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
"""
POINT = """std_msgs/Header header
geometry_msgs/Point point
================================================================================
MSG: geometry_msgs/Point
float64 x
float64 y
float64 z
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
"""


def way(t: np.ndarray) -> np.ndarray:
    """Return joints (N, 3) [rad] in motion."""
    return np.column_stack([0.5 * np.sin(t), 0.3 * np.cos(0.7 * t), 0.2 * t])


def seen(q: np.ndarray) -> np.ndarray:
    """Return what an instrument reads (N, 3) [m]: some function of the joints."""
    return np.column_stack([q[:, 0], q[:, 1] + 0.1 * q[:, 2], q[:, 2] - 1])


Motion = Callable[[np.ndarray], np.ndarray]
TIMES = np.arange(0, 6, 0.01)  # of the joints
LOOKS = np.arange(0.105, 5.8, 0.1003)  # of the instrument


def mcap(folder: Path, motion: Motion) -> Path:
    """Write a file of MCAP by its own library; return it."""
    from mcap_ros2.writer import Writer

    path = folder / "run.mcap"
    with path.open("wb") as file, Writer(file) as bag:
        states = bag.register_msgdef("sensor_msgs/msg/JointState", JOINT_STATE)
        looked = bag.register_msgdef("geometry_msgs/msg/PointStamped", POINT)

        def header(t: float) -> dict[str, Any]:
            return {"stamp": {"sec": START + int(t), "nanosec": round(t % 1 * 1e9)}, "frame_id": ""}

        for t, q in zip(TIMES, motion(TIMES), strict=True):
            message = {"header": header(t), "name": list(NAMES), "position": list(q), "velocity": [], "effort": []}
            bag.write_message("/joint_states", states, message, log_time=int((START + t) * 1e9))
        for t, (x, y, z) in zip(LOOKS, seen(motion(LOOKS)), strict=True):
            message = {"header": header(t), "point": {"x": x, "y": y, "z": z}}
            bag.write_message("/tracker", looked, message, log_time=int((START + t) * 1e9))
    return path
