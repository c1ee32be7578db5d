"""What a configuration of Klipper says, as Klipper reads it: what holds, what it includes, what owners do to it."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

from deltacal_gen import InputError, import_klipper, import_marlin, import_rrf
from deltacal_gen.files.robot import Robot, robot_from_dict
from deltacal_gen.machine.registry import load_mechanism
from deltacal_gen.use.exporters import exporter_of
from tests.support.printers import PRINTER, Z_OFFSET, joints, printer_cfg, session

pytestmark = pytest.mark.usefixtures("compiled")

MESH = (
    "[bed_mesh default]\nversion = 1\npoints =\n\t 0.1, 0.0, 0.1\n\t 0.0, 0.0, 0.0\n\t 0.1, 0.0, 0.1\n"
    "min_x = -50.0\nmax_x = 50.0\nmin_y = -50.0\nmax_y = 50.0"
)
MAP = "height map\nxmin,xspacing,ymin,yspacing\n0,1,0,1\n0.0\n"


@pytest.fixture(scope="module")
def robot() -> Robot:
    return robot_from_dict(PRINTER | {"transmission": {"pulley_circumference": 40.0}})


@pytest.fixture
def text(robot: Robot) -> str:
    return printer_cfg(robot, *session(robot), MESH)


@pytest.fixture
def file(tmp_path: Path) -> Path:
    return tmp_path / "printer.cfg"


def test_what_stands_above_the_saved_block_holds(robot: Robot, text: str, file: Path) -> None:
    """As in Klipper, which comments out what it saves: lines that were written are what a later import begins with."""
    errors = {"radius": 0.4, "endstop_2": -0.3, "angle_1": 0.002}
    written = exporter_of("klipper").describe(dataclasses.replace(robot, errors=errors))
    assert written.after.worst_mm == 0.0  # not 1e-13
    lines = written.text
    body, block = text.split("#*# <", 1)
    file.write_text(f"{body}{lines}\n#*# <{block}")
    read = import_klipper(file)
    assert read.robot is not None
    assert read.robot.geometry["radius"][0] == pytest.approx(robot.geometry["radius"][0] + 0.4, abs=1e-6)
    assert read.robot.geometry["endstop"][1] == pytest.approx(robot.geometry["endstop"][1] - 0.3, abs=1e-6)
    assert not any("follow the SAVE_CONFIG block" in w for w in read.warnings)
    assert "above the SAVE_CONFIG block" in lines
    assert "meshes of the bed that were probed before do not hold" in lines


def test_lines_below_the_saved_block_are_told(text: str, file: Path) -> None:
    """Klipper drops the block for them, heights and all."""
    file.write_text(f"{text}\n\n[printer]\ndelta_radius: 130.5\n")
    read = import_klipper(file)
    assert any("lines follow the SAVE_CONFIG block" in w for w in read.warnings)
    assert read.robot is not None
    assert read.robot.geometry["radius"][0] == 130.5


def test_included_files_are_read_in_their_places(text: str, file: Path) -> None:
    plain = import_klipper(_with(file, text))
    (file.parent / "parts").mkdir()
    (file.parent / "parts" / "motors.cfg").write_text(
        "".join(f"[stepper_{t}]\nrotation_distance: 40\nmicrosteps: 16\n" for t in "abc") + "[include ../probe.cfg]\n"
    )
    (file.parent / "probe.cfg").write_text("[probe]\nx_offset: 2.0\n\n[include printer.cfg]\n")  # round in a ring
    moved = text.replace("rotation_distance: 40\nmicrosteps: 16\n", "").replace("x_offset: 2.0\n", "")
    read = import_klipper(_with(file, f"[include parts/*.cfg]\n[include none/*.cfg]\n{moved}"))
    assert not read.warnings
    for name in ("recording", "mesh_default"):
        assert read.recordings[name].joints == pytest.approx(plain.recordings[name].joints, abs=1e-9), name


def _with(file: Path, text: str) -> Path:
    file.write_text(text)
    return file


def test_files_that_are_not_there_are_asked_for_where_they_matter(text: str, file: Path) -> None:
    includes = "[include mainsail.cfg]\n[include probe.cfg]\n"
    assert not import_klipper(_with(file, includes + text)).warnings
    unplaced = import_klipper(_with(file, includes + text.replace("x_offset: 2.0", ""))).warnings
    assert any("includes mainsail.cfg, probe.cfg, which are not beside it" in w for w in unplaced)
    without = "\n".join(line for line in text.splitlines() if "delta_radius" not in line)
    with pytest.raises(InputError, match=r"delta_radius .* beside it what it includes \(mainsail.cfg, probe.cfg\)"):
        import_klipper(_with(file, includes + without))
    with pytest.raises(InputError, match=r"no \[printer\] in the file"):
        import_klipper(_with(file, "[gcode_macro M600]\ngcode:\n  PAUSE\n"))


def test_what_was_written_beside_a_saved_number_is_a_comment(text: str, file: Path) -> None:
    commented = text.replace("delta_radius = 130.000000", "delta_radius = 130.000000  # 131 before")
    assert commented != text
    read = import_klipper(_with(file, commented.replace("\n", "\r\n")))
    assert read.robot is not None
    assert read.robot.geometry["radius"][0] == 130.0


@pytest.mark.parametrize("name", ["bltouch", "smart_effector", "probe_eddy_current btt"])
def test_a_probe_of_another_name_stands_where_it_says(name: str, text: str, file: Path) -> None:
    plain = import_klipper(_with(file, text)).recordings["mesh_default"]
    other = import_klipper(_with(file, text.replace("[probe]", f"[{name}]"))).recordings["mesh_default"]
    assert other.joints == pytest.approx(plain.joints, abs=1e-9)
    assert (other.measured == Z_OFFSET).all()


def test_endstops_that_were_moved_a_little_for_the_first_layer_are_told(robot: Robot, file: Path) -> None:
    """By less than a millimetre, too: a calibration by these heights would put the nozzle into the bed by as much."""
    heights, _ = session(robot)
    rng = np.random.default_rng(3)
    probed = heights + 0.01 * rng.standard_normal((len(heights), 1))

    def warned(shift: float, spoilt: np.ndarray) -> bool:
        moved = dataclasses.replace(robot, geometry=robot.geometry | {"endstop": robot.geometry["endstop"] + shift})
        return any(
            "undoes that change" in w for w in import_klipper(_with(file, printer_cfg(moved, spoilt, []))).warnings
        )

    assert warned(-0.18, probed)
    assert not warned(0.0, probed)
    bent = joints(
        robot, load_mechanism("linear_delta").forward(heights, robot.tool, _rows(robot))[0][:, :3], {"radius": 1.0}
    )
    assert not warned(0.1, bent)  # never calibrated: nothing is alike


def _rows(robot: Robot) -> np.ndarray:
    return load_mechanism("linear_delta").rows(robot)


@pytest.mark.parametrize("number", ["nan", "inf", "1_5"])
@pytest.mark.parametrize("key", ["height0", "height0_pos", "position_endstop"])
def test_what_is_no_number_is_refused(key: str, number: str, text: str, file: Path) -> None:
    spoilt = "\n".join(
        f"#*# {key} = {number}{',1,2' if key.endswith('pos') else ''}" if line.startswith(f"#*# {key} =") else line
        for line in text.splitlines()
    )
    with pytest.raises(InputError, match=key):
        import_klipper(_with(file, spoilt))


@pytest.mark.parametrize("line", ["microsteps: 0", "microsteps: 16\nfull_steps_per_rotation: 0", "gear_ratio: 2:0"])
def test_a_step_of_no_length_is_refused(line: str, text: str, file: Path) -> None:
    key = line.split(":")[0]
    spoilt = text.replace("microsteps: 16", line if key == "microsteps" else f"microsteps: 16\n{line}")
    with pytest.raises(InputError, match="is 0 or less"):
        import_klipper(_with(file, spoilt))


def test_reprapfirmware_s_saved_numbers_hold_where_the_configuration_loads_them(tmp_path: Path) -> None:
    config, chart = tmp_path / "config.g", tmp_path / "heightmap.csv"
    chart.write_text(MAP)
    config.write_text("M665 R130 L270 B90 H302 X0.1\nM666 X0.3\nG31 P500 Z2.5\nM501 ; saved\n")
    alone = import_rrf(config, chart)
    assert any("config-override.g is not beside it" in w for w in alone.warnings)
    (tmp_path / "config-override.g").write_text("M665 L270:270:270 R130.5 H300 B90 X0 Y0 Z0\nM666 X0 Y0 Z0\nM501\n")
    read = import_rrf(config, chart)
    assert not read.warnings
    assert read.robot is not None
    assert read.robot.geometry["radius"][0] == 130.5
    assert read.robot.geometry["endstop"] == pytest.approx([300.0] * 3)
    config.write_text(config.read_text().replace("M501", ";M501"))
    without = import_rrf(config, chart).robot
    assert without is not None
    assert without.geometry["radius"][0] == 130.0


def test_a_marlin_too_old_to_say_its_height_is_told_of_by_hand(tmp_path: Path) -> None:
    log = tmp_path / "marlin.txt"
    log.write_text("Recv: echo:  M665 L271.50 R135.40 S80.00 A0.00 B0.00 C0.00\nBed X: 0.0 Y: 0.0 Z: 0.1\n")
    with pytest.raises(InputError, match="add a line, M665 H and the number"):
        import_marlin(log)
    log.write_text(f"{log.read_text()}M665 H300\n")
    assert import_marlin(log).robot is not None
