"""Mistakes that people make in writing a recording down, and whether one of them explains what a machine is off."""

from __future__ import annotations

import dataclasses
import functools
import itertools
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

import numpy as np

from deltacal_gen.errors import InputError, MisreadReadings, NoSolutionError
from deltacal_gen.estimation.fit import fit, rough
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import unsaid
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.residuals import lengths
from deltacal_gen.estimation.solvers import LeastSquares
from deltacal_gen.identification.rotations import FAR_TURNED, POSES_LOOKED_AT, TURNED, apart, turned
from deltacal_gen.machine.places import misread, read_together
from deltacal_gen.machine.registry import Array
from deltacal_gen.machine.rotation import from_turns, from_vector
from deltacal_gen.machine.values import ROTATION
from deltacal_gen.physics.body import Body
from deltacal_gen.units import DEG

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


def typical(at: Fit) -> float:
    """Return the median length of residuals [mm]."""
    return float(np.median(sizes(at)))


def sizes(at: Fit) -> Array:
    """Return the lengths (R,) of residuals [mm]."""
    size: Array = np.linalg.norm(np.nan_to_num(lengths(at.residual, at.problem.readings.kind)), axis=1)
    return size


def tried(problem: Problem, off: float) -> list[tuple[float, str]]:
    """Return mistakes, one at a time, with which readings are nearer to the machine, the nearest first.

    Each is looked at with the machine as its file says, on few poses; the few that bring most are fitted. All together
    cost less than a fit. What each leaves of `off` comes with it, by what the readings spread over: in a larger unit
    all is smaller, errors too.
    """
    few = problem.some(POSES_LOOKED_AT, np.random.default_rng(SEED))
    mistakes: Iterable[tuple[str, Problem]] = ()
    if few.readings.kind.positions:
        mistakes = itertools.chain(_mistakes(few), _shifted(problem), _of_links(few))
    elif few.readings.kind.anew:
        mistakes = itertools.chain(_of_joints(few), _of_contacts(few), _of_links(few))
    elif few.readings.kind.in_differences(few.recording.measurement):
        mistakes = _units(few, "lengths")  # what counts from the first is not told by how long it is
    looked_at = [(_aligned_error(changed), words, changed) for words, changed in mistakes]
    most = NEARER * _aligned_error(few)
    near = sorted((t for t in looked_at if t[0] < most), key=lambda t: t[0])[:MOST_FITTED]
    out = []
    for _, words, changed in near:
        try:
            again = rough(changed, must_converge=False)
        except (InputError, NoSolutionError):
            continue
        smaller = min(1.0, _spread(changed) / _spread(few))
        out.append((typical(again) / (off * smaller), words))
    return sorted(out, key=lambda t: t[0])


def in_other_units(at: Fit) -> Iterator[tuple[str, Fit]]:
    """Yield units of lengths that count from the first, with which a fit leaves less of what they spread over."""
    problem = at.problem
    if not problem.readings.kind.in_differences(problem.recording.measurement):
        return
    for words, changed in _units(problem, "lengths"):
        try:
            again = rough(changed, must_converge=False)
        except (InputError, NoSolutionError):
            continue
        if typical(again) * _spread(problem) < typical(at) * _spread(changed):
            yield words, again


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
            residual = lengths(free.residual(errors, begun, free.seen(machine)), free.readings.kind)
            off = float(np.median(np.linalg.norm(np.nan_to_num(residual), axis=1)))
    except (InputError, NoSolutionError):
        return float("inf")
    return off / _spread(problem)


def _spread(problem: Problem) -> float:
    """Return what readings spread over, in their own unit; one of those that are all the same, as of a surface."""
    found = problem.readings
    most = min(3, found.values.shape[1])
    return float(np.linalg.norm(np.nanstd(found.values[:, [c for c in found.components if c < most]], axis=0))) or 1.0


def _mistakes(problem: Problem) -> Iterator[tuple[str, Problem]]:
    found, said = problem.readings, problem.recording.measurement

    def with_values(values: Array) -> Problem:
        return dataclasses.replace(problem, readings=dataclasses.replace(found, values=values))

    if said.frame == "robot":
        recording = dataclasses.replace(problem.recording, measurement=dataclasses.replace(said, frame="unknown"))
        yield (
            'the instrument has a frame of its own (frame = "unknown" in the sidecar)',
            dataclasses.replace(problem, recording=recording),
        )
    yield from _of_joints(problem)
    axes = "xyz"
    read = [c for c in found.components if c < 3]
    for i, j in itertools.combinations(read, 2):
        swapped = [j if k == i else i if k == j else k for k in range(3)]
        yield f"{axes[i]}_mm and {axes[j]}_mm are exchanged", with_values(found.values[:, swapped])
    if found.rotations is not None and np.isfinite(found.rotations).all() and len(read) == 3:
        back = np.swapaxes(found.rotations, 1, 2)
        inverse = dataclasses.replace(found, values=-(back @ found.values[:, :, None])[:, :, 0], rotations=back)
        yield (
            "each pose is the inverse: where a board, or the instrument, is as the platform, or a camera on it, has it",
            dataclasses.replace(problem, readings=inverse),
        )
    if len(read) > 1:
        mirrored = np.where(np.arange(3) == read[0], -found.values, found.values)
        yield "the instrument's frame is left-handed (one axis counts the other way)", with_values(mirrored)
    yield from _units(problem, "positions")
    for (factor, unit), i in itertools.product(UNITS, read):
        scale = np.where(np.arange(3) == i, factor, 1.0)
        yield f"{axes[i]}_mm is in {unit}", with_values(found.values * scale)


def _of_joints(problem: Problem) -> Iterator[tuple[str, Problem]]:
    """Return other meanings of the columns of joints."""
    body = problem.body

    def with_joints(q: Array) -> Problem:
        return dataclasses.replace(problem, body=Body(body.robot, body.mechanism, q, body.tool, body.channels))

    joints = range(body.q.shape[1])
    yield "every joint counts the other way ([joints] sign)", with_joints(-body.q)
    for i in joints:
        yield (
            f"joint {i + 1} counts the other way ([joints] sign)",
            with_joints(np.where(np.arange(len(joints)) == i, -body.q, body.q)),
        )
        for turn in (90, -90, 180) if problem.mechanism.joint_units[i] == "rad" else ():
            step = np.where(np.arange(len(joints)) == i, turn * DEG, 0.0)
            yield f"the zero of joint {i + 1} is off by {turn} deg", with_joints(body.q + step)
    for (i, table), sign in itertools.product(read_together(problem.robot), (1, -1)):
        words = f"joint {i + 2} counts from a line that stays as joint {i + 1} turns"
        added = np.where(np.arange(len(joints)) == i + 1, sign * body.q[:, [i]], 0.0)
        yield f"{words} (page arm: coupling = {{{table} = {sign:.1f}}})", with_joints(body.q + added)
    turning = np.array(problem.mechanism.joint_units) == "rad"
    if turning.any():
        yield "the joints are in radians", with_joints(body.q / np.where(turning, DEG, 1.0))
        for turn in (90, -90):
            yield f"the zeros of all joints are off by {turn} deg", with_joints(body.q + turn * DEG * turning)
    for i, j in itertools.combinations(joints, 2):
        order = [j if k == i else i if k == j else k for k in joints]
        yield f"the columns of joints {i + 1} and {j + 1} are exchanged", with_joints(body.q[:, order])


def _of_links(problem: Problem) -> Iterator[tuple[str, Problem]]:
    """Return other meanings of the table of a chain's links."""
    for words, robot in misread(problem.robot):
        yield words, pose_problem(robot, problem.recording, problem.names, found=problem.readings)


def _of_contacts(problem: Problem) -> Iterator[tuple[str, Problem]]:
    """Return distances between contacts in larger units than mm; with next to none any points would agree."""
    recording = problem.recording
    for factor, unit in ((f, u) for f, u in UNITS if f > 1 and recording.contact_distances):
        ties = tuple((a, b, factor * mm) for a, b, mm in recording.contact_distances)
        changed = dataclasses.replace(recording, contact_distances=ties)
        yield f"the distances between contacts are in {unit}", dataclasses.replace(problem, recording=changed)


def turns_alike(first: Fit) -> None:
    """Raise an InputError where measured rotations agree with the machine by another meaning of them, or of joints.

    Of a wrist, rotations alone may tell how its joints count: the point that is measured lies near its axes. Joints
    are asked where most poses tell, and where no other meaning of the rotations does. The machine is the robot file's:
    one that was fitted to such rotations has bent to them.
    """
    found = first.problem.readings
    if not turned(first) or found.rotations is None or not {3, 4, 5} <= {*found.components}:
        return
    few = first.problem.some(POSES_LOOKED_AT, np.random.default_rng(SEED))
    off = _turned_off(few)
    for meanings in (_of_angles(few), _of_turns(few) if off > FAR_TURNED else ()):
        tried = sorted((_turned_off(changed), *words) for words, changed in meanings)
        if not tried or tried[0][0] >= TURNED * off:
            continue
        least, what, _, remedy = tried[0]
        near = dict.fromkeys(words for left, its, words, _ in tried if left <= AS_NEAR * least and its == what)
        told = ", or ".join(near)
        raise MisreadReadings(
            f"rx_deg, ry_deg, rz_deg are {what}: from pose to pose they turn otherwise than the machine, by "
            f"{off / DEG:.2g} deg. {told[0].upper()}{told[1:]}, it is {least / DEG:.2g} deg.",
            remedy,
            file=first.problem.recording.path,
        )


def _turned_off(problem: Problem) -> float:
    """Return by how much rotations turn more or less than the robot file's machine [rad]; inf where it cannot stand."""
    found = problem.readings
    try:
        drawn = problem.solve(problem.reference).x[found.rows[:, 0], 3:].reshape(-1, 3, 3)
    except (InputError, NoSolutionError):
        return float("inf")
    assert found.rotations is not None
    return apart(found.rotations, drawn, problem)


def _of_angles(problem: Problem) -> Iterator[tuple[tuple[str, str, str], Problem]]:
    """Return other meanings of measured rotations: what they are not, what they are, and what to do."""
    found, recording = problem.readings, problem.recording
    assert found.rotations is not None
    read = np.isfinite(found.rotations[:, 0, 0])
    angles = recording.measured[found.rows[:, 0]][:, [recording.columns.index(name) for name in ROTATION]]

    def meant(rotations: Callable[[Array], Array]) -> Problem:
        own = np.full((len(read), 3, 3), np.nan)
        own[read] = rotations(angles[read])
        return dataclasses.replace(problem, readings=dataclasses.replace(found, rotations=own))

    for order in map("".join, itertools.permutations("xyz")):
        yield (
            (
                "no rotation vectors",
                "as angles of turns about the instrument's axes, one after the other",
                f'Say so under [measurement] in the sidecar: rotation = "{order}".',
            ),
            meant(functools.partial(from_turns, order)),
        )
    yield (
        ("no rotation vectors in deg", "in rad", "Convert them, or call their columns rx_rad, ry_rad, rz_rad."),
        meant(lambda vectors: from_vector(vectors / DEG)),
    )
    yield (
        (
            "not the rotations of the platform",
            "as their inverses, of the instrument seen from the platform",
            "Give the inverse of each: the negative of the vector.",
        ),
        meant(lambda vectors: from_vector(-vectors)),
    )


def _of_turns(problem: Problem) -> Iterator[tuple[tuple[str, str, str], Problem]]:
    """Return other meanings of joints, in the words of `_of_angles`."""
    for words, changed in _of_joints(problem):
        yield (
            ("not those of these joints", f"if {words}", "Correct the recording or the robot file."),
            changed,
        )


def _units(problem: Problem, what: str) -> Iterator[tuple[str, Problem]]:
    """Return readings in other units than mm."""
    for factor, unit in UNITS:
        readings = dataclasses.replace(problem.readings, values=problem.readings.values * factor)
        yield f"all {what} are in {unit}", dataclasses.replace(problem, readings=readings)


def _shifted(problem: Problem) -> Iterator[tuple[str, Problem]]:
    """Return readings against the joints of the row before and behind, few of all of them: poses have neighbours."""
    for shift in (1, -1):
        values = np.roll(problem.readings.values, shift, axis=0)
        rolled = dataclasses.replace(problem, readings=dataclasses.replace(problem.readings, values=values))
        yield (
            "the readings are shifted against the joints by one row",
            rolled.some(POSES_LOOKED_AT, np.random.default_rng(SEED)),
        )
