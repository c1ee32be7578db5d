"""Tables 1 to 5, figures 9 to 12 of Traslosheros 2013.

The true machine has Table 1's calibrated limbs, its home where these put it. Readings have the noise of Table 3, per
axis. What the paper leaves open (paths of the ball, heights of the cylinder, where the nominal Jacobian is taken) is
chosen here and said in the table's title.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np

from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.solvers import LeastSquares
from deltacal_gen.files.robot import Robot, read_robot
from deltacal_gen.identification.identifiability import identification_matrix, observability
from deltacal_gen.machine.registry import SOLVED, Array, load_mechanism
from deltacal_gen.machine.values import POSITION, Measurement, Recording
from deltacal_gen.physics.simulation import read_truth, simulate
from deltacal_gen.planning.rows import blank_recording
from deltacal_gen.units import DEG
from deltacal_gen.use import iso9283
from derive.review.reproduction.sheet import Part, Picture, Sheet
from derive.review.sources import EXAMPLES

HOME = {"px0": 5.31, "py0": 0.31, "pz0": 743.74}  # Table 1, calibrated [mm]; its limbs put it elsewhere, see the truth
TABLE_2 = np.array([0.014, 0.038, 0.092])  # one image: standard deviations along x, y, z of the camera [mm]
TABLE_3 = np.array([0.0025, 0.0049, 0.0212])  # the mean of 500
TABLE_4 = ("0.032, 0.025, 0.114 and 0.039, 0.034, 0.121", "0.0704, 0.0751")  # ranges and RP at 1 and 2 m/s [mm]
ENCODERS = 0.02  # mm, section 6.1
GAIN, PERIOD = 16.8, 8.34e-3  # K_p [1/s], one image [s]
IMAGES = 600  # of a test of tracking
SPEEDS = (500, 750, 1000, 1250, 1500)  # mm/s
TABLE_5 = ((4.54, 4.47), (7.42, 7.32), (12.76, 12.61), (20.14, 19.84), (30.47, 30.14))  # mm, nominal and calibrated
TENNIS = load_mechanism("robotennis")


def rows(robot: Robot, errors: dict[str, float] | None = None) -> Array:
    """Return the rows of the kernels [mm, rad]: with the robot file's own errors, or with others."""
    return TENNIS.rows(robot if errors is None else dataclasses.replace(robot, errors=errors))


def reach(P: Array, machine: Array) -> np.ndarray:
    """Tell which positions (N, 3) a machine reaches."""
    status: np.ndarray = TENNIS.inverse(P, np.zeros_like(P), machine)[2]
    return status == SOLVED


def near_the_boundary(n: int, machine: Array, rng: np.random.Generator) -> Array:
    """Return random positions (n, 3) from which the workspace ends 50 to 100 mm further out (section 5.1)."""
    found = np.zeros((0, 3))
    centre = np.array([0.0, 0.0, 850.0])
    while len(found) < n:
        P = centre + rng.uniform(-1, 1, (20 * n, 3)) * [450, 450, 350]
        out = P - centre
        out /= np.linalg.norm(out, axis=1)[:, None]
        kept = reach(P, machine) & reach(P + 50 * out, machine) & ~reach(P + 100 * out, machine)
        found = np.vstack([found, P[kept]])
    return found[:n]


def recording_of(robot: Robot, P: Array, truth: dict[str, float], rng: np.random.Generator) -> Recording:
    """Return what the camera reads at the home and at positions (N, 3), in increments, with Table 3's noise."""
    P = np.vstack([robot.geometry["home"], P])
    joints, _, _ = TENNIS.inverse(P, np.zeros_like(P), rows(robot))
    joints[0] = 0.0
    said = Measurement(frame="robot", zero="incremental")
    exact = simulate(robot, blank_recording(robot, "position", joints, POSITION, said, "traslosheros2013.csv"), truth)
    return dataclasses.replace(exact, measured=exact.measured + TABLE_3 * rng.standard_normal((len(P), 3)))


def calibrated(robot: Robot, truth: dict[str, float], P: Array, rng: np.random.Generator) -> tuple[Array, Array]:
    """Return the 15 parameters identified from 300 poses, and their standard deviations [mm, rad]."""
    problem = pose_problem(robot, recording_of(robot, P, truth, rng), TENNIS.model("robotennis/15"))
    found = fit(problem, LeastSquares(), weigh_repeats=False, robust=False)
    columns = [TENNIS.index[name] for name in problem.names]
    return found.errors[columns], np.sqrt(np.diag(found.covariance))[: len(columns)]


def table_1(robot: Robot, truth: dict[str, float], rng: np.random.Generator) -> tuple[Sheet, dict[str, float]]:
    """Return Table 1, and the 15 parameters found from poses near the boundary of the workspace [mm, rad]."""
    heads = ("parameter, mm or deg", "paper: calibrated", "simulated", "found", "std, boundary", "std, inside")
    title = "Calibrated less nominal: as printed, as simulated, found again from 300 poses with Table 3's noise"
    sheet = Sheet("Table 1", title, heads)
    printed = truth | {n: HOME[n] - at for n, at in zip(HOME, robot.geometry["home"], strict=True)}
    boundary = near_the_boundary(300, rows(robot), rng)
    r, t = 250 * np.sqrt(rng.uniform(size=300)), rng.uniform(0, 2 * np.pi, 300)
    inside = np.column_stack([r * np.cos(t), r * np.sin(t), rng.uniform(750, 950, 300)])
    found, deviation = calibrated(robot, truth, boundary, rng)
    _, other = calibrated(robot, truth, inside, rng)
    names = TENNIS.model("robotennis/15")
    for name, value, a, b in zip(names, found, deviation, other, strict=True):
        f = DEG if name.startswith("theta") else 1.0
        known = (f"{of[name] / f:.3f}" for of in (printed, truth))
        sheet.add(name, *known, f"{value / f:.3f}", f"{a / f:.4f}", f"{b / f:.4f}")
    return sheet, dict(zip(names, found.tolist(), strict=True))


def observable(robot: Robot, truth: dict[str, float], rng: np.random.Generator) -> tuple[Sheet, Sheet]:
    """Return what readings see with and without phi and H, and how many poses the 15 parameters need."""
    recording = recording_of(robot, near_the_boundary(300, rows(robot), rng), truth, rng)

    def figures(model: str, read: Recording) -> tuple[int, str, float]:
        problem = pose_problem(robot, read, TENNIS.model(model))
        found = observability(identification_matrix(problem, "typical").H, read.n_rows)
        known = "-" if not np.isfinite(found.condition) else f"{found.condition:.0f}"
        return found.rank, known, found.indices["O1"]

    heads = ("parameters", "frame of the camera", "rank", "condition")
    with_more = Sheet("Table 1", "What 300 poses identify", heads)
    for model, words in (("15", "a b h theta0, P0"), ("18", "and phi"), ("21", "and phi, H")):
        for frame in ("robot", "unknown"):
            read = dataclasses.replace(recording, measurement=dataclasses.replace(recording.measurement, frame=frame))
            rank, known, _ = figures(f"robotennis/{model}", read)
            with_more.add(f"{model}: {words}", frame, f"{rank} of {model}", known)
    fewest = Sheet(
        "Table 1", "Least number of poses; the paper has 6", ("poses, the home among them", "rank", "condition")
    )
    for n in (4, 5, 6, 7, 10, 20):
        rank, known, _ = figures("robotennis/15", recording.subset(np.arange(n)))
        fewest.add(str(n), f"{rank} of 15", known)
    return with_more, fewest


def repeatability(rng: np.random.Generator) -> Iterator[Sheet]:
    """Yield Tables 2 to 4: ranges and ISO 9283 figures, the camera alone and with the encoders' 0.02 mm as a range."""
    heads = ("readings", "range x, y, z, mm", "RP, mm", "paper: range", "paper: RP")
    for number, cases in (
        ("Table 2", (("one image", 50, TABLE_2, "0.059, 0.163, 0.497", ""),)),
        (
            "Table 3",
            (
                ("mean of 500", 25, TABLE_3, "0.0096, 0.0150, 0.0846", "0.0635"),
                ("if images were independent", 25, TABLE_2 / np.sqrt(500), "", ""),
            ),
        ),
        ("Table 4", (("robot and camera", 25, np.hypot(TABLE_3, ENCODERS / np.sqrt(12)), *TABLE_4),)),
    ):
        sheet = Sheet(number, "Median of 2000 loops of normal readings with the printed deviations", heads)
        for name, n, sigma, ranges, printed in cases:
            loops = sigma * rng.standard_normal((2000, n, 3))
            spread = np.median(np.ptp(loops, axis=1), axis=0)
            RP = [iso9283.pose(loop, np.zeros(3)).repeatability for loop in loops]
            sheet.add(name, ", ".join(f"{r:.4f}" for r in spread), f"{np.median(RP):.4f}", ranges, printed)
        yield sheet


def plate_errors(true: Array, assumed: Array, z: float, rng: np.random.Generator) -> Array:
    """Return mean errors (5, 5, 5) of the distances from each circle to its neighbours in its plane (section 6.1.2).

    Of 25 loops with Table 3's noise, the camera's axis along x, and that of the encoders.
    """
    step = np.arange(-200, 201, 100.0)
    grid = np.stack(np.meshgrid(step, step, step + z, indexing="ij"), axis=-1)
    P = grid.reshape(-1, 3)
    joints, _, _ = TENNIS.inverse(P, np.zeros_like(P), true)
    read, _ = TENNIS.forward(joints, np.zeros_like(P), assumed)
    noise = np.hypot(TABLE_3[[2, 0, 1]], ENCODERS / np.sqrt(12)) * rng.standard_normal((25, *grid.shape))
    read = read[:, :3].reshape(grid.shape) + noise
    total, count = np.zeros((5, 5, 5)), np.zeros((5, 5, 5))
    for axis in (1, 2):
        error = np.abs(np.linalg.norm(np.diff(read, axis=axis + 1), axis=-1) - 100).mean(axis=0)
        for part in (slice(0, 4), slice(1, 5)):
            at = tuple(part if k == axis else slice(None) for k in range(3))
            total[at] += error
            count[at] += 1
    mean: Array = total / count
    return mean


def jacobian(P: Array, machine: Array, joints: Array | None = None) -> tuple[Array, Array]:
    """Return J_R (N, 3, 3) of equation (24) at positions, or at joints, and the joints."""
    tool = np.zeros((len(P), 3))
    if joints is None:
        joints, _, _ = TENNIS.inverse(P, tool, machine)
    x, _ = TENNIS.forward(joints, tool, machine)
    return TENNIS.sensitivity(x, joints, tool, machine).joints[:, :3], joints


SAME = ("place", "displacement", "motors")  # what of the true pose the nominal Jacobian is taken at


def velocity_error(P: Array, true: Array, assumed: Array, home: Array, *, same: str) -> Array:
    """Return the largest singular values (N,) of equation (28) with the true effector at places P in {O}.

    `same`: the nominal machine at the same place in {O}, at the same displacement from its own home, or at the same
    motor readings. `home` is the true home less the nominal one.
    """
    C, joints = jacobian(P - home, true)
    N, _ = jacobian(P if same == "place" else P - home, assumed, joints if same == "motors" else None)
    size: Array = np.linalg.norm(C @ np.linalg.inv(N) - np.eye(3), ord=2, axis=(1, 2))
    return size


def cylinder(bottom: float) -> Array:
    """Return points (N, 3) [mm] of a cylinder about z, 300 mm in radius, from `bottom` to 400 mm above it."""
    r, t, z = np.meshgrid(
        (10, 100, 200, 300), np.linspace(0, 2 * np.pi, 48, endpoint=False), np.linspace(bottom, bottom + 400, 17)
    )
    return np.column_stack([(r * np.cos(t)).ravel(), (r * np.sin(t)).ravel(), z.ravel()])


def figure_12(true: Array, assumed: Array, home: Array) -> Sheet:
    """Return figure 12: the largest velocity error in cylinders that begin at different heights."""
    heads = ("cylinder from z", *(f"same {s}" for s in SAME), "paper")
    sheet = Sheet("Fig. 12", "Largest value of (28), by what of the true pose the nominal Jacobian is taken at", heads)
    for bottom in (570, 600, 650, 700, 750, 760, 800):
        values = [velocity_error(cylinder(bottom), true, assumed, home, same=s).max() for s in SAME]
        sheet.add(f"{bottom} mm", *(f"{v:.4f}" for v in values), "0.015")
    return sheet


def track(
    true: Array, assumed: Array, speed: float, rng: np.random.Generator, tests: int = 10, n: int = IMAGES
) -> float:
    """Return the mean tracking error [mm] of the loop of figure 11, in which a robot keeps a ball at a fixed offset.

    The ball moves on sums of three sines within 150 mm, in a time scaled so that twice its RMS speed is `speed`. The
    camera sees it relative to the effector, one image late, with Table 2's noise; the controller adds where it believes
    the effector, by its own kinematics, and takes the ball's velocity from two images. The robot moves as the true
    machine does, without delay of its drives.
    """
    w = rng.uniform(1, 3, (tests, 3, 3))
    a, phase = rng.uniform(0.3, 1, (tests, 3, 3)), rng.uniform(0, 2 * np.pi, (tests, 3, 3))
    a *= 150 / a.sum(axis=2, keepdims=True)
    top = np.einsum("kij,kij->k", a**2, w**2)  # twice the mean square of the speed
    t = PERIOD * np.arange(n) * (speed / np.sqrt(2 * top))[:, None]
    path = np.einsum("kij,kijt->kti", a, np.sin(w[..., None] * t[:, None, None] + phase[..., None]))
    path += np.array([0, 0, 850.0]) - path.mean(axis=1, keepdims=True)
    tool = np.zeros((tests, 3))
    joints, _, _ = TENNIS.inverse(path[:, 0], tool, true)
    apart = np.zeros((tests, 3))  # of the last image, and where it puts the ball
    seen = before = TENNIS.forward(joints, tool, assumed)[0][:, :3]
    errors = []
    for k in range(n):
        P, believed = (TENNIS.forward(joints, tool, m)[0][:, :3] for m in (true, assumed))
        errors.append(np.linalg.norm(path[:, k] - P, axis=1))
        wanted = GAIN * apart + (seen - before) / PERIOD  # (23), e = ball less robot
        J, _ = jacobian(P, assumed, joints)
        joints = joints + PERIOD * np.linalg.solve(J, wanted[..., None])[..., 0]  # (25)
        apart = path[:, k] - P + TABLE_2 * rng.standard_normal((tests, 3))
        before, seen = seen, believed + apart
    return float(np.mean(errors))


def table_5(true: Array, nominal: Array, images: int) -> Sheet:
    """Return Table 5, the calibrated set the truth, and the gain were the nominal one.

    The loop is off by its lag. The two sets differ by 1 %, but the nominal one tracks better, whichever is the truth:
    its Jacobian makes the robot run ahead of what is asked, which takes a part of the lag away.
    """
    heads = ("top speed", "nominal", "calibrated", "gain, %", "gain, the other true, %", "paper: both", "paper: gain")
    sheet = Sheet("Table 5", "Mean tracking error in a simulated loop, mm", heads)
    for speed, (p, c) in zip(SPEEDS, TABLE_5, strict=True):
        a, b = (track(true, assumed, speed, np.random.default_rng(5), n=images) for assumed in (nominal, true))
        d, e = (track(nominal, assumed, speed, np.random.default_rng(5), n=images) for assumed in (nominal, true))
        sheet.add(
            str(speed),
            f"{a:.3f}",
            f"{b:.3f}",
            f"{100 * (a - b) / a:.2f}",
            f"{100 * (d - e) / d:.2f}",
            f"{p}, {c}",
            f"{100 * (p - c) / p:.2f}",
        )
    return sheet


def _figure_9_and_10(true: Array, machine: Array, axes: Any) -> None:
    """Draw maps of the mean distance errors, plane by plane."""
    errors = plate_errors(true, machine, 850.0, np.random.default_rng(9))
    for k, ax in enumerate(axes):
        image = ax.imshow(
            errors[k].T, vmin=0, vmax=2, origin="lower", extent=(-250, 250, 600, 1100), interpolation="bilinear"
        )
        ax.set_title(f"x = {100 * k - 200} mm", fontsize=9)
        ax.set_xlabel("y, mm")
        ax.label_outer()
    axes[0].set_ylabel("z, mm")
    axes[0].figure.colorbar(image, ax=list(axes), label="mm", shrink=0.8)


def _figure_12_map(true: Array, nominal: Array, home: Array, axes: Any) -> None:
    """Draw maps of (28) around cylinders, the nominal Jacobian at the same motor readings."""
    z, t = np.linspace(760, 1160, 41), np.linspace(0, 2 * np.pi, 73)
    for ax, radius in zip(axes, (10, 100, 200, 300), strict=True):
        T, Zs = np.meshgrid(t, z)
        P = np.column_stack([radius * np.cos(T.ravel()), radius * np.sin(T.ravel()), Zs.ravel()])
        value = velocity_error(P, true, nominal, home, same="motors").reshape(T.shape)
        image = ax.imshow(
            value,
            vmin=0,
            vmax=0.015,
            origin="lower",
            extent=(0, 360, 760, 1160),
            aspect="auto",
            interpolation="bilinear",
        )
        ax.set_title(f"radius {radius} mm", fontsize=9)
        ax.set_xlabel("angle about z, deg")
        ax.label_outer()
    axes[0].set_ylabel("z, mm")
    axes[0].figure.colorbar(image, ax=list(axes), shrink=0.8)


def study(tell: Callable[[str], None], images: int = IMAGES) -> Iterator[Part]:
    """Yield the paper's tables and figures, remade; the ball is tracked over a number of images."""
    robot = read_robot(EXAMPLES / "robotennis/robot.toml")
    truth = read_truth(EXAMPLES / "robotennis/truth.toml", robot).errors
    rng = np.random.default_rng(2013)
    tell("calibration from 300 poses")
    sheet, found = table_1(robot, truth, rng)
    true, nominal, identified = rows(robot, truth), rows(robot), rows(robot, found)
    yield sheet
    yield from observable(robot, truth, rng)
    yield from repeatability(rng)
    tell("distances between circles")
    for number, name, machine, printed in (
        ("Fig. 9", "calibrated", identified, "0.583"),
        ("Fig. 10", "nominal", nominal, "1.468"),
    ):
        plates = Sheet(number, "Mean error of 100 mm distances", ("parameters", "simulated, mm", "paper, mm"))
        plates.add(name, f"{plate_errors(true, machine, 850.0, rng).mean():.4f}", printed)
        yield plates
        drawn = partial(_figure_9_and_10, true, machine)
        yield Picture(number, f"Errors of distances to neighbours, {name} parameters", drawn, (1, 5), (8.6, 2.6))
    home = np.array([truth[n] for n in ("px0", "py0", "pz0")])
    yield figure_12(true, nominal, home)
    map_of = partial(_figure_12_map, true, nominal, home)
    yield Picture("Fig. 12", "Largest singular value of (28) around cylinders", map_of, (1, 4), (8.6, 2.6))
    tell("tracking a ball")
    yield table_5(true, nominal, images)
