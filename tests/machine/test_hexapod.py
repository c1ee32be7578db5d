"""The hexapod: six equations that turn the platform, against vectors of its legs written out here."""

from __future__ import annotations

import ctypes
import dataclasses
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.errors import UsageError
from deltacal_gen.estimation.prior import unsaid
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import Robot, read_robot
from deltacal_gen.identification.accuracy import turned
from deltacal_gen.identification.identifiability import observability
from deltacal_gen.identification.identification import identify
from deltacal_gen.instrument.kinds import kind_of
from deltacal_gen.machine.backend import Backend, using
from deltacal_gen.machine.registry import UNREACHABLE, load_mechanism
from deltacal_gen.machine.rotation import from_vector
from deltacal_gen.machine.values import Masses, Measurement, Recording
from deltacal_gen.physics.parts import lacks
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import Term, blank
from deltacal_gen.planning import matrix, optimal
from deltacal_gen.planning.reach import reach, readable_targets
from deltacal_gen.planning.targets import candidates_of
from deltacal_gen.use import commanded
from deltacal_gen.use.compensation import Compensator, CompensatorKind
from deltacal_gen.use.exporters.c import export_c
from deltacal_gen.use.exporters.table import export_table
from deltacal_gen.use.prediction import predict
from deltacal_gen.use.spans import channels_of
from tests.support.commands import Run
from tests.support.planned import log_determinant

pytestmark = pytest.mark.usefixtures("compiled")

MACHINE = load_mechanism("hexapod")
FOLDER = example("hexapod")
NOISE = 0.003  # mm


def robot(seed: int | None = 1) -> Robot:
    """Return the example; with a seed no leg of it is like another, and every part is off."""
    drawn = read_robot(FOLDER / "robot.toml")
    if seed is None:
        return drawn
    rng = np.random.default_rng(seed)
    errors = {p.name: 5 * p.typical * float(rng.standard_normal()) for p in MACHINE.parameters}
    legs = {k: np.asarray(v) + rng.uniform(-0.05, 0.05, 6) * np.abs(v) for k, v in drawn.geometry.items()}
    return dataclasses.replace(drawn, geometry=legs, errors=errors, tool=np.array([10.0, -20.0, 30.0]))


def poses(n: int, seed: int = 0) -> np.ndarray:
    rng = np.random.default_rng(seed)
    places = np.column_stack([rng.uniform(-40, 40, (n, 2)), rng.uniform(300, 360, n)])
    return np.hstack([places, from_vector(rng.uniform(-0.2, 0.2, (n, 3))).reshape(-1, 9)])


def reference(r: Robot) -> np.ndarray:
    """Return where the reference point is in {O'}."""
    return r.tool + [r.errors.get(f"t{axis}", 0.0) for axis in "xyz"]


def joints_by_hand(r: Robot, x: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return base joints, platform joints in {O}, (N, 6, 3) each, and ways of the legs (N, 6)."""
    g, e = r.geometry, r.errors

    def ring(which: str, letter: str) -> np.ndarray:
        angle = g[f"{which}_angle"]
        at = [g[f"{which}_radius"] * np.cos(angle), g[f"{which}_radius"] * np.sin(angle), g[f"{which}_height"]]
        return np.stack(at, axis=1) + [[e.get(f"{letter}{axis}_{i}", 0.0) for axis in "xyz"] for i in range(1, 7)]

    A, R = ring("base", "a"), x[:, 3:].reshape(-1, 3, 3)
    B = x[:, None, :3] + (ring("platform", "b") - reference(r)) @ np.swapaxes(R, 1, 2)
    length = np.linalg.norm(B - A, axis=2)
    own, lead = (np.array([e.get(f"{name}_{i}", 0.0) for i in range(1, 7)]) for name in ("l", "scale"))
    return np.broadcast_to(A, B.shape), B, (length - g["leg_length"] - own) / (1 + lead)


@pytest.mark.parametrize("backend", list(Backend))
def test_legs_are_as_long_as_between_their_joints(backend: Backend) -> None:
    r, x = robot(), poses(70)
    _, _, legs = joints_by_hand(r, x)
    with using(backend):
        q, reached, status = MACHINE.inverse(x, r.tool, MACHINE.rows(r))
        assert not status.any()
        np.testing.assert_allclose(q, legs, rtol=0, atol=1e-11)
        np.testing.assert_allclose(reached, x, rtol=0, atol=1e-12)
        there, status = MACHINE.forward(legs, r.tool, MACHINE.rows(r))  # from home: it is not told where it stands
        assert not status.any()
        np.testing.assert_allclose(there, x, rtol=0, atol=1e-10)


def test_its_kernels_are_compiled_ahead() -> None:
    names = {name.removeprefix("hexapod.") for name, _ in MACHINE.compile()}
    assert {"forward", "inverse", "sensitivity", "torque", "linear_commands"} <= names


def test_legs_bear_the_platform() -> None:
    """Forces along the legs of no weight balance the platform's and a payload's, about any point."""
    drawn, x, payload = robot(), poses(20), 2.5
    r = dataclasses.replace(drawn, masses=Masses(platform=4.0))
    A, B, q = joints_by_hand(r, x)
    R, down = x[:, 3:].reshape(-1, 3, 3), np.array([0.0, 0.0, -9.81])
    along = (B - A) / np.linalg.norm(B - A, axis=2)[:, :, None]
    wrench = np.concatenate([along, np.cross(B - x[:, None, :3], along)], axis=2)  # about the reference point
    centre = -(R @ r.tool)  # of the platform, where its mass is
    weight = np.hstack([np.tile((4.0 + payload) * down, (len(x), 1)), np.cross(centre, 4.0 * down)])
    pushed = np.linalg.solve(np.swapaxes(wrench, 1, 2), -weight[..., None])[..., 0]
    masses = {"platform": 4.0, "proximal": 0.0, "proximal_com": 0.5, "distal_rod": 0.0}
    loads = MACHINE.loads(x, q, r.tool, MACHINE.rows(r), masses, down, payload)
    np.testing.assert_allclose(loads.tension[:, :, 0], -pushed, rtol=0, atol=1e-9)


@pytest.mark.parametrize(("frame", "seen"), [("robot", 42), ("unknown", 33)])
def test_all_forty_two_errors_are_seen_in_a_known_frame(frame: str, seen: int) -> None:
    """Masory, Wang, Zhuang 1993; another frame takes six of them, how the target sits on the platform three."""
    r, x = robot(), poses(60)
    _, _, q = joints_by_hand(r, x)
    names, kind = MACHINE.models["hexapod/42"], kind_of("pose")
    S = MACHINE.sensitivity(x, q, r.tool, MACHINE.rows(r)).parameters[:, :, [MACHINE.index[n] for n in names]]
    readings, instrument = kind.imagined(x, 1, MACHINE, Measurement(kind="pose", frame=frame))
    J, F = matrix.linearise(readings, instrument, x, S)
    if frame == "robot":
        F = F[:, :, :0]
    typical = np.array([MACHINE.typical[MACHINE.index[n]] for n in names])
    J, F = J.reshape(-1, len(names)) * typical, F.reshape(len(J) * J.shape[1], -1)
    Q = np.linalg.qr(F)[0]
    assert observability(J - Q @ (Q.T @ J), len(x)).rank == seen


def measured(drawn: Robot, size: float, seed: int, *terms: Term, noise: float = NOISE) -> Recording:
    """Return what a tracker reads of a machine at the example's poses, its errors so many times ordinary ones."""
    targets = read_recording(FOLDER / "poses.csv", MACHINE, need_measured=False, allow_targets=True)
    rng = np.random.default_rng(seed)
    errors = {p.name: size * p.typical * float(rng.standard_normal()) for p in MACHINE.parameters}
    return simulate(drawn, targets, errors, terms=terms, noise_mm=noise, noise_rad=noise / 60, rng=rng)


@pytest.mark.walk
def test_a_leg_that_yields_is_named() -> None:
    """Whether its drive yields or its rod is one number: both push along the leg."""
    drawn = dataclasses.replace(robot(None), masses=Masses(proximal=2.0, distal_rod=1.0, platform=60.0))
    without = lacks("distal_compliance", MACHINE, MACHINE.moves(drawn), MACHINE.roles(drawn))  # rods of a pair
    spring = blank("distal_compliance", (4,), lacks=without).with_values(np.array([[1e-3]]))  # mm/N
    found = diagnose(drawn, measured(drawn, 1.0, 7, spring)).answer()
    (effect,) = found.effects
    assert effect.limbs == (4,)
    assert {effect.name, *effect.indistinguishable_from} >= {"joint_compliance", "distal_compliance"}
    (size,) = effect.parameters
    assert abs(abs(size.value) - 1e-3) < 3 * size.std


def test_what_is_identified_predicts_poses_that_were_not_read() -> None:
    recording = measured(robot(None), 3.0, 8)
    even, odd = (recording.subset(np.arange(k, recording.n_rows, 2)) for k in (0, 1))
    found = identify(robot(None), even).answer()
    missed = predict(found, odd).measured - odd.measured
    assert np.sqrt(np.mean(missed[:, :3] ** 2)) < 2 * NOISE


def test_a_reflector_of_which_nobody_says_where_it_sits_is_found() -> None:
    """Off the centre by centimetres it moves as the platform turns: neither frame nor joints do that for it."""
    bare, sits = robot(None), np.array([14.0, -9.0, 31.0])
    recording = measured(dataclasses.replace(bare, tool=sits), 1.0, 8)
    even, odd = (recording.subset(np.arange(k, recording.n_rows, 2)) for k in (0, 1))
    found = identify(bare, even).answer()
    assert found.model == "hexapod/51"
    assert found.doubts is None
    missed = predict(found, odd).measured - odd.measured
    assert np.sqrt(np.mean(missed[:, :3] ** 2)) < 2 * NOISE
    told: list[str] = []
    dc.compensate(found, np.array([[0.0, 0.0, 330.0]]), tell=told.append)
    assert any("targets are of the point that was measured, found at (1" in words for words in told)
    offsets = {p.name: p.value for p in found.parameters}
    np.testing.assert_allclose([offsets[f"t{axis}"] for axis in "xyz"], sits, atol=1.0)  # but for all joints together


def test_drives_that_count_from_where_they_were_switched_on_cost_nothing() -> None:
    """Legs are centimetres longer at q = 0 than drawn: that is the zero of their drives, and no joint's place."""
    recording, noise = measured(robot(None), 1.0, 8, noise=0.1), 0.1
    counted = dataclasses.replace(recording, joints=recording.joints - recording.joints[0])
    even, odd = (counted.subset(np.arange(k, counted.n_rows, 2)) for k in (0, 1))
    missed = predict(identify(robot(None), even).answer(), odd).measured - odd.measured
    assert np.sqrt(np.mean(missed[:, :3] ** 2)) < 1.6 * noise


def test_of_a_gauge_the_sidecar_says_where_it_is_fixed() -> None:
    recording = measured(robot(None), 1.0, 8)
    gauge = Measurement(kind="gauge", base_point_mm=(150.0, 0.0, 0.0), platform_point_mm=(0.0, 50.0, 0.0))
    length = np.linalg.norm(recording.measured[:, :3], axis=1, keepdims=True)
    columns = {"kind": "gauge", "measurement": gauge, "columns": ("gauge_mm",), "measured": length}
    lengths = dataclasses.replace(recording, **columns)
    for readings, left_open in ((recording, ("tx", "ty", "tz")), (lengths, ())):
        assert unsaid(pose_problem(robot(None), readings, MACHINE.models["hexapod/51"])) == left_open


def test_what_is_chosen_is_what_was_looked_at() -> None:
    """A turn goes by the place in the row of candidates: those that are chosen keep theirs."""
    r, rng = robot(None), np.random.default_rng(5)
    found = optimal.plan_optimal_poses(r, "48", 20)
    candidates = turned(r, np.unique(readable_targets(r, candidates_of(r)), axis=0))
    rows = {tuple(np.round(t, 9)) for t in candidates}
    _, x, _ = MACHINE.inverse(np.hstack([found.poses.targets, found.poses.x[:, 3:]]), r.tool, MACHINE.rows(r))
    assert all(tuple(np.round(t, 9)) in rows for t in x)
    best = log_determinant(found, x)
    able = candidates[reach(r, candidates, found.tools)[1] == ""]
    others = [log_determinant(found, able[rng.choice(len(able), 20, replace=False)]) for _ in range(10)]
    assert best > max(others) + 1


def test_a_plan_turns_the_platform_as_people_write_it(run: Run, tmp_path: Path) -> None:
    """Poses beyond the legs move inwards and turn back towards level, and are told by their position alone."""
    close = (FOLDER / "robot.toml").read_text().replace("height = 40.0", "height = 70.0")
    (tmp_path / "robot.toml").write_text(close)
    code, out, err = run("plan", tmp_path / "robot.toml", "--model", "48", "-o", tmp_path / "targets.csv")
    assert code == 0, err
    assert "is beyond the limits of the joints: joint 1 would stand at" in " ".join(out.split())
    rows = [line.split(",") for line in (tmp_path / "targets.csv").read_text().splitlines()[1:]]
    assert all(len(cell.partition(".")[2]) <= 3 for row in rows for cell in row[:4])
    assert max(len(cell) for row in rows for cell in row) <= 14
    assert "(50, 0, 260) mm is beyond" in " ".join(out.split())


def test_a_hexapod_that_nothing_holds_is_called_singular() -> None:
    """Base and platform alike: all legs are parallel at home, and the platform swings."""
    drawn = robot(None)
    same = dataclasses.replace(drawn, geometry=drawn.geometry | {"platform_radius": drawn.geometry["base_radius"]})
    same = dataclasses.replace(same, geometry=same.geometry | {"platform_angle": drawn.geometry["base_angle"]})
    _, why = reach(same, np.array([[0.0, 0.0, 300.0]]), drawn.tool)
    assert why.tolist() == ["singular: the joints that stand for it do not lead back to it"]


def test_legs_too_short_to_close_are_out_of_reach() -> None:
    short = robot(None)
    short = dataclasses.replace(short, geometry=short.geometry | {"leg_length": np.full(6, 80.0)})
    with using(Backend.NUMPY):
        assert MACHINE.forward(np.zeros((1, 6)), short.tool[None], MACHINE.rows(short))[1] == UNREACHABLE


def commanded_by_c(source: Path, target: np.ndarray, approach: list[float]) -> list[float]:
    """Return what `deltacal_command` of a C export answers."""
    compiler = shutil.which("gcc") or shutil.which("cc")
    if compiler is None:
        pytest.skip("no C compiler on this machine")
    flags = ("-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-shared", "-fPIC")
    subprocess.run([compiler, *flags, "-o", str(source.with_suffix(".so")), str(source), "-lm"], check=True)
    found, channels = (ctypes.c_double * 6)(), (ctypes.c_double * 9)(20.0, 0.0, 0.0, *approach)
    assert (
        ctypes.CDLL(str(source.with_suffix(".so"))).deltacal_command((ctypes.c_double * 6)(*target), channels, found)
        == 0
    )
    return list(found)


def test_effects_of_the_legs_alone_stand_in_the_c_of_a_platform_that_turns(tmp_path: Path) -> None:
    """What depends on where the platform stands would have to know how it is turned, and is refused by name."""
    machine, names = robot(3), {"lacks": lacks("backlash", MACHINE, MACHINE.moves(robot()), MACHINE.roles(robot()))}
    play = blank("backlash", (2,), **names).with_values(np.array([[0.05]]))
    compensator = Compensator(machine, terms=(play,))
    left = export_c(compensator, tmp_path / "command.c")
    assert left.worst_mm < 1e-9
    target, approach = np.array([10.0, -5.0, 330.0, 3.0, -2.0, 4.0]), [1.0, -1.0, 1.0, 1.0, -1.0, 1.0]
    wanted = commanded.Wanted.of_array(target[None], compensator, {}).positions
    joints = compensator.command(wanted, None, channels_of(compensator, 1, {}))[0][0]
    plain = Compensator(machine).command(wanted)[0][0]
    moved = np.array(commanded_by_c(tmp_path / "command.c", target, approach)) - plain
    np.testing.assert_allclose(joints, plain, rtol=0, atol=1e-9)  # the middle of the play
    np.testing.assert_allclose(np.abs(moved), [0.0, 0.025, 0.0, 0.0, 0.0, 0.0], rtol=0, atol=1e-9)
    growth = blank(
        "thermal_growth", None, lacks=lacks("thermal_growth", MACHINE, MACHINE.moves(machine), MACHINE.roles(machine))
    )
    with pytest.raises(UsageError, match="thermal_growth: exported as a function of the position alone"):
        export_c(dataclasses.replace(compensator, terms=(play, growth)), tmp_path / "no.c")


def test_the_table_of_a_platform_that_turns_says_that_it_is_level(tmp_path: Path) -> None:
    export_table(Compensator(robot(3)), tmp_path / "table.csv")
    assert "# The platform is level" in (tmp_path / "table.csv").read_text()


@pytest.mark.parametrize("kind", CompensatorKind)
def test_a_set_point_of_the_servo_function_leaves_nothing_to_the_next(kind: str) -> None:
    """Rotations stand behind the position as Cayley vectors; one that no platform has does not end the loop."""
    compensator = Compensator(robot(), kind)
    at = poses(2)
    R = at[:, 3:].reshape(-1, 3, 3)
    axis = np.stack([R[:, 2, 1] - R[:, 1, 2], R[:, 0, 2] - R[:, 2, 0], R[:, 1, 0] - R[:, 0, 1]], axis=1)
    cayley = 2 * axis / (1 + np.trace(R, axis1=1, axis2=2))[:, None]
    first, second = np.hstack([at[:, :3], cayley]).tolist()
    command, state = compensator.servo()
    fresh = command(*first, state)
    assert fresh == pytest.approx(compensator.command(at[:1])[0][0], abs=1e-9)
    for k in range(3, 6):
        for bad in (1e300, 1e9, np.inf, np.nan):
            command(*[bad if j == k else v for j, v in enumerate(second)], state)
            assert command(*first, state) == fresh
    command(*second, state)
    assert command(*first, state) == fresh
