"""One axis under a laser: a single measured coordinate, cycles forth and back, reversal and figures of ISO 230-2."""

from __future__ import annotations

import dataclasses
import json
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import minimize

import deltacal_gen as dc
from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.errors import InputError
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import Robot, robot_from_dict, robot_to_toml
from deltacal_gen.identification.identification import identify
from deltacal_gen.instrument.kinds import readings
from deltacal_gen.instrument.kinds.position import read_along
from deltacal_gen.machine.registry import Array, load_mechanism
from deltacal_gen.machine.rotation import from_vector
from deltacal_gen.machine.values import Recording
from deltacal_gen.use import iso230, prediction, validation
from tests.support.commands import Run
from tests.support.open_chains import AXIS

AXIS["joint"][0] |= dict.fromkeys(("a", "alpha", "d", "theta"), 0.0)  # type: ignore[attr-defined]
WIDTH, NOISE = 0.012, 0.001  # mm


@pytest.fixture(scope="module")
def robot() -> Robot:
    return robot_from_dict(AXIS)


def cycles(folder: Path, robot: Robot, column: str, *, sidecar: str = "", warm: float = 0.0) -> Recording:
    """Write and read five cycles along 500 mm, the slide 3 mm off, with a gap where it turns round."""
    rng = np.random.default_rng(1)
    forth = np.arange(0.0, 501.0, 25.0)
    rows, time = [f"cycle,time_s,q1_mm,{column}"], 0.0
    for cycle in range(5):
        for way, stops in ((1, forth), (-1, forth[::-1])):
            for q in stops:
                time += 20.0
                moved = q - way * WIDTH / 2 + warm * (1 - np.exp(-time / 900.0))
                rows.append(f"{cycle},{time},{q},{moved + 3.0 + NOISE * rng.standard_normal():.6f}")
    (folder / "axis.csv").write_text("\n".join(rows) + "\n")
    (folder / "axis.toml").write_text(f'[measurement]\nkind = "position"\nsigma_mm = {NOISE}\n{sidecar}')
    return read_recording(folder / "axis.csv", load_mechanism("serial", robot.links))


def visits(folder: Path, robot: Robot, profile: Array, walk: Array) -> Recording:
    """Write and read five cycles over few positions: a profile that is there each time, and what wanders."""
    places = np.arange(len(profile))
    place = np.tile(np.concatenate([places, places[::-1]]), 5)
    way = np.tile(np.repeat([1, -1], len(places)), 5)
    moved = 2.5 * place + profile[place] + walk
    rows = zip(np.arange(len(place)) // (2 * len(places)), 2.5 * place, way, moved, strict=True)
    lines = [f"{cycle},{q},{w},{x:.8f}" for cycle, q, w, x in rows]
    (folder / "axis.csv").write_text("\n".join(["cycle,q1_mm,approach1,x_mm", *lines]) + "\n")
    return read_recording(folder / "axis.csv", load_mechanism("serial", robot.links))


def test_what_comes_back_at_each_visit_depends_on_where_it_is(robot: Robot, tmp_path: Path) -> None:
    """A screw read once a turn: no smooth function of the way, but no noise that hangs together either."""
    rng = np.random.default_rng(2)
    profile = 0.03 * np.array([1.0, -1.0, 0.5, -0.3, 0.8, -0.9, 0.2, 1.0, -0.7])
    found = diagnose(robot, visits(tmp_path, robot, profile, 0.004 * rng.standard_normal(90))).answer()
    assert found.verdict == "unexplained"
    assert "comes back at each visit of a pose (correlation 0.9" in found.location.text


@pytest.mark.parametrize(("size", "verdict"), [(2.0, "unexplained"), (0.0, "adequate")])
def test_what_few_positions_share_is_no_noise_though_many_readings_hardly_show_it(
    robot: Robot, tmp_path: Path, size: float, verdict: str
) -> None:
    """A fine stage: 50 readings of five positions leave twice the noise that repeats show, or no more than that."""
    noise = 1e-5  # mm
    for seed in range(4):
        rng = np.random.default_rng(seed)
        profile = size * noise * np.array([0.3, 0.1, 0.6, 0.4, -1.4])
        found = diagnose(robot, visits(tmp_path, robot, profile, noise * rng.standard_normal(50))).answer()
        assert found.verdict == verdict
        assert "0.0000 mm" not in found.summary
        if size:
            assert "shared by the readings of a pose" in found.location.text


def both_ways(folder: Path, robot: Robot, profile: Array, gap: float, seed: int) -> Recording:
    """Write and read a profile once forth and once back, with no column but the direction."""
    rng = np.random.default_rng(seed)
    places = np.arange(len(profile))
    place = np.concatenate([places, places[::-1]])
    way = np.repeat([1, -1], len(places))
    moved = 5.0 * place + profile[place] - way * gap / 2 + 1e-4 * rng.standard_normal(len(place))
    lines = [f"{5.0 * k},{w},{x:.6f}" for k, w, x in zip(place, way, moved, strict=True)]
    (folder / "ways.csv").write_text("\n".join(["q1_mm,approach1,x_mm", *lines]) + "\n")
    return read_recording(folder / "ways.csv", load_mechanism("serial", robot.links))


@pytest.mark.walk
def test_a_profile_that_comes_back_is_no_noise_however_few_visits_show_it(robot: Robot, tmp_path: Path) -> None:
    """Ten places forth and back were fewer than tell noise: 12 um that came back to 2 um `looked like noise`."""
    for seed in range(4):
        rough = 0.012 * np.random.default_rng(100 + seed).standard_normal(10)
        found = diagnose(robot, both_ways(tmp_path, robot, rough, 0.0, seed)).answer()
        assert found.verdict == "unexplained"
        assert "shared by the readings of a pose" in found.summary
        plain = diagnose(robot, both_ways(tmp_path, robot, np.zeros(10), 0.0, seed)).answer()
        assert plain.verdict == "adequate"


def test_a_jump_where_the_axis_turned_back_may_be_the_sign_of_a_column(robot: Robot, tmp_path: Path) -> None:
    """Of one way forth and one back a jump between them is all that play of less than nothing does."""
    found = diagnose(robot, both_ways(tmp_path, robot, np.zeros(12), -0.003, 1)).answer()
    assert "It may be backlash" in found.summary
    assert "Indistinguishable at these poses: backlash" not in found.summary
    for effect in found.effects:
        assert "backlash" in effect.indistinguishable_from


def test_an_axis_that_wanders_is_no_want_of_poses(robot: Robot, tmp_path: Path) -> None:
    """Repeats within a few rows show less than all rows do: more poses would not change it."""
    rng = np.random.default_rng(4)
    walk = np.cumsum(0.01 * rng.standard_normal(50))
    found = diagnose(robot, visits(tmp_path, robot, np.zeros(5), walk)).answer()
    assert found.verdict == "adequate"
    assert "correlated over" in found.summary
    assert "too few" not in found.summary


@pytest.mark.parametrize("column", ["x_mm", "z_mm"])
def test_one_coordinate_is_read_along_a_line_that_is_found(robot: Robot, tmp_path: Path, column: str) -> None:
    made = cycles(tmp_path, robot, column)
    assert made.columns == (column,)
    found = readings(made)
    assert found.n_scalars == made.n_rows
    result = identify(robot, made).answer()
    assert result.train_rms_mm == pytest.approx(WIDTH / 2, rel=0.1)
    blank = dataclasses.replace(made, measured=np.full((made.n_rows, 1), np.nan))
    told = prediction.predict(result, blank)
    assert np.abs(told.measured - made.measured).max() < WIDTH


GANTRY = {
    "robot": {"name": "gantry", "mechanism": "serial"},
    "geometry": {"tool": [0.0, 0.0, 0.0]},
    "joint": [{"kind": "prismatic", "a": 0.0, "alpha": alpha, "d": 0.0, "theta": 90.0} for alpha in (90.0, 90.0, 0.0)],
}


@pytest.mark.parametrize("deviations", [0.0, 0.02])
def test_a_surface_that_is_followed_is_one_coordinate_that_stays(tmp_path: Path, deviations: float) -> None:
    """A plate that lies askew, touched or read by a dial: such readings passed for metres, along any line in it."""
    gantry = robot_from_dict(GANTRY)
    rng = np.random.default_rng(6)
    first, second = rng.uniform(0.0, 400.0, (2, 40))
    dial = deviations * rng.standard_normal(40)
    third = 200.0 + 0.05 * first - 0.03 * second + dial * np.sqrt(1 + 0.05**2 + 0.03**2)
    third += NOISE * rng.standard_normal(40)
    rows = (f"{a:.6f},{b:.6f},{c:.6f},{y:.6f}" for a, b, c, y in zip(first, second, third, dial, strict=True))
    (tmp_path / "plate.csv").write_text("\n".join(["q1_mm,q2_mm,q3_mm,z_mm", *rows]) + "\n")
    (tmp_path / "plate.toml").write_text(f"[measurement]\nsigma_mm = {NOISE}\n")
    made = read_recording(tmp_path / "plate.csv", load_mechanism("serial", gantry.links))
    result = identify(gantry, made).answer()
    assert result.train_rms_mm < 1.2 * NOISE
    assert max(abs(p.value) for p in result.parameters) < 0.5  # mm, deg
    (tmp_path / "plate.toml").unlink()
    bare = read_recording(tmp_path / "plate.csv", load_mechanism("serial", gantry.links))
    if not deviations:
        with pytest.raises(InputError, match="folded flat onto it") as told:
            diagnose(gantry, bare)
        assert "sigma_mm" in str(told.value)
        return
    blind = diagnose(gantry, bare).answer()
    assert not blind.effects
    assert "zero of their own" not in repr(blind)


@pytest.mark.parametrize("level", [0.0, 1e-3, 0.3, 1.0, 3.0])
def test_no_other_direction_reads_one_coordinate_better(level: float) -> None:
    rng = np.random.default_rng(7)
    P = rng.standard_normal((30, 3)) * [300.0, 200.0, 5.0] @ from_vector(np.array([0.3, -0.5, 0.2]))
    P -= P.mean(axis=0)
    y = level * P @ np.array([0.6, 0.0, 0.8]) + rng.standard_normal(30)
    y -= y.mean()
    ours = np.square(y - P @ read_along(P, y)).sum()
    tried = rng.standard_normal((20, 3))
    ends = (minimize(lambda n: np.square(y - P @ n / np.linalg.norm(n)).sum(), start).fun for start in tried)
    assert ours <= min(ends) * (1 + 1e-9)


def test_the_gap_at_the_turn_is_named_though_no_column_tells_the_way(robot: Robot, tmp_path: Path) -> None:
    found = diagnose(robot, cycles(tmp_path, robot, "z_mm")).answer()
    assert [e.name for e in found.effects] == ["backlash"]
    (width,) = found.effects[0].parameters
    assert width.std is not None
    assert width.value == pytest.approx(WIDTH, abs=4 * width.std)
    assert found.final.train_rms_mm == pytest.approx(NOISE, rel=0.15)


def test_an_axis_that_warms_up_is_told_without_a_thermometer(robot: Robot, tmp_path: Path) -> None:
    found = diagnose(robot, cycles(tmp_path, robot, "z_mm", warm=0.02)).answer()
    effects = {e.name: {p.name: p for p in e.parameters} for e in found.effects}
    assert effects.keys() == {"backlash", "warm_up"}
    size = effects["warm_up"]["size"]
    assert size.std is not None
    assert size.value == pytest.approx(0.02, abs=4 * size.std)
    assert effects["warm_up"]["time_constant"].value == pytest.approx(900.0, rel=0.2)


def test_in_the_robot_s_frame_nothing_of_the_laser_is_unknown(robot: Robot, tmp_path: Path) -> None:
    made = cycles(tmp_path, robot, "z_mm", sidecar='frame = "robot"\n')
    result = identify(robot, made).answer()
    assert result.instrument.free == ()
    shift = sum(p.value for p in result.parameters if p.name in ("d_1", "tz"))
    assert shift == pytest.approx(3.0, abs=WIDTH)


def test_validation_gives_iso_230_2(robot: Robot, tmp_path: Path) -> None:
    made = cycles(tmp_path, robot, "z_mm")
    done = validation.validate(identify(robot, made).answer(), made).iso230
    assert done is not None
    assert done.poses == 19  # the ends are reached from one side alone
    assert done.B_mm == pytest.approx(WIDTH, abs=4 * NOISE)
    assert done.A_mm > done.E_mm > done.M_mm
    assert done.unit == "mm"
    at = [p.at for p in done.places]
    assert at == sorted(set(at))
    assert max(abs(p.up_mm - p.down_mm) for p in done.places) == pytest.approx(done.B_mm)


def test_a_page_of_a_validation_draws_the_axis_from_both_sides(robot: Robot, run: Run, tmp_path: Path) -> None:
    made = cycles(tmp_path, robot, "z_mm")
    dc.identify(robot, made, output=tmp_path / "r.json")
    code, _, said = run("validate", tmp_path / "r.json", made.path, "--report", tmp_path / "v.html")
    assert code == 0, said
    page = (tmp_path / "v.html").read_text(encoding="utf-8")
    assert "these very readings" not in page  # nothing says of which file they were
    dc.identify(robot, made.path, output=tmp_path / "r.json")
    code, said, _ = run("validate", tmp_path / "r.json", made.path, "--report", tmp_path / "v.html")
    assert code == 0
    for text in (said, (tmp_path / "v.html").read_text(encoding="utf-8")):
        assert "made of these very readings: they are no check of it" in " ".join(text.split())
    again = dc.validate(tmp_path / "r.json", made.path)
    assert again.seen
    figures = again.iso230
    assert figures is not None
    for words in ("ISO 9283, 21 poses", "ISO 230-2, 19 positions", "downwards", f"{figures.B_mm:.4f}", "<svg"):
        assert words in page
    assert "http" not in page.replace("http://www.w3.org", "")
    picture = dc.plot(dc.validate(tmp_path / "r.json", made.path))
    assert [line.get_label() for line in picture.axes[0].get_lines()][:3] == ["upwards", "downwards", "mean of both"]


def by_hand(values: Array) -> tuple[float, ...]:
    """Return A, E, R, B, M of values (positions, 2, cycles), position by position."""
    up, down = values[:, 0], values[:, 1]
    tops, ends, repeated, reversal, middle = [], [], [], [], []
    for u, d in zip(up, down, strict=True):
        (mu, su), (md, sd) = ((np.mean(v), np.std(v, ddof=1)) for v in (u, d))
        tops += [mu + 2 * su, md + 2 * sd]
        ends += [mu - 2 * su, md - 2 * sd]
        reversal.append(abs(mu - md))
        repeated.append(max(2 * su + 2 * sd + abs(mu - md), 4 * su, 4 * sd))
        middle.append((mu + md) / 2)
    means = [np.mean(v) for v in (*up, *down)]
    return (
        max(tops) - min(ends),
        max(means) - min(means),
        max(repeated),
        max(reversal),
        max(middle) - min(middle),
    )


def test_the_figures_are_those_of_the_standard() -> None:
    values = np.random.default_rng(2).standard_normal((4, 2, 5))
    position = np.repeat(np.arange(4), 10)
    way = np.tile(np.repeat([1.0, -1.0], 5), 4)
    found = iso230.axis(values.ravel(), position, way)
    assert found is not None
    assert found[3:] == pytest.approx(by_hand(values))
    assert found.means == pytest.approx(values.mean(axis=2))
    assert iso230.axis(values.ravel(), position, np.ones(40)) is None


def test_without_a_clock_a_time_constant_counts_in_the_column_that_counts_on(
    robot: Robot, run: Run, tmp_path: Path
) -> None:
    """Cycles are counted, no time was logged: simulated by a truth that says so, and found so."""
    forth = np.arange(0.0, 501.0, 25.0)
    stops = np.concatenate([forth[1:], forth[::-1][1:]])
    rows = ["cycle,q1_mm", *(f"{cycle},{q}" for cycle in range(8) for q in stops)]
    (tmp_path / "robot.toml").write_text(robot_to_toml(robot))
    (tmp_path / "poses.csv").write_text("\n".join(rows) + "\n")
    (tmp_path / "truth.toml").write_text(
        '[[effects]]\nname = "warm_up"\nlimb = 1\nsize = 0.03\ntime_constant = 1.5\nper = "cycle"\n'
    )
    files = tmp_path / "robot.toml", tmp_path / "poses.csv"
    made = "-o", tmp_path / "read.csv", "--truth", tmp_path / "truth.toml", "--noise", NOISE
    assert run("simulate", *files, *made)[0] == 0
    text = (tmp_path / "read.csv").read_text().splitlines()
    keep = [k for k, name in enumerate(text[0].split(",")) if name in ("cycle", "q1_mm", "z_mm")]
    (tmp_path / "read.csv").write_text("\n".join(",".join(row.split(",")[k] for k in keep) for row in text) + "\n")
    found = diagnose(robot, read_recording(tmp_path / "read.csv", load_mechanism("serial", robot.links))).answer()
    (effect,) = found.effects
    assert effect.name == "warm_up"
    by_name = {p.name: p for p in effect.parameters}
    assert by_name["per"].value == "cycle"
    assert by_name["time_constant"].unit == "cycle"
    assert by_name["size"].value == pytest.approx(0.03, abs=4 * (by_name["size"].std or 0.0))
    assert by_name["time_constant"].value == pytest.approx(1.5, abs=4 * (by_name["time_constant"].std or 0.0))


def test_an_axis_is_planned_in_cycles_forth_and_back(run: Run, tmp_path: Path) -> None:
    bounded = dict(AXIS) | {"joints": {"limits_mm": [[0.0, 3000.0]]}}
    robot, file, plan = robot_from_dict(bounded), tmp_path / "robot.toml", tmp_path / "rows.csv"
    file.write_text(robot_to_toml(robot))
    code, text, said = run("plan", file, "-o", plan, "--cycles", 4)
    assert code == 0, said
    assert "15 positions" in text
    rows = np.genfromtxt(plan, delimiter=",", names=True)
    assert rows.dtype.names == ("pose", "q1_mm", "z_mm", "cycle", "approach1")
    ways, counts = np.unique(np.column_stack([rows["q1_mm"], rows["approach1"]]), axis=0, return_counts=True)
    assert len(ways) == 30
    assert set(counts.tolist()) == {4}
    steps = np.diff(np.unique(ways[:, 0]))
    assert np.ptp(steps) > 0.25 * steps.mean()  # no period of the drive fits all of them
    (tmp_path / "play.toml").write_text('[[effects]]\nname = "backlash"\nlimb = 1\nwidth = 0.01\n')
    simulated = ("-o", tmp_path / "read.csv", "--truth", tmp_path / "play.toml", "--noise", 0.001)
    assert run("simulate", file, plan, *simulated)[0] == 0
    found = diagnose(robot, read_recording(tmp_path / "read.csv", load_mechanism("serial", robot.links))).answer()
    (effect,) = found.effects
    assert effect.name == "backlash"
    assert effect.parameters[0].value == pytest.approx(0.01, abs=4 * (effect.parameters[0].std or 0.0))
    assert found.final.train_rms_mm == pytest.approx(0.001, rel=0.2)  # the laser is laid along the axis
    suspected = ("--suspect", tmp_path / "play.toml", "--diagnoses", 1, "--trials", 200, "--workers", 1, "--json")
    told = json.loads(run("study", file, "--plan", plan, "--noise", 0.001, *suspected)[1])
    assert [s["named_right"] for s in told["suspects"]] == [1, 1]
    ratio = {p["name"]: p["std"] / p["predicted_std"] for p in told["parameters"]}
    assert ratio == pytest.approx(dict.fromkeys(ratio, 1.0), abs=0.2)  # coordinates that nobody reads tell nothing


def test_what_an_axis_cannot_be_planned_by_is_refused(run: Run, robot: Robot, tmp_path: Path) -> None:
    (tmp_path / "robot.toml").write_text(robot_to_toml(robot))
    assert "how far the joints go" in run("plan", tmp_path / "robot.toml")[2]
    bounded = robot_from_dict(dict(AXIS) | {"joints": {"limits_mm": [[0.0, 300.0]]}})
    (tmp_path / "robot.toml").write_text(robot_to_toml(bounded))
    assert "--optimal means nothing here" in run("plan", tmp_path / "robot.toml", "--optimal", 5)[2]
    assert "from 2 positions" in run("plan", tmp_path / "robot.toml", "--cycles", 1)[2]


def test_validation_says_iso_230_2(run: Run, robot: Robot, tmp_path: Path) -> None:
    made = cycles(tmp_path, robot, "z_mm")
    (tmp_path / "result.json").write_text(identify(robot, made).answer().to_json())
    code, text, _ = run("validate", tmp_path / "result.json", tmp_path / "axis.csv")
    assert code == 0
    assert "ISO 230-2, 19 positions from both sides, mm: accuracy A 0.0" in " ".join(text.split())


def test_a_profile_may_be_the_instrument_s(robot: Robot, tmp_path: Path) -> None:
    """What bends along the axis at no period of the drive is one of two, and is said to be."""
    rng = np.random.default_rng(1)
    forth = np.arange(0.0, 501.0, 25.0)
    q = np.tile(np.concatenate([forth[1:], forth[::-1][1:]]), 8)
    bent = 0.01 * np.sin(2 * np.pi * 1.3 * q / 500) + 0.006 * np.sin(2 * np.pi * q / 210)
    read = q + bent + NOISE * rng.standard_normal(len(q))
    rows = ["q1_mm,x_mm", *(f"{a},{b}" for a, b in zip(q.tolist(), read.tolist(), strict=True))]
    (tmp_path / "axis.csv").write_text("\n".join(rows) + "\n")
    (tmp_path / "axis.toml").write_text(f'[measurement]\nkind = "position"\nsigma_mm = {NOISE}\n')
    found = diagnose(robot, read_recording(tmp_path / "axis.csv", load_mechanism("serial", robot.links))).answer()
    assert found.verdict == "unexplained"
    (asked,) = (n for n in found.next_measurements if "profile" in n.why)
    assert "the instrument's own non-linearity" in asked.why
    assert "Turn the instrument round" in asked.text


def test_a_smaller_model_is_offered_only_where_there_is_one(robot: Robot, tmp_path: Path) -> None:
    """A chain has one model: what is left to do is to measure more."""
    made = cycles(tmp_path, robot, "z_mm")
    few = dataclasses.replace(
        made.subset(np.arange(4)), measurement=dataclasses.replace(made.measurement, sigma_mm=None)
    )
    with pytest.raises(InputError, match="Measure more poses") as refused:
        identify(robot, few)
    assert "--model" not in str(refused.value)
