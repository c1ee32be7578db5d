"""Bands of 95 %: of predictions, of commands, over the workspace; what a smaller model leaves out is in them."""

from __future__ import annotations

import csv
import dataclasses
import json
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.errors import InputError
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification import knowledge
from deltacal_gen.identification.identification import identify
from deltacal_gen.identification.knowledge import factor
from deltacal_gen.machine.registry import Machine
from deltacal_gen.machine.rotation import from_vector
from deltacal_gen.machine.values import Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.results.result import Result
from deltacal_gen.use.bands import named, predicted_bands
from deltacal_gen.use.prediction import place_of, predict
from tests.support.commands import Run
from tests.support.left_out import channels, effect, machine, record
from tests.support.prototype import plausible, scattered, wanted

pytestmark = pytest.mark.usefixtures("compiled")

FRAME = (np.array([0.1, -0.2, 0.9]), np.array([900.0, -500.0, 1200.0]))
SIGMA = 0.01  # mm
POSES, NEW, MACHINES = 50, 25, 12


def day(
    robot: Robot, truth: dict[str, float], n: int, seed: int, sigma: float = 0.0, kind: str = "position"
) -> Recording:
    """Return readings of n poses anywhere in the workspace."""
    rng = np.random.default_rng([seed, 3])
    done = simulate(
        robot,
        wanted(scattered(robot, n, seed), kind),
        truth,
        noise_mm=sigma,
        noise_rad=sigma / 500,
        rng=rng,
        frame=FRAME,
    )
    return dataclasses.replace(done, channels={})


def held(result: Result, true: Recording) -> float:
    """Return the part of true readings that lies in the bands of their predictions."""
    ends = predicted_bands(result, true, predict(result, true))
    factors = [np.pi / 180 if name.endswith("_deg") else 1.0 for name in true.columns]
    inside = [
        (ends[low] <= v / f) & (v / f <= ends[high])
        for v, f, (low, high) in zip(true.measured.T, factors, map(named, true.columns), strict=True)
    ]
    return float(np.mean(inside))


@pytest.mark.parametrize(("model", "kind"), [("42", "position"), ("18", "position"), ("3", "position"), ("18", "pose")])
def test_bands_hold_what_is_true_also_where_the_model_leaves_out_most_of_the_machine(
    robot: Robot, mechanism: Machine, model: str, kind: str
) -> None:
    each = []
    for k in range(MACHINES):
        truth = plausible(mechanism, 1000 + k)
        result = identify(robot, day(robot, truth, POSES, k, SIGMA, kind), model).answer()
        each.append(held(result, day(robot, truth, NEW, 5000 + k, kind=kind)))
    assert 0.93 - 0.03 <= np.mean(each) <= 0.99  # of some 900 values, those of a machine not independent


def test_the_map_over_the_workspace_holds_what_a_smaller_model_leaves_out(robot: Robot, mechanism: Machine) -> None:
    inside = []
    for k in range(MACHINES):
        truth = plausible(mechanism, 1000 + k)
        result = identify(robot, day(robot, truth, POSES, k, SIGMA), "18").answer()
        assert result.workspace is not None
        points = np.array([p.target_mm for p in result.workspace.points])
        std = np.array([p.std_mm for p in result.workspace.points])
        true = simulate(robot, wanted(points), truth, frame=FRAME)  # the commands that the drawing has for them
        error = predict(result, dataclasses.replace(true, channels={})).measured - true.measured
        inside.append(np.mean(np.abs(error) < 1.96 * std))
    assert 0.90 <= np.mean(inside) <= 0.99


def test_sizes_of_what_is_left_out_are_those_that_the_readings_show(robot: Robot, mechanism: Machine) -> None:
    truth = plausible(mechanism, 7)  # lengths of ordinary errors, angles of three tenths of them
    known = identify(robot, day(robot, truth, 60, 7, SIGMA), "18").answer().uncertainty
    assert known is not None
    assert known.left_out is not None
    assert known.left_out["mm"] == pytest.approx(1.0, rel=0.5)
    assert 0.1 < known.left_out["deg"] < 0.7
    assert "24 source errors that the model leaves out" in known.text


def test_the_covariance_of_the_full_model_is_kept_as_it_is(robot: Robot, mechanism: Machine) -> None:
    found = identify(robot, day(robot, plausible(mechanism, 3), POSES, 3, SIGMA))
    L, size = factor(found.uncertainty), np.sqrt(np.diag(found.fit.covariance))
    assert (L @ L.T) / np.outer(size, size) == pytest.approx(found.fit.covariance / np.outer(size, size), abs=1e-8)
    assert found.uncertainty.left_out is None


def test_bands_of_a_diagnosis_hold_its_effects(robot: Robot) -> None:
    worn, play = machine(), effect("backlash", (2,), 0.05)
    recording = record(worn, play, of=channels(60, "approach"), seed=4)
    true = record(worn, play, of=channels(40, "approach", seed=6), n=40, seed=77, sigma=0.0)
    found = diagnose(worn, recording).answer()
    assert [e.name for e in found.effects] == ["backlash"]
    ends = predicted_bands(found, true, predict(found, true))
    inside = [
        (ends[f"{a}_lo_mm"] <= v) & (v <= ends[f"{a}_hi_mm"]) for a, v in zip("xyz", true.measured.T, strict=True)
    ]
    assert np.mean(inside) > 0.85
    assert np.median(ends["x_hi_mm"] - ends["x_lo_mm"]) < 4 * SIGMA


def test_a_set_up_that_is_placed_has_wider_bands_that_hold(robot: Robot, mechanism: Machine) -> None:
    truth, inside, wider = plausible(mechanism, 5), [], []
    result = identify(robot, day(robot, truth, 60, 5, SIGMA)).answer()
    elsewhere = (np.array([0.3, 0.2, -0.9]), np.array([-300.0, -500.0, 900.0]))
    for k in range(8):
        rng = np.random.default_rng(k)
        posed = wanted(scattered(robot, 8, 50 + k), setup=["day 2"] * 8)
        other = simulate(robot, posed, truth, noise_mm=SIGMA, rng=rng, frame=elsewhere)
        asked = simulate(robot, wanted(scattered(robot, NEW, 90 + k), setup=["day 2"] * NEW), truth, frame=elsewhere)
        other, asked = (
            dataclasses.replace(r, path=Path(n), channels={}) for r, n in ((other, "o.csv"), (asked, "a.csv"))
        )
        place = place_of(other, asked)
        ends = predicted_bands(result, asked, predict(result, asked, place), place)
        low, high = (np.column_stack([ends[f"{a}_{end}_mm"] for a in "xyz"]) for end in ("lo", "hi"))
        inside.append(np.mean((low <= asked.measured) & (asked.measured <= high)))
        known = dataclasses.replace(asked, setup_names=("1",))
        plain = predicted_bands(result, known, predict(result, known))
        wider.append(np.median(high - low) / np.median(plain["x_hi_mm"] - plain["x_lo_mm"]))
    assert 0.87 <= np.mean(inside) <= 1.0
    assert np.mean(wider) > 1.2


def test_commands_stand_in_their_bands(robot: Robot, mechanism: Machine, tmp_path: Path) -> None:
    truth, targets = plausible(mechanism, 9), scattered(robot, 40, 2)
    result = identify(robot, day(robot, truth, POSES, 9, SIGMA)).answer()
    dc.compensate(result, targets, output=tmp_path / "joints.csv", bands=True)
    with (tmp_path / "joints.csv").open() as file:
        rows = list(csv.DictReader(file))
    q = np.radians([[float(r[f"q{i}_deg"]) for i in (1, 2, 3)] for r in rows])
    assert result.base_frame is not None
    frame = result.base_frame[0]
    turn = from_vector(np.radians(frame.rotation_deg))
    moved = simulate(robot, dataclasses.replace(wanted(targets), joints=q, targets=None), truth, frame=FRAME)
    stands = (moved.measured - frame.origin_mm) @ turn  # in {O} as the instrument sees it
    ends = np.array([[[float(r[f"{a}_{end}_mm"]) for a in "xyz"] for end in ("lo", "hi")] for r in rows])
    assert np.abs(ends.mean(axis=1) - targets).max() < 1e-6
    assert np.mean((ends[:, 0] <= stands) & (stands <= ends[:, 1])) > 0.85


def test_the_commands_write_bands_where_they_are_asked_to(run: Run, tmp_path: Path) -> None:
    folder = example("delta")
    saved, targets, out = tmp_path / "r.json", tmp_path / "t.csv", tmp_path / "out.csv"
    targets.write_text("x_mm,y_mm,z_mm\n0,0,-853\n300,-200,-900\n")
    assert run("identify", folder / "robot.toml", folder / "recording.csv", "--model", "18", "-o", saved)[0] == 0
    code, said, _ = run("predict", saved, folder / "recording.csv", "--bands", "-o", out)
    assert code == 0
    assert "24 source errors that the model leaves out" in " ".join(said.split())
    header = out.read_text().partition("\n")[0].split(",")
    assert header[-6:] == ["x_lo_mm", "x_hi_mm", "y_lo_mm", "y_hi_mm", "z_lo_mm", "z_hi_mm"]
    assert run("compensate", saved, targets, "--bands", "-o", out)[0] == 0
    assert out.read_text().partition("\n")[0].endswith("z_lo_mm,z_hi_mm")
    assert run("compensate", saved, targets, "--bands")[0] == 2
    older = {k: v for k, v in json.loads(saved.read_text()).items() if k != "uncertainty"}
    with pytest.raises(InputError, match="nothing of its uncertainty"):
        dc.predict(older, folder / "recording.csv", bands=True)


def test_bands_of_distances_stand_in_their_file(robot: Robot, mechanism: Machine, tmp_path: Path) -> None:
    truth = plausible(mechanism, 4)
    pairs = np.column_stack(np.triu_indices(20, 1))
    made = simulate(
        robot,
        wanted(scattered(robot, 20, 4), "distance", pairs=pairs),
        truth,
        noise_mm=SIGMA,
        rng=np.random.default_rng(1),
    )
    made = dataclasses.replace(made, channels={})
    true = simulate(robot, wanted(scattered(robot, 20, 8), "distance", pairs=pairs), truth)
    result = identify(robot, made, "18").answer()
    dc.predict(result, dataclasses.replace(true, channels={}), output=tmp_path / "p.csv", bands=True)
    with (tmp_path / "p.csv").open() as file:
        rows = list(csv.DictReader(file))
    low, high = (np.array([float(r[f"distance_{end}_mm"]) for r in rows]) for end in ("lo", "hi"))
    assert true.pair_measured is not None
    assert np.mean((low <= true.pair_measured) & (true.pair_measured <= high)) > 0.85


def test_errors_without_a_unit_are_called_so() -> None:
    """Leads of spindles are numbers; beside them there are mm."""
    said = knowledge._text(
        knowledge._Left(("l_1", "scale_1"), ("mm", "1"), np.ones(2), np.ones((2, 2))), {"mm": 0.5, "1": 2.0}, 0.0
    )
    assert "0.5 times ordinary ones in mm and 2 times ordinary ones without a unit;" in said
