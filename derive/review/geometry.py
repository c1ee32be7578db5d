"""What unseen directions are on the machine, in a sentence: the geometry behind vectors of a null space."""

from __future__ import annotations

from collections.abc import Collection

ROD = "Both ends of a rod shifted alike along the joint's axis: the rod moves parallel to itself."
SENTENCES: dict[str, dict[frozenset[str], str]] = {  # by mechanism, and by the errors that move, their limbs left out
    "complete_delta": {
        frozenset({"bx", "ax"}): ROD,
        frozenset({"bx", "by", "ax"}): ROD,
        frozenset(
            {"az", "betax"}
        ): "The arm turned about the joint's axis, and both elbow joints turned back in the arm.",
        frozenset(
            {"az", "betax", "betay"}
        ): "The arm turned about the joint's axis, and both elbow joints turned back in the arm.",
    },
    "planar_parallelogram": {
        frozenset(
            {"a1x", "b1x"}
        ): "Both ends of the driven rod shifted alike along x: the rod moves parallel to itself.",
        frozenset(
            {"a2x", "b2x"}
        ): "Both ends of the other rod shifted alike along x: the rod moves parallel to itself.",
        frozenset(
            {"a2y", "b2y"}
        ): "Both ends of the other rod shifted alike along y: the rod moves parallel to itself.",
    },
    "diamond": {
        frozenset({"mx"}): "The scale's mount along x moves no link: only lengths see it.",
        frozenset({"my"}): "The scale's mount along y moves no link: only lengths see it.",
    },
}
RIGID = {  # by model, what the paper's reading leaves open, where it is no vector that all poses share in closed form
    "diamond/12": "Shift both base points and the scale's mount alike, along x or y, or turn the machine about the "
    "scale's joint at the base and the mount with it: no length changes.",
}


def sentence(mechanism: str, names: Collection[str], limbs: bool = True) -> str:
    """Return what a direction is on the machine, where it moves one limb or common errors; else an empty text."""
    if limbs and len({n.rpartition("_")[2][:1] for n in names}) > 1:
        return ""
    errors = frozenset(n.rpartition("_")[0] if limbs else n for n in names)
    return SENTENCES.get(mechanism, {}).get(errors, "")
