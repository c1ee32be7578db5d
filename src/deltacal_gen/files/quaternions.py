"""Rotations that a table has as quaternions, as trackers and ROS write them: rotation vectors, as files here have them.

A quaternion is four columns of one name and x, y, z, w: ``qx ... qw``, ``quat_x``, ``orientation.w``.
"""

from __future__ import annotations

import dataclasses
import re
from collections.abc import Iterable, Sequence
from math import isnan

import numpy as np

from deltacal_gen.files.rows import Rows
from deltacal_gen.machine.values import POSITION, ROTATION
from deltacal_gen.units import DEG

_PART = re.compile(r"(?P<of>(?:.*[._ ])?(?:q|quat|quaternion|orientation|rotation|rot))[._ ]?(?P<axis>[xyzw])")
LENGTH = 0.01  # by which one may be longer or shorter than 1: it was rounded


def with_vectors(rows: Rows, order: str, axes: Sequence[str]) -> Rows:
    """Return rows of positions in space with rotation vectors for the quaternions beside them; others as they are.

    Parameters
    ----------
    rows : Rows
    order : str
        ``rotation`` of the sidecar.
    axes : sequence of str
        Along which the machine moves.

    Raises
    ------
    InputError
        Numbers that are no quaternion; turns in an order, which these are not.
    """
    names = quaternion_of(rows.columns)
    placed = len(axes) == len(POSITION) and {*POSITION} <= {*rows.columns}
    if names is None or not placed or {*ROTATION} & {*rows.columns}:
        return rows
    if order != "vector":
        raise rows.error(
            f'rotation = "{order}" in the sidecar is an order of turns, but the rotation here is a quaternion.',
            "Leave the key out: a quaternion needs none.",
            column=names[0],
        )
    read = rows.numbers(*names)
    lengths = np.linalg.norm(read, axis=1)
    rows.refuse(
        np.abs(lengths - 1) > LENGTH,
        lambda k: f"{', '.join(names)} are no rotation: a quaternion has the length 1, this one {lengths[k]:.4g}.",
        "Correct the row, or blank its rotation; where these columns are something else, rename them.",
        column=names[0],
    )
    vectors = (rotation_vector(read) / DEG).T.tolist()
    told = {name: ["" if isnan(v) else repr(v) for v in own] for name, own in zip(ROTATION, vectors, strict=True)}
    return dataclasses.replace(rows, columns=rows.without(names).columns | told)


def quaternion_of(columns: Iterable[str]) -> tuple[str, ...] | None:
    """Return which columns are x, y, z, w of a quaternion; None where there is none, or more than one."""
    found: dict[str, dict[str, str]] = {}
    for name in columns:
        if (part := _PART.fullmatch(name.lower())) is not None:
            found.setdefault(part["of"], {})[part["axis"]] = name
    whole = [own for own in found.values() if len(own) == len("xyzw")]
    return tuple(whole[0][axis] for axis in "xyzw") if len(whole) == 1 else None


def rotation_vector(quaternions: np.ndarray) -> np.ndarray:
    """Return rotation vectors (N, 3) [rad] of quaternions (N, 4), x y z w; nan where one has no length."""
    from scipy.spatial.transform import Rotation

    out = np.full((len(quaternions), 3), np.nan)
    turned = np.linalg.norm(quaternions, axis=1) > 0  # false where there are no numbers
    if turned.any():
        out[turned] = Rotation.from_quat(quaternions[turned]).as_rotvec()
    return out
