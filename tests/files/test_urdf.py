"""A robot file made of a URDF puts every part where the URDF does, and what cannot be one is told with its line."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

import deltacal_gen as dc
from deltacal_gen.app.demonstration import example
from deltacal_gen.errors import InputError, UsageError
from deltacal_gen.files.robot import read_robot
from deltacal_gen.machine.denavit import Row
from deltacal_gen.machine.dynamics import dynamics_of
from deltacal_gen.machine.registry import Array, mechanism_of
from deltacal_gen.machine.values import Robot
from tests.support.commands import Run

SLIDES = "prismatic"
WAYS = ("anyhow", "parallel", "against", "meeting", "on one line", "nearly", "written roughly")


@dataclass
class Drawn:
    """A joint as a test draws it [m, rad]: where it is in its parent, what it does, what its child weighs [kg]."""

    kind: str
    xyz: Array
    rpy: Array
    axis: Array
    mass: float = 0.0
    centre: Sequence[float] = (0.0, 0.0, 0.0)
    turned: Sequence[float] = (0.0, 0.0, 0.0)
    tensor: Sequence[float] = (0.0,) * 6
    more: str = '<limit lower="-1.5" upper="2.5" velocity="2" effort="9"/>'


def words(values: Any) -> str:
    return " ".join(repr(float(v)) for v in np.ravel(values))


def urdf(joints: Sequence[Drawn], more: str = "") -> str:
    """Return a file of links l0, l1, ... in a row."""
    out = ["<robot name='drawn'>", "<link name='l0'/>"]
    for k, j in enumerate(joints, start=1):
        inertia = " ".join(
            f"{key}='{v!r}'" for key, v in zip(("ixx", "iyy", "izz", "ixy", "ixz", "iyz"), j.tensor, strict=True)
        )
        weighs = (
            f"<inertial><origin xyz='{words(j.centre)}' rpy='{words(j.turned)}'/><mass value='{j.mass!r}'/>"
            f"<inertia {inertia}/></inertial>"
        )
        out += [
            f"<link name='l{k}'>{weighs if j.mass else ''}</link>",
            f"<joint name='j{k}' type='{j.kind}'><parent link='l{k - 1}'/><child link='l{k}'/>",
            f"<origin xyz='{words(j.xyz)}' rpy='{words(j.rpy)}'/><axis xyz='{words(j.axis)}'/>{j.more}</joint>",
        ]
    return "\n".join([*out, more, "</robot>"])


def placed(joints: Sequence[Drawn], q: Sequence[float]) -> tuple[list[Array], list[Array]]:
    """Return where the links are [m], and how they are turned, by SciPy's rotations; `q` of joints that move."""
    at, R, values = np.zeros(3), Rotation.identity(), iter(q)
    points, turns = [], []
    for j in joints:
        at, R = at + R.apply(j.xyz), R * Rotation.from_euler("xyz", j.rpy)
        axis = np.array(j.axis) / np.linalg.norm(j.axis)
        if j.kind == SLIDES:
            at = at + R.apply(next(values) * axis)
        elif j.kind != "fixed":
            R = R * Rotation.from_rotvec(next(values) * axis)
        points.append(at)
        turns.append(R.as_matrix())
    return points, turns


def imported(folder: Path, text: str, **links: str) -> Robot:
    file = folder / "arm.urdf"
    file.write_text(text)
    dc.import_urdf(file, folder / "out", **links)
    return read_robot(folder / "out" / "robot.toml")


def moving(joints: Sequence[Drawn]) -> list[Drawn]:
    return [j for j in joints if j.kind != "fixed"]


def drawn(rng: np.random.Generator, ways: Sequence[str], kinds: Sequence[str], fixed: bool) -> list[Drawn]:
    """Return a chain whose axes stand to the one before as `ways` say."""
    out = []
    for way, kind in zip(ways, kinds, strict=True):
        if fixed and rng.uniform() < 0.5:
            out.append(Drawn("fixed", rng.uniform(-0.3, 0.3, 3), rng.uniform(-3, 3, 3), np.array([1.0, 0, 0])))
        before = next((j.axis / np.linalg.norm(j.axis) for j in out[::-1]), np.array([0.0, 0.0, 1.0]))
        xyz, rpy, axis = rng.uniform(-0.5, 0.5, 3), np.zeros(3), before
        match way:
            case "anyhow":
                rpy, axis = rng.uniform(-3, 3, 3), rng.uniform(-2, 2, 3)
            case "against":
                axis = -before
            case "meeting":
                xyz, axis = rng.uniform(-0.5, 0.5) * before, rng.uniform(-2, 2, 3)
            case "on one line":
                xyz = rng.uniform(-0.5, 0.5) * before
            case "nearly":
                axis = Rotation.from_rotvec(10.0 ** rng.uniform(-12, -2, 3)).apply(before)
            case "written roughly":
                rpy, axis = np.array([1.5708, 0.0, -1.5708]), np.array([0.0, 0.0, 1.0])
        out.append(Drawn(kind, xyz, rpy, axis))
    if fixed or rng.uniform() < 0.5:
        out.append(Drawn("fixed", rng.uniform(-0.3, 0.3, 3), rng.uniform(-3, 3, 3), np.array([1.0, 0, 0])))
    return out


@pytest.mark.walk
@given(
    seed=st.integers(0, 2**32),
    ways=st.lists(st.tuples(st.sampled_from(WAYS), st.sampled_from(["revolute", "continuous", SLIDES])), max_size=8),
    fixed=st.booleans(),
)
@settings(
    max_examples=120, deadline=None, derandomize=True, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
def test_every_chain_comes_back(tmp_path: Path, seed: int, ways: list[tuple[str, str]], fixed: bool) -> None:
    rng = np.random.default_rng(seed)
    joints = drawn(rng, ["anyhow", *(way for way, _ in ways)], ["revolute", *(kind for _, kind in ways)], fixed)
    robot = imported(tmp_path, urdf(joints))
    read = moving(joints)
    q = rng.uniform(-3, 3, (20, len(read)))
    factor = np.array([1000.0 if j.kind == SLIDES else 1.0 for j in read]) * robot.joint_sign
    machine = mechanism_of(robot)
    x, _ = machine.forward(q * factor, robot.tool, machine.rows(robot))
    there = [placed(joints, row) for row in q]
    np.testing.assert_allclose(x[:, :3], [1000 * points[-1] for points, _ in there], rtol=0, atol=1e-9)
    np.testing.assert_allclose(x[:, 3:].reshape(-1, 3, 3), [turns[-1] for _, turns in there], rtol=0, atol=1e-12)


def weighing(rng: np.random.Generator, joints: list[Drawn]) -> list[Drawn]:
    """Give all links bodies that could be built: points of mass, in axes of their own."""
    for j in joints:
        points, masses = 0.1 * rng.standard_normal((6, 3)), rng.uniform(0.2, 2.0, 6)
        j.mass, j.centre, j.turned = float(masses.sum()), rng.uniform(-0.2, 0.2, 3), rng.uniform(-1.5, 1.5, 3)
        points -= masses @ points / j.mass
        x, y, z = points.T
        each = (y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z)
        j.tensor = [float(masses @ v) for v in each]
    return joints


def test_weights_ask_of_the_joints_what_an_engine_made_by_others_says(tmp_path: Path) -> None:
    mujoco = pytest.importorskip("mujoco")
    rng = np.random.default_rng(3)
    ways = ["anyhow", "parallel", "against", "anyhow", "nearly", "meeting", "anyhow"]
    joints = weighing(rng, drawn(rng, ways, ["revolute", SLIDES, *["revolute"] * 5], True))
    text = urdf(joints)
    robot = imported(tmp_path, text)
    motion = rng.uniform(-1, 1, (3, 12, 7))
    slides = np.array([j.kind == SLIDES for j in moving(joints)])
    dynamics = dynamics_of(robot)
    factor = np.where(slides, 1000.0, 1.0) * robot.joint_sign
    found = dynamics.torque(motion * factor, np.nan_to_num(dynamics.stated()))
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    for k in range(12):
        data.qpos[:], data.qvel[:], data.qacc[:] = motion[:, k]
        mujoco.mj_inverse(model, data)
        wanted = data.qfrc_inverse - data.qfrc_passive - data.qfrc_constraint
        of_file = found[k] * robot.joint_sign / np.where(slides, 1.0, 1000.0)
        np.testing.assert_allclose(of_file, wanted, rtol=1e-6, atol=1e-6)


def test_the_example_has_the_table_of_its_robot_file(tmp_path: Path) -> None:
    robot, table = (
        imported(tmp_path, (example("serial") / "arm.urdf").read_text()),
        read_robot(example("serial") / "robot.toml"),
    )
    for key, values in table.geometry.items():
        np.testing.assert_allclose(robot.geometry[key], values, atol=1e-12, err_msg=key)
    assert robot.joint_limits == pytest.approx(table.joint_limits)
    assert [(link.mass, link.com) for link in robot.links] == [(link.mass, link.com) for link in table.links]
    assert robot.limits["qd6_deg_s"] == (-400.0, 400.0)
    assert "[[joint]]  # q2: joint_2" in (tmp_path / "out" / "robot.toml").read_text()


def test_an_arm_that_was_calibrated_has_parallel_axes_and_errors(tmp_path: Path) -> None:
    """Axes a minute off parallel have a common normal hundreds of metres away; Hayati's angle has not."""
    tilt = [3e-4, -2e-4, 0.0]
    z = np.array([0.0, 0.0, 1.0])
    joints = [
        Drawn("revolute", np.array([0.0, 0.0, 0.16]), np.zeros(3), z),
        Drawn("revolute", np.zeros(3), np.array([np.pi / 2, 0.0, 0.0]), z),
        Drawn("revolute", np.array([-0.425, 0.0, 0.0]), np.array(tilt), z),
        Drawn("fixed", np.array([-0.39, 0.0, 0.13]), np.zeros(3), z),
    ]
    robot = imported(tmp_path, urdf(joints))
    assert np.abs(robot.geometry["d"]).max() < 200
    assert robot.geometry["alpha"][1] == 0.0
    assert robot.errors == pytest.approx({"alpha_2": 3e-4, "beta_2": -2e-4, **late(robot)}, rel=1e-6)
    assert "beta_2" in mechanism_of(robot).model("dh")


def late(robot: Robot) -> dict[str, float]:
    """Return the errors of tables behind the second."""
    return {name: value for name, value in robot.errors.items() if not name.endswith("_2")}


# ------------------------------------------------------------------------------------------------- which chain, what


def arm(n: int = 2, **of_last: str) -> list[Drawn]:
    """Return a chain of n joints about axes that cross, a decimetre apart."""
    axes = np.array([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
    out = [Drawn("revolute", np.array([0.1, 0.0, 0.2]), np.zeros(3), axes[k % 2]) for k in range(n)]
    for key, value in of_last.items():
        setattr(out[-1], key, value)
    return out


def fixed(name: str, parent: str, at: str = "0 0 0") -> str:
    return (
        f"<link name='{name}'/><joint name='to_{name}' type='fixed'><parent link='{parent}'/><child link='{name}'/>"
        f"<origin xyz='{at}'/></joint>"
    )


HAND = "".join(
    f"<link name='{side}'><inertial><mass value='0.5'/></inertial></link><joint name='to_{side}' type='prismatic'>"
    f"<parent link='l2'/><child link='{side}'/><limit lower='0' upper='0.04'/></joint>"
    for side in ("left", "right")
)
SENSOR = (
    "<link name='sensor'><inertial><origin xyz='0 0 0.1'/><mass value='3'/></inertial></link><joint name='bolted' "
    "type='fixed'><parent link='l2'/><child link='sensor'/></joint>"
)


def test_a_gripper_ends_no_arm_and_its_fingers_are_left_out(tmp_path: Path) -> None:
    text = urdf(arm(), HAND)
    with pytest.raises(InputError, match=r"left, right\. The ways to them part at 'l2', behind 2 joints\. .* --tip"):
        imported(tmp_path, text)
    assert not (tmp_path / "out").exists()
    found = dc.import_urdf(tmp_path / "arm.urdf", tip="l2")
    assert len(found.robot.joint_sign) == 2
    assert "joints to_left, to_right" in found.warnings[0]
    assert found.robot.masses is None


def test_of_two_arms_in_a_file_one_is_asked_for(tmp_path: Path) -> None:
    text = urdf(arm())
    other = text.replace("'l", "'r").replace("'j", "'k").split("\n", 1)[1]
    both = text.replace("</robot>", other)
    with pytest.raises(InputError, match=r"l2, r2\. They hang on links that no joint connects: l0, r0\. .* --base"):
        imported(tmp_path, both)
    assert len(dc.import_urdf(tmp_path / "arm.urdf", base="r0").robot.joint_sign) == 2


def test_what_is_fixed_weighs_with_the_link(tmp_path: Path) -> None:
    joints = arm()
    joints[-1].mass, joints[-1].tensor = 1.0, (1.0, 1.0, 1.0, 0.0, 0.0, 0.0)
    link = imported(tmp_path, urdf(joints, SENSOR), tip="l2").links[-1]
    assert link.mass == 4.0
    assert np.linalg.norm(link.com) == pytest.approx(75.0)
    assert sorted(link.inertia[:3]) == pytest.approx([1e6, 1e6 + 0.75 * 100**2, 1e6 + 0.75 * 100**2])


def test_a_base_may_hang_beside_the_arm(tmp_path: Path) -> None:
    text = urdf(arm(), fixed("base", "l0", "1 2 3"))
    plain, beside = imported(tmp_path, text, tip="l2"), imported(tmp_path, text, base="base", tip="l2")
    x, y = (mechanism_of(r).forward(np.zeros((1, 2)), r.tool, mechanism_of(r).rows(r))[0] for r in (plain, beside))
    assert (x - y)[0, :3] == pytest.approx([1000, 2000, 3000])
    with pytest.raises(UsageError, match="'l2' does not carry 'l0'"):
        imported(tmp_path, text, base="l2", tip="l0")
    with pytest.raises(UsageError, match="no joint moves between 'l0' and 'base'"):
        imported(tmp_path, text, tip="base")


def beside(joints: Sequence[Drawn], at: str) -> str:
    """Return another chain of links r0, r1, ..., r0 fixed to l0."""
    links = urdf(joints).replace("'l", "'r").replace("'j", "'k").split("\n", 2)[2]
    return links.replace("</robot>", fixed("r0", "l0", at))


@pytest.mark.parametrize("seed", range(8))
def test_a_chain_may_go_up_before_it_goes_down(tmp_path: Path, seed: int) -> None:
    rng = np.random.default_rng(seed)
    leg = weighing(rng, drawn(rng, ["anyhow", "parallel", "anyhow"], ["revolute", SLIDES, "revolute"], seed % 2 == 1))
    hand = drawn(rng, ["anyhow", "meeting"], ["revolute", "continuous"], True)
    text = urdf(leg, beside(hand, "0.1 0.2 0.3"))
    robot = imported(tmp_path, text, base=f"l{len(leg)}", tip=f"r{len(hand)}")
    q, hung = rng.uniform(-1, 1, (5, 5)), np.array([0.1, 0.2, 0.3])
    machine = mechanism_of(robot)
    slides = np.array([1.0, 1000.0, 1.0, 1.0, 1.0])
    x, _ = machine.forward(q * slides * robot.joint_sign, robot.tool, machine.rows(robot))
    for row, found in zip(q, x, strict=True):
        (foot, turn), (tip, tilt) = ((p[-1], R[-1]) for p, R in (placed(leg, row[2::-1]), placed(hand, row[3:])))
        np.testing.assert_allclose(found[:3], 1000 * turn.T @ (tip + hung - foot), rtol=0, atol=1e-9)
        np.testing.assert_allclose(found[3:].reshape(3, 3), turn.T @ tilt, rtol=0, atol=1e-12)
    with pytest.raises(UsageError, match="does not carry 'l0'"):
        dc.import_urdf(tmp_path / "arm.urdf", base=f"l{len(leg)}", tip="l0")
    told = dc.import_urdf(tmp_path / "arm.urdf", base=f"l{len(leg)}", tip=f"r{len(hand)}").warnings[0]
    assert "the chain first goes up through what carries it, j" in told


def test_what_is_passed_upwards_carries_what_it_hung_on(tmp_path: Path) -> None:
    rng = np.random.default_rng(3)
    leg, hand = (weighing(rng, arm(n)) for n in (3, 2))
    robot = imported(tmp_path, urdf(leg, beside(hand, "0 0 0")), base="l3", tip="r2")
    bodies = [link.mass for link in robot.links if link.kind != "fixed"]
    assert bodies == pytest.approx([leg[1].mass, leg[0].mass, 0.0, hand[0].mass, hand[1].mass])


def test_a_joint_that_follows_another_is_coupled(tmp_path: Path) -> None:
    joints = arm(4)
    joints[2].more = "<mimic joint='j1' multiplier='-0.5' offset='0.2'/>"
    robot = imported(tmp_path, urdf(joints))
    assert [link.kind for link in robot.links].count("coupled") == 1
    q, machine = np.array([[0.7, -0.3, 1.1]]), mechanism_of(robot)
    x, _ = machine.forward(q * robot.joint_sign, robot.tool, machine.rows(robot))
    points, _ = placed(joints, [0.7, -0.3, -0.5 * 0.7 + 0.2, 1.1])
    np.testing.assert_allclose(x[0, :3], 1000 * points[-1], atol=1e-9)


def test_joints_without_limits_are_told(tmp_path: Path) -> None:
    file = tmp_path / "arm.urdf"
    file.write_text(urdf(arm(2, kind="continuous")))
    found = dc.import_urdf(file)
    assert "joints without limits: j2" in found.warnings[0]
    assert np.degrees(found.robot.joint_limits[1]) == pytest.approx([-360, 360])
    file.write_text(urdf(arm(2, more='<limit lower="-1e16" upper="1e16" velocity="1e10"/>')))
    assert np.degrees(dc.import_urdf(file).robot.joint_limits[1]) == pytest.approx([-360, 360])
    assert dc.import_urdf(file).robot.limits.keys() == {"qd1_deg_s"}
    file.write_text(urdf(arm(2, more='<limit lower="-120" upper="120"/>')))
    assert "10 turns to a side: j2. URDF has radians" in dc.import_urdf(file).warnings[0]
    file.write_text(urdf(arm(2, more='<limit lower="-7" upper="7"/>')))
    assert not dc.import_urdf(file).warnings
    file.write_text(urdf(arm(2, kind=SLIDES, more="")))
    found = dc.import_urdf(file)
    assert "none at all" in found.warnings[0]
    assert found.robot.joint_limits is None


def test_names_are_written_as_comments_can_hold_them(tmp_path: Path) -> None:
    text = urdf(arm()).replace("'j2'", "'j&#10;kind = 1'")
    assert "# q2: j?kind = 1\n" in (imported(tmp_path, text), (tmp_path / "out" / "robot.toml").read_text())[1]


# -------------------------------------------------------------------------------------------------- files of strangers

GOOD = urdf(arm())
WRONG = {
    "cut": (GOOD[:-30], r"line \d+: this is not XML"),
    "empty": ("", "line 1: this is not XML: no element found"),
    "entities": (f'<!DOCTYPE r [<!ENTITY a "b">]>{GOOD}', "line 1: the file has a document type"),
    "xacro": (GOOD.replace("<link name='l0'/>", "<xacro:arm/><link name='l0'/>"), r"line 2: <xacro:arm> .* Run `xacro"),
    "unexpanded": (GOOD.replace("0.2'", "${h}'", 1), r"line 5: xyz=.* 3 numbers .* run `xacro"),
    "sdf": ("<sdf><model/></sdf>", "this is SDF, of Gazebo"),
    "no joints": ("<robot name='a'><link name='l'/></robot>", "no joint in the file"),
    "still": (urdf(arm(2, kind="fixed")[1:]), "no joint moves"),
    "unknown parent": (
        GOOD.replace("parent link='l1'", "parent link='l9'"),
        "line 7: the parent of joint 'j2' is 'l9'",
    ),
    "two parents": (
        GOOD.replace("</robot>", fixed("l3", "l0").replace("child link='l3'", "child link='l2'") + "</robot>"),
        "'l2' hangs on two joints, 'j2' and 'to_l3'",
    ),
    "circle": (GOOD.replace("parent link='l0'", "parent link='l2'"), "line 4: joints lead in a circle.*'j1', 'j2'"),
    "twins": (GOOD.replace("'j2'", "'j1'"), "line 7: there are two joints 'j1'"),
    "same links": (GOOD.replace("link name='l2'", "link name='l1'"), "line 6: there are two links 'l1'"),
    "nan": (GOOD.replace("0.2'", "nan'", 1), 'line 5: xyz="0.1 0.0 nan" in <origin>: 3 numbers'),
    "no number": (GOOD.replace("0.2'", "1e308'", 1), "3 numbers"),
    "two numbers": (GOOD.replace(" 0.2'", "'", 1), "line 5: .* 3 numbers"),
    "underscore": (GOOD.replace("0.2'", "1_0'", 1), "3 numbers"),
    "degrees": (GOOD.replace("rpy='0.0", "rpy='90.0", 1), "line 5: .* degrees, where URDF has radians"),
    "millimetres": (GOOD.replace("0.2'", "200'"), "it is 400 m: millimetres, where URDF has metres"),
    "no axis": (GOOD.replace("<axis xyz='0.0 0.0 1.0'", "<axis xyz='0 0 0'"), "axis of joint 'j1' has no direction"),
    "limits": (GOOD.replace('lower="-1.5"', 'lower="3"', 1), "line 5: .* 3 and 2.5: lower is above upper"),
    "type": (GOOD.replace("'revolute'", "'ball'", 1), "line 4: joint 'j1' is of the type 'ball'"),
    "floating": (GOOD.replace("'revolute'", "'floating'", 1), "line 4: joint 'j1' is floating.* --base l1"),
    "mimic": (urdf(arm(2, more="<mimic joint='finger'/>")), "line 7: joint 'j2' mimics 'finger'"),
    "nameless": (GOOD.replace("name='l1'", "", 1), "line 3: <link> has no name"),
    "far weight": (
        GOOD.replace("'l2'></link>", "'l2'><inertial><origin xyz='0 0 300'/><mass value='1'/></inertial></link>"),
        "line 7: what joint 'j2' carries has its centre of mass 300 m away",
    ),
    "weight": (GOOD.replace("'l2'></link>", "'l2'><inertial><mass value='-1'/></inertial></link>"), "weighs -1 kg"),
}


@pytest.mark.parametrize("name", WRONG)
def test_what_is_no_arm_is_refused_with_its_line(tmp_path: Path, name: str) -> None:
    text, told = WRONG[name]
    with pytest.raises(InputError, match=told):
        imported(tmp_path, text)
    assert not (tmp_path / "out").exists()


def test_what_ros_adds_is_passed_over(tmp_path: Path) -> None:
    more = (
        "<transmission name='t'><joint name='j1'><hardwareInterface/></joint></transmission><gazebo reference='l1'/>"
        "<material name='m'/><ros2_control name='r'><joint name='j1'/></ros2_control>"
    )
    text = urdf(arm(), more).replace("<robot", "<?xml version='1.0'?><!-- xacro: --><robot xmlns:xacro='http://x'", 1)
    assert len(imported(tmp_path, text).links) >= 2


def test_a_table_that_does_not_close_is_not_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    right = Row.neat
    monkeypatch.setattr(Row, "neat", lambda row: right(row)._replace(d=round(float(row.d), 1) + 0.01))
    with pytest.raises(InputError, match=r"misses the file's own frames by 0\.0\d+ mm"):
        imported(tmp_path, GOOD)
    assert not (tmp_path / "out").exists()


def test_the_command_says_what_it_wrote(tmp_path: Path, run: Run) -> None:
    file = tmp_path / "arm.urdf"
    file.write_text(GOOD)
    code, out, _ = run("import", "urdf", file, "-o", tmp_path / "mine", "--json")
    assert code == 0
    assert str(tmp_path / "mine" / "robot.toml") in json.loads(out)["files"]
    code, _, err = run("import", "urdf", file, "--tip", "l22", "-o", tmp_path / "other")
    assert code == 2
    assert "did you mean 'l2'?" in err
    code, _, err = run("import", "klipper", file, "--tip", "l2", "-o", tmp_path / "other")
    assert code == 2
    assert "Unknown option: --tip" in err
    assert not (tmp_path / "other").exists()
