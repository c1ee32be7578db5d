"""The rigid machine by its drives, the ladder of friction, prediction, and what they are told with."""

from __future__ import annotations

import dataclasses
import json
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from jsonschema import Draft202012Validator
from scipy.optimize import nnls

import deltacal_gen as dc
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.identification.accuracy import workspace_of
from deltacal_gen.machine.dynamics import dynamics_of
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.motion import joint, regression
from deltacal_gen.motion.rigid import Rigid, base_of
from deltacal_gen.pages import motion, report
from deltacal_gen.results import published
from deltacal_gen.results.reader import read_answer
from tests.support.commands import Run
from tests.support.every_effect import ARM, LIFT
from tests.support.machines_with_loops import NAMES, machine
from tests.support.motion_recordings import (
    DEG,
    LINKS,
    NOISE,
    STEP,
    Friction,
    carried,
    named,
    planned,
    robot,
    usual,
    written,
)
from tests.support.moving_chains import bodies


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return written(tmp_path_factory.mktemp("usual"), usual)


@pytest.fixture(scope="module")
def diagnosed(recorded: Path) -> Any:
    return dc.diagnose(recorded.with_name("robot.toml"), recorded)


# ------------------------------------------------------------------------------------------------------------- ladder


@pytest.mark.walk
def test_friction_is_named_where_it_is_and_nowhere_else(diagnosed: Any) -> None:
    assert diagnosed["verdict"] == "missing_physics"
    assert named(diagnosed) == {"coulomb_friction": [1, 2], "viscous_friction": [1, 3]}
    truth = {("coulomb", 1): 6.0, ("coulomb", 2): 4.0, ("viscous", 1): 0.15, ("viscous", 3): 0.08}
    for effect in diagnosed["effects"]:
        for p in effect["parameters"]:
            assert abs(p["value"] - truth[p["name"], p["limb"]]) < 4 * p["std"], p
            assert p["std"] < 0.05 * abs(p["value"])
            assert p["unit"] == {"coulomb": "Nm", "viscous": "Nm s/deg"}[p["name"]]


@pytest.mark.walk
def test_drives_of_one_make_have_one_friction(diagnosed: Any, tmp_path: Path) -> None:
    """Surer than that of any joint; where joints differ each has its own alone."""
    assert all("common" not in effect for effect in diagnosed["effects"])
    path = written(tmp_path, lambda states, load: 4.0 * np.sign(states[1]) + 0 * load)
    found = dc.diagnose(tmp_path / "robot.toml", path, report=tmp_path / "page.html")
    (effect,) = found["effects"]
    (common,) = effect["common"]
    assert (effect["name"], effect["limbs"]) == ("coulomb_friction", [1, 2, 3])
    assert (common["name"], common["limb"], common["unit"]) == ("coulomb", None, "Nm")
    assert abs(common["value"] - 4.0) < 4 * common["std"]
    assert common["std"] < min(p["std"] for p in effect["parameters"])
    assert "all alike" in (tmp_path / "page.html").read_text()


@pytest.mark.walk
def test_what_is_left_is_noise_and_told_joint_by_joint(diagnosed: Any) -> None:
    final, before = diagnosed["final"], diagnosed["baseline"]
    assert before["model"] == "serial/rigid"
    assert final["unit_by_joint"] == ["Nm", "Nm", "Nm"]
    assert all(NOISE * 0.95 < v < NOISE * 1.2 for v in final["heldout_rms_by_joint"])
    assert all(v < 0.7 * NOISE for v in final["heldout_rms_by_joint_filtered"])
    assert all(b > 10 * a for a, b in zip(final["heldout_rms_by_joint"], before["heldout_rms_by_joint"], strict=True))
    assert final["heldout_rms_Nm"] == pytest.approx(NOISE, rel=0.1)
    for ladder in diagnosed["ladder"]:
        assert all(rung["buys"] >= 0.02 for rung in ladder["rungs"])


def test_readings_of_other_rows_are_doubted(recorded: Path, tmp_path: Path) -> None:
    found = dc.identify(recorded.with_name("robot.toml"), recorded)
    assert "doubts" not in found
    head, *rows = recorded.read_text().splitlines()
    q, tau = ([",".join(row.split(",")[part]) for row in rows] for part in (slice(0, 5), slice(5, None)))
    mixed = np.random.default_rng(1).permutation(tau)
    (tmp_path / "mixed.csv").write_text("\n".join([head, *map(",".join, zip(q, mixed, strict=True))]) + "\n")
    (tmp_path / "mixed.toml").write_text(recorded.with_suffix(".toml").read_text())
    doubted = dc.identify(recorded.with_name("robot.toml"), tmp_path / "mixed.csv")
    assert "warning: the rigid machine explains next to nothing of what joint" in doubted.headline
    assert "of other rows" in doubted["doubts"][0]


@pytest.mark.walk
def test_a_machine_without_friction_is_adequate(tmp_path: Path) -> None:
    path = written(tmp_path, lambda states, load: 0 * load, seed=1)
    found = dc.diagnose(tmp_path / "robot.toml", path)
    assert (found["verdict"], found["effects"], found["unexplained"]) == ("adequate", [], [])


LAWS: dict[str, tuple[Friction, dict[str, float]]] = {
    "load_friction": (lambda s, load: 0.08 * np.abs(load) * np.sign(s[1]), {"load": 0.08}),
    "rotor_inertia": (lambda s, load: 4e5 * 1e-6 * s[2], {"inertia": 4e5}),
    "torque_offset": (lambda s, load: 2.0 + 0 * load, {"offset": 2.0}),
    "torque_ripple": (
        lambda s, load: 0.7 * np.cos(37 * s[0]) - 0.4 * np.sin(37 * s[0]),
        {"cos": 0.7, "sin": -0.4, "order": 37},
    ),
    "stribeck_friction": (
        lambda s, load: 3.0 * np.sign(s[1]) * (1 + np.exp(-((s[1] / DEG / 6.0) ** 2))),
        {"stribeck": 3.0, "velocity": 6.0},
    ),
    "quadratic_friction": (lambda s, load: 3e-3 * s[1] * np.abs(s[1]) / DEG**2, {"quadratic": 3e-3}),
}


ALIKE = ("quadratic_friction", "rotor_inertia")  # searched as the others are


@pytest.mark.walk
@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.thorough if name in ALIKE else ()) for name in LAWS]
)
def test_every_law_of_one_joint_is_named_with_its_size(tmp_path: Path, name: str) -> None:
    law, truth = LAWS[name]
    on_third = np.array([0.0, 0.0, 1.0])
    path = written(tmp_path, lambda s, load: law(s, load) * on_third, runs=3, seed=2)
    found = dc.diagnose(tmp_path / "robot.toml", path)
    besides = {"coulomb_friction": [3]} if name == "stribeck_friction" else {}
    assert named(found) == {name: [3]} | besides
    for p in next(e for e in found["effects"] if e["name"] == name)["parameters"]:
        allowed = 4 * p["std"] if p["std"] else 0.1 * truth[p["name"]]
        assert abs(p["value"] - truth[p["name"]]) <= allowed + 0.01 * abs(truth[p["name"]]), p


@pytest.mark.walk
def test_currents_tell_torques_where_their_constant_is_known(recorded: Path, diagnosed: Any, tmp_path: Path) -> None:
    constants = np.array([12.0, 8.0, 5.0])  # Nm/A
    lines = [line.split(",") for line in recorded.read_text().splitlines()]
    table = np.array(lines[1:], dtype=float)
    table[:, 5:] /= constants
    header = ",".join([*lines[0][:5], *(f"current{i}_A" for i in (1, 2, 3))])
    path = tmp_path / "recording.csv"
    path.write_text("\n".join([header, *(",".join(map(repr, row)) for row in table.tolist())]) + "\n")
    path.with_suffix(".toml").write_text('[measurement]\nkind = "torque"\n')
    text = recorded.with_name("robot.toml").read_text()
    (tmp_path / "robot.toml").write_text(f"{text}\n[transmission]\ntorque_constant_Nm_A = {constants.tolist()}\n")
    found = dc.diagnose(tmp_path / "robot.toml", path)
    assert named(found) == named(diagnosed)
    for own, other in zip(found["effects"], diagnosed["effects"], strict=True):
        for p, q in zip(own["parameters"], other["parameters"], strict=True):
            assert (p["unit"], p["value"]) == (q["unit"], pytest.approx(q["value"], rel=1e-6))
    assert found["final"]["unit_by_joint"] == ["A", "A", "A"]
    wanted = np.array(diagnosed["final"]["heldout_rms_by_joint"]) / constants
    assert found["final"]["heldout_rms_by_joint"] == pytest.approx(wanted, rel=1e-6)
    assert dc.validate(found.to_dict(), path)["rms_by_joint"] == pytest.approx(wanted, rel=0.3)
    (tmp_path / "robot.toml").write_text(f"{text}\n[transmission]\ntorque_constant_Nm_A = [1.0]\n")
    with pytest.raises(InputError, match="has 1 numbers, and the machine 3 joints"):
        dc.diagnose(tmp_path / "robot.toml", path)


@pytest.mark.walk
def test_a_payload_that_is_not_what_was_written_is_told_with_its_centre(tmp_path: Path) -> None:
    truth = '[[effects]]\nname = "payload_error"\nmass = 0.6\ncom_x = 12.0\ncom_y = -20.0\ncom_z = 30.0\n'
    friction = '[[effects]]\nname = "coulomb_friction"\nlimbs = [2]\ncoulomb = 3.0\n'
    made = carried(tmp_path, truth + friction)
    found = dc.diagnose(tmp_path / "robot.toml", made)
    assert named(found) == {"coulomb_friction": [2], "payload_error": []}
    parameters = {p["name"]: p for p in found["effects"][-1]["parameters"]}
    for name, value in {"mass": 0.6, "com_x": 12.0, "com_y": -20.0, "com_z": 30.0}.items():
        assert abs(parameters[name]["value"] - value) < 4 * parameters[name]["std"], parameters[name]
    assert parameters["mass"]["std"] < 0.03
    assert all(v < 1.15 * NOISE for v in dc.validate(found.to_dict(), made)["rms_by_joint"])
    assert "that is not what was written" in found["summary"]


@pytest.mark.walk
def test_of_several_setups_the_one_that_carries_something_is_told(tmp_path: Path) -> None:
    """One that carries nothing has no centre, and bodies that are free are no more right than those of the file."""
    path, made = (
        planned(tmp_path, '[[effects]]\nname = "payload_error"\nsetup = "loaded"\nmass = 1.5\n'),
        tmp_path / "m.csv",
    )
    head, *rows = path.read_text().splitlines()
    cells = [row.rsplit(",", 1)[0] for row in rows]
    setups = ["loaded" if row.startswith(("2", "3")) else "empty" for row in rows]
    lines = [f"{head},setup", *(f"{own},0.0,{setup}" for own, setup in zip(cells, setups, strict=True))]
    path.write_text("\n".join(lines) + "\n")
    dc.simulate(tmp_path / "robot.toml", path, output=made, truth=tmp_path / "truth.toml", noise=NOISE, seed=3)
    found = dc.diagnose(tmp_path / "robot.toml", made)
    assert named(found) == {"payload_error": []}
    mass, *_ = found["effects"][0]["parameters"]
    assert (mass["name"], mass["setup"]) == ("mass", "loaded")
    assert abs(mass["value"] - 1.5) < 4 * mass["std"] < 0.1
    assert {p["setup"] for p in found["effects"][0]["parameters"]} == {"loaded"}


@pytest.mark.walk
def test_a_delay_is_found_beside_bodies_that_are_known(tmp_path: Path) -> None:
    """Most of the torque is known then: its derivative tells the delay as well."""
    truth = '[[effects]]\nname = "latency"\nlimbs = [2]\ndelay = 0.006\n'
    made = carried(tmp_path, truth + '[[effects]]\nname = "coulomb_friction"\nlimbs = [1, 2]\ncoulomb = 3.0\n')
    found = dc.diagnose(tmp_path / "robot.toml", made)
    assert named(found) == {"coulomb_friction": [1, 2], "latency": [2]}
    (delay,) = found["effects"][-1]["parameters"]
    assert abs(delay["value"] - 0.006) < 4 * delay["std"] < 0.002
    assert found["known"] is not None


@pytest.mark.walk
def test_dry_friction_that_comes_late_is_no_friction_that_builds_up(tmp_path: Path) -> None:
    """20 ms at every reversal look like a way over which friction builds up."""
    path = written(tmp_path, usual, delay=(0.02, 0.0, 0.0))
    found = dc.diagnose(tmp_path / "robot.toml", path)
    assert named(found) == {"coulomb_friction": [1, 2], "viscous_friction": [1, 3], "latency": [1]}
    (delay,) = (p for e in found["effects"] if e["name"] == "latency" for p in e["parameters"])
    assert abs(delay["value"] - 0.02) < 4 * delay["std"] < 0.5e-3


def test_bodies_as_the_file_states_them_leave_the_rotor_its_inertia(tmp_path: Path) -> None:
    """Beside links of unknown inertia nobody tells a rotor; beside known ones its inertia stands by itself."""
    made = carried(tmp_path, '[[effects]]\nname = "rotor_inertia"\nlimbs = [1]\ninertia = 5e5\n')
    found = dc.diagnose(tmp_path / "robot.toml", made)
    assert named(found) == {"rotor_inertia": [1]}
    (inertia,) = found["effects"][0]["parameters"]
    assert abs(inertia["value"] - 5e5) < max(4 * inertia["std"], 5e3)
    assert found["known"]["payloads"] == []


KEYS = {  # of the contract: sections 4 and 6, and 8 of its second part
    "result": "model parameters rank singular_values condition unidentifiable train_rms_Nm heldout_rms_Nm sigma_Nm",
    "diagnosis": "verdict summary noise baseline location effects final rejected next_measurements laws search motion",
}


@pytest.mark.walk
@pytest.mark.parametrize("kind", KEYS)
def test_answers_have_the_keys_of_machines_at_rest(recorded: Path, diagnosed: Any, kind: str, tmp_path: Path) -> None:
    found = diagnosed if kind == "diagnosis" else dc.identify(recorded.with_name("robot.toml"), recorded)
    data = found.to_dict()
    assert data["schema"] == f"deltacal.{kind}/1"
    assert not set(KEYS[kind].split()) - data.keys()
    Draft202012Validator(json.loads((published.FOLDER / f"deltacal.{kind}.1.json").read_text())).validate(data)
    assert type(read_answer(json.loads(json.dumps(data)))) is type(found)
    assert read_answer(json.loads(json.dumps(data))) == data
    assert set(data["motion"]) >= {"cutoff_Hz", "removed"}
    (tmp_path / "found.json").write_text(found.to_json())
    assert dc.validate(tmp_path / "found.json", recorded)["schema"] == "deltacal.validation/1"
    with pytest.raises(InputError, match="of a recording in motion"):
        dc.compensate(found, recorded)


@pytest.mark.walk
def test_what_was_looked_at_and_not_named_is_told(diagnosed: Any) -> None:
    rejected = {r["name"]: r for r in diagnosed["rejected"]}
    assert {"quadratic_friction", "load_friction", "torque_offset", "torque_ripple"} <= set(rejected)
    assert not set(rejected) & set(named(diagnosed))
    for r in rejected.values():
        assert 0.97 < r["heldout_rms_Nm"] / diagnosed["final"]["heldout_rms_Nm"] < 1 + 1e-9
    assert diagnosed["search"]["best"] == "coulomb_friction"
    assert diagnosed["search"]["p_value"] < 1e-12
    assert sum(e["share_of_excess"] for e in diagnosed["effects"]) == pytest.approx(1.0, abs=1e-9)
    location = diagnosed["location"]
    assert location["limbs"] == [1, 2, 3]
    assert location["channels"][0]["name"] in ("speed1", "speed2", "speed3")
    shares = [c["share"] for c in location["channels"]]
    assert shares == sorted(shares, reverse=True)


@pytest.mark.walk
def test_the_page_shows_every_joint_before_and_after(recorded: Path, diagnosed: Any, tmp_path: Path) -> None:
    page = motion.motion(read_answer(diagnosed | {}))  # type: ignore[arg-type]
    assert page.count("<svg") == 1 + 2 * 3  # the ladder; each joint over time, and what is left
    for effect in diagnosed["effects"]:
        for p in effect["parameters"]:
            assert report.measured(p["value"], p["std"]) in page
    for trace in diagnosed["traces"]:
        after = np.array(trace["measured"]) - np.array([np.nan if v is None else v for v in trace["after"]])
        assert np.nanstd(after) == pytest.approx(NOISE, rel=0.15)
        assert np.std(trace["error_before"]) > 5 * np.std(trace["error_after"])
    dc.identify(recorded.with_name("robot.toml"), recorded, report=tmp_path / "result.html")
    text = (tmp_path / "result.html").read_text()
    assert "15 base parameters" in text
    assert "What each term explains" not in text


@pytest.mark.walk
def test_an_answer_in_its_old_form_is_refused(diagnosed: Any) -> None:
    old = diagnosed | {"schema": "deltacal.motion-diagnosis/1"}
    with pytest.raises(InputError, match=r"this version reads deltacal.diagnosis/1\. Run diagnose again"):
        dc.predict(old, "recording.csv")


@pytest.mark.walk
def test_what_changed_between_two_days_is_told_joint_by_joint(tmp_path: Path, diagnosed: Any) -> None:
    path = written(tmp_path, lambda s, load: usual(s, load) + np.array([0.0, 1.0, 0.0]) * np.sign(s[1]), seed=5)
    found = dc.compare(diagnosed, dc.diagnose(tmp_path / "robot.toml", path))
    assert [c["name"] for c in found["changed"]] == ["coulomb_friction coulomb_2"]
    assert found["changed"][0]["change"] == pytest.approx(1.0, abs=4 * found["changed"][0]["std"])


# ------------------------------------------------------------------------------------------------------ the way around


@pytest.mark.walk
def test_a_model_predicts_samples_it_has_not_seen(tmp_path: Path, diagnosed: Any) -> None:
    path = written(tmp_path, usual, runs=1, seed=7, seconds=8.0)
    found = dc.validate(diagnosed.to_dict(), path, report=tmp_path / "validation.html")
    assert all(NOISE * 0.9 < v < NOISE * 1.2 for v in found["rms_by_joint"])
    page = (tmp_path / "validation.html").read_text()
    assert page.count("<svg") == 2 * 3  # of each joint over time, and against what its error may depend on
    assert found.headline in page
    assert "no check of it" not in page
    assert "No sample is judged" not in page
    bare = tmp_path / "bare.csv"
    lines = path.read_text().splitlines()
    bare.write_text("\n".join(",".join(line.split(",")[:5]) for line in lines) + "\n")
    bare.with_suffix(".toml").write_text(path.with_suffix(".toml").read_text())
    dc.predict(diagnosed, bare, output=tmp_path / "predicted.csv")
    cells = [line.split(",") for line in (tmp_path / "predicted.csv").read_text().splitlines()]
    assert cells[0] == ["time_s", "q1_deg", "q2_deg", "q3_deg", "tau1_Nm", "tau2_Nm", "tau3_Nm"]
    known = np.array([[float(c) if c else np.nan for c in row[4:]] for row in cells[1:]])
    wanted = np.array([[float(c) for c in line.split(",")[5:]] for line in lines[1:]])
    assert np.nanstd(known - wanted, axis=0) == pytest.approx(NOISE, rel=0.2)
    assert 0 < np.isnan(known).sum() < 0.1 * known.size  # at rest, where the joints turn back


@pytest.mark.walk
def test_a_validation_says_what_it_is_no_check_of(tmp_path: Path, recorded: Path, diagnosed: Any) -> None:
    dc.validate(diagnosed.to_dict(), recorded, report=tmp_path / "seen.html")
    assert "no check of it" in (tmp_path / "seen.html").read_text()
    head, *lines = recorded.read_text().splitlines()
    first = lines[0].split(",")[2:5]
    still = [",".join([*(c := line.split(","))[:2], *first, *c[5:]]) for line in lines]
    (tmp_path / "still.csv").write_text("\n".join([head, *still]) + "\n")
    (tmp_path / "still.toml").write_text(recorded.with_suffix(".toml").read_text())
    found = dc.validate(diagnosed.to_dict(), tmp_path / "still.csv", report=tmp_path / "still.html")
    assert found.rms_by_joint == (None, None, None)
    page = (tmp_path / "still.html").read_text()
    assert "No sample is judged" in page
    assert "Over time" not in page


def could_be_built(body: np.ndarray) -> bool:
    """Tell whether masses from 0 on can have such a mass, first moments and inertias."""
    m, x, y, z, xx, yy, zz, xy, xz, yz = body
    second = (
        np.array([[yy + zz - xx, -2 * xy, -2 * xz], [-2 * xy, xx + zz - yy, -2 * yz], [-2 * xz, -2 * yz, xx + yy - zz]])
        / 2
    )
    pseudo = np.block([[second, np.array([[x], [y], [z]])], [np.array([[x, y, z, m]])]])
    return bool(np.linalg.eigvalsh(pseudo).min() >= -1e-9 * np.abs(pseudo).max())


@pytest.mark.walk
def test_a_diagnosis_says_what_is_known_of_bodies_beside_the_friction(recorded: Path, diagnosed: Any) -> None:
    rigid, inertia = Rigid(robot()), bodies(LINKS).ravel()
    assert diagnosed["rank"] == len(diagnosed["parameters"]) == rigid.common.rank == 15
    assert 1 < diagnosed["condition"] < 1000
    assert [u["text"] for u in diagnosed["unidentifiable"]] == [u.text for u in rigid.unseen(rigid.common)]
    built = np.array([c["value"] for c in diagnosed["consistent"]])
    assert all(map(could_be_built, built.reshape(3, 10)))
    std = np.array([p["std"] for p in diagnosed["parameters"]])
    off = rigid.common.made_up @ (built - inertia)
    assert np.sqrt(np.mean((off / std) ** 2)) < 3  # friction has not bent them
    assert diagnosed["consistent_off"] < 1
    alone = dc.identify(recorded.with_name("robot.toml"), recorded)
    assert "friction (joint 1, 2, 3) is no part of the rigid machine" in alone["friction"]
    assert "instead of" in alone.headline
    built = np.array([c["value"] for c in alone["consistent"]])
    assert np.sqrt(np.mean((rigid.common.made_up @ (built - inertia) / std) ** 2)) > 30  # of the rigid machine alone


SINCE = (  # of diagnoses that older versions wrote nothing stands in these
    *("rank", "rank_tolerance", "singular_values", "condition", "scaling"),
    *("unidentifiable", "consistent", "consistent_off"),
)


@pytest.mark.walk
def test_a_diagnosis_that_an_older_version_wrote_predicts_the_same(diagnosed: Any, recorded: Path) -> None:
    older = {name: value for name, value in json.loads(json.dumps(diagnosed.to_dict())).items() if name not in SINCE}
    for effect in older["effects"]:
        effect.pop("common", None)
    assert np.array_equal(*(dc.predict(known, recorded).readings for known in (older, diagnosed)), equal_nan=True)
    was, now = (dc.validate(known, recorded) for known in (older, diagnosed.to_dict()))
    assert was["rms_by_joint"] == now["rms_by_joint"]


@pytest.mark.parametrize("name", NAMES)
def test_bodies_of_limbs_could_be_built(name: str) -> None:
    """Masses from 0 on, inertias no smaller than those masses' first moments let them be."""
    dynamics = dynamics_of(machine(name))
    simplest = dynamics.buildable()
    at = {n: k for k, n in enumerate(dynamics.names)}
    made = np.random.default_rng(2).uniform(0, 1, (50, len(simplest))) ** 8 @ simplest
    for body in (*made, *simplest):
        assert (body[[k for n, k in at.items() if not n.startswith("mx_")]] >= 0).all()
        for n, k in at.items():
            if n.startswith("m_arm"):
                first, second = body[at[f"mx{n[1:]}"]], body[at[f"i{n[1:]}"]]
                assert first**2 <= body[k] * second * (1 + 1e-9)
    stated = dynamics.stated(points=True)
    weights, left = nnls((simplest / np.maximum(np.abs(stated), 1.0)).T, stated / np.maximum(np.abs(stated), 1.0))
    assert (weights >= 0).all()
    assert left < 1e-6  # what a file states can be made of them


def test_a_machine_with_limbs_has_bodies_that_could_be_built(tmp_path: Path) -> None:
    """A platform so light beside its rods that noise alone would have it weigh less than nothing."""
    known = machine("linear_delta")
    known = dataclasses.replace(known, errors={}, masses=dataclasses.replace(known.masses, platform=0.001))
    dynamics, rigid = dynamics_of(known), Rigid(known)
    rows, step = [["run", "time_s", *(f"q{i}_mm" for i in (1, 2, 3)), *(f"tau{i}_N" for i in (1, 2, 3))]], 0.01
    t = np.arange(0, 8, step)
    mechanism, rng = mechanism_of(known), np.random.default_rng(0)
    for run in range(3):
        w = 2 * np.pi * np.array([0.3, 0.5, 0.9])
        x = workspace_of(known).box[0] + 30 * np.sin(np.outer(t, w) + rng.uniform(0, 6, 3))
        q, _, status = mechanism.inverse(x, known.tool, mechanism.rows(known))
        assert not status.any()
        states = np.stack([q, np.gradient(q, step, axis=0), np.gradient(np.gradient(q, step, axis=0), step, axis=0)])
        tau = dynamics.torque(states, dynamics.stated()) + 2.0 * np.sign(states[1]) + 0.2 * rng.standard_normal(q.shape)
        rows += [
            [str(run), *(f"{v:.6f}" for v in (n * step, *(known.joint_sign * q[n]), *tau[n]))] for n in range(len(t))
        ]
    path = tmp_path / "recording.csv"
    path.write_text("\n".join(map(",".join, rows)) + "\n")
    path.with_suffix(".toml").write_text('[measurement]\nkind = "torque"\n')
    found = dc.diagnose(known, path)
    assert named(found) == {"coulomb_friction": [1, 2, 3]}
    built = {c["name"]: c["value"] for c in found["consistent"]}
    assert list(built) == list(rigid.names)
    assert all(v >= 0 for v in built.values())
    off = rigid.common.made_up @ (np.array(list(built.values())) - dynamics.stated())
    std = np.array([p["std"] for p in found["parameters"]])
    assert np.sqrt(np.mean((off / std) ** 2)) < 3


def test_the_rigid_machine_has_base_parameters_and_a_consistent_body(tmp_path: Path) -> None:
    path = written(tmp_path, lambda states, load: 0 * load, seed=1)
    found = dc.identify(tmp_path / "robot.toml", path)
    rigid, inertia = Rigid(robot()), bodies(LINKS).ravel()
    truth = rigid.common.made_up @ inertia
    stated = rigid.common.made_up @ np.nan_to_num(dynamics_of(robot()).stated(points=True))
    assert found["rank"] == len(found["parameters"]) == rigid.common.rank == 15
    for p, value in zip(found["parameters"], truth - stated, strict=True):
        assert abs(p["value"] - value) < 5 * p["std"], p
    body = np.array([c["value"] for c in found["consistent"]]).reshape(3, 10)
    assert all(map(could_be_built, body))
    assert "friction" not in found
    near = rigid.common.made_up @ body.ravel()
    std = np.array([p["std"] for p in found["parameters"]])
    assert (np.abs(near - truth) < 8 * std + 1e-3 * np.abs(truth)).all()


@pytest.mark.parametrize("links", [ARM, LIFT])
def test_the_base_has_the_rank_of_the_regressor(links: list[dict[str, Any]]) -> None:
    machine = robot(links)
    rigid, own = Rigid(machine), dynamics_of(machine)
    rng = np.random.default_rng(8)
    Y = own.regressor(
        rng.standard_normal((3, 200, own.joints)) * [150.0 if u == "mm" else 1.0 for u in own.joint_units]
    )
    for j, base in enumerate((*rigid.own, rigid.common)):
        rows = Y[:, j] if j < own.joints else Y.reshape(-1, Y.shape[2])
        sizes = np.linalg.norm(rows, axis=0)
        assert base.rank == np.linalg.matrix_rank(rows / np.where(sizes > 1e-12 * sizes.max(), sizes, np.inf), 1e-9)
        inertia = rng.standard_normal(Y.shape[2])
        by_base = rows[:, base.chosen] @ (base.made_up @ inertia)
        assert by_base == pytest.approx(rows @ inertia, abs=1e-9 * np.abs(rows @ inertia).max())


def test_the_matrix_in_motion_is_the_regressor(run: Run, tmp_path: Path) -> None:
    """Least squares of it is what the rigid machine leaves; its null space moves no torque, and is told in words."""
    files = tmp_path / "robot.toml", written(tmp_path, lambda states, load: 0 * load, runs=2)
    code, out, _ = run("matrix", *files, "--model", "rigid", "-o", tmp_path / "H.npz", "--json")
    told, found = json.loads(out)["figures"], dict(np.load(tmp_path / "H.npz"))
    H, known = found["H"], dc.identify(*files)
    assert code == 0
    assert (told["rows"], told["columns"]) == H.shape == (len(found["r"]), 30)
    assert told["rank"] == known["rank"] == len(found["base"]) == 15
    assert told["condition"] is None
    assert [p["name"] for p in known["parameters"]] == found["base"].tolist()
    X = H[:, [found["names"].tolist().index(name) for name in found["base"]]]
    X /= np.linalg.norm(X, axis=0)
    left = found["r"] - X @ np.linalg.lstsq(X, found["r"])[0]
    assert np.sqrt(np.mean(left**2)) == pytest.approx(NOISE, rel=0.1)
    assert told["unidentifiable"] == [c["text"] for c in known["unidentifiable"]]
    for combination in known["unidentifiable"][1:]:  # each by itself leaves every torque
        terms = [(H[:, found["names"].tolist().index(name)], share) for name, share in combination["terms"].items()]
        assert np.abs(sum(h * share for h, share in terms)).max() < 1e-6 * max(np.abs(h * s).max() for h, s in terms)
    with pytest.raises(UsageError, match="there is the model serial/rigid only"):
        dc.matrix(*files, model="serial/18")
    currents = written(tmp_path, usual, runs=1)
    currents.write_text(currents.read_text().replace("tau1_Nm,tau2_Nm,tau3_Nm", "current1_A,current2_A,current3_A"))
    with pytest.raises(InputError, match="current1_A is no torque"):
        dc.matrix(tmp_path / "robot.toml", currents, model="rigid")


def test_a_base_leaves_out_what_is_never_seen() -> None:
    rng = np.random.default_rng(0)
    Y = rng.standard_normal((30, 4))
    Y[:, 2], Y[:, 3] = 2 * Y[:, 0] - Y[:, 1], 0.0
    found = base_of(Y)
    assert found.chosen.tolist() == [0, 1]
    assert found.made_up == pytest.approx(np.array([[1, 0, 2, 0], [0, 1, -1, 0]]), abs=1e-12)


@pytest.mark.walk
def test_options_of_poses_are_refused(recorded: Path, diagnosed: Any, tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="means nothing for a recording in motion"):
        dc.identify(recorded.with_name("robot.toml"), recorded, as_distance=True)
    with pytest.raises(UsageError, match="there is the model serial/rigid only"):
        dc.identify(recorded.with_name("robot.toml"), recorded, model="serial/dh")
    with pytest.raises(InputError, match="the result is of a recording in motion, and this is none"):
        dc.predict(diagnosed, tmp_path / "poses.csv")


# ------------------------------------------------------------------------------------------------------ what is counted


def test_whole_runs_are_held_out_or_stretches_with_gaps() -> None:
    time, run = np.tile(np.arange(0, 20, STEP), 3), np.repeat([0, 1, 2], 2000)
    used = np.ones(6000, dtype=bool)
    assert all((each == run).all() for each in regression.folds_of(time, run, used))
    found, held = regression.folds_of(time[:2000], run[:2000], used[:2000])
    changes = np.flatnonzero(np.diff(found) != 0)
    for a, b in pairwise(changes):
        assert (b - a) * STEP >= (0.58 if found[b] == regression.BETWEEN else 0.99)
        assert found[b] != found[b + 1]
    assert set(found.tolist()) == {-1, 0, 1, 2, 3, 4}
    assert (held >= 0).all()
    for fold in range(5):
        fitted, apart = time[:2000][(found >= 0) & (found != fold)], time[:2000][held == fold]
        assert np.abs(fitted[:, None] - apart).min() >= regression.GAP - 1e-9


def test_samples_that_hang_together_are_counted_as_one() -> None:
    rng, rho = np.random.default_rng(3), 0.9
    white = rng.standard_normal(20_000)
    red = np.zeros_like(white)
    for n in range(1, len(red)):
        red[n] = rho * red[n - 1] + white[n]
    piece, used = np.zeros(len(red), dtype=int), np.ones(len(red), dtype=bool)
    assert regression.together(white, piece, used, STEP) == pytest.approx(1.0, abs=0.1)
    assert regression.together(red, piece, used, STEP) == pytest.approx((1 + rho) / (1 - rho), rel=0.15)


@pytest.mark.walk
def test_samples_at_rest_take_no_part(diagnosed: Any) -> None:
    below = diagnosed["motion"]["at_rest_below"]
    assert all(0.1 < v < 1.0 for v in below)
    assert all(0 < n < 0.1 * 4800 for n in diagnosed["motion"]["at_rest"])
    assert joint.AT_REST == 0.01


def test_a_dimension_that_cannot_be_is_said(tmp_path: Path, recorded: Path) -> None:
    (tmp_path / "robot.toml").write_text(
        recorded.with_name("robot.toml").read_text().replace("alpha = ", "alpha = 1e300\n# ", 1)
    )
    with pytest.raises(InputError, match="a dimension cannot be"):
        dc.identify(tmp_path / "robot.toml", recorded)
