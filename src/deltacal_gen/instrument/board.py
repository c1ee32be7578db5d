"""A camera and a printed board: where they are to begin with, by homographies and linear hand-eye, then all together.

With ``S_i`` and ``s_i`` the part's rotation and origin as the camera's part sees them in image i, the board stands
there at ``M_i = C S_i B`` and ``t_i = C (S_i g + s_i) + f``: rotation `C` and place `f` of the camera, `B` and `g` of
the board. The images themselves, and all that follows from them, are of the derived kernels.

References
----------
Zhang 2000, IEEE PAMI 22, 1330 (homographies and focal length); Shah 2013, J. Mech. Robotics 5, 031007 (hand-eye and
robot-world at once).
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from deltacal_gen.errors import TooFewReadings
from deltacal_gen.instrument.kind import Instrument, Readings
from deltacal_gen.machine.registry import Array

SAMPLES, SEED = 60, 1330  # of four points, by which an image's homography is found though some of its points are wrong
ROUNDS = 60  # of alternating between camera and board
STEPS, SETTLED = 60, 1e-9  # of the fit of camera and board, and how little a last one gains
HUBER = 2.5  # standard deviations beyond which a reading's pull stops growing
FEWEST, IMAGES = 4, 3  # points of an image, and such images
GUESSED = 1.2  # of the image's width: a focal length of which no image tells
TILTED = 1e-3  # of the best seen direction: below it the images say nothing of the focal length
FAR = 1e6  # image sizes: a point that a wrong homography throws to infinity
PARALLEL = 0.02  # of the lines that look at a point: more than noise, less than a tilt of 10 deg tells of how far it is
FACING = 0.9  # cosine of the angle within which a camera looks at a point
PRINTED, FILLED = 0.3, 0.5  # width of a print, of where the machine moves; of how near a camera comes
CARRIED = 0.2  # likewise of a print on the platform
TURNED = 0.3  # cosine of the angle at which a fixed camera sees a print on the platform at least
NICE = (1.0, 2.0, 2.5, 5.0, 10.0)
POINTS = 7, 5  # of a print, along and across
RANK = 1e-6  # of a column's length: less is a combination of the others


def first(found: Readings, poses: Array, lens: Array, rides: bool, path: Path | str) -> Array:
    """Return the state of camera and board from readings of one set-up, at poses (R, 12) of the platform.

    Raises
    ------
    InputError
        Fewer than three images with four points that do not lie on a line.
    """
    assert found.known is not None
    guess = lens.copy()
    middle = (found.values.max(axis=0) + found.values.min(axis=0)) / 2
    guess[2:4] = np.where(np.isnan(lens[2:4]), middle, lens[2:4])
    guess[4:] = np.nan_to_num(lens[4:])
    views = []
    for group in np.unique(found.group):
        own = np.flatnonzero(found.group == group)
        if len(own) >= FEWEST and (H := homography(found.known[own], found.values[own] - guess[2:4])) is not None:
            views.append((own[0], H))
    if len(views) < IMAGES:
        raise TooFewReadings(
            f"{len(views)} images show {FEWEST} points or more of the board: at least {IMAGES} are needed to begin.",
            "Label the rows of one image with the same pose, and give more points of it.",
            file=path,
        )
    H = np.array([h for _, h in views])
    if np.isnan(lens[:2]).any():
        focal = focal_length(H, float(np.ptp(found.values, axis=0).max()))
        guess[:2] = np.where(np.isnan(lens[:2]), np.where(np.isnan(lens[1::-1]), focal, lens[1::-1]), lens[:2])
    stands = [stand(h / np.array([[guess[0]], [guess[1]], [1.0]])) for h in H]
    M, t = (np.array(part) for part in zip(*stands, strict=True))
    at = poses[[row for row, _ in views]]
    R, P = at[:, 3:].reshape(-1, 3, 3), at[:, :3]
    S = np.swapaxes(R, 1, 2) if rides else R
    s = -np.einsum("nij,nj->ni", S, P) if rides else P
    C, f, B, g = hand_eye(M, t, S, s)
    return np.concatenate([C.ravel(), f, B.ravel(), g, [0.0], guess, [float(rides)]])


def homography(points: Array, image: Array) -> Array | None:
    """Return the homography (3, 3) from points (n, 2) to their image (n, 2), whatever a part of them shows; None.

    Of samples of four points the one that leaves the least median, then all points that agree with it.
    """
    size, spread = float(np.ptp(points, axis=0).max()), float(np.abs(image).max())
    if size == 0 or spread == 0:
        return None
    points, image = points / size, image / spread
    rng, n = np.random.default_rng(SEED), len(points)
    tried = _linear(points, image)[None]
    if n > FEWEST:
        chosen = np.array([rng.choice(n, FEWEST, replace=False) for _ in range(SAMPLES)])
        tried = np.concatenate([tried, _linear(points[chosen], image[chosen])])
    off = np.linalg.norm(_mapped(tried, points) - image, axis=2)
    middle = np.median(off, axis=1)
    best = int(np.argmin(middle))
    near = off[best] <= max(4.0 * float(middle[best]), 1e-9)
    H = _linear(points[near], image[near])
    whole: Array = np.diag([spread, spread, 1.0]) @ H @ np.diag([1 / size, 1 / size, 1.0])
    return whole if np.linalg.cond(H) < 1e7 else None


def _linear(points: Array, image: Array) -> Array:
    """Return the homographies (..., 3, 3) that linear equations of points and images (..., n, 2) give."""
    P = np.concatenate([points, np.ones((*points.shape[:-1], 1))], axis=-1)
    none = np.zeros_like(P)
    along = np.concatenate([P, none, -image[..., :1] * P], axis=-1)
    across = np.concatenate([none, P, -image[..., 1:] * P], axis=-1)
    A = np.concatenate([along, across], axis=-2)
    return np.asarray(np.linalg.svd(A)[2][..., -1, :]).reshape(*A.shape[:-2], 3, 3)


def _mapped(H: Array, points: Array) -> Array:
    """Return the images (S, n, 2) that homographies (S, 3, 3) make of points (n, 2)."""
    out = np.hstack([points, np.ones((len(points), 1))]) @ np.swapaxes(H, 1, 2)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.clip(np.nan_to_num(out[..., :2] / out[..., 2:], nan=FAR), -FAR, FAR)


def focal_length(H: Array, width: float) -> float:
    """Return the focal length [px] that homographies (n, 3, 3) about the principal point speak for (Zhang 2000).

    The middle of what each image says: one of few points, of which one was found wrongly, says anything, and loudly.
    Images that look straight at the board say nothing of it: it is then guessed from their width.
    """
    H = H / np.linalg.norm(H[:, :2, :2], axis=(1, 2))[:, None, None] * width
    a, b = H[:, :, 0], H[:, :, 1]
    across = np.stack([(a * b)[:, :2].sum(axis=1), (a**2 - b**2)[:, :2].sum(axis=1)]) / width**2
    along = np.stack([a[:, 2] * b[:, 2], a[:, 2] ** 2 - b[:, 2] ** 2])
    tells = np.linalg.norm(along, axis=0)
    if tells.max(initial=0.0) < TILTED:
        return GUESSED * width
    square = -(across * along).sum(axis=0) / np.maximum(tells, 1e-300) ** 2
    order = np.argsort(square)
    weight = np.cumsum(np.minimum(tells, np.median(tells))[order])
    middle = float(square[order[np.searchsorted(weight, weight[-1] / 2)]])
    focal = float(np.sqrt(max(middle, 0.0))) * width
    return focal if width / 10 < focal < 30 * width else GUESSED * width


def stand(H: Array) -> tuple[Array, Array]:
    """Return rotation (3, 3) and origin (3,) of a board in the camera's frame, from its homography there."""
    H = H / np.sqrt(np.linalg.norm(H[:, 0]) * np.linalg.norm(H[:, 1]))
    H = H if H[2, 2] > 0 else -H
    turn = nearest(np.column_stack([H[:, 0], H[:, 1], np.cross(H[:, 0], H[:, 1])]))
    return turn, H[:, 2]


def nearest(A: Array) -> Array:
    """Return the rotations (..., 3, 3) nearest to matrices."""
    U, _, Vt = np.linalg.svd(A)
    U[..., 2] *= np.sign(np.linalg.det(U @ Vt))[..., None]
    turn: Array = U @ Vt
    return turn


def hand_eye(M: Array, t: Array, S: Array, s: Array) -> tuple[Array, Array, Array, Array]:
    """Return C, f, B, g from boards (M, t) as cameras see them, and their part (S, s): the best of alternations.

    They begin at all turns by right angles. Images whose board stands elsewhere than the others have it, since of their
    few points one was found wrongly, have little pull. Where nothing turns, the camera sits at the origin of its part.
    """
    turning = float(np.abs(S - S.mean(axis=0)).max()) > TILTED
    reach = max(float(np.median(np.linalg.norm(t - np.median(t, axis=0), axis=1))), 1e-9)
    C = np.array(_right_angles())
    B, weights, open_ = np.empty_like(C), np.ones((len(C), len(M))), np.arange(len(C))
    for _ in range(ROUNDS):
        before, w = C[open_], weights[open_]
        B[open_] = own = nearest(np.einsum("an,anji,njl->ail", w, before[:, None] @ S, M))
        g, f = _places(before, t, S, s, turning, w)
        inner = np.einsum("nij,aj->ani", S, g) + s
        pull = np.einsum("an,anil,njl->aij", w, M @ np.swapaxes(own, 1, 2)[:, None], S) * reach**2
        C[open_] = now = nearest(pull + np.swapaxes((t - f[:, None]) * w[..., None], 1, 2) @ inner)
        off = _apart((now, f, own, g), M, t, S, s, reach)
        weights[open_] = np.minimum(1.0, np.median(off, axis=1, keepdims=True) / np.maximum(off, 1e-300))
        open_ = open_[np.abs(now - before).max(axis=(1, 2)) >= SETTLED]
        if not len(open_):
            break
    g, f = _places(C, t, S, s, turning, weights)
    best = int(np.argmin(_apart((C, f, B, g), M, t, S, s, reach).sum(axis=1)))
    return C[best], f[best], B[best], g[best]


def _apart(at: tuple[Array, Array, Array, Array], M: Array, t: Array, S: Array, s: Array, reach: float) -> Array:
    """Return how far boards stand (A, n) [mm] from where cameras and boards `at` have them; turns count at `reach`."""
    C, f, B, g = at
    off = t - (np.einsum("nij,aj->ani", S, g) + s) @ np.swapaxes(C, 1, 2) - f[:, None]
    turned = M - C[:, None] @ S @ B[:, None]
    apart: Array = np.sqrt((off**2).sum(axis=2) + reach**2 * (turned**2).sum(axis=(2, 3)))
    return apart


def _places(C: Array, t: Array, S: Array, s: Array, turning: bool, weights: Array) -> tuple[Array, Array]:
    """Return g and f (A, 3) of cameras by least squares, images weighed (A, n); f is zero where nothing turns."""
    A = C[:, None] @ S
    if turning:
        A = np.concatenate([A, np.broadcast_to(np.eye(3), A.shape)], axis=3)
    root = np.sqrt(weights)[..., None]
    rows, b = (A * root[..., None]).reshape(len(C), -1, A.shape[3]), ((t - s @ np.swapaxes(C, 1, 2)) * root)
    least = np.linalg.pinv(rows, rcond=np.finfo(float).eps * rows.shape[1])
    found = (least @ b.reshape(len(C), -1, 1))[..., 0]
    return found[:, :3], found[:, 3:] if turning else np.zeros((len(C), 3))


def _right_angles() -> list[Array]:
    """Return the 24 rotations that turn axes into axes."""
    out = []
    for order in itertools.permutations(range(3)):
        for signs in itertools.product((1.0, -1.0), repeat=3):
            turn = np.zeros((3, 3))
            turn[range(3), order] = signs
            if np.linalg.det(turn) > 0:
                out.append(turn)
    return out


# ---------------------------------------------------------------------------------------------------------- the fit


def fitted(instrument: Instrument, found: Readings, x: Array) -> Instrument:
    """Return camera and board fitted to readings, the machine as it is: damped, robust against wrong detections."""
    damping, (r, weights) = 1e-3, _weighed(instrument, found, x)
    cost = _cost(r, weights)
    size = np.tile(instrument.kind.typical[list(instrument.free)], len(instrument.state))
    for _ in range(STEPS):
        J = instrument.linearise(found, x, np.zeros((len(x), 6, 0)))[1] * size * np.sqrt(weights)[:, None, None]
        J, b = J.reshape(-1, len(size)), (r * np.sqrt(weights)[:, None]).ravel()
        G, g = J.T @ J, J.T @ b
        while damping < 1e12:
            step = np.linalg.solve(G + damping * np.diag(np.diag(G) + 1e-12 * np.trace(G)), g)
            trial = instrument.stepped(step * size)
            left = trial.residual(found, x)
            after = _cost(left, weights) if np.isfinite(left).all() else np.inf
            if after <= cost:
                break
            damping *= 10
        else:
            return instrument
        gained = cost - after
        instrument, damping = trial, max(damping / 10, 1e-12)
        r, weights = _weighed(instrument, found, x)
        cost = _cost(r, weights)
        if gained <= SETTLED * cost:
            break
    return instrument


def _cost(r: Array, weights: Array) -> float:
    return float((weights[:, None] * r**2).sum())


def _weighed(instrument: Instrument, found: Readings, x: Array) -> tuple[Array, Array]:
    """Return residuals (R, 2) and Huber's weights (R,) of them."""
    r = instrument.residual(found, x)
    return r, np.minimum(1.0, HUBER * _spread(r) / np.maximum(np.linalg.norm(r, axis=1), 1e-300))


def _spread(r: Array) -> float:
    """Return the standard deviation of a coordinate that the middle of residuals (R, 2) speaks for."""
    return max(float(np.median(np.linalg.norm(r, axis=1))) / 1.1774, 1e-12)


def unseen(
    instrument: Instrument, found: Readings, x: Array, size: Array, known_by: float, last: Sequence[int]
) -> frozenset[int]:
    """Return the unknowns that readings know less well, beside the others, than so many of their sizes (n_unknown,).

    Of unknowns that stand for one another those of `last` go first.
    """
    r, weights = _weighed(instrument, found, x)
    sigma = _spread(r)
    J = instrument.linearise(found, x, np.zeros((len(x), 6, 0)))[1]
    A = (J * np.sqrt(weights)[:, None, None]).reshape(-1, J.shape[2]) * size / sigma
    each, gone = len(instrument.free), set[int]()
    order = sorted(range(each), key=lambda k: instrument.free[k] in last)
    basis = np.zeros((len(A), 0))
    for k in order:
        own = A[:, k::each] if len(instrument.state) > 1 else A[:, [k]]
        rest = own - basis @ (basis.T @ own)
        rest -= basis @ (basis.T @ rest)
        length = np.linalg.norm(rest, axis=0)
        if (length < np.maximum(1 / known_by, RANK * np.linalg.norm(own, axis=0))).any():
            gone.add(instrument.free[k])
            continue
        basis = np.hstack([basis, rest / length])
    return frozenset(gone)


def at_origin(instrument: Instrument, found: Readings, x: Array) -> Array:
    """Return the state (S, g) with the cameras at the origin of their part, the boards where they then seem to be."""
    state = instrument.state.copy()
    for s, row in enumerate(state):
        rows = found.rows[found.setup == s, 0]
        if not len(rows):
            continue
        C, R = row[:9].reshape(3, 3), x[rows, 3:].reshape(-1, 3, 3)
        S = np.swapaxes(R, 1, 2) if row[34] else R
        row[21:24] += nearest(S.mean(axis=0)).T @ C.T @ row[9:12]
        row[9:12] = 0.0
    return state


def looked_at(P: Array, along: Array, otherwise: Array) -> Array:
    """Return the point (3,) that lines from P (N, 3) along unit vectors (N, 3) pass closest.

    As far as they are parallel, and where most do not look that way, it is the one that stands for it otherwise.
    """
    across = np.eye(3) - along[:, :, None] * along[:, None, :]
    A = across.sum(axis=0) + PARALLEL * len(P) * np.eye(3)
    at: Array = np.linalg.solve(A, np.einsum("nij,nj->i", across, P) + PARALLEL * len(P) * otherwise)
    before = np.einsum("ni,ni->n", along, at - P) > FACING * np.linalg.norm(at - P, axis=1)
    return at if before.mean() > 0.5 else otherwise


def nice(length: float) -> float:
    """Return a length that prints have, not more than `length`: 1, 2, 2.5 or 5 times a power of ten."""
    power = 10.0 ** np.floor(np.log10(length))
    return float(max(n for n in NICE if n * power <= length * (1 + 1e-9)) * power)


def printed(x: Array, chain: bool, rides: bool = True) -> Array:
    """Return the points (n, 2) of a print that suits a camera at poses x (N, 12), or one beside it, from its corner."""
    span = float(np.ptp(x[:, :3], axis=0).max())
    width = (PRINTED if rides else CARRIED) * span
    if chain and rides:
        along = x[:, 3:].reshape(-1, 3, 3)[:, :, 2]
        middle = looked_at(x[:, :3], along, x[:, :3].mean(axis=0) + span * along.mean(axis=0))
        width = FILLED * float(np.linalg.norm(middle - x[:, :3], axis=1).min())
    step = nice(width / POINTS[0])
    return np.array([[step * i, step * j] for i in range(POINTS[0]) for j in range(POINTS[1])])


def shown(state: Array, x: Array, points: Array) -> tuple[np.ndarray, np.ndarray]:
    """Return which points (n, 2) of a board a camera shows: numbers of poses and points.

    The camera sits on the platform and the board on the ground, or the other way round: then it has to face the camera.
    The lens is taken for straight, its image twice as large as the principal point is far from its corner.
    """
    C, f, B, g = state[:9].reshape(3, 3), state[9:12], state[12:21].reshape(3, 3), state[21:24]
    own = np.column_stack([points, np.zeros(len(points))]) @ B.T + g
    R = x[:, 3:].reshape(-1, 3, 3)
    if state[34]:
        seen = np.einsum("nji,nkj->nki", R, own[None] - x[:, None, :3]) @ C.T + f
    else:
        seen = (np.einsum("nij,kj->nki", R, own) + x[:, None, :3]) @ C.T + f
    off = (np.abs(seen[:, :, :2] * state[25:27]) < seen[:, :, 2:] * state[27:29]).all(axis=2)
    if not state[34]:
        normal = np.einsum("ij,njk,k->ni", C, R, B[:, 2])
        off &= np.einsum("ni,nki->nk", -normal, seen) > TURNED * np.linalg.norm(seen, axis=2)
    rows, which = np.nonzero(off)
    return rows, which


def mounted(x: Array, middle: Array, width: float, lens: Array, rides: bool, chain: bool) -> Array:
    """Return the state of a camera that looks at the board's middle, far enough to see all of it from poses x (N, 12).

    The camera looks along -z of {O}, or the board on the platform faces up to it: what it looks at lies below. On an
    open chain it looks along z of the last link, at what the poses have before them, or stands there and looks back at
    a board across that axis.
    """
    focal = np.where(np.isnan(lens[:2]), 1000.0, lens[:2])
    centre = np.where(np.isnan(lens[2:4]), [640.0, 512.0], lens[2:4])
    P = x[:, :3]
    mid = (P.max(axis=0) + P.min(axis=0)) / 2
    down = np.diag([1.0, -1.0, -1.0])
    turns = x[:, 3:].reshape(-1, 3, 3)
    R = nearest(turns.mean(axis=0))
    corner = np.array([*middle, 0.0])
    along = turns[:, :, 2]
    ahead = along.mean(axis=0) / np.linalg.norm(along.mean(axis=0))
    if chain and not rides:
        down = np.vstack([np.linalg.svd(ahead[None])[2][1:], -ahead])
        down[0] *= np.sign(np.linalg.det(down))
    span = np.ptp(P if rides else P @ down.T, axis=0)
    slope = 0.8 * float((centre / focal).min())
    far = (float(span[:2].max()) / 2 + 0.75 * width) / slope + float(span[2]) / 2
    if rides and chain:
        at = looked_at(P, along, mid + far * ahead)
        C, f = np.eye(3), np.zeros(3)
        laid = np.column_stack([*np.linalg.svd(ahead[None])[2][1:], -ahead])
        laid[:, 0] *= np.sign(np.linalg.det(laid))
        origin = at - laid @ corner
    elif rides:  # X = R^T (fixed - P), C X: along the camera's z where it looks down
        C, f = down @ R, np.zeros(3)
        laid, origin = np.eye(3), mid - np.array([0.0, 0.0, far]) - corner
    else:
        C, f = down, down @ -(mid - far * down[2])
        laid = np.eye(3) if chain else R.T
        origin = -laid @ corner
    state = np.concatenate([C.ravel(), f, laid.ravel(), origin, [0.0], focal, centre, np.nan_to_num(lens[4:])])
    return np.append(state, float(rides))
