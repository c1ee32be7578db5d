"""An exact camera and an exact arm of our own: chain, lens and files written out once more, nothing of the kernels."""

from __future__ import annotations

import csv
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.spatial.transform import Rotation

from deltacal_gen.machine.registry import Array

LINKS = ((300.0, 20.0, -90.0, 0.0), (0.0, 350.0, 0.0, -90.0), (0.0, 30.0, -90.0, 0.0))  # d, a, alpha, theta
LINKS += ((350.0, 0.0, 90.0, 0.0), (0.0, 0.0, -90.0, 0.0), (80.0, 0.0, 0.0, 0.0))
DH = ("d", "a", "alpha", "theta")
WRONG_ARM = {"theta_2": 0.2, "a_2": 0.5, "theta_5": -0.3}  # deg, mm
LENS = {"fx_px": 1500.0, "fy_px": 1490.0, "cx_px": 645.0, "cy_px": 505.0}
BENT = {"k1": -0.12, "k2": 0.05, "p1": 0.0008, "p2": -0.0005, "k3": 0.01}
SIZE = 1280, 1024  # px
GRID = np.array([[30.0 * i, 30.0 * j] for i in range(6) for j in range(5)])
NOISE_PX, WRONG = 0.2, 0.05


def turn(*vector: float) -> Array:
    return np.asarray(Rotation.from_rotvec(vector).as_matrix())


def arm_poses(joints: Array, wrong: Mapping[str, float] = WRONG_ARM) -> tuple[Array, Array]:
    """Return rotations (N, 3, 3) and origins (N, 3) of the last frame of a wrong arm at joints (N, 6) [deg]."""
    out = []
    for q in joints:
        T = np.eye(4)
        for i, nominal in enumerate(LINKS, start=1):
            d, a, alpha, theta = (n + wrong.get(f"{k}_{i}", 0.0) for k, n in zip(DH, nominal, strict=True))
            t = np.radians(q[i - 1] + theta)
            c, s, ca, sa = np.cos(t), np.sin(t), *_twist(alpha)
            T = T @ np.array([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]])
            T[:3, :3] = T[:3, :3] @ turn(0.0, np.radians(wrong.get(f"beta_{i}", 0.0)), 0.0)
        out.append(T)
    found = np.array(out)
    return found[:, :3, :3], found[:, :3, 3]


def _twist(alpha: float) -> tuple[float, float]:
    return float(np.cos(np.radians(alpha))), float(np.sin(np.radians(alpha)))


def image(X: Array, lens: Mapping[str, float]) -> Array:
    """Return the image (n, 2) [px] of points (n, 3) in the camera's frame."""
    a, b = X[:, 0] / X[:, 2], X[:, 1] / X[:, 2]
    k1, k2, p1, p2, k3 = (lens.get(name, 0.0) for name in BENT)
    square = a**2 + b**2
    radial = 1 + square * (k1 + square * (k2 + square * k3))
    u = a * radial + 2 * p1 * a * b + p2 * (square + 2 * a**2)
    v = b * radial + p1 * (square + 2 * b**2) + 2 * p2 * a * b
    return np.column_stack([lens["cx_px"] + lens["fx_px"] * u, lens["cy_px"] + lens["fy_px"] * v])


def write(path: Path, columns: Mapping[str, Sequence[object]], sidecar: str) -> Path:
    with path.open("w", newline="") as stream:
        rows = csv.writer(stream)
        rows.writerow(columns)
        rows.writerows(zip(*columns.values(), strict=True))
    path.with_suffix(".toml").write_text(f"[measurement]\n{sidecar}")
    return path


def arm_robot(folder: Path, wrong: Mapping[str, float] | None = None) -> Path:
    """Write the arm as it is drawn, or as it is."""
    tables = ""
    for i, link in enumerate(LINKS, start=1):
        told = (f"{k} = {n + (wrong or {}).get(f'{k}_{i}', 0.0)}" for k, n in zip(DH, link, strict=True))
        tables += '[[joint]]\nkind = "revolute"\nconvention = "standard"\n' + "\n".join(told) + "\n"
    path = folder / "robot.toml"
    path.write_text(f'[robot]\nname = "arm"\nmechanism = "serial"\n{tables}[geometry]\ntool = [0.0, 0.0, 0.0]\n')
    return path


@dataclass(frozen=True)
class Scene:
    """A camera and a board as they stand: the camera turned by `C` and shifted by `h`, the board by `B` and `g`.

    Either of them rides on the last link, where the camera's `place` says so; the other one stands still.
    """

    place: str
    C: Array
    h: Array
    B: Array
    g: Array

    def pixels(self, poses: tuple[Array, Array], lens: Mapping[str, float], scale: float = 1.0) -> tuple[Array, Array]:
        """Return the images (N, n, 2) [px] of all points at poses of the last link, and which of them it shows."""
        out, shown = [], []
        fixed = scale * np.column_stack([GRID, np.zeros(len(GRID))]) @ self.B.T + self.g
        for R, P in zip(*poses, strict=True):
            X = ((fixed - P) @ R if self.place == "platform" else fixed @ R.T + P) @ self.C.T + self.h
            uv = image(X, lens)
            out.append(uv)
            shown.append((X[:, 2] > 50) & (uv > 0).all(axis=1) & (uv < SIZE).all(axis=1))
        return np.array(out), np.array(shown)


def around(poses: tuple[Array, Array], place: str) -> Scene:
    """Return a camera and a board that see each other from poses of the last link."""
    R, P = poses
    middle = Rotation.from_matrix(R).mean().as_matrix()
    facing, ahead = np.diag([1.0, -1.0, -1.0]), P.mean(axis=0)
    if place == "platform":
        B, C, h = middle @ facing @ turn(0.1, 0.05, 0.4), turn(0.1, -0.08, 0.3), np.array([5.0, -32.0, 40.0])
        return Scene(place, C, h, B, ahead + 450 * middle[:, 2] - B @ [75.0, 60.0, 0.0])
    B, C = turn(0.1, 0.05, 0.4), (middle @ facing).T @ turn(0.05, 0.02, 0.0)
    return Scene(place, C, -C @ (ahead + 600 * middle[:, 2]), B, np.array([0.0, 0.0, 30.0]) - B @ [75.0, 60.0, 0.0])


def joints_around(rng: np.random.Generator, count: int) -> Array:
    """Return joints (count, 6) [deg] about the middle of the arm's room."""
    return np.array([10.0, 5.0, 15.0, 10.0, 50.0, 5.0]) + rng.uniform(-25, 25, (count, 6))


def rows_seen(joints: Array, pixels: Array, shown: Array, rng: np.random.Generator) -> dict[str, Sequence[object]]:
    """Return the columns of a recording of images with noise, one in twenty points found wrongly."""
    rows: list[tuple[object, ...]] = []
    for k, q in enumerate(joints):
        noisy = pixels[k][shown[k]] + NOISE_PX * rng.standard_normal((shown[k].sum(), 2))
        for point, pixel in zip(GRID[shown[k]], noisy, strict=True):
            found = rng.uniform(0, SIZE) if rng.random() < WRONG else pixel
            rows.append((k, *q, *found, *point))
    names = ("pose", *(f"q{i}_deg" for i in range(1, 7)), "u_px", "v_px", "board_x_mm", "board_y_mm")
    return dict(zip(names, zip(*rows, strict=True), strict=True))


def seen_by_arm(folder: Path, sidecar: str, lens: Mapping[str, float], place: str = "platform") -> tuple[Path, Path]:
    """Write what a camera sees of a board in 30 poses, one in twenty points found wrongly; and the rows without it."""
    rng = np.random.default_rng(7)
    joints = joints_around(rng, 30)
    poses = arm_poses(joints)
    columns = rows_seen(joints, *around(poses, place).pixels(poses, lens), rng)
    blank = {name: cells for name, cells in columns.items() if not name.endswith("_px")}
    return write(folder / "seen.csv", columns, sidecar), write(folder / "blank.csv", blank, sidecar)


def camera(place: str = "platform", **said: object) -> str:
    lines = "".join(f"{k} = {json.dumps(v)}\n" for k, v in said.items())
    return f'kind = "board image"\nsigma_px = {NOISE_PX}\n[measurement.camera]\nplace = "{place}"\n{lines}'
