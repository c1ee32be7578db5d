"""Plans for printed boards: points that the tip touches, places from which a camera sees the board."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from deltacal_gen.errors import NoSolutionError
from deltacal_gen.files.robot import read_robot
from deltacal_gen.files.sidecar import read_measurement
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.planning import boards
from tests.support.commands import Run

pytestmark = pytest.mark.usefixtures("compiled")

EXAMPLES = Path(__file__).parents[2] / "src/deltacal_gen/examples"
ROBOTS = {"serial/dh": EXAMPLES / "serial/robot.toml", "delta/18": EXAMPLES / "delta/robot.toml"}
COUNT = 26


def planned(run: Run, folder: Path, model: str, kind: str) -> tuple[dict[str, Any], np.ndarray, Path]:
    """Return a plan's answer, its table and the file."""
    path = folder / "plan.csv"
    code, out, said = run(
        "plan", ROBOTS[model], "--model", model, "--kind", kind, "--optimal", COUNT, "-o", path, "--json"
    )
    assert code == 0, said
    return json.loads(out), np.genfromtxt(path, delimiter=",", names=True), path


def declared(path: Path, line: str) -> None:
    """Add a line to the sidecar of a plan."""
    sidecar = path.with_suffix(".toml")
    sidecar.write_text(sidecar.read_text().replace("[measurement]", f"[measurement]\n{line}"))


@pytest.mark.parametrize("model", ROBOTS)
def test_the_tip_touches_points_of_a_flat_print(run: Run, tmp_path: Path, model: str) -> None:
    found, rows, path = planned(run, tmp_path, model, "touched board")
    assert found["kind"] == "touched_board"
    at = np.array([p["target_mm"] for p in found["poses"]])
    on_print = np.column_stack([rows["board_x_mm"], rows["board_y_mm"], np.zeros(COUNT)])
    assert (rows["board_z_mm"] == 0).all()
    apart = np.linalg.norm(at[:, None] - at[None], axis=2)
    assert np.linalg.norm(on_print[:, None] - on_print[None], axis=2) == pytest.approx(apart, abs=0.1)
    step = np.diff(np.unique(on_print[:, :2]))
    assert step.min() >= 49.0  # points that a print may have
    # what is simulated lies on the print, but for noise and where it was commanded
    assert run("simulate", ROBOTS[model], path, "-o", tmp_path / "read.csv", "--noise", 0.05)[0] == 0
    read = np.genfromtxt(tmp_path / "read.csv", delimiter=",", names=True)
    assert np.abs(read["board_x_mm"] - on_print[:, 0]).max() < 1.0
    assert np.abs(read["board_z_mm"]).max() < 1.0
    declared(path, "sigma_mm = 0.05")
    command = ("study", ROBOTS[model], "--plan", path, "--model", model, "--trials", 5)
    assert run(*command, "--workers", 1)[0] == 0


@pytest.mark.walk
@pytest.mark.parametrize("model", ROBOTS)
def test_a_camera_sees_the_board_from_every_pose(run: Run, tmp_path: Path, model: str) -> None:
    _, rows, path = planned(run, tmp_path, model, "board image")
    points = len(np.unique(np.column_stack([rows["board_x_mm"], rows["board_y_mm"]]), axis=0))
    assert np.unique(rows["pose"], return_counts=True)[1] == pytest.approx(np.full(COUNT, points))
    assert run("simulate", ROBOTS[model], path, "-o", tmp_path / "read.csv", "--noise", 0.05)[0] == 0
    read = np.genfromtxt(tmp_path / "read.csv", delimiter=",", names=True)
    middle = [read["pose"] == pose for pose in np.unique(read["pose"])]
    uv = np.array([[read["u_px"][own].mean(), read["v_px"][own].mean()] for own in middle])
    assert ((uv > 0) & (uv < [1280, 1024])).all()  # the camera is off by its mount's ordinary errors
    assert (tmp_path / "read.toml").read_text().split()[-3:] == ["sigma_px", "=", "0.05"]
    command = ("study", ROBOTS[model], "--plan", path, "--model", model, "--trials", 5, "--workers", 1, "--json")
    code, _, said = run(*command)
    assert code == 3
    assert "Add sigma_px to the sidecar" in said
    told = json.loads(run(*command, "--noise", 0.05)[1])
    assert told["sigma_px"] == pytest.approx(0.05)
    assert told["sigma_mm"] == pytest.approx(0.05 * told["unit_mm"])
    declared(path, "sigma_px = 0.05")
    assert json.loads(run(*command)[1]) == told


@pytest.mark.walk
@pytest.mark.parametrize("model", ROBOTS)
def test_a_fixed_camera_sees_the_board_on_the_platform(run: Run, tmp_path: Path, model: str) -> None:
    said, path = tmp_path / "said.toml", tmp_path / "plan.csv"
    lens = 'place = "fixed"\nfx_px = 900.0\nfy_px = 900.0\ncx_px = 600.0\ncy_px = 500.0\n'
    said.write_text(f'[measurement]\nkind = "board image"\nsigma_px = 0.2\n[measurement.camera]\n{lens}')
    command = ("plan", ROBOTS[model], "--model", model, "--sidecar", said, "--optimal", COUNT, "-o", path)
    code, _, why = run(*command)
    assert code == 0, why
    camera = read_measurement(path.with_suffix(".toml")).camera
    assert camera is not None
    assert (camera.place, camera.fx_px) == ("fixed", 900.0)
    rows = np.genfromtxt(path, delimiter=",", names=True)
    assert len(np.unique(rows["pose"])) == COUNT
    assert run("simulate", ROBOTS[model], path, "-o", tmp_path / "read.csv", "--noise", 0.2)[0] == 0
    read = np.genfromtxt(tmp_path / "read.csv", delimiter=",", names=True)
    middle = [read["pose"] == pose for pose in np.unique(read["pose"])]
    uv = np.array([[read["u_px"][own].mean(), read["v_px"][own].mean()] for own in middle])
    assert ((uv > 0) & (uv < [1200, 1000])).all()
    study = ("study", ROBOTS[model], "--plan", path, "--model", model, "--trials", 60, "--workers", 1, "--json")
    told = json.loads(run(*study)[1])
    after = told["position"]["after"]
    assert after["rms_mm"] == pytest.approx(after["predicted_rms_mm"], rel=0.25)
    assert after["rms_mm"] < 0.7 * told["position"]["before"]["rms_mm"]


def test_an_arm_looks_at_one_point_tilted_and_from_several_distances() -> None:
    robot = read_robot(ROBOTS["serial/dh"])
    mechanism = mechanism_of(robot)
    x, _ = mechanism.forward(robot.joint_sign * boards.looking(robot), robot.tool, mechanism.rows(robot))
    along = x[:, 3:].reshape(-1, 3, 3)[:, :, 2]
    across = np.eye(3) - along[:, :, None] * along[:, None, :]
    at = np.linalg.solve(across.sum(axis=0), np.einsum("nij,nj->i", across, x[:, :3]))
    off = at - x[:, :3]
    distance = np.linalg.norm(off, axis=1)
    assert off / distance[:, None] == pytest.approx(along, abs=1e-5)
    assert distance.max() / distance.min() > 1.4
    tilt = np.degrees(np.arccos(along @ (along.mean(axis=0) / np.linalg.norm(along.mean(axis=0)))))
    assert tilt.max() > 25.0


def test_an_arm_that_no_joints_bring_before_a_board_says_so(tmp_path: Path) -> None:
    text = ROBOTS["serial/dh"].read_text()
    limits = "[[0, 1], [0, 1], [0, 1], [0, 1], [0, 1], [0, 1]]"
    narrow = re.sub(r"limits_deg = .*", f"limits_deg = {limits}", text)
    (tmp_path / "robot.toml").write_text(narrow.partition("[workspace]")[0])
    robot = read_robot(tmp_path / "robot.toml")
    with pytest.raises(NoSolutionError, match="bring the machine before a board"):
        boards.looking(robot)


def test_unknown_kinds_are_refused_by_the_names_of_sidecars(run: Run) -> None:
    code, _, said = run("plan", ROBOTS["delta/18"], "--model", "delta/18", "--kind", "board imag")
    assert code != 0
    assert "known: board image, distance" in said
