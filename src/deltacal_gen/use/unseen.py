"""What readings do not tell apart, in a sentence of geometry: most often a motion of the machine as a whole."""

from __future__ import annotations

import numpy as np

from deltacal_gen.files.robot import robot_of
from deltacal_gen.identification.accuracy import check_joints
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.rotation import swept
from deltacal_gen.results.result import Result
from deltacal_gen.units import DEG, to_internal
from deltacal_gen.use import firmware

RIGID = 0.01  # of what a combination moves: the most that is left when it is a motion of the base
STILL = 1e-3  # of what its parameters would move one by one: less is no motion
ALONG = 0.995  # cosine between a direction and an axis that is called by its name
NEARLY = 0.1  # of what a combination moves on a bed: the most that is left of a plain stretch of a print
SHARE = 0.05  # of a motion: a shift or a turn that makes less of it is not told


def explained(found: Result) -> Result:
    """Return a result whose open combinations carry what they do to the machine, where that is simple."""
    each = zip(found.unidentifiable, sentences(found), strict=True)
    return found.replace(unidentifiable=tuple(c.replace(meaning=said) if said else c for c, said in each))


def sentences(found: Result) -> list[str]:
    """Return for each combination that is not seen what it does to the machine; "" where nothing simple is it.

    The parameters move together as the result says; it is looked at over the workspace, at the calibrated machine. Of a
    printer, whose probed heights say little of where things are printed, it is what happens to a print on the bed.
    """
    robot = robot_of(found.robot)
    mechanism, tool = mechanism_of(robot), np.asarray(robot.tool, dtype=float)
    prints = mechanism.name == firmware.PRINTER
    if not found.unidentifiable or (robot.workspace is None and not prints):
        return [""] * len(found.unidentifiable)
    if prints:
        printed = firmware.Printed(robot, mechanism, belts=False)
        q, on_bed = printed.q, printed.on_bed & kind_of(found.readings.kind).probed
        x, _ = mechanism.forward(q, tool, mechanism.rows(robot))
    else:
        q, x, _, _ = check_joints(robot, tool)
        on_bed = np.zeros(len(x), dtype=bool)
    if len(x) < 3:
        return [""] * len(found.unidentifiable)
    moved = mechanism.sensitivity(x, q, tool, mechanism.rows(robot)).parameters[:, :3]
    takes = "the instrument's frame takes it" if found.base_frame else "these readings do not see it"
    units = {p.name: p.unit for p in mechanism.parameters}
    told = []
    for c in found.unidentifiable:
        sentence = ""
        if c.terms.keys() <= units.keys():  # else something of the instrument goes along: its own words say it
            by = mechanism.vector({name: size * to_internal(units[name]) for name, size in c.terms.items()})
            shift, alone = moved @ by, np.abs(moved * by).max()
            if c.seen == "not at all":
                sentence = _told(shift, alone, x[:, :3], takes)
            if not sentence and on_bed.any():
                sentence = _on_the_bed(shift[on_bed], x[on_bed, :3])
        told.append(sentence)
    return told


def _on_the_bed(shift: Array, points: Array) -> str:
    """Say what shifts (N, 3) of points (N, 3) of a bed do to a print; "" where it comes out neither flat nor straight.

    Where it lies on the bed, and how it is turned there, is nothing to a print.
    """
    largest = np.abs(shift).max()
    across = np.column_stack([np.ones(len(points)), points[:, :2]])
    by_place = np.linalg.lstsq(across, shift, rcond=None)[0]
    if np.abs(shift - across @ by_place).max() > NEARLY * largest or np.abs(shift[:, 2]).max() > NEARLY * largest:
        return ""
    slope = by_place[1:, :2].T
    grown, axes = np.linalg.eigh((slope + slope.T) / 2)
    if np.abs(grown).max() * np.ptp(points[:, :2], axis=0).max() < SHARE * largest:
        return "a print is turned or shifted on the bed, and nothing else: probed heights hardly see it"
    turn = np.degrees(np.arctan2(axes[1, 1], axes[0, 1])) % 180.0
    along, over = (f"{abs(part):.2%} {'longer' if part > 0 else 'shorter'}" for part in grown[::-1])
    return (
        f"a print comes out {along} at {turn:.0f} deg from x and {over} across, as flat as now: probed heights hardly "
        "see it"
    )


def _told(shift: Array, alone: float, points: Array, takes: str) -> str:
    """Say what shifts (N, 3) of points (N, 3) are, and what `takes` a motion of the machine as a whole.

    `alone` is the largest that a parameter makes by itself [mm].
    """
    largest = np.abs(shift).max()
    if largest <= STILL * alone:
        return "the measured point stays where it is, wherever the machine stands"
    turns = swept(points - points.mean(axis=0))
    A = np.concatenate([np.tile(np.eye(3), (len(points), 1, 1)), turns], axis=2)
    motion = np.linalg.lstsq(A.reshape(-1, 6), shift.ravel(), rcond=None)[0]
    if np.abs(shift - A @ motion).max() > RIGID * largest:
        return ""
    along, about = motion[:3], motion[3:]
    shares = [np.abs(along).max(), np.abs(A[:, :, 3:] @ about).max()]
    parts = []
    if shares[1] > SHARE * largest:
        parts.append(f"turned about {_axis(about)} ({np.linalg.norm(about) / DEG:.2g} deg)")
    if shares[0] > SHARE * largest:
        parts.append(f"shifted along {_axis(along)} ({np.linalg.norm(along):.2g} mm)")
    return f"the machine as a whole {' and '.join(parts)}: {takes}"


def _axis(direction: Array) -> str:
    unit = direction / np.linalg.norm(direction)
    k = int(np.argmax(np.abs(unit)))
    return "xyz"[k] if abs(unit[k]) > ALONG else f"({', '.join(f'{round(v, 2) + 0.0:.2f}' for v in unit)})"  # no -0.00
