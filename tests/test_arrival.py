"""Fits arrive, whatever the readings: near a line, in short ranges, of soft arms. Mistakes are told, not machines."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.diagnosis.library import library
from deltacal_gen.diagnosis.refits import refitted
from deltacal_gen.errors import InputError
from deltacal_gen.estimation import fit as fitting
from deltacal_gen.estimation.fit import PATIENCE, _Rows, fit, rough
from deltacal_gen.estimation.prior import BROAD, UNSAID
from deltacal_gen.estimation.problem import Problem, pose_problem
from deltacal_gen.estimation.saddles import away
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.estimation.steps import State
from deltacal_gen.estimation.turns import turned
from deltacal_gen.files.robot import Robot, read_robot, robot_from_dict
from deltacal_gen.identification.checks import plausible
from deltacal_gen.identification.identification import identify
from deltacal_gen.instrument.kind import Instrument
from deltacal_gen.instrument.kinds import readings
from deltacal_gen.machine.registry import Machine, mechanism_of
from deltacal_gen.machine.rotation import from_vector
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, blank
from deltacal_gen.units import DEG
from deltacal_gen.use.prediction import predict
from tests.benchmarks.arrival import ABOVE, chi2, compared, lowest, missed
from tests.benchmarks.arrival_problems import EXAMPLES, made, near_a_line, poses
from tests.conftest import scattered, wanted
from tests.every_effect import LIFT, chain
from tests.left_out import diagnosis, machine, record

pytestmark = pytest.mark.usefixtures("compiled")

LINKS = ((50, -90, 480, 0), (500, 0, 0, -90), (0, 90, 50, 90), (0, -90, 550, 0), (0, 90, 0, 0), (0, 0, 100, 0))
SIGMA = 0.002  # mm
YIELDS = 0.01  # mm per N: of a slide


@pytest.fixture(scope="module")
def arm() -> Robot:
    joints = [
        {"kind": "revolute", "convention": "standard", "a": a, "alpha": alpha, "d": d, "theta": theta}
        for a, alpha, d, theta in LINKS
    ]
    tool = {"tool": [-30.0, -20.0, 100.0]}
    return robot_from_dict({"robot": {"name": "arm", "mechanism": "serial"}, "joint": joints, "geometry": tool})


def unread(robot: Robot, joints: np.ndarray) -> Recording:
    """Return joints at which positions in an unknown frame are still to be read."""
    n = len(joints)
    return Recording(
        path=Path("arm"),
        kind="position",
        measurement=Measurement(kind="position", frame="unknown"),
        joint_unit=mechanism_of(robot).joint_unit,
        joints=joints,
        columns=("x_mm", "y_mm", "z_mm"),
        measured=np.full((n, 3), np.nan),
        pose=np.arange(1, n + 1).astype(str),
        line=np.arange(2, n + 2),
        channels={},
        setup=np.zeros(n, dtype=int),
        setup_names=("",),
    )


def recorded(arm: Robot, joints: np.ndarray, sag: float = 0.0, size: float = 1.0) -> Recording:
    """Return positions in an unknown frame of an arm with errors, that sinks with its reach by a part `sag` of it."""
    rng, mechanism = np.random.default_rng(3), mechanism_of(arm)
    names = mechanism.model(mechanism.full_model)
    errors = {name: float(size * mechanism.typical[mechanism.index[name]] * rng.standard_normal()) for name in names}
    here = (np.zeros(3), np.zeros(3))
    low = simulate(arm, unread(arm, joints), errors, noise_mm=SIGMA, rng=rng, frame=here)
    sunk = low.measured - np.outer(sag * np.linalg.norm(low.measured[:, :2], axis=1), [0, 0, 1.0])
    turn = np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    return dataclasses.replace(low, measured=sunk @ turn.T + [-70.0, -2900.0, 660.0])


def wide(rng: np.random.Generator, n: int, span: float) -> np.ndarray:
    return np.array([-0.7, 0.2, 1.2, 1.1, 1.2, -0.9]) + span * rng.uniform(-1, 1, (n, 6))


def test_a_trajectory_along_a_line_is_fitted_though_it_hardly_shows_the_frame(arm: Robot) -> None:
    rng = np.random.default_rng(8)
    q = near_a_line(arm, wide(rng, 150, 0.5), rng)
    problem = pose_problem(arm, recorded(arm, q), mechanism_of(arm).model("serial/dh"))
    problem = dataclasses.replace(problem, scale=BROAD * problem.scale)
    found = fit(problem, Prior(), robust=False, weigh_repeats=False)
    assert found.rms() < 1.1 * SIGMA
    assert chi2(found) < lowest(found, 2, rng) + ABOVE


def test_a_fit_of_points_on_a_line_looks_all_around_it(arm: Robot) -> None:
    """A frame that points hardly tell is turned about their line: as they lie, by no more than they are off it."""
    rng = np.random.default_rng(4)
    on_a_line, anywhere = near_a_line(arm, wide(rng, 60, 0.5), rng), wide(rng, 60, 0.5)
    for joints, starts in ((on_a_line, 3), (anywhere, 0)):
        problem = pose_problem(arm, recorded(arm, joints, size=0.1), mechanism_of(arm).model("serial/dh"))
        found = fit(problem, Prior(), instrument=problem.begin(problem.reference), robust=False, weigh_repeats=False)
        covariance = 100 * found.covariance[-6:, -6:]  # of readings ten times worse
        states = turned(problem, State(found.errors, found.instrument, found.machine), covariance)
        assert len(states) == starts
        x = found.machine.x[:, :3]
        off_line = np.linalg.svd(x - x.mean(axis=0), compute_uv=False)[1]
        for state, turn in zip(states, (90, 180, 270), strict=False):
            gap = from_vector(state.instrument.frames()[0][0]) @ from_vector(found.instrument.frames()[0][0]).T
            assert np.trace(gap) == pytest.approx(1 + 2 * np.cos(np.radians(turn)))
            left = problem.residual(state.errors, state.instrument, state.machine.x)
            assert np.linalg.norm(left) < 3 * off_line


def slide(rng: np.random.Generator) -> tuple[Problem, Problem]:
    """Return the problems, at rest and with its yielding slide, of an arm that slides level but for a tilted axis.

    The slide feels nothing of gravity as it is drawn, and in a frame that nobody knows nothing else shows the tilt.
    """
    joints = [
        {"kind": kind, "convention": "modified", "alpha": alpha, "a": 0.0, "d": 0.0, "theta": 0.0}
        for kind, alpha in (("revolute", 0.0), ("prismatic", 90.0), ("revolute", -90.0))
    ]
    weights = [
        {"mass": m, "com": c} for m, c in ((9.0, [0.0, 0.0, 0.0]), (11.0, [30.0, 10.0, 90.0]), (3.0, [0, 50, 90]))
    ]
    head = {"robot": {"name": "slide", "mechanism": "serial"}, "geometry": {"tool": [55.0, -60.0, -70.0]}}
    slides = robot_from_dict(head | {"joint": [j | w for j, w in zip(joints, weights, strict=True)]})
    q = np.array([2.5, 150.0, 0.8]) * rng.uniform(-1, 1, (40, 3))
    yields = blank("joint_compliance", (2,)).with_values(np.full((1, 1), YIELDS))
    mechanism = mechanism_of(slides)
    found = simulate(slides, unread(slides, q), {"alpha_1": 0.02}, noise_mm=SIGMA, rng=rng, terms=[yields])
    free = pose_problem(slides, found, mechanism.model(mechanism.full_model))
    free = dataclasses.replace(free, scale=BROAD * free.scale)
    return free, free.with_terms([yields.with_values(np.zeros((1, 1)))], np.array([10 * YIELDS]))


def test_a_fit_leaves_the_saddle_that_it_begins_on() -> None:
    """What a tilt and a compliance do together shows in no derivative where both are nothing."""
    stiff, yielding = slide(np.random.default_rng(4))
    first = fit(stiff, Prior(), robust=False, weigh_repeats=False)
    found = fit(
        yielding,
        Prior(),
        errors=np.append(first.errors, 0.0),
        instrument=first.instrument,
        robust=False,
        weigh_repeats=False,
    )
    assert first.rms() > 3 * SIGMA
    assert found.rms() < 1.2 * SIGMA
    assert found.parameters["alpha_1"] * found.errors[-1] == pytest.approx(0.02 * YIELDS, rel=0.05)
    assert not away(found)


def test_a_reading_that_is_now_gross_and_now_not_counts_in_the_end(arm: Robot) -> None:
    """Without it the noise is so small that it is gross, and with it so large that it is not: neither would end."""
    rng = np.random.default_rng(2)
    problem = pose_problem(arm, recorded(arm, wide(rng, 30, 0.5)), mechanism_of(arm).model("serial/dh"))
    rows = _Rows(problem, problem.begin(problem.reference), True, None, False, True)
    quiet = rng.standard_normal((30, 3))
    gross, not_quite = quiet.copy(), quiet.copy()
    gross[4], not_quite[4] = 30.0, 4.0
    for iteration in (PATIENCE - 3, PATIENCE - 2, PATIENCE - 1, PATIENCE):
        rows.weigh(gross if iteration % 2 else not_quite, iteration, 3)
        assert (rows.weights[4] == 0) == (iteration % 2 == 1 and iteration < PATIENCE)
    rows.weigh(gross, PATIENCE + 1, 3)
    assert 0 < rows.weights[4] < 0.2
    assert (np.delete(rows.weights, 4) > 0.5).all()


def test_a_reflector_that_nobody_wrote_down_is_no_nonsense(arm: Robot) -> None:
    """A robot file without a tool point, a reflector at 200 mm, short joint ranges: the check knows no tool either."""
    rng = np.random.default_rng(6)
    long = dataclasses.replace(arm, tool=np.array([150.0, -120.0, 60.0]))
    read = recorded(long, wide(rng, 40, 0.15))
    assert identify(dataclasses.replace(arm, tool=np.zeros(3)), read).fit.rms() < 2 * SIGMA


LOUD = 0.05  # mm: noise beside which a step at fixed loads seems to arrive


def softened(arm: Robot, rng: np.random.Generator, more: tuple[Term, ...] = ()) -> Problem:
    """Return the problem of an arm whose joints 2 and 3 yield by one degree at 100 Nm, an unknown size."""
    mass = {"mass": 20.0, "com": [-100.0, 0.0, 0.0]}
    joints = [
        {"kind": "revolute", "convention": "standard", "a": a, "alpha": alpha, "d": d, "theta": theta} | mass
        for a, alpha, d, theta in LINKS
    ]
    head = {"robot": {"name": "soft", "mechanism": "serial"}, "geometry": {"tool": [0.0, 0.0, 100.0]}}
    soft = robot_from_dict(head | {"joint": joints})
    ripple = Term("transmission_eccentricity", (2,), np.full((1, 2), 1e-3), (1.0,))
    spring = blank("joint_compliance", (2, 3)).with_values(np.full((2, 1), 1e-5 * DEG))  # rad per N mm
    tilt = blank("joint_tilt_compliance", (1, 2)).with_values(np.full((2, 2), 3e-7 * DEG))
    free = mechanism_of(soft).model("serial/dh")
    problem = pose_problem(soft, recorded(arm, wide(rng, 30, 1.0)), free, held=[tilt, *more])
    return problem.with_terms([spring, ripple], np.array([1e-7, 1e-7, 1e-3, 1e-3]))


def differences(problem: Problem, errors: np.ndarray, instrument: Instrument) -> np.ndarray:
    """Return the derivatives (R, k, n) of the readings by free parameters, of machines solved anew."""
    out = []
    for column, size in zip(problem.columns, 1e-2 * problem.scale, strict=True):
        moved = np.stack([errors, errors])
        moved[:, column] += size, -size
        there, back = (problem.residual(at, instrument, problem.solve(at).x) for at in moved)
        out.append((back - there) / (2 * size))
    return np.stack(out, axis=2)


BASE = blank("base_compliance", ()).with_values(np.array([[4e-7, 7e-7]]) * DEG)  # rad per N mm


@pytest.mark.parametrize(("more", "kind"), [((), "position"), ((BASE,), "position"), ((BASE,), "distance")])
def test_loads_follow_a_soft_arm(arm: Robot, more: tuple[Term, ...], kind: str) -> None:
    """One degree at 100 Nm: derivatives at fixed loads are wrong by parts, those that follow the loads are not.

    A base that leans by the weight on it is the one thing by which a turn of the first joint changes a distance.
    """
    problem = softened(arm, np.random.default_rng(5), more)
    if kind == "distance":
        problem = dataclasses.replace(problem, readings=readings(problem.recording, as_distance=True))
    assert problem.gives_way
    coefficients = [t.values.ravel() for t in problem.terms]
    errors = np.concatenate([problem.reference[:-4], *coefficients])
    machine = problem.solve(errors)
    instrument = problem.begin(errors, machine)
    fixed = problem.linearise(errors, instrument, machine).J_p
    felt = problem.followed(errors, instrument, machine)
    true = differences(problem, errors, instrument)
    size = np.linalg.norm(true, axis=(0, 1))
    assert np.max(np.linalg.norm(true - fixed, axis=(0, 1)) / size) > 0.02
    assert np.max(np.linalg.norm(true - fixed - felt, axis=(0, 1)) / size) < 2e-4


@pytest.mark.parametrize("name", ["bed_shape", "instrument_scale"])
def test_what_is_added_to_readings_follows_them(name: str) -> None:
    """A bed is as high as it is where the nozzle stands: fits of heights beside a warped one ended 1.1 of chi2 high."""
    rng, printer = np.random.default_rng(3), read_robot(EXAMPLES / "linear_delta" / "robot.toml")
    kind = "height" if name == "bed_shape" else "position"
    empty = made(printer, poses(printer, rng, 30), rng, kind, "robot")
    names = mechanism_of(printer).model(mechanism_of(printer).full_model)
    problem = pose_problem(printer, simulate(printer, empty), names)
    term = next(t for t in library(problem)[0] if t.effect == name)
    machine, instrument = problem.solve(problem.reference), problem.begin(problem.reference)
    columns = problem.term_columns([term], problem.reference, instrument, machine)
    sizes = 2.0 / np.abs(columns).max(axis=(0, 1))  # mm
    problem = dataclasses.replace(problem, held=(term.with_values(sizes.reshape(term.values.shape)),))
    found = problem.linearise(problem.reference, instrument, machine).J_p
    true = differences(problem, problem.reference, instrument)
    size = np.linalg.norm(true, axis=(0, 1))
    assert np.max(np.linalg.norm(true - found, axis=(0, 1)) / size) < 1e-5
    assert not problem.gives_way


def test_a_fit_of_a_soft_arm_ends_where_no_other_optimiser_finds_less(arm: Robot) -> None:
    """Where derivatives at fixed loads see nothing to be gained, those that follow the loads still do."""
    rng = np.random.default_rng(2)
    problem = softened(arm, rng)
    errors = np.concatenate([problem.reference[:-4], *(t.values.ravel() for t in problem.terms)])
    errors[problem.columns] += 0.1 * problem.scale * rng.standard_normal(len(problem.scale))
    low = problem.recording
    read = problem.poses(errors)[:, :3] + LOUD * rng.standard_normal((low.n_rows, 3))
    low = dataclasses.replace(low, measured=read, measurement=dataclasses.replace(low.measurement, frame="robot"))
    own = pose_problem(problem.robot, low, problem.names, held=problem.held)
    own = own.with_terms(problem.terms, problem.scale[-4:])
    found = fit(own, Prior(), robust=False, weigh_repeats=False)
    assert found.rms() < LOUD
    assert chi2(found) < lowest(found, 1, rng) + ABOVE


@pytest.mark.parametrize("number", [0, *(pytest.param(k, marks=pytest.mark.thorough) for k in range(1, 20))])
def test_fits_of_drawn_machines_arrive_where_another_optimiser_does(number: int) -> None:
    line = compared(11, number, starts=3)
    assert not missed(line), line


@pytest.mark.parametrize("number", [149, 438, 502])
def test_fits_that_once_ended_above_the_lowest_place_arrive(number: int) -> None:
    """By 1 to 6 of chi2: of a base that leans, and of derivatives that followed loads far from where it ended."""
    line = compared(20261126, number, starts=1)
    assert not missed(line), line


def test_distances_that_begin_elsewhere_arrive_from_the_drawing() -> None:
    """An arm of 88 poses, begun three ordinary errors off its drawing, ended 900 of chi2 above."""
    line = compared(20281129, 453, starts=2)
    assert not missed(line), line


@pytest.mark.parametrize(
    ("seed", "number"),
    [
        (20281131, 1464),
        (20281133, 9),
        (20281134, 1015),
        *(pytest.param(20281131, k, marks=pytest.mark.thorough) for k in (918, 978, 1139, 1886)),
        pytest.param(20281129, 679, marks=pytest.mark.thorough),
        pytest.param(20281130, 85, marks=pytest.mark.thorough),
    ],
)
def test_a_fit_that_the_drawing_did_not_foresee_begins_on_its_other_side_too(seed: int, number: int) -> None:
    """Begun at the drawing or anywhere near its end, an arm ended above: by distances 12.6 of chi2, 19.7 by points.

    So did a Delta beside a correction, by 19.5, which begins where geometry alone ended, and an arm by touches, by 30:
    what it left at first was taken for noise. One by distances had three low places in directions that the drawing
    saw, .6 of what it leaves open from it; one was of effects; and a Delta came back that began too near the drawing.
    """
    line = compared(seed, number, starts=4)
    assert not missed(line), line


def test_a_valley_flatter_than_the_linear_machine_is_followed_to_its_end() -> None:
    """Each of its steps covered a twentieth of the way: after 30 of them .85 of chi2 was left."""
    line = compared(20281129, 566, starts=1)
    assert not missed(line), line
    assert line["iterations"] < PATIENCE


def test_a_coefficient_that_bears_nothing_asks_for_no_saddle(arm: Robot) -> None:
    """No weight turns a joint about the vertical: each fit of a search with its compliance looked aside in vain."""
    problem = softened(arm, np.random.default_rng(5))
    first = fit(problem.with_terms([], np.ones(0)), Prior(), must_converge=False)
    found = refitted(first.problem, first, [blank("joint_compliance", (1, 2))])
    assert found is not None
    of_first, of_second = np.diag(found.solution.covariance)[-2:]
    assert of_second < 0.5 < 0.99 < of_first
    assert not found.unseen.any()


def test_a_soft_arm_is_no_mistake(arm: Robot) -> None:
    """One per cent of its reach: nothing is refused, and no order of the joints is tried that nobody would make."""
    q = wide(np.random.default_rng(2), 120, 1.2)
    first = rough(pose_problem(arm, recorded(arm, q, sag=0.05), ()), must_converge=False)
    assert np.median(np.linalg.norm(first.residual, axis=1)) > 5
    plausible(first)


MISTAKES = {
    "the columns of joints 2 and 3 are exchanged": lambda r: r.joints[:, [0, 2, 1, 3, 4, 5]],
    "joint 4 counts the other way": lambda r: r.joints * [1, 1, 1, -1, 1, 1],
    "the zero of joint 3 is off by 90 deg": lambda r: r.joints - np.radians([0, 0, 90, 0, 0, 0]),
    "the zeros of all joints are off by 90 deg": lambda r: r.joints - np.radians(90),
    "the joints are in radians": lambda r: np.radians(r.joints),
    "joint 3 counts from a line that stays as joint 2 turns .page arm: coupling = {2 = -1.0}": lambda r: (
        r.joints + r.joints[:, [1]] * [0, 0, 1, 0, 0, 0]
    ),
}


@pytest.mark.parametrize("words", MISTAKES)
def test_a_mistake_in_the_joints_is_named(arm: Robot, words: str) -> None:
    good = recorded(arm, wide(np.random.default_rng(2), 120, 1.2), size=0.3)
    wrong = dataclasses.replace(good, joints=MISTAKES[words](good))
    with pytest.raises(InputError, match="agree with it if .*" + words):
        plausible(rough(pose_problem(arm, wrong, ()), must_converge=False))


@pytest.mark.parametrize("words", ["the columns of joints 2 and 3 are exchanged", "joint 4 counts the other way"])
def test_of_a_poor_machine_that_is_refused_the_mistakes_are_told_with_which_it_would_not_be(
    arm: Robot, words: str
) -> None:
    """It leaves a tenth of what they move whatever is put right: nothing was named, and all had to be compared."""
    poor = recorded(arm, wide(np.random.default_rng(2), 120, 0.6), sag=0.3)
    plausible(rough(pose_problem(arm, poor, ()), must_converge=False))
    wrong = dataclasses.replace(poor, joints=MISTAKES[words](poor))
    with pytest.raises(InputError, match="more than any error of its parts. They would be .* mm off if .*" + words):
        plausible(rough(pose_problem(arm, wrong, ()), must_converge=False))


def test_poses_the_other_way_round_are_named(arm: Robot) -> None:
    """What a camera in the hand tells of a board is where the board is, not where the hand is."""
    rng = np.random.default_rng(2)
    poses = dataclasses.replace(wanted(np.zeros((20, 3)), "pose"), joints=wide(rng, 20, 0.8), targets=None)
    frame = (np.array([0.4, -0.2, 2.0]), np.array([500.0, -80.0, 900.0]))
    good = simulate(arm, poses, {}, noise_mm=SIGMA, noise_rad=1e-4, rng=rng, frame=frame)
    plausible(rough(pose_problem(arm, good, ()), must_converge=False))
    back = np.swapaxes(from_vector(good.measured[:, 3:]), 1, 2)
    there = -np.einsum("rij,rj->ri", back, good.measured[:, :3])
    wrong = dataclasses.replace(good, measured=np.hstack([there, -good.measured[:, 3:]]))
    with pytest.raises(InputError, match=r"agree with it if .*each pose is the inverse"):
        plausible(rough(pose_problem(arm, wrong, ()), must_converge=False))


def test_readings_of_the_next_row_are_named_and_a_coupled_joint_though_the_tool_is_not_said(arm: Robot) -> None:
    good = recorded(arm, wide(np.random.default_rng(2), 120, 1.2), size=0.3)
    wrong = dataclasses.replace(good, measured=np.roll(good.measured, 1, axis=0))
    with pytest.raises(InputError, match=r"agree with it if .*shifted against the joints by one row"):
        plausible(rough(pose_problem(arm, wrong, ()), must_converge=False))
    wrong = dataclasses.replace(good, joints=good.joints - good.joints[:, [1]] * [0, 0, 1, 0, 0, 0])
    untold = dataclasses.replace(arm, tool=np.zeros(3))
    with pytest.raises(InputError, match=r"agree with it if .*joint 3 counts .* coupling = \{2 = 1\.0\}"):
        plausible(rough(pose_problem(untold, wrong, ()), must_converge=False))


def test_a_coupled_joint_is_named_though_joints_hardly_turn_and_the_tool_is_long_and_not_said(arm: Robot) -> None:
    """A point half a metre from where the file has it is off by more than the mistake, until it is found."""
    rng = np.random.default_rng(3)
    q = np.radians([-35.0, -38.0, 5.0, 2.0, -56.0, -33.0]) + np.radians([1, 5, 25, 1, 1, 1]) * wide(rng, 90, 1.0)
    long = dataclasses.replace(arm, tool=np.array([0.0, -400.0, 0.0]))
    good = recorded(long, q, size=0.3)
    wrong = dataclasses.replace(good, joints=good.joints - good.joints[:, [1]] * [0, 0, 1, 0, 0, 0])
    untold = dataclasses.replace(arm, tool=np.zeros(3))
    with pytest.raises(InputError, match=r"agree with it if joint 3 counts .* coupling = \{2 = 1\.0\}"):
        plausible(rough(pose_problem(untold, wrong, ()), must_converge=False))


def test_radians_are_named_of_a_chain_that_slides_too() -> None:
    lift = chain(LIFT)
    q = wide(np.random.default_rng(2), 60, 1.0)[:, :4] * [200.0, 1.0, 1.0, 1.0]
    good = recorded(lift, q, size=0.3)
    wrong = dataclasses.replace(good, joints=good.joints * [1.0, *np.radians([1.0] * 3)])
    with pytest.raises(InputError, match=r"agree with it if .*the joints are in radians"):
        plausible(rough(pose_problem(lift, wrong, ()), must_converge=False))


def test_rows_that_are_off_together_are_no_single_cells(arm: Robot) -> None:
    problem = pose_problem(arm, recorded(arm, wide(np.random.default_rng(2), 30, 1.0)), ())
    off = np.full((30, 3), 0.1)
    off[4] = 100.0
    with pytest.raises(InputError, match=r"line 6: .* of this row, or remove it"):
        fitting._blame(problem, off)
    off[10:14] = 90.0
    with pytest.raises(
        InputError, match=r"5 readings are so far off: lines 6, 12, 13, 14, 15\. .* where a joint moves"
    ):
        fitting._blame(problem, off)


def test_a_left_handed_frame_and_inches_are_named(arm: Robot) -> None:
    good = recorded(arm, wide(np.random.default_rng(2), 120, 1.2), size=0.3)
    for words, measured in (
        ("the instrument's frame is left-handed", good.measured * [-1, 1, 1]),
        ("all positions are in inches", good.measured / 25.4),
    ):
        wrong = dataclasses.replace(good, measured=measured)
        with pytest.raises(InputError, match="agree with it if .*" + words):
            plausible(rough(pose_problem(arm, wrong, ()), must_converge=False))


def test_a_fit_that_takes_a_quarter_turn_for_an_encoder_offset_says_so(robot: Robot, mechanism: Machine) -> None:
    good = simulate(robot, wanted(scattered(robot, 40, 4)), {}, noise_mm=0.01, rng=np.random.default_rng(1))
    wrong = dataclasses.replace(good, joints=good.joints + np.radians([0, 90, 0]))
    with pytest.raises(InputError, match="theta_2 = -90 deg"):
        plausible(rough(pose_problem(robot, wrong, ()), must_converge=False))
    said = dataclasses.replace(robot, errors={"theta_2": -np.pi / 2})
    plausible(rough(pose_problem(said, wrong, ()), must_converge=False))


def test_readings_in_another_order_are_refused(arm: Robot) -> None:
    good = recorded(arm, wide(np.random.default_rng(2), 120, 1.2), size=0.3)
    shuffled = dataclasses.replace(good, measured=np.random.default_rng(1).permutation(good.measured))
    with pytest.raises(InputError, match="more than any error of its parts"):
        plausible(rough(pose_problem(arm, shuffled, ()), must_converge=False))


def test_a_machine_farther_off_than_drawings_leave_open_is_doubted() -> None:
    robot = machine()
    readings = record(robot, errors={"L_1": 15.0, "l_2": -12.0, "theta_3": 4 * DEG, "ex_2": 0.3})
    [doubt] = identify(robot, readings).answer().doubts or ()
    assert "L_1 by +1" in doubt
    assert "theta_3" not in doubt  # encoders are often so far off
    assert f"But {doubt}" in diagnosis(robot, readings).summary
    rough_drawing = machine(tolerance={f"{letter}_{limb}": 20.0 for letter in "Ll" for limb in (1, 2, 3)})
    assert identify(rough_drawing, readings).answer().doubts is None
    assert identify(robot, record(robot)).answer().doubts is None


def test_a_reflector_of_which_the_robot_file_says_nothing_is_found_where_it_sits(arm: Robot) -> None:
    """A tool point of zeros is one that nobody has written down: no part of the machine is off for it."""
    readings = recorded(arm, wide(np.random.default_rng(2), 60, 1.2), size=0.1)
    bare = dataclasses.replace(arm, tool=np.zeros(3))
    answers = {known: identify(robot, readings).answer() for known, robot in (("said", arm), ("unsaid", bare))}
    found = {known: {p.name: p for p in answer.parameters} for known, answer in answers.items()}
    assert answers["unsaid"].doubts is None
    assert answers["unsaid"].train_rms_mm < 3 * SIGMA
    said, unsaid = found["said"], found["unsaid"]
    for name in ("a_2", "a_3", "alpha_4", "theta_3", "d_4"):
        assert abs(unsaid[name].value - said[name].value) < 2 * (said[name].std or 0.0)
    # along x and y of the last link it sits where it is, but for the zero of the last joint, which nothing else reads
    radius = np.hypot(unsaid["tx"].value, unsaid["ty"].value)
    assert radius == pytest.approx(np.hypot(-30.0 + said["tx"].value, -20.0 + said["ty"].value), abs=0.1)


def test_beside_effects_a_tool_point_that_nobody_wrote_down_is_as_open(arm: Robot) -> None:
    readings = recorded(arm, wide(np.random.default_rng(2), 30, 1.2), size=0.1)
    bare = dataclasses.replace(arm, tool=np.zeros(3))
    said, unsaid = (diagnose(robot, readings).baseline.problem for robot in (arm, bare))
    tool = [said.names.index(name) for name in ("tx", "ty", "tz")]
    assert (unsaid.scale[tool] == UNSAID).all()
    assert (said.scale[tool] < UNSAID / 10).all()
    assert np.delete(unsaid.scale, tool) == pytest.approx(np.delete(said.scale, tool))


def test_a_tool_point_that_is_said_is_believed_as_other_parts_are(arm: Robot) -> None:
    readings = recorded(arm, wide(np.random.default_rng(2), 60, 1.2), size=0.1)
    wrong = dataclasses.replace(arm, tool=arm.tool + np.array([0.0, 200.0, 0.0]))
    [doubt] = identify(wrong, readings).answer().doubts or ()
    assert "ty by -" in doubt or "tx by" in doubt


def test_a_reflector_that_was_knocked_for_a_while_is_left_out_and_told(arm: Robot) -> None:
    """A seventh of the rows, centimetres off with the others before and behind, was noise of the rest that wanders."""
    readings = recorded(arm, wide(np.random.default_rng(2), 60, 1.2), size=0.1)
    knocked = dataclasses.replace(readings, measured=readings.measured.copy())
    knocked.measured[20:29] += [30.0, -20.0, 15.0]
    answer, found = identify(arm, knocked).answer(), diagnose(arm, knocked).answer()
    assert answer.gross_errors == found.gross_errors == tuple(range(22, 31))
    assert answer.train_rms_mm < 1.5 * SIGMA
    assert (found.verdict, found.effects) == ("adequate", ())
    assert "9 readings are far beyond all others together and were left out (lines 22, 23," in found.summary
    for known in (answer, found):
        assert np.sqrt(np.mean((predict(known, readings).measured - readings.measured) ** 2)) < 2 * SIGMA


@pytest.mark.parametrize(("poses", "wrong", "other"), [(12, 3, 9), (14, 0, 2)])
def test_of_few_poses_one_with_cells_of_another_is_left_out_and_told(
    arm: Robot, poses: int, wrong: int, other: int
) -> None:
    """It pulled the machine by centimetres, stood out of nothing, and the zero of a joint or nonsense was told."""
    readings = recorded(arm, wide(np.random.default_rng(100 * poses + (poses == 12)), poses, 1.2), size=0.1)
    copied = dataclasses.replace(readings, measured=readings.measured.copy())
    copied.measured[wrong] = copied.measured[other]
    bare = dataclasses.replace(arm, tool=np.zeros(3))
    enough = poses == 14
    found = [identify(bare, copied).answer(), *([diagnose(bare, copied).answer()] if enough else [])]
    assert {known.gross_errors for known in found} == {(wrong + 2,)}
    for known in found:
        off = predict(known, readings).measured - readings.measured
        assert np.sqrt(np.mean(np.delete(off, wrong, axis=0) ** 2)) < 3 * SIGMA
    assert "joints of another pose" in (found[0].doubts or ("",))[0]


def test_a_slip_is_no_reflector_that_was_knocked(arm: Robot) -> None:
    readings = recorded(arm, wide(np.random.default_rng(2), 60, 1.2), size=0.1)
    slipped = dataclasses.replace(readings, measured=readings.measured.copy())
    slipped.measured[51:] += [30.0, -20.0, 15.0]
    [effect] = diagnose(arm, slipped).answer().effects
    assert effect.name in ("instrument_slip", "tool_slip")


def test_a_tracker_that_lost_its_target_is_told_by_lines(arm: Robot) -> None:
    """Its last reading written on for a quarter of the rows is no machine's; with these cells blank the rest is."""
    readings = recorded(arm, wide(np.random.default_rng(2), 60, 1.2), size=0.1)
    stuck, blanked = readings.measured.copy(), readings.measured.copy()
    stuck[45:], blanked[45:] = stuck[44], np.nan
    with pytest.raises(InputError, match=r"15 readings are the one before .* in lines 46 to 61\)"):
        identify(arm, dataclasses.replace(readings, measured=stuck))
    assert identify(arm, dataclasses.replace(readings, measured=blanked)).answer().train_rms_mm < 3 * SIGMA


def test_joints_that_were_logged_of_another_machine_are_told(arm: Robot) -> None:
    """They stand, but for a count of their encoders, while what is read moves."""
    rng = np.random.default_rng(2)
    readings = recorded(arm, wide(rng, 60, 1.2), size=0.1)
    still = readings.joints[0] + 1e-6 * rng.standard_normal(readings.joints.shape)
    with pytest.raises(InputError, match=r"spread over \d+ mm, yet at the joints .* no more than 0\.00\d+ mm"):
        identify(arm, dataclasses.replace(readings, joints=still))


@pytest.mark.parametrize(("longer", "declared"), [(129.0, True), (129.0, False), (160.0, True)])
def test_a_machine_of_other_lengths_is_fitted_and_told_instead_of_noise_of_millimetres(
    longer: float, declared: bool
) -> None:
    """Rods a decimetre longer than drawn are less credible than such noise, to a fit whose noise is open."""
    robot = machine()
    readings = record(robot, errors={f"l_{limb}": longer for limb in (1, 2, 3)}, declared=declared)
    answer = identify(robot, readings).answer()
    [doubt] = answer.doubts or ()
    assert f"l_1 by +{longer:.0f} mm" in doubt
    assert answer.train_rms_mm < 0.02
    found = diagnosis(robot, readings)
    assert (found.verdict, found.effects, found.laws) == ("adequate", (), ())
    assert f"l_1 by +{longer:.0f} mm" in found.summary


def test_no_other_machine_stands_for_physics_or_gross_errors() -> None:
    robot = machine()
    readings = record(robot, blank("joint_compliance", (1, 2, 3)).with_values(np.full((3, 1), 3e-5)), declared=True)
    assert identify(robot, readings).answer().doubts is None
    some = record(robot)
    some.measured[::30] += 40.0
    assert identify(robot, some).answer().doubts is None


def test_a_second_reference_point_of_an_arm_is_as_far_as_a_hand_holds_it(arm: Robot) -> None:
    """It was a part of the first link's twist, which of an arm is no length."""
    readings = recorded(arm, wide(np.random.default_rng(2), 60, 1.2), size=0.1)
    proposed = identify(arm, readings).answer().next_measurements
    points = [idea for idea in proposed if "reference point" in idea.measurement]
    assert points
    assert all("100 mm beside the first" in idea.measurement for idea in points)


def test_points_that_are_read_at_a_pose_already_are_no_idea(arm: Robot) -> None:
    """Three reflectors tell rotations: what they leave open no fourth would pin, nor the rotation itself."""
    rng = np.random.default_rng(2)
    joints = np.repeat(wide(rng, 20, 0.6), 3, axis=0)
    asked = dataclasses.replace(
        unread(arm, joints), tool=np.tile([[0, 0, 120.0], [100, 0, 120], [0, 100, 120]], (20, 1))
    )
    readings = simulate(arm, asked, {}, noise_mm=0.1, rng=rng, frame=(np.ones(3), np.ones(3)))
    proposed = identify(arm, readings).answer().next_measurements
    assert not any("reference point" in idea.measurement or "rotation" in idea.measurement for idea in proposed)
