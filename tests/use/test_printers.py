"""What printer owners do: import what firmware keeps, calibrate, write it back, compare two sessions."""

from __future__ import annotations

import dataclasses
import json
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen import InputError, NoSolutionError, UsageError, import_klipper, import_marlin, import_rrf
from deltacal_gen.files.robot import Robot, robot_from_dict, robot_to_toml
from deltacal_gen.files.writing import write_recording
from deltacal_gen.identification.identification import identify
from deltacal_gen.machine.registry import Array
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.results.result import flattered
from deltacal_gen.results.written import FirmwareLines
from deltacal_gen.units import DEG
from deltacal_gen.use.exporters import exporter_of
from deltacal_gen.use.firmware import Printed
from tests.support.commands import Run
from tests.support.printers import (
    LINEAR,
    PRINTER,
    STEP,
    Z_OFFSET,
    grid,
    joints,
    plausible,
    printer_cfg,
    recording,
    session,
)

pytestmark = pytest.mark.usefixtures("compiled")

Spoil = Callable[[Array, list[Any]], tuple[Array, list[Any]]]


@pytest.fixture(scope="module")
def printer() -> Robot:
    return robot_from_dict(PRINTER | {"transmission": {"pulley_circumference": 40.0}})


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(5)


def test_a_klipper_session_comes_back_as_it_was(tmp_path: Path, printer: Robot) -> None:
    heights, distances = session(printer)
    file = tmp_path / "printer.cfg"
    file.write_text(printer_cfg(printer, heights, distances))
    got = import_klipper(file, tmp_path / "out")
    assert not got.warnings
    for key in ("radius", "arm_length", "tower_angle", "endstop"):
        assert got.robot.geometry[key] == pytest.approx(printer.geometry[key], abs=1e-5), key
    back = got.recordings["recording"]
    assert back.joints[: len(heights)] == pytest.approx(heights, abs=1e-5)
    assert back.pair_measured == pytest.approx([d[0] for d in distances])
    found = dc.identify(tmp_path / "out" / "robot.toml", tmp_path / "out" / "recording.csv", model="9")
    assert found["readings"]["kind"] == "height and distance"
    assert found["train_rms_mm"] < 1e-3


def test_the_saved_block_alone_tells_the_length_of_a_step(tmp_path: Path, printer: Robot) -> None:
    """Also where the endstops were edited afterwards; but only a step that there is, of a pulley with whole teeth."""
    heights, distances = session(printer)
    edited = dataclasses.replace(printer, geometry=printer.geometry | {"endstop": printer.geometry["endstop"] + 12.0})

    def saved(robot: Robot, heights: Array) -> Path:
        text = printer_cfg(robot, heights, distances)
        file = tmp_path / "saved.txt"
        file.write_text("".join(line for line in text.splitlines(keepends=True) if line.startswith("#*#")))
        return file

    for robot in (printer, edited):
        found = import_klipper(saved(robot, heights))
        assert found.recordings["recording"].joints[: len(heights)] == pytest.approx(heights, abs=STEP)
        assert any("0.0125 mm" in w and "40 mm a turn" in w for w in found.warnings)
    with pytest.raises(InputError, match="usual pulley"):
        import_klipper(saved(printer, heights / 1.02))


def test_a_mesh_is_what_the_probe_met(tmp_path: Path, printer: Robot) -> None:
    """Carriages computed back put the nozzle where the probe fired, less the probe's own offset."""
    rng = np.random.default_rng(1)
    z = 0.1 * rng.standard_normal((5, 5))
    points = "\n".join("\t " + ", ".join(f"{v:.6f}" for v in row) for row in z)
    mesh = f"[bed_mesh default]\nversion = 1\npoints =\n{points}\nx_count = 5\ny_count = 5\n" + "\n".join(
        f"{m}_{a} = {s}80.0" for m, s in (("min", "-"), ("max", "")) for a in "xy"
    )
    file = tmp_path / "printer.cfg"
    file.write_text(printer_cfg(printer, *session(printer), mesh))
    got = import_klipper(file)
    found = got.recordings["mesh_default"]
    x = LINEAR.forward(found.joints, got.robot.tool, LINEAR.rows(got.robot))[0][:, :3]
    axis = np.linspace(-80, 80, 5)
    inside = np.hypot(*np.meshgrid(axis, axis)) <= 80
    assert len(x) == inside.sum() == 13
    few = dc.diagnose(got.robot, found)  # too few readings for any physics, and an answer all the same
    assert (few["verdict"], few["effects"]) == ("adequate", [])
    assert all("fewer cannot tell it from geometry" in t["missing"] for t in few["not_tested"])
    assert x[:, 0] == pytest.approx(np.meshgrid(axis, axis)[0][inside] - 2.0, abs=1e-6)
    assert x[:, 2] == pytest.approx(z[inside] + Z_OFFSET, abs=1e-5)
    assert (found.measured == Z_OFFSET).all()


@pytest.mark.parametrize(
    ("spoil", "message"),
    [
        (lambda h, d: (h, [*d[:3], d[2], *d[4:]]), "one line was entered twice"),
        (lambda h, d: (h, [(d[0][0] / 10, *d[0][1:]), *d[1:]]), "no geometry allows that"),
        (lambda h, d: (h * [1.0, 4.0, 1.0], d), "the rods do not reach"),
    ],
)
def test_mistakes_are_caught_before_any_fit(spoil: Spoil, message: str, tmp_path: Path, printer: Robot) -> None:
    file = tmp_path / "printer.cfg"
    file.write_text(printer_cfg(printer, *spoil(*session(printer))))
    with pytest.raises(InputError, match=message):
        import_klipper(file)


def test_exchanged_distances_are_named(tmp_path: Path, printer: Robot) -> None:
    heights, distances = session(printer)
    far = joints(printer, np.array([[-70.0, 0, 1], [70.0, 0, 1]]))
    distances.append((140.0, *far))
    distances[3], distances[12] = (distances[12][0], *distances[3][1:]), (distances[3][0], *distances[12][1:])
    file = tmp_path / "printer.cfg"
    file.write_text(printer_cfg(printer, heights, distances))
    with pytest.raises(InputError, match="agrees with distance12: the two are exchanged"):
        import_klipper(file)


def test_endstops_edited_after_probing_and_absurd_arms_are_warned_of(tmp_path: Path, printer: Robot) -> None:
    heights, _ = session(printer)
    file = tmp_path / "printer.cfg"
    edited = printer.geometry | {"endstop": printer.geometry["endstop"] + 5.0}
    file.write_text(printer_cfg(dataclasses.replace(printer, geometry=edited), heights, []))
    assert "off by 5.000 mm alike" in import_klipper(file).warnings[0]
    absurd = printer.geometry | {"arm_length": np.array([225.0, 391.0, 214.0])}
    file.write_text(printer_cfg(dataclasses.replace(printer, geometry=absurd), heights[:0], session(printer)[1]))
    with pytest.raises(InputError):
        import_klipper(file)


def test_a_wrong_step_length_is_named_with_the_one_that_fits(tmp_path: Path, printer: Robot) -> None:
    file = tmp_path / "printer.cfg"
    file.write_text(printer_cfg(printer, *session(printer)).replace("microsteps: 16", "microsteps: 20"))
    with pytest.raises(InputError, match=r"one factor of 1\.25; steps of 0\.0125 mm, of a pulley of 40 mm"):
        import_klipper(file)


@pytest.mark.parametrize("wrong", [8, 32])
def test_wrong_microsteps_are_named_before_a_first_calibration(wrong: int, tmp_path: Path, printer: Robot) -> None:
    """The bed of such a printer is bent by more than a millimetre with the right steps, too."""
    heights = joints(printer, grid(80, 40, Z_OFFSET), {"endstop_1": 1.5, "radius_2": 0.8})
    file, right = tmp_path / "printer.cfg", printer_cfg(printer, heights, [])
    file.write_text(right)
    import_klipper(file)
    file.write_text(right.replace("microsteps: 16", f"microsteps: {wrong}"))
    with pytest.raises(InputError, match=r"steps of 0\.0125 mm, of a pulley of 40 mm a turn, fit"):
        import_klipper(file)


@pytest.mark.parametrize(("kinematics", "words"), [("rotary_delta", "arms that turn"), ("winch", "cables")])
def test_near_relations_of_klipper_are_refused_by_name(tmp_path: Path, kinematics: str, words: str) -> None:
    file = tmp_path / "printer.cfg"
    file.write_text(f"[printer]\nkinematics: {kinematics}\n")
    with pytest.raises(InputError, match=words):
        import_klipper(file)


@pytest.mark.parametrize(
    ("points", "expected"),
    [("0, 1\n2", "not equally long"), ("0, 1\n2, x", "is 'x': a number"), ("0, 1\n2, nan", "is 'nan': a number")],
)
def test_a_damaged_mesh_is_named(tmp_path: Path, printer: Robot, points: str, expected: str) -> None:
    file = tmp_path / "printer.cfg"
    rows = points.replace("\n", "\n  ")
    mesh = f"[bed_mesh default]\npoints =\n  {rows}\nmin_x = -9\nmax_x = 9\nmin_y = -9\nmax_y = 9"
    file.write_text(printer_cfg(printer, *session(printer), mesh))
    with pytest.raises(InputError, match=expected):
        import_klipper(file)


def test_files_that_are_something_else_say_so(tmp_path: Path, printer: Robot) -> None:
    file = tmp_path / "printer.cfg"
    file.write_text("[printer]\nkinematics: corexy\n")
    with pytest.raises(InputError, match="no linear delta"):
        import_klipper(file)
    heights, distances = session(printer)
    file.write_text(printer_cfg(printer, heights[:0], distances).replace("microsteps: 16", ""))
    with pytest.raises(InputError, match="does not say how long a step is"):
        import_klipper(file)


def test_a_map_of_reprapfirmware(tmp_path: Path, run: Run) -> None:
    config, chart = tmp_path / "config.g", tmp_path / "heightmap.csv"
    config.write_text("M665 R130 L270 B90 H300 X-0.5 Y0.25 ; delta\nM666 X-0.4 Y0.1 Z0.3\nG31 P500 X0 Y10 Z2.5\n")
    chart.write_text(
        "RepRapFirmware height map file v2 generated at 2026-01-01 00:00, mean error 0.0, deviation 0.1\n"
        "xmin,xmax,ymin,ymax,radius,xspacing,yspacing,xnum,ynum\n-40.00,40.10,-40.00,40.10,45.00,40.00,40.00,3,3\n"
        "      0,  0.100,      0\n -0.050,  0.000,  0.025\n      0, -0.110,      0\n"
    )
    code, out, _ = run("import", "rrf", config, chart, "-o", tmp_path / "out", "--json")
    assert code == 0
    assert [Path(file).name for file in json.loads(out)["files"]] == ["robot.toml", "recording.csv"]
    got = import_rrf(config, chart)
    assert got.robot.geometry["tower_angle"] / DEG == pytest.approx([209.5, 330.25, 90.0])
    assert got.robot.geometry["endstop"] == pytest.approx([299.6, 300.1, 300.3])
    found = got.recordings["recording"]
    x = LINEAR.forward(found.joints, got.robot.tool, LINEAR.rows(got.robot))[0][:, :3]
    assert x[:, 2] - 2.5 == pytest.approx([0.1, -0.05, 0.0, 0.025, -0.11], abs=1e-6)
    assert x[0, :2] == pytest.approx([0, -50.0], abs=1e-6)


MARLIN = """echo:; Endstop adjustment:
echo:  M666 X-0.40 Y0.00 Z-0.25
echo:; Delta settings: L<diagonal rod> R<radius> H<height> S<segments per sec> XYZ<tower angle trim> ABC<rod trim>
echo:  M665 L270.00 R130.00 H300.00 S200.00 X-0.50 Y0.25 Z0.00 A0.10 B0.00 C-0.10
echo:  M851 X0.00 Y10.00 Z-2.50 ; (mm)
"""


def test_a_log_of_marlin(tmp_path: Path, run: Run) -> None:
    log = tmp_path / "marlin.txt"
    log.write_text(f"{MARLIN}Bed X: 0.000 Y: -40.000 Z: 0.100\nBed X: 10.0 Y: 5.0 Z: -0.050\nok\n")
    code, out, _ = run("import", "marlin", log, "-o", tmp_path / "out", "--json")
    assert code == 0
    assert [Path(file).name for file in json.loads(out)["files"]] == ["robot.toml", "recording.csv"]
    written = "".join((tmp_path / "out" / name).read_text() for name in ("robot.toml", "recording.csv"))
    assert not re.findall(r"\d+\.\d{7,}", written)  # sums of what the firmware says are as short as it says them
    got = import_marlin(log)
    assert got.robot is not None
    assert got.robot.geometry["tower_angle"] / DEG == pytest.approx([209.5, 330.25, 90.0])
    assert got.robot.geometry["arm_length"] == pytest.approx([270.1, 270.0, 269.9])
    assert got.robot.geometry["endstop"] == pytest.approx([300.4, 300.0, 300.25])
    x = LINEAR.forward(got.recordings["recording"].joints, got.robot.tool, LINEAR.rows(got.robot))[0][:, :3]
    assert x == pytest.approx(np.array([[0, -50.0, 2.6], [10.0, -5.0, 2.45]]), abs=1e-6)


def test_a_report_of_g33_counts_where_it_came_last(tmp_path: Path) -> None:
    log = tmp_path / "marlin.txt"
    report = (
        ".Height:297.85    Ex:-0.18  Ey:-0.13  Ez:+0.00    Radius:100.68\n"
        ".Tower angle :    Tx:-0.05  Ty:+0.08  Tz:+0.00\n"
    )
    log.write_text(f"{MARLIN}{report}Bed X: 0.0 Y: 0.0 Z: 0.1\n")
    got = import_marlin(log).robot
    assert got is not None
    assert got.geometry["radius"][0] == pytest.approx(100.68)
    assert got.geometry["endstop"] == pytest.approx([298.03, 297.98, 297.85])
    assert got.geometry["tower_angle"] / DEG == pytest.approx([209.95, 330.08, 90.0])


def test_a_topography_of_the_unified_bed_levelling(tmp_path: Path) -> None:
    log = tmp_path / "marlin.txt"
    report = (
        "Bed Topography Report:\n\n    (-50,50)                 (50,50)\n"
        "        0       1       2\n"
        " 2 |   .    +0.030    .\n   |\n 1 | -0.010 [+0.000] +0.020\n   |\n 0 |   .    -0.040    .\n"
        "        0       1       2\n    (-50,-50)                (50,-50)\n"
    )
    log.write_text(MARLIN + report)
    got = import_marlin(log)
    assert got.robot is not None
    x = LINEAR.forward(got.recordings["recording"].joints, got.robot.tool, LINEAR.rows(got.robot))[0][:, :3]
    probed = {(round(a), round(b + 10)): round(c - 2.5, 3) for a, b, c in x.tolist()}
    assert probed == {(0, 50): 0.03, (-50, 0): -0.01, (0, 0): 0.0, (50, 0): 0.02, (0, -50): -0.04}


def test_a_grid_without_places_is_refused_with_the_way_out(tmp_path: Path) -> None:
    log = tmp_path / "marlin.txt"
    log.write_text(f"{MARLIN}Bilinear Leveling Grid:\n      0      1\n 0 +0.1 +0.2\n 1 +0.1 +0.0\n")
    with pytest.raises(InputError, match=r"where the points of the grid lie\. Probe with G29 V4"):
        import_marlin(log)
    log.write_text(f"{MARLIN}G33 Auto Calibrate\n.     c:+0.02 x:+0.12 y:-0.08 z:+0.04\n")
    with pytest.raises(InputError, match=r"heights of G33 are averages, .*Probe with G29 V4"):
        import_marlin(log)


@pytest.mark.parametrize("kind", ["klipper", "rrf", "marlin"])
def test_firmware_gets_back_what_it_can_carry(
    kind: str, tmp_path: Path, printer: Robot, rng: np.random.Generator
) -> None:
    """A machine that firmware can describe goes there and back exactly."""
    errors = plausible(rng, LINEAR.model("linear_delta/9"))
    lines = exporter_of(kind).describe(dataclasses.replace(printer, errors=errors))
    assert not lines.not_carried
    assert lines.after.worst_mm < 1e-5
    if kind == "klipper":
        file = tmp_path / "printer.cfg"
        bare = printer_cfg(printer, *session(printer)).split("#*# [printer]")[0]
        steps = ",".join(f"{v:.3f}" for v in joints(printer, np.array([[0, 0, 0.0]]), errors)[0] / STEP)
        file.write_text(f"{bare}\n{lines.text}\n[delta_calibrate]\nheight0: 0\nheight0_pos: {steps}\n")
        got = import_klipper(file).robot
    elif kind == "marlin":
        file = tmp_path / "marlin.txt"
        file.write_text(f"{lines.text}\nBed X: 0 Y: 0 Z: 0\n")
        got = import_marlin(file).robot
    else:
        config, chart = tmp_path / "config.g", tmp_path / "map.csv"
        config.write_text(lines.text)
        chart.write_text("height map\nxmin,xmax,ymin,ymax,radius,xspacing,yspacing,xnum,ynum\n0,1,0,1,1,1,1,1,1\n0.0\n")
        got = import_rrf(config, chart).robot
    q = joints(printer, grid(80, 40, 20.0), errors)
    x = LINEAR.forward(q, got.tool, LINEAR.rows(got))[0][:, :3]
    assert x == pytest.approx(grid(80, 40, 20.0), abs=2e-3)


def test_firmware_lines_say_what_they_cannot_carry(printer: Robot) -> None:
    leaning = dataclasses.replace(printer, errors={"lean_radial_1": 0.3 * DEG, "scale_2": 0.001})
    lines = exporter_of("klipper").describe(leaning, ["transmission_eccentricity"])
    assert lines.after.worst_mm > 0.005
    assert f"{lines.after.worst_mm:.4f} mm" in lines.text
    assert "lean_radial_1 = +0.3000 deg" in lines.text
    assert f"rotation_distance: {40 * 1.001:.6f}" in lines.text
    assert "the effect transmission_eccentricity" in lines.text
    with pytest.raises(UsageError, match="known: c, klipper, marlin, rrf, table"):
        exporter_of("grbl")


@pytest.mark.parametrize("model", [None, "21"])
def test_a_machine_beyond_firmware_gets_the_firmware_s_own_fit(
    tmp_path: Path, printer: Robot, rng: np.random.Generator, run: Run, model: str | None
) -> None:
    """What is written leaves on the bed what firmware's parameters leave of the readings: no truncated machine."""
    truth = plausible(rng, LINEAR.model("linear_delta/21"))
    heights = simulate(printer, recording(printer, grid(100, 20)), truth, noise_mm=0.01, rng=rng)
    found = dc.identify(printer, heights, model=model, output=tmp_path / "result.json")
    lines = dc.export_compensator(found, export="rrf", output=tmp_path / "config.g")
    assert lines.by_readings
    config = tmp_path / "config.g"
    assert config.read_text() == lines.text
    (tmp_path / "map.csv").write_text("height map\nxmin,xspacing,ymin,yspacing\n0,1,0,1\n0.0\n")
    got = import_rrf(config, tmp_path / "map.csv").robot
    assert got is not None
    x = LINEAR.forward(heights.joints, got.tool, LINEAR.rows(got))[0]
    left = x[:, 2] - heights.measured[:, 0]
    assert np.sqrt(np.mean(left**2)) == pytest.approx(found["firmware"]["train_rms_mm"], rel=0.02)
    assert lines.after.bed_rms_mm < lines.before.bed_rms_mm
    out = run("compensate", tmp_path / "result.json", "--export", "rrf", "-o", tmp_path / "lines.g")[1]
    assert "in the file now" in out
    assert f"{lines.after.bed_rms_mm:.4f}" in out


def test_lines_of_a_diagnosed_machine_put_the_bed_first(printer: Robot, rng: np.random.Generator) -> None:
    errors = plausible(rng, LINEAR.model("linear_delta/21"))
    lines = exporter_of("klipper").describe(dataclasses.replace(printer, errors=errors))
    assert not lines.by_readings
    assert lines.after.bed_rms_mm < 0.5 * lines.before.bed_rms_mm
    assert lines.after.bed_rms_mm < 0.1 * lines.after.lateral_rms_mm


def test_lines_by_heights_alone_ask_for_the_bed_alone(printer: Robot, run: Run, tmp_path: Path) -> None:
    """A mesh leaves open where across the bed the nozzle is: lines that follow what is made up there bend the bed.

    Held against the machine that was simulated, they leave on its bed what the firmware's own fit leaves.
    """
    rng = np.random.default_rng(1)
    truth = plausible(rng, LINEAR.model("linear_delta/21"))
    heights = simulate(printer, recording(printer, grid(100, 30)), truth, noise_mm=0.01, rng=rng)
    bed = Printed(dataclasses.replace(printer, errors=truth), LINEAR, belts=False)

    def left(lines: FirmwareLines) -> float:
        radius, *others = (v.after for v in lines.values)
        keys = zip(("arm_length", "tower_angle", "endstop"), np.split(np.array(others), 3), strict=True)
        numbers = {key: values * (DEG if key == "tower_angle" else 1.0) for key, values in keys}
        geometry = {**printer.geometry, "radius": np.array([radius]), **numbers}
        return bed.left(dataclasses.replace(printer, geometry=geometry)).bed_rms_mm

    of_klipper = {"export": "klipper", "output": tmp_path / "printer.cfg"}
    by_diagnosis = dc.export_compensator(dc.diagnose(printer, heights, output=tmp_path / "d.json"), **of_klipper)
    by_fit = dc.export_compensator(dc.identify(printer, heights), **of_klipper)
    assert by_diagnosis.heights_alone
    assert not by_diagnosis.by_readings
    assert left(by_diagnosis) < 1.2 * left(by_fit)
    assert {v.after for v in by_diagnosis.values if v.name.startswith("arm")} == {270.0, 270.5, 269.5}
    out = run("compensate", tmp_path / "d.json", "--export", "klipper", "-o", tmp_path / "lines.cfg")[1]
    assert "lateral" not in out
    assert "heights alone do not determine" in " ".join(out.split())


def test_lines_that_are_worse_than_those_in_the_file_are_refused(
    tmp_path: Path, printer: Robot, rng: np.random.Generator
) -> None:
    heights = simulate(printer, recording(printer, grid(100, 30)), {}, noise_mm=0.01, rng=rng)
    found = dc.identify(printer, heights, model="6")
    worse = found.replace(heldout_rms_mm=2 * found.before_rms_mm)
    with pytest.raises(NoSolutionError, match="your current values are already as good"):
        dc.export_compensator(worse, export="klipper", output=tmp_path / "lines.cfg")
    assert not (tmp_path / "lines.cfg").exists()


# ------------------------------------------------------------------------------------------------------- two sessions


def test_what_changed_is_named_and_the_rest_is_not(printer: Robot, rng: np.random.Generator) -> None:
    targets = rng.uniform([-80, -80, 0], [80, 80, 80], (60, 3))
    truth = plausible(rng, LINEAR.model("linear_delta/9"))
    poses = recording(printer, targets, "position")
    later = truth | {"endstop_2": truth["endstop_2"] + 0.2}
    first, second = (
        identify(printer, simulate(printer, poses, t, noise_mm=0.01, rng=rng), "9").answer() for t in (truth, later)
    )
    found = dc.compare(first, second)
    assert [e["name"] for e in found["changed"]] == ["endstop_2"]
    assert found["changed"][0]["change"] == pytest.approx(0.2, abs=0.03)
    assert "endstop_2 moved +0.2" in found["summary"]
    assert len(found["unchanged"]) == 8


def test_sessions_from_different_robot_files_are_compared_by_the_machine(
    printer: Robot, rng: np.random.Generator
) -> None:
    """Firmware saves a new geometry after every session: what the file took over is no change."""
    targets = rng.uniform([-80, -80, 0], [80, 80, 80], (60, 3))
    truth = plausible(rng, LINEAR.model("linear_delta/9"))
    done = simulate(printer, recording(printer, targets, "position"), truth, noise_mm=0.01, rng=rng)
    moved = dataclasses.replace(
        printer,
        geometry=printer.geometry
        | {"radius": printer.geometry["radius"] + 0.3, "arm_length": printer.geometry["arm_length"] + 0.2},
    )
    first, second = (identify(robot, done, "9").answer() for robot in (printer, moved))
    found = dc.compare(first, second)
    assert not found["changed"]
    assert {e["name"] for e in found["unchanged"]} == set(LINEAR.model("linear_delta/9"))
    other = dataclasses.replace(printer, geometry=printer.geometry | {"rod_spacing": np.array([60.0])})
    with pytest.raises(InputError, match="rod_spacing"):
        dc.compare(first, identify(other, done, "9").answer())


def test_a_session_from_the_file_calibrated_before_shows_only_what_moved(
    printer: Robot, rng: np.random.Generator
) -> None:
    """The second result counts from the first one's robot; what that robot holds already is no change."""
    targets = rng.uniform([-80, -80, 0], [80, 80, 80], (60, 3))
    truth = plausible(rng, LINEAR.model("linear_delta/9"))
    moved = truth | {"endstop_2": truth["endstop_2"] + 0.2}
    poses = recording(printer, targets, "position")
    before, after = (simulate(printer, poses, t, noise_mm=0.01, rng=rng) for t in (truth, moved))
    first = identify(printer, before, "9")
    found = dc.compare(first.answer(), identify(first.robot, after, "9").answer())
    assert [e["name"] for e in found["changed"]] == ["endstop_2"]
    assert found["changed"][0]["change"] == pytest.approx(0.2, abs=0.03)


def test_what_firmware_would_fit_stands_beside(
    tmp_path: Path, printer: Robot, rng: np.random.Generator, run: Run
) -> None:
    truth = plausible(rng, LINEAR.model("linear_delta/21"))
    heights = simulate(printer, recording(printer, grid(100, 20)), truth, noise_mm=0.01, rng=rng)
    found = dc.identify(printer, heights)
    beside = found["firmware"]
    assert found["model"] == "linear_delta/21"
    assert beside["model"] == "linear_delta/6"
    assert beside["train_rms_mm"] == pytest.approx(dc.identify(printer, heights, model="6")["train_rms_mm"])
    assert found["heldout_rms_mm"] < beside["heldout_rms_mm"]
    assert "firmware" not in dc.identify(printer, heights, model="6")
    (tmp_path / "robot.toml").write_text(robot_to_toml(printer))
    write_recording(heights, tmp_path / "mesh.csv")
    _, text, _ = run("identify", tmp_path / "robot.toml", tmp_path / "mesh.csv")
    assert "what firmware fits (linear_delta/6)" in " ".join(text.split())


@pytest.mark.parametrize(("n", "model"), [(5, None), (6, "4"), (10, "3")])
def test_fewer_heights_than_firmware_has_parameters_are_fitted_by_a_smaller_model(
    n: int, model: str | None, printer: Robot, rng: np.random.Generator
) -> None:
    """What is asked for, or as much as they carry: no comparison with a larger model stands in the way."""
    heights = simulate(printer, recording(printer, grid(100, 60)[:n]), {"endstop_1": 0.4}, noise_mm=0.01, rng=rng)
    found = dc.identify(printer, heights, model=model)
    assert found["model"] == f"linear_delta/{model or 4}"
    assert "firmware" not in found


@pytest.mark.parametrize("n", [22, 24, 25])
def test_diagnose_begins_with_the_model_that_identify_takes(n: int, printer: Robot, rng: np.random.Generator) -> None:
    """One recording has one geometry, whichever command reads it."""
    poses = recording(printer, grid(100, 30)[:n])
    heights = simulate(printer, poses, {"endstop_1": 0.4}, noise_mm=0.01, rng=rng)
    assert len(heights.joints) == n
    diagnosed = dc.diagnose(printer, heights)
    assert diagnosed["baseline"]["model"] == dc.identify(printer, heights)["model"]


def test_six_parameters_of_firmware_are_enough_where_the_rest_is_known_from_before(
    printer: Robot, rng: np.random.Generator
) -> None:
    """What firmware cannot fit is held from the earlier session, whatever geometry the later robot file has."""
    names = LINEAR.model("linear_delta/21")
    truth = plausible(rng, names)
    truth |= {n: 4 * truth[n] for n in names if n.startswith(("lean", "radius_"))}
    six = LINEAR.model("linear_delta/6")
    later = truth | {n: truth.get(n, 0.0) + float(rng.normal(0, 0.2 if "angle" not in n else 1e-3)) for n in six}
    poses = recording(printer, grid(100, 20))
    sessions = [simulate(printer, poses, t, noise_mm=0.01, rng=rng) for t in (truth, later)]
    diagnosis = dc.diagnose(printer, sessions[0])
    longer = printer.geometry["arm_length"] + 0.3  # firmware saved other arms in between
    saved = dataclasses.replace(printer, geometry=printer.geometry | {"arm_length": longer})
    alone = dc.identify(printer, sessions[1], model="6")
    held = dc.identify(printer, sessions[1], model="6", physics=diagnosis)
    elsewhere = dc.identify(saved, sessions[1], model="6", physics=diagnosis)
    assert held["train_rms_mm"] < 0.013 < 2 * 0.013 < alone["train_rms_mm"]
    assert elsewhere["train_rms_mm"] == pytest.approx(held["train_rms_mm"], rel=1e-3)
    told = {p["name"]: p for p in elsewhere["parameters"]}
    kept = {p["name"]: p for p in held["parameters"]}
    assert told["arm_1"]["status"] == "fixed"
    assert told["arm_1"]["value"] == pytest.approx(kept["arm_1"]["value"] - 0.3)


# ------------------------------------------------------------------------------------------------------ flat but wrong


def test_flat_but_wrong_is_said_in_numbers_and_one_distance_settles_it(
    printer: Robot, rng: np.random.Generator
) -> None:
    heights = simulate(printer, recording(printer, grid(80, 40)), {}, noise_mm=0.02, rng=rng)
    found = identify(printer, heights).answer()
    first = found["next_measurements"][0]
    assert first["measurement"].startswith("print two marks")
    assert first["open_mm"] > 0.2
    ends = np.array([[-80.0, 0, 0], [80.0, 0, 0], [0, -80.0, 0], [0, 80.0, 0]])
    both = recording(printer, np.vstack([grid(80, 40), ends]), pairs=np.array([[13, 14], [15, 16]]))
    settled = identify(printer, simulate(printer, both, {}, noise_mm=0.02, rng=rng)).answer()
    for told in (first, *settled["next_measurements"]):
        assert "these readings leave it open" in told["measurement"]
        assert not re.search(r" 1[,)]", told["measurement"]), "of a factor no unit is told"
    left = [m["open_mm"] for m in settled["next_measurements"]]
    assert not left or left[0] < 0.7 * first["open_mm"]


def test_known_rods_leave_less_open(printer: Robot, rng: np.random.Generator) -> None:
    poses = recording(printer, grid(80, 40))
    heights = simulate(printer, poses, {}, noise_mm=0.02, rng=rng)
    callipers = {f"arm_{i}": 0.05 for i in (1, 2, 3)} | {f"radius_{i}": 0.05 for i in (1, 2, 3)}
    known = dataclasses.replace(printer, tolerance=callipers)
    open_mm = [identify(r, heights).answer()["next_measurements"][0]["open_mm"] for r in (printer, known)]
    assert open_mm[1] < open_mm[0]


def test_a_fit_of_few_heights_says_by_how_much_its_residual_flatters(rng: np.random.Generator) -> None:
    """The factor it states is the one that noise alone shows, by 400 fits of as many parameters to pure noise."""
    readings, parameters = 13, 9
    A, noise = rng.standard_normal((readings, parameters)), rng.standard_normal((readings, 400))
    left = noise - A @ np.linalg.lstsq(A, noise, rcond=None)[0]
    said = flattered(float(readings - parameters), readings, float(np.sqrt(np.mean(left**2))))
    assert "13 readings less 9 parameters leave 4 degrees of freedom" in said
    assert float(re.search(r"noise of ([\d.]+) mm", said)[1]) == pytest.approx(1.0, abs=0.05)  # type: ignore[index]
    assert "1.8 times" in said
    assert "says nothing of the noise" in flattered(0.4, 7, 0.01)
    assert flattered(90.0, 100, 0.01) == ""
