"""An independent numerical machine of Mei et al. 2018: robot, measuring mechanism, procedure.

Written from the figure and the closure, not from the package: it decides the claims of the paper and serves as the
oracle of the product's machine. Lengths in mm, angles in rad, arrays over any leading axes.

Conventions that reproduce the paper's own figures: y points up and the platform hangs below the base (y < 0), limb 1
at +x, joints counter-clockwise from +x; the mechanism's vectors c and d of table 1 point *down*, (0, -79) and (0, -51);
the six positions run along the upper boundary and then along the lower one, both in the same direction.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]

EX, L, DISTAL = 80.0, 375.0, 825.0  # table 1
TOP, WIDTH, HEIGHT = 632.0, 480.0, 150.0  # H, b, h of the workspace
MECHANISM = np.array([0.0, -79.0 - 51.0])  # c + d
HOME = np.array([0.0, np.pi])
SCALE_SIGMA = (3 + 350 / 1000) * 1e-3 / 3  # eq. (34), mm
MOTOR_SIGMA = np.radians(4 / (20 * 1e4) * 360 / 3)  # eq. (35)
Q = np.array([[0.0, -1.0], [1.0, 0.0]])


@dataclass(frozen=True)
class Robot:
    """Errors of the source: actual minus nominal."""

    zero: Array = field(default_factory=lambda: np.zeros(2))  # (..., 2)
    base: Array = field(default_factory=lambda: np.zeros((2, 2)))  # (..., 2 limbs, 2)
    proximal: Array = field(default_factory=lambda: np.zeros(2))
    distal: Array = field(default_factory=lambda: np.zeros(2))


NOMINAL = Robot()
ZERO_OFFSETS = [(2.0, -1.0), (-1.0, 0.5), (0.5, 0.25)] * 2  # table 2, deg
BEFORE = [10.933, 5.482, 3.796, 10.896, 5.5195, 3.798]  # table 3
BEFORE_MAX = [12.906, 6.418, 4.672, 12.868, 6.455, 4.663]  # table 4
COMPENSATED = [(2.033, -0.957), (-1.049, 0.463), (0.536, 0.297), (2.024, -0.978), (-1.025, 0.474), (0.476, 0.225)]
DELTA = [(0.033, 0.043), (0.049, 0.037), (0.036, 0.047), (0.024, 0.022), (0.025, 0.026), (0.024, 0.025)]
AFTER = [0.402, 0.423, 0.434, 0.228, 0.256, 0.239]
AFTER_MAX = [0.493, 0.531, 0.533, 0.279, 0.314, 0.293]
TABLE_5 = np.array([(0.069, 0.040), (0.074, 0.045), (0.071, 0.042), (0.044, 0.022), (0.051, 0.028), (0.047, 0.024)])
MOUNTED = np.array([1.0, 0.5])  # the mechanism's error set in table 2


def group(number: int) -> Robot:
    """Source errors of simulation group 1 to 6 (table 2)."""
    scale = 1.0 if number <= 3 else 0.1
    return Robot(
        zero=np.radians(ZERO_OFFSETS[number - 1]),
        base=scale * np.array([[0.03, -0.02], [-0.02, 0.01]]),
        proximal=scale * np.array([0.01, 0.02]),
        distal=scale * np.array([-0.03, -0.02]),
    )


def centres(robot: Robot) -> Array:
    return np.array([[EX, 0.0], [-EX, 0.0]]) + robot.base


def forward(theta: Array, robot: Robot = NOMINAL) -> Array:
    """Position of P for the joint angles that the controller reports: the lower meeting point of two circles."""
    angle = np.asarray(theta) + robot.zero
    length, radius = L + robot.proximal, DISTAL + robot.distal
    elbow = centres(robot) + length[..., None] * np.stack([np.cos(angle), np.sin(angle)], -1)
    across = elbow[..., 1, :] - elbow[..., 0, :]
    distance = np.linalg.norm(across, axis=-1)
    along = (radius[..., 0] ** 2 - radius[..., 1] ** 2 + distance**2) / (2 * distance)
    off = np.sqrt(radius[..., 0] ** 2 - along**2)
    normal = np.stack([-across[..., 1], across[..., 0]], -1) / distance[..., None]
    down = -np.sign(normal[..., 1:])
    return elbow[..., 0, :] + along[..., None] * across / distance[..., None] + down * off[..., None] * normal


def inverse(p: Array, robot: Robot = NOMINAL) -> Array:
    """Joint angles (reported ones) that put P at p, elbows outwards: law of cosines."""
    arm = np.asarray(p)[..., None, :] - centres(robot)
    reach = np.linalg.norm(arm, axis=-1)
    length, radius = L + robot.proximal, DISTAL + robot.distal
    opening = np.arccos((length**2 + reach**2 - radius**2) / (2 * length * reach))
    bearing = np.arctan2(arm[..., 1], arm[..., 0])
    theta = bearing + np.array([1.0, -1.0]) * opening
    return np.mod(theta - robot.zero + np.pi / 2, 2 * np.pi) - np.pi / 2


def links(p: Array, robot: Robot = NOMINAL) -> tuple[Array, Array]:
    """Unit vectors u (proximal) and w (distal) of both limbs at p."""
    theta = inverse(p, robot) + robot.zero
    u = np.stack([np.cos(theta), np.sin(theta)], -1)
    length, radius = L + robot.proximal, DISTAL + robot.distal
    return u, (np.asarray(p)[..., None, :] - centres(robot) - length[..., None] * u) / radius[..., None]


def transfer(p: Array, complete: bool = False) -> Array:
    """Error transfer matrix at the nominal robot: (..., 2, 10) of eq. (12), or (..., 2, 2) of eq. (13)."""
    u, w = links(p)
    drive = np.einsum("...i,ij,...j->...", w, Q, u)
    if complete:
        block = np.zeros((*drive.shape[:-1], 2, 10))
        for i in range(2):
            own = [drive[..., i], w[..., i, 0], w[..., i, 1], np.sum(w[..., i, :] * u[..., i, :], -1)]
            block[..., i, 5 * i : 5 * i + 5] = np.stack([*own, np.ones_like(drive[..., i])], -1)
    else:
        block = drive[..., None] * np.eye(2)
    return np.asarray(np.linalg.solve(w, block))


def gauge_rows(p: Array, f: Array, complete: bool = False) -> Array:
    """g_k of eqs. (21) and (28): derivative of the mechanism's length with respect to the errors and its own."""
    unit = f / np.linalg.norm(f, axis=-1, keepdims=True)
    return np.concatenate([np.einsum("...i,...ij->...j", unit, transfer(p, complete)), -unit], -1)


def identification_matrix(p: Array, shift: Array | None = None, complete: bool = False) -> Array:
    """G (or G') of the adjacent positions p; `shift` is added to the mechanism's nominal vectors."""
    f = p - MECHANISM if shift is None else p - MECHANISM + shift
    return np.diff(gauge_rows(p, f, complete), axis=0)


def positions(n: int) -> Array:
    """n evenly spaced positions on the upper boundary, then n on the lower one, in the same direction."""
    x = np.linspace(-WIDTH / 2, WIDTH / 2, n)
    return np.concatenate([np.column_stack([x, np.full(n, -TOP)]), np.column_stack([x, np.full(n, -TOP - HEIGHT)])])


def boundary(step: float = 30.0) -> Array:
    """Positions every `step` mm along the boundary of the workspace (figure 11)."""
    x, y = np.arange(-WIDTH / 2, WIDTH / 2 + 1, step), np.arange(-TOP - HEIGHT, -TOP + 1, step)
    rows = [(a, b) for b in (-TOP, -TOP - HEIGHT) for a in x]
    return np.array(rows + [(a, b) for a in (x[0], x[-1]) for b in y[1:-1]])


def home_error(robot: Robot, compensated: Array | None = None) -> Array:
    """Distance between actual and nominal home position after the controller subtracts `compensated` (rad)."""
    taken = np.zeros(2) if compensated is None else compensated
    return np.asarray(np.linalg.norm(forward(HOME - taken, robot) - forward(HOME), axis=-1))


def position_errors(robot: Robot, p: Array, compensated: Array | None = None) -> Array:
    """Distance between actual and wanted position at each p, the nominal inverse commanding the joints."""
    taken = np.zeros(2) if compensated is None else np.asarray(compensated)[..., None, :]
    return np.asarray(np.linalg.norm(forward(inverse(p) - taken, robot) - p, axis=-1))


@dataclass(frozen=True)
class Noise:
    scale: float = SCALE_SIGMA
    motor: float = float(MOTOR_SIGMA)


@dataclass(frozen=True)
class Procedure:
    """What the paper's procedure did, for every seed and round."""

    compensated: Array  # (seeds, rounds + 1, 2) rad, before each round and after the last one
    mechanism: Array  # (seeds, rounds, 2) mm, sum of the identified errors after each round
    condition: Array  # (seeds, rounds)
    lengths: Array  # (seeds, rounds, positions), mm, as read

    def stopped(self, threshold: float) -> Array:
        """Rounds after which mu of eq. (32) is first below `threshold` (rad); all of them where it never is."""
        steps = np.diff(self.compensated, axis=1)
        mu = np.sqrt(np.mean(np.diff(steps, axis=1) ** 2, axis=-1))
        below = mu < threshold
        return np.where(below.any(axis=1), below.argmax(axis=1) + 2, steps.shape[1])


def procedure(
    robot: Robot,
    mounted: Array,
    rounds: int,
    rng: np.random.Generator | None,
    seeds: int = 1,
    noise: Noise | None = None,
    sign: float = -1.0,
    p: Array | None = None,
) -> Procedure:
    """The iterated identification of eqs. (28) to (33).

    `mounted` is the mechanism's error, (2,) or (seeds, 2); `sign` -1 corrects eq. (30) (f = f - dr), +1 is as printed.
    """
    p = positions(3) if p is None else p
    noise = Noise() if noise is None else noise
    theta, k = inverse(p), len(p)
    mounted = np.broadcast_to(mounted, (seeds, 2))
    taken = np.zeros((seeds, rounds + 1, 2))
    mechanism, condition = np.zeros((seeds, rounds, 2)), np.zeros((seeds, rounds))
    lengths = np.zeros((seeds, rounds, k))
    f = np.broadcast_to(p - MECHANISM, (seeds, k, 2)).copy()
    for j in range(rounds):
        reported = theta - taken[:, j, None, :]
        error = 0.0 if rng is None else noise.motor * rng.standard_normal((seeds, k, 2))
        read = np.linalg.norm(forward(reported + error, robot) - MECHANISM - mounted[:, None, :], axis=-1)
        lengths[:, j] = read if rng is None else read + noise.scale * rng.standard_normal((seeds, k))
        u, s, vt = np.linalg.svd(np.diff(gauge_rows(np.broadcast_to(p, f.shape), f), axis=1), full_matrices=False)
        gap = np.diff(lengths[:, j] - np.linalg.norm(f, axis=-1), axis=-1)
        found = np.einsum("sij,si->sj", vt, np.einsum("sij,si->sj", u, gap) / s)  # eq. (29)
        taken[:, j + 1] = taken[:, j] + found[:, :2] / L
        f = f + sign * found[:, None, 2:]
        mechanism[:, j] = (mechanism[:, j - 1] if j else 0.0) + found[:, 2:]
        condition[:, j] = s[:, 0] / s[:, -1]
    return Procedure(taken, mechanism, condition, lengths)


def joint_identification(
    done: Procedure,
    mechanism_prior: tuple[Array, float],
    geometry_sigma: float = 0.02,
    zero_sigma: float = np.radians(5.0),
    noise: Noise | None = None,
    p: Array | None = None,
    steps: int = 6,
) -> tuple[Robot, Array, Array]:
    """All rounds' differences at once, exact model, priors from tolerances: maximum a posteriori.

    Returns the robot's errors, the mechanism's (seeds, 2), and the covariance (seeds, 12, 12).
    Each difference of adjacent positions shares its middle reading with the next one, and the motor's error enters
    through the mechanism's own slope: both are in the weights.
    """
    p = positions(3) if p is None else p
    noise = Noise() if noise is None else noise
    seeds, rounds, k = done.lengths.shape
    theta = inverse(p) - done.compensated[:, :rounds, None, :]  # (seeds, rounds, k, 2)
    sigma = np.r_[np.full(2, zero_sigma), np.full(8, geometry_sigma), np.full(2, mechanism_prior[1])]
    expected = np.r_[np.zeros(10), mechanism_prior[0]]
    parameters = np.broadcast_to(expected, (seeds, 12)).copy()

    def robot(v: Array) -> Robot:
        return Robot(v[:, :2], v[:, 2:6].reshape(-1, 2, 2), v[:, 6:8], v[:, 8:10])

    def lengths(v: Array, shift: Array | None = None) -> Array:
        r = robot(v)
        wide = Robot(r.zero[:, None, None], r.base[:, None, None], r.proximal[:, None, None], r.distal[:, None, None])
        angle = theta if shift is None else theta + shift
        return np.asarray(np.linalg.norm(forward(angle, wide) - MECHANISM - v[:, None, None, 10:], axis=-1))

    steps_of = np.r_[np.full(2, 1e-6), np.full(10, 1e-4)]
    difference = np.diff(np.eye(k), axis=0)
    for _ in range(steps):
        columns = [(lengths(parameters + h) - lengths(parameters - h)) / (2 * h.sum()) for h in np.diag(steps_of)]
        jacobian = difference @ np.stack(columns, -1)  # (seeds, rounds, k - 1, 12)
        slope = [(lengths(parameters, h) - lengths(parameters, -h)) / 2e-6 for h in np.eye(2) * 1e-6]
        variance = noise.scale**2 + noise.motor**2 * np.sum(np.square(slope), axis=0)
        weight = np.linalg.inv((difference * variance[..., None, :]) @ difference.T)
        residual = (done.lengths - lengths(parameters)) @ difference.T
        normal = np.einsum("srai,srab,srbj->sij", jacobian, weight, jacobian) + np.diag(sigma**-2)
        right = np.einsum("srai,srab,srb->si", jacobian, weight, residual) + (expected - parameters) / sigma**2
        scale = sigma  # a unit per tolerance keeps the normal matrix well conditioned
        scaled = scale[:, None] * normal * scale
        parameters = parameters + scale * np.linalg.solve(scaled, (scale * right)[..., None])[..., 0]
    covariance = scale[:, None] * np.linalg.inv(scaled) * scale
    return robot(parameters), parameters[:, 10:], covariance
