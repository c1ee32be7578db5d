"""Whether fits arrive: ``python -m tests.benchmarks.arrival [--problems N] [--seed S] [--starts K]``.

Random problems of all machines: short and wide ranges, few and many poses, small and large errors, frames known and
unknown, points near a line, soft arms (a bent machine that geometry alone is fitted to). Each fit is compared with the
lowest that SciPy's trust region reaches from several starts, of the same rows weighed alike: what the fit leaves must
not be more than 0.1 of chi2 above it. Distributions were written down before the first run and are not narrowed.
"""

from __future__ import annotations

import argparse
import dataclasses
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from deltacal_gen.errors import DeltacalError
from deltacal_gen.estimation.fit import BROAD, Fit, fit
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.files.robot import Robot, read_robot, robot_from_dict
from deltacal_gen.machine.registry import SOLVED, Array, mechanism_of
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.planning.targets import grid
from deltacal_gen.units import DEG

EXAMPLES = Path(__file__).resolve().parents[2] / "src" / "deltacal_gen" / "examples"
MACHINES = ("delta", "linear_delta", "diamond", "planar_parallelogram")
ABOVE = 0.1  # of chi2: what a fit may leave above the lowest that was found
RANGES = (5.0, 15.0, 40.0, 120.0)  # deg: how far joints of a chain move
SIGMAS = (0.002, 0.02, 0.2)  # mm
SIZES = (0.3, 1.0, 3.0, 10.0)  # of the errors, in ordinary ones


def chain(rng: np.random.Generator) -> Robot:
    """Return an arm of 3 to 8 joints, its links drawn at random [mm, deg]."""
    joints = []
    for _ in range(int(rng.integers(3, 9))):
        joints.append(
            {
                "kind": "revolute" if rng.random() < 0.9 else "prismatic",
                "convention": "standard" if rng.random() < 0.7 else "modified",
                "a": float(np.round(rng.choice([0.0, 1.0]) * rng.uniform(-600, 600), 1)),
                "alpha": float(rng.choice([-90.0, 0.0, 90.0])),
                "d": float(np.round(rng.choice([0.0, 1.0]) * rng.uniform(-500, 500), 1)),
                "theta": float(rng.choice([-90.0, 0.0, 90.0, 180.0])),
            }
        )
    tool = np.round(rng.uniform(-120, 120, 3), 1).tolist()
    return robot_from_dict(
        {"robot": {"name": "drawn", "mechanism": "serial"}, "joint": joints, "geometry": {"tool": tool}}
    )


def poses(robot: Robot, rng: np.random.Generator, n: int) -> Array:
    """Return joints (n, n_q) of a machine as the controller counts [rad, mm]."""
    mechanism = mechanism_of(robot)
    turning = np.array([unit == "rad" for unit in mechanism.joint_units])
    if mechanism.name == "serial":
        middle = np.where(turning, rng.uniform(-90, 90, len(turning)) * DEG, rng.uniform(-200, 200, len(turning)))
        wide = rng.choice(RANGES) / 2
        half = np.where(turning, wide * DEG, 5 * wide)
        q = middle + half * rng.uniform(-1, 1, (n, len(turning)))
        return near_a_line(robot, q, rng) if rng.random() < 0.2 else q
    assert robot.workspace is not None  # the examples have one
    places = grid(robot.workspace, layers=4, radii=3)
    ends, part = rng.choice(len(places), (2, n)), rng.random((n, 1))
    points = part * places[ends[0]] + (1 - part) * places[ends[1]]
    q, _, status = mechanism.inverse(points, robot.tool, mechanism.rows(robot))
    return robot.joint_sign * q[status == SOLVED]


def near_a_line(robot: Robot, q: Array, rng: np.random.Generator) -> Array:
    """Return joints that bring the tool nearer to a line, as trajectories do."""
    mechanism, rows = mechanism_of(robot), mechanism_of(robot).rows(robot)
    tool = np.broadcast_to(robot.tool, (len(q), 3))
    along = rng.standard_normal(3)
    along /= np.linalg.norm(along)
    for _ in range(20):
        x, _ = mechanism.forward(q, tool, rows)
        off = x[:, :3] - x[:, :3].mean(axis=0)
        off -= np.outer(off @ along, along)
        J = mechanism.sensitivity(x, q, tool, rows).joints[:, :3]
        step = np.linalg.pinv(J, rcond=1e-2) @ off[:, :, None]
        q = q - np.clip(0.5 * step[:, :, 0], -0.1, 0.1)
    return q


def problems(seed: int) -> Iterator[tuple[str, Problem]]:
    """Yield random problems, each with a word on what it is."""
    rng = np.random.default_rng(seed)
    while True:
        name = "serial" if rng.random() < 0.6 else str(rng.choice(MACHINES))
        robot = chain(rng) if name == "serial" else read_robot(EXAMPLES / name / "robot.toml")
        mechanism = mechanism_of(robot)
        names = mechanism.model(mechanism.full_model)
        n = int(np.ceil(len(names) * rng.choice([0.7, 1.5, 4.0]))) + 4
        frame = str(rng.choice(["robot", "unknown"]))
        size, sigma = float(rng.choice(SIZES)), float(rng.choice(SIGMAS))
        axes = mechanism.axes
        try:
            q = poses(robot, rng, n)
            n = len(q)
            plain = Recording(
                path=Path("drawn"),
                kind="position",
                measurement=Measurement(kind="position", frame=frame),
                joint_unit=mechanism.joint_unit,
                joints=q,
                columns=tuple(f"{axis}_mm" for axis in axes),
                measured=np.full((n, len(axes)), np.nan),
                pose=np.arange(1, n + 1).astype(str),
                line=np.arange(2, n + 2),
                channels={},
                setup=np.zeros(n, dtype=int),
                setup_names=("",),
            )
            errors = {p: float(size * mechanism.typical[mechanism.index[p]] * rng.standard_normal()) for p in names}
            made = simulate(robot, plain, errors, noise_mm=sigma, rng=rng)
            if name == "serial" and rng.random() < 0.3:  # a soft arm: it hangs, by what its reach is
                sag = rng.uniform(0, 0.01) * np.linalg.norm(made.measured[:, :2], axis=1)
                measured = made.measured.copy()
                measured[:, 2] -= sag
                made = dataclasses.replace(made, measured=measured)
            problem = pose_problem(robot, made, names)
        except DeltacalError:
            continue  # a machine that cannot stand at such poses is no problem of a fit
        scale = BROAD * problem.scale
        word = f"{name}, {n} poses, frame {frame}, errors {size:g} ordinary, sigma {sigma:g}"
        yield word, dataclasses.replace(problem, scale=scale)


def chi2(problem: Problem, found: Fit, errors: Array, instrument: object) -> float:
    """Return the objective at a state, rows weighed by a fit's noise; inf where no machine stands."""
    try:
        machine = problem.solve(errors)
    except DeltacalError:
        return float("inf")
    r = problem.residual(errors, instrument, machine.x) / found.sigma  # type: ignore[arg-type]  # of a fit
    u = (errors[problem.columns] - problem.reference[problem.columns]) / problem.scale
    return float(np.nansum(r**2) + u @ u)


def lowest(problem: Problem, found: Fit, starts: int, rng: np.random.Generator) -> float:
    """Return the lowest objective that another optimiser finds, from the fit's end and from starts at random."""
    from scipy.optimize import least_squares

    columns, scale, n = problem.columns, problem.scale, len(problem.scale)
    best = np.inf
    for k in range(starts):
        errors = problem.reference.copy()
        errors[columns] += 0.0 if k == 1 else scale * rng.standard_normal(n) * rng.choice([0.01, 0.1])
        try:
            base = found.instrument if k == 0 else problem.begin(errors)
        except DeltacalError:
            continue
        if k == 0:
            errors = found.errors.copy()
        first = np.concatenate([(errors[columns] - problem.reference[columns]) / scale, np.zeros(base.n_unknown)])

        def at(z: Array, base: object = base) -> tuple[Array, object]:
            errors = problem.reference.copy()
            errors[columns] += scale * z[:n]
            return errors, base.stepped(z[n:])  # type: ignore[attr-defined]  # an instrument

        def rows(z: Array, at: object = at) -> Array:
            errors, instrument = at(z)  # type: ignore[operator]  # the function above
            try:
                machine = problem.solve(errors)
            except DeltacalError:
                return np.full(problem.readings.n_scalars + n, 1e3)
            r = problem.residual(errors, instrument, machine.x) / found.sigma
            return np.concatenate([r[np.isfinite(r)], z[:n]])

        try:
            ended = least_squares(rows, first, x_scale="jac", method="trf", max_nfev=60)
        except (DeltacalError, ValueError):
            continue
        best = min(best, 2 * float(ended.cost))
    return best


def main() -> int:
    """Fit problems and compare; return 1 where too many fits do not arrive."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--problems", type=int, default=2000)
    parser.add_argument("--seed", type=int, default=20261122)
    parser.add_argument("--starts", type=int, default=20)
    given = parser.parse_args()
    rng, missed, spent = np.random.default_rng(given.seed + 1), [], 0.0
    drawn = problems(given.seed)
    for k in range(given.problems):
        word, problem = next(drawn)
        began = time.process_time()
        try:
            found = fit(problem, Prior(), robust=False, weigh_repeats=False)
        except DeltacalError as error:
            missed.append(f"{k}: {word}: {error}")
            continue
        spent += time.process_time() - began
        own = chi2(problem, found, found.errors, found.instrument)
        other = lowest(problem, found, given.starts, rng)
        if own > other + ABOVE:
            missed.append(f"{k}: {word}: {own:.3f}, another optimiser {other:.3f}")
        print(f"\r{k + 1} of {given.problems}, {len(missed)} not arrived", end="", file=sys.stderr, flush=True)
    print(file=sys.stderr)
    print("\n".join(missed))
    print(f"{len(missed)} of {given.problems} did not arrive; {1e3 * spent / given.problems:.0f} ms a fit")
    return int(len(missed) > given.problems // 1000)


if __name__ == "__main__":
    sys.exit(main())
