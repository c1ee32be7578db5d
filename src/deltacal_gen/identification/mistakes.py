"""Mistakes that people make in writing a recording down, and whether one of them explains what a machine is off.

Each is a hypothesis: the problem with the mistake put right, and its words. Those are believed that explain nearly all
of what the machine leaves, and next to none of which another leaves much less.
"""

from __future__ import annotations

import dataclasses
import itertools
from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

import numpy as np

from deltacal_gen.errors import InputError, MisreadReadings, NoSolutionError
from deltacal_gen.estimation.fit import fit, rough
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import unsaid
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.residuals import lengths
from deltacal_gen.estimation.solvers import LeastSquares
from deltacal_gen.identification.rotations import FAR_TURNED, POSES_LOOKED_AT, TURNED, compared, turned
from deltacal_gen.machine.places import misread, read_together
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.rotation import from_turns, from_vector
from deltacal_gen.machine.values import ROTATION
from deltacal_gen.physics.body import Body
from deltacal_gen.units import DEG

IMPLAUSIBLE = 0.005  # of the machine's size: more is no error of stiff parts; mistakes of the recording are looked for
SEED = 2021  # of the poses on which mistakes are tried
NEARER = 0.5  # of the error: a mistake that brings less is not fitted
MOST_FITTED = 4
AS_NEAR = 2.0  # times what the nearest mistake leaves: one that leaves more is not told beside it
UNITS = ((1000.0, "metres"), (25.4, "inches"), (0.001, "micrometres"))  # and how many mm are one of them
EXPLAINED = 0.1  # of the error: what a mistake may leave that explains it
# how the measured point is found while mistakes are compared: they differ by more than a last step
ROUGHLY: Mapping[str, Any] = {
    "robust": False,
    "weigh_repeats": False,
    "drop_gross": False,
    "must_converge": False,
    "tolerance": 1.0,
}

Mistakes = Iterator[tuple[str, Problem]]  # in words, and the problem with each put right


class Tried(NamedTuple):
    """A mistake with which readings are nearer to the machine, what of the error it leaves, and the fit without it."""

    left: float
    words: str
    fit: Fit


def attempt(fitted: Callable[..., Fit], *given: Any, **how: Any) -> Fit | None:
    """Return a fit; None where the machine cannot stand, or readings do not carry it."""
    try:
        return fitted(*given, **how)
    except (InputError, NoSolutionError):
        return None


def sizes(residual: Array, problem: Problem) -> Array:
    """Return the lengths (R,) of residuals (R, k) [mm]."""
    size: Array = np.linalg.norm(np.nan_to_num(lengths(residual, problem.readings.kind)), axis=1)
    return size


def typical(at: Fit) -> float:
    """Return the median length of residuals [mm]."""
    return float(np.median(sizes(at.residual, at.problem)))


def tried(problem: Problem, off: float) -> list[Tried]:
    """Return mistakes, one at a time, with which readings are nearer to the machine, the nearest first.

    Each is looked at with the machine as its file says, on few poses; the few that bring most are fitted. All together
    cost less than a fit. What each leaves of `off` comes with it, by what the readings spread over: in a larger unit
    all is smaller, errors too.
    """
    few = _few(problem)
    looked_at = [(_aligned_error(changed), words, changed) for words, changed in _mistakes(few, problem)]
    most = NEARER * _aligned_error(few)
    out = []
    for _, words, changed in sorted((t for t in looked_at if t[0] < most), key=lambda t: t[0])[:MOST_FITTED]:
        if (again := attempt(rough, changed, must_converge=False)) is not None:
            smaller = min(1.0, _spread(changed) / _spread(few))
            out.append(Tried(typical(again) / (off * smaller), words, again))
    return sorted(out, key=lambda t: t.left)


def turns_alike(first: Fit) -> None:
    """Raise an InputError where measured rotations agree with the machine by another meaning of them, or of joints.

    Of a wrist, rotations alone may tell how its joints count: the point that is measured lies near its axes. Joints
    are asked where most poses tell, and where no other meaning of the rotations does. The machine is the robot file's:
    one that was fitted to such rotations has bent to them.
    """
    found = first.problem.readings
    if not turned(first) or found.rotations is None or not {3, 4, 5} <= {*found.components}:
        return
    few = _few(first.problem)
    off = _turned_off(few)
    for mistakes in (_of_rotations(few), _of_joints(few) if off > FAR_TURNED else ()):
        left = {words: _turned_off(changed) for words, changed in mistakes}
        least = min(left.values(), default=np.inf)
        if least < TURNED * off:
            told = ", or if ".join(words for words, own in left.items() if own <= AS_NEAR * least)
            raise MisreadReadings(
                f"from pose to pose rx_deg, ry_deg, rz_deg turn otherwise than the machine, by {off / DEG:.2g} deg, "
                f"but by no more than {least / DEG:.2g} deg if {told}.",
                "Correct the recording, its sidecar or the robot file.",
                file=first.problem.recording.path,
            )


def _few(problem: Problem) -> Problem:
    """Return the problem of the poses on which mistakes are tried."""
    return problem.some(POSES_LOOKED_AT, np.random.default_rng(SEED))


def _aligned_error(problem: Problem) -> float:
    """Return the median error of the machine as its file says, the instrument aligned; inf where it cannot be.

    Where the file does not say which point was measured, it is found with the instrument: it alone may be off by more
    than a mistake. By what the readings spread over: in other units all are smaller, or larger.
    """
    free, errors = problem.with_names(unsaid(problem)), problem.reference
    try:
        machine = free.solve(errors)
        begun = free.begin(errors, machine)
        if free.names:
            off = typical(fit(free, LeastSquares(), machine=machine, instrument=begun, **ROUGHLY))
        else:
            off = float(np.median(sizes(free.residual(errors, begun, free.seen(machine)), free)))
    except (InputError, NoSolutionError):
        return float("inf")
    return off / _spread(problem)


def _spread(problem: Problem) -> float:
    """Return what readings spread over, in their own unit; one of those that are all the same, as of a surface."""
    found = problem.readings
    read = [c for c in found.components if c < min(3, found.values.shape[1])]
    return float(np.linalg.norm(np.nanstd(found.values[:, read], axis=0))) or 1.0


def _turned_off(problem: Problem) -> float:
    """Return by how much rotations turn more or less than the robot file's machine [rad]; inf where it cannot stand.

    From pose to pose both turn by one angle about one axis of the body, wherever the instrument stands; and the axes of
    all pairs are those of the other body turned by one rotation, that of its mount.
    """
    found = problem.readings
    try:
        drawn = problem.solve(problem.reference).x[found.rows[:, 0], 3:].reshape(-1, 3, 3)
    except (InputError, NoSolutionError):
        return float("inf")
    assert found.rotations is not None
    turns = compared(np.swapaxes(drawn, 1, 2), np.swapaxes(found.rotations, 1, 2), found.setup)
    return 0.0 if turns is None else turns.left


# --------------------------------------------------------------------------------------------------- the hypotheses


def _mistakes(few: Problem, every: Problem) -> Mistakes:
    """Yield what may be wrong with readings of a kind; what neighbours tell is asked of all poses."""
    kind = few.readings.kind
    if kind.positions:
        return itertools.chain(
            _of_frame(few), _of_joints(few), _of_positions(few), _of_units(few), _of_rows(every), _of_links(few)
        )
    if kind.anew:
        return itertools.chain(_of_joints(few), _of_contacts(few), _of_links(few))
    if kind.in_differences(few.recording.measurement):
        return _of_units(few)  # what counts from the first is not told by how long it is
    return iter(())


def _reading(problem: Problem, **changed: Any) -> Problem:
    """Return the problem with other values or rotations."""
    return dataclasses.replace(problem, readings=dataclasses.replace(problem.readings, **changed))


def _recorded(problem: Problem, **changed: Any) -> Problem:
    return dataclasses.replace(problem, recording=dataclasses.replace(problem.recording, **changed))


def _exchanged(values: Array, i: int, j: int) -> Array:
    """Return values (R, n) with two columns exchanged."""
    out = values.copy()
    out[:, [i, j]] = values[:, [j, i]]
    return out


def _of_frame(problem: Problem) -> Mistakes:
    said = problem.recording.measurement
    if said.frame == "robot":
        words = 'the instrument has a frame of its own (frame = "unknown" in the sidecar)'
        yield words, _recorded(problem, measurement=dataclasses.replace(said, frame="unknown"))


def _of_positions(problem: Problem) -> Mistakes:
    """Yield other meanings of columns of positions."""
    found = problem.readings
    values, read = found.values, [c for c in found.components if c < 3]
    for i, j in itertools.combinations(read, 2):
        yield f"{'xyz'[i]}_mm and {'xyz'[j]}_mm are exchanged", _reading(problem, values=_exchanged(values, i, j))
    if found.rotations is not None and np.isfinite(found.rotations).all() and len(read) == 3:
        back = np.swapaxes(found.rotations, 1, 2)
        words = (
            "each pose is the inverse: where a board, or the instrument, is as the platform, or a camera on it, has it"
        )
        yield words, _reading(problem, values=-(back @ values[:, :, None])[:, :, 0], rotations=back)
    if len(read) > 1:
        words = "the instrument's frame is left-handed (one axis counts the other way)"
        yield words, _reading(problem, values=values * np.where(np.arange(3) == read[0], -1.0, 1.0))
    for (factor, unit), i in itertools.product(UNITS, read):
        scale = np.where(np.arange(3) == i, factor, 1.0)
        yield f"{'xyz'[i]}_mm is in {unit}", _reading(problem, values=values * scale)


def _of_units(problem: Problem) -> Mistakes:
    what = "positions" if problem.readings.kind.positions else "lengths"
    for factor, unit in UNITS:
        yield f"all {what} are in {unit}", _reading(problem, values=problem.readings.values * factor)


def _of_rows(problem: Problem) -> Mistakes:
    """Yield readings against the joints of the row before and behind, few of all of them: poses have neighbours."""
    for shift in (1, -1):
        rolled = _reading(problem, values=np.roll(problem.readings.values, shift, axis=0))
        yield "the readings are shifted against the joints by one row", _few(rolled)


def _of_joints(problem: Problem) -> Mistakes:
    """Yield other meanings of the columns of joints."""
    body, q = problem.body, problem.body.q
    count, turning = q.shape[1], np.array(problem.mechanism.joint_units) == "rad"

    def moved(q: Array) -> Problem:
        return dataclasses.replace(problem, body=Body(body.robot, body.mechanism, q, body.tool, body.channels))

    yield "every joint counts the other way ([joints] sign)", moved(-q)
    for i, this in enumerate(np.eye(count)):
        yield f"joint {i + 1} counts the other way ([joints] sign)", moved(q * (1 - 2 * this))
        for turn in (90, -90, 180) if turning[i] else ():
            yield f"the zero of joint {i + 1} is off by {turn} deg", moved(q + turn * DEG * this)
    for (i, table), sign in itertools.product(read_together(problem.robot), (1, -1)):
        words = f"joint {i + 2} counts from a line that stays as joint {i + 1} turns"
        added = sign * q[:, [i]] * np.eye(count)[i + 1]
        yield f"{words} (page arm: coupling = {{{table} = {sign:.1f}}})", moved(q + added)
    if turning.any():
        yield "the joints are in radians", moved(q / np.where(turning, DEG, 1.0))
        for turn in (90, -90):
            yield f"the zeros of all joints are off by {turn} deg", moved(q + turn * DEG * turning)
    for i, j in itertools.combinations(range(count), 2):
        yield f"the columns of joints {i + 1} and {j + 1} are exchanged", moved(_exchanged(q, i, j))


def _of_links(problem: Problem) -> Mistakes:
    """Yield other meanings of the table of a chain's links."""
    for words, robot in misread(problem.robot):
        yield words, pose_problem(robot, problem.recording, problem.names, found=problem.readings)


def _of_contacts(problem: Problem) -> Mistakes:
    """Yield distances between contacts in larger units than mm; with next to none any points would agree."""
    known = problem.recording.contact_distances
    for factor, unit in ((f, u) for f, u in UNITS if f > 1 and known):
        ties = tuple((a, b, factor * mm) for a, b, mm in known)
        yield f"the distances between contacts are in {unit}", _recorded(problem, contact_distances=ties)


def _of_rotations(problem: Problem) -> Mistakes:
    """Yield other meanings of measured rotations."""
    found, recording = problem.readings, problem.recording
    assert found.rotations is not None
    read = np.isfinite(found.rotations[:, 0, 0])
    angles = recording.measured[found.rows[read, 0]][:, [recording.columns.index(name) for name in ROTATION]]

    def meant(rotations: Array) -> Problem:
        own = np.full((len(read), 3, 3), np.nan)
        own[read] = rotations
        return _reading(problem, rotations=own)

    for order in map("".join, itertools.permutations("xyz")):
        words = "they are angles of turns about the instrument's axes, one after the other"
        yield f'{words} (rotation = "{order}" under [measurement] in the sidecar)', meant(from_turns(order, angles))
    yield "they are rotation vectors in rad (columns rx_rad, ry_rad, rz_rad)", meant(from_vector(angles / DEG))
    words = "they are the inverses, of the instrument seen from the platform (the negative of each vector)"
    yield words, meant(from_vector(-angles))
