"""Remedies: extra measurements, and how many of the directions that readings leave open each would pin."""

from __future__ import annotations

import dataclasses

import numpy as np

from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.prior import with_prior
from deltacal_gen.estimation.problem import Problem
from deltacal_gen.identification.identifiability import Seen
from deltacal_gen.inference.projection import basis, project_out
from deltacal_gen.instrument.kinds import PAIRS, POINTS, kind_of
from deltacal_gen.machine.registry import SOLVED, Array, mechanism_of
from deltacal_gen.machine.rotation import about_z
from deltacal_gen.machine.values import Robot, numbered
from deltacal_gen.results.result import (
    Remedy,
)
from deltacal_gen.units import DEG, file_unit, to_internal

TURNED = 3  # points at a pose that tell how the platform is turned
HANDS = 100.0  # mm: how far beside the first a further reference point of a chain is


def remedies(final: Fit, seen: Seen) -> tuple[Remedy, ...]:
    """Return extra measurements, each with how many more of the directions that readings leave open it would pin."""
    kind = final.problem.readings.kind
    if kind.sees_joints:
        return ()
    if kind.distances_beside:
        return _printed(final) if 3 in final.problem.mechanism.widths else ()  # what turns its tool prints nothing
    return _measured(final, seen.absorbed) if seen.unseen or seen.weak else ()


def _measured(final: Fit, absorbed: int) -> tuple[Remedy, ...]:
    """Return extra measurements of the platform, those that pin most first.

    So many directions are `absorbed` by what is unknown of the instrument's place, which it settles where known.
    """
    problem = final.problem
    kind, span, read = problem.readings.kind, _span(problem.robot), _points_at_a_pose(problem)

    def beside(of: Problem, *offsets: tuple[int, int, int]) -> list[Problem]:
        return [of.with_tool(of.body.tool + np.array(offset) * span) for offset in offsets]

    ideas: list[tuple[str, list[Problem]]] = []
    if not kind.picked and not kind.carried(problem.mechanism):  # a measuring mechanism mounted anew has new errors
        where, points = f"{span:.0f} mm beside the first, at the same poses", beside(problem, (1, 0, 0), (0, 1, 0))
        if read == 1:
            ideas.append((f"a second reference point, {where}", points[:1]))
            ideas.append((f"a second and a third reference point, {where}", points))
        elif read == 2:
            ideas.append((f"a third reference point, {where}", points[:1]))
    if kind.position_beside:
        ideas.append(("the position itself at the same poses, with a tracker or a camera", [_as_positions(problem)]))
    if kind.rotation_beside and problem.mechanism.turns and read < TURNED:
        three = beside(_as_positions(problem), (0, 0, 0), (1, 0, 0), (0, 1, 0))
        ideas.append(("the platform's rotation (kind pose) at the same poses", three))
    known = _pinned([problem], final)
    gains: dict[str, int] = {}
    for text, extra in ideas:
        gain = _pinned([problem, *extra], final) - known
        # what pins no more than less of the same is no idea
        if gain > max((gains.get(t, 0) for t, less in ideas if less == extra[:-1]), default=0):
            gains[text] = gain
    if absorbed:
        gains[f"{kind.whereabouts}, known in the robot's frame to {final.sigma[0]:.2g} mm,"] = absorbed
    of = len(problem.names) - known
    return tuple(Remedy(measurement=text, pins=gains[text], of=of) for text in sorted(gains, key=lambda t: -gains[t]))


def _points_at_a_pose(problem: Problem) -> int:
    """Return how many points of the machine were read at a pose, in the median."""
    rows = np.unique(problem.readings.rows)
    stand = numbered(np.round(problem.body.q[rows], 9))
    each = numbered(np.round(np.column_stack([stand, problem.body.tool[rows]]), 9))
    return int(np.median(np.bincount(stand[np.unique(each, return_index=True)[1]])))


def _span(robot: Robot) -> float:
    """Return how far from the first further reference points are [mm]: half a platform, or what a flange carries."""
    if not mechanism_of(robot).looped:
        return HANDS
    return float(np.mean([v[0] for v in robot.geometry.values()][:2])) / 2


def _printed(final: Fit) -> tuple[Remedy, ...]:
    """Return the one or two distances to print and measure that settle what probed heights leave open.

    Heights make a bed flat; the size of what is printed over it hangs on arms, radius and towers that they hardly see.
    All source errors count here, free or not, each with its prior: `[tolerance]`, or a broad one. What a distance may
    be off by is told with the change of the machine that goes along with it.
    """
    robot, mechanism = final.problem.robot, final.problem.mechanism
    names, noise = mechanism.model(mechanism.full_model), kind_of(PAIRS).usual_noise
    every, _ = with_prior(final.problem.with_names(names), robot)
    state = every.linearise(final.errors, final.instrument)
    A = np.nan_to_num(state.J_p * every.scale / final.sigma[None, :, None]).reshape(-1, len(names))
    C = np.linalg.inv(A.T @ A + np.eye(len(names))) * np.outer(every.scale, every.scale)
    reach = every.body.solve(final.errors, ())[0].x[np.unique(every.readings.rows)]
    wide = float(np.max(np.linalg.norm(reach[:, :2], axis=1)))
    turns = np.arange(0.0, 180.0, 30.0) * DEG
    ends = np.column_stack([about_z(wide, turns), 0 * turns])
    points = np.concatenate([-ends, ends])
    points[:, 2] = np.median(reach[:, 2])
    rows = mechanism.rows(robot, final.errors)
    q, x, status = mechanism.inverse(points, robot.tool, rows)
    if (status != SOLVED).any():
        return ()
    dx = mechanism.sensitivity(x, q, robot.tool, rows).parameters[:, :3, every.columns]
    n = len(turns)
    J = np.einsum("ni,nij->nj", ends / wide, dx[n:] - dx[:n])
    chosen: list[Remedy] = []
    while len(chosen) < 2:
        std = np.sqrt(np.einsum("ni,ij,nj->n", J, C, J))
        k = int(np.argmax(std))
        if std[k] < 2 * noise:
            break
        along = C @ J[k] / std[k]
        size = np.abs(along) / mechanism.typical[every.columns]
        told = [
            f"{names[j]} {along[j] / to_internal(unit):+.2g} {file_unit(unit)}".removesuffix(" 1")
            for j in np.argsort(-size)[:4]
            for unit in [mechanism.parameters[every.columns[j]].unit]
        ]
        text = (
            f"print two marks {2 * wide:.0f} mm apart through the centre, {turns[k] / DEG:.0f} deg from x, and measure "
            f"their distance: these readings leave it open by {std[k]:.2g} mm, with a bed as flat ({', '.join(told)})"
        )
        chosen.append(Remedy(measurement=text, pins=1, of=len(names), open_mm=float(std[k])))
        gain = C @ J[k]
        C = C - np.outer(gain, gain) / (std[k] ** 2 + noise**2)
    return tuple(chosen)


def _as_positions(problem: Problem) -> Problem:
    readings = kind_of(POINTS).taken(np.unique(problem.readings.rows)[:, None])
    recording = dataclasses.replace(problem.recording, setup=np.zeros(problem.recording.n_rows, dtype=int))
    return dataclasses.replace(problem, readings=readings, recording=recording)


def _pinned(problems: list[Problem], final: Fit) -> int:
    """Return how many directions readings of all `problems` together would know better than the prior."""
    blocks: dict[str, list[tuple[Array, Array]]] = {}
    for p in problems:
        machine = p.solve(final.errors)
        same = p.readings.kind == final.instrument.kind
        instrument = final.instrument if same else p.begin(final.errors)
        predicted, rotations = instrument.mounted(p.mechanism, final.errors).predict(p.readings, p.seen(machine))
        ideal = dataclasses.replace(p.readings, values=predicted, rotations=rotations)
        state = dataclasses.replace(p, readings=ideal).linearise(final.errors, instrument, machine)
        sigma = np.resize(final.sigma, state.residual.shape[1])[None, :, None]
        J_p, J_m = state.J_p * p.scale / sigma, state.J_m / sigma
        count = J_p.shape[0] * J_p.shape[1]
        blocks.setdefault(p.readings.kind.name, []).append((J_p.reshape(count, -1), J_m.reshape(count, J_m.shape[2])))
    A = []
    for parts in blocks.values():  # readings of one kind share the instrument
        J_p, J_m = np.vstack([a for a, _ in parts]), np.vstack([b for _, b in parts])
        A.append(project_out(J_p, basis(J_m)))
    return int((np.linalg.svd(np.vstack(A), compute_uv=False) > 1).sum())
