"""The works, each done by the package and by hand; every contender of a work computes the same numbers."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator
from functools import partial

import numpy as np
from deltacal_kernels import rotations
from numba import njit

import deltacal_gen as dc
from deltacal_gen import PoseSet
from deltacal_gen.app.demonstration import example
from deltacal_gen.estimation.arrays import LinearFit
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.solvers import LeastSquares
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import read_robot
from deltacal_gen.identification.accuracy import check_poses, distance_error
from deltacal_gen.identification.identification import identify
from deltacal_gen.machine.backend import JOINTS, Backend, using, working
from deltacal_gen.machine.registry import load_mechanism, mechanism_names, mechanism_of
from deltacal_gen.machine.rotation import cayley_matrix, cayley_vector
from deltacal_gen.use.compensation import Compensator
from tests.benchmarks import by_hand, by_hand_chain, by_hand_numba
from tests.benchmarks.contenders import (
    DELTA,
    KERNEL,
    NUMBA,
    NUMPY,
    OURS,
    PAPER,
    POINT,
    POSES,
    ROBOT,
    SIGMA,
    UNIT,
    Array,
    Contender,
    Work,
    by_tools,
    calibrated,
    columns,
    errors,
    measured,
    paper,
    positions,
    reach,
    recorded,
    rings,
)
from tests.benchmarks.starts import start
from tests.support.drawn import example_of

# ------------------------------------------------------------------------------------------------------- kinematics


def as_pose(x: Array) -> Array:
    """Return poses (N, 12), position and rotation matrix, by positions and Cayley vectors (N, 6)."""
    return np.hstack([x[:, :3], cayley_matrix(x[:, 3:]).reshape(-1, 9)])


def as_coordinates(x: Array) -> Array:
    """Return positions and Cayley vectors (N, 6) by poses (N, 12)."""
    return np.hstack([x[:, :3], cayley_vector(x[:, 3:].reshape(-1, 3, 3))])


def sensitivity(n: int, *, exact: bool) -> Work:
    """Derivatives by all 42 errors: of the ideal machine's position, or of the exact pose of a machine with errors.

    The package's one kernel does both; it gives the rotation and the derivatives by joints and deflections as well.
    """
    r, p = positions(n), errors() if exact else np.zeros(42)
    theta = np.ascontiguousarray(by_hand.ideal_inverse(r))
    rods, slopes = by_hand.machine(paper(p)), by_hand.machine_derivatives(paper(p))
    x, rows, tool = np.ascontiguousarray(by_hand.forward(theta, rods)), DELTA.rows(ROBOT, p), np.zeros((n, 3))
    axes, kernels = 6 if exact else 3, DELTA.compiled
    k = kernels.constants(rows) if exact else kernels.nominal_constants(rows)
    S, point = np.empty((n, 3, 42)), np.zeros((1, 3))
    S_p, S_q, status = np.empty((n, 6, 48)), np.empty((n, 6, 3)), np.empty(n, dtype=np.int64)

    def in_paper(S: Array) -> Array:
        out = np.empty((n, axes, 42))
        out[:, :, PAPER] = S.reshape(n, 6, 42)[:, :axes] / UNIT
        return out

    def by_cayley(S: Array) -> Array:
        """Turns as changes of the Cayley vector, in which the others count."""
        return np.hstack([S[:, :3], np.linalg.solve(rotations.spin(x[:, 3:]), S[:, 3:])])

    poses = as_pose(x)
    contenders = {
        OURS: Contender(
            lambda: DELTA.sensitivity(poses, theta, tool, rows), lambda found: in_paper(by_cayley(found.parameters))
        ),
    }
    if exact:
        contenders[KERNEL] = Contender(
            lambda: kernels.sensitivity(x, theta, point, k, S_p, S_q, status),
            lambda _: in_paper(by_cayley(S_p.reshape(n, 6, 3, 16)[..., :14].reshape(n, 6, 42))),
        )
    else:
        contenders[KERNEL] = Contender(
            lambda: kernels.nominal_sensitivity(r, theta, point, k, S),
            lambda _: np.stack([S[:, :, j] / UNIT[j] for j in np.argsort(PAPER)], axis=2),
        )
    if exact:
        one = lambda: by_hand.exact_sensitivity(theta, x, rods, slopes)  # noqa: E731
        contenders[NUMPY] = Contender(one, lambda S: in_paper(S * UNIT.reshape(3, 14)))
    else:
        by_numpy, by_numba = np.empty((n, 3, 42)), np.empty((n, 3, 42))
        contenders[NUMPY] = Contender(lambda: by_hand.sensitivity(theta, r, by_numpy))
        contenders[NUMBA] = Contender(lambda: by_hand_numba.sensitivity(theta, r, by_numba), lambda _: by_numba)
        contenders |= by_tools("sensitivity", theta, r)
    what = "exact sensitivity of the pose" if exact else "sensitivity of the ideal machine's position"
    return Work(f"{what}, {n} poses", "ns/pose", n, contenders)


def matrix(n: int) -> Work:
    """H of model 32 from the distances of all pairs of n poses."""
    r = rings(n)
    theta = np.ascontiguousarray(by_hand.ideal_inverse(r))
    recording = recorded(theta, [(POINT, r + POINT)])
    whole = partial(dc.matrix, ROBOT, recording, model="32", as_distance=True, scaling="paper")
    chosen, at, H = [DELTA.index[name] for name in DELTA.model("32")], r + POINT, np.empty((n * (n - 1) // 2, 32))
    k, kept, wanted = DELTA.compiled.nominal_constants(DELTA.rows(ROBOT)), np.array(chosen), np.array(columns("32"))
    C, part, out, tool = np.empty((n, 3, 42)), np.empty((n, 3, len(chosen))), np.empty_like(H), POINT[None]
    return Work(
        f"identification matrix, {n} poses, {n * (n - 1) // 2} x 32",
        "us",
        1,
        {
            OURS: Contender(whole, lambda found: found["H"]),
            KERNEL: Contender(
                lambda: DELTA.compiled.distance_rows(at, theta, tool, k, kept, H), lambda _: H / UNIT[chosen]
            ),
            NUMPY: Contender(lambda: by_hand.identification_matrix(theta, r, POINT, columns("32"))),
            NUMBA: Contender(
                lambda: by_hand_numba.identification_matrix(theta, r, POINT, wanted, C, part, out), lambda _: out
            ),
        }
        | by_tools("identification_matrix", theta, r, POINT, columns("32")),
    )


def ideal(n: int, *, forward: bool) -> Work:
    """Positions or joints of the ideal machine; the package solves all six rods, by hand it is a closed form."""
    r = positions(n)
    theta, p, out = np.ascontiguousarray(by_hand.ideal_inverse(r)), DELTA.rows(ROBOT), np.empty((n, 3))
    kernels, point, x, q = DELTA.compiled, np.zeros((1, 3)), np.empty((n, 3)), np.empty((n, 3))
    status = np.empty(n, dtype=np.int64)
    k = kernels.constants(p)
    kernel = {
        True: Contender(lambda: kernels.simplified_forward(theta, point, k, x, status), lambda _: x),
        False: Contender(lambda: kernels.simplified_inverse(r, point, k, q, status), lambda _: q),
    }
    ours = {
        True: Contender(lambda: DELTA.forward(theta, np.zeros(3), p), lambda found: found[0][:, :3]),
        False: Contender(lambda: DELTA.inverse(r, np.zeros(3), p), lambda found: found[0]),
    }
    name, given = ("ideal_forward", theta) if forward else ("ideal_inverse", r)
    numpy, numba = getattr(by_hand, name), getattr(by_hand_numba, name)
    return Work(
        f"ideal machine, {'positions' if forward else 'joints'}, {n} poses",
        "ns/pose",
        n,
        {
            OURS: ours[forward],
            KERNEL: kernel[forward],
            NUMPY: Contender(lambda: by_hand.in_blocks(numpy, given, np.empty((n, 3)), 4 * by_hand.BLOCK)),
            NUMBA: Contender(lambda: numba(given, out), lambda _: out),
        }
        | by_tools(name, given),
    )


def forward(n: int) -> Work:
    """Exact poses of one machine with errors."""
    theta, p = np.ascontiguousarray(by_hand.ideal_inverse(positions(n))), errors()
    rods, rows = by_hand.machine(paper(p)), DELTA.rows(ROBOT, p)
    k, tool, status = DELTA.compiled.constants(rows), np.zeros((1, 3)), np.empty(n, dtype=np.int64)
    x, out = np.empty((n, 6)), np.empty((n, 6))
    return Work(
        f"exact forward position, {n} poses",
        "ns/pose",
        n,
        {
            OURS: Contender(lambda: DELTA.forward(theta, np.zeros(3), rows), lambda found: as_coordinates(found[0])),
            KERNEL: Contender(lambda: DELTA.compiled.forward(theta, tool, k, x, status, False), lambda _: x),
            NUMPY: Contender(lambda: by_hand.in_blocks(partial(by_hand.forward, rods=rods), theta, np.empty((n, 6)))),
            NUMBA: Contender(lambda: by_hand_numba.forward(theta, rods, out), lambda _: out),
        }
        | by_tools("forward", theta, rods),
    )


def every_mechanism(n: int, *, name: str, derivatives: bool) -> Work:
    """Exact poses of a mechanism's example with errors, or their derivatives, beside the package's own plain NumPy."""
    mechanism = load_mechanism(name)
    drawn = read_robot(example_of(name) / "robot.toml")
    robot = dataclasses.replace(drawn, mechanism=name, errors={}, tolerance={})
    given = read_recording(example_of(name) / "poses.csv", mechanism, need_measured=False, allow_targets=True)
    rng, q = np.random.default_rng(8), given.joints
    if given.targets is not None:
        q, _, _ = mechanism.inverse(given.targets, np.zeros(3), mechanism.rows(robot))
    q = np.resize(q, (n, mechanism.limbs)) + 1e-3 * rng.standard_normal((n, mechanism.limbs))
    p = 0.1 * mechanism.typical * rng.standard_normal(len(mechanism.typical))
    k, n_x = mechanism.vectorised.constants(mechanism.rows(robot, p)), len(mechanism.platform)
    one, every, status = np.zeros((1, 3)), np.zeros((n, 3)), np.empty(n, dtype=np.int64)
    fast, plain, x = mechanism.compiled, mechanism.vectorised, np.empty((n, n_x))
    plain.forward(q, every, k, x, status, False)
    if not derivatives:
        mine, theirs = np.empty_like(x), np.empty_like(x)
        kernel = Contender(lambda: fast.forward(q, one, k, mine, status, False), lambda _: mine)
        numpy = Contender(lambda: plain.forward(q, every, k, theirs, status, False), lambda _: theirs)
    else:
        width = len(mechanism.errors) + len(mechanism.common) + len(mechanism.deflections)
        S, T = (np.empty((n, n_x, mechanism.limbs * width)) for _ in range(2))
        V, W = (np.empty((n, n_x, mechanism.limbs)) for _ in range(2))
        kernel = Contender(lambda: fast.sensitivity(x, q, one, k, S, V, status), lambda _: np.dstack([S, V]))
        numpy = Contender(lambda: plain.sensitivity(x, q, every, k, T, W, status), lambda _: np.dstack([T, W]))
    return Work(
        f"{name}, {'sensitivity' if derivatives else 'exact forward position'}, {n} poses",
        "ns/pose",
        n,
        {KERNEL: kernel, NUMPY: numpy},
        tolerance=1e-6 * (1000.0 if derivatives else 1.0),  # columns in rad are as large as the machine
    )


def chain(n: int, *, derivatives: bool) -> Work:
    """Poses of the example's open chain with errors, or their derivatives, beside the package's own plain NumPy."""
    robot = read_robot(example("serial/robot.toml"))
    mechanism, rng, tool = mechanism_of(robot), np.random.default_rng(8), np.zeros((1, 3))
    q = rng.uniform(-1.0, 1.0, (n, mechanism.limbs))
    rows = mechanism.rows(robot, 0.1 * mechanism.typical * rng.standard_normal(len(mechanism.typical)))
    x, _ = mechanism.forward(q, tool, rows)

    def by(backend: Backend) -> Contender:
        if not derivatives:
            poses = np.empty_like(x)
            return Contender(using(backend)(lambda: mechanism.forward(q, tool, rows, out=poses)), lambda _: poses)
        out = np.empty((n, 6, len(mechanism.parameters))), np.empty((n, 6, mechanism.limbs))
        return Contender(
            using(backend)(lambda: mechanism.sensitivity(x, q, tool, rows, out=out)), lambda _: np.dstack(out)
        )

    return Work(
        f"serial, {mechanism.limbs} joints, {'sensitivity' if derivatives else 'exact forward position'}, {n} poses",
        "ns/pose",
        n,
        {KERNEL: by(Backend.COMPILED), NUMPY: by(Backend.NUMPY)},
        tolerance=1e-6 * (1000.0 if derivatives else 1.0),  # columns in rad are as large as the machine
    )


# ------------------------------------------------------------------------------------------------------ compensation


def servo(n: int) -> Work:
    """Commands of the exact compensator, one set point after the other in a compiled loop."""
    target, q = positions(n), np.empty((n, 3))
    one, rods = Compensator(calibrated(), "exact").servo(), by_hand.machine(paper(errors()))
    command = one.command

    @njit
    def loop(target: Array, state: Array, q: Array) -> None:
        for n in range(len(target)):
            q[n, 0], q[n, 1], q[n, 2] = command(target[n, 0], target[n, 1], target[n, 2], state)

    contenders = {
        KERNEL: Contender(lambda: loop(target, one.state, q), lambda _: q),
        NUMPY: Contender(lambda: by_hand.in_blocks(partial(by_hand.inverse, rods=rods), target, np.empty((n, 3)))),
    }
    return Work(f"compensator, exact, compiled loop of {n}", "ns/set point", n, contenders, tolerance=1e-9)


def linear(n: int) -> Work:
    """What eq. (23) adds to the nominal joints, one set point after the other in a compiled loop."""
    target, p, out = positions(n), paper(errors()), np.empty((n, 3))
    theta, added = by_hand.ideal_inverse(target).copy(), np.empty((n, 3))
    change, state = Compensator(calibrated(), "linear").servo(change=True)

    @njit
    def loop(target: Array, theta: Array, state: Array, added: Array) -> None:
        for n in range(len(target)):
            x, y, z, q1, q2, q3 = target[n, 0], target[n, 1], target[n, 2], theta[n, 0], theta[n, 1], theta[n, 2]
            added[n, 0], added[n, 1], added[n, 2] = change(x, y, z, q1, q2, q3, state)

    contenders = {
        KERNEL: Contender(lambda: loop(target, theta, state, added), lambda _: added),
        NUMPY: Contender(lambda: by_hand.change(theta, target, p)),
        NUMBA: Contender(lambda: by_hand_numba.changes(theta, target, p, out), lambda _: out),
    } | by_tools("change", theta, target, p)
    return Work(f"compensator, eq. (23), compiled loop of {n}", "ns/set point", n, contenders, tolerance=1e-9)


def call(n: int, *, kind: str) -> Work:
    """One set point per Python call: the exact command, or what eq. (23) adds to the nominal joints."""
    target, p = positions(1), paper(errors())
    compensator, rods, theta = Compensator(calibrated(), kind), by_hand.machine(p), by_hand.ideal_inverse(target).copy()
    one, out = compensator.servo(change=kind == "linear"), np.empty((1, 3))
    command = one.direct()
    x, y, z = target[0].tolist()
    if kind == "exact":
        contenders = {
            OURS: Contender(lambda: compensator.command(target), lambda found: found[0]),
            KERNEL: Contender(lambda: command(x, y, z), np.atleast_2d),
            NUMPY: Contender(lambda: by_hand.inverse(target, rods)),
        }
    else:
        q_1, q_2, q_3 = theta[0].tolist()
        contenders = {
            OURS: Contender(lambda: compensator.command(target), lambda found: found[0] - theta),
            KERNEL: Contender(lambda: command(x, y, z, q_1, q_2, q_3), np.atleast_2d),
            NUMPY: Contender(lambda: by_hand.change(theta, target, p)),
            NUMBA: Contender(lambda: by_hand_numba.changes(theta, target, p, out), lambda _: out),
        } | by_tools("change", theta, target, p)
    name = {"linear": "eq. (23)"}.get(kind, kind)
    return Work(f"compensator, {name}, one per Python call", "us/call", 1, contenders, tolerance=1e-9)


# ---------------------------------------------------------------------------------------------------- identification


def identification(n: int, *, model: str) -> Work:
    """Encoder offsets, then a model, from the distances of all pairs; the package also says how far to trust them."""
    theta, points = measured(model, n)
    recording = recorded(theta, points)

    def two_fits() -> Array:
        problem = pose_problem(ROBOT, recording, (), as_distance=True)
        how = {"robust": False, "weigh_repeats": False}
        rough = fit(problem.with_names(DELTA.model("3")), LeastSquares(), **how)
        begin = {"errors": rough.errors, "instrument": rough.instrument}
        final = fit(problem.with_names(DELTA.model(model)), LeastSquares(), **begin, **how)
        return final.errors

    whole = partial(identify, ROBOT, recording, model, as_distance=True, solver="least-squares", robust=False)
    return Work(
        f"identification, offsets and model {model}, {len(points)} x {n} positions",
        "ms",
        1,
        {
            OURS: Contender(whole, lambda found: reach(paper(found.fit.errors))),
            KERNEL: Contender(two_fits, lambda p: reach(paper(p))),
            NUMPY: Contender(lambda: by_hand.identify(theta, points, columns(model)), reach),
        },
        tolerance=SIGMA,  # by hand the matrix is that of the ideal machine: the minimum is a little off
    )


def chain_identification(n: int) -> Work:
    """All errors by Denavit and Hartenberg and the frame of a tracker, from positions of a six-joint arm."""
    robot = read_robot(example("serial/robot.toml"))
    mechanism, rng = mechanism_of(robot), np.random.default_rng(9)
    q = rng.uniform(-1.0, 1.0, (n, mechanism.limbs))
    p = mechanism.typical * rng.standard_normal(len(mechanism.typical))
    p[mechanism.index["beta_1"] :: len(mechanism.errors)][: len(mechanism.links or ())] = 0.0
    names = mechanism.model("dh")
    free = tuple(name for name in names if not name.startswith("beta"))
    tool, k = np.asarray(robot.tool, dtype=float), [mechanism.index[name] for name in free]
    links = np.column_stack([robot.geometry[key] for key in ("a", "alpha", "d", "theta")])
    exact = mechanism.positions(q, tool, mechanism.rows(robot, p))
    read = exact @ cayley_matrix(np.array([[0.3, -0.2, 0.5]]))[0].T + [900.0, -400.0, 200.0]
    read += SIGMA * rng.standard_normal(read.shape)
    recording = dataclasses.replace(recorded(q, [(tool, read)]), tool=None)

    @working("identify", n * mechanism.limbs // JOINTS)  # as every command that fits recordings
    def whole_fit() -> Array:
        problem = pose_problem(robot, recording, ()).with_names(free)
        return fit(problem, LeastSquares(), robust=False, weigh_repeats=False).errors[k]

    check = rng.uniform(-1.0, 1.0, (50, mechanism.limbs))

    def apart(found: Array) -> Array:
        """Return the distances between positions (50,): what no choice of the base's frame changes."""
        at = by_hand_chain.forward(check, links + found[:-3].reshape(-1, 4), tool + found[-3:]).T
        return np.linalg.norm(at - np.roll(at, 1, axis=0), axis=1)

    return Work(
        f"identification of an arm, {len(free)} errors by Denavit and Hartenberg, {n} positions",
        "ms",
        1,
        {
            OURS: Contender(
                partial(identify, robot, recording, solver="least-squares", robust=False),
                lambda found: apart(found.fit.errors[k]),
            ),
            KERNEL: Contender(whole_fit, apart),
            NUMPY: Contender(lambda: by_hand_chain.identify(q, read, links, tool)[0], apart),
        },
        tolerance=SIGMA,  # `ours` frees Hayati's angles too
    )


# ------------------------------------------------------------------------------------------------------ many machines


def identified(poses: PoseSet, linear: LinearFit, check: PoseSet, target: Array, errors: Array, noise: Array) -> Array:
    """Identify machines with errors (T, 42) from positions with noise (T, N, 3); worst errors before and after."""
    found = linear.estimate(poses.positions(errors) + noise)
    before = check.positions(errors)
    after = check.positions(errors, check.commands(linear.whole(found)))
    return np.stack([np.abs(distance_error(x, target)).max(axis=1) for x in (before, after)], axis=1)


def trials(count: int, *, model: str, kept: bool) -> Work:
    """Errors of `count` machines, noise, exact poses; the paper's matrix; eq. (23) and exact poses before and after.

    By hand the matrix is built and solved by SVD for each machine, or its inverse is `kept`; the package keeps it, and
    JAX finds by itself that it is the same for all machines.
    """
    offsets = np.array([np.zeros(3)] if model == "18" else [np.zeros(3), POINT])
    rng = np.random.default_rng(6)
    free = np.isin([p.name for p in DELTA.parameters], DELTA.model(model))
    errors = np.where(free, 0.3 * DELTA.typical * rng.standard_normal((count, len(free))), 0.0)
    noise = SIGMA * rng.standard_normal((count, len(offsets), POSES, 3))
    r = rings(POSES)
    theta = np.ascontiguousarray(by_hand.ideal_inverse(r))
    assert ROBOT.workspace is not None
    target = check_poses(ROBOT.workspace)
    joints = np.ascontiguousarray(by_hand.ideal_inverse(target))
    p = np.empty((count, 42))
    p[:, PAPER] = errors * UNIT
    wanted, (i, j) = np.array(columns(model)), np.triu_indices(POSES, 1)

    def ours() -> Array:
        poses = PoseSet(ROBOT, np.tile(theta, (len(offsets), 1)), tool=np.repeat(offsets, POSES, axis=0))
        linear, check = poses.linear(model, as_distance=True), PoseSet(ROBOT, joints)
        return identified(poses, linear, check, target, errors, noise.reshape(count, -1, 3))

    def matrix() -> Array:
        return np.concatenate([by_hand.identification_matrix(theta, r, at, wanted) for at in offsets])

    def numpy() -> Array:
        out, gain = np.empty((count, 2)), np.linalg.pinv(matrix())
        for t in range(count):
            read = [by_hand.forward(theta, by_hand.machine(p[t], at), at)[:, :3] for at in offsets]
            rest = [
                np.linalg.norm(y[j] - y[i], axis=1) - np.linalg.norm(r[j] - r[i], axis=1)
                for y in np.add(read, noise[t])
            ]
            rest = np.concatenate(rest)
            found = np.zeros(42)
            found[wanted] = gain @ rest if kept else np.linalg.lstsq(matrix(), rest, rcond=None)[0]
            rods = by_hand.machine(p[t])
            for stage, q in enumerate((joints, by_hand.command(target, found))):
                out[t, stage] = np.abs(distance_error(by_hand.forward(q, rods)[:, :3], target)).max()
        return out

    def numba() -> Array:
        out, gain = np.empty((count, 2)), np.linalg.pinv(matrix()) if kept else np.empty((0, 0))
        by_hand_numba.trials(theta, r, offsets, wanted, target, joints, p, noise, gain, out)
        return out

    return Work(
        f"identification, model {model}, of each of {count} machines, {'factor kept' if kept else 'SVD each time'}",
        "us/machine",
        count,
        {KERNEL: Contender(ours), NUMPY: Contender(numpy), NUMBA: Contender(numba)}
        | by_tools("trials", theta, r, offsets, wanted, target, joints, p, noise),
    )


# name: how it is made, and its size in full, in a quick run and in the test
WORKS: dict[str, tuple[Callable[[int], Work], tuple[int, int, int]]] = {
    "W1": (partial(sensitivity, exact=False), (100_000, 20_000, 30)),
    "W1s": (partial(sensitivity, exact=False), (512, 512, 7)),
    "W1exact": (partial(sensitivity, exact=True), (512, 512, 7)),
    "W2_19": (matrix, (19, 19, 7)),
    "W2_200": (matrix, (200, 200, 9)),
    "W3ik": (partial(ideal, forward=False), (100_000, 20_000, 30)),
    "W3fk": (partial(ideal, forward=True), (100_000, 20_000, 30)),
    "W4exact": (servo, (100_000, 20_000, 30)),
    "W4linear": (linear, (100_000, 20_000, 30)),
    "W4py_exact": (partial(call, kind="exact"), (1, 1, 1)),
    "W4py_linear": (partial(call, kind="linear"), (1, 1, 1)),
    "W5": (forward, (100_000, 20_000, 30)),
    "W5s": (forward, (19, 19, 7)),
    "W6_18": (partial(trials, model="18", kept=False), (1000, 200, 3)),
    "W6_32": (partial(trials, model="32", kept=False), (1000, 200, 3)),
    "W6_18kept": (partial(trials, model="18", kept=True), (1000, 200, 3)),
    "W6_32kept": (partial(trials, model="32", kept=True), (1000, 200, 3)),
    "exact_18": (partial(identification, model="18"), (19, 19, 19)),
    "exact_32": (partial(identification, model="32"), (19, 19, 19)),
    "exact_dh": (chain_identification, (1000, 1000, 60)),
    "W7_cold": (partial(start, what="identification", cold=True), (1, 1, 1)),
    "W7_warm": (partial(start, what="identification", cold=False), (1, 1, 1)),
    "W7cli_cold": (partial(start, what="deltacal identify", cold=True), (1, 1, 1)),
    "W7cli_warm": (partial(start, what="deltacal identify", cold=False), (1, 1, 1)),
    "W7command_cold": (partial(start, what="command", cold=True), (1, 1, 1)),
    "W7command_warm": (partial(start, what="command", cold=False), (1, 1, 1)),
}
WORKS |= {
    f"{what}_{name}": (partial(every_mechanism, name=name, derivatives=what == "sensitivity"), (2000, 2000, 9))
    for name in mechanism_names()
    if load_mechanism(name).written_out
    for what in ("forward", "sensitivity")
}

WORKS |= {
    "forward_serial": (partial(chain, derivatives=False), (2000, 2000, 9)),
    "sensitivity_serial": (partial(chain, derivatives=True), (2000, 2000, 9)),
}


def works(names: list[str], size: int) -> Iterator[tuple[str, Work]]:
    """Make the works one by one, in size 0 (full), 1 (quick) or 2 (test)."""
    for name in names:
        make, sizes = WORKS[name]
        yield name, make(sizes[size])


def disagreement(work: Work) -> dict[str, float]:
    """Run every contender once; return by how much each differs from NumPy, in units of the tolerance."""
    seen = {}
    for name, contender in work.contenders.items():
        if contender.before is not None:
            contender.before()
        seen[name] = np.array(contender.view(contender.run()))
    return {name: float(np.abs(value - seen[NUMPY]).max() / work.tolerance) for name, value in seen.items()}
