"""Every kind of readings of every machine, in one size of it with all its parts, is identified and predicted."""

from __future__ import annotations

import zlib
from pathlib import Path

import numpy as np
import pytest

import deltacal_gen as dc
from deltacal_gen.machine.registry import mechanism_of
from deltacal_gen.units import joint_factors, joint_names
from tests.benchmarks import concealed_machines as machines

POSES, NOISE = 60, 0.01  # mm
ENDS = "base_point_mm = [700.0, 650.0, -300.0]\nplatform_point_mm = [10.0, -12.0, -5.0]\n"  # of a gauge


def poses(name: str, kind: str, folder: Path) -> tuple[dc.Robot, Path]:
    """Return a machine, and a file of joints at which it is to be read, with the ways that they came."""
    rng = np.random.default_rng(zlib.crc32(f"{name} {kind}".encode()))
    robot = machines.draw(name, rng)
    mechanism = mechanism_of(robot)
    joints = robot.joint_sign * machines.joints_of_poses(robot, POSES, np.zeros(3), rng)
    columns = [
        *joint_names(mechanism.joint_unit, mechanism.limbs),
        *(f"approach{i + 1}" for i in range(mechanism.limbs)),
    ]
    table = np.round(joints / joint_factors(mechanism.joint_unit, mechanism.limbs), 5)
    path = folder / "poses.csv"
    whole = np.hstack([table, rng.choice([-1.0, 1.0], table.shape)])
    np.savetxt(path, whole, delimiter=",", header=",".join(columns), comments="", fmt="%.5f")
    path.with_suffix(".toml").write_text(f'[measurement]\nkind = "{kind}"\n' + ENDS * (kind == "gauge"))
    return robot, path


@pytest.mark.parametrize("kind", ["position", "pose", "gauge", "height", "encoder"])
@pytest.mark.parametrize("name", machines.EVERY)
def test_its_readings_are_identified_and_predicted(name: str, kind: str, tmp_path: Path) -> None:
    robot, path = poses(name, kind, tmp_path)
    made = dc.simulate(robot, path, noise=NOISE, seed=3)
    found = dc.identify(robot, made)
    turns = kind == "encoder" and mechanism_of(robot).joint_unit == "rad"
    arc = 100.0 if turns else 1.0  # mm to the radian, as noise is given
    off = arc * (dc.predict(found, made).measured - made.measured)[:, :3]
    assert np.sqrt(np.nanmean(off**2)) < 3 * NOISE


@pytest.mark.parametrize("name", machines.EVERY)
def test_play_shows_behind_a_second_encoder(name: str, tmp_path: Path) -> None:
    robot, path = poses(name, "encoder", tmp_path)
    truth = tmp_path / "truth.toml"
    truth.write_text("[[effects]]\nname = 'backlash'\nlimb = 1\nwidth = 0.1\n")
    found = dc.diagnose(robot, dc.simulate(robot, path, truth=truth, noise=NOISE, seed=3))
    assert [(e.name, e.limbs) for e in found.effects] == [("backlash", (1,))]
