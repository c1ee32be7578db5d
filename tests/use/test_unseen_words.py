"""What readings do not tell apart, in a sentence of geometry."""

from __future__ import annotations

import dataclasses
import re

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.files.robot import Robot, robot_of
from deltacal_gen.machine.registry import Machine, mechanism_of
from deltacal_gen.pages import report
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.results.result import OpenCombination, Result
from deltacal_gen.units import to_internal
from deltacal_gen.use.unseen import explained, sentences
from tests.support.prototype import plausible, scattered, wanted

ALL = {"ex_1": 0.1, "ex_2": 0.1, "ex_3": 0.1}


@pytest.fixture(scope="module")
def found(robot: Robot, mechanism: Machine) -> Result:
    rng = np.random.default_rng(1)
    given = wanted(scattered(robot, 60, 4))
    recording = simulate(robot, given, plausible(mechanism, 3), noise_mm=0.005, rng=rng)
    return dc.identify(robot, recording)


def test_what_no_reading_sees_of_a_delta_is_a_motion_of_it_as_a_whole(found: Result) -> None:
    told = sentences(found)
    assert len(told) == len(found.unidentifiable) >= 6
    assert all(s.startswith("the machine as a whole ") and s.endswith("the instrument's frame takes it") for s in told)


@pytest.mark.parametrize(
    ("terms", "expected"),
    [
        (ALL, "shifted along x (0.1 mm)"),
        ({"ez_1": 0.2, "ez_2": 0.2, "ez_3": 0.2}, "shifted along z (0.2 mm)"),
    ],
)
def test_a_shift_of_all_limbs_is_named_with_its_size(found: Result, terms: dict[str, float], expected: str) -> None:
    one = OpenCombination(seen="not at all", text="", terms=terms)
    assert sentences(found.replace(unidentifiable=(one,))) == [
        f"the machine as a whole {expected}: the instrument's frame takes it"
    ]


def test_what_bends_the_machine_is_no_motion_of_it(found: Result) -> None:
    one = OpenCombination(seen="not at all", text="", terms={"theta_1": 1.0, "L_2": 0.3})
    assert sentences(found.replace(unidentifiable=(one,))) == [""]
    faint = OpenCombination(seen="less than noise", text="", terms=ALL)
    assert sentences(found.replace(unidentifiable=(faint,))) == [""]


def test_a_machine_without_a_workspace_keeps_the_numbers(found: Result) -> None:
    tables = found.robot.replace(workspace=None)
    assert sentences(found.replace(robot=tables)) == [""] * len(found.unidentifiable)


def test_the_page_folds_the_numbers_behind_the_sentence(found: Result) -> None:
    page = report.calibration(explained(found))  # on paper the sentence stays, and what is folded elsewhere is unfolded
    assert page.count('<details class="said"><summary>The machine as a whole ') == len(found.unidentifiable)


def test_what_probed_heights_leave_open_is_said_of_a_print() -> None:
    printer = dc.import_klipper(example("linear_delta") / "printer.cfg")
    found = dc.identify(printer.robot, printer.recordings["mesh_default"])
    told = sentences(found)
    assert sum(map(bool, told)) >= len(told) - 1
    c, sentence = next((c, s) for c, s in zip(found.unidentifiable, told, strict=True) if "0.23% longer" in s)
    [(longer, turn, across)] = re.findall(r"out ([\d.]+)% longer at (\d+) deg from x and ([\d.]+)% longer", sentence)
    robot = robot_of(found.robot)
    mechanism = mechanism_of(robot)
    along = np.radians(float(turn)) + np.array([0.0, np.pi / 2])
    ends = 60.0 * np.array([[np.cos(a), np.sin(a), 0.0] for a in (*along, *(along + np.pi))])  # a cross on the bed
    q, _, _ = mechanism.inverse(ends, robot.tool, mechanism.rows(robot))
    units = {p.name: to_internal(p.unit) for p in mechanism.parameters}
    errors = robot.errors | {n: robot.errors.get(n, 0.0) + v * units[n] for n, v in c.terms.items()}
    x, _ = mechanism.forward(q, robot.tool, mechanism.rows(dataclasses.replace(robot, errors=errors)))
    grown = 100 * (np.linalg.norm(x[:2, :3] - x[2:, :3], axis=1) / 120.0 - 1)
    assert grown == pytest.approx([float(longer), float(across)], abs=0.015)
    assert np.ptp(x[:, 2]) < 0.01
