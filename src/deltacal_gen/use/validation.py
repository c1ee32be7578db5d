"""Validation: a calibrated model on readings that it has not seen.

Pose accuracy and repeatability follow ISO 9283 (section 7.2): per pose, accuracy AP is the distance from the wanted
to the mean attained position, repeatability RP the mean plus three standard deviations of the distances from that
mean. They need repeats of a pose; at fewer than two readings they are not given, and never guessed.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterable

import numpy as np

from deltacal_gen.diagnosis.spectrum import never_seen
from deltacal_gen.estimation.estimation import lengths
from deltacal_gen.files.recording import Recording
from deltacal_gen.instrument.kinds import readings
from deltacal_gen.instrument.readings import Readings
from deltacal_gen.machine.registry import Array
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.result import Result
from deltacal_gen.results.validation import Iso9283, Row, Validation
from deltacal_gen.use import iso9283
from deltacal_gen.use.prediction import calibrated_robot, residual

__all__ = ["calibrated_robot", "validate"]
WORST = 10  # readings that are listed


def validate(result: Result | Diagnosis, recording: Recording) -> Validation:
    """Return the error of a result on other readings, in the instrument frame that the result knows."""
    found = readings(recording)
    r = residual(result, recording, found)
    return figures(result.sigma_mm, [(found, r)]).replace(
        never_seen=never_seen(result.seen, calibrated_robot(result).joint_sign * recording.joints),
        iso9283=_repeated(found, r) if found.kind.positions else None,
    )


def _repeated(found: Readings, r: Array) -> Iso9283 | None:
    """Return the figures of ISO 9283 for poses that were read at least twice, None where none was."""
    several = [g for g, n in enumerate(np.bincount(found.group)) if n > 1]
    repeated = [iso9283.pose(r[found.group == g, :3], np.zeros(3)) for g in several]  # residuals: attained minus wanted
    if not repeated:
        return None
    return Iso9283(
        poses=len(repeated),
        AP_mean_mm=float(np.mean([f.accuracy for f in repeated])),
        AP_max_mm=float(np.max([f.accuracy for f in repeated])),
        RP_mean_mm=float(np.mean([f.repeatability for f in repeated])),
        RP_max_mm=float(np.max([f.repeatability for f in repeated])),
        **_distances(found, r, several),
        note="wanted is what the calibrated model predicts at the joints commanded",
    )


def figures(sigma: float, parts: Iterable[tuple[Readings, Array]]) -> Validation:
    """Return what `validate` says of readings one by one, against noise of `sigma` [mm].

    They come in parts, each with its residuals (R, k).
    """
    count = scalars = 0
    squares = 0.0
    rows: list[Row] = []
    for found, r in parts:
        read = lengths(r, found.kind)
        size = np.linalg.norm(np.nan_to_num(read), axis=1)
        read = read[np.isfinite(read)]
        count, scalars, squares = count + len(found), scalars + len(read), squares + float(read @ read)
        rows += [Row(line=int(found.line[j]), error_mm=float(size[j])) for j in np.argsort(-size)[:WORST]]
        rows = sorted(rows, key=lambda row: -row.error_mm)[:WORST]
    error = float(np.sqrt(squares / scalars)) if scalars else float("nan")
    return Validation(
        kind=found.kind.name,
        readings=count,
        rms_mm=error,
        worst_mm=rows[0].error_mm,
        sigma_mm=sigma,
        chi2_per_dof=(error / sigma) ** 2 if sigma > 0 else None,
        never_seen=(),
        rows=tuple(rows),
    )


def _distances(found: Readings, r: Array, several: list[int]) -> dict[str, float]:
    """Return the distance accuracy between neighbouring repeated poses that were visited equally often."""
    figures = []
    for a, b in itertools.pairwise(several):
        first, second = found.group == a, found.group == b
        if first.sum() == second.sum():
            at, to = found.values[first], found.values[second]
            wanted = np.linalg.norm((to - r[second, :3]).mean(axis=0) - (at - r[first, :3]).mean(axis=0))
            figures.append(iso9283.distance(at, to, float(wanted)))
    if not figures:
        return {}
    return {
        "AD_mean_mm": float(np.mean([abs(f.accuracy) for f in figures])),
        "AD_max_mm": float(np.max([abs(f.accuracy) for f in figures])),
        "RD_max_mm": float(np.max([f.repeatability for f in figures])),
    }
