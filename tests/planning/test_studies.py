"""Studies of a plan: what Monte Carlo finds is what the linear problem predicts, whatever the number of workers."""

from __future__ import annotations

import dataclasses
import json
import math
import re
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen import InputError, UsageError, read_robot
from deltacal_gen.app.demonstration import example
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.planning import advice, machines, studies
from deltacal_gen.planning.machines import Study
from tests.support.commands import Run

MACHINES = 1000


@pytest.fixture(scope="module")
def robot() -> Robot:
    return read_robot(example() / "robot.toml")


@pytest.fixture(scope="module")
def plan(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two rings of nine poses and one in the middle."""
    file = tmp_path_factory.mktemp("plan") / "plan.csv"
    angles = 2 * np.pi * np.arange(9) / 9
    rings = [(450 * np.cos(a), 450 * np.sin(a), z) for z in (-740, -960) for a in angles]
    lines = [",".join(f"{v:.3f}" for v in target) for target in [*rings, (0, 0, -850)]]
    file.write_text("x_mm,y_mm,z_mm\n" + "\n".join(lines) + "\n")
    file.with_suffix(".toml").write_text('[measurement]\nkind = "position"\nframe = "unknown"\nsigma_mm = 0.005\n')
    return file


@pytest.fixture(scope="module")
def made(robot: Robot, plan: Path) -> Study:
    mechanism = mechanism_of(robot)
    names = mechanism.model("delta/32")
    small = dict.fromkeys((p.name for p in mechanism.parameters), 1e-3)  # where the problem is linear
    poses = read_recording(plan, mechanism, need_measured=False, allow_targets=True)
    return Study(dataclasses.replace(robot, tolerance=small), poses, names, names, 0.005)


def test_scatter_is_what_the_linear_problem_predicts(made: Study) -> None:
    found = studies.conduct(made, MACHINES, model="delta/18", workers=1)
    ratio = np.array([p["std"] / p["predicted_std"] for p in found["parameters"]])
    assert len(ratio) == 32
    assert np.sqrt(np.mean(ratio**2)) == pytest.approx(1.0, abs=0.03)
    assert np.abs(ratio - 1).max() < 4 / math.sqrt(2 * MACHINES)
    stated = np.array([p["std"] / p["stated_std"] for p in found["parameters"]])
    assert stated == pytest.approx(ratio, rel=1e-3), "the prior is what machines are drawn with"
    after = found["position"]["after"]
    assert after["rms_mm"] == pytest.approx(after["predicted_rms_mm"], rel=0.03)
    assert after["predicted_rms_mm"] == pytest.approx(found["advice"]["rms_mm"], rel=1e-3)


def test_machines_of_ordinary_errors_are_calibrated_exactly_though_the_jacobian_is_the_nominal_one(
    robot: Robot, made: Study
) -> None:
    wild = dataclasses.replace(made, robot=robot, sigma=1e-6)
    found = machines.machines(wild, 0, 20)
    assert found.lost == 0
    assert np.array(found.before)[:, 0].min() > 0.3
    assert np.array(found.after)[:, 0].max() < 1e-3


def test_errors_that_the_model_leaves_out_stay(made: Study) -> None:
    mechanism = made.problem.mechanism
    left = dataclasses.replace(made, names=mechanism.model("delta/3"), errors=mechanism.model("delta/42"))
    found = studies.conduct(left, 250, model="delta/18", workers=1)
    after = found["position"]["after"]
    assert after["rms_mm"] == pytest.approx(after["predicted_rms_mm"], rel=0.1)
    assert {p["name"] for p in found["parameters"]} == {"theta_1", "theta_2", "theta_3"}


@pytest.mark.parametrize(
    ("mechanism", "kind", "model"), [("delta", "pose", "42"), ("delta", "distance", "18"), ("delta", "gauge", "18")]
)
def test_other_readings(mechanism: str, kind: str, model: str, robot: Robot, tmp_path: Path) -> None:
    rng = np.random.default_rng(4)
    n = 40
    targets = np.column_stack([rng.uniform(-350, 350, (n, 2)), rng.uniform(-960, -740, n)])
    rows = [f"{k}," + ",".join(f"{v:.3f}" for v in t) for k, t in enumerate(targets)]
    file = tmp_path / "plan.csv"
    file.write_text("pose,x_mm,y_mm,z_mm\n" + "\n".join(rows) + "\n")
    more = "base_point_mm = [300.0, 100.0, -20.0]\nplatform_point_mm = [0.0, 0.0, 0.0]\n" if kind == "gauge" else ""
    file.with_suffix(".toml").write_text(
        f'[measurement]\nkind = "{kind}"\nframe = "unknown"\nsigma_mm = 0.005\nsigma_deg = 0.002\n{more}'
    )
    if kind == "distance":
        pairs = [f"{a},{b}," for a in range(n) for b in range(a)]
        file.with_suffix(".distances.csv").write_text("pose_a,pose_b,distance_mm\n" + "\n".join(pairs) + "\n")
    found = dc.study(robot, plan=file, model=model, trials=60, workers=1)
    after = found["position"]["after"]
    assert found["lost"] == 0
    assert after["rms_mm"] == pytest.approx(after["predicted_rms_mm"], rel=0.25)
    assert after["rms_mm"] < 0.2 * found["position"]["before"]["rms_mm"]


def test_workers_change_nothing_and_a_run_is_resumed(robot: Robot, plan: Path, tmp_path: Path) -> None:
    alone = dc.study(robot, plan=plan, model="18", trials=260, workers=1, resume=tmp_path / "run")
    both = dc.study(robot, plan=plan, model="18", trials=260, workers=2)
    assert alone.to_json() == both.to_json()
    kept = sorted((tmp_path / "run" / "tasks").rglob("*.json"))
    kept[0].unlink()
    again = dc.study(robot, plan=plan, model="18", trials=260, workers=1, resume=tmp_path / "run")
    assert again.to_json() == alone.to_json()
    other = dc.study(robot, plan=plan, model="18", trials=260, workers=1, resume=tmp_path / "run", seed=1)
    assert other["parameters"] != alone["parameters"]


def test_measuring_more_leaves_less(made: Study) -> None:
    told = advice.advice(made)
    rms = [e.rms_mm for e in told.enough]
    assert rms == sorted(rms, reverse=True)
    assert all(0 < g.rms_mm < told.rms_mm for g in told.add)


def test_what_is_advised_gives_what_is_said(made: Study, plan: Path, tmp_path: Path) -> None:
    gain = next(g for g in advice.advice(made).add if g.add.startswith("one more pose"))
    at = re.search(r"\((.*)\)", gain.add)
    assert at is not None
    further = tmp_path / "plan.csv"
    further.write_text(f"{plan.read_text()}{at[1].replace(' ', '')}\n")
    further.with_suffix(".toml").write_text(plan.with_suffix(".toml").read_text())
    poses = read_recording(further, made.problem.mechanism, need_measured=False, allow_targets=True)
    after = studies.conduct(dataclasses.replace(made, poses=poses), 1000, model="delta/18", workers=1)["position"][
        "after"
    ]
    assert after["rms_mm"] == pytest.approx(gain.rms_mm, rel=0.03)


@pytest.mark.walk
def test_a_suspicion_is_concealed_and_looked_for(robot: Robot, plan: Path, tmp_path: Path, run: Run) -> None:
    several = tmp_path / "plan.csv"
    first, *targets = plan.read_text().splitlines()
    rows = [f"{t},{a},1,{-a}" for t in targets for a in (1, -1)]
    several.write_text(f"{first},approach1,approach2,approach3\n" + "\n".join(rows) + "\n")
    several.with_suffix(".toml").write_text(plan.with_suffix(".toml").read_text())
    for name, more in (("backlash", "width = 0.03"), ("thermal_zero", "drift = 0.001")):
        (tmp_path / f"{name}.toml").write_text(f'[[effects]]\nname = "{name}"\nlimb = 1\n{more}\n')
    suspects = [x for name in ("backlash", "thermal_zero") for x in ("--suspect", tmp_path / f"{name}.toml")]
    out = tmp_path / "study.json"
    what = ("--model", "24", "--trials", "100", "--diagnoses", "2", "--workers", "1")
    to = ("-o", out, "--report", tmp_path / "study.html")
    code, text, _ = run("study", example() / "robot.toml", "--plan", several, *what, *suspects, *to)
    assert code == 0, text
    nothing, backlash, warmth = json.loads(out.read_text())["suspects"]
    assert nothing["named_right"] == 2
    assert backlash["named_right"] == 2
    assert warmth["recordings"] == 0
    assert "temp_C" in warmth["failed"][0]
    assert "thermal_zero cannot be found without the column temp_C" in " ".join(text.split())
    page = (tmp_path / "study.html").read_text()
    assert "<svg" in page
    assert not re.search(r"(src|href)=\"http", page)


def test_a_plan_that_carries_too_little_is_refused(robot: Robot, plan: Path, tmp_path: Path) -> None:
    short = tmp_path / "plan.csv"
    short.write_text("\n".join(plan.read_text().splitlines()[:6]) + "\n")
    with pytest.raises(InputError, match="nothing says how well"):
        dc.study(robot, plan=short)
    with pytest.raises(InputError, match="are needed"):
        dc.study(robot, plan=short, model="32", noise=0.01)


def test_a_suspicion_of_no_effect_is_refused(plan: Path) -> None:
    with pytest.raises(InputError, match=r"truth\.toml: this names no effect"):
        dc.study(example() / "robot.toml", plan=plan, noise=0.01, suspect=[example() / "truth.toml"])


def test_a_trajectory_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "trajectory.csv"
    dc.plan_trajectory(example() / "robot.toml", output=path, runs=1, period_s=4.0)
    with pytest.raises(UsageError, match="a study is of poses, and this is a trajectory"):
        dc.study(example() / "robot.toml", plan=path, noise=0.05)


def test_a_plan_of_a_second_encoder_says_what_a_diagnosis_would_find(robot: Robot, tmp_path: Path, run: Run) -> None:
    rng = np.random.default_rng(2)
    rows = [f"{q},{ways}" for q in _joints(rng, 20) for ways in ("1,1,-1", "-1,-1,1")]
    plan = tmp_path / "plan.csv"
    plan.write_text("q1_deg,q2_deg,q3_deg,approach1,approach2,approach3\n" + "\n".join(rows) + "\n")
    plan.with_suffix(".toml").write_text('[measurement]\nkind = "encoder"\nsigma_deg = 0.02\n')
    (tmp_path / "play.toml").write_text('[[effects]]\nname = "backlash"\nlimb = 2\nwidth = 0.3\n')
    command = ("study", example() / "robot.toml", "--plan", plan, "--diagnoses", 2, "--workers", 1)
    assert "see no source error" in run(*command)[2]
    out, page = tmp_path / "study.json", tmp_path / "study.html"
    code, text, said = run(*command, "--suspect", tmp_path / "play.toml", "-o", out, "--report", page)
    assert code == 0, said
    found = json.loads(out.read_text())
    assert (found["position"], found["advice"], found["machines"]) == (None, None, 0)
    assert found["sigma_deg"] == pytest.approx(0.02)
    assert [s["named_right"] for s in found["suspects"]] == [2, 2]
    assert "backlash at limb 2 concealed: said so in 2 of 2" in text
    assert "2 of 2 recordings say" in page.read_text()
    assert "held out before, deg" in page.read_text()
    bare = tmp_path / "bare.toml"
    bare.write_text('[robot]\nname = "arms alone"\nmechanism = "delta"\n')
    again = dc.study(bare, plan=plan, suspect=[tmp_path / "play.toml"], diagnoses=1, workers=1)
    assert again["suspects"][1]["named_right"] == 1


def _joints(rng: np.random.Generator, count: int) -> list[str]:
    return [",".join(f"{v:.3f}" for v in row) for row in rng.uniform(-20, 60, (count, 3))]


def test_where_nothing_is_wrong_and_nothing_is_freed_nothing_is_taken_off(robot: Robot, plan: Path) -> None:
    found = dc.study(robot, plan=plan, model="delta/0", trials=3, workers=1)
    assert found["advice"]["doubling"] == 0
    assert [g["gain"] for g in found["advice"]["add"]] == [0, 0]
