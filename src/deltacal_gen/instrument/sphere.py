"""The image of a ball: where its extremes lie for a given centre, and the centre from its extremes.

Both are exact (``derive/measurements/sphere.py``; Traslosheros 2013, section 5.2): the paper's corrections for the
ellipse's centre and shape are not needed, since the extremes of the whole outline obey equations (12) and (16) as they
stand. Camera frame: z along the optical axis, x and y along u and v, origin at the optical centre.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from deltacal_kernels import images

from deltacal_gen.machine.backend import RowFunctions, row_functions

if TYPE_CHECKING:
    from deltacal_gen.machine.registry import Array
    from deltacal_gen.machine.values import Camera

BALL = slice(9, 12)  # place in the state of a kernel
_STEPS = 20
_SETTLED = 1e-12  # of the distance: a step below is rounding


def _kernels() -> RowFunctions:
    return row_functions("measurements.sphere")


def _at_origin(n: int) -> Array:
    """Return poses (n, 12) of a platform at {O}, parallel to it."""
    return np.tile(np.concatenate([np.zeros(3), np.eye(3).ravel()]), (n, 1))


def state(camera: Camera, turn: Array, ball: Array, order: tuple[float, float] = (1.0, 1.0)) -> Array:
    """Return the state of an instrument: rotation `turn` (3, 3) from {O'} to the camera, ball's centre (3,) in {O}.

    `order` says per axis whether the first extreme is the larger one (1) or the smaller one (-1).
    """
    c = camera
    return np.array([*turn.ravel(), *ball, c.fx_px, c.fy_px, c.cx_px, c.cy_px, c.k1, c.ball_radius_mm, *order])


def lens(camera: Camera) -> Array:
    """Return what a lens does to directions of sight, as the functions of images read it."""
    return np.array([camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px, camera.k1])


def extremes(centre: Array, camera: Camera) -> Array:
    """Return the extremes (N, 4) [px] of the image, u1 > u2 and v1 > v2, of balls at `centre` (N, 3) [mm].

    NaN where a ball reaches behind the optical centre.
    """
    centre = np.atleast_2d(np.asarray(centre, dtype=float))
    given = np.tile(state(camera, np.eye(3), np.zeros(3)), (len(centre), 1))
    given[:, BALL] = centre
    seen = centre[:, 2] > camera.ball_radius_mm
    found = np.full((len(centre), 4), np.nan)
    found[seen] = _kernels().reading(_at_origin(int(seen.sum())), given[seen])
    return found


def order(extreme: Array) -> tuple[float, float]:
    """Return which extreme stands first in a recording's columns (N, 4), per axis: 1 the larger, -1 the smaller."""
    u, v = (float(np.sign(np.nanmedian(extreme[:, j] - extreme[:, j + 1]))) or 1.0 for j in (0, 2))
    return u, v


def centres(extreme: Array, camera: Camera) -> Array:
    """Return the centres (N, 3) [mm] of balls from the extremes (N, 4) [px] of their images, in either order.

    Equations (12) and (16) are linear in the centre and give the start; from there the pixel residuals are least,
    which leaves the centre unbiased to second order in their noise.

    References
    ----------
    Traslosheros 2013, section 5.2.
    """
    seen = np.array(np.atleast_2d(extreme), dtype=float)
    seen[:, :2], seen[:, 2:] = np.sort(seen[:, :2])[:, ::-1], np.sort(seen[:, 2:])[:, ::-1]
    n, slope = len(seen), np.zeros(seen.shape)
    for _ in range(_STEPS):
        middle = np.repeat(slope.reshape(n, 2, 2).mean(axis=2)[:, ::-1], 2, axis=1)
        for axis, own in enumerate((slice(0, 2), slice(2, 4))):
            pixel, sight = np.zeros((2, n, 2)), np.array([middle[:, own]] * 2)
            pixel[axis], sight[axis] = seen[:, own], slope[:, own]
            slope[:, own] = images.direction(pixel, sight, lens(camera))[axis]
    along, depth, touched = images.tangent(slope, np.array([1.0, -1.0, 1.0, -1.0]), camera.ball_radius_mm)
    A = np.zeros((n, 4, 3))
    A[:, :2, 0], A[:, 2:, 1] = along[:, :2], along[:, 2:]
    A[:, :, 2] = depth
    centre = np.linalg.solve(np.swapaxes(A, 1, 2) @ A, np.einsum("nij,ni->nj", A, touched)[..., None])
    centre = centre[..., 0]
    given = np.tile(state(camera, np.eye(3), np.zeros(3)), (n, 1))
    for _ in range(_STEPS):
        given[:, BALL] = centre
        r = seen - _kernels().reading(_at_origin(n), given)
        J = _kernels().by_unknown(_at_origin(n), given)[:, :, 3:6]
        Jt = np.swapaxes(J, 1, 2)
        step = np.linalg.solve(Jt @ J, Jt @ r[..., None])[..., 0]
        centre = centre + step
        if np.abs(step).max() <= _SETTLED * np.abs(centre).max():
            break
    return centre
