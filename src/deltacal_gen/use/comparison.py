"""Two sessions of one machine: how far it moved, which combinations and parameters changed, and which did not.

Results hold actual minus robot file; sessions of a printer often start from different files, so what differs between
the files counts too. A change is called one when noise would rarely make the largest of so many differences.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Any

import numpy as np

from deltacal_gen.errors import OtherMachine, WrongFile
from deltacal_gen.files.robot import Robot, robot_of
from deltacal_gen.identification.accuracy import check_joints
from deltacal_gen.machine.differences import between
from deltacal_gen.machine.registry import SOLVED, Array, mechanism_of
from deltacal_gen.machine.rotation import align
from deltacal_gen.results.comparison import Change, Comparison, Moved
from deltacal_gen.results.diagnosis import Diagnosis, Effect, Geometry
from deltacal_gen.results.document import rounded
from deltacal_gen.results.motion import MotionDiagnosis, MotionResult
from deltacal_gen.results.result import Result, Status
from deltacal_gen.units import file_unit, to_internal

ROUNDED = 0.01  # by which factors of a combination may differ, of its largest: the poses of two sessions do
Calibration = Result | Geometry  # a calibrated machine: the second beside a diagnosis that found nothing else
Found = MotionResult | MotionDiagnosis | Diagnosis
CHANCE = 0.01  # that noise alone makes any of all parameters look changed


def compare(before: Calibration, after: Calibration) -> Comparison:
    """Return what changed from one result of `identify` to another of the same machine.

    Raises
    ------
    InputError
        Results of different mechanisms, or robot files that differ in what no parameter carries.
    """
    first, second = robot_of(before.robot), robot_of(after.robot)
    if first.mechanism != second.mechanism:
        raise OtherMachine(
            f"the results are of different machines: {first.mechanism} and {second.mechanism}.",
            "Give two sessions of one machine.",
        )
    mechanism = mechanism_of(first)
    files, other = between(mechanism, first, second)
    if other:
        raise OtherMachine(
            f"the robot files differ in {', '.join(other)}, which no parameter of the model carries.",
            "Identify both sessions from the same robot file.",
        )
    told = [{p.name: p for p in r.parameters} for r in (before, after)]
    if missing := [p.name for p in mechanism.parameters if any(p.name not in t for t in told)]:
        raise WrongFile(f"a result does not hold {missing[0]}.", "Give the file as it was written.")
    entries = []
    for p in mechanism.parameters:
        a, b = (t[p.name] for t in told)
        # the robots hold all that is known; a file that was calibrated before has a part of it in its own table
        gap = files.get(p.name, 0.0) + second.errors.get(p.name, 0.0) - first.errors.get(p.name, 0.0)
        fixed = [x.status is Status.FIXED for x in (a, b)]
        if gap or not all(fixed):
            stds = [0.0 if f and x.std is None else x.std for x, f in zip((a, b), fixed, strict=True)]
            by, unit = gap / to_internal(p.unit), file_unit(p.unit)
            entries.append(
                Change(name=p.name, before=a.value, after=a.value + by, change=by, std=_both(*stds), unit=unit)
            )
    same_file = not files and first.errors.keys() == second.errors.keys()
    combined = _combinations(before, after) if same_file and any(e.std is None for e in entries) else []
    said = [r.flattered for r in (before, after) if isinstance(r, Result)]
    return _compared(entries, combined, _moved(first, second), said)


def compare_in_motion(before: MotionResult | MotionDiagnosis, after: MotionResult | MotionDiagnosis) -> Comparison:
    """Return what changed between two recordings in motion of one machine: base parameters, or friction joint by joint.

    Raises
    ------
    InputError
        Results of different machines, or a result and a diagnosis.
    """
    if type(before) is not type(after) or before.inertial != after.inertial or before.columns != after.columns:
        raise WrongFile(
            "the answers are not of one kind: of the same machine and reading, both of identify or both of diagnose.",
            "Give two sessions of one machine.",
        )
    return compare_numbers(before, after)


def compare_numbers(before: Found, after: Found) -> Comparison:
    """Return what changed of all that two answers of one sort state: base parameters, or those of effects and formulas.

    What one of two diagnoses names and the other does not is unknown: there it was too small to be seen, not nothing.
    """
    told = [_numbers(r) for r in (before, after)]
    entries = []
    for name in dict.fromkeys((*told[0], *told[1])):
        unit = next(t[name][2] for t in told if name in t)
        (a, s_a, _), (b, s_b, _) = (t.get(name, (0.0, None, unit)) for t in told)
        entries.append(Change(name=name, before=a, after=b, change=b - a, std=_both(s_a, s_b), unit=unit))
    return _compared(entries)


def _both(one: float | None, other: float | None) -> float | None:
    """Return the standard uncertainty of a difference; None where that of either part is unknown."""
    return None if one is None or other is None else float(np.hypot(one, other))


def _compared(
    entries: Sequence[Change], combined: Sequence[Change] = (), moved: Moved | None = None, said: Sequence[str] = ()
) -> Comparison:
    """Return what changed of all entries; `combined` stand for those that are unknown one by one."""
    from scipy.special import ndtri  # half of a command's start, of which few compare

    unknown = [e for e in entries if e.std is None]
    limit = float(-ndtri(CHANCE / 2 / max(len(entries) - len(unknown), len(combined), 1)))
    (changed, unchanged), (new, old) = _told_apart(entries, limit), _told_apart(combined, limit)
    summary = _summary(moved, new if combined else changed, old if combined else unchanged, len(unknown), limit)
    return Comparison(
        summary=" ".join([summary, *filter(None, said)]),
        moved=moved,
        limit_std=limit,
        changed=tuple(changed),
        unchanged=tuple(unchanged),
        unknown=tuple(unknown),
        combinations_changed=tuple(new) if combined else None,
        combinations_unchanged=tuple(old) if combined else None,
    )


def _numbers(found: Found) -> dict[str, tuple[float, float | None, str]]:
    """Return value, deviation and unit of all numbers of an answer, by names that tell what and of which joint."""

    def of(p: Any) -> tuple[float, float | None, str]:
        return p.value, p.std, p.unit

    if isinstance(found, MotionResult):
        return {p.name if p.limb is None else f"{p.name} of joint {p.limb}": of(p) for p in found.base}
    named = {
        f"{e.name}{_order(e)} {p.label}{_limb(p.limb)}": of(p)
        for e in found.effects
        for p in e.parameters
        if not isinstance(p.value, str)
    }
    return named | {
        f"formula {t.target} = {t.expression}: {c.name}{_limb(c.limb or next(iter(t.limbs), None))}": of(c)
        for law in found.laws
        for t in law.terms
        for c in t.coefficients
    }


def _limb(limb: int | None) -> str:
    return "" if limb is None else f"_{limb}"


def _order(effect: Effect) -> str:
    """Return what tells two effects of one name apart."""
    return "".join(f" {order:g}" for order in dict.fromkeys(effect.periods))


def _told_apart(entries: Sequence[Change], limit: float) -> tuple[list[Change], list[Change]]:
    """Return those that changed, the clearest first, and those that did not; those without a deviation are neither."""
    sizes = [(abs(e.change), e.std, e) for e in entries if e.std is not None]
    changed = sorted((s for s in sizes if s[0] > limit * s[1]), key=lambda s: -s[0] / max(s[1], 1e-300))
    return [e for *_, e in changed], [e for size, std, e in sizes if not size > limit * std]


def _moved(first: Robot, second: Robot) -> Moved | None:
    """Return how far the second machine stands off the first one at the same joints, {O} aligned."""
    if first.workspace is None:
        return None
    mechanism, tool = mechanism_of(first), np.asarray(first.tool, dtype=float)
    q, x, _, _ = check_joints(first, tool)
    other, status = mechanism.forward(q, tool, mechanism.rows(second))
    solved = status == SOLVED
    a, b = x[solved, :3], other[solved, :3]
    if not len(a):
        return None
    off = sizes_aligned(a, b)
    worst = int(np.argmax(off))
    return Moved(
        rms_mm=float(np.sqrt(np.mean(off**2))),
        worst_mm=float(off[worst]),
        worst_at_mm=tuple(a[worst].tolist()),
        poses=len(a),
    )


def sizes_aligned(wanted: Array, reached: Array) -> Array:
    """Return how far (N,) reached points (N, 3) are from wanted ones after the rigid motion that fits the two best."""
    a, b = wanted - wanted.mean(axis=0), reached - reached.mean(axis=0)
    return np.asarray(np.linalg.norm(b - a @ align(a, b).T, axis=1))


def _combinations(before: Calibration, after: Calibration) -> list[Change]:
    """Return the combinations of parameters that both sessions determine, those that are alike."""
    if not isinstance(before, Result) or not isinstance(after, Result):
        return []
    then = {b.name: b for b in before.base or ()}
    pairs = ((then[now.name], now) for now in after.base or () if now.name in then)
    return [
        Change(
            name=now.combination,
            before=was.value,
            after=now.value,
            change=now.value - was.value,
            std=_both(was.std, now.std),
            unit=now.unit,
        )
        for was, now in pairs
        if _alike(was.combination, now.combination)
    ]


def _alike(one: str, other: str) -> bool:
    """Tell whether two combinations hold the same parameters with the same factors, but for rounding."""
    a, b = _factors(one), _factors(other)
    return a.keys() == b.keys() and all(abs(a[n] - b[n]) <= ROUNDED * max(map(abs, a.values())) for n in a)


def _factors(combination: str) -> dict[str, float]:
    """Return the factors of a combination, ``theta_1 - 0.5 ez_3``, by parameter."""
    terms = re.findall(r"([+-]?)\s*(\d[\d.e+-]*)?\s*([A-Za-z]\w*)", combination)
    return {name: float(factor or 1.0) * (-1.0 if sign == "-" else 1.0) for sign, factor, name in terms}


def in_words(changed: Sequence[Change]) -> list[str]:
    """Return changes in words: ``backlash width_2 moved +0.0100 +- 0.0014 deg``."""
    shown = (("+" * (e.change > 0) + " +- ".join(rounded(e.change, e.std)), e) for e in changed)
    return [f"{e.name} moved {by} {e.unit}" for by, e in shown]


def _summary(moved: Moved | None, changed: Sequence[Change], same: Sequence[Change], unknown: int, limit: float) -> str:
    text = "; ".join(in_words(changed)) or "Nothing moved that these sessions can see"
    if same:
        text += f"; the other {len(same)} stayed within {limit:.1f} standard deviations of what they were"
    if unknown:
        text += f"; of {unknown} parameters these readings say nothing one by one"
    if moved is None:
        return f"{text}."
    at = ", ".join(f"{v:.0f}" for v in moved.worst_at_mm)
    return (
        f"Over its workspace the machine moved by {moved.rms_mm:.4f} mm rms, by {moved.worst_mm:.4f} mm at worst, at "
        f"({at}) mm. {text}."
    )
