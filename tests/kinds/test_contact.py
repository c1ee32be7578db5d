"""Calibration from joints alone: a ball in sockets, no instrument."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.diagnosis.candidates import candidates
from deltacal_gen.diagnosis.library import library
from deltacal_gen.errors import InputError
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import robot_to_toml
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.physics.terms import blank
from deltacal_gen.units import DEG
from tests.support.commands import Run
from tests.support.open_chains import by_hand, robot

TRUTH = {"a_2": 0.4, "theta_2": 0.08 * DEG, "d_4": -0.3, "theta_5": -0.1 * DEG, "tx": 0.5, "tz": -0.4}
TOUCHES = 20
SOCKETS = {
    "front0": (430.0, 60.0, 120.0),
    "front1": (430.0, 110.0, 120.0),
    "left0": (-60.0, 420.0, 200.0),
    "left1": (-60.0, 420.0, 250.0),
    "high0": (300.0, -250.0, 420.0),
    "high1": (335.35533906, -214.64466094, 420.0),
}


def touched(folder: Path, sockets: dict[str, tuple[float, float, float]], sigma: float, seed: int) -> Path:
    """Write joints at which the true arm's ball sits in each socket, `TOUCHES` times from all sides."""
    r = robot()
    rng, lines = np.random.default_rng(seed), ["contact," + ",".join(f"q{i}_deg" for i in range(1, 7))]
    (folder / "robot.toml").write_text(robot_to_toml(r))
    m = mechanism_of(r)
    rows = m.rows(r, m.vector(TRUTH))
    for name, at in sockets.items():
        q = rng.uniform(-2.5, 2.5, (120, 6))
        for _ in range(40):  # Newton's method, all draws at once; those that do not get there are left out
            x, _ = m.forward(q, r.tool, rows)
            slope = m.sensitivity(x, q, r.tool, rows).joints[:, :3]
            step = (np.linalg.pinv(slope) @ (np.array(at) - x[:, :3])[:, :, None])[:, :, 0]
            q = q + np.clip(step, -0.3, 0.3)
        there = q[np.abs(step).max(axis=1) < 1e-12][:TOUCHES]
        assert len(there) == TOUCHES
        assert by_hand(r, there[0], TRUTH)[:3] == pytest.approx(at, abs=1e-6)
        for one in there + sigma * rng.standard_normal(there.shape):
            lines.append(name + "," + ",".join(repr(float(v)) for v in one / DEG))
    path = folder / "ball.csv"
    path.write_text("\n".join(lines) + "\n")
    pairs = ", ".join(f'["{n}", "{n[:-1]}1", 50.0]' for n in sockets if n.endswith("0"))
    path.with_suffix(".toml").write_text(f'[measurement]\nkind = "contact"\n[contacts]\ndistance_mm = [{pairs}]\n')
    return path


def test_a_ball_in_sockets_calibrates_an_arm(tmp_path: Path) -> None:
    path = touched(tmp_path, SOCKETS, sigma=2e-6, seed=1)
    result = dc.identify(tmp_path / "robot.toml", path, output=tmp_path / "result.json")
    assert result["model"] == "serial/dh"
    assert result["train_rms_mm"] < 0.01
    at = {c["name"]: np.array(c["position_mm"]) for c in result["contacts"]}
    words = result.to_json()
    assert "where the touched points lie are one number in these readings" in words
    assert "instrument stands" not in words  # there is none, nor one that reads rotations
    assert "the platform's rotation" not in words
    for name in SOCKETS:
        if name.endswith("0"):
            assert np.linalg.norm(at[name] - at[name[:-1] + "1"]) == pytest.approx(50.0, abs=1e-9)
    # the arm's place on the table is not seen, distances between sockets are
    across = np.linalg.norm(at["front0"] - at["left0"])
    assert across == pytest.approx(np.linalg.norm(np.subtract(SOCKETS["front0"], SOCKETS["left0"])), abs=0.05)
    elsewhere = touched(tmp_path, {"new0": (200.0, 400.0, 300.0), "new1": (200.0, 450.0, 300.0)}, sigma=2e-6, seed=2)
    assert dc.validate(tmp_path / "result.json", elsewhere)["rms_mm"] < 0.02


MISTAKES = {
    "joint 3 counts the other way": lambda q: q * [1, 1, -1, 1, 1, 1],
    "the columns of joints 2 and 3 are exchanged": lambda q: q[:, [0, 2, 1, 3, 4, 5]],
    "the joints are in radians": lambda q: q * DEG,
    "the zero of joint 2 is off by 90 deg": lambda q: q - [0, 90, 0, 0, 0, 0],
    "the distances between contacts are in metres": lambda q: q,
}


@pytest.mark.walk
@pytest.mark.parametrize("words", MISTAKES)
def test_a_mistake_in_joints_that_touched_is_named(tmp_path: Path, words: str) -> None:
    path = touched(tmp_path, SOCKETS, sigma=2e-6, seed=1)
    header, *lines = path.read_text().splitlines()
    names, q = zip(*(line.split(",", 1) for line in lines), strict=True)
    changed = MISTAKES[words](np.array([row.split(",") for row in q], dtype=float))
    rows = (f"{n}," + ",".join(map(repr, map(float, row))) for n, row in zip(names, changed, strict=True))
    path.write_text("\n".join([header, *rows]) + "\n")
    if "metres" in words:
        said = path.with_suffix(".toml")
        said.write_text(said.read_text().replace("50.0", "0.05"))
    with pytest.raises(InputError, match=f"agree with it if .*{words}"):
        dc.identify(tmp_path / "robot.toml", path, output=tmp_path / "result.json")


def test_what_to_touch_next_are_the_points_that_were_touched(tmp_path: Path) -> None:
    """A diagnosis of contacts with a question left open was refused: nothing could be read at poses drawn anywhere."""
    two = {name: SOCKETS[name] for name in ("front0", "front1")}
    path = touched(tmp_path, two, sigma=2e-6, seed=5)
    r, made = robot(), read_recording(path, mechanism_of(robot()))
    at = fit(pose_problem(r, made, mechanism_of(r).model("serial/dh")), Prior(), must_converge=False)
    found = candidates(at, [blank("transmission_eccentricity", (3,), (7.0,))], np.random.default_rng(0))
    assert len(found.ends) > 100
    taken = found.problem.recording
    m = mechanism_of(r)
    x, _ = m.forward(r.joint_sign * taken.joints, r.tool, m.rows(r, at.errors[: len(m.parameters)]))
    for point in at.instrument.kind.points(at.instrument, made):
        own = found.ends[taken.contact[found.ends[:, 0]] == point.name, 0]
        assert len(own) > 20
        assert np.abs(x[own, :3] - point.position_mm).max() < 0.01
    assert found.to_rows([0])[0]["contact"] in two


def test_contacts_count_in_millimetres_and_lose_no_target(tmp_path: Path, run: Run) -> None:
    """Figures stood in `contact`, and rows that belong to other sockets were said to repeat the reading before."""
    path = touched(tmp_path, {n: SOCKETS[n] for n in ("front0", "left0", "high0")}, sigma=2e-6, seed=6)
    path.with_suffix(".toml").unlink()
    _, out, _ = run("identify", tmp_path / "robot.toml", path)
    assert " mm, held-out" in " ".join(out.split())
    lines = path.read_text().splitlines()
    names = [line.partition(",")[0] for line in lines[1:]]
    mixed = np.random.default_rng(7).permutation(names)
    wrong = [f"{n},{line.partition(',')[2]}" for n, line in zip(mixed, lines[1:], strict=True)]
    path.write_text("\n".join([lines[0], *wrong]) + "\n")
    code, _, err = run("identify", tmp_path / "robot.toml", path)
    assert code == 3
    assert "lost its target" not in err


def test_a_point_that_is_read_once_has_no_place_of_its_own(tmp_path: Path) -> None:
    """What a camera in the hand sees of a ball is another point at each pose: each would explain its reading."""
    path = touched(tmp_path, {n: SOCKETS[n] for n in ("front0", "front1")}, sigma=2e-6, seed=8)
    made = read_recording(path, mechanism_of(robot()))
    for poses, tested in ((1, False), (20, True)):
        tool = robot().tool + np.repeat(np.arange(made.n_rows // poses), poses)[:, None]
        problem = pose_problem(robot(), dataclasses.replace(made, tool=tool), mechanism_of(robot()).model("serial/dh"))
        assert ("instrument_offset" in {t.effect for t in library(problem)[0]}) == tested


def test_contacts_need_their_names(tmp_path: Path) -> None:
    path = touched(tmp_path, {"a0": (430.0, 60.0, 120.0), "a1": (430.0, 110.0, 120.0)}, sigma=0.0, seed=3)
    path.with_suffix(".toml").write_text(
        '[measurement]\nkind = "contact"\n[contacts]\ndistance_mm = [["a0", "b", 50.0]]\n'
    )
    with pytest.raises(InputError, match="'b'"):
        read_recording(path, mechanism_of(robot()))


def test_a_part_that_touches_one_of_two_points_knows_no_distance_between_them(tmp_path: Path) -> None:
    path = touched(tmp_path, {"a0": (430.0, 60.0, 120.0), "a1": (430.0, 110.0, 120.0)}, sigma=0.0, seed=3)
    made = read_recording(path, mechanism_of(robot()))
    assert made.contact is not None
    part = made.subset(np.flatnonzero(made.contact == "a0"))
    for recording, ties in ((made, 1), (part, 0)):
        problem = pose_problem(robot(), recording, ())
        assert len(problem.begin(problem.reference).ties) == ties
