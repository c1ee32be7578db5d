"""Mistakes in a file are told, not fitted: and a machine that is soft, poor or another one is none."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from deltacal_gen.diagnosis.diagnosis import diagnose
from deltacal_gen.errors import InputError
from deltacal_gen.estimation import fit as fitting
from deltacal_gen.estimation.fit import rough
from deltacal_gen.estimation.prior import UNSAID
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.files.robot import Robot, robot_from_dict, robot_to_dict
from deltacal_gen.identification.checks import plausible
from deltacal_gen.identification.identification import identify
from deltacal_gen.machine.registry import Machine
from deltacal_gen.machine.rotation import from_vector
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.physics.terms import blank
from deltacal_gen.units import DEG
from deltacal_gen.use.prediction import predict
from tests.support.every_effect import LIFT, chain
from tests.support.left_out import diagnosis, machine, record
from tests.support.prototype import scattered, wanted
from tests.support.six_joints import SIGMA, recorded, six_joints, unread, wide

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.fixture(scope="module")
def arm() -> Robot:
    return six_joints()


def test_a_soft_arm_is_no_mistake(arm: Robot) -> None:
    """One per cent of its reach: nothing is refused, and no order of the joints is tried that nobody would make."""
    q = wide(np.random.default_rng(2), 120, 1.2)
    first = rough(pose_problem(arm, recorded(arm, q, sag=0.05), ()), must_converge=False)
    assert np.median(np.linalg.norm(first.residual, axis=1)) > 5
    plausible(first)


MISTAKES = {
    "the columns of joints 2 and 3 are exchanged": lambda r: r.joints[:, [0, 2, 1, 3, 4, 5]],
    "joint 4 counts the other way": lambda r: r.joints * [1, 1, 1, -1, 1, 1],
    "the zero of joint 3 is off by 90 deg": lambda r: r.joints - np.radians([0, 0, 90, 0, 0, 0]),
    "the zeros of all joints are off by 90 deg": lambda r: r.joints - np.radians(90),
    "the joints are in radians": lambda r: np.radians(r.joints),
    "joint 3 counts from a line that stays as joint 2 turns .page arm: coupling = {2 = -1.0}": lambda r: (
        r.joints + r.joints[:, [1]] * [0, 0, 1, 0, 0, 0]
    ),
}


@pytest.mark.parametrize("words", MISTAKES)
def test_a_mistake_in_the_joints_is_named(arm: Robot, words: str) -> None:
    good = recorded(arm, wide(np.random.default_rng(2), 120, 1.2), size=0.3)
    wrong = dataclasses.replace(good, joints=MISTAKES[words](good))
    with pytest.raises(InputError, match="agree with it if .*" + words):
        plausible(rough(pose_problem(arm, wrong, ()), must_converge=False))


@pytest.mark.parametrize("words", ["the columns of joints 2 and 3 are exchanged", "joint 4 counts the other way"])
def test_of_a_poor_machine_that_is_refused_the_mistakes_are_told_with_which_it_would_not_be(
    arm: Robot, words: str
) -> None:
    """It leaves a tenth of what they move whatever is put right: nothing was named, and all had to be compared."""
    poor = recorded(arm, wide(np.random.default_rng(2), 120, 0.6), sag=0.3)
    plausible(rough(pose_problem(arm, poor, ()), must_converge=False))
    wrong = dataclasses.replace(poor, joints=MISTAKES[words](poor))
    with pytest.raises(InputError, match="more than any error of its parts. They would be .* mm off if .*" + words):
        plausible(rough(pose_problem(arm, wrong, ()), must_converge=False))


LINKS = {
    "of the other convention .convention = .standard.": lambda k, row: {"convention": "modified"},
    "alpha of ..joint.. 3 counts the other way": lambda k, row: {"alpha": -row["alpha"]} if k == 3 else {},
    "d of ..joint.. 4 is in cm": lambda k, row: {"d": row["d"] / 10} if k == 4 else {},
    "a of ..joint.. 2 is in metres": lambda k, row: {"a": row["a"] / 1000} if k == 2 else {},
}


@pytest.mark.parametrize("words", LINKS)
def test_a_mistake_in_the_table_of_links_is_named_alone(arm: Robot, words: str) -> None:
    good, tables = recorded(arm, wide(np.random.default_rng(2), 120, 1.2), size=0.3), robot_to_dict(arm)
    tables["joint"] = [row | LINKS[words](k, row) for k, row in enumerate(tables["joint"], start=1)]
    with pytest.raises(InputError, match=f"agree with it if [^,]*{words}[^,]*[.] Correct"):
        plausible(rough(pose_problem(robot_from_dict(tables), good, ()), must_converge=False))


def test_poses_the_other_way_round_are_named(arm: Robot) -> None:
    """What a camera in the hand tells of a board is where the board is, not where the hand is."""
    rng = np.random.default_rng(2)
    poses = dataclasses.replace(wanted(np.zeros((20, 3)), "pose"), joints=wide(rng, 20, 0.8), targets=None)
    frame = (np.array([0.4, -0.2, 2.0]), np.array([500.0, -80.0, 900.0]))
    good = simulate(arm, poses, {}, noise_mm=SIGMA, noise_rad=1e-4, rng=rng, frame=frame)
    plausible(rough(pose_problem(arm, good, ()), must_converge=False))
    back = np.swapaxes(from_vector(good.measured[:, 3:]), 1, 2)
    there = -np.einsum("rij,rj->ri", back, good.measured[:, :3])
    wrong = dataclasses.replace(good, measured=np.hstack([there, -good.measured[:, 3:]]))
    with pytest.raises(InputError, match=r"agree with it if .*each pose is the inverse"):
        plausible(rough(pose_problem(arm, wrong, ()), must_converge=False))


def test_readings_of_the_next_row_are_named_and_a_coupled_joint_though_the_tool_is_not_said(arm: Robot) -> None:
    good = recorded(arm, wide(np.random.default_rng(2), 120, 1.2), size=0.3)
    wrong = dataclasses.replace(good, measured=np.roll(good.measured, 1, axis=0))
    with pytest.raises(InputError, match=r"agree with it if .*shifted against the joints by one row"):
        plausible(rough(pose_problem(arm, wrong, ()), must_converge=False))
    wrong = dataclasses.replace(good, joints=good.joints - good.joints[:, [1]] * [0, 0, 1, 0, 0, 0])
    untold = dataclasses.replace(arm, tool=np.zeros(3))
    with pytest.raises(InputError, match=r"agree with it if .*joint 3 counts .* coupling = \{2 = 1\.0\}"):
        plausible(rough(pose_problem(untold, wrong, ()), must_converge=False))


def test_a_coupled_joint_is_named_though_joints_hardly_turn_and_the_tool_is_long_and_not_said(arm: Robot) -> None:
    """A point half a metre from where the file has it is off by more than the mistake, until it is found."""
    rng = np.random.default_rng(3)
    q = np.radians([-35.0, -38.0, 5.0, 2.0, -56.0, -33.0]) + np.radians([1, 5, 25, 1, 1, 1]) * wide(rng, 90, 1.0)
    long = dataclasses.replace(arm, tool=np.array([0.0, -400.0, 0.0]))
    good = recorded(long, q, size=0.3)
    wrong = dataclasses.replace(good, joints=good.joints - good.joints[:, [1]] * [0, 0, 1, 0, 0, 0])
    untold = dataclasses.replace(arm, tool=np.zeros(3))
    with pytest.raises(InputError, match=r"agree with it if joint 3 counts .* coupling = \{2 = 1\.0\}"):
        plausible(rough(pose_problem(untold, wrong, ()), must_converge=False))


def test_radians_are_named_of_a_chain_that_slides_too() -> None:
    lift = chain(LIFT)
    q = wide(np.random.default_rng(2), 60, 1.0)[:, :4] * [200.0, 1.0, 1.0, 1.0]
    good = recorded(lift, q, size=0.3)
    wrong = dataclasses.replace(good, joints=good.joints * [1.0, *np.radians([1.0] * 3)])
    with pytest.raises(InputError, match=r"agree with it if .*the joints are in radians"):
        plausible(rough(pose_problem(lift, wrong, ()), must_converge=False))


def test_rows_that_are_off_together_are_no_single_cells(arm: Robot) -> None:
    problem = pose_problem(arm, recorded(arm, wide(np.random.default_rng(2), 30, 1.0)), ())
    off = np.full((30, 3), 0.1)
    off[4] = 100.0
    with pytest.raises(InputError, match=r"line 6: .* of this row, or remove it"):
        fitting._blame(problem, off)
    off[10:14] = 90.0
    with pytest.raises(
        InputError, match=r"5 readings are so far off: lines 6, 12, 13, 14, 15\. .* where a joint moves"
    ):
        fitting._blame(problem, off)


@pytest.mark.walk
def test_a_left_handed_frame_and_inches_are_named(arm: Robot) -> None:
    good = recorded(arm, wide(np.random.default_rng(2), 120, 1.2), size=0.3)
    for words, measured in (
        ("the instrument's frame is left-handed", good.measured * [-1, 1, 1]),
        ("all positions are in inches", good.measured / 25.4),
    ):
        wrong = dataclasses.replace(good, measured=measured)
        with pytest.raises(InputError, match="agree with it if .*" + words):
            plausible(rough(pose_problem(arm, wrong, ()), must_converge=False))


def test_a_fit_that_takes_a_quarter_turn_for_an_encoder_offset_says_so(robot: Robot, mechanism: Machine) -> None:
    good = simulate(robot, wanted(scattered(robot, 40, 4)), {}, noise_mm=0.01, rng=np.random.default_rng(1))
    wrong = dataclasses.replace(good, joints=good.joints + np.radians([0, 90, 0]))
    with pytest.raises(InputError, match="theta_2 = -90 deg"):
        plausible(rough(pose_problem(robot, wrong, ()), must_converge=False))
    said = dataclasses.replace(robot, errors={"theta_2": -np.pi / 2})
    plausible(rough(pose_problem(said, wrong, ()), must_converge=False))


def test_readings_in_another_order_are_refused(arm: Robot) -> None:
    good = recorded(arm, wide(np.random.default_rng(2), 120, 1.2), size=0.3)
    shuffled = dataclasses.replace(good, measured=np.random.default_rng(1).permutation(good.measured))
    with pytest.raises(InputError, match="more than any error of its parts"):
        plausible(rough(pose_problem(arm, shuffled, ()), must_converge=False))


def test_a_machine_farther_off_than_drawings_leave_open_is_doubted() -> None:
    robot = machine()
    readings = record(robot, errors={"L_1": 15.0, "l_2": -12.0, "theta_3": 4 * DEG, "ex_2": 0.3})
    [doubt] = identify(robot, readings).answer().doubts or ()
    assert "L_1 by +1" in doubt
    assert "theta_3" not in doubt  # encoders are often so far off
    assert f"But {doubt}" in diagnosis(robot, readings).summary
    rough_drawing = machine(tolerance={f"{letter}_{limb}": 20.0 for letter in "Ll" for limb in (1, 2, 3)})
    assert identify(rough_drawing, readings).answer().doubts is None
    assert identify(robot, record(robot)).answer().doubts is None


def test_a_reflector_of_which_the_robot_file_says_nothing_is_found_where_it_sits(arm: Robot) -> None:
    """A tool point of zeros is one that nobody has written down: no part of the machine is off for it."""
    readings = recorded(arm, wide(np.random.default_rng(2), 60, 1.2), size=0.1)
    bare = dataclasses.replace(arm, tool=np.zeros(3))
    answers = {known: identify(robot, readings).answer() for known, robot in (("said", arm), ("unsaid", bare))}
    found = {known: {p.name: p for p in answer.parameters} for known, answer in answers.items()}
    assert answers["unsaid"].doubts is None
    assert answers["unsaid"].train_rms_mm < 3 * SIGMA
    said, unsaid = found["said"], found["unsaid"]
    for name in ("a_2", "a_3", "alpha_4", "theta_3", "d_4"):
        assert abs(unsaid[name].value - said[name].value) < 2 * (said[name].std or 0.0)
    # along x and y of the last link it sits where it is, but for the zero of the last joint, which nothing else reads
    radius = np.hypot(unsaid["tx"].value, unsaid["ty"].value)
    assert radius == pytest.approx(np.hypot(-30.0 + said["tx"].value, -20.0 + said["ty"].value), abs=0.1)


def test_beside_effects_a_tool_point_that_nobody_wrote_down_is_as_open(arm: Robot) -> None:
    readings = recorded(arm, wide(np.random.default_rng(2), 30, 1.2), size=0.1)
    bare = dataclasses.replace(arm, tool=np.zeros(3))
    said, unsaid = (diagnose(robot, readings).baseline.problem for robot in (arm, bare))
    tool = [said.names.index(name) for name in ("tx", "ty", "tz")]
    assert (unsaid.scale[tool] == UNSAID).all()
    assert (said.scale[tool] < UNSAID / 10).all()
    assert np.delete(unsaid.scale, tool) == pytest.approx(np.delete(said.scale, tool))


def test_a_tool_point_that_is_said_is_believed_as_other_parts_are(arm: Robot) -> None:
    readings = recorded(arm, wide(np.random.default_rng(2), 60, 1.2), size=0.1)
    wrong = dataclasses.replace(arm, tool=arm.tool + np.array([0.0, 200.0, 0.0]))
    [doubt] = identify(wrong, readings).answer().doubts or ()
    assert "ty by -" in doubt or "tx by" in doubt


def test_a_reflector_that_was_knocked_for_a_while_is_left_out_and_told(arm: Robot) -> None:
    """A seventh of the rows, centimetres off with the others before and behind, was noise of the rest that wanders."""
    readings = recorded(arm, wide(np.random.default_rng(2), 60, 1.2), size=0.1)
    knocked = dataclasses.replace(readings, measured=readings.measured.copy())
    knocked.measured[20:29] += [30.0, -20.0, 15.0]
    answer, found = identify(arm, knocked).answer(), diagnose(arm, knocked).answer()
    assert answer.gross_errors == found.gross_errors == tuple(range(22, 31))
    assert answer.train_rms_mm < 1.5 * SIGMA
    assert (found.verdict, found.effects) == ("adequate", ())
    assert "9 readings are far beyond all others together and were left out (lines 22, 23," in found.summary
    for known in (answer, found):
        assert np.sqrt(np.mean((predict(known, readings).measured - readings.measured) ** 2)) < 2 * SIGMA


@pytest.mark.parametrize(("poses", "wrong", "other"), [(12, 3, 9), (14, 0, 2)])
def test_of_few_poses_one_with_cells_of_another_is_left_out_and_told(
    arm: Robot, poses: int, wrong: int, other: int
) -> None:
    """It pulled the machine by centimetres, stood out of nothing, and the zero of a joint or nonsense was told."""
    readings = recorded(arm, wide(np.random.default_rng(100 * poses + (poses == 12)), poses, 1.2), size=0.1)
    copied = dataclasses.replace(readings, measured=readings.measured.copy())
    copied.measured[wrong] = copied.measured[other]
    bare = dataclasses.replace(arm, tool=np.zeros(3))
    enough = poses == 14
    found = [identify(bare, copied).answer(), *([diagnose(bare, copied).answer()] if enough else [])]
    assert {known.gross_errors for known in found} == {(wrong + 2,)}
    for known in found:
        off = predict(known, readings).measured - readings.measured
        assert np.sqrt(np.mean(np.delete(off, wrong, axis=0) ** 2)) < 3 * SIGMA
    assert "joints of another pose" in (found[0].doubts or ("",))[0]


def test_a_slip_is_no_reflector_that_was_knocked(arm: Robot) -> None:
    readings = recorded(arm, wide(np.random.default_rng(2), 60, 1.2), size=0.1)
    slipped = dataclasses.replace(readings, measured=readings.measured.copy())
    slipped.measured[51:] += [30.0, -20.0, 15.0]
    [effect] = diagnose(arm, slipped).answer().effects
    assert effect.name in ("instrument_slip", "tool_slip")


def test_a_tracker_that_lost_its_target_is_told_by_lines(arm: Robot) -> None:
    """Its last reading written on for a quarter of the rows is no machine's; with these cells blank the rest is."""
    readings = recorded(arm, wide(np.random.default_rng(2), 60, 1.2), size=0.1)
    stuck, blanked = readings.measured.copy(), readings.measured.copy()
    stuck[45:], blanked[45:] = stuck[44], np.nan
    with pytest.raises(InputError, match=r"15 readings are the one before .* in lines 46 to 61\)"):
        identify(arm, dataclasses.replace(readings, measured=stuck))
    assert identify(arm, dataclasses.replace(readings, measured=blanked)).answer().train_rms_mm < 3 * SIGMA


def test_joints_that_were_logged_of_another_machine_are_told(arm: Robot) -> None:
    """They stand, but for a count of their encoders, while what is read moves."""
    rng = np.random.default_rng(2)
    readings = recorded(arm, wide(rng, 60, 1.2), size=0.1)
    still = readings.joints[0] + 1e-6 * rng.standard_normal(readings.joints.shape)
    with pytest.raises(InputError, match=r"spread over \d+ mm, yet at the joints .* no more than 0\.00\d+ mm"):
        identify(arm, dataclasses.replace(readings, joints=still))


@pytest.mark.walk
@pytest.mark.parametrize(("longer", "declared"), [(129.0, True), (129.0, False), (160.0, True)])
def test_a_machine_of_other_lengths_is_fitted_and_told_instead_of_noise_of_millimetres(
    longer: float, declared: bool
) -> None:
    """Rods a decimetre longer than drawn are less credible than such noise, to a fit whose noise is open."""
    robot = machine()
    readings = record(robot, errors={f"l_{limb}": longer for limb in (1, 2, 3)}, declared=declared)
    answer = identify(robot, readings).answer()
    [doubt] = answer.doubts or ()
    assert f"l_1 by +{longer:.0f} mm" in doubt
    assert answer.train_rms_mm < 0.02
    found = diagnosis(robot, readings)
    assert (found.verdict, found.effects, found.laws) == ("adequate", (), ())
    assert f"l_1 by +{longer:.0f} mm" in found.summary


def test_no_other_machine_stands_for_physics_or_gross_errors() -> None:
    robot = machine()
    readings = record(robot, blank("joint_compliance", (1, 2, 3)).with_values(np.full((3, 1), 3e-5)), declared=True)
    assert identify(robot, readings).answer().doubts is None
    some = record(robot)
    some.measured[::30] += 40.0
    assert identify(robot, some).answer().doubts is None


def test_a_second_reference_point_of_an_arm_is_as_far_as_a_hand_holds_it(arm: Robot) -> None:
    """It was a part of the first link's twist, which of an arm is no length."""
    readings = recorded(arm, wide(np.random.default_rng(2), 60, 1.2), size=0.1)
    proposed = identify(arm, readings).answer().next_measurements
    points = [idea for idea in proposed if "reference point" in idea.measurement]
    assert points
    assert all("100 mm beside the first" in idea.measurement for idea in points)


def test_points_that_are_read_at_a_pose_already_are_no_idea(arm: Robot) -> None:
    """Three reflectors tell rotations: what they leave open no fourth would pin, nor the rotation itself."""
    rng = np.random.default_rng(2)
    joints = np.repeat(wide(rng, 20, 0.6), 3, axis=0)
    asked = dataclasses.replace(
        unread(arm, joints), tool=np.tile([[0, 0, 120.0], [100, 0, 120], [0, 100, 120]], (20, 1))
    )
    readings = simulate(arm, asked, {}, noise_mm=0.1, rng=rng, frame=(np.ones(3), np.ones(3)))
    proposed = identify(arm, readings).answer().next_measurements
    assert not any("reference point" in idea.measurement or "rotation" in idea.measurement for idea in proposed)
