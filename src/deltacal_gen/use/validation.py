"""Validation: a calibrated model on readings that it has not seen.

Pose accuracy and repeatability follow ISO 9283 (section 7.2): per pose, accuracy AP is the distance from the wanted
to the mean attained position, repeatability RP the mean plus three standard deviations of the distances from that
mean. They need repeats of a pose; at fewer than two readings they are not given, and never guessed.
"""

from __future__ import annotations

import itertools
from typing import Literal

import numpy as np

from deltacal_gen.diagnosis.spectrum import never_seen
from deltacal_gen.errors import InputError, NoSolutionError
from deltacal_gen.estimation.residuals import APART, GROSS, MOST_APART, lengths, rms, wrongly_found
from deltacal_gen.instrument.kind import Instrument, Kind, Readings
from deltacal_gen.instrument.kinds import instrument_of, readings
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.rotation import from_vector, to_vector
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.motion import with_motion
from deltacal_gen.results.diagnosis import Diagnosis
from deltacal_gen.results.result import Result
from deltacal_gen.results.validation import Apart, AxisPlace, Iso230, Iso9283, Placed, Row, Validation
from deltacal_gen.units import DEG, file_unit, of_joints, to_internal
from deltacal_gen.use import iso230, iso9283
from deltacal_gen.use.prediction import (
    Known,
    Place,
    beyond_laws,
    beyond_waves,
    calibrated_robot,
    has_law,
    prediction_problem,
    residual,
    unknown_setups,
)

Why = Literal["unknown", "elsewhere"]
WORST = 10  # readings that are listed
FOLDS = 10  # in which poses are left out of the placing
SUSPECT = 3.0  # noises: less misfit than this is not asked for its cause
MOVED = 0.99  # of the squared misfit: what a motion of the instrument must take to have caused it


def validate(result: Result | Diagnosis, recording: Recording) -> Validation:
    """Return the error of a result on other readings, in the instrument frame that the result knows.

    A set-up that the result does not know, or that stands elsewhere by now, is placed by the readings themselves. Its
    unknowns (six, in space) are no degrees of freedom, and the errors are then of poses left out in turn: each is
    predicted from where the others place the instrument.

    Raises
    ------
    InputError
        The readings of such a set-up leave open where it stands.
    """
    found = readings(recording)
    anew: dict[str, Why] = dict.fromkeys(unknown_setups(result, recording), "unknown")
    placeable = has_place(result, recording, found)
    if placeable and len(anew) < len(recording.setup_names):
        anew |= _elsewhere(result, recording, found, frozenset(anew))
    place = Place(recording, found, frozenset(anew)) if placeable and anew else None
    r = left = residual(result, recording, found, place)
    placed: tuple[Placed, ...] = ()
    if place is not None:
        left, placed = _left_out(result, recording, found, anew, r)
    wrong = wrongly_found(left, found)
    left[wrong], r[wrong] = np.nan, np.nan
    read, size = lengths(left[~wrong], found.kind), error_sizes(left[~wrong], found.kind)
    worst = np.argsort(-size)[:WORST]
    degrees = int(np.isfinite(read).sum()) - sum(p.unknowns for p in placed)
    good = degrees > 0 and result.sigma_mm > 0
    known = instrument_of(result.instrument)
    unit = known.unit(recording.columns) if known.kind == found.kind else None
    return Validation(
        kind=found.kind.name,
        readings=int((~wrong).sum()),
        rms_mm=rms(read),
        worst_mm=float(size[worst[0]]),
        sigma_mm=result.sigma_mm,
        chi2_per_dof=float(np.nansum(lengths(r, found.kind) ** 2)) / degrees / result.sigma_mm**2 if good else None,
        degrees_of_freedom=degrees,
        placed=placed or None,
        rows=tuple(Row(line=int(found.line[~wrong][j]), error_mm=float(size[j])) for j in worst),
        unit=unit and unit[0],
        unit_mm=unit and unit[1],
        gross_errors=tuple(found.line[wrong].tolist()) if found.kind.picked else None,
        apart=_apart(result.sigma_mm, found, left),
        outside_law=int(beyond_laws(result, recording).sum()) if has_law(result) else None,
        repairs=recording.repairs or None,
        never_seen=never_seen(result.seen, calibrated_robot(result).joint_sign * recording.joints),
        beyond_waves=beyond_waves(result, recording) or None,
        iso9283=_repeated(found, left) if found.kind.positions else None,
        iso230=_of_axis(found, left, recording) if found.kind.positions else None,
    )


def error_sizes(r: Array, kind: Kind) -> Array:
    """Return how long residuals (R, k) are, (R,) [mm]; a component that was not read counts nothing."""
    return np.asarray(np.linalg.norm(np.nan_to_num(lengths(r, kind)), axis=1))


def has_place(result: Known, recording: Recording, found: Readings) -> bool:
    """Tell whether something must be known of where the instrument stands."""
    of_its_own = found.kind.anew or found.kind.stays
    return bool(found.kind.unknown) and recording.measurement.frame != "robot" and not of_its_own


def _elsewhere(
    result: Result | Diagnosis, recording: Recording, found: Readings, unknown: frozenset[str]
) -> dict[str, Why]:
    """Return the set-ups that the result knows and that stand elsewhere: moving them takes nearly all of the misfit.

    What the machine has become is no motion of it as a whole, so that nothing else takes so much.
    """
    known = residual(result, recording, found, Place(recording, found, unknown))
    elsewhere: dict[str, Why] = {}
    for k, name in enumerate(recording.setup_names):
        own = found.setup == k
        misfit = _rms(known[own], found)
        if name in unknown or not misfit > SUSPECT * result.sigma_mm:
            continue
        mine = found.subset(own)
        try:
            moved = residual(result, recording, mine, Place(recording, mine, frozenset([name])))
        except (InputError, NoSolutionError):  # too few readings to tell
            continue
        if _rms(moved, found) ** 2 < (1 - MOVED) * misfit**2:
            elsewhere[name] = "elsewhere"
    return elsewhere


def _rms(r: Array, found: Readings) -> float:
    return rms(lengths(r[~wrongly_found(r, found)], found.kind))


def _left_out(
    result: Result | Diagnosis, recording: Recording, found: Readings, anew: dict[str, Why], r: Array
) -> tuple[Array, tuple[Placed, ...]]:
    """Return residuals (R, k) of readings left out of the placing in turn, and what was placed.

    A set-up of too few poses to leave some out keeps the residuals `r` of its placing by all.
    """
    left, placed = r.copy(), []
    for name, why in anew.items():
        own = np.flatnonzero(found.setup == recording.setup_names.index(name))
        mine = found.subset(own)
        poses = np.unique(mine.group)
        out = True
        for fold in np.array_split(poses, min(FOLDS, len(poses))) if len(poses) > 1 else ():
            tested = np.isin(mine.group, fold)
            try:
                place = Place(recording, mine.subset(~tested), frozenset([name]))
                left[own[tested]] = residual(result, recording, mine.subset(tested), place)
            except (InputError, NoSolutionError):
                left[own], out = r[own], False
                break
        everything = Place(recording, mine, frozenset([name]))
        _, stands = prediction_problem(result, recording, mine, everything)
        moved: dict[str, float] = {}
        if why == "elsewhere":
            before = prediction_problem(result, recording, mine)[1]
            known = residual(result, recording, mine)
            moved = {"rms_where_known_mm": _rms(known, found), **_motion(before, stands, result, name)}
        placed.append(Placed(setup=name, why=why, unknowns=len(stands.free), readings=len(own), left_out=out, **moved))
    return left, tuple(placed)


def _motion(before: Instrument, after: Instrument, result: Result | Diagnosis, name: str) -> dict[str, float]:
    """Return by how much {O} has moved as the instrument sees it; nothing of an instrument without a frame."""
    setups = result.instrument.setups
    old, new = before.frames(), after.frames()
    if not old or not new:
        return {}
    (turn, origin), (turned, moved) = old[setups.index(name) if name in setups else 0], new[-1]
    angle = np.linalg.norm(to_vector((from_vector(turned[None])[0] @ from_vector(turn[None])[0].T)[None])[0])
    return {"shift_mm": float(np.linalg.norm(moved - origin)), "turn_deg": float(angle / DEG)}


def _apart(sigma: float, found: Readings, r: Array) -> Apart | None:
    """Return the readings that are far off and no others nearly so; None where there are none, or too many."""
    size = error_sizes(r, found.kind)
    order = np.argsort(-size)
    most = int(MOST_APART * len(size))
    least, next_to_it = size[order[:most]], size[order[1 : most + 1]]
    gaps = np.flatnonzero((least > APART * next_to_it) & (least > GROSS * sigma))
    if not len(gaps):
        return None
    far, others = order[: gaps[-1] + 1], order[gaps[-1] + 1 :]
    return Apart(
        lines=tuple(found.line[far].tolist()),
        rms_of_others_mm=rms(lengths(r[others], found.kind)),
        largest_of_others_mm=float(size[others[0]]),
    )


def _repeated(found: Readings, r: Array) -> Iso9283 | None:
    """Return the figures of ISO 9283 for poses that were read at least twice, None where none was."""
    several = [g for g, n in enumerate(np.bincount(found.group)) if n > 1]
    if not several:
        return None
    r = np.where(np.isnan(r).all(axis=0), 0.0, r)  # coordinates that nothing reads
    # residuals: attained minus wanted
    figures = [iso9283.pose(r[found.group == g, :3], np.zeros(3)) for g in several]
    AP, RP = np.transpose([(f.accuracy, f.repeatability) for f in figures])
    return Iso9283(
        poses=len(several),
        AP_mean_mm=float(AP.mean()),
        AP_max_mm=float(AP.max()),
        RP_mean_mm=float(RP.mean()),
        RP_max_mm=float(RP.max()),
        **_distances(found, r, several),
        note="wanted is what the calibrated model predicts at the joints commanded",
    )


def _of_axis(found: Readings, r: Array, recording: Recording) -> Iso230 | None:
    """Return the figures of ISO 230-2 where one coordinate of one joint was read, None elsewhere."""
    (read,) = np.nonzero(np.isfinite(found.values).any(axis=0))
    way = with_motion(recording).channels.get("approach1")
    if len(read) != 1 or recording.joints.shape[1] != 1 or way is None:
        return None
    rows = found.rows[:, 0]
    done = iso230.axis(r[:, read[0]], found.group, way[rows])
    if done is None:
        return None
    (unit,) = map(file_unit, of_joints(recording.joint_unit, 1))
    first = np.array([rows[found.group == p][0] for p in done.positions])
    at = recording.joints[first, 0] / to_internal(unit)
    rows_by_place = np.column_stack([at, done.means, done.spreads])[np.argsort(at)].tolist()
    names = ("at", "up_mm", "down_mm", "up_std_mm", "down_std_mm")
    return Iso230(
        poses=len(done.positions),
        **{f"{letter}_mm": getattr(done, letter) for letter in "AERBM"},
        unit=unit,
        places=tuple(AxisPlace(**dict(zip(names, row, strict=True))) for row in rows_by_place),
        note="wanted is what the calibrated model predicts at the joint commanded",
    )


def _distances(found: Readings, r: Array, several: list[int]) -> dict[str, float]:
    """Return the distance accuracy between neighbouring repeated poses that were visited equally often."""
    figures = []
    for a, b in itertools.pairwise(several):
        first, second = found.group == a, found.group == b
        if first.sum() == second.sum():
            at, to = np.nan_to_num(found.values[first]), np.nan_to_num(found.values[second])
            wanted = np.linalg.norm((to - r[second, :3]).mean(axis=0) - (at - r[first, :3]).mean(axis=0))
            figures.append(iso9283.distance(at, to, float(wanted)))
    if not figures:
        return {}
    AD, RD = np.transpose([(abs(f.accuracy), f.repeatability) for f in figures])
    return {"AD_mean_mm": float(AD.mean()), "AD_max_mm": float(AD.max()), "RD_max_mm": float(RD.max())}
