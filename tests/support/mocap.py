"""Files of motion capture, as C3D and Motive write them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

RATE = 100.0
TIMES = np.arange(0, 4, 1 / RATE)


def stairs(t: np.ndarray) -> np.ndarray:
    """Return joints (N, 3) [deg] that stand still in the second half of every half second."""
    step = np.floor(2 * t) + np.clip(4 * (t % 0.5), 0, 1)
    return np.column_stack([5 * step, -3 * step, step])


def seen(t: np.ndarray) -> np.ndarray:
    """Return what is captured (N, 3) [mm]."""
    return stairs(t) * [10, 20, 30] + [100, 0, -500]


def c3d(folder: Path, labels: tuple[str, ...] = ("tool",), unit: str = "mm") -> Path:
    ezc3d = pytest.importorskip("ezc3d")
    made = ezc3d.c3d()
    made["header"]["points"]["first_frame"] = 0
    made["parameters"]["POINT"]["RATE"]["value"] = [RATE]
    made["parameters"]["POINT"]["LABELS"]["value"] = list(labels)
    made["parameters"]["POINT"]["UNITS"]["value"] = [unit]
    points = np.ones((4, len(labels), len(TIMES)))
    points[:3] = (seen(TIMES).T / (1000 if unit == "m" else 1))[:, None, :]
    points[:3, 0, 50:60] = np.nan  # hidden
    made["data"]["points"] = points
    made.write(str(folder / "take.c3d"))
    return folder / "take.c3d"


def motive(folder: Path) -> Path:
    """Write what Motive exports: a rigid body turned by 0.4 rad about z, and a marker of it."""
    half = 0.2
    head = [
        "Format Version,1.23,Take Name,Take,Capture Frame Rate,100.000,Rotation Type,Quaternion,Length Units,Meters",
        "",
        ",Type,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,"
        "Rigid Body Marker,Rigid Body Marker,Rigid Body Marker",
        ",Name,Tool,Tool,Tool,Tool,Tool,Tool,Tool,Tool,Tool:1,Tool:1,Tool:1",
        ",ID,1,1,1,1,1,1,1,1,2,2,2",
        ",,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Mean Marker Error,Position,Position,Position",
        "Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,,X,Y,Z",
    ]
    rows = [
        f"{k},{t:.6f},0,0,{np.sin(half)},{np.cos(half)},{x / 1000},{y / 1000},{z / 1000},0.0001,1,2,3"
        for k, (t, (x, y, z)) in enumerate(zip(TIMES, seen(TIMES), strict=True))
    ]
    rows[7] = "7,0.070000,,,,,,,,,,,"  # not tracked
    (folder / "take.csv").write_text("\n".join(head + rows) + "\n")
    return folder / "take.csv"
