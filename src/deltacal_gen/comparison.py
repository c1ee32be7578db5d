"""Two sessions of one machine: what changed between them, by parameter, and what did not.

Results hold actual minus robot file; sessions of a printer often start from different files, so what differs between
the files counts too. A change is called one when noise would rarely make the largest of so many differences.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.mechanism import Machine, mechanism_of
from deltacal_gen.robot import Robot, robot_from_dict
from deltacal_gen.units import file_unit, to_internal

SCHEMA = "deltacal.comparison/1"
FEW = 0.5  # of the readings: a fit that leaves fewer to judge it by takes a good part of the noise away
CHANCE = 0.01  # that noise alone makes any of all parameters look changed


def compare(before: Mapping[str, Any], after: Mapping[str, Any]) -> dict[str, Any]:
    """Return what changed from one result of `identify` to another of the same machine.

    Returns
    -------
    dict
        ``schema, summary, changed, unchanged, unknown``: lists of parameters with ``name, before, after, change, std,
        unit``; `before` and `after` are errors relative to the first robot file. *unknown* are those of which a
        session says nothing.

    Raises
    ------
    InputError
        Results of different mechanisms, or without parameters.
    """
    for result in (before, after):
        if "parameters" not in result:
            raise InputError(
                "this is no result of identify.",
                "Give two files that identify wrote; of a diagnosed session: identify --physics DIAGNOSIS.json.",
            )
    first, second = (robot_from_dict(r["robot"]) for r in (before, after))
    if first.mechanism != second.mechanism:
        raise InputError(
            f"the results are of different machines: {first.mechanism} and {second.mechanism}.",
            "Give two sessions of one machine.",
        )
    mechanism = mechanism_of(first)
    files, other = between(mechanism, first, second)
    if other:
        raise InputError(
            f"the robot files differ in {', '.join(other)}, which no parameter of the model carries.",
            "Identify both sessions from the same robot file.",
        )
    from scipy.special import ndtri  # half of a command's start, of which few compare

    told = [{p["name"]: p for p in r["parameters"]} for r in (before, after)]
    entries = []
    for p in mechanism.parameters:
        a, b = (t[p.name] for t in told)
        # the robots hold all that is known; a file that was calibrated before has a part of it in its own table
        gap = files.get(p.name, 0.0) + second.errors.get(p.name, 0.0) - first.errors.get(p.name, 0.0)
        free = [x["status"] != "fixed" for x in (a, b)]
        if not any(free) and gap == 0:
            continue
        known = all(x["std"] is not None or not f for x, f in zip((a, b), free, strict=True))
        std = float(np.hypot(a["std"] or 0.0, b["std"] or 0.0)) if known else None
        change = gap / to_internal(p.unit)
        entries.append(
            {
                "name": p.name,
                "before": a["value"],
                "after": a["value"] + change,
                "change": change,
                "std": std,
                "unit": file_unit(p.unit),
            }
        )
    tested = [e for e in entries if e["std"] is not None]
    limit = float(-ndtri(CHANCE / 2 / max(len(tested), 1)))
    changed = [e for e in tested if abs(e["change"]) > limit * e["std"]]
    unchanged = [e for e in tested if e not in changed]
    unknown = [e for e in entries if e["std"] is None]
    changed.sort(key=lambda e: -abs(e["change"]) / max(e["std"], 1e-300))
    return {
        "schema": SCHEMA,
        "summary": _summary(changed, unchanged, unknown, limit)
        + "".join(f" {words}" for words in map(flattered, (before, after)) if words),
        "limit_std": limit,
        "changed": changed,
        "unchanged": unchanged,
        "unknown": unknown,
    }


def _summary(
    changed: list[dict[str, Any]], same: list[dict[str, Any]], unknown: list[dict[str, Any]], limit: float
) -> str:
    parts = [f"{e['name']} moved {e['change']:+.4g} +- {e['std']:.2g} {e['unit']}" for e in changed]
    text = "; ".join(parts) if parts else "Nothing moved that these sessions can see"
    if same:
        text += f"; the other {len(same)} stayed within {limit:.1f} standard deviations of what they were"
    if unknown:
        text += f"; of {', '.join(e['name'] for e in unknown)} these readings say nothing"
    return text + "."


def flattered(result: Mapping[str, Any]) -> str:
    """Say by how much the residual of a result understates the noise, where its readings are few; else nothing."""
    left = result.get("degrees_of_freedom")
    if left is None or left > FEW * (readings := result["readings"]["scalars"]):
        return ""
    said = f"{readings} readings less {readings - left:.1f} parameters leave {max(left, 0):.1f} degrees of freedom"
    if left < 1:
        return f"{said}: the residual of {result['train_rms_mm']:.3g} mm says nothing of the noise."
    part, rms = float(np.sqrt(left / readings)), result["train_rms_mm"]
    return (
        f"{said}: noise of {rms / part:.3g} mm leaves a residual of {rms:.3g} mm, "
        f"and the next session of an unchanged machine, predicted from this one, at least {1 / part:.2g} times as much."
    )


def between(mechanism: Machine, first: Robot, second: Robot) -> tuple[dict[str, float], list[str]]:
    """Return what the second robot's dimensions have more than the first's, and which differences cannot be said so.

    A dimension and an error are one where moving either moves the machine alike.

    Returns
    -------
    errors : dict
        By name of a source error (internal units).
    other : list of str
        Keys of dimensions that differ and are no source error.
    """
    out: dict[str, float] = {}
    other: list[str] = []
    for key, value in first.geometry.items():
        gap = second.geometry[key] - value
        if not gap.any():
            continue
        errors = mechanism.same_as(first, key)
        gaps = np.broadcast_to(gap, (len(errors),)).tolist() if errors else []
        found = {name: g for name, g in zip(errors, gaps, strict=True) if g}
        if not errors or not found.keys() <= mechanism.index.keys():
            other.append(key)
        else:
            out |= found
    return out, other
