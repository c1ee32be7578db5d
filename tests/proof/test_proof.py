"""The engine of others agrees with the exact kinematics, the cases come from their seeds, and wrong answers fail."""

from __future__ import annotations

import copy
import csv
import dataclasses
import filecmp
import json
import re
import shlex
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from deltacal_gen.files.robot import Robot, robot_from_dict, robot_to_dict
from deltacal_gen.machine.values import Measurement, Recording
from deltacal_gen.pages import manual
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, effect_names
from deltacal_gen.units import DEG
from tests.benchmarks.concealed_cases import MECHANISM, generate, readings
from tests.benchmarks.concealed_grading import oracle
from tests.proof import files, multibody, report
from tests.proof.__main__ import jobs, main
from tests.proof.engines import HAS, by_exudyn, truth_of
from tests.proof.grading import COLUMNS, answer, judge

engine = pytest.mark.skipif(not multibody.available(), reason="Exudyn is not installed: pip install --group dev")
N = 6
TABLES = {
    "robot": {"name": "delta", "mechanism": "delta"},
    "geometry": {
        "base_radius": 200.0,
        "platform_radius": 51.0,
        "proximal_length": 375.0,
        "distal_length": 950.0,
        "joint_spacing": 100.0,
        "tool": [0.0, 0.0, 0.0],
    },
    "masses": {"proximal": 1.2, "proximal_com": 0.4, "distal_rod": 0.15, "platform": 0.8},
}
SIZE = {  # coefficients that move the measured point by some tenths of a millimetre, in the units of the files
    "compliance": 0.01,
    "cos": 0.02,
    "sin": -0.03,
    "scale": 0.001,
    "width": 0.04,
    "drift": 0.005,
    "rate": 0.03,
    "size": 0.03,
    "delay": 0.0005,
    "offset": 0.2,
    "expansion": 2e-5,
}
AGREES = {  # relative to what the effect moves; all others: to 1e-5 of it
    # the engine's frame tilts until weight and spring agree; the effect's moment is taken before it tilts
    "base_compliance": 2e-2,
    # the engine lets a length grow that has its error already
    "thermal_growth": 2e-3,
}


def machine(rng: np.random.Generator, much: float = 1.0) -> tuple[Robot, dict[str, float]]:
    errors = {
        p.name: much * float(rng.standard_normal()) * (0.1 if p.unit == "mm" else 0.05 * DEG)
        for p in MECHANISM.parameters
    }
    return robot_from_dict(copy.deepcopy(TABLES)), errors


def rows(rng: np.random.Generator, kind: str = "position", frame: str = "unknown") -> Recording:
    approach = {f"approach{i}": rng.choice([-1.0, 1.0], N) for i in (1, 2, 3)}
    motion = {f"qd{i}_deg_s": 60 * rng.standard_normal(N) for i in (1, 2, 3)}
    motion |= {f"qdd{i}_deg_s2": 800 * rng.standard_normal(N) for i in (1, 2, 3)}
    return Recording(
        path=Path("recording.csv"),
        kind=kind,
        measurement=Measurement(kind=kind, frame=frame, base_point_mm=(120.0, -80.0, -30.0)),
        joint_unit="rad",
        joints=rng.uniform(-40, 50, (N, 3)) * DEG,
        columns={"gauge": ("gauge_mm",), "distance": ()}.get(kind, ("x_mm", "y_mm", "z_mm"))
        + (("rx_deg", "ry_deg", "rz_deg") if kind == "pose" else ()),
        measured=np.zeros((N, 0)),
        pose=np.array([str(i) for i in range(N)]),
        line=np.arange(N) + 2,
        channels={"time_s": 700.0 * np.arange(N), "temp_C": 20 + 5 * rng.random(N), "payload_kg": 3 * rng.random(N)}
        | approach
        | motion,
        setup=np.zeros(N, dtype=int),
        setup_names=("1",),
        tool=rng.uniform(-40, 40, (N, 3)),
        pairs=np.array([[0, 1], [2, 3], [1, 4], [0, 5]]) if kind == "distance" else None,
        pair_measured=np.zeros(4) if kind == "distance" else None,
        pair_line=np.arange(4) + 2 if kind == "distance" else None,
    )


def term(name: str, poses: Recording) -> Term:
    from deltacal_gen.physics.terms import blank, load_effect

    kernels = load_effect(name)
    constants = {"order": 7.0, "when": 2000.0}
    at = poses.tool[:2].tolist() if name == "instrument_offset" and poses.tool is not None else []
    made = blank(name, (1, 3), [constants[c] for c, *_ in kernels.CONSTANTS], at)
    sizes = [SIZE[c.split("_")[0]] * f for c, _, f, _ in kernels.COEFFICIENTS]
    if name in ("proximal_bending", "distal_compliance"):
        sizes = [0.02]
    if name == "instrument_scale":
        sizes = [200e-6]
    return dataclasses.replace(made, values=np.array(sizes) * np.linspace(1, 1.5, len(made.values))[:, None])


# ------------------------------------------------------------------------------------------------------ the engine


@engine
@pytest.mark.parametrize("gravity", [0.0, -9.81])
@pytest.mark.parametrize("much", [1.0, 20.0])
def test_the_engine_has_the_exact_forward_position(gravity: float, much: float) -> None:
    rng = np.random.default_rng(1)
    robot, errors = machine(rng, much)
    tables = robot_to_dict(robot)
    tables["masses"]["gravity"] = [0.0, 0.0, gravity]
    q, tool = rng.uniform(-40, 60, (20, 3)), rng.uniform(-40, 40, (20, 3))
    delta = multibody.Delta(tables, truth_of(robot, errors, ())["parameters"])
    points, turns = delta.measured(q, tool, {}, np.zeros(20))
    x, status = MECHANISM.forward(q * DEG, tool, MECHANISM.rows(robot, MECHANISM.vector(errors)))
    assert not status.any()
    np.testing.assert_allclose(points, x[:, :3], atol=1e-6)
    assert np.abs(turns - np.eye(3)).max() > 1e-5  # six rods: the platform does turn

    np.testing.assert_allclose(turns, x[:, 3:].reshape(-1, 3, 3), atol=1e-9)


@engine
def test_the_engines_joint_reactions_are_the_static_torques() -> None:
    rng = np.random.default_rng(2)
    robot, errors = machine(rng)
    delta = multibody.Delta(robot_to_dict(robot), truth_of(robot, errors, ())["parameters"])
    q, tool = rng.uniform(-40, 60, (1, 3)), np.array([[10.0, -20.0, -30.0]])
    wanted = robot.masses
    assert wanted is not None
    masses = {k: v for k, v in dataclasses.asdict(wanted).items() if isinstance(v, float)}
    x, _ = MECHANISM.forward(q * DEG, tool, (at := MECHANISM.rows(robot, MECHANISM.vector(errors))))
    torques = MECHANISM.torques(x, q * DEG, tool, at, masses, np.array([0, 0, -9.81]), 2.5)[0] / 1000
    np.testing.assert_allclose(delta.pose(q[0], {"payload_kg": 2.5}, tool[0]).torques, torques, rtol=1e-8)


@engine
@pytest.mark.parametrize("name", HAS["exudyn"])
def test_an_effect_moves_the_engines_machine_as_the_simulator_says(name: str) -> None:
    rng = np.random.default_rng(3)
    robot, errors = machine(rng)
    poses = rows(rng)
    effect = term(name, poses)
    plain, own = (
        simulate(robot, poses, errors, terms=t, rng=np.random.default_rng(7)).measured for t in ([], [effect])
    )
    theirs = by_exudyn(robot, poses, errors, terms=[effect], rng=np.random.default_rng(7)).measured
    moved = np.abs(own - plain).max()
    assert 0.02 < moved < 3.0
    assert np.abs(theirs - own).max() < AGREES.get(name, 1e-5) * moved


@engine
@pytest.mark.parametrize(
    ("kind", "frame"), [("pose", "unknown"), ("position", "robot"), ("distance", "unknown"), ("gauge", "unknown")]
)
def test_every_kind_of_reading_is_made_as_by_the_simulator(kind: str, frame: str) -> None:
    rng = np.random.default_rng(4)
    robot, errors = machine(rng)
    poses = rows(rng, kind, frame)
    effects = [term("joint_compliance", poses), term("instrument_scale", poses)]
    if kind in ("pose", "position"):
        effects.append(term("instrument_drift", poses))
    own = simulate(robot, poses, errors, terms=effects, rng=np.random.default_rng(7))
    theirs = by_exudyn(robot, poses, errors, terms=effects, rng=np.random.default_rng(7))
    # drift and scale act one after the other there, side by side here
    np.testing.assert_allclose(readings(theirs), readings(own), atol=1e-4)


@engine
def test_a_pose_out_of_reach_has_no_equilibrium() -> None:
    short = TABLES | {"geometry": TABLES["geometry"] | {"distal_length": 300.0}}
    with pytest.raises(multibody.NoEquilibriumError, match="out of reach"):
        multibody.Delta(short, {}).pose(np.zeros(3), {}, np.zeros(3))


# ------------------------------------------------------------------------------------------------- files of a case


@pytest.fixture(scope="module")
def concealed() -> files.Concealed:
    case = generate("single", ("backlash",), (11, 1, 4))
    return files.Concealed("c001", "own", case, oracle(case))


@pytest.fixture(scope="module")
def folder(concealed: files.Concealed, tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("proof")
    files.write(concealed, folder)
    return folder


def test_a_case_is_drawn_from_its_seed(tmp_path: Path) -> None:
    job = jobs(4, ["own"], 3)[0]
    from tests.proof.__main__ import conceal

    for part in ("a", "b"):
        conceal(job, tmp_path / part)
    for place in ("cases", "truth"):
        first, again = tmp_path / "a" / place / job[0], tmp_path / "b" / place / job[0]
        names = sorted(p.name for p in first.iterdir())
        assert filecmp.cmpfiles(first, again, names, shallow=False) == (names, [], [])


def test_engines_take_cases_of_their_own_in_turn() -> None:
    work = jobs(40, ["own", "exudyn"], 1)
    assert [name for name, *_ in work] == [f"c{i:03d}" for i in range(1, 41)]
    assert [engine for _, engine, *_ in work[:4]] == ["own", "exudyn", "own", "exudyn"]
    assert len({seed for *_, seed, _ in work}) == 40
    assert work == jobs(40, ["own", "exudyn"], 1)
    assert {kind for _, _, kind, *_ in work} == {"null", "single", "pair", "outside"}


def test_files_hold_the_case_and_the_tool_sees_nothing_of_its_truth(concealed: files.Concealed, folder: Path) -> None:
    read = files.read(folder, "c001")
    assert read.case.names == ("backlash",)
    np.testing.assert_allclose(read.case.terms[0].values, concealed.case.terms[0].values, rtol=1e-12)
    assert read.case.terms[0].limbs == concealed.case.terms[0].limbs
    np.testing.assert_allclose(
        [read.case.errors[p] for p in concealed.case.errors], list(concealed.case.errors.values()), rtol=1e-12
    )
    np.testing.assert_allclose(readings(read.case.exact), readings(concealed.case.exact), rtol=1e-14)
    np.testing.assert_allclose(readings(read.case.fresh), readings(concealed.case.fresh), rtol=1e-14)
    seen = folder / "cases" / "c001"
    text = "".join(p.read_text(encoding="utf-8") for p in sorted(seen.iterdir()))
    assert not any(name in text for name in effect_names())
    assert str(concealed.case.errors["L_1"]) not in text
    with (seen / "fresh.csv").open(encoding="utf-8") as file:
        for row in csv.DictReader(file):
            assert all(row.get(column, "") == "" for column in COLUMNS[concealed.case.recording.kind])


def test_a_tool_runs_among_the_files_of_the_case_alone(folder: Path, tmp_path: Path) -> None:
    tool = tmp_path / "tool.py"
    tool.write_text(
        "import json, os, sys\n"
        "said = {'arguments': sys.argv[1:], 'files': os.listdir()}\n"
        "json.dump(said, open(sys.argv[sys.argv.index('-o') + 1], 'w'))\n",
        encoding="utf-8",
    )
    ran = answer(folder / "cases" / "c001", tmp_path / "out", f"{shlex.quote(sys.executable)} {shlex.quote(str(tool))}")
    assert "failed" not in ran
    said = json.loads((tmp_path / "out" / "diagnosis.json").read_text(encoding="utf-8"))
    assert said["arguments"][:3] == ["diagnose", "robot.toml", "recording.csv"]
    assert {f.split(".")[0] for f in said["files"]} <= {"robot", "recording", "fresh", "diagnosis"}
    tool.write_text("import sys\nsys.exit('no licence')\n", encoding="utf-8")
    ran = answer(folder / "cases" / "c001", tmp_path / "out", f"{shlex.quote(sys.executable)} {shlex.quote(str(tool))}")
    assert ran["failed"] == "diagnose: exit 1: no licence"
    assert not (tmp_path / "out" / "diagnosis.json").exists()


# -------------------------------------------------------------------------------------------------------- grading


def perfect(concealed: files.Concealed) -> dict[str, Any]:
    case, ideal = concealed.case, concealed.ideal
    assert ideal is not None
    effects = []
    for t, std in zip(case.terms, ideal.std, strict=True):
        parameters = [
            {"name": name, "limb": limb, "value": t.values[r, c] / factor, "std": std[r, c] / factor, "unit": unit}
            for r, limb in enumerate(t.limbs or (None,))
            for c, (name, unit, factor, _) in enumerate(t.kernels.COEFFICIENTS)
        ]
        effects.append(
            {"name": t.effect, "limbs": list(t.limbs), "parameters": parameters, "indistinguishable_from": []}
        )
    return {
        "verdict": "missing_physics",
        "noise": {"sigma_mm": case.sigma, "source": "declared"},
        "location": {"channels": [{"name": "approach1", "share": 1.0}], "limbs": list(case.terms[0].limbs)},
        "effects": effects,
        "final": {"chi2_per_dof": 1.0},
        "rejected": [],
    }


def graded(concealed: files.Concealed, said: dict[str, Any], output: Path, shift_mm: float = 0.0) -> dict[str, Any]:
    output.mkdir(exist_ok=True)
    (output / "diagnosis.json").write_text(json.dumps(said), encoding="utf-8")
    columns = COLUMNS[concealed.case.fresh.kind]
    lines = [",".join(repr(float(v + shift_mm)) for v in row[: len(columns)]) for row in readings(concealed.case.fresh)]
    (output / "predicted.csv").write_text("\n".join([",".join(columns), *lines]) + "\n", encoding="utf-8")
    return judge(concealed, output, {"diagnose_s": 1.0})


def test_the_truth_is_the_right_answer(concealed: files.Concealed, tmp_path: Path) -> None:
    entry = graded(concealed, perfect(concealed), tmp_path, shift_mm=1e-3)
    assert entry["right"]
    assert entry["wrong"] == []
    assert max(entry["relative"]) < 1e-12
    assert concealed.ideal is not None
    assert entry["gain"] == pytest.approx(concealed.ideal.geometry / 1e-3)


def other_name(said: dict[str, Any]) -> None:
    said["effects"][0]["name"] = "friction_windup"


def name_too_many(said: dict[str, Any]) -> None:
    said["effects"].append({**said["effects"][0], "name": "joint_scale"})


def nothing(said: dict[str, Any]) -> None:
    said["effects"], said["verdict"] = [], "adequate"


def other_limb(said: dict[str, Any]) -> None:
    entry = said["effects"][0]
    entry["limbs"] = [i for i in (1, 2, 3) if i not in entry["limbs"]] or [1]


@pytest.mark.parametrize("spoil", [other_name, name_too_many, nothing, other_limb])
def test_a_wrong_name_or_limb_is_not_right(
    spoil: Callable[[dict[str, Any]], None], concealed: files.Concealed, tmp_path: Path
) -> None:
    said = perfect(concealed)
    spoil(said)
    entry = graded(concealed, said, tmp_path)
    assert not entry["right"]
    assert entry["wrong"]
    kind = report._answer(entry)
    assert kind == ("silent" if spoil is nothing else "wrong")


def test_a_wrong_value_a_vague_one_and_none_are_flaws(concealed: files.Concealed, tmp_path: Path) -> None:
    for change, flaw in (
        (lambda p: p.update(value=p["value"] + 4 * p["std"]), "z"),
        (lambda p: p.update(std=4 * p["std"]), "times the ideal"),
        (lambda p: p.update(std=None), "no value of backlash.width"),
    ):
        said = perfect(concealed)
        change(said["effects"][0]["parameters"][0])
        assert any(flaw in w for w in graded(concealed, said, tmp_path)["wrong"])


def test_answers_out_of_form_and_none_count_as_wrong(concealed: files.Concealed, tmp_path: Path) -> None:
    entry = graded(concealed, {"verdict": "missing_physics"}, tmp_path)
    assert not entry["right"]
    assert "not a diagnosis" in entry["wrong"][0]
    entry = judge(concealed, tmp_path, {"failed": "diagnose: not done in 300 s"})
    assert not entry["right"]
    assert entry["wrong"] == ["diagnose: not done in 300 s"]
    (tmp_path / "predicted.csv").write_text("distance\n1\n", encoding="utf-8")
    (tmp_path / "diagnosis.json").write_text(json.dumps(perfect(concealed)), encoding="utf-8")
    entry = judge(concealed, tmp_path, {})
    assert any("no prediction" in w for w in entry["wrong"])


def test_table_and_page_say_how_many_were_right(
    concealed: files.Concealed, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    said = perfect(concealed)
    entries = [graded(concealed, said, tmp_path, shift_mm=1e-3)]
    other_limb(said)
    entries.append(graded(concealed, said, tmp_path, shift_mm=1e-3) | {"engine": "exudyn"})
    run = {"seed": 1, "cases": 2, "command": "python -m tests.proof", "engines": {"own": "deltacal_gen"}}
    text = report.markdown(entries, run)
    assert "| one effect | deltacal | 1 | 1 | 0 | 0 |" in text
    assert "| one effect | Exudyn | 1 | 0 | 1 | 0 |" in text
    (tmp_path / "measured").mkdir()
    monkeypatch.setattr(manual, "folder", lambda: tmp_path)
    report.measured(entries, run)
    table = manual.measured("proof_concealed")
    assert table["rows"][0][:5] == ["one effect", "deltacal", "1", "1", "0"]
    assert (table["command"], table["note"]) == (run["command"], "2 cases, seed 1")
    assert "In motion" not in report.page(entries, run)
    moved = {"kind": "1", "machine": "arm", "engine": "mujoco", "verdict": "adequate", "ratio": 1.02, "cpu_s": 4.0}
    blank: dict[str, Any] = {"missed": [], "false": [], "unexplained": [], "off": [["coulomb", 4.0, 1.2]]}
    at_fault = {"seed": 7, "right": False, "true": [["load_friction", 3, {}]], "missed": [["load_friction", 3]]}
    page = report.page(entries, run, [moved | blank | {"seed": 6, "right": True, "true": []}, moved | blank | at_fault])
    assert '<tr><td class="">one</td><td class="n">2</td><td class="n">1</td><td class="n">0</td>' in page
    assert "in motion 7 arm (mujoco) load_friction of joint 3: missed" in page
    assert page.count("<svg") >= 3
    assert "1 of 2 concealed effects named" in page
    assert "prefers-color-scheme" in page
    assert not re.search(r"""(src|href)=["']?http|url\(|@import|<script""", page.replace("url(#", ""))


def test_generate_and_grade_are_steps_of_their_own(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    arguments = ["-o", str(tmp_path), "--cases", "1", "--engine", "own", "--seed", "5", "--jobs", "1"]
    assert main(["generate", *arguments]) == 0
    assert files.names(tmp_path) == ["c001"]
    tool = tmp_path / "tool.py"
    tool.write_text("import sys\nsys.exit('not today')\n", encoding="utf-8")
    assert (
        main(["grade", "-o", str(tmp_path), "--tool", f"{shlex.quote(sys.executable)} {shlex.quote(str(tool))}"]) == 0
    )
    assert "exit 1: not today" in capsys.readouterr().out
    assert (tmp_path / "proof.html").exists()
    with pytest.raises(SystemExit, match="2"):
        main(["grade", "-o", str(tmp_path / "empty")])
    with pytest.raises(SystemExit, match="2"):
        main(["--engine", "adams"])
