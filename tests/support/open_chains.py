"""Open chains by their links, and where they reach by matrices written out here."""

from __future__ import annotations

from typing import Any

import numpy as np

from deltacal_gen.files.robot import Robot, robot_from_dict

ARM: list[dict[str, Any]] = [  # shoulder, two long links with parallel axes, a wrist of three
    {"kind": "revolute", "alpha": 90.0, "d": 120.0, "mass": 6.0, "com": [0.0, -20.0, 0.0]},
    {"kind": "revolute", "a": 400.0, "mass": 5.0, "com": [-180.0, 0.0, 40.0]},
    {"kind": "revolute", "a": 350.0, "theta": -30.0, "mass": 3.0, "com": [-150.0, 0.0, 20.0]},
    {"kind": "revolute", "alpha": 90.0, "d": 110.0, "mass": 1.0},
    {"kind": "revolute", "alpha": -90.0, "d": 95.0},
    {"kind": "revolute", "d": 80.0, "mass": 0.5, "com": [0.0, 5.0, -10.0]},
]


def robot(links: list[dict[str, Any]] = ARM, **tables: Any) -> Robot:
    head = {"robot": {"name": "arm", "mechanism": "serial"}, "geometry": {"tool": [10.0, -5.0, 60.0]}}
    return robot_from_dict(head | {"joint": links} | tables)


def by_hand(r: Robot, q: np.ndarray, errors: dict[str, float]) -> np.ndarray:
    """Return the pose (12,) at joints (n,), by 4 x 4 matrices of one pose."""

    def turn(axis: int, t: float) -> np.ndarray:
        out = np.eye(4)
        i, j = [(1, 2), (2, 0), (0, 1)][axis]
        out[[i, i, j, j], [i, j, i, j]] = np.cos(t), -np.sin(t), np.sin(t), np.cos(t)
        return out

    def shift(x: float, z: float) -> np.ndarray:
        out = np.eye(4)
        out[[0, 2], 3] = x, z
        return out

    T, readings, by_number = np.eye(4), iter(q), {}
    for k, link in enumerate(r.links, start=1):
        a, alpha, d, theta = (r.geometry[n][k - 1] + errors.get(f"{n}_{k}", 0.0) for n in ("a", "alpha", "d", "theta"))
        beta = errors.get(f"beta_{k}", 0.0)
        value = 0.0
        if link.kind in ("revolute", "prismatic"):
            value = by_number[k] = float(next(readings))
        if link.kind == "coupled":
            value = sum(much * by_number[n] for n, much in link.coupling)
        d, theta = (d + value, theta) if link.kind == "prismatic" else (d, theta + value)
        if link.convention == "standard":
            T = T @ turn(2, theta) @ shift(0, d) @ shift(a, 0) @ turn(0, alpha) @ turn(1, beta)
        else:
            T = T @ turn(0, alpha) @ turn(1, beta) @ shift(a, 0) @ turn(2, theta) @ shift(0, d)
    tool = r.tool + [errors.get(t, 0.0) for t in ("tx", "ty", "tz")]
    return np.concatenate([T[:3, :3] @ tool + T[:3, 3], T[:3, :3].ravel()])


SCARA = [
    {"kind": "revolute", "a": 300.0, "d": 400.0, "mass": 8.0, "com": [-120.0, 0.0, 0.0]},
    {"kind": "revolute", "a": 250.0, "alpha": 180.0, "mass": 5.0, "com": [-100.0, 0.0, 30.0]},
    {"kind": "prismatic", "mass": 1.5},
    {"kind": "revolute", "d": 60.0, "mass": 0.5},
]


AXIS = {"robot": {"name": "axis", "mechanism": "serial"}, "joint": [{"kind": "prismatic"}]}
