"""Machines as open trees in MuJoCo, an engine made by others, whose inverse dynamics give the forces on every body.

A machine that closes loops is written down by hand (`Linkage`): where its arms turn or slide, where their rods end, and
what weighs. Every arm is a body on its joint, every rod and the platform a body of its own. How these bodies move with
the joints is found numerically: the loops are closed by Newton's method, derivatives by time and by joints are central
differences of what the engine calls positions. Virtual work along them makes the engine's forces torques of the joints.

Nothing of `deltacal_gen` is imported here. In: mm, rad, kg, s. Inside, as the engine has it: m, N m, N.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

Array = np.ndarray
POINT = 1e-12  # kg m^2: the engine asks every body for an inertia; that of a point is far below what torques tell
FIRST = {1: 4 / 5, 2: -1 / 5, 3: 4 / 105, 4: -1 / 280}  # central differences of eighth order
SECOND = {1: 8 / 5, 2: -1 / 5, 3: 8 / 315, 4: -1 / 560}
STEP, STEP_MM = 2e-3, 4.0  # s, and of a joint rad; of one that slides


@dataclass
class Linkage:
    """A platform on limbs, all in {O} [mm] at joints zero.

    Parameters
    ----------
    joint, axis : (limbs, 3) arrays
        A point of each joint, and the line about which it turns or along which it slides.
    slides : bool
    elbows : (limbs, rods, 3) array
        Rods' ends on the arms.
    hands : (limbs, rods, 3) array
        Their other ends, in the platform's frame, whose origin is the reference point.
    lengths : (limbs, rods) array
    centre : (3,) array
        Of the platform's mass, in its frame.
    arms : sequence of (mass, centre, inertia)
        Of each arm [kg], its centre [mm] and its inertia about that, across the line from the joint [kg mm^2].
    rod, platform : float
        Masses [kg].
    gravity : (3,) array
    turns : bool
        Whether the platform can turn; else it moves in the plane z = 0.
    """

    joint: Array
    axis: Array
    slides: bool
    elbows: Array
    hands: Array
    lengths: Array
    centre: Array
    arms: Sequence[tuple[float, Array, float]]
    rod: float
    platform: float
    gravity: Array
    turns: bool = True

    def rods(self, q: Array, x: Array) -> tuple[Array, Array]:
        """Return both ends of all rods (N, limbs, rods, 3) for joints (N, limbs) and the platform (N, 6)."""
        arm = self.elbows - self.joint[:, None]
        if self.slides:
            elbow = self.elbows + (q[..., None] * self.axis)[:, :, None]
        else:
            turn = Rotation.from_rotvec((q[..., None] * self.axis).reshape(-1, 3)).as_matrix().reshape(*q.shape, 3, 3)
            elbow = self.joint[:, None] + np.einsum("niab,ijb->nija", turn, arm)
        R = Rotation.from_rotvec(x[:, 3:]).as_matrix()
        return elbow, x[:, None, None, :3] + np.einsum("nab,ijb->nija", R, self.hands)

    def closed(self, q: Array, x: Array) -> Array:
        """Return the platform (N, 6), position and rotation vector, that closes the loops, near x."""
        free = [0, 1, 2, 3, 4, 5] if self.turns else [0, 1]
        x = x.copy()
        for _ in range(50):
            elbow, hand = self.rods(q, x)
            rod = hand - elbow
            F = ((rod**2).sum(axis=3) - self.lengths**2).reshape(len(q), -1) / 2
            R = Rotation.from_rotvec(x[:, 3:])
            lever = np.einsum("nab,ijb->nija", R.as_matrix(), self.hands)
            J = np.concatenate([rod, np.cross(lever, rod)], axis=3).reshape(len(q), -1, 6)
            step = np.linalg.solve(J[:, :, free], F[..., None])[..., 0]
            x[:, :2] -= step[:, :2]
            if self.turns:
                x[:, 2] -= step[:, 2]
                x[:, 3:] = (Rotation.from_rotvec(-step[:, 3:]) * R).as_rotvec()
            if np.abs(step).max() < 1e-12:
                break
        return x


def _text(values: Array) -> str:
    return " ".join(repr(float(v)) for v in np.ravel(values))


def _tree(gravity: Array, bodies: str) -> Any:
    """Return the engine's model of some bodies."""
    import mujoco

    return mujoco.MjModel.from_xml_string(
        f'<mujoco><compiler angle="radian" autolimits="false"/><option gravity="{_text(gravity)}"/>'
        f"<worldbody>{bodies}</worldbody></mujoco>"
    )


def _inertial(mass: float, at: Array, diagonal: Sequence[float]) -> str:
    return f'<inertial mass="{mass!r}" pos="{_text(at)}" diaginertia="{_text(np.array(diagonal))}"/>'


def _upright(line: Array) -> Array:
    """Return the quaternions (N, 4) of the shortest turns of z to lines (N, 3)."""
    found = np.column_stack([1 + line[:, 2], -line[:, 1], line[:, 0], np.zeros(len(line))])
    return np.asarray(found / np.linalg.norm(found, axis=1)[:, None])


def _forces(model: Any, at: Callable[[Array], Array], motion: Array) -> tuple[Array, Array]:
    """Return the engine's forces (N, n_v) in a motion, and how its bodies move with each joint (N, n_v, n_q).

    `at` gives the engine's positions (N, n_p) at joints (N, n_q).
    """
    import mujoco

    q, qd, qdd = motion
    data, N, n = mujoco.MjData(model), len(q), q.shape[1]
    here = at(q)

    def apart(there: Array) -> Array:
        out = np.empty((N, model.nv))
        for row, one, two in zip(out, here, there, strict=True):
            mujoco.mj_differentiatePos(model, row, 1.0, one, two)
        return out

    slides = np.isin(model.jnt_type[:n], mujoco.mjtJoint.mjJNT_SLIDE)

    def first_and_second(way: Callable[[float], Array], h: float) -> tuple[Array, Array]:
        sides = {k: (apart(at(way(k * h))), apart(at(way(-k * h)))) for k in FIRST}
        one = sum(FIRST[k] * (ahead - back) for k, (ahead, back) in sides.items()) / h
        two = sum(SECOND[k] * (ahead + back) for k, (ahead, back) in sides.items()) / h**2
        return np.asarray(one), np.asarray(two)

    velocity, acceleration = first_and_second(lambda t: q + qd * t + qdd * t**2 / 2, STEP)
    steps = np.where(slides, STEP_MM, STEP).tolist()
    along = [first_and_second(lambda s, e=e: q + s * e, h)[0] for e, h in zip(np.eye(n), steps, strict=True)]
    forces = np.empty((N, model.nv))
    for k in range(N):
        data.qpos[:], data.qvel[:], data.qacc[:] = here[k], velocity[k], acceleration[k]
        mujoco.mj_inverse(model, data)
        forces[k] = data.qfrc_inverse
    return forces, np.stack(along, axis=2)


def torque_of_linkage(linkage: Linkage, motion: Array, near: Array) -> Array:
    """Return what the joints give (N, limbs) [N mm, N] in a motion (3, N, limbs), the platform being near (6,)."""
    slides, half = linkage.slides, linkage.lengths / 2000
    bodies = ""
    for (mass, centre, inertia), joint, axis in zip(linkage.arms, linkage.joint, linkage.axis, strict=True):
        line = centre - joint
        turn = f'quat="{_text(_upright((line / (np.linalg.norm(line) or 1.0))[None])[0])}"' if line.any() else ""
        across = max(inertia * 1e-6, POINT)
        moments = f'diaginertia="{across!r} {across!r} {POINT!r}"'
        own = f'<inertial mass="{mass!r}" pos="{_text(centre / 1000)}" {turn} {moments}/>'
        kind = "slide" if slides else "hinge"
        bodies += f'<body>{own}<joint type="{kind}" axis="{_text(axis)}" pos="{_text(joint / 1000)}"/></body>'
    for h in half.ravel():
        across = linkage.rod * (2 * h) ** 2 / 12
        bodies += f"<body>{_inertial(linkage.rod, np.zeros(3), (across, across, POINT))}<freejoint/></body>"
    bodies += f"<body>{_inertial(linkage.platform, linkage.centre / 1000, (POINT,) * 3)}<freejoint/></body>"
    model = _tree(linkage.gravity, bodies)
    start = linkage.closed(motion[0], np.tile(near, (motion.shape[1], 1)))

    def at(q: Array) -> Array:
        x = linkage.closed(q, start)
        elbow, hand = linkage.rods(q, x)
        middle = ((elbow + hand) / 2000).reshape(len(q), -1, 3)
        line = ((elbow - hand) / linkage.lengths[..., None]).reshape(len(q), -1, 3)
        rods = [np.hstack([middle[:, r], _upright(line[:, r])]) for r in range(middle.shape[1])]
        turn = Rotation.from_rotvec(x[:, 3:]).as_quat(scalar_first=True)
        moved = q * np.linalg.norm(linkage.axis, axis=1)  # the engine knows lines of length 1 only
        return np.hstack([moved / 1000 if slides else moved, *rods, x[:, :3] / 1000, turn])

    forces, along = _forces(model, at, motion)
    found = np.einsum("nv,nvj->nj", forces, along)
    return np.asarray(1000 * found)


def torque_of_chain(
    links: Sequence[Mapping[str, Any]], inertia: Array, motion: Array, gravity: Sequence[float]
) -> Array:
    """Return what the joints of a chain of turning joints, standard convention, give (N, n_q) [N mm].

    inertia (links, 10): mass, first moments, tensor (xx, yy, zz, xy, xz, yz) about the link frame's origin [kg, mm].
    """
    import mujoco

    bodies, before = "", np.eye(4)
    for link, (m, *rest) in zip(links, inertia, strict=True):
        theta, alpha = np.radians(link.get("theta", 0.0)), np.radians(link.get("alpha", 0.0))
        begun = before @ _placed(Rotation.from_rotvec([0, 0, theta]), np.zeros(3))
        after = _placed(Rotation.from_rotvec([alpha, 0, 0]), np.array([link.get("a", 0.0), 0, link.get("d", 0.0)]))
        xx, yy, zz, xy, xz, yz = rest[3:]
        com, R = np.array(rest[:3]) / m, after[:3, :3]
        tensor = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) - m * (com @ com * np.eye(3) - np.outer(com, com))
        own = 1e-6 * R @ tensor @ R.T
        moments, axes = np.linalg.eigh(own)  # the engine's own decomposition leaves 1e-7
        along = Rotation.from_matrix(axes * np.linalg.det(axes)).as_quat(scalar_first=True)
        turn = Rotation.from_matrix(begun[:3, :3]).as_quat(scalar_first=True)
        bodies += (
            f'<body pos="{_text(begun[:3, 3] / 1000)}" quat="{_text(turn)}"><joint axis="0 0 1"/>'
            f'<inertial mass="{float(m)!r}" pos="{_text((R @ com + after[:3, 3]) / 1000)}" '
            f'quat="{_text(along)}" diaginertia="{_text(moments)}"/>'
        )
        before = after
    model = _tree(np.array(gravity), bodies + "</body>" * len(links))
    data, out = mujoco.MjData(model), np.empty(motion.shape[1:])
    for k in range(len(out)):
        data.qpos[:], data.qvel[:], data.qacc[:] = motion[:, k]
        mujoco.mj_inverse(model, data)
        out[k] = data.qfrc_inverse
    return 1000 * out


def _placed(turn: Rotation, shift: Array) -> Array:
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = turn.as_matrix(), shift
    return T
