"""Boards, encoders and one axis as users hand them in: files written by an exact camera and machine of our own.

Nothing of the kernels makes these readings: the chain, the lens and the joints are written out here once more.
"""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.machine.registry import Array
from tests.benchmarks.instruments import BOARD, DELTA, at_best, leaning, spoken, touches
from tests.support.commands import Run
from tests.support.exact_camera import (
    BENT,
    LENS,
    NOISE_PX,
    WRONG_ARM,
    arm_poses,
    arm_robot,
    around,
    camera,
    joints_around,
    rows_seen,
    seen_by_arm,
    turn,
    write,
)

UNDRAWN = '[robot]\nname = "arms"\nmechanism = "delta"\n[joints]\nsign = [-1, -1, -1]\n'
AXIS = '[robot]\nname = "axis"\nmechanism = "serial"\n[[joint]]\nkind = "prismatic"\n' + "".join(
    f"{key} = 0.0\n" for key in ("a", "alpha", "d", "theta")
)
MIXED = (
    '[robot]\nname = "mixed"\nmechanism = "serial"\n[[joint]]\nkind = "revolute"\na = 100.0\nalpha = 0.0\nd = 0.0\n'
    'theta = 0.0\n[[joint]]\nkind = "prismatic"\na = 0.0\nalpha = 90.0\nd = 10.0\ntheta = 0.0\n'
    "[joints]\nsign = [-1, 1]\n"
)


def answer(run: Run, *arguments: object) -> dict[str, Any]:
    code, out, said = run(*arguments, "--json")
    assert code == 0, said
    found: dict[str, Any] = json.loads(out)
    return found


def parameters(found: Mapping[str, Any]) -> dict[str, Any]:
    return {p["name"]: p for p in found["parameters"]}


# -------------------------------------------------------------------------------------------------------------- prints


def test_the_plane_of_a_delta_and_that_of_the_print_it_touches_are_one(tmp_path: Path) -> None:
    said = 'kind = "position"\nsigma_mm = 0.02\n'
    on_print, at_robot = touches(np.random.default_rng(5))
    assert leaning(dc.identify(DELTA, write(tmp_path / "print.csv", on_print, said)))
    known = dc.identify(DELTA, write(tmp_path / "known.csv", at_robot, f'{said}frame = "robot"\n'))
    assert not spoken(known, BOARD)


# ------------------------------------------------------------------------------------------------------------- images


@pytest.mark.walk
@pytest.mark.parametrize(
    ("said", "lens"),
    [
        pytest.param({"place": "platform", **LENS, **BENT}, LENS | BENT, marks=pytest.mark.thorough),
        ({"place": "fixed", **LENS, **BENT}, LENS | BENT),
        pytest.param({}, LENS, marks=pytest.mark.thorough),
        (dict.fromkeys(BENT, "unknown"), LENS | BENT),
    ],
    ids=["on the link", "beside the arm", "nothing known", "distortion unknown"],
)
def test_an_arm_is_found_though_points_of_cut_images_are_wrong(
    run: Run, tmp_path: Path, said: dict[str, Any], lens: dict[str, float]
) -> None:
    robot = arm_robot(tmp_path)
    place = str(said.get("place", "platform"))
    seen, blank = seen_by_arm(tmp_path, camera(**said), lens, place)
    page = tmp_path / "result.html"
    found = answer(run, "identify", robot, seen, "-o", tmp_path / "result.json", "--report", page)
    assert f"{found['heldout_rms_px']:.4f} px after" in page.read_text()
    assert "rms of the readings, px" in page.read_text()
    assert found["train_rms_px"] == pytest.approx(NOISE_PX, rel=0.1)
    assert found["heldout_rms_px"] == pytest.approx(NOISE_PX, rel=0.2)
    truth = WRONG_ARM | lens
    far = [
        (p["name"], (p["value"] - truth.get(p["name"], 0.0)) / p["std"])
        for p in found["parameters"]
        if p["status"] == "identified" and abs(p["value"] - truth.get(p["name"], 0.0)) > 4 * p["std"]
    ]
    assert not far
    assert {name for name in WRONG_ARM if parameters(found)[name]["status"] == "identified"} == {*WRONG_ARM}
    # what turns with the camera or the board alone moves images, unlike two shifts along parallel axes
    said_of = {frozenset(c["terms"]): c["text"] for c in found["unidentifiable"]}
    assert said_of[frozenset(["theta_1"])].startswith("theta_1 and where camera and board stand are one number")
    assert said_of[frozenset({"d_2", "d_3"})].endswith("moved together, change no reading")
    (remedy,) = (m for m in found["next_measurements"] if m["measurement"].startswith("where camera and board stand"))
    assert sum("one number" in text for text in said_of.values()) == 9
    assert remedy["pins"] == 7  # d_6 is tz, and a_6 is tx
    assert run("predict", tmp_path / "result.json", blank, "-o", tmp_path / "predicted.csv")[0] == 0
    told, read = (np.genfromtxt(path, delimiter=",", names=True) for path in (tmp_path / "predicted.csv", seen))
    off = np.hypot(told["u_px"] - read["u_px"], told["v_px"] - read["v_px"])
    assert np.median(off) == pytest.approx(1.18 * NOISE_PX, rel=0.15)
    checked = answer(run, "validate", tmp_path / "result.json", seen)
    assert checked["rms_px"] == pytest.approx(NOISE_PX, rel=0.1)
    assert len(checked["gross_errors"]) == pytest.approx((off > 6 * NOISE_PX).sum(), abs=2)


def test_images_that_share_nothing_tell_as_much_as_they_can(tmp_path: Path) -> None:
    """Points found wrongly, few points of some images: neither passes for an error that an image's points share."""
    rng = np.random.default_rng(22)
    joints = joints_around(rng, 20)
    poses = arm_poses(joints)
    scene = around(poses, "platform")
    pixels, shown = scene.pixels(poses, LENS)
    columns = rows_seen(joints, pixels, shown, rng)
    found = dc.identify(arm_robot(tmp_path), write(tmp_path / "seen.csv", columns, camera(**LENS)))
    measured = np.column_stack([columns["u_px"], columns["v_px"]]).astype(float)
    right = np.linalg.norm(measured - pixels[shown], axis=1) < 6 * NOISE_PX
    base = [b.name for b in found.base]
    least = dict(zip(base, np.sqrt(np.diag(at_best(scene, joints, WRONG_ARM, (shown, right), base))), strict=False))
    told = {p.name: p.std for p in found.parameters if p.std is not None and p.name in least}
    assert len(told) == 17
    assert {name: std / least[name] for name, std in told.items()} == pytest.approx(dict.fromkeys(told, 1.0), abs=0.15)


# ------------------------------------------------------------------------------------------------------------ encoders


def swinging(joints: int) -> tuple[dict[str, Sequence[object]], Array]:
    """Return columns of time, and joints (N, joints) that swing to and fro in six runs."""
    rng = np.random.default_rng(2)
    time, run = np.tile(0.05 * np.arange(40), 6), np.repeat(np.arange(6), 40)
    rate, phase = rng.uniform(1.0, 3.0, (6, joints)), rng.uniform(0, 6, (6, joints))
    return {"run": run.tolist(), "time_s": time.tolist()}, 20 + 35 * np.sin(rate[run] * time[:, None] + phase[run])


@pytest.mark.parametrize(
    ("robot", "units", "sign"),
    [(UNDRAWN, ("deg", "deg", "deg"), (-1, -1, -1)), (MIXED, ("deg", "mm"), (-1, 1))],
    ids=["delta without a drawing", "one joint turns, one slides"],
)
def test_zeros_of_encoders_are_found(
    run: Run, tmp_path: Path, robot: str, units: Sequence[str], sign: Sequence[int]
) -> None:
    (tmp_path / "robot.toml").write_text(robot)
    time, q = swinging(len(units))
    zeros = np.array([1.0, -2.0, 0.5])[: len(units)]
    read = np.array(sign) * (np.array(sign) * q + zeros) + 0.02 * np.random.default_rng(4).standard_normal(q.shape)
    blank = time | {f"q{i + 1}_{u}": q[:, i] for i, u in enumerate(units)}
    columns = blank | {f"enc{i + 1}_{u}": read[:, i] for i, u in enumerate(units)}
    write(tmp_path / "read.csv", columns, 'kind = "encoder"\n')
    write(tmp_path / "blank.csv", blank, 'kind = "encoder"\n')
    page = ("--report", tmp_path / "result.html")
    found = answer(run, "identify", tmp_path / "robot.toml", tmp_path / "read.csv", *page, "-o", tmp_path / "r.json")
    for i, (unit, zero) in enumerate(zip(units, zeros, strict=True), start=1):
        p = parameters(found)[f"enc_zero_{i}"]
        assert p["unit"] == unit
        assert p["value"] == pytest.approx(zero, abs=4 * p["std"])
        assert p["indistinguishable_from"] == [f"the zero of joint {i}"]
        told = f"enc_zero_{i} and the zero of joint {i} are one number in these readings: their sum is found"
        assert told in [c["text"] for c in found["unidentifiable"]]
        assert found["next_measurements"][i - 1]["measurement"].startswith(f"put joint {i} to a mark or stop")
    assert found.get("unit") == (units[0] if len({*units}) == 1 else None)
    assert run("predict", tmp_path / "r.json", tmp_path / "blank.csv", "-o", tmp_path / "p.csv")[0] == 0
    told = np.genfromtxt(tmp_path / "p.csv", delimiter=",", names=True)
    for i, unit in enumerate(units):
        assert np.std(told[f"enc{i + 1}_{unit}"] - read[:, i]) == pytest.approx(0.02, rel=0.2)
    assert answer(run, "diagnose", tmp_path / "robot.toml", tmp_path / "read.csv", "-o", tmp_path / "d.json")[
        "verdict"
    ] == ("adequate")


def test_joints_without_an_encoder_have_no_zero(run: Run, tmp_path: Path) -> None:
    (tmp_path / "robot.toml").write_text(UNDRAWN)
    time, q = swinging(3)
    columns = time | {f"q{i}_deg": q[:, i - 1] for i in (1, 2, 3)} | {"enc2_deg": q[:, 1] + 0.5}
    write(tmp_path / "read.csv", columns, 'kind = "encoder"\n')
    found = answer(run, "identify", tmp_path / "robot.toml", tmp_path / "read.csv", "-o", tmp_path / "r.json")
    assert [name for name in parameters(found) if name.startswith("enc_zero")] == ["enc_zero_2"]


# ------------------------------------------------------------------------------------------------- boards and one axis


def test_what_no_column_says_is_predicted_as_it_was_read(run: Run, tmp_path: Path) -> None:
    """A file to be predicted holds joints alone: touched boards and single coordinates come back as they were read."""
    (tmp_path / "robot.toml").write_text(AXIS)
    q = np.tile(np.concatenate([np.arange(0, 501, 25), np.arange(500, -1, -25)]), 3).astype(float)
    read = q + 0.001 * np.random.default_rng(1).standard_normal(len(q))
    for frame in ("robot", "unknown"):
        said = f'kind = "one axis"\nsigma_mm = 0.001\nframe = "{frame}"\n'
        write(tmp_path / "read.csv", {"q1_mm": q, "z_mm": read}, said)
        write(tmp_path / "blank.csv", {"q1_mm": q}, said)
        answer(run, "identify", tmp_path / "robot.toml", tmp_path / "read.csv", "-o", tmp_path / "r.json")
        assert run("predict", tmp_path / "r.json", tmp_path / "blank.csv", "-o", tmp_path / "p.csv")[0] == 0
        told = np.genfromtxt(tmp_path / "p.csv", delimiter=",", names=True)
        assert told.dtype.names == ("pose", "q1_mm", "z_mm")
        assert np.std(told["z_mm"] - read) == pytest.approx(0.001, rel=0.2)
        assert answer(run, "validate", tmp_path / "r.json", tmp_path / "read.csv")["iso230"]["poses"] > 10


def test_touched_points_are_predicted_on_the_board(run: Run, tmp_path: Path) -> None:
    robot = arm_robot(tmp_path)
    rng = np.random.default_rng(3)
    joints = np.array([10.0, 5.0, 15.0, 10.0, 50.0, 5.0]) + rng.uniform(-25, 25, (40, 6))
    _, P = arm_poses(joints)
    on_board = (P - P.mean(axis=0)) @ turn(0.2, 0.1, 0.5) + 0.02 * rng.standard_normal(P.shape)
    columns = {f"q{i}_deg": joints[:, i - 1] for i in range(1, 7)}
    said = 'kind = "position"\nsigma_mm = 0.02\n'
    read = columns | {f"board_{axis}_mm": values for axis, values in zip("xyz", on_board.T, strict=True)}
    write(tmp_path / "read.csv", read, said)
    write(tmp_path / "blank.csv", columns, said)
    found = answer(run, "identify", robot, tmp_path / "read.csv", "-o", tmp_path / "r.json")
    assert found["readings"]["kind"] == "touched_board"
    assert run("predict", tmp_path / "r.json", tmp_path / "blank.csv", "-o", tmp_path / "p.csv")[0] == 0
    told = np.genfromtxt(tmp_path / "p.csv", delimiter=",", names=True)
    off = [told[f"board_{axis}_mm"] - values for axis, values in zip("xyz", on_board.T, strict=True)]
    assert np.std(off) < 0.03
