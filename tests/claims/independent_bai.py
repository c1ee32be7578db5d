"""Bai 2015 written down from its text alone, in plain NumPy: the first-order model, the distances, the poses.

Nothing here comes from the package: what agrees with both has been derived twice. Lengths in mm, angles in rad. The
36 columns of models 42 and 36 are those of eqs. (6) and (7) as printed, in the units of Delta p: mm for Delta p_r, rad
(or 1) for Delta p_e.
"""

from __future__ import annotations

from itertools import combinations

import numpy as np

b, a, L, l, c, TOP, RADIUS, HEIGHT = 200.0, 51.0, 375.0, 950.0, 100.0, 728.0, 500.0, 250.0  # Table 1
HOME = np.array([0.0, 0.0, -TOP - HEIGHT / 2])

POSITION = ("theta", "ex", "ey", "ez", "L", "alpha0", "beta0", "l")  # Delta p_r,i
ORIENTATION = ("dl", "dc", "alpha03", "beta03", "alpha2", "beta2")  # Delta p_e,i
MODEL_42 = tuple(f"{n}_{i}" for names in (POSITION, ORIENTATION) for i in (1, 2, 3) for n in names)
GAUGE = ("ex_1", "ey_2", "ey_3", "ez_1", "ez_2", "ez_3")  # eq. (11)
DEPENDENT = ("alpha03_2", "alpha03_3", "beta03_3", "alpha2_3")  # below eq. (19)
MODEL_36 = tuple(n for n in MODEL_42 if n not in GAUGE)
MODEL_32 = tuple(n for n in MODEL_36 if n not in DEPENDENT)
MODEL_24 = MODEL_42[:24]
MODEL_18 = tuple(n for n in MODEL_24 if n not in GAUGE)
OFFSETS = ("theta_1", "theta_2", "theta_3")
POINTS = (np.array([0.0, 0.0, -60.0]), np.array([80.0, 30.0, -60.0]), np.array([-40.0, 70.0, -60.0]))  # of a reflector

PHI = -np.pi / 2 + 2 * np.pi * np.arange(3) / 3
U0 = np.column_stack([np.cos(PHI), np.sin(PHI), np.zeros(3)])
V0 = np.tile([0.0, 0.0, 1.0], (3, 1))
W0 = np.cross(U0, V0)


def joints(r: np.ndarray) -> np.ndarray:
    """Return theta (..., 3) of the nominal machine with its elbows outwards, NaN where it cannot reach."""
    d = np.asarray(r)[..., None, :] - (b - a) * U0
    x, z = (d * U0).sum(-1), d[..., 2]
    reach = ((d * d).sum(-1) + L**2 - l**2) / (2 * L)
    with np.errstate(invalid="ignore"):
        return np.asarray(np.arctan2(z, x) + np.arccos(reach / np.hypot(x, z)))


def frames(r: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return theta (..., 3) and the vectors u_1, v_1, l_hat (..., 3 limbs, 3) at the plate's position r."""
    theta = joints(r)
    cos, sin = np.cos(theta)[..., None], np.sin(theta)[..., None]
    u1, v1 = cos * U0 + sin * V0, -sin * U0 + cos * V0
    l_hat = (np.asarray(r)[..., None, :] - (b - a) * U0 - L * u1) / l
    return theta, u1, v1, l_hat


def matrices(r: np.ndarray, point: np.ndarray | None = None) -> tuple[np.ndarray, ...]:
    """Return A_rr, A_re, A_ee (..., 3, 3), B_r (..., 3, 24), B_e (..., 3, 18), B_m (..., 3, 3) of eqs. (6), (7), (22).

    `point` is the reference point in {O'}; its nominal position is r + point, and a_i counts from it.
    """
    theta, u1, v1, l_hat = frames(r)
    a_i = a * U0 - (0.0 if point is None else point)
    shape = np.shape(r)[:-1]
    A_re, A_ee = np.cross(np.broadcast_to(a_i, l_hat.shape), l_hat), np.cross(np.broadcast_to(W0, l_hat.shape), l_hat)
    lu0, lv0, lw0 = ((l_hat * x).sum(-1) for x in (U0, V0, W0))
    lu1, lv1 = (l_hat * u1).sum(-1), (l_hat * v1).sum(-1)
    one = np.ones_like(lw0)
    e = [l_hat[..., k] for k in range(3)]
    per_limb_r = np.stack([lv1, *e, lu1, lw0 * np.sin(theta), -lw0 * np.cos(theta), one], axis=-1)
    per_limb_e = np.stack([one, lw0, -lv0, lu0, -lv1, lu1], axis=-1)
    B_r, B_e, B_m = np.zeros((*shape, 3, 24)), np.zeros((*shape, 3, 18)), np.zeros((*shape, 3, 3))
    for i in range(3):
        B_r[..., i, 8 * i : 8 * i + 8] = per_limb_r[..., i, :]
        B_e[..., i, 6 * i : 6 * i + 6] = per_limb_e[..., i, :]
        B_m[..., i, i] = lv1[..., i]
    return l_hat, A_re, A_ee, B_r, B_e, B_m


def sensitivity(r: np.ndarray, point: np.ndarray | None = None) -> tuple[np.ndarray, np.ndarray]:
    """Return C_r (..., 3, 42) and C_e (..., 3, 18) of eqs. (8) and (9)."""
    A_rr, A_re, A_ee, B_r, B_e, _ = matrices(r, point)
    C_e = np.linalg.solve(A_ee, B_e)
    return np.concatenate([np.linalg.solve(A_rr, B_r), -np.linalg.solve(A_rr, A_re @ C_e)], axis=-1), C_e


def every_pair(n: int) -> list[tuple[int, int]]:
    return list(combinations(range(n), 2))


def H(
    r: np.ndarray,
    names: tuple[str, ...] = MODEL_36,
    points: tuple[np.ndarray | None, ...] = (None,),
    pairs: list[tuple[int, int]] | None = None,
) -> np.ndarray:
    """Return the identification matrix of eqs. (14)-(16): distances of pairs, one block per reference point."""
    i, j = np.array(every_pair(len(r)) if pairs is None else pairs).T
    n = (r[j] - r[i]) / np.linalg.norm(r[j] - r[i], axis=1, keepdims=True)
    blocks = []
    for point in points:
        C = sensitivity(r, point)[0][:, :, [MODEL_42.index(name) for name in names]]
        blocks.append(np.einsum("kx,kxp->kp", n, C[j] - C[i]))
    return np.vstack(blocks)


def ring(n: int, depth: float, start: float = 0.0, radius: float = RADIUS) -> np.ndarray:
    """Return n evenly spaced poses on a circle, `depth` (0 to 1) of the height below the top layer."""
    angle = start + 2 * np.pi * np.arange(n) / n
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.full(n, -TOP - depth * HEIGHT)])


def rough_poses(n: int, start: float = 0.0) -> np.ndarray:
    """Home and n poses on the rim of the middle layer (section 5.1)."""
    return np.vstack([HOME, ring(n, 0.5, start)])


def fine_poses(n: int, start: float = 0.0) -> np.ndarray:
    """Home and n poses on the rim of the top and the bottom layer (sections 3.3 and 5.2)."""
    return np.vstack([HOME, ring(n, 0.0, start), ring(n, 1.0, start)])


def scattered(n: int, rng: np.random.Generator) -> np.ndarray:
    """Return n poses anywhere in the workspace."""
    angle, radius = 2 * np.pi * rng.random(n), RADIUS * np.sqrt(rng.random(n))
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), -TOP - HEIGHT * rng.random(n)])


def rank(matrix: np.ndarray) -> int:
    """Return the rank with columns of unit length; asserts that no singular value is near the limit."""
    size = np.linalg.norm(matrix, axis=0)
    s = np.linalg.svd(matrix / np.where(size > 0, size, 1.0), compute_uv=False)
    found = int((s > 1e-9 * s[0]).sum())
    assert not ((s > 1e-12 * s[0]) & (s < 1e-8 * s[0])).any(), "no clear gap"
    return found


def forward(theta: np.ndarray) -> np.ndarray:
    """Return the exact position (..., 3) of the nominal machine with its arms at theta (..., 3): three spheres."""
    elbow = (b - a) * U0 + L * (np.cos(theta)[..., None] * U0 + np.sin(theta)[..., None] * V0)
    first, second, third = elbow[..., 0, :], elbow[..., 1, :], elbow[..., 2, :]
    normal = np.cross(second - first, third - first)
    area = (normal * normal).sum(-1, keepdims=True)
    p, q = second - first, third - first
    pp, qq = (p * p).sum(-1, keepdims=True), (q * q).sum(-1, keepdims=True)
    centre = (pp * np.cross(q, normal) + qq * np.cross(normal, p)) / (2 * area)  # of the circle through the elbows
    below = -np.sign(normal[..., 2:]) * normal / np.sqrt(area)
    depth = np.sqrt(l**2 - (centre * centre).sum(-1, keepdims=True))
    return np.asarray(first + centre + depth * below)


def distances(r: np.ndarray) -> np.ndarray:
    """Return the distances of all pairs of positions."""
    i, j = np.array(every_pair(len(r))).T
    return np.asarray(np.linalg.norm(r[j] - r[i], axis=1))


def relative(r: np.ndarray, displacement: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return first-order distance and volumetric errors of the poses after the first, relative to the first."""
    v = displacement[1:] - displacement[0]
    n = (r[1:] - r[0]) / np.linalg.norm(r[1:] - r[0], axis=1, keepdims=True)
    return (v * n).sum(axis=1), np.linalg.norm(v, axis=1)


def check_poses(start: float = 0.0) -> np.ndarray:
    """Home and the 96 poses of section 5.2: 16 on circles of radii 250 and 500 mm in three layers."""
    return np.vstack(
        [HOME, *(ring(16, depth, start, radius) for depth in (0.0, 0.5, 1.0) for radius in (250.0, 500.0))]
    )


def condition(matrix: np.ndarray, norm: str = "spectral") -> float:
    """Return the condition number, infinite below full rank; `norm` is spectral or frobenius."""
    s = np.linalg.svd(matrix, compute_uv=False)
    if len(s) < matrix.shape[1] or s[-1] < 1e-10 * s[0]:
        return np.inf
    return float(s[0] / s[-1] if norm == "spectral" else np.linalg.norm(s) * np.linalg.norm(1 / s))


def rule(kappa: dict[int, float], threshold: float = 0.01) -> int | None:
    """Return the least n that eq. (21) accepts."""
    with np.errstate(invalid="ignore"):
        return next((n for n in kappa if n - 1 in kappa and abs(1 - kappa[n - 1] / kappa[n]) <= threshold), None)


def kappas(model: str, norm: str, start: float) -> dict[int, float]:
    """Return the condition number against n, for rough calibration ("3") or model 18."""
    if model == "3":
        return {n: condition(H(rough_poses(n, start), OFFSETS), norm) for n in range(2, 13)}
    names, points = (MODEL_18, (None,)) if model == "18" else (MODEL_32, POINTS[:2])
    return {n: condition(H(fine_poses(n, start), names, points), norm) for n in range(3, 14)}


OFFSETS_FOUND = np.radians([0.911, 1.098, 1.441])  # section 5.1
TABLE_2 = {
    "before distance": (-3.405, -3.859, -2.863, -4.181, -2.663),
    "before volumetric": (3.769, 3.888, 3.163, 4.962, 2.975),
    "after distance": (0.025, -0.061, 0.008, 0.187, -0.011),
    "after volumetric": (0.309, 1.015, 0.961, 0.859, 1.047),
}
TABLE_3 = {
    "ex": (None, -0.201, 0.146),
    "ey": (0.114, None, None),
    "theta": (0.965, -0.034, -0.578),
    "L": (0.112, 0.101, 0.098),
    "alpha0": (-0.841, -0.546, 0.759),
    "beta0": (0.421, -0.764, 0.432),
    "l": (0.107, 0.157, 0.302),
}
TABLE_4 = {
    "ex": (None, -0.187, 0.174),
    "ey": (0.160, None, None),
    "theta": (1.107, -0.112, -0.941),
    "L": (0.919, 0.110, 0.122),
    "alpha0": (-0.707, -0.901, 0.872),
    "beta0": (0.636, -0.524, 0.497),
    "l": (0.114, 0.125, 0.193),
    "dl": (0.048, 0.052, 0.039),
    "dc": (-0.021, 0.014, -0.009),
    "alpha03": (-0.175, None, None),
    "beta03": (0.267, -0.242, None),
    "alpha2": (0.057, -0.017, None),
    "beta2": (-0.032, -0.047, 0.061),
}
TABLE_5 = {"A": (5.704, 6.361), "B": (0.682, 1.303), "C18": (0.167, 0.386), "C32": (0.134, 0.371)}


def entries(table: dict[str, tuple[float | None, ...]]) -> dict[str, float]:
    """Return a table's numbers by parameter [mm]."""
    return {f"{n}_{i}": v for n, row in table.items() for i, v in enumerate(row, start=1) if v is not None}


def vector(values: dict[str, float]) -> np.ndarray:
    """Return Delta p (42,) from a table's numbers: the tables multiply Delta p_e by c."""
    return np.array([values.get(n, 0.0) / (c if n.split("_")[0] in ORIENTATION else 1.0) for n in MODEL_42])
