"""What an effect may move: the joint, a part of its limb, the base, the measured point, the reading, a drive's torque.

A mechanism says in ``moves`` which of its own errors a part is.
"""

from __future__ import annotations

from collections.abc import Iterable

PARTS = {
    "offset": "zero of the joint",
    "arm": "length of the arm",
    "rod": "length of the rods, mean of the pair",
    "rod_difference": "length of the rods, rod 1 minus rod 2",
    "outwards": "joint centre along the limb's direction, away from the base's centre",
    "tip_v": "arm's tip normal to the arm, in its plane",
    "tip_w": "arm's tip normal to the arm, along the joint's axis",
    "spacing_difference": "spacing of the rods, at the elbow minus at the platform",
    "hand_axis_u": "axis of the platform's joints about the limb's direction, the elbow's less the platform's",
    "hand_axis_v": "the same about the normal of the base",
    "elbow_axis_u": "axis of the elbow's joints about the arm",
    "elbow_axis_v": "axis of the elbow's joints about the normal of the arm",
    "pair_difference": "rod 1 minus rod 2, where the platform tilts by it",
    "tilt_x": "axis of the joint and all it bears, about x of the frame it turns in; of a limb, about its direction",
    "tilt_y": "the same about y of that frame; of a limb, about the normal of the base or of the limb's plane",
    "side_x": "axis of the joint and all it bears, along x of the frame it turns in",
    "side_y": "the same along y of that frame",
    "bend_v": "what a link carries, across the link's line and its joint's axis",
    "bend_w": "the same across the line, along the joint's axis as far as that lies across",
    "twist": "what a link carries, turned about the link's line",
    "lean_radial": "axis of a sliding joint, outwards",
    "lean_tangential": "axis of a sliding joint, counter-clockwise",
}
AXES = ("x", "y", "z")
TARGETS = {  # what an effect on each acts on
    "joint": "limb",
    "torque": "drive",
    **{f"limb.{part}": "limb" for part in PARTS},
    **{f"turn.{axis}": "base" for axis in AXES},
    **{f"tool.{axis}": "point" for axis in AXES},
    **{f"reading.{axis}": "reading" for axis in AXES},
    "length": "reading",
    "height": "reading",
}
ON = {target.partition(".")[0]: on for target, on in TARGETS.items()}  # the same by their first words
LAWFUL = (  # on which a law is looked for that nobody registered
    *("joint", "limb.arm", "limb.rod", "limb.outwards", "limb.tip_v", "limb.tip_w"),
    *("turn.x", "turn.y", "tool.x", "tool.y", "tool.z", "reading.x", "reading.y", "reading.z", "length"),
)


def acts_on(targets: Iterable[str]) -> str:
    """Return what targets belong to: ``limb, drive, base, point`` or ``reading``.

    Raises
    ------
    ValueError
        There is no such target, there is none at all, or they belong to different things.
    """
    found: dict[str, str] = {}
    for target in targets:
        if target not in TARGETS:
            raise ValueError(f"nothing is called '{target}'; an effect moves {', '.join(TARGETS)}.")
        found[TARGETS[target]] = target
    if len(found) != 1:
        one = " and ".join(found.values()) or "nothing"
        raise ValueError(f"it moves {one}; what moves a limb, the base, a point and the reading are different effects.")
    return next(iter(found))
