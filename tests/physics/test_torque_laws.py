"""Laws of drives: what a torque has that no registered effect is, written down and predicted."""

from __future__ import annotations

import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import sympy as sp

import deltacal_gen as dc
from deltacal_gen.diagnosis.laws.effect_file import effect_file
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.robot import read_robot
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.motion import laws
from deltacal_gen.motion.fit import fitted
from deltacal_gen.motion.session import Session
from deltacal_gen.motion.trajectories import read, read_sidecar
from deltacal_gen.physics.formula import written as written_unit
from deltacal_gen.physics.grammar import Atom, single
from deltacal_gen.physics.law import load_law
from derive.mathematics.effects import effect as derived
from tests.support.motion_recordings import DEG, NOISE, named, written

Curve = Callable[[np.ndarray, np.ndarray], np.ndarray]  # of states (3, N) of joint 3 and its load (N,) [Nm]
ALWAYS = 4.0  # standard deviations that no number may be off

# what joint 3 has, the expression told, and its numbers in mm, rad, s, N mm
CURVES: dict[str, tuple[Curve, str, list[float]]] = {
    "a stop": (
        lambda s, load: -30.0 * np.maximum(np.abs(s[0]) - 0.15, 0) * np.sign(s[0]),
        "c1*sign(q)*Max(Abs(q) - c2, 0)",
        [-30000.0, 0.15],
    ),
    "a spring that hardens": (
        lambda s, load: 8.0 * np.maximum(s[0] - 0.1, 0) ** 2,
        "c1*Max(q - c2, 0)**2",
        [8000.0, 0.1],
    ),
    "friction of a tight place": (
        lambda s, load: 0.8 * np.sign(s[1]) * np.exp(-(((s[0] - 0.1) / 0.2) ** 2)),
        "c1*sign(qd)*exp(-((q - c2)/c3)**2)",
        [800.0, 0.1, 0.2],
    ),
}


def on_third(curve: Curve) -> Callable[[np.ndarray, np.ndarray], np.ndarray]:
    """Return what the three joints of an arm have where the third has a curve."""
    return lambda s, load: curve(s[:, :, 2], load[:, 2])[:, None] * np.array([0.0, 0.0, 1.0])


@pytest.fixture(scope="module", params=CURVES)
def found(request: Any, tmp_path_factory: Any) -> tuple[str, Path, Any]:
    """Return the name of a curve, a recording that has it, and its diagnosis."""
    folder = tmp_path_factory.mktemp("law")
    path = written(folder, on_third(CURVES[request.param][0]), seed=3)
    return request.param, path, dc.diagnose(folder / "robot.toml", path)


@pytest.mark.walk
def test_a_law_is_told_with_its_numbers_and_by_no_name(found: tuple[str, Path, Any]) -> None:
    name, _, diagnosis = found
    _, expression, numbers = CURVES[name]
    assert (diagnosis["verdict"], named(diagnosis), diagnosis["unexplained"]) == ("missing_physics", {}, [])
    (law,) = diagnosis["laws"]
    (term,) = law["terms"]
    assert (term["target"], term["limbs"], term["expression"]) == ("torque", [3], expression)
    for c, true in zip(term["coefficients"], numbers, strict=True):
        assert 0 < c["std"] < 0.021 * abs(true)
        assert abs(c["value"] - true) < ALWAYS * c["std"] + 0.003 * abs(true), c
    assert [c["limb"] for c in term["coefficients"]] == [3, *[None] * (len(numbers) - 1)]
    assert law["heldout_rms_Nm"] == pytest.approx(NOISE, rel=0.05)
    assert law["gain"] > law["charge"]
    assert diagnosis["location"]["limbs"] == [3]
    assert f"a torque of {expression} (joint 3) with c1 = " in diagnosis["summary"]
    assert diagnosis["final"]["heldout_rms_by_joint"][2] == pytest.approx(NOISE, rel=0.05)
    assert max(r["gain_chi2"] for r in diagnosis["rejected"]) < 20  # beside the law, not before it


@pytest.mark.walk
def test_it_predicts_runs_that_it_has_not_seen(found: tuple[str, Path, Any], tmp_path: Path) -> None:
    name, _, diagnosis = found
    fresh = written(tmp_path, on_third(CURVES[name][0]), runs=2, seed=8)
    kept = tmp_path / "diagnosis.json"
    kept.write_text(diagnosis.to_json())
    assert dc.validate(kept, fresh)["rms_by_joint"][2] == pytest.approx(NOISE, rel=0.1)


@pytest.mark.walk
def test_rows_beyond_where_it_was_found_are_told(found: tuple[str, Path, Any], tmp_path: Path) -> None:
    """Within a recording that it was found in there are none; a joint that goes further has some."""
    _, path, diagnosis = found
    assert dc.validate(diagnosis, path)["outside_law"] == 0
    told: list[str] = []
    assert not dc.predict(diagnosis, path, tell=told.append).outside.any()
    assert told == []
    rows = [line.split(",") for line in path.read_text().splitlines()]
    wide = [rows[0], *([*row[:4], f"{1.2 * float(row[4]):.6f}", *row[5:]] for row in rows[1:])]
    other = tmp_path / "wide.csv"
    other.write_text("\n".join(map(",".join, wide)) + "\n")
    other.with_suffix(".toml").write_text(path.with_suffix(".toml").read_text())
    beyond = int(dc.predict(diagnosis, other, tell=told.append).outside.sum())
    assert 0 < beyond < 1000
    assert told == [
        f"{beyond} of 4800 samples lie outside the range in which the law was found: it goes on for half "
        "of that range, by no more than it varied within, and then stays"
    ]
    assert dc.validate(diagnosis, other)["outside_law"] == beyond


@pytest.mark.walk
def test_it_is_written_as_the_file_of_an_effect_that_says_the_same(found: tuple[str, Path, Any]) -> None:
    _, _, diagnosis = found
    space: dict[str, Any] = {}
    exec(effect_file(diagnosis.laws[0], Path("a_stop.py")), space)
    effect, size = space["EFFECT"], diagnosis.laws[0].terms[0].coefficients[0].value
    assert (list(effect.targets), effect.per_limb) == (["torque"], True)
    q, qd = sp.symbols("q qd", real=True)
    moved = sp.lambdify((q, qd), effect.targets["torque"].subs(effect.coefficients[0].symbol, size))
    curve = diagnosis.laws[0].curve
    assert curve.state == "q"
    np.testing.assert_allclose(moved(np.asarray(curve.at), 0.1), curve.value, rtol=1e-9, atol=1e-9)
    assert derived(effect)  # its functions are there to be emitted


@pytest.mark.walk
@pytest.mark.parametrize(
    ("said", "units", "size"), [(False, ("A/rad", "rad"), -30.0 / 4.0), (True, ("N mm/rad", "rad"), -30e3)]
)
def test_currents_have_laws_in_their_unit(said: bool, units: tuple[str, str], size: float, tmp_path: Path) -> None:
    """And in that of torques where what a drive gives per ampere is known."""
    path, robot = written(tmp_path, on_third(CURVES["a stop"][0]), seed=3), tmp_path / "robot.toml"
    lines = [line.split(",") for line in path.read_text().splitlines()]
    table = np.array(lines[1:], dtype=float)
    table[:, 5:] /= 4.0
    head = ",".join([*lines[0][:5], *(f"current{i}_A" for i in (1, 2, 3))])
    path.write_text("\n".join([head, *(",".join(map(repr, row)) for row in table.tolist())]) + "\n")
    if said:
        robot.write_text(robot.read_text() + "\n[transmission]\ntorque_constant_Nm_A = [4.0, 4.0, 4.0]\n")
    diagnosis = dc.diagnose(robot, path)
    (term,) = diagnosis["laws"][0]["terms"]
    first, second = term["coefficients"]
    assert (first["unit"], second["unit"]) == units
    assert first["value"] == pytest.approx(size, rel=0.01)
    assert diagnosis["laws"][0]["heldout_rms_A"] == pytest.approx(NOISE / 4.0, rel=0.05)


def test_a_load_that_is_read_as_a_current_counts_in_amperes() -> None:
    law = load_law("law torque = c1*qd*exp(-torque/c2)")
    as_current, as_torque = (law.units("rad", read) for read in ("A", "N mm"))
    assert [written_unit(as_current[c]) for c in ("c1", "c2")] == ["s A/rad", "A"]
    assert [written_unit(as_torque[c]) for c in ("c1", "c2")] == ["s N mm/rad", "N mm"]


@pytest.mark.walk
def test_friction_that_the_load_changes_is_not_left_to_the_nearest_effect(tmp_path: Path) -> None:
    """At some loads, not in proportion: it was no noise, and of nothing recorded, beside dry friction."""
    tight = on_third(lambda s, load: 1.5 * np.sign(s[1]) * np.exp(-(((load - 45.0) / 6.0) ** 2)))
    diagnosis = dc.diagnose(tmp_path / "robot.toml", written(tmp_path, tight, runs=6, seed=6))
    (term,) = diagnosis["laws"][0]["terms"]
    assert (term["expression"], named(diagnosis)) == ("c1*sign(qd)*exp(-((torque - c2)/c3)**2)", {})
    assert [c["value"] for c in term["coefficients"]] == pytest.approx([1500.0, 45e3, 6e3], rel=0.01)
    assert diagnosis["final"]["heldout_rms_by_joint"][2] < 1.2 * NOISE


@pytest.mark.walk
def test_what_another_joint_makes_is_no_law_of_its_own(tmp_path: Path) -> None:
    """A cable that the third joint pulls on as the first one turns: nothing that the third has tells it."""
    cable = np.array([0.0, 0.0, 1.0])
    path = written(tmp_path, lambda s, load: 1.5 * np.sin(7.0 * s[0][:, :1]) * cable, seed=4)
    diagnosis = dc.diagnose(tmp_path / "robot.toml", path)
    assert (diagnosis["verdict"], diagnosis["laws"]) == ("unexplained", [])
    assert [u["limb"] for u in diagnosis["unexplained"]] == [3]


@pytest.mark.walk
def test_what_runs_in_is_no_law(tmp_path: Path) -> None:
    """Of the time no law is made: what wanders would be met by any function of it."""
    start = iter(range(100))

    def friction(states: np.ndarray, load: np.ndarray) -> np.ndarray:
        t = (12.0 * next(start) + 0.01 * np.arange(len(load)))[:, None]
        return 0.02 * (1 + np.exp(-t / 15.0)) * states[1] / DEG * np.array([0.0, 1.0, 0.0])

    diagnosis = dc.diagnose(tmp_path / "robot.toml", written(tmp_path, friction, seed=7))
    assert (diagnosis["verdict"], diagnosis["laws"]) == ("unexplained", [])


@pytest.mark.walk
def test_two_sessions_are_compared_by_the_numbers_of_their_laws(found: tuple[str, Path, Any], tmp_path: Path) -> None:
    name, _, diagnosis = found
    other = written(tmp_path, on_third(lambda s, load: 1.2 * CURVES[name][0](s, load)), seed=3)
    again = dc.diagnose(tmp_path / "robot.toml", other)
    moved = dc.compare(diagnosis, again)
    assert [e["name"].rpartition(": ")[2] for e in moved["changed"]] == ["c1_3"]
    assert moved["changed"][0]["after"] == pytest.approx(1.2 * moved["changed"][0]["before"], rel=0.01)


@pytest.mark.walk
def test_it_is_commanded_by_python_and_refused_as_c(found: tuple[str, Path, Any], tmp_path: Path) -> None:
    _, path, diagnosis = found
    kept = tmp_path / "diagnosis.json"
    kept.write_text(diagnosis.to_json())
    commanded, predicted = dc.feed_forward(kept, path).torque, dc.predict(kept, path).readings
    moving = np.isfinite(predicted)
    np.testing.assert_allclose(commanded[moving], predicted[moving], atol=1e-9)
    with pytest.raises(UsageError, match="is a law"):
        dc.export_compensator(kept, output=tmp_path / "drive.c", export="c")


@pytest.mark.walk
@pytest.mark.parametrize("name", ["law torque = c1*Nothing(q)", "law nowhere = c1*q"])
def test_a_law_that_is_none_is_refused(found: tuple[str, Path, Any], tmp_path: Path, name: str) -> None:
    _, path, diagnosis = found
    told = json.loads(diagnosis.to_json())
    told["joints"][2]["terms"][-1]["effect"] = name
    kept = tmp_path / "diagnosis.json"
    kept.write_text(json.dumps(told))
    with pytest.raises(InputError, match=r"diagnosis\.json: '(c1\*Nothing|law nowhere)"):
        dc.validate(kept, path)


@pytest.mark.walk
def test_a_constant_beside_a_law_is_a_part_of_it(tmp_path: Path) -> None:
    """Of a stop that begins at 0.1 rad the other side is as good, with a slope that gravity has, and a constant."""
    stop = on_third(lambda s, load: -20.0 * np.maximum(0.1 - s[0], 0) + 2.0)
    diagnosis = dc.diagnose(tmp_path / "robot.toml", written(tmp_path, stop, seed=5))
    assert (diagnosis["verdict"], named(diagnosis)) == ("missing_physics", {})
    (term,) = diagnosis["laws"][0]["terms"]
    assert term["expression"] == "c1*Max(c3 - q, 0) + c2"
    assert [c["value"] for c in term["coefficients"]] == pytest.approx([-20000.0, 2000.0, 0.1], rel=0.03)


def test_a_term_that_is_nothing_throughout_is_dropped(tmp_path: Path) -> None:
    """By another load on a joint, what begins at a load may begin beyond all of it: it was told with a number of 0."""
    path = written(tmp_path, lambda s, load: 0 * load, seed=3, seconds=6.0)
    robot, said = read_robot(tmp_path / "robot.toml"), read_sidecar(path)
    assert said is not None
    joint = Session.of(robot, read(path, mechanism_of(robot), said)).moving[2]
    beyond, within = (single("q", Atom("Max({0} - q, 0)", (at,), 3)) for at in (-1e3, 0.1))
    limits = {"q": (float(joint.states["q"].min()), float(joint.states["q"].max()))}
    assert laws._alive(fitted(joint, []), (beyond, within), limits) == (within,)


@pytest.mark.parametrize(
    ("form", "friction", "name"), [("sign(qd)", 0.4, "coulomb_friction"), ("Max(q, 0)", 0.0, None)]
)
def test_what_a_registered_effect_says_as_well_is_no_law(
    form: str, friction: float, name: str | None, tmp_path: Path
) -> None:
    """Three movements, each one way, made dry friction of a real arm a law of ``sign(q)``: so few count as three."""

    def added(s: np.ndarray, load: np.ndarray) -> np.ndarray:
        return friction * np.sign(s[1]) + (0.0 if name else 2.0) * np.maximum(s[0], 0.0)

    path = written(tmp_path, added, seed=3, seconds=6.0)
    robot, said = read_robot(tmp_path / "robot.toml"), read_sidecar(path)
    assert said is not None
    joint = Session.of(robot, read(path, mechanism_of(robot), said)).moving[2]
    (state,) = {"q", "qd"} & set(re.findall(r"[a-z]+", form))
    own = single(state, Atom(form, (), 2))
    limits = {state: (float(joint.states[state].min()), float(joint.states[state].max()))}
    fit = fitted(joint, [laws._rung(own, limits)])
    law = laws.Lawful(fit, (own,), limits, 100.0, 20.0, 1.0, 1.0, (), ((1.0,),))
    found = laws.registered(law, None)
    if name is None:
        assert found is None
        return
    assert found is not None
    assert [rung.effect for rung in found.rungs] == [name]
    assert found.coefficients[-1] / 1000 == pytest.approx(friction, rel=0.05)  # N mm
    assert "viscous_friction" not in found.alike[0]
