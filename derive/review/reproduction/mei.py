"""Tables 3 to 6 and figures 5, 8, 9, 12 of Mei 2018, simulated.

The machine has the source errors of Table 2. A round moves it to the six positions, with the noise of the linear scale
(eq. 34) and of the motors (eq. 35), identifies zero offsets and the mechanism's errors from adjacent differences, and
compensates both; the next round starts from there. The correction of the mechanism is f - dr_M: with the plus that
eq. (30) prints the procedure diverges.

The better identification takes the same readings of all rounds at once, on the exact machine with all twelve
parameters, each known beforehand to its tolerance.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

import numpy as np

from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.solvers import TSVD, LeastSquares, Prior, Ridge, Solver
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import Robot, read_robot
from deltacal_gen.identification.identifiability import observability
from deltacal_gen.instrument.kind import Instrument, Readings
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import Array, load_mechanism
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.simulation import read_truth
from deltacal_gen.planning import planning
from deltacal_gen.units import DEG
from derive.review.reproduction.sheet import Part, Picture, Sheet
from derive.review.sources import EXAMPLES

DIAMOND = load_mechanism("diamond")
ZEROS = [DIAMOND.index["theta_1"], DIAMOND.index["theta_2"]]
OFFSETS = ((2.0, -1.0), (-1.0, 0.5), (0.5, 0.25))  # Table 2, deg
SCALE = (3 + 350 / 1000) * 1e-3 / 3  # eq. (34), mm
MOTOR = 4 / (20 * 1e4) * 360 / 3 * DEG  # eq. (35)
HOME = np.array([[0.0, np.pi]])
STOP, MOST_ROUNDS = 0.1 * DEG, 40  # mu_0; a noisy procedure may never stop by its rule
ROUNDS = 10  # of readings for the better identification
SEEDS = 100  # simulated procedures
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
        """Return the bench of the example: six positions, and the joints that the nominal machine gives them."""
        folder = EXAMPLES / "diamond"
        robot = read_robot(folder / "robot.toml")
        poses = read_recording(folder / "poses.csv", DIAMOND, need_measured=False, allow_targets=True)
        tool, rows = np.array(poses.measurement.platform_point_mm), DIAMOND.rows(robot)
        joints, x, _ = DIAMOND.inverse(np.asarray(poses.targets), tool, rows)
        return Bench(robot, poses, joints, x, DIAMOND.sensitivity(x, joints, tool, rows).parameters)

    @property
    def tool(self) -> Array:
        """End of the gauge on the platform (3,) [mm]."""
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
    """Return which readings a gauge takes: six of each seed, one after the other."""
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


@dataclass(frozen=True)
class Groups:
    """The six groups of Table 2 with the stated noise and without that of the motors, a procedure per seed."""

    bench: Bench
    truth: dict[str, float]
    seeds: int

    @property
    def mounted(self) -> Array:
        """The scale's mounting errors (S, 2), the same for every seed."""
        return np.tile([self.truth["mx"], self.truth["my"]], (self.seeds, 1))

    @cached_property
    def runs(self) -> dict[tuple[int, str], Run]:
        """Procedures by group and noise."""
        noises = (("stated", MOTOR), ("scale only", 0.0))
        return {
            (number, name): run(
                self.bench, group(number, self.truth), self.mounted, MOST_ROUNDS, np.random.default_rng(number), motor
            )
            for number in range(1, 7)
            for name, motor in noises
        }

    @property
    def six(self) -> Array:
        """The six positions (6, 3)."""
        return self.bench.x[:, :3] - self.bench.tool

    def before(self) -> Sheet:
        """Return the errors before calibration."""
        heads = ("group", "home, mm", "largest of six, mm", "paper: home", "paper: largest of six")
        sheet = Sheet("Table 3", "Errors before calibration, with the largest of the six positions (Table 4)", heads)
        for number in range(1, 7):
            errors = group(number, self.truth)
            largest = self.bench.errors_at(self.six, errors, np.zeros(2)).max()
            home = self.bench.home(errors)[0]
            sheet.add(number, f"{home:.4f}", f"{largest:.4f}", BEFORE[number - 1], BEFORE_MAX[number - 1])
        return sheet

    def after(self) -> Sheet:
        """Return the errors after calibration."""
        ours, papers = ("delta, deg", "home, mm", "largest of six, mm"), ("delta", "home", "largest of six")
        heads = ("group", "noise", *ours, "as good", *(f"paper: {p}" for p in papers))
        sheet = Sheet("Table 4", f"After calibration, with Table 3: mean (5 to 95 %) over {self.seeds} seeds", heads)
        for (number, name), done in self.runs.items():
            errors = group(number, self.truth)
            taken = done.taken[np.arange(self.seeds), done.stop()]
            off = np.abs(taken - errors[[0, 5]]).mean(axis=0) / DEG
            left = self.bench.home(errors, taken)
            worst = self.bench.errors_at(self.six, errors, taken).max(axis=1)
            k = number - 1
            found = (f"{off[0]:.3f}, {off[1]:.3f}", spread(left), spread(worst), f"{np.mean(left <= AFTER[k]):.0%}")
            sheet.add(number, name, *found, f"{DELTA[k][0]}, {DELTA[k][1]}", AFTER[k], AFTER_MAX[k])
        return sheet

    def mechanism(self) -> Iterator[Sheet]:
        """Yield what is found of the scale's mounting, and condition numbers."""
        heads = ("group", "noise", "dr_Mx, mm", "dr_My, mm", "paper: dr_Mx", "paper: dr_My")
        mounting = Sheet("Table 5", f"Mean error of the mounting found, over {self.seeds} seeds", heads)
        others = ("group", "noise", "kappa_m", "rounds", "paper: kappa_m")
        condition = Sheet(
            "Table 6", "Mean condition number of the later rounds, and rounds until the rule stops", others
        )
        for (number, name), done in self.runs.items():
            stop, row = done.stop(), np.arange(self.seeds)
            m = np.abs(done.mechanism[row, stop - 1] - self.mounted).mean(axis=0)
            mounting.add(number, name, *(f"{v:.3f}" for v in m), *TABLE_5[number - 1])
            k = np.mean([done.condition[i, 1 : stop[i]].mean() for i in row])
            condition.add(number, name, f"{k:.2f}", f"{stop.mean():.1f}", TABLE_6[number - 1])
        yield mounting
        yield condition


RULES: Sequence[tuple[str, Solver]] = (("TSVD, 4 of 4", TSVD(4)), ("TSVD, 3 of 4", TSVD(3)), ("ridge", Ridge()))
AT_ONCE: Sequence[tuple[str, str, Solver]] = (
    ("4", "least squares", LeastSquares()),
    ("4", "ridge", Ridge()),
    ("12", "least squares", LeastSquares()),
    ("12", "TSVD by cross-validation", TSVD()),
    ("4", "priors", Prior("priors")),
    ("12", "priors", Prior("priors")),
)


def solvers(bench: Bench, truth: dict[str, float], seeds: int, sd: float, centre: Array) -> Sheet:
    """Return rules for weak directions and the better identification, on the same readings of group 1.

    `sd`, `centre`: how well the scale's mounting is known beforehand, and where it is believed (2,) [mm].
    """
    errors = group(1, truth)
    mounted = centre + sd * np.random.default_rng(1).standard_normal((seeds, 2))
    known = dict(zip(("mx", "my"), centre.tolist(), strict=True))
    robot = dataclasses.replace(bench.robot, errors=known, tolerance=bench.robot.tolerance | {"mx": sd, "my": sd})
    done = run(bench, errors, mounted, ROUNDS, np.random.default_rng(2))
    paper = bench.home(errors, done.taken[:, -1])
    title = f"Beyond the paper: group 1, mounting known to {sd} mm, mean (5 to 95 %) over {seeds} seeds"
    sheet = Sheet("Table 3", title, ("identification", "home, mm", "of the paper's"))
    sheet.add("paper: round by round, least squares", spread(paper), "1")

    def add(name: str, left: Array) -> None:
        sheet.add(name, spread(left), f"{left.mean() / paper.mean():.3f}")

    for name, solver in RULES:
        other = run(bench, errors, mounted, ROUNDS, np.random.default_rng(2), solver=solver)
        add(f"round by round, {name}", bench.home(errors, other.taken[:, -1]))
    for model, name, solver in AT_ONCE:
        add(
            f"all rounds at once, diamond/{model}, {name}", bench.home(errors, joint(bench, done, robot, model, solver))
        )
    add("by the covariance of the fit: what noise and priors allow", attainable(bench, done, robot))
    return sheet


def boundary(step: float = 30.0) -> Array:
    """Return the 42 positions of figure 11, in their order around the workspace."""
    x, y = np.arange(-240.0, 240.0, step), np.arange(-782.0, -632.0, step)
    sides = [(v, -782.0) for v in x] + [(240.0, v) for v in y]
    sides += [(-v, -632.0) for v in x] + [(-240.0, -1414 - v) for v in y]
    return np.array([(*p, 0.0) for p in sides])


def _figure_5(bench: Bench, a: Any) -> None:
    size = np.linspace(-2, 2, 41)
    for name, unit in (("theta_1", "deg"), ("ex_1", "mm"), ("ey_1", "mm"), ("L_1", "mm"), ("l_1", "mm")):
        factor = DEG if unit == "deg" else 1.0
        home = [bench.home(DIAMOND.vector({name: v * factor}))[0] for v in size]
        a.plot(size, home, "--" if name == "L_1" else "-", label=f"{name}, {unit}")  # L_1 lies on ex_1
    a.set(xlabel="error of limb 1", ylabel="home error, mm")
    a.legend(frameon=False)


def _figure_8(bench: Bench, a: Any) -> None:
    known = dataclasses.replace(bench.robot, errors={"mx": 1.0, "my": 0.5})
    plan = planning.plan_poses(known, "diamond/4", kind="gauge", said=bench.poses.measurement, n_max=12)
    n = [step.n for step in plan.steps]
    a.plot(n, [step.condition for step in plan.steps], "o-", label="kappa_1")
    a.plot(n, [step.corrected for step in plan.steps], "x--", label="kappa_m, f - dr_M")
    a.set(xlabel="n, positions per boundary", ylabel="condition number")
    a.legend(frameon=False)


def _figure_9(groups: Groups, a: Any) -> None:
    errors, done = group(1, groups.truth), groups.runs[1, "stated"]
    for seed in range(5):
        a.plot((done.taken[seed, 1:, 0] - errors[0]) / DEG, lw=0.9, color="C0", label="" if seed else "five seeds")
    off = (done.taken[:, 1:, 0] - errors[0]).std(axis=0) / DEG
    a.plot(off, color="C1", label="standard deviation, all seeds")
    a.set(xlabel="compensations m", ylabel="error of theta_1, deg")
    a.legend(frameon=False)


def _figure_12(groups: Groups, a: Any) -> None:
    bench, truth, sd = groups.bench, groups.truth, 0.1
    p, centre, errors = boundary(), np.array([truth["mx"], truth["my"]]), group(1, truth)
    mounted = centre + sd * np.random.default_rng(1).standard_normal((groups.seeds, 2))
    done = run(bench, errors, mounted, ROUNDS, np.random.default_rng(2))
    known = dict(zip(("mx", "my"), centre.tolist(), strict=True))
    robot = dataclasses.replace(bench.robot, errors=known, tolerance=bench.robot.tolerance | {"mx": sd, "my": sd})
    best = joint(bench, done, robot, "12", Prior("priors"))
    a.plot(bench.errors_at(p, errors, np.zeros(2))[0], label="before")
    a.plot(bench.errors_at(p, errors, done.taken[:, -1]).mean(axis=0), label="paper's procedure, ten rounds")
    a.plot(bench.errors_at(p, errors, best).mean(axis=0), label="all rounds at once, priors (0.1 mm)")
    a.set(xlabel="position along the boundary", ylabel="position error, mm")
    a.set_yscale("log")
    a.legend(frameon=False)


def study(tell: Callable[[str], None], seeds: int = SEEDS) -> Iterator[Part]:
    """Yield the paper's simulated tables and figures, remade."""
    bench = Bench.of_example()
    truth = read_truth(EXAMPLES / "diamond" / "truth.toml", bench.robot).errors
    groups = Groups(bench, truth, seeds)
    yield Picture("Fig. 5", "Home error by the errors of limb 1, one at a time", partial(_figure_5, bench))
    sheet = Sheet("Fig. 8", "Condition number of the six positions", ("positions", "kappa_1", "paper: kappa_1"))
    sheet.add("n = 3", f"{observability(np.diff(_columns(bench), axis=0), 6).condition:.2f}", "475.34")
    yield sheet
    yield Picture("Fig. 8", "Condition numbers against n", partial(_figure_8, bench))
    tell(f"the six groups, {seeds} procedures each, with and without the motors' noise")
    yield groups.before()
    yield groups.after()
    yield from groups.mechanism()
    yield Picture("Fig. 9", "Group 1 with the stated noise: offset found, round by round", partial(_figure_9, groups))
    for sd, centre in ((2.0, np.zeros(2)), (0.1, np.array([1.0, 0.5]))):
        tell(f"better identifications, mounting known to {sd} mm")
        yield solvers(bench, truth, seeds, sd, centre)
    yield Picture("Fig. 12", "Group 1: errors along the boundary, mean of seeds", partial(_figure_12, groups))


def _columns(bench: Bench) -> Array:
    """Return the rows g_k (6, 4) of eq. (28), columns in mm."""
    dx = bench.sensitivity[:, :, [DIAMOND.index["theta_1"], DIAMOND.index["theta_2"]]]
    gauge, found = bench.instrument(np.zeros((1, 2))), readings(1)
    J = np.concatenate([gauge.linearise(found, bench.x, dx)[0], gauge.by_unknown(found, bench.x, (0, 1))], axis=2)
    return J[:, 0] / np.array([*[bench.robot.geometry["proximal_length"][0]] * 2, 1, 1])
