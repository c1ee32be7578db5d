"""Newton and Euler by hand, for chains of links: a twin of the derived dynamics that shares no line with them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

Array = np.ndarray


def _screw(axis: int, turn: float, shift: float) -> Array:
    c, s = np.cos(turn), np.sin(turn)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    T = np.eye(4)
    T[i, i], T[i, j], T[j, i], T[j, j] = c, -s, s, c
    T[axis, 3] = shift
    return T


def _cross(a: Array, b: Array) -> Array:
    """Return the product of two vectors: of so few numbers ten times as fast as NumPy's, which turns axes first."""
    (x, y, z), (u, v, w) = a.tolist(), b.tolist()
    return np.array([y * w - z * v, z * u - x * w, x * v - y * u])


def torque(
    links: Sequence[Mapping[str, Any]], q: Array, qd: Array, qdd: Array, inertia: Array, gravity: Array
) -> Array:
    """Return the torques (n_q,) [N mm, N] of a chain of tables ``[[joint]]`` at one state [rad, mm, s].

    inertia (links, 10): mass, first moments, tensor (xx, yy, zz, xy, xz, yz) about the link frame's origin [kg, mm].
    """
    moving = [k for k, link in enumerate(links) if link["kind"] in ("revolute", "prismatic")]
    T, w, dw, v, a = np.eye(4), np.zeros(3), np.zeros(3), np.zeros(3), np.zeros(3)
    axes: list[tuple[Array, Array, bool, dict[int, float]]] = []
    asked: list[tuple[Array, Array]] = []
    for k, link in enumerate(links):
        own = {moving.index(k): 1.0} if k in moving else {}
        own |= {moving.index(int(n) - 1): much for n, much in link.get("coupling", {}).items()}
        value, rate, accel = (sum(much * x[j] for j, much in own.items()) for x in (q, qd, qdd))
        slides = link["kind"] == "prismatic"
        turn = np.radians(link.get("theta", 0.0)) + (0.0 if slides else value)
        shift = link.get("d", 0.0) + (value if slides else 0.0)
        screws = [_screw(2, turn, shift), _screw(0, np.radians(link.get("alpha", 0.0)), link.get("a", 0.0))]
        if link.get("convention", "standard") == "modified":
            before, after = T @ screws[1], T @ screws[1] @ screws[0]
        else:
            before, after = T, T @ screws[0] @ screws[1]
        z, at = before[:3, 2], before[:3, 3]
        # where the joint is, carried along by the link before; then what its own motion adds to all behind it
        r0 = at - T[:3, 3]
        v0, a0 = v + _cross(w, r0), a + _cross(dw, r0) + _cross(w, _cross(w, r0))
        r = after[:3, 3] - at
        if slides:
            v = v0 + _cross(w, r) + z * rate
            a = a0 + _cross(dw, r) + _cross(w, _cross(w, r)) + z * accel + 2 * _cross(w, z * rate)
        else:
            dw = dw + _cross(w, z * rate) + z * accel
            w = w + z * rate
            v, a = v0 + _cross(w, r), a0 + _cross(dw, r) + _cross(w, _cross(w, r))
        T = after
        R, o = T[:3, :3], T[:3, 3]
        m, h = inertia[k, 0], R @ inertia[k, 1:4]
        xx, yy, zz, xy, xz, yz = inertia[k, 4:]
        tensor = R @ np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) @ R.T
        felt = a / 1000 - gravity
        force = m * felt + (_cross(dw, h) + _cross(w, _cross(w, h))) / 1000
        moment = (tensor @ dw + _cross(w, tensor @ w)) / 1000 + _cross(h, felt)
        axes.append((z, at, slides, own))
        asked.append((force, moment + _cross(o, force)))
    out = np.zeros(len(moving))
    for k, (z, at, slides, own) in enumerate(axes):
        force = sum((f for f, _ in asked[k:]), np.zeros(3))
        moment = sum((m for _, m in asked[k:]), np.zeros(3))
        paid = z @ force if slides else z @ (moment - _cross(at, force))
        for j, much in own.items():
            out[j] += much * paid
    return out
