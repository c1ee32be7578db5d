"""Measuring poses: the paper's rings and rule, D-optimal sets, ranks, and what is written for the user."""

from __future__ import annotations

import dataclasses
import itertools
import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.errors import InputError, NoSolutionError, UsageError
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import Robot, read_robot, robot_from_dict
from deltacal_gen.identification.accuracy import joint_spread
from deltacal_gen.identification.identifiability import identification_matrix
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.registry import SOLVED, load_mechanism, mechanism_of
from deltacal_gen.machine.values import Measurement
from deltacal_gen.pages.plans import write
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.planning import matrix, optimal, planning, reach, singularities, targets
from deltacal_gen.units import DEG
from tests.support.planned import design, log_determinant, rank_table

pytestmark = pytest.mark.usefixtures("compiled")

B, A = 200.0, 51.0  # mm: radii of base and platform (Bai 2015, Table 1)
TABLES: dict[str, Any] = {
    "robot": {"mechanism": "delta"},
    "geometry": {
        "base_radius": B,
        "platform_radius": A,
        "proximal_length": 375.0,
        "distal_length": 950.0,
        "joint_spacing": 100.0,
    },
    "workspace": {"top": 728.0, "radius": 500.0, "height": 250.0},
}
DELTA = load_mechanism("delta")


@pytest.fixture(scope="module")
def robot() -> Robot:
    return robot_from_dict(TABLES)


def steps(plan: matrix.Plan, field: str) -> dict[int, Any]:
    return {step.n: getattr(step, field) for step in plan.steps}


# ------------------------------------------------------------------------------------------------------ sets of poses


def test_rings_are_the_papers(robot: Robot) -> None:
    assert robot.workspace is not None
    rough = targets.rings(robot.workspace, 5, targets.ROUGH)
    fine = targets.rings(robot.workspace, 7, targets.FINE, start_angle=0.3)
    assert len(rough) == 5 + 1
    assert len(fine) == 2 * 7 + 1
    np.testing.assert_allclose(fine[0], [0, 0, -853])
    np.testing.assert_allclose(fine[1], [500 * np.cos(0.3), 500 * np.sin(0.3), -728])
    np.testing.assert_allclose(np.hypot(*fine[1:, :2].T), 500)
    assert sorted(set(fine[1:, 2])) == [-978, -728]
    gaps = np.linalg.norm(np.diff(np.vstack([rough[1:], rough[1]]), axis=0), axis=1)
    np.testing.assert_allclose(gaps, 2 * 500 * np.sin(np.pi / 5))


@pytest.mark.parametrize("kind", ["distance", "position"])
def test_design_is_the_matrix_of_the_recording_that_follows(robot: Robot, kind: str, tmp_path: Path) -> None:
    known = dataclasses.replace(robot, errors={"theta_2": 0.8 * DEG, "L_1": 0.3, "dl_3": 0.2})
    found = planning.plan_poses(known, "32", kind=kind, n_max=3)
    planning.write_targets(found, tmp_path / "poses.csv")
    poses = read_recording(tmp_path / "poses.csv", DELTA, need_measured=False, allow_targets=True)
    measured = simulate(known, poses, rng=np.random.default_rng(1))
    problem = pose_problem(known, measured, found.names, as_distance=kind == "distance")
    H = identification_matrix(problem, "typical").H
    targets = found.poses.targets[: len(found.poses) // 2]
    ours = design(known, targets, found.tools, found.names, kind) * problem.scale
    np.testing.assert_allclose(ours.T @ ours, H.T @ H, rtol=0, atol=1e-8 * np.linalg.norm(H) ** 2)
    if kind == "distance":
        np.testing.assert_allclose(ours, H, rtol=0, atol=1e-8)


def test_targets_written_are_reached_by_simulation(robot: Robot, tmp_path: Path) -> None:
    found = planning.plan_poses(robot, "32", n_max=4)
    planning.write_targets(found, tmp_path / "poses.csv")
    poses = read_recording(tmp_path / "poses.csv", DELTA, need_measured=False, allow_targets=True)
    measured = simulate(robot, poses, frame=(np.zeros(3), np.zeros(3)))
    np.testing.assert_allclose(measured.measured, found.poses.targets, atol=1e-8)
    np.testing.assert_allclose(measured.joints, found.poses.joints, atol=1e-11)


def test_a_pose_beyond_limits_moves_inwards_and_it_is_said(robot: Robot) -> None:
    limited = robot_from_dict(TABLES | {"joints": {"limits_deg": [[-60.0, 95.0]] * 3}})
    found = planning.plan_poses(limited, "18", n_max=12)
    assert (found.poses.joints >= -60 * DEG - 1e-9).all()
    assert found.steps[-1].rank == 18
    first = found.notes[0]
    assert re.search(r"joint \d would stand at -[\d.]+ deg, its limit is -60; it is moved to \(", first)
    number = int(first.split()[1])
    free = planning.plan_poses(robot, "18", n_max=12)
    assert (free.poses.joints[number - 1] < -60 * DEG).any()
    assert found.answer().notes == found.notes
    assert not free.notes
    assert free.answer().notes is None


def test_written_targets_are_numbers_that_a_person_can_read(robot: Robot, tmp_path: Path) -> None:
    planning.write_targets(planning.plan_poses(robot, "18", n_max=5), tmp_path / "poses.csv")
    cells = [cell for line in (tmp_path / "poses.csv").read_text().splitlines()[1:] for cell in line.split(",")]
    assert max(map(len, cells)) <= len("-1234.567")


def test_joint_limits_and_signs_are_the_controllers(robot: Robot) -> None:
    tables = TABLES | {"joints": {"sign": [1, -1, 1], "limits_deg": [[-66.0, 95.0]] * 3}}
    turned = robot_from_dict(tables)
    plain = planning.plan_poses(robot, "3", n_max=3).poses.joints
    np.testing.assert_allclose(
        reach.reach(turned, planning.plan_poses(robot, "3", n_max=3).poses.targets, turned.tool)[0].joints,
        plain * [1, -1, 1],
    )
    with pytest.raises(NoSolutionError, match=r"joint \d would stand at -[\d.]+ deg, its limit is -66"):
        design(turned, np.array([[0.0, 500.0, -978.0], [0.0, 0.0, -853.0]]), turned.tool, ("theta_1",))
    kept = optimal.plan_optimal_poses(turned, "3", 4).poses.joints
    assert np.all(kept >= -66 * DEG - 1e-12)
    assert np.all(kept <= 95 * DEG)


# ------------------------------------------------------------------------------------------------- ranks, null spaces


@pytest.mark.parametrize(
    ("kind", "ranks"),
    [
        # of the models 42, 36, 32, 24, 18, 3, for one, two and three reference points
        ("distance", [(32, 32, 32, 18, 18, 3)] * 3),
        ("position", [(32, 32, 32, 18, 18, 3), (35, 35, 32, 20, 18, 3), (36, 36, 32, 21, 18, 3)]),
    ],
)
def test_ranks_of_all_models(robot: Robot, kind: str, ranks: list[tuple[int, ...]]) -> None:
    table = rank_table(robot, kind)
    found = {(row.model, row.points): row.rank for row in table}
    models = ("delta/42", "delta/36", "delta/32", "delta/24", "delta/18", "delta/3")
    assert [tuple(found[model, points] for model in models) for points in (1, 2, 3)] == ranks
    for row in table:
        assert len(row.unseen) == row.columns - row.rank
        assert row.smallest > 5e-5  # a gap of ten decades: no rank here is a matter of the tolerance
        assert row.noise < 1e-14


def test_what_model_36_cannot_tell_is_eq_19(robot: Robot) -> None:
    (row,) = (r for r in rank_table(robot) if r.model == "delta/36" and r.points == 3)
    (tilted,) = (c for c in row.unseen if "beta03_1" in c.terms)
    for limb in (1, 2, 3):
        assert tilted.terms[f"beta03_{limb}"] == pytest.approx(tilted.terms["beta03_1"])
        assert tilted.terms[f"beta0_{limb}"] == pytest.approx(-A / (B - A) * tilted.terms["beta03_1"])
    assert tilted.text.endswith("moved together, change no reading")


def test_one_reference_point_is_enough_from_n_7_on(robot: Robot) -> None:
    """2 n + 1 positions hold at most 3 (2 n + 1) - 6 independent distances, and the rings are symmetric besides."""
    one = planning.plan_poses(robot, "32", tools=1, n_max=8)
    turned = planning.plan_poses(robot, "32", tools=1, n_max=8, start_angle=30 * DEG)
    two = planning.plan_poses(robot, "32", tools=2, n_max=8)
    assert steps(one, "rank") == {3: 15, 4: 21, 5: 27, 6: 32, 7: 32, 8: 32}
    assert steps(turned, "rank") == {3: 15, 4: 21, 5: 27, 6: 30, 7: 32, 8: 32}
    assert steps(two, "rank") == {3: 26, 4: 31, 5: 32, 6: 32, 7: 32, 8: 32}
    assert steps(one, "condition")[8] == pytest.approx(50039, rel=1e-3)
    assert steps(two, "condition")[8] == pytest.approx(7994, rel=1e-3)


@pytest.mark.parametrize(("model", "stands_for_it"), [("42", "32"), ("36", "32"), ("24", "18")])
def test_a_model_too_large_is_planned_by_the_one_within(robot: Robot, model: str, stands_for_it: str) -> None:
    found = planning.plan_poses(robot, model, n_max=6)
    within = planning.plan_poses(robot, stands_for_it, n_max=6)
    assert found.names == DELTA.model(stands_for_it)
    assert set(found.names) | set(found.dropped) == set(DELTA.model(model))
    assert steps(found, "condition") == steps(within, "condition")
    assert found.dropped[0] in found.conventions


# ----------------------------------------------------------------------------------------------------- the paper's rule


@pytest.mark.parametrize(
    ("change", "first", "settled"),
    [
        ([np.inf, 0.5, 0.009, 0.02, 0.01, 0.001], 5, 7),
        ([0.01, 0.01], 3, 3),
        ([np.inf, 0.5], None, None),
        ([0.001, 0.5], 3, None),
    ],
)
def test_rule(change: list[float], first: int | None, settled: int | None) -> None:
    assert matrix.rule(range(3, 3 + len(change)), change, 0.01) == (first, settled)


@pytest.mark.parametrize(("norm", "chosen"), [("spectral", (6, 7, 9)), ("frobenius", (5, 7, 9))])
def test_figures_6_and_7(robot: Robot, norm: str, chosen: tuple[int, ...]) -> None:
    """The paper's 5, 7 and 9 come out together, in the Frobenius norm, for rings that start at 75 deg."""
    plans = [
        planning.plan_poses(robot, model, start_angle=75 * DEG, norm=norm, n_max=10) for model in ("3", "18", "32")
    ]
    assert tuple(p.chosen for p in plans) == chosen
    assert [len(p.poses) for p in plans] == [chosen[0] + 1, 2 * chosen[1] + 1, 2 * (2 * chosen[2] + 1)]
    assert [steps(p, "readings")[p.chosen or 0] for p in plans[1:]] == [105, 342]  # as in section 5.2


def test_figure_6_depends_on_norm_and_start_angle(robot: Robot) -> None:
    def chosen(norm: str) -> list[int | None]:
        starts = DEG * np.arange(0, 60, 10)
        return [planning.plan_poses(robot, "3", start_angle=a, norm=norm, n_max=10).chosen for a in starts]

    assert chosen("spectral") == [4, 6, 7, 8, 7, 6]
    assert chosen("frobenius") == [4, 5, 5, 5, 5, 5]


def test_condition_number_does_not_fall_monotonously(robot: Robot) -> None:
    """Section 3.3 of the paper says that it does; from n = 7 on it rises slowly."""
    kappa = steps(planning.plan_poses(robot, "18", start_angle=75 * DEG, n_max=16), "condition")
    assert kappa[7] == pytest.approx(81.34, abs=0.01)
    assert all(kappa[n] < kappa[n + 1] for n in range(7, 16))


def test_figures_of_a_step(robot: Robot) -> None:
    found = planning.plan_poses(robot, "18", scaling="typical", n_max=5)
    step = found.steps[-1]
    H = (
        design(robot, found.poses.targets, found.tools, found.names)
        * DELTA.typical[[DELTA.index[name] for name in found.names]]
    )
    s = np.linalg.svd(H, compute_uv=False)
    assert step.condition == pytest.approx(s[0] / s[-1])
    assert step.indices["O1"] == pytest.approx(np.prod(s) ** (1 / 18) / np.sqrt(11))
    assert step.indices["O5"] == pytest.approx(1 / np.sum(1 / s))
    frobenius = planning.plan_poses(robot, "18", scaling="typical", norm="frobenius", n_max=5).steps[-1].condition
    assert frobenius == pytest.approx(np.linalg.norm(H) * np.linalg.norm(np.linalg.pinv(H)))


# --------------------------------------------------------------------------------------------------- D-optimal sets


def test_exchange_finds_the_best_of_all_sets(robot: Robot) -> None:
    rng = np.random.default_rng(3)
    candidates = rng.uniform([-400, -400, -978], [400, 400, -728], (9, 3))
    found = optimal.plan_optimal_poses(robot, "3", 5, candidates=candidates, rng=rng)
    best = max(log_determinant(found, candidates[list(c)]) for c in itertools.combinations(range(9), 5))
    assert log_determinant(found, found.poses.targets) == pytest.approx(best, abs=1e-9)


def test_d_optimal_set_is_reproducible(robot: Robot) -> None:
    first, again = (optimal.plan_optimal_poses(robot, "3", 5, rng=np.random.default_rng(2)) for _ in range(2))
    np.testing.assert_array_equal(first.poses.targets, again.poses.targets)


@pytest.mark.parametrize(("model", "n"), [("18", 7), ("36", 5)])
def test_d_optimal_set_beats_the_rings(robot: Robot, model: str, n: int) -> None:
    count = 2 * n + 1
    best = optimal.plan_optimal_poses(robot, model, count, sigma_mm=0.005)
    ring = planning.plan_poses(robot, model, n_max=n, threshold=0.0, sigma_mm=0.005)
    ours, theirs = (log_determinant(p, p.poses.targets[:count]) for p in (best, ring))
    assert ours > theirs + 2
    assert best.prediction is not None
    assert ring.prediction is not None
    assert best.prediction.tool_max_mm < 0.75 * ring.prediction.tool_max_mm


def test_too_few_positions_and_candidates(robot: Robot) -> None:
    with pytest.raises(UsageError, match=r"delta/18 and the frame have 24 unknowns .* at least 8 positions"):
        optimal.plan_optimal_poses(robot, "18", 7)
    far = np.array([[0.0, 0.0, -853.0], [3000.0, 0.0, -853.0], [0.0, 100.0, -853.0]])
    with pytest.raises(NoSolutionError, match="only 2 of the candidates"):
        optimal.plan_optimal_poses(robot, "3", 3, candidates=far)


# ---------------------------------------------------------------------------------------------------- the prediction


def test_predicted_deviation_is_that_of_noisy_positions(robot: Robot) -> None:
    sigma = 0.01
    found = planning.plan_poses(robot, "18", n_max=6, threshold=0.0, sigma_mm=sigma)
    assert found.prediction is not None
    P = found.poses.targets
    i, j = np.triu_indices(len(P), 1)
    n = (P[j] - P[i]) / np.linalg.norm(P[j] - P[i], axis=1)[:, None]
    noise = sigma * np.random.default_rng(5).standard_normal((4000, *P.shape))
    read = np.einsum("kc,skc->sk", n, noise[:, j] - noise[:, i])
    fitted = read @ np.linalg.pinv(design(robot, P, found.tools, found.names)).T
    predicted = [p.std * {"mm": 1.0, "deg": DEG}[p.unit] for p in found.prediction.parameters]
    assert [p.name for p in found.prediction.parameters] == list(found.names)
    np.testing.assert_allclose(predicted, fitted.std(axis=0), rtol=0.06)


def test_predicted_tool_deviation_is_the_same_in_every_gauge(robot: Robot) -> None:
    poses = planning.plan_poses(robot, "32", n_max=5, threshold=0.0).poses
    found = []
    for names in (DELTA.model("32"), tuple(n.replace("ex_2", "ex_1") for n in DELTA.model("32"))):
        task = matrix.Task(robot, "", "distance", "paper", "spectral", names, (), targets.reference_points(robot, 2))
        prediction = optimal.predict(task, poses, 0.005)
        assert prediction is not None
        found.append((prediction.tool_mean_mm, prediction.tool_max_mm))
    assert found[0] == pytest.approx(found[1], rel=1e-6)


# ------------------------------------------------------------------------------------------------- files and messages


def test_plan_as_json(robot: Robot) -> None:
    found = planning.plan_poses(robot, "18", start_angle=75 * DEG, n_max=9, sigma_mm=0.005)
    said = json.loads(found.answer().to_json())
    assert said["schema"] == "deltacal.plan/1"
    assert said["model"] == "delta/18"
    assert said["chosen"] == 7
    assert said["n"] == [3, 4, 5, 6, 7, 8, 9]
    assert said["condition"][0] is None  # three poses per ring leave the rank short
    assert all(len(said[key]) == 7 for key in ("condition", "change", "rank", "O1", "O2", "O3", "O4", "O5"))
    assert "first at 75 deg" in said["conventions"]
    assert "singular value" in said["conventions"]
    assert said["prediction"]["parameters"][0]["unit"] == "deg"
    assert len(said["poses"]) == 15
    q = DEG * np.array([pose["joints_deg"] for pose in said["poses"]])
    x, status = DELTA.forward(q, np.zeros(3), DELTA.rows(robot))
    assert (status == SOLVED).all()
    np.testing.assert_allclose(x[:, :3], [pose["target_mm"] for pose in said["poses"]], atol=1e-8)


def test_a_plan_without_a_choice_says_so(robot: Robot) -> None:
    found = planning.plan_poses(robot, "18", n_max=4)
    assert found.chosen is None
    assert found.answer()["chosen"] is None
    assert len(found.poses) == 2 * 4 + 1


def test_figure_shows_chosen_n_and_is_reproducible(robot: Robot, tmp_path: Path) -> None:
    plans = [planning.plan_poses(robot, model, start_angle=75 * DEG, n_max=10).answer() for model in ("18", "32")]
    for name in ("a.svg", "b.svg"):
        write(plans, tmp_path / name)
    text = (tmp_path / "a.svg").read_text()
    for words in ("n = 7", "n = 9", "poses per layer", "condition number", "delta/32, 2 reference points"):
        assert words in text
    assert (tmp_path / "b.svg").read_text() == text
    with pytest.raises(UsageError, match="no set of poses has the full rank"):
        write([planning.plan_poses(robot, "18", n_max=3).answer()], tmp_path / "c.svg")
    with pytest.raises(InputError, match="the file cannot be written"):
        write(plans, tmp_path / "no folder" / "d.svg")


def test_calls_that_make_no_sense(robot: Robot) -> None:
    with pytest.raises(UsageError, match="no layer 'roof'"):
        planning.plan_poses(robot, "18", layers=["roof"])
    with pytest.raises(
        UsageError, match="no kind 'weight'; known: board image, distance, gauge, pose, position, touched board"
    ):
        planning.plan_poses(robot, "18", kind="weight")
    with pytest.raises(UsageError, match="no scaling 'metres'"):
        planning.plan_poses(robot, "18", scaling="metres")
    with pytest.raises(UsageError, match="give 1 to 3"):
        planning.plan_poses(robot, "18", tools=4)
    with pytest.raises(UsageError, match="n_max is 2"):
        planning.plan_poses(robot, "18", n_max=2)
    with pytest.raises(InputError, match=r"no \[workspace\] with top, radius and height"):
        planning.plan_poses(dataclasses.replace(robot, workspace=None), "18")
    wide = robot_from_dict(TABLES | {"workspace": {"top": 728.0, "radius": 1100.0, "height": 250.0}})
    with pytest.raises(NoSolutionError, match="out of reach"):
        planning.plan_poses(wide, "18")
    with pytest.raises(NoSolutionError, match="of 60 points spread over its workspace"):
        rank_table(robot_from_dict(TABLES | {"workspace": {"top": 1500.0, "radius": 500.0, "height": 250.0}}))


# ---------------------------------------------------------------------------------------------------- singularities


def example_robot(name: str) -> Robot:
    return read_robot(example(name) / "robot.toml")


def test_a_workspace_out_of_place_is_answered_with_the_place_of_the_machine() -> None:
    hexapod = example_robot("hexapod")
    assert hexapod.workspace is not None
    low = dataclasses.replace(hexapod, workspace=dataclasses.replace(hexapod.workspace, top=230.0))
    said = r"reaches 0 of 60 .* joint \d would stand at -.* mm, its limit is 0\. In the middle .* at \(0, 0, 321\) mm"
    with pytest.raises(NoSolutionError, match=said):
        rank_table(low, "42")


def test_the_nearest_singularity_of_a_diamond_is_a_stretched_limb() -> None:
    machine = example_robot("diamond")
    sizes = {key: float(machine.geometry[key][0]) for key in ("base_x", "proximal_length", "distal_length")}
    longest = sizes["proximal_length"] + sizes["distal_length"]
    x = np.linspace(-0.6, 0.6, 9) * longest
    targets = np.column_stack([x, -np.sqrt((0.93 * longest) ** 2 - x**2), 0 * x])
    base = np.array([[sizes["base_x"], 0, 0], [-sizes["base_x"], 0, 0]])
    left = (longest - np.linalg.norm(targets[:, None] - base, axis=2)).min(axis=1)
    found = singularities.distance(machine, targets, 150.0)
    near = (left > 0) & (left < 150)
    assert near.sum() > 3
    np.testing.assert_allclose(found[near], left[near], rtol=0.02, atol=0.5)
    assert (found[left <= 0] == 0).all()


def test_poses_near_singularities_are_as_far_as_asked() -> None:
    machine = example_robot("robotennis")
    found = planning.plan_poses(
        machine, "robotennis/15", kind="position", singular=(50.0, 100.0), n_max=12, threshold=0.1
    )
    assert found.method == "singular"
    assert found.chosen is not None
    targets = singularities.near(machine, (50.0, 100.0), 12, np.random.default_rng(0))
    assert np.array_equal(found.poses.targets[: found.chosen], targets[: found.chosen])
    away = singularities.distance(machine, targets, 150.0)
    assert ((away > 49) & (away < 101)).all()
    out = targets + 102 * _unit(targets - [0, 0, targets[:, 2].mean()])
    status = load_mechanism("robotennis").inverse(out, machine.tool, load_mechanism("robotennis").rows(machine))[2]
    assert (status != SOLVED).mean() > 0.3  # of most, what is near is the edge of what can be reached
    best = optimal.plan_optimal_poses(machine, "robotennis/15", 8, kind="position", singular=(50.0, 100.0))
    assert singularities.distance(machine, best.poses.targets, 150.0).max() < 101


def _unit(v: np.ndarray) -> np.ndarray:
    return np.asarray(v / np.linalg.norm(v, axis=1, keepdims=True))


@pytest.mark.parametrize(
    ("name", "model"), [("serial", "serial/dh"), ("planar_parallelogram", "planar_parallelogram/9")]
)
def test_positions_do_not_say_that_these_are_singular(name: str, model: str) -> None:
    with pytest.raises(UsageError, match="need a parallel machine"):
        planning.plan_poses(example_robot(name), model, singular=(50.0, 100.0))
    with pytest.raises(UsageError, match="the lesser first"):
        planning.plan_poses(example_robot("robotennis"), "robotennis/15", singular=(100.0, 50.0))


def test_images_of_a_board_are_planned_where_they_show_it() -> None:
    """An arm's camera looks away from the board at many a pose: such a pose tells nothing, and is not chosen."""
    robot = read_robot(example("serial") / "robot.toml")
    mechanism, tools = mechanism_of(robot), np.atleast_2d(robot.tool)
    wanted = np.unique(joint_spread(robot, 80), axis=0)
    every = reach.reached_of(robot, wanted, tools)
    found, _ = kind_of("board_image").imagined(every.x, 1, mechanism, Measurement())
    plan = optimal.plan_optimal_poses(robot, "serial/dh", 12, kind="board_image", candidates=wanted)
    chosen = [int(np.argmin(np.abs(every.x - x).max(axis=1))) for x in plan.poses.x]
    assert len({*chosen}) == 12
    assert {*chosen} < {*found.rows[:, 0]} < {*range(80)}
    assert plan.steps[-1].rank == len(plan.names)


def test_the_only_model_need_not_be_named() -> None:
    assert dc.plan(example("serial") / "robot.toml", optimal=30).model == "serial/dh"
    with pytest.raises(UsageError, match="--model delta/42, delta/36"):
        dc.plan(example("delta") / "robot.toml", optimal=30)
