"""The table of states and every effect on it: references by hand in NumPy and C, what the reader makes of a state."""

from __future__ import annotations

import ctypes
import dataclasses
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import deltacal_kernels
import numpy as np
import pytest
import sympy as sp

import derive.language.states as language
from deltacal_gen import states
from deltacal_gen.diagnosis import library
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.motion import library as motion_library
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.channels import Channels
from deltacal_gen.physics.terms import Constant, Term, blank, drive_effect_names, effect_names, load_effect, scaled
from deltacal_gen.units import DEG, joint_names
from deltacal_gen.use.compensation import Compensator
from deltacal_gen.use.exporters.c import export_c
from deltacal_gen.use.spans import Spans
from derive import compiler
from derive.effects import constant, covariate, joint_coefficient, state
from derive.effects.joint_compliance import EFFECT as SPRING
from derive.effects.latency import EFFECT as LATENCY
from derive.language.effects import IN_MOTION, IN_POSES, Effect, Orders, Points, Reference, Travels
from derive.language.memory import Memory
from tests.support.every_effect import body_of, channels, declared, machines

COMPILER = shutil.which("gcc") or shutil.which("cc") or shutil.which("clang")
EVERY = (*effect_names(), *drive_effect_names())
CASES = [(name, n) for name in EVERY for n in range(len(declared(name).tests))]
KERNELS = Path(deltacal_kernels.__file__).parent / "effects"
WITH_C = [name for name in EVERY if (KERNELS / f"{name}.c").exists()]


# --- the table --------------------------------------------------------------------------------------------------------


def test_the_runtime_reads_the_table_as_it_is_declared() -> None:
    assert list(states.STATES) == list(language.STATES)
    for name, row in language.STATES.items():
        read = states.STATES[name]
        assert {field: getattr(read, field) for field in row.row} == row.row
    for s in states.STATES.values():
        assert all(states.STATES[other].kind == "channel" for other in s.made_of), s.name


@pytest.mark.parametrize("name", EVERY)
def test_every_state_that_an_effect_reads_has_a_row(name: str) -> None:
    kernels = load_effect(name)
    assert [s.name for s in declared(name).states] == list(kernels.STATE)
    for s in states.read_by(kernels):
        assert s.base in states.STATES or s.kind == "channel", f"{name} reads {s.name}, which no column could be"
        assert s.meaning


OF_CHAINS = ("foot", "slides", *(name for name in states.STATES if name.startswith("on_")))


@pytest.mark.parametrize(
    "s", [s for s in states.STATES.values() if s.kind != "reading" and not s.by], ids=lambda s: s.name
)
def test_some_machine_has_every_state(s: states.State) -> None:
    body = next(body_of(m, 5) for m in machines() if mechanism_of(m).linked == (s.name in OF_CHAINS))
    x, _ = body.mechanism.forward(body.q, body.tool, rows := body.mechanism.rows(body.robot))
    found = body.state([s.name], x, body.q, rows)
    own = s.per in ("joint", "limb")
    assert found[s.name].shape == ((5, body.mechanism.limbs) if own else (5,))
    assert np.isfinite(found[s.name]).all()
    if s.per == "joint":
        other = body.state([f"{s.name}_2"], x, body.q, rows)
        assert np.array_equal(other[f"{s.name}_2"], found[s.name][:, 1])


def test_states_of_the_measured_point_are_where_it_is() -> None:
    body = body_of(machines()[0], 5)
    x, _ = body.mechanism.forward(body.q, body.tool, rows := body.mechanism.rows(body.robot))
    found = body.state(["x", "y", "z", "radius"], x, body.q, rows)
    assert np.column_stack([found[a] for a in "xyz"]) == pytest.approx(x[:, :3])
    assert found["radius"] == pytest.approx(np.hypot(x[:, 0], x[:, 1]))


def test_temperature_is_as_recorded_and_warming_over_20_degrees() -> None:
    robot = machines()[0]
    known = Channels.from_columns({"temp_C": np.array([18.0, 31.5])}, (2, 3), robot)
    assert known.get("temperature") == pytest.approx([18.0, 31.5])
    assert known.get("warming") == pytest.approx([-2.0, 11.5])
    assert known.get("time") is None
    assert known.payload == pytest.approx([0.0, 0.0])


def test_a_column_tells_which_state_it_holds() -> None:
    told = {"q3_deg": "q", "qd12_mm_s": "qd", "qdd1_deg_s2": "qdd", "approach2": "approach"}
    told |= {"temp_C": "temperature", "payload_kg": "payload", "time_s": "time"}
    assert {column: states.of_column(column).name for column in told} == told
    for column in ("temp_motor_C", "humidity", "approach", "qd_deg_s"):
        found = states.of_column(column)
        assert (found.name, found.kind, found.passes, found.commanded, found.levels) == (
            column,
            "channel",
            False,
            False,
            (),
        )
    assert [s.name for s in states.RECORDED if s.holds("temp_motor_C")] == ["temperature"]
    assert joint_names("rad,mm", 2) == joint_names("rad,mm", 2, states.JOINTS)


def test_what_can_be_is_said_where_something_cannot() -> None:
    for s in states.CHANNELS:
        assert bool(s.expected) == bool(s.levels or s.possible), s.name
    for s in states.RECORDED:
        assert s.called, f"{s.name} has no name beside its column"
    ranks = [sorted(r for s in states.STATES.values() if (r := getattr(s, field))) for field in ("law", "drive_law")]
    assert all(found == list(range(1, len(found) + 1)) for found in ranks)


# --- references -------------------------------------------------------------------------------------------------------


def reference(name: str, n: int) -> tuple[np.ndarray, np.ndarray, tuple[Constant, ...], np.ndarray]:
    """Return state (1, n_s), coefficients (1, n_c), constants and displacement (n_t,) of a reference, inside."""
    spec = declared(name)
    test = spec.tests[n]
    known = [test.state[q.name] * q.factor for q in spec.states]
    s = np.array([known + [test.state[m.name] for m in spec.memory]])
    c = np.array([[test.coefficients[q.name] * q.factor for q in spec.coefficients]])
    constants = tuple(scaled(test.constants[q.name], q.factor) for q in spec.constants)
    return s, c, constants, np.array([test.moved[t] for t in spec.targets])


@pytest.mark.parametrize(("name", "n"), CASES)
def test_an_effect_moves_by_what_was_computed_by_hand(name: str, n: int) -> None:
    s, c, constants, moved = reference(name, n)
    kernels = load_effect(name)
    assert kernels.value(s, c, constants)[0] == pytest.approx(moved, rel=1e-12, abs=1e-15)


@pytest.mark.parametrize(("name", "n"), CASES)
def test_derivatives_are_the_differences_of_the_value(name: str, n: int) -> None:
    s, c, constants, _ = reference(name, n)
    kernels = load_effect(name)
    D = kernels.jacobian(s, c, constants)[0]
    for j in range(c.shape[1]):
        h = np.zeros_like(c)
        h[0, j] = 1e-3 * max(abs(c[0, j]), 1e-3)
        slope = (kernels.value(s, c + h, constants) - kernels.value(s, c - h, constants))[0] / (2 * h[0, j])
        assert slope == pytest.approx(D[:, j], rel=1e-6, abs=1e-9 * max(np.abs(D).max(), 1.0))


@pytest.mark.skipif(COMPILER is None, reason="no C compiler on this machine")
def test_references_hold_in_c(tmp_path: Path) -> None:
    texts = [(KERNELS / f"{name}.c").read_text(encoding="utf-8").replace("\nstatic ", "\n") for name in WITH_C]
    source, library = tmp_path / "effects.c", tmp_path / "effects.so"
    source.write_text("#include <math.h>\n" + "\n".join(texts), encoding="utf-8")
    flags = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O2", "-shared", "-fPIC")
    subprocess.run([str(COMPILER), *flags, "-o", str(library), str(source), "-lm"], check=True)
    compiled = ctypes.CDLL(str(library))
    assert WITH_C
    for name, n in CASES:
        if name not in WITH_C:
            continue
        s, c, constants, moved = reference(name, n)
        function = getattr(compiled, name)
        function.restype = ctypes.c_double
        numbers = [np.ascontiguousarray(v, dtype=float) for v in (s.ravel(), c.ravel(), np.array([*constants, 0.0]))]
        given = [v.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for v in numbers]
        assert function(*given) == pytest.approx(moved[0], rel=1e-12, abs=1e-15), name


def test_effects_that_are_any_periodic_function_of_the_turn_are_told_by_what_they_declare() -> None:
    periodic = [name for name in effect_names() if load_effect(name).PERIODIC]
    assert periodic == [name for name in effect_names() if declared(name).periodic]
    assert "transmission_eccentricity" in periodic
    other = dataclasses.replace(declared("transmission_eccentricity"), name="other", source="")
    assert other.periodic
    moved = [dataclasses.replace(test, moved={"joint": 2 * test.moved["joint"]}) for test in other.tests]
    twice = dataclasses.replace(other, targets={"joint": 2 * other.targets["joint"]}, tests=tuple(moved))
    assert not twice.periodic


# --- what a new effect may say ----------------------------------------------------------------------------------------


def made(**other: Any) -> Effect:
    """Return a small effect, declared otherwise in places."""
    (torque,) = state("torque")
    soft = joint_coefficient("soft", "Nm", "twist", (0.0, 1.0))
    words: dict[str, Any] = {"name": "made", "title": "made", "source": "derive/effects/made.py", "advice": "Mend it."}
    words |= {"per_limb": True, "coefficients": (soft,), "targets": {"joint": soft.symbol * torque}}
    words |= {"tests": (Reference({"torque": 1000.0}, {"soft": 0.1}, {"joint": 0.1 * DEG}),)}
    return Effect(**words | other)


SOFT = joint_coefficient("soft", "Nm", "twist", (0.0, 1.0))
ORDER, NUMBER = constant("order", "1", 1.0, "a number"), constant("number", "1", 1.0, "another")
TORQUE, OTHER, AFTER, READ, SPEED = state("torque torque_1 after y_x qd")
BUILT, IDLE = sp.symbols("z idle", real=True)
FOLLOWS = Memory(BUILT, "what builds up", SOFT.symbol * SPEED - BUILT, sp.Integer(0))
OF_DRIVE: dict[str, Any] = {"targets": {"torque": SOFT.symbol * SPEED}}
REFUSED: dict[str, dict[str, Any]] = {
    "effect made: say in `advice`": {"advice": ""},
    "no state 'torqe'. Did you mean torque": {"targets": {"joint": SOFT.symbol * sp.Symbol("torqe", real=True)}},
    "nothing is called 'limb.rodd'": {"targets": {"limb.rodd": SOFT.symbol * TORQUE}},
    "it moves joint and turn.x": {"targets": {"joint": SOFT.symbol * TORQUE, "turn.x": SOFT.symbol}},
    "joint does not vanish": {"targets": {"joint": TORQUE + SOFT.symbol}},
    "soft is declared twice": {"coefficients": (SOFT, SOFT)},
    "acts on the base, of which there is one": {"targets": {"turn.x": SOFT.symbol}},
    "torque of its own.*torque_1 is that of joint 1": {"per_limb": False, "targets": {"turn.x": SOFT.symbol * TORQUE}},
    "y_x is what the instrument reads": {"targets": {"joint": SOFT.symbol * READ}},
    "a reading does not depend on torque_1": {"per_limb": False, "targets": {"length": SOFT.symbol * OTHER}},
    "after is decided by a constant 'when'": {"targets": {"joint": SOFT.symbol * AFTER}},
    "searched twice in the same way": {"searched": (Orders(ORDER), Orders(NUMBER))},
    "acts on the limb is not searched by Travels; by Orders, Moments": {"searched": (Travels(ORDER),)},
    "acts on the limb is not searched by Points": {"searched": (Points(),)},
    "acts on the drive is not searched by Points; by Orders, Sizes, Travels": OF_DRIVE | {"searched": (Points(),)},
    "has one constant that is searched": OF_DRIVE | {"searched": (Orders(ORDER), Travels(NUMBER))},
    "linear in its coefficients": OF_DRIVE | {"targets": {"torque": SOFT.symbol**2 * SPEED}},
    "linear in its coefficients; search": OF_DRIVE | {"memory": (FOLLOWS,), "targets": {"torque": SOFT.symbol * BUILT}},
    "displacement that you computed by hand": {"tests": ()},
    r"gives the states \['q'\].*has \['torque'\]": {"tests": (Reference({"q": 1.0}, {"soft": 0.1}, {"joint": 0.1}),)},
    "beyond what is believable": {"tests": (Reference({"torque": 1.0}, {"soft": -0.1}, {"joint": -0.1}),)},
    "it does not become joint_compliance where its size is large": {"extends": SPRING},
    "it does not become latency where all limbs are alike": {"extends": LATENCY},
    "say in `title`": {"title": ""},
    "soft has no meaning": {"coefficients": (dataclasses.replace(SOFT, meaning=""),)},
    "idle stands in no formula": {"coefficients": (SOFT, dataclasses.replace(SOFT, symbol=IDLE))},
    "order stands in no formula": {"searched": (Orders(ORDER),)},
    "cannot be called 'limb'": {"coefficients": (dataclasses.replace(SOFT, label="limb"),)},
    "cannot be called 'my soft'": {"coefficients": (dataclasses.replace(SOFT, label="my soft"),)},
    "cannot be called 'out'": {"coefficients": (dataclasses.replace(SOFT, symbol=sp.Symbol("out", real=True)),)},
    "joint moves by 0.1, and the formula gives 0.0017": {
        "tests": (Reference({"torque": 1000.0}, {"soft": 0.1}, {"joint": 0.1}),)
    },
    "the formula gives nan": {
        "targets": {"joint": SOFT.symbol / TORQUE},
        "tests": (Reference({"torque": 0.0}, {"soft": 0.1}, {"joint": 0.1}),),
    },
    "the believable range of soft": {"coefficients": (dataclasses.replace(SOFT, believable=(0.1, 1.0)),)},
}


def test_every_way_of_searching_that_may_be_declared_is_searched() -> None:
    assert {way.kind for way in IN_POSES} == library.SEARCHES.keys()
    assert {way.kind for way in IN_MOTION} == motion_library.SEARCHES.keys()


@pytest.mark.parametrize("words", REFUSED)
def test_what_cannot_be_meant_is_refused_by_name(words: str) -> None:
    made()
    with pytest.raises(ValueError, match=words):
        made(**REFUSED[words])


def test_a_column_that_is_a_state_is_read_as_such() -> None:
    for column, words in (
        ("time_s", r"the column time_s is the state time: write state\('time'\)"),
        ("torque_2", r"torque_2 is the name of a state"),
        ("oil temp", r"rename it to letters, digits and _"),
        ("constants", r"cannot stand in an equation"),
    ):
        with pytest.raises(ValueError, match=words):
            covariate(column)
    with pytest.raises(ValueError, match=r"there is no state 'oil_C'.*covariate\('oil_C'\)"):
        state("oil_C")


@pytest.fixture
def coupled(monkeypatch: pytest.MonkeyPatch) -> Effect:
    """An effect that reads another joint's torque and a covariate, derived and registered for one test."""
    (torque,), oil = state("torque_2"), covariate("oil_C")
    soft = joint_coefficient("soft", "Nm", "twist", (0.0, 1.0))
    spec = made(
        targets={"joint": soft.symbol * torque * oil},
        coefficients=(soft,),
        tests=(Reference({"torque_2": 1000.0, "oil_C": 3.0}, {"soft": 0.1}, {"joint": 0.3 * DEG}),),
    )
    monkeypatch.setattr(compiler, "_digest", lambda *paths: "")  # there is no file
    text = compiler.write_one(compiler.lower_one(compiler.derive_one(spec)))[Path("effects/made.py")]
    module = type(states)("made")
    exec(compile(text, "made.py", "exec"), module.__dict__)
    for room in ("terms", "parts"):
        monkeypatch.setattr(
            f"deltacal_gen.physics.{room}.load_effect", lambda name: module if name == "made" else load_effect(name)
        )
    return spec


def test_an_effect_reads_another_joints_state_and_a_covariate(coupled: Effect) -> None:
    assert [s.name for s in coupled.states] == ["torque_2", "oil_C"]
    robot = machines()[0]
    have = channels(robot, 6) | {"oil_C": np.linspace(40.0, 45.0, 6)}
    bare = body_of(robot, 6)
    known = Channels.from_columns(have, bare.q.shape, robot)
    body = Body(robot, bare.mechanism, bare.q, bare.tool, known)
    assert body.missing("made") is None
    soft = 1e-10
    term = Term("made", (1,), np.array([[soft]]))
    machine, status = body.solve(body.mechanism.vector(robot.errors), [term])
    assert not status.any()
    loads = body.state(["torque_2"], machine.x, machine.q, machine.rows)["torque_2"]
    assert machine.q[:, 0] - body.q[:, 0] == pytest.approx(soft * loads * have["oil_C"], rel=1e-9)
    assert np.array_equal(machine.q[:, 1:], body.q[:, 1:])
    assert np.abs(machine.q[:, 0] - body.q[:, 0]).max() > 1e-7


def test_a_missing_column_of_another_joint_or_a_covariate_is_said(coupled: Effect) -> None:
    robot = machines()[0]
    body = body_of(robot, 6)
    without = Body(robot, body.mechanism, body.q, body.tool, Channels.from_columns(channels(robot, 6), (6, 3), robot))
    assert without.missing("made") == "the column oil_C"
    blank_cell = Channels.from_columns({"oil_C": np.array([1, np.nan, 1, 1, 1, 1])}, (6, 3), robot)
    gaps = Body(robot, body.mechanism, body.q, body.tool, blank_cell)
    assert gaps.missing("made") == "every cell of the column oil_C (some are blank)"
    assert states.columns([states.named("qdd_2")], "rad,mm,rad", 3) == ["qdd2_mm_s2"]
    assert states.columns([states.named("inertia_torque_2")], "rad", 3) == ["qdd2_deg_s2", "payload_kg"]
    assert states.named("inertia_torque").shown_in("mm", 3, (1, 3)) == ["qdd1_mm_s2", "qdd3_mm_s2"]


@pytest.mark.skipif(COMPILER is None, reason="no C compiler on this machine")
def test_an_export_asks_for_the_covariate(coupled: Effect, tmp_path: Path) -> None:
    term = Term("made", (1,), np.array([[1e-10]]))  # 0.1 mm at 5 of the covariate
    source = tmp_path / "command.c"
    over = Spans({"payload": (0.0, 3.0), "oil_C": (0.0, 5.0)})
    left = export_c(Compensator(machines()[0], terms=(term,)), source, over)
    text = source.read_text(encoding="utf-8")
    assert "    double oil_C;" in text
    assert "payload_kg 0 to 3, oil_C 0 to 5;" in text  # as the struct has them
    assert "at->payload_kg * at->oil_C" in text
    assert left.worst_mm < 1e-3
    subprocess.run([str(COMPILER), "-std=c99", "-Wall", "-Werror", "-fsyntax-only", str(source)], check=True)


@pytest.mark.parametrize(
    ("column", "field"),
    [
        ("oil_C", "oil_C"),
        ("switch", "recorded_switch"),
        ("LIMB", "recorded_LIMB"),
        ("2nd p [bar]", "recorded_2nd_p__bar_"),
    ],
)
def test_a_column_that_c_takes_for_something_else_has_another_name_there(
    tmp_path: Path, column: str, field: str
) -> None:
    tilting = blank("part_tilt", (), (column,)).with_values(np.array([1e-3, 1e-3]))
    source = tmp_path / "command.c"
    export_c(Compensator(machines()[0], terms=(tilting,)), source, Spans({column: (0.0, 5.0)}))
    text = source.read_text(encoding="utf-8")
    assert f"    double {field};" in text
    assert re.search(rf"by\[\d\] = at->{field};", text)
    assert f".{field} = 5.0," in text


def test_ranges_of_small_channels_and_of_clocks_are_told_in_digits_that_tell_them(tmp_path: Path) -> None:
    over = Spans({"strain": (1e-4, 4.0e-4), "warming": (-0.5, 1.25), "time": (0.0, 0.5)})
    told = over.in_channels(1764219187.25)
    assert told == "strain 0.0001 to 0.0004, temp_C 19.5 to 21.25, time_s 1764219187.25 to 1764220987.25"
    tilting = blank("part_tilt", (), ("strain",)).with_values(np.array([1.0, 1.0]))
    source = tmp_path / "command.c"
    export_c(Compensator(machines()[0], terms=(tilting,)), source, over)
    assert ".recorded_strain = 0.0004," in source.read_text(encoding="utf-8")
