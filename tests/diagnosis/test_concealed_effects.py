"""Effects concealed in recordings of machines of every sort: each is named, at its limb, in its size."""

from __future__ import annotations

import copy
import json

import pytest

import deltacal_gen as dc
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.files.robot import Robot, robot_from_dict
from deltacal_gen.identification import carried
from deltacal_gen.physics import terms as of
from tests.support.concealed import Case, record
from tests.support.every_effect import ARM, LIFT, PRINTER, chain
from tests.support.left_out import machine, named

pytestmark = pytest.mark.usefixtures("compiled")

SPRINGS = ("joint_compliance", "saturating_compliance")  # the simple one, and what becomes of it
BETWEEN = 40.0  # s: of two readings, at most


def printer() -> Robot:
    return robot_from_dict(copy.deepcopy(PRINTER) | {"masses": {"carriage": 0.3, "distal_rod": 0.05, "platform": 0.4}})


MACHINES = {"delta": machine, "printer": printer, "arm": lambda: chain(ARM), "lift": lambda: chain(LIFT)}


OFFSET = {"offset_x": 0.1, "offset_y": -0.15, "offset_z": 0.2}
CASES = (
    Case("printer", "thermal_growth", (), {"expansion_distal": 2.4e-5, "expansion_base": 1.2e-5}),
    Case("arm", "thermal_growth", (), {"expansion_proximal": 2.4e-5}),
    Case("lift", "thermal_growth", (), {"expansion_proximal": 2.4e-5}),
    Case("delta", "tool_slip", (), OFFSET, {"when": 1800.0}, alike=("instrument_slip",)),
    Case("arm", "tool_slip", (), OFFSET, {"when": 1800.0}),
    Case("delta", "instrument_slip", (), OFFSET, {"when": 1800.0}, alike=("tool_slip",)),
    Case("printer", "instrument_slip", (), OFFSET, {"when": 1800.0}, alike=("tool_slip",)),
    Case("arm", "instrument_slip", (), OFFSET, {"when": 1800.0}),
    Case("delta", "joint_coupling", (3,), {"coupling": 1.5e-3}, {"of": 1}),
    Case("arm", "joint_coupling", (3,), {"coupling": 2e-3}, {"of": 2}),
    Case("lift", "joint_coupling", (2,), {"coupling": 2e-3}, {"of": 1}),  # deg per mm
    Case("delta", "saturating_compliance", (2,), {"compliance": 0.02}, {"limit": 4.0}),
    Case("arm", "saturating_compliance", (2,), {"compliance": 0.002}, {"limit": 60.0}),
    Case("delta", "warm_up", (1,), {"size": 0.06}, {"per": "time_s", "time_constant": 900.0}),
    Case("printer", "warm_up", (3,), {"size": 0.3}, {"per": "time_s", "time_constant": 900.0}),
    Case("lift", "warm_up", (1,), {"size": 0.4}, {"per": "time_s", "time_constant": 900.0}),
    Case("arm", "warm_up", (5,), {"size": 0.2}, {"per": "time_s", "time_constant": 900.0}),
    Case("arm", "link_bending", (2,), {"compliance": 2e-3}),
    Case("arm", "link_torsion", (3,), {"compliance": 5e-3}, alike=("joint_tilt_compliance",)),  # of the next joint
    Case("arm", "joint_tilt_compliance", (4,), {"compliance_x": 4e-3, "compliance_y": 5e-3}),
    Case("lift", "link_bending", (2,), {"compliance": 3e-3}),
    Case("lift", "link_torsion", (3,), {"compliance": 5e-3}, alike=("joint_tilt_compliance",)),
    Case("lift", "joint_tilt_compliance", (2,), {"compliance_x": 2e-3, "compliance_y": 3e-3}),
    Case("lift", "column_lean", (1,), {"compliance": 3e-6}),
    Case("arm", "part_tilt", (1,), {"tilt_x": 0.01, "tilt_y": -0.008}, {"of": "level_mrad"}),
    Case("delta", "part_tilt", (2,), {"tilt_x": 0.03, "tilt_y": -0.02}, {"of": "level_mrad"}),
    Case("printer", "part_tilt", (2,), {"tilt_x": 0.03, "tilt_y": -0.02}, {"of": "level_mrad"}),
)


FIRST = {c.effect: c for c in reversed(CASES)}  # where an effect is looked for first; elsewhere it takes minutes more


@pytest.mark.walk
@pytest.mark.parametrize(
    "case",
    [
        pytest.param(c, marks=() if c is FIRST[c.effect] else pytest.mark.thorough, id=f"{c.effect}-{c.machine}")
        for c in CASES
    ],
)
def test_an_effect_is_named_at_its_limbs_in_its_size(case: Case) -> None:
    robot = MACHINES[case.machine]()
    found = dc.diagnose(robot, record(robot, case.term(robot)))
    assert found["verdict"] == "missing_physics", found["summary"]
    (effect,) = found["effects"]
    if effect["name"] in case.alike:  # likelier by chance
        assert case.effect in effect["indistinguishable_from"]
        return
    assert named(found) == [(case.effect, list(case.limbs))]
    assert set(effect["indistinguishable_from"]) <= set(case.alike)
    for p in effect["parameters"]:
        true = {**case.values, **case.constants}[p["name"]]
        if p["name"] == "when":
            assert abs(p["value"] - true) < BETWEEN
        elif p["std"] is None:
            assert p["value"] == true
        else:
            assert abs(p["value"] - true) < 4 * p["std"], p
            assert p["std"] < 0.5 * abs(true), p


@pytest.mark.parametrize("machine_name", MACHINES)
def test_where_nothing_is_concealed_nothing_is_named(machine_name: str) -> None:
    robot = MACHINES[machine_name]()
    found = dc.diagnose(robot, record(robot, None, seed=2))
    assert (found["verdict"], found["effects"]) == ("adequate", []), found["summary"]


def test_what_was_once_is_long_ago_in_numbers_that_a_file_can_hold() -> None:
    jump = of.blank("instrument_slip", (), (1800.0,)).afterwards()
    assert json.loads(json.dumps(jump.constants, allow_nan=False)) == list(jump.constants)
    arm = chain(ARM)
    problem = pose_problem(arm, record(arm, None), ())
    can, cannot = carried.usable(problem, [jump, of.blank("tool_slip", (), (1800.0,)).afterwards()])
    assert [t.effect for t in can] == ["tool_slip"]
    assert [(m.name, m.missing) for m in cannot] == [("instrument_slip", "that session: it happened once, and is past")]
