"""The RoboTennis machine, camera and figures of Traslosheros 2013, in NumPy only: an oracle independent of the package.

Frames as in the paper: {O} at the base centre, z towards the effector, arm i at angle phi_i, a positive joint angle
turns the arm towards +z. Lengths in mm, angles in rad. Nothing here is shared with ``derive`` or ``deltacal_gen``.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

BALL = 19.0  # radius of the ball [mm], section 5.2


@dataclass(frozen=True)
class Machine:
    """Parameters of Table 1: one value per limb, and the home position of the effector."""

    a: np.ndarray
    b: np.ndarray
    h: np.ndarray
    theta0: np.ndarray
    p0: np.ndarray
    phi: np.ndarray
    H: np.ndarray

    def vector(self) -> np.ndarray:
        """U (15,): a b h theta0 limb by limb, then the home position."""
        return np.concatenate([np.column_stack([self.a, self.b, self.h, self.theta0]).ravel(), self.p0])

    def with_vector(self, U: np.ndarray) -> Machine:
        limbs = np.reshape(U[:12], (3, 4))
        return replace(self, a=limbs[:, 0], b=limbs[:, 1], h=limbs[:, 2], theta0=limbs[:, 3], p0=np.asarray(U[12:15]))

    @property
    def outward(self) -> np.ndarray:
        return np.column_stack([np.cos(self.phi), np.sin(self.phi), np.zeros(3)])


PHI = np.deg2rad([0.0, 120.0, 240.0])
NOMINAL = Machine(
    np.full(3, 500.0),
    np.full(3, 1000.0),
    np.full(3, 50.0),
    np.zeros(3),
    np.array([0, 0, 750.0]),
    PHI,
    np.full(3, 210.0),
)
CALIBRATED = Machine(
    np.array([500.89, 500.01, 499.96]),
    np.array([1002.86, 1001.37, 1001.28]),
    np.array([48.69, 49.96, 48.68]),
    np.deg2rad([0.316, 0.844, 0.936]),
    np.array([5.31, 0.31, 743.74]),
    PHI,
    np.full(3, 210.0),
)


def rods(machine: Machine, theta: np.ndarray, P: np.ndarray) -> np.ndarray:
    """C - B (N, 3 limbs, 3) at absolute joints (N, 3) and positions (N, 3): equations (2)."""
    u = machine.outward
    B = (machine.H + machine.a * np.cos(theta))[..., None] * u
    B[..., 2] = machine.a * np.sin(theta)
    return P[:, None] + machine.h[:, None] * u - B


def closure(machine: Machine, theta: np.ndarray, P: np.ndarray) -> np.ndarray:
    """Gamma (N, 3) [mm^2]: equation (1)."""
    return np.sum(rods(machine, theta, P) ** 2, axis=2) - machine.b**2


def inverse(machine: Machine, P: np.ndarray) -> np.ndarray:
    """Absolute joint angles (N, 3) with the arm on the outer side; NaN out of reach."""
    P = np.atleast_2d(P)
    u = machine.outward
    along = P @ u.T + machine.h - machine.H  # of the platform joint, from A_i outward
    across = np.column_stack([-np.sin(machine.phi), np.cos(machine.phi)])
    off = P[:, :2] @ across.T
    z = P[:, 2:3]
    with np.errstate(invalid="ignore"):
        k = (along**2 + z**2 + off**2 + machine.a**2 - machine.b**2) / (2 * machine.a)
        return np.arctan2(z, along) - np.arccos(k / np.hypot(along, z))


def forward(machine: Machine, theta: np.ndarray) -> np.ndarray:
    """Position (N, 3): the intersection of three spheres that lies towards +z."""
    theta = np.atleast_2d(theta)
    u = machine.outward
    centre = (machine.H - machine.h + machine.a * np.cos(theta))[..., None] * u
    centre[..., 2] = machine.a * np.sin(theta)
    # Differences of the spheres are linear in P: P = foot + t * normal.
    A = 2 * (centre[:, 1:] - centre[:, :1])
    square = np.sum(centre**2, axis=2) - machine.b**2
    rhs = square[:, 1:] - square[:, :1]
    foot = np.einsum("nij,nj->ni", np.linalg.pinv(A), rhs)
    normal = np.cross(A[:, 0], A[:, 1])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    normal *= np.sign(normal[:, 2:])
    d = foot - centre[:, 0]
    half = np.sum(d * normal, axis=1)
    t = -half + np.sqrt(half**2 - np.sum(d**2, axis=1) + machine.b[0] ** 2)
    return foot + t[:, None] * normal


def jacobian(machine: Machine, theta: np.ndarray, P: np.ndarray) -> np.ndarray:
    """J_R (N, 3, 3) of r' = J_R q' [mm/rad]: equation (24), from the closure by the implicit function theorem."""
    s = rods(machine, theta, P)
    tip = machine.a[:, None] * np.stack(
        [
            -np.sin(theta) * np.cos(machine.phi),
            -np.sin(theta) * np.sin(machine.phi),
            np.cos(theta),
        ],
        axis=-1,
    )
    pull = np.einsum("nlk,nlk->nl", s, tip)  # s . dB/dtheta
    return np.linalg.solve(s, np.eye(3) * pull[:, None, :])


def observation(machine: Machine, joints: np.ndarray, shift: np.ndarray, *, extra: bool = False) -> np.ndarray:
    """J (3 K, 15): equation (7), rows limb by limb; with `extra` the six columns of phi_i and H_i follow."""
    theta, P = machine.theta0 + joints, machine.p0 + shift
    s, u, K = rods(machine, theta, P), machine.outward, len(joints)
    columns = 21 if extra else 15
    J = np.zeros((3, K, columns))
    for i in range(3):
        e, tangent = u[i], np.array([-u[i, 1], u[i, 0], 0.0])
        arm = np.cos(theta[:, i, None]) * e + np.sin(theta[:, i, None]) * [0, 0, 1]
        swing = -np.sin(theta[:, i, None]) * e + np.cos(theta[:, i, None]) * [0, 0, 1]
        J[i, :, 4 * i] = -2 * np.sum(s[:, i] * arm, axis=1)
        J[i, :, 4 * i + 1] = -2 * machine.b[i]
        J[i, :, 4 * i + 2] = 2 * s[:, i] @ e
        J[i, :, 4 * i + 3] = -2 * machine.a[i] * np.sum(s[:, i] * swing, axis=1)
        J[i, :, 12:15] = 2 * s[:, i]
        if extra:
            reach = machine.h[i] - machine.H[i] - machine.a[i] * np.cos(theta[:, i])
            J[i, :, 15 + i] = 2 * reach * (s[:, i] @ tangent)
            J[i, :, 18 + i] = -2 * s[:, i] @ e
    return J.reshape(3 * K, columns)


def gauss_newton(
    start: Machine, joints: np.ndarray, shift: np.ndarray, iterations: int = 30
) -> tuple[Machine, list[float]]:
    """Equation (8) without its '= 0', and the rms of the closure [mm^2] before each step."""
    U, history = start.vector(), []
    for _ in range(iterations):
        machine = start.with_vector(U)
        F = closure(machine, machine.theta0 + joints, machine.p0 + shift).T.ravel()
        history.append(float(np.sqrt(np.mean(F**2))))
        J = observation(machine, joints, shift)
        scale = np.linalg.norm(J, axis=0)
        step = np.linalg.lstsq(J / scale, -F, rcond=1e-13)[0] / scale
        U = U + step
        if np.max(np.abs(step * scale)) < 1e-9:
            break
    return start.with_vector(U), history


def closed(machine: Machine) -> Machine:
    """The machine with its home position where its own home angles put it."""
    return replace(machine, p0=forward(machine, machine.theta0)[0])


def cylinder(radius: float, bottom: float, top: float, n: int = 9) -> np.ndarray:
    """Points on and in a cylinder about z."""
    z, r, t = np.meshgrid(
        np.linspace(bottom, top, n), np.linspace(0, radius, 5), np.linspace(0, 2 * np.pi, 24, endpoint=False)
    )
    return np.column_stack([(r * np.cos(t)).ravel(), (r * np.sin(t)).ravel(), z.ravel()])


def workspace_points(n: int, rng: np.random.Generator, machine: Machine = NOMINAL) -> np.ndarray:
    """Random positions (n, 3) of a cylinder of radius 300 mm and height 400 mm that the machine reaches."""
    r, t = 300 * np.sqrt(rng.uniform(0, 1, n)), rng.uniform(0, 2 * np.pi, n)
    return np.column_stack([r * np.cos(t), r * np.sin(t), rng.uniform(600, 1000, n)])


def increments(machine: Machine, P: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Theta_k and Pi_k of equation (3) for absolute positions P."""
    return inverse(machine, P) - machine.theta0, P - machine.p0


def velocity_error(true: Machine, assumed: Machine, P: np.ndarray, *, at: str) -> np.ndarray:
    """Largest singular value (N,) of J_C J_N^-1 - I (equation (28)) at true positions P.

    `at` says where the assumed Jacobian is taken: "position", the same P, or "joints", what the assumed machine makes
    of the same motor readings.
    """
    theta = inverse(true, P)
    J = jacobian(true, theta, P)
    if at == "position":
        Q = P
        angle = inverse(assumed, P)
    else:
        angle = theta - true.theta0 + assumed.theta0
        Q = forward(assumed, angle)
    return np.linalg.norm(J @ np.linalg.inv(jacobian(assumed, angle, Q)) - np.eye(3), ord=2, axis=(1, 2))


# The camera: a sphere's cone of tangents cut by the plane z = 1.


def conic(centre: np.ndarray, radius: float) -> np.ndarray:
    """Q (3, 3) with d^T Q d = 0 for the directions d that touch the sphere."""
    return np.outer(centre, centre) - (centre @ centre - radius**2) * np.eye(3)


@dataclass(frozen=True)
class Ellipse:
    """Image of a sphere in the plane z = 1: centre, semi-axes, direction of the major axis."""

    centre: np.ndarray
    major: float
    minor: float
    direction: np.ndarray

    def points(self, n: int = 3600) -> np.ndarray:
        t = np.linspace(0, 2 * np.pi, n, endpoint=False)
        across = np.array([-self.direction[1], self.direction[0]])
        return self.centre + self.major * np.cos(t)[:, None] * self.direction + self.minor * np.sin(t)[:, None] * across


def ellipse(centre: np.ndarray, radius: float = BALL) -> Ellipse:
    """The image from the eigenvectors of its conic, no formula of the paper in it."""
    Q = -conic(centre, radius)
    A, v, c = Q[:2, :2], Q[:2, 2], Q[2, 2]
    middle = -np.linalg.solve(A, v)
    level = -(c + v @ middle)
    value, axes = np.linalg.eigh(A)
    semi = np.sqrt(level / value)  # ascending eigenvalues: the major axis first
    return Ellipse(middle, float(semi[0]), float(semi[1]), axes[:, 0])


def extremes(centre: np.ndarray, radius: float = BALL) -> tuple[np.ndarray, np.ndarray]:
    """Largest and smallest x and y of the image: ((2,), (2,)), by the dual conic."""
    D = np.linalg.inv(conic(centre, radius))
    out = []
    for k in (0, 1):
        # Lines x = t, that is (1, 0, -t) D (1, 0, -t)^T = 0.
        t = np.roots([D[2, 2], -2 * D[k, 2], D[k, k]])
        out.append(np.sort(t)[::-1])
    return out[0], out[1]


def from_extremes(alpha: np.ndarray, beta: np.ndarray, radius: float = BALL) -> np.ndarray:
    """Centre of the sphere by least squares on equations (12) and (16)."""
    A = np.array([[-1, 0, alpha[0]], [1, 0, -alpha[1]], [0, -1, beta[0]], [0, 1, -beta[1]]])
    rhs = radius * np.sqrt(1 + np.array([alpha[0], alpha[1], beta[0], beta[1]]) ** 2)
    return np.linalg.lstsq(A, rhs, rcond=None)[0]


def chords(image: Ellipse) -> tuple[np.ndarray, np.ndarray]:
    """Ends of the horizontal and vertical chord through the centre of the image (section 5.3)."""
    u = image.direction
    shape = np.outer(u, u) / image.major**2 + (np.eye(2) - np.outer(u, u)) / image.minor**2
    half = 1 / np.sqrt(np.diag(shape))
    sign = np.array([1.0, -1.0])
    return image.centre[0] + sign * half[0], image.centre[1] + sign * half[1]


def repeatability(points: np.ndarray) -> float:
    """RP of the appendix."""
    gap = np.linalg.norm(points - points.mean(axis=0), axis=1)
    return float(gap.mean() + 3 * gap.std(ddof=1))
