"""A Delta written down by hand from the contract's conventions (sections 1 and 6): what the generated kernels must be.

Plain matrices, no SymPy, and every function also takes complex arguments, for complex-step derivatives.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.linalg import expm

PHI = np.deg2rad([-90.0, 30.0, 150.0])


def cross_matrix(v: np.ndarray) -> np.ndarray:
    return np.array([[0 * v[0], -v[2], v[1]], [v[2], 0 * v[0], -v[0]], [-v[1], v[0], 0 * v[0]]])


def turned(*v: complex) -> np.ndarray:
    """Return the rotation by a rotation vector, as the exponential of its cross matrix."""
    return np.asarray(expm(cross_matrix(np.array(v))))


def cayley(c: np.ndarray) -> np.ndarray:
    K = cross_matrix(c) / 2
    return np.asarray(np.linalg.solve(np.eye(3) - K, np.eye(3) + K))


def nominal_frame(limb: int) -> np.ndarray:
    """Return [u0 v0 w0] of limb 0, 1 or 2: along the limb, up, along the joint axis towards rod 1."""
    u = np.array([np.cos(PHI[limb]), np.sin(PHI[limb]), 0.0])
    w = np.array([np.sin(PHI[limb]), -np.cos(PHI[limb]), 0.0])
    return np.column_stack([u, [0.0, 0.0, 1.0], w])


def rod_ends(
    geometry: Mapping[str, float], errors: Mapping[str, complex], x: np.ndarray, q: np.ndarray, tool: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return elbow ends (3, 2, 3), platform ends (3, 2, 3) and lengths (3, 2) of the rods, limb by limb, rod by rod."""
    b, a, L, l, c = (geometry[k] for k in ("base_radius", "platform_radius", "proximal_length", "distal_length", "c"))
    kind = np.result_type(x, q, *map(np.asarray, errors.values())) if errors else np.result_type(x, q)
    elbow, hand, length = np.zeros((3, 2, 3), kind), np.zeros((3, 2, 3), kind), np.zeros((3, 2), kind)
    R, P = cayley(x[3:]), x[:3]
    for i in range(3):
        e = {name.rsplit("_", 1)[0]: v for name, v in errors.items() if name.endswith(f"_{i + 1}")}
        get = lambda name, e=e: e.get(name, 0.0)  # noqa: E731
        frame = nominal_frame(i)
        joint = frame @ turned(get("alpha0"), get("beta0"), 0.0) @ turned(0.0, 0.0, q[i] + get("theta"))
        base = b * frame[:, 0] + np.array([get("ex"), get("ey"), get("ez")])
        alpha3, beta3 = get("alpha0") - get("alpha03"), get("beta0") - get("beta03")
        elbow_axis = turned(get("alpha2"), get("beta2"), 0.0)[:, 2]
        hand_axis = (frame @ turned(alpha3, beta3, 0.0))[:, 2]
        for j, side in enumerate((+1, -1)):
            elbow[i, j] = base + joint @ (np.array([L + get("L"), 0, 0]) + side * (c + get("dc")) / 2 * elbow_axis)
            hand[i, j] = P + R @ (a * frame[:, 0] + side * c / 2 * hand_axis - tool)
            length[i, j] = l + get("l") + side * get("dl") / 2
    return elbow, hand, length


def closure(
    geometry: Mapping[str, float], errors: Mapping[str, complex], x: np.ndarray, q: np.ndarray, tool: np.ndarray
) -> np.ndarray:
    """Return ``(|A - C|^2 - l^2) / 2`` of the six rods [mm^2]."""
    elbow, hand, length = rod_ends(geometry, errors, x, q, tool)
    d = hand - elbow
    return np.asarray(((d * d).sum(axis=2) - length**2).ravel() / 2)


def numbers(geometry: Mapping[str, np.ndarray]) -> dict[str, float]:
    """Return a robot's geometry as plain numbers."""
    return {k: float(v[0]) for k, v in geometry.items() if k != "limb_angle_deg"} | {
        "c": float(geometry["joint_spacing"][0])
    }
