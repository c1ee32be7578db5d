"""Fits arrive, whatever the readings: near a line, in short ranges, of soft arms. Mistakes are told, not machines."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from deltacal_gen.diagnosis.library import library
from deltacal_gen.diagnosis.refits import refitted
from deltacal_gen.estimation.fit import PATIENCE, _Rows, fit
from deltacal_gen.estimation.prior import BROAD
from deltacal_gen.estimation.problem import Problem, State, pose_problem
from deltacal_gen.estimation.saddles import away
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.estimation.turns import turned
from deltacal_gen.files.robot import Robot, read_robot, robot_from_dict
from deltacal_gen.identification.identification import identify
from deltacal_gen.inference.least_squares import Status
from deltacal_gen.instrument.kind import Instrument
from deltacal_gen.instrument.kinds import readings
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.machine.rotation import from_vector
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, blank
from deltacal_gen.units import DEG
from tests.benchmarks.arrival import ABOVE, chi2, compared, lowest, missed
from tests.benchmarks.arrival_problems import EXAMPLES, made, near_a_line, poses
from tests.support.six_joints import LINKS, SIGMA, recorded, six_joints, unread, wide

pytestmark = pytest.mark.usefixtures("compiled")

YIELDS = 0.01  # mm per N: of a slide


@pytest.fixture(scope="module")
def arm() -> Robot:
    return six_joints()


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


@pytest.mark.walk
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


def test_a_fit_that_did_not_converge_says_so_in_the_answer(arm: Robot) -> None:
    rng = np.random.default_rng(2)
    read = recorded(arm, wide(rng, 40, 0.5))
    found = identify(arm, read)
    assert found.fit.status is Status.CONVERGED
    assert found.answer().doubts is None
    promised = [*found.fit.history, 3.0]
    short = dataclasses.replace(found.fit, status=Status.ITERATIONS, history=promised)
    (doubt,) = dataclasses.replace(found, fit=short).answer().doubts or ()
    assert f"did not converge (iterations after {len(promised)} iterations)" in doubt
