"""Tables 3 to 6 and figures 5, 8, 9, 12 of Mei 2018, simulated: ``python -m tests.benchmarks.mei2018 [PICTURE]``.

The machine has the source errors of Table 2. A round moves it to the six positions, with the noise of the linear scale
(eq. 34) and of the motors (eq. 35), identifies zero offsets and the mechanism's errors from adjacent differences, and
compensates both; the next round starts from there. The correction of the mechanism is f - dr_M: with the plus that
eq. (30) prints the procedure diverges.

The better identification takes the same readings of all rounds at once, on the exact machine with all twelve
parameters, each known beforehand to its tolerance.
"""

from __future__ import annotations

import dataclasses
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from rich.console import Console
from rich.table import Table

from deltacal_gen.app.demonstration import example
from deltacal_gen.estimation.estimation import Fit, fit, pose_problem
from deltacal_gen.estimation.solvers import TSVD, LeastSquares, Prior, Ridge, Solver
from deltacal_gen.files.recording import Recording, read_recording
from deltacal_gen.files.robot import Robot, read_robot
from deltacal_gen.identification.identifiability import observability
from deltacal_gen.instrument.instrument import Instrument
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.instrument.readings import Readings
from deltacal_gen.machine.registry import Array, load_mechanism
from deltacal_gen.physics.simulation import read_truth
from deltacal_gen.planning import planning
from deltacal_gen.units import DEG

DIAMOND = load_mechanism("diamond")
ZEROS = [DIAMOND.index["theta_1"], DIAMOND.index["theta_2"]]
OFFSETS = ((2.0, -1.0), (-1.0, 0.5), (0.5, 0.25))  # Table 2, deg
SCALE = (3 + 350 / 1000) * 1e-3 / 3  # eq. (34), mm
MOTOR = 4 / (20 * 1e4) * 360 / 3 * DEG  # eq. (35)
HOME = np.array([[0.0, np.pi]])
STOP, MOST_ROUNDS = 0.1 * DEG, 40  # mu_0; a noisy procedure may never stop by its rule
ROUNDS = 10  # of readings for the better identification
BEFORE, BEFORE_MAX = (10.933, 5.482, 3.796, 10.896, 5.5195, 3.798), (12.906, 6.418, 4.672, 12.868, 6.455, 4.663)
AFTER, AFTER_MAX = (0.402, 0.423, 0.434, 0.228, 0.256, 0.239), (0.493, 0.531, 0.533, 0.279, 0.314, 0.293)
DELTA = ((0.033, 0.043), (0.049, 0.037), (0.036, 0.047), (0.024, 0.022), (0.025, 0.026), (0.024, 0.025))
TABLE_5 = ((0.069, 0.040), (0.074, 0.045), (0.071, 0.042), (0.044, 0.022), (0.051, 0.028), (0.047, 0.024))
TABLE_6 = (472.47, 472.49, 472.49, 472.50, 472.51, 472.50)


def group(number: int, truth: dict[str, float]) -> Array:
    """Return the source errors (12,) of a group of Table 2, from those of group 1 [mm, rad]."""
    smaller = {name: value * (1.0 if number <= 3 or name[0] == "m" else 0.1) for name, value in truth.items()}
    zero = OFFSETS[(number - 1) % 3]
    return DIAMOND.vector(smaller | {f"theta_{i + 1}": zero[i] * DEG for i in range(2)})


@dataclass(frozen=True)
class Bench:
    """The robot as its file knows it, and the six positions with their nominal joints (6, 2)."""

    robot: Robot
    poses: Recording
    joints: Array
    x: Array
    sensitivity: Array

    @staticmethod
    def of_example() -> Bench:
        folder = example("diamond")
        robot = read_robot(folder / "robot.toml")
        poses = read_recording(folder / "poses.csv", DIAMOND, need_measured=False, allow_targets=True)
        tool, rows = np.array(poses.measurement.platform_point_mm), DIAMOND.rows(robot)
        joints, x, _ = DIAMOND.inverse(np.asarray(poses.targets), tool, rows)
        return Bench(robot, poses, joints, x, DIAMOND.sensitivity(x, joints, tool, rows).parameters)

    @property
    def tool(self) -> Array:
        return np.array(self.poses.measurement.platform_point_mm)

    def instrument(self, mounted: Array) -> Instrument:
        """Return a gauge per row of `mounted` (S, 2), each off by so much from where it is nominally mounted."""
        state = np.zeros((len(mounted), 4))
        state[:, :3] = self.poses.measurement.base_point_mm
        state[:, :2] += mounted
        return Instrument(kind_of("gauge"), state, ())

    def home(self, errors: Array, taken: Array | float = 0.0) -> Array:
        """Return the home error [mm] after the controller takes offsets (S, 2) off."""
        rows, nominal = DIAMOND.rows(self.robot, errors), DIAMOND.rows(self.robot)
        reached = DIAMOND.forward(HOME - np.atleast_2d(taken), np.zeros(3), rows)[0]
        return np.linalg.norm((reached - DIAMOND.forward(HOME, np.zeros(3), nominal)[0])[:, :2], axis=1)

    def errors_at(self, p: Array, errors: Array, taken: Array) -> Array:
        """Return the position errors (S, M) [mm] at p (M, 3) after offsets (S, 2) have been taken off."""
        joints = DIAMOND.inverse(p, np.zeros(3), DIAMOND.rows(self.robot))[0]
        commanded = (joints[None] - np.atleast_2d(taken)[:, None]).reshape(-1, 2)
        reached = DIAMOND.forward(commanded, np.zeros(3), DIAMOND.rows(self.robot, errors))[0]
        return np.linalg.norm(reached[:, :2].reshape(-1, len(p), 2) - p[:, :2], axis=2)


def readings(seeds: int) -> Readings:
    n = 6 * seeds
    rows = np.arange(n)
    return Readings(kind_of("gauge"), rows[:, None], np.zeros((n, 1)), None, np.repeat(np.arange(seeds), 6), rows, rows)


@dataclass(frozen=True)
class Run:
    """Offsets taken off before each round and after the last (S, R + 1, 2), what was read (S, R, 6), and so on."""

    taken: Array
    mechanism: Array
    condition: Array
    lengths: Array

    def stop(self) -> np.ndarray:
        """Return after how many rounds the rule of eq. (32) stops."""
        steps = np.diff(self.taken, axis=1)
        below = np.sqrt(np.mean(np.diff(steps, axis=1) ** 2, axis=2)) < STOP
        return np.where(below.any(axis=1), below.argmax(axis=1) + 2, steps.shape[1])


def run(
    bench: Bench,
    errors: Array,
    mounted: Array,
    rounds: int,
    rng: np.random.Generator,
    motor: float = MOTOR,
    solver: Solver | None = None,
) -> Run:
    """Return the paper's procedure for every row of `mounted` (S, 2), the true errors of the mechanism."""
    solver = LeastSquares(rcond=0.0) if solver is None else solver
    seeds, found = len(mounted), readings(len(mounted))
    rows, x = DIAMOND.rows(bench.robot, errors), np.tile(bench.x, (seeds, 1))
    dx = np.tile(bench.sensitivity[:, :, [DIAMOND.index["theta_1"], DIAMOND.index["theta_2"]]], (seeds, 1, 1))
    taken, known = np.zeros((seeds, rounds + 1, 2)), np.zeros((seeds, 2))
    mechanism, condition, lengths = (
        np.zeros((seeds, rounds, 2)),
        np.zeros((seeds, rounds)),
        np.zeros((seeds, rounds, 6)),
    )
    scale = np.array([DIAMOND.typical[DIAMOND.index[n]] for n in ("theta_1", "theta_2", "mx", "my")])
    arm = bench.robot.geometry["proximal_length"][0]
    sigma = float(np.hypot(SCALE, 0.8 * motor * arm))
    for j in range(rounds):
        q = bench.joints[None] - taken[:, j, None] + motor * rng.standard_normal((seeds, 6, 2))
        actual = DIAMOND.forward(q.reshape(-1, 2), bench.tool, rows)[0]
        read = bench.instrument(mounted).predict(found, actual)[0].reshape(seeds, 6)
        lengths[:, j] = read + SCALE * rng.standard_normal((seeds, 6))
        gauge = bench.instrument(known)
        J = np.concatenate([gauge.linearise(found, x, dx)[0], gauge.by_unknown(found, x, (0, 1))], axis=2)
        H = np.diff(J.reshape(seeds, 6, 4), axis=1)
        r = np.diff(lengths[:, j] - gauge.predict(found, x)[0].reshape(seeds, 6), axis=1)
        step = np.array([solver.solve(H[s] * scale / sigma, r[s] / sigma).u * scale for s in range(seeds)])
        taken[:, j + 1], known = taken[:, j] + step[:, :2], known + step[:, 2:]
        mechanism[:, j] = known
        s = np.linalg.svd(H / np.array([arm, arm, 1, 1]), compute_uv=False)
        condition[:, j] = s[:, 0] / s[:, 3]
    return Run(taken, mechanism, condition, lengths)


def together(bench: Bench, taken: Array, lengths: Array, robot: Robot, model: str, solver: Solver) -> Fit:
    """Return the fit to all rounds of one seed at once: commands taken off (R + 1, 2), lengths (R, 6)."""
    n = lengths.size
    recording = dataclasses.replace(
        bench.poses,
        targets=None,
        joints=(bench.joints[None] - taken[:-1, None]).reshape(-1, 2),
        measured=(lengths - lengths[0, 0]).reshape(-1, 1),
        pose=np.arange(n).astype(str),
        line=np.arange(n) + 2,
        setup=np.zeros(n, dtype=int),
    )
    problem = pose_problem(robot, recording, DIAMOND.model(model))
    if isinstance(solver, Prior):
        problem = dataclasses.replace(problem, scale=np.array([robot.tolerance[name] for name in problem.names]))
    return fit(problem, solver, robust=False, weigh_repeats=False, must_converge=False)


def joint(bench: Bench, done: Run, robot: Robot, model: str, solver: Solver) -> Array:
    """Return the zero offsets (S, 2) identified from all rounds of each seed at once."""
    runs = zip(done.taken, done.lengths, strict=True)
    return np.array([together(bench, *one, robot, model, solver).errors[ZEROS] for one in runs])


def attainable(bench: Bench, done: Run, robot: Robot) -> Array:
    """Return home errors (4000,) by the covariance of a fit to a machine that has no other errors.

    Noise, priors and poses allow no less on average, whatever is done with the readings.
    """
    runs = zip(done.taken[:20], done.lengths[:20], strict=True)
    C = np.mean([together(bench, *one, robot, "4", Prior("priors")).covariance[:2, :2] for one in runs], axis=0)
    return bench.home(np.zeros(len(DIAMOND.parameters)), np.random.default_rng(3).multivariate_normal([0, 0], C, 4000))


def spread(values: Array) -> str:
    """Return mean and central 90 % in words."""
    low, high = np.percentile(values, [5, 95])
    return f"{values.mean():.3f} ({low:.3f} to {high:.3f})"


def tables(screen: Console, bench: Bench, truth: dict[str, float], seeds: int) -> dict[int, Run]:
    """Print Tables 3 to 6, the printed figures beside ours; return the runs with the stated noise."""
    before = Table("group", "home: paper", "ours", "largest of six: paper", "ours", title="before calibration, mm")
    after = Table(
        "group", "noise", "delta, deg: paper", "ours", "home, mm: paper", "ours", "largest: paper", "ours", "as good",
        title=f"Tables 3 and 4 after calibration: mean (5 to 95 %) over {seeds} seeds",
    )  # fmt: skip
    mechanism = Table(
        "group", "noise", "dr_M, mm: paper", "ours", "kappa_m: paper", "ours", "rounds", title="Tables 5, 6"
    )
    six = bench.x[:, :3] - bench.tool
    runs = {}
    mounted = np.tile([truth["mx"], truth["my"]], (seeds, 1))
    for number in range(1, 7):
        errors = group(number, truth)
        largest = bench.errors_at(six, errors, np.zeros(2)).max()
        home = bench.home(errors)[0]
        before.add_row(
            str(number), str(BEFORE[number - 1]), f"{home:.4f}", str(BEFORE_MAX[number - 1]), f"{largest:.4f}"
        )
        for name, motor in (("stated", MOTOR), ("scale only", 0.0)):
            done = run(bench, errors, mounted, MOST_ROUNDS, np.random.default_rng(number), motor)
            if motor:
                runs[number] = done
            stop, row = done.stop(), np.arange(seeds)
            taken = done.taken[row, stop]
            off = np.abs(taken - errors[[0, 5]]).mean(axis=0) / DEG
            left, worst = bench.home(errors, taken), bench.errors_at(six, errors, taken).max(axis=1)
            paper = DELTA[number - 1]
            after.add_row(
                str(number), name, f"{paper[0]}, {paper[1]}", f"{off[0]:.3f}, {off[1]:.3f}", str(AFTER[number - 1]),
                spread(left), str(AFTER_MAX[number - 1]), spread(worst), f"{np.mean(left <= AFTER[number - 1]):.0%}",
            )  # fmt: skip
            m = np.abs(done.mechanism[row, stop - 1] - mounted).mean(axis=0)
            k = np.mean([done.condition[i, 1 : stop[i]].mean() for i in range(seeds)])
            paper = TABLE_5[number - 1]
            mechanism.add_row(
                str(number), name, f"{paper[0]}, {paper[1]}", f"{m[0]:.3f}, {m[1]:.3f}", str(TABLE_6[number - 1]),
                f"{k:.2f}", f"{stop.mean():.1f}",
            )  # fmt: skip
    for table in (before, after, mechanism):
        screen.print(table)
    return runs


def solvers(screen: Console, bench: Bench, truth: dict[str, float], seeds: int) -> None:
    """Compare rules for weak directions and the better identification, on the same readings of group 1."""
    errors = group(1, truth)
    rules: Sequence[tuple[str, Solver]] = (("TSVD, 4 of 4", TSVD(4)), ("TSVD, 3 of 4", TSVD(3)), ("ridge", Ridge()))
    at_once: Sequence[tuple[str, str, Solver]] = (
        ("4", "least squares", LeastSquares()),
        ("4", "ridge", Ridge()),
        ("12", "least squares", LeastSquares()),
        ("12", "TSVD by cross-validation", TSVD()),
        ("4", "priors", Prior("priors")),
        ("12", "priors", Prior("priors")),
    )
    for sd, centre in ((2.0, np.zeros(2)), (0.1, np.array([1.0, 0.5]))):
        mounted = centre + sd * np.random.default_rng(1).standard_normal((seeds, 2))
        known = dict(zip(("mx", "my"), centre.tolist(), strict=True))
        robot = dataclasses.replace(bench.robot, errors=known, tolerance=bench.robot.tolerance | {"mx": sd, "my": sd})
        done = run(bench, errors, mounted, ROUNDS, np.random.default_rng(2))
        paper = bench.home(errors, done.taken[:, -1])
        title = f"group 1, mechanism known to {sd} mm: mean (5 to 95 %) over {seeds} seeds"
        table = Table("identification", "home error, mm", "of the paper's", title=title)
        table.add_row("paper: round by round, least squares", spread(paper), "1")
        for name, solver in rules:
            other = run(bench, errors, mounted, ROUNDS, np.random.default_rng(2), solver=solver)
            left = bench.home(errors, other.taken[:, -1])
            table.add_row(f"round by round, {name}", spread(left), f"{left.mean() / paper.mean():.3f}")
        for model, name, solver in at_once:
            left = bench.home(errors, joint(bench, done, robot, model, solver))
            table.add_row(
                f"all rounds at once, diamond/{model}, {name}", spread(left), f"{left.mean() / paper.mean():.3f}"
            )
        left = attainable(bench, done, robot)
        table.add_row(
            "by the covariance of the fit: what noise and priors allow",
            spread(left),
            f"{left.mean() / paper.mean():.3f}",
        )
        screen.print(table)


def boundary(step: float = 30.0) -> Array:
    """Return the 42 positions of figure 11, in their order around the workspace."""
    x, y = np.arange(-240.0, 240.0, step), np.arange(-782.0, -632.0, step)
    sides = [(v, -782.0) for v in x] + [(240.0, v) for v in y]
    sides += [(-v, -632.0) for v in x] + [(-240.0, -1414 - v) for v in y]
    return np.array([(*p, 0.0) for p in sides])


def picture(path: Path, bench: Bench, truth: dict[str, float], runs: dict[int, Run]) -> None:
    """Draw figures 5, 8, 9 and 12."""
    from deltacal_gen.pages import figures

    with figures.mpl.rc_context(figures.STYLE):
        drawing, axes = figures.plt.subplots(2, 2, figsize=(10, 7), constrained_layout=True)
        a = axes[0, 0]
        size = np.linspace(-2, 2, 41)
        for name, unit in (("theta_1", "deg"), ("ex_1", "mm"), ("ey_1", "mm"), ("L_1", "mm"), ("l_1", "mm")):
            factor = DEG if unit == "deg" else 1.0
            home = [bench.home(DIAMOND.vector({name: v * factor}))[0] for v in size]
            a.plot(size, home, "--" if name == "L_1" else "-", label=f"{name}, {unit}")  # L_1 lies on ex_1
        a.set(xlabel="error of limb 1", ylabel="home error, mm", title="figure 5: sensitivity")
        a.legend(frameon=False)

        a = axes[0, 1]
        mount = planning.Mount(np.array(bench.poses.measurement.base_point_mm), bench.tool)
        known = dataclasses.replace(bench.robot, errors={"mx": 1.0, "my": 0.5})
        plan = planning.plan(known, "diamond/4", kind="gauge", mount=mount, n_max=12)
        n = [step.n for step in plan.steps]
        a.plot(n, [step.condition for step in plan.steps], "o-", label="kappa_1")
        a.plot(n, [step.corrected for step in plan.steps], "x--", label="kappa_m, f - dr_M")
        a.set(xlabel="n, positions per boundary", ylabel="condition number", title="figure 8")
        a.legend(frameon=False)

        a = axes[1, 0]
        errors = group(1, truth)
        for seed in range(5):
            a.plot(
                (runs[1].taken[seed, 1:, 0] - errors[0]) / DEG, lw=0.9, color="C0", label="" if seed else "five seeds"
            )
        a.plot(
            (runs[1].taken[:, 1:, 0] - errors[0]).std(axis=0) / DEG, color="C1", label="standard deviation, all seeds"
        )
        a.set(xlabel="compensations m", ylabel="error of theta_1, deg", title="figure 9: group 1, stated noise")
        a.legend(frameon=False)

        a = axes[1, 1]
        p, centre, sd = boundary(), np.array([truth["mx"], truth["my"]]), 0.1
        mounted = centre + sd * np.random.default_rng(1).standard_normal((len(runs[1].taken), 2))
        done = run(bench, errors, mounted, ROUNDS, np.random.default_rng(2))
        known = dict(zip(("mx", "my"), centre.tolist(), strict=True))
        robot = dataclasses.replace(bench.robot, errors=known, tolerance=bench.robot.tolerance | {"mx": sd, "my": sd})
        best = joint(bench, done, robot, "12", Prior("priors"))
        a.plot(bench.errors_at(p, errors, np.zeros(2))[0], label="before")
        a.plot(bench.errors_at(p, errors, done.taken[:, -1]).mean(axis=0), label="paper's procedure, ten rounds")
        a.plot(bench.errors_at(p, errors, best).mean(axis=0), label="all rounds at once, priors (0.1 mm)")
        a.set(
            xlabel="position along the boundary", ylabel="position error, mm", title="figure 12: group 1, mean of seeds"
        )
        a.set_yscale("log")
        a.legend(frameon=False)
        figures.save(drawing, path)


def main(seeds: int = 200) -> None:
    """Simulate, identify, print the tables, draw the figures."""
    screen, bench = Console(width=150), Bench.of_example()
    truth = read_truth(example("diamond") / "truth.toml", bench.robot).errors
    H = np.diff(_columns(bench), axis=0)
    screen.print(f"kappa_1 of the six positions: {observability(H, 6).condition:.2f} (paper 475.34)")
    runs = tables(screen, bench, truth, seeds)
    solvers(screen, bench, truth, seeds)
    if len(sys.argv) > 1:
        picture(Path(sys.argv[1]), bench, truth, runs)


def _columns(bench: Bench) -> Array:
    """Return the rows g_k (6, 4) of eq. (28), columns in mm."""
    dx = bench.sensitivity[:, :, [DIAMOND.index["theta_1"], DIAMOND.index["theta_2"]]]
    gauge, found = bench.instrument(np.zeros((1, 2))), readings(1)
    J = np.concatenate([gauge.linearise(found, bench.x, dx)[0], gauge.by_unknown(found, bench.x, (0, 1))], axis=2)
    return J[:, 0] / np.array([*[bench.robot.geometry["proximal_length"][0]] * 2, 1, 1])


if __name__ == "__main__":
    main()
