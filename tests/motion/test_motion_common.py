"""Friction in common: what no joint's readings pay for alone, and all pay for together."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.signal import lfilter

from deltacal_gen.motion.common import asked_in_common
from deltacal_gen.motion.fit import climbed
from tests.support.motion_recordings import Friction, session_of, written

HANGS = 0.9  # of a sample's noise is that of the one before it


def drives(load_friction: float, seed: int) -> Friction:
    """Return what drives of one make add: dry friction, a part of the load, noise that hangs together."""
    rng = np.random.default_rng(seed)

    def added(states: np.ndarray, load: np.ndarray) -> np.ndarray:
        usual = 0.02 * np.sqrt(np.mean(load**2, axis=0))
        noise = lfilter([np.sqrt(1 - HANGS**2)], [1, -HANGS], rng.standard_normal(load.shape), axis=0)
        return usual * (20 * np.sign(states[1]) + noise) + load_friction * np.abs(load) * np.sign(states[1])

    return added


@pytest.mark.walk
@pytest.mark.parametrize(("size", "named"), [(0.03, [1, 2, 3]), (0.0, [])])
def test_what_no_joint_pays_for_alone_all_pay_for_together(size: float, named: list[int], tmp_path: Path) -> None:
    session = session_of(written(tmp_path, drives(size, 7), runs=5, seed=7, seconds=8.0))
    units = session.rigid.dynamics.joint_units
    alone = [climbed(joint) for joint in session.moving]
    assert [rung.effect for fit in alone for rung in fit.rungs] == ["coulomb_friction"] * 3
    found = asked_in_common(alone, units)
    assert [f.joint.number for f in found for rung in f.rungs if rung.effect == "load_friction"] == named
    for fit, before in zip(found, alone, strict=True):
        assert np.nanmean(fit.held_out**2) <= np.nanmean(before.held_out**2)
    for fit in found if named else []:
        at = len(fit.coefficients) - 1
        assert abs(fit.coefficients[at] - size) < 3 * fit.std[at] < size * 3
        assert len(fit.bought) == len(fit.gains) == len(fit.alike) == len(fit.rungs)
    assert asked_in_common(alone, ["rad", "mm", "mm"])[0] is alone[0]  # what turns and what slides have none
