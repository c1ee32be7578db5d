"""The machine of Mei 2018 in the package: kernels, gauge, identification matrices and identification against an oracle.

The oracle is `tests.claims.independent_mei`, written from the closure alone; it decides the paper's own figures, too.
"""

from __future__ import annotations

import dataclasses
from importlib import resources
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.solvers import TSVD, LeastSquares, Prior, Ridge, Solver
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import Robot, read_robot
from deltacal_gen.identification import identifiability, identification
from deltacal_gen.machine.registry import SOLVED, UNREACHABLE, load_mechanism
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.simulation import read_truth, simulate
from deltacal_gen.planning import planning
from deltacal_gen.units import DEG
from deltacal_gen.use.prediction import predict
from derive.review.reproduction import mei as mei2018
from tests.claims import independent_mei as mei

EXAMPLE = Path(str(resources.files("deltacal_gen") / "examples/diamond"))
DIAMOND = load_mechanism("diamond")
SIX = mei.positions(3)


@pytest.fixture(scope="module")
def robot() -> Robot:
    return read_robot(EXAMPLE / "robot.toml")


@pytest.fixture(scope="module")
def poses() -> Recording:
    return read_recording(EXAMPLE / "poses.csv", DIAMOND, need_measured=False, allow_targets=True)


def errors_of(number: int, mounted: np.ndarray = mei.MOUNTED) -> dict[str, float]:
    """Source errors of a group of table 2, by name [mm, rad]."""
    actual = mei.group(number)
    limbs = (
        {
            f"theta_{i + 1}": actual.zero[i],
            f"ex_{i + 1}": actual.base[i, 0],
            f"ey_{i + 1}": actual.base[i, 1],
            f"L_{i + 1}": actual.proximal[i],
            f"l_{i + 1}": actual.distal[i],
        }
        for i in range(2)
    )
    return {k: float(v) for limb in limbs for k, v in limb.items()} | {"mx": mounted[0], "my": mounted[1]}


def as_recording(poses: Recording, done: mei.Procedure, seed: int = 0) -> Recording:
    """All rounds of the paper's procedure as one recording: joints as the controller first counted them."""
    joints = np.concatenate([mei.inverse(SIX) - taken for taken in done.compensated[seed, :-1]])
    lengths = done.lengths[seed].reshape(-1, 1)
    n = len(joints)
    return dataclasses.replace(
        poses,
        targets=None,
        joints=joints,
        measured=lengths - lengths[0],
        pose=np.arange(1, n + 1).astype(str),
        line=np.arange(2, n + 2),
        setup=np.zeros(n, dtype=int),
        measurement=dataclasses.replace(poses.measurement, sigma_mm=None),
    )


# ------------------------------------------------------------------------------------------------------------- kernels


@pytest.mark.parametrize("number", [1, 4])
def test_positions_and_columns_are_the_oracles(robot: Robot, number: int) -> None:
    rng = np.random.default_rng(number)
    p = rng.uniform((-240, -782), (240, -632), (40, 2))
    actual, errors = mei.group(number), DIAMOND.vector(errors_of(number))
    rows, none = DIAMOND.rows(robot, errors), np.zeros(3)
    q, x, status = DIAMOND.inverse(np.column_stack([p, np.zeros(40)]), none, rows)
    assert (status == SOLVED).all()
    np.testing.assert_allclose(q, mei.inverse(p, actual), rtol=0, atol=1e-12)
    np.testing.assert_allclose(x[:, :2], p, rtol=0, atol=1e-9)
    np.testing.assert_allclose(DIAMOND.forward(q, none, rows)[0][:, :2], mei.forward(q, actual), rtol=0, atol=1e-9)
    nominal = DIAMOND.rows(robot)
    q, x, _ = DIAMOND.inverse(np.column_stack([p, np.zeros(40)]), none, nominal)
    S = DIAMOND.sensitivity(x, q, none, nominal).parameters
    per_mm = S[:, :2, :10] / DIAMOND.scaling("paper", robot, [e.name for e in DIAMOND.parameters[:10]])
    np.testing.assert_allclose(per_mm, mei.transfer(p, complete=True), rtol=0, atol=1e-12)
    assert not S[:, :, 10:].any()  # the measuring mechanism moves no link


def test_home_is_level_and_no_joint_jumps(robot: Robot) -> None:
    rows, none = DIAMOND.rows(robot), np.zeros(3)
    home = DIAMOND.forward(mei.HOME[None], none, rows)[0][0]
    np.testing.assert_allclose(home, [0, -np.sqrt(825**2 - 455**2), 0, *np.eye(3).ravel()], atol=1e-9)
    along = np.column_stack([np.linspace(-240, 240, 97), np.full(97, -700.0), np.zeros(97)])
    q = DIAMOND.inverse(along, none, rows)[0]
    assert np.abs(np.diff(q, axis=0)).max() < 2 * DEG  # limb 2 passes 180 deg on the way
    assert DIAMOND.inverse(np.array([[0.0, -1300.0, 0.0]]), none, rows)[2][0] == UNREACHABLE


def test_the_remainder_of_every_column_is_of_second_order(robot: Robot) -> None:
    q, none = mei.inverse(SIX), np.zeros(3)
    x = DIAMOND.forward(q, none, DIAMOND.rows(robot))[0]
    S = DIAMOND.sensitivity(x, q, none, DIAMOND.rows(robot)).parameters
    steps = 2.0 ** -np.arange(4)
    for j, parameter in enumerate(DIAMOND.parameters[:10]):
        direction = np.eye(12)[j] * (2 * DEG if parameter.unit == "rad" else 5.0)
        rest = [
            np.abs(
                (DIAMOND.forward(q, none, DIAMOND.rows(robot, h * direction))[0] - x)[:, :2]
                - h * (S @ direction)[:, :2]
            ).max()
            for h in steps
        ]
        assert np.log2(np.divide(rest[:-1], rest[1:])).min() > 1.9, parameter.name


def test_compiled_and_plain_kernels_agree(robot: Robot) -> None:
    rng = np.random.default_rng(3)
    rows = DIAMOND.rows(robot, DIAMOND.vector(errors_of(1)))
    q, tool, n = mei.inverse(SIX) + 0.01 * rng.standard_normal((6, 2)), np.zeros((6, 3)), 6
    found = []
    for kernels in (DIAMOND.compiled, DIAMOND.vectorised):
        k, x, status = kernels.constants(rows), np.empty((n, 2)), np.empty(n, dtype=np.int64)
        kernels.forward(q, tool, k, x, status, False)
        S, V, solved = np.empty((n, 2, 16)), np.empty((n, 2, 2)), np.empty(n, dtype=np.int64)
        kernels.sensitivity(x, q, tool, k, S, V, solved)
        assert (status == SOLVED).all()
        assert (solved == SOLVED).all()
        found.append((x, S, V))
    for compiled, plain in zip(*found, strict=True):
        np.testing.assert_allclose(plain, compiled, rtol=0, atol=1e-12 * max(np.abs(compiled).max(), 1.0))


# ---------------------------------------------------------------------------------------------- the gauge, its matrices


def test_readings_are_the_oracles(robot: Robot, poses: Recording) -> None:
    """Targets of the example are those of the scale's lower joint, 51 mm above the reference point."""
    recording = simulate(robot, poses, errors_of(1))
    np.testing.assert_allclose(recording.joints, mei.inverse(SIX), rtol=0, atol=1e-12)
    length = np.linalg.norm(mei.forward(mei.inverse(SIX), mei.group(1)) - mei.MECHANISM - mei.MOUNTED, axis=1)
    np.testing.assert_allclose(recording.measured[:, 0], length - length[0], rtol=0, atol=1e-9)


def test_the_condition_number_of_the_paper(tmp_path: Path) -> None:
    """kappa_1 = 475.34, from files alone: the six positions, adjacent differences, columns of eq. (28)."""
    dc.simulate(EXAMPLE / "robot.toml", EXAMPLE / "poses.csv", output=tmp_path / "recording.csv")
    recording = tmp_path / "recording.csv"
    four = dc.matrix(EXAMPLE / "robot.toml", recording, model="diamond/4", scaling="paper")
    assert four["H"].shape == (5, 4)
    assert round(float(np.linalg.cond(four["H"])), 2) == 475.34
    np.testing.assert_allclose(four["H"], mei.identification_matrix(SIX), rtol=0, atol=1e-12)
    twelve = dc.matrix(EXAMPLE / "robot.toml", recording, model="diamond/12", scaling="paper")
    np.testing.assert_allclose(twelve["H"], mei.identification_matrix(SIX, complete=True), rtol=0, atol=1e-12)


def test_the_mechanism_where_the_robot_file_knows_it(robot: Robot, poses: Recording) -> None:
    """kappa_m: the matrix of the corrected mechanism, f = lambda - dr_M."""
    known = dataclasses.replace(robot, errors={"mx": 1.0, "my": 0.5})
    recording = simulate(robot, poses, errors_of(4))
    H = identifiability.identification_matrix(pose_problem(known, recording, DIAMOND.model("4")), "paper").H
    np.testing.assert_allclose(H, mei.identification_matrix(SIX, shift=-mei.MOUNTED), rtol=0, atol=1e-12)


def test_what_no_gauge_sees(robot: Robot, poses: Recording) -> None:
    """Nine of twelve directions: shifts of robot and mechanism together, and a turn, change no length."""
    p = np.random.default_rng(0).uniform((-240, -782), (240, -632), (40, 2))
    blank = as_recording(poses, mei.Procedure(np.zeros((1, 2, 2)), np.zeros(0), np.zeros(0), np.zeros((1, 1, 6))))
    many = dataclasses.replace(
        blank,
        joints=mei.inverse(p),
        measured=np.zeros((40, 1)),
        pose=np.arange(40).astype(str),
        line=np.arange(40),
        setup=np.zeros(40, dtype=int),
    )
    problem = pose_problem(robot, many, DIAMOND.model("12"))
    H = identifiability.identification_matrix(problem, "typical").H
    figures = identifiability.observability(H, 40)
    assert (figures.rank, figures.columns) == (9, 12)
    units = [parameter.unit for parameter in DIAMOND.parameters]
    unseen = identifiability.unseen(H / DIAMOND.typical, problem.names, units, DIAMOND.typical)
    space = np.array([[c.terms.get(name, 0.0) for name in problem.names] for c in unseen])
    shift_x = dict.fromkeys(("ex_1", "ex_2", "mx"), 1.0)
    turn = {"theta_1": 1.0, "theta_2": 1.0, "ey_1": 80.0, "ey_2": -80.0, "ex_1": -79.0, "ex_2": -79.0, "mx": 51.0}
    for direction in (shift_x, {"ey_1": 1.0, "ey_2": 1.0, "my": 1.0}, turn):
        v = DIAMOND.vector(direction) / DIAMOND.typical
        basis = np.linalg.qr((space / DIAMOND.typical).T)[0]
        np.testing.assert_allclose(basis @ (basis.T @ v), v, atol=1e-8 * np.linalg.norm(v))


def test_the_choice_of_positions(tmp_path: Path) -> None:
    """Rule (31): kappa_1 and kappa_m of n = 3 differ by less than 1 %; the six positions are the example's."""
    text = (EXAMPLE / "robot.toml").read_text() + "\n[errors]\nmx = 1.0\nmy = 0.5\n"
    (tmp_path / "robot.toml").write_text(text)
    found = dc.plan(
        tmp_path / "robot.toml", model="diamond/4", output=tmp_path / "poses.csv", gauge=EXAMPLE / "poses.toml", n_max=5
    )
    assert (found["chosen"], len(found["poses"])) == (3, 6)
    assert found["condition"] == pytest.approx([475.342, 457.808, 484.775], abs=1e-3)
    assert found["corrected"][0] == pytest.approx(472.348, abs=1e-3)
    ours, example = (
        read_recording(p, DIAMOND, need_measured=False, allow_targets=True)
        for p in (tmp_path / "poses.csv", EXAMPLE / "poses.csv")
    )
    assert ours.targets is not None
    np.testing.assert_allclose(ours.targets, example.targets, atol=1e-9)
    assert ours.measurement == example.measurement


def test_a_plan_says_what_it_needs(robot: Robot) -> None:
    with pytest.raises(UsageError, match="needs to know where its ends are mounted"):
        planning.plan_poses(robot, "4", kind="gauge")
    with pytest.raises(UsageError, match="not for a gauge"):
        dc.plan(robot, model="4", optimal=6, gauge=EXAMPLE / "poses.toml")


# ------------------------------------------------------------------------------------------------------ identification


@pytest.mark.parametrize("number", range(1, 7))
def test_errors_before_calibration(robot: Robot, number: int) -> None:
    """Tables 3 and 4, to 0.01 mm."""
    rows, none = DIAMOND.rows(robot, DIAMOND.vector(errors_of(number))), np.zeros(3)
    home = (
        DIAMOND.forward(mei.HOME[None], none, rows)[0] - DIAMOND.forward(mei.HOME[None], none, DIAMOND.rows(robot))[0]
    )
    six = DIAMOND.forward(mei.inverse(SIX), none, rows)[0][:, :2] - SIX
    assert np.linalg.norm(home) == pytest.approx(mei.BEFORE[number - 1], abs=0.01)
    assert np.linalg.norm(six, axis=1).max() == pytest.approx(mei.BEFORE_MAX[number - 1], abs=0.01)


def test_exact_readings_give_back_what_they_see(robot: Robot, poses: Recording) -> None:
    truth = errors_of(4) | {n: 0.0 for n in errors_of(4) if n[0] in "eLl"}
    recording = simulate(robot, poses, truth)
    free = dataclasses.replace(recording, measurement=dataclasses.replace(recording.measurement, sigma_mm=1e-6))
    found = identification.identify(robot, free, "diamond/4", solver="least-squares", robust=False)
    np.testing.assert_allclose(found.fit.errors, DIAMOND.vector(truth), rtol=0, atol=1e-8)
    again = predict(found.answer(), free)
    np.testing.assert_allclose(again.measured, recording.measured, rtol=0, atol=1e-8)


def test_positions_give_back_all_ten(robot: Robot) -> None:
    rng = np.random.default_rng(5)
    p = rng.uniform((-240, -782), (240, -632), (30, 2))
    truth = errors_of(1, np.zeros(2))
    csv = "x_mm,y_mm\n" + "".join(f"{x},{y}\n" for x, y in p)
    poses = _read(csv, 'kind = "position"\nframe = "robot"')
    found = identification.identify(robot, simulate(robot, poses, truth), solver="least-squares")
    assert found.model == "diamond/10"  # positions do not show the measuring mechanism
    np.testing.assert_allclose(found.fit.errors, DIAMOND.vector(truth), rtol=0, atol=1e-9)


def _read(csv: str, measurement: str) -> Recording:
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "poses.csv"
        path.write_text(csv)
        path.with_suffix(".toml").write_text(f"[measurement]\n{measurement}\n")
        return read_recording(path, DIAMOND, need_measured=False, allow_targets=True)


def test_six_positions_hardly_pin_the_offsets(robot: Robot, poses: Recording) -> None:
    """With the stated noise the weak direction of condition 475 is half prior, and its deviations say so."""
    recording = simulate(robot, poses, errors_of(1), noise_mm=0.012, rng=np.random.default_rng(0))
    found = identification.identify(robot, recording, "diamond/4")
    left = {p["name"]: p for p in found.answer()["parameters"]}
    assert all(0.3 < left[f"theta_{i}"]["std"] < 0.767 for i in (1, 2))  # deg; 0.767 is what 2 mm of the prior allow
    assert 0.8 < left["mx"]["std"] < 2.0
    assert left["my"]["std"] < 0.15
    assert abs(left["theta_1"]["value"] - 2.0) < 3 * left["theta_1"]["std"]


def test_fewer_positions_than_unknowns_are_refused(robot: Robot, poses: Recording) -> None:
    recording = simulate(robot, poses, errors_of(1))
    with pytest.raises(
        InputError, match=r"holds 4 .* diamond/4 has 4 parameters and 1 of the instrument: 5 are needed"
    ):
        identification.identify(robot, recording.subset([0, 1, 2, 3]), "diamond/4")


@pytest.fixture(scope="module")
def ten_rounds() -> mei.Procedure:
    rng = np.random.default_rng(2018)
    return mei.procedure(mei.group(1), 2.0 * rng.standard_normal((24, 2)), 10, rng, 24)


def home_errors(robot: Robot, poses: Recording, done: mei.Procedure, model: str, solver: Solver) -> np.ndarray:
    """Home errors left by identifying all rounds of each seed at once."""
    left = []
    for seed in range(len(done.lengths)):
        problem = pose_problem(robot, as_recording(poses, done, seed), DIAMOND.model(model))
        if isinstance(solver, Prior):
            sd = np.array([robot.tolerance[name] for name in problem.names])
            problem = dataclasses.replace(problem, scale=sd)
        found = fit(problem, solver, robust=False, weigh_repeats=False)
        zero = found.errors[[DIAMOND.index["theta_1"], DIAMOND.index["theta_2"]]]
        left.append(float(mei.home_error(mei.group(1), zero)))
    return np.array(left)


def test_all_rounds_at_once_with_priors_beat_the_last_round(
    robot: Robot, poses: Recording, ten_rounds: mei.Procedure
) -> None:
    """The same readings, the offset of the mechanism known to 2 mm: about a third of the error at home."""
    paper = mei.home_error(mei.group(1), ten_rounds.compensated[:, -1])
    left = home_errors(robot, poses, ten_rounds, "12", Prior("priors"))
    assert left.mean() < 0.4 * paper.mean()
    oracle, _, _ = mei.joint_identification(ten_rounds, (np.zeros(2), 2.0))
    assert left.mean() == pytest.approx(mei.home_error(mei.group(1), oracle.zero).mean(), rel=0.1)


def test_rules_for_weak_directions(robot: Robot, poses: Recording) -> None:
    """TSVD at four of four directions is least squares; none of the rules knows what a measured offset tells."""
    rng = np.random.default_rng(2019)
    done = mei.procedure(mei.group(1), mei.MOUNTED + 0.1 * rng.standard_normal((12, 2)), 10, rng, 12)
    measured = dataclasses.replace(
        robot, errors={"mx": 1.0, "my": 0.5}, tolerance=robot.tolerance | {"mx": 0.1, "my": 0.1}
    )
    left = {
        name: home_errors(measured, poses, done, "4", solver)
        for name, solver in (("least squares", LeastSquares()), ("tsvd", TSVD(4)), ("ridge", Ridge()))
    }
    np.testing.assert_allclose(left["tsvd"], left["least squares"], rtol=1e-6)
    best = home_errors(measured, poses, done, "12", Prior("priors")).mean()
    assert best < 0.5 * min(each.mean() for each in left.values())
    assert best < 0.1 * mei.home_error(mei.group(1), done.compensated[:, -1]).mean()


def test_the_procedure_of_the_benchmark_is_the_oracles() -> None:
    """Round by round, on the same draws of noise: offsets, the mechanism's errors, condition numbers."""
    bench = mei2018.Bench.of_example()
    errors = DIAMOND.vector(errors_of(1, np.zeros(2)))
    ours = mei2018.run(bench, errors, np.tile(mei.MOUNTED, (3, 1)), 4, np.random.default_rng(7))
    oracle = mei.procedure(mei.group(1), mei.MOUNTED, 4, np.random.default_rng(7), 3)
    np.testing.assert_allclose(ours.taken, oracle.compensated, rtol=0, atol=1e-9)
    np.testing.assert_allclose(ours.mechanism, oracle.mechanism, rtol=0, atol=1e-6)
    np.testing.assert_allclose(ours.condition, oracle.condition, rtol=1e-9)
    np.testing.assert_allclose(bench.home(errors, ours.taken[:, -1]), mei.home_error(mei.group(1), ours.taken[:, -1]))


def test_the_example_recording_gives_its_truth_within_its_deviations(robot: Robot) -> None:
    """Ten rounds as files: the truth lies within the deviations, which say that geometry stays with its tolerance."""
    truth = read_truth(EXAMPLE / "truth.toml", robot).errors
    found = dc.identify(EXAMPLE / "robot.toml", EXAMPLE / "recording.csv")
    assert (found["model"], found["rank"]) == ("diamond/12", 9)
    for p in found["parameters"]:
        true = truth[p["name"]] / (DEG if p["unit"] == "deg" else 1.0)
        assert abs(p["value"] - true) < 3 * p["std"], p
        assert (p["status"] == "identified") == (p["name"] in ("theta_1", "theta_2", "mx", "my")), p
    assert found["residual_sigma_mm"] == pytest.approx(0.0115, rel=0.2)
