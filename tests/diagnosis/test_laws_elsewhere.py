"""A law that one session tells, asked of others: where it holds, how large it is, where it could not be asked."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from deltacal_gen.app import asked as batch_of_laws
from deltacal_gen.app import commands
from deltacal_gen.diagnosis.elsewhere import asked
from deltacal_gen.files.robot import robot_from_dict, robot_to_toml
from deltacal_gen.files.writing import write_recording
from deltacal_gen.machine.values import Recording
from deltacal_gen.pages import report
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, kept_term
from deltacal_gen.results.batch import AskedLaw, AskedOf, Batch, CommonLaw, sizes
from deltacal_gen.results.diagnosis import Law, LawCoefficient, LawTerm
from deltacal_gen.results.reader import read_answer
from tests.machine.test_linear_delta import PRINTER, grid, recording
from tests.physics.test_law_language import LIMB, law
from tests.support.commands import Run
from tests.support.left_out import channels, effect, machine, record

pytestmark = pytest.mark.usefixtures("compiled")

N, ROBOT = 60, machine()
FORMULA, SIZE, FROM = "c1*Max(payload - c2, 0)", 3e-4, 1.5


def coefficient(name: str, limb: int | None, value: float, unit: str) -> LawCoefficient:
    return LawCoefficient(name=name, limb=limb, value=value, std=0.01 * value, unit=unit)


def told(expression: str = FORMULA, limb: int = LIMB, **units: str) -> Law:
    """Return a law of a limb's joint as a diagnosis tells it."""
    units = units or {"c1": "rad/kg", "c2": "kg"}
    values = {"c1": SIZE, "c2": FROM}
    own = (coefficient(c, limb if c == "c1" else None, values[c], unit) for c, unit in units.items())
    return Law(
        terms=(LawTerm(target="joint", limbs=(limb,), expression=expression, coefficients=tuple(own)),),
        states=("payload",),
        range={"payload": (0.0, 4.0)},
        share_of_excess=0.9,
        gain=500.0,
        charge=40.0,
        alike=(),
        borne_out=True,
        heldout_rms_mm=0.011,
    )


def session(*terms: Term, payload: bool = True, seed: int = 1, **how: Any) -> Recording:
    of = channels(N, "temp", "time", seed=seed)
    if payload:
        of["payload_kg"] = np.round(np.random.default_rng(seed).uniform(0, 4, N), 2)
    return record(ROBOT, *terms, n=N, seed=seed, of=of, **how)


def truth(size: float = SIZE) -> Term:
    return law(f"joint = {FORMULA}", size, FROM)


def diagnosed(*named: Term, orders: bool = False) -> Any:
    """Return what a recording's own diagnosis says that is asked beside it."""
    seen = object() if orders else None
    return SimpleNamespace(physics=tuple(map(kept_term, named)), seen=seen, baseline=SimpleNamespace(model=None))


def ask(of: Recording, law: Law | None = None, elsewhere: bool = False, own: Any = None) -> AskedOf:
    return asked(ROBOT, of, own or diagnosed(), [law or told()], [elsewhere])[0]


def test_it_holds_where_it_acts_and_its_size_is_fitted_anew() -> None:
    found = ask(session(truth(0.7 * SIZE)))
    assert found.holds
    assert found.limbs == (LIMB,)
    [c] = found.coefficients
    assert (c.name, c.limb, c.unit) == ("c1", LIMB, "rad/kg")
    assert c.std is not None
    assert abs(c.value - 0.7 * SIZE) < 4 * c.std < 0.3 * SIZE
    assert (found.gain or 0) > (found.charge or 0) > 20
    assert (found.heldout_rms_mm or 1) < 0.6 * (found.without_rms_mm or 0)


def test_it_does_not_hold_where_there_is_none_or_something_else() -> None:
    assert ask(session()).holds is False
    other = effect("joint_compliance", (1,), 0.02)
    assert ask(session(other, seed=2), own=diagnosed(other)).holds is False


def test_it_is_asked_beside_what_the_session_names_but_not_beside_itself() -> None:
    other = effect("joint_compliance", (1,), 0.02)
    of = session(truth(), other, seed=3)
    beside = ask(of, own=diagnosed(other, law(f"joint = {FORMULA}", SIZE, 1.4)))
    assert beside.holds
    assert abs(beside.coefficients[0].value - SIZE) < 4 * (beside.coefficients[0].std or 0)


def test_on_another_machine_another_limb_may_have_it() -> None:
    of = session(truth(), seed=4)
    elsewhere = told(limb=1)
    assert ask(of, elsewhere).coefficients[0].value < 0.5 * SIZE
    found = ask(of, elsewhere, elsewhere=True)
    assert found.holds
    assert found.limbs == (LIMB,)
    assert (found.charge or 0) > (ask(of, elsewhere).charge or 0)


def test_distances_are_asked_too() -> None:
    found = ask(session(truth(), seed=5, kind="distance"))
    assert found.holds
    assert abs(found.coefficients[0].value - SIZE) < 4 * (found.coefficients[0].std or 0)


@pytest.mark.parametrize(
    ("expression", "units", "why"),
    [
        ("c1*Max(oil_C - c2, 0)", {"c1": "rad/oil_C", "c2": "oil_C"}, "there is not the column oil_C"),
        ("c1*q_5*payload", {"c1": "1/kg"}, "has a part joint 5; delta has none"),
        ("c1*payload", {"c1": "mm/kg"}, "slide where those of the law turn"),
    ],
)
def test_why_it_could_not_be_asked_is_said_in_words(expression: str, units: dict[str, str], why: str) -> None:
    found = ask(session(), told(expression, **units))
    assert found.holds is None
    assert why in (found.why or "")


def test_a_state_that_stays_and_joints_of_many_orders_say_nothing() -> None:
    absent = ask(session(payload=False))
    assert absent.holds is None
    assert absent.why == "payload is the same at all readings: there is no column payload_kg"
    assert "many orders" in (ask(session(), own=diagnosed(orders=True)).why or "")


def test_a_printer_whose_joints_slide_is_not_asked_of_angles() -> None:
    robot = robot_from_dict(PRINTER)
    of = recording(robot, grid(90, 30))
    loaded = dataclasses.replace(of, channels={"payload_kg": np.arange(len(of.joints)) % 5.0})
    measured = simulate(robot, loaded, {}, noise_mm=0.01, rng=np.random.default_rng(3))
    own = SimpleNamespace(physics=(), seen=None, baseline=SimpleNamespace(model="9"))
    [found] = asked(robot, measured, own, [told()], [True])  # type: ignore[arg-type]
    assert found.holds is None


def said(recording: str, value: float | None, std: float = 1.0, why: str | None = None) -> AskedLaw:
    own = () if value is None else (coefficient("c1", 2, value, "rad/kg").replace(std=std),)
    holds = None if why else value is not None
    return AskedLaw(recording=recording, machine="m", holds=holds, why=why, coefficients=own, limbs=(2,))


def test_sizes_are_compared_with_what_each_session_leaves_open() -> None:
    [alike] = sizes([said("a", 10.0), said("b", 11.0), said("c", 9.5), said("d", None)])
    assert (alike.low, alike.high, alike.recordings, alike.between) == (9.5, 11.0, 3, 0.0)
    assert alike.mean == pytest.approx(np.mean([10.0, 11.0, 9.5]))
    assert alike.limb is None
    rng = np.random.default_rng(1)
    [apart] = sizes([said(str(k), 100 + 5 * v, 1.0) for k, v in enumerate(rng.standard_normal(400))])
    assert apart.between == pytest.approx(np.sqrt(25 - 1), rel=0.15)


def test_it_is_told_where_it_holds_and_where_not() -> None:
    everywhere = [said("a", 10.0), said("b", 11.0), said("c", 9.5), said("d", None), said("e", None, why="no column")]
    whole = CommonLaw(
        law="joint(payload)", recordings=("a", "b"), terms=told().terms, asked=(*everywhere,), sizes=sizes(everywhere)
    )
    words = whole.told()
    assert words[0].endswith("asked as joint = c1*Max(payload - c2, 0) with c2 = 1.5 kg")
    assert words[1] == "it holds in 3 of 4 recordings that could be asked: a, b, c; what is found thrice is physics"
    assert words[2].startswith("c1 from 9.5 to 11 rad/kg (they differ by no more beyond")
    assert words[3:] == ["it does not hold in d", "it could not be asked of e: no column"]
    page = report.batch(Batch(action="diagnose", rows=(), changed=(), laws=(whole,)))
    assert "holds in 3 of 4 recordings" in page


def test_a_batch_asks_the_law_of_one_session_of_all_others(tmp_path: Path, run: Run) -> None:
    shop = tmp_path / "shop"
    for name, of in (("a/s1", session(truth())), ("a/s2", session(seed=2)), ("b/s1", session(payload=False, seed=3))):
        place = shop / f"{name}.csv"
        place.parent.mkdir(parents=True, exist_ok=True)
        (place.parent / "robot.toml").write_text(robot_to_toml(ROBOT))
        write_recording(of, place)
    code, text, errors = run("batch", shop, "-o", tmp_path / "run", "--workers", "1")
    assert code == 0, errors
    words = " ".join(text.split())
    assert "it holds in 1 of 2 recordings that could be asked: a/s1.csv" in words
    assert "does not hold in a/s2.csv" in words
    assert "could not be asked of b/s1.csv: payload is the same at all readings" in words
    found = read_answer(tmp_path / "run" / "batch.json")
    assert isinstance(found, Batch)
    [law] = found.laws
    assert [(a.recording, a.holds) for a in law.asked] == [("a/s1.csv", True), ("a/s2.csv", False), ("b/s1.csv", None)]
    assert [c.name for c in law.asked[0].coefficients] == ["c1"]
    assert "holds in 1 of 2" in (tmp_path / "run" / "index.html").read_text()
    kept = sorted((tmp_path / "run" / "tasks").rglob("*.json"))
    commands.batch(shop, tmp_path / "run", workers=1)  # what was asked is not asked again
    assert sorted((tmp_path / "run" / "tasks").rglob("*.json")) == kept
    assert batch_of_laws.place_of(law.terms[0]) == law.law == "joint(payload)"
