"""Every kind of measurement, as registered: files, derivatives, steps, noise, and the way from a simulation back."""

from __future__ import annotations

import ast
import dataclasses
import json
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from pydantic import TypeAdapter

from deltacal_gen.errors import InputError
from deltacal_gen.files.recording import read_recording
from deltacal_gen.files.robot import Robot
from deltacal_gen.files.writing import write_recording
from deltacal_gen.identification import identification
from deltacal_gen.instrument import kinds
from deltacal_gen.instrument.kind import Instrument, Kind, Readings
from deltacal_gen.instrument.kinds import instrument_of, kind_of, readings
from deltacal_gen.machine.registry import Array, Machine
from deltacal_gen.machine.rotation import from_vector, to_vector
from deltacal_gen.machine.values import Camera, Measurement, Recording
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.results.parts import InstrumentState
from deltacal_gen.use import prediction, validation
from tests.support.prototype import displaced, plausible, scattered

ROOT = Path(__file__).parents[2]
CAMERA = Camera(fx_px=1500.0, fy_px=1400.0, cx_px=640.0, cy_px=512.0, k1=-0.05, ball_radius_mm=20.0)
SAID = Measurement(camera=CAMERA, base_point_mm=(420.0, -150.0, 40.0))
POSES, FITTED = 40, 30
NOISE = 0.002  # mm
POINTS, BOARD = 4, [[0.0, 0.0], [100.0, 0.0], [100.0, 80.0], [10.0, 90.0]]
EVERY = (*kinds.names(), "height and distance")
MADE = [name for name in kinds.names() if kind_of(name).numbers or kind_of(name).pairs]  # what can be simulated


@pytest.fixture(scope="module")
def x() -> Array:
    """Platforms (12, 12) near each other, turned by up to 20 deg."""
    rng = np.random.default_rng(2)
    turned = from_vector(0.2 * rng.uniform(-1, 1, (12, 3))).reshape(-1, 9)
    return np.hstack([100 * rng.standard_normal((12, 3)) - [0, 0, 850], turned])


def looked_at(name: str, x: Array) -> Array:
    """Return what instruments of a kind look at: platforms x (N, 12), or joints (N, 3)."""
    return 0.01 * x[:, :3] if kind_of(name).sees_joints else x


def moved_by(name: str, x: Array, step: Array) -> Array:
    """Return platforms, or joints, displaced by steps (N, 6)."""
    return x + step[:, : x.shape[1]] if kind_of(name).sees_joints else displaced(x, step)


def taken(name: str, x: Array, mechanism: Machine) -> tuple[Readings, Instrument]:
    """Return the readings of a kind at poses, two reference points' worth, and an instrument in general position."""
    kind = kind_of(name)
    found, at = kind.imagined(looked_at(name, x), 2, mechanism, SAID)
    if kind.unknown and len(at.state) == 1:  # an instrument of two set-ups
        at = dataclasses.replace(at, state=np.tile(at.state, (2, 1)))
        found = dataclasses.replace(found, setup=np.arange(len(found)) % 2)
    rng = np.random.default_rng(5)
    size = 0.2 * kind.typical[list(at.free)] * rng.uniform(-1, 1, (len(at.state), len(at.free)))
    return found, at.stepped(size.reshape(-1))


def wanted(robot: Robot, mechanism: Machine, name: str) -> Recording:
    """Return a recording of a kind without readings, at targets."""
    kind = kind_of(name)
    each = POINTS if kind.known else 1  # points of a board that one image shows
    targets = np.repeat(scattered(robot, POSES // each, 11), each, axis=0)
    pairs = np.column_stack([np.arange(0, POSES, 2), np.arange(1, POSES, 2)]) if kind.pairs else None
    columns = kind.columns(mechanism)
    return Recording(
        path=Path("recording.csv"),
        kind=name,
        measurement=dataclasses.replace(SAID, kind=name, sigma_mm=NOISE),
        joint_unit=mechanism.joint_unit,
        joints=np.full((POSES, mechanism.limbs), np.nan),
        columns=columns,
        measured=np.full((POSES, len(columns) if kind.numbers else 0), np.nan),
        pose=(1 + np.arange(POSES) // each).astype(str),
        line=np.arange(POSES) + 2,
        channels=dict(zip(kind.known, np.resize(BOARD, (POSES, 2)).T, strict=True)) if kind.known else {},
        setup=np.zeros(POSES, dtype=int),
        setup_names=("1",),
        targets=targets,
        pairs=pairs,
        pair_measured=None if pairs is None else np.full(len(pairs), np.nan),
        pair_line=None if pairs is None else np.arange(len(pairs)) + 2,
    )


def cells(recording: Recording) -> Array:
    """Return what was measured, of rows or of pairs."""
    found = recording.measured if recording.pair_measured is None else recording.pair_measured
    return np.asarray(found)


# --------------------------------------------------------------------------------------------------------- derivatives


def change(found: Readings, before: Instrument, after: Instrument, x: Array, moved: Array) -> Array:
    """Return how readings change: values, and the rotation vector between rotations."""
    values, rotations = before.predict(found, x)
    new_values, new_rotations = after.predict(found, moved)
    gap = before.at_platform[: values.shape[1]] * (new_values - values)  # NaN in the columns of other kinds
    if rotations is not None and new_rotations is not None:
        gap = np.hstack([gap, to_vector(new_rotations @ np.swapaxes(rotations, 1, 2))])
    return gap


@pytest.mark.parametrize("name", EVERY)
def test_readings_have_the_derivatives_they_are_said_to_have(x: Array, mechanism: Machine, name: str) -> None:
    """By the platform's coordinates and by every unknown, along steps of the state: central differences."""
    found, at = taken(name, x, mechanism)
    rng, x = np.random.default_rng(3), looked_at(name, x)
    direction = rng.standard_normal((12, 6, 3)) * np.array([1, 1, 1, 1e-3, 1e-3, 1e-3])[:, None]
    direction = direction[:, : x.shape[1]]
    J_p, J_m = at.linearise(found, x, direction)
    assert J_p.shape == (len(found), at.kind.width + len(at.kind.turned), 3)
    assert J_m.shape == (*J_p.shape[:2], at.n_unknown)

    def extrapolated(step) -> Array:
        return np.asarray((8 * (step(0.5) - step(-0.5)) - (step(1.0) - step(-1.0))) / 6)

    for c in range(3):

        def by_platform(h: float, c: int = c) -> Array:
            return np.nan_to_num(change(found, at, at, x, moved_by(name, x, h * direction[:, :, c])))

        assert J_p[:, :, c] == pytest.approx(extrapolated(by_platform), abs=1e-7, rel=1e-7)
    for c in range(at.n_unknown):
        unit = 1e-3 if at.unknown[c][1] == "rad" else 1.0

        def by_unknown(h: float, c: int = c, unit: float = unit) -> Array:
            step = np.zeros(at.n_unknown)
            step[c] = h * unit
            return change(found, at, at.stepped(step), x, x) / unit

        assert J_m[:, :, c] == pytest.approx(extrapolated(by_unknown), abs=1e-6, rel=1e-7)


@pytest.mark.parametrize("name", EVERY)
def test_an_instrument_survives_a_result_file(x: Array, mechanism: Machine, name: str) -> None:
    found, at = taken(name, x, mechanism)
    x = looked_at(name, x)
    kept = TypeAdapter(InstrumentState).validate_json(json.dumps(at.kept(["0"], "absolute").to_dict()))
    again = instrument_of(kept)
    again.check_state()
    assert again.kind == at.kind
    assert (again.free, again.scale, again.home, again.ties) == (at.free, at.scale, at.home, at.ties)
    assert again.predict(found, x)[0] == pytest.approx(at.predict(found, x)[0], abs=0, nan_ok=True)


@pytest.mark.parametrize("name", EVERY)
def test_a_residual_s_columns_have_one_noise_each(x: Array, mechanism: Machine, name: str) -> None:
    found, at = taken(name, x, mechanism)
    x = looked_at(name, x)
    columns = at.linearise(found, x, np.zeros((12, min(6, x.shape[1]), 0)))[0].shape[1]
    groups = found.kind.noise_groups(columns)
    assert len(groups) == columns
    assert set(groups.tolist()) == set(range(groups.max() + 1))
    turned = {groups[c] for c in found.kind.turned}
    assert turned.isdisjoint(groups[c] for c in range(columns) if c not in found.kind.turned)  # nor any other's


@pytest.mark.parametrize("name", EVERY)
def test_unknowns_are_told_by_name_unit_and_usual_size(name: str) -> None:
    kind = kind_of(name)
    assert kind.meaning
    assert len({name for name, _ in kind.unknown}) == len(kind.unknown)
    assert {unit for _, unit in kind.unknown} <= {"mm", "rad", "1"}
    assert (kind.typical > 0).all()


# --------------------------------------------------------------------------------------------------------------- files


@pytest.mark.parametrize("name", MADE)
def test_readings_survive_their_file(robot: Robot, mechanism: Machine, tmp_path: Path, name: str) -> None:
    made = simulate(robot, wanted(robot, mechanism, name), noise_mm=NOISE, rng=np.random.default_rng(1))
    write_recording(made, tmp_path / "recording.csv")
    again = read_recording(tmp_path / "recording.csv", mechanism)
    assert again.kind == name
    assert again.columns == made.columns
    assert cells(again) == pytest.approx(cells(made), abs=1e-12)
    assert again.measurement.camera == made.measurement.camera
    (tmp_path / "recording.toml").write_text(
        (tmp_path / "recording.toml").read_text().replace(f'kind = "{name}"\n', "")
    )
    assert read_recording(tmp_path / "recording.csv", mechanism).kind == name  # the columns say it too


@pytest.mark.parametrize("name", MADE)
def test_what_is_simulated_is_identified_predicted_and_validated(robot: Robot, mechanism: Machine, name: str) -> None:
    errors = plausible(mechanism, 7, mechanism.models["delta/3"])
    rng = np.random.default_rng(4)
    made = simulate(robot, wanted(robot, mechanism, name), errors, noise_mm=NOISE, noise_rad=1e-5, rng=rng)
    seen, new = made.subset(slice(0, FITTED)), made.subset(slice(FITTED, POSES))
    model = "delta/0" if kind_of(name).sees_joints else "delta/3"  # no source error moves a joint
    result = identification.identify(robot, seen, model).answer()
    for parameter in result["parameters"]:
        if parameter["status"] == "identified" and parameter["name"] in errors:
            off = parameter["value"] - errors[parameter["name"]] * 180 / np.pi
            assert abs(off) < 5 * parameter["std"], parameter["name"]
    blank = dataclasses.replace(
        new,
        measured=np.full(new.measured.shape, np.nan),
        pair_measured=None if new.pair_measured is None else np.full(len(new.pair_measured), np.nan),
    )
    predicted = prediction.predict(result, blank)
    r = prediction.residual(result, new, readings(new))
    assert validation.validate(result, new)["rms_mm"] < 3 * NOISE
    again = readings(predicted)
    assert prediction.residual(result, predicted, again) == pytest.approx(np.zeros_like(r), abs=1e-7)


def test_what_cannot_be_simulated_says_so(robot: Robot, mechanism: Machine) -> None:
    for name in set(kinds.names()) - set(MADE):
        with pytest.raises(InputError, match="could be simulated"):
            simulate(robot, wanted(robot, mechanism, name))


# -------------------------------------------------------------------------------------------------------- the registry


def test_a_length_beside_angles_counts_as_it_is(x: Array, monkeypatch: pytest.MonkeyPatch) -> None:
    """Of a tracker that tells range and azimuth only the angle has another size at the platform than in its column."""

    def reading(at: Array, given: Array) -> Array:
        return np.column_stack([np.hypot(at[:, 0], at[:, 1]), np.arctan2(at[:, 1], at[:, 0])])

    slopes = np.ones((len(x), 2, 1, 6)), np.ones((len(x), 2, 1))
    kernels = SimpleNamespace(
        COLUMNS=("range_mm", "azimuth_deg"), ROTATION_ROWS=(), ROWS=2, UNKNOWN=(("w", "rad", 1, ""),)
    )
    vars(kernels).update(reading=reading, by_platform=lambda *_: slopes[0], by_unknown=lambda *_: slopes[1], TARGETS={})
    monkeypatch.setattr(Kind, "kernels", kernels)
    tracker, rows = Kind("tracker"), np.arange(len(x))[:, None]
    found = tracker.taken(rows, values=reading(x, x) + np.array([0.01, 1e-5]))
    at = Instrument(tracker, np.zeros((1, 1)), (0,), 3000.0)
    assert tracker.unit == "mm"
    np.testing.assert_allclose(at.residual(found, x), np.tile([0.01, 0.03], (len(x), 1)), rtol=1e-6)
    by_platform, by_unknown = at.linearise(found, x, np.ones((len(x), 6, 1)))
    np.testing.assert_allclose(by_platform[:, :, 0], np.tile([6.0, 18000.0], (len(x), 1)))
    np.testing.assert_allclose(by_unknown[:, :, 0], np.tile([1.0, 3000.0], (len(x), 1)))


def test_a_name_that_is_none_is_refused() -> None:
    with pytest.raises(InputError, match="no kind of measurement 'weight'"):
        kind_of("weight")


def test_kinds_with_unknowns_cannot_be_read_together() -> None:
    with pytest.raises(ValueError, match="position"):
        kind_of("height and position")


def test_nobody_else_compares_names_of_kinds() -> None:
    """What holds for a kind its object says; only the kinds' own files know their names."""
    names = {*kinds.names()}

    def constants(node: ast.AST) -> set[object]:
        return {n.value for n in ast.walk(node) if isinstance(n, ast.Constant)}

    found = []
    for path in sorted((ROOT / "src" / "deltacal_gen").rglob("*.py")):
        if "kinds" in path.parts:
            continue
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            sides = [node.left, *node.comparators] if isinstance(node, ast.Compare) else []
            asks = any("kind" in ast.unparse(side) for side in sides)
            if asks and any(constants(side) & names for side in sides):
                found.append(f"{path.name}:{node.lineno}: {ast.unparse(node)}")
            if isinstance(node, ast.match_case) and constants(node.pattern) & names:
                found.append(f"{path.name}:{node.pattern.lineno}: {ast.unparse(node.pattern)}")
    assert found == []
