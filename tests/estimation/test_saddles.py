"""Where a fit ended is held against what the machine made linear foresaw, however little noise there is."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from deltacal_gen.estimation import saddles
from deltacal_gen.estimation.fit import fit
from deltacal_gen.estimation.fitted import Fit
from deltacal_gen.estimation.problem import pose_problem
from deltacal_gen.estimation.saddles import unforeseen
from deltacal_gen.estimation.solvers import Prior
from deltacal_gen.estimation.system import System
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.physics.simulation import simulate
from tests.support.left_out import FRAME
from tests.support.open_chains import SCARA, robot
from tests.support.prototype import wanted

pytestmark = pytest.mark.usefixtures("compiled")


@pytest.fixture(scope="module")
def exact() -> Fit:
    """Fit a SCARA to positions without noise in an unknown frame, which sees no offset along parallel axes."""
    arm, rng = robot(SCARA, masses={}), np.random.default_rng(3)
    mechanism = mechanism_of(arm)
    q = rng.uniform([-2.0, -2.4, 0.0, -3.0], [2.0, 2.4, 200.0, 3.0], (40, 4))
    errors = {p.name: p.typical * rng.standard_normal() for p in mechanism.parameters}
    poses = dataclasses.replace(wanted(np.zeros((40, 3))), joints=q, targets=None)
    recording = simulate(arm, poses, errors, noise_mm=0.0, rng=rng, frame=FRAME)
    return fit(pose_problem(arm, recording, mechanism.model(mechanism.full_model)), Prior())


def test_readings_without_noise_end_where_they_were_foreseen_to(exact: Fit) -> None:
    assert exact.rms() < 1e-9
    assert np.linalg.svd(exact.solution.covariance, compute_uv=False)[-1] < 1e-14  # no number for a solve
    assert unforeseen(exact) in (False, True)


def test_columns_that_are_one_another_leave_no_singular_matrix(exact: Fit, monkeypatch: pytest.MonkeyPatch) -> None:
    n = len(exact.departure)
    alike = 2.0**40 * np.ones((2 * n, n + 1))  # beside squares of these a prior of 1 is rounded off
    with pytest.raises(np.linalg.LinAlgError):
        np.linalg.solve(alike[:, :n].T @ alike[:, :n] + np.eye(n), np.ones(n))
    monkeypatch.setattr(saddles, "_rows", lambda *_: System(alike, 0))
    assert unforeseen(exact)  # all columns alike foresee one n-th of the step in every direction
