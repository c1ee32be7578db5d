"""Recordings whose misfit several effects explain, and what one round of the proposed readings makes of them.

The first session is confined: poses in a part of the workspace, or a temperature that rises with time.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.terms import Term, load_effect
from deltacal_gen.results.diagnosis import Row
from deltacal_gen.use.experiments import next_rows, open_questions, shared
from tests.benchmarks.honesty_nulls import ROBOT
from tests.conftest import plausible
from tests.every_effect import sized
from tests.left_out import DELTA, channels, machine, record

NEAR = machine(workspace={"radius": 250.0, "height": 400.0})  # where rods hang straight
POSES, LIMB = 60, (2,)
SORTS = {  # the effect that is there, up to how far it moves what is read [mm], and the channels that were recorded
    "joint_compliance": (0.8, ("payload",)),
    "proximal_bending": (0.8, ("payload",)),
    "payload_deflection": (0.5, ("payload",)),
    "distal_compliance": (1.5, ()),
    "thermal_zero": (0.1, ("time", "temp")),
    "zero_drift": (0.3, ("time", "temp")),
    "zero_jump": (0.1, ("time", "temp")),
    "tool_slip": (0.04, ("time",)),
    "friction_windup": (0.06, ("approach",)),
    "backlash": (0.03, ("approach", "payload")),
}


def round_of(sort: str, k: int) -> dict[str, Any]:
    """Return what a diagnosis of the k-th recording of a sort says, and what it says after one round of proposals.

    `open` says that it was ambiguous, `answered` that poses are proposed for every rival.
    """
    of = channels(POSES, *SORTS[sort][1], seed=k)
    term = _true(sort, of, k)
    errors = plausible(DELTA, 1000 + k, size=0.3)
    joints = np.degrees(record(NEAR, n=POSES, seed=k, sigma=0.0).joints)
    first = record(ROBOT, term, n=POSES, seed=k, joints=joints, of=of, errors=errors, declared=k % 2 > 0)
    found = diagnose(ROBOT, first).answer()
    entries = [e for e in found.next_measurements if e.separates and _rivals(e.separates)]
    out = {
        "open": any(_rivals((e.name, *e.indistinguishable_from)) for e in found.effects),
        "truth in the set": any(sort in (e.name, *e.indistinguishable_from) for e in found.effects),
        "answered": bool(entries) and all(e.poses for e in entries),
    }
    questions = open_questions(found)
    if not out["open"] or not questions:
        return out
    rows = next_rows(questions, shared(questions, None))
    made = _extended(first, rows)
    joints = np.vstack([joints, [[float(row[f"q{i}_deg"]) for i in (1, 2, 3)] for row in rows]])
    then = record(ROBOT, term, n=len(joints), seed=k, joints=joints, of=made, errors=errors, declared=k % 2 > 0)
    after = diagnose(ROBOT, then).answer()
    names = [e.name for e in after.effects]
    alone = names == [sort] and not _rivals((sort, *after.effects[0].indistinguishable_from))
    wrong = bool(names) and not any(sort in (e.name, *e.indistinguishable_from) for e in after.effects)
    return out | {"alone after a round": alone, "wrong after a round": wrong, "rows": len(rows)}


def _rivals(names: Sequence[str]) -> bool:
    """Tell whether one of several effects is another than the first: what becomes it in a limit none can refute."""
    return any(names[0] != load_effect(name).EXTENDS for name in names[1:])


def _extended(first: Recording, rows: list[Row]) -> dict[str, np.ndarray]:
    return {
        name: np.concatenate([values, [float(row.get(name, values[-1])) for row in rows]])
        for name, values in first.channels.items()
    }


def _true(name: str, of: dict[str, np.ndarray], k: int) -> Term:
    term = sized(name, () if name == "tool_slip" else LIMB, SORTS[name][0])
    if "moments" not in term.kernels.SEARCHED:
        return term
    return dataclasses.replace(term, constants=(float(of["time_s"][20 + k % 20]) - 1.0,))
