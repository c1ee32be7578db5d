"""Savoure 2006 written down by hand: the Delta with 51 errors and the planar parallelogram, without the package.

Plain NumPy. Exact machines (closure, Newton) stand beside the paper's linear models, so that each decides the other.
Lengths in mm, angles in rad.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

# ------------------------------------------------------------------------------------------------- the complete Delta

THETA = np.deg2rad([60.0, 180.0, 300.0])
RODS = tuple((i, j) for i in range(3) for j in range(2))
NAMES = (
    *(f"{name}_{i + 1}{j + 1}" for i, j in RODS for name in ("bx", "by", "bz", "ax", "ay", "az", "l")),
    *(f"beta{axis}_{i + 1}" for i in range(3) for axis in "xyz"),
)
SCALE = np.array([1.0 / 300.0 if name.startswith("beta") else 1.0 for name in NAMES])  # a millimetre at 300 mm


def cross_matrix(v: np.ndarray) -> np.ndarray:
    """Return the paper's hat: ``cross_matrix(v) @ w == np.cross(v, w)``."""
    return np.array([[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]])


def turned(v: np.ndarray) -> np.ndarray:
    """Return the rotation by a rotation vector."""
    angle = np.linalg.norm(v)
    if angle == 0.0:
        return np.eye(3)
    K = cross_matrix(v / angle)
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


def P(limb: int) -> np.ndarray:
    """Eq. (10): columns u, v, z of the local basis; u is the axis of the actuator."""
    c, s = np.cos(THETA[limb]), np.sin(THETA[limb])
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def Q(q: float) -> np.ndarray:
    """Eq. (11): the turn about u by the joint angle; positive lifts an arm that points along v."""
    c, s = np.cos(q), np.sin(q)
    return np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])


@dataclass(frozen=True)
class Delta:
    """The paper gives no dimensions: these are a common industrial machine's."""

    base: float = 200.0
    platform: float = 51.0
    arm: float = 375.0
    rod: float = 950.0
    spacing: float = 100.0
    tool: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def nominal(self, limb: int, rod: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Return P_i in the base, A_ij from P_i in the arm's basis, B_ij from C in the platform."""
        side = self.spacing / 2 * (1, -1)[rod]
        frame = P(limb)
        centre_to_rod = frame @ np.array([side, self.platform, 0.0]) - np.array(self.tool)
        return self.base * frame[:, 1], np.array([side, self.arm, 0.0]), centre_to_rod

    def rods(
        self, pose: np.ndarray, q: np.ndarray, errors: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
        """Return closure (6,), rods A_ijB_ij, levers C to B_ij and elbows P_i to A_ij, (6, 3), with finite errors.

        The closure is ``(|A_ij B_ij|^2 - l_ij^2) / 2``, eq. (2). `pose` is the position of C and the rotation vector
        of the platform. ``delta b`` stands for eq. (13), ``delta b - delta p``, and acts at the platform.
        """
        R = turned(pose[3:])
        closure, rod, lever, elbow = np.empty(6), np.empty((6, 3)), np.empty((6, 3)), np.empty((6, 3))
        arms = [turned(errors[42 + 3 * i : 45 + 3 * i]) @ P(i) @ Q(q[i]) for i in range(3)]
        for n, (i, j) in enumerate(RODS):
            db, da, dl = errors[7 * n : 7 * n + 3], errors[7 * n + 3 : 7 * n + 6], errors[7 * n + 6]
            p, a, b = self.nominal(i, j)
            lever[n], elbow[n] = R @ (b + db), arms[i] @ (a + da)
            rod[n] = pose[:3] + lever[n] - p - elbow[n]
            closure[n] = (rod[n] @ rod[n] - (self.rod + dl) ** 2) / 2
        return closure, rod, lever, elbow

    def forward(self, q: np.ndarray, errors: np.ndarray, near: np.ndarray) -> np.ndarray:
        """Return the pose (6,) at given joints. The platform turns little, so its rotation vectors nearly add."""
        pose = np.array(near, dtype=float)
        for _ in range(50):
            closure, rod, lever, _ = self.rods(pose, q, errors)
            change = np.linalg.solve(np.hstack([rod, np.cross(lever, rod)]), -closure)
            pose += change
            if np.abs(change[:3]).max() < 1e-10 and np.abs(change[3:]).max() < 1e-13:
                break
        return pose

    def inverse(self, position: np.ndarray, errors: np.ndarray | None = None) -> np.ndarray:
        """Return the joints that bring C to `position`: eq. (29) without errors, eq. (27) with them, both exact."""
        q, alpha = np.array([self._limb(position, i) for i in range(3)]), np.zeros(3)
        for _ in range(0 if errors is None else 50):
            assert errors is not None
            closure, rod, lever, elbow = self.rods(np.concatenate([position, alpha]), q, errors)
            J = np.zeros((6, 6))
            J[:, 3:] = np.cross(lever, rod)
            for n, (i, _) in enumerate(RODS):
                J[n, i] = -rod[n] @ np.cross(turned(errors[42 + 3 * i : 45 + 3 * i]) @ P(i)[:, 0], elbow[n])
            change = np.linalg.solve(J, -closure)
            q, alpha = q + change[:3], alpha + change[3:]
            if np.abs(change).max() < 1e-13:
                break
        return q

    def _limb(self, position: np.ndarray, limb: int) -> float:
        d = P(limb).T @ (position - np.array(self.tool))
        across, out, up = d[0], d[1] + self.platform - self.base, d[2]
        reach = (across**2 + out**2 + up**2 + self.arm**2 - self.rod**2) / (2 * self.arm)
        turn, half = np.arctan2(up, out), np.arccos(reach / np.hypot(out, up))
        both = [(turn + s * half + np.pi) % (2 * np.pi) - np.pi for s in (1, -1)]
        return float(max(both, key=np.cos))  # the elbow outside

    def matrices(self, position: np.ndarray, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return J_X (6, 6) of eq. (18) and J_kC (6, 51) of eq. (19), from eq. (5) with the signs that it gives."""
        J_X, J_kC = np.zeros((6, 6)), np.zeros((6, 51))
        for n, (i, j) in enumerate(RODS):
            p, a, b = self.nominal(i, j)
            R = P(i) @ Q(q[i])
            PA = R @ a
            AB = position + b - p - PA
            J_X[n] = np.concatenate([AB, AB @ cross_matrix(-b)])
            J_kC[n, 7 * n : 7 * n + 7] = np.concatenate([-AB, AB @ R, [self.rod]])
            J_kC[n, 42 + 3 * i : 45 + 3 * i] = AB @ cross_matrix(-PA)
        return J_X, J_kC

    def sensitivity(self, position: np.ndarray, q: np.ndarray) -> np.ndarray:
        """Eq. (22), (6, 51)."""
        return np.linalg.solve(*self.matrices(position, q))

    def joint_matrix(self, position: np.ndarray, q: np.ndarray) -> np.ndarray:
        """J_S^m (3, 3): joint rates per rate of the TCP, the platform not turning."""
        rows = []
        for i in range(3):
            p, a, b = self.nominal(i, 0)
            arm = P(i) @ Q(q[i]) @ a
            AB = position + b - p - arm
            rows.append(AB / (AB @ np.cross(P(i)[:, 0], arm)))
        return np.array(rows)

    def positions(self, n: int, seed: int = 0) -> np.ndarray:
        """Return TCP positions (n, 3) drawn over the workspace."""
        rng = np.random.default_rng(seed)
        radius, turn = 450.0 * np.sqrt(rng.random(n)), 2 * np.pi * rng.random(n)
        height = rng.uniform(-1050.0, -800.0, n)
        return np.column_stack([radius * np.cos(turn), radius * np.sin(turn), height]) + np.array(self.tool)

    def global_sensitivity(self, n: int, seed: int = 0) -> np.ndarray:
        """S_G of eq. (24), (n, 6, 51)."""
        return np.array([self.sensitivity(x, self.inverse(x)) for x in self.positions(n, seed)])

    # what no measurement sees, in closed form; every row is a direction of the 51 errors

    def unseen_by_pose(self) -> dict[str, np.ndarray]:
        """Nine directions that move neither TCP nor platform to first order."""
        out = {}
        for i in range(3):
            u = P(i)[:, 0]
            v = np.zeros(51)
            v[42 + 3 * i : 45 + 3 * i] = u
            for j in range(2):
                v[7 * (2 * i + j) + 3 : 7 * (2 * i + j) + 6] = -np.cross([1.0, 0.0, 0.0], self.nominal(i, j)[1])
            out[f"joint offset {i + 1}: the arm turned about its own axis, its two joints turned back"] = v
        for n, (i, j) in enumerate(RODS):
            v = np.zeros(51)
            v[7 * n : 7 * n + 3], v[7 * n + 3] = P(i)[:, 0], 1.0
            out[f"rod {i + 1}{j + 1} shifted at both ends along the joint axis"] = v
        return out

    def unseen_by_position(self) -> dict[str, np.ndarray]:
        """Four more that turn the platform and leave the TCP: a constant turn, and one about the line O to TCP."""
        out = {}
        for axis, w in zip("xyz", np.eye(3), strict=True):
            v = np.zeros(51)
            for n, (i, j) in enumerate(RODS):
                v[7 * n : 7 * n + 3] = np.cross(w, self.nominal(i, j)[2])
            out[f"the points B turned in the platform about the TCP, {axis}"] = v
        v = np.zeros(51)
        for n, (i, j) in enumerate(RODS):
            p, a, b = self.nominal(i, j)
            v[7 * n : 7 * n + 3], v[7 * n + 5] = np.cross(b, p), -self.arm * a[0]
            v[42 + 3 * i : 45 + 3 * i] = -(b - a[0] * P(i)[:, 0])
        out["the platform turned about the line from O to the TCP, in proportion to its length"] = v
        return out

    def unseen_by_orientation(self) -> dict[str, np.ndarray]:
        """Twenty-four more that move the TCP and do not turn the platform: what both rods of a limb share."""
        out = {}
        for i in range(3):
            limb = f"limb {i + 1}: "
            for k, name in enumerate(("bx", "by", "bz", "ax", "ay", "az", "l")):
                if name != "ax":  # along the axis a and b are one direction already
                    v = np.zeros(51)
                    v[[14 * i + k, 14 * i + 7 + k]] = 1.0
                    out[f"{limb}{name} of both rods alike"] = v
            for name, axis in (("v", P(i)[:, 1]), ("z", P(i)[:, 2])):
                v = np.zeros(51)
                v[42 + 3 * i : 45 + 3 * i] = axis
                for j in range(2):
                    n, side = 2 * i + j, self.nominal(i, j)[1][0]
                    v[7 * n : 7 * n + 3] = np.cross(axis, side * P(i)[:, 0])
                out[f"{limb}the axis turned about {name}, the points B of its rods likewise"] = v
        return out


DELTA = Delta(tool=(30.0, 20.0, -100.0))


def rank(matrix: np.ndarray, scale: np.ndarray) -> tuple[int, float]:
    """Return the rank of (M, n) with its columns scaled, and the gap: last singular value kept over first dropped."""
    s = np.linalg.svd(matrix * scale, compute_uv=False)
    kept = int((s > 1e-9 * s[0]).sum())
    return kept, float(s[kept - 1] / max(s[kept], 1e-300)) if kept < len(s) else np.inf


# ------------------------------------------------------------------------------------------ the planar parallelogram

PLANAR = ("q0", "a1x", "a2x", "a2y", "b1x", "b2x", "b2y", "l1", "l2")  # eq. (40)
DEG = np.pi / 180.0
NOMINAL = np.array([0.0, 125.0, 125.0, 0.0, 125.0, 125.0, 0.0, 950.0, 950.0])  # Table 2
ERRORS = np.array([0.01 * DEG, 1.0, 0.0, 3.0, 0.0, -2.0, 0.0, 1.0, -1.0])
BASE = ("q0", "a2x", "a2y", "b1x", "l1", "l2")  # eq. (73)
CONFIGURATIONS = np.arange(-45.0, 46.0, 5.0) * DEG
CHECK = np.arange(-45.0, 46.0, 1.0) * DEG
LENGTHS = (0.0, 100.0, 200.0)  # of the tool
SIGMA = np.array([0.003, 0.003, 0.003 * DEG])


def turn(angle: float) -> np.ndarray:
    """Return the planar rotation."""
    return np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])


def planar_pose(q: float, k: np.ndarray, h: float, start: float = 0.0) -> np.ndarray:
    """Return x, y of C and the platform's angle (3,), by Newton's method on the closed chain."""
    q0, a1x, a2x, a2y, b1x, b2x, b2y, l1, l2 = k
    B1 = np.array([-a1x + l1 * np.sin(q + q0), -l1 * np.cos(q + q0)])
    alpha, hand = start, np.array([b1x + b2x, b2y])
    for _ in range(50):
        rod = B1 + turn(alpha) @ hand - np.array([a2x, a2y])
        slope = rod @ turn(alpha + np.pi / 2) @ hand
        change = -(rod @ rod - l2**2) / 2 / slope
        alpha += change
        if abs(change) < 1e-15:
            break
    return np.array([*(B1 + turn(alpha) @ np.array([b1x, -h])), alpha])


def planar_closed_form(q: float | np.ndarray, k: np.ndarray, h: float) -> np.ndarray:
    """Eqs. (42)-(52) as the derivation gives them: G without h, its sign in I, the branch of a parallelogram."""
    q0, a1x, a2x, a2y, b1x, b2x, b2y, l1, l2 = k
    t = q + q0
    E, E_ = (l1 * np.sin(t) - (a1x + a2x)) / l2, (l1 * np.cos(t) + a2y) / l2
    F, G = (b1x + b2x) / l2, -b2y / l2
    gamma_b, l_b = np.arctan2(a2y, a1x + a2x), np.hypot(a1x + a2x, a2y)
    gamma_p, l_p = np.arctan2(b2y, b1x + b2x), np.hypot(b1x + b2x, b2y)
    I = (l_b**2 - l_p**2 + l1**2 - l2**2 + 2 * l_b * l1 * np.sin(gamma_b - t)) / (2 * l_p * l2)
    I += F * np.cos(gamma_p) - G * np.sin(gamma_p)
    D = np.sqrt(E**2 + E_**2 - I**2)
    alpha = np.arctan2(E_ * I + E * D, -E * I + E_ * D) - gamma_p
    x = -a1x + l1 * np.sin(t) + b1x * np.cos(alpha) + h * np.sin(alpha)
    y = -l1 * np.cos(t) + b1x * np.sin(alpha) - h * np.cos(alpha)
    return np.stack([x, y, alpha], axis=-1)


def planar_matrices(q: float, h: float, k: np.ndarray = NOMINAL, *, printed: bool = False) -> tuple[np.ndarray, ...]:
    """Return J_X (3, 3) and J_kC (3, 9), eqs. (64) and (65); `printed` gives the third row of (65) as the paper has it.

    The derivation's third row is ``v1 . (dB1 - dA1) = l dq0``: the point A1 moves too.
    """
    u, v = np.sin(q + k[0]), -np.cos(q + k[0])
    b1, b2, length = k[4], k[5], k[7]
    J_X = np.array([[u, v, -u * h - v * b1], [u, v, -u * h + v * b2], [-v, u, v * h - u * b1]])
    third = [-length, 0, 0, 0, -v, 0, 0, 0, 0] if printed else [length, v, 0, 0, -v, 0, 0, 0, 0]
    J_k = np.array([[0, -u, 0, 0, u, 0, 0, 1, 0], [0, 0, u, v, 0, -u, -v, 0, 1], third], dtype=float)
    return J_X, J_k


def planar_sensitivity(q: float, h: float, *, printed: bool = False) -> np.ndarray:
    """Eq. (67), (3, 9)."""
    return np.linalg.solve(*planar_matrices(q, h, printed=printed))


def planar_inverse(x: float | np.ndarray, k: np.ndarray, h: float) -> np.ndarray:
    """Return the joint that brings C to `x`, exactly: eq. (27)."""
    q = np.arcsin(x / k[7]) - k[0]
    for _ in range(50):
        e = 1e-6
        slope = (planar_closed_form(q + e, k, h)[..., 0] - planar_closed_form(q - e, k, h)[..., 0]) / (2 * e)
        change = (x - planar_closed_form(q, k, h)[..., 0]) / slope
        q = q + change
        if np.abs(change).max() < 1e-14:
            break
    return np.asarray(q)


@dataclass(frozen=True)
class Study:
    """What remains at the TCP over the check angles [mm], and what was identified."""

    none: np.ndarray
    classical: np.ndarray
    improved: np.ndarray
    exact: np.ndarray
    base: np.ndarray
    simplified: np.ndarray


def study(
    h: float,
    rng: np.random.Generator | None,
    *,
    configurations: np.ndarray = CONFIGURATIONS,
    errors: np.ndarray = ERRORS,
    noise: float = 1.0,
    base: Sequence[str] = BASE,
    printed: bool = False,
) -> Study:
    """Section III.B: simulate, identify, compensate; without calibration, classical, improved, and exact.

    Exact means: the closed form itself fitted to the same readings, all nine errors with their tolerances as priors
    (what the six base parameters leave out is unseen only to first order), and inverted without approximation.
    """
    true, columns = NOMINAL + errors, [PLANAR.index(name) for name in base]
    readings = planar_closed_form(configurations, true, h)
    if rng is not None:
        readings = readings + noise * SIGMA * rng.standard_normal(readings.shape)
    nominal = planar_closed_form(configurations, NOMINAL, h)

    S = np.array([planar_sensitivity(q, h, printed=printed)[:, columns] for q in configurations])
    found = np.linalg.lstsq(S.reshape(-1, len(columns)), (readings - nominal).ravel(), rcond=None)[0]
    H = np.column_stack([NOMINAL[7] * np.cos(configurations), np.sin(configurations)])  # eq. (38)
    dq0, dl = np.linalg.lstsq(H, (readings - nominal)[:, 0], rcond=None)[0]

    k, tolerance = NOMINAL.copy(), np.where(np.arange(9) == 0, 0.1 * DEG, 3.0)
    for _ in range(12):
        now = planar_closed_form(configurations, k, h)
        J = np.empty((*now.shape, 9))
        for c, e in enumerate(np.eye(9) * 1e-6):
            both = [planar_closed_form(configurations, k + s * e, h) for s in (1, -1)]
            J[..., c] = (both[0] - both[1]) / 2e-6
        rows = np.vstack([(J / SIGMA[:, None]).reshape(-1, 9), np.diag(1 / tolerance)])
        rest = np.concatenate([((readings - now) / SIGMA).ravel(), (NOMINAL - k) / tolerance])
        step = np.linalg.lstsq(rows, rest, rcond=None)[0]
        k += step
        if np.abs(step).max() < 1e-9:
            break

    x = NOMINAL[7] * np.sin(CHECK)

    def remaining(joints: np.ndarray) -> np.ndarray:
        return planar_closed_form(joints, true, h)[:, 0] - x

    predicted = np.array([planar_sensitivity(q, h, printed=printed)[0, columns] @ found for q in CHECK])
    return Study(
        none=remaining(CHECK),
        classical=remaining(np.arcsin(x / (NOMINAL[7] + dl)) - dq0),
        improved=remaining(CHECK - predicted / (NOMINAL[7] * np.cos(CHECK))),
        exact=remaining(planar_inverse(x, k, h)),
        base=found,
        simplified=np.array([dq0, dl]),
    )
