"""Two sessions of one machine: what changed between them, by parameter, and what did not.

Results hold actual minus robot file; sessions of a printer often start from different files, so what differs between
the files counts too. A change is called one when noise would rarely make the largest of so many differences.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from deltacal_gen.errors import InputError
from deltacal_gen.files.robot import robot_of
from deltacal_gen.machine.differences import between
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.results.comparison import Change, Comparison
from deltacal_gen.results.parts import RobotTables
from deltacal_gen.results.result import Parameter, Result, Status
from deltacal_gen.units import file_unit, to_internal

FEW = 0.5  # of the readings: a fit that leaves fewer to judge it by takes a good part of the noise away
CHANCE = 0.01  # that noise alone makes any of all parameters look changed


class Calibration(Protocol):
    """A calibrated machine: a result, or the geometry beside a diagnosis that found nothing else."""

    @property
    def robot(self) -> RobotTables: ...

    @property
    def parameters(self) -> tuple[Parameter, ...]: ...


def compare(before: Calibration, after: Calibration) -> Comparison:
    """Return what changed from one result of `identify` to another of the same machine.

    Raises
    ------
    InputError
        Results of different mechanisms, or robot files that differ in what no parameter carries.
    """
    first, second = robot_of(before.robot), robot_of(after.robot)
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

    told = [{p.name: p for p in r.parameters} for r in (before, after)]
    entries = []
    for p in mechanism.parameters:
        a, b = (t[p.name] for t in told)
        # the robots hold all that is known; a file that was calibrated before has a part of it in its own table
        gap = files.get(p.name, 0.0) + second.errors.get(p.name, 0.0) - first.errors.get(p.name, 0.0)
        free = [x.status is not Status.FIXED for x in (a, b)]
        if not any(free) and gap == 0:
            continue
        known = all(x.std is not None or not f for x, f in zip((a, b), free, strict=True))
        std = float(np.hypot(a.std or 0.0, b.std or 0.0)) if known else None
        change = gap / to_internal(p.unit)
        entries.append(
            Change(
                name=p.name,
                before=a.value,
                after=a.value + change,
                change=change,
                std=std,
                unit=file_unit(p.unit),
            )
        )
    unknown = [e for e in entries if e.std is None]
    limit = float(-ndtri(CHANCE / 2 / max(len(entries) - len(unknown), 1)))
    sizes = [(abs(e.change), e.std, e) for e in entries if e.std is not None]
    changed = sorted((s for s in sizes if s[0] > limit * s[1]), key=lambda s: -s[0] / max(s[1], 1e-300))
    moved, unchanged = [e for *_, e in changed], [e for size, std, e in sizes if not size > limit * std]
    fits = [r for r in (before, after) if isinstance(r, Result)]
    said = [flattered(r.degrees_of_freedom, r.readings.scalars, r.train_rms_mm) for r in fits]
    return Comparison(
        summary=_summary(moved, unchanged, unknown, limit) + "".join(f" {words}" for words in said if words),
        limit_std=limit,
        changed=tuple(moved),
        unchanged=tuple(unchanged),
        unknown=tuple(unknown),
    )


def _summary(changed: Sequence[Change], same: Sequence[Change], unknown: Sequence[Change], limit: float) -> str:
    parts = [f"{e.name} moved {e.change:+.4g} +- {e.std:.2g} {e.unit}" for e in changed]
    text = "; ".join(parts) if parts else "Nothing moved that these sessions can see"
    if same:
        text += f"; the other {len(same)} stayed within {limit:.1f} standard deviations of what they were"
    if unknown:
        text += f"; of {', '.join(e.name for e in unknown)} these readings say nothing"
    return text + "."


def flattered(left: float | None, readings: int, rms: float) -> str:
    """Say by how much the residual of a fit understates the noise, where its readings are few; else nothing.

    Parameters
    ----------
    left : float or None
        Degrees of freedom: readings less parameters.
    rms : float
        Of the residual [mm].
    """
    if left is None or left > FEW * readings:
        return ""
    said = f"{readings} readings less {readings - left:.1f} parameters leave {max(left, 0):.1f} degrees of freedom"
    if left < 1:
        return f"{said}: the residual of {rms:.3g} mm says nothing of the noise."
    part = float(np.sqrt(left / readings))
    return (
        f"{said}: noise of {rms / part:.3g} mm leaves a residual of {rms:.3g} mm, "
        f"and the next session of an unchanged machine, predicted from this one, at least {1 / part:.2g} times as much."
    )
