"""What readings pin down: matrices, observability, and unseen combinations on a case worked by hand."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from deltacal_gen.errors import UsageError
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.files.robot import Robot
from deltacal_gen.identification.identifiability import base_parameters, identification_matrix, observability, unseen
from deltacal_gen.machine.registry import Machine
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.units import DEG
from tests.support.prototype import plausible, rings, scattered, wanted

NAMES, UNITS, TYPICAL = ("p", "q", "r", "s"), ("mm", "mm", "rad", "mm"), np.array([0.1, 0.1, 0.01, 0.1])


def by_hand() -> np.ndarray:
    """Return a matrix (20, 4) that sees p, and of q and r only ``q + 5 r``; s it does not see."""
    rng = np.random.default_rng(1)
    seen = rng.standard_normal((20, 2))
    return np.column_stack([seen[:, 0], seen[:, 1], 5 * seen[:, 1], np.zeros(20)])


def test_unseen_combinations_are_those_of_a_case_worked_by_hand() -> None:
    first, second = sorted(unseen(by_hand(), NAMES, UNITS, TYPICAL), key=lambda c: len(c.terms))
    assert first.terms == {"s": pytest.approx(0.1)}
    assert first.text == "s moves no reading at all"
    # ordinary errors: q by 0.1 mm, r by 0.01; along q = -5 r the share of q is halved
    assert second.terms == {"r": pytest.approx(0.01), "q": pytest.approx(-0.05)}
    assert second.text == "r by +0.573 deg and q by -0.05 mm, moved together, change no reading"


def test_a_matrix_of_full_rank_leaves_nothing_unseen() -> None:
    assert unseen(by_hand()[:, :2], NAMES[:2], UNITS[:2], TYPICAL[:2]) == []


def test_fewer_readings_than_parameters_leave_the_rest_unseen() -> None:
    H = np.random.default_rng(2).standard_normal((2, 4))
    found = unseen(H, NAMES, UNITS, TYPICAL)
    assert len(found) == 2
    for combination in found:
        v = np.array([combination.terms.get(n, 0.0) for n in NAMES])
        assert H @ v == pytest.approx([0, 0], abs=1e-12)


def test_no_readings_at_all_leave_everything_unseen() -> None:
    assert len(unseen(np.zeros((3, 4)), NAMES, UNITS, TYPICAL)) == 4


def test_base_parameters_are_those_of_a_case_worked_by_hand() -> None:
    found = base_parameters(by_hand(), NAMES, TYPICAL)
    assert len(found) == 2
    assert found["p"] == {"p": 1.0}
    (other,) = set(found) - {"p"}
    partner = "r" if other == "q" else "q"
    assert found[other] == {other: 1.0, partner: pytest.approx(5.0 if other == "q" else 0.2)}


def test_observability_is_what_its_formulas_say() -> None:
    """Singular values 4, 2 and 1 of nine poses."""
    rng = np.random.default_rng(3)
    U, V = (np.linalg.qr(rng.standard_normal((n, 3)))[0] for n in (18, 3))
    found = observability(U @ np.diag([4.0, 2.0, 1.0]) @ V.T, 9)
    assert (found.rank, found.columns) == (3, 3)
    assert found.condition == pytest.approx(4.0)
    expected = {"O1": 2.0 / 3.0, "O2": 0.25, "O3": 1.0, "O4": 0.25, "O5": 1 / 1.75}
    assert found.indices == {k: pytest.approx(v) for k, v in expected.items()}


def test_a_short_rank_is_no_condition_number() -> None:
    found = observability(by_hand(), 20)
    assert found.rank == 2
    assert found.condition == np.inf
    assert set(found.indices.values()) == {0.0}
    assert observability(np.zeros((5, 2)), 5).rank == 0


# ---------------------------------------------------------------------------------------------- of a machine's readings


def test_the_matrix_predicts_what_small_errors_change(robot: Robot, mechanism: Machine) -> None:
    """``H p = r`` to second order, the unknown frame projected out of both: halve the errors, quarter the gap."""
    names = mechanism.model("42")
    full = plausible(mechanism, 5)
    frame = (np.array([0.2, -0.4, 1.0]), np.array([500.0, 100.0, -300.0]))
    for kind, more in (("position", {}), ("distance", {"pairs": np.column_stack(np.triu_indices(15, 1))})):
        gaps = []
        for size in (0.2, 0.1):
            errors = {n: size * v for n, v in full.items()}
            recording = simulate(robot, wanted(scattered(robot, 15, 3), kind, **more), errors, frame=frame)
            found = identification_matrix(pose_problem(robot, recording, names))
            p = mechanism.vector(errors) / [DEG if u == "deg" else 1.0 for u in found.units]
            gaps.append(np.linalg.norm(found.r - found.H @ p))
            assert gaps[-1] < 0.02 * np.linalg.norm(found.r)
        assert np.log2(gaps[0] / gaps[1]) > 1.9


def test_an_unknown_frame_costs_six_directions(robot: Robot, mechanism: Machine) -> None:
    """Position in the robot's frame sees the 38 combinations that move the point; the frame takes its six."""
    names = mechanism.model("42")
    ranks = {}
    for frame in ("robot", "unknown"):
        recording = simulate(robot, wanted(np.vstack([rings(robot, 9), scattered(robot, 20, 4)]), frame=frame))
        ranks[frame] = observability(identification_matrix(pose_problem(robot, recording, names)).H, 39).rank
    assert ranks["robot"] - ranks["unknown"] == 6
    assert ranks["unknown"] == 32


def test_positions_and_their_distances_see_the_same(robot: Robot, mechanism: Machine) -> None:
    """All pairs hold what a position holds beyond its frame: the same unseen space."""
    names = mechanism.model("42")
    recording = simulate(robot, wanted(np.vstack([rings(robot, 9), scattered(robot, 20, 4)])))
    spaces = []
    for as_distance in (False, True):
        H = identification_matrix(pose_problem(robot, recording, names, as_distance=as_distance), "typical").H
        _, s, Vt = np.linalg.svd(H)
        assert (s > 1e-9 * s[0]).sum() == 32
        spaces.append(Vt[32:])
    overlap = np.linalg.svd(spaces[0] @ spaces[1].T, compute_uv=False)
    assert overlap == pytest.approx(np.ones(10), abs=1e-9)


def test_unread_cells_have_no_row(robot: Robot, mechanism: Machine) -> None:
    recording = simulate(robot, wanted(scattered(robot, 15, 3), "pose", frame="robot"))
    measured = recording.measured.copy()
    measured[5:, 3:] = np.nan
    found = identification_matrix(pose_problem(robot, dataclasses.replace(recording, measured=measured), ("L_1",)))
    assert found.H.shape == (15 * 3 + 5 * 3, 1)


def test_an_unknown_scaling_is_refused(robot: Robot) -> None:
    recording = simulate(robot, wanted(scattered(robot, 5, 3)))
    with pytest.raises(UsageError, match="there is no scaling 'unit'; known: file, paper, table, typical"):
        identification_matrix(pose_problem(robot, recording, ("L_1",)), "unit")
