"""Two sessions of one machine: how far it moved, and what both sessions know of why."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.files.robot import Robot
from deltacal_gen.machine.registry import Machine
from deltacal_gen.machine.rotation import from_vector
from deltacal_gen.physics.simulation import simulate
from deltacal_gen.results.comparison import Comparison
from deltacal_gen.results.result import Result
from tests.support.commands import Run
from tests.support.prototype import plausible, scattered, wanted

TURNED = np.radians(0.5)


def session(robot: Robot, errors: dict[str, float], seed: int) -> Result:
    rng = np.random.default_rng(seed)
    frame = (rng.normal(size=3), rng.normal(size=3, scale=500.0))
    given = wanted(scattered(robot, 60, 4))
    return dc.identify(robot, simulate(robot, given, errors, noise_mm=0.005, rng=rng, frame=frame))


@pytest.fixture(scope="module")
def sessions(robot: Robot, mechanism: Machine) -> dict[str, Result]:
    truth = plausible(mechanism, 3)
    slipped = truth | {"theta_2": truth["theta_2"] + TURNED}
    return {"before": session(robot, truth, 1), "same": session(robot, truth, 2), "slipped": session(robot, slipped, 3)}


def test_a_machine_that_did_not_change_moved_by_what_it_is_known_to(sessions: dict[str, Result]) -> None:
    found = dc.compare(sessions["before"], sessions["same"])
    assert found.moved is not None
    assert found.moved.rms_mm < 0.01
    assert not found.combinations_changed
    assert found.summary.startswith("Over its workspace the machine moved by 0.00")


def test_what_a_slipped_encoder_does_is_told_in_mm_and_as_a_combination(
    robot: Robot, mechanism: Machine, sessions: dict[str, Result]
) -> None:
    """Distances between the points of the two machines, whatever stands between, are what the slip itself makes."""
    found = dc.compare(sessions["before"], sessions["slipped"])
    (changed,) = found.combinations_changed or ()
    assert changed.name.startswith("theta_2")
    assert changed.change == pytest.approx(0.5, abs=5 * (changed.std or 0.0))
    errors = plausible(mechanism, 3)
    a, b = (dataclasses.replace(robot, errors=e) for e in (errors, errors | {"theta_2": errors["theta_2"] + TURNED}))
    q, x, status = mechanism.inverse(scattered(robot, 400, 9), robot.tool, mechanism.rows(a))
    there = mechanism.forward(q, robot.tool, mechanism.rows(b))[0]
    assert (status == 0).all()
    expected = aligned(x[:, :3], there[:, :3])
    assert found.moved is not None
    assert found.moved.rms_mm == pytest.approx(expected, rel=0.3)  # other points of the same workspace


def aligned(a: np.ndarray, b: np.ndarray) -> float:
    """Return the rms distance of two clouds after the best rigid motion, by descent on its six numbers."""
    from scipy.optimize import least_squares

    def off(motion: np.ndarray) -> np.ndarray:
        return (a @ from_vector(motion[None, :3])[0].T + motion[3:] - b).ravel()

    return float(np.sqrt(np.mean(off(least_squares(off, np.zeros(6)).x).reshape(-1, 3) ** 2) * 3))


def test_other_models_have_no_combinations_in_common(
    robot: Robot, mechanism: Machine, sessions: dict[str, Result]
) -> None:
    truth = plausible(mechanism, 3)
    rng = np.random.default_rng(4)
    small = dc.identify(
        robot, simulate(robot, wanted(scattered(robot, 60, 4)), truth, noise_mm=0.005, rng=rng), model="18"
    )
    found: Comparison = dc.compare(sessions["before"], small)
    assert found.combinations_changed is None
    assert found.moved is not None


def test_the_screen_begins_with_millimetres_and_folds_the_unknown(
    run: Run, tmp_path: Path, sessions: dict[str, Result]
) -> None:
    for name in ("before", "slipped"):
        (tmp_path / f"{name}.json").write_text(sessions[name].to_json())
    code, out, _ = run("compare", tmp_path / "before.json", tmp_path / "slipped.json")
    assert code == 0
    assert out.startswith("Over its workspace the machine moved by")
    assert len(out.splitlines()) < 25
