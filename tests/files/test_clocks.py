"""Two clocks: joints and readings set against each other in time, and readings that come late."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.errors import InputError
from deltacal_gen.files.robot import robot_to_toml
from deltacal_gen.units import DEG
from tests.support.commands import Run
from tests.support.prototype import plausible
from tests.support.two_clocks import (
    DELTA,
    JOINT_STEP,
    NOISE,
    OFFSET,
    RATE,
    ROBOT,
    Motion,
    Q,
    X,
    read_at,
    swings,
    table,
    written,
)

pytestmark = pytest.mark.usefixtures("compiled")


def even(seed: int) -> Motion:
    """Return joints that move on evenly, all of them."""
    return lambda t: DEG * (10 + np.array([1.0, -0.5, 0.7]) * t[:, None])


def circling(seed: int) -> Motion:
    """Return joints that come back after each second and a half."""
    return lambda t: DEG * (15 + 12 * np.sin(2 * np.pi / 1.5 * t[:, None] + np.array([0.0, 2.0, 4.0])))


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(tmp_path_factory.mktemp("clocks"))


@pytest.fixture(scope="module")
def identified(recorded: Path) -> Any:
    return dc.identify(recorded.with_name("robot.toml"), recorded, model="delta/18")


def clocks(found: Any) -> dict[tuple[str, str | None], Any]:
    return {(p["name"], p.get("run")): p for p in found["parameters"] if p["name"].startswith("clock")}


def test_offsets_and_rate_are_found_with_the_geometry(identified: Any) -> None:
    found = clocks(identified)
    truth = {("clock_offset", run): value for run, value in OFFSET.items()} | {("clock_rate", None): RATE}
    assert found.keys() == truth.keys()
    for key, p in found.items():
        assert abs(p["value"] - truth[key]) < max(4 * p["std"], 1e-6), (key, p)
        assert p["unit"] == ("s" if p["name"] == "clock_offset" else "1")
        assert p["name"] == "clock_rate" or (abs(p["value"] - truth[key]) < 0.5e-3 and p["std"] < 0.5e-3)
    assert identified["heldout_rms_mm"] == pytest.approx(NOISE, rel=0.1)
    assert 0 < identified["motion"]["removed"] < 1e-3
    assert identified["motion"]["cutoff_Hz"] > 2


def test_the_fit_is_as_good_as_one_that_knows_the_clocks(recorded: Path, identified: Any, tmp_path: Path) -> None:
    """Positions in motion, of runs that took no part: rms against the truth, beside that of joints known exactly."""
    path = swings(9)
    when = np.arange(0.5, 7.5, 0.01)
    truth = read_at(path(when), plausible(DELTA, seed=3), np.random.default_rng(6))
    t = np.arange(0, 8.0, JOINT_STEP)
    joints = np.round(path(t) / DEG, 4)
    table(tmp_path / "new.csv", ["time_s", *Q], [t, *joints.T])
    table(tmp_path / "new.instrument.csv", ["time_s"], [(when - OFFSET["a"]) / (1 + RATE)])
    said = recorded.with_suffix(".toml").read_text()
    (tmp_path / "new.toml").write_text(said)
    with pytest.raises(InputError, match="in run '1' is not known") as refused:
        dc.predict(identified, tmp_path / "new.csv")
    assert "clock_offset_s" in str(refused.value)
    offset = clocks(identified)["clock_offset", "a"]["value"]
    (tmp_path / "new.toml").write_text(said + f"clock_offset_s = {offset!r}\n")
    dc.predict(identified, tmp_path / "new.csv", output=tmp_path / "predicted.csv")
    cells = [line.split(",") for line in (tmp_path / "predicted.csv").read_text().splitlines()]
    assert cells[0] == ["time_s", *Q, *X]
    assert len(cells) == len(when) + 1
    off = np.array([[float(c) for c in row[4:]] for row in cells[1:]]) - truth
    known = np.column_stack([np.arange(len(when)), path(when) / DEG, truth])
    table(tmp_path / "known.csv", ["pose", *Q, *X], [known[:, 0], *known[:, 1:].T])
    (tmp_path / "known.toml").write_text('[measurement]\nkind = "position"\n')
    ideal = dc.validate(identified, tmp_path / "known.csv")["rms_mm"]
    assert np.sqrt(np.mean(off**2)) < 1.1 * ideal < 1.2 * NOISE


def test_rows_at_which_no_joints_are_known_are_named(recorded: Path, identified: Any, tmp_path: Path) -> None:
    for name in ("recording.csv", "recording.toml"):
        (tmp_path / name).write_text(recorded.with_name(name).read_text())
    (tmp_path / "recording.instrument.csv").write_text("run,time_s\na,1.0\na,7.9\n")
    with pytest.raises(InputError, match="no joints are known") as refused:
        dc.predict(identified, tmp_path / "recording.csv")
    assert (refused.value.line, refused.value.column) == (3, "time_s")


def test_a_result_knows_the_clocks_of_its_runs(recorded: Path, identified: Any, run: Run, tmp_path: Path) -> None:
    assert dc.validate(identified.to_dict(), recorded)["rms_mm"] == pytest.approx(NOISE, rel=0.1)
    (tmp_path / "result.json").write_text(identified.to_json())
    code, out, _ = run("predict", tmp_path / "result.json", recorded, "-o", tmp_path / "predicted.csv", "--json")
    assert code == 0
    lines = (tmp_path / "predicted.csv").read_text().splitlines()
    assert lines[0] == ",".join(["run", "time_s", *Q, *X])
    assert json.loads(out)["figures"]["readings"] == len(lines) - 1
    given = recorded.with_name("recording.instrument.csv").read_text().splitlines()
    assert [line.split(",")[:1] for line in lines] == [line.split(",")[:1] for line in given]


@pytest.mark.parametrize(
    ("clock", "offsets", "rate"),
    [("own, same for all runs", {"a": 0.5, "b": 0.5}, 1e-4), ("own, same rate", {"a": -3.2, "b": 1.1}, 0.0)],
)
def test_what_clocks_have_in_common_is_one_number(
    tmp_path: Path, clock: str, offsets: dict[str, float], rate: float
) -> None:
    path = written(tmp_path, clock=clock, offsets=offsets, rate=rate, seconds=6.0)
    found = clocks(dc.identify(tmp_path / "robot.toml", path, model="delta/18"))
    if clock == "own, same rate":
        assert {run: p["value"] for (_, run), p in found.items()} == pytest.approx(offsets, abs=0.5e-3)
    else:
        assert set(found) == {("clock_offset", None), ("clock_rate", None)}
        assert found["clock_offset", None]["value"] == pytest.approx(0.5, abs=0.5e-3)
        assert found["clock_rate", None]["value"] == pytest.approx(rate, abs=4 * found["clock_rate", None]["std"])


@pytest.mark.parametrize(
    ("motion", "words"),
    [(even, "does not tell its clock|follow the joints|do as well"), (circling, "since the movement repeats itself")],
)
def test_a_movement_that_tells_no_clock_is_refused(tmp_path: Path, motion: Callable[[int], Motion], words: str) -> None:
    path = written(tmp_path, motion, offsets={"a": 0.3}, rate=0.0)
    with pytest.raises(InputError, match=f"cannot be aligned in time: .*({words})"):
        dc.identify(tmp_path / "robot.toml", path, model="delta/18")


def test_readings_of_another_movement_are_refused(tmp_path: Path) -> None:
    path = written(tmp_path, offsets={"a": 0.3})
    (tmp_path / "other").mkdir()
    other = written(tmp_path / "other", offsets={"a": 0.3}, seed=70)
    path.with_name("recording.instrument.csv").write_text(other.with_name("recording.instrument.csv").read_text())
    with pytest.raises(InputError, match="cannot be aligned in time"):
        dc.identify(tmp_path / "robot.toml", path, model="delta/18")


def test_what_is_missing_beside_two_clocks_is_said(tmp_path: Path) -> None:
    path = written(tmp_path, offsets={"a": 0.3}, seconds=3.0)
    beside = path.with_name("recording.instrument.csv")
    text = beside.read_text()
    beside.write_text(text.replace("\na,", "\nc,"))
    with pytest.raises(InputError, match=r"recording\.csv has no run 'c'"):
        dc.identify(tmp_path / "robot.toml", path)
    beside.unlink()
    with pytest.raises(InputError, match=r"there is no recording\.instrument\.csv"):
        dc.identify(tmp_path / "robot.toml", path)


def test_a_simulation_has_the_clock_of_its_truth(tmp_path: Path) -> None:
    path = written(tmp_path, offsets={"a": 0.0}, rate=0.0, seconds=5.0, sidecar='frame = "robot"\n')
    (tmp_path / "truth.toml").write_text("[parameters]\ntheta_1 = 0.05\nclock_offset = 0.037\nclock_rate = 2e-4\n")
    made = tmp_path / "made.csv"
    dc.simulate(tmp_path / "robot.toml", path, output=made, truth=tmp_path / "truth.toml", noise=NOISE)
    assert made.read_text() == path.read_text()
    found = dc.identify(tmp_path / "robot.toml", made, model="delta/3")
    assert clocks(found)["clock_offset", "a"]["value"] == pytest.approx(0.037, abs=0.3e-3)
    assert clocks(found)["clock_rate", None]["value"] == pytest.approx(2e-4, abs=1e-4)


@pytest.mark.parametrize(
    ("kind", "said"),
    [
        ("pose", ""),
        ("gauge", "base_point_mm = [400.0, 100.0, 50.0]\nplatform_point_mm = [0.0, 0.0, 0.0]"),
        ("height", ""),
        ("encoder", 'frame = "robot"'),
    ],
)
def test_every_kind_of_reading_tells_its_clock(tmp_path: Path, kind: str, said: str) -> None:
    path = written(tmp_path, offsets={"a": 0.0}, rate=0.0, seconds=10.0, columns=())
    path.with_suffix(".toml").write_text(f'[measurement]\nkind = "{kind}"\nclock = "own"\n{said}\n')
    (tmp_path / "truth.toml").write_text("[parameters]\nclock_offset = 0.037\nclock_rate = 2e-4\n")
    made = tmp_path / "made.csv"
    dc.simulate(tmp_path / "robot.toml", path, output=made, truth=tmp_path / "truth.toml", noise=NOISE)
    if kind == "pose":  # the platform of this machine does not turn: its turns are noise, and tell no time
        beside, rng = tmp_path / "made.instrument.csv", np.random.default_rng(1)
        head, *rows = (line.split(",") for line in beside.read_text().splitlines())
        turns = 0.003 * rng.standard_normal((len(rows), 3))
        table(beside, head, [*zip(*(row[:-3] for row in rows), strict=True), *turns.T])
    found = clocks(dc.identify(tmp_path / "robot.toml", made, model=None if kind == "encoder" else "delta/3"))
    for (name, _), truth in zip(found, (0.037, 2e-4), strict=True):
        (p,) = (p for key, p in found.items() if key[0] == name)
        assert abs(p["value"] - truth) < 4 * p["std"], (name, p)
        assert p["std"] < 0.2e-3


@pytest.mark.walk
def test_where_nothing_else_is_wrong_nothing_else_is_named(recorded: Path) -> None:
    found = dc.diagnose(recorded.with_name("robot.toml"), recorded)
    assert (found["verdict"], found["effects"]) == ("adequate", [])
    assert clocks(found)["clock_offset", "b"]["value"] == pytest.approx(OFFSET["b"], abs=0.5e-3)
    assert "latency" in {m["name"] for m in found["not_tested"]}


@pytest.mark.walk
@pytest.mark.parametrize("names", [(), ("1", "2"), ("forth", "back")])
def test_readings_that_come_late_need_no_speeds_in_the_file(tmp_path: Path, names: tuple[str, ...]) -> None:
    """One clock: what is read belongs to 12 ms earlier; no qd stands in the file. Runs may have any name, or none."""
    rng, t, rows = np.random.default_rng(8), np.arange(0.5, 6.5 if not names else 3.5, 0.01), list[Any]()
    for seed, name in enumerate(names or ("",), start=2):
        path = swings(seed)
        x = read_at(path(t - 0.012), plausible(DELTA, seed=3), rng)
        rows += [[*([name] if names else []), *row] for row in np.column_stack([t, path(t) / DEG, x])]
    table(tmp_path / "recording.csv", [*(["run"] if names else []), "time_s", *Q, *X], list(zip(*rows, strict=True)))
    (tmp_path / "recording.toml").write_text(f'[measurement]\nkind = "position"\nsigma_mm = {NOISE}\n')
    (tmp_path / "robot.toml").write_text(robot_to_toml(ROBOT))
    found = dc.diagnose(tmp_path / "robot.toml", tmp_path / "recording.csv", model="delta/18")
    assert [(e["name"], e["indistinguishable_from"]) for e in found["effects"]] == [("latency", [])]
    (delay,) = found["effects"][0]["parameters"]
    assert abs(delay["value"] - 0.012) < 4 * delay["std"] < 1e-3


@pytest.mark.walk
def test_a_joint_that_lags_the_others_is_named_and_they_are_not(tmp_path: Path) -> None:
    """The second joint does 15 ms later what is read of it; where all do, that is one delay: see the test before."""
    rng, t, rows = np.random.default_rng(100), np.arange(0.5, 3.5, 0.01), list[Any]()
    for seed, name in enumerate(("1", "2"), start=2):
        path = swings(seed)
        q = np.column_stack([path(t)[:, 0], path(t - 0.015)[:, 1], path(t)[:, 2]])
        x = read_at(q, plausible(DELTA, seed=3), rng)
        rows += [[name, *row] for row in np.column_stack([t, path(t) / DEG, x])]
    table(tmp_path / "recording.csv", ["run", "time_s", *Q, *X], list(zip(*rows, strict=True)))
    (tmp_path / "recording.toml").write_text(f'[measurement]\nkind = "position"\nsigma_mm = {NOISE}\n')
    (tmp_path / "robot.toml").write_text(robot_to_toml(ROBOT))
    found = dc.diagnose(tmp_path / "robot.toml", tmp_path / "recording.csv", model="delta/18")
    assert [(e["name"], e["limbs"]) for e in found["effects"]] == [("joint_latency", [2])]
    (delay,) = found["effects"][0]["parameters"]
    assert abs(delay["value"] - 0.015) < 4 * delay["std"] < 1e-3


@pytest.mark.walk
def test_a_joint_that_twists_with_acceleration_needs_none_in_the_file(tmp_path: Path) -> None:
    """Simulated by exact accelerations, which are then taken out of the file: they come from the joints themselves."""
    t = np.arange(0.0, 3.0, 0.015)
    w, phase = np.array([3.1, 5.3, 8.9])[:, None], np.random.default_rng(4).uniform(0, 6, (3, 3))
    angle = w * t[:, None, None] + phase
    size = np.array([[12.0], [7.0], [4.0]])
    q = 15 + (size * np.sin(angle)).sum(axis=1)
    qd, qdd = (size * w * np.cos(angle)).sum(axis=1), -(size * w**2 * np.sin(angle)).sum(axis=1)
    rates = [f"{word}{i}_{unit}" for word, unit in (("qd", "deg_s"), ("qdd", "deg_s2")) for i in (1, 2, 3)]
    table(tmp_path / "exact.csv", ["time_s", *Q, *rates], [t, *q.T, *qd.T, *qdd.T])
    (tmp_path / "exact.toml").write_text(f'[measurement]\nkind = "position"\nsigma_mm = {NOISE}\n')
    (tmp_path / "robot.toml").write_text(robot_to_toml(ROBOT))
    truth = '[[effects]]\nname = "inertial_deflection"\nlimbs = [1, 2, 3]\ncompliance = 0.05\n'
    (tmp_path / "truth.toml").write_text(truth)
    made = tmp_path / "made.csv"
    dc.simulate(
        tmp_path / "robot.toml", tmp_path / "exact.csv", output=made, truth=tmp_path / "truth.toml", noise=NOISE
    )
    cells = [line.split(",") for line in made.read_text().splitlines()]
    kept = [k for k, name in enumerate(cells[0]) if name not in rates]
    made.write_text("\n".join(",".join(row[k] for k in kept) for row in cells) + "\n")
    found = dc.diagnose(tmp_path / "robot.toml", made, model="delta/3")
    assert [e["name"] for e in found["effects"]] == ["inertial_deflection"]
    for p in found["effects"][0]["parameters"]:
        assert abs(p["value"] - 0.05) < 4 * p["std"] < 0.01, p
