"""Compensation of a machine with effects: exact inversion, assumptions said aloud, the way from a diagnosis."""

from __future__ import annotations

import ctypes
import dataclasses
import itertools
import json
import re
import shutil
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.errors import InputError, NoSolutionError, UsageError
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.accuracy import workspace_of
from deltacal_gen.machine.limbs import SETTLED_MM
from deltacal_gen.machine.registry import SOLVED, UNREACHABLE, Machine, mechanism_of
from deltacal_gen.physics.body import Body
from deltacal_gen.physics.deformed import Deformed
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, blank, displaces_points, effect_names, load_effect
from deltacal_gen.results.reader import read_result
from deltacal_gen.units import DEG
from deltacal_gen.use.command_source import NOT_A_NUMBER
from deltacal_gen.use.compensation import Compensator
from deltacal_gen.use.exporters.c import export_c
from deltacal_gen.use.exporters.table import export_table, read_table
from deltacal_gen.use.spans import Spans, spans
from tests.support.compiled_c import At
from tests.support.every_effect import ON_MACHINES, channels, constants, machine_with, machines, sized, targets
from tests.support.prototype import plausible, scattered, wanted

pytestmark = pytest.mark.usefixtures("compiled")

OVER = Spans({"warming": (-2.0, 15.0), "payload": (0.0, 3.0), "time": (0.0, 2.0)})


def term(name: str, size: float | None = None, limbs: tuple[int, ...] = (1, 2, 3)) -> Term:
    """Return an effect of some tenths of a millimetre, or of a size in the files' units."""
    bare = sized(name, limbs)
    factors = np.array([factor for _, _, factor, _ in load_effect(name).COEFFICIENTS])
    return bare if size is None else bare.with_values(size * factors * np.ones_like(bare.values))


@pytest.fixture(scope="module")
def machine() -> Robot:
    return machines()[0]


# --- exact inversion ------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ON_MACHINES)
def test_the_command_brings_the_machine_with_the_effect_to_the_target(name: str) -> None:
    machine = machine_with(name)
    wanted_at = targets(machine, 60, 1)
    compensator = Compensator(machine, terms=(sized(name, much=0.4),))
    at, assumed = compensator.channels(channels(machine, 60), 60)
    assert assumed == []
    joints, status = compensator.command(wanted_at, None, at)
    assert (status == SOLVED).all()
    assert np.abs(compensator.reached(joints, None, at)[0] - wanted_at[:, :3]).max() < 2 * SETTLED_MM
    geometry_alone = Compensator(machine).command(wanted_at)[0]
    assert np.abs(compensator.reached(geometry_alone, None, at)[0] - wanted_at[:, :3]).max() > 0.05


@pytest.mark.parametrize("robot", [machines()[0], machines()[2]], ids=["loops", "chain"])
def test_commands_of_a_machine_that_remembers_count_those_before_them(robot: Robot, tmp_path: Path) -> None:
    """A joint is drawn along by where it was: a command moves all that come after it."""
    text, n = "law joint = c1*(Lag(q, c2) - q)", 40
    drawn = Term(text, (2,), np.full((1, 1), 2e-3), (500.0, *(-1e9, 1e9) * len(load_effect(text).STATE)))
    compensator, wanted_at = Compensator(robot, terms=(drawn,)), targets(robot, n, 1)
    at, _ = compensator.channels({"time_s": np.random.default_rng(2).uniform(0, 4000, n)}, n)
    joints, status = compensator.command(wanted_at, None, at)
    assert (status == SOLVED).all()
    reached = compensator.pose(joints, None, at)[0]
    assert np.abs(compensator.mechanism.missed(reached, wanted_at)[:, :3]).max() < 2 * SETTLED_MM
    rigid = Compensator(robot).command(wanted_at)[0]
    assert np.abs(joints - rigid).max() > 1e-4
    without_time = compensator.command(wanted_at)[0]  # then each stands alone
    np.testing.assert_allclose(without_time, rigid, rtol=0, atol=1e-9)
    half = {"time_s": np.tile(np.linspace(0, 2000, n // 2), 2), "run": np.repeat([1.0, 2.0], n // 2)}
    apart = compensator.command(wanted_at, None, compensator.channels(half, n)[0])[0]
    for own in np.split(np.arange(n), 2):  # a run counts nothing of another
        alone, _ = compensator.channels({"time_s": half["time_s"][own]}, n // 2)
        np.testing.assert_allclose(apart[own], compensator.command(wanted_at[own], None, alone)[0], rtol=0, atol=1e-9)
    wanted_at[n // 2, :3] = 1e5
    _, status = compensator.command(wanted_at, None, at)  # all others wait for none that is out of reach
    assert np.flatnonzero(status != SOLVED).tolist() == [n // 2]
    for export in (export_c, export_table):
        with pytest.raises(UsageError, match="of what remembers how the machine came to a target"):
            export(compensator, tmp_path / "one_by_one")


@pytest.mark.parametrize("robot", [machines()[0], machines()[2]], ids=["loops", "chain"])
def test_commands_that_wait_for_one_another_are_refused_each_for_itself(robot: Robot) -> None:
    mechanism, wanted_at, turn = mechanism_of(robot), targets(robot, 5, 1), itertools.cycle((1.0, -1.0))
    tool, rows = np.tile(robot.tool, (5, 1)), mechanism.rows(robot)
    near = Compensator(robot).nominal_command(wanted_at)[0] * robot.joint_sign if mechanism.many_ways else None

    def reach(q: np.ndarray, some: np.ndarray) -> tuple[Deformed, np.ndarray]:
        x, status = mechanism.forward(q, tool[some], rows)
        x[some == 2, 2] += next(turn)  # it never settles
        return Deformed(x, q, tool[some], rows), status

    _, status = mechanism.follow(wanted_at, near, tool, rows, None, reach, together=True)
    assert status.tolist() == [SOLVED, SOLVED, UNREACHABLE, SOLVED, SOLVED]


def test_a_large_shift_of_a_joint_is_undone_in_steps_that_double_the_digits(
    machine: Robot, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[int] = []
    solve = Body.solve

    def counted(body: Body, *arguments: Any, **options: Any) -> Any:
        asked.append(len(body.q))
        return solve(body, *arguments, **options)

    compensator = Compensator(machine, terms=(term("thermal_zero", 0.05, limbs=(2,)),))
    at, _ = compensator.channels({"temp_C": 60.0}, 30)  # 2 deg: the Jacobian of the unmoved machine is 3 % off
    monkeypatch.setattr(Body, "solve", counted)
    joints, status = compensator.command(scattered(machine, 30, 4), None, at)
    assert (status == SOLVED).all()
    assert len(asked) <= 4  # off by tens of mm, by tenths, by micrometres; the last one sees that it is there
    assert np.abs(compensator.reached(joints, None, at)[0] - scattered(machine, 30, 4)).max() < 1e-9


def test_all_effects_at_once_at_another_tool_point(machine: Robot) -> None:
    wanted_at = scattered(machine, 60, 2)
    tool = np.array([20.0, -30.0, -60.0])
    own = [name for name in ON_MACHINES if machine_with(name) is machine]
    compensator = Compensator(machine, terms=tuple(sized(name, much=0.1) for name in own))
    at, _ = compensator.channels(channels(machine, 60), 60)
    assert np.abs(compensator.leftover(wanted_at, tool, at)).max() < 2 * SETTLED_MM


@pytest.mark.parametrize("name", [n for n in effect_names() if n not in ON_MACHINES])
def test_an_effect_on_the_instrument_changes_no_command(name: str) -> None:
    machine = machine_with(name)
    bare = blank(name, (), constants(name), [(0.0, 0.0, 0.0)] if displaces_points(load_effect(name)) else [])
    wanted_at = targets(machine, 5, 1)
    compensator = Compensator(machine, terms=(bare.with_values(np.ones(bare.n_coefficients)),))
    assert np.array_equal(compensator.command(wanted_at)[0], Compensator(machine).command(wanted_at)[0])
    assert compensator.channels({}, 5)[1] == [f"{name} belongs to the instrument: no command is changed for it"]


def test_the_direction_of_a_joint_alone_is_enough_where_it_alone_has_play(machine: Robot) -> None:
    play = blank("backlash", (2,), constants("backlash"), []).with_values(np.array([[0.001]]))
    compensator = Compensator(machine, terms=(play,))
    at, assumed = compensator.channels({"approach2": np.array([1.0, -1.0])}, 2)
    assert assumed == []
    joints, _ = compensator.command(np.repeat(targets(machine, 1, 3), 2, axis=0), channels=at)
    assert joints[0] - joints[1] == pytest.approx([0.0, 0.001, 0.0], abs=1e-9)
    assert "middle of the play" in compensator.channels({"approach1": np.array([1.0, -1.0])}, 2)[1][0]


def test_what_is_not_given_is_assumed_aloud(machine: Robot) -> None:
    names = ("backlash", "joint_compliance", "thermal_zero", "zero_drift", "zero_jump", "inertial_deflection")
    compensator = Compensator(machine, terms=tuple(map(term, names)))
    at, assumed = compensator.channels({}, 4)
    text = "\n".join(assumed)
    for words in (
        r"approach1 \.\.\. approach3 not given: .*middle of the play.*\(backlash\)",
        r"temp_C not given: 20 degC is assumed \(thermal_zero\)",
        r"payload_kg not given: no payload is assumed \(joint_compliance, inertial_deflection\)",
        r"time_s not given: .*before any drift \(zero_drift\)",
        r"time_s not given: a time after the jump is assumed \(zero_jump\)",
        r"qdd1_deg_s2 \.\.\. qdd3_deg_s2 not given: a machine at rest is assumed \(inertial_deflection\)",
    ):
        assert re.search(words, text), words
    # and it is what is said: the same as giving these values
    given = {"temp_C": 20.0, "payload_kg": 0.0, "time_s": 1e9} | {f"approach{i}": 0.0 for i in (1, 2, 3)}
    jumped = Compensator(machine, terms=tuple(t for t in compensator.terms if t.effect != "zero_drift"))
    targets = scattered(machine, 4, 3)
    stated, _ = jumped.channels(given, 4)
    assert np.abs(jumped.command(targets, None, stated)[0] - jumped.command(targets)[0]).max() < 1e-14
    assert np.array_equal(compensator.command(targets, None, at)[0], compensator.command(targets)[0])
    blank_cell = np.array([25.0, np.nan, 25.0, np.nan])
    assert (
        "temp_C blank in 2 of 4 rows: 20 degC is assumed (thermal_zero)"
        in compensator.channels({"temp_C": blank_cell}, 4)[1]
    )
    with pytest.raises(InputError, match="some rows have a time and some have none"):
        compensator.channels({"time_s": blank_cell}, 4)


def test_targets_out_of_reach_stay_so(machine: Robot) -> None:
    compensator = Compensator(machine, terms=(term("joint_compliance"),))
    targets = np.vstack([scattered(machine, 2, 1), [[0.0, 0.0, -5000.0]]])
    joints, status = compensator.command(targets)
    assert status.tolist() == [SOLVED, SOLVED, UNREACHABLE]
    assert np.isnan(joints[2]).all()
    with pytest.raises(NoSolutionError, match="target 3"):
        compensator.joints(targets)


def test_what_knows_geometry_only_says_so(machine: Robot) -> None:
    with pytest.raises(UsageError, match="linear compensator knows geometry only, not backlash"):
        Compensator(machine, "linear", (term("backlash"),))
    with pytest.raises(UsageError, match=r"export C or a table for a machine with backlash"):
        Compensator(machine, terms=(term("backlash"),)).servo()
    without_masses = dataclasses.replace(machine, masses=None)
    with pytest.raises(InputError, match=r"'joint_compliance' needs \[masses\]"):
        Compensator(without_masses, terms=(term("joint_compliance"),)).command(scattered(machine, 2, 1))


# --- from a recording to the corrected machine ----------------------------------------------------------------------

CASES = {  # concealed effect, and the size of the error that it makes at the worst target [mm]
    "temperature": ("thermal_zero", 0.006, (1, 3)),
    "payload": ("joint_compliance", 0.02, (1, 2, 3)),
    "direction": ("backlash", 0.08, (2,)),
}


READS = {
    "thermal_zero": ("temp_C",),
    "joint_compliance": ("payload_kg",),
    "backlash": ("approach1", "approach2", "approach3"),
}


@pytest.mark.walk
@pytest.mark.parametrize("case", CASES)
def test_the_machine_meets_its_targets_once_it_is_diagnosed(
    machine: Robot, mechanism: Machine, case: str, tmp_path: Path
) -> None:
    """Conceal an effect, diagnose it, command the true machine: what is left at new targets is parameter error."""
    name, size, limbs = CASES[case]
    nominal = dataclasses.replace(machine, errors={})
    truth, true_term = plausible(mechanism, 8), term(name, size, limbs)
    used = READS[name]
    given = {k: v for k, v in channels(machine, 90, 4).items() if k in used}
    poses = wanted(scattered(machine, 90, 4), frame="robot", channels=given)
    sigma = 0.005
    recording = simulate(nominal, poses, truth, noise_mm=sigma, rng=np.random.default_rng(5), terms=(true_term,))
    found = json.loads(diagnose(nominal, recording).answer().to_json())
    assert [e["name"] for e in found["effects"]] == [name]

    targets = scattered(machine, 40, 6)
    now = {k: v for k, v in channels(machine, 40, 7).items() if k in used}
    joints = dc.compensate(found, targets, channels=now)
    calibrated_only = dc.compensate(found | {"physics": []}, targets)
    true_machine = Compensator(dataclasses.replace(machine, errors=truth), terms=(true_term,))
    at, _ = true_machine.channels(now, 40)
    error = np.linalg.norm(true_machine.reached(joints * DEG, None, at)[0] - targets, axis=1)
    without = np.linalg.norm(true_machine.reached(calibrated_only * DEG, None, at)[0] - targets, axis=1)
    assert np.sqrt(np.mean(error**2)) < 1.5 * sigma  # 270 readings, 45 unknowns: 0.7 sigma per point at an ideal fit
    assert np.sqrt(np.mean(without**2)) > 10 * sigma

    # the same by files: channels of the targets file are read
    columns = {"x_mm": targets[:, 0], "y_mm": targets[:, 1], "z_mm": targets[:, 2], **now}
    lines = [",".join(columns), *(",".join(repr(float(v)) for v in row) for row in zip(*columns.values(), strict=True))]
    (tmp_path / "targets.csv").write_text("\n".join(lines) + "\n")
    said: list[str] = []
    from_file = dc.compensate(found, tmp_path / "targets.csv", tell=said.append)
    assert np.abs(from_file - joints).max() < 1e-12
    assert said == []
    dc.compensate(found, targets, tell=said.append)
    assert len(said) == 1
    assert (
        spans(read_result(found)).items().keys()
        == {"temperature": {"warming"}, "payload": {"payload"}, "direction": set()}[case]
    )


# --- exports --------------------------------------------------------------------------------------------------------

COMPILER = shutil.which("gcc") or shutil.which("cc") or shutil.which("clang")
SETS = [
    ("backlash", "thermal_zero", "zero_drift", "zero_jump"),  # closed forms alone
    ("transmission_eccentricity", "joint_scale", "joint_compliance"),
    ("thermal_growth", "proximal_bending", "base_compliance", "backlash"),
    ("latency", "joint_latency", "inertial_deflection"),  # nothing of a machine at rest
]


def at_rest(n: int) -> dict[str, np.ndarray]:
    return {k: v for k, v in channels(machines()[0], n, 9).items() if not k.startswith("qd")}


def after_the_jump(terms: tuple[Term, ...]) -> tuple[Term, ...]:
    return tuple(t.afterwards() for t in terms)


@pytest.mark.skipif(COMPILER is None, reason="no C compiler on this machine")
@pytest.mark.parametrize("names", SETS, ids="+".join)
def test_the_exported_c_leaves_what_it_states(machine: Robot, names: tuple[str, ...], tmp_path: Path) -> None:
    terms = tuple(map(term, names))
    source = tmp_path / "command.c"
    left = export_c(Compensator(machine, terms=terms), source, OVER)
    text = source.read_text(encoding="utf-8")
    stated = float(re.findall(r"Error left  (\S+) mm", text)[1])
    assert left.worst_mm <= stated < 0.02
    library = source.with_suffix(".so")
    flags = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O2", "-shared", "-fPIC")
    subprocess.run([str(COMPILER), *flags, "-o", str(library), str(source), "-lm"], check=True)
    function = ctypes.CDLL(str(library)).deltacal_command

    targets, given = scattered(machine, 200, 8), at_rest(200)
    joints = np.zeros((200, 3))
    for j, target in enumerate(targets):
        approach = (ctypes.c_double * 3)(*(given[f"approach{i}"][j] for i in (1, 2, 3)))
        at = At(given["temp_C"][j], given["payload_kg"][j], given["time_s"][j], approach)
        out = (ctypes.c_double * 3)()
        assert function((ctypes.c_double * 3)(*target), ctypes.byref(at), out) == SOLVED
        joints[j] = out
    true_machine = Compensator(machine, terms=after_the_jump(terms))
    channels_then, _ = true_machine.channels(given, 200)
    error = np.linalg.norm(true_machine.reached(joints * DEG, None, channels_then)[0] - targets, axis=1)
    assert error.max() <= max(stated, 1e-9)
    untouched = (ctypes.c_double * 3)(7.0, 7.0, 7.0)
    far = (ctypes.c_double * 3)(0.0, 0.0, -5000.0)
    assert function(far, ctypes.byref(At(20.0, 0.0, 0.0, (ctypes.c_double * 3)())), untouched) == UNREACHABLE
    assert list(untouched) == [7.0, 7.0, 7.0]

    same = (ctypes.c_double * 3)(*targets[0])  # joints may take the place of their target
    approach = (ctypes.c_double * 3)(*(given[f"approach{i}"][0] for i in (1, 2, 3)))
    first = At(given["temp_C"][0], given["payload_kg"][0], given["time_s"][0], approach)
    assert function(same, ctypes.byref(first), same) == SOLVED
    assert list(same) == joints[0].tolist()

    # the points that the header gives for a check after installation
    numbers = [float(v) for v in re.findall(r"^ \* +\.\w+ = ([-\d.]+),", text, re.M)]
    at, checked = At(*numbers, (ctypes.c_double * 3)(1.0, 1.0, 1.0)), text.partition("of deltacal_command")[2]
    checks = re.findall(r"\((\S+), (\S+), (\S+)\) mm -> \((\S+), (\S+), (\S+)\) deg", checked)
    assert len(checks) == 3
    for row in np.array(checks, dtype=float):
        out = (ctypes.c_double * 3)()
        assert function((ctypes.c_double * 3)(*row[:3]), ctypes.byref(at), out) == SOLVED
        assert np.abs(np.array(out) - row[3:]).max() < 1e-8


@pytest.mark.skipif(COMPILER is None, reason="no C compiler on this machine")
def test_a_channel_that_is_no_number_commands_nothing(machine: Robot, tmp_path: Path) -> None:
    function = compiled(machine, ("thermal_growth", "joint_compliance", "backlash"), tmp_path)
    for bad in (np.nan, np.inf, -np.inf):
        for field in ("temp_C", "payload_kg", "approach"):
            at = At(20.0, 1.0, 0.0, (ctypes.c_double * 3)(1.0, 1.0, 1.0))
            setattr(at, field, (ctypes.c_double * 3)(1.0, bad, 1.0) if field == "approach" else bad)
            untouched = (ctypes.c_double * 3)(7.0, 7.0, 7.0)
            target = (ctypes.c_double * 3)(*scattered(machine, 1, 3)[0])
            assert function(target, ctypes.byref(at), untouched) == NOT_A_NUMBER
            assert list(untouched) == [7.0, 7.0, 7.0]
    unread = At(20.0, 1.0, np.nan, (ctypes.c_double * 3)(1.0, 1.0, 1.0))
    assert function(target, ctypes.byref(unread), untouched) == SOLVED


@pytest.mark.skipif(COMPILER is None, reason="no C compiler on this machine")
def test_corrections_far_beside_the_workspace_do_not_run_away(machine: Robot, tmp_path: Path) -> None:
    """A polynomial of degree 6 does, where it was not fitted: at 1.6 times the workspace to 2.7 times what it is."""
    function = compiled(machine, ("thermal_growth", "base_compliance"), tmp_path)
    at = At(35.0, 3.0, 0.0, (ctypes.c_double * 3)())
    centre, half = workspace_of(machine).box
    turns = np.linspace(0.0, 2 * np.pi, 24)
    rim = np.column_stack([np.cos(turns), np.sin(turns), np.ones(24)])
    largest = []
    for part in (1.0, 1.6):
        places = centre + part * half * rim
        rigid, status = Compensator(machine).command(places)
        assert (status == SOLVED).any()
        change = []
        for k in np.flatnonzero(status == SOLVED):
            out = (ctypes.c_double * 3)()
            assert function((ctypes.c_double * 3)(*places[k]), ctypes.byref(at), out) == SOLVED
            change.append(np.abs(np.array(out) - rigid[k] / DEG).max())
        largest.append(max(change))
    assert largest[1] < 2.0 * largest[0]


def compiled(machine: Robot, names: tuple[str, ...], folder: Path) -> Any:
    """Return the exported command of a machine with effects."""
    source = folder / "command.c"
    export_c(Compensator(machine, terms=tuple(map(term, names))), source, OVER)
    library = source.with_suffix(".so")
    flags = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-O2", "-shared", "-fPIC")
    subprocess.run([str(COMPILER), *flags, "-o", str(library), str(source), "-lm"], check=True)
    return ctypes.CDLL(str(library)).deltacal_command


@pytest.mark.skipif(COMPILER is None, reason="no C compiler on this machine")
@pytest.mark.parametrize("flags", [("-ffast-math",), ("-Ofast",), ("-D__DBL_DIG__=6",)])
def test_a_build_that_drops_what_the_file_rests_on_stops(
    machine: Robot, flags: tuple[str, ...], tmp_path: Path
) -> None:
    source = tmp_path / "command.c"
    export_c(Compensator(machine), source)
    for extra, built in (((), True), (flags, False)):
        command = [str(COMPILER), "-std=c99", *extra, "-fsyntax-only", str(source)]
        done = subprocess.run(command, capture_output=True, text=True)
        assert (done.returncode == 0) is built, done.stderr


def test_a_table_holds_the_channels_too(machine: Robot, tmp_path: Path) -> None:
    terms = (term("thermal_zero"), term("joint_compliance"), term("backlash", limbs=(2,)))
    compensator = Compensator(machine, terms=terms)
    written = export_table(compensator, tmp_path / "table.csv", OVER, step_mm=60.0)
    table = read_table(tmp_path / "table.csv")
    assert table.columns == ((), ("approach2",), ("payload",), ("warming",))
    assert np.array_equal(table.corrections, written.corrections)
    given = at_rest(1000)
    values = {"warming": given["temp_C"] - 20.0, "payload": given["payload_kg"], "approach2": given["approach2"]}
    targets = scattered(machine, 1000, 8)
    correction, status = table.correction(targets, values)
    assert (status == SOLVED).all()
    at, _ = compensator.channels(given, 1000)
    joints = compensator.nominal_command(targets)[0] + correction
    error = np.linalg.norm(compensator.reached(joints, None, at)[0] - targets, axis=1)
    assert 0.2 * table.worst_mm < error.max() <= table.worst_mm
    at_reference = compensator.nominal_command(targets)[0] + table.correction(targets)[0]
    missed = np.linalg.norm(compensator.reached(at_reference, None, at)[0] - targets, axis=1)
    assert missed.max() > 10 * table.worst_mm


def test_a_table_that_no_grid_makes_good_enough_is_refused(machine: Robot, tmp_path: Path) -> None:
    compensator = Compensator(machine, terms=(term("friction_windup", 0.05),))
    with pytest.raises(NoSolutionError, match="not linear enough in the channels"):
        export_table(compensator, tmp_path / "table.csv", OVER, worst_mm=0.002)
    assert not list(tmp_path.iterdir())
